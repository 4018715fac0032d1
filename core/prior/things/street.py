"""What stands at a street, in a yard or at a port."""

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
    around,
    ball,
    both,
    box,
    cut,
    join,
    lathe,
    moved,
    prism,
    tube,
    turned,
)
from core.prior.things.sites import dome_of


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


def shipping_container(draw: Draw) -> Parts:
    """A long box with upright ribs, a frame, and doors with bars at its front end."""
    x, y, z, edge = draw(0.58, 0.64), draw(1.3, 1.45), draw(0.6, 0.66), 0.11
    step = 2 * (y - edge) / 5
    ribs = [box((x - 0.1, k * step, z), (0.09, step * 0.27, z - 0.12)) for k in range(-2, 3)]
    posts = both(box((x - edge + 0.06, y - edge + 0.06, z), (edge, edge, z)), 0, 1)
    rails = [both(box((x - edge + 0.06, 0, v), (edge, y, edge))) for v in (edge, 2 * z - edge)]
    ends = [both(box((0, y - edge + 0.06, v), (x, edge, edge)), 1) for v in (edge, 2 * z - edge)]
    bar = tube((x * 0.36, -y - 0.1, 0.1), (x * 0.36, -y - 0.1, 2 * z - 0.1), 0.08)
    handle = box((x * 0.36 + 0.12, -y - 0.08, z * 0.85), (0.16, 0.12, 0.085), 0.02)
    return {
        "body": box((0, 0, z), (x - 0.1, y - 0.12, z - 0.07)),
        "ribs": both(join(*ribs)),
        "frame": join(posts, *rails, *ends),
        "doors": both(box((x * 0.42, -y + 0.06, z), (x * 0.42 - 0.07, 0.08, z - 0.22))),
        "bars": both(join(bar, handle)),
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


def pallet(draw: Draw) -> Parts:
    """Boards on cross boards, nine blocks, three skids below."""
    x, y, thick = draw(1.1, 1.25), draw(0.85, 1.0), draw(0.065, 0.078)
    block, wide = draw(0.13, 0.16), draw(0.15, 0.175)
    foot = 2 * thick
    mid = foot + block
    cross = mid + block + thick
    deck = cross + 2 * thick
    boards = [box(((x - wide) * k / 2, 0, deck), (wide, y, thick)) for k in (-2, -1, 0, 1, 2)]
    cubes = box((0, 0, mid), (0.17, 0.15, block + 0.02))
    row = join(*(moved(cubes, ((x - 0.17) * k, 0, 0)) for k in (-1, 0, 1)))
    bars = [
        box((0, (y - 0.15) * k, z), (x, 0.15, thick + 0.01))
        for k in (-1, 0, 1)
        for z in (thick, cross)
    ]
    return {
        "boards": join(*boards),
        "blocks": join(*(moved(row, (0, (y - 0.15) * k, 0)) for k in (-1, 0, 1))),
        "skids": join(*bars),
    }


STREET = {
    "market stall": market_stall,
    "phone booth": phone_booth,
    "vending machine": vending_machine,
    "dumpster": dumpster,
    "shipping container": shipping_container,
    "parking meter": parking_meter,
    "pallet": pallet,
}
