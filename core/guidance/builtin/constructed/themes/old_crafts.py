"""Old crafts, and a time machine."""

from collections.abc import Callable

import numpy as np

from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.pieces import SQUARE, wheel
from core.guidance.builtin.constructed.shapes import (
    BACKWARD,
    FRONT,
    Parts,
    ball,
    both_sides,
    box,
    capsule,
    closed_curve,
    curve,
    moved,
    pipe,
    plate,
    rod,
    spun,
    turned,
)


def _spinning_wheel(draw: Draw) -> Parts:
    r = draw(0.5, 0.56)
    z = 0.86
    wood = [
        box((0.3, 1.3, 0.08), (0, 0.1, 0.42), 0.012, (6, 0, 0)),
        *(
            rod((x, y, 0.46), (1.5 * x, y + 0.12 * np.sign(y), 0), 0.04, 0.03)
            for x in (-0.11, 0.11)
            for y in (-0.4, 0.6)
        ),
        *both_sides(
            [
                rod((0.12, 0.3, 0.44), (0.12, 0.3, z + 0.06), 0.036),
                ball(0.05, (0.12, 0.3, z + 0.09)),
            ]
        ),
    ]
    wood += [rod((x, -0.42, 0.36), (x, -0.42, 0.86), 0.03) for x in (-0.1, 0.1)] + [
        rod((-0.14, -0.42, 0.6), (0.14, -0.42, 0.6), 0.022),
        *(ball(0.042, (x, -0.42, 0.88)) for x in (-0.1, 0.1)),
    ]
    big = moved(wheel(r, 0.08, 12, 0.12), (0, 0.3, z))
    treadle = [
        box((0.26, 0.5, 0.03), (0, 0.2, 0.1), 0.006, (-8, 0, 0)),
        rod((0.14, 0.3, z), (0.09, 0.26, 0.1), 0.018),
        box((0.4, 0.06, 0.05), (0, 0.655, 0.2), 0.01),
        rod((-0.15, 0.3, z), (0.16, 0.3, z), 0.026),
    ]
    spindle = [
        rod((-0.26, -0.42, 0.74), (0.26, -0.42, 0.74), 0.018),
        rod((-0.06, -0.42, 0.74), (-0.03, -0.42, 0.74), 0.08, rim=0.006),
        pipe(
            [
                (0.06, -0.42, 0.86),
                (-0.14, -0.42, 0.86),
                (-0.2, -0.42, 0.74),
                (-0.14, -0.42, 0.62),
                (0.06, -0.42, 0.62),
            ],
            0.016,
        ),
    ]
    yarn = [
        ball((0.1, 0.062, 0.062), (0.08, -0.42, 0.74)),
        pipe([(0.26, -0.42, 0.74), (0.3, -0.5, 0.95), (0.25, -0.42, 1.22)], 0.0125),
    ]
    distaff = [
        rod((0.24, -0.42, 0.4), (0.25, -0.42, 1.36), 0.018),
        rod((0.1, -0.42, 0.42), (0.26, -0.42, 0.44), 0.024),
    ]
    wool = [
        ball((0.12, 0.11, 0.22), (0.25, -0.42, 1.28)),
        *(
            ball(
                (0.08, 0.08, 0.1),
                (0.25 + 0.06 * np.cos(a), -0.42 + 0.06 * np.sin(a), 1.2 + 0.06 * k),
            )
            for k, a in enumerate((0.3, 2.2, 4.4))
        ),
    ]
    cord = [
        rod((-0.045, 0.3 - 0.1 * r, z + s * r), (-0.045, -0.42, 0.74 + s * 0.078), 0.011)
        for s in (-1, 1)
    ]
    return {
        "frame": [*wood, *treadle, *distaff],
        "wheel": big,
        "spindle": spindle,
        "yarn": [*yarn, *cord],
        "wool": wool,
    }


def _loom(draw: Draw) -> Parts:
    wide, done = 0.62, draw(0.36, 0.5)
    frame = (
        [box((0.1, 0.12, 1.7), (s * wide, 0.1, 0.85), 0.012) for s in (-1, 1)]
        + [box((0.12, 0.8, 0.1), (s * wide, 0.05, 0.05), 0.012) for s in (-1, 1)]
        + [rod((-wide - 0.12, 0.1, z), (wide + 0.12, 0.1, z), 0.055) for z in (0.34, 1.58)]
        + [
            box((2 * wide, 0.08, 0.08), (0, 0.14, 0.16), 0.01),
            *both_sides([ball(0.075, (wide + 0.13, 0.1, z)) for z in (0.34, 1.58)]),
        ]
    )
    count = 30
    warp = [
        rod((x, 0.06, 0.34), (x, 0.06, 1.58), 0.011)
        for x in np.linspace(-wide + 0.14, wide - 0.14, count)
    ]
    bands = {"cloth": [], "stripes": [], "accents": []}
    names = ["cloth", "stripes", "cloth", "accents", "cloth", "stripes", "cloth", "accents"]
    rows = int(done * 1.2 / 0.035)
    for k in range(rows):
        bands[names[(k // 3) % 8]].append(
            capsule(
                (-wide + 0.12, 0.06, 0.41 + 0.035 * k), (wide - 0.12, 0.06, 0.41 + 0.035 * k), 0.022
            )
        )
    tools = [
        box((2 * wide + 0.1, 0.07, 0.07), (0, 0.03, 1.12), 0.012),
        box((2 * wide - 0.04, 0.06, 0.05), (0, 0.07, 1.3), 0.01),
        plate(
            closed_curve([(-0.2, 0), (0, 0.05), (0.2, 0), (0, -0.05)]),
            0.06,
            (0.1, 0.02, 0.46 + 0.035 * rows),
            FRONT,
        ),
    ]
    fringe = [
        capsule((x, 0.05, 0.4), (x, 0.02, 0.26), 0.014)
        for x in np.linspace(-wide + 0.16, wide - 0.16, 16)
    ]
    return {"frame": frame, "warp": [*warp, *fringe], **bands, "shuttle": tools}


def _forge(draw: Draw) -> Parts:
    stone = [
        box((1.3, 0.9, 0.62), (0, 0, 0.31), 0.015),
        box((1.4, 1.0, 0.1), (0, 0, 0.66), 0.015),
        *(box((0.16, 0.9, 0.16), (s * 0.6, 0, 0.78), 0.012) for s in (-1, 1)),
        box((1.2, 0.16, 0.16), (0, 0.4, 0.78), 0.012),
    ]
    stone += [
        box((0.2, 0.06, 0.12), (-0.5 + 0.25 * k + 0.12 * (j % 2), -0.45, 0.12 + 0.15 * j), 0.015)
        for j in range(4)
        for k in range(4)
    ]
    hood = [
        plate(
            SQUARE * (0.52 - 0.034 * k, 0.36 - 0.018 * k),
            0.06,
            (0, 0.06 + 0.012 * k, 1.22 + 0.052 * k),
        )
        for k in range(10)
    ] + [
        box((0.38, 0.36, 0.7), (0, 0.18, 2.0), 0.012),
        box((0.46, 0.44, 0.08), (0, 0.18, 2.34), 0.012),
    ]
    posts = [
        box((0.09, 0.09, 0.5), (s * 0.46, t * 0.3 + 0.06, 0.98), 0.01)
        for s in (-1, 1)
        for t in (-1, 1)
    ]
    rng = np.random.default_rng(draw.which(1000))
    coals, embers = [rod((0, 0, 0.68), (0, 0, 0.76), 0.46, 0.4, 0.02)], []
    for k in range(46):
        a, d = 2.4 * k, 0.4 * np.sqrt((k + 0.5) / 46)
        r = float(rng.uniform(0.05, 0.08))
        (embers if d < 0.26 else coals).append(
            ball((r, r, 0.9 * r), (d * np.cos(a), d * np.sin(a), 0.78 + 0.1 * (1 - d / 0.4)))
        )
    flames = [
        turned(
            [
                (0, 0.82),
                *curve([(0.05, 0.84), (0.075, 0.92), (0.03, 1.06), (0.008, 1.14 + 0.06 * k)]),
                (0, 1.15 + 0.06 * k),
            ],
            (0.14 * np.cos(2.2 * k), 0.1 * np.sin(2.2 * k), 0),
        )
        for k in range(4)
    ]
    leather = [
        plate(
            [(0, -0.18), (0.5, -0.05), (0.5, 0.05), (0, 0.18)],
            0.3,
            (0.86, 0.2, 0.62),
            BACKWARD,
        )
    ]
    tools = [
        rod((-0.36, -0.3, 0.72), (-0.02, 0.0, 0.86), 0.022),
        rod((-0.62, -0.52, 0.59), (-0.34, -0.28, 0.73), 0.034),
        rod((0.62, 0.2, 0.62), (0.9, 0.2, 0.62), 0.05),
    ]
    wood = [
        box((0.5, 0.34, 0.04), (1.12, 0.2, 0.72), 0.01, (0, 14, 0)),
        box((0.5, 0.34, 0.04), (1.12, 0.2, 0.52), 0.01, (0, -14, 0)),
        rod((1.3, 0.2, 0.66), (1.62, 0.2, 0.76), 0.03),
        *(box((0.07, 0.07, 0.56), (1.1, 0.2 + s * 0.22, 0.3), 0.01) for s in (-1, 1)),
        box((0.08, 0.56, 0.07), (1.1, 0.2, 0.5), 0.01),
    ]
    return {
        "hearth": [*stone, *hood],
        "posts": [*posts, *tools],
        "coals": coals,
        "embers": embers,
        "flames": flames,
        "bellows": leather,
        "boards": wood,
    }


def _time_machine(draw: Draw) -> Parts:
    teeth = 16 + 2 * draw.which(3)
    disc = [
        rod((0, 0.62, 0.95), (0, 0.68, 0.95), 0.78, rim=0.012),
        *(
            turned(
                [(r - 0.04, -0.05), (r, -0.05), (r, 0.05), (r - 0.04, 0.05)], (0, 0.65, 0.95), "y"
            )
            for r in (0.8, 0.52, 0.26)
        ),
    ]
    disc += moved(
        spun(
            [
                plate(
                    [(-0.05, 0.56), (0.05, 0.56), (0.035, 0.76), (-0.035, 0.76)],
                    0.1,
                    (0, 0, 0),
                    FRONT,
                )
            ],
            teeth,
            "y",
        ),
        (0, 0.65, 0.95),
    )
    glow = [
        rod((0, 0.6, 0.95), (0, 0.7, 0.95), 0.2),
        *moved(spun([ball((0.045, 0.05, 0.045), (0, 0, 0.4))], 8, "y"), (0, 0.63, 0.95)),
    ]
    base = [
        box((1.0, 1.9, 0.08), (0, 0.05, 0.2), 0.03),
        *both_sides(
            [
                pipe(
                    [
                        (0.5, -1.05, 0.26),
                        (0.52, -0.8, 0.06),
                        (0.52, 0.0, 0.04),
                        (0.52, 0.8, 0.06),
                        (0.5, 1.1, 0.26),
                    ],
                    0.045,
                ),
                *(rod((0.52, y, 0.06), (0.44, y, 0.2), 0.03) for y in (-0.6, 0.0, 0.6)),
            ]
        ),
    ]
    brass = (
        both_sides([rod((0.42, y, 0.22), (0.42, y, 0.62), 0.024) for y in (-0.8, -0.3)])
        + both_sides([capsule((0.42, -0.85, 0.62), (0.42, -0.25, 0.62), 0.03)])
        + [rod((-0.42, -0.84, 0.62), (0.42, -0.84, 0.62), 0.028)]
    )
    brass += [
        pipe([(x, 0.74, 0.2), (x, 0.88, 0.6), (x, 0.69, 0.92)], 0.035) for x in (-0.3, 0.3)
    ] + [box((0.5, 0.3, 0.5), (0, 0.7, 0.4), 0.03)]
    seat = [
        box((0.56, 0.52, 0.16), (0, -0.02, 0.52), 0.06),
        box((0.56, 0.16, 0.66), (0, 0.26, 0.84), 0.07),
        *both_sides([box((0.12, 0.5, 0.14), (0.3, 0.0, 0.7), 0.05)]),
        *(
            ball((0.035, 0.03, 0.035), (x, 0.18, z))
            for x in (-0.13, 0.0, 0.13)
            for z in (0.76, 0.92, 1.06)
        ),
    ]
    legs = [box((0.4, 0.4, 0.26), (0, 0.02, 0.34), 0.02)]
    panel = [
        box((0.56, 0.12, 0.3), (0, -0.82, 0.66), 0.03, (-24, 0, 0)),
        rod((0, -0.84, 0.22), (0, -0.82, 0.6), 0.05),
    ]
    dials = [rod((x, -0.82, 0.7), (x, -0.735, 0.73), 0.075) for x in (-0.16, 0.04)]
    lever = [
        rod((0.22, -0.78, 0.66), (0.26, -0.6, 1.02), 0.02),
        ball(0.055, (0.265, -0.58, 1.06)),
        ball(0.035, (0.42, -0.84, 0.66)),
        ball(0.035, (-0.42, -0.84, 0.66)),
    ]
    return {
        "frame": [*base, *brass, *panel],
        "disc": disc,
        "seat": seat,
        "wood": legs,
        "dials": dials,
        "glow": glow,
        "levers": lever,
    }


OLD_CRAFTS: dict[str, Callable[[Draw], Parts]] = {
    "spinning wheel": _spinning_wheel,
    "loom": _loom,
    "forge": _forge,
    "time machine": _time_machine,
}
