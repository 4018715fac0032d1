"""Pictures in the panel: those of lights, of running jobs and of finished ones."""

from __future__ import annotations

from pathlib import Path

import bpy
import bpy.utils.previews

LIGHTS = Path(__file__).with_name("light_icons")
KEPT = 200  # pictures in memory; older ones are read again

_collections: list[bpy.utils.previews.ImagePreviewCollection] = []


def open_collection() -> None:
    """Make room for pictures; until :func:`close_collection`."""
    _collections.append(bpy.utils.previews.new())


def close_collection() -> None:
    """Let all pictures go."""
    while _collections:
        bpy.utils.previews.remove(_collections.pop())


def icon(path: Path | None, at_once: bool = False) -> int:
    """The icon of a picture file as it is now; 0 where there is none.

    Blender reads a picture in the background, and shows nothing meanwhile: one that is replaced
    every second would hardly ever be seen. ``at_once`` reads it here, in about 5 ms.
    """
    if path is None or not _collections:
        return 0
    try:
        key = f"{path}:{path.stat().st_mtime_ns}"
    except OSError:
        return 0
    pictures = _collections[0]
    if key not in pictures:
        _forget(str(path))
        picture = pictures.load(key, str(path), "IMAGE")
        if at_once:
            picture.image_size[:]  # whoever asks for it has Blender read it
    return pictures[key].icon_id


def _forget(path: str) -> None:
    """Drop an older picture of the same file, and the oldest of all beyond ``KEPT``."""
    pictures = _collections[0]
    for key in [key for key in pictures if key.rpartition(":")[0] == path]:
        del pictures[key]
    for key in list(pictures)[: max(0, len(pictures) - KEPT)]:
        del pictures[key]


def light_icon(name: str) -> int:
    """The icon of a named light: a ball that it lights."""
    return icon(LIGHTS / f"{name}.png")
