"""The point of the surface under each texel.

The mesh is drawn into its own texture: uv is the screen. A texel is looked at in a regular grid of
points, so that one on an island's border takes the mean of the part that the island covers, and
none of the background.
"""

from collections.abc import Iterator
from typing import NamedTuple

import torch
from jaxtyping import Float, Int
from torch import Tensor

from core.errors import UserError
from core.geometry.mesh import Mesh, face_areas
from core.render.visibility import visibility

BAND = 1 << 22  # looked-at points at once: bounds the memory at about 400 MB


class Texels(NamedTuple):
    """N points of the surface, ordered by rows of texels."""

    index: Int[Tensor, " n"]  # row * size + column of the texel; row 0 is the top, v = 1
    face: Int[Tensor, " n"]
    bary: Float[Tensor, "n 3"]  # weights of the face's corners


def texel_points(
    uv: Float[Tensor, "u 2"], face_uvs: Int[Tensor, "f 3"], size: int, samples: int = 4
) -> Texels:
    """All points of a texture of ``size`` texels a side, ``samples`` (a square number) a texel."""
    bands = list(texel_bands(uv, face_uvs, size, samples))
    return Texels(*(torch.cat(parts) for parts in zip(*bands, strict=True)))


def texel_bands(
    uv: Float[Tensor, "u 2"], face_uvs: Int[Tensor, "f 3"], size: int, samples: int = 4
) -> Iterator[Texels]:
    """The same as :func:`texel_points`, in bands of whole texel rows from the top down."""
    grid = grid_side(samples)
    rows = max(1, BAND // (size * grid * grid))
    corner_v = uv[:, 1][face_uvs]
    low, high = corner_v.amin(1), corner_v.amax(1)
    for first in range(0, size, rows):
        count = min(rows, size - first)
        top, bottom = 1 - first / size, 1 - (first + count) / size
        # Only the faces that the band can hold are drawn.
        near = ((high >= bottom) & (low <= top)).nonzero().squeeze(1)
        yield _band(uv, face_uvs, near, (first, count, size, grid))


def footprint(mesh: Mesh, size: int) -> float:
    """Side of a texel on the surface, in the mesh's units, in the mean over its faces."""
    uv, face_uvs = mesh.atlas
    a, b, c = uv[face_uvs].unbind(1)
    (p, q), (r, s) = (b - a).unbind(1), (c - a).unbind(1)
    in_texels = float((p * s - q * r).abs().sum()) / 2 * size**2
    return (float(face_areas(mesh.verts, mesh.faces).sum()) / max(in_texels, 1.0)) ** 0.5


def grid_side(samples: int) -> int:
    """Points along one side of a texel."""
    side = round(samples**0.5)
    if side * side != samples or samples < 1:
        raise UserError(f"A texel takes {samples} samples.", "Use a square number: 1, 4, 9 or 16.")
    return side


def _band(
    uv: Float[Tensor, "u 2"],
    face_uvs: Int[Tensor, "f 3"],
    near: Int[Tensor, " m"],
    place: tuple[int, int, int, int],
) -> Texels:
    first, count, size, grid = place
    # The band is the whole screen: y runs from -1 at its lower edge to 1 at its upper one.
    x = uv[:, 0] * 2 - 1
    y = 1 - 2 * ((1 - uv[:, 1]) * size - first) / count
    clip = torch.stack([x, y, torch.zeros_like(x), torch.ones_like(x)], -1)[None]
    seen = visibility(clip, face_uvs[near], count * grid, size * grid, cull=False)
    seen = seen.view(count, grid, size, grid).transpose(1, 2).reshape(-1)  # texel by texel
    point = (seen >= 0).nonzero().squeeze(1)
    face = near[seen[point]]
    texel, within = point // grid**2, point % grid**2
    column = (texel % size) + (within % grid + 0.5) / grid
    row = first + texel // size + (within // grid + 0.5) / grid
    at = torch.stack([column / size, 1 - row / size], -1).to(uv)
    return Texels(first * size + texel, face, barycentric(at, uv[face_uvs[face]]))


def barycentric(at: Float[Tensor, "n 2"], corners: Float[Tensor, "n 3 2"]) -> Float[Tensor, "n 3"]:
    """Weights of the corners of each triangle that give ``at``, held inside the triangle.

    From a corner, so that rounding moves a point by that of ``at`` itself, however small the
    triangle is.
    """
    a, b, c = corners.unbind(1)
    p, q, r = at - a, b - a, c - a
    whole = _cross(q, r)
    # Divided by infinity both weights are 0: an empty triangle gives its first corner.
    safe = torch.where(whole.abs() < 1e-30, torch.inf, whole)
    of_b, of_c = (_cross(p, r) / safe).clamp(0, 1), (_cross(q, p) / safe).clamp(0, 1)
    # Beyond the side opposite of a: back onto it.
    over = (of_b + of_c).clamp(min=1)
    of_b, of_c = of_b / over, of_c / over
    return torch.stack([(1 - of_b - of_c).clamp(min=0), of_b, of_c], -1)


OVERLAP = "Some faces of the UV map overlap, so they share texels."


def uv_faults(uv: Float[Tensor, "u 2"], face_uvs: Int[Tensor, "f 3"], size: int = 512) -> list[str]:
    """The faults of a user's own uv that prevent a texture for every point; [] if none.

    Each fault is a sentence. Overlaps are counted where the islands cover 2 % more than they show.
    """
    faults = []
    a, b, c = uv[face_uvs].double().unbind(1)
    area = _cross(b - a, c - a).abs() / 2
    if bool(((uv < -1e-4) | (uv > 1 + 1e-4)).any()):
        faults.append("Part of the UV map is outside the unit square.")
    if float((area < 1e-12).double().mean()) > 0.02:
        faults.append("More than 2 % of the faces have no area in the UV map.")
    seen = sum(len(band.index) for band in texel_bands(uv, face_uvs, size, 1)) / size**2
    if not faults and float(area.sum()) > 1.02 * seen + 0.002:
        faults.append(OVERLAP)
    return faults


def _cross(p: Float[Tensor, "n 2"], q: Float[Tensor, "n 2"]) -> Float[Tensor, " n"]:
    """Twice the signed area that ``p`` and ``q`` span."""
    return p[:, 0] * q[:, 1] - p[:, 1] * q[:, 0]
