"""What has scutes along its back and a jaw full of teeth."""

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
    Vector,
    ball,
    blend,
    both,
    chain,
    egg,
    grown,
    join,
    limb,
    mirrored,
    moved,
    prism,
    tilted,
    within,
)
from core.prior.things.animals import fitted


def _spike(at: Vector, high: float, lean: float = 0.0) -> Solid:
    """A pyramid that stands on ``at``, turned about x by ``lean`` degrees, its tip to the back."""
    side = prism([(-0.15, -0.12), (0.15, -0.12), (0.11, high)], 0, 0.14)
    front = prism([(-0.15, -0.12), (0.15, -0.12), (0.04, high), (-0.04, high)], 1, 0.3)
    return tilted(within(side, front), lean, at)


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


REPTILES = {"crocodile": fitted(crocodile)}
