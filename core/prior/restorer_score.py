"""The restorer's gain on fresh objects softened as by a fit, and its damage to exact ones."""

from dataclasses import dataclass

import torch
from jaxtyping import Float
from torch import Tensor
from torch.nn.functional import normalize

from core.guidance.builtin.network import BLOCK, UNet, camera_map
from core.guidance.builtin.restore import as_render, restored
from core.prior.data import NOUNS, SIZE, VIEWS
from core.prior.soft_pairs import make_pairs

COVERED = 0.95  # coverage of the pixels that are compared


@dataclass(frozen=True)
class RestoreScore:
    """Mean angles to the true normals for one noun, in degrees."""

    noun: str
    soft: float  # of the softened renders
    restored: float  # of the softened renders after restoring
    exact: float  # of the exact renders after restoring: the network's own error

    def __str__(self) -> str:
        ratio = self.restored / self.soft
        return (
            f"{self.noun:12} soft {self.soft:5.1f}, restored {self.restored:5.1f} "
            f"({ratio:.2f} of it), exact restored {self.exact:4.1f}"
        )


def mean_angle(pictures: Float[Tensor, "b 4 s s"], true: Float[Tensor, "b 4 s s"]) -> float:
    """The mean angle between the normals of both, degrees, over the pixels that ``true`` covers."""
    covered = true[:, 3] > 2 * COVERED - 1
    a, b = (normalize(x[:, :3], dim=1, eps=1e-4) for x in (pictures, true))
    cosine = (a * b).sum(1)[covered].clamp(-1, 1)
    return torch.rad2deg(cosine.acos()).mean().item()


@torch.no_grad()
def score_restoring(
    net: UNet, noun: str, views: int, seed: int, *, close: bool = False
) -> RestoreScore:
    """The score on ``views`` views, or close-ups, of the fresh objects of ``seed``."""
    pairs = make_pairs(seed, -(-views // VIEWS), (noun,), close=close)
    s, soft = pairs.samples, pairs.soft_pictures()
    words = torch.stack([s.noun + 1, s.adjective, s.part_state], 1)
    words = words * (words <= torch.tensor(net.config.words))  # later nouns are "not stated"
    camera, true = camera_map(s.cameras(), SIZE // BLOCK), s.pictures()
    sharp, same = (as_render(restored(net, x, words, camera)) for x in (soft, true))
    return RestoreScore(
        noun, mean_angle(soft, true), mean_angle(sharp, true), mean_angle(same, true)
    )


def report(
    net: UNet, nouns: list[str], views: int, seed: int, *, close: bool = False
) -> list[RestoreScore]:
    """Print each noun's score and the means."""
    scores = []
    for noun in nouns:
        scores.append(score_restoring(net, noun, views, seed + NOUNS.index(noun), close=close))
        print(scores[-1], flush=True)
    soft, after, exact = (
        sum(getattr(score, name) for score in scores) / len(scores)
        for name in ("soft", "restored", "exact")
    )
    print(RestoreScore("mean", soft, after, exact))
    return scores
