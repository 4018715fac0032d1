"""One run that this Blender follows: how far it is, what it said, what it shows. No bpy."""

from __future__ import annotations

import json
import time
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from .lock import Claim
from .process import Event, Run
from .target import Target

STAGES = {  # as the core names them: how the panel says it
    "fit": "First shape",
    "geometry": "Shape",
    "unwrap": "UV map",
    "start": "Present colour",
    "appearance": "Material",
    "bake": "Textures",
}
PATIENCE = 3.0  # seconds after which a cancel that waits may be forced


class Progress:
    """How far a run is, as the panel shows it."""

    def __init__(self, stages: tuple[str, ...] = ()) -> None:
        self.stages = stages
        self.stage = ""
        self.step = self.steps = 0
        self.seconds_left: float | None = None
        self.started = False  # the core has spoken
        self.cancelled_at = 0.0  # when the user asked for it; 0 while nobody did

    def take(self, event: Event) -> None:
        """Show a ``progress`` event."""
        self.stage, self.step, self.steps = event.stage, event.step, event.steps
        self.seconds_left = event.seconds_left

    @property
    def cancelling(self) -> bool:
        """Whether the user asked for a stop."""
        return self.cancelled_at > 0

    @property
    def overdue(self) -> bool:
        """Whether a stop was asked for, and the core is still in its step."""
        return self.cancelling and time.monotonic() - self.cancelled_at > PATIENCE

    @property
    def share(self) -> float:
        """Of the present stage, from 0 to 1."""
        return self.step / self.steps if self.steps else 0.0

    @property
    def title(self) -> str:
        """The present stage."""
        return STAGES.get(self.stage, self.stage.capitalize()) or "Starting"

    @property
    def line(self) -> str:
        """What stands in the bar."""
        if self.cancelling:
            return "Cancelling"
        return f"{self.title}  {self.share:.0%}" if self.steps else self.title

    @property
    def detail(self) -> str:
        """What stands below the bar: the place among the stages and the time, or what a stop waits
        for."""
        if self.cancelling and not self.started:
            return "Waits until the method is loaded"
        if self.cancelling:
            return f"Waits for the present step of “{self.title}”"
        if not self.started:
            return "Loading the method, a few seconds"
        place = ""
        if self.stage in self.stages:
            place = f"Stage {self.stages.index(self.stage) + 1} of {len(self.stages)}"
        left = self.seconds_left
        time_left = f"{left // 60:.0f}:{left % 60:02.0f} left in it" if left is not None else ""
        return ", ".join(filter(None, (place, time_left)))


class Follow:
    """A run with what its events said so far."""

    def __init__(self, run: Run, target: Target, claim: Claim | None, file_number: int) -> None:
        self.run, self.target, self.claim = run, target, claim
        self.file_number = file_number  # the open file's, at the start: its name may change
        self.job = read_job(run.folder)
        self.progress = Progress(stages_of(self.job))
        self.warning: tuple[str, str] | None = None
        self.picture: Path | None = None
        self.shape: Path | None = None  # a preview that the viewport does not show yet

    @property
    def name(self) -> str:
        """The run folder's name, by which its preview object is known."""
        return self.run.folder.name

    @property
    def prompt(self) -> str:
        """What was asked for."""
        return str(self.job.get("prompt", ""))

    @property
    def end(self) -> Event | None:
        """The last word; None while it runs."""
        return self.run.last

    def poll(self) -> None:
        """Take in the events since the last call; never blocks."""
        for event in self.run.poll():
            self._take(event)

    def _take(self, event: Event) -> None:
        if event.type == "started":
            self.progress.started = True
        elif event.type == "progress":
            self.progress.take(event)
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
        self.run.cancel()
        self.progress.cancelled_at = self.progress.cancelled_at or time.monotonic()

    def release(self) -> None:
        """Let another Blender follow it."""
        if self.claim:
            self.claim.release()


def read_job(folder: Path) -> Mapping[str, Any]:
    """job.json of a run folder; empty where it can't be read."""
    try:
        job = json.loads((folder / "job.json").read_text("utf-8"))
    except (OSError, ValueError):
        return {}
    return job if isinstance(job, dict) else {}


def stages_of(job: Mapping[str, Any]) -> tuple[str, ...]:
    """The stages that a job goes through, in order."""
    if job.get("command") != "texture":
        return ("fit", "geometry", "unwrap", "appearance", "bake")
    own_uv, start = job.get("uv") == "keep", bool(job.get("base_color"))
    return (
        *(() if own_uv else ("unwrap",)),
        *(("start",) if start else ()),
        "appearance",
        "bake",
    )
