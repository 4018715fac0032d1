"""What the panel's buttons ask for: from the scene's settings to a job in the queue."""

from __future__ import annotations

import tempfile
from pathlib import Path

import bpy

from ..asset import bake_base_color, texture_object
from ..asset.export_shape import export_shape
from ..environment import SetupError
from ..errors import AddonError
from . import history
from .history import Entry
from .job_settings import job_of
from .paths import Paths
from .session import session
from .target import Target

COLOR_SIZE = 1024  # texels a side of the picture of the present base colour


def generate(context: bpy.types.Context) -> Path:
    """Ask for the asset that the settings describe; the run folder.

    Raises:
        AddonError: it can't be asked for; nothing is left of it then.
        SetupError: the core is not there.
    """
    settings = context.scene.fantasia3d
    job = job_of(settings)
    with tempfile.TemporaryDirectory() as folder:
        files = {}
        if settings.guide:
            files["guide.obj"] = Path(folder) / "guide.obj"
            export_shape(settings.guide, files["guide.obj"], context.evaluated_depsgraph_get())
            job["guide_mesh"] = "guide.obj"
        return session.submit(context, job, session.here(context), files)


def texture(context: bpy.types.Context) -> Path:
    """Ask for a material for the active object; the run folder.

    Raises:
        AddonError: as :func:`generate`; or the object can't take a texture.
        SetupError: the core is not there.
    """
    settings, obj = context.scene.fantasia3d, context.active_object
    reason = texture_object.reason_against(obj)
    if reason:
        raise AddonError(reason, "Select a mesh with faces, in Object Mode.")
    job = job_of(settings, "texture") | {"mesh": "mesh.obj"}
    with tempfile.TemporaryDirectory() as folder:
        files = {"mesh.obj": Path(folder) / "mesh.obj"}
        new_uv = settings.uv == "new"
        uv_map = texture_object.make_ready(context, obj, new_uv, files["mesh.obj"])
        if settings.use_present_color:
            files["base_color.png"] = Path(folder) / "base_color.png"
            bake_base_color.bake(context, obj, uv_map, files["base_color.png"], COLOR_SIZE)
            job["base_color"] = "base_color.png"
        target = session.here(context, object=obj.name, uv_map=uv_map, assign=settings.assign)
        return session.submit(context, job, target, files)


def repeat(context: bpy.types.Context, entry: Entry, vary_seed: bool = False) -> Path:
    """Ask for what ``entry`` was once more, with another seed if wished; the run folder.

    Raises:
        AddonError: a file that it needs has gone.
    """
    seed = history.another_seed(entry.job.get("seed", 0)) if vary_seed else None
    job, files = history.again(entry, seed)
    old = Target.read(entry.folder)
    here = session.here(context, object=old.object, uv_map=old.uv_map, assign=old.assign)
    return session.submit(context, job, here, files)


def resume(context: bpy.types.Context, entry: Entry) -> None:
    """Have the core go on with ``entry`` from its last checkpoint.

    Raises:
        AddonError: it is running, done, or followed by another Blender.
    """
    now = history.read_entry(entry.folder)
    if now is None or not now.resumable:
        raise AddonError(
            f"“{entry.prompt}” can't be resumed: it is {now.state if now else 'gone'}.",
            "Repeat it instead.",
        )
    session.enqueue(context, entry.folder)


def reason_against(context: bpy.types.Context) -> str:
    """Why no job can be asked for now; empty if one can."""
    if not context.scene.fantasia3d.prompt.strip():
        return "Say what to make: the prompt is empty."
    try:
        python = Paths(context).python
    except SetupError as error:
        return f"{error.text} {error.fix}"
    if not python.exists():
        return "Press Set Up first: the method's Python is not there yet."
    try:
        job_of(context.scene.fantasia3d)
    except AddonError as error:
        return str(error)
    return ""


def reason_against_texture(context: bpy.types.Context) -> str:
    """Why the active object can't be textured now; empty if it can."""
    return reason_against(context) or texture_object.reason_against(context.active_object)
