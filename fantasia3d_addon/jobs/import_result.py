"""Puts a finished run's asset into the scene: a new object, or a material for the user's own."""

from __future__ import annotations

from pathlib import Path

import bpy

from ..asset.asset_folder import AssetFolder, read_asset, read_obj
from ..asset.import_asset import import_asset
from ..asset.texture_object import assign_material
from ..blender.mesh_arrays import evaluated_object
from ..errors import AddonError
from ..mesh import new_shape, region
from .job_file import FILES, IMPORTED, KEPT
from .place import bounds_of, place_of
from .target import MAPS, REGION, SHAPE, Target

# Operators that hold references into the scene while they run: nothing may be added meanwhile.
MODAL_TOOLS = ("TRANSFORM_OT_", "MESH_OT_", "SCULPT_OT_", "PAINT_OT_", "GPENCIL_OT_")


def import_result(
    folder: Path,
    target: Target,
    scene: bpy.types.Scene,
    asset: AssetFolder | None = None,
    push_undo: bool = True,
    near: tuple[float, float, float] | None = None,
) -> str:
    """Import the asset of the run in ``folder`` at ``target``; the name of its object.

    ``asset`` is the asset folder where it was read already; ``near`` is where its preview was.
    One undo step; ``push_undo`` is off
    for operators, which have their own.

    Raises:
        AddonError: the asset is broken, or the target object was removed.
    """
    if target.object:
        obj = bpy.data.objects.get(target.object)
        if obj is None:
            raise AddonError(
                f"The object “{target.object}” no longer exists.",
                "Import the asset from the history: it includes the mesh.",
            )
        if target.assign in REGION:
            _show_region(obj, folder, target.assign, asset or read_asset(folder))
        else:
            assign_material(obj, asset or folder, target.uv_map, target.assign)
    else:
        asset = asset or read_asset(folder)
        place = place_of(scene, target, bounds_of(asset), near)
        # A timer's context has no window.
        obj = import_asset(scene.view_layers[0].active_layer_collection, asset, place)
    mark_imported(folder)
    if push_undo:
        verb = "Edit Region of" if target.assign in REGION else "Generate"
        _push_undo(f"{verb} {obj.name}")
    return obj.name


def is_as_sent(obj: bpy.types.Object, folder: Path, target: Target) -> bool:
    """Whether ``obj`` has as many vertices and triangles as the mesh that its job was sent.

    ``folder`` is that of the run. The job got the vertices of the mesh itself for a region of it,
    else what the modifiers make of it.
    """
    if obj.type != "MESH":
        return False
    try:
        verts, faces = read_obj(folder / FILES["mesh"])[:2]
    except AddonError:
        return False
    with evaluated_object(obj) as evaluated:
        mesh = obj.data if target.assign in REGION else evaluated.data
        # A polygon of n corners has n - 2 triangles.
        triangles = len(mesh.loops) - 2 * len(mesh.polygons)
        return (len(mesh.vertices), triangles) == (len(verts), len(faces))


def _show_region(obj: bpy.types.Object, folder: Path, what: str, asset: AssetFolder) -> None:
    """Show what the run in ``folder`` changed in a region of ``obj``: maps, shape or both."""
    if what != MAPS:
        # First of both: it is refused where the mesh was changed meanwhile.
        new_shape.show_shape(obj, asset, folder / KEPT / "mesh.obj")
    if what != SHAPE:
        region.show_maps(obj, asset, obj.name)


def mark_imported(folder: Path) -> None:
    """Remember that the asset came into a scene; without effect in a read-only folder."""
    try:
        (folder / IMPORTED).touch()
    except OSError:
        return  # it is offered once more at the next start, which does no harm


def reason_to_wait() -> str:
    """The user's activity that an import would disturb; empty if none."""
    if bpy.app.is_job_running("RENDER"):
        return "Import waits until the render is done."
    for window in bpy.context.window_manager.windows:
        active = window.view_layer.objects.active
        if active and active.mode != "OBJECT":
            return "Import waits until you are back in Object Mode."
        if any(op.bl_idname.startswith(MODAL_TOOLS) for op in window.modal_operators):
            return "Import waits until you are done with the tool."
    return ""


def _push_undo(message: str) -> None:
    if not bpy.app.background:  # without a window there is no undo
        with bpy.context.temp_override(window=bpy.context.window_manager.windows[0]):
            bpy.ops.ed.undo_push(message=message)
