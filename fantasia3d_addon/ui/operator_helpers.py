"""What the operators of the tools share: when they may run, and how they report."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import bpy

from ..asset.import_asset import import_asset
from ..environment import SetupError
from ..errors import AddonError
from ..jobs.session import session

UNDO = {"REGISTER", "UNDO"}
USER_ERRORS = (AddonError, SetupError)


def reason_against(context: bpy.types.Context) -> str:
    """Why no tool can act on the active object; empty if one can."""
    if context.mode != "OBJECT":
        return "Leave the edit mode first."
    obj = context.active_object
    if obj is None or obj.type != "MESH":
        return "Click the mesh object that you mean."
    return "" if len(obj.data.polygons) else "The object has no faces."


def allowed(cls: type[bpy.types.Operator], context: bpy.types.Context, more: str = "") -> bool:
    """A poll that says why not; ``more`` is a reason of the operator's own."""
    reason = reason_against(context) or more
    cls.poll_message_set(reason)
    return not reason


def told(operator: bpy.types.Operator, act: Callable[[], object]) -> set[str]:
    """Do it; what the user can mend is told with its fix."""
    try:
        act()
    except AddonError as error:
        operator.report({"ERROR"}, str(error))
        return {"CANCELLED"}
    return {"FINISHED"}


def rendering() -> bool:
    """Whether a render job of this window is going on."""
    return not bpy.app.background and bpy.app.is_job_running("RENDER")


def queue_job(operator: bpy.types.Operator, function: Callable[[], Path]) -> set[str]:
    """Put a job into the queue and say so."""
    try:
        folder = function()
    except USER_ERRORS as error:
        return report_error(operator, error)
    begun = any(follow.run.folder == folder for follow in session.running)
    operator.report({"INFO"}, f"{'Started' if begun else 'Waits its turn'}: {folder.name}")
    return {"FINISHED"}


def report_error(operator: bpy.types.Operator, error: AddonError | SetupError) -> set[str]:
    """Say what is wrong and how to mend it, in the panel and in the status bar."""
    session.error = (error.text, error.fix)
    operator.report({"ERROR"}, str(error))
    return {"CANCELLED"}


def import_at_cursor(context: bpy.types.Context, folder: Path) -> bpy.types.Object:
    """The asset in ``folder`` as an object at the 3D cursor, selected.

    Raises:
        AddonError: the folder is no asset.
    """
    obj = import_asset(context, folder, context.scene.cursor.location)
    session.mark_imported(folder)
    for other in context.selected_objects:
        other.select_set(False)
    obj.select_set(True)
    context.view_layer.objects.active = obj
    return obj
