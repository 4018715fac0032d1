"""Body measurements of a wearer, as for a tailor."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
import torch
import torch.nn.functional as F
from jaxtyping import Float
from scipy import ndimage
from torch import Tensor

from core.geometry.parts.assembly import NEAR, KnownParts
from core.geometry.tet_grid import EXTENT
from core.guidance.builtin.composition.placing.holding import HANDED
from core.guidance.builtin.composition.placing.placement import EYES, Body
from core.guidance.builtin.composition.placing.wearing import NO_HEAD, Head, head_of, neck_of
from core.guidance.builtin.palette import looks

LIMBS = ("arms", "legs", "limbs", "claws")
# Parts that go through cloth.
BARE = frozenset(NO_HEAD).difference(LIMBS) | {"bow tie", "spikes", "plates", "shell", "joints"}
FEET = "feet", "shoes", "boots", "hooves", "legs"
CRAWLING = frozenset("snake snail caterpillar seal walrus stingray".split())
CELLS = 88  # of the lattice of the dressed parts' distances
TALL = 0.8  # of the length: least height of an upright body
OVERHEAD = 0.2  # of the height: most distance of an upright body's head in front of its trunk
SLIM = 0.04  # training units
LEGS, NO_LEGS = 0.12, 0.28  # of the height: a crotch's, at least; where a hem is without legs
LONGEST = 0.45  # of the height up to the neck: legs
COLLAR = 0.1  # of the head's width, above the neck's narrowest place, of an upright body
HANDS = 0.16  # of the reach from side to side, on each
HAND = 0.2  # of an arm that hangs
HANGING = 0.4  # of a trunk's height: this high at its side it is a hanging arm, not a hand
# From the head's middle to the neck, on all fours: of the head's width, of the length, at most.
HEADED, SHOULDERS = 0.5, 0.22
DOWN = torch.tensor([0.0, 0.0, -1.0])
STEEP = F.normalize(torch.tensor([0.0, 1.0, -0.7]), dim=0)  # around the throat, on all fours
ONWARD = F.normalize(torch.tensor([0.0, 1.0, -0.4]), dim=0)  # over the shoulders
COVERED = 0.55  # of a trunk without hind legs
APART = 0.12  # of the feet's length: between two rows of them, at least
CHEST = 0.35  # of the head's width: half a trunk's column
SLEEVE = 0.45  # of a leg, from the ground

Point = Float[Tensor, " 3"]
Field = Callable[[Float[Tensor, "n 3"]], Float[Tensor, " n"]]


@dataclass(frozen=True)
class Measurements:
    """Measurements for cutting clothes, training units."""

    skin: Field  # signed distance of trunk, limbs and head
    head: Head
    stands: bool  # upright; or on all fours
    low: float  # the ground
    crotch: float  # z, or a little above the ground; of an animal, its belly's
    has_legs: bool
    neck: Point  # where a shirt begins
    down: Point  # from there into the trunk, a unit vector
    throat: Point  # where a collar is
    throatward: Point
    neck_wide: float
    front: float  # y of the trunk
    back: float
    hind: float  # y in front of the hind legs; of an upright body its back
    wide: float  # half of the trunk's width, of an upright body without arms
    reach: float  # |x| where hands begin that are held out
    sleeve: float  # z, where sleeves end: an animal's, and of arms that hang
    raised: float  # z up to which raised arms go next to the head

    @classmethod
    def of(cls, body: Body, parts: KnownParts) -> "Measurements":
        """Of a drawn body."""
        head, dressed = head_of(body), body.without(*BARE)
        skin = _skin(parts, body.words.noun)
        make = cls._upright if stands_upright(dressed, head) else cls._on_all_fours
        return make(body, head, dressed, skin)

    @classmethod
    def _upright(
        cls, body: Body, head: Head, dressed: Float[Tensor, "n 3"], skin: Field
    ) -> "Measurements":
        neck = neck_of(body, head)
        neck = neck._replace(middle=torch.tensor([_axis(body, head), *neck.middle[1:].tolist()]))
        at = neck.middle - COLLAR * head.wide * DOWN
        top, low, high = float(at[2]), float(body.box[0, 2]), float(dressed[:, 2].amax())
        # Between the legs there is nothing up to the crotch.
        begin = torch.cat([neck.middle[:2], torch.tensor([low + LEGS * (high - low)])])
        gap = _inside(lambda points: -skin(points), begin, -DOWN)
        has_legs = 0 < gap < top - float(begin[2])
        crotch = float(begin[2]) + gap if has_legs else low + NO_LEGS * (high - low)
        crotch = min(crotch, low + LONGEST * (top - low))
        middle = torch.cat([neck.middle[:2], torch.tensor([(crotch + top) / 2])])
        # Not as far as a tail, or an arm.
        front, back, wide = (
            _inside(skin, middle, torch.tensor(way))
            for way in ([0.0, -1.0, 0.0], [0.0, 1.0, 0.0], [1.0, 0.0, 0.0])
        )
        off_axis = dressed - middle * torch.tensor([1.0, 0.0, 0.0])
        reach, sleeve = _arms(off_axis, crotch, top, wide)
        return cls(
            skin,
            head,
            stands=True,
            low=low,
            crotch=crotch,
            has_legs=_walks(body, has_legs),
            neck=at,
            down=DOWN,
            throat=at,
            throatward=DOWN,
            neck_wide=neck.wide,
            front=float(middle[1]) - front,
            back=float(middle[1]) + back,
            hind=float(middle[1]) + back,
            wide=wide or reach,
            reach=reach,
            sleeve=low if sleeve is None else sleeve,
            raised=head.eyes if body.words.noun in HANDED else top,
        )

    @classmethod
    def _on_all_fours(
        cls, body: Body, head: Head, dressed: Float[Tensor, "n 3"], skin: Field
    ) -> "Measurements":
        low, high = float(body.box[0, 2]), float(dressed[:, 2].amax())
        front, hind = _rows(dressed[dressed[:, 2] < low + LEGS * (high - low), 1])
        ends = (float(dressed[:, 1].amin()), float(dressed[:, 1].amax()))
        between = sum(ends if front is None or hind is None else (front, hind)) / 2
        under = torch.tensor([float(head.middle[0]), between, low])
        belly = low + _inside(lambda points: -skin(points), under, -DOWN)
        crotch = belly if low + SLIM < belly < high else low + NO_LEGS * (high - low)
        reached = min(HEADED * head.wide, SHOULDERS * (ends[1] - ends[0]))
        at = head.middle + reached * ONWARD
        if front is not None and front > head.front:  # its shoulders are over its front legs
            at = torch.tensor([float(head.middle[0]), front - SLIM, crotch])
        trunk = dressed[((dressed - at) @ ONWARD > 0) & (dressed[:, 2] > crotch)]
        trunk = trunk if len(trunk) else dressed
        column = trunk[(trunk[:, 0] - head.middle[0]).abs() < CHEST * head.wide]
        column = column if len(column) else trunk
        back = float(column[:, 1].amax())
        wide = float(trunk[:, 0].abs().amax())
        return cls(
            skin,
            head,
            stands=False,
            low=low,
            crotch=crotch,
            has_legs=_walks(body, front is not None),
            neck=at,
            down=ONWARD,
            throat=head.middle + reached * STEEP,
            throatward=STEEP,
            neck_wide=head.wide,
            front=float(column[:, 1].amin()),
            back=back,
            hind=float(at[1]) + COVERED * (back - float(at[1])) if hind is None else hind,
            wide=wide,
            reach=wide,
            sleeve=low + SLEEVE * (crotch - low),
            raised=low,
        )

    def below_neck(self, points: Float[Tensor, "n 3"]) -> Float[Tensor, " n"]:
        """Distance below the neck, into the trunk."""
        return (points - self.neck.to(points)) @ self.down.to(points)

    def below_throat(self, points: Float[Tensor, "n 3"]) -> Float[Tensor, " n"]:
        """Distance from the middle of a collar."""
        return (points - self.throat.to(points)) @ self.throatward.to(points)

    @property
    def leg(self) -> float:
        """The length from the ground to the crotch."""
        return self.crotch - self.low

    @property
    def belly(self) -> float:
        """The height of its lowest place."""
        return self.crotch - SLIM


def _axis(body: Body, head: Head) -> float:
    """The x of a body's middle: of the eyes, otherwise of the box."""
    middle = head.middle if len(body.of_parts(*EYES)) else body.box.mean(0)
    return float(middle[0])


def _walks(body: Body, apart: bool) -> bool:
    """Whether shoes fit: with legs that are ``apart``, or with parts that are feet."""
    has_feet = apart or len(body.of_parts(*FEET)) > 0
    return has_feet and body.words.noun not in CRAWLING


def stands_upright(dressed: Float[Tensor, "n 3"], head: Head) -> bool:
    """Whether a body, as its points without what goes through cloth, is not on all fours."""
    sides = dressed.amax(0) - dressed.amin(0)
    ahead = float(dressed[:, 1].mean() - head.middle[1])
    return ahead < OVERHEAD * float(sides[2]) and bool(sides[2] > TALL * sides[1])


def _arms(
    dressed: Float[Tensor, "n 3"], crotch: float, top: float, wide: float
) -> tuple[float, float | None]:
    """How far sleeves go to the side on arms that are held out, and down on hanging arms; None for
    arms that do not hang."""
    trunk = dressed[(dressed[:, 2] > crotch) & (dressed[:, 2] < top)]
    aside = trunk[:, 0].abs()
    reach = float(aside.amax()) if len(trunk) else wide
    hands = trunk[aside > (1 - HANDS) * reach, 2]
    if not len(hands) or float(hands.amax() - hands.amin()) < HANGING * (top - crotch):
        return (1 - HANDS) * reach, None
    low = float(dressed[:, 2].amin()) + LEGS * (top - crotch)
    arms = dressed[(dressed[:, 0].abs() > wide + SLIM) & (dressed[:, 2] > low), 2]
    lowest = float(arms.amin()) if len(arms) else crotch
    return EXTENT, lowest + HAND * (top - lowest)


def _rows(y: Float[Tensor, " n"]) -> tuple[float | None, float | None]:
    """Where the front feet and the hind feet begin; Nones without two rows."""
    places = y.sort().values
    gaps = places[1:] - places[:-1]
    if not len(gaps) or float(gaps.max()) < APART * float(places[-1] - places[0]):
        return None, None
    return float(places[0]), float(places[gaps.argmax() + 1])


def _inside(skin: Field, start: Point, way: Point) -> float:
    """How far inside a place on a line is."""
    steps = torch.linspace(0, EXTENT, CELLS)
    outside = skin(start + steps[:, None] * way) > 0
    return float(steps[outside.long().argmax()]) if outside.any() else EXTENT


def _skin(parts: KnownParts, noun: str) -> Field:
    """The distance from the dressed parts, exact near them, from a lattice."""
    count = len(parts.forms.flat)
    names = list(looks(noun))[:count]
    dressed = [k for k, name in enumerate(names) if name not in BARE] or list(range(count))
    side = torch.linspace(-EXTENT, EXTENT, CELLS + 1)
    nodes = torch.stack(torch.meshgrid(side, side, side, indexing="ij"), -1).view(-1, 3)
    known = parts.near(nodes)[:, dressed].amin(1).view(CELLS + 1, CELLS + 1, CELLS + 1)
    nodes_off = np.asarray(ndimage.distance_transform_edt(known.numpy() > NEAR))
    beyond = torch.from_numpy(nodes_off).to(known) * (2 * EXTENT / CELLS)
    known = known.where(known <= NEAR, NEAR + beyond)
    values = known.permute(2, 1, 0)[None, None]  # grid_sample's first coordinate is the last axis's

    def at(points: Float[Tensor, "n 3"]) -> Float[Tensor, " n"]:
        where = (points / EXTENT)[None, None, None].to(values)
        found = F.grid_sample(values, where, align_corners=True, padding_mode="border")
        return found[0, 0, 0, 0].to(points)

    return at
