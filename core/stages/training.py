"""The training loop of both networks: phases of steps; guard, previews and checkpoints."""

import time
from abc import ABC, abstractmethod
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Generic, TypeVar

import torch
from torch import Tensor

from core.config import AppearanceConfig, GeometryConfig
from core.errors import Cancelled, MemoryShortError, NoSurfaceError, RankLostError
from core.guidance.guidance import PromptedGuidance
from core.guidance.sds import NotFiniteError
from core.io.progress import Progress, Step
from core.ranks import ALONE, Ranks
from core.stages.guard import MIN_COVERAGE, Guard, healthy_gradients
from core.stages.room import Render, views_that_fit
from core.stages.scene import Scene
from core.stages.state import Net, Training

CHECKPOINT_SECONDS = 20.0  # what a power cut may cost; one takes some hundredths of a second
PREVIEW_SECONDS = 2.0

Settings = TypeVar("Settings", GeometryConfig, AppearanceConfig)


@dataclass(frozen=True)
class Setup(Generic[Net, Settings]):
    """The common objects of a training's phases: the network, its guidance, its settings."""

    training: Training[Net]
    guidance: PromptedGuidance
    config: Settings
    ranks: Ranks = ALONE  # those that train it together

    @property
    def at_once(self) -> int:
        """Views that are rendered together; the result does not depend on it."""
        return self.training.at_once or self.config.views_at_once

    def fit(self, kind: Render, sizes: Iterable[int]) -> None:
        """Take no more views at a time than the memory holds, of the largest of ``sizes``."""
        config, guidance = self.config, self.guidance
        self.training.at_once = views_that_fit(
            kind,
            config.views_at_once,
            max(sizes),
            config.cameras,
            self.training.device,
            busy=guidance.busy_bytes,
            together=guidance.views_together,
        )


class Phase(ABC):
    """Steps of a training with the same settings."""

    name: str  # of its settings: "coarse" is geometry.coarse
    steps: int

    @abstractmethod
    def learning_rate(self, index: int) -> float:
        """That of the phase's step ``index``."""

    @abstractmethod
    def begin(self, index: int) -> tuple[Scene, Iterator[Tensor]]:
        """The scene of the phase's step ``index``, and its losses, part of the views by part.

        The losses are computed as they are asked for, and their sum is the step's loss.
        """


def train(
    setup: Setup,
    phases: Sequence[Phase],
    progress: Progress,
    gradient_clip: float = 0.0,
    stop: int | None = None,
) -> None:
    """Take the steps of all ``phases``, one after another, from where the training is.

    Args:
        gradient_clip: upper bound of the gradient's norm; 0 is none.
        stop: the step to stop before, for now; None takes them all.
    """
    training, ranks = setup.training, setup.ranks
    training.synchronize(ranks)
    guard = Guard(training, progress)
    checkpoint, preview = Every(CHECKPOINT_SECONDS), Every(PREVIEW_SECONDS, at_once=True)
    # Only their number: a phase's rates and noise follow its whole length, so that a later session
    # continues as if there had been no stop.
    counts = first_steps([phase.steps for phase in phases], stop)

    for step in progress.steps(training.name, training.step, counts):
        phase = phases[step.phase]

        # GRADIENT: of all views of the step
        with _kept_if_a_rank_is_lost(setup):
            scene, failure, asked = _gradient_that_fits(setup, phase, step, progress)

        # STEP: or back to the last healthy state
        if failure:
            guard.recover(failure, step.at, phase.name)
        else:
            guard.remember(step.at)
            if gradient_clip > 0:
                torch.nn.utils.clip_grad_norm_(training.module.parameters(), gradient_clip)
            training.set_learning_rate(guard.rate(step.at) * phase.learning_rate(step.index))
            training.optimizer.step()
            if ranks.first and preview.due():
                scene.show(training.run)

        # CHECKPOINT: now and then, at the end, and before a cancelled run stops
        training.step = step.at + 1
        asked = asked if ranks.world > 1 else progress.cancelled
        if ranks.first and (checkpoint.due() or step.last or asked):
            training.save()
        if asked:
            progress.check_cancelled()
            raise Cancelled("Cancelled.")  # one that only follows does not see the request itself


def _gradient_that_fits(
    setup: Setup, phase: Phase, step: Step, progress: Progress
) -> tuple[Scene, str, bool]:
    """:func:`gradient_of`; where memory does not hold its views, with half as many at a time."""
    training = setup.training
    before = training.mark()
    while True:
        # Views that a guidance predicts together stay together.
        group = setup.guidance.views_together
        half = min(setup.at_once, setup.config.views) // 2 // group * group
        try:
            return gradient_of(setup, phase, step, progress.cancelled)
        except (torch.OutOfMemoryError, MemoryShortError):
            # Other processes wait for the step that this one has started.
            if half == 0 or setup.ranks.world > 1:
                raise
        # Here, and not above: the error holds the step's tensors.
        training.back_to(before)
        training.at_once = half
        if training.device.type == "cuda":
            torch.cuda.empty_cache()
        progress.warn(
            f"There was not enough memory for a step's views; went on with {half} at a time.",
            f"Nothing to do. --set {training.name}.views_at_once={half} starts with that.",
            stage=training.name,
        )


def gradient_of(
    setup: Setup, phase: Phase, step: Step, stop: bool = False
) -> tuple[Scene, str, bool]:
    """Gather the gradient of a step; its scene, what went wrong with it, and ``stop`` of anyone.

    All ranks come to the same: the sums decide, and they are the same to the bit.
    """
    training, ranks = setup.training, setup.ranks
    training.optimizer.zero_grad()
    scene, losses = phase.begin(step.index)
    loss, failure = torch.zeros((), dtype=torch.float64), ""
    try:
        loss = scene.backward(losses)
    except (NotFiniteError, NoSurfaceError) as error:
        failure = error.text
    coverage = scene.coverage
    # Both in one question: a GPU is waited for at each.
    numbers = (loss, loss.new_ones(()) if coverage is None else coverage.to(loss))

    # TOGETHER: one message carries the state of all processes
    rows = ranks.rows([*torch.stack(numbers).tolist(), float(bool(failure)), float(stop)])
    total, stop = float(rows[:, 0].sum()), bool(rows[:, 3].any())
    if bool(rows[:, 2].any()):
        failure = next(filter(None, ranks.texts(failure)))
        training.synchronize_noise(ranks)  # the failed one has drawn less than the others
        return scene, failure, stop
    if coverage is not None:
        step.coverage = float(rows[:, 1].max())
    # After the views: the coverage is known only now. Nearly nothing in view has nearly no
    # gradient.
    if float(rows[:, 1].max()) < MIN_COVERAGE:
        return scene, "The surface had nearly vanished", stop
    step.loss = total
    ranks.sum_gradients(training.module)
    # A finite loss may have an infinite slope; one step with it would spoil every parameter.
    healthy = healthy_gradients(training.module)
    return scene, "" if healthy else "The gradient was not finite", stop


@contextmanager
def _kept_if_a_rank_is_lost(setup: Setup) -> Iterator[None]:
    """A checkpoint from before the step, where another process ends within it."""
    training = setup.training
    before = training.mark()
    try:
        yield
    except RankLostError:
        training.back_to(before)
        if setup.ranks.first:
            training.save()
        raise


def first_steps(counts: Sequence[int], stop: int | None) -> list[int]:
    """For phases with ``counts`` steps: how many steps of each come before step ``stop``."""
    if stop is None:
        return list(counts)
    before = [sum(counts[:i]) for i in range(len(counts))]
    return [max(0, min(n, stop - b)) for n, b in zip(counts, before, strict=True)]


class Every:
    """A clock for what happens every so many seconds."""

    def __init__(self, seconds: float, at_once: bool = False) -> None:
        """``at_once``: the first time is now."""
        self._seconds = seconds
        self._last = time.perf_counter() - (seconds if at_once else 0.0)

    def due(self) -> bool:
        """Whether it is time; the next time is then so many seconds from now."""
        now = time.perf_counter()
        if now - self._last < self._seconds:
            return False
        self._last = now
        return True


def fraction(index: int, steps: int) -> float:
    """How far step ``index`` of ``steps`` is: 0 at the first, 1 at the last."""
    return index / max(steps - 1, 1)


def decayed(learning_rate: float, end: float, progress: float) -> float:
    """The learning rate, falling exponentially to its fraction ``end`` at ``progress`` 1."""
    return learning_rate * end**progress
