"""Tools of the desk and the kitchen, and optical instruments."""

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
    mirrored,
    moved,
    prism,
    ring,
    smooth_curve,
    taper,
    tube,
    turned,
)


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


def stapler(draw: Draw) -> Parts:
    """Its jaws open to the left, its hinge at the right."""
    long, y, gape = draw(1.15, 1.28), draw(0.24, 0.29), draw(9, 13)
    thick = draw(0.3, 0.36)
    hinge = (long - 0.2, 0.3)
    side = [(-1.98 * long + 0.2, -0.02), (0.26, -0.02), (0.26, thick * 0.8), (0.1, thick * 1.16)]
    side += [(-long * 0.8, thick * 1.24), (-1.8 * long, thick * 0.8)]
    at = (hinge[0], 0, hinge[1])

    def jaw(solid: Solid) -> Solid:
        return moved(turned(solid, 1, gape), at)

    return {
        "body": jaw(prism(smooth_curve(side[2:], 2) + side[:2], 1, y)),
        "magazine": jaw(box((-long * 0.9 + 0.06, 0, -0.1), (long * 0.9, y * 0.72, 0.13), 0.02)),
        "base": box((0, 0, 0.09), (long, y + 0.04, 0.09), 0.04),
        "hinge": join(
            box((hinge[0], 0, 0.26), (0.24, y + 0.03, 0.24), 0.04),
            tube((hinge[0], -y - 0.06, 0.34), (hinge[0], y + 0.06, 0.34), 0.11, 0.02),
        ),
        "plate": box((-long * 0.78, 0, 0.17), (0.17, y * 0.7, 0.06), 0.02),
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


def rolling_pin(draw: Draw) -> Parts:
    """It lies along x."""
    half, r, grip = draw(0.75, 0.9), draw(0.26, 0.36), draw(0.12, 0.16)
    knob = taper((half + 0.1, 0, r), (half + draw(0.4, 0.5), 0, r), grip * 0.8, grip * 1.15)
    return {
        "body": tube((-half, 0, r), (half, 0, r), r, 0.06),
        "handles": both(knob),
        "collars": both(tube((half - 0.02, 0, r), (half + 0.1, 0, r), grip * 1.25, 0.02)),
    }


def magnifying_glass(draw: Draw) -> Parts:
    """Upright, its glass above its handle."""
    r, long, thick = draw(0.6, 0.72), draw(0.95, 1.2), draw(0.11, 0.13)
    z = long + 0.28 + r
    return {
        "rim": join(ring((0, 0, z), r, thick, 1), tube((0, 0, long), (0, 0, z - r), 0.1)),
        "glass": egg((0, 0, z), (r + 0.02, draw(0.11, 0.15), r + 0.02)),
        "handle": join(
            taper((0, 0, 0.14), (0, 0, long - 0.1), 0.15, 0.12), ball((0, 0, 0.14), 0.155)
        ),
        "collar": tube((0, 0, long - 0.16), (0, 0, long + 0.08), 0.15, 0.03),
    }


def microscope(draw: Draw) -> Parts:
    """Its stage to the front, its arm behind, its eyepiece tipped to the back."""
    x, back, stage, lean = draw(0.44, 0.54), draw(0.5, 0.58), draw(0.72, 0.82), draw(18, 30)
    high = stage + draw(0.95, 1.1)
    arm = [
        (back - 0.2, 0.1),
        (back + 0.2, 0.1),
        (back + 0.24, high * 0.6),
        (back - 0.1, high + 0.22),
    ]
    arm += [
        (-0.3, high + 0.22),
        (-0.3, high - 0.1),
        (back - 0.3, high - 0.1),
        (back - 0.12, high * 0.6),
    ]
    tip = high + 0.16

    def tipped(solid: Solid) -> Solid:
        return moved(turned(solid, 0, -lean), (0, -0.06, tip))

    return {
        "base": join(
            box((0, 0.04, 0.1), (x, 0.72, 0.1), 0.05), box((0, -0.1, 0.25), (0.2, 0.2, 0.13), 0.04)
        ),
        "arm": prism(arm, 0, 0.17),
        "stage": box((0, 0.0, stage), (x * 0.9, 0.46, 0.09), 0.02),
        "tube": tipped(
            join(
                tube((0, 0, -0.1), (0, 0, 0.5), 0.16), tube((0, 0, -0.06), (0, 0, 0.1), 0.24, 0.03)
            )
        ),
        "eyepiece": tipped(tube((0, 0, 0.42), (0, 0, 0.72), 0.2, 0.03)),
        "lenses": join(
            tube((0, -0.06, high - 0.24), (0, -0.06, high), 0.25, 0.04),
            tube((0, -0.06, stage + 0.2), (0, -0.06, high - 0.1), 0.12, 0.02),
            both(taper((0.1, 0, high - 0.22), (0.24, 0.02, high - 0.44), 0.11, 0.09)),
        ),
        "knobs": join(
            tube((-0.38, back, stage * 0.55), (0.38, back, stage * 0.55), 0.2, 0.03),
            tube((-0.32, back + 0.1, high * 0.62), (0.32, back + 0.1, high * 0.62), 0.13, 0.02),
        ),
    }


def telescope(draw: Draw) -> Parts:
    """On three legs, aimed up and to the front."""
    long, r, high, up = draw(1.0, 1.15), draw(0.2, 0.25), draw(1.35, 1.55), draw(22, 38)

    def aimed(solid: Solid) -> Solid:
        # The tube is along y; its far end, at -y, goes up.
        return moved(turned(solid, 0, -up), (0, 0, high + 0.28))

    leg = taper((0.08, 0, high - 0.04), (draw(0.62, 0.75), 0, 0.1), 0.11, 0.09)
    return {
        "tube": aimed(
            join(
                tube((0, -long, 0), (0, 0.4, 0), r), tube((0, 0.3, 0), (0, long * 0.8, 0), r * 0.72)
            )
        ),
        "bands": aimed(
            join(
                tube((0, -long - 0.06, 0), (0, -long + 0.14, 0), r + 0.06, 0.02),
                tube((0, 0.28, 0), (0, 0.44, 0), r + 0.04, 0.02),
                tube((0, long * 0.74, 0), (0, long * 0.86, 0), r * 0.72 + 0.04, 0.02),
            )
        ),
        "eyepiece": aimed(
            join(
                tube((0, long * 0.8, 0), (0, long + 0.06, 0), 0.11),
                tube((0, long, 0), (0, long + 0.16, 0), 0.15, 0.03),
            )
        ),
        "lens": aimed(tube((0, -long - 0.08, 0), (0, -long + 0.2, 0), r - 0.02)),
        "tripod": join(around(3, leg, -90), lathe([(0.2, high - 0.16), (0.2, high + 0.06)], 0.02)),
        "mount": join(
            box((0, 0, high + 0.14), (0.12, 0.16, 0.22), 0.03),
            tube((-r - 0.12, 0, high + 0.28), (r + 0.12, 0, high + 0.28), 0.11, 0.02),
        ),
    }


HAND_TOOLS_HOUSEHOLD_AND_OPTICAL = {
    "pencil": pencil,
    "scissors": scissors,
    "stapler": stapler,
    "broom": broom,
    "watering can": watering_can,
    "fire extinguisher": fire_extinguisher,
    "knife": knife,
    "fork": fork,
    "spoon": spoon,
    "rolling pin": rolling_pin,
    "magnifying glass": magnifying_glass,
    "microscope": microscope,
    "telescope": telescope,
}
