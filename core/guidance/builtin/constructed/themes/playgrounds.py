"""Things of a fairground and a playground, and a hot tub."""

from collections.abc import Callable

import numpy as np
from scipy.interpolate import CubicSpline

from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.pieces import SQUARE
from core.guidance.builtin.constructed.shapes import (
    SIDE,
    Parts,
    ball,
    both_sides,
    box,
    capsule,
    pipe,
    placed,
    plate,
    ring,
    rod,
    spun,
    turned,
)


def _roller_coaster(draw: Draw) -> Parts:
    rise = draw(0.95, 1.15)
    way = [
        (-0.9, -0.55, 0.25),
        (-1.25, 0.0, 0.3),
        (-1.0, 0.5, 0.55),
        (-0.4, 0.62, rise),
        (0.2, 0.6, 0.95 * rise),
    ]
    way += [
        (0.7, 0.55, 0.3),
        (1.15, 0.3, 0.35),
        (1.2, -0.2, 0.62),
        (0.85, -0.5, 0.4),
        (0.5, -0.55, 0.22),
    ]
    loop = [
        (0.12 - 0.34 * np.sin(a), -0.55 + 0.06 * a / np.pi, 0.56 - 0.36 * np.cos(a))
        for a in np.linspace(0.25, 2 * np.pi - 0.25, 9)
    ]
    way += [*loop, (-0.35, -0.46, 0.22)]
    points = np.array([*way, way[0]])
    steps = np.cumsum([0, *np.linalg.norm(np.diff(points, axis=0), axis=1)])
    curve = CubicSpline(steps, points, bc_type="periodic")
    t = np.linspace(0, steps[-1], 131)[:-1]
    at, along = curve(t), curve(t, 1)
    along /= np.linalg.norm(along, axis=1, keepdims=True)
    up = np.tile([0.0, 0.0, 1.0], (len(t), 1))
    first, last = steps[10], steps[18]
    turn = (t > first - 0.02) & (t < last + 0.02)
    center = np.array([0.12, -0.52, 0.56])
    up[turn] = center - at[turn]
    across = np.cross(along, up)
    across /= np.linalg.norm(across, axis=1, keepdims=True)
    rails = [pipe(at + s * 0.055 * across, 0.02, closed=True) for s in (-1, 1)]
    spine = pipe(at - 0.06 * np.cross(across, along), 0.028, closed=True)
    ties = [
        rod(tuple(at[k] - 0.07 * across[k]), tuple(at[k] + 0.07 * across[k]), 0.014)
        for k in range(0, len(t), 2)
    ]
    ties += [
        rod(tuple(at[k]), tuple(at[k] - 0.065 * np.cross(across[k], along[k])), 0.014)
        for k in range(0, len(t), 2)
    ]
    legs = []
    for k in range(0, len(t), 6):
        if turn[k]:
            continue
        foot = at[k] - (0, 0, 0.06)
        legs.append(rod(tuple(foot), (*foot[:2], 0.0), 0.022))
        if foot[2] > 0.45:
            side = across[k] * (1, 1, 0)
            legs += [
                rod(tuple(foot), (*(foot + s * 0.42 * foot[2] * side)[:2], 0.0), 0.018)
                for s in (-1, 1)
            ]
    legs += [
        rod((0.12, y, 0.02), (0.12, -0.52 + 0.3 * (y + 0.52), 0.96), 0.024) for y in (-0.78, -0.26)
    ]
    legs += [rod((0.12, -0.62, 0.94), (0.12, -0.42, 0.94), 0.024)]
    cars, seats, wheels = [], [], []
    for j, k in enumerate((35, 39, 43)):
        frame = np.stack([across[k], along[k], np.cross(across[k], along[k])], 1)
        shell = [
            (-0.13, 0.03),
            (0.12, 0.03),
            (0.17, 0.08),
            (0.16, 0.2),
            (0.08, 0.16),
            (-0.08, 0.15),
            (-0.13, 0.22),
        ]
        own = [plate(shell, 0.19, (0, 0, 0), SIDE)]
        if j == 2:
            own.append(ball((0.09, 0.1, 0.06), (0, 0.16, 0.1)))
        cars += placed(own, frame, at[k])
        seats += placed(
            [
                box((0.15, 0.06, 0.2), (0, -0.08, 0.17), 0.02),
                box((0.15, 0.12, 0.03), (0, 0.0, 0.165), 0.01),
            ],
            frame,
            at[k],
        )
        wheels += placed(
            both_sides(
                [rod((0.035, y, 0.01), (0.085, y, 0.01), 0.04, rim=0.006) for y in (-0.09, 0.1)]
            ),
            frame,
            at[k],
        )
    base = [box((3.0, 1.7, 0.06), (0, 0, -0.02), 0.02)]
    return {
        "rails": [*rails, spine],
        "ties": [*ties, *wheels],
        "supports": legs,
        "cars": cars,
        "seats": seats,
        "ground": base,
    }


def _playground(draw: Draw) -> Parts:
    posts, deck, roof, slide, climb, seats = [], [], [], [], [], []
    for x in (-0.28, 0.28):
        for y in (-0.28, 0.28):
            posts.append(rod((x, y, 0), (x, y, 1.3), 0.035))
    deck += [box((0.62, 0.62, 0.05), (0, 0, 0.6), 0.008)]
    deck += [box((0.56, 0.03, 0.07), (0, 0.28, z), 0.008) for z in (0.74, 0.86)]
    deck += [box((0.05, 0.03, 0.28), (x, 0.28, 0.74), 0.008) for x in (-0.18, -0.06, 0.06, 0.18)]
    roof += [
        plate(SQUARE * (0.42 - 0.055 * k), 0.06, (0, 0, 1.29 + 0.05 * k)) for k in range(7)
    ] + [ball(0.05, (0, 0, 1.64))]
    chute = [(-0.26, 0.62), (-0.4, 0.6), (-0.9, 0.16), (-1.05, 0.1), (-1.2, 0.1)]
    line = np.array(chute)
    slide += [plate([*line, *(line - (0, 0.035))[::-1]], 0.32, (0, 0, 0), SIDE)]
    slide += both_sides(
        [
            plate([*(line + (0, 0.11)), *(line - (0, 0.045))[::-1]], 0.035, (0.165, 0, 0), SIDE),
            rod((0.13, -1.1, 0.0), (0.13, -1.1, 0.1), 0.025),
        ]
    )
    climb += [rod((0.28, y, z), (0.75, y, z - 0.58), 0.022) for y, z in ((-0.2, 0.6), (0.2, 0.6))]
    climb += [
        rod((0.28 + 0.47 * f, -0.2, 0.6 - 0.58 * f), (0.28 + 0.47 * f, 0.2, 0.6 - 0.58 * f), 0.02)
        for f in np.linspace(0.14, 0.9, 5)
    ]
    end = draw(1.6, 1.8)
    posts += [rod((-0.28, 0, 1.16), (-end, 0, 1.16), 0.04)]
    posts += [rod((-end, 0, 1.18), (-end, s * 0.42, 0), 0.035) for s in (-1, 1)] + [
        rod((-0.28, -0.28, 1.16), (-0.28, 0.28, 1.16), 0.03)
    ]
    for x in (-0.66, -1.22 * end / 1.7):
        swing = draw(-0.16, 0.16)
        climb += [rod((x + s * 0.13, 0, 1.16), (x + s * 0.12, swing, 0.4), 0.011) for s in (-1, 1)]
        seats += [box((0.32, 0.14, 0.035), (x, swing, 0.4), 0.012)]
    seats += [
        rod((-0.12, 0.3, 0.98), (0.12, 0.3, 0.98), 0.03),
        ring(0.1, 0.022, (0.31, 0, 0.98), "x"),
    ]
    climb += [
        rod((0.28, -0.28, 0.98), (0.28, 0.28, 0.98), 0.022),
        rod((-0.28, 0.28, 0.98), (0.28, 0.28, 0.98), 0.022),
    ]
    base = [box((end + 1.4, 2.2, 0.05), (-(end - 0.7) / 2, -0.15, -0.01), 0.02)]
    return {
        "posts": posts,
        "deck": deck,
        "roof": roof,
        "slide": slide,
        "climbing bars": climb,
        "seats": seats,
        "ground": base,
    }


def _monkey_bars(draw: Draw) -> Parts:
    count, long = 8 + draw.which(3), 0.95
    posts = [rod((s * 0.3, y, 0), (s * 0.3, y, 1.0), 0.034) for s in (-1, 1) for y in (-long, long)]
    posts += both_sides([capsule((0.3, -long, 1.0), (0.3, long, 1.0), 0.034)])
    bars = [
        rod((-0.31, y, 1.0), (0.31, y, 1.0), 0.024)
        for y in np.linspace(-long + 0.14, long - 0.14, count)
    ]
    steps = [
        rod((-0.31, y, z), (0.31, y, z), 0.024) for y in (-long, long) for z in (0.22, 0.42, 0.62)
    ]
    feet = [
        rod((s * 0.3, y, -0.03), (s * 0.3, y, 0.05), 0.07, rim=0.01)
        for s in (-1, 1)
        for y in (-long, long)
    ]
    base = [box((0.95, 2 * long + 0.4, 0.05), (0, 0, -0.03), 0.015)]
    return {"frame": posts, "bars": bars, "steps": steps, "feet": feet, "ground": base}


def _hot_tub(draw: Draw) -> Parts:
    r, high = 0.78, draw(0.5, 0.58)
    staves = spun([box((0.19, 0.05, high), (0, -r, high / 2), 0.012)], 26)
    shell = [
        (0, 0.02),
        (r - 0.005, 0.02),
        (r - 0.005, high - 0.02),
        (0.62, high - 0.02),
        (0.6, 0.3),
        (0, 0.26),
    ]
    rim = [
        (0.58, high - 0.03),
        (r + 0.06, high - 0.03),
        (r + 0.07, high + 0.02),
        (r + 0.04, high + 0.05),
        (0.6, high + 0.05),
        (0.57, high + 0.02),
    ]
    bands = [
        turned([(r - 0.02, z), (r + 0.042, z), (r + 0.042, z + 0.035), (r - 0.02, z + 0.035)])
        for z in (0.08, high - 0.13)
    ]
    water = [rod((0, 0, 0.2), (0, 0, high - 0.055), 0.626)]
    rng = np.random.default_rng(draw.which(100))
    bubbles = []
    for _ in range(34):
        a, d = rng.uniform(0, 2 * np.pi), 0.5 * np.sqrt(rng.uniform())
        bubbles.append(
            ball(float(rng.uniform(0.024, 0.05)), (d * np.cos(a), d * np.sin(a), high - 0.055))
        )
    steps = [
        box((0.6, 0.24, 0.16), (0, -r - 0.28, 0.08), 0.015),
        box((0.6, 0.22, 0.2), (0, -r - 0.12, 0.22), 0.015),
    ]
    panel = [box((0.2, 0.09, 0.03), (0, r - 0.06, high + 0.055), 0.008)]
    panel += [
        rod((x, r - 0.06, high + 0.06), (x, r - 0.06, high + 0.085), 0.022) for x in (-0.05, 0.05)
    ]
    pillows = [
        ball(
            (0.15, 0.06, 0.07),
            (0.62 * np.sin(a), -0.62 * np.cos(a), high + 0.05),
            (0, 0, np.degrees(a)),
        )
        for a in (1.6, -1.6)
    ]
    return {
        "staves": [*staves, turned(shell)],
        "rim": [turned(rim)],
        "bands": bands,
        "water": water,
        "bubbles": bubbles,
        "steps": steps,
        "panel": [*panel, *pillows],
    }


PLAYGROUNDS: dict[str, Callable[[Draw], Parts]] = {
    "roller coaster": _roller_coaster,
    "playground": _playground,
    "monkey bars": _monkey_bars,
    "hot tub": _hot_tub,
}
