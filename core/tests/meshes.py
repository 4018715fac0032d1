"""Small meshes for the renderer's tests, made in a few lines."""

import math

import torch
from jaxtyping import Float, Int
from torch import Tensor

Mesh = tuple[Float[Tensor, "v 3"], Int[Tensor, "f 3"]]


def grid_faces(rows: int, columns: int) -> Int[Tensor, "f 3"]:
    """Triangles of a rows x columns torus of quads, counter-clockwise."""
    i, j = torch.meshgrid(torch.arange(rows), torch.arange(columns), indexing="ij")
    i1, j1 = (i + 1) % rows, (j + 1) % columns
    a, b, c, d = (x.reshape(-1) for x in (i * columns + j, i * columns + j1, i1 * columns + j1,
                                          i1 * columns + j))  # fmt: skip
    return torch.cat([torch.stack([a, b, c], 1), torch.stack([a, c, d], 1)])


def torus(rows: int = 48, columns: int = 24, major: float = 0.6, minor: float = 0.25) -> Mesh:
    """A torus about the z axis."""
    u = torch.arange(rows) * (2 * math.pi / rows)
    v = torch.arange(columns) * (2 * math.pi / columns)
    u, v = torch.meshgrid(u, v, indexing="ij")
    r = major + minor * v.cos()
    verts = torch.stack([r * u.cos(), r * u.sin(), minor * v.sin()], -1).view(-1, 3)
    return verts, grid_faces(rows, columns).flip(1)


def sphere(levels: int = 3, radius: float = 0.8, bump: float = 0.0, noise: float = 0.0) -> Mesh:
    """An octahedron, split ``levels`` times; 8 * 4**levels faces."""
    verts = torch.tensor(
        [[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]], dtype=torch.float64
    )
    faces = torch.tensor(
        [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]]
    )
    for _ in range(levels):
        edges = torch.stack([faces, faces.roll(-1, 1)], -1).view(-1, 2).sort(1).values
        unique, index = edges.unique(dim=0, return_inverse=True)
        middle = index.view(-1, 3) + len(verts)
        verts = torch.cat([verts, verts[unique].mean(1)])
        a, b, c = faces.unbind(1)
        ab, bc, ca = middle.unbind(1)
        parts = ((a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca))
        faces = torch.cat([torch.stack(part, 1) for part in parts])
    verts = verts / verts.norm(dim=1, keepdim=True)
    generator = torch.Generator().manual_seed(0)
    waves = torch.randn(3, 8, generator=generator, dtype=torch.float64) * 4
    verts = verts * (1 + bump * torch.sin(verts @ waves).mean(1, keepdim=True) * 2)
    verts = verts * radius
    verts = verts + noise * torch.randn(verts.shape, generator=generator, dtype=torch.float64)
    return verts.float(), faces
