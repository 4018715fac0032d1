"""Which noun a mesh looks like: Chamfer distance to held-out shapes of all nouns.

The distance is the mean over both clouds of the distance to the other's nearest point (Fan et al.,
2017, without the squares), the least over rotations about the vertical: a turned mesh still shows
the same noun.
"""

import hashlib
from pathlib import Path

import torch
from jaxtyping import Float, Int
from safetensors import safe_open
from safetensors.torch import save_file
from torch import Tensor

from core.geometry.mesh import NORMAL_RADIUS, face_areas
from core.guidance.builtin import stretch
from core.io.atomic import atomic_file
from core.prior import draw, families, solids, things
from core.prior.draw import Draw
from core.prior.families import build, surface_points

POINTS = 384
TURNS = 24
SCREEN_POINTS = 96  # points of each cloud, to find which nouns are far
NEAR = 24  # nouns that all points are compared with
REFERENCES = 4  # held-out shapes of each noun
SEED = 2_000_000  # beyond the seeds of the data and of ``evaluate``
KEPT = Path("out/bench_prior/references.safetensors")  # takes minutes to make

Cloud = Float[Tensor, "n 3"]


def reference_clouds(nouns: list[str], count: int = REFERENCES) -> dict[str, list[Cloud]]:
    """Points of ``count`` objects of each noun, in the frame of ``normalised``."""
    clouds = {}
    for noun in nouns:
        draw = Draw(torch.Generator().manual_seed(SEED))
        shapes = [build(noun, "", draw, jitter=0.0) for _ in range(count)]
        clouds[noun] = [_some(surface_points(shape.sdf, 2.4), draw.generator) for shape in shapes]
    return clouds


def kept_clouds(nouns: list[str], path: Path = KEPT) -> dict[str, list[Cloud]]:
    """``reference_clouds``, from the file if the families have not changed since it was written."""
    state = _state(nouns)
    if path.is_file():
        with safe_open(path, "pt") as kept:
            if (kept.metadata() or {}).get("state") == state:
                return {noun: list(kept.get_tensor(noun)) for noun in nouns}
    clouds = reference_clouds(nouns)
    path.parent.mkdir(parents=True, exist_ok=True)
    with atomic_file(path) as part:
        save_file({noun: torch.stack(c) for noun, c in clouds.items()}, part, {"state": state})
    return clouds


def _state(nouns: list[str]) -> str:
    """A hash of everything that determines the clouds: the nouns, and the families' modules."""
    found = hashlib.sha256("\n".join(nouns).encode())
    modules = [Path(str(module.__file__)) for module in (draw, families, solids, stretch)]
    for file in [Path(__file__), *modules, *sorted(Path(things.__path__[0]).rglob("*.py"))]:
        found.update(file.read_bytes())
    return found.hexdigest()


def mesh_cloud(
    verts: Float[Tensor, "v 3"],
    faces: Int[Tensor, "f 3"],
    generator: torch.Generator,
    count: int = POINTS,
) -> Float[Tensor, "{count} 3"]:
    """Points uniform over the surface, in the frame of the references."""
    low, high = verts.amin(0), verts.amax(0)
    verts = verts - (low + high) / 2
    verts = verts * (NORMAL_RADIUS / verts.norm(dim=1).max())
    face = torch.multinomial(face_areas(verts, faces), count, True, generator=generator)
    s, t = torch.rand(2, count, 1, generator=generator)
    s = s.sqrt()
    a, b, c = verts[faces[face]].unbind(1)
    return (1 - s) * a + s * (1 - t) * b + s * t * c


def _some(points: Tensor, generator: torch.Generator) -> Tensor:
    return points[torch.randperm(len(points), generator=generator)[:POINTS]]


def turns(cloud: Cloud, count: int = TURNS) -> Float[Tensor, "t n 3"]:
    """The cloud turned about +Z by ``count`` even angles."""
    angle = torch.arange(count)[:, None] * (2 * torch.pi / count)
    c, s = angle.cos(), angle.sin()
    x, y, z = cloud.unbind(1)
    return torch.stack([c * x - s * y, s * x + c * y, z.expand(count, -1)], -1)


def chamfer(a: Float[Tensor, "*t n 3"], b: Float[Tensor, "m 3"]) -> Float[Tensor, "*t"]:
    """The symmetric Chamfer distance of clouds ``a`` to the cloud ``b``."""
    d = torch.cdist(a, b)
    return (d.amin(-1).mean(-1) + d.amin(-2).mean(-1)) / 2


def ranking(cloud: Cloud, references: dict[str, list[Cloud]]) -> list[tuple[str, float]]:
    """The nouns with their least distances, nearest first.

    A quarter of the points, a sixteenth of the work, finds the ``NEAR`` nearest nouns; these are
    ordered by all points, and the others follow in the order by the quarter.
    """
    few = {noun: [one[:SCREEN_POINTS] for one in clouds] for noun, clouds in references.items()}
    coarse = _by_distance(cloud[:SCREEN_POINTS], few)
    near = {noun: references[noun] for noun, _ in coarse[:NEAR]}
    return _by_distance(cloud, near) + coarse[NEAR:]


def _by_distance(cloud: Cloud, references: dict[str, list[Cloud]]) -> list[tuple[str, float]]:
    turned = turns(cloud)
    found = {
        noun: min(chamfer(turned, reference).min().item() for reference in clouds)
        for noun, clouds in references.items()
    }
    return sorted(found.items(), key=lambda pair: pair[1])
