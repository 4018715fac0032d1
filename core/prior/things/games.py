"""Pieces and equipment of games and sports."""

import math

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    around,
    ball,
    both,
    box,
    capsule,
    cut,
    join,
    lathe,
    moved,
    prism,
    ring,
    smooth_curve,
    taper,
    tube,
)


def dice(draw: Draw) -> Parts:
    """One, its spots proud of its faces by a hair; opposite faces add to seven."""
    half, r = 0.8, draw(0.15, 0.185)
    side = half * draw(0.46, 0.52)
    two, three = [(-1, 1), (1, -1)], [(-1, 1), (0, 0), (1, -1)]
    four = [*two, (-1, -1), (1, 1)]
    faces = [(1, -1, [(0, 0)]), (2, 1, two), (0, 1, three)]
    faces += [(0, -1, four), (2, -1, [*four, (0, 0)]), (1, 1, [*four, (-1, 0), (1, 0)])]
    spots = []
    for axis, sign, places in faces:
        for u, v in places:
            near, far = ([u * side, v * side] for _ in range(2))
            near.insert(axis, sign * (half - 0.1))
            far.insert(axis, sign * (half + 0.025))
            spots.append(tube((*near,), (*far,), r, 0.02))
    body = box((0, 0, 0), (half, half, half), draw(0.1, 0.22))
    return {"body": moved(body, (0, 0, half)), "pips": moved(join(*spots), (0, 0, half))}


def chess_knight(draw: Draw) -> Parts:
    """A horse's head that looks to the front, on a turned base."""
    wide, low, thick = draw(0.56, 0.68), draw(0.4, 0.55), draw(0.2, 0.27)
    side = [(-0.38, 0), (-0.44, 0.26), (-0.18, 0.66), (-0.34, 0.7), (-0.62, 0.52), (-0.8, 0.64)]
    side += [(-0.78, 0.84), (-0.42, 1.2), (-0.22, 1.34), (0.06, 1.34), (0.3, 1.12), (0.44, 0.74)]
    side += [(0.46, 0.3), (0.4, 0)]
    crest = [(-0.36, 1.16), (-0.1, 1.46), (0.1, 1.48), (0.42, 1.22), (0.6, 0.78), (0.6, 0.26)]
    crest += [(0.3, 0.26), (0.1, 1.1)]
    ear = prism([(-0.22, 1.2), (0.06, 1.2), (-0.12, 1.66)], 0, 0.09, thick - 0.06)
    return {
        "body": moved(join(prism(side, 0, thick), both(ear)), (0, 0, low)),
        "mane": moved(prism(crest, 0, 0.1), (0, 0, low)),
        "base": lathe([(wide, 0), (wide, 0.22), (wide * 0.82, 0.22), (wide * 0.82, low + 0.06)]),
        "eyes": both(ball((thick - 0.02, -0.34, low + 0.98), 0.1)),
    }


def _piece(wide: float, waist: float, neck: float) -> list[tuple[float, float]]:
    """The turned body of a chess piece, from its base to its neck."""
    return [(wide, 0.2), (wide * 0.94, 0.36), (waist * 1.2, 0.56), (waist, neck)]


def chess_rook(draw: Draw) -> Parts:
    """A small tower with battlements on a turned base."""
    wide, waist, neck, count = (
        draw(0.55, 0.65),
        draw(0.32, 0.4),
        draw(1.2, 1.5),
        4 + 2 * draw.chance(0.5),
    )
    rim, top = waist + 0.14, neck + draw(0.4, 0.5)
    gaps = around(count, box((rim, 0, top + 0.05), (0.3, 0.1, 0.22)))
    cup = cut(
        lathe([(waist, neck), (rim, neck + 0.1), (rim, top)], 0.02),
        tube((0, 0, top - 0.2), (0, 0, top + 1), rim - 0.18),
        gaps,
    )
    return {
        "body": lathe(_piece(wide * 0.9, waist, neck + 0.05), 0.02),
        "top": cup,
        "base": tube((0, 0, 0), (0, 0, 0.24), wide, 0.06),
        "ring": ring((0, 0, neck), waist, 0.1),
    }


def chess_king(draw: Draw) -> Parts:
    """A tall piece with a crown and a cross."""
    wide, waist, neck, crown = draw(0.54, 0.62), draw(0.23, 0.28), draw(1.35, 1.55), draw(0.4, 0.48)
    top, arm = neck + draw(0.42, 0.5), draw(0.22, 0.28)
    cap = [(waist, neck), (crown, top), (crown * 0.4, top + 0.16)]
    return {
        "body": join(lathe(_piece(wide * 0.9, waist, neck + 0.05)), lathe(cap)),
        "cross": join(
            box((0, 0, top + 0.34), (0.1, 0.1, 0.34)), box((0, 0, top + 0.42), (arm, 0.1, 0.1))
        ),
        "base": tube((0, 0, 0), (0, 0, 0.24), wide),
        "rings": join(
            tube((0, 0, neck - 0.06), (0, 0, neck + 0.12), waist + 0.14),
            tube((0, 0, neck - 0.4), (0, 0, neck - 0.24), waist + 0.1),
        ),
    }


def basketball_hoop(draw: Draw) -> Parts:
    """A board with its ring and net on a pole."""
    x, half, z, r = draw(0.75, 0.9), draw(0.46, 0.55), draw(2.2, 2.4), draw(0.34, 0.4)
    low, y = z - half * 0.6, -0.2
    front = y - 0.1 - r
    net = cut(
        lathe([(r * 0.55, low - 0.55), (r + 0.02, low)], 0.02, (0, front)),
        lathe([(r * 0.55 - 0.11, low - 0.7), (r - 0.1, low + 0.1)], 0, (0, front)),
    )
    slots = around(8, box((0.3, 0, 0), (0.4, 0.045, 0.2), 0.02), 22.5)
    net = cut(net, moved(slots, (0, front, low - 0.25)))
    return {
        "board": box((0, y, z), (x, 0.1, half), 0.02),
        "ring": join(
            ring((0, front, low), r, 0.09), box((0, y - 0.08, low), (0.14, 0.12, 0.1), 0.02)
        ),
        "net": net,
        "pole": join(
            capsule((0, 0.35, 0.1), (0, 0.35, z - 0.35), 0.13),
            capsule((0, 0.35, z - 0.35), (0, y, z), 0.12),
            box((0, 0.3, 0.08), (0.55, 0.5, 0.1), 0.04),
        ),
        "square": cut(
            box((0, y - 0.02, z + 0.02), (x * 0.42, 0.11, half * 0.5)),
            box((0, y, z + 0.02), (x * 0.42 - 0.1, 1, half * 0.5 - 0.1)),
        ),
    }


def baseball_bat(draw: Draw) -> Parts:
    """Upright, its knob below."""
    long, r, thin = draw(2.5, 2.8), draw(0.19, 0.23), draw(0.09, 0.105)
    side = smooth_curve(
        [
            (thin, 0.7),
            (thin * 1.25, long * 0.42),
            (r * 0.92, long * 0.66),
            (r, long * 0.86),
            (r * 0.86, long - 0.06),
            (0.08, long),
        ]
    )
    return {
        "body": lathe([(thin * 0.95, 0.08), *side], 0.01),
        "grip": lathe([(thin + 0.02, 0.12), (thin + 0.02, draw(0.7, 0.9))], 0.015),
        "knob": tube((0, 0, 0.0), (0, 0, 0.15), thin + 0.09, 0.06),
    }


def _oval(x: float, z: float, high: float) -> list[tuple[float, float]]:
    """Corners of an ellipse in x and z about the height ``high``."""
    turns = (2 * math.pi * k / 28 for k in range(28))
    return [(x * math.cos(t), high + z * math.sin(t)) for t in turns]


def tennis_racket(draw: Draw) -> Parts:
    """Upright, its strings a plate with a coarse net in relief."""
    x, z, grip = draw(0.56, 0.64), draw(0.68, 0.74), draw(0.95, 1.1)
    y, throat = draw(0.095, 0.12), draw(0.32, 0.42)
    middle = grip + throat + z
    # The net ends within the rim.
    pitch, half = 0.19, (x - 0.06, z - 0.06)
    net = [
        box(
            (pitch * k, 0, middle),
            (0.035, 0.075, half[1] * (1 - (pitch * k / half[0]) ** 2) ** 0.5),
        )
        for k in range(-2, 3)
    ]
    net += [
        box(
            (0, 0, middle + pitch * k),
            (half[0] * (1 - (pitch * k / half[1]) ** 2) ** 0.5, 0.075, 0.035),
        )
        for k in range(-3, 4)
    ]
    fork = taper((0.06, 0, grip), (x * 0.62, 0, middle - z * 0.74), 0.1, 0.1)
    return {
        "frame": join(
            cut(
                prism(_oval(x + 0.08, z + 0.08, middle), 1, y),
                prism(_oval(x - 0.09, z - 0.09, middle), 1, 1),
            ),
            both(fork),
        ),
        "strings": join(prism(_oval(x, z, middle), 1, 0.045), *net),
        "grip": join(
            box((0, 0, grip / 2 + 0.03), (0.13, 0.12, grip / 2), 0.05),
            box((0, 0, 0.08), (0.16, 0.145, 0.08), 0.05),
        ),
    }


def dumbbell(draw: Draw) -> Parts:
    grip, bar, inner, outer = draw(0.45, 0.6), draw(0.13, 0.17), draw(0.4, 0.55), draw(0.42, 0.55)
    if draw.chance(0.5):
        ends = [tube((s * grip, 0, 0), (s * (grip + outer), 0, 0), inner, 0.06) for s in (-1, 1)]
    else:
        ends = [ball((s * (grip + inner * 0.8), 0, 0), inner) for s in (-1, 1)]
    return {"weights": join(*ends), "bar": tube((-grip - 0.1, 0, 0), (grip + 0.1, 0, 0), bar)}


GAMES = {
    "dice": dice,
    "chess knight": chess_knight,
    "chess rook": chess_rook,
    "chess king": chess_king,
    "basketball hoop": basketball_hoop,
    "baseball bat": baseball_bat,
    "tennis racket": tennis_racket,
    "dumbbell": dumbbell,
}
