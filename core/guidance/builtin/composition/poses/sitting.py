"""Figures that sit on something or ride it: whether they do, and their pose."""

from collections.abc import Sequence
from dataclasses import replace
from functools import partial
from typing import Literal

import torch
from jaxtyping import Float
from torch import Tensor

from core.guidance.builtin.composition.placing.copies import copies_of
from core.guidance.builtin.composition.placing.placement import Body, Placement, joined
from core.guidance.builtin.composition.placing.resting import LYING, MOUNTS
from core.guidance.builtin.composition.poses.legs import Legs, legs_of
from core.guidance.builtin.composition.poses.limbs import Limb, both_poses
from core.guidance.builtin.composition.poses.posing import Distances, Pose, Posed
from core.guidance.builtin.composition.poses.seats import (
    Seat,
    ridden,
    sat_in,
    sat_on,
    sunk_before,
    trunk_of,
)
from core.guidance.builtin.composition.thing import Thing
from core.guidance.builtin.nouns import GROUPS
from core.guidance.builtin.words.companions.known_as import FITTED, SEATS
from core.guidance.builtin.words.companions.search import Relation
from core.guidance.builtin.words.tables.living import is_animal

Posture = Literal["sits", "rides", ""]  # "": stands

SITTING = frozenset("sitting sits sit seated perched resting relaxing lounging".split())
RIDING = frozenset("riding rides ride driving drives drive".split())
ON_FEET = frozenset(
    """standing stands stand dancing dances jumping jumps leaping walking walks running runs
    balancing balanced surfing skating skateboarding snowboarding posing kneeling lying lies laid
    sleeping sleeps asleep crouching crouched squatting climbing fighting hopping landing""".split()
)
# Things to sit on by default; things to stand on unless sitting is stated.
ALSO_SEATS = SEATS | {"bench", "stool", "ottoman", "toilet"}
BOARDS = LYING | {"sled", "raft", "treadmill", "trampoline"}
ALSO_MOUNTS = MOUNTS | {"jet ski", "snowmobile", "kick scooter", "griffin", "centaur", "pegasus"}
# In robes to the ground, or with a tail.
ROBED = frozenset("king queen princess wizard witch angel vampire mermaid".split()) | {
    "grim reaper"
}
# What is worn on the legs.
LEGWEAR = frozenset("trousers boot sneaker sandal sock".split()) | {"high heel"}


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
        posture = posture_of(one.verb or first.words.pose, relation, support.words.noun)
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
            if (noun := bodies[k].words.noun) in FITTED:
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
    limb = Limb(seat.thigh, seat.shin)
    return both_poses(legs, (limb, limb), Placement.of(), distances)


def _farther(
    distances: Distances, by: Float[Tensor, " 3"], points: Float[Tensor, "n 3"]
) -> Float[Tensor, "n p"]:
    return distances(points + by)
