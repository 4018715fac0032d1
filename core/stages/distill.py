"""What both trainings share: where a step stands in its phases, and one score distillation."""

from collections.abc import Iterator
from dataclasses import dataclass

import torch
from jaxtyping import Float, Int
from torch import Tensor

from core.camera import CameraConfig, Cameras, sample_cameras
from core.config import PhaseConfig
from core.guidance.guidance import PromptedGuidance, Views
from core.guidance.sds import anneal, sample_t, sds_grad, sds_loss


def phase_of(index: int, first: PhaseConfig, second: PhaseConfig) -> tuple[PhaseConfig, float]:
    """The phase that step ``index`` lies in, and its share of that phase, 0 to 1."""
    phase, here = (first, index) if index < first.steps else (second, index - first.steps)
    return phase, here / max(phase.steps - 1, 1)


def decayed(learning_rate: float, end: float, share: float) -> float:
    """The learning rate, falling by the exponential to its share ``end`` at the last step."""
    return learning_rate * end**share


@dataclass(frozen=True)
class Draw:
    """What chance gives to one step: a camera, a noise level and a noise for each view.

    Drawn for all views at once and on the CPU, so that a run is the same on every device, and
    however many views are rendered together.
    """

    cameras: Cameras
    t: Int[Tensor, " b"]
    eps: Float[Tensor, "b 4 s s"]

    @classmethod
    def of(
        cls,
        views: int,
        cameras: CameraConfig,
        guidance: PromptedGuidance,
        phase: PhaseConfig,
        share: float,
        generator: torch.Generator,
    ) -> "Draw":
        """``share``: of the phase, for the annealing of t."""
        high = anneal(*phase.t_high, share)
        size = guidance.latent_size
        return cls(
            sample_cameras(views, cameras, generator),
            sample_t(views, phase.t_low, high, len(guidance.alpha_bar), generator),
            torch.randn(views, 4, size, size, generator=generator),
        )

    def split(self, views_at_once: int, device: torch.device) -> "Iterator[Draw]":
        """Parts of ``views_at_once`` views, the last one smaller, on ``device``."""
        for start in range(0, len(self.t), views_at_once):
            part = slice(start, start + views_at_once)
            yield Draw(
                self.cameras[part].to(device), self.t[part].to(device), self.eps[part].to(device)
            )


def distill(
    guidance: PromptedGuidance,
    z: Float[Tensor, "b 4 s s"],
    views: Views,
    draw: Draw,
    phase: PhaseConfig,
    cap: float,
) -> tuple[Tensor, Float[Tensor, "b 4 s s"]]:
    """One SDS step (Eqs. 1, 5, 9): a loss per pixel of ``z``, and its gradient there."""
    grad = sds_grad(
        guidance,
        z,
        views,
        t=draw.t,
        eps=draw.eps.to(z),
        weighting=phase.weighting,
        guidance_scale=phase.guidance_scale,
        cap=cap or None,
    )
    grad = grad / (z.shape[-1] * z.shape[-2])
    return sds_loss(z, grad), grad
