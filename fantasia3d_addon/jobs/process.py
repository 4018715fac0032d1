"""Starts, follows and cancels one process of the core through its run folder. No bpy, no threads.

The process outlives Blender: after a crash or a restart, :meth:`Run.attach` follows it again.
The run folder is described in docs/architecture.md.
"""

from __future__ import annotations

import contextlib
import ctypes
import dataclasses
import json
import os
import shutil
import signal
import subprocess
import sys
import time
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from ..environment import clean_environ
from ..errors import JobError

LAST = ("done", "error", "cancelled")  # exactly one of these ends a stream
FULL = 1e5  # bytes: less is no room for a picture or a checkpoint
START_SECONDS = 90.0  # a process that loads torch from a cold disk may be silent for this long


@dataclass(frozen=True, kw_only=True)
class Event:
    """One line of events.jsonl; what does not apply is empty."""

    type: str  # started, progress, preview, warning, error, done, cancelled
    time: float = 0.0  # seconds since the epoch
    stage: str = ""
    step: int = 0
    steps: int = 0
    loss: float | None = None
    seconds_left: float | None = None
    text: str = ""  # one sentence for the user
    fix: str = ""  # what the user can do about it
    path: str = ""  # relative to the run folder
    pid: int = 0


class Run:
    """One run folder. :meth:`poll` is cheap and never blocks: call it from a timer or a loop."""

    def __init__(
        self, folder: Path, process: subprocess.Popen[bytes] | None = None, offset: int = 0
    ) -> None:
        self.folder = folder
        self.pid = process.pid if process else 0
        self.last: Event | None = None  # set once the stream has ended
        self._process = process
        self._offset = offset
        self._since = time.time()

    @classmethod
    def start(
        cls,
        folder: Path,
        job: Mapping[str, Any],
        python: Path,
        core_root: Path,
        environ: Mapping[str, str] | None = None,
    ) -> Run:
        """Write ``job`` as job.json into the new run folder ``folder`` and start the core on it.

        Raises:
            JobError: the folder holds another run or can't be written, or ``python`` can't run.
        """
        prepare(folder, job)
        return cls.resume(folder, python, core_root, environ)

    @classmethod
    def resume(
        cls,
        folder: Path,
        python: Path,
        core_root: Path,
        environ: Mapping[str, str] | None = None,
    ) -> Run:
        """Start the core on what ``folder`` holds, from its last checkpoint; its events from now.

        Raises:
            JobError: as :meth:`start`.
        """
        events = folder / "events.jsonl"
        offset = events.stat().st_size if events.exists() else 0
        try:
            (folder / "cancel").unlink(missing_ok=True)
            with (folder / "log.txt").open("ab") as log:
                process = _spawn(folder, python, core_root, environ or {}, log)
        except FileNotFoundError:
            raise JobError(
                f"There is no Python at {python}.", "Press Set up in the add-on's preferences."
            ) from None
        except OSError as error:
            if error.filename and Path(os.fsdecode(error.filename)).is_relative_to(folder):
                raise _unwritable(folder, error) from None
            raise JobError(
                f"{python} can't be run ({error.strerror}).",
                "Press Set up in the add-on's preferences, or choose another Python there.",
            ) from None
        return cls(folder, process, offset)

    @classmethod
    def attach(cls, folder: Path) -> Run:
        """Follow a run from its first event on, whoever started it, alive or dead."""
        return cls(folder)

    @property
    def finished(self) -> bool:
        """True when the stream has ended and the process, if it is ours, has gone."""
        return self.last is not None and (self._process is None or self._process.poll() is not None)

    @property
    def asset(self) -> Path:
        """The asset folder; it is there when it is complete."""
        return self.folder / "asset"

    @property
    def resumable(self) -> bool:
        """Whether there is something to go on from."""
        return (self.folder / "checkpoint").is_dir()

    @property
    def log(self) -> Path:
        """What the core and its libraries print."""
        return self.folder / "log.txt"

    def poll(self) -> list[Event]:
        """The events since the last call; a process that died without a word counts as one."""
        dead = self.last is None and self._is_dead()
        events = self._read()  # after the look at the process, so that no last word is missed
        for event in events:
            self.pid = event.pid or self.pid
            if event.type == "started":
                self.last = None  # an earlier session's end is not this one's
            elif event.type in LAST:
                self.last = event
        if dead and self.last is None:
            self.last = self._died()
            events.append(self.last)
        return events

    def cancel(self) -> None:
        """Ask the core to stop after its present step; a ``cancelled`` event is the answer."""
        (self.folder / "cancel").touch()

    def kill(self) -> None:
        """End the process at once; the run resumes from its last checkpoint."""
        if self.pid and (self._process is not None or is_core(self.pid, self.folder)):
            kill_process(self.pid)

    def _is_dead(self) -> bool:
        if self._process is not None:
            return self._process.poll() is not None
        if self.pid:
            return not is_core(self.pid, self.folder)
        return time.time() - self._newest() > START_SECONDS

    def _newest(self) -> float:
        """When the process may have been started: its log is opened first."""
        return self.log.stat().st_mtime if self.log.exists() else self._since - START_SECONDS

    def _died(self) -> Event:
        text, fix = self._reason()
        return Event(type="error", time=time.time(), text=text, fix=fix)

    def _reason(self) -> tuple[str, str]:
        """Why a process may have died without a word, and what to do."""
        if not self.folder.is_dir():
            return f"The run's folder {self.folder} has gone.", "Ask for the asset again."
        if shutil.disk_usage(self.folder).free < FULL:
            return f"The disk of {self.folder} is full.", "Free some space, then resume the run."
        code = self._process.returncode if self._process else None
        how = f" (signal {-code})" if code is not None and code < 0 else ""
        more = " The system may have run short of memory." if code == -9 else ""
        return (
            f"The generator stopped without a word{how}.",
            f"Read {self.log}.{more} The run can be resumed.",
        )

    def _read(self) -> list[Event]:
        """The whole lines since the last call; one that is still being written waits."""
        try:
            with (self.folder / "events.jsonl").open("rb") as file:
                file.seek(self._offset)
                chunk = file.read()
        except FileNotFoundError:
            return []
        whole = chunk[: chunk.rfind(b"\n") + 1]
        self._offset += len(whole)
        return [_event(line) for line in whole.splitlines() if line.strip()]


def prepare(folder: Path, job: Mapping[str, Any]) -> None:
    """Write ``job`` as job.json into the new run folder ``folder``; nothing is started.

    Raises:
        JobError: the folder holds another run or can't be written.
    """
    if (folder / "job.json").exists():
        raise JobError(f"{folder} holds a run already.", "Resume it, or take another folder.")
    try:
        folder.mkdir(parents=True, exist_ok=True)
        write_json(folder / "job.json", job)
    except OSError as error:
        raise _unwritable(folder, error) from None


def write_json(path: Path, data: Mapping[str, Any]) -> None:
    """Write a small JSON file whole: aside, then renamed."""
    aside = path.with_name(path.name + ".tmp")
    aside.write_text(json.dumps(data, ensure_ascii=False, indent=1) + "\n", "utf-8")
    aside.replace(path)


def is_core(pid: int, folder: Path) -> bool:
    """Whether ``pid`` lives and, where the system tells, is the core's process for ``folder``."""
    if sys.platform == "win32":
        return _lives_on_windows(pid)
    try:
        os.kill(pid, 0)
    except (ProcessLookupError, PermissionError):  # a stranger's process took the number over
        return False
    status = Path(f"/proc/{pid}/cmdline")  # Linux; empty for a zombie
    return os.fsencode(folder.name) in status.read_bytes() if status.exists() else True


def kill_process(pid: int) -> None:
    """End ``pid`` and the processes that it started."""
    if sys.platform == "win32":
        command = ["taskkill", "/F", "/T", "/PID", str(pid)]
        subprocess.run(command, capture_output=True, check=False)
        return
    with contextlib.suppress(ProcessLookupError):
        os.killpg(pid, signal.SIGKILL)  # :func:`_spawn` made it the first of its group


def _lives_on_windows(pid: int) -> bool:
    kernel = ctypes.windll.kernel32  # type: ignore[attr-defined]
    handle = kernel.OpenProcess(0x00100000, False, pid)  # SYNCHRONIZE
    if not handle:
        return False
    running = kernel.WaitForSingleObject(handle, 0) == 0x102  # WAIT_TIMEOUT
    kernel.CloseHandle(handle)
    return running


def _spawn(
    folder: Path, python: Path, core_root: Path, environ: Mapping[str, str], log: Any
) -> subprocess.Popen[bytes]:
    flags = getattr(subprocess, "CREATE_NO_WINDOW", 0)  # Windows: no console pops up
    return subprocess.Popen(
        [str(python), "-m", "core", "resume", str(folder.resolve())],
        cwd=core_root,
        env=clean_environ() | {"PYTHONUNBUFFERED": "1", "PYTHONUTF8": "1"} | dict(environ),
        stdin=subprocess.DEVNULL,
        stdout=log,
        stderr=subprocess.STDOUT,
        start_new_session=True,  # Ctrl-C in Blender's terminal is not meant for it
        creationflags=flags,
    )


def _event(line: bytes) -> Event:
    try:
        data = json.loads(line)
        known = {f.name for f in dataclasses.fields(Event)}
        return Event(**{key: value for key, value in data.items() if key in known})
    except (ValueError, TypeError, AttributeError):
        return Event(
            type="warning",
            text="A line of events.jsonl can't be read.",
            fix="Install the add-on and the core of the same release.",
        )


def _unwritable(folder: Path, error: OSError) -> JobError:
    return JobError(
        f"{folder} can't be written ({error.strerror}).",
        "Choose another run folder in the add-on's preferences.",
    )
