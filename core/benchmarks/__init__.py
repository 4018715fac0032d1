"""``run.py bench``: what the parts cost on this machine.

CPU rows are process CPU seconds on one thread, the least of several runs, so that a busy machine
changes them little. Targets are those of docs/performance.md; nothing fails when one is missed.
"""

import importlib
import json
import platform
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import torch

from core.errors import UserError

PARTS = ("render", "geometry", "texture", "guidance")


def least_ms(run: Callable[[], Any], rounds: int = 3) -> float:
    """Process CPU milliseconds of ``run``, the least of ``rounds`` after a first one."""
    run()
    times = []
    for _ in range(rounds):
        start = time.process_time()
        run()
        times.append(time.process_time() - start)
    return 1e3 * min(times)


def row(name: str, value: float, unit: str, target: float | None = None) -> dict[str, Any]:
    """One line of the table; ``target`` is an upper bound, None where there is none."""
    return {"name": name, "value": value, "unit": unit, "target": target}


def bench(names: list[str], out: Path | None = None) -> None:
    """Measure the parts ``names`` (all, if empty), print a table, and write JSON to ``out``."""
    for name in names:
        if name not in PARTS:
            raise UserError(f"There is no benchmark {name!r}.", f"Take {', '.join(PARTS)}.")
    torch.set_num_threads(1)
    rows = []
    for name in names or PARTS:
        for line in importlib.import_module(f"core.benchmarks.bench_{name}").rows():
            rows.append({"part": name} | line)
            print(table_line(rows[-1]), flush=True)
    if out:
        machine = {"processor": platform.processor() or platform.machine(), "threads": 1}
        text = json.dumps({"machine": machine, "rows": rows}, indent=1) + "\n"
        out.write_text(text, encoding="utf-8")


def table_line(line: dict[str, Any]) -> str:
    """A row as text, with its target where it has one."""
    target = "" if line.get("target") is None else f"  (target {line['target']:g})"
    return f"{line['part']:<10} {line['name']:<56} {line['value']:>9.4g} {line['unit']}{target}"
