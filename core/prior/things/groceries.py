"""Meat, cheese, eggs, and food in cans, jars and cartons."""

import math

import torch
from torch import Tensor

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
    around,
    ball,
    both,
    box,
    capsule,
    cut,
    egg,
    join,
    lathe,
    limb,
    prism,
    ring,
    smooth_curve,
    taper,
    tube,
    turned,
)


def steak(draw: Draw) -> Parts:
    """A T-bone steak that lies flat: a rim of fat, marks of the grill."""
    long, wide, z = draw(1.1, 1.22), draw(0.85, 0.95), draw(0.2, 0.25)
    tail, rim, bone = draw(0.45, 0.55), draw(0.88, 0.91), draw(0.11, 0.13)
    right = [(0.0, long * 0.86), (wide * 0.5, long * 0.95), (wide, long * 0.5), (wide * 0.85, -0.1)]
    right += [(wide * tail, -long * 0.75), (0.0, -long)]
    edge = smooth_curve(right)
    outline = edge + [(-x, y) for x, y in edge[-2:0:-1]]
    inner = [(x * rim, y * rim) for x, y in outline]
    high = 2 * z
    marks = [
        turned(box((s, -0.05, high + 0.03), (0.07, length, 0.05)), 2, -32)
        for s, length in ((-0.42, 0.3), (0.0, 0.55), (0.42, 0.3))
    ]
    cross = box((0, long * 0.62, z + 0.02), (wide * 0.62, bone, z + 0.03), 0.02)
    stem = prism(
        [(-bone, long * 0.6), (bone, long * 0.6), (bone * 0.75, -0.35), (-bone * 0.75, -0.35)],
        2,
        z + 0.025,
        z + 0.025,
    )
    return {
        "fat": prism(outline, 2, z * 0.6, z),
        "meat": prism(inner, 2, z + 0.02, z + 0.02),
        "bone": join(cross, stem),
        "marks": join(*marks),
    }


def _waved(solid: Solid, high: float, long: float, phase: float) -> Solid:
    """``solid`` waved up and down, and less to and fro, along x; a lower bound of the distance."""
    pace = math.tau / long
    slope = high * pace * 1.1
    stretch = (slope + math.hypot(slope, 2)) / 2

    def distance(p: Tensor) -> Tensor:
        lift = high * torch.sin(p[:, 0] * pace + phase)
        aside = 0.5 * high * torch.sin(p[:, 0] * pace)
        return solid(torch.stack([p[:, 0], p[:, 1] - aside, p[:, 2] - lift], 1)) / stretch

    return distance


def bacon(draw: Draw) -> Parts:
    """Two wavy rashers side by side, red meat between bold stripes of fat."""
    long, half, high = draw(1.32, 1.4), draw(0.47, 0.5), draw(0.13, 0.15)

    def rasher(phase: float, at: float, rise: float, *bands: tuple[float, float, float]) -> Solid:
        """Bands of a rasher at ``at``: the middle and half of their width, half their height."""
        flat = (
            box((0, at + v * half, rise), (long, w * half, thick), 0.06) for v, w, thick in bands
        )
        return _waved(join(*flat), high, 1.3, phase)

    fat = ((-0.6, 0.2, 0.2), (0.02, 0.13, 0.2), (0.6, 0.17, 0.2))
    lie = [(0.4, -half * 0.98, 0.0), (2.0, half * 0.98, 0.1)]
    return {
        "meat": join(*(rasher(*one, (0, 0.96, 0.15)) for one in lie)),
        "fat": join(*(rasher(*one, *fat) for one in lie)),
    }


def chicken_drumstick(draw: Draw) -> Parts:
    """Roasted, on its thick end, two knobs at the end of its bone."""
    r, high, neck = draw(0.66, 0.75), draw(1.5, 1.7), draw(0.2, 0.24)
    bone, knob, long = draw(0.14, 0.16), draw(0.2, 0.24), draw(0.42, 0.52)
    side = [(0.0, 0.0), (r * 0.7, 0.1), (r, high * 0.32), (r * 0.86, high * 0.58)]
    side += [(neck + 0.08, high * 0.9), (neck, high)]
    top = high + long
    return {
        "meat": lathe(smooth_curve(side), 0.01),
        "bone": join(
            tube((0, 0, high - 0.2), (0, 0, top + 0.05), bone),
            both(ball((knob * 0.68, 0, top + knob * 0.4), knob)),
        ),
        "cuff": ring((0, 0, high - 0.02), neck - 0.02, 0.1),
    }


def roast_chicken(draw: Draw) -> Parts:
    """Plump, on its back, the drumsticks to the front, on a platter with leaves and tomatoes."""
    wide, long, layout = draw(0.54, 0.62), draw(0.66, 0.76), draw.arranged(3)
    plate, z = draw(1.04, 1.14), 0.5
    breast = both(egg((0.17, 0.0, z + 0.14), (wide * 0.74, long, draw(0.44, 0.5))))
    knee, ankle = (wide * 0.96, -0.12, z + 0.02), (0.27, -long - 0.16, z + 0.3)
    thigh = taper((wide * 0.8, 0.06, z), knee, 0.3, 0.27)
    drum = taper(knee, ankle, 0.27, 0.13)
    end = (0.2, -long - 0.4, z + 0.42)
    x, y, up = end
    knobs = ball((x + 0.06, y, up), 0.105), ball((x - 0.05, y, up + 0.05), 0.105)
    bone = join(capsule(ankle, end, 0.085), *knobs)
    elbow = (wide + 0.14, 0.3, z)
    wing = limb([(wide * 0.7, 0.4, z + 0.2), elbow, (wide * 0.9, 0.56, z - 0.06)], 0.17, 0.13)
    dish = [(0.0, 0.0), (plate * 0.66, 0.0), (plate, 0.15), (plate, 0.26), (plate * 0.7, 0.13)]
    dish += [(0.0, 0.13)]
    leaves, tomatoes = [], []
    for k in range(11):
        turn = math.tau * (k + 0.5) / 11 + layout(-0.12, 0.12)
        leaf = egg((plate * 0.78, 0, 0.27), (0.23, layout(0.19, 0.25), 0.11))
        leaves.append(turned(leaf, 2, math.degrees(turn)))
        if k % 3 == 0:
            at = turn + 0.26
            out = plate * 0.82
            tomatoes.append(ball((out * math.cos(at), out * math.sin(at), 0.38), 0.17))
    return {
        "meat": join(breast, egg((0, 0.06, z), (wide, long * 0.96, 0.44)), both(wing)),
        "drumsticks": both(join(thigh, drum)),
        "bones": both(bone),
        "platter": lathe(dish, 0.02),
        "leaves": join(*leaves),
        "tomatoes": join(*tomatoes),
    }


def egg_(draw: Draw) -> Parts:
    """A hen's egg, its tip up."""
    wide, high = draw(0.7, 0.78), draw(1.9, 2.1)
    low = egg((0, 0, 0), (wide, wide, high * 0.43))
    top = egg((0, 0, 0), (wide, wide, high * 0.57))
    half = 2.0
    return {
        "shell": join(
            cut(low, box((0, 0, half + 0.01), (2, 2, half))),
            cut(top, box((0, 0, -half - 0.01), (2, 2, half))),
        )
    }


def cheese(draw: Draw) -> Parts:
    """A wedge with holes and a rind at its back."""
    wide, long, high = draw(0.7, 0.85), draw(0.95, 1.15), draw(0.7, 0.9)
    side = [(-wide, long), (wide, long), (0.06, -long), (-0.06, -long)]
    # Where the long side stands at a height along the wedge, from its tip.
    holes = []
    for k, z, size in ((0.3, 0.35, 0.13), (0.52, 0.62, 0.17), (0.75, 0.3, 0.2), (0.86, 0.72, 0.13)):
        x, y = wide * k, -long + 2 * long * k
        holes += [ball((x, y, high * z), size), ball((-x + 0.03, y - 0.15, high * (1 - z)), size)]
    holes += [
        ball((0.1, 0.2, high), 0.2),
        ball((-0.25, 0.62, high), 0.17),
        ball((0.0, -0.4, high), 0.13),
    ]
    return {
        "body": cut(prism(side, 2, high / 2, high / 2), *holes),
        "rind": box((0, long + 0.03, high / 2), (wide + 0.04, 0.09, high / 2 + 0.02), 0.03),
    }


def can(draw: Draw) -> Parts:
    """A drink's can with a tapering neck, or a tin; a label about it."""
    wide, high = draw(0.55, 0.65), draw(1.6, 2.0)
    if draw.chance(0.6):
        low, neck = wide * 0.8, wide * 0.8
        tab = box((0, -0.12, high), (0.14, 0.22, 0.06), 0.04)
    else:
        high, low, neck = high * 0.75, wide * 1.0, wide * 1.0
        tab = tube((0, 0, high - 0.1), (0, 0, high + 0.03), wide * 0.72, 0.02)
    shape = [(low, 0), (wide, 0.14), (wide, high - 0.2), (neck, high - 0.02)]
    rim = tube((0, 0, high - 0.1), (0, 0, high + 0.06), neck + 0.04, 0.04)
    rim = cut(rim, tube((0, 0, high), (0, 0, high + 1), neck - 0.09))
    foot = tube((0, 0, 0), (0, 0, 0.1), low + 0.03, 0.03)
    label = tube((0, 0, 0.2), (0, 0, high - 0.26), wide + 0.03)
    return {"label": label, "can": join(lathe(shape, 0.01), rim, foot), "tab": tab}


def jar(draw: Draw) -> Parts:
    """A glass with shoulders, a wide lid and a label."""
    wide, high, neck = draw(0.62, 0.75), draw(1.2, 1.55), draw(0.46, 0.54)
    shape = [(wide - 0.1, 0), (wide, 0.1), (wide, high - 0.2), (wide - 0.05, high - 0.08)]
    body = lathe([*shape, (neck, high), (neck, high + 0.14)], 0.02)
    lid = tube((0, 0, high + 0.06), (0, 0, high + 0.36), neck + 0.13, 0.05)
    tall = high * draw(0.2, 0.28)
    band = tube((0, 0, high * 0.45 - tall), (0, 0, high * 0.45 + tall), wide + 0.05)
    label = cut(band, box((0, 2, 1), (3, 1.9, 3))) if draw.chance(0.5) else band
    grip = around(14, capsule((neck + 0.12, 0, high + 0.14), (neck + 0.12, 0, high + 0.3), 0.07))
    return {"body": body, "lid": join(lid, grip), "label": label}


def milk_carton(draw: Draw) -> Parts:
    """A square carton with a gable, its seam up, a cap or a coloured band."""
    wide, high, gable = draw(0.48, 0.56), draw(1.4, 1.75), draw(0.4, 0.5)
    roof = prism([(-wide, high - 0.02), (wide, high - 0.02), (0, high + gable)], 0, wide)
    seam = box((0, 0, high + gable + 0.02), (wide, 0.085, 0.16), 0.02)
    low = high * draw(0.2, 0.35)
    band = box((0, 0, low), (wide + 0.03, wide + 0.03, high * 0.17), 0.01)
    z = high + gable * 0.5
    cap = tube((0, -wide * 0.4, z - 0.08), (0, -wide * 0.5 - 0.2, z + 0.17), 0.2, 0.03)
    return {
        "carton": box((0, 0, high / 2), (wide, wide, high / 2), 0.02),
        "top": join(roof, seam, band),
        "cap": cap,
    }


GROCERIES = {
    "steak": steak,
    "bacon": bacon,
    "chicken drumstick": chicken_drumstick,
    "roast chicken": roast_chicken,
    "egg": egg_,
    "cheese": cheese,
    "can": can,
    "jar": jar,
    "milk carton": milk_carton,
}
