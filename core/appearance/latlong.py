"""Pictures of the sphere of directions: lat-long (equirectangular) maps of light.

Row 0 is the zenith (+Z). The middle column looks along +X, the one at a quarter of the width along
+Y, the seam along -X, as in Blender's Environment Texture node. A texel represents its patch of the
sphere, and sums weigh it by that patch's solid angle, so they do not depend on the map's size.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass, replace

import torch
from jaxtyping import Float
from torch import Tensor
from torch.nn.functional import grid_sample

Kernel = Callable[[Tensor], Tensor]  # weight by the cosine to the lobe's axis


def directions(height: int, width: int) -> Float[Tensor, "{height} {width} 3"]:
    """Unit vectors through the texels' middles."""
    theta = (torch.arange(height) + 0.5) * (math.pi / height)
    phi = (0.5 - (torch.arange(width) + 0.5) / width) * (2 * math.pi)
    theta, phi = torch.meshgrid(theta, phi, indexing="ij")
    return torch.stack([theta.sin() * phi.cos(), theta.sin() * phi.sin(), theta.cos()], -1)


def to_uv(direction: Float[Tensor, "*b 3"]) -> Float[Tensor, "*b 2"]:
    """Where a direction is on the map: column and row as fractions in [0, 1], from the top left.

    Inverse of :func:`directions`. Finite gradient everywhere, zero at the poles.
    """
    x, y, z = direction.unbind(-1)
    # At the poles atan2 has no gradient. Both sides of ``where`` must be finite: a gradient of NaN
    # times 0 is still NaN.
    squared = x * x + y * y
    polar = squared < 1e-12
    x, squared = torch.where(polar, 1, x), torch.where(polar, 1e-12, squared)
    u = 0.5 - torch.atan2(torch.where(polar, 0, y), x) / (2 * math.pi)
    return torch.stack([u, torch.atan2(squared.sqrt(), z) / math.pi], -1)


def solid_angles(height: int, width: int) -> Float[Tensor, "{height} 1"]:
    """Solid angle of a texel in each row, steradians; exact."""
    # In float64: the cosines' differences near the poles would cancel.
    edge = torch.cos(torch.linspace(0, math.pi, height + 1, dtype=torch.float64))
    return ((edge[:-1] - edge[1:]) * (2 * math.pi / width)).float()[:, None]


def resample(image: Float[Tensor, "h w c"], height: int, width: int) -> Float[Tensor, "i j c"]:
    """The mean of ``image`` over each texel of another grid, by solid angle; exact."""
    if image.shape[:2] == (height, width):
        return image
    # Separable: rows by their cosine, in which solid angle is even, columns by the angle.
    rows = overlap(*(torch.cos(edges(n) * math.pi) for n in (height, image.shape[0])))
    # Negated, since ``overlap`` wants edges that run downwards.
    columns = overlap(*(-edges(n) for n in (width, image.shape[1])))
    half = torch.tensordot(rows.to(image), image, 1)
    return torch.einsum("jw,hwc->hjc", columns.to(image), half)


def edges(n: int) -> Float[Tensor, " {n}+1"]:
    """n + 1 even steps from 0 to 1, in float64."""
    return torch.linspace(0, 1, n + 1, dtype=torch.float64)


def overlap(target: Float[Tensor, " m"], source: Float[Tensor, " n"]) -> Float[Tensor, "i j"]:
    """The fraction of each target interval in each source interval; edges run downwards."""
    high = torch.minimum(target[:-1, None], source[None, :-1])
    low = torch.maximum(target[1:, None], source[None, 1:])
    return (high - low).clamp(min=0) / (target[:-1] - target[1:])[:, None]


def convolve(image: Float[Tensor, "h w 3"], kernel: Kernel) -> Float[Tensor, "h w 3"]:
    """The mean of ``image`` around every texel, weighted by ``kernel``; a sum over all texels.

    Around the axis of the poles this is a circular convolution of each pair of rows, a product
    after a Fourier transform. The kernel should be wider than a texel.
    """
    height, width, _ = image.shape
    area = solid_angles(height, width)
    theta = (torch.arange(height) + 0.5) * (math.pi / height)
    sine, cosine = theta.sin(), theta.cos()
    turn = torch.cos(torch.arange(width // 2 + 1) * (2 * math.pi / width))
    # (frequency, row, real and imaginary parts of three colours)
    source = torch.view_as_real(torch.fft.rfft(image * area[:, None], dim=1))
    # Both parts as columns of one real matrix: the kernel's transform is real.
    source = source.permute(1, 0, 2, 3).flatten(2)
    # Seen from below the rows are the same upside down: the lower half's kernel is the upper's.
    source = torch.cat([source, source.flip(1)], -1)
    upper, lower = [], []
    # The kernel between all pairs of rows is height² x width / 2 values: only some rows at a time.
    half = torch.arange((height + 1) // 2)
    for rows in half.split(max(1, (1 << 21) // (height * width))):
        level = cosine[rows, None] * cosine
        # The spherical law of cosines; the turn is that between two texels' azimuths.
        cos = sine[rows, None, None] * sine[:, None] * turn + level[..., None]
        weight = kernel(cos.clamp(-1, 1))
        # Even in the turn, so that its transform is real.
        weight = torch.cat([weight, weight[..., 1 : (width + 1) // 2].flip(-1)], -1)
        weight = torch.fft.rfft(weight).real.permute(2, 0, 1)
        # Frequency 0 sums a row, so this is the kernel's whole weight: the mean is exact for any
        # kernel.
        total = weight[0] @ area
        summed = torch.bmm(weight, source).unflatten(2, (2, 3, 2)).permute(2, 1, 0, 3, 4)
        row = torch.fft.irfft(torch.view_as_complex(summed.contiguous()), n=width, dim=2)
        for part, found in zip((upper, lower), row / total[:, None], strict=True):
            part.append(found)
    return torch.cat([*upper, torch.cat(lower)[: height // 2].flip(0)])


@dataclass(frozen=True)
class Levels:
    """A stack of lat-long maps of different sizes, read smoothly in direction and level.

    They are in one picture one below another, each with a border of its neighbours across the seam
    and the poles, so that bilinear reading is right everywhere.
    """

    picture: Float[Tensor, "1 channels rows columns"]
    places: Float[Tensor, "levels 3"]  # width, height, first row
    azimuth: float = 0.0  # the light is turned by this, counter-clockwise from above, radians

    @classmethod
    def of(cls, maps: list[Float[Tensor, "_ _ c"]]) -> "Levels":
        """Packs the maps; level k is maps[k]."""
        width = max(image.shape[1] for image in maps) + 2
        strips, places, row = [], [], 0
        for image in maps:
            h, w, c = image.shape
            # Across a pole is the same row, half a turn further.
            beyond = image[[0, -1]].roll(w // 2, dims=1)
            framed = torch.cat([beyond[:1], image, beyond[1:]])
            framed = torch.cat([framed[:, -1:], framed, framed[:, :1]], 1)
            strips.append(torch.cat([framed, framed.new_zeros(h + 2, width - w - 2, c)], 1))
            places.append([w, h, row])
            row += h + 2
        picture = torch.cat(strips).permute(2, 0, 1)[None].contiguous()
        return cls(picture, torch.tensor(places, dtype=torch.float32, device=picture.device))

    def to(self, device: "torch.device | str") -> "Levels":
        """The same on ``device``."""
        return Levels(self.picture.to(device), self.places.to(device), self.azimuth)

    def rotated(self, azimuth: float) -> "Levels":
        """Turned further about the vertical; shares the picture."""
        return replace(self, azimuth=self.azimuth + azimuth)

    def read(
        self, direction: Float[Tensor, "p 3"], level: Float[Tensor, " p"] | None = None
    ) -> Float[Tensor, "p c"]:
        """Bilinear in direction (not necessarily of unit length), linear between levels.

        ``None`` reads level 0. Levels beyond the ends read the ends.
        """
        uv = to_uv(direction)
        u = (uv[:, 0] + self.azimuth / (2 * math.pi)) % 1
        if level is None:
            return self.sample(u, uv[:, 1], torch.zeros_like(u, dtype=torch.int64))
        level = level.clamp(0, len(self.places) - 1)
        # Which two maps are read has no gradient; ``fraction`` carries it. The last level is the
        # upper one of a pair, so that ``above`` exists.
        base = level.detach().floor().clamp(max=max(len(self.places) - 2, 0))
        fraction = (level - base)[:, None]
        index = base.long()
        above = (index + 1).clamp(max=len(self.places) - 1)
        low, high = self.sample(u, uv[:, 1], index), self.sample(u, uv[:, 1], above)
        return torch.lerp(low, high, fraction)

    def sample(self, u: Tensor, v: Tensor, index: Tensor) -> Tensor:
        """Bilinear within the given levels; u and v in [0, 1]."""
        width, height, row = self.places.to(u)[index].unbind(1)
        # Past the border of one texel, then to grid_sample's [-1, 1] over the whole picture.
        x = (u * width + 1) * (2 / self.picture.shape[3]) - 1
        y = (v * height + 1 + row) * (2 / self.picture.shape[2]) - 1
        place = torch.stack([x, y], -1)[None, None]
        return grid_sample(self.picture.to(u), place, align_corners=False)[0, :, 0].t()
