"""Softened renders, which the restoring network is trained to sharpen.

A fit leaves rounded edges, dented planes, shifted surfaces and lost thin parts. Two models of that
error, both random and both pure functions of a generator:

- ``soft_shape``: the solid itself on a lattice, blurred, dented and moved, so that all its views
  agree, like the views of a fitted shape.
- ``soft_pictures``: the picture blurred, warped and dented, silhouettes rounded. Cheap enough for
  every batch, so one rendered pair is seen in many forms.
"""

import math
from collections.abc import Callable
from dataclasses import dataclass

import torch
from jaxtyping import Float, Int
from torch import Tensor
from torch.nn.functional import (
    affine_grid,
    conv2d,
    conv3d,
    grid_sample,
    interpolate,
    normalize,
    pad,
)

from core.prior.draw import Draw

HALF = 1.06  # half the side of the lattice's cube, training units; objects reach to 1.0
CELLS = 56  # along an edge: nodes 0.038 apart, a draft's fine lattice has 0.033
CHUNK = 65536  # points in one evaluation of a solid
SAFETY = 0.75  # factor of a step: dents and blur make the lattice's values steeper than a distance


@dataclass(frozen=True)
class Softness:
    """One random model of a fit's error on a solid; lengths in training units."""

    blur: float  # standard deviation; a plate thinner than 1.6 of it vanishes
    shift: float  # the surface moved inwards (above 0) or outwards (below)
    dents: tuple[tuple[int, float], ...]  # nodes along an edge, slope in radians
    warp: float  # standard deviation of the low-frequency displacement


def draw_softness(draw: Draw) -> Softness:
    """From nearly exact to a draft's coarse geometry: mean normal error 2 to 30 degrees."""
    strength = draw(0, 1) ** 1.2  # the last rounds have mild ones
    blur = 0.006 + 0.11 * strength * draw(0.3, 1)
    return Softness(
        blur=blur,
        # Mostly outwards, as a growing fattens: blurred alone, legs and plates would vanish
        shift=draw(-0.75, 0.15) * blur + draw(-0.006, 0.006),
        dents=tuple((nodes, strength * draw(0, 0.2)) for nodes in (6, 11, 20)),
        warp=0.025 * strength * draw(0, 1),
    )


@dataclass(frozen=True)
class LatticeShape:
    """A solid as trilinear values on a lattice; ``core.prior.tracer.render`` takes it."""

    values: Float[Tensor, "1 1 z y x"]

    def sdf(self, points: Float[Tensor, "n 3"]) -> Float[Tensor, " n"]:
        """A distance that is safe for marching, negative inside."""
        at = (points / HALF)[None, None, None]
        sampled = grid_sample(self.values, at, align_corners=True, padding_mode="border")
        return SAFETY * sampled.view(-1)

    def part(self, points: Float[Tensor, "n 3"]) -> Int[Tensor, " n"]:
        """Zeros: the solid has one part."""
        return torch.zeros(len(points), dtype=torch.long)


def soft_shape(
    sdf: Callable[[Tensor], Tensor],
    soft: Softness,
    generator: torch.Generator,
    cells: int = CELLS,
) -> LatticeShape:
    """The solid ``sdf`` with the errors of a fit of softness ``soft``."""
    # WARP: the solid read at displaced nodes; x runs fastest, as grid_sample has it
    side = torch.linspace(-HALF, HALF, cells + 1)
    points = torch.stack(torch.meshgrid(side, side, side, indexing="ij"), -1)[..., [2, 1, 0]]
    if soft.warp > 0:
        field = soft.warp * noise_field(3, 5, len(side), generator)
        points = points + field[0].permute(1, 2, 3, 0)
    # BLUR: of the distances, which rounds edges and loses thin parts
    values = torch.cat([sdf(p) for p in points.view(-1, 3).split(CHUNK)])
    values = blur3(values.view(1, 1, *points.shape[:3]), soft.blur * cells / (2 * HALF))
    # DENTS: at three scales; a value added to the distance moves the surface by that value
    for nodes, slope in soft.dents:
        # A wave of length 4 node distances and slope s is s / k high.
        height = slope * (2 * HALF / nodes) * 4 / (2 * math.pi)
        values = values + height * noise_field(1, nodes, len(side), generator)
    return LatticeShape(values + soft.shift)


def noise_field(
    channels: int, nodes: int, size: int, generator: torch.Generator
) -> Float[Tensor, "1 c {size} {size} {size}"]:
    """Smooth noise of unit variance with ``nodes`` independent values along an edge."""
    rough = torch.randn(1, channels, nodes, nodes, nodes, generator=generator)
    even = interpolate(rough, size=(size,) * 3, mode="trilinear", align_corners=True)
    smooth = blur3(even, 0.35 * size / nodes)  # no creases at the nodes
    return smooth / smooth.std()


def blur3(field: Float[Tensor, "1 c z y x"], sigma: float) -> Float[Tensor, "1 c z y x"]:
    """Gaussian blur along all three axes; ``sigma`` in nodes."""
    kernel = gaussian(torch.tensor([sigma]), max(1, math.ceil(2.5 * sigma)))[0]
    reach, channels = len(kernel) // 2, field.shape[1]
    for axis in range(3):
        shape, sides = [1, 1, 1, 1, 1], [0] * 6
        shape[2 + axis] = len(kernel)
        sides[4 - 2 * axis] = sides[5 - 2 * axis] = reach
        weight = kernel.view(shape).expand(channels, -1, -1, -1, -1)
        field = conv3d(pad(field, sides, mode="replicate"), weight, groups=channels)
    return field


def gaussian(sigma: Float[Tensor, " b"], reach: int) -> Float[Tensor, "b k"]:
    """Normalised kernels of 2 ``reach`` + 1 taps."""
    at = torch.arange(-reach, reach + 1, device=sigma.device)
    kernel = torch.exp(-(at**2) / (2 * sigma[:, None].clamp_min(1e-3) ** 2))
    return kernel / kernel.sum(1, keepdim=True)


def soft_pictures(
    pictures: Float[Tensor, "b 4 s s"], strength: Float[Tensor, " b"], generator: torch.Generator
) -> Float[Tensor, "b 4 s s"]:
    """Pictures [n * o, 2o - 1] of a softer object; ``strength`` 0 changes nothing, 1 is up
    to 3.5 pixels of blur, 1.6 pixels of warp, dents of 14 degrees and fatter silhouettes."""
    count, _, size, _ = pictures.shape

    def uniform(low: float, high: float) -> Tensor:
        return low + (high - low) * torch.rand(count, generator=generator).to(pictures)

    def noise(channels: int, nodes: int) -> Tensor:
        rough = torch.randn(count, channels, nodes, nodes, generator=generator).to(pictures)
        return interpolate(rough, size=size, mode="bicubic", align_corners=True)

    strength = strength.to(pictures)
    amount = strength[:, None, None, None]
    # WARP: low-frequency shifts of the whole picture, of coverage and of normals
    nodes = int(torch.randint(4, 11, (1,), generator=generator))
    away = noise(2, nodes)
    away = away * (strength * uniform(0.1, 1.6) * 2 / size)[:, None, None, None]
    grid = affine_grid(
        torch.eye(2, 3).to(pictures).expand(count, 2, 3), [count, 1, size, size], False
    )
    both = torch.cat([pictures[:, :3], (pictures[:, 3:] + 1) / 2], 1)
    both = grid_sample(both, grid + away.permute(0, 2, 3, 1), align_corners=False)
    # BLUR: of normals weighted by coverage, so that the background adds nothing to their direction
    both = blur2(both, strength * uniform(0.4, 3.5))

    # The silhouette of a blurred solid is rounded and sharp again.
    steep = uniform(8, 16)[:, None, None, None]
    level = (0.5 - strength * uniform(-0.05, 0.3))[:, None, None, None]  # lower is fatter
    edge = torch.sigmoid((both[:, 3:] - level) * steep)
    coverage = torch.lerp(both[:, 3:], edge, amount.clamp(max=1))
    # DENTS: normals turned at random; the mean of blurred normals is short and is made unit first
    dents = noise(3, size // 8)
    dents = dents * (strength * uniform(0.02, 0.25))[:, None, None, None]
    length = both[:, :3].norm(dim=1, keepdim=True).clamp_max(1)
    normal = normalize(normalize(both[:, :3], dim=1, eps=1e-4) + dents, dim=1, eps=1e-4)
    weight = torch.lerp(length, coverage, amount.clamp(max=1))
    soft = torch.cat([normal * weight, 2 * coverage - 1], 1)
    # Strength 0 must change nothing, not even by resampling.
    return torch.where(amount > 0, soft, pictures)


def blur2(
    pictures: Float[Tensor, "b c h w"], sigma: Float[Tensor, " b"]
) -> Float[Tensor, "b c h w"]:
    """Gaussian blur, of its own ``sigma`` in pixels for each picture."""
    count, channels, height, width = pictures.shape
    kernel = gaussian(sigma, max(1, math.ceil(2.5 * float(sigma.max()))))
    reach = kernel.shape[1] // 2
    # One group for each channel of each picture: every picture has its own kernel in one
    # convolution.
    kernel = kernel.repeat_interleave(channels, 0)
    flat = pictures.reshape(1, count * channels, height, width)
    for shape, sides in (
        ((-1, 1, 1, 2 * reach + 1), (reach, reach, 0, 0)),
        ((-1, 1, 2 * reach + 1, 1), (0, 0, reach, reach)),
    ):
        flat = conv2d(
            pad(flat, sides, mode="replicate"), kernel.view(shape), groups=count * channels
        )
    return flat.view_as(pictures)
