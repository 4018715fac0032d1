"""Tangents as MikkTSpace makes them, so that a normal map means the same everywhere.

M. S. Mikkelsen, "Simulation of Wrinkled Surfaces Revisited", 2008, and the notes that come with
his mikktspace library, which Blender, glTF and the game engines follow. Corners of equal position,
normal and uv are one; about such a vertex the faces joined by shared edges and of one uv
orientation make a group, and a group has one tangent: the mean, weighted by the angle at the
vertex, of its faces' uv derivatives, each projected onto the normal's plane.
"""

from typing import NamedTuple

import numpy as np
import torch
from jaxtyping import Float, Int
from scipy.sparse import coo_array
from scipy.sparse.csgraph import connected_components
from torch import Tensor

from core.geometry.faces import areas_and_normals, unit
from core.geometry.mesh import Mesh

TINY = 1.1754944e-38  # the smallest normal float: MikkTSpace takes what is below it for zero


@torch.no_grad()
def corner_tangents(mesh: Mesh, normals: Float[Tensor, "f 3 3"]) -> Float[Tensor, "f 3 4"]:
    """Tangent (xyz, unit, across the corner's normal) and sign w of the bitangent at each corner.

    bitangent = w * cross(normal, tangent); w is -1 where the uv are mirrored. ``normals`` are the
    corners' at unit length. Made in double precision on the CPU, without gradient.
    """
    uv, face_uvs = mesh.atlas
    f, fu = mesh.faces.cpu().numpy(), face_uvs.cpu().numpy()
    p, n, t = (x.detach().cpu().double().numpy() for x in (mesh.verts, normals, uv))
    welded = _weld(np.concatenate([p[f], n], 2), t[fu])
    along, mirrored, flat = _uv_derivative(p[f], t[fu])
    group = _groups(welded, mirrored, flat)
    group = _adopt(group, welded, flat)
    tangent = _group_tangents(group, p[f], n, along)
    sign = np.where(mirrored, -1.0, 1.0)[:, None, None].repeat(3, 1)
    return torch.from_numpy(np.concatenate([tangent, sign], 2)).to(mesh.verts)


class Normals(NamedTuple):
    """The normals that a mesh is shaded with; tangents and normal maps are relative to these."""

    each: Float[Tensor, "n 3"]  # unit
    index: Int[Tensor, "f 3"]  # of each corner's

    @property
    def corners(self) -> Float[Tensor, "f 3 3"]:
        """Each corner's own."""
        return self.each[self.index]


@torch.no_grad()
def shading_normals(mesh: Mesh) -> Normals:
    """A normal for each vertex, as :func:`smooth_normals`; of a flat mesh one for each face.

    A face without an area takes its direction from the origin.
    """
    if not mesh.flat:
        return Normals(smooth_normals(mesh.verts, mesh.faces), mesh.faces)
    points, faces = mesh.verts.detach().cpu().double().numpy(), mesh.faces.cpu().numpy()
    _, each = areas_and_normals(points, faces)
    lost = ~each.any(1)
    each[lost] = unit(points[faces[lost]].mean(1))
    index = torch.arange(len(faces)).to(mesh.faces)[:, None].expand(-1, 3)
    return Normals(torch.from_numpy(each).to(mesh.verts), index)


@torch.no_grad()
def smooth_normals(verts: Float[Tensor, "v 3"], faces: Int[Tensor, "f 3"]) -> Float[Tensor, "v 3"]:
    """Unit vertex normals as Blender's smooth shading has them: face normals weighted by angle.

    (G. Thürmer and C. A. Wüthrich, "Computing Vertex Normals from Polygonal Facets", 1998.)
    A vertex of no face, or whose faces cancel,
    takes its direction from the origin, as in Blender. Without gradient.
    """
    p = verts.detach().double()[faces]
    ahead, back = p.roll(-1, 1) - p, p.roll(1, 1) - p
    normal = torch.nn.functional.normalize(torch.linalg.cross(ahead[:, 0], back[:, 0]), dim=-1)
    unit = [torch.nn.functional.normalize(edge, dim=-1) for edge in (ahead, back)]
    angle = (unit[0] * unit[1]).sum(-1).clamp(-1, 1).arccos()
    parts = (angle[..., None] * normal[:, None]).reshape(-1, 3)
    total = torch.zeros_like(verts, dtype=torch.float64).index_add_(0, faces.reshape(-1), parts)
    lost = total.norm(dim=1, keepdim=True) < 1e-12
    total = torch.where(lost, verts.double(), total)
    return torch.nn.functional.normalize(total, dim=-1).to(verts)


def _weld(points: Float[np.ndarray, "f 3 6"], uv: Float[np.ndarray, "f 3 2"]) -> np.ndarray:
    """One number per corner (F,3), equal where position, normal and uv are equal."""
    # In float32, as MikkTSpace compares; adding 0 turns -0, whose bits differ, into +0.
    rows = np.concatenate([points, uv], 2).reshape(-1, 8).astype(np.float32) + np.float32(0)
    # Eight floats as one value of 32 bytes, so that unique compares whole rows.
    bits = np.ascontiguousarray(rows).view(np.dtype((np.void, rows.dtype.itemsize * 8)))
    return np.unique(bits, return_inverse=True)[1].reshape(-1, 3)


def _uv_derivative(
    p: Float[np.ndarray, "f 3 3"], t: Float[np.ndarray, "f 3 2"]
) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Unit direction (F,3) in which u grows on each face; where uv are mirrored; where it is lost.

    p(u, v) is linear on the face: dp/du ∝ sign(area) (t_31.v e_21 - t_21.v e_31).
    """
    e21, e31 = p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]
    t21, t31 = t[:, 1] - t[:, 0], t[:, 2] - t[:, 0]
    area = t21[:, 0] * t31[:, 1] - t21[:, 1] * t31[:, 0]
    mirrored = area < 0
    u = t31[:, 1:] * e21 - t21[:, 1:] * e31
    v = t21[:, :1] * e31 - t31[:, :1] * e21
    flat = (np.abs(area) <= TINY) | (_length(u) <= TINY)[:, 0] | (_length(v) <= TINY)[:, 0]
    along = _unit(u) * np.where(mirrored, -1.0, 1.0)[:, None]
    along[flat] = 0
    return along, mirrored & (np.abs(area) > TINY), flat


def _groups(welded: np.ndarray, mirrored: np.ndarray, flat: np.ndarray) -> np.ndarray:
    """The group of each corner (F,3): fans of faces of one orientation, joined across edges."""
    count, size = len(welded), int(welded.max(initial=0)) + 1
    start, end = welded.reshape(-1), np.roll(welded, -1, 1).reshape(-1)
    # Edge k of a face runs from corner k to k + 1; its partner runs the other way.
    forth, back = start * size + end, end * size + start
    order = np.argsort(forth, kind="stable")
    # Clipped: past the last key there is no partner, and ``joined`` drops what was found instead.
    slot = np.searchsorted(forth, back, sorter=order).clip(max=3 * count - 1)
    here, there = np.arange(3 * count), order[slot]
    face_a, face_b = here // 3, there // 3
    joined = (forth[there] == back) & (mirrored[face_a] == mirrored[face_b])
    joined &= ~flat[face_a] & ~flat[face_b]
    here, there = here[joined], there[joined]
    # The start of one edge is the end of the other: corner k meets corner k' + 1, and so on.
    links = np.concatenate([here, _next(here)]), np.concatenate([_next(there), there])
    graph = coo_array((np.ones(len(links[0]), bool), links), shape=(3 * count, 3 * count))
    return connected_components(graph, directed=False)[1].reshape(-1, 3)


def _next(corner: np.ndarray) -> np.ndarray:
    """The corner after ``corner`` in its face; corners are numbered 3 f + k."""
    return corner - corner % 3 + (corner % 3 + 1) % 3


def _adopt(group: np.ndarray, welded: np.ndarray, flat: np.ndarray) -> np.ndarray:
    """A face without uv derivative takes part in the first group at each of its vertices."""
    if not flat.any():
        return group
    first = np.full(int(welded.max()) + 1, -1)
    # Backwards: of several writes to one place the last stays, which is the first group.
    first[welded[~flat][::-1].reshape(-1)] = group[~flat][::-1].reshape(-1)
    found = first[welded]
    return np.where(flat[:, None] & (found >= 0), found, group)


def _group_tangents(
    group: np.ndarray,
    p: Float[np.ndarray, "f 3 3"],
    n: Float[np.ndarray, "f 3 3"],
    along: Float[np.ndarray, "f 3"],
) -> Float[np.ndarray, "f 3 3"]:
    """The angle-weighted mean of the projected derivatives, over each corner's group."""
    # Angles between the edges projected onto the normal's plane, not between the edges.
    before = _unit(_across(np.roll(p, 1, 1) - p, n))
    after = _unit(_across(np.roll(p, -1, 1) - p, n))
    angle = np.arccos((before * after).sum(-1, keepdims=True).clip(-1, 1))
    part = angle * _unit(_across(np.broadcast_to(along[:, None], p.shape), n))
    labels, count = group.reshape(-1), int(group.max(initial=-1)) + 1
    total = np.stack(
        [np.bincount(labels, part[..., k].reshape(-1), minlength=count) for k in range(3)], -1
    )[group]
    lost = _length(total) <= 1e-12
    return _unit(np.where(lost, _any_across(n), total))


def _across(x: np.ndarray, n: np.ndarray) -> np.ndarray:
    """``x`` without its part along the unit vector ``n``."""
    return x - n * (x * n).sum(-1, keepdims=True)


def _any_across(n: np.ndarray) -> np.ndarray:
    """Some vector across ``n``: of the x axis, or of y where n is near x."""
    x = np.where(np.abs(n[..., :1]) < 0.9, [1.0, 0.0, 0.0], [0.0, 1.0, 0.0])
    return _across(x, n)


def _length(x: np.ndarray) -> np.ndarray:
    return np.sqrt((x * x).sum(-1, keepdims=True))


def _unit(x: np.ndarray) -> np.ndarray:
    """``x`` at unit length; zero stays zero."""
    length = _length(x)
    return x / np.where(length > TINY, length, 1)
