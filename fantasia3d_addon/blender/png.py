"""Writes PNG files of 8 and 16 bits; Blender's own writer applies the view transform to them."""

from __future__ import annotations

import struct
import zlib
from pathlib import Path

import numpy as np

SIGNATURE = b"\x89PNG\r\n\x1a\n"


def write_png(path: Path, picture: np.ndarray) -> None:
    """``picture`` (H,W,3) or, with an alpha, (H,W,4), uint8 or uint16, row 0 at the top."""
    height, width, channels = picture.shape
    # PNG is big-endian; each row starts with its filter's number.
    big = np.ascontiguousarray(picture.astype(picture.dtype.newbyteorder(">")))
    rows = big.view(np.uint8).reshape(height, -1)
    lines = np.concatenate([np.zeros((height, 1), np.uint8), rows], 1)
    kind = 6 if channels == 4 else 2  # PNG's colour types: RGBA, RGB
    header = struct.pack(">IIBBBBB", width, height, 8 * picture.dtype.itemsize, kind, 0, 0, 0)
    chunks = ((b"IHDR", header), (b"IDAT", zlib.compress(lines.tobytes(), 6)), (b"IEND", b""))
    body = b"".join(
        struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data))
        for name, data in chunks
    )
    path.write_bytes(SIGNATURE + body)


def to_bytes(values: np.ndarray, bits: int = 8) -> np.ndarray:
    """``values`` from 0 to 1 as unsigned integers of ``bits``."""
    top, kind = (255, np.uint8) if bits == 8 else (65535, np.uint16)
    return np.round(np.clip(values, 0, 1) * top).astype(kind)
