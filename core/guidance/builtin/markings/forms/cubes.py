"""Pips of dice and stickers of puzzle cubes."""

from functools import cache

import torch
from jaxtyping import Int
from torch import Tensor

from core.guidance.builtin.markings.margins import Half, Margin, Points

PIPS: dict[int, list[tuple[float, float]]] = {
    1: [(0, 0)],
    2: [(-1, 1), (1, -1)],
    3: [(-1, 1), (0, 0), (1, -1)],
    4: [(-1, -1), (-1, 1), (1, -1), (1, 1)],
    5: [(-1, -1), (-1, 1), (1, -1), (1, 1), (0, 0)],
    6: [(-1, -1), (-1, 0), (-1, 1), (1, -1), (1, 0), (1, 1)],
}
FACES = {(1, -1): 1, (2, 1): 2, (0, 1): 3, (0, -1): 4, (2, -1): 5, (1, 1): 6}  # axis, side: number


def _on_faces(points: Points, half: Half) -> list[tuple[int, int, Tensor, Tensor]]:
    """For each face of a cube: its axis, its side, a mask of the places nearest to it, and their
    positions on it in halves of the cube."""
    at = points / half
    axis = at.abs().argmax(1)
    found = []
    for k in range(3):
        for side in (-1, 1):
            here = (axis == k) & (at[:, k] * side > 0)
            found.append((k, side, here, at[here][:, [i for i in range(3) if i != k]]))
    return found


def pips(points: Points, half: Half) -> Margin:
    """The pips of a die; opposite faces add to seven."""
    margin = torch.full_like(points[:, 0], -1.0)
    for axis, side, here, at in _on_faces(points, half):
        middles = at.new_tensor(PIPS[FACES[axis, side]]) * 0.48
        margin[here] = (0.17 - torch.cdist(at, middles).amin(1)) * half.mean()
    return margin


@cache
def _scrambled() -> Int[Tensor, "6 3 3"]:
    """Colours of a scrambled puzzle cube by face, row and column: nine of each, the middles in
    place."""
    others = torch.arange(6).repeat_interleave(8)[torch.randperm(48, generator=_generator())]
    faces = torch.empty(6, 9, dtype=torch.long)
    faces[:, 4] = torch.arange(6)
    faces[:, [0, 1, 2, 3, 5, 6, 7, 8]] = others.view(6, 8)
    return faces.view(6, 3, 3)


def _generator() -> torch.Generator:
    return torch.Generator().manual_seed(3)


def stickers(points: Points, half: Half, color: int) -> Margin:
    """The stickers of one of the six colours of a scrambled puzzle cube."""
    margin = torch.full_like(points[:, 0], -1.0)
    for axis, side, here, at in _on_faces(points, half):
        cell = (at * 1.5).round().clamp(-1, 1)
        inside = 0.285 - (at - cell * 0.645).abs().amax(1)
        row, column = (cell + 1).long().T
        own = _scrambled().to(row.device)[2 * axis + (side > 0)][row, column]
        margin[here] = torch.where(own == color, inside, -inside.abs() - 0.01) * half.mean()
    return margin
