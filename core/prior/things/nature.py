"""Crystals, feathers, leaves, and what is in the sky."""

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
    Vector,
    around,
    ball,
    both,
    box,
    capsule,
    cut,
    egg,
    join,
    lathe,
    limb,
    moved,
    prism,
    ring,
    taper,
    tilted,
    tube,
    turned,
)


def _six_sided(at: Vector, radius: float, high: float, lean: Vector) -> Solid:
    """A six-sided crystal with a pointed top, leant about x, then y, turned about z (degrees)."""
    side = [(0, 0), (radius, 0), (radius * 1.1, high - radius * 1.9), (0, high)]
    stone = around(6, prism(side, 1, 2), 30)
    for axis, degrees in enumerate(lean):
        stone = turned(stone, axis, degrees)
    return moved(stone, at)


def crystal(draw: Draw) -> Parts:
    """A cluster of pointed crystals on a rock: the largest upright, others about it."""
    high, r, side = draw(1.7, 1.95), draw(0.27, 0.32), draw(1.1, 1.3)
    lean, small = draw(24, 32), draw(0.6, 0.75)
    tall = _six_sided((0, 0.1, 0.1), r, high, (0, 0, 0))
    beside = _six_sided((0.32, 0.12, 0.1), r * 0.78, side, (0, lean, 0))
    front = _six_sided((0.24, -0.3, 0.1), r * 0.66, small, (32, 20, 0))
    low = _six_sided((0.6, -0.1, 0.1), r * 0.58, small * 0.9, (10, 52, 0))
    rear = _six_sided((0.22, 0.4, 0.1), r * 0.7, small * 1.2, (-30, 14, 0))
    base = around(9, prism([(0, 0), (0.86, 0), (0.72, 0.2), (0.4, 0.34), (0, 0.34)], 1, 2), 10)
    return {
        "crystals": join(tall, both(beside)),
        "shards": both(join(front, low, rear)),
        "rock": base,
    }


def feather(draw: Draw) -> Parts:
    """Upright and a little bent, its end dark, with a bare quill below."""
    low, high, wide = draw(0.62, 0.75), draw(2.6, 2.8), draw(0.34, 0.4)
    bend, dark = draw(0.2, 0.3), draw(0.62, 0.7)

    def at(t: float, side: float) -> tuple[float, float]:
        """The height ``t`` of the vane, ``side`` from its middle; it bends to the right."""
        return side + bend * t * t, low + (high - low) * t

    right = [(0.0, 0.09), (0.12, 0.72), (0.3, 0.95), (0.36, 0.55), (0.4, 1), (0.6, 1.02)]
    left = [(0.0, 0.09), (0.1, 0.75), (0.3, 1), (0.52, 1.02), (0.56, 0.6), (0.6, 1)]
    end = [(0.8, 0.86), (0.92, 0.5), (1.0, 0.0)]
    outline = [at(t, wide * k) for t, k in [*right, *end]]
    outline += [at(t, -wide * k) for t, k in reversed([*left, *end[:-1]])]
    vane = prism(outline, 1, 0.09)
    cut_at = low + (high - low) * dark
    chevron = [(-1.5, cut_at + 0.6), (0.1, cut_at - 0.12), (1.7, cut_at + 0.6), (0.1, 9)]
    above = prism(chevron, 1, 1)
    spine = [at(t, 0) for t in (0.0, 0.3, 0.6, 0.86)]
    points = [(-0.08, 0, 0.09), *((x, 0, z) for x, z in spine)]
    return {
        "vane": cut(vane, above),
        "tip": lambda p: vane(p).maximum(above(p)),
        "shaft": limb(points, 0.1, 0.1),
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


def beehive(draw: Draw) -> Parts:
    """A skep: coils of straw, narrower towards the top, with a dark entrance; on a board."""
    r, step, count = draw(0.82, 0.92), draw(0.27, 0.3), 6
    thick = step * 0.68
    base = 0.16 + thick * 0.9
    sizes = [r * k for k in (0.92, 1.0, 0.97, 0.84, 0.62, 0.32)]
    coils = [ring((0, 0, base + step * k), sizes[k] - thick, thick) for k in range(count)]
    core = [(size - thick, base + step * k) for k, size in enumerate(sizes)]
    z, hole = base + step * 0.62, draw(0.24, 0.28)
    return {
        "coils": join(*coils[::2], lathe([(core[0][0], 0.1), *core])),
        "bands": join(*coils[1::2]),
        "knob": ball((0, 0, base + step * (count - 1) + thick + 0.02), draw(0.17, 0.21)),
        "rim": moved(ring((0, 0, 0), hole, 0.09, 1), (0, -r + 0.02, z)),
        "entrance": tube((0, -r - 0.02, z), (0, 0, z), hole),
        "board": box((0, -0.06, 0.09), (r + 0.12, r + 0.2, 0.09), 0.02),
    }


def hay_bale(draw: Draw) -> Parts:
    """A block of straw along x, tied twice; loose straws at its ends and on top."""
    x, y, z = draw(1.15, 1.3), draw(0.58, 0.68), draw(0.5, 0.58)
    count = 5
    slabs = [
        box(
            ((2 * k + 1 - count) * x / count, 0, z),
            (x / count - 0.015, y - 0.04 * (k % 2), z - 0.04 * (k % 2)),
            0.05,
        )
        for k in range(count)
    ]
    # Loose straws on top, fixed.
    over = [(-0.74, -0.5, 34), (0.0, -0.5, -28), (0.74, 0.4, 22)]
    ends = [
        moved(turned(capsule((0, -0.62, 0), (0, 0.62, 0), 0.09), 2, lean), (a * x, b * y, 2 * z))
        for a, b, lean in over
    ]
    return {
        "straw": join(box((0, 0, z), (x - 0.04, y - 0.06, z - 0.06)), *slabs),
        "twine": both(box((x * 0.44, 0, z), (0.085, y + 0.06, z + 0.06), 0.03)),
        "stalks": join(*ends),
    }


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


def _facing(solid: Solid, z: float) -> Solid:
    """``solid``, made flat on the ground, its top turned to the front, its middle at height z."""
    return tilted(solid, 90, (0, 0, z))


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


NATURE = {
    "crystal": crystal,
    "feather": feather,
    "leaf": leaf,
    "beehive": beehive,
    "hay bale": hay_bale,
    "cloud": cloud,
    "sun": sun,
    "snowflake": snowflake,
}
