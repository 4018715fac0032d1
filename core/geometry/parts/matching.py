"""The primitive of each component, similar ones fitted together: a table has one leg four times."""

from collections.abc import Sequence

import numpy as np
import torch
from jaxtyping import Float

from core.geometry.faces import unit
from core.geometry.init_shape import sample_surface
from core.geometry.mesh import face_areas
from core.geometry.parts.components import FITTED, Component, Distances, points_of
from core.geometry.parts.fitting import ANY, Faces, primitive_of
from core.geometry.parts.forms import Forms
from core.geometry.parts.primitives import FORMS, Points, Primitive

SIMILAR = 1.25  # times the area of the least of components that may be the same
STANDS_OUT = 2.5  # errors
SLACK, MANY = 1.6, 3  # of the errors, where so many components agree


def matched(
    distances: Distances, components: list[Component], forms: Forms
) -> list[Primitive | None]:
    """The primitive that each component is. Components of a part of one size are fitted together,
    as they are, mirrored or turned about the vertical; each by itself where none of these fits.

    A part whose forms have no flat faces is no box and no disc: a stripe around a tiger's
    tail was a block, a panda's eyes were discs. A part that is mostly flat is one, if it
    can be: a nightstand's drawer was a roll.
    """
    points = [points_of(component) for component in components]
    found: list[Primitive | None] = [None] * len(components)
    for group in similar_groups(components):
        part = components[group[0]].place.part
        faces = forms.faces(part)
        some = [components[k] for k in group], [points[k] for k in group]
        pairs = list(zip(group, fitted_together(*some, faces), strict=True))
        slack = slack_of(len(group))
        if not all(one and is_drawn(distances, one, components[k], slack) for k, one in pairs):
            pairs = [(k, one_drawn(distances, components[k], points[k], faces)) for k in group]
        for k, one in pairs:
            found[k] = one.sharp() if one else None
    return found


def is_same(one: Primitive | None, other: Primitive | None) -> bool:
    """Whether two components were fitted together."""
    return bool(one and other) and np.array_equal(one.lengths, other.lengths)


def one_drawn(
    distances: Distances, component: Component, points: Points, faces: Faces
) -> Primitive | None:
    """A component's own primitive, if it was drawn there; no block, if that was not."""
    for known in (faces, faces._replace(block=False, sharp=False))[: 1 + faces.block]:
        one = primitive_of(points, component.error, known)
        if one is not None and is_drawn(distances, one, component):
            return one
    return None


def is_drawn(
    distances: Distances, one: Primitive, component: Component, slack: float = 1.0
) -> bool:
    """Whether the whole surface of a primitive is about where the component is drawn, and nothing
    of the component reaches far out of it: a fountain's jet is few points of its water."""
    if float(one.distance(component.verts).abs().max()) > STANDS_OUT * slack * component.error:
        return False
    generator = torch.Generator().manual_seed(0)
    points = sample_surface(*one.mesh(component.cell), FITTED, generator)
    off = distances(points)[:, component.place.part].abs() / (slack * component.error)
    return all(
        float((off < by).float().mean()) >= fraction for by, fraction in FORMS[one.form].drawn
    )


def similar_groups(components: list[Component]) -> list[list[int]]:
    """The components by part and area."""
    area = [float(face_areas(component.verts, component.faces).sum()) for component in components]
    groups: list[list[int]] = []
    for k in sorted(range(len(components)), key=lambda k: (components[k].place.part, area[k])):
        least = groups[-1][0] if groups else k
        same_part = components[least].place.part == components[k].place.part
        if groups and same_part and area[k] < SIMILAR * area[least]:
            groups[-1].append(k)
        else:
            groups.append([k])
    return groups


def slack_of(count: int) -> float:
    """How much worse than one alone so many components may be of one primitive: a table's legs."""
    return SLACK if count >= MANY else 1.0


def fitted_together(
    components: list[Component], points: list[Float[np.ndarray, "n 3"]], faces: Faces = ANY
) -> Sequence[Primitive | None]:
    """One primitive for all, each at its place; Nones where it does not fit all."""
    if len(components) > 1:
        error = slack_of(len(components)) * components[0].error
        middles = [component.middle.double().numpy() for component in components]
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
