"""What makes music and what feasts are decked with; a grenade, a trident and a horseshoe."""

import math

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
    smooth_curve,
    taper,
    tilted,
    tube,
    turned,
    within,
)


def drum_kit(draw: Draw) -> Parts:
    """A bass drum to the front, two toms on it, a snare and a floor tom beside, two cymbals."""
    r, half, tom = draw(0.58, 0.66), draw(0.26, 0.32), draw(0.3, 0.35)
    side, z = draw(0.36, 0.42), r + 0.05
    high, reach, plate = draw(1.95, 2.15), draw(0.92, 1.04), draw(0.44, 0.52)
    floor, snare = draw(0.36, 0.4), draw(0.33, 0.38)
    up = 2 * z + 0.16

    def drum(radius: float, deep: float) -> tuple[Solid, Solid, Solid]:
        """Its shell, hoops and skins, upright about the origin."""
        hoop = tube((0, 0, deep - 0.1), (0, 0, deep + 0.03), radius + 0.055, 0.02)
        return (
            tube((0, 0, -deep), (0, 0, deep), radius),
            both(hoop, 2),
            both(tube((0, 0, 0), (0, 0, deep + 0.06), radius - 0.04, 0.02), 2),
        )

    bass = [tilted(solid, 90, (0, 0, z)) for solid in drum(r, half)]
    toms = [both(moved(turned(s, 0, 14), (side, 0.02, up + tom * 0.5))) for s in drum(tom, 0.2)]
    left = [moved(s, (-reach, 0.1, 0.86)) for s in drum(snare, 0.17)]
    right = [moved(s, (reach, 0.1, 0.46)) for s in drum(floor, 0.32)]
    x, y = reach + 0.02, 0.34 + 0.1
    dish = lathe([(0.0, -0.06), (plate, -0.06), (plate, 0.0), (0.16, 0.05), (0.14, 0.12),
                  (0.0, 0.15)], 0.02)  # fmt: skip
    cymbal = moved(turned(turned(dish, 1, -14), 0, 10), (x, y, high))
    feet = join(
        both(join(capsule((x, y, 0.08), (x, y, high + 0.12), 0.08),
                  capsule((x + 0.2, y + 0.22, 0.08), (x, y, 0.4), 0.08),
                  capsule((side * 0.7, 0.05, 2 * z - 0.14), (side, 0.05, up + 0.1), 0.1))),
        both(capsule((x, y, 0.3), (r * 0.5, half - 0.04, 0.4), 0.08)),
        tube((-reach, 0.1, 0.08), (-reach, 0.1, 0.8), 0.09),
        tube((-reach, 0.1, 0), (-reach, 0.1, 0.14), 0.24, 0.04),
        *(capsule((reach + floor * math.cos(a), 0.1 + floor * math.sin(a), 0.08),
                  (reach + floor * math.cos(a), 0.1 + floor * math.sin(a), 0.4), 0.085)
          for a in (0.5, 2.6, -1.57)),
        both(taper((r * 0.74, -half + 0.05, 0.4), (r + 0.06, -half - 0.1, 0.08), 0.08, 0.08)),
    )  # fmt: skip
    shells, hoops, skins = (join(*solids) for solids in zip(bass, toms, left, right, strict=True))
    badge = tube((0, -half - 0.11, z), (0, 0, z), r * draw(0.38, 0.46), 0.02)
    return {
        "shells": shells,
        "skins": skins,
        "hoops": hoops,
        "cymbals": both(cymbal),
        "stands": feet,
        "badge": badge,
    }


def flute(draw: Draw) -> Parts:
    """It lies across, its mouth plate to the left, oval keys along its top, joints of rings."""
    half, r = draw(1.25, 1.35), draw(0.046, 0.052)
    z, count = r + 0.03, 7
    mouth = -half * draw(0.66, 0.72)
    lean = draw(18, 30)
    first, last = -half * 0.28, half * 0.84
    oval = mirrored([(0.001, -0.054), (0.052, -0.042), (0.08, 0), (0.052, 0.042), (0.001, 0.054)])
    places = [first + (last - first) * k / (count - 1) for k in range(count)]
    keys = [moved(prism(oval, 2, 0.035), (x, 0, r + 0.012)) for x in places]
    cups = [box((x, 0.04, r - 0.012), (0.05, 0.045, 0.032), 0.02) for x in places]
    rod = capsule((first - 0.08, 0.07, r * 0.75), (last + 0.08, 0.07, r * 0.75), 0.034)
    joints = [-half * 0.42, -half + 0.07, half - 0.07]

    def lying(solid: Solid) -> Solid:
        return tilted(solid, lean, (0, 0, z))

    return {
        "body": lying(tube((-half, 0, 0), (half, 0, 0), r, 0.01)),
        "keys": lying(join(*keys)),
        "rods": lying(join(rod, *cups)),
        "rings": lying(join(*(tube((x - 0.08, 0, 0), (x + 0.08, 0, 0), r + 0.018, 0.01)
                              for x in joints))),
        "mouthpiece": lying(within(egg((mouth, 0, r * 0.6), (0.2, 0.074, 0.06)),
                                   box((mouth, 0, 1.01), (1, 1, 1)))),
        "hole": lying(egg((mouth, 0, r + 0.03), (0.085, 0.04, 0.045))),
    }  # fmt: skip


def harmonica(draw: Draw) -> Parts:
    """A comb with a row of square holes to the front, between two plates of metal."""
    x, y, half = draw(1.1, 1.24), draw(0.38, 0.46), 0.15
    plate, count = draw(0.18, 0.23), 7 + draw.which(2)
    z = plate + half
    curve = smooth_curve([(-y + 0.03, half - 0.02), (-y + 0.06, half + plate * 0.5),
                          (-y * 0.3, half + plate), (y * 0.4, half + plate),
                          (y - 0.06, half + plate * 0.55), (y - 0.03, half - 0.02)])  # fmt: skip
    ends = box((0, 0, 0), (x - 0.16, 1, 1))
    cover = both(within(prism(curve, 0, x), ends), 2)
    step = (2 * x - 0.5) / count
    places = [step * (k - (count - 1) / 2) for k in range(count)]
    holes = [box((u, -y - 0.1, 0), (step * 0.5 - 0.055, 0.16, 0.085)) for u in places]
    screw = tube((x - 0.1, 0.02, 0), (x - 0.1, 0.02, half + 0.055), 0.09, 0.02)
    comb = box((0, 0, 0), (x, y, half), 0.04)
    oval = egg((0, 0.02, half + plate), (x * draw(0.4, 0.5), y * 0.5, 0.055))
    return {
        "comb": moved(cut(comb, *holes), (0, 0, z)),
        "plates": moved(cover, (0, 0, z)),
        "holes": moved(join(*(box((u, -y + 0.1, 0), (step * 0.5 - 0.05, 0.07, 0.09))
                              for u in places)), (0, 0, z)),
        "screws": moved(both(screw, 0, 2), (0, 0, z)),
        "badge": moved(both(oval, 2), (0, 0, z)),
    }  # fmt: skip


def jack_o_lantern(draw: Draw) -> Parts:
    """A pumpkin of lobes with a face cut into its front, all alight from within."""
    wide, high, count = draw(0.5, 0.56), draw(0.68, 0.8), 10
    lobe = egg((wide * 0.85, 0, high), (wide, wide * 0.75, high))
    hull = join(around(count, lobe, 18), ball((0, 0, high), 0.5))
    lean, kind = draw(-0.14, 0.14), draw.which(3)
    eye, apart, z = draw(0.2, 0.24), draw(0.36, 0.42), high * 1.2
    eyes = [
        [(apart - eye, z - 0.13), (apart + eye, z - 0.13), (apart + 0.02, z + 0.25)],
        [(apart - eye, z - 0.16), (apart + eye, z - 0.06), (apart + eye, z + 0.26)],
        [(apart + eye * math.cos(a), z + 0.04 + 0.2 * math.sin(a))
         for a in (math.tau * k / 16 for k in range(16))],
    ][kind]  # fmt: skip
    nose = [(-0.15, high * 0.94 - 0.12), (0.15, high * 0.94 - 0.12), (0, high * 0.94 + 0.16)]
    w, low = draw(0.62, 0.7), high * 0.57
    grin = [(0.0, low + 0.02), (0.12, low + 0.02), (0.12, low + 0.16), (0.3, low + 0.16)]
    grin += [(0.3, low + 0.08), (w, low + 0.36), (w * 0.86, low + 0.0), (w * 0.62, low - 0.18)]
    grin += [(0.34, low - 0.25), (0.34, low - 0.1), (0.16, low - 0.1), (0.16, low - 0.28)]
    grin += [(0.0, low - 0.3)]

    def hole(outline: list[tuple[float, float]]) -> Solid:
        return prism(outline, 1, 1.0, -1.2)

    face = (both(hole(eyes)), hole(nose), hole(mirrored(grin)))
    turns = [math.pi * (k / 12 - 0.5) for k in range(13)]
    core = lathe([(wide * (0.85 + 0.74 * math.cos(a)), high * (1 + 0.9 * math.sin(a)))
                  for a in turns])  # fmt: skip
    stalk = limb([(0, 0, high * 1.75), (0.02, 0, high * 2 + 0.12), (lean, -0.05, high * 2 + 0.34)],
                 0.19, 0.12)  # fmt: skip
    root = taper((0, 0, high * 1.86), (0.26, 0, high * 1.9), 0.1, 0.09)
    return {
        "body": cut(hull, *face),
        "stalk": join(stalk, around(5, root)),
        **{name: within(core, grown(cutter, 0.03))
           for name, cutter in zip(("eyes", "nose", "mouth"), face, strict=True)},
    }  # fmt: skip


def christmas_bauble(draw: Draw) -> Parts:
    """A glass ball, or a drop, with a band and stars about it, a cap and a loop above."""
    r, drop = draw(0.82, 0.92), draw.chance(0.35)
    z, long = r, draw(0.5, 0.66)
    high, hull = 2 * r, ball((0, 0, z), r)
    if drop:
        z, high = r + long, 2 * r + long
        hull = join(ball((0, 0, z), r), taper((0, 0, z - r * 0.2), (0, 0, 0.1), r * 0.94, 0.1))
    half, count = draw(0.15, 0.2), 8
    a = math.radians(draw(34, 40))
    star = [((0.19 if k % 2 == 0 else 0.085) * math.cos(math.tau * k / 10 + math.pi / 2),
             (0.19 if k % 2 == 0 else 0.085) * math.sin(math.tau * k / 10 + math.pi / 2))
            for k in range(10)]  # fmt: skip
    mark = moved(turned(prism(star, 0, 0.1), 1, -math.degrees(a)),
                 (r * math.cos(a) - 0.05, 0, z + r * math.sin(a)))  # fmt: skip
    b = -a
    dot = ball((r * 0.98 * math.cos(b), 0, z + r * 0.98 * math.sin(b)), 0.11)
    shell = ball((0, 0, z), r + 0.045)
    top = high + 0.14
    flutes = around(8, capsule((0.25, 0, high - 0.08), (0.25, 0, top - 0.02), 0.06))
    edge = both(ring((0, 0, half), r * math.cos(math.asin(half / r)), 0.075), 2)
    return {
        "ball": hull,
        "band": within(shell, box((0, 0, z), (2, 2, half))),
        "edges": moved(edge, (0, 0, z)),
        "stars": around(count, mark),
        "dots": around(count, dot),
        "cap": join(
            tube((0, 0, high - 0.14), (0, 0, top), 0.27, 0.03),
            flutes,
            ring((0, 0, top + 0.17), 0.17, 0.075, axis=1),
        ),
    }


def wreath(draw: Draw) -> Parts:
    """Upright: a ring of pointed leaves, golden balls, berries in threes, a bow below or above."""
    major, minor, long = draw(0.82, 0.88), draw(0.25, 0.28), draw(0.36, 0.42)
    y = -major if draw.chance(0.6) else major
    low = -90 if y < 0 else 90

    def sprigs(count: int, up: float, thick: float, *tips: tuple[float, float]) -> Solid:
        """Pointed leaves, each to so far from the ring's middle line and over its plane."""
        step, leaves = math.tau / count, []
        for k in range(count):
            a = low / 180 * math.pi + step * (k + 0.5)
            root = (major * math.cos(a), major * math.sin(a), up)
            for out, high in tips:
                b, far = a + 0.34, major + out
                leaves.append(taper(root, (far * math.cos(b), far * math.sin(b), high), thick, 0.1))
        return join(*leaves)

    def spot(turn: float, out: float, up: float, radius: float) -> Solid:
        a = math.radians(low + turn)
        return ball(((major + out) * math.cos(a), (major + out) * math.sin(a), up), radius)

    def cluster(turn: float) -> Solid:
        trio = ((-9, -0.06), (9, -0.06), (0, 0.15))
        return join(*(spot(turn + da, out, minor + 0.02, 0.15) for da, out in trio))

    loop = smooth_curve([(0.0, 0.08), (0.3, 0.3), (0.58, 0.3), (0.68, 0.02), (0.56, -0.22),
                         (0.28, -0.18), (0.0, -0.08)])  # fmt: skip
    end = [(-0.06, 0.0), (0.12, 0.0), (0.52, -0.62), (0.34, -0.6), (0.22, -0.74)]
    bow = join(
        both(grown(prism(loop, 2, 0.1), 0.05)), both(grown(prism(end, 2, 0.06, -0.02), 0.04))
    )

    def facing(solid: Solid) -> Solid:
        return tilted(solid, 90, (0, 0, major + minor + 0.25))

    return {
        "leaves": facing(
            join(ring((0, 0, 0), major, minor), sprigs(16, 0.0, 0.2, (long, 0.0), (-0.34, 0.0)))
        ),
        "tips": facing(sprigs(8, minor - 0.08, 0.2, (0.2, minor), (-0.18, minor))),
        "berries": facing(join(*(cluster(turn) for turn in (-90, 90, 180)))),
        "baubles": facing(
            join(*(spot(turn, 0, minor + 0.02, 0.22) for turn in (-135, -45, 45, 135)))
        ),
        "bow": facing(moved(bow, (0, y, minor + 0.14))),
        "knot": facing(egg((0, y, minor + 0.22), (0.19, 0.17, 0.17))),
    }  # fmt: skip


def grenade(draw: Draw) -> Parts:
    """A pineapple grenade: rows of blocks, a fuse head, its lever down one side, a pin's ring."""
    r, high, rows = draw(0.66, 0.74), draw(1.55, 1.75), 4
    side = smooth_curve([(r * 0.5, 0.02), (r * 0.86, high * 0.2), (r, high * 0.45),
                         (r * 0.88, high * 0.74), (r * 0.46, high * 0.98)])  # fmt: skip
    shell = lathe(side, 0.07)
    gap, step = 0.065, high / rows
    slits = [box((0, 0, step * k), (2, 2, gap)) for k in range(1, rows)]
    grooves = around(8, box((r, 0, 0), (r * 0.8, gap, 4)), 22.5)
    top = high + 0.05
    head = join(
        tube((0, 0, top - 0.1), (0, 0, top + 0.16), 0.3, 0.03),
        tube((0, 0, top), (0, 0, top + 0.42), 0.21, 0.03),
        box((0.06, 0, top + 0.42), (0.3, 0.17, 0.12), 0.03),
    )
    out = r + 0.24
    strip = [(0.16, top + 0.5), (0.16, top + 0.66), (0.42, top + 0.62), (out, top + 0.02),
             (out + 0.06, high * 0.5), (out - 0.08, high * 0.32), (out - 0.16, high * 0.36),
             (out - 0.09, high * 0.5), (out - 0.14, top - 0.04), (0.36, top + 0.5)]  # fmt: skip
    loop, x = draw(0.25, 0.3), -0.2
    return {
        "body": lathe(side, 0.0),
        "blocks": cut(shell, *slits, grooves),
        "head": head,
        "lever": prism(strip, 1, 0.17),
        "ring": ring((x - loop - 0.14, 0, top + 0.26), loop, 0.08, axis=1),
        "pin": capsule((x - 0.12, 0, top + 0.34), (0.34, 0, top + 0.34), 0.09),
    }


def trident(draw: Draw) -> Parts:
    """Upright: three barbed prongs on a long shaft, its grip wound, a knob at its foot."""
    high, thick, wide = draw(2.85, 3.05), draw(0.05, 0.056), draw(0.26, 0.3)
    fork, tall, flat = draw(2.0, 2.12), draw(0.08, 0.16), 0.052
    low, tip = fork + 0.36, high - tall

    def point(x: float, top: float, barb: float) -> Solid:
        edge = [(x - barb, top - 0.42), (x, top), (x + barb, top - 0.42), (x + 0.045, top - 0.34)]
        return prism([*edge, (x - 0.045, top - 0.34)], 1, flat)

    bend = smooth_curve([(0.0, fork), (wide * 0.7, fork + 0.12), (wide, low), (wide, tip - 0.3)])
    outer = join(limb([(u, 0.0, v) for u, v in bend], 0.085, 0.044), point(wide, tip, 0.1))
    inner = join(taper((0, 0, fork), (0, 0, high - 0.3), 0.06, 0.048), point(0, high + 0.04, 0.11))
    grip = draw(0.8, 1.0)
    winds = [tube((0, 0, grip + 0.17 * k), (0, 0, grip + 0.17 * k + 0.1), thick + 0.026, 0.02)
             for k in range(4)]  # fmt: skip
    return {
        "head": join(both(outer), inner),
        "shaft": tube((0, 0, 0.1), (0, 0, fork), thick),
        "grip": join(tube((0, 0, grip - 0.05), (0, 0, grip + 0.66), thick + 0.012), *winds),
        "collar": join(
            lathe([(thick, fork - 0.36), (0.09, fork - 0.24), (0.07, fork - 0.12),
                   (0.1, fork - 0.02), (0.075, fork + 0.1)], 0.01),
            lathe([(0.04, 0.0), (0.085, 0.1), (0.085, 0.2), (0.06, 0.3)], 0.01),
        ),
        "gem": both(egg((0, 0.09, fork + 0.02), (0.07, 0.05, 0.12)), 1),
    }  # fmt: skip


def horseshoe(draw: Draw) -> Parts:
    """Upright, open above: a flat bow of iron with a groove and nails in either branch."""
    out, wide, deep = draw(0.92, 1.02), draw(0.36, 0.42), draw(0.14, 0.18)
    tall, pinch = draw(0.8, 0.96), draw(0.62, 0.72)
    z = out

    def branch(off: float) -> list[tuple[float, float]]:
        """The right half of a line within the bow, from its bottom to its heel."""
        r = out - off
        points = [(r * math.sin(a), z - r * math.cos(a)) for a in (0, 0.4, 0.8, 1.2, 1.6)]
        return smooth_curve([*points, (r - 0.08, z + tall * 0.5), (r - out + pinch, z + tall)], 3)

    outer, inner = branch(0.0), branch(wide)
    half = [*outer, *reversed(inner)]
    middle = branch(wide / 2)
    groove = limb([(u, 0.0, v) for u, v in middle[4:-2]], 0.095, 0.095)
    sides = both(both(moved(groove, (0, deep - 0.045, 0))), 1)
    nails = [box((u, 0, v), (0.085, deep + 0.1, 0.08), 0.02) for u, v in middle[6:-3:3]]
    x, top = middle[-1][0], z + tall - 0.02
    heel = tube((x, -deep - 0.04, top), (x, deep + 0.04, top), wide * 0.53, 0.03)
    clip = [(-0.22, -0.04), (0.22, -0.04), (0.12, 0.3), (-0.12, 0.3)]
    return {
        "shoe": both(prism(half, 1, deep)),
        "grooves": sides,
        "nails": both(join(*nails)),
        "heels": both(heel),
        "clip": moved(prism(clip, 1, deep + 0.08), (0, 0, 0.02)),
    }


FESTIVE = {
    "drum kit": drum_kit,
    "flute": flute,
    "harmonica": harmonica,
    "jack-o-lantern": jack_o_lantern,
    "christmas bauble": christmas_bauble,
    "wreath": wreath,
    "grenade": grenade,
    "trident": trident,
    "horseshoe": horseshoe,
}
