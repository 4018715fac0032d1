"""Computers, their accessories, and office machines."""

import math

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
    ball,
    both,
    box,
    capsule,
    cut,
    egg,
    join,
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

ACCENTS = ((0, 1.5), (5, 0.5), (5, -0.5))  # where no plain key is


def laptop(draw: Draw) -> Parts:
    """Open, its screen leaning back."""
    x, y, high, lean = draw(0.95, 1.1), draw(0.62, 0.74), draw(0.6, 0.72), draw(8, 25)
    hinge = (0, y - 0.06, 0.14)
    lid = tilted(box((0, 0, high), (x, 0.09, high), 0.05), -lean, hinge)
    return {
        "body": join(box((0, 0, 0.1), (x, y, 0.1), 0.06), lid),
        # Blocks that reach into what they lie on: of a thin board little comes out.
        "screen": tilted(box((0, -0.04, high), (x - 0.1, 0.1, high - 0.11)), -lean, hinge),
        "keys": box((0, y * 0.24, 0.12), (x * 0.84, y * 0.42, 0.13)),
        "touchpad": box((0, -y * 0.58, 0.11), (x * 0.3, y * 0.24, 0.13)),
    }


def desktop_computer(draw: Draw) -> Parts:
    """A screen on a flat case, the keyboard in front of them."""
    x, y, case = draw(0.92, 1.02), draw(0.56, 0.64), draw(0.34, 0.42)
    wide, high, rim = draw(0.72, 0.8), draw(0.54, 0.62), draw(0.11, 0.14)
    z, front = case + 0.14 + high, -y + 0.08
    deck, reach, pitch = 0.17, draw(0.27, 0.31), 0.245
    board = -y - reach + 0.03
    keys = [
        box((pitch * (k - 2.5), board + 0.175 * (row - 0.5), deck + 0.03), (0.09, 0.06, 0.09), 0.02)
        for k in range(6)
        for row in (0, 1)
    ]
    return {
        "body": join(
            box((0, 0, case / 2), (x, y, case / 2), 0.03),
            tube((0, 0, case - 0.02), (0, 0, case + 0.2), 0.42),
            box((0, front + 0.3, z), (wide, 0.3, high), 0.05),
            box((0, front + 0.7, z), (wide * 0.76, 0.34, high * 0.76), 0.05),
        ),
        "screen": box((0, front, z + 0.03), (wide - rim, 0.04, high - rim - 0.03), 0.02),
        "keyboard": box((0, board, deck / 2), (x * 0.94, reach, deck / 2), 0.03),
        "keys": join(*keys),
        "slot": box((x * 0.48, -y, case * 0.7), (x * 0.36, 0.05, 0.07), 0.01),
        "button": box((-x * 0.66, -y, case * 0.7), (0.09, 0.05, 0.07), 0.02),
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


def server_rack(draw: Draw) -> Parts:
    """An open cabinet with rows of units, each with drives and lights; vents in its sides."""
    wide, deep, high = draw(0.62, 0.72), draw(0.56, 0.68), draw(2.1, 2.36)
    rows, wall, layout = 4, 0.13, draw.arranged(3)
    step = (high - 0.3 - wall) / rows
    half, x = step / 2 - 0.045, wide - wall
    units, drives, lights, lamps = [], [], [], []
    for k in range(rows):
        z = 0.3 + step * (k + 0.5)
        units.append(box((0, 0, z), (x - 0.02, deep - 0.02, half), 0.02))
        size = min(half - 0.05, 0.12)
        drives += [
            box((x - 0.14 - 0.24 * i, -deep, z), (0.08, 0.05, half - 0.05), 0.01) for i in range(2)
        ]
        on = [lights, lamps, lights] if layout(0, 1) < 0.5 else [lamps, lights, lights]
        for i in range(2):
            on[i].append(tube((0.16 - x + 0.24 * i, -1, z), (0.16 - x + 0.24 * i, 0, z), size))
    back = [box((0, deep, 0.5 + 0.36 * k), (x - 0.1, 0.05, 0.085)) for k in range(5)]
    glow = box((0, -deep, high / 2), (wide, 0.075, high))
    slats = join(*(box((wide, 0, 0.5 + 0.3 * k), (0.05, deep * 0.66, 0.075)) for k in range(3)))
    shell = cut(
        box((0, 0, high / 2 + 0.07), (wide, deep, high / 2 - 0.07), 0.03),
        box((0, -deep, high / 2 + 0.08), (x, 0.26, high / 2 - 0.07 - wall)),
    )
    foot = box((wide - 0.16, deep - 0.16, 0.1), (0.12, 0.12, 0.1))
    top = box((0, 0.05, high + 0.02), (wide * 0.6, deep * 0.6, 0.07), 0.02)
    return {
        "cabinet": join(shell, both(foot, 0, 1)),
        "units": join(*units),
        "drives": join(*drives),
        "lights": within(join(*lights), glow),
        "lamps": within(join(*lamps), glow),
        "vents": join(both(slats), top, *back),
    }


def monitor(draw: Draw) -> Parts:
    """A flat computer screen on a foot."""
    x, half, low = draw(0.98, 1.2), draw(0.56, 0.7), draw(0.4, 0.55)
    z, rim = low + half, draw(0.08, 0.12)
    round_foot = tube((0, 0.1, 0), (0, 0.1, 0.15), 0.5, 0.04)
    square_foot = box((0, 0.1, 0.08), (0.55, 0.36, 0.08), 0.03)
    return {
        "body": box((0, 0, z), (x, 0.11, half), 0.04),
        "screen": box((0, -0.1, z + 0.03), (x - rim, 0.04, half - rim - 0.03)),
        "stand": join(
            box((0, 0.14, low * 0.6 + 0.1), (draw(0.11, 0.18), 0.09, low * 0.6 + 0.1), 0.03),
            round_foot if draw.chance(0.5) else square_foot,
        ),
        "button": ball((x * 0.82, -0.11, low + 0.07), 0.05),
    }


def keyboard(draw: Draw) -> Parts:
    """It lies, its keys in four rows."""
    pitch, row, high, tall = draw(0.38, 0.43), draw(0.36, 0.4), draw(0.2, 0.28), draw(0.12, 0.18)
    x, y = 3 * pitch + 0.1, 2 * row + 0.1

    def key(column: float, line: float, wide: float = 0.5, deep: float = 0.5) -> Solid:
        half = (wide * pitch - 0.08, deep * row - 0.08, tall)
        return box((column * pitch, line * row, high), half)

    keys = (key(c - 2.5, r) for r in (-0.5, 0.5, 1.5) for c in range(6) if (c, r) not in ACCENTS)
    return {
        "body": box((0, 0, high / 2), (x, y, high / 2)),
        "keys": join(*keys, key(0, -1.5, 2), both(key(2.5, -1.5))),
        "accents": join(key(-2.5, 1.5), key(2.5, 0, deep=1)),
    }


def computer_mouse(draw: Draw) -> Parts:
    """A domed body with two buttons and a wheel at the front, and a fat cable that bends away."""
    wide, long, high = draw(0.54, 0.62), draw(0.92, 1.02), draw(0.6, 0.7)
    reach, side = draw(0.4, 0.5), 1 - 2 * draw.which(2)
    floor = box((0, 0, -0.9), (3, 3, 1))
    split, seam = draw(-0.16, -0.02), 0.075

    def dome(grow: float) -> Solid:
        return egg((0, 0, 0.1), (wide + grow, long + grow, high - 0.1 + grow))

    half = box((1 + seam, split - 1, 1.16 + high * 0.24), (1, 1, 1))
    y = -long * 0.6
    z = 0.1 + (high - 0.1) * 0.8
    path = [(0, -long + 0.06), (0, -long - 0.24), (0.1, -long - reach * 0.8)]
    path += [(0.34, -long - reach), (0.62, -long - reach + 0.04)]
    return {
        "body": cut(dome(0.0), floor),
        "buttons": both(within(dome(0.06), half)),
        "wheel": tube((-0.1, y, z - 0.03), (0.1, y, z - 0.03), 0.22, 0.04),
        "base": cut(within(dome(0.04), box((0, 0, 0.12), (2, 2, 0.08))), floor),
        "cable": limb([(side * u, v, 0.17) for u, v in smooth_curve(path, 3)], 0.085, 0.085),
        "logo": within(dome(0.05), tube((0, long * 0.4, 0), (0, long * 0.4, 2), 0.15)),
    }


def printer(draw: Draw) -> Parts:
    """Paper stands at the back and lies on the tray in front."""
    x, y, z, lean = draw(0.85, 1.0), draw(0.55, 0.7), draw(0.36, 0.46), draw(10, 25)
    sheet, at = draw(0.3, 0.45), (0, y * 0.6, 2 * z - 0.1)
    slot = box((0, -y, z * 0.8), (x * 0.72, 0.3, z * 0.36))
    return {
        "body": join(
            cut(box((0, 0, z), (x, y, z), 0.07), slot),
            tilted(box((0, 0.12, 0.2), (x * 0.72, 0.09, 0.28), 0.03), -lean, at),
        ),
        "paper": join(
            tilted(box((0, 0, sheet), (x * 0.6, 0.09, sheet + 0.1)), -lean, at),
            box((0, -y - 0.05, z * 0.62), (x * 0.58, 0.36, 0.08)),
        ),
        "tray": box((0, -y - 0.1, z * 0.42), (x * 0.72, 0.4, 0.09), 0.02),
        "panel": box((x * 0.6, -y * 0.5, 2 * z), (x * 0.26, y * 0.3, 0.05), 0.02),
        "buttons": join(*(ball((-x * u, -y * 0.5, 2 * z), 0.1) for u in (0.75, 0.5))),
    }


def typewriter(draw: Draw) -> Parts:
    """Round keys in straight rows on steps, a basket in the hood behind them, a sheet on the
    roller."""
    x, y, r = draw(1.04, 1.12), draw(0.88, 0.96), draw(0.115, 0.125)
    low, rise, hood = draw(0.2, 0.26), draw(0.12, 0.16), draw(0.72, 0.82)
    step, pitch, roll, sheet = 0.36, 0.39, draw(0.17, 0.2), draw(0.62, 0.84)
    edges = [-y + step * k for k in range(4)]
    stairs = [(v, low + rise * (k + e)) for k, v in enumerate(edges) for e in (-1, 0)]
    side = [(-y, 0), *stairs[1:], (edges[-1] + 0.04, hood), (y, hood), (y, 0)]
    back, z = y - 0.3, hood + roll * 0.6
    keys = [
        tube((pitch * k, v + step / 2, h - 0.06), (pitch * k, v + step / 2, h + 0.12), r, 0.02)
        for v, h in ((edges[1], low + rise), (edges[2], low + 2 * rise))
        for k in (0, 1, 2)
    ]
    basket = tube((0, edges[3] - 0.12, low + 2 * rise), (0, edges[3] - 0.12, 2), 0.5)
    paper = box((0, 0, sheet / 2), (x * 0.6, 0.08, sheet / 2))
    return {
        "body": join(
            cut(prism(side, 0, x - 0.1), basket),
            box((0, 0, 0.08), (x, y + 0.1, 0.09)),
        ),
        "keys": join(
            both(join(*keys)),
            box((0, edges[0] + step / 2, low + 0.03), (pitch * 1.5, 0.1, 0.09), 0.02),
        ),
        "roller": tube((-x - 0.04, back, z), (x + 0.04, back, z), roll, 0.02),
        "knobs": join(
            both(tube((x - 0.02, back, z), (x + 0.18, back, z), roll + 0.06, 0.03)),
            capsule((-x - 0.08, back, z + 0.06), (-x - 0.16, back - 0.5, z + 0.2), 0.1),
        ),
        "paper": moved(turned(paper, 0, -draw(8, 18)), (0, back + 0.14, z - 0.12)),
    }


def calculator(draw: Draw) -> Parts:
    """A wedge that lies, its large keys in four rows and three columns, its screen at the back."""
    x, y, lift, low = draw(0.8, 0.9), draw(1.14, 1.24), draw(15, 20), 0.22
    pane, pitch = draw(0.24, 0.28), (x - 0.06) * 2 / 3
    step = (2 * y - 2 * pane - 0.34) / 4
    rise, run = math.sin(math.radians(lift)) * 2 * y, math.cos(math.radians(lift)) * y
    side = [(-run, 0), (run + 0.1, 0), (run, low + rise), (-run, low)]
    middle = (0.0, 0.0, low + rise / 2)

    def key_at(k: int, row: int) -> Solid:
        place = (pitch * (k - 1), -y + 0.06 + step * (row + 0.5), 0)
        return box(place, (pitch / 2 - 0.08, step / 2 - 0.07, 0.14))

    def column(k: int) -> Solid:
        return join(*(key_at(k, row) for row in range(4)))

    return {
        "body": prism(side, 0, x),
        "display": tilted(box((0, y - pane - 0.12, 0), (x - 0.13, pane, 0.09)), lift, middle),
        "keys": tilted(join(column(0), column(1)), lift, middle),
        "accents": tilted(column(2), lift, middle),
    }


COMPUTERS_AND_OFFICE_MACHINES = {
    "laptop": laptop,
    "desktop computer": desktop_computer,
    "computer tower": computer_tower,
    "server rack": server_rack,
    "monitor": monitor,
    "keyboard": keyboard,
    "computer mouse": computer_mouse,
    "printer": printer,
    "typewriter": typewriter,
    "calculator": calculator,
}
