"""Food, plants and animals."""

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
    join,
    lathe,
    moved,
    prism,
    ring,
    smooth_curve,
    taper,
    tube,
    turned,
)


def hamburger(draw: Draw) -> Parts:
    """Two halves of a bun, and what lies between."""
    wide, low, dome = draw(0.92, 1.05), draw(0.26, 0.34), draw(0.5, 0.62)
    patty = low + draw(0.26, 0.32)
    green = patty + 0.3
    leaf = join(
        tube((0, 0, patty + 0.12), (0, 0, green), wide * 0.97, 0.05),
        around(8, egg((wide * 0.92, 0, patty + 0.22), (0.2, 0.3, 0.1))),
    )
    slice_ = turned(box((0, 0, 0), (wide * 0.82, wide * 0.82, 0.07), 0.02), 2, 45 + draw(-12, 12))
    top = cut(egg((0, 0, green), (wide, wide, dome)), box((0, 0, green - 1.02), (2, 2, 1)))
    return {
        "bun": join(top, tube((0, 0, 0), (0, 0, low), wide * 0.96, 0.12)),
        "lettuce": leaf,
        "patty": tube((0, 0, low - 0.02), (0, 0, patty), wide * 1.02, 0.1),
        "cheese": moved(slice_, (0, 0, patty + 0.05)),
    }


def ice_cream(draw: Draw) -> Parts:
    """One or two scoops in a wafer cone, sometimes with a cherry."""
    wide, high, scoop = draw(0.5, 0.58), draw(1.25, 1.5), draw(0.56, 0.66)
    z = high + scoop * 0.45
    scoops = [ball((0, 0, z), scoop), around(9, ball((scoop * 0.92, 0, z - scoop * 0.38), 0.15))]
    if draw.chance(0.45):
        z += scoop * 1.05
        scoops.append(ball((0, 0, z), scoop * 0.82))
        scoop *= 0.82
    parts = {"scoop": join(*scoops), "cone": lathe([(0.05, 0), (wide, high)], 0.04)}
    return parts | {"cherry": ball((0, 0, z + scoop + 0.07), 0.17)}


def pineapple(draw: Draw) -> Parts:
    """A scaly body and a tuft of leaves."""
    wide, high = draw(0.56, 0.66), draw(0.78, 0.92)
    top = 2 * high - 0.12
    inner = taper((0.08, 0, top), (0.14, 0, top + draw(0.75, 0.9)), 0.15, 0.04)
    outer = taper((0.12, 0, top), (0.5, 0, top + draw(0.5, 0.6)), 0.14, 0.05)
    last = taper((0.12, 0, top - 0.02), (0.62, 0, top + 0.2), 0.13, 0.05)
    shape = [
        (0.3, 0.0),
        (wide * 0.9, high * 0.4),
        (wide, high),
        (wide * 0.85, high * 1.55),
        (0.3, high * 2),
    ]
    return {
        "body": lathe(smooth_curve(shape, 4), 0.03),
        "leaves": join(around(4, inner), around(6, outer, 30), around(6, last, 0)),
    }


def apple(draw: Draw) -> Parts:
    """A fruit with a dimple, a stalk and a leaf."""
    wide, high = draw(0.82, 0.92), draw(1.4, 1.6)
    shape = [(0.1, 0.14), (0.42, 0.0), (wide * 0.85, high * 0.3), (wide, high * 0.62)]
    shape += [(wide * 0.7, high * 0.97), (0.34, high), (0.06, high * 0.84)]
    leaf = turned(egg((0.3, 0, 0), (0.36, 0.2, 0.1)), 1, -25)
    return {
        "body": lathe(smooth_curve(shape, 4)),
        "stalk": taper((0, 0, high * 0.8), (0.08, 0, high + 0.36), 0.08, 0.1),
        "leaf": moved(leaf, (0.05, 0, high + 0.14)),
    }


def carrot(draw: Draw) -> Parts:
    """A root, tip down, with its greens."""
    wide, long = draw(0.36, 0.46), draw(1.6, 1.9)
    inner = taper((0.05, 0, long + 0.2), (0.2, 0, long + draw(0.95, 1.1)), 0.13, 0.12)
    outer = taper((0.1, 0, long + 0.2), (draw(0.6, 0.75), 0, long + draw(0.6, 0.75)), 0.12, 0.13)
    return {
        "body": taper((0, 0, 0), (0, 0, long), 0.08, wide),
        "leaves": join(around(3, inner), around(6, outer, 30)),
    }


def cupcake(draw: Draw) -> Parts:
    """A pleated cup, a swirl of icing, a cherry."""
    low, wide, high = draw(0.48, 0.56), draw(0.7, 0.8), draw(0.65, 0.8)
    cup = lathe([(low, 0), (wide, high)], 0.02)
    pleat = taper((low, 0, 0.06), (wide, 0, high - 0.04), 0.08, 0.1)
    swirl, z = [], high + 0.1
    for width in (1.02, 0.74, 0.45):
        swirl.append(egg((0, 0, z), (wide * width + 0.06, wide * width + 0.06, 0.27)))
        z += draw(0.25, 0.29)
    return {
        "icing": join(*swirl),
        "cup": join(cup, around(12, pleat)),
        "cherry": ball((0, 0, z + 0.1), 0.17),
    }


def pumpkin(draw: Draw) -> Parts:
    """Lobes about a stalk."""
    wide, high, count = draw(0.5, 0.58), draw(0.6, 0.72), 8 + 2 * draw.chance(0.5)
    lobe = egg((wide * 0.85, 0, high), (wide, wide * 0.62, high))
    stalk = taper(
        (0, 0, high * 1.8), (draw(-0.15, 0.15), 0, high * 2 + draw(0.25, 0.4)), 0.17, 0.12
    )
    return {"body": join(around(count, lobe), ball((0, 0, high), 0.5)), "stalk": stalk}


def _planter(draw: Draw) -> Parts:
    wide, high = draw(0.48, 0.58), draw(0.5, 0.62)
    hull = lathe([(wide * 0.72, 0), (wide * 0.95, high)], 0.02)
    rim = tube((0, 0, high - 0.14), (0, 0, high + 0.04), wide * 1.1, 0.04)
    return {"pot": join(hull, rim)}


def cactus(draw: Draw) -> Parts:
    """A column with two arms, in a pot."""
    trunk, arm, top = draw(0.24, 0.3), draw(0.15, 0.18), draw(1.7, 2.0)

    def branch(side: float, low: float, reach: float, tip: float):
        elbow = (side * reach, 0.0, low)
        return join(capsule((0, 0, low), elbow, arm), capsule(elbow, (elbow[0], 0, tip), arm))

    z, reach = 0.75, trunk + arm + draw(0.2, 0.28)
    arms = [branch(1, z + draw(0, 0.2), reach, z + draw(0.55, 0.75))]
    arms.append(branch(-1, z + draw(0.25, 0.5), reach, z + draw(0.8, 1.0)))
    parts = {"body": join(capsule((0, 0, 0.2), (0, 0, top), trunk), *arms)}
    return parts | _planter(draw)


def flower(draw: Draw) -> Parts:
    """A single blossom that looks to the front: clear petals about a disc, a stalk, two leaves."""
    z, petal, count = draw(1.6, 1.75), draw(0.36, 0.42), 6 + 2 * draw.chance(0.5)
    heart, y, lean = draw(0.25, 0.29), -0.2, draw(12, 20)
    half = petal * (0.62 if count == 6 else 0.48)
    tongue = [(heart * 0.6, half * 0.45), (heart + petal * 0.5, half), (heart + petal, half * 0.92)]
    tongue += [(heart + petal * 1.3, half * 0.5), (heart + petal * 1.42, 0)]
    side = smooth_curve(tongue, 3)
    outline = [*side, *((u, -v) for u, v in reversed(side[:-1]))]
    blossom = around(count, turned(prism(outline, 2, 0.085), 1, -8), 90)
    blade = smooth_curve([(0, 0), (0.26, 0.19), (0.5, 0.17), (0.8, 0)], 3)
    blade = prism([*blade, *((u, -v) for u, v in reversed(blade[1:-1]))], 2, 0.08)

    def turned_up(solid: Solid) -> Solid:
        return moved(turned(solid, 0, 90 - lean), (0, y, z))

    return {
        "petals": turned_up(blossom),
        "heart": turned_up(egg((0, 0, 0.06), (heart, heart, 0.16))),
        "stalk": join(
            capsule((0, 0.04, 0.09), (0, 0, z - 0.3), 0.09),
            capsule((0, 0, z - 0.3), (0, y + 0.06, z), 0.09),
            both(moved(turned(blade, 1, -38), (0.02, 0.04, draw(0.3, 0.42)))),
        ),
    }


def palm(draw: Draw) -> Parts:
    """A bare trunk and drooping leaves."""
    top, lean, count = draw(1.7, 2.0), draw(-0.2, 0.2), 6 + draw.chance(0.5)
    rise, reach, fall = draw(0.15, 0.25), draw(0.55, 0.65), draw(0.25, 0.4)
    leaf = join(
        taper((0.05, 0, 0), (reach, 0, rise), 0.12, 0.15),
        taper((reach, 0, rise), (reach + 0.42, 0, rise - fall), 0.15, 0.07),
    )
    nut = ball((0.17, 0, -0.12), 0.14)
    trunk = join(
        taper((0, 0, 0), (lean * 0.35, 0, top * 0.55), 0.21, 0.16),
        taper((lean * 0.35, 0, top * 0.55), (lean, 0, top), 0.16, 0.13),
    )
    return {
        "leaves": moved(around(count, leaf, 15), (lean, 0, top)),
        "trunk": join(trunk, egg((0, 0, 0.05), (0.45, 0.45, 0.12))),
        "nuts": moved(around(3, nut, -90), (lean, 0, top)),
    }


def pig(draw: Draw) -> Parts:
    """On four legs, its snout to the front."""
    wide, long, belly = draw(0.48, 0.56), draw(0.72, 0.85), draw(0.68, 0.76)
    head, y = draw(0.38, 0.43), -long + 0.02
    body = blend(0.12, egg((0, 0, belly), (wide, long, wide)), ball((0, y, belly + 0.16), head))
    ear = taper(
        (head * 0.5, y + 0.02, belly + head),
        (head * 0.85, y - 0.08, belly + head + 0.28),
        0.13,
        0.06,
    )
    leg = capsule((wide * 0.52, long * 0.52, 0.13), (wide * 0.52, long * 0.52, belly * 0.8), 0.14)
    tail = ring((0, long + 0.04, belly + 0.18), 0.12, 0.065, axis=0)
    return {
        "body": join(body, both(ear), both(leg, 0, 1), tail),
        "snout": tube(
            (0, y - head + 0.1, belly + 0.1), (0, y - head - 0.14, belly + 0.1), 0.19, 0.05
        ),
        "eyes": both(ball((head * 0.45, y - head * 0.82, belly + 0.32), 0.075)),
    }


def fish(draw: Draw) -> Parts:
    """Its head to the front, its tail to the back."""
    thick, long, high = draw(0.28, 0.34), draw(0.88, 1.0), draw(0.48, 0.6)
    spread, up = draw(0.46, 0.58), draw(0.24, 0.34)
    # Forked, its root within the body.
    tail = [(long - 0.3, 0.1), (long + 0.26, spread), (long + 0.62, spread + 0.1),
            (long + 0.36, 0.0)]  # fmt: skip
    tail += [(b, -c) for b, c in reversed(tail[:3])]
    back = [(-0.45, high * 0.75), (-0.2, high + up), (0.3, high + up * 0.8), (0.62, high * 0.5)]
    below = [(0.05, -high * 0.8), (0.3, -high - up * 0.7), (0.55, -high * 0.55)]
    fin = turned(egg((0, 0.26, 0), (0.11, 0.36, 0.2)), 2, 38)
    at = (thick * 0.72, -long * 0.6, high * 0.24)
    body = egg((0, 0, 0), (thick, long, high))
    return {
        "body": body,
        "fins": join(
            prism(tail, 0, 0.085),
            prism(back, 0, 0.085),
            prism(below, 0, 0.085),
            both(moved(fin, (thick * 0.85, -0.2, -high * 0.25))),
        ),
        "eyes": both(ball((at[0] + 0.06, at[1] - 0.04, at[2]), 0.075)),
        "whites": both(ball(at, 0.13)),
        "lips": both(capsule((0, -long, -high * 0.18), (0.1, -long + 0.06, -high * 0.24), 0.085)),
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


def turtle(draw: Draw) -> Parts:
    """A shell, its head to the front."""
    wide, long, dome = draw(0.75, 0.85), draw(0.85, 0.95), draw(0.6, 0.72)
    shell = cut(egg((0, 0, 0.28), (wide, long, dome)), box((0, 0, -0.75), (2, 2, 1)))
    z, y = draw(0.5, 0.6), -long - draw(0.25, 0.35)
    leg = taper((wide * 0.55, long * 0.6, 0.3), (wide * 0.98, long * 0.85, 0.14), 0.19, 0.16)
    return {
        "shell": shell,
        "body": join(
            egg((0, 0, 0.27), (wide * 1.08, long * 1.06, 0.13)),
            both(leg, 0, 1),
            taper((0, -long * 0.8, 0.32), (0, y, z), 0.2, 0.27),
            taper((0, long, 0.26), (0, long + 0.3, 0.16), 0.12, 0.05),
        ),
        "eyes": both(ball((0.17, y - 0.2, z + 0.1), 0.08)),
    }


def duck(draw: Draw) -> Parts:
    """A bath duck."""
    wide, long, head = draw(0.56, 0.64), draw(0.78, 0.88), draw(0.38, 0.43)
    y, z = -long * 0.5, draw(1.15, 1.28)
    hull = cut(egg((0, 0, 0.5), (wide, long, 0.52)), box((0, 0, -0.9), (2, 2, 1)))
    tail = taper((0, long * 0.6, 0.6), (0, long + 0.12, 0.98), 0.28, 0.09)
    bill = egg((0, y - head - 0.1, z - 0.07), (0.21, 0.27, 0.1))
    return {
        "body": blend(0.12, hull, tail, ball((0, y, z), head), tube((0, y, 0.6), (0, y, z), 0.25)),
        "wings": both(egg((wide * 0.85, 0.12, 0.62), (0.16, 0.45, 0.26))),
        "bill": bill,
        "eyes": both(ball((head * 0.6, y - head * 0.72, z + 0.14), 0.085)),
    }


def teddy(draw: Draw) -> Parts:
    """A teddy bear, sitting."""
    wide, head = draw(0.5, 0.58), draw(0.44, 0.5)
    z = draw(1.28, 1.38)
    arm = taper((wide * 0.75, -0.05, 0.92), (wide + 0.3, draw(-0.4, -0.2), 0.62), 0.18, 0.2)
    leg = taper((0.26, -0.25, 0.24), (draw(0.42, 0.5), -0.82, 0.24), 0.22, 0.23)
    face = -head - 0.02
    front, knot = -head * 0.84, z - head * 0.86
    return {
        "body": join(
            egg((0, 0, 0.62), (wide, wide * 0.9, 0.6)),
            egg((0, -0.02, z), (head * 1.06, head, head)),
            both(ball((head * 0.8, 0, z + head * 0.75), 0.2)),
            both(arm),
            both(leg),
        ),
        "muzzle": join(
            egg((0, face + 0.1, z - 0.12), (0.22, 0.2, 0.17)),
            egg((0, -wide * 0.9 + 0.26, 0.6), (wide * 0.66, 0.3, 0.4)),
            both(tube((0.46, -0.96, 0.24), (0.46, -1.06, 0.24), 0.14, 0.03)),
        ),
        "eyes": join(
            both(ball((0.19, face + 0.09, z + 0.12), 0.075)),
            egg((0, face - 0.08, z - 0.05), (0.1, 0.08, 0.075)),
        ),
        "bow tie": join(
            both(moved(prism([(0.03, 0.0), (0.3, 0.17), (0.3, -0.17)], 1, 0.1), (0, front, knot))),
            ball((0, front - 0.04, knot), 0.11),
        ),
    }


NATURE = {
    "hamburger": hamburger,
    "ice cream": ice_cream,
    "pineapple": pineapple,
    "apple": apple,
    "carrot": carrot,
    "cupcake": cupcake,
    "pumpkin": pumpkin,
    "cactus": cactus,
    "flower": flower,
    "palm": palm,
    "pig": pig,
    "fish": fish,
    "rabbit": rabbit,
    "turtle": turtle,
    "duck": duck,
    "teddy bear": teddy,
}
