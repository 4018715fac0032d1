"""Plants, wood and stone, and what lies on the beach."""

import math

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
    around,
    ball,
    blend,
    box,
    capsule,
    cut,
    egg,
    join,
    lathe,
    moved,
    ring,
    smooth_curve,
    taper,
    tube,
    turned,
)
from core.prior.things.fruits import bent


def _crown(draw: Draw, wide: float, high: float, z: float, count: int = 9) -> Solid:
    """Round tufts about a middle, more above than below; of few arrangements."""
    own = draw.arranged()
    tufts: list[Solid] = [egg((0, 0, z), (wide * 0.8, wide * 0.8, high * 0.85))]
    for k in range(count):
        angle, level = 2.4 * k + own(-0.3, 0.3), -0.35 + 1.15 * k / count
        reach = wide * 0.72 * math.sqrt(max(0.1, 1 - level * level))
        size = wide * own(0.36, 0.46)
        at = (reach * math.cos(angle), reach * math.sin(angle), z + high * 0.75 * level)
        tufts.append(ball(at, size))
    return join(*tufts)


def _pot(wide: float, high: float) -> Solid:
    hull = lathe([(wide * 0.7, 0), (wide * 0.94, high)], 0.02)
    return join(hull, tube((0, 0, high - 0.16), (0, 0, high + 0.04), wide * 1.08, 0.04))


def bush(draw: Draw) -> Parts:
    """Tufts down to the ground, sometimes with berries."""
    wide, high = draw(0.95, 1.1), draw(0.65, 0.9)
    crown = _crown(draw, wide, high, high * 0.85, 9)
    low = around(7, ball((wide * 0.72, 0, 0.32), 0.38), 10)
    stems = join(around(3, taper((0.15, 0, -0.2), (0.2, 0, 0.4), 0.16, 0.1)))
    return {"leaves": cut(join(crown, low), box((0, 0, -2), (3, 3, 2))), "stems": stems}


def potted_plant(draw: Draw) -> Parts:
    """Broad leaves that arch out of a pot."""
    wide, high = draw(0.5, 0.6), draw(0.65, 0.8)
    rise, out = draw(1.0, 1.25), draw(0.62, 0.78)

    def leaf(length: float, reach: float, fat: float) -> Solid:
        return join(
            taper((0.02, 0, high - 0.1), (reach * 0.45, 0, high + length * 0.7), 0.09, fat),
            taper((reach * 0.45, 0, high + length * 0.7), (reach, 0, high + length), fat, 0.07),
        )

    leaves = [
        around(5, leaf(rise * 0.65, out + 0.15, 0.2), 18),
        around(4, leaf(rise, out * 0.7, 0.2), 45),
        taper((0, 0, high), (0.05, 0, high + rise * 1.15), 0.16, 0.08),
    ]
    return {
        "leaves": join(*leaves),
        "pot": _pot(wide, high),
        "soil": tube((0, 0, high - 0.1), (0, 0, high + 0.07), wide * 0.85, 0.02),
    }


def sunflower(draw: Draw) -> Parts:
    """A great head that looks to the front, on a stalk with leaves."""
    z, heart, count = draw(1.9, 2.2), draw(0.36, 0.44), 11 + 2 * draw.chance(0.5)
    y, reach = -0.22, draw(0.72, 0.84)
    petal = taper((heart * 0.8, 0, 0), (reach, 0, 0), 0.14, 0.08)
    blossom = around(count, petal, 90)
    leaf = turned(egg((0.4, 0, 0), (0.42, 0.22, 0.09)), 1, -draw(20, 40))
    low, mid = draw(0.55, 0.7), draw(0.9, 1.1)
    return {
        "petals": moved(turned(blossom, 0, 90), (0, y, z)),
        "heart": egg((0, y - 0.06, z), (heart, 0.2, heart)),
        "stalk": join(
            capsule((0, 0.02, 0), (0, 0.02, z - 0.1), 0.11),
            capsule((0, 0.02, z - 0.1), (0, y + 0.06, z), 0.12),
            moved(leaf, (0, 0, low)),
            moved(turned(leaf, 2, 180), (0, 0, mid)),
        ),
    }


def rose(draw: Draw) -> Parts:
    """Petals wound about each other, on a stalk with two leaves."""
    z, size = draw(1.55, 1.8), draw(0.46, 0.54)

    def cup(radius: float, low: float, high: float) -> Solid:
        shape = [(0.08, low), (radius * 0.85, low + 0.12), (radius, (low + high) / 2 + 0.05)]
        return lathe(smooth_curve([*shape, (radius * 0.88, high)], 3))

    def petals(count: int, radius: float, low: float, high: float, first: float) -> Solid:
        # Balls pressed flat to the cup, each cut open above.
        outer = egg((radius * 0.72, 0, 0), (radius * 0.42, radius * 0.72, (high - low) / 2))
        return moved(around(count, turned(outer, 1, 14), first), (0, 0, (low + high) / 2))

    head = join(
        petals(5, size, z - 0.35, z + 0.3, 18),
        petals(4, size * 0.75, z - 0.1, z + 0.48, 45),
        petals(3, size * 0.5, z + 0.0, z + 0.62, 90),
        cup(size * 0.6, z - 0.38, z + 0.35),
    )
    leaf = turned(egg((0.36, 0, 0), (0.4, 0.22, 0.09)), 1, -draw(20, 40))
    sepal = taper((0.08, 0, z - 0.38), (size * 0.75, 0, z - 0.3), 0.11, 0.07)
    low = draw(0.4, 0.6)
    return {
        "petals": head,
        "stalk": join(
            capsule((0, 0, 0), (0, 0, z - 0.3), 0.1),
            around(5, sepal),
            moved(leaf, (0, 0, low)),
            moved(turned(leaf, 2, 180), (0, 0, low + draw(0.2, 0.35))),
        ),
    }


def tulip(draw: Draw) -> Parts:
    """A cup of six petals on a stalk, two long leaves from the ground."""
    z, wide, high = draw(1.45, 1.7), draw(0.36, 0.44), draw(0.75, 0.9)
    petal = join(
        taper((0.1, 0, z), (wide * 0.72, 0, z + high * 0.42), 0.16, 0.26),
        taper((wide * 0.72, 0, z + high * 0.42), (wide * 0.85, 0, z + high), 0.26, 0.06),
    )
    inner = taper((0, 0, z + 0.1), (0, 0, z + high * 0.7), 0.2, 0.2)
    out = draw(0.45, 0.65)
    leaf = bent([(0.06, 0, 0.1), (0.3, 0, 0.55), (out, 0, draw(1.1, 1.35))], [0.12, 0.17, 0.06])
    return {
        "petals": join(around(3, petal, 90), around(3, petal, 30), inner),
        "stalk": join(
            capsule((0, 0, 0), (0, 0, z + 0.05), 0.11), around(2 + draw.chance(0.5), leaf)
        ),
    }


def bonsai(draw: Draw) -> Parts:
    """A crooked trunk in a shallow tray, foliage in clouds."""
    side = 1 if draw.chance(0.5) else -1
    lean, top = side * draw(0.3, 0.45), draw(1.35, 1.6)
    tray = join(
        box((0, 0, 0.2), (0.85, 0.55, 0.18), 0.05),
        box((0, 0, 0.36), (0.92, 0.62, 0.07), 0.03),
        box((0, 0, 0.03), (0.65, 0.4, 0.08), 0.02),
    )
    bend = (lean, 0.0, 0.95)
    tip, left = (-lean * 0.3, 0.0, top), (-lean * 1.9, -0.05, draw(1.0, 1.15))
    right = (lean * 2.1, 0.05, draw(1.2, 1.35))
    trunk = join(
        bent([(-lean * 0.4, 0, 0.35), bend, tip], [0.22, 0.17, 0.12]),
        taper((lean * 0.3, 0, 0.72), left, 0.12, 0.1),
        taper(bend, right, 0.12, 0.1),
    )

    def cloud(at: tuple[float, float, float], size: float) -> Solid:
        tufts = around(6, egg((size * 0.6, 0, 0), (size * 0.5, size * 0.5, size * 0.42)))
        return moved(join(tufts, egg((0, 0, 0.06), (size * 0.75, size * 0.75, size * 0.6))), at)

    clouds = [cloud((tip[0], 0, top + 0.12), draw(0.52, 0.62)), cloud(left, draw(0.4, 0.48))]
    return {
        "leaves": join(*clouds, cloud(right, draw(0.42, 0.5))),
        "trunk": trunk,
        "tray": tray,
        "moss": egg((0, 0, 0.4), (0.78, 0.48, 0.12)),
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


def oak_tree(draw: Draw) -> Parts:
    """A broad round crown on a stout trunk with boughs and roots."""
    wide, high, top = draw(0.95, 1.15), draw(0.65, 0.85), draw(0.95, 1.2)
    z, trunk, count = top + high * 0.75, draw(0.2, 0.26), 10
    bough = taper((0.04, 0, top * 0.62), (wide * 0.55, 0, z - 0.15), trunk * 0.65, 0.1)
    root = taper((0.1, 0, 0.22), (trunk + 0.28, 0, 0.06), 0.15, 0.08)
    lobes = around(6, ball((wide * 0.68, 0, z - high * 0.3), wide * 0.36), 15)
    return {
        "leaves": join(_crown(draw, wide, high, z, count), lobes),
        "trunk": join(
            taper((0, 0, 0.1), (0, 0, z), trunk * 1.15, trunk * 0.8),
            around(4, bough, 45),
            around(5, root, 18),
        ),
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


PLANTS = {
    "bush": bush,
    "potted plant": potted_plant,
    "sunflower": sunflower,
    "rose": rose,
    "tulip": tulip,
    "bonsai": bonsai,
    "stump": stump,
    "log": log,
    "boulder": boulder,
    "acorn": acorn,
    "oak tree": oak_tree,
    "coral": coral,
    "seashell": seashell,
}
