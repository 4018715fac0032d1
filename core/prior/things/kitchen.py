"""A kitchen's vessels, pans and appliances."""

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    ball,
    both,
    box,
    capsule,
    cut,
    egg,
    grown,
    join,
    lathe,
    ring,
    smooth_curve,
    taper,
    tube,
    within,
)


def mug(draw: Draw) -> Parts:
    radius, height, wall = draw(0.52, 0.6), draw(1.1, 1.35), draw(0.08, 0.11)
    taper = draw(-0.06, 0.06)
    outer = lathe([(radius - taper - 0.03, 0.03), (radius + taper - 0.03, height - 0.03)], 0.03)
    inner = lathe([(radius - taper - wall, 0.16), (radius + taper - wall, height + 0.5)])
    major, minor = draw(0.32, 0.4), draw(0.09, 0.115)
    handle = ring((radius, 0, height * draw(0.48, 0.54)), major, minor, axis=1)
    parts = {"body": cut(outer, inner)}
    return parts | {"handle": cut(handle, inner)} if draw.has("handle", 1.0) else parts


def teacup(draw: Draw) -> Parts:
    """A wide cup of tea with an ear, on a saucer, both with a rim of gold."""
    wide, high, foot = draw(0.68, 0.76), draw(0.78, 0.9), draw(0.3, 0.36)
    plate, wall, low = draw(1.0, 1.1), 0.08, 0.22
    top = low + high
    curve = smooth_curve([(foot, low + 0.04), (wide * 0.8, low + 0.28), (wide, top)])
    hollow = [(max(r - wall, 0.02), z + (0.1 if z < low + 0.12 else 0.0)) for r, z in curve]
    inside = lathe([*hollow, (wide - wall + 0.02, top + 0.2)])
    dish = [(0.42, 0.0), (0.46, 0.04), (plate * 0.7, 0.1), (plate, 0.22)]
    upper = [(plate, 0.32), (plate * 0.7, 0.2), (0.36, 0.16)]
    ear = join(
        ring((wide * 0.96, 0, low + high * 0.6), draw(0.27, 0.31), 0.085, axis=1),
        box((wide * 0.86, 0, low + high * 0.6), (0.05, 0.07, 0.3), 0.02),
    )
    level = top - 0.14
    parts = {
        "cup": cut(lathe([(foot, 0.14), *curve], 0.01), inside),
        "saucer": lathe([(0.0, 0.0), *dish, *upper, (0.0, 0.16)], 0.02),
        "tea": within(tube((0, 0, level - 0.14), (0, 0, level), wide), grown(inside, 0.02)),
        "rim": ring((0, 0, top), wide - wall / 2, 0.07),
    }
    return parts | ({"handle": cut(ear, inside)} if draw.has("handle", 1.0) else {})


def wine_glass(draw: Draw) -> Parts:
    """A wide bowl half full of red wine, open above, on a slender stem and a flat foot."""
    r, low, high = draw(0.76, 0.82), draw(1.26, 1.34), draw(1.36, 1.46)
    foot, wall = draw(0.66, 0.71), 0.13
    side = [(0.1, 0.0), (r * 0.7, high * 0.16), (r, high * 0.5), (r * 0.96, high * 0.76),
            (r * 0.86, high)]  # fmt: skip
    outer = [(u, low + v) for u, v in smooth_curve(side)]
    fill, top = low + high * 0.58, low + high
    inner = [(u - wall, v) for u, v in outer if v > fill - 0.1]
    hollow = lathe([*inner, (inner[-1][0], top + 1)])
    return {
        "bowl": within(cut(lathe(outer), hollow), box((0, 0, fill + 2), (2, 2, 2))),
        "liquid": within(lathe(outer), box((0, 0, fill - 2), (2, 2, 2))),
        "stem": lathe([(0.24, 0.06), (0.11, 0.3), (0.1, low - 0.16), (0.26, low + 0.08)], 0.01),
        "foot": lathe([(foot, 0), (foot, 0.1), (0.2, 0.2)], 0.01),
    }


def goblet(draw: Draw) -> Parts:
    """A cup on a stem."""
    wide, stem, foot = draw(0.5, 0.6), draw(0.1, 0.13), draw(0.42, 0.52)
    low, high = draw(0.75, 0.95), draw(0.8, 1.0)
    shape = [
        (stem, low),
        (wide * 0.8, low + high * 0.25),
        (wide, low + high * 0.6),
        (wide * 0.92, low + high),
    ]
    hole = [(0.02, low + 0.22), (wide * 0.7, low + high * 0.4), (wide - 0.1, low + high * 0.65)]
    hole += [(wide * 0.92 - 0.1, low + high), (wide * 0.92 - 0.1, low + high + 0.4)]
    base = [(foot, 0.0), (foot, 0.06), (stem, 0.22), (stem, low + 0.1)]
    return {
        "cup": cut(lathe(smooth_curve(shape, 4), 0.01), lathe(hole)),
        "stem": lathe(base, 0.02),
    }


def bottle(draw: Draw) -> Parts:
    body, neck = draw(0.42, 0.5), draw(0.16, 0.2)
    shoulder, top = draw(1.2, 1.4), draw(2.1, 2.3)
    outline = [
        *((body - 0.08, 0), (body, 0.08), (body, shoulder), (0.5 * (body + neck), shoulder + 0.28)),
        *((neck, shoulder + 0.5), (neck, top)),
    ]
    cap = neck + draw(0.03, 0.06)
    parts = {"body": lathe(outline, 0.02)}
    lid = {"cap": tube((0, 0, top - 0.05), (0, 0, top + 0.22), cap, 0.03)}
    return parts | lid if draw.has("cap", 0.9) else parts


def bowl(draw: Draw) -> Parts:
    """Half a hollow ball on a foot."""
    wide, deep, wall = draw(0.95, 1.1), draw(0.6, 0.8), draw(0.1, 0.13)
    shell = [(0.38, 0.1), (wide * 0.72, 0.24), (wide * 0.93, deep * 0.62), (wide, deep)]
    hole = [(0.2, 0.1 + wall), (wide * 0.72 - wall, 0.26 + wall), (wide * 0.93 - wall, deep * 0.66)]
    hole += [(wide - wall, deep), (wide - wall, deep + 0.3)]
    outer, inner = lathe(smooth_curve(shell, 4), 0.02), lathe(smooth_curve(hole, 4))
    return {"body": cut(outer, inner), "foot": tube((0, 0, 0), (0, 0, 0.16), draw(0.4, 0.5), 0.03)}


def teapot(draw: Draw) -> Parts:
    """A round pot with a spout to the left, a handle to the right, a lid."""
    wide, high = draw(0.72, 0.82), draw(0.58, 0.72)
    body = join(
        egg((0, 0, high), (wide, wide, high)), tube((0, 0, 0), (0, 0, 0.14), wide * 0.6, 0.03)
    )
    loop = ring((wide * 0.98, 0, high * 1.05), draw(0.36, 0.42), draw(0.1, 0.12), axis=1)
    tip = (-wide - draw(0.5, 0.6), 0, high * draw(1.75, 1.95))
    lid = join(
        egg((0, 0, high * 1.86), (wide * 0.55, wide * 0.55, 0.2)),
        ball((0, 0, high * 1.86 + 0.28), 0.14),
    )
    return {
        "body": body,
        "spout": taper((-wide * 0.7, 0, high * 0.75), tip, 0.24, 0.12),
        "handle": cut(loop, egg((0, 0, high), (wide * 0.9, wide * 0.9, high * 0.9))),
        "lid": lid,
    }


def kettle(draw: Draw) -> Parts:
    """A kettle with its handle above and a short spout to the left."""
    wide, high = draw(0.72, 0.85), draw(0.8, 1.0)
    side = [(wide * 0.9, 0.0), (wide, high * 0.25), (wide * 0.8, high * 0.7), (0.36, high)]
    bow = cut(
        ring((0, 0, high * 0.85), wide * 0.72, 0.1, axis=1), box((0, 0, high * 0.7 - 1), (3, 3, 1))
    )
    return {
        "body": lathe(smooth_curve(side), 0.02),
        "spout": taper((-wide * 0.7, 0, high * 0.4), (-wide - 0.35, 0, high * 0.95), 0.22, 0.12),
        "handle": bow,
        "lid": join(egg((0, 0, high), (0.36, 0.36, 0.12)), ball((0, 0, high + 0.16), 0.13)),
    }


def pan(draw: Draw) -> Parts:
    """A frying pan, its handle to the right."""
    wide, high, reach = draw(0.72, 0.82), draw(0.26, 0.36), draw(0.85, 1.05)
    x = -0.6
    dish = lathe([(wide - 0.12, 0.0), (wide, high)], 0.03, (x, 0))
    hole = lathe([(wide - 0.22, 0.12), (wide - 0.1, high + 0.03), (wide - 0.1, 1.0)], 0, (x, 0))
    start, end = x + wide - 0.02, x + wide + reach
    grip = taper((start, 0, high * 0.7), (end, 0, high * draw(0.9, 1.4)), 0.1, 0.13)
    return {"body": cut(dish, hole), "handle": grip}


def cooking_pot(draw: Draw) -> Parts:
    """A wide pot with an ear at either side, and its lid with a knob."""
    r, high, ear = draw(0.74, 0.82), draw(0.82, 0.98), draw(0.2, 0.24)
    dome, z = draw(0.2, 0.27), high * 0.72
    lid = smooth_curve([(r - 0.02, high + 0.06), (r * 0.62, high + dome * 0.8), (0.0, high + dome)])
    knob = high + dome
    out = r + ear
    loop = join(
        capsule((r - 0.05, -ear, z), (out, -ear, z), 0.08),
        capsule((out, -ear, z), (out, ear, z), 0.08),
        capsule((r - 0.05, ear, z), (out, ear, z), 0.08),
    )
    return {
        "body": tube((0, 0, 0), (0, 0, high), r, 0.06),
        "rim": tube((0, 0, high - 0.05), (0, 0, high + 0.09), r + 0.06, 0.03),
        "handles": both(loop),
        "lid": lathe(lid, 0.02),
        "knob": join(
            tube((0, 0, knob - 0.1), (0, 0, knob + 0.14), 0.1),
            egg((0, 0, knob + 0.2), (0.19, 0.19, 0.11)),
        ),
    }


def stove(draw: Draw) -> Parts:
    """An oven below four plates, knobs to the front."""
    x, y, high = draw(0.65, 0.78), draw(0.55, 0.65), draw(1.15, 1.35)
    return {
        "body": join(
            box((0, 0, high / 2), (x, y, high / 2), 0.03),
            box((0, y - 0.08, high + draw(0.05, 0.2)), (x, 0.1, 0.16), 0.02),
        ),
        "window": box((0, -y, high * 0.42), (x * 0.68, 0.06, high * 0.2), 0.03),
        "plates": both(
            tube(
                (x * 0.45, y * 0.42, high - 0.1),
                (x * 0.45, y * 0.42, high + 0.08),
                draw(0.18, 0.22),
            ),
            0,
            1,
        ),
        "knobs": join(
            *(
                tube((x * k, -y - 0.1, high - 0.15), (x * k, -y + 0.1, high - 0.15), 0.085)
                for k in (-0.72, -0.24, 0.24, 0.72)
            )
        ),
        "handle": capsule(
            (-x * 0.66, -y - 0.04, high * 0.7), (x * 0.66, -y - 0.04, high * 0.7), 0.08
        ),
    }


def refrigerator(draw: Draw) -> Parts:
    """Two doors, one above the other or side by side."""
    x, y, high, soft = draw(0.55, 0.72), draw(0.5, 0.58), draw(1.9, 2.3), 0.05
    if draw.chance(0.6):
        split = high * 0.64
        doors = join(
            box((0, -y, split / 2 + 0.03), (x, 0.11, split / 2 - 0.12), 0.03),
            box((0, -y, (split + high) / 2 + 0.03), (x, 0.11, (high - split) / 2 - 0.06), 0.03),
        )
        bars = [
            box((-x + 0.17, -y - 0.18, split + v), (0.075, 0.1, half), 0.02)
            for v, half in ((-0.4, 0.24), (0.28, 0.15))
        ]
        handles = join(*bars)
    else:
        doors = both(box((x / 2, -y, high / 2 + 0.03), (x / 2 - 0.06, 0.11, high / 2 - 0.05), 0.03))
        handles = both(box((0.2, -y - 0.18, high * 0.55), (0.075, 0.1, high * 0.16), 0.02))
    return {
        "body": box((0, 0.05, high / 2 + 0.04), (x, y, high / 2 - 0.04), soft),
        "doors": doors,
        "handles": handles,
        "feet": both(box((x - 0.15, y - 0.2, 0.06), (0.12, 0.12, 0.08)), 0, 1),
    }


def microwave(draw: Draw) -> Parts:
    """A box with a dark window, a handle and buttons."""
    x, y, z = draw(1.05, 1.25), draw(0.55, 0.7), draw(0.58, 0.7)
    spots = [(x * 0.8, z * k) for k in (-0.45, -0.1)]
    return {
        "body": box((0, 0, z), (x, y, z), 0.05),
        "window": box((-x * 0.24, -y, z), (x * 0.6, 0.07, z * 0.7), 0.03),
        "handle": capsule((x * 0.48, -y - 0.05, z * 0.5), (x * 0.48, -y - 0.05, z * 1.5), 0.09),
        "buttons": join(*(box((u, -y, z + v), (0.13, 0.08, 0.085), 0.02) for u, v in spots)),
        "display": box((x * 0.8, -y, z * 1.5), (0.16, 0.07, 0.12)),
    }


def toaster(draw: Draw) -> Parts:
    """Two slices of bread stick out of its top."""
    x, y, high = draw(0.8, 1.0), draw(0.48, 0.56), draw(0.85, 1.05)
    out = draw(0.15, 0.35)
    slices = [box((0, s, high - 0.1 + out), (x * 0.58, 0.11, 0.4), 0.1) for s in (-0.2, 0.2)]
    return {
        "body": box((0, 0, high / 2 + 0.06), (x, y, high / 2), draw(0.12, 0.22)),
        "bread": join(*slices),
        "base": box((0, 0, 0.08), (x + 0.03, y + 0.03, 0.1), 0.04),
        "lever": box((x + 0.06, 0, high * 0.66), (0.13, 0.16, 0.08), 0.04),
        "knob": tube(
            (x * 0.5, -y - 0.1, high * 0.35), (x * 0.5, -y + 0.1, high * 0.35), 0.13, 0.02
        ),
    }


def blender(draw: Draw) -> Parts:
    """A jug on a motor, its knob to the front, its handle to the right."""
    low, neck, wide, high = draw(0.5, 0.58), draw(0.32, 0.38), draw(0.46, 0.54), draw(1.9, 2.1)
    z = draw(0.62, 0.72)
    x = wide + 0.3
    grip = join(
        capsule((wide - 0.1, 0, high - 0.2), (x, 0, high - 0.24), 0.1),
        capsule((x, 0, high - 0.24), (x - 0.06, 0, z + 0.4), 0.1),
        capsule((x - 0.06, 0, z + 0.4), (neck, 0, z + 0.36), 0.1),
    )
    motor = smooth_curve([(low, 0.12), (low * 0.92, z * 0.5), (neck + 0.06, z)])
    return {
        "base": lathe([(low, 0.03), *motor], 0.03),
        "jug": lathe([(neck, z + 0.08), (wide, high)], 0.02),
        "handle": grip,
        "lid": join(
            tube((0, 0, high - 0.04), (0, 0, high + 0.13), wide + 0.05, 0.04),
            tube((0, 0, high + 0.1), (0, 0, high + 0.28), 0.2, 0.04),
        ),
        "collar": tube((0, 0, z - 0.04), (0, 0, z + 0.14), neck + 0.1, 0.03),
        "knob": tube((0, -low - 0.08, z * 0.44), (0, 0, z * 0.44), draw(0.15, 0.19), 0.03),
    }


KITCHEN = {
    "mug": mug,
    "teacup": teacup,
    "wine glass": wine_glass,
    "goblet": goblet,
    "bottle": bottle,
    "bowl": bowl,
    "teapot": teapot,
    "kettle": kettle,
    "pan": pan,
    "cooking pot": cooking_pot,
    "stove": stove,
    "refrigerator": refrigerator,
    "microwave": microwave,
    "toaster": toaster,
    "blender": blender,
}
