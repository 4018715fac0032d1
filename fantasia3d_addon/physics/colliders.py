"""The colliders of a simulated asset: objects below or around it, or a ground of its own."""

from __future__ import annotations

from collections.abc import Sequence

import bpy
import numpy as np
from mathutils import Vector

from ..blender.mesh_arrays import acting, baked_mesh, world_verts
from ..scene.placement import visible_meshes
from .helpers import BODY, COLLIDER, MARK, add, is_local

GROUND = "Fantasia3D ground"


def supports(obj: bpy.types.Object) -> list[bpy.types.Object]:
    """The visible objects below or around the footprint of ``obj``; a new ground if none."""
    points = world_verts(obj)
    low, high = points.min(0), points.max(0)
    reach = float((high - low).max())
    found = []
    for other in visible_meshes(obj):
        theirs = world_verts(other)
        # Within a reach of the footprint: it may roll there.
        near = (theirs.min(0)[:2] < high[:2] + reach) & (theirs.max(0)[:2] > low[:2] - reach)
        if near.all() and theirs.min(0)[2] < high[2] and MARK not in other:
            found.append(other)
    middle = (low + high) / 2
    solid = [_editable(obj, other) for other in found]
    if any(_is_below(world_verts(other), middle, low[2] + 1e-3) for other in found):
        return solid
    return [*solid, _ground(obj, Vector((*middle[:2], low[2])), reach)]


def _is_below(points: np.ndarray, middle: np.ndarray, height: float) -> bool:
    """Whether the object of ``points`` starts below ``height``, and is also under ``middle``."""
    low, high = points.min(0), points.max(0)
    return bool(low[2] <= height and (low[:2] <= middle[:2]).all() and (high >= middle)[:2].all())


def _editable(obj: bpy.types.Object, other: bpy.types.Object) -> bpy.types.Object:
    """``other``, or a copy of its shape where it is another file's and can't be made a collider."""
    if is_local(other):
        return other
    copy = add(obj, "collider", baked_mesh(other))
    copy.matrix_world = other.matrix_world
    return copy


def _ground(obj: bpy.types.Object, base: Vector, reach: float) -> bpy.types.Object:
    """A wide plane at z = 0 under ``base``, or just below that if it is lower."""
    half = 6 * reach
    mesh = bpy.data.meshes.new(GROUND)
    corners = [(-half, -half, 0), (half, -half, 0), (half, half, 0), (-half, half, 0)]
    mesh.from_pydata(corners, [], [(0, 1, 2, 3)])
    ground = add(obj, "ground", mesh, hidden=False)
    ground.name = GROUND
    # A little below the lowest point, so that it does not start in contact.
    ground.location = (*base[:2], min(base.z - 0.002 * reach, 0.0))
    bpy.context.view_layer.update()
    return ground


def collide_with(others: Sequence[bpy.types.Object], size: float) -> None:
    """Let what falls, ``size`` metres large, collide with ``others``."""
    for other in others:
        found = [m for m in other.modifiers if m.type == "COLLISION"]
        if any(m.name != MARK for m in found):
            continue  # the user's own settings
        if not found:
            other.modifiers.new(MARK, "COLLISION")
            other[COLLIDER] = True
        # Blender's default of 20 mm is visible as a gap; 1 mm is its least.
        other.collision.thickness_outer = min(max(0.01 * size, 0.001), 0.01)
        other.collision.damping = 0.4
        other.collision.friction_factor = 0.5
        other.collision.cloth_friction = 20.0


def add_rigid(obj: bpy.types.Object, kind: str, shape: str) -> None:
    if obj.rigid_body:
        return  # of the user's own settings, or of another simulation
    with acting(obj):
        bpy.ops.rigidbody.object_add(type=kind)
    obj[BODY] = True
    obj.rigid_body.collision_shape = shape
    obj.rigid_body.use_margin = True
    obj.rigid_body.collision_margin = 0.001


def release(obj: bpy.types.Object) -> None:
    """Remove what makes an object collide."""
    # An earlier version marked what it made a body as it marked the collider of a cloth.
    is_ours = BODY in obj or (COLLIDER in obj and MARK not in obj.modifiers)
    if obj.rigid_body and is_ours:
        # It need not be visible, nor in a collection that the view layer shows.
        hidden, obj.hide_viewport = obj.hide_viewport, False
        with bpy.context.temp_override(object=obj, active_object=obj):
            bpy.ops.rigidbody.object_remove()
        obj.hide_viewport = hidden
    for modifier in [m for m in obj.modifiers if m.name == MARK and m.type == "COLLISION"]:
        obj.modifiers.remove(modifier)
    for mark in (COLLIDER, BODY):
        obj.pop(mark, None)
