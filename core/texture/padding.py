"""Edge padding: every empty texel takes the colour of the nearest island.

"We utilize the edge padding technique" (§4.3, "Texturing"). Viewers look up bilinearly and in
smaller copies of the texture, so a background that is left anywhere shows as a seam.
"""

import numpy as np
import torch
from jaxtyping import Bool, Float, Int
from scipy.ndimage import distance_transform_edt
from torch import Tensor

from core.errors import UserError


def nearest_covered(covered: Bool[Tensor, "h w"]) -> Int[Tensor, " n"]:
    """For each empty texel, in the order of ``(~covered).nonzero()``, the flat index of the nearest
    covered one.

    Raises UserError where nothing is covered.
    """
    height, width = covered.shape
    if not bool(covered.any()):
        raise UserError(
            f"No texel of the {width} x {height} texture is on the surface.",
            "Use a larger --texture-size, or give a mesh whose UV map has an area.",
        )
    empty = ~covered.cpu().numpy()
    if not empty.any():
        return torch.zeros(0, dtype=torch.int64, device=covered.device)
    at = np.asarray(distance_transform_edt(empty, return_distances=False, return_indices=True))
    flat = at[0][empty].astype(np.int64) * width + at[1][empty]
    return torch.from_numpy(flat).to(covered.device)


def pad(
    image: Float[Tensor, "h w c"], covered: Bool[Tensor, "h w"], nearest: Int[Tensor, " n"]
) -> Float[Tensor, "h w c"]:
    """Fill the empty texels of ``image`` in place, ``nearest`` being :func:`nearest_covered`."""
    image[~covered] = image.view(-1, image.shape[-1])[nearest]
    return image
