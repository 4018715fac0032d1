"""What is fast, what carries people, what floats, and a pump where they stop."""

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
from core.prior.things.haulage import pane, wheels

Point = tuple[float, float]


def race_car(draw: Draw) -> Parts:
    """A formula car: open wheels, a pointed nose between wings, a helmet in the cockpit."""
    x, y, front, back = draw(0.68, 0.78), draw(1.24, 1.36), draw(0.32, 0.37), draw(0.36, 0.42)
    pod, rear, high = draw(0.46, 0.56), draw(0.84, 0.92), draw(0.92, 1.06)
    axles = ((-y * 0.5, front), (rear, back))
    nose = [(-y - 0.06, 0.2), (-y - 0.06, 0.36), (-0.5, 0.66), (0.2, 0.66), (0.2, 0.16)]
    tub = [(-0.62, 0.14), (-0.6, 0.4), (-0.3, 0.56), (0.6, 0.54), (1.24, 0.44), (1.24, 0.16)]
    pods = [(0.24, 1.24), (pod, 0.7), (pod + 0.02, -0.1), (pod * 0.8, -0.4), (0.26, -0.62)]
    cover = [(0.14, 0.4), (0.14, 1.0), (0.24, 1.1), (0.46, 1.06), (1.2, 0.6), (1.2, 0.4)]
    ends = [(x * 0.98, -y + 0.02, 0.3, 0.2, 0.2), (x * 0.86, y - 0.18, high - 0.14, 0.26, 0.28)]
    tyres, hubs = wheels(x, axles, draw(0.17, 0.22))
    return {
        "body": join(
            outlined(nose, [(0.28, 0.2), (0.28, -0.4), (0.13, -y), (0.1, -y - 0.06)]),
            outlined(tub, pods),
            prism(cover, 0, 0.14),
        ),
        "wings": join(
            box((0, -y + 0.02, 0.18), (x, 0.17, 0.09), 0.02),
            box((0, y - 0.18, high), (x * 0.86, 0.22, 0.09), 0.02),
            box((0, y - 0.2, high - 0.3), (0.1, 0.14, 0.3)),
            box((0, y - 0.34, 0.34), (0.2, 0.24, 0.1)),
            *(both(box((u, v, w), (0.09, a, b), 0.02)) for u, v, w, a, b in ends),
        ),
        "wheels": tyres,
        "hubs": join(hubs, *(tube((-x, v, r), (x, v, r), 0.09) for v, r in axles)),
        "cockpit": box((0, -0.16, 0.64), (0.2, 0.32, 0.1), 0.06),
        "helmet": ball((0, -0.08, 0.84), draw(0.2, 0.23)),
    }


def sports_car(draw: Draw) -> Parts:
    """Low, broad and like a wedge of plane faces, a flat cabin, a wing over the tail."""
    x, y, wheel = draw(0.68, 0.74), draw(1.3, 1.42), draw(0.29, 0.33)
    belt, roof, axles = draw(0.64, 0.7), draw(0.96, 1.04), (-y * 0.6, y * 0.6)
    front, tail, wing = -y * draw(0.3, 0.38), belt + draw(0.02, 0.08), draw(0.96, 1.06)
    side = x * 0.74  # the cabin's half width, and where arches end
    hull = [(-y, 0.16), (-y, 0.34), (-y * 0.58, 2 * wheel), (front, belt), (y * 0.5, tail)]
    hull += [(y, tail), (y, tail - 0.16), (y - 0.1, 0.16)]
    back, first, last = y * 0.66, front + 0.5, front + 0.9
    roofline = [(front, belt - 0.1), (first, roof), (last, roof), (back, belt - 0.1)]
    arches = (tube((side, v, wheel), (2, v, wheel), wheel + 0.07) for v in axles)
    low, high = belt + 0.05, roof - 0.1
    light = [(front + 0.3, low), (first + 0.02, high), (last, high), (back - 0.46, low)]
    panes = (pane((a, belt - 0.1), (b, roof), s, side - 0.1)
             for a, b, s in ((front, first, -1), (back, last, 1)))  # fmt: skip
    tyres, hubs = wheels(x - 0.1, [(v, wheel) for v in axles], 0.13)
    lamp = turned(box((0, 0, 0), (0.13, 0.16, 0.07)), 0, 27)
    foot = box((x * 0.56, y - 0.18, (tail + wing) / 2), (0.09, 0.12, (wing - tail) / 2 + 0.04))
    return {
        "body": join(cut(prism(hull, 0, x), both(join(*arches))), prism(roofline, 0, side)),
        "windows": join(*panes, both(prism(light, 0, 0.06, side))),
        "wheels": tyres,
        "hubs": hubs,
        "lamps": both(moved(lamp, (x * 0.64, -y + 0.24, 0.45))),
        "spoiler": join(
            box((0, y - 0.16, wing), (x * 0.94, 0.19, 0.07)),
            both(foot),
            box((0, -y, 0.2), (x * 0.8, 0.14, 0.08)),
        ),
    }


def fighter_jet(draw: Draw) -> Parts:
    """A turned fuselage with a pointed nose, delta wings, twin tails that lean out, two nozzles, a
    canopy, and missiles at the ends of the wings."""
    r, nose, tail = draw(0.24, 0.27), draw(1.4, 1.55), draw(1.1, 1.2)
    span, sweep, up = draw(1.05, 1.2), draw(0.4, 0.52), draw(0.62, 0.74)
    x = 0.24
    wing = [(0.1, -0.75), (span, sweep), (span, sweep + 0.36), (0.1, 0.8)]
    rear = [(0.2, tail - 0.2), (0.74, tail + 0.08), (0.74, tail + 0.34), (0.2, tail + 0.2)]
    fin = [(-0.46, 0.0), (0.02, up), (0.3, up), (0.24, 0.0)]
    hull = [(r * 0.9, -tail), (r, 0.3), (r * 0.86, 0.7), (r * 0.52, nose - 0.24), (0.03, nose)]
    at = sweep + 0.2
    missile = join(
        capsule((span, at - 0.52, 0), (span, at + 0.3, 0), 0.115),
        box((span, at + 0.3, 0), (0.24, 0.12, 0.07)),
        box((span, at + 0.3, 0), (0.07, 0.12, 0.24)),
    )
    return {
        # Its axis, upright, to lie along y, the nose to the front.
        "body": join(
            turned(lathe(smooth_curve(hull), 0.02), 0, 90),
            both(box((x, tail / 2 - 0.2, -0.03), (0.2, tail / 2 + 0.24, 0.2), 0.06)),
        ),
        "wings": prism(mirrored(wing), 2, 0.09),
        "canopy": egg((0, -0.56, r * 0.8), (0.19, 0.46, 0.25)),
        "tails": join(
            both(moved(turned(prism(fin, 0, 0.085), 1, 16), (x + 0.08, tail - 0.24, 0.1))),
            both(prism(rear, 2, 0.085)),
        ),
        "nozzles": both(tube((x, tail - 0.2, 0), (x, tail + 0.26, 0), 0.17, 0.02)),
        "missiles": both(missile),
    }


def golf_cart(draw: Draw) -> Parts:
    """A low body with a bench under a roof on posts, golf bags behind."""
    x, y, r = draw(0.5, 0.58), draw(0.9, 1.02), draw(0.24, 0.29)
    top, nose, seat = draw(1.66, 1.82), draw(0.76, 0.86), draw(0.6, 0.68)
    side = [(-y, 0.22), (-y - 0.02, 0.5), (-y + 0.2, nose), (-y + 0.42, nose + 0.04),
            (-y + 0.6, 0.42), (-0.06, 0.42), (0.0, seat - 0.06), (y - 0.1, seat + 0.06),
            (y, seat - 0.1), (y, 0.24)]  # fmt: skip
    posts = [((x - 0.1, -y + 0.34, nose - 0.1), (x - 0.14, -y + 0.66, top)),
             ((x - 0.1, 0.56, seat), (x - 0.14, 0.5, top))]  # fmt: skip
    tyres, hubs = wheels(x - 0.06, [(-y * 0.62, r), (y * 0.62, r)], 0.13)
    wheel = tilted(ring((0, 0, 0), 0.17, 0.07), 50, (-x * 0.45, -y + 0.66, nose + 0.2))
    u, back, rim = x * 0.48, y + 0.04, seat + 0.42
    bag = tube((u, back - 0.06, 0.44), (u, back + 0.04, rim), 0.16, 0.04)
    clubs = [
        limb([(u + d, back, rim - 0.1), (u + d, back + 0.06, rim + up)], 0.07, 0.07)
        for d, up in ((-0.08, 0.3), (0.09, 0.18))
    ]
    heads = [egg((u - 0.08, back, rim + 0.32), (0.09, 0.15, 0.1)),
             egg((u + 0.09, back, rim + 0.2), (0.09, 0.15, 0.1))]  # fmt: skip
    return {
        "body": cut(
            grown(prism(side, 0, x - 0.05), 0.03),
            both(join(*(tube((x - 0.2, s * y * 0.62, r), (2, s * y * 0.62, r), r + 0.06)
                        for s in (-1, 1)))),
        ),
        "roof": box((0, 0.1, top), (x + 0.02, y * 0.76, 0.1), 0.06),
        "seat": join(
            box((0, 0.24, seat + 0.08), (x - 0.08, 0.26, 0.11), 0.05),
            box((0, 0.5, seat + 0.34), (x - 0.08, 0.1, 0.26), 0.05),
        ),
        "posts": join(
            both(join(*(capsule(a, b, 0.075) for a, b in posts))),
            hubs,
            wheel,
            both(join(*clubs, *heads)),
            capsule((-x * 0.45, -y + 0.68, nose + 0.2), (-x * 0.45, -y + 0.3, nose), 0.075),
        ),
        "wheels": tyres,
        "bags": both(join(bag, tube((u, back, rim - 0.1), (u, back + 0.02, rim), 0.19, 0.03))),
    }  # fmt: skip


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


def double_decker_bus(draw: Draw) -> Parts:
    """Two rows of windows one above the other, round corners, a sign over the windscreen."""
    x, y, top, wheel = draw(0.46, 0.54), draw(1.16, 1.34), draw(1.6, 1.8), draw(0.24, 0.29)
    low, high, half = top * 0.46, top * 0.81, top * 0.1
    row = [box((x, y * s, z), (0.06, y * 0.16, half), 0.03)
           for s in (-0.68, -0.23, 0.23, 0.68) for z in (low, high)]  # fmt: skip
    axles = (-y * 0.56, y * 0.56)
    arches = join(*(tube((x - 0.2, v, wheel), (2, v, wheel), wheel + 0.05) for v in axles))
    tyres, hubs = wheels(x - 0.1, [(v, wheel) for v in axles], 0.13)
    z = (low + high) / 2
    ends = [box((0, 0, v), (x * 0.76, y + 0.06, half), 0.03) for v in (low + 0.01, high)]
    return {
        "body": cut(box((0, 0, (top + 0.16) / 2), (x, y, (top - 0.16) / 2), 0.12), both(arches)),
        "windows": join(both(join(*row)), *ends),
        "wheels": tyres,
        "hubs": hubs,
        "stripe": join(
            both(box((x, 0, z), (0.05, y - 0.1, 0.075), 0.02)),
            box((0, -y, z), (x * 0.62, 0.08, 0.11), 0.02),
        ),
        "lamps": join(
            both(tube((x * 0.62, -y - 0.06, 0.4), (x * 0.62, -y + 0.2, 0.4), 0.11, 0.03)),
            box((0, -y, 0.4), (x * 0.3, 0.05, 0.11), 0.03),
        ),
    }


def cargo_ship(draw: Draw) -> Parts:
    """A hull with a high bow, stacks of containers of two colours, a bridge at the stern."""
    x, y, deck = draw(0.4, 0.48), draw(1.3, 1.44), draw(0.46, 0.54)
    plan = smooth_curve([(x * 0.88, y), (x, y * 0.6), (x, -y * 0.5), (x * 0.66, -y * 0.82),
                         (0.03, -y)])  # fmt: skip
    side = [(y, deck), (y * 0.97, 0), (-y * 0.86, 0), (-y - 0.08, deck + 0.26),
            (-y * 0.78, deck + 0.2), (-y * 0.7, deck)]  # fmt: skip
    wide = [(u * 1.02 + 0.01, v * 1.02) for u, v in plan]
    hull, rear = outlined(side, wide), y - 0.34
    below = within(grown(hull, 0.04), box((0, 0, 0.06), (2, 2, 0.12)))
    high, piles = draw.which(2), {0: [], 1: []}
    first, step, tall = -y * 0.56, (rear - 0.22 + y * 0.56) / 4, draw(0.24, 0.29)
    for k in range(4):
        for side, u in enumerate((-x * 0.46, x * 0.46)):
            for level in range((1, 3, 2, 3)[k] - (high and side and k > 1)):
                at = (u, first + (k + 0.5) * step, deck + (level + 0.5) * tall - 0.02)
                crate = box(at, (x * 0.46, step * 0.49, tall / 2), 0.03)
                piles[(k + side + level) % 2].append(crate)
    top, bar = deck + draw(0.9, 1.1), box((0, (rear + first) / 2, deck), (x * 0.8, 0.9, 0.05))
    return {
        "hull": join(hull, bar),
        "keel": below,
        "containers": join(*piles[0]),
        "boxes": join(*piles[1]),
        "bridge": join(
            box((0, rear + 0.06, (deck + top) / 2), (x * 0.8, 0.18, (top - deck) / 2), 0.03),
            box((0, rear + 0.03, top - 0.02), (x * 1.06, 0.24, 0.13), 0.03),
            tube((0, rear + 0.06, top), (0, rear + 0.06, top + 0.32), 0.1, 0.02),
        ),
        "windows": join(
            box((0, rear + 0.03, top), (x * 0.92, 0.3, 0.075), 0.02),
            box((0, rear + 0.06, (deck + top) / 2 + 0.02), (x * 0.6, 0.24, 0.085), 0.02),
        ),
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


def gas_pump(draw: Draw) -> Parts:
    """An old one: a rounded cabinet with a dial, a globe on top, a hose with its nozzle."""
    x, d, top = draw(0.38, 0.46), draw(0.26, 0.34), draw(1.66, 1.86)
    globe, edge, neck = draw(0.3, 0.36), 0.06, top + 0.14
    outline = [(x, 0.2), (x, top * 0.66), *smooth_curve([(x * 0.94, top * 0.76),
               (x * 0.74, top * 0.92), (x * 0.4, top), (0.0, top)])]  # fmt: skip
    z, front = top * 0.7, -d - 0.02
    hose = [(x - 0.06, 0, 0.74), (x + 0.24, -0.02, 0.7), (x + 0.42, -0.04, 0.44),
            (x + 0.5, -0.04, 0.7), (x + 0.4, -0.04, 1.1)]  # fmt: skip
    ball_z = neck + globe * 0.9
    return {
        "body": grown(prism(mirrored([(u - edge, v) for u, v in outline]), 1, d - edge), edge),
        "globe": tube((0, -0.17, ball_z), (0, 0.17, ball_z), globe, 0.08),
        "face": join(
            tube((0, front - 0.05, z), (0, d, z), x * 0.6, 0.03),
            box((0, front, top * 0.33), (x * 0.62, 0.07, top * 0.13), 0.03),
        ),
        "trim": join(
            box((0, 0, 0.1), (x + 0.12, d + 0.1, 0.12), 0.04),
            tube((0, 0, top - 0.05), (0, 0, neck + 0.08), 0.16, 0.03),
            tube((0, -0.13, ball_z), (0, 0.13, ball_z), globe + 0.05, 0.02),
            moved(turned(box((0, 0, 0.07), (0.06, 0.06, 0.14)), 1, 40), (0, front - 0.06, z)),
            tube((0, front - 0.1, z), (0, d, z), 0.08),
        ),
        "hose": limb(hose, 0.085, 0.085),
        "nozzle": join(
            box((x + 0.34, -0.04, 1.2), (0.13, 0.11, 0.2), 0.05),
            capsule((x + 0.32, -0.04, 1.32), (x + 0.06, -0.04, 1.44), 0.09),
            box((x, -0.04, 1.3), (0.12, 0.13, 0.11), 0.03),
        ),
    }


SPEED = {
    "race car": race_car,
    "sports car": sports_car,
    "fighter jet": fighter_jet,
    "golf cart": golf_cart,
    "tricycle": tricycle,
    "double decker bus": double_decker_bus,
    "cargo ship": cargo_ship,
    "rowboat": rowboat,
    "raft": raft,
    "gas pump": gas_pump,
}
