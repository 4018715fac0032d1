"""Things of a workshop."""

from collections.abc import Callable

import numpy as np

from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.pieces import HEXAGON, screw_thread
from core.guidance.builtin.constructed.shapes import (
    FRONT,
    Parts,
    ball,
    both_sides,
    box,
    capsule,
    circle,
    closed_curve,
    pipe,
    plate,
    ring,
    rod,
    rounded,
    spun,
    turned,
)


def _piston(draw: Draw) -> Parts:
    long = draw(0.85, 1.0)
    head = [
        turned([(0, 0.02), (0.36, 0.02), (0.36, 0.5), (0.33, 0.53), (0, 0.53)]),
        rod((0, -0.38, 0.2), (0, 0.38, 0.2), 0.09),
    ]
    rings = [
        turned([(0.3, z), (0.372, z), (0.372, z + 0.035), (0.3, z + 0.035)])
        for z in (0.3, 0.37, 0.44)
    ]
    arm = [
        box((0.14, 0.12, long), (0, 0, 0.1 - long / 2), 0.03),
        rod((0, -0.1, 0.14), (0, 0.1, 0.14), 0.14, rim=0.01),
        turned([(0.16, -0.1), (0.28, -0.1), (0.28, 0.1), (0.16, 0.1)], (0, 0, -long), "y"),
        *both_sides([box((0.1, 0.16, 0.24), (0.27, 0, -long), 0.02)]),
    ]
    bolts = both_sides(
        [
            rod((0.27, 0, -long - 0.18), (0.27, 0, -long + 0.18), 0.045),
            plate(0.065 * HEXAGON, 0.06, (0.27, 0, -long + 0.16)),
            plate(0.065 * HEXAGON, 0.06, (0.27, 0, -long - 0.16)),
        ]
    )
    return {"head": head, "rings": rings, "rod": arm, "bolts": bolts}


def _spark_plug(draw: Draw) -> Parts:
    high = draw(0.5, 0.6)
    metal = [
        plate(0.24 * HEXAGON, 0.2, (0, 0, 0)),
        rod((0, 0, 0.08), (0, 0, 0.18), 0.2, 0.17),
        rod((0, 0, -0.18), (0, 0, -0.08), 0.2),
        rod((0, 0, -0.7), (0, 0, -0.14), 0.14),
        *screw_thread(0.145, -0.66, -0.2),
    ]
    white = [
        turned(
            [
                (0, 0.15),
                (0.15, 0.15),
                (0.14, 0.22),
                *((0.12 + 0.012 * (k % 2), 0.25 + high * k / 10) for k in range(11)),
                (0.08, 0.3 + high),
                (0, 0.3 + high),
            ]
        ),
        rod((0, 0, -0.78), (0, 0, -0.66), 0.07),
    ]
    tip = [
        rod((0, 0, 0.28 + high), (0, 0, 0.4 + high), 0.05),
        rod((0, 0, 0.38 + high), (0, 0, 0.5 + high), 0.075, rim=0.02),
    ]
    wire = [
        rod((0, 0, -0.84), (0, 0, -0.74), 0.03),
        pipe([(0.12, 0, -0.68), (0.125, 0, -0.82), (0.1, 0, -0.9), (0.0, 0, -0.91)], 0.03),
    ]
    return {"body": metal, "insulator": white, "terminal": tip, "electrode": wire}


def _tape_measure(draw: Draw) -> Parts:
    out = draw(0.6, 0.9)
    side = closed_curve(
        [
            (-0.44, -0.4),
            (0.36, -0.4),
            (0.46, -0.2),
            (0.44, 0.24),
            (0.2, 0.44),
            (-0.16, 0.42),
            (-0.44, 0.16),
        ]
    )
    case = [plate(side, 0.34, (0, 0, 0), FRONT), plate(0.93 * side, 0.4, (0, 0, 0), FRONT)]
    disc = [
        rod((0, -0.19, 0.02), (0, -0.215, 0.02), 0.27),
        rod((0, 0.19, 0.02), (0, 0.215, 0.02), 0.27),
    ]
    grip = [
        box((0.2, 0.42, 0.12), (0.3, 0, -0.34), 0.03),
        box((0.1, 0.3, 0.2), (-0.36, 0, 0.12), 0.03, (0, 40, 0)),
    ]
    tape = [box((out, 0.22, 0.025), (-0.4 - out / 2, 0, -0.34))]
    marks = [
        box(
            (0.016, 0.09 if k % 2 else 0.15, 0.012),
            (-0.5 - 0.07 * k, -0.11 + (0.045 if k % 2 else 0.075), -0.327),
        )
        for k in range(int((out - 0.16) / 0.07))
    ]
    hook = [
        box((0.03, 0.2, 0.12), (-0.4 - out, 0, -0.37), 0.006),
        *(rod((-0.36 - out, y, -0.33), (-0.36 - out, y, -0.318), 0.026) for y in (-0.05, 0.05)),
    ]
    return {"case": case, "disc": disc, "grip": grip, "tape": tape, "marks": marks, "hook": hook}


def _spirit_level(draw: Draw) -> Parts:
    long, off = draw(1.7, 1.9), draw(-0.05, 0.05)
    side = np.array([(-long / 2, -0.14), (long / 2, -0.14), (long / 2, 0.14), (-long / 2, 0.14)])
    holes = [
        rounded((0.34, 0.11), 0.05, (0, 0.06)),
        circle(0.085, (-0.36 * long, 0), 32),
        circle(0.085, (0.36 * long, 0), 32),
        rounded((0.3, 0.1), 0.05, (-0.19 * long, 0)),
        rounded((0.3, 0.1), 0.05, (0.19 * long, 0)),
    ]
    body = [
        plate(side, 0.07, (0, 0, 0), FRONT, holes),
        *(box((long, 0.13, 0.035), (0, 0, z), 0.006) for z in (-0.14, 0.14)),
    ]
    ends = both_sides([box((0.08, 0.15, 0.32), (long / 2, 0, 0), 0.02)])
    vials = [
        capsule((-0.16, 0, 0.06), (0.16, 0, 0.06), 0.048),
        capsule((-0.36 * long, 0, -0.08), (-0.36 * long, 0, 0.08), 0.042),
        capsule((0.36 * long - 0.06, 0, -0.06), (0.36 * long + 0.06, 0, 0.06), 0.042),
    ]
    bubbles = [
        ball((0.05, 0.03, 0.032), (off, -0.024, 0.068)),
        ball((0.03, 0.03, 0.045), (-0.36 * long, -0.02, 0.03)),
        ball((0.03, 0.03, 0.03), (0.36 * long, -0.02, 0.0)),
    ]
    lines = [ring(0.048, 0.0115, (x, 0, 0.06), "x") for x in (-0.07, 0.07)]
    return {"body": body, "ends": ends, "vials": vials, "bubbles": bubbles, "lines": lines}


def _c_clamp(draw: Draw) -> Parts:
    deep = draw(0.5, 0.6)
    frame = [
        plate(
            [
                (-0.1, -0.62),
                (deep + 0.1, -0.62),
                (deep + 0.18, -0.5),
                (deep + 0.18, 0.5),
                (deep + 0.1, 0.62),
                (-0.1, 0.62),
                (-0.1, 0.46),
                (deep - 0.04, 0.46),
                (deep, 0.4),
                (deep, -0.4),
                (deep - 0.04, -0.46),
                (-0.1, -0.46),
            ],
            0.14,
            (0, 0, 0),
            FRONT,
        ),
        rod((0, 0, -0.66), (0, 0, -0.4), 0.13, rim=0.02),
        rod((0, 0, 0.34), (0, 0, 0.5), 0.1, rim=0.01),
    ]
    screw = [rod((0, 0, -1.02), (0, 0, -0.02), 0.062), *screw_thread(0.065, -0.94, -0.08, 0.055)]
    pad = [rod((0, 0, -0.04), (0, 0, 0.06), 0.1, 0.15, 0.01)]
    bar = [
        rod((-0.32, 0, -0.98), (0.32, 0, -0.98), 0.028),
        *both_sides([ball(0.05, (0.32, 0, -0.98))]),
        rod((0, 0, -1.05), (0, 0, -0.92), 0.08, rim=0.01),
    ]
    return {"frame": frame, "screw": screw, "pad": pad, "handle": bar}


def _vise(draw: Draw) -> Parts:
    gap = draw(0.16, 0.3)
    base = [
        box((0.7, 0.62, 0.09), (0.1, 0, 0.04), 0.02),
        rod((0.1, 0, 0.06), (0.1, 0, 0.2), 0.26, 0.22, 0.015),
        box((0.46, 0.4, 0.34), (0.16, 0, 0.32), 0.05),
        plate(
            [(0.0, 0.4), (0.4, 0.4), (0.46, 0.62), (0.4, 0.74), (0.0, 0.74)], 0.62, (0, 0, 0), FRONT
        ),
        box((0.26, 0.24, 0.05), (0.46, 0, 0.5), 0.02),
    ]
    slide = [
        box((0.9, 0.22, 0.18), (-0.3, 0, 0.36), 0.02),
        plate(
            [(-gap - 0.3, 0.3), (-gap, 0.3), (-gap, 0.74), (-gap - 0.2, 0.74), (-gap - 0.34, 0.54)],
            0.62,
            (0, 0, 0),
            FRONT,
        ),
    ]
    jaws = [box((0.05, 0.64, 0.16), (x, 0, 0.68), 0.006) for x in (-gap + 0.022, -0.022)]
    screw = [
        rod((-0.84, 0, 0.36), (0.1, 0, 0.36), 0.05),
        rod((-0.94, 0, 0.36), (-0.76, 0, 0.36), 0.085, rim=0.015),
        rod((-0.88, -0.34, 0.3), (-0.88, 0.34, 0.42), 0.03),
        *(ball(0.05, (-0.88, s * 0.34, 0.36 + s * 0.06)) for s in (-1, 1)),
    ]
    bolts = [
        plate(0.05 * HEXAGON, 0.05, (0.1 + s * 0.28, t * 0.24, 0.1))
        for s in (-1, 1)
        for t in (-1, 1)
    ]
    return {"body": [*base, *slide], "jaws": jaws, "screw": screw, "bolts": bolts}


def _caliper(draw: Draw) -> Parts:
    gap = draw(0.25, 0.5)
    beam = [
        box((1.9, 0.05, 0.16), (0.35, 0, 0), 0.004),
        plate(
            [
                (-0.6, 0.08),
                (-0.6, -0.1),
                (-0.52, -0.62),
                (-0.46, -0.62),
                (-0.4, -0.08),
                (-0.4, 0.08),
            ],
            0.06,
            (0, 0, 0),
            FRONT,
        ),
        plate([(-0.58, 0.06), (-0.42, 0.06), (-0.44, 0.3), (-0.5, 0.34)], 0.045, (0, 0, 0), FRONT),
    ]
    x = -0.4 + gap
    head = [
        plate(
            [
                (x, 0.13),
                (x, -0.1),
                (x + 0.06, -0.62),
                (x + 0.12, -0.62),
                (x + 0.2, -0.16),
                (x + 0.6, -0.16),
                (x + 0.6, 0.13),
            ],
            0.1,
            (0, 0, 0),
            FRONT,
        ),
        plate(
            [(x, 0.1), (x + 0.16, 0.1), (x + 0.08, 0.36), (x + 0.02, 0.3)],
            0.05,
            (0, 0, 0),
            FRONT,
        ),
        rod((x + 0.4, 0, 0.1), (x + 0.4, 0, 0.24), 0.045),
        rod((x + 0.4, 0, 0.19), (x + 0.4, 0, 0.25), 0.07, rim=0.01),
        rod((x + 0.52, -0.02, -0.2), (x + 0.52, 0.02, -0.2), 0.08, rim=0.006),
    ]
    screen = [box((0.34, 0.02, 0.13), (x + 0.34, -0.05, 0.0), 0.008)]
    marks = [
        box(
            (0.013, 0.014, 0.05 if k % 5 else 0.09),
            (x + 0.68 + 0.036 * k, -0.026, 0.05 if k % 5 else 0.03),
        )
        for k in range(int((1.28 - x - 0.7) / 0.036))
    ]
    marks += [box((0.03, 0.014, 0.05), (x + 0.26 + 0.06 * k, -0.062, 0.0)) for k in range(3)]
    return {"beam": beam, "jaw": head, "screen": screen, "marks": marks}


def _pulley(draw: Draw) -> Parts:
    r = draw(0.4, 0.46)
    wheel = [
        turned(
            [
                (0.06, -0.1),
                (r + 0.06, -0.1),
                (r + 0.05, -0.07),
                (r - 0.04, 0.0),
                (r + 0.05, 0.07),
                (r + 0.06, 0.1),
                (0.06, 0.1),
            ],
            axis="y",
        )
    ]
    cheek = closed_curve(
        [
            (-0.16, -0.36),
            (0.16, -0.36),
            (0.32, 0.0),
            (0.2, 0.5),
            (0, 0.6),
            (-0.2, 0.5),
            (-0.32, 0.0),
        ]
    )
    block = [plate(cheek, 0.05, (0, y, 0), FRONT) for y in (-0.15, 0.15)] + [
        box((0.26, 0.34, 0.1), (0, 0, 0.53), 0.02)
    ]
    iron = [
        rod((0, -0.22, 0), (0, 0.22, 0), 0.08, rim=0.01),
        pipe(
            [
                (0, 0, 0.55),
                (0, 0, 0.72),
                (0.12, 0, 0.84),
                (0.06, 0, 1.0),
                (-0.1, 0, 1.0),
                (-0.15, 0, 0.88),
            ],
            (0.045, 0.045, 0.045, 0.04, 0.035, 0.02),
        ),
    ]
    turn = np.linspace(0, np.pi, 13)
    rope = [
        pipe(
            [
                (-r + 0.01, 0, -1.0),
                (-r + 0.01, 0, -0.4),
                *((-(r - 0.005) * np.cos(a), 0, (r - 0.005) * np.sin(a)) for a in turn),
                (r - 0.01, 0, -0.4),
                (r - 0.01, 0, -0.72),
            ],
            0.05,
        ),
        ball(0.085, (r - 0.01, 0, -0.74)),
    ]
    rope += [ring(0.09, 0.035, (-r + 0.01, 0, -1.08), "y")]
    return {"block": block, "wheel": wheel, "iron": iron, "rope": rope}


def _valve(draw: Draw) -> Parts:
    spokes = 5 + draw.which(2)
    body = [
        rod((-0.62, 0, 0), (0.62, 0, 0), 0.2),
        ball((0.3, 0.27, 0.28)),
        rod((0, 0, 0.1), (0, 0, 0.52), 0.15, 0.12),
        *both_sides([rod((0.56, 0, 0), (0.66, 0, 0), 0.34, rim=0.012)]),
        rod((0, 0, 0.36), (0, 0, 0.44), 0.24, rim=0.01),
        plate(0.13 * HEXAGON, 0.1, (0, 0, 0.54)),
    ]
    stem = [rod((0, 0, 0.5), (0, 0, 0.92), 0.045)]
    wheel = [
        ring(0.36, 0.045, (0, 0, 0.86)),
        *spun([rod((0, 0, 0.86), (0, -0.36, 0.86), 0.03)], spokes),
        rod((0, 0, 0.81), (0, 0, 0.93), 0.08, rim=0.015),
    ]
    bolts = both_sides(
        [
            rod(
                (0.52, 0.26 * np.cos(a), 0.26 * np.sin(a)),
                (0.7, 0.26 * np.cos(a), 0.26 * np.sin(a)),
                0.04,
                rim=0.006,
            )
            for a in np.arange(6) * np.pi / 3
        ]
    )
    bolts += [
        rod(
            (0.18 * np.cos(a), 0.18 * np.sin(a), 0.34),
            (0.18 * np.cos(a), 0.18 * np.sin(a), 0.47),
            0.03,
            rim=0.005,
        )
        for a in np.arange(6) * np.pi / 3
    ]
    gap = draw(0.0, 0.02)
    return {
        "body": body,
        "stem": [*stem, rod((0, 0, 0.9), (0, 0, 0.96 + gap), 0.03)],
        "wheel": wheel,
        "bolts": bolts,
    }


WORKSHOP: dict[str, Callable[[Draw], Parts]] = {
    "piston": _piston,
    "spark plug": _spark_plug,
    "tape measure": _tape_measure,
    "spirit level": _spirit_level,
    "c clamp": _c_clamp,
    "vise": _vise,
    "caliper": _caliper,
    "pulley": _pulley,
    "valve": _valve,
}
