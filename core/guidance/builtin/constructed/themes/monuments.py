"""Monuments."""

from collections.abc import Callable

import numpy as np
from scipy.spatial.transform import Rotation

from core.geometry.parts.primitives import Primitive
from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.pieces import SQUARE, arch_opening
from core.guidance.builtin.constructed.shapes import (
    FLAT,
    FRONT,
    Parts,
    ball,
    both_sides,
    box,
    capsule,
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


def _statue_of_liberty(draw: Draw) -> Parts:
    turn = np.arange(22) * 2 * np.pi / 22
    star = [
        (r * np.cos(a), r * np.sin(a)) for a, r in zip(turn, np.tile([0.56, 0.44], 11), strict=True)
    ]
    base = [plate(star, 0.16, (0, 0, 0.08)), plate(0.42 * SQUARE, 0.1, (0, 0, 0.19))]
    for half, z, thick in (
        (0.34, 0.27, 0.1),
        (0.27, 0.5, 0.4),
        (0.31, 0.71, 0.05),
        (0.25, 0.78, 0.12),
        (0.28, 0.85, 0.04),
        (0.21, 0.9, 0.09),
    ):
        base.append(plate(half * SQUARE, thick, (0, 0, z)))
    base += spun([box((0.1, 0.03, 0.24), (x, -0.275, 0.5), 0.005) for x in (-0.17, 0, 0.17)], 4)
    foot = 0.93
    robe = [
        (0, foot - 0.02),
        (0.2, foot - 0.02),
        (0.19, foot + 0.1),
        (0.15, foot + 0.4),
        (0.14, foot + 0.62),
        (0.155, foot + 0.74),
        (0.1, foot + 0.84),
        (0.05, foot + 0.88),
        (0, foot + 0.88),
    ]
    body = [turned(robe)]
    folds = draw.which(3)
    for k in range(13 + folds):
        a = 2 * np.pi * k / (13 + folds)
        low, high = 0.19 + 0.012 * (k % 2), 0.12
        body.append(
            capsule(
                (low * np.cos(a), low * np.sin(a), foot),
                (high * np.cos(a + 0.22), high * np.sin(a + 0.22), foot + 0.7),
                0.03,
                0.022,
            )
        )
    for k in range(4):
        z = foot + 0.3 + 0.1 * k
        body.append(pipe([(-0.13, -0.09, z + 0.16), (0.0, -0.17, z), (0.13, -0.1, z - 0.1)], 0.026))
    top = foot + 0.93
    body += [
        rod((0, 0, top - 0.12), (0, 0, top + 0.02), 0.05),
        ball((0.078, 0.088, 0.105), (0, -0.01, top + 0.08)),
    ]
    body += [
        ball((0.085, 0.08, 0.09), (0, 0.03, top + 0.09)),
        ball((0.018, 0.02, 0.022), (0, -0.095, top + 0.07)),
    ]
    body += [
        turned([(0.07, -0.015), (0.098, -0.015), (0.104, 0.03), (0.07, 0.03)], (0, 0.0, top + 0.13))
    ]
    for k in range(7):
        a = np.radians(180 * (k + 0.5) / 7)
        tip = (0.25 * np.cos(a), 0.02 - 0.05 * np.sin(a), top + 0.14 + 0.25 * np.sin(a))
        body.append(rod((0.08 * np.cos(a), 0.0, top + 0.13 + 0.04 * np.sin(a)), tip, 0.018, 0.005))
    body += [
        pipe(
            [
                (-0.1, 0, foot + 0.76),
                (-0.18, -0.02, foot + 0.84),
                (-0.2, -0.02, foot + 1.0),
                (-0.17, -0.02, foot + 1.26),
            ],
            (0.072, 0.064, 0.055, 0.04),
        )
    ]
    body += [
        ball((0.045, 0.045, 0.05), (-0.17, -0.02, foot + 1.28)),
        pipe(
            [(-0.13, 0.0, foot + 0.72), (-0.2, 0.02, foot + 0.66), (-0.22, 0.02, foot + 0.84)],
            (0.07, 0.05, 0.05),
        ),
    ]
    body += [
        pipe(
            [(0.1, 0, foot + 0.76), (0.18, -0.02, foot + 0.62), (0.15, -0.13, foot + 0.54)],
            (0.07, 0.06, 0.045),
        ),
        ball(0.045, (0.15, -0.14, foot + 0.54)),
    ]
    body += [box((0.15, 0.06, 0.25), (0.17, -0.135, foot + 0.64), 0.008, (-18, 0, -18))]
    hand = (-0.17, -0.02, foot + 1.28)
    cup = [
        (0, -0.04),
        (0.025, -0.04),
        (0.03, 0.1),
        (0.075, 0.14),
        (0.08, 0.19),
        (0.06, 0.19),
        (0, 0.17),
    ]
    body.append(turned(cup, hand))
    flame = [(0, 0.15), (0.05, 0.17), (0.062, 0.23), (0.035, 0.33), (0, 0.42)]
    return {"statue": body, "flame": [turned(flame, hand)], "pedestal": base}


def _colosseum(draw: Draw) -> Parts:
    count, floors = 28, 4
    stone, inner = [], []
    height = 0.17

    t = np.linspace(0, 2 * np.pi, 97)[:-1]
    low = draw(2.2, 2.6)

    def standing(level: int, angle: float) -> bool:
        return level < 2 or not (
            low + 0.35 * (level - 2) < angle % (2 * np.pi) + 1.0 < low + 2.6 + 0.25 * (level - 2)
        )

    for level in range(floors):
        z = level * height
        for k in range(count):
            a, b = 2 * np.pi * k / count, 2 * np.pi * (k + 1) / count
            middle = (a + b) / 2
            if not standing(level, middle + np.pi):
                continue
            ends = np.array([(np.cos(x), 0.84 * np.sin(x)) for x in (a, b)])
            wide = float(np.linalg.norm(ends[1] - ends[0]))
            at = ends.mean(0)
            turn = np.degrees(np.arctan2(*(ends[1] - ends[0])[::-1]))
            way = Rotation.from_euler("z", turn + 180, degrees=True).as_matrix() @ FRONT
            hole = (
                arch_opening(0.52 * wide, 0.66 * height)
                if level < 3
                else rounded((0.26 * wide, 0.24 * height), 0.01, (0, 0.5 * height))
            )
            hole = hole + (0, 0.02) if level < 3 else hole
            outer = np.array(
                [
                    (-wide / 2 - 0.012, -0.002),
                    (wide / 2 + 0.012, -0.002),
                    (wide / 2 + 0.012, height + 0.004),
                    (-wide / 2 - 0.012, height + 0.004),
                ]
            )
            stone.append(plate(outer, 0.11, (*at, z), way, [hole]))
            stone.append(
                box((wide + 0.03, 0.15, 0.022), (*at, z + height - 0.008), 0.004, (0, 0, turn))
            )
            stone.append(
                box((0.024, 0.15, height), (*ends[0], z + height / 2), 0.006, (0, 0, turn))
            )
    for k in range(5):
        scale, z = 0.93 - 0.1 * k, 0.40 - 0.075 * k
        outer = np.stack([scale * np.cos(t), 0.84 * scale * np.sin(t)], 1)
        hole = np.stack([0.44 * np.cos(t), 0.84 * 0.44 * np.sin(t)], 1)
        inner.append(plate(outer, 0.08 + z, (0, 0, (0.08 + z) / 2 - 0.01), FLAT, [hole]))
    floor = np.stack([0.5 * np.cos(t), 0.42 * np.sin(t)], 1)
    sand = [plate(floor, 0.06, (0, 0, 0.015))]
    base = np.stack([1.14 * np.cos(t), 0.98 * np.sin(t)], 1)

    return {
        "walls": stone,
        "stands": inner,
        "arena": sand,
        "base": [plate(base, 0.05, (0, 0, -0.015))],
    }


def _leaning_tower(draw: Draw) -> Parts:
    lean = Rotation.from_euler("y", draw(5.0, 7.0), degrees=True).as_matrix()
    r, column, rims = 0.3, [], []
    z = 0.0
    column.append(rod((0, 0, -0.05), (0, 0, 0.34), r + 0.04))
    column += spun([rod((0, -r - 0.04, 0.0), (0, -r - 0.04, 0.3), 0.022)], 15)
    rims.append(turned([(0, 0.32), (r + 0.08, 0.32), (r + 0.08, 0.365), (0, 0.365)]))
    z = 0.36
    for _ in range(6):
        column.append(rod((0, 0, z - 0.02), (0, 0, z + 0.2), r - 0.05))
        column += spun([rod((0, -r, z - 0.01), (0, -r, z + 0.155), 0.017)], 20)
        rims.append(
            turned(
                [
                    (0.1, z + 0.14),
                    (r + 0.02, z + 0.15),
                    (r + 0.04, z + 0.165),
                    (r + 0.04, z + 0.195),
                    (0.1, z + 0.195),
                ]
            )
        )
        z += 0.19
    column.append(rod((0, 0, z - 0.02), (0, 0, z + 0.26), r - 0.07))
    rims.append(
        turned([(0.1, z + 0.23), (r - 0.04, z + 0.23), (r - 0.04, z + 0.27), (0.1, z + 0.27)])
    )
    column += spun([plate(arch_opening(0.1, 0.16), 0.03, (0, -r + 0.07, z + 0.03), FRONT)], 1)
    dark = spun([plate(arch_opening(0.11, 0.18), 0.04, (0, -r + 0.07, z + 0.02), FRONT)], 6)
    dark += [plate(arch_opening(0.14, 0.24), 0.04, (0, -r - 0.03, 0.0), FRONT)]
    base = [
        rod((0, 0, -0.08), (0, 0, 0.0), 0.52, 0.5, 0.01),
        rod((0, 0, -0.02), (0, 0, 0.03), 0.44),
    ]
    return {
        "tower": placed(column, lean),
        "galleries": placed(rims, lean),
        "openings": placed(dark, lean),
        "base": base,
    }


def _onion(radius: float, at: tuple[float, float, float]) -> Primitive:
    """An onion dome by its widest radius, on its drum's top."""
    way = [
        (0, -0.02),
        (0.82, -0.02),
        (0.98, 0.28),
        (1.0, 0.5),
        (0.9, 0.82),
        (0.6, 1.16),
        (0.26, 1.38),
        (0.1, 1.56),
        (0.03, 1.72),
        (0, 1.74),
    ]
    return turned([(radius * a, radius * b) for a, b in way], at)


def _taj_mahal(draw: Draw) -> Parts:
    big = draw(0.27, 0.3)
    walls, dark, gold = [], [], []
    plan = np.array(
        [
            (-0.5, -0.32),
            (-0.32, -0.5),
            (0.32, -0.5),
            (0.5, -0.32),
            (0.5, 0.32),
            (0.32, 0.5),
            (-0.32, 0.5),
            (-0.5, 0.32),
        ]
    )
    walls += [plate(plan, 0.5, (0, 0, 0.33)), plate(1.02 * plan, 0.04, (0, 0, 0.57))]
    face = [
        box((0.4, 0.08, 0.66), (0, -0.48, 0.38), 0.004),
        *both_sides(
            [box((0.05, 0.1, 0.72), (0.205, -0.48, 0.42), 0.004), ball(0.03, (0.205, -0.48, 0.8))]
        ),
    ]
    walls += spun(face, 4)
    arch = np.array(
        [
            (-0.12, 0.0),
            (0.12, 0.0),
            (0.12, 0.26),
            (0.08, 0.36),
            (0.0, 0.43),
            (-0.08, 0.36),
            (-0.12, 0.26),
        ]
    )
    dark += spun(
        [
            plate(arch, 0.03, (0, -0.515, 0.09), FRONT),
            *both_sides([plate(0.42 * arch, 0.03, (0.265, -0.5, z), FRONT) for z in (0.1, 0.34)]),
        ],
        4,
    )
    turn = Rotation.from_euler("z", 45, degrees=True).as_matrix()
    dark += placed(
        spun([plate(0.42 * arch, 0.03, (0, -0.577, z), FRONT) for z in (0.1, 0.34)], 4), turn
    )
    walls += [rod((0, 0, 0.55), (0, 0, 0.72), big, big), ring(big + 0.005, 0.02, (0, 0, 0.7))]
    domes = [_onion(big * 1.1, (0, 0, 0.72))]
    gold += [
        rod((0, 0, 0.72 + 1.86 * big), (0, 0, 0.94 + 1.9 * big), 0.012),
        ball(0.022, (0, 0, 0.84 + 1.9 * big)),
    ]
    for x, y in ((0.3, 0.3), (-0.3, 0.3), (0.3, -0.3), (-0.3, -0.3)):
        walls += [
            rod((x, y, 0.56), (x, y, 0.6), 0.1, 0.1),
            *moved(spun([rod((0.08, 0, 0.58), (0.08, 0, 0.72), 0.014)], 8), (x, y, 0)),
            rod((x, y, 0.7), (x, y, 0.73), 0.11),
        ]
        domes.append(_onion(0.095, (x, y, 0.73)))
        gold.append(rod((x, y, 0.87), (x, y, 0.95), 0.01))
    for x, y in ((0.84, 0.84), (-0.84, 0.84), (0.84, -0.84), (-0.84, -0.84)):
        walls += [rod((x, y, 0.05), (x, y, 0.98), 0.075, 0.055)]
        walls += [rod((x, y, z), (x, y, z + 0.035), 0.095, 0.1) for z in (0.36, 0.66, 0.94)]
        walls += [
            *moved(spun([rod((0.05, 0, 0.96), (0.05, 0, 1.06), 0.012)], 6), (x, y, 0)),
            rod((x, y, 1.04), (x, y, 1.07), 0.08),
        ]
        domes.append(_onion(0.068, (x, y, 1.07)))
        gold.append(rod((x, y, 1.17), (x, y, 1.24), 0.01))
    base = [
        box((2.0, 2.0, 0.1), (0, 0, 0.04), 0.008),
        box((1.1, 1.1, 0.05), (0, 0, 0.1), 0.006),
        box((0.3, 0.2, 0.06), (0, -1.04, 0.02), 0.004),
    ]
    return {"walls": walls, "domes": domes, "openings": dark, "finials": gold, "base": base}


MONUMENTS: dict[str, Callable[[Draw], Parts]] = {
    "statue of liberty": _statue_of_liberty,
    "colosseum": _colosseum,
    "leaning tower": _leaning_tower,
    "taj mahal": _taj_mahal,
}
