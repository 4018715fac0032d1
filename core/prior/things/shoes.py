"""Shoes, boots and a sock."""

import math

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
    ball,
    blend,
    both,
    box,
    capsule,
    chain,
    cut,
    grown,
    join,
    lathe,
    mirrored,
    moved,
    outlined,
    prism,
    smooth_curve,
    taper,
    tilted,
    tube,
    turned,
    within,
)


def sock(draw: Draw) -> Parts:
    """A long sock, its toe to the front; cuff, heel and toe of another colour."""
    r, foot, high = draw(0.36, 0.42), draw(0.85, 1.05), draw(1.45, 1.75)
    back, low = 0.42, draw(0.4, 0.44)
    small = r * 0.84
    toe = (0.0, back - foot, small - 0.02)
    ground = box((0, 0, -1), (3, 3, 1))
    shaft = lathe([(r * 0.96, low), (r, high)], 0.01, (0, back))
    sole = taper((0, back + 0.02, low), toe, r, small)
    hem = tube((0, back, high - 0.1), (0, back, high + 0.3), r + 0.1, 0.06)
    half = box((0, back + 1.04, low - 0.7), (1, 1, 1))
    return {
        "body": cut(blend(0.2, shaft, sole), ground),
        "cuff": cut(hem, tube((0, back, high + 0.1), (0, back, high + 1), r - 0.06)),
        "heel": cut(within(ball((0, back + 0.02, low), r + 0.045), half), ground),
        "toe": cut(taper((0, toe[1] + 0.12, toe[2] + 0.01), toe, small + 0.04, small + 0.04),
                   ground),
        "stripes": join(
            *(tube((0, back, high * v - 0.07), (0, back, high * v + 0.07), r + 0.045, 0.02)
              for v in (0.58, 0.76)),
        ),
    }  # fmt: skip


def sneaker(draw: Draw) -> Parts:
    """A sports shoe, its toe to the front."""
    long, wide, high, low = draw(1.0, 1.15), draw(0.4, 0.47), draw(0.85, 1.05), draw(0.18, 0.24)
    leg, toe = wide * 0.88, wide - long
    y, rise = long - leg, (high - 0.68) / (1.4 * long - leg)
    panel = [(-0.4 * long, 0.1), (y, 0.1), (y, high - 0.38), (-0.4 * long, 0.3)]
    laces = (
        capsule((-0.22, v, u), (0.22, v, u), 0.085)
        for v, u in ((y - k, wide * 0.8 + high - 0.4 - k * rise) for k in (0.35, 0.65, 0.95))
    )
    foot = capsule((0, -0.4 * long, 0.3), (0, y, high - 0.38), wide * 0.8)
    return {
        "body": cut(
            join(tube((0, y, 0.1), (0, y, high), leg), foot, prism(panel, 0, wide * 0.8)),
            tube((0, y, high - 0.3), (0, y, high + 1), leg - 0.14),
            box((0, 0, -0.9), (2, 3, 1)),
        ),
        "sole": join(
            tube((0, toe, 0), (0, toe, low), wide),
            tube((0, y, 0), (0, y, low), leg + 0.05),
            prism(mirrored([(wide, toe), (leg + 0.05, y)]), 2, low / 2, low / 2),
        ),
        "laces": join(*laces),
        "stripes": both(box((wide * 0.8, y - 0.36, 0.42), (0.08, 0.08, 0.2))),
        "toe": cut(ball((0, toe, 0.12), wide * 0.88), box((0, 0, -0.9), (2, 3, 1))),
    }


def boot(draw: Draw) -> Parts:
    """A leather boot: a round toe, a welted sole with a heel, a harness strap, a padded cuff."""
    long, wide, high, leg = draw(0.88, 1.0), draw(0.35, 0.39), draw(1.7, 1.95), draw(0.37, 0.42)
    back, low, toe = long - leg, draw(0.2, 0.26), wide - long
    ankle = (0, back - 0.02, 0.78)
    foot = chain([(ankle, leg * 0.9), ((0, -0.1, 0.42), wide), ((0, toe, low + 0.06), wide)])
    heel = chain([(ankle, leg * 0.9), ((0, back + 0.02, low + 0.08), leg * 0.9)])
    shaft = lathe([(leg * 0.9, 0.7), (leg * 0.94, 1.0), (leg, high)], 0, (0, back))
    hole = tube((0, back, high - 0.3), (0, back, high + 1), leg - 0.12)
    floor = box((0, 0, low - 1.02), (2, 2, 1))
    edge, rear = wide + 0.06, leg * 0.9 + 0.07
    plan = [(0.0, toe - edge), (edge * 0.72, toe - edge * 0.7), (edge, toe)]
    plan += [(edge * 0.94, -0.1), (rear * 0.92, back - 0.3), (rear, back + 0.02)]
    plan += [(rear * 0.7, back + 0.02 + rear * 0.7), (0.0, back + 0.02 + rear)]
    outline = mirrored(smooth_curve(plan, 3))
    arch = box((0, -0.01, 0), (2, 0.24, 0.1))
    band = tube((0, back, 0.68), (0, back, 0.86), leg * 0.9 + 0.06, 0.03)
    return {
        "body": cut(join(blend(0.12, foot, heel), shaft), hole, floor),
        "sole": cut(prism(outline, 2, low / 2, low / 2), arch),
        "cuff": cut(tube((0, back, high - 0.18), (0, back, high + 0.06), leg + 0.07, 0.07), hole),
        "strap": join(band, box((leg * 0.9 + 0.03, back, 0.77), (0.08, 0.12, 0.13), 0.05)),
    }


def high_heel(draw: Draw) -> Parts:
    """A lady's pump on a high heel, its pointed toe to the front; the heel is slim or a block."""
    long, wide, high = draw(1.0, 1.08), draw(0.37, 0.41), draw(0.78, 0.92)
    seat, front, slim = long - 0.34, -0.36 * long, wide * 0.86
    arch = smooth_curve([(-long, 0.16), (front, 0.16), (0.3 * long, high * 0.74)], 4)
    arch += [(seat - 0.1, high), (long + 0.1, high + 0.05)]
    rim = [(long + 0.1, high + 0.6), (seat, high + 0.43), (0.25 * long, high * 0.74 + 0.36)]
    rim = smooth_curve([*rim, (front * 0.55, 0.44), (front * 1.15, 0.62)], 4)
    foot = [((0, front, 0.24), wide), ((0, 0.3 * long, high * 0.74 + 0.22), slim)]
    foot += [((0, seat, high + 0.24), slim)]
    shell = chain([((0, 0.12 - long, 0.22), 0.12), *foot])
    room = [(v, z + 0.16) for v, z in arch if v >= front]
    hollow = within(
        chain(((0, v, z + 0.1), radius - 0.15) for (_, v, z), radius in foot),
        prism([*room, (long, 3), (front * 1.1, 3)], 0, 2),
    )
    under = [*arch[:-1], (seat + 0.1, high + 0.03)]
    plan = [(wide * 0.78, front), (slim * 0.62, 0.3 * long), (slim * 0.74, seat)]
    plan = [(0.06, 0.1 - long), *smooth_curve([*plan, (0.1, seat + slim * 0.7)], 3)]
    spike = [(0.11, 0), (0.1, high * 0.4), (0.14, high * 0.7), (0.22, high + 0.08)]
    block = [(0.2, 0), (0.19, high * 0.5), (0.23, high + 0.08)]
    bow = join(
        ball((0, 0, 0), 0.13),
        both(prism([(0.04, -0.07), (0.34, -0.18), (0.34, 0.18), (0.04, 0.07)], 1, 0.09)),
    )
    return {
        "body": cut(within(shell, prism([*arch, *rim, (-2, 0.62), (-2, 0.16)], 0, 2)), hollow),
        "heel": lathe(block if draw.chance(0.25) else spike, 0, (0, seat + 0.05)),
        "sole": outlined(
            [*((v, z + 0.04) for v, z in under), *((v, z - 0.16) for v, z in reversed(under))], plan
        ),
        "bow": tilted(bow, -60, (0, front * 1.2, 0.24 + wide * 0.92)),
    }


def sandal(draw: Draw) -> Parts:
    """A sole like a foot, toes to the front, under a thong or two broad straps."""
    long, wide, thick, kind = draw(0.98, 1.06), draw(0.42, 0.46), draw(0.28, 0.32), draw.which(2)
    side = [(0.0, -long), (wide * 0.76, -long * 0.86), (wide, -long * 0.46)]
    side += [(wide * 0.86, long * 0.1), (wide * 0.84, long * 0.6), (wide * 0.54, long * 0.92)]
    side += [(0.0, long)]
    curve = smooth_curve(side, 6)
    outline = [*curve, *((-u, v) for u, v in reversed(curve[1:-1]))]

    def slab(grow: float, low: float, high: float) -> Solid:
        half, soft = (high - low) / 2, 0.03
        shape = [(u * (1 + grow), v * (1 + grow * 0.5)) for u, v in outline]
        return grown(prism(shape, 2, half - soft, low + half), soft)

    top, level = thick + 0.07, thick * 0.5

    def arch(r: float, sunk: float) -> Solid:
        """A half pipe along the foot, its axis ``sunk`` below the sole's middle."""
        pipe = cut(
            tube((0, -1, level - sunk), (0, 1, level - sunk), r + 0.05),
            tube((0, -2, level - sunk), (0, 2, level - sunk), r - 0.05),
        )
        return cut(pipe, box((0, 0, level - 2), (2, 2, 2)))

    def strap(at: float, half: float, r: float) -> Solid:
        return within(arch(r, 0), box((0, at, 0), (2, half, 2)))

    if kind == 0:
        vee = [(0, -long * 0.66), (wide * 0.3, -long * 0.6), (wide * 1.3, -long * 0.04)]
        vee += [(wide * 1.3, long * 0.3), (wide * 0.9, long * 0.16), (0, -long * 0.36)]
        straps = within(arch(wide * 1.06, wide * 0.1), prism(mirrored(vee), 2, 2))
        crown = level + wide * 0.96 + 0.14
        buckles = tube((0, -long * 0.51, thick), (0, -long * 0.51, crown), 0.1, 0.03)
    else:
        straps = join(strap(-long * 0.5, 0.2, wide), strap(long * 0.12, 0.18, wide * 0.92))
        pin = box((0, 0, 0), (0.09, 0.14, 0.13), 0.03)
        slope = (math.cos(0.7), math.sin(0.7))
        buckles = join(
            *(
                moved(turned(pin, 1, -40), (r * slope[0], at, level + r * slope[1]))
                for at, r in ((-long * 0.5, wide + 0.05), (long * 0.12, wide * 0.92 + 0.05))
            )
        )
    return {
        "sole": slab(0.04, 0.0, thick),
        "footbed": slab(-0.06, 0.06, top),
        "straps": straps,
        "edges": slab(0.15, thick * 0.34, thick * 0.76),
        "buckles": buckles,
    }


SHOES = {
    "sock": sock,
    "sneaker": sneaker,
    "boot": boot,
    "high heel": high_heel,
    "sandal": sandal,
}
