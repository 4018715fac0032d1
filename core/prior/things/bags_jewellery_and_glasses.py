"""Bags, watches, jewellery, glasses and a gas mask."""

import math

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
    cut,
    egg,
    join,
    lathe,
    limb,
    moved,
    prism,
    ring,
    tube,
    turned,
    within,
)


def gas_mask(draw: Draw) -> Parts:
    """Two great goggles with rims, straps behind; its filter in front, or one at either side."""
    x, high, r = draw(0.76, 0.82), draw(0.88, 0.96), draw(0.36, 0.39)
    z, eye, side = 1.05, (draw(0.4, 0.43), 1.22), draw.chance(0.45)
    face = blend(0.1, egg((0, 0, z), (x, 0.62, high)), egg((0, -0.2, z - 0.55), (0.5, 0.48, 0.42)))
    face = cut(face, box((0, 1.2, z), (2, 1, 2)))
    a = draw(12, 18)

    def goggle(first: float, last: float, radius: float) -> Solid:
        barrel = tube((0, first, 0), (0, last, 0), radius, 0.03)
        return moved(turned(barrel, 2, a), (eye[0], 0, eye[1]))

    rim = cut(goggle(-0.2, -0.7, r), goggle(-0.6, -1, r - 0.13))
    low = z - 0.55
    if side:
        can = turned(tube((0, 0, 0), (0, -0.92, 0), 0.3, 0.04), 2, 56)
        end = turned(tube((0, -0.8, 0), (0, -1.02, 0), 0.2, 0.03), 2, 56)
        at = (0.06, -0.16, low - 0.06)
        filters, caps = both(moved(can, at)), both(moved(end, at))
        caps = join(caps, tube((0, -0.4, low + 0.04), (0, -0.82, low + 0.04), 0.24, 0.04))
    else:
        neck = tube((0, -0.4, low), (0, -0.8, low), 0.26)
        can = tube((0, -0.76, low), (0, -1.3, low), 0.4, 0.05)
        filters = join(neck, can)
        caps = tube((0, -1.1, low), (0, -1.42, low), 0.24, 0.03)
    deep = draw(0.86, 0.96)
    turns = [math.pi * k / 14 for k in range(15)]

    def band(wide: float, width: float, shift: float = 0.0) -> list[tuple[float, float]]:
        outer = [(wide * math.cos(t), shift + deep * math.sin(t)) for t in turns]
        inner = [((wide - width) * math.cos(t), shift + (deep - width) * math.sin(t))
                 for t in reversed(turns)]  # fmt: skip
        return [*outer, *inner]

    over = [(v, z + u) for u, v in band(high - 0.02, 0.17) if u >= 0]
    return {
        "mask": face,
        "lenses": both(goggle(-0.3, -0.63, r - 0.1)),
        "rims": both(rim),
        "filters": filters,
        "caps": caps,
        "straps": join(
            prism(band(x - 0.04, 0.17), 2, 0.13, z + 0.02),
            prism(over, 0, 0.13),
            box((0, deep - 0.09, z + 0.04), (0.22, 0.1, 0.22), 0.03),
        ),
    }


def goggles(draw: Draw) -> Parts:
    """An aviator's: two cups with thick rims, a bridge, a strap round an absent head."""
    r, deep, z = draw(0.43, 0.48), draw(0.2, 0.28), 0.56
    x, toe = r + draw(0.18, 0.2), draw(8, 13)
    wide, long, half = x + r + 0.06, draw(0.95, 1.1), draw(0.17, 0.2)
    front, turns = -long * 0.36, [k * math.tau / 40 for k in range(40)]

    def cup(solid: Solid) -> Solid:
        """What was turned about z, its top to the front, to where the right eye is."""
        return moved(turned(turned(solid, 0, 90), 2, toe), (x, front, z))

    def oval(by: float) -> list[tuple[float, float]]:
        return [((wide + by) * math.cos(t), (long + by) * math.sin(t)) for t in turns]

    hole, pane = (tube((0, 0, -1), (0, 0, 2), r - k) for k in (0.14, 0.09))
    body = cut(lathe([(r + 0.1, -0.22), (r + 0.08, -0.06), (r + 0.01, deep)], 0.02), hole)
    rim = cut(tube((0, 0, deep - 0.06), (0, 0, deep + 0.18), r + 0.1, 0.05), pane)
    band = cut(prism(oval(0), 2, half, z), prism(oval(-0.2), 2, 2, z))
    bar, at = (0.13, front - deep - 0.02, z + 0.08), front + 0.42
    buckle = box((wide - 0.1, at, z), (0.19, 0.13, half + 0.09), 0.04)
    return {
        "cups": both(cup(body)),
        "rims": join(both(cup(rim)), both(buckle)),
        "lenses": both(cup(egg((0, 0, deep - 0.02), (r - 0.04, r - 0.04, 0.15)))),
        "strap": cut(band, box((0, front - 0.92, z), (2, 1, 1)), both(cup(hole))),
        "bridge": capsule((-bar[0], *bar[1:]), bar, 0.13),
    }


def sunglasses(draw: Draw) -> Parts:
    """Two dark glasses in a thick frame, a bridge between, its arms straight to the back."""
    gap, half, high, long = draw(0.07, 0.11), draw(0.38, 0.44), draw(0.32, 0.4), draw(0.85, 1.0)
    soft, z, round_ = draw(0.1, 0.2), 0.5, draw.chance(0.4)
    x, y = gap + half + 0.05, -long / 2
    if round_:
        rims = tube((x, y - 0.1, z), (x, y + 0.1, z), half + 0.05, 0.04)
        panes = tube((x, y - 0.17, z), (x, y + 0.17, z), half - 0.08, 0.02)
    else:
        rims = box((x, y, z), (half + 0.05, 0.1, high + 0.03), min(soft, 0.09))
        panes = box((x, y, z - 0.01), (half - 0.08, 0.17, high - 0.1), 0.05)
    arm = box((x + half, 0.06, z + high * 0.45), (0.11, long / 2 + 0.1, 0.11), 0.03)
    return {
        "frame": join(both(rims), box((0, y, z + high * 0.4), (gap + 0.12, 0.1, 0.11), 0.03)),
        "glasses": both(panes),
        "arms": both(arm),
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


def briefcase(draw: Draw) -> Parts:
    """An upright case of two halves, a seam between them, guarded corners, two latches."""
    x, y, z = draw(0.94, 1.06), draw(0.31, 0.36), draw(0.62, 0.7)
    apart, grip, rise = x * draw(0.52, 0.6), draw(0.3, 0.36), draw(0.3, 0.36)
    corner = within(
        box((0, 0, 0), (x + 0.12, y + 0.1, z + 0.12), 0.1), both(ball((x, y, z), 0.29), 0, 1, 2)
    )
    hold = [(grip, z - 0.05), (grip, z + rise * 0.7), (grip - 0.12, z + rise)]
    path = [(u, 0, v) for u, v in [*hold, *((-u, v) for u, v in reversed(hold))]]
    latch = join(
        box((apart, -y - 0.02, z - 0.22), (0.14, 0.12, 0.18), 0.03),
        box((apart, -y - 0.14, z - 0.28), (0.1, 0.08, 0.08), 0.03),
    )
    parts = {
        "body": box((0, 0, 0), (x, y, z), 0.07),
        "seam": box((0, 0, 0), (x + 0.07, 0.1, z + 0.07), 0.04),
        "handle": join(
            limb(path, 0.1, 0.1), both(box((grip, 0, z + 0.06), (0.14, 0.15, 0.1), 0.03))
        ),
        "latches": both(latch),
        "corners": corner,
    }
    return {name: moved(solid, (0, 0, z + 0.1)) for name, solid in parts.items()}


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


def finger_ring(draw: Draw) -> Parts:
    """A band that stands upright; on it a cut gem in its setting, alone or between two small ones,
    or a plate with a flat one."""
    r, thick, wide = draw(0.96, 1.06), draw(0.15, 0.2), draw(0.2, 0.28)
    band = cut(
        tube((0, -wide, r + thick), (0, wide, r + thick), r + thick, 0.08),
        tube((0, -2, r + thick), (0, 2, r + thick), r - 0.06),
    )
    top = 2 * (r + thick) - 0.06
    kind = draw.which(3)
    if kind == 2:
        plate = tube((0, 0, top - 0.14), (0, 0, top + 0.14), draw(0.42, 0.52), 0.05)
        gem = tube((0, 0, top), (0, 0, top + 0.24), 0.3, 0.03)
        return {"band": band, "setting": plate, "gem": gem}
    size = draw(0.36, 0.46)
    gem = lathe([(0.06, top + 0.02), (size, top + size * 0.8), (size * 0.62, top + size * 1.24)])
    setting = lathe([(0.16, top - 0.12), (size * 0.74, top + size * 0.52)], 0.04)
    if kind == 1:
        at = (size * 0.98, 0, top - 0.06)
        gem = join(gem, both(egg(at, (0.2, 0.2, 0.17))))
    return {"band": band, "setting": setting, "gem": gem}


def medal(draw: Draw) -> Parts:
    """A round medal that hangs from a ribbon."""
    wide, high, y = draw(0.58, 0.72), draw(0.9, 1.15), draw(0.12, 0.15)
    drop, half = wide * 2 + 0.1, draw(0.42, 0.52)
    band = [(-half, drop + high), (-half, drop + 0.3), (-0.16, drop - 0.08), (0.16, drop - 0.08)]
    band += [(half, drop + 0.3), (half, drop + high)]
    stripe = [(-0.15, drop + high), (-0.15, drop), (0.15, drop), (0.15, drop + high)]
    star = around(5, prism([(0, -0.12), (wide * 0.6, 0), (0, 0.12)], 2, y + 0.06), 90)
    return {
        "medal": tube((0, -y, wide), (0, y, wide), wide, 0.03),
        "ribbon": prism(band, 1, 0.1),
        "stripe": prism(stripe, 1, 0.13),
        "star": moved(turned(star, 0, 90), (0, 0, wide)),
        "rim": ring((0, 0, wide), wide - 0.02, y + 0.03, axis=1),
    }


BAGS_JEWELLERY_AND_GLASSES = {
    "gas mask": gas_mask,
    "goggles": goggles,
    "sunglasses": sunglasses,
    "backpack": backpack,
    "handbag": handbag,
    "suitcase": suitcase,
    "briefcase": briefcase,
    "watch": watch,
    "ring": finger_ring,
    "medal": medal,
}
