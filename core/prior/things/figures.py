"""More characters: figures of the winter feast, of fields, of wars to come, of legend."""

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    around,
    ball,
    both,
    box,
    capsule,
    cut,
    egg,
    join,
    lathe,
    mirrored,
    prism,
    smooth_curve,
    taper,
    tube,
)
from core.prior.things.animals import fitted
from core.prior.things.characters import cone, eyes, moustache


def santa(draw: Draw) -> Parts:
    """Stout, in a coat with fur at its edges, a hat that falls to the back, a round beard."""
    wide, head, leg = draw(0.52, 0.64), draw(0.34, 0.4), draw(0.36, 0.46)
    top, out = leg + draw(0.8, 0.92), draw(0.14, 0.26)
    z, y = top + head * 0.62, -head * 0.92
    hand = (wide + out, -0.16, top - 0.62)
    coat = lathe(
        smooth_curve([(wide * 0.94, leg - 0.08), (wide, leg + 0.25), (wide * 0.56, top)]), 0.03
    )
    sleeve = taper((wide * 0.7, 0, top - 0.18), hand, 0.2, 0.17)
    tall = z + head * 0.4 + draw(0.54, 0.7)
    tip = (0, 0.42, tall - 0.1)
    cuff = taper((wide + out * 0.66, -0.11, top - 0.48), (wide + out * 0.9, -0.15, top - 0.57),
                 0.2, 0.2)  # fmt: skip
    boot = join(
        tube((0.26, 0, 0.04), (0.26, 0, leg), 0.21, 0.03),
        egg((0.27, -0.16, 0.14), (0.21, 0.34, 0.15)),
    )
    belt = leg + 0.28
    return {
        "coat": join(
            coat,
            both(sleeve),
            lathe([(head + 0.02, z + 0.2), (0.14, tall)], 0.05),
            taper((0, 0.02, tall - 0.06), tip, 0.18, 0.12),
        ),
        "trim": join(
            tube((0, 0.03, z + 0.16), (0, 0.03, z + 0.36), head + 0.1, 0.09),
            ball(tip, 0.19),
            tube((0, 0, leg - 0.14), (0, 0, leg + 0.04), wide + 0.07, 0.07),
            both(cuff),
        ),
        "beard": join(
            egg((0, y + 0.06, z - 0.36), (head * 0.98, 0.24, 0.42)),
            moustache((0, y - 0.1, z - 0.13), 0.2),
        ),
        "skin": join(ball((0, 0, z), head), ball((0, y - 0.1, z), 0.12)),
        "boots": join(
            both(join(boot, ball(hand, 0.2))),
            tube((0, 0, belt - 0.1), (0, 0, belt + 0.1), wide + 0.06, 0.02),
        ),
        "eyes": eyes(0.16, y + 0.07, z + 0.03, 0.08),
    }


def scarecrow(draw: Draw) -> Parts:
    """On a post, its arms held out; a head of sacking, straw at its hands and hem, a hat."""
    head, reach, wide = draw(0.4, 0.46), draw(0.95, 1.08), draw(0.34, 0.42)
    low, top = draw(0.75, 0.9), draw(1.55, 1.68)
    z, arm, brim = top + head * 0.72, top - 0.24, draw(0.56, 0.64)
    y = -head * 0.9
    straw = lathe([(wide + 0.12, low - 0.26), (wide - 0.02, low + 0.1)], 0.03)
    hands = prism([(reach - 0.1, arm - 0.1), (reach - 0.1, arm + 0.1), (reach + 0.26, arm + 0.22),
                   (reach + 0.18, arm + 0.06), (reach + 0.32, arm), (reach + 0.18, arm - 0.06),
                   (reach + 0.26, arm - 0.22)], 1, 0.1)  # fmt: skip
    ruff = lathe([(head * 0.95, top - 0.1), (head * 0.5, top + 0.1)], 0.04)
    mouth = [(x, y + 0.09, z - 0.26 + abs(x) * 0.35) for x in (-0.18, 0.0, 0.18)]
    return {
        "shirt": join(
            lathe([(wide + 0.04, low), (wide * 0.8, top - 0.12), (0.2, top)], 0.03),
            tube((-reach, 0, arm), (reach, 0, arm), 0.18, 0.03),
        ),
        "sack": join(
            egg((0, 0, z), (head, head * 0.95, head * 1.02)), ball((0, y - 0.02, z - 0.03), 0.09)
        ),
        "straw": join(both(hands), straw, ruff),
        "hat": join(
            tube((0, 0.04, z + 0.25), (0, 0.04, z + 0.39), brim, 0.06),
            lathe([(head * 0.84, z + 0.3), (head * 0.56, z + 0.3 + draw(0.36, 0.5))], 0.05),
        ),
        "post": join(
            tube((0, 0, 0), (0, 0, low + 0.1), 0.12), tube((0, 0, 0), (0, 0, 0.13), 0.4, 0.04)
        ),
        "eyes": join(
            eyes(0.18, y + 0.05, z + 0.08, 0.095),
            capsule(mouth[0], mouth[1], 0.07),
            capsule(mouth[1], mouth[2], 0.07),
        ),
    }


def nutcracker(draw: Draw) -> Parts:
    """A soldier of wood: a tall hat, a square jaw with teeth, white hair, boots on a block."""
    wide, leg, hat = draw(0.38, 0.44), draw(0.7, 0.82), draw(0.5, 0.66)
    top, head = leg + 0.14 + draw(0.72, 0.82), draw(0.36, 0.41)
    z, x = top + head * 0.98, wide + 0.16
    brow = z + head * 0.86
    y = -head * 0.96
    arm = join(
        tube((x, 0, leg + 0.18), (x, 0, top - 0.02), 0.15, 0.04),
        box((x, 0, top), (0.15, 0.15, 0.1)),
    )
    boot = join(
        tube((0.21, 0, 0.16), (0.21, 0, leg * 0.62), 0.175, 0.02),
        box((0.21, -0.1, 0.24), (0.17, 0.28, 0.1), 0.05),
    )
    button = [tube((0.14, -wide - 0.03, v), (0.14, 0, v), 0.085)
              for v in (leg + 0.42, leg + 0.66)]  # fmt: skip
    return {
        "coat": join(
            tube((0, 0, leg + 0.06), (0, 0, top), wide, 0.04),
            both(arm),
            box((0, -0.02, 0.09), (0.56, 0.46, 0.09), 0.03),
        ),
        "hat": join(
            tube((0, 0, brow - 0.06), (0, 0, brow + hat), head + 0.04, 0.03),
            box((0, -head, brow - 0.04), (head * 0.85, 0.22, 0.07), 0.03),
            both(boot),
            eyes(0.17, y + 0.05, z + 0.1, 0.09),
            both(taper((0.05, y - 0.04, z - 0.13), (0.31, y + 0.06, z - 0.06), 0.09, 0.05)),
        ),
        "trousers": both(tube((0.21, 0, 0.2), (0.21, 0, leg + 0.12), 0.165)),
        "skin": join(
            tube((0, 0, top - 0.04), (0, 0, brow), head, 0.03),
            taper((0, y, z + 0.04), (0, y - 0.14, z), 0.09, 0.085),
            box((0, y + 0.06, z - 0.34), (0.25, 0.1, 0.06), 0.02),
            both(ball((x, -0.02, leg + 0.12), 0.16)),
        ),
        "hair": join(
            box((0, y + 0.02, z - 0.26), (0.2, 0.08, 0.07), 0.02),
            prism([(-0.24, z - 0.42), (0.24, z - 0.42), (0.14, z - 0.74), (-0.14, z - 0.74)], 1,
                  0.1, y),
            both(ball((head * 0.92, 0.04, z - 0.08), 0.18)),
            tube((0, 0.14, top), (0, 0.14, z + 0.12), head - 0.02, 0.06),
        ),
        "trim": join(
            tube((0, 0, brow + 0.04), (0, 0, brow + 0.17), head + 0.09, 0.03),
            box((0, -head - 0.02, brow + hat * 0.56), (0.12, 0.08, 0.14), 0.04),
            both(join(tube((x, 0, top - 0.06), (x, 0, top + 0.08), 0.22, 0.03), *button)),
            tube((0, 0, leg + 0.1), (0, 0, leg + 0.24), wide + 0.05, 0.02),
        ),
    }  # fmt: skip


def mech(draw: Draw) -> Parts:
    """A war machine of a few great blocks on dark joints: a cockpit, a crest, two cannons."""
    leg, wide, pad = draw(1.06, 1.12), draw(0.52, 0.56), draw(0.27, 0.29)
    top, a, deep = leg + draw(0.82, 0.88), 0.36, 0.36
    x, z = wide + pad + 0.12, top + 0.32
    shin = [(-0.26, 0.2), (0.28, 0.2), (0.2, leg - 0.2), (-0.2, leg - 0.2)]
    trunk = [(0.3, leg + 0.22), (wide, leg + 0.5), (wide, top)]
    fist = box((x, -0.12, top - 1.14), (0.16, 0.18, 0.16), 0.04)
    return {
        "armour": join(
            prism(mirrored(trunk), 1, deep),
            box((0, 0, leg - 0.02), (0.54, 0.27, 0.14), 0.03),
            both(join(
                prism(shin, 0, 0.22, a),
                box((a + 0.02, -0.14, 0.13), (0.26, 0.44, 0.13), 0.04),
                box((x, 0, top - 0.14), (pad, 0.34, 0.28), 0.05),
                box((x, -0.1, top - 0.8), (0.23, 0.29, 0.26), 0.04),
            )),
            box((0, -0.02, z), (0.27, 0.27, 0.23), 0.05),
        ),
        "joints": join(
            both(tube((a, 0, 0.2), (a, 0, leg), 0.15)),
            both(tube((x, -0.02, top - 0.9), (x, 0, top - 0.1), 0.15)),
            both(fist),
            tube((0, 0, leg), (0, 0, leg + 0.4), 0.26),
            tube((-x, 0, top - 0.16), (x, 0, top - 0.16), 0.17),
            tube((0, 0, top - 0.1), (0, 0, z), 0.17),
        ),
        "chest": prism([(-deep - 0.2, top - 0.34), (-deep - 0.1, top - 0.1), (0, top - 0.1),
                        (0, leg + 0.34), (-deep, leg + 0.34)], 0, 0.32),
        "visor": box((0, -0.3, z), (0.2, 0.09, 0.085), 0.02),
        "crest": both(prism([(0, z + 0.12), (0, z + 0.28), (0.42, z + 0.6), (0.5, z + 0.46),
                             (0.14, z + 0.12)], 1, 0.1, -0.28)),
        "cannons": both(tube((x, -0.62, top + 0.27), (x, 0.36, top + 0.27), 0.17, 0.03)),
    }  # fmt: skip


def yeti(draw: Draw) -> Parts:
    """A great hunched body of shaggy fur; long arms; a bare face, hands and feet; tusks."""
    wide, deep, reach = draw(0.58, 0.68), draw(0.44, 0.52), draw(0.22, 0.34)
    leg, head = draw(0.5, 0.62), draw(0.38, 0.45)
    top = leg + draw(1.0, 1.15)
    z, y = top + head * 0.36, -0.18
    hand = (wide + reach, -0.24, leg - 0.08)
    elbow = (wide + reach * 0.9, -0.12, leg + 0.42)
    tiers = []
    for k, v in enumerate((leg - 0.12, leg + 0.2, leg + 0.52)):
        wider = wide * (1.04 - 0.06 * k)
        notch = prism([(-0.15, v - 0.1), (0.15, v - 0.1), (0, v + 0.2)], 0, 0.35, wider)
        layer = lathe([(wider, v), (wide * 0.62, v + 0.5)], 0.04)
        tiers.append(cut(layer, around(8, notch, 22.5 * k)))
    arm = join(
        taper((wide * 0.72, 0, top - 0.22), elbow, 0.29, 0.23),
        lathe([(0.28, leg + 0.02), (0.2, leg + 0.46)], 0.03, (hand[0], -0.18)),
    )
    thigh = lathe([(0.32, 0.22), (0.24, leg + 0.2)], 0.03, (wide * 0.5, 0))
    face = y - head * 0.74
    foot = egg((wide * 0.54, -0.18, 0.13), (0.25, 0.4, 0.15))
    return {
        "fur": join(
            egg((0, 0, (leg + top) / 2), (wide, deep, (top - leg) * 0.62)),
            egg((0, y, z), (head, head * 0.92, head)),
            egg((0, y + 0.06, z + head * 0.6), (head * 0.7, head * 0.74, head * 0.72)),
            both(join(arm, thigh)),
            *tiers,
            capsule((-0.22, face - 0.08, z + 0.2), (0.22, face - 0.08, z + 0.2), 0.1),
        ),
        "face": join(
            egg((0, face + 0.1, z - 0.04), (head * 0.8, 0.22, head * 0.74)),
            both(join(ball(hand, 0.23), foot)),
            egg((0, face - 0.12, z - 0.02), (0.12, 0.09, 0.085)),
        ),
        "eyes": eyes(0.16, face - 0.1, z + 0.1, 0.09),
        "mouth": egg((0, face - 0.06, z - 0.18), (0.22, 0.12, 0.1)),
        "teeth": both(cone((0.13, face - 0.13, z - 0.24), 0.08, 0.15)),
    }


def mermaid(draw: Draw) -> Parts:
    """Upright on her flukes: a scaled tail, long hair, a top of shells."""
    waist, hip, head = draw(0.21, 0.26), draw(0.34, 0.4), draw(0.35, 0.41)
    low, long, span = draw(0.3, 0.38), draw(0.75, 0.9), draw(0.56, 0.7)
    belt = low + long
    top, out = belt + draw(0.56, 0.66), draw(0.12, 0.22)
    z, y = top + head * 0.92, -head * 0.92
    tail = smooth_curve([(0.15, low - 0.12), (0.2, low + long * 0.24), (hip, low + long * 0.74),
                         (waist + 0.07, belt)])  # fmt: skip
    fluke = prism([(0, low + 0.08), (0.3, low - 0.02), (span, low + 0.06), (span + 0.06, low - 0.1),
                   (span * 0.72, 0.02), (0.2, 0), (0, 0.1)], 1, 0.13)  # fmt: skip
    hand = (hip + out, -0.14, belt - 0.02)
    elbow = (hip + out + 0.08, 0.02, belt + 0.24)
    arm = join(
        taper((0.26, 0, top - 0.12), elbow, 0.13, 0.11), taper(elbow, hand, 0.11, 0.1),
        ball(hand, 0.14),
    )  # fmt: skip
    cap = cut(ball((0, 0.04, z + 0.05), head * 1.12), box((0, -0.68, z - 0.18), (2, 0.56, 0.38)))
    locks = join(
        egg((0, 0.2, z - 0.34), (head * 1.2, 0.24, head * 1.7)),
        both(taper((head * 0.86, 0.02, z - 0.1), (head * 0.84, -0.06, top - 0.3), 0.18, 0.12)),
    )
    return {
        "tail": lathe(tail, 0.02),
        "fins": join(
            both(fluke), lathe([(waist + 0.1, belt - 0.07), (waist + 0.1, belt + 0.07)], 0.03)
        ),
        "skin": join(
            lathe(smooth_curve([(waist, belt - 0.05), (waist, belt + 0.2), (0.29, top - 0.2),
                                (0.12, top)]), 0.02),
            tube((0, 0, top - 0.06), (0, 0, z), 0.13),
            ball((0, 0, z), head),
            both(arm),
            ball((0, y - 0.03, z - 0.05), 0.085),
        ),
        "hair": join(cap, locks),
        "top": both(egg((0.145, -0.2, top - 0.24), (0.16, 0.16, 0.14))),
        "eyes": both(egg((head * 0.42, -head * 0.88, z + 0.03), (0.07, 0.07, 0.1))),
    }  # fmt: skip


FIGURES = {
    "santa claus": fitted(santa),
    "scarecrow": fitted(scarecrow),
    "nutcracker": fitted(nutcracker),
    "mech": fitted(mech),
    "yeti": fitted(yeti),
    "mermaid": fitted(mermaid),
}
