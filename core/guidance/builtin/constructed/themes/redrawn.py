"""Things that the networks know and drew badly: what is thin, long and much repeated."""

import itertools
from collections.abc import Callable

import numpy as np

from core.geometry.parts.primitives import Primitive
from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.shapes import (
    FRONT,
    RIGHTWARD,
    Parts,
    ball,
    both_sides,
    box,
    capsule,
    closed_curve,
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


def _spiral_staircase(draw: Draw) -> Parts:
    count, turn, high, reach = 13 + draw.which(4), draw(0.95, 1.15) * 2 * np.pi, 1.9, 0.62
    step = turn / count
    wide = [(reach * np.cos(a), reach * np.sin(a)) for a in (-0.62 * step, 0.0, 0.62 * step)]
    wedge = [(0.05, -0.09), *wide, (0.05, 0.09)]
    treads, posts, rail = [], [], []
    for k in range(count):
        angle, z = step * k, high * (k + 1) / count
        c, s = np.cos(angle), np.sin(angle)
        frame = np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
        treads.append(plate(wedge, 0.05, (0, 0, z), frame))
        at = (0.93 * reach * c, 0.93 * reach * s)
        posts.append(rod((*at, z), (*at, z + 0.52), 0.012))
        rail.append((*at, z + 0.52))
    return {
        "treads": treads,
        "pole": [
            rod((0, 0, 0), (0, 0, high + 0.6), 0.06),
            ball(0.075, (0, 0, high + 0.62)),
            rod((0, 0, -0.02), (0, 0, 0.05), 0.2, 0.16),
        ],
        "posts": posts,
        "rail": [pipe(rail, 0.022)],
    }


def _satellite_dish(draw: Draw) -> Parts:
    wide, deep, tilt = 0.75, draw(0.2, 0.26), np.radians(draw(35, 50))
    radii = np.linspace(0, 1, 9)
    inner = [(wide * r, deep * r * r) for r in radii]
    outer = [(wide * r + 0.012 * bool(r), deep * r * r - 0.045) for r in radii]
    c, s = np.cos(tilt), np.sin(tilt)
    frame = np.array([[1.0, 0.0, 0.0], [0.0, c, -s], [0.0, s, c]])
    focus, around = (0.0, 0.0, 0.62), np.pi * np.array([3, 7, 11]) / 6
    ends = [(0.68 * np.cos(a), 0.68 * np.sin(a), 0.8 * deep) for a in around]
    head = [rod((0, 0, 0.5), (0, 0, 0.7), 0.07, 0.05, 0.01), ball((0.05, 0.05, 0.04), (0, 0, 0.49))]
    corners = [(a, 0.06 + b) for a in (-0.19, 0.19) for b in (-0.19, 0.19)]

    def aimed(solids: list[Primitive]) -> list[Primitive]:
        """Its axis is z until here."""
        return placed(solids, frame, (0.0, -0.06, 0.95))

    return {
        "dish": aimed([turned([*outer, *inner[::-1]])]),
        "rim": aimed([ring(wide, 0.03, (0, 0, deep - 0.01))]),
        "receiver": aimed(head),
        "arms": aimed([rod(end, focus, 0.016) for end in ends]),
        "mast": [
            *aimed([rod((0, 0, -0.2), (0, 0, -0.02), 0.12, 0.16)]),
            rod((0, 0.06, 0.08), (0, 0.06, 0.86), 0.075, 0.06),
            ball(0.11, (0, 0.06, 0.83)),
        ],
        "foot": [
            box((0.5, 0.5, 0.08), (0, 0.06, 0.05), 0.015),
            *(rod((*one, 0.08), (*one, 0.11), 0.025) for one in corners),
        ],
    }


def _saw(draw: Draw) -> Parts:
    teeth, long = 16 + draw.which(5), 1.0
    places = np.linspace(long, 0.02, 2 * teeth + 1)
    edge = np.stack([places, np.interp(places, [0, long], [-0.2, -0.13])], 1)
    edge[1::2, 1] -= 0.03
    blade = [(-0.06, 0.13), (long, 0.0), (long, -0.09), *edge.tolist(), (-0.06, -0.19)]
    outside = [(-0.02, 0.16), (-0.02, -0.2), (-0.14, -0.24), (-0.32, -0.19), (-0.42, -0.22)]
    outside += [(-0.4, -0.08), (-0.33, 0.0), (-0.36, 0.16), (-0.24, 0.19)]
    hole = [(-0.12, 0.08), (-0.12, -0.12), (-0.2, -0.15), (-0.28, -0.09), (-0.25, 0.02)]
    hole = closed_curve([*hole, (-0.24, 0.1), (-0.18, 0.12)])
    return {
        "blade": [plate(blade, 0.018, (0, 0, 0), FRONT)],
        "handle": [plate(closed_curve(outside), 0.08, (0, 0, 0), FRONT, [hole])],
        "rivets": [rod((-0.06, -0.05, z), (-0.06, 0.05, z), 0.022) for z in (-0.13, 0.0, 0.1)],
    }


def _shopping_cart(draw: Draw) -> Parts:
    low, high, columns = 0.5, 0.95, 8 + draw.which(3)
    # Of the basket below and above: half its width and its end, behind and in front.
    below, above = np.array([0.3, 0.42, 0.22, -0.5]), np.array([0.36, 0.5, 0.27, -0.66])

    def at(side: float, along: float, up: float) -> tuple[float, float, float]:
        x, y, u, v = (below + up * (above - below)).tolist()
        return (side * (x + along * (u - x)), y + along * (v - y), low + up * (high - low))

    wires, across = [], np.linspace(-0.75, 0.75, 5)
    for side in (-1, 1):
        wires += [rod(at(side, t, 0), at(side, t, 1), 0.009) for t in np.linspace(0, 1, columns)]
    for t in (0, 1):
        wires += [rod(at(s, t, 0), at(s, t, 1), 0.009) for s in across]
    wires += [rod(at(s, 0, 0), at(s, 1, 0), 0.009) for s in across]
    wires += [rod(at(-1, t, 0), at(1, t, 0), 0.009) for t in np.linspace(0, 1, 8)]
    for up, radius in ((0.0, 0.014), (0.33, 0.009), (0.66, 0.009), (1.0, 0.018)):
        corners = [at(-1, 0, up), at(1, 0, up), at(1, 1, up), at(-1, 1, up)]
        wires += [rod(a, b, radius) for a, b in itertools.pairwise([*corners, corners[0]])]
        wires += [ball(radius, corner) for corner in corners]
    side = [at(1, 0, 1.0), (0.33, 0.46, 0.6), (0.32, 0.4, 0.22), (0.3, 0.1, 0.16)]
    frame = [
        pipe([*side, (0.22, -0.55, 0.16)], 0.02),
        rod((0.29, 0.0, 0.17), (0.24, -0.2, low), 0.016),
        rod(at(1, 0, 1), (0.33, 0.62, 1.06), 0.018),
    ]
    wheels = []
    for x, y in ((0.3, 0.4), (0.22, -0.5)):
        frame.append(rod((x, y, 0.05), (x, y, 0.22), 0.016))
        wheels.append(rod((x - 0.022, y, 0.07), (x + 0.022, y, 0.07), 0.07, rim=0.015))
    spans = [rod((-x, y, 0.16), (x, y, 0.16), 0.014) for x, y in ((0.29, 0.1), (0.25, -0.3))]
    return {
        "basket": wires,
        "frame": [*both_sides(frame), *spans],
        "handle": [capsule((-0.33, 0.62, 1.06), (0.33, 0.62, 1.06), 0.032)],
        "wheels": both_sides(wheels),
        "flap": [box((0.5, 0.02, 0.2), (0, 0.455, 0.78), 0.006, (8, 0, 0))],
    }


def _truss(length: float, wide: float, cells: int) -> list[Primitive]:
    """A square lattice along z."""
    half = wide / 2
    found = spun([rod((half, half, 0), (half, half, length), 0.02)], 4)
    for k, (a, b) in enumerate(itertools.pairwise(np.linspace(0, length, cells + 1))):
        side = half if k % 2 else -half
        slope = rod((-side, half, a), (side, half, b), 0.012)
        found += spun([slope, rod((-half, half, b), (half, half, b), 0.012)], 4)
    return found


def _crane(draw: Draw) -> Parts:
    high, reach, back = 2.0, draw(1.35, 1.6), 0.62
    boom = placed(_truss(reach + back, 0.16, 11), RIGHTWARD, (-back, 0, high + 0.1))
    peak = (0.0, 0.0, high + 0.62)
    feet = [(0.08 * s, 0.08 * t, high + 0.05) for s in (-1, 1) for t in (-1, 1)]
    at, end = 0.62 * reach, high - draw(0.7, 1.0)
    curved = [(0, 0), (0, -0.08), (0.06, -0.15), (0, -0.2), (-0.06, -0.14)]
    return {
        "mast": [*_truss(high, 0.22, 9), box((0.28, 0.28, 0.1), (0, 0, high), 0.01)],
        "jib": [*boom, *(rod(foot, peak, 0.018) for foot in feet), ball(0.03, peak)],
        "ties": [rod(peak, (x, 0, high + 0.18), 0.011) for x in (0.75 * reach, 0.05 - back)],
        "cab": [box((0.2, 0.2, 0.26), (0.12, -0.17, high - 0.03), 0.02)],
        "weights": [
            box((0.22, 0.24, 0.3), (-back + 0.12, 0, high - 0.02), 0.015),
            box((0.66, 0.66, 0.12), (0, 0, -0.02), 0.02),
        ],
        "hook": [
            box((0.14, 0.14, 0.06), (at, 0, high + 0.01), 0.01),
            rod((at, 0, high), (at, 0, end), 0.012),
            box((0.07, 0.06, 0.12), (at, 0, end + 0.02), 0.015),
            pipe([(at + x, 0, end + z) for x, z in curved], (0.018, 0.02, 0.022, 0.02, 0.01)),
        ],
    }


REDRAWN: dict[str, Callable[[Draw], Parts]] = {
    "wind turbine": _wind_turbine,
    "violin": _violin,
    "harp": _harp,
    "gate": _gate,
    "bicycle": _bicycle,
    "spiral staircase": _spiral_staircase,
    "satellite dish": _satellite_dish,
    "saw": _saw,
    "shopping cart": _shopping_cart,
    "crane": _crane,
}
