"""Carts and engines of war that the networks know and drew roughly."""

from collections.abc import Callable

import numpy as np
from scipy.spatial.transform import Rotation

from core.geometry.parts.primitives import Loop
from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.pieces import wheel
from core.guidance.builtin.constructed.shapes import (
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
    turned,
)


def _wagon(draw: Draw) -> Parts:
    long, hoops = draw(0.95, 1.1), 5
    wide, floor, side = 0.42, 0.62, 0.3
    tilted = Rotation.from_euler("y", 12, degrees=True).as_matrix()
    planks = [box((0.045, 2 * long, 0.1), (0, 0, z), 0.008) for z in (0.05, 0.155, 0.26)]
    planks += [
        box((0.06, 0.07, side + 0.04), (0.012, y, 0.15), 0.006)
        for y in (-0.9 * long, 0, 0.9 * long)
    ]
    walls = both_sides(placed(planks, tilted, (wide, 0, floor)))
    ends = []
    for y in (-long + 0.02, long - 0.02):
        shape = [(-wide, 0), (wide, 0), (wide + 0.055, side), (-wide - 0.055, side)]
        ends.append(plate(shape, 0.045, (0, y, floor), FRONT))
    body = [box((2 * wide + 0.04, 2 * long, 0.05), (0, 0, floor), 0.008), *walls, *ends]
    angle = np.linspace(0, np.pi, 25)

    def arch(radius: float, thick: float) -> Loop:
        outer, inner = (
            np.stack([(r - 0.02) * np.cos(angle), 0.95 * r * np.sin(angle)], 1)
            for r in (radius, radius - thick)
        )
        legs = [(outer[-1][0], -0.14), (inner[-1][0], -0.14)]
        right = [(inner[0][0], -0.14), (outer[0][0], -0.14)]
        return np.array([*outer, *legs, *inner[::-1], *right])

    start, covers = floor + side + 0.06, []
    each = 2 * (long + 0.06) / (hoops - 1)
    for k in range(hoops):
        y = -long - 0.06 + k * each
        covers.append(plate(arch(0.535, 0.06), 0.055, (0, y, start), FRONT))
        if k < hoops - 1:
            covers.append(plate(arch(0.51, 0.035), each, (0, y + each / 2, start), FRONT))
    wheels = []
    for y, radius in ((-0.62 * long, 0.36), (0.62 * long, 0.46)):
        wheels += moved(wheel(radius, 0.075, 12), (wide + 0.16, y, radius))
    under = [box((0.09, 1.7 * long, 0.09), (0, 0, floor - 0.06))]
    for y, radius in ((-0.62 * long, 0.36), (0.62 * long, 0.46)):
        under.append(rod((-wide - 0.2, y, radius), (wide + 0.2, y, radius), 0.035))
        under.append(box((0.5, 0.1, floor - radius), (0, y, (floor + radius) / 2 - 0.02)))
    pole = [(0, -0.5 * long, 0.42), (0, -long - 0.3, 0.4), (0, -long - 0.75, 0.46)]
    under += [
        pipe(pole, 0.035),
        capsule((-0.3, -long - 0.6, 0.44), (0.3, -long - 0.6, 0.44), 0.028),
    ]
    under += [box((2 * wide + 0.1, 0.26, 0.05), (0, -long + 0.06, floor + side + 0.02), 0.01)]
    under += [rod((wide - 0.02, -0.2, floor - 0.02), (wide + 0.14, -0.34, floor + 0.42), 0.022)]
    return {
        "body": body,
        "wheels": both_sides(wheels),
        "handle": under,
        "cover": covers,
    }


def _cannon(draw: Draw) -> Parts:
    long, spokes = draw(1.1, 1.3), 12
    tilt = Rotation.from_euler("x", -draw(6.0, 12.0), degrees=True).as_matrix()
    profile = [(0, -0.62), (0.06, -0.62), (0.085, -0.57), (0.06, -0.52), (0.05, -0.48)]
    profile += [(0.19, -0.45), (0.22, -0.41), (0.2, -0.36), (0.195, -0.05), (0.21, -0.04)]
    profile += [(0.21, 0.02), (0.185, 0.03), (0.14, long - 0.12), (0.17, long - 0.06)]
    profile += [(0.185, long), (0.17, long + 0.03), (0.085, long + 0.03), (0.085, long - 0.2)]
    barrel = placed([turned([*profile, (0, long - 0.2)])], tilt @ FRONT, (0, 0, 0.62))
    trunnions = rod((-0.3, 0, 0.6), (0.3, 0, 0.6), 0.055, rim=0.01)
    cheek = [(-0.32, 0.34), (-0.3, 0.56), (-0.12, 0.62), (0.12, 0.62), (0.3, 0.5), (0.5, 0.44)]
    cheek += [(0.7, 0.32), (1.25, 0.06), (1.25, -0.0), (1.05, -0.0), (0.5, 0.2), (0.1, 0.3)]
    sides = both_sides([plate(cheek, 0.08, (0.225, 0, 0), SIDE)])
    cross = [box((0.42, 0.09, 0.14), (0, y, z), 0.01) for y, z in ((0.62, 0.28), (1.1, 0.07))]
    cross += [box((0.44, 0.12, 0.1), (0, -0.18, 0.42), 0.01)]
    cross += [rod((-0.5, 0, 0.44), (0.5, 0, 0.44), 0.05)]
    tail = ring(0.075, 0.024, (0, 1.2, 0.05), "x")
    return {
        "barrel": [*barrel, trunnions, tail],
        "carriage": [*sides, *cross],
        "wheels": both_sides(moved(wheel(0.44, 0.09, spokes), (0.42, 0, 0.44))),
    }


def _catapult(draw: Draw) -> Parts:
    swing = draw(34.0, 46.0)
    frame = both_sides(
        [
            box((0.12, 1.9, 0.13), (0.42, 0, 0.4), 0.012),
            box((0.11, 0.12, 0.78), (0.42, -0.1, 0.8), 0.012),
            *(
                rod((0.42, y, 0.44), (0.42, -0.1 + 0.04 * np.sign(y), 1.08), 0.045)
                for y in (-0.66, 0.5)
            ),
        ]
    )
    frame += [box((0.98, 0.12, 0.13), (0, y, 0.4), 0.012) for y in (-0.82, -0.1, 0.82)]
    frame += [box((1.02, 0.14, 0.14), (0, -0.1, 1.2), 0.015)]
    frame += [box((0.56, 0.1, 0.12), (0, -0.19, 1.2), 0.03)]
    axle = (0, 0.02, 0.44)
    beam = Rotation.from_euler("x", -(90 - swing), degrees=True).as_matrix()
    arm = placed([box((0.1, 0.11, 1.25), (0, 0, 0.55), 0.015)], beam, axle)
    bowl = [(0.0, 0.0), (0.1, 0.0), (0.2, 0.07), (0.235, 0.17), (0.205, 0.17), (0.16, 0.09)]
    cup = placed([turned([*bowl, (0.0, 0.05)])], beam @ FRONT, beam @ (0, -0.03, 1.3) + axle)
    load = beam @ (0, -0.2, 1.3) + np.array(axle)
    rope = [
        rod((x, 0.02, 0.44), (x + 0.05, 0.02, 0.44), 0.1, rim=0.02)
        for x in np.arange(-0.36, 0.36, 0.09)
    ]
    rope = [one for k, one in enumerate(rope) if k not in (3, 4)]
    winch = rod((-0.5, 0.66, 0.52), (0.5, 0.66, 0.52), 0.06)
    handles = [
        rod((x, 0.66 - a, 0.52 - b), (x, 0.66 + a, 0.52 + b), 0.02)
        for x in (-0.54, 0.54)
        for a, b in ((0.16, 0.0), (0.0, 0.16))
    ]
    hubs = [rod((x, 0.66, 0.52), (1.15 * x, 0.66, 0.52), 0.05) for x in (-0.49, 0.49)]
    cord = rod((0, 0.66, 0.58), tuple(beam @ (0, 0.04, 0.9) + np.array(axle)), 0.018)
    wheels, iron = [], []
    for y in (-0.66, 0.66):
        disc = rod((0.55, y, 0.27), (0.66, y, 0.27), 0.245, rim=0.01)
        wheels += [disc, box((0.135, 0.09, 0.4), (0.605, y, 0.27), 0.01)]
        iron += [
            turned(
                [(0.24, -0.045), (0.272, -0.045), (0.272, 0.045), (0.24, 0.045)],
                (0.605, y, 0.27),
                "x",
            )
        ]
        iron += [rod((0.4, y, 0.27), (0.72, y, 0.27), 0.05, rim=0.01)]
    struts = [box((0.1, 0.12, 0.2), (0.43, y, 0.31)) for y in (-0.66, 0.66)]
    plates = [box((0.03, 0.2, 0.17), (0.478, y, 0.4), 0.006) for y in (-0.82, 0.82)]
    return {
        "frame": [*frame, *both_sides(struts), winch],
        "wheels": both_sides(wheels),
        "arm": arm,
        "cup": [*cup, *rope, cord],
        "stone": [ball(draw(0.15, 0.17), load)],
        "bands": [*both_sides([*iron, *plates]), *handles, *hubs],
    }


CARTS_AND_CANNONS: dict[str, Callable[[Draw], Parts]] = {
    "wagon": _wagon,
    "cannon": _cannon,
    "catapult": _catapult,
}
