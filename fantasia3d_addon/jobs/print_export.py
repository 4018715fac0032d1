"""Files of an object of the scene that the core writes: for 3D printing and for simulators."""

from __future__ import annotations

import json
import re
import subprocess
import tempfile
from pathlib import Path

import bpy
import numpy as np

from ..asset.asset_folder import VERSION
from ..asset.export_shape import export_shape, obj_text
from ..asset.origin import DENSITY, density_of, origin_of
from ..blender.mesh_arrays import evaluated_object, mesh_object, use_uv_map
from ..environment import piped_environ
from ..environment.files import expanded, write_text
from ..errors import OutputError
from ..mesh import maps
from .process import Core

FORMATS = (".stl", ".3mf")
BODIES = {"urdf": ".urdf", "mjcf": ".xml", "usd-physics": ".usda"}  # each by its ending
TIMEOUT = 300.0  # seconds; a mesh of a million faces takes ten


def export_print(obj: bpy.types.Object, path: Path, core: Core) -> Path:
    """Write ``obj`` with its modifiers and its place to ``path``, in millimetres, +Z up.

    Raises:
        AddonError: the object has no surface, is not watertight, or the core is not installed.
    """
    path = _target(path, core)
    with tempfile.TemporaryDirectory() as folder:
        shape = Path(folder) / "shape.obj"
        export_shape(obj, shape)
        _export(core, shape, path, path.suffix.lower()[1:])
    return path


def export_body(obj: bpy.types.Object, path: Path, kind: str, core: Core) -> Path:
    """Write ``obj`` as a rigid body for a simulator to ``path``, in metres, +Z up.

    Its origin is the body's; rotation, scale and modifiers are applied. The mass is that of its
    rigid body, or its volume times its density. ``kind``: one of BODIES.

    Raises:
        AddonError: as :func:`export_print`; no UVs, no Principled BSDF.
    """
    path = _target(path, core)
    mesh_object(obj)
    with tempfile.TemporaryDirectory() as folder:
        asset = Path(folder) / "asset"
        asset.mkdir()
        _write_asset(obj, asset)
        mass = ["--mass", f"{obj.rigid_body.mass:.9g}"] if obj.rigid_body else []
        _export(core, asset, path, kind, *mass)
    return path


def kind_of(path: Path, chosen: str) -> str:
    """The simulator's format that ``path`` is to be written in; "" for another kind of file.

    ``chosen`` decides between two formats of one ending.
    """
    if chosen in BODIES and path.suffix.lower() in ("", BODIES[chosen]):
        return chosen
    # .usda is USD's own, unless USD Physics was chosen.
    return {".urdf": "urdf", ".xml": "mjcf"}.get(path.suffix.lower(), "")


def _write_asset(obj: bpy.types.Object, folder: Path) -> None:
    """An asset folder of the object as it looks now."""
    found = maps.maps_of(obj)
    with evaluated_object(obj) as evaluated:
        matrix = np.array(evaluated.matrix_world)
        matrix[:3, 3] = 0
        mesh = evaluated.to_mesh()
        try:
            use_uv_map(mesh, maps.uv_map_of(obj))
            text = obj_text(mesh, matrix)
        finally:
            evaluated.to_mesh_clear()
    # An asset's corners name a normal each: that of their vertex.
    write_text(folder / "mesh.obj", re.sub(r"(\d+)/(\d+)", r"\1/\2/\1", text))
    for role, picture in maps.save_images(found, folder, "map").items():
        picture.rename(folder / f"{role}.png")
    info = {"prompt": obj.name, **origin_of(obj), "version": VERSION}
    if DENSITY in obj:
        info["density"] = density_of(obj, 0.0)
    write_text(folder / "asset.json", json.dumps(info))


def _target(path: Path, core: Core) -> Path:
    if not core.python.exists():
        raise OutputError("This format needs the installation.", "Press Install in Installation.")
    return expanded(path, OutputError).absolute()


def _export(core: Core, source: Path, path: Path, kind: str, *more: str) -> None:
    """Have the core write ``source`` as ``kind`` to ``path``."""
    try:
        done = subprocess.run(
            [str(core.python), "-m", "core", "export", str(source), "--out", str(path),
             "--format", kind, *more],
            cwd=core.root,
            env=piped_environ() | dict(core.environ),
            stdin=subprocess.DEVNULL,
            capture_output=True,
            encoding="utf-8",
            errors="replace",
            timeout=TIMEOUT,
            check=False,
            creationflags=getattr(subprocess, "CREATE_NO_WINDOW", 0),  # Windows: no console opens
        )  # fmt: skip
    except OSError as error:
        raise OutputError(
            f"{core.python} can't be started ({error.strerror}).", "Press Install in Installation."
        ) from None
    except subprocess.TimeoutExpired:
        raise OutputError(
            f"{path.name} was not ready after {TIMEOUT:.0f} s.", "Export fewer faces: Create LODs."
        ) from None
    if done.returncode:
        lines = done.stderr.strip().splitlines() or ["the core gave no reason"]
        raise OutputError(lines[-1].removeprefix("error: "), "")
