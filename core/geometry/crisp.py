"""A mesh made crisp: faces in their planes, edges where two planes meet, corners where three do.

A lattice rounds every edge by about a cell, and what is drawn on one waves by less. The planes are
found (:mod:`core.geometry.planar`); each vertex goes to the nearest point on all planes of the
faces around it, and what it is still free to do, along an edge or within a plane, it uses to keep
its distance from its neighbours.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import torch
from jaxtyping import Bool, Float, Int
from scipy.sparse import csr_array
from torch import Tensor

from core.geometry.bilateral import Around, filtered, flattened
from core.geometry.collapse import without_turned
from core.geometry.faces import areas_and_normals, neighbours
from core.geometry.planar import Patch, Planes, planes_of

VOTES, REACH = 3, 3  # rounds, and faces that each asks
SIGMA, ROUNDS = 0.5, 4  # of the normals that planes are found from: ripples out, edges kept
RIPPLES = 2, 0.35  # rounds, and the difference of normals that is one
FARTHEST, FARTHEST_AT_FREE = 1.6, 0.8  # cells that a vertex moves; at a face without a plane
MISSED = 0.25  # cells off one of its planes: they do not meet there
PARALLEL = 0.25  # singular value below which planes are too parallel to find where they meet
STEP = 0.9  # cosine between planes that do not meet: from the one to the other is a step
# Cosine to a face without a plane that continues smoothly; rings of faces until all is in the
# plane.
SMOOTH, FADE = np.cos(np.radians(35.0)), 4
SPREADING = 30  # rounds
# Along a line a step back follows each step (Taubin 1995), or a closed line would shrink.
ALONG, BACK, WITHIN = 0.5, -0.52, 0.4


def crisp(
    verts: Float[Tensor, "v 3"],
    faces: Int[Tensor, "f 3"],
    unbent: Float[Tensor, "v 3"],
    part: Int[Tensor, " v"],
    flatness: Sequence[float],
    cell: float,
    smooth: bool = False,
) -> tuple[Float[Tensor, "w 3"], Int[Tensor, "g 3"]]:
    """The mesh with its vertices on the planes that their faces were meant to lie in.

    Other vertices stay as they are; or, next to planes, lose their ripples.

    Args:
        unbent: the same mesh before its faces were flattened: it shows what bends.
        part: of each vertex; no plane continues into another part.
        flatness: of each part, the flat fraction of its surface.
        cell: of the lattice that the mesh comes from, in units of ``verts``.
        smooth: whether they lose them.
    """
    v, f = (x.detach().cpu().double().numpy() / cell for x in (verts, unbent)), faces.cpu().numpy()
    here, before = v
    patch = patch_of(here, before, f, part.cpu().numpy(), np.array(flatness))
    planes = planes_of(patch)
    places, held = here, csr_array((len(here), 1))
    if planes.normal:
        at = Meeting.of(here, patch, planes)
        fraction = blend(patch, planes, len(here))
        places, held = here + fraction[:, None] * (at.spread(here, f) - here), at.member
        if smooth:
            even = flattened(torch.from_numpy(places), faces, *RIPPLES).numpy()
            places = places + at.along(even - places)
    _, wanted = areas_and_normals(before, f)
    flat = planes.label >= 0
    wanted[flat] = planes.table[planes.label[flat], :3]
    left = without_turned(places, f, wanted, held)
    used, left = np.unique(left, return_inverse=True)
    made = places[used] * cell, left.reshape(-1, 3)
    return torch.from_numpy(made[0]).to(verts), torch.from_numpy(made[1]).to(faces)


def patch_of(
    verts: Float[np.ndarray, "v 3"],
    unbent: Float[np.ndarray, "v 3"],
    faces: Int[np.ndarray, "f 3"],
    part: Int[np.ndarray, " v"],
    flatness: Float[np.ndarray, " p"],
) -> Patch:
    """The faces' table; positions in cells."""
    area, _ = areas_and_normals(verts, faces)
    adjacent = neighbours(faces)
    most = part_of_faces(part, faces, adjacent)
    length = np.linalg.norm(verts[np.roll(faces, -1, 1)] - verts[faces], axis=-1)
    normal = filtered(verts, Around.of(faces, len(verts)), SIGMA, None, ROUNDS)
    middles = verts[faces].mean(1), unbent[faces].mean(1)
    return Patch(faces, *middles, normal, area, most, adjacent, length, flatness[most])


def blend(patch: Patch, planes: Planes, count: int) -> Float[np.ndarray, " v"]:
    """How much of its way each vertex goes: all, but where a plane ends within a smooth surface."""
    free = planes.label < 0
    face, side = np.nonzero((patch.adjacent >= 0) & free[:, None])
    other = patch.adjacent[face, side]
    normal = planes.table[planes.label[other], :3]
    smooth = ~free[other] & ((patch.normal[face] * normal).sum(1) > SMOOTH)
    ring = np.full(count, FADE)
    edge = [patch.faces[face[smooth], (side[smooth] + k) % 3] for k in (0, 1)]
    ring[np.concatenate(edge)] = 0
    for _ in range(FADE):
        least = ring[patch.faces].min(1) + 1
        for corner in range(3):
            np.minimum.at(ring, patch.faces[:, corner], least)
    return ring / FADE


def part_of_faces(
    part: Int[np.ndarray, " v"], faces: Int[np.ndarray, "f 3"], adjacent: Int[np.ndarray, "f 3"]
) -> Int[np.ndarray, " f"]:
    """The part that most of a face's corners have, then most of the faces around: no teeth."""
    face, side = np.nonzero(adjacent >= 0)
    pairs = (np.r_[face, np.arange(len(faces))], np.r_[adjacent[face, side], np.arange(len(faces))])
    around = csr_array((np.ones(len(pairs[0])), pairs), (len(faces), len(faces)))
    votes = np.eye(part.max() + 1)[part[faces]].sum(1)
    for _ in range(VOTES):
        votes = np.eye(votes.shape[1])[votes.argmax(1)]
        for _ in range(REACH):
            votes = around @ votes
    return votes.argmax(1)


@dataclass
class Meeting:
    """The planes of each vertex: their nearest point to y is y + b - A y."""

    across: Float[np.ndarray, "v 3 3"]  # A, the projection onto the span of its planes' normals
    to: Float[np.ndarray, "v 3"]  # b, the point of that span on all its planes
    member: csr_array  # (V, 1 + P): the planes of the faces around it; column 0: of none

    @classmethod
    def of(cls, verts: Float[np.ndarray, "v 3"], patch: Patch, planes: Planes) -> "Meeting":
        """Each vertex keeps to the planes around it, without the least ones where they do not meet
        near it."""
        size = (len(verts), 1 + len(planes.normal))
        entries = (
            np.repeat(patch.area, 3),
            (patch.faces.reshape(-1), np.repeat(planes.label + 1, 3)),
        )
        fraction = csr_array(entries, size)
        fraction.sum_duplicates()
        total = np.bincount(planes.label + 1, patch.area, size[1])[1:]
        table, across, to = planes.table, np.zeros((len(verts), 3, 3)), np.zeros((len(verts), 3))
        solved: dict[tuple[int, ...], tuple[np.ndarray, ...]] = {}
        for vert in range(len(verts)):
            row = slice(fraction.indptr[vert], fraction.indptr[vert + 1])
            columns = fraction.indices[row][np.argsort(-fraction.data[row], kind="stable")]
            far = FARTHEST_AT_FREE if (columns == 0).any() else FARTHEST
            kept = tuple(int(c) - 1 for c in columns if c > 0)
            while kept:
                if kept not in solved:
                    solved[kept] = meeting_of(table[list(kept)])
                inverse, normals, offsets = solved[kept]
                move = inverse @ (offsets - normals @ verts[vert])
                missed = np.abs(normals @ (verts[vert] + move) - offsets).max()
                if missed < MISSED and move @ move < far * far:
                    across[vert], to[vert] = inverse @ normals, inverse @ offsets
                    break
                kept = without_one(kept, table, total)
        return cls(across, to, fraction)

    def spread(
        self, verts: Float[np.ndarray, "v 3"], faces: Int[np.ndarray, "f 3"]
    ) -> Float[np.ndarray, "v 3"]:
        """The vertices on their planes, spread evenly along these."""
        mean, line, still = self.spreading(faces)
        places = self.nearest(verts)
        for k in range(SPREADING):
            rate = np.where(line, BACK if k % 2 else ALONG, WITHIN)
            rate[still] = 0
            places = self.nearest(places + rate[:, None] * (mean @ places - places))
        return places

    def along(self, moves: Float[np.ndarray, "v 3"]) -> Float[np.ndarray, "v 3"]:
        """The part of the vertices' moves that leaves them on their planes."""
        return moves - np.einsum("vij,vj->vi", self.across, moves)

    def nearest(self, places: Float[np.ndarray, "v 3"]) -> Float[np.ndarray, "v 3"]:
        """The places moved onto the planes."""
        return places + self.to - np.einsum("vij,vj->vi", self.across, places)

    def spreading(
        self, faces: Int[np.ndarray, "f 3"]
    ) -> tuple[csr_array, Bool[np.ndarray, " v"], Bool[np.ndarray, " v"]]:
        """The mean over the neighbours that have all of a vertex's planes; whether it is of a line
        between planes; whether it stays."""
        member = csr_array(self.member.astype(bool).astype(float))
        count = np.diff(member.indptr)
        ends = np.stack([faces, np.roll(faces, -1, 1)], -1).reshape(-1, 2)
        ends = np.unique(np.concatenate([ends, ends[:, ::-1]]), axis=0)
        common = member[ends[:, 0]].multiply(member[ends[:, 1]]).sum(1)
        ends = ends[common >= count[ends[:, 0]]]
        degree = np.bincount(ends[:, 0], minlength=len(count))
        entries = (1 / degree[ends[:, 0]], (ends[:, 0], ends[:, 1]))
        line, free = count > 1, ~self.across.any((1, 2))
        # What is free stays, but for a border around the planes, which would fray.
        adjacent = np.zeros(len(count), bool)
        adjacent[faces[(~free[faces]).any(1)]] = True
        still = (degree == 0) | (line & (degree < 2)) | (free & ~line & ~adjacent)
        line |= free
        return csr_array(entries, (len(count), len(count))), line, still


def without_one(
    kept: tuple[int, ...], table: Float[np.ndarray, "p 4"], total: Float[np.ndarray, " p"]
) -> tuple[int, ...]:
    """The planes but for the one to give up: the larger of two at a step, else the last."""
    normals = table[list(kept), :3]
    parallel = np.triu(np.abs(normals @ normals.T) > STEP, 1)
    if not parallel.any():
        return kept[:-1]
    pair = [kept[i] for i in np.argwhere(parallel)[0]]
    return tuple(k for k in kept if k != max(pair, key=lambda k: total[k]))


def meeting_of(planes: Float[np.ndarray, "p 4"]) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """The pseudo-inverse of the planes' normals, deaf to differences of nearly parallel ones; the
    normals; the offsets."""
    normals, offsets = planes[:, :3], planes[:, 3]
    u, s, vt = np.linalg.svd(normals, full_matrices=False)
    kept = s > PARALLEL
    return (vt[kept].T / s[kept]) @ u[:, kept].T, normals, offsets
