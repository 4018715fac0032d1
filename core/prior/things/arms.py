"""Arms: weapons, armour and what a fighter carries."""

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
    Vector,
    around,
    ball,
    both,
    box,
    capsule,
    cut,
    egg,
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


def _point(at: Vector, axis: int, degrees: float, radius: float, long: float) -> Solid:
    """A cone whose base is at ``at``, turned from +Z."""
    return moved(turned(lathe([(radius, 0), (0.03, long)], 0.02), axis, degrees), at)


def _leaf(low: float, high: float, wide: float, thick: float) -> Solid:
    """A spear's blade: a kite with a ridge, across y."""
    return lozenge_blade(low, high, wide * 0.4, thick * 0.7, (high - low) * 0.7, 2.5)


def spear(draw: Draw) -> Parts:
    """Point up: a leaf-shaped head, bound with red, a butt of metal."""
    high, long, grip = draw(2.1, 2.4), draw(0.65, 0.8), draw(0.05, 0.056)
    bound = draw(0.26, 0.36)
    return {
        "head": _leaf(high - 0.1, high + long, draw(0.17, 0.21), 0.085),
        "shaft": tube((0, 0, 0.1), (0, 0, high), grip),
        "binding": tube((0, 0, high - 0.14 - bound), (0, 0, high - 0.12), grip + 0.03, 0.02),
        "butt": lathe([(0.025, 0), (grip + 0.025, 0.2), (grip + 0.025, 0.36)]),
    }


def halberd(draw: Draw) -> Parts:
    """Upright: an axe's edge to the left, a beak to the right, a long point on top."""
    high, grip, reach, edge = draw(2.25, 2.4), 0.05, draw(0.37, 0.43), draw(0.3, 0.37)
    z, beak = high - 0.2, draw(0.3, 0.36)
    blade = [(0.05, z + 0.13), (-reach * 0.45, z + 0.15), (-reach + 0.04, z + edge)]
    blade += [(-reach - 0.02, z + edge * 0.5), (-reach - 0.04, z), (-reach - 0.03, z - edge * 0.5)]
    blade += [(-reach + 0.03, z - edge * 1.1), (-reach * 0.45, z - 0.15), (0.05, z - 0.13)]
    hook = [(0, z + 0.15), (0.13, z + 0.15), (beak, z - 0.17), (beak - 0.03, z - 0.25)]
    hook += [(0.13, z - 0.11), (0, z - 0.15)]
    return {
        "head": join(prism(blade, 1, 0.042), prism(hook, 1, 0.042)),
        "point": _leaf(high - 0.06, high + draw(0.7, 0.85), 0.1, 0.052),
        "socket": join(
            box((0, 0, z), (0.08, 0.075, 0.24), 0.02),
            tube((0, 0, z - 0.5), (0, 0, z), grip + 0.022, 0.01),
        ),
        "shaft": tube((0, 0, 0.1), (0, 0, z), grip),
        "butt": lathe([(0.025, 0), (grip + 0.022, 0.18), (grip + 0.022, 0.36)]),
    }


def mace(draw: Draw) -> Parts:
    """Upright: a ball with spikes on a short shaft."""
    r, high, long = draw(0.4, 0.46), draw(1.35, 1.55), draw(0.24, 0.3)
    z, grip = high + r * 0.9, draw(0.11, 0.125)
    spike = lathe([(0.13, r - 0.05), (0.03, r + long)], 0.02)
    tips = join(
        spike,
        around(6, turned(spike, 1, 90)),
        around(4, turned(spike, 1, 45), 45),
        around(4, turned(spike, 1, 135), 45),
    )
    return {
        "head": ball((0, 0, z), r),
        "spikes": moved(tips, (0, 0, z)),
        "shaft": tube((0, 0, 0.2), (0, 0, high + 0.1), grip),
        "collar": lathe([(grip + 0.03, high - 0.22), (grip + 0.13, high + 0.1)], 0.02),
        "grip": tube((0, 0, 0.18), (0, 0, draw(0.62, 0.75)), grip + 0.05, 0.03),
        "pommel": ball((0, 0, 0.17), 0.2),
    }


def club(draw: Draw) -> Parts:
    """Upright: wood that is thick at its top, an iron band around it, spikes or none, a grip."""
    thick, high, neck = draw(0.36, 0.42), draw(2.3, 2.5), draw(0.13, 0.15)
    side = [(neck, 0.1), (neck, high * 0.3), (thick * 0.62, high * 0.58), (thick, high * 0.82),
            (thick * 0.86, high * 0.96), (0.0, high)]  # fmt: skip
    low, up = high * 0.58, high * 0.68
    spike = turned(lathe([(0.12, thick * 0.5), (0.03, thick + draw(0.24, 0.3))], 0.02), 1, 90)
    parts = {
        "wood": lathe(smooth_curve(side)),
        "grip": tube((0, 0, 0.16), (0, 0, high * 0.27), neck + 0.05, 0.03),
        "knob": ball((0, 0, 0.14), neck + 0.09),
        "band": lathe([(thick * 0.7, low), (thick * 0.88, up)], 0.02),
    }
    if draw.has("spikes", 0.5):
        parts["spikes"] = join(
            *(moved(around(5, spike, 36 * k), (0, 0, high * (0.76 + 0.12 * k))) for k in range(2)),
            moved(lathe([(0.13, -0.1), (0.03, 0.3)], 0.02), (0, 0, high)),
        )
    return parts


def scythe(draw: Draw) -> Parts:
    """Upright, its curved blade at the top, to the left; two pegs to hold it."""
    high, reach, drop = draw(2.55, 2.75), draw(1.15, 1.3), draw(0.7, 0.85)
    wide, x = draw(0.34, 0.4), 0.6
    tip = (x - 0.55 - reach, high - drop)
    back = [(x + 0.12, high), (0.05, high + 0.12), (-0.65, high - 0.14), tip]
    edge = [(-0.52, high - 0.12 - wide), (0.05, high + 0.06 - wide), (x + 0.12, high - wide * 0.9)]
    curve = [*smooth_curve(back), *smooth_curve([tip, *edge])[1:]]
    peg = tube((x, 0, 0), (x - 0.42, 0, 0.06), 0.1, 0.03)
    return {
        "blade": prism(curve, 1, 0.09),
        "shaft": tube((x, 0, 0), (x, 0, high + 0.14), draw(0.105, 0.12), 0.03),
        "collar": tube((x, 0, high - wide - 0.06), (x, 0, high + 0.06), 0.18, 0.03),
        "pegs": join(moved(peg, (0, 0, 0.8)), moved(peg, (0, 0, draw(1.35, 1.5)))),
    }


def crossbow(draw: Draw) -> Parts:
    """Upright, its bolt up and to the front, its butt on the ground."""
    top, reach, bend = draw(2.05, 2.2), draw(1.05, 1.2), draw(0.4, 0.52)
    nut, y = top - draw(0.85, 0.95), 0.16
    outer = [(0, top), (reach * 0.55, top - 0.1), (reach, top - bend)]
    inner = [(reach - 0.14, top - bend - 0.1), (reach * 0.5, top - 0.34), (0, top - 0.28)]
    limb = [*smooth_curve(outer), *smooth_curve(inner)]
    cord = capsule((reach - 0.07, -0.02, top - bend), (0, -y - 0.06, nut), 0.08)
    side = [(-y, top + 0.05), (-y, 0.55), (-0.12, 0), (0.42, 0), (0.3, 0.62), (y, 0.9)]
    tip = top + draw(0.1, 0.2)
    bolt = tube((0, -y - 0.05, nut - 0.1), (0, -y - 0.05, tip), 0.085)
    return {
        "stock": prism([*side, (y, top + 0.05)], 0, draw(0.14, 0.16)),
        "limbs": both(prism(limb, 1, 0.13)),
        "string": both(cord),
        "bolt": bolt,
        "point": moved(lathe([(0.16, tip - 0.02), (0.03, tip + 0.32)], 0.01), (0, -y - 0.05, 0)),
        "trigger": taper((0, y - 0.05, 1.0), (0, y + 0.22, 0.88), 0.09, 0.09),
    }


def rifle(draw: Draw) -> Parts:
    """Upright, its muzzle to the left, with a magazine and a telescope."""
    z, long, high = 0.82, draw(1.46, 1.55), draw(0.17, 0.2)
    butt, y = draw(1.45, 1.55), draw(0.13, 0.15)
    stock = [(0.42, z + 0.1), (butt, z), (butt, z - draw(0.56, 0.64)), (butt - 0.2, z - 0.56)]
    stock += [(0.8, z - 0.22), (0.42, z - 0.2)]
    grip = [(0.3, z - 0.14), (0.58, z - 0.14), (0.72, z - 0.68), (0.44, z - 0.7)]
    store = [(-0.42, z - 0.1), (-0.08, z - 0.1), (-0.2, z - 0.76), (-0.52, z - 0.68)]
    guard = [(-0.06, z - 0.12), (-0.06, z - 0.42), (0.4, z - 0.42), (0.4, z - 0.12)]
    inner = [(0.06, z), (0.06, z - 0.31), (0.3, z - 0.31), (0.3, z)]
    eye, seen = z + high + 0.22, draw(0.34, 0.4)
    tele = join(
        tube((-seen, 0, eye), (seen, 0, eye), 0.11),
        tube((-seen - 0.16, 0, eye), (-seen + 0.1, 0, eye), 0.16, 0.02),
        tube((seen - 0.08, 0, eye), (seen + 0.1, 0, eye), 0.15, 0.02),
        both(box((0.2, 0, eye - 0.16), (0.1, 0.1, 0.16))),
    )
    return {
        "barrel": join(
            tube((-long, 0, z + 0.04), (0, 0, z + 0.04), 0.1),
            tube((-long - 0.04, 0, z + 0.04), (-long + 0.18, 0, z + 0.04), 0.14, 0.02),
        ),
        "body": join(
            box((0.02, 0, z), (0.46, y, high), 0.03), cut(prism(guard, 1, 0.1), prism(inner, 1, 1))
        ),
        "stock": join(
            prism(stock, 1, y),
            prism(grip, 1, y * 0.95),
            box((-0.58, 0, z - 0.02), (0.28, y * 1.05, 0.17), 0.03),
        ),
        "magazine": prism(store, 1, y * 0.85),
        "scope": tele,
        "trigger": taper((0.2, 0, z - 0.1), (0.17, 0, z - 0.28), 0.07, 0.07),
    }


def catapult(draw: Draw) -> Parts:
    """On four wheels, its arm drawn back with a stone in the cup; it shoots to the front."""
    x, y, r = draw(0.56, 0.66), draw(1.0, 1.15), draw(0.3, 0.35)
    high, lean, long = draw(1.15, 1.3), draw(38, 46), draw(1.5, 1.65)
    beam = box((x, 0, r), (0.13, y, 0.14), 0.02)
    post = box((x, -y * 0.42, r + high / 2), (0.12, 0.13, high / 2), 0.02)
    brace = [
        (-y * 0.42, r + high - 0.1),
        (-y * 0.42, r + high - 0.36),
        (y * 0.36, r),
        (y * 0.62, r),
    ]
    cross = join(*(box((0, side * (y - 0.16), r), (x, 0.13, 0.12)) for side in (-1, 1)))
    # Made along +Z from the axle, then leant back.
    pole = box((0, 0, long / 2 - 0.2), (0.12, 0.12, long / 2 + 0.2), 0.02)
    cup = cut(
        tube((0, -0.26, long + 0.16), (0, 0.14, long + 0.16), 0.36, 0.03),
        ball((0, -0.42, long + 0.16), 0.36),
    )
    stone = ball((0, -0.3, long + 0.16), draw(0.26, 0.3))
    arm, cup, stone = (
        moved(turned(part, 0, -lean), (0, -y * 0.3, r + 0.12)) for part in (pole, cup, stone)
    )
    wheel = tube((x + 0.1, y * 0.66, r), (x + 0.3, y * 0.66, r), r, 0.03)
    hub = tube((x, y * 0.66, r), (x + 0.4, y * 0.66, r), 0.11, 0.02)
    return {
        "frame": join(
            both(join(beam, post, prism(brace, 0, 0.1, x))),
            cross,
            box((0, -y * 0.42, r + high - 0.1), (x + 0.22, 0.16, 0.15), 0.02),
        ),
        "wheels": both(wheel, 0, 1),
        "arm": arm,
        "cup": cup,
        "stone": stone,
        "bands": join(both(hub, 0, 1), tube((-x, -y * 0.3, r + 0.1), (x, -y * 0.3, r + 0.1), 0.2)),
    }


def flattened(solid: Solid, along_y: float) -> Solid:
    """``solid`` made thinner in y by the factor; a lower bound."""
    return lambda p: solid(p * p.new_tensor([1, 1 / along_y, 1])) * along_y


def _cross(z: float, half: float) -> list[tuple[float, float]]:
    """A cross with flared arms about the height ``z``."""
    arm, root = half * 0.5, half * 0.28
    quarter = [(root, root), (arm, half), (-arm, half), (-root, root)]
    turns = ((1, 0), (0, 1), (-1, 0), (0, -1))
    return [(x * c - y * s, z + x * s + y * c) for c, s in turns for x, y in quarter[:3]]


def chestplate(draw: Draw) -> Parts:
    """A knight's breastplate: a cross on a raised plate, a collar, shoulder plates, a skirt."""
    waist, chest, high = draw(0.58, 0.63), draw(0.8, 0.86), draw(1.72, 1.82)
    deep, hem, wide = draw(0.64, 0.7), draw(0.84, 0.9), draw(0.36, 0.4)
    side = smooth_curve([(waist, 0.5), (chest * 0.94, 0.86), (chest, 1.16), (chest * 0.9, 1.46),
                         (0.46, high - 0.06), (0.4, high)])  # fmt: skip
    bust = [(0.0, 0.72), (0.44, 0.98), (0.52, 1.24), (0.42, high - 0.24), (0.22, high - 0.34),
            (0.0, high - 0.38)]  # fmt: skip

    def trunk(more: float) -> Solid:
        return flattened(lathe(side, more), deep)

    def emblem(half: float, deep: float) -> Solid:
        return within(prism(_cross(1.2, half), 1, 0.6, -0.8), trunk(deep))

    hollow = flattened(tube((0, 0, high - 0.3), (0, 0, 3), 0.3), 0.84)
    dome = cut(egg((0, 0, 0), (wide + 0.04, 0.46, 0.34)), box((0, 0, -1.0), (1, 1, 0.98)))
    lame = lathe([(0.33, -0.44), (0.27, -0.04), (0.24, 0.1)])
    skirt = [(hem, 0.0), (waist + 0.04, 0.52)]
    return {
        "plate": join(cut(trunk(0.0), hollow), flattened(lathe(skirt), deep)),
        "muscles": within(prism(mirrored(bust), 1, 1, -1.1), trunk(0.15)),
        "pauldrons": both(moved(turned(join(dome, lame), 1, 32), (chest - 0.06, 0, high - 0.34))),
        "belt": flattened(tube((0, 0, 0.4), (0, 0, 0.62), waist + 0.12, 0.03), deep),
        "crest": join(emblem(0.32, 0.29), flattened(ring((0, 0, high), 0.4, 0.1), 0.84)),
        "lining": flattened(tube((0, 0, 0.8), (0, 0, high - 0.12), 0.34), 0.84),
    }


def lightsaber(draw: Draw) -> Parts:
    """Upright: a shining blade on a hilt with a black grip."""
    low, r, long = draw(0.8, 0.92), draw(0.16, 0.18), draw(1.75, 2.0)
    count = 3
    bands = [
        tube((0, 0, z), (0, 0, z + 0.1), r + 0.045, 0.02)
        for z in (0.12 + 0.18 * k for k in range(count))
    ]
    return {
        "blade": capsule((0, 0, low), (0, 0, low + long), draw(0.115, 0.13)),
        "hilt": tube((0, 0, 0.06), (0, 0, low), r),
        "grips": join(*bands),
        "emitter": lathe([(r, low - 0.14), (r + 0.08, low - 0.02), (r + 0.05, low + 0.12)], 0.02),
        "pommel": tube((0, 0, 0), (0, 0, 0.1), r + 0.04, 0.03),
        "button": box((0, -r, low - 0.24), (0.08, 0.09, 0.08), 0.02),
    }


def jetpack(draw: Draw) -> Parts:
    """Two tanks side by side, their nozzles aflame; its straps are at the back."""
    r, x, low = draw(0.32, 0.37), draw(0.42, 0.47), draw(0.8, 0.9)
    long, flame = draw(1.0, 1.15), draw(0.5, 0.62)
    top = low + long
    tank = tube((x, 0, low), (x, 0, top), r, 0.03)
    nose = cut(egg((x, 0, top), (r, r, draw(0.38, 0.46))), box((x, 0, top - 1), (1, 1, 0.98)))
    horn = lathe([(r * 0.9, low - 0.3), (r * 0.5, low + 0.04)], 0.01, (x, 0))
    fire = smooth_curve(
        [(0.03, low - 0.28 - flame), (r * 0.62, low - 0.1 - flame * 0.55), (r * 0.56, low - 0.2)]
    )
    strap = join(
        capsule((x, r - 0.1, top - 0.1), (x, r + 0.2, top - 0.3), 0.1),
        capsule((x, r + 0.2, top - 0.3), (x, r + 0.2, low + 0.4), 0.1),
        capsule((x, r + 0.2, low + 0.4), (x, r - 0.1, low + 0.2), 0.1),
    )
    return {
        "tanks": both(tank),
        "noses": both(nose),
        "pack": join(
            box((0, 0.06, low + long * 0.5), (x, 0.2, long * 0.4), 0.03),
            box((0, -0.1, low + long * 0.5), (0.15, 0.22, long * 0.26), 0.03),
        ),
        "nozzles": both(horn),
        "flames": both(lathe(fire, 0.0, (x, 0))),
        "straps": both(strap),
    }


ARMS = {
    "spear": spear,
    "halberd": halberd,
    "mace": mace,
    "club": club,
    "scythe": scythe,
    "crossbow": crossbow,
    "rifle": rifle,
    "catapult": catapult,
    "chestplate": chestplate,
    "lightsaber": lightsaber,
    "jetpack": jetpack,
}
