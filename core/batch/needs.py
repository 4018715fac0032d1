"""The resources that one asset needs, by its guidance, and how many fit at once."""

import os
import re
import sys
from dataclasses import dataclass
from pathlib import Path

import psutil
import torch

from core.errors import UserError
from core.io.job import Job
from core.job_config import BUILTIN

# Bytes, of a process with the built-in prior: `texture` was measured at 1.3 GB, its unwrapping the
# most of it (docs/performance.md).
BUILTIN_MEMORY = 1.5e9
CHECKPOINT_MEMORY = 4.5e9  # bytes beyond the weights: SD 1.5's largest step on a CPU, one view
IN_MEMORY = 2.0  # weights in memory by weights on disk: half there, single here
UNKNOWN_CHECKPOINT = 10e9  # bytes, of one that is named by its hub id
BUILTIN_GPU = 0.25  # of a GPU: its networks and pictures of 64² leave most of one idle


@dataclass(frozen=True)
class Needs:
    """The resources of one asset while it is made."""

    cpus: int
    memory: int  # bytes
    gpus: float  # 0 on the CPU; a fraction lets several share one
    cards: frozenset[int] = frozenset()  # those that are named (cuda:1), if no other will do

    def __str__(self) -> str:
        gpus = f", {self.gpus:g} GPU" if self.gpus else ""
        return f"{self.cpus} core, {self.memory / 1e9:.1f} GB of memory{gpus}"


def needs_of(job: Job, has_gpu: bool) -> Needs:
    """The needs of ``job`` on a machine with or without a CUDA GPU."""
    on_gpu = job.device.split(":")[0] == "cuda" or (job.device == "auto" and has_gpu)
    card = card_of(job.device)
    cards = frozenset() if card is None else frozenset({card})
    if job.guidance == BUILTIN:
        return Needs(1, int(BUILTIN_MEMORY), BUILTIN_GPU if on_gpu else 0.0, cards)
    memory = checkpoint_memory(Path(job.guidance))
    return Needs(1, memory, 1.0 if on_gpu else 0.0, cards)


def card_of(device: str) -> int | None:
    """The GPU's number in a ``device`` such as cuda:1; None where it names none."""
    found = re.fullmatch(r"cuda:(\d{1,3})", device, re.ASCII)
    return int(found[1]) if found else None


def checkpoint_memory(path: Path) -> int:
    """Bytes that a job with the Stable Diffusion checkpoint ``path`` takes, a folder or a file."""
    if not path.exists():
        return int(UNKNOWN_CHECKPOINT)
    files = [path] if path.is_file() else path.glob("*/*.safetensors")
    weights = sum(file.stat().st_size for file in files)
    return int(CHECKPOINT_MEMORY + IN_MEMORY * weights)


def cores() -> int:
    """The cores that this process may use."""
    return len(os.sched_getaffinity(0)) if sys.platform == "linux" else os.cpu_count() or 1


def gpus() -> int:
    """CUDA GPUs of this machine."""
    return torch.cuda.device_count()


def check_at_once(at_once: int | None) -> None:
    """Raise UserError where ``--at-once`` is less than 1."""
    if at_once is not None and at_once < 1:
        raise UserError(f"--at-once is {at_once}.", "Use 1 or more.")


def places(needs: Needs, at_once: int | None) -> int:
    """How many assets with ``needs`` this machine makes at once; at least one is tried.

    Raises:
        UserError: ``at_once`` is less than 1.
    """
    if at_once is not None:
        check_at_once(at_once)
        return at_once
    by_memory = psutil.virtual_memory().available // needs.memory
    cards = min(gpus(), len(needs.cards) or gpus())
    by_gpu = int(cards / needs.gpus) if needs.gpus else cores()
    return max(1, min(cores() // needs.cpus, by_memory, by_gpu))
