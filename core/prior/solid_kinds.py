"""The kinds of each noun's solids: clusters of their volumes, found before the training.

Tables of one leg and of four are both tables, and what is learnt of them together is their mean.
What a family chooses by chance, a round top or an oblong one, counts for more than its proportions,
though these may move more of the volume.
"""

from pathlib import Path

import torch
from jaxtyping import Float, Int
from safetensors.torch import load_file, save_file
from scipy.cluster.vq import kmeans2
from torch import Tensor

from core.guidance.builtin.solid_net import KINDS
from core.io.atomic import atomic_file
from core.prior.data import NOUNS
from core.prior.solid_data import REACH, SIDE, SOLIDS, Solids, read_solids

FILES = 30  # that the kinds are found in
NAME = "kinds.safetensors"
OWN = 0.3  # how much counts by which an object differs from those of the same choices
NEAR = 0.1  # training units: volumes are compared within this of their surfaces
SEED = 0


def kinds_of(folder: Path) -> Float[Tensor, "n k c"]:
    """The middle of each noun's kinds; found once and kept in the folder."""
    path = folder / NAME
    if not path.exists():
        solids = read_solids(sorted(folder.glob(SOLIDS))[:FILES])
        middles = torch.stack([_clusters(solids, noun) for noun in range(len(NOUNS))])
        with atomic_file(path) as temporary:
            save_file({"middles": middles.half()}, temporary)
    return load_file(path)["middles"].float()


def _clusters(solids: Solids, noun: int) -> Float[Tensor, "k c"]:
    """By k-means; a cluster that stays empty keeps its first member."""
    found = _volumes(solids, solids.words[:, 0] == noun)
    if len(found) <= KINDS:
        return found[torch.arange(KINDS) % max(len(found), 1)] if len(found) else _nothing()
    middles, _ = kmeans2(found.numpy(), KINDS, minit="++", seed=SEED)
    return torch.from_numpy(middles)


def _volumes(solids: Solids, which: Tensor) -> Float[Tensor, "n c"]:
    """As compared, and drawn towards the mean of those of the same choices."""
    own = compared(solids.grid[which])
    choices, of = solids.choices[which].unique(return_inverse=True)
    count = of.bincount(minlength=len(choices))
    means = torch.zeros(len(choices), own.shape[1]).index_add(0, of, own) / count[:, None]
    return torch.lerp(means[of], own, OWN)


def _nothing() -> Float[Tensor, "k c"]:
    return torch.zeros(KINDS, SIDE**3)


def compared(grid: Tensor) -> Float[Tensor, "n c"]:
    """Volumes as they are compared: what is far from the surface counts alike."""
    return (grid.flatten(1).float() * (REACH / NEAR / 127)).clamp(-1, 1)


def kind_rows(solids: Solids, middles: Float[Tensor, "n k c"]) -> Int[Tensor, " s"]:
    """Each object's kind, as the network has it: 1 is the first of the first noun."""
    rows = torch.zeros(len(solids), dtype=torch.long)
    for noun in solids.words[:, 0].unique().tolist():
        index = (solids.words[:, 0] == noun).nonzero()[:, 0]
        away = torch.cdist(_volumes(solids, index), middles[noun])
        rows[index] = 1 + KINDS * noun + away.argmin(1)
    return rows


def nearest_kind(volume: Int[Tensor, "32 32 32"], middles: Float[Tensor, "k c"]) -> int:
    """Which of the noun's kinds an object is."""
    return int(torch.cdist(compared(volume[None]), middles).argmin())
