"""Small pictures and a light mesh of what a training has so far, for those who watch the run."""

import io
import time
from pathlib import Path

import numpy as np
import torch
from jaxtyping import Float, Int, UInt8
from torch import Tensor

from core.appearance.seen_through import GROUND
from core.camera import Cameras
from core.geometry.mesh import turned
from core.guidance.builtin.physical import longest_side
from core.io.atomic import atomic_file
from core.io.png import unit_bytes, write_png
from core.io.run_folder import RunFolder
from core.render.normals import render_normals

SIZE = 256  # pixels
FRAMES = 12  # of a film, in its first while
MAX_FACES = 50_000  # of the light mesh: Blender reads it in 20 ms of one core
FREE = 1e-3  # of a cell's planes: what holds its vertex at the mean along them
VIEW = {"azimuth_deg": [30.0], "elevation_deg": [20.0]}


def show_shape(run: RunFolder, verts: Float[Tensor, "v 3"], faces: Int[Tensor, "f 3"]) -> None:
    """The geometry training's shape as normals, and as a light mesh in training units."""
    cameras = Cameras.orbit(**VIEW).to(verts.device)
    verts = turned(verts, -run.turn) if run.turn else verts
    n, o = render_normals(verts, faces, cameras, SIZE, "camera")
    picture = over_grey((n[0] + o[0]) / 2, o[0])
    write_png(run.preview_path("normals.png"), picture)
    keep_frame(run, "geometry", picture)
    write_shape(run.preview_path("shape.npz"), verts, faces, size_of(run, verts))
    run.report("preview", stage="geometry", path="preview/normals.png")
    run.report("preview", stage="geometry", path="preview/shape.npz")


def show_color(run: RunFolder, picture: UInt8[np.ndarray, "h w 3"]) -> None:
    """The appearance training's asset as it is lit."""
    write_png(run.preview_path("color.png"), picture)
    keep_frame(run, "appearance", picture)
    run.report("preview", stage="appearance", path="preview/color.png")


def keep_frame(run: RunFolder, stage: str, picture: UInt8[np.ndarray, "h w 3"]) -> None:
    """Add to the stage's film, small, where the last frame is an old one.

    The names count milliseconds. The distance grows with the film's own length, so a run of hours
    has a hundred frames and its first minute most of what changes fast.
    """
    folder = run.preview_path("film")
    folder.mkdir(exist_ok=True)
    now = round(time.time() * 1000)
    frames = folder.glob(f"{stage}-{'[0-9]' * 13}.png")  # and no copy of the user's
    times = sorted(int(path.stem.split("-")[1]) for path in frames)
    if times and now - times[-1] < (now - times[0]) / FRAMES:
        return
    write_png(folder / f"{stage}-{now:013d}.png", np.ascontiguousarray(picture[::2, ::2]))


def over_grey(
    picture: Float[Tensor, "h w 3"], o: Float[Tensor, "h w 1"]
) -> UInt8[np.ndarray, "h w 3"]:
    """A picture over black, in [0, 1], put over a light grey instead."""
    return unit_bytes((picture + (1 - o) * GROUND).detach().cpu())


def size_of(run: RunFolder, verts: Float[Tensor, "v 3"]) -> float:
    """The longest side in metres of the run's asset, ``verts`` in any unit, +Z up: the user's or
    the prompt's, or else the thing's usual one."""
    extents = (verts.amax(0) - verts.amin(0)).tolist()
    return run.job.size_m or run.size_m or longest_side(run.job.prompt, extents)


def write_shape(
    path: Path, verts: Float[Tensor, "v 3"], faces: Int[Tensor, "f 3"], size_m: float = 1.0
) -> None:
    """A light mesh as numpy's npz, without pickle: ``verts`` float32 in the world's axes (+Z up),
    ``faces`` int32, ``size_m`` what the longest side will be in metres."""
    v, f = lighter(verts.detach().cpu(), faces.cpu())
    packed = io.BytesIO()  # in memory first: on a full disk numpy leaves a zip file open
    faces_32 = f.numpy().astype(np.int32)
    np.savez(packed, verts=v.numpy(), faces=faces_32, size_m=np.float64(size_m))
    with atomic_file(path) as temporary:
        temporary.write_bytes(packed.getvalue())


def lighter(
    verts: Float[Tensor, "v 3"], faces: Int[Tensor, "f 3"], max_faces: int = MAX_FACES
) -> tuple[Float[Tensor, "w 3"], Int[Tensor, "g 3"]]:
    """The mesh with ``max_faces`` faces or fewer, to look at: vertices in one cell become one.

    Rossignac and Borrel, "Multi-resolution 3D approximations", 1993; where that one is, as
    Lindstrom has it, so that edges stay sharp. Within the limit it is left untouched; else it need
    not be manifold.
    """
    if len(faces) <= max_faces:
        return verts, faces
    edges = verts[faces] - verts[faces.roll(1, 1)]
    size, kept, cell = 1.2 * float(edges.norm(dim=2).mean()), faces, faces
    while len(kept) > max_faces:  # cells a fifth larger each time, from a fifth over an edge
        kept, cell = _clustered(verts, faces, size)
        size *= 1.2
    return _placed(verts, faces, cell), kept


def _clustered(
    verts: Float[Tensor, "v 3"], faces: Int[Tensor, "f 3"], size: float
) -> tuple[Int[Tensor, "g 3"], Int[Tensor, " v"]]:
    """The faces between the cubes of side ``size`` that hold vertices, and each vertex's cube;
    faces that collapse are removed, and so are those that coincide."""
    cubes = ((verts - verts.amin(0)) / size).long()
    _, cell = torch.unique(_one_number(cubes), return_inverse=True)
    corners = cell[faces]
    # A face with two corners in one cell has become a line.
    corners = corners[(corners != corners.roll(1, 1)).all(1)]
    _, same, times = torch.unique(
        _one_number(corners.sort(1).values), return_inverse=True, return_counts=True
    )
    return corners[times[same] == 1], cell


def _placed(
    verts: Float[Tensor, "v 3"], faces: Int[Tensor, "f 3"], cell: Int[Tensor, " v"]
) -> Float[Tensor, "w 3"]:
    """Where each cell's one vertex is: nearest to the planes of its faces, by their area, and to
    the mean of its vertices where these leave it free. On an edge, that is on the edge.

    Lindstrom, "Out-of-Core Simplification of Large Polygonal Models", 2000.
    """
    cells = int(cell.max()) + 1
    sums = torch.cat([verts, torch.ones_like(verts[:, :1])], 1)
    sums = verts.new_zeros(cells, 4).index_add_(0, cell, sums)
    mean = sums[:, :3] / sums[:, 3:]

    a, b, c = verts[faces].unbind(1)
    n = torch.linalg.cross(b - a, c - a)
    corner, n, on = cell[faces].flatten(), n.repeat_interleave(3, 0), a.repeat_interleave(3, 0)
    d = ((on - mean[corner]) * n).sum(1, keepdim=True)  # around the mean: no large numbers cancel
    planes = torch.cat([(n[:, :, None] * n[:, None]).flatten(1), n * d], 1)
    planes = verts.new_zeros(cells, 12).index_add_(0, corner, planes)
    # The sum of the diagonal is that of all squared areas; tiny: of a cell without a face, too.
    weight = planes[:, (0, 4, 8)].sum(1, keepdim=True) + torch.finfo(verts.dtype).tiny
    A, b = (planes / weight).split([9, 3], 1)
    return mean + torch.linalg.solve(A.unflatten(1, (3, 3)) + FREE * torch.eye(3).to(A), b)


def _one_number(rows: Int[Tensor, "n 3"]) -> Int[Tensor, " n"]:
    """Rows of three numbers below 2^21, none negative, as one number each: quick to sort."""
    return (rows[:, 0] << 42) | (rows[:, 1] << 21) | rows[:, 2]
