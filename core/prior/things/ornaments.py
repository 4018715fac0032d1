"""Vases, ornaments of a shelf, and small objects of a room."""

import math
from itertools import pairwise

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
    Vector,
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
    limb,
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


def vase(draw: Draw) -> Parts:
    belly, neck, lip = draw(0.62, 0.8), draw(0.24, 0.32), draw(0.36, 0.46)
    low, high = draw(0.6, 0.8), draw(1.5, 1.7)
    outline = [(draw(0.34, 0.44), 0), (belly, low), (neck, high), (lip, high + 0.4)]
    hole = [(neck - 0.1, high - 0.5), (neck - 0.1, high), (lip - 0.1, high + 0.41)]
    return {"body": cut(lathe(smooth_curve(outline, 5)), lathe([*hole, (lip - 0.1, high + 0.8)]))}


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


def bust(draw: Draw) -> Parts:
    """A marble hero: a cap of great curls, a straight nose, shoulders cut off, a round pedestal."""
    r, wide, low = draw(0.43, 0.46), draw(0.66, 0.72), draw(0.42, 0.46)
    z = low + draw(1.24, 1.3)
    front = -r * 0.98
    chest = blend(0.2, egg((0, 0, low + 0.3), (wide, 0.38, 0.42)),
                  taper((0, 0.04, low + 0.4), (0, 0.04, z - r * 0.4), 0.3, 0.24))  # fmt: skip
    sides = both(box((wide + 0.86, 0, low), (1, 2, 2)))
    brow = z + r * 0.16
    arches = both(capsule((0.06, front + 0.02, brow), (r * 0.56, front + 0.13, brow), 0.085))
    skull = blend(0.1, egg((0, 0.02, z), (r * 0.84, r, r * 1.1)), arches,
                  egg((0, -r * 0.4, z - r * 0.72), (r * 0.56, r * 0.56, r * 0.56)))  # fmt: skip
    curls = (
        ball((r * u, r * v, z + r * t), 0.17)
        for u, v, t in ((0.0, -0.8, 0.78), (0.42, -0.66, 0.76), (0.72, -0.34, 0.56),
                        (0.0, -0.36, 1.02), (0.42, -0.04, 0.96), (0.76, 0.16, 0.58),
                        (0.84, 0.3, 0.12), (0.0, 0.36, 1.0), (0.42, 0.58, 0.72), (0.0, 0.86, 0.6),
                        (0.64, 0.68, 0.26), (0.26, 0.96, 0.16), (0.48, 0.7, -0.24),
                        (0.0, 0.84, -0.3))
    )  # fmt: skip
    plinth = [(0.46, 0.0), (0.46, 0.14), (0.36, 0.2), (0.24, 0.28), (0.24, 0.32), (0.36, low),
              (0.36, low + 0.1)]  # fmt: skip
    ridge = [(front + 0.12, brow + 0.04), (front - 0.04, brow - 0.02),
             (front - 0.14, z - r * 0.48), (front + 0.12, z - r * 0.54)]  # fmt: skip
    lips = (egg((0, front + 0.06, v), (half, 0.1, 0.075))
            for half, v in ((0.15, z - r * 0.76), (0.1, z - r * 0.92)))  # fmt: skip
    return {
        "body": join(cut(chest, box((0, 0, low - 0.92), (2, 2, 1)), sides), skull,
                     both(egg((r * 0.86, 0.02, z - 0.06), (0.1, 0.13, 0.17)))),
        "hair": both(join(*curls)),
        "base": lathe(plinth, 0.02),
        "face": join(
            prism(ridge, 0, 0.08),
            both(ball((r * 0.38, front + 0.1, brow - 0.12), 0.11)),
            *lips,
        ),
    }  # fmt: skip


def trophy(draw: Draw) -> Parts:
    """A cup with two ears on a block."""
    wide, low, high = draw(0.46, 0.54), draw(0.38, 0.48), draw(0.8, 0.95)
    bottom = low + 0.4
    shape = [(0.12, low), (0.12, bottom), (wide * 0.85, bottom + 0.28), (wide, bottom + high)]
    hole = lathe(
        [(wide * 0.5, bottom + 0.4), (wide - 0.1, bottom + high), (wide - 0.1, bottom + high + 0.4)]
    )
    cup = cut(lathe(smooth_curve(shape, 4), 0.02), hole)
    ear = ring((wide * 0.98, 0, bottom + high * 0.6), draw(0.26, 0.31), 0.09, axis=1)
    return {
        "cup": cup,
        "handles": both(cut(ear, hole)),
        "base": join(
            box((0, 0, low / 2), (0.42, 0.42, low / 2), 0.04),
            tube((0, 0, low), (0, 0, low + 0.12), 0.3, 0.03),
        ),
    }


def bell(draw: Draw) -> Parts:
    """A bell with its loop and its clapper."""
    wide, high = draw(0.8, 0.9), draw(1.15, 1.35)
    shape = [
        (wide, 0.0),
        (wide * 0.78, 0.2),
        (wide * 0.6, high * 0.5),
        (wide * 0.5, high * 0.85),
        (0.12, high),
    ]
    hole = lathe(
        [(wide * 0.82, -0.3), (wide * 0.82, 0.0), (wide * 0.42, high * 0.5), (0.2, high * 0.75)]
    )
    loop = ring((0, 0, high + 0.2), draw(0.2, 0.24), 0.1, axis=1)
    return {
        "body": cut(lathe(smooth_curve(shape, 4), 0.03), hole),
        "loop": loop,
        "clapper": join(ball((0, 0, 0.0), 0.22), tube((0, 0, 0), (0, 0, high * 0.8), 0.09)),
    }


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


def crown(draw: Draw) -> Parts:
    """A band with six points, pearls on their tips, and gems."""
    wide, band, reach = draw(0.8, 0.9), draw(0.34, 0.44), draw(0.45, 0.6)
    top, foot = band + reach, wide * 0.42
    hoop = cut(tube((0, 0, 0), (0, 0, band), wide + 0.05), tube((0, 0, -1), (0, 0, 3), wide - 0.13))
    flat = [(-foot, band - 0.12), (foot, band - 0.12), (0.06, top), (-0.06, top)]
    spike = prism(flat, 0, 0.085, wide - 0.03)
    return {
        "band": join(hoop, around(6, spike, -90)),
        "pearls": around(6, ball((wide - 0.03, 0, top + 0.04), 0.15), -90),
        "gems": around(6, ball((wide + 0.06, 0, band * 0.48), 0.14), -90),
    }


def hat(draw: Draw) -> Parts:
    """A top hat, or a lower one with a round crown."""
    wide, high, brim = draw(0.52, 0.62), draw(0.75, 1.05), draw(0.95, 1.1)
    low = tube((0, 0, 0), (0, 0, 0.17), brim, 0.07)
    if draw.chance(0.5):
        body = lathe([(wide * 0.95, 0.05), (wide * draw(0.95, 1.1), high)], 0.04)
    else:
        body = join(
            egg((0, 0, high * 0.45), (wide, wide, high * 0.5)),
            tube((0, 0, 0.05), (0, 0, high * 0.45), wide),
        )
    ribbon = tube((0, 0, 0.15), (0, 0, draw(0.34, 0.4)), wide + 0.05, 0.02)
    return {"body": join(low, body), "ribbon": ribbon}


def umbrella_stand(draw: Draw) -> Parts:
    """A tall vessel with a rim, in it two rolled umbrellas with crooks that lean apart."""
    r, high = draw(0.52, 0.58), draw(1.26, 1.38)
    tops = (draw(2.36, 2.46), draw(2.1, 2.2))

    def umbrella(u: float, v: float, top: float) -> tuple[Solid, Solid]:
        """Rolled cloth up to where it was open, above it the stick's crook."""
        foot, lip = (u * 0.1, v, 0.3), (u, v, top - 0.54)
        cloth = join(taper(foot, lip, 0.12, 0.22), taper(lip, (u * 1.06, v, top - 0.4), 0.22, 0.12))
        bow = [(u * 1.06, top - 0.5), (u * 1.14, top - 0.2), (u * 1.3, top), (u * 1.72, top + 0.02),
               (u * 1.98, top - 0.16), (u * 1.98, top - 0.3)]  # fmt: skip
        return cloth, limb([(s, v, t) for s, t in smooth_curve(bow)], 0.09, 0.09)

    first, second = umbrella(0.28, -0.12, tops[0]), umbrella(-0.28, 0.14, tops[1])
    wide = draw(0.76, 1.0)
    hollow = tube((0, 0, 0.2), (0, 0, 3), r - 0.15)
    return {
        "body": cut(lathe([(r * wide, 0.04), (r, high)]), hollow),
        "rim": ring((0, 0, high), r - 0.03, 0.11),
        "base": tube((0, 0, 0), (0, 0, 0.18), r * wide + 0.1, 0.04),
        "umbrellas": join(first[0], second[0]),
        "handles": join(first[1], second[1]),
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


def pin(draw: Draw) -> Parts:
    """A bowling pin."""
    belly, neck, head = draw(0.46, 0.54), draw(0.16, 0.2), draw(0.27, 0.31)
    shape = [(0.28, 0.0), (belly, 0.75), (neck, 1.6), (head, 2.0), (0.1, 2.3)]
    return {"body": lathe(smooth_curve(shape, 4), 0.03)}


ORNAMENTS = {
    "vase": vase,
    "flower pot": flower_pot,
    "bust": bust,
    "trophy": trophy,
    "bell": bell,
    "globe": globe,
    "snow globe": snow_globe,
    "picture frame": picture_frame,
    "crown": crown,
    "hat": hat,
    "umbrella stand": umbrella_stand,
    "birdhouse": birdhouse,
    "cardboard box": cardboard_box,
    "bowling pin": pin,
}
