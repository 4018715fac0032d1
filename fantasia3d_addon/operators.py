"""The operators: each reads properties, calls one function, and reports."""

from __future__ import annotations

import random
from pathlib import Path

import bpy
from bpy.props import StringProperty

from .environment import SetupError
from .errors import AddonError
from .import_asset import import_asset
from .preferences import Machine
from .session import session

MENDABLE = (AddonError, SetupError)


class FANTASIA3D_OT_generate(bpy.types.Operator):
    """Make a textured mesh from the prompt, in the background"""

    bl_idname = "fantasia3d.generate"
    bl_label = "Generate"

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        """Says why it can't be pressed."""
        reason = reason_against(context)
        cls.poll_message_set(reason)
        return not reason

    def execute(self, context: bpy.types.Context) -> set[str]:
        try:
            run = session.generate(context)
        except MENDABLE as error:
            return refuse(self, error)
        self.report({"INFO"}, f"Started in {run.folder}")
        return {"FINISHED"}


class FANTASIA3D_OT_cancel(bpy.types.Operator):
    """Stop after the present step; the run can be resumed"""

    bl_idname = "fantasia3d.cancel"
    bl_label = "Cancel"

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        cls.poll_message_set("Nothing is running.")
        return session.busy

    def execute(self, context: bpy.types.Context) -> set[str]:
        session.cancel()
        return {"FINISHED"}


class FANTASIA3D_OT_import_asset(bpy.types.Operator):
    """Put an asset folder into the scene, at the 3D cursor"""

    bl_idname = "fantasia3d.import_asset"
    bl_label = "Import Asset"
    bl_options = {"REGISTER", "UNDO"}

    directory: StringProperty(name="Folder", subtype="DIR_PATH")
    filter_folder: bpy.props.BoolProperty(default=True, options={"HIDDEN"})

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        cls.poll_message_set("Leave the edit mode first.")
        return context.mode == "OBJECT"

    def invoke(self, context: bpy.types.Context, event: bpy.types.Event) -> set[str]:
        context.window_manager.fileselect_add(self)
        return {"RUNNING_MODAL"}

    def execute(self, context: bpy.types.Context) -> set[str]:
        folder = Path(bpy.path.abspath(self.directory))
        try:
            obj = import_asset(context, folder, context.scene.cursor.location)
        except MENDABLE as error:
            return refuse(self, error)
        for other in context.selected_objects:
            other.select_set(False)
        obj.select_set(True)
        context.view_layer.objects.active = obj
        return {"FINISHED"}


class FANTASIA3D_OT_new_seed(bpy.types.Operator):
    """Draw another seed"""

    bl_idname = "fantasia3d.new_seed"
    bl_label = "New Seed"
    bl_options = {"UNDO"}

    def execute(self, context: bpy.types.Context) -> set[str]:
        context.scene.fantasia3d.seed = random.randrange(2**31)
        return {"FINISHED"}


class FANTASIA3D_OT_open_log(bpy.types.Operator):
    """Open what the last run printed"""

    bl_idname = "fantasia3d.open_log"
    bl_label = "Open Log"

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        cls.poll_message_set("There is no log yet.")
        return session.run is not None and session.run.log.exists()

    def execute(self, context: bpy.types.Context) -> set[str]:
        return bpy.ops.wm.path_open(filepath=str(session.run.log))


class FANTASIA3D_OT_set_up(bpy.types.Operator):
    """Make the core's own Python environment; nothing is installed into Blender"""

    bl_idname = "fantasia3d.set_up"
    bl_label = "Set Up"

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        """Says why it can't be pressed."""
        reason = reason_against_set_up()
        cls.poll_message_set(reason)
        return not reason

    def execute(self, context: bpy.types.Context) -> set[str]:
        try:
            session.set_up(context)
        except MENDABLE as error:
            return refuse(self, error)
        return {"FINISHED"}


class FANTASIA3D_OT_check(bpy.types.Operator):
    """See what is here and what is missing"""

    bl_idname = "fantasia3d.check"
    bl_label = "Check"

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        cls.poll_message_set("The set-up is running.")
        return not (session.work and session.work.running)

    def execute(self, context: bpy.types.Context) -> set[str]:
        try:
            session.check(context)
        except MENDABLE as error:
            return refuse(self, error)
        return {"FINISHED"}


def reason_against(context: bpy.types.Context) -> str:
    """Why a job can't be started now; empty if it can."""
    if not context.scene.fantasia3d.prompt.strip():
        return "Say what to make: the prompt is empty."
    if session.busy:
        return "A run is going on."
    try:
        python = Machine(context).python
    except SetupError as error:
        return f"{error.text} {error.fix}"
    if not python.exists():
        return "Press Set Up first: the core's Python is not there yet."
    return ""


def reason_against_set_up() -> str:
    """Why the environment can't be made now; empty if it can."""
    if session.work and session.work.running:
        return "It is running."
    if not bpy.app.online_access:
        return "Allow online access first: Preferences, System, Network."
    return ""


def refuse(operator: bpy.types.Operator, error: AddonError | SetupError) -> set[str]:
    """Say what is wrong and how to mend it, in the panel and in the status bar."""
    session.error = (error.text, error.fix)
    operator.report({"ERROR"}, str(error))
    return {"CANCELLED"}


CLASSES = (
    FANTASIA3D_OT_generate,
    FANTASIA3D_OT_cancel,
    FANTASIA3D_OT_import_asset,
    FANTASIA3D_OT_new_seed,
    FANTASIA3D_OT_open_log,
    FANTASIA3D_OT_set_up,
    FANTASIA3D_OT_check,
)
