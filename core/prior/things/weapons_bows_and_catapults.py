"""Bows, a quiver and a catapult."""

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
    grown,
    join,
    lathe,
    limb,
    mirrored,
    moved,
    prism,
    smooth_curve,
    taper,
    tube,
    turned,
)


def bow(draw: Draw) -> Parts:
    """Upright, strung, its tips curled away from the archer; an arrow may lie on it."""
    belly, back, high = draw(0.3, 0.75), draw(0.2, 0.5), draw(1.25, 1.43)
    x, hold = draw(-0.2, 0.0), draw(0.22, 0.36)
    line = smooth_curve([(x - belly, 0), (x - belly * 0.86, hold + 0.1),
                         (x - belly * 0.1, high * 0.66), (x + back, high * 0.86),
                         (x + back - draw(-0.05, 0.3), high)])  # fmt: skip
    at = [(u, 0.0, v) for u, v in line]
    string = x + back + 0.04

    def raised(solid: Solid) -> Solid:
        return moved(solid, (0.1, 0, high + 0.1))

    parts = {
        "limbs": raised(both(limb(at, 0.15, 0.1), 2)),
        "grip": raised(tube((x - belly, 0, -hold), (x - belly, 0, hold), 0.19, 0.05)),
        "bands": raised(
            both(tube((x - belly, 0, hold - 0.06), (x - belly, 0, hold + 0.09), 0.22, 0.03), 2)
        ),
        "string": raised(tube((string, 0, -high * 0.88), (string, 0, high * 0.88), 0.08)),
    }
    if not draw.has("arrow", 0.5):
        return parts
    front = x - belly - draw(0.3, 0.45)
    tip = [(front - 0.4, 0.0), (front, -0.22), (front, 0.22)]
    vane = [(string - 0.5, 0.05), (string - 0.34, 0.26), (string + 0.12, 0.26), (string, 0.05)]
    return parts | {
        "arrow": raised(
            join(tube((front - 0.05, 0, 0), (string + 0.06, 0, 0), 0.085), prism(tip, 1, 0.1))
        ),
        "feathers": raised(both(prism(vane, 1, 0.08), 2)),
    }


def quiver(draw: Draw) -> Parts:
    """A slender leather tube that leans, with rims, an emblem and a strap at its back; five
    arrows with big feathers stand out of it."""
    r, high, lean = draw(0.42, 0.45), draw(1.66, 1.74), 12
    foot = r * 0.72
    vane = grown(prism(mirrored([(0.03, 0), (0.18, 0.18), (0.18, 0.68), (0.03, 0.54)]), 1, 0.04),
                 0.02)  # fmt: skip
    cross = moved(join(vane, turned(vane, 2, 90)), (0, 0, 0.42))
    shaft = tube((0, 0, -0.5), (0, 0, 1.06), 0.085, 0.03)

    def leaning(solid: Solid) -> Solid:
        """What is made upright on the z axis."""
        return moved(turned(solid, 1, lean), (-0.3, 0, 0.1))

    def stuck(solid: Solid) -> Solid:
        """What is of an arrow, of all five."""
        side = moved(turned(solid, 1, 26), (0.22, 0, high - 0.2))
        return leaning(join(moved(solid, (0, 0, high + 0.2)), around(4, side, 45)))

    path = [(r - 0.06, high - 0.1), (r + 0.22, high - 0.36), (r + 0.26, high * 0.5),
            (r + 0.12, 0.42), (foot - 0.02, 0.2)]  # fmt: skip
    outline = smooth_curve(path)
    strap = [*outline, *((u - 0.15, v) for u, v in reversed(outline))]
    gem = turned(box((0, 0, 0), (0.17, 0.14, 0.17), 0.04), 1, 45)
    return {
        "body": leaning(lathe([(foot * 0.7, 0), (foot, 0.14), (r, high - 0.05)], 0.02)),
        "rims": leaning(join(
            tube((0, 0, high - 0.22), (0, 0, high + 0.04), r + 0.08, 0.05),
            lathe([(foot * 0.6, -0.06), (foot + 0.07, 0.04), (foot + 0.1, 0.34)], 0.02),
        )),
        "strap": leaning(prism(strap, 0, 0.14)),
        "shafts": stuck(shaft),
        "feathers": stuck(cross),
        "emblem": leaning(moved(gem, (0, -r * 0.88, high * 0.54))),
    }  # fmt: skip


def crossbow(draw: Draw) -> Parts:
    """Upright, its bolt up and to the front, its butt on the ground."""
    top, reach, bend = draw(2.05, 2.2), draw(1.05, 1.2), draw(0.4, 0.52)
    nut, y = top - draw(0.85, 0.95), 0.16
    outer = [(0, top), (reach * 0.55, top - 0.1), (reach, top - bend)]
    inner = [(reach - 0.14, top - bend - 0.1), (reach * 0.5, top - 0.34), (0, top - 0.28)]
    limb = [*smooth_curve(outer), *smooth_curve(inner)]
    cord = capsule((reach - 0.07, -0.02, top - bend), (0, -y - 0.06, nut), 0.08)
    side = [(-y, top + 0.05), (-y, 0.55), (-0.12, 0), (0.42, 0), (0.3, 0.62), (y, 0.9)]
    tip = top + draw(0.1, 0.2)
    bolt = tube((0, -y - 0.05, nut - 0.1), (0, -y - 0.05, tip), 0.085)
    return {
        "stock": prism([*side, (y, top + 0.05)], 0, draw(0.14, 0.16)),
        "limbs": both(prism(limb, 1, 0.13)),
        "string": both(cord),
        "bolt": bolt,
        "point": moved(lathe([(0.16, tip - 0.02), (0.03, tip + 0.32)], 0.01), (0, -y - 0.05, 0)),
        "trigger": taper((0, y - 0.05, 1.0), (0, y + 0.22, 0.88), 0.09, 0.09),
    }


def catapult(draw: Draw) -> Parts:
    """On four wheels, its arm drawn back with a stone in the cup; it shoots to the front."""
    x, y, r = draw(0.56, 0.66), draw(1.0, 1.15), draw(0.3, 0.35)
    high, lean, long = draw(1.15, 1.3), draw(38, 46), draw(1.5, 1.65)
    beam = box((x, 0, r), (0.13, y, 0.14), 0.02)
    post = box((x, -y * 0.42, r + high / 2), (0.12, 0.13, high / 2), 0.02)
    brace = [
        (-y * 0.42, r + high - 0.1),
        (-y * 0.42, r + high - 0.36),
        (y * 0.36, r),
        (y * 0.62, r),
    ]
    cross = join(*(box((0, side * (y - 0.16), r), (x, 0.13, 0.12)) for side in (-1, 1)))
    # Made along +Z from the axle, then leant back.
    pole = box((0, 0, long / 2 - 0.2), (0.12, 0.12, long / 2 + 0.2), 0.02)
    cup = cut(
        tube((0, -0.26, long + 0.16), (0, 0.14, long + 0.16), 0.36, 0.03),
        ball((0, -0.42, long + 0.16), 0.36),
    )
    stone = ball((0, -0.3, long + 0.16), draw(0.26, 0.3))
    arm, cup, stone = (
        moved(turned(part, 0, -lean), (0, -y * 0.3, r + 0.12)) for part in (pole, cup, stone)
    )
    wheel = tube((x + 0.1, y * 0.66, r), (x + 0.3, y * 0.66, r), r, 0.03)
    hub = tube((x, y * 0.66, r), (x + 0.4, y * 0.66, r), 0.11, 0.02)
    return {
        "frame": join(
            both(join(beam, post, prism(brace, 0, 0.1, x))),
            cross,
            box((0, -y * 0.42, r + high - 0.1), (x + 0.22, 0.16, 0.15), 0.02),
        ),
        "wheels": both(wheel, 0, 1),
        "arm": arm,
        "cup": cup,
        "stone": stone,
        "bands": join(both(hub, 0, 1), tube((-x, -y * 0.3, r + 0.1), (x, -y * 0.3, r + 0.1), 0.2)),
    }


WEAPONS_BOWS_AND_CATAPULTS = {
    "bow": bow,
    "quiver": quiver,
    "crossbow": crossbow,
    "catapult": catapult,
}
