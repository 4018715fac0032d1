"""Records and sound; hardware, rope and pipes; bricks, a stone cross and a rainbow."""

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
    around,
    ball,
    both,
    box,
    chain,
    cut,
    egg,
    join,
    lathe,
    moved,
    prism,
    ring,
    tube,
    turned,
    within,
)


def maracas(draw: Draw) -> Parts:
    """A pair, crossed: round heads with a thick belt and a cap, on handles with a knob."""
    lean, wide, long = draw(36, 40), draw(0.43, 0.47), draw(0.52, 0.57)
    grip, apart = draw(1.16, 1.26), draw(0.34, 0.38)
    z = grip + long * 0.8

    def crossed(solid: Solid) -> Solid:
        return join(
            *(moved(turned(solid, 1, -side * lean), (side * apart, 0, 0.2)) for side in (-1, 1))
        )

    def head(more: float) -> Solid:
        return egg((0, 0, z), (wide + more, wide + more, long + more))

    handle = [(0.11, 0.0), (0.13, grip * 0.5), (0.17, grip), (0.2, grip + 0.1)]
    return {
        "heads": crossed(head(0.0)),
        "bands": crossed(tube((0, 0, z - 0.15), (0, 0, z + 0.15), wide + 0.085, 0.03)),
        "tops": crossed(within(head(0.06), box((0, 0, z + long * 0.7 + 1), (1, 1, 1)))),
        "handles": crossed(lathe(handle, 0.01)),
        "knobs": crossed(ball((0, 0, 0), 0.2)),
    }


def gong(draw: Draw) -> Parts:
    """A disc of bronze that hangs in a frame."""
    r, high = draw(0.7, 0.78), draw(2.45, 2.6)
    boss, foot, over = draw(0.22, 0.28), draw(0.42, 0.52), draw(0.2, 0.26)
    x = r + draw(0.36, 0.42)
    z = high - 0.3 - r
    beam = box((0, 0, high), (x + over, 0.13, 0.12), 0.02)
    tip = box((x + over, 0, high + 0.06), (0.1, 0.16, 0.18), 0.03)
    return {
        "disc": tube((0, -0.1, z), (0, 0.1, z), r, 0.02),
        "rim": ring((0, 0, z), r - 0.02, 0.12, 1),
        "boss": egg((0, -0.1, z), (boss, 0.14, boss)),
        "ropes": both(tube((r * 0.5, 0, z + r * 0.8), (r * 0.5, 0, high), 0.075)),
        "frame": join(
            beam,
            both(join(tip, box((x, 0, high / 2), (0.12, 0.12, high / 2)))),
            box((0, 0, 0.2), (x, 0.09, 0.1)),
        ),
        "feet": both(box((x, 0, 0.1), (0.17, foot, 0.1), 0.03)),
    }


def megaphone(draw: Draw) -> Parts:
    """On its grip, the horn to -X."""
    wide, long, neck = draw(0.68, 0.78), draw(1.1, 1.25), draw(0.24, 0.28)
    back, z, grip = draw(0.42, 0.52), draw(1.02, 1.12), draw(0.16, 0.19)

    def level(solid: Solid) -> Solid:
        """Made upwards along z, laid along -X."""
        return moved(turned(solid, 1, -90), (0.15, 0, z))

    bell = lathe([(neck, -0.05), (wide, long)])
    hollow = lathe([(neck * 0.35, 0.4), (wide - 0.12, long + 0.05)])
    return {
        "horn": level(cut(bell, hollow)),
        "rim": level(ring((0, 0, long), wide - 0.05, 0.1)),
        "body": level(lathe([(neck + 0.1, -back), (neck + 0.07, 0.04)], 0.03)),
        "cap": level(tube((0, 0, -back - 0.18), (0, 0, -back + 0.02), neck + 0.02, 0.03)),
        "handle": join(
            box((0.32, 0, z / 2), (grip, 0.15, z / 2), 0.05),
            box((0.32, 0, 0.09), (grip + 0.08, 0.2, 0.09), 0.03),
        ),
        "trigger": box((0.32 - grip - 0.05, 0, z - 0.62), (0.1, 0.09, 0.14), 0.02),
    }


def cassette(draw: Draw) -> Parts:
    """It stands; a label with a window, two reels in it, a thicker lower edge."""
    x, z, y = draw(1.0, 1.06), draw(0.62, 0.68), draw(0.12, 0.15)
    out, hub = y + 0.05, draw(0.17, 0.19)
    reel = x * 0.4
    base = [(-x * 0.66, -0.0), (x * 0.66, -0.0), (x * 0.56, 0.34), (-x * 0.56, 0.34)]
    return {
        "body": join(box((0, 0, z), (x, y, z), 0.04), prism(base, 1, y + 0.07)),
        "label": box((0, 0, z * 1.16), (x * 0.86, out, z * 0.6)),
        "window": box((0, 0, z * 1.1), (x * 0.66, out + 0.045, z * 0.3)),
        "reels": both(tube((reel, -out - 0.1, z * 1.1), (reel, out + 0.1, z * 1.1), hub)),
        "stripe": box((0, 0, z * 1.6), (x * 0.86, out + 0.04, z * 0.09)),
    }


def record(draw: Draw) -> Parts:
    """A vinyl disc that stands, its label and hole in the middle, a few grooves as rings."""
    r, thick, label = 1.0, draw(0.06, 0.075), draw(0.32, 0.38)

    def disc(radius: float, half: float) -> Solid:
        return tube((0, -half, r), (0, half, r), radius)

    grooves = [cut(disc(a + 0.055, thick + 0.025), disc(a - 0.055, 1)) for a in (0.56, 0.8)]
    return {
        "disc": disc(r, thick),
        "grooves": join(*grooves),
        "label": disc(label, thick + 0.04),
        "hole": disc(0.08, thick + 0.08),
    }


def screw(draw: Draw) -> Parts:
    """Point down, a cross in its head, a thread about its shaft."""
    head, cap, r = draw(0.54, 0.62), draw(0.26, 0.32), draw(0.22, 0.26)
    tip, long, out = draw(0.42, 0.55), draw(1.5, 1.7), draw(0.13, 0.16)
    top = tip + long
    turns, pitch = 5, (long * 0.8) / 5
    side = []
    for k in range(turns):
        z = tip * 0.72 + pitch * k
        wide = r * (0.75 if k == 0 else 1)
        side += [(wide, z), (wide + out, z + pitch * 0.3), (wide + out, z + pitch * 0.42)]
        side += [(wide, z + pitch * 0.72)]
    cross = join(
        box((0, 0, top + cap), (head * 0.6, 0.1, 0.12)),
        box((0, 0, top + cap), (0.1, head * 0.6, 0.12)),
    )
    return {
        "head": cut(
            lathe(
                [(r, top - 0.3), (head, top + 0.02), (head, top + 0.1), (head * 0.72, top + cap)]
            ),
            cross,
        ),
        "shaft": lathe([(0.02, 0.0), (r * 0.8, tip), (r, tip + 0.1), (r, top)], 0.01),
        "thread": lathe(side),
    }


def pipe(draw: Draw) -> Parts:
    """A tee of a water pipe, with a flange and its bolts at each of three ends."""
    r, x, high = draw(0.36, 0.42), draw(1.02, 1.15), draw(0.95, 1.1)
    wide, thick, bolt = r + draw(0.22, 0.27), draw(0.17, 0.21), draw(0.09, 0.1)
    bore, z = r - 0.15, high
    at = (r + wide) / 2 + 0.01

    def standing(from_z: float, to_z: float, radius: float) -> Solid:
        return tube((0, 0, from_z), (0, 0, to_z), radius)

    def side(solid: Solid) -> Solid:
        """Made upwards from the crossing, laid to both sides."""
        return both(moved(turned(solid, 1, 90), (0, 0, z)))

    nuts = around(6, tube((at, 0, -0.07), (at, 0, thick + 0.07), bolt), 30)
    mouth = standing(r + 0.3, 3, bore)
    return {
        "pipe": join(
            side(cut(standing(-0.05, x, r), mouth)), standing(0, z, r), ball((0, 0, z), r + 0.02)
        ),
        "flanges": join(
            side(cut(standing(x - thick, x, wide), mouth)),
            standing(0, thick, wide),
        ),
        "bolts": join(side(moved(nuts, (0, 0, x - thick))), moved(nuts, (0, 0, 0.0))),
        "bands": join(
            side(standing(r + 0.02, r + 0.2, r + 0.07)),
            standing(z - r - 0.2, z - r - 0.02, r + 0.07),
        ),
    }


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


def rake(draw: Draw) -> Parts:
    """Upright on its tines, a long shaft up from the middle of its bar."""
    x, high, tine = draw(0.72, 0.82), draw(2.5, 2.7), draw(0.34, 0.42)
    count, z, socket = 6, tine + 0.04, draw(0.34, 0.42)
    grip, y = draw(0.6, 0.75), -0.06
    tines = [
        lathe([(0.04, 0.0), (0.085, tine * 0.5), (0.085, z)], 0.0, (x * (2 * k / 5 - 1), y))
        for k in range(count)
    ]
    return {
        "tines": join(*tines),
        "bar": box((0, y, z), (x + 0.1, 0.11, 0.1), 0.02),
        "socket": lathe([(0.19, z), (0.12, z + socket)], 0.01),
        "handle": tube((0, 0, z + 0.1), (0, 0, high), 0.095, 0.03),
        "grip": tube((0, 0, high - grip), (0, 0, high + 0.02), 0.12, 0.04),
    }


def brick(draw: Draw) -> Parts:
    """One fired brick that lies flat, three round holes through it from above."""
    x, y, high = draw(1.2, 1.3), draw(0.6, 0.66), draw(0.72, 0.8)
    r, apart = draw(0.24, 0.26), x * 0.56
    at = (-apart, 0.0, apart)
    return {
        "brick": cut(
            box((0, 0, high / 2), (x, y, high / 2), 0.05),
            *(tube((u, 0, 0.3), (u, 0, 2), r) for u in at),
        ),
        "holes": join(*(tube((u, 0, 0.2), (u, 0, high - 0.14), r + 0.02) for u in at)),
    }


def rainbow(draw: Draw) -> Parts:
    """Five arches about one another, red without, blue within; clouds at both feet."""
    outer, each = draw(1.34, 1.4), draw(0.185, 0.195)
    low, deep = 0.3, draw(0.17, 0.19)

    def arch(k: int) -> Solid:
        """The k-th from without, the inner ones a little thicker."""
        half, r = deep + 0.03 * (4 - k), outer - each * k
        disc = tube((0, -half, low), (0, half, low), r)
        hole = tube((0, -1, low), (0, 1, low), r - each - (0.0 if k == 4 else 0.02))
        legs = box((r - each / 2, 0, low - 0.04), (each / 2, half, 0.06))
        return join(both(legs), within(cut(disc, hole), box((0, 0, low + 2), (2, 2, 2))))

    x = outer - 2.4 * each
    puffs = [((x, 0, 0.38), 0.43), ((x + 0.38, 0, 0.27), 0.3), ((x - 0.4, 0, 0.27), 0.3),
             ((x + 0.16, -0.3, 0.25), 0.28), ((x - 0.22, -0.26, 0.24), 0.27)]  # fmt: skip
    names = ("red", "orange", "yellow", "green", "blue")
    return {
        **{name: arch(k) for k, name in enumerate(names)},
        "clouds": both(join(*(egg(at, (r, r, r * 0.9)) for at, r in puffs))),
    }


def cross(draw: Draw) -> Parts:
    """A cross of stone on three steps, its arms spread at their ends, plain or with a ring."""
    high, wide, deep = draw(2.5, 2.65), draw(0.78, 0.84), draw(0.17, 0.19)
    low, z = 0.6, 1.98
    half = 0.15
    shape = [(0.28, low - 0.1), (half + 0.02, z - 0.34), (half, z - half), (wide - 0.2, z - half),
             (wide, z - half - 0.12), (wide, z + half + 0.12), (wide - 0.2, z + half),
             (half, z + half), (half, high), (half + 0.12, high + 0.2)]  # fmt: skip
    body = prism([*shape, *((-u, v) for u, v in reversed(shape))], 1, deep)
    if draw.chance(0.5):
        hoop = cut(
            tube((0, -deep * 0.7, z), (0, deep * 0.7, z), 0.62, 0.02),
            tube((0, -1, z), (0, 1, z), 0.44),
        )
        body = join(body, hoop)
    steps = [(0.84, 0.66, 0.0), (0.62, 0.5, 0.2), (0.42, 0.36, 0.4)]
    front = deep + 0.05
    return {
        "cross": body,
        "boss": join(
            tube((0, -front - 0.06, z), (0, front + 0.06, z), 0.24, 0.06),
            *(egg((u, 0, v), (0.12, front + 0.04, 0.12))
              for u, v in ((0.58, z), (-0.58, z), (0, high), (0, 1.34), (0, 0.94))),
        ),
        "base": join(*(box((0, 0, v + 0.1), (x, y, 0.11), 0.02) for x, y, v in steps)),
    }  # fmt: skip


SOUND_AND_HARDWARE = {
    "maracas": maracas,
    "gong": gong,
    "megaphone": megaphone,
    "cassette": cassette,
    "vinyl record": record,
    "screw": screw,
    "pipe": pipe,
    "rope": rope,
    "rake": rake,
    "brick block": brick,
    "rainbow arch": rainbow,
    "stone cross": cross,
}
