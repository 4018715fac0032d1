"""Points moved off the borders between a drawn solid's parts, into their own parts.

Γ learns colours from pictures of 64², where a border between two parts is a pixel or two wide, 6 %
of the object. The parts themselves are known in space, so a texel near a border takes the material
from a little farther inside its own part, and the border is as sharp as the texture.
"""

from collections.abc import Callable

import torch
import torch.nn.functional as F
from jaxtyping import Float, Int
from torch import Tensor

from core.geometry.tet_grid import EXTENT

CELLS = 80  # of the lattice on which the parts are known, along an edge
INSET = 0.06  # training units: what a picture's blur covers
STEPS = 3  # on the way; each looks anew where the border is
LEAST_SLOPE = 1e-3  # of the margin, below which there is no border near

Field = Callable[
    [Float[Tensor, "n 3"]], tuple[Float[Tensor, " n"], Float[Tensor, "n p"]]
]  # signed distance and the parts' logits, at points


class PartBorders:
    """Where the parts of one solid meet, on a lattice of its distances and logits."""

    def __init__(self, field: Field, cells: int = CELLS) -> None:
        self.spacing = 2 * EXTENT / cells
        side = torch.linspace(-EXTENT, EXTENT, cells + 1)
        nodes = torch.stack(torch.meshgrid(side, side, side, indexing="ij"), -1)
        distance, logits = field(nodes.view(-1, 3))
        values = torch.cat([distance[:, None], logits], 1)
        # grid_sample's first coordinate runs along the last axis.
        self.values = values.T.view(-1, cells + 1, cells + 1, cells + 1).permute(0, 3, 2, 1)[None]

    def inside(self, points: Float[Tensor, "n 3"]) -> Float[Tensor, "n 3"]:
        """Each point, or where it is near a border the place along the surface that is ``INSET``
        from the border, in the same part."""
        start = self._at(points)
        part, level = start[:, 1:].argmax(1), start[:, 0]
        moved = points
        for step in range(STEPS):
            margin, slope, normal = self._margin(moved, part)
            slope = slope - (slope * normal).sum(1, keepdim=True) * normal  # along the surface
            steep = slope.norm(dim=1, keepdim=True)
            away = margin[:, None] / steep.clamp_min(LEAST_SLOPE)
            way = (INSET - away).clamp(0, INSET) / (STEPS - step)
            moved = moved + torch.where(steep > LEAST_SLOPE, way * slope / steep, 0.0)
            # Back to the distance from the surface that the point had.
            moved = moved - (self._at(moved)[:, :1] - level[:, None]) * normal
        return moved

    def _margin(
        self, points: Float[Tensor, "n 3"], part: Int[Tensor, " n"]
    ) -> tuple[Float[Tensor, " n"], Float[Tensor, "n 3"], Float[Tensor, "n 3"]]:
        """How far the part's logit is above the others', that margin's gradient, and the surface's
        normal; by central differences."""
        taps = torch.eye(3).to(points) * self.spacing
        here = self._over(self._at(points), part)
        ahead = [self._over(self._at(points + tap), part) for tap in taps]
        behind = [self._over(self._at(points - tap), part) for tap in taps]
        slopes = torch.stack(ahead, 1) - torch.stack(behind, 1)  # (n, 3, 2)
        slope = slopes / (2 * self.spacing)
        normal = F.normalize(slope[..., 1], dim=1)
        return here[:, 0], slope[..., 0], normal

    @staticmethod
    def _over(values: Float[Tensor, "n c"], part: Int[Tensor, " n"]) -> Float[Tensor, "n 2"]:
        """The part's margin over the best of the others, and the distance."""
        logits = values[:, 1:]
        own = logits.gather(1, part[:, None])
        others = logits.scatter(1, part[:, None], -torch.inf).amax(1, keepdim=True)
        return torch.cat([own - others, values[:, :1]], 1)

    def _at(self, points: Float[Tensor, "n 3"]) -> Float[Tensor, "n c"]:
        """Distance and logits, trilinear."""
        at = (points / EXTENT)[None, None, None]
        found = F.grid_sample(self.values, at, align_corners=True, padding_mode="border")
        return found[0, :, 0, 0].T
