"""Gadgets, optical instruments and sports gear; with the symbols."""

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
    moved,
    prism,
    ring,
    smooth_curve,
    taper,
    tube,
    turned,
)
from core.prior.things.symbols import SYMBOLS


def pistol(draw: Draw) -> Parts:
    """Upright, its muzzle to the left."""
    long, y, high, grip = draw(1.15, 1.3), draw(0.15, 0.18), draw(0.17, 0.2), draw(0.85, 1.0)
    z, lean, wide = grip + 0.32, draw(0.22, 0.32), draw(0.24, 0.28)
    x = 0.75  # the grip's front edge at its top
    butt = [(x - wide * 0.6, z), (x + wide * 1.5, z), (x + wide * 1.5 + lean, 0.05)]
    butt += [(x + wide * 1.3 + lean, 0), (x - wide * 0.5 + lean, 0)]
    guard = [(x - 0.62, z - 0.1), (x - 0.56, z - 0.56), (x + 0.14, z - 0.56), (x + 0.14, z - 0.1)]
    inner = [(x - 0.47, z - 0.14), (x - 0.43, z - 0.41), (x + 0.02, z - 0.41), (x + 0.02, z - 0.14)]
    top = z + 0.12 + 2 * high
    slide = join(
        box((x + 0.4 - long, 0, z + 0.1 + high), (long, y, high), 0.04),
        box((x + 0.48 - 2 * long, 0, top), (0.09, 0.08, 0.09), 0.02),
        box((x + 0.26, 0, top), (0.1, y * 0.8, 0.09), 0.02),
    )
    bore = x + 0.4 - 2 * long
    return {
        "barrel": cut(
            slide, tube((bore - 1, 0, z + 0.14 + high), (bore + 0.3, 0, z + 0.14 + high), 0.09)
        ),
        "frame": join(
            box((x + 0.36 - long * 0.86, 0, z), (long * 0.86, y * 0.9, 0.14), 0.03),
            cut(prism(guard, 1, 0.1), prism(inner, 1, 1)),
            taper((x + 0.3, 0, z + 0.24), (x + 0.5, 0, z + 0.4), 0.14, 0.1),
        ),
        "grip": prism(butt, 1, y * 1.06),
        "trigger": taper((x - 0.17, 0, z - 0.08), (x - 0.2, 0, z - 0.26), 0.085, 0.08),
    }


def chainsaw(draw: Draw) -> Parts:
    """It lies, its bar to the left."""
    long, wide, y = draw(1.25, 1.4), draw(0.17, 0.2), draw(0.26, 0.32)
    z, high = draw(0.34, 0.4), draw(0.72, 0.82)
    tip = 0.15 - long
    outer = wide + 0.09
    plate = join(
        box(((0.2 + tip) / 2, 0, z), ((0.2 - tip) / 2, 0.11, wide)),
        tube((tip, -0.11, z), (tip, 0.11, z), wide),
    )
    chain = join(
        box(((0.2 + tip) / 2, 0, z), ((0.2 - tip) / 2, 0.08, outer)),
        tube((tip, -0.08, z), (tip, 0.08, z), outer),
    )
    count = 6
    tooth = join(
        *(
            prism(
                [(a, side * outer), (a + 0.14, side * outer), (a, side * (outer + 0.08))], 1, 0.08
            )
            for side in (-1, 1)
            for a in (tip + (0.1 - tip) * k / count for k in range(count))
        )
    )
    body = [(0.05, 0.08), (0.95, 0.08), (1.0, 0.4), (0.9, high), (0.3, high + 0.06), (0.02, 0.5)]
    back = join(
        capsule((0.85, 0, high - 0.1), (1.35, 0, high - 0.16), 0.11),
        capsule((1.35, 0, high - 0.16), (1.42, 0, 0.26), 0.11),
        capsule((1.42, 0, 0.26), (0.85, 0, 0.2), 0.11),
    )
    hoop = join(
        capsule((0.36, -y, high - 0.2), (0.34, -y, high + 0.34), 0.1),
        capsule((0.34, -y, high + 0.34), (0.34, y, high + 0.34), 0.1),
        capsule((0.36, y, high - 0.2), (0.34, y, high + 0.34), 0.1),
    )
    return {
        "body": join(prism(body, 1, y), box((0.6, 0, high), (0.28, y * 0.7, 0.12), 0.06)),
        "bar": plate,
        "chain": join(chain, moved(tooth, (0, 0, z))),
        "handles": join(back, hoop),
        "guard": moved(
            turned(box((0, 0, 0), (0.08, y * 0.9, 0.2), 0.03), 1, -16), (-0.06, 0, high + 0.08)
        ),
        "cover": tube((0.5, -y - 0.07, 0.38), (0.5, -y + 0.05, 0.38), draw(0.2, 0.25), 0.03),
    }


def padlock(draw: Draw) -> Parts:
    """Its keyhole to the front, its shackle above."""
    x, y, high = draw(0.62, 0.72), draw(0.24, 0.3), draw(1.0, 1.2)
    bow, thick = x - draw(0.2, 0.25), draw(0.12, 0.145)
    top = high + draw(0.25, 0.4)
    body = box((0, 0, high / 2), (x, y, high / 2), draw(0.06, 0.16))
    if draw.chance(0.3):
        body = join(
            tube((0, -y, x), (0, y, x), x, 0.06), box((0, 0, x + 0.32), (x * 0.92, y, 0.32), 0.06)
        )
        top = max(top, x + 0.95)
    arc = cut(ring((0, 0, top), bow, thick, 1), box((0, 0, top - 1), (2, 1, 1)))
    return {
        "body": body,
        "shackle": join(arc, both(tube((bow, 0, 0.6), (bow, 0, top + 0.01), thick))),
        "keyhole": join(
            tube((0, -y - 0.03, high * 0.52), (0, 0, high * 0.52), 0.14),
            prism(
                [
                    (-0.07, high * 0.52),
                    (0.07, high * 0.52),
                    (0.12, high * 0.22),
                    (-0.12, high * 0.22),
                ],
                1,
                (y + 0.03) / 2,
                -(y + 0.03) / 2,
            ),
        ),
    }


def magnifying_glass(draw: Draw) -> Parts:
    """Upright, its glass above its handle."""
    r, long, thick = draw(0.6, 0.72), draw(0.95, 1.2), draw(0.11, 0.13)
    z = long + 0.28 + r
    return {
        "rim": join(ring((0, 0, z), r, thick, 1), tube((0, 0, long), (0, 0, z - r), 0.1)),
        "glass": egg((0, 0, z), (r + 0.02, draw(0.11, 0.15), r + 0.02)),
        "handle": join(
            taper((0, 0, 0.14), (0, 0, long - 0.1), 0.15, 0.12), ball((0, 0, 0.14), 0.155)
        ),
        "collar": tube((0, 0, long - 0.16), (0, 0, long + 0.08), 0.15, 0.03),
    }


def telescope(draw: Draw) -> Parts:
    """On three legs, aimed up and to the front."""
    long, r, high, up = draw(1.0, 1.15), draw(0.2, 0.25), draw(1.35, 1.55), draw(22, 38)

    def aimed(solid: Solid) -> Solid:
        # The tube is along y; its far end, at -y, goes up.
        return moved(turned(solid, 0, -up), (0, 0, high + 0.28))

    leg = taper((0.08, 0, high - 0.04), (draw(0.62, 0.75), 0, 0.1), 0.11, 0.09)
    return {
        "tube": aimed(
            join(
                tube((0, -long, 0), (0, 0.4, 0), r), tube((0, 0.3, 0), (0, long * 0.8, 0), r * 0.72)
            )
        ),
        "bands": aimed(
            join(
                tube((0, -long - 0.06, 0), (0, -long + 0.14, 0), r + 0.06, 0.02),
                tube((0, 0.28, 0), (0, 0.44, 0), r + 0.04, 0.02),
                tube((0, long * 0.74, 0), (0, long * 0.86, 0), r * 0.72 + 0.04, 0.02),
            )
        ),
        "eyepiece": aimed(
            join(
                tube((0, long * 0.8, 0), (0, long + 0.06, 0), 0.11),
                tube((0, long, 0), (0, long + 0.16, 0), 0.15, 0.03),
            )
        ),
        "lens": aimed(tube((0, -long - 0.08, 0), (0, -long + 0.2, 0), r - 0.02)),
        "tripod": join(around(3, leg, -90), lathe([(0.2, high - 0.16), (0.2, high + 0.06)], 0.02)),
        "mount": join(
            box((0, 0, high + 0.14), (0.12, 0.16, 0.22), 0.03),
            tube((-r - 0.12, 0, high + 0.28), (r + 0.12, 0, high + 0.28), 0.11, 0.02),
        ),
    }


def microscope(draw: Draw) -> Parts:
    """Its stage to the front, its arm behind, its eyepiece tipped to the back."""
    x, back, stage, lean = draw(0.44, 0.54), draw(0.5, 0.58), draw(0.72, 0.82), draw(18, 30)
    high = stage + draw(0.95, 1.1)
    arm = [
        (back - 0.2, 0.1),
        (back + 0.2, 0.1),
        (back + 0.24, high * 0.6),
        (back - 0.1, high + 0.22),
    ]
    arm += [
        (-0.3, high + 0.22),
        (-0.3, high - 0.1),
        (back - 0.3, high - 0.1),
        (back - 0.12, high * 0.6),
    ]
    tip = high + 0.16

    def tipped(solid: Solid) -> Solid:
        return moved(turned(solid, 0, -lean), (0, -0.06, tip))

    return {
        "base": join(
            box((0, 0.04, 0.1), (x, 0.72, 0.1), 0.05), box((0, -0.1, 0.25), (0.2, 0.2, 0.13), 0.04)
        ),
        "arm": prism(arm, 0, 0.17),
        "stage": box((0, 0.0, stage), (x * 0.9, 0.46, 0.09), 0.02),
        "tube": tipped(
            join(
                tube((0, 0, -0.1), (0, 0, 0.5), 0.16), tube((0, 0, -0.06), (0, 0, 0.1), 0.24, 0.03)
            )
        ),
        "eyepiece": tipped(tube((0, 0, 0.42), (0, 0, 0.72), 0.2, 0.03)),
        "lenses": join(
            tube((0, -0.06, high - 0.24), (0, -0.06, high), 0.25, 0.04),
            tube((0, -0.06, stage + 0.2), (0, -0.06, high - 0.1), 0.12, 0.02),
            both(taper((0.1, 0, high - 0.22), (0.24, 0.02, high - 0.44), 0.11, 0.09)),
        ),
        "knobs": join(
            tube((-0.38, back, stage * 0.55), (0.38, back, stage * 0.55), 0.2, 0.03),
            tube((-0.32, back + 0.1, high * 0.62), (0.32, back + 0.1, high * 0.62), 0.13, 0.02),
        ),
    }


def typewriter(draw: Draw) -> Parts:
    """Round keys in straight rows on steps, a basket in the hood behind them, a sheet on the
    roller."""
    x, y, r = draw(1.04, 1.12), draw(0.88, 0.96), draw(0.115, 0.125)
    low, rise, hood = draw(0.2, 0.26), draw(0.12, 0.16), draw(0.72, 0.82)
    step, pitch, roll, sheet = 0.36, 0.39, draw(0.17, 0.2), draw(0.62, 0.84)
    edges = [-y + step * k for k in range(4)]
    stairs = [(v, low + rise * (k + e)) for k, v in enumerate(edges) for e in (-1, 0)]
    side = [(-y, 0), *stairs[1:], (edges[-1] + 0.04, hood), (y, hood), (y, 0)]
    back, z = y - 0.3, hood + roll * 0.6
    keys = [
        tube((pitch * k, v + step / 2, h - 0.06), (pitch * k, v + step / 2, h + 0.12), r, 0.02)
        for v, h in ((edges[1], low + rise), (edges[2], low + 2 * rise))
        for k in (0, 1, 2)
    ]
    basket = tube((0, edges[3] - 0.12, low + 2 * rise), (0, edges[3] - 0.12, 2), 0.5)
    paper = box((0, 0, sheet / 2), (x * 0.6, 0.08, sheet / 2))
    return {
        "body": join(
            cut(prism(side, 0, x - 0.1), basket),
            box((0, 0, 0.08), (x, y + 0.1, 0.09)),
        ),
        "keys": join(
            both(join(*keys)),
            box((0, edges[0] + step / 2, low + 0.03), (pitch * 1.5, 0.1, 0.09), 0.02),
        ),
        "roller": tube((-x - 0.04, back, z), (x + 0.04, back, z), roll, 0.02),
        "knobs": join(
            both(tube((x - 0.02, back, z), (x + 0.18, back, z), roll + 0.06, 0.03)),
            capsule((-x - 0.08, back, z + 0.06), (-x - 0.16, back - 0.5, z + 0.2), 0.1),
        ),
        "paper": moved(turned(paper, 0, -draw(8, 18)), (0, back + 0.14, z - 0.12)),
    }


def baseball_bat(draw: Draw) -> Parts:
    """Upright, its knob below."""
    long, r, thin = draw(2.5, 2.8), draw(0.19, 0.23), draw(0.09, 0.105)
    side = smooth_curve(
        [
            (thin, 0.7),
            (thin * 1.25, long * 0.42),
            (r * 0.92, long * 0.66),
            (r, long * 0.86),
            (r * 0.86, long - 0.06),
            (0.08, long),
        ]
    )
    return {
        "body": lathe([(thin * 0.95, 0.08), *side], 0.01),
        "grip": lathe([(thin + 0.02, 0.12), (thin + 0.02, draw(0.7, 0.9))], 0.015),
        "knob": tube((0, 0, 0.0), (0, 0, 0.15), thin + 0.09, 0.06),
    }


def _oval(x: float, z: float, high: float) -> list[tuple[float, float]]:
    """Corners of an ellipse in x and z about the height ``high``."""
    turns = (2 * math.pi * k / 28 for k in range(28))
    return [(x * math.cos(t), high + z * math.sin(t)) for t in turns]


def tennis_racket(draw: Draw) -> Parts:
    """Upright, its strings a plate with a coarse net in relief."""
    x, z, grip = draw(0.56, 0.64), draw(0.68, 0.74), draw(0.95, 1.1)
    y, throat = draw(0.095, 0.12), draw(0.32, 0.42)
    middle = grip + throat + z
    # The net ends within the rim.
    pitch, half = 0.19, (x - 0.06, z - 0.06)
    net = [
        box(
            (pitch * k, 0, middle),
            (0.035, 0.075, half[1] * (1 - (pitch * k / half[0]) ** 2) ** 0.5),
        )
        for k in range(-2, 3)
    ]
    net += [
        box(
            (0, 0, middle + pitch * k),
            (half[0] * (1 - (pitch * k / half[1]) ** 2) ** 0.5, 0.075, 0.035),
        )
        for k in range(-3, 4)
    ]
    fork = taper((0.06, 0, grip), (x * 0.62, 0, middle - z * 0.74), 0.1, 0.1)
    return {
        "frame": join(
            cut(
                prism(_oval(x + 0.08, z + 0.08, middle), 1, y),
                prism(_oval(x - 0.09, z - 0.09, middle), 1, 1),
            ),
            both(fork),
        ),
        "strings": join(prism(_oval(x, z, middle), 1, 0.045), *net),
        "grip": join(
            box((0, 0, grip / 2 + 0.03), (0.13, 0.12, grip / 2), 0.05),
            box((0, 0, 0.08), (0.16, 0.145, 0.08), 0.05),
        ),
    }


def blender(draw: Draw) -> Parts:
    """A jug on a motor, its knob to the front, its handle to the right."""
    low, neck, wide, high = draw(0.5, 0.58), draw(0.32, 0.38), draw(0.46, 0.54), draw(1.9, 2.1)
    z = draw(0.62, 0.72)
    x = wide + 0.3
    grip = join(
        capsule((wide - 0.1, 0, high - 0.2), (x, 0, high - 0.24), 0.1),
        capsule((x, 0, high - 0.24), (x - 0.06, 0, z + 0.4), 0.1),
        capsule((x - 0.06, 0, z + 0.4), (neck, 0, z + 0.36), 0.1),
    )
    motor = smooth_curve([(low, 0.12), (low * 0.92, z * 0.5), (neck + 0.06, z)])
    return {
        "base": lathe([(low, 0.03), *motor], 0.03),
        "jug": lathe([(neck, z + 0.08), (wide, high)], 0.02),
        "handle": grip,
        "lid": join(
            tube((0, 0, high - 0.04), (0, 0, high + 0.13), wide + 0.05, 0.04),
            tube((0, 0, high + 0.1), (0, 0, high + 0.28), 0.2, 0.04),
        ),
        "collar": tube((0, 0, z - 0.04), (0, 0, z + 0.14), neck + 0.1, 0.03),
        "knob": tube((0, -low - 0.08, z * 0.44), (0, 0, z * 0.44), draw(0.15, 0.19), 0.03),
    }


def chandelier(draw: Draw) -> Parts:
    """Arms with candles about a turned stem, drops of glass below."""
    count, reach, high = 5 + draw.chance(0.6), draw(1.0, 1.15), draw(0.7, 0.85)
    dip, candle = high - draw(0.3, 0.4), draw(0.26, 0.36)
    stem = [(0.1, 0.26), (0.28, 0.5), (0.13, 0.74), (0.22, 1.0), (0.11, 1.25), (0.1, high + 1.0)]
    arm = join(
        capsule((0.1, 0, 0.58), (reach * 0.4, 0, dip), 0.09),
        capsule((reach * 0.4, 0, dip), (reach * 0.8, 0, dip + 0.04), 0.09),
        capsule((reach * 0.8, 0, dip + 0.04), (reach, 0, high), 0.09),
    )
    top = high + 0.12 + candle
    drop = join(ball((reach * 0.62, 0, dip - 0.16), 0.12), ball((reach, 0, high - 0.12), 0.11))
    return {
        "stem": join(
            lathe(smooth_curve(stem), 0.01),
            tube((0, 0, high + 0.9), (0, 0, high + 1.05), 0.26, 0.03),
        ),
        "arms": around(count, arm, -90),
        "cups": around(count, tube((reach, 0, high), (reach, 0, high + 0.14), 0.2, 0.04), -90),
        "candles": around(count, tube((reach, 0, high + 0.1), (reach, 0, top), 0.1), -90),
        "flames": around(
            count, taper((reach, 0, top + 0.08), (reach, 0, top + 0.24), 0.11, 0.06), -90
        ),
        "drops": join(around(count, drop, -90), ball((0, 0, 0.16), 0.17)),
    }


GADGETS = {
    "pistol": pistol,
    "chainsaw": chainsaw,
    "padlock": padlock,
    "magnifying glass": magnifying_glass,
    "telescope": telescope,
    "microscope": microscope,
    "typewriter": typewriter,
    "baseball bat": baseball_bat,
    "tennis racket": tennis_racket,
    "blender": blender,
    "chandelier": chandelier,
} | SYMBOLS
