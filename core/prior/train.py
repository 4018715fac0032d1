"""Training of the prior's networks, on one CPU thread or a GPU, for a budget of minutes.

The learning rate follows the fraction of the budget that is spent, so the budget is the whole
schedule. A checkpoint is written every few minutes; a stopped run continues from it, with the
remaining budget or a new one.
"""

import json
import math
import signal
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any, ClassVar

import torch
from jaxtyping import Int
from safetensors.torch import load_file
from torch import Tensor, nn

from core.device import has_fast_bfloat16
from core.errors import UserError
from core.guidance.builtin.diffusion import TIMES, alpha_bar_schedule
from core.guidance.builtin.hint import CHANNELS, SURFACE, hint
from core.guidance.builtin.network import UNetConfig
from core.guidance.builtin.offered import read_metadata
from core.guidance.builtin.part_map import PARTS
from core.guidance.builtin.weights import load_tensors, save_weights, write_tensors
from core.guidance.builtin.words.grammar.lexicon import SLOTS
from core.guidance.sds import add_noise
from core.prior.colored import CAPTION_SLOTS
from core.prior.data import (
    ADJECTIVES,
    NOUNS,
    PART_STATES,
)
from core.prior.learnt_rows import LearntRows
from core.prior.sources import Batch, Batches
from core.prior.velocity import v_target

Objective = Callable[["Training", Any], Tensor]  # the loss of a batch of the training's source


@dataclass(frozen=True, kw_only=True)
class TrainConfig:
    """The settings of one training."""

    minutes: float = 95.0
    batch: int = 32
    learning_rate: float = 8e-4
    last_fraction: float = 0.02  # of the learning rate, at the end of the budget
    warm_up: int = 200  # steps
    ema: float = 0.999
    drop_both: float = 0.10  # neither words nor camera
    drop_words: float = 0.05
    drop_camera: float = 0.05
    late_fraction: float = 0.5  # of the batch, whose times are drawn from the noisier steps only
    late_from: int = 600
    checkpoint_minutes: float = 2.5
    rescan_minutes: float = 1.0  # look for new shards
    seed: int = 0


# The first entry of the tables is "not stated", which the network does not count as a word.
GEOMETRY = UNetConfig(
    words=(len(NOUNS), len(ADJECTIVES) - 1, len(PART_STATES) - 1), widths=(48, 96, 128, 192)
)
APPEARANCE = UNetConfig(
    words=(len(NOUNS), *(len(SLOTS[slot]) for slot in CAPTION_SLOTS[:-1])),
    widths=(32, 64, 96, 128),
    hint=CHANNELS,
)


def learning_rate(step: int, progress: float, config: TrainConfig) -> float:
    """Warm-up, then half a cosine over the fraction of the budget spent."""
    warm = min(1.0, (step + 1) / config.warm_up)
    decay = 0.5 * (1 + math.cos(math.pi * min(progress, 1.0)))
    return config.learning_rate * warm * (config.last_fraction + (1 - config.last_fraction) * decay)


def drop_conditions(
    words: Tensor, camera: Tensor, config: TrainConfig, generator: torch.Generator
) -> tuple[Tensor, Tensor]:
    """The batch, a part of it without words, camera, or both, for classifier-free guidance."""
    # One number for each picture, so that the three cases exclude one another.
    u = torch.rand(len(words), generator=generator)
    both, words_only = config.drop_both, config.drop_both + config.drop_words
    no_words = u < words_only
    no_camera = (u < both) | ((u >= words_only) & (u < words_only + config.drop_camera))
    # Row 0 is "not stated", a map of zeros "no camera".
    return words * ~no_words[:, None], camera * ~no_camera[:, None, None, None]


def draw_times(count: int, config: TrainConfig, generator: torch.Generator) -> Tensor:
    """Time steps: some uniform, some from the noisy end, where the layout is decided."""
    late = torch.rand(count, generator=generator) < config.late_fraction
    low = torch.where(late, config.late_from, 0)
    return (low + torch.rand(count, generator=generator) * (TIMES - low)).long()


def arithmetic(device: torch.device) -> torch.autocast:
    """The autocast of a network's steps: bfloat16, except on a CPU without units for it, where a
    step of the solids' network takes 7.8 s in bfloat16 and 1.4 s in 32 bit."""
    return torch.autocast(device.type, torch.bfloat16, enabled=has_fast_bfloat16(device))


def denoising_loss(training: "Training", batch: Batch) -> Tensor:
    """The mean squared error of v at random times, with some conditions dropped."""
    x, words, camera, surface = batch
    config, g, device = training.config, training.generator, training.device
    words, camera = drop_conditions(words, camera, config, g)
    t = draw_times(config.batch, config, g).to(device)
    eps = torch.randn(x.shape, generator=g).to(device)
    x, words, camera = (tensor.to(device) for tensor in (x, words, camera))
    given = None
    if surface is not None:  # with the words that are left after some captions were dropped
        given = hint(*surface.to(device).split([SURFACE, PARTS], 1), words)
    alpha_bar = training.alpha_bar[t]
    z_t = add_noise(x, eps, alpha_bar)
    # The network alone: the noise and the error are computed in 32 bit.
    with arithmetic(device):
        v = training.net(z_t, t, words[:, : len(training.net.config.words)], camera, given)
    return (v.float() - v_target(x, eps, alpha_bar)).square().mean()


class Training:
    """A network in training: its weights, their moving average, the optimiser, the time spent."""

    noun_tables: ClassVar[tuple[str, ...]] = ("words.0",)  # a row for each noun
    held_until = 0  # the step up to which loaded weights stay fixed
    unshipped: ClassVar[tuple[str, ...]] = ()  # prefixes of weights that only the training needs

    def __init__(
        self,
        make: Callable[[], nn.Module],
        config: TrainConfig,
        device: "torch.device | str" = "cpu",
        objective: Objective = denoising_loss,
    ) -> None:
        """``make``: the network, with random weights; its ``config`` goes to the shipped file."""
        self.config, self.device = config, torch.device(device)
        self.objective = objective
        torch.manual_seed(config.seed)  # the network's first weights
        self.net: Any = make().to(self.device)
        self._learn(weight_decay=1e-3)
        self.alpha_bar = alpha_bar_schedule().to(self.device)
        self.generator = torch.Generator().manual_seed(config.seed)
        self.step, self.seconds, self.loss = 0, 0.0, float("nan")
        self.held = False

    def _learn(self, weight_decay: float) -> None:
        """Start to train all parameters with a gradient."""
        named = [(name, p) for name, p in self.net.named_parameters() if p.requires_grad]
        self.names, self.params = map(list, zip(*named, strict=True))
        self.ema = [p.detach().clone() for p in self.params]
        self.optimizer = torch.optim.AdamW(
            self.params,
            self.config.learning_rate,
            betas=(0.9, 0.99),
            weight_decay=weight_decay,
            fused=True,
        )

    @property
    def progress(self) -> float:
        """The fraction of the budget that is spent."""
        return self.seconds / (60 * self.config.minutes)

    def advance(self, source: Batches) -> None:
        """One step of the optimiser."""
        start = time.monotonic()
        config = self.config
        loss = self.objective(self, source.batch(config.batch, self.generator))
        self.optimizer.zero_grad()
        loss.backward()
        nn.utils.clip_grad_norm_(self.params, 1.0)
        for group in self.optimizer.param_groups:
            group["lr"] = learning_rate(self.step, self.progress, config)
        self.optimizer.step()
        self.step += 1
        # Shorter at first, so that the average forgets the random weights it starts from.
        keep = min(config.ema, (self.step + 1) / (self.step + 10))
        for mean, parameter in zip(self.ema, self.params, strict=True):
            mean.lerp_(parameter.detach(), 1 - keep)
        self.loss = loss.item() if self.step == 1 else 0.99 * self.loss + 0.01 * loss.item()
        # Only time in steps: reading shards and saving are not part of the budget.
        self.seconds += time.monotonic() - start

    def start_from(self, path: Path) -> None:
        """Start from shipped weights of an older vocabulary, whose words come first in each slot.

        A new word starts as the mean of its slot's words, a new slot as zeros. A stem that the
        older network lacks keeps its initial weights, which change nothing.
        """
        old = self.shipped(path)
        with torch.no_grad():
            for (name, p), mean in zip(self.net.named_parameters(), self.ema, strict=True):
                # A stem adds nothing at first, by its own zeros; with zeros everywhere it could not
                # learn.
                if name not in old and name.startswith("stem."):
                    continue
                if name not in old:
                    p.zero_()
                elif name.startswith("words."):
                    rows = old[name]
                    p[: len(rows)] = rows
                    # Row 0 is "not stated" and no word.
                    p[len(rows) :] = rows[1:].mean(0)
                else:
                    p.copy_(old[name])
                mean.copy_(p)

    def hold(self, source: Batches) -> None:
        """Train only the nouns that the source has samples of.

        The results for the other nouns stay the same to the bit. The weights are first replaced by
        their moving averages.
        """
        with torch.no_grad():
            for p, mean in zip(self.params, self.ema, strict=True):
                p.copy_(mean)
        for name, p in self.net.named_parameters():
            p.requires_grad_(name.startswith(self.unshipped))
        for table in self._noun_tables():
            rows = self.rows_of(table, source).to(self.device)
            self.net.set_submodule(table, LearntRows(self.net.get_submodule(table), rows))
        # No decay: it would shrink the rows.
        self._learn(weight_decay=0.0)
        self.held = True

    def _noun_tables(self) -> list[str]:
        """The names of the modules that are noun tables."""
        names = [name for name, _ in self.net.named_modules()]
        return [name for name in names if name.endswith(self.noun_tables)]

    def rows_of(self, table: str, source: Batches) -> Int[Tensor, " r"]:  # noqa: ARG002
        """The rows of a noun table that the source has samples of."""
        return source.samples.noun.unique().long() + 1

    def shipped(self, path: Path) -> dict[str, Tensor]:
        """The tensors of a shipped file, by their names in this network."""
        return load_tensors(path)

    def save(self, path: Path) -> None:
        """Write all that ``resume`` needs to one file, and the averaged weights next to it."""
        tensors = {f"net.{name}": p for name, p in self.weights().items()}
        for name, p, mean in zip(self.names, self.params, self.ema, strict=True):
            tensors[f"ema.{name}"] = mean
            if state := self.optimizer.state.get(p):
                tensors |= {f"m.{name}": state["exp_avg"], f"v.{name}": state["exp_avg_sq"]}
        facts = {"step": self.step, "seconds": self.seconds, "loss": self.loss, "held": self.held}
        facts["held_until"] = self.held_until
        contiguous = {name: tensor.contiguous() for name, tensor in tensors.items()}
        write_tensors(path, contiguous, {"training": json.dumps(facts)})
        save_weights(
            path.with_name(path.stem + "_ema.safetensors"), self.net.config, self.averaged()
        )

    def weights(self) -> dict[str, Tensor]:
        """All weights, by their names in a network without held tables."""
        return self._whole(self.params)

    def averaged(self) -> dict[str, Tensor]:
        """The moving average of all weights, by the same names."""
        return self._whole(self.ema)

    def _whole(self, learning: list[Tensor]) -> dict[str, Tensor]:
        """All weights, with ``learning`` in the place of the trained ones."""
        found = {name: p.detach() for name, p in self.net.named_parameters()}
        found |= {name: p.detach() for name, p in zip(self.names, learning, strict=True)}
        for table in self._noun_tables() if self.held else ():
            rows = self.net.get_submodule(table)
            found[f"{table}.weight"] = rows.whole(found.pop(f"{table}.learnt"))
        return found

    def resume(self, path: Path, source: Batches) -> None:
        """Continue from ``save``'s file, with samples of the same nouns.

        Raises UserError if a trained parameter is not in the file.
        """
        tensors = load_file(path)
        facts = read_metadata(path)["training"]
        self.step, self.seconds, self.loss = facts["step"], facts["seconds"], facts["loss"]
        self.held_until = facts.get("held_until", self.held_until)
        # The generator's state is not in the file: another seed, or the run would get its first
        # batches again.
        self.generator.manual_seed(self.config.seed + self.step)
        with torch.no_grad():
            for name, p, mean in zip(self.names, self.params, self.ema, strict=True):
                p.copy_(tensors[f"net.{name}"])
                mean.copy_(p)
            if facts.get("held"):
                self.hold(source)
            for name, p, mean in zip(self.names, self.params, self.ema, strict=True):
                saved = tensors.get(f"ema.{name}")
                if saved is None or saved.shape != mean.shape:
                    raise UserError(
                        f"{path} is from a training on other nouns, or from an older version.",
                        "Start from the shipped weights (--start), in another folder.",
                    )
                mean.copy_(saved)
                if f"m.{name}" not in tensors:
                    continue
                self.optimizer.state[p] = {
                    "step": torch.tensor(float(self.step), device=p.device),
                    "exp_avg": torch.empty_like(p).copy_(tensors[f"m.{name}"]),
                    "exp_avg_sq": torch.empty_like(p).copy_(tensors[f"v.{name}"]),
                }


def run(training: Training, source: Batches, checkpoint: Path) -> None:
    """Train until the budget is spent; Ctrl-C and SIGTERM save too."""
    config = training.config
    # Both become KeyboardInterrupt, so that ``finally`` saves.
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    signal.signal(signal.SIGINT, signal.default_int_handler)
    saved = scanned = training.seconds
    try:
        while training.progress < 1:
            training.advance(source)
            if training.step % 100 == 0:
                print(
                    f"step {training.step}  {training.seconds / 60:.1f} min  "
                    f"loss {training.loss:.4f}  samples {len(source.samples)}",
                    flush=True,
                )
            if training.seconds - saved > 60 * config.checkpoint_minutes:
                training.save(checkpoint)
                saved = training.seconds
            if training.seconds - scanned > 60 * config.rescan_minutes:
                source.rescan()
                scanned = training.seconds
    finally:
        training.save(checkpoint)
