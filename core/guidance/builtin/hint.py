"""What the appearance network is given as a picture: the surface, and what the words look like."""

import torch
from jaxtyping import Bool, Float, Int
from torch import Tensor

from core.guidance.builtin.lexicon import SLOTS
from core.guidance.builtin.nouns import NOUNS
from core.guidance.builtin.palette import SWATCHES, has_accents, swatches
from core.guidance.builtin.patterns import PATTERNS, Place

SURFACE = 7  # channels: normals, coverage, points
CHANNELS = SURFACE + SWATCHES
ACCENTED = torch.tensor([False, *map(has_accents, NOUNS)])  # by the noun's row
TWO_TONE = 1 + list(SLOTS["pattern"]).index("two-tone")


def hint(surface: Float[Tensor, "b 7 s s"], words: Int[Tensor, "b n"]) -> Float[Tensor, "b c s s"]:
    """``surface`` ([n, 2o - 1, p], weighted by coverage), then the words' two swatches: the first
    laid over all of the surface as the stated pattern has it, the second even.

    A network this small learns which parts a word is for, but not to draw a pattern: given the
    points, or their Fourier features too, it painted the pattern's mean colour.

    Args:
        words: rows of noun, color, material, pattern, second and more; 0 is not stated.
    """
    first, second = swatches(words)[:, :, None, None].split(SWATCHES // 2, 1)
    laid = torch.where(stencil(surface, words), second, first)
    return torch.cat([surface, laid, second.expand_as(laid)], 1)


def stencil(
    surface: Float[Tensor, "b 7 h w"], words: Int[Tensor, "b n"]
) -> Bool[Tensor, "b 1 h w"]:
    """Where the stated pattern puts the second colour, whatever part is there; nowhere, where no
    pattern or no second colour is stated or implied, or where it is for accent parts alone."""
    out = torch.zeros_like(surface[:, :1], dtype=torch.bool)
    # The points come weighted by coverage; undone, or patterns would bend at silhouettes.
    point = surface[:, 4:] / ((surface[:, 3:4] + 1) / 2).clamp_min(1e-3)
    accents = ACCENTED.to(words.device)[words[:, 0]] & (words[:, 3] == TWO_TONE)
    # The last channel of the second swatch says that there is one.
    lays = ~accents & (swatches(words)[:, -1] > 0)
    for row, name in enumerate(SLOTS["pattern"], 1):
        mine = lays & (words[:, 3] == row)
        if mine.any():
            place = point[mine].permute(0, 2, 3, 1).reshape(-1, 3)
            zero = torch.zeros_like(place)
            # Drawn in black and white, a pattern is its own mask.
            drawn = PATTERNS[name](zero, zero + 1, Place(place, place))[:, 0] > 0
            out[mine] = drawn.view(-1, 1, *out.shape[2:])
    # Outside of the object the point is none.
    return out & (surface[:, 3:4] > -1)
