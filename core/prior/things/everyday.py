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
    """Three rolled towels as a pyramid, striped around near their front ends."""
    r, long = draw(0.5, 0.54), draw(0.94, 1.0)
    x, top = r * 0.98, r * 2.7
    middles = ((-x, r), (x, r), (0.0, top))

    def rolled(u: float, z: float, radius: float, out: float, rounding: float) -> Solid:
        return tube((u, -long - out, z), (u, long + out, z), radius, rounding)

    return {
        "towels": both(rolled(x, r, r, 0, 0.1)),
        "folds": join(*(rolled(u, z, r * 0.45, 0.07, 0.03) for u, z in middles)),
        "bands": join(
            *(
                tube((u, v - 0.07, z), (u, v + 0.07, z), r + 0.05, 0.02)
                for u, z in middles
                for v in (0.26 - long, 0.52 - long)
            )
        ),
        "roll": rolled(0, top, r, 0, 0.1),
    }


def toilet_paper(draw: Draw) -> Parts:
    """A plump roll on its side, its last sheets down its front and out on the ground."""
    r, half, core = draw(0.82, 0.88), draw(0.74, 0.82), draw(0.32, 0.35)
    out, thick, bend = draw(0.48, 0.54), 0.07, 0.24
    y, floor, wide = -r - 0.03, bend + thick, half - 0.04
    turns = [math.radians(-15 * k) for k in range(7)]
    path = [(-0.78 * r, r * 1.5, 0.88, 0.48), (y, r * 1.04, 1.0, 0.06)]
    path += [(y - bend * (1 - math.cos(a)), floor + bend * math.sin(a), math.cos(a), math.sin(a))
             for a in turns]  # fmt: skip
    path.append((y - bend - out, thick, 0.0, -1.0))
    back, front = ([(a + s * c, b + s * d) for a, b, c, d in path] for s in (thick, -thick))
    hole = tube((-2, 0, r), (2, 0, r), core - 0.06)
    xs, far = (-wide * 0.58, 0.0, wide * 0.58), y - bend - out * 0.5
    return {
        "roll": cut(tube((-half, 0, r), (half, 0, r), r, 0.16), hole),
        "sheet": prism(back + front[::-1], 0, wide),
        "core": cut(tube((-half - 0.07, 0, r), (half + 0.07, 0, r), core + 0.08, 0.02), hole),
        "line": box((0, y - thick, floor + 0.04), (wide + 0.04, 0.06, 0.06), 0.02),
        "dots": join(
            *(tube((v, y - thick - 0.06, r * 0.86), (v, y, r * 0.86), 0.14) for v in xs),
            *(tube((v, far, thick), (v, far, 2 * thick + 0.06), 0.14) for v in xs),
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
    mouth, tip, far = draw(0.44, 0.5), draw(0.1, 0.12), draw(1.2, 1.35)
    near, turns, middle, up = 0.84, (6.0, -158.0), (-0.06, 1.62), 0.16

    def place(share: float) -> tuple[float, float, float]:
        a = math.radians(turns[0] + (turns[1] - turns[0]) * share)
        out = near + (far - near) * share
        return (middle[0] + out * math.cos(a), middle[1] + out * math.sin(a), a)

    def piece(shares: list[float], out: float) -> Solid:
        """The horn through these shares of its length, ``out`` thicker."""
        places = ((place(share), mouth + (tip - mouth) * share + out) for share in shares)
        return chain(((x, 0, z), r) for (x, z, _), r in places)

    def hoop(share: float) -> Solid:
        """A band about the horn."""
        x, z, a = place(share)
        r, half = mouth + (tip - mouth) * share + 0.06, 0.09
        way = (-math.sin(a) * half, math.cos(a) * half)
        return tube((x - way[0], 0, z - way[1]), (x + way[0], 0, z + way[1]), r, 0.03)

    x, z, _ = place(0)
    low, bottom, _ = place(0.46)
    end = place(1)
    rim = tube((x, 0, z + up - 0.14), (x, 0, z + up + 0.1), mouth + 0.07, 0.04)
    bubbles = [ball((x + a, b, z + up + 0.24), 0.17) for a, b in ((-0.17, -0.12), (0.17, 0.06))]
    return {
        "horn": cut(
            join(piece([k / 15 for k in range(16)], 0), tube((x, 0, z), (x, 0, z + up), mouth)),
            box((x, 0, z + up + 1), (1, 1, 1)),
        ),
        "rim": join(rim, hoop(0.3)),
        "foam": join(egg((x, 0, z + up + 0.06), (mouth - 0.04, mouth - 0.04, 0.24)), *bubbles),
        "tip": join(piece([0.84, 0.92, 1], 0.045), ball((end[0], 0, end[1]), tip + 0.08)),
        "strap": hoop(0.62),
        "stand": join(
            box((low, 0, 0.1), (0.62, 0.44, 0.1), 0.04),
            box((low, 0, bottom / 2), (0.16, 0.26, bottom / 2), 0.04),
        ),
    }


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
