"""What stands in a study: an abacus, a molecule, a planet, a cassette, a record, a ruler."""

import math

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
    ball,
    both,
    box,
    capsule,
    cut,
    egg,
    join,
    lathe,
    moved,
    prism,
    tube,
    turned,
)

LEAN_DEG = 23.0  # of a planet's axis, as the markings' (``markings/balls.py``) of its globe


def abacus(draw: Draw) -> Parts:
    """A standing frame; on each of its five rods four beads of one colour, some pushed aside."""
    x, high, deep = draw(0.95, 1.05), draw(1.55, 1.7), draw(0.13, 0.17)
    wall, rows, r = 0.1, 5, draw(0.125, 0.135)
    frame = cut(
        box((0, 0, high / 2), (x, deep, high / 2)),
        box((0, 0, high / 2), (x - 2 * wall, 1, high / 2 - 2 * wall)),
    )
    feet = both(box((x - wall, 0, 0.06), (wall + 0.02, deep + 0.16, 0.08)))
    rods, beads = [], ([], [], [])
    left, pitch = -x + 2 * wall + 0.17, 0.31
    aside = draw.which(2)
    room = 2 * (x - 2 * wall) - 0.34 - 3 * pitch
    for k in range(rows):
        z = wall * 2 + (high - 4 * wall) * (k + 0.5) / rows
        rods.append(tube((-x + wall, 0, z), (x - wall, 0, z), 0.05))
        here = (1 + 2 * k + aside) % 5  # how many are on the left
        for i in range(4):
            u = left + pitch * i + (room if i >= here else 0.0)
            beads[k % 3].append(egg((u, 0, z), (0.115, r + 0.02, r)))
    return {
        "frame": join(frame, feet),
        "rods": join(*rods),
        "beads": join(*beads[0]),
        "counters": join(*beads[1]),
        "pearls": join(*beads[2]),
    }


def molecule(draw: Draw) -> Parts:
    """Water's: a large atom and two smaller ones; or a larger molecule of balls and sticks."""
    big, small = draw(0.5, 0.56), draw(0.34, 0.38)
    if draw.chance(0.5):
        a, far = math.radians(draw(50, 54)), draw(0.95, 1.05)
        at = (far * math.sin(a), 0.0, -far * math.cos(a))
        return {
            "core": moved(ball((0, 0, 0), big), (0, 0, 1.2)),
            "atoms": moved(both(ball(at, small)), (0, 0, 1.2)),
            "bonds": moved(both(capsule((0, 0, 0), at, 0.13)), (0, 0, 1.2)),
        }
    far = draw(0.92, 1.0)
    tips = [(0.0, 0.0, far)]
    low = math.radians(109.5)
    for k in range(3):
        t = math.radians(120 * k - 90)
        u = far * math.sin(low)
        tips.append((u * math.cos(t), u * math.sin(t), far * math.cos(low)))
    return {
        "core": moved(ball((0, 0, 0), big * 0.8), (0, 0, 0.7)),
        "atoms": moved(join(*(ball(tip, small * 0.8) for tip in tips)), (0, 0, 0.7)),
        "bonds": moved(join(*(capsule((0, 0, 0), tip, 0.11) for tip in tips)), (0, 0, 0.7)),
    }


def planet(draw: Draw) -> Parts:
    """A globe with bands and a thin ring around it, leaning."""
    r, near, far, thick = 0.82, draw(1.04, 1.1), draw(1.42, 1.52), 0.05
    disc = lathe([(near, -thick), (far, -thick), (far, thick), (near, thick)])
    hole = tube((0, 0, -1), (0, 0, 1), near)
    bridge = box((0, 0, 0), (near + 0.05, 0.06, thick * 0.9))
    belt = lathe([(r + 0.02, -0.1), (r + 0.02, 0.1)])
    parts = {
        "globe": ball((0, 0, 0), r),
        "bands": belt,
        "rings": join(cut(disc, hole), bridge),
    }
    return {name: moved(turned(solid, 1, LEAN_DEG), (0, 0, 1)) for name, solid in parts.items()}


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


def ruler(draw: Draw) -> Parts:
    """It stands on its long edge, with long and short marks along the upper one."""
    x, z, y = draw(1.25, 1.35), draw(0.2, 0.25), draw(0.06, 0.075)
    count, out = 9, y + 0.035
    pitch = 2 * (x - 0.12) / (count - 1)
    marks = []
    for k in range(count):
        u, long = k * pitch - x + 0.12, 0.62 if k % 2 == 0 else 0.34
        marks.append(box((u, 0, 2 * z - long * z), (0.045, out, long * z)))
    return {
        "body": box((0, 0, z), (x, y, z)),
        "marks": join(*marks),
    }


STUDY = {
    "abacus": abacus,
    "molecule": molecule,
    "planet": planet,
    "cassette": cassette,
    "vinyl record": record,
    "ruler": ruler,
}
