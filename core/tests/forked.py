"""Sessions of the core as forks of one process that has the method loaded.

A process of its own costs 3 CPU seconds before its first step, torch and the core; then one for its
weights and its light (``warm.py``). Tests of loading itself start one (``python -m core``).
"""

import multiprocessing
import os
import signal
import sys
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from multiprocessing.context import BaseContext
from multiprocessing.process import BaseProcess
from pathlib import Path
from unittest import mock

from core import command_line
from core.interrupt import process_began

# The order of sums is the same each time with one thread, and a fork is safe.
ONE_THREAD = dict.fromkeys(("OMP_NUM_THREADS", "MKL_NUM_THREADS", "NUMBA_NUM_THREADS"), "1")
LOADED = ["core.tests.forked", "core.generate", "pytest", "core.tests.warm"]
WAIT_SECONDS = 600.0  # for a short run, on a busy machine


@dataclass
class Session:
    """A command of the core that is being carried out."""

    process: BaseProcess
    log: Path  # what it prints

    @classmethod
    def start(cls, argv: Sequence[object], log: Path, before: str = "") -> "Session":
        """Carry out a command line; ``before`` is Python to run first, in the same process."""
        words = [*map(str, argv)]
        process = _server().Process(target=_carry_out, args=(words, str(log), before))
        process.start()
        return cls(process, log)

    def kill(self) -> None:
        """End it at once, as the system does when memory is short."""
        self.process.kill()
        self.process.join(WAIT_SECONDS)

    def interrupt(self) -> None:
        """Ctrl-C."""
        os.kill(self.process.pid or 0, signal.SIGINT)

    def finished(self) -> tuple[int, str]:
        """Its exit code, negative for a signal, and what it printed."""
        self.process.join(WAIT_SECONDS)
        code = self.process.exitcode
        if code is None:
            self.kill()
            raise TimeoutError(f"a session took more than {WAIT_SECONDS:.0f} s")
        return code, self.log.read_text(encoding="utf-8")


@cache
def _server() -> BaseContext:
    """Where forks come from; where there are none (Windows), each session loads all by itself."""
    forks = "forkserver" in multiprocessing.get_all_start_methods()
    context = multiprocessing.get_context("forkserver" if forks else "spawn")
    if forks:
        from multiprocessing.forkserver import ensure_running

        context.set_forkserver_preload(LOADED)
        with mock.patch.dict(os.environ, ONE_THREAD):
            ensure_running()
    return context


def _carry_out(argv: list[str], log: str, before: str) -> None:
    file = os.open(log, os.O_WRONLY | os.O_CREAT | os.O_TRUNC)
    os.dup2(file, 1)
    os.dup2(file, 2)
    command_line.START = process_began()  # the fork's, not the server's
    exec(before, {})
    sys.exit(command_line.main(argv))
