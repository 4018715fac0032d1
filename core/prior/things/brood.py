"""The brood: beasts of the yard, and an orca."""

import math

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
    around,
    ball,
    blend,
    both,
    capsule,
    chain,
    egg,
    grown,
    join,
    limb,
    moved,
    prism,
    ring,
    smooth_curve,
    taper,
    tilted,
    tube,
    turned,
)
from core.prior.things.animals import fitted
from core.prior.things.characters import eyes


def _legs(wide: float, long: float, high: float, thick: float) -> Solid:
    """Four, from the height ``high`` to the ground."""
    return both(taper((wide, long, high), (wide, long, thick), thick * 1.15, thick), 0, 1)


def _flow(stops: list[tuple[float, float, float]], across: bool = False) -> Solid:
    """A smooth bar through the stops (y, z, radius), or (x, z, radius) if ``across``."""
    path = smooth_curve([(u, v) for u, v, _ in stops], 3)
    girth = smooth_curve([(r, 0.0) for *_, r in stops], 3)
    return chain(((u, 0.0, v) if across else (0.0, u, v), r)
                 for (u, v), (r, _) in zip(path, girth, strict=True))  # fmt: skip


def goose(draw: Draw) -> Parts:
    """White and plump on orange webbed feet, a long upright neck, an orange bill."""
    wide, long, up = draw(0.5, 0.54), draw(0.74, 0.8), draw(2.16, 2.26)
    z, y = 0.98, -0.6
    neck = [(-0.3, z + 0.06, 0.4), (y + 0.02, z + 0.44, 0.26), (y + 0.08, up - 0.4, 0.19),
            (y, up, 0.2)]  # fmt: skip
    web = grown(prism([(-0.05, 0.14), (0.05, 0.14), (0.17, -0.3), (0, -0.36), (-0.17, -0.3)],
                      2, 0.05), 0.04)  # fmt: skip
    wing = tilted(egg((0, 0, 0), (0.15, 0.64, 0.33)), -16, (wide * 0.84, 0.24, z + 0.12))
    return {
        "body": join(
            blend(0.14, egg((0, 0.04, z), (wide, long, 0.5)), _flow(neck),
                  taper((0, long * 0.66, z + 0.1), (0, long + 0.26, z + 0.36), 0.28, 0.11)),
            egg((0, y - 0.06, up + 0.02), (0.28, 0.32, 0.27)),
        ),
        "wings": both(wing),
        "bill": join(
            taper((0, y - 0.32, up), (0, y - 0.68, up - 0.07), 0.17, 0.11),
            egg((0, y - 0.34, up + 0.02), (0.19, 0.16, 0.17)),
        ),
        "feet": both(join(taper((0.29, 0.06, z - 0.36), (0.29, 0.06, 0.14), 0.15, 0.11),
                          moved(web, (0.29, 0.04, 0.09)))),
        "eyes": eyes(0.22, y - 0.2, up + 0.1, 0.09),
    }  # fmt: skip


def orca(draw: Draw) -> Parts:
    """Black with a white belly and eye patches, a tall dorsal fin, round flippers, flukes."""
    wide, rise, tall = draw(0.54, 0.58), draw(0.16, 0.2), draw(0.78, 0.86)
    z = 0.72

    def trunk(share: float, down: float, last: int) -> Solid:
        """The trunk's balls, smaller by ``share`` and lower by a part of their radius."""
        girth = smooth_curve([(-1.14, 0.52), (-0.86, 0.82), (-0.4, 1.0), (0.08, 0.98), (0.56, 0.7),
                              (1.0, 0.4), (1.34, 0.28)], 3)  # fmt: skip
        return chain(((0, y, z + rise * max(y, 0.0) ** 2 - down * r * wide), r * wide * share)
                     for y, r in girth[:last])  # fmt: skip

    top, half = z + wide, 0.11
    fin = smooth_curve([(-0.34, top - 0.2), (-0.1, top + tall * 0.55), (0.22, top + tall)])
    fin += smooth_curve([(0.36, top + tall * 0.94), (0.36, top + 0.3), (0.46, top - 0.2)])
    vane = [(0, -0.24), (0.3, -0.28), (0.68, -0.04), (0.78, 0.26), (0.6, 0.42), (0.3, 0.26),
            (0, 0.18)]  # fmt: skip
    side = moved(turned(prism(smooth_curve(vane), 2, half), 1, 30), (wide * 0.6, -0.5, z - 0.24))
    tail = [(-0.1, -0.26), (0.18, -0.12), (0.5, 0.02), (0.78, 0.3), (0.72, 0.42), (0.4, 0.34),
            (0.1, 0.2), (-0.1, 0.2)]  # fmt: skip
    fluke = tilted(both(prism(tail, 2, half)), -20, (0, 1.4, z + rise * 1.9))
    patch = moved(turned(egg((0, 0, 0), (0.12, 0.28, 0.15)), 0, 14), (wide * 0.8, -0.66, z + 0.24))
    return {
        "body": join(trunk(1, 0, 19), prism(fin, 0, half), both(side), fluke),
        "belly": join(trunk(0.985, 0.21, 13),
                      both(egg((wide * 0.54, 0.52, z - 0.02), (0.2, 0.42, 0.17)))),
        "patches": both(patch),
        "eyes": eyes(wide * 0.72, -0.97, z + 0.1, 0.115),
    }  # fmt: skip


def bull(draw: Draw) -> Parts:
    """Mighty shoulders over a low head, wide horns, a golden ring in its nose."""
    wide, long, leg = draw(0.5, 0.53), draw(0.8, 0.86), draw(0.56, 0.6)
    z = leg + 0.36
    y, up = -long - 0.2, z + 0.14
    nose = y - 0.56
    horn = moved(_flow([(0.18, 0.26, 0.17), (0.54, 0.32, 0.16), (0.8, 0.52, 0.13),
                        (0.8, 0.86, 0.075)], across=True), (0, y, up))  # fmt: skip
    ear = taper((0.28, y + 0.08, up + 0.1), (0.62, y + 0.12, up + 0.04), 0.13, 0.1)
    a, b = wide * 0.6, long * 0.66
    tail = limb([(0, long * 0.9, z + 0.26), (0, long + 0.24, z + 0.12), (0, long + 0.28, z - 0.3)],
                0.11, 0.1)  # fmt: skip
    return {
        "body": join(
            blend(0.18, egg((0, 0.06, z), (wide, long, 0.46)),
                  egg((0, -long * 0.44, z + 0.22), (wide * 1.12, 0.5, 0.52)),
                  egg((0, y, up), (0.36, 0.38, 0.36))),
            taper((0, y, up), (0, y - 0.36, up - 0.2), 0.31, 0.24),
            both(ear), _legs(a, b, z - 0.14, 0.18), tail,
        ),
        "muzzle": egg((0, y - 0.44, up - 0.24), (0.3, 0.24, 0.22)),
        "horns": both(horn),
        "ring": ring((0, nose - 0.08, up - 0.4), 0.13, 0.075, 1),
        "hair": join(
            egg((0, y - 0.14, up + 0.34), (0.27, 0.26, 0.16)),
            ball((0, long + 0.28, z - 0.38), 0.17),
        ),
        "hooves": both(tube((a, b, 0.0), (a, b, 0.2), 0.225, 0.03), 0, 1),
        "eyes": eyes(0.27, y - 0.26, up + 0.12, 0.1),
    }  # fmt: skip


def _fan(radius: float, count: int) -> list[tuple[float, float]]:
    """A fan of ``count`` round feathers about the origin, somewhat more than a half disc."""
    step = 204 / count
    corners = [(0.0, -0.2)]
    for k in range(count * 6 + 1):
        turn = math.radians(-12 + step * k / 6)
        bulge = math.sin(math.pi * (k % 6) / 6) ** 0.6
        r = radius * (0.9 + 0.1 * bulge)
        corners.append((r * math.cos(turn), r * math.sin(turn)))
    return corners


def turkey(draw: Draw) -> Parts:
    """A great fan of tail feathers with pale tips behind a round body, a bare head, a red
    wattle."""
    wide, fan, up = draw(0.56, 0.6), draw(1.2, 1.28), draw(1.72, 1.8)
    z, y = 0.9, -0.52
    head = [((0, y + 0.16, z + 0.24), 0.24), ((0, y, z + 0.56), 0.18), ((0, y - 0.02, up), 0.25)]
    foot = join(
        taper((0.27, 0, z - 0.34), (0.27, 0, 0.12), 0.14, 0.11),
        *(capsule((0.27, 0, 0.1), (0.27 + u, v, 0.1), 0.1)
          for u, v in ((-0.1, -0.32), (0.14, -0.3), (0.02, 0.16))),
    )  # fmt: skip
    at = (0, 0.5, z + 0.04)
    return {
        "body": join(
            blend(0.1, egg((0, 0, z), (wide, 0.62, 0.56)),
                  egg((0, -0.24, z + 0.06), (wide * 0.8, 0.46, 0.46))),
        ),
        "wings": both(tilted(egg((0, 0, 0), (0.16, 0.46, 0.34)), -18, (wide * 0.94, 0.06, z))),
        "tail": tilted(prism(_fan(fan * 0.8, 9), 1, 0.16), -14, at),
        "tips": tilted(prism(_fan(fan, 9), 1, 0.1), -14, at),
        "head": chain(head),
        "wattle": join(
            taper((0, y - 0.24, up - 0.16), (0, y - 0.24, up - 0.5), 0.1, 0.15),
            limb([(0, y - 0.2, up + 0.12), (0.0, y - 0.36, up + 0.08), (0.1, y - 0.42, up - 0.2)],
                 0.1, 0.085),
        ),
        "bill": join(taper((0, y - 0.22, up - 0.02), (0, y - 0.5, up - 0.08), 0.13, 0.07),
                     both(foot)),
        "eyes": eyes(0.18, y - 0.16, up + 0.08, 0.085),
    }  # fmt: skip


def donkey(draw: Draw) -> Parts:
    """Grey, with very long ears, a dark upright mane, a pale muzzle and belly."""
    wide, long, leg = draw(0.4, 0.43), draw(0.64, 0.68), draw(0.62, 0.66)
    z, y = leg + 0.3, -long - 0.14
    up = z + 0.66
    ear = [((0.14, y + 0.08, up + 0.2), 0.13), ((0.24, y + 0.1, up + 0.56), 0.16),
           ((0.34, y + 0.08, up + 0.96), 0.08)]  # fmt: skip
    a, b = wide * 0.6, long * 0.66
    crest = chain(
        [
            ((0, -long * 0.42, z + 0.4), 0.13),
            ((0, y + 0.26, up + 0.04), 0.16),
            ((0, y + 0.06, up + 0.3), 0.17),
            ((0, y - 0.14, up + 0.26), 0.13),
        ]
    )
    tail = limb([(0, long * 0.9, z + 0.2), (0, long + 0.2, z), (0, long + 0.22, z - 0.26)],
                0.11, 0.1)  # fmt: skip
    return {
        "body": join(
            blend(0.14, egg((0, 0, z), (wide, long, wide)),
                  taper((0, -long * 0.56, z + 0.06), (0, y + 0.04, up), 0.3, 0.25),
                  egg((0, y, up), (0.3, 0.34, 0.31))),
            taper((0, y, up), (0, y - 0.34, up - 0.18), 0.28, 0.22),
            both(chain(ear)), _legs(a, b, z - 0.06, 0.155), tail,
        ),
        "mane": join(crest, ball((0, long + 0.22, z - 0.36), 0.16)),
        "muzzle": join(
            egg((0, y - 0.44, up - 0.24), (0.29, 0.27, 0.25)),
            egg((0, 0, z - 0.1), (wide * 0.84, long * 0.86, wide * 0.86)),
        ),
        "hooves": both(tube((a, b, 0.0), (a, b, 0.18), 0.195, 0.03), 0, 1),
        "nostrils": both(ball((0.13, y - 0.65, up - 0.16), 0.09)),
        "eyes": eyes(0.24, y - 0.22, up + 0.1, 0.1),
    }  # fmt: skip


def rooster(draw: Draw) -> Parts:
    """Upright and proud: a tall red comb, wattles, a golden neck, a fountain of a tail."""
    wide, z, head = draw(0.48, 0.52), draw(1.06, 1.12), draw(0.28, 0.3)
    y, up = -0.5, z + 0.98
    sickle = [(0.34, 0.02), (0.66, 0.66), (1.0, 0.92), (1.26, 0.66), (1.32, 0.16)]
    plumes = [(0.0, 1.0, 1.1), (0.2, 0.96, 0.78), (0.34, 0.8, 0.4)]
    thick = (0.16, 0.21, 0.23, 0.2, 0.09)
    tail = [chain([((u * k / 2, 0.1 + v * s, z + 0.06 + w * t), thick[k])
                   for k, (v, w) in enumerate(sickle)]) for u, s, t in plumes]  # fmt: skip
    wing = moved(turned(egg((0, 0, 0), (0.16, 0.5, 0.34)), 0, -16), (wide * 0.92, 0.06, z + 0.04))
    spikes = [taper((0, y + v, up + 0.2), (0, y + v * 1.4, up + t), 0.16, 0.09)
              for v, t in ((-0.2, 0.48), (-0.02, 0.64), (0.16, 0.6), (0.28, 0.36))]  # fmt: skip
    foot = join(*(capsule((0.24, -0.06, 0.09), (0.24 + u, -0.06 + v, 0.09), 0.09)
                  for u, v in ((-0.16, -0.32), (0.18, -0.32), (0.0, 0.26))))  # fmt: skip
    ruff = around(10, taper((0.28, 0, 0), (0.46, 0, -0.32), 0.15, 0.06))
    return {
        "body": join(egg((0, 0.02, z), (wide, 0.62, 0.52)),
                     both(taper((0.22, -0.02, z - 0.28), (0.24, -0.04, 0.56), 0.24, 0.14))),
        "neck": join(
            blend(0.1, taper((0, -0.3, z + 0.24), (0, y, up), 0.42, 0.24), ball((0, y, up), head)),
            moved(tilted(ruff, 10, (0, 0, 0)), (0, -0.3, z + 0.34)),
        ),
        "wings": both(wing),
        "tail": join(both(join(*tail)), ball((0, 0.5, z + 0.2), 0.3)),
        "comb": join(
            *spikes,
            both(egg((0.1, y - head * 0.92, up - 0.3), (0.11, 0.12, 0.22))),
        ),
        "bill": taper((0, y - head * 0.8, up), (0, y - head - 0.26, up - 0.06), 0.14, 0.07),
        "legs": both(join(taper((0.24, -0.04, 0.6), (0.24, -0.06, 0.1), 0.1, 0.1), foot)),
        "eyes": eyes(head * 0.66, y - head * 0.6, up + 0.08, 0.09),
    }  # fmt: skip


BROOD = {
    "goose": goose,
    "orca": fitted(orca),
    "bull": fitted(bull),
    "turkey": turkey,
    "donkey": fitted(donkey),
    "rooster": rooster,
}
