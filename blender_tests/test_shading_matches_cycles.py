"""The core's pictures against Cycles: the same light, camera and material give the same picture."""

import math
from pathlib import Path

import numpy as np
import pytest
import torch

bpy = pytest.importorskip("bpy")

from blender_tests.compare_cycles import (  # noqa: E402
    KD,
    Exact,
    add_ball,
    ball_points,
    cycles_pixels,
    empty_scene,
    prefiltered,
    psnr,
)
from core.appearance.environment import Environment  # noqa: E402
from core.appearance.latlong import directions  # noqa: E402
from core.appearance.lights import blender_light, load_light  # noqa: E402
from core.appearance.shade import shade  # noqa: E402
from core.io.exr import write_exr  # noqa: E402
from core.io.png import read_png, units  # noqa: E402
from core.ops import linear_to_srgb, normalize  # noqa: E402

pytestmark = pytest.mark.blender

LIGHTS = ("courtyard", "city", "forest", "sunset", "interior")  # city and sunset have a sun
ROUGHNESS = (0.1, 0.3, 0.5, 0.8)
LEAST, LEAST_EXACT = 38, 45  # dB


@pytest.fixture(scope="module")
def light_file(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Coloured lights in unlike directions: no turned or mirrored map looks the same."""
    d = directions(256, 512)
    image = torch.full_like(d, 0.15)
    for axis, color, sharpness in (
        ((1, 0, 0.2), (3, 0.3, 0.3), 12),
        ((0, 1, 0.5), (0.2, 3, 0.2), 20),
        ((-0.3, -1, 0.1), (0.3, 0.5, 4), 30),
        ((0.2, -0.6, 1), (4, 4, 3), 40),
        ((-1, 0.3, -0.6), (2, 0, 2), 8),
    ):
        axis = normalize(torch.tensor(axis, dtype=torch.float32))
        lobe = torch.exp(sharpness * (d @ axis - 1))
        image = image + lobe[..., None] * torch.tensor(color)
    path = tmp_path_factory.mktemp("light") / "light.exr"
    write_exr(path, image)
    return path


def ball(roughness: float, metallic: float, size: int) -> tuple:
    """Where the ball is, and the arguments of :func:`shade` for its points."""
    seen, normal, view = ball_points(size)
    like = torch.ones_like(normal[:, :1])
    return seen, (normal, view, torch.tensor(KD) * like, roughness * like, metallic * like)


def both(picture: torch.Tensor, cover: torch.Tensor, seen: torch.Tensor, ours: torch.Tensor):
    """Cycles' and the core's colours where both see the ball."""
    assert float((cover != seen).float().mean()) < 0.005
    return picture[cover & seen], ours[cover[seen]]


@pytest.mark.parametrize(("roughness", "metallic"), [(0.1, 1), (0.3, 0), (0.5, 1), (0.8, 0)])
def test_ball_looks_as_in_cycles(
    light_file: Path, tmp_path: Path, roughness: float, metallic: float
) -> None:
    """And not as under the same light turned round."""
    empty_scene(light_file, 64, 96)
    add_ball(roughness, metallic)
    theirs = cycles_pixels(tmp_path / "cycles.exr")
    environment = prefiltered(str(light_file))
    seen, points = ball(roughness, metallic, 64)
    result = psnr(*both(*theirs, seen, shade(*points, environment)))
    turned = psnr(*both(*theirs, seen, shade(*points, environment.rotated(math.pi))))
    print(f"roughness {roughness} metallic {metallic}: {result:.1f} dB, turned {turned:.1f}")
    assert result > LEAST
    assert turned < result - 10


def test_standard_view_is_the_srgb_curve(light_file: Path, tmp_path: Path) -> None:
    """What the comparisons assume of the colours that a user sees."""
    empty_scene(light_file, 32, 4)
    add_ball(0.5, 0.0)
    pixels, cover = cycles_pixels(tmp_path / "cycles.exr")
    settings = bpy.context.scene.render.image_settings
    settings.file_format, settings.color_mode, settings.color_depth = "PNG", "RGB", "16"
    bpy.data.images["Render Result"].save_render(str(tmp_path / "seen.png"))
    seen = units(read_png(tmp_path / "seen.png"))
    assert torch.allclose(seen[cover], linear_to_srgb(pixels[cover].clamp(0, 1)), atol=1e-3)


def test_no_fireflies_under_a_sun(tmp_path: Path) -> None:
    """Nowhere brighter than what Cycles shows about that pixel; the sun's mirror image is there."""
    empty_scene(blender_light("city"), 64, 96)
    add_ball(0.1, 1.0)
    theirs, cover = cycles_pixels(tmp_path / "cycles.exr")
    seen, points = ball(0.1, 1.0, 64)
    environment = prefiltered("blender:city")
    ours = torch.zeros(64, 64, 3)
    ours[seen] = shade(*points, environment)
    result = psnr(ours[seen & cover], theirs[seen & cover])
    near = torch.nn.functional.max_pool2d(theirs.permute(2, 0, 1)[None], 3, 1, 1)[0]
    print(f"under the sun {result:.1f} dB, brightest {float(ours.max()):.0f}")
    assert bool((ours.permute(2, 0, 1) <= 1.5 * near + 0.1)[:, seen & cover].all())
    assert float(ours.max()) > 20
    assert result > LEAST


@pytest.mark.slow
@pytest.mark.parametrize("name", LIGHTS)
def test_every_material_looks_as_in_cycles(name: str, tmp_path: Path) -> None:
    """The core's shading, and the exact integral, whose rest to Cycles is mostly Cycles' noise."""
    image = load_light(f"blender:{name}")
    environment, exact, found = Environment.of(image), Exact(image), {}
    for roughness in ROUGHNESS:
        for metallic in (0.0, 1.0):
            empty_scene(blender_light(name), 96, 384)
            add_ball(roughness, metallic)
            theirs = cycles_pixels(tmp_path / "cycles.exr")
            seen, points = ball(roughness, metallic, 96)
            found[roughness, metallic] = [
                psnr(*both(*theirs, seen, ours))
                for ours in (shade(*points, environment), exact.shade(*points))
            ]
    for key, value in found.items():
        print(name, *key, *(f"{dB:.1f}" for dB in value))
    core, truth = np.array(list(found.values())).T
    assert core.min() > LEAST
    assert truth.min() > LEAST_EXACT


def test_exact_integral_is_cycles(tmp_path: Path) -> None:
    """The tests' reference, in one cell."""
    empty_scene(blender_light("courtyard"), 48, 256)
    bpy.context.scene.world.cycles.sample_map_resolution = 2048  # 0.1 dB
    add_ball(0.5, 1.0)
    theirs = cycles_pixels(tmp_path / "cycles.exr")
    seen, points = ball(0.5, 1.0, 48)
    result = psnr(*both(*theirs, seen, Exact(load_light("blender:courtyard")).shade(*points)))
    print(f"exact {result:.1f} dB")
    assert result > LEAST_EXACT
