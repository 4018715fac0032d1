"""Schools, shops, farm buildings and a church."""

import math

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Point,
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
    tube,
    turned,
)
from core.prior.things.shared.building_parts import box_row, hip_roof
from core.prior.things.shared.fitted import fitted


def barn(draw: Draw) -> Parts:
    """Its gambrel gable to the front: a great door with a white cross, a loft with hay."""
    wide, long, wall = draw(0.8, 0.92), draw(0.95, 1.2), draw(0.78, 0.9)
    knee, ridge = wall + draw(0.44, 0.52), wall + draw(0.72, 0.82)
    gable = [(wide, 0), (wide, wall), (wide * 0.66, knee), (0, ridge)]
    over = [(wide + 0.16, wall - 0.1), (wide * 0.68 + 0.1, knee + 0.09), (0, ridge + 0.15)]
    inner = [(0, ridge - 0.02), (wide * 0.66 - 0.02, knee - 0.05), (wide - 0.02, wall - 0.14)]
    sheet = [*over, *inner]
    x, y, high = wide * 0.5, -long, wall * 0.84
    bar = box((0, 0, 0), (0.075, 0.08, math.hypot(x, high / 2)))
    lean = math.degrees(math.atan2(x, high / 2))
    loft = wall + 0.26
    post = box((wide - 0.06, y, wall / 2), (0.085, 0.06, wall / 2))
    frame = both(box((x, y - 0.02, high / 2), (0.075, 0.08, high / 2)))
    cross = [moved(turned(bar, 1, side * lean), (0, y - 0.02, high / 2)) for side in (-1, 1)]
    return {
        "walls": prism(mirrored(gable), 1, long),
        "roof": both(prism(sheet, 1, long + 0.12)),
        "trim": join(
            both(post),
            frame,
            box((0, y - 0.02, high), (x + 0.075, 0.08, 0.08)),
            *cross,
            cut(box((0, y - 0.02, loft), (0.34, 0.09, 0.26)), box((0, y, loft), (0.2, 1, 0.12))),
        ),
        "door": box((0, y, high / 2), (x, 0.05, high / 2)),
        "hay": box((0, y, loft), (0.24, 0.06, 0.16)),
    }


def _gabled(x: float, eave: float, ridge: float) -> list[Point]:
    return [(-x, 0), (x, 0), (x, eave), (0, ridge), (-x, eave)]


def greenhouse(draw: Draw) -> Parts:
    """A house of glass in a frame of bars, on a low wall, with plants at its door."""
    x, y, eave = draw(0.74, 0.86), draw(0.94, 1.08), draw(0.85, 0.98)
    ridge, bar, low = eave + draw(0.46, 0.58), 0.085, 0.22
    door, pot = x * 0.36, x * 0.76
    hoop = cut(
        prism(_gabled(x + 0.05, eave + 0.03, ridge + 0.07), 1, bar),
        prism(_gabled(x - 0.13, eave - 0.06, ridge - 0.18), 1, 3),
    )
    end = join(
        box((0, 0, eave), (x, bar, bar)),
        both(box((door, 0, eave / 2), (bar, bar, eave / 2))),
    )
    return {
        "glass": prism(_gabled(x, eave, ridge), 1, y),
        "frame": join(
            *(moved(hoop, (0, y * k, 0)) for k in (-1, 0, 1)),
            both(moved(end, (0, y, 0)), 1),
            both(box((x, 0, eave), (bar, y, bar))),
            box((0, 0, ridge), (bar + 0.02, y + 0.04, bar + 0.02)),
        ),
        "base": box((0, 0, low / 2), (x + 0.12, y + 0.12, low / 2)),
        "door": box((0, -y - 0.06, eave * 0.42), (door - bar, 0.1, eave * 0.42)),
        "plants": both(ball((pot, -y - 0.28, 0.5), 0.26)),
        "pots": both(lathe([(0.16, 0), (0.23, 0.34)], 0, (pot, -y - 0.28))),
    }


def shop(draw: Draw) -> Parts:
    """A front with a wide window, a door, a striped awning, a sign above them."""
    x, y, high = draw(0.9, 1.35), draw(0.6, 0.95), draw(1.9, 2.6)
    eave, out = draw(1.16, 1.34), draw(0.34, 0.55)
    sign, stripe = draw(0.2, 0.25), 2 * (x + 0.04) / 7
    slope = [(-y + 0.05, eave + 0.34), (-y + 0.05, eave + 0.1), (-y - out, eave - 0.14),
             (-y - out, eave + 0.02)]  # fmt: skip
    bars = [prism(slope, 0, stripe / 2, stripe * (k - 3)) for k in range(7)]
    raised = [grown(bars[k], 0.03) for k in (1, 3, 5)]
    side = 1 if draw.chance(0.5) else -1
    door, z = -side * x * 0.58, eave + 0.34 + sign + 0.06
    pane = (side * x * 0.32, x * 0.5)
    return {
        "walls": join(
            box((0, 0, high / 2), (x, y, high / 2)),
            box((0, -0.04, 0.07), (x + 0.06, y + 0.1, 0.07), 0.02),
        ),
        "awning": join(*bars),
        "stripes": join(*raised),
        "window": join(
            box((pane[0], -y, 0.64), (pane[1], 0.09, 0.36), 0.01),
            both(box((x, 0, 0.66), (0.08, y * 0.5, 0.3), 0.01)),
        ),
        "door": join(
            box((door, -y, 0.54), (x * 0.24, 0.12, 0.48), 0.01),
            box((0, 0, high + 0.02), (x + 0.1, y + 0.1, 0.11), 0.03),
        ),
        "sign": box((0, -y - 0.03, z), (x * draw(0.7, 0.86), 0.09, sign), 0.03),
    }


def school(draw: Draw) -> Parts:
    """A long house of red brick, over its door a tower with a clock and a bell, a flag on top."""
    x, y, high = draw(1.36, 1.42), draw(0.47, 0.5), draw(0.96, 1.0)
    half, tall = draw(0.43, 0.45), draw(1.52, 1.56)
    front = -y - 0.14
    mid, roof, clock = front + half, tall + 0.58, tall - 0.32
    cols = [s * u for u in (half + 0.28, x - 0.27) for s in (-1, 1)]
    rows = (high * 0.36, high * 0.76)
    post = box((half - 0.07, half - 0.07, tall + 0.28), (0.09, 0.09, 0.34))
    bell = lathe([(0.23, tall + 0.16), (0.17, tall + 0.28), (0.14, tall + 0.44),
                  (0.1, roof + 0.04)], 0.02)  # fmt: skip
    return {
        "walls": join(
            box((0, 0, high / 2), (x, y, high / 2)),
            box((0, mid, tall / 2), (half, half, tall / 2)),
        ),
        "roof": join(
            hip_roof(x + 0.12, y + 0.12, high - 0.04, high + 0.38),
            moved(hip_roof(half + 0.12, half + 0.12, roof - 0.04, roof + 0.42), (0, mid, 0)),
        ),
        "trim": join(
            box((0, mid, tall), (half + 0.09, half + 0.09, 0.09), 0.02),
            moved(both(post, 0, 1), (0, mid, 0)),
            tube((0, front - 0.08, clock), (0, front + 0.2, clock), 0.3, 0.02),
            box((0, 0, 0.06), (x + 0.08, y + 0.08, 0.08)),
            box((0, front - 0.12, 0.07), (half, 0.3, 0.1)),
            box((0, front, 0.78), (0.34, 0.18, 0.08), 0.02),
            tube((0, mid, roof + 0.3), (0, mid, roof + 0.96), 0.08),
        ),
        "windows": join(
            *(box_row(cols, z, (0.14, y + 0.08, 0.13), 0) for z in rows),
            *(box_row((-0.24, 0.24), z, (0.14, 0.1, 0.13), y) for z in rows),
            *(box((0, 0, z), (x + 0.08, 0.2, 0.13), 0.02) for z in rows),
        ),
        "door": join(
            box((0, front, 0.4), (0.23, 0.1, 0.36), 0.02),
            box((0.36, mid, roof + 0.76), (0.36, 0.075, 0.22), 0.02),
        ),
        "bell": moved(bell, (0, mid, 0)),
        "hands": join(
            capsule((0, front - 0.1, clock), (0, front - 0.1, clock + 0.18), 0.065),
            capsule((0, front - 0.1, clock), (0.14, front - 0.1, clock), 0.065),
        ),
    }


def hospital(draw: Draw) -> Parts:
    """A white block with a great red cross, rows of blue windows, a canopy over the entrance."""
    x, y, high = draw(0.74, 0.8), draw(0.54, 0.58), draw(1.8, 1.9)
    wide, low = draw(1.4, 1.46), draw(0.9, 0.96)
    front = -y - 0.1
    size, arm, z = draw(0.4, 0.42), 0.14, high - 0.5
    cols = [s * (x + (wide - x) * 0.5) for s in (-1, 1)]
    rows = (low * 0.36, low * 0.74)
    return {
        "walls": join(
            box((0, 0, high / 2), (x, y + 0.1, high / 2), 0.02),
            box((0, 0.04, low / 2), (wide, y - 0.06, low / 2), 0.02),
        ),
        "roof": join(
            box((0, 0, high), (x + 0.07, y + 0.17, 0.07), 0.02),
            box((0, 0.04, low), (wide + 0.07, y + 0.01, 0.07), 0.02),
            box((0, 0, 0.04), (wide + 0.07, y + 0.14, 0.08), 0.02),
        ),
        "windows": join(
            *(box_row(cols, v, (0.22, y + 0.04, 0.12), 0) for v in rows),
            *(box((0, 0.04, v), (wide + 0.06, 0.28, 0.12), 0.02) for v in rows),
            box_row((-x * 0.62, 0, x * 0.62), low * 0.92, (0.17, y + 0.16, 0.11), 0),
            *(box((0, 0, v), (x + 0.06, 0.34, 0.11), 0.02) for v in (high * 0.66, high * 0.84)),
            both(box((x * 0.64, front, low * 0.36), (0.15, 0.06, 0.15), 0.02)),
        ),
        "cross": both(join(
            box((0, -front + 0.02, z), (size, 0.08, arm)),
            box((0, -front + 0.02, z), (arm, 0.08, size)),
        ), 1),
        "canopy": join(
            box((0, front - 0.22, 0.64), (0.42, 0.3, 0.08), 0.02),
            both(tube((0.33, front - 0.42, 0), (0.33, front - 0.42, 0.64), 0.07)),
            box((0, front - 0.24, 0.03), (0.42, 0.3, 0.07), 0.02),
        ),
        "door": box((0, front, 0.3), (0.24, 0.08, 0.3), 0.02),
    }  # fmt: skip


def factory(draw: Draw) -> Parts:
    """A hall with a saw-tooth roof, windows and a gate; two chimneys with bands."""
    x, y, eave = draw(1.05, 1.35), draw(0.6, 0.95), draw(0.85, 1.2)
    tooth, high, r = draw(0.4, 0.54), draw(2.2, 2.7), draw(0.2, 0.25)
    step = 2 * x / 3
    teeth = [prism([(-x + step * k, eave - 0.15), (-x + step * k, eave + tooth),
                    (-x + step * (k + 1), eave + 0.08), (-x + step * (k + 1), eave - 0.15)], 1,
                   y + 0.06) for k in range(3)]  # fmt: skip
    back = y + 0.1
    stacks = [(x * 0.1, high), (x * 0.72, high - 0.32)]
    return {
        "hall": join(
            box((0, 0, eave / 2), (x, y, eave / 2)),
            box((x * 0.2, back, 0.5), (x * 0.76, 0.34, 0.5)),
        ),
        "roof": join(*teeth),
        "chimneys": join(*(lathe([(r + 0.1, 0), (r, top)], 0.0, (u, back)) for u, top in stacks)),
        "bands": join(*(tube((u, back, top - d - 0.2), (u, back, top - d), r + 0.1, 0.02)
                        for u, top in stacks for d in (0.0, 0.42))),
        "windows": join(
            *(box((-x + step * (k + 0.5), -y, eave * 0.66), (step * 0.32, 0.05, 0.16), 0.01)
              for k in range(3)),
            both(box((x, 0, eave * 0.6), (0.05, y * 0.6, 0.17), 0.01)),
        ),
        "gate": join(
            box((-x + step * 1.5, -y, 0.2), (step * 0.36, 0.06, 0.22), 0.01),
            box((-x + step * 2.5, -y, 0.19), (0.16, 0.06, 0.2), 0.01),
        ),
    }  # fmt: skip


def gas_station(draw: Draw) -> Parts:
    """A flat roof with a band on two posts, two pumps with hoses on their islands."""
    x, y, high = draw(1.15, 1.48), draw(0.65, 1.0), draw(1.7, 2.35)
    post, pump, tall = draw(0.12, 0.2), draw(0.22, 0.32), draw(0.9, 1.25)
    at, deep = x * 0.52, 0.2
    front = -0.28
    hose = [(at + pump, front, tall * 0.82), (at + pump + 0.2, front, tall * 0.7),
            (at + pump + 0.2, front, tall * 0.36),
            (at + pump - 0.02, front, tall * 0.3)]  # fmt: skip
    return {
        "roof": box((0, 0, high + 0.1), (x, y, 0.14), 0.03),
        "band": box((0, 0, high + 0.12), (x + 0.05, y + 0.05, 0.07), 0.02),
        "posts": join(
            both(box((at, 0.1, high / 2), (post, post, high / 2))),
            box((0, 0, 0.07), (x * 0.98, y * 0.8, 0.07), 0.03),
        ),
        "pumps": both(box((at, front, tall / 2 + 0.06), (pump, deep, tall / 2), 0.06)),
        "screens": both(
            join(
                box((at, front - deep, tall * 0.78), (pump - 0.08, 0.05, 0.14), 0.02),
                box((at, front - deep, tall * 0.4), (pump - 0.1, 0.05, 0.1), 0.02),
            )
        ),
        "hoses": both(limb(hose, 0.085, 0.085)),
    }


def church(draw: Draw) -> Parts:
    """A nave behind a tower with a spire."""
    x, y, wall = draw(0.5, 0.58), draw(0.75, 0.85), draw(0.72, 0.85)
    ridge, side, high = wall + draw(0.5, 0.62), draw(0.27, 0.32), draw(1.35, 1.55)
    front = -y + 0.1
    nave = [(-x, 0), (x, 0), (x, wall), (0, ridge), (-x, wall)]
    roof = [
        (-x - 0.1, wall - 0.1),
        (0, ridge + 0.0),
        (x + 0.1, wall - 0.1),
        (x + 0.1, wall + 0.06),
        (0, ridge + 0.17),
    ]
    spire = moved(
        turned(around(4, prism([(0, 0), (side + 0.1, 0), (0, draw(0.85, 1.0))], 1, 0.6)), 2, 0),
        (0, front, high),
    )
    return {
        "walls": join(prism(nave, 1, y), box((0, front, high / 2), (side, side, high / 2))),
        "roof": join(prism([*roof, (-x - 0.1, wall + 0.06)], 1, y + 0.08), spire),
        "door": box((0, front - side, 0.28), (0.16, 0.08, 0.28), 0.02),
        "windows": join(
            both(
                join(*(box((x, y * s, wall * 0.55), (0.06, 0.1, 0.2), 0.02) for s in (-0.05, 0.55)))
            ),
            tube((0, front - side - 0.06, high * 0.72), (0, front, high * 0.72), 0.14),
        ),
    }


HOUSES_TO_WORK_IN = {
    "barn": barn,
    "greenhouse": greenhouse,
    "shop": shop,
    "school": fitted(school),
    "hospital": fitted(hospital),
    "factory": factory,
    "gas station": gas_station,
    "church": church,
}
