"""The sidebar's tab: what to make, how far it is, what went wrong."""

from __future__ import annotations

import textwrap

import bpy

from . import compat
from .environment import SetupError
from .preferences import Machine
from .properties import FILE
from .session import session

TAB = "Fantasia3D"


class FANTASIA3D_PT_generate(bpy.types.Panel):
    """Generate from text."""

    bl_idname = "FANTASIA3D_PT_generate"
    bl_label = "Generate from Text"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = TAB

    def draw(self, context: bpy.types.Context) -> None:
        layout = self.layout
        settings = context.scene.fantasia3d
        if not _is_set_up(context):
            box = layout.box()
            box.label(text="The method's Python is not there yet.", icon="INFO")
            draw_set_up(box, context)
        compat.text_field(layout, settings, "prompt", placeholder="a red wooden chair")
        layout.use_property_split = True
        layout.use_property_decorate = False
        layout.prop(settings, "preset")
        row = layout.row(align=True)
        row.prop(settings, "seed")
        row.operator("fantasia3d.new_seed", text="", icon="FILE_REFRESH")
        _draw_options(layout, settings)
        _draw_run(layout)
        _draw_messages(layout, context)
        layout.operator("fantasia3d.import_asset", icon="IMPORT")


def draw_set_up(layout: bpy.types.UILayout, context: bpy.types.Context) -> None:
    """The buttons that make and check the core's Python, and what they found."""
    row = layout.row(align=True)
    row.operator("fantasia3d.set_up")
    row.operator("fantasia3d.check")
    work = session.work
    if work is None:
        return
    if work.running:
        layout.progress(factor=work.share, text=work.text)
    elif work.error:
        _draw_message(layout, context, work.error, "ERROR")
    else:
        _draw_message(layout, context, (work.text, ""), "CHECKMARK")


def _draw_options(layout: bpy.types.UILayout, settings: bpy.types.PropertyGroup) -> None:
    """What the preset decides unless it is said here, folded away."""
    header, body = layout.panel("fantasia3d_options", default_closed=True)
    header.label(text="Options")
    if body is None:
        return
    body.prop(settings, "negative_prompt")
    body.prop(settings, "guidance")
    if settings.guidance == "model":
        body.prop(settings, "model")
    body.prop(settings, "guide")
    if settings.guide:
        body.prop(settings, "guide_strength")
    body.prop(settings, "light")
    if settings.light == FILE:
        body.prop(settings, "light_file")
    body.prop(settings, "texture_size")
    body.prop(settings, "max_faces")


def _is_set_up(context: bpy.types.Context) -> bool:
    try:
        return Machine(context).python.exists()
    except SetupError:
        return False


def _draw_run(layout: bpy.types.UILayout) -> None:
    """Generate, or the bar and Cancel while it runs."""
    if not session.busy:
        row = layout.row()
        row.scale_y = 1.4
        row.operator("fantasia3d.generate", icon="SHADERFX")
        return
    progress = session.progress
    layout.progress(factor=progress.share, text=progress.line)
    row = layout.row()
    row.enabled = not progress.cancelling
    row.operator("fantasia3d.cancel", icon="CANCEL")


def _draw_messages(layout: bpy.types.UILayout, context: bpy.types.Context) -> None:
    if session.warning and session.busy:
        _draw_message(layout, context, session.warning, "INFO")
    if session.error:
        box = layout.box()
        _draw_message(box, context, session.error, "ERROR")
        box.operator("fantasia3d.open_log", icon="TEXT")
    elif session.asset:
        layout.label(text=f"Made: {session.asset}", icon="CHECKMARK")


def _draw_message(
    layout: bpy.types.UILayout, context: bpy.types.Context, message: tuple[str, str], icon: str
) -> None:
    """A sentence and its fix, broken into lines that fit the region."""
    scale = context.preferences.system.ui_scale
    width = max(20, int(context.region.width / (7.5 * scale)) - 4)
    column = layout.column(align=True)
    for index, line in enumerate(
        line for part in message if part for line in textwrap.wrap(part, width)
    ):
        column.label(text=line, icon="NONE" if index else icon)


CLASSES = (FANTASIA3D_PT_generate,)
