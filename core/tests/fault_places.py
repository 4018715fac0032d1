"""Runs whose folder is removed, replaced, made read-only, or on a disk that fills."""

from __future__ import annotations

import contextlib
import os
import random
import shutil
import signal
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

from core.tests.fault_sessions import Faults, Session, Task, unfit
from core.tests.permissions import permissions_count
from core.tests.tiny_runs import STAGES, generate

PLACES = ("removed", "a file", "read-only", "full")
DISK = "size=32m"  # far more than a run takes


def places(faults: Faults, task: Task) -> Iterator[dict]:
    """Runs whose folder is removed, replaced by a file, made read-only, or on a disk that fills.

    Each place at a moment of each stage; the last one wants a user who may mount.
    """
    both = [(place, stage) for place in PLACES for stage in STAGES]
    for i in chosen_places(task):
        place, stage = both[i]
        disk, dice = faults.folder / f"{place} {stage}", random.Random(f"{task.seed} {i}")
        disk.mkdir()
        with contextlib.ExitStack() as stack:
            if place == "full" and not mounted(disk, stack):
                continue
            result = _misplaced(faults, disk, place, stage, dice)
            yield {"number": i, "place": f"{place}, {stage}", **result}


def chosen_places(task: Task) -> list[int]:
    """The numbers of all places and stages, of so many, or of one place in each stage."""
    numbers = list(range(len(PLACES) * len(STAGES)))
    if task.kind:
        numbers = numbers[PLACES.index(task.kind) * len(STAGES) :][: len(STAGES)]
    elif task.count:
        numbers = random.Random(task.seed).sample(numbers, task.count)
    return [i for i in numbers if i not in task.done]


def mounted(disk: Path, stack: contextlib.ExitStack) -> bool:
    """Whether ``disk`` is a file system of its own now, until the end of ``stack``."""
    mount = ["mount", "-t", "tmpfs", "-o", DISK, "tmpfs", str(disk)]
    if sys.platform != "linux" or subprocess.run(mount, capture_output=True).returncode:
        return False
    stack.callback(subprocess.run, ["umount", "-l", str(disk)], check=True)
    return True


def permit(run: Path, write: int) -> None:
    """Give or take the owner's right to write to a run folder and all that is in it."""
    for path in (run, *run.rglob("*")):
        path.chmod(path.stat().st_mode & ~0o222 | write)


def remount(disk: Path, option: str) -> None:
    """Change the file system at ``disk``."""
    subprocess.run(["mount", "-o", f"remount,{option}", str(disk)], check=True)


def _misplaced(
    faults: Faults, disk: Path, place: str, stage: str, dice: random.Random
) -> dict[str, object]:
    """A run that ``place`` happens to in ``stage``; what it answers, and how it ends after all."""
    run, other = disk / "run", disk / "the user's.txt"
    other.write_text("precious")
    ordinary = permissions_count()
    # In the session alone: root would write to a folder that is read-only.
    session = Session.start(generate(run), faults.log, lambda: ordinary.__enter__() and None)
    session.wait_for_event(dice.choice(faults.moments(stage)))
    os.kill(session.pid, signal.SIGSTOP)  # else it writes meanwhile
    os.waitpid(session.pid, os.WUNTRACED)
    _spoil(run, place)
    os.kill(session.pid, signal.SIGCONT)
    code = session.end()
    output = faults.log.read_text()
    if place == "full":
        remount(disk, "size=64m")
    elif place == "read-only":
        permit(run, 0o200)
    elif code:
        shutil.rmtree(run) if run.is_dir() else run.unlink(missing_ok=True)
    wrong = unfit(code, output) or faults.wrong(run, again=code != 0)
    if other.read_text() != "precious":
        wrong = "the user's file is another"
    return {"code": code, "output": output.strip().splitlines()[-1] if code else "", "wrong": wrong}


def _spoil(run: Path, place: str) -> None:
    if place == "full":
        free = os.statvfs(run).f_bavail * os.statvfs(run).f_frsize
        with (run.parent / "the user's too").open("wb") as file:
            file.write(bytes(free - 8192))
        with contextlib.suppress(OSError), (run.parent / "rest").open("wb", 0) as file:
            while True:
                file.write(bytes(4096))
    elif place == "read-only":  # a disk is not, while a file of it is open for writing
        permit(run, 0)
    else:
        shutil.rmtree(run)
        if place == "a file":
            run.write_text("of the user's")
