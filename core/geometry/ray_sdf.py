"""The smallest SDF along the ray of each pixel: a mask that has a gradient in empty space.

A rendered silhouette moves only where there is surface. Sent through m = 2 sigmoid(-k min s) - 1
as well, the mask's score can grow a thin part out of nothing. Not in the paper; ours.
"""

import torch
from jaxtyping import Float, Int
from torch import Tensor
from torch.nn.functional import grid_sample

from core import kernels
from core.camera import Cameras
from core.geometry.tet_grid import TetGrid

# Eyes (b, 3), and of each of p rays its unit direction (b, p, 3), where it enters and leaves the
# lattice's cube, and its samples' shift (b, p).
Rays = tuple[Tensor, Tensor, Tensor, Tensor, Tensor]


def ray_min_sdf(
    sdf: Float[Tensor, " nt"],
    grid: TetGrid,
    cameras: Cameras,
    samples: int,
    shift: Float[Tensor, "b s s"],
) -> Float[Tensor, "b s s"]:
    """Smallest of ``samples`` trilinear values of the lattice along each ray, rows from the top.

    The samples are spaced evenly within the lattice's cube, moved on by ``shift``, 0 to 1, of a
    spacing; it is drawn at random for each ray, so that no place stays between the samples. The
    gradient goes through the smallest one. A ray that misses the cube takes the cube's nearest
    values. The nodes are taken where they were before their offsets.
    """
    size = shift.shape[-1]
    # The search needs no gradient: only the sample that it finds is evaluated again, with one.
    with torch.no_grad():
        eye, direction = pixel_rays(cameras, size)
        rays = (eye, direction, *_span(eye, direction, grid.extent), shift.to(eye).flatten(1))
        number = lowest_along(sdf, grid, rays, samples)
        nearest = _points(*rays, number[..., None], samples)
    return _trilinear(sdf, nearest, grid).view(len(cameras), size, size)


def lowest_along(
    sdf: Float[Tensor, " nt"], grid: TetGrid, rays: Rays, samples: int
) -> Int[Tensor, "b p"]:
    """Number of the sample that has each ray's smallest value."""
    if kernels.supports(sdf, *rays):
        return kernels.lowest_along(sdf.view(grid.shape), rays, grid.extent, samples)
    number = torch.arange(samples, device=sdf.device).expand(*rays[-1].shape, -1)
    return _trilinear(sdf, _points(*rays, number, samples), grid).argmin(-1)


def _points(
    eye: Float[Tensor, "b 3"],
    direction: Float[Tensor, "b p 3"],
    near: Float[Tensor, "b p"],
    far: Float[Tensor, "b p"],
    shift: Float[Tensor, "b p"],
    number: Int[Tensor, "b p m"],
    samples: int,
) -> Float[Tensor, "b p m 3"]:
    """The samples of these numbers on each ray."""
    along = (number + shift[..., None]) / samples
    depth = near[..., None] + (far - near)[..., None] * along
    return eye[:, None, None] + direction[:, :, None] * depth[..., None]


def pixel_rays(cameras: Cameras, size: int) -> tuple[Float[Tensor, "b 3"], Float[Tensor, "b p 3"]]:
    """Eyes, and unit directions through the pixel centres of a square picture, row by row."""
    half = (cameras.fovy / 2).tan()
    centre = (torch.arange(size, device=half.device, dtype=half.dtype) + 0.5) / size * 2 - 1
    y, x = torch.meshgrid(-centre, centre, indexing="ij")
    plane = torch.stack([x, y], -1).view(1, -1, 2) * half[:, None, None]
    in_camera = torch.cat([plane, -torch.ones_like(plane[..., :1])], -1)
    direction = in_camera @ cameras.rotation
    return cameras.eye, direction / direction.norm(dim=-1, keepdim=True)


def _span(
    eye: Float[Tensor, "b 3"], direction: Float[Tensor, "b p 3"], extent: float
) -> tuple[Float[Tensor, "b p"], Float[Tensor, "b p"]]:
    """Where each ray enters and leaves the cube; twice the middle of the two where it does not."""
    # A ray along a cube's side has an infinite slab, never 0 / 0.
    safe = torch.where(direction.abs() < 1e-9, 1e-9, direction)
    one, other = ((side - eye[:, None]) / safe for side in (-extent, extent))
    # The slab test: inside is where all three axes' intervals meet. Nothing behind the eye counts.
    near = torch.minimum(one, other).amax(-1).clamp(min=0)
    far = torch.maximum(one, other).amin(-1).clamp(min=0)
    middle = (near + far) / 2
    hit = near < far
    return torch.where(hit, near, middle), torch.where(hit, far, middle)


def _trilinear(
    sdf: Float[Tensor, " nt"], points: Float[Tensor, "b p m 3"], grid: TetGrid
) -> Float[Tensor, "b p m"]:
    # grid_sample's last axis runs along the volume's last: z, y, x here.
    volume = sdf.view(1, 1, *grid.shape)
    at = (points / grid.extent).flip(-1)[None]
    # The nodes are the voxels' centres, hence align_corners.
    return grid_sample(volume, at, padding_mode="border", align_corners=True)[0, 0]
