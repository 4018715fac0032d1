"""The legs of a standing figure: two mirrored limbs from the crotch to the soles."""

from collections.abc import Callable
from dataclasses import dataclass

import torch
from jaxtyping import Float
from torch import Tensor

from core.geometry.parts.assembly import KnownParts
from core.guidance.builtin.composition.placing.holding import HANDED
from core.guidance.builtin.composition.placing.placement import Body
from core.guidance.builtin.palette import looks

# Characters without two legs: with others, on a block, or with two other lower ends.
NO_FIGURES = ("bone", "tooth", "hand", "mermaid", "centaur", "griffin", "nutcracker")
# Parts that hang down next to or behind the legs.
HANGING = tuple(
    """cape wings shield sword katana rifle staff wand axe pack cannons flag hilt tail tails plume
    scarf beard hair cloak scythe gun bow quiver broom""".split()
)
LEVELS, UP_TO = 48, 0.6  # heights to search; of the height, where they end
ACROSS, DEEP = 32, 44  # places at each, from the middle to the side, from front to back
WIDE = 0.3  # of the height: legs are not farther aside
# Of the height, from below: the level to search for legs; their least length.
FIRST, LEAST = 0.09, 0.09
# The body's depth in the middle as a fraction of a leg's: the most between two legs, even where
# they touch.
BETWEEN = 0.75
DEEPER = 0.012  # training units, at the crotch
HEM = 1.45  # of a leg's usual thickness
ASIDE = 0.07  # training units: largest shift of a leg's middle between heights
MARGIN = 0.045  # training units, around the legs
THICK = 3.0  # of a leg's radius: how far from its middle it goes sideways and to the back
ROUND = 1.3  # of its radius: how far it goes to the front, at least
HIP = 0.8  # of its radius above the crotch
OFF_AXIS = 0.02  # training units, at least
KNEED = 2.4  # radii: a leg as long as this has a knee


@dataclass(frozen=True)
class Legs:
    """The right and the left leg, mirrored; training units, x from the axis."""

    box: Float[Tensor, "2 3"]  # around the left one, from the middle between the two
    middle: Float[Tensor, " 2"]  # of the left one, x and y
    radius: float
    crotch: float  # z
    square: bool = False  # as a robot's are
    axis: float = 0.0  # x of the middle between them: a waving figure is off its box's middle

    @property
    def half(self) -> float:
        """Half the width of both together."""
        return float(self.middle[0]) + self.radius

    @property
    def sole(self) -> float:
        """The lowest z."""
        return float(self.box[0, 2]) + MARGIN

    @property
    def hip(self) -> Float[Tensor, " 3"]:
        """The left joint in the pelvis."""
        return torch.cat([self.middle, torch.tensor([self.crotch + HIP * self.radius])])

    @property
    def knee(self) -> Float[Tensor, " 3"] | None:
        """The left joint halfway down; None where the leg is too short for one."""
        if self.crotch - self.sole < KNEED * self.radius:
            return None
        return self.halfway

    @property
    def halfway(self) -> Float[Tensor, " 3"]:
        """Where the left knee is, in however short a leg."""
        return torch.cat([self.middle, torch.tensor([(float(self.hip[2]) + self.sole) / 2])])


def legs_of(body: Body, parts: KnownParts) -> Legs | None:
    """The legs of a drawn figure; None without legs, such as a queen's in a dress."""
    noun = body.words.noun
    if noun not in HANDED or noun in NO_FIGURES:
        return None
    kept = [k for k, name in enumerate(looks(noun)) if name not in HANGING]
    by = torch.tensor([_axis(body), 0.0, 0.0])
    sides = _Sides(body, lambda points: parts.distances(points + by)[:, kept].amin(1))
    levels = sides.legs()
    low, height = float(body.box[0, 2]), float(body.sides[2])
    if not levels:
        return None
    levels = sides.parted(levels)
    crotch = float(sides.z[levels[-1]] + sides.z[levels[-1] + 1]) / 2
    if crotch - low < LEAST * height:
        return None
    upper = levels[len(levels) // 2 :]
    x, y = (float(torch.tensor(of).median()) for of in sides.cores(upper))
    radius = float(torch.tensor([sides.radius(k) for k in upper]).median())
    runs = [sides.run(k) for k in range(levels[len(levels) // 2] + 1)]  # not a coat's hem
    wide, front, back = zip(*[run for run in runs if run], strict=True)
    front = min(*front, y - ROUND * radius) - MARGIN
    wide, back = (min(max(far), at + THICK * radius) + MARGIN for far, at in ((wide, x), (back, y)))
    corners = [[0.0, front, low - MARGIN], [wide, back, crotch]]
    core = torch.tensor([[x, y, (crotch + low) / 2]]) + by
    part = int(parts.distances(core)[0, : len(parts.forms.flat)].argmin())
    square = parts.forms.faces(part).block
    axis = float(by[0])
    return Legs(torch.tensor(corners), torch.tensor([x, y]), radius, crotch, square, axis)


def _axis(body: Body) -> float:
    """The middle between the feet; 0 where that is about the body's own."""
    feet = body.without(*HANGING)
    feet = feet[feet[:, 2] < body.box[0, 2] + FIRST * body.sides[2], 0]
    middle = float(feet.amin() + feet.amax()) / 2
    return middle if abs(middle) > OFF_AXIS else 0.0


class _Sides:
    """The depth of a body at each height, inside on both sides of x = 0."""

    def __init__(self, body: Body, distance: Callable[[Tensor], Tensor]) -> None:
        (low, high), height = body.box, float(body.sides[2])
        self.x = torch.linspace(0, WIDE * height, ACROSS)
        self.y = torch.linspace(float(low[1]), float(high[1]), DEEP)
        self.z = float(low[2]) + torch.linspace(0, UP_TO * height, LEVELS)
        nodes = torch.stack(torch.meshgrid(self.z, self.x, self.y, indexing="ij"), -1)
        points = nodes[..., [1, 2, 0]].reshape(-1, 3)
        mirrored = points * torch.tensor([-1.0, 1.0, 1.0])
        found = torch.maximum(distance(points), distance(mirrored))
        self.depth = -found.view(LEVELS, ACROSS, DEEP)
        self.first = int(FIRST / UP_TO * LEVELS)
        self._cores: dict[int, tuple[float, float, float]] = {}

    def legs(self) -> list[int]:
        """The levels of the legs, from the lowest that is searched up to the crotch."""
        found: list[int] = []
        before = None
        for level in range(self.first, LEVELS - 1):
            core = self._core(level, before)
            if core is None or float(self.depth[level, 0].amax()) > BETWEEN * core[2]:
                break
            self._cores[level] = before = core
            found.append(level)
        return found if len(found) > 1 else []

    def parted(self, levels: list[int]) -> list[int]:
        """The legs' levels below the trunk, which is deeper in the middle than the gap between two
        legs."""
        between = [float(self.depth[level, 0].amax()) for level in levels]
        most = max(float(torch.tensor(between).median()), 0.0) + DEEPER
        last = max((k for k, deep in enumerate(between) if deep < most), default=0)
        return self._below_hem(levels[: max(last, 1) + 1])

    def _below_hem(self, levels: list[int]) -> list[int]:
        """The levels without a hem around the legs."""
        runs = [self.run(level) or (0.0, 0.0, 0.0) for level in levels]
        cores = [self._cores[level] for level in levels]
        pairs = list(zip(runs, cores, strict=True))
        thick = torch.tensor([[run[0] - at[0], run[2] - at[1]] for run, at in pairs])
        wider = (thick > HEM * thick.median(0).values).any(1)
        while len(levels) > 2 and wider[len(levels) - 1]:
            levels = levels[:-1]
        return levels

    def _core(
        self, level: int, before: tuple[float, float, float] | None
    ) -> tuple[float, float, float] | None:
        """The deepest place of the leg at a level, x and y, and its depth."""
        depth = self.depth[level]
        if before is not None:
            depth = depth.masked_fill((self.x[:, None] - before[0]).abs() > ASIDE, -1.0)
        best = int(depth.argmax())
        i, j = best // DEEP, best % DEEP
        deep = float(depth[i, j])
        return (float(self.x[i]), float(self.y[j]), deep) if deep > 0 and i else None

    def cores(self, levels: list[int]) -> tuple[list[float], list[float]]:
        """Each level's deepest places, x and y."""
        x, y, _ = zip(*(self._cores[level] for level in levels), strict=True)
        return list(x), list(y)

    def radius(self, level: int) -> float:
        """Half the leg's width at a level, averaged over both directions."""
        x, y, deep = self._cores[level]
        run = self.run(level)
        if run is None:
            return deep
        aside, front, back = run
        return (min(aside - x, x) + min(aside - x, y - front, back - y)) / 2

    def run(self, level: int) -> tuple[float, float, float] | None:
        """How far the leg extends to the side, to the front and to the back from its core."""
        core = self._cores.get(level) or self._cores[self.first]
        i = int((self.x - core[0]).abs().argmin())
        j = int((self.y - core[1]).abs().argmin())
        inside = self.depth[level] > 0
        if not inside[i, j]:
            return None
        aside = _end(inside[i:, j])
        front, back = _end(inside[i, : j + 1].flip(0)), _end(inside[i, j:])
        return float(self.x[i + aside]), float(self.y[j - front]), float(self.y[j + back])


def _end(inside: Tensor) -> int:
    """The index of the last of the leading places that are inside."""
    outside = (~inside).nonzero()
    return int(outside[0]) - 1 if len(outside) else len(inside) - 1
