"""Takes a finished run's asset into the scene: a new object, or the material of the user's own."""

from __future__ import annotations

from pathlib import Path

import bpy

from ..asset.asset_folder import AssetFolder
from ..asset.import_asset import import_asset
from ..asset.texture_object import dress
from ..errors import AddonError
from .target import Target

BUSY = ("TRANSFORM_OT_", "MESH_OT_", "SCULPT_OT_", "PAINT_OT_", "GPENCIL_OT_")


def take_in(
    folder: Path,
    target: Target,
    scene: bpy.types.Scene,
    asset: AssetFolder | None = None,
    push_undo: bool = True,
) -> str:
    """The asset of the run in ``folder``, where ``target`` says; the name of its object.

    ``asset`` is what was read there already. One undo step; an operator makes it by itself.

    Raises:
        AddonError: the asset is broken, or the object has gone.
    """
    if target.object:
        obj = bpy.data.objects.get(target.object)
        if obj is None:
            raise AddonError(
                f"There is no object “{target.object}” any more.",
                "Import the asset from the history: it holds the mesh too.",
            )
        dress(obj, asset or folder, target.uv_map, target.assign)
    else:
        where = scene.view_layers[0].active_layer_collection  # a timer's context has no window
        obj = import_asset(where, asset or folder, target.location)
    mark_taken(folder)
    if push_undo:
        _push_undo(f"Generate {obj.name}")
    return obj.name


def mark_taken(folder: Path) -> None:
    """Remember that the asset came into a scene; a folder that can't be written forgets it."""
    try:
        (folder / "taken").touch()
    except OSError:
        return


def obstacle() -> str:
    """What the user is in the middle of, so that an asset has to wait; empty if nothing."""
    if bpy.app.is_job_running("RENDER"):
        return "It comes when the render is done."
    for window in bpy.context.window_manager.windows:
        active = window.view_layer.objects.active
        if active and active.mode != "OBJECT":
            return "It comes when you are back in Object Mode."
        if any(op.bl_idname.startswith(BUSY) for op in window.modal_operators):
            return "It comes when you are done with the tool."
    return ""


def _push_undo(message: str) -> None:
    if not bpy.app.background:
        with bpy.context.temp_override(window=bpy.context.window_manager.windows[0]):
            bpy.ops.ed.undo_push(message=message)
