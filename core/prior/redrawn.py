"""Solids as the solids' network draws them, with its errors: a draft's geometry starts there."""

from dataclasses import dataclass
from pathlib import Path

import torch
from jaxtyping import Float
from safetensors.torch import load_file
from torch import Tensor

from core.geometry.tet_grid import EXTENT
from core.guidance.builtin.solid_net import KINDS, SCALE
from core.guidance.builtin.stretch import AS_IT_IS, known_wider
from core.prior.data import NOUNS
from core.prior.families import Shape, normalised
from core.prior.soften import HALF, LatticeShape
from core.prior.solid_data import volume_of
from core.prior.solid_kinds import kinds_of, nearest_kind
from core.prior.solid_training import Autoencoder

WEIGHTS = "solid_ema.safetensors"  # the training's file, with the encoder
CHUNK = 1 << 16  # points at a time


@dataclass(frozen=True)
class Redrawing:
    """The trained autoencoder: a solid is encoded and drawn again."""

    net: Autoencoder
    kinds: Float[Tensor, "n k c"]  # the middle of each noun's kinds

    @classmethod
    def of(cls, folder: Path) -> "Redrawing | None":
        """The autoencoder of a training folder; None if nothing has been trained there."""
        path = folder / WEIGHTS
        if not path.exists():
            return None
        net = Autoencoder()
        weights = {name: tensor.float() for name, tensor in load_file(path).items()}
        net.load_state_dict(net.state_dict() | weights)
        return cls(net.eval().requires_grad_(False), kinds_of(folder).middles)

    def shape(self, shape: Shape, noun: int, cells: int) -> LatticeShape:
        """The solid encoded and drawn again, on a lattice of ``cells`` along an edge; ``noun``: its
        index in ``core.prior.data.NOUNS``."""
        # A slender object is known wider than it is: the network's points differ from its own.
        wider = known_wider(NOUNS[noun])
        drawn = shape if wider == AS_IT_IS else normalised(shape.parts, wider)
        by = torch.tensor(drawn.scale) / torch.tensor(shape.scale)
        volume = volume_of(drawn)
        kind = 1 + KINDS * noun + nearest_kind(volume, self.kinds[noun])
        words = torch.tensor([[noun + 1, 0, 0, kind]])
        code, _ = self.net.encode(volume[None, None].float() / 127, words)
        triplane = self.net.decoder.triplane(words, code)
        side = torch.linspace(-HALF, HALF, cells + 1).clamp(-EXTENT, EXTENT) / EXTENT
        nodes = torch.stack(torch.meshgrid(side, side, side, indexing="ij"), -1)[..., [2, 1, 0]]
        chunks = (nodes.view(-1, 3) * by).clamp(-1, 1).split(CHUNK)
        found = [self.net.decoder.at(triplane, chunk[None]).amin(-1) for chunk in chunks]
        distance = torch.cat(found, 1) / (SCALE * by.max())
        return LatticeShape(distance.view(1, 1, *nodes.shape[:3]))
