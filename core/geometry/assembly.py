"""A solid of known parts as a mesh: the surface of each piece of each part, made exact, united.

A part by itself is simple: a box, a ball, a board. On a lattice of its own size even a small one
has its form. Most are a primitive (:mod:`core.geometry.primitives`) or the same all around an axis
(:mod:`core.geometry.revolved`); of the others planes are found whole (:mod:`core.geometry.crisp`),
and where a piece meets others the union has an edge. One lattice over all of them rounds what is
smaller than a cell, and there each border between two parts is ragged.
"""

from collections.abc import Callable, Iterator, Sequence
from functools import cached_property
from typing import NamedTuple

import numpy as np
import torch
from jaxtyping import Float, Int
from scipy import ndimage
from scipy.spatial.transform import Rotation
from torch import Tensor

from core.geometry.crisp import crisp
from core.geometry.faces import areas_and_normals, bending, unit
from core.geometry.flush import flush
from core.geometry.init_shape import sample_surface
from core.geometry.layered import FAR, Lattice, layered, wall
from core.geometry.mesh import compact, component_labels, drop_floaters, face_areas, polished
from core.geometry.primitives import Primitive, frames_of, primitive_of
from core.geometry.revolved import SHARE, revolved
from core.geometry.sdf_net import surface
from core.geometry.signed_distance import SolidMesh
from core.geometry.tet_grid import EXTENT, tet_grid
from core.geometry.union import is_solid, profile, union

SEARCH = 72  # cubes along an edge of the lattice that finds the pieces
BOARD = 0.25  # of its cell: a thin board between two nodes is found by what is so near to it
LEAST_NODES = 4  # of a piece
MARGIN = 1.6  # of its cell, around a piece
# What the network leaves to be made exact is of about this size, and less on small pieces; in
# twelfths of the piece's longest side.
ERROR, ERROR_SHARE = (0.02, 0.04), 1 / 12
CELLS = 1.6  # of the piece's own lattice, to such an error
MOST_CELLS = 72  # along the piece's longest side
POLISH = 2  # rounds
TURNS, TURNED = 12, 500  # by which a piece is turned about its middle, vertices that are
TURNED_OFF = 0.5  # errors off the surface, of what is the same all around
ALIKE = 1.25  # times the area of the least of pieces that may be the same
DRAWN = ((0.6, 0.9), (1.2, 0.985))  # errors off what is drawn; the least share of a surface
DRAWN_TURNED = ((0.6, 0.9), (1.2, 0.995))  # battlements, a spout or a notch are no noise
DRAWN_LAYERS = ((0.6, 0.84), (1.2, 0.985))
WORDY = 0.001  # errors in the mean, for each number of an outline
SLACK, MANY = 1.6, 3  # of the errors, for what so many pieces say together
TIMES = (8, 7, 6, 5, 4, 3, 2)  # that a piece may repeat itself around an axis
REPEATED = 0.94  # the least share of its surface that does
SECTIONS, OUTLINE = 8, 0.002  # through an axis; training units that its outline is simplified by
ALONG = 0.99  # cosine between an end's normal and the axis
FLAT_ENDS = 0.4  # of the area of a piece's ends, what of its part is flat in the mean, at least
TORN = 1.05  # times the bending of what is drawn, at most
FITTED = 400  # points of a piece's surface, which tell its primitive
NEAR = 0.1  # training units
STRUT = 0.03  # radius, training units

Mesh = tuple[Float[Tensor, "w 3"], Int[Tensor, "g 3"]]
Distances = Callable[[Float[Tensor, "n 3"]], Float[Tensor, "n p"]]


class Forms(NamedTuple):
    """What the parts are like, in the mean over a noun's objects."""

    flat: Sequence[float]  # of each, the fraction of its surface that is flat
    round: Sequence[Sequence[float]]  # and the same all around, along x, along y, along z


class Place(NamedTuple):
    """Where one connected piece of a part is."""

    part: int
    low: Float[np.ndarray, " 3"]  # of the box around it, with a margin
    high: Float[np.ndarray, " 3"]
    others: Callable[[Float[Tensor, "n 3"]], Tensor]  # whether a place is of another of the part's


class Piece(NamedTuple):
    """One connected piece of a part, as it is drawn."""

    place: Place
    verts: Float[Tensor, "v 3"]
    faces: Int[Tensor, "f 3"]
    lattice: Lattice  # that the surface comes from
    error: float  # about what it may be off
    primitive: Primitive | None = None  # that it is up to its errors

    @property
    def cell(self) -> float:
        """Of its lattice."""
        return self.lattice.cell

    @property
    def middle(self) -> Float[Tensor, " 3"]:
        """Of its surface."""
        area = face_areas(self.verts, self.faces)
        return area @ self.verts[self.faces].mean(1) / area.sum()


class KnownParts:
    """The parts of one object, each a solid of its own, and the pieces that they are of."""

    def __init__(self, distances: Distances, forms: Forms) -> None:
        """``distances``: of each part, at points in training units; columns beyond are none."""
        self.distances, self.forms = distances, forms
        self._surfaces: dict[int, Mesh] = {}
        self._solids: dict[int, SolidMesh] = {}

    @cached_property
    def pieces(self) -> list[Piece]:
        """All that have a surface; those of a part that are alike are so exactly."""
        found = places_of(self.distances, len(self.forms.flat))
        drawn = [piece for piece in (drawn_at(self.distances, x) for x in found) if piece]
        pairs = zip(drawn, matched(self.distances, drawn), strict=True)
        told = [self._told(piece, one or self._turned(piece)) for piece, one in pairs]
        even = flush([piece.primitive for piece in told])
        return [piece._replace(primitive=one) for piece, one in zip(told, even, strict=True)]

    def _told(self, piece: Piece, one: Primitive | None) -> Piece:
        """The piece with the primitive that it is; what is none yet without what breaks its
        symmetry, and as layers where it is of such."""
        if one is None:
            piece = repeated(self.distances, piece)
            one = self._layered(piece)
        return piece._replace(primitive=one)

    def _turned(self, piece: Piece) -> Primitive | None:
        """What the piece is, where it is the same all around an axis."""
        share = self.share(piece)
        axis = int(share.argmax())
        turned = turned_about(piece, axis) if share[axis] >= SHARE else None
        return turned if turned and is_drawn(self.distances, turned, piece) else None

    def _layered(self, piece: Piece) -> Primitive | None:
        """What the piece is, where it is flat outlines one upon another along an axis."""
        points, mesh = points_of(piece), (piece.verts.double().numpy(), piece.faces.numpy())
        frames = [np.roll(f, k, 1) for f in frames_of(points) for k in range(3)]
        found = [layered(piece.lattice, *mesh, piece.error, frame) for frame in frames]
        found.append(wall(piece.lattice, *mesh, piece.error, piece.middle.double().numpy()))
        found = [one for one in found if one and one.fits(points, piece.error)]
        likely = [x for x in found if self._may_be(x, piece) and is_drawn(self.distances, x, piece)]
        # Of what fits about as well the one that takes less to say.
        dear = {id(one): one.off(points, piece.error) + WORDY * len(one.lengths) for one in likely}
        return min(likely, key=lambda one: dear[id(one)], default=None)

    def _may_be(self, layers: Primitive, piece: Piece) -> bool:
        """Whether the part has such flat ends in the mean: a tube's are not told from its sides."""
        if layers.form != "layers":
            return True
        verts, faces = (x.double().numpy() for x in layers.mesh(np.inf))
        area, normal = areas_and_normals(verts @ layers.frame, faces.astype(int))
        ends = area[np.abs(normal[:, 2]) > ALONG].sum() / area.sum()
        return bool(self.forms.flat[piece.place.part] >= FLAT_ENDS * ends)

    def share(self, piece: Piece) -> Float[np.ndarray, " 3"]:
        """The fraction of the piece's surface that is the same all around along x, y, z."""
        # By the noun's objects, or by this piece itself: a table's top may be round, as most are
        # not.
        own = [turned_share(self.distances, piece, axis) for axis in range(3)]
        return np.maximum(own, [axis[piece.place.part] for axis in self.forms.round])

    def surface_of(self, index: int) -> Mesh:
        """A piece's exact surface, made once."""
        if index not in self._surfaces:
            self._surfaces[index] = exact_surface(self, self.pieces[index])
        return self._surfaces[index]

    def near(self, points: Float[Tensor, "n 3"]) -> Float[Tensor, "n p"]:
        """The parts' distances from their exact surfaces, of points that are near these; what is
        farther off than ``NEAR`` may come out as ``EXTENT``."""
        found = torch.full((len(points), len(self.forms.flat)), EXTENT).to(points)
        for index, piece in enumerate(self.pieces):
            verts, _ = self.surface_of(index)
            low, high = verts.amin(0) - NEAR, verts.amax(0) + NEAR
            here = ((points > low.to(points)) & (points < high.to(points))).all(1)
            if not here.any():
                continue
            column = found[:, piece.place.part]
            column[here] = torch.minimum(column[here], self._distance(index)(points[here]))
        return found

    def _distance(self, index: int) -> Callable[[Tensor], Tensor]:
        """From a piece's exact surface, signed."""
        primitive = self.pieces[index].primitive
        if primitive is not None:
            return primitive.distance
        if index not in self._solids:
            self._solids[index] = SolidMesh(*self.surface_of(index))
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
    for index, piece in enumerate(parts.pieces):
        progress((index + 1) / (len(parts.pieces) + 1))
        meshes.append(parts.surface_of(index) if exact else (piece.verts, piece.faces))
    if not meshes:
        return None
    return drop_floaters(*union(meshes, STRUT), floaters)


def places_of(distances: Distances, parts: int) -> Iterator[Place]:
    """The connected pieces of each part, found on one lattice."""
    cell = 2 * EXTENT / SEARCH
    side = torch.linspace(-EXTENT, EXTENT, SEARCH + 1)
    nodes = torch.stack(torch.meshgrid(side, side, side, indexing="ij"), -1)
    found = distances(nodes.view(-1, 3))[:, :parts].view(*nodes.shape[:3], parts).cpu().numpy()
    for part in range(parts):
        labels = np.zeros(found.shape[:3], np.int32)
        ndimage.label(found[..., part] < BOARD * cell, output=labels)
        for index, where in enumerate(ndimage.find_objects(labels)):
            mine = labels[where] == index + 1
            if mine.sum() < LEAST_NODES or found[(*where, part)][mine].min() >= 0:
                continue
            ends = np.array([(side.start, side.stop - 1) for side in where]).T * cell - EXTENT
            others = _elsewhere(labels, index + 1, cell)
            yield Place(part, ends[0] - MARGIN * cell, ends[1] + MARGIN * cell, others)


def _elsewhere(
    labels: Int[np.ndarray, "n n n"], mine: int, cell: float
) -> Callable[[Float[Tensor, "n 3"]], Tensor]:
    """Whether places are in another labelled piece than ``mine``, by the nearest node."""
    table = torch.from_numpy((labels != 0) & (labels != mine))

    def at(points: Float[Tensor, "n 3"]) -> Tensor:
        node = ((points + EXTENT) / cell).round().long().clamp(0, len(table) - 1)
        return table[tuple(node.T)]

    return at


def drawn_at(distances: Distances, place: Place) -> Piece | None:
    """The piece's closed surface on a lattice of its own."""
    longest = float((place.high - place.low).max())
    error = min(max(longest * ERROR_SHARE, ERROR[0]), ERROR[1])
    grid = tet_grid(min(int(np.ceil(longest * CELLS / error)), MOST_CELLS))
    cell = longest / grid.resolution
    middle = torch.from_numpy((place.low + place.high) / 2).float()
    nodes = grid.tet_verts * (longest / (2 * EXTENT)) + middle
    low, high = (torch.from_numpy(end).float() for end in (place.low, place.high))
    asked = ((nodes > low) & (nodes < high)).all(1) & ~grid.boundary
    asked[asked.clone()] = ~place.others(nodes[asked])
    distance = torch.full((len(nodes),), FAR * cell)  # outside, where nothing is asked
    distance[asked] = distances(nodes[asked])[:, place.part].cpu()
    verts, faces, *_ = surface(distance, nodes, grid)
    if not len(faces):
        return None
    verts, faces = largest(verts, faces)
    verts = polished(verts, faces, POLISH)
    values = distance.view(grid.shape).double().numpy()
    return Piece(place, verts, faces, Lattice(values, nodes[0].double().numpy(), cell), error)


def matched(distances: Distances, pieces: list[Piece]) -> list[Primitive | None]:
    """The primitive that each piece is. Pieces of a part that are as large are fitted together, as
    they are, or as mirrored, or as turned about the vertical, and each where none of these fits."""
    points = [points_of(piece) for piece in pieces]
    found: list[Primitive | None] = [None] * len(pieces)
    for group in alike(pieces):
        together = fitted_together([pieces[k] for k in group], [points[k] for k in group])
        pairs = list(zip(group, together, strict=True))
        slack = slack_of(len(group))
        if not all(one and is_drawn(distances, one, pieces[k], slack) for k, one in pairs):
            pairs = [(k, primitive_of(points[k], pieces[k].error)) for k in group]
            pairs = [(k, one) for k, one in pairs if one and is_drawn(distances, one, pieces[k])]
        for k, one in pairs:
            found[k] = one.sharp() if one else None
    return found


def is_drawn(distances: Distances, one: Primitive, piece: Piece, slack: float = 1.0) -> bool:
    """Whether the whole surface of a primitive is about where the piece is drawn."""
    generator = torch.Generator().manual_seed(0)
    points = sample_surface(*one.mesh(piece.cell), FITTED, generator)
    off = distances(points)[:, piece.place.part].abs() / (slack * piece.error)
    drawn = {"turned": DRAWN_TURNED, "layers": DRAWN_LAYERS, "wall": DRAWN_LAYERS}.get(
        one.form, DRAWN
    )
    return all(float((off < by).float().mean()) >= share for by, share in drawn)


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
    pieces: list[Piece], points: list[Float[np.ndarray, "n 3"]]
) -> Sequence[Primitive | None]:
    """One primitive for all, each at its place; Nones where it does not fit all."""
    if len(pieces) > 1:
        error = slack_of(len(pieces)) * pieces[0].error
        middles = [piece.middle.double().numpy() for piece in pieces]
        for placed in (unturned, mirrored, around):
            frames = [placed(middle) for middle in middles]
            local = [(p - m) @ f for p, m, f in zip(points, middles, frames, strict=True)]
            one = primitive_of(np.concatenate(local)[:: len(points)], error)
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


def points_of(piece: Piece) -> Float[np.ndarray, "n 3"]:
    """Of the piece's surface, evenly by area."""
    generator = torch.Generator().manual_seed(0)
    return sample_surface(piece.verts, piece.faces, FITTED, generator).double().numpy()


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
    """That of its primitive; or its own, on its planes."""
    if piece.primitive is not None:
        return piece.primitive.mesh(piece.cell)
    verts, faces, flat = piece.verts, piece.faces, parts.forms.flat[piece.place.part]
    of = torch.zeros(len(verts), dtype=torch.long)
    made = crisp(verts, faces, verts, of, (flat,), piece.error)
    before, after = (bending(v.double().numpy(), f.numpy()) for v, f in ((verts, faces), made))
    # On what is finer than its errors the planes are wrong, and leave it ragged.
    return made if after < TORN * before and is_solid(*made) else (verts, faces)


def turned_share(distances: Distances, piece: Piece, axis: int) -> float:
    """The fraction of a piece's surface that stays on it when it is turned about the line along
    ``axis`` through its middle."""
    # By no symmetry of a square.
    return on_itself(distances, piece, axis, [k / (TURNS + 0.5) for k in range(1, TURNS + 1)])


def repeated(distances: Distances, piece: Piece) -> Piece:
    """The piece as it is in the mean over the turns that leave it as it is."""
    mean = repeats(distances, piece)
    return (mean and drawn_at(mean, piece.place)) or piece


def repeats(distances: Distances, piece: Piece) -> Distances | None:
    """The mean of a piece's distances over the turns that leave it as it is; None: over none."""
    middle = piece.middle
    for times in TIMES:
        turns = [k / times for k in range(times)]
        for axis in (2, 0, 1):
            if on_itself(distances, piece, axis, turns[1:]) >= REPEATED:
                return lambda points: torch.stack(
                    [distances(x + middle) for x in ring_of(points - middle, axis, turns)]
                ).mean(0)
    return None


def on_itself(distances: Distances, piece: Piece, axis: int, turns: Sequence[float]) -> float:
    """The fraction of a piece's surface that parts of a whole turn leave on it."""
    some = piece.verts[:: -(-len(piece.verts) // TURNED)] - piece.middle
    places = ring_of(some, axis, turns) + piece.middle
    off = distances(places.view(-1, 3))[:, piece.place.part].abs()
    return float((off < TURNED_OFF * piece.error).float().mean())


def ring_of(
    points: Float[Tensor, "n 3"], axis: int, turns: Sequence[float]
) -> Float[Tensor, "t n 3"]:
    """The points by each part of a whole turn about an axis through the origin."""
    angle = 2 * torch.pi * torch.tensor(turns)
    c, s = angle.cos()[:, None], angle.sin()[:, None]
    i, j = (k for k in range(3) if k != axis)
    placed = points.repeat(len(turns), 1, 1)
    placed[..., i] = c * points[:, i] - s * points[:, j]
    placed[..., j] = s * points[:, i] + c * points[:, j]
    return placed


def largest(verts: Float[Tensor, "v 3"], faces: Int[Tensor, "f 3"]) -> Mesh:
    """The component of the most faces."""
    _, label = component_labels(faces, len(verts))
    return compact(verts, faces[torch.from_numpy(label == np.bincount(label).argmax())])
