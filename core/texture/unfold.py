"""Removes faces that are turned against their surface: each is a dark speck.

A face that is folded back on its neighbours turns the normals of all around it. Edges next to it
are collapsed or turned, whichever leaves the faces around most similar to the surface (the local
search of Hoppe et al., "Mesh Optimization", 1993, §4, over the same two operations).
"""

from collections.abc import Callable, Iterator

import numpy as np
from jaxtyping import Float, Int

from core.geometry.faces import areas_and_normals

AGAINST = 0.3  # cosine to the surface's normals near it: less is a fold
GAIN = 0.3  # of what a face costs, which its repair has to be worth
LEAST = 1e-4  # of the mean area: less is no face
ROUNDS = 4

Corners = tuple[int, int, int]
Off = Callable[[Float[np.ndarray, "n 3"], Float[np.ndarray, "n 3"]], Float[np.ndarray, " n"]]


def unfolded(
    verts: Float[np.ndarray, "v 3"], faces: Int[np.ndarray, "f 3"], off: Off
) -> Int[np.ndarray, "g 3"]:
    """A manifold's faces without folds, as far as its topology lets it; no vertex moves.

    Args:
        off: by how much directions (N,3) at points (N,3) differ from the surface's near them: one
            less the cosine, 0 to 2.
    """
    for _ in range(ROUNDS):
        _, normal = areas_and_normals(verts, faces)
        folded = np.flatnonzero(off(verts[faces].mean(1), normal) > 1 - AGAINST)
        if not len(folded):
            break
        patches = _Patches(verts, faces, off)
        changed = [patches.repair(int(face)) for face in folded]
        faces = patches.rest()
        if not any(changed):
            break
    return faces


class _Patches:
    """The faces by their vertices, so that a few of them can be replaced."""

    def __init__(
        self, verts: Float[np.ndarray, "v 3"], faces: Int[np.ndarray, "f 3"], off: Off
    ) -> None:
        self._verts, self._off = verts, off
        self._least = LEAST * areas_and_normals(verts, faces)[0].mean()
        self._faces: dict[int, Corners] = dict(enumerate(map(tuple, faces.tolist())))
        self._around: list[set[int]] = [set() for _ in verts]
        for face, corners in self._faces.items():
            for corner in corners:
                self._around[corner].add(face)

    def rest(self) -> Int[np.ndarray, "g 3"]:
        """The faces that there are."""
        return np.array(list(self._faces.values()), np.int64).reshape(-1, 3)

    def repair(self, face: int) -> bool:
        """Replace what is around a fold, if anything there is better."""
        if face not in self._faces:
            return False
        corners = self._faces[face]
        best, least = None, -GAIN * self._cost([corners])[0]
        for old, new in self._ways(corners):
            before, _ = self._cost([self._faces[k] for k in old])
            after, smallest = self._cost(new)
            if after - before < least and smallest > self._least:
                best, least = (old, new), after - before
        if best is None:
            return False
        for k in best[0]:
            for corner in self._faces.pop(k):
                self._around[corner].discard(k)
        for k, corners in zip(best[0], best[1], strict=False):
            self._faces[k] = corners
            for corner in corners:
                self._around[corner].add(k)
        return True

    def _ways(self, corners: Corners) -> Iterator[tuple[list[int], list[Corners]]]:
        """Possible replacements of the faces around a face, with no more faces than there are."""
        for a, b, c in (corners, (*corners[1:], corners[0]), (corners[2], *corners[:2])):
            both = self._around[a] & self._around[b]
            if len(both) != 2:
                continue
            common = self._near(a) & self._near(b)
            if len(common) == 2 and self._closed(a) and self._closed(b):
                for kept, gone in ((a, b), (b, a)):
                    old = sorted(self._around[gone])
                    moved = [tuple(kept if v == gone else v for v in self._faces[k]) for k in old]
                    yield old, [new for new in moved if len(set(new)) == 3]
            beyond = {v for k in both for v in self._faces[k]} - {a, b, c}
            if len(beyond) != 1:  # two faces back to back
                continue
            (d,) = beyond
            few = min(len(self._around[a]), len(self._around[b])) <= 3
            if not (few or self._around[c] & self._around[d]):
                yield sorted(both), [(c, a, d), (d, b, c)]

    def _near(self, vertex: int) -> set[int]:
        return {v for k in self._around[vertex] for v in self._faces[k]} - {vertex}

    def _closed(self, vertex: int) -> bool:
        """Whether faces are all around it, more than three: an open border stays where it is."""
        return len(self._near(vertex)) == len(self._around[vertex]) > 3

    def _cost(self, faces: list[Corners]) -> tuple[float, float]:
        """The area of faces times what they differ from the surface by, and of the smallest."""
        some = np.array(faces)
        area, normal = areas_and_normals(self._verts, some)
        return float(area @ self._off(self._verts[some].mean(1), normal)), float(area.min())
