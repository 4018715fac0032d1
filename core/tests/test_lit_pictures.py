"""What glows is seen in the core's own pictures, added to what the light makes."""

import torch

from core.appearance.environment import Environment, load_light
from core.appearance.shaded import UvMesh, render_shaded
from core.camera import Cameras
from core.geometry.mesh import Mesh, normalise
from core.io.maps import EMISSION_STRENGTH, Maps
from core.ops import srgb_to_linear
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
