"""The primitive of each piece, those that are alike together: a table has one leg four times."""

from collections.abc import Sequence

import numpy as np
import torch
from jaxtyping import Float

from core.geometry.faces import unit
from core.geometry.init_shape import sample_surface
from core.geometry.mesh import face_areas
from core.geometry.parts.fitting import ANY, Faces, primitive_of
from core.geometry.parts.forms import Forms
from core.geometry.parts.pieces import FITTED, Distances, Piece, points_of
from core.geometry.parts.primitives import FORMS, Points, Primitive

ALIKE = 1.25  # times the area of the least of pieces that may be the same
STANDS_OUT = 2.5  # errors
SLACK, MANY = 1.6, 3  # of the errors, for what so many pieces say together


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
