"""Chairs, sofas and other seats."""

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
    grown,
    join,
    limb,
    mirrored,
    moved,
    prism,
    ring,
    taper,
    tilted,
    tube,
    turned,
)
from core.prior.things.shared.furniture_parts import corner_legs, feet


def chair(draw: Draw) -> Parts:
    """Slim legs with bars between them, and a back of two boards, of a slat, or of one panel."""
    x, y, thick = draw(0.5, 0.57), draw(0.48, 0.54), draw(0.075, 0.09)
    seat, plate = draw(0.78, 0.92), draw(0.07, 0.085)
    top, a, b = seat + draw(0.85, 1.05), x - thick, y - thick
    high = (top - seat) / 2
    posts = [box((side * a, b, seat + high), (thick, thick, high), 0.015) for side in (-1, 1)]
    rail = box((0, b, top - 0.13), (a, 0.075, 0.13), 0.02)
    # Four sorts in all, as a noun has kinds: what shares one is drawn as the mean of both.
    arms = draw.has("armrests", 0.12)
    style = 0 if arms else draw.which(3)
    # Gaps narrower than a fifth of the seat would be drawn closed.
    boards = [box((0, b, seat + high * 0.86), (a, 0.07, 0.1), 0.015)]
    slats = [box((0, b, seat + high), (0.15, 0.07, high * 0.9), 0.015)]
    panel = [box((0, b, seat + high * 1.15), (a, 0.07, high * 0.75), 0.015)]
    bars = [box((side * a, 0, seat * 0.4), (0.06, b, 0.06), 0.01) for side in (-1, 1)]
    parts = {
        "seat": box((0, 0, seat), (x, y, plate), 0.03),
        "back": join(*posts, rail, *(boards, slats, panel)[style]),
        "legs": join(corner_legs(x, y, seat, thick, False), *bars),
    }
    if not arms:
        return parts
    rest = seat + draw(0.36, 0.44)
    arm = join(
        box((a, 0, rest), (0.075, y, 0.06), 0.02),
        box((a, thick - y, (seat + rest) / 2), (0.065, 0.065, (rest - seat) / 2), 0.01),
    )
    return parts | {"arms": both(arm)}


def armchair(draw: Draw) -> Parts:
    """A cushion between arms and a back, on four short legs."""
    x, y, seat = draw(0.8, 1.0), draw(0.7, 0.8), draw(0.6, 0.75)
    arm, arm_top = draw(0.17, 0.24), seat + draw(0.28, 0.4)
    back, back_top = draw(0.17, 0.24), seat + draw(0.75, 0.95)
    soft, low, thick = draw(0.08, 0.15), draw(0.24, 0.32), 0.1

    def block(u: float, v: float, half: float, deep: float, top: float) -> Solid:
        return box((u, v, (low + top) / 2), (half, deep, (top - low) / 2), soft)

    leg = box((x - 0.14, y - 0.14, low / 2 + 0.05), (thick, thick, low / 2 + 0.05))
    return {
        "cushion": block(0, 0, x - arm, y, seat),
        "back": block(0, y - back, x - 0.02, back, back_top),
        "arms": both(block(x - arm, 0, arm, y, arm_top)),
        "legs": both(leg, 0, 1),
    }


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


def gaming_chair(draw: Draw) -> Parts:
    """A racing seat: a high winged back, its sides of a second colour, a pillow at the head, arms,
    a star of five wheels."""
    high, x = draw(0.86, 0.92), draw(0.4, 0.43)
    lean, at = -9, (0.0, 0.42, high + 0.04)
    half = [(x, 0), (x + 0.08, 0.5), (x + 0.2, 0.86), (x + 0.2, 1.1), (x, 1.28), (x, 1.62),
            (x - 0.14, 1.76)]  # fmt: skip
    wing = [(x + 0.04, -0.02, 0.1), (x + 0.1, -0.06, 0.5), (x + 0.22, -0.1, 0.9),
            (x + 0.16, -0.06, 1.16)]  # fmt: skip
    top = limb([(x - 0.02, -0.04, 1.34), (x - 0.02, -0.04, 1.6)], 0.12, 0.12)
    post = join(tube((0, 0, 0.26), (0, 0, high), 0.13), tube((0, 0, 0.4), (0, 0, 0.62), 0.19, 0.04))
    star = around(5, taper((0, 0, 0.34), (0.66, 0, 0.26), 0.13, 0.1), -90)
    reach = x + 0.32
    rest = join(
        box((reach, -0.02, high + 0.44), (0.12, 0.34, 0.08), 0.06),
        capsule((reach, 0.04, high), (reach, 0.04, high + 0.4), 0.09),
        capsule((x - 0.1, 0.04, high - 0.08), (reach, 0.04, high - 0.02), 0.09),
    )
    return {
        "seat": join(
            box((0, -0.06, high), (x, 0.54, 0.17), 0.1),
            tilted(grown(prism(mirrored(half), 1, 0.07), 0.05), lean, at),
        ),
        "stripes": both(
            join(tilted(join(limb(wing, 0.13, 0.13), top), lean, at),
                 box((x + 0.02, -0.08, high + 0.04), (0.12, 0.54, 0.19), 0.11))
        ),
        "pillows": tilted(
            join(box((0, -0.16, 1.42), (x - 0.14, 0.13, 0.17), 0.1),
                 box((0, -0.16, 0.4), (x - 0.1, 0.13, 0.18), 0.1)), lean, at
        ),
        "arms": both(rest),
        "base": join(post, star),
        "wheels": around(5, ball((0.7, 0, 0.15), 0.16), -90),
    }  # fmt: skip


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


def beanbag(draw: Draw) -> Parts:
    """A soft bag with a hollow to sit in."""
    x, high = draw(0.85, 1.0), draw(0.5, 0.6)
    top = draw(0.95, 1.25)
    bag = blend(
        0.35,
        egg((0, 0, high * 0.85), (x, x, high)),
        egg((0, 0.3, top * 0.75), (x * 0.6, 0.42, top * 0.5)),
    )
    return {
        "body": cut(bag, box((0, 0, -0.95), (3, 3, 1))),
        "loop": ring((0, 0.34, top * 1.2), 0.15, 0.085, axis=1),
    }


SEATS = {
    "chair": chair,
    "armchair": armchair,
    "office chair": office_chair,
    "rocking chair": rocking_chair,
    "gaming chair": gaming_chair,
    "throne": throne,
    "sofa": sofa,
    "stool": stool,
    "bench": bench,
    "ottoman": ottoman,
    "beanbag": beanbag,
}
