"""Things of the bath."""

from collections.abc import Callable

import numpy as np

from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.shapes import (
    Parts,
    ball,
    box,
    capsule,
    moved,
    pipe,
    plate,
    rod,
    rounded,
    spun,
)


def _shower(draw: Draw) -> Parts:
    high = draw(1.9, 2.05)
    tray = [
        box((1.0, 1.0, 0.1), (0, 0, 0.05), 0.03),
        rod((0, 0, 0.09), (0, 0, 0.112), 0.06, rim=0.004),
    ]
    walls = [
        box((1.0, 0.04, high), (0, 0.48, high / 2), 0.004),
        box((0.04, 1.0, high), (-0.48, 0, high / 2), 0.004),
    ]
    walls += [
        box((0.012, 0.05, high - 0.1), (x, 0.472, high / 2), 0.0) for x in np.linspace(-0.3, 0.3, 4)
    ]
    walls += [box((1.0, 0.05, 0.012), (0, 0.472, z), 0.0) for z in np.arange(0.3, high - 0.1, 0.24)]
    glass = [
        box((0.02, 0.98, high - 0.14), (0.48, 0, high / 2), 0.004),
        box((0.44, 0.02, high - 0.14), (-0.25, -0.48, high / 2), 0.004),
    ]
    metal = [
        box((0.035, 0.035, high), (x, y, high / 2), 0.006)
        for x, y in ((0.48, -0.48), (0.48, 0.48), (-0.48, -0.48))
    ]
    metal += [
        box((0.035, 1.0, 0.035), (0.48, 0, high - 0.05), 0.006),
        box((1.0, 0.035, 0.035), (0, -0.48, high - 0.05), 0.006),
        box((0.02, 0.03, high - 0.1), (-0.03, -0.48, high / 2)),
    ]
    pole = [
        pipe(
            [
                (-0.1, 0.42, 0.95),
                (-0.1, 0.42, high - 0.35),
                (-0.1, 0.4, high - 0.12),
                (-0.1, 0.18, high - 0.06),
                (-0.1, 0.12, high - 0.1),
            ],
            0.022,
        ),
        rod((-0.1, 0.12, high - 0.08), (-0.1, 0.12, high - 0.13), 0.05, 0.16, 0.008),
        rod((-0.1, 0.12, high - 0.12), (-0.1, 0.12, high - 0.15), 0.165, rim=0.008),
    ]
    pole += [
        box((0.3, 0.08, 0.08), (-0.1, 0.43, 0.98), 0.02),
        *(
            rod((-0.1 + s * 0.14, 0.4, 0.98), (-0.1 + s * 0.2, 0.4, 0.98), 0.045, rim=0.01)
            for s in (-1, 1)
        ),
        rod((-0.1, 0.48, high - 0.4), (-0.1, 0.4, high - 0.4), 0.024),
    ]
    drops = [
        capsule(
            (-0.1 + x, 0.12 + y, high - 0.14),
            (-0.1 + 1.3 * x, 0.12 + 1.3 * y, high - 0.14 - d),
            0.0125,
        )
        for x, y, d in (
            (-0.1, 0, 0.5),
            (0.1, 0, 0.62),
            (0, 0.1, 0.4),
            (0, -0.1, 0.56),
            (0.07, 0.07, 0.7),
            (-0.07, -0.07, 0.66),
            (-0.07, 0.07, 0.46),
            (0.07, -0.07, 0.4),
            (0, 0, 0.74),
        )
    ]
    return {
        "tray": tray,
        "walls": walls,
        "glass": glass,
        "frame": metal,
        "fittings": pole,
        "water": drops,
    }


def _soap(draw: Draw) -> Parts:
    bar = [box((0.9, 0.56, 0.26), (0, 0, 0.25), 0.12), box((0.76, 0.42, 0.3), (0, 0, 0.25), 0.13)]
    letters = [plate(rounded((0.5, 0.2), 0.1), 0.02, (0, 0, 0.405))]
    dish = [
        box((1.2, 0.8, 0.08), (0, 0, 0.04), 0.036),
        *(box((0.9, 0.04, 0.06), (0, y, 0.1), 0.016) for y in (-0.2, -0.07, 0.07, 0.2)),
    ]
    dish += [
        pipe(
            [(-0.54, -0.34, 0.08), (0.54, -0.34, 0.08), (0.54, 0.34, 0.08), (-0.54, 0.34, 0.08)],
            0.05,
            closed=True,
        )
    ]
    rng = np.random.default_rng(draw.which(1000))
    bubbles = []
    for _ in range(16):
        x, y = rng.uniform(-0.4, 0.4), rng.uniform(-0.22, 0.22)
        r = float(rng.uniform(0.03, 0.085))
        if abs(x) > 0.2 or abs(y) > 0.14:
            bubbles.append(ball(r, (1.05 * x, 1.15 * y, 0.34)))
    bubbles += [
        ball(0.1, (0.36, 0.16, 0.4)),
        ball(0.07, (0.28, 0.22, 0.44)),
        ball(0.06, (-0.36, -0.2, 0.36)),
    ]
    return {"bar": bar, "stamp": letters, "bubbles": bubbles, "dish": dish}


def _sponge(draw: Draw) -> Parts:
    body = [box((0.9, 0.56, 0.26), (0, 0, 0.15), 0.04)]
    scour = [box((0.902, 0.562, 0.08), (0, 0, 0.31), 0.03)]
    rng = np.random.default_rng(draw.which(1000))
    holes = []
    for _ in range(52):
        r = float(rng.uniform(0.014, 0.036))
        side = rng.integers(4)
        a, z = rng.uniform(-0.92, 0.92), float(rng.uniform(0.05, 0.25))
        x, y = ((0.448 * a, -0.276), (0.448 * a, 0.276), (-0.446, 0.27 * a), (0.446, 0.27 * a))[
            side
        ]
        holes.append(
            ball(
                (r if side < 2 else 0.0125, 0.0125 if side < 2 else r, r),
                (x * (0.96 if side < 2 else 1), y * (1 if side < 2 else 0.94), z),
            )
        )
    return {"body": body, "scourer": scour, "pores": holes}


def _toothpaste(draw: Draw) -> Parts:
    long = draw(0.95, 1.1)
    tube = []
    for k in range(9):
        f = k / 8
        tube.append(
            plate(
                rounded((0.42, 0.2), 0.1) * (1, 1 - 0.78 * (1 - f) ** 1.4),
                long / 8 + 0.004,
                (0, 0, 0.06 + long * f),
            )
        )
    tube += [
        box((0.44, 0.04, 0.1), (0, 0, -0.02), 0.008),
        rod((0, 0, 0.05 + long), (0, 0, 0.17 + long), 0.16, 0.08),
    ]
    stripe = [box((0.3, 0.05, 0.34), (0, -0.07, 0.62 * long), 0.02)]
    cap = [
        rod((0, 0, 0.14 + long), (0, 0, 0.36 + long), 0.1, 0.085, 0.015),
        *moved(spun([box((0.02, 0.02, 0.18), (0, -0.093, 0.25 + long), 0.004)], 14), (0, 0, 0)),
    ]
    smile = [
        pipe(
            [(-0.12, -0.1, 0.66 * long), (0, -0.103, 0.6 * long), (0.12, -0.1, 0.66 * long)], 0.02
        ),
        ball((0.05, 0.012, 0.05), (0, -0.096, 0.7 * long)),
    ]
    return {"tube": tube, "label": stripe, "emblem": smile, "cap": cap}


def _razor(draw: Draw) -> Parts:
    long = draw(0.9, 1.0)
    grip = [
        pipe(
            [(0, 0.02, -long), (0, -0.03, -0.6), (0, 0.0, -0.2), (0, 0.0, 0.02)],
            (0.06, 0.075, 0.05, 0.036),
        )
    ]
    rubber = [
        capsule((0, -0.075, -0.78 + 0.07 * k), (0, -0.075, -0.76 + 0.07 * k), 0.03)
        for k in range(6)
    ]
    head = [
        box((0.62, 0.16, 0.13), (0, -0.05, 0.08), 0.03, (25, 0, 0)),
        box((0.16, 0.12, 0.1), (0, 0.0, 0.02), 0.03),
    ]
    blades = [
        box((0.52, 0.02, 0.03), (0, -0.105 - 0.012 * k, 0.05 + 0.03 * k), 0.004, (25, 0, 0))
        for k in range(4)
    ]
    strip = [box((0.54, 0.04, 0.04), (0, -0.115, 0.135), 0.01, (25, 0, 0))]
    return {"handle": grip, "grip": rubber, "head": head, "blades": blades, "strip": strip}


BATH: dict[str, Callable[[Draw], Parts]] = {
    "shower": _shower,
    "soap": _soap,
    "sponge": _sponge,
    "toothpaste": _toothpaste,
    "razor": _razor,
}
