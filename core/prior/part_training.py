"""Training of the network that finds a thing's parts (``core.guidance.builtin.part_map``)."""

import torch
from jaxtyping import Float, Int
from torch import Tensor
from torch.nn.functional import cross_entropy, one_hot

from core.guidance.builtin.network import UNetConfig
from core.guidance.builtin.part_map import PARTS, part_logits
from core.prior.colored import lumpy
from core.prior.data import NOUNS
from core.prior.soften import soft_pictures
from core.prior.sources import Batch, Source
from core.prior.train import TrainConfig, Training, arithmetic

PART_NETWORK = UNetConfig(words=(len(NOUNS),), widths=(32, 48, 80, 112), code=128, picture=PARTS)
FINDING_PARTS = TrainConfig(batch=16, learning_rate=1e-3)
EXACT = 0.3  # fraction of the pictures that are not softened


class PartMaps(Source):
    """Batches of surfaces, softened like those of a training, with the noun and each pixel's part;
    -1 is background."""

    def batch(self, count: int, generator: torch.Generator) -> Batch:
        """Surfaces (N, 7, s, s), nouns' rows (N, 1), camera maps, parts (N, s, s)."""
        index, pictures, camera = self.draw(count, generator)
        strength = torch.rand(count, generator=generator)
        strength[: round(count * EXACT)] = 0
        soft = soft_pictures(pictures, strength, generator)
        soft = torch.cat([lumpy(soft[:, :3], generator), soft[:, 3:]], 1)
        surface = torch.cat([soft, self.samples.points(index)], 1)
        parts = self.samples.part[index].long()
        return surface, self.samples.noun[index][:, None] + 1, camera, parts


def part_loss(training: Training, batch: Batch) -> Tensor:
    """The mean cross-entropy over the object's pixels; small parts have larger weights."""
    surface, words, camera, parts = batch
    assert parts is not None
    weights = pixel_weights(parts)
    moved = (tensor.to(training.device) for tensor in (surface, words, camera, parts, weights))
    surface, words, camera, parts, weights = moved
    with arithmetic(training.device):
        logits = part_logits(training.net, surface, words[:, 0], camera)
    losses = cross_entropy(logits, parts, ignore_index=-1, reduction="none")
    return (losses * weights).sum() / weights.sum()


def pixel_weights(parts: Int[Tensor, "b s s"]) -> Float[Tensor, "b s s"]:
    """1 / sqrt of the number of the picture's pixels with the same part; 0 outside.

    With equal weights a robot's eyes were lost in its head.
    """
    one = one_hot(parts + 1, PARTS + 1)
    counts = one.sum((1, 2), keepdim=True).clamp_min(1)
    return (one / counts.sqrt()).sum(3) * (parts >= 0)
