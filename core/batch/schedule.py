"""The batch's loop: what is missing is made, what died is tried again, whatever makes it."""

import time
from collections import deque
from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any, Protocol, runtime_checkable

from core.batch.attempt import End
from core.batch.needs import Needs
from core.batch.options import OUT_OF_TIME
from core.batch.plan import Task
from core.batch.progress_line import ProgressLine, seconds_left
from core.errors import UserError
from core.guidance.stable_diffusion.checkpoint import find_checkpoint
from core.guidance.stable_diffusion.multi_view_names import TOGETHER
from core.interrupt import interruptible_once
from core.io.job import Job, write_text
from core.io.json_file import read_object
from core.io.run_folder import RunFolder
from core.job_config import BUILTIN, config_of

# Exit codes that the same run gives again: the input, what is missing, no surface, a cancel.
FINAL = (2, 3, 5, 130, OUT_OF_TIME)
MEMORY = (4, -9)  # -9: the system's own answer to a lack of memory
REFUSED = 2  # the input
WAIT = 1.0  # seconds between two progress lines
STAGES = ("geometry", "appearance")


@runtime_checkable  # or the tests cannot check arguments of it
class Pool(Protocol):
    """Where assets are made: this machine, or a cluster."""

    needs: Needs  # of one asset
    stopping: str  # what the user reads while it stops

    @property
    def places(self) -> int:
        """How many at once."""
        ...

    def start(self, task: Task) -> None:
        """Start or continue ``task``."""
        ...

    def wait(self, seconds: float) -> list[tuple[Task, End]]:
        """The ended attempts, after ``seconds`` at the latest."""
        ...

    def stop(self) -> None:
        """Stop what runs, so that it can be resumed."""
        ...


@dataclass
class State:
    """The state of one run folder in this call."""

    attempts: int = 0
    end: End | None = None  # of its last attempt
    larger: tuple[End, str] | None = None  # that of the attempt before smaller parts, and its job
    started: float = 0.0  # of the running attempt, on the monotonic clock


@dataclass
class Batch:
    """The runs of a batch and how far they are."""

    tasks: Sequence[Task]  # one for each run folder
    pool: Pool
    retries: int
    save: Callable[[dict[Path, State]], None]  # called after each asset
    refused: int = 0  # rows of the table for which there is no run
    states: dict[Path, State] = field(default_factory=dict)

    def run(self) -> None:
        """Make what is missing; KeyboardInterrupt leaves it resumable."""
        # From here on, as Ray's own start has another answer; the last steps may take long.
        with interruptible_once():
            self._run()

    def _run(self) -> None:
        waiting = deque(task for task in self.tasks if not is_done(task))
        self._waiting, self._running = waiting, dict[Path, Task]()
        self._failed, self._is_reported = self.refused, False
        self._line = ProgressLine(len(self.tasks) + self.refused)
        try:
            while waiting or self._running:
                while waiting and len(self._running) < self.pool.places:
                    self._start(waiting.popleft())
                self._tell_of_no_room()
                self._show()
                for task, end in self.pool.wait(WAIT):
                    self._ended(task, end)
            self._show()
        finally:
            if self._running:
                self._line.add(self.pool.stopping)
                self.pool.stop()
            self._line.close()

    def _tell_of_no_room(self) -> None:
        """Once: a cluster may have no node that is large enough, and get one later."""
        if self._waiting and not self._running and not self._is_reported:
            self._is_reported = True
            self._line.add(f"No node has room for an asset ({self.pool.needs}); waiting for one.")

    def _start(self, task: Task) -> None:
        assert task.folder and task.job
        if not (task.folder / "job.json").is_file():
            RunFolder.create(task.folder, task.job)
        elif task.folder not in self.states:  # of an earlier call
            with suppress(UserError):  # of a broken job.json, which the run itself reports
                take_means(task.folder, task.job)
        state = self.states.setdefault(task.folder, State())
        state.attempts, state.started = state.attempts + 1, time.monotonic()
        self._running[task.folder] = task
        self.pool.start(task)

    def _ended(self, task: Task, end: End) -> None:
        assert task.folder
        del self._running[task.folder]
        state = self.states[task.folder]
        if torn := end.code == REFUSED and state.larger:
            # What a checkpoint predicts together, which the node alone can read: as it was before.
            end, job = torn
            write_text(task.folder / "job.json", job)
        state.end = end
        if end.code == 0:
            remove_checkpoints(task.folder)
        elif not torn and end.code not in FINAL and state.attempts <= self.retries:
            job = (task.folder / "job.json").read_text("utf-8") if end.code in MEMORY else ""
            smaller = bool(job) and use_smaller_parts(task.folder)
            state.larger = (end, job) if smaller else None
            how = " with smaller parts" if smaller else ""
            self._line.add(f"{task.name}: {end.text} It is tried again{how}.")
            self._waiting.append(task)
            return
        else:
            self._failed += 1
            self._line.add(f"{task.name} failed: {end.text}")
        self.save(self.states)

    def _show(self) -> None:
        ends = [state.end for state in self.states.values() if state.end]
        now = time.monotonic()
        running = [now - self.states[path].started for path in self._running]
        took = [end.seconds for end in ends if end.code == 0]
        left = seconds_left(took, len(self._waiting), running, self.pool.places)
        self._line.show(self._done(), len(running), self._failed, left)

    def _done(self) -> int:
        return (
            len(self.tasks) + self.refused - len(self._waiting) - len(self._running) - self._failed
        )


def is_done(task: Task) -> bool:
    """Whether the asset is there: it appears whole."""
    return bool(task.folder) and (task.folder / "asset" / "asset.json").is_file()


def remove_checkpoints(folder: Path) -> None:
    """Remove a finished run's checkpoints: two thirds of its bytes."""
    for file in (folder / "checkpoint").glob("*.safetensors"):
        file.unlink()


def take_means(folder: Path, job: Job) -> None:
    """Give the started run in ``folder`` those settings of ``job`` that do not change the result:
    its device, and the views at once where they are fewer.

    Not more: the same command as before must not undo :func:`use_smaller_parts`.
    """
    path, less = folder / "job.json", {}
    old = Job.from_object(read_object(path, "Start a new run."))
    before, now = config_of(old), config_of(job)
    for stage in STAGES:
        if (views := getattr(now, stage).views_at_once) < getattr(before, stage).views_at_once:
            less[f"{stage}.views_at_once"] = views
    new = replace(old, device=job.device, settings=old.settings | less)
    if new != old:
        write_text(path, new.to_json())


def use_smaller_parts(folder: Path) -> bool:
    """Halve the views that are computed together, which the result does not depend on.

    Views that the guidance predicts together stay together. False where it is one view, or one
    such group, already.
    """
    path = folder / "job.json"
    data: dict[str, Any] = read_object(path, "Start a new run.")
    job = Job.from_object(data)
    config, group, less = config_of(job), group_of(job.guidance), {}
    for stage in STAGES:
        now = min(getattr(config, stage).views_at_once, getattr(config, stage).views)
        half = now // 2
        if group or half >= TOGETHER:
            half -= half % (group or TOGETHER)
        if half:
            less[f"{stage}.views_at_once"] = half
    if not less:
        return False
    write_text(path, replace(job, settings=job.settings | less).to_json())
    return True


def group_of(guidance: str) -> int:
    """How many views the ``guidance`` of a job predicts together; 0 of a checkpoint that this
    machine cannot read, as the cluster's nodes may."""
    if guidance == BUILTIN:
        return 1
    try:
        return TOGETHER if find_checkpoint(guidance).family == "mvdream" else 1
    except (UserError, OSError, ImportError):
        return 0
