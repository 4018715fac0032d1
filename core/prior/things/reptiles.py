"""Dragon and crocodile: what has scales, spikes along its back and a jaw full of teeth."""

from collections.abc import Sequence
from itertools import pairwise

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
    Vector,
    ball,
    blend,
    both,
    box,
    chain,
    egg,
    grown,
    join,
    limb,
    mirrored,
    moved,
    prism,
    smooth_curve,
    taper,
    tilted,
    turned,
    within,
)
from core.prior.things.animals import fitted

Outline = list[tuple[float, float]]


def _spine(stops: Sequence[tuple[float, float, float]], steps: int = 4) -> list:
    """Balls (centre, radius) along a smooth curve through the stops (y, z, radius)."""
    path = smooth_curve([(y, z) for y, z, _ in stops], steps)
    thick = [r for _, _, r in stops]
    balls = []
    for k, (y, z) in enumerate(path):
        at, t = divmod(k, steps)
        r = thick[at] + (thick[min(at + 1, len(thick) - 1)] - thick[at]) * t / steps
        balls.append(((0.0, y, z), r))
    return balls


def _spike(at: Vector, high: float, lean: float = 0.0) -> Solid:
    """A pyramid that stands on ``at``, turned about x by ``lean`` degrees, its tip to the back."""
    side = prism([(-0.15, -0.12), (0.15, -0.12), (0.11, high)], 0, 0.14)
    front = prism([(-0.15, -0.12), (0.15, -0.12), (0.04, high), (-0.04, high)], 1, 0.3)
    return tilted(within(side, front), lean, at)


def _membrane(root: tuple[float, float], wrist: tuple[float, float], ends: Outline) -> Outline:
    """A wing's outline (out, up): its arm, and hollows between its fingers' ends."""
    edge = [ends[0]]
    for (ax, ay), (bx, by) in pairwise(ends):
        mx, my = (ax + bx) / 2, (ay + by) / 2
        # The hollow's depth, towards the wrist.
        cx, cy = mx + (wrist[0] - mx) * 0.5, my + (wrist[1] - my) * 0.5
        for t in (0.25, 0.5, 0.75, 1.0):
            a, c, b = (1 - t) ** 2, 2 * t * (1 - t), t * t
            edge.append((a * ax + c * cx + b * bx, a * ay + c * cy + b * by))
    return [root, wrist, *edge]


def _wing(draw: Draw, up: float) -> tuple[Solid, Solid]:
    """The right wing's skin, its lower edge scalloped, and the arm that carries it."""
    span, high = draw(1.5, 1.75), draw(1.0, 1.16)
    wrist = (0.55, up + high)
    tip = (span, up + high * draw(0.75, 0.9))
    ends = [tip, (span * 0.88, up), (span * 0.52, up - 0.24), (0.15, up - 0.16)]
    skin = prism(_membrane((0.15, up + 0.12), wrist, ends), 1, 0.1)
    a, b, c = (0.15, 0, up), (wrist[0], 0, wrist[1]), (tip[0], 0, tip[1])
    fingers = [taper(b, (u, 0, v), 0.15, 0.12) for u, v in ends[1:3]]
    claw = taper(b, (wrist[0] - 0.04, 0, wrist[1] + 0.26), 0.13, 0.08)
    arm = join(limb([a, b, c], 0.16, 0.12), claw)
    return turned(join(skin, *fingers), 2, 24), turned(arm, 2, 24)


def _dragon_head(y: float, z: float) -> tuple[Solid, Solid, Solid]:
    """Skull, snout and jaw, a mouth between them; the horns; the eyes."""
    upper = [(-0.2, -0.1), (0.2, -0.1), (0.16, -0.46), (0.2, -0.6), (0.12, -0.72), (-0.12, -0.72),
             (-0.2, -0.6), (-0.16, -0.46)]  # fmt: skip
    lower = [(-0.19, -0.05), (0.19, -0.05), (0.13, -0.6), (-0.13, -0.6)]
    skull = join(
        egg((0, 0, 0), (0.29, 0.33, 0.27)),
        prism(upper, 2, 0.12, 0.02),
        turned(prism(lower, 2, 0.1, -0.2), 0, 14),
        both(ball((0.12, -0.6, 0.14), 0.11)),
        both(taper((0.17, -0.34, 0.15), (0.24, 0.02, 0.26), 0.1, 0.1)),
    )
    horns = both(limb([(0.16, 0.08, 0.16), (0.26, 0.42, 0.28), (0.3, 0.68, 0.54)], 0.14, 0.08))
    eyes = both(ball((0.23, -0.22, 0.08), 0.1))
    return tuple(tilted(solid, 8, (0, y, z)) for solid in (skull, horns, eyes))


def dragon(draw: Draw) -> Parts:
    """An S-shaped neck, bat's wings with scalloped edges, horns, a spiked back, a spade tail."""
    wide, long, hip = draw(0.34, 0.4), draw(0.54, 0.64), draw(0.72, 0.84)
    rise, tip, e = draw(0.95, 1.12), draw(0.5, 0.7), long + 0.8
    y, z = -long - 0.3, hip + rise
    neck = _spine(
        [(-long * 0.5, hip + 0.08, wide * 0.85), (-long - 0.22, hip + 0.3, 0.26),
         (-long - 0.14, hip + rise * 0.62, 0.2), (y + 0.2, z - 0.06, 0.21), (y, z, 0.21)]
    )  # fmt: skip
    tail = _spine(
        [(long * 0.6, hip - 0.02, wide * 0.8), (long + 0.2, hip * 0.52, 0.25),
         (long + 0.5, 0.24, 0.19), (e - 0.05, tip - 0.2, 0.15), (e, tip, 0.13)]
    )  # fmt: skip
    trunk = taper((0, -long * 0.5, hip + 0.06), (0, long * 0.5, hip), wide, wide * 0.9)
    fore, hind = -long * 0.62, long * 0.72
    legs = join(
        limb([(wide * 0.75, fore, hip), (wide + 0.1, fore + 0.08, hip * 0.5),
              (wide + 0.08, fore - 0.06, 0.12)], 0.2, 0.14),
        egg((wide * 0.85, hind, hip - 0.08), (0.2, 0.32, 0.34)),
        limb([(wide + 0.02, hind - 0.1, hip - 0.25), (wide + 0.08, hind + 0.16, 0.36),
              (wide + 0.08, hind, 0.12)], 0.19, 0.14),
        *(box((wide + 0.08, at - 0.14, 0.1), (0.17, 0.24, 0.1), 0.07) for at in (fore, hind)),
    )  # fmt: skip
    claws = [
        taper((wide + 0.08 + s, at - 0.34, 0.08), (wide + 0.08 + s, at - 0.48, 0.05), 0.1, 0.07)
        for at in (fore, hind) for s in (-0.1, 0.1)
    ]  # fmt: skip
    skull, horns, eyes = _dragon_head(y - 0.06, z + 0.04)
    skin, arm = _wing(draw, hip + 0.22)
    spade = prism([(e - 0.28, tip - 0.05), (e, tip + 0.08), (e + 0.28, tip - 0.05),
                   (e + 0.04, tip + 0.5)], 0, 0.11)  # fmt: skip
    throat = chain(((0, b[1] - r * 0.45, b[2] - r * 0.1), r * 0.8) for b, r in neck[2:13])
    return {
        "body": join(trunk, chain(neck), chain(tail), both(legs), skull, both(arm)),
        "belly": join(throat, egg((0, 0, hip - 0.1), (wide * 0.8, long * 1.05, wide * 0.9))),
        "wings": join(both(skin), spade),
        "horns": join(horns, both(join(*claws)), *_ridge(neck, tail, long, hip + wide)),
        "eyes": eyes,
    }


def _ridge(neck: list, tail: list, long: float, top: float) -> list[Solid]:
    """The spikes of the dragon's neck, back and tail."""
    spikes = [_spike((0, at * long, top - 0.03), 0.28) for at in (-0.35, 0.15, 0.65)]
    for k, lean in ((6, -70), (9, -80)):
        (_, y, z), r = neck[k]
        spikes.append(_spike((0, y + r * 0.9, z + r * 0.1), 0.26, lean))
    for k, lean in ((4, -32), (7, -25)):
        (_, y, z), r = tail[k]
        spikes.append(_spike((0, y + r * 0.3, z + r * 0.85), 0.24, lean))
    return spikes


def crocodile(draw: Draw) -> Parts:
    """Long and low: a flat snout full of teeth, two rows of scutes, splayed legs, a long tail."""
    wide, snout, bend = draw(0.38, 0.45), draw(0.76, 0.88), draw(0.2, 0.34)
    z, y = 0.4, -0.62
    trunk = blend(0.1, egg((0, 0, z), (wide, 0.86, 0.27)), egg((0, y, z + 0.04), (0.3, 0.36, 0.22)))
    tail = chain(
        [((0, 0.4, z), 0.26), ((0, 0.95, z - 0.06), 0.22), ((bend * 0.3, 1.4, 0.24), 0.16),
         ((bend, 1.9, 0.2), 0.1)]
    )  # fmt: skip
    half = [(0.27, 0.2), (0.21, -snout * 0.55), (0.25, -snout * 0.8), (0.17, -snout)]
    upper, lower = (
        tilted(prism([(s * u, s * v) for u, v in mirrored(half)], 2, 0.1), lean, (0, y - 0.1, at))
        for s, lean, at in ((1, -10, z + 0.13), (0.92, 4, z - 0.14))
    )
    saw = [(-snout * (0.16 + 0.1 * k), -0.06 - 0.2 * (k % 2)) for k in range(9)]
    teeth = tilted(prism(saw, 0, 0.09, 0.12), -10, (0, y - 0.1, z + 0.13))
    legs, nose = [], (0.1, y - 0.06 - snout * 0.88, z + 0.13 + snout * 0.16 + 0.1)
    for at, back in ((-0.5, 0.06), (0.52, 0.14)):
        x = wide + 0.26
        legs.append(limb([(wide * 0.6, at, z), (x, at + back, z - 0.1), (x, at, 0.1)], 0.18, 0.13))
        paw = [(-0.1, 0.1), (0.1, 0.1), (0.22, -0.2), (0.1, -0.16), (0, -0.3), (-0.1, -0.16),
               (-0.22, -0.2)]  # fmt: skip
        legs.append(moved(grown(prism(paw, 2, 0.05), 0.05), (x, at, 0.09)))
    bumps = join(ball((0.19, y - 0.06, z + 0.24), 0.16), ball(nose, 0.1))
    scutes = [_spike((0.17, at, z + 0.2 - 0.12 * at * at), 0.17) for at in (-0.32, 0.08, 0.48)]
    fins = [
        _spike((bend * s, at, up), 0.2)
        for at, up, s in ((0.88, z + 0.16, 0.04), (1.26, 0.42, 0.22), (1.62, 0.34, 0.62))
    ]
    return {
        "body": join(trunk, tail, upper, both(join(*legs, bumps))),
        "belly": join(lower, egg((0, 0, z - 0.08), (wide * 0.92, 0.84, 0.27))),
        "crest": join(both(join(*scutes)), *fins),
        "teeth": both(teeth),
        "eyes": both(ball((0.24, y - 0.14, z + 0.27), 0.11)),
    }


REPTILES = {"dragon": fitted(dragon), "crocodile": fitted(crocodile)}
