"""The things of a composition in the poses that the prompt states."""

from collections.abc import Sequence
from dataclasses import replace

from core.guidance.builtin.composition.placing.placement import Body
from core.guidance.builtin.composition.poses.animal_poses import Animal, pose_of
from core.guidance.builtin.composition.poses.figure_poses import STRAIGHT, poses_of
from core.guidance.builtin.composition.poses.posing import Pose, Posed
from core.guidance.builtin.composition.poses.sitting import LEGWEAR, posture_of
from core.guidance.builtin.composition.thing import Thing
from core.guidance.builtin.nouns.appendages import APPENDAGES
from core.guidance.builtin.stretch import training_size
from core.guidance.builtin.words.companions.known_as import FITTED
from core.guidance.builtin.words.companions.search import Relation
from core.guidance.builtin.words.phrases.poses import FIGURES

UNPOSED = "left out, as it is not drawn on legs that are apart."
IN_DRESS = "left out, as the dress has no legs."
SEATED = "left out, as it sits on something else."
WITHIN = "left out, as it is in something else."
WIDE = 1.2  # times as wide as deep: one lies across it
# Clothes without sleeves, and what grows on a trunk.
OFF_LEGS = (
    frozenset("scarf cape belt".split())
    | {"dog collar"}
    | {noun for noun in APPENDAGES if noun.endswith(("wings", "tail"))}
)
PADDED = 0.04  # training units: by how much clothes go beyond an animal's legs


def in_poses(
    drawn: Sequence[Thing], bodies: Sequence[Body], relations: Sequence[Relation]
) -> tuple[list[Thing], list[Body], list[str]]:
    """The drawn things in their poses, the first one with its clothes, and notes on the poses that
    are left out."""
    things, found, notes = list(drawn), list(bodies), []
    for index, (thing, body) in enumerate(zip(drawn, bodies, strict=True)):
        words = thing.words
        if not words.pose:
            continue
        worn = [k for k, how in enumerate(relations, 1) if how == "wears" and not index]
        clothes = [k for k in worn if bodies[k].words.noun in FITTED]
        seat = not index and _has_seat(bodies, relations)
        in_dress = any(bodies[k].words.noun == "dress" for k in clothes)
        if words.noun in FIGURES and seat:  # ``seated`` poses it
            notes += [f"{words.noun} {words.pose}: {SEATED}"] if words.pose != "sitting" else []
            continue
        if words.noun in FIGURES and not index and "in" in relations:
            notes.append(f"{words.noun} {words.pose}: {WITHIN}")
            continue
        if words.noun in FIGURES and in_dress and words.pose not in STRAIGHT:
            notes.append(f"{words.noun} {words.pose}: {IN_DRESS}")
            continue
        below = [bodies[k] for k, how in enumerate(relations, 1) if how == "on" and not index]
        across = any(one.sides[0] > WIDE * one.sides[1] for one in below)
        poses = _poses(thing, body, across)
        if poses is None:
            notes.append(f"{words.noun} {words.pose}: {UNPOSED}")
            continue
        pose, on_legs, elsewhere = poses
        fit = training_size(pose.out(body.verts))
        pose = pose.then(*fit)
        things[index], found[index] = Posed(thing, pose), _measured(pose.body(body))
        if words.noun in FIGURES:
            carried = pose.bones[0].place
            found[index] = replace(found[index], standing=body, carried=carried)
        for k in clothes:
            noun = bodies[k].words.noun
            wide = (on_legs if noun in LEGWEAR else elsewhere).then(*fit)
            if noun in OFF_LEGS:
                wide = Pose((replace(wide.bones[0], regions=()),))
            things[k], found[k] = Posed(drawn[k], wide), wide.body(bodies[k])
    return things, found, notes


def _poses(thing: Thing, body: Body, across: bool) -> tuple[Pose, Pose, Pose] | None:
    """The stated pose, that of garments on the legs, and that of other garments; None where it
    cannot have it."""
    if thing.words.noun in FIGURES:
        both = poses_of(thing, body, across)
        return both and (*both, both[0])
    animal = Animal.of(thing, body)
    if animal is None:
        return None
    wide = pose_of(replace(animal, padded=PADDED))
    return pose_of(animal), wide, wide


def _has_seat(bodies: Sequence[Body], relations: Sequence[Relation]) -> bool:
    """Whether the first one sits on something or rides it."""
    words = bodies[0].words
    said = zip(words.companions, relations, bodies[1:], strict=False)
    return any(
        posture_of(one.verb or words.pose, how, other.words.noun) for one, how, other in said
    )


def _measured(body: Body) -> Body:
    """With its stated size, which is that of the pose."""
    size = body.words.size
    return replace(body, metres=size.longest(body.sides.tolist()) / body.longest) if size else body
