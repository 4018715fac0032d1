"""Figures that sit on something or ride it: whether they do, and their pose."""

from collections.abc import Sequence
from dataclasses import replace
from functools import partial
from typing import Literal

import torch
from jaxtyping import Float
from torch import Tensor

from core.geometry.union import Region
from core.guidance.builtin.composition.copies import copies_of
from core.guidance.builtin.composition.legs import HIP, Legs, legs_of
from core.guidance.builtin.composition.placement import Body, Placement, about_x, about_z, joined
from core.guidance.builtin.composition.posing import Bone, Distances, Pose, Posed, joint
from core.guidance.builtin.composition.resting import LYING, MOUNTS
from core.guidance.builtin.composition.seats import (
    Seat,
    ridden,
    sat_in,
    sat_on,
    sunk_before,
    trunk_of,
)
from core.guidance.builtin.composition.thing import Thing
from core.guidance.builtin.nouns import GROUPS
from core.guidance.builtin.words.companion_words import CLOTHING, SEATS
from core.guidance.builtin.words.companions import Relation
from core.guidance.builtin.words.living import is_animal

Posture = Literal["sits", "rides", ""]  # "": stands

SITTING = frozenset("sitting sits sit seated perched resting relaxing lounging".split())
RIDING = frozenset("riding rides ride driving drives drive".split())
ON_FEET = frozenset(
    """standing stands stand dancing dances jumping jumps leaping walking walks running runs
    balancing balanced surfing skating skateboarding snowboarding posing kneeling lying lies laid
    sleeping sleeps asleep climbing fighting hopping landing""".split()
)
# Things to sit on by default; things to stand on unless sitting is stated.
ALSO_SEATS = SEATS | {"bench", "stool", "ottoman", "toilet"}
BOARDS = LYING | {"sled", "raft", "treadmill", "trampoline"}
ALSO_MOUNTS = MOUNTS | {"jet ski", "snowmobile", "kick scooter", "griffin", "centaur", "pegasus"}
# In robes to the ground, or with a tail.
ROBED = frozenset("king queen princess wizard witch angel vampire mermaid".split()) | {
    "grim reaper"
}
BARE = 0.1  # of the radius, of a leg that stays in the coat that it comes out of
INNER = 0.96  # of a joint's ball, the shin's: no two surfaces are in one place
STEPS, FARTHEST = 40, 5.0  # on the way out of the trunk, radii
# What is worn on the legs; training units by which it goes beyond them, at most, and all around
# their joints.
LEGWEAR = frozenset("trousers boot sneaker sandal sock".split()) | {"high heel"}
CLOTHED, PADDED = 0.09, 0.04


def posture_of(verb: str, relation: Relation, noun: str) -> Posture:
    """The posture on or in such a thing, as far as legs are concerned."""
    vehicle = noun in GROUPS["Vehicles"] and noun not in BOARDS
    if relation not in ("on", "in") or verb in ON_FEET or (relation == "in" and not vehicle):
        return ""
    if is_animal(noun) or noun in ALSO_MOUNTS:
        return "rides"
    rides = verb in RIDING and noun not in BOARDS
    sits = rides or verb in SITTING or noun in ALSO_SEATS or relation == "in"
    return "sits" if sits else ""


def seated(
    drawn: Sequence[Thing], bodies: Sequence[Body], relations: Sequence[Relation]
) -> tuple[list[Thing], list[Body]]:
    """The drawn things of a composition with the first one seated or riding, if it does that and
    has legs; with its clothes."""
    things, found = list(drawn), list(bodies)
    first, parts = bodies[0], drawn[0].parts()
    worn = [k for k, relation in enumerate(relations, 1) if relation == "wears"]
    dresses = [bodies[k] for k in worn if bodies[k].words.noun == "dress"]
    robed = bool(dresses) or first.words.noun in ROBED
    said = zip(first.words.companions, relations, bodies[1:], strict=False)
    for one, relation, support in said:
        posture = posture_of(one.verb, relation, support.words.noun)
        if posture == "sits" and relation == "on" and robed:
            found[0] = replace(first, rests=sunk_before(joined([first, *dresses]), support))
            break
        legs = legs_of(first, parts) if posture and parts and not dresses else None
        heaped = first.words.count > 1 and relation == "in"
        if legs is None or parts is None or first.words.order != "row" or heaped:
            continue
        by = torch.tensor([legs.axis, 0.0, 0.0])
        seat = _seat(posture, relation, first.placed(Placement.of().moved(-by)), support, legs)
        if seat is None:
            continue
        poses = posed(legs, seat, partial(_farther, parts.distances, by))
        bare, clothed = (pose.moved(by) for pose in poses)
        things[0] = Posed(drawn[0], bare)
        found[0] = replace(bare.body(first), rests=seat.place.moved(by), standing=first)
        for k in worn:
            if (noun := bodies[k].words.noun) in CLOTHING:
                pose = clothed if noun in LEGWEAR else bare
                things[k], found[k] = Posed(drawn[k], pose), pose.body(bodies[k])
        break
    return things, found


def _seat(
    posture: Posture, relation: Relation, first: Body, support: Body, legs: Legs
) -> Seat | None:
    """The seat on its carrier; None where several would ride one mount."""
    each = support.words.count == first.words.count
    if posture == "rides":
        return ridden(first, support, legs) if each else None
    trunk = trunk_of(first, legs)
    trunk = trunk if each else trunk.group(copies_of(first))
    return (sat_in if relation == "in" else sat_on)(trunk, first, support, legs)


def posed(legs: Legs, seat: Seat, distances: Distances) -> tuple[Pose, Pose]:
    """The pose with both legs as on the seat, also for garments on them."""
    way = _turn(seat.thigh, 1) @ torch.tensor([0.0, 0.0, -1.0])
    out = _way_out(legs, _above(_boxes(legs)), way, distances)
    return _bent(legs, seat, out, 0.0, 0.0), _bent(legs, seat, out, CLOTHED, PADDED)


def _farther(
    distances: Distances, by: Float[Tensor, " 3"], points: Float[Tensor, "n 3"]
) -> Float[Tensor, "n p"]:
    return distances(points + by)


def _boxes(legs: Legs, beyond: float = 0.0) -> list[tuple[Tensor, Tensor]]:
    """Boxes around each leg and ``beyond`` it, but not upwards or across the middle."""
    wider = torch.tensor([[0.0, -beyond, -beyond], [beyond, beyond, 0.0]])
    return [_mirrored(legs.box + wider, side) for side in (1, -1)]


def _above(boxes: list[tuple[Tensor, Tensor]]) -> Bone:
    """The trunk: all outside the boxes."""
    return Bone(tuple(Region((low, high)) for low, high in boxes), Placement.of(), within=False)


def _bent(legs: Legs, seat: Seat, out: float, beyond: float, padded: float) -> Pose:
    """The pose of a part that extends so far beyond the legs and around their joints; ``out``: how
    far they are moved along themselves."""
    boxes = _boxes(legs, beyond)
    around, bones = legs.radius + padded, [_above(boxes)]
    for side, (low, high) in zip((1, -1), boxes, strict=True):
        hip = legs.hip * torch.tensor([side, 1.0, 1.0])
        turn = _turn(seat.thigh, side)
        moved = joint(hip, turn, hip + turn @ torch.tensor([0.0, 0.0, -out]))
        top = torch.stack([hip[0], hip[1], high[2]])
        upper = (hip, top, around)
        if seat.shin is None or legs.knee is None:
            bones.append(Bone((Region((low, high), (upper,)),), moved))
            continue
        knee = legs.knee * torch.tensor([side, 1.0, 1.0])
        ball, inner = ((knee, knee, radius) for radius in (around, INNER * around))
        over = torch.tensor([0.0, 0.0, legs.radius if legs.square else 0.0])
        split = [torch.stack([end[0], end[1], knee[2]]) for end in (low, high)]
        bent = joint(knee, _turn(seat.shin, side), moved.out(knee[None])[0])
        bones += [
            Bone((Region((split[0] - over, high), (upper, ball)),), moved),
            Bone((Region((low, split[1] + over), (inner,)),), bent),
        ]
    return Pose(tuple(bones))


def _mirrored(
    box: Float[Tensor, "2 3"], side: int
) -> tuple[Float[Tensor, " 3"], Float[Tensor, " 3"]]:
    ends = box * torch.tensor([side, 1.0, 1.0])
    return ends.amin(0), ends.amax(0)


def _turn(angles: tuple[float, float], side: int) -> Float[Tensor, "3 3"]:
    """A rotation forward from the vertical, then outwards."""
    forward, outwards = angles
    return about_z(side * outwards) @ about_x(-forward)


def _way_out(legs: Legs, trunk: Bone, way: Float[Tensor, " 3"], distances: Distances) -> float:
    """How far a leg is moved along itself, so that it is not hidden in a coat."""
    far = torch.linspace(0, FARTHEST * legs.radius, STEPS)
    points = legs.hip + far[:, None] * way
    inside = torch.maximum(distances(points).amin(1), trunk.gap(points)) < 0
    exit_at = float(far[int((~inside).long().argmax())]) if not inside.all() else float(far[-1])
    return max(exit_at - (HIP + BARE) * legs.radius, 0.0)
