"""The run folders as a history: what was asked, what became of it, how to do it again. No bpy."""

from __future__ import annotations

import dataclasses
import json
import random
import shutil
import time
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from ..errors import JobError
from .process import LAST, START_SECONDS, is_core

WAITING, RUNNING, DONE, FAILED, CANCELLED, STOPPED = (
    "waiting",  # its job is written, and nobody has begun it
    "running",
    "done",
    "failed",
    "cancelled",
    "stopped",  # its process died without a word
)
FILES = {"guide_mesh": "guide.obj", "mesh": "mesh.obj", "base_color": "base_color.png"}
SEEDS = 2**31  # as many as Blender's number fields hold
TAIL = 1 << 16  # bytes; several hundred events


@dataclass(frozen=True, kw_only=True)
class Entry:
    """One run folder."""

    folder: Path
    job: Mapping[str, Any] = field(default_factory=dict)  # job.json
    state: str = WAITING
    stage: str = ""
    text: str = ""  # of an error
    fix: str = ""
    begun: float = 0.0  # seconds since the epoch; when job.json was written
    seconds: float = 0.0  # of the last session
    stamp: float = 0.0  # when the last event was written, as the file system has it

    @property
    def prompt(self) -> str:
        """What was asked for."""
        return str(self.job.get("prompt", ""))

    @property
    def picture(self) -> Path | None:
        """The best picture of it that there is."""
        names = ("asset/preview.png", "preview/color.png", "preview/normals.png")
        return next((path for name in names if (path := self.folder / name).is_file()), None)

    @property
    def resumable(self) -> bool:
        """Whether the core may go on with it; what failed at once would fail again."""
        begun = self.state == FAILED and (self.folder / "checkpoint").is_dir()
        return begun or self.state in (CANCELLED, STOPPED)


def scan(runs: Path, known: Mapping[Path, Entry] | None = None) -> list[Entry]:
    """All runs in the folder ``runs``, the newest first.

    ``known`` are entries of an earlier scan: those that have ended are not read again.
    """
    try:
        folders = sorted((p for p in runs.iterdir() if p.is_dir()), reverse=True)
    except OSError:
        return []
    found = []
    for folder in folders:
        old = (known or {}).get(folder)
        ended = old is not None and old.state in (DONE, FAILED, CANCELLED)
        entry = old if ended and _settled(folder, old) else read_entry(folder)
        found += [entry] if entry else []
    return sorted(found, key=lambda entry: entry.begun, reverse=True)


def _settled(folder: Path, entry: Entry) -> bool:
    """Whether nothing was written since ``entry`` was read."""
    return _stamp(folder) == entry.stamp


def _stamp(folder: Path) -> float:
    try:
        return (folder / "events.jsonl").stat().st_mtime
    except OSError:
        return 0.0


def read_entry(folder: Path) -> Entry | None:
    """The run in ``folder``; None where there is none."""
    try:
        begun = (folder / "job.json").stat().st_mtime
        job = json.loads((folder / "job.json").read_text("utf-8"))
    except (OSError, ValueError):
        return None
    if not isinstance(job, dict):
        return None
    entry = Entry(folder=folder, job=job, begun=begun, stamp=_stamp(folder))
    events = _events(folder / "events.jsonl")
    if not events:
        return dataclasses.replace(entry, state=_silent(folder))
    last = events[-1]
    starts = [event for event in events if event.get("type") == "started"]
    start = starts[-1] if starts else {}
    staged = [event for event in events if event.get("stage")]
    return dataclasses.replace(
        entry,
        state=_state(folder, last, start.get("pid", 0)),
        stage=str(staged[-1]["stage"]) if staged else "",
        text=str(last.get("text", "")),
        fix=str(last.get("fix", "")),
        seconds=max(0.0, last.get("time", 0.0) - start.get("time", begun)),
    )


def _state(folder: Path, last: Mapping[str, Any], pid: int) -> str:
    ends = {"done": DONE, "error": FAILED, "cancelled": CANCELLED}
    if last.get("type") in ends:
        return ends[last["type"]]
    return RUNNING if pid and is_core(pid, folder) else STOPPED


def _silent(folder: Path) -> str:
    """The state of a run that has said nothing yet."""
    log = folder / "log.txt"
    if not log.exists():
        return WAITING
    return RUNNING if time.time() - log.stat().st_mtime < START_SECONDS else STOPPED


def _events(path: Path) -> list[dict[str, Any]]:
    """The last events; all of them where the process may still be running."""
    try:
        with path.open("rb") as file:
            size = file.seek(0, 2)
            file.seek(max(0, size - TAIL))
            events = _parse(file.read(), whole=size <= TAIL)
            if size > TAIL and not (events and events[-1].get("type") in LAST):
                file.seek(0)
                events = _parse(file.read(), whole=True)
    except OSError:
        return []
    return events


def _parse(chunk: bytes, whole: bool) -> list[dict[str, Any]]:
    lines = chunk[: chunk.rfind(b"\n") + 1].splitlines()[0 if whole else 1 :]
    events = []
    for line in lines:
        try:
            event = json.loads(line)
        except ValueError:
            continue
        events += [event] if isinstance(event, dict) else []
    return events


def again(entry: Entry, seed: int | None = None) -> tuple[dict[str, Any], dict[str, Path]]:
    """The job of ``entry`` once more, and the files that its folder must get, by name.

    Their paths in the job are names in the new folder (:func:`settle` makes them whole). ``seed``
    replaces the seed.

    Raises:
        JobError: a file of the old run has gone.
    """
    job = dict(entry.job)
    if seed is not None:
        job["seed"] = seed
    files = {}
    for key, name in FILES.items():
        given = job.get(key)
        if not given or (key == "base_color" and given == "mesh"):
            continue
        path = Path(given)
        if not path.is_file():
            raise JobError(f"{path} has gone, which the job needs.", "Start it from the panel.")
        files[name], job[key] = path, name
    return job, files


def settle(job: Mapping[str, Any], folder: Path) -> dict[str, Any]:
    """``job`` with the paths of its own files in the run folder ``folder``."""
    own = {
        key: str((folder / name).resolve()) for key, name in FILES.items() if job.get(key) == name
    }
    return dict(job) | own


def another_seed(seed: int) -> int:
    """Any seed but ``seed``."""
    return (seed + random.randrange(1, SEEDS)) % SEEDS


def remove(entry: Entry) -> None:
    """Remove a run from the disk, its asset too.

    Raises:
        JobError: it is running, or the folder can't be removed.
    """
    now = read_entry(entry.folder)
    if now is None:
        return
    if now.state == RUNNING:
        raise JobError(f"“{entry.prompt}” is still running.", "Cancel it first.")
    try:
        shutil.rmtree(entry.folder)
    except OSError as error:
        raise JobError(
            f"{entry.folder} can't be removed ({error.strerror}).",
            "Close what has its files open.",
        ) from None
