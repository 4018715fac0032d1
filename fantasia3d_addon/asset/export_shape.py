"""Exports the shape of an object of the scene as an OBJ file, for the core to start from."""

from __future__ import annotations

from pathlib import Path

import bpy
import numpy as np

from ..blender.mesh_arrays import (
    corner_uv,
    evaluated_object,
    triangles,
    use_uv_map,
    values,
    verts_of,
)
from ..environment.files import write_text
from ..errors import AddonError, OutputError
from .asset_folder import FLAT


def export_shape(obj: bpy.types.Object, path: Path, uv_map: str = "") -> None:
    """Write ``obj`` with modifiers and transform applied as a triangle OBJ with its uv.

    The axes are the default of Blender's importer: forward -Z, up Y. Where ``uv_map`` is empty,
    the active one is used.

    Raises:
        AddonError: the object has no surface, or not that UV map.
        OutputError: the file can't be written.
    """
    with evaluated_object(obj) as evaluated:
        text = _text(evaluated, uv_map, obj.name)
    try:
        write_text(path, text)
    except OSError as error:
        raise OutputError(
            f"{path} can't be written ({error.strerror}).", "Choose another run folder."
        ) from None


def _text(evaluated: bpy.types.Object, uv_map: str, name: str) -> str:
    try:
        mesh = evaluated.to_mesh()
    except RuntimeError:  # an empty, a camera, a light
        mesh = None
    if mesh is None or not len(mesh.polygons):
        raise AddonError(f"“{name}” has no faces.", "Choose an object with a surface.")
    try:
        if uv_map:
            use_uv_map(mesh, uv_map)
        return obj_text(mesh, np.array(evaluated.matrix_world))
    finally:
        evaluated.to_mesh_clear()


def obj_text(mesh: bpy.types.Mesh, matrix: np.ndarray) -> str:
    """``mesh``, moved by the 4x4 ``matrix``, as the text of an OBJ file with its active UV map."""
    verts = verts_of(mesh) @ matrix[:3, :3].T + matrix[:3, 3]
    faces, corners = triangles(mesh)
    if np.linalg.det(matrix[:3, :3]) < 0:  # a mirrored object: keep the normals outward
        faces, corners = faces[:, ::-1], corners[:, ::-1]
    # 9 digits restore any single precision number exactly.
    text = _lines("v %.9g %.9g %.9g\n", y_up(verts))
    uv = corner_uv(mesh)
    if uv is None:
        return text + _lines("f %d %d %d\n", faces + 1)
    text += _lines("vt %.9g %.9g\n", uv)
    return text + _lines("f %d/%d %d/%d %d/%d\n", np.stack([faces, corners], -1) + 1)


def asset_obj_text(
    mesh: bpy.types.Mesh, uv: np.ndarray, faces: np.ndarray, face_uvs: np.ndarray
) -> str:
    """The triangles ``faces`` of ``mesh`` in its own space, as an asset folder's mesh.obj."""
    verts, normals, of_corner = verts_of(mesh), values(mesh.vertices, "normal", 3), faces
    flat = not any(face.use_smooth for face in mesh.polygons)
    if flat:  # one for each face
        a, b, c = (verts[faces[:, k]] for k in range(3))
        across = np.cross(b - a, c - a)
        normals = across / np.maximum(np.linalg.norm(across, axis=1, keepdims=True), 1e-30)
        of_corner = np.arange(len(faces))[:, None].repeat(3, 1)
    text = _lines("v %.9g %.9g %.9g\n", y_up(verts)) + _lines("vt %.9g %.9g\n", uv)
    text += _lines("vn %.6g %.6g %.6g\n", y_up(normals)) + (FLAT.decode() + "\n" if flat else "")
    corners = np.stack([faces, face_uvs, of_corner], -1) + 1
    return text + _lines("f %d/%d/%d %d/%d/%d %d/%d/%d\n", corners)


def y_up(vectors: np.ndarray) -> np.ndarray:
    """Blender's axes as those of an OBJ file: forward -Z, up Y."""
    return vectors[:, [0, 2, 1]] * (1, 1, -1)


def _lines(line: str, rows: np.ndarray) -> str:
    # One format for all rows: a loop takes seconds in Python.
    return line * len(rows) % tuple(rows.ravel().tolist())
