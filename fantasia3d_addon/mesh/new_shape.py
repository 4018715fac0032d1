"""The new shape of a part of an object, which a job has made; and the old one again."""

from __future__ import annotations

from pathlib import Path

import bpy
import numpy as np

from ..asset.asset_folder import AssetFolder, read_obj
from ..blender.mesh_arrays import KEPT_SHAPE as OLD
from ..blender.mesh_arrays import is_shared, reason_against_mesh, triangles, values, verts_of
from ..errors import AddonError


def reason_against(obj: bpy.types.Object | None) -> str:
    """Why the vertices of ``obj`` can't be moved by a job; empty if they can."""
    reason = reason_against_mesh(obj)
    if obj is None or reason:
        return reason
    return "Its mesh has shape keys. Apply them first." if obj.data.shape_keys else ""


def show_shape(obj: bpy.types.Object, asset: AssetFolder, sent: Path) -> None:
    """Move the vertices of ``obj`` to where ``asset`` has them; nothing else of it changes.

    ``sent``: the mesh.obj that the job was given. :func:`restore_shape` brings the shape from
    before the first edit back. A mesh that other objects use becomes the object's own.

    Raises:
        AddonError: the mesh was changed since, or has shape keys.
    """
    reason = reason_against(obj) or _reason_against_change(obj.data, asset, sent)
    if reason:
        raise AddonError(reason, "Undo that change, then import the job's asset from the history.")
    mesh = _own_mesh(obj)
    if OLD not in mesh.attributes:  # a second edit must not overwrite the original
        mesh.attributes.new(OLD, "FLOAT_VECTOR", "POINT")
        mesh.attributes[OLD].data.foreach_set("vector", verts_of(mesh).ravel())
    _move(mesh, asset.verts)


def _reason_against_change(mesh: bpy.types.Mesh, asset: AssetFolder, sent: Path) -> str:
    verts, faces = read_obj(sent)[:2]
    now, triangles_now = verts_of(mesh), triangles(mesh)[0]
    same = np.array_equal(triangles_now, faces) and len(now) == len(asset.verts)
    # Asked for again from the history, it is there already.
    if same and any(np.array_equal(now, there) for there in (verts, asset.verts)):
        return ""
    return f"The mesh “{mesh.name}” was changed after the job was requested."


def _own_mesh(obj: bpy.types.Object) -> bpy.types.Mesh:
    if is_shared(obj.data):
        obj.data = obj.data.copy()
    return obj.data


def _move(mesh: bpy.types.Mesh, verts: np.ndarray) -> None:
    mesh.vertices.foreach_set("co", np.asarray(verts, np.float32).ravel())
    mesh.update()


def reason_against_restore(obj: bpy.types.Object | None) -> str:
    """Why ``obj`` has no earlier shape; empty if it has one."""
    reason = reason_against(obj)
    if obj is None or reason:
        return reason
    kept = obj.data.attributes.get(OLD)
    ours = kept is not None and (kept.data_type, kept.domain) == ("FLOAT_VECTOR", "POINT")
    return "" if ours else "It has its own shape."


def restore_shape(obj: bpy.types.Object) -> None:
    """Move the vertices of ``obj`` to where they were before the first job moved some.

    Raises:
        AddonError: none did.
    """
    reason = reason_against_restore(obj)
    if reason:
        raise AddonError(reason, "There is nothing to restore.")
    mesh = _own_mesh(obj)
    _move(mesh, values(mesh.attributes[OLD].data, "vector", 3))
    mesh.attributes.remove(mesh.attributes[OLD])
