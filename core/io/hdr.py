"""Radiance pictures (.hdr): "Real Pixels", Ward, Graphics Gems II, 1991; the run-length coding of
Radiance's color.c. No well-kept light library reads them, hence these lines.
"""

from pathlib import Path

import numpy as np
import torch
from jaxtyping import Float
from torch import Tensor

from core.errors import MissingError, UserError

MAX_SIDE = 1 << 15


def read_hdr(path: "str | Path") -> Float[Tensor, "h w 3"]:
    """Linear colours of a Radiance RGBE file, row 0 at the top, in either coding.

    Raises ``MissingError`` if there is no file, ``UserError`` if it is no such picture.
    """
    if not Path(path).is_file():
        raise MissingError(f"There is no file {path}.", "Check the path.")
    data = Path(path).read_bytes()
    try:
        height, width, start = parse_header(data)
        rgbe = decode(data, start, height, width)
    except (ValueError, IndexError) as error:
        raise UserError(
            f"{path} cannot be read as a Radiance picture: {error}.",
            "Save it again as .hdr (RGBE, top row first) or as .exr.",
        ) from error
    # Without Ward's half step, as Blender reads it.
    scale = np.ldexp(np.float32(1), rgbe[..., 3:].astype(np.int32) - (128 + 8))
    return torch.from_numpy(rgbe[..., :3] * scale)


def parse_header(data: bytes) -> tuple[int, int, int]:
    """Height, width and where the pixels begin."""
    if not data.startswith((b"#?RADIANCE", b"#?RGBE")):
        raise ValueError("it does not begin with #?RADIANCE")
    end = data.find(b"\n\n")
    if end < 0:
        raise ValueError("its header has no end")
    if b"FORMAT=32-bit_rle_xyze" in data[:end]:
        raise ValueError("its colours are XYZ, not RGB")
    line_end = data.find(b"\n", end + 2)
    words = data[end + 2 : line_end].split()
    if line_end < 0 or len(words) != 4 or words[0] != b"-Y" or words[2] != b"+X":
        raise ValueError("its size is not given as -Y height +X width")
    height, width = int(words[1]), int(words[3])
    if not (0 < height <= MAX_SIDE and 0 < width <= MAX_SIDE):
        raise ValueError(f"its size {width} x {height} makes no sense")
    return height, width, line_end + 1


def decode(data: bytes, at: int, height: int, width: int) -> np.ndarray:
    """The (height, width, 4) bytes of the pixels, run-length coded by row and channel or plain."""
    marker = bytes([2, 2, width >> 8, width & 255])
    if not 8 <= width < MAX_SIDE or data[at : at + 4] != marker:
        size = height * width * 4
        if len(data) - at < size:
            raise ValueError("it ends before its last pixel")
        return np.frombuffer(data, np.uint8, size, at).reshape(height, width, 4)
    rows = np.empty((height, 4, width), np.uint8)
    for row in rows:
        if data[at : at + 4] != marker:
            raise ValueError("a row does not begin where it should")
        at += 4
        for channel in row:
            at = decode_runs(data, at, channel)
    return rows.transpose(0, 2, 1)


def decode_runs(data: bytes, at: int, out: np.ndarray) -> int:
    """Fills ``out`` from the runs at ``at``; returns where they end."""
    filled = 0
    while filled < len(out):
        count = data[at]
        repeated, count = count > 128, count - 128 if count > 128 else count
        if count == 0 or filled + count > len(out):
            raise ValueError("a run is longer than its row")
        taken = 1 if repeated else count
        values = np.frombuffer(data, np.uint8, taken, at + 1)
        out[filled : filled + count] = values
        filled, at = filled + count, at + 1 + taken
    return at
