"""Landmarks, pools and webs."""

from collections.abc import Callable

import numpy as np

from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.shapes import (
    Parts,
    ball,
    both_sides,
    box,
    pipe,
    plate,
    rod,
    rounded,
    spun,
)


def _swimming_pool(draw: Draw) -> Parts:
    wide, deep, high = draw(1.7, 2.2), draw(0.9, 1.2), 0.26
    border = 0.14
    outer, inner = rounded((wide, deep), 0.14), rounded((wide - 2 * border, deep - 2 * border), 0.1)
    x, y = wide / 2 - 0.22, deep / 2 - border
    rails = [
        pipe([(x + dx, y - 0.02, 0.02), (x + dx, y + 0.04, 0.36), (x + dx, y + 0.16, 0.13)], 0.016)
        for dx in (-0.09, 0.09)
    ]
    board = box((0.24, 0.5, 0.03), (-x + 0.1, y - 0.05, 0.3), 0.01)
    stand = box((0.2, 0.1, 0.2), (-x + 0.1, y + 0.07, 0.2))
    return {
        "rim": [plate(outer, high, (0, 0, 0), holes=[inner])],
        "water": [plate(rounded((wide - border, deep - border), 0.12), high - 0.08, (0, 0, -0.04))],
        "ladder": rails,
        "board": [board, stand],
    }


def _spider_web(draw: Draw) -> Parts:
    spokes, rings, thread = 8 + draw.which(3), 5, 0.012
    angle = 2 * np.pi * (np.arange(spokes) + draw(0, 0.5)) / spokes
    way = np.stack([np.cos(angle), np.zeros(spokes), np.sin(angle)], 1)
    web = [rod((0, 0, 0), tuple(one), thread) for one in way]
    for k in range(1, rings + 1):
        ends = way * (0.95 * k / rings)
        for a, b in zip(ends, np.roll(ends, -1, 0), strict=True):
            middle = 0.44 * (a + b)  # the thread hangs to the inside
            web.append(pipe([tuple(a), tuple(middle), tuple(b)], 0.8 * thread))
    body = [ball((0.07, 0.06, 0.09), (0.0, -0.06, -0.06)), ball(0.045, (0.0, -0.06, 0.05))]
    legs = []
    for k, out in enumerate((0.14, 0.05, -0.05, -0.15)):
        bend, end = (0.1, -0.1, 0.02 + 0.7 * out), (0.19, -0.02, 0.02 + 1.3 * out)
        legs.append(pipe([(0.02, -0.06, 0.03 - 0.02 * k), bend, end], 0.012))
    return {"web": web, "spider": [*body, *both_sides(legs)]}


def _eiffel_tower(draw: Draw) -> Parts:
    del draw
    heights = np.array([0.0, 0.35, 0.62, 1.15, 2.6])
    reach = np.array([0.62, 0.4, 0.27, 0.135, 0.03])
    thick = np.array([0.075, 0.06, 0.05, 0.04, 0.022])
    leg = [
        rod((a, a, low), (b, b, high), r, s)
        for low, high, a, b, r, s in zip(
            heights[:-1], heights[1:], reach[:-1], reach[1:], thick[:-1], thick[1:], strict=True
        )
    ]
    lattice = []
    for k in range(3):
        cells = (3, 2, 3)[k]
        for j in range(cells):
            (low, a), (high, b) = (
                (np.interp(t, [0, 1], heights[k : k + 2]), np.interp(t, [0, 1], reach[k : k + 2]))
                for t in (j / cells, (j + 1) / cells)
            )
            for start, end in (((-a, -a, low), (b, -b, high)), ((a, -a, low), (-b, -b, high))):
                lattice.append(rod(start, end, 0.018))
            lattice.append(rod((-b, -b, high), (b, -b, high), 0.022))
    lattice.append(pipe([(-0.52, -0.53, 0.1), (0, -0.47, 0.3), (0.52, -0.53, 0.1)], 0.03))
    decks = [
        box((2 * r + 0.2, 2 * r + 0.2, 0.07), (0, 0, z), 0.01)
        for r, z in ((0.3, 0.6), (0.16, 1.15))
    ]
    top = [box((0.15, 0.15, 0.12), (0, 0, 2.5), 0.02), rod((0, 0, 2.5), (0, 0, 2.95), 0.02, 0.008)]
    feet = spun([box((0.3, 0.3, 0.1), (0.62, 0.62, 0.0), 0.02)], 4)
    iron = [*spun(leg, 4), *spun(lattice, 4), *top]
    return {"iron": iron, "decks": decks, "feet": feet}


def _stonehenge(draw: Draw) -> Parts:
    stones, count = [], 9
    for k in range(count):
        turn = 360 * k / count + draw(-2, 2)
        angle = np.radians(turn)
        at = (np.cos(angle), np.sin(angle), 0.25)
        stones.append(box((0.16, 0.26, 0.55), at, 0.05, (draw(-2, 2), draw(-2, 2), turn)))
        middle = np.radians(turn + 180 / count)
        if k not in (2, 6):
            lintel = (0.95 * np.cos(middle), 0.95 * np.sin(middle), 0.56)
            stones.append(box((0.19, 0.8, 0.13), lintel, 0.04, (0, 0, turn + 180 / count)))
    for k in range(3):
        turn = 40 + 100 * k
        for side in (-0.16, 0.16):
            angle = np.radians(turn) + side / 0.45
            at = (0.45 * np.cos(angle), 0.45 * np.sin(angle), 0.32)
            stones.append(box((0.16, 0.17, 0.7), at, 0.05, (0, 0, turn)))
        angle = np.radians(turn)
        at = (0.44 * np.cos(angle), 0.44 * np.sin(angle), 0.7)
        stones.append(box((0.19, 0.54, 0.12), at, 0.04, (0, 0, turn)))
    return {"stones": stones, "grass": [rod((0, 0, -0.1), (0, 0, 0.01), 1.3, 1.24, 0.03)]}


SIGHTS: dict[str, Callable[[Draw], Parts]] = {
    "swimming pool": _swimming_pool,
    "spider web": _spider_web,
    "eiffel tower": _eiffel_tower,
    "stonehenge": _stonehenge,
}
