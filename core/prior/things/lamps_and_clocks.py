"""Lamps, candles and clocks."""

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
    limb,
    moved,
    ring,
    smooth_curve,
    taper,
    tube,
    turned,
)
from core.prior.things.shared.furniture_parts import clock_dial


def candle(draw: Draw) -> Parts:
    """A burning candle on a dish, which may have a loop to the right."""
    radius, high, dish = draw(0.2, 0.27), draw(1.0, 1.4), draw(0.5, 0.62)
    plate = cut(
        lathe([(dish * 0.8, 0), (dish, 0.2)], 0.03),
        lathe([(dish * 0.66, 0.12), (dish - 0.08, 0.6)]),
    )
    socket = tube((0, 0, 0.05), (0, 0, 0.34), radius + 0.1, 0.03)
    holder = [plate, socket]
    if draw.has("handle", 0.4):
        holder.append(ring((dish + 0.12, 0, 0.17), 0.2, 0.085, axis=1))
    top = 0.2 + high
    flame = join(
        egg((0, 0, top + 0.3), (0.13, 0.13, 0.2)),
        taper((0, 0, top + 0.33), (0, 0, top + 0.55), 0.11, 0.03),
    )
    return {
        "wax": tube((0, 0, 0.1), (0, 0, top), radius, 0.05),
        "flame": join(flame, tube((0, 0, top - 0.1), (0, 0, top + 0.2), 0.08)),
        "holder": join(*holder),
    }


def candelabra(draw: Draw) -> Parts:
    """Three candles: one on a turned stem, two on arms that curve out and up from it."""
    foot, reach, high = draw(0.44, 0.52), draw(0.66, 0.76), draw(1.15, 1.3)
    tall, wide = draw(0.46, 0.58), 0.125
    drop, up = reach * 0.5, high + 0.06
    stem = [(foot, 0.0), (foot, 0.08), (foot * 0.72, 0.14), (0.14, 0.26), (0.1, 0.42), (0.17, 0.52)]
    stem += [(0.1, 0.64), (0.09, high * 0.72), (0.16, high * 0.8), (0.1, high * 0.9), (0.1, up)]
    hoop = ring((drop, 0, high - 0.06), drop, 0.085, axis=1)
    arm = join(
        cut(hoop, box((0, 0, high + 0.94), (3, 2, 1))),
        tube((reach, 0, high - 0.08), (reach, 0, up), 0.085),
    )

    def thrice(solid: Solid) -> Solid:
        return join(moved(solid, (0, 0, 0.22)), both(moved(solid, (reach, 0, 0))))

    cup = lathe([(0.09, up - 0.06), (0.25, up + 0.02), (0.25, up + 0.1)], 0.015)
    flame = [(0.04, up + tall), (0.1, up + tall + 0.13), (0.035, up + tall + 0.34)]
    return {
        "stem": join(
            lathe(smooth_curve(stem, 3), 0.01), tube((0, 0, up - 0.2), (0, 0, up + 0.2), 0.1)
        ),
        "arms": both(arm),
        "cups": thrice(cup),
        "candles": thrice(tube((0, 0, up), (0, 0, up + tall), wide, 0.02)),
        "flames": thrice(lathe(smooth_curve(flame), 0.015)),
    }


def chandelier(draw: Draw) -> Parts:
    """Arms with candles about a turned stem, drops of glass below."""
    count, reach, high = 5 + draw.chance(0.6), draw(1.0, 1.15), draw(0.7, 0.85)
    dip, candle = high - draw(0.3, 0.4), draw(0.26, 0.36)
    stem = [(0.1, 0.26), (0.28, 0.5), (0.13, 0.74), (0.22, 1.0), (0.11, 1.25), (0.1, high + 1.0)]
    arm = join(
        capsule((0.1, 0, 0.58), (reach * 0.4, 0, dip), 0.09),
        capsule((reach * 0.4, 0, dip), (reach * 0.8, 0, dip + 0.04), 0.09),
        capsule((reach * 0.8, 0, dip + 0.04), (reach, 0, high), 0.09),
    )
    top = high + 0.12 + candle
    drop = join(ball((reach * 0.62, 0, dip - 0.16), 0.12), ball((reach, 0, high - 0.12), 0.11))
    return {
        "stem": join(
            lathe(smooth_curve(stem), 0.01),
            tube((0, 0, high + 0.9), (0, 0, high + 1.05), 0.26, 0.03),
        ),
        "arms": around(count, arm, -90),
        "cups": around(count, tube((reach, 0, high), (reach, 0, high + 0.14), 0.2, 0.04), -90),
        "candles": around(count, tube((reach, 0, high + 0.1), (reach, 0, top), 0.1), -90),
        "flames": around(
            count, taper((reach, 0, top + 0.08), (reach, 0, top + 0.24), 0.11, 0.06), -90
        ),
        "drops": join(around(count, drop, -90), ball((0, 0, 0.16), 0.17)),
    }


def desk_lamp(draw: Draw) -> Parts:
    """Two arms with joints on a round foot, a shade like a funnel that faces the front, a bulb."""
    foot, tilt, mouth = draw(0.56, 0.6), draw(62, 66), draw(0.54, 0.58)
    elbow, neck = (0, draw(0.56, 0.6), draw(1.0, 1.06)), (0, 0.12, draw(1.62, 1.68))
    low, arm = (0, 0.1, 0.2), 0.09
    cone = [(mouth, -0.94), (mouth, -0.86), (0.24, -0.28), (0.24, -0.06)]
    hollow = lathe([(mouth - 0.1, -1.2), (mouth - 0.1, -0.9), (0.14, -0.34)])

    def hung(solid: Solid) -> Solid:
        return moved(turned(solid, 0, -tilt), neck)

    joints = [tube((-0.19, py, pz), (0.19, py, pz), 0.17, 0.03) for _, py, pz in (elbow, neck)]
    return {
        "base": tube((0, 0, 0), (0, 0, 0.17), foot, 0.05),
        "arms": join(capsule(low, elbow, arm), capsule(elbow, neck, arm)),
        "joints": join(*joints, ball(low, 0.2)),
        "shade": hung(cut(lathe(cone, 0.01), hollow)),
        "bulb": hung(ball((0, 0, -0.84), 0.27)),
    }


def wall_sconce(draw: Draw) -> Parts:
    """A plate of the wall behind, a bent arm, a cup, on it a lamp's shade; or a bell of glass."""
    far, z, r = draw(0.72, 0.8), draw(0.94, 1.02), draw(0.54, 0.6)
    bell = draw.chance(0.45)
    if draw.chance(0.5):
        plate = tube((0, far, 0.62), (0, far + 0.2, 0.62), draw(0.44, 0.5), 0.05)
    else:
        plate = box((0, far + 0.1, 0.66), (0.32, 0.1, draw(0.6, 0.66)), 0.05)
    bend = [(far, 0.62), (far * 0.6, 0.36), (far * 0.22, 0.3), (0, 0.56), (0, z)]
    arm = limb([(0, u, v) for u, v in smooth_curve(bend)], 0.11, 0.11)
    boss = tube((0, far - 0.12, 0.62), (0, far + 0.1, 0.62), 0.22, 0.03)
    cup = lathe([(0.14, z - 0.12), (0.2, z - 0.04), (0.32, z + 0.04), (0.32, z + 0.12)], 0.02)
    if bell:
        side = smooth_curve([(0.24, z), (0.38, z + 0.2), (0.44, z + 0.5), (r, z + 0.8)])
        hollow = lathe([(0.26, z + 0.5), (r - 0.17, z + 0.82), (r - 0.17, z + 1)])
        shade, bulb = cut(lathe(side, 0.02), hollow), egg((0, 0, z + 0.7), (0.24, 0.24, 0.34))
    else:
        low, high = z + 0.42, z + draw(1.1, 1.2)
        hollow = lathe([(r - 0.16, low - 0.2), (r - 0.16, low + 0.1), (0.2, low + 0.2)])
        shade = cut(lathe([(r, low), (r * 0.6, high)], 0.02), hollow)
        bulb = join(tube((0, 0, z), (0, 0, low + 0.3), 0.16), ball((0, 0, low - 0.02), 0.26))
    return {"plate": plate, "arm": join(arm, boss), "cup": cup, "shade": shade, "bulb": bulb}


def pendant_lamp(draw: Draw) -> Parts:
    """From a rose of the ceiling hangs a dome, a cone or a globe, its bulb showing below."""
    shape, r, long = draw.which(3), draw(0.84, 0.94), draw(0.8, 0.92)
    high = r * (0.78, 0.86, 1.5)[shape]
    base, top = 0.26, 0.26 + high
    if shape == 0:
        side = [(r * math.cos(a), base + high * math.sin(a)) for a in
                (math.radians(5 * k) for k in range(17))]  # fmt: skip
        shade = join(lathe(side), tube((0, 0, base - 0.05), (0, 0, base + 0.12), r + 0.05, 0.03))
    elif shape == 1:
        shade = lathe([(r, base - 0.04), (r, base + 0.1), (0.26, top)], 0.02)
    else:
        q, c = r * 0.86, base + r * 0.68
        angles = (math.radians(-54 + 6 * k) for k in range(24))
        side = [(q * math.cos(a), c + q * math.sin(a)) for a in angles]
        shade, top = lathe(side), c + q * 0.94
    mouth = r * 0.86 * 0.45 if shape == 2 else r - 0.17
    bowl = lathe([(mouth, base - 0.6), (mouth, base + 0.06), (mouth * 0.8, base + high * 0.3)])
    size, drop = (0.29, 0.1) if shape == 2 else (0.34, 0.24)
    end = top + 0.2 + long
    return {
        "rose": lathe([(0.16, end - 0.12), (0.4, end), (0.42, end + 0.12)], 0.02),
        "cable": tube((0, 0, top), (0, 0, end), 0.1),
        "cap": lathe([(0.3, top - 0.14), (0.26, top + 0.1), (0.17, top + 0.22)], 0.02),
        "shade": cut(shade, bowl),
        "bulb": join(
            ball((0, 0, base - drop), size),
            tube((0, 0, base - drop), (0, 0, base + high * 0.5), 0.18),
        ),
    }


def clock(draw: Draw) -> Parts:
    """An alarm clock with bells and feet, or a plain round one."""
    r, y = draw(0.75, 0.95), draw(0.18, 0.3)
    face, hands = clock_dial(-y, 0, r - 0.06)
    parts = {
        "body": join(tube((0, -y, 0), (0, y, 0), r, 0.03), ring((0, -y, 0), r - 0.04, 0.1, axis=1)),
        "face": face,
        "hands": hands,
    }
    if draw.has("bells", 0.6):
        parts["bells"] = both(egg((r * 0.56, 0, r * 0.92), (0.3, 0.26, 0.26)))
        parts["feet"] = both(taper((r * 0.55, 0, -r * 0.7), (r * 0.8, 0, -r * 1.1), 0.12, 0.1))
    return parts


def _marked_dial(y: float, r: float, hand: float) -> tuple[Solid, Solid]:
    """A face to the front, in the middle; and its two hands, at ten past ten, and four marks."""
    mark, steep = box((0, y, r - 0.15), (0.08, 0.08, 0.1), 0.01), math.radians(60)
    ends = [(s * math.sin(steep), y, math.cos(steep) * abs(s)) for s in (r * 0.6, -r * 0.42)]
    pointers = (capsule((0, y, 0), end, hand) for end in ends)
    marks = (turned(mark, 1, 90 * k) for k in range(4))
    return tube((0, y, 0), (0, y + 0.2, 0), r), join(*marks, *pointers)


def alarm_clock(draw: Draw) -> Parts:
    """Round, on two legs, two bells on top: between them a hammer, or over them a handle."""
    r, y, lean = draw(0.82, 0.9), draw(0.3, 0.36), 34
    face, hands = _marked_dial(-y - 0.02, r - 0.1, 0.09)
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


LAMPS_AND_CLOCKS = {
    "candle": candle,
    "candelabra": candelabra,
    "chandelier": chandelier,
    "desk lamp": desk_lamp,
    "wall sconce": wall_sconce,
    "pendant lamp": pendant_lamp,
    "clock": clock,
    "alarm clock": alarm_clock,
}
