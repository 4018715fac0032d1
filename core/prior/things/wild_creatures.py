"""Wild birds and swimmers, and what has scales or shells."""

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    around,
    ball,
    blend,
    both,
    egg,
    join,
    lathe,
    limb,
    prism,
    smooth_curve,
    taper,
    tilted,
    tube,
)
from core.prior.things.animals import fitted


def crocodile(draw: Draw) -> Parts:
    """Long and low: a flat snout full of teeth, ridges along back and tail, bent legs."""
    wide, snout, tip = draw(0.36, 0.43), draw(0.62, 0.74), draw(0.12, 0.4)
    z, y = 0.42, -0.72
    nose = y - snout
    trunk = blend(
        0.12,
        egg((0, 0, z), (wide, 0.86, 0.29)),
        taper((0, 0.55, z), (0, 1.25, 0.26), 0.27, 0.17),
        taper((0, -0.5, z), (0, y, z + 0.06), 0.28, 0.26),
    )
    tail = taper((0, 1.25, 0.26), (0.0, 1.7, 0.14 + tip), 0.17, 0.1)
    jaw = [(-0.26, y + 0.06), (0.26, y + 0.06), (0.22, nose + 0.1), (0.12, nose), (-0.12, nose),
           (-0.22, nose + 0.1)]  # fmt: skip
    upper, lower = prism(jaw, 2, 0.11, z + 0.17), prism(jaw, 2, 0.09, z - 0.16)
    legs = [
        limb([(wide * 0.7, at, z - 0.06), (wide + 0.22, at + 0.04, z - 0.1),
              (wide + 0.24, at - 0.02, 0.1)], 0.17, 0.12)
        for at in (-0.46, 0.46)
    ]  # fmt: skip
    paws = [egg((wide + 0.26, at - 0.1, 0.09), (0.19, 0.22, 0.09)) for at in (-0.46, 0.46)]
    ridge = []
    for k in range(9):
        at = -0.5 + 0.26 * k
        top = z + 0.2 if at < 0.5 else z + 0.2 - (at - 0.5) * 0.24
        top += max(at - 1.25, 0) / 0.55 * (tip - 0.1)
        ridge.append(taper((0, at, top), (0, at + 0.05, top + 0.16), 0.13, 0.06))
    teeth = [
        tube((0.19, nose + s * snout, z - 0.12), (0.19, nose + s * snout, z + 0.1), 0.09)
        for s in (0.18, 0.52, 0.86)
    ]
    bumps = join(ball((0.17, y - 0.02, z + 0.26), 0.15), ball((0.1, nose + 0.08, z + 0.22), 0.09))
    return {
        "body": join(trunk, tail, upper, lower, both(join(*legs, *paws, bumps))),
        "belly": egg((0, 0, z - 0.08), (wide * 0.9, 0.84, 0.27)),
        "crest": join(*ridge),
        "teeth": both(join(*teeth)),
        "eyes": both(ball((0.23, y - 0.09, z + 0.31), 0.09)),
    }


def jellyfish(draw: Draw) -> Parts:
    """A bell with a scalloped rim, long tentacles, thick arms in the middle."""
    wide, high, long = draw(0.68, 0.8), draw(0.58, 0.72), draw(0.85, 1.1)
    z, count = long + 0.35, 8
    profile = [(wide, z), (wide * 0.97, z + high * 0.35), (wide * 0.8, z + high * 0.68),
               (wide * 0.45, z + high * 0.93), (0.0, z + high)]  # fmt: skip
    wave = 0.07
    down = smooth_curve([(0, z), (wave, z - long * 0.33), (-wave, z - long * 0.68), (0, 0.1)], 2)
    r = wide * 0.8
    tentacle = limb([(r + x, 0, h) for x, h in down], 0.1, 0.085)
    frill = [(0.17, z), (0.24, z - long * 0.25), (0.13, z - long * 0.5), (0.2, z - long * 0.72)]
    arm = limb([(x, 0, h) for x, h in frill], 0.16, 0.1)
    spot = ball((wide * 0.72, 0, z + high * 0.52), 0.17)
    return {
        "body": lathe(smooth_curve(profile, 5)),
        "rim": around(count, egg((wide * 0.88, 0, z), (0.19, wide * 0.37, 0.13)), 180 / count),
        "tentacles": around(count, tentacle),
        "arms": join(around(4, arm, 45), tube((0, 0, z - 0.15), (0, 0, z + 0.1), 0.24)),
        "dots": around(6, spot),
    }


def flamingo(draw: Draw) -> Parts:
    """On two long legs; the neck a bow, the bill bent down with a dark end."""
    leg, wide, up = draw(0.86, 1.02), draw(0.33, 0.39), draw(0.78, 0.92)
    z = leg + 0.26
    top = z + up
    bow = smooth_curve(
        [(-0.4, z + 0.1), (-0.76, z + 0.22), (-0.72, z + up * 0.6), (-0.5, top - 0.06),
         (-0.66, top + 0.16)], 3
    )  # fmt: skip
    y, h = -0.7, top + 0.16
    trunk = blend(
        0.12,
        egg((0, 0, z), (wide, 0.56, 0.33)),
        taper((0, 0.3, z + 0.02), (0, 0.74, z - 0.02), 0.22, 0.1),
        limb([(0, a, b) for a, b in bow], 0.17, 0.11),
    )
    wing = tilted(egg((0, 0, 0), (0.13, 0.56, 0.26)), -6, (wide * 0.86, 0.2, z + 0.07))
    shank = taper((0.17, 0.04, z - 0.2), (0.17, 0.04, 0.08), 0.09, 0.085)
    web = prism(
        [(0.08, 0.1), (0.26, 0.1), (0.36, -0.32), (0.17, -0.26), (-0.02, -0.32)], 2, 0.07, 0.07
    )
    return {
        "body": join(trunk, ball((0, y, h), 0.21)),
        "wings": both(wing),
        "legs": both(join(shank, web, ball((0.17, 0.04, leg * 0.5), 0.125))),
        "bill": taper((0, y - 0.14, h - 0.01), (0, y - 0.36, h - 0.12), 0.13, 0.11),
        "tip": taper((0, y - 0.38, h - 0.14), (0, y - 0.42, h - 0.32), 0.115, 0.07),
        "eyes": both(ball((0.15, y - 0.09, h + 0.07), 0.08)),
    }


WILD_CREATURES = {
    "crocodile": fitted(crocodile),
    "jellyfish": fitted(jellyfish),
    "flamingo": fitted(flamingo),
}
