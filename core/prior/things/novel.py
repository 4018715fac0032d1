"""Two clocks, a guitar with horns, a house in a mushroom, a caterpillar, a pin for a map."""

import math
from itertools import pairwise

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
    ball,
    both,
    box,
    capsule,
    cut,
    grown,
    join,
    lathe,
    limb,
    mirrored,
    moved,
    prism,
    ring,
    smooth_curve,
    tube,
    turned,
)

Point = tuple[float, float]

# From the strap's end at the floor to a horn's tip, and from there to the neck.
EVEN_SIDE = ((0.0, 0.0), (0.34, 0.03), (0.62, 0.18), (0.71, 0.46), (0.58, 0.8), (0.54, 1.0),
             (0.63, 1.24), (0.62, 1.5))  # fmt: skip
EVEN_HORN = ((0.62, 1.5), (0.42, 1.38), (0.31, 1.24), (0.2, 1.14))
LEFT_SIDE = ((0.0, 0.0), (-0.4, 0.03), (-0.68, 0.22), (-0.7, 0.52), (-0.54, 0.86), (-0.58, 1.2),
             (-0.6, 1.6))  # fmt: skip
LEFT_HORN = ((-0.6, 1.6), (-0.42, 1.44), (-0.3, 1.27), (-0.2, 1.14))
RIGHT_SIDE = ((0.0, 0.0), (0.4, 0.0), (0.7, 0.16), (0.75, 0.46), (0.57, 0.8), (0.55, 1.02),
              (0.62, 1.42))  # fmt: skip
RIGHT_HORN = ((0.62, 1.42), (0.42, 1.31), (0.3, 1.2), (0.2, 1.1))


def _bent(*rows: tuple[Point, ...]) -> list[Point]:
    return [point for row in rows for point in smooth_curve(list(row))]


def electric_guitar(draw: Draw) -> Parts:
    """Upright, its strings to the front: even horns and pegs on both sides, or uneven and a row."""
    even, wide, thick = draw.chance(0.5), draw(0.97, 1.03), draw(0.15, 0.18)
    top, head = draw(1.94, 2.02), draw(0.86, 0.92)
    front, edge = -thick, 0.05
    rows = (top + 0.22, top + 0.7)
    tuners = join(*(capsule((0.28, front, v), (0.37, front, v), 0.105) for v in rows))
    if even:
        outline = mirrored(_bent(EVEN_SIDE, EVEN_HORN))
        plate = mirrored([(0.1, 0.4), (0.36, 0.4), (0.4, 0.6), (0.36, 0.86), (0.42, 1.14),
                          (0.1, 1.14)])  # fmt: skip
        nut = mirrored([(0.13, top), (0.24, top + 0.14), (0.22, top + head), (0.08, top + head)])
        pegs = both(tuners)
    else:
        left, right = _bent(LEFT_SIDE, LEFT_HORN), _bent(RIGHT_SIDE, RIGHT_HORN)
        outline = [*left, *reversed(right)]
        plate = [(-0.3, 0.42), (0.24, 0.34), (0.36, 0.14), (0.6, 0.2), (0.6, 0.5), (0.44, 0.8),
                 (0.46, 1.1), (-0.44, 1.28), (-0.42, 0.9)]  # fmt: skip
        nut = [(0.13, top), (0.22, top + 0.12), (0.22, top + head - 0.06), (0.1, top + head + 0.04),
               (-0.06, top + head), (-0.2, top + head - 0.2), (-0.13, top)]  # fmt: skip
        pegs = tuners
    knobs = ((0.48, 0.67), (0.44, 0.28))
    controls = (tube((x, front - 0.2, z), (x, front, z), 0.125, 0.02) for x, z in knobs)
    return {
        "body": grown(prism([(x * wide, z) for x, z in outline], 1, thick - edge), edge),
        "neck": join(
            box((0, front - 0.04, (1.08 + top) / 2), (0.13, 0.13, (top - 1.08) / 2 + 0.04), 0.02),
            prism(nut, 1, 0.12, front - 0.01),
        ),
        "pickguard": prism([(x * wide, z) for x, z in plate], 1, 0.1, front + 0.03),
        "pickups": join(
            *(box((0, front - 0.09, z), (0.23, 0.12, 0.09), 0.02) for z in (0.84, 0.53))
        ),
        "bridge": box((0, front - 0.06, 0.22), (0.18, 0.13, 0.1), 0.02),
        "knobs": join(pegs, *controls),
    }


def mushroom_house(draw: Draw) -> Parts:
    """A stem with a round door and a round window or two, a chimney in the spotted cap."""
    r, wall, cap, dome = draw(0.58, 0.63), draw(1.14, 1.22), draw(1.06, 1.14), draw(0.8, 0.88)
    turns = (-58, 58) if draw.chance(0.5) else (58,)
    quarter = [math.radians(9 * k) for k in range(11)]
    over = [(cap * math.cos(a), wall + dome * math.sin(a)) for a in quarter]
    arch = [(0.28 * math.cos(a), 0.56 + 0.28 * math.sin(a)) for a in quarter]

    def spot(east: float, north: float) -> Solid:
        """A ball half sunk, so that it stands out by 0.12."""
        a, b = math.radians(east - 90), math.radians(north)
        out, up = math.cos(b) / cap, math.sin(b) / dome  # along the cap's normal
        out, up = (n * 0.2 / math.hypot(out, up) for n in (out, up))
        out, up = cap * math.cos(b) - out, dome * math.sin(b) - up
        return ball((out * math.cos(a), out * math.sin(a), wall + up), 0.32)

    spots = [spot(72 * k, 30) for k in range(5)]
    frame = tube((0, -r - 0.13, 0.64), (0, 0, 0.64), 0.25, 0.02)
    pane = tube((0, -r - 0.21, 0.64), (0, 0, 0.64), 0.16, 0.02)
    small = tube((0, -r - 0.32, 0.56), (0, -r, 0.56), 0.13, 0.02)
    x, y, top = cap * 0.5, cap * 0.16, wall + dome
    return {
        "stem": lathe(smooth_curve([(r + 0.08, 0), (r + 0.14, 0.16), (r + 0.04, 0.5),
                                    (r - 0.04, wall * 0.8), (r - 0.02, wall + 0.1)])),
        "cap": lathe([(r - 0.2, wall + 0.02), (cap - 0.14, wall - 0.14), (cap - 0.03, wall - 0.1),
                      *over]),
        "dots": join(*spots, spot(0, 90)),
        "door": join(prism(mirrored([(0.28, 0), *arch]), 1, 0.22, -r - 0.02),
                     *(turned(frame, 2, angle) for angle in turns)),
        "windows": join(small, *(turned(pane, 2, angle) for angle in turns)),
        "chimney": join(tube((x, y, wall + 0.3), (x, y, top + 0.08), 0.16),
                        tube((x, y, top), (x, y, top + 0.18), 0.23, 0.02)),
    }  # fmt: skip


def caterpillar(draw: Draw) -> Parts:
    """A row of balls, its head raised to the front, or its back in an arch."""
    r, step, foot, head = draw(0.4, 0.43), draw(0.47, 0.5), 0.14, draw(0.44, 0.48)
    heights = (0.42, 0.08, 0.0, 0.04, 0.16) if draw.chance(0.5) else (0.06, 0.34, 0.52, 0.34, 0.0)
    spots = [(step * (k - 1.5), foot + r + rise) for k, rise in enumerate(heights)]
    y, z = spots[0][0] - 0.42, spots[0][1] + 0.3
    beads = [ball((0, v, w), r) for v, w in spots]
    low = [(v, w) for v, w in spots if w < r + 0.25]
    feet = [capsule((0.2, v, w - 0.2), (0.26, v, w - r), 0.14) for v, w in low]
    feeler = [(0.16, y, z + head * 0.7), (0.24, y - 0.02, z + head + 0.22)]
    return {
        "body": join(*beads[1::2]),
        "rings": join(*beads[::2]),
        "head": ball((0, y, z), head),
        "eyes": both(ball((0.19, y - head * 0.82, z + 0.12), 0.14)),
        "antennae": both(join(limb(feeler, 0.1, 0.1), ball(feeler[-1], 0.16))),
        "feet": both(join(*feet)),
    }


def map_pin(draw: Draw) -> Parts:
    """A thick drop on its point: with a round hole, or with a disc on each side."""
    r, z, half, edge = draw(0.78, 0.86), draw(1.5, 1.64), draw(0.24, 0.3), 0.06
    small, inner = r - edge, r * draw(0.42, 0.48)
    # The sides touch the circle at this angle below its middle.
    first = -math.asin(small / (z - 0.1))
    angles = (first + (math.pi / 2 - first) * k / 10 for k in range(11))
    side = [(0.0, 0.1), *((small * math.cos(a), z + small * math.sin(a)) for a in angles)]
    drop = grown(prism(mirrored(side), 1, half - edge), edge)
    if draw.chance(0.5):
        return {"body": cut(drop, tube((0, -1, z), (0, 1, z), inner))}
    deep = half + 0.09
    return {"body": drop, "disc": tube((0, -deep, z), (0, deep, z), inner + 0.06, 0.03)}


def _dial(y: float, r: float, hand: float) -> tuple[Solid, Solid]:
    """A face to the front, in the middle; and its two hands, at ten past ten, and four marks."""
    mark, steep = box((0, y, r - 0.15), (0.08, 0.08, 0.1), 0.01), math.radians(60)
    ends = [(s * math.sin(steep), y, math.cos(steep) * abs(s)) for s in (r * 0.6, -r * 0.42)]
    pointers = (capsule((0, y, 0), end, hand) for end in ends)
    marks = (turned(mark, 1, 90 * k) for k in range(4))
    return tube((0, y, 0), (0, y + 0.2, 0), r), join(*marks, *pointers)


def alarm_clock(draw: Draw) -> Parts:
    """Round, on two legs, two bells on top: between them a hammer, or over them a handle."""
    r, y, lean = draw(0.82, 0.9), draw(0.3, 0.36), 34
    face, hands = _dial(-y - 0.02, r - 0.1, 0.09)
    bell = join(
        lathe([(0.38, 0), (0.36, 0.14), (0.24, 0.3), (0.0, 0.36)], 0.02),
        tube((0, 0, -0.16), (0, 0, 0.1), 0.12),
    )
    if draw.chance(0.5):
        handle = cut(ring((0, 0, r + 0.3), 0.42, 0.1, 1), box((0, 0, r - 0.1), (2, 2, 0.4)))
    else:
        handle = join(
            capsule((0, 0, r - 0.1), (0, 0, r + 0.3), 0.09),
            capsule((-0.12, 0, r + 0.34), (0.12, 0, r + 0.34), 0.13),
        )
    foot = join(capsule((0, 0, r - 0.1), (0, 0, r + 0.24), 0.12), ball((0, 0, r + 0.24), 0.15))
    return {
        "body": tube((0, -y, 0), (0, y, 0), r, 0.05),
        "face": face,
        "hands": hands,
        "bells": both(turned(moved(bell, (0, 0, r + 0.1)), 1, lean)),
        "rim": ring((0, -y, 0), r - 0.05, 0.11, 1),
        "feet": both(turned(foot, 1, 180 - lean)),
        "handle": handle,
    }


def pocket_watch(draw: Draw) -> Parts:
    """Upright, its dial to the front, a bow about its crown, from which a chain may hang."""
    r, deep, neck = draw(0.9, 0.96), draw(0.24, 0.28), 0.3
    top, bow, lip = r + 0.36, draw(0.4, 0.43), 0.1
    back = [(0.0, -deep - 0.12), (r * 0.5, -deep - 0.08), (r * 0.8, -deep + 0.04), (r, -0.02)]
    case = [*smooth_curve(back), (r, 0.08)]
    bezel = [(r - 0.02, -0.1), (r + 0.07, 0.0), (r + 0.07, 0.14), (r - 0.04, 0.3), (r - 0.14, 0.3)]
    inner = [(r - 0.22, 0.0), (r - 0.22, 0.14), (r - 0.08, 0.36)]

    def hand(long: float, wide: float, turn: float) -> Solid:
        leaf = [(-0.09, -0.12), (0.09, -0.12), (wide, long * 0.62), (0.06, long), (-0.06, long),
                (-wide, long * 0.62)]  # fmt: skip
        return turned(prism(leaf, 1, 0.1, -0.16), 1, turn)

    def facing(solid: Solid) -> Solid:
        return turned(solid, 0, 90)

    parts = {
        "case": facing(lathe(case)),
        "face": facing(tube((0, 0, -0.06), (0, 0, 0.16), r - 0.14)),
        "hands": join(
            hand(r * 0.48, 0.15, -60),
            hand(r * 0.7, 0.13, 60),
            tube((0, -0.31, 0), (0, -0.1, 0), 0.14, 0.02),
        ),
        "rim": facing(cut(lathe(bezel), lathe(inner))),
        "crown": join(
            lathe([(neck + 0.04, r - 0.12), (neck - 0.04, r + 0.1), (0.12, r + 0.18)]),
            lathe([(0.13, r + 0.1), (0.2, r + 0.26), (0.2, r + 0.42), (0.12, r + 0.5)]),
            ring((0, 0, top), bow, lip, 1),
        ),
    }
    if draw.chance(0.5):
        far = [(0.44, top + bow - 0.02), (0.92, top + bow - 0.12), (1.24, top + bow - 0.48)]
        links = (ring((u, 0, w), 0.2, 0.1, 1) for u, w in far)
        bars = (
            capsule((u, 0, w), (s, 0, v), 0.1)
            for (u, w), (s, v) in pairwise([(0.1, top + bow), *far])
        )
        eyes = (tube((u, -1, w), (u, 1, w), 0.12) for u, w in far)
        parts["chain"] = join(cut(join(*bars), *eyes), *links)
    return parts


NOVEL = {
    "electric guitar": electric_guitar,
    "mushroom house": mushroom_house,
    "caterpillar": caterpillar,
    "map pin": map_pin,
    "alarm clock": alarm_clock,
    "pocket watch": pocket_watch,
}
