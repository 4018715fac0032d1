"""Wind instruments, drums and a xylophone."""

import math

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


def trumpet(draw: Draw) -> Parts:
    """It lies along x: the bell to the left, three valves in the middle."""
    z, gap, bell, reach = 0.6, draw(0.17, 0.22), draw(0.42, 0.52), draw(1.15, 1.35)
    flare = [(0.1, -0.1), (0.11, 0.35), (0.2, 0.62), (bell, 0.85), (bell, 0.92)]
    horn = cut(lathe(smooth_curve(flare, 4), 0.02), lathe([(0.03, 0.5), (bell * 0.86, 0.98)], 0))
    left = moved(turned(horn, 1, -90), (-reach + 0.88, 0, z + gap))
    bends = (
        cut(ring((x, 0, z), gap, 0.1, axis=1), box((x - s, 0, z), (1, 1, 2)))
        for x, s in ((0.6, 1), (-0.35, -1))
    )
    valves = (tube((x, 0, z - 0.42), (x, 0, z + 0.38), 0.13, 0.03) for x in (-0.16, 0.13, 0.42))
    caps = (
        join(
            tube((x, 0, z + 0.3), (x, 0, z + 0.58), 0.08),
            tube((x, 0, z + 0.54), (x, 0, z + 0.66), 0.13, 0.03),
        )
        for x in (-0.16, 0.13, 0.42)
    )
    pipe = join(
        capsule((-0.5, 0, z + gap), (0.6, 0, z + gap), 0.1),
        capsule((-0.35, 0, z - gap), (reach, 0, z - gap), 0.1),
    )
    parts = {
        "body": join(left, pipe, *bends),
        "valves": join(*valves),
        "buttons": join(*caps),
        "mouthpiece": taper((reach - 0.1, 0, z - gap), (reach + 0.15, 0, z - gap), 0.1, 0.17),
    }
    return {name: moved(solid, (-0.13, 0, 0)) for name, solid in parts.items()}


def saxophone(draw: Draw) -> Parts:
    """Upright: the bell turns up at the left, the mouthpiece to the right."""
    high, bend, bell = draw(1.9, 2.2), draw(0.36, 0.42), draw(0.42, 0.5)
    x, low = 0.2, 0.58
    left, mouth = x - 2 * bend, draw(1.1, 1.3)
    bow = cut(ring((x - bend, 0, low), bend, 0.2, axis=1), box((0, 0, low + 1), (2, 2, 1)))
    flare = [(0.2, low - 0.05), (0.24, low + 0.3), (bell, mouth)]
    horn = cut(
        lathe(smooth_curve(flare, 3), 0.02, (left, 0)),
        lathe([(0.08, low + 0.25), (bell - 0.1, mouth + 0.04)], 0.0, (left, 0)),
    )
    neck = join(
        capsule((x, 0, high), (x + 0.12, 0, high + 0.2), 0.1),
        capsule((x + 0.12, 0, high + 0.2), (x + 0.45, 0, high + 0.16), 0.1),
    )
    keys = (
        tube((x - 0.02, -0.26, z), (x - 0.02, 0, z), 0.12, 0.03)
        for z in (0.75, 1.02, 1.29, 1.56, 1.83)
        if z < high - 0.1
    )
    return {
        "body": join(taper((x, 0, low), (x, 0, high), 0.2, 0.11), bow, horn, neck),
        "keys": join(*keys, tube((left, -0.36, low + 0.1), (left, 0, low + 0.1), 0.14, 0.03)),
        "mouthpiece": taper((x + 0.4, 0, high + 0.16), (x + 0.68, 0, high + 0.06), 0.14, 0.09),
    }


def flute(draw: Draw) -> Parts:
    """It lies across, its mouth plate to the left, oval keys along its top, joints of rings."""
    half, r = draw(1.25, 1.35), draw(0.046, 0.052)
    z, count = r + 0.03, 7
    mouth = -half * draw(0.66, 0.72)
    lean = draw(18, 30)
    first, last = -half * 0.28, half * 0.84
    oval = mirrored([(0.001, -0.054), (0.052, -0.042), (0.08, 0), (0.052, 0.042), (0.001, 0.054)])
    places = [first + (last - first) * k / (count - 1) for k in range(count)]
    keys = [moved(prism(oval, 2, 0.035), (x, 0, r + 0.012)) for x in places]
    cups = [box((x, 0.04, r - 0.012), (0.05, 0.045, 0.032), 0.02) for x in places]
    rod = capsule((first - 0.08, 0.07, r * 0.75), (last + 0.08, 0.07, r * 0.75), 0.034)
    joints = [-half * 0.42, -half + 0.07, half - 0.07]

    def lying(solid: Solid) -> Solid:
        return tilted(solid, lean, (0, 0, z))

    return {
        "body": lying(tube((-half, 0, 0), (half, 0, 0), r, 0.01)),
        "keys": lying(join(*keys)),
        "rods": lying(join(rod, *cups)),
        "rings": lying(join(*(tube((x - 0.08, 0, 0), (x + 0.08, 0, 0), r + 0.018, 0.01)
                              for x in joints))),
        "mouthpiece": lying(within(egg((mouth, 0, r * 0.6), (0.2, 0.074, 0.06)),
                                   box((mouth, 0, 1.01), (1, 1, 1)))),
        "hole": lying(egg((mouth, 0, r + 0.03), (0.085, 0.04, 0.045))),
    }  # fmt: skip


def harmonica(draw: Draw) -> Parts:
    """A comb with a row of square holes to the front, between two plates of metal."""
    x, y, half = draw(1.1, 1.24), draw(0.38, 0.46), 0.15
    plate, count = draw(0.18, 0.23), 7 + draw.which(2)
    z = plate + half
    curve = smooth_curve([(-y + 0.03, half - 0.02), (-y + 0.06, half + plate * 0.5),
                          (-y * 0.3, half + plate), (y * 0.4, half + plate),
                          (y - 0.06, half + plate * 0.55), (y - 0.03, half - 0.02)])  # fmt: skip
    ends = box((0, 0, 0), (x - 0.16, 1, 1))
    cover = both(within(prism(curve, 0, x), ends), 2)
    step = (2 * x - 0.5) / count
    places = [step * (k - (count - 1) / 2) for k in range(count)]
    holes = [box((u, -y - 0.1, 0), (step * 0.5 - 0.055, 0.16, 0.085)) for u in places]
    screw = tube((x - 0.1, 0.02, 0), (x - 0.1, 0.02, half + 0.055), 0.09, 0.02)
    comb = box((0, 0, 0), (x, y, half), 0.04)
    oval = egg((0, 0.02, half + plate), (x * draw(0.4, 0.5), y * 0.5, 0.055))
    return {
        "comb": moved(cut(comb, *holes), (0, 0, z)),
        "plates": moved(cover, (0, 0, z)),
        "holes": moved(join(*(box((u, -y + 0.1, 0), (step * 0.5 - 0.05, 0.07, 0.09))
                              for u in places)), (0, 0, z)),
        "screws": moved(both(screw, 0, 2), (0, 0, z)),
        "badge": moved(both(oval, 2), (0, 0, z)),
    }  # fmt: skip


def whistle(draw: Draw) -> Parts:
    """A round chamber with a slot, a ball seen in it, a mouthpiece to the left, a ring."""
    r, y, reach = draw(0.62, 0.7), draw(0.34, 0.4), draw(1.0, 1.15)
    z, tall = 0.72, draw(0.3, 0.36)
    top = z + r
    mouth = [(-reach, top), (0.1, top), (0.1, top - tall - 0.16), (-reach, top - tall)]
    slot = [(-0.3, top - 0.5), (-0.42, top + 0.2), (0.2, top + 0.2), (0.08, top - 0.5)]
    end = [(-reach - 0.04, top + 0.03), (-reach + 0.24, top + 0.03)]
    end += [(-reach + 0.24, top - tall - 0.07), (-reach - 0.04, top - tall - 0.03)]
    eye = r + 0.16
    chamber = join(tube((0, -y, z), (0, y, z), r, 0.05), prism(mouth, 1, y - 0.02))
    return {
        "body": cut(chamber, prism(slot, 1, y - 0.12)),
        "mouthpiece": prism(end, 1, y + 0.03),
        "sides": both(tube((0, 0, z), (0, y + 0.05, z), r * draw(0.56, 0.64), 0.02), 1),
        "pea": ball((-0.1, 0, top - 0.17), 0.21),
        "ring": ring((eye, 0, z + 0.1), 0.2, 0.08, axis=1),
    }


def accordion(draw: Draw) -> Parts:
    """Its bellows between two cases, keys on the left of the picture and buttons on the right."""
    y, high, case = draw(0.42, 0.46), draw(0.94, 1.02), draw(0.3, 0.33)
    count, pitch = 4, draw(0.28, 0.3)
    inner = count * pitch / 2
    right, left = inner + case / 2, -inner - 0.4
    folds = [box((pitch * (k - 1.5), 0, high), (0.085, y, high * 0.92), 0.02) for k in range(count)]
    keys = [
        box((left - 0.17, -y - 0.03, high * (1 + v)), (0.32, 0.15, high * 0.12), 0.03)
        for v in (-0.68, -0.34, 0.0, 0.34, 0.68)
    ]
    buttons = [
        tube((right, -y - 0.11, high * (1 + v)), (right, 0, high * (1 + v)), 0.1)
        for v in (-0.68, -0.34, 0.0, 0.34, 0.68)
    ]
    return {
        "body": join(
            box((right, 0, high), (case / 2 + 0.02, y + 0.03, high), 0.06),
            box((left, 0, high), (0.42, y + 0.03, high), 0.06),
        ),
        "bellows": box((0, 0, high), (inner + 0.04, y - 0.12, high * 0.92 - 0.12)),
        "folds": join(*folds),
        "keys": join(*keys),
        "buttons": join(*buttons),
        "grille": box((-inner - 0.13, -y - 0.03, high), (0.08, 0.08, high * 0.8), 0.02),
    }


def xylophone(draw: Draw) -> Parts:
    """Bars of falling length on two rails, with a mallet on top."""
    count, pitch, long, short = 6 + draw.which(3), 0.3, draw(0.7, 0.85), draw(0.36, 0.46)
    x = count * pitch / 2
    bars = [
        box(((k + 0.5) * pitch - x, 0, 0.3), (0.11, long + (short - long) * k / count, 0.09), 0.03)
        for k in range(count)
    ]
    slope = [(-x - 0.05, 0), (-x - 0.05, long * 0.72), (x + 0.05, short * 0.78), (x + 0.05, 0)]
    inner = [(-x + 0.15, -1), (-x + 0.15, long * 0.72 - 0.2), (x - 0.15, short * 0.78 - 0.2)]
    rail = cut(prism(slope, 2, 0.13, 0.13), prism([*inner, (x - 0.15, -1)], 2, 1))
    start, end = (-x * 0.7, -0.25, 0.46), (x * 0.5, 0.05, 0.46)
    return {
        "frame": both(rail, 1),
        "bars": join(*bars[::2]),
        "slats": join(*bars[1::2]),
        "mallet": capsule(start, end, 0.085),
        "tip": ball(end, 0.16),
    }


def drum(draw: Draw) -> Parts:
    """A side drum with its sticks."""
    radius, high = draw(0.78, 0.88), draw(0.75, 1.0)
    hoop = tube((0, 0, -0.1), (0, 0, 0.1), radius + 0.08, 0.03)
    stick = join(capsule((-0.5, 0, 0.12), (0.65, 0, 0.12), 0.085), ball((-0.5, 0, 0.12), 0.13))
    sticks = (moved(turned(stick, 2, a), (0, 0, high)) for a in (62, 118))
    return {
        "shell": tube((0, 0, 0.0), (0, 0, high), radius),
        "hoops": join(moved(hoop, (0, 0, 0.1)), moved(hoop, (0, 0, high - 0.12))),
        "skin": tube((0, 0, high - 0.2), (0, 0, high + 0.03), radius - 0.03, 0.02),
        "sticks": join(*sticks),
    }


def drum_kit(draw: Draw) -> Parts:
    """A bass drum to the front, two toms on it, a snare and a floor tom beside, two cymbals."""
    r, half, tom = draw(0.58, 0.66), draw(0.26, 0.32), draw(0.3, 0.35)
    side, z = draw(0.36, 0.42), r + 0.05
    high, reach, plate = draw(1.95, 2.15), draw(0.92, 1.04), draw(0.44, 0.52)
    floor, snare = draw(0.36, 0.4), draw(0.33, 0.38)
    up = 2 * z + 0.16

    def drum(radius: float, deep: float) -> tuple[Solid, Solid, Solid]:
        """Its shell, hoops and skins, upright about the origin."""
        hoop = tube((0, 0, deep - 0.1), (0, 0, deep + 0.03), radius + 0.055, 0.02)
        return (
            tube((0, 0, -deep), (0, 0, deep), radius),
            both(hoop, 2),
            both(tube((0, 0, 0), (0, 0, deep + 0.06), radius - 0.04, 0.02), 2),
        )

    bass = [tilted(solid, 90, (0, 0, z)) for solid in drum(r, half)]
    toms = [both(moved(turned(s, 0, 14), (side, 0.02, up + tom * 0.5))) for s in drum(tom, 0.2)]
    left = [moved(s, (-reach, 0.1, 0.86)) for s in drum(snare, 0.17)]
    right = [moved(s, (reach, 0.1, 0.46)) for s in drum(floor, 0.32)]
    x, y = reach + 0.02, 0.34 + 0.1
    dish = lathe([(0.0, -0.06), (plate, -0.06), (plate, 0.0), (0.16, 0.05), (0.14, 0.12),
                  (0.0, 0.15)], 0.02)  # fmt: skip
    cymbal = moved(turned(turned(dish, 1, -14), 0, 10), (x, y, high))
    feet = join(
        both(join(capsule((x, y, 0.08), (x, y, high + 0.12), 0.08),
                  capsule((x + 0.2, y + 0.22, 0.08), (x, y, 0.4), 0.08),
                  capsule((side * 0.7, 0.05, 2 * z - 0.14), (side, 0.05, up + 0.1), 0.1))),
        both(capsule((x, y, 0.3), (r * 0.5, half - 0.04, 0.4), 0.08)),
        tube((-reach, 0.1, 0.08), (-reach, 0.1, 0.8), 0.09),
        tube((-reach, 0.1, 0), (-reach, 0.1, 0.14), 0.24, 0.04),
        *(capsule((reach + floor * math.cos(a), 0.1 + floor * math.sin(a), 0.08),
                  (reach + floor * math.cos(a), 0.1 + floor * math.sin(a), 0.4), 0.085)
          for a in (0.5, 2.6, -1.57)),
        both(taper((r * 0.74, -half + 0.05, 0.4), (r + 0.06, -half - 0.1, 0.08), 0.08, 0.08)),
    )  # fmt: skip
    shells, hoops, skins = (join(*solids) for solids in zip(bass, toms, left, right, strict=True))
    badge = tube((0, -half - 0.11, z), (0, 0, z), r * draw(0.38, 0.46), 0.02)
    return {
        "shells": shells,
        "skins": skins,
        "hoops": hoops,
        "cymbals": both(cymbal),
        "stands": feet,
        "badge": badge,
    }


INSTRUMENTS_WIND_AND_PERCUSSION = {
    "trumpet": trumpet,
    "saxophone": saxophone,
    "flute": flute,
    "harmonica": harmonica,
    "whistle": whistle,
    "accordion": accordion,
    "xylophone": xylophone,
    "drum": drum,
    "drum kit": drum_kit,
}
