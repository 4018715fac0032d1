"""Statues and masks, and parts of the body."""

import math

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
    limb,
    moved,
    prism,
    taper,
    tube,
    turned,
)
from core.prior.things.shared.fitted import fitted


def totem(draw: Draw) -> Parts:
    """Three carved heads on one another, the topmost a bird's with spread wings."""
    r, each, span = draw(0.36, 0.42), draw(0.72, 0.82), draw(1.1, 1.3)
    first = 0.14
    levels = [first + each * k for k in range(3)]
    low, middle, high = levels
    blocks = join(
        *(tube((0, 0, v), (0, 0, v + each - 0.1), r + 0.03, 0.04) for v in levels),
        tube((0, 0, 0), (0, 0, high + each - 0.2), r - 0.06),
        tube((0, 0, 0), (0, 0, 0.17), r + 0.14, 0.03),
        lathe([(r, high + each - 0.12), (r * 0.5, high + each + 0.1)], 0.04),
    )
    lift = high + each * 0.3
    wing = [(0.1, lift - 0.3), (0.1, lift + 0.2), (span * 0.6, lift + 0.4), (span, lift + 0.36),
            (span * 0.98, lift - 0.06), (span * 0.78, lift + 0.06), (span * 0.74, lift - 0.22),
            (span * 0.54, lift - 0.1), (span * 0.5, lift - 0.34)]  # fmt: skip
    beak = prism([(-r + 0.06, high + 0.36), (-r + 0.06, high + 0.1), (-r - 0.34, high + 0.06),
                  (-r - 0.3, high + 0.2)], 0, 0.13)  # fmt: skip
    snout = box((0, -r - 0.06, middle + 0.24), (0.16, 0.18, 0.1), 0.04)
    y = -r * 0.86
    sights = [(0.18, y, v + each * 0.64) for v in levels]
    grin = [box((0, -r + 0.04, v), (0.22, 0.1, 0.075), 0.03) for v in (low + 0.16, middle + 0.07)]
    return {
        "wood": blocks,
        "wings": join(both(prism(wing, 1, 0.1)),
                      box((0, -r - 0.02, low + 0.34), (0.1, 0.12, 0.1), 0.03)),
        "bill": join(beak, snout),
        "mouth": join(*grin, tube((0, 0, middle - 0.1), (0, 0, middle), r + 0.07, 0.02),
                      tube((0, 0, high - 0.1), (0, 0, high), r + 0.07, 0.02)),
        "eyes": both(join(*(tube((u, -r - 0.05, w), (u, 0, w), 0.14, 0.02) for u, _, w in sights))),
        "pupils": both(
            join(*(tube((u, -r - 0.1, w), (u, 0, w), 0.085, 0.02) for u, _, w in sights))
        ),
    }  # fmt: skip


def moai(draw: Draw) -> Parts:
    """A long head of stone: a heavy brow, a long nose, thin lips, long ears, on a slab."""
    wide, deep, high = draw(0.42, 0.49), draw(0.38, 0.45), draw(1.65, 1.9)
    brow, nose, lip = draw(0.66, 0.72), draw(0.19, 0.25), draw(0.24, 0.29)
    low = 0.36
    z = low + high * brow
    skull = prism([(-wide * 0.8, low), (wide * 0.8, low), (wide, low + high * 0.3),
                   (wide * 0.96, low + high * 0.86), (wide * 0.76, low + high),
                   (-wide * 0.76, low + high), (-wide * 0.96, low + high * 0.86),
                   (-wide, low + high * 0.3)], 1, deep, 0.06)  # fmt: skip
    side = [(-deep + 0.1, z + high * 0.22), (-deep - 0.14, z + 0.08), (-deep - 0.12, z - 0.08),
            (-deep + 0.1, z - 0.08)]  # fmt: skip
    front = low + high * lip
    bridge = [(-deep + 0.1, z), (-deep - 0.1, z), (-deep - nose - 0.12, front + 0.26),
              (-deep - 0.04, front + 0.16), (-deep + 0.1, front + 0.16)]  # fmt: skip
    nostrils = box((0, -deep - nose * 0.5, front + 0.24), (0.22, nose * 0.5 + 0.06, 0.085), 0.04)
    lips = join(
        box((0, -deep, front + 0.04), (0.24, 0.14, 0.05), 0.03),
        box((0, -deep, front - 0.11), (0.22, 0.14, 0.05), 0.03),
    )
    chin = box((0, -deep + 0.04, low + high * 0.08), (wide * 0.6, 0.14, high * 0.08), 0.04)
    ear = box((wide, 0.1, low + high * 0.5), (0.1, 0.13, high * 0.24), 0.04)
    hollow = box((0.24, -deep + 0.02, z - 0.19), (0.13, 0.085, 0.11), 0.03)
    return {
        "body": join(
            skull, prism(side, 0, wide * 0.97), prism(bridge, 0, 0.15), nostrils, lips, chin,
            both(ear),
        ),
        "eyes": both(hollow),
        "base": join(
            box((0, 0.04, 0.2), (wide + 0.26, deep + 0.16, 0.2), 0.06),
            box((0, 0.04, 0.36), (wide * 0.74, deep * 0.84, 0.16)),
        ),
    }  # fmt: skip


def obelisk(draw: Draw) -> Parts:
    """A tall four-sided shaft that narrows, its tip gilded; signs are cut in its sides."""
    low, top, high = draw(0.26, 0.31), draw(0.18, 0.21), draw(2.05, 2.35)
    foot, point = draw(0.5, 0.6), draw(0.36, 0.48)
    first = 0.42
    shaft = around(
        4, prism([(0, first), (low, first), (top, first + high), (0, first + high)], 1, 2)
    )
    crown = first + high
    tip = around(
        4, prism([(0, crown - 0.02), (top + 0.03, crown - 0.02), (0, crown + point)], 1, 2)
    )
    steps = join(
        box((0, 0, 0.12), (foot, foot, 0.12), 0.03),
        box((0, 0, 0.32), (foot * 0.78, foot * 0.78, 0.14), 0.03),
    )
    stops = [(low + (top - low) * k, first + high * k) for k in (0.2, 0.4, 0.6, 0.8)]
    signs = join(
        *(tube((x - 0.04, 0, v), (x + 0.05, 0, v), 0.095) for x, v in stops[::2]),
        *(box((x, 0, v), (0.05, 0.13, 0.055)) for x, v in stops[1::2]),
    )
    return {
        "body": shaft,
        "tip": tip,
        "base": steps,
        "signs": around(4, signs),
    }  # fmt: skip


def mask(draw: Draw) -> Parts:
    """A carved face, long and curved, painted, with a crest of feathers; it stands."""
    wide, high, deep = draw(0.58, 0.68), draw(0.88, 1.02), draw(0.36, 0.44)
    z, plume = high, draw(0.42, 0.58)
    back = box((0, 1.1, z), (2, 1, 3))
    shell = cut(egg((0, 0.1, z), (wide, deep, high)), back)
    y = 0.1 - deep

    def face(x: float, v: float) -> float:
        """How far to the front the shell is."""
        return 0.1 - deep * math.sqrt(max(0.05, 1 - (x / wide) ** 2 - ((v - z) / high) ** 2))

    leaf = prism([(-0.09, high * 0.7), (0.09, high * 0.7), (0.19, high + plume * 0.55),
                  (0, high + plume), (-0.19, high + plume * 0.55)], 1, 0.09, 0.03)  # fmt: skip
    fan = [moved(turned(leaf, 1, angle), (0, 0, z)) for angle in (0, 24, 48)]
    eye = moved(
        turned(egg((0, 0, 0), (0.19, 0.12, 0.1)), 1, 16), (0.26, face(0.26, z + 0.16), z + 0.16)
    )
    brow = capsule(
        (0.12, face(0.12, z + 0.34) - 0.02, z + 0.34), (0.4, face(0.4, z + 0.46), z + 0.46), 0.09
    )
    cheeks = [
        capsule(
            (0.28, face(0.28, z - v), z - v), (0.46, face(0.46, z - v + 0.1), z - v + 0.1), 0.075
        )
        for v in (0.14, 0.38)
    ]
    stripe = capsule((0, face(0, z + 0.72), z + 0.72), (0, face(0, z + 0.5), z + 0.5), 0.1)
    mouth = egg((0, face(0, z - 0.5) + 0.02, z - 0.5), (0.27, 0.14, 0.17))
    nose = prism([(y + 0.1, z + 0.34), (y - 0.02, z + 0.32), (y - 0.2, z - 0.16),
                  (y + 0.1, z - 0.2)], 0, 0.1)  # fmt: skip
    row = z - 0.43
    bite = both(
        join(
            *(box((u, face(u, row) - 0.02, row), (0.06, 0.08, 0.075), 0.02) for u in (0.065, 0.19))
        )
    )
    return {
        "face": join(shell, nose),
        "paint": join(both(join(brow, *cheeks)), stripe),
        "eyes": both(eye),
        "mouth": mouth,
        "teeth": bite,
        "feathers": join(fan[0], both(join(*fan[1:]))),
    }  # fmt: skip


def bone(draw: Draw) -> Parts:
    """A shaft with two knobs at either end, as a dog is given."""
    long, thick, knob = draw(0.8, 0.96), draw(0.23, 0.29), draw(0.3, 0.36)
    apart = draw(0.8, 0.9) * knob
    z = apart + knob
    ends = both(ball((long, 0, apart), knob), 0, 2)
    return {"body": moved(join(ends, tube((-long, 0, 0), (long, 0, 0), thick)), (0, 0, z))}


def eyeball(draw: Draw) -> Parts:
    """It looks to the front: the white, iris, pupil and a glint, the nerve behind."""
    r, iris, pupil = 0.9, draw(0.44, 0.54), draw(0.2, 0.27)
    bulge = draw(0.05, 0.1)
    nerve = [(0, r - 0.1, 0), (0, r + 0.28, -0.06), (0, r + 0.55, -0.24)]

    def disc(radius: float, high: float) -> Solid:
        """The cap of that radius on a ball that is ``high`` above the white."""
        plane = math.sqrt((r + high) ** 2 - radius**2)
        return cut(ball((0, 0, 0), r + high), box((0, 2 - plane, 0), (2, 2, 2)))

    parts = {
        "white": ball((0, 0, 0), r),
        "iris": disc(iris, bulge),
        "pupil": disc(pupil, bulge + 0.04),
        "nerve": limb(nerve, draw(0.2, 0.26), 0.17),
        "glint": ball((0.2, -r - bulge + 0.06, 0.22), 0.11),
    }
    return {name: moved(solid, (0, 0, r)) for name, solid in parts.items()}


def tooth(draw: Draw) -> Parts:
    """A molar: a square crown with four cusps, on roots that taper."""
    wide, high, root = draw(0.54, 0.62), draw(0.4, 0.48), draw(0.75, 0.95)
    apart, deep = wide * draw(0.52, 0.6), draw(0.44, 0.52)
    cusp = egg((wide * 0.52, deep * 0.5, root + 2 * high - 0.06), (wide * 0.5, deep * 0.52, 0.24))
    neck = box((0, 0, root + 0.06), (wide * 0.84, deep * 0.84, 0.2), 0.14)
    leg = taper((apart, deep * 0.42, root), (apart * 1.05, deep * 0.4, 0.1), 0.25, 0.1)
    return {
        "crown": blend(
            0.12,
            box((0, 0, root + high), (wide, deep, high), 0.22),
            both(cusp, 0, 1),
        ),
        "roots": join(both(leg, 0, 1), neck),
    }


def hand(draw: Draw) -> Parts:
    """Open, its palm to the front, standing on its cuff."""
    wide, palm, r = draw(0.4, 0.46), draw(0.36, 0.42), draw(0.115, 0.13)
    long, spread = draw(0.55, 0.68), draw(0.28, 0.42)
    z = 0.46 + palm
    knuckle = z + palm - 0.08
    fingers, nails = [], []
    for k, part in enumerate((0.9, 1.05, 1.0, 0.78)):
        u = wide * (k - 1.5) * 0.52
        lean = (k - 1.5) * spread * 0.32
        tip = (u + lean * long, 0.02, knuckle + long * part)
        fingers.append(taper((u, 0, knuckle), tip, r + 0.01, r))
        nails.append(egg((tip[0], r * 0.75, tip[2] + 0.02), (0.09, 0.085, 0.11)))
    thumb = limb(
        [(-wide * 0.5, -0.04, z - palm * 0.6), (-wide - 0.16, -0.08, z + 0.02),
         (-wide - 0.32, -0.08, z + palm * 0.8)], 0.19, r + 0.015)  # fmt: skip
    heel = join(
        egg((-wide * 0.45, -0.13, z - palm * 0.35), (0.21, 0.13, 0.28)),
        egg((wide * 0.5, -0.12, z - palm * 0.4), (0.16, 0.1, 0.28)),
    )
    return {
        "skin": join(
            box((0, 0, z), (wide, 0.17, palm), 0.15),
            taper((0, 0, 0.2), (0, 0, z - palm * 0.8), 0.25, 0.16),
            thumb,
            heel,
            *fingers,
        ),
        "cuff": join(tube((0, 0, 0), (0, 0, 0.36), 0.34, 0.04),
                     tube((0, 0, 0.24), (0, 0, 0.42), 0.39, 0.05)),
        "nails": join(*nails),
    }  # fmt: skip


def _fold(side_deg: float, radii: Vector) -> list[Vector]:
    """A winding line from under the front over the top to under the back, ``side_deg`` outwards."""
    x, y, z = radii
    points = []
    for k in range(18):
        along, wave = math.radians(-28 + 13.4 * k), (0, 1, 0, -1)[k % 4]
        side = math.radians(side_deg + 9 * wave)
        level = math.cos(0.8 * side)
        points.append(
            (x * math.sin(side), -y * math.cos(along) * level, z * math.sin(along) * level)
        )
    return points


def brain(draw: Draw) -> Parts:
    """Two halves with winding folds, the little brain and the stem below."""
    wide, long, high = draw(0.62, 0.7), draw(0.88, 1.0), draw(0.6, 0.68)
    z, thick, apart = 0.95, draw(0.125, 0.145), 0.1
    half = egg((apart, 0, 0), (wide * 0.94, long * 0.94, high * 0.94))
    inner = cut(half, box((-1.94, 0, 0), (2, 2, 2)))
    folds = [limb(_fold(side, (wide, long, high)), thick, thick) for side in (13, 46, 80)]
    lobe = egg((wide * 0.82, -long * 0.16, -high * 0.5), (0.27, long * 0.52, 0.2))
    return {
        "folds": moved(both(join(moved(join(*folds), (apart, 0, 0)), lobe)), (0, 0, z)),
        "grooves": moved(join(both(inner), box((0, 0, 0), (0.12, long * 0.6, high * 0.5))),
                         (0, 0, z)),
        "cerebellum": both(egg((0.24, long * 0.62, z - high * 0.72), (0.32, 0.32, 0.24))),
        "stem": taper((0, 0.18, z - 0.4), (0, 0.34, 0.16), 0.2, 0.16),
    }  # fmt: skip


STATUES_AND_BODY_PARTS = {
    "totem pole": fitted(totem),
    "moai": fitted(moai),
    "obelisk": fitted(obelisk),
    "mask": fitted(mask),
    "bone": fitted(bone),
    "eyeball": fitted(eyeball),
    "tooth": fitted(tooth),
    "hand": fitted(hand),
    "brain": fitted(brain),
}
