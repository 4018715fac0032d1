"""The core's own pictures: what glows is added to the light; a face is seen from both sides."""

import pytest
import torch

from core.appearance.environment import Environment, load_light
from core.appearance.material import Material
from core.appearance.shaded import UvMesh, render_shaded
from core.camera import Cameras
from core.geometry.mesh import Mesh, normalise
from core.io.maps import EMISSION_STRENGTH, Maps
from core.ops import srgb_to_linear
from core.tests.meshes import sphere
from core.tests.texture_shapes import torus, torus_uv
from core.texture.look_up import emission_source, maps_source


def test_emission_is_added_in_linear_light_and_in_the_dark_it_is_all_there_is() -> None:
    verts, faces = torus()
    mesh = UvMesh.of(Mesh(normalise(verts)[0], faces, *torus_uv()))
    grey = torch.full((16, 16, 3), 0.5)
    flat = torch.tensor([0.0, 0, 1]).expand(16, 16, 3)
    color = torch.tensor([0.08, 0.04, 0.0])
    maps = Maps(grey, grey, flat, emission=color.expand(16, 16, 3))
    cameras = Cameras.orbit([30.0], [40.0])

    def seen(strength: float, emission: bool) -> torch.Tensor:
        light = Environment.of(strength * load_light("studio"))
        source = emission_source(maps) if emission else None
        shaded = render_shaded(mesh, maps_source(maps), cameras, 64, light, emission=source)
        return srgb_to_linear(shaded.srgb[0][shaded.o[0, ..., 0] == 1])

    wanted = EMISSION_STRENGTH * color
    dark = seen(1e-5, True)
    torch.testing.assert_close(dark, wanted.expand_as(dark), atol=1e-3, rtol=0)
    added = seen(0.1, True) - seen(0.1, False)
    # Where one part of the ring is before another, antialiasing mixes their screen colours.
    assert (added - wanted).abs().amax(1).quantile(0.9) < 2e-3
    assert emission_source(maps._replace(emission=None)) is None


def red_before_blue(points: torch.Tensor, _uv: torch.Tensor) -> Material:
    """Dull; red at the front (-Y)."""
    red, one = (points[:, 1:2] < 0).float(), torch.ones(len(points), 1)
    up = torch.tensor([[0.0, 0, 1]]).expand(len(points), 3)
    return Material(torch.cat([red, 0 * red, 1 - red], 1), one, 0 * one, up)


@pytest.mark.parametrize("flips", ["all", "half"])
def test_a_mesh_that_is_inside_out_is_seen_from_its_near_side(flips: str) -> None:
    verts, faces = sphere(4)
    light, cameras = Environment.of(load_light("studio")), Cameras.orbit([0.0], [0.0])

    def seen(triangles: torch.Tensor):
        mesh = UvMesh.of(Mesh(verts, triangles, verts[:, :2], triangles))
        return render_shaded(mesh, red_before_blue, cameras, 64, light)

    flip = torch.rand(len(faces), generator=torch.Generator().manual_seed(0)) < 0.5
    flip |= flips == "all"
    right, turned = seen(faces), seen(torch.where(flip[:, None], faces.flip(1), faces))
    assert float(turned.points[:, 1].max()) < 0.01
    # Where neighbours disagree the rim is not always smoothed.
    assert float((turned.o - right.o).abs().mean()) < 0.01
    assert bool((turned.o[right.o == 1] > 0.4).all())
    if flips == "all":
        torch.testing.assert_close(turned.srgb, right.srgb, atol=1e-3, rtol=0)
