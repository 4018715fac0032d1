"""Houses, huts and other buildings that people live in."""

import math

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
    ball,
    both,
    box,
    capsule,
    cut,
    join,
    lathe,
    mirrored,
    prism,
    ring,
    smooth_curve,
    tube,
    turned,
)
from core.prior.things.shared.building_parts import box_row, hip_roof
from core.prior.things.shared.fitted import fitted
from core.prior.things.shared.outlines import dome_of


def house(draw: Draw) -> Parts:
    x, y, wall = draw(0.85, 1.05), draw(0.65, 0.8), draw(0.85, 1.05)
    ridge, eave = wall + draw(0.55, 0.75), draw(0.1, 0.16)
    roof = [(-y - eave, wall - 0.04), (y + eave, wall - 0.04), (0, ridge + 0.04)]
    cx = x * draw(0.45, 0.6)
    frame = 0.16  # the door's depth before the wall: enough for its sides to be seen
    parts = {
        "walls": box((0, 0, wall / 2), (x, y, wall / 2)),
        "roof": prism(roof, 0, x + eave),
        "door": box((0, -y, wall * 0.34), (0.2, frame, wall * 0.34), 0.02),
        "windows": join(
            both(box((x * 0.61, -y, wall * 0.56), (x * 0.21, 0.1, wall * 0.2))),
            both(box((x, 0, wall * 0.56), (0.1, y * 0.42, wall * 0.2))),
        ),
    }
    chimney = {"chimney": box((cx, y * 0.35, ridge - 0.1), (0.13, 0.13, 0.35))}
    return parts | chimney if draw.has("chimney", 0.9) else parts


def cottage(draw: Draw) -> Parts:
    """A low gabled house with a thick roof, its door in the gable, a chimney at its side."""
    x, y, wall = draw(0.72, 0.82), draw(0.75, 0.95), draw(0.62, 0.75)
    ridge, eave, thick = wall + draw(0.8, 0.95), draw(0.18, 0.24), 0.2
    gable = [(-x, 0), (x, 0), (x, wall), (0, ridge - 0.1), (-x, wall)]
    slope = (ridge - wall) / x
    low = wall - eave * slope
    outer = [(-x - eave, low), (0, ridge), (x + eave, low), (x + eave, low + thick)]
    roof = prism([*outer, (0, ridge + thick * 1.3), (-x - eave, low + thick)], 1, y + 0.12)
    parts = {
        "walls": prism(gable, 1, y),
        "roof": roof,
        "door": box((0, -y, 0.32), (0.2, 0.1, 0.32), 0.02),
        "windows": join(
            both(box((x * 0.63, -y, wall * 0.6), (0.17, 0.1, 0.19))),
            both(box((x, 0.0, wall * 0.52), (0.1, y * 0.32, 0.17))),
        ),
    }
    if draw.has("chimney", 0.8):
        parts |= {
            "chimney": box((x * 0.55, y * 0.45, ridge * 0.5 + 0.2), (0.14, 0.14, ridge * 0.5 + 0.2))
        }
    return parts


def hut(draw: Draw) -> Parts:
    """A round hut of mud under a tall cone of thatch in layers, a dark door in a wooden frame."""
    r, high, reach = draw(0.86, 0.92), draw(1.06, 1.14), draw(1.14, 1.2)
    tall, low = draw(1.24, 1.32), high - 0.14
    layers = []
    for k in range(3):
        out, z = reach * (1 - 0.27 * k), low + tall * 0.27 * k
        layers.append(lathe([(out - 0.16, z), (out, z), (out - 0.02, z + 0.13),
                             (out * 0.4, z + tall * 0.42)], 0.03))  # fmt: skip
    peak = low + tall
    crown = [(0.3, peak - 0.34), (0.15, peak - 0.08), (0.24, peak + 0.16), (0.08, peak + 0.18)]
    wide, front = 0.33, -r - 0.05

    def aside(solid: Solid) -> Solid:
        """What is made at +X, turned to the front beside the door."""
        return turned(solid, 2, -34)

    post = capsule((wide, front + 0.06, 0.05), (wide, front + 0.06, 0.78), 0.1)
    return {
        "walls": lathe([(r + 0.02, 0), (r + 0.04, 0.3), (r, high + 0.1)], 0.02),
        "roof": join(*layers, lathe(crown, 0.02)),
        "door": box((0, front + 0.12, 0.4), (0.28, 0.14, 0.4), 0.02),
        "frame": join(
            both(join(post, aside(ring((r + 0.02, 0, 0.6), 0.2, 0.09, 0)))),
            capsule((-0.43, front + 0.06, 0.8), (0.43, front + 0.06, 0.8), 0.1),
        ),
        "windows": both(aside(tube((r - 0.1, 0, 0.6), (r + 0.06, 0, 0.6), 0.18))),
        "base": tube((0, 0, 0), (0, 0, 0.2), r + 0.12, 0.04),
        "band": tube((0, 0, peak - 0.13), (0, 0, peak + 0.03), 0.25, 0.04),
    }


def log_cabin(draw: Draw) -> Parts:
    """Thick logs that cross at the corners, a gable roof, a chimney, a door, a window."""
    wide, deep, r, rows = draw(1.0, 1.12), draw(0.7, 0.8), 0.2, 3
    rise, over, step = draw(0.6, 0.72), 0.28, 2 * 0.2
    top = rows * step
    sides = [
        tube((wide, -0.2, r * 2 + k * step), (wide, deep + over, r * 2 + k * step), r)
        for k in range(rows - 1)
    ]
    fronts = [
        tube((-0.2, deep, r + k * step), (wide + over, deep, r + k * step), r) for k in range(rows)
    ]
    half = deep + over + 0.1
    # Up into the roof: a gap under it would be a slit.
    eaves = top + 0.08 + rise - (rise + 0.18) * deep / half
    gable = [(-deep, top - 0.1), (deep, top - 0.1), (deep, eaves), (0, top + rise + 0.08)]
    slope = [(0.0, top + rise + 0.22), (half, top), (half, top - 0.18), (0.0, top + rise)]
    x, y = draw(0.42, 0.48), -deep - r
    stack, peak = wide * 0.6, top + rise + 0.46
    return {
        "logs": join(
            both(join(*fronts, *sides), 0, 1), box((0, 0, top / 2), (wide, deep, top / 2))
        ),
        "roof": both(prism(slope, 0, wide + over + 0.04), 1),
        "chimney": join(
            box((-stack, 0.2, (top + peak) / 2), (0.2, 0.2, (peak - top) / 2)),
            box((-stack, 0.2, peak), (0.28, 0.28, 0.1)),
        ),
        "door": box((-x, y, 0.46), (0.28, 0.13, 0.46)),
        "window": box((x, y, 0.66), (0.24, 0.18, 0.22)),
        "frame": join(
            box((x, y, 0.66), (0.36, 0.09, 0.34)),
            ball((-x + 0.13, y - 0.13, 0.44), 0.1),
        ),
        "gable": prism([*gable, (-deep, eaves)], 0, wide + 0.06),
    }


def tunnel(r: float, z: float, front: float, back: float) -> Solid:
    """A vault along y: a half cylinder of radius ``r`` on walls of height ``z``."""
    walls = box((0, (front + back) / 2, z / 2), (r, (back - front) / 2, z / 2))
    return join(cut(tube((0, front, z), (0, back, z), r), box((0, 0, z - 1), (3, 3, 1))), walls)


def igloo(draw: Draw) -> Parts:
    """A dome of snow, an entrance tunnel with a dark opening."""
    r, high, side = draw(1.05, 1.18), draw(1.0, 1.15), draw(0.34, 0.4)
    long, rim = draw(0.3, 0.42), draw(0.1, 0.13)
    front, z = -r - long, 0.3
    return {
        "dome": lathe([(r * 0.97, 0.0), *dome_of(r, 0.14, high)]),
        "tunnel": tunnel(side, z, front + 0.1, 0),
        "arch": tunnel(side + rim, z, front, front + 0.24),
        "door": tunnel(side - 0.08, z - 0.02, front - 0.04, -0.3),
    }


def treehouse(draw: Draw) -> Parts:
    """A hut with a gabled roof on a platform in a tree, a ladder up to its door."""
    floor, x, y, wall = draw(1.08, 1.16), draw(0.6, 0.66), draw(0.44, 0.5), draw(0.66, 0.72)
    gable, r, top, front = draw(0.46, 0.54), draw(0.54, 0.6), floor + wall, -y - 0.34
    roof = [(-x - 0.2, top - 0.06), (x + 0.2, top - 0.06), (0, top + gable)]
    at, sill, behind = -0.36, floor + wall * 0.56, y + 0.16
    rungs = (box((at, front, floor * k), (0.3, 0.1, 0.095)) for k in (0.3, 0.64))
    rails = (box((at + s, front, floor / 2), (0.11, 0.12, floor / 2)) for s in (-0.32, 0.32))
    return {
        "trunk": join(
            lathe([(0.5, 0), (0.36, 0.3), (0.32, floor + 0.05)], 0, (0.12, 0.14)),
            tube((0.12, behind, floor), (0.12, behind, top + 0.3), 0.2),
        ),
        "leaves": join(
            ball((0, y + 0.24, top + 0.76), r * 1.12), both(ball((0.64, y + 0.24, top + 0.3), r))
        ),
        "walls": box((0, 0, floor + wall / 2), (x, y, wall / 2)),
        "roof": prism(roof, 1, y + 0.14),
        "floor": join(box((0, 0, floor), (x + 0.28, y + 0.36, 0.11)), *rungs, *rails),
        "door": box((-0.28, -y, floor + 0.34), (0.19, 0.1, 0.26)),
        "windows": join(
            box((0.28, -y, sill), (0.19, 0.1, 0.17)), both(box((x, 0, sill), (0.1, 0.22, 0.17)))
        ),
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


def modern_house(draw: Draw) -> Parts:
    """Two storeys with flat roofs, the upper one over the garage; wide panes in dark frames."""
    x, y, low = draw(1.15, 1.3), draw(0.75, 0.85), draw(0.62, 0.7)
    side = (-1, 1)[draw.which(2)]
    wide, over, high = x * draw(0.62, 0.7), draw(0.16, 0.26), draw(0.6, 0.68)
    roof, top = 0.1, low + 0.1
    mid = side * (x - wide)  # of the upper storey
    front = -y - over

    def pane(u: float, v: float, z: float, half: float, tall: float) -> Parts:
        return {
            "frames": box((u, v, z), (half, 0.06, tall)),
            "windows": box((u, v - 0.05, z), (half - 0.09, 0.06, tall - 0.09)),
        }

    panes = [
        pane(mid - wide * 0.16, front, top + high * 0.5, wide * 0.66, high * 0.36),
        pane(-side * x * 0.52, -y, low * 0.52, x * 0.36, low * 0.4),
    ]
    door = side * x * 0.03
    return {
        "walls": join(
            box((0, 0, low / 2), (x, y, low / 2)),
            box((mid, -over / 2, top + high / 2), (wide, y + over / 2, high / 2)),
        ),
        "roof": join(
            box((0, -0.05, low + roof / 2), (x + 0.1, y + 0.14, roof / 2)),
            box((mid, -over / 2, top + high), (wide + 0.1, y + over / 2 + 0.1, roof / 2)),
        ),
        "windows": join(*(one["windows"] for one in panes)),
        "frames": join(*(one["frames"] for one in panes)),
        "door": box((door, -y, low * 0.4), (0.15, 0.08, low * 0.4)),
        "garage": box((side * x * 0.6, -y, low * 0.4), (x * 0.32, 0.07, low * 0.4)),
    }


def mansion(draw: Draw) -> Parts:
    """A great house: a portico of four columns with a pediment, two wings, rows of windows."""
    x, y, high = draw(1.5, 1.56), draw(0.5, 0.54), draw(0.98, 1.04)
    mid, front = draw(0.56, 0.6), -y - 0.42
    top = high + 0.14
    wing = [x * 0.54, x * 0.83]
    both_rows = [s * u for u in wing for s in (-1, 1)]
    half = (0.11, y + 0.06, 0.15)
    gable = [(-mid - 0.14, top), (mid + 0.14, top), (0, top + 0.38)]
    inner = [(-mid * 0.62, top + 0.1), (mid * 0.62, top + 0.1), (0, top + 0.28)]
    return {
        "walls": join(
            box((0, 0, high / 2), (x, y, high / 2)),
            box((0, 0, high / 2), (mid, y + 0.08, high / 2)),
            prism(inner, 1, 0.3, front + 0.24),
        ),
        "roof": join(
            hip_roof(x + 0.1, y + 0.1, high - 0.04, high + 0.64),
            prism([(u * 1.16, v + 0.1) for u, v in gable], 1, (y + 0.3) / 2, -(y + 0.16) / 2),
        ),
        "columns": join(
            *(tube((u, front + 0.12, 0), (u, front + 0.12, top), 0.1, 0.01)
              for u in (-mid, -mid * 0.36, mid * 0.36, mid)),
            prism(gable, 1, 0.3, front + 0.3),
            box((0, front + 0.3, top - 0.02), (mid + 0.16, 0.32, 0.08)),
            box((0, front + 0.26, 0.06), (mid + 0.18, 0.4, 0.09)),
            box((0, front - 0.1, 0.03), (mid * 0.6, 0.22, 0.08)),
            box((0, 0, 0.05), (x + 0.06, y + 0.06, 0.08)),
        ),
        "windows": join(
            *(box_row(both_rows, z, half, 0) for z in (high * 0.3, high * 0.74)),
            *(box((0, 0, z), (x + 0.06, 0.14, 0.15), 0.02) for z in (high * 0.3, high * 0.74)),
            box_row((-mid * 0.68, 0, mid * 0.68), high * 0.8, (0.11, y + 0.14, 0.14), 0),
            box_row((-mid * 0.68, mid * 0.68), high * 0.32, (0.11, y + 0.14, 0.14), 0),
        ),
        "door": box((0, -y, 0.28), (0.16, 0.16, 0.28), 0.02),
        "chimney": both(box((x * 0.62, 0.12, high + 0.5), (0.12, 0.12, 0.34), 0.02)),
    }  # fmt: skip


def skyscraper(draw: Draw) -> Parts:
    """A slim tower with set-backs, bands of windows around it, an entrance, a spire."""
    wide, low, mast, row = draw(0.4, 0.43), 0.33, draw(0.36, 0.44), draw(0.28, 0.292)
    walls, glass = [box((0, 0, low / 2), (wide, wide, low / 2))], []
    for count, share in ((5, 1.0), (2, 0.68)):
        half, high = wide * share, (count - 0.24) * row + 0.145
        walls.append(box((0, 0, low + high / 2 - 0.05), (half, half, high / 2 + 0.05)))
        for k in range(count):
            place = (0, 0, low + (k + 0.38) * row)
            glass.append(box(place, (half + 0.065, half + 0.065, row * 0.26)))
        low += high
    walls.append(box((0, 0, low), (wide * 0.4, wide * 0.4, 0.135)))
    return {
        "walls": join(*walls),
        "windows": join(*glass),
        "base": box((0, 0, 0.11), (wide + 0.145, wide + 0.145, 0.11)),
        "door": box((0, -wide - 0.07, 0.17), (0.16, 0.145, 0.17)),
        "spire": lathe([(0.082, low), (0.077, low + 0.135 + mast)]),
    }


HOUSES_TO_LIVE_IN = {
    "house": house,
    "cottage": cottage,
    "hut": hut,
    "log cabin": log_cabin,
    "igloo": igloo,
    "treehouse": treehouse,
    "mushroom house": mushroom_house,
    "modern house": modern_house,
    "mansion": fitted(mansion),
    "skyscraper": skyscraper,
}
