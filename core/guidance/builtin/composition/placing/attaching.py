"""Placements of small things on a thing: growing on it, hanging from it, at its front, behind it,
and of what a coiled animal is around."""

import math
from collections.abc import Callable

import torch
from jaxtyping import Float
from torch import Tensor

from core.geometry.init_shape import sample_surface
from core.guidance.builtin.composition.placing.formations import angle_of, around
from core.guidance.builtin.composition.placing.placement import Body, Placement, sized
from core.guidance.builtin.composition.placing.resting import (
    CELLS,
    SAMPLES,
    height_map,
    highest,
    upon,
)
from core.guidance.builtin.words.companions.known_as import FLOWERS, HEADWEAR, POINTED
from core.guidance.builtin.words.grammar.openers import Relation

# Of the first thing's longest side, least and most.
GROWN, ON_TREES, HUNG, AT_FRONT, TRIM = (0.18, 0.5), (0.1, 0.3), (0.15, 0.5), (0.2, 0.6), (0.3, 0.6)
NEXT_TO = (0.2, 1.2)
BLOSSOM = (0.18, 0.26)
BEHIND, IN_COILS, TREE_IN_COILS = (1.25, 1.6), (1.5, 2.2), (2.4, 2.7)
LOW = 0.2  # of a skull's height: so far below its middle bones are crossed
TREES = ("tree", "oak tree", "palm", "christmas tree", "willow tree", "bush")
UPPER = 0.35  # of the height: what grows is higher than this
PEAK, WINDOW, EDGE = 0.08, 3, 2  # of the height: how far below its neighbours a place may be; cells
APART = 0.9  # times its width: distance of two that grow
LOOSER, CLOSER = 8, 0.9  # attempts, each with lower places, and each as close to each other
DEEP = 0.12  # of its height: how deep a blossom without a stem is in what it grows on
SUNK = 0.02  # training units: overlap
NO_CROWN = ("trunk", "pot", "roots", "stand", "base", "star")
AROUND, OUTER = math.radians(55), 0.88  # between hanging things; of the way to the crown's edge
HIGHER = 0.6  # cost of a unit above the crown's lowest point
CLEAR = 0.75  # of the height below the crown: most height of what hangs
BAR = 0.6  # quantile of a handlebar's height, and of how far back it is: the basket's back and top
BARS = ("handlebar", "handlebars", "bars", "grips", "grip")
# Of a hat's height: the top of its brim; its band; how wide its crown is is measured here.
BRIM, BAND, CROWN = 0.15, 0.3, 0.55
CURLED = {"cowboy hat": 0.88}  # above a brim that is curled up
OFF_NECK = 0.3  # of the coils' depth: from their middle towards the back

Spread = Callable[[Body, Body, int], list[Placement]]


def growing(thing: Body, soil: Body, count: int) -> list[Placement]:
    """The placements of things that grow on another, each at a high place of its own."""
    sizes = ON_TREES if soil.words.noun in TREES else GROWN
    place = Placement.of(sized(thing, soil, *(BLOSSOM if _is_blossom(thing) else sizes)))
    borne = thing.placed(place)
    wide = APART * float(borne.sides[:2].max())
    foot = torch.cat([borne.box.mean(0)[:2], borne.box[0, 2:]])
    if _is_blossom(thing):
        foot[2] += DEEP * borne.sides[2]
    spots = _high_places(soil, count, wide)
    down = torch.tensor([0.0, 0.0, SUNK])
    return [Placement.of(place.scale).moved(spot - foot - down) for spot in spots]


def _is_blossom(thing: Body) -> bool:
    """Whether it is a flower without its stem."""
    return thing.words.noun in FLOWERS and bool(thing.words.absent)


def _high_places(soil: Body, count: int, apart: float) -> Float[Tensor, "n 3"]:
    """So many points of the upper surface, as high as their neighbours and apart from each
    other."""
    heights = height_map(soil)
    low, sides = soil.box[0], soil.sides
    known = heights.nan_to_num(-torch.inf)
    near = torch.nn.functional.max_pool2d(known[None], 2 * WINDOW + 1, 1, WINDOW)[0]
    # Not on the very edge.
    inner = -torch.nn.functional.max_pool2d(-known[None], 2 * EDGE + 1, 1, EDGE)[0] > -torch.inf
    upper = inner & (known > low[2] + UPPER * sides[2])
    upper = upper if upper.any() else known > -torch.inf
    for k in range(LOOSER):
        cells = (upper & (known >= near - PEAK * (k + 1) * sides[2])).nonzero()
        cells = cells if len(cells) >= count else (known > -torch.inf).nonzero()
        points = torch.cat(
            [low[:2] + (cells + 0.5) * sides[:2] / CELLS, known[cells[:, 0], cells[:, 1], None]], 1
        )
        found = _spread(points, count, soil)
        gaps = torch.cdist(found, found) + torch.eye(len(found)) * 1e3
        if count == 1 or float(gaps.min()) > apart:
            break
        apart *= CLOSER
    return found


def _spread(points: Float[Tensor, "n 3"], count: int, soil: Body) -> Float[Tensor, "m 3"]:
    """The highest point towards the front, then those farthest from the ones before."""
    front = (points[:, 1] - soil.box[0, 1]) / soil.sides[1].clamp_min(1e-6)
    taken = [int((points[:, 2] - 0.3 * soil.sides[2] * front).argmax())]
    while len(taken) < min(count, len(points)):
        away = torch.cdist(points, points[taken]).amin(1)
        taken.append(int((away * (1.2 - 0.4 * front)).argmax()))
    return points[taken]


def hanging(thing: Body, tree: Body, count: int) -> list[Placement]:
    """The placements of things that hang below a tree's crown, the first in front."""
    crown = tree.bare(*NO_CROWN)
    points = sample_surface(crown.verts, crown.faces, SAMPLES, torch.Generator().manual_seed(0))
    low, sides = points.amin(0), (points.amax(0) - points.amin(0)).clamp_min(1e-6)
    flipped = points * torch.tensor([1.0, 1.0, -1.0])
    under = -highest(flipped, low[:2], sides[:2], CELLS)
    cells = under.isfinite().nonzero()
    spots = torch.cat(
        [low[:2] + (cells + 0.5) * sides[:2] / CELLS, under[cells[:, 0], cells[:, 1], None]], 1
    )
    middle, ground = tree.box.mean(0)[:2], float(tree.box[0, 2])
    scale, found = sized(thing, tree, *HUNG), []
    for k in range(count):
        angle = AROUND * math.ceil(k / 2) * (-1) ** k - math.pi / 2
        way = torch.tensor([math.cos(angle), math.sin(angle)])
        at = middle + OUTER * way * sides[:2] / 2
        cost = (spots[:, :2] - at).norm(dim=1) + HIGHER * (spots[:, 2] - low[2])
        spot = spots[cost.argmin()]
        room = CLEAR * (float(spot[2]) - ground)
        own = min(scale, room / float(thing.sides[2])) if room > 0 else scale
        body = thing.placed(Placement.of(own))
        top = torch.cat([body.box.mean(0)[:2], body.box[1, 2:]])
        found.append(Placement.of(own).moved(spot - top + torch.tensor([0.0, 0.0, SUNK])))
    return found


def surrounding(thing: Body, first: Body, count: int) -> list[Placement]:
    """The placements of things around another that they look at, touching it or each other."""
    scale = sized(thing, first, *NEXT_TO)
    there = thing.placed(Placement.of(scale))
    middle, ground = first.box.mean(0), first.box[0, 2]
    up = torch.stack([middle[0], middle[1], ground - there.box[0, 2]])
    found = []
    for k in range(count):
        near = around(there, count, _radius(there, first, count, k))[k]
        found.append(near.moved(up).of_copy(Placement.of(scale)))
    return found


def _radius(thing: Body, first: Body, count: int, k: int) -> float:
    """How far from the middle one of so many things is that touches the first, by that one's
    points in its way, or touches its neighbours."""
    low = first.verts[first.verts[:, 2] < first.box[0, 2] + thing.sides[2]]
    away = (low - first.box.mean(0))[:, :2]
    angle = angle_of(k, count)
    way = torch.tensor([math.cos(angle), math.sin(angle)])
    wide, deep, _ = thing.sides.tolist()
    across = away @ torch.tensor([-way[1], way[0]])
    in_way = away[across.abs() < wide / 2] @ way
    reach = float((in_way if len(in_way) else away.norm(dim=1)).max())
    apart = wide / 2 / math.tan(math.pi / count) if count > 2 else 0.0
    return max(reach, apart) + deep / 2 - SUNK


SPREAD: dict[Relation, Spread] = {
    "growing": growing,
    "hanging": hanging,
    "surrounding": surrounding,
}


def behind(thing: Body, first: Body) -> Placement:
    """The placement of what is behind the first thing and stands out around it."""
    place = Placement.of(sized(thing, first, *BEHIND))
    there = thing.placed(place)
    middle, mine = first.box.mean(0), there.box.mean(0)
    near = (first.verts - middle)[:, [0, 2]].abs() < 0.4 * first.sides[[0, 2]]
    back = first.verts[near.all(1)]
    back = back if len(back) else first.verts
    shift = middle - mine
    if first.words.noun == "skull":  # the jaw is in front of the crossing
        shift[2] -= LOW * first.sides[2]
    shift[1] = back[:, 1].amax() - SUNK - there.box[0, 1]
    return place.moved(shift)


def at_front(thing: Body, first: Body) -> Placement:
    """The placement of a basket at a bicycle's handlebars, or of a feather at a hat."""
    if first.words.noun in HEADWEAR:
        return _at_hat(thing, first)
    if first.sides[2] < first.sides[:2].min():  # a book that lies
        return upon(thing, first)
    place = Placement.of(sized(thing, first, *AT_FRONT))
    there = thing.placed(place)
    bars = first.of_parts(*BARS)
    if len(bars):
        z, y = float(bars[:, 2].quantile(BAR)), float(bars[:, 1].quantile(1 - BAR))
        top = there.box[1, 2]
    else:
        z, top = float(first.box.mean(0)[2]), there.box.mean(0)[2]
        near = first.verts[(first.verts[:, 2] - z).abs() < 0.1 * first.sides[2]]
        y = float(near[:, 1].amin()) if len(near) else float(first.box[0, 1])
    x = first.box.mean(0)[0] - there.box.mean(0)[0]
    return place.moved(torch.stack([x, y + SUNK - there.box[1, 1], z - top]))


def _at_hat(thing: Body, hat: Body) -> Placement:
    """A tall thing upright at the hat's side, another in front of its crown."""
    place = Placement.of(sized(thing, hat, *(BLOSSOM if _is_blossom(thing) else TRIM)))
    there = thing.placed(place)
    tall = float(there.sides[2]) > 1.4 * float(there.sides[:2].min())
    z = float(hat.box[0, 2] + BAND * hat.sides[2])
    above = float(hat.box[0, 2] + CURLED.get(hat.words.noun, CROWN) * hat.sides[2])
    ring = hat.verts[(hat.verts[:, 2] - above).abs() < 0.06 * hat.sides[2]]
    ring = ring if len(ring) else hat.verts
    middle, mine = (ring.amin(0) + ring.amax(0)) / 2, there.box.mean(0)
    if thing.words.noun in FLOWERS:
        tall = False
    if tall:
        x = ring[:, 0].amax() - SUNK - there.box[0, 0]
        return place.moved(torch.stack([x, middle[1] - mine[1], z - there.box[0, 2]]))
    high = float(there.sides[2])
    z = max(z, float(hat.box[0, 2]) + BRIM * float(hat.sides[2]) + high / 2)
    before = (hat.verts[:, 0] - middle[0]).abs() < there.sides[0] / 2
    before &= (hat.verts[:, 2] - z).abs() < high / 4
    front = hat.verts[before] if before.any() else ring
    y = front[:, 1].amin() + SUNK - there.box[1, 1]
    return place.moved(torch.stack([middle[0] - mine[0], y, z - mine[2]]))


def in_coils(thing: Body, coiled: Body) -> Placement:
    """The placement of what an animal is coiled around: upright in the coils, behind its neck."""
    turn = torch.eye(3)
    if thing.words.noun in POINTED:  # point down
        turn = torch.diag(torch.tensor([1.0, -1.0, -1.0]))
    sizes = TREE_IN_COILS if thing.words.noun in TREES else IN_COILS
    place = Placement.of(sized(thing, coiled, *sizes), turn)
    there = thing.placed(place)
    mine = there.box.mean(0)
    half = coiled.box[0, 2] + 0.6 * coiled.sides[2]
    coils = coiled.verts[coiled.verts[:, 2] < half]
    low, high = coils.amin(0), coils.amax(0)
    middle = (low + high) / 2
    y = middle[1] + OFF_NECK * (high[1] - low[1]) / 2 - mine[1]
    return place.moved(torch.stack([middle[0] - mine[0], y, low[2] - there.box[0, 2]]))
