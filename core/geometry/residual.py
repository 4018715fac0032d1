"""A lattice of values added to Ψ: detail that its few Fourier features are too smooth for.

Not in the paper, whose hash grid has such values itself (16 levels of them); ours. Ψ alone finds
the shape, since its smoothness carries it over what the pictures leave open; then each node of the
fine lattice may differ from it, as in DMTet without a network (Shen et al. 2021, §3.1).
"""

import torch
from jaxtyping import Float
from torch import Tensor, nn


class Residual(nn.Module):
    """SDF and offset, trilinear between the nodes of a lattice over [-extent, extent]³; 0 first.

    What is trained is blurred before it is read. Adam moves each value by its rate, whichever way
    the noise of the few pictures of a step points; the blur takes off what neighbours disagree in,
    and leaves what they do together (the idea of Nicolet et al. 2021, "Large Steps in Inverse
    Rendering of Geometry", where a Laplacian does it).
    """

    def __init__(self, resolution: int, extent: float, scale: float) -> None:
        """``resolution``: cubes along an axis. ``scale``: of the values; Adam moves each of them by
        about its rate a step, so this sets how fast the residual is compared with Ψ."""
        super().__init__()
        self.resolution, self.extent, self.scale = resolution, extent, scale
        self.values = nn.Parameter(torch.zeros(1, 4, *(resolution + 1,) * 3))

    @property
    def cell(self) -> float:
        """Length of a cube's side."""
        return 2 * self.extent / self.resolution

    def forward(self, points: Float[Tensor, "n 3"]) -> Float[Tensor, "n 4"]:
        return self.scale * read_lattice(blurred(self.values), points, self.extent)


def lattice_nodes(resolution: int, extent: float) -> Float[Tensor, "n 3"]:
    """The nodes of a lattice over [-extent, extent]³, as a volume (x, y, z) runs, z fastest."""
    axis = torch.linspace(-extent, extent, resolution + 1)
    return torch.stack(torch.meshgrid(axis, axis, axis, indexing="ij"), -1).view(-1, 3)


def read_lattice(
    values: Float[Tensor, "1 c x y z"], points: Float[Tensor, "n 3"], extent: float
) -> Float[Tensor, "n c"]:
    """Values of a lattice over [-extent, extent]³ at points, trilinear between its nodes."""
    # grid_sample's last axis runs along the volume's last: z, y, x here.
    at = (points / extent).flip(-1)[None, None, None]
    found = nn.functional.grid_sample(values, at, padding_mode="border", align_corners=True)
    return found[0, :, 0, 0].T


def blurred(values: Float[Tensor, "1 c x y z"]) -> Float[Tensor, "1 c x y z"]:
    """The binomial mean (1, 2, 1) / 4 along each axis; values go on beyond the rim."""
    # The kernel is a product over the axes: three passes of 3 taps instead of 27 taps.
    for axis in (2, 3, 4):
        last = values.shape[axis] - 1
        before = torch.cat([values.narrow(axis, 0, 1), values.narrow(axis, 0, last)], axis)
        after = torch.cat([values.narrow(axis, 1, last), values.narrow(axis, last, 1)], axis)
        values = values / 2 + (before + after) / 4
    return values
