"""Sweets, meat and fruit."""

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
    egg,
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
)


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


def tomato(draw: Draw) -> Parts:
    """Squat and round, a green star about its stalk."""
    r, half, reach = draw(0.92, 1.05), draw(0.68, 0.8), draw(0.52, 0.66)
    width, stalk, droop = draw(0.12, 0.15), draw(0.24, 0.36), draw(0.0, 0.08)
    top = 2 * half
    leaf = taper((0.08, 0, top), (reach, 0, top - droop), width, 0.075)
    return {
        "body": egg((0, 0, half), (r, r, half)),
        "leaves": around(5, leaf, 18),
        "stalk": taper((0, 0, top - 0.1), (0, 0, top + stalk), 0.14, 0.1),
    }


def orange(draw: Draw) -> Parts:
    """A whole one, and a half before it that shows its segments."""
    r, half, lean = draw(0.74, 0.8), draw(0.62, 0.68), draw(38, 46)
    y, share, gap = draw(0.46, 0.52), draw(0.83, 0.86), 8
    pith, leaf = half * 0.93, draw(0.4, 0.48)
    # Segments: sectors of the disc, apart from one another.
    inner, wide = half * 0.14, math.pi / 8
    edge = half * share
    arc = [wide * (0.74 * k / 3) for k in range(-3, 4)]
    wedge = [(inner, 0.0), *((edge * math.cos(a), edge * math.sin(a)) for a in arc)]
    # Made with its cut face up, then turned to the front.
    bowl = cut(ball((0, 0, 0), half), box((0, 0, 1), (1, 1, 1)))

    def laid(solid: Solid) -> Solid:
        return tilted(solid, lean + gap, (0, -0.58, half * 0.86))

    blade = [(0.0, 0.0), (leaf * 0.4, 0.15), (leaf, 0.0), (leaf * 0.4, -0.15)]
    return {
        "body": join(ball((0, y, r), r), laid(bowl)),
        "pith": laid(tube((0, 0, -0.1), (0, 0, 0.025), pith)),
        "flesh": laid(around(8, prism(wedge, 2, 0.08), 22.5)),
        "stalk": tube((0, y, 2 * r - 0.1), (0, y, 2 * r + 0.1), 0.1, 0.02),
        "leaf": moved(turned(prism(smooth_curve(blade), 2, 0.075), 1, -14), (0, y, 2 * r + 0.04)),
    }


def coconut(draw: Draw) -> Parts:
    """A whole one with its three eyes, and a half before it with white flesh and water."""
    r, half, lean = draw(0.76, 0.84), draw(0.66, 0.72), draw(26, 36)
    y, white, hollow = draw(0.5, 0.56), draw(0.86, 0.89), draw(0.6, 0.66)
    z = r
    c = half * hollow
    upper, hole = box((0, 0, 1.03), (1, 1, 1)), ball((0, 0, 0.05), c)
    shell = cut(ball((0, 0, 0), half), box((0, 0, 1), (1, 1, 1)), hole)

    def laid(solid: Solid) -> Solid:
        return tilted(solid, lean, (0, -0.56, half * 0.95))

    eye = ball((0, 0, r - 0.03), 0.12)
    eyes = [turned(turned(eye, 0, 15), 2, 120 * k) for k in range(3)]
    meat = cut(ball((0, 0, 0), half * white), upper, hole)
    return {
        "shell": join(ball((0, y, z), r), laid(shell)),
        "flesh": laid(meat),
        "water": laid(cut(ball((0, 0, 0.05), c + 0.02), box((0, 0, 0.92), (1, 1, 1)))),
        "eyes": tilted(join(*eyes), 30, (0, y, z)),
    }


def steak(draw: Draw) -> Parts:
    """A T-bone steak that lies flat: a rim of fat, marks of the grill."""
    long, wide, z = draw(1.1, 1.22), draw(0.85, 0.95), draw(0.2, 0.25)
    tail, rim, bone = draw(0.45, 0.55), draw(0.88, 0.91), draw(0.11, 0.13)
    right = [(0.0, long * 0.86), (wide * 0.5, long * 0.95), (wide, long * 0.5), (wide * 0.85, -0.1)]
    right += [(wide * tail, -long * 0.75), (0.0, -long)]
    edge = smooth_curve(right)
    outline = edge + [(-x, y) for x, y in edge[-2:0:-1]]
    inner = [(x * rim, y * rim) for x, y in outline]
    high = 2 * z
    marks = [
        turned(box((s, -0.05, high + 0.03), (0.07, length, 0.05)), 2, -32)
        for s, length in ((-0.42, 0.3), (0.0, 0.55), (0.42, 0.3))
    ]
    cross = box((0, long * 0.62, z + 0.02), (wide * 0.62, bone, z + 0.03), 0.02)
    stem = prism(
        [(-bone, long * 0.6), (bone, long * 0.6), (bone * 0.75, -0.35), (-bone * 0.75, -0.35)],
        2,
        z + 0.025,
        z + 0.025,
    )
    return {
        "fat": prism(outline, 2, z * 0.6, z),
        "meat": prism(inner, 2, z + 0.02, z + 0.02),
        "bone": join(cross, stem),
        "marks": join(*marks),
    }


def chicken_drumstick(draw: Draw) -> Parts:
    """Roasted, on its thick end, two knobs at the end of its bone."""
    r, high, neck = draw(0.66, 0.75), draw(1.5, 1.7), draw(0.2, 0.24)
    bone, knob, long = draw(0.14, 0.16), draw(0.2, 0.24), draw(0.42, 0.52)
    side = [(0.0, 0.0), (r * 0.7, 0.1), (r, high * 0.32), (r * 0.86, high * 0.58)]
    side += [(neck + 0.08, high * 0.9), (neck, high)]
    top = high + long
    return {
        "meat": lathe(smooth_curve(side), 0.01),
        "bone": join(
            tube((0, 0, high - 0.2), (0, 0, top + 0.05), bone),
            both(ball((knob * 0.68, 0, top + knob * 0.4), knob)),
        ),
        "cuff": ring((0, 0, high - 0.02), neck - 0.02, 0.1),
    }


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


def bubble_tea(draw: Draw) -> Parts:
    """A tapered cup of milk tea, tapioca pearls about its foot, a lid and a straw that leans."""
    foot, r, high = draw(0.46, 0.5), draw(0.64, 0.7), draw(1.44, 1.56)
    pearl, lean, tall = draw(0.14, 0.15), draw(12, 16), draw(2.62, 2.78)

    def row(z: float, count: int, first_deg: float) -> Solid:
        out = foot + (r - foot) * z / high - 0.03
        return around(count, ball((out, 0, z), pearl), first_deg)

    if draw.chance(0.5):
        top = high + 0.46
        cap = [(r, high), *((r * 0.94 * math.cos(a / 10), high + 0.06 + 0.44 * math.sin(a / 10))
                            for a in range(14))]  # fmt: skip
    else:
        top = high + 0.36
        cap = [(r - 0.06, high), (r - 0.06, high + 0.2), (r - 0.24, high + 0.24), (r - 0.28, top)]
    straw = cut(
        tube((0, 0, -0.7), (0, 0, tall - top), 0.12),
        moved(turned(box((0, 0, 1), (1, 1, 1)), 1, 35), (0, 0, tall - top - 0.1)),
    )
    return {
        "tea": lathe([(foot - 0.04, 0), (foot, 0.06), (r, high + 0.02)]),
        "pearls": join(row(0.22, 7, 0), row(0.52, 7, 180 / 7), row(0.82, 3, 50)),
        "lid": lathe(cap),
        "straw": moved(turned(straw, 1, lean), (0.08, 0, top)),
        "rim": ring((0, 0, high), r - 0.01, 0.1),
    }


TREATS = {
    "candy cane": candy_cane,
    "sundae": sundae,
    "tomato": tomato,
    "orange fruit": orange,
    "coconut": coconut,
    "steak": steak,
    "chicken drumstick": chicken_drumstick,
    "waffle": waffle,
    "bubble tea": bubble_tea,
}
