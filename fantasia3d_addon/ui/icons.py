"""Pictures in the panel: of lights, of running jobs and of finished ones.

A panel is drawn many times a second, and :func:`icon`, which it calls, touches no file: a timer
looks at the files of what was drawn.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import bpy
import bpy.utils.previews

from ..jobs.panels import redraw

LIGHTS = Path(__file__).with_name("light_icons")
MAX_PICTURES = 200  # in memory, unless more are drawn; older ones are read again
SECONDS = 0.05  # until the files of what was drawn are looked at

Files = tuple[Path, ...]

_collections: list[bpy.utils.previews.ImagePreviewCollection] = []  # the jobs', the lights'
_names: dict[Files, str] = {}  # of the jobs' pictures that are shown; last drawn, last here
_drawn: dict[Files, None] = {}  # what was asked for since the last look, in that order


def open_collection() -> None:
    """Create Blender's collections of pictures, to be freed by :func:`close_collection`."""
    _collections.extend(bpy.utils.previews.new() for _ in ("jobs", "lights"))


def close_collection() -> None:
    """Free all pictures."""
    if bpy.app.timers.is_registered(look):
        bpy.app.timers.unregister(look)
    _names.clear()
    _drawn.clear()
    while _collections:
        bpy.utils.previews.remove(_collections.pop())


def icon(files: Sequence[Path]) -> int:
    """The icon of the first of ``files`` that exists, as the last :func:`look` found it.

    0 where none exists, and before the first look, after which the panel is drawn again.
    """
    if not _collections:
        return 0
    key = tuple(files)
    _drawn[key] = None
    if not bpy.app.timers.is_registered(look):
        bpy.app.timers.register(look, first_interval=SECONDS, persistent=True)
    return _collections[0][_names[key]].icon_id if key in _names else 0


def look() -> float | None:
    """Look at the files of what was drawn; the seconds until the next call, None without one.

    Blender reads a picture in a thread of its own when it is first drawn, and shows nothing
    meanwhile: one that is replaced every second would hardly ever be visible. So what replaces
    another is read here, which blocks: one in each call.
    """
    pictures, many, is_changed = _collections[0], max(MAX_PICTURES, len(_drawn)), False
    for files in list(_drawn):
        del _drawn[files]
        path, name = _newest(files)
        before = _names.pop(files, "")
        is_read_here = bool(before and path and name not in pictures)
        if path and name not in pictures:
            pictures.load(name, str(path), "IMAGE")
        if path:
            _names[files] = name
        is_changed |= name != before
        if is_read_here:
            pictures[name].image_size[:]  # to read this property makes Blender read the file
            break
    if is_changed:
        _free(many)
        redraw()
    return SECONDS if _drawn else None


def _newest(files: Files) -> tuple[Path | None, str]:
    """The first file that exists, and its picture's name: another after it is written again."""
    for path in files:
        try:
            return path, f"{path}:{path.stat().st_mtime_ns}"
        except OSError:
            continue
    return None, ""


def _free(many: int) -> None:
    """Free the pictures that nothing shows any more, and the oldest beyond ``many``."""
    for files in list(_names)[: max(0, len(_names) - many)]:
        del _names[files]
    pictures = _collections[0]
    for name in set(pictures).difference(_names.values()):
        del pictures[name]


def light_icon(name: str) -> int:
    """The icon of a named light: a ball under that light."""
    path = LIGHTS / f"{name}.png"
    if not _collections or not path.is_file():
        return 0
    lights = _collections[1]
    if name not in lights:
        lights.load(name, str(path), "IMAGE")
    return lights[name].icon_id
