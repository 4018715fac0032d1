"""Fixtures and appliances of a house, cages and a shopping cart."""

import math

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
    moved,
    prism,
    ring,
    smooth_curve,
    taper,
    tilted,
    tube,
    turned,
)


def faucet(draw: Draw) -> Parts:
    """Two cross taps on one base, a spout between them that bends over to the front."""
    x, r, back = draw(0.8, 0.84), draw(0.17, 0.18), 0.2
    bend, high, z = draw(0.44, 0.47), draw(1.32, 1.4), draw(0.76, 0.8)
    front, drop = back - 2 * bend, high - 0.2
    arch = cut(ring((0, back - bend, high), bend, r, 0), box((0, 0, high - 2), (4, 4, 2)))
    spout = join(
        tube((0, back, 0.2), (0, back, high), r), arch, tube((0, front, drop), (0, front, high), r)
    )
    cross = join(
        capsule((-0.3, 0, z), (0.3, 0, z), 0.115), capsule((0, -0.3, z), (0, 0.3, z), 0.115)
    )
    return {
        "body": join(
            both(lathe([(0.32, 0.1), (0.32, 0.3), (0.2, 0.5), (0.2, z)], 0.0, (x, back))),
            tube((0, back, 0.1), (0, back, 0.5), r + 0.12, 0.04),
            box((0, back, 0.13), (x + 0.4, 0.44, 0.13), 0.08),
        ),
        "spout": spout,
        "handles": both(moved(cross, (x, back, 0))),
        "nozzle": tube((0, front, drop - 0.22), (0, front, drop + 0.1), r + 0.08, 0.03),
        "hot mark": tube((-x, back, z), (-x, back, z + 0.22), 0.17, 0.03),
        "cold mark": tube((x, back, z), (x, back, z + 0.22), 0.17, 0.03),
    }


def radiator(draw: Draw) -> Parts:
    """Columns side by side between two pipes, on four feet, a valve at its right end."""
    count, pitch, high = 5 + draw.which(3), 0.35, draw(1.4, 1.6)
    y, low, thick = draw(0.16, 0.2), 0.38, draw(0.14, 0.15)
    end = pitch * (count - 1) / 2
    places = [pitch * k - end for k in range(count)]

    def section(x: float) -> Solid:
        posts = both(capsule((x, y, low), (x, y, high), thick), 1)
        heads = [capsule((x, -y, z), (x, y, z), thick + 0.02) for z in (low, high)]
        return join(posts, *heads)

    leg = taper((end, y, low), (end, y + 0.1, 0.1), 0.15, 0.12)
    out = end + 0.5
    parts = {
        "columns": join(*map(section, places)),
        "pipes": join(
            *(tube((-end - 0.2, 0, z), (end + 0.2, 0, z), 0.12, 0.03) for z in (low, high)),
            limb([(end, 0, low), (out, 0, low), (out, 0, 0.0)], 0.09, 0.09),
        ),
        "feet": both(leg, 0, 1),
        "valve": tube((out, 0, low - 0.14), (out, 0, low + 0.18), 0.16, 0.03),
        "knob": tube((out, 0, low + 0.14), (out, 0, low + 0.46), 0.19, 0.06),
    }
    # The valve makes it longer to the right.
    return {name: moved(solid, (-0.27, 0, 0)) for name, solid in parts.items()}


def air_conditioner(draw: Draw) -> Parts:
    """A wide indoor unit, round below: its outlet with a flap, a display, slits on top."""
    x, deep, high = draw(1.1, 1.22), draw(0.44, 0.52), draw(0.74, 0.84)
    soft = draw.chance(0.5)
    front = [(-deep * 0.1, 0.0), (-deep * 0.86, high * 0.34), (-deep, high * 0.56)]
    front += [(-deep, high * 0.84), (-deep * 0.78, high)]
    boxy = [(-deep * 0.2, 0.0), (-deep, high * 0.38), (-deep, high)]
    outline = [(deep * 0.55, high), (deep * 0.55, 0.0), *(front if soft else boxy)]
    wider = [(v * 1.06, (w - high / 2) * 1.06 + high / 2) for v, w in outline]
    # The outlet lies in the slope below, and its flap is hinged at the lower edge.
    (y0, z0), (y1, z1) = outline[2:4]
    slope = math.degrees(math.atan2(y0 - y1, z1 - z0))
    vent = box((0, 0, 0), (x * 0.84, 0.06, math.dist((y0, z0), (y1, z1)) * 0.4))
    flap = box((0, 0, -0.17), (x * 0.84, 0.075, 0.2), 0.03)
    return {
        "body": prism(outline, 0, x),
        "ends": both(prism(wider, 0, 0.1, x)),
        "vent": tilted(vent, slope, (0, (y0 + y1) / 2, (z0 + z1) / 2)),
        "flap": tilted(flap, -draw(62, 74), (0, y0 - 0.06, z0 + 0.02)),
        "display": box((x * 0.62, -deep, high * 0.68), (0.2, 0.06, 0.1), 0.02),
        "slits": join(
            *(box((0, deep * 0.24 - 0.34 * k, high), (x * 0.8, 0.08, 0.06)) for k in range(2))
        ),
    }


def ironing_board(draw: Draw) -> Parts:
    """A board with a pointed end to the left, on crossed legs, a rest at its right end."""
    long, wide, high = draw(1.02, 1.1), draw(0.34, 0.39), draw(1.2, 1.38)
    half = [(long, wide * 0.86), (long - 0.08, wide), (-long * 0.45, wide)]
    half += [(-long * 0.82, wide * 0.7), (-long * 0.97, wide * 0.34), (-long, 0.0)]
    outline = [*half, *((u, -v) for u, v in reversed(half[:-1]))]
    reach, foot = draw(0.58, 0.68), wide * 0.9

    def leg(sign: float, y: float) -> Solid:
        return both(capsule((-sign * reach, y, 0.1), (sign * reach, y, high), 0.085), 1)

    bars = [capsule((s * reach, -foot, 0.1), (s * reach, foot, 0.1), 0.085) for s in (1, -1)]
    rest = [(long - 0.1, high + 0.02), (long + 0.36, high + 0.02), (long + 0.4, high + 0.12)]
    rods = both(limb([(u, wide * 0.62, v) for u, v in rest], 0.08, 0.08), 1)
    return {
        "cover": prism(outline, 2, 0.1, high + 0.1),
        "frame": prism([(u * 0.99, v * 0.9) for u, v in outline], 2, 0.1, high),
        "legs": join(leg(1, foot * 0.55), leg(-1, foot * 0.3), *bars),
        "feet": both(ball((reach, foot, 0.1), 0.125), 0, 1),
        "rest": join(
            rods,
            capsule(
                (long + 0.36, -wide * 0.62, high + 0.1),
                (long + 0.36, wide * 0.62, high + 0.1),
                0.08,
            ),
        ),
    }


def clothes_hanger(draw: Draw) -> Parts:
    """Two sloping shoulders, a bar between their ends, a hook above."""
    wide, drop, y = draw(1.15, 1.28), draw(0.56, 0.7), draw(0.11, 0.13)
    bar, size = draw(0.46, 0.56), draw(0.25, 0.29)
    top = bar + drop
    stops = [(0.0, top), (0.2, top - 0.04), (wide * 0.6, bar + drop * 0.42), (wide, bar)]
    curve = smooth_curve(stops, 4)
    arm = limb([(u, 0, v) for u, v in curve], y + 0.04, y)
    end = (wide - 0.04, 0, bar + 0.02)
    low = capsule((0, 0, bar - 0.06), end, 0.095)
    z = top + 0.42 + size
    turns = [math.radians(a) for a in range(-90, 171, 26)]
    hook = [(size * math.cos(a), 0, z + size * math.sin(a)) for a in turns]
    return {
        "body": both(arm),
        "bar": both(low),
        "hook": limb([(0, 0, top), (0, 0, z - size - 0.06), *hook], 0.085, 0.085),
        "collar": tube((0, 0, top + 0.06), (0, 0, top + 0.26), 0.15, 0.03),
        "ends": both(taper((wide - 0.2, 0, bar + 0.11), (wide, 0, bar), y + 0.04, y + 0.045)),
    }


def high_chair(draw: Draw) -> Parts:
    """A small seat with a tray before it, on four long legs that stand apart, with a footrest."""
    seat, x, top = draw(1.1, 1.26), draw(0.48, 0.54), draw(0.78, 0.9)
    foot, y = draw(0.68, 0.78), draw(0.42, 0.48)
    leg = taper((x * 0.8, y * 0.72, seat), (foot, foot * 0.92, 0.08), 0.1, 0.09)
    pad = tilted(box((0, 0, top / 2 - 0.06), (x, 0.09, top / 2 + 0.06), 0.08), -8, (0, y, seat))
    tray, front = seat + 0.42, -y - 0.12
    rail = both(capsule((x, y - 0.1, tray - 0.06), (x, front, tray - 0.06), 0.085))
    step = draw(0.44, 0.52)
    out = x * 0.8 + (foot - x * 0.8) * (1 - step / seat)
    rest = box((0, -out * 0.92 - 0.1, step), (out + 0.06, 0.17, 0.085), 0.03)
    soft = join(
        box((0, -0.06, seat + 0.14), (x - 0.08, y - 0.08, 0.11), 0.06),
        tilted(box((0, -0.1, top * 0.56), (x - 0.1, 0.09, top * 0.36), 0.07), -8, (0, y, seat)),
    )
    dish = box((0, front, tray), (x + 0.2, 0.32, 0.1), 0.08)
    hollow = box((0, front, tray + 0.13), (x + 0.06, 0.19, 0.1), 0.04)
    return {
        "seat": join(box((0, 0, seat), (x, y, 0.11), 0.05), pad, rail),
        "cushion": soft,
        "tray": cut(dish, hollow),
        "legs": both(leg, 0, 1),
        "footrest": rest,
        "feet": both(ball((foot, foot * 0.92, 0.1), 0.13), 0, 1),
    }


def shopping_cart(draw: Draw) -> Parts:
    """A basket of wires that narrows to the front, on wheels, a grip at its back."""
    long, wide, high = draw(0.8, 0.9), draw(0.52, 0.58), draw(1.5, 1.64)
    low, r, deep = draw(0.74, 0.84), draw(0.17, 0.2), 0.085
    shrink, rise = draw(0.76, 0.84), 0.12
    back, front = long, -long

    def at(y: float, z: float) -> tuple[float, float, float]:
        """On the basket's right side: it narrows to the front and downwards."""
        f = (back - y) / (2 * long)
        g = (high - z) / (high - low)
        return wide * (1 - (1 - shrink) * f) * (1 - 0.12 * g), y, z - 0.0 * f

    def floor(y: float) -> float:
        return low + rise * (back - y) / (2 * long)

    count = 5
    rows = [back + (front - back) * k / (count - 1) for k in range(count)]
    wires: list[Solid] = []
    for k, y in enumerate(rows):
        lean = 0.86 if k == count - 1 else 1.0  # the front slopes
        wires.append(both(capsule(at(y, high), at(y * lean, floor(y)), deep)))
    for f in (0.0, 0.5, 1.0):
        ends = []
        for y in (back, front):
            z = floor(y) + (high - floor(y)) * f
            slope = 0.86 + 0.14 * f if y == front else 1.0
            ends.append(at(y * slope, z))
        a, b = ends
        wires += [both(capsule(a, b, deep)), capsule(b, (-b[0], b[1], b[2]), deep)]
        wires.append(capsule(a, (-a[0], a[1], a[2]), deep))
    top, bottom = at(front, high), at(front * 0.86, floor(front))
    for s in (-0.34, 0.34):
        wires.append(
            capsule((s * top[0], top[1], top[2]), (s * bottom[0], bottom[1], bottom[2]), deep)
        )
    sheet = [(back, low), (front * 0.86, floor(front))]
    plate = prism([*sheet, (sheet[1][0], sheet[1][1] + 0.14), (back, low + 0.14)], 0, wide * 0.74)
    z = r + 0.2
    chassis = join(
        both(
            limb(
                [
                    (wide * 0.8, back * 0.9, low),
                    (wide * 0.84, back * 0.66, z),
                    (wide * 0.72, front * 0.72, z),
                ],
                0.09,
                0.09,
            )
        ),
        capsule((-wide * 0.84, back * 0.66, z), (wide * 0.84, back * 0.66, z), 0.09),
        capsule((-wide * 0.72, front * 0.72, z), (wide * 0.72, front * 0.72, z), 0.09),
        both(capsule((wide * 0.72, front * 0.72, z), (wide * 0.66, front * 0.4, low + 0.1), 0.09)),
    )
    grip = high + 0.16
    wheel = join(
        tube((wide * 0.84 - 0.09, back * 0.66, r), (wide * 0.84 + 0.09, back * 0.66, r), r, 0.03),
        tube((wide * 0.72 - 0.09, front * 0.72, r), (wide * 0.72 + 0.09, front * 0.72, r), r, 0.03),
    )
    return {
        "basket": join(*wires, plate),
        "frame": join(chassis, both(capsule(at(back, high), (wide, back + 0.26, grip), 0.09))),
        "handle": capsule(
            (-wide - 0.05, back + 0.28, grip), (wide + 0.05, back + 0.28, grip), 0.125
        ),
        "wheels": both(wheel),
        "flap": box((0, back + 0.04, high - 0.34), (wide * 0.6, 0.1, 0.26), 0.03),
    }


def aquarium(draw: Draw) -> Parts:
    """Water in a frame, gravel below; fish and plants swim and grow out of all four sides."""
    x, y, high = draw(1.0, 1.14), draw(0.56, 0.66), draw(1.2, 1.36)
    layout, edge = draw.arranged(3), 0.1
    wide, deep, low = x - 0.12, y - 0.12, 0.2
    posts = both(box((x - edge, y - edge, high / 2), (edge, edge, high / 2), 0.02), 0, 1)
    lids = [box((0, 0, z), (x + 0.02, y + 0.02, h), 0.03) for z, h in ((0.09, 0.1), (high, 0.13))]

    def fish(at: float, z: float, size: float, way: float) -> Solid:
        tail = [(0.26, 0.0), (0.62, 0.26), (0.54, 0.0), (0.62, -0.26)]
        fin = [(-0.12, 0.2), (0.16, 0.42), (0.2, 0.14)]
        flat = [prism([(way * size * u, size * v) for u, v in c], 1, 0.09) for c in (tail, fin)]
        shape = join(egg((0, 0, 0), (size * 0.46, 0.16, size * 0.3)), *flat)
        return both(moved(shape, (at, deep, z)), 1)

    def weed(at: float, tall: float, sway: float) -> Solid:
        stops = [(at, low), (at + sway, low + tall * 0.35), (at - sway, low + tall * 0.7)]
        stops += [(at + sway * 0.6, low + tall)]
        return limb([(u, deep, v) for u, v in smooth_curve(stops, 3)], 0.13, 0.08)

    side = 1 if draw.chance(0.5) else -1
    z = high * 0.5
    school = [
        fish(side * wide * 0.3, z + 0.22, 0.62, 1),
        fish(-side * wide * 0.12, z - 0.16, 0.5, -1),
    ]
    lone = turned(fish(0.0, z + 0.1, 0.5, 1), 2, 90)  # on the short sides
    reach = wide - deep
    grown = [
        weed(-side * wide * 0.72, high * 0.62, 0.08),
        weed(-side * wide * 0.45, high * 0.36, -0.06),
    ]
    grown.append(weed(side * wide * 0.8, high * 0.4, 0.05))
    stones = [
        egg((f * wide, 0, low + 0.02), (0.2, deep + 0.07, layout(0.1, 0.19)))
        for f in (-0.84, -0.5, -0.16, 0.18, 0.52, 0.84)
    ]
    return {
        "water": box((0, 0, high / 2), (wide, deep, high / 2)),
        "frame": join(posts, *lids),
        "gravel": join(box((0, 0, low), (wide + 0.06, deep + 0.06, 0.13), 0.03), *stones),
        "fish": join(*school, both(moved(lone, (reach, 0, 0)))),
        "plants": both(join(*grown), 1),
        "lid": box((0, 0, high + 0.17), (x * 0.72, y * 0.66, 0.1), 0.03),
    }


def birdcage(draw: Draw) -> Parts:
    """Bars that meet in a dome, a tray, a ring to hang it by, a small bird on its perch."""
    r, wall, dome = draw(0.72, 0.8), draw(0.98, 1.14), draw(0.6, 0.72)
    count, low, thick = 10 + 2 * draw.chance(0.4), 0.22, 0.078
    top = wall + dome
    turns = [math.pi / 2 * k / 5 for k in range(6)]
    bar = limb(
        [(r, 0, low), *((r * math.cos(a), 0, wall + dome * math.sin(a)) for a in turns)],
        thick,
        thick,
    )
    z = low + (wall - low) * 0.42
    body, head = z + 0.27, z + 0.56
    bird = join(
        taper((0, 0.02, body), (0, 0, body + 0.12), 0.25, 0.2),
        ball((0, -0.06, head), 0.19),
        taper((0, 0.16, body - 0.06), (0, 0.42, body - 0.24), 0.12, 0.09),
        taper((0, -0.2, head), (0, -0.36, head - 0.03), 0.1, 0.05),
    )
    return {
        "bars": around(count, bar),
        "hoops": join(ring((0, 0, wall), r, 0.085), ring((0, 0, low + 0.06), r, 0.085)),
        "tray": lathe([(r + 0.02, 0.0), (r + 0.14, 0.06), (r + 0.14, low), (r, low + 0.02)], 0.02),
        "ring": join(
            tube((0, 0, top - 0.1), (0, 0, top + 0.14), 0.16, 0.04),
            ring((0, 0, top + 0.3), 0.19, 0.08, axis=1),
        ),
        "perch": capsule((-r, 0, z), (r, 0, z), 0.085),
        "bird": bird,
    }


def remote_control(draw: Draw) -> Parts:
    """Upright and leaning back: a red key on top, a round pad, rows of keys."""
    x, y, high = draw(0.4, 0.46), draw(0.16, 0.19), draw(2.2, 2.36)
    soft, pad = draw(0.06, 0.14), draw(0.25, 0.28)
    rows, key = 3, 0.08
    middle = high * 0.52
    pitch, face = x * 0.6, -y

    def lean(solid: Solid) -> Solid:
        return tilted(solid, -12, (0, 0, 0))

    low, step = 0.22, (middle - pad - 0.4) / (rows - 1)
    keys = [
        box((pitch * k, face, low + step * row), (key + 0.01, 0.06, key), 0.03)
        for k in (-1, 0, 1)
        for row in range(rows)
    ]
    up = (middle + pad + high - 0.3) / 2
    return {
        "body": lean(box((0, 0, high / 2), (x, y, high / 2), soft)),
        "power": lean(
            tube((-pitch, face - 0.07, high - 0.18), (-pitch, 0, high - 0.18), 0.105, 0.02)
        ),
        "pad": lean(tube((0, face - 0.06, middle), (0, 0, middle), pad, 0.02)),
        "button": lean(tube((0, face - 0.11, middle), (0, 0, middle), 0.125, 0.02)),
        "keys": lean(join(*keys, box((pitch, face, high - 0.18), (0.1, 0.06, 0.08), 0.03))),
        "bars": lean(both(capsule((pitch, face, up - 0.07), (pitch, face, up + 0.07), 0.085))),
    }


FIXTURES = {
    "faucet": faucet,
    "radiator": radiator,
    "air conditioner": air_conditioner,
    "ironing board": ironing_board,
    "clothes hanger": clothes_hanger,
    "high chair": high_chair,
    "shopping cart": shopping_cart,
    "aquarium": aquarium,
    "birdcage": birdcage,
    "remote control": remote_control,
}
