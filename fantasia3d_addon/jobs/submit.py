"""From the scene's settings to a job in the queue: what the panel's large button does."""

from __future__ import annotations

import dataclasses
import tempfile
import uuid
from collections.abc import Mapping, Sequence
from contextlib import suppress
from pathlib import Path
from typing import Any

import bpy

from ..asset import bake_base_color, texture_object
from ..asset.export_shape import export_shape
from ..environment import SetupError
from ..errors import AddonError
from . import candidates, history
from .candidates import Candidate
from .history import Entry
from .job_file import unwritable
from .job_settings import Settings, job_of
from .paths import Paths
from .session import session
from .target import FREE, Target
from .words import Report, unknown

# The files that a run with another material starts from; the last means that the shape is finished.
SHAPE_PARTS = (
    "checkpoint/geometry.safetensors",
    "checkpoint/reshaped.safetensors",
    "checkpoint/front.safetensors",
    history.SHAPE,
)
NO_PROMPT = "Enter a prompt: what to generate."
COLOR_SIZE = 1024  # texels a side of the picture of the present base colour


def generate(context: bpy.types.Context) -> Path:
    """Request the asset that the settings describe; the run folder.

    Raises:
        AddonError: it can't be made; nothing is left on the disk then.
        SetupError: the core is missing.
    """
    job = _job_of(context.scene.fantasia3d)
    with tempfile.TemporaryDirectory() as folder:
        files = _guide(context, job, Path(folder))
        return session.submit(context, job, session.target_here(context), files)


def _job_of(settings: Settings, command: str = "generate") -> dict[str, Any]:
    """:func:`job_of`, which must have a prompt."""
    if not settings.prompt.strip():
        raise AddonError(NO_PROMPT)
    return job_of(settings, command)


def _guide(context: bpy.types.Context, job: dict[str, Any], folder: Path) -> dict[str, Path]:
    """The guide mesh as a file in ``folder``, where the settings have one; named in ``job``."""
    guide = context.scene.fantasia3d.guide
    if not guide:
        return {}
    path = folder / "guide.obj"
    export_shape(guide, path)
    job["guide_mesh"] = path.name
    return {path.name: path}


def explore(context: bpy.types.Context) -> Path:
    """Request first looks at several shapes, of the seed and the next; the first run folder.

    Raises:
        AddonError: as :func:`generate`.
        SetupError: the core is missing.
    """
    settings = context.scene.fantasia3d
    job = _job_of(settings)
    seeds = [(job["seed"] + n) % history.SEEDS for n in range(settings.candidates)]
    with tempfile.TemporaryDirectory() as folder:
        files = _guide(context, job, Path(folder))
        # Next to each other: of several, only one could be exactly at the cursor.
        target = dataclasses.replace(session.target_here(context), place=FREE)
        jobs = [job | {"seed": seed} for seed in seeds]
        return _submit_candidates(context, jobs, target, files, candidates.SHAPE)


def recolor(context: bpy.types.Context, entry: Entry) -> Path:
    """Request first looks at several materials for the shape of ``entry``; the first run folder.

    Raises:
        AddonError: its shape is not finished, or a file that it needs no longer exists.
    """
    reason = reason_against_recolor(entry)
    if reason:
        raise AddonError(reason)
    job, files = history.copy_of_job(entry)
    for name in SHAPE_PARTS:
        if (entry.folder / name).is_file():
            files[name] = entry.folder / name
    first = job.get("color_seed") or job.get("seed", 0) + 1  # the run's own material has it
    count = context.scene.fantasia3d.candidates
    jobs = [job | {"color_seed": first + n} for n in range(1, count + 1)]
    old = Target.read(entry.folder)
    target = session.target_here(context, object=old.object, uv_map=old.uv_map, assign=old.assign)
    return _submit_candidates(context, jobs, target, files, candidates.COLOR)


def reason_against_recolor(entry: Entry) -> str:
    """Why no other materials can be made for the shape of ``entry``; empty if they can."""
    if (entry.folder / SHAPE_PARTS[-1]).is_file():
        return ""
    if entry.state == history.DONE:  # a batch removes the checkpoints of what is done
        return "Its shape was not kept. Repeat it, or choose another job."
    return "Its shape is not finished. Resume it, or choose another job."


def _submit_candidates(
    context: bpy.types.Context,
    jobs: Sequence[dict[str, Any]],
    target: Target,
    files: Mapping[str, Path],
    until: str,
) -> Path:
    candidate = Candidate(group=uuid.uuid4().hex, until=until)
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / candidates.NAME
        candidates.write(path, candidate)
        all_files = {**files, candidates.NAME: path}
        runs = [session.submit(context, job, target, all_files) for job in jobs]
    return runs[0]


def finish(context: bpy.types.Context, entry: Entry) -> None:
    """Finish the candidate ``entry``, from its checkpoint.

    Raises:
        AddonError: it is still being made, or its folder can't be written.
    """
    if entry.folder.name in session.names:
        raise AddonError("This candidate is still being made.", "Wait until it is ready.")
    try:
        chosen = dataclasses.replace(entry.candidate, until="")
        candidates.write(entry.folder / candidates.NAME, chosen)
    except OSError as error:
        raise unwritable(entry.folder, error) from None
    if all(entry.folder != folder for folder, _ in session.waiting):
        session.enqueue(context, entry.folder)
    session.refresh()


def discard(entries: Sequence[Entry]) -> None:
    """Delete those of the candidates ``entries`` that were not chosen; one that runs is cancelled.

    Raises:
        AddonError: a folder can't be removed.
    """
    for entry in entries:
        if not entry.candidate.is_open:
            continue
        session.remove_from_queue(entry.folder)
        if entry.folder.name in session.names:
            session.cancel(entry.folder.name)
            _forget_group(entry)
        else:
            history.remove(entry)
            session.forget_candidate(entry.folder)
    session.refresh()


def _forget_group(entry: Entry) -> None:
    """Leave a run that is being cancelled in the history, but no longer as a candidate."""
    with suppress(OSError):
        candidates.write(entry.folder / candidates.NAME, Candidate())


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
    job = _job_of(settings, "texture") | {"mesh": "mesh.obj"}
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
    if now.state == history.PAUSED and now.candidate.is_open:  # or it would pause again at once
        finish(context, now)
    else:
        session.enqueue(context, entry.folder)


def report_of(settings: bpy.types.PropertyGroup) -> Report | None:
    """The built-in model's reading of the prompt; None: not known, or another model."""
    if settings.guidance != "builtin":
        return None
    return session.report(settings.prompt, settings.ignore_unknown)


def reason_against_generate(context: bpy.types.Context) -> str:
    """Why no job can be requested now; empty if one can."""
    if not context.scene.fantasia3d.prompt.strip():
        return NO_PROMPT
    reason = reason_against_jobs(context)
    if reason:
        return reason
    if unknown(report_of(context.scene.fantasia3d)):
        return "Replace or ignore the unknown words of the prompt."
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
