"""The effect of an adjective such as "tall" on an object: in the training, and on a drawn solid."""

from typing import NamedTuple

from jaxtyping import Float
from torch import Tensor

from core.geometry.mesh import NORMAL_RADIUS

# Factors along x, y and z, and a move of the surface outwards in training units.
STRETCH = {
    "tall": ((0.82, 0.82, 1.25), 0.0),
    "flat": ((1.12, 1.12, 0.62), 0.0),
    "wide": ((1.4, 0.95, 0.95), 0.0),
    "thick": ((1.0, 1.15, 1.0), 0.035),
    "thin": ((0.95, 0.62, 1.0), 0.0),
    "round": ((1.0, 1.0, 1.0), 0.055),
}
LEVELLING = 0.5  # of "round": the power by which the box around the object becomes a cube
NOT_STRETCHED = ((1.0, 1.0, 1.0), 0.0)

Vector = tuple[float, float, float]

AS_IT_IS = (1.0, 1.0, 1.0)
# Slender things: a blade in its own proportions is thinner than the resolution of the network's
# planes.
DRAWN_WIDER: dict[str, Vector] = {
    "sword": (2.4, 2.4, 1.0),
    "katana": (1.7, 1.7, 1.0),
    "dagger": (1.7, 1.7, 1.0),
    "knife": (1.8, 1.8, 1.0),
    "spear": (2.2, 2.2, 1.0),
    "staff": (1.8, 1.8, 1.0),
    "arrow": (2.0, 2.0, 1.0),
    "fork": (1.7, 1.7, 1.0),
    "spoon": (1.6, 1.6, 1.0),
    "pencil": (2.2, 2.2, 1.0),
    "screwdriver": (1.7, 1.7, 1.0),
    "paintbrush": (1.7, 1.7, 1.0),
    "halberd": (2.2, 2.2, 1.0),
    "trident": (2.0, 2.0, 1.0),
    "flute": (1.0, 2.2, 2.2),
    "broom": (2.0, 2.0, 1.0),
    "shovel": (1.8, 1.8, 1.0),
    "wrench": (1.4, 2.2, 1.0),
    "oar": (2.1, 2.1, 1.0),
    "golf club": (2.3, 2.3, 1.0),
    "hockey stick": (1.8, 2.5, 1.0),
    "toothbrush": (2.0, 2.0, 1.0),
    "ukulele": (1.3, 1.5, 1.0),
    "guitar": (1.3, 1.6, 1.0),
    "banjo": (1.3, 1.6, 1.0),
    "airplane": (1.0, 1.0, 1.7),
    "person": (1.3, 1.3, 1.0),
}


def known_wider(noun: str) -> Vector:
    """How much wider than the real thing the solids' network knows it, along x, y and z."""
    return DRAWN_WIDER.get(noun, AS_IT_IS)


class Frame(NamedTuple):
    """The frame of an object's own points: (point - center) * scale, training units."""

    center: Vector
    scale: Vector


IN_PLACE = Frame((0.0, 0.0, 0.0), (1.0, 1.0, 1.0))


def frame_of(
    points: Float[Tensor, "n 3"],
    stretch: Vector = (1.0, 1.0, 1.0),
    swell: float = 0.0,
    level: bool = False,
    size: float = 1.0,
) -> Frame:
    """The frame in which a surface's bounding-box centre is the origin, and its bounding sphere
    about it has the radius ``NORMAL_RADIUS`` once it has been moved outwards by ``swell``.

    ``size`` is a factor on that radius; ``level`` draws the box's sides nearer to each other.
    """
    low, high = points.amin(0), points.amax(0)
    center, factors = (low + high) / 2, points.new_tensor(stretch)
    if level:
        extent = high - low
        factors = factors * (extent.prod() ** (1 / 3) / extent) ** LEVELLING
    radius = ((points - center) * factors).norm(dim=1).max().item()
    a, b, c = center.tolist()
    x, y, z = (factors * ((NORMAL_RADIUS * size - swell) / radius)).tolist()
    return Frame((a, b, c), (x, y, z))


def training_size(verts: Float[Tensor, "n 3"]) -> tuple[float, Float[Tensor, " 3"]]:
    """The scale, and then the shift, to the size in which the networks know things."""
    center = (verts.amin(0) + verts.amax(0)) / 2
    scale = NORMAL_RADIUS / float((verts - center).norm(dim=1).max())
    return scale, -center * scale
