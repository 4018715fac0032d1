"""Placements of things worn on a head, over the eyes or around the neck."""

from collections.abc import Iterable
from dataclasses import replace
from typing import NamedTuple

import torch
from jaxtyping import Float
from torch import Tensor

from core.guidance.builtin.composition.placing.placement import EYES, Body, Placement, sized
from core.guidance.builtin.composition.placing.resting import spot_on
from core.guidance.builtin.nouns.appendages import APPENDAGES
from core.guidance.builtin.palette import looks
from core.guidance.builtin.words.companions.known_as import (
    AROUND_NECKS,
    EYEWEAR,
    FACES,
    FITTED,
    HEADWEAR,
    ON_BACKS,
)
from core.guidance.builtin.words.companions.search import Relation
from core.guidance.builtin.words.phrases.slots import Words

IN_HAND = {"knight": "shield"}  # in the hand that holds something else
COVERS = {"wagon": "cover"}  # of what is loaded
OWN_HATS = "hat", "crown", "helmet"  # parts that another one replaces
# Parts that stand out of a head and do not count in its width.
NO_HEAD = tuple(
    """ears horns horn antlers antennae aerial hat helmet crown plume crest wings halo mane tail
    arms feathers tuft comb fins frill cape pack staff sword shield wand beard scarf stem stalk
    leaf leaves claws legs limbs""".split()
)
AT_ITS_SIDES = "horns", "sockets"  # parts that stand out of a hat
MUZZLES = "muzzle", "snout", "nose", "bill", "beard", "teeth"
# Of the head's width below the eyes: where the neck is, at least; and how far on; how low a
# face may reach.
BELOW, REACH, FACE = 0.4, 0.2, 0.45
# Of the neck's width; of a necklace's height, below its top; of the head's width, a neck's at
# most.
WRAPPED, RING, SLIM = 1.3, 0.28, 0.95
GLASSES_LIKE, OUT = ("sunglasses", "goggles"), 0.6  # of the depth: before the eyes
FOREHEAD, SMALL_HAT = 0.12, 0.6  # of the head's width
HANGING = ("necktie", "medal")
HANGS, FOREMOST = 0.85, 0.03  # of the head's width, how long; of a chest's points, what is before
EARS = 1.12  # of the head's width
# Of the head's width: a hat's crown, glasses, a mask, a bow tie.
HAT, GLASSES, MASKED, TIE = 1.04, 1.06, 0.8, 0.55
BAND = (0.25, 0.5)  # of a hat's height: where it is as wide as the head that it is made for
HAT_SINKS = 0.32, 0.5  # of the head's width, of the hat's own height, at most
EYES_HIGH = 0.3  # training units, at most
WIDEST = 1.9  # times the eyes' distance: a head
# Where a thing has no eyes, its head: of its height; of its width, at least and at most. Eyes and
# brow, of the head's width below the top: as far as a ball of this hat's size goes into it.
TOP, CAPPED, FACED = 0.12, (0.3, 0.5), (0.4, 0.16)
PACK, SADDLED = (0.3, 0.5), (0.2, 0.35)  # of the wearer's longest side: on its feet, on all fours
SHOULDERS = 0.7  # of the way from the feet to the eyes: the middle of a pack
UPRIGHT = 1.1  # times as high as long
BACKWARDS = torch.diag(torch.tensor([-1.0, -1.0, 1.0]))
# Its front up, its top to the head.
ON_ITS_BACK = torch.tensor([[-1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, -1.0, 0.0]])
SUNK = 0.02


class Head(NamedTuple):
    """A head as a ball."""

    middle: Float[Tensor, " 3"]
    wide: float
    top: float
    front: float  # y of the foremost eye
    eyes: float  # z
    brow: float  # z, above the eyes


def worn(item: Body, wearer: Body) -> Placement:
    """The placement of a worn thing."""
    noun = item.words.noun
    if noun in FITTED:  # it is cut to the wearer
        return Placement.of()
    head = head_of(wearer)
    if noun == "headphones":
        return _over_ears(item, head)
    if noun in EYEWEAR | FACES:
        by = GLASSES if noun in EYEWEAR else MASKED
        place = Placement.of(by * head.wide / float(item.sides[0]))
        there = item.placed(place)
        middle = there.box.mean(0)
        # Glasses have sides that extend to the back; the others stand out.
        out = SUNK if noun in GLASSES_LIKE else OUT * float(there.sides[1])
        at = torch.tensor([head.middle[0], head.front - out, head.eyes])
        return place.moved(at - torch.stack([middle[0], there.box[0, 1], middle[2]]))
    if noun in ON_BACKS:
        return _on_back(item, wearer, head)
    if noun in AROUND_NECKS:
        return _at_neck(item, wearer, head)
    return _on_head(item, head)


def _on_head(hat: Body, head: Head) -> Placement:
    low, high = (float(hat.box[0, 2] + fraction * hat.sides[2]) for fraction in BAND)
    verts = hat.without(*AT_ITS_SIDES)
    band = verts[(verts[:, 2] > low) & (verts[:, 2] < high)]
    crown = float(band[:, 0].amax() - band[:, 0].amin()) if len(band) else float(hat.sides[0])
    above = max(head.top - head.brow, SUNK)
    # On a frog, whose eyes are on top of its head, it is between them.
    wide = head.wide * (HAT if above > FOREHEAD * head.wide else SMALL_HAT)
    place = Placement.of(wide / crown)
    there = hat.placed(place)
    within = there.verts[there.verts[:, 2] < there.box[0, 2] + BAND[1] * there.sides[2]]
    middle = (within.amin(0) + within.amax(0)) / 2
    sunk = min(HAT_SINKS[0] * head.wide, HAT_SINKS[1] * float(there.sides[2]), above)
    at = torch.tensor([head.middle[0], head.middle[1], head.top - sunk])
    return place.moved(at - torch.stack([middle[0], middle[1], there.box[0, 2]]))


def _at_neck(item: Body, wearer: Body, head: Head) -> Placement:
    """A necklace around the narrowest place below the head, a bow tie in front of it, a pendant in
    front of the chest."""
    neck = neck_of(wearer, head)
    if item.words.noun in HANGING:
        return _before_chest(item, wearer, head, neck)
    wrapped = item.words.noun == "necklace"
    wide = WRAPPED * min(neck.wide, SLIM * head.wide) if wrapped else TIE * head.wide
    place = Placement.of(wide / float(item.sides[0]))
    there = item.placed(place)
    middle = there.box.mean(0)
    if wrapped:  # by the middle of its ring, which is its upper half
        ring = there.box[1, 2] - RING * there.sides[2]
        return place.moved(neck.middle - torch.stack([middle[0], middle[1], ring]))
    at = torch.tensor([float(neck.middle[0]), neck.front + SUNK, float(neck.middle[2])])
    return place.moved(at - torch.stack([middle[0], there.box[1, 1], middle[2]]))


def _before_chest(item: Body, wearer: Body, head: Head, neck: "Neck") -> Placement:
    place = Placement.of(HANGS * head.wide / float(item.sides[2]))
    there = item.placed(place)
    top, high = float(neck.middle[2]), float(there.sides[2])
    rest = wearer.without(*NO_HEAD, *MUZZLES)
    chest = rest[
        (rest[:, 2] < top)
        & (rest[:, 2] > top - high)
        & ((rest[:, 0] - head.middle[0]).abs() < there.sides[0])
    ]
    front = float(chest[:, 1].quantile(FOREMOST)) if len(chest) else neck.front
    middle = there.box.mean(0)
    at = torch.tensor([float(neck.middle[0]), front + SUNK, top])
    return place.moved(at - torch.stack([middle[0], there.box[1, 1], there.box[1, 2]]))


def _over_ears(item: Body, head: Head) -> Placement:
    place = Placement.of(EARS * head.wide / float(item.sides[0]))
    there = item.placed(place)
    middle = there.box.mean(0)
    at = torch.stack([head.middle[0], head.middle[1], torch.tensor(head.top + 2 * SUNK)])
    return place.moved(at - torch.stack([middle[0], middle[1], there.box[1, 2]]))


class Neck(NamedTuple):
    """The place of a neck."""

    middle: Float[Tensor, " 3"]
    wide: float
    front: float  # its least y


def neck_of(wearer: Body, head: Head) -> Neck:
    """The narrowest place below the head."""
    rest = wearer.without(*NO_HEAD, *MUZZLES)
    found = []
    begin = head.eyes - BELOW * head.wide
    face = wearer.of_parts(*MUZZLES[:4])
    face = face[face[:, 2] > head.eyes - FACE * head.wide]
    begin = min(begin, float(face[:, 2].amin())) if len(face) else begin
    for below in torch.linspace(0, REACH, 10).tolist():
        z = begin - below * head.wide
        near = rest[
            ((rest[:, 2] - z).abs() < 0.08 * head.wide)
            & ((rest[:, :2] - head.middle[:2]).norm(dim=1) < 0.75 * head.wide)
        ]
        if len(near):
            low, high = near.amin(0), near.amax(0)
            middle = torch.stack([head.middle[0], (low + high)[1] / 2, torch.tensor(z)])
            found.append(Neck(middle, float(high[0] - low[0]), float(low[1])))
    if not found:
        at = head.middle - torch.tensor([0.0, 0.0, BELOW * head.wide])
        return Neck(at, head.wide, head.front)
    return min(found, key=lambda neck: neck.wide)


def _on_back(pack: Body, wearer: Body, head: Head) -> Placement:
    stands = wearer.sides[2] > UPRIGHT * wearer.sides[1]
    turn = BACKWARDS if stands else ON_ITS_BACK
    place = Placement.of(sized(pack, wearer, *(PACK if stands else SADDLED)), turn)
    there = pack.placed(place)
    middle = there.box.mean(0)
    if not stands:
        lowest = there.without("straps")[:, 2].amin()  # they are around the animal
        at = torch.stack([middle[0], middle[1], lowest + SUNK])
        return place.moved(spot_on(there, wearer) - at)
    low = float(wearer.box[0, 2])
    z = low + SHOULDERS * (head.eyes - low)
    rest = wearer.without(*NO_HEAD)
    near = rest[
        ((rest[:, 2] - z).abs() < 0.3 * float(there.sides[2]))
        & ((rest[:, 0] - head.middle[0]).abs() < 0.3 * float(there.sides[0]))
    ]
    back = float(near[:, 1].amax()) if len(near) else float(head.middle[1])
    at = torch.tensor([float(head.middle[0]), back - SUNK, z])
    return place.moved(at - torch.stack([middle[0], there.box[0, 1], middle[2]]))


def head_of(body: Body) -> Head:
    """The head around the eyes; without eyes the top."""
    eyes = body.of_parts(*EYES)
    own = body.of_parts("head")
    rest = own if len(own) and len(eyes) else body.without(*NO_HEAD)
    if not len(eyes):
        return _top_of(body, rest)
    eyes = eyes[eyes[:, 2] > eyes[:, 2].amax() - EYES_HIGH]  # not a robot's panel
    low, high = eyes.amin(0), eyes.amax(0)
    middle = (low + high) / 2
    apart = float(high[0] - low[0])
    # As wide as the surface at the eyes' height, behind them.
    wide = apart
    for _ in range(3):
        slab = rest[
            ((rest[:, 2] - middle[2]).abs() < 0.25 * wide)
            & (rest[:, 1] < middle[1] + 1.1 * wide)
            & ((rest[:, 0] - middle[0]).abs() < 1.6 * wide)
        ]
        if len(slab):
            wide = max(apart, float(slab[:, 0].amax() - slab[:, 0].amin()))
            wide = min(wide, WIDEST * apart)  # or it has shoulders
    above = rest[
        ((rest[:, 0] - middle[0]).abs() < 0.35 * wide)
        & (rest[:, 1] > middle[1] - 0.3 * wide)
        & (rest[:, 1] < middle[1] + 1.0 * wide)
        & (rest[:, 2] > middle[2])
    ]
    top = float(above[:, 2].amax()) if len(above) else float(high[2])
    over = above[above[:, 2] > middle[2] + 0.4 * (top - float(middle[2]))] if len(above) else eyes
    y = float(over[:, 1].amin() + over[:, 1].amax()) / 2
    at = torch.tensor([float(middle[0]), y, float(middle[2])])
    return Head(at, wide, top, float(low[1]), float(middle[2]), float(high[2]))


def _top_of(body: Body, rest: Float[Tensor, "n 3"]) -> Head:
    top = float(rest[:, 2].amax())
    high = rest[rest[:, 2] > top - TOP * float(body.sides[2])]
    middle = (high.amin(0) + high.amax(0)) / 2
    least, most = (fraction * body.sides[:2] for fraction in CAPPED)
    wide = float((high.amax(0) - high.amin(0))[:2].maximum(least).minimum(most).min())
    eyes, brow = (top - fraction * wide for fraction in FACED)
    face = rest[((rest[:, 2] - eyes).abs() < 0.1 * wide) & ((rest - middle)[:, 0].abs() < wide / 2)]
    front = (face if len(face) else high)[:, 1].amin()
    return Head(middle, wide, top, float(front), eyes, brow)


def freed(words: Words, relations: Iterable[tuple[Relation, Words]]) -> Words:
    """``words`` without a hat or wings of the thing's own, where it wears others, without the thing
    in a hand that holds something else, and without a cover where it is loaded."""
    relations = list(relations)
    does = [(how, other.noun in HEADWEAR) for how, other in relations]
    grown = [other.noun for how, other in relations if how == "wears" and other.noun in APPENDAGES]
    gone = tuple(noun.split()[-1] for noun in grown)  # "an angel with bat wings"
    gone += OWN_HATS if ("wears", True) in does else ()
    gone = (*gone, IN_HAND.get(words.noun, "")) if "holds" in dict(does) else gone
    gone = (*gone, COVERS.get(words.noun, "")) if "bears" in dict(does) else gone
    own = [name for name in looks(words.noun) if name in gone]
    return replace(words, absent=(*words.absent, *own))
