"""Big Ben, a sphinx, a ziggurat and other large works of stone."""

from collections.abc import Callable

import numpy as np

from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.pieces import SQUARE, arch_opening
from core.guidance.builtin.constructed.shapes import (
    FRONT,
    SIDE,
    Parts,
    ball,
    both_sides,
    box,
    capsule,
    pipe,
    plate,
    rod,
    spun,
    turned,
)


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
            [arch_opening(0.07, 0.15) + (x, 0.02) for x in (-0.12, 0, 0.12)],
        )
    ]
    stone += spun(belfry, 4)
    stone += [box((0.26, 0.26, 0.2), (0, 0, high + 0.56))]
    top = high + 0.66
    roof = [
        plate(SQUARE * (0.21 - 0.011 * k), 0.032, (0, 0, top + 0.012 + 0.03 * k)) for k in range(9)
    ]
    mid = top + 0.26
    roof += [box((0.22, 0.22, 0.1), (0, 0, mid + 0.04), 0.006)]
    roof += [
        plate(SQUARE * (0.115 - 0.0105 * k), 0.038, (0, 0, mid + 0.1 + 0.036 * k))
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
    bands = both_sides(
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


def _aqueduct(draw: Draw) -> Parts:
    count = 5 + draw.which(2)
    wide = 0.44
    total = count * wide
    big, small = arch_opening(0.32, 0.62), arch_opening(0.105, 0.16)
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
        hedges.append(
            box(
                (rim - size, 0.09, 0.22),
                (s * size / 2, s * rim / 2, 0.11),
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


def _ziggurat(draw: Draw) -> Parts:
    tiers = 4 + draw.which(2)
    stone, steps = [], []
    side, z = 1.0, 0.0
    for k in range(tiers):
        high = 0.24 - 0.02 * k
        for m in range(6):
            stone.append(
                plate(
                    SQUARE * (side - 0.012 * m), high / 6 + 0.006, (0, 0, z + (m + 0.5) * high / 6)
                )
            )
        stone += spun(
            [
                box((0.05, 0.04, high - 0.02), (x, -side + 0.02, z + high / 2), 0.004)
                for x in np.linspace(-side + 0.12, side - 0.12, 9 - k)
            ],
            4,
        )
        stone.append(plate(SQUARE * (side - 0.045), 0.03, (0, 0, z + high)))
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


MONUMENTS_OF_STONE: dict[str, Callable[[Draw], Parts]] = {
    "big ben": _big_ben,
    "sphinx": _sphinx,
    "aqueduct": _aqueduct,
    "hedge maze": _hedge_maze,
    "ziggurat": _ziggurat,
}
