"""The visible face at each pixel centre: the renderer's one non-differentiable step.

Plain torch, the same on CPU and GPU (the CPU has a compiled version in :mod:`core.kernels`): every
triangle is cut into the rows of pixel centres that it crosses, every row into a span, and the spans
meet in a z-buffer. A span's ends are where the row crosses two of the triangle's edges. Neighbours
compute the crossing of their common edge from the same numbers in the same order, and spans are
half open, so a surface has neither gaps nor pixels hit twice (this is the top-left rule). Nothing
depends on how large a triangle is.
"""

from typing import NamedTuple

import torch
from jaxtyping import Bool, Float, Int
from torch import Tensor

from core import kernels
from core.ops import constant

# Z-buffer entry: depth above, face below; the bits of a float >= 0 sort as the float does.
# EMPTY has the bits of depth 2.0, which is beyond the far plane.
EMPTY = 1 << 62
FACE_BITS = 0xFFFFFFFF
# Bounding-box pixels drawn at once; bounds the memory at about 300 MB.
CHUNK = 1 << 21


class Triangles(NamedTuple):
    """N triangles on the screen."""

    corners: Float[Tensor, "n 3 3"]  # (column, row, depth in [0, 1]) of each corner, pixels
    view: Int[Tensor, " n"]
    face: Int[Tensor, " n"]


def to_screen(clip: Float[Tensor, "*b 4"], height: int, width: int) -> Float[Tensor, "*b 3"]:
    """Clip coordinates to (column, row, depth): pixels, row 0 at the top; depth 0 near, 1 far."""
    inverse_w = 1 / clip[..., 3]
    return torch.stack(
        [
            (clip[..., 0] * inverse_w * 0.5 + 0.5) * width,
            (0.5 - clip[..., 1] * inverse_w * 0.5) * height,
            clip[..., 2] * inverse_w * 0.5 + 0.5,
        ],
        -1,
    )


@torch.no_grad()
def visibility(
    clip: Float[Tensor, "b v 4"],
    faces: Int[Tensor, "f 3"],
    height: int,
    width: int,
    cull: bool = True,
) -> Int[Tensor, "b {height} {width}"]:
    """The nearest face at each pixel centre, -1 where there is none.

    ``clip`` are OpenGL clip coordinates; parts before the near plane (z < -w) are cut away.
    ``cull`` drops faces seen from behind (clockwise on the screen): right for closed surfaces,
    and half the work. At equal depth the face with the smaller index wins.
    """
    b = clip.shape[0]
    if kernels.supports(clip, faces):
        return kernels.visibility(clip, faces, height, width, cull)
    keys = torch.full((b * height * width,), EMPTY, dtype=torch.int64, device=clip.device)
    if len(faces) and b:
        before = clip[..., 2] + clip[..., 3] > 0
        seen = worth_drawing(to_screen(clip, height, width), faces, cull)
        # Both in one question: a GPU is waited for at each.
        behind, count = torch.stack([(~before).sum(), seen.sum()]).tolist()
        # The usual case: nothing to cut, and where faces are culled those are never gathered.
        if behind:
            triangles = clipped(clip, faces, before, (height, width))
        else:
            triangles = gather(to_screen(clip, height, width), faces, seen, count)
        draw(keys, triangles, (height, width), cull)
    face_id = torch.where(keys == EMPTY, -1, keys & FACE_BITS)
    return face_id.view(b, height, width)


def worth_drawing(
    screen: Float[Tensor, "b v 3"], faces: Int[Tensor, "f 3"], cull: bool
) -> Bool[Tensor, "f b"]:
    """Whether a triangle faces us and its bounding box holds a pixel centre, seen or not."""
    # Vertices first: a gathered row then holds all views, which is what makes the gather cheap.
    x, y = screen[..., 0].t().contiguous(), screen[..., 1].t().contiguous()
    x0, x1, x2 = (x.index_select(0, i) for i in faces.unbind(1))
    y0, y1, y2 = (y.index_select(0, i) for i in faces.unbind(1))
    keep = holds_centre(x0, x1, x2) & holds_centre(y0, y1, y2)
    if cull:
        # Rows grow downwards, so counter-clockwise has negative area here. Slivers whose sign is
        # rounding are kept: their spans are empty, or else are needed to close the surface.
        p, q = (x1 - x0) * (y2 - y0), (x2 - x0) * (y1 - y0)
        keep &= p - q <= 4e-7 * (p.abs() + q.abs())
    return keep


def gather(
    screen: Float[Tensor, "b v 3"],
    faces: Int[Tensor, "f 3"],
    keep: Bool[Tensor, "f b"],
    count: int,
) -> Triangles:
    """The ``count`` triangles that are to be kept."""
    face, view = keep.nonzero_static(size=count).unbind(1)
    corner = faces.index_select(0, face) + (view * screen.shape[1])[:, None]
    points = screen.reshape(-1, 3).index_select(0, corner.view(-1))
    return Triangles(points.view(-1, 3, 3), view, face)


def holds_centre(
    a: Float[Tensor, "f b"], b: Float[Tensor, "f b"], c: Float[Tensor, "f b"]
) -> Bool[Tensor, "f b"]:
    """Whether the interval spanned by three coordinates holds a pixel centre (i + 0.5)."""
    low = torch.minimum(torch.minimum(a, b), c)
    high = torch.maximum(torch.maximum(a, b), c)
    return high.sub_(0.5).ceil_() > low.sub_(0.5).ceil_()


def clipped(
    clip: Float[Tensor, "b v 4"],
    faces: Int[Tensor, "f 3"],
    before: Bool[Tensor, "b v"],
    size: tuple[int, int],
) -> Triangles:
    """All triangles, cut at the near plane: one corner before it leaves one, two leave two."""
    count = before[:, faces].sum(-1)
    parts = []
    for seen in (1, 2, 3):
        view, face = (count == seen).nonzero(as_tuple=True)
        corner = faces.index_select(0, face)
        points = clip[view[:, None], corner]
        if seen < 3:
            # Turn the triangle so that the corner on its own side of the plane comes first.
            lone = (before[view[:, None], corner] == (seen == 1)).to(torch.uint8).argmax(1)
            turn = (lone[:, None] + torch.arange(3, device=lone.device)) % 3
            points = points.gather(1, turn[..., None].expand(-1, -1, 4))
        for triangle in cut(points, seen):
            parts.append(Triangles(to_screen(triangle, *size), view, face))
    return Triangles(*(torch.cat(part) for part in zip(*parts, strict=True)))


def cut(points: Float[Tensor, "n 3 4"], seen: int) -> list[Float[Tensor, "n 3 4"]]:
    """Triangles with ``seen`` corners before the near plane; the lone corner comes first."""
    a, b, c = points.unbind(1)
    if seen == 3:
        return [points]
    if seen == 1:
        return [torch.stack([a, on_near_plane(a, b), on_near_plane(a, c)], 1)]
    ab, ac = on_near_plane(b, a), on_near_plane(c, a)
    return [torch.stack([ab, b, c], 1), torch.stack([ab, c, ac], 1)]


def on_near_plane(
    before: Float[Tensor, "n 4"], behind: Float[Tensor, "n 4"]
) -> Float[Tensor, "n 4"]:
    """Where the edge meets z = -w; from the visible end, so that both neighbours get the same."""
    d0, d1 = before[:, 2] + before[:, 3], behind[:, 2] + behind[:, 3]
    return before + (d0 / (d0 - d1))[:, None] * (behind - before)


def draw(keys: Int[Tensor, " p"], triangles: Triangles, size: tuple[int, int], cull: bool) -> None:
    """Writes the nearest of ``triangles`` into the z-buffer, a bounded number at a time."""
    height, width = size
    corners = triangles.corners
    limit = constant((width, height), corners.device, corners.dtype)
    low, high = corners[..., :2].amin(1), corners[..., :2].amax(1)
    start = torch.minimum((low - 0.5).ceil().clamp(min=0), limit)
    extent = torch.minimum((high - 0.5).ceil(), limit) - start
    # NaN and infinite corners are in no picture.
    used = (extent > 0).all(1) & torch.isfinite(corners.sum((1, 2)))
    # What is not used has no rows. Chosen before they are whole numbers: NaN is none.
    first, count = (torch.where(used, x[:, 1], 0).long() for x in (start, extent))
    area = count * torch.where(used, extent[:, 0], 0).long()
    rows = torch.stack([first, count])
    total_rows, total = torch.stack([count, area]).sum(1).tolist()
    if total <= CHUNK:
        draw_spans(keys, triangles, rows, total_rows, size, cull)
        return
    part = area.cumsum(0) // CHUNK
    sizes = torch.unique_consecutive(part, return_counts=True)[1].tolist()
    parts = zip(*(t.split(sizes) for t in triangles), rows.split(sizes, 1), strict=True)
    for *fields, some in parts:
        draw_spans(keys, Triangles(*fields), some, int(some[1].sum()), size, cull)


def draw_spans(
    keys: Int[Tensor, " p"],
    triangles: Triangles,
    rows: Int[Tensor, "2 n"],
    total: int,
    size: tuple[int, int],
    cull: bool,
) -> None:
    """Draws triangles row by row; ``rows`` are the first row and the number of rows of each,
    ``total`` the sum of these numbers."""
    height, width = size
    # The edges: a long one from the top corner to the bottom one, two short ones across from it.
    corners, order = sort_by_row(triangles.corners)
    top, middle, bottom = corners.unbind(1)
    long = edge_rows(top, bottom)
    short = torch.stack([edge_rows(top, middle), edge_rows(middle, bottom)], 1).view(-1, 6)

    # The rows: from here one entry for each row of each triangle.
    triangle, row = repeat_and_count(rows[1], total)
    row = row + rows[0].index_select(0, triangle)
    y = row + 0.5
    below = y >= middle[:, 1].index_select(0, triangle)
    x0, z0 = cross(long.index_select(0, triangle), y)
    x1, z1 = cross(short.index_select(0, 2 * triangle + below), y)
    # Counter-clockwise (in rows that grow downwards): with the corners in an even order the long
    # edge is on the right. From behind it is the other way about, which leaves the span empty.
    swap = order.index_select(0, triangle) if cull else x0 > x1
    x0, x1 = torch.where(swap, x1, x0), torch.where(swap, x0, x1)
    z0, z1 = torch.where(swap, z1, z0), torch.where(swap, z0, z1)
    # Half open: from the first centre at x0 or right of it to the last one left of x1.
    begin = (x0 - 0.5).ceil().clamp(0, width)
    length = ((x1 - 0.5).ceil().clamp(max=width) - begin).clamp(min=0).long()

    z_slope = (z1 - z0) / (x1 - x0).clamp(min=1e-12)
    z_begin = z0 + (begin + 0.5 - x0) * z_slope
    # Within the span's ends: a sliver's slope may be large and rounded.
    depths = torch.stack([z_begin, z_slope, torch.minimum(z0, z1), torch.maximum(z0, z1)], 1)
    pixel = triangles.view.index_select(0, triangle) * height + row
    pixel = pixel * width + begin.long()
    # The pixels: from here one entry for each centre of each span.
    span, step = repeat_and_count(length, int(length.sum()))
    z_begin, z_slope, low, high = depths.index_select(0, span).unbind(1)
    depth = torch.minimum(torch.maximum(z_begin + step * z_slope, low), high).clamp(min=0).float()
    face = triangles.face.index_select(0, triangle).index_select(0, span)
    key = (depth.view(torch.int32).long() << 32) | face
    # The least key is the nearest face, and of equal depths the first: no order of writes matters.
    keys.scatter_reduce_(0, pixel.index_select(0, span) + step, key, "amin")


# By the comparisons of sort_by_row: the corners from the top row down; those in an even order.
ORDERS = ((2, 1, 0), (2, 1, 0), (1, 2, 0), (1, 0, 2), (2, 0, 1), (0, 2, 1), (0, 1, 2), (0, 1, 2))
EVEN = tuple((b - a) % 3 == 1 for a, b, _ in ORDERS)


def sort_by_row(
    corners: Float[Tensor, "n 3 3"],
) -> tuple[Float[Tensor, "n 3 3"], Bool[Tensor, " n"]]:
    """Corners from the top row to the bottom one, and whether their order became even."""
    y0, y1, y2 = corners[..., 1].unbind(1)
    code = 4 * (y0 <= y1).long() + 2 * (y1 <= y2) + (y0 <= y2)
    order = constant(ORDERS, corners.device).index_select(0, code)
    order = order + 3 * torch.arange(len(corners), device=corners.device)[:, None]
    even = constant(EVEN, corners.device).index_select(0, code)
    return corners.view(-1, 3).index_select(0, order.view(-1)).view(-1, 3, 3), even


def edge_rows(upper: Float[Tensor, "n 3"], lower: Float[Tensor, "n 3"]) -> Float[Tensor, "n 6"]:
    """An edge as a function of the row, for :func:`cross`.

    Row, column and depth of its upper end (the smaller row), column of the lower end, slopes of
    column and depth. A level edge crosses no row of centres; its slope is never asked for.
    """
    way = lower - upper
    slope = way / way[:, 1:2].clamp(min=1e-30)
    columns = (upper[:, 1], upper[:, 0], upper[:, 2], lower[:, 0], slope[:, 0], slope[:, 2])
    return torch.stack(columns, 1)


def cross(
    edge: Float[Tensor, "n 6"], y: Float[Tensor, " n"]
) -> tuple[Float[Tensor, " n"], Float[Tensor, " n"]]:
    """Column and depth where the edges cross the rows ``y``."""
    row, x0, z0, x1, x_slope, z_slope = edge.unbind(1)
    t = y - row
    x = torch.minimum(torch.maximum(x0 + t * x_slope, torch.minimum(x0, x1)), torch.maximum(x0, x1))
    return x, z0 + t * z_slope


def repeat_and_count(
    count: Int[Tensor, " n"], total: int
) -> tuple[Int[Tensor, " {total}"], Int[Tensor, " {total}"]]:
    """Each index ``count`` times, and 0, 1, 2, ... within each; ``total`` in all."""
    end = count.cumsum(0)
    index = torch.repeat_interleave(count, output_size=total)
    place = torch.arange(total, device=count.device)
    return index, place - (end - count).index_select(0, index)
