"""Runs a task that would block Blender for seconds in a Blender process without a window.

The process gets a copy of one object in a file of its own and answers with a file; this Blender
stays responsive.
"""

from __future__ import annotations

import json
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path

import bpy
import numpy as np

from ..environment import piped_environ
from ..errors import AddonError
from .thread import ReportProgress, Task

WORKER = Path(__file__).with_name("blender_worker.py")
POLL_SECONDS = 0.1  # between two checks for a cancel
USER_ERROR = 2  # the worker's exit code for an AddonError, which it writes to error.json


def start(obj: bpy.types.Object, task_name: str, **options: object) -> Task:
    """Run the task ``task_name`` of :mod:`blender_worker` with ``obj`` as it is now.

    Its result is the folder of the answer, for :func:`load_objects` or :func:`load_pixels`.
    """
    folder = Path(tempfile.mkdtemp(prefix="fantasia3d-"))
    request = {"task": task_name, "object": obj.name, "options": options}
    (folder / "request.json").write_text(json.dumps(request), "utf-8")
    # Here and not in the thread: bpy is not thread-safe.
    # A path that is relative to the open file would mean another place there.
    path = str(folder / "in.blend")
    bpy.data.libraries.write(path, {obj}, path_remap="ABSOLUTE", fake_user=True)

    def run(progress: ReportProgress) -> object:
        try:
            return _run(folder, progress, lambda: task.cancelled)
        except BaseException:
            shutil.rmtree(folder, ignore_errors=True)
            raise

    task = Task(task_name, run)
    return task


def load_objects(folder: Path) -> list[bpy.types.Object]:
    """The objects of the answer in ``folder``, in no collection yet; removes the folder."""
    path = folder / "out.blend"
    try:
        with bpy.data.libraries.load(str(path)) as (source, wanted):
            wanted.objects = source.objects
        for library in list(bpy.data.libraries):  # appending leaves an unused library behind
            if Path(library.filepath) == path:
                bpy.data.libraries.remove(library)
        return list(wanted.objects)
    finally:
        shutil.rmtree(folder, ignore_errors=True)


def load_pixels(folder: Path) -> np.ndarray:
    """The picture of the answer in ``folder``, (H,W,4); removes the folder."""
    try:
        return np.load(folder / "out.npy", allow_pickle=False)
    finally:
        shutil.rmtree(folder, ignore_errors=True)


def command(folder: Path) -> list[str]:
    """The worker's command line: this Blender's program, or the Python that has the bpy module."""
    rest = [str(WORKER), "--", str(folder)]
    if not bpy.app.binary_path:  # bpy as a module
        return [sys.executable, *rest]
    return [bpy.app.binary_path, "--background", "--factory-startup", "--python", *rest]


def _run(folder: Path, progress: ReportProgress, is_cancelled: Callable[[], bool]) -> Path:
    flags = getattr(subprocess, "CREATE_NO_WINDOW", 0)  # Windows: no console window opens
    # A file and not a pipe: nobody would read the pipe, and a full one blocks the worker.
    with (folder / "log.txt").open("wb") as log:
        child = subprocess.Popen(
            command(folder), stdin=subprocess.DEVNULL, stdout=log, stderr=subprocess.STDOUT,
            env=piped_environ(), creationflags=flags,
        )  # fmt: skip
        code = None
        while code is None:
            try:
                code = child.wait(POLL_SECONDS)
            except subprocess.TimeoutExpired:
                if is_cancelled():
                    child.kill()
                    child.wait()
                    raise AddonError("Cancelled.") from None
                progress(*_progress(folder))
    _raise_for(code, folder)
    return folder


def _raise_for(code: int, folder: Path) -> None:
    """The worker's error, if its exit code is not 0."""
    if code == USER_ERROR:
        raise AddonError(*json.loads((folder / "error.json").read_text("utf-8")))
    if code:
        lines = (folder / "log.txt").read_text("utf-8", "replace").strip().splitlines()
        raise AddonError(
            f"Background Blender exited with code {code} ({lines[-1] if lines else 'no output'}).",
            "Run the same tool from a script: it then works in this Blender itself.",
        )


def _progress(folder: Path) -> tuple[str, float]:
    """The worker's present task, and the fraction done."""
    try:
        text, fraction = json.loads((folder / "progress.json").read_text("utf-8"))
        return str(text), float(fraction)
    except (OSError, ValueError):
        return "Starting", 0.0
