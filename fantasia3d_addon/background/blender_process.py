"""What takes Blender seconds and can't be cut into steps is done by a Blender without a window.

It gets a copy of one object in a file of its own and answers with a file; this Blender stays free.
"""

from __future__ import annotations

import json
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

import bpy
import numpy as np

from ..environment import clean_environ
from ..errors import AddonError
from .thread import Say, Work

CHILD = Path(__file__).with_name("blender_worker.py")
LOOK = 0.1  # seconds between two looks at whether the user gave up
MENDABLE = 2  # the child's exit status for a sentence of ours


def send(obj: bpy.types.Object, task: str, **options: object) -> Work:
    """Have ``task`` (:mod:`blender_worker`) done with ``obj`` as it is now.

    Its result is the folder of the answer, which :func:`objects` or :func:`pixels` take in.
    """
    folder = Path(tempfile.mkdtemp(prefix="fantasia3d-"))
    order = {"task": task, "object": obj.name, "options": options}
    (folder / "order.json").write_text(json.dumps(order), "utf-8")
    bpy.data.libraries.write(str(folder / "in.blend"), {obj}, fake_user=True)

    def go(say: Say) -> object:
        try:
            return _follow(folder, say, lambda: work.cancelled)
        except BaseException:
            shutil.rmtree(folder, ignore_errors=True)
            raise

    work = Work(task, go)
    return work


def objects(folder: Path) -> list[bpy.types.Object]:
    """The objects of the answer in ``folder``, linked nowhere yet; the folder is gone then."""
    path = folder / "out.blend"
    try:
        with bpy.data.libraries.load(str(path)) as (source, wanted):
            wanted.objects = source.objects
        for library in list(bpy.data.libraries):  # an appended file leaves its name behind
            if Path(library.filepath) == path:
                bpy.data.libraries.remove(library)
        return list(wanted.objects)
    finally:
        shutil.rmtree(folder, ignore_errors=True)


def pixels(folder: Path) -> np.ndarray:
    """The picture of the answer in ``folder``, (H,W,4); the folder is gone then."""
    try:
        return np.load(folder / "out.npy", allow_pickle=False)
    finally:
        shutil.rmtree(folder, ignore_errors=True)


def command(folder: Path) -> list[str]:
    """The program that answers: this Blender's, or the Python that holds the bpy module."""
    rest = [str(CHILD), "--", str(folder)]
    if not bpy.app.binary_path:
        return [sys.executable, *rest]
    return [bpy.app.binary_path, "--background", "--factory-startup", "--python", *rest]


def _follow(folder: Path, say: Say, stopped) -> Path:
    flags = getattr(subprocess, "CREATE_NO_WINDOW", 0)  # Windows: no console pops up
    with (folder / "log.txt").open("wb") as log:
        child = subprocess.Popen(
            command(folder), stdin=subprocess.DEVNULL, stdout=log, stderr=subprocess.STDOUT,
            env=clean_environ(), creationflags=flags,
        )  # fmt: skip
        while True:
            try:
                status = child.wait(LOOK)
                break
            except subprocess.TimeoutExpired:
                if stopped():
                    child.kill()
                    child.wait()
                    raise AddonError("It was stopped.") from None
                said = _said(folder)
                say(said[0], said[1])
    if status == MENDABLE:
        raise AddonError(*json.loads((folder / "error.json").read_text("utf-8")))
    if status:
        lines = (folder / "log.txt").read_text("utf-8", "replace").strip().splitlines()
        raise AddonError(
            f"The Blender that helps ended with {status} ({lines[-1] if lines else 'no word'}).",
            "Call it from a script, where nothing else stands in the way.",
        )
    return folder


def _said(folder: Path) -> tuple[str, float]:
    """What the child does now, and the share that is done."""
    try:
        text, share = json.loads((folder / "progress.json").read_text("utf-8"))
        return str(text), float(share)
    except (OSError, ValueError):
        return "Starting", 0.0
