"""What a market or a stand sells to eat, and two plants."""

import math

import torch

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
    Vector,
    around,
    ball,
    blend,
    both,
    box,
    capsule,
    cut,
    egg,
    join,
    lathe,
    moved,
    prism,
    ring,
    smooth_curve,
    tilted,
    tube,
    turned,
    within,
)


def potato(draw: Draw) -> Parts:
    """A lump, thicker at one end, with a few dark eyes in it."""
    long, r, s = draw(0.55, 0.75), draw(0.52, 0.6), draw(0.42, 0.54)
    bump, z = draw(0.08, 0.2), 0.62
    body = blend(
        0.3,
        egg((-long * 0.6, 0, z), (0.62, r, r * 0.92)),
        egg((long * 0.7, 0, z - 0.04), (0.6, s, s * 0.95)),
        egg((-0.05, -bump, z + bump), (0.62, 0.42, 0.4)),
        egg((0.1, bump, z - 0.12), (0.7, 0.42, 0.4)),
    )
    marks = []
    for x, angle in ((-0.75, 60), (-0.35, 20), (0.1, 55), (0.55, 28), (0.8, 70), (0.3, 120),
                     (-0.5, 130)):  # fmt: skip
        a = math.radians(angle)
        dy, dz = -math.cos(a), math.sin(a)
        reach = _surface(body, (x, 0, z), (0, dy, dz))
        marks.append(egg((x, dy * (reach - 0.04), z + dz * (reach - 0.04)), (0.15, 0.085, 0.085)))
    return {"body": body, "spots": join(*marks)}


def _surface(solid: Solid, start: Vector, way: Vector) -> float:
    """How far from ``start``, within, the solid's surface is along the unit vector ``way``."""
    steps = torch.arange(0, 1.5, 0.01)[:, None]
    points = torch.tensor(start) + steps * torch.tensor(way)
    return float(steps[(solid(points) < 0).sum() - 1])


def cucumber(draw: Draw) -> Parts:
    """It lies, one end cut off, pale stripes along it; a thick slice leans on its front."""
    long, r = draw(1.24, 1.32), draw(0.42, 0.45)
    big, x, end = r + 0.04, draw(-0.3, -0.2), draw(0.96, 1.02)
    at = (x, -r - 0.2, big - 0.04)
    stripes = [(-math.cos(a) * (r - 0.05), r + math.sin(a) * (r - 0.05))
               for a in map(math.radians, (15, 70, 125))]  # fmt: skip
    seed = egg((0.21, 0, 0.04), (0.115, 0.07, 0.09))

    def faces(solid: Solid) -> Solid:
        """``solid``, of a face that looks up, at the end and on the slice."""
        return join(moved(turned(solid, 0, 72), at), moved(turned(solid, 1, 90), (end, 0, r)))

    return {
        "rind": join(
            capsule((-long + r, 0, r), (end - r, 0, r), r),
            tube((end - r, 0, r), (end, 0, r), r),
            moved(turned(tube((0, 0, -0.26), (0, 0, 0), big, 0.02), 0, 72), at),
        ),
        "stripes": join(*(capsule((-long + r, v, w), (end - 0.22, v, w), 0.12)
                          for v, w in stripes)),
        "flesh": faces(tube((0, 0, -0.1), (0, 0, 0.06), r - 0.07)),
        "seeds": faces(around(5, seed, 90)),
        "stem": tube((-long - 0.1, 0, r), (-long + 0.1, 0, r), 0.11, 0.04),
    }  # fmt: skip


def lettuce(draw: Draw) -> Parts:
    """A round heart in a ring of leaves and one of open ones of three lobes, with pale ribs."""
    r, lean, size = draw(0.5, 0.53), draw(28, 31), draw(0.64, 0.68)
    wide = size * 0.7
    hollow = egg((-0.2, 0, 0.06), (0.32, wide - 0.04, size))
    lobe = cut(egg((0, 0, 0), (0.32, wide, size)), hollow)
    leaf = join(lobe, both(turned(lobe, 0, -44), 1))

    def put(solid: Solid, first: float, degrees: float, out: float, z: float) -> Solid:
        return around(5, moved(turned(solid, 1, degrees), (out, 0, z)), first)

    return {
        "head": egg((0, 0, 0.94), (r, r, r)),
        "leaves": join(
            put(leaf, 18, lean, 0.7, 0.62),
            egg((0, 0, 0.5), (0.56, 0.56, 0.38)),
        ),
        "frills": put(egg((0, 0, 0), (0.26, 0.46, 0.54)), 54, 18, 0.46, 0.8),
        "ribs": put(egg((0.22, 0, 0.1), (0.14, 0.11, 0.38)), 18, lean, 0.7, 0.62),
        "stalk": tube((0, 0, 0), (0, 0, 0.3), 0.32, 0.06),
    }


def ramen(draw: Draw) -> Parts:
    """A bowl of broth with noodles, two halves of an egg, chopsticks across its rim."""
    wide, high, foot = draw(0.98, 1.1), draw(0.8, 0.96), draw(0.44, 0.52)
    full = high - 0.08
    wall = smooth_curve([(foot, 0.1), (wide * 0.74, 0.3), (wide * 0.95, high * 0.66), (wide, high)])
    nest = [ring((-0.3, -0.22, full + lift), r, 0.11) for r, lift in ((0.42, 0.02), (0.18, 0.12))]
    half = cut(ball((0, 0, 0), 0.3), box((0, 0, 1), (1, 1, 1)))
    eggs = ((0.56, -0.18, 30), (0.2, -0.62, 5))

    def put(solid: Solid) -> Solid:
        return join(*(moved(turned(tilted(solid, 32, (0, 0, 0)), 2, turn), (x, y, full + 0.08))
                      for x, y, turn in eggs))  # fmt: skip

    return {
        "bowl": join(
            cut(lathe(wall), tube((0, 0, full - 0.1), (0, 0, high + 1), wide - 0.15)),
            tube((0, 0, 0), (0, 0, 0.2), foot),
        ),
        "broth": tube((0, 0, full - 0.2), (0, 0, full), wide - 0.14),
        "noodles": join(*nest, tube((-0.3, -0.22, full - 0.1), (-0.3, -0.22, full + 0.1), 0.42)),
        "whites": put(half),
        "yolks": put(ball((0, 0, -0.08), 0.18)),
        "chopsticks": join(
            *(capsule((-1.0, y, high + 0.07), (1.36, y, high + 0.07), 0.09) for y in (0.46, 0.78))
        ),
    }


def popcorn(draw: Draw) -> Parts:
    """A striped box, wider at its top, heaped with popcorn."""
    low, wide, high = draw(0.46, 0.54), draw(0.72, 0.82), draw(1.2, 1.45)
    heap = draw.arranged()

    def flared(out: float) -> Solid:
        side = [(-low - out, 0.0), (low + out, 0.0), (wide + out, high), (-wide - out, high)]
        return within(prism(side, 1, 2), prism(side, 0, 2))

    slabs = [
        both(prism([(x * low - 0.07, 0), (x * low + 0.07, 0), (x * wide + 0.13, high + 0.1),
                    (x * wide - 0.13, high + 0.1)], axis, 2), 0, 1)
        for axis in (0, 1) for x in (0.0, 0.74)
    ]  # fmt: skip
    corn = [ball((0, 0, high - 0.06), 0.6)]
    yellow = []
    for count, r, lift in ((8, wide * 0.8, 0.06), (6, wide * 0.5, 0.28), (3, wide * 0.18, 0.48)):
        for k in range(count):
            turn = math.radians(360 * k / count + heap(-10, 10) + 20 * lift)
            spot = (r * math.cos(turn), r * math.sin(turn), high + lift + heap(-0.04, 0.06))
            size = heap(0.2, 0.25)
            corn.append(ball(spot, size))
            top = (spot[0] * 1.1, spot[1] * 1.1, spot[2] + size * 0.75)
            yellow.append(ball(top, 0.11))
    shell = within(flared(0.04), join(*slabs))
    front = (low + wide) / 2
    return {
        "box": flared(0.0),
        "stripes": shell,
        "popcorn": join(*corn),
        "butter": join(*yellow),
        "badge": tilted(
            turned(tube((0, 0, -0.08), (0, 0, 0.08), 0.36), 0, 90), 0, (0, -front - 0.02, high / 2)
        ),
    }


def chocolate_bar(draw: Draw) -> Parts:
    """Upright: squares above, the lower half in foil and paper with a label."""
    columns = 3
    w, h, deep = draw(0.25, 0.29), draw(0.29, 0.33), draw(0.14, 0.18)
    rows, x = 3, columns * w
    fold = draw(0.85, 1.0)
    long = fold + 0.12 + rows * 2 * h
    blocks = []
    for i in range(columns):
        for k in range(rows):
            u, v = (2 * i - columns + 1) * w, fold + 0.12 + (2 * k + 1) * h
            blocks.append(
                join(
                    box((u, -deep, v), (w - 0.06, 0.07, h - 0.06), 0.03),
                    box((u, -deep - 0.06, v), (w - 0.12, 0.06, h - 0.12), 0.03),
                )
            )
    torn = [(-x - 0.06, fold - 0.2), (x + 0.06, fold - 0.2)]
    torn += [
        (x + 0.06 - k * (2 * x + 0.12) / 6, fold + (0.22 if k % 2 else 0.06)) for k in range(7)
    ]
    return {
        "chocolate": box((0, 0, long / 2), (x, deep, long / 2), 0.02),
        "squares": join(*blocks),
        "foil": prism(torn, 1, deep + 0.14),
        "wrapper": box((0, 0, fold / 2), (x + 0.1, deep + 0.18, fold / 2), 0.03),
        "label": box((0, -deep - 0.18, fold / 2), (x * 0.78, 0.05, fold * 0.26), 0.02),
        "bands": join(
            *(box((0, -deep - 0.16, fold / 2 + s * fold * 0.4), (x + 0.11, 0.06, 0.06), 0.02)
              for s in (-1, 1)),
        ),
    }  # fmt: skip


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


def bamboo(draw: Draw) -> Parts:
    """Three straight stalks with rings from a clump of earth, flat leaves at their joints."""
    tall, r = draw(2.3, 2.6), draw(0.17, 0.21)
    outline = [(0, 0.09), (0.45, 0.22), (1.0, 0), (0.45, -0.22), (0, -0.09)]
    blade = turned(prism(outline, 1, 0.08), 1, -28)
    stalks, rings, leaves = [], [], []
    for x, y, joints, turns in (
        (0, 0.14, 4, (15, 165)),
        (0.42, -0.1, 3, (-20, 60)),
        (-0.42, -0.14, 2, (200, 270)),
    ):
        high = tall * joints / 4
        stalks.append(tube((x, y, 0), (x, y, high), r))
        for j in range(1, joints + 1):
            z = tall * j / 4 - 0.16
            rings.append(tube((x, y, z - 0.08), (x, y, z + 0.08), r + 0.06))
        for j, turn in enumerate(turns):
            leaves.append(moved(turned(blade, 2, turn), (x, y, high - 0.1 - 0.24 * j)))
    return {
        "stalks": join(*stalks),
        "rings": join(*rings),
        "leaves": join(*leaves),
        "ground": lathe([(0.82, 0), (0.74, 0.2)]),
    }


MARKET = {
    "potato": potato,
    "cucumber": cucumber,
    "lettuce": lettuce,
    "ramen": ramen,
    "popcorn": popcorn,
    "chocolate bar": chocolate_bar,
    "pinecone": pinecone,
    "bamboo plant": bamboo,
}
