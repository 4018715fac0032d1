"""One process of the core on one run folder: ``core resume RUN``, watched until it ends.

The same here and on another machine's node. The process holds the run's lock, and ends when the
one that started it does: its standard input is a pipe that only its starter holds open.
"""

import os
import signal
import subprocess
import sys
import time
from collections.abc import Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

from core.batch.options import OUT_OF_TIME
from core.errors import UserError
from core.io.job import LAST, read_events

ROOT = Path(__file__).parents[2]  # the folder that holds the package ``core``
COMMAND = (sys.executable, "-m", "core", "resume", "--end-with-stdin")  # and the run folder
SENTENCES = (2, 3, 4, 5)  # exit codes that come with one
GRACE = 20.0  # seconds between a request to stop and the end by force
# More threads than one only wait for each other where every core has an asset of its own.
THREADS = {"OMP_NUM_THREADS": "1", "NUMBA_NUM_THREADS": "1"}


@dataclass(frozen=True)
class End:
    """How an attempt ended."""

    code: int  # an exit code; negative: a signal; OUT_OF_TIME
    text: str  # one sentence where it failed
    seconds: float
    node: str = ""  # the machine's address, of a cluster


class Attempt:
    """A running process of the core; :meth:`poll` never blocks."""

    def __init__(
        self,
        folder: Path,
        command: Sequence[str] = COMMAND,
        timeout: float | None = None,
        environ: Mapping[str, str] = THREADS,
    ) -> None:
        self.folder = folder
        self._timeout, self._start = timeout, time.monotonic()
        self._stop_at: float | None = None  # when it ends by force
        self._is_late = False
        (folder / "cancel").unlink(missing_ok=True)  # meant for an earlier session
        # The log is UTF-8, whatever the terminal takes.
        more = {"PYTHONUNBUFFERED": "1", "PYTHONUTF8": "1", "PYTHONIOENCODING": "utf-8"}
        with (folder / "log.txt").open("ab") as log:
            self._process = subprocess.Popen(
                [*command, str(folder.resolve())],
                cwd=ROOT,
                env={**os.environ, **more, **environ},
                stdin=subprocess.PIPE,
                stdout=log,
                stderr=subprocess.STDOUT,
                start_new_session=True,  # Ctrl-C in the terminal is meant for the batch
            )

    @property
    def seconds(self) -> float:
        """Since its start."""
        return time.monotonic() - self._start

    def poll(self) -> End | None:
        """How it ended; None while it runs. Past its time it is asked to stop, then made to."""
        code = self._process.poll()
        if code is not None:
            return self._end(code)
        if self._timeout is not None and self.seconds > self._timeout and not self._is_late:
            self._is_late = True
            self.stop()
        if self._stop_at is not None and time.monotonic() > self._stop_at:
            self.kill()
        return None

    def stop(self) -> None:
        """Ask it to stop after its present step; the run folder resumes."""
        if self._stop_at is None:
            self._stop_at = time.monotonic() + GRACE
            with suppress(OSError):  # a full disk: it ends by force
                (self.folder / "cancel").touch()

    def kill(self) -> None:
        """End it at once, with what it started; the run resumes from its last checkpoint."""
        with suppress(ProcessLookupError):
            if os.name == "posix":
                os.killpg(self._process.pid, signal.SIGKILL)  # the leader of its own group
            else:
                self._process.kill()

    def close(self) -> None:
        """End it, if it still runs, and leave nothing of it open."""
        if self._process.poll() is None:
            self.kill()
        self._process.wait()
        if self._process.stdin:
            self._process.stdin.close()

    def _end(self, code: int) -> End:
        self.close()
        if self._is_late and code:
            text = f"It took longer than --timeout {self._timeout:g}. Call again to continue it."
            return End(OUT_OF_TIME, text, self.seconds)
        return End(code, "" if code == 0 else cause(self.folder, code), self.seconds)


def cause(folder: Path, code: int) -> str:
    """Why the core's process ended with ``code``: its own sentence, else what the code means."""
    if code in SENTENCES and (reported := _last_error(folder / "log.txt")):
        return reported
    ends = [event for event in _events(folder) if event.get("type") in (*LAST, "started")]
    last = ends[-1] if ends else {}
    if last.get("type") in ("error", "cancelled"):
        return f"{last.get('text', '')} {last.get('fix') or ''}".strip()
    how = f"signal {-code}" if code < 0 else f"exit code {code}"
    more = " The system may have run out of memory." if code == -9 else ""
    return f"Its process ended with {how} and reported nothing.{more} Read {folder / 'log.txt'}."


def _last_error(log: Path) -> str:
    """The sentence for the command line, which the last event has in the panel's words."""
    try:
        lines = log.read_text(encoding="utf-8", errors="replace").splitlines()
    except OSError:
        return ""
    return next((line[7:] for line in reversed(lines[-20:]) if line.startswith("error: ")), "")


def _events(folder: Path) -> list[dict]:
    try:
        return read_events(folder)
    except (UserError, OSError):
        return []
