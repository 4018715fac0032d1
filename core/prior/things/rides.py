"""What one rides for fun, and a parachute."""

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    around,
    both,
    box,
    capsule,
    cut,
    grown,
    join,
    lathe,
    outlined,
    prism,
    ring,
    smooth_curve,
    tilted,
    tube,
    within,
)

Point = tuple[float, float]


def go_kart(draw: Draw) -> Parts:
    """Low, on four thick wheels: a nose, pods at its sides, a seat before the engine."""
    x, y, r = draw(0.76, 1.05), draw(0.9, 1.08), draw(0.28, 0.42)
    rear, wide, back = r * draw(1.0, 1.3), draw(0.13, 0.22), draw(0.4, 0.75)
    z = 0.3
    axles = ((-y, r, wide), (y, rear, wide * 1.35))
    wheels = [tube((x - w, v, q), (x + w, v, q), q, 0.07) for v, q, w in axles]
    hubs = [tube((x - w, v, q), (x + w + 0.04, v, q), q * 0.5, 0.03) for v, q, w in axles]
    nose = [(-y - 0.46, 0.14), (-y - 0.42, 0.34), (-y + 0.1, 0.62), (-y + 0.42, 0.56),
            (-y + 0.42, 0.16)]  # fmt: skip
    pod = [(-y + 0.52, 0.14), (-y + 0.52, 0.4), (y - 0.5, 0.48), (y - 0.5, 0.14)]
    seat = [(-0.12, z), (-0.16, z + 0.24), (0.32, z + 0.22), (0.5, z + back + 0.24),
            (0.68, z + back + 0.22), (0.56, z)]  # fmt: skip
    wheel = tilted(ring((0, 0, 0), 0.24, 0.085), 55, (0, -0.46, 0.86))
    return {
        "body": join(
            outlined(nose, [(x * 0.62, -y + 0.5), (x * 0.62, -y - 0.2), (x * 0.4, -y - 0.5)]),
            both(prism(pod, 0, 0.17, x * 0.74)),
        ),
        "frame": join(
            box((0, 0, 0.23), (x * 0.66, y + 0.12, 0.1), 0.03),
            tube((-x, -y, r), (x, -y, r), 0.1),
            tube((-x, y, rear), (x, y, rear), 0.1),
            box((0, y + 0.3, 0.38), (x * 0.6, 0.11, 0.12), 0.05),
            box((0, y + 0.16, 0.28), (0.3, 0.12, 0.08)),
        ),
        "wheels": both(join(*wheels)),
        "hubs": both(join(*hubs)),
        "seat": join(prism(seat, 0, 0.36), both(prism([*seat[:3], (0.5, z + 0.5), (0.56, z)], 0,
                                                      0.09, 0.36))),
        "engine": join(
            box((0, y - 0.12, z + 0.3), (0.4, 0.22, 0.26), 0.05),
            wheel,
            capsule((0, -0.46, 0.86), (0, -y + 0.3, 0.4), 0.09),
            both(tube((0.24, y - 0.1, z + 0.3), (0.24, y + 0.3, z + 0.36), 0.11, 0.02)),
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


def snowmobile(draw: Draw) -> Parts:
    """Two skis, a hood with a windshield, a long saddle above the track."""
    x, y, hood = draw(0.4, 0.6), draw(1.2, 1.45), draw(0.76, 1.06)
    seat, glass, track = draw(0.76, 0.96), draw(0.24, 0.55), draw(0.22, 0.3)
    out = x + draw(0.1, 0.36)
    front = [(-y + 0.1, 0.36), (-y + 0.16, 0.56), (-0.42, hood), (-0.1, hood - 0.04), (0.1, 0.34)]
    top = [(x, 0.2), (x, -0.6), (x * 0.56, -y), (0.06, -y + 0.06)]
    saddle = [(-0.2, 0.5), (-0.2, seat - 0.06), (0.6, seat - 0.1), (0.76, seat + 0.1),
              (y + 0.06, seat + 0.08), (y - 0.08, 0.54)]  # fmt: skip
    pane = [(-0.74, hood - 0.1), (-0.42, hood + glass), (-0.24, hood + glass), (-0.46, hood - 0.1)]
    loop = prism(
        [(-0.1, 0.0), (y - 0.1, 0.0), (y + 0.1, track), (y - 0.06, 2 * track),
         (-0.1, 2 * track), (-0.3, track)], 0, x * 0.66)  # fmt: skip
    lugs = [box((0, v, 0.05), (x * 0.66 + 0.05, 0.08, 0.09), 0.02) for v in (0.1, 0.45, 0.8)]
    ski = [(-y - 0.1, 0.36), (-y + 0.02, 0.4), (-y + 0.24, 0.2), (-0.2, 0.2), (-0.2, 0.0),
           (-y + 0.16, 0.0)]  # fmt: skip
    return {
        "hood": join(outlined(front, top), box((0, 0.5, 0.52), (x * 0.84, 0.8, 0.1), 0.04)),
        "saddle": prism(saddle, 0, x * 0.6),
        "track": join(loop, *lugs),
        "skis": join(
            both(prism(ski, 0, 0.13, out)),
            both(capsule((out, -y * 0.6, 0.16), (x * 0.5, -y * 0.56, 0.46), 0.1)),
        ),
        "windshield": prism(pane, 0, x * 0.74),
        "handles": join(
            capsule((0, -0.22, hood - 0.1), (0, -0.18, hood + 0.12), 0.13),
            both(capsule((0, -0.18, hood + 0.12), (x + 0.1, -0.06, hood + 0.18), 0.1)),
        ),
    }


def parachute(draw: Draw) -> Parts:
    """A canopy of coloured gores, lines from its rim to a crate with straps."""
    r, low, high = draw(1.15, 1.48), draw(1.75, 2.2), draw(2.75, 3.05)
    half, thick = draw(0.28, 0.48), 0.2
    rise = high - low
    shell = smooth_curve([(r, low), (r * 0.93, low + rise * 0.42), (r * 0.62, low + rise * 0.83),
                          (0.0, high)])  # fmt: skip
    inner = [(max(u - thick, 0), v - (0.3 if k == 0 else thick)) for k, (u, v) in enumerate(shell)]
    dome = cut(lathe(shell), lathe([*inner[:-1], (0.0, high - thick)]))
    wedge = prism([(0.0, 0.0), (3.0, -3 * 0.414), (3.0, 3 * 0.414)], 2, 4)
    top = 2 * half
    line = capsule((half * 0.6, half * 0.6, top - 0.04), (r * 0.62, r * 0.62, low + 0.04), 0.09)
    strap = 0.1
    return {
        "canopy": dome,
        "gores": within(grown(dome, 0.04), around(4, wedge)),
        "lines": both(line, 0, 1),
        "crate": box((0, 0, half), (half, half, half), 0.03),
        "straps": join(
            box((0, 0, half), (strap, half + 0.04, half + 0.04), 0.01),
            box((0, 0, half), (half + 0.04, strap, half + 0.04), 0.01),
        ),
    }


RIDES = {
    "go-kart": go_kart,
    "jet ski": jet_ski,
    "snowmobile": snowmobile,
    "parachute": parachute,
}
