"""All families by noun, and objects of a family, with or without a shape adjective."""

from collections.abc import Callable
from dataclasses import dataclass

import torch
from jaxtyping import Float, Int
from torch import Tensor

from core.guidance.builtin.nouns import NOUNS, solid_of
from core.guidance.builtin.stretch import AS_IT_IS, NOT_STRETCHED, STRETCH, Vector, frame_of
from core.prior.draw import Draw
from core.prior.solids import Parts
from core.prior.things import THEMES

TAPS = ((1, -1, -1), (-1, -1, 1), (-1, 1, -1), (1, 1, 1))  # the corners of a tetrahedron


@dataclass(frozen=True)
class Shape:
    """A normalised object: its parts, and their frame in the family's own units."""

    parts: Parts
    center: tuple[float, float, float]
    scale: tuple[float, float, float]  # family units to training units, along x, y, z
    swell: float = 0.0  # how far the surface is moved outwards, training units

    @property
    def names(self) -> list[str]:
        """The parts' names, in the order of ``part``."""
        return list(self.parts)

    def distances(self, points: Float[Tensor, "n 3"]) -> Float[Tensor, "n k"]:
        """Each part's signed distance (a lower bound where the scale is uneven)."""
        local = points / points.new_tensor(self.scale) + points.new_tensor(self.center)
        smallest = min(self.scale)
        return (
            torch.stack([solid(local) for solid in self.parts.values()], 1) * smallest - self.swell
        )

    def sdf(self, points: Float[Tensor, "n 3"]) -> Float[Tensor, " n"]:
        """Signed distance of the whole, negative inside, training units."""
        return self.distances(points).amin(1)

    def part(self, points: Float[Tensor, "n 3"]) -> Int[Tensor, " n"]:
        """Index of the part that is nearest."""
        return self.distances(points).argmin(1)


FAMILIES: dict[str, Callable[[Draw], Parts]] = {
    noun: family for theme in THEMES for noun, family in theme.items()
}


def family(noun: str) -> Callable[[Draw], Parts]:
    """The noun's family; for a noun that has another noun's solid, that noun's family with the
    parts renamed to the noun's own."""
    of = solid_of(noun)
    if of == noun:
        return FAMILIES[noun]
    names = dict(zip(NOUNS[of].looks, NOUNS[noun].looks, strict=False))
    return lambda draw: {
        names[name]: part for name, part in FAMILIES[of](draw).items() if name in names
    }


def build(
    noun: str, adjective: str, draw: Draw, jitter: float = 0.06, wider: Vector = AS_IT_IS
) -> Shape:
    """A random object of the noun's family, normalised (see ``normalised``).

    ``adjective``: a word of ``STRETCH``, or empty. ``jitter``: the size's spread about the norm.
    ``wider``: further stretch factors along x, y and z.
    """
    factors, swell = STRETCH.get(adjective, NOT_STRETCHED)
    parts = family(noun)(draw.formed(adjective))
    if adjective:
        x, y, z = (factor * draw(0.96, 1.04) for factor in factors)
        factors = (x, y, z)
    x, y, z = (factor * by for factor, by in zip(factors, wider, strict=True))
    return normalised(parts, (x, y, z), swell, adjective == "round", draw(1 - jitter, 1 + jitter))


def normalised(
    parts: Parts,
    stretch: tuple[float, float, float] = (1.0, 1.0, 1.0),
    swell: float = 0.0,
    level: bool = False,
    size: float = 1.0,
) -> Shape:
    """An object of ``parts`` in the frame of :func:`core.guidance.builtin.stretch.frame_of`."""
    points = surface_points(lambda p: torch.stack([s(p) for s in parts.values()]).amin(0))
    frame = frame_of(points, stretch, swell, level, size)
    return Shape(parts, frame.center, frame.scale, swell)


def surface_points(
    sdf: Callable[[Tensor], Tensor], reach: float = 3.2, cells: int = 56
) -> Float[Tensor, "n 3"]:
    """Points on the surface, found on a lattice over x, y in ±reach/2, z in [-reach/2, reach].

    The first lattice has half as many cells; near the surface each of its points becomes eight.
    """
    step = 2 * reach / cells
    side = torch.arange(-reach / 2, reach / 2, step) + step / 2
    high = torch.arange(-reach / 2, reach, step) + step / 2
    lattice = torch.stack(torch.meshgrid(side, side, high, indexing="ij"), -1).reshape(-1, 3)
    near = lattice[sdf(lattice).abs() < 0.9 * step]  # half a cell's diagonal is 0.87
    signs = torch.tensor([-0.25, 0.25]) * step
    corners = torch.stack(torch.meshgrid(signs, signs, signs, indexing="ij"), -1).reshape(-1, 3)
    near = (near[:, None] + corners).reshape(-1, 3)
    near = near[sdf(near).abs() < step / 2]
    for _ in range(3):
        value, slope = value_and_gradient(sdf, near)
        near = near - value[:, None] * slope
    return near[sdf(near).abs() < 0.01]


def gradient(
    sdf: Callable[[Tensor], Tensor], points: Float[Tensor, "n 3"], step: float = 2e-3
) -> Float[Tensor, "n 3"]:
    """The SDF's unit gradient by four taps at the corners of a tetrahedron (Quilez)."""
    return _slope(sdf(_tapped(points, step)))


def value_and_gradient(
    sdf: Callable[[Tensor], Tensor], points: Float[Tensor, "n 3"], step: float = 2e-3
) -> tuple[Float[Tensor, " n"], Float[Tensor, "n 3"]]:
    """The SDF and its :func:`gradient` in one call: a call costs as much as 10,000 points."""
    values = sdf(torch.cat([points, _tapped(points, step)]))
    return values[: len(points)], _slope(values[len(points) :])


def _tapped(points: Float[Tensor, "n 3"], step: float) -> Float[Tensor, "m 3"]:
    taps = points.new_tensor(TAPS)
    return (points[None] + step * taps[:, None]).reshape(-1, 3)


def _slope(values: Float[Tensor, " m"]) -> Float[Tensor, "n 3"]:
    return torch.nn.functional.normalize(values.view(4, -1).T @ values.new_tensor(TAPS), dim=1)
