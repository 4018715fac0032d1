"""One run that this Blender follows: its progress, its messages, its previews. No bpy."""

from __future__ import annotations

import time
from pathlib import Path

from .events import STAGES, Event, stages_of
from .job_file import read_job
from .lock import RunLock
from .process import Run
from .target import Target

PATIENCE = 3.0  # seconds after which a cancel that waits may be forced


class Progress:
    """How far a run is, as the panel shows it."""

    def __init__(self, stages: tuple[str, ...] = ()) -> None:
        self.stages = stages
        self.stage = ""
        self.step = self.steps = 0
        self.seconds_left: float | None = None
        self.started = False  # the core's first event was read
        self.cancelled_at = 0.0  # when the user requested it; 0 while nobody did

    def update(self, event: Event) -> None:
        """Take over a ``progress`` event."""
        self.stage, self.step, self.steps = event.stage, event.step, event.steps
        self.seconds_left = event.seconds_left

    @property
    def cancelling(self) -> bool:
        """Whether the user requested a stop."""
        return self.cancelled_at > 0

    @property
    def overdue(self) -> bool:
        """Whether a stop was requested and the core is still in its step after PATIENCE."""
        return self.cancelling and time.monotonic() - self.cancelled_at > PATIENCE

    @property
    def fraction(self) -> float:
        """The present stage's progress, from 0 to 1."""
        return self.step / self.steps if self.steps else 0.0

    @property
    def title(self) -> str:
        """The present stage."""
        return STAGES.get(self.stage, self.stage.capitalize()) or "Starting"

    @property
    def line(self) -> str:
        """The text in the progress bar."""
        if self.cancelling:
            return "Cancelling"
        return f"{self.title}  {self.fraction:.0%}" if self.steps else self.title

    @property
    def detail(self) -> str:
        """The text below the bar: stage and time left, or what a cancel waits for."""
        if self.cancelling and not self.started:
            return "Waiting until the method is loaded"
        if self.cancelling:
            return f"Waiting for the present step of “{self.title}”"
        if not self.started:
            return "Loading the method, a few seconds"
        number = ""
        if self.stage in self.stages:
            number = f"Stage {self.stages.index(self.stage) + 1} of {len(self.stages)}"
        left = self.seconds_left
        minutes, seconds = divmod(round(left or 0), 60)  # first: 59.7 is a minute, not 0:60
        time_left = f"{minutes}:{seconds:02} left in it" if left is not None else ""
        return ", ".join(filter(None, (number, time_left)))


class FollowedRun:
    """A run with what its events reported so far."""

    def __init__(
        self, run: Run, target: Target, lock: RunLock | None, file_number: int | None
    ) -> None:
        self.run, self.target, self.lock = run, target, lock
        # The number of the file that was open at the request, whose name may change; None: an
        # earlier Blender's, known by its name alone.
        self.file_number = file_number
        self.job = read_job(run.folder)
        self.progress = Progress(stages_of(self.job))
        self.warning: tuple[str, str] | None = None  # the last one: text and fix
        self.picture: Path | None = None  # the newest preview picture
        self.shape: Path | None = None  # a preview mesh that the viewport does not show yet
        self.place: tuple[float, float, float] | None = None  # where its preview was put

    @property
    def name(self) -> str:
        """The run folder's name, which its preview object carries."""
        return self.run.folder.name

    @property
    def prompt(self) -> str:
        """The text of the job."""
        return str(self.job.get("prompt", ""))

    @property
    def end(self) -> Event | None:
        """The event that ended it; None while it runs."""
        return self.run.last

    def poll(self) -> None:
        """Read the events since the last call; never blocks."""
        for event in self.run.poll():
            self._update(event)

    def _update(self, event: Event) -> None:
        if event.type == "started":
            self.progress.started = True
        elif event.type == "progress":
            self.progress.update(event)
        elif event.type == "warning":
            self.warning = (event.text, event.fix)
        elif event.type == "preview":
            path = self.run.folder / event.path
            if path.suffix == ".npz":
                self.shape = path
            else:
                self.picture = path

    def cancel(self) -> None:
        """Ask the core to stop after its present step."""
        # The first request counts: pressing again does not restart the patience. It starts even
        # where the request can't be written, so that the process can be ended.
        self.progress.cancelled_at = self.progress.cancelled_at or time.monotonic()
        self.run.cancel()

    def release(self) -> None:
        """Let another Blender follow it."""
        if self.lock:
            self.lock.release()
