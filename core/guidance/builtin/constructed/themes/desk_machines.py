"""A typewriter and a sewing machine that the networks know and drew roughly."""

from collections.abc import Callable

import numpy as np

from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.shapes import (
    FRONT,
    SIDE,
    Parts,
    ball,
    both_sides,
    box,
    closed_curve,
    curve,
    pipe,
    placed,
    plate,
    rod,
    rounded,
    turned,
)


def _typewriter(draw: Draw) -> Parts:
    wide, rows = draw(0.6, 0.66), 4
    side = [
        (-0.5, 0.0),
        (0.5, 0.0),
        (0.52, 0.3),
        (0.3, 0.44),
        (0.06, 0.42),
        (-0.06, 0.3),
        (-0.5, 0.1),
    ]
    body = both_sides([plate(side, 0.1, (wide - 0.05, 0, 0), SIDE)])
    body += [
        plate([(-0.52, 0.0), (0.5, 0.0), (0.5, 0.08), (-0.52, 0.08)], 2 * wide, (0, 0, 0), SIDE)
    ]
    body += [
        plate(
            [(0.02, 0.06), (0.5, 0.06), (0.5, 0.3), (0.34, 0.4), (0.14, 0.4), (0.02, 0.28)],
            2 * wide - 0.1,
            (0, 0, 0),
            SIDE,
        )
    ]
    body += [
        plate(
            [(-0.5, 0.05), (0.04, 0.05), (0.04, 0.23), (-0.5, 0.08)],
            2 * wide - 0.12,
            (0, 0, 0),
            SIDE,
        )
    ]
    body += [
        rod((s * (wide - 0.1), y, 0.0), (s * (wide - 0.1), y, -0.05), 0.05, rim=0.01)
        for s in (-1, 1)
        for y in (-0.42, 0.42)
    ]
    fan = [
        rod((0.34 * np.sin(a), 0.06, 0.3), (0.16 * np.sin(a), 0.26, 0.42), 0.011)
        for a in np.linspace(-1.2, 1.2, 13)
    ]
    keys = []
    for row in range(rows):
        y, z = -0.43 + 0.12 * row, 0.14 + 0.045 * row
        count = 10 - row % 2
        for x in (np.arange(count) - (count - 1) / 2) * 0.108:
            keys += [
                rod((x, y, z), (x, y, z + 0.035), 0.042, rim=0.01),
                rod((x, y + 0.02, z - 0.12), (x, y, z + 0.01), 0.013),
            ]
    keys += [
        box((0.62, 0.06, 0.03), (0, -0.53, 0.13), 0.014),
        *both_sides([rod((0.25, -0.5, 0.06), (0.25, -0.53, 0.13), 0.014)]),
    ]
    roller = [rod((-wide + 0.02, 0.36, 0.5), (wide - 0.02, 0.36, 0.5), 0.1)]
    roller += [box((2 * wide - 0.04, 0.16, 0.08), (0, 0.4, 0.42), 0.01)]
    knobs = both_sides(
        [
            rod((wide - 0.03, 0.36, 0.5), (wide + 0.05, 0.36, 0.5), 0.03),
            rod((wide + 0.03, 0.36, 0.5), (wide + 0.11, 0.36, 0.5), 0.075, rim=0.014),
        ]
    )
    knobs += [
        pipe(
            [(-wide + 0.05, 0.34, 0.48), (-wide - 0.04, 0.16, 0.54), (-wide - 0.02, 0.02, 0.56)],
            (0.02, 0.018, 0.024),
        )
    ]
    knobs += [
        rod((-wide + 0.1, 0.27, 0.62), (wide - 0.1, 0.27, 0.62), 0.014),
        *both_sides(
            [
                rod((wide - 0.1, 0.27, 0.62), (wide - 0.1, 0.36, 0.5), 0.014),
                rod((0.2, 0.27, 0.62), (0.26, 0.27, 0.62), 0.026),
            ]
        ),
    ]
    spools = both_sides(
        [
            rod((0.36, 0.2, 0.38), (0.36, 0.2, 0.44), 0.12, rim=0.01),
            rod((0.36, 0.2, 0.43), (0.36, 0.2, 0.47), 0.03),
        ]
    )
    sheet = [(0.27, 0.5), (0.27, 0.56), (0.33, 0.62), (0.4, 0.62), (0.5, 0.74), (0.6, 0.95)]
    page = curve(sheet)
    paper = plate([*page, *(page + (0.02, -0.012))[::-1]], 0.72, (0, 0, 0), SIDE)
    return {
        "body": body,
        "keys": keys,
        "roller": roller,
        "knobs": [*knobs, *spools, *fan],
        "paper": [paper],
    }


def _sewing_machine(draw: Draw) -> Parts:
    high = draw(0.5, 0.58)
    arm = [
        (0.5, 0.0),
        (0.52, 0.3),
        (0.5, high),
        (0.42, high + 0.1),
        (0.1, high + 0.11),
        (-0.2, high + 0.08),
        (-0.42, high + 0.1),
        (-0.54, high + 0.04),
    ]
    arm += [
        (-0.56, high - 0.18),
        (-0.5, high - 0.24),
        (-0.42, high - 0.22),
        (-0.36, high - 0.1),
        (0.0, high - 0.06),
        (0.16, high - 0.1),
        (0.22, 0.3),
        (0.16, 0.06),
        (0.1, 0.0),
    ]
    outline = closed_curve(arm)
    mid = outline.mean(0)
    body = [
        plate(outline, 0.16, (0, 0, 0), FRONT),
        plate(mid + (outline - mid) * (0.96, 0.93), 0.21, (0, 0, 0), FRONT),
    ]
    body += [
        box((1.14, 0.36, 0.08), (-0.02, 0, -0.01), 0.02),
        rod((-0.46, 0, high - 0.2), (-0.46, 0, high - 0.28), 0.06, rim=0.01),
    ]
    base = [
        box((1.3, 0.56, 0.1), (0, 0, -0.1), 0.015),
        box((1.36, 0.62, 0.04), (0, 0, -0.16), 0.012),
    ]
    base += [ball(0.045, (s * 0.6, t * 0.24, -0.19)) for s in (-1, 1) for t in (-1, 1)]
    wheel = [
        rod((0.48, 0, high - 0.06), (0.58, 0, high - 0.06), 0.05),
        *placed(
            [turned([(0.12, -0.035), (0.2, -0.035), (0.2, 0.035), (0.12, 0.035)], axis="x")],
            np.eye(3),
            (0.6, 0, high - 0.06),
        ),
    ]
    wheel += [
        rod((0.56, 0, high - 0.06), (0.63, 0, high - 0.06), 0.06, rim=0.01),
        *(
            rod(
                (0.6, 0, high - 0.06),
                (0.6, 0.15 * np.cos(a), high - 0.06 + 0.15 * np.sin(a)),
                0.022,
            )
            for a in np.arange(5) * 2 * np.pi / 5
        ),
    ]
    wheel += [
        rod((0.6, 0.0, high + 0.08), (0.72, 0, high + 0.08), 0.02),
        ball(0.03, (0.72, 0, high + 0.08)),
    ]
    needle = [
        rod((-0.46, 0, high - 0.24), (-0.46, 0, 0.14), 0.022),
        rod((-0.46, 0, 0.16), (-0.46, 0, 0.02), 0.013),
        rod((-0.4, 0, high - 0.2), (-0.4, 0, 0.08), 0.018),
    ]
    needle += [
        box((0.06, 0.12, 0.02), (-0.42, -0.03, 0.07), 0.006),
        box((0.02, 0.02, 0.06), (-0.4, 0, 0.08)),
        box((0.24, 0.2, 0.02), (-0.44, 0, 0.035), 0.004),
    ]
    needle += [
        pipe(
            [(-0.3, -0.08, high - 0.02), (-0.3, -0.14, high - 0.04), (-0.34, -0.14, high - 0.1)],
            0.014,
        ),
        rod((-0.3, -0.05, high), (-0.3, -0.13, high), 0.045, rim=0.01),
    ]
    top = high + 0.1
    spool = [
        turned(
            [
                (0, top),
                (0.07, top),
                (0.07, top + 0.02),
                (0.055, top + 0.03),
                (0.058, top + 0.15),
                (0.07, top + 0.16),
                (0.07, top + 0.18),
                (0, top + 0.18),
            ],
            (0.24, 0, 0),
        )
    ]
    spool += [
        rod((0.24, 0, top + 0.16), (0.24, 0, top + 0.23), 0.016),
        rod((0.2, -0.03, top + 0.1), (-0.3, -0.11, high), 0.0085),
    ]
    band = [plate(rounded((0.34, 0.1), 0.03), 0.22, (0.1, 0, high + 0.02), FRONT)]
    band += [plate(rounded((0.05, 0.2), 0.02), 0.22, (0.36, 0, 0.24), FRONT)]
    return {
        "body": body,
        "base": base,
        "wheel": wheel,
        "needle": needle,
        "spool": spool,
        "band": band,
    }


DESK_MACHINES: dict[str, Callable[[Draw], Parts]] = {
    "typewriter": _typewriter,
    "sewing machine": _sewing_machine,
}
