"""Solids of the families as numbers: a coarse volume of distances, and points with each part's.

The encoder reads the volume, the decoder is trained at the points. A file contains two objects of
each noun, and takes half a minute of one core.
"""

import math
import multiprocessing
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, fields
from pathlib import Path
from zlib import crc32

import torch
from jaxtyping import Float, Int
from safetensors.torch import load_file, save_file
from torch import Tensor

from core.geometry.tet_grid import EXTENT
from core.guidance.builtin.solid import FORMS
from core.guidance.builtin.solid_net import PARTS
from core.guidance.builtin.stretch import known_wider
from core.guidance.builtin.words.tables.part_tables import OPTIONS
from core.io.atomic import atomic_file
from core.prior.data import ADJECTIVES, NO_PART_STATE, NOUNS, PART_STATES
from core.prior.draw import Draw
from core.prior.families import Shape, build, gradient

SOLIDS = "solids_*.safetensors"
SIDE = 32  # cells along an edge of the volume
REACH = 0.2  # training units: greater distances are clamped to this
ON, NEAR, ANYWHERE = 1536, 1536, 1024  # points of one object: at its surface, about it, in the cube
SPREAD = 0.02  # of the points at the surface
BAND = (0.07, 0.12)  # distance of the cells that points about the surface are drawn from; if few
FEW = 50  # cells
FORMED = 0.3  # fraction of a noun's objects that have the form of an adjective, if it has one
JITTER = 0.02  # of the size
STEP = 2e-3  # of the slope's differences, training units
OF_EACH = 2  # objects of a noun in one file
FIRST_SEED = 7_000_000  # away from the shards' seeds and the evaluation's


@dataclass(frozen=True)
class Solids:
    """Objects, in 8 and 16 bit."""

    grid: Tensor  # (N, 32, 32, 32) int8, distance / REACH × 127, axes x, y, z
    points: Tensor  # (N, p, 3) int16, place / EXTENT × 32767
    distances: Tensor  # (N, p, PARTS) float16, of each part, within ±REACH; REACH for no part
    words: (
        Tensor  # (N, 3) int16: noun, adjective, state of the parts; indices of ``core.prior.data``
    )
    choices: Tensor  # (N,) int64: a number for each outcome of the families' random choices

    def __len__(self) -> int:
        return len(self.words)

    def rows(self) -> Int[Tensor, "n 3"]:
        """The words as rows of the networks' tables."""
        # Every object has a noun, so its row 0 is free for "not stated".
        return self.words.long() + torch.tensor([1, 0, 0])

    def volumes(self, index: "Tensor | slice") -> Float[Tensor, "n 1 32 32 32"]:
        """The distances, in units of REACH."""
        return self.grid[index].float()[:, None] / 127


def make_solids(seed: int, of_each: int = OF_EACH, nouns: Sequence[str] = NOUNS) -> Solids:
    """``of_each`` random objects of each noun."""
    draw = Draw(torch.Generator().manual_seed(FIRST_SEED + seed))
    rows = [_object(NOUNS.index(noun), draw) for noun in nouns for _ in range(of_each)]
    names = [field.name for field in fields(Solids)]
    return Solids(*(torch.stack([getattr(row, name) for row in rows]) for name in names))


def _object(noun: int, draw: Draw) -> Solids:
    forms = [a for kind, a in sorted(FORMS) if kind == NOUNS[noun] and draw.chance(FORMED)]
    adjective = ADJECTIVES.index(forms[0]) if forms else 0
    options = OPTIONS.get(NOUNS[noun], ())
    unstated = draw.chance(NO_PART_STATE) or not options
    state = 0 if unstated else PART_STATES.index(options[int(draw(0, len(options)))])
    own = Draw(draw.generator, PART_STATES[state])
    wider = known_wider(NOUNS[noun])
    shape = build(NOUNS[noun], ADJECTIVES[adjective], own, JITTER, wider)
    points = _points(shape, draw.generator)
    distances = distances_of(shape, points).clamp(-REACH, REACH)
    none = torch.full((len(points), PARTS - distances.shape[1]), REACH)
    return Solids(
        grid=volume_of(shape),
        points=(points / EXTENT * 32767).round().to(torch.int16),
        distances=torch.cat([distances, none], 1).half(),
        words=torch.tensor([noun, adjective, state], dtype=torch.int16),
        choices=torch.tensor(crc32(bytes(own.choices))),
    )


def volume_of(shape: Shape) -> Int[Tensor, "32 32 32"]:
    """Distances at the middles of the volume's cells, in the format of ``Solids.grid``."""
    return in_bytes(distances_of(shape, cells()).amin(1)).view((SIDE,) * 3)


def in_bytes(distance: Float[Tensor, "*n"]) -> Int[Tensor, "*n"]:
    """Distances in training units, converted to the format of ``Solids.grid``."""
    return (distance.clamp(-REACH, REACH) / REACH * 127).round().to(torch.int8)


def distances_of(shape: Shape, points: Float[Tensor, "n 3"]) -> Float[Tensor, "n k"]:
    """Each part's signed distance, to first order also where the shape's scale is uneven.

    The shape's own distance is too short there: a network's error in it would move the surface
    more.
    """
    found, least = shape.distances(points), min(shape.scale) / max(shape.scale)
    if math.isclose(least, 1):
        return found
    steps = STEP * torch.eye(3).to(points)
    sides = [shape.distances(points + step) - shape.distances(points - step) for step in steps]
    slope = torch.stack(sides).norm(dim=0) / (2 * STEP)
    return found / slope.clamp(least, 1)


def cells() -> Float[Tensor, "n 3"]:
    """The middles of the volume's cells."""
    axis = (torch.arange(SIDE) + 0.5) * (2 * EXTENT / SIDE) - EXTENT
    return torch.stack(torch.meshgrid(axis, axis, axis, indexing="ij"), -1).view(-1, 3)


def _points(shape: Shape, generator: torch.Generator) -> Float[Tensor, "p 3"]:
    """Points at the surface, about it, and anywhere in the cube."""

    def sdf(points: Float[Tensor, "n 3"]) -> Float[Tensor, " n"]:
        return distances_of(shape, points).amin(1)

    volume = sdf(cells())
    near = volume.abs() < BAND[0]
    near = near if near.sum() >= FEW else volume.abs() < BAND[1]
    drawn = torch.multinomial(near.float(), ON + NEAR, True, generator=generator)
    jitter = torch.rand(ON + NEAR, 3, generator=generator) - 0.5
    about = cells()[drawn] + jitter * (2 * EXTENT / SIDE)
    on = about[:ON]
    on = on - sdf(on)[:, None] * gradient(sdf, on)
    on = on + SPREAD * torch.randn(on.shape, generator=generator)
    anywhere = (2 * torch.rand(ANYWHERE, 3, generator=generator) - 1) * EXTENT
    return torch.cat([on, about[ON:], anywhere]).clamp(-EXTENT, EXTENT)


def write_solids(
    folder: Path, number: int, of_each: int = OF_EACH, nouns: Sequence[str] = NOUNS
) -> Path:
    """Write the file ``number`` (also the seed) unless the folder has it, by a temporary file."""
    path = folder / SOLIDS.replace("*", f"{number:05d}")
    if not path.exists():
        with atomic_file(path) as temporary:
            save_file(vars(make_solids(number, of_each, nouns)), temporary)
    return path


def _work(job: tuple[Path, int, Sequence[str]]) -> Path:
    torch.set_num_threads(1)
    folder, number, nouns = job
    return write_solids(folder, number, nouns=nouns)


def write_solid_files(
    folder: Path, numbers: range, workers: int, nouns: Sequence[str] = NOUNS
) -> Iterator[Path]:
    """The paths of the files ``numbers`` in ``folder``, each when one of ``workers`` processes has
    written it."""
    if not numbers:
        return
    with multiprocessing.get_context("spawn").Pool(workers) as pool:
        yield from pool.imap(_work, [(folder, number, nouns) for number in numbers])


def read_solids(paths: list[Path]) -> Solids:
    """The solids of several files, joined."""
    parts = [load_file(path) for path in paths]
    names = [field.name for field in fields(Solids)]
    return Solids(*(torch.cat([part[name] for part in parts]) for name in names))
