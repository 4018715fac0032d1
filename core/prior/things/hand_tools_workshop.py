"""Tools of the workshop and the garden."""

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
    limb,
    mirrored,
    moved,
    prism,
    smooth_curve,
    taper,
    tube,
    turned,
    within,
)


def hammer(draw: Draw) -> Parts:
    """Upright, its face to the left, its claw, which is bent down and split, to the right."""
    high, grip, face = draw(1.75, 1.95), draw(0.11, 0.13), draw(0.23, 0.27)
    reach, drop, y = draw(0.78, 0.9), draw(0.24, 0.34), 0.2
    z = high
    over = [(0.1, z + 0.17), (reach * 0.55, z + 0.11), (reach, z - drop)]
    under = [(reach - 0.12, z - drop - 0.06), (reach * 0.5, z - 0.13), (0.1, z - 0.17)]
    slit = [(0.36, 0.0), (1.2, 0.13), (1.2, -0.13)]
    return {
        "head": join(
            tube((-0.64, 0, z), (-0.4, 0, z), face, 0.04),
            tube((-0.45, 0, z), (-0.1, 0, z), face * 0.68),
            box((0, 0, z), (0.2, y, 0.21), 0.03),
        ),
        "handle": join(
            tube((0, 0, 0), (0, 0, high * 0.46), grip * 1.35, 0.06),
            tube((0, 0, high * 0.4), (0, 0, high + 0.28), grip),
        ),
        "claw": cut(prism([*smooth_curve(over), *smooth_curve(under)], 1, y), prism(slit, 2, 3)),
    }


def axe(draw: Draw) -> Parts:
    """Upright, its edge to the left."""
    high, grip = draw(1.8, 2.05), draw(0.1, 0.12)
    reach, edge = draw(0.62, 0.72), draw(0.4, 0.5)
    z = high - 0.25
    blade = [
        (0.16, z - 0.16),
        (0.16, z + 0.16),
        (-reach * 0.6, z + edge * 0.62),
        (-reach, z + edge),
    ]
    blade += [(-reach - 0.1, z), (-reach, z - edge), (-reach * 0.55, z - edge * 0.5)]
    return {
        "head": join(prism(blade, 1, 0.09), box((0.0, 0, z), (0.2, 0.16, 0.18), 0.03)),
        "handle": join(
            capsule((0, 0, 0.12), (0, 0, high), grip),
            taper((0, 0, 0.12), (0, 0, 0.5), grip * 1.4, grip),
        ),
    }


def pickaxe(draw: Draw) -> Parts:
    """A curved head with two points, upright."""
    high, reach, drop, heavy = draw(1.8, 2.2), draw(0.9, 1.1), draw(0.25, 0.45), draw(0.17, 0.22)
    knee = (reach * 0.5, 0, high - drop * 0.25)
    point = join(
        taper((0, 0, high), knee, heavy, heavy * 0.85),
        taper(knee, (reach, 0, high - drop), heavy * 0.85, 0.08),
    )
    return {
        "head": join(both(point), box((0, 0, high), (0.22, 0.22, 0.2), 0.04)),
        "handle": lathe([(0.17, 0), (0.12, 0.35), (0.13, high + 0.25)], 0.01),
        "grip": tube((0, 0, 0.03), (0, 0, draw(0.4, 0.7)), 0.18, 0.04),
    }


def shovel(draw: Draw) -> Parts:
    """It stands on its pointed blade, which is hollow to the front; the grip above is a D."""
    wide, deep, top, shaft = draw(0.29, 0.35), draw(0.8, 0.95), draw(2.4, 2.6), draw(0.055, 0.06)
    side = [(0.03, 0), (wide * 0.6, 0.13), (wide * 0.95, 0.34), (wide, 0.5), (wide, deep)]
    shell = (tube((0, -0.6, -1), (0, -0.6, 2), 0.6 + thick) for thick in (0.052, -0.052))
    bar = box((0, 0, top + 0.36), (0.22, 0.06, 0.085), 0.05)
    return {
        "blade": join(
            within(prism(mirrored(side), 1, 0.4), cut(*shell)),
            taper((0, 0, deep * 0.5), (0, 0, deep + 0.3), shaft + 0.025, shaft + 0.03),
        ),
        "handle": tube((0, 0, deep), (0, 0, top), shaft),
        "grip": join(bar, both(capsule((0, 0, top - 0.02), (0.17, 0, top + 0.34), 0.06))),
    }


def saw(draw: Draw) -> Parts:
    """A handsaw along x, its teeth down, its handle to the right."""
    left, right, high, tip = -1.2, 0.62, draw(0.62, 0.75), draw(0.25, 0.35)
    teeth, low = 7, 0.16
    step = (right - left) / teeth
    edge = []
    for k in range(teeth):
        edge += [(left + k * step, low), (left + (k + 0.5) * step, 0.0)]
    blade = [*edge, (right, low), (right, low + high), (left, low + tip)]
    z = low + high * 0.5
    back = [(0.45, z - 0.36), (0.98, z - 0.52), (1.26, z - 0.46), (1.3, z - 0.2), (1.22, z + 0.1),
            (1.3, z + 0.44), (1.1, z + 0.56), (0.55, z + 0.46)]  # fmt: skip
    grip = [(0.8, z - 0.24), (1.04, z - 0.32), (1.1, z - 0.16), (1.04, z + 0.12), (1.08, z + 0.32),
            (0.86, z + 0.32)]  # fmt: skip
    body, hole = prism(back, 1, 0.15), prism(smooth_curve([*grip, grip[0]], 3), 1, 1)
    return {
        "blade": prism(blade, 1, 0.09),
        "handle": cut(body, hole),
        "rivets": join(
            *(tube((0.62, -0.19, z + v), (0.62, 0.19, z + v), 0.08, 0.02) for v in (-0.18, 0.26))
        ),
    }


def chainsaw(draw: Draw) -> Parts:
    """It lies, its bar to the left."""
    long, wide, y = draw(1.25, 1.4), draw(0.17, 0.2), draw(0.26, 0.32)
    z, high = draw(0.34, 0.4), draw(0.72, 0.82)
    tip = 0.15 - long
    outer = wide + 0.09
    plate = join(
        box(((0.2 + tip) / 2, 0, z), ((0.2 - tip) / 2, 0.11, wide)),
        tube((tip, -0.11, z), (tip, 0.11, z), wide),
    )
    chain = join(
        box(((0.2 + tip) / 2, 0, z), ((0.2 - tip) / 2, 0.08, outer)),
        tube((tip, -0.08, z), (tip, 0.08, z), outer),
    )
    count = 6
    tooth = join(
        *(
            prism(
                [(a, side * outer), (a + 0.14, side * outer), (a, side * (outer + 0.08))], 1, 0.08
            )
            for side in (-1, 1)
            for a in (tip + (0.1 - tip) * k / count for k in range(count))
        )
    )
    body = [(0.05, 0.08), (0.95, 0.08), (1.0, 0.4), (0.9, high), (0.3, high + 0.06), (0.02, 0.5)]
    back = join(
        capsule((0.85, 0, high - 0.1), (1.35, 0, high - 0.16), 0.11),
        capsule((1.35, 0, high - 0.16), (1.42, 0, 0.26), 0.11),
        capsule((1.42, 0, 0.26), (0.85, 0, 0.2), 0.11),
    )
    hoop = join(
        capsule((0.36, -y, high - 0.2), (0.34, -y, high + 0.34), 0.1),
        capsule((0.34, -y, high + 0.34), (0.34, y, high + 0.34), 0.1),
        capsule((0.36, y, high - 0.2), (0.34, y, high + 0.34), 0.1),
    )
    return {
        "body": join(prism(body, 1, y), box((0.6, 0, high), (0.28, y * 0.7, 0.12), 0.06)),
        "bar": plate,
        "chain": join(chain, moved(tooth, (0, 0, z))),
        "handles": join(back, hoop),
        "guard": moved(
            turned(box((0, 0, 0), (0.08, y * 0.9, 0.2), 0.03), 1, -16), (-0.06, 0, high + 0.08)
        ),
        "cover": tube((0.5, -y - 0.07, 0.38), (0.5, -y + 0.05, 0.38), draw(0.2, 0.25), 0.03),
    }


def screwdriver(draw: Draw) -> Parts:
    """A ribbed handle below, the tip up."""
    grip, high, top, shaft = draw(0.17, 0.21), draw(0.85, 1.05), draw(2.0, 2.4), draw(0.065, 0.075)
    shape = [(grip * 0.7, 0.0), (grip, 0.15), (grip * 0.95, high * 0.65), (grip * 0.6, high)]
    grooves = around(6, capsule((grip * 1.12, 0, 0.2), (grip * 1.12, 0, high * 0.66), 0.06))
    blade = prism(mirrored([(shaft, top - 0.1), (0.1, top + 0.1), (0.08, top + 0.3)]), 1, 0.055)
    cross = lathe([(shaft, top), (0.03, top + 0.25)], 0.02)
    return {
        "handle": cut(lathe(smooth_curve(shape, 3), 0.02), grooves),
        "shaft": join(
            tube((0, 0, high - 0.1), (0, 0, top), shaft), blade if draw.chance(0.6) else cross
        ),
        "collar": tube((0, 0, high - 0.08), (0, 0, high + 0.1), grip * 0.66, 0.03),
    }


def wrench(draw: Draw) -> Parts:
    """Flat: an open jaw above, a ring or a second jaw below."""
    high, wide, jaw = draw(1.85, 2.1), draw(0.11, 0.135), draw(0.29, 0.33)
    thick, gap = draw(0.044, 0.05), draw(0.12, 0.145)
    top, ring_radius = high + jaw, jaw * 0.85
    head = tube((0, -thick, top), (0, thick, top), jaw, 0.015)
    mouth = turned(box((0, 0, jaw * 0.75), (gap, 1, jaw * 0.75)), 1, draw(-25, 25))
    foot = tube((0, -thick, 0.1), (0, thick, 0.1), ring_radius, 0.015)
    hole = tube((0, -1, 0.1), (0, 1, 0.1), ring_radius - 0.14)
    if draw.chance(0.4):
        hole = moved(turned(box((0, 0, -jaw), (gap * 0.85, 1, jaw)), 1, -15), (0, 0, 0.12))
    neck = [(wide + 0.07, 0.2), (wide, 0.6), (wide, high - 0.25), (wide + 0.09, high + 0.12)]
    return {
        "head": join(cut(head, moved(mouth, (0, 0, top - 0.05))), cut(foot, hole)),
        "handle": prism(mirrored(neck), 1, thick * 0.82),
    }


def pliers(draw: Draw) -> Parts:
    """Open, upright: toothed jaws above a bolt, and long grips of rubber that bow out."""
    long, wide, reach = draw(0.72, 0.92), draw(0.3, 0.36), draw(0.46, 0.56)
    z, gap, y = draw(1.5, 1.64), draw(0.24, 0.32), 0.15
    tip, up = draw(0.12, 0.16), z + long
    jaw = [(0.0, z - 0.2), (wide * 0.8, z - 0.12), (wide, z + 0.12), (wide * 1.06, z + 0.32)]
    jaw += [(gap + tip, up), (gap, up), (0.06, z + 0.22), (0.0, z + 0.2)]
    high = z - 0.54
    grip = [(reach * 0.7, high), (reach, high * 0.72), (reach * 1.06, high * 0.4)]
    path = [(u, 0, v) for u, v in smooth_curve([*grip, (reach * 0.86, 0.14)], 3)]
    shares = [(k + 1) / 3.4 for k in range(3)]
    places = [(gap * share + 0.06, 0, z + 0.22 + (long - 0.22) * share) for share in shares]
    neck = [(0.1, 0, z), (0.17, 0, z - 0.26), (reach * 0.72, 0, high - 0.04)]
    return {
        "jaws": both(grown(prism(jaw, 1, y - 0.03), 0.03)),
        "handles": both(limb(path, 0.15, 0.15)),
        "necks": both(limb(neck, 0.2, 0.11)),
        "bolt": tube((0, -y - 0.08, z), (0, y + 0.08, z), 0.2, 0.03),
        "teeth": both(join(*(box(at, (0.06, y + 0.05, 0.07)) for at in places))),
        "ends": both(
            taper((reach * 0.68, 0, high + 0.04), (reach * 0.78, 0, high - 0.1), 0.2, 0.18)
        ),
    }


def anvil(draw: Draw) -> Parts:
    """Its horn to the left, a step between that and its face, its waist on a broad foot."""
    top, long, waist = draw(1.0, 1.12), draw(0.58, 0.66), draw(0.26, 0.32)
    deep, foot, high = draw(0.24, 0.28), draw(0.58, 0.66), draw(0.18, 0.22)
    reach, low = draw(1.16, 1.26), top - 0.34
    side = smooth_curve([(foot - 0.06, high), (waist, high + 0.22), (waist, low - 0.16),
                         (waist + 0.18, low + 0.06)], 4)  # fmt: skip
    return {
        "body": box((0.24, 0, top - 0.16), (long, deep, 0.17), 0.02),
        "horn": join(
            taper((-0.46, 0, top - 0.18), (-reach, 0, top - 0.06), deep * 0.8, 0.06),
            box((-0.42, 0, top - 0.2), (0.16, deep - 0.03, 0.14), 0.02),
        ),
        "waist": prism(mirrored(side), 1, deep - 0.04),
        "foot": box((0, 0, high / 2), (foot, deep + 0.1, high / 2), 0.03),
    }


def toolbox(draw: Draw) -> Parts:
    """A box with a sloped lid, a handle along its top and two latches."""
    x, y, high, rise = draw(0.95, 1.15), draw(0.42, 0.54), draw(0.6, 0.75), draw(0.25, 0.35)
    top = high + rise
    lid = [(-y - 0.04, high), (y + 0.04, high), (y * 0.4, top), (-y * 0.4, top)]
    post = both(box((x * 0.5, 0, top + 0.1), (0.1, 0.1, 0.2), 0.02))
    return {
        "body": box((0, 0, high / 2), (x, y, high / 2), 0.03),
        "lid": prism(
            [*lid[:2], (y + 0.04, high + 0.1), *lid[2:], (-y - 0.04, high + 0.1)], 0, x + 0.04
        ),
        "handle": join(post, box((0, 0, top + 0.26), (x * 0.5 + 0.1, 0.11, 0.1), 0.06)),
        "latches": both(box((x * 0.5, -y - 0.05, high), (0.13, 0.07, 0.17), 0.02)),
    }


def paintbrush(draw: Draw) -> Parts:
    """Bristles up: a round brush, or a flat one for walls."""
    flat, high = draw.chance(0.5), draw(1.3, 1.7)
    wide = draw(0.24, 0.32) if flat else draw(0.11, 0.14)
    deep = 0.1 if flat else wide
    neck, hair = high + draw(0.3, 0.4), draw(0.5, 0.7)
    if flat:
        bristles = box(
            (0, 0, neck + hair / 2 - 0.05), (wide * 0.94, deep * 0.88, hair / 2 + 0.05), 0.03
        )
        ferrule = box((0, 0, (high + neck) / 2), (wide, deep, (neck - high) / 2 + 0.02), 0.03)
        grip = prism(
            [(-0.09, 0), (0.09, 0), (0.08, high * 0.6), (wide * 0.9, high), (0, high)], 1, 0.07
        )
        grip = join(grip, both(grip))
    else:
        point = [(wide, neck - 0.1), (wide * 1.25, neck + hair * 0.4), (0.04, neck + hair * 1.2)]
        bristles = lathe(smooth_curve(point, 4), 0.02)
        ferrule = lathe([(0.095, high), (wide, neck)], 0.02)
        curve = smooth_curve([(0.06, 0), (0.1, high * 0.7), (0.09, high + 0.05)], 3)
        grip = lathe(curve, 0.01)
    return {
        "bristles": bristles,
        "ferrule": ferrule,
        "handle": grip,
        "paint": cut(
            moved(bristles, (0, 0, 0.02)), box((0, 0, neck + hair * draw(0.4, 0.6) - 2), (2, 2, 2))
        )
        if not flat
        else box(
            (0, 0, neck + hair * 0.78), (wide * 0.95 + 0.02, deep * 0.9 + 0.02, hair * 0.26), 0.05
        ),
    }


HAND_TOOLS_WORKSHOP = {
    "hammer": hammer,
    "axe": axe,
    "pickaxe": pickaxe,
    "shovel": shovel,
    "saw": saw,
    "chainsaw": chainsaw,
    "screwdriver": screwdriver,
    "wrench": wrench,
    "pliers": pliers,
    "anvil": anvil,
    "toolbox": toolbox,
    "paintbrush": paintbrush,
}
