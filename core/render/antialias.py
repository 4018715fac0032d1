"""Antialias along silhouette edges: what gives the picture a gradient of the outline.

Every silhouette edge is walked over the lines of pixel centres, rows and columns. Where it crosses
between two neighbouring pixels, one of them under the surface and one beyond it, the two blend by
how far the edge lies from the middle between them. The blend is linear in the crossing, so the
gradient of the picture is that of the area the surface covers.

Two rules make the slope 1:

* **Axis weight.** A slanted edge is met by rows and by columns, and both see its whole motion. Each
  is weighted by the squared component of the edge's normal along its own axis; n_x^2 + n_y^2 = 1.
* **Outermost.** Where folds put several silhouette edges between the same two pixels, only the
  outermost bounds what is seen, and only it blends.

Where two surfaces cut into each other there is no edge, so the line between them is drawn hard and
carries no gradient. A surface of marching tetrahedra never does; a user's mesh may, and its
vertices are not trained.

Comparing neighbouring pixels' triangles instead (as in Laine et al. 2020, "Modular Primitives for
High-Performance Differentiable Rendering", §3.5) loses most of the gradient once the triangles at
the silhouette are foreshortened below a pixel.
"""

from collections.abc import Callable, Sequence
from typing import NamedTuple, TypeVar

import torch
from jaxtyping import Bool, Float, Int
from torch import Tensor

from core import kernels
from core.render.rasterizer import Fragments, Points, take
from core.render.visibility import to_screen

# A silhouette edge may lie this far behind what its outer pixel shows and still bound it: the
# rounding of an interpolated depth.
DEPTH_EPS = 1e-5


Record = TypeVar("Record", bound=tuple)


class EdgeTable(NamedTuple):
    """The E edges of a mesh; one with n > 2 faces counts as ceil(n / 2) edges."""

    verts: Int[Tensor, "e 2"]
    faces: Int[Tensor, "e 2"]  # second -1 on a boundary
    opposite: Int[Tensor, "e 2"]  # each face's third vertex; on a boundary the first one's again


def edge_table(faces: Int[Tensor, "f 3"]) -> EdgeTable:
    """Who shares an edge with whom. Once per mesh."""
    # Half-edge 3 f + k runs from corner k to k + 1 of face f, opposite of corner k + 2.
    verts = torch.stack([faces, faces.roll(-1, 1)], -1).view(-1, 2)
    opposite = faces.roll(-2, 1).reshape(-1)
    count = int(faces.max()) + 1 if len(faces) else 0
    low, high = torch.minimum(*verts.unbind(1)), torch.maximum(*verts.unbind(1))
    # One number for both directions. Stable: the faces of an edge keep their order.
    key, order = (low * count + high).sort(stable=True)
    starts = torch.ones_like(key, dtype=torch.bool)
    starts[1:] = key[1:] != key[:-1]
    index = torch.arange(len(key), device=key.device)
    # The place in a run of equal keys: even ones begin an edge, odd ones are its second face.
    place = index - torch.where(starts, index, 0).cummax(0).values if len(key) else index
    begins = place % 2 == 0
    first = begins.nonzero().squeeze(1)
    paired = (first + 1 < len(key)) & ~begins[(first + 1).clamp(max=max(len(key) - 1, 0))]
    a = order[first]
    b = torch.where(paired, order[torch.where(paired, first + 1, first)], a)
    return EdgeTable(
        verts[a],
        torch.stack([a // 3, torch.where(paired, b // 3, -1)], 1),
        torch.stack([opposite[a], opposite[b]], 1),
    )


def antialias(
    image: Float[Tensor, "b h w c"],
    fragments: Fragments,
    faces: Int[Tensor, "f 3"],
    edges: EdgeTable,
    rim: Callable[[Points], Float[Tensor, "m c"]] | None = None,
) -> Float[Tensor, "b h w c"]:
    """Blends ``image`` across the silhouettes; gradients to the image and to the vertices.

    ``image`` is what :func:`core.render.rasterizer.scatter` made of these ``fragments``, its
    background already in it.

    ``rim`` gives the surface's value on the silhouette itself. With it a pixel changes
    continuously while the edge passes its centre, which the gradient of what varies quickly towards
    the rim (normals) needs: it is up to a fifth too large at 64 x 64 without. ``None`` takes the
    inner pixel's value: enough where only the colours are trained.
    """
    silhouette = silhouettes(fragments, faces, edges)
    # Search without gradient: which pairs of pixels blend.
    found = [crossings(silhouette, fragments, axis) for axis in (0, 1)]
    # The same crossings once more, with gradient to the vertices.
    places, points = zip(*(locate(found[axis], fragments, axis) for axis in (0, 1)), strict=True)
    crossing, points = concatenate(found), concatenate(points)
    place = torch.cat(places)
    reach = torch.where(crossing.inner_is_lower, place, 1 - place)
    grows = reach > 0.5

    # The blend.
    flat = image.reshape(-1, image.shape[-1])
    inner, outer = take(flat, torch.stack([crossing.inner, crossing.outer]))
    if rim is not None:
        inner = torch.where(grows[:, None], rim(points), inner)
    # Nothing changes for an edge midway; the outer pixel gains beyond, the inner one loses.
    # The weight carries no gradient: the area that an edge sweeps does not depend on it.
    amount = ((reach - 0.5) * crossing.weight)[:, None].to(flat.dtype)
    receiver = torch.where(grows, crossing.outer, crossing.inner)
    return flat.index_add(0, receiver, amount * (inner - outer)).view_as(image)


def concatenate(parts: "Sequence[Record]") -> "Record":
    """Named tuples of tensors, one after another."""
    return type(parts[0])(*(torch.cat(field) for field in zip(*parts, strict=True)))


class Silhouette(NamedTuple):
    """S silhouette edges on the screen, without gradient."""

    view: Int[Tensor, " s"]
    index: Int[Tensor, "s 2"]  # their ends, in the flattened (B, V) vertices
    start: Float[Tensor, "s 3"]
    along: Float[Tensor, "s 3"]  # end - start
    side: Float[Tensor, " s"]  # > 0: the surface lies to the left of `along`, in (column, row)


@torch.no_grad()
def silhouettes(fragments: Fragments, faces: Int[Tensor, "f 3"], edges: EdgeTable) -> Silhouette:
    """The edges that bound the surface on the screen: their faces lie on one side of them.

    On a closed surface these are the edges with exactly one face towards the camera.
    """
    if kernels.supports(fragments.screen):
        view, edge, first = kernels.silhouette_edges(
            fragments.screen, fragments.in_front, faces, edges[:2], fragments.cull
        )
    else:
        view, edge, first = silhouette_edges(fragments, faces, edges)
    offset = view * fragments.screen.shape[1]
    inner = torch.where(first, edges.opposite[edge, 0], edges.opposite[edge, 1])
    index = edges.verts[edge] + offset[:, None]
    xyz = fragments.screen.reshape(-1, 3)
    start, end, third = xyz[index[:, 0]], xyz[index[:, 1]], xyz[inner + offset]
    along, across = end - start, third - start
    side = along[:, 0] * across[:, 1] - along[:, 1] * across[:, 0]
    return Silhouette(view, index, start, along, side)


def silhouette_edges(
    fragments: Fragments, faces: Int[Tensor, "f 3"], edges: EdgeTable
) -> tuple[Int[Tensor, " s"], Int[Tensor, " s"], Bool[Tensor, " s"]]:
    """View and edge of the silhouettes, and whether their first face is towards the camera."""
    front = facing(fragments, faces)
    missing = edges.faces[:, 1:] < 0
    first = front.index_select(0, edges.faces[:, 0])
    second = front.index_select(0, edges.faces[:, 1].clamp(min=0))
    # The border of an open surface always bounds it, unless its face is not drawn.
    alone = first if fragments.cull else torch.ones_like(first)
    ends = fragments.in_front.t()
    seen = ends.index_select(0, edges.verts[:, 0]) & ends.index_select(0, edges.verts[:, 1])
    edge, view = (torch.where(missing, alone, first != second) & seen).nonzero(as_tuple=True)
    return view, edge, first[edge, view]


def facing(fragments: Fragments, faces: Int[Tensor, "f 3"]) -> Bool[Tensor, "f b"]:
    """Whether a face is counter-clockwise on the screen (y up)."""
    screen = fragments.screen
    x, y = screen[..., 0].t().contiguous(), screen[..., 1].t().contiguous()
    x0, x1, x2 = (x.index_select(0, i) for i in faces.unbind(1))
    y0, y1, y2 = (y.index_select(0, i) for i in faces.unbind(1))
    return (x1 - x0) * (y2 - y0) < (x2 - x0) * (y1 - y0)


class Crossings(NamedTuple):
    """M pairs of neighbouring pixels with a silhouette edge between their centres."""

    index: Int[Tensor, "m 2"]  # the edge's ends, in the flattened (B, V) vertices
    weight: Float[Tensor, " m"]  # squared normal component along the axis
    line: Int[Tensor, " m"]  # the row or column that is walked
    lower: Int[Tensor, " m"]  # the pair's lower coordinate along the axis
    inner: Int[Tensor, " m"]  # flat index of the pixel on the surface's side
    outer: Int[Tensor, " m"]
    inner_is_lower: Bool[Tensor, " m"]


@torch.no_grad()
def crossings(silhouette: Silhouette, fragments: Fragments, axis: int) -> Crossings:
    """Where silhouettes cross the lines of pixel centres along ``axis`` (0: rows, 1: columns)."""
    _, height, width = fragments.size
    lines, length = (height, width) if axis == 0 else (width, height)
    line_stride, step = (width, 1) if axis == 0 else (1, width)
    start, along = silhouette.start, silhouette.along
    edge, line = lines_met(start[:, 1 - axis], along[:, 1 - axis], lines)

    # Where the edge crosses the line, counted from the first pixel's centre (hence - 0.5).
    s = (line + 0.5 - start[edge, 1 - axis]) / along[edge, 1 - axis]
    place = start[edge, axis] + s * along[edge, axis] - 0.5
    z = start[edge, 2] + s * along[edge, 2]
    # Clamped while a float: a place far outside the picture may not fit an integer.
    lower = place.floor().clamp(-1, length).long()
    inside = (lower >= 0) & (lower + 1 < length)
    lower_pixel = silhouette.view[edge] * (height * width) + line * line_stride
    lower_pixel = lower_pixel + lower.clamp(0, max(length - 2, 0)) * step
    # The surface is at smaller coordinates if the vector across, turned from `along`, points there.
    turn = -along[:, 1] if axis == 0 else along[:, 0]
    inner_is_lower = (silhouette.side * turn < 0)[edge]
    upper_pixel = lower_pixel + (step if length > 1 else 0)
    inner = torch.where(inner_is_lower, lower_pixel, upper_pixel)
    outer = torch.where(inner_is_lower, upper_pixel, lower_pixel)

    # The inner pixel shows the surface, and nothing at the outer one hides the edge.
    depth = fragments.depth.view(-1)
    bounds = inside & (z < depth[outer] + DEPTH_EPS) & torch.isfinite(depth[inner])
    reach = torch.where(inner_is_lower, place - lower, lower + 1 - place)
    # Surfaces on either side of a pair have an outermost edge each, hence the side in the key.
    keep = outermost(reach, lower_pixel * 2 + inner_is_lower, bounds)
    weight = along[:, 1 - axis].square() / along[:, :2].square().sum(1).clamp(min=1e-30)
    return Crossings(
        silhouette.index[edge[keep]],
        weight[edge[keep]],
        line[keep],
        lower[keep],
        inner[keep],
        outer[keep],
        inner_is_lower[keep],
    )


def lines_met(
    start: Float[Tensor, " s"], along: Float[Tensor, " s"], lines: int
) -> tuple[Int[Tensor, " n"], Int[Tensor, " n"]]:
    """All pairs (edge, line) where the edge crosses the line's centre, inside the picture."""
    end = start + along
    # Half open: where two edges meet on a centre, one of them has it.
    low = (torch.minimum(start, end) - 0.5).ceil().clamp(0, lines)
    high = (torch.maximum(start, end) - 0.5).ceil().clamp(0, lines)
    count = (high - low).long()
    edge = torch.repeat_interleave(count)
    # Less the place where the edge's run begins, so that adding the running index counts from low.
    first = (low.long() - (count.cumsum(0) - count))[edge]
    return edge, first + torch.arange(len(edge), device=edge.device)


def outermost(
    reach: Float[Tensor, " n"], pair: Int[Tensor, " n"], valid: Bool[Tensor, " n"]
) -> Int[Tensor, " m"]:
    """Indices of the valid crossings that reach farthest out in their pair; of equals the first."""
    index = valid.nonzero().squeeze(1)
    reach = reach.index_select(0, index)
    pairs, pair = torch.unique(pair.index_select(0, index), return_inverse=True)
    # -1 is below every reach; they are 0 to 1.
    farthest = reach.new_full((len(pairs),), -1.0).scatter_reduce_(0, pair, reach, "amax")
    # len(valid), above every index, marks what is not outermost: the minimum passes it over.
    index = torch.where(reach >= farthest.index_select(0, pair), index, len(valid))
    # Two edges that meet on the line cross it at the same place: count one of them.
    return index.new_full((len(pairs),), len(valid)).scatter_reduce_(0, pair, index, "amin")


def locate(
    crossing: Crossings, fragments: Fragments, axis: int
) -> tuple[Float[Tensor, " m"], Points]:
    """The crossings with gradient: place between the pair's centres (0 to 1), and on the mesh."""
    _, height, width = fragments.size
    clip = take(fragments.clip.reshape(-1, 4), crossing.index)
    screen = to_screen(clip, height, width)
    (x0, x1), (y0, y1) = screen[..., axis].unbind(1), screen[..., 1 - axis].unbind(1)
    s = (crossing.line + 0.5 - y0) / (y1 - y0)
    place = x0 + s * (x1 - x0) - 0.5 - crossing.lower
    # Linear on the screen is linear in 1/w on the mesh.
    share = torch.stack([1 - s, s], 1) / clip[..., 3]
    view = crossing.index[:, 0].div(fragments.clip.shape[1], rounding_mode="floor")
    corners = crossing.index - (view * fragments.clip.shape[1])[:, None]
    return place, Points(view, corners, share / share.sum(1, keepdim=True))
