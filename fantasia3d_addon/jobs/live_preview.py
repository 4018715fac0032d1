"""The preview of a running job in the viewport: one mesh object that is updated in place.

It is not part of the user's work: it can't be selected or rendered, is not saved with the file,
and undo does not bring it back.
"""

from __future__ import annotations

import zipfile
import zlib
from collections.abc import Sequence
from pathlib import Path

import bpy
import numpy as np

from ..blender.names import data_name
from .progress import FollowedRun

RUN = "fantasia3d_run"  # the custom property with the run of a preview object
SIZE_M = 1.0  # the longest side, as of a finished asset


def show(
    collection: bpy.types.Collection, path: Path, followed: FollowedRun
) -> bpy.types.Object | None:
    """Show the mesh in ``path``, the newest of ``followed``; None where it can't be read.

    It stands on the target's location as the finished asset will.
    """
    try:
        with path.open("rb") as file, np.load(file, allow_pickle=False) as parts:
            verts, faces = parts["verts"], parts["faces"]
    # MemoryError: a declared size; zlib.error: a broken part.
    except (OSError, ValueError, KeyError, MemoryError, zipfile.BadZipFile, zlib.error):
        return None  # it is being replaced or removed at this moment: the next one comes soon
    if not _is_mesh(verts, faces):
        return None
    obj = find(followed.name) or _add(collection, followed.name, followed.prompt)
    obj.location = followed.target.location
    _fill(obj.data, to_metres(verts), faces)
    return obj


def _is_mesh(verts: np.ndarray, faces: np.ndarray) -> bool:
    """Whether these are triangles: Blender crashes on an index beyond the vertices."""
    shaped = verts.ndim == faces.ndim == 2 and verts.shape[1] == faces.shape[1] == 3
    if not shaped or not faces.size or verts.dtype.kind != "f" or faces.dtype.kind not in "iu":
        return False
    inside = faces.min() >= 0 and faces.max() < len(verts)
    return bool(inside and np.isfinite(verts).all() and np.ptp(verts, axis=0).max() < 1e6)


def find(run: str) -> bpy.types.Object | None:
    """The preview object of ``run``."""
    return next((obj for obj in bpy.data.objects if obj.get(RUN) == run), None)


def remove(keep: Sequence[str] = ()) -> None:
    """Remove all previews but those of the runs ``keep``."""
    # By the custom property: the user may have renamed the object.
    stale = [obj for obj in bpy.data.objects if RUN in obj and obj[RUN] not in keep]
    meshes = [obj.data for obj in stale]
    bpy.data.batch_remove([*stale, *(mesh for mesh in meshes if mesh.users == 1)])


def to_metres(verts: np.ndarray) -> np.ndarray:
    """From training units: on z = 0, centred in x and y, ``SIZE_M`` on the longest side."""
    low, high = verts.min(0), verts.max(0)
    base = (low + high) / 2
    base[2] = low[2]
    return ((verts - base) * (SIZE_M / max(float((high - low).max()), 1e-9))).astype(np.float32)


def _add(collection: bpy.types.Collection, run: str, prompt: str) -> bpy.types.Object:
    name = data_name(prompt, " (preview)")
    obj = bpy.data.objects.new(name, bpy.data.meshes.new(name))
    obj[RUN] = run
    # Visible, but in no way part of the user's work.
    obj.hide_select = obj.hide_render = True
    collection.objects.link(obj)
    return obj


def _fill(mesh: bpy.types.Mesh, verts: np.ndarray, faces: np.ndarray) -> None:
    # In place: a new mesh for each preview would fill the file with unused ones.
    mesh.clear_geometry()
    mesh.vertices.add(len(verts))
    mesh.vertices.foreach_set("co", verts.ravel())
    mesh.loops.add(faces.size)
    mesh.loops.foreach_set("vertex_index", faces.ravel().astype(np.int32))
    mesh.polygons.add(len(faces))
    mesh.polygons.foreach_set("loop_start", np.arange(0, faces.size, 3, dtype=np.int32))
    mesh.update(calc_edges=True)
    mesh.shade_smooth()
