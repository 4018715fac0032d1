"""Instruments of laboratories, doctors and travellers."""

import math
from itertools import pairwise

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
    ball,
    both,
    box,
    capsule,
    cut,
    egg,
    join,
    lathe,
    limb,
    moved,
    prism,
    ring,
    smooth_curve,
    tube,
    turned,
)


def molecule(draw: Draw) -> Parts:
    """Water's: a large atom and two smaller ones; or a larger molecule of balls and sticks."""
    big, small = draw(0.5, 0.56), draw(0.34, 0.38)
    if draw.chance(0.5):
        a, far = math.radians(draw(50, 54)), draw(0.95, 1.05)
        at = (far * math.sin(a), 0.0, -far * math.cos(a))
        return {
            "core": moved(ball((0, 0, 0), big), (0, 0, 1.2)),
            "atoms": moved(both(ball(at, small)), (0, 0, 1.2)),
            "bonds": moved(both(capsule((0, 0, 0), at, 0.13)), (0, 0, 1.2)),
        }
    far = draw(0.92, 1.0)
    tips = [(0.0, 0.0, far)]
    low = math.radians(109.5)
    for k in range(3):
        t = math.radians(120 * k - 90)
        u = far * math.sin(low)
        tips.append((u * math.cos(t), u * math.sin(t), far * math.cos(low)))
    return {
        "core": moved(ball((0, 0, 0), big * 0.8), (0, 0, 0.7)),
        "atoms": moved(join(*(ball(tip, small * 0.8) for tip in tips)), (0, 0, 0.7)),
        "bonds": moved(join(*(capsule((0, 0, 0), tip, 0.11) for tip in tips)), (0, 0, 0.7)),
    }


def magnet(draw: Draw) -> Parts:
    """A horseshoe on its bend, its two poles up."""
    out, thick, y = draw(0.92, 1.02), draw(0.4, 0.48), draw(0.24, 0.3)
    leg, tip, gap = draw(0.72, 0.88), draw(0.34, 0.42), draw(0.02, 0.05)
    inner, top = out - thick, out + leg

    def arc(r: float, turn: int) -> list[tuple[float, float]]:
        angles = [math.pi * k / 20 for k in range(21)][::turn]
        return [(r * math.cos(a), out - r * math.sin(a)) for a in angles]

    bow = [(out, top), *arc(out, 1), (-out, top), (-inner, top), *arc(inner, -1), (inner, top)]
    middle = (out + inner) / 2
    pole = box((middle, 0, top + tip / 2), (thick / 2, y, tip / 2 + 0.01))
    seam = box((middle, 0, top), (thick / 2 + 0.03, y + 0.03, 0.06 + gap))
    return {"body": prism(bow, 1, y), "poles": both(pole), "bands": both(seam)}


def flask(draw: Draw) -> Parts:
    """An Erlenmeyer flask of the laboratory, with liquid and marks of its volume."""
    low, neck, high = draw(0.85, 0.98), draw(0.24, 0.29), draw(1.3, 1.5)
    top, fill = high + draw(0.5, 0.65), draw(0.42, 0.55) * high

    def radius(z: float) -> float:
        return low + (neck - low) * (z - 0.12) / (high - 0.12)

    marks = []
    for k, wide in enumerate((0.2, 0.13, 0.2)):
        z = fill + (high - fill) * (0.12 + 0.27 * k)
        marks.append(box((0, -radius(z), z), (wide, 0.06, 0.05)))
    return {
        "glass": lathe([(radius(fill), fill), (neck, high), (neck, top)], 0.0),
        "liquid": lathe([(low - 0.06, 0.0), (low, 0.06), (low, 0.12), (radius(fill), fill)], 0.012),
        "rim": ring((0, 0, top), neck + 0.01, 0.085),
        "marks": join(*marks),
    }


def syringe(draw: Draw) -> Parts:
    """Upright on its plunger, the needle up, half full."""
    r, stroke, long = draw(0.26, 0.31), draw(0.6, 0.75), draw(1.25, 1.4)
    wing, fill, needle = draw(0.55, 0.65), draw(0.42, 0.58), draw(0.5, 0.6)
    low, top, middle = stroke, stroke + long, stroke + long * fill
    hub = top + 0.26
    marks = [
        box((0, -r, low + long * s), (wide, 0.06, 0.045))
        for s, wide in ((0.26, 0.16), (0.45, 0.1), (0.64, 0.16), (0.83, 0.1))
    ]
    return {
        "barrel": join(
            tube((0, 0, low), (0, 0, middle), r),
            box((0, 0, low), (wing, 0.2, 0.09), 0.03),
        ),
        "liquid": lathe([(r, middle), (r, top), (0.15, top + 0.14)], 0.01),
        "plunger": join(
            tube((0, 0, 0), (0, 0, 0.16), r + 0.08, 0.04),
            tube((0, 0, 0.1), (0, 0, low), 0.13),
        ),
        "marks": join(*marks),
        "hub": lathe([(0.14, top + 0.06), (0.11, hub + 0.06)], 0.01),
        "needle": lathe([(0.075, hub), (0.07, hub + needle * 0.7), (0.02, hub + needle)], 0.01),
    }


def stethoscope(draw: Draw) -> Parts:
    """Upright like its own sign: two ear pieces, a tube in a Y that curls up to the chest piece."""
    wide, high, fork = draw(0.44, 0.54), draw(1.9, 2.1), draw(0.92, 1.04)
    r, x, drop = 0.088, draw(0.74, 0.86), draw(0.6, 0.72)
    neck = high - 0.62
    side = [(0.0, fork - 0.04), (0.16, fork + 0.14), (wide, fork + 0.34), (wide + 0.04, neck)]
    bow = [(wide + 0.04, neck), (wide, neck + 0.3), (wide * 0.66, high - 0.1), (0.2, high)]
    tail = [(0.0, fork), (0.0, 0.46), (0.1, 0.2), (x * 0.5, 0.09), (x - 0.08, 0.22), (x, drop)]

    def bar(points: list[tuple[float, float]], radius: float) -> Solid:
        return limb([(u, 0, v) for u, v in smooth_curve(points, 3)], radius, radius)

    chest = (x, drop + 0.2)
    (u, v), disc = chest, draw(0.25, 0.3)
    return {
        "tube": join(both(bar(side, r)), bar(tail, r), ball((0, 0, fork), 0.13)),
        "ear tubes": both(bar(bow, 0.075)),
        "tips": both(egg((0.19, 0, high), (0.15, 0.13, 0.13))),
        "chest piece": join(
            tube((u, -0.13, v), (u, 0.12, v), disc, 0.03),
            tube((u, 0, drop - 0.16), (u, 0, v), 0.12),
        ),
        "disc": tube((u, -0.18, v), (u, 0, v), disc - 0.07, 0.02),
        "collars": both(
            tube((wide + 0.04, 0, neck - 0.06), (wide + 0.04, 0, neck + 0.1), 0.12, 0.02)
        ),
    }


def first_aid_kit(draw: Draw) -> Parts:
    """A case that stands, a cross on its front, with a handle, latches and a band."""
    wide, deep, high = draw(0.82, 0.94), draw(0.32, 0.42), draw(0.56, 0.64)
    size, arm, corner = high * draw(0.56, 0.64), draw(0.13, 0.16), draw(0.1, 0.2)
    seam = high * 2 * 0.74
    plus = join(
        *(box((0, 0, high * 0.92), (a, deep + 0.06, b)) for a, b in ((size, arm), (arm, size)))
    )
    grip = [(0.4, 0, 2 * high - 0.06), (0.36, 0, 2 * high + 0.22), (0, 0, 2 * high + 0.25)]
    latch = box((wide * 0.66, -deep - 0.02, seam), (0.12, 0.08, 0.17), 0.02)
    foot = box((wide * 0.74, 0, 0), (0.14, deep * 0.7, 0.07), 0.02)
    return {
        "body": box((0, 0, high), (wide, deep, high), corner),
        "cross": plus,
        "handle": both(limb(grip, 0.09, 0.09)),
        "latches": both(latch),
        "band": cut(
            box((0, 0, seam), (wide + 0.045, deep + 0.045, 0.065), 0.02),
            box((0, -deep, high), (size + 0.09, 0.3, size + 0.09)),
        ),
        "feet": both(foot),
    }


def binoculars(draw: Draw) -> Parts:
    """Two barrels, wider at the front, joined by a hinge with a wheel; lenses at their ends."""
    x, r, long = draw(0.52, 0.6), draw(0.4, 0.46), draw(0.8, 0.95)
    small, z = draw(0.3, 0.34), 0.46
    front, back = -long - 0.3, long

    def along(start: float, end: float, radius: float, rounding: float = 0.03) -> Solid:
        return both(tube((x, start, z), (x, end, z), radius, rounding))

    shape = [(small, -back), (small + 0.02, 0.05), (r, 0.34), (r, -front)]
    barrel = moved(turned(lathe(shape, 0.02), 0, 90), (x, 0, z))
    return {
        "barrels": both(barrel),
        "rims": join(
            along(front - 0.06, front + 0.18, r + 0.06),
            along(back - 0.3, back - 0.14, small + 0.06),
        ),
        "lenses": along(front - 0.1, front + 0.1, r - 0.09, 0.02),
        "eyepieces": along(back - 0.06, back + 0.3, small + 0.03, 0.08),
        "bridge": join(
            box((0, 0.3, z + 0.05), (x, 0.15, 0.15), 0.05),
            box((0, -0.36, z), (x, 0.14, 0.14), 0.05),
            tube((0, -0.5, z + 0.06), (0, 0.6, z + 0.06), 0.13, 0.03),
        ),
        "wheel": tube((0, 0.5, z + 0.08), (0, 0.78, z + 0.08), 0.21, 0.04),
    }  # fmt: skip


def spyglass(draw: Draw) -> Parts:
    """It lies along x, drawn out, its lens to the left: a barrel and two narrower tubes."""
    r, long = draw(0.225, 0.255), draw(1.02, 1.16)
    mid, last = draw(0.54, 0.66), draw(0.46, 0.58)
    radii, up = (r, r - 0.055, r - 0.11), r + 0.09
    ends = (long, long + mid, long + mid + last)
    whole = ends[2] + 0.14

    def lying(solid: Solid) -> Solid:
        """What was turned about z, its foot to the left."""
        return moved(turned(solid, 1, 90), (-whole / 2, 0, up))

    def band(low: float, high: float, radius: float) -> Solid:
        return tube((0, 0, low), (0, 0, high), radius, 0.03)

    mouth = tube((0, 0, -1), (0, 0, 0.14), r - 0.04)
    return {
        "barrel": lying(lathe([(r + 0.02, 0.1), (r - 0.01, ends[0])])),
        "tubes": lying(
            join(
                tube((0, 0, 0.5), (0, 0, ends[1]), radii[1]),
                tube((0, 0, 1.0), (0, 0, ends[2]), radii[2]),
            )
        ),
        "bands": lying(
            join(
                cut(band(0, 0.26, r + 0.09), mouth),
                band(ends[0] - 0.1, ends[0] + 0.08, r + 0.08),
                band(ends[1] - 0.1, ends[1] + 0.08, radii[1] + 0.08),
            )
        ),
        "lens": lying(egg((0, 0, 0.17), (r, r, 0.13))),
        "eyepiece": lying(lathe([(radii[2] + 0.03, ends[2] - 0.1), (radii[2] + 0.1, whole)], 0.02)),
    }


def pocket_watch(draw: Draw) -> Parts:
    """Upright, its dial to the front, a bow about its crown, from which a chain may hang."""
    r, deep, neck = draw(0.9, 0.96), draw(0.24, 0.28), 0.3
    top, bow, lip = r + 0.36, draw(0.4, 0.43), 0.1
    back = [(0.0, -deep - 0.12), (r * 0.5, -deep - 0.08), (r * 0.8, -deep + 0.04), (r, -0.02)]
    case = [*smooth_curve(back), (r, 0.08)]
    bezel = [(r - 0.02, -0.1), (r + 0.07, 0.0), (r + 0.07, 0.14), (r - 0.04, 0.3), (r - 0.14, 0.3)]
    inner = [(r - 0.22, 0.0), (r - 0.22, 0.14), (r - 0.08, 0.36)]

    def hand(long: float, wide: float, turn: float) -> Solid:
        leaf = [(-0.09, -0.12), (0.09, -0.12), (wide, long * 0.62), (0.06, long), (-0.06, long),
                (-wide, long * 0.62)]  # fmt: skip
        return turned(prism(leaf, 1, 0.1, -0.16), 1, turn)

    def facing(solid: Solid) -> Solid:
        return turned(solid, 0, 90)

    parts = {
        "case": facing(lathe(case)),
        "face": facing(tube((0, 0, -0.06), (0, 0, 0.16), r - 0.14)),
        "hands": join(
            hand(r * 0.48, 0.15, -60),
            hand(r * 0.7, 0.13, 60),
            tube((0, -0.31, 0), (0, -0.1, 0), 0.14, 0.02),
        ),
        "rim": facing(cut(lathe(bezel), lathe(inner))),
        "crown": join(
            lathe([(neck + 0.04, r - 0.12), (neck - 0.04, r + 0.1), (0.12, r + 0.18)]),
            lathe([(0.13, r + 0.1), (0.2, r + 0.26), (0.2, r + 0.42), (0.12, r + 0.5)]),
            ring((0, 0, top), bow, lip, 1),
        ),
    }
    if draw.chance(0.5):
        far = [(0.44, top + bow - 0.02), (0.92, top + bow - 0.12), (1.24, top + bow - 0.48)]
        links = (ring((u, 0, w), 0.2, 0.1, 1) for u, w in far)
        bars = (
            capsule((u, 0, w), (s, 0, v), 0.1)
            for (u, w), (s, v) in pairwise([(0.1, top + bow), *far])
        )
        eyes = (tube((u, -1, w), (u, 1, w), 0.12) for u, w in far)
        parts["chain"] = join(cut(join(*bars), *eyes), *links)
    return parts


LABORATORY = {
    "molecule": molecule,
    "magnet": magnet,
    "flask": flask,
    "syringe": syringe,
    "stethoscope": stethoscope,
    "first aid kit": first_aid_kit,
    "binoculars": binoculars,
    "spyglass": spyglass,
    "pocket watch": pocket_watch,
}
