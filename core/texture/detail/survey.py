"""Points all over a surface, the same for the same mesh."""

import numpy as np
import torch
from jaxtyping import Float, Int
from torch import Tensor


def spread(
    verts: Float[Tensor, "v 3"], faces: Int[Tensor, "f 3"], count: int
) -> tuple[Int[Tensor, " {count}"], Float[Tensor, "{count} 3"]]:
    """Face and weights of its corners of ``count`` points, evenly by area."""
    a, b, c = verts.cpu().double()[faces.cpu()].unbind(1)
    area = torch.linalg.cross(b - a, c - a).norm(dim=1).numpy().cumsum()
    i = np.arange(count)
    face = np.searchsorted(area, (i + 0.5) / count * area[-1]).clip(max=len(area) - 1)
    # The root makes them uniform over the triangle (Osada et al. 2002). Multiples of irrational
    # numbers (M. Roberts' R2 sequence) spread like random numbers and never change.
    r, s = np.sqrt((0.7548776662466927 * i) % 1), (0.5698402909980532 * i) % 1
    bary = np.stack([1 - r, r * (1 - s), r * s], 1)
    return torch.from_numpy(face), torch.from_numpy(bary).to(verts)
