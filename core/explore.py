"""The ``explore`` and ``recolor`` commands: quick candidates; one of them is then finished.

A candidate is an ordinary run that has paused at a first look: at its shape, after half of growing,
or at its colours, after one round of refining. ``resume`` finishes it, to the asset that a run
without the pause makes.
"""

import shutil
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from PIL import Image, ImageDraw

from core.errors import NoSurfaceError, UserError
from core.generate import prepare
from core.io.atomic import atomic_file
from core.io.job import Job, read_events
from core.io.run_folder import RunFolder
from core.job_config import is_kept
from core.terminal import show

SHEET = "candidates.png"
PICTURES = {"shape": "normals.png", "color": "color.png"}  # the preview of a first look
COUNT = (1, 64)  # candidates
SIDE, LABEL, COLUMNS = 256, 24, 4  # pixels of a picture and of the line under it; pictures in a row
GREY, INK = (230, 230, 230), (40, 40, 40)  # the previews' own background
SHAPE_PARTS = (
    "geometry",
    "reshaped",
    "front",
    "mesh",
)  # checkpoints that a shape's recoloured runs start from


def explore(folder: Path, job: Job, count: int, make: Any) -> Path:
    """First looks at ``count`` shapes of ``job``, of its seed and the next; the contact sheet.

    ``make(run, inputs, until)`` carries a run out. Called again, it makes what is missing.
    """
    _check(folder, count)
    if job.command != "generate" or is_kept(job):
        raise UserError("There is no shape to explore: the mesh is given.", "Use recolor.")
    inputs = prepare(job)  # once: no seed is in it
    jobs = [replace(job, seed=job.seed + n) for n in range(count)]
    return _candidates(folder, jobs, "shape", lambda run: make(run, inputs, "shape"))


def recolor(folder: Path, shape: Path, count: int, make: Any) -> Path:
    """First looks at ``count`` materials on the shape of the run ``shape``; the contact sheet."""
    _check(folder, count)
    source = RunFolder.open(shape)
    if not source.has("mesh"):
        if source.asset.exists():  # resume would train it all again
            raise UserError(
                f"{shape} is done, and its shape was not kept, as a batch keeps none.",
                "Name a run of `generate`, or texture the asset's own mesh: run.py texture "
                f"{source.asset / 'mesh.obj'}",
            )
        raise UserError(
            f"The shape of {shape} is not finished.",
            f"Finish it first: run.py resume {shape} --until color",
        )
    job = source.job
    inputs = prepare(job)
    # The run's own material has the first of these seeds.
    first = job.color_seed or job.seed + 1
    jobs = [replace(job, color_seed=first + n) for n in range(1, count + 1)]

    def look(run: RunFolder) -> None:
        _take_shape(run, source)
        make(run, inputs, "color")

    return _candidates(folder, jobs, "color", look)


def _candidates(folder: Path, jobs: Sequence[Job], until: str, look: Any) -> Path:
    """A run folder for each of ``jobs`` in ``folder``, looked at; the contact sheet."""
    runs = [_run(folder / f"candidate-{n}", job) for n, job in enumerate(jobs, 1)]
    for run in runs:
        if not _looked_at(run.path):
            try:
                look(run)
            except NoSurfaceError as error:  # an unlucky seed; the others are worth looking at
                show(f"{run.path.name}: {error.text}")
        write_sheet(folder / SHEET, runs, until)
    return folder / SHEET


def _run(path: Path, job: Job) -> RunFolder:
    """The candidate in ``path``, made where it is missing; UserError for one of another job."""
    if not (path / "job.json").exists():
        return RunFolder.create(path, job)
    run = RunFolder.open(path)
    if run.job != job:
        raise UserError(
            f"{path} is a candidate of other settings.", "Use another --out, or the same settings."
        )
    return run


def _looked_at(path: Path) -> bool:
    events = read_events(path)
    return bool(events) and events[-1]["type"] in ("paused", "done")


def _take_shape(run: RunFolder, source: RunFolder) -> None:
    """Copy the finished shape of ``source``; the unwrapped mesh, which marks it complete, last."""
    if run.has("mesh"):
        return
    (run.path / "checkpoint").mkdir(exist_ok=True)
    for name in SHAPE_PARTS:
        if source.has(name):
            file = f"checkpoint/{name}.safetensors"
            with atomic_file(run.path / file) as temporary:
                shutil.copyfile(source.path / file, temporary)


def write_sheet(path: Path, runs: Sequence[RunFolder], until: str) -> None:
    """One picture of all candidates that can be looked at, each with its number and its seed."""
    columns = min(COLUMNS, len(runs))
    rows = -(-len(runs) // columns)
    sheet = Image.new("RGB", (columns * SIDE, rows * (SIDE + LABEL)), GREY)
    draw = ImageDraw.Draw(sheet)
    for n, run in enumerate(runs):
        x, y = n % columns * SIDE, n // columns * (SIDE + LABEL)
        job = run.job
        seed = job.color_seed if until == "color" else job.seed
        draw.text((x + 8, y + SIDE + 4), f"{n + 1}: seed {seed}", INK, font_size=14)
        picture = run.path / "preview" / PICTURES[until]
        if picture.is_file():
            with Image.open(picture) as image:
                sheet.paste(image.convert("RGB").resize((SIDE, SIDE)), (x, y))
    with atomic_file(path) as temporary:
        sheet.save(temporary, "PNG")


def _check(folder: Path, count: int) -> None:
    """Refuse a wrong count, and a folder whose sheet is the user's own picture."""
    low, high = COUNT
    if not low <= count <= high:
        raise UserError(f"--count is {count}.", f"Use {low} to {high}.")
    if (folder / SHEET).exists() and not any(folder.glob("candidate-*/job.json")):
        raise UserError(
            f"{folder} holds a {SHEET} that does not belong to candidates.",
            "Choose another --out, or rename that file.",
        )
