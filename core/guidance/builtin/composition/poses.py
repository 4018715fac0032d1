"""The things of a composition in the poses that the prompt states."""

from collections.abc import Sequence
from dataclasses import replace

from jaxtyping import Float
from torch import Tensor

from core.geometry.mesh import NORMAL_RADIUS
from core.guidance.builtin.composition.animal_poses import Animal, pose_of
from core.guidance.builtin.composition.placement import Body
from core.guidance.builtin.composition.posing import Pose, Posed
from core.guidance.builtin.composition.thing import Thing
from core.guidance.builtin.words.companion_words import CLOTHING
from core.guidance.builtin.words.companions import Relation
from core.guidance.builtin.words.slots import Words

OFF_LEGS = frozenset("scarf cape belt".split()) | {"dog collar"}  # clothes without sleeves
PADDED = 0.04  # training units: by how much clothes go beyond legs


def in_poses(
    drawn: Sequence[Thing], bodies: Sequence[Body], relations: Sequence[Relation]
) -> tuple[list[Thing], list[Body], list[Words]]:
    """The drawn things in their poses, the first one with its clothes, and the words of those that
    cannot have theirs."""
    things, found, unposed = list(drawn), list(bodies), []
    for index, (thing, body) in enumerate(zip(drawn, bodies, strict=True)):
        if not thing.words.pose:
            continue
        animal = Animal.of(thing, body)
        if animal is None:
            unposed.append(thing.words)
            continue
        pose = pose_of(animal)
        fit = _fit(pose.out(body.verts))
        pose = pose.then(*fit)
        things[index], found[index] = Posed(thing, pose), _measured(pose.body(body))
        worn = [k for k, how in enumerate(relations, 1) if how == "wears" and not index]
        for k in worn:
            if (noun := bodies[k].words.noun) in CLOTHING:
                wide = pose_of(replace(animal, padded=PADDED)).then(*fit)
                if noun in OFF_LEGS:
                    wide = Pose((replace(wide.bones[0], regions=()),))
                things[k], found[k] = Posed(drawn[k], wide), wide.body(bodies[k])
    return things, found, unposed


def _fit(verts: Float[Tensor, "n 3"]) -> tuple[float, Float[Tensor, " 3"]]:
    """The scale and the shift to the size in which the networks know things."""
    center = (verts.amin(0) + verts.amax(0)) / 2
    scale = NORMAL_RADIUS / float((verts - center).norm(dim=1).max())
    return scale, -center * scale


def _measured(body: Body) -> Body:
    """With its stated size, which is that of the pose."""
    size = body.words.size
    return replace(body, metres=size.longest(body.sides.tolist()) / body.longest) if size else body
