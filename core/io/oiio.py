"""OpenImageIO, the only file that imports it: numbers as they are in a file, unconverted."""

import errno
import os
from pathlib import Path

import numpy as np
import OpenImageIO

from core.io.input_file import check_name

# A larger picture is a broken header or an attack on the memory.
MAX_SIDE = 1 << 15  # pixels
MAX_PIXELS = 1 << 27  # a light of 16384 x 8192; decoded it takes up to 1.5 GB
# Bytes of a picture for each byte of its file: deflate packs 1032 to 1 at most; of a Radiance
# picture, whose runs have no bound, no more than a flat one needs.
MAX_RATIO = {"png": 1100, "hdr": 10_000}

# Alpha as stored: the library would multiply colours by it.
STRAIGHT_ALPHA = OpenImageIO.ImageSpec()
STRAIGHT_ALPHA.attribute("oiio:UnassociatedAlpha", 1)


class UnreadableError(ValueError):
    """The library's sentence on why a file is not the picture it should be."""


def read_pixels(path: Path, format: str) -> np.ndarray:
    """(H,W,C) of the file's own type (uint8, uint16, float32); ``format`` is "png" or "hdr".

    Raises UnreadableError for a file of another format, a broken one, or one too large; UserError
    for a name that is not text.
    """
    check_name(path)
    source = OpenImageIO.ImageInput.open(str(path), STRAIGHT_ALPHA)
    if source is None:
        raise UnreadableError(_one_line(OpenImageIO.geterror()))
    try:
        spec = source.spec()
        if source.format_name() != format:
            raise UnreadableError(f"it is a {source.format_name()} file")
        _check_size(spec, path.stat().st_size, format)
        if spec.get_int_attribute("Orientation", 1) != 1:
            raise UnreadableError("its rows do not run from the top left")
        pixels = source.read_image(0, 0, 0, spec.nchannels, spec.format.basetype)
        # The library fills in missing scanlines: its error message counts.
        if pixels is None or source.has_error:
            raise UnreadableError(_one_line(source.geterror()))
        return pixels
    finally:
        source.close()


def _check_size(spec: OpenImageIO.ImageSpec, size: int, format: str) -> None:
    """Before any memory is taken: the header alone states how much."""
    declared = f"its size {spec.width} x {spec.height}"
    if max(spec.width, spec.height) > MAX_SIDE:
        raise UnreadableError(f"{declared} is over {MAX_SIDE} a side")
    if spec.width * spec.height > MAX_PIXELS:
        raise UnreadableError(f"{declared} is over {MAX_PIXELS:,} pixels")
    if spec.image_bytes(True) > MAX_RATIO[format] * size:
        raise UnreadableError(f"{declared} cannot be in {size:,} bytes")


def write_pixels(path: Path, pixels: np.ndarray) -> None:
    """Write (H,W,C) of uint8 or uint16 as a PNG, the values as they are.

    Raises OSError. The library reports success on a full disk, so its error text decides.
    """
    path.open("wb").close()  # for the system's own reason, which the library does not pass on
    height, width, channels = pixels.shape
    kind = OpenImageIO.UINT8 if pixels.dtype == np.uint8 else OpenImageIO.UINT16
    spec = OpenImageIO.ImageSpec(width, height, channels, kind)
    spec.attribute("png:compressionLevel", 6)
    spec.attribute("oiio:UnassociatedAlpha", 1)
    out = OpenImageIO.ImageOutput.create("png")
    done = out.open(str(path), spec) and out.write_image(np.ascontiguousarray(pixels))
    closed = out.close()
    text = out.geterror().strip()
    if "could only write" in text:
        raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC), str(path))
    if text or not (done and closed):
        raise OSError(errno.EIO, _one_line(text), str(path))


def _one_line(text: str) -> str:
    """The first line of an error: a full disk repeats it for each block."""
    return text.strip().split("\n")[0].rstrip(".") or "no reason was given"
