"""Pictures between tensors and files: 8 and 16 bit PNG.

Numbers are scaled and cut in floating point and rounded last: colours get their sRGB curve before
they lose bits, and a normal below -1 or above 1 stays at the end of the range, it does not wrap.
"""

import struct
import zlib
from collections.abc import Callable, Mapping
from pathlib import Path

import numpy as np
import torch
from jaxtyping import Float, UInt8, UInt16
from torch import Tensor

from core.errors import UserError
from core.io.atomic import atomic_file
from core.io.input_file import check_file, check_name
from core.io.oiio import UnreadableError, read_pixels, write_pixels
from core.ops import linear_to_srgb, srgb_to_linear

BAND = 1 << 24  # numbers changed at once


def srgb_bytes(linear: Float[Tensor, "h w c"]) -> UInt8[np.ndarray, "h w c"]:
    """Linear colour to 8-bit sRGB."""
    return by_rows(lambda x: unit_bytes(linear_to_srgb(x)), linear)


def unit_bytes(x: Float[Tensor, "h w c"]) -> UInt8[np.ndarray, "h w c"]:
    """[0, 1] to 8 bits."""
    return by_rows(lambda x: (x.clamp(0, 1) * 255).round().to(torch.uint8).cpu().numpy(), x)


def normal_words(n: Float[Tensor, "h w 3"]) -> UInt16[np.ndarray, "h w 3"]:
    """Unit vectors to 16 bits, 0.5 + 0.5 n; flat is (32768, 32768, 65535)."""

    def words(n: Tensor) -> np.ndarray:
        return ((n.clamp(-1, 1) * 0.5 + 0.5) * 65535).round().cpu().numpy().astype(np.uint16)

    return by_rows(words, n)


def by_rows(change: Callable[[Tensor], np.ndarray], image: Float[Tensor, "h w c"]) -> np.ndarray:
    """``change`` of ``image``, some rows at a time: a map of 8192² has steps of 0.8 GB each."""
    rows = max(1, BAND // max(1, image[:1].numel()))
    return np.concatenate([change(part) for part in image.split(rows)])


def colors(image: np.ndarray) -> Float[Tensor, "h w c"]:
    """8-bit sRGB to linear colour."""
    return srgb_to_linear(units(image))


def units(image: np.ndarray) -> Float[Tensor, "h w c"]:
    """8 or 16 bits to [0, 1]."""
    return torch.from_numpy(image.astype(np.float32)) / float(np.iinfo(image.dtype).max)


def normals(image: np.ndarray) -> Float[Tensor, "h w 3"]:
    """8 or 16 bits to vectors, unit up to rounding."""
    return units(image) * 2 - 1


def write_png(path: Path, image: np.ndarray | Float[Tensor, "h w c"]) -> None:
    """Write a picture of 3 or 4 channels whole or not at all.

    ``image`` is an array of uint8 or uint16, or a tensor of [0, 1] that already has the curve
    which the file shall have, and is written with 8 bits.

    Raises UserError for a name that is not text, and as :func:`atomic_file`.
    """
    check_name(path)
    if isinstance(image, Tensor):
        image = unit_bytes(image)
    with atomic_file(path) as temporary:
        write_pixels(temporary, image)


def add_text(path: Path, texts: Mapping[str, str]) -> None:
    """Add ``texts`` by keyword to a PNG, as its own text chunks (iTXt, UTF-8, uncompressed).

    PNG specification, 11.3.3.4: keyword, flags, an empty language and translated keyword, text.
    """
    data = path.read_bytes()
    end = 8 + 25  # the signature and the header chunk, which is always first
    chunks = b""
    for key, text in texts.items():
        body = b"iTXt" + key.encode("latin-1") + b"\0\0\0\0\0" + text.encode("utf-8")
        chunks += struct.pack(">I", len(body) - 4) + body + struct.pack(">I", zlib.crc32(body))
    with atomic_file(path) as temporary:
        temporary.write_bytes(data[:end] + chunks + data[end:])


def read_png(path: Path) -> np.ndarray:
    """(H,W,C) uint8, or uint16 from a file of 16 bits; grey comes as one channel.

    Raises UserError for a file that is not there or no PNG.
    """
    check_file(path, "picture")
    try:
        return read_pixels(path, "png")
    except UnreadableError as error:
        raise UserError(
            f"{path} is not a readable PNG ({error}).", "Make the file again."
        ) from error
