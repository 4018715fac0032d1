"""Placements of held things: in a hand, in front of the chest, or in the mouth."""

import torch
from jaxtyping import Float
from torch import Tensor

from core.guidance.builtin.composition.placing.placement import (
    X_TO_Y,
    Z_TO_X,
    Body,
    Placement,
    sized,
)
from core.guidance.builtin.composition.placing.wearing import NO_HEAD, UPRIGHT, head_of
from core.guidance.builtin.nouns import GROUPS
from core.guidance.builtin.words.companions.known_as import FLOWERS

# Of the holder's longest side, least and most: a held thing; one that is not slender; one that is
# upright in a hand.
HELD, BULKY, RAISED_SIZES = (0.28, 0.85), (0.28, 0.5), (0.4, 0.75)
SLENDER, LONG = 2.2, 1.25  # times as long as wide: along its grip; across a mouth
AT_CHEST, AT_MOUTH = (0.28, 0.45), ((0.2, 0.3), (0.28, 0.42))  # in a mouth: bulky, long
HANDED = frozenset(GROUPS["Characters"]) | frozenset("person knight alien robot skeleton".split())
CLAWED = {"crab": "claws", "lobster": "claws", "scorpion": "claws"}
# Things that hang on their grip or are upright on it, in a mouth too.
RAISED = frozenset("umbrella balloon torch candle lantern signpost".split())
RAISED |= frozenset(GROUPS["Flags and Signs"]) | {"flag", "stop sign", "kite"}
GRIPS = "string handle grip hilt handles shaft stick pole stem neck post rod".split()
GRIPPED = 0.2  # without a grip, from its lower end
NO_ARM = tuple(name for name in NO_HEAD if name not in ("arms", "limbs", "legs", "claws"))
CHIN = 0.9  # of the head's width below the eyes, at most: the mouth
ARM = (0.25, 0.75)  # of a figure's height: where the hand is
OUT = 0.82  # of the way to the side: beyond it is the arm
CHEST = 0.42  # of the height
SUNK = 0.03


def held(item: Body, holder: Body, second: bool = False) -> Placement:
    """The placement of a held thing; ``second``: next to something else, in the other hand."""
    noun = holder.words.noun
    if noun in HANDED or noun in CLAWED:
        return _in_hand(item, holder, second)
    if second:
        place = Placement.of(sized(item, holder, *AT_CHEST))
        return place.moved(_beside(holder) - _grip(item.placed(place)))
    if holder.sides[2] > UPRIGHT * holder.sides[1]:
        return _before_chest(item, holder)
    return _in_mouth(item, holder)


def _in_hand(item: Body, holder: Body, second: bool) -> Placement:
    raised = item.words.noun in RAISED
    long = _along(item) == 2 and item.words.noun not in FLOWERS
    sizes = RAISED_SIZES if raised else HELD if long else BULKY
    place = Placement.of(sized(item, holder, *sizes))
    there = item.placed(place)
    hand = _hand(holder) * torch.tensor([-1.0 if second else 1.0, 1.0, 1.0])
    if raised or _along(there) == 2:  # a staff, a sword: upright, by its grip
        return place.moved(hand - _grip(there))
    middle = there.box.mean(0)
    back = torch.stack([middle[0], there.box[1, 1], middle[2]])
    return place.moved(hand + torch.tensor([0.0, SUNK, 0.0]) - back)


def _hand(holder: Body) -> Float[Tensor, " 3"]:
    """The front of the holder's right hand, on the left of the picture."""
    found = holder.of_parts(CLAWED.get(holder.words.noun, ""))
    if len(found):
        mine = found[found[:, 0] < found[:, 0].mean()]
        tip = mine[mine[:, 1] <= mine[:, 1].quantile(0.1)]
        return tip.mean(0)
    rest = holder.without(*NO_ARM)
    low, high = (float(holder.box[0, 2] + fraction * holder.sides[2]) for fraction in ARM)
    arms = rest[(rest[:, 2] > low) & (rest[:, 2] < high)]
    if not len(arms):
        arms = rest
    side = arms[arms[:, 0] < OUT * arms[:, 0].amin()]
    side = side if len(side) else arms
    lowest = side[side[:, 2] <= side[:, 2].quantile(0.2)]
    x, z = float(lowest[:, 0].mean()), float(lowest[:, 2].mean())
    return torch.tensor([x, float(lowest[:, 1].amin()), z])


def _grip(item: Body) -> Float[Tensor, " 3"]:
    grip = item.of_parts(*GRIPS)
    if len(grip) and (grip.amax(0) - grip.amin(0))[2] < 0.5 * item.sides[2]:
        return (grip.amin(0) + grip.amax(0)) / 2
    middle = item.box.mean(0)
    return torch.stack([middle[0], middle[1], item.box[0, 2] + GRIPPED * item.sides[2]])


def _along(item: Body, times: float = SLENDER) -> int:
    """The axis along which a thing is ``times`` as long as along the others; -1 without one."""
    order = item.sides.argsort()
    slender = item.sides[order[2]] > times * item.sides[order[1]]
    return int(order[2]) if slender else -1


def _before_chest(item: Body, holder: Body) -> Placement:
    place = Placement.of(sized(item, holder, *AT_CHEST))
    there = item.placed(place)
    z = float(holder.box[0, 2] + CHEST * holder.sides[2])
    half = 0.3 * float(there.sides[2])
    near = holder.verts[
        ((holder.verts[:, 2] - z).abs() < max(half, 0.05))
        & (holder.verts[:, 0].abs() < 0.2 * holder.sides[0])
    ]
    front = float(near[:, 1].amin()) if len(near) else float(holder.box[0, 1])
    middle = there.box.mean(0)
    back = torch.stack([middle[0], there.box[1, 1], middle[2]])
    return place.moved(torch.tensor([0.0, front + SUNK, z]) - back)


def _in_mouth(item: Body, holder: Body) -> Placement:
    if item.words.noun in RAISED:
        place = Placement.of(sized(item, holder, *RAISED_SIZES))
        return place.moved(_beside(holder) - _grip(item.placed(place)))
    along = _along(item, LONG)
    turn = {2: Z_TO_X, 1: X_TO_Y}.get(along, torch.eye(3))
    place = Placement.of(sized(item, holder, *AT_MOUTH[along >= 0]), turn)
    there = item.placed(place)
    at = there.box.mean(0)
    if along < 0:  # below the nose, or it would hide the face
        at[2] = there.box[1, 2] - SUNK
    return place.moved(_mouth(holder) - at)


def _beside(holder: Body) -> Float[Tensor, " 3"]:
    """A place next to the shoulder, so that a tall thing hides no face."""
    low, high = holder.box
    side = holder.without(*NO_HEAD)[:, 0].amin()
    y, z = (low + (high - low) * torch.tensor([0.0, 0.3, 0.6]))[1:]
    return torch.stack([side, y, z])


def _mouth(holder: Body) -> Float[Tensor, " 3"]:
    """The foremost part of the head."""
    rest, head = holder.without(*NO_HEAD), head_of(holder)
    near = rest[rest[:, 2] > head.eyes - CHIN * head.wide]
    rest = near if len(near) else rest
    front = rest[rest[:, 1] <= rest[:, 1].amin() + 0.06 * holder.sides[1]]
    return (front.amin(0) + front.amax(0)) / 2
