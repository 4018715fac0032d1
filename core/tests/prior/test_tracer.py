"""The prior's pictures are the renderer's: same pixels, same cameras, same normals."""

import math
from dataclasses import replace

import pytest
import torch

from core.appearance.environment import Environment
from core.appearance.material import MaterialNet
from core.appearance.shaded import UvMesh, render_shaded
from core.camera import Cameras
from core.config import DRAFT
from core.geometry.marching_tets import marching_tets
from core.geometry.mesh import Mesh
from core.geometry.tet_grid import tet_grid
from core.prior.draw import Draw
from core.prior.families import Shape, build, normalised
from core.prior.solids import ball
from core.prior.tracer import render
from core.render.normals import render_normals
from core.stages.lit_scene import surface_picture


def _mesh(shape: Shape, resolution: int = 48):
    grid = tet_grid(resolution)
    return marching_tets(grid.tet_verts, shape.sdf(grid.tet_verts), grid)


@pytest.mark.parametrize("noun", ["mug", "teapot", "house"])
def test_traced_and_rasterised_pictures_agree(noun):
    shape = build(noun, "", Draw(torch.Generator().manual_seed(0)))
    cameras = Cameras.orbit([25.0, 130.0, 260.0], [20.0, -15.0, 60.0], 2.95)
    seen = render(shape, cameras, 64)
    n, o = render_normals(*_mesh(shape), cameras, 128, "object")
    n, o = (torch.nn.functional.avg_pool2d(x.permute(0, 3, 1, 2), 2) for x in (n, o))
    both = torch.minimum(o, seen.coverage).sum() / torch.maximum(o, seen.coverage).sum()
    assert both > 0.95
    inside = ((o > 0.99) & (seen.coverage > 0.99))[:, 0]
    cos = (n * seen.normal).sum(1)[inside]
    assert cos.mean() > 0.95
    mirrored = Cameras.orbit([-25.0, -130.0, -260.0], [20.0, -15.0, 60.0], 2.95)
    other = render(shape, mirrored, 64).coverage
    assert torch.minimum(o, other).sum() / torch.maximum(o, other).sum() < both - 0.05


def test_the_trained_hint_is_the_surface_of_the_appearance_training():
    """Normals, coverage and points of the mesh as ``surface_picture`` gives them to a guidance,
    against those that the network saw."""
    shape = build("mug", "", Draw(torch.Generator().manual_seed(0)))
    cameras = Cameras.orbit([25.0, 130.0], [20.0, 50.0], 2.95)
    seen = render(shape, cameras, 64)
    trained = torch.cat([seen.normal, 2 * seen.coverage - 1, seen.point * seen.coverage], 1)
    verts, faces = _mesh(shape)
    uv, corners = torch.rand(3, 2), torch.arange(3).expand(len(faces), 3)
    grey = Environment.of(torch.full((8, 16, 3), 0.5))
    config = replace(DRAFT.appearance, log2_hash_size=8, finest=16)
    source = MaterialNet(config, torch.Generator().manual_seed(0))
    with torch.no_grad():
        shaded = render_shaded(
            UvMesh.of(Mesh(verts, faces, uv, corners)), source, cameras, 128, grey
        )
    given = surface_picture(shaded, 64)
    away = (given - trained).abs().mean((0, 2, 3))
    assert away[:4].max() < 0.03
    assert away[4:].max() < 0.01
    assert (given[:, 4:] - trained[:, [5, 4, 6]]).abs().mean() > 0.05  # x and y are not swapped


def test_a_ball_is_a_disc_of_the_right_size():
    shape = normalised({"body": ball((0, 0, 0), 1.0)})
    seen = render(shape, Cameras.orbit([30.0], [10.0]), 64, 4)
    radius = math.tan(math.asin(0.9 / 3.0)) / math.tan(math.radians(20)) * 32
    assert seen.coverage.sum().item() == pytest.approx(math.pi * radius**2, rel=0.01)
    middle = seen.normal[0, :, 31:33, 31:33].mean((1, 2))
    torch.testing.assert_close(middle, Cameras.orbit([30.0], [10.0]).back[0], atol=0.01, rtol=0)


def test_points_are_on_the_surface_and_parts_are_the_nearest():
    shape = build("snowman", "", Draw(torch.Generator().manual_seed(1)))
    seen = render(shape, Cameras.orbit([0.0], [5.0]), 64)
    full = seen.coverage[0, 0] == 1
    points = seen.point[0].permute(1, 2, 0)[full]
    assert shape.sdf(points).abs().median() < 0.01
    nose = shape.names.index("nose")
    rows, columns = (seen.part[0] == nose).nonzero(as_tuple=True)
    assert len(rows) > 4
    assert (columns.float().mean() - 31.5).abs() < 1.5  # it points to the front, az 0
