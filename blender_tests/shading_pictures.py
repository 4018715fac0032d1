"""The core's shading next to Cycles': ``python -m blender_tests.shading_pictures OUT.jpg``.

Balls of four materials under three lights; of each the core's, Cycles', and eight times their
difference. Cycles' pixels are kept in the folder CACHE, if one is named, and taken from there.
"""

import argparse
import tempfile
from pathlib import Path

import torch
from jaxtyping import Float
from PIL import Image, ImageDraw
from torch import Tensor

from blender_tests.compare_cycles import KD, add_ball, ball_points, cycles_pixels, empty_scene, psnr
from core.appearance.environment import Environment
from core.appearance.lights import blender_light, load_light
from core.appearance.shade import shade
from core.io.exr import read_exr
from core.ops import linear_to_srgb

LIGHTS = ("courtyard", "city", "forest")
MATERIALS = ((0.1, 1.0), (0.3, 1.0), (0.5, 1.0), (0.8, 0.0))  # roughness, metallic
SIZE, SAMPLES = 96, 384
SCALE, TITLE = 2, 18  # pixels of the picture per pixel; height of a line of text


def from_cycles(name: str, roughness: float, metallic: float, cache: Path) -> Tensor:
    """Cycles' linear pixels (S,S,3)."""
    path = cache / f"{name}_{roughness}_{metallic}.exr"
    if not path.exists():
        empty_scene(blender_light(name), SIZE, SAMPLES)
        add_ball(roughness, metallic)
        cycles_pixels(path)
    return read_exr(path)


def cell(name: str, environment: Environment, roughness: float, metallic: float, cache: Path):
    """Core, Cycles and difference side by side as sRGB (S,3S,3), and their likeness in dB."""
    seen, normal, view = ball_points(SIZE)
    like = torch.ones_like(normal[:, :1])
    ours = torch.zeros(SIZE, SIZE, 3)
    material = (torch.tensor(KD) * like, roughness * like, metallic * like)
    ours[seen] = shade(normal, view, *material, environment)
    theirs = from_cycles(name, roughness, metallic, cache) * seen[..., None]
    result = psnr(ours[seen], theirs[seen])
    ours, theirs = (linear_to_srgb(x.clamp(0, 1)) for x in (ours, theirs))
    return torch.cat([ours, theirs, (8 * (ours - theirs)).abs().clamp(max=1)], 1), result


def tile(picture: Float[Tensor, "h w 3"], title: str) -> Image.Image:
    """The picture enlarged, a line of text above it."""
    image = Image.fromarray((picture * 255).round().byte().numpy())
    image = image.resize((image.width * SCALE, image.height * SCALE), Image.Resampling.BICUBIC)
    out = Image.new("RGB", (image.width, image.height + TITLE), (24, 24, 24))
    out.paste(image, (0, TITLE))
    ImageDraw.Draw(out).text((6, 3), title, fill=(225, 225, 225))
    return out


def main() -> None:
    """Write the sheet, lights across, materials down; print the table."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("out", type=Path)
    parser.add_argument("--cache", type=Path, help="folder of Cycles' pixels")
    args = parser.parse_args()
    cache = args.cache or Path(tempfile.mkdtemp())
    columns = []
    for name in LIGHTS:
        environment, tiles = Environment.of(load_light(f"blender:{name}")), []
        for roughness, metallic in MATERIALS:
            picture, result = cell(name, environment, roughness, metallic, cache)
            kind = "metal" if metallic else "dielectric"
            title = f"{name}, {kind}, roughness {roughness}: core | Cycles | 8 x difference"
            tiles.append(tile(picture, f"{title}   {result:.1f} dB"))
            print(f"{name} {kind} roughness {roughness}: {result:.1f} dB", flush=True)
        columns.append(tiles)
    width, height = columns[0][0].size
    sheet = Image.new("RGB", (width * len(columns), height * len(MATERIALS)))
    for i, tiles in enumerate(columns):
        for j, one in enumerate(tiles):
            sheet.paste(one, (i * width, j * height))
    sheet.save(args.out, quality=88)


if __name__ == "__main__":
    main()
