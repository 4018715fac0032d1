"""Hats by who wears them: a viking, a rider, a builder, a cook, Father Christmas."""

import math

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
    around,
    ball,
    both,
    box,
    chain,
    cut,
    egg,
    grown,
    join,
    lathe,
    limb,
    prism,
    ring,
    smooth_curve,
    tilted,
    tube,
    within,
)


def _dome(wide: float, deep: float, high: float, low: float) -> Solid:
    """The upper half of an egg, from the height ``low`` on."""
    return cut(egg((0, 0, low), (wide, deep, high - low)), box((0, 0, low - 2), (3, 3, 2)))


def _across(dome: Solid, by: float, half: float, axis: int) -> Solid:
    """A band over a dome, ``by`` out of it, ``half`` its width, across ``axis``."""
    middle = [half if k == axis else 3.0 for k in range(3)]
    return within(grown(dome, by), box((0, 0, 0), (middle[0], middle[1], middle[2])))


def viking_helmet(draw: Draw) -> Parts:
    """An iron dome with bands across and around it, rivets, a nose guard, two curved horns."""
    r, high, band = draw(0.74, 0.8), draw(0.92, 1.02), draw(0.3, 0.36)
    out, up, thick = draw(1.2, 1.34), draw(1.24, 1.42), draw(0.2, 0.23)
    dome = _dome(r, r * 1.08, high, 0.12)
    hollow = tube((0, 0, -1), (0, 0, 0.34), r - 0.17)
    rim = lathe([(r * 1.09, 0.0), (r * 1.09, band)], 0.02)
    above = box((0, 0, band - 0.06 + 1), (2, 2, 1))
    nose = prism([(-0.1, band), (0.1, band), (0.13, -0.34), (-0.13, -0.34)], 1, 0.07, -r * 1.06)
    curve = smooth_curve([(r * 0.86, band + 0.14), (r + 0.24, band + 0.2), (out, band + 0.48),
                          (out + 0.04, up - 0.24), (out - 0.14, up + 0.1)])  # fmt: skip
    horn = limb([(u, 0, v) for u, v in curve], thick, 0.06)
    socket = tube((r * 0.8, 0, band + 0.13), (r + 0.16, 0, band + 0.22), thick + 0.07, 0.02)
    return {
        "shell": cut(dome, hollow),
        "bands": join(
            cut(rim, hollow),
            within(join(_across(dome, 0.06, 0.1, 0), _across(dome, 0.06, 0.1, 1)), above),
            nose,
        ),
        "horns": both(horn),
        "sockets": both(socket),
        "rivets": join(
            around(8, ball((r * 1.08, 0, band / 2), 0.085), 22.5), ball((0, 0, high + 0.06), 0.13)
        ),
    }


def motorcycle_helmet(draw: Draw) -> Parts:
    """Round, with a chin bar, a dark visor across the face and a stripe over its top."""
    x, y, z = draw(0.76, 0.8), draw(0.92, 0.98), draw(0.86, 0.9)
    mid, bottom = 0.86, draw(0.1, 0.14)
    head = egg((0, 0, mid), (x, y, z))
    chin = egg((0, -0.08, 0.46), (x * 0.97, y, 0.66))
    shell = cut(join(head, chin), box((0, 0, bottom - 2), (3, 3, 2)))
    hollow = tube((0, 0, -1), (0, 0, 0.4), x - 0.22)
    low, tall = draw(0.6, 0.64), draw(1.18, 1.24)
    half = (low + tall) / 2
    face = prism([(-2, low), (-0.1, low), (0.08, half), (-0.16, tall), (-2, tall)], 0, 2)
    seam = [(-2, low - 0.09), (-0.06, low - 0.09), (0.18, half), (-0.12, tall + 0.09)]
    seam = prism([*seam, (-2, tall + 0.09)], 0, 2)
    window = cut(head, grown(head, -0.2))
    return {
        "shell": cut(shell, hollow),
        "visor": within(grown(window, 0.05), face),
        "trim": join(
            within(grown(window, 0.025), cut(seam, face)),
            cut(within(grown(shell, 0.04), box((0, 0, bottom + 0.02), (2, 2, 0.07))), hollow),
        ),
        "stripe": cut(
            within(grown(head, 0.035), box((0, 0, mid + 1), (draw(0.16, 0.2), 2, 1))),
            grown(head, -0.1), seam,
        ),
        "hinges": both(tube((x - 0.1, -0.02, 0.92), (x + 0.07, -0.02, 0.92), 0.15, 0.02)),
    }  # fmt: skip


def hard_hat(draw: Draw) -> Parts:
    """A dome with ridges from front to back, a brim that is a peak in front, a badge."""
    x, y, high = draw(0.72, 0.77), draw(0.84, 0.9), draw(0.92, 1.0)
    peak, edge = draw(0.36, 0.44), draw(0.12, 0.15)
    dome = _dome(x, y, high, 0.06)
    plan = [(0, -y - peak), (x * 0.62, -y - peak * 0.78), (x * 0.98, -y * 0.72)]
    half = smooth_curve(
        [*plan, (x + edge, -y * 0.2), (x + edge, y * 0.3), (x * 0.7, y * 0.86), (0, y + edge)]
    )
    brim = grown(prism([*half, *((-u, v) for u, v in reversed(half[1:-1]))], 2, 0.03), 0.05)
    hollow = tube((0, 0, -1), (0, 0, 0.22), x - 0.18)
    low = cut(box((0, 0, 2.16), (2, 2, 2)), tube((0, -3, 0), (0, -y * 0.72, 0), 3))
    ridge = _across(dome, 0.06, 0.1, 0)
    side = within(grown(dome, 0.05), box((x * 0.42, 0, 0), (0.075, 3, 3)))
    at = math.radians(draw(30, 36))
    front = (-y * math.cos(at), 0.06 + (high - 0.06) * math.sin(at))
    return {
        "shell": cut(dome, hollow),
        "ridges": within(join(ridge, both(side)), low),
        "brim": cut(tilted(brim, 3, (0, 0, 0.08)), hollow),
        "badge": tube(
            (0, front[0] + 0.16, front[1] - 0.1), (0, front[0] - 0.05, front[1] + 0.03), 0.17, 0.02
        ),
    }


def santa_hat(draw: Draw) -> Parts:
    """A soft red cone that falls to the right, a white fur brim, a bobble at its tip."""
    r, high, out = draw(0.62, 0.68), draw(1.3, 1.44), draw(0.84, 0.96)
    fur, bobble, drop = draw(0.2, 0.23), draw(0.24, 0.28), draw(0.3, 0.42)
    tip = (out, 0.0, high - drop)
    cone = chain(
        [
            ((0, 0, 0.34), r),
            ((0.04, 0, high * 0.52), r * 0.76),
            ((0.16, 0, high * 0.78), r * 0.52),
            ((out * 0.46, 0, high - 0.08), r * 0.36),
            ((out * 0.8, 0, high - 0.14), r * 0.26),
            (tip, r * 0.18),
        ]
    )
    hollow = tube((0, 0, -1), (0, 0, 0.3), r - 0.16)
    return {
        "cap": cut(cone, box((0, 0, 0.1 - 2), (3, 3, 2)), hollow),
        "brim": cut(ring((0, 0, fur), r, fur), hollow),
        "pompom": ball((tip[0] + 0.06, 0, tip[2] - bobble * 0.7), bobble),
    }


def chef_hat(draw: Draw) -> Parts:
    """A tall white band, above it puffed cloth in folds."""
    r, band, puff = draw(0.56, 0.62), draw(0.62, 0.76), draw(0.36, 0.4)
    top = band + draw(0.36, 0.44)
    fold = egg((r * 0.72, 0, top), (0.4, puff * 0.86, puff))
    hollow = tube((0, 0, -1), (0, 0, 0.3), r - 0.16)
    return {
        "band": cut(lathe([(r, 0.0), (r, band)], 0.03), hollow),
        "top": join(
            around(8, fold), egg((0, 0, top + 0.14), (r * 0.9, r * 0.9, 0.42)),
            tube((0, 0, band - 0.05), (0, 0, top), r * 0.94),
        ),
    }  # fmt: skip


HEADWEAR = {
    "viking helmet": viking_helmet,
    "motorcycle helmet": motorcycle_helmet,
    "hard hat": hard_hat,
    "santa hat": santa_hat,
    "chef hat": chef_hat,
}
