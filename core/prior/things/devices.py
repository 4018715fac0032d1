"""Electronic devices."""

import math

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
    limb,
    mirrored,
    moved,
    prism,
    ring,
    smooth_curve,
    taper,
    tilted,
    tube,
    within,
)


def laptop(draw: Draw) -> Parts:
    """Open, its screen leaning back."""
    x, y, high, lean = draw(0.95, 1.1), draw(0.62, 0.74), draw(0.6, 0.72), draw(8, 25)
    hinge = (0, y - 0.06, 0.14)
    lid = tilted(box((0, 0, high), (x, 0.09, high), 0.05), -lean, hinge)
    return {
        "body": join(box((0, 0, 0.1), (x, y, 0.1), 0.06), lid),
        # Blocks that reach into what they lie on: of a thin board little comes out.
        "screen": tilted(box((0, -0.04, high), (x - 0.1, 0.1, high - 0.11)), -lean, hinge),
        "keys": box((0, y * 0.24, 0.12), (x * 0.84, y * 0.42, 0.13)),
        "touchpad": box((0, -y * 0.58, 0.11), (x * 0.3, y * 0.24, 0.13)),
    }


def phone(draw: Draw) -> Parts:
    """A smartphone standing upright, its cameras on the back."""
    x, thick, high, soft = draw(0.46, 0.56), draw(0.09, 0.12), draw(0.95, 1.1), draw(0.07, 0.09)
    lenses = (
        tube((x * 0.5, thick, high * v), (x * 0.5, thick + 0.11, high * v), 0.1, 0.02)
        for v in (1.75, 1.5)
    )
    return {
        "body": box((0, 0, high), (x, thick, high), soft),
        "screen": box((0, -thick, high), (x - 0.07, 0.04, high - 0.09)),
        "camera": join(*lenses),
        "buttons": box((x, 0, high * 1.4), (0.05, 0.05, 0.18)),
    }


def monitor(draw: Draw) -> Parts:
    """A flat computer screen on a foot."""
    x, half, low = draw(0.98, 1.2), draw(0.56, 0.7), draw(0.4, 0.55)
    z, rim = low + half, draw(0.08, 0.12)
    round_foot = tube((0, 0.1, 0), (0, 0.1, 0.15), 0.5, 0.04)
    square_foot = box((0, 0.1, 0.08), (0.55, 0.36, 0.08), 0.03)
    return {
        "body": box((0, 0, z), (x, 0.11, half), 0.04),
        "screen": box((0, -0.1, z + 0.03), (x - rim, 0.04, half - rim - 0.03)),
        "stand": join(
            box((0, 0.14, low * 0.6 + 0.1), (draw(0.11, 0.18), 0.09, low * 0.6 + 0.1), 0.03),
            round_foot if draw.chance(0.5) else square_foot,
        ),
        "button": ball((x * 0.82, -0.11, low + 0.07), 0.05),
    }


ACCENTS = ((0, 1.5), (5, 0.5), (5, -0.5))  # where no plain key is


def keyboard(draw: Draw) -> Parts:
    """It lies, its keys in four rows."""
    pitch, row, high, tall = draw(0.38, 0.43), draw(0.36, 0.4), draw(0.2, 0.28), draw(0.12, 0.18)
    x, y = 3 * pitch + 0.1, 2 * row + 0.1

    def key(column: float, line: float, wide: float = 0.5, deep: float = 0.5) -> Solid:
        half = (wide * pitch - 0.08, deep * row - 0.08, tall)
        return box((column * pitch, line * row, high), half)

    keys = (key(c - 2.5, r) for r in (-0.5, 0.5, 1.5) for c in range(6) if (c, r) not in ACCENTS)
    return {
        "body": box((0, 0, high / 2), (x, y, high / 2)),
        "keys": join(*keys, key(0, -1.5, 2), both(key(2.5, -1.5))),
        "accents": join(key(-2.5, 1.5), key(2.5, 0, deep=1)),
    }


def camera(draw: Draw) -> Parts:
    """A photo camera, its lens to the front."""
    x, y, z = draw(0.8, 0.95), draw(0.26, 0.34), draw(0.46, 0.56)
    wide, reach = draw(0.34, 0.42), draw(0.3, 0.6)
    hump = [(-0.34, 2 * z - 0.05), (0.34, 2 * z - 0.05), (0.22, 2 * z + 0.2), (-0.22, 2 * z + 0.2)]
    front = -y - reach
    return {
        "body": join(box((0, 0, z), (x, y, z), 0.08), prism(hump, 1, y * 0.8)),
        "grip": box((0, 0, z * 0.9), (x + 0.03, y + 0.03, z * 0.55), 0.07),
        "lens": join(
            tube((0, 0, z), (0, front, z), wide, 0.03),
            tube((0, front, z), (0, front + 0.2, z), wide + 0.05, 0.03),
        ),
        "glass": egg((0, front, z), (wide * 0.72, 0.08, wide * 0.72)),
        "button": tube((-x * 0.68, 0, z), (-x * 0.68, 0, 2 * z + 0.12), 0.13, 0.03),
        "flash": box((x * 0.7, -y, 2 * z - 0.14), (0.13, 0.07, 0.08), 0.02),
    }


def speaker(draw: Draw) -> Parts:
    """A loudspeaker box with a large and a small cone."""
    x, y, z = draw(0.54, 0.66), draw(0.42, 0.55), draw(0.95, 1.1)
    big, small = x * draw(0.66, 0.74), x * draw(0.4, 0.46)
    cones = ((big, 0.18 + big), (small, 2 * z - 0.2 - small))
    dish = (tube((0, -y - 0.05, v), (0, 0, v), r) for r, v in cones)
    rims = (ring((0, -y - 0.03, v), r, 0.085, axis=1) for r, v in cones)
    cap = tube((0, -y - 0.12, cones[0][1]), (0, -y, cones[0][1]), big * 0.4)
    return {"body": box((0, 0, z), (x, y, z)), "cones": join(*dish), "rims": join(*rims, cap)}


def microphone(draw: Draw) -> Parts:
    """Held upright; some have a foot."""
    high, head, low = draw(1.25, 1.5), draw(0.36, 0.44), draw(0.14, 0.17)
    grip = lathe([(low, 0.05), (low + 0.03, 0.4), (head * 0.72, high)], 0.02)
    parts = {
        "head": egg((0, 0, high + head * 0.75), (head, head, head * draw(1.0, 1.2))),
        "handle": grip,
        "ring": tube((0, 0, high - 0.08), (0, 0, high + 0.12), head * 0.95, 0.04),
        "switch": box((0, -low - 0.1, high * 0.62), (0.07, 0.12, 0.14), 0.03),
    }
    if draw.has("stand", 0.4):
        parts |= {"stand": lathe([(0.58, -0.12), (0.56, 0.06), (0.22, 0.16)], 0.02)}
    return parts


def radio(draw: Draw) -> Parts:
    """A portable radio with a handle and an upright aerial."""
    x, y, z = draw(0.88, 1.05), draw(0.28, 0.36), draw(0.48, 0.6)
    wide, left = z * draw(0.66, 0.74), x * 0.45
    bow = both(box((x * 0.55, 0, 2 * z + 0.12), (0.09, 0.1, 0.26)))
    knobs = (tube((x * u, -y - 0.14, z * 0.55), (x * u, 0, z * 0.55), 0.15) for u in (0.26, 0.72))
    tip = (x - 0.12, y * 0.4, 2 * z + draw(0.7, 0.9))
    return {
        "body": box((0, 0, z), (x, y, z), 0.04),
        "speaker": tube((-left, -y - 0.08, z), (-left, 0, z), wide),
        "dial": box((x * 0.49, -y, z * 1.42), (x * 0.38, 0.07, z * 0.28)),
        "knobs": join(*knobs),
        "handle": join(bow, box((0, 0, 2 * z + 0.32), (x * 0.55 + 0.09, 0.1, 0.09))),
        "aerial": join(capsule((x - 0.12, y * 0.4, z), tip, 0.085), ball(tip, 0.13)),
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


def telephone(draw: Draw) -> Parts:
    """A rotary telephone of the 1940s: a flared body, a dial with a hub, a receiver on a cradle."""
    x, y, z = draw(0.78, 0.86), draw(0.9, 1.0), draw(0.86, 0.94)
    reach, rise, ledge = draw(0.96, 1.04), z + 0.34, -0.12
    side = [(-y, 0), (-y, 0.18), (ledge, z), (0.5, z), (0.62, z * 0.55), (0.8, 0.18), (0.8, 0)]
    front = [(x, 0), (x, 0.16), (x - 0.14, z * 0.42), (x - 0.25, z * 0.7), (x - 0.31, z + 0.1)]
    lean = math.degrees(math.atan2(z - 0.18, y + ledge))
    dial = (0, (ledge - y) / 2, (z + 0.18) / 2)
    plate = cut(tube((0, 0, -0.1), (0, 0, 0.15), 0.47, 0.02), tube((0, 0, 0.06), (0, 0, 1), 0.32))
    hub = lathe([(0.16, -0.1), (0.16, 0.12), (0.1, 0.17)], 0.01)
    top, half = z + 0.2, x - 0.36
    cradle = join(
        box((0, 0.2, top), (half, 0.2, 0.24), 0.04),
        both(moved(both(box((half - 0.12, 0.24, top + 0.2), (0.12, 0.1, 0.2), 0.05), 1),
                   (0, 0.2, 0))),
    )  # fmt: skip
    bow = [(-reach, rise), (-reach * 0.62, rise + 0.1), (reach * 0.62, rise + 0.1), (reach, rise)]
    cup = lathe([(0.27, -0.34), (0.29, -0.28), (0.28, -0.16), (0.17, 0.06), (0.1, 0.12)], 0.01)
    return {
        "body": join(within(prism(side, 0, 1), prism(mirrored(front), 1, 2)), cradle),
        "dial": tilted(plate, lean, dial),
        "hub": tilted(hub, lean, dial),
        "receiver": join(
            limb([(u, 0.2, v) for u, v in smooth_curve(bow)], 0.14, 0.14),
            both(moved(cup, (reach, 0.2, rise))),
        ),
    }


def headphones(draw: Draw) -> Parts:
    """A band over two ear cups."""
    x, z, wide = draw(0.78, 0.9), draw(0.65, 0.9), draw(0.38, 0.48)
    band = cut(ring((0, 0, z), x, draw(0.1, 0.13), axis=1), box((0, 0, z - 1), (2, 2, 1)))
    sides = both(capsule((x, 0, z), (x, 0, 0.5), 0.11))
    return {
        "band": join(band, sides),
        "cups": both(tube((x - 0.06, 0, 0.45), (x + 0.2, 0, 0.45), wide, 0.08)),
        "cushions": both(tube((x - 0.3, 0, 0.45), (x, 0, 0.45), wide * 0.92, 0.1)),
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


def printer(draw: Draw) -> Parts:
    """Paper stands at the back and lies on the tray in front."""
    x, y, z, lean = draw(0.85, 1.0), draw(0.55, 0.7), draw(0.36, 0.46), draw(10, 25)
    sheet, at = draw(0.3, 0.45), (0, y * 0.6, 2 * z - 0.1)
    slot = box((0, -y, z * 0.8), (x * 0.72, 0.3, z * 0.36))
    return {
        "body": join(
            cut(box((0, 0, z), (x, y, z), 0.07), slot),
            tilted(box((0, 0.12, 0.2), (x * 0.72, 0.09, 0.28), 0.03), -lean, at),
        ),
        "paper": join(
            tilted(box((0, 0, sheet), (x * 0.6, 0.09, sheet + 0.1)), -lean, at),
            box((0, -y - 0.05, z * 0.62), (x * 0.58, 0.36, 0.08)),
        ),
        "tray": box((0, -y - 0.1, z * 0.42), (x * 0.72, 0.4, 0.09), 0.02),
        "panel": box((x * 0.6, -y * 0.5, 2 * z), (x * 0.26, y * 0.3, 0.05), 0.02),
        "buttons": join(*(ball((-x * u, -y * 0.5, 2 * z), 0.1) for u in (0.75, 0.5))),
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


DEVICES = {
    "laptop": laptop,
    "phone": phone,
    "monitor": monitor,
    "keyboard": keyboard,
    "camera": camera,
    "speaker": speaker,
    "microphone": microphone,
    "radio": radio,
    "game controller": game_controller,
    "light bulb": light_bulb,
    "telephone": telephone,
    "headphones": headphones,
    "drone": drone,
    "printer": printer,
    "arcade machine": arcade_machine,
}
