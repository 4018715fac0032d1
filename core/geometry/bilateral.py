"""Bilateral filtering of a mesh's normals: planes get flat, and the edges between them stay.

Faces take the mean normal of the faces around them, near and similar ones most (Zheng, Fu, Au and
Tai 2011, "Bilateral Normal Filtering for Mesh Denoising", Eq. 4, the local scheme):

    n_i <- K_i Σ_j a_j W_c(|c_i - c_j|) W_s(|n_i - n_j|) n_j,   W(x) = exp(-x² / 2σ²)

then the vertices move until the faces agree with their new normals (Sun et al. 2007, Eq. 9):

    v <- v + 1 / |F(v)| Σ_{j in F(v)} n_j (n_j · (c_j - v))

a, c and n are a face's area, centre and unit normal, F(v) the faces around a vertex.
"""

from dataclasses import dataclass

import numpy as np
import torch
from jaxtyping import Float, Int
from scipy.sparse import csr_array
from torch import Tensor

from core.geometry.faces import areas_and_normals
from core.kernels.normals import filtered_once, towards

NORMAL_ROUNDS = 10  # of the normals, in one round of the filter
VERTEX_ROUNDS = 15  # of the vertices after them
FOLLOWING_NORMAL_ROUNDS = 3  # of normals that come from elsewhere: less noisy than a mesh's own
FOLLOWING_VERTEX_ROUNDS = 20
REACH = 2.0  # σ_c, of the mean distance between the centres of faces that touch
UNDO_ROUNDS = 4  # enough: the vertices put back are in small groups
LEAST_AREA = 1e-3  # of the mean face's; a smaller one that was larger before is put back

Verts = Float[np.ndarray, "v 3"]
Normals = Float[np.ndarray, "f 3"]
Faces = Int[np.ndarray, "f 3"]


def flattened(
    verts: Float[Tensor, "v 3"], faces: Int[Tensor, "f 3"], rounds: int, sigma: float
) -> Float[Tensor, "v 3"]:
    """Vertices after ``rounds`` of the filter; faces that it would turn over stay as they were.

    ``sigma``: σ_s, the difference at which unit normals count as similar; larger ones melt edges
    and make round legs square.
    """
    if rounds == 0:
        return verts
    v, f = verts.detach().cpu().double().numpy(), faces.cpu().numpy()
    moved, around = v, Around.of(f, len(v))
    for _ in range(rounds):
        # Two phases: new normals from the present shape, then vertices that follow them.
        normals = filtered(moved, around, sigma)
        for _ in range(VERTEX_ROUNDS):
            moved = towards(moved, around.faces, normals, around.count)
    return torch.from_numpy(_sound(v, moved, f)).to(verts)


def following(
    verts: Float[Tensor, "v 3"],
    faces: Int[Tensor, "f 3"],
    normals: Float[Tensor, "f 3"],
    trust: Float[Tensor, " f"],
    sigma: float,
) -> Float[Tensor, "v 3"]:
    """Vertices moved until their faces have the unit ``normals``, filtered as in ``flattened``.

    ``trust``: in [0, 1], of each face's normal; where it is 0 the face's own counts.
    """
    v, f = verts.detach().cpu().double().numpy(), faces.cpu().numpy()
    around = Around.of(f, len(v))
    fraction, wanted = trust.cpu().double().numpy()[:, None], normals.cpu().double().numpy()
    mixed = fraction * wanted + (1 - fraction) * areas_and_normals(v, f)[1]
    mixed /= np.maximum(np.linalg.norm(mixed, axis=1, keepdims=True), 1e-20)
    target = filtered(v, around, sigma, mixed, FOLLOWING_NORMAL_ROUNDS)
    moved = v
    for _ in range(FOLLOWING_VERTEX_ROUNDS):
        moved = towards(moved, around.faces, target, around.count)
    return torch.from_numpy(_sound(v, moved, f)).to(verts)


def without_folds(
    before: Float[Tensor, "v 3"], after: Float[Tensor, "v 3"], faces: Int[Tensor, "f 3"]
) -> Float[Tensor, "v 3"]:
    """``after``, but around faces that have turned over or lost their area as it was before."""
    parts = (before.detach().cpu().double().numpy(), after.detach().cpu().double().numpy())
    return torch.from_numpy(_sound(*parts, faces.cpu().numpy())).to(before)


@dataclass(frozen=True)
class Around:
    """Faces and their neighbours."""

    faces: Faces
    one: Int[np.ndarray, " p"]  # pairs of faces that share a vertex, each in both orders,
    other: Int[np.ndarray, " p"]  # sorted by ``one``
    start: Int[np.ndarray, " f1"]  # of each face's pairs
    count: Float[np.ndarray, " v"]  # faces at a vertex, 1 where there are none

    @classmethod
    def of(cls, faces: Faces, vert_count: int) -> "Around":
        """The tables of a mesh."""
        at, size = faces.reshape(-1), 3 * len(faces)
        inside = csr_array((np.ones(size), (at, np.arange(size) // 3)), (vert_count, len(faces)))
        # Faces that share a vertex: the nonzeros of the incidence matrix times itself. Its
        # diagonal, each face with itself, goes out.
        pairs = (inside.T @ inside).tocoo()
        apart = pairs.row != pairs.col
        one, other = pairs.row[apart].astype(np.int64), pairs.col[apart].astype(np.int64)
        order = np.argsort(one, kind="stable")
        start = np.concatenate([[0], np.bincount(one, minlength=len(faces)).cumsum()])
        count = np.maximum(np.bincount(at, minlength=vert_count), 1).astype(float)
        return cls(faces, one[order], other[order], start, count)


def filtered(
    verts: Verts,
    around: Around,
    sigma: float,
    start: Normals | None = None,
    rounds: int = NORMAL_ROUNDS,
) -> Normals:
    """The faces' normals, or those of ``start``, after ``rounds`` (Zheng et al., Eq. 4)."""
    areas, own = areas_and_normals(verts, around.faces)
    normals = own if start is None else start
    centres = verts[around.faces].mean(1)
    apart = np.linalg.norm(centres[around.one] - centres[around.other], axis=1)
    # The vertices rest while the normals change, so W_c is computed once.
    near = areas[around.other] * _gauss(apart, REACH * apart.mean())
    normals = np.ascontiguousarray(normals)
    for _ in range(rounds):
        normals = filtered_once(normals, areas, near, around.other, around.start, sigma)
    return normals


def _sound(before: Verts, after: Verts, faces: Faces) -> Verts:
    """``after``, but around faces that have turned over or lost their area as it was before."""
    after = after.copy()
    area_before, was = areas_and_normals(before, faces)
    for _ in range(UNDO_ROUNDS):
        area, now = areas_and_normals(after, faces)
        least = LEAST_AREA * area_before.mean()
        wrong = ((was * now).sum(1) < 0) | ((area < least) & (area_before >= least))
        if not wrong.any():
            break
        # What is put back may turn over a face next to it, hence the rounds.
        after[faces[wrong]] = before[faces[wrong]]
    return after


def _gauss(x: Float[np.ndarray, " p"], sigma: float) -> Float[np.ndarray, " p"]:
    return np.exp(-(x * x) / (2 * sigma * sigma))
