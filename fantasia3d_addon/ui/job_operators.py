"""The queue and the history by buttons."""

from __future__ import annotations

from pathlib import Path

import bpy
from bpy.props import BoolProperty, StringProperty

from ..jobs import history, submit
from ..jobs.history import Entry
from ..jobs.import_result import take_in
from ..jobs.job_settings import take_job
from ..jobs.session import session
from ..jobs.target import Target
from .operator_helpers import USER_ERRORS, import_at_cursor, queue_job, report_error


def selected(context: bpy.types.Context) -> Entry | None:
    """The run that is selected in the history's list."""
    jobs = context.window_manager.fantasia3d
    if not 0 <= jobs.index < len(jobs.entries):
        return None
    return entry_of(jobs.entries[jobs.index].name)


def entry_of(folder: str) -> Entry | None:
    """The history's entry for a run folder."""
    return next((e for e in session.history if str(e.folder) == folder), None)


class _OnRun:
    """An operator on one run: that of ``folder``, or the selected one."""

    folder: StringProperty(name="Run Folder", subtype="DIR_PATH", options={"SKIP_SAVE"})

    @staticmethod
    def reason(entry: Entry) -> str:
        """Why it can't be done with ``entry``; empty if it can."""
        return "" if entry.folder.is_dir() else "Its folder has gone."

    def entry(self, context: bpy.types.Context) -> Entry | None:
        if not self.folder:
            return selected(context)
        return entry_of(self.folder) or history.read_entry(Path(bpy.path.abspath(self.folder)))

    def execute(self, context: bpy.types.Context) -> set[str]:
        entry = self.entry(context)
        reason = self.reason(entry) if entry else "There is no such run."
        if entry is None or reason:
            self.report({"ERROR"}, reason)
            return {"CANCELLED"}
        return self.act(context, entry)


class FANTASIA3D_OT_job_repeat(_OnRun, bpy.types.Operator):
    """Do this job once more, with the same settings"""

    bl_idname = "fantasia3d.job_repeat"
    bl_label = "Repeat"

    vary_seed: BoolProperty(name="Vary the Seed", options={"SKIP_SAVE"})

    @classmethod
    def description(
        cls, context: bpy.types.Context, properties: bpy.types.OperatorProperties
    ) -> str:
        """The button has two meanings."""
        how = "another seed" if properties.vary_seed else "the same seed, for the same result"
        return f"Do this job once more, with {how}"

    def act(self, context: bpy.types.Context, entry: Entry) -> set[str]:
        return queue_job(self, lambda: submit.repeat(context, entry, self.vary_seed))


class FANTASIA3D_OT_job_resume(_OnRun, bpy.types.Operator):
    """Go on with this job from its last checkpoint"""

    bl_idname = "fantasia3d.job_resume"
    bl_label = "Resume"

    def act(self, context: bpy.types.Context, entry: Entry) -> set[str]:
        def resume() -> Path:
            submit.resume(context, entry)
            return entry.folder

        return queue_job(self, resume)


class FANTASIA3D_OT_job_import(_OnRun, bpy.types.Operator):
    """Put this job's asset into the scene: at the 3D cursor, or onto its object"""

    bl_idname = "fantasia3d.job_import"
    bl_label = "Import"
    bl_options = {"REGISTER", "UNDO"}

    @staticmethod
    def reason(entry: Entry) -> str:
        if bpy.context.mode != "OBJECT":
            return "Leave the edit mode first."
        if entry.state != history.DONE:
            return _OnRun.reason(entry) or "It has no asset yet."
        there = (entry.folder / "asset" / "asset.json").is_file()
        return "" if there else "Its asset has gone from the disk. Press Repeat to make it again."

    def act(self, context: bpy.types.Context, entry: Entry) -> set[str]:
        target = Target.read(entry.folder)
        try:
            if target.object in bpy.data.objects:
                take_in(entry.folder, target, context.scene, push_undo=False)
                session.mark_imported(entry.folder)
            else:
                import_at_cursor(context, entry.folder)
        except USER_ERRORS as error:
            return report_error(self, error)
        return {"FINISHED"}


class FANTASIA3D_OT_job_settings(_OnRun, bpy.types.Operator):
    """Set the panel's fields to those of this job"""

    bl_idname = "fantasia3d.job_settings"
    bl_label = "Use Settings"
    bl_options = {"UNDO"}

    def act(self, context: bpy.types.Context, entry: Entry) -> set[str]:
        take_job(context.scene.fantasia3d, entry.job)
        return {"FINISHED"}


class FANTASIA3D_OT_job_folder(_OnRun, bpy.types.Operator):
    """Open this job's folder"""

    bl_idname = "fantasia3d.job_folder"
    bl_label = "Open Folder"

    def act(self, context: bpy.types.Context, entry: Entry) -> set[str]:
        return bpy.ops.wm.path_open(filepath=str(entry.folder))


class FANTASIA3D_OT_job_remove(_OnRun, bpy.types.Operator):
    """Remove this job and its asset from the disk; what is in a scene stays"""

    bl_idname = "fantasia3d.job_remove"
    bl_label = "Remove"

    @staticmethod
    def reason(entry: Entry) -> str:
        ours = any(follow.run.folder == entry.folder for follow in session.running)
        return "It is running. Cancel it first." if ours else ""

    def invoke(self, context: bpy.types.Context, event: bpy.types.Event) -> set[str]:
        return context.window_manager.invoke_confirm(self, event)

    def act(self, context: bpy.types.Context, entry: Entry) -> set[str]:
        try:
            session.drop(entry.folder)
            history.remove(entry)
        except USER_ERRORS as error:
            return report_error(self, error)
        session.refresh()
        return {"FINISHED"}


class FANTASIA3D_OT_queue_drop(bpy.types.Operator):
    """Take this job out of the queue"""

    bl_idname = "fantasia3d.queue_drop"
    bl_label = "Take Out"

    folder: StringProperty(name="Run Folder", subtype="DIR_PATH", options={"SKIP_SAVE"})

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        cls.poll_message_set("Nothing waits.")
        return bool(session.waiting)

    def execute(self, context: bpy.types.Context) -> set[str]:
        try:
            session.drop(Path(self.folder) if self.folder else session.waiting[-1][0])
        except USER_ERRORS as error:
            return report_error(self, error)
        return {"FINISHED"}


class FANTASIA3D_OT_queue_go_on(bpy.types.Operator):
    """Begin with the jobs that an earlier Blender left waiting"""

    bl_idname = "fantasia3d.queue_go_on"
    bl_label = "Start the Queue"

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        cls.poll_message_set("The queue is not paused.")
        return session.paused and bool(session.waiting)

    def execute(self, context: bpy.types.Context) -> set[str]:
        session.paused = False
        session.watch()
        return {"FINISHED"}


class FANTASIA3D_OT_refresh(bpy.types.Operator):
    """Look for runs anew: those of other Blenders and of the command line too"""

    bl_idname = "fantasia3d.refresh"
    bl_label = "Refresh"

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
