"""Keeps a training alive: goes back where its surface vanishes or its numbers are not finite.

An empty mesh gives no gradient, so nothing would ever bring it back. (The released code ends on an
assertion there.)
"""

import torch

from core.errors import NoSurfaceError
from core.io.progress import Progress
from core.stages.state import Training

SNAPSHOT_STEPS = 20  # between two states to go back to; one costs a copy of the parameters
MAX_RECOVERIES = 5  # within WINDOW steps: the rate is then a 32nd, and lower rates do not help
WINDOW = 200  # steps after which a recovery is over: ten snapshots have been good since
MIN_COVERAGE = 0.01  # fraction of the picture's pixels


class Guard:
    """Remembers the last healthy state of a training, and goes back to it."""

    def __init__(self, training: Training, progress: Progress) -> None:
        self._training, self._progress = training, progress
        # Both are in the checkpoint, so that a resumed run counts on and goes back as far as an
        # unbroken one: the steps at which it went back, and the state that it goes back to.
        self._recovered: list[int] = training.extra.setdefault("recovered_at", [])
        if not training.healthy:
            self._keep(training.step)

    def rate(self, step: int) -> float:
        """The factor on the learning rate: a half for each recovery that is not over yet."""
        return 0.5 ** len(self._recent(step))

    def remember(self, step: int) -> None:
        """The state before ``step`` is healthy."""
        if step % SNAPSHOT_STEPS == 0:
            self._keep(step)

    def _keep(self, step: int) -> None:
        self._training.healthy = self._training.state()
        self._training.extra["healthy_at"] = step

    def recover(self, why: str, step: int, phase: str) -> None:
        """Put the last healthy state back, at half the learning rate and with other noise.

        Raises:
            NoSurfaceError: it has gone back too often lately.
        """
        self._recovered.append(step)
        count = len(self._recent(step))
        if count > MAX_RECOVERIES:
            raise NoSurfaceError(
                f"{why}, {count} times in {WINDOW} steps, at half the learning rate each time.",
                "Use another seed, a --guide mesh, or a lower --set "
                f"{self._training.name}.{phase}.guidance_scale.",
            )
        # The generator continues: with the same noise the same step would fail again.
        noise = self._training.generator.get_state()
        self._training.set_state(self._training.healthy)
        self._training.generator.set_state(noise)
        self._progress.warn(
            f"{why}; went back to step {self._training.extra['healthy_at']} at half the learning "
            "rate.",
            "Nothing to do. If it happens often, use another seed.",
            stage=self._training.name,
        )

    def _recent(self, step: int) -> list[int]:
        return [at for at in self._recovered if step - at < WINDOW]


def healthy_gradients(module: torch.nn.Module) -> bool:
    """Whether every gradient is finite; a GPU is waited for once, not once for each parameter."""
    grads = [p.grad for p in module.parameters() if p.grad is not None]
    # The largest value: unlike a sum of squares it is finite wherever all of them are.
    return bool(torch.nn.utils.get_total_norm(grads, float("inf")).isfinite())
