"""Things of pets and of a terrace."""

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
    moved,
    pipe,
    plate,
    ring,
    rod,
    spun,
    turned,
)


def _cat_tree(draw: Draw) -> Parts:
    tall = draw(1.3, 1.5)
    posts = [(-0.32, -0.2, 0.55), (0.3, -0.16, 0.85), (0.0, 0.24, tall)]
    sisal, carpet, toys = [], [], []
    for x, y, z in posts:
        sisal += [
            rod((x, y, 0.04), (x, y, z), 0.06),
            *(ring(0.058, 0.014, (x, y, h)) for h in np.arange(0.1, z - 0.04, 0.05)),
        ]
    carpet += [box((1.1, 0.85, 0.08), (0, 0, 0.04), 0.03)]
    carpet += [
        rod((-0.32, -0.2, 0.53), (-0.32, -0.2, 0.59), 0.25, rim=0.02),
        rod((0.3, -0.16, 0.83), (0.3, -0.16, 0.89), 0.24, rim=0.02),
    ]
    carpet += [
        turned(
            [(0, 0), (0.28, 0), (0.32, 0.12), (0.28, 0.13), (0.24, 0.07), (0, 0.06)],
            (0, 0.24, tall - 0.03),
        )
    ]
    house = [box((0.5, 0.44, 0.42), (0.22, 0.14, 0.28), 0.04)]
    door = [rod((0.22, -0.075, 0.28), (0.22, -0.095, 0.28), 0.13)]
    ears = both_sides([rod((0.19, 0.24, tall), (0.25, 0.22, tall + 0.28), 0.1, 0.012)])
    toys += [
        rod((-0.48, -0.3, 0.57), (-0.48, -0.3, 0.38), 0.012),
        ball(0.055, (-0.48, -0.3, 0.36)),
        rod((0.46, -0.26, 0.86), (0.46, -0.26, 0.68), 0.012),
        ball(0.05, (0.46, -0.26, 0.66)),
    ]
    ladder = [rod((x, -0.42, 0.06), (x, -0.36, 0.56), 0.022) for x in (-0.42, -0.22)] + [
        rod((-0.43, -0.41 + 0.05 * f, z), (-0.21, -0.41 + 0.05 * f, z), 0.018)
        for f, z in ((0.2, 0.16), (0.5, 0.3), (0.8, 0.44))
    ]
    return {
        "carpet": [*carpet, *house, *ears],
        "posts": [*sisal, *ladder],
        "opening": door,
        "toys": toys,
    }


def _hamster_wheel(draw: Draw) -> Parts:
    r, wide = 0.62, 0.36
    rims = [
        turned(
            [(r - 0.035, -0.03), (r + 0.02, -0.03), (r + 0.02, 0.03), (r - 0.035, 0.03)],
            (0, y, 0),
            "y",
        )
        for y in (-wide / 2, wide / 2)
    ]
    rungs = spun([rod((0, -wide / 2, -r), (0, wide / 2, -r), 0.02)], 32, "y")
    spokes = moved(spun([rod((0, 0, 0), (0, 0, r - 0.02), 0.018)], 6, "y"), (0, wide / 2, 0))
    spokes += [
        rod((0, -0.1, 0), (0, wide / 2 + 0.14, 0), 0.035),
        rod((0, wide / 2 - 0.03, 0), (0, wide / 2 + 0.03, 0), 0.09, rim=0.01),
    ]
    stand = [
        pipe(
            [
                (s * 0.5, wide / 2 + 0.1, -0.78),
                (s * 0.34, wide / 2 + 0.12, -0.3),
                (0, wide / 2 + 0.12, 0.02),
            ],
            0.035,
        )
        for s in (-1, 1)
    ]
    stand += [box((1.15, 0.62, 0.06), (0, 0.1, -0.8), 0.03)]
    z = -r + 0.17
    fur = [
        ball((0.2, 0.15, 0.16), (0.02, 0, z)),
        ball((0.12, 0.115, 0.11), (-0.18, 0, z + 0.06)),
        *(ball((0.02, 0.04, 0.045), (-0.16, y, z + 0.17)) for y in (-0.08, 0.08)),
        ball(0.03, (0.22, 0, z - 0.02)),
    ]
    feet = [
        ball((0.045, 0.03, 0.03), (x, y, -r + 0.03)) for x in (-0.12, 0.12) for y in (-0.08, 0.08)
    ] + [ball(0.024, (-0.3, 0, z + 0.06))]
    eyes = [ball(0.022, (-0.265, y, z + 0.1)) for y in (-0.06, 0.06)]
    belly = [
        ball((0.15, 0.12, 0.1), (0.0, 0, z - 0.07)),
        *(ball((0.05, 0.03, 0.045), (-0.24, y, z + 0.02)) for y in (-0.06, 0.06)),
    ]
    del draw
    return {
        "wheel": [*rims, *rungs],
        "spokes": spokes,
        "stand": stand,
        "hamster": fur,
        "belly": belly,
        "paws": feet,
        "eyes": eyes,
    }


def _wind_chime(draw: Draw) -> Parts:
    count = 5 + draw.which(3)
    wood = [rod((0, 0, 0.9), (0, 0, 0.96), 0.3, rim=0.015)]
    tubes, strings = [], []
    for k in range(count):
        a = 2 * np.pi * k / count
        x, y, long = 0.22 * np.cos(a), 0.22 * np.sin(a), 0.62 + 0.07 * k
        strings.append(rod((x, y, 0.92), (x, y, 0.76), 0.0105))
        tubes += [rod((x, y, 0.8), (x, y, 0.8 - long), 0.042)]
    clapper = [rod((0, 0, 0.36), (0, 0, 0.42), 0.13, rim=0.015)]
    strings += [
        rod((0, 0, 0.92), (0, 0, -0.32), 0.0105),
        *(
            rod((0.24 * np.cos(a), 0.24 * np.sin(a), 0.95), (0, 0, 1.3), 0.0105)
            for a in np.arange(3) * 2 * np.pi / 3
        ),
        ring(0.05, 0.014, (0, 0, 1.34), "y"),
    ]
    sail = [
        plate(
            [(0, 0), (0.11, -0.12), (0.08, -0.36), (0, -0.44), (-0.08, -0.36), (-0.11, -0.12)],
            0.03,
            (0, 0, -0.26),
            FRONT,
        )
    ]
    strings += [rod((x, y, 0.9), (0, 0, 0.9), 0.014) for x, y in ((0.1, 0),)]
    stays = [
        rod((0.22 * np.cos(a), 0.22 * np.sin(a), 0.39), (0, 0, 0.39), 0.0105)
        for a in 2 * np.pi * np.arange(count) / count
    ]
    return {"disc": [*wood, *clapper], "tubes": tubes, "strings": [*strings, *stays], "sail": sail}


def _deck_chair(draw: Draw) -> Parts:
    lean = draw(0.85, 0.98)
    frame = both_sides(
        [
            rod((0.34, 0.52, 0.04), (0.34, -0.62, 0.42), 0.03),
            rod((0.3, -0.5, 0.04), (0.3, 0.66, lean), 0.03),
            rod((0.345, 0.16, 0.165), (0.325, 0.44, 0.04 + 0.81 * (lean - 0.04)), 0.026),
        ]
    )
    frame += [
        rod((-0.37, y, z), (0.37, y, z), 0.026)
        for y, z in (
            (0.52, 0.05),
            (-0.62, 0.42),
            (-0.5, 0.05),
            (0.66, lean),
            (0.44, 0.04 + 0.81 * (lean - 0.04)),
            (0.16, 0.17),
        )
    ]
    sag = np.array(
        [(-0.62, 0.43), (-0.4, 0.3), (-0.1, 0.24), (0.14, 0.32), (0.4, 0.6), (0.66, lean + 0.01)]
    )
    from_curve = np.array(
        [np.interp(np.linspace(0, 5, 26), np.arange(6), sag[:, k]) for k in (0, 1)]
    ).T
    smooth = np.array([from_curve[max(k - 2, 0) : k + 3].mean(0) for k in range(26)])
    smooth[0], smooth[-1] = sag[0], sag[-1]
    sheet = [*smooth, *(smooth - (0, 0.03))[::-1]]
    white, blue = [], []
    for k, x in enumerate(np.linspace(-0.24, 0.24, 7)):
        (blue if k % 2 else white).append(plate(sheet, 0.088, (x, 0, 0.006 * (k % 2)), SIDE))
    return {"cloth": white, "stripes": blue, "frame": frame}


def _cooler(draw: Draw) -> Parts:
    wide = draw(0.62, 0.72)
    body = [
        box((2 * wide, 0.8, 0.62), (0, 0, 0.35), 0.07),
        box((2 * wide - 0.1, 0.7, 0.1), (0, 0, 0.05), 0.03),
    ]
    lid = [
        box((2 * wide + 0.05, 0.85, 0.16), (0, 0, 0.73), 0.06),
        box((2 * wide - 0.24, 0.6, 0.05), (0, 0, 0.81), 0.02),
    ]
    handle = both_sides(
        [
            pipe(
                [
                    (wide, -0.22, 0.58),
                    (wide + 0.1, -0.22, 0.6),
                    (wide + 0.13, 0, 0.62),
                    (wide + 0.1, 0.22, 0.6),
                    (wide, 0.22, 0.58),
                ],
                0.03,
            ),
            box((0.06, 0.56, 0.1), (wide - 0.01, 0, 0.56), 0.02),
        ]
    )
    latch = [box((0.14, 0.06, 0.18), (x, -0.42, 0.63), 0.02) for x in (-0.34, 0.34)] + [
        rod((wide - 0.2, -0.38, 0.13), (wide - 0.2, -0.46, 0.13), 0.04, rim=0.01)
    ]
    stripe = [box((2 * wide + 0.012, 0.812, 0.09), (0, 0, 0.4), 0.075)]
    return {"body": body, "lid": lid, "handles": handle, "latches": latch, "stripe": stripe}


def _clothesline(draw: Draw) -> Parts:
    sag = draw(0.05, 0.1)
    posts = both_sides(
        [
            rod((1.2, 0, 0), (1.2, 0, 1.25), 0.04),
            rod((1.2, -0.22, 1.16), (1.2, 0.22, 1.16), 0.03),
            rod((1.2, 0, -0.02), (1.2, 0, 0.06), 0.14, 0.1, 0.02),
        ]
    )

    def line(x: float) -> float:
        return 1.16 - sag * (1 - (x / 1.2) ** 2)

    ropes = [
        pipe([(x, y, line(x)) for x in np.linspace(-1.2, 1.2, 9)], 0.014) for y in (-0.19, 0.19)
    ]
    shirt = [
        (-0.12, 0),
        (-0.06, -0.03),
        (0.06, -0.03),
        (0.12, 0),
        (0.27, -0.1),
        (0.22, -0.22),
        (0.14, -0.17),
        (0.15, -0.5),
        (-0.15, -0.5),
        (-0.14, -0.17),
        (-0.22, -0.22),
        (-0.27, -0.1),
    ]
    trousers = [
        (-0.13, 0),
        (0.13, 0),
        (0.17, -0.62),
        (0.04, -0.62),
        (0, -0.2),
        (-0.04, -0.62),
        (-0.17, -0.62),
    ]
    sock = [(-0.05, 0), (0.05, 0), (0.05, -0.2), (0.14, -0.24), (0.13, -0.3), (-0.04, -0.3)]
    red, blue, white = [], [], []
    pegs = []
    for x, outline, where, half in (
        (-0.72, shirt, red, 0.11),
        (0.0, trousers, blue, 0.12),
        (0.38, sock, white, 0.03),
        (0.56, sock, white, 0.03),
    ):
        where.append(plate(outline, 0.03, (x, -0.19, line(x) + 0.012), FRONT))
        pegs += [
            box((0.022, 0.05, 0.09), (x + s * half, -0.19, line(x)), 0.005)
            for s in ((-1, 1) if half > 0.05 else (0,))
        ]
    white += [
        plate(
            [(-0.34, 0), (0.34, 0), (0.34, -0.62), (-0.34, -0.62)],
            0.03,
            (-0.3, 0.19, line(-0.3) + 0.01),
            FRONT,
        )
    ]
    red += [
        plate(
            [(-0.2, 0), (0.2, 0), (0.2, -0.4), (-0.2, -0.4)],
            0.03,
            (0.62, 0.19, line(0.62) + 0.01),
            FRONT,
        )
    ]
    pegs += [
        box((0.022, 0.05, 0.09), (x, 0.19, line(x)), 0.005) for x in (-0.58, -0.02, 0.46, 0.78)
    ]
    return {
        "posts": posts,
        "lines": ropes,
        "shirt": red,
        "trousers": blue,
        "linen": white,
        "pegs": pegs,
    }


PETS_AND_TERRACE: dict[str, Callable[[Draw], Parts]] = {
    "cat tree": _cat_tree,
    "hamster wheel": _hamster_wheel,
    "wind chime": _wind_chime,
    "deck chair": _deck_chair,
    "cooler": _cooler,
    "clothesline": _clothesline,
}
