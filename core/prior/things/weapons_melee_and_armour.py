"""Weapons held in the hand, armour and handcuffs."""

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
    flattened,
    join,
    lathe,
    limb,
    lozenge_blade,
    mirrored,
    moved,
    prism,
    ring,
    smooth_curve,
    taper,
    tube,
    turned,
    within,
)


def _leaf(low: float, high: float, wide: float, thick: float) -> Solid:
    """A spear's blade: a kite with a ridge, across y."""
    return lozenge_blade(low, high, wide * 0.4, thick * 0.7, (high - low) * 0.7, 2.5)


def spear(draw: Draw) -> Parts:
    """Point up: a leaf-shaped head, bound with red, a butt of metal."""
    high, long, grip = draw(2.1, 2.4), draw(0.65, 0.8), draw(0.05, 0.056)
    bound = draw(0.26, 0.36)
    return {
        "head": _leaf(high - 0.1, high + long, draw(0.17, 0.21), 0.085),
        "shaft": tube((0, 0, 0.1), (0, 0, high), grip),
        "binding": tube((0, 0, high - 0.14 - bound), (0, 0, high - 0.12), grip + 0.03, 0.02),
        "butt": lathe([(0.025, 0), (grip + 0.025, 0.2), (grip + 0.025, 0.36)]),
    }


def halberd(draw: Draw) -> Parts:
    """Upright: an axe's edge to the left, a beak to the right, a long point on top."""
    high, grip, reach, edge = draw(2.25, 2.4), 0.05, draw(0.37, 0.43), draw(0.3, 0.37)
    z, beak = high - 0.2, draw(0.3, 0.36)
    blade = [(0.05, z + 0.13), (-reach * 0.45, z + 0.15), (-reach + 0.04, z + edge)]
    blade += [(-reach - 0.02, z + edge * 0.5), (-reach - 0.04, z), (-reach - 0.03, z - edge * 0.5)]
    blade += [(-reach + 0.03, z - edge * 1.1), (-reach * 0.45, z - 0.15), (0.05, z - 0.13)]
    hook = [(0, z + 0.15), (0.13, z + 0.15), (beak, z - 0.17), (beak - 0.03, z - 0.25)]
    hook += [(0.13, z - 0.11), (0, z - 0.15)]
    return {
        "head": join(prism(blade, 1, 0.042), prism(hook, 1, 0.042)),
        "point": _leaf(high - 0.06, high + draw(0.7, 0.85), 0.1, 0.052),
        "socket": join(
            box((0, 0, z), (0.08, 0.075, 0.24), 0.02),
            tube((0, 0, z - 0.5), (0, 0, z), grip + 0.022, 0.01),
        ),
        "shaft": tube((0, 0, 0.1), (0, 0, z), grip),
        "butt": lathe([(0.025, 0), (grip + 0.022, 0.18), (grip + 0.022, 0.36)]),
    }


def mace(draw: Draw) -> Parts:
    """Upright: a ball with spikes on a short shaft."""
    r, high, long = draw(0.4, 0.46), draw(1.35, 1.55), draw(0.24, 0.3)
    z, grip = high + r * 0.9, draw(0.11, 0.125)
    spike = lathe([(0.13, r - 0.05), (0.03, r + long)], 0.02)
    tips = join(
        spike,
        around(6, turned(spike, 1, 90)),
        around(4, turned(spike, 1, 45), 45),
        around(4, turned(spike, 1, 135), 45),
    )
    return {
        "head": ball((0, 0, z), r),
        "spikes": moved(tips, (0, 0, z)),
        "shaft": tube((0, 0, 0.2), (0, 0, high + 0.1), grip),
        "collar": lathe([(grip + 0.03, high - 0.22), (grip + 0.13, high + 0.1)], 0.02),
        "grip": tube((0, 0, 0.18), (0, 0, draw(0.62, 0.75)), grip + 0.05, 0.03),
        "pommel": ball((0, 0, 0.17), 0.2),
    }


def club(draw: Draw) -> Parts:
    """Upright: wood that is thick at its top, an iron band around it, spikes or none, a grip."""
    thick, high, neck = draw(0.36, 0.42), draw(2.3, 2.5), draw(0.13, 0.15)
    side = [(neck, 0.1), (neck, high * 0.3), (thick * 0.62, high * 0.58), (thick, high * 0.82),
            (thick * 0.86, high * 0.96), (0.0, high)]  # fmt: skip
    low, up = high * 0.58, high * 0.68
    spike = turned(lathe([(0.12, thick * 0.5), (0.03, thick + draw(0.24, 0.3))], 0.02), 1, 90)
    parts = {
        "wood": lathe(smooth_curve(side)),
        "grip": tube((0, 0, 0.16), (0, 0, high * 0.27), neck + 0.05, 0.03),
        "knob": ball((0, 0, 0.14), neck + 0.09),
        "band": lathe([(thick * 0.7, low), (thick * 0.88, up)], 0.02),
    }
    if draw.has("spikes", 0.5):
        parts["spikes"] = join(
            *(moved(around(5, spike, 36 * k), (0, 0, high * (0.76 + 0.12 * k))) for k in range(2)),
            moved(lathe([(0.13, -0.1), (0.03, 0.3)], 0.02), (0, 0, high)),
        )
    return parts


def war_hammer(draw: Draw) -> Parts:
    """A huge block for a head, metal bands about both its ends, a spike on top, a long handle."""
    z, x, half = 2.22, draw(0.8, 0.85), draw(0.4, 0.43)
    r = draw(0.12, 0.13)
    face = moved(turned(lathe([(half + 0.06, 0), (half + 0.06, 0.2)], 0.02), 1, 90), (x, 0, z))
    gem = box((0, 0, 0), (0.19, 0.13, 0.19), 0.04)
    end = box((x, 0, z), (0.15, half + 0.09, half + 0.09), 0.05)
    return {
        "head": join(
            box((0, 0, z), (x + 0.05, half, half), 0.06),
            both(within(face, box((x, 0, z), (0.24, half - 0.06, half - 0.06)))),
        ),
        "bands": join(both(end), box((0, 0, z), (0.17, half + 0.06, half + 0.06), 0.04)),
        "emblem": both(moved(turned(gem, 1, 45), (0, half + 0.06, z)), 1),
        "spike": lathe([(0.26, z + half - 0.02), (0.24, z + half + 0.16), (0.06, z + half + 0.52)]),
        "handle": tube((0, 0, 0.1), (0, 0, z), r, 0.02),
        "grip": join(*(tube((0, 0, v), (0, 0, v + 0.15), r + 0.06, 0.05)
                       for v in (0.18, 0.33, 0.48, 0.63, 0.78))),
        "pommel": join(
            egg((0, 0, 0.08), (0.26, 0.26, 0.18)),
            lathe([(0.16, z - half - 0.34), (0.3, z - half - 0.1), (0.3, z - half + 0.1)], 0.01),
        ),
    }  # fmt: skip


def scythe(draw: Draw) -> Parts:
    """Upright, its curved blade at the top, to the left; two pegs to hold it."""
    high, reach, drop = draw(2.55, 2.75), draw(1.15, 1.3), draw(0.7, 0.85)
    wide, x = draw(0.34, 0.4), 0.6
    tip = (x - 0.55 - reach, high - drop)
    back = [(x + 0.12, high), (0.05, high + 0.12), (-0.65, high - 0.14), tip]
    edge = [(-0.52, high - 0.12 - wide), (0.05, high + 0.06 - wide), (x + 0.12, high - wide * 0.9)]
    curve = [*smooth_curve(back), *smooth_curve([tip, *edge])[1:]]
    peg = tube((x, 0, 0), (x - 0.42, 0, 0.06), 0.1, 0.03)
    return {
        "blade": prism(curve, 1, 0.09),
        "shaft": tube((x, 0, 0), (x, 0, high + 0.14), draw(0.105, 0.12), 0.03),
        "collar": tube((x, 0, high - wide - 0.06), (x, 0, high + 0.06), 0.18, 0.03),
        "pegs": join(moved(peg, (0, 0, 0.8)), moved(peg, (0, 0, draw(1.35, 1.5)))),
    }


def trident(draw: Draw) -> Parts:
    """Upright: three barbed prongs on a long shaft, its grip wound, a knob at its foot."""
    high, thick, wide = draw(2.85, 3.05), draw(0.05, 0.056), draw(0.26, 0.3)
    fork, tall, flat = draw(2.0, 2.12), draw(0.08, 0.16), 0.052
    low, tip = fork + 0.36, high - tall

    def point(x: float, top: float, barb: float) -> Solid:
        edge = [(x - barb, top - 0.42), (x, top), (x + barb, top - 0.42), (x + 0.045, top - 0.34)]
        return prism([*edge, (x - 0.045, top - 0.34)], 1, flat)

    bend = smooth_curve([(0.0, fork), (wide * 0.7, fork + 0.12), (wide, low), (wide, tip - 0.3)])
    outer = join(limb([(u, 0.0, v) for u, v in bend], 0.085, 0.044), point(wide, tip, 0.1))
    inner = join(taper((0, 0, fork), (0, 0, high - 0.3), 0.06, 0.048), point(0, high + 0.04, 0.11))
    grip = draw(0.8, 1.0)
    winds = [tube((0, 0, grip + 0.17 * k), (0, 0, grip + 0.17 * k + 0.1), thick + 0.026, 0.02)
             for k in range(4)]  # fmt: skip
    return {
        "head": join(both(outer), inner),
        "shaft": tube((0, 0, 0.1), (0, 0, fork), thick),
        "grip": join(tube((0, 0, grip - 0.05), (0, 0, grip + 0.66), thick + 0.012), *winds),
        "collar": join(
            lathe([(thick, fork - 0.36), (0.09, fork - 0.24), (0.07, fork - 0.12),
                   (0.1, fork - 0.02), (0.075, fork + 0.1)], 0.01),
            lathe([(0.04, 0.0), (0.085, 0.1), (0.085, 0.2), (0.06, 0.3)], 0.01),
        ),
        "gem": both(egg((0, 0.09, fork + 0.02), (0.07, 0.05, 0.12)), 1),
    }  # fmt: skip


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


def _cross(z: float, half: float) -> list[tuple[float, float]]:
    """A cross with flared arms about the height ``z``."""
    arm, root = half * 0.5, half * 0.28
    quarter = [(root, root), (arm, half), (-arm, half), (-root, root)]
    turns = ((1, 0), (0, 1), (-1, 0), (0, -1))
    return [(x * c - y * s, z + x * s + y * c) for c, s in turns for x, y in quarter[:3]]


def chestplate(draw: Draw) -> Parts:
    """A knight's breastplate: a cross on a raised plate, a collar, shoulder plates, a skirt."""
    waist, chest, high = draw(0.58, 0.63), draw(0.8, 0.86), draw(1.72, 1.82)
    deep, hem, wide = draw(0.64, 0.7), draw(0.84, 0.9), draw(0.36, 0.4)
    side = smooth_curve([(waist, 0.5), (chest * 0.94, 0.86), (chest, 1.16), (chest * 0.9, 1.46),
                         (0.46, high - 0.06), (0.4, high)])  # fmt: skip
    bust = [(0.0, 0.72), (0.44, 0.98), (0.52, 1.24), (0.42, high - 0.24), (0.22, high - 0.34),
            (0.0, high - 0.38)]  # fmt: skip

    def trunk(more: float) -> Solid:
        return flattened(lathe(side, more), deep)

    def emblem(half: float, deep: float) -> Solid:
        return within(prism(_cross(1.2, half), 1, 0.6, -0.8), trunk(deep))

    hollow = flattened(tube((0, 0, high - 0.3), (0, 0, 3), 0.3), 0.84)
    dome = cut(egg((0, 0, 0), (wide + 0.04, 0.46, 0.34)), box((0, 0, -1.0), (1, 1, 0.98)))
    lame = lathe([(0.33, -0.44), (0.27, -0.04), (0.24, 0.1)])
    skirt = [(hem, 0.0), (waist + 0.04, 0.52)]
    return {
        "plate": join(cut(trunk(0.0), hollow), flattened(lathe(skirt), deep)),
        "muscles": within(prism(mirrored(bust), 1, 1, -1.1), trunk(0.15)),
        "pauldrons": both(moved(turned(join(dome, lame), 1, 32), (chest - 0.06, 0, high - 0.34))),
        "belt": flattened(tube((0, 0, 0.4), (0, 0, 0.62), waist + 0.12, 0.03), deep),
        "crest": join(emblem(0.32, 0.29), flattened(ring((0, 0, high), 0.4, 0.1), 0.84)),
        "lining": flattened(tube((0, 0, 0.8), (0, 0, high - 0.12), 0.34), 0.84),
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


def lightsaber(draw: Draw) -> Parts:
    """Upright: a shining blade on a hilt with a black grip."""
    low, r, long = draw(0.8, 0.92), draw(0.16, 0.18), draw(1.75, 2.0)
    count = 3
    bands = [
        tube((0, 0, z), (0, 0, z + 0.1), r + 0.045, 0.02)
        for z in (0.12 + 0.18 * k for k in range(count))
    ]
    return {
        "blade": capsule((0, 0, low), (0, 0, low + long), draw(0.115, 0.13)),
        "hilt": tube((0, 0, 0.06), (0, 0, low), r),
        "grips": join(*bands),
        "emitter": lathe([(r, low - 0.14), (r + 0.08, low - 0.02), (r + 0.05, low + 0.12)], 0.02),
        "pommel": tube((0, 0, 0), (0, 0, 0.1), r + 0.04, 0.03),
        "button": box((0, -r, low - 0.24), (0.08, 0.09, 0.08), 0.02),
    }


WEAPONS_MELEE_AND_ARMOUR = {
    "spear": spear,
    "halberd": halberd,
    "mace": mace,
    "club": club,
    "war hammer": war_hammer,
    "scythe": scythe,
    "trident": trident,
    "katana": katana,
    "chestplate": chestplate,
    "handcuffs": handcuffs,
    "lightsaber": lightsaber,
}
