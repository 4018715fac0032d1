"""Small tools and instruments, a hammock and a gong."""

import math

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
    Vector,
    around,
    ball,
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
    tube,
    turned,
    within,
)


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


def screw(draw: Draw) -> Parts:
    """Point down, a cross in its head, a thread about its shaft."""
    head, cap, r = draw(0.54, 0.62), draw(0.26, 0.32), draw(0.22, 0.26)
    tip, long, out = draw(0.42, 0.55), draw(1.5, 1.7), draw(0.13, 0.16)
    top = tip + long
    turns, pitch = 5, (long * 0.8) / 5
    side = []
    for k in range(turns):
        z = tip * 0.72 + pitch * k
        wide = r * (0.75 if k == 0 else 1)
        side += [(wide, z), (wide + out, z + pitch * 0.3), (wide + out, z + pitch * 0.42)]
        side += [(wide, z + pitch * 0.72)]
    cross = join(
        box((0, 0, top + cap), (head * 0.6, 0.1, 0.12)),
        box((0, 0, top + cap), (0.1, head * 0.6, 0.12)),
    )
    return {
        "head": cut(
            lathe(
                [(r, top - 0.3), (head, top + 0.02), (head, top + 0.1), (head * 0.72, top + cap)]
            ),
            cross,
        ),
        "shaft": lathe([(0.02, 0.0), (r * 0.8, tip), (r, tip + 0.1), (r, top)], 0.01),
        "thread": lathe(side),
    }


def rake(draw: Draw) -> Parts:
    """Upright on its tines, a long shaft up from the middle of its bar."""
    x, high, tine = draw(0.72, 0.82), draw(2.5, 2.7), draw(0.34, 0.42)
    count, z, socket = 6, tine + 0.04, draw(0.34, 0.42)
    grip, y = draw(0.6, 0.75), -0.06
    tines = [
        lathe([(0.04, 0.0), (0.085, tine * 0.5), (0.085, z)], 0.0, (x * (2 * k / 5 - 1), y))
        for k in range(count)
    ]
    return {
        "tines": join(*tines),
        "bar": box((0, y, z), (x + 0.1, 0.11, 0.1), 0.02),
        "socket": lathe([(0.19, z), (0.12, z + socket)], 0.01),
        "handle": tube((0, 0, z + 0.1), (0, 0, high), 0.095, 0.03),
        "grip": tube((0, 0, high - grip), (0, 0, high + 0.02), 0.12, 0.04),
    }


def maracas(draw: Draw) -> Parts:
    """A pair, crossed: round heads with a thick belt and a cap, on handles with a knob."""
    lean, wide, long = draw(36, 40), draw(0.43, 0.47), draw(0.52, 0.57)
    grip, apart = draw(1.16, 1.26), draw(0.34, 0.38)
    z = grip + long * 0.8

    def crossed(solid: Solid) -> Solid:
        return join(
            *(moved(turned(solid, 1, -side * lean), (side * apart, 0, 0.2)) for side in (-1, 1))
        )

    def head(more: float) -> Solid:
        return egg((0, 0, z), (wide + more, wide + more, long + more))

    handle = [(0.11, 0.0), (0.13, grip * 0.5), (0.17, grip), (0.2, grip + 0.1)]
    return {
        "heads": crossed(head(0.0)),
        "bands": crossed(tube((0, 0, z - 0.15), (0, 0, z + 0.15), wide + 0.085, 0.03)),
        "tops": crossed(within(head(0.06), box((0, 0, z + long * 0.7 + 1), (1, 1, 1)))),
        "handles": crossed(lathe(handle, 0.01)),
        "knobs": crossed(ball((0, 0, 0), 0.2)),
    }


def megaphone(draw: Draw) -> Parts:
    """On its grip, the horn to -X."""
    wide, long, neck = draw(0.68, 0.78), draw(1.1, 1.25), draw(0.24, 0.28)
    back, z, grip = draw(0.42, 0.52), draw(1.02, 1.12), draw(0.16, 0.19)

    def level(solid: Solid) -> Solid:
        """Made upwards along z, laid along -X."""
        return moved(turned(solid, 1, -90), (0.15, 0, z))

    bell = lathe([(neck, -0.05), (wide, long)])
    hollow = lathe([(neck * 0.35, 0.4), (wide - 0.12, long + 0.05)])
    return {
        "horn": level(cut(bell, hollow)),
        "rim": level(ring((0, 0, long), wide - 0.05, 0.1)),
        "body": level(lathe([(neck + 0.1, -back), (neck + 0.07, 0.04)], 0.03)),
        "cap": level(tube((0, 0, -back - 0.18), (0, 0, -back + 0.02), neck + 0.02, 0.03)),
        "handle": join(
            box((0.32, 0, z / 2), (grip, 0.15, z / 2), 0.05),
            box((0.32, 0, 0.09), (grip + 0.08, 0.2, 0.09), 0.03),
        ),
        "trigger": box((0.32 - grip - 0.05, 0, z - 0.62), (0.1, 0.09, 0.14), 0.02),
    }


def hammock(draw: Draw) -> Parts:
    """A cloth that sags between two posts, striped along it; a bar at each end, ropes to it."""
    x, high, y, sag = draw(1.17, 1.22), draw(1.04, 1.11), draw(0.39, 0.43), draw(0.53, 0.59)
    reach, thick = x - 0.38, 0.065
    low = high - sag - 0.15
    bar: Vector = (reach, 0, low + sag)

    def cloth(out: float) -> list[tuple[float, float]]:
        us = [reach * (k / 10 - 1) for k in range(21)]
        curve = [(u, low + sag * (u / reach) ** 2) for u in us]
        return [(u, v + out) for u, v in curve] + [(u, v - out) for u, v in curve[::-1]]

    hook = (x - 0.03, 0.0, high + 0.04)
    return {
        "cloth": prism(cloth(thick), 1, y),
        "stripes": both(prism(cloth(thick + 0.06), 1, y * 0.17, y * 0.56), 1),
        "bars": both(tube((reach, -y - 0.09, bar[2]), (reach, y + 0.09, bar[2]), 0.14, 0.04)),
        "ropes": both(both(capsule((reach, y - 0.04, bar[2]), hook, 0.055), 1)),
        "posts": both(tube((x - 0.08, 0, 0.08), (x, 0, high + 0.22), 0.12, 0.04)),
        "base": both(lathe([(0.36, 0), (0.33, 0.09), (0.17, 0.19)], 0.02, (x - 0.08, 0))),
    }


def gong(draw: Draw) -> Parts:
    """A disc of bronze that hangs in a frame."""
    r, high = draw(0.7, 0.78), draw(2.45, 2.6)
    boss, foot, over = draw(0.22, 0.28), draw(0.42, 0.52), draw(0.2, 0.26)
    x = r + draw(0.36, 0.42)
    z = high - 0.3 - r
    beam = box((0, 0, high), (x + over, 0.13, 0.12), 0.02)
    tip = box((x + over, 0, high + 0.06), (0.1, 0.16, 0.18), 0.03)
    return {
        "disc": tube((0, -0.1, z), (0, 0.1, z), r, 0.02),
        "rim": ring((0, 0, z), r - 0.02, 0.12, 1),
        "boss": egg((0, -0.1, z), (boss, 0.14, boss)),
        "ropes": both(tube((r * 0.5, 0, z + r * 0.8), (r * 0.5, 0, high), 0.075)),
        "frame": join(
            beam,
            both(join(tip, box((x, 0, high / 2), (0.12, 0.12, high / 2)))),
            box((0, 0, 0.2), (x, 0.09, 0.1)),
        ),
        "feet": both(box((x, 0, 0.1), (0.17, foot, 0.1), 0.03)),
    }


def pipe(draw: Draw) -> Parts:
    """A tee of a water pipe, with a flange and its bolts at each of three ends."""
    r, x, high = draw(0.36, 0.42), draw(1.02, 1.15), draw(0.95, 1.1)
    wide, thick, bolt = r + draw(0.22, 0.27), draw(0.17, 0.21), draw(0.09, 0.1)
    bore, z = r - 0.15, high
    at = (r + wide) / 2 + 0.01

    def standing(from_z: float, to_z: float, radius: float) -> Solid:
        return tube((0, 0, from_z), (0, 0, to_z), radius)

    def side(solid: Solid) -> Solid:
        """Made upwards from the crossing, laid to both sides."""
        return both(moved(turned(solid, 1, 90), (0, 0, z)))

    nuts = around(6, tube((at, 0, -0.07), (at, 0, thick + 0.07), bolt), 30)
    mouth = standing(r + 0.3, 3, bore)
    return {
        "pipe": join(
            side(cut(standing(-0.05, x, r), mouth)), standing(0, z, r), ball((0, 0, z), r + 0.02)
        ),
        "flanges": join(
            side(cut(standing(x - thick, x, wide), mouth)),
            standing(0, thick, wide),
        ),
        "bolts": join(side(moved(nuts, (0, 0, x - thick))), moved(nuts, (0, 0, 0.0))),
        "bands": join(
            side(standing(r + 0.02, r + 0.2, r + 0.07)),
            standing(z - r - 0.2, z - r - 0.02, r + 0.07),
        ),
    }


def finger_ring(draw: Draw) -> Parts:
    """A band that stands upright; on it a cut gem in its setting, alone or between two small ones,
    or a plate with a flat one."""
    r, thick, wide = draw(0.96, 1.06), draw(0.15, 0.2), draw(0.2, 0.28)
    band = cut(
        tube((0, -wide, r + thick), (0, wide, r + thick), r + thick, 0.08),
        tube((0, -2, r + thick), (0, 2, r + thick), r - 0.06),
    )
    top = 2 * (r + thick) - 0.06
    kind = draw.which(3)
    if kind == 2:
        plate = tube((0, 0, top - 0.14), (0, 0, top + 0.14), draw(0.42, 0.52), 0.05)
        gem = tube((0, 0, top), (0, 0, top + 0.24), 0.3, 0.03)
        return {"band": band, "setting": plate, "gem": gem}
    size = draw(0.36, 0.46)
    gem = lathe([(0.06, top + 0.02), (size, top + size * 0.8), (size * 0.62, top + size * 1.24)])
    setting = lathe([(0.16, top - 0.12), (size * 0.74, top + size * 0.52)], 0.04)
    if kind == 1:
        at = (size * 0.98, 0, top - 0.06)
        gem = join(gem, both(egg(at, (0.2, 0.2, 0.17))))
    return {"band": band, "setting": setting, "gem": gem}


SMALL_THINGS = {
    "syringe": syringe,
    "magnet": magnet,
    "screw": screw,
    "rake": rake,
    "maracas": maracas,
    "megaphone": megaphone,
    "hammock": hammock,
    "gong": gong,
    "pipe": pipe,
    "ring": finger_ring,
}
