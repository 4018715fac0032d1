"""Things that are worn or carried."""

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
    egg,
    grown,
    join,
    lathe,
    mirrored,
    moved,
    outlined,
    prism,
    ring,
    smooth_curve,
    taper,
    tilted,
    tube,
    within,
)


def watch(draw: Draw) -> Parts:
    """A wristwatch: its dial to the front, the strap closed to a loop behind it."""
    loop, half, wide = draw(0.68, 0.8), draw(0.22, 0.28), draw(0.46, 0.56)
    z, front = loop + 0.1, -loop - 0.04
    strap = cut(
        tube((-half, 0, z), (half, 0, z), loop + 0.09, 0.03),
        tube((-2, 0, z), (2, 0, z), loop - 0.09),
    )
    hour = (draw(0.1, 0.26), z + draw(0.0, 0.16))
    hands = join(
        capsule((0, front - 0.18, z), (0, front - 0.18, z + wide * 0.6), 0.06),
        capsule((0, front - 0.18, z), (hour[0], front - 0.18, hour[1]), 0.06),
    )
    return {
        "strap": join(strap, box((0, loop, z), (half + 0.06, 0.13, 0.16), 0.03)),
        "case": join(
            tube((0, front - 0.14, z), (0, front + 0.16, z), wide, 0.05),
            tube((0, front, z), (wide + 0.13, front, z), 0.1, 0.03),
        ),
        "face": tube((0, front - 0.18, z), (0, front, z), wide - 0.1, 0.01),
        "hands": hands,
    }


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


def helmet(draw: Draw) -> Parts:
    """A knight's: a slit to look through, a plume over its top and back."""
    wide, high = draw(0.7, 0.8), draw(0.9, 1.05)
    dome = [
        (wide * math.cos(k * math.pi / 24), high + wide * math.sin(k * math.pi / 24))
        for k in range(13)
    ]
    hollow = tube((0, 0, -1), (0, 0, 0.35), wide - 0.15)
    slot = box((0, -wide, high), (wide * 0.8, wide * 0.75, 0.11))
    strip = box((0, -wide, high * 0.45), (0.11, 0.12, high * 0.45))
    rim = join(tube((0, 0, 0), (0, 0, 0.2), wide + 0.06), strip)
    back, up = 0.14, high + draw(0.16, 0.24)
    return {
        "shell": cut(lathe([(wide, 0.05), *dome]), hollow, slot),
        "visor": tube((0, 0, high - 0.2), (0, 0, high + 0.2), wide - 0.1),
        "crest": tube((-0.12, back, up), (0.12, back, up), wide),
        "rim": cut(rim, hollow),
    }


def baseball_cap(draw: Draw) -> Parts:
    """A cap with its brim to the front, a round badge above it."""
    wide, high, reach = draw(0.72, 0.8), draw(0.76, 0.9), draw(0.62, 0.78)
    deep, side = wide * 1.06, wide * draw(0.86, 0.96)
    half = [(0, -deep - reach), (side * 0.55, -deep - reach * 0.88), (side * 0.92, -deep - 0.2)]
    plan = smooth_curve([*half, (side, -deep * 0.55), (side * 0.8, -deep * 0.2)], 5)
    brim = grown(prism(mirrored(plan), 2, 0.05), 0.04)
    # Where on the dome the badge sits, and the way out of it.
    at, size = math.radians(draw(36, 42)), draw(0.23, 0.28)
    y, z = -deep * math.cos(at), 0.04 + high * math.sin(at)
    out = (math.cos(at) / deep, math.sin(at) / high)
    dy, dz = (u / math.hypot(*out) for u in out)
    dome = egg((0, 0, 0.04), (wide, deep, high))
    return {
        "cap": cut(dome, box((0, 0, -1), (2, 2, 1))),
        "brim": tilted(brim, draw(2, 7), (0, 0, 0.2)),
        "button": egg((0, 0, high + 0.07), (0.15, 0.15, 0.1)),
        "badge": tube(
            (0, y + dy * 0.2, z - dz * 0.2), (0, y - dy * 0.08, z + dz * 0.08), size, 0.03
        ),
    }


def glove(draw: Draw) -> Parts:
    """A glove, its fingers up and its thumb to the right; some are mittens."""
    wide, palm, thick = draw(0.42, 0.5), draw(0.62, 0.75), draw(0.17, 0.21)
    low, finger = 0.5, draw(0.52, 0.7)
    top = low + palm
    if draw.chance(0.25):
        fingers = [egg((0, 0, top), (wide, thick + 0.05, finger * 1.15))]
    else:
        reach = (0.82, 1.0, 0.94, 0.68)
        fingers = [
            capsule(
                (wide * (0.75 - 0.5 * k), 0, top - 0.1),
                (wide * (0.9 - 0.6 * k), 0, top + finger * reach[k]),
                wide * 0.25,
            )
            for k in range(4)
        ]
    thumb = taper(
        (wide * 0.6, -0.04, low + 0.25), (wide + 0.36, -0.08, low + palm * 0.95), 0.19, 0.14
    )
    hand = egg((0, 0, low + palm * 0.5), (wide * 1.08, thick + 0.06, palm * 0.72))
    flare = draw(0.9, 1.15)
    cuff = [
        (-wide * flare, 0),
        (wide * flare, 0),
        (wide * 0.8, low + 0.1),
        (-wide * 0.8, low + 0.1),
    ]
    return {
        "body": blend(0.06, hand, thumb, *fingers),
        "cuff": prism(cuff, 1, thick),
        "band": box((0, 0, low + 0.06), (wide * 0.9, thick + 0.06, 0.09), 0.04),
    }


def backpack(draw: Draw) -> Parts:
    """A school bag: a pocket in front, straps at the back."""
    x, y, high, soft = draw(0.6, 0.7), draw(0.32, 0.4), draw(1.5, 1.75), draw(0.18, 0.28)
    pocket = draw(0.55, 0.7)
    strap = cut(
        ring((x * 0.5, y * 0.35, high * 0.5), high * 0.36, 0.1, axis=0),
        box((0, -1 + y * 0.4, 0), (2, 1, 3)),
    )
    clasp = box((x * 0.4, -y - 0.24, pocket * 0.75), (0.08, 0.08, 0.16), 0.02)
    return {
        "body": box((0, 0, high / 2), (x, y, high / 2), soft),
        "pocket": box((0, -y - 0.02, pocket * 0.55), (x * 0.8, 0.24, pocket * 0.5), 0.12),
        "flap": box((0, -0.08, high * 0.82), (x + 0.05, y + 0.04, high * 0.2), 0.14),
        "straps": both(strap),
        "handle": cut(ring((0, 0, high - 0.02), 0.22, 0.09, axis=1), box((0, 0, 0), (2, 2, 1))),
        "buckles": join(both(clasp), box((0, -y - 0.1, high * 0.64), (0.1, 0.08, 0.14), 0.02)),
    }


def handbag(draw: Draw) -> Parts:
    """A lady's bag with a round handle."""
    low, top, high, y = draw(0.8, 0.95), draw(0.55, 0.75), draw(0.85, 1.05), draw(0.26, 0.34)
    shape = [(-low, 0), (low, 0), (top, high), (-top, high)]
    flap = [(-top - 0.02, high + 0.04), (-top - 0.1, high * 0.52), (0, high * draw(0.3, 0.42))]
    flap += [(top + 0.1, high * 0.52), (top + 0.02, high + 0.04)]
    bow = ring((0, 0, high), top * draw(0.62, 0.8), 0.095, axis=1)
    return {
        "body": prism(shape, 1, y),
        "flap": prism(flap, 1, y * 0.5 + 0.06, -y * 0.5),
        "handle": cut(bow, box((0, 0, high - 1.05), (2, 2, 1))),
        "clasp": box((0, -y - 0.06, high * 0.42), (0.12, 0.08, 0.12), 0.03),
    }


def suitcase(draw: Draw) -> Parts:
    """A travel case with a handle, two straps with buckles, blocks about its corners and feet."""
    x, z, y = draw(1.14, 1.18), draw(0.7, 0.74), draw(0.36, 0.39)
    low, at = 0.22, x * 0.47
    mid, top = low + z, low + 2 * z
    corner = box((x - 0.08, 0, z - 0.08), (0.15, y + 0.07, 0.15), 0.06)
    strap = box((at, 0, 0), (0.11, y + 0.07, z + 0.07), 0.03)
    grip = join(
        both(box((0.25, 0, top + 0.13), (0.1, 0.12, 0.22), 0.03)),
        box((0, 0, top + 0.3), (0.35, 0.12, 0.11), 0.05),
    )
    return {
        "body": box((0, 0, mid), (x, y, z), 0.1),
        "bands": moved(join(both(corner, 0, 2), both(strap)), (0, 0, mid)),
        "handle": grip,
        "feet": both(box((x - 0.14, 0, 0.13), (0.13, y * 0.84, 0.13), 0.03)),
        "locks": both(box((at, -y - 0.07, mid + z * 0.34), (0.18, 0.09, 0.15), 0.04)),
    }


def shirt(draw: Draw) -> Parts:
    """A polo shirt, as if worn by someone unseen: short sleeves, a collar, three buttons."""
    wide, high, y, soft = draw(0.47, 0.54), draw(1.4, 1.6), draw(0.3, 0.34), 0.2
    reach, drop = draw(0.24, 0.32), draw(0.3, 0.42)
    half = [(0, 0), (wide, 0), (wide - 0.02, high * 0.4), (wide + 0.02, high - 0.3)]
    half += [(wide - 0.06, high - 0.13), (0.2, high), (0, high)]
    trunk = [(max(u - soft, 0.0), min(max(v, soft), high - soft)) for u, v in half]
    shoulder, end = (wide - 0.17, 0, high - 0.25), (wide + reach, 0, high - 0.22 - drop)
    along = [e - s for s, e in zip(shoulder, end, strict=True)]
    last = tuple(e - 0.4 * d for e, d in zip(end, along, strict=True))
    start = tuple(e - 0.2 * d for e, d in zip(end, along, strict=True))
    out = tuple(e + 0.16 * d for e, d in zip(end, along, strict=True))
    neck = egg((0, -0.06, high + 0.06), (0.22, 0.2, 0.28))
    flap = [(0.05, high - 0.08), (0.3, high - 0.02), (0.3, high - 0.22), (0.2, high - 0.34)]
    spots = (egg((0, -y, high * v), (0.085, 0.08, 0.085)) for v in (0.19, 0.39, 0.59))
    return {
        "body": cut(
            join(
                both(grown(prism(trunk, 1, y - soft), soft)),
                both(taper(shoulder, last, 0.25, 0.22)),
            ),
            neck,
        ),
        "cuffs": both(tube(start, out, 0.26, 0.05)),
        "collar": join(
            tilted(ring((0, 0, 0), 0.25, 0.1), 12, (0, -0.03, high + 0.01)),
            both(grown(prism(flap, 1, 0.05, -y + 0.02), 0.05)),
        ),
        "buttons": join(*spots),
    }


def trousers(draw: Draw) -> Parts:
    """Jeans as if worn: round legs, turned up, a belt, pockets in front and behind."""
    hip, y, leg = draw(0.46, 0.51), draw(0.29, 0.32), draw(0.2, 0.23)
    crotch, foot = draw(1.2, 1.4), draw(0.34, 0.4)
    top = crotch + draw(0.44, 0.52)

    def waist(by: float, low: float, high: float) -> Solid:
        quarter = [
            (0.0, -y - by),
            (hip * 0.62, -y - by),
            (hip * 0.96 + by, -y * 0.5),
            (hip + by, 0),
        ]
        plan = smooth_curve([*quarter, *((u, -v) for u, v in reversed(quarter[:-1]))], 3)
        return grown(prism(mirrored(plan), 2, (high - low) / 2 - 0.03, (low + high) / 2), 0.03)

    hole = egg((0, 0, top + 0.06), (hip - 0.14, y - 0.13, 0.24))
    hose = taper((hip - 0.25, 0, crotch + 0.06), (foot, 0, 0.22), 0.28, leg)
    pocket = box((hip * 0.54, y - 0.03, crotch + 0.05), (0.14, 0.09, 0.14), 0.03)
    return {
        "body": cut(blend(0.12, both(hose), waist(-0.03, crotch + 0.02, top - 0.05)), hole),
        "belt": cut(waist(0.04, top - 0.18, top), hole),
        "buckle": box((0, -y - 0.09, top - 0.09), (0.12, 0.08, 0.11), 0.03),
        "cuffs": both(tube((foot, 0, 0), (foot, 0, 0.24), leg + 0.06, 0.04)),
        "pockets": both(pocket, 0, 1),
    }


def dress(draw: Draw) -> Parts:
    """A dress with a wide skirt and short sleeves, low at the neck."""
    waist, low, skirt, high = draw(0.26, 0.3), draw(0.8, 0.95), draw(0.9, 1.3), draw(0.62, 0.7)
    top = skirt + high
    flare = smooth_curve([(low, 0), (low * draw(0.55, 0.75), skirt * 0.5), (waist, skirt)], 4)
    bust = [(waist, skirt - 0.05), (waist + 0.12, top - 0.3), (waist + 0.1, top - 0.08)]
    reach, drop = draw(0.5, 0.58), draw(0.2, 0.34)
    sleeve = taper((waist - 0.02, 0, top - 0.12), (reach, 0, top - 0.12 - drop), 0.15, 0.19)
    hollow = egg((0, 0, 0), (low * 0.85, low * 0.85, skirt * 0.35))
    neck = join(egg((0, -0.04, top + 0.02), (0.23, 0.25, 0.3)))
    return {
        "skirt": cut(lathe(flare, 0.02), hollow),
        "body": cut(lathe([*bust, (waist - 0.02, top)], 0.02), neck),
        "belt": tube((0, 0, skirt - 0.09), (0, 0, skirt + 0.08), waist + 0.06, 0.03),
        "hem": cut(tube((0, 0, -0.02), (0, 0, 0.13), low + 0.04, 0.04), hollow),
        "bow": join(
            ball((0, waist + 0.1, skirt), 0.11),
            both(egg((0.24, waist + 0.12, skirt + 0.04), (0.22, 0.1, 0.15))),
        ),
        "sleeves": both(sleeve),
    }


CLOTHES = {
    "watch": watch,
    "sneaker": sneaker,
    "boot": boot,
    "high heel": high_heel,
    "helmet": helmet,
    "baseball cap": baseball_cap,
    "glove": glove,
    "backpack": backpack,
    "handbag": handbag,
    "suitcase": suitcase,
    "shirt": shirt,
    "trousers": trousers,
    "dress": dress,
}
