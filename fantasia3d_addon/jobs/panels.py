"""Updates of Blender's data for the panels: the history's list, and a redraw."""

from __future__ import annotations

from collections.abc import Sequence

import bpy

from .history import Entry


def update_list(entries: Sequence[Entry]) -> None:
    """Give the panel's list the entries of the history; the selected run stays selected."""
    jobs = bpy.context.window_manager.fantasia3d
    before, names = [item.name for item in jobs.entries], [str(entry.folder) for entry in entries]
    # Only where they differ: writing the property makes Blender redraw.
    if before != names:
        jobs.entries.clear()
        for name in names:
            jobs.entries.add().name = name
        selected = before[jobs.index] if 0 <= jobs.index < len(before) else ""
        jobs.index = names.index(selected) if selected in names else jobs.index


def redraw() -> None:
    """Redraw the sidebars and the preferences, which do not notice a job's progress."""
    for window in bpy.context.window_manager.windows:
        for area in window.screen.areas:
            if area.type == "PREFERENCES":
                area.tag_redraw()
            for region in area.regions if area.type == "VIEW_3D" else ():
                if region.type == "UI":
                    region.tag_redraw()
