"""Text in the panels: labels that wrap, errors with their fix, collapsible parts, durations."""

from __future__ import annotations

import re
from collections.abc import Callable

import blf
import bpy
from bpy.app.translations import pgettext_iface as translated

TAB = "Fantasia3D"
TEXT_SIZE = 11.0  # points, as Blender's widgets
SENTENCES = re.compile(r"(?<=[.!?]) +")
VALUES = re.compile(r"“[^”]*”|\d[\d.,:]*(?<=\d)")  # the values in a message: names, numbers
OTHER_WIDTH = 96.0  # pixels at scale 1 that text can't use: tabs, the panel's borders, an icon


def wrapped_label(
    layout: bpy.types.UILayout,
    context: bpy.types.Context,
    text: str,
    icon: str = "NONE",
    dimmed: bool = False,
    as_it_is: bool = False,
) -> None:
    """Text of any length, in lines that fit the region; ``dimmed`` for the less important.

    ``as_it_is``: of the user's, such as a prompt, which is not a message.
    """
    column = layout.column(align=True)
    column.active = not dimmed
    # Before it is wrapped: the lines are no messages.
    text = text if as_it_is else in_language(text)
    for index, line in enumerate(wrapped(text, _text_width(context))):
        # The icon comes before the first line; a blank one indents the others.
        shown = icon if index == 0 or icon == "NONE" else "BLANK1"
        column.label(text=line, icon=shown, translate=False)


def in_language(text: str, translate: Callable[[str], str] = translated) -> str:
    """``text`` in the interface's language: a message, or several sentences that are each one.

    In a message "{}" is replaced by a number or a “name”, in the same order.
    """
    whole = translate(text)
    if whole != text:
        return whole
    return " ".join(_sentence(each, translate) for each in SENTENCES.split(text))


def _sentence(text: str, translate: Callable[[str], str]) -> str:
    message = VALUES.sub("{}", text)
    found = translate(message)
    if found == message:
        return translate(text)
    values = VALUES.findall(text)
    return found.format(*(f"“{translate(x[1:-1])}”" if x[0] == "“" else x for x in values))


def error_and_fix(
    layout: bpy.types.UILayout, context: bpy.types.Context, message: tuple[str, str], icon: str
) -> None:
    """A message and, dimmed, what to do about it."""
    column = layout.column(align=True)
    wrapped_label(column, context, message[0], icon)
    if message[1]:
        wrapped_label(column, context, message[1], "BLANK1", dimmed=True)


def wrapped(text: str, limit: float) -> list[str]:
    """``text`` in lines that are no wider than ``limit`` pixels, broken between words.

    A word that is wider than a line, such as a path, is broken too.
    """
    lines, line = [], ""
    for word in text.split():
        joined = f"{line} {word}".strip()
        if _width(joined) <= limit:
            line = joined
            continue
        lines += [line] if line else []
        while _width(word) > limit and len(word) > 1:
            fits = next(
                n for n in range(len(word) - 1, 0, -1) if n == 1 or _width(word[:n]) <= limit
            )
            lines.append(word[:fits])
            word = word[fits:]
        line = word
    return [*lines, line] if line else lines


def _width(text: str) -> float:
    return blf.dimensions(0, text)[0]


def _text_width(context: bpy.types.Context) -> float:
    scale = context.preferences.system.ui_scale
    blf.size(0, TEXT_SIZE * scale)
    width = context.region.width if context.region else 300 * scale
    return max(80.0, width - OTHER_WIDTH * scale)


def collapsible(layout: bpy.types.UILayout, name: str, title: str) -> bpy.types.UILayout | None:
    """The body of a part that is collapsed at first; None while it is."""
    header, body = layout.panel(f"fantasia3d_{name}", default_closed=True)
    header.label(text=title)
    return body


def duration(seconds: float) -> str:
    """2:05, or 1:02:05."""
    minutes, rest = divmod(round(seconds), 60)
    hours, minutes = divmod(minutes, 60)
    return f"{hours}:{minutes:02}:{rest:02}" if hours else f"{minutes}:{rest:02}"


def length(metres: float) -> str:
    """4.2 m, or 10 cm."""
    return f"{metres:.3g} m" if metres >= 1 else f"{100 * metres:.3g} cm"
