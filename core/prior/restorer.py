"""Training of the restorer: soft renders in, crisp ones out (``core.guidance.builtin.restore``).

Part of each batch is exact and must come back unchanged: a refinement must not damage it.
"""

from dataclasses import replace
from pathlib import Path

import torch
from torch import Tensor

from core.guidance.builtin.network import BLOCK, camera_map
from core.guidance.builtin.restore import restored
from core.prior.data import SIZE
from core.prior.soft_pairs import CLOSE_PAIRS, PAIRS, Pairs, read_pairs
from core.prior.soften import soft_pictures
from core.prior.sources import Batch, Geometry
from core.prior.train import GEOMETRY, TrainConfig, Training, arithmetic

STEM = 24  # channels at full resolution: a step costs half as much again
RESTORER = replace(GEOMETRY, stem=STEM)
RESTORING = TrainConfig(
    minutes=120.0, batch=16, learning_rate=5e-4, warm_up=60, ema=0.995, drop_both=0.05
)
EXACT = 0.2  # fraction of the pictures softened on the fly that are left exact
FROM_SOLIDS = 0.4  # fraction of a batch from soft solids, where the folder has any
KNEE = 0.02  # errors above it count linearly: a median keeps planes flat, a mean rounds edges


def restoring_loss(training: Training, batch: Batch) -> Tensor:
    """The mean pseudo-Huber error, its knee at ``KNEE``, of the restored pictures."""
    x, words, camera, solids = batch
    assert solids is not None
    generator, device = training.generator, training.device
    unnamed = torch.rand(len(x), generator=generator) < training.config.drop_both
    words = words * ~unnamed[:, None]
    x, words, camera, solids = (tensor.to(device) for tensor in (x, words, camera, solids))
    # Here and not in the batch, so that a GPU does it.
    drawn = len(x) - len(solids)
    strength = torch.rand(drawn, generator=generator)
    strength[: round(drawn * EXACT)] = 0
    soft = torch.cat([soft_pictures(x[:drawn], strength, generator), solids])
    with arithmetic(device):
        error = restored(training.net, soft, words, camera) - x
    return ((error / KNEE).square() + 1).sqrt().sub(1).mul(KNEE).mean()


class Restoring(Geometry):
    """Batches of geometry pictures, with the renders of soft solids in the place of the surface.

    These renders belong to the last pictures; the others are to be softened. Half of each batch are
    close-ups, if the folder has any.
    """

    def __init__(self, folder: Path) -> None:
        super().__init__(folder)
        self._read_pairs()

    def rescan(self) -> None:
        """Read the new shards and pairs."""
        super().rescan()
        self._read_pairs()

    def _read_pairs(self) -> None:
        self.pairs, self.close = (pairs_of(self.folder, name) for name in (PAIRS, CLOSE_PAIRS))

    def batch(self, count: int, generator: torch.Generator) -> Batch:
        """Pictures, words, camera maps, and the soft pictures of the last ones."""
        close = count // 2 if self.close else 0
        whole = count - close
        solids = round(whole * FROM_SOLIDS) if self.pairs else 0
        drawn, words, camera, _ = super().batch(whole - solids, generator)
        # Half of the close-ups have their solids' softness, the others are softened as pictures.
        rows = [(drawn, words, camera, drawn[:0])]
        rows += [(*some(self.close, close // 2, generator)[:3], drawn[:0])] if self.close else []
        rows += [some(self.pairs, solids, generator)] if self.pairs else []
        rows += [some(self.close, close - close // 2, generator)] if self.close else []
        pictures, words, camera, soft = (torch.cat(part) for part in zip(*rows, strict=True))
        return pictures, words, camera, soft


def pairs_of(folder: Path, name: str) -> Pairs | None:
    """The pairs in the folder's files that match the pattern ``name``; None if there are none."""
    paths = sorted(folder.glob(name))
    return read_pairs(paths) if paths else None


def some(
    pairs: Pairs, count: int, generator: torch.Generator
) -> tuple[Tensor, Tensor, Tensor, Tensor]:
    """``count`` random pairs: pictures, words, camera maps, soft pictures."""
    s, index = pairs.samples, torch.randint(len(pairs), (count,), generator=generator)
    words = torch.stack([s.noun[index] + 1, s.adjective[index], s.part_state[index]], 1)
    camera = camera_map(s.cameras(index), SIZE // BLOCK)
    return s.pictures(index), words, camera, pairs.soft_pictures(index)
