"""Animals on four legs in another pose than standing: sitting, lying, rearing, running."""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property, partial
from typing import NamedTuple

import torch
from jaxtyping import Float
from torch import Tensor

from core.geometry.fan import Fan
from core.geometry.union import Region
from core.guidance.builtin.composition.placing.placement import Body, Placement
from core.guidance.builtin.composition.placing.wearing import head_of
from core.guidance.builtin.composition.poses.limbs import (
    DOWN,
    SIDES,
    Box,
    degrees,
    mirrored,
    turned,
)
from core.guidance.builtin.composition.poses.posing import Bone, Pose, joint
from core.guidance.builtin.composition.poses.quadruped import Leg, Quadruped
from core.guidance.builtin.composition.thing import Thing
from core.guidance.builtin.words.phrases.poses import PoseWord

FRONT, HIND = 0, 1
HEAD = 0.5  # of its width, from the middle
OF_HEADS = tuple("eyes ears muzzle snout nose horns horn antlers frill bill tusks".split())
WITHERS = 0.55  # of the way from the front legs to the spine: the axis of the neck
ENDS = [0.03, 0.97]  # quantiles of a head's points
CHEST = math.radians(15)  # what is over the front legs bends too
MOST = math.radians(176)
TILTS = (45, 40, 50, 35, 55, 30, 60, 25, 65, 20, 15)  # degrees, of a sitting trunk, the best first
SUNK = 0.5  # of a front leg's radius: how far it may go into the ground on the way to it
RUMP = 2.0  # radii of a hind leg: how far the trunk goes on behind it
LONGEST = {FRONT: 4.2, HIND: 3.2}  # radii: what is seen of a leg on the ground
APART = {FRONT: 0.2, HIND: 0.7}  # radii: how far it is moved aside
GRAZED = range(75, 20, -5)  # degrees


class Swing(NamedTuple):
    """A leg's direction in degrees from downwards, forward and outwards; the z of its joint, where
    it is on the ground; how far it comes out of the trunk."""

    forward: float
    outwards: float = 0.0
    ground: float | None = None
    out: float = 0.0


Swings = Sequence[tuple[Swing, Swing]]  # of the front pair and the hind one: left, right


@dataclass(frozen=True)
class Animal:
    """An animal at rest, and where its bones part."""

    body: Body
    pairs: tuple[Leg, Leg]  # the front and the hind one
    belly: float  # z
    spine: float
    padded: float = 0.0  # training units, around the legs: for clothes

    @classmethod
    def of(cls, thing: Thing, body: Body) -> "Animal | None":
        """Of a drawn one; None without four legs that are apart."""
        parts = thing.parts()
        legs = parts and Quadruped.of(body, parts)
        return cls(body, (legs.front, legs.hind), legs.belly, legs.spine) if legs else None

    @property
    def sole(self) -> float:
        """The ground's z."""
        return float(self.body.box[0, 2])

    @property
    def hip(self) -> Float[Tensor, " 3"]:
        """Between the hind legs' joints."""
        return self.pairs[HIND].joint * torch.tensor([0.0, 1.0, 1.0])

    @cached_property
    def neck(self) -> Float[Tensor, " 2"]:
        """The axis about which the head is raised, y and z."""
        leg = self.pairs[FRONT]
        low = float(leg.high[2])
        return torch.tensor([float(leg.middle[1]), low + WITHERS * (self.spine - low)])

    def bend(self, by: float) -> Fan:
        """The bend that raises the head by so many degrees."""
        y, z = self.neck.tolist()
        leg, head = self.pairs[FRONT], head_of(self.body)
        verts = self.body.verts
        own = (verts - head.middle).norm(dim=1) < HEAD * head.wide
        own |= self.body.among(*OF_HEADS) | (self.body.among("mane") & self._has_ruff)
        own &= (verts[:, 1] < self.between) & (verts[:, 2] > leg.high[2])
        back = verts[(verts[:, 1] > self.between) & (verts[:, 2] > z)]
        angles = self._angles(verts[own])
        low, high = angles.quantile(torch.tensor(ENDS)).tolist()
        above = min(MOST, float(self._angles(back).amin()) if len(back) else MOST)
        below = math.atan2(float(leg.high[2]) - z, y - float(leg.low[1])) - CHEST
        high = min(high, above - 1e-2)
        return Fan(self.neck, below, max(low, below + 1e-2), high, above, math.radians(by))

    def _angles(self, points: Float[Tensor, "n 3"]) -> Float[Tensor, " n"]:
        """Around the neck, from forward upwards."""
        y, z = self.neck
        return torch.atan2(points[:, 2] - z, y - points[:, 1])

    @property
    def between(self) -> float:
        """y in the middle between the pairs of legs."""
        return float(self.pairs[FRONT].middle[1] + self.pairs[HIND].middle[1]) / 2

    @property
    def _has_ruff(self) -> bool:
        """Whether its mane is around the head, as a lion's, not along the neck."""
        aside, leg = self.body.of_parts("mane")[:, 0].abs(), self.pairs[FRONT]
        return len(aside) > 0 and float(aside.amax()) > float(leg.middle[0]) + leg.radius

    def posed(self, trunk: Placement, swings: Swings, head: float) -> Pose:
        """The pose with the trunk in such a place and the head raised by so many degrees against
        it; without ``swings`` the legs are as they are."""
        bones, cut = [], []
        for pair, both in enumerate(swings):
            for side, swing in zip(SIDES, both, strict=True):
                cut += [Region(box) for box in _boxes(self.pairs[pair], side, self.padded)]
                bones.append(self._leg(pair, side, swing, trunk))
        whole = Bone(tuple(cut), trunk, within=False, bend=self.bend(head))
        return Pose((whole, *bones))

    def _leg(self, pair: int, side: int, swing: Swing, trunk: Placement) -> Bone:
        leg, turn = self.pairs[pair], _turned(swing.forward, swing.outwards, side)
        upper, lower = _boxes(leg, side, self.padded)
        at = mirrored(leg.joint, side)
        start, end = torch.stack([at[0], at[1], leg.high[2]]), at
        to = trunk.out(at[None])[0]
        if swing.ground is not None:  # the rest of it is in the trunk
            length = min(float(at[2]) - self.sole, LONGEST[pair] * leg.radius)
            start = end = at = torch.stack([at[0], at[1], torch.tensor(self.sole + length)])
            upper, lower = (_below(box, float(at[2])) for box in (upper, lower))
            aside = side * APART[pair] * leg.radius
            to = torch.stack([to[0] + aside, to[1], torch.tensor(swing.ground)])
        elif swing.out > 0:
            end = at - leg.hidden * DOWN
        capsule = (start, end, leg.radius + self.padded)
        place = joint(at, turn, to + swing.out * (turn @ DOWN))
        top = float(leg.high[2]) - leg.radius / 2 if swing.out > 0 else math.inf
        return Bone((Region(upper, (capsule,)), Region(lower)), place, top=top)


def _below(box: Box, z: float) -> Box:
    """A box's lower end."""
    low, high = box
    high = torch.stack([high[0], high[1], high[2].clamp_max(z)])
    return torch.stack([low[0], low[1], low[2].clamp_max(z - 1e-3)]), high


def _boxes(leg: Leg, side: int, padded: float) -> tuple[Box, Box]:
    """A leg's box, and a wider one for its hoof."""
    around = torch.tensor([padded, padded, 0.0])
    ends = torch.stack([leg.low - around, leg.high + around])
    wide = torch.stack([ends[0] - leg.room, ends[1] + leg.room])
    wide[0, 0] = wide[0, 0].clamp_min(0.0)
    wide[1, 2] = leg.hoof
    upper, lower = (mirrored(of, side) for of in (ends, wide))
    return (upper.amin(0), upper.amax(0)), (lower.amin(0), lower.amax(0))


def _turned(forward: float, outwards: float = 0.0, side: int = 1) -> Float[Tensor, "3 3"]:
    """A rotation in degrees: a head goes up, a leg forward, then outwards."""
    return turned(degrees(forward, outwards), side)


def _sits(animal: Animal) -> Pose:
    """On its rump, the front legs upright; the trunk as steep as they are long for it."""
    front, hind = animal.pairs
    verts = animal.body.verts
    behind = verts[:, 1] - hind.middle[1]
    rump = verts[
        (verts[:, 2] > hind.high[2]) & (behind > -hind.radius) & (behind < RUMP * hind.radius)
    ]
    found = []
    for tilt in TILTS:
        trunk = joint(animal.hip, _turned(tilt), animal.hip)
        ground = float(trunk.out(rump)[:, 2].amin())
        shoulder = float(trunk.out(front.joint[None])[0, 2])
        out = shoulder - ground - (float(front.joint[2]) - animal.sole)
        over = max(out - front.hidden, -out - SUNK * front.radius, 0.0)
        found.append((over, tilt, trunk, ground, out))
    _, tilt, trunk, ground, out = min(found, key=lambda one: one[0])
    ahead = Swing(88, 14, ground + hind.radius)
    upright = Swing(0, out=out)
    return animal.posed(trunk, [(upright, upright), (ahead, ahead)], 8 - tilt)


def _lies(animal: Animal, head: float = 0) -> Pose:
    """On its belly, the legs forward."""
    front, hind = (animal.belly + leg.radius for leg in animal.pairs)
    swings = Swing(90, 4, front), Swing(90, 10, hind)
    return animal.posed(Placement.of(), [(swing, swing) for swing in swings], head)


def _moves(animal: Animal, angles: Sequence[float], tilt: float = 0, head: float = 0) -> Pose:
    """The legs forward by so many degrees, from the left front one to the right hind one."""
    swings = [Swing(angle) for angle in angles]
    trunk = joint(animal.hip, _turned(tilt), animal.hip)
    return animal.posed(trunk, [(swings[0], swings[1]), (swings[2], swings[3])], head - tilt)


def _looks(animal: Animal, up: float) -> Pose:
    """Standing, the head raised by so many degrees."""
    return animal.posed(Placement.of(), (), up)


def _grazes(animal: Animal) -> Pose:
    """Its muzzle on the ground, or as low as it gets."""
    head = animal.body.verts[animal.body.among(*OF_HEADS)]
    low = (float(animal.bend(-angle).out(head)[:, 2].amin()) for angle in GRAZED)
    pairs = zip(GRAZED, low, strict=True)
    return _looks(animal, -next((angle for angle, z in pairs if z >= animal.sole), GRAZED[-1]))


POSES: dict[PoseWord, Callable[[Animal], Pose]] = {
    "sitting": _sits,
    "lying": _lies,
    "sleeping": partial(_lies, head=-28),
    "rearing": partial(_moves, angles=(70, 45, 5, 5), tilt=55, head=25),
    "running": partial(_moves, angles=(55, 25, -50, -22)),
    "walking": partial(_moves, angles=(22, -20, -22, 20)),
    "leaping": partial(_moves, angles=(65, 55, -60, -50), tilt=18, head=8),
    "howling": partial(_looks, up=42),
    "roaring": partial(_looks, up=22),
    "grazing": _grazes,
    "flying": partial(_moves, angles=(-50, -38, -62, -50), tilt=12, head=0),
}


def pose_of(animal: Animal) -> Pose:
    """The stated pose of an animal."""
    return POSES[animal.body.words.pose](animal)
