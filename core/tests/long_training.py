"""Many short steps of one training, with the run's files written far oftener than in use.

    python -m core.tests.long_training 10000

One JSON object a line, each twentieth of the way: what the process and its run folder hold. The
network is small, so that steps are quick; the loop, the guard, the progress, the events, the
checkpoints and the previews are those of every training.
"""

import gc
import json
import os
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import torch
from torch import Tensor

from core.camera import Cameras
from core.guidance.guidance import Views
from core.io.job import Job
from core.io.lock import run_lock
from core.io.progress import Progress
from core.io.run_folder import RunFolder
from core.stages import training
from core.stages.preview import show_color
from core.stages.scene import Scene, gather
from core.stages.state import Training

CHECKPOINT_SECONDS, PREVIEW_SECONDS = 0.05, 0.05  # 20 and 2 in use
EVENTS = "events.jsonl"  # it grows by a line now and then, and is counted by itself


class Numbers(Scene):
    """What a small network makes of noise."""

    device = torch.device("cpu")

    def latents(self, cameras: Cameras, size: int) -> tuple[Tensor, Views]:
        raise NotImplementedError

    def backward(self, losses: Iterator[Tensor]) -> float:
        return gather(losses)

    def show(self, run: RunFolder) -> None:
        show_color(run, np.zeros((64, 64, 3), np.uint8))


class Fit(training.Phase):
    """It is brought towards zero."""

    name = "fit"

    def __init__(self, one: Training, steps: int) -> None:
        self.training, self.steps = one, steps

    def learning_rate(self, index: int) -> float:
        return 1e-3

    def begin(self, index: int) -> tuple[Scene, Iterator[Tensor]]:
        x = torch.randn(16, 64, generator=self.training.generator)
        return Numbers(), iter([self.training.module(x).square().mean()])


def take(count: int, folder: Path) -> None:
    """Take ``count`` steps in ``folder``; print what is held at each twentieth."""
    training.CHECKPOINT_SECONDS, training.PREVIEW_SECONDS = CHECKPOINT_SECONDS, PREVIEW_SECONDS
    run = RunFolder.create(folder / "run", Job(prompt="a chair"))
    generator = torch.Generator().manual_seed(0)
    net = torch.nn.Sequential(torch.nn.Linear(64, 256), torch.nn.ReLU(), torch.nn.Linear(256, 64))
    one = Training("geometry", net, generator, run)
    phase, part = Fit(one, count), max(1, count // 20)
    begin = phase.begin

    def counted(index: int) -> tuple[Scene, Iterator[Tensor]]:
        if index % part == 0 and index:
            print(json.dumps({"steps": index, **held(run.path)}), flush=True)
        return begin(index)

    phase.begin = counted
    with run_lock(run.path):
        alone = SimpleNamespace(views_together=1), SimpleNamespace(views=1, views_at_once=1)
        training.train(training.Setup(one, *alone), [phase], Progress(run))
        print(json.dumps({"steps": count, **held(run.path)}), flush=True)


def held(run: Path) -> dict[str, int]:
    """Memory in kB, open files and processes (Linux); bytes and files of the run folder."""
    gc.collect()
    # A film has ever fewer frames, and is tested by itself.
    files = [
        path
        for path in run.rglob("*")
        if path.is_file() and path.suffix != ".tmp" and path.parent.name != "film"
    ]
    status = Path("/proc/self/status").read_text().split("VmRSS:")[1].split()[0]
    children = Path(f"/proc/{os.getpid()}/task/{os.getpid()}/children").read_text().split()
    return {
        "memory_kb": int(status),
        "files": len(list(Path("/proc/self/fd").iterdir())),
        "processes": len(children),
        "folder_bytes": sum(path.stat().st_size for path in files if path.name != EVENTS),
        "events_bytes": (run / EVENTS).stat().st_size,
        "folder_files": len(files),
    }


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as place:
        take(int(sys.argv[1]), Path(place))
