"""Fruit."""

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
    prism,
    smooth_curve,
    taper,
    tilted,
    tube,
    turned,
)
from core.prior.things.shared.ropes import arc, bent


def apple(draw: Draw) -> Parts:
    """A fruit with a dimple, a stalk and a leaf."""
    wide, high = draw(0.82, 0.92), draw(1.4, 1.6)
    shape = [(0.1, 0.14), (0.42, 0.0), (wide * 0.85, high * 0.3), (wide, high * 0.62)]
    shape += [(wide * 0.7, high * 0.97), (0.34, high), (0.06, high * 0.84)]
    leaf = turned(egg((0.3, 0, 0), (0.36, 0.2, 0.1)), 1, -25)
    return {
        "body": lathe(smooth_curve(shape, 4)),
        "stalk": taper((0, 0, high * 0.8), (0.08, 0, high + 0.36), 0.08, 0.1),
        "leaf": moved(leaf, (0.05, 0, high + 0.14)),
    }


def _leaf(length: float, angle: float, at: tuple[float, float, float]) -> Solid:
    shape = egg((length, 0, 0), (length * 1.1, length * 0.55, 0.1))
    return moved(turned(shape, 1, -angle), at)


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


def orange(draw: Draw) -> Parts:
    """A whole one, and a half before it that shows its segments."""
    r, half, lean = draw(0.74, 0.8), draw(0.62, 0.68), draw(38, 46)
    y, share, gap = draw(0.46, 0.52), draw(0.83, 0.86), 8
    pith, leaf = half * 0.93, draw(0.4, 0.48)
    # Segments: sectors of the disc, apart from one another.
    inner, wide = half * 0.14, math.pi / 8
    edge = half * share
    arc = [wide * (0.74 * k / 3) for k in range(-3, 4)]
    wedge = [(inner, 0.0), *((edge * math.cos(a), edge * math.sin(a)) for a in arc)]
    # Made with its cut face up, then turned to the front.
    bowl = cut(ball((0, 0, 0), half), box((0, 0, 1), (1, 1, 1)))

    def laid(solid: Solid) -> Solid:
        return tilted(solid, lean + gap, (0, -0.58, half * 0.86))

    blade = [(0.0, 0.0), (leaf * 0.4, 0.15), (leaf, 0.0), (leaf * 0.4, -0.15)]
    return {
        "body": join(ball((0, y, r), r), laid(bowl)),
        "pith": laid(tube((0, 0, -0.1), (0, 0, 0.025), pith)),
        "flesh": laid(around(8, prism(wedge, 2, 0.08), 22.5)),
        "stalk": tube((0, y, 2 * r - 0.1), (0, y, 2 * r + 0.1), 0.1, 0.02),
        "leaf": moved(turned(prism(smooth_curve(blade), 2, 0.075), 1, -14), (0, y, 2 * r + 0.04)),
    }


def lemon(draw: Draw) -> Parts:
    """Lying on its side, a nub at each end."""
    wide, long = draw(0.62, 0.72), draw(0.98, 1.12)
    shape = [(0.04, -long), (0.16, -long * 0.93), (0.24, -long * 0.8), (wide * 0.85, -long * 0.45)]
    shape += [(wide, 0), (wide * 0.85, long * 0.45), (0.22, long * 0.82), (0.12, long * 0.95)]
    body = lathe(smooth_curve([*shape, (0.03, long)]), 0.01)
    body = turned(body, 1, 90)
    return {"body": body, "leaf": _leaf(0.32, draw(35, 60), (long * 0.86, 0, 0.1))}


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


def kiwi(draw: Draw) -> Parts:
    """Half a kiwi, its green face with a pale middle and a ring of seeds to the front, against a
    whole brown one."""
    r, long = draw(0.94, 1.0), draw(1.2, 1.28)
    lean, deep = draw(14, 17), 0.66
    face = box((0, -2, 0), (3, 2, 3))
    half = cut(egg((0, 0, 0), (r, r * 0.92, r)), face)
    inner = tube((0, -0.05, 0), (0, 0.2, 0), r - 0.11, 0.02)
    seed = egg((0.5 * r, 0, 0), (0.15, 0.075, 0.09))
    ring_of = turned(around(10, seed, 18), 0, 90)

    def leant(solid: Solid) -> Solid:
        return tilted(solid, -lean, (0, -deep, r * 0.98))

    whole = egg((0, 0.42, 0.82), (long, 0.82, 0.82))
    return {
        "skin": join(whole, leant(half)),
        "flesh": leant(inner),
        "middle": leant(moved(egg((0, 0, 0), (0.26 * r, 0.1, 0.3 * r)), (0, -0.05, 0))),
        "seeds": leant(moved(ring_of, (0, -0.06, 0))),
        "tips": join(
            tube((long - 0.06, 0.42, 0.82), (long + 0.1, 0.42, 0.82), 0.15, 0.03),
            tube((-long + 0.06, 0.42, 0.82), (-long - 0.06, 0.42, 0.82), 0.1, 0.03),
        ),
    }


def pineapple(draw: Draw) -> Parts:
    """A scaly body and a tuft of leaves."""
    wide, high = draw(0.56, 0.66), draw(0.78, 0.92)
    top = 2 * high - 0.12
    inner = taper((0.08, 0, top), (0.14, 0, top + draw(0.75, 0.9)), 0.15, 0.04)
    outer = taper((0.12, 0, top), (0.5, 0, top + draw(0.5, 0.6)), 0.14, 0.05)
    last = taper((0.12, 0, top - 0.02), (0.62, 0, top + 0.2), 0.13, 0.05)
    shape = [
        (0.3, 0.0),
        (wide * 0.9, high * 0.4),
        (wide, high),
        (wide * 0.85, high * 1.55),
        (0.3, high * 2),
    ]
    return {
        "body": lathe(smooth_curve(shape, 4), 0.03),
        "leaves": join(around(4, inner), around(6, outer, 30), around(6, last, 0)),
    }


def coconut(draw: Draw) -> Parts:
    """A whole one with its three eyes, and a half before it with white flesh and water."""
    r, half, lean = draw(0.76, 0.84), draw(0.66, 0.72), draw(26, 36)
    y, white, hollow = draw(0.5, 0.56), draw(0.86, 0.89), draw(0.6, 0.66)
    z = r
    c = half * hollow
    upper, hole = box((0, 0, 1.03), (1, 1, 1)), ball((0, 0, 0.05), c)
    shell = cut(ball((0, 0, 0), half), box((0, 0, 1), (1, 1, 1)), hole)

    def laid(solid: Solid) -> Solid:
        return tilted(solid, lean, (0, -0.56, half * 0.95))

    eye = ball((0, 0, r - 0.03), 0.12)
    eyes = [turned(turned(eye, 0, 15), 2, 120 * k) for k in range(3)]
    meat = cut(ball((0, 0, 0), half * white), upper, hole)
    return {
        "shell": join(ball((0, y, z), r), laid(shell)),
        "flesh": laid(meat),
        "water": laid(cut(ball((0, 0, 0.05), c + 0.02), box((0, 0, 0.92), (1, 1, 1)))),
        "eyes": tilted(join(*eyes), 30, (0, y, z)),
    }


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


FRUIT = {
    "apple": apple,
    "pear": pear,
    "banana": banana,
    "orange fruit": orange,
    "lemon": lemon,
    "peach": peach,
    "cherry": cherry,
    "strawberry": strawberry,
    "grapes": grapes,
    "kiwi": kiwi,
    "pineapple": pineapple,
    "coconut": coconut,
    "watermelon": watermelon,
    "avocado": avocado,
}
