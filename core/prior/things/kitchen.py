"""What is baked, fried, cooked and served."""

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
    within,
)


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


def teacup(draw: Draw) -> Parts:
    """A wide cup of tea with an ear, on a saucer, both with a rim of gold."""
    wide, high, foot = draw(0.68, 0.76), draw(0.78, 0.9), draw(0.3, 0.36)
    plate, wall, low = draw(1.0, 1.1), 0.08, 0.22
    top = low + high
    curve = smooth_curve([(foot, low + 0.04), (wide * 0.8, low + 0.28), (wide, top)])
    hollow = [(max(r - wall, 0.02), z + (0.1 if z < low + 0.12 else 0.0)) for r, z in curve]
    inside = lathe([*hollow, (wide - wall + 0.02, top + 0.2)])
    dish = [(0.42, 0.0), (0.46, 0.04), (plate * 0.7, 0.1), (plate, 0.22)]
    upper = [(plate, 0.32), (plate * 0.7, 0.2), (0.36, 0.16)]
    ear = join(
        ring((wide * 0.96, 0, low + high * 0.6), draw(0.27, 0.31), 0.085, axis=1),
        box((wide * 0.86, 0, low + high * 0.6), (0.05, 0.07, 0.3), 0.02),
    )
    level = top - 0.14
    parts = {
        "cup": cut(lathe([(foot, 0.14), *curve], 0.01), inside),
        "saucer": lathe([(0.0, 0.0), *dish, *upper, (0.0, 0.16)], 0.02),
        "tea": within(tube((0, 0, level - 0.14), (0, 0, level), wide), grown(inside, 0.02)),
        "rim": ring((0, 0, top), wide - wall / 2, 0.07),
    }
    return parts | ({"handle": cut(ear, inside)} if draw.has("handle", 1.0) else {})


def cooking_pot(draw: Draw) -> Parts:
    """A wide pot with an ear at either side, and its lid with a knob."""
    r, high, ear = draw(0.74, 0.82), draw(0.82, 0.98), draw(0.2, 0.24)
    dome, z = draw(0.2, 0.27), high * 0.72
    lid = smooth_curve([(r - 0.02, high + 0.06), (r * 0.62, high + dome * 0.8), (0.0, high + dome)])
    knob = high + dome
    out = r + ear
    loop = join(
        capsule((r - 0.05, -ear, z), (out, -ear, z), 0.08),
        capsule((out, -ear, z), (out, ear, z), 0.08),
        capsule((r - 0.05, ear, z), (out, ear, z), 0.08),
    )
    return {
        "body": tube((0, 0, 0), (0, 0, high), r, 0.06),
        "rim": tube((0, 0, high - 0.05), (0, 0, high + 0.09), r + 0.06, 0.03),
        "handles": both(loop),
        "lid": lathe(lid, 0.02),
        "knob": join(
            tube((0, 0, knob - 0.1), (0, 0, knob + 0.14), 0.1),
            egg((0, 0, knob + 0.2), (0.19, 0.19, 0.11)),
        ),
    }


KITCHEN = {
    "donut": donut,
    "gingerbread man": gingerbread_man,
    "watermelon slice": watermelon_slice,
    "fried egg": fried_egg,
    "teacup": teacup,
    "cooking pot": cooking_pot,
}
