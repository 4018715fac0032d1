"""Sweets, ice cream and snacks."""

import math
from itertools import pairwise

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
    join,
    lathe,
    moved,
    prism,
    ring,
    smooth_curve,
    taper,
    tilted,
    tube,
    turned,
    within,
)
from core.prior.things.shared.ropes import bent


def candy_cane(draw: Draw) -> Parts:
    """A striped staff with a crook to one side."""
    r, bow, high = draw(0.17, 0.2), draw(0.42, 0.5), draw(1.55, 1.75)
    end, step = draw(0.26, 0.36), 0.4
    shift = bow
    # From the foot up, over the bow, and down: the way s along the middle line.
    half = math.pi * bow
    total = high + half + end

    def at(s: float) -> tuple[float, float, float]:
        if s < high:
            return (shift, 0, s)
        if s > high + half:
            return (-2 * bow + shift, 0, high - (s - high - half))
        turn = (s - high) / bow
        return (shift - bow + bow * math.cos(turn), 0, high + bow * math.sin(turn))

    bars, s = [], step * 0.6
    while s < total - 0.12:
        bars.append(tube(at(s - step / 4), at(s + step / 4), r + 0.025))
        s += step
    stops = [at(high + half * k / 8) for k in range(9)]
    bend = [capsule(a, b, r) for a, b in pairwise(stops)]
    return {
        "candy": join(
            tube((shift, 0, 0), (shift, 0, high), r, 0.05), *bend, capsule(stops[-1], at(total), r)
        ),
        "stripes": join(*bars),
    }


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


def chocolate_bar(draw: Draw) -> Parts:
    """Upright: squares above, the lower half in foil and paper with a label."""
    columns = 3
    w, h, deep = draw(0.25, 0.29), draw(0.29, 0.33), draw(0.14, 0.18)
    rows, x = 3, columns * w
    fold = draw(0.85, 1.0)
    long = fold + 0.12 + rows * 2 * h
    blocks = []
    for i in range(columns):
        for k in range(rows):
            u, v = (2 * i - columns + 1) * w, fold + 0.12 + (2 * k + 1) * h
            blocks.append(
                join(
                    box((u, -deep, v), (w - 0.06, 0.07, h - 0.06), 0.03),
                    box((u, -deep - 0.06, v), (w - 0.12, 0.06, h - 0.12), 0.03),
                )
            )
    torn = [(-x - 0.06, fold - 0.2), (x + 0.06, fold - 0.2)]
    torn += [
        (x + 0.06 - k * (2 * x + 0.12) / 6, fold + (0.22 if k % 2 else 0.06)) for k in range(7)
    ]
    return {
        "chocolate": box((0, 0, long / 2), (x, deep, long / 2), 0.02),
        "squares": join(*blocks),
        "foil": prism(torn, 1, deep + 0.14),
        "wrapper": box((0, 0, fold / 2), (x + 0.1, deep + 0.18, fold / 2), 0.03),
        "label": box((0, -deep - 0.18, fold / 2), (x * 0.78, 0.05, fold * 0.26), 0.02),
        "bands": join(
            *(box((0, -deep - 0.16, fold / 2 + s * fold * 0.4), (x + 0.11, 0.06, 0.06), 0.02)
              for s in (-1, 1)),
        ),
    }  # fmt: skip


def ice_cream(draw: Draw) -> Parts:
    """One or two scoops in a wafer cone, sometimes with a cherry."""
    wide, high, scoop = draw(0.5, 0.58), draw(1.25, 1.5), draw(0.56, 0.66)
    z = high + scoop * 0.45
    scoops = [ball((0, 0, z), scoop), around(9, ball((scoop * 0.92, 0, z - scoop * 0.38), 0.15))]
    if draw.chance(0.45):
        z += scoop * 1.05
        scoops.append(ball((0, 0, z), scoop * 0.82))
        scoop *= 0.82
    parts = {"scoop": join(*scoops), "cone": lathe([(0.05, 0), (wide, high)], 0.04)}
    return parts | {"cherry": ball((0, 0, z + scoop + 0.07), 0.17)}


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


def sundae(draw: Draw) -> Parts:
    """Three scoops in a glass on a foot, with sauce, a cherry and a wafer."""
    r, bowl, scoop = draw(0.68, 0.76), draw(0.75, 0.88), draw(0.37, 0.42)
    stem, foot, tall = draw(0.3, 0.4), draw(0.46, 0.54), draw(0.5, 0.62)
    low, top = stem + 0.1, stem + 0.1 + bowl
    shell = smooth_curve([(0.14, low), (r * 0.7, low + bowl * 0.4), (r, top)])
    x, y = scoop * 0.86, scoop * 0.3
    peak = top + scoop * 1.35
    head = ball((0, 0, peak), scoop)
    # A cap of sauce that runs down in three tongues.
    runs = [
        capsule(
            (scoop * 0.9 * math.sin(a), -scoop * 0.9 * math.cos(a), peak + 0.12),
            (scoop * 1.03 * math.sin(a), -scoop * 1.03 * math.cos(a), peak - down),
            0.1,
        )
        for a, down in ((-0.95, 0.02), (0.0, 0.14), (0.95, 0.02), (2.3, 0.08), (3.98, 0.08))
    ]
    cap = cut(ball((0, 0, peak), scoop + 0.06), box((0, 0, peak - 1 + 0.12), (1, 1, 1)))
    wafer = turned(box((0, 0, tall / 2), (0.1, 0.1, tall / 2), 0.02), 1, 24)
    return {
        "glass": join(
            lathe([(foot, 0), (foot, 0.07), (0.13, 0.2), (0.13, low + 0.02)], 0.015),
            lathe(shell, 0.01),
            ring((0, 0, top), r, 0.085),
        ),
        "scoops": join(
            both(ball((x, -y, top + 0.1), scoop)), ball((0, y * 2, top + 0.1), scoop), head
        ),
        "sauce": join(cap, *runs),
        "cherry": ball((0, -0.05, peak + scoop + 0.14), draw(0.16, 0.19)),
        "wafer": moved(wafer, (scoop * 0.6, 0.25, peak)),
    }


def popcorn(draw: Draw) -> Parts:
    """A striped box, wider at its top, heaped with popcorn."""
    low, wide, high = draw(0.46, 0.54), draw(0.72, 0.82), draw(1.2, 1.45)
    heap = draw.arranged()

    def flared(out: float) -> Solid:
        side = [(-low - out, 0.0), (low + out, 0.0), (wide + out, high), (-wide - out, high)]
        return within(prism(side, 1, 2), prism(side, 0, 2))

    slabs = [
        both(prism([(x * low - 0.07, 0), (x * low + 0.07, 0), (x * wide + 0.13, high + 0.1),
                    (x * wide - 0.13, high + 0.1)], axis, 2), 0, 1)
        for axis in (0, 1) for x in (0.0, 0.74)
    ]  # fmt: skip
    corn = [ball((0, 0, high - 0.06), 0.6)]
    yellow = []
    for count, r, lift in ((8, wide * 0.8, 0.06), (6, wide * 0.5, 0.28), (3, wide * 0.18, 0.48)):
        for k in range(count):
            turn = math.radians(360 * k / count + heap(-10, 10) + 20 * lift)
            spot = (r * math.cos(turn), r * math.sin(turn), high + lift + heap(-0.04, 0.06))
            size = heap(0.2, 0.25)
            corn.append(ball(spot, size))
            top = (spot[0] * 1.1, spot[1] * 1.1, spot[2] + size * 0.75)
            yellow.append(ball(top, 0.11))
    shell = within(flared(0.04), join(*slabs))
    front = (low + wide) / 2
    return {
        "box": flared(0.0),
        "stripes": shell,
        "popcorn": join(*corn),
        "butter": join(*yellow),
        "badge": tilted(
            turned(tube((0, 0, -0.08), (0, 0, 0.08), 0.36), 0, 90), 0, (0, -front - 0.02, high / 2)
        ),
    }


def watermelon_slice(draw: Draw) -> Parts:
    """Half a disc that stands on its rind, seeds on both sides."""
    r, y, layout = draw(1.1, 1.2), draw(0.26, 0.32), draw.arranged(2)
    rind, pith = 0.16, 0.145
    z = r

    def half(radius: float) -> Solid:
        return cut(tube((0, -y, z), (0, y, z), radius), box((0, 0, z + 2), (2, 2, 2)))

    seeds = []
    for count, share in ((5, 0.56), (2, 0.24)):
        for k in range(count):
            a = math.pi * (k + 0.5) / count + layout(-0.07, 0.07)
            at, s = share * r, math.sin(a)
            x, h = at * math.cos(a), z - at * s - 0.03
            low, up = (x, y, h - 0.05), (x * 0.93, y, h + 0.09)
            seeds.append(both(taper(low, up, 0.085, 0.04), 1))
    flesh = r - rind - pith
    return {
        "flesh": half(flesh),
        "pith": cut(half(flesh + pith), tube((0, -1, z), (0, 1, z), flesh)),
        "rind": cut(half(r), tube((0, -1, z), (0, 1, z), flesh + pith)),
        "seeds": join(*seeds),
    }


SWEETS = {
    "candy cane": candy_cane,
    "lollipop": lollipop,
    "chocolate bar": chocolate_bar,
    "ice cream": ice_cream,
    "popsicle": popsicle,
    "sundae": sundae,
    "popcorn": popcorn,
    "watermelon slice": watermelon_slice,
}
