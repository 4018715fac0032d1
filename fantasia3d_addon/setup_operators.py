"""The core's Python environment by buttons: set up, check, repair, remove."""

from __future__ import annotations

from collections.abc import Callable

import bpy

from . import environment
from .operators import MENDABLE, refuse
from .preferences import Machine
from .session import session
from .work import Say, Work

RUNNING = "The set-up is running."


def set_up(context: bpy.types.Context, renew: bool = False) -> Work:
    """Make the environment in the background; ``renew`` makes it anew."""
    machine = Machine(context)
    root, place = machine.root, machine.place

    def make(say: Say) -> object:
        python = environment.ensure(
            root, (), say, renew=renew, place=place, stopped=lambda: work.cancelled
        )
        say(f"Ready: {python}", 1.0)
        return python

    work = Work("Repair" if renew else "Set-up", make)
    return session.begin(work)


def check(context: bpy.types.Context) -> Work:
    """Look at what is here and what is missing, in the background; its result are Lines."""
    machine = Machine(context)
    root, folder, python = machine.root, machine.environment, machine.own_python

    def look(say: Say) -> object:
        lines = environment.examine(root, folder, python)
        missing = [line.name for line in lines if line.state == "MISSING"]
        say(f"Missing: {', '.join(missing)}." if missing else "Everything is here.", 1.0)
        return lines

    return session.begin(Work("Check", look))


def remove(context: bpy.types.Context) -> Work:
    """Remove the environment that Set Up made, in the background."""
    folder = Machine(context).environment

    def clear(say: Say) -> object:
        environment.remove(folder)
        environment.tidy(folder)
        say("The environment is gone. Runs and assets are still there.", 1.0)
        return None

    return session.begin(Work("Removal", clear))


def reason_against(needs_network: bool = True) -> str:
    """Why the environment can't be made now; empty if it can."""
    if session.work and session.work.running:
        return RUNNING
    offline = Machine(bpy.context).place.wheels
    if offline and not offline.is_dir():
        return f"The wheel folder {offline} is not there."
    if needs_network and not offline and not bpy.app.online_access:
        return "Allow online access (Preferences, System, Network), or name a folder of wheels."
    return ""


def reason_against_removal() -> str:
    """Why the environment can't be removed now; empty if it can."""
    if session.work and session.work.running:
        return RUNNING
    if session.running:
        return "A job is running in it."
    try:
        there = Machine(bpy.context).environment.exists()
    except environment.SetupError as error:
        return error.text
    return "" if there else "There is none."


class _Setup:
    """What the operators of the set-up share: they begin something and say why they can't."""

    @staticmethod
    def reason() -> str:
        return RUNNING if session.work and session.work.running else ""

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
        except MENDABLE as error:
            return refuse(self, error)
        return {"FINISHED"}


class FANTASIA3D_OT_set_up(_Setup, bpy.types.Operator):
    """Make the method's own Python environment; nothing is installed into Blender"""

    bl_idname = "fantasia3d.set_up"
    bl_label = "Set Up"
    reason = staticmethod(reason_against)

    def execute(self, context: bpy.types.Context) -> set[str]:
        return self.begin(set_up, context)


class FANTASIA3D_OT_repair(_Setup, bpy.types.Operator):
    """Make the environment anew, from nothing"""

    bl_idname = "fantasia3d.repair"
    bl_label = "Repair"
    reason = staticmethod(reason_against)

    def execute(self, context: bpy.types.Context) -> set[str]:
        return self.begin(set_up, context, renew=True)


class FANTASIA3D_OT_check(_Setup, bpy.types.Operator):
    """See what is here and what is missing, and how to mend it"""

    bl_idname = "fantasia3d.check"
    bl_label = "Check"

    def execute(self, context: bpy.types.Context) -> set[str]:
        return self.begin(check, context)


class FANTASIA3D_OT_remove_environment(_Setup, bpy.types.Operator):
    """Remove the environment that Set Up made; runs and assets stay"""

    bl_idname = "fantasia3d.remove_environment"
    bl_label = "Remove"
    reason = staticmethod(reason_against_removal)

    def invoke(self, context: bpy.types.Context, event: bpy.types.Event) -> set[str]:
        return context.window_manager.invoke_confirm(self, event)

    def execute(self, context: bpy.types.Context) -> set[str]:
        return self.begin(remove, context)


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
            return environment.log_file(Machine(context).environment).exists()
        except environment.SetupError:
            return False

    def execute(self, context: bpy.types.Context) -> set[str]:
        path = environment.log_file(Machine(context).environment)
        return bpy.ops.wm.path_open(filepath=str(path))


class FANTASIA3D_OT_open_preferences(bpy.types.Operator):
    """Folders of this machine: the environment, the runs, the models"""

    bl_idname = "fantasia3d.open_preferences"
    bl_label = "Folders"

    @classmethod
    def poll(cls, context: bpy.types.Context) -> bool:
        cls.poll_message_set("The add-on is not installed in this Blender.")
        return __package__ in context.preferences.addons

    def execute(self, context: bpy.types.Context) -> set[str]:
        return bpy.ops.preferences.addon_show(module=__package__)


CLASSES = (
    FANTASIA3D_OT_set_up,
    FANTASIA3D_OT_repair,
    FANTASIA3D_OT_check,
    FANTASIA3D_OT_remove_environment,
    FANTASIA3D_OT_cancel_set_up,
    FANTASIA3D_OT_open_set_up_log,
    FANTASIA3D_OT_open_preferences,
)
