"""Books, writing materials and boards."""

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
    grown,
    join,
    lathe,
    mirrored,
    moved,
    prism,
    ring,
    tilted,
    tube,
    turned,
    within,
)


def pen(draw: Draw) -> Parts:
    """A fountain pen that leans, its golden nib down: a thick body, bands, a clip on its cap."""
    r, lean = draw(0.27, 0.29), 35

    def leaning(solid: Solid) -> Solid:
        """What is made upright about z = 1.5."""
        return moved(turned(moved(solid, (0, 0, -1.5)), 1, lean), (0, 0, 1.5))

    nib = prism(mirrored([(0.02, -0.02), (0.08, 0.04), (0.26, 0.44), (0.2, 0.72)]), 1, 0.3)
    shell = lathe([(0.07, -0.02), (0.24, 0.48), (0.22, 0.72)], 0.01)
    clip = join(
        box((0, -r - 0.14, 2.36), (0.09, 0.08, 0.42), 0.05),
        box((0, -r, 2.7), (0.09, 0.2, 0.09), 0.04),
        ball((0, -r - 0.12, 1.98), 0.13),
    )
    rims = ((0.98, r + 0.03), (1.82, r + 0.06))
    return {
        "body": leaning(join(
            lathe([(r * 0.86, 0.96), (r, 1.2), (r + 0.01, 1.9)], 0.01),
            lathe([(r + 0.03, 1.8), (r + 0.03, 2.6), (r * 0.8, 2.88)], 0.01),
        )),
        "grip": leaning(lathe([(0.18, 0.6), (0.2, 0.68), (r * 0.82, 1.0)], 0.02)),
        "nib": leaning(within(shell, nib)),
        "hole": leaning(egg((0, -0.21, 0.46), (0.1, 0.12, 0.12))),
        "bands": leaning(join(*(tube((0, 0, v - 0.07), (0, 0, v + 0.07), e, 0.02)
                                for v, e in rims), egg((0, 0, 2.92), (0.2, 0.2, 0.12)))),
        "clip": leaning(clip),
    }  # fmt: skip


def notebook(draw: Draw) -> Parts:
    """A notebook that stands, bound by bold rings at its left side; a label, an elastic band."""
    x, y, z = draw(0.78, 0.84), draw(0.23, 0.26), draw(1.06, 1.12)
    low = 0.05
    rings = [ring((-x + 0.02, 0, low + z * (0.17 + 0.33 * k)), y + 0.12, 0.08) for k in range(6)]
    return {
        "cover": both(box((0, y, low + z), (x, 0.075, z), 0.05), 1),
        "pages": box((0.02, 0, low + z), (x - 0.08, y + 0.02, z - 0.08)),
        "rings": join(*rings),
        "label": box((0.02, -y - 0.06, low + z * 1.34), (x * 0.5, 0.09, z * 0.22), 0.05),
        "band": box((x * 0.74, 0, low + z), (0.085, y + 0.15, z + 0.07), 0.04),
    }


def ruler(draw: Draw) -> Parts:
    """It stands on its long edge, with long and short marks along the upper one."""
    x, z, y = draw(1.25, 1.35), draw(0.2, 0.25), draw(0.06, 0.075)
    count, out = 9, y + 0.035
    pitch = 2 * (x - 0.12) / (count - 1)
    marks = []
    for k in range(count):
        u, long = k * pitch - x + 0.12, 0.62 if k % 2 == 0 else 0.34
        marks.append(box((u, 0, 2 * z - long * z), (0.045, out, long * z)))
    return {
        "body": box((0, 0, z), (x, y, z)),
        "marks": join(*marks),
    }


def envelope(draw: Draw) -> Parts:
    """Upright, its closed flap to the front with a seal of wax on it."""
    x, z, y = draw(1.15, 1.3), draw(0.75, 0.85), 0.1
    tip, seal, low = draw(0.85, 1.0) * z, draw(0.19, 0.23), draw(0.12, 0.2) * z
    flap = [(x, 2 * z), (-x, 2 * z), (-0.05, tip), (0.05, tip)]
    sides = [(x, 0.02), (x, 2 * z - 0.02), (low, z)]
    bottom = [(-x, 0.0), (x, 0.0), (0.0, z * 1.08)]
    return {
        "body": box((0, 0, z), (x, y, z), 0.01),
        "sides": both(prism(sides, 1, 0.05, -y + 0.01)),
        "bottom": prism(bottom, 1, 0.05, -y - 0.015),
        "flap": prism(flap, 1, 0.07, -y - 0.04),
        "seal": tube((0, -y - 0.19, tip + 0.06), (0, -y, tip + 0.06), seal, 0.03),
    }


def clipboard(draw: Draw) -> Parts:
    """A board that leans back a little, with a ticked list of lines under a clip."""
    wide, high, y = draw(0.72, 0.82), draw(1.96, 2.14), 0.09
    rows, lean = 3 + draw.which(3), draw(6, 14)
    step = (high - 0.62) / rows
    bars, boxes = [], []
    for k in range(rows):
        z = 0.18 + step * (k + 0.5)
        short = 0.16 * (k % 2)
        bars.append(box((0.16 - short / 2, -y - 0.08, z), (wide - 0.42 - short / 2, 0.06, 0.07)))
        boxes.append(box((0.27 - wide, -y - 0.09, z), (0.09, 0.07, 0.09), 0.01))
    hook = cut(
        tube((0, -0.08, high), (0, 0.08, high), 0.24, 0.02),
        tube((0, -1, high + 0.04), (0, 1, high + 0.04), 0.1),
    )
    jaw = [(-0.44, high - 0.3), (0.44, high - 0.3), (0.34, high - 0.04), (-0.34, high - 0.04)]
    parts = {
        "board": box((0, 0, high / 2), (wide, y, high / 2), 0.06),
        "paper": box((0, -y, high / 2 - 0.06), (wide - 0.1, 0.065, high / 2 - 0.16)),
        "lines": join(*bars),
        "boxes": join(*boxes),
        "clip": join(grown(prism(jaw, 1, 0.12, -y - 0.04), 0.03), hook),
        "bar": tube((-0.42, -y - 0.16, high - 0.3), (0.42, -y - 0.16, high - 0.3), 0.09, 0.02),
    }
    return {name: turned(solid, 0, -lean) for name, solid in parts.items()}


def notice_board(draw: Draw) -> Parts:
    """Cork in a frame of wood, with notes of three colours that hang from round pins."""
    wide, high, y = draw(1.0, 1.14), draw(0.78, 0.9), 0.07
    layout, rim = draw.arranged(3), 0.075
    colors: list[list[Solid]] = [[], [], []]
    pins = []
    for column_ in range(3):
        for row in range(2):
            u = (column_ - 1) * (wide - rim) * 0.62 + layout(-0.05, 0.05)
            v = high + (row - 0.5) * (high - rim) * 0.92 + layout(-0.03, 0.03)
            half_u, half_v = layout(0.17, 0.22), layout(0.17, 0.23)
            sheet = turned(box((0, 0, 0), (half_u, 0.06, half_v)), 1, layout(-9, 9))
            colors[(column_ + 2 * row) % 3].append(moved(sheet, (u, -y - 0.02, v)))
            pins.append(ball((u, -y - 0.11, v + half_v * 0.62), 0.075))
    frame = cut(
        box((0, 0, high), (wide, 0.13, high), 0.02),
        box((0, -1, high), (wide - 2 * rim, 1, high - 2 * rim)),
    )
    papers, notes, cards = (join(*some) for some in colors)
    return {
        "frame": frame,
        "cork": box((0, 0, high), (wide - rim, y, high - rim)),
        "paper": papers,
        "notes": notes,
        "cards": cards,
        "pins": join(*pins),
    }


def map_pin(draw: Draw) -> Parts:
    """A thick drop on its point: with a round hole, or with a disc on each side."""
    r, z, half, edge = draw(0.78, 0.86), draw(1.5, 1.64), draw(0.24, 0.3), 0.06
    small, inner = r - edge, r * draw(0.42, 0.48)
    # The sides touch the circle at this angle below its middle.
    first = -math.asin(small / (z - 0.1))
    angles = (first + (math.pi / 2 - first) * k / 10 for k in range(11))
    side = [(0.0, 0.1), *((small * math.cos(a), z + small * math.sin(a)) for a in angles)]
    drop = grown(prism(mirrored(side), 1, half - edge), edge)
    if draw.chance(0.5):
        return {"body": cut(drop, tube((0, -1, z), (0, 1, z), inner))}
    deep = half + 0.09
    return {"body": drop, "disc": tube((0, -deep, z), (0, deep, z), inner + 0.06, 0.03)}


def _tome(x: float, y: float, half: float) -> dict[str, Solid]:
    """A thick book that lies, its round spine to the front, two bands about that."""
    board, bulge, inner = 0.18, 0.12, half - 0.18

    def spine(out: float, high: float) -> list[tuple[float, float]]:
        turns = (math.radians(90 - 22.5 * k) for k in range(9))
        return [(-y - out * math.cos(a), high * math.sin(a)) for a in turns]

    cover = [(y, half), *spine(bulge, half), (y, -half), (y, -inner), (board - y, -inner),
             (board - y, inner), (y, inner)]  # fmt: skip
    band = [(0.1 - y, half - 0.05), *spine(bulge + 0.1, half - 0.05), (0.1 - y, 0.05 - half)]
    return {
        "cover": prism(cover, 0, x),
        "pages": box((0, 0, 0), (x - 0.1, y - 0.1, inner + 0.05)),
        "bands": both(prism(band, 0, 0.11, x * 0.58)),
    }


def stack_of_books(draw: Draw) -> Parts:
    """Four thick books that lie on one another, each smaller than the one below and turned."""
    layout, scale, z = draw.arranged(2), draw(0.95, 1.05), 0.0
    sizes = [(1.04, 0.74, 0.3), (0.94, 0.68, 0.265), (0.84, 0.62, 0.285), (0.7, 0.54, 0.265)]
    laid: list[dict[str, Solid]] = []
    for k, (x, y, half) in enumerate(sizes):
        # The second one's back is behind.
        turn = layout(7, 13) * (1, -1, 1, -1)[k] + 180 * (k == 1)
        at = (layout(-0.07, 0.07), layout(-0.04, 0.04), z + half)
        tome = _tome(x * scale, y, half)
        laid.append({name: moved(turned(solid, 2, turn), at) for name, solid in tome.items()})
        z += 2 * half - 0.05
    covers = [tome["cover"] for tome in laid]
    return {
        "books": join(covers[0], covers[3]),
        "tomes": covers[1],
        "volumes": covers[2],
        "pages": join(*(tome["pages"] for tome in laid)),
        "bands": join(*(tome["bands"] for tome in laid)),
    }


def easel(draw: Draw) -> Parts:
    """Three legs of wood, a painting on a ledge."""
    lean, spread, high = draw(9, 13), draw(0.62, 0.72), draw(2.25, 2.45)
    x, z, ledge = draw(0.66, 0.78), draw(0.5, 0.58), draw(0.72, 0.8)
    back, low, sun = draw(0.75, 0.9), ledge + 0.1, draw(0.12, 0.15)
    middle = low + z
    front = capsule((spread, 0, 0.09), (0.12, 0, high), 0.09)
    y = -0.09
    hill = [(-x + 0.08, low + 0.08), (x - 0.08, low + 0.08), (x - 0.08, low + z * 0.75)]
    hill += [(x * 0.45, low + z * 1.15), (0.0, low + z * 0.6), (-x * 0.45, low + z * 0.95)]
    hill += [(-x + 0.08, low + z * 0.55)]
    parts = {
        "legs": join(both(front), box((0, 0.02, high - 0.2), (0.24, 0.07, 0.08), 0.02)),
        "ledge": box((0, -0.16, ledge), (x + 0.06, 0.2, 0.085), 0.02),
        "canvas": box((0, y - 0.06, middle), (x, 0.08, z)),
        "picture": box((0, y - 0.08, middle), (x - 0.08, 0.09, z - 0.08)),
        "hills": prism(hill, 1, 0.05, y - 0.16),
        "sun": tube((x * 0.42, y - 0.21, middle + z * 0.5), (x * 0.42, y, middle + z * 0.5), sun),
    }
    # The whole front leans back against the third leg.
    leaning = {name: tilted(solid, -lean, (0, 0, 0)) for name, solid in parts.items()}
    slope = math.sin(math.radians(lean))
    stay = capsule((0, back, 0.09), (0, slope * (high - 0.2), high * 0.97 - 0.2), 0.09)
    return leaning | {"legs": join(leaning["legs"], stay)}


def abacus(draw: Draw) -> Parts:
    """A standing frame; on each of its five rods four beads of one colour, some pushed aside."""
    x, high, deep = draw(0.95, 1.05), draw(1.55, 1.7), draw(0.13, 0.17)
    wall, rows, r = 0.1, 5, draw(0.125, 0.135)
    frame = cut(
        box((0, 0, high / 2), (x, deep, high / 2)),
        box((0, 0, high / 2), (x - 2 * wall, 1, high / 2 - 2 * wall)),
    )
    feet = both(box((x - wall, 0, 0.06), (wall + 0.02, deep + 0.16, 0.08)))
    rods, beads = [], ([], [], [])
    left, pitch = -x + 2 * wall + 0.17, 0.31
    aside = draw.which(2)
    room = 2 * (x - 2 * wall) - 0.34 - 3 * pitch
    for k in range(rows):
        z = wall * 2 + (high - 4 * wall) * (k + 0.5) / rows
        rods.append(tube((-x + wall, 0, z), (x - wall, 0, z), 0.05))
        here = (1 + 2 * k + aside) % 5  # how many are on the left
        for i in range(4):
            u = left + pitch * i + (room if i >= here else 0.0)
            beads[k % 3].append(egg((u, 0, z), (0.115, r + 0.02, r)))
    return {
        "frame": join(frame, feet),
        "rods": join(*rods),
        "beads": join(*beads[0]),
        "counters": join(*beads[1]),
        "pearls": join(*beads[2]),
    }


SCHOOL = {
    "pen": pen,
    "notebook": notebook,
    "ruler": ruler,
    "envelope": envelope,
    "clipboard": clipboard,
    "notice board": notice_board,
    "map pin": map_pin,
    "stack of books": stack_of_books,
    "easel": easel,
    "abacus": abacus,
}
