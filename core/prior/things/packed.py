"""Snacks, and food in its package."""

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
    prism,
    smooth_curve,
    tube,
    turned,
)
from core.prior.things.fruits import bent


def pretzel(draw: Draw) -> Parts:
    """Three loops of dough with grains of salt, upright."""
    fat, wide = draw(0.17, 0.2), draw(0.92, 1.08)
    half = [(0.0, 0.28), (0.26, 0.62), (0.55, 0.95), (0.95, 0.95), (1.08, 0.5), (0.95, 0.05)]
    half += [(0.7, -0.4), (0.3, -0.72), (0.0, -0.8)]
    side = [(x * wide, 0.0, z) for x, z in smooth_curve(half, 3)]
    ends = [(0.0, -0.1, 0.28), (0.3 * wide, -0.12, -0.1), (0.52 * wide, -0.1, -0.58)]
    dough = join(both(bent(side, [fat] * len(side))), both(bent(ends, [fat, fat, fat * 0.85])))
    grains = [(0.55, 0.95), (0.95, 0.9), (1.08, 0.5), (0.9, -0.05), (0.55, -0.55), (0.2, -0.76)]
    salt = (both(ball((x * wide, -fat * 0.92, z), 0.075)) for x, z in grains)
    return {"dough": dough, "salt": join(*salt)}


def pie(draw: Draw) -> Parts:
    """A dish, a lattice of dough over the filling and a crimped rim."""
    wide, high = draw(1.0, 1.15), draw(0.4, 0.52)
    inside = tube((0, 0, high - 0.2), (0, 0, high + 0.4), wide)
    step = wide * 0.5
    bars = [box((0, step * k, high + 0.03), (2, 0.11, 0.09), 0.03) for k in (-1, 0, 1)]
    bars += [box((step * k, 0, high + 0.05), (0.11, 2, 0.09), 0.03) for k in (-1, 0, 1)]

    def lattice(p):
        return join(*bars)(p).maximum(inside(p))

    rim = around(16, egg((wide + 0.02, 0, high + 0.02), (0.17, 0.24, 0.14)))
    return {
        "crust": join(turned(lattice, 2, 20), rim),
        "filling": lathe([(wide * 0.6, 0.08), (wide - 0.08, high - 0.02)]),
        "dish": lathe([(wide * 0.72, 0), (wide + 0.05, high - 0.06)], 0.03),
    }


def can(draw: Draw) -> Parts:
    """A drink's can with a tapering neck, or a tin; a label about it."""
    wide, high = draw(0.55, 0.65), draw(1.6, 2.0)
    if draw.chance(0.6):
        low, neck = wide * 0.8, wide * 0.8
        tab = box((0, -0.12, high), (0.14, 0.22, 0.06), 0.04)
    else:
        high, low, neck = high * 0.75, wide * 1.0, wide * 1.0
        tab = tube((0, 0, high - 0.1), (0, 0, high + 0.03), wide * 0.72, 0.02)
    shape = [(low, 0), (wide, 0.14), (wide, high - 0.2), (neck, high - 0.02)]
    rim = tube((0, 0, high - 0.1), (0, 0, high + 0.06), neck + 0.04, 0.04)
    rim = cut(rim, tube((0, 0, high), (0, 0, high + 1), neck - 0.09))
    foot = tube((0, 0, 0), (0, 0, 0.1), low + 0.03, 0.03)
    label = tube((0, 0, 0.2), (0, 0, high - 0.26), wide + 0.03)
    return {"label": label, "can": join(lathe(shape, 0.01), rim, foot), "tab": tab}


def jar(draw: Draw) -> Parts:
    """A glass with shoulders, a wide lid and a label."""
    wide, high, neck = draw(0.62, 0.75), draw(1.2, 1.55), draw(0.46, 0.54)
    shape = [(wide - 0.1, 0), (wide, 0.1), (wide, high - 0.2), (wide - 0.05, high - 0.08)]
    body = lathe([*shape, (neck, high), (neck, high + 0.14)], 0.02)
    lid = tube((0, 0, high + 0.06), (0, 0, high + 0.36), neck + 0.13, 0.05)
    tall = high * draw(0.2, 0.28)
    band = tube((0, 0, high * 0.45 - tall), (0, 0, high * 0.45 + tall), wide + 0.05)
    label = cut(band, box((0, 2, 1), (3, 1.9, 3))) if draw.chance(0.5) else band
    grip = around(14, capsule((neck + 0.12, 0, high + 0.14), (neck + 0.12, 0, high + 0.3), 0.07))
    return {"body": body, "lid": join(lid, grip), "label": label}


def taco(draw: Draw) -> Parts:
    """A folded shell, open side up, what fills it looks out."""
    size, gap = draw(0.98, 1.1), draw(0.24, 0.32)
    below = box((0, 0, -2 + 0.02), (3, 3, 2))
    leaf = cut(tube((0, -0.07, 0), (0, 0.07, 0), size, 0.03), below)
    # A half disc hangs with its round side down; two lean apart over a round fold.
    side = turned(leaf, 1, 180)

    def sheet(y: float):
        tilt = math.degrees(math.atan2(gap, size))
        turned_ = turned(side, 0, -tilt if y > 0 else tilt)
        return lambda p: turned_(p - p.new_tensor((0.0, y, size)))

    shell = join(sheet(gap), sheet(-gap), capsule((-0.5, 0, 0.12), (0.5, 0, 0.12), 0.12))
    xs = [(k - 3) * size * 0.27 for k in range(7)]
    core = capsule((-size * 0.7, 0, size - 0.12), (size * 0.7, 0, size - 0.12), gap)
    meat = join(core, box((0, 0, 0.5), (0.6, 0.12, 0.4)))
    sides = [(x, 0.14 * (-1) ** k) for k, x in enumerate(xs)]
    green = join(*(egg((x, y, size + 0.1), (0.2, 0.16, 0.2)) for x, y in sides))
    red = [box((x, -y, size + 0.16), (0.11, 0.11, 0.11), 0.02) for x, y in sides[1::2]]
    return {"shell": shell, "meat": meat, "lettuce": green, "tomato": join(*red)}


def sushi(draw: Draw) -> Parts:
    """A roll in seaweed, or a slice of fish on rice with a band about it."""
    if draw.chance(0.5):
        size, high = draw(0.8, 0.95), draw(0.5, 0.65)
        skin = tube((0, 0, 0), (0, 0, 2 * high), size, 0.03)
        rice = tube((0, 0, -0.03), (0, 0, 2 * high + 0.06), size - 0.13, 0.05)
        heart = tube((0, 0, -0.05), (0, 0, 2 * high + 0.14), size * draw(0.38, 0.46), 0.05)
        return {"rice": rice, "fish": heart, "seaweed": cut(skin, rice)}
    long, wide, high = draw(0.95, 1.1), draw(0.45, 0.52), draw(0.34, 0.42)
    rice = box((0, 0, high), (wide, long, high), 0.25)
    arch = [(0, -long - 0.18, high * 1.55), (0, -long * 0.5, high * 2.1), (0, 0, high * 2.2)]
    arch += [(0, long * 0.5, high * 2.1), (0, long + 0.18, high * 1.55)]
    pieces = [
        bent([(x, y, z) for _, y, z in arch], [0.17] * 5)
        for x in (-wide * 0.62, -wide * 0.2, wide * 0.2, wide * 0.62)
    ]
    band = box((0, 0, high * 1.24), (wide + 0.06, 0.2, high * 1.3), 0.08)
    return {"rice": rice, "fish": join(*pieces), "seaweed": band}


def milk_carton(draw: Draw) -> Parts:
    """A square carton with a gable, its seam up, a cap or a coloured band."""
    wide, high, gable = draw(0.48, 0.56), draw(1.4, 1.75), draw(0.4, 0.5)
    roof = prism([(-wide, high - 0.02), (wide, high - 0.02), (0, high + gable)], 0, wide)
    seam = box((0, 0, high + gable + 0.02), (wide, 0.085, 0.16), 0.02)
    low = high * draw(0.2, 0.35)
    band = box((0, 0, low), (wide + 0.03, wide + 0.03, high * 0.17), 0.01)
    z = high + gable * 0.5
    cap = tube((0, -wide * 0.4, z - 0.08), (0, -wide * 0.5 - 0.2, z + 0.17), 0.2, 0.03)
    return {
        "carton": box((0, 0, high / 2), (wide, wide, high / 2), 0.02),
        "top": join(roof, seam, band),
        "cap": cap,
    }


PACKED = {
    "pretzel": pretzel,
    "pie": pie,
    "can": can,
    "jar": jar,
    "taco": taco,
    "sushi": sushi,
    "milk carton": milk_carton,
}
