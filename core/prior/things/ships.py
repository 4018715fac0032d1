"""Ships, old and new, and a yacht."""

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    ball,
    both,
    box,
    cut,
    grown,
    join,
    lathe,
    limb,
    mirrored,
    moved,
    outlined,
    prism,
    smooth_curve,
    taper,
    tube,
    turned,
    within,
)
from core.prior.things.shared.fitted import fitted
from core.prior.things.shared.vehicle_parts import ship_hull


def yacht(draw: Draw) -> Parts:
    """A white hull with a sharp bow, two raked decks with dark bands of windows, a mast arch."""
    x, y, deck = draw(0.46, 0.5), draw(1.36, 1.42), draw(0.44, 0.48)
    low, high = deck + draw(0.36, 0.4), deck + draw(0.72, 0.78)
    hull = ship_hull(x, y, deck, 0.16)
    cabin = [(-y * 0.56, deck - 0.1), (-y * 0.56, deck + 0.06), (-y * 0.28, low), (y * 0.6, low),
             (y * 0.54, deck - 0.1)]  # fmt: skip
    upper = [(-y * 0.24, low - 0.1), (-0.02, high), (y * 0.5, high), (y * 0.42, low - 0.1)]
    brow = [(-0.1, high - 0.05), (-0.06, high + 0.07), (y * 0.6, high + 0.07),
            (y * 0.6, high - 0.05)]  # fmt: skip
    arch = [(y * 0.22, high), (y * 0.4, high + 0.36), (y * 0.54, high + 0.36), (y * 0.42, high)]
    first = [(-y * 0.52, deck + 0.16), (-y * 0.34, low - 0.09), (y * 0.44, low - 0.09),
             (y * 0.36, deck + 0.13)]  # fmt: skip
    second = [(-y * 0.2, low + 0.07), (-0.08, high - 0.07), (y * 0.4, high - 0.07),
              (y * 0.34, low + 0.07)]  # fmt: skip
    band = within(grown(hull, 0.045), box((0, 0, 0.1), (2, 3, 0.11)))
    return {
        "hull": hull,
        "keel": band,
        "deck": join(
            box((0, y * 0.76, deck), (x * 0.76, y * 0.19, 0.06), 0.02),
            box((0, y * 0.99, 0.17), (x * 0.66, 0.16, 0.08), 0.02),
        ),
        "cabin": join(
            prism(cabin, 0, x * 0.76), prism(upper, 0, x * 0.62), prism(brow, 0, x * 0.68),
            prism([(-y * 0.3, low - 0.05), (-y * 0.28, low + 0.05), (y * 0.72, low + 0.05),
                   (y * 0.72, low - 0.05)], 0, x * 0.82),
        ),
        "windows": join(prism(first, 0, x * 0.76 + 0.05), prism(second, 0, x * 0.62 + 0.05)),
        "mast": join(
            both(prism(arch, 0, 0.07, x * 0.48)),
            box((0, y * 0.47, high + 0.35), (x * 0.62, 0.12, 0.065), 0.03),
            ball((0, y * 0.47, high + 0.5), 0.14),
        ),
    }  # fmt: skip


def pirate_ship(draw: Draw) -> Parts:
    """A hull with a high stern and a bow, two masts with square sails, a black flag."""
    x, y, deck, tall = draw(0.4, 0.48), draw(1.05, 1.15), draw(0.52, 0.6), draw(2.3, 2.5)
    plan = [(-x, y), (x, y), (x, -y * 0.5), (0, -y), (-x, -y * 0.5)]
    stern = box((0, y * 0.72, deck + 0.16), (x, y * 0.28, 0.22))
    bow = prism([(x * 0.92, -y * 0.52), (0, -y), (-x * 0.92, -y * 0.52)], 2, 0.12, deck + 0.06)
    sails, masts = [], []
    for v, top in ((-0.36, tall * 0.86), (0.34, tall)):
        masts.append(tube((0, v, 0.3), (0, v, top), 0.08))
        low, span = deck + 0.42, top - deck - 0.5
        for z, half in ((low + span * 0.2, 0.66), (low + span * 0.66, 0.48)):
            sails.append(box((0, v - 0.1, z), (half, 0.075, span * 0.19)))
    masts.append(tube((0, -y * 0.8, deck + 0.08), (0, -y - 0.4, deck + 0.42), 0.08))
    return {
        "hull": join(prism(plan, 2, deck / 2, deck / 2), stern, bow),
        "sails": join(*sails),
        "masts": join(*masts),
        "flag": box((0, 0.56, tall - 0.13), (0.075, 0.25, 0.15)),
        "windows": both(
            join(*(box((x, v, deck * 0.55), (0.07, 0.1, 0.1)) for v in (-0.35, 0.1, 0.55)))
        ),
    }


def longship(draw: Draw) -> Parts:
    """Of vikings: a long hull that sweeps up to a dragon's head and a curled tail, round shields
    along it, one square sail in stripes."""
    x, y, high, wide = draw(0.42, 0.47), draw(1.3, 1.4), draw(1.7, 1.84), draw(0.66, 0.74)
    rail, top, full = draw(0.46, 0.52), draw(1.06, 1.16), draw(0.08, 0.13)
    keel = smooth_curve([(-y - 0.08, 0.66), (-y * 0.84, 0.24), (-y * 0.5, 0.03), (0, 0),
                         (y * 0.5, 0.03), (y * 0.84, 0.24), (y + 0.08, 0.66)])  # fmt: skip
    sheer = smooth_curve([(y - 0.12, 0.86), (y * 0.74, rail + 0.12), (y * 0.4, rail),
                          (0, rail - 0.02), (-y * 0.4, rail), (-y * 0.74, rail + 0.12),
                          (-y + 0.12, 0.86)])  # fmt: skip
    beam = smooth_curve([(0.1, -y - 0.1), (x * 0.66, -y * 0.7), (x, -y * 0.3), (x, y * 0.3),
                         (x * 0.66, y * 0.7), (0.1, y + 0.1)])  # fmt: skip
    well = [(u - 0.15, v * 0.84) for u, v in beam if u > x * 0.6]
    bilge = prism(mirrored([(0.14, -0.1), (x * 0.76, 0.16), (x + 0.05, 0.42), (x + 0.05, 3)]), 1, 2)
    hull = cut(within(outlined([*keel, *sheer], beam), bilge), prism(mirrored(well), 2, 1, 1.22))
    # Seen from the side: of the front as far out, to -Y, as of the back to +Y.
    neck = [(y - 0.3, 0.4), *smooth_curve([(y - 0.06, 0.34), (y + 0.17, 0.66), (y + 0.17, 0.9),
                                           (y + 0.06, top)]),
            *smooth_curve([(y - 0.16, top), (y - 0.05, 0.88), (y - 0.3, 0.62)])]  # fmt: skip
    head = [(y - 0.18, top - 0.06), (y - 0.1, top + 0.16), (y + 0.06, top + 0.18),
            (y + 0.2, top + 0.07), (y + 0.42, top + 0.06), (y + 0.38, top - 0.12),
            (y + 0.06, top - 0.14)]  # fmt: skip
    horn = taper((0.08, y - 0.04, top + 0.08), (0.22, y - 0.24, top + 0.24), 0.1, 0.09)
    tail = [(0, y - 0.05, top - 0.08), (0, y - 0.1, top + 0.14), (0, y - 0.26, top + 0.26),
            (0, y - 0.42, top + 0.16)]  # fmt: skip
    dragon = turned(join(prism(head, 0, 0.13), both(horn)), 2, 180)
    low, up = rail + 0.3, high - 0.14
    wind = smooth_curve([(0, low), (-full * 0.9, low + (up - low) * 0.4), (0, up)])
    cloth = [(v - 0.12, w) for v, w in wind] + [(v + 0.08, w) for v, w in reversed(wind)]
    stripe = [(v - 0.18, w) for v, w in wind] + [(v + 0.12, w) for v, w in reversed(wind)]
    round_ = lathe([(0.17, -0.1), (0.17, 0.05), (0.08, 0.1)], 0.02)
    shields = (moved(turned(round_, 1, 90), (at - 0.02, v, rail - 0.06)) for v, at in
               ((-0.81, x * 0.84), (-0.27, x), (0.27, x), (0.81, x * 0.84)))  # fmt: skip
    return {
        "hull": hull,
        "prows": join(both(prism(neck, 0, 0.1), 1), dragon, limb(tail, 0.11, 0.1)),
        "mast": join(
            tube((0, 0.01, 0.14), (0, 0.01, high + 0.14), 0.1, 0.03),
            tube((-wide - 0.1, 0, up), (wide + 0.1, 0, up), 0.1, 0.03),
        ),
        "sail": prism(cloth, 0, wide),
        "stripes": both(prism(stripe, 0, wide / 5, wide * 0.4)),
        "shields": both(join(*shields)),
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


def cruise_ship(draw: Draw) -> Parts:
    """A dark blue hull, white decks in tiers with rows of windows, a red funnel, lifeboats."""
    x, y, deck = draw(0.42, 0.45), draw(1.4, 1.46), draw(0.48, 0.52)
    tall, fat = draw(0.27, 0.29), draw(0.19, 0.21)
    hull = ship_hull(x, y, deck, 0.16)
    tiers, panes = [], []
    for k, (front, back, wide) in enumerate(((-0.6, 0.84, 0.9), (-0.5, 0.74, 0.86),
                                             (-0.38, 0.64, 0.8))):  # fmt: skip
        low, half = deck + tall * k, x * wide
        tiers.append(box((0, (front + back) * y / 2, low + tall / 2 - 0.03),
                         (half, (back - front) * y / 2, tall / 2 + 0.05), 0.04))  # fmt: skip
        count = 7 - k
        step = (back - front) * y / count
        z = low + tall * 0.5
        panes += [box((0, front * y + step * (j + 0.5), z), (half + 0.05, step * 0.29, 0.075), 0.02)
                  for j in range(count) if k != 0]  # fmt: skip
        panes.append(box((0, front * y, z), (half * 0.72, 0.05, 0.075), 0.02))
        panes.append(box((0, back * y, z), (half * 0.72, 0.05, 0.075), 0.02))
    top = deck + tall * 3
    boat = [box((x * 0.9 + 0.04, v * y, deck + 0.15), (0.12, 0.165, 0.1), 0.09)
            for v in (-0.36, -0.04, 0.28, 0.6)]  # fmt: skip
    return {
        "hull": hull,
        "keel": within(grown(hull, 0.045), box((0, 0, 0.05), (2, 3, 0.1))),
        "decks": join(
            *tiers,
            box((0, -y * 0.3, top + 0.04), (x * 0.95, 0.17, 0.1), 0.03),
            tube((0, -y * 0.2, top), (0, -y * 0.17, top + 0.4), 0.075, 0.02),
        ),
        "windows": join(*panes, box((0, -y * 0.3 - 0.1, top + 0.05), (x * 0.7, 0.12, 0.06), 0.02)),
        "funnel": join(*(taper((0, v, top - 0.1), (0, v + 0.12, top + 0.4), fat + 0.05, fat)
                         for v in (y * 0.24, y * 0.34))),
        "rim": tube((0, y * 0.29 + 0.1, top + 0.38), (0, y * 0.29 + 0.17, top + 0.7), fat + 0.06,
                    0.04),
        "lifeboats": both(join(*boat)),
    }  # fmt: skip


SHIPS = {
    "yacht": yacht,
    "pirate ship": pirate_ship,
    "longship": fitted(longship),
    "cargo ship": cargo_ship,
    "cruise ship": cruise_ship,
}
