"""Things of a hospital, of a road, of music and of golf."""

from collections.abc import Callable

import numpy as np
from scipy.spatial.transform import Rotation

from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.shapes import (
    FRONT,
    Parts,
    ball,
    both_sides,
    box,
    capsule,
    pipe,
    placed,
    plate,
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
    "jackhammer": _jackhammer,
    "music stand": _music_stand,
    "golf bag": _golf_bag,
}
