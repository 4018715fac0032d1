"""What lies about in a hall, a bath or a yard."""

import math

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
    ball,
    blend,
    both,
    box,
    capsule,
    chain,
    cut,
    egg,
    join,
    lathe,
    moved,
    prism,
    ring,
    taper,
    tilted,
    tube,
    turned,
    within,
)


def paper_cup(draw: Draw) -> Parts:
    """A tapered cup in a sleeve, under a lid to drink through or with a straw in it."""
    low, wide, high = draw(0.44, 0.52), draw(0.64, 0.72), draw(1.6, 1.85)
    straw, a, b = draw.chance(0.35), draw(0.26, 0.34), draw(0.66, 0.74)

    def at(share: float, out: float = 0.0) -> tuple[float, float]:
        return low + (wide - low) * share + out, high * share

    lid = [(wide + 0.09, high - 0.1), (wide + 0.09, high + 0.06), (wide * 0.9, high + 0.1),
           (wide * 0.84, high + 0.26), (wide * 0.76, high + 0.28)]  # fmt: skip
    pipe = capsule((0.08, 0.1, high), (0.24, 0.26, high + 0.95), 0.1)
    hole = box((0, -wide * 0.5, high + 0.28), (0.16, 0.09, 0.06), 0.02)
    logo = low + (wide - low) * (a + b) / 2
    return {
        "cup": lathe([at(0.0), at(1.0)], 0.01),
        "sleeve": lathe([at(a, 0.05), at(b, 0.05)], 0.02),
        "lid": lathe(lid, 0.02),
        "rim": join(
            tube((0, 0, high - 0.14), (0, 0, high - 0.02), wide + 0.12, 0.04),
            tube((0, 0, 0), (0, 0, 0.12), low + 0.05, 0.04),
        ),
        "spout": pipe if straw else hole,
        "badge": tube((0, -logo - 0.1, high * (a + b) / 2), (0, 0, high * (a + b) / 2), 0.26),
    }


def sock(draw: Draw) -> Parts:
    """A long sock, its toe to the front; cuff, heel and toe of another colour."""
    r, foot, high = draw(0.36, 0.42), draw(0.85, 1.05), draw(1.45, 1.75)
    back, low = 0.42, draw(0.4, 0.44)
    small = r * 0.84
    toe = (0.0, back - foot, small - 0.02)
    ground = box((0, 0, -1), (3, 3, 1))
    shaft = lathe([(r * 0.96, low), (r, high)], 0.01, (0, back))
    sole = taper((0, back + 0.02, low), toe, r, small)
    hem = tube((0, back, high - 0.1), (0, back, high + 0.3), r + 0.1, 0.06)
    half = box((0, back + 1.04, low - 0.7), (1, 1, 1))
    return {
        "body": cut(blend(0.2, shaft, sole), ground),
        "cuff": cut(hem, tube((0, back, high + 0.1), (0, back, high + 1), r - 0.06)),
        "heel": cut(within(ball((0, back + 0.02, low), r + 0.045), half), ground),
        "toe": cut(taper((0, toe[1] + 0.12, toe[2] + 0.01), toe, small + 0.04, small + 0.04),
                   ground),
        "stripes": join(
            *(tube((0, back, high * v - 0.07), (0, back, high * v + 0.07), r + 0.045, 0.02)
              for v in (0.58, 0.76)),
        ),
    }  # fmt: skip


def towel(draw: Draw) -> Parts:
    """Three folded towels, their folds to the front, a rolled one on them; bands across them."""
    x, y, half = draw(0.98, 1.08), draw(0.64, 0.74), draw(0.25, 0.27)
    r, short, inner = draw(0.36, 0.42), draw(0.78, 0.88), half - 0.17
    turns = [math.radians(90 - 22.5 * k) for k in range(9)]

    def fold(out: float) -> list[tuple[float, float]]:
        """Round to the front, ``out`` larger than a towel, seen from its end."""
        size = half + out
        return [(half - y - size * math.cos(a), size * math.sin(a)) for a in turns]

    gap = [(y, -inner), (half - y, -inner), (half - y, inner), (y, inner)]
    sheet = [(y, half), *fold(0), (y, -half), *gap]
    stripe = [(half - y + 0.3, half + 0.07), *fold(0.07), (half - y + 0.3, -half - 0.07)]
    towels, folds, bands = [], [], []
    for k in range(3):
        at = (0.0, 0.0, half + k * (2 * half - 0.05))
        towels.append(moved(prism(sheet, 0, x - 0.06 * (k % 2)), at))
        folds.append(moved(box((0, 0.02, 0), (x - 0.14, y - 0.1, inner + 0.06)), at))
        bands.append(moved(both(prism(stripe, 0, 0.13, x * 0.62)), at))
    z = 6 * half - 0.16 + r
    return {
        "towels": join(*towels),
        "folds": join(
            *folds, tube((0.1 - short - 0.2, 0, z), (short + 0.08, 0, z), r * 0.62, 0.02)
        ),
        "bands": join(
            *bands, both(tube((short * 0.44, 0, z), (short * 0.74, 0, z), r + 0.07, 0.02))
        ),
        "roll": join(
            tube((-short, 0, z), (short, 0, z), r, 0.04),
            box((0, -r * 0.8, z - r + 0.09), (short - 0.02, 0.24, 0.1), 0.05),
            tube((-short - 0.17, 0, z), (short + 0.17, 0, z), r * 0.3, 0.02),
        ),
    }


def toilet_paper(draw: Draw) -> Parts:
    """A roll on its end, the last sheets off it to the right; the tube within."""
    r, high, core = draw(0.72, 0.84), draw(1.2, 1.45), draw(0.26, 0.31)
    off = r + draw(0.4, 0.6)
    hole = tube((0, 0, high - 0.34), (0, 0, high + 1), core - 0.02)
    dots = []
    for k, turn in enumerate((-150, -120, -60, -30, 0, 30, 60)):
        a = math.radians(turn)
        for v in (0.3, 0.7):
            z = high * (v + (0.1 if k % 2 else -0.1))
            dots.append(ball((math.cos(a) * (r - 0.08), math.sin(a) * (r - 0.08), z), 0.12))
    return {
        "roll": cut(tube((0, 0, 0), (0, 0, high), r, 0.06), hole),
        "sheet": box((off / 2, -r + 0.05, high / 2), (off / 2, 0.1, high / 2 - 0.01), 0.03),
        "core": cut(
            tube((0, 0, high - 0.36), (0, 0, high + 0.03), core + 0.09, 0.02),
            tube((0, 0, high - 0.3), (0, 0, high + 1), core - 0.06),
        ),
        "line": box((r * 0.86, -r + 0.05, high / 2), (0.06, 0.135, high / 2 - 0.03), 0.02),
        "dots": join(
            *dots,
            *(ball((v, -r + 0.03, high * w), 0.12) for v, w in ((r * 0.3, 0.3), (r * 0.3, 0.7))),
        ),
    }


def _tome(x: float, y: float, half: float) -> dict[str, Solid]:
    """A thick book that lies, its round spine to the front, two bands about that."""
    board, bulge, inner = 0.18, 0.12, half - 0.18

    def spine(out: float, high: float) -> list[tuple[float, float]]:
        turns = (math.radians(90 - 22.5 * k) for k in range(9))
        return [(-y - out * math.cos(a), high * math.sin(a)) for a in turns]

    cover = [(y, half), *spine(bulge, half), (y, -half), (y, -inner), (board - y, -inner),
             (board - y, inner), (y, inner)]  # fmt: skip
    band = [(0.1 - y, half - 0.05), *spine(bulge + 0.1, half - 0.05), (0.1 - y, 0.05 - half)]
    return {
        "cover": prism(cover, 0, x),
        "pages": box((0, 0, 0), (x - 0.1, y - 0.1, inner + 0.05)),
        "bands": both(prism(band, 0, 0.11, x * 0.58)),
    }


def stack_of_books(draw: Draw) -> Parts:
    """Four thick books that lie on one another, each smaller than the one below and turned."""
    layout, scale, z = draw.arranged(2), draw(0.95, 1.05), 0.0
    sizes = [(1.04, 0.74, 0.3), (0.94, 0.68, 0.265), (0.84, 0.62, 0.285), (0.7, 0.54, 0.265)]
    laid: list[dict[str, Solid]] = []
    for k, (x, y, half) in enumerate(sizes):
        # The second one's back is behind.
        turn = layout(7, 13) * (1, -1, 1, -1)[k] + 180 * (k == 1)
        at = (layout(-0.07, 0.07), layout(-0.04, 0.04), z + half)
        tome = _tome(x * scale, y, half)
        laid.append({name: moved(turned(solid, 2, turn), at) for name, solid in tome.items()})
        z += 2 * half - 0.05
    covers = [tome["cover"] for tome in laid]
    return {
        "books": join(covers[0], covers[3]),
        "tomes": covers[1],
        "volumes": covers[2],
        "pages": join(*(tome["pages"] for tome in laid)),
        "bands": join(*(tome["bands"] for tome in laid)),
    }


def binoculars(draw: Draw) -> Parts:
    """Two barrels, wider at the front, joined by a hinge with a wheel; lenses at their ends."""
    x, r, long = draw(0.52, 0.6), draw(0.4, 0.46), draw(0.8, 0.95)
    small, z = draw(0.3, 0.34), 0.46
    front, back = -long - 0.3, long

    def along(start: float, end: float, radius: float, rounding: float = 0.03) -> Solid:
        return both(tube((x, start, z), (x, end, z), radius, rounding))

    shape = [(small, -back), (small + 0.02, 0.05), (r, 0.34), (r, -front)]
    barrel = moved(turned(lathe(shape, 0.02), 0, 90), (x, 0, z))
    return {
        "barrels": both(barrel),
        "rims": join(
            along(front - 0.06, front + 0.18, r + 0.06),
            along(back - 0.3, back - 0.14, small + 0.06),
        ),
        "lenses": along(front - 0.1, front + 0.1, r - 0.09, 0.02),
        "eyepieces": along(back - 0.06, back + 0.3, small + 0.03, 0.08),
        "bridge": join(
            box((0, 0.3, z + 0.05), (x, 0.15, 0.15), 0.05),
            box((0, -0.36, z), (x, 0.14, 0.14), 0.05),
            tube((0, -0.5, z + 0.06), (0, 0.6, z + 0.06), 0.13, 0.03),
        ),
        "wheel": tube((0, 0.5, z + 0.08), (0, 0.78, z + 0.08), 0.21, 0.04),
    }  # fmt: skip


def grill(draw: Draw) -> Parts:
    """A kettle on three legs, its lid open at the back; sausages and a steak on its grate."""
    r, leg, lean = draw(0.82, 0.92), draw(0.85, 1.05), draw(68, 80)
    z = leg + 0.36
    up = box((0, 0, 3), (5, 5, 3))
    bowl = cut(moved(egg((0, 0, 0), (r, r, r * 0.8)), (0, 0, z)), moved(up, (0, 0, z)))
    dome = cut(egg((0, r, 0), (r, r, r * 0.72)), box((0, 0, -3), (5, 5, 3)))
    hollow = egg((0, r, -0.02), (r - 0.14, r - 0.14, r * 0.72 - 0.14))
    knob = join(
        both(tube((0.2, r, r * 0.6), (0.2, r, r * 0.72 + 0.16), 0.085)),
        capsule((-0.24, r, r * 0.72 + 0.18), (0.24, r, r * 0.72 + 0.18), 0.1),
    )
    legs = [((0, -0.3), (0, -0.86)), ((0.3, 0.2), (0.72, 0.5)), ((-0.3, 0.2), (-0.72, 0.5))]
    feet = join(*(tube((*a, z - 0.5), (*b, 0.0), 0.1) for a, b in legs))
    bars = [
        capsule((v, -w, z + 0.03), (v, w, z + 0.03), 0.085)
        for v, w in (
            (k * 0.27, math.sqrt(r * r * 0.8 - (k * 0.27) ** 2)) for k in (-2, -1, 0, 1, 2)
        )
    ]
    food = [capsule((v - 0.22, y, z + 0.2), (v + 0.22, y + 0.06, z + 0.2), 0.14)
            for v, y in ((-0.28, -0.36), (-0.3, 0.0))]  # fmt: skip
    steak = egg((0.32, -0.14, z + 0.17), (0.28, 0.34, 0.13))
    return {
        "bowl": join(bowl, both(box((r + 0.02, 0, z - 0.1), (0.14, 0.2, 0.08), 0.03))),
        "lid": tilted(cut(dome, hollow), lean, (0, r - 0.08, z - 0.02)),
        "legs": join(feet, tube((0, 0.04, 0.3), (0, 0.04, 0.42), 0.5, 0.03)),
        "grate": join(ring((0, 0, z), r - 0.07, 0.1), *bars),
        "food": join(*food, steak),
        "handles": join(
            tilted(knob, lean, (0, r - 0.08, z - 0.02)),
            both(tube((0.64, 0.5, 0.2), (0.86, 0.5, 0.2), 0.2, 0.03)),
        ),
    }  # fmt: skip


def rope(draw: Draw) -> Parts:
    """Four turns one upon another, tied together twice, an end that lies before them."""
    wide, r = draw(0.8, 0.92), draw(0.17, 0.2)
    heights = [r * (1 + 1.75 * k) for k in range(4)]
    high = heights[-1] + r
    turns = [ring((0, 0, z), wide, r) for z in heights]
    end = [(-wide, -0.02, r), (-wide * 0.8, -wide * 0.8, r), (-wide * 0.2, -wide - 0.3, r),
           (wide * 0.45, -wide - 0.4, r)]  # fmt: skip
    tip = end[-1]
    tie = box((wide, 0.1, high / 2), (r + 0.07, 0.14, high / 2 + 0.03), 0.06)
    return {
        "coil": join(*turns[::2], chain((p, r) for p in end)),
        "strands": join(*turns[1::2]),
        "ties": both(tie),
        "end": tube((tip[0] - 0.1, tip[1], r), (tip[0] + 0.26, tip[1] - 0.03, r), r + 0.05, 0.04),
    }  # fmt: skip


def drinking_horn(draw: Draw) -> Parts:
    """A curved horn on a stand, wide and full at the right, its tip up at the left."""
    mouth, tip, rise = draw(0.42, 0.5), draw(0.11, 0.14), draw(0.3, 0.6)
    bend = draw(1.0, 1.1)
    stops = []
    for k in range(11):
        t = k / 10
        # From the mouth at the right by a bow to the tip.
        a = math.radians(10 - 150 * t)
        stops.append(((bend * math.cos(a) - 0.1, 0.0, 1.5 + bend * math.sin(a) + rise * t * t),
                      mouth + (tip - mouth) * t ** 0.8))  # fmt: skip
    (x, _, z), r = stops[0]
    flat = box((x, 0, z + 1.12), (2, 2, 1))
    lip = moved(turned(tube((0, 0, -0.1), (0, 0, 0.12), r + 0.06, 0.04), 1, -8), (x, 0, z + 0.05))
    bubbles = [ball((x + a, b, z + 0.26), 0.15) for a, b in ((-0.16, -0.12), (0.15, 0.05))]
    foam = moved(egg((0, 0, 0.1), (r - 0.05, r - 0.05, 0.2)), (x, 0, z + 0.05))

    def hoop(at: int, out: float) -> Solid:
        (a, _, b), thick = stops[at]
        (c, _, d), _ = stops[at + 1]
        half = math.hypot(c - a, d - b) * 1.4
        way = ((c - a) / half * 0.14, (d - b) / half * 0.14)
        return tube((a - way[0], 0, b - way[1]), (a + way[0], 0, b + way[1]), thick + out, 0.02)

    (end, _, top), _ = stops[-1]
    low = stops[5][0][2]
    middle = stops[5][0][0]
    return {
        "horn": cut(chain(stops), flat),
        "rim": join(lip, hoop(3, 0.05)),
        "foam": join(foam, *bubbles),
        "tip": join(chain([stops[9], ((end - 0.04, 0.0, top + 0.16), 0.08)]), hoop(8, 0.05)),
        "strap": hoop(5, 0.06),
        "stand": join(
            box((middle, 0, 0.09), (0.62, 0.42, 0.09), 0.03),
            box((middle, 0, low * 0.5 - 0.05), (0.13, 0.13, low * 0.5), 0.03),
            both(taper((0, 0.3, 0.14), (0, 0.26, low - 0.1), 0.11, 0.1), 1),
        ),
    }  # fmt: skip


EVERYDAY = {
    "paper cup": paper_cup,
    "sock": sock,
    "towel": towel,
    "toilet paper": toilet_paper,
    "stack of books": stack_of_books,
    "binoculars": binoculars,
    "grill": grill,
    "rope": rope,
    "drinking horn": drinking_horn,
}
