"""Rounds of fitting, beyond the paper: to denoised pictures of what there is.

Score distillation seeks one shape that pleases every noise at once: thin parts, of which each noise
means another, fade, planes stay dented and edges round. A round draws pictures of what there is,
makes them noisy and clean again (SDEdit: Meng et al. 2022), and fits to all of them at once by
plain regression, over and over (the dataset update of Instruct-NeRF2NeRF: Haque et al. 2023, §4.2).
"""

from dataclasses import dataclass, fields

import torch
from jaxtyping import Float
from torch import Tensor

from core.camera import Cameras
from core.config import RefineConfig
from core.guidance.denoise import denoise
from core.guidance.guidance import PromptedGuidance, Views
from core.guidance.sds import add_noise, anneal


def refine_steps(config: RefineConfig) -> int:
    """Steps of the optimiser in all rounds."""
    return config.rounds * config.steps


@dataclass(frozen=True)
class Targets:
    """The pictures that one round is fitted to, as clean latents."""

    cameras: Cameras
    z: Float[Tensor, "b 4 s s"]

    def tensors(self) -> dict[str, Tensor]:
        """For a checkpoint."""
        return {"z": self.z} | vars(self.cameras)

    @classmethod
    def of(cls, tensors: dict[str, Tensor]) -> "Targets":
        """Back from :meth:`tensors`."""
        names = [field.name for field in fields(Cameras)]
        return cls(Cameras(*(tensors[name] for name in names)), tensors["z"])

    def some(self, count: int, generator: torch.Generator) -> "Targets":
        """``count`` of them by chance, all where there are fewer."""
        index = torch.randperm(len(self.z), generator=generator)[:count].to(self.z.device)
        return Targets(self.cameras[index], self.z[index])

    def split(self, views_at_once: int) -> "list[Targets]":
        """Parts of ``views_at_once`` views, the last one smaller."""
        starts = range(0, len(self.z), views_at_once)
        parts = [slice(start, start + views_at_once) for start in starts]
        return [Targets(self.cameras[part], self.z[part]) for part in parts]


def denoised(
    z: Float[Tensor, "b 4 s s"],
    guidance: PromptedGuidance,
    views: Views,
    config: RefineConfig,
    share: float,
    generator: torch.Generator,
) -> Targets:
    """Targets from the latents of what there is.

    Args:
        share: of the rounds, 0 at the first and 1 at the last.
    """
    last = len(guidance.alpha_bar) - 1
    t = min(round(anneal(*config.t, share) * len(guidance.alpha_bar)), last)
    eps = torch.randn(z.shape, generator=generator).to(z)
    z_t = add_noise(z, eps, guidance.alpha_bar.to(z)[t].expand(len(z)))
    clean = denoise(guidance, z_t, t, views, config.guidance_scale, config.denoise_steps)
    return Targets(views.cameras, clean)


def fit_loss(z: Float[Tensor, "b 4 s s"], target: Float[Tensor, "b 4 s s"]) -> Float[Tensor, ""]:
    """The mean squared difference of each picture, summed over the pictures."""
    return (z - target).square().mean((1, 2, 3)).sum()
