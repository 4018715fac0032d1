"""Ships that the networks know and drew roughly."""

from collections.abc import Callable, Sequence

import numpy as np

from core.geometry.parts.primitives import Loop, Primitive
from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.shapes import (
    FLAT,
    SIDE,
    Parts,
    ball,
    both_sides,
    box,
    capsule,
    closed_curve,
    curve,
    pipe,
    plate,
    rod,
    turned,
)

HULL_LAYERS = 10


def _deck(wide: float, bow: float, stern: float) -> Loop:
    """A ship's outline from above, its bow towards -y."""
    half = [(0.3, 0.9), (0.62, 0.68), (0.92, 0.35), (1.0, 0.0)]
    side = [(wide * x, -bow * y) for x, y in half]
    side += [(wide, 0.45 * stern), (0.86 * wide, 0.8 * stern), (0.72 * wide, stern)]
    return np.array([(0.0, -bow), *side, *((-x, y) for x, y in side[::-1])])


def _sail(wide: float, high: float, at: Sequence[float]) -> Primitive:
    """A square sail full of wind from behind, by the middle of its head."""
    z = np.linspace(0, -high, 11)
    belly = -0.16 * high * np.sin(np.linspace(0.12 * np.pi, np.pi, 11))
    outer = np.stack([belly - 0.014, z], 1)
    return plate([*outer, *(outer[::-1] + (0.028, 0))], wide, at, SIDE)


def _pirate_ship(draw: Draw) -> Parts:
    wide, rise, ports = draw(0.27, 0.31), draw(0.95, 1.1), 4 + draw.which(2)
    hull, low, high = [], -0.5, 0.0
    for k in range(HULL_LAYERS):
        up = (k + 0.5) / HULL_LAYERS
        outline = _deck(wide * (0.42 + 0.58 * up**0.55), 0.62 + 0.26 * up, 0.76 + 0.08 * up)
        z = low + (high - low) * up
        hull.append(plate(outline, 0.056, (0, 0, z)))
    rail = _deck(wide + 0.012, 0.9, 0.85)
    within = _deck(wide - 0.022, 0.83, 0.82)
    hull.append(plate(rail, 0.12, (0, 0, 0.05), FLAT, [within]))
    hull.append(plate(_deck(wide - 0.01, 0.86, 0.84), 0.03, (0, 0, 0.0)))

    def aft(grow: float, start: float, z: float, thick: float, hole: bool = False) -> Primitive:
        outer = np.array([(wide + grow, start), (0.94 * wide + grow, 0.66), (0.78 * wide, 0.9)])
        whole = np.array([*outer, *(outer[::-1] * (-1, 1))])
        holes = [(whole - (0, 0.69)) * 0.84 + (0, 0.69)]
        return plate(whole, thick, (0, 0, z), FLAT, holes if hole else ())

    hull += [aft(0.004, 0.36, 0.12, 0.2), aft(0.014, 0.34, 0.22, 0.03)]
    hull += [aft(-0.004, 0.52, 0.3, 0.16), aft(0.012, 0.5, 0.385, 0.03)]
    hull += [aft(0.006, 0.5, 0.44, 0.1, True)]
    fore = _deck(wide + 0.006, 0.93, 0.85)
    front = fore[fore[:, 1] < -0.4]
    hull += [plate(front, 0.11, (0, 0, 0.12)), plate(1.03 * front, 0.03, (0, 0.012, 0.18))]
    stem = [(0, -0.6, -0.53), (0, -0.74, -0.28), (0, -0.88, 0.0), (0, -0.98, 0.17)]
    hull += [
        pipe(stem, (0.024, 0.028, 0.032, 0.034)),
        box((0.04, 0.16, 0.5), (0, 0.86, -0.3), 0.01),
    ]
    stripe = plate(_deck(wide + 0.014, 0.88, 0.85), 0.03, (0, 0, -0.05))
    masts, sails = [], []
    for y, foot, top, heads in (
        (-0.5, 0.0, 0.95 * rise, ((0.46, 0.3, 0.52), (0.34, 0.24, 0.84))),
        (0.02, 0.0, 1.2 * rise, ((0.56, 0.4, 0.62), (0.44, 0.3, 0.98))),
        (0.56, 0.36, 1.02 * rise, ((0.4, 0.27, 0.78),)),
    ):
        masts.append(rod((0, y, foot - 0.02), (0, y, top), 0.03, 0.018))
        for across, tall, z in heads:
            head = z * rise
            masts.append(
                capsule((-0.55 * across, y - 0.03, head), (0.55 * across, y - 0.03, head), 0.015)
            )
            sails.append(_sail(across, tall * rise, (0, y - 0.035, head)))
        masts.append(ball((0.02, 0.02, 0.025), (0, y, top)))
    masts.append(rod((0, -0.8, 0.12), (0, -1.32, 0.36), 0.028, 0.014))
    for ends in (
        ((0, -1.3, 0.35), (0, -0.5, 0.93 * rise)),
        ((0, -0.5, 0.93 * rise), (0, 0.02, 1.16 * rise)),
        ((0, 0.02, 1.16 * rise), (0, 0.56, 1.0 * rise)),
        ((0, 0.56, 1.0 * rise), (0, 0.86, 0.46)),
    ):
        masts.append(rod(*ends, 0.0085))
    shrouds = []
    for y, top, foot in ((-0.5, 0.52, 0.08), (0.02, 0.62, 0.08), (0.56, 0.78, 0.46)):
        for step in (0.03, 0.1, 0.17):
            outer = (0.98 if y > -0.4 else 0.84) * wide - (0.02 if y > 0.5 else 0)
            shrouds.append(rod((outer, y + step, foot), (0.01, y + 0.01, top * rise), 0.0085))
    masts += both_sides(shrouds)
    nest = [(0.05, 0.0), (0.085, 0.09), (0.07, 0.09), (0.045, 0.02)]
    masts.append(turned([(0, 0), *nest, (0, 0.02)], (0, 0.02, 1.0 * rise)))
    top = 1.2 * rise
    wave = curve([(0, 0), (0.1, 0.025), (0.2, -0.01), (0.31, 0.02)])
    flag = [*wave + (0, 0.008), *(wave[::-1] - (0, 0.008))]
    upright = np.array([[0.0, 1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, -1.0]])
    skull = [
        rod((-0.03, 0.17, top - 0.11), (0.03, 0.17, top - 0.11), 0.042, rim=0.01),
        box((0.056, 0.045, 0.045), (0, 0.17, top - 0.15), 0.01),
    ]
    guns, holes = [], []
    for y in np.linspace(-0.38, 0.3, ports):
        side = wide * 0.93
        holes.append(box((0.05, 0.075, 0.07), (side, y, -0.17), 0.004))
        guns.append(rod((side - 0.05, y, -0.17), (side + 0.09, y, -0.16), 0.026, 0.02))
    glass = [box((0.075, 0.03, 0.1), (x, 0.905, 0.14), 0.004) for x in (-0.13, 0.0, 0.13)]
    glass += [box((0.075, 0.03, 0.07), (x, 0.905, 0.3), 0.004) for x in (-0.09, 0.09)]
    return {
        "hull": hull,
        "sails": [*sails, stripe, *skull],
        "masts": masts,
        "flag": [plate(flag, 0.19, (0, 0.02, top - 0.12), upright)],
        "windows": [*both_sides([*guns, *holes]), *glass],
    }


def _longship(draw: Draw) -> Parts:
    count, wide = 7 + draw.which(3), draw(0.25, 0.29)
    hull = []
    for k in range(7):
        up = (k + 0.5) / 7
        w, reach = wide * (0.3 + 0.7 * up**0.6), 0.78 + 0.16 * up
        outline = closed_curve(
            [
                (0, -reach),
                (0.62 * w, -0.68 * reach),
                (w, -0.2),
                (w, 0.2),
                (0.62 * w, 0.68 * reach),
                (0, reach),
                (-0.62 * w, 0.68 * reach),
                (-w, 0.2),
                (-w, -0.2),
                (-0.62 * w, -0.68 * reach),
            ]
        )
        hole = [0.86 * outline] if k > 2 else []
        hull.append(
            plate(outline * (1 + 0.02 * (k % 2), 1), 0.062, (0, 0, -0.4 + 0.055 * k), FLAT, hole)
        )
    hull += [box((1.7 * wide, 0.07, 0.03), (0, y, -0.12), 0.006) for y in (-0.45, -0.2, 0.2, 0.45)]
    prows = []
    for s in (-1, 1):
        way = [(0.7, -0.4), (0.88, -0.22), (0.97, 0.0), (0.98, 0.2), (0.9, 0.32)]
        prows.append(pipe([(0, s * y, z) for y, z in way], (0.03, 0.036, 0.036, 0.034, 0.034)))
    head = [
        (-0.9, 0.3),
        (-1.0, 0.37),
        (-1.1, 0.33),
        (-1.16, 0.36),
        (-1.15, 0.42),
        (-1.02, 0.46),
        (-0.9, 0.4),
    ]
    prows += [
        plate(head, 0.07, (0, 0, 0), SIDE),
        plate([(-0.97, 0.36), (-1.12, 0.28), (-1.0, 0.26)], 0.045, (0, 0, 0), SIDE),
    ]
    prows += both_sides([rod((0.02, -0.96, 0.4), (0.05, -0.86, 0.53), 0.026, 0.006)])
    spiral = [(0.9, 0.32), (0.82, 0.36), (0.8, 0.44), (0.86, 0.49), (0.92, 0.45)]
    prows.append(pipe([(0, y, z) for y, z in spiral], (0.034, 0.032, 0.03, 0.026, 0.02)))
    fins = [(-0.97, 0.02), (-0.98, 0.12), (-0.94, 0.22)]
    prows += [rod((0, y + 0.02, z), (0, y + 0.09, z + 0.05), 0.024, 0.005) for y, z in fins]
    mast = [
        rod((0, 0, -0.38), (0, 0, 0.86), 0.028, 0.018),
        ball(0.03, (0, 0, 0.87)),
        capsule((-0.46, -0.02, 0.74), (0.46, -0.02, 0.74), 0.02),
    ]
    mast += [rod((0, y, -0.1), (0, 0, 0.84), 0.009) for y in (-0.86, 0.86)]
    mast += both_sides([rod((0.9 * wide, 0.28, -0.08), (0.0, 0.0, 0.8), 0.009)])
    oars = []
    for y in np.linspace(-0.42, 0.46, 6):
        oars.append(rod((0.8 * wide, y, -0.06), (wide + 0.34, y + 0.05, -0.44), 0.012))
        oars.append(box((0.02, 0.06, 0.13), (wide + 0.34, y + 0.05, -0.44), 0.006, (0, -42, 0)))
    sail, stripes = [], []
    for k in range(6):
        x = (k - 2.5) * 0.14
        (stripes if k % 2 else sail).append(_sail(0.142, 0.66, (x, -0.03, 0.74)))
    shields = []
    for y in np.linspace(-0.52, 0.52, count):
        side = wide * (1.02 - 0.42 * abs(y / 0.6) ** 2.4)
        shields += [
            rod((side - 0.06, y, -0.1), (side + 0.03, y, -0.1), 0.068, rim=0.01),
            ball(0.026, (side + 0.03, y, -0.1)),
        ]
    return {
        "hull": hull,
        "prows": prows,
        "mast": [*mast, *both_sides(oars)],
        "sail": sail,
        "stripes": stripes,
        "shields": both_sides(shields),
    }


SHIPS: dict[str, Callable[[Draw], Parts]] = {
    "pirate ship": _pirate_ship,
    "longship": _longship,
}
