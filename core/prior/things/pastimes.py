"""What one plays, throws, rows and fishes with: balls, a goal, games of a pub, a rod, an oar."""

import math

from torch import Tensor

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
    limb,
    mirrored,
    moved,
    prism,
    ring,
    smooth_curve,
    taper,
    tilted,
    tube,
    turned,
    within,
)

Point = tuple[float, float, float]
PHI = (1 + math.sqrt(5)) / 2


def _rolled(solid: Solid, about_x: float, about_z: float, at: Point) -> Solid:
    """A ball, made about the origin, turned as it lies."""
    return moved(turned(turned(solid, 0, about_x), 2, about_z), at)


def _icosahedral(solid: Solid) -> Solid:
    """What ``solid`` is near (0, 1, PHI), one of twelve corners, at all of them by mirrors."""
    mirror = (-0.5 * PHI, -0.5, 0.5 / PHI)

    def distance(p: Tensor) -> Tensor:
        for _ in range(3):
            p = p.abs()
            beyond = (p * p.new_tensor(mirror)).sum(1, keepdim=True).clamp_max(0)
            p = p - 2 * beyond * p.new_tensor(mirror)
        return solid(p.abs())

    return distance


def soccer_ball(draw: Draw) -> Parts:
    """White, of hexagons with seams between them and twelve black pentagons that stand out."""
    wide, out = math.radians(draw(20.0, 23.5)), draw(0.035, 0.05)
    # From a corner (0, 1, PHI) to the middle of a face: the middle of a pentagon's side.
    reach = math.hypot(1, PHI)
    corner = (0.0, 1 / reach, PHI / reach)
    face = (PHI / math.hypot(PHI, 1 + 2 * PHI), 0.0, (1 + 2 * PHI) / math.hypot(PHI, 1 + 2 * PHI))
    along = sum(c * f for c, f in zip(corner, face, strict=True))
    side = [f - along * c for c, f in zip(corner, face, strict=True)]
    size = math.hypot(*side)
    half = math.atan(math.tan(wide) * math.cos(math.pi / 5))
    wall = [math.cos(half) * s / size - math.sin(half) * c
            for c, s in zip(corner, side, strict=True)]  # fmt: skip

    def sector(p: Tensor) -> Tensor:
        return (p * p.new_tensor(wall)).sum(1)

    lie = ((20.0, 10.0), (-30.0, 40.0), (70.0, -20.0))[draw.which(3)]
    patch = within(ball((0, 0, 0), 1 + out), sector)
    seam = ring((0, 0, 0), 0.94, 0.082, axis=0)
    return {
        "ball": ball((0, 0, 1), 1),
        "patches": _rolled(_icosahedral(patch), *lie, (0, 0, 1)),
        "seams": _rolled(_icosahedral(seam), *lie, (0, 0, 1)),
    }


def basketball(_: Draw) -> Parts:
    """Its seams are a pattern."""
    return {"ball": ball((0, 0, 1), 1)}


def american_football(draw: Draw) -> Parts:
    """A pointed egg that lies across, white stripes near its ends, laces on its upper side."""
    long, r, band = draw(1.1, 1.22), draw(0.6, 0.68), draw(0.52, 0.6)
    side = [(0.05, -long), (r * 0.32, -long * 0.86), (r * 0.68, -long * 0.6)]
    side += [(r * 0.93, -long * 0.28), (r, 0.0)]
    curve = smooth_curve([*side, *((u, -v) for u, v in reversed(side[:-1]))])
    stripe = within(lathe(curve, 0.045), both(box((0, 0, long * band), (2, 2, 0.085)), 2))
    top, lean = r + 0.03, draw(22, 40)
    seam = around(4, limb([(u - 0.04, 0, v) for u, v in curve[4:-4:4]], 0.075, 0.075))
    cross = [capsule((r, -0.17, v), (r, 0.17, v), 0.08) for v in (-0.36, -0.12, 0.12, 0.36)]
    spine = limb([(top - 0.06, 0, -0.46), (top, 0, 0), (top - 0.06, 0, 0.46)], 0.075, 0.075)

    def lying(solid: Solid) -> Solid:
        """The laces, made at +X, to the top and somewhat to the front."""
        return moved(turned(turned(solid, 1, -90), 0, lean), (0, 0, r))

    return {
        "ball": lying(lathe(curve, 0.01)),
        "stripes": lying(stripe),
        "laces": lying(join(spine, *cross)),
        "seam": lying(seam),
    }


def soccer_goal(draw: Draw) -> Parts:
    """Open to the front: two posts and a bar, and a net of bars that slants down to the back."""
    x, high, deep = draw(1.2, 1.36), draw(1.15, 1.32), draw(0.8, 0.95)
    roof, post, cord = draw(0.2, 0.34) * draw.chance(0.5), 0.11, 0.08
    z, y = high - post, deep - cord
    # The net's side line: from the bar over the roof down to the ground at the back.
    knee = (roof, z) if roof else (0.0, z)

    def at(height: float) -> float:
        return y + (knee[0] - y) * height / z

    rows = [capsule((-x, at(h), h), (x, at(h), h), cord) for h in (z * 0.36, z * 0.68)]
    columns = [
        limb([(u, 0, z), (u, knee[0] + 0.001, z), (u, y, cord)], cord, cord)
        for u in (-x * 2 / 3, -x / 3, 0, x / 3, x * 2 / 3)
    ]
    sides = [
        limb([(x, 0, z), (x, knee[0] + 0.001, z), (x, y, cord)], cord, cord),
        capsule((x, 0, z * 0.42), (x, at(z * 0.42), z * 0.42), cord),
        capsule((x, at(z * 0.7), z * 0.7), (x, at(z * 0.7), 0.1), cord),
    ]
    frame = join(
        both(join(tube((x, 0, 0), (x, 0, high), post), capsule((x, 0, post), (x, y, post), post))),
        capsule((-x, 0, z), (x, 0, z), post),
    )
    return {
        "posts": frame,
        "net": join(*rows, *columns, both(join(*sides))),
        "base": tube((0.1 - x, y, post), (x - 0.1, y, post), post - 0.005),
    }


def dartboard(draw: Draw) -> Parts:
    """A disc that faces the front: light and dark sectors, red and green rings, three darts."""
    r, deep, count = draw(1.06, 1.14), draw(0.2, 0.24), 16
    double, treble, bull = r * 0.8, r * draw(0.48, 0.5), 0.13
    step = math.pi / count
    wedge = [(0.0, 0.0), (2.0, 2 * math.tan(step)), (2.0, -2 * math.tan(step))]

    def disc(radius: float, top: float) -> Solid:
        return tube((0, 0, 0.08), (0, 0, top), radius)

    def band(middle: float, half: float, top: float) -> Solid:
        return cut(disc(middle + half, top), tube((0, 0, -1), (0, 0, 2), middle - half))

    def facing(solid: Solid) -> Solid:
        return tilted(solid, 90, (0, 0, r))

    def thrown(solid: Solid, x: float, y: float, aside: float) -> Solid:
        """``solid``, which stands on z = 0, with its end up and aside."""
        return moved(turned(turned(solid, 0, -16), 1, aside), (x * r, y * r, deep))

    up = deep + 0.055
    fin = mirrored([(0.05, 0.7), (0.21, 0.84), (0.21, 1.12), (0.05, 1.06)])
    flight = join(prism(fin, 1, 0.05), prism(fin, 0, 0.05))
    dart = join(
        taper((0, 0, 0), (0, 0, 0.42), 0.055, 0.09), capsule((0, 0, 0), (0, 0, 0.95), 0.055)
    )
    hits = ((-0.42, 0.34, -16), (0.5, 0.16, 16), (-0.1, -0.5, -6))
    outer = [(r, 0.0), (r, deep + 0.1), (r - 0.12, deep + 0.1), (r - 0.12, deep)]
    return {
        "board": facing(lathe(outer)),
        "sectors": facing(
            cut(within(disc(double, up), around(count // 2, _flat(wedge))), disc(bull, 1))
        ),
        "reds": facing(join(band(double, 0.065, up + 0.04), disc(bull * 0.8, up + 0.08))),
        "greens": facing(join(band(treble, 0.065, up + 0.04), disc(bull + 0.1, up + 0.02))),
        "darts": facing(join(*(thrown(dart, *hit) for hit in hits))),
        "flights": facing(join(*(thrown(flight, *hit) for hit in hits))),
    }


def _flat(corners: list[tuple[float, float]]) -> Solid:
    return prism(corners, 2, 3.0)


def fishing_rod(draw: Draw) -> Parts:
    """It leans to the right and bends, a reel below its grip, a float on its line."""
    lean, high, reach = draw(1.0, 1.2), draw(2.2, 2.45), draw(0.6, 0.75)
    foot, thick = -1.0, 0.1
    slope = lean / high
    hold = 0.86
    end = (foot + lean + reach, high + draw(-0.05, 0.14))
    bend = smooth_curve(
        [
            (foot + slope * 0.7, 0.7),
            (foot + slope * 1.4, 1.36),
            (foot + slope * 1.95, 1.95),
            (foot + lean + reach * 0.3, high),
            end,
        ],
        3,
    )

    def at(height: float, aside: float = 0.0) -> Point:
        return (foot + slope * height + aside, 0.0, height - aside * slope)

    low = draw(0.6, 0.85)
    spool, drop = at(0.98, 0.36), (end[0], 0.0, low)
    bob = draw(0.23, 0.28)
    crank = [(spool[0], -0.2, spool[2]), (spool[0], -0.36, spool[2])]
    crank += [(spool[0] + 0.2, -0.36, spool[2] - 0.16)]
    return {
        "rod": limb([(u, 0.0, v) for u, v in bend], thick + 0.02, thick - 0.01),
        "handle": join(
            tube(at(0.02), at(hold - 0.16), 0.15, 0.05), tube(at(1.12), at(1.4), 0.15, 0.05)
        ),
        "reel": join(
            *(tube((spool[0], a, spool[2]), (spool[0], b, spool[2]), 0.27, 0.03)
              for a, b in ((-0.22, -0.09), (0.09, 0.22))),
            tube((spool[0], -0.2, spool[2]), (spool[0], 0.2, spool[2]), 0.17),
            capsule(at(0.98), spool, 0.1),
            limb(crank, 0.085, 0.085),
            ball((spool[0] + 0.2, -0.42, spool[2] - 0.16), 0.12),
        ),
        "line": capsule((end[0], 0, end[1]), drop, 0.08),
        "float": cut(egg(drop, (bob, bob, bob * 1.2)), box((0, 0, low - 1), (3, 2, 1))),
        "tip": join(
            cut(egg(drop, (bob, bob, bob * 1.2)), box((0, 0, low + 1), (3, 2, 1))),
            tube((end[0], 0, low), (end[0], 0, low - bob - 0.2), 0.085, 0.03),
        ),
    }  # fmt: skip


def oar(draw: Draw) -> Parts:
    """It stands on its blade: a long shaft with a sleeve, a knob or a bar across at its top."""
    wide, blade, long = draw(0.17, 0.21), draw(0.95, 1.1), draw(2.9, 3.1)
    thick, deep, broad = draw(0.047, 0.052), 0.045, draw.chance(0.5)
    half = [(0.001, 0.0), (wide * 0.62, 0.05), (wide * 0.96, 0.24), (wide * 0.9, blade * 0.6)]
    if broad:
        half = [(0.001, 0.0), (wide * 0.85, 0.01), (wide * 1.06, 0.12), (wide * 0.9, blade * 0.66)]
    flat = mirrored(smooth_curve([*half, (wide * 0.42, blade * 0.88), (0.04, blade + 0.1)], 3))
    low, up = draw(0.3, 0.38), draw(0.1, 0.13)
    bar = box((0, 0, long), (0.16, 0.06, 0.09), 0.05)
    knob = join(
        tube((0, 0, long - 0.5), (0, 0, long), thick + 0.017, 0.01), ball((0, 0, long), 0.09)
    )
    sleeve = long * draw(0.54, 0.6)
    return {
        "shaft": tube((0, 0, blade * 0.2), (0, 0, long), thick),
        "blade": prism(flat, 1, deep),
        "stripe": within(prism(flat, 1, deep + 0.015), box((0, 0, low), (2, 2, up))),
        "grip": bar if draw.chance(0.5) else knob,
        "sleeve": tube((0, 0, sleeve), (0, 0, sleeve + 0.4), thick + 0.017, 0.01),
        "collar": tube((0, 0, sleeve + 0.11), (0, 0, sleeve + 0.29), thick + 0.042, 0.02),
    }


def pool_table(draw: Draw) -> Parts:
    """Green cloth within a wooden rim, six pockets, four stout legs, balls and a cue on it."""
    x, y, high = draw(1.26, 1.4), draw(0.76, 0.86), draw(0.72, 0.84)
    deep, rail, r = draw(0.24, 0.3), 0.15, 0.095
    top = high + deep
    foot, thick = 0.2, draw(0.14, 0.17)
    leg = lathe([(thick * 0.8, 0), (thick * 0.9, 0.12), (thick * 0.75, 0.2), (thick * 1.25, high)],
                0.02, (x - foot, y - foot))  # fmt: skip
    inside = box((0, 0, top), (x - rail, y - rail, 0.14))
    cloth = top - 0.1
    cushion = box((0, 0, top - 0.1), (x - rail + 0.02, y - rail + 0.02, 0.15), 0.03)
    well = box((0, 0, top), (x - rail - 0.1, y - rail - 0.1, 0.3))
    hole = both(join(*(tube((u, y - rail, top - 0.2), (u, y - rail, top + 0.075), 0.14, 0.02)
                       for u in (0.0, x - rail))), 0, 1)  # fmt: skip
    rack = [(k, j) for k in range(3) for j in range(k + 1)]
    balls = [(0.3 + 1.74 * r * k, 2 * r * (j - k / 2), cloth + r * 0.8) for k, j in rack]
    cue = [(-x + 0.12, -y * 0.1, top + 0.075), (0.02, -y * 0.62, cloth + 0.12)]
    return {
        "frame": join(
            cut(box((0, 0, top - deep / 2), (x, y, deep / 2), 0.03), inside),
            both(leg, 0, 1),
        ),
        "cloth": join(
            box((0, 0, cloth - 0.1), (x - rail + 0.02, y - rail + 0.02, 0.1)), cut(cushion, well)
        ),
        "pockets": hole,
        "balls": join(*(ball(at, r) for at in balls)),
        "cue ball": ball((-x * 0.4, y * 0.22, cloth + r * 0.8), r + 0.01),
        "cue": taper(*cue, 0.095, 0.08),
    }


def whistle(draw: Draw) -> Parts:
    """A round chamber with a slot, a ball seen in it, a mouthpiece to the left, a ring."""
    r, y, reach = draw(0.62, 0.7), draw(0.34, 0.4), draw(1.0, 1.15)
    z, tall = 0.72, draw(0.3, 0.36)
    top = z + r
    mouth = [(-reach, top), (0.1, top), (0.1, top - tall - 0.16), (-reach, top - tall)]
    slot = [(-0.3, top - 0.5), (-0.42, top + 0.2), (0.2, top + 0.2), (0.08, top - 0.5)]
    end = [(-reach - 0.04, top + 0.03), (-reach + 0.24, top + 0.03)]
    end += [(-reach + 0.24, top - tall - 0.07), (-reach - 0.04, top - tall - 0.03)]
    eye = r + 0.16
    chamber = join(tube((0, -y, z), (0, y, z), r, 0.05), prism(mouth, 1, y - 0.02))
    return {
        "body": cut(chamber, prism(slot, 1, y - 0.12)),
        "mouthpiece": prism(end, 1, y + 0.03),
        "sides": both(tube((0, 0, z), (0, y + 0.05, z), r * draw(0.56, 0.64), 0.02), 1),
        "pea": ball((-0.1, 0, top - 0.17), 0.21),
        "ring": ring((eye, 0, z + 0.1), 0.2, 0.08, axis=1),
    }


PASTIMES = {
    "soccer ball": soccer_ball,
    "basketball": basketball,
    "american football": american_football,
    "soccer goal": soccer_goal,
    "dartboard": dartboard,
    "fishing rod": fishing_rod,
    "oar": oar,
    "pool table": pool_table,
    "whistle": whistle,
}
