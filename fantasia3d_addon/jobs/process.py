"""Starts, follows and cancels one process of the core through its run folder. No bpy, no threads.

The process outlives Blender: after a crash or a restart, :meth:`Run.attach` follows it again.
The run folder is described in docs/architecture.md.
"""

from __future__ import annotations

import contextlib
import ctypes
import os
import shutil
import signal
import subprocess
import sys
import time
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, NamedTuple

from ..blender.input_file import require_file
from ..environment import piped_environ
from ..errors import JobError
from . import candidates
from .events import Event, parse_event
from .job_file import unwritable, write_job
from .lock import UNKNOWN, worker

CHUNK = 16 << 20  # bytes of events.jsonl read at once
FULL = 1e5  # bytes free: less than that can't hold a picture or a checkpoint
START_SECONDS = 90.0  # a process that loads torch from a cold disk may write nothing for this long


class Core(NamedTuple):
    """How the core is started."""

    python: Path  # the interpreter that has its packages
    root: Path  # the folder that holds the package ``core``
    environ: Mapping[str, str] = {}  # more variables for its process
    options: Sequence[str] = ()  # of its command resume: on which machines it works


class Run:
    """One run folder. :meth:`poll` is cheap and never blocks: call it from a timer or a loop."""

    def __init__(
        self, folder: Path, process: subprocess.Popen[bytes] | None = None, offset: int = 0
    ) -> None:
        self.folder = folder
        self.pid = process.pid if process else 0
        self.last: Event | None = None  # the event that ended the run; None while it runs
        self._process = process  # None for a process that another Blender started
        self._offset = offset  # bytes of events.jsonl that were read
        self._since = time.time()

    @classmethod
    def start(cls, folder: Path, job: Mapping[str, Any], core: Core) -> Run:
        """Write ``job`` as job.json into the new run folder ``folder`` and start the core on it.

        Raises:
            JobError: the folder holds another run or can't be written, or the core's Python can't
                be started.
        """
        write_job(folder, job)
        return cls.resume(folder, core)

    @classmethod
    def resume(cls, folder: Path, core: Core) -> Run:
        """Start the core on what ``folder`` holds, from its last checkpoint; its events from now.

        Raises:
            JobError: as :meth:`start`.
        """
        pid = worker(folder)
        if pid:
            raise JobError(
                f"Another process works on {folder} already (pid {pid}).",
                "Wait until it ends, or cancel it.",
            )
        events = folder / "events.jsonl"
        offset = events.stat().st_size if events.exists() else 0  # earlier sessions are over
        try:
            # A cancel that was requested of an earlier session is not meant for this one.
            (folder / "cancel").unlink(missing_ok=True)
            with (folder / "log.txt").open("ab") as log:
                process = _spawn(folder, core, log)
        except FileNotFoundError:
            raise JobError(
                f"There is no Python at {core.python}.",
                "Press Install in the add-on's preferences.",
            ) from None
        except OSError as error:
            # The same exception for the log and for the program: the file name distinguishes them.
            if error.filename and Path(os.fsdecode(error.filename)).is_relative_to(folder):
                raise unwritable(folder, error) from None
            raise JobError(
                f"{core.python} can't be started ({error.strerror}).",
                "Press Install in the add-on's preferences, or choose another Python there.",
            ) from None
        return cls(folder, process, offset)

    @classmethod
    def attach(cls, folder: Path) -> Run:
        """Follow a run from its first event on, whoever started it, alive or dead."""
        return cls(folder)

    @property
    def finished(self) -> bool:
        """True when the last event was read and the process, if it is ours, has exited."""
        # The process holds the GPU's memory until it exits, after its last event.
        return self.last is not None and (self._process is None or self._process.poll() is not None)

    @property
    def asset(self) -> Path:
        """The asset folder; it exists when it is complete."""
        return self.folder / "asset"

    @property
    def resumable(self) -> bool:
        """Whether there is a checkpoint to continue from."""
        return (self.folder / "checkpoint").is_dir()

    @property
    def log(self) -> Path:
        """The file with what the core and its libraries print."""
        return self.folder / "log.txt"

    def poll(self) -> list[Event]:
        """The events since the last call; a process that died without one adds an error."""
        # The events come first: they name the process to look at.
        events = self._take()
        if self.last is None and self._is_dead():
            # What it wrote before its death is never missed: only when all is read it is dead.
            late = self._take()
            if not late:
                self.last = self._died()
            events += late or [self.last]
        return events

    def cancel(self) -> None:
        """Ask the core to stop after its present step; it answers with a ``cancelled`` event.

        Raises:
            JobError: the folder can't be written; then only :meth:`kill` stops it.
        """
        try:
            (self.folder / "cancel").touch()
        except OSError as error:
            raise unwritable(self.folder, error) from None

    def kill(self) -> None:
        """End the process at once; the run resumes from its last checkpoint."""
        if self._process is not None:
            if self._process.poll() is None:  # or its number may be another's by now
                kill_process(self._process.pid)
        elif self.pid and is_core(self.pid, self.folder):
            kill_process(self.pid)

    def _is_dead(self) -> bool:
        if self._process is not None:
            return self._process.poll() is not None
        if self.pid:
            return not is_core(self.pid, self.folder)
        # Another Blender may just have started it, and its first event is still to come.
        return time.time() - self._started_at() > START_SECONDS

    def _started_at(self) -> float:
        """When the process may have been started: its log is opened first."""
        try:
            return self.log.stat().st_mtime
        except OSError:
            return self._since - START_SECONDS

    def _died(self) -> Event:
        text, fix = self._cause_of_death()
        return Event(type="error", time=time.time(), text=text, fix=fix)

    def _cause_of_death(self) -> tuple[str, str]:
        """Why a process may have exited without a last event, and what to do."""
        if not self.folder.is_dir():
            return f"The run's folder {self.folder} no longer exists.", "Generate the asset again."
        if shutil.disk_usage(self.folder).free < FULL:
            return f"The disk of {self.folder} is full.", "Free some space, then resume the run."
        code = self._process.returncode if self._process else None
        how = f" (signal {-code})" if code is not None and code < 0 else ""
        # 9 is what the Linux kernel sends to a process when memory runs out.
        more = " The system may have run out of memory." if code == -9 else ""
        return (
            f"The generator stopped unexpectedly{how}. No error was reported.",
            f"Read {self.log}.{more} The run can be resumed.",
        )

    def _take(self) -> list[Event]:
        """The events since the last call; also keeps the process's state that they report."""
        events = self._read()
        for event in events:
            self.pid = event.pid or self.pid
            if event.type == "started":
                self.last = None  # the end of an earlier session is not the end of this one
            elif event.ends:
                self.last = event
        return events

    def _read(self) -> list[Event]:
        """The complete lines since the last call; one that is still being written waits."""
        events = self.folder / "events.jsonl"
        try:
            require_file(events)
            with events.open("rb") as file:
                file.seek(self._offset)
                chunk = file.read(CHUNK)
        except OSError:  # not written yet; or the folder is gone, and the core ends by itself
            return []
        whole = chunk[: chunk.rfind(b"\n") + 1]
        # A line as long as that is not an event of ours.
        self._offset += len(whole) or (CHUNK if len(chunk) == CHUNK else 0)
        return [parse_event(line) for line in whole.splitlines() if line.strip()]


def is_core(pid: int, folder: Path) -> bool:
    """Whether ``pid`` lives and is the core's for ``folder``."""
    if not _is_alive(pid):
        return False
    # The system gives numbers of ended processes away again: look at the command line too.
    command = _command_line(pid)
    if command is not None:
        return os.fsencode(folder.name) in command
    # Where the system does not report it: the core holds the run's lock from before its first
    # event until after its last. On a full disk the lock is held without its owner's pid.
    return worker(folder) in (str(pid), UNKNOWN)


def _is_alive(pid: int) -> bool:
    if sys.platform == "win32":
        return _is_alive_on_windows(pid)
    try:
        os.kill(pid, 0)  # signal 0 only asks whether the process exists
    except (ProcessLookupError, PermissionError):  # PermissionError: another user's process
        return False
    return True


def _command_line(pid: int) -> bytes | None:
    """The command line of ``pid``, empty for a zombie; None where the system does not report it."""
    try:
        return Path(f"/proc/{pid}/cmdline").read_bytes()  # Linux
    except OSError:
        return None


def kill_process(pid: int) -> None:
    """End ``pid`` and the processes that it started."""
    if sys.platform == "win32":
        command = ["taskkill", "/F", "/T", "/PID", str(pid)]
        subprocess.run(command, capture_output=True, check=False)
        return
    with contextlib.suppress(ProcessLookupError):
        if os.getpgid(pid) == pid:  # :func:`_spawn` made it the leader of its own group
            os.killpg(pid, signal.SIGKILL)
        else:  # a terminal or a script started it, whose group is not ours to end
            os.kill(pid, signal.SIGKILL)


def _is_alive_on_windows(pid: int) -> bool:
    kernel = ctypes.windll.kernel32  # type: ignore[attr-defined]
    handle = kernel.OpenProcess(0x00100000, False, pid)  # SYNCHRONIZE
    if not handle:
        return False
    running = kernel.WaitForSingleObject(handle, 0) == 0x102  # WAIT_TIMEOUT
    kernel.CloseHandle(handle)
    return running


def _spawn(folder: Path, core: Core, log: Any) -> subprocess.Popen[bytes]:
    flags = getattr(subprocess, "CREATE_NO_WINDOW", 0)  # Windows: no console window opens
    # UTF-8 for the log wherever it runs; unbuffered, so that the log is complete after a crash.
    environ = piped_environ() | {"PYTHONUNBUFFERED": "1"} | dict(core.environ)
    until = candidates.read(folder).until
    options = [*core.options, *(["--until", until] if until else [])]
    return subprocess.Popen(
        [str(core.python), "-m", "core", "resume", *options, str(folder.resolve())],
        cwd=core.root,
        env=environ,
        stdin=subprocess.DEVNULL,
        stdout=log,
        stderr=subprocess.STDOUT,
        start_new_session=True,  # Ctrl-C in Blender's terminal is not meant for it
        creationflags=flags,
    )
