"""Animals of the sea and of ponds."""

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
    chain,
    egg,
    grown,
    join,
    lathe,
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
from core.prior.things.shared.faces import eyes
from core.prior.things.shared.fitted import fitted


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


def seahorse(draw: Draw) -> Parts:
    """Upright, its snout a pipe, a crest, rings about its belly, its tail rolled up."""
    big, snout, crest = draw(0.92, 1.08), draw(0.42, 0.54), draw(0.16, 0.26)
    y, z = -0.28, 2.3
    spine = [((0.0, y, z), 0.3), ((0.0, 0.0, z - 0.2), 0.25), ((0.0, 0.08, z - 0.48), 0.25),
             ((0.0, -0.06, z - 0.84), 0.36 * big), ((0.0, -0.04, z - 1.12), 0.37 * big),
             ((0.0, 0.14, z - 1.44), 0.27), ((0.0, 0.22, z - 1.74), 0.21),
             *(((0.0, -0.14 + 0.36 * (1 - k * 0.03) * math.cos(t), z - 1.86 - 0.36 * math.sin(t)),
                0.17 - 0.008 * k) for k, t in ((k, 0.3 + 0.62 * k) for k in range(8)))]  # fmt: skip
    bands = []
    for at in (3, 4, 5, 6):
        (_, a, b), r = spine[at]
        turn = (8, -10, -22, -14)[at - 3]
        bands.append(moved(turned(tube((0, 0, -0.06), (0, 0, 0.06), r + 0.045, 0.02), 0, turn),
                           (0, a, b)))  # fmt: skip
    thorns = [
        taper((0, a + r * 0.6, b), (0, a + r + 0.14, b + 0.06), 0.13, 0.07)
        for (_, a, b), r in spine[1:7:1]
    ]
    comb = [taper((0, y + v, z + 0.2), (0, y + v * 2, z + 0.34 + crest * s), 0.13, 0.08)
            for v, s in ((-0.02, 0.6), (0.1, 1.0), (0.2, 0.5))]  # fmt: skip
    fan = [(0.1, z - 0.8), (0.62, z - 0.66), (0.7, z - 0.98), (0.58, z - 1.28), (0.1, z - 1.3)]
    return {
        "body": join(
            chain(spine),
            taper((0, y - 0.1, z - 0.06), (0, y - 0.2 - snout, z - 0.24), 0.17, 0.12),
        ),
        "belly": egg((0, -0.22, z - 0.94), (0.26, 0.26 * big, 0.42)),
        "bands": join(
            *bands,
            moved(turned(tube((0, 0, -0.08), (0, 0, 0.08), 0.17, 0.03), 0, 112),
                  (0, y - 0.2 - snout, z - 0.24)),
        ),
        "crest": join(*comb, *thorns),
        "fins": join(
            prism(fan, 0, 0.085), both(egg((0.28, y + 0.2, z - 0.1), (0.09, 0.15, 0.2)))
        ),
        "eyes": eyes(0.22, y - 0.1, z + 0.06, 0.125),
    }  # fmt: skip


def stingray(draw: Draw) -> Parts:
    """Flat, its fins a rounded diamond, dots on its back, a long tail with a sting."""
    span, long, raised = draw(1.14, 1.22), draw(0.76, 0.82), draw(4, 7)
    z, at = 0.24, -0.74
    edge = [(0, at - long), (0.3, at - long * 0.88), (span * 0.62, at - long * 0.3),
            (span, at + 0.16), (span * 0.6, at + long * 0.66), (0.22, at + long),
            (0, at + long + 0.06)]  # fmt: skip
    fin = grown(turned(prism(smooth_curve(edge, 6), 2, 0.02), 1, -raised), 0.08)
    rise = math.tan(math.radians(raised))
    dots = [
        tube((x, y, z), (x, y, z + x * rise + 0.18), 0.13)
        for x, y in ((0.5, at + 0.32), (0.72, at))
    ]
    return {
        "body": join(
            both(moved(fin, (0, 0, z))),
            egg((0, at, z + 0.02), (0.36, 0.66, 0.26)),
            both(ball((0.24, at - 0.42, z + 0.14), 0.15)),
            taper((0, at + 0.5, z + 0.02), (0, 1.8, z + 0.24), 0.16, 0.07),
        ),
        "belly": egg((0, at, z - 0.06), (0.72, 0.6, 0.18)),
        "patches": both(join(*dots)),
        "horn": taper((0, 0.42, z + 0.1), (0, 0.8, z + 0.36), 0.1, 0.07),
        "eyes": both(ball((0.3, at - 0.48, z + 0.2), 0.12)),
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
        "patches": around(6, spot),
    }


def starfish(draw: Draw) -> Parts:
    """Upright like a star: five plump arms, each with a row of knobs that shrink to its tip."""
    reach, middle, tip = draw(1.05, 1.2), draw(0.36, 0.42), draw(0.12, 0.15)
    bend = draw(0.22, 0.28)
    arm = limb([(0, 0, 0), (reach * 0.5, 0, 0), (reach, 0, 0)], middle, tip)

    def standing(solid: Solid) -> Solid:
        return moved(turned(around(5, solid, 90), 0, 90), (0, 0, 1.1))

    knobs, dots = [], []
    for k in range(4):
        x = reach * (0.22 + 0.23 * k)
        thick = middle + (tip - middle) * x / reach
        knobs.append(both(ball((x, 0, thick * 0.94), 0.1 - 0.006 * k), 2))
    for k in range(3):
        x = reach * (0.3 + 0.19 * k)
        thick = (middle + (tip - middle) * x / reach) * 0.96
        at = (x, thick * math.sin(0.95), thick * math.cos(0.95))
        dots.append(both(ball(at, 0.08 - 0.004 * k), 1, 2))
    center = both(ball((0, 0, middle * 0.96), bend * 0.5), 2)
    return {
        "body": standing(arm),
        "knobs": standing(join(*knobs)),
        "dots": standing(join(*dots)),
        "center": moved(turned(center, 0, 90), (0, 0, 1.1)),
    }


def lobster(draw: Draw) -> Parts:
    """Its great claws raised, three pairs of legs, a tail of rings that ends in a fan."""
    wide, long, claw = draw(0.4, 0.46), draw(0.5, 0.56), draw(0.29, 0.33)
    z, step = draw(0.46, 0.52), draw(0.16, 0.18)
    shell = taper((0, -long * 0.8, z + 0.02), (0, long * 0.3, z), wide * 0.62, wide)
    beak = taper((0, -long, z + 0.12), (0, -long - 0.4, z + 0.2), 0.17, 0.085)
    links = []
    for k in range(4):
        y, r = long * 0.4 + step * (k + 1), wide * (0.97 - 0.1 * k)
        links.append(egg((0, y, z - 0.05 * k), (r, 0.17, r * 0.8)))
    blade, end = egg((0.25, 0, 0), (0.25, 0.14, 0.09)), long * 0.4 + step * 4 + 0.08
    fan = [moved(turned(blade, 2, 90 + a), (0, end, z - 0.2)) for a in (-60, -30, 0, 30, 60)]
    # A raised claw: the arm, the palm, and two fingers of which the outer one is the thicker.
    x, y, up = draw(0.78, 0.9), -long - 0.16, z + 0.56
    arm = limb([(wide * 0.6, -long * 0.5, z), (x + 0.1, y, z + 0.08), (x, y, up - 0.2)], 0.12, 0.1)
    palm = egg((x, y, up), (claw, 0.2, 0.3))
    thick = limb([(x + 0.14, y, up), (x + 0.2, y, up + 0.4), (x - 0.04, y, up + 0.7)], 0.19, 0.09)
    thin = limb([(x - 0.16, y, up), (x - 0.34, y, up + 0.3), (x - 0.26, y, up + 0.52)], 0.14, 0.09)
    x_foot, legs = wide + 0.5, []
    for q, s in ((-0.2, -0.08), (0.06, 0.02), (0.32, 0.12)):
        knee = (wide + 0.3, q + s, z + 0.1)
        legs.append(limb([(wide * 0.6, q, z - 0.1), knee, (x_foot, q + s, 0.09)], 0.1, 0.09))
    tip = (0.6, -long - 0.72, z + 0.24)
    feeler = limb([(0.14, -long - 0.1, z + 0.16), (0.34, -long - 0.42, z + 0.3), tip], 0.09, 0.09)
    return {
        "body": join(shell, beak),
        "claws": both(join(arm, palm, thick, thin)),
        "tail": join(*links, *fan),
        "legs": both(join(*legs)),
        "eyes": both(ball((0.26, -long + 0.04, z + 0.4), 0.125)),
        "feelers": both(feeler),
    }


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


def seal(draw: Draw) -> Parts:
    """Lies with its chest raised on its flippers, a pale front, the tail's two fins apart."""
    wide, up = draw(0.38, 0.46), draw(0.78, 0.94)
    y, head = -0.68, draw(0.29, 0.34)
    trunk = chain(
        [((0, 1.3, 0.16), 0.13), ((0, 0.75, 0.27), 0.26), ((0, 0.1, 0.42), wide),
         ((0, -0.36, 0.56), wide * 0.92), ((0, y + 0.08, up + 0.06), 0.3)]
    )  # fmt: skip
    fore = tilted(egg((0, 0, 0), (0.44, 0.2, 0.09)), -6, (0, 0, 0))
    flipper = moved(turned(turned(fore, 1, 24), 2, 18), (wide + 0.22, -0.36, 0.2))
    fan = [(0, 1.2), (0.2, 1.25), (0.46, 1.62), (0.3, 1.74), (0.1, 1.5), (0, 1.42)]
    pad = egg((0.11, y - head * 0.9, up + 0.1), (0.15, 0.15, 0.12))
    return {
        "body": join(trunk, ball((0, y, up + 0.2), head)),
        "belly": taper((0, -0.2, 0.38), (0, y + 0.02, up - 0.1), wide * 0.92, 0.26),
        "fins": join(both(flipper), both(prism(fan, 2, 0.09, 0.16))),
        "muzzle": both(pad),
        "eyes": both(ball((head * 0.56, y - head * 0.72, up + 0.3), 0.09)),
        "nose": egg((0, y - head * 0.9 - 0.12, up + 0.18), (0.1, 0.08, 0.075)),
    }


def walrus(draw: Draw) -> Parts:
    """A heavy body that rests on its flippers; two long tusks under broad whisker pads."""
    wide, head = draw(0.6, 0.64), draw(0.43, 0.46)
    y, up = -0.74, draw(1.08, 1.14)
    trunk = [((0, 1.34, 0.22), 0.2), ((0, 0.8, 0.42), 0.4), ((0, 0.1, 0.6), wide),
             ((0, -0.36, 0.72), wide * 0.98), ((0, y + 0.2, up - 0.04), 0.52)]  # fmt: skip
    face = y - head * 0.84
    fore = moved(turned(turned(egg((0, 0, 0), (0.46, 0.26, 0.12)), 1, 18), 2, 24),
                 (wide + 0.26, -0.5, 0.2))  # fmt: skip
    fin = moved(turned(egg((0, 0.2, 0), (0.2, 0.4, 0.13)), 2, -34), (0.1, 1.36, 0.18))
    tusk = limb([(0.17, face - 0.14, up - 0.08), (0.2, face - 0.24, up - 0.46),
                 (0.19, face - 0.2, up - 0.86)], 0.12, 0.08)  # fmt: skip
    return {
        "body": join(blend(0.12, chain(trunk), ball((0, y, up + 0.14), head))),
        "muzzle": both(egg((0.21, face - 0.05, up + 0.02), (0.29, 0.25, 0.25))),
        "tusks": both(tusk),
        "fins": join(both(fore), both(fin)),
        "eyes": eyes(head * 0.6, y - head * 0.72, up + 0.38, 0.1),
        "nose": egg((0, face - 0.16, up + 0.18), (0.14, 0.1, 0.1)),
    }


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


SEA_ANIMALS = {
    "pufferfish": pufferfish,
    "seahorse": seahorse,
    "stingray": fitted(stingray),
    "jellyfish": fitted(jellyfish),
    "starfish": starfish,
    "lobster": lobster,
    "axolotl": fitted(axolotl),
    "seal": fitted(seal),
    "walrus": fitted(walrus),
    "orca": fitted(orca),
}
