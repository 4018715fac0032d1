"""Machines of the house, the workshop and the shop."""

import math

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
    around,
    both,
    box,
    capsule,
    cut,
    join,
    lathe,
    moved,
    prism,
    smooth_curve,
    tilted,
    tube,
    turned,
)


def _arch(x: float, low: float, top: float, front: float, back: float) -> Solid:
    """A slab whose upper end is half a disc of radius ``x``."""
    y, deep = (front + back) / 2, (back - front) / 2
    return join(
        box((0, y, (low + top) / 2), (x, deep, (top - low) / 2)),
        tube((0, front, top), (0, back, top), x),
    )


def jukebox(draw: Draw) -> Parts:
    """Round above, an arch of light about its window, a grille below."""
    x, y, top = draw(0.76, 0.86), draw(0.4, 0.5), draw(1.32, 1.5)
    glow, pane = x - draw(0.13, 0.16), x - draw(0.34, 0.38)
    middle = draw(0.98, 1.08)
    bar = box((0, -y - 0.1, 0.52), (0.07, 0.1, 0.3), 0.02)
    return {
        "body": join(
            _arch(x, 0, top, -y, y), box((0, -0.04, 0.09), (x + 0.08, y + 0.1, 0.09), 0.03)
        ),
        "lights": _arch(glow, 0.16, top, -y - 0.08, 0),
        "window": _arch(pane, middle, top, -y - 0.13, 0),
        "grille": box((0, -y, 0.52), (pane, 0.14, 0.34)),
        "bars": join(bar, both(moved(bar, (pane * 0.62, 0, 0)))),
        "buttons": box((0, -y - 0.1, middle - 0.07), (pane + 0.06, 0.13, 0.085), 0.03),
    }


def desktop_computer(draw: Draw) -> Parts:
    """A screen on a flat case, the keyboard in front of them."""
    x, y, case = draw(0.92, 1.02), draw(0.56, 0.64), draw(0.34, 0.42)
    wide, high, rim = draw(0.72, 0.8), draw(0.54, 0.62), draw(0.11, 0.14)
    z, front = case + 0.14 + high, -y + 0.08
    deck, reach, pitch = 0.17, draw(0.27, 0.31), 0.245
    board = -y - reach + 0.03
    keys = [
        box((pitch * (k - 2.5), board + 0.175 * (row - 0.5), deck + 0.03), (0.09, 0.06, 0.09), 0.02)
        for k in range(6)
        for row in (0, 1)
    ]
    return {
        "body": join(
            box((0, 0, case / 2), (x, y, case / 2), 0.03),
            tube((0, 0, case - 0.02), (0, 0, case + 0.2), 0.42),
            box((0, front + 0.3, z), (wide, 0.3, high), 0.05),
            box((0, front + 0.7, z), (wide * 0.76, 0.34, high * 0.76), 0.05),
        ),
        "screen": box((0, front, z + 0.03), (wide - rim, 0.04, high - rim - 0.03), 0.02),
        "keyboard": box((0, board, deck / 2), (x * 0.94, reach, deck / 2), 0.03),
        "keys": join(*keys),
        "slot": box((x * 0.48, -y, case * 0.7), (x * 0.36, 0.05, 0.07), 0.01),
        "button": box((-x * 0.66, -y, case * 0.7), (0.09, 0.05, 0.07), 0.02),
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


def record_player(draw: Draw) -> Parts:
    """A gramophone: its horn rises at the back and opens to the front over a turning record."""
    x, high, r = draw(0.6, 0.68), draw(0.38, 0.46), draw(0.46, 0.52)
    bell, lean, long = draw(0.7, 0.8), draw(42, 50), draw(1.15, 1.3)
    # Up the outside, over the lip and down to the bottom of the throat.
    outer = [(0.12, 0), (0.14, long * 0.45), (0.3, long * 0.74), (bell * 0.64, long * 0.91)]
    inner = [(bell * 0.64 - 0.16, long * 0.97), (0.15, long * 0.85), (0, long * 0.78)]
    inner = smooth_curve([(bell - 0.04, long + 0.14), *inner])
    horn = [*smooth_curve([*outer, (bell, long)]), *inner]
    back, crank, z = x - 0.16, x + 0.3, high * 0.55
    return {
        "horn": tilted(lathe(horn), lean, (0, back, high + 0.62)),
        "pipe": tube((0, back, high - 0.1), (0, back, high + 0.68), 0.12),
        "case": join(
            box((0, 0, high / 2), (x, x, high / 2)),
            box((0, 0, 0.09), (x + 0.1, x + 0.1, 0.09)),
        ),
        "record": tube((0, -0.08, high - 0.02), (0, -0.08, high + 0.12), r),
        "label": tube((0, -0.08, high), (0, -0.08, high + 0.18), r * 0.36),
        "crank": join(
            capsule((x - 0.1, 0, z), (crank, 0, z), 0.09),
            capsule((crank, 0, z), (crank, -0.3, z), 0.09),
            capsule((crank, -0.3, z), (crank + 0.2, -0.3, z), 0.11),
        ),
    }


def _reel(x: float, z: float, r: float) -> Solid:
    """A disc with five holes, facing the front."""
    ports = turned(around(5, tube((r * 0.57, 0, -1), (r * 0.57, 0, 1), r * 0.24), 90), 0, 90)
    return moved(cut(tube((0, -0.1, 0), (0, 0.1, 0), r, 0.02), ports), (x, 0, z))


def projector(draw: Draw) -> Parts:
    """A film projector, its lens to the left, its two reels above."""
    x, y, high = draw(0.58, 0.66), draw(0.28, 0.34), draw(0.72, 0.84)
    r, reach, foot = draw(0.5, 0.56), draw(0.3, 0.38), draw(0.16, 0.2)
    low, top = foot, foot + high
    left, right, up = -r - 0.04, r + 0.04, top + r + 0.1
    z, front = low + high * 0.6, -x - reach
    return {
        "body": box((0, 0, (low + top) / 2), (x, y, high / 2), 0.05),
        "lens": join(
            tube((-x + 0.05, 0, z), (front, 0, z), 0.18, 0.02),
            tube((front - 0.16, 0, z), (front, 0, z), 0.24, 0.03),
        ),
        "reels": join(_reel(left, up, r), _reel(right, up, r)),
        "hubs": join(*(tube((v, -0.17, up), (v, 0.17, up), 0.15, 0.02) for v in (left, right))),
        "base": join(
            box((0, 0, foot / 2), (x + 0.14, y + 0.08, foot / 2 + 0.02), 0.03),
            both(capsule((x * 0.4, 0, top - 0.06), (r + 0.04, 0, up), 0.1)),
        ),
        "door": box((0.1, -y, z - 0.04), (x * 0.5, 0.05, high * 0.26), 0.02),
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


def cash_register(draw: Draw) -> Parts:
    """An old one: keys on its slope, the sum in a frame above, a drawer below."""
    x, y, low = draw(0.82, 0.94), draw(0.66, 0.74), draw(0.36, 0.42)
    high, shoulder, sign = draw(1.1, 1.22), draw(0.0, 0.08), draw(0.2, 0.24)
    front = -y + 0.14
    side = [(front, low), (front, low + 0.14), (shoulder, high), (y - 0.06, high), (y - 0.06, low)]
    a, b = (front, low + 0.14), (shoulder, high)
    keys = []
    for row in range(3):
        t = (row + 0.6) / 3.2
        v, z = a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t
        keys += [
            tube((x * u, v + 0.1, z - 0.08), (x * u, v - 0.12, z + 0.09), 0.095, 0.02)
            for u in (-0.68, -0.34, 0.0, 0.34, 0.68)
        ]
    middle = (shoulder + y) / 2
    return {
        "body": join(
            prism(side, 0, x),
            box((0, 0, low / 2), (x + 0.1, y + 0.04, low / 2), 0.02),
            box((0, middle, high + 0.04), (x * 0.8, 0.24, 0.09), 0.02),
        ),
        "keys": join(*keys),
        "display": box((0, middle, high + sign + 0.1), (x * 0.62, 0.2, sign), 0.01),
        "frame": join(
            both(box((x * 0.7, middle, high + sign + 0.1), (0.11, 0.16, sign + 0.06), 0.02)),
            box((0, middle, high + 2 * sign + 0.16), (x * 0.8, 0.18, 0.09), 0.03),
        ),
        "drawer": box((0, -y, low * 0.5), (x * 0.86, 0.1, low * 0.32), 0.01),
        "knob": tube((0, -y - 0.2, low * 0.5), (0, -y, low * 0.5), 0.1, 0.03),
    }


def calculator(draw: Draw) -> Parts:
    """A wedge that lies, its large keys in four rows and three columns, its screen at the back."""
    x, y, lift, low = draw(0.8, 0.9), draw(1.14, 1.24), draw(15, 20), 0.22
    pane, pitch = draw(0.24, 0.28), (x - 0.06) * 2 / 3
    step = (2 * y - 2 * pane - 0.34) / 4
    rise, run = math.sin(math.radians(lift)) * 2 * y, math.cos(math.radians(lift)) * y
    side = [(-run, 0), (run + 0.1, 0), (run, low + rise), (-run, low)]
    middle = (0.0, 0.0, low + rise / 2)

    def key_at(k: int, row: int) -> Solid:
        place = (pitch * (k - 1), -y + 0.06 + step * (row + 0.5), 0)
        return box(place, (pitch / 2 - 0.08, step / 2 - 0.07, 0.14))

    def column(k: int) -> Solid:
        return join(*(key_at(k, row) for row in range(4)))

    return {
        "body": prism(side, 0, x),
        "display": tilted(box((0, y - pane - 0.12, 0), (x - 0.13, pane, 0.09)), lift, middle),
        "keys": tilted(join(column(0), column(1)), lift, middle),
        "accents": tilted(column(2), lift, middle),
    }


APPLIANCES = {
    "jukebox": jukebox,
    "desktop computer": desktop_computer,
    "coffee machine": coffee_machine,
    "vacuum cleaner": vacuum_cleaner,
    "lawn mower": lawn_mower,
    "power drill": power_drill,
    "sewing machine": sewing_machine,
    "record player": record_player,
    "projector": projector,
    "clothes iron": clothes_iron,
    "cash register": cash_register,
    "calculator": calculator,
}
