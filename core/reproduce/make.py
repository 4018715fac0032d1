"""Makes a figure's rows: their runs as a batch, then their pictures and numbers.

A row is a folder with its pictures and row.json, which is written last: what is there is complete,
and is not made again. The folder's name holds a hash of its commands and of its runs.
"""

import hashlib
import json
import subprocess
import sys
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from core.batch.local import LocalPool
from core.batch.needs import gpus, needs_of
from core.batch.plan import Task, digest
from core.batch.schedule import Batch, State, is_done
from core.batch.table import Row as TableRow
from core.batch.table import slug
from core.camera import Cameras
from core.errors import MissingError, UserError
from core.geometry.mesh import normalise
from core.io.atomic import disk_errors
from core.io.job import Job, write_text
from core.io.json_file import read_object
from core.io.mesh_file import load_mesh
from core.io.png import write_png
from core.job_config import BUILTIN
from core.render.normals import render_normals
from core.reproduce.figures import ASSETS, Figure, Row
from core.reproduce.guides import guide_file
from core.reproduce.numbers import measured
from core.stages.preview import over_grey
from core.terminal import show

ROOT = Path(__file__).parents[2]
GUIDE = "guide"  # a shot of the guide mesh in place of a command
IN_CYCLES = ("relight", "cornell", "physics")
OF_WORDS = ("rank", "color")  # measures that compare with the built-in prior's own data
RETRIES = 1
# The shortest of everything, to see the whole path through: what comes out is no likeness.
QUICK = (
    "geometry.resolution=12,14", "geometry.fit_steps=20", "geometry.views=2",
    "geometry.views_at_once=2", "geometry.coarse.steps=2", "geometry.grow.rounds=1",
    "geometry.grow.steps=2", "geometry.grow.views=2", "geometry.refine.rounds=1",
    "geometry.refine.steps=2", "geometry.refine.views=2", "geometry.sharpen.rounds=0",
    "appearance.shading=split_sum", "appearance.views=2", "appearance.early.steps=2",
    "appearance.late.steps=1", "appearance.early.size=32", "appearance.late.size=32",
    "appearance.refine.rounds=1", "appearance.refine.steps=2", "appearance.refine.views=2",
    "appearance.refine.size=32", "texture.size=64", "texture.max_faces=200",
    "geometry.grow.denoise_steps=1", "geometry.refine.denoise_steps=1",
    "appearance.refine.denoise_steps=1",
)  # fmt: skip

JobOf = Callable[[list[str]], Job]  # of the words of a ``generate`` command


@dataclass(frozen=True)
class Order:
    """Where and how everything is made."""

    out: Path
    job_of: JobOf
    guidance: str = BUILTIN
    quick: bool = False
    at_once: int | None = None

    @property
    def size(self) -> int:
        """Pixels of a picture's side."""
        return 48 if self.quick else 256

    @property
    def samples(self) -> int:
        """The samples of a pixel in Cycles."""
        return 2 if self.quick else 48


@dataclass(frozen=True)
class Plan:
    """One row with the runs that it needs and the folder that it goes to."""

    row: Row
    runs: dict[str, Task]  # by the assets' names
    folder: Path

    @property
    def result(self) -> dict[str, Any] | None:
        """The content of row.json; None where there is none."""
        path = self.folder / "row.json"
        return read_object(path, "Remove it.") if path.exists() else None

    @property
    def is_made(self) -> bool:
        """Whether it is complete; one that failed is tried again."""
        result = self.result
        return bool(result) and not result["failure"]


def plan(figure: Figure, order: Order) -> list[Plan]:
    """Each row of ``figure`` with its runs."""
    return [_plan(figure, row, order) for row in figure.rows]


def _plan(figure: Figure, row: Row, order: Order) -> Plan:
    runs = {name: _task(name, order) for name in (row.asset, *row.others)}
    names = sorted(task.folder.name for task in runs.values() if task.folder)
    decides = [row.shots, row.numbers, names, order.size, order.samples]
    number = hashlib.sha256(json.dumps(decides).encode()).hexdigest()[:8]
    return Plan(row, runs, order.out / "figures" / figure.name / f"{slug(row.name)}-{number}")


def words_of(name: str, order: Order) -> list[str]:
    """The command line that makes the asset ``name``."""
    asset = ASSETS[name]
    free = order.guidance != BUILTIN
    options = [f"--guidance={order.guidance}", "--preset=standard"] if free else []
    options += asset.options
    if asset.guide:
        options.append(f"--guide={order.out / 'guides' / asset.guide}.obj")
    options += [f"--set={text}" for text in QUICK if order.quick]
    return ["generate", *options, "--", asset.paper if free and asset.paper else asset.prompt]


def _task(name: str, order: Order) -> Task:
    job = order.job_of(words_of(name, order))
    return Task(TableRow(0, job.prompt, name), order.out / "runs" / f"{name}-{digest(job)}", job)


def make(figure: Figure, order: Order, rows: Sequence[str] = ()) -> None:
    """Make what is missing of ``figure``; a row that cannot be made records why.

    ``rows``: their names; empty is all of them.

    Raises:
        KeyboardInterrupt: stopped; the next call continues.
    """
    for row in figure.rows:  # before the plan: a guide's content decides its run's name
        if guide := ASSETS[row.asset].guide:
            guide_file(order.out / "guides", guide)
    wanted = [each for each in plan(figure, order) if not rows or each.row.name in rows]
    missing = [each for each in wanted if not each.is_made]
    failures = _make_runs(missing, order)
    for each in missing:
        _make_row(each, order, failures)
        result = each.result or {}
        show(f"{figure.name}: {each.row.name}: {result.get('failure') or 'done'}")


def _make_runs(plans: Sequence[Plan], order: Order) -> dict[Path, str]:
    """Make the runs that are not there; why some could not be made, by their folders."""
    tasks = {task.folder: task for each in plans for task in each.runs.values()}
    todo = [task for task in tasks.values() if not is_done(task)]
    if not todo:
        return {}
    assert todo[0].job
    pool = LocalPool(needs_of(todo[0].job, gpus() > 0), order.at_once)
    states: dict[Path, State] = {}
    with disk_errors(order.out):
        (order.out / "runs").mkdir(parents=True, exist_ok=True)
    Batch(todo, pool, RETRIES, lambda _: None, 0, states).run()
    return {path: state.end.text for path, state in states.items() if state.end and state.end.code}


def _make_row(plan: Plan, order: Order, failures: dict[Path, str]) -> None:
    folders = {name: task.folder for name, task in plan.runs.items() if task.folder}
    failed = [failures[folder] for folder in folders.values() if folder in failures]
    with disk_errors(plan.folder):
        plan.folder.mkdir(parents=True, exist_ok=True)
    result: dict[str, Any] = {"failure": "", "pictures": [], "numbers": {}}
    try:
        if failed:
            raise UserError(failed[0])
        result["pictures"] = [_shoot(plan, i, folders, order) for i in range(len(plan.row.shots))]
        result["numbers"] = _measure(plan.row, folders[plan.row.asset], order)
    except UserError as error:
        if error.status == MissingError.status:  # of this machine, not of the row
            raise
        result["failure"] = error.text
    write_text(plan.folder / "row.json", json.dumps(result, indent=1) + "\n")


def _measure(row: Row, run: Path, order: Order) -> dict[str, object]:
    asset = ASSETS[row.asset]
    guide = order.out / "guides" / f"{asset.guide}.obj" if asset.guide else None
    names = [n for n in row.numbers if order.guidance == BUILTIN or n not in OF_WORDS]
    found = {name: measured(name, run, asset, guide) for name in names}
    return {name: value for name, value in found.items() if value is not None}


def _shoot(plan: Plan, index: int, folders: dict[str, Path], order: Order) -> str:
    """The name of the row's picture number ``index``, made unless it is there."""
    _, command = plan.row.shots[index]
    file = plan.folder / f"{index}.png"
    if file.exists():
        return file.name
    if command == GUIDE:
        guide = order.out / "guides" / f"{ASSETS[plan.row.asset].guide}.obj"
        draw_normals(guide, file, order.size)
        return file.name
    places = {name: folder / "asset" for name, folder in folders.items()}
    words = command_words(command, places | {"asset": places[plan.row.asset], "file": file})
    more = ["--samples", str(order.samples)] if words[0] in IN_CYCLES else []
    carry_out([*words, "--size", str(order.size), *more])
    return file.name


def command_words(command: str, places: dict[str, Path]) -> list[str]:
    """``command`` with its places filled in, each one word."""
    return [word.format_map(places) for word in command.split()]


def carry_out(words: Sequence[str]) -> None:
    """Run a command of run.py.

    Raises:
        MissingError: there is no run.py, as in the extension's zip.
        UserError: what the command reports.
    """
    if not (ROOT / "run.py").is_file():
        raise MissingError(
            "This copy of the project has no run.py.", "Run it from the project's own folder."
        )
    command = [sys.executable, str(ROOT / "run.py"), *words]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode:
        errors = [line for line in done.stderr.splitlines() if line.startswith("error: ")]
        raise UserError(errors[-1][7:] if errors else f"{words[0]} failed: {done.stderr[-300:]}")


def draw_normals(path: Path, out: Path, size: int) -> None:
    """A picture of a mesh's normals, from the camera of the ``render`` command."""
    mesh = load_mesh(path)
    verts, _, _ = normalise(mesh.verts)
    n, o = render_normals(verts, mesh.faces, Cameras.orbit([30.0], [20.0]), size, "object")
    write_png(out, over_grey((n[0] + o[0]) / 2, o[0]))
