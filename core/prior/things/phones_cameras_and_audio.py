"""Telephones, cameras, television, and machines that play or record sound."""

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
    turned,
    within,
)


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


def security_camera(draw: Draw) -> Parts:
    """Its lens to the front under a hood, on a post with a round foot."""
    x, y, z = draw(0.34, 0.4), draw(0.74, 0.84), draw(0.32, 0.37)
    foot, post, dip = draw(0.46, 0.54), draw(0.62, 0.76), draw(8, 14)
    middle = post + z + 0.14
    hood = join(
        box((0, -0.14, z + 0.05), (x + 0.14, y + 0.14, 0.08), 0.02),
        both(box((x + 0.07, -0.14, z * 0.5), (0.075, y + 0.14, z * 0.5 + 0.1), 0.02)),
    )

    def aimed(solid: Solid) -> Solid:
        return moved(turned(solid, 0, dip), (0, 0, middle))

    return {
        "body": aimed(box((0, 0, 0), (x, y, z), 0.05)),
        "hood": aimed(hood),
        "lens": aimed(tube((0, -y - 0.12, 0), (0, 0, 0), x * 0.74, 0.03)),
        "glass": aimed(tube((0, -y - 0.15, 0), (0, 0, 0), x * 0.42, 0.02)),
        "stand": join(
            lathe([(foot, 0), (foot, 0.12), (foot * 0.5, 0.2)], 0.02),
            tube((0, 0, 0.1), (0, 0, post), 0.13),
            ball((0, 0, post), 0.21),
        ),
        "light": aimed(ball((x * 0.68, -y, -z * 0.7), 0.075)),
    }


def television(draw: Draw) -> Parts:
    """A flat screen on a foot, or an old set with aerials and knobs."""
    if draw.chance(0.5):
        x, z = draw(1.2, 1.4), draw(0.68, 0.8)
        return {
            "body": box((0, 0, z + 0.3), (x, 0.12, z), 0.03),
            "screen": box((0, -0.1, z + 0.3), (x - 0.11, 0.06, z - 0.11)),
            "stand": join(
                box((0, 0.02, 0.25), (0.18, 0.1, 0.25)),
                box((0, 0, 0.07), (draw(0.4, 0.75), 0.34, 0.08), 0.03),
            ),
            "buttons": both(box((0.2, -0.12, 0.36), (0.08, 0.06, 0.06))),
        }
    x, z, y = draw(0.8, 0.95), draw(0.6, 0.7), draw(0.45, 0.6)
    m = z + 0.25
    ears = both(capsule((0.05, 0, m + z - 0.05), (0.45, 0, m + z + draw(0.45, 0.65)), 0.085))
    return {
        "body": box((0, 0, m), (x, y, z), 0.1),
        "screen": box((-x * 0.2, -y, m), (x * 0.66, 0.07, z * 0.76), 0.06),
        "stand": join(
            both(taper((x * 0.75, y * 0.6, 0.1), (x * 0.6, y * 0.5, 0.4), 0.09, 0.12), 0, 1), ears
        ),
        "buttons": join(
            *(
                tube((x * 0.76, -y - 0.1, m + s), (x * 0.76, -y + 0.1, m + s), 0.12, 0.02)
                for s in (-0.06, 0.36)
            )
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


def satellite_dish(draw: Draw) -> Parts:
    """A bowl that looks up to the front, its receiver on arms before it, on a mast with a foot."""
    r, deep, wall = draw(0.92, 1.04), draw(0.44, 0.54), 0.17
    lean, z, large = draw(38, 50), draw(1.3, 1.5), draw.chance(0.5)
    shares = [k / 6 for k in range(7)]
    outer = [(r * s, deep * s * s - wall) for s in shares]
    inner = [(r * s, deep * s * s) for s in reversed(shares)]
    focus = draw(0.8, 0.94)
    arm = capsule((r * 0.8, 0, deep * 0.6), (0.06, 0, focus), 0.068)
    # The single arm is at the lower side; three stand evenly.
    arms = around(3, arm, -90) if large else capsule((0, -r * 0.9, 0.2), (0, 0, focus), 0.085)
    horn = join(
        tube((0, 0, focus - 0.24), (0, 0, focus + 0.2), 0.18, 0.04),
        tube((0, 0, focus - 0.26), (0, 0, focus - 0.1), 0.24, 0.03),
    )

    def aimed(solid: Solid) -> Solid:
        return tilted(solid, lean, (0, 0, z))

    tower = lathe([(0.56, 0.0), (0.56, 0.12), (0.26, 0.2), (0.2, z - 0.3)], 0.02, (0, 0.3))
    plate = box((0, 0.3, 0.08), (0.46, 0.42, 0.08), 0.02)
    pole = tube((0, 0.3, 0), (0, 0.3, z - 0.1), 0.12)
    yoke = both(box((0.24, 0.26, z - 0.22), (0.08, 0.18, 0.26), 0.03))
    return {
        "dish": aimed(lathe([*outer, *inner])),
        "rim": aimed(ring((0, 0, deep - wall / 2), r - 0.01, 0.11)),
        "receiver": aimed(horn),
        "arms": aimed(arms),
        "mast": join(tower if large else pole, aimed(tube((0, 0, -0.34), (0, 0, 0), 0.24, 0.03))),
        "foot": join(tube((0, 0.3, 0), (0, 0.3, 0.16), 0.7, 0.03), yoke) if large else plate,
    }


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


def boombox(draw: Draw) -> Parts:
    """Two large speakers, a cassette deck between them, buttons, a bright handle and aerial."""
    x, y, half = draw(1.32, 1.36), draw(0.36, 0.38), draw(0.57, 0.6)
    at, r, top = x * 0.63, draw(0.38, 0.4), 2 * half
    speaker = join(tube((at, -y - 0.05, half), (at, 0, half), r),
                   ball((at, -y - 0.02, half), 0.17))  # fmt: skip
    bow = join(
        both(box((x * 0.54, 0, top + 0.12), (0.12, 0.13, 0.26), 0.04)),
        box((0, 0, top + 0.36), (x * 0.54 + 0.12, 0.13, 0.12), 0.05),
    )
    keys = [box((0.32 * k, -y + 0.17, top + 0.02), (0.1, 0.13, 0.13), 0.04) for k in (-1, 0, 1)]
    foot, tip = (x - 0.16, 0.06, top - 0.1), (x + 0.06, 0.06, top + 0.86)
    return {
        "body": box((0, 0, half), (x, y, half), 0.1),
        "rims": both(ring((at, -y, half), r, 0.1, 1)),
        "speakers": both(speaker),
        "deck": join(
            box((0, -y, half * 0.68), (0.27, 0.09, 0.21), 0.03),
            box((0, -y, half * 1.52), (0.27, 0.09, 0.13), 0.03),
        ),
        "reels": both(tube((0.14, -y - 0.18, half * 0.68), (0.14, -y, half * 0.68), 0.09, 0.02)),
        "buttons": join(*keys),
        "handle": join(bow, capsule(foot, tip, 0.08), ball(tip, 0.13)),
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


PHONES_CAMERAS_AND_AUDIO = {
    "phone": phone,
    "telephone": telephone,
    "camera": camera,
    "security camera": security_camera,
    "television": television,
    "projector": projector,
    "satellite dish": satellite_dish,
    "radio": radio,
    "boombox": boombox,
    "record player": record_player,
    "jukebox": jukebox,
    "speaker": speaker,
    "microphone": microphone,
    "headphones": headphones,
}
