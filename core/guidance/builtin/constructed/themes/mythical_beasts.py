"""The pegasus, the griffin and the dragon."""

from collections.abc import Callable

import numpy as np

from core.geometry.parts.primitives import Primitive
from core.guidance.builtin.constructed.anatomy import (
    along,
    aside,
    body,
    eyes_on,
    paw,
    spine,
    with_legs,
)
from core.guidance.builtin.constructed.carnivore import Build, carnivore
from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.shapes import (
    SIDE,
    Parts,
    ball,
    both_sides,
    joined,
    limb,
    mirrored_limbs,
    plate,
    smooth_union,
)
from core.guidance.builtin.constructed.themes.horses import HORSES
from core.guidance.builtin.constructed.wings import feathered_wing, skin_wing


def _pegasus(draw: Draw) -> Parts:
    horse = HORSES["horse"](draw)
    arm, feathers = feathered_wing((0.11, -0.18, 0.86), 0.95 * draw(0.92, 1.1))
    return {
        "body": horse["body"],
        "wings": both_sides([arm]),
        "feathers": both_sides([feathers]),
        **{name: horse[name] for name in ("mane", "hooves", "eyes")},
    }


def _griffin(draw: Draw) -> Parts:
    build = Build(head=0.98, muzzle=0.35, snub=0.85, thick=1.1, stout=1.04)
    one = carnivore(build, draw)
    tail = spine(
        (0.48, 0.85, 0.034, 1), (0.64, 0.78, 0.03, 1), (0.76, 0.6, 0.026, 1), (0.86, 0.5, 0.024, 1)
    )
    whole = one.whole(tail)
    tuft = spine((0.84, 0.52, 0.03, 1), (0.92, 0.46, 0.055, 1), (1.02, 0.44, 0.008, 1))
    chest = [
        spine(
            (-0.34, 0.72, 0.2, 0.86),
            (-0.38, 0.86, 0.185, 0.86),
            (-0.46, 1.0, 0.15, 0.9),
            (-0.53, 1.1, 0.135, 0.95),
        )
    ]
    chest += one.on_head(
        spine((-0.55, 1.17, 0.145, 1.02), (-0.66, 1.17, 0.145, 1.02), (-0.72, 1.15, 0.12, 1.0))
    )
    locks = []
    for k in range(26):  # rows of feathers around the neck
        row, t = divmod(k, 7)
        angle = np.pi * (t + 0.5 * (row % 2)) / 3.25 - np.pi
        at = np.array(
            (0.125 * np.sin(angle), -0.5 + 0.05 * row - 0.12 * np.cos(angle), 1.08 - 0.1 * row)
        )
        locks.append(
            aside(
                (*at, 0.045),
                (*(at + (0.05 * np.sin(angle), -0.02 * np.cos(angle), -0.07)), 0.03),
                (*(at + (0.075 * np.sin(angle), -0.03 * np.cos(angle), -0.12)), 0.006),
            )
        )
    ears = one.on_head(
        aside(
            (0.07, -0.55, 1.27, 0.035, 0.8),
            (0.085, -0.53, 1.34, 0.03, 0.7),
            (0.09, -0.5, 1.42, 0.008, 1),
        )
    )
    head = smooth_union([*chest, *locks, *mirrored_limbs(ears)], 0.02)
    bill = one.on_head(
        spine(
            (-0.73, 1.17, 0.066, 0.85),
            (-0.82, 1.165, 0.052, 0.75),
            (-0.88, 1.12, 0.034, 0.7),
            (-0.885, 1.06, 0.01, 0.8),
        ),
        spine((-0.72, 1.12, 0.04, 0.9), (-0.82, 1.1, 0.022, 0.8)),
    )
    arm, feathers = feathered_wing((0.13, -0.2, 0.86), 0.95 * draw(0.92, 1.08))
    eyes = eyes_on(head, one.place(-0.68, 1.21), (-1, 0.35, 0), 0.028, 0.35)
    return {
        "body": [whole, *one.paws],
        "feathers": [head],
        "wings": both_sides([joined(arm, feathers)]),
        "bill": [smooth_union(bill, 0.012)],
        "tuft": [smooth_union([tuft], 0.02)],
        "eyes": eyes,
    }


def _dragon(draw: Draw) -> Parts:
    trunk = spine(
        (-0.34, 0.66, 0.17, 0.86),
        (-0.16, 0.62, 0.215, 0.9),
        (0.08, 0.62, 0.22, 0.95),
        (0.3, 0.68, 0.185, 0.95),
        (0.42, 0.7, 0.15, 1),
    )
    neck = spine(
        (-0.28, 0.76, 0.16, 0.8),
        (-0.46, 0.96, 0.115, 0.85),
        (-0.52, 1.2, 0.095, 0.9),
        (-0.58, 1.4, 0.095, 0.9),
    )
    skull = spine(
        (-0.56, 1.44, 0.1, 0.95),
        (-0.67, 1.46, 0.098, 1.0),
        (-0.78, 1.4, 0.072, 1.0),
        (-0.92, 1.37, 0.06, 1.05),
    )
    jaw = spine((-0.66, 1.36, 0.06, 0.95), (-0.88, 1.31, 0.038, 1.1))
    curl = draw(-0.12, 0.12)
    tail = spine(
        (0.4, 0.72, 0.13, 1),
        (0.66, 0.58, 0.1, 1),
        (0.95, 0.4, 0.07, 1),
        (1.22, 0.34 + 0.3 * abs(curl), 0.045, 1),
        (1.42, 0.42 + 0.6 * abs(curl), 0.02, 1),
    )
    front = aside(
        (0.12, -0.28, 0.66, 0.11),
        (0.17, -0.27, 0.46, 0.075),
        (0.165, -0.22, 0.3, 0.055),
        (0.165, -0.27, 0.12, 0.05),
        (0.165, -0.3, 0.06, 0.05),
    )
    hind = aside(
        (0.11, 0.34, 0.66, 0.16),
        (0.17, 0.28, 0.46, 0.115),
        (0.17, 0.4, 0.28, 0.06),
        (0.165, 0.42, 0.13, 0.048),
        (0.165, 0.38, 0.06, 0.05),
    )
    nose = aside((0.04, -0.93, 1.41, 0.03), (0.04, -0.96, 1.39, 0.02))
    brow = aside((0.07, -0.66, 1.53, 0.03), (0.062, -0.74, 1.5, 0.03))
    spikes = []
    back = [
        (0, -0.5, 1.34),
        (0, -0.44, 1.12),
        (0, -0.28, 0.93),
        (0, -0.05, 0.86),
        (0, 0.2, 0.87),
        (0, 0.42, 0.86),
        (0, 0.66, 0.68),
        (0, 0.95, 0.47),
    ]
    for t in np.linspace(0, 1, 15):
        _, y, z = along(back, t)
        high = 0.055 + 0.05 * np.sin(np.pi * t)
        spikes.append(
            limb(
                [(0, y, z - 0.03), (0, y + 0.03, z + 0.4 * high), (0, y + 0.09, z + high)],
                [0.045, 0.032, 0.006],
                0.45,
            )
        )
    whole = body([trunk, neck, skull, jaw, tail, *spikes], [front, hind, nose, brow], 0.024)
    belly = spine(
        (-0.52, 1.22, 0.07, 0.9),
        (-0.5, 1.0, 0.09, 0.9),
        (-0.38, 0.74, 0.14, 0.85),
        (-0.2, 0.58, 0.18, 0.85),
        (0.08, 0.57, 0.18, 0.9),
        (0.3, 0.62, 0.13, 1.0),
        (0.6, 0.56, 0.08, 1.0),
    )
    belly = belly + np.array([0, -0.012, -0.012, 0.008, 0])
    skin, bones = skin_wing((0.12, -0.2, 0.82), 0.95 * draw(0.92, 1.1))
    horns = [
        aside((0.055, -0.56, 1.52, 0.036), (0.085, -0.46, 1.6, 0.03), (0.1, -0.34, 1.72, 0.008)),
        aside((0.09, -0.57, 1.45, 0.024), (0.13, -0.5, 1.48, 0.018), (0.15, -0.43, 1.52, 0.006)),
    ]
    tip = plate(
        [(-0.02, 0.0), (0.1, 0.09), (0.27, 0.0), (0.1, -0.09)],
        0.035,
        (0, 1.4, 0.42 + 0.6 * abs(curl)),
        SIDE,
    )
    eyes = eyes_on(whole, (0, -0.715, 1.475), (-1, 0.35, -0.05), 0.03, 0.4)
    claws = []
    for y in (-0.315, 0.375):
        claws += [
            smooth_union(
                [
                    aside(
                        (0.165 + x, y - 0.075 + abs(x) * 0.3, 0.03, 0.018),
                        (0.165 + 1.2 * x, y - 0.135 + abs(x) * 0.3, 0.008, 0.006),
                    )
                ],
                0.004,
            )
            for x in (-0.04, 0.0, 0.04)
        ]
    return {
        "body": [whole, *both_sides([paw(0.165, -0.315, 0.075, 3), paw(0.165, 0.375, 0.075, 3)])],
        "belly": [smooth_union([belly], 0.02)],
        "wings": both_sides([*skin, *bones]),
        "horns": [tip, *both_sides([*(smooth_union([one], 0.005) for one in horns), *claws])],
        "eyes": eyes,
        "pupils": both_sides([_pupil(eyes[0])]),
    }


def _pupil(eye: Primitive) -> Primitive:
    """A slit on the left eye."""
    r = float(max(eye.lengths))
    return ball(
        (0.3 * r, 0.28 * r, 0.75 * r), eye.center + np.array((0.8 * r, -0.42 * r, 0.05 * r))
    )


MYTHICAL_BEASTS: dict[str, Callable[[Draw], Parts]] = {
    "pegasus": _pegasus,
    "griffin": with_legs(_griffin),
    "dragon": with_legs(_dragon, 0.95, 1.05),
}
