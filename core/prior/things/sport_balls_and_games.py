"""Balls, throwing toys, boards and tables of games."""

import math

import torch
from torch import Tensor

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Point,
    Solid,
    Vector,
    around,
    ball,
    both,
    box,
    capsule,
    chain,
    cut,
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

PHI = (1 + math.sqrt(5)) / 2


def _rolled(solid: Solid, about_x: float, about_z: float, at: Vector) -> Solid:
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


def _flat(corners: list[tuple[float, float]]) -> Solid:
    return prism(corners, 2, 3.0)


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


def _repeated(solid: Solid, pitch: float, count: int) -> Solid:
    """``solid``, symmetric about the axes, at ``count`` places along x and as many along y."""
    last = (count - 1) / 2

    def nearest(u: Tensor) -> Tensor:
        return u - pitch * ((u / pitch + last).round().clamp(0, count - 1) - last)

    return lambda p: solid(torch.stack([nearest(p[:, 0]), nearest(p[:, 1]), p[:, 2]], 1))


def _chessman(at: Point, low: float, tall: float, royal: bool) -> Solid:
    """A piece on its foot; it has a round head, or a crown and a knob."""
    high, (x, y) = low + tall, at
    foot = [(0.14, low), (0.14, low + 0.07), (0.07, low + 0.16)]
    if not royal:
        return join(lathe([*foot, (0.06, high - 0.28)], 0.02, (x, y)),
                    ball((x, y, high - 0.14), 0.14))  # fmt: skip
    crown = [(0.07, high - 0.36), (0.15, high - 0.12), (0.03, high - 0.06)]
    return join(lathe([*foot, *crown], 0.02, (x, y)), ball((x, y, high - 0.02), 0.09))


def chessboard(draw: Draw) -> Parts:
    """Eight by eight squares in a frame, the dark ones raised; pieces may stand on it."""
    pitch, rim, high = draw(0.29, 0.32), draw(0.12, 0.26), draw(0.2, 0.5)
    side, top, tall = 4 * pitch, high + 0.03, draw(0.44, 0.7)
    check = _repeated(box((0, 0, high), (pitch * 0.44, pitch * 0.44, 0.03)), 2 * pitch, 4)
    parts = {
        "frame": cut(
            box((0, 0, high / 2 + 0.03), (side + rim, side + rim, high / 2 + 0.03), 0.03),
            box((0, 0, high + 0.5), (side, side, 0.52)),
        ),
        "squares": box((0, 0, high / 2), (side, side, high / 2)),
        "checks": join(
            moved(check, (pitch / 2, pitch / 2, 0)), moved(check, (-pitch / 2, -pitch / 2, 0))
        ),
    }
    if not draw.has("pieces", 0.5):
        return parts

    def men(sign: float) -> Solid:
        places = ((3.5, 3.5, 0.1), (1.5, 3.5, 0.34), (2.5, 2.5, 0), (0.5, 1.5, 0))
        row = (_chessman((u * pitch, sign * v * pitch), top - 0.02, tall + more, more > 0.2)
               for u, v, more in places)  # fmt: skip
        return both(join(*row))

    return parts | {"pieces": men(-1), "rivals": men(1)}


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


def kite(draw: Draw) -> Parts:
    """A diamond, its upper half of one colour, on crossed spars; a tail with bows."""
    x, low, high = draw(0.8, 1.3), draw(1.1, 1.5), draw(2.85, 3.08)
    z, sway = low + (high - low) * draw(0.5, 0.72), draw(0.08, 0.22)
    tail = smooth_curve([(0, low + 0.1), (-sway, low * 0.78), (sway, low * 0.42), (-sway, 0.08)])
    bow = [(0, 0.05), (0.22, 0.13), (0.22, -0.13), (0, -0.05), (-0.22, -0.13), (-0.22, 0.13)]
    ties = [moved(turned(prism(bow, 1, 0.1), 1, turn), (tail[k][0], 0, tail[k][1]))
            for k, turn in ((4, 35), (8, -35), (12, 20))]  # fmt: skip
    return {
        "sail": prism([(-x, z), (0, high), (x, z)], 1, 0.1),
        "keel": prism([(-x, z), (x, z), (0, low)], 1, 0.1),
        "spars": join(
            tube((0, 0.06, low - 0.02), (0, 0.06, high), 0.1, 0.03),
            capsule((-x, 0.06, z), (x, 0.06, z), 0.1),
            box((0, -0.04, (low + high) / 2), (0.07, 0.13, (high - low) / 2 - 0.05), 0.02),
            box((0, -0.04, z), (x - 0.1, 0.13, 0.07), 0.02),
        ),
        "tail": limb([(u, 0.0, v) for u, v in tail], 0.09, 0.09),
        "bows": join(*ties),
    }


def yo_yo(draw: Draw) -> Parts:
    """Two discs on an axle, a star on each; its string rises to a loop."""
    r, deep, slot = draw(0.7, 1.05), draw(0.2, 0.42), 0.13
    top, loop = min(2 * r + draw(0.3, 0.75), 2.5), draw(0.18, 0.26)
    half = [(r * 0.8, slot), (r, slot + 0.1), (r * 0.96, slot + deep * 0.6),
            (r * 0.74, slot + deep)]  # fmt: skip
    face = lathe([(r * 0.62, slot + deep - 0.05), (r * 0.62, slot + deep + 0.06)])
    point = prism([(0.0, -0.15), (r * 0.52, -0.02), (r * 0.52, 0.02), (0.0, 0.15)], 2,
                  0.1, slot + deep + 0.03)  # fmt: skip

    def facing(solid: Solid) -> Solid:
        return both(tilted(solid, -90, (0, 0, r)), 1)

    return {
        "discs": facing(lathe(smooth_curve(half, 3))),
        "faces": facing(face),
        "stars": facing(around(5, point, -90)),
        "axle": both(tube((0, 0, r), (0, slot + deep + 0.19, r), 0.13, 0.03), 1),
        "string": join(
            tube((0, 0, r), (0, 0, top), 0.09),
            ring((0, 0, top + loop), loop, 0.09, 1),
            tube((0, -slot, r), (0, slot, r), r * 0.66),
        ),
    }


def slingshot(draw: Draw) -> Parts:
    """A forked branch; two bands hang from it to a pouch with a stone."""
    x, fork, high = draw(0.55, 0.95), draw(0.95, 1.45), draw(2.45, 2.9)
    thick, sag = draw(0.16, 0.23), draw(0.5, 0.95)
    prong = smooth_curve([(0.0, fork - 0.1), (x * 0.62, fork + 0.24), (x, fork + 0.75), (x, high)])
    pouch = (0.0, -0.5, high - 0.2 - sag)
    tie = high - 0.24
    return {
        "fork": join(
            both(limb([(u, 0.0, v) for u, v in prong], thick + 0.02, thick - 0.03)),
            taper((0, 0, 0.25), (0, 0, fork), thick + 0.03, thick + 0.02),
        ),
        "grip": join(
            tube((0, 0, 0.06), (0, 0, fork - 0.3), thick + 0.1, 0.06),
            *(tube((0, 0, v), (0, 0, v + 0.14), thick + 0.14, 0.05)
              for v in (0.04, (fork - 0.3) / 2, fork - 0.4)),
        ),
        "bands": both(capsule((x, -0.1, tie), (0.2, pouch[1], pouch[2] + 0.06), 0.1)),
        "pouch": box(pouch, (0.3, 0.13, 0.2), 0.09),
        "stone": ball((0, pouch[1] - 0.1, pouch[2] + 0.02), 0.17),
        "ties": both(tube((x, 0, tie - 0.12), (x, 0, tie + 0.12), thick + 0.07, 0.04)),
    }  # fmt: skip


def boomerang(draw: Draw) -> Parts:
    """Upright on its tips, a smooth flat wing bent in the middle, its bands wholly around it."""
    x, high, wide, flat = draw(1.34, 1.42), draw(1.24, 1.34), draw(0.31, 0.34), 0.4
    end, bend = wide * 0.78, draw(0.32, 0.38)
    stops = smooth_curve([(0.0, high), (bend, high - 0.12), (x * 0.6, high * 0.56), (x, end)], 3)
    wing = [((u, 0.0, v), wide + (end - wide) * u / x) for u, v in stops]
    ((a, _, b), first), ((c, _, d), last) = wing[-4], wing[-1]

    def flattened(solid: Solid) -> Solid:
        """``solid``, thinner from front to back."""
        return lambda p: solid(p * p.new_tensor([1, 1 / flat, 1])) * flat

    def at(s: float) -> tuple[float, float, float]:
        return (a + (c - a) * s, 0.0, b + (d - b) * s)

    def band(s: float) -> Solid:
        """About the straight end of an arm, at ``s`` of it."""
        wider = first + (last - first) * s + 0.08
        return both(flattened(tube(at(s - 0.1), at(s + 0.1), wider, 0.03)))

    dot = (high - 0.03, wide * flat + 0.06)
    return {
        "body": both(flattened(chain(wing))),
        "bands": join(band(0.0), band(0.72)),
        "stripes": band(0.36),
        "dot": tube((0, -dot[1], dot[0]), (0, dot[1], dot[0]), 0.19, 0.03),
    }


SPORT_BALLS_AND_GAMES = {
    "soccer ball": soccer_ball,
    "basketball": basketball,
    "american football": american_football,
    "dartboard": dartboard,
    "pool table": pool_table,
    "chessboard": chessboard,
    "soccer goal": soccer_goal,
    "kite": kite,
    "yo-yo": yo_yo,
    "slingshot": slingshot,
    "boomerang": boomerang,
}
