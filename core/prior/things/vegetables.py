"""Vegetables."""

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    around,
    ball,
    blend,
    chain,
    egg,
    join,
    lathe,
    limb,
    moved,
    smooth_curve,
    taper,
    tube,
    turned,
)


def tomato(draw: Draw) -> Parts:
    """Squat and round, a green star about its stalk."""
    r, half, reach = draw(0.92, 1.05), draw(0.68, 0.8), draw(0.52, 0.66)
    width, stalk, droop = draw(0.12, 0.15), draw(0.24, 0.36), draw(0.0, 0.08)
    top = 2 * half
    leaf = taper((0.08, 0, top), (reach, 0, top - droop), width, 0.075)
    return {
        "body": egg((0, 0, half), (r, r, half)),
        "leaves": around(5, leaf, 18),
        "stalk": taper((0, 0, top - 0.1), (0, 0, top + stalk), 0.14, 0.1),
    }


def carrot(draw: Draw) -> Parts:
    """A root, tip down, with its greens."""
    wide, long = draw(0.36, 0.46), draw(1.6, 1.9)
    inner = taper((0.05, 0, long + 0.2), (0.2, 0, long + draw(0.95, 1.1)), 0.13, 0.12)
    outer = taper((0.1, 0, long + 0.2), (draw(0.6, 0.75), 0, long + draw(0.6, 0.75)), 0.12, 0.13)
    return {
        "body": taper((0, 0, 0), (0, 0, long), 0.08, wide),
        "leaves": join(around(3, inner), around(6, outer, 30)),
    }


def corn(draw: Draw) -> Parts:
    """A cob with rows of kernels in its husk, tip up."""
    wide, high = draw(0.36, 0.43), draw(2.1, 2.4)
    kernels = []
    for k in range(11):
        z = 0.5 + (high - 0.62) * k / 10
        radius = wide * min(1.0, 1.35 * (1 - (k / 11.5) ** 3))
        kernels.append(around(10, egg((radius, 0, z), (0.12, radius * 0.33, 0.12)), 18 * (k % 2)))
    cob = taper((0, 0, 0.4), (0, 0, high - 0.2), wide * 0.98, wide * 0.5)
    out, tip = draw(0.4, 0.75), draw(1.2, 1.55)
    husk = join(
        taper((0.1, 0, 0.1), (wide + 0.08, 0, 0.65), 0.2, 0.22),
        taper((wide + 0.08, 0, 0.65), (wide + out * 0.6, 0, tip), 0.22, 0.08),
    )
    return {
        "kernels": join(cob, *kernels),
        "husk": join(around(4, husk, 45), tube((0, 0, -0.15), (0, 0, 0.3), 0.2, 0.04)),
    }


def pumpkin(draw: Draw) -> Parts:
    """Lobes about a stalk."""
    wide, high, count = draw(0.5, 0.58), draw(0.6, 0.72), 8 + 2 * draw.chance(0.5)
    lobe = egg((wide * 0.85, 0, high), (wide, wide * 0.62, high))
    stalk = taper(
        (0, 0, high * 1.8), (draw(-0.15, 0.15), 0, high * 2 + draw(0.25, 0.4)), 0.17, 0.12
    )
    return {"body": join(around(count, lobe), ball((0, 0, high), 0.5)), "stalk": stalk}


def broccoli(draw: Draw) -> Parts:
    """A crown of florets on branches."""
    trunk, reach, top = draw(0.25, 0.32), draw(0.5, 0.6), draw(1.3, 1.5)
    count, size = 5 + draw.chance(0.5), draw(0.34, 0.4)
    branch = taper((0.05, 0, 0.45), (reach, 0, top - 0.25), trunk * 0.6, 0.16)
    tufts = [
        around(count, ball((reach, 0, top), size)),
        around(2 * count, ball((reach + 0.22, 0, top - 0.05), size * 0.55), 20),
        around(count, ball((reach * 0.75, 0, top + 0.3), size * 0.65), 180 / count),
        around(count, ball((reach * 0.3, 0, top + 0.42), size * 0.6)),
        ball((0, 0, top + 0.22), size * 1.15),
    ]
    return {
        "florets": join(*tufts),
        "stem": join(
            taper((0, 0, 0), (0, 0, top - 0.1), trunk, trunk * 0.9), around(count, branch)
        ),
    }


def eggplant(draw: Draw) -> Parts:
    """A drop, its cap and stalk above."""
    wide, high, lean = draw(0.5, 0.6), draw(1.7, 2.0), draw(-0.25, 0.25)
    neck = (lean, 0.0, high)
    body = blend(
        0.15,
        egg((0, 0, wide * 1.1), (wide, wide, wide * 1.15)),
        taper((0, 0, wide * 1.15), neck, wide * 0.92, wide * 0.5),
    )
    flap = taper((0.05, 0, wide * 0.42), (wide * 0.62, 0, -0.14), 0.14, 0.07)
    cap = join(egg((0, 0, wide * 0.28), (wide * 0.5, wide * 0.5, wide * 0.33)), around(5, flap))
    tip = (lean * 1.5 + 0.08, 0, high + wide * 0.5 + 0.4)
    return {
        "body": body,
        "cap": join(moved(cap, neck), taper((lean, 0, high + 0.2), tip, 0.13, 0.12)),
    }


def pepper(draw: Draw) -> Parts:
    """A bell pepper: three or four lobes about a stalk."""
    wide, high, count = draw(0.36, 0.42), draw(1.25, 1.6), 3 + draw.chance(0.6)
    lobe = taper((wide * 0.6, 0, wide * 0.75), (wide, 0, high - wide), wide * 0.72, wide * 1.05)
    top = high - 0.02
    return {
        "body": join(around(count, lobe, 45), taper((0, 0, 0.3), (0, 0, high - 0.35), 0.25, 0.4)),
        "stalk": join(
            taper((0, 0, top - 0.25), (draw(-0.15, 0.15), 0, top + 0.38), 0.13, 0.12),
            egg((0, 0, top - 0.08), (0.28, 0.28, 0.1)),
        ),
    }


def chili_pepper(draw: Draw) -> Parts:
    """Glossy red, bowed like a horn to a point, a green cap with a crooked stem."""
    bow, thick, long = draw(0.62, 0.7), draw(0.37, 0.4), draw(1.9, 2.0)
    girth = [0.86, 1.0, 1.0, 0.93, 0.82, 0.66, 0.46, 0.2]
    spine = [(k / 7, r * thick) for k, r in enumerate(girth)]
    pod = [((bow * (2.2 * t * t - 0.9 * t) - 0.2, 0, long * (1 - t) + 0.2 + 0.24 * t * t), r)
           for t, r in spine]  # fmt: skip
    top = long + 0.2
    lobe = taper((0.12, 0, top + 0.2), (thick * 0.98, 0, top - 0.16), 0.17, 0.1)
    cap = join(egg((0, 0, top + 0.17), (thick * 1.06, thick * 1.06, 0.22)), around(5, lobe, 18))
    return {
        "body": chain(pod),
        "cap": moved(cap, (-0.2, 0, 0)),
        "stem": limb(
            [(-0.2, 0, top + 0.26), (-0.24, 0, top + 0.56), (-0.44, 0, top + 0.8)], 0.13, 0.14
        ),
    }


def onion(draw: Draw) -> Parts:
    """A bulb that runs out in a tip, roots below."""
    wide, high = draw(0.78, 0.9), draw(1.35, 1.55)
    shape = [(0.1, 0.06), (wide * 0.6, 0.1), (wide, high * 0.45), (wide * 0.7, high * 0.8)]
    shape += [(0.24, high), (0.13, high + 0.2), (0.16, high + draw(0.35, 0.5))]
    root = taper((0.05, 0, 0.1), (0.22, 0, -0.12), 0.1, 0.06)
    rib = egg((wide * 0.3, 0, high * 0.45), (wide * 0.73, 0.34, high * 0.43))
    return {
        "body": join(lathe(smooth_curve(shape)), around(8, rib)),
        "roots": around(6, root),
    }


def garlic(draw: Draw) -> Parts:
    """A bulb of plump cloves about a dry neck, purple in its grooves, a disc of roots below."""
    r, high, neck = draw(0.5, 0.54), draw(0.62, 0.67), draw(0.19, 0.21)
    z = high + 0.08
    clove = join(
        egg((r, 0, z), (0.5, 0.34, high)),
        limb(
            [(r * 0.9, 0, z + high * 0.5), (r * 0.56, 0, z + high * 0.92),
             (0.16, 0, z + high * 1.3)],
            0.26, 0.12,
        ),
    )  # fmt: skip
    core = lathe(smooth_curve([(0.3, 0.1), (r * 1.46, z * 0.62), (r * 1.44, z * 1.2),
                               (0.4, z + high * 0.8), (0.16, z + high * 1.1)]))  # fmt: skip
    top = z + high * 1.1
    frond = egg((0, 0, 0.2), (0.1, 0.13, 0.26))
    return {
        "cloves": around(7, clove, -90),
        "grooves": core,
        "neck": join(
            lathe([(neck + 0.1, top - 0.1), (neck, top + 0.3), (neck, top + 0.62)], 0.02),
            around(4, moved(turned(frond, 1, 24), (0.1, 0, top + 0.42))),
        ),
        "roots": join(tube((0, 0, 0), (0, 0, 0.26), 0.46, 0.04),
                      around(8, ball((0.42, 0, 0.1), 0.11))),
    }  # fmt: skip


VEGETABLES = {
    "tomato": tomato,
    "carrot": carrot,
    "corn": corn,
    "pumpkin": pumpkin,
    "broccoli": broccoli,
    "eggplant": eggplant,
    "pepper": pepper,
    "chili pepper": chili_pepper,
    "onion": onion,
    "garlic": garlic,
}
