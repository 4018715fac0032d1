"""Placement: drops an object onto the surface below it, and sets its origin to its base."""

from __future__ import annotations

from collections.abc import Iterable

import bpy
import numpy as np
from mathutils import Matrix, Vector
from mathutils.bvhtree import BVHTree

from ..blender.mesh_arrays import (
    is_shared,
    mesh_object,
    move_kept_shape,
    moved,
    verts_of,
    world_verts,
)
from ..errors import AddonError

DOWN = Vector((0, 0, -1))


def drop(
    obj: bpy.types.Object, others: Iterable[bpy.types.Object] | None = None, ground: bool = True
) -> float:
    """Move ``obj`` straight down until it first touches another object; the distance in metres.

    ``others`` are the visible mesh objects of its scene where None. An object that intersects one
    of them is not lifted out of it: only surfaces below its vertices count. ``ground``: where
    nothing is below it, it moves to z = 0, from above or from below (a negative distance).

    Raises:
        AddonError: nothing is below it, and not ``ground``; or its modifiers leave no vertices.
    """
    mesh_object(obj)
    bpy.context.view_layer.update()
    if others is None:
        others = visible_meshes(obj)
    own = shown_verts(obj)
    distance = min((_gap(obj, own, other) for other in others), default=np.inf)
    if not np.isfinite(distance):
        if not ground:
            raise AddonError(f"Nothing is below {obj.name}.", "Move it above another object.")
        distance = float(own[:, 2].min())
    # In the world, so that parents and rotations do not matter.
    matrix = obj.matrix_world.copy()
    obj.matrix_world = Matrix.Translation((0, 0, -distance)) @ matrix
    bpy.context.view_layer.update()
    return float(distance)


def shown_verts(obj: bpy.types.Object) -> np.ndarray:
    """(V,3) in the world of ``obj`` as it looks.

    Raises:
        AddonError: its modifiers leave none.
    """
    points = world_verts(obj)
    if not len(points):
        raise AddonError(
            f"The modifiers of {obj.name} leave no vertices.", "Change or remove them."
        )
    return points


def visible_meshes(obj: bpy.types.Object) -> list[bpy.types.Object]:
    """The mesh objects that a render shows, except ``obj`` and its children."""
    own, graph = {obj, *obj.children_recursive}, bpy.context.evaluated_depsgraph_get()
    return [
        other
        for other in bpy.context.view_layer.objects
        if other.type == "MESH"
        and other not in own
        and other.visible_get()
        and not other.hide_render
        and len(other.evaluated_get(graph).data.polygons)  # a modifier may leave none
    ]


def _gap(obj: bpy.types.Object, own: np.ndarray, other: bpy.types.Object) -> float:
    """How far ``obj`` falls until it meets ``other``; infinite where it passes by.

    The first contact is of a vertex of one with a face of the other. A contact of two edges is not
    searched: the error is smaller than a face, and our faces are small.
    """
    theirs = world_verts(other)
    low, high = own.min(0), own.max(0)
    # Bounding boxes first: rays are slow.
    if (theirs.max(0)[:2] < low[:2]).any() or (theirs.min(0)[:2] > high[:2]).any():
        return np.inf
    tree, tree_own = _tree(other), _tree(obj)
    # Vertices of one fall on the other, and vertices of the other meet it from below.
    down = (_cast(tree, point, DOWN) for point in own)
    inside = (theirs[:, :2] >= low[:2]).all(1) & (theirs[:, :2] <= high[:2]).all(1)
    up = (_cast(tree_own, point, -DOWN) for point in theirs[inside & (theirs[:, 2] <= high[2])])
    return min((d for rays in (down, up) for d in rays), default=np.inf)


def _cast(tree: BVHTree, point: np.ndarray, direction: Vector) -> float:
    start = Vector(point) - 1e-6 * direction  # from just above: what touches already falls by 0
    _, _, _, distance = tree.ray_cast(start, direction)
    return np.inf if distance is None else max(distance - 1e-6, 0.0)


def _tree(obj: bpy.types.Object) -> BVHTree:
    evaluated = obj.evaluated_get(bpy.context.evaluated_depsgraph_get())
    mesh = evaluated.to_mesh()
    points = moved(verts_of(mesh), evaluated.matrix_world).tolist()
    faces = [tuple(polygon.vertices) for polygon in mesh.polygons]
    evaluated.to_mesh_clear()
    return BVHTree.FromPolygons(points, faces)


def origin_to_base(obj: bpy.types.Object) -> None:
    """Set the origin of ``obj`` to its lowest point, below its centre; nothing visible moves.

    Raises:
        AddonError: the object is no mesh, or shares its mesh with others, or has shape keys.
    """
    mesh = mesh_object(obj).data
    if is_shared(mesh):
        raise AddonError(
            f"{obj.name} shares its mesh with other objects.",
            "Make it single-user first: Object, Relations, Make Single User.",
        )
    if mesh.shape_keys:
        raise AddonError(f"{obj.name} has shape keys.", "Apply or remove them first.")
    bpy.context.view_layer.update()
    points = moved(verts_of(mesh), obj.matrix_world)
    low, high = points.min(0), points.max(0)
    base = Vector(((low[0] + high[0]) / 2, (low[1] + high[1]) / 2, low[2]))
    matrix = obj.matrix_world.copy()
    # Children keep their place in the world.
    kept = [(child, child.matrix_world.copy()) for child in obj.children]
    to_base = Matrix.Translation(-(matrix.inverted_safe() @ base))
    mesh.transform(to_base)
    move_kept_shape(mesh, to_base)
    matrix.translation = base
    obj.matrix_world = matrix
    bpy.context.view_layer.update()
    for child, where in kept:
        child.matrix_world = where
    mesh.update()
