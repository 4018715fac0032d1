"""The pie menu's shortcut, which the preferences offer and which is off at first."""

from __future__ import annotations

import bpy

KEY = {"type": "F", "value": "PRESS", "ctrl": True, "alt": True}
TEXT = "Ctrl Alt F"
_items: list[tuple[bpy.types.KeyMap, bpy.types.KeyMapItem]] = []


def update(is_on: bool) -> None:
    """Add the shortcut to Blender's keymap, or remove it."""
    remove()
    config = bpy.context.window_manager.keyconfigs.addon
    if is_on and config:  # there is none without a window
        keymap = config.keymaps.new(name="Object Mode", space_type="EMPTY")
        item = keymap.keymap_items.new("wm.call_menu_pie", **KEY)
        item.properties.name = "FANTASIA3D_MT_pie"
        _items.append((keymap, item))


def remove() -> None:
    """Remove the shortcut, if it is there."""
    while _items:
        keymap, item = _items.pop()
        keymap.keymap_items.remove(item)
