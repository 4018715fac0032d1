"""Bridges, gates, stairs, walls, a column and a fountain."""

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
    join,
    lathe,
    prism,
    ring,
    smooth_curve,
    taper,
    tube,
    turned,
)


def column(draw: Draw) -> Parts:
    """A fluted shaft on a round base; a plain, a scrolled or a leafy capital."""
    high, r, kind = draw(2.1, 2.5), draw(0.34, 0.42), draw.which(3)
    low, up, slim = 0.46, high - 0.5, r * draw(0.82, 0.9)
    wide = r * 1.5
    flute = capsule((r + 0.035, 0, low + 0.22), (slim + 0.035, 0, up - 0.12), 0.092)
    shaft = lathe(smooth_curve([(r, low - 0.1), (r * 0.99, (low + up) / 2), (slim, up + 0.1)]))
    square = box((0, 0, 0.11), (wide, wide, 0.11), 0.01)
    bell = [(slim, up), (slim + 0.02, up + 0.1), (wide - 0.08, up + 0.32), (wide - 0.08, up + 0.4)]
    scroll = tube((wide - 0.06, -r * 1.14, up + 0.2), (wide - 0.06, r * 1.14, up + 0.2), 0.22, 0.03)
    eye = tube(
        (wide - 0.06, -r * 1.14 - 0.05, up + 0.2), (wide - 0.06, r * 1.2, up + 0.2), 0.09, 0.02
    )
    pad = box((0, 0, up + 0.28), (wide - 0.1, r * 1.04, 0.1), 0.03)
    # A leaf stands against the bell, its tip rolled outwards.
    roll = slim + 0.2, up + 0.27
    tip = capsule((roll[0], -0.07, roll[1]), (roll[0], 0.07, roll[1]), 0.09)
    leaf = join(egg((slim + 0.05, 0, up + 0.1), (0.12, 0.18, 0.26)), tip)
    fancy = {
        0: ring((0, 0, up - 0.1), slim + 0.02, 0.075),
        1: both(eye),
        2: around(8, leaf),
    }
    return {
        "shaft": cut(shaft, around(12, flute)),
        "base": join(square, ring((0, 0, 0.32), r + 0.05, 0.12)),
        "capital": join(pad, both(scroll)) if kind == 1 else lathe(bell, 0.02),
        "slab": box((0, 0, high - 0.03), (wide, wide, 0.09), 0.01),
        "rings": join(*(ring((0, 0, h), q, 0.08) for h, q in ((low, r), (up, slim)))),
        "ornament": fancy[kind],
    }


def arch(draw: Draw) -> Parts:
    """A gate of stone."""
    x, y, gap, top = draw(0.9, 1.05), draw(0.28, 0.38), draw(0.44, 0.52), draw(1.7, 1.95)
    spring = draw(0.75, 0.95)
    opening = join(tube((0, -1, spring), (0, 1, spring), gap), box((0, 0, spring - 2), (gap, 1, 2)))
    plinth = both(box(((gap + x) / 2 + 0.02, 0, 0.13), ((x - gap) / 2 + 0.1, y + 0.1, 0.13), 0.02))
    return {
        "body": cut(box((0, 0, top / 2), (x, y, top / 2), 0.02), opening),
        "cornice": join(box((0, 0, top), (x + 0.13, y + 0.12, 0.12), 0.02), plinth),
    }


def gate(draw: Draw) -> Parts:
    """Two wings of bars between stone piers with caps."""
    x, high, bar = draw(0.98, 1.1), draw(1.3, 1.5), 0.075
    pier, tall = draw(0.17, 0.2), high * draw(1.0, 1.1)
    arch, tip = draw(0.1, 0.24) * draw.chance(0.5), 0.13
    bars, tips = [], []
    for k in range(3):
        u = x * (0.16 + k * 0.3)
        z = high * 0.9 + arch * (1 - u / x)
        bars.append(box((u, 0, z / 2 + 0.04), (bar, bar, z / 2 - 0.04)))
        tips.append(ball((u, 0, z + 0.06), tip))
    beams = [box((x / 2, 0, z), (x / 2, 0.08, 0.08)) for z in (0.22, high * 0.76)]
    cap = join(
        box((x + pier, 0, tall), (pier + 0.08, pier + 0.08, 0.08)),
        ball((x + pier, 0, tall + 0.22), 0.18),
    )
    return {
        "bars": both(join(*bars, *beams)),
        "tips": both(join(*tips)),
        "piers": both(box((x + pier, 0, tall / 2), (pier, pier, tall / 2))),
        "caps": both(cap),
    }


def torii_gate(draw: Draw) -> Parts:
    """Two red pillars that lean inwards, a curved red lintel under a black one, a second beam."""
    x, high, r = draw(0.8, 0.86), draw(1.9, 2.0), draw(0.165, 0.175)
    reach, rise = draw(1.42, 1.48), draw(0.24, 0.28)
    us = [k / 6 - 1 for k in range(13)]

    def beam(low: float, tall: float, half: float, span: float) -> Solid:
        """Curved upwards to its ends, from ``low`` in the middle."""
        under = [(span * u, low + rise * abs(u) ** 2.4) for u in us]
        over = [(span * u * 1.04, low + tall + rise * abs(u) ** 2.4) for u in us[::-1]]
        return prism([*under, *over], 1, half)

    return {
        "pillars": join(
            both(tube((x, 0, 0), (x - 0.08, 0, high + 0.1), r, 0.01)),
            box((0, 0, high * 0.76), (x + 0.36, 0.1, 0.1)),
            beam(high - 0.06, 0.2, 0.16, reach - 0.1),
            box((0, 0, high * 0.9), (0.09, 0.09, high * 0.16)),
        ),
        "lintel": beam(high + 0.1, 0.17, 0.22, reach),
        "feet": both(join(
            tube((x, 0, 0), (x, 0, 0.24), r + 0.1, 0.03),
            box((x, 0, 0.02), (r + 0.2, r + 0.2, 0.08), 0.02),
        )),
        "plaque": box((0, 0, high * 0.885), (0.16, 0.17, 0.17), 0.02),
    }  # fmt: skip


def wall(draw: Draw) -> Parts:
    """A straight garden wall between two piers: blocks along its top, a ball on each pier."""
    x, y, high = draw(1.08, 1.18), draw(0.18, 0.23), draw(0.92, 1.1)
    pier, more, cap = draw(0.26, 0.31), draw(0.38, 0.46), 0.1
    top, step = high + more, (x - pier) * 2 / 3
    block = (step / 2 - 0.08, y + 0.1, cap)
    return {
        "body": box((0, 0, high / 2), (x, y, high / 2)),
        "piers": both(box((x, 0, top / 2), (pier, pier, top / 2))),
        "cap": join(
            box((0, 0, high), block, 0.02),
            both(box((step, 0, high), block, 0.02)),
            both(box((x, 0, top), (pier + 0.1, pier + 0.1, cap), 0.02)),
            both(ball((x, 0, top + 0.24), 0.21)),
        ),
        "base": join(
            box((0, 0, 0.12), (x, y + 0.1, 0.12)),
            both(box((x, 0, 0.12), (pier + 0.1, pier + 0.1, 0.12))),
        ),
    }


def bridge(draw: Draw) -> Parts:
    """Of stone, along x, its road over one arch or two."""
    long, y, low, hump = 1.5, draw(0.38, 0.5), draw(0.68, 0.8), draw(0.18, 0.36)
    xs = [long * (k / 6 - 1) for k in range(13)]
    rise = [low + hump * math.cos(x / long * math.pi / 2) for x in xs]
    top = list(zip(xs, rise, strict=True))
    count = 1 + draw.which(2)
    spans = (((0.0, 0.8),), ((-0.62, 0.48), (0.62, 0.48)))
    # One span is a flat arch: the middle of its circle is below the ground.
    down = 0.16 if count == 1 else 0.0
    holes = [
        tube((x, -1, r * 0.15 - down), (x, 1, r * 0.15 - down), r + down / 2)
        for x, r in spans[count - 1]
    ]
    wall = [*((x, z - 0.05) for x, z in top), *((x, z + 0.2) for x, z in reversed(top))]
    posts = box((long - 0.1, y - 0.09, low / 2 + 0.16), (0.14, 0.15, low / 2 + 0.16), 0.02)
    return {
        "body": cut(prism([*top, (long, 0), (-long, 0)], 1, y), *holes),
        "walls": join(*(prism(wall, 1, 0.1, side * (y - 0.07)) for side in (-1, 1))),
        "road": prism(
            [*((x, z - 0.1) for x, z in top), *((x, z + 0.03) for x, z in top[::-1])], 1, y - 0.1
        ),
        "posts": both(posts, 0, 1),
    }


def fountain(draw: Draw) -> Parts:
    """A round pool with a column, a bowl on it, and water that falls from its rim."""
    r, rim, bowl, high = draw(1.1, 1.3), draw(0.34, 0.42), draw(0.56, 0.68), draw(1.1, 1.3)
    side = smooth_curve([(r * 0.9, 0.1), (r, rim * 0.6), (r * 0.98, rim)])
    shell = smooth_curve([(0.2, high - 0.3), (bowl * 0.72, high - 0.18), (bowl, high + 0.08)])
    out = bowl + draw(0.06, 0.16)
    fall = join(
        capsule((bowl - 0.12, 0, high + 0.06), (out, 0, high + 0.02), 0.08),
        capsule((out, 0, high + 0.02), (out + 0.08, 0, high - 0.2), 0.08),
        capsule((out + 0.08, 0, high - 0.2), (out + 0.12, 0, rim - 0.1), 0.08),
    )
    jet = taper((0, 0, high), (0, 0, high + draw(0.4, 0.6)), 0.17, 0.09)
    return {
        "basin": join(
            cut(lathe([(r * 0.9, 0), *side], 0.03), tube((0, 0, rim - 0.16), (0, 0, 3), r - 0.17)),
            tube((0, 0, 0), (0, 0, 0.13), r * 1.06, 0.03),
        ),
        "column": lathe([(0.34, 0.1), (0.3, 0.4), (0.17, 0.62), (0.16, high)], 0.02),
        "bowl": lathe(shell, 0.03),
        "water": join(
            tube((0, 0, 0.14), (0, 0, rim - 0.07), r - 0.1),
            tube((0, 0, high - 0.06), (0, 0, high + 0.11), bowl - 0.09),
            around(5 + draw.chance(0.5), fall, 20),
            jet,
        ),
    }


def staircase(draw: Draw) -> Parts:
    """Six steps that rise to the back, with treads, and a handrail on either side."""
    x, run, rise, rail = draw(0.58, 0.7), draw(0.34, 0.38), draw(0.24, 0.29), draw(0.6, 0.7)
    count, thick = 6, 0.11
    front = -run * count / 2
    side, treads = [(front, 0.0)], []
    for k in range(count):
        y, z = front + run * k, rise * (k + 1)
        side += [(y, z - 0.04), (y + run, z - 0.04)]
        treads.append(box((0, y + run / 2 - 0.03, z - 0.03), (x + 0.05, run / 2 + 0.03, 0.055)))
    low, last = (front + run / 2, rise), (front + run * (count - 0.5), rise * count)
    posts = [box((x - 0.09, y, z + rail / 2), (0.09, 0.09, rail / 2)) for y, z in (low, last)]
    middle = ((low[0] + last[0]) / 2, (low[1] + last[1]) / 2)
    posts.append(box((x - 0.09, middle[0], middle[1] + rail / 2), (0.07, 0.07, rail / 2)))
    knobs = [ball((x - 0.09, y, z + rail + 0.14), 0.14) for y, z in (low, last)]
    bar = [(y, z + rail + e) for (y, z), e in ((low, -thick), (last, -thick), (last, thick))]
    bar.append((low[0], low[1] + rail + thick))
    return {
        "body": prism([*side, (-front, 0.0)], 0, x),
        "treads": join(*treads),
        "posts": both(join(*posts)),
        "rails": both(prism(bar, 0, 0.1, x - 0.09)),
        "knobs": both(join(*knobs)),
    }


def spiral_staircase(draw: Draw) -> Parts:
    """Treads that turn up about a pole, and a rail along them."""
    count, rise, turn = 10, draw(0.2, 0.22), draw(28, 33)
    reach, half, rail = draw(0.82, 0.92), 17.0, draw(0.5, 0.56)
    pole, thick, high = draw(0.11, 0.13), 0.06, 10 * rise
    way = (-1, 1)[draw.which(2)]
    wide = math.tan(math.radians(half)) * reach
    board = [(0.0, -0.1), (reach, -wide), (reach, wide), (0.0, 0.1)]
    treads, posts, tops = [], [], []
    for k in range(count):
        a, z = way * turn * k - 90, rise * (k + 1) - thick
        treads.append(turned(prism(board, 2, thick, z), 2, a))
        u, v = (reach * 0.9 * f(math.radians(a)) for f in (math.cos, math.sin))
        tops.append((u, v, z + rail))
        if k % 3 == 0:
            posts.append(capsule((u, v, z), (u, v, z + rail), 0.06))
    pairs = itertools.pairwise(tops)
    return {
        "treads": join(*treads),
        "pole": join(
            tube((0, 0, 0), (0, 0, high + rail + 0.05), pole), ball((0, 0, high + rail), 0.17)
        ),
        "posts": join(*posts),
        "rail": join(*(capsule(a, b, 0.075) for a, b in pairs)),
    }


LANDMARKS_STRUCTURES = {
    "column": column,
    "arch": arch,
    "gate": gate,
    "torii gate": torii_gate,
    "wall": wall,
    "bridge": bridge,
    "fountain": fountain,
    "staircase": staircase,
    "spiral staircase": spiral_staircase,
}
