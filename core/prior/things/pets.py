"""Cats, dogs and small animals of the house."""

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    ball,
    blend,
    both,
    capsule,
    egg,
    join,
    limb,
    prism,
    smooth_curve,
    taper,
    tube,
)
from core.prior.things.shared.fitted import fitted
from core.prior.things.shared.quadruped import Beast


def dog(draw: Draw) -> Parts:
    """Hanging or raised ears, a long muzzle."""
    b = Beast(draw, 0.36, 0.72, 0.5, 0.34, (0.22, 0.5))
    h, hang = b.head, draw.chance(0.6)
    low = taper((h * 0.8, b.y, b.z + h * 0.5), (h * 1.1, b.y, b.z - 0.22), 0.12, 0.14)
    return {
        "body": join(b.trunk(0.22), b.tail(0.35, draw(0.2, 0.5), 0.11, 0.09)),
        "ears": both(low) if hang else b.ears(0.16, 0.14, 0.05),
        "muzzle": b.muzzle(0.16, 0.16),
        "eyes": b.eyes(),
        "nose": b.nose(0.28, 0.1),
    }


def corgi(draw: Draw) -> Parts:
    """Short legs, large ears, a white chest, white paws and a blaze."""
    b = Beast(draw, 0.38, 0.78, 0.2, 0.38, (0.1, 0.42))
    h, y, z = b.head, b.y, b.z
    ear = taper((h * 0.5, y + 0.04, z + h * 0.6), (h * 0.84, y + 0.04, z + h + 0.36), 0.25, 0.1)
    chest = egg((0, -b.long * 0.86, b.belly + 0.06), (b.wide * 0.66, 0.3, b.wide * 0.74))
    blaze = egg((0, y - h * 0.6, z + h * 0.3), (0.12, h * 0.44, h * 0.62))
    return {
        "body": join(b.trunk(0.3), both(ear), ball((0, b.long, b.belly + 0.15), 0.16)),
        "chest": join(chest, b.feet(0.14)),
        "muzzle": join(b.muzzle(0.12, 0.15), blaze),
        "eyes": b.eyes(),
        "nose": b.nose(0.24, 0.09),
    }


def cat(draw: Draw) -> Parts:
    """Triangular ears, a long raised tail, a short muzzle."""
    b = Beast(draw, 0.32, 0.68, 0.42, 0.4, (0.14, 0.42))
    h, y, z = b.head, b.y, b.z
    ear = prism([(0.06, z + h * 0.7), (h, z + h * 0.3), (h * 0.9, z + h + 0.24)], 1, 0.07, y)
    back, up, bend = b.long * 0.85, b.belly + 0.1, draw(0.2, 0.4)
    tail = join(
        taper((0, back, up), (0, back + bend, up + 0.35), 0.12, 0.11),
        taper((0, back + bend, up + 0.35), (0, back + bend, up + draw(0.7, 1.0)), 0.11, 0.11),
    )
    cheeks = both(egg((0.11, y - h * 0.88, z - 0.14), (0.16, 0.13, 0.12)))
    return {
        "body": join(b.trunk(0.22), both(ear), tail),
        "muzzle": cheeks,
        "eyes": both(egg((h * 0.45, y - h * 0.86, z + 0.1), (0.09, 0.07, 0.11))),
        "nose": ball((0, y - h - 0.06, z - 0.05), 0.08),
    }


def rabbit(draw: Draw) -> Parts:
    """Sitting up, long ears."""
    wide, head = draw(0.5, 0.57), draw(0.36, 0.41)
    z = draw(1.2, 1.3)
    ear = taper(
        (0.15, -0.08, z + head * 0.7),
        (draw(0.2, 0.3), 0.02, z + head + draw(0.6, 0.75)),
        0.12,
        0.14,
    )
    face = -0.14 - head
    return {
        "body": join(
            blend(0.12, egg((0, 0.06, 0.6), (wide, wide * 1.05, 0.62)), ball((0, -0.14, z), head)),
            both(ear),
            both(egg((wide * 0.75, -0.25, 0.16), (0.2, 0.42, 0.17))),
            both(capsule((0.2, -wide * 0.85, 0.5), (0.17, -wide * 1.05, 0.2), 0.12)),
        ),
        "tail": ball((0, wide + 0.12, 0.34), draw(0.19, 0.23)),
        "eyes": both(ball((head * 0.48, face + head * 0.2, z + 0.1), 0.08)),
        "nose": egg((0, face, z - 0.06), (0.09, 0.08, 0.07)),
    }


def mouse(draw: Draw) -> Parts:
    """Large round ears, a pointed face, a long tail."""
    wide, long, ear = draw(0.4, 0.48), draw(0.52, 0.62), draw(0.29, 0.36)
    z, y = wide * 0.95, -long - 0.05
    face = taper((0, y + 0.1, z + 0.16), (0, y - 0.38, z - 0.02), 0.34, 0.12)
    x, top, turn = 0.28, z + 0.36 + ear * 0.6, draw.chance(0.5)
    # Trailing, or raised at its end.
    bend = [(long * 0.7, 0.2), (long + 0.3, 0.12), (long + 0.65, 0.13),
            (long + 0.85, 0.3), (long + 0.75, 0.6 if turn else 0.32)]  # fmt: skip
    tail = [(0, b, h) for b, h in smooth_curve(bend, 2)]
    fore = join(taper((wide * 0.5, -0.35, z * 0.6), (wide * 0.55, -0.5, 0.1), 0.14, 0.1))
    haunch = egg((wide * 0.72, 0.26, 0.33), (0.2, 0.32, 0.31))
    feet = [egg((wide * a, b, 0.08), (0.13, 0.2, 0.09)) for a, b in ((0.55, -0.58), (0.75, 0.08))]
    disc = tube((x, y + 0.2, top), (x, y + 0.36, top), ear, 0.06)
    trunk = blend(0.15, egg((0, 0, z), (wide, long, wide * 0.95)), face)
    return {
        "body": join(trunk, both(join(disc, haunch, fore))),
        "ears": both(tube((x, y + 0.15, top), (x, y + 0.3, top), ear * 0.7, 0.04)),
        "tail": limb(tail, 0.1, 0.075),
        "feet": both(join(*feet)),
        "eyes": both(ball((0.2, y - 0.08, z + 0.34), 0.09)),
        "nose": ball((0, y - 0.48, z - 0.02), 0.1),
    }


PETS = {
    "dog": fitted(dog),
    "corgi": fitted(corgi),
    "cat": fitted(cat),
    "rabbit": rabbit,
    "mouse": fitted(mouse),
}
