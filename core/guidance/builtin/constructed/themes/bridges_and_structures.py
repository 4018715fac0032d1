"""Bridges."""

import itertools
from collections.abc import Callable

import numpy as np
from scipy.spatial.transform import Rotation

from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.pieces import SQUARE, arch_opening
from core.guidance.builtin.constructed.shapes import (
    FRONT,
    Parts,
    box,
    capsule,
    pipe,
    placed,
    plate,
    rod,
)


def _suspension_bridge(draw: Draw) -> Parts:
    half, high = draw(0.78, 0.9), 0.95
    deck_z, wide = 0.36, 0.13
    towers, cables, piers = [], [], []
    for x in (-half, half):
        for y in (-wide, wide):
            towers += [
                box((0.11, 0.08, high), (x, y, high / 2), 0.006),
                box((0.085, 0.065, 0.3), (x, y, high + 0.02), 0.006),
            ]
        towers += [
            box((0.07, 2 * wide, 0.06), (x, 0, z), 0.006) for z in (0.16, 0.52, 0.74, 0.96, 1.12)
        ]
        piers += [
            box((0.24, 0.5, 0.18), (x, 0, 0.0), 0.03),
            box((0.18, 0.42, 0.1), (x, 0, 0.11), 0.02),
        ]
    top, end = high + 0.16, 1.62
    for y in (-wide, wide):
        xs = np.linspace(-half, half, 25)
        zs = deck_z + 0.07 + (top - deck_z - 0.07) * (xs / half) ** 2
        line = [
            (-end, y, deck_z),
            *((x, y, z) for x, z in zip(xs, zs, strict=True)),
            (end, y, deck_z),
        ]
        cables += [capsule(a, b, 0.017) for a, b in itertools.pairwise(line)]
        for x in np.linspace(-end + 0.14, end - 0.14, 37):
            z = np.interp(x, [p[0] for p in line], [p[2] for p in line])
            if z > deck_z + 0.05:
                cables.append(rod((x, y, deck_z), (x, y, z), 0.0095))
    deck = [box((2 * end, 2 * wide + 0.04, 0.035), (0, 0, deck_z), 0.004)]
    deck += [
        box((2 * end, 0.025, 0.07), (0, y, deck_z - 0.03), 0.004)
        for y in (-wide - 0.01, wide + 0.01)
    ]
    for y in (-wide - 0.01, wide + 0.01):
        xs = np.linspace(-end + 0.04, end - 0.04, 41)
        deck += [
            rod(
                (a, y, deck_z - 0.09 + 0.07 * (k % 2)),
                (b, y, deck_z - 0.02 - 0.07 * (k % 2)),
                0.0095,
            )
            for k, (a, b) in enumerate(itertools.pairwise(xs))
        ]
        deck += [box((2 * end, 0.02, 0.02), (0, y, deck_z - 0.095), 0.004)]
    road = [box((2 * end - 0.02, 2 * wide - 0.05, 0.02), (0, 0, deck_z + 0.018))]
    lines = [
        box((0.07, 0.014, 0.012), (x, 0, deck_z + 0.026))
        for x in np.linspace(-end + 0.1, end - 0.1, 19)
    ]
    piers += [
        box((0.24, 2 * wide + 0.14, 0.46), (s * (end - 0.06), 0, 0.12), 0.01) for s in (-1, 1)
    ]
    return {
        "towers": towers,
        "cables": cables,
        "deck": deck,
        "road": road,
        "lines": lines,
        "piers": piers,
    }


def _tower_bridge(draw: Draw) -> Parts:
    half, lift = 0.52, draw(0.0, 26.0)
    stone, roof, blue, road, dark = [], [], [], [], []
    for x in (-half, half):
        stone += [
            box((0.3, 0.32, 0.8), (x, 0, 0.5), 0.004),
            box((0.4, 0.5, 0.24), (x, 0, 0.06), 0.05),
        ]
        stone += [box((0.34, 0.36, 0.035), (x, 0, z), 0.004) for z in (0.5, 0.72, 0.9)]
        for s in (-1, 1):
            for t in (-1, 1):
                at = (x + 0.14 * s, 0.15 * t)
                stone.append(rod((*at, 0.1), (*at, 0.98), 0.045))
                roof.append(rod((*at, 0.96), (*at, 1.16), 0.055, 0.004))
        roof += [
            plate(SQUARE * (0.13 - 0.012 * k), 0.04, (x, 0, 0.92 + 0.036 * k)) for k in range(10)
        ]
        roof += [rod((x, 0, 1.24), (x, 0, 1.4), 0.012)]
        dark += [
            plate(arch_opening(0.09, 0.16) + (dx, 0), 0.34, (x, 0, z), FRONT)
            for dx in (-0.065, 0.065)
            for z in (0.53, 0.75)
        ]
    for y in (-0.1, 0.1):
        blue += [box((2 * half, 0.05, 0.03), (0, y, z), 0.004) for z in (0.66, 0.76)]
        xs = np.linspace(-half, half, 15)
        blue += [
            rod((a, y, 0.66 + 0.1 * (k % 2)), (b, y, 0.76 - 0.1 * (k % 2)), 0.011)
            for k, (a, b) in enumerate(itertools.pairwise(xs))
        ]
    for s in (-1, 1):
        way = Rotation.from_euler("y", -s * lift, degrees=True).as_matrix()
        leaf = [box((0.4, 0.24, 0.04), (-s * 0.19, 0, 0), 0.006)]
        road += placed(leaf, way, (s * (half - 0.13), 0, 0.32))
        sides = [box((0.4, 0.02, 0.06), (-s * 0.19, y, 0.02), 0.004) for y in (-0.12, 0.12)]
        blue += placed(sides, way, (s * (half - 0.13), 0, 0.32))
        end = s * 1.5
        road.append(box((abs(end) - half, 0.24, 0.045), ((end + s * half) / 2, 0, 0.32), 0.006))
        for y in (-0.13, 0.13):
            line = [
                (s * (half + 0.12), y, 0.74),
                (s * (half + 0.34), y, 0.5),
                (s * (half + 0.56), y, 0.39),
                (s * (half + 0.74), y, 0.4),
                (end - s * 0.08, y, 0.56),
            ]
            blue.append(pipe(line, 0.026))
            xs = np.linspace(half + 0.2, 1.42, 11)
            heights = np.interp(xs, [abs(p[0]) for p in line], [p[2] for p in line])
            blue += [
                rod((s * a, y, 0.32), (s * a, y, b), 0.011)
                for a, b in zip(xs, heights, strict=True)
            ]
        stone += [box((0.2, 0.34, 0.62), (end - s * 0.04, 0, 0.27), 0.006)]
        roof += [
            plate(
                np.array([(-0.11, 0), (0.11, 0), (0, 0.16)]), 0.36, (end - s * 0.04, 0, 0.56), FRONT
            )
        ]
    return {"towers": stone, "roofs": roof, "chains": blue, "deck": road, "windows": dark}


BRIDGES_AND_STRUCTURES: dict[str, Callable[[Draw], Parts]] = {
    "suspension bridge": _suspension_bridge,
    "tower bridge": _tower_bridge,
}
