"""Helpers of the operators: when they may run, and how they report."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import bpy
from bpy.app.translations import pgettext_iface as translated

from ..asset.asset_folder import read_asset
from ..asset.import_asset import import_asset
from ..blender.mesh_arrays import EDIT_MODE, reason_against_mesh
from ..environment import SetupError
from ..errors import AddonError
from ..jobs.place import bounds_of, place_of
from ..jobs.session import session
from ..scene import view
from .text import in_language

UNDO = {"REGISTER", "UNDO"}
USER_ERRORS = (AddonError, SetupError)  # what the user can fix; anything else is a bug


def reason_against_tool(context: bpy.types.Context, changes: bool = True) -> str:
    """Why no tool can act on the active object; empty if one can.

    ``changes``: whether the tool changes it, which one that is linked from another file refuses.
    """
    if context.mode != "OBJECT":
        return EDIT_MODE
    obj = context.active_object
    reason = reason_against_mesh(obj)
    if not reason and changes and (obj.library or obj.data.library):
        return "It is linked from another file. Make it local first: Object, Relations, Make Local."
    return reason


def can_run(
    cls: type[bpy.types.Operator],
    context: bpy.types.Context,
    more: str = "",
    changes: bool = True,
) -> bool:
    """The poll of a tool, with its reason; ``more`` is a reason of the operator's own."""
    return allowed(cls, reason_against_tool(context, changes) or more)


def allowed(cls: type[bpy.types.Operator], reason: str) -> bool:
    """A poll that fails for ``reason``, unless that is empty."""
    # Blender translates no message of a poll; it calls this where the message is shown.
    cls.poll_message_set(in_language, reason)
    return not reason


def needs(cls: type[bpy.types.Operator], condition: object, reason: str) -> bool:
    """A poll that fails for ``reason``, unless ``condition`` is true."""
    return allowed(cls, "" if condition else reason)


def run_and_report(operator: bpy.types.Operator, act: Callable[[], object]) -> set[str]:
    """Call ``act``; report what the user can fix as an error message."""
    try:
        act()
    except USER_ERRORS as error:
        operator.report({"ERROR"}, in_language(str(error)))
        return {"CANCELLED"}
    return {"FINISHED"}


def rendering() -> bool:
    """Whether a render job of this window is running."""
    return not bpy.app.background and bpy.app.is_job_running("RENDER")


def queue_job(operator: bpy.types.Operator, submit: Callable[[], Path]) -> set[str]:
    """Put a job into the queue by ``submit``, which returns its run folder, and report it."""
    try:
        folder = submit()
    except USER_ERRORS as error:
        return report_error(operator, error)
    started = any(followed.run.folder == folder for followed in session.running)
    operator.report({"INFO"}, f"{translated('Started' if started else 'Queued')}: {folder.name}")
    return {"FINISHED"}


def report_error(operator: bpy.types.Operator, error: AddonError | SetupError) -> set[str]:
    """Report an error and its fix, in the panel and in the status bar."""
    session.error = (error.text, error.fix)
    operator.report({"ERROR"}, in_language(str(error)))
    return {"CANCELLED"}


def import_and_select(context: bpy.types.Context, folder: Path) -> bpy.types.Object:
    """Import the asset in ``folder`` where the panel's setting places it, select and show it.

    Raises:
        AddonError: the folder is not an asset.
    """
    asset, target = read_asset(folder), session.target_here(context)
    obj = import_asset(context, asset, place_of(context.scene, target, bounds_of(asset)))
    session.mark_imported(folder)
    for other in context.selected_objects:
        other.select_set(False)
    obj.select_set(True)
    context.view_layer.objects.active = obj
    session.asset = obj.name  # the panel offers to show its colours
    context.view_layer.update()  # the framing reads its matrix
    view.frame_if_unseen(context.scene, obj)
    return obj
