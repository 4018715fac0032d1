"""How far a run is: progress events, the time left, seconds by stage, and the request to cancel."""

import math
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any

from tqdm import tqdm

from core.errors import Cancelled
from core.io.run_folder import RunFolder
from core.terminal import show

PROGRESS_SECONDS = 0.2  # between two progress events: what a panel can show
# And this much of the time since the session began: the file of a day's run stays under 1 MB.
PROGRESS_FRACTION = 1e-3


@dataclass
class Step:
    """One step of a stage: where it is, and the loss that the progress shows."""

    phase: int  # which of the stage's phases
    index: int  # within the phase
    at: int  # within the stage
    last: bool  # of the stage
    loss: float | None = None
    coverage: float | None = None  # of the pictures by the surface, where that is being learned


class Progress:
    """A stage's reports while it works, and its look at the user's request to stop."""

    def __init__(self, run: RunFolder) -> None:
        self._run = run
        self._interrupted = False
        self._reported = 0.0  # when the last progress event was written
        self._started = time.perf_counter()

    def interrupt(self) -> None:
        """Ask for a stop after this step, as the file ``cancel`` does."""
        self._interrupted = True

    @property
    def cancelled(self) -> bool:
        """Whether a stop was asked for."""
        return self._interrupted or (self._run.path / "cancel").exists()

    def check_cancelled(self) -> None:
        """Raise Cancelled where a stop was asked for."""
        if self.cancelled:
            raise Cancelled("Cancelled.", f"Continue it: run.py resume {self._run.path}")

    def steps(self, stage: str, first: int, counts: Sequence[int]) -> Iterator[Step]:
        """The steps of a stage whose phases have ``counts`` steps, from the ``first`` on."""
        places = [(phase, index) for phase, n in enumerate(counts) for index in range(n)]
        total, timings = len(places), self._run.timings
        earlier = timings.get(stage, 0.0)  # seconds of earlier sessions
        clock = TimeLeft(counts)
        with _Bar(stage, first, total) as bar:
            start = before = time.perf_counter()
            for at in range(first, total):
                phase, index = places[at]
                step = Step(phase, index, at, last=at + 1 == total)
                yield step
                now = time.perf_counter()
                timings[stage] = earlier + now - start
                clock.add(phase, now - before)
                before = now
                seconds_left = clock.after(phase, index)
                numbers = {"loss": step.loss, "coverage": step.coverage}
                self._report(stage, at + 1, total, **numbers, seconds_left=seconds_left)
                bar.update(at + 1, seconds_left)

    def advance(self, stage: str, step: int, steps: int) -> None:
        """Report ``step`` of ``steps``, and stop where the user asks for it."""
        self.check_cancelled()
        self._report(stage, step, steps)

    def complete(self, stage: str) -> None:
        """Report the end of a stage that may have been too short for any other report."""
        self._report(stage, 100, 100)

    def warn(self, text: str, fix: str = "", stage: str | None = None) -> None:
        """A warning, for the terminal and the panel."""
        self._run.report("warning", stage=stage, text=text, fix=fix or None)

    @contextmanager
    def timed(self, stage: str) -> Iterator[None]:
        """Add the time within to the stage's; name the stage on the terminal."""
        show(f"{stage} …")
        start = time.perf_counter()
        yield
        timings = self._run.timings
        timings[stage] = timings.get(stage, 0.0) + time.perf_counter() - start

    def _report(self, stage: str, step: int, steps: int, **numbers: float | None) -> None:
        """A progress event, if the last one is old enough or the stage has ended."""
        now = time.perf_counter()
        pause = max(PROGRESS_SECONDS, PROGRESS_FRACTION * (now - self._started))
        if now - self._reported < pause and step < steps:
            return
        self._reported = now
        fields: dict[str, Any] = {
            name: round(value, 1 if name == "seconds_left" else 5)
            for name, value in numbers.items()
            if value is not None and math.isfinite(value)  # JSON has neither NaN nor infinity
        }
        self._run.report("progress", stage=stage, step=step, steps=steps, **fields)


class TimeLeft:
    """Seconds that a stage still takes, from the mean step of each of its phases.

    A phase's first step in a session is left out: it compiles and allocates, and once made 2,750 s
    of a stage of 75. A phase that is still to come is taken to cost what the present one does.
    """

    def __init__(self, counts: Sequence[int]) -> None:
        self._counts = counts
        self._seconds: dict[int, list[float]] = {}  # by phase, of the steps after its first

    def add(self, phase: int, seconds: float) -> None:
        """A step of ``phase`` took ``seconds``."""
        if phase in self._seconds:
            self._seconds[phase].append(seconds)
        else:
            self._seconds[phase] = []

    def after(self, phase: int, index: int) -> float | None:
        """The time left after step ``index`` of ``phase``; None while nothing was measured."""
        left = self._counts[phase] - index - 1 + sum(self._counts[phase + 1 :])
        if left == 0:
            return 0.0
        for measured in (self._seconds[p] for p in sorted(self._seconds, reverse=True)):
            if measured:
                return left * sum(measured) / len(measured)
        return None


class _Bar:
    """Progress on the terminal: a bar, or a line for each tenth where the output is a file."""

    def __init__(self, stage: str, first: int, total: int) -> None:
        self._bar = tqdm(total=total, initial=first, desc=stage, mininterval=0.5, disable=None)
        self._stage, self._total, self._tenth = stage, total, -1

    def __enter__(self) -> "_Bar":
        return self

    def __exit__(self, *_: object) -> None:
        self._bar.close()

    def update(self, done: int, seconds_left: float | None) -> None:
        """``done`` steps are done."""
        self._bar.update()
        tenth = done * 10 // self._total
        if self._bar.disable and tenth > self._tenth:
            self._tenth = tenth
            left = "" if seconds_left is None else f", {seconds_left:.0f} s left"
            show(f"{self._stage} {done}/{self._total}{left}")
