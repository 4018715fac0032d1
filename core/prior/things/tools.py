"""Tools, instruments and a robot."""

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    ball,
    both,
    box,
    capsule,
    cut,
    join,
    mirrored,
    moved,
    prism,
    smooth_curve,
    taper,
    tube,
    turned,
)


def hammer(draw: Draw) -> Parts:
    """Upright, its face to the left, its claw, which is bent down and split, to the right."""
    high, grip, face = draw(1.75, 1.95), draw(0.11, 0.13), draw(0.23, 0.27)
    reach, drop, y = draw(0.78, 0.9), draw(0.24, 0.34), 0.2
    z = high
    over = [(0.1, z + 0.17), (reach * 0.55, z + 0.11), (reach, z - drop)]
    under = [(reach - 0.12, z - drop - 0.06), (reach * 0.5, z - 0.13), (0.1, z - 0.17)]
    slit = [(0.36, 0.0), (1.2, 0.13), (1.2, -0.13)]
    return {
        "head": join(
            tube((-0.64, 0, z), (-0.4, 0, z), face, 0.04),
            tube((-0.45, 0, z), (-0.1, 0, z), face * 0.68),
            box((0, 0, z), (0.2, y, 0.21), 0.03),
        ),
        "handle": join(
            tube((0, 0, 0), (0, 0, high * 0.46), grip * 1.35, 0.06),
            tube((0, 0, high * 0.4), (0, 0, high + 0.28), grip),
        ),
        "claw": cut(prism([*smooth_curve(over), *smooth_curve(under)], 1, y), prism(slit, 2, 3)),
    }


def axe(draw: Draw) -> Parts:
    """Upright, its edge to the left."""
    high, grip = draw(1.8, 2.05), draw(0.1, 0.12)
    reach, edge = draw(0.62, 0.72), draw(0.4, 0.5)
    z = high - 0.25
    blade = [
        (0.16, z - 0.16),
        (0.16, z + 0.16),
        (-reach * 0.6, z + edge * 0.62),
        (-reach, z + edge),
    ]
    blade += [(-reach - 0.1, z), (-reach, z - edge), (-reach * 0.55, z - edge * 0.5)]
    return {
        "head": join(prism(blade, 1, 0.09), box((0.0, 0, z), (0.2, 0.16, 0.18), 0.03)),
        "handle": join(
            capsule((0, 0, 0.12), (0, 0, high), grip),
            taper((0, 0, 0.12), (0, 0, 0.5), grip * 1.4, grip),
        ),
    }


def anvil(draw: Draw) -> Parts:
    """Its horn to the left, a step between that and its face, its waist on a broad foot."""
    top, long, waist = draw(1.0, 1.12), draw(0.58, 0.66), draw(0.26, 0.32)
    deep, foot, high = draw(0.24, 0.28), draw(0.58, 0.66), draw(0.18, 0.22)
    reach, low = draw(1.16, 1.26), top - 0.34
    side = smooth_curve([(foot - 0.06, high), (waist, high + 0.22), (waist, low - 0.16),
                         (waist + 0.18, low + 0.06)], 4)  # fmt: skip
    return {
        "body": box((0.24, 0, top - 0.16), (long, deep, 0.17), 0.02),
        "horn": join(
            taper((-0.46, 0, top - 0.18), (-reach, 0, top - 0.06), deep * 0.8, 0.06),
            box((-0.42, 0, top - 0.2), (0.16, deep - 0.03, 0.14), 0.02),
        ),
        "waist": prism(mirrored(side), 1, deep - 0.04),
        "foot": box((0, 0, high / 2), (foot, deep + 0.1, high / 2), 0.03),
    }


def guitar(draw: Draw) -> Parts:
    """Upright, its strings to the front; two pegs on either side of its head."""
    low, half, neck = draw(0.54, 0.6), draw(0.16, 0.18), draw(0.76, 0.86)
    waist, up, high = low * draw(0.64, 0.69), low * draw(0.76, 0.82), draw(1.32, 1.42)
    right = [(0, 0), (low * 0.62, 0.04), (low, 0.38), (waist, 0.82), (up, 1.1), (up * 0.5, high)]
    side = smooth_curve([*right, (0, high + 0.02)], 6)
    top, front, z = high + neck, -half, high * 0.64
    head = mirrored([(0.12, top), (0.22, top + 0.14), (0.2, top + 0.75)])
    rows = (top + 0.18, top + 0.58)
    pegs = (capsule((0.27, front, v), (0.37, front, v), 0.09) for v in rows)
    return {
        "body": prism(mirrored(side), 1, half),
        "neck": join(
            box((0, front - 0.01, (z + 0.24 + top) / 2), (0.12, 0.12, (top - z - 0.16) / 2)),
            prism(head, 1, 0.11, front),
            tube((0, front - 0.05, z), (0, 0, z), 0.27),
        ),
        "hole": tube((0, front - 0.1, z), (0, 0, z), draw(0.15, 0.17)),
        "bridge": box((0, front, 0.34), (0.26, 0.1, 0.075), 0.02),
        "pegs": both(join(*pegs)),
    }


def drum(draw: Draw) -> Parts:
    """A side drum with its sticks."""
    radius, high = draw(0.78, 0.88), draw(0.75, 1.0)
    hoop = tube((0, 0, -0.1), (0, 0, 0.1), radius + 0.08, 0.03)
    stick = join(capsule((-0.5, 0, 0.12), (0.65, 0, 0.12), 0.085), ball((-0.5, 0, 0.12), 0.13))
    sticks = (moved(turned(stick, 2, a), (0, 0, high)) for a in (62, 118))
    return {
        "shell": tube((0, 0, 0.0), (0, 0, high), radius),
        "hoops": join(moved(hoop, (0, 0, 0.1)), moved(hoop, (0, 0, high - 0.12))),
        "skin": tube((0, 0, high - 0.2), (0, 0, high + 0.03), radius - 0.03, 0.02),
        "sticks": join(*sticks),
    }


def robot(draw: Draw) -> Parts:
    """A toy of boxes, its face to the front; ears, shoulders and hands are round."""
    x, body, head = draw(0.42, 0.5), draw(0.38, 0.44), draw(0.31, 0.36)
    low, deep = draw(0.5, 0.62), draw(0.28, 0.34)
    top = low + 2 * body
    z = top + head + 0.1
    side, out = head * 1.2, x + 0.19
    shoulder, hand = top - 0.16, top - draw(0.82, 0.9)
    cube = box((0, 0, z), (side, head, head), 0.06)
    drum = tube((0, 0, z - head), (0, 0, z + head), head * 1.12, 0.06)
    round_head, two = draw.chance(0.4), draw.chance(0.4)
    side = head * 1.12 if round_head else side
    rod = join(
        tube((0, 0, z + head - 0.05), (0, 0, z + head + 0.2), 0.085),
        ball((0, 0, z + head + 0.26), 0.13),
    )
    sole = [(0.17, 0.0), (0.17, low + 0.05), (-0.15, low + 0.05), (-0.15, 0.2), (-0.36, 0.2)]
    return {
        "body": box((0, 0, low + body), (x, deep, body), 0.05),
        "head": drum if round_head else cube,
        "limbs": both(
            join(
                box((out, 0, (shoulder + hand) / 2), (0.13, 0.14, (shoulder - hand) / 2), 0.03),
                moved(prism([*sole, (-0.36, 0.0)], 0, 0.16), (x * 0.52, 0, 0)),
            )
        ),
        "eyes": both(
            tube((side * 0.42, -head - 0.07, z + 0.05), (side * 0.42, -head + 0.2, z + 0.05), 0.12)
        ),
        "aerial": both(moved(rod, (head * 0.62, 0, 0))) if two else rod,
        "joints": join(
            tube((0, 0, top - 0.1), (0, 0, z), 0.15),
            both(tube((side - 0.1, 0, z), (side + 0.09, 0, z), 0.15)),
            both(ball((out - 0.03, 0, shoulder), 0.2)),
            both(ball((out, 0, hand - 0.06), 0.185)),
        ),
    }


TOOLS = {
    "hammer": hammer,
    "axe": axe,
    "anvil": anvil,
    "guitar": guitar,
    "drum": drum,
    "robot": robot,
}
