"""From a mesh and cameras to the covered pixels, with gradients.

:func:`core.render.visibility.visibility` says which face is seen where; everything here is a
smooth function of the vertices at those pixels, and plain torch autograd. What that misses is the
motion of the silhouette, which :mod:`core.render.antialias` adds.
"""

from dataclasses import dataclass
from typing import NamedTuple

import torch
from jaxtyping import Bool, Float, Int
from torch import Tensor

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
    screen: Float[Tensor, "b v 3"]  # (column, row, depth) in pixels, with gradient
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
    face_id = visibility(clip.detach(), faces, height, width, cull)
    flat = face_id.view(-1)
    pixel = (flat >= 0).nonzero().squeeze(1)
    face = flat.index_select(0, pixel)
    view = pixel.div(height * width, rounding_mode="floor")
    corners = faces.index_select(0, face)
    bary = barycentrics(clip, view, corners, pixel_centres(pixel, height, width))

    in_front = clip[..., 2] + clip[..., 3] > 0
    # Behind the near plane the division has no meaning, and near w = 0 its gradient no bound.
    safe = torch.where(in_front[..., None], clip, clip.new_tensor([0.0, 0.0, 0.0, 1.0]))
    screen = to_screen(safe, height, width)
    with torch.no_grad():
        # The picture's depth is linear in clip coordinates, not on the screen.
        zw = take(clip[..., 2:].reshape(-1, 2), corners + (view * len(verts))[:, None])
        zw = (zw * bary[..., None]).sum(1)
        depth = bary.new_full((flat.shape[0],), torch.inf)
        depth[pixel] = zw[:, 0] / zw[:, 1] * 0.5 + 0.5
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
    return verts @ mvp[:, :, :3].transpose(1, 2) + mvp[:, None, :, 3]


def pixel_centres(pixel: Int[Tensor, " p"], height: int, width: int) -> Float[Tensor, "p 2"]:
    """Normalised device coordinates (x right, y up, in [-1, 1]) of flat pixel indices."""
    column = pixel % width
    row = pixel.div(width, rounding_mode="floor") % height
    return torch.stack([(2 * column + 1) / width - 1, 1 - (2 * row + 1) / height], -1)


def barycentrics(
    clip: Float[Tensor, "b v 4"],
    view: Int[Tensor, " p"],
    corners: Int[Tensor, "p 3"],
    centre: Float[Tensor, "p 2"],
) -> Float[Tensor, "p 3"]:
    """Perspective-correct barycentrics of the rays through ``centre`` in their faces.

    With (X, Y) = (x, y) - w * centre of each corner in clip space, the ray is where X = Y = 0, and
    a corner's weight is the cross product of the other two. No division by w: holds for faces
    that reach behind the camera (homogeneous rasterization, Olano and Greer 1997).
    """
    b, v, _ = clip.shape
    xyw = clip[..., [0, 1, 3]].reshape(b * v, 3)
    corner = take(xyw, corners + (view * v)[:, None])
    x, y = (corner[..., :2] - corner[..., 2:] * centre[:, None].to(clip.dtype)).unbind(-1)
    weight = x.roll(-1, 1) * y.roll(-2, 1) - x.roll(-2, 1) * y.roll(-1, 1)
    total = weight.sum(1, keepdim=True)
    usable = total.abs() > torch.finfo(clip.dtype).tiny * 1e4
    bary = weight / torch.where(usable, total, 1)
    # Of a sliver only rounding is left; keep the point in the face.
    sound = usable & (bary.detach().abs() < 2).all(1, keepdim=True)
    return torch.where(sound, bary, 1 / 3)


def take(x: Float[Tensor, "n c"], index: Int[Tensor, "*p"]) -> Float[Tensor, "*p c"]:
    """Rows of ``x``; its backward is an index_add, several times faster than that of indexing."""
    return x.index_select(0, index.reshape(-1)).view(*index.shape, x.shape[1])


def interpolate(
    attributes: "Float[Tensor, 'v c'] | Float[Tensor, 'f 3 c']", points: "Fragments | Points"
) -> Float[Tensor, "p c"]:
    """Attributes of the vertices (V,C), or of the faces' corners (F,3,C), at the covered pixels.

    The vertices' attributes can be had at any :class:`Points`, the corners' at fragments only.
    """
    if attributes.ndim == 2:
        corner = take(attributes, points.corners)
    else:
        corner = attributes.index_select(0, points.face)
    return (corner * points.bary[..., None]).sum(1)


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
    background = torch.as_tensor(background, dtype=values.dtype, device=values.device)
    picture = background.expand(shape).reshape(-1, shape[-1])
    return picture.index_copy(0, fragments.pixel, values).view(shape)
