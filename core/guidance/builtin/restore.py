"""Restored pictures: what a shape's own renders should look like.

A denoiser answers that by adding noise and removing it, which loses whatever the noise covered. The
restorer gets the render itself. It is the geometry network trained further: the render stands in
for a picture at the early time step ``TIME``, whose noise is the fit's softness, and
x_hat = sqrt(alpha_bar) z - sigma v (Salimans and Ho 2022, §4) is the restored picture. So it is an
input skip with a correction, and close to the identity where there is nothing to correct.
"""

import torch
from jaxtyping import Float, Int
from torch import Tensor

from core.guidance.builtin.diffusion import alpha_bar_schedule
from core.guidance.builtin.network import UNet

TIME = 50  # sigma 0.16. At 20 the correction's scale is too small to train, 100 starts further off


def restored(
    net: UNet,
    pictures: Float[Tensor, "b 4 s s"],
    words: Int[Tensor, "b n"],
    camera: Float[Tensor, "b 6 m m"],
) -> Float[Tensor, "b 4 s s"]:
    """Crisp pictures [n * o, 2o - 1] from soft ones; ``camera`` is ``camera_map`` at half the
    size."""
    # One fixed step, as the softness of a render is not known.
    t = torch.full((len(pictures),), TIME, device=pictures.device)
    a = alpha_bar_schedule()[TIME].to(pictures)
    return a.sqrt() * pictures - (1 - a).sqrt() * net(pictures, t, words, camera).float()


def as_render(pictures: Float[Tensor, "b 4 s s"]) -> Float[Tensor, "b 4 s s"]:
    """Restored pictures as a render would be: coverage in [0, 1], normals as long as it is.

    Where the network is unsure of a normal it comes out short, and a fit to it would be blunt.
    """
    coverage = ((pictures[:, 3:] + 1) / 2).clamp(0, 1)
    direction = torch.nn.functional.normalize(pictures[:, :3], dim=1, eps=1e-4)
    return torch.cat([direction * coverage, 2 * coverage - 1], 1)
