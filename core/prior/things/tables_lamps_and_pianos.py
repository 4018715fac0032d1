"""Tables, lamps, a mirror, a fireplace and pianos."""

import math

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    around,
    both,
    box,
    capsule,
    cut,
    egg,
    join,
    lathe,
    moved,
    prism,
    smooth_curve,
    taper,
    tilted,
    tube,
    turned,
)
from core.prior.things.shared.furniture_parts import corner_legs


def table(draw: Draw) -> Parts:
    """An oblong or a round board on slim legs with a frame between them, or on one foot."""
    x, top, slim = draw(0.95, 1.15), draw(0.95, 1.15), draw(0.068, 0.073)
    y, disc = x * draw(0.6, 0.8), draw.shaped("round", 0.25)
    if disc:
        x = y = (x + y) / 2
    thick = max(x, top / 2) * slim
    if draw.legs(4, 4, 4, 1) == 1:
        legs = join(
            tube((0, 0, 0), (0, 0, top), thick * 1.4), tube((0, 0, 0), (0, 0, 0.14), x * 0.55, 0.03)
        )
    else:
        # A disc has no corners.
        a, b = (x * 0.6, y * 0.6) if disc else (x - 0.05, y - 0.05)
        frame = box((0, 0, top - 0.05), (a - thick, b - thick, 0.1))
        legs = join(corner_legs(a, b, top + thick, thick, disc), frame)
    slab = tube((0, 0, top), (0, 0, top + 2 * thick), x, 0.03)
    return {"top": slab if disc else box((0, 0, top + thick), (x, y, thick), 0.02), "legs": legs}


def coffee_table(draw: Draw) -> Parts:
    """Low: an oblong or a round board on slim legs, a shelf between them."""
    x, y, high, slim = draw(1.0, 1.25), draw(0.6, 0.72), draw(0.6, 0.75), draw(0.065, 0.071)
    if draw.chance(0.3):
        x = draw(0.9, 1.1)
        plate, low, u = x * slim, high * 0.28, x * 0.52
        v = u
        top = tube((0, 0, high - plate), (0, 0, high + plate), x, 0.03)
        shelf = tube((0, 0, low - plate), (0, 0, low + plate), x * 0.7, 0.02)
    else:
        plate, low = x * slim, high * 0.28
        u, v = x - plate - 0.08, y - plate - 0.08
        top = box((0, 0, high), (x, y, plate), 0.02)
        shelf = box((0, 0, low), (u, v, plate), 0.02)
    legs = both(box((u, v, high / 2), (plate, plate, high / 2), 0.02), 0, 1)
    return {"top": top, "legs": legs, "shelf": shelf}


def picnic_table(draw: Draw) -> Parts:
    """A table of three thick planks, a bench at either side, A-shaped legs that hold all."""
    x, high, seat = draw(1.3, 1.36), draw(1.36, 1.42), draw(0.74, 0.78)
    out = draw(1.02, 1.06)
    planks = [box((0, 0.44 * k, high), (x, 0.17, 0.1), 0.03) for k in (-1, 0, 1)]
    u = x * 0.64
    leg = capsule((u, 0.3, high - 0.12), (u, 0.86, 0.11), 0.11)
    return {
        "top": join(*planks),
        "benches": both(box((0, out, seat), (x, 0.22, 0.1), 0.03), 1),
        "legs": join(
            both(leg, 0, 1),
            both(box((u, 0, seat - 0.16), (0.1, out + 0.14, 0.1), 0.03)),
            both(box((u, 0, high - 0.16), (0.1, 0.56, 0.1), 0.03)),
            box((0, 0, seat - 0.16), (u, 0.1, 0.1), 0.03),
        ),
    }


def mirror(draw: Draw) -> Parts:
    """A standing mirror, oval or oblong, between two posts."""
    x, half, y = draw(0.5, 0.62), draw(0.85, 1.05), 0.1
    z = half + draw(0.3, 0.42)
    if draw.chance(0.6):
        rim = cut(
            egg((0, 0, z), (x, 0.6, half)),
            box((0, 2 + y, z), (3, 2, 3)),
            box((0, -2 - y, z), (3, 2, 3)),
        )
        glass = cut(
            egg((0, 0, z), (x - 0.13, 0.6, half - 0.13)),
            box((0, 2, z), (3, 2, 3)),
            box((0, -2 - y - 0.03, z), (3, 2, 3)),
        )
    else:
        rim = box((0, 0, z), (x, y, half), 0.04)
        glass = box((0, -y, z), (x - 0.14, 0.04, half - 0.14))
    post = box((x + 0.08, 0, z / 2 + 0.15), (0.1, 0.09, z / 2 + 0.1), 0.03)
    foot = box((x + 0.08, 0, 0.09), (0.11, 0.45, 0.09), 0.04)
    return {
        "frame": rim,
        "glass": glass,
        "stand": join(both(join(post, foot)), box((0, 0, 0.2), (x + 0.1, 0.09, 0.09))),
    }


def lamp(draw: Draw) -> Parts:
    pole_top, bottom, top = draw(1.3, 1.5), draw(0.65, 0.8), draw(0.32, 0.45)
    height = draw(0.75, 0.95)
    shade = [(bottom, pole_top), (top, pole_top + height)]
    foot = draw(0.45, 0.55)
    return {
        "shade": lathe(shade, 0.03),
        "pole": tube((0, 0, 0.05), (0, 0, pole_top + 0.1), draw(0.1, 0.13)),
        "foot": tube((0, 0, 0), (0, 0, draw(0.16, 0.22)), foot, 0.05),
    }


def floor_lamp(draw: Draw) -> Parts:
    """A high pole with a shade."""
    high, wide, top, tall = draw(2.1, 2.5), draw(0.5, 0.68), draw(0.3, 0.5), draw(0.5, 0.7)
    if draw.chance(0.4):
        foot = around(3, capsule((0.55, 0, 0.1), (0, 0, high * 0.55), 0.1), -90)
    else:
        foot = tube((0, 0, 0), (0, 0, 0.14), draw(0.42, 0.55), 0.05)
    return {
        "shade": lathe([(wide, high - 0.05), (top, high + tall)], 0.02),
        "pole": tube((0, 0, 0.05), (0, 0, high + 0.1), 0.105),
        "foot": foot,
    }


def fireplace(draw: Draw) -> Parts:
    """An open fire in a wall with a mantel, perhaps a chimney above."""
    x, y, high, arch = draw(0.95, 1.15), draw(0.36, 0.44), draw(1.25, 1.5), draw(0.5, 0.62)
    hole = box((0, -0.2, high * 0.36), (arch, y, high * 0.3))
    if draw.chance(0.5):
        hole = join(hole, tube((0, -0.2 - y, high * 0.6), (0, y - 0.2, high * 0.6), arch))
    body = box((0, 0, high / 2), (x, y, high / 2))
    if draw.chance(0.5):
        body = join(body, box((0, 0.06, high + 0.5), (x * 0.68, y - 0.08, 0.55)))
    logs = [
        tube((-0.4, -0.1 + s, 0.24 + z), (0.4, -0.1 - s, 0.24 + z), 0.11)
        for s, z in ((0.1, 0), (-0.1, 0.1))
    ]
    tall = draw(0.28, 0.36)
    flames = [
        taper((u, -0.05, 0.36), (u * 1.2, -0.05, 0.36 + tall * f), 0.14, 0.04)
        for u, f in ((-0.22, 0.9), (0.0, 1.4), (0.22, 1.0))
    ]
    return {
        "body": cut(body, hole),
        "mantel": box((0, -0.06, high), (x + 0.12, y + 0.12, 0.1), 0.02),
        "fire": join(*flames),
        "logs": join(*logs),
        "hearth": box((0, -0.15, 0.06), (x + 0.1, y + 0.22, 0.09), 0.02),
    }


def piano(draw: Draw) -> Parts:
    """An upright one: a tall case, to the front a shelf with the keys, on two legs."""
    x, desk, high = draw(1.02, 1.12), draw(0.8, 0.9), draw(1.65, 1.85)
    u, y, front = x - 0.17, -0.15, -0.8
    pitch = 2 * u / 7  # of the white keys: an octave
    black = (
        box((k * pitch - u, -0.64, desk + 0.18), (0.07, 0.2, 0.1), 0.01) for k in (1, 2, 4, 5, 6)
    )
    return {
        "body": join(
            box((0, y, high / 2), (x, 0.34, high / 2), 0.03),
            box((0, front, desk - 0.04), (x, 0.36, 0.12), 0.02),
            both(box((x - 0.085, front, desk + 0.06), (0.085, 0.36, 0.2), 0.03)),
        ),
        "keys": box((0, front + 0.02, desk + 0.09), (u + 0.01, 0.32, 0.09), 0.01),
        "black keys": join(*black),
        "legs": both(box((x - 0.13, front - 0.18, desk / 2), (0.12, 0.12, desk / 2), 0.02)),
        "lid": box((0, y - 0.03, high), (x + 0.07, 0.43, 0.09), 0.02),
    }


def _harp(x: float, y: float, front: float) -> list[tuple[float, float]]:
    """A grand piano's outline seen from above: straight at the left, bent in at the right."""
    bend = [(x, -y * 0.1), (x * 0.72, y * 0.3), (x * 0.34, y * 0.56), (x * 0.16, y * 0.82),
            (-x * 0.2, y * 0.98), (-x * 0.62, y), (-x * 0.92, y * 0.86), (-x, y * 0.6)]  # fmt: skip
    return [(-x, front), (x, front), *smooth_curve(bend)]


def grand_piano(draw: Draw) -> Parts:
    """A harp-shaped case on three legs, its lid propped open over the strings."""
    x, y, low, high = draw(0.92, 1.0), draw(1.1, 1.24), draw(0.76, 0.82), draw(1.22, 1.28)
    a, desk, u = math.radians(draw(33, 39)), -y * 0.54, x - 0.18
    pitch = 2 * u / 7  # of the white keys: an octave
    black = (
        box((k * pitch - u, -y + 0.34, low + 0.25), (0.075, 0.2, 0.1), 0.01)
        for k in (1, 2, 4, 5, 6)
    )
    case = prism(_harp(x, y, desk), 2, (high - low) / 2, (high + low) / 2)
    well = prism(_harp(x - 0.15, y - 0.15, desk + 0.15), 2, 0.4, high + 0.24)
    board = [(u + x, v) for u, v in _harp(x, y, desk)]
    lid = turned(prism(board, 2, 0.075), 1, -math.degrees(a))
    reach = x * 1.5
    prop = (
        (x - 0.12, -0.1, high - 0.1),
        (reach * math.cos(a) - x, -0.1, high + reach * math.sin(a)),
    )
    leg = taper((0, 0, 0.1), (0, 0, low), 0.1, 0.15)
    return {
        "body": join(
            cut(case, well),
            box((0, -y * 0.77, low + 0.08), (x, y * 0.23, 0.08), 0.02),
            both(box((x - 0.09, -y * 0.77, low + 0.18), (0.09, y * 0.23, 0.18), 0.03)),
            tilted(box((0, 0, 0.16), (x * 0.5, 0.075, 0.18), 0.02), -14, (0, desk + 0.1, high)),
        ),
        "keys": box((0, -y + 0.3, low + 0.18), (u + 0.01, 0.28, 0.08), 0.01),
        "black keys": join(*black),
        "lid": moved(lid, (-x, 0, high + 0.08)),
        "strings": prism(_harp(x - 0.1, y - 0.1, desk + 0.1), 2, 0.1, high - 0.22),
        "legs": join(
            both(moved(leg, (x - 0.2, -y * 0.6, 0))),
            moved(leg, (-x * 0.4, y * 0.7, 0)),
            box((0, -y * 0.5, low * 0.5), (0.16, 0.08, low * 0.5), 0.03),
            box((0, -y * 0.5 - 0.1, 0.12), (0.26, 0.18, 0.08), 0.03),
            capsule(*prop, 0.075),
        ),
    }


TABLES_LAMPS_AND_PIANOS = {
    "table": table,
    "coffee table": coffee_table,
    "picnic table": picnic_table,
    "mirror": mirror,
    "lamp": lamp,
    "floor lamp": floor_lamp,
    "fireplace": fireplace,
    "piano": piano,
    "grand piano": grand_piano,
}
