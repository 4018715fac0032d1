"""The run folders as a history: each job, its state, and how to repeat it. No bpy."""

from __future__ import annotations

import dataclasses
import random
import shutil
import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Any

from ..blender.input_file import require_file
from ..errors import JobError
from . import candidates, target
from .candidates import Candidate
from .events import END_EVENTS, event_object
from .job_file import FILES, IMPORTED, KEPT, NAME, read_job
from .lock import RunLock
from .process import START_SECONDS, is_core
from .untrusted import read_object

WAITING, RUNNING, DONE, FAILED, CANCELLED, STOPPED, PAUSED = (
    "waiting",  # its job is written, but it was never started
    "running",
    "done",
    "failed",
    "cancelled",
    "stopped",  # its process ended without a last event
    "paused",  # a candidate that can be looked at
)
ADOPTABLE = (RUNNING, WAITING, DONE)  # what a new Blender takes over
SEEDS = 2**31  # as many as an IntProperty of Blender holds
SHAPE = "checkpoint/mesh.safetensors"  # the finished shape of a run
TAIL = 1 << 16  # bytes read from the end of events.jsonl: several hundred events


@dataclass(frozen=True, kw_only=True)
class Entry:
    """One run folder."""

    folder: Path
    job: Mapping[str, Any] = field(default_factory=dict)  # job.json
    state: str = WAITING
    stage: str = ""
    text: str = ""  # of an error
    fix: str = ""
    requested: float = 0.0  # seconds since the epoch; when job.json was written
    seconds: float = 0.0  # of the last session
    size_m: float = 0.0  # the longest side of a finished asset; 0: unknown
    candidate: Candidate = field(default_factory=Candidate)
    stamp: float = 0.0  # when the last event was written, as the file system has it

    @property
    def prompt(self) -> str:
        """The text of the job."""
        return str(self.job.get("prompt", ""))

    @cached_property
    def pictures(self) -> tuple[Path, ...]:
        """Where a picture of it may be, the best first."""
        names = ("asset/preview.png", "preview/color.png", "preview/normals.png")
        return tuple(self.folder / name for name in names)

    @property
    def resumable(self) -> bool:
        """Whether the core may continue it; what failed before a checkpoint would fail again."""
        failed_midway = self.state == FAILED and (self.folder / "checkpoint").is_dir()
        return failed_midway or self.state in (CANCELLED, STOPPED, PAUSED)


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
        ended = old is not None and old.state in (DONE, FAILED, CANCELLED, PAUSED)
        entry = old if ended and _is_current(folder, old) else read_entry(folder)
        found += [entry] if entry else []
    return sorted(found, key=lambda entry: entry.requested, reverse=True)


def _is_current(folder: Path, entry: Entry) -> bool:
    """Whether no event was written since ``entry`` was read, and no candidate was chosen."""
    return _stamp(folder) == entry.stamp and candidates.read(folder) == entry.candidate


def _stamp(folder: Path) -> float:
    try:
        return (folder / "events.jsonl").stat().st_mtime
    except OSError:
        return 0.0


def read_entry(folder: Path) -> Entry | None:
    """The run in ``folder``; None where there is none."""
    try:
        requested = (folder / NAME).stat().st_mtime
    except OSError:
        return None
    job = read_job(folder)
    if not job:
        return None
    entry = Entry(
        folder=folder,
        job=job,
        requested=requested,
        stamp=_stamp(folder),
        candidate=candidates.read(folder),
    )
    events = _events(folder / "events.jsonl")
    if not events:
        return dataclasses.replace(entry, state=_state_without_events(folder))
    last = events[-1]
    size = _size(folder) if last.get("type") == "done" else 0.0
    # A resumed run has several sessions: the last one counts.
    starts = [event for event in events if event.get("type") == "started"]
    start = starts[-1] if starts else {}
    staged = [event for event in events if event.get("stage")]
    return dataclasses.replace(
        entry,
        state=_state(folder, last, start.get("pid", 0)),
        stage=str(staged[-1]["stage"]) if staged else "",
        text=str(last.get("text", "")),
        fix=str(last.get("fix", "")),
        size_m=size,
        seconds=max(0.0, last.get("time", 0.0) - start.get("time", requested)),
    )


def _size(folder: Path) -> float:
    """The longest side of the run's asset in metres, by its asset.json; 0 where it has none."""
    try:
        size = read_object(folder / "asset" / "asset.json").get("size_m", 0.0)
        return float(size)
    except (OSError, ValueError, TypeError):
        return 0.0


def _state(folder: Path, last: Mapping[str, Any], pid: int) -> str:
    ends = {"done": DONE, "error": FAILED, "cancelled": CANCELLED, "paused": PAUSED}
    if last.get("type") in ends:
        return ends[last["type"]]
    return RUNNING if pid and is_core(pid, folder) else STOPPED


def _state_without_events(folder: Path) -> str:
    """The state of a run that has written no event yet."""
    log = folder / "log.txt"  # opened when the process is started
    if not log.exists():
        return WAITING
    return RUNNING if time.time() - log.stat().st_mtime < START_SECONDS else STOPPED


def _events(path: Path) -> list[dict[str, Any]]:
    """The last events; all of them where the last session's start may be before the tail."""
    try:
        require_file(path)
        with path.open("rb") as file:
            # The end is enough for a run that has ended: a long one has many thousand events.
            size = file.seek(0, 2)
            file.seek(max(0, size - TAIL))
            events = _parse(file.read(), whole=size <= TAIL)
            # Still running, or dead: the "started" event with the process id may be further back.
            if size > TAIL and not (events and events[-1].get("type") in END_EVENTS):
                file.seek(0)
                events = _parse(file.read(), whole=True)
    except OSError:
        return []
    return events


def _parse(chunk: bytes, whole: bool) -> list[dict[str, Any]]:
    # The last line may still be being written, and the first one be cut by the tail's start.
    lines = chunk[: chunk.rfind(b"\n") + 1].splitlines()[0 if whole else 1 :]
    events = []
    for line in lines:
        event = event_object(line)  # None: a line that was cut by a full disk
        events += [event] if event is not None else []
    return events


def open_candidates(entries: Sequence[Entry]) -> list[Entry]:
    """The newest group that has candidates to choose from, the chosen one included, in order."""
    group = next((e.candidate.group for e in entries if e.candidate.is_open), "")
    found = [entry for entry in entries if group and entry.candidate.group == group]
    seeds = ("color_seed", "seed")
    return sorted(found, key=lambda entry: [entry.job.get(name, 0) for name in seeds])


def copy_of_job(entry: Entry, seed: int | None = None) -> tuple[dict[str, Any], dict[str, Path]]:
    """The job of ``entry`` again, and the files that its folder must get, by name.

    In the job they are names in the new folder (``job_file.with_own_paths`` makes full paths of
    them). ``seed`` replaces the seed.

    Raises:
        JobError: a file of the old run no longer exists.
    """
    job = dict(entry.job)
    if seed is not None:
        job["seed"] = seed
        job.pop("color_seed", None)  # or a material that has one would be the same again
    files = {}
    for key, name in FILES.items():
        given = job.get(key)
        if not given or (key == "base_color" and given == "mesh"):
            continue
        path = Path(given)
        if not path.is_file():
            raise JobError(
                f"{path} no longer exists, and the job needs it.", "Request it from the panel."
            )
        files[name], job[key] = path, name
    if job.get("kept_asset"):
        files |= _kept_files(Path(job["kept_asset"]))
        job["kept_asset"] = KEPT
    return job, files


def _kept_files(asset: Path) -> dict[str, Path]:
    """The copy of an edited asset in another run, and the shape that it was made from."""
    try:
        files = {f"{KEPT}/{path.name}": path for path in asset.iterdir() if path.is_file()}
    except OSError as error:
        raise JobError(
            f"{asset} can't be read ({error.strerror}), and the job needs it.",
            "Request it from the panel.",
        ) from None
    shape = asset.parent / SHAPE
    return files | ({f"{Path(KEPT).parent}/{SHAPE}": shape} if shape.is_file() else {})


def awaits_import(entry: Entry) -> bool:
    """Whether a finished asset was requested in Blender and never came into a scene."""
    requested_in_blender = (entry.folder / target.NAME).exists()
    return requested_in_blender and not (entry.folder / IMPORTED).exists()


def other_seed(seed: int) -> int:
    """Any seed but ``seed``."""
    return (seed + random.randrange(1, SEEDS)) % SEEDS


def _is_followed(folder: Path) -> bool:
    """Whether a Blender has the run in its queue, resumes it now, or imports its asset."""
    try:
        lock = RunLock.acquire(folder)
    except JobError:  # read-only: nobody can
        return False
    if lock:
        lock.release()
    return lock is None


def remove(entry: Entry) -> None:
    """Remove a run from the disk, its asset too.

    Raises:
        JobError: it is running, a Blender waits for it, or the folder can't be removed.
    """
    now = read_entry(entry.folder)
    if now is None:
        return
    if now.state == RUNNING:
        raise JobError(f"“{entry.prompt}” is still running.", "Cancel it first.")
    if _is_followed(entry.folder):
        raise JobError(
            f"A Blender waits for “{entry.prompt}”.", "Cancel it there, or wait until it is done."
        )
    try:
        shutil.rmtree(entry.folder)
    except OSError as error:
        raise JobError(
            f"{entry.folder} can't be removed ({error.strerror}).",
            "Close the program that has its files open.",
        ) from None
