"""Desks, shelves and cabinets, and a grandfather clock."""

from typing import NamedTuple

from core.prior.draw import Draw
from core.prior.solids import (
    Parts,
    Solid,
    ball,
    both,
    box,
    capsule,
    cut,
    join,
    lathe,
    prism,
    smooth_curve,
    tube,
)
from core.prior.things.shared.furniture_parts import clock_dial, feet


class _Drawers(NamedTuple):
    """Rows and columns of drawers over ``middle`` ± ``half``, between two heights."""

    middle: float
    low: float
    high: float
    half: float
    rows: int
    columns: int = 1

    def cells(self) -> tuple[float, float, list[tuple[float, float]]]:
        """Half of a drawer's width, its height, and all their middles."""
        wide, high = self.half / self.columns, (self.high - self.low) / self.rows
        across = [self.middle - self.half + wide * (2 * c + 1) for c in range(self.columns)]
        return (
            wide,
            high,
            [(u, self.low + high * (r + 0.5)) for r in range(self.rows) for u in across],
        )

    def knobbed(self, y: float) -> tuple[Solid, Solid]:
        """Fronts that stand out from the plane ``y``, and their knobs."""
        wide, high, cells = self.cells()
        fronts = (
            box((u, y - 0.04, v), (wide - 0.07, 0.1, high / 2 - 0.075), 0.02) for u, v in cells
        )
        return join(*fronts), join(*(ball((u, y - 0.18, v), 0.1) for u, v in cells))

    def barred(self, y: float) -> tuple[Solid, Solid]:
        """Fronts that stand out from the plane ``y``, and their bars."""
        wide, high, cells = self.cells()
        fronts = (
            box((u, y - 0.04, v), (wide - 0.06, 0.1, high / 2 - 0.075), 0.02) for u, v in cells
        )
        bars = (box((u, y - 0.17, v), (wide * 0.4, 0.1, 0.07), 0.02) for u, v in cells)
        return join(*fronts), join(*bars)


def desk(draw: Draw) -> Parts:
    """A board on one or two chests of drawers, slim legs where there is but one."""
    x, y, high, half = draw(1.1, 1.3), draw(0.58, 0.68), draw(1.15, 1.3), draw(0.35, 0.4)
    right, deep, leg = x - half - 0.05, y - 0.2, x / 15
    fronts, bars = _Drawers(right, 0.08, high - 0.05, half - 0.02, 2).barred(-deep)
    side = box((right, 0, high / 2), (half, deep, high / 2), 0.02)
    panel = box((0, deep - 0.1, high * 0.7), (x - 0.1, leg, high * 0.3))
    if draw.chance(0.4):
        fronts, bars, side = both(fronts), both(bars), both(side)
    else:
        post = box((0.05 + leg - x, deep - leg, high / 2), (leg, leg, high / 2), 0.02)
        side = join(side, both(post, 1))
    return {
        "top": box((0, 0, high + 0.06), (x, y, 0.085), 0.03),
        "body": join(side, panel),
        "drawers": fronts,
        "handles": bars,
    }


def bookshelf(draw: Draw) -> Parts:
    """Three boards with thick books, apart from one another, in three colours."""
    x, y, high, wall = draw(0.74, 0.85), draw(0.3, 0.36), draw(1.9, 2.2), 0.11
    shelves, each, apart, back = 3, 4, 0.1, 0.14
    gap, wide = (high - wall) / shelves, 2 * (x - wall)
    rooms = (
        box((0, -back, wall + gap * k + (gap - wall) / 2), (wide / 2, y, (gap - wall) / 2))
        for k in range(shelves)
    )
    rows: list[list[Solid]] = [[], [], []]
    thick, order = (wide - apart * (each + 1)) / each, draw.which(2)
    for k in range(shelves):
        for book in range(each):
            if (k, book) == ((0, 3), (2, 3))[order]:
                continue
            tall = (gap - wall) * (0.78, 0.62, 0.72, 0.56)[(book + k + order) % 4] / 2
            u = -wide / 2 + apart + thick / 2 + (thick + apart) * book
            # A little sunk into the boards: of what only touches, the surfaces lie in each other.
            at = (u, -0.02, wall + gap * k + tall - 0.03)
            rows[(book + 2 * k) % 3].append(box(at, (thick / 2, y - 0.08, tall)))
    return {
        "frame": cut(box((0, 0, high / 2), (x, y, high / 2)), *rooms),
        "books": join(*rows[0]),
        "volumes": join(*rows[1]),
        "tomes": join(*rows[2]),
    }


def shelf(draw: Draw) -> Parts:
    """A board on two brackets with a few things on it."""
    x, y = draw(1.1, 1.35), draw(0.32, 0.4)
    bracket = prism([(y, 0.0), (y, -0.65), (y - 0.18, -0.65), (-y * 0.7, 0.0)], 0, 0.1, x * 0.66)
    tall = draw(0.4, 0.6)
    books = [
        box((-x * 0.75 + 0.25 * k, 0.02, 0.05 + h * tall), (0.115, y - 0.1, h * tall))
        for k, h in enumerate((0.85, 1.0, 0.75))
    ]
    pot = lathe(
        smooth_curve([(0.16, 0.05), (0.28, 0.3), (0.14, 0.55), (0.2, 0.66)]), 0.02, (x * 0.55, 0)
    )
    return {
        "board": box((0, 0, 0), (x, y, 0.11), 0.02),
        "brackets": both(bracket),
        "books": join(*books),
        "vase": pot,
    }


def cabinet(draw: Draw) -> Parts:
    """Low and wide with two or four doors on short legs."""
    y, leg, high = draw(0.4, 0.5), draw(0.2, 0.35), draw(1.1, 1.5)
    pairs = 1 + draw.chance(0.5)
    x = draw(0.85, 1.05) if pairs == 1 else draw(1.15, 1.3)
    width, middle = x / pairs, (leg + high) / 2
    doors = [
        box(
            (width * (k + 0.5), -y - 0.04, middle),
            (width / 2 - 0.075, 0.1, (high - leg) / 2 - 0.08),
        )
        for k in range(pairs)
    ]
    # On both sides of where two doors meet.
    at = (0.2,) if pairs == 1 else (width - 0.2, width + 0.2)
    knobs = [box((u, -y - 0.16, middle), (0.075, 0.09, 0.17), 0.03) for u in at]
    return {
        "body": box((0, 0, middle), (x, y, (high - leg) / 2), 0.02),
        "doors": both(join(*doors)),
        "handles": both(join(*knobs)),
        "legs": feet(x - 0.16, y - 0.14, leg + 0.1, 0.12),
        "top": box((0, -0.06, high + 0.06), (x + 0.09, y + 0.15, 0.09), 0.02),
    }


def wardrobe(draw: Draw) -> Parts:
    """Two high doors, a ledge above, perhaps a drawer below."""
    x, y, high = draw(0.75, 0.95), draw(0.38, 0.48), draw(2.1, 2.5)
    low = 0.68 if draw.has("drawer", 0.5) else 0.2
    door = box(
        (x / 2, -y - 0.04, (low + high - 0.14) / 2), (x / 2 - 0.075, 0.1, (high - 0.14 - low) / 2)
    )
    body = box((0, 0, high / 2 + 0.06), (x, y, high / 2 - 0.06), 0.02)
    ledge = box((0, -0.06, high), (x + 0.09, y + 0.15, draw(0.1, 0.13)), 0.02)
    fronts, knobs = both(door), both(ball((0.17, -y - 0.18, high * 0.52), 0.1))
    if low > 0.5:
        fronts = join(fronts, box((0, -y - 0.04, 0.36), (x - 0.075, 0.1, 0.18), 0.02))
        knobs = join(knobs, both(ball((x / 2, -y - 0.18, 0.36), 0.1)))
    return {
        "body": body,
        "doors": fronts,
        "handles": knobs,
        "feet": both(box((x - 0.14, y - 0.14, 0.1), (0.13, 0.13, 0.1), 0.03), 0, 1),
        "top": ledge,
    }


def dresser(draw: Draw) -> Parts:
    """A chest of two or three rows of drawers under a top that stands out."""
    x, y, leg = draw(0.8, 1.15), draw(0.42, 0.5), draw(0.14, 0.36)
    rows = 2 + draw.chance(0.5)
    high = leg + rows * draw(0.48, 0.56)
    fronts, knobs = _Drawers(0, leg + 0.05, high - 0.06, x - 0.03, rows, 2).knobbed(-y)
    return {
        "body": box((0, 0, (leg + high) / 2), (x, y, (high - leg) / 2), 0.02),
        "drawers": fronts,
        "handles": knobs,
        "legs": feet(x - 0.16, y - 0.14, leg + 0.1, 0.13),
        "top": box((0, -0.06, high + 0.06), (x + 0.09, y + 0.15, 0.09), 0.02),
    }


def nightstand(draw: Draw) -> Parts:
    """A small table with one or two drawers."""
    x, y, leg = draw(0.55, 0.68), draw(0.46, 0.54), draw(0.3, 0.65)
    rows = 1 + draw.chance(0.6)
    high = leg + 0.12 + rows * draw(0.36, 0.44)
    fronts, knobs = _Drawers(0, leg + 0.05, high - 0.06, x - 0.03, rows).knobbed(-y)
    return {
        "body": box((0, 0, (leg + high) / 2), (x, y, (high - leg) / 2), 0.02),
        "drawers": fronts,
        "handles": knobs,
        "legs": feet(x - 0.12, y - 0.12, leg + 0.1, 0.115),
        "top": box((0, -0.06, high + 0.06), (x + 0.1, y + 0.15, 0.08), 0.02),
    }


def grandfather_clock(draw: Draw) -> Parts:
    """A high case: the dial in its head, the pendulum behind glass."""
    x, y, high = draw(0.4, 0.48), draw(0.3, 0.36), draw(2.3, 2.7)
    base, head = draw(0.45, 0.6), high - 0.85
    face, hands = clock_dial(-y - 0.04, high - 0.42, x * 0.8)
    roof = [
        (-x - 0.1, high),
        (x + 0.1, high),
        (x * 0.4, high + draw(0.2, 0.34)),
        (-x * 0.4, high + 0.2),
    ]
    z = (base + head) / 2
    return {
        "body": join(
            box((0, 0, base / 2), (x + 0.06, y + 0.05, base / 2), 0.02),
            box((0, 0, z), (x - 0.06, y - 0.06, (head - base) / 2 + 0.1)),
            box((0, 0, high - 0.42), (x + 0.05, y + 0.02, 0.45), 0.02),
            prism(roof, 1, y + 0.04),
        ),
        "face": face,
        "hands": hands,
        "glass": box((0, -y + 0.05, z), (x * 0.56, 0.05, (head - base) / 2 - 0.06)),
        "pendulum": join(
            capsule((0, -y, z + 0.3), (0, -y, z - 0.1), 0.07),
            tube((0, -y - 0.07, z - 0.2), (0, -y + 0.06, z - 0.2), 0.16),
        ),
    }


CABINETS = {
    "desk": desk,
    "bookshelf": bookshelf,
    "shelf": shelf,
    "cabinet": cabinet,
    "wardrobe": wardrobe,
    "dresser": dresser,
    "nightstand": nightstand,
    "grandfather clock": grandfather_clock,
}
