"""The training set: shards of rendered families (and of real models, see ``core.prior.models``),
written once, read as 8-bit tensors.

One shard is a safetensors file of ``VIEWS`` views each of random objects. Files are written
under a temporary name and renamed, so that a training may read the folder while more shards are
being made.
"""

import math
import multiprocessing
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, fields
from pathlib import Path

import torch
from safetensors.torch import load_file, save_file
from torch import Tensor

from core.camera import CameraConfig, Cameras, sample_cameras
from core.guidance.builtin.nouns.order import ORDER
from core.guidance.builtin.stretch import STRETCH
from core.guidance.builtin.words.tables.part_tables import OPTIONS, PARTS
from core.io.atomic import atomic_file
from core.prior.draw import Draw
from core.prior.families import build
from core.prior.tracer import Pictures, render

SHARDS = "shard_*.safetensors"
MODEL_VIEWS = "models.safetensors"  # views of the real models, see ``core.prior.models``
SIZE = 64
VIEWS = 4  # views of one object
OBJECTS = 256  # objects in one shard
CAMERAS = CameraConfig(distance=(2.9, 3.1), elevation_deg=(-60.0, 78.0))  # bottoms too

NOUNS = ORDER
ADJECTIVES = ["", *STRETCH]
PART_STATES = ["", *PARTS]
# Symmetric objects are soon learnt; objects with legs, handles and holes need more pictures.
NOUN_WEIGHTS = dict.fromkeys(
    ("ball", "cube", "cylinder", "cone", "bottle", "tree", "bowling pin"), 0.5
)
NOUN_WEIGHTS |= dict.fromkeys(("chair", "mug", "table", "stool", "bench", "house", "bucket"), 1.6)
NO_ADJECTIVE = 0.75  # fraction of objects without an adjective
NO_PART_STATE = 0.4  # fraction of objects with options whose caption states none


@dataclass(frozen=True)
class Samples:
    """Views and their contents; 8-bit, see ``pictures``."""

    normal: Tensor  # (N, 3, s, s) int8, × 127
    coverage: Tensor  # (N, 1, s, s) uint8, × 255
    part: Tensor  # (N, s, s) int8
    point: Tensor  # (N, 3, s, s) int8, × 120
    noun: Tensor  # (N,) index into NOUNS
    adjective: Tensor  # (N,) index into ADJECTIVES
    part_state: Tensor  # (N,) index into PART_STATES
    camera: Tensor  # (N, 4) azimuth, elevation, distance, fovy; (N, 6) with a lens shift

    @classmethod
    def of(
        cls, seen: Pictures, cameras: Cameras, noun: int, adjective: int = 0, part_state: int = 0
    ) -> "Samples":
        """One object's pictures; ``noun``, ``adjective`` and ``part_state`` are indices."""
        count = len(cameras)
        facts = [cameras.azimuth % (2 * math.pi), cameras.elevation, cameras.distance, cameras.fovy]
        shift = [] if cameras.shift is None else [cameras.shift]
        return cls(
            normal=(seen.normal * 127).round().to(torch.int8),
            coverage=(seen.coverage * 255).round().to(torch.uint8),
            part=seen.part.to(torch.int8),
            # 127 / 120 = 1.06 training units: objects reach to 1.
            point=(seen.point * 120).round().clamp(-127, 127).to(torch.int8),
            noun=torch.full((count,), noun),
            adjective=torch.full((count,), adjective),
            part_state=torch.full((count,), part_state),
            camera=torch.cat([torch.stack(facts, 1), *shift], 1),
        )

    def __len__(self) -> int:
        return len(self.noun)

    def cameras(self, index: "Tensor | slice" = slice(None)) -> Cameras:
        """The views' cameras."""
        camera = self.camera[index]
        shift = camera[:, 4:] if camera.shape[1] > 4 else None
        return Cameras(*camera[:, :4].unbind(1), shift)

    def pictures(self, index: "Tensor | slice" = slice(None)) -> Tensor:
        """The geometry pictures (N, 4, s, s): [n * o, 2o - 1]."""
        normal = self.normal[index].float() / 127
        return torch.cat([normal, self.coverage[index].float() * (2 / 255) - 1], 1)

    def part_maps(self, index: "Tensor | slice", count: int) -> Tensor:
        """1 where a pixel belongs to a part, else 0 (N, count, s, s)."""
        part = self.part[index].long()
        one = torch.nn.functional.one_hot(part.clamp_min(0), count) * (part >= 0)[..., None]
        return one.permute(0, 3, 1, 2).float()

    def points(self, index: "Tensor | slice" = slice(None)) -> Tensor:
        """The visible points in object space, weighted by coverage (N, 3, s, s)."""
        return self.point[index].float() / 120 * (self.coverage[index].float() / 255)


def make(seed: int, objects: int = OBJECTS, nouns: Sequence[str] = NOUNS) -> Samples:
    """``objects`` random objects of ``nouns``, ``VIEWS`` views of each."""
    generator = torch.Generator().manual_seed(seed)
    draw = Draw(generator)
    weights = torch.tensor([NOUN_WEIGHTS.get(noun, 1.0) * (noun in nouns) for noun in NOUNS])
    rows = []
    for _ in range(objects):
        kind = int(torch.multinomial(weights, 1, generator=generator))
        plain = draw.chance(NO_ADJECTIVE)
        adjective = 0 if plain else 1 + int(draw(0, len(ADJECTIVES) - 1))
        options = OPTIONS.get(NOUNS[kind], ())
        unstated = draw.chance(NO_PART_STATE) or not options
        state = 0 if unstated else PART_STATES.index(options[int(draw(0, len(options)))])
        rows.append(_views(kind, adjective, state, draw))
    return joined(rows)


def _views(noun: int, adjective: int, part_state: int, draw: Draw) -> Samples:
    own = Draw(draw.generator, PART_STATES[part_state])
    shape = build(NOUNS[noun], ADJECTIVES[adjective], own)
    cameras = sample_cameras(VIEWS, CAMERAS, draw.generator)
    return Samples.of(render(shape, cameras, SIZE), cameras, noun, adjective, part_state)


def write_shard(
    folder: Path, number: int, objects: int = OBJECTS, nouns: Sequence[str] = NOUNS
) -> Path:
    """Write shard ``number`` (also the seed) of ``nouns`` unless the folder has it."""
    path = folder / f"shard_{number:05d}.safetensors"
    if not path.exists():
        write_samples(path, make(number, objects, nouns))
    return path


def write_samples(path: Path, samples: Samples) -> None:
    """Write one file of samples, by a temporary file and a rename."""
    with atomic_file(path) as temporary:
        save_file({name: tensor.contiguous() for name, tensor in vars(samples).items()}, temporary)


def _work(job: tuple[Path, int, Sequence[str]]) -> Path:
    # The pool already has a process for each core that is to be used.
    torch.set_num_threads(1)
    folder, number, nouns = job
    return write_shard(folder, number, nouns=nouns)


def write_shards(
    folder: Path, numbers: range, workers: int, nouns: Sequence[str] = NOUNS
) -> Iterator[Path]:
    """The paths of the shards ``numbers`` in ``folder``, each when one of ``workers`` processes has
    written it."""
    folder.mkdir(parents=True, exist_ok=True)
    # A fork would copy torch's thread pools in whatever state they are.
    with multiprocessing.get_context("spawn").Pool(workers) as pool:
        yield from pool.imap(_work, [(folder, number, nouns) for number in numbers])


def read_shards(paths: list[Path]) -> Samples:
    """The samples of several shards, joined."""
    return joined([samples_of(load_file(path)) for path in paths])


def samples_of(tensors: dict[str, Tensor]) -> Samples:
    """The samples of a file's tensors."""
    if "told" in tensors:  # the name of the parts' state in files of earlier versions
        tensors["part_state"] = tensors.pop("told")
    return Samples(**tensors)


def joined(parts: list[Samples]) -> Samples:
    """The samples of all ``parts``, in order."""
    names = [field.name for field in fields(Samples)]
    return Samples(*(torch.cat([getattr(part, name) for part in parts]) for name in names))
