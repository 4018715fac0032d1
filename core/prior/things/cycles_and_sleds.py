"""Cycles, a scooter, a wheelchair, sleds and a parachute."""

import itertools
import math

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
    grown,
    join,
    lathe,
    limb,
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
from core.prior.things.shared.outlines import strip
from core.prior.things.shared.ropes import rods
from core.prior.things.shared.wheels import disc_wheel


def bicycle(draw: Draw) -> Parts:
    """Two wheels, a diamond of tubes, a saddle, a handlebar."""
    y, r, tire, rod = draw(0.88, 0.94), draw(0.46, 0.5), draw(0.09, 0.1), draw(0.08, 0.09)
    saddle = [(-0.09, 0), (0.09, 0), (0.2, 0.34), (0.18, 0.62), (-0.18, 0.62), (-0.2, 0.34)]
    z, seat, bar = r + tire, draw(1.32, 1.42), draw(1.5, 1.62)
    low, post, head = (0, 0.12, z - 0.06), (0, 0.32, seat - 0.16), (0, -y + 0.26, seat - 0.14)
    top, out = (0, -y + 0.2, bar), tire + rod - 0.01
    stays = [((out, y, z), (out, *low[1:])), ((out, y, z), (out, *post[1:]))]
    fork = ((out, -y, z), (out, head[1] - 0.02, head[2]))
    hub = tube((-out - 0.05, 0, 0), (out + 0.05, 0, 0), 0.15)
    spokes = join(*(box((0, 0, 0), half) for half in ((0.07, 0.06, r), (0.07, r, 0.06))))
    wheel = join(ring((0, 0, 0), r, tire, 0), turned(spokes, 0, 45), hub)
    return {
        "frame": join(
            rods(rod, (low, post), (low, head), (post, head)), both(rods(rod, *stays, fork))
        ),
        "wheels": join(moved(wheel, (0, y, z)), moved(wheel, (0, -y, z))),
        "seat": moved(prism(saddle, 2, 0.09), (0, 0.02, seat)),
        "handlebar": join(
            capsule(head, top, rod),
            tube((-0.56, *top[1:]), (0.56, *top[1:]), rod),
            both(tube((0.32, *top[1:]), (0.58, *top[1:]), rod + 0.03)),
        ),
        "pedals": join(
            tube((-0.14, *low[1:]), (0.14, *low[1:]), 0.24),
            box((0.28, low[1], low[2] - 0.33), (0.15, 0.13, 0.08)),
            box((-0.28, low[1], low[2] + 0.33), (0.15, 0.13, 0.08)),
            box((0.16, low[1], low[2] - 0.2), (0.08, 0.08, 0.21)),
            box((-0.16, low[1], low[2] + 0.2), (0.08, 0.08, 0.21)),
        ),
    }


def tricycle(draw: Draw) -> Parts:
    """A child's: a large wheel with pedals under the handlebar, two small ones behind."""
    big, small, x, y = draw(0.38, 0.46), draw(0.24, 0.3), draw(0.4, 0.48), draw(0.6, 0.7)
    seat, bar, rod = draw(0.76, 0.86), draw(1.16, 1.34), draw(0.08, 0.095)
    front, head = -y, (0, -y + 0.16, bar - 0.24)
    disc = tube((-0.12, front, big), (0.12, front, big), big, 0.05)
    wheel = tube((x - 0.1, y, small), (x + 0.1, y, small), small, 0.05)
    fork = [(0.2, front, big), (0.2, front + 0.08, 2 * big + 0.02), (0.0, front + 0.12, bar - 0.3)]
    return {
        "frame": join(
            both(limb(fork, rod, rod)),
            limb([head, (0, -0.1, 0.58), (0, 0.24, seat - 0.24), (0, y, small)], rod, rod),
            capsule((0, 0.24, seat - 0.2), (0, 0.3, seat), rod),
            tube((-x, y, small), (x, y, small), rod),
            box((0, y + 0.04, small + 0.16), (x - 0.16, 0.2, 0.07), 0.03),
        ),
        "wheels": join(disc, both(wheel)),
        "hubs": both(
            join(
                tube((0, front, big), (0.17, front, big), big * 0.6, 0.03),
                tube((x, y, small), (x + 0.15, y, small), small * 0.58, 0.03),
            )
        ),
        "seat": join(
            egg((0, 0.36, seat + 0.04), (0.22, 0.24, 0.12)), egg((0, 0.18, seat), (0.11, 0.24, 0.1))
        ),
        "handlebar": join(
            capsule((head[0], head[1], head[2] - 0.06), (0, front + 0.2, bar), 0.09),
            both(capsule((0, front + 0.2, bar), (0.36, front + 0.29, bar), rod)),
        ),
        "pedals": join(
            both(capsule((0.38, front + 0.3, bar), (0.5, front + 0.44, bar), 0.115)),
            tube((-0.22, front, big), (0.22, front, big), 0.09),
            box((0.3, front, big - 0.2), (0.14, 0.12, 0.08), 0.02),
            box((-0.3, front, big + 0.2), (0.14, 0.12, 0.08), 0.02),
            *(box((s * 0.22, front, big - s * 0.1), (0.06, 0.07, 0.14)) for s in (-1, 1)),
        ),
    }


def motorcycle(draw: Draw) -> Parts:
    """Thick wheels, a tank, a long saddle, a lamp."""
    y, r, wide, tail = draw(0.8, 0.92), draw(0.42, 0.48), draw(0.13, 0.17), draw(0.95, 1.1)
    bar = draw(1.2, 1.4)
    hub = join(
        *(
            cut(disc_wheel(0, s * y, r, r, wide), disc_wheel(0, s * y, r, r * 0.45, 1))
            for s in (-1, 1)
        )
    )
    cores = join(*(disc_wheel(0, s * y, r, r * 0.55, 0.07) for s in (-1, 1)))
    saddle = [(0.0, 0.8), (tail - 0.2, 0.8), (tail, 1.06), (0.3, 0.95), (0.0, 0.96)]
    return {
        "body": join(
            egg((0, -0.2, 0.98), (0.25, 0.42, 0.22)),
            box((0, y + 0.02, 2 * r + 0.03), (0.17, 0.34, 0.08), 0.05),
            box((0, -y, 2 * r + 0.02), (0.17, 0.28, 0.07), 0.05),
        ),
        "wheels": hub,
        "engine": join(
            box((0, 0, 0.52), (0.22, 0.36, 0.28), 0.05),
            rods(0.09, ((0, 0.2, 0.5), (0, y, r)), ((0.2, 0.1, 0.36), (0.26, tail, 0.4))),
            cores,
        ),
        "seat": prism(saddle, 0, 0.2),
        "handlebar": join(
            both(capsule((0.16, -y, r), (0.14, -y + 0.4, bar - 0.12), 0.08)),
            both(capsule((0, -y + 0.4, bar - 0.1), (0.5, -y + 0.55, bar), 0.08)),
            box((0, -0.45, 0.8), (0.14, 0.2, 0.14)),
        ),
        "lamp": ball((0, -y + 0.2, bar - 0.22), 0.18),
    }


def scooter(draw: Draw) -> Parts:
    """A motor scooter: a leg shield, a low floor, a saddle over a round tail."""
    y, r, seat, bar = draw(0.72, 0.82), draw(0.3, 0.35), draw(0.98, 1.1), draw(1.35, 1.55)
    x = draw(0.28, 0.34)
    shield = strip((-y + 0.2, r + 0.05), (-y + 0.48, bar - 0.15), 0.1)
    return {
        "body": join(
            egg((0, y - 0.12, seat - 0.4), (x, 0.55, 0.42)),
            box((0, 0, 0.36), (x * 0.85, y - 0.15, 0.1), 0.04),
            prism(shield, 0, x),
            egg((0, -y, r + 0.22), (0.19, 0.38, 0.22)),
        ),
        "wheels": join(disc_wheel(0, -y, r, r), disc_wheel(0, y, r, r)),
        "seat": box((0, y - 0.24, seat), (x * 0.8, 0.45, 0.12), 0.1),
        "handlebar": join(
            tube((-0.48, -y + 0.5, bar), (0.48, -y + 0.5, bar), 0.09, 0.03),
            capsule((0, -y + 0.5, bar), (0, -y + 0.42, bar - 0.3), 0.12),
        ),
        "lamp": ball((0, -y + 0.36, bar - 0.04), 0.17),
    }


def skateboard(draw: Draw) -> Parts:
    """A board with raised ends on four small wheels."""
    x, y, bend, r = draw(0.34, 0.4), draw(0.66, 0.78), draw(0.18, 0.34), draw(0.17, 0.21)
    z = 2 * r + 0.16
    end = moved(tube((0, 0, -0.1), (0, 0, 0.1), x, 0.04), (0, 0.4, 0))
    tip = turned(join(end, box((0, 0.16, 0), (x, 0.26, 0.1), 0.04)), 0, math.degrees(bend))
    return {
        "board": join(
            box((0, 0, z), (x, y + 0.05, 0.1), 0.04),
            both(moved(tip, (0, y, z)), 1),
        ),
        "wheels": both(tube((x - 0.2, y * 0.7, r), (x + 0.04, y * 0.7, r), r, 0.05), 0, 1),
        "trucks": both(
            join(
                tube((-x + 0.1, y * 0.7, r), (x - 0.1, y * 0.7, r), 0.09),
                box((0, y * 0.7, r + 0.08), (0.14, 0.14, 0.16)),
            ),
            1,
        ),
    }


def wheelchair(draw: Draw) -> Parts:
    """Two large wheels and two small ones, a seat with a back, handles and footrests."""
    x, r, small = draw(0.4, 0.46), draw(0.56, 0.64), draw(0.18, 0.21)
    seat, back, arm = draw(0.78, 0.86), draw(0.62, 0.72), draw(0.3, 0.36)
    y, tire, side = 0.24, 0.075, x + 0.16
    front, top = -0.62, seat + back
    spoke = box((0, 0, 0), (0.05, r, 0.05))
    spokes = join(*(tilted(spoke, 45 * k, (side, y, r)) for k in range(4)))
    return {
        "wheels": both(
            join(
                ring((side, y, r), r - tire, tire + 0.01, 0),
                tube((x - 0.12, front, small), (x + 0.06, front, small), small),
            )
        ),
        "spokes": both(join(spokes, tube((x - 0.05, y, r), (side + 0.1, y, r), 0.12))),
        "seat": join(
            box((0, -0.08, seat), (x - 0.04, 0.42, 0.09), 0.03),
            box((0, 0.34, seat + back / 2), (x - 0.04, 0.085, back / 2 + 0.04), 0.03),
        ),
        "frame": both(
            join(
                box((x - 0.04, 0.34, seat + back / 2 - 0.2), (0.065, 0.065, back / 2 + 0.36)),
                box((x - 0.04, -0.1, seat - 0.12), (0.065, 0.5, 0.065)),
                box((x - 0.04, -0.54, (seat + small) / 2), (0.065, 0.065, (seat - small) / 2)),
                prism(strip((-0.54, seat - 0.12), (-0.86, 0.2), 0.065), 0, 0.065, x - 0.1),
                box((x - 0.04, -0.32, seat + arm / 2), (0.06, 0.06, arm / 2)),
            )
        ),
        "armrests": both(
            join(
                box((x - 0.02, -0.06, seat + arm), (0.09, 0.4, 0.065), 0.02),
                box((x - 0.04, 0.46, top), (0.07, 0.2, 0.07), 0.02),
            )
        ),
        "footrests": both(box((x / 2 + 0.02, -0.92, 0.16), (x / 2 - 0.06, 0.2, 0.06))),
    }


def sled(draw: Draw) -> Parts:
    """Slats upon two runners that curl up in front."""
    x, y, seat, count = draw(0.42, 0.52), draw(1.0, 1.2), draw(0.48, 0.58), 3
    curl = draw(0.3, 0.4)
    bend = [
        (-y + curl * (1 - math.sin(a)), 0.1 + curl * (1 - math.cos(a)))
        for a in (0, 0.5, 1, 1.6, 2.2, 2.7)
    ]
    path = [(y, 0.1), *bend]
    runner = [((x, *a), (x, *b)) for a, b in itertools.pairwise(path)]
    posts = [((x, v, 0.1), (x, v, seat)) for v in (-y * 0.45, y * 0.6)]
    width = (x + 0.12) / count
    slats = (
        box(((2 * k - count + 1) * width, 0.1, seat), (width - 0.04, y - 0.05, 0.09), 0.03)
        for k in range(count)
    )
    bars = (box((0, v, seat - 0.1), (x + 0.06, 0.11, 0.08)) for v in (-y * 0.45, y * 0.6))
    return {"seat": join(*slats, *bars), "runners": both(rods(0.1, *runner, *posts))}


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


CYCLES_AND_SLEDS = {
    "bicycle": bicycle,
    "tricycle": tricycle,
    "motorcycle": motorcycle,
    "scooter": scooter,
    "skateboard": skateboard,
    "wheelchair": wheelchair,
    "sled": sled,
    "snowmobile": snowmobile,
    "parachute": parachute,
}
