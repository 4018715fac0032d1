"""The sky and the season as signs: each upright, its face to the front."""

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
    moved,
    prism,
    taper,
    tilted,
    turned,
)


def _facing(solid: Solid, z: float) -> Solid:
    """``solid``, made flat on the ground, its top turned to the front, its middle at height z."""
    return tilted(solid, 90, (0, 0, z))


def cloud(draw: Draw) -> Parts:
    """Heaped balls with a flat base."""
    r, side, far = draw(0.66, 0.76), draw(0.5, 0.58), draw(0.66, 0.76)
    tail, out = draw(0.34, 0.4), draw(1.12, 1.25)
    ground = box((0, 0, -2), (3, 3, 2))
    puffs = join(both(ball((far, 0, 0.44), side)), both(ball((0, 0.36, 0.38), draw(0.44, 0.5)), 1))
    ends = join(
        both(ball((out, 0, 0.24), tail)), both(ball((0.5, 0.4, 0.26), draw(0.36, 0.42)), 0, 1)
    )
    return {
        "middle": cut(ball((0, 0, 0.78), r), ground),
        "puffs": cut(puffs, ground),
        "ends": cut(ends, ground),
    }


def sun(draw: Draw) -> Parts:
    """A disc that bulges, with eight long rays and eight short ones."""
    r, deep, gap = draw(0.66, 0.74), draw(0.3, 0.36), 0.1
    long, short, wide = draw(1.35, 1.45), draw(1.02, 1.12), draw(0.2, 0.24)

    def rays(reach: float, half: float, first: float) -> Solid:
        ray = prism([(r - gap, -half), (reach, -0.02), (reach, 0.02), (r - gap, half)], 2, 0.11)
        return _facing(around(8, ray, first), long)

    return {
        "disc": egg((0, 0, long), (r, deep, r)),
        "rays": rays(long, wide, 0),
        "glints": rays(short, wide * 0.8, 22.5),
    }


def leaf(draw: Draw) -> Parts:
    """A maple leaf on its stalk, with veins."""
    x, z, low = draw(1.15, 1.3), draw(1.05, 1.15), draw(0.55, 0.7)
    half = [(0.08, 0.42), (0.56, 0.34), (0.52, 0.54), (1.03, 0.96), (0.9, 1.1), (1.0, 1.44)]
    half += [(0.7, 1.38), (0.6, 1.52), (0.34, 1.22), (0.44, 1.76), (0.22, 1.64), (0.0, 2.05)]
    half = [(a * x, (b - 0.4) * z + low) for a, b in half]
    outline = [*half, *((-a, b) for a, b in reversed(half[:-1]))]
    y = -0.08

    def vein(u: float, v: float) -> Solid:
        return taper((0, y, low + 0.06), (u * x, y, (v - 0.4) * z + low), 0.09, 0.07)

    return {
        "blade": prism(outline, 1, draw(0.1, 0.12)),
        "veins": join(vein(0, 1.72), both(join(vein(0.76, 1.2), vein(0.36, 0.5)))),
        "stalk": capsule((0, 0, 0.1), (0, 0, low + 0.1), 0.1),
    }


def snowflake(draw: Draw) -> Parts:
    """Six arms with two pairs of branches each, about a star."""
    reach, thin, thick = draw(1.3, 1.42), draw(0.085, 0.1), draw(0.1, 0.13)
    outer, inner = draw(0.28, 0.36), draw(0.26, 0.32)

    def branch(at: float, long: float) -> Solid:
        bar = moved(turned(box((long / 2, 0, 0), (long / 2, thin, thick)), 2, 60), (at, 0, 0))
        return both(bar, 1)

    arm = box((reach / 2, 0, 0), (reach / 2, thin, thick))
    pairs = join(branch(reach * 0.78, outer), branch(reach * 0.48, inner))
    star = [(0, 0.0), (0.36, 0.0), (0.26, 0.16), (0, 0.16)]
    plate = around(6, prism([*star, *((a, -b) for a, b in reversed(star))], 1, 2), 0)
    return {
        "arms": _facing(around(6, arm, 30), reach),
        "branches": _facing(around(6, pairs, 30), reach),
        "middle": _facing(plate, reach),
    }


SKY = {"cloud": cloud, "sun": sun, "leaf": leaf, "snowflake": snowflake}
