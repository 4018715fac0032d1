"""Prepares the user's own mesh for a texturing job, and assigns the resulting material.

Its shape, its modifiers and its other UV maps stay as they are.
"""

from __future__ import annotations

import math
from pathlib import Path

import bpy
import numpy as np

from ..blender.mesh_arrays import EDIT_MODE, reason_against_mesh
from ..errors import AddonError
from .asset_folder import AssetFolder
from .export_shape import export_shape
from .import_asset import import_material

NEW_UV_MAP = "Fantasia3D"
ANGLE = math.radians(66)  # between faces of one island: Blender's own default
MARGIN = 0.004  # between islands, of the square's side
TOLERANCE = 1e-4  # of the square's side; less is rounding


def reason_against(obj: bpy.types.Object | None) -> str:
    """Why ``obj`` can't be textured; empty if it can."""
    if obj is not None and obj.mode != "OBJECT":
        return EDIT_MODE
    reason = reason_against_mesh(obj)
    if obj is None or reason:
        return reason
    if obj.library or obj.data.library:
        return f"“{obj.name}” is linked from another file. Make it local first."
    return ""


def prepare_object(
    context: bpy.types.Context, obj: bpy.types.Object, new_uv: bool, path: Path
) -> str:
    """Write the evaluated mesh to ``path``, with its UV map; the name of that map.

    ``new_uv`` adds a UV map next to the existing ones; so does a mesh without one.

    Raises:
        AddonError: there is no surface, or its UV map can't be used for textures.
    """
    layers = obj.data.uv_layers
    name = add_uv_map(context, obj) if new_uv or not layers else layers.active.name
    export_shape(obj, path, name)
    uv = np.empty(2 * len(obj.data.loops), np.float32)
    layers[name].uv.foreach_get("vector", uv)
    if uv.min() < -TOLERANCE or uv.max() > 1 + TOLERANCE:
        raise AddonError(
            f"The UV map “{name}” of {obj.name} extends outside the unit square.",
            "Choose “New” as its UV map, or scale it into the square.",
        )
    return name


def add_uv_map(context: bpy.types.Context, obj: bpy.types.Object) -> str:
    """Add a UV map without overlaps, by Blender's Smart UV Project; its name."""
    uv = _unwrapped(context, obj)
    layers = obj.data.uv_layers
    # A second job writes into the map of the first.
    layer = layers.get(NEW_UV_MAP) or layers.new(name=NEW_UV_MAP, do_init=False)
    if layer is None:
        raise AddonError(
            f"{obj.name} has as many UV maps as a mesh can have.", "Remove one of them."
        )
    layer.uv.foreach_set("vector", uv)
    return layer.name


def _unwrapped(context: bpy.types.Context, obj: bpy.types.Object) -> np.ndarray:
    """New UVs (2 L,) of the corners, from a copy: the user's selection in the mesh stays."""
    mesh = obj.data.copy()
    helper = bpy.data.objects.new("Unwrap", mesh)
    while mesh.uv_layers:
        mesh.uv_layers.remove(mesh.uv_layers[0])
    mesh.uv_layers.new(name=NEW_UV_MAP)
    # The operator skips hidden faces.
    mesh.polygons.foreach_set("hide", np.zeros(len(mesh.polygons), bool))
    context.scene.collection.objects.link(helper)
    objects = context.view_layer.objects
    active, selected = objects.active, list(objects.selected)
    for other in selected:  # Edit Mode would include them
        other.select_set(False)
    objects.active = helper
    helper.select_set(True)
    try:
        bpy.ops.object.mode_set(mode="EDIT")
        bpy.ops.mesh.select_all(action="SELECT")
        bpy.ops.uv.smart_project(angle_limit=ANGLE, island_margin=MARGIN)
        bpy.ops.object.mode_set(mode="OBJECT")
        uv = np.empty(2 * len(mesh.loops), np.float32)
        mesh.uv_layers[NEW_UV_MAP].uv.foreach_get("vector", uv)
        return uv
    finally:
        objects.active = active
        for other in selected:
            other.select_set(True)
        bpy.data.objects.remove(helper)
        bpy.data.meshes.remove(mesh)


def assign_material(
    obj: bpy.types.Object, folder: Path | AssetFolder, uv_map: str, assign: str
) -> bpy.types.Material:
    """Assign the material of the asset in ``folder`` to ``obj``.

    ``assign`` "slot": in a new slot, which no face uses yet unless it is the first; "object": shown
    by every slot of this object, while the mesh keeps its own materials (a slot's Link, set back
    to Data, shows them again).

    Raises:
        AddonError: the UV map was removed, or the asset is broken.
    """
    if uv_map not in obj.data.uv_layers:
        raise AddonError(
            f"“{obj.name}” no longer has the UV map “{uv_map}”.",
            "Undo its removal, or texture the mesh again.",
        )
    material = import_material(folder, uv_map)
    if assign == "object" and obj.material_slots:
        show_on_all_slots(obj, material)
    else:
        obj.data.materials.append(material)
    return material


def show_on_all_slots(obj: bpy.types.Object, material: bpy.types.Material) -> None:
    """Show ``material`` in every slot of ``obj``, linked to the object and not to its mesh."""
    for slot in obj.material_slots:
        slot.link = "OBJECT"
        slot.material = material
