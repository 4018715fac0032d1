"""Machines, lights and tools that run on electricity."""

import math

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Point,
    Solid,
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
    smooth_curve,
    tilted,
    tube,
    turned,
)


def light_bulb(draw: Draw) -> Parts:
    """A round bulb that narrows to its screw cap."""
    neck, wide, high = draw(0.26, 0.3), draw(0.6, 0.68), draw(1.8, 1.98)
    middle = high - wide
    shape = [(neck, 0.58), (neck + 0.03, 0.7), (wide * 0.7, middle - 0.46)]
    shape += [(wide * 0.93, middle - 0.22)]
    bends = (math.radians(angle) for angle in (0, 24, 46, 66, 80))
    shape += [(wide * math.cos(bend), middle + wide * math.sin(bend)) for bend in bends]
    rings = (ring((0, 0, v), neck - 0.01, 0.08) for v in (0.24, 0.42, 0.6))
    return {
        "bulb": lathe(smooth_curve([*shape, (0, high)], 4)),
        "cap": join(tube((0, 0, 0.14), (0, 0, 0.66), neck), *rings),
        "tip": lathe([(0.12, 0.0), (neck - 0.03, 0.17)], 0.02),
    }


def flashlight(draw: Draw) -> Parts:
    """It lies, its lens to the front; rings to hold it by, a button on top."""
    long, r, head = draw(1.2, 1.48), draw(0.27, 0.38), draw(0.48, 0.62)
    neck, cone = long * draw(0.22, 0.36), draw(0.2, 0.4)
    rings = [tube((0, 0, v), (0, 0, v + 0.13), r + 0.06, 0.03)
             for v in (-long + 0.4, -long + 0.68, -long + 0.96)]  # fmt: skip
    bell = [(r, neck), (head, neck + cone), (head, long)]
    mouth = tube((0, 0, long - 0.1), (0, 0, 2), head - 0.13)
    knob = -neck + 0.16

    def lying(solid: Solid) -> Solid:
        return tilted(solid, 90, (0, 0, head))

    return {
        "body": lying(tube((0, 0, -long), (0, 0, neck + 0.1), r)),
        "head": lying(cut(lathe(bell), mouth)),
        "lens": lying(egg((0, 0, long - 0.12), (head - 0.1, head - 0.1, 0.2))),
        "rings": lying(join(*rings)),
        "cap": lying(join(
            tube((0, 0, -long - 0.06), (0, 0, -long + 0.24), r + 0.05, 0.04),
            tube((0, 0, neck + cone + 0.05), (0, 0, neck + cone + 0.2), head + 0.06, 0.03),
        )),
        "button": box((0, knob, head + r), (0.12, 0.21, 0.09), 0.05),
    }  # fmt: skip


def battery(draw: Draw) -> Parts:
    """A cell that stands on its flat end: a copper top, a nub, a plus and a bolt on its label."""
    r, high, share = draw(0.64, 0.8), draw(2.2, 2.5), draw(0.62, 0.7)
    nub, band, front = draw(0.24, 0.32), high * share, -r + 0.04
    plus, bar, at = 0.1, 0.3, (band + high) / 2 + 0.02
    bolt = [(0.1, 0.5), (-0.34, -0.1), (-0.06, -0.1), (-0.14, -0.5), (0.34, 0.14), (0.06, 0.14)]
    return {
        "body": tube((0, 0, 0.12), (0, 0, band), r, 0.03),
        "top": tube((0, 0, band - 0.1), (0, 0, high), r - 0.05, 0.06),
        "nub": tube((0, 0, high - 0.1), (0, 0, high + 0.26), nub, 0.05),
        "base": join(
            tube((0, 0, 0), (0, 0, 0.3), r - 0.1, 0.02),
            tube((0, 0, band - 0.1), (0, 0, band + 0.1), r + 0.07, 0.03),
        ),
        "plus": join(
            box((0, front + 0.04, at), (bar, 0.14, plus), 0.01),
            box((0, front + 0.04, at), (plus, 0.14, bar), 0.01),
        ),
        "bolt": moved(prism(bolt, 1, 0.16), (0, front + 0.04, band / 2)),
    }


def coffee_machine(draw: Draw) -> Parts:
    """A head over a jug of coffee on its plate."""
    x, y, high = draw(0.58, 0.68), draw(0.56, 0.64), draw(1.5, 1.7)
    base, head, belly = draw(0.17, 0.22), draw(0.36, 0.44), draw(0.38, 0.42)
    front, low, under = -0.16, base + 0.05, high - head
    jug = [(belly * 0.82, low), (belly, low + (under - low) * 0.34), (belly * 0.7, under - 0.2)]
    at = (0.0, front)
    return {
        "body": join(
            box((0, 0, base / 2), (x, y + 0.06, base / 2), 0.04),
            box((0, y * 0.66, high / 2), (x, y * 0.34, high / 2), 0.04),
            box((0, 0, high - head / 2), (x, y + 0.06, head / 2), 0.06),
        ),
        "jug": lathe(smooth_curve(jug), 0.0, at),
        "collar": lathe([(belly * 0.76, under - 0.22), (belly * 0.66, under - 0.07)], 0.02, at),
        "handle": join(
            box((0, front - belly - 0.14, (low + under) / 2), (0.09, 0.09, 0.3), 0.04),
            box((0, front - belly, (low + under) / 2 + 0.22), (0.09, 0.2, 0.08), 0.03),
            box((0, front - belly, (low + under) / 2 - 0.2), (0.09, 0.2, 0.08), 0.03),
        ),
        "plate": tube((0, front, base - 0.03), (0, front, low + 0.02), belly * 0.95),
        "panel": box((0, -y - 0.06, high - head / 2), (x * 0.7, 0.04, head * 0.24), 0.02),
    }


def clothes_iron(draw: Draw) -> Parts:
    """Flat on its sole, its tip to the left, higher towards the back."""
    long, wide, high = draw(1.1, 1.22), draw(0.46, 0.54), draw(0.5, 0.6)
    sole, top, slope = draw(0.15, 0.18), draw(1.02, 1.14), draw(12, 16)

    def outline(by: float) -> list[tuple[float, float]]:
        half = [(-long + by * 1.6, 0.0), (-long * 0.62, wide * 0.62 - by), (-0.1, wide - by)]
        half += [(long * 0.7, wide - by), (long - by, wide * 0.8 - by)]
        upper = smooth_curve(half[:4], 3) + half[4:]
        return [*upper, *((a, -b) for a, b in reversed(upper[1:]))]

    back, front = long * 0.66, -long * 0.4
    above = turned(box((0, 0, 1), (3, 1, 1)), 1, -slope)
    return {
        "body": cut(
            prism(outline(0.07), 2, high / 2 + 0.1, sole + high / 2 + 0.05),
            moved(above, (0.3, 0, sole + high)),
        ),
        "sole": prism(outline(0.0), 2, sole / 2, sole / 2),
        "handle": join(
            capsule((front, 0, top), (back, 0, top + 0.06), 0.14),
            capsule((front, 0, top), (front - 0.12, 0, sole + 0.25), 0.13),
            capsule((back, 0, top + 0.06), (back + 0.06, 0, sole + high), 0.15),
        ),
        "dial": moved(
            turned(tube((0, 0, -0.1), (0, 0, 0.1), 0.18, 0.03), 1, -slope), (0.2, 0, sole + high)
        ),
        "button": tube((front + 0.1, 0, top), (front + 0.1, 0, top + 0.22), 0.1, 0.03),
    }


def hair_dryer(draw: Draw) -> Parts:
    """Upright on its handle, its nozzle to the left."""
    r, long, high = draw(0.36, 0.42), draw(0.46, 0.54), draw(1.15, 1.3)
    nozzle, lean, grip = draw(0.48, 0.56), draw(0.1, 0.18), draw(0.16, 0.19)
    x = 0.28
    mouth = -x - long - nozzle
    barrel = lathe(smooth_curve([(r * 0.72, -long - 0.1), (r * 0.95, 0), (r, long)]), 0.0)
    cone = lathe([(r * 0.8, 0), (r * 0.62, nozzle * 0.8), (r * 0.68, nozzle)], 0.01)
    at = (x, 0.0, high)
    stem = [(x - 0.16, high), (x + 0.22, high), (x + 0.2 + lean, 0), (x - 0.1 + lean, 0)]
    return {
        "body": join(
            moved(turned(barrel, 1, 90), at), moved(ball((0, 0, 0), r), (x + long, 0, high))
        ),
        "nozzle": cut(
            moved(turned(cone, 1, -90), (x - long + 0.06, 0, high)),
            tube((mouth - 1, 0, high), (mouth + 0.5, 0, high), r * 0.42),
        ),
        "grip": prism(stem, 1, grip),
        "grille": join(
            tube((x + long + r * 0.72, 0, high), (x + long + r + 0.06, 0, high), r * 0.66, 0.03),
        ),
        "buttons": join(
            *(
                box((x - 0.1 + lean * t, 0, high * (1 - t)), (0.14, 0.09, 0.09), 0.03)
                for t in (0.46, 0.66)
            )
        ),
        "ring": tube((x - long - 0.06, 0, high), (x - long + 0.1, 0, high), r * 0.86, 0.03),
    }


def vacuum_cleaner(draw: Draw) -> Parts:
    """Upright: a wide head on the floor, a dust cup, a handle that leans back."""
    x, deep, high = draw(0.58, 0.68), draw(0.32, 0.38), draw(2.3, 2.5)
    lean, cup, thick = draw(12, 17), draw(0.25, 0.29), draw(0.1, 0.12)
    low, top = 0.5, draw(1.35, 1.5)

    def leaning(solid: Solid) -> Solid:
        return tilted(solid, -lean, (0, 0.2, 0.1))

    grip = join(
        box((0, 0, high), (0.3, 0.1, 0.1), 0.05),
        box((0, 0, high - 0.42), (0.3, 0.1, 0.1), 0.05),
        both(box((0.24, 0, high - 0.21), (0.1, 0.1, 0.3), 0.05)),
    )
    return {
        "body": join(
            box((0, -0.2, 0.16), (x, deep, 0.16), 0.06),
            leaning(
                box(
                    (0, 0.14, (low + top) / 2 - 0.05),
                    (cup * 1.05, 0.16, (top - low) / 2 + 0.3),
                    0.05,
                )
            ),
            leaning(tube((0, -0.06, top), (0, -0.06, top + 0.16), cup + 0.05, 0.04)),
        ),
        "cup": leaning(tube((0, -0.06, low + 0.1), (0, -0.06, top + 0.02), cup)),
        "base": leaning(tube((0, -0.06, low - 0.16), (0, -0.06, low + 0.12), cup + 0.05, 0.04)),
        "pole": leaning(tube((0, 0.1, top), (0, 0.1, high - 0.4), thick)),
        "grip": leaning(moved(grip, (0, 0.1, 0))),
        "wheels": both(tube((x * 0.56, 0.26, 0.2), (x * 0.98, 0.26, 0.2), 0.2, 0.03)),
    }


def sewing_machine(draw: Draw) -> Parts:
    """An arm over its bed, the needle at the left, a hand wheel at the right."""
    x, y, bed = draw(1.08, 1.2), draw(0.36, 0.42), draw(0.2, 0.26)
    high, arm, pillar = draw(1.22, 1.36), draw(0.19, 0.22), draw(0.24, 0.28)
    left, right, wheel = -x + 0.32, x - 0.42, draw(0.3, 0.36)
    z = high - arm
    head = z + arm * 0.8
    return {
        "body": join(
            box(((left + right) / 2, 0, z), ((right - left) / 2 + pillar, 0.22, arm), 0.06),
            box((right, 0, (bed + high) / 2), (pillar, 0.24, (high - bed) / 2 + 0.02), 0.06),
            box((left, 0, (head + 0.66) / 2), (0.23, 0.23, (head - 0.66) / 2), 0.06),
        ),
        "base": box((0, 0, bed / 2), (x, y, bed / 2), 0.04),
        "wheel": join(
            tube((right + pillar, 0, z), (right + pillar + 0.26, 0, z), wheel, 0.04),
            tube((right, 0, z), (right + pillar + 0.34, 0, z), 0.12, 0.03),
        ),
        "needle": join(
            tube((left, 0, bed), (left, 0, 0.8), 0.075),
            box((left, 0, bed + 0.03), (0.2, 0.18, 0.06), 0.02),
        ),
        "spool": join(
            tube((0.1, 0, high - 0.02), (0.1, 0, high + 0.34), 0.12),
            *(tube((0.1, 0, high + v), (0.1, 0, high + v + 0.08), 0.19) for v in (0.0, 0.3)),
        ),
        "band": box(((left + right) / 2, 0, z), ((right - left) / 2 - 0.26, 0.25, 0.08), 0.02),
    }


def lawn_mower(draw: Draw) -> Parts:
    """A motor on its deck between four wheels, a handle that rises to the back, a bag below it."""
    x, y, r = draw(0.52, 0.6), draw(0.66, 0.76), draw(0.22, 0.26)
    back, up = draw(1.2, 1.35), draw(1.25, 1.4)
    front, deck = -0.35, r + draw(0.2, 0.26)
    round_deck = [
        (-x, front + y),
        (-x, front - y + 0.3),
        (-x + 0.26, front - y),
        (x - 0.26, front - y),
    ]
    round_deck += [(x, front - y + 0.3), (x, front + y)]
    rear = front + y
    side = x - 0.1
    wheel = (
        tube((x - 0.03, v, r), (x + 0.19, v, r), r, 0.04) for v in (front - y * 0.6, rear - 0.2)
    )
    hub = (tube((x, v, r), (x + 0.23, v, r), r * 0.48, 0.02) for v in (front - y * 0.6, rear - 0.2))
    bag = [(rear - 0.06, 0.24), (rear + 0.72, 0.3), (rear + 0.72, 0.66), (rear - 0.06, 0.86)]
    return {
        "deck": prism(round_deck, 2, (deck - r * 0.6) / 2, (deck + r * 0.6) / 2),
        "engine": join(
            tube((0, front, deck - 0.05), (0, front, deck + 0.26), 0.36, 0.03),
            tube((0, front, deck + 0.2), (0, front, deck + 0.4), 0.24, 0.04),
            box((0, front - 0.36, deck + 0.1), (0.16, 0.14, 0.13), 0.03),
        ),
        "wheels": both(join(*wheel)),
        "hubs": both(join(*hub)),
        "handle": join(
            both(capsule((side, rear - 0.16, deck), (side, back, up), 0.085)),
            capsule((-side, back, up), (side, back, up), 0.1),
        ),
        "bag": prism(bag, 0, side - 0.16),
    }


def power_drill(draw: Draw) -> Parts:
    """Upright on its battery, its bit to the left."""
    r, long, high = draw(0.24, 0.28), draw(0.56, 0.64), draw(1.1, 1.22)
    nose, reach, foot = draw(0.34, 0.4), draw(0.5, 0.6), draw(0.34, 0.4)
    x = -0.1  # where the motor ends and the chuck begins
    z, lean = high, 0.16
    grip = [(x + 0.34, z), (x + 0.74, z), (x + 0.74 + lean, 0.2), (x + 0.36 + lean, 0.2)]
    chuck = lathe([(r * 0.9, 0), (r * 0.9, nose * 0.5), (r * 0.45, nose)], 0.0)
    along = turned(chuck, 1, -90)
    return {
        "body": join(
            tube((x - 0.02, 0, z), (x + 2 * long, 0, z), r, 0.05),
            tube((x - 0.12, 0, z), (x + 0.1, 0, z), r * 1.12, 0.03),
        ),
        "chuck": moved(along, (x - 0.1, 0, z)),
        "bit": tube((x - nose - reach, 0, z), (x - nose, 0, z), 0.085),
        "grip": prism(grip, 1, 0.17),
        "battery": box((x + 0.5 + lean * 0.7, 0, 0.15), (foot, 0.24, 0.15), 0.04),
        "trigger": box((x + 0.31, 0, z - r - 0.16), (0.12, 0.1, 0.15), 0.04),
    }


def robot_arm(draw: Draw) -> Parts:
    """On a turning base: two arms between round joints, a gripper that reaches to the front."""
    foot, wide, first = draw(0.52, 0.76), draw(0.16, 0.22), draw(0.95, 1.4)
    back, second, drop = draw(0.0, 0.32), draw(1.25, 1.6), draw(-0.1, 0.4)
    y, low = 0.7, 0.66
    elbow = (y + back, low + first)
    wrist = (elbow[0] - second, elbow[1] + 0.1 - drop)
    hand = wrist[1] - 0.32

    def joint(at: Point, radius: float, half: float) -> Solid:
        return tube((-half, *at), (half, *at), radius, 0.03)

    claw = [(0.1, hand), (0.34, hand - 0.02), (0.4, hand - 0.26), (0.17, hand - 0.56),
            (0.1, hand - 0.44), (0.2, hand - 0.26)]  # fmt: skip
    fingers = prism(claw, 1, 0.13, wrist[0])
    return {
        "arms": join(
            limb([(0.0, y, low), (0.0, *elbow)], wide + 0.04, wide),
            limb([(0.0, *elbow), (0.0, *wrist)], wide, wide * 0.72),
        ),
        "joints": join(
            joint((y, low), wide + 0.12, wide + 0.1),
            joint(elbow, wide + 0.07, wide + 0.08),
            joint(wrist, wide * 0.85, wide * 0.95),
        ),
        "base": join(
            tube((0, y, 0), (0, y, 0.16), foot, 0.03),
            box((0, y, 0.42), (wide + 0.06, wide + 0.16, 0.3), 0.05),
        ),
        "turntable": tube((0, y, 0.12), (0, y, 0.34), foot * 0.74, 0.03),
        "gripper": join(
            both(fingers),
            box((0, wrist[0], hand), (0.3, 0.15, 0.1), 0.03),
            tube((0, wrist[0], hand), (0, wrist[0], wrist[1]), 0.13),
        ),
        "caps": join(
            joint((y, low), wide * 0.75, wide + 0.16), joint(elbow, wide * 0.7, wide + 0.14)
        ),
    }


def drone(draw: Draw) -> Parts:
    """A quadcopter, its camera to the front, its rotors in rings."""
    x, y, reach, r = draw(0.3, 0.36), draw(0.44, 0.55), draw(1.05, 1.15), draw(0.42, 0.48)
    rotor = join(box((reach, 0, 0.64), (0.09, r, 0.08)), ring((reach, 0, 0.6), r, 0.1))
    motor = tube((reach, 0, 0.46), (reach, 0, 0.8), 0.16)
    post = both(tube((x, 0.24, 0.1), (x, 0.24, 0.5), 0.09), 1)
    return {
        "body": box((0, 0, 0.6), (x, y, 0.22), 0.04),
        "arms": around(4, join(tube((0, 0, 0.58), (reach, 0, 0.58), 0.1), motor), 45),
        "rotors": around(4, rotor, 45),
        "camera": ball((0, -y, 0.5), 0.19),
        "legs": both(join(post, capsule((x, -y, 0.1), (x, y, 0.1), 0.1))),
    }


ELECTRIC_MACHINES = {
    "light bulb": light_bulb,
    "flashlight": flashlight,
    "battery": battery,
    "coffee machine": coffee_machine,
    "clothes iron": clothes_iron,
    "hair dryer": hair_dryer,
    "vacuum cleaner": vacuum_cleaner,
    "sewing machine": sewing_machine,
    "lawn mower": lawn_mower,
    "power drill": power_drill,
    "robot arm": robot_arm,
    "drone": drone,
}
