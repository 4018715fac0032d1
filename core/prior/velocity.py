"""v, the target that the prior's networks are trained to predict.

v = sqrt(alpha_bar) eps - sigma x with sigma = sqrt(1 - alpha_bar) (Salimans and Ho, "Progressive
Distillation", 2022, §4).
"""

from jaxtyping import Float
from torch import Tensor


def v_target(
    x: Float[Tensor, "b c h w"], eps: Float[Tensor, "b c h w"], alpha_bar: Float[Tensor, " b"]
) -> Float[Tensor, "b c h w"]:
    """The target v of the picture x with the noise eps."""
    a = alpha_bar[:, None, None, None]
    return a.sqrt() * eps - (1 - a).sqrt() * x


def x_from_v(
    v: Float[Tensor, "b c h w"], z_t: Float[Tensor, "b c h w"], alpha_bar: Float[Tensor, " b"]
) -> Float[Tensor, "b c h w"]:
    """The picture that v and z_t imply."""
    a = alpha_bar[:, None, None, None]
    return a.sqrt() * z_t - (1 - a).sqrt() * v
