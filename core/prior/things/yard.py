"""Objects of a yard or a camp, a chain and horse tack."""

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
    smooth_curve,
    tilted,
    tube,
    turned,
    within,
)


def fence(draw: Draw) -> Parts:
    """Pickets on two rails."""
    count, high, half = int(draw(4, 6)), draw(1.1, 1.4), draw(0.15, 0.18)
    step = 2.8 / count
    corners = [(-half, 0), (half, 0), (half, high - 0.2), (0, high), (-half, high - 0.2)]
    pickets = (
        prism([(u + step * (k - (count - 1) / 2), v) for u, v in corners], 1, 0.09)
        for k in range(count)
    )
    rails = join(*(box((0, 0.12, high * k), (1.4, 0.09, 0.11)) for k in (0.25, 0.72)))
    return {"pickets": join(*pickets), "rails": rails}


def well(draw: Draw) -> Parts:
    """A round wall of stones, two posts, a roof."""
    r, high = draw(0.72, 0.85), draw(0.6, 0.72)
    wall = cut(tube((0, 0, 0), (0, 0, high), r, 0.03), tube((0, 0, 0.3), (0, 0, 3), r - 0.24))
    top = draw(1.75, 2.0)
    slope = [(-r - 0.2, top), (r + 0.2, top), (0, top + draw(0.5, 0.65))]
    roof = prism(slope, 1, r * 0.8)
    return {
        "wall": wall,
        "roof": roof,
        "posts": join(
            both(box((r - 0.12, 0, top / 2 + 0.1), (0.1, 0.12, top / 2))),
            tube((-r, 0, high + 0.55), (r, 0, high + 0.55), 0.1),
        ),
        "water": tube((0, 0, 0.05), (0, 0, high * 0.6), r - 0.1),
    }


def ladder(draw: Draw) -> Parts:
    """Two rails, rungs."""
    x, high, count = draw(0.4, 0.5), draw(2.0, 2.4), int(draw(4, 7))
    rungs = (
        tube((-x, 0, high * (k + 0.5) / count), (x, 0, high * (k + 0.5) / count), 0.09)
        for k in range(count)
    )
    return {"rails": both(box((x, 0, high / 2), (0.1, 0.1, high / 2), 0.02)), "rungs": join(*rungs)}


def tent(draw: Draw) -> Parts:
    """A ridge tent, its door in front."""
    x, y, high = draw(0.85, 1.05), draw(1.0, 1.25), draw(1.05, 1.3)
    body = prism([(-x, 0), (x, 0), (0, high)], 1, y)
    door = prism([(-x * 0.36, -0.1), (x * 0.36, -0.1), (0, high * 0.66)], 1, 0.3, -y)
    inside = prism([(-x * 0.34, 0.0), (x * 0.34, 0.0), (0, high * 0.62)], 1, 0.1, -y + 0.25)
    ridge = capsule((0, -y - 0.06, high), (0, y + 0.06, high), 0.09)
    return {"canvas": cut(body, door), "door": inside, "poles": ridge}


def campfire(draw: Draw) -> Parts:
    """Logs leant together, stones around, a flame."""
    count, flame = int(draw(6, 9)), draw(1.0, 1.3)
    stones = around(count, egg((0.95, 0, 0.14), (0.24, 0.26, 0.2)))
    logs = around(5, capsule((0.72, 0, 0.14), (0.08, 0, 0.6), 0.13), 20)
    fire = smooth_curve([(0.25, 0.3), (0.36, 0.6), (0.2, flame), (0.02, flame + 0.35)])
    ground = tube((0, 0, 0), (0, 0, 0.1), 0.95, 0.03)
    return {"flame": lathe(fire, 0.04), "logs": logs, "stones": stones, "ash": ground}


def flag(draw: Draw) -> Parts:
    """A flag on a pole with a foot."""
    high, wide, tall = draw(2.2, 2.5), draw(1.0, 1.25), draw(0.6, 0.75)
    waves = [(0.0, 0.0), (wide * 0.35, 0.09), (wide * 0.7, -0.09), (wide, 0.05)]
    curve = smooth_curve(waves)
    outline = [(u, v + 0.09) for u, v in curve] + [(u, v - 0.09) for u, v in reversed(curve)]
    return {
        "cloth": prism(outline, 2, tall / 2, high - tall / 2 - 0.1),
        "pole": capsule((0, 0, 0.1), (0, 0, high), 0.09),
        "knob": ball((0, 0, high + 0.08), 0.16),
        "base": tube((0, 0, 0), (0, 0, 0.14), 0.38, 0.03),
    }


def nest(draw: Draw) -> Parts:
    """A thick bowl of rings that lie askew, twigs woven about it, three eggs on the straw."""
    r, high, thick = draw(0.9, 0.98), draw(0.74, 0.84), draw(0.2, 0.23)
    size, first = draw(0.33, 0.36), 30 if draw.chance(0.5) else 90
    levels = ((0.26, 0.76, 0.05, 90), (0.62, 0.94, 0.05, 210), (0.98, 1.0, 0.05, 330))

    def askew(z: float, wide: float, off: float, turn: float) -> Solid:
        a = math.radians(turn)
        return ring((off * math.cos(a), off * math.sin(a), high * z), r * wide, thick)

    def twig(turn: float, out: float, z: float, tilt: float) -> Solid:
        return turned(capsule((out, -0.54, z - tilt), (out, 0.54, z + tilt), 0.115), 2, turn)

    laid = egg((size * 1.12, 0, high * 0.98), (size * 0.96, size * 0.96, size * 1.26))
    low = [twig(72 * k + 18, r * 0.92 + thick * 0.6, high * 0.46, 0.14) for k in range(5)]
    top = [twig(72 * k + 54, r + thick * 0.6, high * 0.92, -0.12) for k in range(5)]
    hollow = lathe([(r * 0.5, high * 0.5), (r * 0.8, high), (r * 0.8, 2)])
    return {
        "bowl": join(
            cut(lathe([(r * 0.6, 0.06), (r * 0.9, high * 0.5), (r * 0.96, high)], 0.06), hollow),
            *(askew(*level) for level in levels),
        ),
        "twigs": join(*low, *top),
        "straw": join(
            tube((0, 0, 0.2), (0, 0, high * 0.6), r * 0.7),
            ring((0, 0, high * 0.98), r * 0.8, 0.17),
        ),
        "eggs": join(*(turned(laid, 2, first + 120 * k) for k in range(3))),
    }


def padlock(draw: Draw) -> Parts:
    """Its keyhole to the front, its shackle above."""
    x, y, high = draw(0.62, 0.72), draw(0.24, 0.3), draw(1.0, 1.2)
    bow, thick = x - draw(0.2, 0.25), draw(0.12, 0.145)
    top = high + draw(0.25, 0.4)
    body = box((0, 0, high / 2), (x, y, high / 2), draw(0.06, 0.16))
    if draw.chance(0.3):
        body = join(
            tube((0, -y, x), (0, y, x), x, 0.06), box((0, 0, x + 0.32), (x * 0.92, y, 0.32), 0.06)
        )
        top = max(top, x + 0.95)
    arc = cut(ring((0, 0, top), bow, thick, 1), box((0, 0, top - 1), (2, 1, 1)))
    return {
        "body": body,
        "shackle": join(arc, both(tube((bow, 0, 0.6), (bow, 0, top + 0.01), thick))),
        "keyhole": join(
            tube((0, -y - 0.03, high * 0.52), (0, 0, high * 0.52), 0.14),
            prism(
                [
                    (-0.07, high * 0.52),
                    (0.07, high * 0.52),
                    (0.12, high * 0.22),
                    (-0.12, high * 0.22),
                ],
                1,
                (y + 0.03) / 2,
                -(y + 0.03) / 2,
            ),
        ),
    }


def _link(x: float, half: float, major: float, minor: float) -> Solid:
    """A link in the plane of x and y: two bows of a ring and the straights between them."""
    bent = ring((0, 0, 0), major, minor)
    straight = both(capsule((-half, major, 0), (half, major, 0), minor), 1)
    ends = both(cut(moved(bent, (half, 0, 0)), box((half - 3, 0, 0), (3, 3, 3))))
    return moved(join(straight, ends), (x, 0, 0))


def chain(draw: Draw) -> Parts:
    """Three long links that lie in a row, each turned against its neighbours."""
    minor, half, lean = draw(0.12, 0.145), draw(0.16, 0.34), draw(36, 54)
    major = minor * draw(2.15, 2.5)
    pitch = 2 * (half + major) - 2 * minor - 0.07
    z = (major + minor) * 0.8

    def links(places: tuple[int, ...], degrees: float) -> Solid:
        row = join(*(_link(k * pitch, half, major, minor) for k in places))
        return moved(turned(row, 0, degrees), (0, 0, z))

    return {"links": links((-1, 1), lean), "rings": links((0,), lean - 90)}


def horseshoe(draw: Draw) -> Parts:
    """Upright, open above: a flat bow of iron with a groove and nails in either branch."""
    out, wide, deep = draw(0.92, 1.02), draw(0.36, 0.42), draw(0.14, 0.18)
    tall, pinch = draw(0.8, 0.96), draw(0.62, 0.72)
    z = out

    def branch(off: float) -> list[tuple[float, float]]:
        """The right half of a line within the bow, from its bottom to its heel."""
        r = out - off
        points = [(r * math.sin(a), z - r * math.cos(a)) for a in (0, 0.4, 0.8, 1.2, 1.6)]
        return smooth_curve([*points, (r - 0.08, z + tall * 0.5), (r - out + pinch, z + tall)], 3)

    outer, inner = branch(0.0), branch(wide)
    half = [*outer, *reversed(inner)]
    middle = branch(wide / 2)
    groove = limb([(u, 0.0, v) for u, v in middle[4:-2]], 0.095, 0.095)
    sides = both(both(moved(groove, (0, deep - 0.045, 0))), 1)
    nails = [box((u, 0, v), (0.085, deep + 0.1, 0.08), 0.02) for u, v in middle[6:-3:3]]
    x, top = middle[-1][0], z + tall - 0.02
    heel = tube((x, -deep - 0.04, top), (x, deep + 0.04, top), wide * 0.53, 0.03)
    clip = [(-0.22, -0.04), (0.22, -0.04), (0.12, 0.3), (-0.12, 0.3)]
    return {
        "shoe": both(prism(half, 1, deep)),
        "grooves": sides,
        "nails": both(join(*nails)),
        "heels": both(heel),
        "clip": moved(prism(clip, 1, deep + 0.08), (0, 0, 0.02)),
    }


def saddle(draw: Draw) -> Parts:
    """A western saddle: a deep seat between horn and cantle, flaps, stirrups at the sides."""
    r, c, back = draw(0.62, 0.68), draw(1.2, 1.26), draw(0.72, 0.8)
    top, foot = c + r, c - draw(0.96, 1.02)

    def bent(radius: float, side: list[tuple[float, float]]) -> Solid:
        """A sheet over the horse's back that hangs straight from its widest; seen from the side."""
        over = cut(tube((0, -1.2, c), (0, 1.2, c), radius), box((0, 0, c - 1), (2, 2, 1)))
        sheet = join(over, box((0, 0, c - 1), (radius, 1.2, 1.01)))
        inner = join(
            tube((0, -2, c), (0, 2, c), radius - 0.16), box((0, 0, c - 1), (radius - 0.16, 2, 1))
        )
        return within(cut(sheet, inner), prism(side, 0, 2))

    rug = smooth_curve([(-0.9, c + 0.7), (-0.92, c + 0.2), (-0.7, c - 0.12), (0, c - 0.16),
                        (0.74, c - 0.12), (0.98, c + 0.2), (0.92, c + 0.8)])  # fmt: skip
    fender = [(-0.14, c + 0.54), (-0.36, c + 0.2), (-0.34, c - 0.3), (-0.14, c - 0.68),
              (0.14, c - 0.68), (0.3, c - 0.3), (0.26, c + 0.2), (0.12, c + 0.54)]  # fmt: skip
    horn = ((0, -0.64, top + 0.14), (0, -0.76, top + 0.44))
    loop = within(ring((r, 0, foot), 0.24, 0.085, axis=0), box((0, 0, foot + 1), (2, 2, 1.04)))
    sides = both(capsule((r, 0.24, foot), (r, 0.24, foot - 0.18), 0.085), 0, 1)
    return {
        "skirt": bent(r, rug),
        "seat": blend(
            0.16,
            egg((0, 0.06, top - 0.02), (0.52, 0.76, 0.19)),
            tilted(egg((0, 0, 0), (0.52, 0.15, 0.38)), -24, (0, back, top + 0.12)),
            egg((0, -0.58, top), (0.48, 0.22, 0.28)),
        ),
        "horn": join(
            capsule(*horn, 0.1), tilted(tube((0, 0, 0), (0, 0, 0.14), 0.2, 0.04), 12, horn[1])
        ),
        "flaps": bent(r + 0.09, smooth_curve(fender)),
        "stirrups": join(both(loop), sides, both(box((r, 0, foot - 0.2), (0.16, 0.3, 0.08), 0.03))),
        "rivets": both(join(*(ball((r * 0.9, v, c + r * 0.42), 0.11) for v in (-0.66, 0.72)))),
    }


YARD = {
    "fence": fence,
    "well": well,
    "ladder": ladder,
    "tent": tent,
    "campfire": campfire,
    "flag": flag,
    "nest": nest,
    "padlock": padlock,
    "chain": chain,
    "horseshoe": horseshoe,
    "saddle": saddle,
}
