"""Kitchen, bathroom and what hangs or stands about the house."""

import math

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
    around,
    ball,
    blend,
    both,
    box,
    capsule,
    cut,
    egg,
    join,
    lathe,
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


def refrigerator(draw: Draw) -> Parts:
    """Two doors, one above the other or side by side."""
    x, y, high, soft = draw(0.55, 0.72), draw(0.5, 0.58), draw(1.9, 2.3), 0.05
    if draw.chance(0.6):
        split = high * 0.64
        doors = join(
            box((0, -y, split / 2 + 0.03), (x, 0.11, split / 2 - 0.12), 0.03),
            box((0, -y, (split + high) / 2 + 0.03), (x, 0.11, (high - split) / 2 - 0.06), 0.03),
        )
        bars = [
            box((-x + 0.17, -y - 0.18, split + v), (0.075, 0.1, half), 0.02)
            for v, half in ((-0.4, 0.24), (0.28, 0.15))
        ]
        handles = join(*bars)
    else:
        doors = both(box((x / 2, -y, high / 2 + 0.03), (x / 2 - 0.06, 0.11, high / 2 - 0.05), 0.03))
        handles = both(box((0.2, -y - 0.18, high * 0.55), (0.075, 0.1, high * 0.16), 0.02))
    return {
        "body": box((0, 0.05, high / 2 + 0.04), (x, y, high / 2 - 0.04), soft),
        "doors": doors,
        "handles": handles,
        "feet": both(box((x - 0.15, y - 0.2, 0.06), (0.12, 0.12, 0.08)), 0, 1),
    }


def stove(draw: Draw) -> Parts:
    """An oven below four plates, knobs to the front."""
    x, y, high = draw(0.65, 0.78), draw(0.55, 0.65), draw(1.15, 1.35)
    return {
        "body": join(
            box((0, 0, high / 2), (x, y, high / 2), 0.03),
            box((0, y - 0.08, high + draw(0.05, 0.2)), (x, 0.1, 0.16), 0.02),
        ),
        "window": box((0, -y, high * 0.42), (x * 0.68, 0.06, high * 0.2), 0.03),
        "plates": both(
            tube(
                (x * 0.45, y * 0.42, high - 0.1),
                (x * 0.45, y * 0.42, high + 0.08),
                draw(0.18, 0.22),
            ),
            0,
            1,
        ),
        "knobs": join(
            *(
                tube((x * k, -y - 0.1, high - 0.15), (x * k, -y + 0.1, high - 0.15), 0.085)
                for k in (-0.72, -0.24, 0.24, 0.72)
            )
        ),
        "handle": capsule(
            (-x * 0.66, -y - 0.04, high * 0.7), (x * 0.66, -y - 0.04, high * 0.7), 0.08
        ),
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


def _dial(y: float, z: float, r: float) -> tuple[Solid, Solid]:
    """A clock's face looking to the front, and its hands."""
    hands = join(
        capsule((0, y - 0.06, z), (0, y - 0.06, z + r * 0.66), 0.065),
        capsule((0, y - 0.06, z), (r * 0.45, y - 0.06, z - r * 0.2), 0.065),
    )
    return tube((0, y - 0.04, z), (0, y + 0.1, z), r), hands


def clock(draw: Draw) -> Parts:
    """An alarm clock with bells and feet, or a plain round one."""
    r, y = draw(0.75, 0.95), draw(0.18, 0.3)
    face, hands = _dial(-y, 0, r - 0.06)
    parts = {
        "body": join(tube((0, -y, 0), (0, y, 0), r, 0.03), ring((0, -y, 0), r - 0.04, 0.1, axis=1)),
        "face": face,
        "hands": hands,
    }
    if draw.has("bells", 0.6):
        parts["bells"] = both(egg((r * 0.56, 0, r * 0.92), (0.3, 0.26, 0.26)))
        parts["feet"] = both(taper((r * 0.55, 0, -r * 0.7), (r * 0.8, 0, -r * 1.1), 0.12, 0.1))
    return parts


def grandfather_clock(draw: Draw) -> Parts:
    """A high case: the dial in its head, the pendulum behind glass."""
    x, y, high = draw(0.4, 0.48), draw(0.3, 0.36), draw(2.3, 2.7)
    base, head = draw(0.45, 0.6), high - 0.85
    face, hands = _dial(-y - 0.04, high - 0.42, x * 0.8)
    roof = [
        (-x - 0.1, high),
        (x + 0.1, high),
        (x * 0.4, high + draw(0.2, 0.34)),
        (-x * 0.4, high + 0.2),
    ]
    z = (base + head) / 2
    return {
        "body": join(
            box((0, 0, base / 2), (x + 0.06, y + 0.05, base / 2), 0.02),
            box((0, 0, z), (x - 0.06, y - 0.06, (head - base) / 2 + 0.1)),
            box((0, 0, high - 0.42), (x + 0.05, y + 0.02, 0.45), 0.02),
            prism(roof, 1, y + 0.04),
        ),
        "face": face,
        "hands": hands,
        "glass": box((0, -y + 0.05, z), (x * 0.56, 0.05, (head - base) / 2 - 0.06)),
        "pendulum": join(
            capsule((0, -y, z + 0.3), (0, -y, z - 0.1), 0.07),
            tube((0, -y - 0.07, z - 0.2), (0, -y + 0.06, z - 0.2), 0.16),
        ),
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


def beanbag(draw: Draw) -> Parts:
    """A soft bag with a hollow to sit in."""
    x, high = draw(0.85, 1.0), draw(0.5, 0.6)
    top = draw(0.95, 1.25)
    bag = blend(
        0.35,
        egg((0, 0, high * 0.85), (x, x, high)),
        egg((0, 0.3, top * 0.75), (x * 0.6, 0.42, top * 0.5)),
    )
    return {
        "body": cut(bag, box((0, 0, -0.95), (3, 3, 1))),
        "loop": ring((0, 0.34, top * 1.2), 0.15, 0.085, axis=1),
    }


def picture_frame(draw: Draw) -> Parts:
    """A painted landscape in a frame."""
    x, z = draw(0.75, 1.1), draw(0.75, 1.1)
    wide, y = draw(0.14, 0.2), 0.12
    rim = cut(box((0, 0, 0), (x, y, z), 0.03), box((0, -0.2, 0), (x - wide, 0.2, z - wide)))
    u, v = x - wide + 0.01, z - wide + 0.01
    hill = [
        (-u, -v),
        (u, -v),
        (u, -v * 0.3),
        (u * 0.4, v * 0.15),
        (0, -v * 0.35),
        (-u * 0.4, v * 0.4),
        (-u, -v * 0.2),
    ]
    return {
        "frame": rim,
        "picture": box((0, 0.02, 0), (u, 0.07, v)),
        "hills": prism(hill, 1, 0.08, -0.01),
        "sun": tube((u * 0.5, -0.09, v * 0.6), (u * 0.5, 0.05, v * 0.6), 0.17),
    }


def television(draw: Draw) -> Parts:
    """A flat screen on a foot, or an old set with aerials and knobs."""
    if draw.chance(0.5):
        x, z = draw(1.2, 1.4), draw(0.68, 0.8)
        return {
            "body": box((0, 0, z + 0.3), (x, 0.12, z), 0.03),
            "screen": box((0, -0.1, z + 0.3), (x - 0.11, 0.06, z - 0.11)),
            "stand": join(
                box((0, 0.02, 0.25), (0.18, 0.1, 0.25)),
                box((0, 0, 0.07), (draw(0.4, 0.75), 0.34, 0.08), 0.03),
            ),
            "buttons": both(box((0.2, -0.12, 0.36), (0.08, 0.06, 0.06))),
        }
    x, z, y = draw(0.8, 0.95), draw(0.6, 0.7), draw(0.45, 0.6)
    m = z + 0.25
    ears = both(capsule((0.05, 0, m + z - 0.05), (0.45, 0, m + z + draw(0.45, 0.65)), 0.085))
    return {
        "body": box((0, 0, m), (x, y, z), 0.1),
        "screen": box((-x * 0.2, -y, m), (x * 0.66, 0.07, z * 0.76), 0.06),
        "stand": join(
            both(taper((x * 0.75, y * 0.6, 0.1), (x * 0.6, y * 0.5, 0.4), 0.09, 0.12), 0, 1), ears
        ),
        "buttons": join(
            *(
                tube((x * 0.76, -y - 0.1, m + s), (x * 0.76, -y + 0.1, m + s), 0.12, 0.02)
                for s in (-0.06, 0.36)
            )
        ),
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


def toaster(draw: Draw) -> Parts:
    """Two slices of bread stick out of its top."""
    x, y, high = draw(0.8, 1.0), draw(0.48, 0.56), draw(0.85, 1.05)
    out = draw(0.15, 0.35)
    slices = [box((0, s, high - 0.1 + out), (x * 0.58, 0.11, 0.4), 0.1) for s in (-0.2, 0.2)]
    return {
        "body": box((0, 0, high / 2 + 0.06), (x, y, high / 2), draw(0.12, 0.22)),
        "bread": join(*slices),
        "base": box((0, 0, 0.08), (x + 0.03, y + 0.03, 0.1), 0.04),
        "lever": box((x + 0.06, 0, high * 0.66), (0.13, 0.16, 0.08), 0.04),
        "knob": tube(
            (x * 0.5, -y - 0.1, high * 0.35), (x * 0.5, -y + 0.1, high * 0.35), 0.13, 0.02
        ),
    }


def kettle(draw: Draw) -> Parts:
    """A kettle with its handle above and a short spout to the left."""
    wide, high = draw(0.72, 0.85), draw(0.8, 1.0)
    side = [(wide * 0.9, 0.0), (wide, high * 0.25), (wide * 0.8, high * 0.7), (0.36, high)]
    bow = cut(
        ring((0, 0, high * 0.85), wide * 0.72, 0.1, axis=1), box((0, 0, high * 0.7 - 1), (3, 3, 1))
    )
    return {
        "body": lathe(smooth_curve(side), 0.02),
        "spout": taper((-wide * 0.7, 0, high * 0.4), (-wide - 0.35, 0, high * 0.95), 0.22, 0.12),
        "handle": bow,
        "lid": join(egg((0, 0, high), (0.36, 0.36, 0.12)), ball((0, 0, high + 0.16), 0.13)),
    }


def microwave(draw: Draw) -> Parts:
    """A box with a dark window, a handle and buttons."""
    x, y, z = draw(1.05, 1.25), draw(0.55, 0.7), draw(0.58, 0.7)
    spots = [(x * 0.8, z * k) for k in (-0.45, -0.1)]
    return {
        "body": box((0, 0, z), (x, y, z), 0.05),
        "window": box((-x * 0.24, -y, z), (x * 0.6, 0.07, z * 0.7), 0.03),
        "handle": capsule((x * 0.48, -y - 0.05, z * 0.5), (x * 0.48, -y - 0.05, z * 1.5), 0.09),
        "buttons": join(*(box((u, -y, z + v), (0.13, 0.08, 0.085), 0.02) for u, v in spots)),
        "display": box((x * 0.8, -y, z * 1.5), (0.16, 0.07, 0.12)),
    }


def shelf(draw: Draw) -> Parts:
    """A board on two brackets with a few things on it."""
    x, y = draw(1.1, 1.35), draw(0.32, 0.4)
    bracket = prism([(y, 0.0), (y, -0.65), (y - 0.18, -0.65), (-y * 0.7, 0.0)], 0, 0.1, x * 0.66)
    tall = draw(0.4, 0.6)
    books = [
        box((-x * 0.75 + 0.25 * k, 0.02, 0.05 + h * tall), (0.115, y - 0.1, h * tall))
        for k, h in enumerate((0.85, 1.0, 0.75))
    ]
    pot = lathe(
        smooth_curve([(0.16, 0.05), (0.28, 0.3), (0.14, 0.55), (0.2, 0.66)]), 0.02, (x * 0.55, 0)
    )
    return {
        "board": box((0, 0, 0), (x, y, 0.11), 0.02),
        "brackets": both(bracket),
        "books": join(*books),
        "vase": pot,
    }


def pillow(draw: Draw) -> Parts:
    """A soft square with drawn-out corners; tassels on some."""
    x, y, z = draw(0.85, 1.2), draw(0.75, 0.9), draw(0.3, 0.4)
    soft = blend(0.2, egg((0, 0, z), (x * 0.95, y * 0.95, z)), box((0, 0, z), (x, y, 0.13), 0.12))
    parts = {"body": soft, "button": egg((0, 0, 2 * z), (0.14, 0.14, 0.08))}
    if draw.has("tassels", 0.4):
        parts["tassels"] = both(ball((x, y, z), 0.15), 0, 1)
    return parts


HOME_FITTINGS = {
    "door": door,
    "window": window,
    "refrigerator": refrigerator,
    "stove": stove,
    "washing machine": washing_machine,
    "toilet": toilet,
    "bathtub": bathtub,
    "sink": sink,
    "clock": clock,
    "grandfather clock": grandfather_clock,
    "fan": fan,
    "beanbag": beanbag,
    "picture frame": picture_frame,
    "television": television,
    "trash can": trash_can,
    "toaster": toaster,
    "kettle": kettle,
    "microwave": microwave,
    "shelf": shelf,
    "pillow": pillow,
}
