"""Objects that are magic, found or ancient."""

import math

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
    around,
    ball,
    both,
    box,
    capsule,
    chain,
    cut,
    egg,
    flattened,
    grown,
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


def jetpack(draw: Draw) -> Parts:
    """Two tanks side by side, their nozzles aflame; its straps are at the back."""
    r, x, low = draw(0.32, 0.37), draw(0.42, 0.47), draw(0.8, 0.9)
    long, flame = draw(1.0, 1.15), draw(0.5, 0.62)
    top = low + long
    tank = tube((x, 0, low), (x, 0, top), r, 0.03)
    nose = cut(egg((x, 0, top), (r, r, draw(0.38, 0.46))), box((x, 0, top - 1), (1, 1, 0.98)))
    horn = lathe([(r * 0.9, low - 0.3), (r * 0.5, low + 0.04)], 0.01, (x, 0))
    fire = smooth_curve(
        [(0.03, low - 0.28 - flame), (r * 0.62, low - 0.1 - flame * 0.55), (r * 0.56, low - 0.2)]
    )
    strap = join(
        capsule((x, r - 0.1, top - 0.1), (x, r + 0.2, top - 0.3), 0.1),
        capsule((x, r + 0.2, top - 0.3), (x, r + 0.2, low + 0.4), 0.1),
        capsule((x, r + 0.2, low + 0.4), (x, r - 0.1, low + 0.2), 0.1),
    )
    return {
        "tanks": both(tank),
        "noses": both(nose),
        "pack": join(
            box((0, 0.06, low + long * 0.5), (x, 0.2, long * 0.4), 0.03),
            box((0, -0.1, low + long * 0.5), (0.15, 0.22, long * 0.26), 0.03),
        ),
        "nozzles": both(horn),
        "flames": both(lathe(fire, 0.0, (x, 0))),
        "straps": both(strap),
    }


RELICS = {
    "magic wand": magic_wand,
    "crystal ball": crystal_ball,
    "compass": compass,
    "ingot": ingot,
    "necklace": necklace,
    "brazier": brazier,
    "drinking horn": drinking_horn,
    "coffin": coffin,
    "sack": sack,
    "anchor": anchor,
    "jetpack": jetpack,
}
