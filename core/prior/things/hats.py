"""Hats, caps and helmets."""

import math
from typing import TypeVar

import torch
from torch import Tensor

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
    grown,
    join,
    lathe,
    limb,
    mirrored,
    moved,
    prism,
    ring,
    smooth_curve,
    tilted,
    tube,
    turned,
    within,
)

Number = TypeVar("Number", float, Tensor)
FLARE = 0.26  # of a tricorn's brim: how much wider it is a unit higher


def baseball_cap(draw: Draw) -> Parts:
    """A cap with its brim to the front, a round badge above it."""
    wide, high, reach = draw(0.72, 0.8), draw(0.76, 0.9), draw(0.62, 0.78)
    deep, side = wide * 1.06, wide * draw(0.86, 0.96)
    half = [(0, -deep - reach), (side * 0.55, -deep - reach * 0.88), (side * 0.92, -deep - 0.2)]
    plan = smooth_curve([*half, (side, -deep * 0.55), (side * 0.8, -deep * 0.2)], 5)
    brim = grown(prism(mirrored(plan), 2, 0.05), 0.04)
    # Where on the dome the badge sits, and the way out of it.
    at, size = math.radians(draw(36, 42)), draw(0.23, 0.28)
    y, z = -deep * math.cos(at), 0.04 + high * math.sin(at)
    out = (math.cos(at) / deep, math.sin(at) / high)
    dy, dz = (u / math.hypot(*out) for u in out)
    dome = egg((0, 0, 0.04), (wide, deep, high))
    return {
        "cap": cut(dome, box((0, 0, -1), (2, 2, 1))),
        "brim": tilted(brim, draw(2, 7), (0, 0, 0.2)),
        "button": egg((0, 0, high + 0.07), (0.15, 0.15, 0.1)),
        "badge": tube(
            (0, y + dy * 0.2, z - dz * 0.2), (0, y - dy * 0.08, z + dz * 0.08), size, 0.03
        ),
    }


def beanie(draw: Draw) -> Parts:
    """A knitted cap with ribs, a folded brim and a bobble."""
    r, high, fold = draw(0.78, 0.86), draw(1.0, 1.16), draw(0.38, 0.46)
    count, bobble = 14, draw(0.3, 0.36)
    base = fold * 0.7
    side = [(r, 0.05), (r * 0.99, high * 0.4), (r * 0.8, high * 0.72), (0.4, high * 0.94)]
    curve = smooth_curve([*side, (0.0, high)])
    rib = limb([(u - 0.02, 0, h) for u, h in curve[2:-1:3]], 0.1, 0.06)
    cuff = [(r + 0.06, 0.04), (r + 0.14, 0.12), (r + 0.14, fold - 0.08), (r + 0.06, fold)]
    ridge = capsule((r + 0.13, 0, 0.11), (r + 0.13, 0, fold - 0.09), 0.075)
    hollow = lathe([(r - 0.16, -0.2), (r - 0.16, high * 0.3), (0.1, high * 0.6)])
    top, size = high + bobble * 0.72, bobble * 0.8

    def tuft(down: float, turn: float) -> Solid:
        out = size * math.sin(down)
        at = (out * math.cos(turn), out * math.sin(turn), top + size * math.cos(down))
        return ball(at, size * 0.5)

    rows = ((0.0, 1), (0.9, 5), (1.7, 7), (2.5, 4))
    tufts = [tuft(down, math.tau * k / n + down) for down, n in rows for k in range(n)]
    return {
        "cap": cut(lathe(curve), hollow),
        "ribs": cut(around(count, rib), box((0, 0, base - 1), (2, 2, 1))),
        "brim": cut(lathe(cuff, 0.03), hollow),
        "ridges": around(2 * count, ridge),
        "pompom": join(*tufts),
    }


def cowboy_hat(draw: Draw) -> Parts:
    """A hat with a creased crown; its brim curls up at the sides."""
    wide, high, brim, curl = draw(0.48, 0.55), draw(0.65, 0.8), draw(1.0, 1.15), draw(0.25, 0.45)
    curve = [
        (-brim, curl + 0.05),
        (-brim * 0.6, 0.05),
        (0, 0),
        (brim * 0.6, 0.05),
        (brim, curl + 0.05),
    ]
    lower = smooth_curve(curve, 4)
    sheet = prism([*lower, *((u, v + 0.17) for u, v in reversed(lower))], 1, 2)
    plate = cut(sheet, cut(box((0, 0, 0), (3, 3, 3)), egg((0, 0, 0.3), (brim, brim * 1.12, 3.0))))
    crown = join(
        egg((0, 0, high * 0.72), (wide * 0.94, wide * 1.18, high * 0.5)),
        lathe([(wide, 0.05), (wide * 0.95, high * 0.7)], 0.03),
    )
    crease = capsule((0, -wide * 1.2, high * 1.2), (0, wide * 1.2, high * 1.38), 0.2)
    return {
        "body": join(plate, cut(crown, crease, both(ball((wide * 1.1, -wide * 0.75, high), 0.25)))),
        "band": egg((0, 0, 0.32), (wide + 0.13, wide * 1.18 + 0.12, 0.24)),
        "buckle": box((wide + 0.09, 0, 0.23), (0.07, 0.13, 0.13), 0.02),
    }


def wizard_hat(draw: Draw) -> Parts:
    """A tall pointed hat with a wide brim, its side hollow, a star and a buckle in front."""
    wide, high, brim = draw(0.5, 0.6), draw(1.5, 1.8), draw(0.95, 1.1)
    side = smooth_curve([(wide + 0.02, 0.16), (wide * 0.56, high * 0.5), (0.07, high)])
    star = around(5, prism([(0, -0.1), (0.26, 0), (0, 0.1)], 2, 0.09), 90)
    lean = math.degrees(math.atan2(wide * 0.44, high * 0.5))
    return {
        "body": join(lathe(side, 0.02), tube((0, 0, 0), (0, 0, 0.17), brim, 0.05)),
        "ribbon": tube((0, 0, 0.12), (0, 0, 0.34), wide + 0.06, 0.03),
        "stars": moved(turned(star, 0, 90 - lean), (0, -wide * 0.62, high * 0.42)),
        "buckle": box((0, -wide - 0.04, 0.24), (0.15, 0.08, 0.14), 0.02),
    }


def _flare(height: Number) -> Number:
    """How much wider a hat's brim is at this height."""
    return 1 + FLARE * height


def _flared(solid: Solid) -> Solid:
    """``solid``, of up to 1.2 from the axis and in height, widened by :func:`_flare`; a lower
    bound."""

    def distance(p: Tensor) -> Tensor:
        k = _flare(p[:, 2:].clamp(0, 1))
        return solid(torch.cat([p[:, :2] / k, p[:, 2:]], 1)) * 0.78

    return distance


def pirate_hat(draw: Draw) -> Parts:
    """A tricorn, a flap to the front: a dome in a brim folded up thrice, gold along it, a plume."""
    r, point, high = draw(0.5, 0.54), draw(1.08, 1.16), draw(0.74, 0.84)
    low, dome = draw(0.34, 0.4), draw(1.02, 1.12)
    s, c = math.sin(math.pi / 3) * point, math.cos(math.pi / 3) * point
    # Half a flap's edge: along it, out from the middle, up.
    edge = [
        (0.0, r + 0.03, high),
        (0.3, r, high * 0.95),
        (0.62, r - 0.03, high * 0.74),
        (s, c, low),
    ]
    line = smooth_curve([(v, u) for v, u, _ in edge])
    rise = smooth_curve([(v, w) for v, _, w in edge])
    flap = [*((-v, u) for v, u in reversed(line[1:])), *line[:-1]]
    turns = [(math.cos(a), math.sin(a)) for a in (math.radians(k) for k in (30, 150, 270))]
    plan = [(u * i - v * j, u * j + v * i) for i, j in turns for v, u in flap]
    wall = cut(grown(prism(plan, 2, 1, 1.08), 0.09), grown(prism(plan, 2, 1, 1.18), -0.1))
    under = mirrored([(1.4, -1), (1.4, low), *((v, w - 0.03) for v, w in reversed(rise))])
    roll = [
        (u * _flare(w), v * _flare(w), w)
        for (v, u), (_, w) in zip(line[::2], rise[::2], strict=True)
    ]
    roll = [*((u, -v, w) for u, v, w in reversed(roll[1:])), *roll]
    vane = [
        (0, 0),
        (-0.08, 0.3),
        (-0.02, 0.62),
        (0.2, 0.92),
        (0.56, 1.1),
        (0.96, 1.06),
        (1.2, 0.82),
    ]
    barbs = [(0.96, 0.86), (0.88, 0.66), (0.68, 0.74), (0.56, 0.46), (0.38, 0.54), (0.24, 0.2)]
    plume = [*smooth_curve(vane), *barbs, (0.14, 0)]
    return {
        "crown": join(tube((0, 0, 0.04), (0, 0, 0.5), r), egg((0, 0, 0.48), (r, r, dome - 0.48))),
        "brim": _flared(within(wall, around(3, prism(under, 0, 2), 30))),
        "trim": around(3, limb(roll, 0.11, 0.11), 30),
        "feather": moved(
            turned(grown(prism(plume, 1, 0.05), 0.06), 2, 30),
            (0.26, -0.2, high - 0.22),
        ),
    }


def helmet(draw: Draw) -> Parts:
    """A knight's: a slit to look through, a plume over its top and back."""
    wide, high = draw(0.7, 0.8), draw(0.9, 1.05)
    dome = [
        (wide * math.cos(k * math.pi / 24), high + wide * math.sin(k * math.pi / 24))
        for k in range(13)
    ]
    hollow = tube((0, 0, -1), (0, 0, 0.35), wide - 0.15)
    slot = box((0, -wide, high), (wide * 0.8, wide * 0.75, 0.11))
    strip = box((0, -wide, high * 0.45), (0.11, 0.12, high * 0.45))
    rim = join(tube((0, 0, 0), (0, 0, 0.2), wide + 0.06), strip)
    back, up = 0.14, high + draw(0.16, 0.24)
    return {
        "shell": cut(lathe([(wide, 0.05), *dome]), hollow, slot),
        "visor": tube((0, 0, high - 0.2), (0, 0, high + 0.2), wide - 0.1),
        "crest": tube((-0.12, back, up), (0.12, back, up), wide),
        "rim": cut(rim, hollow),
    }


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


HATS = {
    "baseball cap": baseball_cap,
    "beanie": beanie,
    "cowboy hat": cowboy_hat,
    "wizard hat": wizard_hat,
    "pirate hat": pirate_hat,
    "helmet": helmet,
    "viking helmet": viking_helmet,
    "motorcycle helmet": motorcycle_helmet,
    "hard hat": hard_hat,
    "santa hat": santa_hat,
    "chef hat": chef_hat,
}
