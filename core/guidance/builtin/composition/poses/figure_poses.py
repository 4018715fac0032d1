"""Figures on two legs in another pose than standing: sitting, kneeling, lying, running."""

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial

import torch
from jaxtyping import Float
from torch import Tensor

from core.guidance.builtin.composition.placing.placement import (
    Body,
    Placement,
    about_x,
    about_y,
    about_z,
)
from core.guidance.builtin.composition.poses.legs import Legs, legs_of
from core.guidance.builtin.composition.poses.limbs import (
    Limb,
    both_poses,
    degrees,
    mirrored,
    turned,
)
from core.guidance.builtin.composition.poses.posing import Bone, Distances, Pose, joint
from core.guidance.builtin.composition.thing import Thing
from core.guidance.builtin.words.phrases.poses import PoseWord

# Parts that hang around the legs and stay with the trunk; of a leg, how much they may hide.
HEMS, HIDDEN = tuple("dress apron tunic trim coat shirt shorts cloth vest leather".split()), 0.6
FLAT = range(-115, -64, 2)  # degrees: how far back one leans who lies
# Degrees, of a shin on the ground: from level upwards, as its toes point down.
FOLDED = range(-90, -131, -5)
TOES = 1.2  # radii of the leg: how far toes may be below a knee on the ground


@dataclass(frozen=True)
class Figure:
    """A figure at rest, and its legs."""

    body: Body  # its legs' axis at x = 0
    legs: Legs
    distances: Distances

    @classmethod
    def of(cls, thing: Thing, body: Body) -> "Figure | None":
        """Of a drawn one; None without two legs that are apart."""
        parts = thing.parts()
        legs = parts and legs_of(body, parts)
        if not legs or not parts:
            return None
        by = torch.tensor([legs.axis, 0.0, 0.0])
        centred = body.placed(Placement.of().moved(-by))
        return cls(centred, _below_hem(legs, centred), lambda points: parts.distances(points + by))

    @property
    def between(self) -> Float[Tensor, " 3"]:
        """The place between the hips."""
        return self.legs.hip * torch.tensor([0.0, 1.0, 1.0])

    @property
    def lengths(self) -> tuple[float, float]:
        """Of a thigh and of a shin with its shoe."""
        hip, knee = float(self.legs.hip[2]), float(self.legs.halfway[2])
        return hip - knee, knee - self.legs.sole

    def posed(self, left: Limb, right: Limb, lean: float = 0, roll: float = 0) -> tuple[Pose, Pose]:
        """The pose, and the one of garments on the legs; the trunk turned by so many degrees to the
        front and to its left."""
        turn = about_y(math.radians(roll)) @ about_x(math.radians(lean))
        trunk = joint(self.between, turn, self.between)
        bare, clothed = both_poses(self.legs, (left, right), trunk, self.distances)
        by = torch.tensor([self.legs.axis, 0.0, 0.0])
        return bare.moved(by), clothed.moved(by)


def _below_hem(legs: Legs, body: Body) -> Legs:
    """The legs without the hem of what the trunk wears, which would be torn."""
    (low, high), hem = legs.box, body.of_parts(*HEMS)
    aside = torch.stack([hem[:, 0].abs(), hem[:, 1]], 1)
    hem = hem[((aside > low[:2]) & (aside < high[:2])).all(1), 2]
    lowest = float(hem.amin()) if len(hem) else legs.crotch
    if not legs.crotch > lowest > legs.crotch - HIDDEN * (legs.crotch - legs.sole):
        return legs
    top = torch.stack([high[0], high[1], torch.tensor(lowest)])
    return replace(legs, box=torch.stack([low, top]))


def _moves(
    figure: Figure,
    left: tuple[float, ...],
    right: tuple[float, ...],
    lean: float = 0,
    roll: float = 0,
) -> tuple[Pose, Pose]:
    """Each leg in degrees: its thigh forward, its shin, and both outwards."""
    limbs = []
    for thigh, shin, *aside in (left, right):
        outwards = aside[0] if aside else 0.0
        limbs.append(Limb(degrees(thigh, outwards), degrees(shin, outwards)))
    return figure.posed(limbs[0], limbs[1], lean, roll)


def _sits(figure: Figure) -> tuple[Pose, Pose]:
    """On the ground, the legs straight before it."""
    limb = Limb(degrees(87, 14), None)
    return figure.posed(limb, limb)


def _kneels(figure: Figure) -> tuple[Pose, Pose]:
    """On the right knee, the left foot as low as it is."""
    legs, (thigh, shin) = figure.legs, figure.lengths
    knee = mirrored(legs.halfway, -1)
    lower = figure.body.verts
    lower = lower[(lower[:, 2] < knee[2]) & (lower[:, 0] < 0) & (lower[:, 0] > -legs.box[1, 0])]
    for back in FOLDED:
        low = joint(knee, turned(degrees(back)), knee).out(lower)
        if not len(lower) or float(low[:, 2].amin()) > float(knee[2]) - TOES * legs.radius:
            break
    down = max(thigh + legs.radius - shin, 0.0)
    forward = math.acos(min(down / thigh, 1.0))
    return figure.posed(Limb((forward, 0.0), degrees(0)), Limb(degrees(0), degrees(back)))


def _lies(body: Body, across: bool) -> Pose:
    """On its back, as low as it gets; its head behind, or on its left."""
    middle = body.verts.mean(0)

    def high(lean: float) -> float:
        turn = about_x(math.radians(lean)).T
        return float((middle @ turn)[2] - (body.verts @ turn)[:, 2].amin())

    lean = min(FLAT, key=high)
    turn = about_z(-math.pi / 2 if across else 0.0) @ about_x(math.radians(lean))
    return Pose((Bone((), Placement.of(1.0, turn), within=False),))


STRAIGHT: frozenset[PoseWord] = frozenset(("lying", "sleeping"))  # on the back, legs or none
POSES: dict[PoseWord, Callable[[Figure], tuple[Pose, Pose]]] = {
    "sitting": _sits,
    "kneeling": _kneels,
    "crouching": partial(_moves, left=(97, -38, 18), right=(97, -38, 18), lean=22),
    "running": partial(_moves, left=(64, -6), right=(-28, -82), lean=14),
    "walking": partial(_moves, left=(28, 14), right=(-20, -44), lean=4),
    "leaping": partial(_moves, left=(74, 52), right=(-48, -84), lean=12),
    "dancing": partial(_moves, left=(40, -35, 30), right=(0, 0, 6), roll=-8),
}


def poses_of(thing: Thing, body: Body, across: bool = False) -> tuple[Pose, Pose] | None:
    """The stated pose of a figure, and that of garments on its legs; None without legs for it.

    Args:
        across: who lies does so from left to right, as on a sofa.
    """
    word = body.words.pose
    if word in STRAIGHT:
        return (_lies(body, across),) * 2
    figure = Figure.of(thing, body)
    return figure and POSES[word](figure)
