"""Soldiers, warriors and a pirate."""

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
    around,
    ball,
    both,
    box,
    capsule,
    chain,
    cut,
    egg,
    join,
    lathe,
    moved,
    prism,
    ring,
    smooth_curve,
    taper,
    tube,
    turned,
    within,
)
from core.prior.things.shared.faces import eyes, moustache
from core.prior.things.shared.figure import Figure, figure


def _dome(f: Figure, low: float, grown: float) -> Solid:
    """A cap from ``low`` heads above the middle of the head."""
    size = f.head * grown
    return cut(ball((0, 0.02, f.z + 0.05), size), box((0, 0, f.z + low * f.head - 1), (2, 2, 1)))


def _armed(draw: Draw) -> Figure:
    """Someone who holds things before the body."""
    f = figure(draw)
    return f._replace(hand=(f.wide + draw(0.26, 0.34), -0.42, f.top - 0.54))


def viking(draw: Draw) -> Parts:
    """A horned helmet, a great beard, fur about the shoulders, an axe and a round shield."""
    f = _armed(draw)
    r, w, (x, y, z) = f.head, f.wide, f.hand
    round_, beard, up = draw(0.44, 0.52), draw(1.5, 1.8), draw(1.25, 1.55)
    skirt = lathe([(w * 1.15, f.leg - 0.1), (w * 0.86, f.leg + 0.3)], 0.04)
    front = y - 0.28
    blade = [
        (x + 0.02, 0.16),
        (x + 0.34, 0.34),
        (x + 0.42, 0),
        (x + 0.34, -0.34),
        (x + 0.02, -0.16),
    ]
    blade = [(u, f.z + 0.05 + v) for u, v in blade]
    horn = [
        ((r * 0.95, 0, f.z + r * 0.5), 0.17),
        ((r * 1.6, 0, f.z + r * 0.6), 0.15),
        ((r * 1.9, 0, f.z + r * up), 0.07),
    ]
    chin = [(0.06, f.z - r * beard), (r * 0.72, f.z - r * 0.85), (r * 0.84, f.z - r * 0.25)]
    return {
        "tunic": join(
            f.trunk(0.02), skirt, f.legs(), tube((-x, front, z), (-x, front + 0.15, z), round_)
        ),
        "fur": join(
            lathe(
                [(w * 1.3, f.top - 0.34), (w * 1.2, f.top - 0.16), (w * 0.6, f.top + 0.06)], 0.06
            ),
            f.shoes(0.36),
            tube((0, 0, f.leg + 0.1), (0, 0, f.leg + 0.25), w),
            tube((x, y, z - 0.45), (x, y, f.z + 0.3), 0.085),
            f.eyes(),
        ),
        "helmet": join(
            _dome(f, 0.44, 1.14),
            tube((0, 0, f.z + r * 0.44), (0, 0, f.z + r * 0.76), r * 1.12),
            box((0, -r * 1.04, f.z + r * 0.3), (0.085, 0.09, 0.18)),
            prism(blade, 1, 0.08, y),
            ball((-x, front, z), 0.15),
            ring((-x, front + 0.05, z), round_, 0.085, 1),
        ),
        "horns": both(chain(horn)),
        "beard": join(
            lathe(smooth_curve(chin), 0.04, (0, -r * 0.4)),
            moustache((0, -r * 1.02, f.z - r * 0.32), 0.18),
            egg((0, r * 0.45, f.z - r * 0.4), (r * 0.98, r * 0.6, r)),
        ),
        "skin": join(f.skull(), f.sleeves(), f.hands()),
    }


def samurai(draw: Draw) -> Parts:
    """In plates of lacquer, a helmet with a wide neck guard and a golden crest, a katana."""
    f = _armed(draw)
    r, w, (x, y, z) = f.head, f.wide, f.hand
    rise, long, waist = draw(0.26, 0.38), draw(0.98, 1.12), f.leg + 0.1
    third = (f.top - waist) / 3
    chest = lathe(
        [
            (w * 0.95, waist),
            (w * 0.85, waist + third),
            (w * 1.03, waist + third),
            (w * 0.92, f.top - third),
            (w * 1.08, f.top - third),
            (w * 0.8, f.top),
        ]
    )
    flap = prism(
        [
            (w * 0.7, f.leg + 0.16),
            (w * 1.0, f.leg + 0.16),
            (w * 1.5, f.leg - 0.26),
            (w * 1.16, f.leg - 0.26),
        ],
        1,
        0.3,
    )
    guard = [(0.0, 0.1), (0.22, 0.1), (0.46, -0.46), (0.28, -0.5)]
    shoulder = prism([(w * 0.86 + u, f.top - 0.08 + v) for u, v in guard], 1, 0.29)
    neck = lathe([(r * 1.65, f.z - r * 0.5), (r * 1.12, f.z + r * 0.3)], 0.03)
    neck = cut(neck, box((0, -2, f.z), (3, 2 - r * 0.12, 2)))
    low = z + 0.2
    right = [(x + 0.09, low), (x + 0.16, low + long * 0.55), (x + 0.36, low + long)]
    left = [(x + 0.21, low + long * 0.92), (x, low + long * 0.55), (x - 0.09, low)]
    horn = [
        ((0.06, -r * 1.06, f.z + r * 0.64), 0.11),
        ((0.36, -r * 1.1, f.z + r * 1.0), 0.1),
        ((0.46, -r * 1.06, f.z + r * 0.9 + rise), 0.08),
    ]
    return {
        "armour": join(chest, around(4, flap, 90), both(shoulder)),
        "helmet": join(
            _dome(f, 0.4, 1.16), neck, tube((0, 0, f.z + r * 0.4), (0, 0, f.z + r * 0.7), r * 1.14)
        ),
        "crest": join(
            both(chain(horn)),
            tube((x, y, z + 0.13), (x, y, z + 0.27), 0.2),
            tube((0, 0, waist), (0, 0, waist + 0.14), w * 0.99),
        ),
        "clothes": join(
            f.sleeves(0.05),
            f.legs(0.07),
            f.shoes(),
            f.eyes(),
            capsule((x, y, z - 0.3), f.hand, 0.08),
        ),
        "skin": join(f.skull(), f.hands()),
        "katana": prism([*right, *left], 1, 0.08, y),
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


def cowboy(draw: Draw) -> Parts:
    """A hat with its brim curled up at the sides, a vest, a scarf at the neck, high boots."""
    f = figure(draw)
    f = f._replace(hand=(f.wide + draw(0.3, 0.4), -0.12, f.leg + 0.24))
    r, w, out = f.head, f.wide, f.head * draw(1.8, 2.0)
    brow, tall, curl = f.z + r * 0.6, draw(0.46, 0.58), draw(0.2, 0.34)
    arc = [(-out, curl), (-out * 0.6, 0.02), (0, -0.03), (out * 0.6, 0.02), (out, curl)]
    lower = smooth_curve([(u, brow + v) for u, v in arc])
    sheet = prism([*lower, *((u, v + 0.15) for u, v in reversed(lower))], 1, 2)
    crown = lathe([(r * 0.98, brow), (r * 0.84, brow + tall)], 0.05)
    crease = capsule((0, -1, brow + tall + 0.12), (0, 1, brow + tall + 0.12), 0.17)
    vest = lathe([(w * 0.98, f.leg + 0.16), (w * 0.98, f.top - 0.2), (w * 0.72, f.top)], 0.02)
    gap = prism([(-w * 0.36, 0), (w * 0.36, 0), (w * 0.5, f.top), (-w * 0.5, f.top)], 1, 1, -1)
    scarf = prism(
        [(-w * 0.7, f.top + 0.02), (w * 0.7, f.top + 0.02), (0, f.top - 0.34)], 1, 0.14, -w * 0.8
    )
    return {
        "shirt": join(f.trunk(-0.02), f.sleeves(0.04)),
        "vest": join(cut(vest, gap), f.shoes(0.46), f.eyes()),
        "hat": join(within(sheet, tube((0, 0, 0), (0, 0, 3), out)), cut(crown, crease)),
        "scarf": join(
            ring((0, 0, f.top), r * 0.8, 0.11),
            scarf,
            tube((0, 0, brow + 0.1), (0, 0, brow + 0.24), r * 1.07),
        ),
        "jeans": join(f.legs(0.05), tube((0, 0, f.leg - 0.06), (0, 0, f.leg + 0.2), w * 0.9)),
        "skin": join(f.skull(), f.hands()),
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


def soldier(draw: Draw) -> Parts:
    """A round helmet, a pack with a rolled blanket, pouches, boots, a rifle before the chest."""
    f = figure(draw)
    r, w = f.head, f.wide
    x, y = w * 0.5, -w - 0.16
    f = f._replace(hand=(x, y, f.top - 0.5))
    deep = w + draw(0.16, 0.22)
    outline = [  # about the hands: the barrel above, the magazine below, the butt at the left
        (-w - 0.44, -0.2), (-w - 0.44, 0.1), (-w - 0.1, 0.07), (w + 0.1, 0.11), (w + 0.14, 0.06),
        (w + 0.58, 0.06), (w + 0.58, -0.1), (0.14, -0.12), (0.08, -0.38), (-0.16, -0.34),
        (-0.08, -0.12), (-w, -0.12),
    ]  # fmt: skip
    rifle = turned(prism(outline, 1, 0.1), 1, -draw(8, 18))
    brim = lathe([(r * 1.3, f.z + r * 0.4), (r * 1.16, f.z + r * 0.7)], 0.03)
    elbow = (w + 0.24, -0.1, f.top - 0.58)
    arm = join(
        taper((w * 0.84, 0, f.top - 0.2), elbow, 0.2, 0.17), taper(elbow, f.hand, 0.17, 0.15)
    )
    belt = tube((0, 0, f.leg + 0.06), (0, 0, f.leg + 0.22), w * 0.97)
    pouch = box((w * 0.62, -w * 0.8, f.leg + 0.1), (0.14, 0.16, 0.15), 0.03)
    roll = f.top + 0.1
    return {
        "uniform": join(f.trunk(0.03), both(arm), f.legs(0.06)),
        "helmet": join(_dome(f, 0.42, 1.22), brim),
        "pack": join(
            box((0, deep, f.top - 0.4), (w * 0.86, 0.26, 0.42), 0.06),
            tube((-w, deep, roll), (w, deep, roll), 0.19, 0.05),
            belt,
            both(pouch),
            both(
                capsule((w * 0.55, -w * 0.8, f.leg + 0.2), (w * 0.5, -w * 0.66, f.top - 0.1), 0.09)
            ),
        ),
        "boots": join(f.shoes(0.42), f.eyes()),
        "skin": join(f.skull(), f.hands()),
        "rifle": moved(rifle, (0, y, f.top - 0.5)),
    }


PEOPLE_FIGHTERS = {
    "viking": viking,
    "samurai": samurai,
    "ninja": ninja,
    "cowboy": cowboy,
    "pirate": pirate,
    "soldier": soldier,
}
