"""The core's Python environment by buttons: set up, check, repair, remove."""

from __future__ import annotations

from collections.abc import Callable

import bpy

from .. import PACKAGE, environment
from ..background.thread import Work
from ..jobs import environment_setup
from ..jobs.paths import Paths
from ..jobs.session import session
from .operator_helpers import USER_ERRORS, report_error


class _Setup:
    """What the operators of the set-up share: they begin something and say why they can't."""

    @staticmethod
    def reason() -> str:
        return environment_setup.RUNNING if session.work and session.work.running else ""

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        """Says why it can't be pressed."""
        reason = cls.reason()
        cls.poll_message_set(reason)
        return not reason

    def begin(
        self, function: Callable[..., Work], context: bpy.types.Context, **options: bool
    ) -> set[str]:
        try:
            function(context, **options)
        except USER_ERRORS as error:
            return report_error(self, error)
        return {"FINISHED"}


class FANTASIA3D_OT_set_up(_Setup, bpy.types.Operator):
    """Make the method's own Python environment; nothing is installed into Blender"""

    bl_idname = "fantasia3d.set_up"
    bl_label = "Set Up"
    reason = staticmethod(environment_setup.reason_against)

    def execute(self, context: bpy.types.Context) -> set[str]:
        return self.begin(environment_setup.set_up, context)


class FANTASIA3D_OT_repair(_Setup, bpy.types.Operator):
    """Make the environment anew, from nothing"""

    bl_idname = "fantasia3d.repair"
    bl_label = "Repair"
    reason = staticmethod(environment_setup.reason_against)

    def execute(self, context: bpy.types.Context) -> set[str]:
        return self.begin(environment_setup.set_up, context, renew=True)


class FANTASIA3D_OT_check(_Setup, bpy.types.Operator):
    """See what is here and what is missing, and how to mend it"""

    bl_idname = "fantasia3d.check"
    bl_label = "Check"

    def execute(self, context: bpy.types.Context) -> set[str]:
        return self.begin(environment_setup.check, context)


class FANTASIA3D_OT_remove_environment(_Setup, bpy.types.Operator):
    """Remove the environment that Set Up made; runs and assets stay"""

    bl_idname = "fantasia3d.remove_environment"
    bl_label = "Remove"
    reason = staticmethod(environment_setup.reason_against_removal)

    def invoke(self, context: bpy.types.Context, event: bpy.types.Event) -> set[str]:
        return context.window_manager.invoke_confirm(self, event)

    def execute(self, context: bpy.types.Context) -> set[str]:
        return self.begin(environment_setup.remove, context)


class FANTASIA3D_OT_cancel_set_up(bpy.types.Operator):
    """Stop the set-up; nothing half-made is left"""

    bl_idname = "fantasia3d.cancel_set_up"
    bl_label = "Cancel"

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        cls.poll_message_set("No set-up is running.")
        return session.work is not None and session.work.running

    def execute(self, context: bpy.types.Context) -> set[str]:
        if session.work:
            session.work.cancel()
        return {"FINISHED"}


class FANTASIA3D_OT_open_set_up_log(bpy.types.Operator):
    """Open what the last set-up printed"""

    bl_idname = "fantasia3d.open_set_up_log"
    bl_label = "Open Log"

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        cls.poll_message_set("There is no log yet.")
        try:
            return environment.log_file(Paths(context).environment).exists()
        except environment.SetupError:
            return False

    def execute(self, context: bpy.types.Context) -> set[str]:
        path = environment.log_file(Paths(context).environment)
        return bpy.ops.wm.path_open(filepath=str(path))


class FANTASIA3D_OT_open_preferences(bpy.types.Operator):
    """Folders of this machine: the environment, the runs, the models"""

    bl_idname = "fantasia3d.open_preferences"
    bl_label = "Folders"

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        cls.poll_message_set("The add-on is not installed in this Blender.")
        return PACKAGE in context.preferences.addons

    def execute(self, context: bpy.types.Context) -> set[str]:
        return bpy.ops.preferences.addon_show(module=PACKAGE)


CLASSES = (
    FANTASIA3D_OT_set_up,
    FANTASIA3D_OT_repair,
    FANTASIA3D_OT_check,
    FANTASIA3D_OT_remove_environment,
    FANTASIA3D_OT_cancel_set_up,
    FANTASIA3D_OT_open_set_up_log,
    FANTASIA3D_OT_open_preferences,
)
