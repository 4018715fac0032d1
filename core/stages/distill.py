"""What both trainings share: where a step stands in its phases, and one score distillation."""

import torch
from jaxtyping import Float
from torch import Tensor

from core.config import PhaseConfig
from core.guidance.guidance import Embedding, Guidance, Views
from core.guidance.sds import anneal, sample_t, sds_grad, sds_loss


def phase_of(index: int, first: PhaseConfig, second: PhaseConfig) -> tuple[PhaseConfig, float]:
    """The phase that step ``index`` lies in, and its share of that phase, 0 to 1."""
    phase, here = (first, index) if index < first.steps else (second, index - first.steps)
    return phase, here / max(phase.steps - 1, 1)


def decayed(learning_rate: float, end: float, share: float) -> float:
    """The learning rate, falling by the exponential to its share ``end`` at the last step."""
    return learning_rate * end**share


def distill(
    guidance: Guidance,
    z: Float[Tensor, "b 4 s s"],
    embedding: Embedding,
    views: Views,
    phase: PhaseConfig,
    share: float,
    cap: float,
    generator: torch.Generator,
) -> tuple[Tensor, Float[Tensor, "b 4 s s"]]:
    """One SDS step (Eqs. 1, 5, 9): a loss per pixel of ``z``, and its gradient there.

    ``generator`` is a CPU generator, so that a run has the same noise on every device.
    """
    high = anneal(*phase.t_high, share)
    t = sample_t(len(z), phase.t_low, high, len(guidance.alpha_bar), generator).to(z.device)
    eps = torch.randn(z.shape, generator=generator).to(z)
    grad = sds_grad(
        guidance,
        z,
        embedding,
        views,
        t=t,
        eps=eps,
        weighting=phase.weighting,
        guidance_scale=phase.guidance_scale,
        cap=cap or None,
    )
    grad = grad / (z.shape[-1] * z.shape[-2])
    return sds_loss(z, grad), grad
