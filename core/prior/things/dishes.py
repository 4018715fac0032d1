"""Dishes that are ready to eat."""

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
    grown,
    join,
    lathe,
    moved,
    prism,
    ring,
    smooth_curve,
    tilted,
    tube,
    turned,
    within,
)
from core.prior.things.shared.ropes import bent


def hamburger(draw: Draw) -> Parts:
    """Two halves of a bun, and what lies between."""
    wide, low, dome = draw(0.92, 1.05), draw(0.26, 0.34), draw(0.5, 0.62)
    patty = low + draw(0.26, 0.32)
    green = patty + 0.3
    leaf = join(
        tube((0, 0, patty + 0.12), (0, 0, green), wide * 0.97, 0.05),
        around(8, egg((wide * 0.92, 0, patty + 0.22), (0.2, 0.3, 0.1))),
    )
    slice_ = turned(box((0, 0, 0), (wide * 0.82, wide * 0.82, 0.07), 0.02), 2, 45 + draw(-12, 12))
    top = cut(egg((0, 0, green), (wide, wide, dome)), box((0, 0, green - 1.02), (2, 2, 1)))
    return {
        "bun": join(top, tube((0, 0, 0), (0, 0, low), wide * 0.96, 0.12)),
        "lettuce": leaf,
        "patty": tube((0, 0, low - 0.02), (0, 0, patty), wide * 1.02, 0.1),
        "cheese": moved(slice_, (0, 0, patty + 0.05)),
    }


def hot_dog(draw: Draw) -> Parts:
    """A sausage in a bun, mustard along it."""
    long, fat, wide = draw(1.0, 1.15), draw(0.25, 0.3), draw(0.34, 0.4)
    bun = both(capsule((wide * 0.8, -long + 0.2, wide), (wide * 0.8, long - 0.2, wide), wide))
    z = wide + fat * 0.95
    end = long + draw(0.1, 0.2)
    sausage = bent(
        [(0, -end, z + 0.06), (0, -end / 2, z), (0, end / 2, z), (0, end, z + 0.06)], [fat] * 4
    )
    waves, swing = 8, fat * 0.5
    line = [
        (swing * (-1) ** k, -long + 2 * long * k / waves, z + fat * 0.88) for k in range(waves + 1)
    ]
    return {
        "bun": join(bun, box((0, 0, 0.25), (wide, long - 0.2, 0.2), 0.05)),
        "sausage": sausage,
        "mustard": bent(line, [0.085] * (waves + 1)),
    }


def sandwich(draw: Draw) -> Parts:
    """Two slices of bread, square or cut to a triangle, and what lies between."""
    wide, thick = draw(0.9, 1.0), draw(0.13, 0.18)
    three = draw.chance(0.6)

    def layer(more: float, low: float, high: float):
        if three:
            side = [(-wide - more, -0.6 - more * 0.5), (wide + more, -0.6 - more * 0.5)]
            return prism([*side, (0, 0.6 + more)], 2, (high - low) / 2, (high + low) / 2)
        return box((0, 0, (low + high) / 2), (wide + more, wide + more, (high - low) / 2), 0.05)

    z, filling = 2 * thick, {}
    for name, more, high in (
        ("lettuce", 0.1, draw(0.13, 0.17)),
        ("ham", 0.02, draw(0.13, 0.18)),
        ("tomato", -0.02, 0.14),
        ("cheese", 0.08, 0.13),
    ):
        filling[name] = layer(more, z - 0.01, z + high)
        z += high
    bread_ = join(layer(0, 0, 2 * thick), layer(0, z - 0.01, z + 2 * thick))
    return {"bread": bread_, **filling}


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


def burrito(draw: Draw) -> Parts:
    """A wrapped roll on end: foil about its lower half, its filling heaped at the open top."""
    r, foil, high = draw(0.54, 0.58), draw(1.1, 1.18), draw(2.16, 2.3)
    facet = prism([(0, 0), (r * 0.7, 0), (r + 0.04, 0.2), (r + 0.14, 0.6), (r + 0.1, 2),
                   (0, 2)], 1, 2)  # fmt: skip
    peak = prism([(-0.5, -1), (0.5, -1), (0.5, foil - 0.36), (0, foil + 0.24),
                  (-0.5, foil - 0.36)], 0, 2)  # fmt: skip
    roll = lathe([(r - 0.1, 0.2), (r, 0.4), (r, high - 0.2), (r - 0.04, high)], 0.02)
    wrap = within(
        lathe([(r, 0.4), (r + 0.08, 0.5), (r + 0.08, high - 0.16), (r + 0.04, high - 0.08)], 0.01),
        moved(turned(box((-1, 0, 0), (1, 2, 3)), 1, 24), (0.08, 0, foil + 0.4)),
    )
    mouth = tube((0, 0, high - 0.2), (0, 0, high + 1), r - 0.14)
    patch = egg((r - 0.01, 0, 0), (0.13, 0.19, 0.12))
    spots = [(-58, 0.5), (-122, 0.42), (-10, 0.62), (50, 0.45), (110, 0.6), (180, 0.5)]
    toast = [moved(turned(patch, 2, a), (0, 0, foil + (high - foil) * v)) for a, v in spots]
    z = high + 0.02
    return {
        "foil": around(8, within(facet, peak), -90),
        "tortilla": cut(join(roll, wrap), mouth),
        "toast": join(*toast),
        "meat": join(
            egg((0, 0, high - 0.14), (r - 0.06, r - 0.06, 0.22)),
            ball((-0.08, 0.2, z + 0.04), 0.21),
            ball((0.3, -0.08, z + 0.02), 0.19),
        ),
        "lettuce": join(
            *(
                egg((u, v, z), (0.22, 0.17, 0.2))
                for u, v in ((-0.36, 0.06), (0.22, 0.34), (0.06, -0.38))
            )
        ),
        "tomato": join(
            *(
                box((u, v, z + 0.08), (0.13, 0.13, 0.13), 0.03)
                for u, v in ((-0.22, -0.28), (0.0, -0.08), (-0.28, 0.4))
            )
        ),
    }


def pizza(draw: Draw) -> Parts:
    """Whole, mostly with a slice missing, salami and olives on the cheese; or one slice."""
    if draw.chance(0.4):
        wide, long = draw(0.62, 0.75), draw(0.95, 1.1)
        side = [(0, -long), (wide, long * 0.8), (-wide, long * 0.8)]
        inner = [(0, -long + 0.02), (wide - 0.04, long * 0.74), (-wide + 0.04, long * 0.74)]
        rim = capsule((-wide + 0.05, long * 0.8, 0.1), (wide - 0.05, long * 0.8, 0.1), 0.18)
        spots = [(-0.24, 0.35), (0.26, 0.42), (0.0, -0.15)]
        return {
            "crust": join(prism(side, 2, 0.09), rim),
            "cheese": prism(inner, 2, 0.07, 0.09),
            "salami": join(*(tube((x, y, 0.05), (x, y, 0.23), 0.19, 0.03) for x, y in spots)),
            "olives": join(ball((0.02, 0.15, 0.15), 0.1), ball((0.1, -0.5, 0.15), 0.1)),
        }
    size = draw(1.2, 1.35)
    gap = prism([(0, 0), (1.2, -2), (-0.4, -2)], 2, 1) if draw.chance(0.6) else ball((9, 0, 0), 0.1)
    disc = tube((0, 0, -0.09), (0, 0, 0.09), size)
    crust = join(disc, ring((0, 0, 0.06), size, 0.16))
    inner = tube((0, 0, 0), (0, 0, 0.16), size - 0.1)
    slices = [tube((0.55, 0, 0.1), (0.55, 0, 0.24), 0.2, 0.03)]
    outer = tube((0.92, 0, 0.1), (0.92, 0, 0.24), 0.17, 0.03)
    return {
        "crust": cut(crust, gap),
        "cheese": cut(inner, gap),
        "salami": cut(join(around(4, slices[0], 40), around(6, outer, 20)), gap),
        "olives": cut(around(5, ball((0.74, 0, 0.17), 0.1), 30), gap),
    }


def fries(draw: Draw) -> Parts:
    """Six straight sticks of potato in a carton."""
    wide, deep, high = draw(0.55, 0.65), draw(0.28, 0.34), draw(0.95, 1.15)
    front = [(-wide * 0.75, 0), (wide * 0.75, 0), (wide, high), (0, high * 0.82), (-wide, high)]
    back = [*front[:3], (0, high * 1.2), front[4]]
    sticks = []
    for y, tops in ((-0.4, (1.36, 1.24, 1.3)), (0.4, (1.62, 1.76, 1.54))):
        for x, top in zip((-0.6, 0, 0.6), tops, strict=True):
            z = high * top * draw(0.96, 1.04)
            half = ((z - high * 0.6) / 2, deep * 0.4)
            sticks.append(box((x * wide, deep * y, z - half[0]), (wide * 0.2, half[1], half[0])))
    return {
        "carton": join(prism(front, 1, deep), prism(back, 1, 0.08, deep)),
        "fries": join(*sticks),
    }


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


def ramen(draw: Draw) -> Parts:
    """A bowl of broth with noodles, two halves of an egg, chopsticks across its rim."""
    wide, high, foot = draw(0.98, 1.1), draw(0.8, 0.96), draw(0.44, 0.52)
    full = high - 0.08
    wall = smooth_curve([(foot, 0.1), (wide * 0.74, 0.3), (wide * 0.95, high * 0.66), (wide, high)])
    nest = [ring((-0.3, -0.22, full + lift), r, 0.11) for r, lift in ((0.42, 0.02), (0.18, 0.12))]
    half = cut(ball((0, 0, 0), 0.3), box((0, 0, 1), (1, 1, 1)))
    eggs = ((0.56, -0.18, 30), (0.2, -0.62, 5))

    def put(solid: Solid) -> Solid:
        return join(*(moved(turned(tilted(solid, 32, (0, 0, 0)), 2, turn), (x, y, full + 0.08))
                      for x, y, turn in eggs))  # fmt: skip

    return {
        "bowl": join(
            cut(lathe(wall), tube((0, 0, full - 0.1), (0, 0, high + 1), wide - 0.15)),
            tube((0, 0, 0), (0, 0, 0.2), foot),
        ),
        "broth": tube((0, 0, full - 0.2), (0, 0, full), wide - 0.14),
        "noodles": join(*nest, tube((-0.3, -0.22, full - 0.1), (-0.3, -0.22, full + 0.1), 0.42)),
        "whites": put(half),
        "yolks": put(ball((0, 0, -0.08), 0.18)),
        "chopsticks": join(
            *(capsule((-1.0, y, high + 0.07), (1.36, y, high + 0.07), 0.09) for y in (0.46, 0.78))
        ),
    }


def salad(draw: Draw) -> Parts:
    """A wide bowl heaped with curly leaves, tomatoes, slices of cucumber and rings of onion."""
    r, high, foot = draw(0.98, 1.1), draw(0.66, 0.8), draw(0.4, 0.5)
    layout, heap = draw.arranged(3), draw(0.26, 0.36)
    side = smooth_curve([(foot, 0.0), (foot + 0.02, 0.08), (r * 0.82, high * 0.46), (r, high)])
    hollow = lathe([(0.02, high * 0.6), (r * 0.8, high - 0.1), (r - 0.12, high + 0.2)])

    def laid(solid: Solid, out: float, turn: float, lean: float, up: float) -> Solid:
        u = out * r
        at = (u * math.cos(turn), u * math.sin(turn), high + heap * (1 - out * out) + up)
        return moved(turned(turned(solid, 1, lean), 2, math.degrees(turn)), at)

    leaves: list[Solid] = [egg((0, 0, high - 0.1), (r * 0.86, r * 0.86, heap + 0.1))]
    for k in range(13):
        size, turn = layout(0.2, 0.27), k * math.tau / 9 + layout(-0.2, 0.2)
        frill = around(5, ball((size, 0, 0), 0.1))
        leaf = join(egg((0, 0, 0), (size, size, 0.11)), frill)
        leaves.append(laid(leaf, 0.84 if k < 9 else 0.4, turn, layout(10, 50), -0.03))
    tomato, slices, rinds, rings = [], [], [], []
    for k in range(9):
        out, turn = (0.62, 0.3)[k % 2], math.tau * k / 9 + layout(-0.1, 0.1)
        where = out, turn, layout(10, 34)
        if k % 3 == 0:
            tomato.append(laid(ball((0, 0, 0), 0.2), *where, 0.07))
        elif k % 3 == 1:
            slices.append(laid(tube((0, 0, -0.075), (0, 0, 0.095), 0.19, 0.02), *where, 0.06))
            rinds.append(laid(tube((0, 0, -0.075), (0, 0, 0.07), 0.25, 0.02), *where, 0.06))
        else:
            rings.append(laid(ring((0, 0, 0.02), 0.19, 0.07), *where, 0.06))
    return {
        "bowl": cut(lathe(side, 0.02), hollow),
        "leaves": join(*leaves),
        "tomato": join(*tomato),
        "cucumber": join(*slices),
        "rind": join(*rinds),
        "onion": join(*rings),
    }


def fried_egg(draw: Draw) -> Parts:
    """White that ran out in lobes, with a brown edge, and a high round yolk."""
    yolk, layout, size = draw(0.4, 0.46), draw.arranged(3), draw(0.94, 1.04)
    first, second = layout(0, math.tau), layout(0, math.tau)

    def outline(grow: float) -> list[tuple[float, float]]:
        turns = [math.tau * k / 40 for k in range(40)]
        reach = [
            size * (0.94 + 0.12 * math.sin(3 * a + first) + 0.07 * math.sin(5 * a + second)) + grow
            for a in turns
        ]
        return [(r * math.cos(a), r * math.sin(a)) for r, a in zip(reach, turns, strict=True)]

    x, y = layout(-0.12, 0.12), layout(-0.12, 0.12)
    return {
        "whites": join(
            grown(prism(outline(-0.06), 2, 0.05, 0.11), 0.05),
            lathe([(yolk + 0.24, 0.1), (yolk + 0.04, 0.28)], 0.02, (x, y)),
        ),
        "yolk": cut(ball((x, y, 0.15), yolk), box((0, 0, -0.9), (2, 2, 1))),
        "edge": grown(prism(outline(0.02), 2, 0.02, 0.07), 0.05),
    }


DISHES = {
    "hamburger": hamburger,
    "hot dog": hot_dog,
    "sandwich": sandwich,
    "taco": taco,
    "burrito": burrito,
    "pizza": pizza,
    "fries": fries,
    "sushi": sushi,
    "ramen": ramen,
    "salad": salad,
    "fried egg": fried_egg,
}
