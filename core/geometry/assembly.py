"""A solid of known parts as a mesh: the surface of each piece of each part, made exact, united.

A part by itself is simple: a box, a ball, a board. On a lattice of its own size even a small one
has its form, its planes and profile are found whole (:mod:`core.geometry.crisp`,
:mod:`core.geometry.revolved`), and where it meets others the union has an edge. One lattice over
all of them rounds what is smaller than a cell, and there each border between two parts is ragged.
"""

from collections.abc import Callable, Iterator, Sequence
from typing import NamedTuple

import numpy as np
import torch
from jaxtyping import Float, Int
from scipy import ndimage
from torch import Tensor

from core.geometry.crisp import crisp
from core.geometry.faces import areas_and_normals
from core.geometry.mesh import compact, component_labels, drop_floaters, polished
from core.geometry.revolved import SHARE, revolved
from core.geometry.sdf_net import surface
from core.geometry.tet_grid import EXTENT, tet_grid
from core.geometry.union import box, is_solid, union

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
SIDE, LEAST_SIDE = np.cos(np.radians(25.0)), 0.004  # cosine to a box's side; its share of the area
SIDE_OFF, BOXED = 0.5, 0.97  # errors off its side, of this much of a box's area
ENDS = 0.5  # the most that is flat of what is round: its ends
STRUT = 0.03  # radius, training units

Mesh = tuple[Float[Tensor, "w 3"], Int[Tensor, "g 3"]]
Distances = Callable[[Float[Tensor, "n 3"]], Float[Tensor, "n p"]]


class Forms(NamedTuple):
    """What the parts are like, in the mean over a noun's objects."""

    flat: Sequence[float]  # of each, the fraction of its surface that is flat
    round: Sequence[Sequence[float]]  # and the same all around, along x, along y, along z


class Piece(NamedTuple):
    """One connected piece of a part."""

    part: int
    low: Float[np.ndarray, " 3"]  # of the box around it, with a margin
    high: Float[np.ndarray, " 3"]
    others: Callable[[Float[Tensor, "n 3"]], Tensor]  # whether a place is of another of the part's


def assembled(
    distances: Distances,
    parts: int,
    forms: Forms | None,
    floaters: float,
    progress: Callable[[float], None],
) -> Mesh | None:
    """The union of the parts' surfaces; None where there is none.

    Args:
        distances: of each part, at points in training units; columns beyond ``parts`` are none.
        parts: how many there are.
        forms: which of them are flat or round; None: all are left as they are drawn.
        floaters: a component of less area than this much of the largest is dropped.
        progress: gets the fraction done; what it raises stops it.
    """
    meshes = []
    pieces = list(pieces_of(distances, parts))
    for index, piece in enumerate(pieces):
        made = piece_surface(distances, piece, forms)
        if made is not None:
            meshes.append(made)
        progress((index + 1) / (len(pieces) + 1))
    if not meshes:
        return None
    return drop_floaters(*union(meshes, STRUT), floaters)


def pieces_of(distances: Distances, parts: int) -> Iterator[Piece]:
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
            yield Piece(part, ends[0] - MARGIN * cell, ends[1] + MARGIN * cell, others)


def _elsewhere(
    labels: Int[np.ndarray, "n n n"], mine: int, cell: float
) -> Callable[[Float[Tensor, "n 3"]], Tensor]:
    """Whether places are in another labelled piece than ``mine``, by the nearest node."""
    table = torch.from_numpy((labels != 0) & (labels != mine))

    def at(points: Float[Tensor, "n 3"]) -> Tensor:
        node = ((points + EXTENT) / cell).round().long().clamp(0, len(table) - 1)
        return table[tuple(node.T)]

    return at


def piece_surface(distances: Distances, piece: Piece, forms: Forms | None) -> Mesh | None:
    """The closed surface of one piece on a lattice of its own, on its planes and profile."""
    longest = float((piece.high - piece.low).max())
    error = min(max(longest * ERROR_SHARE, ERROR[0]), ERROR[1])
    grid = tet_grid(min(int(np.ceil(longest * CELLS / error)), MOST_CELLS))
    cell = longest / grid.resolution
    middle = torch.from_numpy((piece.low + piece.high) / 2).float()
    places = grid.tet_verts * (longest / (2 * EXTENT)) + middle
    low, high = (torch.from_numpy(end).float() for end in (piece.low, piece.high))
    asked = ((places > low) & (places < high)).all(1) & ~grid.boundary
    asked[asked.clone()] = ~piece.others(places[asked])
    distance = torch.full((len(places),), cell)  # outside, where nothing is asked
    distance[asked] = distances(places[asked])[:, piece.part].cpu()
    verts, faces, *_ = surface(distance, places, grid)
    if not len(faces):
        return None
    verts, faces = largest(verts, faces)
    verts = polished(verts, faces, POLISH)
    if forms is None:
        return verts, faces
    of, unbent, flat = torch.zeros(len(verts), dtype=torch.long), verts, forms.flat[piece.part]
    sides = box_of(verts, faces, error)
    if sides:
        return box(*sides, edge=cell)
    # By the noun's objects, or by this piece itself: a table's top may be round, as most are not.
    share = np.array([axis[piece.part] for axis in forms.round])
    own = [turned_share(distances, piece.part, verts, axis, error) for axis in range(3)]
    share = np.maximum(share, own)
    if share.max() >= SHARE:
        around = tuple((float(one),) for one in share)
        verts, flat = revolved(verts, faces, of, around, error), min(flat, ENDS)
    made = crisp(verts, faces, unbent, of, (flat,), error)
    return made if is_solid(*made) else (unbent, faces)


def box_of(
    verts: Float[Tensor, "v 3"], faces: Int[Tensor, "f 3"], error: float
) -> tuple[Float[np.ndarray, " 3"], Float[np.ndarray, " 3"]] | None:
    """The corners of the box along the axes that a piece is up to its errors; None if it is none.

    The commonest piece of all, such as a chair's leg, whose ends are too small to show a plane.
    """
    area, normal = areas_and_normals(verts.double().numpy(), faces.numpy())
    middle = verts.double().numpy()[faces.numpy()].mean(1)
    ends = np.zeros((2, 3))
    for axis in range(3):
        for end, way in enumerate((-1, 1)):
            side = way * normal[:, axis] > SIDE
            if area[side].sum() < LEAST_SIDE * area.sum():
                return None
            ends[end, axis] = np.median(middle[side, axis])
    q = np.abs(middle - ends.mean(0)) - (ends[1] - ends[0]) / 2
    outside = np.linalg.norm(q.clip(min=0), axis=1)
    off = np.abs(outside + q.max(1).clip(max=0))
    fits = area @ (off < SIDE_OFF * error) / area.sum() > BOXED
    return (ends[0], ends[1]) if fits else None


def turned_share(
    distances: Distances, part: int, verts: Float[Tensor, "v 3"], axis: int, error: float
) -> float:
    """The fraction of a piece's surface that stays on it when it is turned about the line along
    ``axis`` through the middle of its box."""
    middle = (verts.amin(0) + verts.amax(0)) / 2
    some = (verts[:: -(-len(verts) // TURNED)] - middle)[None]
    # By no symmetry of a square.
    angle = torch.arange(1, TURNS + 1) * (2 * torch.pi / (TURNS + 0.5))
    c, s = angle.cos()[:, None], angle.sin()[:, None]
    i, j = (k for k in range(3) if k != axis)
    turned = some.repeat(TURNS, 1, 1)
    turned[..., i] = c * some[..., i] - s * some[..., j]
    turned[..., j] = s * some[..., i] + c * some[..., j]
    off = distances((turned + middle).view(-1, 3))[:, part].abs()
    return float((off < TURNED_OFF * error).float().mean())


def largest(verts: Float[Tensor, "v 3"], faces: Int[Tensor, "f 3"]) -> Mesh:
    """The component of the most faces."""
    _, label = component_labels(faces, len(verts))
    return compact(verts, faces[torch.from_numpy(label == np.bincount(label).argmax())])
