"""Animals of the farm."""

import math

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
    around,
    ball,
    blend,
    both,
    box,
    capsule,
    chain,
    cut,
    egg,
    grown,
    join,
    limb,
    moved,
    prism,
    ring,
    taper,
    tilted,
    tube,
    turned,
)
from core.prior.things.shared.faces import eyes
from core.prior.things.shared.fitted import fitted
from core.prior.things.shared.quadruped import Beast, four_legs, steed
from core.prior.things.shared.ropes import smooth_bar
from core.prior.things.shared.wings_and_claws import bird_claws


def horse(draw: Draw) -> Parts:
    """A long face, a mane, a tail, hooves."""
    return steed(draw)[1]


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
            both(chain(ear)), four_legs(a, b, z - 0.06, 0.155), tail,
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


def _patches(draw: Draw, b: Beast) -> Solid:
    """Raised spots on the flanks and the back."""
    # Eggs a little inside the body's own: what stands out of it is a spot.
    side = both(egg((b.wide * 0.7, b.long * draw(-0.3, 0), b.belly), (0.18, 0.26, 0.24)))
    back = egg((0.1, b.long * draw(0.3, 0.5), b.belly + b.wide * 0.5), (0.36, 0.28, 0.3))
    face = egg((b.head * 0.5, b.y - b.head * 0.5, b.z + b.head * 0.35), (0.2, 0.22, 0.2))
    return join(side, back, face)


def cow(draw: Draw) -> Parts:
    """Horns, a broad muzzle, an udder."""
    b = Beast(draw, 0.46, 0.85, 0.5, 0.33, (0.25, 0.35))
    h, y, z = b.head, b.y, b.z
    ear = taper((h * 0.7, y, z + 0.08), (h + 0.25, y, z + 0.1), 0.1, 0.1)
    horn = taper((h * 0.5, y, z + h * 0.7), (h * 0.95, y, z + h + draw(0.15, 0.25)), 0.11, 0.07)
    return {
        "body": join(b.trunk(0.28), both(ear), b.tail(0.12, -0.5)),
        "muzzle": b.muzzle(0.12, 0.21),
        "horns": both(horn),
        "eyes": b.eyes(),
        "udder": ball((0, b.long * 0.35, b.belly - b.wide * 0.85), 0.2),
        "patches": _patches(draw, b),
    }


def bull(draw: Draw) -> Parts:
    """Mighty shoulders over a low head, wide horns, a golden ring in its nose."""
    wide, long, leg = draw(0.5, 0.53), draw(0.8, 0.86), draw(0.56, 0.6)
    z = leg + 0.36
    y, up = -long - 0.2, z + 0.14
    nose = y - 0.56
    horn = moved(smooth_bar([(0.18, 0.26, 0.17), (0.54, 0.32, 0.16), (0.8, 0.52, 0.13),
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
            both(ear), four_legs(a, b, z - 0.14, 0.18), tail,
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


def sheep(draw: Draw) -> Parts:
    """A barrel of wool with a dark face and legs, the eyes on the face's front."""
    wide, long, z = draw(0.52, 0.62), draw(0.3, 0.42), draw(0.92, 1.04)
    y, up, head = -long - wide * 0.72, z + 0.34, draw(0.3, 0.35)
    leg = tube((0.3, long * 0.9, 0), (0.3, long * 0.9, z), 0.15)
    return {
        "wool": join(
            capsule((0, -long, z), (0, long, z), wide),
            ball((0, y + 0.06, up + head * 0.85), 0.26),
            ball((0, long + wide, z + 0.2), 0.18),
        ),
        "head": join(
            ball((0, y, up), head),
            capsule((0, y, up - 0.05), (0, y - 0.24, up - 0.14), 0.22),
            both(capsule((0.2, y + 0.05, up + 0.14), (0.52, y + 0.05, up + 0.02), 0.11)),
        ),
        "legs": both(leg, 0, 1),
        "eyes": both(ball((head * 0.5, y - head * 0.78, up + head * 0.34), 0.12)),
        "pupils": both(ball((head * 0.54, y - head * 0.78 - 0.08, up + head * 0.34), 0.09)),
    }


def pig(draw: Draw) -> Parts:
    """On four legs, its snout to the front."""
    wide, long, belly = draw(0.48, 0.56), draw(0.72, 0.85), draw(0.68, 0.76)
    head, y = draw(0.38, 0.43), -long + 0.02
    body = blend(0.12, egg((0, 0, belly), (wide, long, wide)), ball((0, y, belly + 0.16), head))
    ear = taper(
        (head * 0.5, y + 0.02, belly + head),
        (head * 0.85, y - 0.08, belly + head + 0.28),
        0.13,
        0.06,
    )
    leg = capsule((wide * 0.52, long * 0.52, 0.13), (wide * 0.52, long * 0.52, belly * 0.8), 0.14)
    tail = ring((0, long + 0.04, belly + 0.18), 0.12, 0.065, axis=0)
    return {
        "body": join(body, both(ear), both(leg, 0, 1), tail),
        "snout": tube(
            (0, y - head + 0.1, belly + 0.1), (0, y - head - 0.14, belly + 0.1), 0.19, 0.05
        ),
        "eyes": both(ball((head * 0.45, y - head * 0.82, belly + 0.32), 0.075)),
    }


def chicken(draw: Draw) -> Parts:
    """A comb, a wattle, a raised tail: a hen, or a rooster with a great one."""
    wide, leg, cock = draw(0.44, 0.54), draw(0.32, 0.45), draw.chance(0.4)
    z, head = leg + wide * 0.75, draw(0.23, 0.27)
    hy, hz = -0.62, z + draw(0.7, 0.85)
    trunk = taper((0, 0.25, z), (0, -0.2, z), wide * 0.82, wide)
    throat = taper((0, -0.35, z + 0.15), (0, hy, hz), wide * 0.6, head)
    up = draw(0.55, 0.7) if cock else draw(0.32, 0.48)
    plumes = [(0.52, 1.0), (0.72, 0.78), (0.84, 0.5)]
    fan = [
        limb(
            [
                (0, 0.4, z + 0.1),
                (0, y - 0.08, z + up * h * 1.2),
                (0, y + (0.18 if cock else 0.0), z + up * h * 1.25 - (0.18 if cock else 0)),
            ],
            0.2,
            0.12,
        )
        for y, h in plumes
    ]
    comb = [
        ball((0, hy + y, hz + head + up), 0.11)
        for y, up in ((-0.14, -0.02), (0.03, 0.06), (0.2, -0.05))
    ]
    shank = taper((0.24, 0.05, z - wide * 0.5), (0.24, 0.02, 0.1), 0.12, 0.08)
    return {
        "body": blend(0.2, trunk, throat),
        "wings": both(
            tilted(egg((0, 0, 0), (0.14, 0.44, 0.27)), -12, (wide * 0.88, 0.12, z + 0.08))
        ),
        "tail": join(*fan),
        "comb": join(
            *comb, both(egg((0.06, hy - head * 0.85, hz - head * 0.95), (0.1, 0.1, 0.17)))
        ),
        "bill": taper((0, hy - head * 0.8, hz - 0.02), (0, hy - head - 0.2, hz - 0.07), 0.12, 0.05),
        "legs": both(join(shank, bird_claws(0.24, 0, 0.08, 0.22, 0.08))),
        "eyes": both(ball((head * 0.75, hy - head * 0.5, hz + head * 0.25), 0.075)),
    }


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


def duck(draw: Draw) -> Parts:
    """A bath duck."""
    wide, long, head = draw(0.56, 0.64), draw(0.78, 0.88), draw(0.38, 0.43)
    y, z = -long * 0.5, draw(1.15, 1.28)
    hull = cut(egg((0, 0, 0.5), (wide, long, 0.52)), box((0, 0, -0.9), (2, 2, 1)))
    tail = taper((0, long * 0.6, 0.6), (0, long + 0.12, 0.98), 0.28, 0.09)
    bill = egg((0, y - head - 0.1, z - 0.07), (0.21, 0.27, 0.1))
    return {
        "body": blend(0.12, hull, tail, ball((0, y, z), head), tube((0, y, 0.6), (0, y, z), 0.25)),
        "wings": both(egg((wide * 0.85, 0.12, 0.62), (0.16, 0.45, 0.26))),
        "bill": bill,
        "eyes": both(ball((head * 0.6, y - head * 0.72, z + 0.14), 0.085)),
    }


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
            blend(0.14, egg((0, 0.04, z), (wide, long, 0.5)), smooth_bar(neck),
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


FARM_ANIMALS = {
    "horse": fitted(horse),
    "donkey": fitted(donkey),
    "cow": fitted(cow),
    "bull": fitted(bull),
    "sheep": fitted(sheep),
    "pig": pig,
    "chicken": fitted(chicken),
    "rooster": rooster,
    "duck": duck,
    "goose": goose,
    "turkey": turkey,
}
