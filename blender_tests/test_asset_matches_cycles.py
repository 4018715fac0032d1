"""An asset with varying maps, imported by the add-on and seen in Cycles, against the core's."""

from pathlib import Path

import pytest
import torch
from torch import Tensor

bpy = pytest.importorskip("bpy")

from blender_tests.compare_cycles import (  # noqa: E402
    add_asset,
    asset_pixels,
    cycles_pixels,
    empty_scene,
    inner,
    prefiltered,
    psnr,
)
from core.appearance.lights import blender_light  # noqa: E402
from core.appearance.material import Material  # noqa: E402
from core.geometry.mesh import Mesh  # noqa: E402
from core.io.asset import read_asset, write_asset  # noqa: E402
from core.io.png import normal_words, write_png  # noqa: E402
from core.ops import normalize  # noqa: E402
from core.tests.meshes import sphere, torus  # noqa: E402
from core.tests.texture_shapes import one_material  # noqa: E402
from core.tests.tiny_runs import loosely_packed  # noqa: E402
from core.texture.bake import bake  # noqa: E402
from core.texture.unwrap import unwrap  # noqa: E402

pytestmark = pytest.mark.blender

LIGHT = "courtyard"
LEAST = 35  # dB
SIZE = 80


def varied(points: Tensor) -> Material:
    """Stripes of colour, patches of roughness, veins of metal, and a bumpy normal."""
    x, y, z = points.unbind(1)
    wave = 0.5 + 0.5 * torch.sin(9 * z + 3 * torch.sin(4 * x))
    kd = torch.stack([0.15 + 0.7 * wave, 0.3 + 0.3 * torch.sin(5 * y), 0.7 - 0.6 * wave], 1)
    roughness = 0.5 + 0.35 * torch.sin(6 * x) * torch.cos(5 * y)
    metallic = torch.sigmoid(20 * torch.sin(4 * (x + y + z)))
    return Material(kd.clamp(0, 1), roughness[:, None], metallic[:, None], bumps(points))


def bumps(points: Tensor) -> Tensor:
    """Normals that tilt by up to 20 degrees, otherwise along x than along y."""
    x, y, z = points.unbind(1)
    tilt = [0.25 * torch.sin(11 * y + 6 * z), 0.25 * torch.cos(9 * x - 5 * z)]
    return normalize(torch.stack([*tilt, torch.ones_like(x)], 1))


def bumpy(points: Tensor) -> Material:
    """One glossy metal, so that all that is seen comes from the normals."""
    like = torch.ones_like(points[:, :1])
    return Material(like * torch.tensor([0.9, 0.6, 0.3]), 0.35 * like, like, bumps(points))


def pebble() -> tuple[Tensor, Tensor]:
    """A closed, convex shape with rounded corners, of three unlike axes."""
    verts, faces = sphere(5, radius=1.0)
    return verts / verts.abs().pow(2.5).sum(1, keepdim=True) ** 0.4 * verts.new_tensor(
        [0.55, 0.42, 0.65]
    ), faces


def make_asset(folder: Path, material, shape=None) -> Path:
    """Unwrapped, baked and written as every asset of the core is."""
    verts, faces = shape or pebble()
    with loosely_packed():
        atlas = unwrap(verts, faces, 512)
    maps = bake(Mesh(verts, faces, *atlas), material, 512)
    info = {"prompt": "pebble", "distribution": "GGX"}
    return write_asset(folder, Mesh(verts, faces, *atlas), maps, info)


def in_cycles(folder: Path, samples: int = 128, bounces: int = 1) -> tuple[Tensor, Tensor]:
    """Its pixels in Cycles, and where it is."""
    empty_scene(blender_light(LIGHT), SIZE, samples, bounces)
    add_asset(folder)
    return cycles_pixels(folder.parent / "cycles.exr")


def likeness(folder: Path, theirs: Tensor, cover: Tensor, self_shadow: bool = False) -> float:
    """PSNR of the core's picture of an asset to Cycles' pixels, dB."""
    environment = prefiltered(f"blender:{LIGHT}")
    ours, seen = asset_pixels(folder, SIZE, environment, self_shadow)
    assert float((cover != seen).float().mean()) < 0.005
    where = inner(cover & seen)
    assert int(where.sum()) > 1000
    return psnr(ours[where], theirs[where])


def test_textured_asset_looks_as_in_cycles(tmp_path: Path) -> None:
    asset = make_asset(tmp_path / "asset", varied)
    result = likeness(asset, *in_cycles(asset))
    print(f"textured asset {result:.1f} dB")
    assert result > LEAST


def test_baked_bump_is_the_same_bump_in_cycles(tmp_path: Path) -> None:
    """In MikkTSpace and with +Y up: a map whose y is turned round misses by 8 dB or more."""
    asset = make_asset(tmp_path / "asset", bumpy)
    pixels = in_cycles(asset)
    result = likeness(asset, *pixels)
    maps = read_asset(asset).maps
    write_png(asset / "normal.png", normal_words(maps.normal * torch.tensor([1.0, -1.0, 1.0])))
    turned = likeness(asset, *pixels)
    print(f"bump {result:.1f} dB, with y turned round {turned:.1f}")
    assert result > LEAST
    assert turned < result - 8


def test_a_torus_shadows_itself_as_in_cycles(tmp_path: Path) -> None:
    """Measured: 27 dB without, 36 with."""
    asset = make_asset(tmp_path / "asset", one_material((0.8, 0.35, 0.1)), torus(96, 48))
    pixels = in_cycles(asset, bounces=6)
    without, with_shadows = (likeness(asset, *pixels, shadow) for shadow in (False, True))
    print(f"torus {without:.1f} dB, with its own shadows {with_shadows:.1f}")
    assert with_shadows > 33
    assert with_shadows > without + 5


def test_open_mesh_from_behind_is_as_in_cycles(tmp_path: Path) -> None:
    """A shell whose normals point inwards, open below; the bump is perturbed, then turned round."""
    verts, faces = pebble()
    faces = faces[verts[faces].mean(1)[:, 2] > -0.5].flip(1)
    used, faces = faces.unique(return_inverse=True)
    asset = make_asset(tmp_path / "asset", bumpy, (verts[used], faces))
    result = likeness(asset, *in_cycles(asset))
    print(f"from behind {result:.1f} dB")
    assert result > LEAST
