"""A mesh's data as arrays, checks of the active object, and the context for Blender's operators."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator

import bpy
import numpy as np
from mathutils import Matrix

from ..errors import AddonError

EDIT_MODE = "Leave Edit Mode first."
KEPT_SHAPE = "fantasia3d_shape"  # attribute of the vertices: where they were before the first edit


def values(
    items: bpy.types.bpy_prop_collection, name: str, width: int, kind: type = np.float32
) -> np.ndarray:
    """The attribute ``name`` of all ``items`` as (N, width)."""
    flat = np.empty(len(items) * width, kind)  # foreach_get fills flat buffers alone
    items.foreach_get(name, flat)
    return flat.reshape(-1, width)


def verts_of(mesh: bpy.types.Mesh) -> np.ndarray:
    """(V,3) float32, in the object's own space."""
    return values(mesh.vertices, "co", 3)


def triangles(mesh: bpy.types.Mesh) -> tuple[np.ndarray, np.ndarray]:
    """The vertices (T,3) and the corners (T,3) of the mesh's triangles, int32."""
    mesh.calc_loop_triangles()
    found = mesh.loop_triangles
    return values(found, "vertices", 3, np.int32), values(found, "loops", 3, np.int32)


def corner_uv(mesh: bpy.types.Mesh) -> np.ndarray | None:
    """(L,2) of the active UV map; None where there is none."""
    layer = mesh.uv_layers.active
    return None if layer is None else values(layer.uv, "vector", 2)


def use_uv_map(mesh: bpy.types.Mesh, name: str) -> None:
    """Make the UV map ``name`` the active one, for bakes and exporters.

    Raises:
        AddonError: the modifiers have left none of that name.
    """
    layer = mesh.uv_layers.get(name)
    if layer is None:
        raise AddonError(
            f"The modifiers leave no UV map “{name}”.",
            "Apply the modifier that makes new faces, then start again.",
        )
    mesh.uv_layers.active, layer.active_render = layer, True


def moved(points: np.ndarray, matrix: object) -> np.ndarray:
    """``points`` (N,3) through the 4x4 ``matrix``, float64."""
    m = np.array(matrix, dtype=np.float64)
    return points @ m[:3, :3].T + m[:3, 3]


def move_kept_shape(mesh: bpy.types.Mesh, matrix: Matrix) -> None:
    """Move the vertices' earlier places as the mesh was moved, which moves no attributes."""
    kept = mesh.attributes.get(KEPT_SHAPE)
    if kept is not None and (kept.data_type, kept.domain) == ("FLOAT_VECTOR", "POINT"):
        places = moved(values(kept.data, "vector", 3), matrix)
        kept.data.foreach_set("vector", places.astype(np.float32).ravel())


def world_verts(obj: bpy.types.Object) -> np.ndarray:
    """(V,3) in the world, as the object looks: with its modifiers, after the last update."""
    evaluated = obj.evaluated_get(bpy.context.evaluated_depsgraph_get())
    mesh = evaluated.to_mesh()
    try:
        return moved(verts_of(mesh), evaluated.matrix_world)
    finally:
        evaluated.to_mesh_clear()


@contextlib.contextmanager
def evaluated_object(obj: bpy.types.Object) -> Iterator[bpy.types.Object]:
    """``obj`` as it looks: with its modifiers, and where its parent and its constraints have it.

    Also where it is not :func:`enabled`.
    """
    with enabled(obj) as shown:
        yield shown.evaluated_get(bpy.context.evaluated_depsgraph_get())


@contextlib.contextmanager
def enabled(obj: bpy.types.Object) -> Iterator[bpy.types.Object]:
    """``obj``; a copy in the view layer where ``obj`` or its collections are disabled in viewports.

    Blender evaluates none of those, or, where something that is shown depends on one, without its
    modifiers.
    """
    found = obj.evaluated_get(bpy.context.evaluated_depsgraph_get())
    # The evaluated one's: it may be animated.
    if not found.hide_viewport and _is_in(bpy.context.view_layer.layer_collection, obj):
        yield obj
        return
    copy = obj.copy()
    try:
        copy.hide_viewport = False
        if copy.animation_data:  # a driver comes after all other animation, which moves it still
            copy.driver_remove("hide_viewport")
            copy.driver_add("hide_viewport").driver.expression = "0"
        bpy.context.scene.collection.objects.link(copy)
        bpy.context.view_layer.update()
        yield copy
    finally:
        bpy.data.objects.remove(copy)


def _is_in(layer: bpy.types.LayerCollection, obj: bpy.types.Object) -> bool:
    """Whether ``layer`` has ``obj`` in a collection that is not disabled."""
    if layer.collection.hide_viewport:
        return False
    own = not layer.exclude and any(obj == each for each in layer.collection.objects)
    return own or any(_is_in(child, obj) for child in layer.children)


def baked_mesh(obj: bpy.types.Object) -> bpy.types.Mesh:
    """A new mesh of ``obj`` with its modifiers applied, in its own space, with its materials."""
    with evaluated_object(obj) as evaluated:
        return bpy.data.meshes.new_from_object(
            evaluated,
            preserve_all_data_layers=True,
            depsgraph=bpy.context.evaluated_depsgraph_get(),
        )


def shown_copy(obj: bpy.types.Object, name: str) -> bpy.types.Object:
    """A new object that looks as ``obj`` does now and stays so in any scene, hidden nowhere.

    ``obj`` itself is elsewhere, or empty, where what moves or hides it is not.
    """
    with evaluated_object(obj) as evaluated:
        place = evaluated.matrix_world.copy()
    mesh, copy = baked_mesh(obj), obj.copy()
    copy.name = name
    copy.animation_data_clear()
    copy.modifiers.clear()
    copy.constraints.clear()
    copy.data, copy.parent = mesh, None
    copy.hide_render = copy.hide_viewport = False
    copy.matrix_world = place
    return copy


def apply_modifiers(obj: bpy.types.Object) -> None:
    """Replace the mesh of ``obj`` by :func:`baked_mesh`, and remove its modifiers."""
    old = obj.data
    mesh = baked_mesh(obj)
    obj.modifiers.clear()
    obj.data = mesh
    if not old.users:
        name = old.name
        bpy.data.meshes.remove(old)  # first: two meshes can't have one name
        mesh.name = name


def mesh_object(obj: bpy.types.Object | None) -> bpy.types.Object:
    """``obj``, which must be a mesh with faces.

    Raises:
        AddonError: it is none.
    """
    reason = reason_against_mesh(obj)
    if obj is None or reason:
        raise AddonError(reason, "Select an object with a surface, in Object Mode.")
    return obj


def reason_against_mesh(obj: bpy.types.Object | None) -> str:
    """Why ``obj`` is no mesh with faces; empty if it is one."""
    if obj is None or obj.type != "MESH":
        return "Select a mesh."
    return "" if len(obj.data.polygons) else f"“{obj.name}” has no faces."


def is_shared(mesh: bpy.types.Mesh) -> bool:
    """Whether several objects use ``mesh``."""
    return mesh.users - mesh.use_fake_user > 1


@contextlib.contextmanager
def acting(obj: bpy.types.Object, **more: object) -> Iterator[None]:
    """Let Blender's operators act on ``obj`` alone; the user's own selection is restored."""
    layer = bpy.context.view_layer
    active, selected = layer.objects.active, list(bpy.context.selected_objects)
    for other in selected:
        other.select_set(False)
    layer.objects.active = obj
    obj.select_set(True)
    try:
        # Some operators read the override, others the view layer: both must agree.
        with bpy.context.temp_override(
            object=obj, active_object=obj, selected_objects=[obj],
            selected_editable_objects=[obj], **more,
        ):  # fmt: skip
            yield
    finally:
        kept = set(layer.objects)  # the operator may have removed some
        for other in list(bpy.context.selected_objects):
            other.select_set(False)
        for other in selected:
            if other in kept:
                other.select_set(True)
        layer.objects.active = active if active in kept else None
