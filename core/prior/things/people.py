"""People of stories and of the screen, sturdy, with large heads."""

import math

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    around,
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
    taper,
    tube,
    turned,
)
from core.prior.things.characters import eyes
from core.prior.things.standing import figure, hair


def astronaut(draw: Draw) -> Parts:
    """A white suit with a round helmet, a golden visor, a pack with tanks, a panel at the chest."""
    f = figure(draw)
    helmet, deep = f.head * draw(1.16, 1.28), f.wide + draw(0.2, 0.28)
    pack = box((0, deep, f.top - 0.32), (f.wide * 0.86, 0.24, draw(0.46, 0.54)), 0.06)
    cuffs = both(ball(f.hand, 0.2))
    y = -f.wide * 0.96
    return {
        "suit": join(f.trunk(0.06), f.sleeves(0.06), f.legs(0.06), ball((0, 0, f.z), helmet)),
        "visor": egg((0, -helmet * 0.42, f.z + 0.02), (helmet * 0.8, helmet * 0.72, helmet * 0.62)),
        "pack": join(
            pack, both(tube((0.22, deep + 0.1, f.top - 0.8), (0.22, deep + 0.1, f.z), 0.16, 0.05))
        ),
        "boots": join(f.shoes(0.34), cuffs),
        "panel": box((0, y, f.top - 0.4), (f.wide * 0.52, 0.16, 0.17), 0.03),
        "collar": ring((0, 0, f.top + 0.02), helmet * 0.74, 0.11),
    }


def pirate(draw: Draw) -> Parts:
    """A long coat, a hat with its brim turned up, an eye patch, a beard, a hook for a hand."""
    f = figure(draw)
    hem, brim, r = draw(0.3, 0.42), f.head * draw(1.7, 1.95), f.head
    coat = lathe(
        smooth_curve(
            [(f.wide * 1.12, hem), (f.wide * 0.9, f.leg + 0.15), (f.wide * 0.62, f.top - 0.02)]
        ),
        0.05,
    )
    low = f.z + r * 0.3
    arch = [(brim * c, low + h) for c, h in ((1, 0.02), (0.82, 0.3), (0.46, 0.5), (0, 0.58))]
    bicorne = [*((-a, b) for a, b in arch), *reversed(arch[:-1])]
    strap = cut(
        turned(ring((0, 0, 0), r * 1.0, 0.055, 0), 1, 28), box((0, 0, -2), (2, 2, 2 - r * 0.1))
    )
    patch = egg((r * 0.4, -r * 0.86, f.z + 0.1), (0.15, 0.13, 0.14))
    beard = [(0.06, f.z - r * 1.5), (r * 0.62, f.z - r * 0.9), (r * 0.8, f.z - r * 0.3)]
    x, y, z = f.hand
    hook = capsule((x, y, z), (x, y - 0.06, z - 0.2), 0.07)
    tip = taper((x, y - 0.06, z - 0.2), (x - 0.02, y - 0.3, z - 0.12), 0.075, 0.065)
    return {
        "coat": join(coat, f.sleeves(0.02)),
        "hat": join(prism(bicorne, 1, r * 0.5, -r * 0.2), ball((0, 0.02, f.z + r * 0.3), r * 1.06)),
        "skin": join(f.skull(), ball((-x, y, z), 0.17)),
        "beard": lathe(smooth_curve(beard), 0.04, (0, -r * 0.36)),
        "boots": join(f.shoes(hem + 0.1), ring((0, 0, f.leg + 0.16), f.wide * 0.9, 0.1)),
        "patch": join(
            moved(strap, (0, 0, f.z + 0.1)),
            patch,
            ball((-r * 0.4, -r * 0.88, f.z + 0.1), 0.085),
            hook,
            tip,
        ),
    }


def zombie(draw: Draw) -> Parts:
    """Its arms stretched forward, a torn shirt, round eyes of two sizes, an open mouth."""
    f = figure(draw)
    reach, rise = draw(0.72, 0.9), draw(-0.16, 0.06)
    x, shoulder = f.wide * 0.92, (f.wide * 0.92, 0, f.top - 0.22)
    hand = (x, -reach, f.top - 0.22 + rise)
    elbow = tuple(a + (b - a) * 0.45 for a, b in zip(shoulder, hand, strict=True))
    tears = around(
        5, prism([(-0.16, f.leg - 0.1), (0.16, f.leg - 0.1), (0, f.leg + 0.2)], 0, 2), 10
    )
    shirt = cut(
        join(f.trunk(0.05), tube((0, 0, f.leg - 0.04), (0, 0, f.leg + 0.3), f.wide * 0.86)), tears
    )
    small, large = draw(0.09, 0.1), draw(0.13, 0.15)
    e = f.head * 0.42
    return {
        "skin": join(
            f.skull(),
            both(join(taper(shoulder, hand, 0.14, 0.12), ball(hand, 0.18))),
            f.trunk(),
            f.shoes(0.3),
        ),
        "shirt": join(shirt, both(taper(shoulder, elbow, 0.2, 0.2))),
        "trousers": f.legs(0.04),
        "hair": cut(hair(f), box((0, -f.head, f.z + f.head), (0.1, 1, f.head * 0.6))),
        "eyes": join(
            ball((-e, -f.head * 0.86, f.z + 0.1), large),
            ball((e, -f.head * 0.88, f.z + 0.1), small),
        ),
        "mouth": egg(f.face(-0.42, -0.12), (0.2, 0.12, 0.1)),
    }


def ninja(draw: Draw) -> Parts:
    """Hooded, but for a band at the eyes; a sash, a knot behind the head, a sword on the back."""
    f = figure(draw)
    r = f.head
    out, low = f.wide + 0.14, (-f.wide * 0.7, f.top - 0.78)
    high = (f.wide * 0.9, f.top + 0.3)
    band = cut(
        ball((0, 0, f.z), r * 1.07),
        box((0, 0, f.z + r * 0.56 + 1), (2, 2, 1)),
        box((0, 0, f.z + r * 0.24 - 1), (2, 2, 1)),
    )
    tails = join(
        taper((0, r, f.z + r * 0.4), (0.26, r + 0.3, f.z - 0.06), 0.12, 0.09),
        taper((0, r, f.z + r * 0.4), (-0.18, r + 0.34, f.z + 0.1), 0.12, 0.09),
    )
    slit = egg((0, -r * 0.62, f.z + 0.03), (r * 0.72, r * 0.46, r * 0.26))
    tip = (high[0] + 0.22, high[1] + 0.33)
    return {
        "suit": join(ball((0, 0, f.z), r), f.trunk(), f.sleeves(), f.legs(), f.shoes(), f.hands()),
        "skin": slit,
        "eyes": eyes(r * 0.36, -r * 1.0, f.z + 0.04, 0.08),
        "sash": join(
            tube((0, 0, f.leg + 0.06), (0, 0, f.leg + 0.28), f.wide * 0.96, 0.03), band, tails
        ),
        "sword": capsule((low[0], out, low[1]), (high[0], out, high[1]), 0.12),
        "hilt": join(
            capsule((high[0], out, high[1]), (tip[0], out, tip[1]), 0.085),
            ball((high[0] + 0.02, out, high[1] + 0.03), 0.16),
        ),
    }


def vampire(draw: Draw) -> Parts:
    """A long cape with a high collar that stands open over a red vest; fangs."""
    f = figure(draw)
    wide, r = f.wide * draw(1.5, 1.75), f.head
    gap = [(-0.3, -0.1), (0.3, -0.1), (0.2, f.top - 0.05), (-0.2, f.top - 0.05)]
    cape = lathe([(wide, 0.05), (f.wide * 1.12, f.leg + 0.3), (f.wide * 0.72, f.top)], 0.06)
    front = prism(gap, 1, 1.0, -1.0)
    collar = cut(
        lathe([(f.wide * 0.7, f.top - 0.1), (r * 1.5, f.z + r * 0.5)], 0.06),
        lathe([(f.wide * 0.7 - 0.14, f.top - 0.3), (r * 1.5 - 0.12, f.z + r * 0.8)]),
        box((0, -2, f.z), (3, 2 - r * 0.1, 2)),
    )
    fangs = both(
        taper((0.1, -r * 0.9, f.z - r * 0.38), (0.1, -r * 0.94, f.z - r * 0.38 - 0.13), 0.065, 0.03)
    )
    inside = lathe([(wide * 0.8, 0.08), (f.wide * 0.86, f.leg + 0.3), (f.wide * 0.56, f.top)], 0.02)
    widow = [(r * 0.86, f.z - r * 1.4), (r * 0.86, f.z + r * 0.34), (r * 0.42, f.z + r * 0.64)]
    face = [*widow, (0, f.z + r * 0.26), *((-u, v) for u, v in reversed(widow))]
    return {
        "cape": join(cut(cape, front), collar, f.sleeves()),
        "vest": inside,
        "skin": join(
            f.skull(),
            f.hands(),
            both(taper((r * 0.9, 0, f.z), (r * 1.2, 0.02, f.z + 0.16), 0.1, 0.06)),
        ),
        "hair": cut(ball((0, 0.03, f.z + 0.04), r * 1.12), prism(face, 1, r, -r)),
        "fangs": fangs,
        "eyes": f.eyes(),
    }


def fairy(draw: Draw) -> Parts:
    """In a wide dress, with four wings, a knot of hair, a wand with a star."""
    f = figure(draw)
    r, wing = f.head, draw(0.62, 0.76)
    hem = f.leg * 0.62
    skirt = lathe([(f.wide * draw(1.5, 1.8), hem), (f.wide * 0.66, f.leg + 0.26)], 0.05)
    bodice = taper((0, 0, f.leg + 0.2), (0, 0, f.top - 0.24), f.wide * 0.7, f.wide * 0.78)
    y = f.wide * 0.68
    upper = moved(
        turned(egg((wing * 0.8, 0, 0), (wing, 0.09, wing * 0.52)), 1, -32), (0.06, y, f.top - 0.3)
    )
    lower = moved(
        turned(egg((wing * 0.62, 0, 0), (wing * 0.76, 0.09, wing * 0.4)), 1, 26),
        (0.06, y, f.top - 0.4),
    )
    x, py, pz = f.hand
    star = [
        (0.0, 0.3),
        (0.085, 0.115),
        (0.285, 0.093),
        (0.135, -0.045),
        (0.176, -0.243),
        (0, -0.14),
    ]
    star = [*star, *((-a, b) for a, b in reversed(star[1:-1]))]
    tip = pz + 0.62
    wand = prism([(x + a, tip + 0.12 + b) for a, b in star], 1, 0.09, py)
    return {
        "dress": join(skirt, bodice),
        "skin": join(f.skull(), f.sleeves(-0.03), f.hands(0.15), f.legs(-0.04)),
        "wings": both(join(upper, lower)),
        "hair": join(hair(f, draw(0.5, 1.1)), ball((0, 0.08, f.z + r * 1.16), r * 0.42)),
        "wand": join(capsule((x, py, pz - 0.08), (x, py, tip), 0.065), wand, f.shoes(0.16)),
        "eyes": f.eyes(),
    }


def superhero(draw: Draw) -> Parts:
    """Broad, the fists at the hips, in a cape, with a sign on the chest."""
    f = figure(draw)
    r, wide = f.head, f.wide * draw(1.12, 1.24)
    chest = lathe(
        smooth_curve(
            [
                (f.wide * 0.66, f.leg),
                (f.wide * 0.72, f.leg + 0.26),
                (wide, f.top - 0.3),
                (wide * 0.7, f.top),
            ]
        ),
        0.05,
    )
    shoulder, elbow = (wide * 0.94, 0, f.top - 0.2), (wide + 0.44, 0.06, f.leg + 0.42)
    hip = (f.wide * 0.86, -0.1, f.leg + 0.16)
    sweep = draw(0.16, 0.4)
    cape = [
        (f.wide * 0.82, f.top - 0.06),
        (wide * 1.45, 0.16),
        (-wide * 1.45, 0.16),
        (-f.wide * 0.82, f.top - 0.06),
    ]
    slab = turned(prism(cape, 1, 0.09), 0, math.degrees(sweep / f.top))
    sign = [(0, -0.2), (0.2, 0.02), (0.12, 0.14), (-0.12, 0.14), (-0.2, 0.02)]
    return {
        "suit": join(chest, f.legs(), both(limb([shoulder, elbow, hip], 0.19, 0.14))),
        "cape": join(
            moved(slab, (0, f.wide * 0.82 + sweep, 0)),
            ring((0, 0.02, f.top + 0.02), r * 0.62, 0.13),
        ),
        "skin": join(f.skull(), both(ball(hip, 0.17))),
        "hair": hair(f),
        "trim": join(
            f.shoes(f.leg * 0.6),
            tube((0, 0, f.leg - 0.02), (0, 0, f.leg + 0.16), f.wide * 0.86, 0.03),
            prism([(a, f.top - 0.24 + b) for a, b in sign], 1, 0.2, -wide + 0.1),
        ),
        "eyes": f.eyes(),
    }


def elf(draw: Draw) -> Parts:
    """A helper at the feast: long ears, a pointed hat with a bobble, a collar of points."""
    f = figure(draw)
    r, tall = f.head, draw(0.62, 0.86)
    lean = draw(0.1, 0.3)
    ear = taper((r * 0.86, 0, f.z - 0.02), (r + draw(0.3, 0.42), 0.06, f.z + 0.24), 0.14, 0.06)
    points = around(
        6,
        prism([(-0.22, f.top + 0.02), (0.22, f.top + 0.02), (0, f.top - 0.4)], 0, f.wide * 1.04),
        0,
    )
    collar = cut(points, tube((0, 0, f.top - 0.6), (0, 0, f.top - 0.1), f.wide * 0.72))
    skirt = lathe([(f.wide * 1.14, f.leg - 0.02), (f.wide * 0.84, f.leg + 0.34)], 0.05)
    top = f.z + r * 0.62 + tall
    hat = taper((0, 0.02, f.z + r * 0.62), (lean, 0.06, top), r * 0.82, 0.1)
    x = f.wide * 0.5
    shoe = join(
        egg((x, -0.16, 0.12), (0.2, 0.36, 0.14)),
        taper((x, -0.38, 0.13), (x, -0.54, 0.3), 0.12, 0.08),
    )
    return {
        "tunic": join(f.trunk(), skirt, f.sleeves()),
        "hat": hat,
        "skin": join(f.skull(), both(ear), f.hands()),
        "trim": join(
            tube((0, 0.02, f.z + r * 0.4), (0, 0.02, f.z + r * 0.76), r * 1.06, 0.08),
            ball((lean, 0.06, top), 0.18),
            collar,
            tube((0, 0, f.leg + 0.24), (0, 0, f.leg + 0.42), f.wide * 0.93, 0.03),
        ),
        "shoes": join(both(shoe), f.legs(-0.01)),
        "eyes": f.eyes(),
    }


def clown(draw: Draw) -> Parts:
    """Baggy, with tufts of hair at both sides, a ruff, a red nose, large shoes, a small hat."""
    f = figure(draw)
    r, belly = f.head, f.wide * draw(1.2, 1.45)
    baggy = egg((0, 0, (f.leg + f.top) / 2), (belly, belly * 0.86, (f.top - f.leg) * 0.66))
    tuft = draw(0.24, 0.3)
    hat = join(
        tube((0.1, 0, f.z + r * 0.86), (0.1, 0, f.z + r * 0.86 + 0.4), 0.22, 0.03),
        tube((0.1, 0, f.z + r * 0.82), (0.1, 0, f.z + r * 0.96), 0.38, 0.04),
    )
    x = f.wide * 0.5
    shoe = egg((x + 0.04, -0.26, 0.13), (0.24, 0.5, 0.16))
    buttons = join(*(ball((0, -belly * 0.84, f.leg + at), 0.11) for at in (0.22, 0.52)))
    return {
        "suit": join(baggy, f.sleeves(0.05), f.legs(0.07)),
        "ruff": ring((0, 0, f.top), r * 0.86, 0.15),
        "skin": join(ball((0, 0, f.z), r), f.hands()),
        "hair": both(
            join(
                ball((r * 0.98, 0.06, f.z + 0.12), tuft),
                ball((r * 0.9, 0.12, f.z - 0.16), tuft * 0.8),
            )
        ),
        "nose": join(ball(f.face(-0.06, 0.06), 0.15), both(shoe), buttons, hat),
        "eyes": f.eyes(),
    }


PEOPLE = {
    "astronaut": astronaut,
    "pirate": pirate,
    "zombie": zombie,
    "ninja": ninja,
    "vampire": vampire,
    "fairy": fairy,
    "superhero": superhero,
    "elf": elf,
    "clown": clown,
}
