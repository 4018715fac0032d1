"""One family of solids for each noun: random proportions, named parts.

Front is -Y, up is +Z. Everything a picture of 64² shall show is at least about 4 pixels wide: legs,
handles and walls are thicker than in life. The units are arbitrary; ``normalised`` scales.
"""

from collections.abc import Callable
from dataclasses import dataclass

import torch
from jaxtyping import Float, Int
from torch import Tensor

from core.geometry.mesh import NORMAL_RADIUS
from core.prior.solids import (
    Solid,
    ball,
    box,
    capsule,
    cut,
    ellipsoid,
    join,
    lathe,
    prism,
    ring,
    smooth_curve,
    tube,
)

Parts = dict[str, Solid]


class Draw:
    """Random numbers for proportions, from one generator."""

    def __init__(self, generator: torch.Generator) -> None:
        self.generator = generator

    def __call__(self, low: float, high: float) -> float:
        """Uniform in [low, high)."""
        return low + (high - low) * torch.rand(1, generator=self.generator).item()

    def chance(self, probability: float) -> bool:
        """True with this probability."""
        return self(0, 1) < probability


@dataclass(frozen=True)
class Shape:
    """A normalised object: its parts, and where they stand in the family's own units."""

    parts: Parts
    center: tuple[float, float, float]
    scale: tuple[float, float, float]  # family units to training units, along x, y, z

    @property
    def names(self) -> list[str]:
        """The parts' names, in the order of ``part``."""
        return list(self.parts)

    def distances(self, points: Float[Tensor, "n 3"]) -> Float[Tensor, "n k"]:
        """Each part's signed distance (a lower bound where the scale is uneven)."""
        local = points / points.new_tensor(self.scale) + points.new_tensor(self.center)
        smallest = min(self.scale)
        return torch.stack([solid(local) for solid in self.parts.values()], 1) * smallest

    def sdf(self, points: Float[Tensor, "n 3"]) -> Float[Tensor, " n"]:
        """Signed distance of the whole, negative inside, training units."""
        return self.distances(points).amin(1)

    def part(self, points: Float[Tensor, "n 3"]) -> Int[Tensor, " n"]:
        """Index of the part that is nearest."""
        return self.distances(points).argmin(1)


def _ball(_: Draw) -> Parts:
    return {"body": ball((0, 0, 0), 1.0)}


def _cube(draw: Draw) -> Parts:
    return {"body": box((0, 0, 0), (1, 1, 1), draw(0.02, 0.15))}


def _torus(draw: Draw) -> Parts:
    return {"body": ring((0, 0, 0), 1.0, draw(0.32, 0.45))}


def _cylinder(draw: Draw) -> Parts:
    half = draw(1.0, 1.4)
    return {"body": tube((0, 0, -half), (0, 0, half), draw(0.75, 0.95), draw(0.02, 0.1))}


def _cone(draw: Draw) -> Parts:
    radius, height = draw(0.85, 1.05), draw(1.7, 2.2)
    return {"body": lathe([(0, 0), (radius, 0), (0, height)], 0.04)}


def _legs(x: float, y: float, top: float, thick: float, round_legs: bool) -> Solid:
    """Four legs under the corners (±x, ±y), from the floor to ``top``."""
    corners = [(sx * (x - thick), sy * (y - thick)) for sx in (-1, 1) for sy in (-1, 1)]
    if round_legs:
        return join(*(tube((a, b, 0), (a, b, top), thick, 0.02) for a, b in corners))
    half = (thick, thick, top / 2)
    return join(*(box((a, b, top / 2), half, 0.02) for a, b in corners))


def _table(draw: Draw) -> Parts:
    x, top, thick = draw(0.9, 1.2), draw(0.9, 1.2), draw(0.11, 0.14)
    y = x * draw(0.6, 0.95)
    plate = draw(0.07, 0.1)
    return {
        "top": box((0, 0, top + plate), (x, y, plate), 0.03),
        "legs": _legs(x, y, top + plate, thick, draw.chance(0.4)),
    }


def _chair(draw: Draw) -> Parts:
    x, y = draw(0.57, 0.66), draw(0.55, 0.63)
    seat, thick, plate = draw(0.7, 0.88), draw(0.1, 0.125), draw(0.08, 0.1)
    top, board = seat + draw(0.75, 0.98), draw(0.08, 0.1)
    return {
        "seat": box((0, 0, seat), (x, y, plate), 0.04),
        "back": box((0, y - board, (seat + top) / 2), (x, board, (top - seat) / 2 + plate), 0.04),
        "legs": _legs(x, y, seat, thick, draw.chance(0.4)),
    }


def _armchair(draw: Draw) -> Parts:
    x, y, seat = draw(0.8, 1.0), draw(0.7, 0.8), draw(0.6, 0.75)
    arm, arm_top = draw(0.17, 0.24), seat + draw(0.28, 0.4)
    back, back_top = draw(0.17, 0.24), seat + draw(0.75, 0.95)
    soft = draw(0.08, 0.15)
    arms = (
        box((side * (x - arm), 0, arm_top / 2), (arm, y, arm_top / 2), soft) for side in (-1, 1)
    )
    return {
        "cushion": box((0, 0, seat / 2), (x - arm, y, seat / 2), soft),
        "back": box((0, y - back, back_top / 2), (x - 0.02, back, back_top / 2), soft),
        "arms": join(*arms),
    }


def _mug(draw: Draw) -> Parts:
    radius, height, wall = draw(0.52, 0.6), draw(1.1, 1.35), draw(0.08, 0.11)
    taper = draw(-0.06, 0.06)
    outer = lathe([(radius - taper - 0.03, 0.03), (radius + taper - 0.03, height - 0.03)], 0.03)
    inner = lathe([(radius - taper - wall, 0.16), (radius + taper - wall, height + 0.5)])
    major, minor = draw(0.32, 0.4), draw(0.09, 0.115)
    handle = ring((radius, 0, height * draw(0.48, 0.54)), major, minor, axis=1)
    return {"body": cut(outer, inner), "handle": cut(handle, inner)}


def _vase(draw: Draw) -> Parts:
    belly, neck, lip = draw(0.62, 0.8), draw(0.24, 0.32), draw(0.36, 0.46)
    low, high = draw(0.6, 0.8), draw(1.5, 1.7)
    outline = [(draw(0.34, 0.44), 0), (belly, low), (neck, high), (lip, high + 0.4)]
    hole = [(neck - 0.1, high - 0.5), (neck - 0.1, high), (lip - 0.1, high + 0.41)]
    return {"body": cut(lathe(smooth_curve(outline, 5)), lathe([*hole, (lip - 0.1, high + 0.8)]))}


def _bottle(draw: Draw) -> Parts:
    body, neck = draw(0.42, 0.5), draw(0.16, 0.2)
    shoulder, top = draw(1.2, 1.4), draw(2.1, 2.3)
    outline = [
        *((body - 0.08, 0), (body, 0.08), (body, shoulder), (0.5 * (body + neck), shoulder + 0.28)),
        *((neck, shoulder + 0.5), (neck, top)),
    ]
    cap = neck + draw(0.03, 0.06)
    return {
        "body": lathe(outline, 0.02),
        "cap": tube((0, 0, top - 0.05), (0, 0, top + 0.22), cap, 0.03),
    }


def _lamp(draw: Draw) -> Parts:
    pole_top, bottom, top = draw(1.3, 1.5), draw(0.65, 0.8), draw(0.32, 0.45)
    height = draw(0.75, 0.95)
    shade = [(bottom, pole_top), (top, pole_top + height)]
    foot = draw(0.45, 0.55)
    return {
        "shade": lathe(shade, 0.03),
        "pole": tube((0, 0, 0.05), (0, 0, pole_top + 0.1), draw(0.1, 0.13)),
        "foot": tube((0, 0, 0), (0, 0, draw(0.16, 0.22)), foot, 0.05),
    }


def _snowman(draw: Draw) -> Parts:
    low, middle, head = draw(0.66, 0.74), draw(0.47, 0.53), draw(0.35, 0.4)
    z1 = low + (low + middle) * draw(0.72, 0.8)
    z2 = z1 + (middle + head) * draw(0.74, 0.82)
    face = -head
    brim = z2 + head * 0.75
    eyes = (ball((s * 0.14, face * 0.87, z2 + 0.12), 0.065) for s in (-1, 1))
    buttons = (ball((0, -middle * 0.97, z1 + d), 0.07) for d in (-0.12, 0.14))
    nose = capsule((0, face * 0.9, z2), (0, face - draw(0.22, 0.32), z2 - 0.03), 0.08)
    hat = join(
        tube((0, 0, brim - 0.05), (0, 0, brim + 0.07), head * 1.12, 0.03),
        tube((0, 0, brim), (0, 0, brim + draw(0.4, 0.5)), head * 0.72, 0.03),
    )
    return {
        "body": join(ball((0, 0, low), low), ball((0, 0, z1), middle), ball((0, 0, z2), head)),
        "hat": hat,
        "nose": nose,
        "buttons": join(*eyes, *buttons),
    }


def _mushroom(draw: Draw) -> Parts:
    cap, height, stem = draw(0.85, 1.0), draw(0.85, 1.1), draw(0.24, 0.32)
    dome = draw(0.6, 0.8)
    under = box((0, 0, height - 2), (2, 2, 2))
    return {
        "cap": cut(ellipsoid((0, 0, height), (cap, cap, dome)), under),
        "stem": lathe([(stem * 1.25, 0), (stem, 0.4), (stem * 0.95, height + 0.1)], 0.02),
    }


def _house(draw: Draw) -> Parts:
    x, y, wall = draw(0.85, 1.05), draw(0.65, 0.8), draw(0.85, 1.05)
    ridge, eave = wall + draw(0.55, 0.75), draw(0.1, 0.16)
    roof = [(-y - eave, wall - 0.04), (y + eave, wall - 0.04), (0, ridge + 0.04)]
    cx = x * draw(0.45, 0.6)
    windows = (box((s * x * 0.58, -y, wall * 0.56), (x * 0.2, 0.05, wall * 0.18)) for s in (-1, 1))
    return {
        "walls": box((0, 0, wall / 2), (x, y, wall / 2)),
        "roof": prism(roof, 0, x + eave),
        "chimney": box((cx, y * 0.35, ridge - 0.1), (0.13, 0.13, 0.35)),
        "door": box((0, -y, wall * 0.32), (x * 0.19, 0.08, wall * 0.32)),
        "windows": join(*windows),
    }


def _dumbbell(draw: Draw) -> Parts:
    grip, bar, inner, outer = draw(0.45, 0.6), draw(0.13, 0.17), draw(0.4, 0.55), draw(0.42, 0.55)
    if draw.chance(0.5):
        ends = [tube((s * grip, 0, 0), (s * (grip + outer), 0, 0), inner, 0.06) for s in (-1, 1)]
    else:
        ends = [ball((s * (grip + inner * 0.8), 0, 0), inner) for s in (-1, 1)]
    return {"weights": join(*ends), "bar": tube((-grip - 0.1, 0, 0), (grip + 0.1, 0, 0), bar)}


def _rocket(draw: Draw) -> Parts:
    radius, shoulder, tip = draw(0.36, 0.44), draw(1.3, 1.5), draw(2.2, 2.5)
    hull = [(radius * 0.75, 0.2), (radius, 0.6), (radius, shoulder)]
    split = shoulder + 0.12
    nose = [(radius, shoulder), (radius * 0.75, shoulder + (tip - shoulder) * 0.5), (0.03, tip)]
    reach, high = radius + draw(0.38, 0.5), draw(0.7, 0.85)
    fin = [(0, 0.2), (reach, 0.0), (reach, 0.32), (0, high)]
    mirrored = [(-a, b) for a, b in reversed(fin)]
    fins = (prism(f, axis, 0.08) for axis in (0, 1) for f in (fin, mirrored))
    return {
        "hull": lathe(smooth_curve(hull, 4)),
        "nose": cut(lathe(smooth_curve(nose, 5)), box((0, 0, split - 1), (1, 1, 1))),
        "fins": join(*fins),
        "nozzle": tube((0, 0, 0.05), (0, 0, 0.3), radius * 0.6),
    }


def _tree(draw: Draw) -> Parts:
    wide, trunk, step = draw(0.7, 0.85), draw(0.7, 0.9), draw(0.45, 0.52)
    tiers = (
        lathe([(0, z), (r, z), (0, z + r * 1.15)], 0.03)
        for z, r in ((trunk, wide), (trunk + step, wide * 0.8), (trunk + 2 * step, wide * 0.6))
    )
    return {
        "leaves": join(*tiers),
        "trunk": tube((0, 0, 0), (0, 0, trunk + 0.2), draw(0.17, 0.23), 0.02),
    }


FAMILIES: dict[str, Callable[[Draw], Parts]] = {
    "ball": _ball,
    "cube": _cube,
    "torus": _torus,
    "cylinder": _cylinder,
    "cone": _cone,
    "table": _table,
    "chair": _chair,
    "armchair": _armchair,
    "mug": _mug,
    "vase": _vase,
    "bottle": _bottle,
    "lamp": _lamp,
    "snowman": _snowman,
    "mushroom": _mushroom,
    "house": _house,
    "dumbbell": _dumbbell,
    "rocket": _rocket,
    "tree": _tree,
}

STRETCH = {"tall": (0.82, 0.82, 1.25), "flat": (1.12, 1.12, 0.62), "wide": (1.4, 0.95, 0.95)}


def build(noun: str, adjective: str, draw: Draw, jitter: float = 0.06) -> Shape:
    """A random object of the noun's family, normalised (see ``normalised``).

    ``adjective`` is a word of ``STRETCH`` or empty. ``jitter`` spreads the size about the norm.
    """
    shape = normalised(FAMILIES[noun](draw), _stretch(adjective, draw))
    size = draw(1 - jitter, 1 + jitter)
    x, y, z = shape.scale
    return Shape(shape.parts, shape.center, (x * size, y * size, z * size))


def _stretch(adjective: str, draw: Draw) -> tuple[float, float, float]:
    if not adjective:
        return 1.0, 1.0, 1.0
    x, y, z = STRETCH[adjective]
    return x * draw(0.96, 1.04), y * draw(0.96, 1.04), z * draw(0.96, 1.04)


def normalised(parts: Parts, stretch: tuple[float, float, float] = (1.0, 1.0, 1.0)) -> Shape:
    """Bounding-box centre at the origin, bounding sphere about it of radius ``NORMAL_RADIUS``."""
    points = surface_points(lambda p: torch.stack([s(p) for s in parts.values()]).amin(0))
    low, high = points.amin(0), points.amax(0)
    center = (low + high) / 2
    radius = ((points - center) * points.new_tensor(stretch)).norm(dim=1).max().item()
    scale = NORMAL_RADIUS / radius
    x, y, z = stretch
    a, b, c = center.tolist()
    return Shape(parts, (a, b, c), (x * scale, y * scale, z * scale))


def surface_points(
    sdf: Callable[[Tensor], Tensor], reach: float = 3.2, cells: int = 56
) -> Float[Tensor, "n 3"]:
    """Points on the surface, found on a lattice over x, y in ±reach/2, z in [-reach/2, reach]."""
    side = torch.linspace(-reach / 2, reach / 2, cells)
    high = torch.linspace(-reach / 2, reach, cells * 3 // 2)
    lattice = torch.stack(torch.meshgrid(side, side, high, indexing="ij"), -1).reshape(-1, 3)
    near = lattice[sdf(lattice).abs() < reach / cells]
    for _ in range(3):
        near = near - sdf(near)[:, None] * gradient(sdf, near)
    return near[sdf(near).abs() < 0.01]


def gradient(
    sdf: Callable[[Tensor], Tensor], points: Float[Tensor, "n 3"], step: float = 2e-3
) -> Float[Tensor, "n 3"]:
    """The SDF's unit gradient by four taps at the corners of a tetrahedron (Quilez)."""
    taps = points.new_tensor([[1, -1, -1], [-1, -1, 1], [-1, 1, -1], [1, 1, 1]])
    values = sdf((points[None] + step * taps[:, None]).reshape(-1, 3)).view(4, -1)
    return torch.nn.functional.normalize(values.T @ taps, dim=1)
