"""Training of the network that finds a thing's parts (``core.guidance.builtin.part_map``)."""

import torch
from torch import Tensor
from torch.nn.functional import cross_entropy

from core.guidance.builtin.network import UNetConfig
from core.guidance.builtin.part_map import PARTS, part_logits
from core.prior.colored import lumpy
from core.prior.data import NOUNS
from core.prior.soften import soft_pictures
from core.prior.train import Batch, Source, TrainConfig, Training

PART_NETWORK = UNetConfig(words=(len(NOUNS),), widths=(32, 48, 80, 112), code=128, picture=PARTS)
FINDING_PARTS = TrainConfig(batch=16, learning_rate=1e-3)
EXACT = 0.3  # fraction of the pictures that are not softened


class PartMaps(Source):
    """Batches of surfaces, softened as a training leaves them, with the noun and each pixel's part;
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
    """The mean cross-entropy over the object's pixels."""
    surface, words, camera, parts = (tensor.to(training.device) for tensor in batch)
    with torch.autocast(training.device.type, torch.bfloat16):
        logits = part_logits(training.net, surface, words[:, 0], camera)
    return cross_entropy(logits, parts, ignore_index=-1)
