"""Antialias along silhouette edges: what gives the picture a gradient of the outline.

Every silhouette edge is walked over the lines of pixel centres, rows and columns. Where it crosses
between two neighbouring pixels, one of them under the surface and one beyond it, the two blend by
how far the edge is from the middle between them. The blend is linear in the crossing, so the
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

from collections.abc import Callable
from typing import NamedTuple

import torch
from jaxtyping import Bool, Float, Int
from torch import Tensor

from core import kernels
from core.ops import places
from core.render.rasterizer import Fragments, Points, take
from core.render.visibility import repeat_and_count, to_screen

# A silhouette edge may be this far behind what its outer pixel shows and still bound it: the
# rounding of an interpolated depth.
DEPTH_EPS = 1e-5


class EdgeTable(NamedTuple):
    """The E edges of a mesh; one with n > 2 faces counts as ceil(n / 2) edges."""

    verts: Int[Tensor, "e 2"]
    faces: Int[Tensor, "e 2"]  # second -1 on a boundary
    opposite: Int[Tensor, "e 2"]  # each face's third vertex; on a boundary the first one's again


def edge_table(faces: Int[Tensor, "f 3"]) -> EdgeTable:
    """The edges of a mesh and their faces. Once per mesh."""
    # Half-edge 3 f + k runs from corner k to k + 1 of face f, opposite of corner k + 2.
    verts = torch.stack([faces, faces.roll(-1, 1)], -1).view(-1, 2)
    opposite = faces.roll(-2, 1).reshape(-1)
    low, high = torch.minimum(*verts.unbind(1)), torch.maximum(*verts.unbind(1))
    # One number for both directions. Stable: the faces of an edge keep their order.
    key, order = ((low << 32) | high).sort(stable=True)
    starts = torch.ones_like(key, dtype=torch.bool)
    starts[1:] = key[1:] != key[:-1]
    index = torch.arange(len(key), device=key.device)
    # The place in a run of equal keys: even ones begin an edge, odd ones are its second face.
    place = index - torch.where(starts, index, 0).cummax(0).values if len(key) else index
    begins = place % 2 == 0
    (first,) = places(begins)
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
    crossing = crossings(silhouette, fragments)
    # The same crossings once more, with gradient to the vertices.
    place, points = locate(crossing, fragments)
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


class Silhouette(NamedTuple):
    """S silhouette edges on the screen, without gradient."""

    view: Int[Tensor, " s"]
    index: Int[Tensor, "s 2"]  # their ends, in the flattened (B, V) vertices
    start: Float[Tensor, "s 3"]
    along: Float[Tensor, "s 3"]  # end - start
    side: Float[Tensor, " s"]  # > 0: the surface is to the left of `along`, in (column, row)


@torch.no_grad()
def silhouettes(fragments: Fragments, faces: Int[Tensor, "f 3"], edges: EdgeTable) -> Silhouette:
    """The edges that bound the surface on the screen: their faces are on one side of them.

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
    (flat,) = places((torch.where(missing, alone, first != second) & seen).view(-1))
    view, edge = flat % first.shape[1], flat.div(first.shape[1], rounding_mode="floor")
    return view, edge, first.reshape(-1)[flat]


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
    column: Bool[Tensor, " m"]  # the pair is of one column; else of one row
    line: Int[Tensor, " m"]  # that row or column
    lower: Int[Tensor, " m"]  # the pair's lower coordinate along it
    inner: Int[Tensor, " m"]  # flat index of the pixel on the surface's side
    outer: Int[Tensor, " m"]
    inner_is_lower: Bool[Tensor, " m"]


@torch.no_grad()
def crossings(silhouette: Silhouette, fragments: Fragments) -> Crossings:
    """Where silhouettes cross the lines of pixel centres: the rows, then the columns."""
    _, height, width = fragments.size
    # Columns are the rows of the picture mirrored in its diagonal, which turns left into right.
    start, along = (
        torch.cat([x, torch.stack([x[:, 1], x[:, 0], x[:, 2]], 1)])
        for x in (silhouette.start, silhouette.along)
    )
    side = torch.cat([silhouette.side, -silhouette.side])
    view, index = (torch.cat([x, x]) for x in (silhouette.view, silhouette.index))
    mirrored = torch.arange(len(start), device=start.device) >= len(silhouette.view)
    lines = torch.where(mirrored, width, height)
    edge, line = lines_met(start[:, 1], along[:, 1], lines)
    column = mirrored[edge]
    length = torch.where(column, height, width)
    line_stride, step = torch.where(column, 1, width), torch.where(column, width, 1)

    # Where the edge crosses the line, counted from the first pixel's centre (hence - 0.5).
    s = (line + 0.5 - start[edge, 1]) / along[edge, 1]
    place = start[edge, 0] + s * along[edge, 0] - 0.5
    z = start[edge, 2] + s * along[edge, 2]
    # Clamped while a float: a place far outside the picture may not fit an integer.
    lower = place.floor().clamp(-1, max(height, width)).long()
    inside = (lower >= 0) & (lower + 1 < length)
    lower_pixel = view[edge] * (height * width) + line * line_stride
    # A place outside counts nowhere; it only has to name some pixel.
    lower_pixel = lower_pixel + torch.where(inside, lower, 0) * step
    upper_pixel = lower_pixel + torch.where(inside, step, 0)
    # The surface is at smaller coordinates if the vector across, turned from `along`, points there.
    inner_is_lower = (side * along[:, 1] > 0)[edge]
    inner = torch.where(inner_is_lower, lower_pixel, upper_pixel)
    outer = torch.where(inner_is_lower, upper_pixel, lower_pixel)

    # The inner pixel shows the surface, and nothing at the outer one hides the edge.
    depth = fragments.depth.view(-1)
    bounds = inside & (z < depth[outer] + DEPTH_EPS) & torch.isfinite(depth[inner])
    reach = torch.where(inner_is_lower, place - lower, lower + 1 - place)
    # Surfaces on either side of a pair have an outermost edge each, hence the side in the key.
    pair = (column * depth.numel() + lower_pixel) * 2 + inner_is_lower
    keep = outermost(reach, pair, bounds)
    weight = along[:, 1].square() / along[:, :2].square().sum(1).clamp(min=1e-30)
    return Crossings(
        index[edge[keep]],
        weight[edge[keep]],
        column[keep],
        line[keep],
        lower[keep],
        inner[keep],
        outer[keep],
        inner_is_lower[keep],
    )


def lines_met(
    start: Float[Tensor, " s"], along: Float[Tensor, " s"], lines: Int[Tensor, " s"]
) -> tuple[Int[Tensor, " n"], Int[Tensor, " n"]]:
    """All pairs (edge, line) where the edge crosses the line's centre, inside the picture.

    ``lines``: how many there are along each edge's axis.
    """
    end = start + along
    # Half open: where two edges meet on a centre, one of them has it.
    low, high = ((f(start, end) - 0.5).ceil() for f in (torch.minimum, torch.maximum))
    low, high = (torch.minimum(x.clamp(min=0), lines.to(x)).long() for x in (low, high))
    count = high - low
    edge, place = repeat_and_count(count, int(count.sum()))
    return edge, low[edge] + place


def outermost(
    reach: Float[Tensor, " n"], pair: Int[Tensor, " n"], valid: Bool[Tensor, " n"]
) -> Int[Tensor, " m"]:
    """Indices of the valid crossings that reach farthest out in their pair; of equals the first.

    Two edges that meet on the line cross it at the same place: one of them counts.
    """
    # The farthest of each pair first; those that are not valid, and may be NaN, last.
    order = torch.where(valid, reach, -1).sort(descending=True, stable=True).indices
    pair, again = pair[order].sort(stable=True)
    order = order[again]
    first = torch.ones_like(pair, dtype=torch.bool)
    first[1:] = pair[1:] != pair[:-1]
    (found,) = places(first & valid[order])
    return order[found]


def locate(crossing: Crossings, fragments: Fragments) -> tuple[Float[Tensor, " m"], Points]:
    """The crossings with gradient: place between the pair's centres (0 to 1), and on the mesh."""
    _, height, width = fragments.size
    clip = take(fragments.clip.reshape(-1, 4), crossing.index)
    column, row, _ = to_screen(clip, height, width).unbind(-1)
    (x0, x1), (y0, y1) = (
        torch.where(crossing.column[:, None], a, b).unbind(1)
        for a, b in ((row, column), (column, row))
    )
    s = (crossing.line + 0.5 - y0) / (y1 - y0)
    place = x0 + s * (x1 - x0) - 0.5 - crossing.lower
    # Linear on the screen is linear in 1/w on the mesh.
    weight = torch.stack([1 - s, s], 1) / clip[..., 3]
    view = crossing.index[:, 0].div(fragments.clip.shape[1], rounding_mode="floor")
    corners = crossing.index - (view * fragments.clip.shape[1])[:, None]
    return place, Points(view, corners, weight / weight.sum(1, keepdim=True))
