"""How well the parts of fresh objects are found, and of the same objects softened."""

from typing import NamedTuple

import torch
from torch import Tensor

from core.guidance.builtin.network import BLOCK, UNet, camera_map
from core.guidance.builtin.part_map import part_map
from core.prior.data import SIZE, Samples, make
from core.prior.soften import soft_pictures

STRENGTH = 0.6  # strength of the softening; 1 is the most


class PartScore(NamedTuple):
    """Fractions of the wholly covered pixels whose part is right, for one noun."""

    noun: str
    exact: float
    soft: float

    def __str__(self) -> str:
        return f"{self.noun:14} right: exact {self.exact:.3f}, softened {self.soft:.3f}"


def score_parts(net: UNet, noun: str, objects: int, seed: int) -> PartScore:
    """The score on ``objects`` fresh objects of the noun."""
    samples = make(seed, objects, (noun,))
    pictures = samples.pictures()
    strength = torch.full((len(pictures),), STRENGTH)
    soft = soft_pictures(pictures, strength, torch.Generator().manual_seed(seed))
    return PartScore(noun, _right(net, samples, pictures), _right(net, samples, soft))


@torch.no_grad()
def _right(net: UNet, samples: Samples, pictures: Tensor) -> float:
    surface = torch.cat([pictures, samples.points()], 1)
    camera = camera_map(samples.cameras(), SIZE // BLOCK)
    found = part_map(net, surface, samples.noun + 1, camera).argmax(1)
    inside = samples.coverage[:, 0] == 255
    return (found == samples.part)[inside].float().mean().item()


def report_parts(net: UNet, nouns: list[str], objects: int, seed: int) -> None:
    """Print each noun's score and the means."""
    scores = [score_parts(net, noun, objects, seed) for noun in nouns]
    print(*scores, sep="\n")
    exact, soft = (sum(s[k] for s in scores) / len(scores) for k in (1, 2))
    print(f"mean of {len(scores)} nouns: exact {exact:.3f}, softened {soft:.3f}")
