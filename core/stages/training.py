"""The training loop of both networks: phases of steps; guard, previews and checkpoints."""

import time
from abc import ABC, abstractmethod
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Generic, TypeVar

import torch
from torch import Tensor

from core.config import AppearanceConfig, GeometryConfig
from core.errors import NoSurfaceError
from core.guidance.guidance import PromptedGuidance
from core.guidance.sds import NotFiniteError
from core.io.progress import Progress
from core.stages.guard import Guard, healthy_gradients
from core.stages.scene import Scene
from core.stages.state import Net, Training

CHECKPOINT_SECONDS = 20.0  # what a power cut may cost; one takes some hundredths of a second
PREVIEW_SECONDS = 2.0

Settings = TypeVar("Settings", GeometryConfig, AppearanceConfig)


@dataclass(frozen=True)
class Setup(Generic[Net, Settings]):
    """What all phases of one training share: the network, its guidance, its settings."""

    training: Training[Net]
    guidance: PromptedGuidance
    config: Settings


class Phase(ABC):
    """Steps of a training that are alike."""

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
    training: Training,
    phases: Sequence[Phase],
    progress: Progress,
    gradient_clip: float = 0.0,
    stop: int | None = None,
) -> None:
    """Take the steps of all ``phases``, one after another, from where ``training`` is.

    Args:
        gradient_clip: upper bound of the gradient's norm; 0 is none.
        stop: the step to stop before, for now; None takes them all.
    """
    guard = Guard(training, progress)
    checkpoint, preview = Every(CHECKPOINT_SECONDS), Every(PREVIEW_SECONDS, at_once=True)
    # Only their number: a phase's rates and noise follow its whole length, so that a later session
    # goes on as if there had been no stop.
    counts = first_steps([phase.steps for phase in phases], stop)

    for step in progress.steps(training.name, training.step, counts):
        phase = phases[step.phase]

        # GRADIENT: of all views of the step
        training.optimizer.zero_grad()
        scene, losses = phase.begin(step.index)
        failure = ""
        try:
            step.loss = scene.backward(losses)
            step.coverage = scene.coverage
        except (NotFiniteError, NoSurfaceError) as error:
            failure = error.text
        # A finite loss may have an infinite slope; one step with it would spoil every parameter.
        if not failure and not healthy_gradients(training.module):
            failure = "The gradient was not finite"

        # STEP: or back to the last healthy state
        if failure:
            guard.recover(failure, step.at, phase.name)
        else:
            guard.remember(step.at)
            if gradient_clip > 0:
                torch.nn.utils.clip_grad_norm_(training.module.parameters(), gradient_clip)
            training.set_learning_rate(guard.rate(step.at) * phase.learning_rate(step.index))
            training.optimizer.step()
            if preview.due():
                scene.show(training.run)

        # CHECKPOINT: now and then, at the end, and before a cancelled run stops
        training.step = step.at + 1
        if checkpoint.due() or step.last or progress.cancelled:
            training.save()
        progress.check_cancelled()


def first_steps(counts: Sequence[int], stop: int | None) -> list[int]:
    """Of phases with ``counts`` steps, how many steps of each come before step ``stop``."""
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
