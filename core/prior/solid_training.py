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
AT_PART = 0.03  # training units: the greatest distance outside a part of a point at that part
ASKED = 2048  # points of an object in one step
# Nouns with larger errors are drawn more often, within these bounds; an error is a mean over this
# many last ones.
OFTEN, REMEMBERED = (0.5, 3.0), 20
HOLD = 800  # steps in which the loaded weights stay fixed, until the new ones fit them
PRIOR_WEIGHT = 4e-5  # weight of the code's distance to the normal distribution, nats
INSIDE = 2.5  # weight of a distance inside the solid
INSIDE_WEIGHT = 0.03  # weight of the cross entropy of inside and outside
STEEPNESS = 8.0  # of its logits, / SCALE of the distance
UNCLEAR = 0.02  # distance, / SCALE, that is neither inside nor outside
PART_WEIGHT = 0.4  # weight of the error of each part's own distance
OWNER_WEIGHT = 0.03  # weight of the cross entropy of the part that the surface belongs to
OWNER_REACH = 0.6  # distance to the surface within which this cross entropy is computed, / SCALE
MIRROR_TOLERANCE = 0.01  # training units: greatest difference between two mirrored sides
CHECKED = 4  # objects of a mirrored kind whose parts are compared
STEEPEST = 1.5  # bound of the change of a distance over the length of the way
LOG_VARIANCE = (-8.0, 4.0)  # bounds of the encoder's output


class SolidBatch(NamedTuple):
    """Objects, and the points of each with their distances."""

    volumes: Float[Tensor, "b 1 32 32 32"]
    words: Int[Tensor, "b 4"]  # rows
    points: Float[Tensor, "b n 3"]  # in [-1, 1]³
    distances: Float[Tensor, "b n 8"]  # of the parts, times SCALE
    errors: Float[Tensor, " m"]  # each noun's mean over the last ones; the loss updates it


class Encoder(nn.Module):
    """From a volume of distances and the words' embedding to a code's mean and log variance."""

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
        """Mean and log variance of the objects' codes."""
        mean, log_variance = self.exit(self.net(volume) + self.words(embedding)).chunk(2, 1)
        return mean.float(), log_variance.float().clamp(*LOG_VARIANCE)


class Autoencoder(nn.Module):
    """The trained networks: the decoder, which ships, and the encoder, which does not."""

    def __init__(self, config: SolidNetConfig = SOLID) -> None:
        super().__init__()
        self.config = config
        self.decoder, self.encoder = SolidNet(config), Encoder(config)

    def encode(self, volume: Tensor, words: Int[Tensor, "b n"]) -> tuple[Tensor, Tensor]:
        """Mean and log variance of the objects' codes."""
        return self.encoder(volume, self.decoder.embedding(words))


class SolidSource:
    """Batches of objects from the data folder; new files are read during the training."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.kinds = kinds_of(folder)
        self.errors = torch.ones(len(NOUNS))  # each noun's, mean over the last ones drawn
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
        """Put the folder's kinds in the order of a network that the training continues with."""
        self.kinds = in_order_of(net, self.kinds, self.samples.words[:, 0].unique())
        write_kinds(self.folder, self.kinds)
        self.paths = []
        self.rescan()

    def batch(self, count: int, generator: torch.Generator) -> SolidBatch:
        """Random objects, nouns with large errors more often, and some of the points of each."""
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
        """Kinds whose objects are all the same on both sides of x = 0 (column 0) or y = 0 (1)."""
        same = torch.stack([mirrored(self.samples.grid, axis) for axis in (0, 1)], 1)
        different = torch.zeros(WORDS[3] + 1, 2).index_add(0, self.rows[:, 3], (~same).float())
        seen = self.rows[:, 3].bincount(minlength=WORDS[3] + 1) > 0
        found = (different == 0) & seen[:, None]
        for kind, axis in found.nonzero().tolist():
            some = (self.rows[:, 3] == kind).nonzero()[:CHECKED, 0]
            found[kind, axis] = all(parts_mirrored(self.samples, int(i), axis) for i in some)
        return found


def mirrored(grid: Int[Tensor, "n s s s"], axis: int) -> Bool[Tensor, " n"]:
    """Which volumes, in the format of ``Solids.grid``, are the same from both ends of an axis."""
    same = []
    for some in grid.split(256):
        here = compared(some)
        there = compared(some.flip(1 + axis))
        same.append((here - there).abs().amax(1) <= MIRROR_TOLERANCE / NEAR)
    return torch.cat(same)


def parts_mirrored(solids: Solids, index: int, axis: int) -> bool:
    """Whether each of an object's parts is the same from both ends of an axis, by its points: a hot
    tap and a cold one are not, though their volume is."""
    points = solids.points[index].float() / 32767 * EXTENT
    distances = solids.distances[index].float()
    there = points[:ASKED].clone()
    there[:, axis] *= -1
    gap, near = KDTree(points.numpy()).query(there.numpy())
    # A distance changes no faster than the position.
    away = (distances[near] - distances[:ASKED]).abs().amax(1)
    return bool((away <= STEEPEST * torch.from_numpy(gap) + MIRROR_TOLERANCE).all())


def asked(
    solids: Solids, index: Tensor, count: int, generator: torch.Generator
) -> tuple[Float[Tensor, "b n 3"], Float[Tensor, "b n 8"]]:
    """``count`` points of each object, in [-1, 1]³, and the parts' distances times SCALE.

    Half of them are at the objects' parts, the same number at each: a doll's eyes have 20 points of
    4,096, and were never learnt otherwise.
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
    """The loss: the errors of the whole's and of the parts' distances, the cross entropy of the
    part that the surface belongs to, and the code's prior."""
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
    """Update the nouns' mean errors with the objects' errors."""
    for noun, error in zip((batch.words[:, 0] - 1).tolist(), errors, strict=True):
        batch.errors[noun] += (error - batch.errors[noun]) / REMEMBERED


def distance_loss(
    found: Float[Tensor, "*b n"], distance: Float[Tensor, "*b n"]
) -> Float[Tensor, ""]:
    """Mean absolute error; 0 where both distances are beyond 1 on the same side (Park et al. 2019,
    "DeepSDF", Eq. 4). It counts more inside: a wall thinner than the error would be torn."""
    beyond = (distance.abs() >= 1) & (found * distance >= 1)
    weight = torch.where(distance < 0, INSIDE, 1.0)
    return ((found - distance).abs() * weight * ~beyond).mean()


def inside_loss(found: Float[Tensor, "b n"], distance: Float[Tensor, "b n"]) -> Float[Tensor, ""]:
    """Cross entropy of inside and outside, by the sign of the distance alone."""
    clear = distance.abs() > UNCLEAR
    inside = (distance < 0).float()
    return F.binary_cross_entropy_with_logits(-STEEPNESS * found[clear], inside[clear])


class SolidTraining(Training):
    """A training of the autoencoder, whose decoder may start from shipped weights."""

    kind_tables: ClassVar = ("words.3", "kind")
    noun_tables: ClassVar = ("words.0", "own", *kind_tables)
    unshipped: ClassVar = ("encoder.",)
    held_until = HOLD

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        super().__init__(*args, **kwargs)
        self.known: set[str] = set()  # parameters loaded completely

    def advance(self, source: Batches) -> None:
        """One step; all objects of the source decide which kinds are mirrored."""
        if isinstance(source, SolidSource):
            self.net.decoder.mirrored.copy_(source.mirrored)
        super().advance(source)

    def start_from(self, path: Path) -> None:
        """Start from a shipped decoder.

        Weights that it lacks start at random, but a layer's further inputs start at zero. The
        decoder is fixed at first: with a code without information it would forget.
        """
        old = self.shipped(path)
        mirrored = self.net.decoder.mirrored
        with torch.no_grad():
            # The decoder has learnt a mirrored kind on one side alone.
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
        """As in ``Training``; completely loaded parameters stay fixed until ``held_until``."""
        super().hold(source)
        for table in self._noun_tables():
            if f"{table}.weight" in self.known:
                self.net.get_submodule(table).learnt.register_hook(self._held)

    def rows_of(self, table: str, source: Batches) -> Int[Tensor, " r"]:
        """The rows of the source's nouns, or of their kinds."""
        assert isinstance(source, SolidSource)
        of_kinds = table.endswith(self.kind_tables)
        return kinds_in(source) if of_kinds else source.samples.words[:, 0].unique().long() + 1

    def shipped(self, path: Path) -> dict[str, Tensor]:
        """The decoder's tensors, by their names in the autoencoder."""
        return {f"decoder.{name}": tensor for name, tensor in load_tensors(path).items()}

    def _held(self, gradient: Tensor) -> Tensor:
        return gradient if self.step >= self.held_until else torch.zeros_like(gradient)

    def encode_as(self, checkpoint: Path) -> None:
        """Start with an older training's encoder, so that loaded weights need not stay fixed."""
        old = load_file(checkpoint)
        with torch.no_grad():
            for (name, p), mean in zip(self.net.named_parameters(), self.ema, strict=True):
                if name.startswith("encoder."):
                    p.copy_(old[f"ema.{name}"])
                    mean.copy_(p)
        self.held_until = 0

    def forget_kinds(self, source: SolidSource) -> None:
        """Start the kinds of the source's nouns again: where a family has changed, an older kind
        shows another object, and the first results are a mixture of both."""
        with torch.no_grad():
            for (name, p), mean in zip(self.net.named_parameters(), self.ema, strict=True):
                if name in ("decoder.words.3.weight", "decoder.kind.weight"):
                    p[kinds_in(source)] = 0
                    mean.copy_(p)


def trained_solid_net(folder: Path, before: Path) -> SolidNet:
    """The decoder to ship: the folder's checkpoint with its averaged weights; after a held training
    only the rows of its nouns, and everything else from the file ``before``."""
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
    """The rows of the kinds of the source's nouns."""
    nouns = source.samples.words[:, 0].unique().long()
    return (KINDS * nouns[:, None] + 1 + torch.arange(KINDS)).flatten()


def kept(net: SolidNet, old: dict[str, Tensor], source: SolidSource) -> SolidNet:
    """``net`` with the tensors of ``old`` except for the rows of the source's nouns: a checkpoint
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
