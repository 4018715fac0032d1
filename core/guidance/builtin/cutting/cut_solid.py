"""A drawn solid that is bitten, cut or broken: its parts, and the areas of its inside."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import torch
from jaxtyping import Float
from torch import Tensor

from core.geometry.parts.assembly import KnownParts
from core.geometry.parts.cut import CutParts
from core.guidance.builtin.cutting.fills import Fill, fills_of
from core.guidance.builtin.cutting.places import (
    BRITTLE,
    FACE_AT,
    PAIRS,
    SPARED,
    ACROSS,
    TILT,
    extent_of,
    tool_of,
    way,
)
from core.guidance.builtin.palette import Finish, Painted
from core.guidance.builtin.substances import CLASS_OF, CLOTH, GLASS, METAL, ROUGHNESS, WOOD
from core.guidance.builtin.surfaces import ranges_of, surface_of
from core.guidance.builtin.words.slots import Words
from core.guidance.guidance import Area, Surface

# Training units beyond the cut face: the inside's areas are there, too, whatever its errors are.
SLACK = 0.03
ROUGH = 0.9  # the roughness of a break in stone or clay
GRAIN_OF = {WOOD: "wooden", METAL: "metal", GLASS: "ceramic"}
SHARDS = ("ceramic", "clay", "glass", "bone")


@dataclass(frozen=True)
class Cut:
    """What is made of a thing's parts by a cut."""

    parts: CutParts
    fills: tuple[tuple[int, Fill], ...]  # each with its part
    areas: tuple[Area, ...]  # of the fills
    gone: tuple[int, ...]  # parts that are left out

    def shown(
        self,
        field: Callable[[Float[Tensor, "n 3"]], Float[Tensor, "n p"]],
        points: Float[Tensor, "n 3"],
        count: int,
    ) -> Float[Tensor, "n _q"]:
        """The distances of the first ``count`` columns of the field, cut, and those of the
        fills."""
        known, tool = field(points)[:, :count], self.parts.tool.distance(points)
        cut = torch.maximum(known, -tool[:, None])
        kept = list(self.parts.spared)
        cut[:, kept] = known[:, kept]
        columns = []
        for part, fill in self.fills:
            depth = -known[:, part]
            column = tool.abs() - depth
            if fill.margin is not None:
                column = column - fill.margin(points, depth).clamp_max(0)
            columns.append(torch.maximum(column, -tool - SLACK))
        return torch.cat([cut, torch.stack(columns, 1)], 1)


def cut_out_of(words: Words, whole: KnownParts, paints: Sequence[Painted]) -> Cut:
    """The cut that the words request, of a thing's parts."""
    noun, names = words.noun, [paint.name for paint in paints]
    surfaces = [surface_of(words, paint) for paint in paints]
    grain = _grain(words, whole, surfaces)
    tool = tool_of(words.cut, noun, whole, names, grain, words.is_statue)
    spared = [k for k, name in enumerate(names) if name in SPARED.get(noun, ())]
    brittle = [k for k, name in enumerate(names) if name in BRITTLE]
    parts = CutParts(whole, tool, spared, brittle)
    box = extent_of(noun, whole, names)
    normal = tuple(ACROSS.get(noun, way(FACE_AT, 2 * TILT if noun in PAIRS else 0.0)))
    fills, areas = [], []
    for part in sorted({component.place.part for component in whole.components}):
        if part in spared:
            continue
        paint, surface = paints[part], surfaces[part]
        for fill in fills_of(noun, paint.name, surface.kind, surface.color, box, normal):
            fills.append((part, fill))
            areas.append(_area(fill, surface))
    return Cut(parts, tuple(fills), tuple(areas), ())


def _grain(words: Words, whole: KnownParts, surfaces: Sequence[Surface]) -> str:
    """The roughness of a break, by the thing's largest part."""
    sizes = torch.tensor([float(abs(size).prod()) for size in whole.extents()])
    kind = surfaces[int(sizes[: len(surfaces)].argmax())].kind
    if kind in SHARDS:
        return "ceramic"
    return GRAIN_OF.get(CLASS_OF.get(kind, ""), "stone")


def _area(fill: Fill, outside: Surface) -> Area:
    """A fill's properties; clear glass is clear inside."""
    metallic = float(CLASS_OF.get(fill.kind) == METAL)
    rough = ROUGHNESS.get(fill.kind, 0.35 if metallic else ROUGH)
    if fill.kind == outside.kind == "glass":
        surface = outside._replace(weather=())
        rough = 0.08
    else:
        surface = Surface(fill.kind, fill.color)
    return Area(True, ranges_of(Finish(fill.color, rough, metallic), fill.color), surface)
