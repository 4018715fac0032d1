"""Doors and windows, a bathroom, objects to clean and air a house, and a safe."""

import math

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    around,
    ball,
    both,
    box,
    capsule,
    cut,
    egg,
    join,
    lathe,
    limb,
    mirrored,
    moved,
    prism,
    ring,
    smooth_curve,
    taper,
    tube,
    turned,
)


def door(draw: Draw) -> Parts:
    """A door in its frame, with panels."""
    x, high, y = draw(0.55, 0.7), draw(2.0, 2.3), 0.11
    rows = 2 + draw.chance(0.4)
    step = (high - 0.2) / rows
    panels = [
        box((0, 0, 0.12 + step * (k + 0.5)), (x * 0.66, y + 0.06, step / 2 - 0.1), 0.02)
        for k in range(rows)
    ]
    knob = both(ball((x - 0.13, y + 0.1, high * 0.46), 0.11), 1)
    frame = join(
        both(box((x + 0.08, 0, high / 2), (0.11, 0.17, high / 2))),
        box((0, 0, high), (x + 0.19, 0.17, 0.12)),
    )
    return {
        "door": box((0, 0, high / 2), (x, y, high / 2)),
        "panels": join(*panels),
        "frame": frame,
        "handle": knob,
    }


def window(draw: Draw) -> Parts:
    """Panes in a frame with a sill, some with shutters."""
    x, high = draw(0.6, 0.8), draw(1.3, 1.7)
    z = high / 2
    sides = join(
        both(box((x, 0, z), (0.11, 0.14, z))),
        box((0, 0, high), (x + 0.11, 0.14, 0.11)),
        box((0, 0, 0.06), (x, 0.14, 0.1)),
    )
    cross = join(box((0, 0, z), (0.075, 0.12, z)), box((0, 0, high * 0.52), (x, 0.12, 0.075)))
    parts = {
        "frame": join(sides, cross),
        "glass": box((0, 0, z), (x, 0.07, z)),
        "sill": box((0, -0.12, 0.0), (x + 0.24, 0.28, 0.09), 0.02),
    }
    if draw.has("shutters", 0.4):
        parts["shutters"] = both(box((x + 0.4, -0.04, z + 0.04), (0.34, 0.09, z - 0.06), 0.02))
    return parts


def toilet(draw: Draw) -> Parts:
    """A bowl with its seat, the tank behind, the lid up or down."""
    x, long, high = draw(0.44, 0.5), draw(0.6, 0.7), draw(0.75, 0.85)
    tank, tall = draw(0.5, 0.6), draw(0.65, 0.85)
    up = draw.chance(0.6)
    bowl = cut(egg((0, -0.2, high), (x, long, high * 0.75)), box((0, 0, high + 1), (3, 3, 1)))
    hole = egg((0, -0.22, high + 0.1), (x - 0.16, long - 0.18, 0.36))
    seat = cut(
        egg((0, -0.2, high), (x + 0.04, long + 0.04, 0.3)),
        box((0, 0, high + 1.11), (3, 3, 1)),
        box((0, 0, high - 1.03), (3, 3, 1)),
    )
    foot = lathe([(0.34, 0.0), (0.26, 0.25), (0.3, high * 0.7)], 0.02)
    if up:
        lid = cut(
            egg((0, 0.3, high + 0.5), (x, 0.5, 0.55)),
            box((0, 1.36, high), (3, 1, 3)),
            box((0, -0.82, high), (3, 1, 3)),
        )
        seat = cut(seat, hole)
    else:
        lid = egg((0, -0.2, high + 0.1), (x, long, 0.13))
    return {
        "body": join(
            cut(bowl, hole) if up else bowl,
            foot,
            box((0, 0.3, high * 0.6), (0.26, 0.35, high * 0.38), 0.05),
        ),
        "seat": seat,
        "lid": lid,
        "tank": join(
            box((0, 0.55, high + tall / 2 - 0.05), (tank, 0.21, tall / 2 + 0.05), 0.05),
            box((0, 0.54, high + tall), (tank + 0.05, 0.26, 0.08), 0.03),
        ),
        "button": tube((0, 0.54, high + tall), (0, 0.54, high + tall + 0.14), 0.11),
    }


def bathtub(draw: Draw) -> Parts:
    """A long tub on feet, a tap at its end, water in it."""
    x, y, high, leg = draw(1.2, 1.4), draw(0.6, 0.7), draw(0.75, 0.9), 0.2
    top = leg + high
    body = cut(egg((0, 0, top), (x, y, high)), box((0, 0, top + 0.96), (3, 3, 1)))
    turn = [(math.cos(k * math.pi / 24), math.sin(k * math.pi / 24)) for k in range(48)]
    outer, inner, edge = (
        [((x + d) * u, (y + d) * v) for u, v in turn] for d in (0.09, -0.13, -0.06)
    )
    rim = cut(prism(outer, 2, 0.1, top), prism(inner, 2, 1, top))
    tap = join(
        capsule((x - 0.04, 0, top - 0.1), (x - 0.04, 0, top + 0.4), 0.1),
        capsule((x - 0.04, 0, top + 0.4), (x - 0.4, 0, top + 0.34), 0.09),
        both(ball((x - 0.04, 0.2, top + 0.14), 0.13), 1),
    )
    return {
        "body": body,
        "water": prism(edge, 2, 0.06, top - 0.04),
        "tap": tap,
        "feet": both(taper((x * 0.6, y * 0.55, 0.1), (x * 0.5, y * 0.45, 0.5), 0.13, 0.16), 0, 1),
        "rim": rim,
    }


def sink(draw: Draw) -> Parts:
    """A wash basin on a column, with a tap."""
    x, y, high = draw(0.62, 0.78), draw(0.48, 0.56), draw(1.25, 1.5)
    basin = box((0, 0, high), (x, y, 0.22), draw(0.05, 0.16))
    hole = egg((0, -0.08, high + 0.24), (x - 0.14, y - 0.18, 0.32))
    return {
        "basin": cut(basin, hole),
        "column": lathe([(0.36, 0.0), (0.22, 0.22), (0.2, high * 0.6), (0.34, high - 0.1)], 0.02),
        "tap": join(
            capsule((0, y - 0.12, high), (0, y - 0.12, high + 0.42), 0.1),
            capsule((0, y - 0.12, high + 0.42), (0, -0.05, high + 0.34), 0.09),
        ),
        "handles": both(ball((x * 0.42, y - 0.12, high + 0.26), 0.12)),
    }


def washing_machine(draw: Draw) -> Parts:
    """A round glass door in the front of a box."""
    x, y, high, r = draw(0.65, 0.75), draw(0.6, 0.68), draw(1.45, 1.7), draw(0.36, 0.44)
    z = high * 0.45
    return {
        "body": box((0, 0, high / 2), (x, y, high / 2), 0.06),
        "door": ring((0, -y, z), r, 0.1, axis=1),
        "glass": egg((0, -y, z), (r, 0.15, r)),
        "panel": box((-x * 0.4, -y, high - 0.17), (x * 0.45, 0.06, 0.1), 0.02),
        "knob": tube(
            (x * 0.6, -y - 0.12, high - 0.17), (x * 0.6, -y + 0.1, high - 0.17), 0.12, 0.02
        ),
    }


def bucket(draw: Draw) -> Parts:
    """A pail with its handle up."""
    low, high, top = draw(0.5, 0.58), draw(1.0, 1.2), draw(0.7, 0.8)
    hole = [(low - 0.1, 0.14), (top - 0.1, high), (top - 0.1, high + 0.4)]
    rim = ring((0, 0, high), top, 0.08)
    parts = {"body": join(cut(lathe([(low, 0), (top, high)], 0.01), lathe(hole)), rim)}
    if draw.has("handle", 0.85):
        bow = ring((0, 0, high), top, draw(0.085, 0.1), axis=1)
        parts |= {"handle": cut(bow, box((0, 0, high - 1), (2, 2, 1)))}
    return parts


def mop(draw: Draw) -> Parts:
    """A long handle, a clamp, and a skirt of thick white strands that spreads on the floor."""
    high, r, reach = draw(2.9, 3.05), 0.1, draw(0.62, 0.68)
    top = 0.84
    strand = limb([(0.1, 0, top - 0.06), (0.34, 0, top - 0.16), (reach * 0.8, 0, 0.42),
                   (reach, 0, 0.14)], 0.13, 0.145)  # fmt: skip
    inner = limb([(0.1, 0, top - 0.1), (0.24, 0, 0.5), (0.32, 0, 0.12)], 0.14, 0.13)
    return {
        "handle": tube((0, 0, top), (0, 0, high), r, 0.03),
        "clamp": lathe(
            [(0.36, top - 0.1), (0.36, top + 0.06), (0.18, top + 0.16), (0.17, top + 0.34)], 0.02
        ),
        "strands": join(around(9, strand), around(6, inner)),
        "cap": tube((0, 0, high - 0.34), (0, 0, high + 0.04), r + 0.04, 0.05),
    }


def trash_can(draw: Draw) -> Parts:
    """A ribbed bin with handles and a lid."""
    low, top, high = draw(0.5, 0.58), draw(0.64, 0.74), draw(1.3, 1.6)
    ribs = [ring((0, 0, high * k), low + (top - low) * k, 0.08) for k in (0.3, 0.68)]
    lid = [(top + 0.08, high), (top + 0.06, high + 0.12), (0.2, high + draw(0.24, 0.34))]
    peak = high + 0.24
    knob = cut(ring((0, 0, peak), 0.2, 0.085, axis=1), box((0, 0, peak - 1.1), (2, 2, 1)))
    sides = both(ring((top - 0.02, 0, high * 0.7), 0.18, 0.08, axis=1))
    return {
        "body": join(lathe([(low, 0), (top, high)], 0.02), *ribs),
        "lid": lathe(lid, 0.02),
        "handles": join(knob, sides),
    }


def fan(draw: Draw) -> Parts:
    """Flat blades before a post on a round foot, within a ring."""
    z, r, foot = draw(1.3, 1.5), draw(0.74, 0.84), draw(0.5, 0.6)
    count = 3 + draw.chance(0.5)
    end, wide = r - 0.16, 0.27 if count == 4 else 0.36
    half = [(0.1, 0.05), (0.11, 0.2), (wide * 0.74, 0.34), (wide, end - 0.17)]
    half += [(wide * 0.72, end - 0.03), (0, end)]
    # Made along +x, flat on the ground; then the axis, upright, is laid along y.
    blade = prism([(v, u) for u, v in mirrored(smooth_curve(half))], 2, 0.09)
    return {
        "blades": moved(turned(around(count, blade, 90), 0, 90), (0, -0.2, z)),
        "cage": ring((0, -0.07, z), r, 0.11, axis=1),
        "hub": tube((0, -0.36, z), (0, 0.3, z), 0.2, 0.05),
        "stand": join(
            tube((0, 0.14, 0.1), (0, 0.14, z), 0.12),
            tube((0, 0.05, 0), (0, 0.05, 0.18), foot, 0.05),
        ),
    }


def safe(draw: Draw) -> Parts:
    """A steel box, a dial and a wheel with handles on its door."""
    x, y, z = draw(0.78, 0.9), draw(0.66, 0.78), draw(0.82, 0.98)
    foot, rim, dial = 0.14, draw(0.15, 0.19), draw(0.17, 0.21)
    middle, front = foot + z, -y - 0.06
    reach = draw(0.3, 0.36)
    spoke = capsule((0, 0, 0), (reach, 0, 0), 0.08)
    wheel = join(
        turned(around(3, spoke, 0), 0, 90),
        turned(around(3, ball((reach, 0, 0), 0.12), 0), 0, 90),
        tube((0, -0.12, 0), (0, 0.14, 0), 0.15, 0.03),
    )
    hinge = tube((-x + 0.04, front, 0), (-x + 0.04, front, 0.3), 0.09, 0.02)
    return {
        "body": box((0, 0, middle), (x, y, z), draw(0.04, 0.09)),
        "door": box((0, -y, middle), (x - rim, 0.1, z - rim), 0.03),
        "dial": join(
            tube((-x * 0.36, front - 0.14, middle), (-x * 0.36, 0, middle), dial, 0.03),
            tube((-x * 0.36, front - 0.24, middle), (-x * 0.36, 0, middle), dial * 0.5, 0.03),
        ),
        "handle": moved(turned(wheel, 1, 30), (x * 0.26, front - 0.16, middle)),
        "hinges": join(
            moved(hinge, (0, 0, middle + z * 0.4)), moved(hinge, (0, 0, middle - z * 0.4 - 0.3))
        ),
        "feet": both(box((x - 0.18, y - 0.18, foot * 0.6), (0.14, 0.14, foot * 0.6), 0.02), 0, 1),
    }


DOORS_AND_BATHROOM = {
    "door": door,
    "window": window,
    "toilet": toilet,
    "bathtub": bathtub,
    "sink": sink,
    "washing machine": washing_machine,
    "bucket": bucket,
    "mop": mop,
    "trash can": trash_can,
    "fan": fan,
    "safe": safe,
}
