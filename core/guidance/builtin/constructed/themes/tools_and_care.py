"""Hand tools, and things of a hospital and of a paint shop."""

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
    capsule,
    closed_curve,
    curve,
    pipe,
    placed,
    plate,
    ring,
    rod,
    rounded,
    turned,
)


def _hospital_bed(draw: Draw) -> Parts:
    tilt = draw(18.0, 38.0)
    frame = [
        box((0.86, 1.94, 0.07), (0, 0, 0.48), 0.015),
        box((0.5, 1.5, 0.08), (0, 0, 0.28), 0.015),
        *(rod((x, y, 0.28), (x, y, 0.48), 0.035) for x in (-0.2, 0.2) for y in (-0.5, 0.5)),
    ]
    frame += [
        rod((s * 0.3, t * 0.75, 0.1), (s * 0.26, t * 0.6, 0.28), 0.03)
        for s in (-1, 1)
        for t in (-1, 1)
    ]
    wheels = [
        rod((s * 0.3 - 0.03, t * 0.75, 0.08), (s * 0.3 + 0.03, t * 0.75, 0.08), 0.085, rim=0.015)
        for s in (-1, 1)
        for t in (-1, 1)
    ]
    boards = [
        plate(rounded((0.86, 0.5), 0.1, (0, 0.68)), 0.05, (0, 0.98, 0), FRONT),
        plate(rounded((0.86, 0.36), 0.1, (0, 0.62)), 0.05, (0, -0.98, 0), FRONT),
    ]
    way = Rotation.from_euler("x", tilt, degrees=True).as_matrix()
    mattress = [
        box((0.76, 1.06, 0.14), (0, -0.4, 0.58), 0.05),
        *placed([box((0.76, 0.84, 0.14), (0, 0.4, 0), 0.05)], way, (0, 0.1, 0.58)),
    ]
    pillow = placed([box((0.5, 0.32, 0.12), (0, 0.58, 0.11), 0.055)], way, (0, 0.1, 0.58))
    blanket = [
        box((0.8, 0.86, 0.1), (0, -0.46, 0.63), 0.045),
        box((0.8, 0.16, 0.12), (0, 0.0, 0.64), 0.05),
    ]
    rails = []
    for s in (-1, 1):
        rails += [
            capsule((s * 0.42, -0.3, z), (s * 0.42, 0.4, z), 0.018) for z in (0.66, 0.76, 0.86)
        ] + [capsule((s * 0.42, y, 0.48), (s * 0.42, y, 0.86), 0.018) for y in (-0.3, 0.05, 0.4)]
    drip = [
        rod((0.5, 0.9, 0.06), (0.5, 0.9, 1.7), 0.018),
        *(
            rod((0.5, 0.9, 0.07), (0.5 + 0.2 * np.cos(a), 0.9 + 0.2 * np.sin(a), 0.05), 0.018)
            for a in np.arange(5) * 2 * np.pi / 5
        ),
        capsule((0.4, 0.9, 1.7), (0.6, 0.9, 1.7), 0.016),
        rod((0.4, 0.94, 0.7), (0.52, 0.9, 0.7), 0.016),
    ]
    bag = [
        box((0.13, 0.06, 0.22), (0.42, 0.9, 1.56), 0.028),
        rod((0.42, 0.9, 1.46), (0.42, 0.9, 1.38), 0.016),
        pipe([(0.42, 0.9, 1.4), (0.44, 0.86, 1.0), (0.4, 0.6, 0.9), (0.34, 0.4, 0.78)], 0.0115),
    ]
    return {
        "frame": [*frame, *rails, *drip],
        "boards": boards,
        "mattress": mattress,
        "pillow": pillow,
        "blanket": blanket,
        "wheels": wheels,
        "drip bag": bag,
    }


def _crutches(draw: Draw) -> Parts:
    lean = draw(5.0, 8.0)
    wood, pads, grips, feet = [], [], [], []
    for s in (-1, 1):
        way = Rotation.from_euler("y", s * lean, degrees=True).as_matrix()
        at = (s * 0.16, s * 0.03, 0)
        rails = [
            pipe(
                [(t * 0.035, 0, -0.55), (t * 0.07, 0, -0.1), (t * 0.1, 0, 0.4), (t * 0.1, 0, 0.84)],
                0.024,
            )
            for t in (-1, 1)
        ]
        wood += placed(
            [
                *rails,
                rod((0, 0, -1.0), (0, 0, -0.42), 0.03),
                box((0.12, 0.05, 0.05), (0, 0, -0.3), 0.01),
            ],
            way,
            at,
        )
        pads += placed([capsule((-0.12, 0, 0.87), (0.12, 0, 0.87), 0.05)], way, at)
        grips += placed([rod((-0.1, 0, 0.16), (0.1, 0, 0.16), 0.038, rim=0.01)], way, at)
        feet += placed([rod((0, 0, -1.06), (0, 0, -0.96), 0.05, 0.042, 0.012)], way, at)

    wood += [rod((-0.16, -0.01, 0.62), (0.16, 0.01, 0.62), 0.018)]
    wood += [rod((-0.2, -0.03, 0.5), (0.2, 0.03, 0.5), 0.014)]
    return {"rails": wood, "pads": pads, "grips": grips, "feet": feet}


def _paint_roller(draw: Draw) -> Parts:
    wide = draw(0.42, 0.5)
    roller = [rod((-wide, 0, 0.8), (wide, 0, 0.8), 0.15, rim=0.03)]
    caps = both_sides([rod((wide - 0.01, 0, 0.8), (wide + 0.02, 0, 0.8), 0.1, rim=0.006)])
    wire = [
        pipe(
            [
                (wide, 0, 0.8),
                (wide + 0.1, 0, 0.8),
                (wide + 0.12, 0, 0.72),
                (wide + 0.1, 0, 0.52),
                (wide - 0.02, 0, 0.44),
                (0.1, 0, 0.36),
                (0, 0, 0.26),
                (0, 0, 0.0),
            ],
            0.026,
        )
    ]
    grip = [
        turned(
            [
                (0, 0.04),
                (0.05, 0.04),
                (0.07, 0.0),
                (0.055, -0.1),
                (0.075, -0.3),
                (0.06, -0.5),
                (0.075, -0.62),
                (0.05, -0.7),
                (0, -0.71),
            ][::-1]
        )
    ]
    paint = [
        plate(
            closed_curve(
                [
                    (-wide, 1.5),
                    (-0.5 * wide, 1.56),
                    (0.4 * wide, 1.52),
                    (0.98 * wide, 1.55),
                    (0.98 * wide, 0.86),
                    (-0.98 * wide, 0.86),
                    (-0.98 * wide, 1.1),
                ]
            ),
            0.03,
            (0, 0.13, 0),
            FRONT,
        ),
        *(
            capsule((x, 0.12, 0.86), (x, 0.12, 0.86 - d), 0.03)
            for x, d in ((-0.28, 0.2), (0.02, 0.12), (0.3, 0.26))
        ),
    ]
    return {"roller": [*roller], "wire": [*wire, *caps], "grip": grip, "paint": paint}


def _paint_bucket(draw: Draw) -> Parts:
    r, high = 0.42, draw(0.82, 0.94)
    tin = [
        turned(
            [
                (0, 0),
                (r, 0),
                (r, high - 0.05),
                (r + 0.02, high - 0.02),
                (r + 0.02, high + 0.02),
                (r - 0.08, high + 0.02),
                (r - 0.08, high - 0.1),
                (0, high - 0.12),
            ]
        ),
        ring(r, 0.018, (0, 0, 0.02)),
    ]
    label = [
        turned(
            [(r - 0.02, 0.16), (r + 0.008, 0.16), (r + 0.008, high - 0.2), (r - 0.02, high - 0.2)]
        )
    ]
    paint = [rod((0, 0, high - 0.15), (0, 0, high - 0.06), r - 0.07)]
    for a, d, w in (
        (-1.9, 0.4, 0.05),
        (-1.55, 0.62, 0.06),
        (-1.2, 0.3, 0.05),
        (-2.4, 0.2, 0.04),
        (-0.7, 0.18, 0.045),
    ):
        x, y = np.cos(a), np.sin(a)
        paint += [
            capsule(
                ((r - 0.12) * x, (r - 0.12) * y, high - 0.07),
                ((r + 0.01) * x, (r + 0.01) * y, high + 0.03),
                w,
            ),
            capsule(
                ((r + 0.015) * x, (r + 0.015) * y, high + 0.02),
                ((r + 0.012) * x, (r + 0.012) * y, high - d),
                w,
                0.8 * w,
            ),
        ]
    handle = [
        pipe(
            [
                (-r - 0.01, 0, high - 0.1),
                (-r - 0.1, -0.1, high - 0.2),
                (-0.3, -r - 0.12, high - 0.42),
                (0.3, -r - 0.12, high - 0.42),
                (r + 0.1, -0.1, high - 0.2),
                (r + 0.01, 0, high - 0.1),
            ],
            0.018,
        ),
        *both_sides([rod((r - 0.02, 0, high - 0.1), (r + 0.03, 0, high - 0.1), 0.04, rim=0.008)]),
    ]
    brush = [
        rod((0.1, 0.1, high - 0.05), (0.34, 0.34, high + 0.5), 0.035, 0.05),
        box((0.24, 0.09, 0.14), (0.07, 0.07, high - 0.08), 0.01, (0, 20, 45)),
    ]
    return {"tin": tin, "label": label, "paint": paint, "handle": handle, "brush": brush}


def _jackhammer(draw: Draw) -> Parts:
    long = draw(0.55, 0.7)
    body = [
        rod((0, 0, 0.0), (0, 0, 0.66), 0.15, rim=0.02),
        rod((0, 0, -0.2), (0, 0, 0.04), 0.11, 0.14, 0.015),
        box((0.2, 0.34, 0.34), (0, 0, 0.44), 0.04),
        *(rod((0, 0, z), (0, 0, z + 0.03), 0.165, rim=0.008) for z in (0.08, 0.16, 0.24)),
        rod((0, 0, 0.64), (0, 0, 0.78), 0.12, 0.1, 0.02),
        *(
            rod((0.1 * s, 0.1 * t, 0.0), (0.1 * s, 0.1 * t, 0.62), 0.026)
            for s in (-1, 1)
            for t in (-1, 1)
        ),
    ]
    chisel = [
        rod((0, 0, -0.16), (0, 0, -0.2 - long), 0.045),
        rod((0, 0, -0.2 - long), (0, 0, -0.4 - long), 0.048, 0.012),
        rod((0, 0, -0.3), (0, 0, -0.22), 0.085, rim=0.01),
    ]
    bars = [
        rod((-0.42, 0, 0.76), (0.42, 0, 0.76), 0.035),
        box((0.2, 0.14, 0.12), (0, 0, 0.76), 0.03),
    ]
    grips = both_sides([rod((0.2, 0, 0.76), (0.46, 0, 0.76), 0.052, rim=0.015)])
    hose = [
        rod((0, 0.14, 0.62), (0, 0.24, 0.64), 0.05),
        pipe([(0, 0.2, 0.63), (0.05, 0.36, 0.58), (0.2, 0.44, 0.2), (0.3, 0.5, -0.3)], 0.04),
    ]
    trigger = [
        box((0.05, 0.05, 0.1), (0.24, -0.03, 0.82), 0.012),
        box((0.21, 0.36, 0.06), (0, 0, 0.44), 0.015),
    ]
    return {
        "body": body,
        "chisel": chisel,
        "bars": bars,
        "grips": grips,
        "hose": hose,
        "trigger": trigger,
    }


def _chisel(draw: Draw) -> Parts:
    long = draw(0.8, 0.95)
    blade = [
        plate([(-0.1, 0), (0.1, 0), (0.1, -long), (-0.1, -long)], 0.05, (0, 0, 0), FRONT),
        rod((0, 0, -0.05), (0, 0, 0.14), 0.05, 0.07, 0.01),
    ]
    edge = [
        plate(
            [(-0.026, -long), (0.026, -long), (0.026, -long - 0.02), (-0.02, -long - 0.14)],
            0.198,
            (0, 0, 0),
            SIDE,
        )
    ]
    grip = [
        turned(
            [
                (0, 0.12),
                (0.08, 0.12),
                (0.09, 0.16),
                *curve([(0.09, 0.16), (0.075, 0.3), (0.1, 0.55), (0.09, 0.72)]),
                (0.075, 0.76),
                (0, 0.77),
            ]
        )
    ]
    bands = [
        rod((0, 0, 0.12), (0, 0, 0.2), 0.098, rim=0.01),
        rod((0, 0, 0.68), (0, 0, 0.75), 0.1, rim=0.01),
    ]
    return {"blade": blade, "edge": edge, "grip": grip, "bands": bands}


def _wood_plane(draw: Draw) -> Parts:
    long = draw(0.85, 1.0)
    body = [
        box((0.34, 2 * long, 0.24), (0, 0, 0.14), 0.02),
        box((0.36, 2 * long + 0.02, 0.06), (0, 0, 0.03), 0.01),
    ]
    tote = [
        plate(
            closed_curve(
                [
                    (0.34, 0.24),
                    (0.62, 0.24),
                    (0.66, 0.4),
                    (0.6, 0.62),
                    (0.7, 0.74),
                    (0.58, 0.8),
                    (0.46, 0.7),
                    (0.46, 0.46),
                ]
            ),
            0.12,
            (0, 0, 0),
            SIDE,
        )
    ]
    knob = [
        turned(
            [
                (0, 0.22),
                (0.12, 0.22),
                (0.09, 0.3),
                (0.06, 0.36),
                *curve([(0.06, 0.36), (0.13, 0.44), (0.12, 0.54), (0.06, 0.58)]),
                (0, 0.59),
            ],
            (0, -0.66 * long, 0),
        )
    ]
    iron = [
        box((0.24, 0.04, 0.62), (0, 0.1, 0.4), 0.008, (-42, 0, 0)),
        box((0.2, 0.05, 0.34), (0, 0.06, 0.42), 0.01, (-42, 0, 0)),
        rod((0, -0.06, 0.36), (0, 0.06, 0.5), 0.05, rim=0.01),
    ]
    shaving = [
        pipe(
            [
                (
                    0,
                    -0.14 + 0.16 * (1 - 0.07 * t) * np.cos(t + 3.6),
                    0.44 + 0.16 * (1 - 0.07 * t) * np.sin(t + 3.6),
                )
                for t in np.linspace(0, 8, 18)
            ],
            0.03,
        ),
        rod((0, -0.16, 0.22), (0, -0.24, 0.38), 0.035),
    ]
    return {"body": body, "handle": [*tote, *knob], "iron": iron, "shaving": shaving}


def _workbench(draw: Draw) -> Parts:
    wide = draw(0.95, 1.1)
    top = [box((2 * wide, 0.13, 0.09), (0, -0.34 + 0.136 * k, 0.86), 0.01) for k in range(6)] + [
        box((2 * wide - 0.1, 0.7, 0.08), (0, 0, 0.79), 0.01)
    ]
    legs = (
        [
            box((0.12, 0.12, 0.8), (s * (wide - 0.16), t * 0.28, 0.4), 0.012)
            for s in (-1, 1)
            for t in (-1, 1)
        ]
        + [box((2 * wide - 0.3, 0.08, 0.1), (0, t * 0.28, 0.2), 0.01) for t in (-1, 1)]
        + [box((0.08, 0.56, 0.1), (s * (wide - 0.16), 0, 0.2), 0.01) for s in (-1, 1)]
    )
    shelf = [box((2 * wide - 0.36, 0.54, 0.05), (0, 0, 0.25), 0.01)]
    board = [
        box((2 * wide, 0.05, 0.74), (0, 0.4, 1.26), 0.01),
        *(box((0.07, 0.07, 0.9), (s * (wide - 0.06), 0.42, 1.2), 0.01) for s in (-1, 1)),
    ]
    vise = [
        box((0.34, 0.1, 0.16), (-wide + 0.3, -0.5, 0.82), 0.015),
        rod((-wide + 0.3, -0.42, 0.8), (-wide + 0.3, -0.66, 0.8), 0.03),
        rod((-wide + 0.18, -0.62, 0.8), (-wide + 0.42, -0.62, 0.8), 0.016),
        box((0.34, 0.08, 0.16), (-wide + 0.3, -0.42, 0.82), 0.012),
    ]
    steel = [
        rod((-0.52, 0.36, 1.44), (-0.52, 0.36, 1.2), 0.022),
        box((0.2, 0.07, 0.08), (-0.52, 0.36, 1.46), 0.015),
        plate(
            closed_curve([(-0.2, 1.5), (-0.06, 1.5), (-0.06, 1.12), (-0.2, 1.12), (-0.19, 1.3)]),
            0.04,
            (0, 0.36, 0),
            FRONT,
        ),
        *(
            rod((0.12 + 0.13 * k, 0.36, 1.46), (0.12 + 0.13 * k, 0.36, 1.3), 0.018)
            for k in range(4)
        ),
        plate([(0.62, 1.5), (0.86, 1.42), (0.86, 1.36), (0.62, 1.34)], 0.03, (0, 0.36, 0), FRONT),
    ]
    grips = [
        rod((-0.52, 0.36, 1.22), (-0.52, 0.36, 1.06), 0.032, rim=0.008),
        *(
            capsule((0.12 + 0.13 * k, 0.36, 1.28), (0.12 + 0.13 * k, 0.36, 1.16), 0.034)
            for k in range(4)
        ),
        box((0.16, 0.05, 0.14), (0.62, 0.36, 1.43), 0.03),
        box((0.5, 0.3, 0.22), (0.3, 0.0, 0.38), 0.02),
        box((0.24, 0.2, 0.06), (0.2, 0.02, 0.93), 0.01),
    ]
    return {
        "top": top,
        "legs": [*legs, *shelf],
        "board": board,
        "vise": vise,
        "tools": steel,
        "grips": grips,
    }


def _music_stand(draw: Draw) -> Parts:
    tilt = Rotation.from_euler("x", -draw(14.0, 24.0), degrees=True).as_matrix()
    desk = placed(
        [
            plate(
                rounded((0.9, 0.56), 0.06),
                0.03,
                (0, 0, 0),
                FRONT,
                [rounded((0.16, 0.1), 0.04, (x, 0.12)) for x in (-0.28, 0.0, 0.28)],
            ),
            box((0.9, 0.12, 0.03), (0, -0.05, -0.27), 0.008),
        ],
        tilt,
        (0, 0, 1.3),
    )
    pole = [
        rod((0, 0.03, 0.3), (0, 0.03, 1.3), 0.026),
        rod((0, 0.03, 0.7), (0, 0.03, 0.8), 0.04, rim=0.008),
        rod((0, 0.03, 0.78), (0.08, 0.03, 0.78), 0.018),
        *(
            capsule((0, 0.03, 0.36), (0.42 * np.cos(a), 0.03 + 0.42 * np.sin(a), 0.02), 0.024)
            for a in (-np.pi / 2, 0.52, 2.62)
        ),
        rod((0, 0.03, 0.3), (0, 0.03, 0.42), 0.045, rim=0.01),
        box((0.1, 0.06, 0.12), (0, 0.03, 1.27), 0.015),
    ]
    sheets = placed(
        [box((0.32, 0.02, 0.44), (x, -0.02, -0.02), 0.0) for x in (-0.165, 0.165)],
        tilt,
        (0, 0, 1.3),
    )
    notes = []
    for x in (-0.165, 0.165):
        for row in range(4):
            z = 0.14 - 0.1 * row
            notes += [box((0.26, 0.014, 0.012), (x, -0.03, z + 0.022 * k)) for k in range(3)]
            notes += [
                ball(
                    (0.014, 0.012, 0.012),
                    (x - 0.1 + 0.05 * k, -0.034, z + 0.011 * ((3 * k + row) % 5)),
                )
                for k in range(5)
            ]
    return {"stand": [*desk, *pole], "sheets": sheets, "notes": placed(notes, tilt, (0, 0, 1.3))}


def _golf_bag(draw: Draw) -> Parts:
    lean = Rotation.from_euler("x", -draw(10.0, 16.0), degrees=True).as_matrix()
    bag = [
        rod((0, 0, 0), (0, 0, 1.1), 0.2, 0.22, 0.03),
        box((0.26, 0.14, 0.42), (0, -0.2, 0.4), 0.06),
        box((0.22, 0.12, 0.2), (0, -0.2, 0.78), 0.05),
        box((0.12, 0.24, 0.5), (0.18, 0, 0.5), 0.05),
    ]
    trim = [
        rod((0, 0, -0.02), (0, 0, 0.09), 0.212, rim=0.02),
        turned([(0.15, 1.04), (0.235, 1.04), (0.235, 1.14), (0.15, 1.14)]),
        rod((0, 0, 0.6), (0, 0, 0.64), 0.214, rim=0.006),
        rod((0, 0, 1.0), (0, 0, 1.12), 0.16),
    ]
    strap = [
        pipe([(0, 0.2, 1.0), (0, 0.36, 0.9), (0, 0.4, 0.66), (0, 0.34, 0.4), (0, 0.19, 0.28)], 0.03)
    ]
    shafts, heads, socks = [], [], []
    for k, (x, y, high) in enumerate(
        (
            (-0.1, 0.06, 1.5),
            (0.1, 0.07, 1.56),
            (0.0, -0.08, 1.44),
            (-0.09, -0.06, 1.4),
            (0.1, -0.05, 1.48),
        )
    ):
        shafts.append(rod((x, y, 1.05), (1.3 * x, 1.3 * y, high), 0.014))
        if k < 2:
            socks.append(ball((0.075, 0.1, 0.075), (1.3 * x, 1.3 * y - 0.04, high + 0.03)))
        else:
            heads.append(
                plate(
                    [(-0.02, 0), (0.03, 0.02), (0.05, 0.08), (-0.1, 0.1), (-0.12, 0.02)],
                    0.045,
                    (1.3 * x, 1.3 * y, high - 0.02),
                    FRONT,
                )
            )
    stand = both_sides(
        [rod((0.12, 0.04, 0.95), (0.3, -0.5, 0.02), 0.018), ball(0.03, (0.3, -0.5, 0.02))]
    )
    solids = {
        "bag": bag,
        "trim": trim,
        "strap": strap,
        "shafts": shafts,
        "irons": heads,
        "head covers": socks,
    }
    found = {name: placed(own, lean) for name, own in solids.items()}
    found["shafts"] += stand
    return found


TOOLS_AND_CARE: dict[str, Callable[[Draw], Parts]] = {
    "hospital bed": _hospital_bed,
    "crutches": _crutches,
    "paint roller": _paint_roller,
    "paint bucket": _paint_bucket,
    "jackhammer": _jackhammer,
    "chisel": _chisel,
    "wood plane": _wood_plane,
    "workbench": _workbench,
    "music stand": _music_stand,
    "golf bag": _golf_bag,
}
