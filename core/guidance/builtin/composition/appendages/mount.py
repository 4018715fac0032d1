"""Where appendages grow on a body: measured once, for all of them."""

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
from jaxtyping import Float

from core.guidance.builtin.composition.clothes.measurements import BARE, stands_upright
from core.guidance.builtin.composition.placing.placement import Body
from core.guidance.builtin.composition.placing.resting import OVER_THE_RIM
from core.guidance.builtin.composition.placing.wearing import head_of, neck_of
from core.guidance.builtin.words.companions.known_as import is_dressed

Point = Float[np.ndarray, " 3"]

SHOULDERS = 0.16  # of the height from the ground to the neck, below the neck: an upright body's
RUMP = 0.4  # of the way from the ground to the neck: where its tail begins
WITHERS = (0.6, 0.3)  # behind the head's middle: of its width, of the way to the rear, at least
ACROSS, NEAR = 0.35, 0.08  # of an animal's half width: its wings' distance; of a size: a column
SIDES = 0.62  # of a thing's height: its wings'
REAR = 0.6  # of an animal's height at its rear: where its tail begins
CROWN = 0.62  # of the head's width, above its eyes, at most
OUTSIDE = (*OVER_THE_RIM, "wheels", "spout", "lid", "mirrors")  # parts without wings
SLIM = 0.24  # of the size: a horse's head is no narrower here
CLOSEST = 0.05  # training units: a column of a drawn body has points
SUNK = 0.02  # training units, into the body
LEAST = 0.04  # of the size: half the distance of an upright body's wings


@dataclass(frozen=True)
class Mount:
    """Places on a body, training units: x to its left, y to its rear, z up."""

    size: float  # its height; on all fours its length
    stands: bool  # or it is on all fours
    sideways: bool  # its wings are at its sides, as a thing's without a back are
    shoulder: Point  # where the wing at x > 0 begins
    rump: Point  # where a tail begins
    head: Point  # the middle of the head
    wide: float  # the head's width
    top: float  # z
    crown: Callable[[float, float], float]  # z of the head's surface at (x, y)

    @classmethod
    def of(cls, body: Body) -> "Mount":
        """Of a drawn body."""
        alive = is_dressed(body.words.noun)
        head, rest = head_of(body), body.without(*(BARE if alive else OUTSIDE))
        middle = head.middle.double().numpy()
        points = rest.double().numpy()
        low, high = points.min(0), points.max(0)
        stands = stands_upright(rest, head)
        sides = high - low
        size = (
            float(sides[2] if stands else sides[1]) if alive else float(sides.max() + sides[2]) / 2
        )
        column = _Column(points, NEAR * size)
        if not alive:
            z = low[2] + SIDES * (high[2] - low[2])
            y = (low[1] + high[1]) / 2
            at = column.side(y, z)
            shoulder, rump = np.array([at - SUNK, y, z]), np.array([middle[0], high[1] - SUNK, z])
        elif stands:
            neck = float(neck_of(body, head).middle[2])
            z = neck - SHOULDERS * (neck - low[2])
            back = column.behind(middle[0], z) - SUNK
            below = low[2] + RUMP * (neck - low[2])
            shoulder = np.array([middle[0] + LEAST * size, back, z])
            rump = np.array([middle[0], column.behind(middle[0], below) - SUNK, below])
        else:
            y = middle[1] + max(WITHERS[0] * head.wide, WITHERS[1] * (high[1] - middle[1]))
            top = column.above(middle[0], y)
            wide = column.side(y, top - NEAR * size) - middle[0]
            shoulder = np.array([middle[0] + ACROSS * wide, y, top])
            shoulder[2] = column.above(shoulder[0], y) - SUNK
            end = high[1] - NEAR * size / 2
            z = low[2] + REAR * (column.above(middle[0], end) - low[2])
            rump = np.array([middle[0], column.behind(middle[0], z) - SUNK, z])
        scalp = _Column(body.without(*BARE).double().numpy(), NEAR * head.wide)

        highest = min(head.top, head.eyes + CROWN * head.wide)  # a rabbit's ears are higher

        def crown(x: float, y: float) -> float:
            return min(scalp.above(x, y), highest)

        wide = max(head.wide, SLIM * size) if alive else head.wide
        return cls(size, stands, not alive, shoulder, rump, middle, wide, highest, crown)

    @classmethod
    def alone(cls) -> "Mount":
        """Of a ball in place of a head, and of nothing else: for what is made by itself."""
        origin = np.zeros(3)

        def crown(x: float, y: float) -> float:
            return float(np.sqrt(max(0.25 - x * x - y * y, 0.0)))

        return cls(2.0, True, False, np.array([0.1, 0, 0]), origin, origin, 1.0, 0.5, crown)

    def times(self, factor: float) -> "Mount":
        """The same for appendages of another size."""
        return replace(self, size=factor * self.size, wide=factor * self.wide)


class _Column:
    """The surface's extent around a line along an axis."""

    def __init__(self, points: Float[np.ndarray, "n 3"], near: float) -> None:
        self.points, self.near = points, max(near, CLOSEST)

    def above(self, x: float, y: float) -> float:
        """The highest z near (x, y)."""
        return self._farthest(2, {0: x, 1: y})

    def behind(self, x: float, z: float) -> float:
        """The largest y near (x, z)."""
        return self._farthest(1, {0: x, 2: z})

    def side(self, y: float, z: float) -> float:
        """The largest x near (y, z)."""
        return self._farthest(0, {1: y, 2: z})

    def _farthest(self, axis: int, at: dict[int, float]) -> float:
        off = np.max([np.abs(self.points[:, k] - value) for k, value in at.items()], axis=0)
        here = off < max(self.near, float(off.min()))
        return float(self.points[here | (off == off.min()), axis].max())
