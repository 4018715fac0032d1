"""Things of smoking, and a lava lamp."""

from collections.abc import Callable

import numpy as np
from scipy.spatial.transform import Rotation

from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.shapes import (
    FRONT,
    LEFTWARD,
    Parts,
    ball,
    both_sides,
    box,
    moved,
    pipe,
    placed,
    plate,
    ring,
    rod,
    rounded,
    spun,
    turned,
)


def _hookah(draw: Draw) -> Parts:
    hoses = 1 + draw.which(2)
    base = [
        (0, 0),
        (0.24, 0),
        (0.27, 0.05),
        (0.3, 0.2),
        (0.26, 0.36),
        (0.14, 0.5),
        (0.09, 0.6),
        (0.11, 0.66),
        (0.07, 0.68),
        (0, 0.68),
    ]
    stem = [
        (0, 0.64),
        (0.1, 0.66),
        (0.1, 0.72),
        (0.05, 0.76),
        (0.05, 0.92),
        (0.085, 0.98),
        (0.05, 1.04),
        (0.045, 1.3),
        (0.08, 1.36),
        (0.04, 1.4),
        (0.04, 1.5),
        (0, 1.5),
    ]
    tray = [(0, 1.46), (0.22, 1.48), (0.25, 1.52), (0.22, 1.52), (0, 1.5)]
    bowl = [
        (0, 1.5),
        (0.05, 1.5),
        (0.06, 1.58),
        (0.13, 1.66),
        (0.14, 1.76),
        (0.11, 1.76),
        (0.1, 1.7),
        (0, 1.68),
    ]
    coals = [
        ball((0.045, 0.045, 0.035), (0.055 * np.cos(a), 0.055 * np.sin(a), 1.745))
        for a in np.arange(3) * 2.1
    ] + [rod((0, 0, 1.65), (0, 0, 1.72), 0.108)]
    tubes, tips = [], []
    for s in (1, -1)[:hoses]:
        way = [
            (0, 0, 0.7),
            (s * 0.16, -0.04, 0.74),
            (s * 0.36, -0.1, 0.7),
            (s * 0.52, -0.18, 0.4),
            (s * 0.5, -0.26, 0.12),
            (s * 0.3, -0.36, 0.06),
            (s * 0.16, -0.44, 0.16),
            (s * 0.22, -0.5, 0.42),
        ]
        tubes.append(pipe(way, 0.028))
        tips += [
            rod((s * 0.2, -0.48, 0.32), (s * 0.28, -0.54, 0.66), 0.036, 0.026),
            rod((s * 0.27, -0.53, 0.62), (s * 0.3, -0.56, 0.76), 0.018),
            rod((s * 0.06, -0.02, 0.71), (s * 0.14, -0.035, 0.735), 0.045),
        ]
    rings = [
        ring(0.26, 0.018, (0, 0, 0.36)),
        ring(0.285, 0.02, (0, 0, 0.06)),
        ring(0.085, 0.02, (0, 0, 0.98)),
        ring(0.138, 0.016, (0, 0, 1.755)),
    ]
    return {
        "base": [turned(base)],
        "stem": [turned(stem), turned(tray), *rings],
        "bowl": [turned(bowl)],
        "coals": coals,
        "hose": tubes,
        "mouthpiece": tips,
    }


def _lava_lamp(draw: Draw) -> Parts:
    foot = [(0, 0), (0.3, 0), (0.31, 0.03), (0.17, 0.34), (0.22, 0.52), (0.21, 0.54), (0, 0.52)]
    glass = [(0, 0.5), (0.21, 0.5), (0.25, 0.66), (0.11, 1.34), (0, 1.34)]
    cap = [(0, 1.32), (0.125, 1.32), (0.09, 1.56), (0.08, 1.58), (0, 1.58)]
    blobs = []
    rng = np.random.default_rng(draw.which(1000))
    for z, r in ((0.6, 0.13), (0.78, 0.085), (0.98, 0.1), (1.14, 0.06), (1.27, 0.055)):
        side = 0.236 - (z - 0.66) * 0.206
        a = rng.uniform(-2.4, -0.7)
        blobs.append(
            ball(
                (r, r, 1.25 * r), ((side - 0.72 * r) * np.cos(a), (side - 0.72 * r) * np.sin(a), z)
            )
        )
        blobs.append(
            ball(
                (0.8 * r, 0.8 * r, r),
                ((side - 0.6 * r) * np.cos(a + 2.2), (side - 0.6 * r) * np.sin(a + 2.2), z + 0.06),
            )
        )
    rings = [ring(0.165, 0.02, (0, 0, 0.34)), ring(0.12, 0.018, (0, 0, 1.33))]
    return {
        "base": [turned(foot), turned(cap)],
        "glass": [turned(glass)],
        "lava": blobs,
        "rings": rings,
    }


def _ashtray(draw: Draw) -> Parts:
    count = 3 + draw.which(2)
    dish = [
        (0, 0),
        (0.5, 0),
        (0.56, 0.04),
        (0.56, 0.2),
        (0.52, 0.24),
        (0.44, 0.24),
        (0.4, 0.1),
        (0, 0.08),
    ]
    butts, filters, ash = [], [], []
    for k in range(count):
        a = 2 * np.pi * k / count + 0.5
        start = 0.3
        way = np.array([np.cos(a), np.sin(a)])
        filters.append(rod((*(0.52 * way), 0.265), (*(0.74 * way), 0.285), 0.042, rim=0.006))
        butts.append(rod((*(start * way), 0.245), (*(0.53 * way), 0.266), 0.04, rim=0.004))
        ash.append(ball((0.042, 0.042, 0.042), (*(start * way), 0.244)))
    ash += [
        ball((0.24, 0.22, 0.06), (0.02, 0.03, 0.09)),
        ball((0.12, 0.1, 0.06), (-0.12, -0.06, 0.1)),
    ]
    rests = [
        box(
            (0.13, 0.12, 0.06),
            (
                0.5 * np.cos(2 * np.pi * k / count + 0.5),
                0.5 * np.sin(2 * np.pi * k / count + 0.5),
                0.215,
            ),
            0.02,
            (0, 0, np.degrees(2 * np.pi * k / count + 0.5)),
        )
        for k in range(count)
    ]
    return {"dish": [turned(dish), *rests], "cigarettes": butts, "filters": filters, "ash": ash}


def _lighter(draw: Draw) -> Parts:
    tilt = draw(105.0, 125.0)
    case = [box((0.56, 0.22, 0.7), (0, 0, 0.36), 0.05)]
    lid = [box((0.56, 0.22, 0.36), (0, 0, 0.18), 0.05)]
    way = Rotation.from_euler("y", tilt, degrees=True).as_matrix()
    hinge = (0.29, 0, 0.72)
    lids = placed(moved(lid, (-0.29, 0, 0.0)), way, hinge)
    lids += [box((0.12, 0.17, 0.1), (0.27, 0, 0.7), 0.02)]
    chimney = [
        plate(rounded((0.36, 0.17), 0.07), 0.26, (-0.05, 0, 0.8)),
    ]
    holes = [
        rod((x, -0.09, z), (x, 0.09, z), 0.022) for x in (-0.14, -0.06, 0.02) for z in (0.78, 0.86)
    ]
    spark = [
        rod((0.1, -0.05, 0.88), (0.1, 0.05, 0.88), 0.075),
        *placed(spun([box((0.014, 0.1, 0.03), (0, 0, 0.073))], 16, "y"), np.eye(3), (0.1, 0, 0.88)),
    ]
    flame = [
        turned([(0, -0.02), (0.06, 0.03), (0.075, 0.1), (0.04, 0.24), (0, 0.34)], (-0.08, 0, 0.92))
    ]
    return {"case": [*case, *lids], "chimney": [*chimney, *spark], "holes": holes, "flame": flame}


def _matchbox(draw: Draw) -> Parts:
    out = draw(0.24, 0.38)
    sleeve = [
        plate(
            [(-0.3, -0.1), (0.3, -0.1), (0.3, 0.1), (-0.3, 0.1)],
            1.0,
            (0, 0.0, 0.1),
            FRONT,
            [np.array([(-0.275, -0.075), (0.275, -0.075), (0.275, 0.075), (-0.275, 0.075)])],
        )
    ]
    strike = both_sides([box((0.012, 0.92, 0.15), (0.3, 0, 0.1))])
    label = [
        box((0.44, 0.72, 0.012), (0, 0, 0.2)),
    ]
    emblem = [rod((0, 0, 0.2), (0, 0, 0.212), 0.15)]
    tray = [
        box((0.55, 1.0, 0.02), (0, -out, 0.035)),
        *both_sides([box((0.02, 1.0, 0.14), (0.265, -out, 0.09))]),
        box((0.55, 0.02, 0.14), (0, -out - 0.49, 0.09)),
    ]
    sticks, heads = [], []
    for k, x in enumerate(np.linspace(-0.22, 0.22, 9)):
        y = -out - 0.44 + 0.015 * (k % 3)
        sticks.append(box((0.035, 0.8, 0.035), (x, y + 0.42, 0.06 + 0.02 * (k % 2))))
        heads.append(ball((0.034, 0.05, 0.034), (x, y + 0.03, 0.06 + 0.02 * (k % 2))))
    return {
        "sleeve": sleeve,
        "striker": strike,
        "label": label,
        "emblem": emblem,
        "tray": tray,
        "sticks": sticks,
        "heads": heads,
    }


def _cigar(draw: Draw) -> Parts:
    long = draw(0.8, 0.95)
    shape = [
        (0, -long),
        (0.09, -long),
        (0.1, -0.4),
        (0.1, 0.5),
        (0.085, 0.7),
        (0.04, 0.8),
        (0, 0.81),
    ]
    band = [(0.09, 0.28), (0.108, 0.28), (0.108, 0.46), (0.09, 0.46)]
    gold = [[(0.09, z), (0.114, z), (0.114, z + 0.035), (0.09, z + 0.035)] for z in (0.26, 0.445)]
    ash = [
        (0, -long - 0.09),
        (0.05, -long - 0.1),
        (0.086, -long - 0.05),
        (0.088, -long + 0.01),
        (0, -long + 0.01),
    ]
    glow = [
        (0.05, -long - 0.008),
        (0.096, -long - 0.008),
        (0.097, -long + 0.03),
        (0.05, -long + 0.03),
    ]
    return {
        "leaf": placed([turned(shape)], LEFTWARD),
        "band": placed([turned(band)], LEFTWARD),
        "trim": placed(
            [
                *(turned(g) for g in gold),
                *(ball(0.03, (0, -0.1 * np.sin(a), 0.37)) for a in (np.pi / 2,)),
            ],
            LEFTWARD,
        ),
        "ash": placed([turned(ash)], LEFTWARD),
        "ember": placed([turned(glow)], LEFTWARD),
    }


SMOKING: dict[str, Callable[[Draw], Parts]] = {
    "hookah": _hookah,
    "lava lamp": _lava_lamp,
    "ashtray": _ashtray,
    "lighter": _lighter,
    "matchbox": _matchbox,
    "cigar": _cigar,
}
