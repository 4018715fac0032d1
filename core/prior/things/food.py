"""Baking, dishes and what is sold packed; with fruit and vegetables all the new food."""

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
    moved,
    prism,
    ring,
    smooth_curve,
    tube,
    turned,
)
from core.prior.things.fruits import FRUITS, arc, bent
from core.prior.things.packed import PACKED


def bread(draw: Draw) -> Parts:
    """A loaf that swells over its tin, one slice cut off at the front."""
    wide, long, high = draw(0.5, 0.6), draw(0.85, 1.05), draw(0.9, 1.05)

    def outline(less: float) -> list[tuple[float, float]]:
        crown = smooth_curve([(wide + 0.1, high * 0.62), (wide + 0.1, high * 0.9),
                              (wide * 0.6, high * 1.12), (0, high * 1.18)])  # fmt: skip
        side = [(wide, 0), (wide, high * 0.55), *crown]
        shrink = 1 - less / wide
        return [(x * shrink * s, less + z * shrink) for s in (1, -1) for x, z in side[::s]]

    slices = [prism(outline(0), 1, 0.13, 0.13 - long), prism(outline(0), 1, long - 0.23, 0.23)]
    cores = [prism(outline(0.1), 1, 0.12, 0.06 - long), prism(outline(0.1), 1, 0.1, 0.5 - long)]
    return {
        "crust": join(*slices, box((0, 0.3 - long, 0.08), (wide, 0.2, 0.08))),
        "crumb": join(*cores),
    }


def croissant(draw: Draw) -> Parts:
    """A crescent of ever thicker rolls, lying, its tips to the front."""
    half, bend, thick = draw(65, 80), draw(0.85, 0.95), draw(0.4, 0.48)
    points = [(x, z, 0.0) for x, _, z in arc(bend, 90 - half, 90 + half, 6)]
    rolls = []
    for k, (x, y, _) in enumerate(points):
        size = thick * (1 - 0.055 * (k - 3) ** 2)
        roll = egg((0, 0, 0), (size, 0.27, size * 0.95))
        rolls.append(moved(turned(roll, 2, (k - 3) * half / 3), (x, y, 0.4)))
    core = bent([(x, y, 0.36) for x, y, _ in points], [0.14, 0.22, 0.3, 0.34, 0.3, 0.22, 0.14])
    return {"crust": join(*rolls), "folds": core}


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


def cake(draw: Draw) -> Parts:
    """One or two tiers, icing that runs down, cherries about the rim, candles that burn on top."""
    wide, high, two = draw(0.85, 1.0), draw(0.6, 0.8), draw.chance(0.4)
    drip = capsule((wide + 0.01, 0, high * 0.55), (wide + 0.01, 0, high), 0.13)
    icing = [tube((0, 0, high - 0.1), (0, 0, high + 0.1), wide + 0.07, 0.08), around(10, drip)]
    layers, z, top = [tube((0, 0, 0), (0, 0, high), wide, 0.03)], high + 0.1, wide
    if two:
        top, z = wide * 0.64, high + 0.62
        layers.append(tube((0, 0, high - 0.05), (0, 0, z - 0.08), top, 0.03))
        drop = capsule((top, 0, z - 0.28), (top, 0, z - 0.1), 0.11)
        icing += [tube((0, 0, z - 0.16), (0, 0, z), top + 0.06, 0.07), around(7, drop)]
    count, at = (3, 0.5) if two else (5, 0.46)
    stick = tube((top * at, 0, z - 0.1), (top * at, 0, z + 0.4), 0.1)
    flame = egg((top * at, 0, z + 0.5), (0.1, 0.1, 0.17))
    cherries = around(6 if two else 8, ball((wide * 0.84, 0, high + 0.2), 0.14))
    plate = tube((0, 0, -0.14), (0, 0, 0.02), wide + 0.25, 0.05)
    return {
        "icing": join(*icing),
        "body": join(*layers),
        "topping": cherries,
        "plate": plate,
        "candles": around(count, stick, 18),
        "flames": around(count, flame, 18),
    }


def cookie(draw: Draw) -> Parts:
    """A disc with chips of chocolate, sometimes bitten; it stands a little tilted back."""
    wide, thick = draw(0.95, 1.05), draw(0.13, 0.17)
    body = join(tube((0, -thick, 0), (0, thick, 0), wide, 0.12), egg((0, 0, 0), (0.8, 0.24, 0.8)))
    bite = [ball((wide * 0.75, 0, wide * 0.75), 0.38), ball((wide * 0.98, 0, wide * 0.3), 0.2)]
    body = cut(body, *bite) if draw.chance(0.5) else body
    spots = [(0.08, 0.06)] + [
        (r * math.cos(math.radians(a)), r * math.sin(math.radians(a)))
        for r, a in ((0.52, 10), (0.5, 85), (0.55, 160), (0.5, 230), (0.55, 300))
    ]
    chips = (egg((x, 0, z), (0.14, thick + 0.13, 0.14)) for x, z in spots)
    tilt = draw(-20, -8)
    return {
        "body": turned(body, 0, tilt),
        "chips": turned(cut(join(*chips), *bite), 0, tilt),
    }


def cheese(draw: Draw) -> Parts:
    """A wedge with holes and a rind at its back."""
    wide, long, high = draw(0.7, 0.85), draw(0.95, 1.15), draw(0.7, 0.9)
    side = [(-wide, long), (wide, long), (0.06, -long), (-0.06, -long)]
    # Where the long side stands at a height along the wedge, from its tip.
    holes = []
    for k, z, size in ((0.3, 0.35, 0.13), (0.52, 0.62, 0.17), (0.75, 0.3, 0.2), (0.86, 0.72, 0.13)):
        x, y = wide * k, -long + 2 * long * k
        holes += [ball((x, y, high * z), size), ball((-x + 0.03, y - 0.15, high * (1 - z)), size)]
    holes += [
        ball((0.1, 0.2, high), 0.2),
        ball((-0.25, 0.62, high), 0.17),
        ball((0.0, -0.4, high), 0.13),
    ]
    return {
        "body": cut(prism(side, 2, high / 2, high / 2), *holes),
        "rind": box((0, long + 0.03, high / 2), (wide + 0.04, 0.09, high / 2 + 0.02), 0.03),
    }


def egg_(draw: Draw) -> Parts:
    """A hen's egg, its tip up."""
    wide, high = draw(0.7, 0.78), draw(1.9, 2.1)
    low = egg((0, 0, 0), (wide, wide, high * 0.43))
    top = egg((0, 0, 0), (wide, wide, high * 0.57))
    half = 2.0
    return {
        "shell": join(
            cut(low, box((0, 0, half + 0.01), (2, 2, half))),
            cut(top, box((0, 0, -half - 0.01), (2, 2, half))),
        )
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


def pancakes(draw: Draw) -> Parts:
    """A stack on a plate, butter and syrup on top."""
    wide, thick, count = draw(0.85, 0.95), draw(0.12, 0.15), 3 + draw.chance(0.5) + draw.chance(0.3)
    stack, z, own = [], 0.12, draw.arranged()
    for _ in range(count):
        x, y, size = own(-0.06, 0.06), own(-0.06, 0.06), wide * own(0.94, 1.04)
        stack.append(tube((x, y, z - 0.02), (x, y, z + 2 * thick), size, thick * 0.95))
        z += 2 * thick
    drop = capsule((wide * 1.0, 0, z - draw(0.35, 0.5)), (wide * 0.96, 0, z - 0.06), 0.12)
    syrup = join(
        tube((0, 0, z - 0.08), (0, 0, z + 0.06), wide * 0.72, 0.05),
        around(5, join(drop, capsule((0.4, 0, z), (wide * 0.95, 0, z - 0.04), 0.12)), 18),
    )
    butter = turned(box((0, 0, z + 0.13), (0.24, 0.24, 0.12), 0.03), 2, draw(10, 60))
    plate = lathe([(0.75, 0), (wide + 0.38, 0.14)], 0.05)
    return {"pancakes": join(*stack), "syrup": syrup, "butter": butter, "plate": plate}


def lollipop(draw: Draw) -> Parts:
    """A disc with a spiral on a stick."""
    size, long, thick = draw(0.62, 0.75), draw(1.2, 1.5), draw(0.17, 0.22)
    z = long + size
    turns = draw(1.8, 2.3)
    points = []
    for k in range(19):
        angle, radius = turns * 2 * math.pi * k / 18, 0.05 + (size - 0.14) * k / 18
        points.append((radius * math.cos(angle), 0.0, z + radius * math.sin(angle)))
    front = bent([(x, -thick, h) for x, _, h in points], [0.08] * 19)
    back = bent([(x, thick, h) for x, _, h in points], [0.08] * 19)
    return {
        "candy": tube((0, -thick, z), (0, thick, z), size, 0.1),
        "swirl": join(front, back),
        "stick": tube((0, 0, 0), (0, 0, long + 0.1), 0.1, 0.03),
    }


def popsicle(draw: Draw) -> Parts:
    """Ice on a flat stick, with two grooves, sometimes bitten."""
    wide, high, deep = draw(0.5, 0.58), draw(1.35, 1.6), draw(0.22, 0.28)
    low = 0.6
    body = join(
        box((0, 0, low + high * 0.36), (wide, deep, high * 0.36), 0.08),
        tube((0, -deep, low + high - wide), (0, deep, low + high - wide), wide, 0.08),
    )
    groove = both(
        capsule((wide * 0.42, -deep, low + 0.3), (wide * 0.42, -deep, low + high - 0.5), 0.09)
    )
    bite = [ball((wide * 0.95, 0, low + high), 0.36), ball((wide * 0.4, 0, low + high + 0.1), 0.25)]
    holes = [groove, *bite] if draw.chance(0.5) else [groove]
    line = low + high * draw(0.5, 0.62)
    upper = box((0, 0, line + 2), (2, 2, 2))
    return {
        "ice": cut(body, *holes, upper),
        "top": cut(body, *holes, box((0, 0, line - 2.01), (2, 2, 2))),
        "stick": join(
            box((0, 0, 0.4), (0.15, 0.09, 0.5), 0.05), tube((0, -0.09, -0.1), (0, 0.09, -0.1), 0.15)
        ),
    }


FOOD = {
    **FRUITS,
    "bread": bread,
    "croissant": croissant,
    "pizza": pizza,
    "hot dog": hot_dog,
    "sandwich": sandwich,
    "cake": cake,
    "cookie": cookie,
    "cheese": cheese,
    "egg": egg_,
    "fries": fries,
    "pancakes": pancakes,
    "lollipop": lollipop,
    "popsicle": popsicle,
    **PACKED,
}
