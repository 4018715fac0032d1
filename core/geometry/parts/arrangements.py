"""Where another number of similar components is: arranged as the drawn ones are.

On a ring, at the corners of a rectangle, in rows and columns, in mirrored pairs, scattered around
an axis or in a heap. Each arrangement yields spots for all of them, the likeliest first; whether
they hold there is seen elsewhere (:mod:`core.geometry.parts.counted`).
"""

from collections.abc import Iterator, Sequence
from itertools import product
from typing import NamedTuple

import numpy as np
from jaxtyping import Float

EVEN = 0.13  # of a ring's radius: how far a component is off it; of the mean gap, likewise
LEVEL = 0.3  # of its height: how much higher one of them is than another at most
GAPS = 1.45  # times the mean angle between neighbours on a ring, at most
IN_LINE = 0.14  # of a row's length, its spread across
TILED = 0.45  # of its side: components with smaller gaps fill their row
APART = 1.12  # of its side, from one to the next
BEYOND = 1.35  # of the drawn span: how much longer a row may become
# The size of the odd one above a pair, and how far above it is, of the height of one.
LIFTS = ((1.0, 0.85), (1.0, 1.0), (0.75, 0.7), (0.75, 0.85), (0.6, 0.65), (0.6, 0.8))
SHRUNK = (1.0, 0.94, 0.86, 0.78, 0.7)  # of its size: what has too little room in a heap
OBLONG = 1.15  # times as long as wide is a rectangle; others are a ring of four
INNER = 1.25  # of its width: how much smaller the next ring inwards is
TOGETHER = 1.3  # of its width: how far the middle of the next one in a heap is at most
TRIES = 160  # places of a scattered one
ALIKE = 0.5  # of its side: places of a row or a column that differ by less are one

Points = Float[np.ndarray, "k 3"]
Matrix = Float[np.ndarray, "3 3"]


class Spot(NamedTuple):
    """A copy of one of the drawn components, with its middle in another place."""

    source: int  # among the drawn ones
    at: Float[np.ndarray, " 3"]
    turn: Matrix = np.eye(3)
    scale: Float[np.ndarray, " 3"] = np.ones(3)  # along its own axes, before the turn
    stays: bool = False  # where it was drawn, or as firm as there


def arrangements(middles: Points, sizes: Points, count: int) -> Iterator[Sequence[Spot]]:
    """Spots for ``count`` components, from the drawn ones' middles and sizes."""
    for arranged in (_tiles, _corners, _ring, _pairs, _row, _fewer, _scattered, _heaped):
        yield from arranged(middles, sizes, count)


def _turned(angle: float) -> Matrix:
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])


def _mirrored(middles: Points) -> bool:
    """Whether two are each other's mirror image across x = 0."""
    return len(middles) == 2 and bool(
        np.abs(middles[0] * (-1, 1, 1) - middles[1]).max() < EVEN * np.ptp(middles[:, 0])
    )


def _round(middles: Points, sizes: Points) -> tuple[Float[np.ndarray, " 2"], float] | None:
    """The middle and the radius of the regular ring that they are on."""
    if len(middles) < 3 or np.ptp(middles[:, 2]) > LEVEL * sizes[:, 2].mean():
        return None
    flat = middles[:, :2]
    # x² + y² = 2 a x + 2 b y + c
    rows = np.c_[2 * flat, np.ones(len(flat))]
    a, b, c = np.linalg.lstsq(rows, (flat**2).sum(1), rcond=None)[0]
    middle, radius = np.array([a, b]), float(np.sqrt(max(c + a * a + b * b, 0)))
    away = flat - middle
    off = np.abs(np.linalg.norm(away, axis=1) - radius).max()
    angles = np.sort(np.arctan2(away[:, 1], away[:, 0]))
    gaps = np.diff(np.r_[angles, angles[0] + 2 * np.pi])
    regular = gaps.max() <= GAPS * 2 * np.pi / len(middles)
    return (middle, radius) if regular and off <= EVEN * radius else None


def _ring(middles: Points, sizes: Points, count: int) -> Iterator[list[Spot]]:
    """At equal angles, around the vertical, or as a fan's blades."""
    yield from _level_ring(middles, sizes, count)
    for order in ([0, 2, 1], [2, 1, 0]):  # turns an axis to the vertical
        spots = list(_level_ring(middles[:, order], sizes[:, order], count, np.pi / 2))
        for one in spots if count > 1 else ():
            yield [
                spot._replace(at=spot.at[order], turn=spot.turn[np.ix_(order, order)])
                for spot in one
            ]


def _level_ring(
    middles: Points, sizes: Points, count: int, first: float = -np.pi / 2
) -> Iterator[list[Spot]]:
    """Around the vertical; what has no room there, on rings within."""
    found = _round(middles, sizes)
    if found is None:
        return
    middle, radius = found
    away = middles[:, :2] - middle
    angles = np.arctan2(away[:, 1], away[:, 0])
    if count == 1:
        yield [Spot(0, np.array([*middle, middles[:, 2].mean()]))]
        return
    width = float(sizes[:, :2].max(1).mean())
    for outer in range(count, max(count // 2, 1), -1):
        spots = list(_on_ring(outer, (middle, radius), middles, angles, first))
        rest, inner = count - outer, radius - INNER * width
        if rest > 1 and inner <= 0.5 * width:
            return
        if rest == 1:
            spots.append(Spot(0, np.array([*middle, middles[:, 2].mean()])))
        elif rest:
            spots += _on_ring(rest, (middle, inner), middles, angles, first)
        yield spots


def _on_ring(
    count: int,
    circle: tuple[Float[np.ndarray, " 2"], float],
    middles: Points,
    angles: Float[np.ndarray, " k"],
    first: float,
) -> Iterator[Spot]:
    """Symmetric about x = 0: where they are odd, one is at the angle ``first``."""
    middle, radius = circle
    begin = first + (np.pi / count if count % 2 == 0 else 0.0)
    for k in range(count):
        angle = begin + 2 * np.pi * k / count
        off = np.abs((angles - angle + np.pi) % (2 * np.pi) - np.pi)
        source = int(off.argmin())
        at = middle + radius * np.array([np.cos(angle), np.sin(angle)])
        turn = _turned(angle - angles[source])
        yield Spot(source, np.array([*at, middles[source, 2]]), turn)


def _corners(middles: Points, sizes: Points, count: int) -> Iterator[list[Spot]]:
    """At the corners of a rectangle, and between them along its longer sides."""
    if len(middles) != 4 or np.ptp(middles[:, 2]) > LEVEL * sizes[:, 2].mean():
        return
    middle = middles.mean(0)
    away = middles - middle
    half = np.abs(away[:, :2]).mean(0)
    if (
        np.abs(np.abs(away[:, :2]) - half).max() > EVEN * half.max()
        or half.max() < OBLONG * half.min()
    ):
        return
    long = int(half.argmax())
    columns, odd = divmod(count, 2)
    along = np.linspace(-1, 1, columns) if columns > 1 else np.zeros(columns)
    signs = [(x, y) for x in along for y in (-1, 1)]
    if count == 1:
        signs = [(0, 0)]
    elif count == 3:
        signs = [(-1, 0), (1, -1), (1, 1)]
    elif odd:
        signs = [*signs, (0, 0)] if columns % 2 == 0 else [*signs, (0.5, 0)]
    spots = []
    for one in signs:
        offset = np.zeros(3)
        offset[long], offset[1 - long] = one[0] * half[long], one[1] * half[1 - long]
        source = int(np.linalg.norm(away - offset, axis=1).argmin())
        spots.append(Spot(source, np.array([*(middle + offset)[:2], middles[source, 2]])))
    yield spots


def _lined(values: Float[np.ndarray, " k"], side: float) -> list[float]:
    """The distinct values, those that are nearly the same as one."""
    found: list[list[float]] = []
    for value in np.sort(values):
        if found and value - found[-1][-1] < ALIKE * side:
            found[-1].append(value)
        else:
            found.append([value])
    return [float(np.mean(one)) for one in found]


def _tiles(middles: Points, sizes: Points, count: int) -> Iterator[list[Spot]]:
    """Rows and columns that fill their area: each cell as large as its number leaves it."""
    side = sizes.mean(0)
    lines = [_lined(middles[:, axis], side[axis]) for axis in range(3)]
    across = next((axis for axis in (0, 1) if len(lines[axis]) > 1), 0)
    columns, rows = len(lines[across]), len(lines[2])
    flat = all(len(lines[axis]) == 1 for axis in (0, 1) if axis != across)
    if not flat or columns * rows != len(middles) or rows < 2:
        return
    low = (middles - sizes / 2).min(0)
    high = (middles + sizes / 2).max(0)
    pitch = {2: (high[2] - low[2] - side[2]) / (rows - 1)}
    pitch[across] = (high[across] - low[across] - side[across]) / max(columns - 1, 1)
    if pitch[2] > (1 + TILED) * side[2] or (
        columns > 1 and pitch[across] > (1 + TILED) * side[across]
    ):
        return
    gap = max(pitch[2] - side[2], 0.0)
    for wide in dict.fromkeys((columns, 1)):
        if count % wide:
            continue
        tall = count // wide
        cell_z = (high[2] - low[2] - gap * (tall - 1)) / tall
        cell_x = (high[across] - low[across] - gap * (wide - 1)) / wide
        spots = []
        for row, column in product(range(tall), range(wide)):
            at = middles.mean(0)
            at[2] = low[2] + cell_z / 2 + row * (cell_z + gap)
            at[across] = low[across] + cell_x / 2 + column * (cell_x + gap)
            source = int(np.linalg.norm(middles - at, axis=1).argmin())
            scale = np.ones(3)
            scale[2], scale[across] = cell_z / sizes[source, 2], cell_x / sizes[source, across]
            at[1 - across] = middles[source, 1 - across]
            spots.append(Spot(source, at, scale=scale, stays=True))
        yield spots


def _pairs(middles: Points, sizes: Points, count: int) -> Iterator[list[Spot]]:
    """Mirrored pairs, one above another; an odd one in the middle."""
    if not _mirrored(middles):
        return
    tall, wide = float(sizes[:, 2].mean()), float(sizes[:, 0].mean())
    center = middles.mean(0)
    apart = np.ptp(middles[:, 0])
    pairs, odd = divmod(count, 2)
    for way in (1, -1):
        spots = []
        for k in range(pairs):
            lift = np.array([0.0, 0.0, way * k * APART * tall])
            spots += [Spot(i, middles[i] + lift, stays=k == 0) for i in range(2)]
        if odd:
            above = APART * (pairs - 1)
            lifts = [(way * (by + above) * tall, size) for size, by in LIFTS]
            if not pairs or apart >= 2 * APART * wide:
                lifts = [(0.0, 1.0), *lifts]
            for lift, size in lifts:
                at = center + np.array([0.0, 0.0, lift])
                yield [*spots, Spot(0, at, scale=np.full(3, size))]
        else:
            yield spots


def _row(middles: Points, sizes: Points, count: int) -> Iterator[list[Spot]]:
    """Along the line that they are on, at equal distances."""
    center = middles.mean(0)
    lengths, axes = np.linalg.svd(middles - center, full_matrices=False)[1:]
    if len(lengths) > 1 and lengths[1] > IN_LINE * lengths[0]:
        return
    along = (middles - center) @ axes[0]
    side = float(np.abs(sizes.mean(0) * axes[0]).sum())
    span = float(np.ptp(along))
    least = APART * side
    step = span / max(count - 1, 1)
    if count < len(middles):
        step = span / (len(middles) - 1)
    step = max(step, least)
    if step * (count - 1) > BEYOND * span:
        return
    spots = []
    for k in range(count):
        place = step * (k - (count - 1) / 2)
        source = int(np.abs(along - place).argmin())
        spots.append(Spot(source, middles[source] + (place - along[source]) * axes[0]))
    yield spots


def _fewer(middles: Points, sizes: Points, count: int) -> Iterator[list[Spot]]:
    """Some of the drawn ones: symmetric ones, else those farthest from one another."""
    del sizes
    total = len(middles)
    if count >= total:
        return
    mirror = [int(np.linalg.norm(middles - one * (-1, 1, 1), axis=1).argmin()) for one in middles]
    on_axis = [k for k in range(total) if mirror[k] == k]
    pairs = [(k, mirror[k]) for k in range(total) if mirror[k] > k and mirror[mirror[k]] == k]
    if len(on_axis) + 2 * len(pairs) == total:
        pairs.sort(key=lambda pair: (-abs(middles[pair[0], 0]), middles[pair[0], 1]))
        odd = count % 2
        if len(on_axis) >= odd and len(pairs) >= count // 2:
            on_axis.sort(key=lambda k: middles[k, 1])
            kept = [k for pair in pairs[: count // 2] for k in pair] + on_axis[:odd]
            yield [Spot(k, middles[k], stays=True) for k in kept]
    kept = [int(middles[:, 1].argmin())]
    while len(kept) < count:
        away = np.linalg.norm(middles[:, None] - middles[kept], axis=2).min(1)
        kept.append(int(away.argmax()))
    yield [Spot(k, middles[k], stays=True) for k in kept]


def _scattered(middles: Points, sizes: Points, count: int) -> Iterator[list[Spot]]:
    """All that are drawn, and copies turned about the vertical through the thing's middle, each
    where most room is."""
    angles = np.sort(np.arctan2(middles[:, 1], middles[:, 0]))
    gaps = np.diff(np.r_[angles, angles[0] + 2 * np.pi])
    if count <= len(middles) or gaps.max() > np.pi:
        return
    generator = np.random.default_rng(0)
    wide = float(sizes.mean())
    for _ in range(12):
        spots = [Spot(k, at, stays=True) for k, at in enumerate(middles)]
        while len(spots) < count:
            places = np.array([spot.at for spot in spots])
            best, room = None, APART * wide
            for _ in range(TRIES):
                source = int(generator.integers(len(middles)))
                turn = _turned(float(generator.uniform(-np.pi, np.pi)))
                at = turn @ middles[source]
                away = float(np.linalg.norm(places - at, axis=1).min())
                if away > room:
                    best, room = Spot(source, at, turn), away
            if best is None:
                return
            spots.append(best)
        yield spots


def _heaped(middles: Points, sizes: Points, count: int) -> Iterator[list[Spot]]:
    """In a heap: on rings around its middle, as near as they fit."""
    if count <= len(middles):
        return
    away = np.linalg.norm(middles[:, None] - middles, axis=2) + np.diag(
        np.full(len(middles), np.inf)
    )
    if (away.min(1) > TOGETHER * sizes[:, :2].max(1)).any():  # they are no heap
        return
    center, wide = middles.mean(0), float(sizes[:, :2].mean())
    for size in SHRUNK:
        apart = APART * size * wide
        inner = 1 if count > 5 else 0
        around = count - inner
        radius = max(apart / (2 * np.sin(np.pi / around)), apart * inner)
        scale = np.full(3, size)
        spots = [Spot(0, center, scale=scale)] if inner else []
        for k in range(around):
            angle = -np.pi / 2 + 2 * np.pi * k / around
            at = center + radius * np.array([np.cos(angle), np.sin(angle), 0.0])
            spots.append(Spot(k % len(middles), at, scale=scale))
        yield spots
