"""The part at each place of a thing's surface, from a small network that reads the surface.

In training the families' parts are known, so that a prompt's "blue handle" can be painted exactly;
for a trained shape this network finds them: a segmentation of the pictures that the appearance
network gets, in one step and without noise.
"""

from collections.abc import Callable
from functools import cache

import torch
from jaxtyping import Bool, Float, Int
from torch import Tensor

from core.guidance.builtin.network import UNet
from core.guidance.builtin.nouns import NOUNS
from core.guidance.builtin.part_forms import part_forms_table

PARTS = 8  # of one noun, at most


def part_map(
    net: UNet,
    surface: Float[Tensor, "b 7 s s"],
    nouns: Int[Tensor, " b"],
    camera: Float[Tensor, "b 6 m m"],
) -> Float[Tensor, "b 8 s s"]:
    """How surely each place belongs to each part of the noun; zeros outside and without a noun.

    Args:
        surface: [n, 2o - 1, p], weighted by coverage.
        nouns: rows of the nouns; 0 is none.
        camera: ``camera_map`` at half the picture's size.
    """
    logits = part_logits(net, surface, nouns, camera)
    has = has_parts(nouns)
    sure = logits.masked_fill(~has, -1e4).softmax(1)
    return sure * has * (surface[:, 3:4] > -1)


def known_part_map(
    distances: Callable[[Tensor], Tensor], surface: Float[Tensor, "b 7 s s"]
) -> Float[Tensor, "b 8 s s"]:
    """The same for parts with known distances: 1 where a place is of the part, else 0."""
    seen = surface[:, 3] > -1
    covered = (surface[:, 3] + 1) / 2
    points = (surface[:, 4:] / covered[:, None].clamp_min(1e-3)).permute(0, 2, 3, 1)
    part = torch.zeros_like(seen, dtype=torch.long)
    part[seen] = distances(points[seen]).argmin(1)
    one = torch.nn.functional.one_hot(part, PARTS).permute(0, 3, 1, 2).to(surface)
    return one * seen[:, None]


def part_logits(
    net: UNet,
    surface: Float[Tensor, "b 7 s s"],
    nouns: Int[Tensor, " b"],
    camera: Float[Tensor, "b 6 m m"],
) -> Float[Tensor, "b 8 s s"]:
    """The network's output; it takes as many channels as it gives, the last one zero."""
    t = torch.zeros(len(surface), dtype=torch.long, device=surface.device)
    pictures = torch.cat([surface, torch.zeros_like(surface[:, :1])], 1)
    return net(pictures, t, nouns[:, None], camera).float()


def has_parts(nouns: Int[Tensor, " b"]) -> Bool[Tensor, "b 8 1 1"]:
    """Which parts of each noun are solids, by its row; row 0 is no noun and has none. The network
    was trained on these only."""
    return _solids().to(nouns.device)[nouns][:, :, None, None]


@cache
def _solids() -> Bool[Tensor, "n 8"]:
    table = part_forms_table()
    rows = ([least > 0 for least in table[noun].least] for noun in NOUNS)
    return torch.tensor([[False] * PARTS, *rows])
