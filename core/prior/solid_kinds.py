"""The kinds of each noun's solids, found before the training: what a family chooses by chance, and
where that leaves some, clusters of the volumes.

Tables of one leg and of four are both tables, and what is learnt of them together is their mean.
A round top or an oblong one counts for more than proportions, though these may move more of the
volume; and a chair's back of slats or of boards is hardly seen in the volume.
"""

from pathlib import Path
from typing import NamedTuple

import torch
from jaxtyping import Float, Int
from safetensors.torch import load_file, save_file
from scipy.cluster.vq import kmeans2
from scipy.optimize import linear_sum_assignment
from torch import Tensor

from core.geometry.tet_grid import EXTENT
from core.guidance.builtin.solid_net import KINDS, SCALE, SolidNet
from core.io.atomic import atomic_file
from core.prior.data import NOUNS
from core.prior.solid_data import REACH, SIDE, SOLIDS, Solids, cells, in_bytes, read_solids

FILES = 30  # that the kinds are found in
NAME = "kinds.safetensors"
ANY = -1  # choices of a kind that is told by the volume alone
OWN = 0.3  # how much counts by which an object differs from those of the same choices
NEAR = 0.1  # training units: volumes are compared within this of their surfaces
SEED = 0


class Kinds(NamedTuple):
    """Of each noun."""

    middles: Float[Tensor, "n k c"]  # of the kinds' volumes, as compared
    choices: Int[Tensor, "n k"]  # which a kind's objects have, or ``ANY``


def kinds_of(folder: Path) -> Kinds:
    """Found once and kept in the folder."""
    path = folder / NAME
    if not path.exists():
        solids = read_solids(sorted(folder.glob(SOLIDS))[:FILES])
        found = [_kinds(solids, solids.words[:, 0] == noun) for noun in range(len(NOUNS))]
        write_kinds(folder, Kinds(*map(torch.stack, zip(*found, strict=True))))
    kept = load_file(path)
    middles = kept["middles"].float()
    # A folder from before the choices were kept goes on with the kinds that it has.
    return Kinds(middles, kept.get("choices", torch.full(middles.shape[:2], ANY)))


def write_kinds(folder: Path, kinds: Kinds) -> None:
    """The folder's from now on."""
    with atomic_file(folder / NAME) as temporary:
        save_file({"middles": kinds.middles.half(), "choices": kinds.choices}, temporary)


def in_order_of(net: SolidNet, kinds: Kinds, nouns: Int[Tensor, " n"]) -> Kinds:
    """The nouns' kinds in the order of the network's own, by what it draws of each without a code:
    what it has learnt of a table of one leg is not to begin with tables of four."""
    middles, choices = kinds.middles.clone(), kinds.choices.clone()
    for noun in nouns.tolist():
        away = torch.cdist(drawn_kinds(net, noun), kinds.middles[noun])
        _, order = linear_sum_assignment(away.numpy())
        middles[noun], choices[noun] = kinds.middles[noun, order], kinds.choices[noun, order]
    return Kinds(middles, choices)


@torch.no_grad()
def drawn_kinds(net: SolidNet, noun: int) -> Float[Tensor, "k c"]:
    """A noun's kinds as the network draws them without a code, as compared."""
    device = net.exit.weight.device
    own = KINDS * noun + 1 + torch.arange(KINDS)
    words = torch.zeros(KINDS, 4, dtype=torch.long)
    words[:, 0], words[:, 3] = noun + 1, own
    code = torch.zeros(KINDS, net.config.latent, device=device)
    triplane = net.triplane(words.to(device), code)
    points = (cells() / EXTENT).expand(KINDS, -1, 3).to(device)
    return compared(in_bytes(net.at(triplane, points).amin(2).cpu() / SCALE))


def _kinds(solids: Solids, which: Tensor) -> tuple[Float[Tensor, "k c"], Int[Tensor, " k"]]:
    """One noun's: as many of each of its choices as these have objects for, at least one; of more
    choices than there are kinds, or of none, by the volumes."""
    choices, count = solids.choices[which].unique(return_counts=True)
    if not 1 < len(choices) <= KINDS:
        return _clusters(_volumes(solids, which), KINDS), torch.full((KINDS,), ANY)
    share = torch.ones_like(count)
    while share.sum() < KINDS:
        share[(count / share).argmax()] += 1
    middles = [
        _clusters(compared(solids.grid[which & (solids.choices == one)]), kinds)
        for one, kinds in zip(choices, share.tolist(), strict=True)
    ]
    return torch.cat(middles), choices.repeat_interleave(share)


def _clusters(found: Float[Tensor, "s c"], count: int) -> Float[Tensor, "{count} c"]:
    """By k-means; a cluster that stays empty keeps its first member."""
    if len(found) <= count:
        nothing = torch.zeros(count, SIDE**3)
        return found[torch.arange(count) % len(found)] if len(found) else nothing
    middles, _ = kmeans2(found.numpy(), count, minit="++", seed=SEED)
    return torch.from_numpy(middles)


def _volumes(solids: Solids, which: Tensor) -> Float[Tensor, "s c"]:
    """As compared, and drawn towards the mean of those of the same choices."""
    own = compared(solids.grid[which])
    choices, of = solids.choices[which].unique(return_inverse=True)
    count = of.bincount(minlength=len(choices))
    means = torch.zeros(len(choices), own.shape[1]).index_add(0, of, own) / count[:, None]
    return torch.lerp(means[of], own, OWN)


def compared(grid: Tensor) -> Float[Tensor, "n c"]:
    """Volumes as they are compared: what is far from the surface counts alike."""
    return (grid.flatten(1).float() * (REACH / NEAR / 127)).clamp(-1, 1)


def kind_rows(solids: Solids, kinds: Kinds) -> Int[Tensor, " s"]:
    """Each object's kind, as the network has it: 1 is the first of the first noun."""
    rows = torch.zeros(len(solids), dtype=torch.long)
    for noun in solids.words[:, 0].unique().tolist():
        index = (solids.words[:, 0] == noun).nonzero()[:, 0]
        by_choice = kinds.choices[noun, 0] != ANY
        found = compared(solids.grid[index]) if by_choice else _volumes(solids, index)
        away = torch.cdist(found, kinds.middles[noun])
        others = solids.choices[index, None] != kinds.choices[noun]
        # Choices that the kinds were found without: whichever is nearest.
        others &= by_choice & ~others.all(1, keepdim=True)
        rows[index] = 1 + KINDS * noun + away.masked_fill(others, torch.inf).argmin(1)
    return rows


def nearest_kind(volume: Int[Tensor, "32 32 32"], middles: Float[Tensor, "k c"]) -> int:
    """Which of the noun's kinds an object is."""
    return int(torch.cdist(compared(volume[None]), middles).argmin())
