"""Beds and a pillow."""

import math

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    ball,
    blend,
    both,
    box,
    capsule,
    egg,
    join,
    mirrored,
    prism,
    smooth_curve,
    tilted,
    tube,
)


def bed(draw: Draw) -> Parts:
    """A mattress, a pillow, a blanket; the head stands at the back."""
    x, y, low = draw(0.75, 0.95), draw(1.15, 1.3), draw(0.35, 0.45)
    soft, head, foot = draw(0.17, 0.22), draw(0.95, 1.25), draw(0.5, 0.65)
    fold = draw(0.1, 0.4)
    blanket = box(
        (0, (fold - y) / 2, low + soft), (x - 0.0, (fold + y) / 2 - 0.08, soft + 0.06), 0.08
    )
    return {
        "blanket": blanket,
        "mattress": box((0, 0, low + soft), (x - 0.07, y - 0.08, soft), 0.07),
        "pillow": box((0, y - 0.42, low + 2 * soft + 0.06), (x * 0.66, 0.24, 0.15), 0.13),
        "frame": join(
            box((0, 0, low - 0.06), (x, y, 0.12), 0.03),
            box((0, y, head / 2), (x + 0.03, 0.1, head / 2), 0.05),
            box((0, -y, foot / 2), (x + 0.03, 0.1, foot / 2), 0.05),
        ),
    }


def bunk_bed(draw: Draw) -> Parts:
    """Two beds, one above the other, between four posts; a ladder leans at the front's right, a low
    rail is on top, the pillows are left."""
    x, y, low, high = draw(1.14, 1.18), draw(0.64, 0.67), draw(0.42, 0.45), draw(1.5, 1.54)
    at, top, levels = x - 0.6, high + 0.76, (low, high)
    posts = join(box((x, y, top / 2), (0.14, 0.14, top / 2), 0.03), ball((x, y, top + 0.08), 0.18))
    beds = (box((0, 0, z), (x, y + 0.08, 0.14)) for z in levels)
    ends = (both(box((x, 0, z + 0.12), (0.09, y, 0.34))) for z in levels)
    side, rail = at - 0.44, high + 0.62
    guards = (box(((side - x) / 2, -y, rail), ((side + x) / 2, 0.09, 0.09)),
              box((side - 0.09, -y, rail - 0.22), (0.09, 0.09, 0.31)),
              box((0, y, rail), (x, 0.09, 0.09)))  # fmt: skip
    long = high + 0.52
    steps = (0.34 + 0.4 * k for k in range(5))
    ladder = join(
        both(box((0.27, 0, long / 2), (0.08, 0.09, long / 2), 0.03)),
        *(capsule((-0.27, 0, z), (0.27, 0, z), 0.075) for z in steps),
    )
    return {
        "blanket": join(*(box((0.3, 0, z + 0.36), (x - 0.44, y + 0.06, 0.14), 0.06)
                          for z in levels)),
        "mattress": join(*(box((0, 0, z + 0.2), (x - 0.08, y - 0.03, 0.19), 0.05)
                           for z in levels)),
        "pillow": join(*(egg((0.44 - x, 0, z + 0.44), (0.25, y * 0.7, 0.17)) for z in levels)),
        "frame": join(both(posts, 0, 1), *beds, *ends, *guards),
        "ladder": tilted(ladder, -9, (at, -y - 0.42, 0)),
    }  # fmt: skip


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


def crib(draw: Draw) -> Parts:
    """A baby's bed: solid ends, four thick bars in each long side."""
    x, y, low, top = draw(0.98, 1.15), draw(0.55, 0.65), draw(0.42, 0.52), draw(1.3, 1.45)
    head = top + draw(0.1, 0.3)
    middle, half = (low + top) / 2, (top - low) / 2
    bars = (box((x * k, y, middle), (0.085, 0.085, half)) for k in (-0.6, -0.2, 0.2, 0.6))
    rail = box((0, y, top), (x, 0.1, 0.1), 0.03)
    return {
        "frame": join(
            both(join(*bars, rail), 1),
            both(box((x, 0, (low + head) / 2), (0.09, y, (head - low) / 2), 0.03)),
            both(box((x, y, head / 2 + 0.03), (0.13, 0.13, head / 2 + 0.03), 0.03), 0, 1),
            box((0, 0, low), (x, y, 0.12)),
        ),
        "mattress": box((0, 0, low + 0.2), (x - 0.06, y - 0.05, 0.15), 0.05),
        "pillow": box((x - 0.36, 0, low + 0.38), (0.22, y * 0.62, 0.14), 0.1),
        "blanket": box((-0.26, 0, low + 0.25), (x - 0.38, y - 0.05, 0.17), 0.06),
    }


def pillow(draw: Draw) -> Parts:
    """A soft square with drawn-out corners; tassels on some."""
    x, y, z = draw(0.85, 1.2), draw(0.75, 0.9), draw(0.3, 0.4)
    soft = blend(0.2, egg((0, 0, z), (x * 0.95, y * 0.95, z)), box((0, 0, z), (x, y, 0.13), 0.12))
    parts = {"body": soft, "button": egg((0, 0, 2 * z), (0.14, 0.14, 0.08))}
    if draw.has("tassels", 0.4):
        parts["tassels"] = both(ball((x, y, z), 0.15), 0, 1)
    return parts


BEDS = {
    "bed": bed,
    "bunk bed": bunk_bed,
    "four-poster bed": four_poster_bed,
    "crib": crib,
    "pillow": pillow,
}
