"""Sundries: from the wine glass to the mimic, a chest that bites."""

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


def wine_glass(draw: Draw) -> Parts:
    """A wide bowl half full of red wine, open above, on a slender stem and a flat foot."""
    r, low, high = draw(0.76, 0.82), draw(1.26, 1.34), draw(1.36, 1.46)
    foot, wall = draw(0.66, 0.71), 0.13
    side = [(0.1, 0.0), (r * 0.7, high * 0.16), (r, high * 0.5), (r * 0.96, high * 0.76),
            (r * 0.86, high)]  # fmt: skip
    outer = [(u, low + v) for u, v in smooth_curve(side)]
    fill, top = low + high * 0.58, low + high
    inner = [(u - wall, v) for u, v in outer if v > fill - 0.1]
    hollow = lathe([*inner, (inner[-1][0], top + 1)])
    return {
        "bowl": within(cut(lathe(outer), hollow), box((0, 0, fill + 2), (2, 2, 2))),
        "liquid": within(lathe(outer), box((0, 0, fill - 2), (2, 2, 2))),
        "stem": lathe([(0.24, 0.06), (0.11, 0.3), (0.1, low - 0.16), (0.26, low + 0.08)], 0.01),
        "foot": lathe([(foot, 0), (foot, 0.1), (0.2, 0.2)], 0.01),
    }


def katana(draw: Draw) -> Parts:
    """A slender curved blade, its tip up, the cutting edge bright; a round guard, a long grip
    wrapped in lozenges."""
    high, wide, bow = draw(2.2, 2.32), draw(0.165, 0.175), draw(0.4, 0.46)
    low, r = draw(0.84, 0.92), draw(0.075, 0.082)

    def line(aside: float, end: float) -> list[tuple[float, float]]:
        """Along the blade, ``aside`` of its width from its back, to a part of its length."""
        stops = [end * k / 8 for k in range(9)]
        return [(wide * (0.5 - aside) + bow * v * v, high * v) for v in stops]

    spine, ridge, sharp = line(0, 1), line(0.55, 0.9), line(1, 0.84)
    lozenge = prism([(-0.07, 0), (0, -0.13), (0.07, 0), (0, 0.13)], 1, r + 0.03)
    return {
        "blade": prism([*spine, *reversed(ridge)], 1, 0.06),
        "edge": prism([*ridge, spine[-1], *reversed(sharp)], 1, 0.045),
        "guard": tube((0, 0, -0.065), (0, 0, 0.065), draw(0.24, 0.26), 0.02),
        "grip": tube((0, 0, -low), (0, 0, 0), r),
        "lozenges": join(*(moved(lozenge, (0, 0, -low * k)) for k in (0.22, 0.53, 0.84))),
        "pommel": join(
            tube((0, 0, -low - 0.12), (0, 0, -low + 0.02), r + 0.03, 0.03),
            tube((0, 0, 0.02), (0, 0, 0.17), r + 0.03, 0.02),
        ),
    }


def _star(center: tuple[float, float], radius: float, inner: float) -> list[tuple[float, float]]:
    """A star of five points, one up."""
    x, z = center
    turns = [(math.pi / 2 + math.pi * k / 5, inner if k % 2 else radius) for k in range(10)]
    return [(x + r * math.cos(a), z + r * math.sin(a)) for a, r in turns]


def magic_wand(draw: Draw) -> Parts:
    """A dark rod with golden bands, at its tip a big star or a crystal."""
    high, r, foot = draw(1.9, 2.05), draw(0.1, 0.11), draw(0.15, 0.165)
    grip = draw(0.62, 0.7)
    if draw.chance(0.5):
        size = draw(0.52, 0.56)
        tip = grown(prism(_star((0, high + size * 0.62), size, size * 0.48), 1, 0.1), 0.04)
    else:
        size = draw(0.3, 0.34)
        tip = around(
            6,
            prism(
                [
                    (-0.1, high),
                    (0.15, high),
                    (size, high + 0.42),
                    (0.02, high + 1.0),
                    (-0.1, high + 1.0),
                ],
                1,
                size * 0.577,
            ),
        )
    return {
        "shaft": taper((0, 0, 0.2), (0, 0, high), r + 0.02, r),
        "grip": tube((0, 0, 0.1), (0, 0, grip), foot, 0.03),
        "bands": join(
            *(tube((0, 0, v - 0.08), (0, 0, v + 0.08), foot + 0.06, 0.03) for v in (0.1, grip)),
            tube((0, 0, high - 0.16), (0, 0, high + 0.06), r + 0.1, 0.03),
        ),
        "tip": tip,
    }


def dynamite(draw: Draw) -> Parts:
    """Seven red sticks in a bundle, a black band about it, the fuses run together and burn."""
    r, high = draw(0.29, 0.31), draw(1.8, 1.95)
    out, hull = 2 * r, 3 * r
    stick = tube((0, 0, 0), (0, 0, high), r, 0.03)
    end = tube((0, 0, high - 0.03), (0, 0, high + 0.1), r - 0.06, 0.02)
    lead = limb([(out, 0, high + 0.05), (out * 0.75, 0, high + 0.32), (0.1, 0, high + 0.5)],
                0.085, 0.085)  # fmt: skip
    main = [(0, 0, high), (0, 0, high + 0.55), (0.14, 0, high + 0.78), (0.4, 0, high + 0.86),
            (0.56, 0, high + 1.02)]  # fmt: skip
    corners = [
        (hull * math.cos(a), hull * math.sin(a)) for a in (math.tau * k / 6 for k in range(6))
    ]
    wrap = grown(prism([(u * 0.66, v * 0.66) for u, v in corners], 2, draw(0.15, 0.17), high / 2),
                 r + 0.05)  # fmt: skip
    return {
        "sticks": join(stick, around(6, moved(stick, (out, 0, 0)))),
        "ends": join(end, around(6, moved(end, (out, 0, 0)))),
        "band": within(wrap, box((0, 0, high / 2), (2, 2, 0.26))),
        "fuses": join(around(6, lead), limb(main, 0.1, 0.09)),
        "spark": join(
            ball((0.58, 0, high + 1.06), 0.15),
            *(
                moved(turned(capsule((0, 0, 0), (0, 0, 0.26), 0.075), 1, a), (0.58, 0, high + 1.06))
                for a in (-60, 0, 60, 120, 180)
            ),
        ),
    }


def handcuffs(draw: Draw) -> Parts:
    """Two steel rings side by side, the locks at their inner sides joined by a short chain."""
    r, deep, z = draw(0.46, 0.49), draw(0.15, 0.165), 0.6
    x = 1.02

    def hoop(radius: float, half: float) -> Solid:
        return tube((x, -half, z), (x, half, z), radius, 0.02)

    cheek = both(cut(tube((x, -deep - 0.08, z), (x, deep + 0.08, z), r + 0.05, 0.02),
                     tube((x, -1, z), (x, 1, z), r - 0.13)), 0)  # fmt: skip
    lower = within(cheek, box((0, 0, z - 1), (2, 2, 1)))
    lock = box((x - r - 0.03, 0, z), (0.19, deep + 0.1, 0.27), 0.06)
    hole = join(
        tube((x - r - 0.03, -deep - 0.15, z + 0.06), (x - r - 0.03, 0, z + 0.06), 0.1),
        box((x - r - 0.03, -deep - 0.02, z - 0.07), (0.06, 0.13, 0.13)),
    )
    link = ring((0, 0, z), 0.17, 0.085, 1)
    return {
        "rings": both(cut(hoop(r + 0.1, deep), hoop(r - 0.13, 1))),
        "cheeks": lower,
        "locks": both(lock),
        "chain": join(link, both(ring((0.26, 0, z), 0.16, 0.085, 2))),
        "keyholes": both(hole),
    }


def crystal_ball(draw: Draw) -> Parts:
    """A big ball of glass held by four golden claws, on a turned foot."""
    r, low = draw(0.84, 0.9), draw(0.6, 0.66)
    z = low + r + 0.06
    wide = draw(0.78, 0.84)
    base = lathe([(wide, 0.06), (wide, 0.16), (wide * 0.72, 0.24), (0.34, 0.4), (0.34, low - 0.1),
                  (0.5, low + 0.1), (0.3, low + 0.16)], 0.03)  # fmt: skip
    claw = limb([(0.36, 0, low - 0.14), (r * 0.82, 0, low + 0.06), (r + 0.07, 0, z - r * 0.36),
                 (r + 0.08, 0, z + 0.08)], 0.13, 0.085)  # fmt: skip
    curl = ball((r + 0.12, 0, z + 0.1), 0.125)
    return {
        "ball": ball((0, 0, z), r),
        "stand": base,
        "claws": around(4, join(claw, curl), 45),
        "bands": join(
            ring((0, 0, 0.13), wide, 0.1), ring((0, 0, low - 0.04), 0.36, 0.1),
            around(4, egg((wide - 0.04, 0, 0.12), (0.22, 0.17, 0.14)), 45),
        ),
        "glints": join(
            egg((-r * 0.42, -r * 0.72, z + r * 0.42), (0.17, 0.15, 0.2)),
            ball((r * 0.42, -r * 0.8, z - r * 0.3), 0.1),
        ),
    }  # fmt: skip


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


def bullet(draw: Draw) -> Parts:
    """A cartridge that stands: a rim and a groove, a straight brass case, a pointed copper tip."""
    r, case, tip = draw(0.42, 0.45), draw(1.6, 1.7), draw(1.14, 1.24)
    neck, first = r * 0.86, 0.42
    curve = [(neck * (1 - (k / 12) ** 2.1), case + tip * k / 12) for k in range(12)]
    return {
        "case": lathe(
            [(r * 0.7, first - 0.12), (r, first), (r, case - 0.24), (r * 0.9, case - 0.02)], 0.01
        ),
        "tip": lathe([(neck, case - 0.1), *curve, (0.02, case + tip)], 0.01),
        "rim": join(
            lathe([(r - 0.02, 0.01), (r + 0.06, 0.06), (r + 0.06, 0.18), (r - 0.02, 0.22)], 0.01),
            tube((0, 0, 0.1), (0, 0, first), r * 0.74),
        ),
        "band": tube((0, 0, case - 0.16), (0, 0, case + 0.04), neck + 0.06, 0.03),
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


def slime(draw: Draw) -> Parts:
    """A blob of jelly that runs up to a curled tip, a puddle of drips about its foot, big eyes and
    a smile."""
    r, high = draw(1.0, 1.06), draw(1.66, 1.76)
    side = [(r * 0.9, 0.0), (r, 0.28), (r * 0.98, 0.6), (r * 0.78, 1.1), (r * 0.42, high - 0.2),
            (0.12, high)]  # fmt: skip
    curl = limb([(0, 0, high - 0.4), (0.02, 0, high), (0.1, 0, high + 0.26),
                 (0.26, 0, high + 0.4)], 0.42, 0.11)  # fmt: skip
    z, x, y = 0.84, draw(0.36, 0.4), -r * 0.84
    smile = [(u, -r - 0.01 + 0.36 * u * u, 0.32 + 0.5 * u * u)
             for u in (-0.44, -0.22, 0, 0.22, 0.44)]  # fmt: skip
    return {
        "body": blend(0.16, lathe(smooth_curve(side, 6)), curl),
        "drips": join(
            around(8, egg((r * 0.96, 0, 0.1), (0.36, 0.3, 0.15)), 22.5),
            tube((0, 0, 0), (0, 0, 0.2), r, 0.08),
        ),
        "eyes": both(egg((x, y, z), (0.28, 0.22, 0.34))),
        "pupils": both(egg((x - 0.03, y - 0.15, z - 0.02), (0.16, 0.14, 0.22))),
        "mouth": limb(smile, 0.1, 0.1),
        "glints": join(
            egg((-r * 0.54, -r * 0.3, 1.22), (0.13, 0.12, 0.17)),
            both(ball((x + 0.04, y - 0.26, z + 0.11), 0.085)),
        ),
    }


def mimic(draw: Draw) -> Parts:
    """A treasure chest whose lid is a gaping mouth: rows of teeth, a long tongue, eyes on it."""
    x, y, low = draw(1.0, 1.08), draw(0.66, 0.72), draw(0.7, 0.76)
    angle, at, wall = draw(-46, -42), (0.0, y - 0.02, low - 0.02), 0.16

    def lidded(solid: Solid) -> Solid:
        """What is made as on a closed lid whose hinge is the origin, opened."""
        return tilted(solid, angle, at)

    def barrel(half: float, radius: float) -> Solid:
        return within(tube((-half, -y, 0), (half, -y, 0), radius, 0.02), box((0, 0, 1), (2, 3, 1)))

    lid = cut(barrel(x, y), barrel(x - wall, y - wall))
    hollow = box((0, 0, low + 0.3), (x - wall, y - wall, low))
    gums = join(
        box((0, 0, low * 0.66), (x - 0.1, y - 0.1, 0.1)),
        lidded(moved(barrel(x - 0.1, y - 0.1), (0, 0, 0.06))),
    )
    stops = [x * k for k in (-0.8, -0.4, 0, 0.4, 0.8)]
    fang = taper((0, 0, -0.06), (0, 0, 0.24), 0.165, 0.08)
    lower = [moved(fang, (u, -y + 0.1, low)) for u in stops if abs(u) > 0.1]
    upper = [moved(turned(fang, 0, 180), (u, -2 * y + 0.1, 0.02)) for u in stops]
    tongue = [(0, 0.2, low - 0.06), (0, -y + 0.1, low + 0.16), (0, -y - 0.26, low - 0.06),
              (0, -y - 0.36, 0.42), (0, -y - 0.52, 0.14)]  # fmt: skip
    band = join(*(moved(barrel(0.11, y + 0.07), (u, 0, 0)) for u in (-x * 0.66, x * 0.66)))
    look = both(egg((x * 0.34, -2 * y + 0.3, y * 0.92), (0.25, 0.25, 0.25)))
    slit = both(egg((x * 0.34, -2 * y + 0.1, y * 0.96), (0.09, 0.1, 0.17)))
    return {
        "body": join(cut(box((0, 0, low / 2), (x, y, low / 2), 0.02), hollow), lidded(lid)),
        "bands": join(
            both(cut(box((x * 0.66, 0, low / 2), (0.11, y + 0.07, low / 2)), hollow)),
            lidded(cut(band, barrel(3, y - 0.04))),
        ),
        "teeth": join(*lower, lidded(join(*upper))),
        "tongue": limb(tongue, 0.2, 0.25),
        "eyes": lidded(look),
        "mouth": join(gums, lidded(slit)),
    }


def mop(draw: Draw) -> Parts:
    """A long handle, a clamp, and a skirt of thick white strands that spreads on the floor."""
    high, r, reach = draw(2.9, 3.05), 0.1, draw(0.62, 0.68)
    top = 0.84
    strand = limb([(0.1, 0, top - 0.06), (0.34, 0, top - 0.16), (reach * 0.8, 0, 0.42),
                   (reach, 0, 0.14)], 0.13, 0.145)  # fmt: skip
    inner = limb([(0.1, 0, top - 0.1), (0.24, 0, 0.5), (0.32, 0, 0.12)], 0.14, 0.13)
    return {
        "handle": tube((0, 0, top), (0, 0, high), r, 0.03),
        "clamp": lathe(
            [(0.36, top - 0.1), (0.36, top + 0.06), (0.18, top + 0.16), (0.17, top + 0.34)], 0.02
        ),
        "strands": join(around(9, strand), around(6, inner)),
        "cap": tube((0, 0, high - 0.34), (0, 0, high + 0.04), r + 0.04, 0.05),
    }


SUNDRIES = {
    "wine glass": wine_glass,
    "katana": katana,
    "magic wand": magic_wand,
    "dynamite": dynamite,
    "handcuffs": handcuffs,
    "crystal ball": crystal_ball,
    "stone cross": cross,
    "brick block": brick,
    "bullet": bullet,
    "rainbow arch": rainbow,
    "slime": slime,
    "mimic": mimic,
    "mop": mop,
}
