"""Cranes, towers, turbines and containers of a port or a field."""

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
    grown,
    join,
    lathe,
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
from core.prior.things.shared.outlines import dome_of, strip


def shipping_container(draw: Draw) -> Parts:
    """A long box with upright ribs, a frame, and doors with bars at its front end."""
    x, y, z, edge = draw(0.58, 0.64), draw(1.3, 1.45), draw(0.6, 0.66), 0.11
    step = 2 * (y - edge) / 5
    ribs = [box((x - 0.1, k * step, z), (0.09, step * 0.27, z - 0.12)) for k in range(-2, 3)]
    posts = both(box((x - edge + 0.06, y - edge + 0.06, z), (edge, edge, z)), 0, 1)
    rails = [both(box((x - edge + 0.06, 0, v), (edge, y, edge))) for v in (edge, 2 * z - edge)]
    ends = [both(box((0, y - edge + 0.06, v), (x, edge, edge)), 1) for v in (edge, 2 * z - edge)]
    bar = tube((x * 0.36, -y - 0.1, 0.1), (x * 0.36, -y - 0.1, 2 * z - 0.1), 0.08)
    handle = box((x * 0.36 + 0.12, -y - 0.08, z * 0.85), (0.16, 0.12, 0.085), 0.02)
    return {
        "body": box((0, 0, z), (x - 0.1, y - 0.12, z - 0.07)),
        "ribs": both(join(*ribs)),
        "frame": join(posts, *rails, *ends),
        "doors": both(box((x * 0.42, -y + 0.06, z), (x * 0.42 - 0.07, 0.08, z - 0.22))),
        "bars": both(join(bar, handle)),
    }


def pallet(draw: Draw) -> Parts:
    """Boards on cross boards, nine blocks, three skids below."""
    x, y, thick = draw(1.1, 1.25), draw(0.85, 1.0), draw(0.065, 0.078)
    block, wide = draw(0.13, 0.16), draw(0.15, 0.175)
    foot = 2 * thick
    mid = foot + block
    cross = mid + block + thick
    deck = cross + 2 * thick
    boards = [box(((x - wide) * k / 2, 0, deck), (wide, y, thick)) for k in (-2, -1, 0, 1, 2)]
    cubes = box((0, 0, mid), (0.17, 0.15, block + 0.02))
    row = join(*(moved(cubes, ((x - 0.17) * k, 0, 0)) for k in (-1, 0, 1)))
    bars = [
        box((0, (y - 0.15) * k, z), (x, 0.15, thick + 0.01))
        for k in (-1, 0, 1)
        for z in (thick, cross)
    ]
    return {
        "boards": join(*boards),
        "blocks": join(*(moved(row, (0, (y - 0.15) * k, 0)) for k in (-1, 0, 1))),
        "skids": join(*bars),
    }


def crane(draw: Draw) -> Parts:
    """A tower crane: a mast of bars, a jib to the front with a hook, a counterweight behind."""
    high, half, reach = draw(1.65, 1.85), 0.16, draw(1.75, 1.95)
    tail, deep, peak = draw(0.8, 0.95), draw(0.24, 0.28), draw(0.42, 0.5)
    thick, hang = 0.06, draw(0.5, 0.7)
    floor, count = 0.14, 4
    step = (high - floor) / count
    rungs, braces = [], []
    for k in range(count):
        z = floor + step * k
        a, b = (-half, half) if k % 2 else (half, -half)
        braces.append(prism(strip((a, z), (b, z + step), 0.05), 0, 0.05, half))
        rungs.append(both(box((0, half, z + step), (half, 0.05, 0.05)), 1))
    posts = both(box((half, half, high / 2), (0.07, 0.07, high / 2)), 0, 1)
    low, top = high + 0.16, high + 0.16 + deep
    bays = 5
    pitch = (reach - 0.3) / bays
    web = []
    for k in range(bays):
        near = -0.2 - pitch * k
        web.append(strip((near, low), (near - pitch / 2, top), 0.055))
        web.append(strip((near - pitch / 2, top), (near - pitch, low), 0.055))
    tip = top + peak
    hook = -reach * 0.78
    parts: Parts = {
        "mast": join(posts, *rungs, both(join(*braces))),
        "jib": join(
            box((0, (tail - reach) / 2, low), (0.12, (tail + reach) / 2, thick + 0.01)),
            box((0, -(reach + 0.1) / 2, top), (0.075, (reach - 0.3) / 2, thick)),
            *(prism(strip, 0, 0.075) for strip in web),
            box((0, 0, high + 0.06), (0.25, 0.25, 0.1)),
        ),
        "ties": join(
            prism([(-0.16, low), (0.16, low), (0.06, tip), (-0.06, tip)], 0, 0.08),
            prism(strip((0, tip - 0.05), (-reach * 0.62, top), 0.055), 0, 0.06),
            prism(strip((0, tip - 0.05), (tail - 0.1, low), 0.055), 0, 0.06),
        ),
        "cab": box((0, -0.36, low - 0.24), (0.17, 0.17, 0.2)),
        "weights": join(
            box((0, tail - 0.12, low - 0.14), (0.2, 0.2, 0.2)),
            box((0, 0, 0.09), (0.46, 0.46, 0.09)),
        ),
        "hook": join(
            box((0, hook, low - hang / 2), (0.06, 0.06, hang / 2)),
            box((0, hook, low - hang), (0.09, 0.12, 0.11)),
            cut(
                ring((0, hook, low - hang - 0.22), 0.13, 0.06, 0),
                box((0, hook + 0.2, low - hang - 0.12), (0.2, 0.16, 0.1)),
            ),
        ),
    }
    # So that both ends of the jib are equally far from the middle.
    return {name: moved(part, (0, 0.5, 0)) for name, part in parts.items()}


def silo(draw: Draw) -> Parts:
    """A tall round store of a farm: hoops, a domed roof, a ladder and a door in front."""
    r, high, dome = draw(0.52, 0.6), draw(1.8, 2.05), draw(0.38, 0.48)
    step = high / 5
    hoops = [tube((0, 0, step * k - 0.06), (0, 0, step * k + 0.06), r + 0.05) for k in (1, 2, 3, 4)]
    rungs = [
        box((0, -r - 0.12, z), (0.2, 0.05, 0.05)) for z in (step * k / 2 for k in range(3, 11))
    ]
    return {
        "body": tube((0, 0, 0), (0, 0, high), r),
        "roof": join(
            lathe([(r + 0.08, high - 0.06), *dome_of(r + 0.08, high + 0.02, high + dome)]),
            tube((0, 0, high + dome - 0.1), (0, 0, high + dome + 0.12), 0.1),
        ),
        "bands": join(*hoops),
        "ladder": join(both(box((0.17, -r - 0.1, high * 0.6), (0.055, 0.08, high * 0.4))), *rungs),
        "door": box((0, -r, 0.17), (0.17, 0.1, 0.17)),
        "base": tube((0, 0, 0), (0, 0, 0.12), r + 0.14, 0.02),
    }


def water_tower(draw: Draw) -> Parts:
    """A banded tank with a pointed roof on four braced legs, a pipe down its middle."""
    r, low, high = draw(0.64, 0.76), draw(1.4, 1.66), draw(0.74, 0.92)
    top, foot, rise = low + high, draw(0.62, 0.74), draw(0.34, 0.46)
    hip, z = r * 0.68, low * 0.46
    mid = (foot + hip) / 2
    tank = tube((0, 0, low), (0, 0, top), r)
    hoops = join(*(tube((0, 0, v - 0.08), (0, 0, v + 0.08), r + 0.05)
                   for v in (low + high * 0.24, low + high * 0.74)))  # fmt: skip
    bowl = lathe(smooth_curve([(0.14, low - 0.26), (r * 0.7, low - 0.14), (r, low + 0.02)]))
    side = join(
        capsule((0.0, mid, z), (mid, mid, z), 0.085),
        capsule((mid, mid, z), (-hip, hip, low - 0.06), 0.085),
        capsule((-mid, mid, z), (hip, hip, low - 0.06), 0.085),
    )
    return {
        "tank": join(tank, bowl),
        "roof": join(
            lathe([(r + 0.12, top - 0.04), (r + 0.12, top + 0.06), (0.1, top + rise),
                   (0.0, top + rise)]), ball((0, 0, top + rise), 0.12)),
        "bands": hoops,
        "legs": both(
            join(taper((foot, foot, 0.1), (hip, hip, low), 0.1, 0.1),
                 box((foot, foot, 0.06), (0.16, 0.16, 0.08), 0.02)), 0, 1),
        "braces": join(both(side, 0, 1), turned(both(side, 0, 1), 2, 90)),
        "pipe": join(tube((0, 0, 0), (0, 0, low), 0.13), tube((0, 0, 0), (0, 0, 0.16), 0.22)),
    }  # fmt: skip


def _third(solid: Solid, turn: float) -> Solid:
    """``solid``, which stands at +X, three times about +Z, the first by ``turn`` off +Y."""
    return join(*(turned(solid, 2, 90 + turn + 120 * k) for k in range(3)))


def _nose(radius: float, back: float, front: float, z: float) -> Solid:
    """A round nose along y from ``back`` to its tip at ``front``, at height z."""
    long = back - front
    side = smooth_curve([(radius, 0.0), (radius * 0.9, long * 0.5), (radius * 0.5, long * 0.88),
                         (0.0, long)])  # fmt: skip
    return tilted(lathe(side), 90, (0, back, z))


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


STREET_INDUSTRY = {
    "shipping container": shipping_container,
    "pallet": pallet,
    "crane": crane,
    "silo": silo,
    "water tower": water_tower,
    "wind turbine": wind_turbine,
    "solar panel": solar_panel,
}
