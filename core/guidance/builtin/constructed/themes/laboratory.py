"""Things of the laboratory and of the sky, and of a desk."""

from collections.abc import Callable

import numpy as np
from scipy.spatial.transform import Rotation

from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.shapes import (
    FRONT,
    Parts,
    ball,
    box,
    capsule,
    circle,
    curve,
    pipe,
    placed,
    plate,
    ring,
    rod,
    rounded,
    turned,
)


def _atom(draw: Draw) -> Parts:
    rng = np.random.default_rng(draw.which(1000))
    red, blue = [], []
    places = [
        (0.0, 0.0, 0.0),
        *(
            0.16 * np.array([np.cos(a) * np.sin(b), np.sin(a) * np.sin(b), np.cos(b)])
            for a, b in zip(
                2.4 * np.arange(13), np.arccos(np.linspace(0.95, -0.95, 13)), strict=True
            )
        ),
    ]
    for k, at in enumerate(places):
        (red if k % 2 else blue).append(ball(0.105 if k else 0.15, tuple(at)))
    orbits, electrons = [], []
    for tilt in (0.0, 60.0, 120.0):
        way = Rotation.from_euler("y", tilt, degrees=True).as_matrix()
        t = np.linspace(0, 2 * np.pi, 33)[:-1]
        loop = np.stack([0.95 * np.cos(t), -0.22 * np.sin(t), 0.36 * np.sin(t)], 1) @ way.T
        orbits.append(pipe(loop, 0.02, closed=True))
        a = rng.uniform(0, 2 * np.pi)
        electrons.append(
            ball(0.07, tuple(way @ (0.95 * np.cos(a), -0.22 * np.sin(a), 0.36 * np.sin(a))))
        )
    stays = [
        rod(
            (0, 0.08, 0),
            tuple(Rotation.from_euler("y", tilt, degrees=True).as_matrix() @ (0, 0.22, -0.36)),
            0.0125,
        )
        for tilt in (0.0, 60.0, 120.0)
    ]
    return {"protons": red, "neutrons": blue, "orbits": [*orbits, *stays], "electrons": electrons}


def _solar_system(draw: Draw) -> Parts:
    stand = [
        turned(
            [
                (0, -0.62),
                (0.34, -0.62),
                (0.32, -0.57),
                (0.12, -0.52),
                (0.05, -0.44),
                (0.05, -0.3),
                (0.08, -0.26),
                (0.04, -0.2),
                (0.04, 0.0),
                (0, 0.0),
            ]
        )
    ]
    sun = [ball(0.2, (0, 0, 0.06))]
    planets = (
        ("grey", 0.32, 0.042),
        ("orange", 0.44, 0.058),
        ("blue", 0.58, 0.062),
        ("red", 0.71, 0.05),
        ("orange", 0.9, 0.115),
        ("tan", 1.13, 0.095),
        ("blue", 1.33, 0.075),
        ("blue", 1.5, 0.072),
    )
    found = {"grey": [], "orange": [], "blue": [], "red": [], "tan": []}
    arms, rings = [], []
    for k, (colour, far, r) in enumerate(planets):
        a = 2.4 * k + draw(-0.3, 0.3)
        x, y = far * np.cos(a), far * np.sin(a)
        z = -0.08 - 0.028 * k
        arms += [
            rod((0, 0, z), (x, y, z), 0.0125),
            rod((x, y, z - 0.01), (x, y, 0.06), 0.0125),
            rod((0, 0, z - 0.014), (0, 0, z + 0.014), 0.06),
        ]
        found[colour].append(ball(r, (x, y, 0.06)))
        if colour == "tan":
            rings.append(
                plate(
                    circle(0.19),
                    0.02,
                    (x, y, 0.06),
                    Rotation.from_euler("x", 18, degrees=True).as_matrix(),
                    [circle(0.118)],
                )
            )
            rings.append(rod((x - 0.16, y, 0.06), (x + 0.16, y, 0.06), 0.0125))
    return {
        "sun": sun,
        "stand": [*stand, *arms],
        "inner planets": [*found["grey"], *found["orange"]],
        "ocean planets": found["blue"],
        "desert planet": found["red"],
        "ringed planet": [*found["tan"], *rings],
    }


def _beaker(draw: Draw) -> Parts:
    r, high = 0.36, draw(0.86, 1.0)
    glass = [
        turned(
            [
                (0, 0),
                (r - 0.03, 0),
                (r, 0.04),
                (r, high - 0.04),
                (r + 0.05, high),
                (r + 0.03, high + 0.015),
                (r - 0.03, high - 0.03),
                (r - 0.03, 0.5 * high),
                (0, 0.5 * high),
            ]
        )
    ]
    glass += [
        plate(
            [(-0.07, 0), (0.07, 0), (0.0, 0.12)],
            0.04,
            (r, 0, high - 0.01),
            np.array([[0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, -1.0]]),
        )
    ]
    liquid = [rod((0, 0, 0.035), (0, 0, 0.52 * high), r + 0.006, rim=0.02)]
    marks = []
    for k, z in enumerate(np.linspace(0.16, 0.84, 9) * high):
        turn = np.linspace(-1.9, -1.9 + (0.7 if k % 2 == 0 else 0.4), 6)
        marks.append(
            pipe([((r + 0.006) * np.cos(a), (r + 0.006) * np.sin(a), z) for a in turn], 0.011)
        )
    bubbles = [
        ball(s, (0.2 * np.cos(a), 0.2 * np.sin(a), 0.52 * high + 0.01))
        for a, s in ((0.4, 0.05), (1.7, 0.07), (3.0, 0.045), (4.4, 0.06), (5.4, 0.04))
    ]
    return {"glass": glass, "liquid": liquid, "marks": marks, "bubbles": bubbles}


def _bunsen_burner(draw: Draw) -> Parts:
    high = draw(0.82, 0.95)
    base = [
        turned([(0, 0), (0.38, 0), (0.39, 0.05), (0.3, 0.1), (0.12, 0.15), (0.1, 0.2), (0, 0.2)])
    ]
    tube = [
        rod((0, 0, 0.18), (0, 0, high), 0.075),
        rod((0, 0, 0.22), (0, 0, 0.4), 0.1, rim=0.01),
        rod((0, 0, high - 0.05), (0, 0, high + 0.01), 0.09, rim=0.01),
        rod((0.06, 0, 0.2), (0.3, 0, 0.2), 0.05),
        *(rod((x - 0.012, 0, 0.2), (x + 0.012, 0, 0.2), 0.06, rim=0.004) for x in (0.22, 0.27)),
    ]
    holes = [
        rod((0, -0.09, 0.3), (0, -0.106, 0.3), 0.036),
        rod((0.09, 0.04, 0.3), (0.106, 0.045, 0.3), 0.03),
        rod((-0.09, 0.04, 0.3), (-0.106, 0.045, 0.3), 0.03),
    ]
    hose = [
        pipe(
            [
                (0.27, 0, 0.2),
                (0.46, 0, 0.18),
                (0.58, -0.1, 0.08),
                (0.74, -0.3, 0.055),
                (0.9, -0.34, 0.055),
            ],
            0.055,
        )
    ]
    outer = [
        turned(
            [
                (0, high - 0.02),
                *curve(
                    [(0.06, high), (0.1, high + 0.16), (0.06, high + 0.42), (0.012, high + 0.62)]
                ),
                (0, high + 0.63),
            ]
        )
    ]
    inner = [
        turned(
            [
                (0, high),
                *curve([(0.075, high + 0.005), (0.108, high + 0.12), (0.09, high + 0.24)]),
                (0, high + 0.22),
            ]
        )
    ]
    return {"base": base, "tube": tube, "holes": holes, "hose": hose, "flame": outer, "core": inner}


def _petri_dish(draw: Draw) -> Parts:
    rng = np.random.default_rng(draw.which(1000))
    dish = [
        turned(
            [(0, 0), (0.6, 0), (0.62, 0.02), (0.62, 0.16), (0.58, 0.16), (0.58, 0.06), (0, 0.06)]
        )
    ]
    gel = [rod((0, 0, 0.04), (0, 0, 0.1), 0.59)]
    spots, green = [], []
    for k in range(26):
        a, d = rng.uniform(0, 2 * np.pi), 0.5 * np.sqrt(rng.uniform())
        r = float(rng.uniform(0.022, 0.07))
        (green if k % 3 == 0 else spots).append(
            ball((r, r, 0.03), (d * np.cos(a), d * np.sin(a), 0.1))
        )
    lid = placed(
        [turned([(0, 0), (0.66, 0), (0.66, 0.12), (0.63, 0.12), (0.63, 0.035), (0, 0.035)])],
        Rotation.from_euler("x", 62, degrees=True).as_matrix(),
        (0.1, 0.66, 0.59),
    )
    return {"dish": [*dish, *lid], "gel": gel, "colonies": spots, "mould": green}


def _prism(draw: Draw) -> Parts:
    side = draw(0.5, 0.56)
    triangle = np.array([(-side, 0), (side, 0), (0, 1.732 * side)])
    glass = [
        plate(triangle, 0.5, (0, 0, 0), FRONT),
        plate(0.97 * triangle + (0, 0.01), 0.53, (0, 0, 0), FRONT),
    ]
    left = np.array([-0.52 * side, 0.83 * side])
    right = np.array([0.5 * side, 0.82 * side])
    beams = [
        capsule((left[0] - 0.9, -0.02, left[1] - 0.4), (left[0] + 0.02, -0.02, left[1]), 0.026)
    ]
    found = {f"{name} ray": [] for name in ("inner", "second", "third", "fourth", "fifth", "outer")}
    for k, name in enumerate(found):
        a = np.radians(-6 - 7 * k)
        start = right + (0.0 + 0.01 * k, 0.05 - 0.032 * k)
        end = start + 0.95 * np.array([np.cos(a), np.sin(a)])
        normal = np.array([-np.sin(a), np.cos(a)])
        found[name].append(
            plate(
                [
                    start + 0.02 * normal,
                    start - 0.02 * normal,
                    end - 0.062 * normal,
                    end + 0.062 * normal,
                ],
                0.05,
                (0, -0.02, 0),
                FRONT,
            )
        )
        found[name].append(
            rod(
                (right[0] - 0.1, -0.02, right[1] - 0.02),
                (*start[:1] + 0.02, -0.02, start[1]),
                0.013,
            )
        )
    return {"glass": glass, "light": beams, **found}


def _thermometer(draw: Draw) -> Parts:
    level = draw(0.1, 0.5)
    board = [plate(rounded((0.42, 1.9), 0.2, (0, 0)), 0.08, (0, 0.03, 0), FRONT)]
    tube = [capsule((0, -0.035, -0.6), (0, -0.035, 0.76), 0.055)]
    red = [
        ball((0.105, 0.07, 0.105), (0, -0.045, -0.68)),
        capsule((0, -0.062, -0.66), (0, -0.062, level), 0.036),
    ]
    marks = [
        box(
            (0.12 if k % 5 == 0 else 0.07, 0.018, 0.014),
            (0.12 if k % 5 else 0.135, -0.015, -0.5 + 0.06 * k),
        )
        for k in range(21)
    ]
    marks += [
        box(
            (0.12 if k % 5 == 0 else 0.07, 0.018, 0.014),
            (-0.12 if k % 5 else -0.135, -0.015, -0.5 + 0.06 * k),
        )
        for k in range(21)
    ]
    hang = [
        ring(0.05, 0.016, (0, 0.03, 0.98), "y"),
        *(box((0.26, 0.05, 0.03), (0, -0.03, z), 0.008) for z in (-0.54, 0.7)),
    ]
    return {"board": board, "tube": tube, "mercury": red, "marks": marks, "clips": hang}


def _galaxy(draw: Draw) -> Parts:
    rng = np.random.default_rng(draw.which(1000))
    core = [ball((0.24, 0.24, 0.12)), ball((0.34, 0.34, 0.06))]
    arms, dust, stars = [], [], []
    for k in range(2):
        t = np.linspace(0.0, 2 * np.pi * 0.95, 36)
        r = 0.2 + 0.13 * t
        for j, (a, d) in enumerate(zip(t + np.pi * k, r, strict=True)):
            wide = 0.13 * (1 - 0.55 * j / 36)
            at = np.array([d * np.cos(a), d * np.sin(a), 0])
            arms.append(
                ball((1.8 * wide, 0.9 * wide, 0.045), tuple(at), (0, 0, np.degrees(a) + 90))
            )
            inner = 0.94 * at
            dust.append(
                ball(
                    (0.8 * wide, 0.5 * wide, 0.04),
                    (inner[0], inner[1], 0.012),
                    (0, 0, np.degrees(a) + 90),
                )
            )
            for _ in range(2):
                stars.append(
                    ball(
                        float(rng.uniform(0.0125, 0.026)),
                        tuple(
                            at + (*rng.uniform(-0.7, 0.7, 2) * wide, rng.choice([-1, 1]) * 0.036)
                        ),
                    )
                )
    tilt = Rotation.from_euler("x", 24, degrees=True).as_matrix()
    return {
        name: placed(own, tilt)
        for name, own in {"core": core, "arms": arms, "dust": dust, "stars": stars}.items()
    }


def _comet(draw: Draw) -> Parts:
    rng = np.random.default_rng(draw.which(1000))
    rock = [ball((0.26, 0.24, 0.23))]
    for _ in range(16):
        way = rng.normal(size=3)
        way /= np.linalg.norm(way)
        rock.append(ball(tuple(rng.uniform(0.07, 0.12, 3)), tuple(0.19 * way)))
    glow, tail = [], []
    for k in range(15):
        a = 2.4 * k
        d = 0.06 + 0.17 * np.sqrt((k + 0.5) / 15)
        long = (1.5 - 0.9 * d / 0.24) * rng.uniform(0.85, 1.1)
        end = np.array([long, 0.5 * d * np.cos(a), 0.42 * long + 0.5 * d * np.sin(a)])
        (tail if k % 2 else glow).append(
            rod((0.02, d * np.cos(a), d * np.sin(a)), tuple(end), 0.11, 0.012)
        )
    return {"rock": rock, "flames": glow, "tail": tail}


LABORATORY: dict[str, Callable[[Draw], Parts]] = {
    "atom": _atom,
    "solar system": _solar_system,
    "beaker": _beaker,
    "bunsen burner": _bunsen_burner,
    "petri dish": _petri_dish,
    "prism": _prism,
    "thermometer": _thermometer,
    "galaxy": _galaxy,
    "comet": _comet,
}
