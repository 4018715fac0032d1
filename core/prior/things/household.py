"""Furniture, kitchen, light and dress."""

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
    around,
    ball,
    blend,
    both,
    box,
    capsule,
    cut,
    egg,
    join,
    lathe,
    prism,
    ring,
    smooth_curve,
    taper,
    tube,
)


def sofa(draw: Draw) -> Parts:
    """Two or three seats, arms, a back."""
    x, y, seat = draw(1.25, 1.45), draw(0.55, 0.65), draw(0.5, 0.58)
    arm, arm_top, soft = draw(0.16, 0.21), seat + draw(0.22, 0.32), draw(0.08, 0.13)
    back, back_top = draw(0.17, 0.22), seat + draw(0.55, 0.7)
    seats = 2 + draw.chance(0.5)
    width = (x - 1.6 * arm) / seats
    cushions = (
        box(((2 * k + 1 - seats) * width, -0.08, seat), (width * 0.98, y - 0.06, 0.14), 0.08)
        for k in range(seats)
    )
    return {
        "cushion": join(*cushions),
        "back": box((0, y - back, back_top / 2 + 0.1), (x - 0.03, back, back_top / 2 - 0.1), soft),
        "arms": both(box((x - arm, 0, arm_top / 2 + 0.1), (arm, y, arm_top / 2 - 0.1), soft)),
        "base": box((0, 0, seat / 2 + 0.08), (x - 0.06, y - 0.04, seat / 2 - 0.06), 0.03),
        "feet": both(tube((x - 0.2, y - 0.2, 0), (x - 0.2, y - 0.2, 0.25), 0.11, 0.02), 0, 1),
    }


def stool(draw: Draw) -> Parts:
    """A round seat on three or four legs, or on one foot."""
    seat, top, thick, leg = draw(0.52, 0.62), draw(1.15, 1.5), draw(0.12, 0.17), draw(0.1, 0.125)
    count = draw.legs(3, 4, 4, 1)
    if count == 1:
        foot = tube((0, 0, 0), (0, 0, 0.13), seat * 0.85, 0.04)
        legs = join(tube((0, 0, 0), (0, 0, top), leg * 1.15), foot)
    else:
        low, high = seat * draw(0.88, 1.1), seat * 0.66
        legs = around(count, capsule((low, 0, leg), (high, 0, top), leg), 45 if count == 4 else -90)
    return {"seat": tube((0, 0, top - thick), (0, 0, top + thick), seat, 0.08), "legs": legs}


def bench(draw: Draw) -> Parts:
    """A park bench."""
    x, y, seat, plate = draw(1.25, 1.45), draw(0.42, 0.5), draw(0.55, 0.65), draw(0.085, 0.1)
    back, top = draw(0.08, 0.1), seat + draw(0.65, 0.8)
    has_back, foot = draw.has("backrest", 0.8), draw(0.1, 0.13)
    leg = box((x - 0.3, 0, seat / 2), (foot, y - 0.04, seat / 2), 0.02)
    arch = box((x - 0.3, 0, 0), (0.4, y - 0.28, seat * 0.45))
    parts = {"seat": box((0, 0, seat), (x, y, plate), 0.03), "legs": both(cut(leg, arch))}
    if not has_back:
        return parts
    rails = (
        box((0, y - back, seat + (top - seat) * k), (x, back, 0.13), 0.03) for k in (0.42, 0.88)
    )
    posts = both(box((x * 0.78, y - back, (seat + top) / 2), (0.11, back, (top - seat) / 2)))
    return parts | {"back": join(*rails, posts)}


def bed(draw: Draw) -> Parts:
    """A mattress, a pillow, a blanket; the head stands at the back."""
    x, y, low = draw(0.75, 0.95), draw(1.15, 1.3), draw(0.35, 0.45)
    soft, head, foot = draw(0.17, 0.22), draw(0.95, 1.25), draw(0.5, 0.65)
    fold = draw(0.1, 0.4)
    blanket = box(
        (0, (fold - y) / 2, low + soft), (x - 0.0, (fold + y) / 2 - 0.08, soft + 0.06), 0.08
    )
    return {
        "blanket": blanket,
        "mattress": box((0, 0, low + soft), (x - 0.07, y - 0.08, soft), 0.07),
        "pillow": box((0, y - 0.42, low + 2 * soft + 0.06), (x * 0.66, 0.24, 0.15), 0.13),
        "frame": join(
            box((0, 0, low - 0.06), (x, y, 0.12), 0.03),
            box((0, y, head / 2), (x + 0.03, 0.1, head / 2), 0.05),
            box((0, -y, foot / 2), (x + 0.03, 0.1, foot / 2), 0.05),
        ),
    }


def bookshelf(draw: Draw) -> Parts:
    """Three boards with thick books, apart from one another, in three colours."""
    x, y, high, wall = draw(0.74, 0.85), draw(0.3, 0.36), draw(1.9, 2.2), 0.11
    shelves, each, apart, back = 3, 4, 0.1, 0.14
    gap, wide = (high - wall) / shelves, 2 * (x - wall)
    rooms = (
        box((0, -back, wall + gap * k + (gap - wall) / 2), (wide / 2, y, (gap - wall) / 2))
        for k in range(shelves)
    )
    rows: list[list[Solid]] = [[], [], []]
    thick, order = (wide - apart * (each + 1)) / each, draw.which(2)
    for k in range(shelves):
        for book in range(each):
            if (k, book) == ((0, 3), (2, 3))[order]:
                continue
            tall = (gap - wall) * (0.78, 0.62, 0.72, 0.56)[(book + k + order) % 4] / 2
            u = -wide / 2 + apart + thick / 2 + (thick + apart) * book
            # A little sunk into the boards: of what only touches, the surfaces lie in each other.
            at = (u, -0.02, wall + gap * k + tall - 0.03)
            rows[(book + 2 * k) % 3].append(box(at, (thick / 2, y - 0.08, tall)))
    return {
        "frame": cut(box((0, 0, high / 2), (x, y, high / 2)), *rooms),
        "books": join(*rows[0]),
        "volumes": join(*rows[1]),
        "tomes": join(*rows[2]),
    }


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


def bowl(draw: Draw) -> Parts:
    """Half a hollow ball on a foot."""
    wide, deep, wall = draw(0.95, 1.1), draw(0.6, 0.8), draw(0.1, 0.13)
    shell = [(0.38, 0.1), (wide * 0.72, 0.24), (wide * 0.93, deep * 0.62), (wide, deep)]
    hole = [(0.2, 0.1 + wall), (wide * 0.72 - wall, 0.26 + wall), (wide * 0.93 - wall, deep * 0.66)]
    hole += [(wide - wall, deep), (wide - wall, deep + 0.3)]
    outer, inner = lathe(smooth_curve(shell, 4), 0.02), lathe(smooth_curve(hole, 4))
    return {"body": cut(outer, inner), "foot": tube((0, 0, 0), (0, 0, 0.16), draw(0.4, 0.5), 0.03)}


def pan(draw: Draw) -> Parts:
    """A frying pan, its handle to the right."""
    wide, high, reach = draw(0.72, 0.82), draw(0.26, 0.36), draw(0.85, 1.05)
    x = -0.6
    dish = lathe([(wide - 0.12, 0.0), (wide, high)], 0.03, (x, 0))
    hole = lathe([(wide - 0.22, 0.12), (wide - 0.1, high + 0.03), (wide - 0.1, 1.0)], 0, (x, 0))
    start, end = x + wide - 0.02, x + wide + reach
    grip = taper((start, 0, high * 0.7), (end, 0, high * draw(0.9, 1.4)), 0.1, 0.13)
    return {"body": cut(dish, hole), "handle": grip}


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


def bucket(draw: Draw) -> Parts:
    """A pail with its handle up."""
    low, high, top = draw(0.5, 0.58), draw(1.0, 1.2), draw(0.7, 0.8)
    hole = [(low - 0.1, 0.14), (top - 0.1, high), (top - 0.1, high + 0.4)]
    rim = ring((0, 0, high), top, 0.08)
    parts = {"body": join(cut(lathe([(low, 0), (top, high)], 0.01), lathe(hole)), rim)}
    if draw.has("handle", 0.85):
        bow = ring((0, 0, high), top, draw(0.085, 0.1), axis=1)
        parts |= {"handle": cut(bow, box((0, 0, high - 1), (2, 2, 1)))}
    return parts


def candle(draw: Draw) -> Parts:
    """A burning candle on a dish, which may have a loop to the right."""
    radius, high, dish = draw(0.2, 0.27), draw(1.0, 1.4), draw(0.5, 0.62)
    plate = cut(
        lathe([(dish * 0.8, 0), (dish, 0.2)], 0.03),
        lathe([(dish * 0.66, 0.12), (dish - 0.08, 0.6)]),
    )
    socket = tube((0, 0, 0.05), (0, 0, 0.34), radius + 0.1, 0.03)
    holder = [plate, socket]
    if draw.has("handle", 0.4):
        holder.append(ring((dish + 0.12, 0, 0.17), 0.2, 0.085, axis=1))
    top = 0.2 + high
    flame = join(
        egg((0, 0, top + 0.3), (0.13, 0.13, 0.2)),
        taper((0, 0, top + 0.33), (0, 0, top + 0.55), 0.11, 0.03),
    )
    return {
        "wax": tube((0, 0, 0.1), (0, 0, top), radius, 0.05),
        "flame": join(flame, tube((0, 0, top - 0.1), (0, 0, top + 0.2), 0.08)),
        "holder": join(*holder),
    }


def crown(draw: Draw) -> Parts:
    """A band with six points, pearls on their tips, and gems."""
    wide, band, reach = draw(0.8, 0.9), draw(0.34, 0.44), draw(0.45, 0.6)
    top, foot = band + reach, wide * 0.42
    hoop = cut(tube((0, 0, 0), (0, 0, band), wide + 0.05), tube((0, 0, -1), (0, 0, 3), wide - 0.13))
    flat = [(-foot, band - 0.12), (foot, band - 0.12), (0.06, top), (-0.06, top)]
    spike = prism(flat, 0, 0.085, wide - 0.03)
    return {
        "band": join(hoop, around(6, spike, -90)),
        "pearls": around(6, ball((wide - 0.03, 0, top + 0.04), 0.15), -90),
        "gems": around(6, ball((wide + 0.06, 0, band * 0.48), 0.14), -90),
    }


def hat(draw: Draw) -> Parts:
    """A top hat, or a lower one with a round crown."""
    wide, high, brim = draw(0.52, 0.62), draw(0.75, 1.05), draw(0.95, 1.1)
    low = tube((0, 0, 0), (0, 0, 0.17), brim, 0.07)
    if draw.chance(0.5):
        body = lathe([(wide * 0.95, 0.05), (wide * draw(0.95, 1.1), high)], 0.04)
    else:
        body = join(
            egg((0, 0, high * 0.45), (wide, wide, high * 0.5)),
            tube((0, 0, 0.05), (0, 0, high * 0.45), wide),
        )
    ribbon = tube((0, 0, 0.15), (0, 0, draw(0.34, 0.4)), wide + 0.05, 0.02)
    return {"body": join(low, body), "ribbon": ribbon}


def bell(draw: Draw) -> Parts:
    """A bell with its loop and its clapper."""
    wide, high = draw(0.8, 0.9), draw(1.15, 1.35)
    shape = [
        (wide, 0.0),
        (wide * 0.78, 0.2),
        (wide * 0.6, high * 0.5),
        (wide * 0.5, high * 0.85),
        (0.12, high),
    ]
    hole = lathe(
        [(wide * 0.82, -0.3), (wide * 0.82, 0.0), (wide * 0.42, high * 0.5), (0.2, high * 0.75)]
    )
    loop = ring((0, 0, high + 0.2), draw(0.2, 0.24), 0.1, axis=1)
    return {
        "body": cut(lathe(smooth_curve(shape, 4), 0.03), hole),
        "loop": loop,
        "clapper": join(ball((0, 0, 0.0), 0.22), tube((0, 0, 0), (0, 0, high * 0.8), 0.09)),
    }


def bust(draw: Draw) -> Parts:
    """A marble hero: a cap of great curls, a straight nose, shoulders cut off, a round pedestal."""
    r, wide, low = draw(0.43, 0.46), draw(0.66, 0.72), draw(0.42, 0.46)
    z = low + draw(1.24, 1.3)
    front = -r * 0.98
    chest = blend(0.2, egg((0, 0, low + 0.3), (wide, 0.38, 0.42)),
                  taper((0, 0.04, low + 0.4), (0, 0.04, z - r * 0.4), 0.3, 0.24))  # fmt: skip
    sides = both(box((wide + 0.86, 0, low), (1, 2, 2)))
    brow = z + r * 0.16
    arches = both(capsule((0.06, front + 0.02, brow), (r * 0.56, front + 0.13, brow), 0.085))
    skull = blend(0.1, egg((0, 0.02, z), (r * 0.84, r, r * 1.1)), arches,
                  egg((0, -r * 0.4, z - r * 0.72), (r * 0.56, r * 0.56, r * 0.56)))  # fmt: skip
    curls = (
        ball((r * u, r * v, z + r * t), 0.17)
        for u, v, t in ((0.0, -0.8, 0.78), (0.42, -0.66, 0.76), (0.72, -0.34, 0.56),
                        (0.0, -0.36, 1.02), (0.42, -0.04, 0.96), (0.76, 0.16, 0.58),
                        (0.84, 0.3, 0.12), (0.0, 0.36, 1.0), (0.42, 0.58, 0.72), (0.0, 0.86, 0.6),
                        (0.64, 0.68, 0.26), (0.26, 0.96, 0.16), (0.48, 0.7, -0.24),
                        (0.0, 0.84, -0.3))
    )  # fmt: skip
    plinth = [(0.46, 0.0), (0.46, 0.14), (0.36, 0.2), (0.24, 0.28), (0.24, 0.32), (0.36, low),
              (0.36, low + 0.1)]  # fmt: skip
    ridge = [(front + 0.12, brow + 0.04), (front - 0.04, brow - 0.02),
             (front - 0.14, z - r * 0.48), (front + 0.12, z - r * 0.54)]  # fmt: skip
    lips = (egg((0, front + 0.06, v), (half, 0.1, 0.075))
            for half, v in ((0.15, z - r * 0.76), (0.1, z - r * 0.92)))  # fmt: skip
    return {
        "body": join(cut(chest, box((0, 0, low - 0.92), (2, 2, 1)), sides), skull,
                     both(egg((r * 0.86, 0.02, z - 0.06), (0.1, 0.13, 0.17)))),
        "hair": both(join(*curls)),
        "base": lathe(plinth, 0.02),
        "face": join(
            prism(ridge, 0, 0.08),
            both(ball((r * 0.38, front + 0.1, brow - 0.12), 0.11)),
            *lips,
        ),
    }  # fmt: skip


def trophy(draw: Draw) -> Parts:
    """A cup with two ears on a block."""
    wide, low, high = draw(0.46, 0.54), draw(0.38, 0.48), draw(0.8, 0.95)
    bottom = low + 0.4
    shape = [(0.12, low), (0.12, bottom), (wide * 0.85, bottom + 0.28), (wide, bottom + high)]
    hole = lathe(
        [(wide * 0.5, bottom + 0.4), (wide - 0.1, bottom + high), (wide - 0.1, bottom + high + 0.4)]
    )
    cup = cut(lathe(smooth_curve(shape, 4), 0.02), hole)
    ear = ring((wide * 0.98, 0, bottom + high * 0.6), draw(0.26, 0.31), 0.09, axis=1)
    return {
        "cup": cup,
        "handles": both(cut(ear, hole)),
        "base": join(
            box((0, 0, low / 2), (0.42, 0.42, low / 2), 0.04),
            tube((0, 0, low), (0, 0, low + 0.12), 0.3, 0.03),
        ),
    }


def pin(draw: Draw) -> Parts:
    """A bowling pin."""
    belly, neck, head = draw(0.46, 0.54), draw(0.16, 0.2), draw(0.27, 0.31)
    shape = [(0.28, 0.0), (belly, 0.75), (neck, 1.6), (head, 2.0), (0.1, 2.3)]
    return {"body": lathe(smooth_curve(shape, 4), 0.03)}


HOUSEHOLD = {
    "sofa": sofa,
    "stool": stool,
    "bench": bench,
    "bed": bed,
    "bookshelf": bookshelf,
    "teapot": teapot,
    "bowl": bowl,
    "pan": pan,
    "goblet": goblet,
    "bucket": bucket,
    "candle": candle,
    "crown": crown,
    "hat": hat,
    "bell": bell,
    "bust": bust,
    "trophy": trophy,
    "bowling pin": pin,
}
