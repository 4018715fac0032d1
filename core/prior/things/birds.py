"""Less common birds."""

import math

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
    ball,
    blend,
    both,
    capsule,
    chain,
    egg,
    join,
    limb,
    moved,
    prism,
    smooth_curve,
    taper,
    tilted,
    tube,
    turned,
)
from core.prior.things.shared.faces import eyes
from core.prior.things.shared.fitted import fitted
from core.prior.things.shared.wings_and_claws import front_toes, hooked_bill


def swan(draw: Draw) -> Parts:
    """Swims: a neck like an S, raised wings, an orange bill with a black root."""
    wide, long, up = draw(0.48, 0.56), draw(0.76, 0.88), draw(1.02, 1.22)
    z, y = 0.4, -long + 0.06
    top = z + up
    bow = smooth_curve(
        [(y + 0.2, z + 0.08), (y - 0.12, z + 0.3), (y + 0.06, z + up * 0.52), (y + 0.1, top - 0.12),
         (y - 0.1, top + 0.06)], 3
    )  # fmt: skip
    trunk = blend(
        0.14,
        egg((0, 0, z), (wide, long, 0.4)),
        taper((0, long * 0.6, z + 0.06), (0, long + 0.2, z + 0.34), 0.26, 0.1),
        limb([(0, a, b) for a, b in bow], 0.21, 0.13),
    )
    h, x = top + 0.06, y - 0.14
    feathers = [
        tilted(
            egg((0, 0, 0), (0.13, 0.62 * s, 0.27 * s)),
            -t,
            (wide * 0.86, 0.2 + 0.18 * k, z + 0.16 + 0.14 * k),
        )
        for k, (s, t) in enumerate(((1.0, 10), (0.84, 22)))
    ]
    return {
        "body": join(trunk, egg((0, x, h), (0.18, 0.24, 0.18))),
        "wings": both(join(*feathers)),
        "face": join(egg((0, x - 0.22, h), (0.13, 0.1, 0.13)), ball((0, x - 0.28, h + 0.09), 0.09)),
        "bill": taper((0, x - 0.28, h - 0.03), (0, x - 0.52, h - 0.1), 0.12, 0.085),
        "eyes": both(ball((0.14, x - 0.02, h + 0.07), 0.075)),
    }


def flamingo(draw: Draw) -> Parts:
    """On two long legs; the neck a bow, the bill bent down with a dark end."""
    leg, wide, up = draw(0.86, 1.02), draw(0.33, 0.39), draw(0.78, 0.92)
    z = leg + 0.26
    top = z + up
    bow = smooth_curve(
        [(-0.4, z + 0.1), (-0.76, z + 0.22), (-0.72, z + up * 0.6), (-0.5, top - 0.06),
         (-0.66, top + 0.16)], 3
    )  # fmt: skip
    y, h = -0.7, top + 0.16
    trunk = blend(
        0.12,
        egg((0, 0, z), (wide, 0.56, 0.33)),
        taper((0, 0.3, z + 0.02), (0, 0.74, z - 0.02), 0.22, 0.1),
        limb([(0, a, b) for a, b in bow], 0.17, 0.11),
    )
    wing = tilted(egg((0, 0, 0), (0.13, 0.56, 0.26)), -6, (wide * 0.86, 0.2, z + 0.07))
    shank = taper((0.17, 0.04, z - 0.2), (0.17, 0.04, 0.08), 0.09, 0.085)
    web = prism(
        [(0.08, 0.1), (0.26, 0.1), (0.36, -0.32), (0.17, -0.26), (-0.02, -0.32)], 2, 0.07, 0.07
    )
    return {
        "body": join(trunk, ball((0, y, h), 0.21)),
        "wings": both(wing),
        "legs": both(join(shank, web, ball((0.17, 0.04, leg * 0.5), 0.125))),
        "bill": taper((0, y - 0.14, h - 0.01), (0, y - 0.36, h - 0.12), 0.13, 0.11),
        "tip": taper((0, y - 0.38, h - 0.14), (0, y - 0.42, h - 0.32), 0.115, 0.07),
        "eyes": both(ball((0.15, y - 0.09, h + 0.07), 0.08)),
    }


def ostrich(draw: Draw) -> Parts:
    """A great ball of feathers on long bare legs, a long bare neck, a flat bill."""
    leg, wide, up = draw(1.0, 1.2), draw(0.48, 0.56), draw(0.95, 1.15)
    z = leg + 0.34
    y, top = -0.72, z + up + 0.2
    neck = [(0, -0.42, z + 0.12), (0, -0.68, z + 0.34), (0, -0.66, z + up * 0.66), (0, y, top)]
    shank = join(
        taper((0.24, 0.04, z - 0.12), (0.24, 0.1, leg * 0.54), 0.19, 0.12),
        taper((0.24, 0.1, leg * 0.54), (0.24, 0.0, 0.1), 0.12, 0.1),
        taper((0.22, 0.0, 0.1), (0.2, -0.36, 0.1), 0.12, 0.1),
        taper((0.26, 0.0, 0.1), (0.4, -0.2, 0.1), 0.11, 0.095),
    )
    wing = tilted(egg((0, 0, 0), (0.16, 0.5, 0.34)), 10, (wide * 0.86, 0.1, z + 0.08))
    frill = [
        egg((wide * 0.84, v, z - 0.14 + v * 0.16), (0.17, 0.16, 0.19)) for v in (0.06, 0.34, 0.58)
    ]
    plume = [
        taper((x, 0.56, z + 0.16), (x * 2.2, 0.56 + a, z + 0.16 + v), 0.2, 0.15)
        for x, a, v in ((0.0, 0.3, 0.36), (0.14, 0.42, 0.16))
    ]
    return {
        "body": join(egg((0, 0.08, z), (wide, 0.7, 0.46)), both(wing)),
        "plumes": join(
            both(join(*frill, *plume)), tube((0, -0.44, z + 0.1), (0, -0.56, z + 0.22), 0.26, 0.08)
        ),
        "skin": join(
            limb(neck, 0.19, 0.13),
            egg((0, y - 0.04, top + 0.04), (0.22, 0.26, 0.2)),
            both(shank),
        ),
        "bill": egg((0, y - 0.32, top + 0.02), (0.17, 0.24, 0.09)),
        "hair": egg((0, y + 0.05, top + 0.17), (0.15, 0.18, 0.12)),
        "eyes": eyes(0.18, y - 0.12, top + 0.12, 0.1),
    }  # fmt: skip


def peacock(draw: Draw) -> Parts:
    """The fan of its tail spread behind it, an eye on each feather; a crown of three."""
    leg, wide, reach = draw(0.36, 0.46), draw(0.3, 0.35), draw(1.08, 1.24)
    z, y = leg + 0.28, 0.3
    top = z + draw(0.68, 0.8)
    low, count = z - 0.05, 9
    turns = [math.radians(2 + 176 * k / (count - 1)) for k in range(count)]
    rim = [(reach * math.cos(a), low + reach * math.sin(a)) for a in turns]
    inner = [
        (reach * 0.66 * math.cos(a), low + reach * 0.66 * math.sin(a))
        for a in (math.radians(13 + 154 * k / 6) for k in range(7))
    ]

    def discs(at: list[tuple[float, float]], radius: float, front: float) -> Solid:
        return join(*(tube((x, front, h), (x, y + 0.1, h), radius) for x, h in at))

    neck = limb([(0, -0.2, z + 0.08), (0, -0.42, z + 0.34), (0, -0.4, top)], 0.24, 0.13)
    trunk = blend(0.12, egg((0, 0, z), (wide, 0.48, 0.3)), neck)
    crown = [capsule((0, -0.36, top + 0.12), (x, -0.34, top + 0.4), 0.07) for x in (-0.16, 0, 0.16)]
    tips = [ball((x, -0.34, top + 0.42), 0.1) for x in (-0.2, 0, 0.2)]
    shank = taper((0.15, 0.02, z - 0.16), (0.15, 0, 0.09), 0.1, 0.085)
    toes = [capsule((0.15, 0.06, 0.08), (x, -0.26, 0.08), 0.085) for x in (0.04, 0.28)]
    return {
        "body": join(trunk, ball((0, -0.42, top), 0.19), *crown, *tips),
        "tail": join(prism([*rim, (0, low - 0.25)], 1, 0.1, y), discs(rim, 0.24, y - 0.1),
                     taper((0, 0.2, z), (0, y, low + 0.1), 0.24, 0.22)),
        "patches": join(discs(rim, 0.17, y - 0.15), discs(inner, 0.15, y - 0.15)),
        "pupils": join(discs(rim, 0.09, y - 0.2), discs(inner, 0.08, y - 0.2)),
        "bill": join(taper((0, -0.56, top - 0.02), (0, -0.74, top - 0.07), 0.1, 0.06),
                     both(join(shank, *toes))),
        "eyes": both(ball((0.13, -0.53, top + 0.06), 0.08)),
    }  # fmt: skip


def parrot(draw: Draw) -> Parts:
    """A macaw that stands upright: a great hooked beak in a white face, a long tail."""
    wide, long, head = draw(0.4, 0.46), draw(0.92, 1.1), draw(0.34, 0.39)
    z, lean = 1.0, 0.2
    y, up = -lean, z + 0.72
    root = (0, 0.22, z - 0.3)
    tail = [
        taper((x, 0.2, z - 0.3), (x * 1.7, 0.2 + long * 0.9, 0.1 - abs(x) * 0.2), 0.14, 0.1)
        for x in (-0.1, 0.1)
    ]
    wing = moved(turned(egg((0, 0, 0), (0.15, 0.34, 0.62)), 0, 24), (wide * 0.92, 0.16, z - 0.04))
    coverts = moved(turned(egg((0, 0, 0), (0.17, 0.34, 0.3)), 0, 24), (wide * 0.92, 0.03, z + 0.22))
    bill = join(
        hooked_bill((0, y - head * 0.72, up + 0.06), 0.2, 0.2),
        ball((0, y - head * 0.86, up - 0.18), 0.13),
        both(
            join(
                taper((0.2, -0.06, z - 0.5), (0.2, -0.1, 0.12), 0.13, 0.1),
                front_toes(0.2, -0.1, 0.28, 0.09),
            )
        ),
    )
    return {
        "body": join(
            blend(0.12, egg((0, 0, z), (wide, wide * 0.92, 0.66)), ball((0, y, up), head)),
            taper(root, (0, 0.24 + long, 0.1), 0.2, 0.12),
        ),
        "wings": join(both(wing), *tail),
        "coverts": both(coverts),
        "face": both(
            egg((head * 0.52, y - head * 0.42, up + 0.02), (head * 0.5, head * 0.5, head * 0.52))
        ),
        "bill": bill,
        "eyes": eyes(head * 0.82, y - head * 0.56, up + 0.1, 0.1),
    }


def toucan(draw: Draw) -> Parts:
    """Black with a white throat and a huge orange bill that curves to a black tip."""
    wide, head, long = draw(0.42, 0.45), draw(0.38, 0.4), draw(0.94, 1.0)
    z, y = 0.98, -0.16
    up = z + 0.72
    bill = [((0, y - head * 0.6, up + 0.04), 0.29), ((0, y - head - 0.32, up + 0.08), 0.27),
            ((0, y - head - long * 0.66, up - 0.04), 0.21)]  # fmt: skip
    tip = [((0, y - head - long * 0.66, up - 0.04), 0.222), ((0, y - head - long, up - 0.26), 0.1)]
    wing = moved(turned(egg((0, 0, 0), (0.15, 0.34, 0.58)), 0, 22), (wide * 0.9, 0.12, z - 0.02))
    tail = prism([(-0.14, 0.0), (0.14, 0.0), (0.24, 0.84), (-0.24, 0.84)], 2, 0.1)
    toes = join(*(capsule((0.2, -0.08, 0.1), (0.2 + u, -0.42, 0.1), 0.1) for u in (-0.12, 0.12)))
    return {
        "body": join(
            blend(0.12, egg((0, 0, z), (wide, wide * 0.94, 0.66)), ball((0, y, up), head)),
            both(wing), tilted(tail, -44, (0, 0.2, z - 0.34)),
        ),
        "throat": join(
            egg((0, -0.2, z + 0.4), (wide * 0.72, wide * 0.72, 0.4)),
            both(egg((head * 0.5, y - head * 0.4, up - 0.02),
                     (head * 0.5, head * 0.56, head * 0.6))),
        ),
        "bill": chain(bill),
        "tip": chain(tip),
        "skin": join(
            both(ball((head * 0.66, y - head * 0.5, up + 0.12), 0.17)),
            both(join(taper((0.2, -0.04, z - 0.5), (0.2, -0.08, 0.1), 0.13, 0.1), toes)),
        ),
        "eyes": eyes(head * 0.66 + 0.1, y - head * 0.5 - 0.08, up + 0.14, 0.1),
    }  # fmt: skip


def eagle(draw: Draw) -> Parts:
    """A bald eagle that stands with its wings half spread: white head and tail, a hooked beak."""
    wide, head, span = draw(0.42, 0.48), draw(0.31, 0.35), draw(1.2, 1.4)
    z, lift = 1.02, draw(0.5, 0.75)
    y, up = -0.26, z + 0.74
    vane = [(0.1, z + 0.4), (span * 0.5, z + 0.5 + lift), (span, z + 0.34 + lift)]
    vane += [
        (span * 0.98, z - 0.06 + lift * 0.4),
        (span * 0.8, z + 0.1 + lift * 0.2),
        (span * 0.78, z - 0.3 + lift * 0.2),
        (span * 0.58, z - 0.12),
        (span * 0.52, z - 0.46),
        (span * 0.34, z - 0.24),
        (0.1, z - 0.4),
    ]
    fan = [(-0.16, 0.1), (0.16, 0.1), (0.36, 0.86), (-0.36, 0.86)]
    thigh = join(taper((0.24, 0, z - 0.4), (0.24, -0.04, 0.42), 0.24, 0.15))
    return {
        "body": join(egg((0, 0, z), (wide, wide * 0.9, 0.66)), both(thigh)),
        "wings": both(prism(vane, 1, 0.1, 0.12)),
        "head": join(
            blend(
                0.1,
                ball((0, y, up), head),
                taper((0, y, up), (0, -0.1, z + 0.3), head * 0.9, wide * 0.8),
            ),
            tilted(prism(fan, 2, 0.09), -38, (0, 0.1, z - 0.36)),
        ),
        "bill": hooked_bill((0, y - head * 0.8, up), 0.16, 0.2),
        "legs": both(
            join(
                tube((0.24, -0.04, 0.1), (0.24, -0.04, 0.5), 0.1),
                front_toes(0.24, 0.0, 0.36, 0.095),
            )
        ),
        "eyes": eyes(head * 0.7, y - head * 0.62, up + 0.1, 0.085),
    }


BIRDS = {
    "swan": fitted(swan),
    "flamingo": fitted(flamingo),
    "ostrich": fitted(ostrich),
    "peacock": fitted(peacock),
    "parrot": parrot,
    "toucan": fitted(toucan),
    "eagle": eagle,
}
