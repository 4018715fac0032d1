"""The operators of the core's Python environment: install, check, reinstall, uninstall."""

from __future__ import annotations

from collections.abc import Callable

import bpy
from bpy.props import BoolProperty, StringProperty

from .. import PACKAGE, environment
from ..background.thread import Task
from ..jobs import environment_setup
from ..jobs.paths import Paths
from ..jobs.session import session
from .operator_helpers import USER_ERRORS, allowed, needs, report_error

NO_ADDON = "The add-on is not installed in this Blender."


class _SetupOperator:
    """Mixin: starts a task of ``environment_setup``, one at a time."""

    @staticmethod
    def reason_against() -> str:
        return environment_setup.RUNNING if session.task and session.task.running else ""

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        return allowed(cls, cls.reason_against())

    def start(
        self, function: Callable[..., Task], context: bpy.types.Context, **options: bool
    ) -> set[str]:
        try:
            function(context, **options)
        except USER_ERRORS as error:
            return report_error(self, error)
        return {"FINISHED"}


class FANTASIA3D_OT_set_up(_SetupOperator, bpy.types.Operator):
    """Create the method's own Python environment; nothing is installed into Blender"""

    bl_idname = "fantasia3d.set_up"
    bl_label = "Install Python Environment"
    reason_against = staticmethod(environment_setup.reason_against)

    def execute(self, context: bpy.types.Context) -> set[str]:
        return self.start(environment_setup.set_up, context)


class FANTASIA3D_OT_repair(_SetupOperator, bpy.types.Operator):
    """Create the environment again from nothing"""

    bl_idname = "fantasia3d.repair"
    bl_label = "Reinstall Python Environment"
    reason_against = staticmethod(environment_setup.reason_against)

    def execute(self, context: bpy.types.Context) -> set[str]:
        return self.start(environment_setup.set_up, context, renew=True)


class FANTASIA3D_OT_check(_SetupOperator, bpy.types.Operator):
    """List what is installed and what is missing, with the fix"""

    bl_idname = "fantasia3d.check"
    bl_label = "Check Installation"

    def execute(self, context: bpy.types.Context) -> set[str]:
        return self.start(environment_setup.check, context)


class FANTASIA3D_OT_remove_environment(_SetupOperator, bpy.types.Operator):
    """Remove the environment that Install created; runs and assets stay"""

    bl_idname = "fantasia3d.remove_environment"
    bl_label = "Uninstall Python Environment"
    reason_against = staticmethod(environment_setup.reason_against_removal)

    def invoke(self, context: bpy.types.Context, event: bpy.types.Event) -> set[str]:
        return context.window_manager.invoke_confirm(self, event)

    def execute(self, context: bpy.types.Context) -> set[str]:
        return self.start(environment_setup.remove, context)


class FANTASIA3D_OT_allow_online_access(bpy.types.Operator):
    """Allow Blender to use the internet, for the installation: Preferences, System, Network"""

    bl_idname = "fantasia3d.allow_online_access"
    bl_label = "Allow Online Access"

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        reason = "Online access is allowed already." if bpy.app.online_access else ""
        if bpy.app.online_access_override:
            reason = "It was decided when Blender was started."
        return allowed(cls, reason)

    def execute(self, context: bpy.types.Context) -> set[str]:
        context.preferences.system.use_online_access = True
        return {"FINISHED"}


class FANTASIA3D_OT_choose_wheels(bpy.types.Operator):
    """Choose a folder of wheels, for an installation without a network"""

    bl_idname = "fantasia3d.choose_wheels"
    bl_label = "Choose Wheels Folder"

    directory: StringProperty(name="Folder", description="The folder of wheels", subtype="DIR_PATH")
    filter_folder: BoolProperty(default=True, options={"HIDDEN"})  # the file browser's own filter

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        return needs(cls, PACKAGE in context.preferences.addons, NO_ADDON)

    def invoke(self, context: bpy.types.Context, event: bpy.types.Event) -> set[str]:
        context.window_manager.fileselect_add(self)
        return {"RUNNING_MODAL"}

    def execute(self, context: bpy.types.Context) -> set[str]:
        context.preferences.addons[PACKAGE].preferences.wheels_folder = self.directory
        return {"FINISHED"}


class FANTASIA3D_OT_cancel_set_up(bpy.types.Operator):
    """Stop the installation; nothing incomplete is left"""

    bl_idname = "fantasia3d.cancel_set_up"
    bl_label = "Cancel Installation"

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        is_running = session.task is not None and session.task.running
        return needs(cls, is_running, "No installation is running.")

    def execute(self, context: bpy.types.Context) -> set[str]:
        if session.task:
            session.task.cancel()
        return {"FINISHED"}


class FANTASIA3D_OT_open_set_up_log(bpy.types.Operator):
    """Open the log of the last installation"""

    bl_idname = "fantasia3d.open_set_up_log"
    bl_label = "Open Installation Log"

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        try:
            exists = environment.log_file(Paths(context).environment).exists()
        except environment.SetupError:
            exists = False
        return needs(cls, exists, "There is no log yet.")

    def execute(self, context: bpy.types.Context) -> set[str]:
        path = environment.log_file(Paths(context).environment)
        return bpy.ops.wm.path_open(filepath=str(path))


class FANTASIA3D_OT_open_preferences(bpy.types.Operator):
    """Folders of this machine: the environment, the runs, the models"""

    bl_idname = "fantasia3d.open_preferences"
    bl_label = "Open Preferences"

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        return needs(cls, PACKAGE in context.preferences.addons, NO_ADDON)

    def execute(self, context: bpy.types.Context) -> set[str]:
        return bpy.ops.preferences.addon_show(module=PACKAGE)


CLASSES = (
    FANTASIA3D_OT_set_up,
    FANTASIA3D_OT_repair,
    FANTASIA3D_OT_check,
    FANTASIA3D_OT_remove_environment,
    FANTASIA3D_OT_allow_online_access,
    FANTASIA3D_OT_choose_wheels,
    FANTASIA3D_OT_cancel_set_up,
    FANTASIA3D_OT_open_set_up_log,
    FANTASIA3D_OT_open_preferences,
)
