"""Placements of seats and mounts, and the pose of the legs on them."""

import math
from dataclasses import replace
from typing import NamedTuple

import torch
from jaxtyping import Bool, Float
from torch import Tensor

from core.guidance.builtin.composition.placing.placement import EYES, Body, Placement, sized
from core.guidance.builtin.composition.placing.resting import (
    BROOM,
    BROOMS,
    CELLS,
    FOOT,
    MOUNT,
    SEAT,
    SUNK,
    height_map,
    levelled,
    on_handle,
    spot_on,
)
from core.guidance.builtin.composition.placing.wearing import head_of
from core.guidance.builtin.composition.poses.legs import HANGING, HIP, Legs

SADDLES = ("saddle", "seat", "seats")
# Something is over or around their seats.
HIDDEN = ("swing", "toilet", "wheelchair", "go-kart", "high chair")
APART = 0.02  # training units off the middle: two seats
# Parts that stand out of a mount and are not between the legs.
ASIDE = tuple("wings ears horns antlers mane tail arms mirrors handlebars handlebar".split())
SEAT_SIZES = (0.5, 1.3)  # of the figure's height: the longest side of its seat
DECKS = (0.8, 2.0)  # the same for a vehicle
# In robes to the ground, or with a tail: of the height, the seat's place; of the depth, the part in
# front of it; of the width, the searched part of a seat.
HIPS, LAP, ROBE = 0.26, 0.45, 0.4
DEEP_IN = 0.12  # of the figure's height: how deep one sits in a car
ROOF = "roof"
STEP = 0.12  # training units: where a seat ends or something is on it
PELVIS = 0.7  # of its depth: least part on the seat
BACKMOST = 0.98  # quantile of a pelvis's depth
FLAT, SPREAD = math.radians(87), math.radians(8)  # sitting: thighs from the vertical; apart
DOLL = math.radians(14)  # how far apart straight legs are
ASTRIDE, OUTWARD = math.radians(62), (math.radians(10), math.radians(78))
SHORT = math.radians(75), math.radians(35)  # astride without knees: forward; outwards at least
HUGGING, TOES = 0.6, 0.25  # of the radius, of a leg in a flank; of the thighs' angle, the feet's
SADDLED = 0.35  # of the radius: how deep one sits on a back
NAPE = 0.9  # of a head's width, behind its middle
BESIDE = 1.5  # radii along a mount, between the legs
BROAD_BACK = math.radians(82), math.radians(40)  # astride on what is too broad for knees
BROAD = 0.9  # quantile of what is between the legs
GROUND = 0.02  # training units


class Seat(NamedTuple):
    """The placement of the seat or mount, and the pose of the legs."""

    place: Placement
    thigh: tuple[float, float]  # forward from the vertical, and outwards; radians
    shin: tuple[float, float] | None  # None: the legs are straight


def trunk_of(body: Body, legs: Legs) -> Body:
    """The part that does not bend: all above the crotch."""
    above = body.verts[:, 2] >= legs.crotch
    none = body.faces[:0]
    return replace(body, verts=body.verts[above], part=body.part[above], faces=none)


def sat_on(trunk: Body, first: Body, support: Body, legs: Legs) -> Seat:
    """On a seat: at the depth at which the knees are over its edge, or with straight legs."""
    place = Placement.of(sized(support, first, *SEAT_SIZES))
    below = support.placed(place)
    seat = _only(below, *SADDLES) if support.words.noun in HIDDEN else below
    return _sitting(trunk, seat, place, legs, spot_on(trunk, seat), float(below.box[0, 2]))


def sunk_before(first: Body, support: Body) -> Placement:
    """A seat into which the robe of a figure without legs to bend is sunk, except for its front."""
    place = Placement.of(sized(support, first, *SEAT_SIZES))
    below = support.placed(place)
    spot = spot_on(first, below)
    rows = _rows(below, float(spot[0]), ROBE * float(first.sides[0]) / 2)
    front, _ = rows.seat(float(spot[1]), float(spot[2]))
    low = first.box[0]
    hips = min(HIPS * float(first.sides[2]), float(spot[2] - below.box[0, 2]))
    at = float(low[1]) + LAP * float(first.sides[1])
    return place.moved(torch.tensor([-float(spot[0]), at - front, float(low[2]) + hips - spot[2]]))


def sat_in(trunk: Body, first: Body, support: Body, legs: Legs) -> Seat:
    """With straight legs, on the deck or the seats of a vehicle, below its roof."""
    place = Placement.of(sized(support, first, *DECKS))
    below = support.placed(place)
    deep = DEEP_IN * float(first.sides[2])
    foot = torch.tensor([0.0, float(legs.hip[1]), legs.crotch])
    roof = below.of_parts(ROOF)
    if len(roof):
        low = _kept(below, ~below.among(ROOF))
        spot = (
            _cushion(_only(low, *SADDLES)) if len(low.of_parts(*SADDLES)) else spot_on(trunk, low)
        )
    else:
        spot = spot_on(trunk, below, SEAT)
    return Seat(place.moved(foot - spot + torch.tensor([0.0, 0.0, deep])), (FLAT, DOLL), None)


def _cushion(seat: Body) -> Float[Tensor, " 3"]:
    """The middle of a seat in front of its back."""
    x, half = float(seat.box.mean(0)[0]), float(seat.sides[0]) / 4
    rows = _rows(seat, x, half)
    low = rows.z[~rows.z.isnan()].amin()
    return torch.stack([torch.tensor(x), rows.y[rows.z - low < STEP].mean(), low])


def _only(body: Body, *names: str) -> Body:
    """The points of such parts, on one side if there is one on each; otherwise all points."""
    mine = body.among(*names)
    beside = body.verts[:, 0] < 0
    mine = mine & beside if (body.verts[mine][:, 0].abs() > APART).all() else mine
    return _kept(body, mine)


def _kept(body: Body, mine: Bool[Tensor, " v"]) -> Body:
    """The points under the mask, or all points without any."""
    faces = body.faces[mine[body.faces].all(1)]
    if not len(faces):
        return body
    kept, renumbered = faces.unique(return_inverse=True)
    return replace(body, verts=body.verts[kept], part=body.part[kept], faces=renumbered)


def _sitting(
    trunk: Body,
    below: Body,
    place: Placement,
    legs: Legs,
    spot: Float[Tensor, " 3"],
    ground: float,
) -> Seat:
    half, hip = legs.half, float(legs.hip[1])
    pelvis = trunk.without(*HANGING)
    low = pelvis[pelvis[:, 2] < legs.crotch + legs.radius]
    pelvis = low if len(low) else pelvis
    inner = pelvis[pelvis[:, 0].abs() < half]
    pelvis = inner if len(inner) else pelvis
    behind = float((pelvis[:, 1] - hip).quantile(BACKMOST))
    rows = _rows(below, float(spot[0]), half)
    front, back = rows.seat(float(spot[1]), float(spot[2]))
    knee = legs.knee
    at = min(max(float(spot[1]), front + PELVIS * behind), back - behind)
    thigh, shin = (FLAT, DOLL), None
    if knee is not None and rows.open_before(front, float(spot[2])):
        reach = float(legs.hip[2] - knee[2]) - legs.radius - GROUND
        if reach > PELVIS * behind:
            at = min(front + reach, back - behind)
            at = max(at, front + PELVIS * behind)
            thigh = (FLAT, SPREAD)
            rest = rows.height(at, behind, float(spot[2]))
            drop = rest - ground + (1 - GROUND) * legs.radius
            shin = (_tilt(float(knee[2]) - legs.sole, drop), SPREAD)
    rest = rows.height(at, behind, float(spot[2]))
    bottom = legs.crotch - (1 - HIP) * legs.radius + SUNK
    shift = torch.tensor([-float(spot[0]), hip - at, bottom - rest])
    return Seat(place.moved(shift), thigh, shin)


def _tilt(length: float, drop: float) -> float:
    """How far forward a shin goes so that its foot is above the ground."""
    return math.acos(min(max(drop / length, 0.0), 1.0))


class _Rows(NamedTuple):
    """Heights of the seat or mount along y."""

    y: Float[Tensor, " c"]
    z: Float[Tensor, " c"]  # NaN where nothing is

    def seat(self, at: float, rest: float) -> tuple[float, float]:
        """The front and the back end of the seat around a place: where it drops, or where something
        is on it."""
        middle = int((self.y - at).abs().argmin())
        level = (self.z - rest).abs() < STEP
        low = high = middle
        while low > 0 and level[low - 1]:
            low -= 1
        while high < len(self.y) - 1 and level[high + 1]:
            high += 1
        half = float(self.y[1] - self.y[0]) / 2
        return float(self.y[low]) - half, float(self.y[high]) + half

    def open_before(self, front: float, rest: float) -> bool:
        """Whether nothing is in front of the seat."""
        before = self.z[self.y < front]
        return not bool((before > rest + STEP).any())

    def height(self, at: float, half: float, otherwise: float) -> float:
        """The seat's height below a pelvis."""
        under = self.z[(self.y - at).abs() < half]
        under = under[~under.isnan() & ((under - otherwise).abs() < STEP)]
        return float(under.median()) if len(under) else otherwise


def _rows(below: Body, x: float, half: float) -> _Rows:
    """Each row's height near x."""
    heights, low, sides = height_map(below), below.box[0], below.sides
    places = (torch.arange(CELLS) + 0.5) / CELLS
    across = ((low[0] + places * sides[0]) - x).abs() <= max(half, float(sides[0]) / CELLS)
    rows = heights[across].nanmedian(0).values
    return _Rows(low[1] + places * sides[1], rows)


def _on_back(mount: Body, half: float) -> Float[Tensor, " 3"]:
    """Above the middle of its feet, or behind its head."""
    feet = mount.verts[mount.verts[:, 2] < mount.box[0, 2] + FOOT * mount.sides[2]]
    x, y, _ = ((feet.amin(0) + feet.amax(0)) / 2).tolist()
    if len(mount.of_parts(*EYES)):
        head = head_of(mount)
        y = max(y, float(head.middle[1]) + NAPE * head.wide)
    near = mount.verts[((mount.verts[:, :2] - torch.tensor([x, y])).abs() < half).all(1)]
    z = float(near[:, 2].amax()) if len(near) else float(mount.box[1, 2])
    return torch.tensor([x, y, z])


def ridden(first: Body, support: Body, legs: Legs) -> Seat:
    """Astride, the thighs around the mount, or on top of one that is too broad."""
    on_broom = support.words.noun in BROOMS
    sizes = BROOM if on_broom else MOUNT
    place = Placement.of(sized(support, first, *sizes), levelled(first, support))
    below = support.placed(place)
    saddle = below.of_parts(*SADDLES)
    if on_broom:
        spot = on_handle(below)
    elif len(saddle):
        low, high = saddle.amin(0), saddle.amax(0)
        spot = torch.cat([(low + high)[:2] / 2, high[2:]])
    else:
        spot = _on_back(below, legs.half / 2)
    knee = legs.knee
    length = float(legs.hip[2]) - (legs.sole if knee is None else float(knee[2]))
    forward, least = SHORT if knee is None else (ASTRIDE, OUTWARD[0])
    full = float(legs.hip[2]) - legs.sole
    flank = below.without(*ASIDE)
    flank = flank[
        ((flank[:, 1] - spot[1]).abs() < BESIDE * legs.radius)
        & (flank[:, 2] < spot[2] - SADDLED * legs.radius)
        & (flank[:, 2] > spot[2] - full)
    ]
    wide = float((flank[:, 0] - spot[0]).abs().quantile(BROAD)) if len(flank) else 0.0
    aside = wide + (1 - HUGGING) * legs.radius - float(legs.hip[0])
    needed = aside / (length * math.sin(forward))
    broad = needed > math.sin(OUTWARD[1])
    if broad:
        forward, outwards = BROAD_BACK
    else:
        outwards = min(max(math.asin(max(needed, 0.0)), least), OUTWARD[1])
    shin = None
    if knee is not None and not broad:
        rise = float(spot[2] - below.box[0, 2]) + legs.radius - length * math.cos(forward)
        shin = (_tilt(float(knee[2]) - legs.sole, rise), TOES * outwards)
    bottom = legs.crotch + SADDLED * legs.radius
    shift = torch.tensor([0.0, float(legs.hip[1]), bottom]) - spot
    return Seat(place.moved(shift), (forward, outwards), shin)
