"""Paint for the families' objects: their parts' colours by nature, and what a caption changes."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import NamedTuple

import torch
from jaxtyping import Float, Int
from torch import Tensor

from core.guidance.builtin.palette import (
    COLOR_VALUES,
    FINISHES,
    Color,
    companion,
    has_accents,
    looks,
)
from core.guidance.builtin.patterns import Place
from core.ops import srgb_to_linear
from core.prior.draw import Draw
from core.prior.natural_patterns import ALL_PATTERNS

JITTER = 0.06  # spread of a colour's channels between objects, and of its brightness


class Coat(NamedTuple):
    """Paint of K parts."""

    color: Float[Tensor, "k 3"]  # sRGB
    second: Float[Tensor, "k 3"]  # sRGB, what the pattern is drawn with
    roughness: Float[Tensor, "k 1"]
    metallic: Float[Tensor, "k 1"]
    pattern: Int[Tensor, " k"]  # index into ALL_PATTERNS; -1 is none


@dataclass(frozen=True)
class Caption:
    """The words of a caption that the paint depends on; empty is not stated."""

    color: str = ""
    material: str = ""
    pattern: str = ""
    second: str = ""


def coat(noun: str, caption: Caption, draw: Draw) -> Coat:
    """The paint of one object with this caption."""
    # One for the whole object: its parts keep their contrast.
    shift = 1 + draw(-JITTER, JITTER)
    tint = torch.tensor([1 + draw(-JITTER, JITTER) / 2 for _ in range(3)]) * shift
    gloss = draw(-0.05, 0.05)
    colors, seconds, roughness, metallic, patterns = zip(*_rows(noun, caption), strict=True)
    return Coat(
        (torch.tensor(colors) * tint).clamp(0.02, 1),
        (torch.tensor(seconds) * tint).clamp(0.02, 1),
        torch.tensor(roughness)[:, None] + gloss,
        torch.tensor(metallic)[:, None],
        torch.tensor([[*ALL_PATTERNS].index(name) if name else -1 for name in patterns]),
    )


def _rows(noun: str, caption: Caption) -> Iterator[tuple[Color, Color, float, float, str]]:
    """Colour, second colour, roughness, metallic and pattern of each part."""
    # Of a thing with accents these take the second colour; of any other its lower half.
    two_tone = caption.pattern == "two-tone" and has_accents(noun)
    for look in looks(noun).values():
        finish, color, pattern = look.finish, look.color, look.pattern
        # The material first: a stated colour then replaces the material's own.
        if caption.material and look.role != "-":
            finish = FINISHES[caption.material]
            color, pattern = finish.color or color, finish.pattern
        if caption.color and look.role in "*&":
            color, pattern = COLOR_VALUES[caption.color], finish.pattern
        second = COLOR_VALUES[caption.second] if caption.second else companion(color)
        if two_tone and look.role in "+&":
            first = COLOR_VALUES[caption.color] if caption.color else look.color
            color = COLOR_VALUES[caption.second] if caption.second else companion(first)
            pattern = finish.pattern
        elif caption.pattern and look.role in "*&" and not two_tone:
            pattern = caption.pattern
        yield color, second, finish.roughness, finish.metallic, pattern


def paint(
    coat: Coat, part: Int[Tensor, " p"], point: Float[Tensor, "p 3"], normal: Float[Tensor, "p 3"]
) -> tuple[Float[Tensor, "p 3"], Float[Tensor, "p 1"], Float[Tensor, "p 1"]]:
    """kd (linear), roughness and metallic of points of the parts."""
    color, second, pattern = coat.color[part], coat.second[part], coat.pattern[part]
    for index in coat.pattern.unique().tolist():
        if index >= 0:
            mine = pattern == index
            draw = list(ALL_PATTERNS.values())[index]
            color[mine] = draw(color[mine], second[mine], Place(point[mine], normal[mine]))
    return srgb_to_linear(color.clamp(0, 1)), coat.roughness[part], coat.metallic[part]
