"""All families by noun, and what a shape adjective does to an object of theirs."""

from collections.abc import Callable
from dataclasses import dataclass

import torch
from jaxtyping import Float, Int
from torch import Tensor

from core.guidance.builtin.nouns import NOUNS, solid_of
from core.guidance.builtin.stretch import AS_IT_IS, NOT_STRETCHED, STRETCH, Vector, frame_of
from core.prior.draw import Draw
from core.prior.solids import Parts
from core.prior.things.animals import ANIMALS
from core.prior.things.appliances import APPLIANCES
from core.prior.things.arms import ARMS
from core.prior.things.basics import BASICS
from core.prior.things.beasts import BEASTS
from core.prior.things.birds_sea import BIRDS_AND_SEA
from core.prior.things.brood import BROOD
from core.prior.things.characters import CHARACTERS
from core.prior.things.chess import CHESS
from core.prior.things.chests import CHESTS
from core.prior.things.civic import CIVIC
from core.prior.things.clothes import CLOTHES
from core.prior.things.craft import CRAFT
from core.prior.things.creatures import CREATURES
from core.prior.things.curios import CURIOS
from core.prior.things.devices import DEVICES
from core.prior.things.dinosaurs import DINOSAURS
from core.prior.things.dwellings import DWELLINGS
from core.prior.things.equipment import EQUIPMENT
from core.prior.things.everyday import EVERYDAY
from core.prior.things.fantasy import FANTASY
from core.prior.things.fare import FARE
from core.prior.things.fauna import FAUNA
from core.prior.things.festive import FESTIVE
from core.prior.things.figures import FIGURES
from core.prior.things.fixtures import FIXTURES
from core.prior.things.folk import FOLK
from core.prior.things.food import FOOD
from core.prior.things.furnishings import FURNISHINGS
from core.prior.things.gadgets import GADGETS
from core.prior.things.gear import GEAR
from core.prior.things.harbour import HARBOUR
from core.prior.things.haulage import HAULAGE
from core.prior.things.headwear import HEADWEAR
from core.prior.things.home import HOME
from core.prior.things.home_fittings import HOME_FITTINGS
from core.prior.things.household import HOUSEHOLD
from core.prior.things.insects import INSECTS
from core.prior.things.kitchen import KITCHEN
from core.prior.things.landmarks import LANDMARKS
from core.prior.things.larder import LARDER
from core.prior.things.leisure import LEISURE
from core.prior.things.machines import MACHINES
from core.prior.things.market import MARKET
from core.prior.things.menagerie import MENAGERIE
from core.prior.things.nature import NATURE
from core.prior.things.novel import NOVEL
from core.prior.things.novelties import NOVELTIES
from core.prior.things.oddities import ODDITIES
from core.prior.things.office import OFFICE
from core.prior.things.outfit import OUTFIT
from core.prior.things.parlour import PARLOUR
from core.prior.things.pastimes import PASTIMES
from core.prior.things.people import PEOPLE
from core.prior.things.plants import PLANTS
from core.prior.things.playground import PLAYGROUND
from core.prior.things.premises import PREMISES
from core.prior.things.props import PROPS
from core.prior.things.provisions import PROVISIONS
from core.prior.things.relics import RELICS
from core.prior.things.reptiles import REPTILES
from core.prior.things.residence import RESIDENCE
from core.prior.things.rides import RIDES
from core.prior.things.roadside import ROADSIDE
from core.prior.things.roles import ROLES
from core.prior.things.showpieces import SHOWPIECES
from core.prior.things.sites import SITES
from core.prior.things.sky import SKY
from core.prior.things.small_things import SMALL_THINGS
from core.prior.things.speed import SPEED
from core.prior.things.sport import SPORT
from core.prior.things.street import STREET
from core.prior.things.study import STUDY
from core.prior.things.sundries import SUNDRIES
from core.prior.things.table_ware import TABLE_WARE
from core.prior.things.tools import TOOLS
from core.prior.things.transport import TRANSPORT
from core.prior.things.travel import TRAVEL
from core.prior.things.treats import TREATS
from core.prior.things.tribe import TRIBE
from core.prior.things.utensils import UTENSILS
from core.prior.things.vehicles_buildings import VEHICLES_BUILDINGS
from core.prior.things.wild_animals import WILD_ANIMALS
from core.prior.things.wild_creatures import WILD_CREATURES
from core.prior.things.wildlife import WILDLIFE
from core.prior.things.workshop import WORKSHOP
from core.prior.things.worn import WORN
from core.prior.things.yard import YARD

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


FAMILIES: dict[str, Callable[[Draw], Parts]] = (
    BASICS
    | HOUSEHOLD
    | NATURE
    | VEHICLES_BUILDINGS
    | TOOLS
    | DEVICES
    | CLOTHES
    | GEAR
    | FOOD
    | HOME
    | CHESTS
    | HOME_FITTINGS
    | BEASTS
    | PLANTS
    | ANIMALS
    | TRANSPORT
    | CRAFT
    | PROPS
    | YARD
    | PEOPLE
    | BIRDS_AND_SEA
    | CREATURES
    | LANDMARKS
    | GADGETS
    | APPLIANCES
    | TABLE_WARE
    | SITES
    | STREET
    | MACHINES
    | SMALL_THINGS
    | TREATS
    | ARMS
    | FANTASY
    | PLAYGROUND
    | CHARACTERS
    | FIGURES
    | RELICS
    | OFFICE
    | SPORT
    | WILD_ANIMALS
    | WILD_CREATURES
    | SKY
    | INSECTS
    | LEISURE
    | RIDES
    | ROADSIDE
    | PREMISES
    | MARKET
    | EVERYDAY
    | WILDLIFE
    | KITCHEN
    | PARLOUR
    | NOVELTIES
    | ROLES
    | FAUNA
    | DWELLINGS
    | WORN
    | REPTILES
    | FIXTURES
    | UTENSILS
    | EQUIPMENT
    | FURNISHINGS
    | PROVISIONS
    | PASTIMES
    | FESTIVE
    | HAULAGE
    | HEADWEAR
    | SPEED
    | NOVEL
    | CURIOS
    | RESIDENCE
    | STUDY
    | SHOWPIECES
    | TRAVEL
    | CHESS
    | SUNDRIES
    | FARE
    | FOLK
    | MENAGERIE
    | BROOD
    | WORKSHOP
    | TRIBE
    | OUTFIT
    | ODDITIES
    | LARDER
    | HARBOUR
    | DINOSAURS
    | CIVIC
)


def family(noun: str) -> Callable[[Draw], Parts]:
    """The noun's; of what is another thing's solid that one's, its parts by the noun's names."""
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

    ``adjective`` is a word of ``STRETCH`` or empty. ``jitter`` spreads the size about the norm.
    ``wider``: factors along x, y and z that the object is stretched by besides.
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

    First a lattice of half as many cells; where it comes near the surface each of its points
    becomes eight.
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
    """The SDF and its :func:`gradient`, asked together: a call costs as much as 10,000 points."""
    values = sdf(torch.cat([points, _tapped(points, step)]))
    return values[: len(points)], _slope(values[len(points) :])


def _tapped(points: Float[Tensor, "n 3"], step: float) -> Float[Tensor, "m 3"]:
    taps = points.new_tensor(TAPS)
    return (points[None] + step * taps[:, None]).reshape(-1, 3)


def _slope(values: Float[Tensor, " m"]) -> Float[Tensor, "n 3"]:
    return torch.nn.functional.normalize(values.view(4, -1).T @ values.new_tensor(TAPS), dim=1)
