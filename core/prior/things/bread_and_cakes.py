"""Bread, cakes and other things from the oven."""

import itertools
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
    taper,
    tube,
    turned,
    within,
)
from core.prior.things.shared.ropes import arc, bent


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


def cupcake(draw: Draw) -> Parts:
    """A pleated cup, a swirl of icing, a cherry."""
    low, wide, high = draw(0.48, 0.56), draw(0.7, 0.8), draw(0.65, 0.8)
    cup = lathe([(low, 0), (wide, high)], 0.02)
    pleat = taper((low, 0, 0.06), (wide, 0, high - 0.04), 0.08, 0.1)
    swirl, z = [], high + 0.1
    for width in (1.02, 0.74, 0.45):
        swirl.append(egg((0, 0, z), (wide * width + 0.06, wide * width + 0.06, 0.27)))
        z += draw(0.25, 0.29)
    return {
        "icing": join(*swirl),
        "cup": join(cup, around(12, pleat)),
        "cherry": ball((0, 0, z + 0.1), 0.17),
    }


def muffin(draw: Draw) -> Parts:
    """A pleated paper cup under a domed golden top, studded with blueberries."""
    low, wide, high = draw(0.6, 0.64), draw(0.82, 0.87), draw(0.84, 0.9)
    dome, tall = wide + 0.24, draw(0.62, 0.68)
    cup = lathe([(low, 0.0), (wide, high)], 0.02)
    pleat = taper((low - 0.01, 0, 0.08), (wide, 0, high - 0.02), 0.09, 0.12)
    z = high + 0.08
    top = within(egg((0, 0, z), (dome, dome, tall * 1.2)), box((0, 0, z + 0.9), (2, 2, 0.98)))
    berries = [ball((0.04, -0.1, z + tall * 1.14), 0.19)]
    for lift, count, first in ((48, 5, 20), (14, 7, 50)):
        a = math.radians(lift)
        at = (dome * 0.96 * math.cos(a), 0, z + tall * 1.16 * math.sin(a))
        berries.append(around(count, ball(at, 0.18), first))
    return {
        "top": join(top, ring((0, 0, z + 0.02), dome - 0.16, 0.17)),
        "cup": join(cup, around(14, pleat)),
        "berries": join(*berries),
    }


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


def waffle(draw: Draw) -> Parts:
    """Square, with a grid of ridges, butter and syrup on it."""
    x, z, ridge = draw(1.05, 1.15), draw(0.13, 0.16), draw(0.085, 0.1)
    butter, pool, high = draw(0.27, 0.32), draw(0.52, 0.62), draw(0.1, 0.14)
    rise, count = 0.09, 4
    top = 2 * z
    lines = [x * 0.92 * (2 * k / count - 1) for k in range(count + 1)]
    bars = [box((u, 0, z + rise / 2), (ridge, x, z + rise / 2), 0.02) for u in lines]
    puddle = [
        (
            pool * (1 + 0.2 * math.sin(4 * a)) * math.cos(a),
            pool * (1 + 0.2 * math.sin(4 * a)) * math.sin(a),
        )
        for a in (math.tau * k / 40 for k in range(40))
    ]
    level = top + rise
    return {
        "body": box((0, 0, z), (x * 0.98, x * 0.98, z), 0.03),
        "ridges": join(*bars, *(turned(bar, 2, 90) for bar in bars)),
        "syrup": prism(puddle, 2, 0.09, level - 0.02),
        "butter": box((0, 0, level + high), (butter, butter, high), 0.05),
    }


def _wound(t: float, aside: float) -> tuple[float, float]:
    """At ``t`` turns of a roll's spiral, so far outwards of it; its last bit is tucked in."""
    tuck = max(0.0, t - 1.9) / 0.25
    r = 0.14 + 0.48 * t - 0.2 * tuck * tuck + aside * (1 - 0.4 * min(1.0, tuck))
    a = math.tau * t + 1.2
    return r * math.cos(a), r * math.sin(a)


def _band(first: float, last: float, middle: float, half: float) -> list[tuple[float, float]]:
    """The outline of a band that is wound from ``first`` to ``last`` turns."""
    stops = [first + (last - first) * k / 48 for k in range(49)]
    outside = [_wound(t, middle + half) for t in stops]
    return [*outside, *(_wound(t, middle - half) for t in reversed(stops))]


def cinnamon_roll(draw: Draw) -> Parts:
    """A bun wound in a spiral, dark cinnamon between its turns, white icing that runs down it."""
    high, half = draw(0.82, 0.9), draw(0.14, 0.15)

    def wound(band: list[tuple[float, float]], top: float, thick: float, soft: float) -> Solid:
        """``thick`` from the top down, its edges round."""
        return grown(prism(band, 2, thick / 2 - soft, top - thick / 2), soft)

    def drip(turns: float, low: float) -> Solid:
        u, v = _wound(turns, half - 0.01)
        return capsule((u, v, high + 0.02), (u, v, low), 0.12)

    drips = [(1.2, 0.36), (1.36, 0.54), (1.52, 0.3), (1.68, 0.5), (1.84, 0.38)]
    return {
        "bun": join(
            wound(_band(0, 2.15, 0, half - 0.07), high, high, 0.07),
            tube((0, 0, 0), (0, 0, high - 0.04), 0.2, 0.04),
        ),
        "cinnamon": prism(
            _band(0.3, 2.1, -0.24, 0.16), 2, (high - 0.2) / 2, (high - 0.2) / 2 + 0.04
        ),
        "icing": join(
            wound(_band(0, 1.96, 0, half - 0.11), high + 0.1, 0.26, 0.09),
            ball((0.02, 0.02, high - 0.04), 0.2),
            *(drip(turns, low) for turns, low in drips),
        ),
    }


def donut(draw: Draw) -> Parts:
    """A ring that lies flat, icing that runs down its sides, sprinkles of three colours."""
    major, minor = draw(0.66, 0.72), draw(0.38, 0.42)
    layout, runs = draw.arranged(3), 7 + 2 * draw.chance(0.5)
    z = minor
    drip = tube((major + minor, 0, z - draw(0.06, 0.12)), (major + minor, 0, z + 0.4), 0.16, 0.1)
    inner = tube((0, 0, z - 0.1), (0, 0, 2), major - minor * 0.5)
    area = join(box((0, 0, z + 1.14), (2, 2, 1)), around(runs, drip), inner)
    groups: list[list[Solid]] = [[], [], []]
    for k in range(21):
        a, t = math.tau * (k + layout(-0.25, 0.25)) / 21, math.radians((58, 93, 128)[k % 3])
        lean, out = layout(0, math.pi), minor + 0.07
        r, up = major + out * math.cos(t), z + out * math.sin(t)
        # Half a sprinkle: around the axis, and across the ring.
        s, c = 0.09 * math.sin(lean), 0.09 * math.cos(lean)
        ends = [((r - f * c * math.sin(t)), f * s, up + f * c * math.cos(t)) for f in (-1, 1)]
        ca, sa = math.cos(a), math.sin(a)
        start, end = ((x * ca - y * sa, x * sa + y * ca, h) for x, y, h in ends)
        groups[(k + k // 3) % 3].append(capsule(start, end, 0.073))
    return {
        "dough": ring((0, 0, z), major, minor),
        "icing": within(ring((0, 0, z), major, minor + 0.06), area),
        **{n: join(*s) for n, s in zip(("sprinkles", "strands", "drops"), groups, strict=True)},
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


def gingerbread_man(draw: Draw) -> Parts:
    """A flat one that stands, its face, buttons and cuffs of icing."""
    y, head, limb = draw(0.17, 0.2), draw(0.42, 0.47), draw(0.23, 0.26)
    reach, apart, high = draw(0.78, 0.88), draw(0.42, 0.5), draw(1.0, 1.08)
    top = high + 0.28 + head * 0.8
    hand, foot = (reach, 0, high + 0.02), (apart, 0, limb)
    shoulder, hip = (0.12, 0, high + 0.06), (0.16, 0, 0.7)
    plump = join(
        ball((0, 0, top), head),
        taper((0, 0, 0.72), (0, 0, high), 0.36, 0.32),
        both(join(capsule(shoulder, hand, limb), capsule(hip, foot, limb + 0.02))),
    )
    front, thick = -y - 0.01, 0.07

    def cuff(at: tuple[float, float], lean: tuple[float, float]) -> Solid:
        (x, z), (u, w) = at, lean
        return capsule((x - u, front, z - w), (x + u, front, z + w), thick)

    smile = [
        (head * 0.5 * math.sin(a), front, top - head * 0.5 * math.cos(a) - 0.06)
        for a in (-0.9, -0.3, 0.3, 0.9)
    ]
    mouth = join(*(capsule(a, b, 0.065) for a, b in itertools.pairwise(smile)))
    cuffs = join(
        cuff((reach - 0.06, high + 0.02), (0, limb - 0.05)),
        cuff((apart - 0.06, limb + 0.14), (limb - 0.04, 0.08)),
    )
    bow = prism([(0.02, top - head), (0.24, top - head + 0.14), (0.24, top - head - 0.14)], 1, 0.1)
    return {
        "body": within(plump, box((0, 0, 1), (2, y, 2))),
        "icing": join(both(cuffs), mouth),
        "eyes": both(ball((head * 0.38, front, top + 0.14), 0.085)),
        "buttons": join(*(ball((0, front, z), 0.095) for z in (0.66, 0.9))),
        "bow": moved(join(both(bow), ball((0, 0, top - head), 0.1)), (0, front, 0)),
    }


BREAD_AND_CAKES = {
    "bread": bread,
    "croissant": croissant,
    "pretzel": pretzel,
    "cake": cake,
    "cupcake": cupcake,
    "muffin": muffin,
    "pie": pie,
    "pancakes": pancakes,
    "waffle": waffle,
    "cinnamon roll": cinnamon_roll,
    "donut": donut,
    "cookie": cookie,
    "gingerbread man": gingerbread_man,
}
