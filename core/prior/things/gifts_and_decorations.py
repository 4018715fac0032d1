"""Gifts, decorations of feasts, and a pawn."""

import math

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
    around,
    ball,
    blend,
    both,
    box,
    capsule,
    cut,
    egg,
    grown,
    join,
    lathe,
    limb,
    mirrored,
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


def gift(draw: Draw) -> Parts:
    """A box with a lid, a ribbon and a bow."""
    x, y, z = draw(0.7, 0.9), draw(0.7, 0.9), draw(0.5, 0.75)
    top = 2 * z + 0.14
    ribbon = join(
        box((0, 0, top / 2), (0.13, y + 0.1, top / 2 + 0.05)),
        box((0, 0, top / 2), (x + 0.1, 0.13, top / 2 + 0.05)),
    )
    loop = ring((0.26, 0, top + 0.22), 0.19, 0.1, 1)
    return {
        "box": box((0, 0, z), (x, y, z)),
        "lid": box((0, 0, 2 * z), (x + 0.06, y + 0.06, 0.16), 0.01),
        "ribbon": ribbon,
        "bow": join(both(loop), ball((0, 0, top + 0.12), 0.14)),
    }


def balloon(draw: Draw) -> Parts:
    """A toy balloon with its knot and a bit of string."""
    wide, high = draw(0.75, 0.85), draw(0.9, 1.05)
    body = blend(
        0.2, egg((0, 0, 1.5), (wide, wide, high)), taper((0, 0, 0.9), (0, 0, 0.55), 0.35, 0.1)
    )
    return {
        "body": body,
        "knot": lathe([(0.2, 0.32), (0.09, 0.52)], 0.02),
        "string": capsule((0, 0, -0.3), (0, 0, 0.4), 0.09),
    }


def paper_lantern(draw: Draw) -> Parts:
    """A ribbed globe of paper with a cap at either end, a loop above, a tassel below; or tall."""
    tall = draw.chance(0.35)
    r, half = (draw(0.6, 0.66), draw(0.82, 0.9)) if tall else (draw(0.92, 1.0), draw(0.74, 0.82))
    count, end = (7, r * 0.62) if tall else (6, r * 0.5)
    z, drop = half + 0.1, draw(0.5, 0.58)
    power = 3.2 if tall else 2.2

    def wide(t: float) -> float:
        return end + (r - end) * (1 - abs(t) ** power) ** (1 / power)

    folds = [(wide((2 * k - count) / count) - 0.02, z + half * (2 * k - count) / count)
             for k in range(count + 1)]  # fmt: skip
    hoops = [ring((0, 0, h), u - 0.03, 0.09) for u, h in folds[1:-1]]
    steps = [k / 24 for k in range(-24, 25)]
    cap = both(tube((0, 0, half - 0.06), (0, 0, half + 0.16), end + 0.08, 0.03), 2)
    low = z - half - 0.12
    return {
        "globe": lathe([(wide(t), z + half * t) for t in steps]),
        "ribs": join(*hoops),
        "caps": moved(cap, (0, 0, z)),
        "loop": ring((0, 0, z + half + 0.32), 0.22, 0.11, axis=1),
        "tassels": join(
            tube((0, 0, low + 0.1), (0, 0, low - 0.5), 0.13),
            ball((0, 0, low - 0.26), 0.2),
            lathe([(0.27, low - 0.4 - drop), (0.17, low - 0.4)], 0.02),
        ),
    }


def jack_o_lantern(draw: Draw) -> Parts:
    """A pumpkin of lobes with a face cut into its front, all alight from within."""
    wide, high, count = draw(0.5, 0.56), draw(0.68, 0.8), 10
    lobe = egg((wide * 0.85, 0, high), (wide, wide * 0.75, high))
    hull = join(around(count, lobe, 18), ball((0, 0, high), 0.5))
    lean, kind = draw(-0.14, 0.14), draw.which(3)
    eye, apart, z = draw(0.2, 0.24), draw(0.36, 0.42), high * 1.2
    eyes = [
        [(apart - eye, z - 0.13), (apart + eye, z - 0.13), (apart + 0.02, z + 0.25)],
        [(apart - eye, z - 0.16), (apart + eye, z - 0.06), (apart + eye, z + 0.26)],
        [(apart + eye * math.cos(a), z + 0.04 + 0.2 * math.sin(a))
         for a in (math.tau * k / 16 for k in range(16))],
    ][kind]  # fmt: skip
    nose = [(-0.15, high * 0.94 - 0.12), (0.15, high * 0.94 - 0.12), (0, high * 0.94 + 0.16)]
    w, low = draw(0.62, 0.7), high * 0.57
    grin = [(0.0, low + 0.02), (0.12, low + 0.02), (0.12, low + 0.16), (0.3, low + 0.16)]
    grin += [(0.3, low + 0.08), (w, low + 0.36), (w * 0.86, low + 0.0), (w * 0.62, low - 0.18)]
    grin += [(0.34, low - 0.25), (0.34, low - 0.1), (0.16, low - 0.1), (0.16, low - 0.28)]
    grin += [(0.0, low - 0.3)]

    def hole(outline: list[tuple[float, float]]) -> Solid:
        return prism(outline, 1, 1.0, -1.2)

    face = (both(hole(eyes)), hole(nose), hole(mirrored(grin)))
    turns = [math.pi * (k / 12 - 0.5) for k in range(13)]
    core = lathe([(wide * (0.85 + 0.74 * math.cos(a)), high * (1 + 0.9 * math.sin(a)))
                  for a in turns])  # fmt: skip
    stalk = limb([(0, 0, high * 1.75), (0.02, 0, high * 2 + 0.12), (lean, -0.05, high * 2 + 0.34)],
                 0.19, 0.12)  # fmt: skip
    root = taper((0, 0, high * 1.86), (0.26, 0, high * 1.9), 0.1, 0.09)
    return {
        "body": cut(hull, *face),
        "stalk": join(stalk, around(5, root)),
        **{name: within(core, grown(cutter, 0.03))
           for name, cutter in zip(("eyes", "nose", "mouth"), face, strict=True)},
    }  # fmt: skip


def christmas_bauble(draw: Draw) -> Parts:
    """A glass ball, or a drop, with a band and stars about it, a cap and a loop above."""
    r, drop = draw(0.82, 0.92), draw.chance(0.35)
    z, long = r, draw(0.5, 0.66)
    high, hull = 2 * r, ball((0, 0, z), r)
    if drop:
        z, high = r + long, 2 * r + long
        hull = join(ball((0, 0, z), r), taper((0, 0, z - r * 0.2), (0, 0, 0.1), r * 0.94, 0.1))
    half, count = draw(0.15, 0.2), 8
    a = math.radians(draw(34, 40))
    star = [((0.19 if k % 2 == 0 else 0.085) * math.cos(math.tau * k / 10 + math.pi / 2),
             (0.19 if k % 2 == 0 else 0.085) * math.sin(math.tau * k / 10 + math.pi / 2))
            for k in range(10)]  # fmt: skip
    mark = moved(turned(prism(star, 0, 0.1), 1, -math.degrees(a)),
                 (r * math.cos(a) - 0.05, 0, z + r * math.sin(a)))  # fmt: skip
    b = -a
    dot = ball((r * 0.98 * math.cos(b), 0, z + r * 0.98 * math.sin(b)), 0.11)
    shell = ball((0, 0, z), r + 0.045)
    top = high + 0.14
    flutes = around(8, capsule((0.25, 0, high - 0.08), (0.25, 0, top - 0.02), 0.06))
    edge = both(ring((0, 0, half), r * math.cos(math.asin(half / r)), 0.075), 2)
    return {
        "ball": hull,
        "band": within(shell, box((0, 0, z), (2, 2, half))),
        "edges": moved(edge, (0, 0, z)),
        "stars": around(count, mark),
        "dots": around(count, dot),
        "cap": join(
            tube((0, 0, high - 0.14), (0, 0, top), 0.27, 0.03),
            flutes,
            ring((0, 0, top + 0.17), 0.17, 0.075, axis=1),
        ),
    }


def wreath(draw: Draw) -> Parts:
    """Upright: a ring of pointed leaves, golden balls, berries in threes, a bow below or above."""
    major, minor, long = draw(0.82, 0.88), draw(0.25, 0.28), draw(0.36, 0.42)
    y = -major if draw.chance(0.6) else major
    low = -90 if y < 0 else 90

    def sprigs(count: int, up: float, thick: float, *tips: tuple[float, float]) -> Solid:
        """Pointed leaves, each to so far from the ring's middle line and over its plane."""
        step, leaves = math.tau / count, []
        for k in range(count):
            a = low / 180 * math.pi + step * (k + 0.5)
            root = (major * math.cos(a), major * math.sin(a), up)
            for out, high in tips:
                b, far = a + 0.34, major + out
                leaves.append(taper(root, (far * math.cos(b), far * math.sin(b), high), thick, 0.1))
        return join(*leaves)

    def spot(turn: float, out: float, up: float, radius: float) -> Solid:
        a = math.radians(low + turn)
        return ball(((major + out) * math.cos(a), (major + out) * math.sin(a), up), radius)

    def cluster(turn: float) -> Solid:
        trio = ((-9, -0.06), (9, -0.06), (0, 0.15))
        return join(*(spot(turn + da, out, minor + 0.02, 0.15) for da, out in trio))

    loop = smooth_curve([(0.0, 0.08), (0.3, 0.3), (0.58, 0.3), (0.68, 0.02), (0.56, -0.22),
                         (0.28, -0.18), (0.0, -0.08)])  # fmt: skip
    end = [(-0.06, 0.0), (0.12, 0.0), (0.52, -0.62), (0.34, -0.6), (0.22, -0.74)]
    bow = join(
        both(grown(prism(loop, 2, 0.1), 0.05)), both(grown(prism(end, 2, 0.06, -0.02), 0.04))
    )

    def facing(solid: Solid) -> Solid:
        return tilted(solid, 90, (0, 0, major + minor + 0.25))

    return {
        "leaves": facing(
            join(ring((0, 0, 0), major, minor), sprigs(16, 0.0, 0.2, (long, 0.0), (-0.34, 0.0)))
        ),
        "tips": facing(sprigs(8, minor - 0.08, 0.2, (0.2, minor), (-0.18, minor))),
        "berries": facing(join(*(cluster(turn) for turn in (-90, 90, 180)))),
        "baubles": facing(
            join(*(spot(turn, 0, minor + 0.02, 0.22) for turn in (-135, -45, 45, 135)))
        ),
        "bow": facing(moved(bow, (0, y, minor + 0.14))),
        "knot": facing(egg((0, y, minor + 0.22), (0.19, 0.17, 0.17))),
    }  # fmt: skip


def basket(draw: Draw) -> Parts:
    """A woven basket with a high handle."""
    r, high = draw(0.75, 0.9), draw(0.65, 0.85)
    body = cut(
        lathe([(r * 0.72, 0), (r, high)], 0.02), lathe([(r * 0.56, 0.14), (r * 0.86, high + 0.2)])
    )
    return {
        "body": body,
        "handle": cut(ring((0, 0, high), r * 0.94, 0.1, 1), box((0, 0, high - 1.1), (2, 2, 1))),
        "rim": ring((0, 0, high), r * 0.94, 0.12),
    }


def umbrella(draw: Draw) -> Parts:
    """Open: a canopy, a stick, a crook."""
    r, top, crook = draw(1.1, 1.3), draw(1.7, 1.9), 0.2
    dome = cut(egg((0, 0, top - 0.6), (r, r, 0.85)), box((0, 0, top - 2.55), (3, 3, 2.0)))
    dome = cut(dome, egg((0, 0, top - 0.72), (r - 0.1, r - 0.1, 0.8)))
    hook = cut(ring((crook, 0, 0.1), crook, 0.09, 1), box((0, 0, 2.1), (3, 3, 2.0)))
    return {
        "canopy": dome,
        "stick": capsule((0, 0, 0.1), (0, 0, top + 0.35), 0.09),
        "handle": join(hook, capsule((0, 0, 0.1), (0, 0, 0.45), 0.1)),
    }


def pawn(draw: Draw) -> Parts:
    """A pawn of chess."""
    r, high = draw(0.6, 0.7), draw(1.4, 1.65)
    side = smooth_curve([(r * 0.85, 0.25), (r * 0.5, 0.55), (0.24, 1.0), (0.3, high - 0.05)])
    return {
        "body": join(lathe(side, 0.01), ball((0, 0, high + 0.3), draw(0.38, 0.44))),
        "base": lathe([(r, 0.0), (r, 0.16), (r * 0.82, 0.3)], 0.03),
        "collar": tube((0, 0, high - 0.1), (0, 0, high + 0.05), r * 0.7, 0.05),
    }


def gumball_machine(draw: Draw) -> Parts:
    """A globe full of balls on a red foot, with a knob to turn and a flap where they come out."""
    r, high, foot = draw(0.66, 0.74), draw(0.86, 1.0), draw(0.52, 0.6)
    z, size, neck = high + r * 0.86, draw(0.17, 0.2), draw(0.4, 0.44)
    stand = [(foot, 0.0), (foot, 0.12), (neck, 0.2), (neck - 0.03, high * 0.6), (neck, high - 0.1)]
    stand += [(r * 0.76, high + 0.02), (r * 0.76, high + 0.12)]
    top = z + r
    lid = [(0.4, top - 0.12), (0.42, top - 0.02), (0.3, top + 0.1), (0.0, top + 0.16)]
    colors: list[list[Solid]] = [[], [], []]
    count, first = 58, draw.arranged(3)(0, math.tau)
    for k in range(count):
        up = 1 - 2 * (k + 0.5) / count
        if -0.74 < up < 0.8:
            flat, turn = math.sqrt(1 - up * up), first + k * math.pi * (3 - math.sqrt(5))
            x, y = flat * math.cos(turn), flat * math.sin(turn)
            colors[k % 3].append(ball((r * x, r * y, z + r * up), size))
    face, at = -neck + 0.02, high * 0.58
    bar = turned(box((0, 0, 0), (0.22, 0.14, 0.075), 0.03), 1, draw(-40, 40))
    chute = [(-0.19, 0.14), (0.19, 0.14), (0.19, at - 0.3), (-0.19, at - 0.3)]
    reds, blues, yellows = (join(*some) for some in colors)
    return {
        "base": join(lathe(stand), lathe(lid, 0.02), ball((0, 0, top + 0.2), 0.11)),
        "globe": ball((0, 0, z), r + 0.03),
        "gumballs": reds,
        "sweets": blues,
        "candies": yellows,
        "knob": join(
            tube((0, face - 0.1, at), (0, 0, at), 0.22, 0.03),
            moved(bar, (0, face - 0.12, at)),
            prism(chute, 1, 0.12, face),
        ),
    }


GIFTS_AND_DECORATIONS = {
    "gift": gift,
    "balloon": balloon,
    "paper lantern": paper_lantern,
    "jack-o-lantern": jack_o_lantern,
    "christmas bauble": christmas_bauble,
    "wreath": wreath,
    "basket": basket,
    "umbrella": umbrella,
    "pawn": pawn,
    "gumball machine": gumball_machine,
}
