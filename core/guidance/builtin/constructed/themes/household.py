"""Things of the household."""

from collections.abc import Callable

import numpy as np
from scipy.spatial.transform import Rotation

from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.shapes import (
    FRONT,
    SIDE,
    Parts,
    ball,
    both_sides,
    box,
    capsule,
    closed_curve,
    pipe,
    placed,
    plate,
    ring,
    rod,
    rounded,
    spun,
    turned,
)


def _mousetrap(draw: Draw) -> Parts:
    lift = draw(40.0, 62.0)
    base = [box((0.62, 1.2, 0.07), (0, 0, 0.035), 0.012)]
    hammer = placed(
        [
            pipe(
                [
                    (-0.24, 0.0, 0),
                    (-0.24, 0.46, 0),
                    (-0.2, 0.5, 0),
                    (0.2, 0.5, 0),
                    (0.24, 0.46, 0),
                    (0.24, 0.0, 0),
                ],
                0.018,
            )
        ],
        Rotation.from_euler("x", lift, degrees=True).as_matrix(),
        (0, 0.02, 0.1),
    )
    coil = [
        ring(0.055, 0.014, (x, 0.02, 0.1), "x")
        for x in np.arange(-0.2, 0.21, 0.04)
        if abs(x) > 0.05
    ]
    metal = [
        *hammer,
        *coil,
        rod((-0.28, 0.02, 0.1), (0.28, 0.02, 0.1), 0.016),
        *both_sides([pipe([(0.27, 0.02, 0.04), (0.29, 0.02, 0.1), (0.27, 0.02, 0.14)], 0.014)]),
    ]
    metal += [
        rod((0, 0.54, 0.1), (0.0, -0.34, 0.115), 0.012),
        ring(0.03, 0.012, (0, 0.54, 0.09), "x"),
    ]
    plate_ = [
        box((0.22, 0.2, 0.022), (0, -0.36, 0.1), 0.006),
        rod((-0.12, -0.25, 0.085), (0.12, -0.25, 0.085), 0.014),
        box((0.06, 0.06, 0.04), (0, -0.3, 0.08)),
    ]
    cheese = [
        plate([(-0.13, 0), (0.15, 0), (0.15, 0.13), (-0.13, 0.03)], 0.17, (0, -0.37, 0.105), SIDE)
    ]
    cheese_holes = [
        ball((0.03, 0.03, 0.012), (x, y, 0.17 + 0.35 * (y + 0.37) * 0.36 + 0.012))
        for x, y in ((-0.04, -0.32), (0.045, -0.4))
    ]
    return {"base": base, "wire": metal, "trigger": plate_, "cheese": [*cheese, *cheese_holes]}


def _fly_swatter(draw: Draw) -> Parts:
    wide = draw(0.22, 0.26)
    frame = rounded((2 * wide, 0.56), 0.07)
    inner = rounded((2 * wide - 0.06, 0.5), 0.05)
    mesh = [plate(frame, 0.03, (0, 0, 1.0), FRONT, [inner])]
    mesh += [
        rod((x, 0, 0.74), (x, 0, 1.26), 0.0115) for x in np.linspace(-wide + 0.055, wide - 0.055, 8)
    ]
    mesh += [
        rod((-wide + 0.02, 0, z), (wide - 0.02, 0, z), 0.0115) for z in np.linspace(0.78, 1.22, 9)
    ]
    handle = [
        pipe([(-0.05, 0, 0.72), (-0.018, 0, 0.6), (-0.018, 0, -0.3)], 0.017),
        pipe([(0.05, 0, 0.72), (0.018, 0, 0.6), (0.018, 0, -0.3)], 0.017),
    ]
    grip = [
        capsule((0, 0, -0.28), (0, 0, -0.62), 0.05, 0.055),
        ring(0.05, 0.014, (0, 0, -0.7), "y"),
    ]
    fly = [
        ball((0.034, 0.028, 0.045), (0.06, -0.026, 1.06)),
        ball(0.024, (0.06, -0.026, 1.115)),
        *(
            ball((0.02, 0.012, 0.045), (0.06 + s * 0.034, -0.034, 1.035), (0, s * 28, 0))
            for s in (-1, 1)
        ),
    ]
    return {"net": mesh, "wire": handle, "grip": grip, "fly": fly}


def _feather_duster(draw: Draw) -> Parts:
    rng = np.random.default_rng(draw.which(1000))
    handle = [capsule((0, 0, -0.9), (0, 0, -0.2), 0.05, 0.045), ball(0.06, (0, 0, -0.94))]
    collar = [rod((0, 0, -0.26), (0, 0, -0.12), 0.07, 0.1, 0.01)]
    first, second = [ball((0.2, 0.2, 0.42), (0, 0, 0.24))], []
    for k in range(70):
        a, t = 2.4 * k, (k + 0.5) / 70
        lean = 0.2 + 0.95 * (1 - t)
        way = np.array([np.cos(a) * np.sin(lean), np.sin(a) * np.sin(lean), np.cos(lean)])
        start = np.array([0, 0, -0.1 + 0.36 * t])
        end = start + way * rng.uniform(0.42, 0.52)
        (first if k % 3 else second).append(capsule(tuple(start), tuple(end), 0.05, 0.075))
    ringlet = [ring(0.04, 0.014, (0, 0, -1.02), "y")]
    return {"feathers": first, "plumes": second, "handle": [*handle, *ringlet], "collar": collar}


def _clothespin(draw: Draw) -> Parts:
    open_by = draw(4.0, 8.0)
    half = closed_curve(
        [
            (0.02, -0.6),
            (0.1, -0.62),
            (0.17, -0.5),
            (0.17, 0.1),
            (0.13, 0.55),
            (0.06, 0.6),
            (0.03, 0.52),
            (0.035, 0.3),
            (0.07, 0.24),
            (0.035, 0.18),
            (0.03, 0.0),
            (0.06, -0.08),
            (0.02, -0.16),
        ]
    )
    way = Rotation.from_euler("y", open_by, degrees=True).as_matrix()
    wood = both_sides(placed([plate(half, 0.2, (0, 0, 0), FRONT)], way, (-0.012, 0, 0)))
    wood += [rod((-0.05, 0, -0.06), (0.05, 0, -0.06), 0.07)]
    coil = [ring(0.072, 0.022, (0, y, -0.06), "y") for y in (-0.12, -0.09, 0.09, 0.12)]
    wire = [
        rod((0, -0.12, -0.06), (0, 0.12, -0.06), 0.03),
        *both_sides(
            [
                pipe(
                    [(0.06, y, -0.04), (0.17, y, 0.0), (0.195, 0.9 * y, 0.12), (0.195, 0, 0.14)],
                    0.02,
                )
                for y in (-0.1, 0.1)
            ]
        ),
    ]
    return {"wood": wood, "spring": [*coil, *wire]}


def _light_switch(draw: Draw) -> Parts:
    on = 1 if draw.which(2) else -1
    base = [box((0.7, 0.1, 1.1), (0, 0, 0), 0.04), box((0.6, 0.12, 1.0), (0, -0.004, 0), 0.05)]
    frame = [plate(rounded((0.36, 0.62), 0.04), 0.04, (0, -0.07, 0), FRONT)]
    rocker = [box((0.28, 0.1, 0.52), (0, -0.085, 0), 0.03, (on * 9, 0, 0))]
    mark = [box((0.018, 0.03, 0.09), (0, -0.13 - on * 0.025, 0.16), 0.003)]
    screws = [rod((0, -0.05, z), (0, -0.075, z), 0.035, rim=0.006) for z in (-0.42, 0.42)] + [
        box((0.05, 0.012, 0.012), (0, -0.076, z), 0.0, (0, 30, 0)) for z in (-0.42, 0.42)
    ]
    lamp = [ball((0.022, 0.02, 0.022), (0, -0.133 + on * 0.027, -0.18))]
    return {
        "plate": base,
        "frame": frame,
        "rocker": rocker,
        "mark": mark,
        "screws": screws,
        "lamp": lamp,
    }


def _power_outlet(draw: Draw) -> Parts:
    del draw
    base = [box((0.7, 0.1, 1.1), (0, 0, 0), 0.04), box((0.6, 0.12, 1.0), (0, -0.004, 0), 0.05)]
    face, holes = [], []
    for z in (-0.25, 0.25):
        face += [plate(rounded((0.42, 0.38), 0.1), 0.05, (0, -0.065, z), FRONT)]
        holes += [box((0.034, 0.03, 0.12), (x, -0.083, z + 0.03), 0.004) for x in (-0.09, 0.09)] + [
            rod((0, -0.07, z - 0.1), (0, -0.098, z - 0.1), 0.036)
        ]
    screws = [rod((0, -0.05, 0), (0, -0.08, 0), 0.032, rim=0.006)]
    return {"plate": base, "sockets": face, "slots": holes, "screw": screws}


def _smoke_detector(draw: Draw) -> Parts:
    count = 20 + draw.which(6)
    body = [
        turned(
            [
                (0, 0),
                (0.62, 0),
                (0.64, 0.04),
                (0.6, 0.12),
                (0.5, 0.14),
                (0.5, 0.24),
                (0.42, 0.32),
                (0.16, 0.36),
                (0, 0.36),
            ]
        )
    ]
    slots = spun([box((0.05, 0.05, 0.1), (0, -0.5, 0.19), 0.006)], count)
    button = [rod((0, 0, 0.34), (0, 0, 0.39), 0.1, 0.09, 0.01)]
    lamp = [ball(0.035, (0.26, -0.1, 0.34))]
    grill = spun([rod((0, -0.2, 0.33), (0, -0.4, 0.31), 0.014)], 16)
    turn = Rotation.from_euler("x", 90, degrees=True).as_matrix()
    return {
        name: placed(own, turn)
        for name, own in {
            "body": body,
            "slots": slots,
            "vents": grill,
            "button": button,
            "lamp": lamp,
        }.items()
    }


def _dish_rack(draw: Draw) -> Parts:
    count = 5 + draw.which(3)
    loops = [
        [(x, y, z) for x, y in ((-0.7, -0.42), (0.7, -0.42), (0.7, 0.42), (-0.7, 0.42))]
        for z in (0.12, 0.34)
    ]
    wire = []
    for loop in loops:
        wire += [capsule(a, b, 0.016) for a, b in zip(loop, [*loop[1:], loop[0]], strict=True)]
    for x in np.linspace(-0.6, 0.6, 13):
        wire += [rod((x, -0.42, 0.12), (x, 0.42, 0.12), 0.0125)]
        wire += [rod((x, y, 0.12), (x, y, 0.34), 0.0125) for y in (-0.42, 0.42)]
    wire += [rod((-0.7, y, 0.12), (0.7, y, 0.12), 0.0125) for y in (-0.2, 0.2)] + [
        rod((s * 0.7, y, 0.12), (s * 0.7, y, 0.34), 0.0125)
        for s in (-1, 1)
        for y in (-0.2, 0.0, 0.2)
    ]
    wire += [
        rod((s * 0.66, t * 0.38, 0.0), (s * 0.66, t * 0.4, 0.13), 0.024)
        for s in (-1, 1)
        for t in (-1, 1)
    ]
    plates, trim = [], []
    for k in range(count):
        x = -0.56 + 0.17 * k
        plates.append(rod((x, 0.0, 0.41), (x + 0.03, 0.0, 0.415), 0.31, rim=0.008))
        trim.append(
            turned(
                [(0.2, -0.018), (0.225, -0.018), (0.225, 0.022), (0.2, 0.022)],
                (x + 0.016, 0, 0.4225),
                "x",
            )
        )
    mug = [
        turned([(0, 0.13), (0.14, 0.13), (0.15, 0.4), (0.13, 0.43), (0, 0.43)], (0.52, -0.2, 0)),
        pipe(
            [(0.64, -0.24, 0.38), (0.76, -0.3, 0.34), (0.76, -0.3, 0.24), (0.64, -0.24, 0.2)], 0.024
        ),
    ]
    tray = [box((1.6, 1.0, 0.05), (0, 0, 0.0), 0.02)]
    wire.append(rod((-0.7, 0, 0.12), (0.7, 0, 0.12), 0.0125))
    return {"rack": wire, "plates": plates, "trim": trim, "mug": mug, "tray": tray}


HOUSEHOLD: dict[str, Callable[[Draw], Parts]] = {
    "mousetrap": _mousetrap,
    "fly swatter": _fly_swatter,
    "feather duster": _feather_duster,
    "clothespin": _clothespin,
    "light switch": _light_switch,
    "power outlet": _power_outlet,
    "smoke detector": _smoke_detector,
    "dish rack": _dish_rack,
}
