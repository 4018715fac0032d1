"""Candidates: several quick shapes or materials; the user finishes one of them."""

from __future__ import annotations

import bpy
from bpy.app.translations import pgettext_iface as translated

from ..jobs import history, submit
from ..jobs.history import Entry
from ..jobs.session import session
from . import icons
from .job_operators import RunOperator
from .operator_helpers import USER_ERRORS, allowed, needs, queue_job, report_error

PICTURE = 5.0  # height of a candidate's, in rows
COLUMNS = 2


class FANTASIA3D_OT_explore(bpy.types.Operator):
    """Make several quick shapes next to each other, with other seeds, to choose one from"""

    bl_idname = "fantasia3d.explore"
    bl_label = "Explore Shapes"

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        return allowed(cls, submit.reason_against_generate(context))

    def execute(self, context: bpy.types.Context) -> set[str]:
        return queue_job(self, lambda: submit.explore(context))


class FANTASIA3D_OT_recolor(RunOperator, bpy.types.Operator):
    """Make several quick materials for this job's shape, to choose one from"""

    bl_idname = "fantasia3d.recolor"
    bl_label = "Explore Materials"

    @staticmethod
    def reason_against(entry: Entry) -> str:
        return submit.reason_against_recolor(entry)

    def act(self, context: bpy.types.Context, entry: Entry) -> set[str]:
        return queue_job(self, lambda: submit.recolor(context, entry))


class FANTASIA3D_OT_finish_candidate(RunOperator, bpy.types.Operator):
    """Finish this candidate from where it paused; the asset is that of an unbroken run"""

    bl_idname = "fantasia3d.finish_candidate"
    bl_label = "Finish Candidate"

    @staticmethod
    def reason_against(entry: Entry) -> str:
        return "" if entry.candidate.is_open else "It is not a candidate."

    def act(self, context: bpy.types.Context, entry: Entry) -> set[str]:
        try:
            submit.finish(context, entry)
        except USER_ERRORS as error:
            return report_error(self, error)
        return {"FINISHED"}


class FANTASIA3D_OT_discard_candidates(bpy.types.Operator):
    """Delete the candidates that were not chosen; one that is being made is cancelled"""

    bl_idname = "fantasia3d.discard_candidates"
    bl_label = "Discard Other Candidates"

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        return needs(cls, history.open_candidates(session.history), "There are no candidates.")

    def execute(self, context: bpy.types.Context) -> set[str]:
        try:
            submit.discard(history.open_candidates(session.history))
        except USER_ERRORS as error:
            return report_error(self, error)
        return {"FINISHED"}


def draw_candidates(layout: bpy.types.UILayout) -> None:
    """The candidates of the last Explore in a grid, each with its button."""
    entries = history.open_candidates(session.history)
    if not entries:
        return
    box = layout.box().column()
    box.label(text="Candidates", icon="IMGDISPLAY")
    grid = box.grid_flow(row_major=True, columns=COLUMNS, even_columns=True, align=True)
    for entry in entries:
        _draw_candidate(grid.box().column(align=True), entry)
    chosen = any(not entry.candidate.is_open for entry in entries)
    box.operator(
        "fantasia3d.discard_candidates",
        text="Discard Others" if chosen else "Discard All",
        icon="TRASH",
    )


def _draw_candidate(column: bpy.types.UILayout, entry: Entry) -> None:
    running = entry.folder.name in session.names
    picture = icons.icon(entry.pictures)
    if picture:
        column.template_icon(picture, scale=PICTURE)
    else:
        column.label(text="Running" if running else "Queued")
    seed = entry.job.get("color_seed") or entry.job.get("seed", 0)
    row = column.row()
    row.enabled = entry.candidate.is_open and not running
    if entry.candidate.is_open:
        button = row.operator("fantasia3d.finish_candidate", text="Finish This One")
        button.folder = str(entry.folder)
    else:
        row.label(text="Chosen", icon="CHECKMARK")
    column.label(text=f"{translated('Seed')} {seed}", translate=False)


CLASSES = (
    FANTASIA3D_OT_explore,
    FANTASIA3D_OT_recolor,
    FANTASIA3D_OT_finish_candidate,
    FANTASIA3D_OT_discard_candidates,
)
