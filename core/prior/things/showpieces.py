"""A grand piano, a stop sign, an open chest of gold, a saddle, an umbrella stand, a PC's tower."""

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
    cut,
    egg,
    grown,
    join,
    lathe,
    limb,
    moved,
    prism,
    ring,
    smooth_curve,
    taper,
    tilted,
    tube,
    turned,
    within,
)


def _harp(x: float, y: float, front: float) -> list[tuple[float, float]]:
    """A grand piano's outline seen from above: straight at the left, bent in at the right."""
    bend = [(x, -y * 0.1), (x * 0.72, y * 0.3), (x * 0.34, y * 0.56), (x * 0.16, y * 0.82),
            (-x * 0.2, y * 0.98), (-x * 0.62, y), (-x * 0.92, y * 0.86), (-x, y * 0.6)]  # fmt: skip
    return [(-x, front), (x, front), *smooth_curve(bend)]


def grand_piano(draw: Draw) -> Parts:
    """A harp-shaped case on three legs, its lid propped open over the strings."""
    x, y, low, high = draw(0.92, 1.0), draw(1.1, 1.24), draw(0.76, 0.82), draw(1.22, 1.28)
    a, desk, u = math.radians(draw(33, 39)), -y * 0.54, x - 0.18
    pitch = 2 * u / 7  # of the white keys: an octave
    black = (
        box((k * pitch - u, -y + 0.34, low + 0.25), (0.075, 0.2, 0.1), 0.01)
        for k in (1, 2, 4, 5, 6)
    )
    case = prism(_harp(x, y, desk), 2, (high - low) / 2, (high + low) / 2)
    well = prism(_harp(x - 0.15, y - 0.15, desk + 0.15), 2, 0.4, high + 0.24)
    board = [(u + x, v) for u, v in _harp(x, y, desk)]
    lid = turned(prism(board, 2, 0.075), 1, -math.degrees(a))
    reach = x * 1.5
    prop = (
        (x - 0.12, -0.1, high - 0.1),
        (reach * math.cos(a) - x, -0.1, high + reach * math.sin(a)),
    )
    leg = taper((0, 0, 0.1), (0, 0, low), 0.1, 0.15)
    return {
        "body": join(
            cut(case, well),
            box((0, -y * 0.77, low + 0.08), (x, y * 0.23, 0.08), 0.02),
            both(box((x - 0.09, -y * 0.77, low + 0.18), (0.09, y * 0.23, 0.18), 0.03)),
            tilted(box((0, 0, 0.16), (x * 0.5, 0.075, 0.18), 0.02), -14, (0, desk + 0.1, high)),
        ),
        "keys": box((0, -y + 0.3, low + 0.18), (u + 0.01, 0.28, 0.08), 0.01),
        "black keys": join(*black),
        "lid": join(moved(lid, (-x, 0, high + 0.08)), capsule(*prop, 0.075)),
        "strings": prism(_harp(x - 0.1, y - 0.1, desk + 0.1), 2, 0.1, high - 0.22),
        "legs": join(
            both(moved(leg, (x - 0.2, -y * 0.6, 0))),
            moved(leg, (-x * 0.4, y * 0.7, 0)),
            box((0, -y * 0.5, low * 0.5), (0.16, 0.08, low * 0.5), 0.03),
            box((0, -y * 0.5 - 0.1, 0.12), (0.26, 0.18, 0.08), 0.03),
        ),
    }


def stop_sign(draw: Draw) -> Parts:
    """An octagon with a raised rim and letters, as a band across it, on a post."""
    r, post = draw(0.84, 0.92), draw(0.9, 1.1)
    z, slope = post + r, math.tan(math.pi / 8)

    def octagon(half: float, deep: float) -> Solid:
        e = half * slope
        side = [(half, e), (e, half), (-e, half), (-half, e), (-half, -e), (-e, -half), (e, -half),
                (half, -e)]  # fmt: skip
        return moved(prism(side, 1, deep), (0, 0, z))

    return {
        "plate": octagon(r, 0.12),
        "rim": moved(cut(octagon(r + 0.02, 0.08), octagon(r - 0.14, 0.2)), (0, -0.11, 0)),
        "letters": box((0, -0.11, z), (r * 0.68, 0.1, draw(0.16, 0.19)), 0.03),
        "post": tube((0, 0.2, 0), (0, 0.2, z + r * 0.6), draw(0.1, 0.12), 0.02),
        "base": lathe([(0.36, 0), (0.36, 0.08), (0.2, 0.2)], 0.02, (0, 0.2)),
    }


def open_chest(draw: Draw) -> Parts:
    """A treasure chest, its half barrel of a lid thrown back, heaped with coins."""
    x, y, low, wall = draw(1.02, 1.16), draw(0.62, 0.7), draw(0.72, 0.82), 0.15
    angle, at, some = draw(-112, -104), (0.0, y - 0.04, low + 0.02), draw.arranged()

    def barrel(half: float, radius: float) -> Solid:
        return tube((-half, -y, 0), (half, -y, 0), radius, 0.02)

    def opened(solid: Solid) -> Solid:
        return tilted(cut(solid, barrel(x - wall, y - wall), box((0, 0, -1), (2, 2, 1))), angle, at)

    def coin(k: int) -> Solid:
        """The k-th of the coins that lie half sunk on the heap, about a spiral."""
        turn, out = 137.5 * k + some(-20, 20), math.sqrt((k + 0.4) / 11)
        u, v = out * math.cos(math.radians(turn)), out * math.sin(math.radians(turn))
        lean = some(58, 72) if k % 4 == 3 else some(4, 14) + 26 * out
        rest = turned(tube((0, 0, -0.075), (0, 0, 0.075), 0.22, 0.02), 0, lean)
        up = low + 0.37 * math.sqrt(1 - 0.8 * out * out)
        return moved(turned(rest, 2, turn + 90), (u * (x - 0.3), v * (y - 0.26), up))

    hoop = join(
        *(moved(barrel(0.12, y + 0.09), (u, 0, 0)) for u in (-x * 0.6, x * 0.6)),
    )
    hollow = box((0, 0, low + 0.2), (x - wall, y - wall, low))
    heap = egg((0, 0, low - 0.04), (x - 0.06, y - 0.06, 0.42))
    return {
        "body": cut(box((0, 0, low / 2), (x, y, low / 2), 0.02), hollow),
        "lid": opened(barrel(x, y)),
        "bands": join(
            cut(
                join(
                    both(box((x * 0.6, 0, low / 2), (0.12, y + 0.09, low / 2))),
                    box((0, 0, low - 0.06), (x + 0.09, y + 0.09, 0.09)),
                ),
                hollow,
            ),
            opened(hoop),
        ),
        "lock": box((0, -y - 0.1, low - 0.1), (0.18, 0.14, 0.2), 0.03),
        "coins": join(within(heap, grown(hollow, 0.05)), *(coin(k) for k in range(11))),
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


def umbrella_stand(draw: Draw) -> Parts:
    """A tall vessel with a rim, in it two rolled umbrellas with crooks that lean apart."""
    r, high = draw(0.52, 0.58), draw(1.26, 1.38)
    tops = (draw(2.36, 2.46), draw(2.1, 2.2))

    def umbrella(u: float, v: float, top: float) -> tuple[Solid, Solid]:
        """Rolled cloth up to where it was open, above it the stick's crook."""
        foot, lip = (u * 0.1, v, 0.3), (u, v, top - 0.54)
        cloth = join(taper(foot, lip, 0.12, 0.22), taper(lip, (u * 1.06, v, top - 0.4), 0.22, 0.12))
        bow = [(u * 1.06, top - 0.5), (u * 1.14, top - 0.2), (u * 1.3, top), (u * 1.72, top + 0.02),
               (u * 1.98, top - 0.16), (u * 1.98, top - 0.3)]  # fmt: skip
        return cloth, limb([(s, v, t) for s, t in smooth_curve(bow)], 0.09, 0.09)

    first, second = umbrella(0.28, -0.12, tops[0]), umbrella(-0.28, 0.14, tops[1])
    wide = draw(0.76, 1.0)
    hollow = tube((0, 0, 0.2), (0, 0, 3), r - 0.15)
    return {
        "body": cut(lathe([(r * wide, 0.04), (r, high)]), hollow),
        "rim": ring((0, 0, high), r - 0.03, 0.11),
        "base": tube((0, 0, 0), (0, 0, 0.18), r * wide + 0.1, 0.04),
        "umbrellas": join(first[0], second[0]),
        "handles": join(first[1], second[1]),
    }


def computer_tower(draw: Draw) -> Parts:
    """A PC's tall case: two lit fans in front, panes at its sides, buttons on top."""
    x, y, high = draw(0.5, 0.56), draw(0.96, 1.06), draw(2.06, 2.2)
    low, r, middle = 0.14, 0.3, (high + 0.14) / 2
    spots = [middle + 0.46 * k for k in (-1, 1)]
    front = box((0, -y, middle), (x - 0.06, 0.12, middle - low - 0.06), 0.04)
    wells = (tube((0, -3, z), (0, -y - 0.02, z), r) for z in spots)
    fan = join(
        tube((0, -0.03, 0), (0, 0.06, 0), r),
        moved(box((0, 0, 0), (0.28, 0.06, 0.06)), (0, -0.06, 0)),
        moved(box((0, 0, 0), (0.06, 0.06, 0.28)), (0, -0.06, 0)),
        ball((0, -0.04, 0), 0.12),
    )
    pane = box((x, 0.06, middle + 0.06), (0.08, y - 0.26, middle - low - 0.24), 0.02)
    return {
        "body": join(box((0, 0.04, middle), (x, y - 0.04, middle - low), 0.04), cut(front, *wells)),
        "window": both(pane),
        "fans": join(*(moved(fan, (0, -y, z)) for z in spots)),
        "lights": join(*(ring((0, -y - 0.1, z), r, 0.085, axis=1) for z in spots)),
        "buttons": join(
            tube((0, -y + 0.22, high), (0, -y + 0.22, high + 0.08), 0.12, 0.02),
            both(box((0.28, -y + 0.22, high), (0.08, 0.09, 0.07), 0.02)),
        ),
        "feet": both(box((x - 0.14, y - 0.26, 0.1), (0.14, 0.2, 0.1), 0.03), 1, 0),
    }


SHOWPIECES = {
    "grand piano": grand_piano,
    "stop sign": stop_sign,
    "open chest": open_chest,
    "saddle": saddle,
    "umbrella stand": umbrella_stand,
    "computer tower": computer_tower,
}
