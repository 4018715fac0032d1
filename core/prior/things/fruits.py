"""Fruit and vegetables."""

import math

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
    around,
    ball,
    blend,
    both,
    box,
    cut,
    egg,
    join,
    lathe,
    moved,
    smooth_curve,
    taper,
    tube,
    turned,
)


def bent(points: list[tuple[float, float, float]], radii: list[float]) -> Solid:
    """A rope through the points, as thick as ``radii`` says at each."""
    pairs = zip(points, points[1:], radii, radii[1:], strict=False)
    return join(*(taper(a, b, r, s) for a, b, r, s in pairs))


def arc(radius: float, first: float, last: float, steps: int) -> list[tuple[float, float, float]]:
    """Points on a circle about the origin in the upright plane of the picture, in degrees."""
    angles = [math.radians(first + (last - first) * k / steps) for k in range(steps + 1)]
    return [(radius * math.cos(a), 0.0, radius * math.sin(a)) for a in angles]


def _leaf(length: float, angle: float, at: tuple[float, float, float]) -> Solid:
    shape = egg((length, 0, 0), (length * 1.1, length * 0.55, 0.1))
    return moved(turned(shape, 1, -angle), at)


def banana(draw: Draw) -> Parts:
    """A bent fruit, its ends dark."""
    half, thick, bend = draw(58, 75), draw(0.23, 0.29), draw(1.0, 1.15)
    points = arc(bend, 270 - half, 270 + half, 8)
    radii = [thick * (1 - 0.6 * abs(k / 4 - 1) ** 3) for k in range(9)]
    ends = arc(bend, 270 - half - 15, 270 + half + 6, 1)
    return {
        "peel": bent(points, radii),
        "ends": join(
            taper(points[0], ends[0], thick * 0.42, 0.12),
            taper(points[-1], ends[1], thick * 0.41, 0.09),
        ),
    }


def pear(draw: Draw) -> Parts:
    """Wide below, narrow above, a stalk and a leaf."""
    wide, high, neck = draw(0.66, 0.76), draw(1.6, 1.85), draw(0.32, 0.4)
    shape = [(0.08, 0.06), (wide * 0.6, 0.04), (wide, high * 0.3), (wide * 0.8, high * 0.55)]
    shape += [(neck, high * 0.8), (neck * 0.7, high * 0.96), (0.06, high)]
    return {
        "body": lathe(smooth_curve(shape)),
        "stalk": taper((0, 0, high - 0.1), (0.1, 0, high + 0.36), 0.08, 0.1),
        "leaf": _leaf(0.3, draw(15, 35), (0.04, 0, high + 0.12)),
    }


def strawberry(draw: Draw) -> Parts:
    """Its tip down, seeds on its skin, a star of leaves on top."""
    wide, high = draw(0.66, 0.78), draw(1.45, 1.7)
    shape = [(0.06, 0), (0.3, high * 0.12), (wide * 0.8, high * 0.45), (wide, high * 0.75)]
    shape += [(wide * 0.75, high * 0.96), (0.1, high * 0.98)]
    leaf = taper((0.1, 0, high), (wide * 0.95, 0, high - draw(0.02, 0.16)), 0.16, 0.07)
    rows = ((0.62, 0.3, 0), (0.93, 0.52, 30), (1.0, 0.76, 0))
    seeds = (
        around(6, egg((wide * r - 0.02, 0, high * z), (0.07, 0.06, 0.09)), turn)
        for r, z, turn in rows
    )
    return {
        "body": lathe(smooth_curve(shape)),
        "leaves": join(
            around(6, leaf), taper((0, 0, high - 0.05), (0.06, 0, high + 0.3), 0.1, 0.08)
        ),
        "seeds": join(*seeds),
    }


def cherry(draw: Draw) -> Parts:
    """Two cherries, their stalks joined under a leaf."""
    size, apart, high = draw(0.46, 0.54), draw(0.52, 0.6), draw(1.75, 2.0)
    low, top = draw(0, 0.15), (0.0, 0.0, high)
    fruits = join(ball((-apart, 0, size), size), ball((apart, 0, size + low), size))
    left = bent([(-apart, 0, size * 1.8), (-apart * 0.6, 0, high * 0.78), top], [0.08, 0.08, 0.1])
    right = bent(
        [(apart, 0, size * 1.8 + low), (apart * 0.6, 0, high * 0.8), top], [0.08, 0.08, 0.1]
    )
    return {
        "fruits": fruits,
        "stalks": join(left, right),
        "leaf": _leaf(0.38, draw(0, 20), (0, 0, high)),
    }


def lemon(draw: Draw) -> Parts:
    """Lying on its side, a nub at each end."""
    wide, long = draw(0.62, 0.72), draw(0.98, 1.12)
    shape = [(0.04, -long), (0.16, -long * 0.93), (0.24, -long * 0.8), (wide * 0.85, -long * 0.45)]
    shape += [(wide, 0), (wide * 0.85, long * 0.45), (0.22, long * 0.82), (0.12, long * 0.95)]
    body = lathe(smooth_curve([*shape, (0.03, long)]), 0.01)
    body = turned(body, 1, 90)
    return {"body": body, "leaf": _leaf(0.32, draw(35, 60), (long * 0.86, 0, 0.1))}


def watermelon(draw: Draw) -> Parts:
    """A whole one that lies, and before it a half slice that stands on its rind."""
    long, r, slim = draw(1.15, 1.35), draw(0.86, 0.94), draw(0.17, 0.21)
    size, y = draw(0.84, 0.9), -r - slim + 0.08
    top, inner = box((0, 0, size + 2), (4, 4, 2)), size - 0.17
    seeds = [(0.0, 0.74), (0.44, 0.74), (0.22, 0.4)]
    return {
        "rind": join(
            egg((0, 0, r), (long, r, r)),
            cut(tube((0, y - slim, size), (0, y + slim, size), size), top),
        ),
        "flesh": cut(
            tube((0, y - slim - 0.07, size), (0, y + slim + 0.07, size), inner),
            moved(top, (0, 0, 0.07)),
        ),
        "seeds": both(
            join(
                *(egg((size * u, y - slim - 0.06, size * v), (0.075, 0.1, 0.11)) for u, v in seeds)
            )
        ),
    }


def grapes(draw: Draw) -> Parts:
    """A bunch, tip down, a stalk and a leaf above."""
    size, high, wide = draw(0.21, 0.25), draw(1.5, 1.75), draw(0.55, 0.65)
    balls, layers = [ball((0, 0, size), size)], 6
    for k, count in enumerate((3, 5, 7, 8, 7), 1):
        z = size + (high - size) * k / layers
        radius = wide * (k / (layers - 1.0)) ** 0.6 if k < layers - 1 else wide * 0.85
        balls.append(around(count, ball((radius, 0, z), size), 25 * k))
    core = taper((0, 0, size), (0, 0, high - 0.2), 0.12, wide * 0.85)
    return {
        "grapes": join(*balls, core),
        "stalk": taper((0, 0, high - 0.1), (0.1, 0, high + 0.5), 0.1, 0.11),
        "leaf": join(
            _leaf(0.36, 10, (0.1, -0.05, high + 0.22)),
            turned(_leaf(0.3, 10, (-0.05, 0, high + 0.22)), 2, draw(120, 180)),
        ),
    }


def avocado(draw: Draw) -> Parts:
    """A half, upright, its cut face with the stone to the front."""
    wide, high, neck = draw(0.72, 0.82), draw(1.75, 1.95), draw(0.36, 0.44)

    def pear_shape(less: float) -> Solid:
        shape = [(0.08, less), (wide * 0.6 - less, 0.05 + less), (wide - less, high * 0.33)]
        shape += [(wide * 0.8 - less, high * 0.6), (neck - less * 0.8, high * 0.85)]
        return lathe(smooth_curve([*shape, (0.05, high - less)]), 0.02)

    front = box((0, -1.94, 1), (2, 2, 2))
    return {
        "skin": cut(pear_shape(0), front),
        "flesh": cut(pear_shape(0.1), box((0, -2.02, 1), (2, 2, 2))),
        "stone": ball((0, 0.02, high * 0.34), wide * draw(0.42, 0.5)),
    }


def corn(draw: Draw) -> Parts:
    """A cob with rows of kernels in its husk, tip up."""
    wide, high = draw(0.36, 0.43), draw(2.1, 2.4)
    kernels = []
    for k in range(11):
        z = 0.5 + (high - 0.62) * k / 10
        radius = wide * min(1.0, 1.35 * (1 - (k / 11.5) ** 3))
        kernels.append(around(10, egg((radius, 0, z), (0.12, radius * 0.33, 0.12)), 18 * (k % 2)))
    cob = taper((0, 0, 0.4), (0, 0, high - 0.2), wide * 0.98, wide * 0.5)
    out, tip = draw(0.4, 0.75), draw(1.2, 1.55)
    husk = join(
        taper((0.1, 0, 0.1), (wide + 0.08, 0, 0.65), 0.2, 0.22),
        taper((wide + 0.08, 0, 0.65), (wide + out * 0.6, 0, tip), 0.22, 0.08),
    )
    return {
        "kernels": join(cob, *kernels),
        "husk": join(around(4, husk, 45), tube((0, 0, -0.15), (0, 0, 0.3), 0.2, 0.04)),
    }


def broccoli(draw: Draw) -> Parts:
    """A crown of florets on branches."""
    trunk, reach, top = draw(0.25, 0.32), draw(0.5, 0.6), draw(1.3, 1.5)
    count, size = 5 + draw.chance(0.5), draw(0.34, 0.4)
    branch = taper((0.05, 0, 0.45), (reach, 0, top - 0.25), trunk * 0.6, 0.16)
    tufts = [
        around(count, ball((reach, 0, top), size)),
        around(2 * count, ball((reach + 0.22, 0, top - 0.05), size * 0.55), 20),
        around(count, ball((reach * 0.75, 0, top + 0.3), size * 0.65), 180 / count),
        around(count, ball((reach * 0.3, 0, top + 0.42), size * 0.6)),
        ball((0, 0, top + 0.22), size * 1.15),
    ]
    return {
        "florets": join(*tufts),
        "stem": join(
            taper((0, 0, 0), (0, 0, top - 0.1), trunk, trunk * 0.9), around(count, branch)
        ),
    }


def eggplant(draw: Draw) -> Parts:
    """A drop, its cap and stalk above."""
    wide, high, lean = draw(0.5, 0.6), draw(1.7, 2.0), draw(-0.25, 0.25)
    neck = (lean, 0.0, high)
    body = blend(
        0.15,
        egg((0, 0, wide * 1.1), (wide, wide, wide * 1.15)),
        taper((0, 0, wide * 1.15), neck, wide * 0.92, wide * 0.5),
    )
    flap = taper((0.05, 0, wide * 0.42), (wide * 0.62, 0, -0.14), 0.14, 0.07)
    cap = join(egg((0, 0, wide * 0.28), (wide * 0.5, wide * 0.5, wide * 0.33)), around(5, flap))
    tip = (lean * 1.5 + 0.08, 0, high + wide * 0.5 + 0.4)
    return {
        "body": body,
        "cap": join(moved(cap, neck), taper((lean, 0, high + 0.2), tip, 0.13, 0.12)),
    }


def pepper(draw: Draw) -> Parts:
    """A bell pepper: three or four lobes about a stalk."""
    wide, high, count = draw(0.36, 0.42), draw(1.25, 1.6), 3 + draw.chance(0.6)
    lobe = taper((wide * 0.6, 0, wide * 0.75), (wide, 0, high - wide), wide * 0.72, wide * 1.05)
    top = high - 0.02
    return {
        "body": join(around(count, lobe, 45), taper((0, 0, 0.3), (0, 0, high - 0.35), 0.25, 0.4)),
        "stalk": join(
            taper((0, 0, top - 0.25), (draw(-0.15, 0.15), 0, top + 0.38), 0.13, 0.12),
            egg((0, 0, top - 0.08), (0.28, 0.28, 0.1)),
        ),
    }


def onion(draw: Draw) -> Parts:
    """A bulb that runs out in a tip, roots below."""
    wide, high = draw(0.78, 0.9), draw(1.35, 1.55)
    shape = [(0.1, 0.06), (wide * 0.6, 0.1), (wide, high * 0.45), (wide * 0.7, high * 0.8)]
    shape += [(0.24, high), (0.13, high + 0.2), (0.16, high + draw(0.35, 0.5))]
    root = taper((0.05, 0, 0.1), (0.22, 0, -0.12), 0.1, 0.06)
    rib = egg((wide * 0.3, 0, high * 0.45), (wide * 0.73, 0.34, high * 0.43))
    return {
        "body": join(lathe(smooth_curve(shape)), around(8, rib)),
        "roots": around(6, root),
    }


def peach(draw: Draw) -> Parts:
    """A ball with a crease, a stalk and a leaf."""
    wide, high = draw(0.78, 0.86), draw(0.74, 0.82)
    halves = both(egg((0.24, 0, high), (wide - 0.18, wide, high)))
    return {
        "body": blend(0.06, halves, egg((0, 0, high), (0.4, wide * 0.9, high * 0.88))),
        "stalk": taper((0, 0, high * 1.7), (0.05, 0, high * 2 + 0.18), 0.1, 0.09),
        "leaf": join(
            _leaf(0.38, draw(5, 25), (0, 0, high * 2 + 0.06)),
            turned(_leaf(0.3, 10, (0, 0, high * 2 + 0.04)), 2, 160),
        ),
    }


FRUITS = {
    "banana": banana,
    "pear": pear,
    "strawberry": strawberry,
    "cherry": cherry,
    "lemon": lemon,
    "watermelon": watermelon,
    "grapes": grapes,
    "avocado": avocado,
    "corn": corn,
    "broccoli": broccoli,
    "eggplant": eggplant,
    "pepper": pepper,
    "onion": onion,
    "peach": peach,
}
