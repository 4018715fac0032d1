"""A solid of known parts as a mesh: the surface of each piece of each part, made exact, united.

A part by itself is simple: a box, a ball, a board. On a lattice of its own size even a small one
has its form. Most are a primitive (:mod:`core.geometry.parts.fitting`), the same all around an
axis (:mod:`core.geometry.revolved`), or flat outlines one upon another
(:mod:`core.geometry.parts.layered`); of the others planes are found whole
(:mod:`core.geometry.crisp`), and where a piece meets others the union has an edge. One lattice over
all of them rounds what is smaller than a cell, and there each border between two parts is ragged.
"""

from collections.abc import Callable
from functools import cached_property

import numpy as np
import torch
from jaxtyping import Float
from scipy.spatial.transform import Rotation
from torch import Tensor

from core.geometry.bilateral import flattened
from core.geometry.crisp import RIPPLES, crisp
from core.geometry.faces import bending
from core.geometry.mesh import drop_floaters, face_areas
from core.geometry.parts.blade import blade
from core.geometry.parts.crossed import crossed
from core.geometry.parts.fitting import frames_of
from core.geometry.parts.flush import flush
from core.geometry.parts.forms import Forms
from core.geometry.parts.layered import ends_share, layered, wall
from core.geometry.parts.matching import is_drawn, is_same, matched
from core.geometry.parts.pieces import (
    Distances,
    Mesh,
    Piece,
    drawn_in,
    places_of,
    points_of,
    repeated,
    turned_share,
)
from core.geometry.parts.primitives import FRAMES, Primitive
from core.geometry.parts.twins import Twin, across, mirrored_mesh, twins
from core.geometry.revolved import SHARE, revolved
from core.geometry.signed_distance import SolidMesh
from core.geometry.tet_grid import EXTENT
from core.geometry.union import is_solid, profile, union

WORDY = 0.001  # errors in the mean, for each number of an outline
SECTIONS, OUTLINE = 8, 0.002  # through an axis; training units that its outline is simplified by
FLAT_ENDS = 0.4  # of the area of a piece's ends, what of its part is flat in the mean, at least
STRAIGHT = 0.9  # times the bending of what is smooth, at most: planes that gain less are ragged
NEAR = 0.1  # training units
# Errors in the mean, below which a piece is surely what it seems; what a blade has of that at most.
CLEAR, BLADED = 0.06, 0.7
ENDLESS = "wall", "blade"  # without ends across an axis
STRUT = 0.03  # radius, training units


class KnownParts:
    """The parts of one object, each a solid of its own, and the pieces that they are of."""

    def __init__(
        self, distances: Distances, forms: Forms, wider: tuple[float, float, float] = (1, 1, 1)
    ) -> None:
        """
        Args:
            distances: of each part, at points in training units; columns beyond are none.
            wider: by how much wider the pieces are looked at than they are, along x, y and z: a
                lattice would miss a slender thing's walls.
        """
        self.distances, self.forms, self.wider = distances, forms, wider
        self._surfaces: dict[int, Mesh] = {}
        self._solids: dict[int, SolidMesh] = {}
        self._twins: dict[int, Twin] = {}

    @cached_property
    def pieces(self) -> list[Piece]:
        """All that have a surface, as wide as they are looked at; of a part those that are alike
        are so exactly. What mirrors another has no primitive of its own: it is that one's."""
        places = places_of(self._wide, len(self.forms.flat))
        drawn = [piece for place in places for piece in drawn_in(self._wide, place)]
        drawn = without_strays(drawn, self.forms)
        found = matched(self._wide, drawn, self.forms)
        self._twins = {
            index: twin
            for index, twin in twins(self._wide, drawn).items()
            if not is_same(found[index], found[twin.of])
        }
        told = [
            piece if index in self._twins else self._as_made(piece, one)
            for index, (piece, one) in enumerate(zip(drawn, found, strict=True))
        ]
        even = flush([piece.primitive for piece in told])
        return [piece._replace(primitive=one) for piece, one in zip(told, even, strict=True)]

    def _as_made(self, piece: Piece, one: Primitive | None) -> Piece:
        """The piece with the primitive that it is, ``one`` or another; what is none without what
        breaks its symmetry, and as layers where it is of such."""
        one = self._bladed(piece, one or self._turned(piece))
        if one is None:
            piece = repeated(self._wide, piece)
            one = self._layered(piece)
        return piece._replace(primitive=one)

    def _bladed(self, piece: Piece, one: Primitive | None) -> Primitive | None:
        """The blade that a mostly flat piece is, where that is nearer: a small one is nearly a ball
        too."""
        if one is None or not self.forms.faces(piece.place.part).block:
            return one
        points = points_of(piece)
        off = one.off(points, piece.error)
        if off <= CLEAR or (edged := blade(piece)) is None:
            return one
        found = self._best(piece, [edged])
        return found if found and found.off(points, piece.error) < BLADED * off else one

    def _turned(self, piece: Piece) -> Primitive | None:
        """What the piece is, where it is the same all around an axis."""
        if piece.place.part in self.forms.cornered:
            return None
        share = self.share(piece)
        axis = int(share.argmax())
        turned = turned_about(piece, axis) if share[axis] >= SHARE else None
        return turned if turned and is_drawn(self._wide, turned, piece) else None

    def _layered(self, piece: Piece) -> Primitive | None:
        """What the piece is, where it is flat outlines one upon another along an axis, or along
        several, or one around a line."""
        frames = [frame @ turned for frame in frames_of(points_of(piece)) for turned in FRAMES]
        each = [*(layered(piece, frame) for frame in frames), wall(piece)]
        if self.forms.faces(piece.place.part).block:
            each.append(blade(piece))
        flat = [one for one in each if one]
        found = self._best(piece, flat)
        if found is None and (one := crossed(piece)):
            found = self._best(piece, [one])
        return found

    def _best(self, piece: Piece, flat: list[Primitive]) -> Primitive | None:
        """Of these the one that fits the piece best; None where none does."""
        points = points_of(piece)
        # A round tube is not told from a flat one: the noun's objects say whether there are ends.
        most = self.forms.flat[piece.place.part] / FLAT_ENDS
        fits = [one for one in flat if one.form in ENDLESS or ends_share(one) <= most]
        fits = [one for one in fits if one.fits(points, piece.error)]
        return min(
            (one for one in fits if is_drawn(self._wide, one, piece)),
            # Of what fits about as well the one that takes less to say.
            key=lambda one: one.off(points, piece.error) + WORDY * len(one.lengths),
            default=None,
        )

    def share(self, piece: Piece) -> Float[np.ndarray, " 3"]:
        """The fraction of the piece's surface that is the same all around along x, y, z."""
        # By the noun's objects, or by this piece itself: a table's top may be round, as most are
        # not.
        own = [turned_share(self._wide, piece, axis) for axis in range(3)]
        return np.maximum(own, [axis[piece.place.part] for axis in self.forms.round])

    def extents(self) -> list[Float[np.ndarray, " 3"]]:
        """Of each part, how long its largest piece is along x, y, z; zeros where it has none."""
        boxes = self.boxes()
        return [np.zeros(3) if box is None else (box[1] - box[0]).numpy() for box in boxes]

    def boxes(self) -> list[Float[Tensor, "2 3"] | None]:
        """Of each part the lowest and the highest corner of its largest piece's box; None where it
        has no piece."""
        found: list[Float[Tensor, "2 3"] | None] = [None] * len(self.forms.flat)
        for index, piece in enumerate(self.pieces):
            verts, _ = self.surface_of(index)
            box = torch.stack([verts.amin(0), verts.amax(0)]).cpu()
            before = found[piece.place.part]
            if before is None or (box[1] - box[0]).norm() > (before[1] - before[0]).norm():
                found[piece.place.part] = box
        return found

    def surface_of(self, index: int, exact: bool = True) -> Mesh:
        """A piece's exact surface, or the one that is drawn."""
        piece = self.pieces[index]
        verts, faces = self._surface(index) if exact else (piece.verts, piece.faces)
        return verts / verts.new_tensor(self.wider), faces

    def near(self, points: Float[Tensor, "n 3"]) -> Float[Tensor, "n p"]:
        """The parts' distances from their exact surfaces, of points that are near these; what is
        farther off than ``NEAR`` may come out as ``EXTENT``."""
        found = torch.full((len(points), len(self.forms.flat)), EXTENT).to(points)
        wider = points.new_tensor(self.wider)
        points, reach = points * wider, NEAR * wider
        for index, piece in enumerate(self.pieces):
            verts, _ = self._surface(index)
            low, high = verts.amin(0).to(points) - reach, verts.amax(0).to(points) + reach
            here = ((points > low) & (points < high)).all(1)
            if not here.any():
                continue
            column = found[:, piece.place.part]
            away = self._distance(index)(points[here]) / max(self.wider)
            column[here] = torch.minimum(column[here], away)
        return found

    def _wide(self, points: Float[Tensor, "n 3"]) -> Float[Tensor, "n p"]:
        """The parts' distances as wide as they are looked at."""
        return self.distances(points / points.new_tensor(self.wider)) * max(self.wider)

    def _surface(self, index: int) -> Mesh:
        """A piece's exact surface as wide as it is looked at, made once."""
        if index not in self._surfaces:
            piece, twin = self.pieces[index], self._twins.get(index)
            self._surfaces[index] = (
                mirrored_mesh(self._surface(twin.of), twin.axis)
                if twin
                else exact_surface(self, piece)
            )
        return self._surfaces[index]

    def _distance(self, index: int) -> Callable[[Tensor], Tensor]:
        """From a piece's exact surface, signed."""
        if twin := self._twins.get(index):
            there = self._distance(twin.of)
            return lambda points: there(across(points, twin.axis))
        primitive = self.pieces[index].primitive
        if primitive is not None:
            return primitive.distance
        if index not in self._solids:
            self._solids[index] = SolidMesh(*self._surface(index))
        return self._solids[index].sdf


def assembled(
    parts: KnownParts, exact: bool, floaters: float, progress: Callable[[float], None]
) -> Mesh | None:
    """The union of the parts' surfaces; None where there is none.

    Args:
        exact: as primitives, and with planes and profiles; or all as they are drawn.
        floaters: a component of less area than this much of the largest is dropped.
        progress: gets the fraction done; what it raises stops it.
    """
    meshes = []
    progress(0.0)
    for index in range(len(parts.pieces)):
        progress((index + 1) / (len(parts.pieces) + 1))
        meshes.append(parts.surface_of(index, exact))
    if not meshes:
        return None
    return drop_floaters(*union(meshes, STRUT), floaters)


def without_strays(pieces: list[Piece], forms: Forms) -> list[Piece]:
    """The pieces that are their parts': of a boy's hair a bit lay beside each shoe."""
    areas = [float(face_areas(piece.verts, piece.faces).sum()) for piece in pieces]
    pairs = list(zip(pieces, areas, strict=True))
    largest: dict[int, float] = {}
    for piece, area in pairs:
        largest[piece.place.part] = max(area, largest.get(piece.place.part, 0.0))
    return [
        piece
        for piece, area in pairs
        if not forms.is_stray(piece.place.part, area / largest[piece.place.part])
    ]


def turned_about(piece: Piece, axis: int) -> Primitive | None:
    """The solid of revolution that the piece is, about a line along the axis; or None."""
    of = torch.zeros(len(piece.verts), dtype=torch.long)
    share = tuple((float(k == axis),) for k in range(3))
    verts = revolved(piece.verts, piece.faces, of, share, piece.error)
    upright = np.roll(np.eye(3), axis + 1, 0)  # turns z to the axis
    local = verts.double() @ torch.from_numpy(upright)
    area = face_areas(local, piece.faces)
    center = (area @ local[piece.faces].mean(1) / area.sum()).numpy() * (1, 1, 0)
    outline = profile((local - torch.from_numpy(center)).float(), piece.faces, SECTIONS, OUTLINE)
    if outline is None:
        return None
    turn = Rotation.from_matrix(upright).as_rotvec()
    one = Primitive("turned", upright @ center, turn, outline.ravel())
    return one if one.fits(points_of(piece), piece.error) else None


def exact_surface(parts: KnownParts, piece: Piece) -> Mesh:
    """That of its primitive; or its own, on its planes or without its ripples."""
    if piece.primitive is not None:
        return piece.primitive.mesh(piece.cell)
    verts, faces, flat = piece.verts, piece.faces, parts.forms.flat[piece.place.part]
    of = torch.zeros(len(verts), dtype=torch.long)
    made = crisp(verts, faces, verts, of, (flat,), piece.error, smooth=True)
    smooth = flattened(verts, faces, *RIPPLES), faces
    before, after = (bending(v.double().numpy(), f.numpy()) for v, f in (smooth, made))
    # On what is finer than its errors the planes are wrong, and leave it ragged.
    return made if after < STRAIGHT * before and is_solid(*made) else smooth
