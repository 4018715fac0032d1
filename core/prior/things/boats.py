"""Boats, a raft, a jet ski and a submarine."""

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    around,
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
    outlined,
    prism,
    ring,
    smooth_curve,
    tilted,
    tube,
    turned,
    within,
)
from core.prior.things.shared.ropes import rods
from core.prior.things.shared.vehicle_parts import ship_hull


def boat(draw: Draw) -> Parts:
    """A sailing boat, its bow to the front."""
    wide, long, deep = draw(0.42, 0.5), draw(0.95, 1.1), draw(0.42, 0.5)
    hull = cut(egg((0, 0, 0.5), (wide, long, deep * 1.1)), box((0, 0, 1.5), (2, 2, 1)))
    deck = cut(egg((0, 0, 0.5), (wide - 0.11, long - 0.16, 0.16)), box((0, 0, -1), (2, 2, 1)))
    top, y = draw(2.2, 2.5), -0.12
    sail = [(y + 0.12, 0.78), (long * 0.8, 0.82), (y + 0.12, top)]
    jib = [(y - 0.12, 0.78), (-long * 0.85, 0.72), (y - 0.12, top * 0.82)]
    return {
        "hull": cut(hull, deck),
        "sails": join(prism(sail, 0, 0.08), prism(jib, 0, 0.08)),
        "mast": capsule((0, y, 0.2), (0, y, top + 0.08), 0.1),
    }


def rowboat(draw: Draw) -> Parts:
    """An open hull with a rim and benches, an oar over either side."""
    x, y, deep = draw(0.54, 0.64), draw(1.24, 1.38), draw(0.48, 0.58)
    plan = smooth_curve([(x * 0.74, y), (x, y * 0.36), (x * 0.9, -y * 0.36), (x * 0.5, -y * 0.78),
                         (0.04, -y)])  # fmt: skip
    side = [(y, deep), (y * 0.9, 0.06), (y * 0.6, 0), (-y * 0.5, 0), (-y * 0.84, 0.14),
            (-y - 0.04, deep)]  # fmt: skip
    flare = [(x * 0.66, 0), (x, deep * 0.8), (x, 2)]
    hull = within(outlined(side, plan), prism(mirrored(flare), 1, 3))
    inside = [(max(u - 0.16, 0.02), v * 0.88) for u, v in plan]
    hollow = within(prism(mirrored(inside), 2, 1, 1.17),
                    prism(mirrored([(u - 0.14, v) for u, v in flare]), 1, 3))  # fmt: skip
    over = [(u + 0.035, v * 1.02) for u, v in plan]
    z = deep + 0.14
    inner, outer = (0.24, -0.3, z + 0.1), (1.02, 0.42, z - 0.2)
    blade = turned(turned(box((0, 0, 0), (0.3, 0.15, 0.08), 0.03), 1, 15), 2, 43)
    seats = [box((0, v, deep - 0.14), (2, 0.13, 0.085)) for v in (-y * 0.42, y * 0.1, y * 0.62)]
    return {
        "hull": cut(hull, hollow),
        "rim": cut(prism(mirrored(over), 2, 0.085, deep - 0.02), hollow),
        "benches": within(join(*seats), prism(mirrored([(u - 0.05, v) for u, v in plan]), 2, 2)),
        "floor": within(box((0, 0.1, 0.18), (x * 0.5, y * 0.6, 0.06)), hull),
        "oars": both(capsule(inner, outer, 0.085)),
        "blades": both(moved(blade, (outer[0] + 0.14, outer[1] + 0.13, outer[2] - 0.06))),
    }


def canoe(draw: Draw) -> Parts:
    """A slim open hull, its ends swept up; two seats, a paddle laid across."""
    x, y, high, rise = draw(0.46, 0.52), draw(1.32, 1.44), draw(0.44, 0.5), draw(0.44, 0.54)
    bow = [(0.07, y + 0.12), (x * 0.4, y * 0.8), (x * 0.82, y * 0.42), (x, 0.0)]
    plan = prism(mirrored(smooth_curve([*bow, *((u, -v) for u, v in bow[-2::-1])])), 2, 3)
    chine = smooth_curve([(0.0, 0.0), (x * 0.5, 0.02), (x * 0.9, 0.22), (x + 0.08, high)])
    bilge = prism(mirrored([*chine, (x + 0.08, 3)]), 1, 3)
    sheer = smooth_curve([(0.0, high), (y * 0.45, high + rise * 0.14),
                          (y * 0.78, high + rise * 0.46), (y * 0.98, high + rise)])  # fmt: skip
    stem = smooth_curve([(y, high + rise * 0.4), (y * 0.95, high * 0.6), (y * 0.84, 0.16),
                         (y * 0.62, 0.02), (0.0, 0.0)])  # fmt: skip
    well = within(grown(plan, -0.14), box((0, 0, 1.12), (x, y * 0.7, 1)))
    paddle = [(-0.86, -0.09), (0.5, -0.09), (0.64, -0.2), (1.06, -0.2)]
    paddle = [*paddle, *((u, -v) for u, v in reversed(paddle))]
    return {
        "hull": cut(within(within(plan, bilge), prism(mirrored([*sheer, *stem]), 0, 2)), well),
        "seats": both(box((0, y * 0.4, high - 0.06), (x * 0.66, 0.15, 0.09)), 1),
        "paddle": moved(turned(prism(paddle, 2, 0.09), 2, draw(-36, -28)), (0, 0, high + 0.14)),
    }


def raft(draw: Draw) -> Parts:
    """Logs side by side, lashed with ropes, a square sail and a flag on the mast."""
    r, y, mast = draw(0.165, 0.19), draw(1.0, 1.2), draw(1.85, 2.15)
    wide, sail = draw(0.74, 0.9), draw(0.46, 0.56)
    spots = [(r * (2 * k + 1) * 0.96, y * (1.0, 0.9, 0.98)[k]) for k in range(3)]
    logs = join(*(tube((u, -v, r), (u, v, r), r, 0.03) for u, v in spots))
    cuts = join(*(tube((u, -v - 0.05, r), (u, v + 0.05, r), r * 0.7, 0.02) for u, v in spots))
    slabs = both(box((0, y * 0.62, r), (3, 0.1, 1)), 1)
    middle, half = mast - sail - 0.18, 0.085
    arc = smooth_curve([(0.0, -0.26), (wide * 0.6, -0.2), (wide, -0.04)])
    back = [(u, v + 0.19) for u, v in reversed(arc)]
    cloth = prism(mirrored([*arc, *back]), 2, sail, middle)
    pole = tube((0, 0.12, r), (0, 0.12, mast + 0.34), 0.095, 0.02)
    yards = [tube((-wide - 0.08, 0.06, z), (wide + 0.08, 0.06, z), 0.09, 0.02)
             for z in (middle + sail, middle - sail)]  # fmt: skip
    return {
        "logs": both(logs),
        "ends": both(cuts),
        "ropes": both(within(grown(logs, 0.06), slabs)),
        "mast": join(pole, *yards, tube((0, 0.12, 2 * r - 0.06), (0, 0.12, 2 * r + 0.14), 0.2)),
        "sail": cloth,
        "flag": prism([(0.12, mast + 0.36), (0.66, mast + 0.22), (0.12, mast + 0.04)], 0, half),
    }


def sailboat(draw: Draw) -> Parts:
    """A hull with a pointed bow, a mast with its boom, a mainsail and a jib."""
    long, wide, deep = draw(1.05, 1.2), draw(0.36, 0.42), draw(0.36, 0.42)
    high, foot = draw(1.75, 1.95), deep + 0.26
    mast = -0.14
    plan = smooth_curve(
        [(wide * 0.8, long), (wide, long * 0.3), (wide * 0.86, -long * 0.3), (0.02, -long - 0.14)]
    )
    side = [
        (long, deep),
        (long * 0.9, 0.1),
        (long * 0.6, 0),
        (-long * 0.55, 0),
        (-long * 0.85, 0.12),
        (-long - 0.2, deep),
    ]
    hull = prism(mirrored(plan), 2, deep)
    rim = [(u + 0.025, v) for u, v in plan]
    half = prism(side, 0, 2)
    inner = [(u * 0.82, v * 0.86) for u, v in plan]
    main = smooth_curve(
        [(long * 0.86, foot), (long * 0.56, foot + high * 0.45), (mast + 0.14, foot + high * 0.94)]
    )
    jib = [(mast - 0.12, foot), (mast - 0.1, foot + high * 0.74), (-long * 0.98, foot - 0.04)]
    return {
        "hull": within(hull, half),
        "deck": prism(mirrored(inner), 2, 0.08, deep - 0.03),
        "mast": join(
            tube((0, mast, deep), (0, mast, foot + high), 0.08),
            tube((0, mast, foot - 0.06), (0, long * 0.9, foot - 0.06), 0.08),
        ),
        "sails": join(
            prism([(mast + 0.08, foot), *main, (mast + 0.08, foot + high * 0.94)], 0, 0.08),
            prism(jib, 0, 0.08),
        ),
        "stripe": within(prism(mirrored(rim), 2, 0.08, deep - 0.11), half),
        "flag": prism(
            [(mast, foot + high), (mast + 0.4, foot + high - 0.12), (mast, foot + high - 0.26)],
            0,
            0.08,
        ),
    }


def speedboat(draw: Draw) -> Parts:
    """A low pointed hull with a stripe, a raked windscreen, two seats, a motor at the stern."""
    x, y, deck = draw(0.5, 0.54), draw(1.3, 1.4), draw(0.4, 0.44)
    hull = ship_hull(x, y, deck, 0.1)
    well = box((0, y * 0.42, deck + 0.1), (x * 0.72, y * 0.36, 0.24), 0.06)
    pane = [(-y * 0.1, deck - 0.06), (y * 0.12, deck + 0.3), (y * 0.2, deck + 0.3),
            (y * 0.06, deck - 0.06)]  # fmt: skip
    foot = box((0, y + 0.1, 0.16), (0.09, 0.1, 0.3))
    seat = join(
        box((0, 0, 0), (0.19, 0.17, 0.09), 0.05), box((0, 0.16, 0.18), (0.19, 0.07, 0.24), 0.05)
    )
    seat = moved(seat, (x * 0.36, y * 0.44, deck - 0.06))
    wheel = tilted(ring((0, 0, 0), 0.15, 0.05), 60, (-x * 0.36, y * 0.2, deck + 0.12))
    return {
        "hull": cut(hull, well),
        "stripe": within(grown(hull, 0.04), box((0, 0, deck * 0.56), (2, 3, 0.075))),
        "windscreen": within(prism(pane, 0, x * 0.74), grown(hull, 0.6)),
        "seats": join(both(seat), wheel),
        "motor": join(
            box((0, y + 0.12, deck + 0.16), (0.19, 0.2, 0.22), 0.08), foot,
            egg((0, y + 0.14, -0.1), (0.13, 0.22, 0.13)),
        ),
        "rails": join(
            both(limb([(x * 0.5, -y * 0.2, deck + 0.02), (x * 0.44, -y * 0.52, deck + 0.22),
                       (0.06, -y * 0.86, deck + 0.3)], 0.055, 0.055)),
            tube((0, -y * 0.86, deck), (0, -y * 0.86, deck + 0.3), 0.055),
        ),
    }  # fmt: skip


def jet_ski(draw: Draw) -> Parts:
    """A pointed hull with a bumper round it, a cowl with handles, a saddle."""
    x, y, deck = draw(0.5, 0.72), draw(1.25, 1.5), draw(0.5, 0.64)
    cowl, seat, bar = deck + draw(0.42, 0.7), deck + draw(0.34, 0.5), deck + draw(0.72, 0.95)
    hull = [(y, 0.12), (y, deck), (-y * 0.5, deck + 0.04), (-y, deck + 0.2), (-y * 0.74, 0.22),
            (-y * 0.3, 0.0), (y - 0.2, 0.0)]  # fmt: skip
    plan = smooth_curve([(x * 0.86, y), (x, y * 0.4), (x * 0.94, -y * 0.3), (x * 0.5, -y * 0.8),
                         (0.04, -y - 0.02)])  # fmt: skip
    lift = [(y, deck - 0.06), (y, deck + 0.04), (-y * 0.5, deck + 0.08), (-y, deck + 0.24),
            (-y, deck + 0.12), (-y * 0.5, deck - 0.04)]  # fmt: skip
    hood = [(-y + 0.1, deck + 0.1), (-y + 0.16, deck + 0.32), (-0.34, cowl + 0.12), (-0.12, cowl),
            (0.0, deck)]  # fmt: skip
    top = [(x * 0.62, 0.1), (x * 0.62, -y * 0.4), (x * 0.3, -y * 0.84), (0.04, -y)]
    saddle = [(-0.2, deck), (-0.14, seat - 0.06), (0.5, seat - 0.12), (0.62, seat + 0.04),
              (y - 0.24, seat), (y - 0.14, deck)]  # fmt: skip
    return {
        "hull": outlined(hull, plan),
        "cowl": join(outlined(hood, top), prism([(0, deck - 0.1), (0, seat - 0.24),
                                              (y - 0.1, seat - 0.24), (y - 0.06, deck - 0.1)],
                                             0, x * 0.52)),
        "saddle": prism(saddle, 0, x * 0.42),
        "bumper": within(grown(outlined(lift, plan), 0.05), box((0, 0, 1), (2, y + 0.05, 1))),
        "handles": join(
            both(capsule((0, -0.42, bar), (draw(0.44, 0.52), -0.28, bar + 0.04), 0.1)),
            capsule((0, -0.44, cowl - 0.1), (0, -0.42, bar), 0.14),
        ),
        "stripes": both(prism([(-y * 0.5, deck * 0.42), (-y * 0.4, deck * 0.8),
                               (y - 0.1, deck * 0.7), (y - 0.1, deck * 0.36)], 0, 0.1, x - 0.07)),
    }  # fmt: skip


def submarine(draw: Draw) -> Parts:
    """A round hull, a tower with a periscope, round windows, a screw."""
    r, y, count = draw(0.42, 0.52), draw(1.0, 1.15), 2 + draw.chance(0.6)
    top, tower = r + draw(0.34, 0.44), draw(0.28, 0.36)
    ports = [(k - (count - 1) / 2) * 0.48 - 0.1 for k in range(count)]
    scope = [((0, 0, top - 0.1), (0, 0, top + 0.4)), ((0, 0, top + 0.4), (0, -0.24, top + 0.4))]
    blade = box((0.21, 0, 0), (0.21, 0.12, 0.08))
    screw = turned(join(around(4, blade), tube((0, 0, -0.08), (0, 0, 0.08), 0.15)), 0, 90)
    rudder = [(y * 0.5, 0.2), (y - 0.14, 0.5), (y + 0.06, 0.5), (y - 0.02, 0.18)]
    return {
        "hull": egg((0, 0, 0), (r, y + 0.15, r)),
        "tower": join(
            box((0, 0, top - 0.3), (tower * 0.7, tower, 0.36), 0.14),
        ),
        "windows": both(
            join(*(tube((r * 0.6, v, 0.04), (r + 0.05, v, 0.04), 0.15) for v in ports))
        ),
        "periscope": rods(0.1, *scope),
        "fins": join(
            prism(rudder, 0, 0.08),
            both(prism([(v, u) for u, v in rudder], 2, 0.08)),
        ),
        "screw": moved(screw, (0, y + 0.2, 0)),
    }


BOATS = {
    "boat": boat,
    "rowboat": rowboat,
    "canoe": canoe,
    "raft": raft,
    "sailboat": sailboat,
    "speedboat": speedboat,
    "jet ski": jet_ski,
    "submarine": submarine,
}
