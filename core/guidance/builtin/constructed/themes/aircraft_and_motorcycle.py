"""Aircraft, a spaceship and a motorcycle that the networks know and drew roughly."""

from collections.abc import Callable

import numpy as np
from scipy.spatial.transform import Rotation

from core.geometry.parts.primitives import Primitive
from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.shapes import (
    BACKWARD,
    FRONT,
    SIDE,
    Parts,
    ball,
    both_sides,
    box,
    capsule,
    closed_curve,
    curve,
    moved,
    pipe,
    placed,
    plate,
    ring,
    rod,
    spun,
    turned,
)


def _helicopter(draw: Draw) -> Parts:
    blades, reach = 2 + draw.which(3), draw(0.98, 1.1)
    cabin = [(0, -0.72), (0.16, -0.7), (0.3, -0.58), (0.37, -0.36), (0.38, -0.1), (0.34, 0.2)]
    cabin += [(0.24, 0.44), (0.13, 0.62), (0, 0.66)]
    body = placed([turned(curve(cabin))], BACKWARD, (0, -0.02, 0))
    body += [rod((0, 0.3, 0.1), (0, 1.36, 0.17), 0.15, 0.062)]
    body += [capsule((0, -0.12, 0.33), (0, 0.42, 0.27), 0.16, 0.12)]
    fin = [(1.2, 0.15), (1.32, 0.14), (1.52, 0.56), (1.4, 0.57)]
    low = [(1.24, 0.17), (1.36, 0.17), (1.46, -0.1), (1.38, -0.11)]
    body += [plate(fin, 0.045, (0.0, 0, 0), SIDE), plate(low, 0.04, (0, 0, 0), SIDE)]
    body += [box((0.62, 0.15, 0.035), (0, 1.16, 0.15), 0.012)]
    body += both_sides([box((0.03, 0.2, 0.16), (0.31, 1.17, 0.15), 0.01)])
    glass = [ball((0.345, 0.4, 0.29), (0, -0.38, 0.085), (8, 0, 0))]
    glass += both_sides([box((0.05, 0.26, 0.22), (0.352, 0.06, 0.1), 0.025)])
    blade = [
        box((0.1, reach, 0.02), (0, reach / 2, 0), 0.006),
        box((0.05, 0.24, 0.035), (0, 0.1, 0)),
    ]
    hub = (0, -0.02, 0.68)
    rotor = [*moved(spun(blade, blades), hub), rod((0, -0.02, 0.4), (0, -0.02, 0.72), 0.035)]
    rotor += [rod((0, -0.02, 0.64), (0, -0.02, 0.71), 0.085, 0.06, 0.01)]
    tail = spun([box((0.014, 0.06, 0.24), (0, 0, 0.12), 0.004)], 4, "x")
    centre = (0.085, 1.38, 0.3)
    rear = [*moved(tail, centre), rod((0.0, *centre[1:]), (0.11, *centre[1:]), 0.035, rim=0.006)]
    runner = [(0.4, -0.82, -0.5), (0.4, -0.74, -0.58), (0.4, -0.55, -0.6), (0.4, 0.5, -0.6)]
    skids = [pipe(runner, 0.026), ball(0.028, (0.4, 0.5, -0.6))]
    for y in (-0.42, 0.22):
        skids.append(
            pipe([(0.14, y, -0.26), (0.3, y, -0.36), (0.39, y, -0.5), (0.4, y, -0.6)], 0.022)
        )
    return {
        "body": body,
        "windows": glass,
        "rotor": rotor,
        "skids": both_sides(skids),
        "tail rotor": rear,
    }


def _fighter_jet(draw: Draw) -> Parts:
    span, sweep = draw(0.82, 0.95), draw(0.28, 0.4)
    nose = [(0, -1.3), (0.025, -1.25), (0.09, -1.02), (0.14, -0.8), (0.165, -0.5), (0.17, 0.2)]
    nose += [(0.15, 0.75), (0, 0.75)]
    body = placed([turned(nose)], BACKWARD)
    engine = [box((0.22, 1.25, 0.22), (0.18, 0.18, -0.03), 0.05)]
    inlet = [(-0.62, 0.1), (-0.44, 0.1), (-0.3, 0.11), (-0.3, -0.14), (-0.52, -0.14)]
    engine += [plate(inlet, 0.2, (0.185, 0, 0), SIDE)]
    strake = [(0.1, -0.72), (0.2, -0.5), (0.3, -0.25), (0.3, 0.1), (0.1, 0.1)]
    body += both_sides([*engine, plate(strake, 0.04, (0, 0, 0.06))])
    body += [capsule((0, -0.35, 0.12), (0, 0.5, 0.08), 0.12, 0.08)]
    wing = [(0.2, -0.3), (span, -0.3 + sweep + 0.24), (span, 0.44), (0.2, 0.42)]
    flap = [(0.25, 0.34), (span - 0.14, 0.3), (span - 0.14, 0.36), (0.25, 0.46)]
    rear = [(0.2, 0.6), (0.26, 0.55), (0.56, 0.82), (0.56, 0.98), (0.26, 0.9)]
    wings = [plate(wing, 0.042, (0, 0, 0.0)), plate(flap, 0.055, (0, 0, 0.0))]
    wings += [plate(rear, 0.036, (0, 0, -0.02))]
    fin = [(0.28, 0.0), (0.62, 0.0), (0.84, 0.44), (0.66, 0.46)]
    lean = Rotation.from_euler("y", 16, degrees=True).as_matrix()
    tails = placed([plate(fin, 0.036, (0, 0, 0), SIDE)], lean, (0.22, 0.1, 0.06))
    canopy = [ball((0.095, 0.3, 0.12), (0, -0.6, 0.12), (-4, 0, 0))]
    mouth = [
        (0.085, 0),
        (0.12, 0),
        (0.108, 0.2),
        (0.085, 0.24),
        (0.07, 0.22),
        (0.085, 0.1),
        (0.0, 0.06),
    ]
    nozzles = placed([turned([(0, 0), *mouth[1:]])], BACKWARD, (0.165, 0.72, -0.02))
    missiles = []
    for x, y in ((span, 0.12), (0.62 * span, 0.08)):
        z = 0.0 if x == span else -0.1
        missiles += [capsule((x, y - 0.36, z), (x, y + 0.34, z), 0.034)]
        missiles += [rod((x, y - 0.36, z), (x, y - 0.44, z), 0.03, 0.0)]
        for at in (y - 0.22, y + 0.28):
            missiles += [box((0.16, 0.07, 0.014), (x, at, z)), box((0.014, 0.07, 0.16), (x, at, z))]
        if z:
            missiles += [box((0.026, 0.2, 0.1), (x, y, -0.05))]
    return {
        "body": [*body, rod((0, -1.28, 0), (0, -1.42, 0), 0.012)],
        "wings": both_sides(wings),
        "canopy": canopy,
        "tails": both_sides(tails),
        "nozzles": both_sides(nozzles),
        "missiles": both_sides(missiles),
    }


def _motorcycle(draw: Draw) -> Parts:
    front, rear, radius = -0.78, 0.74, 0.36
    bars = draw(0.82, 0.9)
    tyres, metal = [], []
    for y, wide in ((front, 0.075), (rear, 0.1)):
        tyres += [ring(radius - 0.075, wide, (0, y, radius), "x")]
        metal += moved([ring(radius - 0.14, 0.028, (0, 0, 0), "x")], (0, y, radius))
        metal += moved(
            spun([rod((0.0, 0, 0), (0, 0, radius - 0.13), 0.014)], 10, "x"), (0, y, radius)
        )
        metal += [rod((-0.1, y, radius), (0.1, y, radius), 0.06, rim=0.01)]
        metal += [rod((0.06, y, radius), (0.075, y, radius), 0.13, rim=0.004)]

    def fender(y: float, start: float, end: float, wide: float) -> Primitive:
        turn = np.radians(np.linspace(start, end, 15))
        outer, inner = (np.stack([np.cos(turn), np.sin(turn)], 1) * r for r in (0.435, 0.405))
        return plate([*outer, *inner[::-1]], wide, (0, y, radius), SIDE)

    tank = [ball((0.155, 0.34, 0.15), (0, -0.16, 0.84), (10, 0, 0))]
    tank += [rod((0, -0.26, 0.95), (0, -0.26, 1.01), 0.045, rim=0.01)]
    side = [(0.06, 0.52), (0.4, 0.52), (0.46, 0.66), (0.06, 0.74)]
    body = [*tank, fender(front, 60, 165, 0.17), fender(rear, -10, 140, 0.23)]
    body += [plate(side, 0.26, (0, 0, 0), SIDE)]
    saddle = [(0.0, 0.75), (0.1, 0.72), (0.46, 0.73), (0.86, 0.83), (0.92, 0.88), (0.86, 0.93)]
    saddle += [(0.62, 0.86), (0.48, 0.88), (0.44, 0.94), (0.36, 0.86), (0.16, 0.83), (0.02, 0.86)]
    seat = [plate(closed_curve(saddle), 0.25, (0, 0, 0), SIDE)]
    block = [
        box((0.26, 0.5, 0.24), (0, -0.02, 0.36), 0.05),
        rod((-0.2, 0.1, 0.34), (0.2, 0.1, 0.34), 0.14, rim=0.02),
    ]
    for lean in (-26, 26):
        way = Rotation.from_euler("x", -lean, degrees=True).as_matrix()
        fins = [
            rod((0, 0, z), (0, 0, z + 0.022), 0.125, rim=0.004)
            for z in np.arange(0.14, 0.32, 0.042)
        ]
        fins += [rod((0, 0, 0.08), (0, 0, 0.36), 0.095, rim=0.02)]
        block += placed(fins, way, (0, -0.04, 0.34))
    exhaust = [(0.1, -0.2, 0.52), (0.17, -0.3, 0.4), (0.18, -0.2, 0.24), (0.19, 0.1, 0.21)]
    block += [pipe([*exhaust, (0.19, 0.4, 0.23)], 0.034)]
    block += [rod((0.19, 0.32, 0.22), (0.19, 1.06, 0.3), 0.05, 0.062, 0.01)]
    frame = [
        (0, -0.5, 0.86),
        (0, -0.4, 0.5),
        (0, -0.28, 0.24),
        (0, 0.2, 0.2),
        (0, 0.44, 0.4),
        (0, 0.5, 0.7),
    ]
    block += both_sides([pipe([(0.07, y, z) for _, y, z in frame], 0.026)])
    block += both_sides([rod((0.13, rear, radius), (0.1, 0.24, 0.32), 0.026)])
    block += both_sides([rod((0.14, rear - 0.02, radius), (0.12, 0.56, 0.74), 0.03)])
    fork = [rod((0.105, front, radius), (0.105, -0.5, 0.98), 0.03)]
    fork += [capsule((0.105, front + 0.02, radius - 0.03), (0.105, -0.66, 0.68), 0.04)]
    fork += [
        pipe(
            [
                (0.0, -0.5, 0.98),
                (0.1, -0.5, 1.03),
                (0.28, -0.4, 1.12),
                (0.44, -0.26, 1.08 + bars - 0.86),
            ],
            0.022,
        )
    ]
    fork += [
        rod((0.34, -0.36, 1.1), (0.42, -0.4, 1.26), 0.012),
        ball((0.07, 0.02, 0.05), (0.43, -0.4, 1.28)),
    ]
    handle = both_sides(fork)
    handle += [
        box((0.26, 0.07, 0.05), (0, -0.52, 0.94), 0.01),
        box((0.26, 0.07, 0.04), (0, -0.6, 0.78), 0.01),
    ]
    handle += [
        turned(
            [(0, 0), (0.05, 0.0), (0.11, 0.06), (0.125, 0.15), (0.1, 0.17), (0, 0.17)],
            (0, -0.56, 0.86),
            "y",
        )
    ]
    handle = list(handle[:-1]) + placed(
        [turned([(0, 0), (0.05, 0.0), (0.11, 0.06), (0.125, 0.15), (0, 0.15)])],
        FRONT,
        (0, -0.56, 0.87),
    )
    lamp = [ball((0.105, 0.05, 0.105), (0, -0.71, 0.87))]
    lamp += [box((0.12, 0.06, 0.06), (0, 1.18, 0.52), 0.02)]
    handle += [rod((0, -0.61, 0.76), (0, -0.46, 0.98), 0.05)]
    block += [rod((0, -0.53, 0.86), (0, -0.28, 0.86), 0.042)]
    return {
        "body": [*body, box((0.04, 0.16, 0.03), (0, 1.12, 0.56))],
        "wheels": tyres,
        "engine": [*metal, *block],
        "seat": seat,
        "handlebar": handle,
        "lamp": lamp,
    }


def _spaceship(draw: Draw) -> Parts:
    span, droop = draw(0.82, 1.0), draw(-14.0, 14.0)
    nose = [
        (0, -1.2),
        (0.05, -1.17),
        (0.11, -1.0),
        (0.17, -0.66),
        (0.21, -0.2),
        (0.22, 0.4),
        (0.19, 0.7),
        (0.14, 0.74),
        (0, 0.74),
    ]
    hull = placed([turned(nose)], BACKWARD)
    hull += [
        box((0.36, 0.9, 0.16), (0, 0.2, -0.1), 0.05),
        capsule((0, 0.0, 0.14), (0, 0.6, 0.12), 0.14, 0.1),
    ]
    hull += both_sides(
        [
            box((0.14, 0.62, 0.2), (0.26, 0.3, 0.0), 0.04),
            plate([(0.0, -0.86), (0.14, -0.7), (0.14, -0.5), (0.0, -0.6)], 0.05, (0.1, 0, -0.02)),
        ]
    )
    hull += [plate([(0.3, 0.2), (0.74, 0.2), (0.86, 0.62), (0.7, 0.62)], 0.045, (0, 0, 0), SIDE)]
    hull += both_sides([rod((0.16, 0.5, 0.16), (0.16, 0.5, 0.24), 0.05, rim=0.01)])
    wing = [(0.16, -0.12), (0.42, 0.06), (span, 0.36), (span, 0.62), (0.46, 0.66), (0.16, 0.6)]
    rib = [(0.3, 0.06), (span - 0.08, 0.4), (span - 0.08, 0.5), (0.3, 0.4)]
    tip = [(0.2, -0.05), (0.66, 0.02), (0.78, 0.26), (0.6, 0.28)]
    lower = [(0.22, -0.05), (0.6, -0.02), (0.66, -0.16), (0.5, -0.16)]
    way = Rotation.from_euler("y", droop, degrees=True).as_matrix()
    wings = placed(
        [
            plate(wing, 0.05),
            plate(rib, 0.08),
            plate(tip, 0.045, (span, 0, 0), SIDE),
            plate(lower, 0.045, (span, 0, 0), SIDE),
        ],
        way,
        (0, 0, -0.02),
    )
    guns = placed(
        [
            rod((span + 0.02, 0.5, 0), (span + 0.02, 0.0, 0), 0.05, 0.045, 0.01),
            rod((span + 0.02, 0.02, 0), (span + 0.02, -0.36, 0), 0.022),
            rod((span + 0.02, -0.3, 0), (span + 0.02, -0.36, 0), 0.034, rim=0.006),
        ],
        way,
        (0, 0, -0.02),
    )
    cell = [
        (0, -0.24),
        (0.09, -0.24),
        (0.15, -0.14),
        (0.15, 0.12),
        (0.11, 0.26),
        (0.085, 0.25),
        (0.085, 0.16),
        (0, 0.16),
    ]
    engines = placed([turned(cell)], BACKWARD, (0.28, 0.6, 0.0))
    engines += [ring(0.15, 0.02, (0.28, 0.66, 0.0), "y"), ring(0.152, 0.02, (0.28, 0.54, 0.0), "y")]
    flame = [(0, 0.1), (0.09, 0.12), (0.092, 0.24), (0.05, 0.42), (0, 0.56)]
    flames = placed([turned([*flame])], BACKWARD, (0.28, 0.6, 0.0))
    canopy = [ball((0.13, 0.34, 0.13), (0, -0.34, 0.16), (-5, 0, 0))]
    return {
        "hull": hull,
        "wings": both_sides(wings),
        "cockpit": canopy,
        "guns": both_sides(guns),
        "engines": both_sides(engines),
        "flames": both_sides(flames),
    }


AIRCRAFT_AND_MOTORCYCLE: dict[str, Callable[[Draw], Parts]] = {
    "helicopter": _helicopter,
    "fighter jet": _fighter_jet,
    "motorcycle": _motorcycle,
    "spaceship": _spaceship,
}
