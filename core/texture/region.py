"""Another material on a part of an asset: all other texels stay bit for bit."""

from pathlib import Path
from typing import NamedTuple

import numpy as np
import torch
from jaxtyping import Bool, Float
from scipy.spatial import KDTree
from torch import Tensor

from core.errors import UserError, shown
from core.geometry.mesh import Mesh
from core.io.input_file import check_file, check_size
from core.io.maps import Maps
from core.ops import normalize
from core.texture.padding import nearest_covered, pad
from core.texture.texels import texel_bands

MAX_BYTES = 256 << 20  # of 25 million numbers
POINTS = 8  # along the border, for each width of the feather
MOST = 1 << 20  # of them


class Region(NamedTuple):
    """The kept maps, and where they change."""

    kept: Maps
    faces: Bool[Tensor, " f"]
    fine: Mesh | None = None  # the shape from before the simplification, in the training's cube


def read_faces(path: Path, count: int) -> Bool[Tensor, " f"]:
    """The faces that a text file names, a number a line, 0 the first of ``count``.

    Raises UserError for what is no number or no face, and for a file that names none.
    """
    check_file(path, fix="Check the path of the faces.")
    check_size(path, MAX_BYTES, "Name each face once.")
    fix = "Write one face number per line, in mesh.obj's order, from 0."
    chosen = torch.zeros(count, dtype=torch.bool)
    for word in path.read_bytes().decode("utf-8-sig", "replace").split():
        if not (word.isdecimal() and word.isascii() and len(word) < 12 and int(word) < count):
            raise UserError(f"{path} has {shown(word)}; the mesh has {count} faces.", fix)
        chosen[int(word)] = True
    if not bool(chosen.any()):
        raise UserError(f"{path} names no face.", fix)
    return chosen


def edited(mesh: Mesh, region: Region, new: Maps, feather: float, samples: int = 4) -> Maps:
    """The kept maps, and ``new`` on the region; in between over a border inside of the region.

    ``feather``: width of that border, in the mesh's units.
    """
    size = new.base_color.shape[0]
    weight = region_weight(mesh, region.faces, size, feather, samples)[..., None]

    def between(kept: Tensor, other: Tensor, unit: bool = False) -> Tensor:
        mixed = kept + weight * (other - kept)
        mixed = normalize(mixed) if unit else mixed
        # Not left to arithmetic: outside it is the very same number, inside the new one's.
        return torch.where(weight == 0, kept, torch.where(weight == 1, other, mixed))

    mixed = {}
    for role in Maps._fields:
        kept, other = getattr(region.kept, role), getattr(new, role)
        there = kept if other is None else other
        if there is not None:
            both = (torch.zeros_like(there) if x is None else x for x in (kept, other))
            mixed[role] = between(*both, unit=role == "normal")
    return Maps(**mixed)


@torch.no_grad()
def region_weight(
    mesh: Mesh, faces: Bool[Tensor, " f"], size: int, feather: float, samples: int = 4
) -> Float[Tensor, "s s"]:
    """1 on the texels of ``faces``, falling to 0 at their border and 0 on all others'.

    A texel that any other face also covers is 0, and so is the padding that belongs to others.
    """
    weight = torch.zeros(size * size)
    covered = torch.zeros(size * size, dtype=torch.bool)
    border = _border_points(mesh, faces, feather)
    for texels in texel_bands(*mesh.atlas, size, samples):
        if not len(texels.index):
            continue
        where, slot, count = texels.index.unique_consecutive(
            return_inverse=True, return_counts=True
        )
        covered[where] = True
        inside = torch.zeros(len(where)).index_add_(0, slot, faces[texels.face].float()) == count
        corners = mesh.verts[mesh.faces[texels.face]]
        points = torch.einsum("nk,nkc->nc", texels.bary, corners)
        middle = torch.zeros(len(where), 3).index_add_(0, slot, points) / count[:, None]
        weight[where[inside]] = _rise(middle[inside], border, feather)
    hit = covered.view(size, size)
    return pad(weight.view(size, size, 1), hit, nearest_covered(hit))[..., 0]


def _rise(
    points: Float[Tensor, "n 3"], border: Float[np.ndarray, "b 3"], feather: float
) -> Float[Tensor, " n"]:
    """From 0 at the border to 1 at ``feather`` from it, smoothly; 1 where there is no border."""
    if not len(border) or not feather:
        return torch.ones(len(points))
    distance = torch.from_numpy(KDTree(border).query(points.numpy())[0]).float()
    x = (distance / feather).clamp(0, 1)
    return x * x * (3 - 2 * x)


def _border_points(
    mesh: Mesh, faces: Bool[Tensor, " f"], feather: float
) -> Float[np.ndarray, "b 3"]:
    """Points on the edges between a face of the region and another one."""
    corners, inside = mesh.faces.numpy(), faces.numpy()
    edges = np.stack([corners, np.roll(corners, -1, 1)], -1).reshape(-1, 2)
    edges.sort(1)
    unique, of_edge = np.unique(edges, axis=0, return_inverse=True)
    of_edge = of_edge.reshape(-1)
    uses = np.bincount(of_edge)
    chosen = np.bincount(of_edge, weights=np.repeat(inside, 3))
    ends = mesh.verts.double().numpy()[unique[(chosen > 0) & (chosen < uses)]]
    if not len(ends) or not feather:
        return np.zeros((0, 3))
    lengths = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)
    steps = np.clip(np.ceil(POINTS * lengths / feather), 1, MOST // len(ends) + 1).astype(int)
    edge = np.repeat(np.arange(len(ends)), steps + 1)
    first = np.repeat(np.cumsum(steps + 1) - (steps + 1), steps + 1)
    t = ((np.arange(len(edge)) - first) / steps[edge])[:, None]
    return ends[edge, 0] * (1 - t) + ends[edge, 1] * t
