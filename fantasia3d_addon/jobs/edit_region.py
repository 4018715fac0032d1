"""From chosen faces and words to a job that changes the maps there alone."""

from __future__ import annotations

import tempfile
from pathlib import Path

import bpy
import numpy as np

from ..asset.asset_folder import read_info, read_obj
from ..asset.origin import origin_of
from ..errors import AddonError
from ..mesh import new_shape, region
from . import history
from .job_file import FILES, KEPT
from .job_settings import job_of
from .session import session
from .submit import reason_against_jobs
from .target import BOTH, MAPS, SHAPE

FACES = FILES["region"]


def reason_against(context: bpy.types.Context, group: str = "", change: str = MAPS) -> str:
    """Why no region of the active object can be edited now; empty if one can.

    ``change``: as :func:`edit_region` has it.
    """
    obj = context.active_object
    return (
        reason_against_jobs(context)
        or region.reason_against(obj)
        or (new_shape.reason_against(obj) if change != MAPS else "")
        or region.reason_against_part(obj, group)
    )


def edit_region(
    context: bpy.types.Context, words: str, group: str = "", change: str = MAPS
) -> Path:
    """Request what ``words`` describe for the chosen faces of the active object; the run folder.

    In Edit Mode the selected faces, else those of the vertex group ``group`` or of the active one.
    ``change``: MAPS, their material; SHAPE, their vertices move to where the words have them; BOTH.

    Raises:
        AddonError: no faces are chosen, there are no words, or the object shows no baked maps.
        SetupError: the core is missing.
    """
    reason = reason_against(context, group, change)
    if reason:
        raise AddonError(reason, "Choose faces of an imported asset.")
    if not words.strip():
        raise AddonError("There are no words.", "Enter what the faces become: red velvet.")
    obj = context.active_object
    if obj.mode == "EDIT":
        obj.update_from_editmode()
    faces = region.faces_of(obj, group)
    job = job_of(context.scene.fantasia3d, "texture")
    job |= {"prompt": words.strip(), "mesh": FILES["mesh"], "region": FACES, "kept_asset": KEPT}
    job |= {"reshape": change in (SHAPE, BOTH), "retexture": change == BOTH}
    look = region.look_of(obj)
    assert look is not None
    job["texture_size"] = look.images["normal"].size[0]
    with tempfile.TemporaryDirectory() as folder:
        files = _files(obj, faces, Path(folder))
        target = session.target_here(context, object=obj.name, uv_map=look.uv_map, assign=change)
        return session.submit(context, job, target, files)


def _files(obj: bpy.types.Object, faces: np.ndarray, folder: Path) -> dict[str, Path]:
    """The run folder's input files, written into ``folder``."""
    kept = region.write_kept(obj, folder / "kept")
    (folder / FACES).write_text("".join(f"{face}\n" for face in faces), "ascii")
    files = {f"{KEPT}/{name}": path for name, path in kept.items()}
    files |= {FACES: folder / FACES, FILES["mesh"]: kept["mesh.obj"]}
    shape = _shape(obj, kept["mesh.obj"])
    return files | ({f"{Path(KEPT).parent}/{history.SHAPE}": shape} if shape else {})


def _shape(obj: bpy.types.Object, mesh: Path) -> Path | None:
    """The shape that ``obj`` was made from, whose relief its normal map has; None: unknown.

    Where the mesh was changed since, that relief is another's.
    """
    made = origin_of(obj).get("mesh_hash")
    for entry in session.history:
        path = entry.folder / history.SHAPE
        try:
            if not made or not path.is_file():
                continue
            hashes = read_info(entry.folder).get("hashes")
            if isinstance(hashes, dict) and hashes.get("mesh.obj") == made:
                theirs, ours = read_obj(entry.folder / "asset" / "mesh.obj"), read_obj(mesh)
                same = all(map(np.array_equal, theirs[:2], ours[:2]))
                return path if same else None
        except AddonError:
            continue
    return None
