"""Treasure and gear of games and stories."""

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
    join,
    lathe,
    limb,
    moved,
    prism,
    ring,
    smooth_curve,
    taper,
    tube,
    turned,
)
from core.prior.things.arms import flattened


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


def compass(draw: Draw) -> Parts:
    """Upright like a pocket watch, its dial to the front, the needle's red end to the north."""
    r, y, rim = draw(0.95, 1.05), draw(0.17, 0.22), draw(0.16, 0.2)
    long, wide, lean = r * draw(0.58, 0.66), draw(0.17, 0.21), draw(24, 36)
    z = r + rim
    half = [(-wide, 0), (wide, 0), (0, long)]
    red, pale = (
        moved(turned(prism(half, 1, 0.12, -y), 1, lean + turn), (0, 0, z)) for turn in (0, 180)
    )
    mark = box((0, -y + 0.04, r - 0.2), (0.07, 0.09, 0.1))
    return {
        "case": moved(
            join(
                tube((0, -y + 0.1, 0), (0, y, 0), r + rim, 0.03),
                ring((0, -y, 0), r + rim - 0.13, 0.13, 1),
            ),
            (0, 0, z),
        ),
        "dial": tube((0, -y + 0.02, z), (0, y - 0.1, z), r - 0.02),
        "needle": red,
        "tail": pale,
        "marks": moved(join(*(turned(mark, 1, 90 * k) for k in range(4))), (0, 0, z)),
        "loop": join(
            tube((0, 0, 2 * z - 0.1), (0, 0, 2 * z + 0.16), 0.16, 0.02),
            ring((0, 0, 2 * z + 0.36), draw(0.23, 0.27), 0.1, 1),
        ),
    }


def ingot(draw: Draw) -> Parts:
    """A bar of cast metal along x, narrower at its top, with a raised stamp."""
    x, y, high, slope = draw(1.25, 1.45), draw(0.5, 0.6), draw(0.46, 0.56), draw(0.16, 0.22)
    long = prism([(-x, 0), (x, 0), (x - slope, high), (slope - x, high)], 1, y)
    across = prism([(-y, 0), (y, 0), (y - slope, high), (slope - y, high)], 0, x)
    wide, deep = x * draw(0.5, 0.58), (y - slope) * 0.62
    return {
        "bar": lambda p: long(p).maximum(across(p)),
        "stamp": box((0, 0, high), (wide, deep, 0.08), 0.02),
    }


def brazier(draw: Draw) -> Parts:
    """A bowl of embers on three legs, in flames."""
    r, high, leg = draw(0.68, 0.78), draw(0.85, 1.0), draw(0.56, 0.68)
    flame, wide = draw(1.05, 1.25), draw(0.38, 0.44)
    top = high + 0.36
    tongue = [(wide * 0.7, top - 0.1), (wide, top + 0.24), (wide * 0.5, top + flame * 0.62)]
    small = [(0.14, top - 0.1), (0.19, top + 0.14), (0.1, top + 0.36), (0.02, top + draw(0.5, 0.6))]
    foot = leg + 0.08
    return {
        "bowl": lathe(smooth_curve([(0.2, high - 0.16), (r * 0.66, high - 0.02), (r, top)]), 0.02),
        "rim": ring((0, 0, top), r, 0.1),
        "legs": join(
            around(3, taper((0.2, 0, high), (foot, 0, 0.11), 0.11, 0.11), -90),
            ring((0, 0, high * 0.42), leg * 0.68, 0.09),
        ),
        "embers": tube((0, 0, top - 0.1), (0, 0, top + 0.06), r - 0.08),
        "flame": lathe(smooth_curve([*tongue, (0.02, top + flame)])),
        "tongues": around(5, lathe(smooth_curve(small), 0.0, (r * 0.62, 0)), -90),
    }


def necklace(draw: Draw) -> Parts:
    """Upright, a round string of beads; a cut stone in a setting hangs from it."""
    r, wide, bead = draw(0.82, 0.92), draw(0.33, 0.4), draw(0.115, 0.13)
    z, count = 2 * wide + 0.34 + r, 16
    stone = around(8, prism([(0, 0), (0.25, 0), (0.25, 0.14), (0.15, 0.27), (0, 0.27)], 1, 2), 22.5)
    eye = wide * 0.99
    beads = around(count, ball((r, 0, 0), bead), 90 + 180 / count)
    return {
        "chain": ring((0, 0, z), r, 0.085, 1),
        "beads": moved(turned(beads, 0, 90), (0, 0, z)),
        "setting": join(
            tube((0, -0.13, eye), (0, 0.13, eye), wide, 0.03),
            tube((0, 0, 2 * wide - 0.05), (0, 0, z - r + 0.05), 0.12, 0.02),
        ),
        "stone": moved(turned(stone, 0, 90), (0, -0.02, eye)),
        "bail": ring((0, 0, z - r), 0.15, 0.09, 0),
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


def sack(draw: Draw) -> Parts:
    """Full, tied with rope below its ruffled mouth, a patch in front."""
    r, high, deep = draw(0.78, 0.88), draw(1.25, 1.4), draw(0.8, 0.9)
    neck, mouth = draw(0.24, 0.29), draw(0.42, 0.5)
    side = [(r * 0.8, 0.0), (r, 0.22), (r * 1.02, 0.5), (r * 0.72, high * 0.78), (neck, high)]
    body = flattened(lathe(smooth_curve(side)), deep)
    grown = flattened(lathe([(a + 0.07, b) for a, b in smooth_curve(side)]), deep)
    patch = box((0, -1, 0.52), (draw(0.28, 0.34), 1, 0.27), 0.02)
    fold = taper((neck - 0.08, 0, high - 0.02), (mouth - 0.08, 0, high + 0.34), 0.14, 0.16)
    return {
        "body": body,
        "mouth": join(lathe([(neck, high - 0.04), (mouth, high + 0.3)]), around(8, fold, 22.5)),
        "rope": join(
            ring((0, 0, high), neck + 0.05, 0.1),
            both(capsule((0.06, -neck - 0.08, high), (0.2, -neck - 0.16, high - 0.28), 0.09)),
        ),
        "patch": lambda p: patch(p).maximum(grown(p)),
    }


def coffin(draw: Draw) -> Parts:
    """Upright on its foot, six-sided, its lid to the front with a cross on it."""
    high, wide, foot = draw(2.4, 2.6), draw(0.66, 0.76), draw(0.36, 0.44)
    head, deep = draw(0.4, 0.48), draw(0.3, 0.38)
    shoulder = high * draw(0.68, 0.73)

    def board(grow: float, y: float, thick: float) -> Solid:
        half = [(foot + grow, -grow), (wide + grow, shoulder), (head + grow, high + grow)]
        return prism([*half, *((-a, b) for a, b in reversed(half))], 1, thick, y)

    cross = join(
        box((0, 0, high * 0.6), (0.1, 0.1, high * 0.24), 0.02),
        box((0, 0, high * 0.67), (0.34, 0.1, 0.1), 0.02),
    )
    grip = join(*(tube((0, 0, z - 0.16), (0, 0, z + 0.16), 0.1) for z in (0.9, 1.5)))
    lean = 6
    return {
        "body": board(0, 0.04, deep),
        "lid": board(0.09, -deep - 0.04, 0.1),
        "panel": board(-0.12, -deep - 0.14, 0.08),
        "cross": moved(cross, (0, -deep - 0.24, 0)),
        "handles": both(moved(turned(grip, 1, lean), (foot + 0.08, 0, 0))),
        "edge": board(0.09, deep - 0.02, 0.1),
    }


def anchor(draw: Draw) -> Parts:
    """Upright: a ring, a stock, a shank and two curved arms with flukes."""
    high, reach, r = draw(1.95, 2.15), draw(0.95, 1.1), draw(0.12, 0.14)
    bar, hole = draw(0.56, 0.66), draw(0.22, 0.27)
    z = reach + r  # the centre of the arms' half circle
    rise = 0.25 * reach
    arms = cut(ring((0, 0, z), reach, r, 1), box((0, 0, z - rise + 3), (3, 3, 3)))
    out, up = reach * 0.97, z - rise
    fluke = [
        (out - 0.42, up - 0.1),
        (out + 0.02, up + 0.42),
        (out + 0.3, up - 0.22),
        (out, up - 0.16),
    ]
    return {
        "shank": taper((0, 0, r + 0.02), (0, 0, high), r * 1.1, r * 0.95),
        "arms": arms,
        "flukes": both(prism(fluke, 1, 0.15)),
        "stock": join(
            tube((-bar, 0, high - 0.28), (bar, 0, high - 0.28), r),
            both(ball((bar, 0, high - 0.28), r + 0.05)),
        ),
        "ring": ring((0, 0, high + hole + 0.02), hole, 0.1, 1),
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


FANTASY = {
    "crystal": crystal,
    "compass": compass,
    "ingot": ingot,
    "brazier": brazier,
    "necklace": necklace,
    "feather": feather,
    "sack": sack,
    "coffin": coffin,
    "anchor": anchor,
    "hay bale": hay_bale,
    "beehive": beehive,
}
