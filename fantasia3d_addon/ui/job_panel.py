"""The queue and the history in the sidebar's tab."""

from __future__ import annotations

import time

import bpy
from bpy.app.translations import pgettext_iface as translated

from ..jobs import history
from ..jobs.events import STAGES
from ..jobs.history import Entry
from ..jobs.session import session
from . import icons
from .job_operators import entry_of, selected
from .text import TAB, duration, length, wrapped_label

ICONS = {
    history.WAITING: "TIME",
    history.RUNNING: "PLAY",
    history.DONE: "CHECKMARK",
    history.FAILED: "ERROR",
    history.CANCELLED: "CANCEL",
    history.STOPPED: "ERROR",
    history.PAUSED: "PAUSE",
}
STATES = {history.WAITING: "Queued"}  # as the panel names them where it differs
PICTURE = 6.0  # height in rows


class FANTASIA3D_UL_runs(bpy.types.UIList):
    """One line for each run."""

    def draw_item(self, context, layout, data, item, icon, active_data, active_property) -> None:
        entry = entry_of(item.name)
        if entry is None:  # removed since the list was made
            layout.label(text="…")
            return
        picture = icons.icon(entry.pictures)
        row = layout.row(align=True)
        if picture:
            row.label(text=entry.prompt, icon_value=picture, translate=False)
        else:
            row.label(text=entry.prompt, icon="OUTLINER_OB_MESH", translate=False)
        end = row.row()
        end.active = False
        end.alignment = "RIGHT"
        end.label(text=length(entry.size_m) if entry.size_m else "", icon=ICONS[entry.state])

    def filter_items(self, context, data, property) -> tuple[list[int], list[int]]:
        """By prompt."""
        items = getattr(data, property)
        words = self.filter_name.lower()
        if not words:
            return [], []  # all, in the given order
        shown = {str(entry.folder) for entry in session.history if words in entry.prompt.lower()}
        return [self.bitflag_filter_item if item.name in shown else 0 for item in items], []


class FANTASIA3D_PT_jobs(bpy.types.Panel):
    """Queue and history."""

    bl_idname = "FANTASIA3D_PT_jobs"
    bl_label = "Jobs"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = TAB
    bl_options = {"DEFAULT_CLOSED"}
    bl_order = 1

    def draw_header_preset(self, context: bpy.types.Context) -> None:
        self.layout.operator("fantasia3d.refresh", text="", icon="FILE_REFRESH", emboss=False)

    def draw(self, context: bpy.types.Context) -> None:
        layout, jobs = self.layout, context.window_manager.fantasia3d
        _draw_queue(layout, context)
        if not len(jobs.entries):
            wrapped_label(layout, context, "No jobs yet.", dimmed=True)
            layout.operator("fantasia3d.import_asset", text="Import from Folder", icon="IMPORT")
            return
        layout.template_list("FANTASIA3D_UL_runs", "", jobs, "entries", jobs, "index", rows=4)
        entry = selected(context)
        if entry:
            _draw_entry(layout, context, entry)
        layout.operator("fantasia3d.import_asset", text="Import from Folder", icon="IMPORT")


def _draw_queue(layout: bpy.types.UILayout, context: bpy.types.Context) -> None:
    if not session.waiting:
        return
    box = layout.box().column(align=True)
    for number, (folder, _) in enumerate(session.waiting, 1):
        row = box.row(align=True)
        entry = entry_of(str(folder))
        text = f"{number}. {entry.prompt if entry else folder.name}"
        row.label(text=text, icon="TIME", translate=False)
        row.operator("fantasia3d.queue_drop", text="", icon="X", emboss=False).folder = str(folder)
    if session.paused:
        text = "These jobs were queued in an earlier Blender session."
        wrapped_label(box, context, text, dimmed=True)
        box.operator("fantasia3d.queue_go_on", text="Resume Queue", icon="PLAY")


def _draw_entry(layout: bpy.types.UILayout, context: bpy.types.Context, entry: Entry) -> None:
    """The selected run: its picture, its exact settings, its buttons."""
    box = layout.box().column()
    picture = icons.icon(entry.pictures)
    if picture:
        box.template_icon(picture, scale=PICTURE)
    wrapped_label(box, context, entry.prompt, as_it_is=True)
    column = box.column(align=True)
    for line in facts(entry):
        wrapped_label(column, context, line, dimmed=True)
    if entry.state in (history.FAILED, history.STOPPED):
        wrapped_label(box, context, entry.text or "No error reported.", "ERROR")
    path = str(entry.folder)
    row = box.row(align=True)
    if entry.state == history.DONE:
        row.operator("fantasia3d.job_import", text="Import", icon="IMPORT").folder = path
    elif entry.resumable:
        row.operator("fantasia3d.job_resume", text="Resume", icon="PLAY").folder = path
    row.operator("fantasia3d.job_settings", text="Use Settings", icon="COPYDOWN").folder = path
    row = box.row(align=True)
    row.operator("fantasia3d.job_repeat", text="Repeat", icon="LOOP_BACK").folder = path
    vary = row.operator("fantasia3d.job_repeat", text="Vary Seed", icon="FILE_REFRESH")
    vary.folder, vary.vary_seed = path, True
    if entry.state == history.DONE:
        button = box.operator("fantasia3d.recolor", text="Explore Materials", icon="COLOR")
        button.folder = path
    row = box.row(align=True)
    row.operator("fantasia3d.job_folder", text="Open Folder", icon="FILE_FOLDER").folder = path
    row.operator("fantasia3d.job_remove", text="Delete", icon="TRASH").folder = path


def facts(entry: Entry) -> list[str]:
    """The settings of a run that distinguish it from others, in a few short lines."""
    job, done = entry.job, entry.state == history.DONE
    when = time.strftime("%Y-%m-%d, %H:%M", time.localtime(entry.requested))
    took = f", {duration(entry.seconds)}" if done else ""
    stage = f", {translated(STAGES.get(entry.stage, entry.stage))}" if entry.stage else ""
    name = translated(STATES.get(entry.state, entry.state.capitalize()))
    state = "" if done else f"{name}{stage}"
    lines = [f"{when}{took}", state]
    lines.append(f"{str(job.get('preset', '')).capitalize()}, seed {job.get('seed', 0)}")
    if entry.size_m:
        lines.append(f"{translated('Size')}: {length(entry.size_m)}")
    # Only what differs from the default.
    if job.get("negative_prompt"):
        lines.append(f"{translated('Negative Prompt')}: {job['negative_prompt']}")
    if job.get("guidance", "builtin") != "builtin":
        lines.append(f"{translated('Model')}: {job['guidance']}")
    if job.get("guide_mesh"):
        lines.append(f"Guide mesh, strength {job.get('guide_strength', 0.5):.2g}")
    if job.get("light", "studio") != "studio":
        # The file's name alone; chr(92) is the backslash of Windows.
        name = job["light"].replace(chr(92), "/").rpartition("/")[2]
        lines.append(f"{translated('Light')}: {name}")
    for key, unit in (("texture_size", "texels"), ("max_faces", "faces")):
        if job.get(key):
            lines.append(f"{job[key]} {unit}")
    lines += [f"{key} = {value}" for key, value in job.get("settings", {}).items()]
    return [line for line in lines if line]


CLASSES = (FANTASIA3D_UL_runs, FANTASIA3D_PT_jobs)
