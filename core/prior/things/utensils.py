"""Kitchen utensils, a jug and perfume."""

import math

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
    grown,
    join,
    lathe,
    limb,
    mirrored,
    prism,
    ring,
    smooth_curve,
    taper,
    tilted,
    tube,
    within,
)


def _faceted(sides: int, profile: list[tuple[float, float]]) -> Solid:
    """The profile (reach, height) about the vertical with flat sides, one of them to the front."""
    slab = prism([*profile, (-0.1, profile[-1][1]), (-0.1, profile[0][1])], 1, 4.0)
    return around(sides, slab, -90)


def _puck(r: float) -> Solid:
    return tube((0, 0, 0), (0, 0, 0.14), r, 0.03)


def perfume(draw: Draw) -> Parts:
    """A thick bottle with a label, a golden collar and a stopper; some with a bulb to spray by."""
    kind, high, x = draw.which(3), draw(0.98, 1.14), draw(0.66, 0.76)
    y, bulb = x * draw(0.5, 0.6), None
    if kind == 0:  # a block
        glass = join(
            box((0, 0, high / 2), (x, y, high / 2), 0.06),
            box((0, 0, high), (x * 0.5, y * 0.6, 0.1), 0.03),
        )
        label = box((0, -y, high * 0.5), (x * 0.58, 0.06, high * 0.24), 0.02)
        stopper = box((0, 0, high + 0.54), (0.34, 0.28, 0.27), 0.04)
    elif kind == 1:  # faceted like a gem
        cuts = [(x * 0.62, 0.0), (x, high * 0.34), (x * 0.86, high * 0.8), (0.3, high + 0.06)]
        glass = _faceted(8, cuts)
        label = within(
            box((0, -x, high * 0.56), (x * 0.28, 0.4, high * 0.19)),
            _faceted(8, [(r + 0.06, z) for r, z in cuts]),
        )
        stopper = _faceted(
            6, [(0.16, high + 0.24), (0.36, high + 0.5), (0.3, high + 0.74), (0.1, high + 0.92)]
        )
    else:  # round, with a bulb
        glass = join(egg((0, 0, high * 0.52), (x, y + 0.1, high * 0.52)), _puck(x * 0.6))
        label = tube((0, -y - 0.14, high * 0.5), (0, 0, high * 0.5), 0.3, 0.02)
        stopper = egg((0, 0, high + 0.48), (0.2, 0.2, 0.24))
    z = high + 0.3
    if kind == 2:
        hose = [(0.1, z), (0.46, z + 0.06), (0.78, z - 0.1), (0.98, z - 0.42)]
        bulb = join(
            limb([(u, 0, v) for u, v in smooth_curve(hose, 3)], 0.085, 0.085),
            egg((1.04, 0, z - 0.64), (0.26, 0.26, 0.33)),
            taper((1.04, 0, z - 0.98), (1.04, 0, z - 1.2), 0.085, 0.13),
        )
    spray = tube((-0.3, 0, z), (0, 0, z), 0.09, 0.02)
    neck = lathe([(0.27, high - 0.05), (0.27, high + 0.13), (0.2, high + 0.16), (0.2, high + 0.4)])
    parts = {
        "bottle": glass,
        "label": label,
        "collar": join(neck, spray) if kind == 2 else neck,
        "cap": stopper,
    }
    return parts | ({"bulb": bulb} if bulb else {})


def colander(draw: Draw) -> Parts:
    """Half a ball, white inside, with two rows of holes, on a foot, an ear at either side."""
    r, deep, wall = draw(0.84, 0.92), draw(0.82, 0.96), 0.17
    count, hole, low = 8, draw(0.14, 0.15), 0.12
    top, ear = low + deep, draw(0.2, 0.25)
    shell = cut(egg((0, 0, top), (r, r, deep)), box((0, 0, top + 1), (2, 2, 1)))
    inside = egg((0, 0, top + 0.02), (r - wall, r - wall, deep - wall))

    def row(down: float, first: float, size: float) -> Solid:
        """Holes towards the middle of the bowl, ``down`` degrees below its rim."""
        a = math.radians(down)
        out, sink = math.cos(a), math.sin(a)
        start = (out * 0.3, 0.0, top - sink * 0.3)
        end = (out * 1.4, 0.0, top - sink * 1.4)
        return around(count, tube(start, end, size), first)

    step, z = 360 / count, top - 0.03
    holes = join(row(25, 0, hole), row(52, step / 2, hole - 0.01))
    out = r + ear + 0.06
    loop = join(
        capsule((r - 0.02, -0.3, z), (out, -0.22, z), 0.085),
        capsule((r - 0.02, 0.3, z), (out, 0.22, z), 0.085),
        capsule((out, -0.22, z), (out, 0.22, z), 0.085),
    )
    return {
        "bowl": cut(shell, egg((0, 0, top + 0.02), (r - 0.09, r - 0.09, deep - 0.09)), holes),
        "lining": cut(within(grown(inside, 0.1), box((0, 0, top - 1), (2, 2, 1))), inside, holes),
        "rim": ring((0, 0, top), r - 0.03, 0.095),
        "handles": both(loop),
        "foot": cut(
            lathe([(r * 0.56, 0), (r * 0.5, low + 0.14)]),
            lathe([(r * 0.56 - 0.2, -0.1), (r * 0.56 - 0.2, low + 0.1)]),
            inside,
        ),
    }


def whisk(draw: Draw) -> Parts:
    """Its balloon of wires up, a collar, a handle with grips and a ring to hang it by."""
    wide, long, count = draw(0.68, 0.78), draw(1.3, 1.46), 6 + 2 * draw.chance(0.6)
    thick, high, r = 0.08, draw(0.8, 0.92), draw(0.15, 0.18)
    low = high + 0.3
    half = [(0.06, low - 0.1), (wide * 0.5, low + long * 0.28), (wide * 0.96, low + long * 0.58)]
    half += [(wide * 0.86, low + long * 0.84), (wide * 0.5, low + long * 0.97), (0.0, low + long)]
    wire = limb([(u, 0, v) for u, v in smooth_curve(half, 3)], thick, thick)
    bands = [ring((0, 0, high * f), r - 0.01, 0.07) for f in (0.34, 0.68)]
    return {
        "wires": around(count, wire),
        "collar": lathe([(r + 0.05, high - 0.08), (r + 0.05, low - 0.14), (0.13, low + 0.1)], 0.02),
        "handle": lathe(smooth_curve([(r * 0.8, 0.0), (r + 0.03, high * 0.4), (r * 0.9, high)])),
        "grips": join(*bands),
        "ring": ring((0, 0, -0.18), 0.2, 0.085, axis=1),
    }


def spatula(draw: Draw) -> Parts:
    """A turner, its slotted blade up and bent to the front, a long handle with a hole."""
    wide, high, y = draw(0.56, 0.64), draw(0.98, 1.12), 0.09
    count, slot = 2 + draw.which(2), draw(0.1, 0.115)
    grip, neck = draw(0.95, 1.05), draw(0.5, 0.6)
    z = grip + neck
    top = wide if count == 3 else wide * 0.92
    half = [(wide * 0.5, 0.0), (wide * 0.94, 0.14), (top, high - 0.1), (top - 0.1, high)]
    pitch = 2 * (top - 0.17 - slot) / (count - 1) if count == 3 else 0.44
    slots = [
        box((pitch * (k - (count - 1) / 2), 0, 0.22 + (high - 0.4) / 2 + 0.02), (slot, 1, 0.3))
        for k in range(count)
    ]
    blade = cut(prism(mirrored(half), 1, y), *slots)
    rod = limb([(0, 0, grip - 0.1), (0, 0.02, z - 0.2), (0, 0, z + 0.1)], 0.11, 0.11)
    handle = lathe(smooth_curve([(0.17, 0.0), (0.2, 0.2), (0.14, grip * 0.6), (0.16, grip)]), 0.02)
    hole = tube((0, -1, 0.2), (0, 1, 0.2), 0.1)
    return {
        "blade": tilted(blade, draw(8, 16), (0, 0, z)),
        "neck": join(rod, ball((0, 0, z + 0.08), 0.15)),
        "handle": cut(within(handle, box((0, 0, 0.5), (1, 0.14, 2))), hole),
        "collar": tube((0, 0, grip - 0.06), (0, 0, grip + 0.1), 0.19, 0.02),
    }


def smooth_arc(foot: tuple[float, float], rise: float) -> list[tuple[float, float, float]]:
    """A bow's half from its foot (x, z) up and over to the middle."""
    x, z = foot
    stops = [(x, z), (x * 0.98, z + rise * 0.6), (x * 0.6, z + rise * 0.96), (0.0, z + rise)]
    return [(u, 0.0, v) for u, v in smooth_curve(stops, 3)]


def grater(draw: Draw) -> Parts:
    """A box that narrows upwards, coarse teeth before, slits at the sides, a bow for a handle."""
    wide, top, high = draw(0.66, 0.74), draw(0.42, 0.48), draw(1.5, 1.64)
    deep, thin = wide * draw(0.68, 0.78), top * draw(0.62, 0.7)
    sides = [(wide, 0.0), (top, high)]
    body = within(
        prism(mirrored(sides), 1, 2.0), prism(mirrored([(deep, 0.0), (thin, high)]), 0, 2.0)
    )

    def at(z: float, bottom: float, upper: float) -> float:
        return bottom + (upper - bottom) * z / high

    teeth, holes, slits = [], [], []
    rows = 4
    for k in range(rows):
        z = 0.36 + (high - 0.62) * k / (rows - 1)
        y, x = at(z, deep, thin), at(z, wide, top)
        row = (-0.56, 0.0, 0.56) if k % 2 == 0 else (-0.29, 0.29)
        for f in row:
            teeth.append(egg((f * x, -y + 0.01, z), (0.12, 0.12, 0.09)))
            holes.append(egg((f * x, -y, z + 0.12), (0.11, 0.055, 0.07)))
            teeth.append(egg((f * x, y - 0.01, z), (0.12, 0.12, 0.09)))
            holes.append(egg((f * x, y, z + 0.12), (0.11, 0.055, 0.07)))
        slits.append(box((x, 0, z), (0.055, at(z, deep, thin) * 0.6, 0.075), 0.02))
    bow = limb(
        smooth_arc((top - 0.06, high - 0.02), draw(0.42, 0.52)),
        0.11,
        0.11,
    )
    return {
        "body": body,
        "teeth": join(*teeth),
        "holes": join(*holes),
        "slits": both(join(*slits)),
        "handle": both(bow),
        "rims": join(
            box((0, 0, 0.06), (wide + 0.05, deep + 0.05, 0.09), 0.03),
            box((0, 0, high), (top + 0.05, thin + 0.05, 0.075), 0.03),
        ),
    }


def jug(draw: Draw) -> Parts:
    """A pitcher with a belly, its lip to the left, a large ear to the right, a painted band."""
    belly, neck, high = draw(0.66, 0.78), draw(0.42, 0.5), draw(1.7, 1.95)
    low, wall, rim = draw(0.3, 0.42), 0.12, neck + draw(0.06, 0.12)
    foot = belly * 0.68
    stops = [(foot, 0.1), (belly, high * low), (neck, high * 0.76), (rim, high)]
    curve = smooth_curve(stops, 5)
    inner = [(max(r - wall, 0.05), z) for r, z in curve if z > high * 0.4]
    inside = lathe([*inner, (rim - wall + 0.02, high + 0.3)])
    reach, level = rim + draw(0.22, 0.3), high - 0.02
    lip = taper((-rim * 0.4, 0, level - 0.4), (-reach, 0, level + 0.02), 0.36, 0.15)
    groove = taper((-rim * 0.3, 0, level - 0.2), (-reach - 0.05, 0, level + 0.16), 0.26, 0.12)
    above = box((0, 0, high + 1.02), (3, 3, 1))
    hand = draw(0.34, 0.42)
    loop = [(neck * 0.8, high * 0.86), (neck + hand, high * 0.93), (belly + hand, high * 0.7)]
    loop += [(belly + hand * 0.7, high * 0.48), (belly * 0.86, high * 0.36)]
    ear = limb([(u, 0, v) for u, v in smooth_curve(loop, 4)], 0.12, 0.11)

    def wide_at(z: float) -> float:
        return min(curve, key=lambda stop: abs(stop[1] - z))[0]

    middle = curve[5]  # the belly's widest
    band = [(r + 0.045, z) for r, z in curve if abs(z - middle[1]) < 0.26]
    return {
        "body": cut(join(lathe(curve), lip), inside, groove, above),
        "handle": cut(ear, lathe([(r - 0.06, z) for r, z in curve])),
        "band": lathe(band),
        "foot": lathe([(foot + 0.06, 0.0), (foot + 0.02, 0.16)], 0.02),
        "collar": cut(ring((0, 0, high * 0.76), wide_at(high * 0.76) - 0.01, 0.07), inside),
    }


def moka_pot(draw: Draw) -> Parts:
    """Eight-sided: a boiler, a waist, a pot that widens up to its spout; handle and knob dark."""
    base, waist, top = draw(0.66, 0.74), draw(0.44, 0.5), draw(0.6, 0.7)
    low, high = draw(0.72, 0.84), draw(1.62, 1.8)
    upper, lift = low + 0.12, draw(0.18, 0.26)
    spout = [(-top + 0.1, high - 0.44), (-top - 0.4, high - 0.02), (-top + 0.2, high)]
    out = top + draw(0.4, 0.5)
    arm = [(top * 0.8, high - 0.12), (out, high - 0.12), (out + 0.06, high - 0.2)]
    arm += [(out + 0.12, low + 0.12), (out - 0.1, low + 0.12), (out - 0.16, high - 0.34)]
    arm += [(top * 0.7, high - 0.36)]
    lid = [(top + 0.05, high - 0.02), (top + 0.03, high + 0.07), (0.14, high + lift)]
    knob = high + lift
    return {
        "boiler": _faceted(8, [(base, 0.0), (base * 0.97, 0.1), (waist + 0.04, low)]),
        "pot": join(
            _faceted(8, [(waist, upper - 0.06), (waist + 0.01, upper + 0.06), (top, high)]),
            prism(spout, 1, 0.17),
        ),
        "handle": prism(arm, 1, 0.12),
        "lid": _faceted(8, lid),
        "knob": join(
            tube((0, 0, knob - 0.08), (0, 0, knob + 0.1), 0.1),
            _faceted(8, [(0.11, knob + 0.04), (0.18, knob + 0.16), (0.14, knob + 0.28)]),
        ),
        "collar": join(
            tube((0, 0, low - 0.05), (0, 0, upper + 0.03), waist + 0.09, 0.02),
            tube((0, -base * 1.02, low * 0.5), (0, 0, low * 0.5), 0.11, 0.02),
        ),
    }


UTENSILS = {
    "perfume": perfume,
    "colander": colander,
    "whisk": whisk,
    "spatula": spatula,
    "grater": grater,
    "jug": jug,
    "moka pot": moka_pot,
}
