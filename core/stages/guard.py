"""Keeps a training alive: goes back where its surface vanishes or its numbers are not finite.

An empty mesh gives no gradient, so nothing would ever bring it back (METHOD.md, fault 9 of the
released code).
"""

import torch

from core.errors import NoSurfaceError
from core.io.run_folder import Training

SNAPSHOT_STEPS = 20
MAX_RECOVERIES = 5
MIN_COVERAGE = 0.01  # share of the picture's pixels


class Guard:
    """Remembers the last healthy state of a training, and goes back to it."""

    def __init__(self, training: Training) -> None:
        self._training = training
        self._good = training.state()
        self._good_step = training.step
        training.extra.setdefault("recoveries", 0)

    @property
    def rate(self) -> float:
        """The factor on the learning rate: a half for each time that it went back."""
        return 0.5 ** self._training.extra["recoveries"]

    def remember(self, step: int) -> None:
        """Step ``step`` began in good health."""
        if step % SNAPSHOT_STEPS == 0:
            self._good, self._good_step = self._training.state(), step

    def recover(self, why: str) -> None:
        """Put the last healthy state back, at half the learning rate and with other noise.

        Raises:
            NoSurfaceError: it has gone back too often.
        """
        training = self._training
        training.extra["recoveries"] += 1
        if training.extra["recoveries"] > MAX_RECOVERIES:
            raise NoSurfaceError(
                f"{why}, {MAX_RECOVERIES} times, at half the learning rate each time.",
                "Take another seed, a --guide mesh, or a lower --set "
                f"{training.name}.{'coarse' if training.name == 'geometry' else 'early'}"
                ".guidance_scale.",
            )
        noise = training.generator.get_state()
        training.set_state(self._good)
        training.generator.set_state(noise)
        training.run.say(
            "warning",
            stage=training.name,
            text=f"{why}; went back to step {self._good_step} at half the learning rate.",
            fix="Nothing to do. If it happens often, take another seed.",
        )


def healthy_gradients(module: torch.nn.Module) -> bool:
    """Whether every gradient is finite."""
    return all(p.grad is None or bool(p.grad.isfinite().all()) for p in module.parameters())
