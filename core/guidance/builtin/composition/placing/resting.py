"""One thing on another, or in it."""

import torch
from jaxtyping import Float, Int
from torch import Tensor

from core.geometry.init_shape import sample_surface
from core.guidance.builtin.composition.placing.bunches import TOGETHER
from core.guidance.builtin.composition.placing.placement import (
    X_TO_Y,
    Z_TO_BACK,
    Body,
    Placement,
    laid_down,
    sized,
)
from core.guidance.builtin.nouns import GROUPS
from core.guidance.builtin.words.companions.known_as import (
    CONTAINERS,
    EDIBLE,
    FLOWERS,
    PIERCED,
    POINTED,
    PUT_DOWN,
)
from core.guidance.builtin.words.tables.living import is_animal, is_creature

CELLS, SAMPLES = 40, 60_000  # of a height map: along a side; points of the surface
FOOT = 0.08  # of a thing's height: lower parts are its feet
OVER = 0.45  # of a support's half width: most width of a foot
PLACES = 9  # places to try along a side
# Of a thing's feet: least fraction over ground for it to stand there; fraction that touches.
STANDING, TOUCHING = 0.3, 0.3
LEVEL = 0.8  # quantile of the heights under a foot that it rests on
# Cost of a place: for each unit of height by which the ground under the foot differs; for the
# fraction of the foot without ground; for each unit off the middle; for obstacles.
UNEVEN, NO_GROUND, OFF_MIDDLE, IN_THE_WAY = 1.0, 0.5, 0.15, 0.3
FILLED, HEAPED = 0.78, 0.4  # of a container's width; of a heap's height, what is over the rim
DEPTH = 0.55  # of a container's height: most depth of a heap in it, as it narrows below
OVER_THE_RIM = "handle", "handles", "tap", "lid", "straps", "saucer"  # and around it
SEAT = 0.8  # off the middle of what one sits in
SUNK = 0.02  # training units: overlap with the support
ASTRIDE, SEATED = 0.22, 0.15  # of a thing's height
IN = 0.45  # of the lower one's height: how deep a thing is in another
ROOM = 1.1  # of a thing's lower half: least width of a container
NEIGHBOUR, YOUNG, TOUCHING_SIDES = (0.3, 2.5), (0.22, 0.6), 0.02
WIDEST = 0.7  # of the carrier: most width of a thing on it
# Of the other's longest side: least and most of a thing's.
SUPPORT, MOUNT, CONTAINER, BORNE = (0.6, 3.0), (0.7, 1.7), (0.5, 2.5), (0.2, 1.1)
DECKS = {*GROUPS["Vehicles"], "sled"}  # things in these are on them
VASE = (0.7, 1.0)  # around flowers
FOOD = (1.6, 3.5)  # under another food: a cupcake under a cherry
TALL = 1.5  # times as high as wide: laid down from here on
LOADED, FLOOR = 1.1, 0.3  # of a bed's width: a load; quantile of a bed's heights: its floor
CROWNED = {"tree", "oak tree", "palm", "willow tree"}  # things stand below their crowns
NESTS, HALFWAY, NESTED = ("nest", "beehive"), 0.5, 0.3  # of the crown's height; of its own
BEDS = {"pickup truck": ("bed",), "dump truck": ("load", "bed")}  # a load lies on these parts
PLANTED = {"island": ("trunk", "leaves", "coconuts", "stones")}  # no thing is put on these
LYING = {"surfboard", "skateboard", "snowboard"}  # as a support
BROOM, ON_HANDLE = (1.0, 1.7), 0.66  # its size; of its handle, from the front
BROOMS = {"broom"}  # lie along who is on them, the handle to the front
MOUNTS = {"bicycle", "motorcycle", "scooter", "tricycle", "rocking horse"} | BROOMS
STONE, STUCK = (0.4, 1.6), 0.3  # of a stuck thing: the other's size; its depth
POINT_DOWN = torch.tensor([[1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, -1.0]])


def under(thing: Body, support: Body, off_middle: float = OFF_MIDDLE) -> Placement:
    """The placement of a support below ``thing``; with the cost of a unit off its middle."""
    foods = FOOD if {thing.words.noun, support.words.noun} <= EDIBLE else SUPPORT
    on_broom = support.words.noun in BROOMS
    sizes = BROOM if on_broom else MOUNT if _is_mount(support) else foods
    turn = levelled(thing, support)
    place = Placement.of(sized(support.placed(Placement.of(1.0, turn)), thing, *sizes), turn)
    below = support.placed(place)
    spot = on_handle(below) if on_broom else spot_on(thing, below, off_middle)
    sunk = ASTRIDE * float(thing.sides[2]) if _rides(thing, support) else SUNK
    return place.moved(_foot(thing) - spot + torch.tensor([0.0, 0.0, sunk]))


def on_handle(broom: Body) -> Float[Tensor, " 3"]:
    """The place on a level broom's handle where one sits."""
    handle = broom.of_parts("handle")
    low, high = handle.amin(0), handle.amax(0)
    spot = (low + high) / 2
    return torch.stack([spot[0], low[1] + ON_HANDLE * (high - low)[1], spot[2]])


def within(thing: Body, other: Body) -> Placement:
    """The placement of a container around ``thing``: with its point in it, as one of a heap, or by
    itself."""
    if is_stuck(thing, other):
        return pierced(thing, other)
    if other.words.noun in CONTAINERS and is_heap(thing):
        return _filling(thing, other).inverted()
    return around(thing, other)


def around(thing: Body, container: Body) -> Placement:
    """The placement of a container around ``thing``."""
    if container.words.noun in DECKS:  # or its seats
        place = under(thing, container, SEAT)
        return place.moved(torch.tensor([0.0, 0.0, SEATED * float(thing.sides[2])]))
    if is_bunch(thing):
        return _around_stems(thing, container)
    scale = sized(container, thing, *CONTAINER)
    lower = thing.verts[thing.verts[:, 2] < thing.box.mean(0)[2]]
    wide = ROOM * (lower.amax(0) - lower.amin(0))[:2] / _opening(container)[1][:2]
    place = Placement.of(max(scale, float(wide.max())))
    there = container.placed(place)
    depth = IN * min(float(thing.sides[2]), float(there.sides[2]))
    spot, _ = _opening(there)
    middle = torch.cat([thing.box.mean(0)[:2], thing.box[0, 2:]])
    return place.moved(middle - spot + torch.tensor([0.0, 0.0, depth]))


def _around_stems(bunch: Body, container: Body) -> Placement:
    """The placement of a vase around flowers, its mouth where their stems cross."""
    place = Placement.of(sized(container, bunch, *VASE))
    spot, _ = _opening(container.placed(place))
    low = bunch.verts[bunch.verts[:, 2] < bunch.box[0, 2] + FOOT * bunch.sides[2]]
    crossing = bunch.box[0, 2] + TOGETHER * bunch.sides[2]
    return place.moved(torch.stack([*low[:, :2].mean(0), crossing]) - spot)


def beside(thing: Body, other: Body, row: Body, on_left: bool = False) -> Placement:
    """The placement of ``thing`` next to the other, at the end of a row with it, touching it."""
    young = thing.words.noun == other.words.noun
    place = Placement.of(sized(thing, other, *(YOUNG if young else NEIGHBOUR)))
    there = thing.placed(place)
    middle, mine = other.box.mean(0), there.box.mean(0)
    to = torch.stack([torch.zeros(()), middle[1] - mine[1], (other.box - there.box)[0, 2]])
    close = is_creature(other.words.noun) or other.words.noun in CROWNED
    near = _next_to(there.placed(Placement.of().moved(to)), row) if close else row.box
    if on_left:
        side = near[0, 0] + TOUCHING_SIDES - there.box[1, 0]
    else:
        side = near[1, 0] - TOUCHING_SIDES - there.box[0, 0]
    return place.moved(to + side * torch.tensor([1.0, 0.0, 0.0]))


def _next_to(thing: Body, row: Body) -> Float[Tensor, "2 3"]:
    """The box around the points of a row that a thing next to it may touch, under a parent's ears
    or wings."""
    low, high = thing.box
    near = row.verts[
        (row.verts[:, 2] < high[2]) & (row.verts[:, 1] > low[1]) & (row.verts[:, 1] < high[1])
    ]
    return torch.stack([near.amin(0), near.amax(0)]) if len(near) else row.box


def is_stuck(thing: Body, other: Body) -> bool:
    """Whether a thing is in the other with its point."""
    return thing.words.noun in POINTED and other.words.noun in PIERCED


def pierced(thing: Body, other: Body) -> Placement:
    """The placement of a thing in which ``thing`` is stuck, point down."""
    place = Placement.of(sized(other, thing, *STONE))
    spot = spot_on(thing, other.placed(place))
    deep = torch.tensor([0.0, 0.0, STUCK * float(thing.sides[2])])
    return place.moved(_foot(thing) - spot + deep)


def upon(thing: Body, carrier: Body, count: int = 1) -> Placement:
    """The placement of ``thing`` on top of the carrier or in it; one of several has to fit between
    the carrier's nearer sides."""
    if is_stuck(thing, carrier):
        place = Placement.of(sized(thing, carrier, *BORNE), POINT_DOWN)
        borne = thing.placed(place)
        deep = torch.tensor([0.0, 0.0, STUCK * float(borne.sides[2])])
        return place.moved(spot_on(borne, carrier) - _foot(borne) - deep)
    if carrier.words.noun in CONTAINERS and is_heap(thing):
        return _filling(thing, carrier)
    if carrier.words.noun in BEDS and is_heap(thing):
        return _load(thing, carrier.only(*BEDS[carrier.words.noun]))
    if carrier.words.noun in CONTAINERS:
        return around(thing, carrier).inverted()
    if carrier.words.noun in CROWNED and thing.words.noun in NESTS:
        return _in_branches(thing, carrier)
    turn = lying(thing) @ levelled(carrier, thing)
    laid = thing.placed(Placement.of(1.0, turn))
    room = carrier.sides[:2].max() if count == 1 else carrier.sides[:2].min()
    wide = WIDEST * room / laid.sides[:2].max()
    if thing.words.noun in LYING:  # a surfboard on a car's roof
        wide = wide / WIDEST
    place = Placement.of(min(sized(laid, carrier, *BORNE), float(wide)), turn)
    borne = thing.placed(place)
    ground = carrier.bare(*PLANTED.get(carrier.words.noun, ()))
    return place.moved(spot_on(borne, ground) - _foot(borne) - torch.tensor([0.0, 0.0, SUNK]))


def lying(thing: Body) -> Float[Tensor, "3 3"]:
    """The rotation of a thing that is put down and does not stand: a sword on a table."""
    return laid_down(thing, TALL) if thing.words.noun in PUT_DOWN else torch.eye(3)


def lying_on(thing: Body, support: Body) -> Float[Tensor, "3 3"]:
    """The same of the first thing, along a long support: a katana on its stand."""
    turn = lying(thing)
    if torch.equal(turn, torch.eye(3)):
        return turn
    sides = thing.placed(Placement.of(1.0, turn)).sides
    across = (sides[0] > sides[1]) != (support.sides[0] > support.sides[1])
    return X_TO_Y @ turn if across else turn


def is_bunch(thing: Body) -> bool:
    """Whether it is several flowers with their stems together."""
    return thing.words.count > 1 and thing.words.noun in FLOWERS


def is_heap(thing: Body) -> bool:
    """Whether it is several things in a heap."""
    return thing.words.count > 1 and not is_bunch(thing)


def _filling(heap: Body, container: Body) -> Placement:
    """The placement of a heap that fills a container to above its rim."""
    wide = FILLED * float((_opening(container)[1][:2] / heap.sides[:2]).min())
    place = Placement.of(wide)
    there = heap.placed(place)
    rim, sides = _opening(container)
    high = float(there.sides[2])  # of which no more is in it than it is deep
    up = torch.tensor([0.0, 0.0, max(HEAPED * high, high - DEPTH * float(sides[2]))])
    middle = there.box.mean(0)
    top = torch.stack([middle[0], middle[1], there.box[1, 2]])
    return place.moved(rim - top + up)


def _load(heap: Body, bed: Body) -> Placement:
    """The placement of a heap on a truck's bed, as wide as that."""
    place = Placement.of(LOADED * float((bed.sides[:2] / heap.sides[:2]).min()))
    there = heap.placed(place)
    foot = torch.cat([there.box.mean(0)[:2], there.box[0, 2:]])
    floor = torch.cat([bed.box.mean(0)[:2], bed.verts[:, 2].quantile(FLOOR)[None]])
    return place.moved(floor - foot - torch.tensor([0.0, 0.0, SUNK]))


def _in_branches(nest: Body, tree: Body) -> Placement:
    """The placement of a nest halfway up a tree's crown, at the front."""
    place = Placement.of(sized(nest, tree, *BORNE))
    there = nest.placed(place)
    crown = tree.without("trunk")
    low, high = crown[:, 2].amin(), crown[:, 2].amax()
    heights, sides = height_map(tree), tree.sides
    cells = (~heights.isnan()).nonzero()
    level = heights[cells[:, 0], cells[:, 1]]
    at = tree.box[0, :2] + (cells + 0.5) * sides[:2] / CELLS
    off = (at - tree.box.mean(0)[:2]) * torch.tensor([1.0, 0.3])
    behind = (at[:, 1] > tree.box.mean(0)[1]).float()
    best = ((level - (low + HALFWAY * (high - low))).abs() + off.norm(dim=1) + behind).argmin()
    spot = torch.cat([at[best], level[best, None]])
    foot = torch.cat([there.box.mean(0)[:2], there.box[0, 2:]])
    return place.moved(spot - foot - torch.tensor([0.0, 0.0, NESTED * float(there.sides[2])]))


def _is_mount(support: Body) -> bool:
    noun = support.words.noun
    return is_animal(noun) or noun in MOUNTS or noun in GROUPS["Vehicles"]


def _rides(thing: Body, support: Body) -> bool:
    noun = support.words.noun
    stands = thing.sides[2] > thing.sides[:2].max()
    return bool(stands) and (is_animal(noun) or noun in MOUNTS)


def levelled(thing: Body, support: Body) -> Float[Tensor, "3 3"]:
    """The rotation of a thing's support: a board is flat, and along the thing."""
    if support.words.noun in BROOMS:
        return Z_TO_BACK
    turn = torch.eye(3)
    flat = support.words.noun in LYING and support.sides[2] > support.sides[:2].min()
    if flat:
        turn = Z_TO_BACK @ turn
    sides = support.placed(Placement.of(1.0, turn)).sides
    own = thing.sides
    if support.words.noun in LYING and (sides[0] > sides[1]) != (own[0] > own[1]):
        turn = X_TO_Y @ turn
    return turn


def _foot(thing: Body) -> Float[Tensor, " 3"]:
    """The middle of the part that a thing stands on; of what lies, of the whole."""
    lies = thing.words.noun in PUT_DOWN and thing.sides[2] < thing.sides[:2].max() / TALL
    feet = thing.verts if lies else _feet(thing)
    return torch.cat([(feet.amin(0) + feet.amax(0))[:2] / 2, thing.box[0, 2:]])


def _feet(thing: Body) -> Float[Tensor, "n 3"]:
    return thing.verts[thing.verts[:, 2] < thing.box[0, 2] + FOOT * thing.sides[2]]


def _opening(container: Body) -> tuple[Float[Tensor, " 3"], Float[Tensor, " 3"]]:
    """The middle of a container's opening, and the sides of its box without handles."""
    body = container.without(*OVER_THE_RIM)
    low, high = body.amin(0), body.amax(0)
    return torch.cat([(low + high)[:2] / 2, high[2:]]), high - low


def _middle_top(body: Body) -> Float[Tensor, " 3"]:
    middle = body.box.mean(0)
    return torch.stack([middle[0], middle[1], body.box[1, 2]])


def spot_on(thing: Body, support: Body, off_middle: float = OFF_MIDDLE) -> Float[Tensor, " 3"]:
    """The best place for the thing on the support: level, wide enough, near the middle."""
    heights = height_map(support)
    low, sides = support.box[0], support.sides
    cell = sides[:2] / CELLS
    feet = _feet(thing)
    foot = (feet.amax(0) - feet.amin(0))[:2] / 2
    foot = foot.minimum(OVER * sides[:2]) / cell
    whole = (thing.sides[:2] / 2).minimum(sides[:2] / 2) / cell
    found = []
    for i in range(PLACES):
        for j in range(PLACES):
            at = torch.tensor([i + 0.5, j + 0.5]) / PLACES * CELLS
            ground, rest, cost = _ground(heights, at, foot)
            if not ground:
                continue
            around, *_ = _window(heights, at, whole)
            cost += IN_THE_WAY * float((around - rest - SUNK).clamp_min(0).nan_to_num().mean())
            cost += off_middle * float((((at / CELLS) - 0.5) * sides[:2]).norm())
            found.append((cost, *(low[:2] + at * cell).tolist(), rest))
    if not found:
        return _middle_top(support)
    _, x, y, z = min(found)
    spot = torch.tensor([x, y, z])
    return spot - torch.tensor([0.0, 0.0, _clearance(thing, spot, support, heights)])


def _clearance(
    thing: Body, spot: Float[Tensor, " 3"], support: Body, heights: Float[Tensor, "c c"]
) -> float:
    """How far most of a thing's feet are above the ground at a spot: the middle of a bulging
    cushion is higher than the places below a cat's feet."""
    foot = _feet(thing) - _foot(thing) + spot
    cell = support.sides[:2] / CELLS
    i, j = ((foot[:, :2] - support.box[0, :2]) / cell).long().T
    over = (i >= 0) & (i < CELLS) & (j >= 0) & (j < CELLS)
    above = foot[over, 2] - heights[i[over], j[over]]
    above = above[~above.isnan()]
    if len(above) < STANDING * len(foot):
        return 0.0
    return max(float(above.quantile(TOUCHING)), 0.0)


def _ground(
    heights: Float[Tensor, "c c"], at: Float[Tensor, " 2"], half: Float[Tensor, " 2"]
) -> tuple[bool, float, float]:
    """Whether there is ground in a window, the height at which a foot rests there, and the cost of
    the place."""
    window = _window(heights, at, half)
    known = window[~window.isnan()]
    if not len(known):
        return False, 0.0, 0.0
    rest = float(known.quantile(LEVEL))
    uneven = rest - float(known.quantile(1 - LEVEL))
    return True, rest, UNEVEN * uneven + NO_GROUND * (1 - len(known) / window.numel())


def _window(
    heights: Float[Tensor, "c c"], at: Float[Tensor, " 2"], half: Float[Tensor, " 2"]
) -> Float[Tensor, "a b"]:
    low = (at - half).floor().long().clamp(0, CELLS - 1)
    high = (at + half).ceil().long().clamp(1, CELLS)
    high = torch.maximum(high, low + 1)
    return heights[low[0] : high[0], low[1] : high[1]]


def height_map(body: Body) -> Float[Tensor, "c c"]:
    """The highest point of the surface over each cell of the box, by x and y; NaN without one."""
    points = sample_surface(body.verts, body.faces, SAMPLES, torch.Generator().manual_seed(0))
    heights = highest(points, body.box[0, :2], body.sides[:2].clamp_min(1e-6), CELLS)
    return heights.masked_fill(heights.isinf(), torch.nan)


def highest(
    points: Float[Tensor, "n 3"], low: Float[Tensor, " 2"], sides: Float[Tensor, " 2"], cells: int
) -> Float[Tensor, "c c"]:
    """The greatest z over each cell of a rectangle; minus infinity without points."""
    i, j = cells_of(points, low, sides, cells).T
    heights = torch.full((cells * cells,), -torch.inf)
    return heights.scatter_reduce(0, i * cells + j, points[:, 2], "amax").view(cells, cells)


def cells_of(
    points: Float[Tensor, "n 3"], low: Float[Tensor, " 2"], sides: Float[Tensor, " 2"], cells: int
) -> Int[Tensor, "n 2"]:
    """The cell of a rectangle below each point, or the nearest."""
    return ((points[:, :2] - low) / sides * cells).long().clamp(0, cells - 1)
