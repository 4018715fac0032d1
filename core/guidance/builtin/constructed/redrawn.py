"""Things that the networks know and drew badly: what is thin, long and much repeated."""

from collections.abc import Callable

import numpy as np

from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.shapes import (
    FRONT,
    Parts,
    ball,
    both_sides,
    box,
    capsule,
    closed_curve,
    moved,
    pipe,
    plate,
    ring,
    rod,
    rounded,
    spun,
    turned,
)


def _wind_turbine(draw: Draw) -> Parts:
    long, high = draw(0.95, 1.15), 1.7
    blade = [(-0.04, 0.0), (0.04, 0.0), (0.085, 0.18), (0.07, 0.3), (0.022, 1.0), (-0.022, 1.0)]
    outline = np.array([*blade, (-0.05, 0.3)]) * (1.0, long)
    tip = np.array([(-0.034, 0.8), (0.042, 0.8), (0.026, 0.95), (-0.027, 0.95)]) * (1.0, long)
    blades = spun([plate(outline, 0.035, (0, 0, 0), FRONT)], 3, "y")
    bands = spun([plate(tip, 0.042, (0, 0, 0), FRONT)], 3, "y")
    middle = (0.0, -0.2, high)
    return {
        "tower": [rod((0, 0, 0), (0, 0, high), 0.1, 0.055)],
        "blades": moved(blades, middle),
        "hub": [ball((0.085, 0.12, 0.085), middle)],
        "nacelle": [box((0.16, 0.42, 0.17), (0, 0.02, high), 0.05)],
        "bands": moved(bands, middle),
        "base": [rod((0, 0, -0.04), (0, 0, 0.06), 0.26, 0.22, 0.02)],
    }


def _violin(draw: Draw) -> Parts:
    half = [(0.2, -0.47), (0.29, -0.32), (0.25, -0.14), (0.155, -0.02), (0.175, 0.11)]
    half += [(0.235, 0.22), (0.21, 0.36), (0.1, 0.45)]
    outline = closed_curve([(0, -0.5), *half, (0, 0.46), *((-x, z) for x, z in half[::-1])])
    inner, deep = 0.93 * outline, draw(0.12, 0.15)
    body = [plate(outline, 0.03, (0, y, 0), FRONT) for y in (-deep / 2, deep / 2)]
    front = -deep / 2
    high, low = front - 0.08, front - 0.05
    strings = []
    for x in (-0.045, -0.015, 0.015, 0.045):
        strings.append(rod((x, high, -0.07), (0.55 * x, front - 0.045, 0.92), 0.0055))
        strings.append(rod((x, high, -0.07), (0.8 * x, low, -0.24), 0.0055))
    bridge = [(-0.075, 0.0), (0.075, 0.0), (0.055, 0.075), (0.0, 0.085), (-0.055, 0.075)]
    upright = np.array([[1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, -1.0]])
    heights = enumerate((0.985, 1.03, 1.075, 1.12))
    pegs = [
        capsule((0.0, front, z), (0.09 * (-1) ** k, front, z), 0.012, 0.018) for k, z in heights
    ]
    scroll = [(1.1, 0.0), (1.2, 0.02), (1.24, -0.05), (1.18, -0.08)]
    neck = [
        box((0.085, 0.05, 0.62), (0, front - 0.005, 0.68), 0.02),
        box((0.075, 0.02, 0.72), (0, front - 0.035, 0.56), 0.006),
        box((0.075, 0.06, 0.24), (0, front, 1.05), 0.015),
        pipe([(0, front + y, z) for z, y in scroll], (0.035, 0.035, 0.03, 0.022)),
        ball((0.05, 0.03, 0.03), (0, front - 0.03, 1.2)),
    ]
    tail = closed_curve([(-0.045, 0), (0.045, 0), (0.03, -0.23), (-0.03, -0.23)])
    chin = [
        plate(tail, 0.02, (0, low, -0.22), FRONT),
        rod((0, low, -0.43), (0, front + 0.04, -0.5), 0.014),
        ball((0.13, 0.03, 0.09), (-0.15, front - 0.02, -0.4)),
    ]
    return {
        "body": [*body, plate(inner, deep, (0, 0, 0), FRONT)],
        "neck": neck,
        "bridge": [plate(bridge, 0.02, (0, front - 0.005, -0.07), upright), *strings],
        "pegs": pegs,
        "chinrest": chin,
    }


def _harp(draw: Draw) -> Parts:
    count = 13 + draw.which(5)
    low, high = np.array([-0.34, 0.0, -0.74]), np.array([0.52, 0.0, 0.5])
    neck = np.array(
        [(-0.42, 0.7), (-0.26, 0.6), (-0.02, 0.56), (0.2, 0.66), (0.42, 0.7), (0.53, 0.52)]
    )
    x = np.linspace(-0.33, 0.42, count)
    top = np.interp(x, neck[:5, 0], neck[:5, 1])
    foot = np.interp(x, [low[0], high[0]], [low[2], high[2]])
    strings = [rod((a, 0, b), (a, 0, c), 0.007) for a, b, c in zip(x, foot, top, strict=True)]
    pins = [ball(0.014, (a, -0.05, b)) for a, b in zip(x, top, strict=True)]
    column = [(0, -0.75), (0.05, -0.75), (0.04, -0.6), (0.032, -0.5), (0.032, 0.45), (0.045, 0.55)]
    crown = [(0, 0), (0.06, 0), (0.05, 0.06), (0.085, 0.12), (0.075, 0.17), (0.03, 0.2), (0, 0.2)]
    return {
        "body": [rod(tuple(low), tuple(high), 0.14, 0.06, 0.02)],
        "neck": [pipe([(a, 0, c) for a, c in neck], (0.05, 0.055, 0.05, 0.055, 0.05, 0.06))],
        "pillar": [turned([*column, (0.055, 0.72), (0, 0.72)], (-0.43, 0, 0)), *pins],
        "strings": strings,
        "base": [
            box((0.42, 0.36, 0.1), (-0.36, 0, -0.82), 0.03),
            *(ball(0.05, (-0.36 + a, b, -0.88)) for a in (-0.16, 0.16) for b in (-0.13, 0.13)),
        ],
        "crown": [turned(crown, (-0.43, 0, 0.7))],
    }


def _gate(draw: Draw) -> Parts:
    count, wide, high = 7 + draw.which(3), draw(0.72, 0.8), 0.95
    piers = box((0.26, 0.26, 1.14), (wide + 0.12, 0, 0.57), 0.012)
    caps = [
        box((0.36, 0.36, 0.07), (wide + 0.12, 0, 1.16), 0.015),
        ball(0.12, (wide + 0.12, 0, 1.28)),
    ]

    def arch(x: float) -> float:
        return high + 0.16 * np.sqrt(max(1 - (x / wide) ** 2, 0.0))

    places = np.linspace(0.03, wide - 0.05, count)
    gap = float(places[1] - places[0])
    bars, tips, rings = [], [], []
    for x in places:
        bars.append(rod((x, 0, 0.05), (x, 0, arch(x)), 0.017))
        tips.append(rod((x, 0, arch(x) - 0.01), (x, 0, arch(x) + 0.1), 0.03, 0.0))
        tips.append(ball(0.026, (x, 0, arch(x))))
    for x in places[:-1] + gap / 2:
        rings.append(ring(0.42 * gap, 0.012, (x, 0, 0.64), "y"))
        for side in (-1, 1):
            ends = [(x, 0, 0.64 + side * by) for by in (0.4 * gap, 0.14)]
            rings.append(rod(*ends, 0.01))
    rails = [box((wide + 0.02, 0.036, 0.036), (wide / 2 + 0.01, 0, z)) for z in (0.12, 0.5, 0.78)]
    upper = [(x, 0, arch(x) - 0.06) for x in np.linspace(0.0, wide, 9)]
    return {
        "bars": both_sides([*bars, *rails, *rings, pipe(upper, 0.016)]),
        "tips": both_sides(tips),
        "piers": both_sides([piers]),
        "caps": both_sides(caps),
    }


def _bicycle(draw: Draw) -> Parts:
    radius, base = 0.34, 0.52
    spokes = 14 + 2 * draw.which(3)
    wheels, metal = [], []
    for y in (-base, base):
        tyre = ring(radius - 0.03, 0.03, (0, y, radius), "x")
        each = spun([rod((0, 0, 0.02), (0, 0, radius - 0.05), 0.006)], spokes, "x")
        wheels.append(tyre)
        metal += [*moved(each, (0, y, radius)), ring(radius - 0.058, 0.013, (0, y, radius), "x")]
        metal.append(rod((-0.075, y, radius), (0.075, y, radius), 0.024))
    crank, saddle, head = (0.0, 0.06, 0.3), (0.0, 0.2, 0.76), (0.0, -0.32, 0.82)
    tubes = [
        rod(crank, saddle, 0.022),
        rod((0, 0.175, 0.69), head, 0.022),
        rod(crank, (0, -0.345, 0.7), 0.026),
        rod((0, -0.305, 0.88), (0, -0.36, 0.64), 0.028),
    ]
    stays = [
        rod((0.02, 0.06, 0.3), (0.055, base, radius), 0.014),
        rod((0.02, 0.18, 0.7), (0.055, base, radius), 0.013),
        pipe([(0.03, -0.36, 0.66), (0.055, -0.41, 0.55), (0.055, -base, radius)], 0.016),
    ]
    fork = box((0.13, 0.06, 0.05), (0, -0.36, 0.66), 0.015)
    bar = [(0.29, -0.16, 0.95), (0.24, -0.26, 0.97), (0.1, -0.3, 0.95), (0, -0.3, 0.94)]
    stem = rod((0, -0.305, 0.86), (0, -0.3, 0.95), 0.02)
    grips = capsule((0.3, -0.14, 0.948), (0.265, -0.22, 0.963), 0.026)
    pedal = [
        rod((0.05, 0.06, 0.3), (0.09, 0.06, 0.3), 0.02),
        rod((0.085, 0.06, 0.3), (0.085, -0.07, 0.22), 0.014),
        box((0.11, 0.07, 0.03), (0.14, -0.075, 0.215), 0.01),
    ]
    other = [
        rod((0.03, 0.06, 0.3), (-0.09, 0.06, 0.3), 0.02),
        rod((-0.085, 0.06, 0.3), (-0.085, 0.19, 0.38), 0.014),
        box((0.11, 0.07, 0.03), (-0.14, 0.195, 0.385), 0.01),
    ]
    chain = [(0.05, 0.06, 0.385), (0.05, -0.025, 0.3), (0.05, 0.06, 0.215), (0.05, 0.3, 0.25)]
    chain += [
        (0.05, base, 0.29),
        (0.05, base + 0.05, radius),
        (0.05, base, 0.39),
        (0.05, 0.3, 0.395),
    ]
    gears = [
        ring(0.085, 0.012, (0.05, 0.06, 0.3), "x"),
        rod((0.02, 0.06, 0.3), (0.055, 0.06, 0.3), 0.045),
    ]
    gears += [
        rod((0.03, base, radius), (0.06, base, radius), 0.05),
        pipe(chain, 0.009, closed=True),
    ]
    seat = [
        plate(rounded((0.05, 0.14), 0.024, (0, -0.1)), 0.05, (0, 0.21, 0.82)),
        ball((0.095, 0.09, 0.035), (0, 0.26, 0.825)),
        rod((0, 0.19, 0.72), (0, 0.22, 0.81), 0.014),
    ]
    return {
        "frame": [*tubes, *both_sides(stays), fork],
        "wheels": wheels,
        "seat": seat,
        "handlebar": [*both_sides([pipe(bar, 0.016), grips]), stem],
        "pedals": [*metal, *pedal, *other, *gears],
    }


REDRAWN: dict[str, Callable[[Draw], Parts]] = {
    "wind turbine": _wind_turbine,
    "violin": _violin,
    "harp": _harp,
    "gate": _gate,
    "bicycle": _bicycle,
}
