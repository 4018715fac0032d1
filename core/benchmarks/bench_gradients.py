"""The renderer's gradient against finite differences of hard pictures of many times the size."""

import math
from dataclasses import dataclass
from typing import NamedTuple

import torch
from jaxtyping import Bool, Float, Int
from torch import Tensor

from core.benchmarks import ball, row
from core.camera import Cameras
from core.ops import normalize
from core.render.normals import render_normals, vertex_normals
from core.render.rasterizer import interpolate, rasterize, scatter

CAMERAS = Cameras.orbit([10.0, 130.0], [5.0, 40.0])
STEP = 0.02  # of the finite differences, on both sides
FUNCTIONS = 6


class Slope(NamedTuple):
    """How ours compares: the regression's slope (1 is right) and the relative error."""

    slope: float
    error: float


@dataclass(frozen=True)
class GradientError:
    """Errors of the mask, of the normals, and of the normals where no outline comes near.

    The first two against area averages. The last one against pictures of the same size: the area
    between the outlines is sampled at the pixels' centres in both.
    """

    outline: Slope
    normals: Slope
    interior: Slope


def deformed(verts: Float[Tensor, "v 3"], a: "Tensor | float") -> Float[Tensor, "v 3"]:
    """The shape as a one-parameter family: it swells in waves and moves."""
    way = torch.tensor([0.09, 0.06, -0.075])
    return verts * (1 + 0.3 * a * torch.sin(2 * verts[:, 1:2] + 1)) + a * way


@torch.no_grad()
def hard_picture(
    verts: Float[Tensor, "v 3"], faces: Int[Tensor, "f 3"], size: int, fine: int
) -> Float[Tensor, "b {size} {size} 4"]:
    """(n, o) drawn without antialias at ``fine`` and averaged down: independent of all blending."""
    smooth = vertex_normals(verts, faces)
    pictures = []
    for k in range(len(CAMERAS)):
        fragments = rasterize(verts, faces, CAMERAS[k : k + 1].mvp, fine, fine)
        normal = normalize(interpolate(smooth, fragments))
        values = torch.cat([normal, torch.ones_like(normal[:, :1])], 1)
        blocks = scatter(values, fragments).view(size, fine // size, size, -1, 4)
        pictures.append(blocks.mean((1, 3)))
    return torch.stack(pictures)


def gradient_error(
    verts: Float[Tensor, "v 3"],
    faces: Int[Tensor, "f 3"],
    size: int = 64,
    fine: int = 2048,
    places: int = 5,
) -> GradientError:
    """Ours against finite differences of pictures drawn hard at ``fine``.

    Compared are the derivatives, by the shape's parameter, of the pictures' means weighed by smooth
    random functions; ours are averaged over ``places`` within the step of the finite differences:
    a coarse picture's samples fall by chance next to the outlines.
    """
    ends = [deformed(verts, a) for a in (STEP, -STEP)]
    plus, minus = (hard_picture(end, faces, size, fine) for end in ends)
    plus_here, minus_here = (hard_picture(end, faces, size, size) for end in ends)
    generator = torch.Generator().manual_seed(0)
    coarse = torch.rand(FUNCTIONS * len(CAMERAS), 4, 4, 4, generator=generator)
    weight = torch.nn.functional.interpolate(coarse, (size, size), mode="bicubic")
    weight = weight.view(FUNCTIONS, len(CAMERAS), 4, size, size).permute(0, 1, 3, 4, 2)
    reach = 2 * math.ceil(size * STEP / 8) + 1  # how far an outline moves, in pixels
    near = outlines(ends[0], faces, plus_here) | outlines(ends[1], faces, minus_here)
    near = torch.nn.functional.max_pool2d(near.float(), reach, 1, reach // 2)
    inner = weight * (1 - near)[..., None]

    def sums(picture: Float[Tensor, "b s s 4"]) -> Float[Tensor, "n 3"]:
        """Those of the mask, the normals, and the normals inside."""
        n, o = (picture * weight).split((3, 1), -1)
        parts = (o, n, (picture * inner)[..., :3])
        return torch.stack([part.mean((1, 2, 3)).sum(-1) for part in parts], -1)

    expected = (sums(plus) - sums(minus)) / (2 * STEP)
    expected[:, 2] = (sums(plus_here) - sums(minus_here))[:, 2] / (2 * STEP)
    ours = torch.zeros_like(expected)
    for place in (torch.arange(places) + 0.5) / places * 2 - 1:
        a = (STEP * place).requires_grad_()
        picture = torch.cat(render_normals(deformed(verts, a), faces, CAMERAS, size), -1)
        leaf = picture.detach().requires_grad_()
        values = sums(leaf)
        for i in range(values.numel()):
            (to_picture,) = torch.autograd.grad(values.view(-1)[i], leaf, retain_graph=True)
            (found,) = torch.autograd.grad(picture, a, to_picture, retain_graph=True)
            ours.view(-1)[i] += found / places

    slopes = []
    for a, b in zip(ours.T, expected.T, strict=True):
        slopes.append(Slope(float(a @ b / (b @ b)), float((a - b).norm() / b.norm())))
    return GradientError(*slopes)


@torch.no_grad()
def outlines(
    verts: Float[Tensor, "v 3"], faces: Int[Tensor, "f 3"], hard: Float[Tensor, "b s s 4"]
) -> Bool[Tensor, "b s s"]:
    """The pixels that the antialias changed: an outline passes there, or next to them."""
    picture = torch.cat(render_normals(verts, faces, CAMERAS, hard.shape[1]), -1)
    return ((picture - hard).abs() > 1e-6).any(-1)


def two_balls() -> tuple[Tensor, Tensor]:
    """A small body in front of and next to a large one: it hides part of it from both cameras."""
    verts, faces = ball(8_000, bump=0.0)
    near = verts * 0.4 + torch.tensor([0.1, -1.0, 0.25])
    return torch.cat([verts, near]), torch.cat([faces, faces + len(verts)])


def meeting_balls() -> tuple[Tensor, Tensor]:
    """Two bodies that cut into each other."""
    verts, faces = ball(8_000, bump=0.0)
    verts = verts * 0.7
    way = torch.tensor([0.35, -0.2, 0.1])
    return torch.cat([verts - way, verts + way]), torch.cat([faces, faces + len(verts)])


def rows() -> list[dict]:
    """|slope - 1| and the relative error of each body; 0.02 is the target for both."""
    bodies = {f"{n:,} faces, {name}": ball(n, bump=bump)
              for n in (5_000, 20_000, 80_000)
              for name, bump in (("smooth", 0.0), ("bumpy", 0.05))}  # fmt: skip
    bodies |= {"one before the other": two_balls(), "one into the other": meeting_balls()}
    lines = []
    for name, (verts, faces) in bodies.items():
        turned = verts @ Cameras.orbit([25.0], [35.0]).rotation[0]  # edges that follow no grid
        for size in (64, 512):
            found = gradient_error(turned, faces, size, places=max(1600 // size, 5))
            for part, slope in vars(found).items():
                for what, value in (("slope off", abs(slope.slope - 1)), ("error", slope.error)):
                    lines.append(row(f"{name}, {size}², {part}, {what}", value, "", 0.02))
    return lines
