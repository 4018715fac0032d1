"""The installation in the panel and in the preferences: buttons, progress, what was found."""

from __future__ import annotations

import bpy

from ..environment import Line
from ..jobs import environment_setup
from ..jobs.session import session
from .text import TAB, error_and_fix, in_language, wrapped_label

ICONS = {"ok": "CHECKMARK", "MISSING": "ERROR", "-": "DOT"}  # by a Line's state


class FANTASIA3D_PT_set_up(bpy.types.Panel):
    """The method's Python environment."""

    bl_idname = "FANTASIA3D_PT_set_up"
    bl_label = "Installation"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = TAB
    bl_options = {"DEFAULT_CLOSED"}
    bl_order = 90

    def draw(self, context: bpy.types.Context) -> None:
        draw_set_up(self.layout, context, repair=True)
        self.layout.operator("fantasia3d.open_preferences", text="Preferences…", icon="PREFERENCES")


def draw_set_up(
    layout: bpy.types.UILayout, context: bpy.types.Context, repair: bool = False
) -> None:
    """The buttons that create and check the core's Python, and their result.

    ``repair`` adds those that create it again and remove it.
    """
    task = session.task
    if task and task.running:
        text = f"{in_language(task.title)}  {task.fraction:.0%}"
        layout.progress(factor=task.fraction, text=text, translate=False)
        wrapped_label(layout, context, task.text, dimmed=True)
        row = layout.row(align=True)
        row.enabled = not task.cancelled
        row.operator("fantasia3d.cancel_set_up", text="Cancel", icon="CANCEL")
        return
    row = layout.row(align=True)
    row.operator("fantasia3d.set_up", text="Install", icon="IMPORT")
    row.operator("fantasia3d.check", text="Check", icon="VIEWZOOM")
    _draw_reason(layout, context)
    if repair:
        row = layout.row(align=True)
        row.operator("fantasia3d.repair", text="Reinstall", icon="FILE_REFRESH")
        row.operator("fantasia3d.remove_environment", text="Uninstall", icon="TRASH")
    if task:
        _draw_result(layout, context)


def _draw_reason(layout: bpy.types.UILayout, context: bpy.types.Context) -> None:
    """Why nothing can be installed now, and the buttons that change it; nothing once all is here.

    ``context`` may be of the panel or of the preferences.
    """
    reason = environment_setup.reason_against()
    if not reason or environment_setup.is_installed():
        return
    wrapped_label(layout, context, reason, "INFO", dimmed=True)
    if not bpy.app.online_access:
        column = layout.column(align=True)
        column.operator("fantasia3d.allow_online_access", icon="URL")
        column.operator("fantasia3d.choose_wheels", icon="FILE_FOLDER")


def _draw_result(layout: bpy.types.UILayout, context: bpy.types.Context) -> None:
    task = session.task
    if task is None:
        return
    if task.error:
        error_and_fix(layout, context, task.error, "ERROR")
        layout.operator("fantasia3d.open_set_up_log", text="Open Log", icon="TEXT")
        return
    lines = task.result if isinstance(task.result, list) else []  # only a check has lines
    missing = any(isinstance(line, Line) and line.state == "MISSING" for line in lines)
    wrapped_label(layout, context, task.text, "ERROR" if missing else "CHECKMARK")
    column = layout.column(align=True)
    for line in lines:
        text, icon = f"{line.name}: {line.text}", ICONS.get(line.state, "DOT")
        wrapped_label(column, context, text, icon, dimmed=line.state != "MISSING")
