"""What is worn besides clothes: hats, at the neck, at the waist, on the nose."""

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
    moved,
    prism,
    ring,
    smooth_curve,
    tilted,
    tube,
    turned,
    within,
)


def _oval(wide: float, deep: float, low: float, high: float) -> Solid:
    """An upright wall's filling: an oval between two heights."""
    turns = [math.tau * k / 48 for k in range(48)]
    outline = [(wide * math.cos(t), deep * math.sin(t)) for t in turns]
    return prism(outline, 2, (high - low) / 2, (high + low) / 2)


def belt(draw: Draw) -> Parts:
    """Closed, its great buckle to the front; the free end lies over it beside the buckle."""
    wide, deep, half = draw(0.95, 1.05), draw(0.76, 0.86), draw(0.19, 0.22)
    frame, reach = half + 0.14, draw(0.56, 0.66)
    strap = cut(_oval(wide, deep, 0, 2 * half), _oval(wide - 0.15, deep - 0.15, -1, 2))
    end = cut(
        _oval(wide + 0.1, deep + 0.1, 0.02, 2 * half - 0.02), _oval(wide - 0.05, deep - 0.05, -1, 2)
    )
    region = prism(
        [(0, half - 1), (reach, half - 1), (reach + 0.2, half), (reach, half + 1), (0, half + 1)],
        1,
        1,
        -1,
    )
    y = -deep - 0.06
    window = box((0, y, half), (frame - 0.13, 1, frame - 0.15))
    prong = capsule((-frame + 0.06, y - 0.08, half), (frame - 0.08, y - 0.1, half), 0.075)
    holes = [tube((u, -2, half), (u, 0, half), 0.07) for u in (-0.62, -0.42)]
    dots = within(
        cut(_oval(wide + 0.02, deep + 0.02, 0, 2 * half), _oval(wide - 0.17, deep - 0.17, -1, 2)),
        join(*holes),
    )
    keeper = box((reach * 0.8, -deep * 0.9, half), (0.085, 0.2, half + 0.075), 0.02)
    return {
        "strap": join(strap, within(end, region)),
        "buckle": join(cut(box((0, y, half), (frame + 0.04, 0.1, frame), 0.03), window), prong),
        "keeper": keeper,
        "holes": dots,
    }


def scarf(draw: Draw) -> Parts:
    """Wound about a neck that is not there, both ends hang down before it, with fringes."""
    wide, thick, long = draw(0.5, 0.56), draw(0.25, 0.29), draw(1.05, 1.25)
    z, lean = 1.5, draw(7, 11)
    half, y = 0.24, -wide - 0.12
    loops = join(
        tilted(ring((0, 0, 0), wide, thick), 14, (0, 0, z)),
        tilted(ring((0, 0, 0), wide * 0.94, thick * 0.9), -4, (0, 0.02, z + 0.3)),
    )

    def hung(solid: Solid, side: float) -> Solid:
        return moved(turned(solid, 1, side * lean), (-0.2 * side, y - 0.1 * (side > 0), z - 0.1))

    def end(share: float) -> Solid:
        tall = long * share
        return box((0, 0, -tall / 2), (half, 0.1, tall / 2), 0.04)

    def bands(share: float) -> Solid:
        low = -long * share
        return join(*(box((0, 0, low + at), (half + 0.025, 0.125, 0.075)) for at in (0.16, 0.44)))

    def fringe(share: float) -> Solid:
        low = -long * share
        tufts = (tube((u, 0, low - 0.17), (u, 0, low + 0.04), 0.08) for u in (-0.17, 0, 0.17))
        return join(*tufts)

    sides = ((-1, 0.84), (1, 1.0))
    return {
        "wool": join(loops, *(hung(end(share), side) for side, share in sides)),
        "stripes": join(*(hung(bands(share), side) for side, share in sides)),
        "fringes": join(*(hung(fringe(share), side) for side, share in sides)),
        "knot": egg((0, y - 0.14, z - 0.06), (0.3, 0.2, 0.26)),
    }


def wizard_hat(draw: Draw) -> Parts:
    """A tall pointed hat with a wide brim, its side hollow, a star and a buckle in front."""
    wide, high, brim = draw(0.5, 0.6), draw(1.5, 1.8), draw(0.95, 1.1)
    side = smooth_curve([(wide + 0.02, 0.16), (wide * 0.56, high * 0.5), (0.07, high)])
    star = around(5, prism([(0, -0.1), (0.26, 0), (0, 0.1)], 2, 0.09), 90)
    lean = math.degrees(math.atan2(wide * 0.44, high * 0.5))
    return {
        "body": join(lathe(side, 0.02), tube((0, 0, 0), (0, 0, 0.17), brim, 0.05)),
        "ribbon": tube((0, 0, 0.12), (0, 0, 0.34), wide + 0.06, 0.03),
        "stars": moved(turned(star, 0, 90 - lean), (0, -wide * 0.62, high * 0.42)),
        "buckle": box((0, -wide - 0.04, 0.24), (0.15, 0.08, 0.14), 0.02),
    }


def cowboy_hat(draw: Draw) -> Parts:
    """A hat with a creased crown; its brim curls up at the sides."""
    wide, high, brim, curl = draw(0.48, 0.55), draw(0.65, 0.8), draw(1.0, 1.15), draw(0.25, 0.45)
    curve = [
        (-brim, curl + 0.05),
        (-brim * 0.6, 0.05),
        (0, 0),
        (brim * 0.6, 0.05),
        (brim, curl + 0.05),
    ]
    lower = smooth_curve(curve, 4)
    sheet = prism([*lower, *((u, v + 0.17) for u, v in reversed(lower))], 1, 2)
    plate = cut(sheet, cut(box((0, 0, 0), (3, 3, 3)), egg((0, 0, 0.3), (brim, brim * 1.12, 3.0))))
    crown = join(
        egg((0, 0, high * 0.72), (wide * 0.94, wide * 1.18, high * 0.5)),
        lathe([(wide, 0.05), (wide * 0.95, high * 0.7)], 0.03),
    )
    crease = capsule((0, -wide * 1.2, high * 1.2), (0, wide * 1.2, high * 1.38), 0.2)
    return {
        "body": join(plate, cut(crown, crease, both(ball((wide * 1.1, -wide * 0.75, high), 0.25)))),
        "band": egg((0, 0, 0.32), (wide + 0.13, wide * 1.18 + 0.12, 0.24)),
        "buckle": box((wide + 0.09, 0, 0.23), (0.07, 0.13, 0.13), 0.02),
    }


def bow_tie(draw: Draw) -> Parts:
    """A bow tie, upright."""
    x, high, pinch, y = draw(0.95, 1.1), draw(0.45, 0.6), draw(0.16, 0.22), draw(0.15, 0.2)
    wing = [(0, -pinch), (x * 0.8, -high), (x, -high * 0.85), (x * 0.92, 0), (x, high * 0.85)]
    solid = prism([*wing, (x * 0.8, high), (0, pinch)], 1, y)
    knot = draw(0.2, 0.26)
    fold = both(prism([(0.1, -0.06), (x * 0.6, -0.11), (x * 0.6, 0.11), (0.1, 0.06)], 1, y + 0.05))
    parts = {
        "body": both(solid),
        "knot": box((0, 0, 0), (knot, y + 0.12, knot * 1.2), 0.1),
        "folds": fold,
    }
    return {name: moved(part, (0, 0, high)) for name, part in parts.items()}


def medal(draw: Draw) -> Parts:
    """A round medal that hangs from a ribbon."""
    wide, high, y = draw(0.58, 0.72), draw(0.9, 1.15), draw(0.12, 0.15)
    drop, half = wide * 2 + 0.1, draw(0.42, 0.52)
    band = [(-half, drop + high), (-half, drop + 0.3), (-0.16, drop - 0.08), (0.16, drop - 0.08)]
    band += [(half, drop + 0.3), (half, drop + high)]
    stripe = [(-0.15, drop + high), (-0.15, drop), (0.15, drop), (0.15, drop + high)]
    star = around(5, prism([(0, -0.12), (wide * 0.6, 0), (0, 0.12)], 2, y + 0.06), 90)
    return {
        "medal": tube((0, -y, wide), (0, y, wide), wide, 0.03),
        "ribbon": prism(band, 1, 0.1),
        "stripe": prism(stripe, 1, 0.13),
        "star": moved(turned(star, 0, 90), (0, 0, wide)),
        "rim": ring((0, 0, wide), wide - 0.02, y + 0.03, axis=1),
    }


def sunglasses(draw: Draw) -> Parts:
    """Two dark glasses in a thick frame, a bridge between, its arms straight to the back."""
    gap, half, high, long = draw(0.07, 0.11), draw(0.38, 0.44), draw(0.32, 0.4), draw(0.85, 1.0)
    soft, z, round_ = draw(0.1, 0.2), 0.5, draw.chance(0.4)
    x, y = gap + half + 0.05, -long / 2
    if round_:
        rims = tube((x, y - 0.1, z), (x, y + 0.1, z), half + 0.05, 0.04)
        panes = tube((x, y - 0.17, z), (x, y + 0.17, z), half - 0.08, 0.02)
    else:
        rims = box((x, y, z), (half + 0.05, 0.1, high + 0.03), min(soft, 0.09))
        panes = box((x, y, z - 0.01), (half - 0.08, 0.17, high - 0.1), 0.05)
    arm = box((x + half, 0.06, z + high * 0.45), (0.11, long / 2 + 0.1, 0.11), 0.03)
    return {
        "frame": join(both(rims), box((0, y, z + high * 0.4), (gap + 0.12, 0.1, 0.11), 0.03)),
        "glasses": both(panes),
        "arms": both(arm),
    }


def cape(draw: Draw) -> Parts:
    """A cloak as on a bust: open in front, wider below, a collar that stands, a clasp."""
    top, foot, high = draw(0.34, 0.37), draw(0.84, 0.92), draw(1.96, 2.1)
    thick = 0.15
    outside = [(0, 0), (foot, 0), (top + 0.14, high * 0.72), (top, high), (0, high)]
    inside = [(0, -0.1), (foot - thick, -0.1), (top + 0.14 - thick, high * 0.72),
              (top - thick, high + 0.1), (0, high + 0.1)]  # fmt: skip
    gap = prism([(0.0, 0.06), (-0.62 * foot, -2.0), (0.62 * foot, -2.0)], 2, high, high / 2)
    rise = high + draw(0.2, 0.24)
    brim = [(top - 0.02, high - 0.06), (top + 0.16, rise), (top + 0.02, rise), (top - 0.16, high)]
    narrow = prism([(0.0, 0.1), (-0.5, -1.0), (0.5, -1.0)], 2, high, high)
    return {
        "cloth": cut(lathe(outside), lathe(inside), gap),
        "collar": cut(lathe(brim), narrow),
        "clasp": join(
            both(ball((0.26, -0.3, high - 0.02), 0.11)),
            box((0, -0.34, high - 0.02), (0.26, 0.07, 0.07)),
        ),
    }


WORN = {
    "belt": belt,
    "scarf": scarf,
    "wizard hat": wizard_hat,
    "cowboy hat": cowboy_hat,
    "bow tie": bow_tie,
    "medal": medal,
    "sunglasses": sunglasses,
    "cape": cape,
}
