"""Pairs of views for the restorer: solids, and the same views of the solids softened."""

import multiprocessing
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

import torch
from jaxtyping import Float
from safetensors.torch import load_file, save_file
from torch import Tensor
from torch.nn.functional import pad

from core.camera import aimed, sample_cameras
from core.io.atomic import atomic_file
from core.prior.data import CAMERAS, NOUNS, SIZE, VIEWS, Samples, joined, samples_of
from core.prior.draw import Draw
from core.prior.families import build
from core.prior.redrawn import Redrawing
from core.prior.soften import CELLS, draw_softness, soft_shape
from core.prior.tracer import Pictures, render

PAIRS = "pairs_*.safetensors"
CLOSE_PAIRS = "close_*.safetensors"
OBJECTS = 64  # objects in one file
REDRAWN = 0.8  # fraction of the soft forms that the solids' network draws, once it is trained
FINDER = 32  # side, pixels, of the pictures that show where an object is
FIRST_SEED = 500_000  # away from the shards' seeds and the evaluation's


@dataclass(frozen=True)
class Pairs:
    """Views of solids with the same views of the solids softened."""

    samples: Samples
    soft: Tensor  # (N, 4, s, s) int8, [n * o, 2o - 1] × 127

    def __len__(self) -> int:
        return len(self.soft)

    def soft_pictures(self, index: "Tensor | slice" = slice(None)) -> Float[Tensor, "n 4 s s"]:
        """The pictures [n * o, 2o - 1] of the softened solids."""
        return self.soft[index].float() / 127


def as_picture(seen: Pictures) -> Float[Tensor, "b 4 s s"]:
    """The geometry pictures [n * o, 2o - 1] of ``seen``."""
    return torch.cat([seen.normal, 2 * seen.coverage - 1], 1)


def make_pairs(
    seed: int,
    objects: int = OBJECTS,
    nouns: Sequence[str] = NOUNS,
    *,
    close: bool = False,
    redrawing: Redrawing | None = None,
) -> Pairs:
    """``objects`` random objects of ``nouns``, and a soft form of each.

    ``close``: close-ups, which show details smaller than a pixel of a whole view. ``redrawing``:
    the solids' network draws most of the soft forms.
    """
    generator = torch.Generator().manual_seed(seed)
    draw = Draw(generator)
    rows, soft = [], []
    for _ in range(objects):
        kind = NOUNS.index(nouns[int(draw(0, len(nouns)))])
        shape = build(NOUNS[kind], "", Draw(generator))
        # A close-up shows the lattice's facets too, whatever their size.
        cells = int(draw(CELLS, 1.5 * CELLS)) if close else CELLS
        if redrawing and draw.chance(REDRAWN):
            softened = redrawing.shape(shape, kind, cells)
        else:
            softened = soft_shape(shape.sdf, draw_softness(draw), generator, cells)
        # The same cameras for both: a pair differs in softness alone.
        cameras = sample_cameras(VIEWS, CAMERAS, generator)
        if close:
            cameras = aimed(cameras, render(softened, cameras, FINDER, 1).coverage[:, 0], generator)
        rows.append(Samples.of(render(shape, cameras, SIZE), cameras, kind))
        soft.append((as_picture(render(softened, cameras, SIZE)) * 127).round().to(torch.int8))
    return Pairs(joined(rows), torch.cat(soft))


def write_pairs(
    folder: Path,
    number: int,
    objects: int = OBJECTS,
    nouns: Sequence[str] = NOUNS,
    *,
    close: bool = False,
) -> Path:
    """Write the file ``number`` unless the folder has it, by a temporary file and a rename.

    If the folder has a trained solids' network, it draws most of the soft forms.
    """
    path = folder / (CLOSE_PAIRS if close else PAIRS).replace("*", f"{number:05d}")
    if not path.exists():
        redrawing = Redrawing.of(folder)
        pairs = make_pairs(FIRST_SEED + number, objects, nouns, close=close, redrawing=redrawing)
        tensors = vars(pairs.samples) | {"soft": pairs.soft}
        with atomic_file(path) as temporary:
            save_file({name: tensor.contiguous() for name, tensor in tensors.items()}, temporary)
    return path


def _work(job: tuple[Path, int, Sequence[str], bool]) -> Path:
    torch.set_num_threads(1)
    folder, number, nouns, close = job
    return write_pairs(folder, number, nouns=nouns, close=close)


def write_pair_files(
    folder: Path,
    numbers: range,
    workers: int,
    nouns: Sequence[str] = NOUNS,
    *,
    close: bool = False,
) -> Iterator[Path]:
    """The paths of the files ``numbers`` in ``folder``, each when one of ``workers`` processes has
    written it."""
    if not numbers:
        return
    with multiprocessing.get_context("spawn").Pool(workers) as pool:
        yield from pool.imap(_work, [(folder, number, nouns, close) for number in numbers])


def read_pairs(paths: list[Path]) -> Pairs:
    """The pairs of several files, joined."""
    parts = [load_file(path) for path in paths]
    soft = torch.cat([part.pop("soft") for part in parts])
    for part in parts:  # no lens shift is a shift of 0
        part["camera"] = pad(part["camera"], (0, 6 - part["camera"].shape[1]))
    return Pairs(joined([samples_of(part) for part in parts]), soft)
