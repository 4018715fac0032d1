"""Cuts of clothes: each part's signed distance, from its wearer's measurements.

A garment is a little outside the wearer's own surface, between planes: at the neck, at the crotch,
at the wrists, in front of an animal's hind legs.
"""

from collections.abc import Callable
from functools import cached_property
from typing import NamedTuple

import torch
from jaxtyping import Float
from torch import Tensor

from core.guidance.builtin.composition.clothes.measurements import Measurements

# Training units, outside the wearer: cloth, its rims, stiff parts, a scarf's ring and its end.
CLOTH, RIM, STIFF, THICK, PADDED = 0.035, 0.055, 0.06, 0.075, 0.06
# Training units: how much farther out a garment is than another one that may be under it.
LAYERS = {"dress": 0.008, "shirt": 0.008, "jacket": 0.016, "belt": 0.016, "chestplate": 0.016}
EDGE = 0.03  # training units: half of a hem's or a collar's height
AROUND = 0.06  # training units added to a trunk's front and back
WAIST = 0.3  # of the way from the crotch to the neck
FLARE = 1.5  # a skirt's width at its hem, of the waist's
# On all fours: how steeply a skirt goes outwards, and for how long, training units.
PUFFED, TUTU = 1.2, 0.14
# A jacket's opening at the neck: half of it, of the head's width; how deep, of a trunk's height.
OPENING, LAPEL = 0.2, 0.5
ZIP = 0.04  # of the head's width, half of it
# A scarf: half of its height around the neck, training units; the widest of its ring, of the head's
# width; its end, of a trunk's height; how far aside that hangs, of the neck's width.
WRAP, AT_NECK, SCARF, ASIDE = 0.07, 0.68, 0.25, 0.25
# A cape: how far it swings out at its foot, training units; by how much wider it is there, and what
# of a trunk it drapes.
SWUNG, SPREAD, DRAPED = 0.25, 0.6, 0.45
FOLDS, FOLD = 9, 0.07  # of a cape: how many, half around; how deep, of its distance
ANKLE = 0.16  # of a leg's length
# Training units: a sole's thickness; from where on a shoe goes straight down; its least height.
SOLE, FOOT, SHORTEST = 0.035, 0.08, 0.14
BESIDE = 0.55  # of the head's width, from its middle: an arm that is raised
SPLIT = 0.15  # of half the trunk's width: between shoes
HEAD_HIGH = 0.5  # of the way from the crotch to the eyes: an animal's cape ends

Distance = Float[Tensor, " n"]
Cloth = dict[str, Distance]  # by part of the noun


class Place:
    """Points, and their position relative to a wearer."""

    def __init__(self, wearer: Measurements, points: Float[Tensor, "n 3"], layer: float) -> None:
        self.wearer, self.points, self.layer = wearer, points, layer
        self.level = points[:, 2]
        self.aside = (points[:, 0] - wearer.neck[0]).abs()
        self.before = points[:, 1] - (wearer.front + wearer.back) / 2
        self.below = wearer.below_neck(points)

    @cached_property
    def skin(self) -> Distance:
        """Distance from the surface below the garment."""
        return self.wearer.skin(self.points) - self.layer

    @cached_property
    def off_trunk(self) -> Distance:
        """Distance outside what a shirt covers."""
        wearer, y = self.wearer, self.points[:, 1]
        if not wearer.stands:
            ends = [-self.below, y - wearer.hind + EDGE, wearer.sleeve - self.level]
            return most(*ends)
        hands = self.aside - wearer.reach
        hanging = most(wearer.wide + CLOTH - self.aside, self.level - wearer.sleeve)
        front, back = wearer.front - AROUND - y, y - wearer.back - AROUND
        beside = most(BESIDE * wearer.head.wide - self.aside, self.level - wearer.raised)
        neck = torch.minimum(-self.below, beside)
        return most(neck, hands, -hanging, front, back, wearer.crotch - self.level)

    def band(self, at: Distance, middle: float = 0.0, half: float = EDGE) -> Distance:
        """Distance outside the band within ``half`` of a value."""
        return (at - middle).abs() - half

    @property
    def hems(self) -> Distance:
        """Distance from the rim at a shirt's lower end; on all fours, also from those of its
        sleeves."""
        wearer = self.wearer
        if wearer.stands:
            return self.band(self.level, wearer.crotch + EDGE)
        rear = self.band(self.points[:, 1], wearer.hind - 2 * EDGE)
        return torch.minimum(rear, self.band(self.level, wearer.sleeve + EDGE))

    @property
    def collar(self) -> Distance:
        """Distance from the rim at the neck."""
        ring = self.band(self.below, EDGE)
        if not self.wearer.stands:
            return ring
        off_axis = (self.points[:, :2] - self.wearer.neck[:2].to(ring)).norm(dim=1)
        return most(ring, off_axis - self.wearer.neck_wide / 2 - 2 * RIM)  # not on the shoulders

    @property
    def waist(self) -> float:
        """The z of the waist of an upright wearer."""
        wearer = self.wearer
        return wearer.crotch + WAIST * (float(wearer.neck[2]) - wearer.crotch)


def most(*distances: Distance) -> Distance:
    """The intersection of distances."""
    return torch.stack(distances).amax(0)


def _shirt(at: Place) -> Cloth:
    rims = torch.minimum(at.hems, at.collar)
    return {
        "body": most(at.skin - CLOTH, at.off_trunk),
        "cuffs": most(at.skin - RIM, rims, at.off_trunk),
    }


def _jacket(at: Place) -> Cloth:
    cloth, wearer = _shirt(at), at.wearer
    if not wearer.stands:  # its chest is under its chin
        return cloth
    # It is open in a V below the neck, where a shirt is seen.
    deep = LAPEL * (float(wearer.neck[2]) - wearer.crotch)
    vee = at.aside - OPENING * wearer.head.wide * (1 - at.below / deep)
    shown = most(vee, at.before, at.below - deep)
    strip = most(at.aside - ZIP * wearer.head.wide, at.before, deep - at.below)
    return {name: most(part, -shown) for name, part in cloth.items()} | {
        "shirt": most(at.skin - CLOTH / 2, shown, at.off_trunk),
        "zip": most(at.skin - STIFF, strip, at.off_trunk),
    }


def _dress(at: Place) -> Cloth:
    wearer, level = at.wearer, at.level
    if not wearer.stands:
        behind = at.points[:, 1] - (wearer.hind - EDGE)
        flared = at.skin - CLOTH - PUFFED * behind.clamp(0, TUTU)
        return {
            "body": most(at.skin - CLOTH, at.off_trunk, behind),
            "skirt": most(flared, at.band(behind, TUTU / 2, TUTU / 2), wearer.belly - level),
            "belt": most(at.skin - RIM, at.band(behind), at.off_trunk),
        }
    foot, waist = wearer.low + 2 * EDGE, at.waist
    fraction = ((waist - level) / (waist - foot)).clamp(0, 1)
    half = level.new_tensor([wearer.wide, (wearer.back - wearer.front) / 2]) + CLOTH
    wide = half * (1 + (FLARE - 1) * fraction[:, None])
    off_axis = torch.stack([at.aside, at.before], 1)
    cone = ((off_axis / wide).norm(dim=1) - 1) * wide.amin(1)
    arms = at.aside - wearer.wide - RIM
    return {
        "body": most(at.skin - CLOTH, at.off_trunk, waist - level),
        "skirt": most(cone, level - waist, foot - level),
        "hem": most(cone - RIM / 2, at.band(level, foot + EDGE)),
        "belt": most(at.skin - RIM, at.band(level, waist), arms),
    }


def _trousers(at: Place) -> Cloth:
    wearer, level = at.wearer, at.level
    foot = wearer.low + ANKLE * wearer.leg
    if wearer.stands:
        arms = at.aside - wearer.wide - CLOTH
        off = most(level - at.waist, foot - level, arms)
        top = most(at.band(level, at.waist), arms)
    else:  # those of its hind legs
        y, begin = at.points[:, 1], wearer.hind - 2 * EDGE
        off = most(begin - y, foot - level, y - wearer.back)
        top = most(at.band(y, begin), foot - level)
    return {
        "body": most(at.skin - CLOTH, off),
        "belt": most(at.skin - RIM, top),
        "cuffs": most(at.skin - RIM, at.band(level, foot + EDGE), off),
    }


def _belt(at: Place) -> Cloth:
    wearer, plate = at.wearer, at.aside - 2 * EDGE
    if wearer.stands:
        around = at.band(at.level, at.waist)
        plate = most(plate, at.before)
    else:
        around = most(at.band(at.points[:, 1], wearer.hind - 3 * EDGE), wearer.belly - at.level)
    return {
        "strap": most(at.skin - RIM, around),
        "buckle": most(at.skin - STIFF - CLOTH / 2, around - EDGE / 3, plate),
    }


def _chestplate(at: Place) -> Cloth:
    arms = at.aside - at.wearer.wide
    return {
        "plate": most(at.skin - STIFF, at.off_trunk, arms),
        "belt": most(at.skin - STIFF - CLOTH, at.hems, arms),
    }


def _scarf(at: Place) -> Cloth:
    wearer = at.wearer
    depth = wearer.below_throat(at.points)
    ring = at.band(depth, half=WRAP)
    aside = at.points[:, 0] - wearer.neck[0]
    if wearer.stands:
        off_axis = (at.points[:, :2] - wearer.neck[:2].to(ring)).norm(dim=1)
        ring = most(ring, off_axis - AT_NECK * wearer.head.wide)
        end = wearer.crotch + SCARF * (float(wearer.neck[2]) - wearer.crotch)
        beside = at.band(aside, ASIDE * wearer.neck_wide, 1.5 * WRAP)
        strip = most(beside, -at.below, at.points[:, 1] - float(wearer.neck[1]))
    else:  # over its shoulder; not around its front legs
        ring = most(ring, wearer.belly - at.level)
        end = wearer.crotch
        strip = most(at.band(depth, WRAP, 1.5 * WRAP), -aside)
    hanging = most(at.skin - PADDED, strip)
    return {
        "wool": torch.minimum(
            most(at.skin - THICK, ring), most(hanging, end + 2 * EDGE - at.level)
        ),
        "stripes": most(hanging - EDGE / 4, at.band(at.level, end + 5 * EDGE)),
        "fringes": most(hanging - EDGE / 4, at.band(at.level, end + EDGE)),
    }


def _dog_collar(at: Place) -> Cloth:
    depth, wearer = at.wearer.below_throat(at.points), at.wearer
    before = at.points[:, 1] - float(wearer.throat[1])
    tag = most(at.band(depth, 2 * EDGE, 2 * EDGE), at.aside - 1.5 * EDGE, before)
    return {"strap": most(at.skin - RIM, at.band(depth)), "buckle": most(at.skin - THICK, tag)}


def _cape(at: Place) -> Cloth:
    wearer, level = at.wearer, at.level
    around = at.aside - wearer.wide - RIM  # and not up a raised arm
    collar = most(at.skin - THICK, at.band(at.below, EDGE, 1.5 * EDGE), around)
    clasp = most(collar - EDGE, at.aside - 2 * EDGE)
    if not wearer.stands:  # along its back
        half = wearer.crotch + HEAD_HIGH * (wearer.head.eyes - wearer.crotch)
        end = at.points[:, 1] - wearer.back + AROUND
        chest = level - wearer.crotch - 3 * EDGE
        cloth = most(at.skin - STIFF, -at.below, half - level, end)
        return {"cloth": cloth, "collar": collar, "clasp": most(clasp, chest)}
    neck, foot = float(wearer.neck[2]), wearer.low + 3 * EDGE
    before = at.points[:, 1] - float(wearer.neck[1])
    fraction = ((neck - level) / (neck - foot)).clamp(0, 1)
    # Half an ellipse around the back, farther out and folded towards the hem.
    deep = wearer.back - float(wearer.neck[1]) + CLOTH + SWUNG * fraction
    wide = wearer.wide * (1 + SPREAD * fraction)
    angle = torch.atan2(at.aside / wide, before / deep)
    out = torch.hypot(at.aside / wide, before / deep) - 1 - FOLD * fraction * (FOLDS * angle).cos()
    sheet = most(at.band(out * deep.minimum(wide), half=CLOTH), -before, level - neck, foot - level)
    shoulders = neck - DRAPED * (neck - wearer.crotch)
    draped = most(at.skin - STIFF, -before, -at.below, shoulders - level)
    return {
        "cloth": torch.minimum(sheet, draped),
        "collar": collar,
        "clasp": most(clasp, before),
    }


class Shoe(NamedTuple):
    """A shoe: its height as a fraction of a leg; the noun's parts that are its upper, its sole and
    its cuff."""

    shaft: float
    upper: str = "body"
    sole: str = "sole"
    cuff: str = ""

    def __call__(self, at: Place) -> Cloth:
        """The distances of its parts."""
        wearer, level = at.wearer, at.level
        foot = level.new_tensor(wearer.low + FOOT)  # below, it goes straight down to the ground
        section = torch.cat([at.points[:, :2], level.maximum(foot)[:, None]], 1)
        skin = wearer.skin(section) - at.layer
        top = wearer.low + max(self.shaft * wearer.leg, SHORTEST)
        ground = wearer.low - SOLE - level
        apart = SPLIT * wearer.wide - at.aside  # not a belly on the ground
        parts = {
            self.upper: most(skin - RIM, level - top, ground, apart),
            self.sole: most(skin - STIFF, level - wearer.low - SOLE, ground, apart),
            self.cuff: most(skin - STIFF, at.band(level, top - EDGE / 2, EDGE / 2), apart),
        }
        return {name: part for name, part in parts.items() if name}


SHOES = {
    "boot": Shoe(0.5, cuff="cuff"),
    "sock": Shoe(0.55, sole="", cuff="cuff"),
    "sneaker": Shoe(0.28),
    "high heel": Shoe(0.28),
    "sandal": Shoe(0.22, upper="straps"),
}
CUTS: dict[str, Callable[[Place], Cloth]] = {
    "shirt": _shirt,
    "jacket": _jacket,
    "dress": _dress,
    "trousers": _trousers,
    "belt": _belt,
    "chestplate": _chestplate,
    "scarf": _scarf,
    "dog collar": _dog_collar,
    "cape": _cape,
    **SHOES,
}


def cut(noun: str, wearer: Measurements, points: Float[Tensor, "n 3"]) -> Cloth:
    """The signed distance of each part of a garment, training units."""
    return CUTS[noun](Place(wearer, points, LAYERS.get(noun, 0.0)))
