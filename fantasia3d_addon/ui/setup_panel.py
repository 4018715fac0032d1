"""The set-up in the panel and in the preferences: buttons, the bar, what was found."""

from __future__ import annotations

import bpy

from ..environment import Line
from ..jobs import environment_setup
from ..jobs.session import session
from .text import TAB, message, sentence

ICONS = {"ok": "CHECKMARK", "MISSING": "ERROR", "-": "DOT"}


class FANTASIA3D_PT_set_up(bpy.types.Panel):
    """The method's Python environment."""

    bl_idname = "FANTASIA3D_PT_set_up"
    bl_label = "Set-Up"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = TAB
    bl_options = {"DEFAULT_CLOSED"}
    bl_order = 90

    def draw(self, context: bpy.types.Context) -> None:
        draw_set_up(self.layout, context, repair=True)
        self.layout.operator("fantasia3d.open_preferences", icon="PREFERENCES")


def draw_set_up(
    layout: bpy.types.UILayout, context: bpy.types.Context, repair: bool = False
) -> None:
    """The buttons that make, check and mend the core's Python, and what they found."""
    work = session.work
    if work and work.running:
        layout.progress(factor=work.share, text=f"{work.title}  {work.share:.0%}")
        sentence(layout, context, work.text, quiet=True)
        row = layout.row(align=True)
        row.enabled = not work.cancelled
        row.operator("fantasia3d.cancel_set_up", icon="CANCEL")
        return
    row = layout.row(align=True)
    row.operator("fantasia3d.set_up", icon="IMPORT")
    row.operator("fantasia3d.check", icon="VIEWZOOM")
    reason = environment_setup.reason_against()
    if reason and not repair:  # the panel's box says it while there is none
        sentence(layout, context, reason, "INFO", quiet=True)
    if repair:
        row = layout.row(align=True)
        row.operator("fantasia3d.repair", icon="FILE_REFRESH")
        row.operator("fantasia3d.remove_environment", icon="TRASH")
    if work:
        _draw_result(layout, context)


def _draw_result(layout: bpy.types.UILayout, context: bpy.types.Context) -> None:
    work = session.work
    if work is None:
        return
    if work.error:
        message(layout, context, work.error, "ERROR")
        layout.operator("fantasia3d.open_set_up_log", icon="TEXT")
        return
    lines = work.result if isinstance(work.result, list) else []
    missing = any(isinstance(line, Line) and line.state == "MISSING" for line in lines)
    sentence(layout, context, work.text, "ERROR" if missing else "CHECKMARK")
    column = layout.column(align=True)
    for line in lines:
        sentence(column, context, f"{line.name}: {line.text}", ICONS.get(line.state, "DOT"),
                 quiet=line.state != "MISSING")  # fmt: skip
