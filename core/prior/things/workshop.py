"""The workshop: an engine, a tire, and what stands about."""

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
    egg,
    grown,
    join,
    lathe,
    limb,
    mirrored,
    moved,
    prism,
    ring,
    taper,
    tilted,
    tube,
    turned,
    within,
)


def gaming_chair(draw: Draw) -> Parts:
    """A racing seat: a high winged back, its sides of a second colour, a pillow at the head, arms,
    a star of five wheels."""
    high, x = draw(0.86, 0.92), draw(0.4, 0.43)
    lean, at = -9, (0.0, 0.42, high + 0.04)
    half = [(x, 0), (x + 0.08, 0.5), (x + 0.2, 0.86), (x + 0.2, 1.1), (x, 1.28), (x, 1.62),
            (x - 0.14, 1.76)]  # fmt: skip
    wing = [(x + 0.04, -0.02, 0.1), (x + 0.1, -0.06, 0.5), (x + 0.22, -0.1, 0.9),
            (x + 0.16, -0.06, 1.16)]  # fmt: skip
    top = limb([(x - 0.02, -0.04, 1.34), (x - 0.02, -0.04, 1.6)], 0.12, 0.12)
    post = join(tube((0, 0, 0.26), (0, 0, high), 0.13), tube((0, 0, 0.4), (0, 0, 0.62), 0.19, 0.04))
    star = around(5, taper((0, 0, 0.34), (0.66, 0, 0.26), 0.13, 0.1), -90)
    reach = x + 0.32
    rest = join(
        box((reach, -0.02, high + 0.44), (0.12, 0.34, 0.08), 0.06),
        capsule((reach, 0.04, high), (reach, 0.04, high + 0.4), 0.09),
        capsule((x - 0.1, 0.04, high - 0.08), (reach, 0.04, high - 0.02), 0.09),
    )
    return {
        "seat": join(
            box((0, -0.06, high), (x, 0.54, 0.17), 0.1),
            tilted(grown(prism(mirrored(half), 1, 0.07), 0.05), lean, at),
        ),
        "stripes": both(
            join(tilted(join(limb(wing, 0.13, 0.13), top), lean, at),
                 box((x + 0.02, -0.08, high + 0.04), (0.12, 0.54, 0.19), 0.11))
        ),
        "pillows": tilted(
            join(box((0, -0.16, 1.42), (x - 0.14, 0.13, 0.17), 0.1),
                 box((0, -0.16, 0.4), (x - 0.1, 0.13, 0.18), 0.1)), lean, at
        ),
        "arms": both(rest),
        "base": join(post, star),
        "wheels": around(5, ball((0.7, 0, 0.15), 0.16), -90),
    }  # fmt: skip


def pen(draw: Draw) -> Parts:
    """A fountain pen that leans, its golden nib down: a thick body, bands, a clip on its cap."""
    r, lean = draw(0.27, 0.29), 35

    def leaning(solid: Solid) -> Solid:
        """What is made upright about z = 1.5."""
        return moved(turned(moved(solid, (0, 0, -1.5)), 1, lean), (0, 0, 1.5))

    nib = prism(mirrored([(0.02, -0.02), (0.08, 0.04), (0.26, 0.44), (0.2, 0.72)]), 1, 0.3)
    shell = lathe([(0.07, -0.02), (0.24, 0.48), (0.22, 0.72)], 0.01)
    clip = join(
        box((0, -r - 0.14, 2.36), (0.09, 0.08, 0.42), 0.05),
        box((0, -r, 2.7), (0.09, 0.2, 0.09), 0.04),
        ball((0, -r - 0.12, 1.98), 0.13),
    )
    rims = ((0.98, r + 0.03), (1.82, r + 0.06))
    return {
        "body": leaning(join(
            lathe([(r * 0.86, 0.96), (r, 1.2), (r + 0.01, 1.9)], 0.01),
            lathe([(r + 0.03, 1.8), (r + 0.03, 2.6), (r * 0.8, 2.88)], 0.01),
        )),
        "grip": leaning(lathe([(0.18, 0.6), (0.2, 0.68), (r * 0.82, 1.0)], 0.02)),
        "nib": leaning(within(shell, nib)),
        "hole": leaning(egg((0, -0.21, 0.46), (0.1, 0.12, 0.12))),
        "bands": leaning(join(*(tube((0, 0, v - 0.07), (0, 0, v + 0.07), e, 0.02)
                                for v, e in rims), egg((0, 0, 2.92), (0.2, 0.2, 0.12)))),
        "clip": leaning(clip),
    }  # fmt: skip


def notebook(draw: Draw) -> Parts:
    """A notebook that stands, bound by bold rings at its left side; a label, an elastic band."""
    x, y, z = draw(0.78, 0.84), draw(0.23, 0.26), draw(1.06, 1.12)
    low = 0.05
    rings = [ring((-x + 0.02, 0, low + z * (0.17 + 0.33 * k)), y + 0.12, 0.08) for k in range(6)]
    return {
        "cover": both(box((0, y, low + z), (x, 0.075, z), 0.05), 1),
        "pages": box((0.02, 0, low + z), (x - 0.08, y + 0.02, z - 0.08)),
        "rings": join(*rings),
        "label": box((0.02, -y - 0.06, low + z * 1.34), (x * 0.5, 0.09, z * 0.22), 0.05),
        "band": box((x * 0.74, 0, low + z), (0.085, y + 0.15, z + 0.07), 0.04),
    }


def tire(draw: Draw) -> Parts:
    """A tyre that stands on its tread, open in the middle: bold blocks about a thick ring."""
    r, half, hole = draw(1.16, 1.2), draw(0.42, 0.46), draw(0.62, 0.66)
    side = [(hole, -half * 0.72), (hole + 0.14, -half), (r - 0.2, -half), (r, -half * 0.62)]
    profile = [*side, *((u, -v) for u, v in reversed(side))]
    body = grown(cut(lathe(profile), tube((0, 0, -2), (0, 0, 2), hole)), 0.02)
    count = 14
    block = box((r + 0.02, 0, half * 0.5), (0.13, 0.15, half * 0.42), 0.03)
    lower = box((r + 0.02, 0, -half * 0.5), (0.13, 0.15, half * 0.42), 0.03)
    rib = both(ring((0, 0, half), (r + hole) / 2 - 0.04, 0.09), 2)

    def standing(solid: Solid) -> Solid:
        return tilted(solid, 90, (0, 0, r + 0.13))

    return {
        "tyre": standing(body),
        "tread": standing(join(around(count, block), around(count, lower, 180 / count))),
        "stripe": standing(rib),
    }


def boombox(draw: Draw) -> Parts:
    """Two large speakers, a cassette deck between them, buttons, a bright handle and aerial."""
    x, y, half = draw(1.32, 1.36), draw(0.36, 0.38), draw(0.57, 0.6)
    at, r, top = x * 0.63, draw(0.38, 0.4), 2 * half
    speaker = join(tube((at, -y - 0.05, half), (at, 0, half), r),
                   ball((at, -y - 0.02, half), 0.17))  # fmt: skip
    bow = join(
        both(box((x * 0.54, 0, top + 0.12), (0.12, 0.13, 0.26), 0.04)),
        box((0, 0, top + 0.36), (x * 0.54 + 0.12, 0.13, 0.12), 0.05),
    )
    keys = [box((0.32 * k, -y + 0.17, top + 0.02), (0.1, 0.13, 0.13), 0.04) for k in (-1, 0, 1)]
    foot, tip = (x - 0.16, 0.06, top - 0.1), (x + 0.06, 0.06, top + 0.86)
    return {
        "body": box((0, 0, half), (x, y, half), 0.1),
        "rims": both(ring((at, -y, half), r, 0.1, 1)),
        "speakers": both(speaker),
        "deck": join(
            box((0, -y, half * 0.68), (0.27, 0.09, 0.21), 0.03),
            box((0, -y, half * 1.52), (0.27, 0.09, 0.13), 0.03),
        ),
        "reels": both(tube((0.14, -y - 0.18, half * 0.68), (0.14, -y, half * 0.68), 0.09, 0.02)),
        "buttons": join(*keys),
        "handle": join(bow, capsule(foot, tip, 0.08), ball(tip, 0.13)),
    }


def picnic_table(draw: Draw) -> Parts:
    """A table of three thick planks, a bench at either side, A-shaped legs that hold all."""
    x, high, seat = draw(1.3, 1.36), draw(1.36, 1.42), draw(0.74, 0.78)
    out = draw(1.02, 1.06)
    planks = [box((0, 0.44 * k, high), (x, 0.17, 0.1), 0.03) for k in (-1, 0, 1)]
    u = x * 0.64
    leg = capsule((u, 0.3, high - 0.12), (u, 0.86, 0.11), 0.11)
    return {
        "top": join(*planks),
        "benches": both(box((0, out, seat), (x, 0.22, 0.1), 0.03), 1),
        "legs": join(
            both(leg, 0, 1),
            both(box((u, 0, seat - 0.16), (0.1, out + 0.14, 0.1), 0.03)),
            both(box((u, 0, high - 0.16), (0.1, 0.56, 0.1), 0.03)),
            box((0, 0, seat - 0.16), (u, 0.1, 0.1), 0.03),
        ),
    }


def engine(draw: Draw) -> Parts:
    """A V8: two rows of cylinders under red covers with bright ribs, bright exhaust pipes at the
    sides, a fan and pulleys in front, a round air filter on top."""
    y, lean = draw(0.86, 0.9), 42
    z, pulley = 0.64, (0.6, 1.2)
    half = [(0.3, 0.12), (0.42, 0.42), (0.5, 0.7), (0.9, 1.2), (0.5, 1.5), (0.2, 1.3)]

    def on_bank(solid: Solid) -> Solid:
        return moved(turned(solid, 1, lean), (0.78, 0, 1.42))

    ribs = [on_bank(box((0, 0.5 * k, 0.2), (0.21, 0.11, 0.12), 0.04)) for k in (-1, 0, 1)]
    pipes = [limb([(0.62, 0.5 * k, 0.92), (1.02, 0.5 * k, 0.86), (1.14, 0.5 * k, 0.42)], 0.14, 0.14)
             for k in (-1, 0, 1)]  # fmt: skip
    drain = capsule((1.14, -0.5, 0.34), (1.14, y + 0.26, 0.34), 0.18)
    fan = tilted(around(5, box((0.33, 0, 0), (0.25, 0.15, 0.08), 0.05), 90), 90, (0, -y - 0.42, z))
    u, v = pulley
    return {
        "block": grown(prism(mirrored(half), 1, y - 0.04), 0.04),
        "covers": both(on_bank(box((0, 0, 0), (0.32, y - 0.06, 0.2), 0.08))),
        "ribs": both(join(drain, *ribs, *pipes)),
        "filter": join(
            tube((0, 0, 1.72), (0, 0, 2.04), draw(0.58, 0.61), 0.04),
            tube((0, 0, 1.2), (0, 0, 1.8), 0.3),
        ),
        "lid": join(tube((0, 0, 1.98), (0, 0, 2.16), 0.72, 0.05), ball((0, 0, 2.18), 0.15)),
        "pulleys": both(tube((u, -y - 0.24, v), (u, -y + 0.1, v), 0.25, 0.04)),
        "fan": join(fan, tube((0, -y - 0.58, z), (0, -y + 0.1, z), 0.17, 0.04)),
    }


WORKSHOP = {
    "gaming chair": gaming_chair,
    "pen": pen,
    "notebook": notebook,
    "tire": tire,
    "boombox": boombox,
    "picnic table": picnic_table,
    "engine": engine,
}
