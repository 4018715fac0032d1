"""Characters of tales, feasts and games: sturdy figures with large heads."""

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
    Vector,
    ball,
    both,
    box,
    capsule,
    cut,
    egg,
    join,
    lathe,
    limb,
    prism,
    ring,
    smooth_curve,
    taper,
    tube,
)
from core.prior.things.animals import fitted


def eyes(apart: float, y: float, z: float, radius: float = 0.095) -> Solid:
    """A pair of round eyes."""
    return both(ball((apart, y, z), radius))


def cone(low: Vector, radius: float, high: float) -> Solid:
    """A pointed cone of height ``high`` that stands at ``low``."""
    x, y, z = low
    return lathe([(radius - 0.04, z), (0.02, z + high)], 0.04, (x, y))


def moustache(at: Vector, reach: float) -> Solid:
    """Two tufts under a nose at ``at``."""
    x, y, z = at
    return both(capsule((x + 0.08, y, z), (x + reach + 0.06, y + 0.08, z - 0.07), 0.1))


def _beard(at: Vector, radius: float, long: float) -> Solid:
    """A cone that hangs from the chin."""
    x, y, z = at
    profile = [(0.03, z - long), (radius * 0.72, z - long * 0.42), (radius, z)]
    return lathe(smooth_curve(profile), 0.04, (x, y))


def goblin(draw: Draw) -> Parts:
    """A wide head with long ears and a long nose; tusks; a short tunic."""
    head, leg, wide = draw(0.48, 0.56), draw(0.45, 0.58), draw(0.36, 0.44)
    ear, nose = draw(0.42, 0.56), draw(0.26, 0.36)
    top = leg + draw(0.66, 0.78)
    z = top + head * 0.62
    hand = (wide + 0.26, -0.12, leg + 0.02)
    arm = join(taper((wide * 0.7, 0, top - 0.16), hand, 0.14, 0.12), ball(hand, 0.17))
    legs = join(
        taper((0.2, 0, leg + 0.1), (0.22, 0, 0.14), 0.15, 0.13),
        egg((0.24, -0.13, 0.12), (0.19, 0.32, 0.13)),
    )
    ears = taper((head * 0.8, 0, z + 0.02), (head + ear, 0.1, z + ear * 0.6), 0.22, 0.06)
    skull = egg((0, 0, z), (head, head * 0.85, head * 0.8))
    y = -head * 0.74
    return {
        "skin": join(
            skull,
            both(join(ears, arm, legs)),
            taper((0, y - 0.02, z + 0.04), (0, y - nose, z - 0.06), 0.13, 0.09),
        ),
        "tunic": lathe([(wide + 0.1, leg - 0.06), (wide * 0.72, top - 0.05)], 0.04),
        "eyes": eyes(0.24, y + 0.02, z + 0.14, 0.15),
        "pupils": both(ball((0.23, y - 0.1, z + 0.14), 0.085)),
        "mouth": egg((0, y + 0.08, z - 0.22), (0.34, 0.16, 0.09)),
        "teeth": both(cone((0.25, y + 0.02, z - 0.28), 0.085, 0.19)),
    }


def golem(draw: Draw) -> Parts:
    """Of blocks of stone: a broad chest, a small head, great fists; its eyes and core glow."""
    wide, leg, fist = draw(0.6, 0.72), draw(0.5, 0.64), draw(0.25, 0.31)
    top, deep = leg + draw(0.92, 1.06), draw(0.36, 0.44)
    head, x = draw(0.27, 0.33), wide + 0.2
    z = top + head * 0.7
    chest = [
        (wide * 0.62, leg + 0.22), (wide, top - 0.5), (wide, top - 0.1), (wide - 0.14, top),
    ]  # fmt: skip
    limbs = join(
        box((x, 0, top - 0.2), (0.25, 0.3, 0.26), 0.05),
        box((x + 0.05, -0.08, top - 0.92), (fist, fist, 0.34), 0.05),
        box((wide * 0.52, 0, leg * 0.5), (0.24, 0.27, leg * 0.5), 0.05),
    )
    joints = join(
        box((0, 0, leg + 0.12), (wide * 0.5, deep * 0.7, 0.22)),
        both(tube((x, -0.02, top - 0.7), (x, 0, top - 0.3), 0.16)),
        tube((0, 0, top - 0.1), (0, 0, z), head * 0.7),
    )
    moss = join(
        egg((x - 0.04, 0, top + 0.05), (0.28, 0.31, 0.11)),
        egg((wide * 0.52, -0.22, 0.08), (0.24, 0.14, 0.11)),
    )
    return {
        "body": prism([*chest, *((-u, v) for u, v in reversed(chest))], 1, deep),
        "head": box((0, -0.12, z), (head, head * 0.95, head * 0.85), 0.06),
        "limbs": both(limbs),
        "joints": joints,
        "eyes": join(
            both(box((head * 0.45, -0.12 - head * 0.95, z + 0.02), (0.085, 0.06, 0.07), 0.02)),
            prism([(0, leg + 0.36), (0.17, leg + 0.56), (0, leg + 0.76), (-0.17, leg + 0.56)], 1,
                  deep + 0.07),
        ),
        "moss": both(moss),
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
            _beard((0, face + 0.14, z - 0.14), head * 0.82, beard),
        ),
        "skin": join(ball((0, 0, z), head), ball((0, face - 0.1, z - 0.06), 0.15),
                     both(ball(hand, 0.19))),
        "boots": join(both(shoe), lathe([(wide + 0.04, 0.4), (wide + 0.04, 0.56)], 0.01)),
        "eyes": eyes(0.18, face + 0.05, z + 0.1, 0.095),
    }  # fmt: skip


def skeleton(draw: Draw) -> Parts:
    """A large skull on few thick bones, the chest dark between the ribs."""
    head, leg, wide = draw(0.44, 0.52), draw(0.72, 0.82), draw(0.36, 0.42)
    top, out = leg + draw(0.96, 1.06), draw(0.2, 0.3)
    z, x = top + head * 1.02, wide + 0.12
    elbow, hand = (x + out * 0.6, 0, top - 0.42), (x + out, -0.16, leg)
    side = join(
        capsule((0, 0, top - 0.06), (x, 0, top - 0.06), 0.12),
        capsule((x, 0, top - 0.06), elbow, 0.11),
        capsule(elbow, hand, 0.11),
        ball(hand, 0.17),
        capsule((0.22, 0, leg), (0.22, 0, 0.12), 0.12),
        capsule((0.22, 0, 0.12), (0.22, -0.3, 0.12), 0.13),
    )
    return {
        "bone": join(
            ball((0, 0, z), head),
            box((0, -head * 0.42, z - head * 0.8), (head * 0.5, head * 0.42, 0.2)),
            tube((0, 0, leg), (0, 0, z), 0.14),
            both(side),
            *(ring((0, 0, top - 0.34 * k), wide - 0.06 * k, 0.11) for k in (1, 2)),
            capsule((-0.2, 0, leg), (0.2, 0, leg), 0.19),
        ),
        "chest": lathe([(wide - 0.14, leg + 0.14), (wide - 0.02, top - 0.08)]),
        "eyes": join(
            both(ball((head * 0.42, -head * 0.76, z + 0.02), head * 0.28)),
            prism([(-0.11, z - 0.3), (0.11, z - 0.3), (0, z - 0.1)], 1, 0.1, -head * 0.9),
        ),
    }


def wizard(draw: Draw) -> Parts:
    """A long robe with wide sleeves, a tall brimmed hat, a long beard, a staff."""
    wide, top, hat = draw(0.5, 0.62), draw(1.25, 1.4), draw(0.85, 1.1)
    head, beard = draw(0.33, 0.38), draw(0.7, 0.88)
    z, brim, reach = top + head * 0.7, draw(0.56, 0.66), draw(0.62, 0.72)
    robe = lathe(smooth_curve([(wide, 0), (wide * 0.72, 0.5), (0.3, top)]), 0.03)
    hand = (reach, -0.28, top - 0.48)
    sleeve = taper((0.26, 0, top - 0.16), (reach - 0.06, -0.22, top - 0.44), 0.14, 0.21)
    y = -head * 0.9
    staff_top = z + hat * 0.55
    return {
        "robe": join(robe, both(sleeve)),
        "hat": join(
            tube((0, 0.04, z + 0.22), (0, 0.04, z + 0.36), brim, 0.06),
            lathe([(head, z + 0.3), (head * 0.45, z + hat * 0.62), (0.02, z + 0.26 + hat)], 0.05),
        ),
        "beard": join(
            moustache((0, y - 0.06, z - 0.14), 0.2),
            _beard((0, y + 0.12, z - 0.14), head * 0.8, beard),
        ),
        "skin": join(
            ball((0, 0, z), head), ball((0, y - 0.08, z - 0.02), 0.12), both(ball(hand, 0.16))
        ),
        "staff": join(
            tube((reach, -0.34, 0), (reach, -0.34, staff_top), 0.09, 0.02),
            ball((reach, -0.34, staff_top + 0.06), 0.19),
        ),
        "eyes": eyes(0.17, y + 0.05, z + 0.06, 0.09),
    }


def _wing(draw: Draw, low: float, tips: list[Vector]) -> Solid:
    """A right wing behind the back, of the tips (x, z above ``low``, notch after it)."""
    span, lift = draw(0.92, 1.08), draw(0.92, 1.08)
    corners = [(0.05, low), (0.05, low + 0.55)]
    for u, v, notch in tips:
        corners.append((u * span, low + v * lift))
        corners.append(((u - notch) * span, low + (v + notch * 0.5) * lift))
    return prism(corners[:-1], 1, 0.085, 0.34)


def angel(draw: Draw) -> Parts:
    """A long robe, feathered wings, a halo, hands folded."""
    wide, top, head = draw(0.5, 0.6), draw(1.15, 1.3), draw(0.36, 0.42)
    z = top + head * 0.75
    halo, high = draw(0.3, 0.36), z + head + draw(0.18, 0.26)
    y = -head * 0.92
    sleeve = taper((0.3, 0, top - 0.16), (0.1, -0.4, top - 0.44), 0.15, 0.15)
    cap = cut(ball((0, 0.04, z + 0.05), head * 1.1), box((0, -0.66, z - 0.16), (2, 0.56, 0.36)))
    curls = egg((0, 0.14, z - 0.2), (head * 1.12, 0.26, head))
    feathers = [(0.42, 1.0, 0), (0.85, 1.25, 0), (1.15, 1.1, 0), (1.25, 0.62, 0.26),
                (1.02, 0.26, 0.26), (0.66, -0.06, 0.2)]  # fmt: skip
    return {
        "robe": join(
            lathe(smooth_curve([(wide, 0), (wide * 0.66, 0.55), (0.3, top)]), 0.03), both(sleeve)
        ),
        "wings": both(
            join(_wing(draw, top - 0.6, feathers), box((0, 0.3, top - 0.3), (0.2, 0.12, 0.26)))
        ),
        "skin": join(ball((0, 0, z), head), egg((0, -0.46, top - 0.4), (0.13, 0.14, 0.19)),
                     ball((0, y - 0.04, z - 0.04), 0.085)),
        "hair": join(cap, curls),
        "halo": join(
            ring((0, 0, high), halo, 0.09), tube((0, halo, high), (0, halo * 0.7, z + 0.2), 0.085)
        ),
        "eyes": eyes(head * 0.42, -head * 0.86, z + 0.03, 0.085),
    }  # fmt: skip


def demon(draw: Draw) -> Parts:
    """Red, with horns, bat wings, hooves and a tail that ends in a point."""
    leg, wide, head = draw(0.58, 0.7), draw(0.34, 0.42), draw(0.38, 0.45)
    top, horn, out = leg + draw(0.62, 0.74), draw(0.5, 0.68), draw(0.16, 0.3)
    z, x = top + head * 0.8, wide + 0.06
    hand = (x + out, -0.16, top - 0.62)
    arm = join(taper((x, 0, top - 0.14), hand, 0.16, 0.13), ball(hand, 0.17))
    tail = limb([(0, 0.2, leg), (0, 0.66, leg * 0.5), (0, 0.98, leg * 0.8), (0, 1.02, leg + 0.3)],
                0.12, 0.09)  # fmt: skip
    dart = lathe([(0.18, leg + 0.24), (0.02, leg + 0.62)], 0.04, (0, 1.02))
    curl = limb(
        [
            (head * 0.5, 0, z + head * 0.7),
            (head * 1.1, -0.02, z + head * 0.75 + horn * 0.3),
            (head * 0.9, -0.06, z + head * 0.7 + horn),
        ],
        0.16,
        0.05,
    )
    ribs = [(0.5, 1.05, 0), (0.95, 1.5, 0), (1.25, 0.75, 0.3), (1.0, 0.3, 0.3), (0.62, 0.0, 0.26)]
    y = -head * 0.92
    shank = taper((wide * 0.55, 0, leg + 0.05), (wide * 0.6, 0.02, 0.2), 0.2, 0.14)
    return {
        "skin": join(
            taper((0, 0, leg), (0, 0, top - 0.16), wide * 0.8, wide),
            ball((0, 0, z), head),
            both(join(arm, shank)),
            tail,
        ),
        "horns": both(curl),
        "wings": both(
            join(_wing(draw, top - 0.55, ribs), box((0, 0.3, top - 0.25), (0.2, 0.12, 0.24)))
        ),
        "hooves": join(
            both(box((wide * 0.62, -0.06, 0.13), (0.19, 0.26, 0.13), 0.06)),
            dart,
            tube((0, 0, leg - 0.08), (0, 0, leg + 0.14), wide * 0.86 + 0.04, 0.04),
        ),
        "eyes": eyes(head * 0.42, y + 0.08, z + 0.08, 0.1),
        "mouth": capsule((-0.15, y + 0.06, z - 0.14), (0.15, y + 0.06, z - 0.14), 0.085),
    }


CHARACTERS = {
    "goblin": fitted(goblin),
    "golem": fitted(golem),
    "gnome": fitted(gnome),
    "skeleton": fitted(skeleton),
    "wizard": fitted(wizard),
    "angel": fitted(angel),
    "demon": fitted(demon),
}
