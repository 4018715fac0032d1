"""The scene of one step's cameras: one interface for the shape and for the shaded object."""

from abc import ABC, abstractmethod
from collections.abc import Iterator

import torch
from jaxtyping import Float
from torch import Tensor

from core.camera import Cameras
from core.guidance.guidance import Views
from core.io.run_folder import RunFolder


class Scene(ABC):
    """The pictures of one step, and the way of their gradient back into the network.

    The network stays as it is until all views of the step have been rendered.
    """

    device: torch.device

    @property
    def coverage(self) -> Float[Tensor, ""] | None:
        """Fraction of the picture that is covered; None where the shape is final."""
        return None

    @abstractmethod
    def latents(self, cameras: Cameras, size: int) -> tuple[Float[Tensor, "b 4 s s"], Views]:
        """The pictures of ``size`` pixels as latents, and what the guidance may know of them."""

    @abstractmethod
    def backward(self, losses: Iterator[Tensor]) -> Float[Tensor, ""]:
        """Gather the gradient of ``losses`` in the network; their sum.

        Raises:
            NoSurfaceError: there is nothing to see.
        """

    @abstractmethod
    def show(self, run: RunFolder) -> None:
        """Write the run's preview of it."""


def gather(losses: Iterator[Tensor]) -> Float[Tensor, ""]:
    """Backward through one loss after another; their sum.

    Each is computed, and its graph freed, before the next: memory is that of one part's views.
    """
    values: list[Tensor] = []
    for loss in losses:
        if loss.requires_grad:  # a regulariser may not apply
            loss.backward()
        values.append(loss.detach().double())
    # A tensor, so that a GPU is not waited for.
    return torch.stack(values).sum() if values else torch.zeros((), dtype=torch.float64)


def portions(count: int, at_once: int) -> list[slice]:
    """0 to ``count`` in parts of ``at_once``, the last one smaller."""
    return [slice(start, start + at_once) for start in range(0, count, at_once)]
