"""Lamps, booths, machines and bins of a street."""

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
    limb,
    mirrored,
    moved,
    prism,
    smooth_curve,
    tube,
    turned,
)
from core.prior.things.shared.outlines import dome_of


def _shaded_lamp(x: float, y: float, z: float, r: float) -> tuple[Solid, Solid]:
    """A bell that hangs at (x, y, z) and the light in it."""
    bell = [(r, z - 0.42), (r, z - 0.36), (r * 0.55, z - 0.12), (0.13, z), (0.13, z + 0.1)]
    return lathe(bell, 0.02, (x, y)), ball((x, y, z - 0.42), r * 0.68)


def street_lamp(draw: Draw) -> Parts:
    """A lantern on its post; or a bell on a bent arm to the front, or one at each side."""
    kind, thick, foot = draw.which(3), draw(0.1, 0.14), draw(0.26, 0.42)
    neck, wide, r = draw(1.7, 2.15), draw(0.3, 0.42), draw(0.3, 0.42)
    parts = {
        "post": tube((0, 0, 0.1), (0, 0, neck), thick),
        "base": join(
            lathe([(foot, 0), (foot, 0.14), (thick + 0.1, 0.24), (thick + 0.06, 0.56)], 0.02),
        ),
        "rings": join(*(tube((0, 0, v), (0, 0, v + 0.12), thick + 0.08, 0.03)
                        for v in (0.54, neck * draw(0.5, 0.8)))),
    }  # fmt: skip
    if kind == 0:
        low, top, small = neck + 0.12, neck + draw(0.5, 0.72), wide * 0.62
        bar = tube((small + 0.02, 0, low), (wide + 0.06, 0, top), 0.09)
        return parts | {
            "arms": join(
                lathe([(0.1, neck - 0.06), (small + 0.08, low - 0.05), (small + 0.08, low + 0.06)]),
                around(4, bar, 45),
                capsule((-0.36, 0, neck - 0.18), (0.36, 0, neck - 0.18), 0.085),
            ),
            "lamp": lathe([(small, low), (wide, top)]),
            "cap": join(
                lathe([(wide + 0.16, top), (wide + 0.16, top + 0.07), (0.1, top + 0.32)], 0.01),
                ball((0, 0, top + 0.36), 0.11),
            ),
        }
    reach, high = draw(0.58, 0.95), neck + draw(0.5, 0.8)
    line = smooth_curve([(0.0, neck - 0.05), (0.02, high - 0.3), (reach * 0.34, high),
                         (reach * 0.8, high - 0.02), (reach, high - 0.26)])  # fmt: skip
    if kind == 1:
        bell, bulb = _shaded_lamp(0, -reach, high - 0.42, r)
        return parts | {
            "arms": limb([(0.0, -u, v) for u, v in line], thick, 0.09),
            "lamp": bulb,
            "cap": bell,
        }
    bell, bulb = _shaded_lamp(reach, 0, high - 0.42, r)
    return parts | {
        "arms": join(
            both(limb([(u, 0.0, v) for u, v in line], thick, 0.09)),
            tube((0, 0, neck - 0.1), (0, 0, high - 0.1), thick),
            ball((0, 0, high - 0.02), 0.16),
        ),
        "lamp": both(bulb),
        "cap": both(bell),
    }


def bus_stop(draw: Draw) -> Parts:
    """A shelter of glass with a bench, a round sign on its pole beside it."""
    x, y, high = draw(0.78, 0.97), draw(0.38, 0.6), draw(1.5, 2.1)
    seat, post, r = draw(0.42, 0.56), 0.095, draw(0.25, 0.36)
    pole, top, left = x + 0.22, high + draw(0.1, 0.5), -0.16
    a, b = -x + left, x + left - 0.28
    panes = join(
        box(((a + b) / 2, y, high / 2 + 0.1), ((b - a) / 2, 0.07, high / 2 - 0.2)),
        box((a, 0, high / 2 + 0.1), (0.07, y, high / 2 - 0.2)),
    )
    return {
        "roof": box(((a + b) / 2, -0.04, high + 0.06), ((b - a) / 2 + 0.16, y + 0.24, 0.1), 0.04),
        "posts": join(
            *(box((u, v, high / 2), (post, post, high / 2), 0.01)
              for u, v in ((a, -y), (a, y), (b, y), (b, -y))),
            box(((a + b) / 2, y, 0.22), ((b - a) / 2, 0.09, 0.1)),
            box((a, 0, 0.22), (0.09, y, 0.1)),
            box(((a + pole) / 2, 0, 0.06), ((pole - a) / 2 + 0.2, y + 0.2, 0.08), 0.02),
        ),
        "glass": panes,
        "bench": join(
            box(((a + b) / 2, y - 0.3, seat), ((b - a) / 2 - 0.2, 0.26, 0.09), 0.03),
            *(box((u, y - 0.28, seat / 2), (0.1, 0.18, seat / 2)) for u in (a + 0.42, b - 0.42)),
        ),
        "pole": join(
            tube((pole, -y * 0.6, 0), (pole, -y * 0.6, top), 0.095),
            tube((pole, -y * 0.6 - 0.08, top + r), (pole, -y * 0.6 + 0.08, top + r), r, 0.02),
        ),
        "sign": join(
            tube((pole, -y * 0.6 - 0.13, top + r), (pole, -y * 0.6 + 0.13, top + r), r - 0.1, 0.02),
            box((pole, -y * 0.6, top - 0.3), (0.2, 0.13, 0.14), 0.02),
        ),
    }  # fmt: skip


def phone_booth(draw: Draw) -> Parts:
    """The British one: red, with raised panes on all sides, a sign above, a domed roof."""
    x, high, low = draw(0.5, 0.58), draw(1.75, 1.95), 0.36
    top, pitch = high + 0.36, (high - low) / 3
    pane = (x - 0.27) / 2
    panes = join(
        *(both(box((pane + 0.09, x, low + pitch * (k + 0.5)), (pane, 0.05, pitch / 2 - 0.08)))
          for k in range(3))
    )  # fmt: skip
    plate = box((0, x, high + 0.18), (x - 0.1, 0.06, 0.13))
    return {
        "body": join(
            box((0, 0, top / 2), (x, x, top / 2)), box((0, 0, 0.1), (x + 0.08, x + 0.08, 0.1))
        ),
        "windows": around(4, turned(panes, 2, -90)),
        "sign": around(4, turned(plate, 2, -90)),
        "roof": join(
            box((0, 0, top), (x + 0.08, x + 0.08, 0.08)),
            lathe(dome_of(x * 0.98, top + 0.03, top + draw(0.26, 0.34))),
        ),
        "handle": box((0, -x - 0.04, low + pitch), (0.08, 0.1, 0.14)),
    }


def parking_meter(draw: Draw) -> Parts:
    """A post, a head with a round top and a window, a plate with a coin slot, a knob."""
    x, post, tall = draw(0.34, 0.4), draw(1.15, 1.35), draw(0.42, 0.52)
    y, top = 0.24, post + tall
    dial = x - 0.1
    window = cut(
        tube((0, -y - 0.05, top), (0, -y + 0.1, top), dial), box((0, 0, top - 1.02), (1, 1, 1))
    )
    return {
        "head": join(
            box((0, 0, (post + top) / 2), (x, y, tall / 2)), tube((0, -y, top), (0, y, top), x)
        ),
        "window": window,
        "needle": box((0, -y - 0.04, top + dial * 0.4), (0.055, 0.06, dial * 0.36)),
        "plate": box((0, -y - 0.02, post + tall * 0.5), (x - 0.12, 0.06, tall * 0.32)),
        "slot": box((0, -y - 0.06, post + tall * 0.5), (0.05, 0.06, tall * 0.2)),
        "post": join(
            tube((0, 0, 0), (0, 0, post + 0.05), 0.12),
            lathe([(x * 0.6, post - 0.1), (x * 0.6, post + 0.05)], 0.02),
            lathe([(0.32, 0), (0.32, 0.1), (0.14, 0.2)]),
        ),
    }


def gas_pump(draw: Draw) -> Parts:
    """An old one: a rounded cabinet with a dial, a globe on top, a hose with its nozzle."""
    x, d, top = draw(0.38, 0.46), draw(0.26, 0.34), draw(1.66, 1.86)
    globe, edge, neck = draw(0.3, 0.36), 0.06, top + 0.14
    outline = [(x, 0.2), (x, top * 0.66), *smooth_curve([(x * 0.94, top * 0.76),
               (x * 0.74, top * 0.92), (x * 0.4, top), (0.0, top)])]  # fmt: skip
    z, front = top * 0.7, -d - 0.02
    hose = [(x - 0.06, 0, 0.74), (x + 0.24, -0.02, 0.7), (x + 0.42, -0.04, 0.44),
            (x + 0.5, -0.04, 0.7), (x + 0.4, -0.04, 1.1)]  # fmt: skip
    ball_z = neck + globe * 0.9
    return {
        "body": grown(prism(mirrored([(u - edge, v) for u, v in outline]), 1, d - edge), edge),
        "globe": tube((0, -0.17, ball_z), (0, 0.17, ball_z), globe, 0.08),
        "face": join(
            tube((0, front - 0.05, z), (0, d, z), x * 0.6, 0.03),
            box((0, front, top * 0.33), (x * 0.62, 0.07, top * 0.13), 0.03),
        ),
        "trim": join(
            box((0, 0, 0.1), (x + 0.12, d + 0.1, 0.12), 0.04),
            tube((0, 0, top - 0.05), (0, 0, neck + 0.08), 0.16, 0.03),
            tube((0, -0.13, ball_z), (0, 0.13, ball_z), globe + 0.05, 0.02),
            moved(turned(box((0, 0, 0.07), (0.06, 0.06, 0.14)), 1, 40), (0, front - 0.06, z)),
            tube((0, front - 0.1, z), (0, d, z), 0.08),
        ),
        "hose": limb(hose, 0.085, 0.085),
        "nozzle": join(
            box((x + 0.34, -0.04, 1.2), (0.13, 0.11, 0.2), 0.05),
            capsule((x + 0.32, -0.04, 1.32), (x + 0.06, -0.04, 1.44), 0.09),
            box((x, -0.04, 1.3), (0.12, 0.13, 0.11), 0.03),
        ),
    }


def vending_machine(draw: Draw) -> Parts:
    """A case with a bright recess where cans stand on shelves, a panel with keys, a flap."""
    x, y, high = draw(0.72, 0.82), draw(0.5, 0.6), draw(1.85, 2.05)
    panel, rows, count = draw(0.4, 0.46), 3, 3
    left, right, low, top = -x + 0.12, x - panel - 0.06, 0.62, high - 0.14
    middle, half, pitch = (left + right) / 2, (right - left) / 2, (top - low) / rows
    recess = box((middle, -y, (low + top) / 2), (half, 0.24, (top - low) / 2))
    r = half / count * 0.74
    cans = [
        tube((u, -y + 0.12, z), (u, -y + 0.12, z + pitch * 0.7), r)
        for k in range(rows)
        for z in (low + pitch * k + 0.02,)
        for u in (middle + half * 2 / count * (j - 1) for j in range(count))
    ]
    shelves = [box((middle, -y + 0.12, low + pitch * k), (half + 0.02, 0.14, 0.05)) for k in (1, 2)]
    key = x - panel / 2 - 0.03
    return {
        "body": cut(box((0, 0, high / 2), (x, y, high / 2), 0.03), recess),
        "window": box((middle, -y + 0.3, (low + top) / 2), (half + 0.03, 0.08, (top - low) / 2)),
        "cans": join(*cans),
        "shelves": join(*shelves),
        "panel": box((key, -y, high * 0.66), (panel / 2 - 0.06, 0.06, high * 0.2)),
        "flap": join(
            box((middle, -y - 0.01, 0.34), (half - 0.02, 0.07, 0.15)),
            box((key, -y - 0.04, high * 0.77), (panel / 2 - 0.12, 0.07, 0.11)),
            box((key, -y - 0.04, high * 0.57), (panel / 2 - 0.12, 0.07, 0.07)),
        ),
    }


def market_stall(draw: Draw) -> Parts:
    """A counter with fruit, four posts, a striped awning with a scalloped edge."""
    x, y, desk = draw(1.0, 1.12), draw(0.5, 0.58), draw(0.68, 0.78)
    eave, rise, out = draw(1.55, 1.68), draw(0.36, 0.46), draw(0.28, 0.36)
    post, count, wide = 0.08, 7, x + 0.12
    half = wide / count
    front, back = -y - out, y + 0.12
    side = [(front, eave), (back, eave + rise), (back, eave + rise + 0.14), (front, eave + 0.14)]
    bands: list[list[Solid]] = [[], []]
    for k in range(count):
        u = -wide + half * (2 * k + 1)
        scallop = tube((u, front - 0.05, eave + 0.05), (u, front + 0.08, eave + 0.05), half)
        lower = cut(scallop, box((u, front, eave + 1.14), (1, 1, 1)))
        bands[k % 2] += [prism(side, 0, half, u), lower]
    step = (2 * x - 0.2) / 6
    fruit = [
        ball((-x + 0.1 + step * (k + 0.5), v, desk + 0.2), step * 0.47)
        for k in range(6)
        for v in (-y * 0.5, 0.1)
    ]
    return {
        "counter": box((0, 0, desk / 2), (x - 0.06, y, desk / 2)),
        "awning": join(*bands[0]),
        "stripes": join(*bands[1]),
        "posts": join(
            both(box((x, -y, eave / 2 + 0.02), (post, post, eave / 2 + 0.02))),
            both(box((x, y, (eave + rise) / 2), (post, post, (eave + rise) / 2))),
        ),
        "shelf": box((0, -0.02, desk + 0.02), (x - 0.02, y + 0.1, 0.07)),
        "fruit": join(*fruit),
    }


def dumpster(draw: Draw) -> Parts:
    """A waste container, wider above, with ribs, two lids, pockets at its sides and wheels."""
    x, y, high = draw(1.05, 1.2), draw(0.58, 0.66), draw(0.85, 1.0)
    out, rise, wheel = draw(0.12, 0.2), draw(0.14, 0.24), 0.15
    low = 2 * wheel - 0.06
    front, back = low + high, low + high + rise
    side = [(-y, low), (y, low), (y + 0.06, back), (-y - out, front)]
    lid = [(-y - out - 0.1, front - 0.02), (y + 0.1, back - 0.02), (y + 0.1, back + 0.12)]
    lid.append((-y - out - 0.1, front + 0.12))
    ribs = [(-y - 0.08, low + 0.1), (-y, low + 0.1), (-y, front - 0.1)]
    ribs += [(-y - out - 0.08, front - 0.1)]
    return {
        "body": prism(side, 0, x),
        "lid": both(prism(lid, 0, x / 2 - 0.02, x / 2 + 0.045)),
        "ribs": join(
            *(prism(ribs, 0, 0.08, u * x) for u in (-0.62, 0, 0.62)),
            prism(
                [
                    (-y - out - 0.07, front - 0.2),
                    (-y, front - 0.2),
                    (-y, front),
                    (-y - out - 0.07, front),
                ],
                0,
                x + 0.06,
            ),
        ),
        "pockets": both(box((x + 0.06, -0.02, low + high * 0.5), (0.13, y * 0.8, 0.15))),
        "wheels": both(
            tube((x * 0.72, y - 0.16, wheel), (x * 0.72 + 0.2, y - 0.16, wheel), wheel), 0, 1
        ),
    }


STREET_FURNITURE = {
    "street lamp": street_lamp,
    "bus stop": bus_stop,
    "phone booth": phone_booth,
    "parking meter": parking_meter,
    "gas pump": gas_pump,
    "vending machine": vending_machine,
    "market stall": market_stall,
    "dumpster": dumpster,
}
