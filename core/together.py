"""Several processes make one asset: the first starts the others, or torchrun starts all.

The first one is the command itself: it holds the run's lock, reads and writes its folder, reports,
and ends with the exit code. The others have the same inputs on devices of their own, and follow.
"""

import os
import subprocess
import sys
import traceback
from collections.abc import Iterator
from contextlib import contextmanager, redirect_stderr, redirect_stdout, suppress
from dataclasses import replace
from pathlib import Path
from typing import Any

import torch
from torch import Tensor

from core.batch.orphan import end_with_stdin
from core.errors import RankLostError, UserError
from core.generate import Inputs, generate, prepare, views_of
from core.interrupt import asks_to_stop
from core.io.job import Job
from core.io.progress import Progress
from core.io.run_folder import RunFolder
from core.ranks import ALONE, Ranks, host, join, meet, rank_in, require_gpus, require_views
from core.terminal import sentence_of

ROOT = Path(__file__).parents[1]
END_SECONDS = 20.0  # that the others get to end by themselves
FOLLOW = "follow"  # the one word of a follower's command line


def place(gpus: int = 1, device: str = "auto") -> int | None:
    """This process's number among those of this machine that make the asset; None: it is alone.

    Raises:
        UserError, MissingError: there cannot be ``gpus`` of them.
    """
    if gpus < 1:
        raise UserError(f"--gpus is {gpus}.", "Use 1 or more.")
    rank = rank_in()
    if rank is not None and gpus > 1:
        raise UserError("--gpus and torchrun both start processes.", "Leave --gpus out.")
    if gpus > 1:
        require_gpus(gpus, device, torch.cuda.device_count())
        return 0
    return None if rank is None else int(os.environ.get("LOCAL_RANK") or rank)


@contextmanager
def together(inputs: Inputs, job: Job, gpus: int = 1, until: str = "") -> Iterator[Inputs]:
    """``inputs`` of the first process with the others at its side: for ``gpus``, or torchrun's.

    Raises:
        UserError: there are more processes than views, or it is for a first look (``until``).
    """
    if rank_in() is None and gpus == 1:
        yield inputs
        return
    if until:
        raise UserError(f"--until {until} is for one process.", "Leave --gpus out, or --until.")
    world = int(os.environ["WORLD_SIZE"]) if rank_in() is not None else gpus
    if inputs.guidance.views_together > 1:
        raise UserError(
            f"This model denoises {inputs.guidance.views_together} views together, in one process.",
            "Leave --gpus and torchrun out.",
        )
    require_views(world, views_of(inputs.config))
    with _met(world, inputs.device) as ranks:
        ranks.texts(job.to_json())
        yield replace(inputs, ranks=ranks)


@contextmanager
def _met(world: int, device: torch.device) -> Iterator[Ranks]:
    """The group of all processes; those that this one has started are gone afterwards."""
    _use(device)
    if rank_in() is not None:
        ranks, others = join(), []
    else:
        store, port = host(world)
        others = [_started(rank, world, port) for rank in range(1, world)]
        ranks = meet(store, 0, world)
    try:
        yield ranks
    finally:
        with suppress(RuntimeError):  # of a group whose others have gone
            ranks.leave()
        for process in others:
            _ended(process)


def _started(rank: int, world: int, port: int) -> subprocess.Popen:
    places = {"RANK": rank, "LOCAL_RANK": rank, "WORLD_SIZE": world, "MASTER_PORT": port}
    more = {name: str(value) for name, value in places.items()} | {"MASTER_ADDR": "127.0.0.1"}
    return subprocess.Popen(
        [sys.executable, "-m", "core.together", FOLLOW],
        cwd=ROOT,
        env={**os.environ, "PYTHONUTF8": "1", **more},
        stdin=subprocess.PIPE,  # closes with this process: it ends then
        stdout=subprocess.DEVNULL,
        start_new_session=True,  # Ctrl-C in the terminal is meant for the first one
    )


def _ended(process: subprocess.Popen) -> None:
    try:
        process.wait(END_SECONDS)
    except subprocess.TimeoutExpired:
        process.kill()
    if process.stdin:
        process.stdin.close()
    process.wait()


def follow() -> int:
    """Take part in the run of the first process, which, or torchrun, has started this one.

    Prints nothing: the first process reports errors.
    """
    # Not asked to stop: the first one decides, and this one ends with it.
    with (
        Path(os.devnull).open("w") as null,
        redirect_stdout(null),
        redirect_stderr(null),
        asks_to_stop(lambda: None),
    ):
        return _follow()


def _follow() -> int:
    ranks = ALONE
    try:
        ranks = join()
        job = Job.from_json(ranks.texts("")[0])
        inputs = replace(prepare(job, place()), ranks=ranks)
        _use(inputs.device)
        run = Followed(job)
        generate(run, inputs, Progress(run))
    except UserError as error:
        return _leave(ranks, error)
    except Exception as error:
        text = f"{type(error).__name__}: {error}\n{traceback.format_exc()}"
        return _leave(ranks, sentence_of(error) or UserError(text))
    ranks.leave()
    return 0


def _leave(ranks: Ranks, error: UserError) -> int:
    """Report the error to the others, except another's end or a request to stop."""
    if not isinstance(error, RankLostError) and error.status != 130:
        with suppress(RuntimeError):
            ranks.report(str(error))
    return error.status


def _use(device: torch.device) -> None:
    if device.type == "cuda":  # which its messages go to as well
        torch.cuda.set_device(device)


class Followed(RunFolder):
    """A run whose folder another process reads and writes."""

    def __init__(self, job: Job) -> None:
        self.path, self.timings, self.turn = Path(os.devnull), {}, 0.0
        self._job = job

    @property
    def job(self) -> Job:
        """The user's job."""
        return self._job

    def report(self, type: str, **fields: Any) -> None:
        """Nothing."""

    def save(self, name: str, tensors: dict[str, Tensor], meta: dict[str, Any]) -> None:
        """Nothing."""

    def load(self, name: str) -> None:
        """Nothing: the first process's state is taken over."""

    def has(self, name: str) -> bool:
        """No checkpoint."""
        del name
        return False


if __name__ == "__main__":
    end_with_stdin()
    os._exit(follow())
