"""From a noisy latent back to a clean one, in a few steps."""

import torch
from jaxtyping import Float
from torch import Tensor

from core.guidance.guidance import PromptedGuidance, Views
from core.guidance.sds import predict_eps


@torch.no_grad()
def denoise(
    guidance: PromptedGuidance,
    z_t: Float[Tensor, "b 4 s s"],
    t: int,
    views: Views,
    guidance_scale: float,
    steps: int,
) -> Float[Tensor, "b 4 s s"]:
    """The clean latents that ``z_t`` comes from, by ``steps`` evenly spaced steps of DDIM.

    Song, Meng and Ermon 2021, "Denoising diffusion implicit models", Eq. 12 with sigma_t = 0.
    One step gives the mean of all pictures that ``z_t`` may come from; more of them, one picture.

    Args:
        t: index into ``guidance.alpha_bar``, of all views.
    """
    alpha_bar = guidance.alpha_bar.to(z_t)
    times = [round(t * (1 - k / steps)) for k in range(steps)]  # t first; 0 is never reached
    z = z_t
    for now, after in zip(times, [*times[1:], None], strict=True):
        index = torch.full((len(z),), now, device=z.device)
        eps = predict_eps(guidance, z, index, views, guidance_scale)
        a = alpha_bar[now]
        # z_t = sqrt(a) z + sqrt(1 - a) eps, solved for z.
        clean = (z - (1 - a).sqrt() * eps) / a.sqrt()
        if after is None:
            return clean
        # To the next level with the same eps: sigma_t = 0 adds no new noise, so a run repeats.
        b = alpha_bar[after]
        z = b.sqrt() * clean + (1 - b).sqrt() * eps
    return z
