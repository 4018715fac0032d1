"""Things of a desk: what one writes, glues, measures and stores with."""

from collections.abc import Callable

import numpy as np
from scipy.spatial.transform import Rotation

from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.shapes import (
    FRONT,
    SIDE,
    Parts,
    ball,
    both_sides,
    box,
    closed_curve,
    pipe,
    placed,
    plate,
    ring,
    rod,
    rounded,
    spun,
    turned,
)


def _paper_clip(draw: Draw) -> Parts:
    wide = draw(0.2, 0.24)
    way = [
        (-wide, -0.4),
        (-wide, 0.5),
        (-0.6 * wide, 0.72),
        (0, 0.78),
        (0.6 * wide, 0.72),
        (wide, 0.5),
        (wide, -0.5),
        (0.7 * wide, -0.76),
        (0.1 * wide, -0.82),
        (-0.4 * wide, -0.72),
        (-0.55 * wide, -0.5),
        (-0.55 * wide, 0.3),
        (-0.3 * wide, 0.48),
        (0.1 * wide, 0.52),
        (0.42 * wide, 0.44),
        (0.5 * wide, 0.26),
        (0.5 * wide, -0.46),
    ]
    return {"wire": [pipe([(x, 0, z) for x, z in way], 0.036)]}


def _pencil_sharpener(draw: Draw) -> Parts:
    side = [(-0.3, -0.2), (0.3, -0.2), (0.3, 0.1), (0.12, 0.22), (-0.12, 0.22), (-0.3, 0.1)]
    body = [
        plate(side, 0.72, (0, 0, 0), FRONT, []),
        *both_sides(
            [
                rod((0.3, -0.3 + 0.06 * k, -0.17), (0.3, -0.3 + 0.06 * k, 0.08), 0.026)
                for k in range(11)
            ]
        ),
    ]
    hole = [
        rod((0, -0.34, -0.01), (0, -0.375, -0.01), 0.13),
        rod((0, 0.34, -0.01), (0, 0.375, -0.01), 0.06),
    ]
    blade = [box((0.28, 0.6, 0.03), (0, 0.02, 0.235), 0.004, (0, 0, draw(6, 12)))]
    screw = [rod((0, 0.02, 0.23), (0, 0.02, 0.275), 0.07, rim=0.01)]
    slot = [box((0.1, 0.02, 0.012), (0, 0.02, 0.275), 0.0, (0, 0, 30))]
    pencil = [
        rod((0, -0.3, -0.01), (0, -1.3, -0.01), 0.09),
        rod((0, -1.24, -0.01), (0, -1.4, -0.01), 0.094),
    ]
    shaving = [
        pipe(
            [
                (0.14 * np.cos(t) + 0.3, 0.06 * t - 0.1, 0.3 + 0.1 * np.sin(t))
                for t in np.linspace(-2.6, 4.4, 12)
            ],
            0.026,
        )
    ]
    return {
        "body": body,
        "hole": hole,
        "blade": blade,
        "screw": [*screw, *slot],
        "pencil": pencil,
        "shaving": [*shaving, rod((0.1, -0.1, 0.24), (0.2, -0.22, 0.25), 0.03)],
    }


def _eraser(draw: Draw) -> Parts:
    cut = draw(-0.05, 0.1)
    pink = [
        plate(
            [(-0.7, -0.16), (cut, -0.16), (cut + 0.06, 0.16), (-0.55, 0.16)], 0.44, (0, 0, 0), FRONT
        )
    ]
    blue = [
        plate(
            [(cut - 0.002, -0.162), (0.55, -0.162), (0.7, 0.162), (cut + 0.06, 0.162)],
            0.444,
            (0, 0, 0),
            FRONT,
        )
    ]
    stamp = [
        plate(rounded((0.34, 0.2), 0.1), 0.015, (-0.3, 0, 0.165)),
        box((0.22, 0.03, 0.02), (-0.3, 0, 0.172)),
    ]
    crumbs = [
        ball((0.05, 0.022, 0.022), (-0.72 + 0.01 * k, -0.13 + 0.09 * k, -0.13), (0, 0, 50 * k))
        for k in range(4)
    ]
    return {"body": pink, "ink end": blue, "stamp": stamp, "crumbs": crumbs}


def _glue_stick(draw: Draw) -> Parts:
    out = draw(0.1, 0.24)
    tube = [rod((0, 0, 0.1), (0, 0, 0.9), 0.24, rim=0.01), rod((0, 0, 0.86), (0, 0, 1.02), 0.215)]
    glue = [rod((0, 0, 1.0), (0, 0, 1.04 + out), 0.19, 0.18, 0.03)]
    dial = [
        rod((0, 0, 0), (0, 0, 0.12), 0.235, rim=0.015),
        *spun([box((0.03, 0.03, 0.1), (0, -0.235, 0.06), 0.006)], 20),
    ]
    label = [rod((0, 0, 0.22), (0, 0, 0.72), 0.248)]
    stripe = [rod((0, 0, 0.4), (0, 0, 0.54), 0.254)]
    cap = [
        rod((0.56, 0, 0.0), (0.56, 0, 0.42), 0.25, rim=0.03),
        rod((0.2, 0, 0.05), (0.4, 0, 0.05), 0.04),
    ]
    return {"tube": tube, "glue": glue, "dial": [*dial, *cap], "label": label, "stripe": stripe}


def _tape_dispenser(draw: Draw) -> Parts:
    r = draw(0.34, 0.4)
    side = closed_curve(
        [
            (-0.8, -0.2),
            (-0.1, -0.22),
            (0.62, -0.2),
            (0.78, 0.0),
            (0.62, 0.34),
            (0.3, 0.5),
            (0.02, 0.36),
            (-0.22, 0.06),
            (-0.5, 0.1),
            (-0.72, 0.16),
            (-0.84, 0.1),
        ]
    )
    body = both_sides([plate(side, 0.07, (0.17, 0, 0), SIDE)]) + [
        box((0.36, 1.46, 0.16), (0, -0.02, -0.15), 0.04),
        box((0.3, 0.2, 0.22), (0, -0.7, 0.0), 0.03),
    ]
    roll = placed(
        [turned([(0.2, -0.12), (r, -0.12), (r, 0.12), (0.2, 0.12)], axis="x")],
        np.eye(3),
        (0, 0.3, 0.2),
    )
    core = [
        turned([(0.12, -0.13), (0.21, -0.13), (0.21, 0.13), (0.12, 0.13)], (0, 0.3, 0.2), "x"),
        rod((-0.19, 0.3, 0.2), (0.19, 0.3, 0.2), 0.13),
    ]
    tape = [
        plate(
            [(0.14, 0.2 + r - 0.05), (0.16, 0.23 + r - 0.05), (-0.76, 0.235), (-0.76, 0.2)],
            0.22,
            (0, 0, 0),
            SIDE,
        )
    ]
    teeth = [
        box((0.3, 0.04, 0.1), (0, -0.79, 0.16), 0.004),
        *(rod((x, -0.8, 0.19), (x, -0.84, 0.25), 0.02, 0.005) for x in np.linspace(-0.12, 0.12, 8)),
    ]
    return {"body": body, "roll": [*roll, *tape], "core": core, "cutter": teeth}


def _protractor(draw: Draw) -> Parts:
    r = 0.9
    turn = np.linspace(0, np.pi, 49)
    outer = [(r * np.cos(a), r * np.sin(a)) for a in turn]
    inner = np.array(
        [(0.5 * r * np.cos(a), 0.16 + 0.42 * r * np.sin(a)) for a in np.linspace(0, np.pi, 33)]
    )
    body = [plate([*outer, (-r, -0.12), (r, -0.12)], 0.05, (0, 0, 0), FRONT, [inner])]
    marks = []
    for k in range(37):
        a, long = np.radians(5 * k), 0.15 if k % 2 == 0 else 0.08
        way = np.array([np.cos(a), np.sin(a)])
        start, end = (r - 0.02) * way, (r - 0.02 - long) * way
        marks.append(rod((start[0], -0.026, start[1]), (end[0], -0.026, end[1]), 0.0115))
    marks += [
        box((1.76, 0.012, 0.014), (0, -0.028, 0.0)),
        box((0.014, 0.012, 0.14), (0, -0.028, 0.05)),
        ring(0.035, 0.011, (0, -0.026, 0.0), "y"),
    ]
    marks += [
        pipe(
            [
                ((0.66 * r) * np.cos(a), -0.026, 0.66 * r * np.sin(a))
                for a in np.linspace(0.05, np.pi - 0.05, 21)
            ],
            0.011,
        )
    ]
    del draw
    return {"body": body, "marks": marks}


def _usb_stick(draw: Draw) -> Parts:
    long = draw(0.9, 1.05)
    body = [
        box((0.4, 0.2, long), (0, 0, -long / 2 + 0.1), 0.07),
        box((0.34, 0.22, long - 0.24), (0, 0, -long / 2 + 0.1), 0.05),
    ]
    plug = [box((0.28, 0.13, 0.4), (0, 0, 0.26), 0.012)]
    holes = [box((0.06, 0.14, 0.06), (x, 0, 0.34)) for x in (-0.07, 0.07)] + [
        box((0.22, 0.07, 0.02), (0, 0, 0.457))
    ]
    band = [
        box((0.41, 0.232, 0.06), (0, 0, -0.06), 0.05),
        ring(0.07, 0.026, (0, 0, -long + 0.06), "y"),
    ]
    mark = [
        rod((0, -0.1, -0.36), (0, -0.118, -0.36), 0.045),
        rod((0, -0.112, -0.6), (0, -0.112, -0.24), 0.0125),
        rod((0, -0.112, -0.52), (0.08, -0.112, -0.42), 0.0115),
        rod((0, -0.112, -0.58), (-0.08, -0.112, -0.48), 0.0115),
        ball((0.03, 0.014, 0.03), (-0.08, -0.112, -0.46)),
        box((0.05, 0.02, 0.05), (0.08, -0.112, -0.4)),
        rod((0, -0.112, -0.24), (0, -0.112, -0.18), 0.034, 0.004),
    ]
    return {"body": body, "plug": plug, "holes": holes, "band": band, "mark": mark}


def _drawing_compass(draw: Draw) -> Parts:
    spread = draw(16.0, 26.0)
    legs, points, lead = [], [], []
    for s in (-1, 1):
        way = Rotation.from_euler("y", -s * spread / 1.0, degrees=True).as_matrix()
        at = (0, 0, 0.7)
        legs += placed(
            [
                rod((0, 0, 0.02), (0, 0, -1.0), 0.05, 0.04),
                rod((0, 0, -0.96), (0, 0, -1.1), 0.055, 0.05, 0.01),
            ],
            way,
            at,
        )
        (points if s < 0 else lead).extend(
            placed(
                [
                    rod(
                        (0, 0, -1.08),
                        (0, 0, -1.4 if s < 0 else -1.38),
                        0.024 if s < 0 else 0.034,
                        0.005,
                    )
                ],
                way,
                at,
            )
        )
    head = [
        rod((0, -0.08, 0.7), (0, 0.08, 0.7), 0.13, rim=0.015),
        rod((0, 0, 0.78), (0, 0, 1.02), 0.05, rim=0.01),
        *spun([box((0.016, 0.016, 0.18), (0, -0.05, 0.92), 0.004)], 14),
    ]
    foot = Rotation.from_euler("y", -spread, degrees=True).as_matrix() @ (0, 0, -0.5)
    gear = [rod((-foot[0] - 0.08, 0, 0.7 + foot[2]), (foot[0] + 0.08, 0, 0.7 + foot[2]), 0.018)]
    gear += [rod((-0.03, 0, 0.7 + foot[2]), (0.03, 0, 0.7 + foot[2]), 0.1, rim=0.01)]
    return {"legs": legs, "head": head, "adjuster": gear, "needle": points, "lead": lead}


def _set_square(draw: Draw) -> Parts:
    tall = draw(1.2, 1.4)
    outer = [(-0.5, 0), (0.5, 0), (-0.5, tall)]
    inner = np.array([(-0.34, 0.16), (0.16, 0.16), (-0.34, 0.16 + 0.5 * tall)])
    marks = [
        box(
            (0.014, 0.014, 0.1 if k % 5 == 0 else 0.06),
            (-0.46 + 0.045 * k, -0.026, 0.05 if k % 5 == 0 else 0.03),
        )
        for k in range(19)
    ]
    marks += [
        box(
            (0.1 if k % 5 == 0 else 0.06, 0.014, 0.014),
            (-0.45 if k % 5 == 0 else -0.47, -0.026, 0.06 + 0.045 * k),
        )
        for k in range(int(tall / 0.055))
    ]
    return {"body": [plate(outer, 0.05, (0, 0, 0), FRONT, [inner])], "marks": marks}


DESK_TOOLS: dict[str, Callable[[Draw], Parts]] = {
    "paper clip": _paper_clip,
    "pencil sharpener": _pencil_sharpener,
    "eraser": _eraser,
    "glue stick": _glue_stick,
    "tape dispenser": _tape_dispenser,
    "protractor": _protractor,
    "usb stick": _usb_stick,
    "drawing compass": _drawing_compass,
    "set square": _set_square,
}
