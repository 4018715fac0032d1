"""Oddities: a beetle, a chameleon, an axolotl, a pufferfish."""

import math

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    ball,
    blend,
    both,
    box,
    egg,
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
    within,
)
from core.prior.things.animals import fitted
from core.prior.things.characters import eyes


def beetle(draw: Draw) -> Parts:
    """A stag beetle: two shiny wing covers with a seam, six bent legs, jaws like antlers."""
    wide, long, high = draw(0.74, 0.78), draw(0.9, 0.96), draw(0.7, 0.74)
    z = 0.36
    y = -long * 0.62
    cover = within(egg((0.06, 0.3, z), (wide, long, high)), box((1.0, 0, z + 0.96), (1, 3, 1)))
    jaw = limb([(0.22, y - 0.6, z - 0.02), (0.56, y - 0.92, z + 0.1), (0.58, y - 1.22, z + 0.36),
                (0.26, y - 1.38, z + 0.6)], 0.17, 0.11)  # fmt: skip
    tooth = taper((0.57, y - 1.06, z + 0.22), (0.28, y - 1.12, z + 0.3), 0.14, 0.1)
    legs = [
        limb([(wide * 0.7, at, z - 0.06), (wide + 0.2, at + lean, z + 0.06),
              (wide + 0.38, at + lean * 1.7, 0.11)], 0.15, 0.115)
        for at, lean in ((-0.5, -0.26), (0.2, 0.06), (0.74, 0.3))
    ]  # fmt: skip
    return {
        "shell": both(cover),
        "seam": within(egg((0, 0.3, z), (wide + 0.05, long + 0.05, high + 0.05)),
                       box((0, 0, z + 1), (0.07, 3, 1.1))),
        "head": join(
            egg((0, y, z + 0.08), (wide * 0.94, 0.46, 0.5)),
            egg((0, y - 0.44, z + 0.08), (0.5, 0.34, 0.34)),
            egg((0, 0.3, z - 0.04), (wide * 0.94, long * 0.94, 0.2)),
        ),
        "jaws": both(join(jaw, tooth)),
        "legs": both(join(*legs)),
        "eyes": eyes(0.34, y - 0.6, z + 0.32, 0.14),
    }  # fmt: skip


def chameleon(draw: Draw) -> Parts:
    """On a branch: a high flat body with a crest, a helmet, turning eyes, a tail in a spiral."""
    wide, long, high = draw(0.34, 0.37), draw(0.76, 0.82), draw(0.5, 0.54)
    z, y = 1.0, -0.98
    up, r = 1.16, draw(0.5, 0.54)
    core = (long + 0.34, z - 0.36)
    coil = [(0, long * 0.6, z + 0.06)]
    for k in range(15):
        turn, out = math.radians(100 - 30 * k), r - 0.026 * k
        coil.append((0, core[0] + out * math.cos(turn), core[1] + out * math.sin(turn)))
    leg = [
        limb([(wide * 0.7, at, z - 0.16), (wide + 0.2, at + lean, z - 0.34),
              (0.22, at + lean * 0.5, 0.36)], 0.14, 0.12)
        for at, lean in ((-0.46, 0.1), (0.42, -0.06))
    ]  # fmt: skip
    spine = [(0, -long * 0.46, z + high * 0.9), (0, -long * 0.1, z + high * 1.02),
             (0, long * 0.3, z + high * 0.94), (0, long * 0.64, z + high * 0.68)]  # fmt: skip
    return {
        "body": join(
            blend(0.12, egg((0, 0, z), (wide, long, high)),
                  egg((0, y + 0.16, up), (0.3, 0.42, 0.3))),
            taper((0, y, up - 0.02), (0, y - 0.4, up - 0.1), 0.24, 0.14),
            taper((0, y + 0.12, up + 0.12), (0, y + 0.46, up + 0.56), 0.27, 0.12),
            limb(coil, 0.19, 0.11), both(join(*leg)),
        ),
        "crest": join(*(egg(at, (0.1, 0.17, 0.16)) for at in spine)),
        "stripes": both(join(*(
            moved(turned(egg((0, 0, 0), (0.1, 0.1, 0.34)), 0, 12), (wide * out, at, z + 0.06))
            for at, out in ((-0.34, 0.9), (0.02, 0.97), (0.38, 0.88))
        ))),
        "eyes": both(ball((0.28, y - 0.02, up + 0.08), 0.2)),
        "pupils": both(ball((0.41, y - 0.12, up + 0.1), 0.125)),
        "branch": join(tube((0, -1.3, 0.18), (0, 1.1, 0.18), 0.2, 0.06),
                       taper((0, 0.2, 0.2), (-0.5, -0.2, 0.2), 0.15, 0.12)),
    }  # fmt: skip


def axolotl(draw: Draw) -> Parts:
    """Pink: a broad smiling head, three tapered frills on each side, four legs, a finned tail."""
    wide, head, far = draw(0.4, 0.43), draw(0.74, 0.78), draw(0.76, 0.82)
    z, y, up = 0.5, -0.72, 0.68
    face = y - 0.5
    frill = smooth_curve([(0.0, -0.1), (far * 0.4, -0.2), (far, 0.0), (far * 0.4, 0.2), (0.0, 0.1)])
    gills = (
        moved(turned(turned(prism(frill, 1, 0.1), 1, -turn), 2, 16),
              (head * out, y + 0.24, up + rise))
        for turn, out, rise in ((-6, 0.8, -0.02), (32, 0.7, 0.2), (70, 0.44, 0.3))
    )  # fmt: skip
    smile = ((-0.34, 0.1), (-0.2, -0.02), (0, -0.07), (0.2, -0.02), (0.34, 0.1))
    fin = [(-0.1, z + 0.3), (0.4, z + 0.5), (1.0, z + 0.62), (1.5, z + 0.54), (1.86, z + 0.14),
           (1.5, z - 0.26), (1.0, z - 0.32), (0.6, z - 0.1)]  # fmt: skip
    legs = (
        limb([(wide * 0.6, at, z - 0.1), (wide + 0.3, at - 0.08, 0.26),
              (wide + 0.42, at - 0.26, 0.15)], 0.18, 0.15)
        for at in (-0.24, 0.6)
    )  # fmt: skip
    return {
        "body": join(
            blend(0.16, egg((0, y, up), (head, 0.54, 0.48)),
                  egg((0, 0.1, z), (wide, 0.74, 0.4)),
                  taper((0, 0.5, z), (0, 1.5, z + 0.1), 0.28, 0.14)),
            both(join(*legs)),
        ),
        "fin": prism(smooth_curve(fin), 0, 0.1),
        "gills": both(join(*gills)),
        "mouth": limb([(u, face + 0.6 * u * u, up - 0.12 + v) for u, v in smile], 0.08, 0.08),
        "cheeks": both(ball((head * 0.76, face + 0.24, up - 0.08), 0.13)),
        "eyes": eyes(head * 0.56, face + 0.14, up + 0.22, 0.14),
    }  # fmt: skip


def pufferfish(draw: Draw) -> Parts:
    """A ball with bold spikes, a pale belly, small fins, thick lips and big eyes."""
    r, tall = draw(0.84, 0.88), draw(0.26, 0.3)
    z = 1.2
    spikes = []
    for lift, *turns in ((84, 0), (54, 34, 102, 180), (14, 76, 132, 180), (-28, 38, 84, 136, 180)):
        up, out = math.sin(math.radians(lift)), math.cos(math.radians(lift))
        for turn in turns:
            x, y = out * math.sin(math.radians(turn)), -out * math.cos(math.radians(turn))
            far = r + tall
            spikes.append(taper((x * r * 0.9, y * r * 0.9, up * r * 0.9),
                                (x * far, y * far, up * far), 0.16, 0.065))  # fmt: skip
    vane = smooth_curve([(0, -0.16), (0.34, -0.3), (0.56, -0.1), (0.58, 0.14), (0.34, 0.3),
                         (0, 0.16)])  # fmt: skip
    side = moved(turned(turned(prism(vane, 1, 0.1), 1, -10), 2, 24), (r * 0.86, 0.04, z - 0.1))
    tail = smooth_curve([(r - 0.1, z - 0.14), (r + 0.36, z - 0.42), (r + 0.62, z - 0.36),
                         (r + 0.54, z), (r + 0.62, z + 0.36), (r + 0.36, z + 0.42),
                         (r - 0.1, z + 0.14)])  # fmt: skip
    return {
        "body": ball((0, 0, z), r),
        "belly": within(ball((0, 0, z), r + 0.045), box((0, 0, z - 1.17), (2, 2, 1.1))),
        "spikes": moved(both(join(*spikes)), (0, 0, z)),
        "fins": join(both(side), prism(tail, 0, 0.11)),
        "mouth": tilted(ring((0, 0, 0), 0.17, 0.13, 1), 6, (0, -r - 0.02, z - 0.1)),
        "whites": both(ball((0.44, -r * 0.76, z + 0.3), 0.24)),
        "eyes": eyes(0.47, -r * 0.76 - 0.17, z + 0.32, 0.13),
    }  # fmt: skip


ODDITIES = {
    "beetle": fitted(beetle),
    "chameleon": fitted(chameleon),
    "axolotl": fitted(axolotl),
    "pufferfish": pufferfish,
}
