"""The operators of the queue and the history."""

from __future__ import annotations

from pathlib import Path

import bpy
from bpy.props import BoolProperty, StringProperty

from ..asset.import_asset import can_link
from ..blender.mesh_arrays import EDIT_MODE
from ..jobs import history, submit
from ..jobs.history import Entry
from ..jobs.import_result import import_result, is_as_sent
from ..jobs.job_settings import apply_job
from ..jobs.session import session
from ..jobs.target import Target
from .operator_helpers import USER_ERRORS, import_and_select, needs, queue_job, report_error
from .text import in_language

RUN_FOLDER = "The folder of the run; empty: the one that is selected in the list"


def selected(context: bpy.types.Context) -> Entry | None:
    """The run that is selected in the history's list."""
    jobs = context.window_manager.fantasia3d
    if not 0 <= jobs.index < len(jobs.entries):
        return None
    return entry_of(jobs.entries[jobs.index].name)


def entry_of(folder: str) -> Entry | None:
    """The history's entry for a run folder."""
    return next((e for e in session.history if str(e.folder) == folder), None)


class RunOperator:
    """Mixin: an operator on the run in ``folder``, or else on the selected one."""

    # SKIP_SAVE: a button without a folder must not act on the folder of the last press.
    folder: StringProperty(
        name="Run Folder", description=RUN_FOLDER, subtype="DIR_PATH", options={"SKIP_SAVE"}
    )

    @staticmethod
    def reason_against(entry: Entry) -> str:
        """Why it can't be done with ``entry``; empty if it can."""
        return "" if entry.folder.is_dir() else "Its folder no longer exists."

    def entry(self, context: bpy.types.Context) -> Entry | None:
        if not self.folder:
            return selected(context)
        return entry_of(self.folder) or history.read_entry(Path(bpy.path.abspath(self.folder)))

    def execute(self, context: bpy.types.Context) -> set[str]:
        entry = self.entry(context)
        reason = self.reason_against(entry) if entry else "There is no such run."
        if entry is None or reason:
            self.report({"ERROR"}, in_language(reason))
            return {"CANCELLED"}
        return self.act(context, entry)


class FANTASIA3D_OT_job_repeat(RunOperator, bpy.types.Operator):
    """Run this job again, with the same settings"""

    bl_idname = "fantasia3d.job_repeat"
    bl_label = "Repeat Job"

    vary_seed: BoolProperty(name="Vary Seed", description="Use another seed", options={"SKIP_SAVE"})

    @classmethod
    def description(
        cls, context: bpy.types.Context, properties: bpy.types.OperatorProperties
    ) -> str:
        """The tooltip: two buttons use this operator."""
        how = "another seed" if properties.vary_seed else "the same seed, for the same result"
        return f"Run this job again, with {how}"

    def act(self, context: bpy.types.Context, entry: Entry) -> set[str]:
        return queue_job(self, lambda: submit.repeat(context, entry, self.vary_seed))


class FANTASIA3D_OT_job_resume(RunOperator, bpy.types.Operator):
    """Continue this job from its last checkpoint"""

    bl_idname = "fantasia3d.job_resume"
    bl_label = "Resume Job"

    def act(self, context: bpy.types.Context, entry: Entry) -> set[str]:
        def resume() -> Path:
            submit.resume(context, entry)
            return entry.folder

        return queue_job(self, resume)


def _has_object(entry: Entry, target: Target) -> bool:
    """Whether the object that the job of ``entry`` was given is here, with the same mesh."""
    obj = bpy.data.objects.get(target.object)
    here = obj is not None and session.is_requested_here(entry.folder, target)
    return here and is_as_sent(obj, entry.folder, target)


class FANTASIA3D_OT_job_import(RunOperator, bpy.types.Operator):
    """Import this job's asset into the scene, or its material onto its object"""

    bl_idname = "fantasia3d.job_import"
    bl_label = "Import Job's Asset"
    bl_options = {"REGISTER", "UNDO"}

    @staticmethod
    def reason_against(entry: Entry) -> str:
        if bpy.context.mode != "OBJECT":
            return EDIT_MODE
        if entry.state != history.DONE:
            return RunOperator.reason_against(entry) or "It has no asset yet."
        exists = (entry.folder / "asset" / "asset.json").is_file()
        return "" if exists else "Its asset no longer exists. Press Repeat to generate it again."

    def act(self, context: bpy.types.Context, entry: Entry) -> set[str]:
        target = Target.read(entry.folder)
        try:
            if _has_object(entry, target):
                # The operator is an undo step already.
                import_result(entry.folder, target, context.scene, push_undo=False)
                session.mark_imported(entry.folder)
                return {"FINISHED"}
            here = context.collection
            where = here if can_link(here) else context.scene.collection
            with context.temp_override(collection=where):
                obj = import_and_select(context, entry.folder)
        except USER_ERRORS as error:
            return report_error(self, error)
        if target.object:
            what = f"“{target.object}” of the job's file is missing, or its mesh was changed."
            self.report({"INFO"}, in_language(f"{what} The asset is a new object: “{obj.name}”."))
        return {"FINISHED"}


class FANTASIA3D_OT_job_settings(RunOperator, bpy.types.Operator):
    """Set the panel's fields to those of this job"""

    bl_idname = "fantasia3d.job_settings"
    bl_label = "Use Job's Settings"
    bl_options = {"UNDO"}

    def act(self, context: bpy.types.Context, entry: Entry) -> set[str]:
        try:
            apply_job(context.scene.fantasia3d, entry.job)
        except USER_ERRORS as error:
            return report_error(self, error)
        return {"FINISHED"}


class FANTASIA3D_OT_job_folder(RunOperator, bpy.types.Operator):
    """Open this job's folder"""

    bl_idname = "fantasia3d.job_folder"
    bl_label = "Open Job's Folder"

    def act(self, context: bpy.types.Context, entry: Entry) -> set[str]:
        return bpy.ops.wm.path_open(filepath=str(entry.folder))


class FANTASIA3D_OT_job_remove(RunOperator, bpy.types.Operator):
    """Delete this job and its asset from the disk; what was imported stays in its scene"""

    bl_idname = "fantasia3d.job_remove"
    bl_label = "Delete Job"

    @staticmethod
    def reason_against(entry: Entry) -> str:
        ours = any(followed.run.folder == entry.folder for followed in session.running)
        return "It is running. Cancel it first." if ours else ""

    def invoke(self, context: bpy.types.Context, event: bpy.types.Event) -> set[str]:
        return context.window_manager.invoke_confirm(self, event)

    def act(self, context: bpy.types.Context, entry: Entry) -> set[str]:
        try:
            session.remove_from_queue(entry.folder)
            history.remove(entry)
            session.forget_candidate(entry.folder)
        except USER_ERRORS as error:
            return report_error(self, error)
        session.refresh()
        return {"FINISHED"}


class FANTASIA3D_OT_queue_drop(bpy.types.Operator):
    """Remove this job from the queue"""

    bl_idname = "fantasia3d.queue_drop"
    bl_label = "Remove from Queue"

    folder: StringProperty(
        name="Run Folder", description="The folder of the run; empty: the last of the queue",
        subtype="DIR_PATH", options={"SKIP_SAVE"},
    )  # fmt: skip

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        return needs(cls, session.waiting, "The queue is empty.")

    def execute(self, context: bpy.types.Context) -> set[str]:
        folder = Path(self.folder) if self.folder else session.waiting[-1][0]
        try:
            session.remove_from_queue(folder)
        except USER_ERRORS as error:
            return report_error(self, error)
        return {"FINISHED"}


class FANTASIA3D_OT_queue_go_on(bpy.types.Operator):
    """Start the jobs that were queued in an earlier Blender session"""

    bl_idname = "fantasia3d.queue_go_on"
    bl_label = "Resume Queue"

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        return needs(cls, session.paused and session.waiting, "The queue is not paused.")

    def execute(self, context: bpy.types.Context) -> set[str]:
        session.paused = False
        session.start_timer()
        return {"FINISHED"}


class FANTASIA3D_OT_refresh(bpy.types.Operator):
    """Look for runs again, also those of other Blenders and of the command line"""

    bl_idname = "fantasia3d.refresh"
    bl_label = "Refresh Jobs"

    def execute(self, context: bpy.types.Context) -> set[str]:
        session.adopt(context)
        session.refresh()
        return {"FINISHED"}


CLASSES = (
    FANTASIA3D_OT_job_repeat,
    FANTASIA3D_OT_job_resume,
    FANTASIA3D_OT_job_import,
    FANTASIA3D_OT_job_settings,
    FANTASIA3D_OT_job_folder,
    FANTASIA3D_OT_job_remove,
    FANTASIA3D_OT_queue_drop,
    FANTASIA3D_OT_queue_go_on,
    FANTASIA3D_OT_refresh,
)
