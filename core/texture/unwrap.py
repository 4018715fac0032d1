"""UVs for a mesh that has none (§4.3, "Texturing": "we use xatlas")."""

import subprocess
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

import numpy as np
import torch
from jaxtyping import Float, Int
from torch import Tensor

from core.errors import UserError
from core.texture.files import told_errors

MAX_FACES = 100_000  # xatlas takes half a minute here, and beyond this sometimes hours
TIME_LIMIT = 900.0  # seconds; thirty times what MAX_FACES needs
PATIENCE = 8.0  # times the expected seconds: xatlas's thorough packing of some meshes never ends
PADDING = 4  # texels round each island, so twice this between: bilinear lookup and two mipmaps
WORKER = Path(__file__).with_name("unwrap_worker.py")


class Unwrapped(NamedTuple):
    """An atlas. The mesh stays welded: its vertices keep their indices."""

    uv: Float[Tensor, "u 2"]  # in [0, 1], (0, 0) at the bottom left
    face_uvs: Int[Tensor, "f 3"]


def unwrap(
    verts: Float[Tensor, "v 3"],
    faces: Int[Tensor, "f 3"],
    size: int,
    progress: Callable[[float], None] | None = None,
    time_limit: float = TIME_LIMIT,
) -> Unwrapped:
    """Cut the surface into islands and lay them out for a texture of ``size`` texels a side.

    The same mesh gives the same atlas, unless the machine is so busy that the thorough packing
    is given up for the quick one. ``progress`` is called some times a second with the estimated
    part done, in [0, 1); what it raises stops the work.

    Raises UserError: more than MAX_FACES faces, numbers that are not finite, a mesh that xatlas
    cannot open out, or longer than ``time_limit`` seconds.
    """
    if len(faces) > MAX_FACES:
        raise UserError(
            f"The mesh has {len(faces):,} faces; the unwrap takes {MAX_FACES:,} at most, "
            "above that it can run for hours.",
            "Take a smaller --max-faces, or give the mesh a UV map of its own.",
        )
    if not len(faces) or not bool(torch.isfinite(verts).all()):
        raise UserError(
            "The mesh has no faces, or vertices that are not finite numbers.",
            "Give a mesh that Blender can show.",
        )
    with (
        told_errors(Path(tempfile.gettempdir())),
        tempfile.TemporaryDirectory(prefix="fantasia3d-unwrap-") as name,
    ):
        folder = Path(name)
        np.save(folder / "verts.npy", verts.detach().cpu().float().numpy())
        np.save(folder / "faces.npy", faces.cpu().numpy().astype(np.uint32))
        expected = expected_seconds(len(faces))
        patience = min(PATIENCE * (expected + 1), time_limit / 2)
        if not _run(folder, (size, "thorough"), expected, progress, patience) and not _run(
            folder, (size, "quick"), expected, progress, time_limit - patience
        ):
            raise UserError(
                f"The unwrap was not done after {time_limit:.0f} seconds.",
                "Take a smaller --max-faces, or give the mesh a UV map of its own.",
            )
        uv = torch.from_numpy(np.load(folder / "uv.npy")).to(verts)
        face_uvs = torch.from_numpy(np.load(folder / "face_uvs.npy").astype(np.int64))
    return Unwrapped(uv, face_uvs.to(faces))


def expected_seconds(face_count: int) -> float:
    """Measured on one idle core: 4 s at 20k faces, 12 s at 46k, 29 s at 99k."""
    return 0.5 + 3.5 * (face_count / 20_000) ** 1.3


def _run(
    folder: Path,
    options: tuple[int, str],
    expected: float,
    progress: Callable[[float], None] | None,
    time_limit: float,
) -> bool:
    """Whether the worker ended in time."""
    size, manner = options
    command = [sys.executable, str(WORKER), str(folder), str(size), str(PADDING), manner]
    begin = time.monotonic()
    with (folder / "log.txt").open("wb") as log:
        worker = subprocess.Popen(command, stdout=log, stderr=log, stdin=subprocess.DEVNULL)
        try:
            while _running(worker):
                seconds = time.monotonic() - begin
                if seconds > time_limit:
                    return False
                if progress:
                    progress(min(seconds / expected, 0.99))
        finally:
            worker.kill()
            worker.wait()
    if worker.returncode:
        _explain(worker.returncode, (folder / "log.txt").read_text(errors="replace"))
    return True


def _running(worker: "subprocess.Popen[bytes]") -> bool:
    try:
        worker.wait(timeout=0.25)
    except subprocess.TimeoutExpired:
        return True
    return False


def _explain(code: int, log: str) -> None:
    """Raise what ended the worker: a fault of ours with its traceback, else the mesh's."""
    if "ImportError" in log or "ModuleNotFoundError" in log or "RuntimeError" in log:
        raise RuntimeError(f"the unwrap's process failed with status {code}:\n{log}")
    raise UserError(
        f"xatlas could not unwrap the mesh (status {code}).",
        "Repair the mesh in Blender (Mesh > Clean Up), or give it a UV map of its own.",
    )
