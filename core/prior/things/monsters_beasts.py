"""Monsters that are beasts, objects or slime."""

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
    around,
    ball,
    blend,
    both,
    box,
    capsule,
    chain,
    cut,
    egg,
    join,
    lathe,
    limb,
    moved,
    prism,
    smooth_curve,
    taper,
    tilted,
    tube,
    turned,
    within,
)
from core.prior.things.shared.faces import cone, eyes
from core.prior.things.shared.fitted import fitted
from core.prior.things.shared.wings_and_claws import front_toes, hooked_bill


def minotaur(draw: Draw) -> Parts:
    """A bull's head with great horns on a mighty man with hooves; a double axe."""
    wide, leg, head = draw(0.62, 0.67), draw(0.64, 0.7), draw(0.44, 0.47)
    top = leg + draw(0.76, 0.82)
    z, y = top + 0.26, -0.2
    face, mouth = y - head - 0.1, z - 0.24
    x, front, hold = wide + 0.4, -0.36, leg + 0.2
    arm = taper((wide * 0.98, 0, top - 0.2), (x, front, hold), 0.28, 0.2)
    shank = taper((wide * 0.5, 0, leg), (wide * 0.56, 0, 0.2), 0.3, 0.2)
    horn = [
        ((head * 0.7, y, z + head * 0.56), 0.17),
        ((head * 1.6, y, z + head * 0.66), 0.15),
        ((head * 1.95, y - 0.06, z + head * 1.1), 0.12),
        ((head * 1.95, y - 0.12, z + head * 1.6), 0.07),
    ]
    mid = leg + 0.92
    blade = [(x, mid + 0.12), (x + 0.36, mid + 0.38), (x + 0.46, mid), (x + 0.36, mid - 0.38)]
    blade += [(x, mid - 0.12)]
    halves = (blade, [(2 * x - a, b) for a, b in blade])
    flap = [(-0.3, leg + 0.1), (0.3, leg + 0.1), (0.24, leg - 0.36), (-0.24, leg - 0.36)]
    return {
        "body": join(
            taper((0, 0, top - 0.26), (0, 0, leg + 0.06), 0.44, 0.36),
            both(egg((wide * 0.46, -0.12, top - 0.28), (wide * 0.54, 0.38, 0.32))),
            both(arm),
            both(ball((x, front, hold), 0.24)),
        ),
        "fur": join(
            ball((0, y, z), head),
            both(taper((head * 0.8, y + 0.06, z), (head * 1.55, y, z - 0.12), 0.14, 0.1)),
            egg((0, 0.2, top), (wide * 0.76, 0.36, 0.36)),
            both(shank),
            both(ball((0.15, face - 0.17, mouth + 0.08), 0.09)),
        ),
        "horns": join(
            both(chain(horn)),
            both(lathe([(0.27, 0), (0.22, 0.24)], 0.02, (wide * 0.56, 0.0))),
            egg((0, face + 0.06, mouth), (0.35, 0.28, 0.26)),
        ),
        "loincloth": join(
            tube((0, 0, leg - 0.04), (0, 0, leg + 0.2), 0.5, 0.03),
            both(prism(flap, 1, 0.1, 0.44), 1),
            tube((x, front, 0.1), (x, front, mid + 0.44), 0.09),
        ),
        "axe": join(*(prism(half, 1, 0.1, front) for half in halves)),
        "eyes": both(ball((head * 0.46, y - head * 0.78, z + head * 0.36), 0.13)),
    }


def griffin(draw: Draw) -> Parts:
    """A lion's body and tail, an eagle's head, chest and claws; raised wings."""
    wide, long, leg = draw(0.36, 0.42), draw(0.66, 0.78), draw(0.62, 0.74)
    z, head, lift = leg + 0.26, draw(0.32, 0.37), draw(0.95, 1.15)
    y, up = -long - 0.32, z + draw(0.6, 0.7)
    hind = chain(
        [
            ((wide * 0.7, long * 0.8, z - 0.05), 0.3),
            ((wide * 0.75, long * 0.98, 0.42), 0.17),
            ((wide * 0.75, long * 0.86, 0.16), 0.15),
        ]
    )
    fore = taper((wide * 0.66, -long * 0.74, z), (wide * 0.7, -long * 0.9, 0.36), 0.25, 0.17)
    vane = [
        (-long * 0.7, z),
        (-long * 0.62, z + lift * 0.75),
        (0.0, z + lift + 0.1),
        (long + 0.42, z + lift),
    ]
    vane += [
        (long + 0.3, z + lift * 0.72),
        (long * 0.9, z + lift * 0.7),
        (long * 0.82, z + lift * 0.44),
        (long * 0.4, z + lift * 0.4),
        (0.12, z),
    ]
    wing = moved(turned(prism(vane, 0, 0.1), 1, 24), (wide * 0.66 - z * 0.42, 0, 0.08))
    tail = [(0, long, z + 0.1), (0, long + 0.5, z - 0.06), (0, long + 0.72, z + 0.36)]
    ear = taper(
        (head * 0.6, y + 0.1, up + head * 0.7),
        (head * 0.85, y + 0.22, up + head * 1.45),
        0.13,
        0.075,
    )
    foot = both(
        join(
            taper((wide * 0.7, -long * 0.9, 0.4), (wide * 0.7, -long * 0.95, 0.13), 0.14, 0.12),
            front_toes(wide * 0.7, -long * 0.9, 0.3, 0.095),
        )
    )
    return {
        "body": join(
            blend(
                0.15, egg((0, 0.1, z), (wide, long, wide)), ball((0, long * 0.7, z), wide * 0.95)
            ),
            both(join(hind, egg((wide * 0.75, long * 0.72, 0.12), (0.18, 0.3, 0.13)))),
            limb(tail, 0.1, 0.09),
        ),
        "feathers": join(
            blend(
                0.1,
                ball((0, y, up), head),
                taper(
                    (0, y + 0.06, up - 0.1), (0, -long * 0.7, z + 0.06), head * 0.86, wide + 0.06
                ),
            ),
            both(join(ear, fore)),
        ),
        "wings": both(wing),
        "bill": join(hooked_bill((0, y - head * 0.76, up - 0.02), 0.18, 0.22), foot),
        "tuft": taper(tail[-1], (0, long + 0.76, z + 0.56), 0.19, 0.1),
        "eyes": eyes(head * 0.72, y - head * 0.6, up + 0.1, 0.09),
    }


def gargoyle(draw: Draw) -> Parts:
    """Crouching on a block: knees up, arms between its feet, folded bat wings, a horned head."""
    wide, top = draw(0.6, 0.68), 0.42
    chest, head, peak = draw(1.3, 1.38), draw(1.72, 1.8), draw(2.62, 2.76)
    y, z = -0.44, head
    knee, foot = (wide + 0.04, -0.42, 1.02), (wide, -0.38, top + 0.12)
    leg = join(
        taper((0.28, 0.3, 0.74), knee, 0.3, 0.19),
        taper(knee, foot, 0.18, 0.14),
        egg((wide, -0.54, top + 0.08), (0.19, 0.32, 0.15)),
    )
    arm = limb([(0.4, -0.16, chest), (0.32, -0.5, 0.94), (0.22, -0.66, top + 0.1)], 0.19, 0.13)
    paw = egg((0.22, -0.73, top + 0.06), (0.14, 0.2, 0.12))
    outline = [(0.1, 0.7), (0.1, 1.5), (0.44, peak - 0.26), (0.6, peak), (0.76, peak - 0.1),
               (1.12, 1.8), (1.2, 0.96), (1.04, 0.9), (0.86, 1.2), (0.74, 0.66), (0.58, 0.6),
               (0.42, 0.9), (0.3, 0.62)]  # fmt: skip
    bone = limb([(0.14, 0, 1.2), (0.54, 0, peak - 0.1), (1.1, 0, 1.78)], 0.14, 0.11)
    wing = join(prism(outline, 1, 0.09), bone)
    ear = prism([(0.2, z + 0.14), (0.66, z + 0.36), (0.28, z - 0.16)], 1, 0.1, y + 0.1)
    snout = prism([(y + 0.1, z + 0.14), (y - 0.3, z + 0.06), (y - 0.54, z + 0.08),
                   (y - 0.66, z - 0.04), (y - 0.62, z - 0.2), (y, z - 0.2)], 0, 0.2)  # fmt: skip
    jaw = prism([(y + 0.1, z - 0.1), (y - 0.18, z - 0.28), (y - 0.52, z - 0.42),
                 (y - 0.5, z - 0.58), (y - 0.1, z - 0.5), (y + 0.2, z - 0.3)], 0, 0.17)  # fmt: skip
    brow = taper((0.06, y - 0.32, z + 0.12), (0.34, y - 0.14, z + 0.3), 0.13, 0.1)
    fang = taper((0.16, y - 0.48, z - 0.16), (0.15, y - 0.43, z - 0.42), 0.09, 0.07)
    bend = [(0.17, 0.06, 0.22), (0.27, 0.13, 0.4), (0.33, 0.12, 0.56), (0.34, 0.03, 0.72),
            (0.31, -0.09, 0.84)]  # fmt: skip
    horn = limb([(u, y + v, z + w) for u, v, w in bend], 0.15, 0.09)
    return {
        "body": join(
            blend(0.12, taper((0, 0.24, 0.82), (0, -0.1, chest), 0.42, 0.38),
                  taper((0, -0.1, chest), (0, y + 0.1, z - 0.14), 0.3, 0.24)),
            both(join(leg, arm, paw)),
        ),
        "wings": both(moved(turned(wing, 2, 16), (0.06, 0.3, 0))),
        "head": join(egg((0, y, z), (0.36, 0.36, 0.34)), snout, jaw, both(join(ear, brow, fang))),
        "horns": both(horn),
        "base": join(
            box((0, 0, 0.1), (0.98, 1.04, 0.1), 0.02), box((0, 0, 0.25), (0.86, 0.92, 0.19), 0.02)
        ),
        "eyes": both(ball((0.23, y - 0.27, z + 0.06), 0.11)),
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


def werewolf(draw: Draw) -> Parts:
    """An upright wolf with a man's broad chest, long clawed arms, in torn trousers."""
    wide, leg, head = draw(0.56, 0.61), draw(0.78, 0.84), draw(0.37, 0.4)
    top = leg + draw(0.72, 0.78)
    z, y = top + 0.26, -0.26
    hand = (wide + 0.44, -0.4, leg + 0.12)
    arm = chain([((wide * 0.92, 0, top - 0.16), 0.25), ((wide + 0.38, 0.08, leg + 0.42), 0.19),
                 (hand, 0.19)])  # fmt: skip
    thigh = (wide * 0.48, -0.06, leg)
    knee, heel = (wide * 0.58, -0.2, leg * 0.52), (wide * 0.58, 0.12, 0.3)
    paw = egg((wide * 0.6, -0.16, 0.13), (0.21, 0.34, 0.14))
    shank = join(taper(knee, heel, 0.2, 0.14), taper(heel, (wide * 0.6, -0.02, 0.14), 0.14, 0.14),
                 paw)  # fmt: skip
    x, front, low = hand
    claws = [taper((x + u, front - 0.12, low - 0.08), (x + u * 1.5, front - 0.22, low - 0.3), 0.09,
                   0.06) for u in (-0.14, 0.14)]  # fmt: skip
    toes = [taper((wide * 0.6 + u, -0.44, 0.1), (wide * 0.6 + u, -0.6, 0.07), 0.09, 0.065)
            for u in (-0.12, 0.12)]  # fmt: skip
    tears = around(6, prism([(-0.15, leg * 0.3), (0.15, leg * 0.3), (0, leg * 0.62)], 0, 1), 15)
    cuff = cut(lathe([(0.29, leg * 0.4), (0.3, leg * 0.8)], 0.03), tears)
    face = y - head * 0.8
    snout = prism([(face + 0.2, z + 0.14), (face - 0.16, z + 0.1), (face - 0.5, z + 0.02),
                   (face - 0.52, z - 0.14), (face - 0.1, z - 0.2), (face + 0.2, z - 0.2)],
                  0, 0.16)  # fmt: skip
    jaw = taper((0, face + 0.14, z - 0.3), (0, face - 0.34, z - 0.38), 0.15, 0.1)
    fang = taper((0.14, face - 0.4, z - 0.1), (0.14, face - 0.4, z - 0.3), 0.085, 0.05)
    ear = prism([(head * 0.22, z + head * 0.6), (head * 1.02, z + head * 0.3),
                 (head * 0.9, z + head + 0.18)], 1, 0.1, y + 0.06)  # fmt: skip
    ruff = both(
        taper((head * 0.6, y + 0.04, z - 0.1), (head * 1.35, y + 0.1, z - 0.32), 0.22, 0.08)
    )
    tail = limb([(0, 0.3, leg + 0.05), (0, 0.66, leg - 0.1), (0, 0.86, leg - 0.4)], 0.17, 0.1)
    torso = blend(0.14, taper((0, 0, leg + 0.1), (0, 0, leg + 0.3), 0.36, 0.4),
                  egg((0, 0, top - 0.3), (wide, 0.46, 0.42)))  # fmt: skip
    return {
        "fur": join(
            torso, ball((0, y, z), head), taper((0, 0.1, top - 0.2), (0, y, z), 0.42, head * 0.9),
            both(join(arm, shank, ear)), ruff, tail,
        ),
        "muzzle": join(snout, jaw, egg((0, -0.2, top - 0.36), (wide * 0.6, 0.34, 0.36))),
        "trousers": join(
            lathe([(0.42, leg - 0.16), (0.44, leg + 0.14)], 0.04),
            both(join(taper(thigh, (knee[0], knee[1], knee[2] + 0.12), 0.29, 0.26),
                      moved(cuff, (knee[0], knee[1] + 0.04, 0.06)))),
        ),
        "claws": both(join(*claws, *toes, fang)),
        "eyes": both(ball((head * 0.46, face + 0.04, z + 0.16), 0.1)),
        "nose": ball((0, face - 0.52, z + 0.02), 0.12),
    }  # fmt: skip


def monster(draw: Draw) -> Parts:
    """A round furry fellow with horns, two big eyes, a wide toothy grin, waving arms."""
    wide, z = draw(0.8, 0.84), draw(1.16, 1.2)
    grin = z - 0.14
    shaggy = [around(9, taper((wide * k, 0, z + v), (wide * k * 1.08 + 0.08, 0, z + v - 0.22),
                              0.17, 0.06), turn)
              for k, v, turn in ((0.82, -0.4, 10), (0.95, 0.02, 30), (0.8, 0.46, 10))]  # fmt: skip
    tuft = [taper((u, 0, z + wide * 0.94), (u * 2.4, 0.02, z + wide + t), 0.15, 0.06)
            for u, t in ((0.0, 0.36), (0.14, 0.26))]  # fmt: skip
    smile = [(-0.5, grin + 0.12), (0.5, grin + 0.12), (0.42, grin - 0.16), (0.2, grin - 0.32),
             (-0.2, grin - 0.32), (-0.42, grin - 0.16)]  # fmt: skip
    mouth = within(ball((0, 0, z), wide + 0.06), prism(smile, 1, 1, -1.1))
    teeth = [prism([(u - 0.12, grin + 0.16), (u + 0.12, grin + 0.16), (u, grin - 0.15)], 1, 1, -1.1)
             for u in (0.13, 0.37)]  # fmt: skip
    horn = limb([(wide * 0.5, 0, z + wide * 0.72), (wide * 0.84, 0, z + wide * 1.02),
                 (wide * 0.86, -0.04, z + wide * 1.4)], 0.2, 0.07)  # fmt: skip
    hand = (wide + 0.5, -0.22, z + 0.32)
    return {
        "fur": join(
            ball((0, 0, z), wide), *shaggy, both(join(*tuft)),
            both(join(
                chain([((wide * 0.86, 0, z - 0.12), 0.2), ((wide + 0.36, -0.06, z - 0.12), 0.19),
                       (hand, 0.18)]),
                taper((0.36, 0, z - wide * 0.7), (0.38, -0.02, 0.24), 0.27, 0.24),
            )),
        ),
        "paws": join(
            both(egg((0.4, -0.16, 0.16), (0.3, 0.42, 0.18))),
            both(ball((hand[0], hand[1], hand[2] + 0.1), 0.23)),
        ),
        "horns": both(horn),
        "mouth": mouth,
        "teeth": within(ball((0, 0, z), wide + 0.13), both(join(*teeth))),
        "eyes": both(ball((0.25, -wide * 0.82, z + 0.4), 0.26)),
        "pupils": both(ball((0.22, -wide * 0.82 - 0.2, z + 0.4), 0.12)),
    }  # fmt: skip


def slime(draw: Draw) -> Parts:
    """A blob of jelly that runs up to a curled tip, a puddle of drips about its foot, big eyes and
    a smile."""
    r, high = draw(1.0, 1.06), draw(1.66, 1.76)
    side = [(r * 0.9, 0.0), (r, 0.28), (r * 0.98, 0.6), (r * 0.78, 1.1), (r * 0.42, high - 0.2),
            (0.12, high)]  # fmt: skip
    curl = limb([(0, 0, high - 0.4), (0.02, 0, high), (0.1, 0, high + 0.26),
                 (0.26, 0, high + 0.4)], 0.42, 0.11)  # fmt: skip
    z, x, y = 0.84, draw(0.36, 0.4), -r * 0.84
    smile = [(u, -r - 0.01 + 0.36 * u * u, 0.32 + 0.5 * u * u)
             for u in (-0.44, -0.22, 0, 0.22, 0.44)]  # fmt: skip
    return {
        "body": blend(0.16, lathe(smooth_curve(side, 6)), curl),
        "drips": join(
            around(8, egg((r * 0.96, 0, 0.1), (0.36, 0.3, 0.15)), 22.5),
            tube((0, 0, 0), (0, 0, 0.2), r, 0.08),
        ),
        "eyes": both(egg((x, y, z), (0.28, 0.22, 0.34))),
        "pupils": both(egg((x - 0.03, y - 0.15, z - 0.02), (0.16, 0.14, 0.22))),
        "mouth": limb(smile, 0.1, 0.1),
        "glints": join(
            egg((-r * 0.54, -r * 0.3, 1.22), (0.13, 0.12, 0.17)),
            both(ball((x + 0.04, y - 0.26, z + 0.11), 0.085)),
        ),
    }


def mimic(draw: Draw) -> Parts:
    """A treasure chest whose lid is a gaping mouth: rows of teeth, a long tongue, eyes on it."""
    x, y, low = draw(1.0, 1.08), draw(0.66, 0.72), draw(0.7, 0.76)
    angle, at, wall = draw(-46, -42), (0.0, y - 0.02, low - 0.02), 0.16

    def lidded(solid: Solid) -> Solid:
        """What is made as on a closed lid whose hinge is the origin, opened."""
        return tilted(solid, angle, at)

    def barrel(half: float, radius: float) -> Solid:
        return within(tube((-half, -y, 0), (half, -y, 0), radius, 0.02), box((0, 0, 1), (2, 3, 1)))

    lid = cut(barrel(x, y), barrel(x - wall, y - wall))
    hollow = box((0, 0, low + 0.3), (x - wall, y - wall, low))
    gums = join(
        box((0, 0, low * 0.66), (x - 0.1, y - 0.1, 0.1)),
        lidded(moved(barrel(x - 0.1, y - 0.1), (0, 0, 0.06))),
    )
    stops = [x * k for k in (-0.8, -0.4, 0, 0.4, 0.8)]
    fang = taper((0, 0, -0.06), (0, 0, 0.24), 0.165, 0.08)
    lower = [moved(fang, (u, -y + 0.1, low)) for u in stops if abs(u) > 0.1]
    upper = [moved(turned(fang, 0, 180), (u, -2 * y + 0.1, 0.02)) for u in stops]
    tongue = [(0, 0.2, low - 0.06), (0, -y + 0.1, low + 0.16), (0, -y - 0.26, low - 0.06),
              (0, -y - 0.36, 0.42), (0, -y - 0.52, 0.14)]  # fmt: skip
    band = join(*(moved(barrel(0.11, y + 0.07), (u, 0, 0)) for u in (-x * 0.66, x * 0.66)))
    look = both(egg((x * 0.34, -2 * y + 0.3, y * 0.92), (0.25, 0.25, 0.25)))
    slit = both(egg((x * 0.34, -2 * y + 0.1, y * 0.96), (0.09, 0.1, 0.17)))
    return {
        "body": join(cut(box((0, 0, low / 2), (x, y, low / 2), 0.02), hollow), lidded(lid)),
        "bands": join(
            both(cut(box((x * 0.66, 0, low / 2), (0.11, y + 0.07, low / 2)), hollow)),
            lidded(cut(band, barrel(3, y - 0.04))),
        ),
        "teeth": join(*lower, lidded(join(*upper))),
        "tongue": limb(tongue, 0.2, 0.25),
        "eyes": lidded(look),
        "mouth": join(gums, lidded(slit)),
    }


MONSTERS_BEASTS = {
    "minotaur": minotaur,
    "griffin": fitted(griffin),
    "gargoyle": fitted(gargoyle),
    "yeti": fitted(yeti),
    "werewolf": fitted(werewolf),
    "monster": monster,
    "slime": slime,
    "mimic": mimic,
}
