"""The data folder's shards as batches for the trainings of the pictures' networks."""

from abc import ABC, abstractmethod
from pathlib import Path
from typing import Any, ClassVar, Protocol, runtime_checkable

import torch
from torch import Tensor

from core.guidance.builtin.network import BLOCK, camera_map
from core.guidance.builtin.part_map import PARTS
from core.prior.colored import Painter, blurred, lumpy
from core.prior.data import MODEL_VIEWS, NOUNS, SHARDS, Samples, joined, read_shards
from core.prior.draw import Draw

# Nouns with many or similar parts, whose colours are confused most often.
MIXED = ("house", "bench", "candle", "carrot", "cupcake", "fish", "car", "bus", "truck", "train")
MIXED += ("boat", "rocket", "cottage", "church", "lighthouse", "hammer", "axe", "drum")

# Pictures, words, camera maps, and the surface (for the restorer: the soft pictures) or None.
Batch = tuple[Tensor, Tensor, Tensor, Tensor | None]


@runtime_checkable
class Batches(Protocol):
    """A source of a training's batches."""

    samples: Any  # the samples that they are drawn from; len() is their number

    def batch(self, count: int, generator: torch.Generator) -> Any:
        """``count`` random samples, in the form that the objective expects."""
        ...

    def rescan(self) -> None:
        """Read the new files."""
        ...


class Source(ABC):
    """The data folder's samples; new shards are read during the training."""

    names = (SHARDS,)
    noun_weights: ClassVar[dict[str, float]] = {}  # in the draw, where not 1

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.paths = self._shards()
        self._take(read_shards(self.paths))

    def _shards(self) -> list[Path]:
        return [path for name in self.names for path in sorted(self.folder.glob(name))]

    def rescan(self) -> None:
        """Read the new shards."""
        new = [path for path in self._shards() if path not in self.paths]
        if new:
            self.paths += new
            self._take(joined([self.samples, read_shards(new)]))

    def _take(self, samples: Samples) -> None:
        self.samples = samples
        self._weights = torch.tensor([self.noun_weights.get(n, 1.0) for n in NOUNS])[samples.noun]

    def draw(self, count: int, generator: torch.Generator) -> tuple[Tensor, Tensor, Tensor]:
        """Rows of random samples, their geometry pictures, their camera maps."""
        # With replacement, so that the weights stay true within a batch.
        index = torch.multinomial(self._weights, count, replacement=True, generator=generator)
        pictures = self.samples.pictures(index)
        return index, pictures, camera_map(self.samples.cameras(index), pictures.shape[-1] // BLOCK)

    @abstractmethod
    def batch(self, count: int, generator: torch.Generator) -> Batch:
        """Pictures, words, camera maps, and the surface or None."""


class Geometry(Source):
    """Batches of geometry pictures with the noun, the shape adjective and the parts' state."""

    names = (SHARDS, MODEL_VIEWS)  # the models' parts are not known, so they have no painter

    def batch(self, count: int, generator: torch.Generator) -> Batch:
        """Pictures, words, camera maps and no surface."""
        index, pictures, camera = self.draw(count, generator)
        s = self.samples
        # Every picture has a noun, so its row 0 is free for "not stated"; the other tables have
        # their own.
        words = torch.stack([s.noun[index] + 1, s.adjective[index], s.part_state[index]], 1)
        return pictures, words, camera, None


class Appearance(Source):
    """Batches of painted pictures with the noun and ``CAPTION_SLOTS``, and the surface: normals and
    coverage as in ``Samples.pictures``, points weighted by coverage, and the parts."""

    noun_weights: ClassVar = dict.fromkeys(MIXED, 2.5)

    def __init__(self, folder: Path) -> None:
        super().__init__(folder)
        self.painter = Painter()

    def batch(self, count: int, generator: torch.Generator) -> Batch:
        """Pictures, words, camera maps and surfaces."""
        index, shape, camera = self.draw(count, generator)
        captions = self.painter.words(self.samples.noun[index], generator)
        # The same dented normals are lit and given: a dent explains its own shading.
        normals = lumpy(shape[:, :3], generator)
        parts = blurred(self.samples.part_maps(index, PARTS), generator)
        surface = torch.cat([normals, shape[:, 3:], self.samples.points(index), parts], 1)
        pictures = self.painter.pictures(self.samples, index, captions, Draw(generator), normals)
        words = torch.cat([self.samples.noun[index][:, None] + 1, captions], 1)
        return pictures, words, camera, surface
