"""A drawn solid that is bitten, cut or broken: its parts, and the areas of its inside."""

import itertools
from collections.abc import Sequence
from dataclasses import dataclass

import torch
from jaxtyping import Float
from torch import Tensor

from core.geometry.parts.assembly import KnownParts
from core.geometry.parts.components import Distances
from core.geometry.parts.cut import CutParts
from core.geometry.tet_grid import EXTENT
from core.guidance.builtin.cutting.fills import Fill, fills_of
from core.guidance.builtin.cutting.places import (
    ACROSS,
    BRITTLE,
    FACE_AT,
    PAIRS,
    SPARED,
    TILT,
    extent_of,
    tool_of,
    way,
)
from core.guidance.builtin.palette import Finish, Painted
from core.guidance.builtin.substances import CLASS_OF, GLASS, METAL, ROUGHNESS, WOOD
from core.guidance.builtin.surfaces import ranges_of, surface_of
from core.guidance.builtin.words.phrases.slots import Words
from core.guidance.guidance import Area, Surface

# Training units beyond the cut face: the inside's areas are there, too, whatever its errors are.
SLACK = 0.03
NEAR = 0.12  # training units from the cut: farther off the inside is not known
EVEN = 0.35  # of the light and dark of meat: fruit is more even
ROUGH = 0.9  # the roughness of a break in stone or clay
GRAIN_OF = {WOOD: "wooden", METAL: "metal", GLASS: "ceramic"}
SHARDS = ("ceramic", "clay", "glass", "bone")


@dataclass(frozen=True)
class Cut:
    """What is made of a thing's parts by a cut."""

    parts: CutParts
    fills: tuple[tuple[int, Fill], ...]  # each with its part
    areas: tuple[Area, ...]  # of the fills

    def shown(
        self, outside: Distances, points: Float[Tensor, "n 3"], count: int
    ) -> Float[Tensor, "n _q"]:
        """The distances of the first ``count`` columns of ``outside``, the parts with what is on
        them, cut; then those of the fills, which are known near the cut."""
        known, tool = outside(points)[:, :count], self.parts.tool.distance(points)
        cut = torch.maximum(known, -tool[:, None])
        kept = list(self.parts.spared)
        cut[:, kept] = known[:, kept]
        cut = self.parts.without_missing(cut, points)
        near = tool.abs() < NEAR
        found = torch.full((len(points), len(self.fills)), EXTENT).to(known)
        found[near] = self._fills_at(points[near], tool[near])
        return torch.cat([cut, found], 1)

    def _fills_at(
        self, points: Float[Tensor, "n 3"], tool: Float[Tensor, " n"]
    ) -> Float[Tensor, "n f"]:
        """The distances of the fills at points so far from the tool."""
        # The parts' exact surfaces: a network's distances are too short deep inside.
        own = self.parts.without_missing(self.parts.whole.near(points), points)
        columns = []
        for part, fills in itertools.groupby(self.fills, key=lambda pair: pair[0]):
            depth = -own[:, part]
            for margin in _apart([fill for _, fill in fills], points, depth):
                columns.append(tool.abs() - depth - margin)
        found = torch.stack(columns, 1)
        # All alike, so that the deepest of them stays so.
        beyond = (-tool - SLACK - found.amin(1)).clamp_min(0) * (tool < 0)
        return found + beyond[:, None]


def _apart(
    fills: Sequence[Fill], points: Float[Tensor, "n 3"], depth: Float[Tensor, " n"]
) -> list[Float[Tensor, " n"]]:
    """The margins of one part's fills, at most 0, where a later one replaces those before it."""
    margins, taken = [], torch.full_like(depth, -EXTENT)
    for fill in reversed(fills):
        own = fill.margin(points, depth) if fill.margin else torch.full_like(depth, EXTENT)
        margins.append(torch.minimum(own, -taken).clamp_max(0))
        taken = torch.maximum(taken, own)
    return margins[::-1]


def cut_out_of(words: Words, whole: KnownParts, paints: Sequence[Painted]) -> Cut:
    """The cut that the words request, of a thing's parts."""
    noun, names = words.noun, [paint.name for paint in paints]
    surfaces = [surface_of(words, paint) for paint in paints]
    grain = _grain(whole, surfaces)
    tool = tool_of(words.cut, noun, whole, names, grain, words.is_statue)
    spared = [k for k, name in enumerate(names) if name in SPARED.get(noun, ())]
    brittle = [k for k, name in enumerate(names) if name in BRITTLE]
    if words.cut == "slice":  # without its plate
        spared, brittle = [], [*brittle, *spared]
    parts = CutParts(whole, tool, spared, brittle)
    box = extent_of(noun, whole, names)
    normal = tuple(ACROSS.get(noun, way(FACE_AT, TILT if noun in PAIRS else 0.0)))
    fills, areas = [], []
    for part in sorted({component.place.part for component in whole.components}):
        if part in spared:
            continue
        paint, surface = paints[part], surfaces[part]
        for fill in fills_of(noun, paint.name, surface.kind, surface.color, box, normal):
            fills.append((part, fill))
            areas.append(_area(fill, surface))
    return Cut(parts, tuple(fills), tuple(areas))


def _grain(whole: KnownParts, surfaces: Sequence[Surface]) -> str:
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
        surface = Surface(fill.kind, fill.color, depth=EVEN if fill.kind == "flesh" else 1.0)
    return Area(True, ranges_of(Finish(fill.color, rough, metallic), fill.color), surface)
