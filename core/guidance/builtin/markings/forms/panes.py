"""Windows, doors and shutters in walls."""

import math
from collections.abc import Sequence
from typing import NamedTuple

from core.guidance.builtin.markings.margins import (
    Half,
    Margin,
    Pair,
    Points,
    all_of,
    any_of,
    in_front,
)
from core.guidance.builtin.markings.outlines import Outline, laid

FRAME = 0.026  # how wide a window's is, training units
SILL = 0.022  # how far that goes on at either side, and half of how high it is
BAR = 0.012  # half of what is between two panes


class Opening(NamedTuple):
    """An opening in a wall, in halves of the wall's extent; a round one is as high as it is
    wide."""

    face: str  # "front", "back" or "sides"
    at: tuple[float, float]  # the middle, along the wall and up
    size: tuple[float, float]  # half of its own
    head: str = ""  # "arched", "round"; "": square
    depth: float = 0.7  # what is nearer to the middle of the building has none


class Seen(NamedTuple):
    """Places seen from the middle of an opening."""

    across: Margin
    up: Margin
    half: tuple[float, float]  # of the opening, training units
    outside: Margin  # how far they are on its side of the building


def _seen(points: Points, half: Half, one: Opening) -> Seen:
    """The places seen from an opening."""
    x, y, z = points.unbind(1)
    long, deep = (1, 0) if one.face == "sides" else (0, 1)
    toward = {"front": -y, "back": y, "sides": x.abs()}[one.face]
    along = y if one.face == "sides" else x
    wide = one.size[0] * float(half[long])
    size = wide, wide if one.head == "round" else one.size[1] * float(half[2])
    outside = toward - one.depth * half[deep]
    return Seen(along - one.at[0] * half[long], z - one.at[1] * half[2], size, outside)


def _within(seen: Seen, head: str, more: float = 0.0) -> Margin:
    """Inside an opening that is ``more`` larger on all sides."""
    (wide, high), up = seen.half, seen.up
    if head == "round":
        return wide + more - (seen.across.square() + up.square()).sqrt()
    if head == "arched":
        over = (up - (high - wide)).clamp_min(0)
        around = wide + more - (seen.across.square() + over.square()).sqrt()
        return all_of(around, high + more + up)
    return all_of(wide + more - seen.across.abs(), high + more - up.abs())


def _between(at: Margin, half: float, count: int, bar: float) -> Margin:
    """Inside one of ``count`` panes in a row."""
    pitch = 2 * half / count
    place = at / pitch + count / 2
    return (place - place.round().clamp(1, count - 1)).abs() * pitch - bar


def panes(
    points: Points,
    half: Half,
    openings: Sequence[Opening],
    grid: tuple[int, int] = (2, 2),
    bar: float = BAR,
) -> Margin:
    """The glass: panes across and up in each opening."""
    found = []
    for one in openings:
        seen = _seen(points, half, one)
        bars = [
            _between(at, size, count, bar)
            for at, size, count in zip((seen.across, seen.up), seen.half, grid, strict=True)
            if count > 1
        ]
        found.append(all_of(_within(seen, one.head), *bars, seen.outside))
    return any_of(*found)


def frames(
    points: Points,
    half: Half,
    openings: Sequence[Opening],
    grid: tuple[int, int] = (2, 2),
    bar: float = BAR,
) -> Margin:
    """The part of windows that is not glass."""
    return -panes(points, half, openings, grid, bar)


def windows(
    points: Points,
    half: Half,
    openings: Sequence[Opening],
    frame: float = FRAME,
    sill: float = SILL,
) -> Margin:
    """Windows with their frames and sills."""
    found = []
    for one in openings:
        seen = _seen(points, half, one)
        whole = _within(seen, one.head, frame)
        if sill and one.head != "round":
            low = seen.up + seen.half[1] + frame
            under = all_of(sill - low.abs(), seen.half[0] + frame + sill - seen.across.abs())
            whole = any_of(whole, under)
        found.append(all_of(whole, seen.outside))
    return any_of(*found)


def shutters(points: Points, half: Half, openings: Sequence[Opening], wide: float = 0.55) -> Margin:
    """Shutters at both sides of windows, each ``wide`` of half a window's width, with gaps between
    their slats."""
    found = []
    for one in openings:
        seen = _seen(points, half, one)
        own = wide * seen.half[0]
        aside = own / 2 - (seen.across.abs() - seen.half[0] - FRAME - 0.014 - own / 2).abs()
        found.append(all_of(aside, seen.half[1] + FRAME - seen.up.abs(), seen.outside))
    return any_of(*found)


def door_panels(
    points: Points,
    half: Half,
    rows: Sequence[tuple[float, float]] = ((-0.78, -0.12), (0.06, 0.82)),
    columns: int = 2,
    edge: float = 0.22,
) -> Margin:
    """Panels of a door: the heights of their rows in halves; ``edge``: the fraction of half the
    width next to them."""
    x, z, wide = points[:, 0], points[:, 2], float((1 - edge) * half[0])
    across = wide - x.abs()
    if columns > 1:
        across = all_of(across, _between(x, wide, columns, edge * float(half[0]) / 2.4))
    level = [all_of(z - low * half[2], high * half[2] - z) for low, high in rows]
    return all_of(across, any_of(*level), in_front(points) - 0.4 * half[1])


BARN_DOOR = 0.5, -0.12  # half of its width, and its upper edge
LOFT = Opening("front", (0.0, 0.37), (0.24, 0.13))
BARN_WINDOWS = tuple(Opening("sides", (u, -0.42), (0.12, 0.15)) for u in (-0.55, 0.0, 0.55))


def barn_door(points: Points, half: Half) -> Margin:
    """The door in the front of a barn."""
    wide = BARN_DOOR[0] * half[0] - points[:, 0].abs()
    return all_of(wide, BARN_DOOR[1] * half[2] - points[:, 2], -points[:, 1] - 0.7 * half[1])


def barn_trim(points: Points, half: Half, wide: float = 0.03) -> Margin:
    """White boards of a barn: around the door, a cross on each of its leaves, around the loft and
    the windows, and at the corners."""
    x, y, z = points.unbind(1)
    side, top = float(BARN_DOOR[0] * half[0]), float(BARN_DOOR[1] * half[2])
    tall = top + float(half[2])
    around = all_of(side + wide - x.abs(), top + wide - z)
    leaf = all_of(
        x.abs() - wide / 2, side - wide - x.abs(), top - wide - z, z + half[2] - 1.6 * wide
    )
    long = math.hypot(side, tall)
    u, v = x.abs() - side / 2, z - (top - tall / 2)
    braces = [0.75 * wide - (u * tall + s * v * side).abs() / long for s in (-1, 1)]
    door = any_of(all_of(around, -leaf), all_of(around, *[any_of(*braces)]))
    loft = _seen(points, half, LOFT)
    hatch = all_of(_within(loft, "", 2 * wide), -_within(loft, ""))
    front = all_of(any_of(door, hatch), -y - 0.7 * half[1])
    panes_of = all_of(
        windows(points, half, BARN_WINDOWS, 0.03, 0.0), frames(points, half, BARN_WINDOWS)
    )
    corner = any_of(
        all_of(x.abs() - half[0] + 2 * wide, y.abs() - half[1] + 0.01),
        all_of(y.abs() - half[1] + 2 * wide, x.abs() - half[0] + 0.01),
    )
    return any_of(front, panes_of, corner)


def vehicle_windows(
    points: Points,
    half: Half,
    front: Sequence[Outline],
    sides: Sequence[Outline] = (),
    back: Sequence[Outline] = (),
    ends: Pair = (0.1, 0.1),
    until: float = 9.0,
) -> Margin:
    """Panes of a vehicle; ``ends``: how far from the middle those of the front and the back begin,
    in halves."""
    margins = [laid(points, half, front=front, deep=ends[0])]
    if sides:
        margins.append(laid(points, half, sides=sides, deep=0.55))
    if back:
        margins.append(laid(points, half, back=back, deep=ends[1], until=until))
    return any_of(*margins)
