"""What one plays with, in the hand, on a table and at a machine; a bow, a flashlight."""

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
    join,
    lathe,
    limb,
    mirrored,
    moved,
    prism,
    ring,
    smooth_curve,
    taper,
    tilted,
    tube,
    turned,
)

Point = tuple[float, float]


def bow(draw: Draw) -> Parts:
    """Upright, strung, its tips curled away from the archer; an arrow may lie on it."""
    belly, back, high = draw(0.3, 0.75), draw(0.2, 0.5), draw(1.25, 1.43)
    x, hold = draw(-0.2, 0.0), draw(0.22, 0.36)
    line = smooth_curve([(x - belly, 0), (x - belly * 0.86, hold + 0.1),
                         (x - belly * 0.1, high * 0.66), (x + back, high * 0.86),
                         (x + back - draw(-0.05, 0.3), high)])  # fmt: skip
    at = [(u, 0.0, v) for u, v in line]
    string = x + back + 0.04

    def raised(solid: Solid) -> Solid:
        return moved(solid, (0.1, 0, high + 0.1))

    parts = {
        "limbs": raised(both(limb(at, 0.15, 0.1), 2)),
        "grip": raised(tube((x - belly, 0, -hold), (x - belly, 0, hold), 0.19, 0.05)),
        "bands": raised(
            both(tube((x - belly, 0, hold - 0.06), (x - belly, 0, hold + 0.09), 0.22, 0.03), 2)
        ),
        "string": raised(tube((string, 0, -high * 0.88), (string, 0, high * 0.88), 0.08)),
    }
    if not draw.has("arrow", 0.5):
        return parts
    front = x - belly - draw(0.3, 0.45)
    tip = [(front - 0.4, 0.0), (front, -0.22), (front, 0.22)]
    vane = [(string - 0.5, 0.05), (string - 0.34, 0.26), (string + 0.12, 0.26), (string, 0.05)]
    return parts | {
        "arrow": raised(
            join(tube((front - 0.05, 0, 0), (string + 0.06, 0, 0), 0.085), prism(tip, 1, 0.1))
        ),
        "feathers": raised(both(prism(vane, 1, 0.08), 2)),
    }


def flashlight(draw: Draw) -> Parts:
    """It lies, its lens to the front; rings to hold it by, a button on top."""
    long, r, head = draw(1.2, 1.48), draw(0.27, 0.38), draw(0.48, 0.62)
    neck, cone = long * draw(0.22, 0.36), draw(0.2, 0.4)
    rings = [tube((0, 0, v), (0, 0, v + 0.13), r + 0.06, 0.03)
             for v in (-long + 0.4, -long + 0.68, -long + 0.96)]  # fmt: skip
    bell = [(r, neck), (head, neck + cone), (head, long)]
    mouth = tube((0, 0, long - 0.1), (0, 0, 2), head - 0.13)
    knob = -neck + 0.16

    def lying(solid: Solid) -> Solid:
        return tilted(solid, 90, (0, 0, head))

    return {
        "body": lying(tube((0, 0, -long), (0, 0, neck + 0.1), r)),
        "head": lying(cut(lathe(bell), mouth)),
        "lens": lying(egg((0, 0, long - 0.12), (head - 0.1, head - 0.1, 0.2))),
        "rings": lying(join(*rings)),
        "cap": lying(join(
            tube((0, 0, -long - 0.06), (0, 0, -long + 0.24), r + 0.05, 0.04),
            tube((0, 0, neck + cone + 0.05), (0, 0, neck + cone + 0.2), head + 0.06, 0.03),
        )),
        "button": box((0, knob, head + r), (0.12, 0.21, 0.09), 0.05),
    }  # fmt: skip


def kite(draw: Draw) -> Parts:
    """A diamond, its upper half of one colour, on crossed spars; a tail with bows."""
    x, low, high = draw(0.8, 1.3), draw(1.1, 1.5), draw(2.85, 3.08)
    z, sway = low + (high - low) * draw(0.5, 0.72), draw(0.08, 0.22)
    tail = smooth_curve([(0, low + 0.1), (-sway, low * 0.78), (sway, low * 0.42), (-sway, 0.08)])
    bow = [(0, 0.05), (0.22, 0.13), (0.22, -0.13), (0, -0.05), (-0.22, -0.13), (-0.22, 0.13)]
    ties = [moved(turned(prism(bow, 1, 0.1), 1, turn), (tail[k][0], 0, tail[k][1]))
            for k, turn in ((4, 35), (8, -35), (12, 20))]  # fmt: skip
    return {
        "sail": prism([(-x, z), (0, high), (x, z)], 1, 0.1),
        "keel": prism([(-x, z), (x, z), (0, low)], 1, 0.1),
        "spars": join(
            tube((0, 0.06, low - 0.02), (0, 0.06, high), 0.1, 0.03),
            capsule((-x, 0.06, z), (x, 0.06, z), 0.1),
            box((0, -0.04, (low + high) / 2), (0.07, 0.13, (high - low) / 2 - 0.05), 0.02),
            box((0, -0.04, z), (x - 0.1, 0.13, 0.07), 0.02),
        ),
        "tail": limb([(u, 0.0, v) for u, v in tail], 0.09, 0.09),
        "bows": join(*ties),
    }


def yo_yo(draw: Draw) -> Parts:
    """Two discs on an axle, a star on each; its string rises to a loop."""
    r, deep, slot = draw(0.7, 1.05), draw(0.2, 0.42), 0.13
    top, loop = min(2 * r + draw(0.3, 0.75), 2.5), draw(0.18, 0.26)
    half = [(r * 0.8, slot), (r, slot + 0.1), (r * 0.96, slot + deep * 0.6),
            (r * 0.74, slot + deep)]  # fmt: skip
    face = lathe([(r * 0.62, slot + deep - 0.05), (r * 0.62, slot + deep + 0.06)])
    point = prism([(0.0, -0.15), (r * 0.52, -0.02), (r * 0.52, 0.02), (0.0, 0.15)], 2,
                  0.1, slot + deep + 0.03)  # fmt: skip

    def facing(solid: Solid) -> Solid:
        return both(tilted(solid, -90, (0, 0, r)), 1)

    return {
        "discs": facing(lathe(smooth_curve(half, 3))),
        "faces": facing(face),
        "stars": facing(around(5, point, -90)),
        "axle": both(tube((0, 0, r), (0, slot + deep + 0.19, r), 0.13, 0.03), 1),
        "string": join(
            tube((0, 0, r), (0, 0, top), 0.09),
            ring((0, 0, top + loop), loop, 0.09, 1),
            tube((0, -slot, r), (0, slot, r), r * 0.66),
        ),
    }


def slingshot(draw: Draw) -> Parts:
    """A forked branch; two bands hang from it to a pouch with a stone."""
    x, fork, high = draw(0.55, 0.95), draw(0.95, 1.45), draw(2.45, 2.9)
    thick, sag = draw(0.16, 0.23), draw(0.5, 0.95)
    prong = smooth_curve([(0.0, fork - 0.1), (x * 0.62, fork + 0.24), (x, fork + 0.75), (x, high)])
    pouch = (0.0, -0.5, high - 0.2 - sag)
    tie = high - 0.24
    return {
        "fork": join(
            both(limb([(u, 0.0, v) for u, v in prong], thick + 0.02, thick - 0.03)),
            taper((0, 0, 0.25), (0, 0, fork), thick + 0.03, thick + 0.02),
        ),
        "grip": join(
            tube((0, 0, 0.06), (0, 0, fork - 0.3), thick + 0.1, 0.06),
            *(tube((0, 0, v), (0, 0, v + 0.14), thick + 0.14, 0.05)
              for v in (0.04, (fork - 0.3) / 2, fork - 0.4)),
        ),
        "bands": both(capsule((x, -0.1, tie), (0.2, pouch[1], pouch[2] + 0.06), 0.1)),
        "pouch": box(pouch, (0.3, 0.13, 0.2), 0.09),
        "stone": ball((0, pouch[1] - 0.1, pouch[2] + 0.02), 0.17),
        "ties": both(tube((x, 0, tie - 0.12), (x, 0, tie + 0.12), thick + 0.07, 0.04)),
    }  # fmt: skip


def boomerang(draw: Draw) -> Parts:
    """Upright on its tips, a smooth flat wing bent in the middle, its bands wholly around it."""
    x, high, wide, flat = draw(1.34, 1.42), draw(1.24, 1.34), draw(0.31, 0.34), 0.4
    end, bend = wide * 0.78, draw(0.32, 0.38)
    stops = smooth_curve([(0.0, high), (bend, high - 0.12), (x * 0.6, high * 0.56), (x, end)], 3)
    wing = [((u, 0.0, v), wide + (end - wide) * u / x) for u, v in stops]
    ((a, _, b), first), ((c, _, d), last) = wing[-4], wing[-1]

    def flattened(solid: Solid) -> Solid:
        """``solid``, thinner from front to back."""
        return lambda p: solid(p * p.new_tensor([1, 1 / flat, 1])) * flat

    def at(s: float) -> tuple[float, float, float]:
        return (a + (c - a) * s, 0.0, b + (d - b) * s)

    def band(s: float) -> Solid:
        """About the straight end of an arm, at ``s`` of it."""
        wider = first + (last - first) * s + 0.08
        return both(flattened(tube(at(s - 0.1), at(s + 0.1), wider, 0.03)))

    dot = (high - 0.03, wide * flat + 0.06)
    return {
        "body": both(flattened(chain(wing))),
        "bands": join(band(0.0), band(0.72)),
        "stripes": band(0.36),
        "dot": tube((0, -dot[1], dot[0]), (0, dot[1], dot[0]), 0.19, 0.03),
    }


def _repeated(solid: Solid, pitch: float, count: int) -> Solid:
    """``solid``, symmetric about the axes, at ``count`` places along x and as many along y."""
    last = (count - 1) / 2

    def nearest(u: Tensor) -> Tensor:
        return u - pitch * ((u / pitch + last).round().clamp(0, count - 1) - last)

    return lambda p: solid(torch.stack([nearest(p[:, 0]), nearest(p[:, 1]), p[:, 2]], 1))


def _chessman(at: Point, low: float, tall: float, royal: bool) -> Solid:
    """A piece on its foot; it has a round head, or a crown and a knob."""
    high, (x, y) = low + tall, at
    foot = [(0.14, low), (0.14, low + 0.07), (0.07, low + 0.16)]
    if not royal:
        return join(lathe([*foot, (0.06, high - 0.28)], 0.02, (x, y)),
                    ball((x, y, high - 0.14), 0.14))  # fmt: skip
    crown = [(0.07, high - 0.36), (0.15, high - 0.12), (0.03, high - 0.06)]
    return join(lathe([*foot, *crown], 0.02, (x, y)), ball((x, y, high - 0.02), 0.09))


def chessboard(draw: Draw) -> Parts:
    """Eight by eight squares in a frame, the dark ones raised; pieces may stand on it."""
    pitch, rim, high = draw(0.29, 0.32), draw(0.12, 0.26), draw(0.2, 0.5)
    side, top, tall = 4 * pitch, high + 0.03, draw(0.44, 0.7)
    check = _repeated(box((0, 0, high), (pitch * 0.44, pitch * 0.44, 0.03)), 2 * pitch, 4)
    parts = {
        "frame": cut(
            box((0, 0, high / 2 + 0.03), (side + rim, side + rim, high / 2 + 0.03), 0.03),
            box((0, 0, high + 0.5), (side, side, 0.52)),
        ),
        "squares": box((0, 0, high / 2), (side, side, high / 2)),
        "checks": join(
            moved(check, (pitch / 2, pitch / 2, 0)), moved(check, (-pitch / 2, -pitch / 2, 0))
        ),
    }
    if not draw.has("pieces", 0.5):
        return parts

    def men(sign: float) -> Solid:
        places = ((3.5, 3.5, 0.1), (1.5, 3.5, 0.34), (2.5, 2.5, 0), (0.5, 1.5, 0))
        row = (_chessman((u * pitch, sign * v * pitch), top - 0.02, tall + more, more > 0.2)
               for u, v, more in places)  # fmt: skip
        return both(join(*row))

    return parts | {"pieces": men(-1), "rivals": men(1)}


def slot_machine(draw: Draw) -> Parts:
    """A cabinet with three reels that show sevens, a lever at its side, a tray, a sign above."""
    x, y, high = draw(0.68, 0.98), draw(0.45, 0.7), draw(1.8, 2.4)
    z, tall, shelf = high * draw(0.62, 0.68), draw(0.27, 0.36), draw(0.46, 0.6)
    pitch, arm = x * 0.52, x + 0.26
    arch = smooth_curve(
        [(x * 0.98, high - 0.1), (x * 0.9, high + 0.36), (0.34, high + draw(0.46, 0.66))]
    )
    seven = [(-0.13, 0.1), (-0.13, 0.22), (0.15, 0.22), (0.15, 0.12), (0.03, -0.22), (-0.12, -0.22),
             (0.0, 0.1)]  # fmt: skip
    sevens = [moved(prism(seven, 1, 0.12), (pitch * k, -y - 0.05, z)) for k in (-1, 0, 1)]
    lamp = [tube((x * 0.3 * k, -y - 0.04, high + 0.24), (x * 0.3 * k, y * 0.5, high + 0.24), 0.1)
            for k in (-2, 0, 2)]  # fmt: skip
    return {
        "cabinet": join(
            cut(
                box((0, 0, high / 2), (x, y, high / 2), 0.06),
                box((0, -y, z), (pitch * 1.42, 0.12, tall)),
                box((0, -y, shelf - 0.1), (x * 0.62, 0.24, 0.16)),
            ),
            box((0, -y - 0.02, z - tall - 0.3), (x * 0.98, 0.18, 0.1), 0.03),
        ),
        "sign": prism(mirrored(arch), 1, y * 0.8),
        "trim": join(
            cut(
                box((0, -y, z), (pitch * 1.42 + 0.12, 0.07, tall + 0.12), 0.02),
                box((0, -y, z), (pitch * 1.42, 1, tall)),
            ),
            box((0, -y - 0.08, shelf - 0.27), (x * 0.7, 0.22, 0.08), 0.03),
            tube((x - 0.05, 0, z - 0.3), (arm + 0.08, 0, z - 0.3), 0.17, 0.03),
            capsule((arm, 0, z - 0.3), (arm, -0.1, high - 0.1), 0.095),
            *lamp,
        ),
        "reels": join(*(tube((pitch * k - pitch * 0.42, -y + 0.3, z),
                             (pitch * k + pitch * 0.42, -y + 0.3, z), tall + 0.04)
                        for k in (-1, 0, 1))),
        "sevens": join(*sevens),
        "knob": join(
            ball((arm, -0.1, high), draw(0.19, 0.24)),
            *(tube((u, -y - 0.02, z - tall - 0.3), (u, -y - 0.02, z - tall - 0.14), 0.11, 0.02)
              for u in (-x * 0.5, 0, x * 0.5)),
        ),
    }  # fmt: skip


def game_console(draw: Draw) -> Parts:
    """One for the hand, upright: a screen in its bezel above a cross and buttons, or between."""
    if draw.chance(0.35):
        x, high, y = draw(1.3, 1.48), draw(1.25, 1.6), draw(0.18, 0.28)
        z, wide, tall = high / 2, x * 0.5, high / 2 - 0.14
        side, level, keys, apart = x * 0.76, high * 0.56, high * 0.2, 0.15
    else:
        x, high, y = draw(0.86, 1.12), draw(2.3, 3.0), draw(0.2, 0.36)
        z, wide, tall = draw(0.7, 0.74) * high, x - 0.12, high * draw(0.19, 0.235)
        side, level, keys, apart = x * 0.5, high * 0.36, high * 0.14, 0.19
    cross, rim, front = draw(0.09, 0.11), draw(0.13, 0.24), -y - 0.03
    pads = [(side + k * apart, level + k * 0.1) for k in (1, -1)]
    key = turned(capsule((-0.12, 0, 0), (0.12, 0, 0), 0.085), 1, -25)
    slit = turned(capsule((0, 0, -0.13), (0, 0, 0.13), 0.07), 1, 25)
    return {
        "body": box((0, 0, high / 2), (x, y, high / 2), 0.12),
        "bezel": box((0, -y, z), (wide, 0.05, tall), 0.04),
        "screen": box((0, -y - 0.03, z), (wide - rim, 0.06, tall - 0.13), 0.02),
        "cross": join(
            box((-side, front, level), (cross * 3, 0.1, cross), 0.02),
            box((-side, front, level), (cross, 0.1, cross * 3), 0.02),
        ),
        "buttons": join(*(tube((u, front - 0.09, v), (u, 0, v), apart - 0.02, 0.04)
                          for u, v in pads)),
        "keys": join(
            *(moved(key, (u - side * 0.9, -y, keys)) for u in (-0.18, 0.18)),
            *(moved(slit, (u + side, -y, keys)) for u in (-0.14, 0.14)),
        ),
    }  # fmt: skip


LEISURE = {
    "bow": bow,
    "flashlight": flashlight,
    "kite": kite,
    "yo-yo": yo_yo,
    "slingshot": slingshot,
    "boomerang": boomerang,
    "chessboard": chessboard,
    "slot machine": slot_machine,
    "game console": game_console,
}
