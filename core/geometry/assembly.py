"""A solid of known parts as a mesh: the surface of each piece of each part, made exact, united.

A part by itself is simple: a box, a ball, a board. On a lattice of its own size even a small one
has its form. Most are a primitive (:mod:`core.geometry.fitting`), the same all around an axis
(:mod:`core.geometry.revolved`), or flat outlines one upon another
(:mod:`core.geometry.layered`); of the others planes are found whole (:mod:`core.geometry.crisp`),
and where a piece meets others the union has an edge. One lattice over all of them rounds what is
smaller than a cell, and there each border between two parts is ragged.
"""

from collections.abc import Callable, Collection, Sequence
from functools import cached_property
from typing import NamedTuple

import numpy as np
import torch
from jaxtyping import Float
from scipy.spatial.transform import Rotation
from torch import Tensor

from core.geometry.bilateral import flattened
from core.geometry.blade import blade
from core.geometry.crisp import RIPPLES, crisp
from core.geometry.crossed import crossed
from core.geometry.faces import bending, unit
from core.geometry.fitting import ANY, Faces, frames_of, primitive_of
from core.geometry.flush import flush
from core.geometry.init_shape import sample_surface
from core.geometry.layered import ends_share, layered, wall
from core.geometry.mesh import drop_floaters, face_areas
from core.geometry.pieces import (
    FITTED,
    Distances,
    Mesh,
    Piece,
    drawn_in,
    places_of,
    points_of,
    repeated,
    turned_share,
)
from core.geometry.primitives import FORMS, FRAMES, Points, Primitive
from core.geometry.revolved import SHARE, revolved
from core.geometry.signed_distance import SolidMesh
from core.geometry.tet_grid import EXTENT
from core.geometry.twins import Twin, across, mirrored_mesh, twins
from core.geometry.union import is_solid, profile, union

ALIKE = 1.25  # times the area of the least of pieces that may be the same
WORDY = 0.001  # errors in the mean, for each number of an outline
STANDS_OUT = 2.5  # errors
SLACK, MANY = 1.6, 3  # of the errors, for what so many pieces say together
SECTIONS, OUTLINE = 8, 0.002  # through an axis; training units that its outline is simplified by
LEAST_FLAT = 0.05  # of a part's surface, from which its pieces may have flat faces
FLAT_ENDS = 0.4  # of the area of a piece's ends, what of its part is flat in the mean, at least
STRAIGHT = 0.9  # times the bending of what is smooth, at most: planes that gain less are ragged
NEAR = 0.1  # training units
# Of a part's surface, what is flat of blocks and discs in the mean, at least; and of sharp ones.
BLOCK, SHARP = 0.58, 0.78
# Errors in the mean, below which a piece is surely what it seems; what a blade has of that at most.
CLEAR, BLADED = 0.06, 0.7
ENDLESS = "wall", "blade"  # without ends across an axis
STRUT = 0.03  # radius, training units
STRAY = 0.06  # of the area of a part's least piece, what is none of it at most


class Forms(NamedTuple):
    """What the parts are like, in the mean over a noun's objects."""

    flat: Sequence[float]  # of each, the fraction of its surface that is flat
    round: Sequence[Sequence[float]]  # and the same all around, along x, along y, along z
    cornered: Collection[int] = ()  # parts of corners that are too many to be told from round
    # Of each the area of its least piece, as a fraction of its largest one's; 0 where that is not
    # known.
    least: Sequence[float] = ()

    def may_be_flat(self, part: int) -> bool:
        """Whether pieces of the part may have flat faces; of what is small or was never seen the
        table knows nothing."""
        known = self.flat[part] or any(axis[part] for axis in self.round)
        return not known or self.flat[part] >= LEAST_FLAT

    def is_stray(self, part: int, share: float) -> bool:
        """Whether a piece is far smaller than any that the part has; ``share``: its area, as a
        fraction of the largest one's."""
        return part < len(self.least) and share < STRAY * self.least[part]

    def faces(self, part: int) -> Faces:
        """What is known of the faces of the part's pieces."""
        flat = self.flat[part]
        return Faces(self.may_be_flat(part), flat >= BLOCK, flat >= SHARP, part in self.cornered)


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


def matched(distances: Distances, pieces: list[Piece], forms: Forms) -> list[Primitive | None]:
    """The primitive that each piece is. Pieces of a part that are as large are fitted together, as
    they are, or as mirrored, or as turned about the vertical, and each where none of these fits.

    What a part's forms say it has no flat faces of is no box and no disc: a stripe around a tiger's
    tail was a block, a panda's eyes were discs. What they say is mostly flat is one, if it
    can be: a nightstand's drawer was a roll.
    """
    points = [points_of(piece) for piece in pieces]
    found: list[Primitive | None] = [None] * len(pieces)
    for group in alike(pieces):
        part = pieces[group[0]].place.part
        faces = forms.faces(part)
        some = [pieces[k] for k in group], [points[k] for k in group]
        pairs = list(zip(group, fitted_together(*some, faces), strict=True))
        slack = slack_of(len(group))
        if not all(one and is_drawn(distances, one, pieces[k], slack) for k, one in pairs):
            pairs = [(k, one_drawn(distances, pieces[k], points[k], faces)) for k in group]
        for k, one in pairs:
            found[k] = one.sharp() if one else None
    return found


def is_same(one: Primitive | None, other: Primitive | None) -> bool:
    """Whether two pieces were fitted together."""
    return bool(one and other) and np.array_equal(one.lengths, other.lengths)


def one_drawn(distances: Distances, piece: Piece, points: Points, faces: Faces) -> Primitive | None:
    """The primitive that a piece is by itself, where it was drawn; no block, if that was not."""
    for known in (faces, faces._replace(block=False, sharp=False))[: 1 + faces.block]:
        one = primitive_of(points, piece.error, known)
        if one is not None and is_drawn(distances, one, piece):
            return one
    return None


def is_drawn(distances: Distances, one: Primitive, piece: Piece, slack: float = 1.0) -> bool:
    """Whether the whole surface of a primitive is about where the piece is drawn, and nothing of
    the piece stands far out of it: a fountain's jet is few points of its water."""
    if float(one.distance(piece.verts).abs().max()) > STANDS_OUT * slack * piece.error:
        return False
    generator = torch.Generator().manual_seed(0)
    points = sample_surface(*one.mesh(piece.cell), FITTED, generator)
    off = distances(points)[:, piece.place.part].abs() / (slack * piece.error)
    return all(float((off < by).float().mean()) >= share for by, share in FORMS[one.form].drawn)


def alike(pieces: list[Piece]) -> list[list[int]]:
    """The pieces by part and area."""
    area = [float(face_areas(piece.verts, piece.faces).sum()) for piece in pieces]
    groups: list[list[int]] = []
    for k in sorted(range(len(pieces)), key=lambda k: (pieces[k].place.part, area[k])):
        least = groups[-1][0] if groups else k
        same_part = pieces[least].place.part == pieces[k].place.part
        if groups and same_part and area[k] < ALIKE * area[least]:
            groups[-1].append(k)
        else:
            groups.append([k])
    return groups


def slack_of(count: int) -> float:
    """How much worse than one alone so many pieces may be of one primitive: a table's legs."""
    return SLACK if count >= MANY else 1.0


def fitted_together(
    pieces: list[Piece], points: list[Float[np.ndarray, "n 3"]], faces: Faces = ANY
) -> Sequence[Primitive | None]:
    """One primitive for all, each at its place; Nones where it does not fit all."""
    if len(pieces) > 1:
        error = slack_of(len(pieces)) * pieces[0].error
        middles = [piece.middle.double().numpy() for piece in pieces]
        for placed in (unturned, mirrored, around):
            frames = [placed(middle) for middle in middles]
            local = [(p - m) @ f for p, m, f in zip(points, middles, frames, strict=True)]
            one = primitive_of(np.concatenate(local)[:: len(points)], error, faces)
            if one is not None and all(one.fits(some, error) for some in local):
                return [one.placed(f, m) for f, m in zip(frames, middles, strict=True)]
    return [None] * len(points)


def unturned(_middle: Float[np.ndarray, " 3"]) -> Float[np.ndarray, "3 3"]:
    """As it is."""
    return np.eye(3)


def mirrored(middle: Float[np.ndarray, " 3"]) -> Float[np.ndarray, "3 3"]:
    """Each side of x = 0 and of y = 0 the mirror of the other."""
    return np.diag([1.0 if middle[0] >= 0 else -1.0, 1.0 if middle[1] >= 0 else -1.0, 1.0])


def around(middle: Float[np.ndarray, " 3"]) -> Float[np.ndarray, "3 3"]:
    """Turned about the vertical, as the place is."""
    c, s = unit(middle[None, :2])[0]
    return np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])


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
