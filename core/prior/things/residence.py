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
    mirrored,
    prism,
    smooth_curve,
    tilted,
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
    """Slender posts, a canopy with a scalloped valance, curtains gathered at the posts."""
    x, y, low, high = draw(0.82, 0.92), draw(1.0, 1.1), draw(0.34, 0.4), draw(1.92, 2.06)
    r, edge, tie = 0.11, high - 0.2, draw(0.46, 0.52)
    post = join(
        tube((x, y, 0), (x, y, high + 0.1), r),
        box((x, y, low), (0.15, 0.15, 0.17), 0.02),
        ball((x, y, high + 0.2), 0.135),
    )
    crest = [(x - 0.02, low + 0.52), (x * 0.7, low + 0.56), (x * 0.42, low + 0.74),
             (0, low + 0.82)]  # fmt: skip
    panel = mirrored([(x - 0.02, low), *smooth_curve(crest)])
    soft, fold = low + 0.34, y * draw(0.24, 0.32)

    def valance(half: float, count: int) -> list[tuple[float, float]]:
        """The outline of a strip that hangs from the canopy in bows."""
        last = 8 * count
        bows = [
            (half * (2 * k / last - 1), edge - 0.09 * abs(math.sin(math.pi * k / 8)))
            for k in range(last + 1)
        ]
        return [(half, high), (-half, high), *bows]

    def drape(at: float) -> list[tuple[float, float]]:
        """From along the rail to the tie at the post, then down; ``at`` is the post's."""
        waist = low + (edge - low) * tie
        inner = [
            (at - 0.46, edge + 0.08),
            (at - 0.38, edge - 0.18),
            (at - 0.24, waist + 0.1),
            (at - 0.18, waist),
            (at - 0.23, waist - 0.14),
            (at - 0.27, low + 0.05),
        ]
        return [(at, low + 0.05), (at, edge + 0.08), *smooth_curve(inner)]

    return {
        "frame": join(
            both(post, 0, 1),
            both(box((x, 0, low), (0.09, y, 0.12), 0.02)),
            box((0, -y, low + 0.06), (x, 0.09, 0.17), 0.02),
            prism(panel, 1, 0.09, y),
        ),
        "mattress": join(
            box((0, 0, low + 0.17), (x - 0.05, y - 0.05, 0.17), 0.05),
            box((0, fold, soft + 0.04), (x + 0.04, 0.13, 0.12), 0.05),
        ),
        "blanket": box((0, (fold - y) / 2, soft - 0.08), (x, (fold + y) / 2 - 0.04, 0.17), 0.06),
        "pillow": both(
            tilted(box((0, 0, 0), (x * 0.4, 0.22, 0.13), 0.1), 24, (x * 0.43, y - 0.3, soft + 0.1))
        ),
        "canopy": join(
            box((0, 0, high - 0.02), (x + 0.2, y + 0.2, 0.1), 0.02),
            both(prism(valance(y + 0.06, 3), 0, 0.09, x + 0.02)),
            both(prism(valance(x + 0.06, 3), 1, 0.09, y + 0.02), 1),
        ),
        "curtains": both(
            join(
                prism(drape(y - 0.03), 0, 0.1, x - 0.08), prism(drape(x - 0.03), 1, 0.1, y - 0.08)
            ),
            0,
            1,
        ),
    }


RESIDENCE = {
    "modern house": modern_house,
    "spiral staircase": spiral_staircase,
    "gate": gate,
    "four-poster bed": four_poster_bed,
}
