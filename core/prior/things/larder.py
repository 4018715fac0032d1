"""Larder and garden: a muffin, bacon, a chili pepper, a fern, a willow."""

import math

import torch
from torch import Tensor

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
    around,
    ball,
    blend,
    box,
    chain,
    egg,
    grown,
    join,
    lathe,
    limb,
    moved,
    prism,
    ring,
    taper,
    within,
)
from core.prior.things.brood import _flow


def muffin(draw: Draw) -> Parts:
    """A pleated paper cup under a domed golden top, studded with blueberries."""
    low, wide, high = draw(0.6, 0.64), draw(0.82, 0.87), draw(0.84, 0.9)
    dome, tall = wide + 0.24, draw(0.62, 0.68)
    cup = lathe([(low, 0.0), (wide, high)], 0.02)
    pleat = taper((low - 0.01, 0, 0.08), (wide, 0, high - 0.02), 0.09, 0.12)
    z = high + 0.08
    top = within(egg((0, 0, z), (dome, dome, tall * 1.2)), box((0, 0, z + 0.9), (2, 2, 0.98)))
    berries = [ball((0.04, -0.1, z + tall * 1.14), 0.19)]
    for lift, count, first in ((48, 5, 20), (14, 7, 50)):
        a = math.radians(lift)
        at = (dome * 0.96 * math.cos(a), 0, z + tall * 1.16 * math.sin(a))
        berries.append(around(count, ball(at, 0.18), first))
    return {
        "top": join(top, ring((0, 0, z + 0.02), dome - 0.16, 0.17)),
        "cup": join(cup, around(14, pleat)),
        "berries": join(*berries),
    }


def _waved(solid: Solid, high: float, long: float, phase: float) -> Solid:
    """``solid`` waved up and down, and less to and fro, along x; a lower bound of the distance."""
    pace = math.tau / long
    slope = high * pace * 1.1
    stretch = (slope + math.hypot(slope, 2)) / 2

    def distance(p: Tensor) -> Tensor:
        lift = high * torch.sin(p[:, 0] * pace + phase)
        aside = 0.5 * high * torch.sin(p[:, 0] * pace)
        return solid(torch.stack([p[:, 0], p[:, 1] - aside, p[:, 2] - lift], 1)) / stretch

    return distance


def bacon(draw: Draw) -> Parts:
    """Two wavy rashers side by side, red meat between bold stripes of fat."""
    long, half, high = draw(1.32, 1.4), draw(0.47, 0.5), draw(0.13, 0.15)

    def rasher(phase: float, at: float, rise: float, *bands: tuple[float, float, float]) -> Solid:
        """Bands of a rasher at ``at``: the middle and half of their width, half their height."""
        flat = (
            box((0, at + v * half, rise), (long, w * half, thick), 0.06) for v, w, thick in bands
        )
        return _waved(join(*flat), high, 1.3, phase)

    fat = ((-0.6, 0.2, 0.2), (0.02, 0.13, 0.2), (0.6, 0.17, 0.2))
    lie = [(0.4, -half * 0.98, 0.0), (2.0, half * 0.98, 0.1)]
    return {
        "meat": join(*(rasher(*one, (0, 0.96, 0.15)) for one in lie)),
        "fat": join(*(rasher(*one, *fat) for one in lie)),
    }


def chili_pepper(draw: Draw) -> Parts:
    """Glossy red, bowed like a horn to a point, a green cap with a crooked stem."""
    bow, thick, long = draw(0.62, 0.7), draw(0.37, 0.4), draw(1.9, 2.0)
    girth = [0.86, 1.0, 1.0, 0.93, 0.82, 0.66, 0.46, 0.2]
    spine = [(k / 7, r * thick) for k, r in enumerate(girth)]
    pod = [((bow * (2.2 * t * t - 0.9 * t) - 0.2, 0, long * (1 - t) + 0.2 + 0.24 * t * t), r)
           for t, r in spine]  # fmt: skip
    top = long + 0.2
    lobe = taper((0.12, 0, top + 0.2), (thick * 0.98, 0, top - 0.16), 0.17, 0.1)
    cap = join(egg((0, 0, top + 0.17), (thick * 1.06, thick * 1.06, 0.22)), around(5, lobe, 18))
    return {
        "body": chain(pod),
        "cap": moved(cap, (-0.2, 0, 0)),
        "stem": limb(
            [(-0.2, 0, top + 0.26), (-0.24, 0, top + 0.56), (-0.44, 0, top + 0.8)], 0.13, 0.14
        ),
    }


def _arched(solid: Solid, at: float, low: float, radius: float) -> Solid:
    """``solid``, which lies along +X, bent up and over to the half circle of ``radius`` about
    (``at``, ``low``) in x and z; it begins at the axis' side."""

    def distance(p: Tensor) -> Tensor:
        u, v = p[:, 0] - at, p[:, 2] - low
        angle = torch.atan2(v, -u)
        angle = torch.where(angle < -math.pi / 2, angle + math.tau, angle)
        out = (u * u + v * v).sqrt() - radius
        return solid(torch.stack([angle * radius, p[:, 1], out], 1)) * 0.8

    return distance


def fern(draw: Draw) -> Parts:
    """A clump of arching fronds, each a row of bold leaflets along a rib, out of dark soil."""
    long, wide, radius = draw(2.0, 2.1), draw(0.38, 0.41), draw(0.76, 0.8)
    side = [(0.0, 0.1), (0.4, 0.1)]
    for k, out in enumerate((0.66, 0.92, 1.0, 0.94, 0.8, 0.6)):
        start = 0.4 + 0.26 * k
        side += [(start + 0.08, wide * out), (start + 0.2, wide * out * 0.94),
                 (start + 0.15, 0.1), (start + 0.26, 0.1)]  # fmt: skip
    outline = [*side, (long * 1.04, 0.0), *((u, -v) for u, v in reversed(side))]
    leaf = grown(prism(outline, 2, 0.05), 0.025)
    rib = taper((0, 0, 0.05), (long * 0.94, 0, 0.05), 0.105, 0.075)

    def clump(frond: Solid) -> Solid:
        """Six fronds that bow outwards about four that rise."""
        high = _arched(frond, radius * 0.86, 0.62, radius * 0.82)
        return join(around(6, _arched(frond, radius + 0.08, 0.06, radius), 30), around(4, high, 45))

    return {
        "fronds": clump(leaf),
        "ribs": join(clump(rib), taper((0, 0, 0.2), (0, 0, 0.7), 0.24, 0.15)),
        "soil": within(egg((0, 0, 0.0), (0.56, 0.56, 0.36)), box((0, 0, 1), (2, 2, 1.1))),
    }


def willow_tree(draw: Draw) -> Parts:
    """A stout trunk under a crown from which curtains of leaves hang almost to the ground."""
    wide, top, low = draw(1.1, 1.16), draw(2.2, 2.3), draw(0.86, 0.94)

    def strand(out: float, drop: float, thick: float) -> Solid:
        """Flows over the crown's rim and hangs to a point."""
        return _flow([(out * 0.56, top + 0.42, thick * 0.8), (out * 0.98, top + 0.04, thick),
                      (out * 1.06, (top + drop) * 0.5, thick), (out, drop, 0.085)],
                     across=True)  # fmt: skip

    root = taper((0.14, 0, 0.3), (0.56, 0, 0.1), 0.2, 0.12)
    return {
        "leaves": join(
            blend(0.2, egg((0, 0, top + 0.1), (wide * 0.98, wide * 0.98, 0.5)),
                  egg((0, 0, top + 0.36), (0.72, 0.72, 0.5))),
            around(9, strand(wide * 0.9, low + 0.42, 0.22), 20),
        ),
        "strands": around(9, strand(wide, low, 0.2)),
        "trunk": join(taper((0, 0, 0.16), (0, 0, 1.9), 0.34, 0.26), around(5, root, 18)),
    }  # fmt: skip


LARDER = {
    "muffin": muffin,
    "bacon": bacon,
    "chili pepper": chili_pepper,
    "fern": fern,
    "willow tree": willow_tree,
}
