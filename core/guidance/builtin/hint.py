"""The picture that the appearance network gets: the surface, and the colours of its parts by the
words and by nature."""

from collections.abc import Sequence
from functools import lru_cache
from typing import NamedTuple

import torch
from jaxtyping import Float, Int
from torch import Tensor

from core.guidance.builtin.palette import SWATCHES, painted, swatches
from core.guidance.builtin.part_map import PARTS
from core.guidance.builtin.patterns import RAINBOW_COLORS, Laid
from core.guidance.builtin.words.grammar.lexicon import SLOTS
from core.guidance.builtin.words.phrases.slots import Words

SURFACE = 7  # channels: normals, coverage, points
CHANNELS = SURFACE + SWATCHES
HINT_SLOTS = ("noun", "color", "material", "pattern", "second", "target")
NAMES = {slot: ("", *SLOTS[slot]) for slot in HINT_SLOTS}


def hint(
    surface: Float[Tensor, "b 7 h w"],
    parts: Float[Tensor, "b 8 h w"],
    words: Int[Tensor, "b 6"],
    stated: Sequence[Words] = (),
    axes: tuple[int, ...] = (),
) -> Float[Tensor, "b c h w"]:
    """``surface`` ([n, 2o - 1, p], weighted by coverage), then each place's colour by the words and
    by nature, [2 srgb - 1, 1], drawn in the pattern; last the second swatch, even.

    So the network need not learn what a colour word looks like on each part of each thing, nor to
    draw a pattern: given the points alone, or their Fourier features, it painted its mean colour.

    Args:
        parts: how surely a place belongs to each of the noun's parts (``part_map``).
        words: rows of ``HINT_SLOTS``; 0 is not stated.
        stated: the words of the rows, where they state more than these.
        axes: for each part, the axis along which stripes follow one another
            (``patterns.axis_of``).
    """
    stated = stated or [_words_of(tuple(row)) for row in words.tolist()]
    rows = [_part_colors(one, axes) for one in stated]
    colors = torch.stack([row.colors for row in rows]).to(surface)
    which = stencil(surface, [row.patterns for row in rows])
    laid = torch.einsum("bkhw,bkc->bchw", parts, colors[:, :, 0])
    for k in range(1, int(which.max()) + 1):  # the other colours of what is patterned
        more = colors[:, :, k] - colors[:, :, 0]
        laid = laid + torch.einsum("bkhw,bkc->bchw", parts * (which == k), more)
    even = swatches(words)[:, SWATCHES // 2 :, None, None].to(surface)
    return torch.cat([surface, laid, even.expand_as(laid)], 1)


class PartColors(NamedTuple):
    """The colours of the noun's parts by the words; rows beyond them are zeros."""

    colors: Float[Tensor, "8 6 4"]  # [2 srgb - 1, 1]: of the pattern; of two the part's own first
    patterns: tuple[Laid, ...]


@lru_cache(4096)
def _words_of(row: tuple[int, ...]) -> Words:
    return Words(**{slot: NAMES[slot][i] for slot, i in zip(HINT_SLOTS, row, strict=True)})


@lru_cache(4096)
def _part_colors(words: Words, axes: tuple[int, ...]) -> PartColors:
    colors = torch.zeros(PARTS, len(RAINBOW_COLORS), 4)
    patterns = [Laid()] * PARTS
    # Without words nothing is known, as the network must paint it without guidance.
    for k, part in enumerate(painted(words.noun, words) if words.noun else ()):
        own = torch.tensor(part.colors())
        colors[k, : len(own)] = torch.cat([2 * own - 1, torch.ones(len(own), 1)], 1)
        patterns[k] = Laid(part.pattern, axes[k] if axes else 2)
    return PartColors(colors, tuple(patterns))


def stencil(
    surface: Float[Tensor, "b 7 h w"], patterns: Sequence[Sequence[Laid]]
) -> Int[Tensor, "b k h w"]:
    """The index of the colour at each place of the patterns of a picture's k parts; 0 without a
    pattern."""
    batch, _, high, wide = surface.shape
    out = torch.zeros(batch, len(patterns[0]), high, wide, dtype=torch.long, device=surface.device)
    # The points come weighted by coverage; undone, or patterns would bend at silhouettes.
    point = surface[:, 4:] / ((surface[:, 3:4] + 1) / 2).clamp_min(1e-3)
    for laid in {one for row in patterns for one in row}:
        if margins := laid.margins():
            mine = torch.tensor([[one == laid for one in row] for row in patterns])
            row, part = mine.to(surface.device).nonzero().T
            place = point[row].permute(0, 2, 3, 1).reshape(-1, 3)
            out[row, part] = margins(place).argmax(1).view(-1, high, wide)
    # Outside of the object the point is none.
    return out * (surface[:, 3:4] > -1)
