"""From the scene's settings to a job in the queue: what the panel's large button does."""

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
from .words import Report, unknown

COLOR_SIZE = 1024  # texels a side of the picture of the present base colour


def generate(context: bpy.types.Context) -> Path:
    """Request the asset that the settings describe; the run folder.

    Raises:
        AddonError: it can't be made; nothing is left on the disk then.
        SetupError: the core is missing.
    """
    settings = context.scene.fantasia3d
    job = job_of(settings)
    with tempfile.TemporaryDirectory() as folder:
        files = {}
        if settings.guide:
            files["guide.obj"] = Path(folder) / "guide.obj"
            export_shape(settings.guide, files["guide.obj"], context.evaluated_depsgraph_get())
            job["guide_mesh"] = "guide.obj"
        return session.submit(context, job, session.target_here(context), files)


def texture(context: bpy.types.Context) -> Path:
    """Request a material for the active object; the run folder.

    Raises:
        AddonError: as :func:`generate`; or the object can't be textured.
        SetupError: the core is missing.
    """
    settings, obj = context.scene.fantasia3d, context.active_object
    reason = texture_object.reason_against(obj)
    if reason:
        raise AddonError(reason, "Select a mesh with faces, in Object Mode.")
    job = job_of(settings, "texture") | {"mesh": "mesh.obj"}
    with tempfile.TemporaryDirectory() as folder:
        files = {"mesh.obj": Path(folder) / "mesh.obj"}
        new_uv = settings.uv == "new"
        uv_map = texture_object.prepare_object(context, obj, new_uv, files["mesh.obj"])
        if settings.use_present_color:
            files["base_color.png"] = Path(folder) / "base_color.png"
            bake_base_color.bake(context, obj, uv_map, files["base_color.png"], COLOR_SIZE)
            job["base_color"] = "base_color.png"
        target = session.target_here(
            context, object=obj.name, uv_map=uv_map, assign=settings.assign
        )
        return session.submit(context, job, target, files)


def repeat(context: bpy.types.Context, entry: Entry, vary_seed: bool = False) -> Path:
    """Request the job of ``entry`` again, with another seed on request; the run folder.

    Raises:
        AddonError: a file that it needs no longer exists.
    """
    seed = history.other_seed(entry.job.get("seed", 0)) if vary_seed else None
    job, files = history.copy_of_job(entry, seed)
    old = Target.read(entry.folder)
    # The same object as before, but a new object comes to where the user wants it now.
    target = session.target_here(context, object=old.object, uv_map=old.uv_map, assign=old.assign)
    return session.submit(context, job, target, files)


def resume(context: bpy.types.Context, entry: Entry) -> None:
    """Continue ``entry`` from its last checkpoint.

    Raises:
        AddonError: it is running, done, or followed by another Blender.
    """
    now = history.read_entry(entry.folder)  # the list may be older than the disk
    if now is None or not now.resumable:
        raise AddonError(
            f"“{entry.prompt}” can't be resumed: it is {now.state if now else 'deleted'}.",
            "Use Repeat instead.",
        )
    session.enqueue(context, entry.folder)


def report_of(settings: bpy.types.PropertyGroup) -> Report | None:
    """What the built-in model understands of the prompt; None: not known, or another model."""
    if settings.guidance != "builtin":
        return None
    return session.report(settings.prompt, settings.ignore_unknown)


def reason_against_generate(context: bpy.types.Context) -> str:
    """Why no job can be requested now; empty if one can."""
    if not context.scene.fantasia3d.prompt.strip():
        return "Enter a prompt: what to generate."
    reason = reason_against_jobs(context)
    if reason:
        return reason
    if unknown(report_of(context.scene.fantasia3d)):
        return "The prompt has unknown words."
    try:
        job_of(context.scene.fantasia3d)
    except AddonError as error:
        return str(error)
    return ""


def reason_against_jobs(context: bpy.types.Context) -> str:
    """Why no job at all can be started; empty if one can."""
    try:
        python = Paths(context).python
    except SetupError as error:
        return f"{error.text} {error.fix}"
    return "" if python.exists() else "Installation required: press Install."


def reason_against_texture(context: bpy.types.Context) -> str:
    """Why the active object can't be textured now; empty if it can."""
    return reason_against_generate(context) or texture_object.reason_against(context.active_object)
