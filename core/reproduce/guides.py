"""Guide meshes, coarse on purpose: what a user blocks out in a minute. Metres, front -Y."""

import math
from pathlib import Path

import torch
from jaxtyping import Float, Int
from torch import Tensor

from core.errors import UserError
from core.geometry.mesh import Mesh
from core.io.atomic import disk_errors
from core.io.obj import write_plain_obj

Corner = tuple[float, float, float]
# Corners of a box count in binary: x + 2 y + 4 z. Counter-clockwise seen from outside.
BOX_FACES = (
    (0, 2, 3), (0, 3, 1), (4, 5, 7), (4, 7, 6), (0, 1, 5), (0, 5, 4),
    (2, 6, 7), (2, 7, 3), (0, 4, 6), (0, 6, 2), (1, 3, 7), (1, 7, 5),
)  # fmt: skip
ROOF_FACES = (
    (0, 1, 4),
    (2, 5, 3),
    (0, 2, 3),
    (0, 3, 1),
    (0, 4, 5),
    (0, 5, 2),
    (1, 3, 5),
    (1, 5, 4),
)


def box(low: Corner, high: Corner) -> Mesh:
    """A box between two corners."""
    corners = [[(low, high)[i >> axis & 1][axis] for axis in range(3)] for i in range(8)]
    return Mesh(torch.tensor(corners), torch.tensor(BOX_FACES))


def roof(low: Corner, high: Corner) -> Mesh:
    """A gable between two corners, its ridge along y."""
    (x0, y0, z0), (x1, y1, z1) = low, high
    ridge = (x0 + x1) / 2
    corners = [[x0, y0, z0], [x1, y0, z0], [x0, y1, z0], [x1, y1, z0]]
    verts = torch.tensor([*corners, [ridge, y0, z1], [ridge, y1, z1]])
    return Mesh(verts, torch.tensor(ROOF_FACES))


def ball(middle: Corner, radii: Corner, rings: int = 8) -> Mesh:
    """An ellipsoid of few faces."""
    columns = 2 * rings
    theta = torch.arange(1, rings) * (math.pi / rings)
    phi = torch.arange(columns) * (2 * math.pi / columns)
    theta, phi = (x.reshape(-1) for x in torch.meshgrid(theta, phi, indexing="ij"))
    unit = torch.stack([theta.sin() * phi.cos(), theta.sin() * phi.sin(), theta.cos()], -1)
    unit = torch.cat([unit, torch.tensor([[0.0, 0.0, 1.0], [0.0, 0.0, -1.0]])])
    verts = torch.tensor(middle) + torch.tensor(radii) * unit
    return Mesh(verts, _ball_faces(rings, columns))


def _ball_faces(rings: int, columns: int) -> Int[Tensor, "f 3"]:
    ring, count = torch.arange(columns), (rings - 1) * columns
    after, last = (ring + 1) % columns, count - columns
    start = torch.arange(rings - 2)[:, None] * columns
    a, b = (start + ring).reshape(-1), (start + after).reshape(-1)
    top = torch.stack([torch.full_like(ring, count), ring, after], 1)
    end = torch.stack([torch.full_like(ring, count + 1), last + after, last + ring], 1)
    c, d = a + columns, b + columns
    return torch.cat([top, torch.stack([a, c, d], 1), torch.stack([a, d, b], 1), end])


def joined(*parts: Mesh) -> Mesh:
    """One mesh of several closed ones, which may overlap."""
    starts = torch.tensor([0, *(len(part.verts) for part in parts)]).cumsum(0)
    faces = [part.faces + start for part, start in zip(parts, starts.tolist(), strict=False)]
    return Mesh(torch.cat([part.verts for part in parts]), torch.cat(faces))


def bus() -> Mesh:
    """A box, longer than it is high."""
    return box((-1.2, -4.0, 0.0), (1.2, 4.0, 2.8))


def person() -> Mesh:
    """A standing figure of six ellipsoids, its arms a little away from the body."""
    return joined(
        ball((0.0, 0.0, 1.0), (0.24, 0.17, 0.38)),
        ball((0.0, 0.0, 1.58), (0.14, 0.15, 0.19)),
        *(ball((side * 0.32, 0.0, 1.05), (0.09, 0.09, 0.36)) for side in (-1, 1)),
        *(ball((side * 0.13, 0.0, 0.38), (0.11, 0.12, 0.42)) for side in (-1, 1)),
    )


def seat() -> Mesh:
    """A chair of boxes: four thick legs, a seat, a high back."""
    legs = [(x, y) for x in (-0.3, 0.18) for y in (-0.3, 0.18)]
    return joined(
        *(box((x, y, 0.0), (x + 0.12, y + 0.12, 0.5)) for x, y in legs),
        box((-0.3, -0.3, 0.45), (0.3, 0.3, 0.57)),
        box((-0.3, 0.18, 0.5), (0.3, 0.3, 1.4)),
    )


def hut() -> Mesh:
    """Walls, a gable roof and a chimney."""
    return joined(
        box((-2.0, -2.6, 0.0), (2.0, 2.6, 2.2)),
        roof((-2.3, -2.9, 2.1), (2.3, 2.9, 4.2)),
        box((0.7, 0.5, 2.5), (1.3, 1.1, 4.8)),
    )


GUIDES = {"bus": bus, "person": person, "seat": seat, "hut": hut}


def guide_file(folder: Path, name: str) -> Path:
    """The file of the guide ``name`` in ``folder``, written unless it is there."""
    if name not in GUIDES:
        raise UserError(f"There is no guide mesh {name!r}.", f"Use one of {', '.join(GUIDES)}.")
    path = folder / f"{name}.obj"
    if not path.exists():
        with disk_errors(folder):
            folder.mkdir(parents=True, exist_ok=True)
        mesh = GUIDES[name]()
        write_plain_obj(path, mesh.verts, mesh.faces)
    return path


def triangle_volume(verts: Float[Tensor, "v 3"], faces: Int[Tensor, "f 3"]) -> float:
    """Signed volume of a closed mesh; positive where its faces look outwards."""
    a, b, c = verts[faces].unbind(1)
    return float((torch.linalg.cross(a, b) * c).sum() / 6)
