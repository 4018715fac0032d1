"""Small closed meshes, with and without uv, for the tests of textures and assets."""

import math

import torch
from torch import Tensor

from core.appearance.material import Material
from core.appearance.material_ranges import MaterialRanges
from core.guidance.guidance import Area, Surface

OPEN = MaterialRanges((0.05, 0.95), (0.0, 1.0))


def area(plain: bool = True, surface: Surface | None = None) -> Area:
    """What is meant by an area where nothing else matters."""
    return Area(plain, OPEN, surface or Surface("plain", (0.5, 0.5, 0.5)))


def torus(
    n: int = 24, m: int = 12, radius: float = 0.6, tube: float = 0.25
) -> tuple[Tensor, Tensor]:
    """Welded verts (n m, 3) and faces (2 n m, 3), outward; bumpy: no turn maps it to itself."""
    i, j = torch.meshgrid(torch.arange(n), torch.arange(m), indexing="ij")
    a, b = 2 * torch.pi * i / n, 2 * torch.pi * j / m
    r = tube * (1 + 0.2 * torch.sin(3 * a + 1) + 0.1 * torch.cos(2 * b))
    ring = radius + r * torch.cos(b)
    verts = torch.stack([ring * torch.cos(a), ring * torch.sin(a), r * torch.sin(b)], -1)
    at = lambda p, q: (p % n) * m + q % m  # noqa: E731
    corners = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]
    p, q, s, t = (c.reshape(-1) for c in corners)
    return verts.reshape(-1, 3), torch.cat([torch.stack([p, q, s], -1), torch.stack([p, s, t], -1)])


def torus_uv(n: int = 24, m: int = 12, margin: float = 0.06) -> tuple[Tensor, Tensor]:
    """One island for :func:`torus`, cut along both rings, ``margin`` away from the border."""
    i, j = torch.meshgrid(torch.arange(n + 1), torch.arange(m + 1), indexing="ij")
    uv = torch.stack([i / n, j / m], -1).reshape(-1, 2) * (1 - 2 * margin) + margin
    i, j = torch.meshgrid(torch.arange(n), torch.arange(m), indexing="ij")
    at = lambda p, q: (p * (m + 1) + q).reshape(-1)  # noqa: E731
    p, q, s, t = at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)
    return uv, torch.cat([torch.stack([p, q, s], -1), torch.stack([p, s, t], -1)])


def square() -> tuple[Tensor, Tensor, Tensor, Tensor]:
    """A metre's square facing -Y, x and z from 0 to 1, with uv = (x, z)."""
    verts = torch.tensor([[0.0, 0, 0], [1, 0, 0], [1, 0, 1], [0, 0, 1]])
    faces = torch.tensor([[0, 1, 2], [0, 2, 3]])
    return verts, faces, verts[:, [0, 2]].clone(), faces.clone()


def smooth_material(points: Tensor) -> Material:
    """A material that changes slowly with position."""
    kd = 0.5 + 0.3 * torch.sin(3 * points + torch.tensor([0.0, 1.0, 2.0]))
    kn = torch.nn.functional.normalize(
        torch.cat([0.3 * torch.sin(2 * points[:, :2]), torch.ones_like(points[:, :1])], -1), dim=-1
    )
    roughness = 0.5 + 0.2 * torch.sin(points[:, :1])
    return Material(kd, roughness, (0.5 + 0.4 * torch.cos(2 * points[:, 1:2])), kn)


def one_material(kd: tuple[float, float, float]) -> "callable":
    """The same material everywhere."""

    def material(points: Tensor, _area: Tensor | None = None) -> Material:
        ones = torch.ones_like(points[:, :1])
        return Material(
            ones * torch.tensor(kd), 0.3 * ones, 0.2 * ones, torch.tensor([[0.0, 0, 1]]) * ones
        )

    return material


def moebius(columns: int, rows: int) -> tuple[Tensor, Tensor]:
    """A strip with a single side, about the z axis: vertices and faces."""
    u = (torch.arange(columns) * (2 * math.pi / columns))[:, None]
    w = torch.linspace(-0.3, 0.3, rows + 1)[None]
    r = 1 + w * (u / 2).cos()
    verts = torch.stack([r * u.cos(), r * u.sin(), w * (u / 2).sin()], -1).view(-1, 3)
    number = torch.arange(len(verts)).view(columns, rows + 1)
    following = torch.cat([number[1:], number[:1].flip(1)])  # the strip's end is turned over
    a, b = number[:, :-1], number[:, 1:]
    c, d = following[:, :-1], following[:, 1:]
    faces = [torch.stack(face, -1).view(-1, 3) for face in ((a, b, d), (a, d, c))]
    return verts, torch.cat(faces)
