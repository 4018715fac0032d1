"""Ships, carts and engines of war that the networks know and drew roughly."""

from collections.abc import Callable, Sequence

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

HULL_LAYERS = 10


def wheel(radius: float, width: float, spokes: int, rim: float = 0.12) -> list[Primitive]:
    """A spoked cart wheel about the x axis; ``rim``: its height, by the radius."""
    inner, half = (1 - rim) * radius, width / 2
    band = [(inner, -half), (radius, -half), (radius, half), (inner, half)]
    spoke = rod((0, 0, 0), (0, 0, inner + 0.02 * radius), 0.05 * radius, 0.038 * radius)
    hub = rod((-0.8 * width, 0, 0), (0.8 * width, 0, 0), 0.16 * radius, rim=0.01)
    return [turned(band, axis="x"), *spun([spoke], spokes, "x"), hub]


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
    under += [rod((wide + 0.09, -0.2, floor - 0.05), (wide + 0.13, -0.32, floor + 0.42), 0.02)]
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
    axis = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]])
    barrel = placed([turned([*profile, (0, long - 0.2)])], tilt @ axis, (0, 0, 0.62))
    trunnions = rod((-0.3, 0, 0.6), (0.3, 0, 0.6), 0.055, rim=0.01)
    cheek = [(-0.32, 0.34), (-0.3, 0.56), (-0.12, 0.62), (0.12, 0.62), (0.3, 0.5), (0.5, 0.44)]
    cheek += [(0.7, 0.32), (1.25, 0.06), (1.25, -0.0), (1.05, -0.0), (0.5, 0.2), (0.1, 0.3)]
    sides = both_sides([plate(cheek, 0.08, (0.225, 0, 0), SIDE)])
    cross = [box((0.42, 0.09, 0.14), (0, y, z), 0.01) for y, z in ((0.62, 0.28), (1.1, 0.07))]
    cross += [box((0.44, 0.12, 0.1), (0, -0.18, 0.42), 0.01)]
    cross += [rod((-0.5, 0, 0.44), (0.5, 0, 0.44), 0.05)]
    tail = ring(0.075, 0.024, (0, 1.28, 0.05), "x")
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
    facing = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]])
    cup = placed([turned([*bowl, (0.0, 0.05)])], beam @ facing, beam @ (0, -0.03, 1.3) + axle)
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


def _helicopter(draw: Draw) -> Parts:
    blades, reach = 2 + draw.which(3), draw(0.98, 1.1)
    cabin = [(0, -0.72), (0.16, -0.7), (0.3, -0.58), (0.37, -0.36), (0.38, -0.1), (0.34, 0.2)]
    cabin += [(0.24, 0.44), (0.13, 0.62), (0, 0.66)]
    forward = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]])
    body = placed([turned(curve(cabin))], forward, (0, -0.02, 0))
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
    forward = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]])
    body = placed([turned(nose)], forward)
    engine = [box((0.22, 1.25, 0.22), (0.18, 0.18, -0.03), 0.05)]
    inlet = [(-0.62, 0.1), (-0.44, 0.1), (-0.3, 0.11), (-0.3, -0.14), (-0.52, -0.14)]
    engine += [plate(inlet, 0.2, (0.185, 0, 0), SIDE)]
    strake = [(0.1, -0.72), (0.2, -0.5), (0.3, -0.25), (0.3, 0.1), (0.1, 0.1)]
    body += both_sides([*engine, plate(strake, 0.04, (0, 0, 0.06))])
    body += [capsule((0, -0.35, 0.12), (0, 0.5, 0.08), 0.12, 0.08)]
    wing = [(0.2, -0.3), (span, -0.3 + sweep + 0.28), (span, 0.32), (0.2, 0.42)]
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
    back = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]])
    nozzles = placed([turned([(0, 0), *mouth[1:]])], back, (0.165, 0.72, -0.02))
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
    shell = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]])
    handle = [one for one in handle[:-1]] + placed(
        [turned([(0, 0), (0.05, 0.0), (0.11, 0.06), (0.125, 0.15), (0, 0.15)])],
        shell,
        (0, -0.56, 0.87),
    )
    lamp = [ball((0.105, 0.05, 0.105), (0, -0.71, 0.87))]
    lamp += [box((0.12, 0.06, 0.06), (0, 1.18, 0.52), 0.02)]
    return {
        "body": [*body, box((0.04, 0.16, 0.03), (0, 1.12, 0.56))],
        "wheels": tyres,
        "engine": [*metal, *block],
        "seat": seat,
        "handlebar": handle,
        "lamp": lamp,
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
        plate([(-1.0, 0.32), (-1.12, 0.29), (-1.02, 0.27)], 0.045, (0, 0, 0), SIDE),
    ]
    prows += both_sides([rod((0.02, -0.94, 0.43), (0.05, -0.86, 0.53), 0.022, 0.006)])
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
        oars.append(box((0.02, 0.06, 0.13), (wide + 0.35, y + 0.05, -0.46), 0.006, (0, 50, 0)))
    sail, stripes = [], []
    for k in range(6):
        x = (k - 2.5) * 0.14
        (stripes if k % 2 else sail).append(_sail(0.142, 0.66, (x, -0.03, 0.74)))
    shields = []
    for k, y in enumerate(np.linspace(-0.52, 0.52, count)):
        side = wide * (1.02 - 0.42 * abs(y / 0.6) ** 2.4)
        shields += [
            rod((side - 0.03, y, -0.1), (side + 0.03, y, -0.1), 0.068, rim=0.01),
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
    back = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]])
    hull = placed([turned(nose)], back)
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
    engines = placed([turned(cell)], back, (0.28, 0.6, 0.0))
    engines += [ring(0.15, 0.02, (0.28, 0.66, 0.0), "y"), ring(0.152, 0.02, (0.28, 0.54, 0.0), "y")]
    flame = [(0, 0.1), (0.075, 0.12), (0.09, 0.24), (0.05, 0.42), (0, 0.56)]
    flames = placed([turned([*flame])], back, (0.28, 0.6, 0.0))
    canopy = [ball((0.13, 0.34, 0.13), (0, -0.34, 0.16), (-5, 0, 0))]
    return {
        "hull": hull,
        "wings": both_sides(wings),
        "cockpit": canopy,
        "guns": both_sides(guns),
        "engines": both_sides(engines),
        "flames": both_sides(flames),
    }


REDRAWN_VEHICLES: dict[str, Callable[[Draw], Parts]] = {
    "pirate ship": _pirate_ship,
    "wagon": _wagon,
    "cannon": _cannon,
    "catapult": _catapult,
    "helicopter": _helicopter,
    "fighter jet": _fighter_jet,
    "motorcycle": _motorcycle,
    "longship": _longship,
    "spaceship": _spaceship,
}
