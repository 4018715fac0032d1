"""STL and 3MF of an object of the scene, written by the core, which has both formats."""

from __future__ import annotations

import subprocess
import tempfile
from pathlib import Path

import bpy

from ..asset.export_shape import export_shape
from ..environment import clean_environ
from ..errors import OutputError
from .process import Core

FORMATS = (".stl", ".3mf")
TIMEOUT = 300.0  # seconds; a mesh of a million faces takes ten


def export_print(obj: bpy.types.Object, path: Path, core: Core) -> Path:
    """Write ``obj`` with its modifiers and its place to ``path``, in millimetres, +Z up.

    Raises:
        AddonError: the object has no surface, is not watertight, or the core is not installed.
    """
    path = Path(path).expanduser().absolute()
    if not core.python.exists():
        raise OutputError("STL and 3MF need the installation.", "Press Install in Installation.")
    with tempfile.TemporaryDirectory() as folder:
        shape = Path(folder) / "shape.obj"
        export_shape(obj, shape, bpy.context.evaluated_depsgraph_get())
        done = subprocess.run(
            [str(core.python), "-m", "core", "export", str(shape), "--out", str(path),
             "--format", path.suffix.lower()[1:]],
            cwd=core.root,
            env=clean_environ() | {"PYTHONUTF8": "1"} | dict(core.environ),
            stdin=subprocess.DEVNULL,
            capture_output=True,
            encoding="utf-8",
            timeout=TIMEOUT,
            check=False,
            creationflags=getattr(subprocess, "CREATE_NO_WINDOW", 0),  # Windows: no console opens
        )  # fmt: skip
    if done.returncode:
        said = done.stderr.strip().splitlines() or ["the core gave no reason"]
        raise OutputError(said[-1].removeprefix("error: "), "")
    return path
