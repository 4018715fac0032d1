"""Gnomes, elves, Santa Claus, and figures made of wood, straw or steel."""

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    around,
    ball,
    blend,
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
from core.prior.things.shared.faces import eyes, moustache, pointed_beard
from core.prior.things.shared.figure import Figure, figure
from core.prior.things.shared.fitted import fitted


def elf(draw: Draw) -> Parts:
    """A helper at the feast: long ears, a pointed hat with a bobble, a collar of points."""
    f = figure(draw)
    r, tall = f.head, draw(0.62, 0.86)
    lean = draw(0.1, 0.3)
    ear = taper((r * 0.86, 0, f.z - 0.02), (r + draw(0.3, 0.42), 0.06, f.z + 0.24), 0.14, 0.06)
    points = around(
        6,
        prism([(-0.22, f.top + 0.02), (0.22, f.top + 0.02), (0, f.top - 0.4)], 0, f.wide * 1.04),
        0,
    )
    collar = cut(points, tube((0, 0, f.top - 0.6), (0, 0, f.top - 0.1), f.wide * 0.72))
    skirt = lathe([(f.wide * 1.14, f.leg - 0.02), (f.wide * 0.84, f.leg + 0.34)], 0.05)
    top = f.z + r * 0.62 + tall
    hat = taper((0, 0.02, f.z + r * 0.62), (lean, 0.06, top), r * 0.82, 0.1)
    x = f.wide * 0.5
    shoe = join(
        egg((x, -0.16, 0.12), (0.2, 0.36, 0.14)),
        taper((x, -0.38, 0.13), (x, -0.54, 0.3), 0.12, 0.08),
    )
    return {
        "tunic": join(f.trunk(), skirt, f.sleeves()),
        "hat": hat,
        "skin": join(f.skull(), both(ear), f.hands()),
        "trim": join(
            tube((0, 0.02, f.z + r * 0.4), (0, 0.02, f.z + r * 0.76), r * 1.06, 0.08),
            ball((lean, 0.06, top), 0.18),
            collar,
            tube((0, 0, f.leg + 0.24), (0, 0, f.leg + 0.42), f.wide * 0.93, 0.03),
        ),
        "shoes": join(both(shoe), f.legs(-0.01)),
        "eyes": f.eyes(),
    }


def dwarf(draw: Draw) -> Parts:
    """Short and stout: a braided beard to the belt, an iron helmet, an axe, heavy boots."""
    leg, wide, head = draw(0.4, 0.43), draw(0.52, 0.56), draw(0.43, 0.46)
    top = leg + draw(0.76, 0.8)
    f = Figure(leg, wide, top, head, (wide + 0.36, -0.3, leg + 0.28))
    r, w, z, (x, y, _) = f.head, f.wide, f.z, f.hand
    brow, belt = z + r * 0.46, leg + 0.08
    dome = cut(ball((0, 0.02, z + 0.04), r * 1.18), box((0, 0, brow - 1), (2, 2, 1)))
    ridge = cut(tube((-0.09, 0.02, z + 0.04), (0.09, 0.02, z + 0.04), r * 1.29, 0.03),
                box((0, 0, brow - 1), (2, 2, 1)))  # fmt: skip
    beard = blend(
        0.08,
        egg((0, -r * 0.62, z - r * 0.66), (r * 0.9, r * 0.6, r * 0.62)),
        taper((0, -w * 0.78, top - 0.1), (0, -w * 1.06, belt + 0.46), 0.34, 0.22),
    )
    plaits = both(taper((0.17, -w * 1.02, belt + 0.56), (0.19, -w * 1.12, belt + 0.1), 0.16, 0.13))
    knobs = both(ball((0.19, -w * 1.14, belt - 0.06), 0.16))
    blade = [(-0.1, 0.16), (-0.42, 0.4), (-0.52, 0.02), (-0.42, -0.36), (-0.1, -0.12)]
    wings = [*blade, *((-u, v) for u, v in reversed(blade))]
    axe = prism([(x + u, z + 0.06 + v) for u, v in smooth_curve(wings)], 1, 0.1, y)
    return {
        "tunic": join(
            lathe([(w * 1.06, leg - 0.1), (w * 1.0, belt + 0.1), (w * 1.02, top - 0.24),
                   (w * 0.6, top)], 0.04),
            both(taper((w * 0.86, 0, top - 0.22), f.hand, 0.25, 0.2)),
        ),
        "beard": join(beard, plaits,
                      both(taper((0.12, -r * 1.02, z - r * 0.36), (0.42, -r * 0.86, z - r * 0.62),
                                 0.15, 0.1)),
                      both(egg((r * 0.84, -0.02, z - r * 0.36), (0.18, 0.28, 0.38)))),
        "helmet": join(dome, tube((0, 0.02, brow - 0.06), (0, 0.02, brow + 0.12), r * 1.26, 0.04),
                       axe),
        "gold": join(
            box((0, -r * 1.2, brow + 0.02), (0.11, 0.12, 0.17), 0.04), ridge,
            knobs, both(ball((r * 1.18, 0.02, brow + 0.04), 0.14)),
        ),
        "skin": join(ball((0, 0, z), r), egg((0, -r * 1.04, z - r * 0.12), (0.15, 0.15, 0.12))),
        "boots": join(
            tube((0, 0, belt - 0.08), (0, 0, belt + 0.12), w * 1.12, 0.03),
            both(join(egg((w * 0.56, -0.14, 0.15), (0.25, 0.38, 0.17)),
                      tube((w * 0.54, 0, 0.06), (w * 0.54, 0, leg + 0.02), 0.23, 0.04),
                      ball(f.hand, 0.23))),
        ),
        "handle": tube((x, y, 0.14), (x, y, z + 0.34), 0.09, 0.02),
        "eyes": both(ball((r * 0.44, -r * 0.9, z + 0.04), 0.1)),
    }  # fmt: skip


def gnome(draw: Draw) -> Parts:
    """Round and small, with a tall pointed hat and a great beard."""
    wide, hat, head = draw(0.44, 0.54), draw(0.95, 1.25), draw(0.36, 0.42)
    top, beard = draw(1.02, 1.14), draw(0.55, 0.7)
    z = top + head * 0.55
    hand = (wide + 0.12, -0.24, top - 0.62)
    arm = taper((wide * 0.72, 0, top - 0.14), hand, 0.17, 0.15)
    shoe = join(
        tube((0.24, 0, 0.06), (0.24, 0, 0.34), 0.19, 0.04),
        egg((0.25, -0.18, 0.14), (0.19, 0.32, 0.15)),
    )
    body = lathe(smooth_curve([(wide * 0.9, 0.26), (wide, 0.5), (wide * 0.62, top)]), 0.02)
    face = -head * 0.95
    return {
        "coat": join(body, both(arm)),
        "hat": join(
            lathe([(head, z + 0.3), (0.02, z + 0.3 + hat)], 0.05),
            tube((0, 0.04, z + 0.24), (0, 0.04, z + 0.36), head + 0.04, 0.05),
        ),
        "beard": join(
            moustache((0, face - 0.06, z - 0.14), 0.2),
            pointed_beard((0, face + 0.14, z - 0.14), head * 0.82, beard),
        ),
        "skin": join(ball((0, 0, z), head), ball((0, face - 0.1, z - 0.06), 0.15),
                     both(ball(hand, 0.19))),
        "boots": join(both(shoe), lathe([(wide + 0.04, 0.4), (wide + 0.04, 0.56)], 0.01)),
        "eyes": eyes(0.18, face + 0.05, z + 0.1, 0.095),
    }  # fmt: skip


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


FAIRY_TALE_FOLK_GNOMES_AND_PUPPETS = {
    "elf": elf,
    "dwarf": dwarf,
    "gnome": fitted(gnome),
    "santa claus": fitted(santa),
    "scarecrow": fitted(scarecrow),
    "nutcracker": fitted(nutcracker),
    "mech": fitted(mech),
}
