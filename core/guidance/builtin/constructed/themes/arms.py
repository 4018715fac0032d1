"""Arms that the networks know and drew roughly."""

from collections.abc import Callable

import numpy as np

from core.geometry.parts.primitives import Primitive
from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.shapes import (
    FRONT,
    LEFTWARD,
    SIDE,
    Corners,
    Parts,
    ball,
    both_sides,
    box,
    capsule,
    pipe,
    placed,
    plate,
    ring,
    rod,
    turned,
)


def _bevelled(outline: Corners, thick: float, rim: float = 0.012) -> list[Primitive]:
    """A plate that looks to the front, thinner along its edge."""
    loop = np.array(outline, float)
    middle = (loop.min(0) + loop.max(0)) / 2
    size = loop.max(0) - loop.min(0)
    inner = (loop - middle) * (1 - 2 * rim / size) + middle
    return [plate(loop, thick - 2 * rim, (0, 0, 0), FRONT), plate(inner, thick, (0, 0, 0), FRONT)]


def _crossbow(draw: Draw) -> Parts:
    half, bend = draw(0.62, 0.7), draw(0.16, 0.24)
    butt = [(0.055, 0.5), (0.06, -0.05), (0.1, -0.2), (0.075, -0.34), (0.1, -0.5), (0.2, -0.84)]
    butt += [(0.02, -0.88), (-0.06, -0.5), (-0.055, -0.3), (-0.06, 0.5)]
    stock = [
        plate(butt, 0.11, (0, 0, 0), SIDE),
        plate(np.array(butt) * (0.8, 0.99), 0.13, (0, 0.005, 0), SIDE),
    ]
    stock += both_sides([box((0.028, 0.04, 0.66), (0.038, -0.07, 0.15), 0.006)])
    x = np.linspace(-half, half, 17)
    z = 0.44 - bend * (np.abs(x) / half) ** 1.7
    deep = 0.045 - 0.022 * np.abs(x) / half
    bow = np.concatenate([np.stack([x, z + deep], 1), np.stack([x, z - deep], 1)[::-1]])
    limbs = [plate(bow, 0.07, (0, -0.02, 0), FRONT), box((0.2, 0.15, 0.11), (0, -0.01, 0.45), 0.02)]
    limbs += both_sides([ball((0.034, 0.04, 0.034), (half, -0.02, 0.44 - bend))])
    stirrup = [(-0.055, -0.01, 0.5), (-0.12, -0.01, 0.6), (-0.08, -0.01, 0.73), (0.0, -0.01, 0.755)]
    stirrup += [(-x, y, z) for x, y, z in stirrup[2::-1]]
    nut = (0.0, -0.085, -0.1)
    string = both_sides([rod((half, -0.03, 0.44 - bend), nut, 0.012)])
    wound = [rod((-0.07, *nut[1:]), (0.07, *nut[1:]), 0.016)]
    bolt = [rod((0, -0.1, -0.1), (0, -0.1, 0.6), 0.019)]
    bolt += [
        box((0.09, 0.01, 0.12), (0, -0.1, -0.02), 0.004),
        box((0.012, 0.045, 0.12), (0, -0.125, -0.02), 0.004),
    ]
    point = [(0.0, 0.8), (0.05, 0.62), (0.02, 0.6), (-0.02, 0.6), (-0.05, 0.62)]
    lever = [(0, 0.05, -0.16), (0, 0.13, -0.22), (0, 0.16, -0.34), (0, 0.14, -0.42)]
    guard = [(0, 0.06, -0.06), (0, 0.2, -0.12), (0, 0.23, -0.3), (0, 0.1, -0.42)]
    return {
        "stock": stock,
        "limbs": limbs,
        "string": [*string, *wound],
        "bolt": bolt,
        "point": [
            plate(point, 0.03, (0, -0.1, 0), FRONT),
            rod((0, -0.1, 0.57), (0, -0.1, 0.63), 0.028),
        ],
        "trigger": [
            pipe(lever, 0.018),
            pipe(guard, 0.013),
            rod((0, -0.105, -0.1), (0, -0.03, -0.1), 0.04),
            pipe(stirrup, 0.02),
        ],
    }


def _bow(draw: Draw) -> Parts:
    curl, deep = draw(0.06, 0.12), draw(0.4, 0.48)
    half = [(-0.19, 0.0), (-0.2, 0.16), (-0.13, 0.36), (0.04, 0.58), (deep - 0.1, 0.74)]
    half += [(deep - 0.02, 0.83), (deep - 0.02 - curl, 0.9)]
    radii = (0.045, 0.042, 0.04, 0.036, 0.03, 0.026, 0.022)
    upper = pipe([(x, 0, z) for x, z in half], radii)
    lower = pipe([(x, 0, -z) for x, z in half], radii)
    tip = (deep - 0.03, 0, 0.81)
    ends = [(*tip[:2], s * tip[2]) for s in (1, -1)]
    knots = [rod((x, y, z - 0.02), (x, y, z + 0.02), 0.04, rim=0.01) for x, y, z in ends]
    bands = [ring(0.05, 0.016, (-0.2, 0, z)) for z in (-0.15, 0.15)]
    for z in (0.56, -0.56):
        bands.append(ball((0.05, 0.048, 0.05), (0.025, 0, z)))
    shaft = [rod((-0.57, -0.02, 0.03), (deep + 0.03, -0.02, 0.03), 0.014)]
    head = [(-0.62, 0.03), (-0.5, 0.075), (-0.52, 0.03), (-0.5, -0.015)]
    shaft += [plate(head, 0.024, (0, -0.02, 0), FRONT)]
    vane = [(deep - 0.2, 0.03), (deep - 0.15, 0.1), (deep - 0.02, 0.1), (deep, 0.03)]
    down = [(x, 0.06 - z) for x, z in vane]
    across = [(x, -0.02 + k * (z - 0.03)) for k in (1,) for x, z in vane]
    feathers = [plate(one, 0.016, (0, -0.02, 0), FRONT) for one in (vane, down)]
    feathers += [
        plate(across, 0.016, (0, 0, 0.03)),
        plate([(x, -0.04 - y) for x, y in across], 0.016, (0, 0, 0.03)),
    ]
    return {
        "limbs": [upper, lower],
        "grip": [capsule((-0.2, 0, -0.12), (-0.2, 0, 0.12), 0.06)],
        "bands": [*bands, *knots],
        "string": [rod(ends[0], ends[1], 0.0095)],
        "arrow": shaft,
        "feathers": feathers,
    }


def _rifle(draw: Draw) -> Parts:
    long = draw(0.82, 0.95)
    barrel = [rod((-0.5, 0, 0.08), (-long - 0.16, 0, 0.08), 0.026)]
    barrel += placed(
        [turned([(0, 0), (0.04, 0), (0.04, 0.14), (0.018, 0.14), (0.018, 0.05), (0, 0.05)])],
        LEFTWARD,
        (-long - 0.1, 0, 0.08),
    )
    barrel += [
        box((0.03, 0.02, 0.09), (-long + 0.02, 0, 0.14), 0.004),
        rod((-0.6, 0, 0.03), (-long + 0.06, 0, 0.03), 0.016),
    ]
    barrel += [box((0.05, 0.05, 0.1), (-long + 0.06, 0, 0.055), 0.01)]
    receiver = [
        (-0.28, -0.03),
        (0.3, -0.03),
        (0.36, 0.03),
        (0.34, 0.12),
        (0.2, 0.15),
        (-0.28, 0.14),
    ]
    body = [*_bevelled(receiver, 0.11), box((0.6, 0.05, 0.02), (0.0, 0, 0.152), 0.004)]
    body += [box((0.024, 0.06, 0.012), (x, 0, 0.166), 0.002) for x in np.arange(-0.26, 0.29, 0.05)]
    body += [rod((0.18, -0.05, 0.1), (0.2, -0.13, 0.08), 0.014), ball(0.024, (0.205, -0.14, 0.078))]
    butt = [(0.28, 0.1), (0.4, 0.07), (0.82, 0.08), (0.86, 0.06), (0.87, -0.2), (0.83, -0.22)]
    butt += [(0.5, -0.08), (0.36, -0.05), (0.33, -0.28), (0.25, -0.32), (0.19, -0.29), (0.2, -0.06)]
    fore = [(-0.62, 0.03), (-0.6, 0.1), (-0.26, 0.12), (-0.26, -0.02), (-0.58, 0.0)]
    stock = [*_bevelled(butt, 0.1, 0.016), *_bevelled(fore, 0.115, 0.016)]
    magazine = [
        (-0.16, 0.0),
        (-0.01, 0.0),
        (-0.03, -0.18),
        (-0.09, -0.36),
        (-0.24, -0.3),
        (-0.18, -0.16),
    ]
    scope = placed(
        [
            turned(
                [
                    (0, -0.3),
                    (0.06, -0.3),
                    (0.065, -0.18),
                    (0.042, -0.12),
                    (0.042, 0.12),
                    (0.072, 0.18),
                    (0.075, 0.32),
                    (0.06, 0.33),
                    (0.055, 0.28),
                    (0, 0.28),
                ]
            )
        ],
        LEFTWARD,
        (0, 0, 0.26),
    )
    scope += [box((0.06, 0.06, 0.12), (x, 0, 0.19), 0.008) for x in (-0.1, 0.1)]
    scope += [
        rod((0, 0, 0.28), (0, 0, 0.335), 0.03, rim=0.006),
        rod((0, -0.02, 0.26), (0, -0.07, 0.26), 0.028, rim=0.006),
    ]
    guard = [(-0.0, 0, -0.02), (0.02, 0, -0.11), (0.12, 0, -0.12), (0.2, 0, -0.06)]
    return {
        "barrel": barrel,
        "body": body,
        "stock": [*stock, box((0.03, 0.09, 0.26), (0.875, 0, -0.07), 0.01)],
        "magazine": [
            plate(magazine, 0.065, (0, 0, 0), FRONT),
            box((0.02, 0.08, 0.02), (-0.1, 0, -0.04)),
        ],
        "scope": scope,
        "trigger": [
            pipe(guard, 0.012),
            pipe([(0.1, 0, -0.01), (0.085, 0, -0.06), (0.1, 0, -0.1)], 0.014),
        ],
    }


def _shotgun(draw: Draw) -> Parts:
    long = draw(0.9, 1.0)
    tube = [(0, 0), (0.042, 0), (0.042, long), (0.026, long), (0.026, long - 0.1), (0, long - 0.1)]
    barrel = placed([turned(tube)], LEFTWARD, (0.0, 0, 0.13))
    barrel += [rod((0, 0, 0.035), (-long + 0.16, 0, 0.035), 0.036, rim=0.006)]
    barrel += [
        box((0.05, 0.1, 0.16), (-long + 0.2, 0, 0.085), 0.012),
        ball(0.02, (-long + 0.03, 0, 0.178)),
    ]
    barrel += [box((long - 0.1, 0.02, 0.018), (-long / 2 + 0.02, 0, 0.175))]
    receiver = [(-0.1, -0.04), (0.26, -0.05), (0.36, 0.02), (0.32, 0.14), (0.2, 0.18), (-0.1, 0.18)]
    body = _bevelled(receiver, 0.12)
    guard = [(0.06, 0, -0.04), (0.08, 0, -0.13), (0.2, 0, -0.14), (0.28, 0, -0.05)]
    body += [
        pipe(guard, 0.014),
        pipe([(0.17, 0, -0.03), (0.155, 0, -0.08), (0.17, 0, -0.12)], 0.015),
    ]
    butt = [
        (0.28, 0.1),
        (0.42, 0.06),
        (0.8, 0.03),
        (0.8, -0.26),
        (0.56, -0.14),
        (0.4, -0.1),
        (0.28, -0.04),
    ]
    stock = _bevelled(butt, 0.1, 0.018)
    grip = [rod((-0.62, 0, 0.035), (-0.24, 0, 0.035), 0.07, rim=0.02)]
    grip += [
        rod((x - 0.012, 0, 0.035), (x + 0.012, 0, 0.035), 0.078, rim=0.004)
        for x in np.arange(-0.57, -0.27, 0.05)
    ]
    shells = []
    for x in (0.0, 0.07, 0.14, 0.21):
        shells += [rod((x, -0.085, 0.0), (x, -0.085, 0.13), 0.028, rim=0.004)]
    return {
        "barrel": barrel,
        "body": [*body, box((0.3, 0.03, 0.04), (0.1, -0.066, 0.05), 0.006)],
        "stock": stock,
        "pump": grip,
        "pad": [box((0.05, 0.11, 0.3), (0.82, 0, -0.115), 0.02)],
        "shells": shells,
    }


ARMS: dict[str, Callable[[Draw], Parts]] = {
    "crossbow": _crossbow,
    "bow": _bow,
    "rifle": _rifle,
    "shotgun": _shotgun,
}
