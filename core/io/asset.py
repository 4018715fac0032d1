"""The asset folder (docs/architecture.md, "The asset folder"): written whole or not at all."""

import json
import shutil
from collections.abc import Callable
from contextlib import ExitStack
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from jaxtyping import Float, UInt8
from torch import Tensor

from core.errors import UserError
from core.geometry.mesh import Mesh, health
from core.geometry.tangents import corner_tangents, shading_normals
from core.geometry.uv_health import uv_health
from core.io import png as images
from core.io.atomic import (
    atomic_file,
    check_target,
    disk_errors,
    left_over,
    refuse_foreign_files,
    restore,
    take_place,
    temporary,
)
from core.io.glb import glb_bytes
from core.io.input_file import check_file, check_name, own_file
from core.io.json_file import read_object
from core.io.maps import (
    EMISSION_STRENGTH,
    IOR,
    OPTIONAL,
    REMAKE,
    Maps,
    read_maps,
    write_maps,
)
from core.io.mesh_file import load_mesh
from core.io.obj import mtl_text, obj_text, read_obj, write_plain_obj
from core.io.png import add_text
from core.io.printing import check_printable, stl_bytes, three_mf_bytes
from core.io.provenance import file_hash, summary

__all__ = [
    "Asset", "check_asset_folder", "check_format", "check_output", "export", "inspect", "place",
    "read_asset", "write_asset", "write_plain_obj",
]  # fmt: skip

VERSION = 1
SIZE_M = 1.0  # the longest side, metres
FILES: dict[str, dict[str, Any]] = {
    "mesh.obj": {"role": "mesh", "axes": "forward -Z, up Y"},
    "mesh.mtl": {"role": "material"},
    "base_color.png": {
        "role": "base_color", "color_space": "sRGB", "channels": "RGB", "bits": 8,
    },
    "orm.png": {
        "role": "orm", "color_space": "Non-Color", "channels": "occlusion, roughness, metallic",
        "bits": 8,
    },
    "normal.png": {
        "role": "normal", "color_space": "Non-Color", "channels": "XYZ", "convention": "OpenGL",
        "tangent_space": "MikkTSpace", "bits": 16,
    },
    # These two only where some of the object glows, or lets light through.
    "emission.png": {
        "role": "emission", "color_space": "sRGB", "channels": "RGB", "bits": 8,
        "strength": EMISSION_STRENGTH,
    },
    "transmission.png": {
        "role": "transmission", "color_space": "Non-Color", "channels": "weight", "bits": 8,
        "ior": IOR,
    },
    "asset.glb": {"role": "glb", "axes": "forward +Z, up +Y"},
    "preview.png": {"role": "preview", "color_space": "sRGB"},
}  # fmt: skip
OWN = {"asset.json", *FILES}  # names of the files that may be replaced
DATA_FILES = ("mesh.obj", "base_color.png", "orm.png", "normal.png", "asset.glb")
FORMATS = ("glb", "obj", "stl", "3mf")  # that are written without Blender


@dataclass(frozen=True, eq=False)
class Asset:
    """An asset folder in memory. Axes as in the core: +Z up, front -Y, metres."""

    folder: Path
    info: dict[str, Any]  # asset.json
    mesh: Mesh
    maps: Maps


def place(verts: Float[Tensor, "v 3"], size: float = SIZE_M) -> Float[Tensor, "v 3"]:
    """Into the world: ``size`` metres on the longest side, on z = 0, centred in x and y."""
    low, high = verts.amin(0), verts.amax(0)
    extent = (high - low).max()
    if not float(extent) > 0:
        raise UserError("All the mesh's vertices are one point.", "Give a mesh with an extent.")
    base = (low + high) / 2
    base[2] = low[2]
    return (verts - base) * (size / extent)


def write_asset(
    folder: Path,
    mesh: Mesh,
    maps: Maps,
    info: dict[str, Any],
    preview: Float[Tensor, "h w c"] | UInt8[np.ndarray, "h w c"] | None = None,
) -> Path:
    """Write the asset into a temporary folder and rename that; an older one is removed only then.

    ``mesh`` is in world axes and metres; ``info`` is what asset.json reports of how it was made;
    ``preview`` is sRGB, in [0, 1] or of 8 bits.

    Raises UserError for a disk that is full or may not be written; nothing new is left then, and
    an older asset stays.
    """
    folder = Path(folder)
    verts, faces, uv, face_uvs = (x.detach().cpu() for x in (mesh.verts, mesh.faces, *mesh.atlas))
    mesh = Mesh(verts.float(), faces, uv.float(), face_uvs, flat=mesh.flat)

    def fill(new: Path) -> None:
        write_maps(new, maps)
        if preview is not None:
            images.write_png(new / "preview.png", preview)
        origin = summary(info)
        for path in new.glob("*.png"):
            add_text(path, {key.title().replace("_", " "): text for key, text in origin.items()})
        _write_mesh(new, mesh, origin)
        report = _report(new, mesh, info)
        text = json.dumps(report, ensure_ascii=False, indent=1, allow_nan=False) + "\n"
        with atomic_file(new / "asset.json") as path:
            path.write_text(text, encoding="utf-8")

    _replace_folder(folder, fill)
    return folder


def read_asset(folder: Path) -> Asset:
    """The asset in ``folder``, which may also be the run folder around it.

    Raises UserError for a folder that is not an asset, or that lacks a part or has a broken one.
    """
    folder = Path(folder)
    if not (folder / "asset.json").is_file() and (folder / "asset" / "asset.json").is_file():
        folder = folder / "asset"
    info = _read_info(folder)
    for name in FILES:
        own_file(folder / name, folder, REMAKE)
    mesh = read_obj(folder / "mesh.obj")
    stated = info.get("mesh", {})
    if not isinstance(stated, dict):
        raise UserError(f"asset.json of {folder} has a mesh entry that is not an object.", REMAKE)
    for name, got in (("verts", len(mesh.verts)), ("faces", len(mesh.faces))):
        if stated.get(name, got) != got:
            raise UserError(
                f"mesh.obj of {folder} has {got} {name}, asset.json states {stated[name]}.", REMAKE
            )
    return Asset(folder, info, mesh, read_maps(folder, info))


def data_files(folder: Path) -> tuple[str, ...]:
    """Those of the asset's files that its job alone decides."""
    optional = (f"{role}.png" for role in OPTIONAL)
    return (*DATA_FILES, *(name for name in optional if (folder / name).is_file()))


def inspect(path: Path) -> dict[str, Any]:
    """The health report of an asset folder, a run folder or a mesh file."""
    path = Path(path)
    if path.is_dir():
        asset = read_asset(path)
        made = {k: v for k, v in asset.info.items() if k not in ("mesh", "files")}
        size = list(asset.maps.base_color.shape[:2])
        report = health(asset.mesh.verts, asset.mesh.faces) | uv_health(asset.mesh)
        return {"path": str(asset.folder), **made, "texture_size": size, "mesh": report}
    mesh = load_mesh(path)
    return {"path": str(path), "uv": mesh.uv is not None, "mesh": health(mesh.verts, mesh.faces)}


def export(folder: Path, format: str, out: Path) -> Path:
    """Write the asset as "glb"; as "obj" with its .mtl and pictures next to it; or, in millimetres
    for printing, as "stl" or "3mf": these of a mesh file too.

    Raises UserError for another format, no asset, a place that cannot be written, or for printing
    a mesh that is not watertight.
    """
    source, out = Path(folder), Path(out)
    check_format(format)
    if out.suffix.lower() != f".{format}":
        raise UserError(f"{out} does not end in .{format}.", f"Name a .{format} file.")
    check_output(out)
    if format in ("stl", "3mf"):
        mesh = load_mesh(source) if source.is_file() else read_asset(source).mesh
        _export_print(mesh, format, out)
        return out
    asset = read_asset(source)
    if format == "glb":
        _copy(asset.folder / "asset.glb", out)
    else:
        _export_obj(asset, out)
    return out


def check_format(format: str) -> None:
    """Refuse what :func:`export` does not write."""
    if format not in FORMATS:
        raise UserError(f"The core does not write {format!r}.", f"Use one of {', '.join(FORMATS)}.")


def check_asset_folder(folder: Path) -> None:
    """Refuse before the work a folder that :func:`write_asset` would refuse after it."""
    with disk_errors(folder):
        refuse_foreign_files(folder, OWN)


def check_output(path: Path) -> None:
    """:func:`check_target`, and UserError for a file of an asset itself, which would be lost."""
    check_target(path)
    # Some systems take Mesh.obj for mesh.obj.
    if path.name.lower() in OWN and (path.parent / "asset.json").exists():
        raise UserError(f"{path} is a file of the asset itself.", "Name another file.")


def _export_print(mesh: Mesh, format: str, out: Path) -> None:
    check_printable(mesh.verts, mesh.faces)
    to_bytes = stl_bytes if format == "stl" else three_mf_bytes
    with atomic_file(out) as new:
        new.write_bytes(to_bytes(mesh.verts, mesh.faces))


def _export_obj(asset: Asset, out: Path) -> None:
    check_name(out)
    roles = ("base_color", "normal", "roughness", "metallic")
    emission = () if asset.maps.emission is None else ("emission",)
    names = {name: f"{out.stem}_{name}.png" for name in (*roles, *emission)}
    for path in (out.with_suffix(".mtl"), *map(out.with_name, names.values())):
        check_output(path)
    normals = shading_normals(asset.mesh)
    of_material = [names[name] for name in roles]
    texts = {
        out: obj_text(asset.mesh, normals, out.stem),
        out.with_suffix(".mtl"): mtl_text(
            out.stem, *of_material, emission=names.get("emission", "")
        ),
    }
    with ExitStack() as files:  # all are written before the first takes its name; the OBJ is last
        for path, content in texts.items():
            files.enter_context(atomic_file(path)).write_text(content, encoding="utf-8")
        for name in ("base_color", "normal", *emission):
            new = files.enter_context(atomic_file(out.with_name(names[name])))
            shutil.copyfile(asset.folder / f"{name}.png", new)
        orm = images.read_png(asset.folder / "orm.png")
        for channel, name in ((1, "roughness"), (2, "metallic")):
            new = files.enter_context(atomic_file(out.with_name(names[name])))
            images.write_png(new, orm[..., [channel] * 3])


def _write_mesh(folder: Path, mesh: Mesh, origin: dict[str, str]) -> None:
    normals = shading_normals(mesh)
    tangents = corner_tangents(mesh, normals.corners)
    paths = {role: folder / f"{role}.png" for role in Maps._fields}
    pictures = {role: path.read_bytes() for role, path in paths.items() if path.is_file()}
    light = {"emission_strength": EMISSION_STRENGTH, "ior": IOR}
    glb = glb_bytes(mesh, normals, tangents, pictures, origin, **light)
    with atomic_file(folder / "asset.glb") as path:
        path.write_bytes(glb)
    with atomic_file(folder / "mesh.mtl") as path:
        emission = "emission.png" if "emission" in pictures else ""
        text = mtl_text("mesh", "base_color.png", "normal.png", emission=emission)
        path.write_text(text, encoding="utf-8")
    with atomic_file(folder / "mesh.obj") as path:
        path.write_text(obj_text(mesh, normals, "mesh"), encoding="ascii")


def _report(folder: Path, mesh: Mesh, info: dict[str, Any]) -> dict[str, Any]:
    """asset.json: what is known here, and what ``info`` adds."""
    size = float((mesh.verts.amax(0) - mesh.verts.amin(0)).max())
    mesh_health = health(mesh.verts, mesh.faces)
    here = {
        "version": VERSION,
        "size_m": round(size, 6),
        "mass_kg": _mass(mesh_health["volume"], info.get("density")),
        "mesh": mesh_health | uv_health(mesh),
        "files": {name: entry for name, entry in FILES.items() if (folder / name).is_file()},
        "hashes": {name: file_hash(folder / name) for name in data_files(folder)},
    }
    return info | here


def _mass(volume: object, density: object) -> float | None:
    """Kilograms, of a closed mesh whose density (kg/m³) is known."""
    if not (isinstance(volume, float) and isinstance(density, float)):
        return None
    return float(f"{abs(volume) * density:.4g}")


def _read_info(folder: Path) -> dict[str, Any]:
    path = folder / "asset.json"
    if not path.exists():
        if (folder / "job.json").is_file():
            raise UserError(
                f"The run {folder} has not finished: it has no asset yet.",
                f"Finish it: run.py resume {folder}",
            )
        raise UserError(f"{folder} is not an asset: it has no asset.json.", REMAKE)
    info = read_object(path, REMAKE)
    version = info.get("version")
    if version != VERSION:
        raise UserError(
            f"{path} has version {version!r}; this core reads {VERSION}.",
            "Read it with the release that wrote it, or make the asset again.",
        )
    return info


def _replace_folder(folder: Path, fill: Callable[[Path], None]) -> None:
    """``fill`` a temporary folder next to ``folder``, then rename it; clean up after a failure.

    Raises UserError where one of the folders that it would remove holds a file of somebody else's.
    """
    new = temporary(folder)
    with disk_errors(folder):
        refuse_foreign_files(folder, OWN)
        _clean_up(folder)
        try:
            new.mkdir(parents=True)
            fill(new)
            take_place(new, folder)
        except BaseException:
            shutil.rmtree(new, ignore_errors=True)
            raise


def _clean_up(folder: Path) -> None:
    """Clean up after killed processes next to ``folder``: an older asset gets its name back."""
    halves = left_over(folder.parent, of=folder.name)
    older = left_over(folder.parent, "old", folder.name)
    for left in (*halves, *older):
        refuse_foreign_files(left, OWN)
    for left in older:
        restore(folder, left)
    for left in halves:
        shutil.rmtree(left, ignore_errors=True)


def _copy(source: Path, to: Path) -> None:
    check_file(source, fix=REMAKE)
    with atomic_file(to) as new:
        shutil.copyfile(source, new)
