"""The process that runs xatlas: ``python unwrap_worker.py FOLDER SIZE PADDING``.

xatlas holds Python's lock while it works and a broken mesh can end the whole process, so it gets
a process of its own, which can be watched, stopped and outlived. Reads ``verts.npy`` (V,3) float32
and ``faces.npy`` (F,3) uint32 in FOLDER, writes ``uv.npy`` (U,2) and ``face_uvs.npy`` (F,3).
Needs nothing of torch, so that it starts at once.
"""

import sys
from pathlib import Path

import numpy as np
import xatlas

MAX_PASSES = 3


def pack(
    verts: np.ndarray, faces: np.ndarray, size: int, padding: int
) -> tuple[np.ndarray, np.ndarray]:
    """uv in [0, 1] and a uv index per corner, ``padding`` texels at ``size`` round each island.

    The atlas comes out larger than asked for, by a tenth to a half, and is then scaled into the
    unit square, which shrinks the gaps: they are asked for wider, and again where that is short.
    """
    gap = padding + padding // 2
    for _ in range(MAX_PASSES):
        atlas = xatlas.Atlas()
        atlas.add_mesh(verts, faces)
        options = xatlas.PackOptions()
        options.resolution = size
        options.padding = gap
        atlas.generate(xatlas.ChartOptions(), options)
        side = max(atlas.width, atlas.height)
        if gap * size >= padding * side:
            break
        gap = -(-padding * side * 11 // (size * 10))
    source, corners, uv = atlas[0]  # uv comes divided by the atlas's own width and height
    if not np.array_equal(source[corners], faces):
        raise RuntimeError("xatlas returned other faces than it was given")
    return uv, corners


def main(folder: Path, size: int, padding: int) -> None:
    """Unwrap the mesh that lies in ``folder``."""
    uv, corners = pack(np.load(folder / "verts.npy"), np.load(folder / "faces.npy"), size, padding)
    np.save(folder / "uv.npy", uv)
    np.save(folder / "face_uvs.npy", corners)


if __name__ == "__main__":
    main(Path(sys.argv[1]), int(sys.argv[2]), int(sys.argv[3]))
