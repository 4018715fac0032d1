"""Kills and failing files, walked in one process that has the method loaded.

    python -m core.tests.fault_runs --kills 50 --kills-at-files all --failures all --places all

It prints one JSON object a line: what was done to a run, and what was wrong after it ("" where
nothing was). A session of the core is a fork of this process, so that none of them loads torch.
Run it with OMP_NUM_THREADS=1: the order of sums is then the same each time, and a fork is safe.
"""

from __future__ import annotations

import argparse
import errno
import json
import os
import random
import shutil
import signal
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

from core.tests.fault_places import places
from core.tests.fault_sessions import Faults, unfit
from core.tests.file_operations import Operations
from core.tests.tiny_runs import STAGES, generate


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
