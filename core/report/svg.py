"""Curves as inline SVG: nothing to load, sharp at any size. Standard library only."""

import math
from html import escape

WIDTH, HEIGHT, LEFT, BELOW = 440, 150, 52, 22  # user units; the page scales them
MOST_POINTS = 400  # of a line: a pixel each


def curve(points: dict[int, float], title: str, logarithmic: bool = False) -> str:
    """A line chart of values by step, with its ends and extremes written at the axes.

    ``logarithmic``: the values' axis, where all of them are positive.
    """
    known = sorted(points)
    kept = {*known[:: max(1, len(known) // MOST_POINTS)], known[-1]}
    kept |= {min(known, key=points.__getitem__), max(known, key=points.__getitem__)}
    steps = sorted(kept)
    values = [points[step] for step in steps]
    log = logarithmic and all(value > 0 for value in values)
    heights = [math.log10(value) for value in values] if log else values
    low, high = min(heights), max(heights)
    first, last = steps[0], steps[-1]
    line = " ".join(
        f"{_place(step, first, last, LEFT, WIDTH - 8):.1f},"
        f"{_place(height, low, high, HEIGHT - BELOW, 10):.1f}"
        for step, height in zip(steps, heights, strict=True)
    )
    marks = [
        _text(LEFT - 5, 14, f"{max(values):.3g}", "end"),
        _text(LEFT - 5, HEIGHT - BELOW, f"{min(values):.3g}", "end"),
        _text(LEFT, HEIGHT - 6, str(first), "start"),
        _text(WIDTH - 8, HEIGHT - 6, f"step {last}", "end"),
    ]
    frame = f'<path class="axis" d="M{LEFT},8 V{HEIGHT - BELOW} H{WIDTH - 8}"/>'
    drawn = f'{frame}<polyline points="{line}"/>{"".join(marks)}'
    kind = f"{title}, logarithmic" if log else title
    return (
        f'<figure><svg viewBox="0 0 {WIDTH} {HEIGHT}" role="img" aria-label="{escape(kind)}">'
        f"{drawn}</svg><figcaption>{escape(kind)}</figcaption></figure>"
    )


def _place(value: float, low: float, high: float, start: float, end: float) -> float:
    """Where ``value`` is between ``start`` and ``end``; a constant is in the middle."""
    return start + (end - start) * ((value - low) / (high - low) if high > low else 0.5)


def _text(x: float, y: float, text: str, anchor: str) -> str:
    return f'<text x="{x}" y="{y}" text-anchor="{anchor}">{escape(text)}</text>'
