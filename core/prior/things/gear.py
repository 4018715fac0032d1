"""Hand tools and kitchen tools, upright where they have a handle; with the toys, all the gear."""

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    around,
    both,
    box,
    capsule,
    cut,
    egg,
    join,
    lathe,
    mirrored,
    moved,
    prism,
    ring,
    smooth_curve,
    taper,
    tube,
    turned,
    within,
)
from core.prior.things.toys import TOYS


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


def pencil(draw: Draw) -> Parts:
    """Six-sided, its point up, an eraser below."""
    r, high, cone = draw(0.1, 0.12), draw(2.0, 2.4), draw(0.4, 0.5)
    body = around(
        6,
        prism(
            [(0, -r * 0.58), (r, -r * 0.58), (r, r * 0.58), (0, r * 0.58)],
            2,
            high / 2,
            high / 2 + 0.4,
        ),
    )
    tip = high + 0.4
    return {
        "body": body,
        "wood": lathe([(r * 1.02, tip - 0.08), (0.035, tip + cone)], 0.01),
        "lead": lathe([(r * 0.5, tip + cone * 0.62), (0.01, tip + cone * 1.12)], 0.015),
        "eraser": tube((0, 0, 0), (0, 0, 0.3), r * 1.02, 0.04),
        "ferrule": tube((0, 0, 0.22), (0, 0, 0.48), r * 1.15, 0.02),
    }


def scissors(draw: Draw) -> Parts:
    """A little open, the points up."""
    long, loop, up = draw(1.15, 1.4), draw(0.27, 0.33), 1.2
    half = [(-0.14, -0.25), (0.13, -0.25), (0.15, long * 0.45), (-0.06, long), (-0.14, long)]
    halves = (
        moved(
            turned(prism([(side * u, v) for u, v in half], 1, 0.09), 1, side * 14),
            (0, 0.08 * side, up),
        )
        for side in (-1, 1)
    )
    eye = (loop + 0.2, 0, up - 0.62 - loop)
    reach = capsule((0, 0, up - 0.1), (0.3, 0, up - 0.62), 0.12)
    return {
        "blades": join(*halves),
        "handles": both(join(ring(eye, loop, 0.115, axis=1), reach)),
        "screw": tube((0, -0.24, up), (0, 0.24, up), 0.11),
    }


def broom(draw: Draw) -> Parts:
    """It stands on its bristles; flat, or round as a witch's."""
    top, low, neck, high = draw(2.8, 3.1), draw(0.36, 0.44), draw(0.13, 0.16), draw(0.75, 0.9)
    if draw.chance(0.35):
        shape = [(low * 0.66, 0), (low * 0.74, high * 0.4), (0.09, high + 0.1)]
        bristles, tie = (
            lathe(smooth_curve(shape, 4), 0.02),
            tube((0, 0, high - 0.16), (0, 0, high + 0.06), 0.155, 0.03),
        )
    else:
        fan = smooth_curve([(low, 0), (low * 0.88, high * 0.45), (neck * 1.6, high * 0.86)], 3)
        notch = (box((low * u, 0, 0), (0.028, 1, 0.14)) for u in (-0.6, -0.2, 0.2, 0.6))
        bristles = cut(prism(mirrored([*fan, (neck, high)]), 1, 0.1), *notch)
        tie = box((0, 0, high), (neck + 0.04, 0.12, 0.11), 0.04)
    return {
        "bristles": bristles,
        "band": tie,
        "handle": tube((0, 0, high - 0.1), (0, 0, top), draw(0.05, 0.056), 0.02),
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


def fire_extinguisher(draw: Draw) -> Parts:
    """A bottle with a lever, a hose to the right and a label."""
    r, high, side = draw(0.38, 0.46), draw(1.35, 1.6), draw(0.26, 0.4)
    shape = [(r * 0.94, 0.0), (r, 0.1), (r, high - 0.25), (r * 0.7, high), (0.15, high + 0.1)]
    x, low = r + 0.14, high * draw(0.3, 0.45)
    hose = join(
        capsule((0, 0, high + 0.22), (x, 0, high + 0.1), 0.1),
        capsule((x, 0, high + 0.1), (x + 0.02, 0, low + 0.3), 0.1),
    )
    lever = join(
        capsule((0, 0, high + 0.26), (0, side, high + 0.28), 0.1),
        capsule((0, 0, high + 0.4), (0, side + 0.12, high + 0.62), 0.1),
    )
    return {
        "body": lathe(shape, 0.02),
        "hose": hose,
        "nozzle": lathe([(0.2, low), (0.11, low + 0.42)], 0.02, (x + 0.02, 0)),
        "lever": join(lever, tube((0, 0, high), (0, 0, high + 0.46), 0.16, 0.03)),
        "label": cut(
            tube((0, 0, high * 0.3), (0, 0, high * 0.68), r + 0.045), box((0, 1.9, 0), (3, 2, 3))
        ),
        "base": tube((0, 0, -0.02), (0, 0, 0.14), r + 0.05, 0.04),
    }


def knife(draw: Draw) -> Parts:
    """A kitchen knife, its point up and its edge to the left."""
    grip, long, wide, y = draw(0.85, 1.0), draw(1.4, 1.8), draw(0.2, 0.3), draw(0.07, 0.085)
    top = grip + long
    curve = smooth_curve(
        [(-wide + 0.08, grip + 0.02), (-wide + 0.085, grip + long * 0.5), (0.035, top)], 4
    )
    blade = [(0.09, grip), *curve, (0.09, top - 0.1 if draw.chance(0.5) else top - long * 0.4)]
    handle = [
        (-0.09, 0.0),
        (0.115, 0.0),
        (0.09, grip * 0.5),
        (0.1, grip + 0.05),
        (-0.08, grip + 0.05),
    ]
    return {
        "blade": prism(blade, 1, 0.05),
        "handle": prism([*handle, (-0.06, grip * 0.5)], 1, y),
        "rivets": join(
            *(
                tube((0.015, -y - 0.02, grip * v), (0.015, y + 0.02, grip * v), 0.07)
                for v in (0.2, 0.5, 0.8)
            )
        ),
    }


def fork(draw: Draw) -> Parts:
    """A table fork, its three tines up."""
    high, tine, w = draw(1.4, 1.6), draw(0.66, 0.78), 0.06
    pitch = 2 * w + draw(0.08, 0.095)
    wide, palm, foot = pitch, high + 0.34, draw(0.11, 0.14)
    tip = palm + tine
    side = [(0.07, high - 0.06), (wide + w, palm - 0.16), (wide + w, palm + 0.04)]
    half = [(w, palm), (w, tip - 0.16), (0.035, tip)]
    tines = (prism([(u + k * pitch, v) for u, v in mirrored(half)], 1, 0.055) for k in (-1, 0, 1))
    grip = [(foot - 0.03, 0), (foot, 0.1), (foot, 0.2), (0.07, high - 0.2), (0.07, high + 0.06)]
    return {
        "head": join(prism(mirrored(side), 1, 0.055), *tines),
        "handle": prism(mirrored(grip), 1, 0.065),
    }


def spoon(draw: Draw) -> Parts:
    """A spoon, its bowl up and open to the front; some are of wood with a round handle."""
    high, wide, deep = draw(1.6, 1.9), draw(0.25, 0.31), draw(0.42, 0.5)
    z, foot = high + deep * 0.85, draw(0.1, 0.14)
    bowl = cut(egg((0, 0, z), (wide, 0.19, deep)), box((0, -1, z), (2, 1, 2)))
    dent = egg((0, 0.0, z), (wide - 0.06, 0.1, deep - 0.09))
    grip = smooth_curve(
        [(foot * 0.8, 0), (foot, 0.15), (0.07, high * 0.7), (0.075, high + 0.12)], 3
    )
    flat = prism([*grip, *((-u, v) for u, v in reversed(grip))], 1, 0.06, 0.06)
    rod = taper((0, 0.08, 0.12), (0, 0.08, high), 0.1, 0.075)
    return {"bowl": cut(bowl, dent), "handle": flat if draw.chance(0.6) else rod}


def watering_can(draw: Draw) -> Parts:
    """Its spout to the left, its handle to the right."""
    r, high, reach = draw(0.55, 0.68), draw(0.9, 1.15), draw(0.65, 0.8)
    hole = egg((0, 0, high + 0.02), (r * 0.75, r * 0.75, 0.3))
    tip = (-r - reach, 0, high + draw(0.1, 0.35))
    rose = (tip[0] - 0.1, 0, tip[2] + 0.12)
    if draw.chance(0.5):  # behind it, or over it
        bow = cut(
            ring((r * 0.8, 0, high * 0.56), high * 0.4, 0.11, axis=1),
            tube((0, 0, 0), (0, 0, 3), r - 0.06),
        )
    else:
        bow = cut(
            ring((0, 0, high - 0.05), r * 0.8, 0.11, axis=1), box((0, 0, high - 1.1), (2, 2, 1))
        )
    parts = {
        "body": cut(lathe([(r, 0), (r * draw(0.82, 1.0), high)], 0.03), hole),
        "spout": taper((-r * 0.7, 0, 0.28), tip, 0.18, 0.11),
        "handle": bow,
        "rose": taper(tip, rose, 0.13, 0.26),
        "band": tube((0, 0, high * 0.1), (0, 0, high * 0.24), r + 0.06, 0.03),
    }
    return {name: moved(solid, (0.35, 0, 0)) for name, solid in parts.items()}


def rolling_pin(draw: Draw) -> Parts:
    """It lies along x."""
    half, r, grip = draw(0.75, 0.9), draw(0.26, 0.36), draw(0.12, 0.16)
    knob = taper((half + 0.1, 0, r), (half + draw(0.4, 0.5), 0, r), grip * 0.8, grip * 1.15)
    return {
        "body": tube((-half, 0, r), (half, 0, r), r, 0.06),
        "handles": both(knob),
        "collars": both(tube((half - 0.02, 0, r), (half + 0.1, 0, r), grip * 1.25, 0.02)),
    }


TOOLS = {
    "screwdriver": screwdriver,
    "wrench": wrench,
    "shovel": shovel,
    "pickaxe": pickaxe,
    "saw": saw,
    "paintbrush": paintbrush,
    "pencil": pencil,
    "scissors": scissors,
    "broom": broom,
    "toolbox": toolbox,
    "fire extinguisher": fire_extinguisher,
    "knife": knife,
    "fork": fork,
    "spoon": spoon,
    "watering can": watering_can,
    "rolling pin": rolling_pin,
}
GEAR = TOOLS | TOYS
