"""How the panels of the tab look: sentences that fit, folds, quiet lines."""

from __future__ import annotations

import blf
import bpy

TAB = "Fantasia3D"
TEXT_SIZE = 11.0  # points, of Blender's widgets
LEFT_OUT = 96.0  # pixels at scale 1: the tabs, the panel's borders, an icon


def sentence(
    layout: bpy.types.UILayout,
    context: bpy.types.Context,
    text: str,
    icon: str = "NONE",
    quiet: bool = False,
) -> None:
    """Text of any length, in lines that fit the region; ``quiet`` ones are dimmed."""
    column = layout.column(align=True)
    column.active = not quiet
    for index, line in enumerate(wrapped(text, _room(context))):
        # An icon stands before the first line; the others are set in by a blank one.
        column.label(text=line, icon=icon if index == 0 or icon == "NONE" else "BLANK1")


def message(
    layout: bpy.types.UILayout, context: bpy.types.Context, told: tuple[str, str], icon: str
) -> None:
    """A sentence and, quieter, what to do about it."""
    column = layout.column(align=True)
    sentence(column, context, told[0], icon)
    if told[1]:
        sentence(column, context, told[1], "BLANK1", quiet=True)


def wrapped(text: str, room: float) -> list[str]:
    """``text`` in lines that are no wider than ``room`` pixels, broken between words.

    A word that is wider than a line, such as a path, is broken too.
    """
    lines, line = [], ""
    for word in text.split():
        joined = f"{line} {word}".strip()
        if _width(joined) <= room:
            line = joined
            continue
        lines += [line] if line else []
        while _width(word) > room and len(word) > 1:
            fits = next(
                n for n in range(len(word) - 1, 0, -1) if n == 1 or _width(word[:n]) <= room
            )
            lines.append(word[:fits])
            word = word[fits:]
        line = word
    return [*lines, line] if line else lines


def _width(text: str) -> float:
    return blf.dimensions(0, text)[0]


def _room(context: bpy.types.Context) -> float:
    scale = context.preferences.system.ui_scale
    blf.size(0, TEXT_SIZE * scale)
    width = context.region.width if context.region else 300 * scale
    return max(80.0, width - LEFT_OUT * scale)


def fold(layout: bpy.types.UILayout, name: str, title: str) -> bpy.types.UILayout | None:
    """A part that is folded away at first; None while it is."""
    header, body = layout.panel(f"fantasia3d_{name}", default_closed=True)
    header.label(text=title)
    return body


def duration(seconds: float) -> str:
    """2:05, or 1:02:05."""
    minutes, rest = divmod(round(seconds), 60)
    hours, minutes = divmod(minutes, 60)
    return f"{hours}:{minutes:02}:{rest:02}" if hours else f"{minutes}:{rest:02}"
