"""The learnt material, even where one colour is meant.

Reflectance is mostly piecewise constant (Land and McCann 1971, "Lightness and Retinex Theory").
A material learnt from small pictures still varies within each area, in blotches that an artist
sees as dirt. Where the areas are known, values are moved towards their median.
"""

from collections.abc import Callable

import torch
from jaxtyping import Float, Int
from torch import Tensor

from core.appearance.material import Material
from core.appearance.shaded import UvMesh
from core.guidance.guidance import Areas
from core.texture.detail.survey import spread

SURVEYED = 1 << 14  # points of the surface, for the medians

MaterialIn = Callable[[Float[Tensor, "n 3"], Int[Tensor, " n"]], Material]  # in a known area


def evened(learnt: MaterialIn, areas: Areas, mesh: UvMesh, evenness: float) -> MaterialIn:
    """``learnt`` with sharp borders, and with ``evenness`` of the variation within each plain area
    taken out of colour, roughness and metallic; relief stays."""
    face, bary = spread(mesh.verts, mesh.faces, SURVEYED)
    points = torch.einsum("nk,nkc->nc", bary, mesh.verts[mesh.faces[face]])
    area = areas.of(points)
    values = _values(learnt(areas.inside(points, area), area))
    median = torch.zeros(len(areas.each), values.shape[1])
    fraction = torch.zeros(len(areas.each), 1)
    for index, meant in enumerate(areas.each):
        mine = values[area == index]
        if meant.plain and len(mine):
            median[index], fraction[index] = mine.median(0).values, evenness

    def at(points: Float[Tensor, "n 3"], area: Int[Tensor, " n"]) -> Material:
        material = learnt(areas.inside(points, area), area)
        values = torch.lerp(_values(material), median[area], fraction[area])
        return Material(values[:, :3], values[:, 3:4], values[:, 4:5], material.kn)

    return at


def _values(material: Material) -> Float[Tensor, "n 5"]:
    return torch.cat([material.kd, material.roughness, material.metallic], 1)
