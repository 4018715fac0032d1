"""What stands in a room at all times or at a feast, and what stands before its window."""

import math
from itertools import pairwise

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
    Vector,
    around,
    ball,
    both,
    box,
    capsule,
    cut,
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
    within,
)

# Longitude, latitude and half width of places in a row through each land, degrees.
LANDS = (
    ((-150, 64, 8), (-120, 58, 15), (-98, 50, 19), (-95, 38, 14), (-103, 24, 8), (-85, 13, 7)),
    ((-85, 13, 7), (-70, 4, 9), (-58, -8, 17), (-64, -25, 10), (-70, -44, 7)),
    ((-80, 66, 10), (-68, 54, 10)),
    ((-42, 74, 10), (-42, 68, 8)),
    ((-6, 24, 12), (14, 18, 16), (30, 10, 12), (24, -10, 14), (24, -26, 9)),
    ((-4, 41, 7), (12, 50, 10), (36, 56, 15), (70, 58, 20), (105, 58, 20), (150, 64, 10)),
    ((45, 26, 10), (60, 38, 14), (85, 40, 17), (110, 34, 16), (104, 16, 8)),
    ((77, 30, 11), (78, 14, 7)),
    ((122, -25, 10), (142, -25, 11)),
)


def globe(draw: Draw) -> Parts:
    """The world on a leaning axis, held by a half ring on a turned foot."""
    r, lean, first = draw(0.72, 0.78), draw(21, 25), (75, -15, -95)[draw.which(3)]
    low, foot = draw(0.5, 0.58), draw(0.48, 0.56)
    bow = r + 0.16
    z = low + bow

    def at(east: float, north: float) -> Vector:
        a, b = math.radians(east + first - 90), math.radians(north)
        return (r * math.cos(b) * math.cos(a), r * math.cos(b) * math.sin(a), r * math.sin(b))

    lands = [
        taper(at(a, b), at(c, d), r * math.radians(wide), r * math.radians(last))
        for row in LANDS
        for (a, b, wide), (c, d, last) in pairwise(row)
    ]

    def hung(solid: Solid) -> Solid:
        return moved(turned(solid, 1, lean), (0, 0, z))

    pin = tube((0, 0, r - 0.1), (0, 0, bow + 0.12), 0.1)
    half = cut(ring((0, 0, 0), bow, 0.085, axis=1), box((-2, 0, 0), (2, 2, 2)))
    side = [(foot, 0.0), (foot, 0.1), (foot * 0.8, 0.17), (0.17, 0.24), (0.13, low + 0.04)]
    caps = [tube((0, 0, s * r * 0.9), (0, 0, s * r * 2), r * 0.5) for s in (-1, 1)]
    surface = ball((0, 0, 0), r + 0.04)
    return {
        "ocean": hung(ball((0, 0, 0), r)),
        "land": hung(within(surface, join(*lands))),
        "ice": hung(within(ball((0, 0, 0), r + 0.045), join(*caps))),
        "meridian": hung(join(half, both(pin, 2))),
        "stand": lathe(side, 0.02),
    }


def flower_pot(draw: Draw) -> Parts:
    """Of clay, wider at its rim, on a saucer; earth in it and nothing else."""
    foot, wide, high = draw(0.52, 0.6), draw(0.78, 0.88), draw(1.2, 1.4)
    band, dish, wall = draw(0.26, 0.34), draw(0.84, 0.94), 0.14
    low = 0.1
    top = low + high
    edge = foot + (wide - foot) * (1 - band / high)
    inside = lathe([(foot - wall, low + 0.2), (wide - wall, top), (wide - wall, top + 0.3)])
    return {
        "pot": cut(lathe([(foot, low), (edge, top - band + 0.02)]), inside),
        "rim": cut(tube((0, 0, top - band), (0, 0, top), wide + 0.08, 0.03), inside),
        "saucer": lathe(
            [(dish - 0.14, 0.0), (dish, 0.24), (dish - 0.13, 0.24), (dish - 0.22, 0.12)], 0.015
        ),
        "soil": within(tube((0, 0, low + 0.3), (0, 0, top - 0.17), wide), inside),
    }


def snow_globe(draw: Draw) -> Parts:
    """A ball of glass on a turned foot; the firs, the snow and the flakes in it stand out of it."""
    r, low, foot = draw(0.78, 0.86), draw(0.42, 0.52), draw(0.76, 0.84)
    layout, level = draw.arranged(3), draw(0.52, 0.62)
    z = low + r * 0.84
    drift = z - r * (1 - level)

    def near(grown: float) -> Solid:
        return ball((0, 0, z), r + grown)

    tiers = [(0.34, 0.0, 0.36), (0.28, 0.2, 0.54), (0.21, 0.4, 0.74)]
    fir = [prism([(-w, drift + a), (w, drift + a), (0, drift + b)], 0, 1, 1) for w, a, b in tiers]
    flakes = []
    for k in range(24):
        up = 1 - (k + 0.5) / 24
        a, flat = 2.4 * k + layout(-0.3, 0.3), math.sqrt(1 - up * up)
        # Between the firs, or above them.
        if math.cos(3 * (a + math.pi / 2)) < 0.2 or up > 0.7:
            at = (r * flat * math.cos(a), r * flat * math.sin(a), z + r * up)
            flakes.append(ball(at, 0.075))
    side = [(foot, 0.0), (foot, 0.14), (foot * 0.86, 0.22), (foot * 0.82, low)]
    return {
        "base": join(lathe(side, 0.02), ring((0, 0, low), foot * 0.78, 0.08)),
        "glass": near(0),
        "snow": within(near(0.04), box((0, 0, drift - 0.96), (2, 2, 1))),
        "firs": within(near(0.055), around(3, join(*fir), -90)),
        "flakes": join(*flakes),
        "plaque": box((0, -foot * 0.9, 0.22), (0.3, 0.12, 0.12), 0.02),
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


def christmas_tree(draw: Draw) -> Parts:
    """A fir of four tiers in a tub, with baubles of two colours, a chain of beads and a star."""
    wide, layout = draw(0.82, 0.94), draw.arranged(2)
    low, step, tiers = 0.72, draw(0.34, 0.38), 4
    boughs, reds, golds, beads = [], [], [], []
    for k in range(tiers):
        r, z = wide * (1 - 0.2 * k), low + step * k
        boughs.append(
            lathe([(r - 0.05, z + 0.05), (r, z + 0.09), (r * 0.3, z + step * 1.45)], 0.02)
        )
        count, turn = (9, 7, 6, 5)[k], layout(0, 1) + 0.5 * k
        for i in range(count):
            a = math.tau * (i + turn) / count
            hung = ball((r * math.cos(a), r * math.sin(a), z + 0.02), 0.1)
            (reds if (i + k) % 2 else golds).append(hung)
        ends = [(wide * (0.8 - 0.2 * k) * 0.78, z + 0.33)]
        beads += [ring((0, 0, h), r, 0.07) for r, h in ends if k < tiers - 1]
    top = low + step * (tiers + 0.45) - 0.02
    point = taper((0.04, 0, 0), (0.25, 0, 0), 0.12, 0.06)
    star = moved(turned(around(5, point, 90), 0, 90), (0, 0, top + 0.18))
    return {
        "leaves": join(*boughs),
        "trunk": tube((0, 0, 0.2), (0, 0, low + 0.2), 0.17),
        "baubles": join(*reds),
        "beads": join(*golds, *beads),
        "star": star,
        "tub": lathe([(0.34, 0.0), (0.42, 0.24), (0.46, 0.25), (0.46, 0.33)], 0.02),
    }


def cardboard_box(draw: Draw) -> Parts:
    """Open, its four flaps folded outwards, tape down front and back, a label and an arrow."""
    x, y, high, wall = draw(0.84, 0.88), draw(0.66, 0.7), draw(1.1, 1.16), 0.075
    flap, slope = draw(0.42, 0.46), draw(15, 19)
    inside = box((0, 0, 0.16 + high), (x - 2 * wall, y - 2 * wall, high))

    def hinged(half: float, along: float) -> Solid:
        leaf = box((flap / 2, 0, 0), (flap / 2, half - 0.13, wall))
        return moved(turned(leaf, 1, slope), (along - wall, 0, high - wall))

    arrow = prism(mirrored([(0.08, -0.26), (0.08, 0), (0.21, 0), (0, 0.26)]), 1, 0.07)
    return {
        "body": cut(box((0, 0, high / 2), (x, y, high / 2), 0.02), inside),
        "flaps": join(both(hinged(y, x)), both(turned(hinged(x, y), 2, 90), 1)),
        "tape": both(box((0, y, high * 0.34), (0.14, 0.07, high * 0.34)), 1),
        "label": box((x * 0.57, -y, high * 0.37), (x * 0.26, 0.07, high * 0.17)),
        "arrows": moved(arrow, (-x * 0.58, -y, high * 0.36)),
    }


def birdhouse(draw: Draw) -> Parts:
    """A box with a gable and a round hole over its perch, on a post."""
    x, y, wall = draw(0.44, 0.5), draw(0.4, 0.46), draw(0.66, 0.78)
    post, rise, over = draw(0.5, 0.66), draw(0.42, 0.5), 0.16
    low = post + 0.08
    top = low + wall
    gable = [(-x, low), (x, low), (x, top), (0.0, top + rise), (-x, top)]
    slope = math.degrees(math.atan2(rise, x))
    long = math.hypot(x, rise) / 2 + over / 2
    slab = box((long - 0.04, 0, 0.07), (long + 0.02, y + over, 0.075))
    hole, z = draw(0.19, 0.22), low + wall * 0.68
    return {
        "walls": cut(prism(gable, 1, y), tube((0, -2, z), (0, -y + 0.16, z), hole)),
        "roof": both(moved(turned(slab, 1, slope), (0, 0, top + rise))),
        "hole": tube((0, -y + 0.1, z), (0, -y + 0.2, z), hole + 0.02),
        "rim": cut(
            tube((0, -y - 0.07, z), (0, -y + 0.05, z), hole + 0.11),
            tube((0, -2, z), (0, 2, z), hole),
        ),
        "perch": join(
            capsule((0, -y, low + 0.16), (0, -y - 0.24, low + 0.16), 0.075),
            box((0, -0.06, low - 0.02), (x + 0.08, y + 0.14, 0.075), 0.02),
        ),
        "post": join(
            box((0, 0, post / 2), (0.11, 0.11, post / 2)),
            box((0, 0, 0.08), (0.34, 0.34, 0.08), 0.02),
        ),
    }


PARLOUR = {
    "globe": globe,
    "flower pot": flower_pot,
    "snow globe": snow_globe,
    "desk lamp": desk_lamp,
    "candelabra": candelabra,
    "christmas tree": christmas_tree,
    "cardboard box": cardboard_box,
    "birdhouse": birdhouse,
}
