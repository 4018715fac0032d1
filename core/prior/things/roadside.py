"""What stands at a road or by it, what is fixed in a yard, and a battery."""

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
    grown,
    join,
    lathe,
    limb,
    moved,
    prism,
    ring,
    smooth_curve,
    tilted,
    tube,
    turned,
    within,
)

Point = tuple[float, float]


def _shaded_lamp(x: float, y: float, z: float, r: float) -> tuple[Solid, Solid]:
    """A bell that hangs at (x, y, z) and the light in it."""
    bell = [(r, z - 0.42), (r, z - 0.36), (r * 0.55, z - 0.12), (0.13, z), (0.13, z + 0.1)]
    return lathe(bell, 0.02, (x, y)), ball((x, y, z - 0.42), r * 0.68)


def street_lamp(draw: Draw) -> Parts:
    """A lantern on its post; or a bell on a bent arm to the front, or one at each side."""
    kind, thick, foot = draw.which(3), draw(0.1, 0.14), draw(0.26, 0.42)
    neck, wide, r = draw(1.7, 2.15), draw(0.3, 0.42), draw(0.3, 0.42)
    parts = {
        "post": tube((0, 0, 0.1), (0, 0, neck), thick),
        "base": join(
            lathe([(foot, 0), (foot, 0.14), (thick + 0.1, 0.24), (thick + 0.06, 0.56)], 0.02),
        ),
        "rings": join(*(tube((0, 0, v), (0, 0, v + 0.12), thick + 0.08, 0.03)
                        for v in (0.54, neck * draw(0.5, 0.8)))),
    }  # fmt: skip
    if kind == 0:
        low, top, small = neck + 0.12, neck + draw(0.5, 0.72), wide * 0.62
        bar = tube((small + 0.02, 0, low), (wide + 0.06, 0, top), 0.09)
        return parts | {
            "arms": join(
                lathe([(0.1, neck - 0.06), (small + 0.08, low - 0.05), (small + 0.08, low + 0.06)]),
                around(4, bar, 45),
                capsule((-0.36, 0, neck - 0.18), (0.36, 0, neck - 0.18), 0.085),
            ),
            "lamp": lathe([(small, low), (wide, top)]),
            "cap": join(
                lathe([(wide + 0.16, top), (wide + 0.16, top + 0.07), (0.1, top + 0.32)], 0.01),
                ball((0, 0, top + 0.36), 0.11),
            ),
        }
    reach, high = draw(0.58, 0.95), neck + draw(0.5, 0.8)
    line = smooth_curve([(0.0, neck - 0.05), (0.02, high - 0.3), (reach * 0.34, high),
                         (reach * 0.8, high - 0.02), (reach, high - 0.26)])  # fmt: skip
    if kind == 1:
        bell, bulb = _shaded_lamp(0, -reach, high - 0.42, r)
        return parts | {
            "arms": limb([(0.0, -u, v) for u, v in line], thick, 0.09),
            "lamp": bulb,
            "cap": bell,
        }
    bell, bulb = _shaded_lamp(reach, 0, high - 0.42, r)
    return parts | {
        "arms": join(
            both(limb([(u, 0.0, v) for u, v in line], thick, 0.09)),
            tube((0, 0, neck - 0.1), (0, 0, high - 0.1), thick),
            ball((0, 0, high - 0.02), 0.16),
        ),
        "lamp": both(bulb),
        "cap": both(bell),
    }


def wheel(draw: Draw) -> Parts:
    """Upright, its face to the front: a tyre with treads, a rim, five spokes, a hub with nuts."""
    r, wide, rim = draw(1.3, 1.48), draw(0.34, 0.54), draw(0.64, 0.74)
    half, hub, core = draw(0.13, 0.17), r * draw(0.24, 0.28), r * rim

    def facing(solid: Solid) -> Solid:
        return tilted(solid, 90, (0, 0, r))

    def hoop(outer: float, inner: float, half: float) -> Solid:
        return cut(tube((0, 0, -half), (0, 0, half), outer), tube((0, 0, -2), (0, 0, 2), inner))

    lug = box((r - 0.15, 0, 0), (0.15, 0.17, wide))
    out = (hub + core) / 2 - 0.1
    nut = tube((out, 0, 0), (out, 0, wide * 0.5 + 0.1), 0.11)
    return {
        "tyre": facing(hoop(r - 0.11, core, wide)),
        "treads": facing(around(12, lug, 90)),
        "rim": facing(hoop(core + 0.04, core - 0.16, wide + 0.06)),
        "spokes": facing(around(5, box((core / 2, 0, 0), (core / 2, half, wide * 0.5)), 90)),
        "hub": facing(tube((0, 0, -wide * 0.8), (0, 0, wide * 0.8), hub)),
        "nuts": facing(join(around(5, nut, 90), tube((0, 0, 0), (0, 0, wide * 0.8 + 0.08), 0.14))),
    }


def _link(x: float, half: float, major: float, minor: float) -> Solid:
    """A link in the plane of x and y: two bows of a ring and the straights between them."""
    bent = ring((0, 0, 0), major, minor)
    straight = both(capsule((-half, major, 0), (half, major, 0), minor), 1)
    ends = both(cut(moved(bent, (half, 0, 0)), box((half - 3, 0, 0), (3, 3, 3))))
    return moved(join(straight, ends), (x, 0, 0))


def chain(draw: Draw) -> Parts:
    """Three long links that lie in a row, each turned against its neighbours."""
    minor, half, lean = draw(0.12, 0.145), draw(0.16, 0.34), draw(36, 54)
    major = minor * draw(2.15, 2.5)
    pitch = 2 * (half + major) - 2 * minor - 0.07
    z = (major + minor) * 0.8

    def links(places: tuple[int, ...], degrees: float) -> Solid:
        row = join(*(_link(k * pitch, half, major, minor) for k in places))
        return moved(turned(row, 0, degrees), (0, 0, z))

    return {"links": links((-1, 1), lean), "rings": links((0,), lean - 90)}


def robot_arm(draw: Draw) -> Parts:
    """On a turning base: two arms between round joints, a gripper that reaches to the front."""
    foot, wide, first = draw(0.52, 0.76), draw(0.16, 0.22), draw(0.95, 1.4)
    back, second, drop = draw(0.0, 0.32), draw(1.25, 1.6), draw(-0.1, 0.4)
    y, low = 0.7, 0.66
    elbow = (y + back, low + first)
    wrist = (elbow[0] - second, elbow[1] + 0.1 - drop)
    hand = wrist[1] - 0.32

    def joint(at: Point, radius: float, half: float) -> Solid:
        return tube((-half, *at), (half, *at), radius, 0.03)

    claw = [(0.1, hand), (0.34, hand - 0.02), (0.4, hand - 0.26), (0.17, hand - 0.56),
            (0.1, hand - 0.44), (0.2, hand - 0.26)]  # fmt: skip
    fingers = prism(claw, 1, 0.13, wrist[0])
    return {
        "arms": join(
            limb([(0.0, y, low), (0.0, *elbow)], wide + 0.04, wide),
            limb([(0.0, *elbow), (0.0, *wrist)], wide, wide * 0.72),
        ),
        "joints": join(
            joint((y, low), wide + 0.12, wide + 0.1),
            joint(elbow, wide + 0.07, wide + 0.08),
            joint(wrist, wide * 0.85, wide * 0.95),
        ),
        "base": join(
            tube((0, y, 0), (0, y, 0.16), foot, 0.03),
            box((0, y, 0.42), (wide + 0.06, wide + 0.16, 0.3), 0.05),
        ),
        "turntable": tube((0, y, 0.12), (0, y, 0.34), foot * 0.74, 0.03),
        "gripper": join(
            both(fingers),
            box((0, wrist[0], hand), (0.3, 0.15, 0.1), 0.03),
            tube((0, wrist[0], hand), (0, wrist[0], wrist[1]), 0.13),
        ),
        "caps": join(
            joint((y, low), wide * 0.75, wide + 0.16), joint(elbow, wide * 0.7, wide + 0.14)
        ),
    }


def bus_stop(draw: Draw) -> Parts:
    """A shelter of glass with a bench, a round sign on its pole beside it."""
    x, y, high = draw(0.78, 0.97), draw(0.38, 0.6), draw(1.5, 2.1)
    seat, post, r = draw(0.42, 0.56), 0.095, draw(0.25, 0.36)
    pole, top, left = x + 0.22, high + draw(0.1, 0.5), -0.16
    a, b = -x + left, x + left - 0.28
    panes = join(
        box(((a + b) / 2, y, high / 2 + 0.1), ((b - a) / 2, 0.07, high / 2 - 0.2)),
        box((a, 0, high / 2 + 0.1), (0.07, y, high / 2 - 0.2)),
    )
    return {
        "roof": box(((a + b) / 2, -0.04, high + 0.06), ((b - a) / 2 + 0.16, y + 0.24, 0.1), 0.04),
        "posts": join(
            *(box((u, v, high / 2), (post, post, high / 2), 0.01)
              for u, v in ((a, -y), (a, y), (b, y), (b, -y))),
            box(((a + b) / 2, y, 0.22), ((b - a) / 2, 0.09, 0.1)),
            box((a, 0, 0.22), (0.09, y, 0.1)),
            box(((a + pole) / 2, 0, 0.06), ((pole - a) / 2 + 0.2, y + 0.2, 0.08), 0.02),
        ),
        "glass": panes,
        "bench": join(
            box(((a + b) / 2, y - 0.3, seat), ((b - a) / 2 - 0.2, 0.26, 0.09), 0.03),
            *(box((u, y - 0.28, seat / 2), (0.1, 0.18, seat / 2)) for u in (a + 0.42, b - 0.42)),
        ),
        "pole": join(
            tube((pole, -y * 0.6, 0), (pole, -y * 0.6, top), 0.095),
            tube((pole, -y * 0.6 - 0.08, top + r), (pole, -y * 0.6 + 0.08, top + r), r, 0.02),
        ),
        "sign": join(
            tube((pole, -y * 0.6 - 0.13, top + r), (pole, -y * 0.6 + 0.13, top + r), r - 0.1, 0.02),
            box((pole, -y * 0.6, top - 0.3), (0.2, 0.13, 0.14), 0.02),
        ),
    }  # fmt: skip


def wind_turbine(draw: Draw) -> Parts:
    """A slim tower, a nacelle, three long blades that face the front."""
    high, reach, wide = draw(1.66, 1.9), draw(1.05, 1.36), draw(0.17, 0.24)
    thick, front, root = draw(0.1, 0.16), -0.42, draw(0.1, 0.14)
    blade = [(0.05, -0.1), (0.2, -0.1), (0.38, -wide), (reach, -0.1), (reach, 0.07), (0.38, 0.1),
             (0.05, 0.1)]  # fmt: skip
    stripe = box((reach, -0.06, 0), (draw(0.16, 0.4), wide, 0.13), 0.02)

    turn = 60 * draw.which(2)

    def turning(solid: Solid) -> Solid:
        return moved(turned(_third(solid, turn), 0, 90), (0, front, high))

    whole = prism(blade, 2, 0.09)
    return {
        "tower": lathe([(thick + 0.06, 0), (thick - 0.03, high)]),
        "blades": turning(whole),
        "hub": _nose(root + 0.06, front + 0.14, front - 0.26, high),
        "nacelle": box((0, -0.04, high + 0.02), (0.16, 0.42, 0.16), 0.06),
        "bands": turning(within(grown(whole, 0.035), stripe)),
        "base": tube((0, 0, 0), (0, 0, 0.14), draw(0.32, 0.5), 0.03),
    }


def _third(solid: Solid, turn: float) -> Solid:
    """``solid``, which stands at +X, three times about +Z, the first by ``turn`` off +Y."""
    return join(*(turned(solid, 2, 90 + turn + 120 * k) for k in range(3)))


def _nose(radius: float, back: float, front: float, z: float) -> Solid:
    """A round nose along y from ``back`` to its tip at ``front``, at height z."""
    long = back - front
    side = smooth_curve([(radius, 0.0), (radius * 0.9, long * 0.5), (radius * 0.5, long * 0.88),
                         (0.0, long)])  # fmt: skip
    return tilted(lathe(side), 90, (0, back, z))


def solar_panel(draw: Draw) -> Parts:
    """Two rows of three cells in a frame, tilted to the front, on a post with a foot."""
    x, y, tilt = draw(1.15, 1.4), draw(0.76, 0.95), draw(30, 48)
    z, post = y * math.sin(math.radians(tilt)) + draw(0.5, 0.8), draw(0.13, 0.17)
    wide, deep = (x - 0.12) / 3, (y - 0.12) / 2
    cell = box((0, deep, 0.1), (wide - 0.08, deep - 0.08, 0.1))

    def leaning(solid: Solid) -> Solid:
        return tilted(solid, tilt, (0, 0, z))

    rim = cut(box((0, 0, 0), (x, y, 0.14)), box((0, 0, 0), (x - 0.12, y - 0.12, 1)))
    return {
        "cells": leaning(both(join(*(moved(cell, (2 * wide * k, 0, 0)) for k in (-1, 0, 1))), 1)),
        "lines": leaning(box((0, 0, 0), (x - 0.1, y - 0.1, 0.13))),
        "frame": leaning(rim),
        "post": join(
            tube((0, 0, 0.1), (0, 0, z), post),
            both(capsule((0, 0, 0.4), (x * 0.6, 0, z - 0.06), 0.1)),
        ),
        "base": box((0, 0, 0.1), (x * 0.5, y * 0.6, 0.1)),
        "box": box((0, -post - 0.06, z * 0.42), (0.2, 0.12, 0.22)),
    }


def battery(draw: Draw) -> Parts:
    """A cell that stands on its flat end: a copper top, a nub, a plus and a bolt on its label."""
    r, high, share = draw(0.64, 0.8), draw(2.2, 2.5), draw(0.62, 0.7)
    nub, band, front = draw(0.24, 0.32), high * share, -r + 0.04
    plus, bar, at = 0.1, 0.3, (band + high) / 2 + 0.02
    bolt = [(0.1, 0.5), (-0.34, -0.1), (-0.06, -0.1), (-0.14, -0.5), (0.34, 0.14), (0.06, 0.14)]
    return {
        "body": tube((0, 0, 0.12), (0, 0, band), r, 0.03),
        "top": tube((0, 0, band - 0.1), (0, 0, high), r - 0.05, 0.06),
        "nub": tube((0, 0, high - 0.1), (0, 0, high + 0.26), nub, 0.05),
        "base": join(
            tube((0, 0, 0), (0, 0, 0.3), r - 0.1, 0.02),
            tube((0, 0, band - 0.1), (0, 0, band + 0.1), r + 0.07, 0.03),
        ),
        "plus": join(
            box((0, front + 0.04, at), (bar, 0.14, plus), 0.01),
            box((0, front + 0.04, at), (plus, 0.14, bar), 0.01),
        ),
        "bolt": moved(prism(bolt, 1, 0.16), (0, front + 0.04, band / 2)),
    }


ROADSIDE = {
    "street lamp": street_lamp,
    "wheel": wheel,
    "chain": chain,
    "robot arm": robot_arm,
    "bus stop": bus_stop,
    "wind turbine": wind_turbine,
    "solar panel": solar_panel,
    "battery": battery,
}
