"""Sphere tracing of the families into the prior's pictures: a cheap substitute for the renderer.

Pixels and cameras are those of ``core.camera`` and ``core.render``: row 0 is the top, rays go
through pixel centres, normals are in the object's frame.
"""

from dataclasses import dataclass
from typing import Protocol, runtime_checkable

import torch
from jaxtyping import Float, Int
from torch import Tensor
from torch.nn.functional import normalize

from core.camera import Cameras
from core.prior.families import gradient

REACH = 1.0  # radius of the ball that holds every object, with its jitter
HIT = 1.5e-3  # distance that counts as the surface, training units
# Rays that graze a surface for more steps count as misses.
STEPS = 96


@runtime_checkable
class Solid(Protocol):
    """A solid that can be traced, such as ``core.prior.families.Shape``."""

    def sdf(self, points: Float[Tensor, "n 3"]) -> Float[Tensor, " n"]:
        """Signed distance or less, negative inside, training units."""
        ...

    def part(self, points: Float[Tensor, "n 3"]) -> Int[Tensor, " n"]:
        """Index of the part that is nearest."""
        ...


@dataclass(frozen=True)
class Pictures:
    """G-buffers of one object seen by several cameras."""

    normal: Float[Tensor, "b 3 s s"]  # object frame, premultiplied by coverage
    coverage: Float[Tensor, "b 1 s s"]
    part: Int[Tensor, "b s s"]  # index into the shape's parts; -1 is background
    point: Float[Tensor, "b 3 s s"]  # object space, mean over the covered samples


def rays(cameras: Cameras, size: int) -> tuple[Tensor, Tensor]:
    """Origins (B, 3) and unit directions (B, size², 3) through the pixels' centres."""
    # Cameras look along their own -Z, with +Y up; row 0 is the top.
    ndc = (torch.arange(size, dtype=torch.float32) + 0.5) / size * 2 - 1
    slope = (cameras.fovy / 2).tan()[:, None, None]
    x, y = (
        axis.expand(len(cameras), size, size) for axis in (ndc[None, None], -ndc[None, :, None])
    )
    if cameras.shift is not None:
        x, y = (axis - s[:, None, None] for axis, s in zip((x, y), cameras.shift.T, strict=True))
    x, y = x * slope, y * slope
    local = torch.stack([x, y, -torch.ones_like(x)], -1).flatten(1, 2)
    return cameras.eye, normalize(local @ cameras.rotation, dim=-1)


def trace(shape: Solid, origin: Tensor, direction: Tensor, start: Tensor | None = None) -> Tensor:
    """Distance along each ray (N,) to the surface; infinite where it misses.

    ``start`` (N,): the distances up to which the rays are known to be free; infinite where they
    miss.
    """
    near, end = _within_reach(origin, direction)
    t = near if start is None else torch.maximum(near, start)
    hit = torch.full_like(t, torch.inf)
    # Only rays on their way are evaluated: most hit or leave within a few steps.
    alive = (t < end).nonzero().squeeze(1)
    for _ in range(STEPS):
        if len(alive) == 0:
            break
        d = shape.sdf(origin[alive] + t[alive, None] * direction[alive])
        t[alive] += d
        found = d < HIT
        hit[alive[found]] = t[alive[found]]
        alive = alive[~found & (t[alive] < end[alive])]
    return hit


def _within_reach(origin: Tensor, direction: Tensor) -> tuple[Tensor, Tensor]:
    """The distances at which rays enter and leave the ball around every object; infinity and zero
    for rays that miss it."""
    middle = -(origin * direction).sum(1)
    square = REACH**2 - (origin**2).sum(1) + middle**2
    half = square.clamp_min(0).sqrt()
    inside = square > 0
    return torch.where(inside, middle - half, torch.inf), torch.where(inside, middle + half, 0.0)


def free_lengths(
    shape: Solid, cameras: Cameras, size: int, block: int = 4
) -> Float[Tensor, "b {size} {size}"]:
    """The distance up to which each pixel's ray is certainly free; infinite where it misses.

    One cone for each ``block``² pixels is marched (Crassin's cone marching): the pixels' rays are
    within ``wide`` t of its axis at t, so a ball of radius d about the axis frees them up to
    (t + d) / (1 + wide).
    """
    eye, direction = rays(cameras, size // block)
    origin = eye[:, None].expand_as(direction).reshape(-1, 3)
    direction = direction.reshape(-1, 3)
    # Half of a block's diagonal, on the plane at distance 1; the widest camera's holds for all.
    pitch = 2 * (cameras.fovy.max() / 2).tan() / size
    wide = (pitch * block * 2**-0.5).item()
    distance = origin.norm(dim=1)
    # A little before the ball, since a cone enters it before its axis does.
    t = distance - REACH - 0.1
    end = distance + REACH
    free = torch.full_like(t, torch.inf)
    alive = torch.arange(len(t))
    for _ in range(STEPS // 3):
        d = shape.sdf(origin[alive] + t[alive, None] * direction[alive])
        ahead = (t[alive] + d) / (1 + wide)
        # The cone touches something: from here each pixel's ray goes on alone.
        stuck = ahead < t[alive] + 2 * HIT
        free[alive[stuck]] = t[alive[stuck]]
        t[alive] = ahead
        alive = alive[~stuck & (ahead < end[alive])]
    # The steps are used up: these are free as far as they came.
    free[alive] = t[alive]
    square = free.view(len(cameras), size // block, size // block)
    return square.repeat_interleave(block, 1).repeat_interleave(block, 2)


def render(shape: Solid, cameras: Cameras, size: int = 64, samples: int = 2) -> Pictures:
    """The object's pictures, averaged over ``samples``² rays a pixel."""
    # RAYS: marched by cones first, which frees most of their way at a 16th of the rays
    fine = size * samples
    eye, direction = rays(cameras, fine)
    origin = eye[:, None].expand_as(direction).reshape(-1, 3)
    direction = direction.reshape(-1, 3)
    depth = trace(shape, origin, direction, free_lengths(shape, cameras, fine).flatten())
    covered = depth.isfinite().nonzero().squeeze(1)
    points = origin[covered] + depth[covered, None] * direction[covered]

    count = len(cameras)
    # AVERAGES: of normals, coverage and points, zero where nothing is hit: so they come out
    # weighted
    buffer = torch.zeros(count * fine * fine, 7)
    buffer[covered] = torch.cat(
        [gradient(shape.sdf, points), torch.ones(len(points), 1), points], 1
    )
    mean = torch.nn.functional.avg_pool2d(
        buffer.view(count, fine, fine, 7).permute(0, 3, 1, 2), samples
    )
    # PARTS: an index has no average
    part = torch.full((count * fine * fine,), -1)
    part[covered] = shape.part(points)
    blocks = part.view(count, size, samples, size, samples)
    nearest = blocks.amax((2, 4))  # any covered sample's part, so that a thin edge has one
    coverage = mean[:, 3:4]
    point = mean[:, 4:] / coverage.clamp_min(1e-6)
    return Pictures(mean[:, :3], coverage, nearest, point)
