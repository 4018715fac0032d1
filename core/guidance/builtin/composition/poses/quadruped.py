"""The anatomy of an animal that stands on four legs."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
import torch
from jaxtyping import Bool, Float, Int
from scipy import ndimage
from torch import Tensor

from core.geometry.parts.assembly import KnownParts
from core.guidance.builtin.composition.placing.placement import Body

LEVELS = 64  # heights to search
ACROSS, DEEP = 24, 72  # places at each, from the middle to the side, from front to back
FIRST = 0.05  # of the height, from below: the level to search for legs
LEAST = 0.05  # of the height: the shortest leg
# Times a leg's usual area, and its depth: it is the trunk.
WIDER, LONGER = 1.7, 1.4
HIP = 0.8  # of its radius above its top: a leg's joint
ROOM = 0.7  # of its radius, around a leg: for its hoof

Area = Bool[np.ndarray, "x y"]


class Leg(NamedTuple):
    """The left leg of a pair, which is upright; training units."""

    low: Float[Tensor, " 3"]  # the corners of its box
    high: Float[Tensor, " 3"]
    hoof: float  # z below which nothing else is around it
    middle: Float[Tensor, " 2"]  # of its upper half, x and y
    radius: float  # of its upper half
    above: float  # z of the trunk's top over it

    @property
    def joint(self) -> Float[Tensor, " 3"]:
        """In the trunk."""
        return torch.cat([self.middle, (self.high[2] + HIP * self.radius)[None]])

    @property
    def hidden(self) -> float:
        """How far it goes on in the trunk, above its joint."""
        return max(self.above - float(self.joint[2]) - self.radius, 0.0)

    @property
    def room(self) -> Float[Tensor, " 3"]:
        """Around it, for its hoof."""
        return torch.tensor([ROOM * self.radius, ROOM * self.radius, 0.0])


@dataclass(frozen=True)
class Quadruped:
    """Two pairs of legs, and the trunk that they carry; training units."""

    front: Leg
    hind: Leg
    belly: float  # z, between the legs
    spine: float

    @classmethod
    def of(cls, body: Body, parts: KnownParts) -> "Quadruped | None":
        """Of a drawn animal; None without four legs that are apart."""
        grid = _Grid(body, lambda points: parts.distances(points).amin(1))
        found = grid.legs()
        if found is None:
            return None
        front, hind = found
        middle = float(front.middle[1] + hind.middle[1]) / 2
        return cls(front, hind, *grid.column(0.0, middle))


class _Grid:
    """Where a body is inside on both sides of x = 0."""

    def __init__(self, body: Body, distance: Callable[[Tensor], Tensor]) -> None:
        (low, high), self.height = body.box, float(body.sides[2])
        wide = float(torch.maximum(low.abs(), high.abs())[0])
        self.x = torch.linspace(0, wide, ACROSS)
        self.y = torch.linspace(float(low[1]), float(high[1]), DEEP)
        self.z = torch.linspace(float(low[2]), float(high[2]), LEVELS)
        nodes = torch.stack(torch.meshgrid(self.z, self.x, self.y, indexing="ij"), -1)
        points = nodes[..., [1, 2, 0]].reshape(-1, 3)
        mirrored = points * torch.tensor([-1.0, 1.0, 1.0])
        found = torch.maximum(distance(points), distance(mirrored))
        self.inside: Bool[np.ndarray, "z x y"] = (found < 0).view(LEVELS, ACROSS, DEEP).numpy()
        self.first = round(FIRST * LEVELS)

    def legs(self) -> tuple[Leg, Leg] | None:
        """The front one and the hind one."""
        labels = _labels(self.inside[self.first])
        apart = range(1, int(labels.max()) + 1)
        feet = [labels == k for k in apart if not (labels[0] == k).any()]
        if len(feet) != 2:
            return None
        feet.sort(key=lambda foot: float(foot.nonzero()[1].mean()))
        front, hind = self._leg(feet[0]), self._leg(feet[1])
        return (front, hind) if front and hind else None

    def _leg(self, foot: Area) -> Leg | None:
        """Upwards from a foot, as long as it gets no wider."""
        areas = [foot]
        for level in range(self.first + 1, LEVELS):
            labels = _labels(self.inside[level])
            own = np.isin(labels, labels[areas[-1] & (labels > 0)])
            if not own.any() or self._is_wider(own, areas):
                break
            areas.append(own)
        top = float(self.z[self.first + len(areas) - 1])
        if len(areas) < 2 or top - float(self.z[0]) < LEAST * self.height:
            return None
        upper = areas[len(areas) // 2 :]
        cells = torch.stack([self.x[1], self.y[1] - self.y[0]])
        start = torch.stack([self.x[0], self.y[0]])
        at = np.concatenate([np.argwhere(area) for area in upper]).mean(0)
        middle = start + torch.from_numpy(at).float() * cells
        area = float(np.median([area.sum() for area in upper])) * float(cells.prod())
        radius = (area / np.pi) ** 0.5
        places = torch.from_numpy(np.argwhere(np.any(areas, 0)))
        low = start + (places.amin(0) - 1) * cells
        high = start + (places.amax(0) + 1) * cells
        ends = torch.tensor([[float(self.z[0]) - radius], [top]])
        low, high = torch.cat([torch.stack([low, high]), ends], 1).unbind()
        hoof = self._apart(areas, low - ROOM * radius, high + ROOM * radius)
        return Leg(low, high, hoof, middle, radius, self.column(*middle.tolist())[1])

    @staticmethod
    def _is_wider(own: Area, areas: list[Area]) -> bool:
        """Whether the trunk begins: wider than the leg below, or longer."""
        deep = own.any(0).sum() > LONGER * np.median([area.any(0).sum() for area in areas])
        return bool(deep or own.sum() > WIDER * np.median([area.sum() for area in areas]))

    def _apart(self, areas: list[Area], low: Tensor, high: Tensor) -> float:
        """The z up to which a box has nothing but the leg of these areas."""
        across = (self.x >= low[0]) & (self.x <= high[0])
        deep = (self.y >= low[1]) & (self.y <= high[1])
        box = (across[:, None] & deep).numpy()
        for level, area in enumerate(areas, self.first):
            if (self.inside[level] & ~area & box).any():
                return float(self.z[level - 1])
        return float(self.z[self.first + len(areas) - 1])

    def column(self, x: float, y: float) -> tuple[float, float]:
        """The lowest and the highest z of the trunk at such a place."""
        i, j = int((self.x - x).abs().argmin()), int((self.y - y).abs().argmin())
        labels = _labels(self.inside[:, i, j])
        sizes = np.bincount(labels)[1:]
        runs = (labels == sizes.argmax() + 1).nonzero()[0] if len(sizes) else np.array([0])
        return float(self.z[runs[0]]), float(self.z[runs[-1]])


def _labels(inside: Bool[np.ndarray, "*n"]) -> Int[np.ndarray, "*n"]:
    """The number of each place's connected area, from 1 on; 0 outside."""
    labels = np.zeros(inside.shape, np.int32)
    ndimage.label(inside, output=labels)
    return labels
