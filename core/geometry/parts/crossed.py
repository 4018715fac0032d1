"""Solids that are layers along two or three axes at once: a rocket's fins, an airplane's tail.

Along each axis a part of it is even, and the rest is not: through a fin's thickness all sections
are the same, along the other fin's they taper. The even layers of all axes are taken one by one,
each the one that covers most of the remaining surface (a greedy cover: Chvatal 1979).
"""

import numpy as np
import torch
from scipy.spatial.transform import Rotation

from core.geometry.init_shape import sample_surface
from core.geometry.parts.components import FITTED, Component, points_of
from core.geometry.parts.layered import even_layers
from core.geometry.parts.primitives import (
    FORMS,
    FRAMES,
    Layer,
    Primitive,
    packed,
    packed_along,
    unpacked,
)

MORE = 0.02  # of the surface, which a layer has to cover


def crossed(component: Component) -> Primitive | None:
    """The component's layers along the coordinate axes; None where they leave much out."""
    found = [(axis, one) for axis in range(len(FRAMES)) for one in _layers(component, axis)]
    if len(found) < 2:
        return None
    points = points_of(component)
    off = np.stack([one.at(points) for _, one in found])
    nearest, covered, used = np.full(len(points), np.inf), 0.0, []
    while len(used) < len(found):
        fractions = (np.abs(np.minimum(nearest, off)) < component.error / 2).mean(1)
        best = int(fractions.argmax())
        if fractions[best] < covered + MORE:
            break
        nearest, covered = np.minimum(nearest, off[best]), fractions[best]
        used.append(best)
    along: list[list[Layer]] = [[] for _ in FRAMES]
    for axis, one in (found[k] for k in used):
        along[axis] += unpacked(one.lengths)
    if sum(map(bool, along)) < 2:  # along one axis they are layers, or too many
        return None
    return Primitive("crossed", np.zeros(3), np.zeros(3), packed_along(along))


def _layers(component: Component, axis: int) -> list[Primitive]:
    """The even layers along one of the ``FRAMES``, each by itself, if within the component."""
    frame = FRAMES[axis]
    lattice, turn = component.lattice.along(frame), Rotation.from_matrix(frame).as_rotvec()
    found = even_layers(lattice, component, lambda verts: verts @ frame)
    each = [Primitive("layers", np.zeros(3), turn, packed([layer])) for layer in found if layer]
    return [one for one in each if _is_within(one, component)]


def _is_within(one: Primitive, component: Component) -> bool:
    """Whether none of its surface is out of the component by more than what is drawn may be."""
    verts, faces = one.mesh(component.cell)
    if not len(faces):
        return False
    points = sample_surface(verts, faces, FITTED, torch.Generator().manual_seed(0))
    out = component.lattice.near(points.double().numpy()) / component.error
    return all((out < by).mean() >= fraction for by, fraction in FORMS[one.form].drawn)
