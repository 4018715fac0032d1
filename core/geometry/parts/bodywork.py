"""A vehicle's bodywork: rounded edges, and wells around its wheels.

The solids' network knows planes well, and edges that are round or thin walls over a wheel badly.
So a body is drawn of planes and whole, and these are made of what is drawn, exactly.
"""

from collections.abc import Sequence
from typing import NamedTuple

import igl
import numpy as np
import torch
from jaxtyping import Float, Int
from torch import Tensor

from core.geometry.union import dilated, eroded, is_solid, lathe, less, refined, volume

Mesh = tuple[Float[Tensor, "v 3"], Int[Tensor, "f 3"]]
GAP = 0.03  # between a wheel and its well, training units
STUB = 0.4  # of a wheel's radius: that of the axle which joins it to the body
OUT = 1.0  # how far a well goes beyond its wheel, training units
SEGMENTS = 48
UPRIGHT = 0.8  # of a wheel's height, its length at least; and its width at most
ASIDE = 0.5  # of the width of the body's half, the middle of a wheel at least
FACES, INNER_FACES = 300, 200  # of a surface while it is rounded: all of its planes
KEPT = 0.6  # of a body's volume, by the roundings


class Bodywork(NamedTuple):
    """What is made of a part's planes."""

    radius: float  # of its edges, training units; 0: sharp
    wheels: int | None = None  # the part that it gets wells around
    leans: bool = False  # its sides lean: it is not of flat outlines one upon another


def bodied(
    mesh: Mesh, radius: float, wheels: Sequence[tuple[Tensor, Tensor]], edge: float
) -> tuple[Float[Tensor, "w 3"], Int[Tensor, "g 3"]]:
    """A body with its edges rounded by ``radius``, and wells around its wheels, whose axles are
    along x; a wheel that is not at its side stays as it is. ``edge``: the longest one, about: even
    triangles cannot be made of long slivers, a car became wavy."""
    soft = rounded_edges(mesh, radius) if radius else mesh
    # Thinner than the edges are round, it would be gone.
    made = soft if volume(soft) > KEPT * volume(mesh) else mesh
    half = float(mesh[0][:, 0].abs().max())
    for verts, _ in wheels:
        low, high = verts.amin(0), verts.amax(0)
        (wide, *_), middle = high - low, (low + high) / 2
        if is_upright(high - low) and abs(float(middle[0])) > ASIDE * half:
            made = less(made, _well(middle, float((high - low)[1:].max()) / 2, float(wide)))
    return refined(made, edge)


def rounded_edges(
    mesh: tuple[Tensor, Tensor], radius: float
) -> tuple[Float[Tensor, "w 3"], Int[Tensor, "g 3"]]:
    """A closed mesh without what no ball of this radius inside it reaches (its opening, Serra
    1982): convex edges and corners become round, planes stay where they are; maybe nothing."""
    inner = eroded(_of_few_faces(mesh, FACES), radius)
    return dilated(_of_few_faces(inner, INNER_FACES), radius)


def _of_few_faces(
    mesh: tuple[Tensor, Tensor], most: int
) -> tuple[Float[Tensor, "w 3"], Int[Tensor, "g 3"]]:
    """About the same surface (Garland and Heckbert 1997); the same, if that is no solid."""
    verts, faces = mesh
    if len(faces) <= most:
        return verts, faces
    points, triangles = verts.double().numpy(), faces.numpy()
    found = igl.qslim(points, triangles, most)
    made = torch.from_numpy(found[0]).to(verts), torch.from_numpy(found[1]).to(faces)
    return made if is_solid(*made) else mesh


def is_upright(size: Float[Tensor, " 3"]) -> bool:
    """Whether something of this size is a wheel with its axle along x."""
    wide, long, high = size.tolist()
    return long > UPRIGHT * high > UPRIGHT**2 * long and wide < UPRIGHT * high


def _well(middle: Float[Tensor, " 3"], radius: float, wide: float) -> Mesh:
    """What is cut out around a wheel, but for its axle."""
    inner, outer = -wide / 2 - GAP, wide / 2 + OUT
    around, stub = radius + GAP, STUB * radius
    outline = [(stub, inner), (around, inner), (around, outer), (0, outer), (0, 0), (stub, 0)]
    verts, faces = lathe(np.array(outline), np.inf, SEGMENTS)
    side = 1.0 if middle[0] > 0 else -1.0
    # z to x, or to -x
    turned = torch.stack([side * verts[:, 2], verts[:, 1], -side * verts[:, 0]], 1)
    return turned.to(middle) + middle, faces
