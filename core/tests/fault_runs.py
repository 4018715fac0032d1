"""Kills and failing files, walked in one process that has the method loaded.

    python -m core.tests.fault_runs --kills 50 --kills-at-files all --failures all --places all

It prints one JSON object a line: what was done to a run, and what was wrong after it ("" where
nothing was). A session of the core is a fork of this process, so that none of them loads torch.
Run it with OMP_NUM_THREADS=1: the order of sums is then the same each time, and a fork is safe.
"""

from __future__ import annotations

import argparse
import contextlib
import errno
import itertools
import json
import os
import random
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

import core.appearance.environment as environment
import core.generate as method
from core.command_line import main
from core.guidance.builtin import guidance as builtin
from core.io import progress
from core.io.job import LAST, EventWriter, read_events
from core.stages import training
from core.tests.file_operations import Operations
from core.texture import packing

# Every stage and every phase, each with as few steps as it has a middle with.
FILM = "preview/film"
TINY = {
    "geometry.resolution": "10,12",
    "geometry.fit_steps": 20,
    "geometry.views": 1,
    "geometry.views_at_once": 1,
    "geometry.coarse.steps": 3,
    "geometry.fine.steps": 2,
    "geometry.sharpen.rounds": 1,
    "geometry.sharpen.passes": 1,
    "geometry.sharpen.views": 2,
    "geometry.sharpen.steps": 2,
    "geometry.sharpen.size": 32,
    **{f"geometry.{phase}.rounds": 1 for phase in ("grow", "refine")},
    **{f"geometry.{phase}.steps": 2 for phase in ("grow", "refine")},
    **{f"geometry.{phase}.views": 2 for phase in ("grow", "refine")},
    **{f"geometry.{phase}.denoise_steps": 1 for phase in ("grow", "refine")},
    "appearance.shading": "split_sum",
    "appearance.views": 1,
    **{f"appearance.{phase}.size": 32 for phase in ("early", "late", "refine")},
    "appearance.early.steps": 3,
    "appearance.late.steps": 2,
    "appearance.refine.rounds": 1,
    "appearance.refine.steps": 2,
    "appearance.refine.views": 2,
    "appearance.refine.denoise_steps": 1,
}
OPTIONS = [f"--set={key}={value}" for key, value in TINY.items()]
OPTIONS += ["--texture-size=64", "--max-faces=100"]
STAGES = ("start", "fit", "geometry", "unwrap", "appearance", "bake", "asset")
PASSES = 10  # of the packing, which would be half of so short a run
PATIENCE = 120.0  # seconds after which a session hangs


def generate(run: Path) -> list[str]:
    """The command line of a new run."""
    return ["generate", "a red torus", "--out", str(run), *OPTIONS]


def resume(run: Path) -> list[str]:
    """The command line that ends it: as a new run where it has not come to its job.json."""
    return ["resume", str(run)] if (run / "job.json").exists() else generate(run)


def made(run: Path) -> dict[str, bytes]:
    """The asset's files. The seconds of each stage are another matter in each run."""
    files = {path.name: path.read_bytes() for path in sorted((run / "asset").iterdir())}
    info = json.loads(files["asset.json"])
    del info["timings"]
    return files | {"asset.json": json.dumps(info).encode()}


def names(run: Path) -> set[str]:
    """All that lies in a run folder; there is a log only where a bug was met."""
    return {path.relative_to(run).as_posix() for path in run.rglob("*")}


def lighten() -> None:
    """Do what has no part in a fault once, and let every event and checkpoint be written."""
    packing.PASSES = PASSES
    progress.PROGRESS_SECONDS = progress.PROGRESS_SHARE = 0.0
    training.CHECKPOINT_SECONDS = 0.0
    training.PREVIEW_SECONDS = 1e9  # the first alone: their number would be by the machine's load
    method.PREVIEW_SIZE = 64
    builtin.load_weights = remembered(builtin.load_weights)
    light = remembered(environment.Environment.of.__func__)
    environment.Environment.of = classmethod(light)
    packing.pack = remembered(packing.pack)


def remembered(function: Callable) -> Callable:
    """``function``, whose results serve again for the same arguments."""
    found: dict[tuple, object] = {}

    def again(*args: Any) -> object:
        # The last argument of the packing only reports how far it is.
        given = [x for x in args if not callable(x)]
        key = tuple(np.asarray(x).tobytes() if hasattr(x, "__array__") else x for x in given)
        if key not in found:
            found[key] = function(*args)
        return found[key]

    return again


class Moment(NamedTuple):
    """So many CPU seconds after an event of a session, by its number."""

    event: int
    seconds: float


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
            told(write, death)
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


def told(pipe: int, death: Moment | None) -> None:
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
        said = f"{stage}, event {event}"
        while self._kill(generate(run), Moment(event, dice.uniform(1e-3, gap))) >= 0:
            shutil.rmtree(run)  # it was done before: quicker than the run of the times
            gap *= 0.7
        if dice.random() < 0.25:
            event = dice.randrange(4)
            ended = self._kill(resume(run), Moment(event, dice.uniform(1e-3, gap))) >= 0
            said += f"; again, event {event}" + (", had ended" if ended else "")
        return said

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


class quiet:  # noqa: N801
    """What is printed goes to a file."""

    def __init__(self, log: Path) -> None:
        self.log = log

    def __enter__(self) -> None:
        sys.stdout.flush()
        sys.stderr.flush()
        self.kept = os.dup(1), os.dup(2)
        file = os.open(self.log, os.O_WRONLY | os.O_CREAT | os.O_TRUNC)
        os.dup2(file, 1)
        os.dup2(file, 2)
        os.close(file)

    def __exit__(self, *_: object) -> None:
        sys.stdout.flush()
        sys.stderr.flush()
        for number, kept in enumerate(self.kept, 1):
            os.dup2(kept, number)
            os.close(kept)


def kills(faults: Faults, count: int, seed: int) -> Iterator[dict]:
    """``count`` runs killed at random moments, every stage in its turn."""
    dice = random.Random(seed)
    for i in range(count):
        run = faults.folder / f"killed {i}"
        where = faults.killed(run, STAGES[i % len(STAGES)], dice)
        yield {"killed": where, "wrong": faults.wrong(run)}
        shutil.rmtree(run, ignore_errors=True)


def chosen(operations: list[str], count: int, seed: int) -> list[int]:
    """The numbers of all operations, or of ``count`` of them: no kind and file twice if it can."""
    if not count:
        return list(range(len(operations)))
    numbers = list(range(len(operations)))
    random.Random(seed).shuffle(numbers)
    first = {operations[i]: i for i in numbers}
    kept = set(first.values())
    return sorted([*kept, *(i for i in numbers if i not in kept)][:count])


def kills_at_files(faults: Faults, count: int, seed: int) -> Iterator[dict]:
    """Runs killed just before an operation on a file, each operation in its turn."""
    for i in chosen(faults.operations, count, seed):
        run = faults.folder / f"killed at {i}"

        def before(run: Path = run, i: int = i) -> None:
            def die(_: str) -> None:
                if len(operations.log) - 1 == i:
                    os.kill(os.getpid(), signal.SIGKILL)

            operations = Operations(run, last=die)
            operations.watch()

        code = faults.session(generate(run), before)
        wrong = faults.wrong(run) if code == -signal.SIGKILL else f"it ended with {code}"
        yield {"killed": f"before {faults.operations[i]}", "wrong": wrong}
        shutil.rmtree(run, ignore_errors=True)


def failures(faults: Faults, count: int, seed: int) -> Iterator[dict]:
    """Runs of which one operation on a file fails, each operation in its turn."""
    for i in chosen(faults.operations, count, seed):
        number = (errno.ENOSPC, errno.EACCES)[(i + seed) % 2]
        run = faults.folder / f"failed at {i}"

        def before(run: Path = run, i: int = i, number: int = number) -> None:
            Operations(run, i, number).watch()

        code = faults.session(generate(run), before)
        said = faults.log.read_text().strip().splitlines()[-1:]
        yield {
            "failed": f"{errno.errorcode[number]} at {faults.operations[i]}",
            "code": code,
            "said": "".join(said) if code else "",
            "wrong": unfit(code, faults.log.read_text()) or faults.wrong(run),
        }
        shutil.rmtree(run, ignore_errors=True)


def unfit(code: int, said: str) -> str:
    """Why an answer to a failing disk is none: no sentence, or another exit code."""
    if code == 0 and "Traceback" not in said:
        return ""
    last = said.strip().splitlines()[-1:]
    if code != 2 or "Traceback" in said or not last or not last[0].startswith("error: "):
        return f"exit code {code}: {said[-600:]}"
    return ""


def places(faults: Faults, count: int, seed: int) -> Iterator[dict]:
    """Runs whose folder is removed, replaced by a file, made read-only, or on a disk that fills.

    Each place at a moment of each stage; the last two want a user who may mount.
    """
    dice = random.Random(seed)
    both = [(place, stage) for place in PLACES for stage in STAGES]
    for place, stage in both if not count else dice.sample(both, count):
        disk = faults.folder / f"{place} {stage}"
        disk.mkdir()
        with contextlib.ExitStack() as stack:
            if place in ("full", "read-only") and not mounted(disk, stack):
                continue
            yield {"place": f"{place}, {stage}", **_misplaced(faults, disk, place, stage, dice)}


PLACES = ("removed", "a file", "read-only", "full")
DISK = "size=32m"  # far more than a run takes


def mounted(disk: Path, stack: contextlib.ExitStack) -> bool:
    """Whether ``disk`` is a file system of its own now, until the end of ``stack``."""
    mount = ["mount", "-t", "tmpfs", "-o", DISK, "tmpfs", str(disk)]
    if sys.platform != "linux" or subprocess.run(mount, capture_output=True).returncode:
        return False
    stack.callback(subprocess.run, ["umount", "-l", str(disk)], check=True)
    return True


def remount(disk: Path, option: str) -> None:
    """Change the file system at ``disk``."""
    subprocess.run(["mount", "-o", f"remount,{option}", str(disk)], check=True)


def _misplaced(
    faults: Faults, disk: Path, place: str, stage: str, dice: random.Random
) -> dict[str, object]:
    """A run that ``place`` happens to in ``stage``; what it answers, and how it ends after all."""
    run, other = disk / "run", disk / "the user's.txt"
    other.write_text("precious")
    session = Session.start(generate(run), faults.log)
    session.wait_for_event(dice.choice(faults.moments(stage)))
    os.kill(session.pid, signal.SIGSTOP)  # else it writes meanwhile
    os.waitpid(session.pid, os.WUNTRACED)
    _spoil(run, place)
    os.kill(session.pid, signal.SIGCONT)
    code = session.end()
    said = faults.log.read_text()
    if place in ("full", "read-only"):
        remount(disk, "size=64m" if place == "full" else "rw")
    elif code:
        shutil.rmtree(run) if run.is_dir() else run.unlink(missing_ok=True)
    wrong = unfit(code, said) or faults.wrong(run, again=code != 0)
    if other.read_text() != "precious":
        wrong = "the user's file is another"
    return {"code": code, "said": said.strip().splitlines()[-1] if code else "", "wrong": wrong}


def _spoil(run: Path, place: str) -> None:
    if place == "full":
        free = os.statvfs(run).f_bavail * os.statvfs(run).f_frsize
        with (run.parent / "the user's too").open("wb") as file:
            file.write(bytes(free - 8192))
        with contextlib.suppress(OSError), (run.parent / "rest").open("wb", 0) as file:
            while True:
                file.write(bytes(4096))
    elif place == "read-only":
        remount(run.parent, "ro")
    else:
        shutil.rmtree(run)
        if place == "a file":
            run.write_text("of the user's")


WALKS = {
    "kills": kills, "kills-at-files": kills_at_files, "failures": failures, "places": places,
}  # fmt: skip


def walk(argv: list[str]) -> None:
    """Carry out the command line above."""
    parser = argparse.ArgumentParser(description=__doc__)
    for name in WALKS:
        parser.add_argument(f"--{name}", metavar="COUNT", help="or all")
    parser.add_argument("--seed", type=int, default=0)
    args = vars(parser.parse_args(argv))
    with tempfile.TemporaryDirectory() as folder:
        faults = Faults(Path(folder))
        for name, do in WALKS.items():
            count = args[name.replace("-", "_")]
            for result in (
                do(faults, 0 if count == "all" else int(count), args["seed"]) if count else ()
            ):
                print(json.dumps({"walk": name, **result}, ensure_ascii=False), flush=True)


if __name__ == "__main__":
    walk(sys.argv[1:])
