"""The shortest run of all stages, in one process that has the method loaded."""

from __future__ import annotations

import contextlib
import json
import os
import sys
from collections.abc import Callable, Iterator
from functools import cache, partial
from pathlib import Path
from typing import Any
from unittest import mock

import numpy as np
import torch
from torch import Tensor

import core.generate as method
from core.appearance.environment import Environment
from core.geometry.tet_grid import tet_grid
from core.guidance.builtin import guidance as builtin
from core.guidance.builtin import solid
from core.guidance.builtin.areas import SolidAreas
from core.guidance.builtin.network import UNet
from core.guidance.builtin.solid import Solid
from core.io import progress
from core.stages import training
from core.texture import packing, unwrap

# Every stage and every phase, each with as few steps as it has a middle with.
FILM = "preview/film"
TINY = {
    "geometry.resolution": "10,12",
    "geometry.fit_steps": 6,
    "geometry.views": 1,
    "geometry.views_at_once": 1,
    "geometry.coarse.steps": 3,
    "geometry.fine.steps": 2,
    "geometry.sharpen.rounds": 1,
    "geometry.sharpen.passes": 1,
    "geometry.sharpen.views": 2,
    "geometry.sharpen.steps": 2,
    "geometry.sharpen.size": 32,
    **{f"geometry.{phase}.rounds": 1 for phase in ("grow", "refine")},
    **{f"geometry.{phase}.steps": 2 for phase in ("grow", "refine")},
    **{f"geometry.{phase}.views": 2 for phase in ("grow", "refine")},
    **{f"geometry.{phase}.denoise_steps": 1 for phase in ("grow", "refine")},
    "appearance.shading": "split_sum",
    "appearance.views": 1,
    **{f"appearance.{phase}.size": 32 for phase in ("early", "late", "refine")},
    "appearance.early.steps": 3,
    "appearance.late.steps": 2,
    "appearance.refine.rounds": 1,
    "appearance.refine.steps": 2,
    "appearance.refine.views": 2,
    "appearance.refine.denoise_steps": 1,
}
OPTIONS = [f"--set={key}={value}" for key, value in TINY.items()]
OPTIONS += ["--texture-size=64", "--max-faces=100"]
# In the order of their kills: where few are made, they fall into the trainings.
STAGES = ("geometry", "appearance", "start", "fit", "unwrap", "bake", "asset")
DRAWN = 24  # cells along an edge, of 64 and 80
PASSES = 1  # for a larger scale in the packing, which would be a third of so short a run


def generate(run: Path) -> list[str]:
    """The command line of a new run."""
    return ["generate", "a red torus", "--out", str(run), *OPTIONS]


def resume(run: Path) -> list[str]:
    """The command line that ends it: as a new run where it has not come to its job.json."""
    return ["resume", str(run)] if (run / "job.json").exists() else generate(run)


def made(run: Path) -> dict[str, bytes]:
    """The asset's files. The seconds of each stage are another matter in each run."""
    files = {path.name: path.read_bytes() for path in sorted((run / "asset").iterdir())}
    info = json.loads(files["asset.json"])
    del info["timings"]
    return files | {"asset.json": json.dumps(info).encode()}


def names(run: Path) -> set[str]:
    """All files in a run folder; there is a log only after a bug."""
    return {path.relative_to(run).as_posix() for path in run.rglob("*")}


def loaded_once() -> list[Any]:
    """The weights and the light are made once, and what a drawn solid is at the same points."""
    light = classmethod(remembered(Environment.of.__func__))
    return [
        mock.patch.object(builtin, "load_weights", remembered(builtin.load_weights)),
        mock.patch.object(builtin, "load_solid_net", remembered(builtin.load_solid_net)),
        mock.patch.object(Environment, "of", light),
        mock.patch.object(Solid, "distances", distances_once()),
    ]


def coarsely_drawn() -> list[Any]:
    """How fine a solid is drawn, and where its parts' colours meet, is not looked at."""
    grid = cache(lambda: tet_grid(DRAWN))
    return [
        mock.patch.object(solid, "_grid", grid),
        mock.patch.object(builtin, "SolidAreas", partial(SolidAreas, cells=DRAWN)),
    ]


def _made_once() -> list[Any]:
    """The packing too, and by fewer passes; and a network's answer for the same pictures."""
    return [
        *loaded_once(),
        mock.patch.object(UNet, "forward", predicted_once()),
        loosely_packed(),
        mock.patch.object(unwrap, "pack", packed_once()),
    ]


@contextlib.contextmanager
def once() -> Iterator[None]:
    """What runs have in common is made once, within."""
    with contextlib.ExitStack() as stack:
        for patch in _made_once():
            stack.enter_context(patch)
        yield


def lighten() -> None:
    """Do what has no part in a fault once, and let every event and checkpoint be written."""
    for patch in (*_made_once(), *coarsely_drawn()):
        patch.start()
    progress.PROGRESS_SECONDS = progress.PROGRESS_FRACTION = 0.0
    training.CHECKPOINT_SECONDS = 0.0
    training.PREVIEW_SECONDS = 1e9  # the first alone: their number would be by the machine's load
    method.PREVIEW_SIZE = 64


def loosely_packed() -> Any:
    """How well the charts fill the texture is not looked at."""
    return mock.patch.object(packing, "CLOSER_PASSES", PASSES)


def distances_once() -> Callable:
    """``Solid.distances``: of a session's time half. It is a function of these alone."""
    distances, found = Solid.distances, {}

    def again(self: Solid, points: Tensor) -> Tensor:
        tensors = (*self.triplane.planes, *self.triplane.fine, points)
        at = tuple(hash(x.cpu().numpy().tobytes()) for x in tensors)
        key = id(self.net), self.frame, self.swell, at
        if key not in found:
            found[key] = distances(self, points)
        return found[key].clone()

    return again


def predicted_once() -> Callable:
    """``UNet.forward``: of the network and these tensors alone."""
    forward, found = UNet.forward, {}

    def again(self: UNet, *tensors: Tensor | None) -> Tensor:
        given = [None if x is None else (x.shape, x.cpu().numpy().tobytes()) for x in tensors]
        key = self, *given
        if torch.is_grad_enabled():
            return forward(self, *tensors)
        if key not in found:
            found[key] = forward(self, *tensors)
        return found[key].clone()

    return again


def packed_once() -> Callable:
    """The packing, remembered, for ``unwrap.pack``. It reports no progress, which a remembered
    result has none of: each session has the same events."""
    pack = remembered(packing.pack)
    return lambda uv, face_uvs, chart, gap, _=None: pack(uv, face_uvs, chart, gap)


def remembered(function: Callable) -> Callable:
    """``function``, whose results serve again for the same arguments."""
    found: dict[tuple, object] = {}

    def again(*args: Any) -> object:
        key = tuple(np.asarray(x).tobytes() if hasattr(x, "__array__") else x for x in args)
        if key not in found:
            found[key] = function(*args)
        return found[key]

    return again


class quiet:  # noqa: N801
    """What is printed goes to a file."""

    def __init__(self, log: Path) -> None:
        self.log = log

    def __enter__(self) -> None:
        sys.stdout.flush()
        sys.stderr.flush()
        self.kept = os.dup(1), os.dup(2)
        file = os.open(self.log, os.O_WRONLY | os.O_CREAT | os.O_TRUNC)
        os.dup2(file, 1)
        os.dup2(file, 2)
        os.close(file)

    def __exit__(self, *_: object) -> None:
        sys.stdout.flush()
        sys.stderr.flush()
        for number, kept in enumerate(self.kept, 1):
            os.dup2(kept, number)
            os.close(kept)
