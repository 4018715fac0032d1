"""Kills and failing files, walked in one process that has the method loaded.

    python -m core.tests.fault_runs --kills 50 --kills-at-files all --failures all --places all

It prints one JSON object a line: what was done to a run, and what was wrong after it ("" where
nothing was). With ``--log FILE`` the lines are added to FILE, and what is recorded there is not
done again: a long walk may be cut off and started again (only the random kills start again). A
session of the core is a fork of this process, so that none of them loads torch. Run it with
OMP_NUM_THREADS=1: the order of sums is then the same each time, and a fork is safe.
"""

from __future__ import annotations

import argparse
import errno
import json
import os
import random
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

from core.tests.fault_places import PLACES, places
from core.tests.fault_sessions import Faults, Task, unfit
from core.tests.file_operations import Operations
from core.tests.tiny_runs import STAGES, generate


def kills(faults: Faults, task: Task) -> Iterator[dict]:
    """Runs killed at random moments, every stage in its turn."""
    dice = random.Random(task.seed)
    for i in range(task.count):
        run = faults.folder / f"killed {i}"
        where = faults.killed(run, STAGES[i % len(STAGES)], dice)
        yield {"killed": where, "wrong": faults.wrong(run)}
        shutil.rmtree(run, ignore_errors=True)


def chosen(operations: list[str], task: Task) -> list[int]:
    """The numbers of all operations, or of so many: each kind and file once, then the others; in a
    random order, so that few are not the run's first ones."""
    numbers = list(range(len(operations)))
    random.Random(task.seed).shuffle(numbers)
    kept = {operations[i]: i for i in numbers}.values()
    order = [*kept, *(i for i in numbers if i not in kept)]
    return [i for i in order[: task.count or None] if i not in task.done]


def kills_at_files(faults: Faults, task: Task) -> Iterator[dict]:
    """Runs killed just before an operation on a file, each operation in its turn.

    Such a kill leaves the folder as it is then, without what the process holds in its buffers. So
    one session copies its folder before each operation, and each copy is resumed.
    """
    numbers, copies = chosen(faults.operations, task), faults.folder / "copies"
    if not numbers:
        return
    copies.mkdir()
    run = faults.folder / "copied"

    def before() -> None:
        wanted = set(numbers)

        def copy(_: str) -> None:
            if (i := len(operations.log) - 1) in wanted:
                # In a process of its own, whose operations are not counted.
                command = ["cp", "-a", str(run), str(copies / str(i))]
                subprocess.run(command, check=run.exists(), stderr=subprocess.DEVNULL)

        operations = Operations(run, last=copy)
        operations.watch()

    code = faults.session(generate(run), before)
    for i in numbers:
        copied = copies / str(i)
        fit = code == 0 and (copied.exists() or i == 0)  # the first makes the folder
        wrong = faults.wrong(copied) if fit else f"no copy; the session ended with {code}"
        yield {"number": i, "killed": f"before {faults.operations[i]}", "wrong": wrong}
        shutil.rmtree(copied, ignore_errors=True)


def failures(faults: Faults, task: Task) -> Iterator[dict]:
    """Runs in which one operation on a file fails, each operation in its turn."""
    for i in chosen(faults.operations, task):
        number = (errno.ENOSPC, errno.EACCES)[(i + task.seed) % 2]
        run = faults.folder / f"failed at {i}"

        def before(run: Path = run, i: int = i, number: int = number) -> None:
            Operations(run, i, number).watch()

        code = faults.session(generate(run), before)
        output = faults.log.read_text().strip().splitlines()[-1:]
        yield {
            "number": i,
            "failed": f"{errno.errorcode[number]} at {faults.operations[i]}",
            "code": code,
            "output": "".join(output) if code else "",
            "wrong": unfit(code, faults.log.read_text()) or faults.wrong(run),
        }
        shutil.rmtree(run, ignore_errors=True)


WALKS = {
    "kills": kills, "kills-at-files": kills_at_files, "failures": failures, "places": places,
}  # fmt: skip


def walk(argv: list[str]) -> None:
    """Carry out the command line above."""
    parser = argparse.ArgumentParser(description=__doc__)
    for name in WALKS:
        kinds = f", {', '.join(PLACES)}" if name == "places" else ""
        parser.add_argument(f"--{name}", metavar="COUNT", help=f"or all{kinds}")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--log", type=Path, default=Path(os.devnull))
    args = parser.parse_args(argv)
    rows = [json.loads(line) for line in lines_of(args.log)]
    with tempfile.TemporaryDirectory() as folder, args.log.open("a", encoding="utf-8") as log:
        faults = Faults(Path(folder))
        same = {"seed": args.seed, "of": len(faults.operations)}
        for name, do in WALKS.items():
            if not (wanted := getattr(args, name.replace("-", "_"))):
                continue
            if not wanted.isdigit() and wanted not in ("all", *(PLACES if do is places else ())):
                parser.error(f"--{name} {wanted}: neither all nor a number")
            named = {"walk": name, **same}
            done = {row.get("number") for row in rows if named.items() <= row.items()}
            for result in do(faults, Task.of(wanted, args.seed, done)):
                line = json.dumps({**named, **result}, ensure_ascii=False)
                print(line, flush=True)
                print(line, file=log, flush=True)


def lines_of(log: Path) -> list[str]:
    """The lines of earlier walks."""
    return log.read_text(encoding="utf-8").splitlines() if log.exists() else []


if __name__ == "__main__":
    walk(sys.argv[1:])
