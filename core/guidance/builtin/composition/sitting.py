"""Somebody who sits on something or rides it: the pose, and where that lies which bears them."""

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import Literal, NamedTuple

import torch
from jaxtyping import Bool, Float
from torch import Tensor

from core.geometry.union import Region
from core.guidance.builtin.composition.copies import about_x, about_z, copies_of
from core.guidance.builtin.composition.legs import HANGING, HIP, Legs, legs_of
from core.guidance.builtin.composition.placement import EYES, Body, Placement, joined, sized
from core.guidance.builtin.composition.posing import Bone, Distances, Pose, Posed, joint
from core.guidance.builtin.composition.resting import (
    CELLS,
    FOOT,
    LYING,
    MOUNT,
    MOUNTS,
    SEAT,
    SUNK,
    height_map,
    spot_on,
)
from core.guidance.builtin.composition.thing import Thing
from core.guidance.builtin.composition.wearing import head_of
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
# What one sits on without a word of it; what one stands on, if it is not said that one sits.
ALSO_SEATS = SEATS | {"bench", "stool", "ottoman", "toilet"}
BOARDS = LYING | {"sled", "raft", "treadmill", "trampoline"}
ALSO_MOUNTS = MOUNTS | {"jet ski", "snowmobile", "kick scooter", "griffin", "centaur", "pegasus"}
SADDLES = ("saddle", "seat", "seats")
# Something is over or around their seats.
HIDDEN = ("swing", "toilet", "wheelchair", "go-kart", "high chair")
APART = 0.02  # training units off the middle: two seats
# What stands out of a mount, and is not between the legs.
ASIDE = tuple("wings ears horns antlers mane tail arms mirrors handlebars handlebar".split())
SEAT_SIZES = (0.5, 1.3)  # of the figure's height, the longest side of what it sits on
# In robes to the ground, or with a tail: of their height, where a seat is; of their depth, what is
# before it; of their width, what of a seat is looked at.
ROBED = frozenset("king queen princess wizard witch angel vampire mermaid".split()) | {
    "grim reaper"
}
HIPS, LAP, ROBE = 0.26, 0.45, 0.4
DECKS = (0.8, 2.0)  # the same of what it sits in
DEEP_IN = 0.12  # of the figure's height: how deep one sits in a car
ROOF, ROOMIER = "roof", 1.3  # times as large, at most, so that one has room below its roof
STEP = 0.12  # training units: where a seat ends or something is on it
PELVIS = 0.7  # of its depth, that is on the seat at least
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
BARE = 0.1  # of the radius, of a leg that stays in the coat that it comes out of
INNER = 0.96  # of a joint's ball, the shin's: no two surfaces are in one place
STEPS, FARTHEST = 40, 5.0  # on the way out of the trunk, radii
GROUND = 0.02  # training units
# What is worn on the legs; training units by which it goes beyond them, at most, and all around
# their joints.
LEGWEAR = frozenset("trousers boot sneaker sandal sock".split()) | {"high heel"}
CLOTHED, PADDED = 0.09, 0.04


class Seat(NamedTuple):
    """Where what bears somebody lies, and how the legs are."""

    place: Placement
    thigh: tuple[float, float]  # forward from the vertical, and outwards
    shin: tuple[float, float] | None  # None: the legs are straight


def posture_of(verb: str, relation: Relation, noun: str) -> Posture:
    """How one is on or in such a thing, as far as legs go."""
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
    """The drawn things of a composition, of which the first sits or rides, if it does that and has
    legs; with its clothes."""
    things, found = list(drawn), list(bodies)
    first, parts = bodies[0], drawn[0].parts()
    worn = [k for k, relation in enumerate(relations, 1) if relation == "wears"]
    dresses = [bodies[k] for k in worn if bodies[k].words.noun == "dress"]
    robed = bool(dresses) or first.words.noun in ROBED
    said = zip(first.words.companions, relations, bodies[1:], strict=False)
    for one, relation, support in said:
        posture = posture_of(one.verb, relation, support.words.noun)
        if posture == "sits" and relation == "on" and robed:
            found[0] = replace(first, rests=_before(joined([first, *dresses]), support))
            break
        legs = legs_of(first, parts) if posture and parts and not dresses else None
        heaped = first.words.count > 1 and relation == "in"
        if legs is None or parts is None or first.words.order != "row" or heaped:
            continue
        seat = _seat(posture, relation, first, support, legs)
        if seat is None:
            continue
        bare, clothed = posed(legs, seat, parts.distances)
        things[0] = Posed(drawn[0], bare)
        found[0] = replace(bare.body(first), rests=seat.place, standing=first)
        for k in worn:
            if (noun := bodies[k].words.noun) in CLOTHING:
                pose = clothed if noun in LEGWEAR else bare
                things[k], found[k] = Posed(drawn[k], pose), pose.body(bodies[k])
        break
    return things, found


def _seat(
    posture: Posture, relation: Relation, first: Body, support: Body, legs: Legs
) -> Seat | None:
    """On what bears it; None where several would ride one mount."""
    each = support.words.count == first.words.count
    if posture == "rides":
        return _ridden(first, support, legs) if each else None
    trunk = _trunk(first, legs)
    trunk = trunk if each else trunk.group(copies_of(first))
    return (_sat_in if relation == "in" else _sat_on)(trunk, first, support, legs)


def posed(legs: Legs, seat: Seat, distances: Distances) -> tuple[Pose, Pose]:
    """The pose in which both legs are as they are on the seat; that of what is worn on them."""
    way = _turn(seat.thigh, 1) @ torch.tensor([0.0, 0.0, -1.0])
    out = _way_out(legs, _above(_boxes(legs)), way, distances)
    return _bent(legs, seat, out, 0.0, 0.0), _bent(legs, seat, out, CLOTHED, PADDED)


def _boxes(legs: Legs, beyond: float = 0.0) -> list[tuple[Tensor, Tensor]]:
    """Around each leg, and so far beyond it, but not up, or across the middle."""
    wider = torch.tensor([[0.0, -beyond, -beyond], [beyond, beyond, 0.0]])
    return [_mirrored(legs.box + wider, side) for side in (1, -1)]


def _above(boxes: list[tuple[Tensor, Tensor]]) -> Bone:
    """The trunk, which has all that is not in the boxes."""
    return Bone(tuple(Region((low, high)) for low, high in boxes), Placement.of(), within=False)


def _bent(legs: Legs, seat: Seat, out: float, beyond: float, padded: float) -> Pose:
    """The pose of what goes so far beyond the legs, and around their joints; ``out``: how far they
    are moved along themselves."""
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
    """Forward from the vertical, then outwards."""
    forward, outwards = angles
    return about_z(side * outwards) @ about_x(-forward)


def _way_out(legs: Legs, trunk: Bone, way: Float[Tensor, " 3"], distances: Distances) -> float:
    """How far a leg is moved along itself, so that it is not lost in a coat."""
    far = torch.linspace(0, FARTHEST * legs.radius, STEPS)
    points = legs.hip + far[:, None] * way
    inside = torch.maximum(distances(points).amin(1), trunk.gap(points)) < 0
    exit_at = float(far[int((~inside).long().argmax())]) if not inside.all() else float(far[-1])
    return max(exit_at - (HIP + BARE) * legs.radius, 0.0)


def _trunk(body: Body, legs: Legs) -> Body:
    """What does not bend: all above the crotch."""
    above = body.verts[:, 2] >= legs.crotch
    none = body.faces[:0]
    return replace(body, verts=body.verts[above], part=body.part[above], faces=none)


def _sat_on(trunk: Body, first: Body, support: Body, legs: Legs) -> Seat:
    """On a seat: at the depth at which the knees are over its edge, or with straight legs."""
    place = Placement.of(sized(support, first, *SEAT_SIZES))
    below = support.placed(place)
    seat = _only(below, *SADDLES) if support.words.noun in HIDDEN else below
    return _sitting(trunk, seat, place, legs, spot_on(trunk, seat), float(below.box[0, 2]))


def _before(first: Body, support: Body) -> Placement:
    """A seat in which the robe of who has no legs to bend is sunk, but for its front."""
    place = Placement.of(sized(support, first, *SEAT_SIZES))
    below = support.placed(place)
    spot = spot_on(first, below)
    rows = _rows(below, float(spot[0]), ROBE * float(first.sides[0]) / 2)
    front, _ = rows.seat(float(spot[1]), float(spot[2]))
    low = first.box[0]
    hips = min(HIPS * float(first.sides[2]), float(spot[2] - below.box[0, 2]))
    at = float(low[1]) + LAP * float(first.sides[1])
    return place.moved(torch.tensor([-float(spot[0]), at - front, float(low[2]) + hips - spot[2]]))


def _sat_in(trunk: Body, first: Body, support: Body, legs: Legs) -> Seat:
    """With straight legs, on the deck or the seats of what carries one, below its roof."""
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
        room = float(roof[:, 2].amax() - spot[2])
        tall = float(trunk.box[1, 2]) - legs.crotch - deep
        scale = min(max(tall / max(room, deep), 1.0), ROOMIER)
        place, spot = place.then(scale, torch.zeros(3)), scale * spot
    else:
        spot = spot_on(trunk, below, SEAT)
    return Seat(place.moved(foot - spot + torch.tensor([0.0, 0.0, deep])), (FLAT, DOLL), None)


def _cushion(seat: Body) -> Float[Tensor, " 3"]:
    """The middle of a seat before its back."""
    x, half = float(seat.box.mean(0)[0]), float(seat.sides[0]) / 4
    rows = _rows(seat, x, half)
    low = rows.z[~rows.z.isnan()].amin()
    return torch.stack([torch.tensor(x), rows.y[rows.z - low < STEP].mean(), low])


def _only(body: Body, *names: str) -> Body:
    """What a body has of such parts, on one side where there is one on each; or all of it."""
    mine = body.among(*names)
    beside = body.verts[:, 0] < 0
    mine = mine & beside if (body.verts[mine][:, 0].abs() > APART).all() else mine
    return _kept(body, mine)


def _kept(body: Body, mine: Bool[Tensor, " v"]) -> Body:
    """What a body has of such points, or all of it."""
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
    behind = float((pelvis[:, 1] - hip).quantile(0.98))
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
    """How far forward a shin goes, so that its foot is above the ground."""
    return math.acos(min(max(drop / length, 0.0), 1.0))


class _Rows(NamedTuple):
    """The heights of what bears somebody, along y."""

    y: Float[Tensor, " c"]
    z: Float[Tensor, " c"]  # NaN where nothing is

    def seat(self, at: float, rest: float) -> tuple[float, float]:
        """The front and the back end of the seat around a place: where it falls off, or where
        something stands on it."""
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
        """Whether nothing stands before the seat."""
        before = self.z[self.y < front]
        return not bool((before > rest + STEP).any())

    def height(self, at: float, half: float, otherwise: float) -> float:
        """Of the seat under a pelvis."""
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


def _ridden(first: Body, support: Body, legs: Legs) -> Seat:
    """Astride, the thighs around what is ridden, or on top of it where it is too broad."""
    place = Placement.of(sized(support, first, *MOUNT))
    below = support.placed(place)
    saddle = below.of_parts(*SADDLES)
    if len(saddle):
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
