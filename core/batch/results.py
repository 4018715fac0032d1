"""The results of a batch: a row for each of the table's rows, and its CSV file."""

import csv
import io
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, fields
from pathlib import Path
from typing import Any

from core.batch.attempt import cause
from core.batch.options import OUT_OF_TIME
from core.batch.plan import Task
from core.batch.schedule import State
from core.errors import UserError
from core.io.job import LAST, read_events, write_text
from core.io.json_file import read_object

REMAKE = "Remove its folder and call batch again."


@dataclass(frozen=True)
class Result:
    """One row of report.csv."""

    name: str
    state: str  # done, failed, unfinished (it resumes) or missing
    folder: str  # in the batch's folder
    line: int  # of the table
    prompt: str
    seed: int | str
    attempts: int  # of this call; 0 where there was nothing to do
    seconds: float | str  # that its stages took, in all sessions
    node: str
    faces: int | str
    components: int | str
    closed: bool | str
    text: str  # why it failed


def result_of(task: Task, states: Mapping[Path, State]) -> Result:
    """The result of ``task``, from its run folder and this call's ``states``."""
    row = {"name": task.name, "line": task.row.line, "prompt": task.row.prompt}
    if task.folder is None or task.job is None:
        return Result(state="failed", folder="", seed="", text=task.error, **row, **_nothing())
    state = states.get(task.folder, State())
    here = {"folder": task.folder.name, "seed": task.job.seed, "attempts": state.attempts}
    here |= {"node": state.end.node if state.end else ""}
    asset = task.folder / "asset" / "asset.json"
    try:
        if asset.is_file():
            return Result(state="done", text="", **row, **(_nothing() | here | _made(asset)))
        name, text = _unmade(task.folder, state)
    except UserError as error:  # one broken asset must not stop the others
        name, text = "failed", str(error)
    return Result(state=name, text=text, **row, **(_nothing() | here))


def _nothing() -> dict[str, Any]:
    return {"attempts": 0, "node": "", **dict.fromkeys(
        ("seconds", "faces", "components", "closed"), "")}  # fmt: skip


def _made(asset: Path) -> dict[str, Any]:
    info = read_object(asset, REMAKE)
    mesh, timings = info.get("mesh"), info.get("timings")
    mesh = mesh if isinstance(mesh, dict) else {}
    seconds = sum(timings.values()) if isinstance(timings, dict) else 0.0
    health = {key: mesh.get(key, "") for key in ("faces", "components", "closed")}
    return {"seconds": round(seconds, 1), **health}


def _unmade(folder: Path, state: State) -> tuple[str, str]:
    """Its state and why, of a run without an asset: of this call, or of an earlier one."""
    if state.end and state.end.code not in (130, OUT_OF_TIME):
        return "failed", state.end.text
    if state.end:
        return "unfinished", state.end.text
    try:
        events = [event for event in read_events(folder) if event.get("type") in (*LAST, "started")]
    except (UserError, OSError):
        return "failed", f"{folder / 'events.jsonl'} cannot be read. {REMAKE}"
    if not events:
        return "missing", ""
    return ("failed", cause(folder, 2)) if events[-1]["type"] == "error" else ("unfinished", "")


def write_report(path: Path, results: Sequence[Result]) -> None:
    """Write ``results`` as a CSV file, whole."""
    text = io.StringIO()
    writer = csv.DictWriter(text, [f.name for f in fields(Result)], lineterminator="\n")
    writer.writeheader()
    writer.writerows(map(asdict, results))
    write_text(path, text.getvalue())
