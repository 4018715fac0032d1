"""Training of the network that draws solids: a conditional variational autoencoder (Kingma and
Welling 2014; Sohn et al. 2015) over the distances of the families' solids, part by part.
"""

import itertools
from pathlib import Path
from typing import Any, ClassVar, NamedTuple

import torch
import torch.nn.functional as F
from jaxtyping import Bool, Float, Int
from safetensors.torch import load_file
from scipy.spatial import KDTree
from torch import Tensor, nn

from core.geometry.tet_grid import EXTENT
from core.guidance.builtin.offered import read_metadata
from core.guidance.builtin.solid_net import KINDS, PARTS, SCALE, SolidNet, SolidNetConfig
from core.guidance.builtin.weights import load_tensors
from core.prior.data import ADJECTIVES, NOUNS, PART_STATES
from core.prior.solid_data import SOLIDS, Solids, read_solids
from core.prior.solid_kinds import (
    NEAR,
    compared,
    in_order_of,
    kind_rows,
    kinds_of,
    write_kinds,
)
from core.prior.sources import Batches
from core.prior.train import TrainConfig, Training, arithmetic

WORDS = (len(NOUNS), len(ADJECTIVES) - 1, len(PART_STATES) - 1, KINDS * len(NOUNS))
SOLID = SolidNetConfig(WORDS)
FITTING = TrainConfig(minutes=120.0, batch=16, learning_rate=1.5e-3, warm_up=100)
AT_PART = 0.03  # training units, outside of a part at the most
ASKED = 2048  # points of an object in one step
# Nouns of larger errors are drawn more often, within these bounds; the mean of the last so many.
OFTEN, REMEMBERED = (0.5, 3.0), 20
HOLD = 800  # steps in which what was taken over stays, until what is new fits it
PRIOR_WEIGHT = 4e-5  # of the code's distance to the normal distribution, nats
INSIDE = 2.5  # weight of a distance inside the solid
INSIDE_WEIGHT = 0.03  # of the cross entropy of what is inside
STEEPNESS = 8.0  # of its logits, / SCALE of the distance
UNCLEAR = 0.02  # distance, / SCALE, that is neither inside nor outside
PART_WEIGHT = 0.4  # of the error of each part's own distance
OWNER_WEIGHT = 0.03  # of the cross entropy of whose the surface is
OWNER_REACH = 0.6  # within which of the surface that is asked for, / SCALE
ALIKE = 0.01  # training units: how far apart the sides of what is mirrored may be
CHECKED = 4  # objects of a mirrored kind, of which the parts are looked at
STEEPEST = 1.5  # a distance over the way, more than any is
LOG_VARIANCE = (-8.0, 4.0)  # bounds of what the encoder answers


class SolidBatch(NamedTuple):
    """Objects, and what is asked of each."""

    volumes: Float[Tensor, "b 1 32 32 32"]
    words: Int[Tensor, "b 4"]  # rows
    points: Float[Tensor, "b n 3"]  # in [-1, 1]³
    distances: Float[Tensor, "b n 8"]  # of the parts, times SCALE
    errors: Float[Tensor, " m"]  # each noun's, in the mean over the last ones; the loss adds to it


class Encoder(nn.Module):
    """A volume of distances and the words' embedding to a code's mean and log variance."""

    def __init__(self, config: SolidNetConfig) -> None:
        super().__init__()
        widths, hidden = (1, 16, 32, 64), 256
        layers: list[nn.Module] = []
        for inner, outer in itertools.pairwise(widths):
            layers += [nn.Conv3d(inner, outer, 4, 2, 1), nn.SiLU()]
        self.net = nn.Sequential(*layers, nn.Flatten(), nn.Linear(widths[-1] * 4**3, hidden))
        self.words = nn.Linear(config.embedding, hidden)
        self.exit = nn.Sequential(nn.SiLU(), nn.Linear(hidden, 2 * config.latent))

    def forward(
        self, volume: Float[Tensor, "b 1 32 32 32"], embedding: Float[Tensor, "b e"]
    ) -> tuple[Float[Tensor, "b l"], Float[Tensor, "b l"]]:
        """Mean and log variance."""
        mean, log_variance = self.exit(self.net(volume) + self.words(embedding)).chunk(2, 1)
        return mean.float(), log_variance.float().clamp(*LOG_VARIANCE)


class Autoencoder(nn.Module):
    """What is trained: the decoder, which ships, and the encoder, which does not."""

    def __init__(self, config: SolidNetConfig = SOLID) -> None:
        super().__init__()
        self.config = config
        self.decoder, self.encoder = SolidNet(config), Encoder(config)

    def encode(self, volume: Tensor, words: Int[Tensor, "b n"]) -> tuple[Tensor, Tensor]:
        """Mean and log variance of the objects' codes."""
        return self.encoder(volume, self.decoder.embedding(words))


class SolidSource:
    """Batches of objects from the data folder; more files are read as they come."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.kinds = kinds_of(folder)
        self.errors = torch.ones(len(NOUNS))  # of each noun, in the mean over the last ones drawn
        self.paths: list[Path] = []
        self.rescan()

    def rescan(self) -> None:
        """Read the files, if there are new ones."""
        paths = sorted(self.folder.glob(SOLIDS))
        if paths != self.paths:
            self.paths, self.samples = paths, read_solids(paths)
            kinds = kind_rows(self.samples, self.kinds)
            self.rows = torch.cat([self.samples.rows(), kinds[:, None]], 1)
            self.mirrored = self._mirrored()

    def order_kinds(self, net: SolidNet) -> None:
        """As the network has them that a training goes on with."""
        self.kinds = in_order_of(net, self.kinds, self.samples.words[:, 0].unique())
        write_kinds(self.folder, self.kinds)
        self.paths = []
        self.rescan()

    def batch(self, count: int, generator: torch.Generator) -> SolidBatch:
        """Random objects, and some of the points of each; nouns with large errors more often."""
        often = (self.errors / self.errors.mean()).clamp(*OFTEN)
        chance = often[self.samples.words[:, 0].long()]
        index = torch.multinomial(chance, count, replacement=True, generator=generator)
        points, distances = asked(self.samples, index, ASKED, generator)
        volumes, rows = self.samples.volumes(index), self.rows[index]
        return SolidBatch(volumes, rows, points, distances, self.errors)

    def counts(self) -> Float[Tensor, "a p k"]:
        """How many objects there are, by adjective, state of the parts and kind."""
        counts = torch.zeros([count + 1 for count in WORDS[1:]])
        index = tuple(self.rows[:, 1:].T)
        return counts.index_put(index, torch.ones(len(self.rows)), accumulate=True)

    def _mirrored(self) -> Bool[Tensor, "k 2"]:
        """Which kinds have none but objects that are the same on both sides of x = 0, of y = 0."""
        alike = torch.stack([mirrored(self.samples.grid, axis) for axis in (0, 1)], 1)
        unlike = torch.zeros(WORDS[3] + 1, 2).index_add(0, self.rows[:, 3], (~alike).float())
        seen = self.rows[:, 3].bincount(minlength=WORDS[3] + 1) > 0
        found = (unlike == 0) & seen[:, None]
        for kind, axis in found.nonzero().tolist():
            some = (self.rows[:, 3] == kind).nonzero()[:CHECKED, 0]
            found[kind, axis] = all(parts_mirrored(self.samples, int(i), axis) for i in some)
        return found


def mirrored(grid: Int[Tensor, "n s s s"], axis: int) -> Bool[Tensor, " n"]:
    """Which volumes, as ``Solids.grid`` has them, are the same from both ends of an axis."""
    same = []
    for some in grid.split(256):
        here = compared(some)
        there = compared(some.flip(1 + axis))
        same.append((here - there).abs().amax(1) <= ALIKE / NEAR)
    return torch.cat(same)


def parts_mirrored(solids: Solids, index: int, axis: int) -> bool:
    """Whether each of an object's parts is the same from both ends of an axis, as far as its points
    tell: a hot tap and a cold one are not, though their volume is."""
    points = solids.points[index].float() / 32767 * EXTENT
    distances = solids.distances[index].float()
    there = points[:ASKED].clone()
    there[:, axis] *= -1
    gap, near = KDTree(points.numpy()).query(there.numpy())
    # A distance changes no faster than the way.
    away = (distances[near] - distances[:ASKED]).abs().amax(1)
    return bool((away <= STEEPEST * torch.from_numpy(gap) + ALIKE).all())


def asked(
    solids: Solids, index: Tensor, count: int, generator: torch.Generator
) -> tuple[Float[Tensor, "b n 3"], Float[Tensor, "b n 8"]]:
    """``count`` points of each object, in [-1, 1]³, and the parts' distances times SCALE.

    Half of them are at the objects' parts, at each as many: a doll's eyes have 20 points in 4,096,
    and were never learnt.
    """
    points = solids.points[index]
    at_parts = torch.stack([solids.distances[i] for i in index]) < AT_PART  # (b, p, 8)
    chance = (at_parts / at_parts.sum(1, keepdim=True).clamp_min(1)).sum(2)
    some = torch.cat(
        [
            torch.multinomial(chance, count // 2, replacement=True, generator=generator),
            torch.randint(points.shape[1], (len(index), count - count // 2), generator=generator),
        ],
        1,
    )
    points = points.gather(1, some[..., None].expand(-1, -1, 3)).float() / 32767
    distances = torch.stack([solids.distances[i, row] for i, row in zip(index, some, strict=True)])
    return points, (distances.float() * SCALE).clamp(-1, 1)


def solid_loss(training: Training, batch: SolidBatch) -> Tensor:
    """The mean error of the distance and of the parts' own, the cross entropy of whose the surface
    is, the code's prior."""
    volume, words, points, distances, _ = (x.to(training.device) for x in batch)
    net: Autoencoder = training.net  # pyright: ignore[reportAssignmentType]
    with arithmetic(training.device):
        mean, log_variance = net.encode(volume, words)
        noise = torch.randn(mean.shape, generator=training.generator).to(mean)
        triplane = net.decoder.triplane(words, mean + noise * (log_variance / 2).exp())
        found = net.decoder.at(triplane, points)
    whole, distance = found.amin(-1), distances.amin(-1)
    remember(batch, (whole - distance).detach().abs().mean(1).cpu())
    near = distance.abs() < OWNER_REACH
    owner = F.cross_entropy(-STEEPNESS * found[near], distances[near].argmin(-1))
    parts = PARTS * distance_loss(found, distances)
    prior = (mean.square() + log_variance.exp() - 1 - log_variance).sum(1).mean() / 2
    solid = distance_loss(whole, distance) + INSIDE_WEIGHT * inside_loss(whole, distance)
    return solid + PART_WEIGHT * parts + OWNER_WEIGHT * owner + PRIOR_WEIGHT * prior


def remember(batch: SolidBatch, errors: Float[Tensor, " b"]) -> None:
    """Add the objects' errors to their nouns'."""
    for noun, error in zip((batch.words[:, 0] - 1).tolist(), errors, strict=True):
        batch.errors[noun] += (error - batch.errors[noun]) / REMEMBERED


def distance_loss(
    found: Float[Tensor, "*b n"], distance: Float[Tensor, "*b n"]
) -> Float[Tensor, ""]:
    """Mean absolute error; what is rightly farther off than 1 has none (Park et al. 2019,
    "DeepSDF", Eq. 4). Inside it counts more: a wall thinner than the error would be torn."""
    beyond = (distance.abs() >= 1) & (found * distance >= 1)
    weight = torch.where(distance < 0, INSIDE, 1.0)
    return ((found - distance).abs() * weight * ~beyond).mean()


def inside_loss(found: Float[Tensor, "b n"], distance: Float[Tensor, "b n"]) -> Float[Tensor, ""]:
    """Cross entropy of what is inside, by the sign of the distance alone."""
    clear = distance.abs() > UNCLEAR
    inside = (distance < 0).float()
    return F.binary_cross_entropy_with_logits(-STEEPNESS * found[clear], inside[clear])


class SolidTraining(Training):
    """A training of the autoencoder, whose decoder may begin with shipped weights."""

    kind_tables: ClassVar = ("words.3", "kind")
    noun_tables: ClassVar = ("words.0", "own", *kind_tables)
    unshipped: ClassVar = ("encoder.",)
    held_until = HOLD

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        super().__init__(*args, **kwargs)
        self.known: set[str] = set()  # parameters taken over whole

    def advance(self, source: Batches) -> None:
        """One step; what is mirrored is so by all objects that there are."""
        if isinstance(source, SolidSource):
            self.net.decoder.mirrored.copy_(source.mirrored)
        super().advance(source)

    def start_from(self, path: Path) -> None:
        """Begin with a shipped decoder.

        What it lacks begins by chance, but for a layer's further inputs, which count nothing yet.
        The decoder stays at first: by a code that says nothing it would unlearn.
        """
        old = self.shipped(path)
        mirrored = self.net.decoder.mirrored
        with torch.no_grad():
            # What mirrors a kind it has learnt on one side alone.
            known = old["decoder.mirrored"][: len(mirrored)]
            mirrored[: len(known)].copy_(known)
            for (name, p), mean in zip(self.net.named_parameters(), self.ema, strict=True):
                if name in old:
                    p.zero_()
                    p[tuple(slice(n) for n in old[name].shape)] = old[name]
                mean.copy_(p)
                if name in old and old[name].shape == p.shape:
                    self.known.add(name)
                    p.register_hook(self._held)

    def hold(self, source: Batches) -> None:
        """As any training's; what was taken over whole waits until ``held_until``."""
        super().hold(source)
        for table in self._noun_tables():
            if f"{table}.weight" in self.known:
                self.net.get_submodule(table).learnt.register_hook(self._held)

    def rows_of(self, table: str, source: Batches) -> Int[Tensor, " r"]:
        """Of the nouns, or of their kinds."""
        assert isinstance(source, SolidSource)
        of_kinds = table.endswith(self.kind_tables)
        return kinds_in(source) if of_kinds else source.samples.words[:, 0].unique().long() + 1

    def shipped(self, path: Path) -> dict[str, Tensor]:
        """The decoder's tensors."""
        return {f"decoder.{name}": tensor for name, tensor in load_tensors(path).items()}

    def _held(self, gradient: Tensor) -> Tensor:
        return gradient if self.step >= self.held_until else torch.zeros_like(gradient)

    def encode_as(self, checkpoint: Path) -> None:
        """Begin with the encoder of an older training: what is taken over need not wait for one."""
        old = load_file(checkpoint)
        with torch.no_grad():
            for (name, p), mean in zip(self.net.named_parameters(), self.ema, strict=True):
                if name.startswith("encoder."):
                    p.copy_(old[f"ema.{name}"])
                    mean.copy_(p)
        self.held_until = 0

    def forget_kinds(self, source: SolidSource) -> None:
        """Begin the kinds of the source's nouns anew: where a family has changed, an older kind is
        of something else, and what comes out at first is between the two."""
        with torch.no_grad():
            for (name, p), mean in zip(self.net.named_parameters(), self.ema, strict=True):
                if name in ("decoder.words.3.weight", "decoder.kind.weight"):
                    p[kinds_in(source)] = 0
                    mean.copy_(p)


def trained_solid_net(folder: Path, before: Path) -> SolidNet:
    """What ships: the decoder of the folder's checkpoint, with its averaged weights; of a held
    training those of its nouns alone, and else what shipped ``before``."""
    net = Autoencoder()
    path = folder / "solid_ema.safetensors"
    weights = {name: tensor.float() for name, tensor in load_file(path).items()}
    net.load_state_dict(net.state_dict() | weights)
    source = SolidSource(folder)
    net.decoder.counts.copy_(source.counts())
    net.decoder.mirrored.copy_(source.mirrored)
    held = read_metadata(folder / "solid.safetensors")["training"]["held"]
    return kept(net.decoder, load_tensors(before), source) if held else net.decoder


def kinds_in(source: SolidSource) -> Int[Tensor, " k"]:
    """The rows of the kinds of the nouns that there are solids of."""
    nouns = source.samples.words[:, 0].unique().long()
    return (KINDS * nouns[:, None] + 1 + torch.arange(KINDS)).flatten()


def kept(net: SolidNet, old: dict[str, Tensor], source: SolidSource) -> SolidNet:
    """``net`` with the older one's tensors, but for the rows of the source's nouns: a checkpoint
    rounds the others."""
    learnt, kinds = source.samples.words[:, 0].unique().long() + 1, kinds_in(source)
    rows = {"words.0.weight": learnt, "own.weight": learnt, "counts": kinds}
    tables = [f"{table}.weight" for table in SolidTraining.noun_tables]
    for name, tensor in net.state_dict().items():
        along = tensor.ndim - 1 if name == "counts" else 0
        if name not in (*tables, "counts", "mirrored"):
            tensor.copy_(old[name])
            continue
        new = tensor.index_select(along, rows.get(name, kinds))
        tensor.narrow(along, 0, old[name].shape[along]).copy_(old[name])
        tensor.index_copy_(along, rows.get(name, kinds), new)
    return net
