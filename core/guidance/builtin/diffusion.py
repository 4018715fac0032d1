"""The prior's forward process and its v-parametrisation.

v = sqrt(alpha_bar) eps - sigma x with sigma = sqrt(1 - alpha_bar) (Salimans and Ho, "Progressive
Distillation", 2022, §4); ``core.guidance.sds`` has ``add_noise`` and ``eps_from_v``. The schedule
is the cosine one (Nichol and Dhariwal, 2021), its log-SNR moved down as "simple diffusion"
(Hoogeboom et al., 2023, §3.1) does for larger pictures: smooth pictures need more noise before
their layout is in doubt.
"""

import torch
from jaxtyping import Float
from torch import Tensor

TIMES = 1000
SHIFT = 0.5  # factor on sqrt(SNR)
LOWEST = -9.0  # log-SNR of the last step: nearly pure noise


def alpha_bar_schedule(times: int = TIMES) -> Float[Tensor, " t"]:
    """alpha_bar for t = 0 … times - 1."""
    u = (torch.arange(times, dtype=torch.float64) + 0.5) / times
    log_snr = -2 * (u * torch.pi / 2).tan().log() + 2 * torch.tensor(SHIFT).log()
    return log_snr.clamp_min(LOWEST).sigmoid().float()


def v_target(x: Tensor, eps: Tensor, alpha_bar: Float[Tensor, " b"]) -> Tensor:
    """What the network predicts."""
    a = alpha_bar[:, None, None, None]
    return a.sqrt() * eps - (1 - a).sqrt() * x


def x_from_v(v: Tensor, z_t: Tensor, alpha_bar: Float[Tensor, " b"]) -> Tensor:
    """The picture that v and z_t imply."""
    a = alpha_bar[:, None, None, None]
    return a.sqrt() * z_t - (1 - a).sqrt() * v
