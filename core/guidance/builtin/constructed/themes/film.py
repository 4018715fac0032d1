"""Things of film and of the studio."""

from collections.abc import Callable

import numpy as np
from scipy.spatial.transform import Rotation

from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.pieces import star
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
    placed,
    plate,
    ring,
    rod,
    rounded,
    turned,
)


def _clapperboard(draw: Draw) -> Parts:
    lift = draw(14.0, 28.0)
    board = [box((1.3, 0.06, 0.86), (0, 0, 0), 0.015), box((1.3, 0.07, 0.15), (0, 0, 0.46), 0.006)]
    arm = [box((1.3, 0.07, 0.15), (0.65, 0, 0.075), 0.006)]
    way = Rotation.from_euler("y", -lift, degrees=True).as_matrix()
    hinge = np.array([-0.65, 0, 0.54])
    stripe = np.array([(-0.09, -0.076), (0.05, -0.076), (0.11, 0.076), (-0.03, 0.076)])
    white = [plate(stripe + (-0.5 + 0.26 * k, 0), 0.078, (0, 0, 0.46), FRONT) for k in range(5)]
    upper = [
        plate(stripe * (-1, 1) + (0.15 + 0.26 * k, 0.075), 0.078, (0, 0, 0), FRONT)
        for k in range(5)
    ]
    lines = (
        [box((1.18, 0.014, 0.014), (0, -0.032, z)) for z in (0.2, 0.02, -0.16)]
        + [box((0.014, 0.014, 0.5), (x, -0.032, z)) for x, z in ((-0.2, -0.2), (0.22, -0.2))]
        + [box((1.18, 0.014, 0.014), (0, -0.032, -0.38))]
    )
    text = [
        box((w, 0.014, 0.05), (x, -0.032, z), 0.01)
        for w, x, z in (
            (0.3, -0.42, 0.28),
            (0.5, 0.1, 0.28),
            (0.26, -0.42, 0.1),
            (0.4, 0.06, 0.1),
            (0.2, -0.42, -0.08),
            (0.18, -0.42, -0.26),
            (0.2, 0.0, -0.26),
            (0.22, 0.42, -0.26),
        )
    ]
    bolts = [
        rod((-0.6, -0.05, 0.46), (-0.6, 0.05, 0.46), 0.03, rim=0.006),
        rod((-0.62, -0.052, 0.55), (-0.62, 0.052, 0.55), 0.045, rim=0.006),
    ]
    return {
        "board": [*board, *placed(arm, way, hinge)],
        "stripes": [*white, *placed(upper, way, hinge)],
        "lines": [*lines, *text],
        "hinge": bolts,
    }


def _film_reel(draw: Draw) -> Parts:
    count, r = 5 + draw.which(2), 0.8
    holes = [
        circle(0.19, (0.46 * np.cos(a), 0.46 * np.sin(a)), 32)
        for a in np.arange(count) * 2 * np.pi / count
    ]
    holes += [
        circle(0.035, (0.16 * np.cos(a), 0.16 * np.sin(a)), 16) for a in np.arange(3) * 2.1 + 0.5
    ]
    sides = [plate(circle(r), 0.035, (0, y, 0), FRONT, holes) for y in (-0.13, 0.13)]
    sides += [
        rod((0, -0.18, 0), (0, 0.18, 0), 0.1, rim=0.01),
        *(ring(r - 0.01, 0.022, (0, y, 0), "y") for y in (-0.13, 0.13)),
    ]
    film = [turned([(0.3, -0.115), (0.7, -0.115), (0.7, 0.115), (0.3, 0.115)], axis="y")]
    t = np.linspace(0, 1.0, 12)
    path = np.stack([0.62 + 0.75 * t, -0.33 - 0.44 * t + 0.3 * t**2 + 0.05 * np.sin(7 * t)], 1)
    path[0] = (0.5, -0.46)
    film += [plate([*path, *(path[::-1] - (0, 0.026))], 0.2, (0, 0, 0), FRONT)]
    frames = [
        box((0.07, 0.11, 0.012), (x, 0, z + 0.004), 0.0, (0, np.degrees(np.arctan2(-dz, dx)), 0))
        for (x, z), (dx, dz) in zip(
            (path[2:-1:2] + path[3::2]) / 2, path[3::2] - path[2:-1:2], strict=False
        )
    ]
    return {"reel": sides, "film": film, "frames": frames}


def _spotlight(draw: Draw) -> Parts:
    tilt = Rotation.from_euler("x", draw(14.0, 30.0), degrees=True).as_matrix()
    at = (0, 0, 1.1)
    can = placed(
        [
            turned(
                [
                    (0, -0.3),
                    (0.18, -0.3),
                    (0.26, -0.2),
                    (0.28, 0.3),
                    (0.25, 0.3),
                    (0.24, 0.26),
                    (0, 0.24),
                ]
            )
        ],
        FRONT,
    )
    can += [rod((0, y - 0.015, 0), (0, y + 0.015, 0), 0.29, rim=0.006) for y in (0.04, 0.1, 0.16)]
    lens = [rod((0, -0.2, 0), (0, -0.27, 0), 0.246)]
    doors = []
    for k in range(4):
        leaf = plate(
            [(-0.2, 0), (0.2, 0), (0.28, 0.32), (-0.28, 0.32)],
            0.025,
            (0, 0, 0),
            np.array([[1.0, 0, 0], [0, -1.0, 0], [0, 0, -1.0]]),
        )
        doors += placed(
            [leaf],
            Rotation.from_euler("y", 90 * k, degrees=True).as_matrix()
            @ Rotation.from_euler("x", -20, degrees=True).as_matrix(),
            Rotation.from_euler("y", 90 * k, degrees=True).as_matrix() @ (0, -0.27, 0.27),
        )
    yoke = [
        pipe(
            [
                (0.33, 0, 1.1),
                (0.35, 0, 0.8),
                (0.16, 0, 0.68),
                (-0.16, 0, 0.68),
                (-0.35, 0, 0.8),
                (-0.33, 0, 1.1),
            ],
            0.028,
        ),
        *both_sides([rod((0.26, 0, 1.1), (0.38, 0, 1.1), 0.05, rim=0.01)]),
    ]
    stand = [
        rod((0, 0, 0.1), (0, 0, 0.7), 0.035),
        *(
            rod((0, 0, 0.34), (0.5 * np.cos(a), 0.5 * np.sin(a), 0.02), 0.024)
            for a in (-np.pi / 2, 0.52, 2.62)
        ),
        rod((0, 0, 0.3), (0, 0, 0.4), 0.06, rim=0.01),
        *(ball(0.035, (0.5 * np.cos(a), 0.5 * np.sin(a), 0.02)) for a in (-np.pi / 2, 0.52, 2.62)),
    ]
    return {
        "body": placed(can, tilt, at),
        "lens": placed(lens, tilt, at),
        "barn doors": placed(doors, tilt, at),
        "stand": [*yoke, *stand],
    }


def _tripod(draw: Draw) -> Parts:
    wide = draw(0.52, 0.62)
    legs, feet, clips = [], [], []
    for a in (-np.pi / 2, np.pi / 6, 5 * np.pi / 6):
        end = np.array([wide * np.cos(a), wide * np.sin(a), 0.0])
        top = np.array([0.09 * np.cos(a), 0.09 * np.sin(a), 1.3])
        mid, low = top + 0.45 * (end - top), top + 0.75 * (end - top)
        legs += [
            rod(tuple(top), tuple(mid), 0.04),
            rod(tuple(mid), tuple(low), 0.032),
            rod(tuple(low), tuple(end), 0.024),
        ]
        clips += [
            ball(0.055, tuple(mid)),
            ball(0.045, tuple(low)),
            rod((0, 0, 0.82), tuple(top + 0.42 * (end - top)), 0.016),
        ]
        feet.append(ball(0.045, tuple(end)))
    column = [
        rod((0, 0, 0.75), (0, 0, 1.62), 0.034),
        rod((0, 0, 1.24), (0, 0, 1.4), 0.13, 0.09, 0.02),
        rod((0, 0, 0.78), (0, 0, 0.86), 0.06, rim=0.01),
    ]
    head = [
        box((0.14, 0.14, 0.14), (0, 0, 1.64), 0.03),
        box((0.26, 0.34, 0.045), (0, 0, 1.75), 0.015),
        rod((0.06, 0.05, 1.64), (0.16, 0.62, 1.5), 0.018),
        rod((0, 0, 1.68), (0, 0, 1.75), 0.05),
        rod((-0.14, 0, 1.64), (-0.06, 0, 1.64), 0.045, rim=0.01),
    ]
    grip = [
        capsule((0.14, 0.5, 1.53), (0.19, 0.76, 1.465), 0.036),
        rod((0, 0, 1.76), (0, 0, 1.8), 0.02),
    ]
    return {"legs": legs, "column": column, "head": head, "joints": [*clips, *grip], "feet": feet}


def _palette(draw: Draw) -> Parts:
    outline = closed_curve(
        [
            (-0.8, 0.05),
            (-0.62, 0.48),
            (-0.1, 0.64),
            (0.5, 0.52),
            (0.82, 0.14),
            (0.76, -0.3),
            (0.44, -0.4),
            (0.26, -0.22),
            (0.02, -0.24),
            (-0.1, -0.46),
            (-0.42, -0.5),
            (-0.72, -0.3),
        ]
    )
    wood = [
        plate(
            outline,
            0.05,
            (0, 0, 0),
            FRONT,
            [
                closed_curve(
                    [(-0.36, -0.22), (-0.24, -0.3), (-0.14, -0.2), (-0.22, -0.1), (-0.34, -0.12)]
                )
            ],
        )
    ]
    found = {f"{name} paint": [] for name in ("first", "second", "third", "fourth", "fifth")}
    places = [(-0.58, 0.12), (-0.44, 0.38), (-0.12, 0.48), (0.22, 0.44), (0.54, 0.3)]
    for name, (x, z) in zip(found, places, strict=True):
        r = draw(0.1, 0.125)
        found[name] += [
            ball((r, 0.055, 0.9 * r), (x, -0.03, z)),
            ball((0.5 * r, 0.06, 0.4 * r), (x + 0.3 * r, -0.05, z + 0.2 * r)),
            ball((0.4 * r, 0.045, 0.5 * r), (x - 0.7 * r, -0.02, z - 0.5 * r)),
        ]
    brush = [
        rod((0.1, -0.06, -0.52), (0.5, -0.07, 0.16), 0.026, 0.034),
        capsule((-0.1, -0.055, -0.86), (0.1, -0.06, -0.52), 0.016, 0.026),
    ]
    found["third paint"] += [capsule((0.55, -0.07, 0.24), (0.6, -0.07, 0.34), 0.045, 0.012)]
    ferrule = [rod((0.48, -0.07, 0.13), (0.56, -0.07, 0.26), 0.042)]
    return {"board": wood, "brush": [*brush, *ferrule], **found}


def _director_chair(draw: Draw) -> Parts:
    wide = draw(0.5, 0.56)
    wood = []
    for y in (-0.3, 0.3):
        wood += [
            rod((-wide, y, 0.06), (wide, y, 0.86), 0.03),
            rod((wide, y, 0.06), (-wide, y, 0.86), 0.03),
        ]
    wood += both_sides(
        [
            box((0.07, 0.82, 0.06), (wide, 0, 0.04), 0.012),
            box((0.06, 0.76, 0.06), (wide, 0, 0.86), 0.012),
            box((0.1, 0.8, 0.05), (wide + 0.02, -0.02, 1.16), 0.018),
            *(box((0.055, 0.055, 0.3), (wide, y, 1.0), 0.01) for y in (-0.32, 0.32)),
            box((0.055, 0.055, 0.6), (wide, 0.34, 1.42), 0.012),
        ]
    )
    cloth = [
        plate(
            [(-wide, 0.88), (0, 0.82), (wide, 0.88), (wide, 0.845), (0, 0.785), (-wide, 0.845)],
            0.68,
            (0, 0, 0),
            FRONT,
        ),
        plate(rounded((2 * wide + 0.08, 0.36), 0.02), 0.03, (0, 0.34, 1.52), FRONT),
        *both_sides([rod((wide, 0.34, 1.35), (wide, 0.34, 1.7), 0.045)]),
    ]
    outline = star(5, 0.13, 0.055, (0.0, 1.52))
    mark = [plate(outline, 0.055, (0, 0.34, 0), FRONT)]
    bolts = [rod((0, y - 0.045, 0.46), (0, y + 0.045, 0.46), 0.04, rim=0.008) for y in (-0.3, 0.3)]
    return {"cloth": cloth, "frame": wood, "star": mark, "bolts": bolts}


FILM: dict[str, Callable[[Draw], Parts]] = {
    "clapperboard": _clapperboard,
    "film reel": _film_reel,
    "spotlight": _spotlight,
    "tripod": _tripod,
    "palette": _palette,
    "director chair": _director_chair,
}
