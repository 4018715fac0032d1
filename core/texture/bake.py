"""The material of the surface as texture maps: the paper's last step, after §4.3.

"... sample the generated 2D texture ... edge padding": Γ is asked at the points under each texel,
and what is empty is padded.
"""

from collections.abc import Callable
from typing import Protocol, runtime_checkable

import torch
from jaxtyping import Float, Int
from torch import Tensor

from core.appearance.material import Material
from core.geometry.mesh import Mesh
from core.guidance.guidance import Areas
from core.io.maps import Maps
from core.ops import normalize
from core.texture.padding import nearest_covered, pad
from core.texture.texels import Texels, footprint, texel_bands

CHUNK = 1 << 18  # points given to the material at once

MaterialAt = Callable[..., Material]  # of points; where areas are known, and of the area of each


@runtime_checkable
class TexelFinish(Protocol):
    """The last change of a texel's means: see :class:`core.texture.finish.Finish`."""

    attributes: Float[Tensor, "f 3 c"]  # of the surface, by corner
    lights: bool  # whether it adds emission (3) and transmission (1) to the values

    def __call__(
        self,
        attributes: Float[Tensor, "t c"],
        values: Float[Tensor, "t 8"],
        area: Int[Tensor, " t"] | None = None,
    ) -> Float[Tensor, "t w"]: ...


@torch.no_grad()
def bake(
    mesh: Mesh,
    material: MaterialAt,
    size: int,
    progress: Callable[[float], None] | None = None,
    samples: int = 4,
    finish: TexelFinish | None = None,
    areas: Areas | None = None,
) -> Maps:
    """Evaluate ``material`` on the surface; every texel of the maps has a value.

    A texel is the mean over those of its ``samples`` points that are on an island, the normal at
    unit length again; ``finish`` then makes the last change to it. Where no border between two
    ``areas`` is near, one point is enough. Occlusion is 1: the light's shadows are the
    renderer's. The maps are in main memory. ``progress`` gets the fraction done, in [0, 1]; what it
    raises stops it.

    Raises UserError where the uv map covers no texel.
    """
    # 1 is the occlusion, which nothing writes over.
    maps = Maps(*(torch.ones(size * size, 3) for _ in range(3)))
    if finish and finish.lights:
        maps = maps._replace(
            emission=torch.zeros(size * size, 3), transmission=torch.zeros(size * size, 1)
        )
    covered = torch.zeros(size * size, dtype=torch.bool)
    reach = footprint(mesh, size)
    for texels in texel_bands(*mesh.atlas, size, samples):
        if len(texels.index):
            where, mean = _means(mesh, texels, material, finish, areas, reach)
            maps.base_color[where] = mean[:, :3]
            maps.orm[where, 1:] = mean[:, 3:5]
            maps.normal[where] = normalize(mean[:, 5:8])
            if maps.emission is not None and maps.transmission is not None:
                maps.emission[where], maps.transmission[where] = mean[:, 8:].split([3, 1], 1)
            covered[where] = True
            if progress:
                # The last tenth is the padding.
                progress(0.9 * float(where[-1] + 1) / size**2)
    hit = covered.view(size, size)
    # One search serves all maps.
    nearest = nearest_covered(hit)
    square = Maps(*(x if x is None else x.view(size, size, -1) for x in maps))
    for image in square:
        if image is not None:  # in place: at 8192² a map is 0.8 GB
            pad(image, hit, nearest)
    if progress:
        progress(1.0)
    return square


def _means(
    mesh: Mesh,
    texels: Texels,
    material: MaterialAt,
    finish: TexelFinish | None,
    areas: Areas | None,
    reach: float,
) -> tuple[Int[Tensor, " t"], Float[Tensor, "t w"]]:
    """The covered texels and, for each, the mean of kd, roughness, metallic and kn, finished.

    ``reach``: no texel goes farther from its middle.
    """
    # A texel's points follow each other, so no sort is needed.
    where, slot, count = texels.index.unique_consecutive(return_inverse=True, return_counts=True)
    device = mesh.verts.device
    width = finish.attributes.shape[-1] if finish else 0
    place, middle = (torch.zeros(len(where), n, device=device) for n in (width, 3))
    for face, bary, to in zip(
        texels.face.split(CHUNK), texels.bary.split(CHUNK), slot.split(CHUNK), strict=True
    ):
        if finish:
            place.index_add_(0, to, _at(finish.attributes[face], bary))
        if areas:
            middle.index_add_(0, to, _at(mesh.verts[mesh.faces[face]], bary))
    place, middle = place / count[:, None], middle / count[:, None]

    mean, area = torch.zeros(len(where), 8, device=device), None
    once = torch.zeros_like(count, dtype=torch.bool)  # texels for which one point is enough
    if areas:
        found = [areas.certain(part, reach) for part in middle.split(CHUNK)]
        area, once = (torch.cat(x) for x in zip(*found, strict=True))
        for here in once.nonzero().squeeze(1).split(CHUNK):
            mean[here] = torch.cat(material(middle[here], area[here]), -1).to(mean)
    for here in (~once[slot]).nonzero().squeeze(1).split(CHUNK):
        to = slot[here]
        points = _at(mesh.verts[mesh.faces[texels.face[here]]], texels.bary[here])
        values = material(points, *([areas.of(points)] if areas else []))
        mean.index_add_(0, to, torch.cat(values, -1).to(mean) / count[to, None])
    if finish:
        mean[:, 5:] = normalize(mean[:, 5:])
        # Once a texel, at the middle of its points: the detail is made of waves that texels show.
        mean = finish(place, mean, area)
    return where.cpu(), mean.cpu()


def _at(values: Float[Tensor, "n 3 c"], bary: Float[Tensor, "n 3"]) -> Float[Tensor, "n c"]:
    """The values at points, interpolated from the corners of their faces."""
    return torch.einsum("nk,nkc->nc", bary, values)
