"""Letters, and the land of the world: margins read from a picture."""

import json
from functools import cache
from pathlib import Path

import numpy as np
import torch
import torch.nn.functional as F
from jaxtyping import Float
from PIL import Image, ImageDraw, ImageFont
from scipy import ndimage
from torch import Tensor

SIZE = 256  # of Pillow's own font (Aileron, CC0), in pixels
ROOM = 0.4  # around a text, of a capital's height
# Rings of longitudes and latitudes, the seas within them left out: Natural Earth's land of
# 1 : 110 million (public domain), simplified to 1.6°.
LAND = Path(__file__).with_name("land.json")
PER_DEGREE = 3  # pixels


def lettering(at: Float[Tensor, "p 2"], text: str) -> Float[Tensor, " p"]:
    """Positive inside the letters; all lengths in heights of a capital.

    Args:
        at: places to the right of the text's middle and above it.
    """
    field, (wide, high) = _text_field(text)
    scaled = at / at.new_tensor([wide / 2, -high / 2])
    # Beyond the picture there is nothing.
    return read(field, scaled) - (scaled.abs() - 1).clamp_min(0).amax(1)


def text_size(text: str) -> tuple[float, float]:
    """The width and the height of a text, in heights of a capital."""
    wide, high = _text_field(text)[1]
    return wide - 2 * ROOM, high - 2 * ROOM


def land(points: Float[Tensor, "p 3"]) -> Float[Tensor, " p"]:
    """Positive on land, radians; north is up, and Europe and Africa face the front."""
    x, y, z = torch.nn.functional.normalize(points, dim=1).unbind(1)
    east, north = torch.atan2(x, -y), z.clamp(-1, 1).asin()
    east = (east + np.radians(15) + np.pi) % (2 * np.pi) - np.pi
    return read(_land_field(), torch.stack([east / np.pi, -north / (np.pi / 2)], 1))


def read(field: Float[Tensor, "h w"], at: Float[Tensor, "p 2"]) -> Float[Tensor, " p"]:
    """The picture's value at places from -1 to 1, to the right and down."""
    found = F.grid_sample(
        field.to(at)[None, None], at[None, None], align_corners=False, padding_mode="border"
    )
    return found[0, 0, 0]


@cache
def _text_field(text: str) -> tuple[Float[Tensor, "h w"], tuple[float, float]]:
    """Margins of a picture's pixels, and the size of the picture."""
    font = ImageFont.load_default(SIZE)
    blank = ImageDraw.Draw(Image.new("L", (1, 1)))
    left, top, right, bottom = blank.multiline_textbbox((0, 0), text, font, align="center")
    _, capital_top, _, capital_bottom = font.getbbox("H")
    capital = capital_bottom - capital_top
    room = int(ROOM * capital)
    picture = Image.new("L", (int(right - left) + 2 * room, int(bottom - top) + 2 * room))
    ImageDraw.Draw(picture).multiline_text(
        (room - left, room - top), text, 255, font, align="center"
    )
    field = margins_of(np.asarray(picture) > 127) / capital
    return torch.from_numpy(field).float(), (picture.width / capital, picture.height / capital)


@cache
def _land_field() -> Float[Tensor, "h w"]:
    """Margins of the land of the whole world, longitude by latitude."""
    picture = Image.new("L", (360 * PER_DEGREE, 180 * PER_DEGREE))
    draw = ImageDraw.Draw(picture)
    for ring in json.loads(LAND.read_text("utf-8")):
        draw.polygon([((x + 180) * PER_DEGREE, (90 - y) * PER_DEGREE) for x, y in ring], 255)
    field = margins_of(np.asarray(picture) > 127) / PER_DEGREE
    return torch.from_numpy(np.radians(field)).float()


def margins_of(inside: np.ndarray) -> np.ndarray:
    """Margins of a picture's pixels, in pixels."""
    within, beyond = map(np.asarray, map(ndimage.distance_transform_edt, (inside, ~inside)))
    return within - beyond
