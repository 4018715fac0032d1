"""The built-in prior's forward process.

The schedule is the cosine one (Nichol and Dhariwal, 2021), its log-SNR moved down as "simple
diffusion" (Hoogeboom et al., 2023, §3.1) does for larger pictures: smooth pictures need more noise
before their layout is in doubt. ``core.guidance.sds`` has ``add_noise`` and ``eps_from_v``.
"""

import torch
from jaxtyping import Float
from torch import Tensor

TIMES = 1000
SHIFT = 0.5  # factor on sqrt(SNR)
LOWEST = -9.0  # log-SNR of the last step: nearly pure noise


def alpha_bar_schedule(times: int = TIMES) -> Float[Tensor, " t"]:
    """alpha_bar for t = 0 … times - 1."""
    # At the steps' centres: at u = 0 and u = 1 the log-SNR is infinite.
    u = (torch.arange(times, dtype=torch.float64) + 0.5) / times
    # alpha_bar = cos²(π u / 2) has the log-SNR -2 log tan(π u / 2).
    log_snr = -2 * (u * torch.pi / 2).tan().log() + 2 * torch.tensor(SHIFT).log()
    return log_snr.clamp_min(LOWEST).sigmoid().float()
