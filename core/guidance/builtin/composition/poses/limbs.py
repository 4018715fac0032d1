"""The legs of a figure turned at their hips and knees, each by itself, and its trunk."""

import math
from typing import NamedTuple

import torch
from jaxtyping import Float
from torch import Tensor

from core.geometry.union import Region
from core.guidance.builtin.composition.placing.placement import Placement, about_x, about_z
from core.guidance.builtin.composition.poses.legs import HIP, Legs
from core.guidance.builtin.composition.poses.posing import Bone, Distances, Pose, joint

SIDES = (1, -1)  # the figure's left leg, and its right one
BARE = 0.1  # of the radius, of a leg that stays in the coat that it comes out of
INNER = 0.96  # of a joint's ball, the shin's: no two surfaces are in one place
STEPS, FARTHEST = 40, 5.0  # on the way out of the trunk, radii
DOWN = torch.tensor([0.0, 0.0, -1.0])
# Training units by which clothes go beyond the legs that wear them, at most, and all around their
# joints.
CLOTHED, PADDED = 0.09, 0.04

Angles = tuple[float, float]  # forward from the vertical, then outwards; radians
Box = tuple[Float[Tensor, " 3"], Float[Tensor, " 3"]]


class Limb(NamedTuple):
    """One leg: the directions of its thigh and of its shin, and how far it is moved along
    itself."""

    thigh: Angles
    shin: Angles | None  # None: the leg is straight
    out: float = 0.0


def both_poses(
    legs: Legs, limbs: tuple[Limb, Limb], trunk: Placement, distances: Distances
) -> tuple[Pose, Pose]:
    """The pose with the legs, the left one first, so far out of the trunk that none is hidden in a
    coat, two that are alike equally far; the same for garments on them."""

    def moved(side: int, limb: Limb) -> Limb:
        way = trunk.turn.T @ turned(limb.thigh, side) @ DOWN
        return limb._replace(out=_way_out(legs, side, way, distances))

    left = moved(1, limbs[0])
    right = left if limbs[1] == limbs[0] else moved(-1, limbs[1])
    return bent(legs, (left, right), trunk), bent(legs, (left, right), trunk, CLOTHED, PADDED)


def bent(
    legs: Legs,
    limbs: tuple[Limb, Limb],
    trunk: Placement,
    beyond: float = 0.0,
    padded: float = 0.0,
) -> Pose:
    """The pose of a part that extends so far beyond the legs and around their joints: the trunk in
    such a place, the legs at it."""
    boxes = _boxes(legs, beyond)
    around, bones = legs.radius + padded, [_above(boxes, trunk)]
    for side, limb, (low, high) in zip(SIDES, limbs, boxes, strict=True):
        hip = mirrored(legs.hip, side)
        turn = turned(limb.thigh, side)
        moved = joint(hip, turn, trunk.out(hip[None])[0] + turn @ (limb.out * DOWN))
        top = torch.stack([hip[0], hip[1], high[2]])
        upper = (hip, top, around)
        if limb.shin is None:
            bones.append(Bone((Region((low, high), (upper,)),), moved))
            continue
        knee = mirrored(legs.halfway, side)
        ball, inner = ((knee, knee, radius) for radius in (around, INNER * around))
        over = torch.tensor([0.0, 0.0, legs.radius if legs.square else 0.0])
        split = [torch.stack([end[0], end[1], knee[2]]) for end in (low, high)]
        shin = joint(knee, turned(limb.shin, side), moved.out(knee[None])[0])
        bones += [
            Bone((Region((split[0] - over, high), (upper, ball)),), moved),
            Bone((Region((low, split[1] + over), (inner,)),), shin),
        ]
    return Pose(tuple(bones))


def turned(angles: Angles, side: int = 1) -> Float[Tensor, "3 3"]:
    """A rotation of what hangs down: forward, then outwards."""
    forward, outwards = angles
    return about_z(side * outwards) @ about_x(-forward)


def degrees(forward: float, outwards: float = 0.0) -> Angles:
    """The same in degrees."""
    return math.radians(forward), math.radians(outwards)


def mirrored(at: Float[Tensor, "*n 3"], side: int) -> Float[Tensor, "*n 3"]:
    """A place of the left side on the right one, where ``side`` is -1."""
    return at * torch.tensor([float(side), 1.0, 1.0])


def _boxes(legs: Legs, beyond: float = 0.0) -> list[Box]:
    """Boxes around each leg and ``beyond`` it, but not upwards or across the middle."""
    wider = torch.tensor([[0.0, -beyond, -beyond], [beyond, beyond, 0.0]])
    both = [mirrored(legs.box + wider, side) for side in SIDES]
    return [(ends.amin(0), ends.amax(0)) for ends in both]


def _above(boxes: list[Box], place: Placement) -> Bone:
    """The trunk: all outside the boxes."""
    return Bone(tuple(Region(box) for box in boxes), place, within=False)


def _way_out(legs: Legs, side: int, way: Float[Tensor, " 3"], distances: Distances) -> float:
    """How far a leg is moved along itself, so that no more of it is hidden in a coat than at
    rest."""
    trunk = _above(_boxes(legs), Placement.of())
    far = torch.linspace(0, FARTHEST * legs.radius, STEPS)

    def exit_at(way: Float[Tensor, " 3"]) -> float:
        points = mirrored(legs.hip, side) + far[:, None] * way
        inside = torch.maximum(distances(points).amin(1), trunk.gap(points)) < 0
        return float(far[int((~inside).long().argmax())]) if not inside.all() else float(far[-1])

    return max(exit_at(way) - max(exit_at(DOWN), (HIP + BARE) * legs.radius), 0.0)
