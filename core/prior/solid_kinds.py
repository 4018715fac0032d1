"""The kinds of each noun's solids, found before the training: a family's random choices, and, where
kinds are left, clusters of the volumes.

Tables with one leg and with four are both tables, and a network that learns them together learns
their mean. A round or an oblong top counts for more than proportions, though these may move more of
the volume; and whether a chair's back has slats or boards hardly shows in the volume.
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

FILES = 30  # files that the kinds are found in
NAME = "kinds.safetensors"
ANY = -1  # choices of a kind that is found by the volume alone
OWN = 0.3  # weight of an object's difference from the mean of the same choices
NEAR = 0.1  # training units: volumes are compared within this of their surfaces
SEED = 0


class Kinds(NamedTuple):
    """The kinds of each noun."""

    middles: Float[Tensor, "n k c"]  # of the kinds' volumes, see ``compared``
    choices: Int[Tensor, "n k"]  # the choices of a kind's objects, or ``ANY``


def kinds_of(folder: Path) -> Kinds:
    """The kinds of the folder's solids, found once and kept in the folder."""
    path = folder / NAME
    if not path.exists():
        solids = read_solids(sorted(folder.glob(SOLIDS))[:FILES])
        found = [_kinds(solids, solids.words[:, 0] == noun) for noun in range(len(NOUNS))]
        write_kinds(folder, Kinds(*map(torch.stack, zip(*found, strict=True))))
    kept = load_file(path)
    middles = kept["middles"].float()
    # A folder of an earlier version has no choices: its kinds stay.
    return Kinds(middles, kept.get("choices", torch.full(middles.shape[:2], ANY)))


def write_kinds(folder: Path, kinds: Kinds) -> None:
    """Write the folder's kinds."""
    with atomic_file(folder / NAME) as temporary:
        save_file({"middles": kinds.middles.half(), "choices": kinds.choices}, temporary)


def in_order_of(net: SolidNet, kinds: Kinds, nouns: Int[Tensor, " n"]) -> Kinds:
    """The nouns' kinds in the order of the network's own, matched by the solids that it draws
    without a code: rows that have learnt a table with one leg must not start with tables of
    four."""
    middles, choices = kinds.middles.clone(), kinds.choices.clone()
    for noun in nouns.tolist():
        away = torch.cdist(drawn_kinds(net, noun), kinds.middles[noun])
        _, order = linear_sum_assignment(away.numpy())
        middles[noun], choices[noun] = kinds.middles[noun, order], kinds.choices[noun, order]
    return Kinds(middles, choices)


@torch.no_grad()
def drawn_kinds(net: SolidNet, noun: int) -> Float[Tensor, "k c"]:
    """A noun's kinds as the network draws them without a code, see ``compared``."""
    device = net.exit.weight.device
    own = KINDS * noun + 1 + torch.arange(KINDS)
    words = torch.zeros(KINDS, 4, dtype=torch.long)
    words[:, 0], words[:, 3] = noun + 1, own
    code = torch.zeros(KINDS, net.config.latent, device=device)
    triplane = net.triplane(words.to(device), code)
    points = (cells() / EXTENT).expand(KINDS, -1, 3).to(device)
    return compared(in_bytes(net.at(triplane, points).amin(2).cpu() / SCALE))


def _kinds(solids: Solids, which: Tensor) -> tuple[Float[Tensor, "k c"], Int[Tensor, " k"]]:
    """The kinds of one noun: for each of its choices a number in proportion to its objects, at
    least one; by the volumes if there are more choices than kinds, or no more than one choice."""
    choices, count = solids.choices[which].unique(return_counts=True)
    if not 1 < len(choices) <= KINDS:
        return _clusters(_volumes(solids, which), KINDS), torch.full((KINDS,), ANY)
    kinds = torch.ones_like(count)
    while kinds.sum() < KINDS:
        kinds[(count / kinds).argmax()] += 1
    middles = [
        _clusters(compared(solids.grid[which & (solids.choices == one)]), number)
        for one, number in zip(choices, kinds.tolist(), strict=True)
    ]
    return torch.cat(middles), choices.repeat_interleave(kinds)


def _clusters(found: Float[Tensor, "s c"], count: int) -> Float[Tensor, "{count} c"]:
    """The middles of ``count`` clusters by k-means; an empty cluster keeps its first member."""
    if len(found) <= count:
        nothing = torch.zeros(count, SIDE**3)
        return found[torch.arange(count) % len(found)] if len(found) else nothing
    middles, _ = kmeans2(found.numpy(), count, minit="++", seed=SEED)
    return torch.from_numpy(middles)


def _volumes(solids: Solids, which: Tensor) -> Float[Tensor, "s c"]:
    """Volumes as ``compared``, moved towards the mean of the volumes with the same choices."""
    own = compared(solids.grid[which])
    choices, of = solids.choices[which].unique(return_inverse=True)
    count = of.bincount(minlength=len(choices))
    means = torch.zeros(len(choices), own.shape[1]).index_add(0, of, own) / count[:, None]
    return torch.lerp(means[of], own, OWN)


def compared(grid: Tensor) -> Float[Tensor, "n c"]:
    """Volumes for comparison: all distances above ``NEAR`` count the same."""
    return (grid.flatten(1).float() * (REACH / NEAR / 127)).clamp(-1, 1)


def kind_rows(solids: Solids, kinds: Kinds) -> Int[Tensor, " s"]:
    """The network's row of each object's kind: 1 is the first kind of the first noun."""
    rows = torch.zeros(len(solids), dtype=torch.long)
    for noun in solids.words[:, 0].unique().tolist():
        index = (solids.words[:, 0] == noun).nonzero()[:, 0]
        by_choice = kinds.choices[noun, 0] != ANY
        found = compared(solids.grid[index]) if by_choice else _volumes(solids, index)
        away = torch.cdist(found, kinds.middles[noun])
        others = solids.choices[index, None] != kinds.choices[noun]
        # The kinds were found without such choices: the nearest kind.
        others &= by_choice & ~others.all(1, keepdim=True)
        rows[index] = 1 + KINDS * noun + away.masked_fill(others, torch.inf).argmin(1)
    return rows


def nearest_kind(volume: Int[Tensor, "32 32 32"], middles: Float[Tensor, "k c"]) -> int:
    """The index of the noun's kind that is nearest to an object."""
    return int(torch.cdist(compared(volume[None]), middles).argmin())
