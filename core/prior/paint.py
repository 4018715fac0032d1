"""Paint for the families' objects: their parts' natural colours, changed by a caption."""

from dataclasses import dataclass
from typing import NamedTuple

import torch
from jaxtyping import Float, Int
from torch import Tensor

from core.guidance.builtin.palette import painted
from core.guidance.builtin.patterns import Place
from core.guidance.builtin.words.grammar.accents import Accent
from core.ops import srgb_to_linear
from core.prior.draw import Draw
from core.prior.natural_patterns import ALL_PATTERNS

JITTER = 0.06  # spread of a colour's channels between objects, and of its brightness


class Coat(NamedTuple):
    """The paint of K parts."""

    color: Float[Tensor, "k 3"]  # sRGB
    second: Float[Tensor, "k 3"]  # sRGB, the pattern's colour
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
    target: str = ""  # the part that has the second colour
    accents: tuple[Accent, ...] = ()
    color_form: str = ""
    second_form: str = ""
    material_form: str = ""
    sheen: tuple[str, ...] = ()
    is_statue: bool = False


def coat(noun: str, caption: Caption, draw: Draw) -> Coat:
    """The paint of one object with this caption."""
    # One tint for the whole object: its parts keep their contrast.
    shift = 1 + draw(-JITTER, JITTER)
    tint = torch.tensor([1 + draw(-JITTER, JITTER) / 2 for _ in range(3)]) * shift
    gloss = draw(-0.05, 0.05)
    parts = list(painted(noun, caption))
    return Coat(
        (torch.tensor([part.color for part in parts]) * tint).clamp(0.02, 1),
        (torch.tensor([part.second for part in parts]) * tint).clamp(0.02, 1),
        torch.tensor([part.finish.roughness for part in parts])[:, None] + gloss,
        torch.tensor([part.finish.metallic for part in parts])[:, None],
        torch.tensor([_index(part.pattern) for part in parts]),
    )


def _index(pattern: str) -> int:
    return [*ALL_PATTERNS].index(pattern) if pattern else -1


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
