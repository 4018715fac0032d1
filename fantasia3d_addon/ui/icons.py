"""Pictures in the panel: of lights, of running jobs and of finished ones."""

from __future__ import annotations

from pathlib import Path

import bpy
import bpy.utils.previews

LIGHTS = Path(__file__).with_name("light_icons")
MAX_PICTURES = 200  # in memory; older ones are read again

_collections: list[bpy.utils.previews.ImagePreviewCollection] = []


def open_collection() -> None:
    """Create Blender's collection of pictures, to be freed by :func:`close_collection`."""
    _collections.append(bpy.utils.previews.new())


def close_collection() -> None:
    """Free all pictures."""
    while _collections:
        bpy.utils.previews.remove(_collections.pop())


def icon(path: Path | None, at_once: bool = False) -> int:
    """The icon of a picture file as it is now; 0 where there is none.

    Blender reads a picture in the background and shows nothing meanwhile: one that is replaced
    every second would hardly ever be visible. ``at_once`` reads it here, in about 5 ms.
    """
    if path is None or not _collections:
        return 0
    try:
        key = f"{path}:{path.stat().st_mtime_ns}"  # a file that is written again is a new picture
    except OSError:
        return 0
    pictures = _collections[0]
    if key not in pictures:
        _forget(str(path))
        picture = pictures.load(key, str(path), "IMAGE")
        if at_once:
            picture.image_size[:]  # to read this property makes Blender read the file
    return pictures[key].icon_id


def _forget(path: str) -> None:
    """Free an older picture of the same file, and the oldest of all beyond ``MAX_PICTURES``."""
    pictures = _collections[0]
    for key in [key for key in pictures if key.rpartition(":")[0] == path]:
        del pictures[key]
    for key in list(pictures)[: max(0, len(pictures) - MAX_PICTURES)]:
        del pictures[key]


def light_icon(name: str) -> int:
    """The icon of a named light: a ball under that light."""
    return icon(LIGHTS / f"{name}.png")
