"""Things of a desk, a laboratory and a workshop."""

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
    circle,
    pipe,
    placed,
    plate,
    ring,
    rod,
    rounded,
    spun,
    turned,
)


def _dna_helix(draw: Draw) -> Parts:
    turns, high, radius = draw(1.6, 2.1), 2.2, 0.42
    t = np.linspace(0, 1, 28)
    angle = 2 * np.pi * turns * t
    strands = [
        pipe(
            [
                (radius * np.cos(a + by), radius * np.sin(a + by), high * u)
                for a, u in zip(angle, t, strict=True)
            ],
            0.065,
        )
        for by in (0.0, 0.8 * np.pi)
    ]
    first, second = [], []
    for u in np.linspace(0.03, 0.97, round(11 * turns / 1.8)):
        a = 2 * np.pi * turns * u
        ends = [
            np.array([radius * np.cos(b), radius * np.sin(b), high * u])
            for b in (a, a + 0.8 * np.pi)
        ]
        middle = (ends[0] + ends[1]) / 2
        first.append(rod(tuple(ends[0]), tuple(middle), 0.034))
        second.append(rod(tuple(ends[1]), tuple(0.98 * middle + 0.02 * ends[0]), 0.034))
    return {"strands": strands, "bases": first, "pairs": second}


def _steering_wheel(draw: Draw) -> Parts:
    spokes = 3 + draw.which(2)
    spoke = [(-0.1, 0.0), (0.1, 0.0), (0.075, -0.56), (-0.075, -0.56)]
    turns = {3: (0, 115, 245), 4: (35, 145, 215, 325)}[spokes]
    arms = []
    for degrees in turns:
        c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
        turn = np.array([[c, 0.0, s], [0.0, 1.0, 0.0], [-s, 0.0, c]])
        arms += placed([plate(spoke, 0.05, (0, 0.02, 0), FRONT)], turn)
    grips = [
        ball((0.035, 0.05, 0.02), (0.55 * np.cos(a), 0.03, 0.55 * np.sin(a)))
        for a in np.linspace(-0.5, 0.5, 5)
    ]
    return {
        "rim": [ring(0.6, 0.062, (0, 0, 0), "y"), *both_sides(grips)],
        "spokes": arms,
        "hub": [ball((0.2, 0.09, 0.2), (0, 0.0, 0)), rod((0, 0.02, 0), (0, 0.34, 0), 0.09, 0.06)],
        "badge": [rod((0, -0.1, 0), (0, -0.05, 0), 0.07, 0.075, 0.01)],
    }


def _test_tubes(draw: Draw) -> Parts:
    count = 3 + draw.which(2)
    places = [0.3 * (k - (count - 1) / 2) for k in range(count)]
    long = 0.3 * count + 0.12
    profile = [
        (0, 0),
        (0.06, 0.015),
        (0.095, 0.06),
        (0.105, 0.11),
        (0.105, 0.95),
        (0.125, 0.955),
        (0.125, 0.99),
    ]
    inside = [(0.08, 0.99), (0.08, 0.11), (0.05, 0.05), (0, 0.04)]
    tubes = [turned([*profile, *inside], (x, 0, 0.08)) for x in places]
    liquid = []
    for x in places:
        level = draw(0.3, 0.55)  # below the upper shelf, where it is seen
        section = [(0, 0.015), (0.097, 0.058), (0.1075, 0.11), (0.1075, level), (0, level)]
        liquid.append(turned(section, (x, 0, 0.08)))
    holes = [circle(0.1, (x, 0)) for x in places]
    shelves = [
        plate(rounded((long, 0.36), 0.02), 0.05, (0, 0, 0.62), holes=holes),
        box((long, 0.36, 0.05), (0, 0, 0.04), 0.012),
        box((long, 0.36, 0.04), (0, 0, 0.1), 0.012),
    ]
    ends = both_sides([box((0.05, 0.36, 0.66), (long / 2, 0, 0.33), 0.012)])
    return {"rack": [*shelves, *ends], "tubes": tubes, "liquid": liquid}


def _propeller(draw: Draw) -> Parts:
    count = 3 + draw.which(2)
    half = np.linspace(0, 1, 14)
    wide = 0.19 * np.sin(np.pi * half**0.7) ** 0.8 + 0.03
    outline = np.concatenate(
        [
            np.stack([wide, 0.12 + 0.85 * half], 1),
            np.stack([-0.6 * wide, 0.12 + 0.85 * half], 1)[::-1],
        ]
    )
    c, s = np.cos(np.radians(28)), np.sin(np.radians(28))
    twist = np.array([[c, 0.0, -s], [s, 0.0, c], [0.0, 1.0, 0.0]])
    twist[:, 2] = np.cross(twist[:, 0], twist[:, 1])
    blades = spun([plate(outline, 0.045, (0, 0, 0), twist)], count, "y")
    return {
        "blades": blades,
        "hub": [
            rod((0, -0.1, 0), (0, 0.16, 0), 0.17, 0.17, 0.03),
            ball((0.15, 0.22, 0.15), (0, -0.1, 0)),
        ],
        "bolts": spun([rod((0.12, 0.12, 0), (0.12, 0.18, 0), 0.025)], 6, "y"),
    }


def _life_ring(draw: Draw) -> Parts:
    tube = draw(0.16, 0.19)
    bands, rope = [], []
    for k in range(4):
        a = np.pi / 4 + k * np.pi / 2
        ends = [a - 0.2, a + 0.2]
        arc = [(0.6 * np.cos(t), 0, 0.6 * np.sin(t)) for t in np.linspace(*ends, 5)]
        bands.append(pipe(arc, tube + 0.012))
        far = 0.6 + tube + 0.01
        loop = [
            ((far + by) * np.cos(t), 0, (far + by) * np.sin(t))
            for t, by in zip(
                np.linspace(a, a + np.pi / 2, 5), (0, 0.05, 0.07, 0.05, 0), strict=True
            )
        ]
        rope.append(pipe(loop, 0.022))
    return {"ring": [ring(0.6, tube, (0, 0, 0), "y")], "bands": bands, "rope": rope}


def _plunger(draw: Draw) -> Parts:
    high = draw(1.1, 1.35)
    cup = [
        (0.0, 0.36),
        (0.1, 0.34),
        (0.24, 0.26),
        (0.34, 0.12),
        (0.36, 0.03),
        (0.38, 0.0),
        (0.33, 0.0),
        (0.3, 0.08),
        (0.2, 0.2),
        (0.0, 0.25),
    ]
    return {
        "cup": [turned(cup), rod((0, 0, 0.3), (0, 0, 0.46), 0.1, 0.07, 0.02)],
        "handle": [
            rod((0, 0, 0.4), (0, 0, high), 0.045),
            capsule((0, 0, high - 0.02), (0, 0, high + 0.02), 0.055),
        ],
    }


DESK_AND_WORKSHOP: dict[str, Callable[[Draw], Parts]] = {
    "dna helix": _dna_helix,
    "steering wheel": _steering_wheel,
    "test tubes": _test_tubes,
    "propeller": _propeller,
    "life ring": _life_ring,
    "plunger": _plunger,
}
