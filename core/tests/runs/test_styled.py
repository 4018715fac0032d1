"""A style's settings, its shape, and the colours of voxels."""

from dataclasses import replace

import pytest
import torch

from core.appearance.material_ranges import MaterialRanges
from core.config import DRAFT, GeometryConfig
from core.geometry.mesh import Mesh
from core.geometry.voxels import squares_of
from core.guidance.guidance import Area, Surface
from core.stages.styled import SquareAreas, in_style, style_of, styled, styled_areas
from core.tests.meshes import sphere

BALL = Mesh(*sphere(4))
RANGES = MaterialRanges((0.1, 0.9), (0.0, 1.0))


class Halves:
    """Red above, blue below, and a thin green belt."""

    each = tuple(
        Area(True, RANGES, Surface("plain", color), level)
        for color, level in (((1, 0, 0), True), ((0, 0, 1), True), ((0, 1, 0), False))
    )
    belt = 0.004

    def of(self, points):
        z = points[:, 2]
        return torch.where(z.abs() < self.belt, 2, torch.where(z > 0.04, 0, 1))

    def certain(self, points, reach):
        raise AssertionError("asked for texels of squares")

    def inside(self, points, area):
        return points + torch.tensor([0.0, 0, 0.125])

    def slope(self, points, normals, area, step):
        return torch.ones_like(points)

    def nearest(self):
        return torch.full((2, 2, 2), 7)


@pytest.mark.parametrize(
    ("setting", "stated", "wanted"),
    [
        ("stated", "", "none"),
        ("stated", "low_poly", "low_poly"),
        ("none", "low_poly", "none"),
        ("voxels", "low_poly", "voxels"),
        ("stated", "cubism", "none"),  # a guidance's own
    ],
)
def test_the_setting_comes_before_the_prompt(setting, stated, wanted):
    assert style_of(GeometryConfig(style=setting), stated) == wanted


def test_a_style_has_plain_colours_and_sharp_edges():
    config = in_style(DRAFT, "voxels")
    assert config.geometry.style == "voxels"
    assert (config.appearance.detail, config.appearance.evenness) == (0.0, 1.0)
    assert config.texture.edge_radius == 0.0
    plain = in_style(DRAFT, "none")
    assert plain.appearance == DRAFT.appearance and plain.texture == DRAFT.texture


def test_each_style_has_its_shape():
    shapes = {}
    for style in ("none", "low_poly", "voxels"):
        shapes[style] = styled(BALL, in_style(DRAFT, style), lambda: None)
    assert shapes["none"] is BALL
    assert shapes["low_poly"].flat and shapes["low_poly"].uv is None
    assert shapes["voxels"].flat and shapes["voxels"].uv is not None
    sides = shapes["voxels"].verts.amax(0) - shapes["voxels"].verts.amin(0)
    assert float(sides[0] / squares_of(shapes["voxels"])[1][0].norm()) == pytest.approx(32)


def test_each_square_has_texels():
    config = in_style(DRAFT, "voxels")
    small = replace(config, texture=replace(config.texture, size=64))
    assert len(styled(BALL, small, lambda: None).faces) <= 2 * 16**2
    few = replace(config, texture=replace(config.texture, max_faces=400))
    assert len(styled(BALL, few, lambda: None).faces) <= 400


def test_a_square_is_of_one_area():
    mesh = styled(BALL, in_style(DRAFT, "voxels"), lambda: None)
    areas = styled_areas(Halves(), mesh, in_style(DRAFT, "voxels").geometry)
    assert isinstance(areas, SquareAreas)
    assert areas.own.unique().tolist() == [0, 1]  # no square is mostly belt
    middles, outward = squares_of(mesh)
    high = middles[:, 2] > outward[0].norm()  # above the lowest layer: its middle decides
    assert (areas.own[high] == 0).all()
    # A third of these is red.
    across = (middles[:, 2] > 0) & (middles[:, 2] < outward[0].norm()) & (outward[:, 2] == 0)
    assert across.any() and (areas.own[across] == 1).all()
    # Anywhere on a square, close to its corners too.
    a, b, c = mesh.verts[mesh.faces[::2]].unbind(1)
    for i, j in ((0.02, 0.03), (0.98, 0.97), (0.5, 0.96)):
        at = a + i * (b - a) + j * (c - b)
        assert torch.equal(areas.of(at), areas.own)
        area, sure = areas.certain(at, 0.1)
        assert torch.equal(area, areas.own) and sure.all()
        # One place for all of it, which the solid's areas choose.
        wanted = middles + torch.tensor([0.0, 0, 0.125])
        torch.testing.assert_close(areas.inside(at, area), wanted)
        assert not areas.slope(at, outward, area, 0.1).any()
    assert all(one.level for one in areas.each) and areas.nearest()[0, 0, 0] == 7


def test_without_voxels_the_areas_are_the_solids():
    halves = Halves()
    assert styled_areas(halves, BALL, in_style(DRAFT, "low_poly").geometry) is halves
    assert styled_areas(None, BALL, in_style(DRAFT, "voxels").geometry) is None
