"""Furniture of the house's rooms."""

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    around,
    ball,
    both,
    box,
    capsule,
    cut,
    egg,
    join,
    lathe,
    moved,
    prism,
    ring,
    taper,
    tilted,
    tube,
    turned,
)
from core.prior.things.chests import feet


def office_chair(draw: Draw) -> Parts:
    """A seat that turns on a star of wheels."""
    high, wide, tall, soft = draw(0.9, 1.05), draw(0.46, 0.54), draw(0.42, 0.62), draw(0.08, 0.12)
    back = moved(
        turned(box((0, 0, tall), (wide * 0.92, 0.11, tall), soft), 0, -8), (0, 0.42, high + 0.22)
    )
    post = capsule((0, 0.3, high - 0.05), (0, 0.55, high + 0.5), 0.1)
    star = around(5, capsule((0, 0, 0.34), (0.56, 0, 0.24), 0.085), -90)
    parts = {
        "seat": box((0, -0.02, high), (wide, 0.5, 0.13), 0.11),
        "back": back,
        "base": join(tube((0, 0, 0.25), (0, 0, high), 0.11), star, post),
        "wheels": around(5, ball((0.6, 0, 0.14), 0.14), -90),
    }
    if draw.has("armrests", 0.65):
        rest = join(
            box((wide + 0.07, -0.02, high + 0.42), (0.09, 0.34, 0.075), 0.05),
            capsule((wide - 0.08, 0.1, high - 0.02), (wide + 0.07, 0.1, high + 0.4), 0.08),
        )
        parts["arms"] = both(rest)
    return parts


def rocking_chair(draw: Draw) -> Parts:
    """A chair on two bows."""
    x, seat, tall, lean = draw(0.44, 0.52), draw(0.78, 0.9), draw(1.05, 1.3), draw(8, 15)
    bow = cut(ring((x, 0, 1.6), 1.52, 0.1, axis=0), box((0, 0, 2.42), (2, 2, 2)))
    legs = join(*(capsule((x, y, 0.16), (x * 0.95, y, seat), 0.095) for y in (-0.42, 0.42)))
    slats = [box((u, 0, tall / 2), (0.075, 0.07, tall / 2)) for u in (-0.22, 0.0, 0.22)]
    posts = both(capsule((x - 0.04, 0, 0), (x - 0.04, 0, tall), 0.095))
    rail = box((0, 0, tall), (x + 0.05, 0.09, draw(0.11, 0.17)), 0.06)
    rest = join(
        capsule((x, -0.46, seat + 0.42), (x, 0.56, seat + 0.46), 0.09),
        capsule((x, -0.4, seat - 0.02), (x, -0.4, seat + 0.42), 0.085),
    )
    parts = {
        "seat": box((0, 0, seat), (x + 0.06, 0.52, 0.1), 0.04),
        "back": moved(turned(join(*slats, posts, rail), 0, -lean), (0, 0.44, seat)),
        "legs": both(legs),
        "rockers": both(bow),
    }
    return parts | {"arms": both(rest)} if draw.has("armrests", 0.75) else parts


def throne(draw: Draw) -> Parts:
    """A king's seat: a high pointed back, arms, golden knobs."""
    x, seat, top, arm = draw(0.6, 0.7), draw(0.62, 0.75), draw(2.1, 2.5), draw(0.14, 0.17)
    peak, y = top + draw(0.2, 0.4), 0.5
    back = prism([(-x, 0.1), (x, 0.1), (x, top), (0, peak), (-x, top)], 1, 0.13, y)
    pad = prism(
        [
            (-x * 0.66, seat),
            (x * 0.66, seat),
            (x * 0.66, top - 0.2),
            (0, peak - 0.3),
            (-x * 0.66, top - 0.2),
        ],
        1,
        0.1,
        y - 0.12,
    )
    rest = join(
        box((x - arm, 0, seat + 0.4), (arm, 0.62, 0.1), 0.03),
        box((x - arm, -0.45, seat / 2 + 0.2), (arm, 0.14, seat / 2 + 0.2), 0.02),
    )
    knobs = [ball((0, y, peak + 0.1), 0.2), both(ball((x, y, top + 0.1), 0.17))]
    return {
        "cushion": join(pad, box((0, -0.08, seat + 0.06), (x - 2 * arm + 0.04, 0.56, 0.13), 0.09)),
        "frame": join(back, box((0, 0, seat / 2), (x - 0.04, 0.58, seat / 2)), both(rest)),
        "knobs": join(*knobs, both(ball((x - arm, -0.6, seat + 0.42), 0.17))),
        "step": box((0, -0.05, 0.06), (x + 0.2, 0.85, draw(0.08, 0.12)), 0.02),
    }


def bunk_bed(draw: Draw) -> Parts:
    """Two beds, one above the other, between four posts; a ladder leans at the front's right, a low
    rail is on top, the pillows are left."""
    x, y, low, high = draw(1.14, 1.18), draw(0.64, 0.67), draw(0.42, 0.45), draw(1.5, 1.54)
    at, top, levels = x - 0.6, high + 0.76, (low, high)
    posts = join(box((x, y, top / 2), (0.14, 0.14, top / 2), 0.03), ball((x, y, top + 0.08), 0.18))
    beds = (box((0, 0, z), (x, y + 0.08, 0.14)) for z in levels)
    ends = (both(box((x, 0, z + 0.12), (0.09, y, 0.34))) for z in levels)
    side, rail = at - 0.44, high + 0.62
    guards = (box(((side - x) / 2, -y, rail), ((side + x) / 2, 0.09, 0.09)),
              box((side - 0.09, -y, rail - 0.22), (0.09, 0.09, 0.31)),
              box((0, y, rail), (x, 0.09, 0.09)))  # fmt: skip
    long = high + 0.52
    steps = (0.34 + 0.4 * k for k in range(5))
    ladder = join(
        both(box((0.27, 0, long / 2), (0.08, 0.09, long / 2), 0.03)),
        *(capsule((-0.27, 0, z), (0.27, 0, z), 0.075) for z in steps),
    )
    return {
        "blanket": join(*(box((0.3, 0, z + 0.36), (x - 0.44, y + 0.06, 0.14), 0.06)
                          for z in levels)),
        "mattress": join(*(box((0, 0, z + 0.2), (x - 0.08, y - 0.03, 0.19), 0.05)
                           for z in levels)),
        "pillow": join(*(egg((0.44 - x, 0, z + 0.44), (0.25, y * 0.7, 0.17)) for z in levels)),
        "frame": join(both(posts, 0, 1), *beds, *ends, *guards),
        "ladder": tilted(ladder, -9, (at, -y - 0.42, 0)),
    }  # fmt: skip


def coffee_table(draw: Draw) -> Parts:
    """Low: an oblong or a round board on slim legs, a shelf between them."""
    x, y, high, slim = draw(1.0, 1.25), draw(0.6, 0.72), draw(0.6, 0.75), draw(0.065, 0.071)
    if draw.chance(0.3):
        x = draw(0.9, 1.1)
        plate, low, u = x * slim, high * 0.28, x * 0.52
        v = u
        top = tube((0, 0, high - plate), (0, 0, high + plate), x, 0.03)
        shelf = tube((0, 0, low - plate), (0, 0, low + plate), x * 0.7, 0.02)
    else:
        plate, low = x * slim, high * 0.28
        u, v = x - plate - 0.08, y - plate - 0.08
        top = box((0, 0, high), (x, y, plate), 0.02)
        shelf = box((0, 0, low), (u, v, plate), 0.02)
    legs = both(box((u, v, high / 2), (plate, plate, high / 2), 0.02), 0, 1)
    return {"top": top, "legs": legs, "shelf": shelf}


def mirror(draw: Draw) -> Parts:
    """A standing mirror, oval or oblong, between two posts."""
    x, half, y = draw(0.5, 0.62), draw(0.85, 1.05), 0.1
    z = half + draw(0.3, 0.42)
    if draw.chance(0.6):
        rim = cut(
            egg((0, 0, z), (x, 0.6, half)),
            box((0, 2 + y, z), (3, 2, 3)),
            box((0, -2 - y, z), (3, 2, 3)),
        )
        glass = cut(
            egg((0, 0, z), (x - 0.13, 0.6, half - 0.13)),
            box((0, 2, z), (3, 2, 3)),
            box((0, -2 - y - 0.03, z), (3, 2, 3)),
        )
    else:
        rim = box((0, 0, z), (x, y, half), 0.04)
        glass = box((0, -y, z), (x - 0.14, 0.04, half - 0.14))
    post = box((x + 0.08, 0, z / 2 + 0.15), (0.1, 0.09, z / 2 + 0.1), 0.03)
    foot = box((x + 0.08, 0, 0.09), (0.11, 0.45, 0.09), 0.04)
    return {
        "frame": rim,
        "glass": glass,
        "stand": join(both(join(post, foot)), box((0, 0, 0.2), (x + 0.1, 0.09, 0.09))),
    }


def floor_lamp(draw: Draw) -> Parts:
    """A high pole with a shade."""
    high, wide, top, tall = draw(2.1, 2.5), draw(0.5, 0.68), draw(0.3, 0.5), draw(0.5, 0.7)
    if draw.chance(0.4):
        foot = around(3, capsule((0.55, 0, 0.1), (0, 0, high * 0.55), 0.1), -90)
    else:
        foot = tube((0, 0, 0), (0, 0, 0.14), draw(0.42, 0.55), 0.05)
    return {
        "shade": lathe([(wide, high - 0.05), (top, high + tall)], 0.02),
        "pole": tube((0, 0, 0.05), (0, 0, high + 0.1), 0.105),
        "foot": foot,
    }


def fireplace(draw: Draw) -> Parts:
    """An open fire in a wall with a mantel, perhaps a chimney above."""
    x, y, high, arch = draw(0.95, 1.15), draw(0.36, 0.44), draw(1.25, 1.5), draw(0.5, 0.62)
    hole = box((0, -0.2, high * 0.36), (arch, y, high * 0.3))
    if draw.chance(0.5):
        hole = join(hole, tube((0, -0.2 - y, high * 0.6), (0, y - 0.2, high * 0.6), arch))
    body = box((0, 0, high / 2), (x, y, high / 2))
    if draw.chance(0.5):
        body = join(body, box((0, 0.06, high + 0.5), (x * 0.68, y - 0.08, 0.55)))
    logs = [
        tube((-0.4, -0.1 + s, 0.24 + z), (0.4, -0.1 - s, 0.24 + z), 0.11)
        for s, z in ((0.1, 0), (-0.1, 0.1))
    ]
    tall = draw(0.28, 0.36)
    flames = [
        taper((u, -0.05, 0.36), (u * 1.2, -0.05, 0.36 + tall * f), 0.14, 0.04)
        for u, f in ((-0.22, 0.9), (0.0, 1.4), (0.22, 1.0))
    ]
    return {
        "body": cut(body, hole),
        "mantel": box((0, -0.06, high), (x + 0.12, y + 0.12, 0.1), 0.02),
        "fire": join(*flames),
        "logs": join(*logs),
        "hearth": box((0, -0.15, 0.06), (x + 0.1, y + 0.22, 0.09), 0.02),
    }


def piano(draw: Draw) -> Parts:
    """An upright one: a tall case, to the front a shelf with the keys, on two legs."""
    x, desk, high = draw(1.02, 1.12), draw(0.8, 0.9), draw(1.65, 1.85)
    u, y, front = x - 0.17, -0.15, -0.8
    pitch = 2 * u / 7  # of the white keys: an octave
    black = (
        box((k * pitch - u, -0.64, desk + 0.18), (0.07, 0.2, 0.1), 0.01) for k in (1, 2, 4, 5, 6)
    )
    return {
        "body": join(
            box((0, y, high / 2), (x, 0.34, high / 2), 0.03),
            box((0, front, desk - 0.04), (x, 0.36, 0.12), 0.02),
            both(box((x - 0.085, front, desk + 0.06), (0.085, 0.36, 0.2), 0.03)),
        ),
        "keys": box((0, front + 0.02, desk + 0.09), (u + 0.01, 0.32, 0.09), 0.01),
        "black keys": join(*black),
        "legs": both(box((x - 0.13, front - 0.18, desk / 2), (0.12, 0.12, desk / 2), 0.02)),
        "lid": box((0, y - 0.03, high), (x + 0.07, 0.43, 0.09), 0.02),
    }


def ottoman(draw: Draw) -> Parts:
    """A padded seat on short feet, round or square, with a button."""
    x, y, low, high = draw(0.75, 1.0), draw(0.65, 0.75), draw(0.2, 0.32), draw(0.3, 0.42)
    top = low + 2 * high
    if draw.chance(0.5):
        y = x
        base = tube((0, 0, low), (0, 0, top), x, 0.06)
        pad = tube((0, 0, top - 0.12), (0, 0, top + 0.18), x + 0.06, 0.14)
    else:
        base = box((0, 0, low + high), (x, y, high), 0.06)
        pad = box((0, 0, top + 0.03), (x + 0.06, y + 0.06, 0.16), 0.13)
    inset = 0.66 if x == y else 0.8
    return {
        "cushion": pad,
        "base": base,
        "feet": feet(x * inset, y * inset, low + 0.1, 0.13),
        "button": egg((0, 0, top + 0.18), (0.14, 0.14, 0.08)),
    }


def crib(draw: Draw) -> Parts:
    """A baby's bed: solid ends, four thick bars in each long side."""
    x, y, low, top = draw(0.98, 1.15), draw(0.55, 0.65), draw(0.42, 0.52), draw(1.3, 1.45)
    head = top + draw(0.1, 0.3)
    middle, half = (low + top) / 2, (top - low) / 2
    bars = (box((x * k, y, middle), (0.085, 0.085, half)) for k in (-0.6, -0.2, 0.2, 0.6))
    rail = box((0, y, top), (x, 0.1, 0.1), 0.03)
    return {
        "frame": join(
            both(join(*bars, rail), 1),
            both(box((x, 0, (low + head) / 2), (0.09, y, (head - low) / 2), 0.03)),
            both(box((x, y, head / 2 + 0.03), (0.13, 0.13, head / 2 + 0.03), 0.03), 0, 1),
            box((0, 0, low), (x, y, 0.12)),
        ),
        "mattress": box((0, 0, low + 0.2), (x - 0.06, y - 0.05, 0.15), 0.05),
        "pillow": box((x - 0.36, 0, low + 0.38), (0.22, y * 0.62, 0.14), 0.1),
        "blanket": box((-0.26, 0, low + 0.25), (x - 0.38, y - 0.05, 0.17), 0.06),
    }


HOME = {
    "office chair": office_chair,
    "rocking chair": rocking_chair,
    "throne": throne,
    "bunk bed": bunk_bed,
    "coffee table": coffee_table,
    "mirror": mirror,
    "floor lamp": floor_lamp,
    "fireplace": fireplace,
    "piano": piano,
    "ottoman": ottoman,
    "crib": crib,
}
