"""Tableware, a counter and a grill."""

import math

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
    around,
    ball,
    both,
    box,
    capsule,
    cut,
    egg,
    join,
    lathe,
    moved,
    prism,
    ring,
    smooth_curve,
    tilted,
    tube,
    turned,
)
from core.prior.things.shared.outlines import rounded


def plate(draw: Draw) -> Parts:
    """With a wide rim about a round well, two rings of colour on it."""
    r, high, well = draw(1.15, 1.25), draw(0.34, 0.42), draw(0.6, 0.68)
    foot, low = well * draw(0.8, 0.95), 0.2
    inner, edge = r * well, draw(0.07, 0.085)
    side = [(r * foot, 0.0), (r * foot, 0.06), (r, high - 0.1), (r, high)]
    return {
        "body": lathe([*side, (inner + 0.08, low + 0.07), (inner, low), (0.0, low)], 0.01),
        "rim": join(
            ring((0, 0, high - 0.04), r, edge),
            ring((0, 0, low + 0.03), inner + 0.04, edge * 0.9),
        ),
    }


def cutting_board(draw: Draw) -> Parts:
    """A board of wood with darker strips, a hole in its handle."""
    long, wide, z = draw(0.85, 0.95), draw(0.66, 0.76), draw(0.1, 0.12)
    grip, out, strip = draw(0.21, 0.24), draw(1.42, 1.52), draw(0.09, 0.12)
    hole, shift = 0.11, -0.25
    board = prism([(x + shift, y) for x, y in rounded(long, wide, draw(0.16, 0.24))], 2, z, z)
    handle = prism(
        [(x + out - 0.6 + shift, y) for x, y in rounded(0.6, grip, grip * 0.95)], 2, z * 0.85, z
    )
    eye = out - grip + shift
    at = long * 0.62
    return {
        "body": board,
        "bands": join(
            *(box((s * at + shift, 0, z + 0.01), (strip, wide, z + 0.01)) for s in (-1, 1))
        ),
        "handle": cut(handle, tube((eye, 0, -1), (eye, 0, 1), hole)),
    }


def salt_shaker(draw: Draw) -> Parts:
    """Of glass, half full of salt, with a round cap of metal that has holes."""
    low, top, high = draw(0.55, 0.62), draw(0.36, 0.42), draw(1.15, 1.35)
    fill, dome, rim = draw(0.5, 0.65) * high, draw(0.28, 0.36), draw(0.07, 0.1)

    def radius(z: float) -> float:
        return low + (top - low) * z / high

    cap, eaves = top + 0.07, high + 0.1
    roof = [(cap, eaves), (cap * 0.82, eaves + dome * 0.7), (0.0, eaves + dome)]
    hole = ball((cap * 0.56, 0, eaves + dome * 0.78), 0.075)
    return {
        "body": lathe([(radius(fill), fill), (top, high)], 0.0),
        "salt": lathe([(low, 0.06), (radius(fill), fill)], 0.012),
        "cap": lathe([(cap, high - 0.1), *smooth_curve(roof)], 0.01),
        "base": tube((0, 0, 0), (0, 0, 0.16), low + rim, 0.04),
        "holes": join(ball((0, 0, eaves + dome - 0.02), 0.075), around(4, hole, 45)),
    }


def paper_cup(draw: Draw) -> Parts:
    """A tapered cup in a sleeve, under a lid to drink through or with a straw in it."""
    low, wide, high = draw(0.44, 0.52), draw(0.64, 0.72), draw(1.6, 1.85)
    straw, a, b = draw.chance(0.35), draw(0.26, 0.34), draw(0.66, 0.74)

    def at(share: float, out: float = 0.0) -> tuple[float, float]:
        return low + (wide - low) * share + out, high * share

    lid = [(wide + 0.09, high - 0.1), (wide + 0.09, high + 0.06), (wide * 0.9, high + 0.1),
           (wide * 0.84, high + 0.26), (wide * 0.76, high + 0.28)]  # fmt: skip
    pipe = capsule((0.08, 0.1, high), (0.24, 0.26, high + 0.95), 0.1)
    hole = box((0, -wide * 0.5, high + 0.28), (0.16, 0.09, 0.06), 0.02)
    logo = low + (wide - low) * (a + b) / 2
    return {
        "cup": lathe([at(0.0), at(1.0)], 0.01),
        "sleeve": lathe([at(a, 0.05), at(b, 0.05)], 0.02),
        "lid": lathe(lid, 0.02),
        "rim": join(
            tube((0, 0, high - 0.14), (0, 0, high - 0.02), wide + 0.12, 0.04),
            tube((0, 0, 0), (0, 0, 0.12), low + 0.05, 0.04),
        ),
        "spout": pipe if straw else hole,
        "badge": tube((0, -logo - 0.1, high * (a + b) / 2), (0, 0, high * (a + b) / 2), 0.26),
    }


def bubble_tea(draw: Draw) -> Parts:
    """A tapered cup of milk tea, tapioca pearls about its foot, a lid and a straw that leans."""
    foot, r, high = draw(0.46, 0.5), draw(0.64, 0.7), draw(1.44, 1.56)
    pearl, lean, tall = draw(0.14, 0.15), draw(12, 16), draw(2.62, 2.78)

    def row(z: float, count: int, first_deg: float) -> Solid:
        out = foot + (r - foot) * z / high - 0.03
        return around(count, ball((out, 0, z), pearl), first_deg)

    if draw.chance(0.5):
        top = high + 0.46
        cap = [(r, high), *((r * 0.94 * math.cos(a / 10), high + 0.06 + 0.44 * math.sin(a / 10))
                            for a in range(14))]  # fmt: skip
    else:
        top = high + 0.36
        cap = [(r - 0.06, high), (r - 0.06, high + 0.2), (r - 0.24, high + 0.24), (r - 0.28, top)]
    straw = cut(
        tube((0, 0, -0.7), (0, 0, tall - top), 0.12),
        moved(turned(box((0, 0, 1), (1, 1, 1)), 1, 35), (0, 0, tall - top - 0.1)),
    )
    return {
        "tea": lathe([(foot - 0.04, 0), (foot, 0.06), (r, high + 0.02)]),
        "pearls": join(row(0.22, 7, 0), row(0.52, 7, 180 / 7), row(0.82, 3, 50)),
        "lid": lathe(cap),
        "straw": moved(turned(straw, 1, lean), (0.08, 0, top)),
        "rim": ring((0, 0, high), r - 0.01, 0.1),
    }


def grill(draw: Draw) -> Parts:
    """A kettle on three legs, its lid open at the back; sausages and a steak on its grate."""
    r, leg, lean = draw(0.82, 0.92), draw(0.85, 1.05), draw(68, 80)
    z = leg + 0.36
    up = box((0, 0, 3), (5, 5, 3))
    bowl = cut(moved(egg((0, 0, 0), (r, r, r * 0.8)), (0, 0, z)), moved(up, (0, 0, z)))
    dome = cut(egg((0, r, 0), (r, r, r * 0.72)), box((0, 0, -3), (5, 5, 3)))
    hollow = egg((0, r, -0.02), (r - 0.14, r - 0.14, r * 0.72 - 0.14))
    knob = join(
        both(tube((0.2, r, r * 0.6), (0.2, r, r * 0.72 + 0.16), 0.085)),
        capsule((-0.24, r, r * 0.72 + 0.18), (0.24, r, r * 0.72 + 0.18), 0.1),
    )
    legs = [((0, -0.3), (0, -0.86)), ((0.3, 0.2), (0.72, 0.5)), ((-0.3, 0.2), (-0.72, 0.5))]
    feet = join(*(tube((*a, z - 0.5), (*b, 0.0), 0.1) for a, b in legs))
    bars = [
        capsule((v, -w, z + 0.03), (v, w, z + 0.03), 0.085)
        for v, w in (
            (k * 0.27, math.sqrt(r * r * 0.8 - (k * 0.27) ** 2)) for k in (-2, -1, 0, 1, 2)
        )
    ]
    food = [capsule((v - 0.22, y, z + 0.2), (v + 0.22, y + 0.06, z + 0.2), 0.14)
            for v, y in ((-0.28, -0.36), (-0.3, 0.0))]  # fmt: skip
    steak = egg((0.32, -0.14, z + 0.17), (0.28, 0.34, 0.13))
    return {
        "bowl": join(bowl, both(box((r + 0.02, 0, z - 0.1), (0.14, 0.2, 0.08), 0.03))),
        "lid": tilted(cut(dome, hollow), lean, (0, r - 0.08, z - 0.02)),
        "legs": join(feet, tube((0, 0.04, 0.3), (0, 0.04, 0.42), 0.5, 0.03)),
        "grate": join(ring((0, 0, z), r - 0.07, 0.1), *bars),
        "food": join(*food, steak),
        "handles": join(
            tilted(knob, lean, (0, r - 0.08, z - 0.02)),
            both(tube((0.64, 0.5, 0.2), (0.86, 0.5, 0.2), 0.2, 0.03)),
        ),
    }  # fmt: skip


def counter(draw: Draw) -> Parts:
    """Of a bar or a shop: panels in front under a wide top, a rail for the feet."""
    x, y, high = draw(1.3, 1.42), draw(0.36, 0.44), draw(1.0, 1.15)
    over, thick, z = draw(0.1, 0.16), draw(0.085, 0.11), draw(0.26, 0.32)
    count, rail = 3 + draw.chance(0.5), -y - 0.2
    step = 2 * (x - 0.08) / count
    panels = [
        box(
            (-x + 0.08 + step * (k + 0.5), -y, high * 0.56),
            (step / 2 - 0.09, 0.06, high * 0.3),
            0.02,
        )
        for k in range(count)
    ]
    stays = tube((x * 0.72, rail, z), (x * 0.72, -y + 0.05, z), 0.075)
    return {
        "body": box((0, 0, high / 2), (x, y, high / 2), 0.01),
        "top": box((0, -over * 0.6, high + thick * 0.8), (x + over, y + over, thick), 0.03),
        "panels": join(*panels),
        "base": box((0, 0, 0.09), (x + 0.04, y + 0.05, 0.09)),
        "rail": join(tube((-x + 0.04, rail, z), (x - 0.04, rail, z), 0.08), both(stays)),
    }


TABLEWARE = {
    "plate": plate,
    "cutting board": cutting_board,
    "salt shaker": salt_shaker,
    "paper cup": paper_cup,
    "bubble tea": bubble_tea,
    "grill": grill,
    "counter": counter,
}
