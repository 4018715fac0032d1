"""``run.py bench``: what the parts cost on this machine.

CPU rows are process CPU seconds on one thread, the least of several runs, so that a busy machine
changes them little. Targets are those of docs/performance.md; nothing fails when one is missed.
"""

import importlib
import json
import math
import os
import platform
import re
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import torch
from torch import Tensor

from core.errors import UserError
from core.io.job import write_text
from core.io.json_file import read_object

LONG = 20.0  # s, compared with which the first run's extra work is small
PARTS = ("render", "gradients", "geometry", "texture", "guidance", "gpu")


def least_ms(run: Callable[[], Any], rounds: int = 3) -> float:
    """Process CPU milliseconds of ``run``, the least of ``rounds`` after a first one."""
    run()
    times = []
    for _ in range(rounds):
        start = time.process_time()
        run()
        times.append(time.process_time() - start)
    return 1e3 * min(times)


def wall_ms(run: Callable[[], object], device: torch.device, rounds: int = 5) -> float:
    """Wall milliseconds of ``run`` until the device has done it, the least of ``rounds`` after a
    first one; or that one's, if it takes longer than ``LONG``."""
    times: list[float] = []
    while len(times) <= rounds and not (times and times[0] > LONG):
        start = time.perf_counter()
        run()
        if device.type == "cuda":
            torch.cuda.synchronize(device)
        times.append(time.perf_counter() - start)
    return 1e3 * min(times[1:] or times)


def row(
    name: str, value: float, unit: str, target: float | None = None, at_least: bool = False
) -> dict[str, Any]:
    """One line of the table.

    ``target``: the value wanted at most (``at_least``: at least); None where nothing is.
    """
    return {"name": name, "value": value, "unit": unit, "target": target, "at_least": at_least}


def machine() -> str:
    """This machine in words."""
    name = platform.processor() or platform.machine()
    if (info := Path("/proc/cpuinfo")).exists():
        models = re.findall(r"^model name\s*:\s*(.+)$", info.read_text(), re.MULTILINE)
        name = models[0] if models else name
    device = torch.cuda.get_device_name() if torch.cuda.is_available() else "no CUDA device"
    return (
        f"{name}, {os.cpu_count()} cores, {device}; Python {platform.python_version()}, "
        f"torch {torch.__version__}"
    )


def ball(faces: int, bump: float = 0.05) -> tuple[Tensor, Tensor]:
    """A closed ball of about this number of faces, with waves of relative height ``bump``."""
    n = round(math.sqrt(faces / 2))
    theta = torch.arange(1, n) * (math.pi / n)
    phi = torch.arange(n) * (2 * math.pi / n)
    theta, phi = (x.reshape(-1) for x in torch.meshgrid(theta, phi, indexing="ij"))
    d = torch.stack([theta.sin() * phi.cos(), theta.sin() * phi.sin(), theta.cos()], -1)
    d = torch.cat([d, d.new_tensor([[0, 0, 1], [0, 0, -1]])])
    verts = 0.75 * d * (1 + bump * torch.sin(9 * d).sum(1, keepdim=True))
    ring = torch.arange(n)
    after = (ring + 1) % n
    top = torch.stack([torch.full_like(ring, len(d) - 2), ring, after], 1)
    last = (n - 2) * n
    end = torch.stack([torch.full_like(ring, len(d) - 1), last + after, last + ring], 1)
    start = torch.arange(n - 2)[:, None] * n
    a, b = (start + ring).reshape(-1), (start + after).reshape(-1)
    c, e = a + n, b + n
    return verts, torch.cat([top, torch.stack([a, c, e], 1), torch.stack([a, e, b], 1), end])


def keep_settings(folder: Path, settings: dict[str, Any]) -> None:
    """Remember what the scores in ``folder`` are made with: what is there is not made again.

    Raises:
        UserError: those that are there were made with other settings.
    """
    path = folder / "settings.json"
    if path.exists() and read_object(path, "Name another --out.") != settings:
        raise UserError(f"{folder} holds scores of other settings.", "Name another --out.")
    folder.mkdir(parents=True, exist_ok=True)
    write_text(path, json.dumps(settings) + "\n")


def bench(names: list[str], out: Path | None = None) -> None:
    """Measure the parts ``names`` (all, if empty), print a table, and write JSON to ``out``."""
    for name in names:
        if name not in PARTS:
            raise UserError(f"There is no benchmark {name!r}.", f"Use one of {', '.join(PARTS)}.")
    torch.set_num_threads(1)
    rows = []
    for name in names or PARTS:
        found = importlib.import_module(f"core.benchmarks.bench_{name}").rows()
        if not found:
            print(f"{name:<10} nothing to measure: this machine has no CUDA device")
        for line in found:
            rows.append({"part": name} | line)
            print(table_line(rows[-1]), flush=True)
    if out:
        text = json.dumps({"machine": machine(), "rows": rows}, indent=1) + "\n"
        out.write_text(text, encoding="utf-8")


def table_line(line: dict[str, Any]) -> str:
    """A row as text, with its target where it has one."""
    bound = "at least" if line["at_least"] else "at most"
    target = "" if line["target"] is None else f"  ({bound} {line['target']:g})"
    return f"{line['part']:<10} {line['name']:<56} {line['value']:>9.4g} {line['unit']}{target}"
