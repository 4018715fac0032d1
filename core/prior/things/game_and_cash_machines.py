"""Machines for games and for money."""

import math

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
    ball,
    blend,
    both,
    box,
    capsule,
    cut,
    join,
    limb,
    mirrored,
    moved,
    prism,
    smooth_curve,
    taper,
    tilted,
    tube,
    turned,
)


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


def atm(draw: Draw) -> Parts:
    """A tall case with a sloped screen, a desk of keys, notes that come out, and a sign above."""
    wide, high, deep = draw(0.62, 0.72), draw(2.1, 2.3), draw(0.46, 0.56)
    desk, front, back = high * draw(0.4, 0.44), -deep, 0.3 - deep
    case = [(front + 0.08, 0), (front + 0.08, desk - 0.34), (front - 0.22, desk - 0.14)]
    case += [(front - 0.22, desk), (front + 0.1, desk + 0.12), (back, high - 0.56)]
    case += [(front, high - 0.5), (front, high), (deep, high), (deep, 0)]
    rise = high - 0.68 - desk
    lean = -math.degrees(math.atan2(back - front - 0.1, rise))
    middle = (front + back) / 2 + 0.05, desk + 0.12 + rise / 2
    screen = box((-0.13, 0, 0), (wide - 0.26, 0.06, rise / 2 - 0.06), 0.02)
    card = box((wide - 0.15, 0, 0), (0.085, 0.09, 0.17), 0.02)
    grid = [(i * 0.21, j * 0.17) for i in (-1, 0, 1) for j in (-0.5, 0.5)]
    pad = join(*(box((u, v, 0), (0.075, 0.06, 0.07), 0.01) for u, v in grid))
    z = desk - 0.62
    mouth = box((0, front + 0.08, z), (wide * 0.7, 0.06, 0.15), 0.02)
    base, s = high - 0.41, 0.062

    def stroke(*points: tuple[float, float]) -> Solid:
        return limb([(u * wide, front - 0.07, base + v) for u, v in points], s, s)

    letters = join(
        stroke((-0.8, 0), (-0.56, 0.32), (-0.32, 0)),
        stroke((-0.66, 0.1), (-0.46, 0.1)),
        stroke((-0.26, 0.32), (0.18, 0.32)),
        stroke((-0.04, 0.32), (-0.04, 0)),
        stroke((0.28, 0), (0.3, 0.32), (0.54, 0.1), (0.78, 0.32), (0.8, 0)),
    )
    return {
        "body": prism(case, 0, wide),
        "screen": moved(turned(screen, 0, lean), (0, *middle)),
        "keys": moved(turned(pad, 0, 20.6), (-0.1, front - 0.06, desk + 0.06)),
        "panels": join(
            box((0, front, base + 0.16), (wide + 0.04, 0.07, 0.29), 0.03),
            mouth,
            moved(turned(card, 0, lean), (0, *middle)),
        ),
        "letters": letters,
        "notes": box((0, front - 0.1, z), (wide * 0.48, 0.22, 0.07)),
    }


def game_controller(draw: Draw) -> Parts:
    """A gamepad with two grips, its face to the front and up."""
    x, lean, up = draw(0.68, 0.8), draw(35, 60), (0, 0, 0.75)
    shell = blend(
        0.16,
        box((0, 0.08, 0), (x, 0.42, 0.2), 0.16),
        both(taper((x, 0.05, 0), (x + draw(0.1, 0.25), -0.72, -0.14), 0.42, 0.21)),
    )
    flat = cut(shell, box((0, 0, 1.22), (2, 2, 1)))
    pad = join(box((-x, 0.1, 0.22), (0.26, 0.09, 0.1)), box((-x, 0.1, 0.22), (0.09, 0.26, 0.1)))
    dots = (ball((x + u * 0.2, 0.1 + v * 0.2, 0.24), 0.1) for u, v in ((0, 1), (1, 0), (0, -1)))
    stick = join(
        tube((0.32, -0.28, 0), (0.32, -0.28, 0.4), 0.11),
        tube((0.32, -0.28, 0.34), (0.32, -0.28, 0.46), 0.19, 0.05),
    )
    parts = {
        "body": flat,
        "pad": pad,
        "buttons": join(*dots, ball((x - 0.2, 0.1, 0.24), 0.1)),
        "sticks": both(stick),
        "triggers": both(box((x, 0.5, 0.02), (0.26, 0.14, 0.12), 0.08)),
    }
    return {name: tilted(solid, lean, up) for name, solid in parts.items()}


def game_console(draw: Draw) -> Parts:
    """One for the hand, upright: a screen in its bezel above a cross and buttons, or between."""
    if draw.chance(0.35):
        x, high, y = draw(1.3, 1.48), draw(1.25, 1.6), draw(0.18, 0.28)
        z, wide, tall = high / 2, x * 0.5, high / 2 - 0.14
        side, level, keys, apart = x * 0.76, high * 0.56, high * 0.2, 0.15
    else:
        x, high, y = draw(0.86, 1.12), draw(2.3, 3.0), draw(0.2, 0.36)
        z, wide, tall = draw(0.7, 0.74) * high, x - 0.12, high * draw(0.19, 0.235)
        side, level, keys, apart = x * 0.5, high * 0.36, high * 0.14, 0.19
    cross, rim, front = draw(0.09, 0.11), draw(0.13, 0.24), -y - 0.03
    pads = [(side + k * apart, level + k * 0.1) for k in (1, -1)]
    key = turned(capsule((-0.12, 0, 0), (0.12, 0, 0), 0.085), 1, -25)
    slit = turned(capsule((0, 0, -0.13), (0, 0, 0.13), 0.07), 1, 25)
    return {
        "body": box((0, 0, high / 2), (x, y, high / 2), 0.12),
        "bezel": box((0, -y, z), (wide, 0.05, tall), 0.04),
        "screen": box((0, -y - 0.03, z), (wide - rim, 0.06, tall - 0.13), 0.02),
        "cross": join(
            box((-side, front, level), (cross * 3, 0.1, cross), 0.02),
            box((-side, front, level), (cross, 0.1, cross * 3), 0.02),
        ),
        "buttons": join(*(tube((u, front - 0.09, v), (u, 0, v), apart - 0.02, 0.04)
                          for u, v in pads)),
        "keys": join(
            *(moved(key, (u - side * 0.9, -y, keys)) for u in (-0.18, 0.18)),
            *(moved(slit, (u + side, -y, keys)) for u in (-0.14, 0.14)),
        ),
    }  # fmt: skip


def vr_headset(draw: Draw) -> Parts:
    """A visor with cameras, foam behind it, and straps round where a head would be."""
    r, wide, high = draw(0.78, 0.86), draw(0.8, 0.9), draw(0.36, 0.42)
    z, deep, band = draw(0.62, 0.7), draw(0.2, 0.25), draw(0.15, 0.19)
    inner, y = r - 0.14, -r - deep * 0.5
    front = y - deep
    nose = tube((0, -3, z - high - 0.1), (0, 0, z - high - 0.1), 0.26)
    hollow = tube((0, 0, -1), (0, 0, 3), inner)
    round_head = cut(tube((0, 0, z - band), (0, 0, z + band), r, 0.03), hollow)
    over = cut(
        tube((-band, 0, z), (band, 0, z), r + 0.08, 0.03),
        tube((-1, 0, z), (1, 0, z), inner + 0.08),
        box((0, 0, z - 2), (2, 2, 2)),
    )
    lens = tube((wide * 0.6, front - 0.12, z), (wide * 0.6, y, z), 0.17, 0.03)
    return {
        "visor": cut(box((0, y, z), (wide, deep, high), 0.14), nose),
        "foam": cut(
            box((0, y + deep + 0.12, z), (wide * 0.86, 0.2, high * 0.86), 0.08), hollow, nose
        ),
        "straps": join(round_head, over),
        "plate": cut(box((0, front, z), (wide * 0.92, 0.06, high * 0.78), 0.05), nose),
        "cameras": both(join(lens, ball((wide * 0.6, front - 0.1, z), 0.1))),
        "pads": join(
            box((0, r, z), (0.32, 0.13, 0.26), 0.08),
            both(box((r - 0.02, -r * 0.3, z), (0.1, 0.3, band + 0.06), 0.05)),
            box((0, r * 0.1, z + r + 0.05), (band + 0.07, 0.24, 0.1), 0.05),
        ),
    }


def arcade_machine(draw: Draw) -> Parts:
    """An upright cabinet with a screen, a joystick and buttons."""
    x, y, desk, top = draw(0.5, 0.6), draw(0.45, 0.55), draw(0.85, 0.98), draw(2.2, 2.45)
    lip, sill = desk + 0.24, top - 0.42
    side = [(-y, 0), (y, 0), (y, top), (-y * 0.8, top), (-y * 0.8, sill), (0.1, sill - 0.05)]
    side += [(-y * 0.5, lip), (-y - 0.25, desk), (-y - 0.25, desk - 0.14), (-y, desk - 0.3)]
    glass = [(0.1, sill - 0.08), (-y * 0.44, lip + 0.08), (-y * 0.44 - 0.06, lip + 0.14)]
    knob = (-x * 0.45, -y - 0.02, desk + 0.42)
    dots = (ball((x * u, -y - 0.03, desk + 0.13), 0.1) for u in (0.1, 0.58))
    return {
        "body": prism(side, 0, x),
        "screen": prism([*glass, (0.02, sill - 0.02)], 0, x * 0.82),
        "marquee": box((0, -y * 0.8, (top + sill) / 2), (x * 0.9, 0.05, 0.15), 0.02),
        "joystick": join(capsule((knob[0], knob[1], desk), knob, 0.085), ball(knob, 0.14)),
        "buttons": join(*dots),
        "door": box((0, -y, desk * 0.34), (x * 0.5, 0.05, desk * 0.22), 0.02),
    }


def slot_machine(draw: Draw) -> Parts:
    """A cabinet with three reels that show sevens, a lever at its side, a tray, a sign above."""
    x, y, high = draw(0.68, 0.98), draw(0.45, 0.7), draw(1.8, 2.4)
    z, tall, shelf = high * draw(0.62, 0.68), draw(0.27, 0.36), draw(0.46, 0.6)
    pitch, arm = x * 0.52, x + 0.26
    arch = smooth_curve(
        [(x * 0.98, high - 0.1), (x * 0.9, high + 0.36), (0.34, high + draw(0.46, 0.66))]
    )
    seven = [(-0.13, 0.1), (-0.13, 0.22), (0.15, 0.22), (0.15, 0.12), (0.03, -0.22), (-0.12, -0.22),
             (0.0, 0.1)]  # fmt: skip
    sevens = [moved(prism(seven, 1, 0.12), (pitch * k, -y - 0.05, z)) for k in (-1, 0, 1)]
    lamp = [tube((x * 0.3 * k, -y - 0.04, high + 0.24), (x * 0.3 * k, y * 0.5, high + 0.24), 0.1)
            for k in (-2, 0, 2)]  # fmt: skip
    return {
        "cabinet": join(
            cut(
                box((0, 0, high / 2), (x, y, high / 2), 0.06),
                box((0, -y, z), (pitch * 1.42, 0.12, tall)),
                box((0, -y, shelf - 0.1), (x * 0.62, 0.24, 0.16)),
            ),
            box((0, -y - 0.02, z - tall - 0.3), (x * 0.98, 0.18, 0.1), 0.03),
        ),
        "sign": prism(mirrored(arch), 1, y * 0.8),
        "trim": join(
            cut(
                box((0, -y, z), (pitch * 1.42 + 0.12, 0.07, tall + 0.12), 0.02),
                box((0, -y, z), (pitch * 1.42, 1, tall)),
            ),
            box((0, -y - 0.08, shelf - 0.27), (x * 0.7, 0.22, 0.08), 0.03),
            tube((x - 0.05, 0, z - 0.3), (arm + 0.08, 0, z - 0.3), 0.17, 0.03),
            capsule((arm, 0, z - 0.3), (arm, -0.1, high - 0.1), 0.095),
            *lamp,
        ),
        "reels": join(*(tube((pitch * k - pitch * 0.42, -y + 0.3, z),
                             (pitch * k + pitch * 0.42, -y + 0.3, z), tall + 0.04)
                        for k in (-1, 0, 1))),
        "sevens": join(*sevens),
        "knob": join(
            ball((arm, -0.1, high), draw(0.19, 0.24)),
            *(tube((u, -y - 0.02, z - tall - 0.3), (u, -y - 0.02, z - tall - 0.14), 0.11, 0.02)
              for u in (-x * 0.5, 0, x * 0.5)),
        ),
    }  # fmt: skip


GAME_AND_CASH_MACHINES = {
    "cash register": cash_register,
    "atm": atm,
    "game controller": game_controller,
    "game console": game_console,
    "vr headset": vr_headset,
    "arcade machine": arcade_machine,
    "slot machine": slot_machine,
}
