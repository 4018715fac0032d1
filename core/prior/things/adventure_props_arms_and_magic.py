"""Adventure props: weapons, lights, books, potions and what a wizard uses."""

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
    grown,
    join,
    lathe,
    lozenge_blade,
    mirrored,
    moved,
    prism,
    ring,
    smooth_curve,
    taper,
    tube,
    turned,
    within,
)


def sword(draw: Draw) -> Parts:
    """Point up: a slender blade with a ridge, a guard, a grip, a pommel."""
    low, high, wide = draw(0.6, 0.7), draw(2.2, 2.6), draw(0.12, 0.145)
    return {
        "blade": lozenge_blade(0, high, wide, 0.07, wide * draw(2.4, 3.2), 0.85),
        "guard": box((0, 0, 0), (draw(0.38, 0.48), 0.085, 0.09)),
        "grip": tube((0, 0, -low), (0, 0, 0), 0.062),
        "pommel": ball((0, 0, -low - 0.05), draw(0.11, 0.13)),
    }


def dagger(draw: Draw) -> Parts:
    """A short broad blade."""
    low, high, wide = draw(0.46, 0.54), draw(1.1, 1.35), draw(0.14, 0.17)
    return {
        "blade": lozenge_blade(0, high, wide, 0.09, wide * draw(2.4, 3.2), 0.85),
        "guard": box((0, 0, 0), (draw(0.32, 0.38), 0.1, 0.085)),
        "grip": tube((0, 0, -low), (0, 0, 0), 0.08),
        "pommel": ball((0, 0, -low - 0.05), draw(0.12, 0.14)),
    }


def _round_shield(wide: float, boss: float) -> Parts:
    """Domed boards in a thick ring, a boss on a flange between four straps; its front to -Y."""
    bow = [0.2 * (1 - (k / 8) ** 2) for k in range(9)]
    inner = [(wide * k / 8, v) for k, v in enumerate(bow)]
    outer = [(u, v + 0.18) for u, v in reversed(inner)]
    strap = [(-wide, 0.19), (-wide, -0.19), (0, -0.1), (wide, -0.19), (wide, 0.19), (0, 0.1)]
    turns = [math.radians(9 * k) for k in range(11)]
    dome = [(boss * math.cos(a), 0.44 + 0.3 * math.sin(a)) for a in turns]
    cover = lathe([(0, 0.3), (wide * 0.7, 0.2), (wide * 0.7, 0.3), (boss, 0.46), (0, 0.47)])

    def faced(solid: Solid) -> Solid:
        return moved(turned(solid, 0, 90), (0, 0, wide))

    straps = within(cover, join(prism(strap, 2, 1), turned(prism(strap, 2, 1), 2, 90)))
    return {
        "plate": faced(lathe([*inner, *outer])),
        "rim": faced(ring((0, 0, 0.08), wide - 0.02, 0.14)),
        "emblem": faced(
            join(
                lathe([(boss, 0.28), *dome]),
                lathe([(boss + 0.13, 0.26), (boss + 0.11, 0.48)]),
                straps,
            )
        ),
    }


def shield(draw: Draw) -> Parts:
    """A heater shield, bent about the arm, with a cross; or a round one, domed, with a boss."""
    high, wide = draw(0.5, 0.62), draw(0.82, 0.9)
    if draw.chance(0.3):
        return _round_shield(wide + 0.1, draw(0.28, 0.33))
    low = wide * math.sqrt(3)  # where the two arcs about the other side's end begin
    arcs = [math.radians(7.5 * k) for k in range(9)]
    side = [(wide * (2 * math.cos(a) - 1), low - 2 * wide * math.sin(a)) for a in arcs]
    plate = prism(mirrored([(wide, low + high), *side]), 1, 2)
    c, arm, up = low + high - 0.72, draw(0.13, 0.15), wide * 0.45
    flare = [(arm, arm), (arm * 1.7, up), (-arm * 1.7, up), (-arm, arm), (-up, arm * 1.7),
             (-up, -arm * 1.7), (-arm, -arm), (-arm * 1.7, -up * 1.6), (arm * 1.7, -up * 1.6),
             (arm, -arm), (up, -arm * 1.7), (up, arm * 1.7)]  # fmt: skip

    def bent(region: Solid, inner: float, outer: float) -> Solid:
        """What of a sheet about the vertical behind the shield lies in the region."""
        tubes = (tube((0, 1.6, -1), (0, 1.6, 4), r) for r in (outer, inner))
        return within(cut(*tubes), within(region, box((0, -1, 0), (4, 2.6, 4))))

    return {
        "plate": bent(plate, 1.56, 1.74),
        "rim": bent(cut(grown(plate, 0.03), grown(plate, -0.15)), 1.49, 1.83),
        "emblem": bent(prism([(u, v + c) for u, v in flare], 1, 2), 1.64, 1.86),
    }


def arrow(draw: Draw) -> Parts:
    """Point up, feathers below."""
    high = draw(2.2, 2.5)
    head = prism([(-0.14, high), (0.14, high), (0, high + 0.5)], 1, 0.05)
    feather = prism([(0.0, 0.1), (0.18, 0.0), (0.18, 0.5), (0.0, 0.72)], 1, 0.04)
    return {
        "head": head,
        "shaft": capsule((0, 0, 0.1), (0, 0, high + 0.1), 0.052),
        "feathers": around(4, feather),
    }


def pistol(draw: Draw) -> Parts:
    """Upright, its muzzle to the left."""
    long, y, high, grip = draw(1.15, 1.3), draw(0.15, 0.18), draw(0.17, 0.2), draw(0.85, 1.0)
    z, lean, wide = grip + 0.32, draw(0.22, 0.32), draw(0.24, 0.28)
    x = 0.75  # the grip's front edge at its top
    butt = [(x - wide * 0.6, z), (x + wide * 1.5, z), (x + wide * 1.5 + lean, 0.05)]
    butt += [(x + wide * 1.3 + lean, 0), (x - wide * 0.5 + lean, 0)]
    guard = [(x - 0.62, z - 0.1), (x - 0.56, z - 0.56), (x + 0.14, z - 0.56), (x + 0.14, z - 0.1)]
    inner = [(x - 0.47, z - 0.14), (x - 0.43, z - 0.41), (x + 0.02, z - 0.41), (x + 0.02, z - 0.14)]
    top = z + 0.12 + 2 * high
    slide = join(
        box((x + 0.4 - long, 0, z + 0.1 + high), (long, y, high), 0.04),
        box((x + 0.48 - 2 * long, 0, top), (0.09, 0.08, 0.09), 0.02),
        box((x + 0.26, 0, top), (0.1, y * 0.8, 0.09), 0.02),
    )
    bore = x + 0.4 - 2 * long
    return {
        "barrel": cut(
            slide, tube((bore - 1, 0, z + 0.14 + high), (bore + 0.3, 0, z + 0.14 + high), 0.09)
        ),
        "frame": join(
            box((x + 0.36 - long * 0.86, 0, z), (long * 0.86, y * 0.9, 0.14), 0.03),
            cut(prism(guard, 1, 0.1), prism(inner, 1, 1)),
            taper((x + 0.3, 0, z + 0.24), (x + 0.5, 0, z + 0.4), 0.14, 0.1),
        ),
        "grip": prism(butt, 1, y * 1.06),
        "trigger": taper((x - 0.17, 0, z - 0.08), (x - 0.2, 0, z - 0.26), 0.085, 0.08),
    }


def cannon(draw: Draw) -> Parts:
    """A barrel to the front on a carriage with two wheels."""
    long, r = draw(1.2, 1.4), draw(0.26, 0.32)
    body = join(
        taper((0, 0.75, 0.72), (0, -long, 0.95), r * 1.25, r * 0.85), ball((0, 1.0, 0.7), 0.16)
    )
    muzzle = ring((0, -long - 0.1, 0.96), r * 0.72, 0.12, 1)
    body = cut(join(body, muzzle), tube((0, -3, 1.25), (0, -long + 0.3, 0.94), r * 0.5))
    wheel = join(tube((0.42, 0, 0.5), (0.6, 0, 0.5), draw(0.48, 0.55), 0.03))
    return {
        "barrel": body,
        "carriage": join(
            box((0, 0.3, 0.42), (0.3, 0.7, 0.16), 0.03), tube((-0.5, 0, 0.5), (0.5, 0, 0.5), 0.12)
        ),
        "wheels": both(cut(wheel, tube((0, 0, 0.5), (2, 0, 0.5), 0.0001 + 0.12))),
    }


def bomb(draw: Draw) -> Parts:
    """A round bomb with a fuse."""
    r = draw(0.78, 0.9)
    return {
        "body": ball((0, 0, r), r),
        "cap": tube((0, 0, 1.9 * r), (0, 0, 2 * r + draw(0.12, 0.2)), draw(0.26, 0.32), 0.02),
        "fuse": join(
            capsule((0, 0, 2 * r), (0.12, 0, 2 * r + 0.4), 0.09),
            capsule((0.12, 0, 2 * r + 0.4), (0.38, 0, 2 * r + 0.5), 0.09),
        ),
        "spark": ball((0.46, 0, 2 * r + 0.53), draw(0.15, 0.19)),
    }


def staff(draw: Draw) -> Parts:
    """A wizard's staff with a crystal in a fork."""
    high = draw(2.5, 2.8)
    orb = ball((0, 0, high + 0.12), draw(0.19, 0.23))
    prong = capsule((0.08, 0, high - 0.35), (0.26, 0, high + 0.2), 0.065)
    return {
        "shaft": capsule((0, 0, 0.1), (0, 0, high - 0.1), 0.07),
        "crystal": orb,
        "fork": around(int(draw(3, 5)), prong),
    }


def torch(draw: Draw) -> Parts:
    """A burning torch."""
    high, wide = draw(1.3, 1.6), draw(0.25, 0.32)
    flame = smooth_curve(
        [
            (wide * 0.8, high + 0.2),
            (wide * 1.25, high + 0.5),
            (wide * 0.7, high + 0.9),
            (0.02, high + 1.3),
        ]
    )
    return {
        "handle": taper((0, 0, 0.12), (0, 0, high), 0.12, 0.17),
        "flame": lathe(flame, 0.03),
        "basket": lathe([(0.16, high - 0.1), (wide, high + 0.3)], 0.06),
    }


def lantern(draw: Draw) -> Parts:
    """A lamp of four posts round a glass, a roof, a ring to carry it."""
    r, high, post = draw(0.5, 0.62), draw(0.95, 1.25), 0.1
    posts = both(box((r - post, r - post, high / 2 + 0.15), (post, post, high / 2 + 0.1)), 0, 1)
    roof = prism(
        [(-r - 0.12, high + 0.2), (r + 0.12, high + 0.2), (0.2, high + 0.75), (-0.2, high + 0.75)],
        1,
        r + 0.12,
    )
    slope = prism(
        [(-r - 0.12, high + 0.2), (r + 0.12, high + 0.2), (0.2, high + 0.75), (-0.2, high + 0.75)],
        0,
        r + 0.12,
    )
    top = lambda p: roof(p).maximum(slope(p))  # noqa: E731
    return {
        "frame": join(posts, box((0, 0, 0.1), (r + 0.08, r + 0.08, 0.13), 0.03)),
        "glass": box((0, 0, high / 2 + 0.15), (r - 0.1, r - 0.1, high / 2 + 0.1)),
        "roof": top,
        "handle": ring((0, 0, high + 0.95), draw(0.22, 0.28), 0.09, 1),
    }


def potion(draw: Draw) -> Parts:
    """A round or a conical flask with a neck and a cork."""
    r, neck = draw(0.65, 0.8), draw(0.2, 0.26)
    high = draw(1.35, 1.65)
    if draw.chance(0.6):
        side = smooth_curve(
            [(r * 0.55, 0.0), (r, r * 0.75), (r * 0.7, r * 1.5), (neck, r * 1.9), (neck, high)]
        )
    else:
        side = smooth_curve([(r * 0.92, 0.0), (r, 0.14), (neck, r * 1.55), (neck, high)])
    return {
        "flask": lathe(side, 0.02),
        "cork": tube((0, 0, high - 0.05), (0, 0, high + 0.25), neck * 0.95, 0.04),
        "rim": tube((0, 0, high - 0.16), (0, 0, high), neck + 0.1, 0.04),
    }


def cauldron(draw: Draw) -> Parts:
    """A pot-bellied pot on three stout legs, two rings at its rim, bubbling brew in it."""
    r, neck, low, high = draw(0.95, 1.03), draw(0.68, 0.73), draw(0.36, 0.44), draw(1.16, 1.26)
    rim, top = r * neck + 0.06, low + high
    belly = [(0.34 * r, 0), (0.72 * r, 0.1), (0.96 * r, 0.32), (r, 0.52), (0.92 * r, 0.76),
             (neck * r, 1)]  # fmt: skip
    wall = [(u, low + high * v) for u, v in smooth_curve(belly)]
    hollow = [(rim - 0.14, top), (rim - 0.14, low + high * 0.5)]
    brew = tube((0, 0, low + high * 0.6), (0, 0, top - 0.02), rim - 0.08)
    bubbles = (((0.2, -0.16), 0.2), ((-0.22, -0.04), 0.15), ((0.06, 0.26), 0.16))
    return {
        "pot": join(lathe([*wall, *hollow]), ring((0, 0, top), rim, 0.15)),
        "brew": join(brew, *(ball((u, v, top - 0.02), size) for (u, v), size in bubbles)),
        "feet": around(3, taper((r * 0.56, 0, low + 0.16), (r * 0.7, 0, 0.15), 0.22, 0.15), -90),
        "handles": both(ring((rim + 0.32, 0, top - 0.02), 0.27, 0.105, 1)),
    }


def book(draw: Draw) -> Parts:
    """A thick book, lying or upright, its spine to the left."""
    x, y, z = draw(0.7, 0.8), draw(0.2, 0.32), draw(0.95, 1.1)
    covers = join(both(box((0, y, z), (x, 0.08, z)), 1), box((-x, 0, z), (0.09, y + 0.08, z), 0.04))
    band = box((-x * 0.98, 0, z), (0.12, y + 0.12, 0.1))
    return {
        "cover": covers,
        "pages": box((0.0, 0, z), (x - 0.1, y, z - 0.1)),
        "bands": join(*(moved(band, (0, 0, z * k)) for k in (-0.6, 0.6))),
    }


def scroll(draw: Draw) -> Parts:
    """A sheet between two rolls, upright."""
    x, high, r = draw(0.55, 0.7), draw(1.5, 1.9), draw(0.16, 0.2)
    knob = join(both(ball((x + 0.18, 0, high), 0.15)), both(ball((x + 0.18, 0, 0.1), 0.15)))
    return {
        "paper": join(
            box((0, 0, high / 2), (x - 0.06, 0.08, high / 2)),
            tube((-x, 0, high), (x, 0, high), r),
            tube((-x, 0, 0.1), (x, 0, 0.1), r),
        ),
        "rods": join(
            knob,
            tube((-x - 0.15, 0, high), (x + 0.15, 0, high), 0.09),
            tube((-x - 0.15, 0, 0.1), (x + 0.15, 0, 0.1), 0.09),
        ),
        "seal": tube((0, -0.16, high * 0.35), (0, 0, high * 0.35), 0.2, 0.03),
    }


def hourglass(draw: Draw) -> Parts:
    """Two bulbs between plates, on four posts."""
    r, high = draw(0.46, 0.56), draw(0.8, 0.95)
    half = [(r * 0.85, 0.1), (r, 0.3), (r * 0.85, 0.5), (0.15, high - 0.02)]
    bulbs = lathe([*half, *((u, 2 * high - v) for u, v in reversed(half))])
    low = tube((0, 0, 0), (0, 0, 0.2), r + 0.36)
    post = tube((r + 0.23, 0, 0.1), (r + 0.23, 0, 2 * high - 0.1), 0.09)
    return {
        "glass": bulbs,
        "frame": join(low, moved(low, (0, 0, 2 * high - 0.2)), around(4, post, 45)),
    }


ADVENTURE_PROPS_ARMS_AND_MAGIC = {
    "sword": sword,
    "dagger": dagger,
    "shield": shield,
    "arrow": arrow,
    "pistol": pistol,
    "cannon": cannon,
    "bomb": bomb,
    "staff": staff,
    "torch": torch,
    "lantern": lantern,
    "potion": potion,
    "cauldron": cauldron,
    "book": book,
    "scroll": scroll,
    "hourglass": hourglass,
}
