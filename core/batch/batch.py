"""``run.py batch TABLE --out DIR``: an asset for each row, made here or on a cluster."""

from argparse import Namespace
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from core.batch.local import LocalPool
from core.batch.needs import Needs, check_at_once, gpus, needs_of
from core.batch.plan import Task, plan
from core.batch.results import Result, result_of, write_report
from core.batch.schedule import Batch, Pool, State, is_done
from core.batch.sheet import write_sheet
from core.batch.table import Row, read_table
from core.errors import Cancelled, SomeFailedError, UserError
from core.io.atomic import disk_errors
from core.io.job import Job
from core.io.lock import run_lock
from core.job_config import config_of

# The batch's own files, by stem and ending; the lock stays, and shows that the others are ours.
LOCK, REPORT, SHEET = ("batch", ".lock"), ("report", ".csv"), ("contact_sheet", ".html")


@dataclass(frozen=True)
class Part:
    """The batch's folder and which part of the table is made: ``at`` of ``of``, from 1."""

    out: Path
    at: int = 1
    of: int = 1

    def file(self, stem: str, ending: str) -> str:
        """A file's name, which no other part of the same batch writes."""
        part = f"-{self.at}-of-{self.of}" if self.of > 1 else ""
        return f"{stem}{part}{ending}"


def run_batch(args: Namespace, job_of: Callable[[Row], Job]) -> Path:
    """Make what is missing of ``args.table``; the path of its contact sheet.

    Raises:
        UserError: a wrong option, a table that cannot be read, a folder that cannot be written.
        SomeFailedError: some assets could not be made; all others are.
        Cancelled: by Ctrl-C; a second call continues.
    """
    _check(args)
    config_of(job_of(Row(0, "a cube")))  # options that are wrong for every row
    part = Part(args.out, *args.shard)
    rows = read_table(args.table)[part.at - 1 :: part.of]
    tasks = plan(rows, part.out, job_of)
    _keep_the_users(part)
    with disk_errors(part.out):
        part.out.mkdir(parents=True, exist_ok=True)
    with run_lock(part.out, part.file(*LOCK)):
        return _make(tasks, part, args)


def _check(args: Namespace) -> None:
    check_at_once(args.at_once)
    if args.retries < 0:
        raise UserError(f"--retries is {args.retries}.", "Use 0 or more.")
    if args.timeout is not None and not args.timeout > 0:
        raise UserError(f"--timeout is {args.timeout:g}.", "Use seconds, more than 0.")
    if args.ray is not None and not args.ray.strip():  # a script's variable that was never set
        raise UserError("--ray is empty.", "Use auto, local or HOST:PORT.")
    if args.out.exists() and not args.out.is_dir():
        raise UserError(
            f"--out is {args.out}, which is not a folder.", "Name a folder, or a new one."
        )


def _keep_the_users(part: Part) -> None:
    """Refuse a folder with a report or a sheet that no batch has written."""
    if (part.out / part.file(*LOCK)).exists():
        return
    for name in (part.file(*REPORT), part.file(*SHEET)):
        if (part.out / name).exists():
            raise UserError(
                f"{part.out} holds a {name} that does not belong to a batch.",
                "Choose another --out, or rename that file.",
            )


def _make(tasks: list[Task], part: Part, args: Namespace) -> Path:
    by_folder = {task.folder: task for task in reversed(tasks) if task.folder and task.job}
    runs = list(reversed(by_folder.values()))

    def save(states: dict[Path, State]) -> list[Result]:
        results = [result_of(task, states) for task in tasks]
        write_report(part.out / part.file(*REPORT), results)
        return results

    states: dict[Path, State] = {}
    refused = sum(task.folder is None for task in tasks)
    stopped = False
    try:
        todo = [task for task in runs if not is_done(task)]
        if todo:
            pool = _pool(todo, args)
            Batch(runs, pool, args.retries, save, refused, states).run()
    except KeyboardInterrupt:
        stopped = True
    results = save(states)
    title = f"{args.table.stem}: {len(results)} assets"
    sheet = write_sheet(part.out, part.file(*SHEET), results, title)
    _raise_what_is_wrong(results, stopped, part)
    return sheet


def _pool(runs: list[Task], args: Namespace) -> Pool:
    if args.ray is None:
        return LocalPool(_needs(runs, gpus() > 0), args.at_once, args.timeout)
    from core.batch.cluster import RayPool, connect

    return RayPool(_needs(runs, connect(args.ray)), args.at_once, args.timeout)


def _needs(runs: list[Task], has_gpu: bool) -> Needs:
    return _most([needs_of(task.job, has_gpu) for task in runs if task.job])


def _most(needs: list[Needs]) -> Needs:
    """The most of each: one place fits every asset of the batch."""
    named = [n.cards for n in needs if n.gpus]
    return Needs(
        max(n.cpus for n in needs),
        max(n.memory for n in needs),
        max(n.gpus for n in needs),
        frozenset().union(*named) if all(named) else frozenset(),
    )


def _raise_what_is_wrong(results: list[Result], stopped: bool, part: Part) -> None:
    done = sum(result.state == "done" for result in results)
    if stopped:
        raise Cancelled(
            f"Stopped: {done} of {len(results)} are done.", "The same command continues it."
        )
    if done < len(results):
        raise SomeFailedError(
            f"{len(results) - done} of {len(results)} assets were not made.",
            f"Read {part.out / part.file('report', '.csv')}; the same command tries them again.",
        )
