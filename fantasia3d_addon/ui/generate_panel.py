"""The sidebar's tab: what to make, how far it is, what came of it."""

from __future__ import annotations

import bpy

from ..blender import compat
from ..environment import SetupError
from ..jobs import memory, submit
from ..jobs.import_result import obstacle
from ..jobs.job_settings import FILE
from ..jobs.paths import Paths
from ..jobs.progress import Follow
from ..jobs.session import session
from . import icons
from .presets import FANTASIA3D_PT_presets
from .setup_panel import FANTASIA3D_PT_set_up, draw_set_up
from .text import TAB, fold, message, sentence

PICTURE = 7.0  # of the preview, in rows


class FANTASIA3D_PT_generate(bpy.types.Panel):
    """Generate from text."""

    bl_idname = "FANTASIA3D_PT_generate"
    bl_label = "Generate from Text"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = TAB
    bl_order = 0

    def draw_header_preset(self, context: bpy.types.Context) -> None:
        FANTASIA3D_PT_presets.draw_panel_header(self.layout)

    def draw(self, context: bpy.types.Context) -> None:
        layout, settings = self.layout, context.scene.fantasia3d
        if not is_set_up(context):
            box = layout.box()
            sentence(box, context, "Once, before the first asset:", "INFO")
            draw_set_up(box, context)
        layout.row().prop(settings, "task", expand=True)
        column = layout.column(align=True)
        compat.text_field(column, settings, "prompt", placeholder="a red wooden chair")
        column.prop(settings, "negative_prompt", text="", placeholder="without: …")
        layout.use_property_split = True
        layout.use_property_decorate = False
        _draw_settings(layout, settings)
        if settings.task == "texture":
            _draw_mesh(layout, context)
        _draw_folds(layout, context)
        _draw_button(layout, context)
        for follow in session.running:
            _draw_run(layout, context, follow)
        _draw_outcome(layout, context)


def is_set_up(context: bpy.types.Context) -> bool:
    """Whether there is a Python for the core."""
    try:
        return Paths(context).python.exists()
    except SetupError:
        return False


def _draw_settings(layout: bpy.types.UILayout, settings: bpy.types.PropertyGroup) -> None:
    column = layout.column()
    column.prop(settings, "preset")
    row = column.row(align=True)
    row.prop(settings, "seed")
    row.operator("fantasia3d.new_seed", text="", icon="FILE_REFRESH")
    column.prop(settings, "guidance")
    if settings.guidance == "folder":
        column.prop(settings, "model_folder")
    elif settings.guidance == "hub":
        column.prop(settings, "hub_id", placeholder="owner/name")


def _draw_mesh(layout: bpy.types.UILayout, context: bpy.types.Context) -> None:
    """What happens to the mesh that is selected."""
    settings, obj = context.scene.fantasia3d, context.active_object
    column = layout.column()
    split = column.split(factor=0.4)
    right = split.row()
    right.alignment = "RIGHT"
    right.label(text="Mesh")
    there = obj is not None and obj.type == "MESH"
    split.label(text=obj.name if there else "none is selected", icon="OUTLINER_OB_MESH")
    column.row().prop(settings, "uv", expand=True)
    column.row().prop(settings, "assign", expand=True)
    column.prop(settings, "use_present_color")
    if settings.use_present_color:
        column.prop(settings, "color_strength")


def _draw_folds(layout: bpy.types.UILayout, context: bpy.types.Context) -> None:
    """What the quality decides unless it is said here."""
    settings = context.scene.fantasia3d
    body = fold(layout, "guide", "Start from a Mesh") if settings.task == "generate" else None
    if body:
        row = body.row(align=True)
        row.prop(settings, "guide")
        row.operator("fantasia3d.guide_from_selection", text="", icon="RESTRICT_SELECT_OFF")
        row = body.row()
        row.active = settings.guide is not None
        row.prop(settings, "guide_strength")
    body = fold(layout, "light", "Light")
    if body:
        body.template_icon_view(settings, "light", show_labels=True, scale=5, scale_popup=5)
        body.prop(settings, "light", text="")
        if settings.light == FILE:
            body.prop(settings, "light_file", text="")
    body = fold(layout, "output", "Size")
    if body:
        body.prop(settings, "texture_size")
        if settings.task == "generate":
            body.prop(settings, "max_faces")
        sentence(body, context, _memory_line(settings)[0], quiet=True)
    body = fold(layout, "advanced", "Advanced")
    if body:
        body.prop(settings, "device")
        body.prop(settings, "overrides", placeholder="stage.field=value")


def _memory_line(settings: bpy.types.PropertyGroup) -> tuple[str, bool]:
    """What the job will take, and whether this machine has it."""
    return memory.line(settings.preset, int(settings.texture_size), session.free_memory())


def _draw_button(layout: bpy.types.UILayout, context: bpy.types.Context) -> None:
    """The one large button, and why it can't be pressed."""
    textures = context.scene.fantasia3d.task == "texture"
    column = layout.column()
    row = column.row()
    row.scale_y = 1.5
    if textures:
        reason = submit.reason_against_texture(context)
        word, name = "Texture", "fantasia3d.texture"
    else:
        reason = submit.reason_against(context)
        word, name = "Generate", "fantasia3d.generate"
    if session.busy:
        row.operator(name, text="Add to Queue", icon="ADD")
    else:
        row.operator(name, text=word, icon="SHADERFX")
    if reason:
        sentence(column, context, reason, "INFO", quiet=True)
    said, enough = _memory_line(context.scene.fantasia3d)
    if not enough and not session.running:
        sentence(column, context, said, "ERROR")


def _draw_run(layout: bpy.types.UILayout, context: bpy.types.Context, follow: Follow) -> None:
    """The picture, the bar, the time, and Cancel."""
    box, progress = layout.box().column(), follow.progress
    picture = icons.icon(follow.picture, at_once=True)
    if picture:
        box.template_icon(picture, scale=PICTURE)
    sentence(box, context, follow.prompt, "OUTLINER_OB_MESH")
    box.progress(factor=progress.share, text=progress.line)
    if progress.detail:
        sentence(box, context, progress.detail, quiet=True)
    if follow.warning:
        message(box, context, follow.warning, "INFO")
    row = box.row(align=True)
    if progress.overdue:
        row.operator("fantasia3d.stop_now", icon="X")
    else:
        row.enabled = not progress.cancelling
        row.operator("fantasia3d.cancel", icon="CANCEL").run = follow.name


def _draw_outcome(layout: bpy.types.UILayout, context: bpy.types.Context) -> None:
    """What came of the last run, and what came while nobody looked."""
    last = session.last
    if session.error:
        box = layout.box().column()
        message(box, context, session.error, "ERROR")
        row = box.row(align=True)
        row.operator("fantasia3d.open_log", icon="TEXT")
        if last and last.end and last.end.type == "error" and last.run.resumable:
            row.operator("fantasia3d.job_resume", icon="PLAY").folder = str(last.run.folder)
        row.operator("fantasia3d.dismiss", text="", icon="X")
    elif last and last.end and last.end.type == "cancelled":
        row = layout.row(align=True)
        row.label(text="Cancelled", icon="CANCEL")
        row.operator("fantasia3d.job_resume", icon="PLAY").folder = str(last.run.folder)
        row.operator("fantasia3d.dismiss", text="", icon="X")
    elif session.asset:
        sentence(layout, context, f"Made: {session.asset}", "CHECKMARK")
    for entry in session.missed:
        row = layout.row(align=True)
        row.label(text=f"Ready: {entry.prompt}", icon="CHECKMARK")
        row.operator("fantasia3d.job_import", icon="IMPORT").folder = str(entry.folder)
    if session.arriving:
        sentence(layout, context, f"The asset is ready. {obstacle()}", "CHECKMARK")


CLASSES = (FANTASIA3D_PT_generate, FANTASIA3D_PT_set_up)
