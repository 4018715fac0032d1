"""A mushroom, logs, cones and a boulder; coral and a seashell."""

import math

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    around,
    ball,
    blend,
    box,
    capsule,
    cut,
    egg,
    ellipsoid,
    join,
    lathe,
    moved,
    ring,
    smooth_curve,
    taper,
    tube,
    turned,
)
from core.prior.things.shared.ropes import bent


def mushroom(draw: Draw) -> Parts:
    cap, height, stem = draw(0.85, 1.0), draw(0.85, 1.1), draw(0.24, 0.32)
    dome = draw(0.6, 0.8)
    under = box((0, 0, height - 2), (2, 2, 2))
    return {
        "cap": cut(ellipsoid((0, 0, height), (cap, cap, dome)), under),
        "stem": lathe([(stem * 1.25, 0), (stem, 0.4), (stem * 0.95, height + 0.1)], 0.02),
    }


def stump(draw: Draw) -> Parts:
    """What is left of a tree: bark, roots, a cut face with rings, sometimes a sprout."""
    wide, high, count = draw(0.68, 0.82), draw(0.7, 1.05), 5 + draw.chance(0.5)
    root = taper((wide * 0.7, 0, 0.4), (wide + draw(0.35, 0.5), 0, 0.08), 0.24, 0.12)
    hull = lathe([(wide * 1.15, 0), (wide * 1.0, 0.3), (wide * 0.94, high)], 0.02)
    ribs = around(14, capsule((wide * 0.97, 0, 0.2), (wide * 0.9, 0, high - 0.1), 0.1), 10)
    below = box((0, 0, -2), (3, 3, 2))
    bark = cut(join(hull, ribs, around(count, root)), below)
    rings = join(
        tube((0, 0, high - 0.1), (0, 0, high + 0.05), wide * 0.84, 0.02),
        ring((0, 0, high + 0.04), wide * 0.56, 0.06),
        ring((0, 0, high + 0.04), wide * 0.26, 0.06),
    )
    twig = taper((wide * 0.8, 0, high * 0.6), (wide + 0.4, 0, high + 0.1), 0.14, 0.11)
    return {"bark": join(bark, turned(twig, 2, -70)), "wood": rings}


def log(draw: Draw) -> Parts:
    """It lies along x: bark, cut ends with rings, the stump of a branch."""
    long, fat = draw(1.1, 1.4), draw(0.4, 0.52)
    rib = capsule((fat, 0, -long + 0.15), (fat, 0, long - 0.15), 0.09)
    hull = join(tube((0, 0, -long), (0, 0, long), fat + 0.02, 0.03), around(11, rib))
    disc = tube((0, 0, -long - 0.05), (0, 0, long + 0.05), fat * 0.84, 0.02)
    rings = [ring((0, 0, side * (long + 0.04)), fat * 0.48, 0.06) for side in (-1, 1)]
    at = draw(-0.5, 0.5)
    twig = taper((at, -0.1, 0.2), (at + 0.2, -fat * 0.7, fat + 0.25), 0.17, 0.14)
    end = ball((at + 0.21, -fat * 0.73, fat + 0.32), 0.1)
    return {
        "bark": join(turned(hull, 1, 90), twig),
        "wood": join(turned(join(disc, *rings), 1, 90), end),
    }


def boulder(draw: Draw) -> Parts:
    """A rock with flat faces, now and then moss on it."""
    size = [draw(0.85, 1.15), draw(0.75, 0.95), draw(0.6, 0.85)]
    planes, own = [], draw.arranged()
    for k in range(22):
        # Directions spread evenly over the sphere (a Fibonacci spiral), jittered.
        z = 1 - (2 * k + 1) / 22 + own(-0.06, 0.06)
        angle, flat = 2.39996 * k + own(-0.35, 0.35), math.sqrt(max(0.0, 1 - z * z))
        planes.append((flat * math.cos(angle), flat * math.sin(angle), z, own(0.82, 1.0)))
    smallest = min(size)

    def faceted(p, grow: float = 0.0):
        q = p / p.new_tensor(size)
        normals = p.new_tensor([plane[:3] for plane in planes])
        offsets = p.new_tensor([plane[3] for plane in planes]) + grow
        return ((q @ normals.T - offsets).amax(1)) * smallest / 1.02

    def rock(p):
        return faceted(p).maximum(-0.55 * size[2] - p[:, 2])

    angle = own(0, 6.28)
    by = (size[0] * 0.35 * math.cos(angle), size[1] * 0.35 * math.sin(angle), size[2] * 0.95)
    patch = egg(by, (0.55, 0.5, 0.4)) if draw.chance(0.4) else ball((0, 0, 0), 0.05)
    return {"rock": rock, "moss": lambda p: faceted(p, 0.04).maximum(patch(p))}


def acorn(draw: Draw) -> Parts:
    """A nut, tip down, in its scaly cup with a stalk."""
    wide, high = draw(0.62, 0.72), draw(1.15, 1.4)
    shape = [(0.04, -0.1), (0.12, 0.04), (wide * 0.6, high * 0.2), (wide, high * 0.62)]
    nut = lathe(smooth_curve([*shape, (wide * 0.95, high)]))
    z = high * 0.82
    cup = cut(egg((0, 0, z), (wide * 1.2, wide * 1.2, 0.62)), box((0, 0, z - 2.05), (3, 3, 2)))
    scales = []
    for k in range(4):
        tilt = math.radians(6 + 20 * k)
        at = (wide * 1.2 * math.cos(tilt), 0, z + 0.62 * math.sin(tilt))
        count = max(5, int(13 * math.cos(tilt)))
        scales.append(around(count, egg(at, (0.13, 0.19, 0.13)), 14 * (k % 2)))
    stalk = taper((0, 0, z + 0.5), (draw(-0.15, 0.2), 0, z + draw(0.9, 1.1)), 0.13, 0.11)
    return {"nut": nut, "cap": join(cup, *scales, stalk)}


def pinecone(draw: Draw) -> Parts:
    """On its base, its broad scales in four rings of six that open to the sides."""
    wide, high, lean = draw(0.66, 0.78), draw(1.4, 1.65), draw(34, 44)
    scales, tips, core = [], [], [(wide * 0.8, 0.08)]
    for row, share in enumerate((0.84, 0.9, 0.7, 0.38)):
        r, z, first = wide * share, 0.36 + row * high / 4, 90 - 30 * (row % 2)
        core.append((r + 0.13, z))
        broad = 0.16 + r * 0.34
        blade = egg((0, 0, 0), (0.18, broad, 0.42))
        tip = egg((0.02, 0, 0.33), (0.13, broad * 0.55, 0.14))
        scales.append(around(6, moved(turned(blade, 1, lean), (r, 0, z)), first))
        tips.append(around(6, moved(turned(tip, 1, lean), (r, 0, z)), first))
    return {
        "core": lathe([*core, (0.1, high + 0.2)]),
        "scales": join(*scales, capsule((0, 0, high), (0, 0, high + 0.3), 0.2)),
        "tips": join(*tips),
        "stem": tube((0, 0, 0), (0, 0, 0.3), 0.2),
    }


def coral(draw: Draw) -> Parts:
    """Branches that fork, with round tips, on a stone."""
    branches, count, own = [], 5, draw.arranged()
    for k in range(count):
        angle = 2 * math.pi * k / count + own(-0.25, 0.25)
        c, s, high = math.cos(angle), math.sin(angle), own(0.75, 1.05)
        knee = (0.42 * c, 0.42 * s, high)
        branches.append(taper((0.05 * c, 0.05 * s, 0.2), knee, 0.2, 0.15))
        for turn, reach in ((-0.5, 0.4), (0.5, 0.36)):
            c, s = math.cos(angle + turn), math.sin(angle + turn)
            tip = (knee[0] + reach * c, knee[1] + reach * s, high + own(0.4, 0.7))
            branches.append(taper(knee, tip, 0.15, 0.13))
    top = draw(1.3, 1.5)
    branches.append(taper((0, 0, 0.2), (0, 0, top), 0.22, 0.16))
    branches += [taper((0, 0, top), (0.25 * side, 0, top + 0.45), 0.15, 0.13) for side in (-1, 1)]
    stone = cut(egg((0, 0, 0.02), (0.8, 0.7, 0.32)), box((0, 0, -2.08), (3, 3, 2)))
    return {"branches": blend(0.08, *branches), "stone": stone}


def seashell(draw: Draw) -> Parts:
    """A scallop, upright, its ribs spread like a fan towards the front."""
    count, size = 7 + 2 * draw.chance(0.5), draw(1.15, 1.35)
    spread, ribs, grooves = draw(66, 76), [], []
    for k in range(count):
        angle = math.radians(spread * (2 * k / (count - 1) - 1))
        c, s = math.cos(angle), math.sin(angle)
        long = size * (0.78 + 0.22 * c)
        tip = (long * s, 0.05, 0.25 + long * c)
        mid = (long * 0.55 * s, -0.2 * c - 0.02, 0.25 + long * 0.55 * c)
        fat = size * 1.18 * math.radians(spread) / count
        ribs.append(bent([(0, 0.02, 0.25), mid, tip], [0.12, fat * 0.68, fat * 0.85]))
        if k:
            half = math.radians(spread * ((2 * k - 1) / (count - 1) - 1))
            at = (size * 0.86 * math.sin(half), 0.05, 0.25 + size * 0.86 * math.cos(half))
            grooves.append(taper((0, 0.02, 0.3), at, 0.1, 0.14))
    hinge = join(box((0, 0.03, 0.14), (draw(0.4, 0.5), 0.12, 0.15), 0.05), ball((0, 0, 0.26), 0.2))
    back = cut(join(*ribs), box((0, 2.14, 1), (3, 2, 3)))
    return {"ribs": back, "grooves": join(*grooves), "hinge": hinge}


PLANTS_FOREST_FLOOR_AND_SHORE = {
    "mushroom": mushroom,
    "stump": stump,
    "log": log,
    "boulder": boulder,
    "acorn": acorn,
    "pinecone": pinecone,
    "coral": coral,
    "seashell": seashell,
}
