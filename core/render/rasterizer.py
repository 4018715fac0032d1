"""From a mesh and cameras to the covered pixels, with gradients.

:func:`core.render.visibility.visibility` finds which face is seen where; everything here is a
smooth function of the vertices at those pixels, and plain torch autograd. What that misses is the
motion of the silhouette, which :mod:`core.render.antialias` adds.
"""

from dataclasses import dataclass
from typing import NamedTuple

import torch
from jaxtyping import Bool, Float, Int
from torch import Tensor
from torch.autograd.function import once_differentiable
from torch.nn.functional import embedding_bag

from core import kernels
from core.ops import places
from core.render.visibility import to_screen, visibility


class Points(NamedTuple):
    """P points on the mesh as weighted means of k vertices; what :func:`interpolate` needs."""

    view: Int[Tensor, " p"]  # the picture each belongs to
    corners: Int[Tensor, "p k"]
    bary: Float[Tensor, "p k"]


@dataclass(frozen=True)
class Fragments:
    """The P covered pixels of B pictures, ordered by picture, row and column."""

    face_id: Int[Tensor, "b h w"]  # -1 where nothing is seen
    depth: Float[Tensor, "b h w"]  # 0 near plane, 1 far plane, inf where nothing; no gradient
    pixel: Int[Tensor, " p"]  # index into the flattened (B, H, W)
    view: Int[Tensor, " p"]
    face: Int[Tensor, " p"]
    corners: Int[Tensor, "p 3"]  # the face's vertices
    bary: Float[Tensor, "p 3"]  # perspective-correct barycentrics, with gradient to the vertices
    clip: Float[Tensor, "b v 4"]  # of every vertex, with gradient
    screen: Float[Tensor, "b v 3"]  # (column, row, depth) in pixels; no gradient
    in_front: Bool[Tensor, "b v"]  # vertices before the near plane: where `screen` has a meaning
    cull: bool  # faces seen from behind were left out

    @property
    def size(self) -> tuple[int, int, int]:
        """B, height, width."""
        b, height, width = self.face_id.shape
        return b, height, width


def rasterize(
    verts: Float[Tensor, "v 3"],
    faces: Int[Tensor, "f 3"],
    mvp: Float[Tensor, "b 4 4"],
    height: int,
    width: int,
    cull: bool = True,
) -> Fragments:
    """Draws the mesh once for each of the B matrices (world to OpenGL clip coordinates).

    ``cull`` drops faces seen from behind: right for closed surfaces only.
    """
    clip = to_clip(verts, mvp)
    # Discrete, so without gradient; all that follows is at these faces.
    face_id = visibility(clip.detach(), faces, height, width, cull)
    pixel, view, face, corners = covered(face_id, faces)
    bary = barycentrics(clip, view, corners, pixel, height, width)

    with torch.no_grad():
        # For the antialias's search, which computes what needs a gradient again from ``clip``.
        in_front = clip[..., 2] + clip[..., 3] > 0
        screen = to_screen(clip, height, width)
        depth = bary.new_full((face_id.numel(),), torch.inf)
        depth.index_copy_(0, pixel, depths(clip, view, corners, bary))
    return Fragments(
        face_id=face_id,
        depth=depth.view_as(face_id),
        pixel=pixel,
        view=view,
        face=face,
        corners=corners,
        bary=bary,
        clip=clip,
        screen=screen,
        in_front=in_front,
        cull=cull,
    )


def to_clip(verts: Float[Tensor, "v 3"], mvp: Float[Tensor, "b 4 4"]) -> Float[Tensor, "b v 4"]:
    """Homogeneous clip coordinates of every vertex in every view."""
    # The fourth coordinate is 1: its column is added, and the vertices are not copied.
    return verts @ mvp[:, :, :3].transpose(1, 2) + mvp[:, None, :, 3]


def covered(face_id: Int[Tensor, "b h w"], faces: Int[Tensor, "f 3"]) -> tuple[Tensor, ...]:
    """The covered pixels' ``pixel``, ``view``, ``face`` and ``corners`` (see Fragments)."""
    if kernels.supports(face_id, faces):
        return kernels.covered(face_id, faces)
    flat = face_id.view(-1)
    (pixel,) = places(flat >= 0)
    face = flat.index_select(0, pixel)
    view = pixel.div(face_id[0].numel(), rounding_mode="floor")
    return pixel, view, face, faces.index_select(0, face)


def pixel_centres(pixel: Int[Tensor, " p"], height: int, width: int) -> Float[Tensor, "p 2"]:
    """Normalised device coordinates (x right, y up, in [-1, 1]) of flat pixel indices."""
    column = pixel % width
    row = pixel.div(width, rounding_mode="floor") % height
    return torch.stack([(2 * column + 1) / width - 1, 1 - (2 * row + 1) / height], -1)


def barycentrics(
    clip: Float[Tensor, "b v 4"],
    view: Int[Tensor, " p"],
    corners: Int[Tensor, "p 3"],
    pixel: Int[Tensor, " p"],
    height: int,
    width: int,
) -> Float[Tensor, "p 3"]:
    """Perspective-correct barycentrics of the rays through the pixels' centres in their faces.

    With (X, Y) = (x, y) - w * centre of each corner in clip space, the ray is where X = Y = 0, and
    a corner's weight is the cross product of the other two. No division by w: holds for faces
    that reach behind the camera (homogeneous rasterization, Olano and Greer 1997).

    A sliver of the size of rounding errors gives its middle without gradient.
    """
    if kernels.supports(clip, corners):
        return kernels.Barycentrics.apply(clip, view, corners, pixel, height, width)
    index = (corners + (view * clip.shape[1])[:, None]).t().contiguous()
    centre = pixel_centres(pixel, height, width)
    return Barycentrics.apply(clip.reshape(-1, 4), index, centre.t().to(clip.dtype)).t()


class Barycentrics(torch.autograd.Function):
    """:func:`barycentrics`, one row for each corner; a third of the time that autograd takes."""

    @staticmethod
    def forward(ctx, clip: Tensor, index: Tensor, centre: Tensor) -> Tensor:
        corner = take(clip, index)
        x = corner[..., 0] - corner[..., 3] * centre[0]
        y = corner[..., 1] - corner[..., 3] * centre[1]
        x1, x2, y1, y2 = x.roll(-1, 0), x.roll(1, 0), y.roll(-1, 0), y.roll(1, 0)
        weight = x1 * y2 - x2 * y1
        total = weight.sum(0)
        # Far enough from the smallest float that 1 / total stays finite.
        usable = total.abs() > torch.finfo(clip.dtype).tiny * 1e4
        bary = weight / torch.where(usable, total, 1)
        # Within a face weights are 0 to 1; up to 2 allows for rounding at its edges.
        sound = usable & (bary.abs().amax(0) < 2)
        bary = torch.where(sound, bary, 1 / 3)
        ctx.save_for_backward(index, centre, x, y, bary, torch.where(sound, 1 / total, 0))
        ctx.shape = clip.shape
        return bary

    @staticmethod
    @once_differentiable
    def backward(ctx, g: Tensor) -> tuple[Tensor, None, None]:
        index, centre, x, y, bary, inverse = ctx.saved_tensors
        # Through the division by the sum: d bary_i / d weight_j = (δ_ij - bary_i) / total.
        g = (g - (g * bary).sum(0)) * inverse  # to the weights
        g1, g2 = g.roll(-1, 0), g.roll(1, 0)
        # Through the cross products: each corner takes part in the two others' weights.
        gx = g2 * y.roll(-1, 0) - g1 * y.roll(1, 0)
        gy = g1 * x.roll(1, 0) - g2 * x.roll(-1, 0)
        # X = x - w * centre, so w gets the centre's part; the clip z has no influence.
        gw = -(gx * centre[0] + gy * centre[1])
        rows = torch.stack([gx, gy, torch.zeros_like(gx), gw], -1).view(-1, 4)
        return g.new_zeros(ctx.shape).index_add_(0, index.view(-1), rows), None, None


def depths(
    clip: Float[Tensor, "b v 4"],
    view: Int[Tensor, " p"],
    corners: Int[Tensor, "p 3"],
    bary: Float[Tensor, "p 3"],
) -> Float[Tensor, " p"]:
    """The points' depth, 0 near plane to 1 far plane: linear in clip coordinates, not in pixels."""
    if kernels.supports(clip, bary):
        return kernels.depths(clip, view, corners, bary)
    index = corners + (view * clip.shape[1])[:, None]
    zw = interpolate(clip[..., 2:].reshape(-1, 2), Points(view, index, bary))
    return zw[:, 0] / zw[:, 1] * 0.5 + 0.5


def take(x: Float[Tensor, "n c"], index: Int[Tensor, "*p"]) -> Float[Tensor, "*p c"]:
    """Rows of ``x``; its backward is an index_add, several times faster than that of indexing."""
    return x.index_select(0, index.reshape(-1)).view(*index.shape, x.shape[1])


def interpolate(
    attributes: "Float[Tensor, 'v c'] | Float[Tensor, 'f 3 c']", points: "Fragments | Points"
) -> Float[Tensor, "p c"]:
    """Attributes of the vertices (V,C), or of the faces' corners (F,3,C), at the covered pixels.

    The vertices' attributes can be had at any :class:`Points`, the corners' at fragments only.
    """
    if isinstance(points, Points) or attributes.ndim == 2:
        return WeightedSum.apply(attributes, points.corners, points.bary)
    corner = attributes.index_select(0, points.face)
    return (corner * points.bary[..., None]).sum(1)


class WeightedSum(torch.autograd.Function):
    """Sums of rows of a table, by index and weight (P,K); half the time that autograd takes."""

    @staticmethod
    def forward(ctx, table: Tensor, index: Tensor, weight: Tensor) -> Tensor:
        ctx.save_for_backward(table, index, weight)
        if kernels.supports(table, weight):
            return kernels.weighted_sum(table, index, weight)
        return embedding_bag(index, table, per_sample_weights=weight.contiguous(), mode="sum")

    @staticmethod
    @once_differentiable
    def backward(ctx, g: Tensor) -> tuple[Tensor | None, None, Tensor | None]:
        table, index, weight = ctx.saved_tensors
        if kernels.supports(table, weight, g):
            return kernels.weighted_sum_backward(g, table, index, weight)
        to_table, to_weight = None, None
        if ctx.needs_input_grad[0]:
            to_table = torch.zeros_like(table)
            for k in range(index.shape[1]):
                to_table.index_add_(0, index[:, k], g * weight[:, k : k + 1])
        if ctx.needs_input_grad[2]:
            one = g.new_ones(g.shape[1], 1)  # a matrix product sums short rows fastest
            parts = [(g * table.index_select(0, k)) @ one for k in index.unbind(1)]
            to_weight = torch.cat(parts, 1)
        return to_table, None, to_weight


def scatter(
    values: Float[Tensor, "p c"],
    fragments: Fragments,
    background: "float | Float[Tensor, '...']" = 0.0,
) -> Float[Tensor, "b h w c"]:
    """Puts the covered pixels' values into a picture over ``background``.

    ``background`` is a number, a colour (C,) or anything that broadcasts to (B,H,W,C). It goes in
    before the antialias, which blends with it.
    """
    shape = (*fragments.size, values.shape[1])
    if not isinstance(background, Tensor):
        background = values.new_full((), background)
    picture = background.to(values).expand(shape).reshape(-1, shape[-1])
    return picture.index_copy(0, fragments.pixel, values).view(shape)
