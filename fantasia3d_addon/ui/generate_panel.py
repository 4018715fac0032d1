"""The main panel: what to make, its progress, its result."""

from __future__ import annotations

import bpy
from bpy.app.translations import pgettext_iface as translated

from ..blender import compat
from ..jobs import environment_setup, live_preview, memory, submit
from ..jobs.import_result import reason_to_wait
from ..jobs.job_settings import FILE
from ..jobs.progress import FollowedRun
from ..jobs.session import session
from ..scene import view
from . import icons
from .candidates import draw_candidates
from .presets import FANTASIA3D_PT_presets
from .setup_panel import FANTASIA3D_PT_set_up, draw_set_up
from .text import TAB, collapsible, error_and_fix, wrapped_label
from .words_menu import draw_understood

PICTURE = 7.0  # height of the preview, in rows


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
        if not environment_setup.is_installed():
            box = layout.box()
            wrapped_label(box, context, "Installation required", "INFO")
            draw_set_up(box, context)
        layout.row().prop(settings, "task", expand=True)
        column = layout.column(align=True)
        compat.text_field(column, settings, "prompt", placeholder="a red wooden chair")
        column.prop(settings, "negative_prompt", text="", placeholder="Negative prompt")
        draw_understood(layout, context)
        layout.use_property_split = True
        layout.use_property_decorate = False
        _draw_settings(layout, settings)
        if settings.task == "texture":
            _draw_mesh(layout, context)
        _draw_collapsed(layout, context)
        _draw_button(layout, context)
        for followed in session.running:
            _draw_run(layout, context, followed)
        draw_candidates(layout)
        _draw_result(layout, context)


def _draw_settings(layout: bpy.types.UILayout, settings: bpy.types.PropertyGroup) -> None:
    column = layout.column()
    column.prop(settings, "preset")
    row = column.row(align=True)
    row.prop(settings, "seed")
    row.operator("fantasia3d.new_seed", text="", icon="FILE_REFRESH")
    if settings.task == "generate":
        row = column.row()
        row.prop(settings, "size")
        if not settings.size:
            row.label(text="Usual")
    column.prop(settings, "guidance")
    if settings.guidance == "folder":
        column.prop(settings, "model_folder")
        column.menu("FANTASIA3D_MT_models", icon="FILE_FOLDER")
    elif settings.guidance == "hub":
        column.prop(settings, "hub_id", placeholder="owner/name")
    if settings.guidance != "builtin":
        column.prop(settings, "lora")
        row = column.row()
        row.active = bool(settings.lora.strip())
        row.prop(settings, "lora_strength")
        column.prop(settings, "embedding")


def _draw_mesh(layout: bpy.types.UILayout, context: bpy.types.Context) -> None:
    """The settings of a job that textures the active mesh."""
    settings, obj = context.scene.fantasia3d, context.active_object
    column = layout.column()
    # A label in the two columns of Blender's property split, which labels do not follow.
    split = column.split(factor=0.4)
    right = split.row()
    right.alignment = "RIGHT"
    right.label(text="Mesh")
    is_mesh = obj is not None and obj.type == "MESH"
    text = obj.name if is_mesh else translated("None selected")
    split.label(text=text, icon="OUTLINER_OB_MESH", translate=False)
    column.row().prop(settings, "uv", expand=True)
    column.row().prop(settings, "assign", expand=True)
    column.prop(settings, "use_present_color")
    if settings.use_present_color:
        column.prop(settings, "color_strength")


def _draw_collapsed(layout: bpy.types.UILayout, context: bpy.types.Context) -> None:
    """Settings that the quality decides unless they are set here."""
    settings = context.scene.fantasia3d
    if settings.task == "generate":
        _draw_guide(layout, settings)
    body = collapsible(layout, "light", "Light")
    if body:
        body.template_icon_view(settings, "light", show_labels=True, scale=5, scale_popup=5)
        body.prop(settings, "light", text="")
        if settings.light == FILE:
            body.prop(settings, "light_file", text="")
    body = collapsible(layout, "output", "Output")
    if body:
        body.prop(settings, "texture_size")
        if settings.task == "generate":
            body.prop(settings, "max_faces")
            body.prop(settings, "placement")
        wrapped_label(body, context, _memory_line(settings)[0], dimmed=True)
    body = collapsible(layout, "advanced", "Advanced")
    if body:
        body.prop(settings, "device")
        body.prop(settings, "overrides", placeholder="stage.field=value")


def _draw_guide(layout: bpy.types.UILayout, settings: bpy.types.PropertyGroup) -> None:
    body = collapsible(layout, "guide", "Guide Mesh")
    if body:
        row = body.row(align=True)
        row.prop(settings, "guide")
        row.operator("fantasia3d.guide_from_selection", text="", icon="RESTRICT_SELECT_OFF")
        row = body.row()
        row.active = settings.guide is not None
        row.prop(settings, "guide_strength")


def _memory_line(settings: bpy.types.PropertyGroup) -> tuple[str, bool]:
    """The memory that the job needs as text, and whether this machine has it."""
    return memory.line(settings.preset, int(settings.texture_size), session.free_memory())


def _draw_button(layout: bpy.types.UILayout, context: bpy.types.Context) -> None:
    """The large button, and why it is disabled."""
    if context.scene.fantasia3d.task == "texture":
        reason = submit.reason_against_texture(context)
        label, operator = "Texture", "fantasia3d.texture"
    else:
        reason = submit.reason_against_generate(context)
        label, operator = "Generate", "fantasia3d.generate"
    column = layout.column()
    row = column.row()
    row.scale_y = 1.5
    if session.busy:
        row.operator(operator, text="Add to Queue", icon="ADD")
    else:
        row.operator(operator, text=label, icon="SHADERFX")
    if context.scene.fantasia3d.task == "generate":
        row = column.row(align=True)
        row.operator("fantasia3d.explore", text="Explore", icon="IMGDISPLAY")
        row.prop(context.scene.fantasia3d, "candidates", text="")
    if reason:
        wrapped_label(column, context, reason, "INFO", dimmed=True)
    text, is_enough = _memory_line(context.scene.fantasia3d)
    # While a job runs, its own memory is in use: the sum would be wrong.
    if not is_enough and not session.running:
        wrapped_label(column, context, text, "ERROR")


def _draw_run(
    layout: bpy.types.UILayout, context: bpy.types.Context, followed: FollowedRun
) -> None:
    """The picture, the progress bar, the time left, and Cancel."""
    box, progress = layout.box().column(), followed.progress
    picture = icons.icon((followed.picture,)) if followed.picture else 0
    if picture:
        box.template_icon(picture, scale=PICTURE)
    wrapped_label(box, context, followed.prompt, "OUTLINER_OB_MESH", as_it_is=True)
    title = translated(progress.title if not progress.cancelling else progress.line)
    percent = f"  {progress.fraction:.0%}" if progress.steps and not progress.cancelling else ""
    box.progress(factor=progress.fraction, text=title + percent)
    if progress.detail:
        wrapped_label(box, context, progress.detail, dimmed=True)
    if followed.warning:
        error_and_fix(box, context, followed.warning, "INFO")
    row = box.row(align=True)
    if progress.overdue:
        row.operator("fantasia3d.stop_now", text="Stop Now", icon="X")
    else:
        row.enabled = not progress.cancelling
        row.operator("fantasia3d.cancel", text="Cancel", icon="CANCEL").run = followed.name
    if live_preview.find(followed.name):
        is_alone = context.space_data and context.space_data.local_view
        icon = "HIDE_ON" if is_alone else "HIDE_OFF"
        box.operator("fantasia3d.local_view", text="Local View", icon=icon).run = followed.name


def _draw_result(layout: bpy.types.UILayout, context: bpy.types.Context) -> None:
    """The result of the last run, and assets that wait for their import."""
    last = session.last
    if session.error:
        _draw_error(layout, context, session.error)
    elif last and last.end and last.end.type == "cancelled":
        row = layout.row(align=True)
        row.label(text="Cancelled", icon="CANCEL")
        row.operator("fantasia3d.job_resume", text="Resume", icon="PLAY").folder = str(
            last.run.folder
        )
        row.operator("fantasia3d.dismiss", text="", icon="X")
    elif session.asset:
        text = f"{translated('Imported')}: {session.asset}"
        wrapped_label(layout, context, text, "CHECKMARK", as_it_is=True)
        if view.hides_colors(context.space_data):
            row = layout.row(align=True)
            for shading, text in (("MATERIAL", "Material Preview"), ("TEXTURE", "Texture Color")):
                button = row.operator("fantasia3d.show_colors", text=text)
                button.shading = shading
    for entry in session.missed:
        row = layout.row(align=True)
        text = f"{translated('Ready')}: {entry.prompt}"
        row.label(text=text, icon="CHECKMARK", translate=False)
        row.operator("fantasia3d.job_import", text="Import", icon="IMPORT").folder = str(
            entry.folder
        )
    if session.importing:
        wrapped_label(layout, context, f"The asset is ready. {reason_to_wait()}", "CHECKMARK")


def _draw_error(
    layout: bpy.types.UILayout, context: bpy.types.Context, error: tuple[str, str]
) -> None:
    last = session.last
    box = layout.box().column()
    error_and_fix(box, context, error, "ERROR")
    row = box.row(align=True)
    row.operator("fantasia3d.open_log", text="Open Log", icon="TEXT")
    if last and last.end and last.end.type == "error" and last.run.resumable:
        row.operator("fantasia3d.job_resume", text="Resume", icon="PLAY").folder = str(
            last.run.folder
        )
    row.operator("fantasia3d.dismiss", text="", icon="X")


CLASSES = (FANTASIA3D_PT_generate, FANTASIA3D_PT_set_up)
