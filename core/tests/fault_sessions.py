"""Sessions of the core as forks of one process, and what a disturbed run is compared with.

Run it with OMP_NUM_THREADS=1: the order of sums is then the same each time, and a fork is safe.
"""

from __future__ import annotations

import itertools
import os
import random
import shutil
import signal
import struct
import sys
import time
from collections.abc import Callable, Collection
from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple

from core.command_line import main
from core.io.job import LAST, EventWriter, read_events
from core.tests.file_operations import Operations
from core.tests.tiny_runs import FILM, generate, lighten, made, names, quiet, resume


class Moment(NamedTuple):
    """So many CPU seconds after an event of a session, by its number."""

    event: int
    seconds: float


class Task(NamedTuple):
    """What of a walk is to be done."""

    count: int  # 0: all
    seed: int
    done: Collection[int] = ()  # the numbers of what need not be done again
    kind: str = ""  # the one place that is wanted

    @classmethod
    def of(cls, wanted: str, seed: int, done: Collection[int]) -> Task:
        """From an option of the command line: "all", a number or a place."""
        kind = "" if wanted == "all" or wanted.isdigit() else wanted
        return cls(int(wanted) if wanted.isdigit() else 0, seed, done, kind)


@dataclass
class Session:
    """One process of the core, forked from this one."""

    pid: int
    events: int  # the reading end of a pipe: CPU seconds at each event

    @classmethod
    def start(
        cls,
        argv: list[str],
        log: Path,
        before: Callable[[], None] | None = None,
        death: Moment | None = None,
    ) -> Session:
        """Carry out ``argv``; ``before`` is called in it first, and it is killed at ``death``."""
        read, write = os.pipe()
        sys.stdout.flush()
        pid = os.fork()
        if pid:
            os.close(write)
            return cls(pid, read)
        code = 99  # anything that is no sentence
        try:
            file = os.open(log, os.O_WRONLY | os.O_CREAT | os.O_TRUNC)
            os.dup2(file, 1)
            os.dup2(file, 2)
            os.close(read)
            pass_on(write, death)
            if before:
                before()
            code = main(argv)
        except BaseException:
            import traceback

            traceback.print_exc()
        finally:
            sys.stdout.flush()
            sys.stderr.flush()
            os._exit(code)

    def wait_for_event(self, number: int) -> bool:
        """Until the session has written event ``number``, from 0; False where it ended before."""
        return all(os.read(self.events, 8) for _ in range(number + 1))

    def times(self) -> list[float]:
        """CPU seconds at each event, to the end of the session."""
        return [struct.unpack("d", x)[0] for x in iter(lambda: os.read(self.events, 8), b"")]

    def end(self, kill: bool = False) -> int:
        """The exit code; negative is a signal."""
        if kill:
            os.kill(self.pid, signal.SIGKILL)
        status = os.waitpid(self.pid, 0)[1]
        os.close(self.events)
        return os.waitstatus_to_exitcode(status)


def pass_on(pipe: int, death: Moment | None) -> None:
    """Have the time of each event written to ``pipe``, and the process killed at ``death``."""
    write, count = EventWriter.write, itertools.count()

    def then(self: EventWriter, type: str, **fields: object) -> dict:
        event = write(self, type, **fields)
        os.write(pipe, struct.pack("d", time.process_time()))
        if death and next(count) == death.event:
            # By CPU time: the same moment on a busy machine. Nothing handles the signal, so that
            # the system ends the process in the middle of whatever it does, as by SIGKILL.
            signal.setitimer(signal.ITIMER_PROF, death.seconds)
        return event

    EventWriter.write = then


class Faults:
    """An undisturbed run, and what is compared with it."""

    def __init__(self, folder: Path) -> None:
        self.folder, self.log = folder, folder / "log.txt"
        whole = folder / "whole"
        lighten()
        # In this process, so that all is loaded and compiled before the first fork.
        with Operations(whole).watched() as operations, quiet(self.log):
            assert main(generate(whole)) == 0, self.log.read_text()
        self.operations = operations.log
        self.made, self.names = made(whole), names(whole)
        self.stages = [e.get("stage") for e in read_events(whole)]
        session = Session.start(generate(folder / "forked"), self.log)
        self.times = session.times()
        assert session.end() == 0 and made(folder / "forked") == self.made
        assert len(self.times) == len(self.stages), (self.times, self.stages)

    def session(self, argv: list[str], before: Callable[[], None] | None = None) -> int:
        """The exit code of a session that nobody disturbs from outside."""
        return Session.start(argv, self.log, before).end()

    def moments(self, stage: str) -> list[int]:
        """The numbers of the events after which ``stage`` is at work."""
        if stage == "start":
            return [0]
        found = [i for i, at in enumerate(self.stages) if at == stage]
        if stage == "asset":
            return [max(i for i, at in enumerate(self.stages) if at == "bake")]
        return [min(found) - 1, *found[:-1]]

    def killed(self, run: Path, stage: str, dice: random.Random) -> str:
        """Kill a run once or twice at random moments; where it was."""
        event = dice.choice(self.moments(stage))
        gap = self.times[event + 1] - self.times[event]
        output = f"{stage}, event {event}"
        while self._kill(generate(run), Moment(event, dice.uniform(1e-3, gap))) >= 0:
            shutil.rmtree(run)  # it was done before: quicker than the run of the times
            gap *= 0.7
        if dice.random() < 0.25:
            event = dice.randrange(4)
            ended = self._kill(resume(run), Moment(event, dice.uniform(1e-3, gap))) >= 0
            output += f"; again, event {event}" + (", had ended" if ended else "")
        return output

    def _kill(self, argv: list[str], death: Moment) -> int:
        """The exit code of a session that ends at ``death``; negative is a signal."""
        session = Session.start(argv, self.log, death=death)
        session.times()
        return session.end()

    def wrong(self, run: Path, again: bool = True) -> str:
        """Resume ``run`` unless it has ended; what differs from the undisturbed one."""
        code = self.session(resume(run)) if again else 0
        if code:
            return f"resume exits with {code}: {self.log.read_text()[-600:]}"
        got = made(run)
        differ = [name for name in self.made if got.get(name) != self.made[name]]
        if differ or not again:
            return f"other bytes: {', '.join(differ)}" if differ else ""
        # A film's frames are named by their time, and a disturbed run has other ones.
        spare = {name for name in names(run) ^ self.names if not name.startswith(FILM)}
        ends = [e["type"] for e in read_events(run) if e["type"] in LAST]
        if spare or ends[-1:] != ["done"]:
            return f"left over or missing: {sorted(spare)}, {ends}"
        return ""


def unfit(code: int, output: str) -> str:
    """Why an answer to a failing disk is none: no sentence, or another exit code."""
    if code == 0 and "Traceback" not in output:
        return ""
    last = output.strip().splitlines()[-1:]
    if code != 2 or "Traceback" in output or not last or not last[0].startswith("error: "):
        return f"exit code {code}: {output[-600:]}"
    return ""
