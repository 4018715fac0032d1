"""A house with flat roofs, a spiral staircase, a gate of bars, a bed with four posts."""

import itertools
import math

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    ball,
    both,
    box,
    capsule,
    join,
    prism,
    tube,
    turned,
)


def modern_house(draw: Draw) -> Parts:
    """Two storeys with flat roofs, the upper one over the garage; wide panes in dark frames."""
    x, y, low = draw(1.15, 1.3), draw(0.75, 0.85), draw(0.62, 0.7)
    side = (-1, 1)[draw.which(2)]
    wide, over, high = x * draw(0.62, 0.7), draw(0.16, 0.26), draw(0.6, 0.68)
    roof, top = 0.1, low + 0.1
    mid = side * (x - wide)  # of the upper storey
    front = -y - over

    def pane(u: float, v: float, z: float, half: float, tall: float) -> Parts:
        return {
            "frames": box((u, v, z), (half, 0.06, tall)),
            "windows": box((u, v - 0.05, z), (half - 0.09, 0.06, tall - 0.09)),
        }

    panes = [
        pane(mid - wide * 0.16, front, top + high * 0.5, wide * 0.66, high * 0.36),
        pane(-side * x * 0.52, -y, low * 0.52, x * 0.36, low * 0.4),
    ]
    door = side * x * 0.03
    return {
        "walls": join(
            box((0, 0, low / 2), (x, y, low / 2)),
            box((mid, -over / 2, top + high / 2), (wide, y + over / 2, high / 2)),
        ),
        "roof": join(
            box((0, -0.05, low + roof / 2), (x + 0.1, y + 0.14, roof / 2)),
            box((mid, -over / 2, top + high), (wide + 0.1, y + over / 2 + 0.1, roof / 2)),
        ),
        "windows": join(*(one["windows"] for one in panes)),
        "frames": join(*(one["frames"] for one in panes)),
        "door": box((door, -y, low * 0.4), (0.15, 0.08, low * 0.4)),
        "garage": box((side * x * 0.6, -y, low * 0.4), (x * 0.32, 0.07, low * 0.4)),
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


def four_poster_bed(draw: Draw) -> Parts:
    """Four posts with a canopy or bare beams above, a mattress, a blanket, two pillows."""
    x, y, low, high = draw(0.8, 0.92), draw(1.02, 1.12), draw(0.36, 0.44), draw(1.6, 1.8)
    soft, fold, thick = draw(0.15, 0.19), draw(0.3, 0.5), 0.085
    posts = both(box((x, y, high / 2), (thick, thick, high / 2)), 0, 1)
    beams = join(
        both(box((x, 0, high - thick), (thick, y, thick))),
        both(box((0, y, high - thick), (x, thick, thick)), 1),
    )
    head = box((0, y, low + 0.3), (x, 0.075, 0.42))
    parts = {
        "frame": join(posts, beams, head, box((0, 0, low - 0.06), (x, y, 0.12))),
        "mattress": box((0, 0, low + soft), (x - 0.06, y - 0.08, soft), 0.05),
        "blanket": box(
            (0, (fold - y) / 2, low + soft), (x - 0.02, (fold + y) / 2 - 0.06, soft + 0.07), 0.06
        ),
        "pillow": both(
            box((x * 0.44, y - 0.34, low + 2 * soft + 0.06), (x * 0.36, 0.2, 0.13), 0.1)
        ),
        "canopy": box((0, 0, high + 0.03), (x + 0.06, y + 0.06, 0.06)),
    }
    if draw.chance(0.5):
        curtain = box((x - 0.02, y - 0.16, (high + low) / 2), (0.11, 0.2, (high - low) / 2), 0.05)
        parts["curtains"] = both(curtain, 0, 1)
    return parts


RESIDENCE = {
    "modern house": modern_house,
    "spiral staircase": spiral_staircase,
    "gate": gate,
    "four-poster bed": four_poster_bed,
}
