"""The process that runs xatlas: ``python unwrap_worker.py FOLDER SIZE PADDING THOROUGH``.

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
# Texels along the side of the square in which places are tried: the islands' places hardly depend
# on it, the time does with its square.
PLACES = 512
GROWTH = 1.25  # the atlas comes out larger than asked for by about this
MAX_COST = 4.0  # of a face in an island: fewer and larger islands than at xatlas's own 2


def pack(
    verts: np.ndarray, faces: np.ndarray, size: int, padding: int, thorough: bool
) -> tuple[np.ndarray, np.ndarray]:
    """uv in [0, 1] and a uv index per corner, ``padding`` texels at ``size`` round each island.

    ``thorough`` tries every place for every island instead of some. The atlas is scaled into the
    unit square, which shrinks the gaps: they are asked for wider, and again where that is short.
    """
    gap = max(1, round(padding * GROWTH * PLACES / size))
    places = min(PLACES, round(gap * size / (padding * GROWTH)))
    for _ in range(MAX_PASSES):
        atlas = xatlas.Atlas()
        atlas.add_mesh(verts, faces)
        charts, options = xatlas.ChartOptions(), xatlas.PackOptions()
        charts.max_cost = MAX_COST
        options.resolution, options.padding, options.bruteForce = places, gap, thorough
        atlas.generate(charts, options)
        side = max(atlas.width, atlas.height)
        if gap * size >= padding * side:
            break
        places = int(0.98 * places * gap * size / (padding * side))
    source, corners, uv = atlas[0]  # uv comes divided by the atlas's own width and height
    if not np.array_equal(source[corners], faces):
        raise RuntimeError("xatlas returned other faces than it was given")
    return uv, corners


def main(folder: Path, size: int, padding: int, thorough: bool) -> None:
    """Unwrap the mesh that lies in ``folder``."""
    verts, faces = np.load(folder / "verts.npy"), np.load(folder / "faces.npy")
    uv, corners = pack(verts, faces, size, padding, thorough)
    np.save(folder / "uv.npy", uv)
    np.save(folder / "face_uvs.npy", corners)


if __name__ == "__main__":
    main(Path(sys.argv[1]), int(sys.argv[2]), int(sys.argv[3]), sys.argv[4] == "thorough")
