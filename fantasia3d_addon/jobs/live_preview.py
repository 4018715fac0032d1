"""The preview of a running job in the viewport: one mesh object that is updated in place.

It is not part of the user's work: it can't be selected or rendered, is not saved with the file,
and undo does not bring it back.
"""

from __future__ import annotations

import math
import zipfile
import zlib
from collections.abc import Sequence
from pathlib import Path

import bpy
import numpy as np

from ..blender.names import data_name
from ..scene import view
from .place import place_of
from .progress import FollowedRun

RUN = "fantasia3d_run"  # the custom property with the run of a preview object
SIZE_M = 1.0  # the longest side, where the core reports none
SHARP = math.radians(40)  # between two faces: more than a growing surface's ripples have
GROWTH = 0.6  # of the longest side: room that a preview gets at least in width and depth


def show(scene: bpy.types.Scene, path: Path, followed: FollowedRun) -> bpy.types.Object | None:
    """Show the mesh in ``path``, the newest of ``followed``; None where it can't be read.

    It is where the finished asset will be, and the view is turned there where it shows something
    else at the first preview.
    """
    try:
        with path.open("rb") as file, np.load(file, allow_pickle=False) as parts:
            verts, faces = parts["verts"], parts["faces"]
            size = float(parts["size_m"]) if "size_m" in parts else SIZE_M
    # MemoryError: a declared size; TypeError: a size that is no number; zlib.error: a broken part.
    except (OSError, TypeError, ValueError, KeyError, MemoryError, zipfile.BadZipFile, zlib.error):
        return None  # it is being replaced or removed at this moment: the next one comes soon
    if not _is_mesh(verts, faces) or not 0 < size < math.inf:
        return None
    obj = find(followed.name)
    if obj and followed.place is None:  # of an earlier session, such as a candidate's
        followed.place = tuple(obj.location)
    is_first = followed.place is None
    obj = obj or _add(scene.collection, followed.name, followed.prompt)
    _fill(obj.data, to_metres(verts, size), faces)
    if followed.place is None:
        followed.place = place_of(scene, followed.target, _room(obj), ignored=(obj,))
    obj.location = followed.place
    if is_first:
        scene.view_layers[0].update()  # the framing reads its matrix
        view.frame_if_unseen(scene, obj)
    return obj


def _is_mesh(verts: np.ndarray, faces: np.ndarray) -> bool:
    """Whether these are triangles: Blender crashes on an index beyond the vertices."""
    shaped = verts.ndim == faces.ndim == 2 and verts.shape[1] == faces.shape[1] == 3
    if not shaped or not faces.size or verts.dtype.kind != "f" or faces.dtype.kind not in "iu":
        return False
    inside = faces.min() >= 0 and faces.max() < len(verts)
    return bool(inside and np.isfinite(verts).all() and np.ptp(verts, axis=0).max() < 1e6)


def _room(obj: bpy.types.Object) -> np.ndarray:
    """The bounds (2,3) that a preview of now may grow to: legs and handles come later."""
    corners = np.array([corner[:] for corner in obj.bound_box], np.float64)
    low, high = corners.min(0), corners.max(0)
    half = GROWTH * float((high - low).max()) / 2
    low[:2], high[:2] = np.minimum(low[:2], -half), np.maximum(high[:2], half)
    return np.stack([low, high])


def find(run: str) -> bpy.types.Object | None:
    """The preview object of ``run``."""
    return next((obj for obj in bpy.data.objects if obj.get(RUN) == run), None)


def any_shown() -> bpy.types.Object | None:
    """A preview of any run."""
    return next((obj for obj in bpy.data.objects if RUN in obj), None)


def remove(keep: Sequence[str] = ()) -> None:
    """Remove all previews but those of the runs ``keep``."""
    # By the custom property: the user may have renamed the object.
    stale = [obj for obj in bpy.data.objects if RUN in obj and obj[RUN] not in keep]
    for obj in stale:
        view.leave_local_views(obj)  # or they would show nothing
    meshes = [obj.data for obj in stale]
    bpy.data.batch_remove([*stale, *(mesh for mesh in meshes if mesh.users == 1)])


def to_metres(verts: np.ndarray, size: float) -> np.ndarray:
    """From training units: on z = 0, centred in x and y, ``size`` metres on the longest side."""
    low, high = verts.min(0), verts.max(0)
    base = (low + high) / 2
    base[2] = low[2]
    return ((verts - base) * (size / max(float((high - low).max()), 1e-9))).astype(np.float32)


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
    mesh.set_sharp_from_angle(angle=SHARP)  # no normal map here: smooth, a box looks inflated
