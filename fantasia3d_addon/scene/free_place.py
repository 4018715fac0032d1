"""The free place nearest to a point: where a preview or an asset intersects nothing.

Objects count with their bounding boxes; large ones that an asset is in or on, such as a room
or a terrain, with their faces.
"""

from __future__ import annotations

from collections.abc import Container, Sequence

import bpy
import numpy as np
from mathutils import Vector
from mathutils.bvhtree import BVHTree

from ..blender.mesh_arrays import moved

GAP = 0.05  # to the next object, of the asset's longest side
MIN_SURROUNDINGS = 3.0  # metres; what is wider may be a room or a terrain
SURROUNDINGS = 4.0  # and so many times as wide as the asset
CLEAR_FROM = 0.1  # of the asset's height: lower faces are the floor below it
EXACT_TRIES = 64  # places that are compared with the faces of the surroundings
FARTHER = 1.5  # times the distance of the nearest place, for one that is seen
UP = Vector((0, 0, 1))
BOX_FACES = ((0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3))


def free_place(
    scene: bpy.types.Scene,
    bounds: np.ndarray,
    near: Sequence[float],
    ignored: Container[bpy.types.Object] = (),
    eye: Vector | None = None,
) -> tuple[float, float, float]:
    """The location nearest to ``near``, on its height, where an object intersects no other.

    ``bounds`` (2,3) are the object's lowest and highest corner about its origin, in metres. ``eye``
    is where it is looked at from: a place a little farther away is taken if the nearest is hidden.
    """
    near = np.asarray(near, np.float64)
    boxes, around = _obstacles(scene, bounds, ignored)
    beyond = np.array([_box_of(obj) for obj in around]).reshape(-1, 2, 3)
    places = _places(boxes, beyond, bounds, near)
    free = [
        place
        for place in places[:EXACT_TRIES]
        if not any(_intersects(scene, obj, place + bounds) for obj in around)
    ]
    # Nowhere in the surroundings, such as in a narrow room: then at least not in another object.
    best = (free or [places[0]])[0]
    if eye is not None:
        reach = FARTHER * float(np.linalg.norm(best - near)) + float(np.ptp(bounds, axis=0).max())
        close = (place for place in free if np.linalg.norm(place - near) <= reach)
        best = next((place for place in close if _is_seen(scene, place + bounds, eye)), best)
    return tuple(best.tolist())


def _is_seen(scene: bpy.types.Scene, box: np.ndarray, eye: Vector) -> bool:
    """Whether nothing is between ``eye`` and the middle of ``box`` (2,3), nor its upper part."""
    graph = scene.view_layers[0].depsgraph
    middle, top = box.mean(0), box.mean(0)
    top[2] = 0.1 * box[0, 2] + 0.9 * box[1, 2]
    radius = float(np.linalg.norm(box[1] - box[0])) / 2
    for point in (Vector(middle), Vector(top)):
        ray = point - eye
        # Up to the box itself: the object may be there already, as a preview.
        distance = max(ray.length - radius, 0.0)
        if scene.ray_cast(graph, eye, ray.normalized(), distance=distance)[0]:
            return False
    return True


def _obstacles(
    scene: bpy.types.Scene, bounds: np.ndarray, ignored: Container[bpy.types.Object]
) -> tuple[np.ndarray, list[bpy.types.Object]]:
    """The bounding boxes (N,2,3) of the visible meshes, and the objects that are surroundings."""
    layer = scene.view_layers[0]
    layer.update()  # the matrices of objects that were made a moment ago
    wide = max(MIN_SURROUNDINGS, SURROUNDINGS * float(np.ptp(bounds, axis=0)[:2].max()))
    boxes, around = [], []
    for obj in layer.objects:
        if obj.type != "MESH" or obj in ignored or not obj.visible_get(view_layer=layer):
            continue
        box = _box_of(obj)
        if (np.ptp(box, axis=0)[:2] > wide).all():
            around.append(obj)
        elif len(obj.data.vertices):
            boxes.append(box)
    return np.array(boxes).reshape(-1, 2, 3), around


def _box_of(obj: bpy.types.Object) -> np.ndarray:
    """Its lowest and highest corner (2,3) in the world."""
    corners = moved(np.array([corner[:] for corner in obj.bound_box]), obj.matrix_world)
    return np.stack([corners.min(0), corners.max(0)])


def _places(
    boxes: np.ndarray, beyond: np.ndarray, bounds: np.ndarray, near: np.ndarray
) -> np.ndarray:
    """The free places (P,3) among the candidates, the nearest first; never empty.

    The sides of the boxes ``beyond`` give candidates too, but nothing is refused for them.
    """
    gap = GAP * float(np.ptp(bounds, axis=0).max())
    # What is above or below the object does not matter; touching is no intersection.
    level = near[2] + bounds[:, 2] + (gap / 10, -gap / 10)
    boxes = boxes[(boxes[:, 1, 2] > level[0]) & (boxes[:, 0, 2] < level[1])]
    both = np.concatenate([boxes, beyond])
    # The origin may be nowhere between these (a Minkowski sum of boxes).
    low, high = both[:, 0, :2] - bounds[1, :2] - gap, both[:, 1, :2] - bounds[0, :2] + gap
    # The nearest point outside of rectangles is on a line through one of their sides in each axis
    # in which it differs from ``near``.
    x, y = (np.unique(np.concatenate([[near[i]], low[:, i], high[:, i]])) for i in (0, 1))
    low, high = low[: len(boxes)], high[: len(boxes)]
    points = np.stack(np.meshgrid(x, y, indexing="ij"), -1).reshape(-1, 2)
    points = points[np.linalg.norm(points - near[:2], axis=1).argsort(kind="stable")]
    free = np.ones(len(points), bool)
    for corner, opposite in zip(low + 1e-9, high - 1e-9, strict=True):
        free &= ~((points > corner) & (points < opposite)).all(1)
    # At least the corner beyond all boxes is free.
    return np.column_stack([points[free], np.full(int(free.sum()), near[2])])


def _intersects(scene: bpy.types.Scene, obj: bpy.types.Object, box: np.ndarray) -> bool:
    """Whether a face of ``obj`` is in the upper part of ``box`` (2,3), or the box in its inside."""
    box = box.copy()
    box[0, 2] += CLEAR_FROM * (box[1, 2] - box[0, 2])
    # Of this scene, which need not be the one that is shown; _obstacles has updated it.
    tree = BVHTree.FromObject(obj, scene.view_layers[0].depsgraph)
    # In the object's own space, which the tree has.
    corners = np.array(np.meshgrid(*box.T, indexing="ij")).reshape(3, -1).T
    inverse = obj.matrix_world.inverted_safe()
    own = BVHTree.FromPolygons(moved(corners, inverse).tolist(), BOX_FACES)
    if tree.overlap(own):
        return True
    start = inverse @ Vector(box.mean(0))
    _, normal, _, _ = tree.ray_cast(start, inverse.to_3x3() @ UP)
    # A back face above: the point is in the solid, not in a room, whose faces look inward.
    return normal is not None and normal.dot(inverse.to_3x3() @ UP) > 0
