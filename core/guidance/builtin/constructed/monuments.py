"""Monuments and large structures."""

from collections.abc import Callable

import numpy as np
from scipy.spatial.transform import Rotation

from core.geometry.parts.primitives import Loop, Primitive
from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.shapes import (
    FLAT,
    FRONT,
    SIDE,
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


def _arch(wide: float, high: float, sides: int = 11) -> Loop:
    """An opening with a round head, on the ground, by its width and its whole height."""
    half = wide / 2
    angle = np.linspace(0, np.pi, sides)
    head = [(half * np.cos(a), high - half + half * np.sin(a)) for a in angle]
    return np.array([(half, 0.0), *head, (-half, 0.0)])


def _ngon(radius: float, sides: int) -> Loop:
    """A regular outline with a side to the front."""
    angle = np.arange(sides) * 2 * np.pi / sides + np.pi / sides - np.pi / 2
    return radius * np.stack([np.cos(angle), np.sin(angle)], 1)


def _statue_of_liberty(draw: Draw) -> Parts:
    turn = np.arange(22) * 2 * np.pi / 22
    star = [
        (r * np.cos(a), r * np.sin(a)) for a, r in zip(turn, np.tile([0.56, 0.44], 11), strict=True)
    ]
    square = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)], float)
    base = [plate(star, 0.16, (0, 0, 0.08)), plate(0.42 * square, 0.1, (0, 0, 0.19))]
    for half, z, thick in (
        (0.34, 0.27, 0.1),
        (0.27, 0.5, 0.4),
        (0.31, 0.71, 0.05),
        (0.25, 0.78, 0.12),
        (0.28, 0.85, 0.04),
        (0.21, 0.9, 0.09),
    ):
        base.append(plate(half * square, thick, (0, 0, z)))
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
    body += [box((0.15, 0.05, 0.25), (0.17, -0.13, foot + 0.63), 0.008, (-18, 0, -18))]
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
    height, high = 0.17, 0.62
    ring_of = lambda r, grow=1.0: np.stack([grow * r * np.cos(t), 0.84 * grow * r * np.sin(t)], 1)  # noqa: E731
    t = np.linspace(0, 2 * np.pi, 97)[:-1]
    low = draw(2.2, 2.6)

    def standing(level: int, angle: float) -> bool:
        return level < 2 or not (
            low + 0.35 * (level - 2) < angle % (2 * np.pi) + 1.0 < low + 2.6 + 0.25 * (level - 2)
        )

    del ring_of
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
                _arch(0.52 * wide, 0.66 * height)
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
    del high
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
    column += spun([plate(_arch(0.1, 0.16), 0.03, (0, -r + 0.07, z + 0.03), FRONT)], 1)
    dark = spun([plate(_arch(0.11, 0.18), 0.04, (0, -r + 0.07, z + 0.02), FRONT)], 6)
    dark += [plate(_arch(0.14, 0.24), 0.04, (0, -r - 0.03, 0.0), FRONT)]
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


def _big_ben(draw: Draw) -> Parts:
    high = draw(1.15, 1.3)
    w = 0.2
    stone = [box((2 * w, 2 * w, high), (0, 0, high / 2), 0.004)]
    ribs = [
        box((0.035, 0.03, high - 0.06), (x, -w - 0.006, high / 2), 0.004)
        for x in (-0.1, -0.035, 0.035, 0.1)
    ]
    ribs += [
        box((2 * w + 0.03, 0.04, 0.022), (0, -w, z), 0.004)
        for z in np.linspace(0.22, high - 0.14, 6)
    ]
    stone += spun(ribs, 4)
    stone += [
        box((0.075, 0.075, high + 0.52), (s * w, t * w, (high + 0.52) / 2), 0.012)
        for s in (-1, 1)
        for t in (-1, 1)
    ]
    stone += [
        box((0.5, 0.5, 0.06), (0, 0, 0.03), 0.006),
        box((0.46, 0.46, 0.05), (0, 0, high - 0.02), 0.006),
    ]
    stone += [
        box((0.44, 0.44, 0.44), (0, 0, high + 0.22), 0.006),
        box((0.5, 0.5, 0.04), (0, 0, high + 0.45), 0.006),
    ]
    belfry = [
        plate(
            np.array([(-0.19, 0), (0.19, 0), (0.19, 0.2), (-0.19, 0.2)]),
            0.05,
            (0, -0.165, high + 0.46),
            FRONT,
            [_arch(0.07, 0.15) + (x, 0.02) for x in (-0.12, 0, 0.12)],
        )
    ]
    stone += spun(belfry, 4)
    stone += [box((0.26, 0.26, 0.2), (0, 0, high + 0.56))]
    top = high + 0.66
    square = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)], float)
    roof = [
        plate(square * (0.21 - 0.011 * k), 0.032, (0, 0, top + 0.012 + 0.03 * k)) for k in range(9)
    ]
    mid = top + 0.28
    roof += [box((0.22, 0.22, 0.1), (0, 0, mid + 0.04), 0.006)]
    roof += [
        plate(square * (0.115 - 0.0105 * k), 0.038, (0, 0, mid + 0.1 + 0.036 * k))
        for k in range(10)
    ]
    tips = [
        rod((0, 0, mid + 0.42), (0, 0, mid + 0.62), 0.014, 0.006),
        ball(0.026, (0, 0, mid + 0.5)),
    ]
    tips += [
        rod((s * w, t * w, high + 0.5), (s * w, t * w, high + 0.68), 0.034, 0.004)
        for s in (-1, 1)
        for t in (-1, 1)
    ]
    clock, hands, gold = [], [], []
    face = [rod((0, -0.2, high + 0.22), (0, -0.235, high + 0.22), 0.15)]
    marks = [
        box(
            (0.016, 0.02, 0.034),
            (0.122 * np.sin(a), -0.233, high + 0.22 + 0.122 * np.cos(a)),
            0.002,
            (0, np.degrees(a), 0),
        )
        for a in np.arange(12) * np.pi / 6
    ]
    marks += [
        rod((0, -0.236, high + 0.2), (0, -0.236, high + 0.33), 0.01),
        rod((-0.008, -0.236, high + 0.21), (0.078, -0.236, high + 0.26), 0.013),
        rod((0, -0.22, high + 0.22), (0, -0.248, high + 0.22), 0.02),
    ]
    rim = [
        turned(
            [(0.148, -0.02), (0.178, -0.02), (0.178, 0.024), (0.148, 0.024)],
            (0, -0.222, high + 0.22),
            "y",
        )
    ]
    clock, hands, gold = spun(face, 4), spun(marks, 4), spun(rim, 4)
    return {"tower": stone, "roof": roof, "faces": clock, "hands": hands, "gold": [*gold, *tips]}


def _sphinx(draw: Draw) -> Parts:
    long = draw(0.95, 1.1)
    body = [
        capsule((0, -0.35, 0.42), (0, long - 0.25, 0.36), 0.24, 0.28),
        box((0.5, long + 0.3, 0.3), (0, 0.15, 0.19), 0.08),
    ]
    body += both_sides(
        [
            ball((0.14, 0.3, 0.27), (0.26, long - 0.3, 0.28)),
            box((0.17, 0.62, 0.16), (0.25, -0.72, 0.12), 0.06),
            capsule((0.25, -0.5, 0.14), (0.22, -0.36, 0.46), 0.1, 0.12),
        ]
    )
    body += both_sides(
        [ball((0.038, 0.05, 0.05), (0.19 + 0.055 * k, -1.02, 0.1)) for k in range(3)]
    )
    body += both_sides([capsule((0.34, long - 0.52, 0.1), (0.34, long - 0.2, 0.1), 0.09)])
    body += [
        pipe(
            [
                (0.1, long - 0.02, 0.3),
                (0.3, long + 0.08, 0.14),
                (0.42, long - 0.1, 0.1),
                (0.44, long - 0.4, 0.09),
            ],
            0.04,
        )
    ]
    body += [capsule((0, -0.42, 0.4), (0, -0.45, 0.66), 0.2, 0.13)]
    head = [
        ball((0.17, 0.18, 0.2), (0, -0.5, 0.92)),
        ball((0.12, 0.08, 0.08), (0, -0.6, 0.83)),
        ball((0.03, 0.05, 0.045), (0, -0.68, 0.9)),
    ]
    head += both_sides([ball((0.03, 0.04, 0.05), (0.17, -0.49, 0.9))])
    head += [pipe([(-0.055, -0.66, 0.82), (0, -0.685, 0.815), (0.055, -0.66, 0.82)], 0.014)]
    hood = [
        (0, 1.14),
        (0.13, 1.12),
        (0.21, 1.03),
        (0.25, 0.9),
        (0.3, 0.68),
        (0.32, 0.52),
        (0.18, 0.5),
        (0.17, 0.72),
        (0.16, 0.88),
        (0.14, 1.0),
        (0.08, 1.04),
        (0, 1.05),
    ]
    cloth = [plate([*hood, *((-x, z) for x, z in hood[-2:0:-1])], 0.26, (0, -0.46, 0), FRONT)]
    cloth += [
        ball((0.2, 0.19, 0.2), (0, -0.44, 0.95)),
        capsule((0, -0.34, 0.9), (0, -0.2, 0.6), 0.16, 0.12),
    ]
    bands = [
        box((0.13, 0.3, 0.028), (s * (0.25 + 0.012 * k), -0.46, 0.55 + 0.075 * k - 0.02), 0.01)
        for s in (-1, 1)
        for k in ()
    ]
    bands += both_sides(
        [
            box(
                (0.145 - 0.012 * k, 0.285, 0.03), (0.245 - 0.012 * k, -0.46, 0.56 + 0.085 * k), 0.01
            )
            for k in range(4)
        ]
    )
    bands += [
        pipe(
            [
                (-0.16, -0.6, 1.02),
                (-0.1, -0.66, 1.045),
                (0, -0.685, 1.05),
                (0.1, -0.66, 1.045),
                (0.16, -0.6, 1.02),
            ],
            0.022,
        ),
        capsule((0, -0.68, 1.03), (0, -0.69, 1.14), 0.025, 0.018),
    ]
    face = both_sides(
        [
            ball((0.032, 0.016, 0.018), (0.07, -0.655, 0.945)),
            capsule((0.03, -0.66, 0.985), (0.11, -0.64, 0.99), 0.01),
        ]
    )
    beard = [capsule((0, -0.64, 0.76), (0, -0.66, 0.58), 0.04, 0.03)]
    base = [box((0.92, long + 1.4, 0.1), (0, (long - 1.0) / 2 - 0.02, 0.0), 0.012)]
    return {
        "body": [*body, *head],
        "headdress": cloth,
        "bands": [*bands, *beard],
        "eyes": face,
        "base": base,
    }


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
        cables += [capsule(a, b, 0.017) for a, b in zip(line[:-1], line[1:], strict=True)]
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
            for k, (a, b) in enumerate(zip(xs[:-1], xs[1:], strict=True))
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
        square = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)], float)
        roof += [
            plate(square * (0.13 - 0.012 * k), 0.04, (x, 0, 0.92 + 0.036 * k)) for k in range(10)
        ]
        roof += [rod((x, 0, 1.24), (x, 0, 1.4), 0.012)]
        dark += [
            plate(_arch(0.09, 0.16) + (dx, 0), 0.34, (x, 0, z), FRONT)
            for dx in (-0.065, 0.065)
            for z in (0.53, 0.75)
        ]
    for y in (-0.1, 0.1):
        blue += [box((2 * half, 0.05, 0.03), (0, y, z), 0.004) for z in (0.66, 0.76)]
        xs = np.linspace(-half, half, 15)
        blue += [
            rod((a, y, 0.66 + 0.1 * (k % 2)), (b, y, 0.76 - 0.1 * (k % 2)), 0.011)
            for k, (a, b) in enumerate(zip(xs[:-1], xs[1:], strict=True))
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


def _aqueduct(draw: Draw) -> Parts:
    count = 5 + draw.which(2)
    wide = 0.44
    total = count * wide
    big, small = _arch(0.32, 0.62), _arch(0.105, 0.16)
    tops = [(0, 0), (total, 0), (total, 0.78), (0, 0.78)]
    lower = plate(
        np.array(tops) - (total / 2, 0),
        0.28,
        (0, 0, 0),
        FRONT,
        [big * (1, 1) + ((k + 0.5) * wide - total / 2, 0.0001) for k in range(count)],
    )
    upper_count = 3 * count
    each = total / upper_count
    upper = plate(
        np.array([(0, 0), (total, 0), (total, 0.26), (0, 0.26)]) - (total / 2, 0),
        0.2,
        (0, 0, 0.82),
        FRONT,
        [small + ((k + 0.5) * each - total / 2, 0.001) for k in range(upper_count)],
    )
    stone = [lower, upper]
    rims = [
        box((total + 0.04, 0.34, 0.05), (0, 0, 0.8), 0.008),
        box((total + 0.04, 0.26, 0.04), (0, 0, 1.08), 0.006),
    ]
    rims += [
        box((0.16, 0.34, 0.05), ((k) * wide - total / 2, 0, 0.4), 0.008) for k in range(count + 1)
    ]
    rims += [
        box((0.18, 0.36, 0.08), ((k) * wide - total / 2, 0, 0.03), 0.01) for k in range(count + 1)
    ]
    rims += [box((total + 0.02, 0.04, 0.08), (0, y, 1.12), 0.006) for y in (-0.1, 0.1)]
    water = [box((total + 0.03, 0.17, 0.05), (0, 0, 1.1))]
    return {"arches": stone, "courses": rims, "water": water}


def _stadium(draw: Draw) -> Parts:
    t = np.linspace(0, 2 * np.pi, 97)[:-1]

    def oval(scale: float, grow: float = 0.0) -> Loop:
        power = 0.72
        x, y = np.cos(t), np.sin(t)
        return np.stack(
            [
                (scale + grow) * np.sign(x) * np.abs(x) ** power,
                0.78 * (scale + grow) * np.sign(y) * np.abs(y) ** power,
            ],
            1,
        )

    stands = [
        plate(
            oval(0.94 - 0.075 * k),
            0.05 + 0.36 - 0.06 * k,
            (0, 0, (0.41 - 0.06 * k) / 2 - 0.01),
            FLAT,
            [oval(0.5)],
        )
        for k in range(6)
    ]
    walls = [plate(oval(1.0), 0.46, (0, 0, 0.22), FLAT, [oval(0.92)])]
    ribs = []
    for a in np.arange(32) * 2 * np.pi / 32:
        x, y = np.cos(a), np.sin(a)
        at = np.array([1.0 * np.sign(x) * abs(x) ** 0.72, 0.78 * np.sign(y) * abs(y) ** 0.72])
        ribs.append(rod((*at, 0.0), (*(1.04 * at), 0.6), 0.022))
        ribs.append(rod((*(1.04 * at), 0.6), (*(0.74 * at), 0.68), 0.018))
    roof = [
        plate(oval(1.06), 0.03, (0, 0, 0.6), FLAT, [oval(0.86)]),
        plate(oval(0.9), 0.03, (0, 0, 0.64), FLAT, [oval(0.72)]),
    ]
    pitch = [plate(oval(0.52), 0.05, (0, 0, 0.01))]
    lines = [box((0.62, 0.012, 0.012), (0, y, 0.037)) for y in (-0.22, 0.22)]
    lines += [box((0.012, 0.452, 0.012), (x, 0, 0.037)) for x in (-0.31, 0.0, 0.31)]
    lines += [ring(0.075, 0.008, (0, 0, 0.036))]
    lights = []
    for x, y in ((0.92, 0.6), (-0.92, 0.6), (0.92, -0.6), (-0.92, -0.6)):
        lights += [
            rod((x, y, 0.2), (1.02 * x, 1.02 * y, 0.98), 0.022),
            box(
                (0.2, 0.05, 0.13),
                (1.02 * x, 1.02 * y, 1.0),
                0.01,
                (0, 0, np.degrees(np.arctan2(-x, y)) if y > 0 else np.degrees(np.arctan2(x, -y))),
            ),
        ]
    return {
        "walls": walls,
        "stands": stands,
        "roof": roof,
        "ribs": [*ribs, *lights],
        "pitch": pitch,
        "lines": lines,
    }


def _hedge_maze(draw: Draw) -> Parts:
    n = 9
    rng = np.random.default_rng(draw.which(1000))
    seen, walls = {(0, 0)}, {(x, y, d) for x in range(n) for y in range(n) for d in "es"}
    stack = [(0, 0)]
    while stack:
        x, y = stack[-1]
        near = [
            (x + a, y + b)
            for a, b in ((1, 0), (-1, 0), (0, 1), (0, -1))
            if 0 <= x + a < n and 0 <= y + b < n and (x + a, y + b) not in seen
        ]
        if not near:
            stack.pop()
            continue
        u, v = near[int(rng.integers(len(near)))]
        walls.discard((min(x, u), y, "e") if u != x else (x, min(y, v), "s"))
        seen.add((u, v))
        stack.append((u, v))
    size = 0.2
    start = -n * size / 2
    hedges = []
    for x, y, d in sorted(walls):
        if d == "e" and x < n - 1:
            hedges.append(
                box(
                    (0.08, size + 0.08, 0.2),
                    (start + (x + 1) * size, start + (y + 0.5) * size, 0.1),
                    0.02,
                )
            )
        if d == "s" and y < n - 1:
            hedges.append(
                box(
                    (size + 0.08, 0.08, 0.2),
                    (start + (x + 0.5) * size, start + (y + 1) * size, 0.1),
                    0.02,
                )
            )
    rim = n * size
    hedges += [box((0.09, rim + 0.09, 0.22), (s * rim / 2, 0, 0.11), 0.02) for s in (-1, 1)]
    for s in (-1, 1):
        gap = -s * (rim / 2 - size / 2)
        hedges.append(
            box(
                (rim - size, 0.09, 0.22),
                (gap - np.sign(gap) * rim / 2 if False else s * size / 2, s * rim / 2, 0.11),
                0.02,
            )
        )
    ground = [box((rim + 0.5, rim + 0.5, 0.06), (0, 0, -0.02), 0.012)]
    path = [
        box((rim, rim, 0.03), (0, 0, 0.005)),
        *(
            box((size - 0.06, 0.3, 0.03), (-s * (rim / 2 - size / 2), s * (rim / 2 + 0.1), 0.006))
            for s in (-1, 1)
        ),
    ]
    balls = [
        ball(0.085, (-s * (rim / 2 - size / 2) + a * 0.15, s * rim / 2, 0.27))
        for s in (-1, 1)
        for a in (-1, 1)
    ]
    return {"hedges": [*hedges, *balls], "path": path, "ground": ground}


def _train_tracks(draw: Draw) -> Parts:
    count = 11 + draw.which(3)
    long = 0.2 * count
    bed = [(-0.62, 0), (0.62, 0), (0.46, 0.12), (-0.46, 0.12)]
    sleepers = [
        box((0.86, 0.1, 0.07), (0, -long / 2 + 0.2 * (k + 0.5), 0.135), 0.012) for k in range(count)
    ]
    rail = [
        (-0.05, 0),
        (0.05, 0),
        (0.05, 0.02),
        (0.016, 0.03),
        (0.016, 0.08),
        (0.034, 0.085),
        (0.034, 0.115),
        (-0.034, 0.115),
        (-0.034, 0.085),
        (-0.016, 0.08),
        (-0.016, 0.03),
        (-0.05, 0.02),
    ]
    rails = both_sides([plate(rail, long + 0.06, (0.29, 0, 0.165), FRONT)])
    spikes = both_sides(
        [
            ball(0.018, (0.29 + s * 0.055, -long / 2 + 0.2 * (k + 0.5), 0.182))
            for k in range(count)
            for s in (-1, 1)
        ]
    )
    stones = []
    rng = np.random.default_rng(draw.which(1000))
    for _ in range(90):
        x, y = rng.uniform(-0.56, 0.56), rng.uniform(-long / 2 + 0.04, long / 2 - 0.04)
        z = min(0.12, (0.62 - abs(x)) * 0.75)
        stones.append(ball(tuple(rng.uniform(0.022, 0.042, 3)), (x, y, z)))
    return {
        "rails": rails,
        "sleepers": sleepers,
        "bed": [plate(bed, long + 0.04, (0, 0, 0), FRONT), *stones],
        "spikes": spikes,
    }


def _ziggurat(draw: Draw) -> Parts:
    tiers = 4 + draw.which(2)
    stone, steps = [], []
    side, z = 1.0, 0.0
    for k in range(tiers):
        high = 0.24 - 0.02 * k
        square = np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)], float)
        for m in range(6):
            stone.append(
                plate(
                    square * (side - 0.012 * m), high / 6 + 0.006, (0, 0, z + (m + 0.5) * high / 6)
                )
            )
        stone += spun(
            [
                box((0.05, 0.04, high - 0.02), (x, -side + 0.02, z + high / 2), 0.004)
                for x in np.linspace(-side + 0.12, side - 0.12, 9 - k)
            ],
            4,
        )
        stone.append(plate(square * (side - 0.045), 0.03, (0, 0, z + high)))
        z += high
        side -= 0.19
    rise = z
    count = 26
    run = 1.0 - side - 0.05
    steps += [
        box(
            (0.26, 0.11, 0.06 + rise * (k + 1) / count),
            (0, -1.14 + (run + 0.1) * (k + 0.5) / count, (rise * (k + 1) / count) / 2),
            0.002,
        )
        for k in range(count)
    ]
    for s in (-1, 1):
        edge = [
            (-1.2, 0),
            (-1.14, 0.06),
            (-1.14 + run + 0.14, rise + 0.06),
            (-1.14 + run + 0.14, 0),
        ]
        steps.append(plate(edge, 0.06, (s * 0.155, 0, 0), SIDE))
    temple = [
        plate(
            [
                (-0.16, 0),
                (-0.06, 0),
                (-0.06, 0.13),
                (0.06, 0.13),
                (0.06, 0),
                (0.16, 0),
                (0.16, 0.24),
                (-0.16, 0.24),
            ],
            0.3,
            (0, 0.04, z),
            FRONT,
        ),
        box((0.36, 0.36, 0.05), (0, 0.04, z + 0.25), 0.006),
    ]
    temple += [box((0.28, 0.03, 0.2), (0, 0.16, z + 0.1))]
    ground = [box((2.4, 2.5, 0.05), (0, -0.06, -0.01), 0.008)]
    return {"tiers": stone, "stairs": steps, "temple": temple, "ground": ground}


def _water_wheel(draw: Draw) -> Parts:
    count = 12 + 2 * draw.which(2)
    r, wide = 0.62, 0.3
    rims, spokes, paddles = [], [], []
    for x in (-wide / 2, wide / 2):
        rims.append(
            turned(
                [(r - 0.07, -0.025), (r + 0.01, -0.025), (r + 0.01, 0.025), (r - 0.07, 0.025)],
                (x, 0, 0),
                "x",
            )
        )
        spokes += moved(
            spun([box((0.04, 0.05, r - 0.05), (0, 0, r / 2), 0.006)], 8, "x"), (x, 0, 0)
        )
    paddles = spun(
        [box((wide + 0.06, 0.03, 0.2), (0, 0, r + 0.01), 0.006, (-18, 0, 0))], count, "x"
    )
    spokes += [
        rod((-wide - 0.16, 0, 0), (wide + 0.16, 0, 0), 0.055),
        *(rod((x - 0.05, 0, 0), (x + 0.05, 0, 0), 0.12, rim=0.01) for x in (-wide / 2, wide / 2)),
    ]
    frame = []
    for x in (-wide - 0.06, wide + 0.06):
        frame += [rod((x, s * 0.5, -0.86), (x, s * 0.03, 0.06), 0.045) for s in (-1, 1)]
        frame += [
            box((0.1, 1.2, 0.08), (x, 0, -0.86), 0.01),
            box((0.08, 0.62, 0.06), (x, 0, -0.42), 0.008),
            box((0.12, 0.2, 0.14), (x, 0, 0.02), 0.015),
        ]
    frame += [box((2 * wide + 0.2, 0.09, 0.07), (0, y, -0.85), 0.01) for y in (-0.54, 0.54)]
    top = r + 0.18
    frame += [
        box((0.34, 0.6, 0.03), (0, 0.5, top), 0.004),
        *both_sides(
            [
                box((0.03, 0.6, 0.1), (0.155, 0.5, top + 0.04), 0.004),
                rod((0.14, 0.74, top), (wide + 0.06, 0.52, -0.84), 0.03),
            ]
        ),
    ]
    water = [box((0.28, 0.58, 0.06), (0, 0.5, top + 0.035))]
    fall = [
        (0.22, top + 0.03),
        (0.1, top + 0.02),
        (0.03, top - 0.06),
        (0.04, top - 0.12),
        (0.1, top - 0.1),
        (0.24, top - 0.0),
    ]
    water += [plate(fall, 0.24, (0, 0, 0), SIDE)]
    return {"rims": rims, "paddles": paddles, "spokes": spokes, "frame": frame, "water": water}


def _oil_rig(draw: Draw) -> Parts:
    legs, deck, derrick, yellow = [], [], [], []
    for x in (-0.5, 0.5):
        for y in (-0.4, 0.4):
            legs += [
                rod((x, y, -0.7), (x, y, 0.1), 0.075),
                rod((x, y, -0.74), (x, y, -0.64), 0.13, 0.11, 0.01),
            ]
    for z in (-0.45, -0.1):
        legs += [rod((-0.5, y, z), (0.5, y, z), 0.028) for y in (-0.4, 0.4)] + [
            rod((x, -0.4, z), (x, 0.4, z), 0.028) for x in (-0.5, 0.5)
        ]
    legs += [
        rod((-s * 0.5, y, -0.45), (s * 0.5, y, -0.1), 0.02) for s in (-1, 1) for y in (-0.4, 0.4)
    ]
    legs += [
        rod((x, -s * 0.4, -0.45), (x, s * 0.4, -0.1), 0.02) for s in (-1, 1) for x in (-0.5, 0.5)
    ]
    deck += [
        box((1.3, 1.06, 0.1), (0, 0, 0.1), 0.01),
        box((1.16, 0.94, 0.06), (0, 0, 0.01), 0.01),
        box((0.5, 0.4, 0.22), (-0.34, -0.22, 0.25), 0.015),
        box((0.36, 0.34, 0.14), (-0.38, -0.22, 0.42), 0.012),
    ]
    deck += [
        box((0.4, 0.26, 0.16), (0.38, -0.3, 0.22), 0.012),
        rod((0.34, 0.3, 0.14), (0.34, 0.3, 0.36), 0.11, rim=0.02),
        rod((0.54, 0.3, 0.14), (0.54, 0.3, 0.34), 0.08, rim=0.02),
    ]
    rail = []
    for a, b in (
        ((-0.63, -0.51), (0.63, -0.51)),
        ((0.63, -0.51), (0.63, 0.51)),
        ((0.63, 0.51), (-0.63, 0.51)),
        ((-0.63, 0.51), (-0.63, -0.51)),
    ):
        rail += [rod((*a, z), (*b, z), 0.011) for z in (0.2, 0.25)]
        rail += [rod((*p, 0.14), (*p, 0.255), 0.011) for p in np.linspace(a, b, 8)[:-1]]
    foot, top, high = 0.2, 0.06, draw(0.95, 1.1)
    base = np.array([0.02, 0.12, 0.14])
    corners = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
    levels = np.linspace(0, 1, 7)
    for a, b in zip(corners, [*corners[1:], corners[0]], strict=True):
        pts = [
            (
                base
                + np.array(
                    [(foot + (top - foot) * f) * a[0], (foot + (top - foot) * f) * a[1], high * f]
                ),
                base
                + np.array(
                    [(foot + (top - foot) * f) * b[0], (foot + (top - foot) * f) * b[1], high * f]
                ),
            )
            for f in levels
        ]
        derrick += [capsule(pts[0][0], pts[-1][0], 0.02)]
        derrick += [rod(p, q, 0.012) for p, q in pts]
        derrick += [rod(pts[k][k % 2], pts[k + 1][1 - k % 2], 0.011) for k in range(6)]
    derrick += [
        box((0.2, 0.2, 0.05), tuple(base + (0, 0, high)), 0.008),
        rod(tuple(base), tuple(base + (0, 0, high)), 0.014),
        box((0.08, 0.08, 0.12), tuple(base + (0, 0, 0.55 * high)), 0.01),
    ]
    legs += [rod((0.02, 0.12, -0.72), (0.02, 0.12, 0.06), 0.04)]
    yellow += [
        rod((0.5, -0.34, 0.28), (0.5, -0.34, 0.46), 0.05),
        box((0.12, 0.12, 0.1), (0.5, -0.34, 0.48), 0.012),
        capsule((0.5, -0.34, 0.5), (0.94, -0.62, 0.86), 0.024),
        rod((0.93, -0.61, 0.85), (0.93, -0.61, 0.5), 0.0095),
        box((0.05, 0.05, 0.06), (0.93, -0.61, 0.5), 0.01),
    ]
    yellow += [
        rod((-0.66, 0.36, 0.16), (-1.0, 0.5, 0.5), 0.016),
        rod((-0.5, 0.36, 0.12), (-0.68, 0.37, 0.17), 0.03),
    ]
    pad = [
        rod((-0.56, 0.3, 0.36), (-0.56, 0.3, 0.4), 0.24, rim=0.008),
        rod((-0.5, 0.3, 0.12), (-0.52, 0.3, 0.37), 0.04),
    ]
    mark = [
        box((0.03, 0.2, 0.016), (-0.62, 0.3, 0.402)),
        box((0.03, 0.2, 0.016), (-0.5, 0.3, 0.402)),
        box((0.12, 0.03, 0.016), (-0.56, 0.3, 0.402)),
        ring(0.2, 0.01, (-0.56, 0.3, 0.4)),
    ]
    flame = [
        turned([(0, -0.02), (0.04, 0.02), (0.05, 0.07), (0.02, 0.15), (0, 0.19)], (-1.0, 0.5, 0.5))
    ]
    return {
        "legs": legs,
        "deck": [*deck, *rail],
        "derrick": derrick,
        "crane": yellow,
        "pad": pad,
        "markings": mark,
        "flame": flame,
    }


MONUMENTS: dict[str, Callable[[Draw], Parts]] = {
    "statue of liberty": _statue_of_liberty,
    "colosseum": _colosseum,
    "leaning tower of pisa": _leaning_tower,
    "taj mahal": _taj_mahal,
    "big ben": _big_ben,
    "sphinx": _sphinx,
    "suspension bridge": _suspension_bridge,
    "tower bridge": _tower_bridge,
    "aqueduct": _aqueduct,
    "stadium": _stadium,
    "hedge maze": _hedge_maze,
    "train tracks": _train_tracks,
    "ziggurat": _ziggurat,
    "water wheel": _water_wheel,
    "oil rig": _oil_rig,
}
