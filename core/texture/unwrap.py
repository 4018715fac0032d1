"""UVs for a mesh that has none (§4.3, "Texturing": "we use xatlas").

Charts by the shape, not by its faces (:mod:`core.texture.charts`), flattened without cutting them
up further (:mod:`core.texture.flatten`), and packed by xatlas (:mod:`core.texture.packing`). Of a
surface of slivers, as the tetrahedra leave it, xatlas's own charts are thousands; these are tens.
"""

from collections.abc import Callable
from typing import NamedTuple

import numpy as np
import torch
from jaxtyping import Bool, Float, Int
from torch import Tensor

from core.errors import UserError
from core.geometry.faces import neighbours
from core.kernels.cells import mark
from core.texture.charts import charts, components, halved
from core.texture.flatten import at_rest, flatten
from core.texture.packing import FEW, charts_of, pack, triangle_areas

MAX_FACES = 500_000
PADDING = 4  # texels round each island, so twice this between: bilinear lookup and two mipmaps
REPAIR_ROUNDS = 4  # of cutting out what cannot be flattened
FOLD_ROUNDS = 8  # more, at most, of cutting charts, if few, that still overlap themselves
SQUASHED = 4.0  # times smaller than on the surface: such a face gets an island of its own
OVERLAP_CELLS = 512  # along a square as large as the surface, in which overlaps are looked for
OVERLAP = 0.004  # of a chart, covered twice: more, and it is cut in two
FILL = 0.6  # of the square: less, and the charts that leave most room are cut in two
CUTS = 4  # times, at most


class Unwrapped(NamedTuple):
    """An atlas. The mesh stays welded: its vertices keep their indices."""

    uv: Float[Tensor, "u 2"]  # in [0, 1], (0, 0) at the bottom left
    face_uvs: Int[Tensor, "f 3"]


FlatCharts = tuple[Float[np.ndarray, "u 2"], Int[np.ndarray, "f 3"], Int[np.ndarray, " f"]]


def unwrap(
    verts: Float[Tensor, "v 3"],
    faces: Int[Tensor, "f 3"],
    size: int,
    progress: Callable[[float], None] = lambda _: None,
    chart: Int[np.ndarray, " f"] | None = None,
) -> Unwrapped:
    """Cut the surface into islands and lay them out for a texture of ``size`` texels a side.

    ``chart``: the chart of each face, where it is known; None: they are found here.
    The same mesh gives the same atlas. ``progress`` is called with the part done, in [0, 1); what
    it raises stops the work.

    Raises UserError: more than MAX_FACES faces, numbers that are not finite, a mesh of so many
    components that the gaps between them fill the texture.
    """
    if len(faces) > MAX_FACES:
        raise UserError(
            f"The mesh has {len(faces):,} faces; the unwrap takes {MAX_FACES:,} at most.",
            "Use a smaller --max-faces, or give the mesh a UV map of its own.",
        )
    if not len(faces) or not bool(torch.isfinite(verts).all()):
        raise UserError(
            "The mesh has no faces, or vertices that are not finite numbers.",
            "Give a mesh that Blender can show.",
        )
    p, f = at_unit_size(verts.detach().cpu().double().numpy()), faces.cpu().long().numpy()
    progress(0.0)
    chart = charts(p, f) if chart is None else chart
    progress(0.2)
    flat = flat_charts(p, f, chart, lambda x: progress(0.2 + 0.4 * x))
    out = pack(*flat, PADDING / size, lambda x: progress(0.6 + 0.2 * x))
    if out is None:
        raise UserError(
            f"The mesh has {int(flat[2].max()) + 1:,} UV islands, and a texture of {size} texels "
            "has no room for so many.",
            "Join its faces (Blender: Mesh > Merge > By Distance), or use a larger texture.",
        )
    out, face_uvs = cut_to_fill(p, f, flat, out, size, lambda x: progress(0.8 + 0.19 * x))
    return Unwrapped(torch.from_numpy(out).to(verts), torch.from_numpy(face_uvs).to(faces))


def cut_to_fill(
    verts: Float[np.ndarray, "v 3"],
    faces: Int[np.ndarray, "f 3"],
    flat: FlatCharts,
    out: Float[np.ndarray, "u 2"],
    size: int,
    progress: Callable[[float], None],
) -> tuple[Float[np.ndarray, "_ 2"], Int[np.ndarray, "f 3"]]:
    """``out``, the packed uv of the charts ``flat``, and its indices; or those that fill more.

    A few charts of awkward outlines leave half of the square empty: halves of them fit better.
    """
    uv, current, chart = flat
    best = out, current
    fill, adjacent = float(triangle_areas(out[current]).sum()), neighbours(faces)
    for cut in range(CUTS):
        progress(cut / CUTS)
        if fill >= FILL or chart.max() >= FEW:
            break
        cut_up = halved(chart, sprawling(uv, current, chart), adjacent, verts[faces].mean(1))
        if cut_up.max() == chart.max():  # single faces: there is nothing to cut
            break
        chart = cut_up
        uv, current, chart = flat_charts(verts, faces, chart, lambda _: None)
        again = pack(uv, current, chart, PADDING / size)
        filled = 0.0 if again is None else float(triangle_areas(again[current]).sum())
        if again is None or filled <= fill:  # more charts have more gaps
            break
        best, fill = (again, current), filled
    return best


def sprawling(
    uv: Float[np.ndarray, "u 2"], face_uvs: Int[np.ndarray, "f 3"], chart: Int[np.ndarray, " f"]
) -> Bool[np.ndarray, " c"]:
    """The charts that leave the most of their boxes empty: all near to the worst."""
    found = charts_of(uv, face_uvs, chart)
    empty = [
        float(one.at.max(0).prod() - triangle_areas(one.at[one.corners]).sum()) for one in found
    ]
    return np.array(empty) > 0.8 * max(empty)


def at_unit_size(verts: Float[np.ndarray, "v 3"]) -> Float[np.ndarray, "v 3"]:
    """The mesh as it is, but one unit across: all bounds here are for that."""
    middle = (verts.max(0) + verts.min(0)) / 2
    return (verts - middle) / max(float(np.ptp(verts, axis=0).max()), 1e-30)


def flat_charts(
    verts: Float[np.ndarray, "v 3"],
    faces: Int[np.ndarray, "f 3"],
    chart: Int[np.ndarray, " f"],
    progress: Callable[[float], None],
) -> FlatCharts:
    """uv, uv indices and charts; charts that cannot be flattened are cut until they can."""
    adjacent, centre = neighbours(faces), verts[faces].mean(1)
    area = triangle_areas(at_rest(verts[faces]))
    rounds = REPAIR_ROUNDS + FOLD_ROUNDS
    for round_ in range(rounds):
        progress(round_ / rounds)
        uv, face_uvs = flatten(verts, faces, chart)
        bad, folded = squashed(uv[face_uvs], area), overlapping(uv, face_uvs, chart)
        # Of a noisy surface all would be cut up in the end, and have no room.
        enough = round_ >= REPAIR_ROUNDS - 1
        bad &= not enough
        # In the last round nothing more is cut: each chart returned has its uv.
        if round_ == rounds - 1 or (enough and chart.max() >= FEW):
            break
        if not (bad.any() or folded.any()):
            break
        # A chart that is squashed as a whole has nothing to be cut out of.
        whole = np.bincount(chart, bad) == np.bincount(chart)
        chart = halved(chart, folded | whole, adjacent, centre)
        # Squashed faces get a number beyond all charts; each connected group is a new chart.
        chart = components(np.where(bad, chart + chart.max() + 1, chart), adjacent)
    return uv, face_uvs, chart


def squashed(
    corners: Float[np.ndarray, "f 3 2"], area: Float[np.ndarray, " f"]
) -> Bool[np.ndarray, " f"]:
    """Faces that are face down, or that lost most of their size."""
    p, q = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    signed = (p[:, 0] * q[:, 1] - p[:, 1] * q[:, 0]) / 2
    return (signed * SQUASHED < area) & (area > 1e-4 * area.mean())


def overlapping(
    uv: Float[np.ndarray, "u 2"], face_uvs: Int[np.ndarray, "f 3"], chart: Int[np.ndarray, " f"]
) -> Bool[np.ndarray, " c"]:
    """Charts that overlap themselves."""
    found = charts_of(uv, face_uvs, chart)
    total = sum(float(triangle_areas(one.at[one.corners]).sum()) for one in found)
    largest = max(float(one.at.max()) for one in found)
    scale = OVERLAP_CELLS / max(np.sqrt(total), largest / 8, 1e-30)  # a wire is all length
    folded = np.zeros(len(found), np.bool_)
    for i, one in enumerate(found):
        at = one.at * scale
        width, height = (int(x) + 1 for x in at.max(0))
        mask = np.zeros((height, width), np.bool_)
        twice = mark(at[one.corners], mask)
        folded[i] = twice > max(2.0, OVERLAP * mask.sum())
    return folded
