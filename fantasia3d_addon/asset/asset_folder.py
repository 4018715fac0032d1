"""Reads an asset folder: asset.json and the welded mesh. No bpy.

The mesh is read here and not by Blender's OBJ importer, which is as exact (and takes 0.15 s for
200,000 faces where this takes 0.5 s) but is an operator: it wants a window, leaves edit mode,
changes the selection, and links into whatever collection is active when a job happens to end.
"""

from __future__ import annotations

import json
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from ..errors import AssetError

VERSION = 1
PNG = b"\x89PNG\r\n\x1a\n"
ROLES = ("base_color", "orm", "normal")
DISTRIBUTIONS = ("GGX", "MULTI_GGX")
REMAKE = "Resume its run, or generate it again."


@dataclass(frozen=True)
class Picture:
    """One of the maps, as asset.json describes it."""

    path: Path
    color_space: str  # "sRGB" or "Non-Color"


@dataclass(frozen=True)
class AssetFolder:
    """What an asset folder holds, checked; the mesh in Blender's axes (front -Y, up +Z), metres."""

    path: Path
    info: dict[str, Any]  # asset.json
    verts: np.ndarray  # (V, 3) float32
    faces: np.ndarray  # (F, 3) int32, counter-clockwise seen from outside
    corner_uv: np.ndarray  # (3 F, 2) float32, (0, 0) bottom left
    pictures: dict[str, Picture]  # by role

    @property
    def prompt(self) -> str:
        """What the asset was made from."""
        return str(self.info.get("prompt", ""))

    @property
    def distribution(self) -> str:
        """The microfacet distribution that the maps were learned with."""
        return str(self.info.get("distribution", "GGX"))


def read_asset(folder: Path) -> AssetFolder:
    """The asset in ``folder``, which may also be the run folder around it.

    Raises:
        AssetError: the folder is no asset, or a part of it is missing or broken.
    """
    folder = asset_in(folder)
    info = read_info(folder)
    files = {
        entry["role"]: (folder / name, entry)
        for name, entry in info["files"].items()
        if isinstance(entry, dict) and "role" in entry
    }
    for role in ("mesh", *ROLES):
        if role not in files:
            raise AssetError(f"asset.json of {folder} names no {role.replace('_', ' ')}.", REMAKE)
        if not files[role][0].is_file():
            raise AssetError(f"{files[role][0]} is missing.", REMAKE)
    convention = files["normal"][1].get("convention", "OpenGL")
    if convention != "OpenGL":
        raise AssetError(
            f"{files['normal'][0]} is a {convention} normal map.", "Take an OpenGL one."
        )
    if info.get("distribution", "GGX") not in DISTRIBUTIONS:
        raise AssetError(
            f"asset.json of {folder} has the distribution {info['distribution']!r}.",
            f"This add-on knows {' and '.join(DISTRIBUTIONS)}.",
        )
    verts, faces, corner_uv = read_obj(files["mesh"][0])
    _check_counts(folder, info, len(verts), len(faces))
    for role in ROLES:
        _check_png(files[role][0])
    pictures = {
        role: Picture(path, entry.get("color_space", "Non-Color"))
        for role, (path, entry) in files.items()
        if role in ROLES
    }
    return AssetFolder(folder, info, verts, faces, corner_uv, pictures)


def asset_in(folder: Path) -> Path:
    """``folder``, or the asset in it where it is a run folder."""
    inside = folder / "asset"
    is_run = not (folder / "asset.json").is_file() and (inside / "asset.json").is_file()
    return inside if is_run else folder


def read_info(folder: Path) -> dict[str, Any]:
    """asset.json of the asset in ``folder``.

    Raises:
        AssetError: it is missing, broken, or of another version.
    """
    folder = asset_in(folder)
    path = folder / "asset.json"
    try:
        info = json.loads(path.read_text(encoding="utf-8"))
    except (FileNotFoundError, NotADirectoryError):
        raise AssetError(
            f"{folder} is no asset: it has no asset.json.",
            "Choose the folder named asset inside a run folder.",
        ) from None
    except (OSError, ValueError) as error:
        raise AssetError(f"{path} can't be read ({error}).", REMAKE) from None
    if not isinstance(info, dict) or not isinstance(info.get("files"), dict):
        raise AssetError(f"{path} names no files.", REMAKE)
    if info.get("version") != VERSION:
        raise AssetError(
            f"{path} has version {info.get('version')!r}; this add-on reads {VERSION}.",
            "Install the add-on and the core of the same release.",
        )
    return info


def read_obj(path: Path) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Verts (V,3), faces (F,3), uv by corner (3F,2) of a triangle mesh in the OBJ axes of Blender.

    Those are forward -Z and up Y; what comes back has front -Y and up +Z. Vertices stay as welded
    as they are in the file.

    Raises:
        AssetError: the file is no triangle mesh with a uv for each corner.
    """
    lines = path.read_bytes().splitlines()
    broken = AssetError(f"{path} is no triangle mesh with a uv for each corner.", REMAKE)
    try:
        verts = _numbers(lines, b"v ", 3).astype(np.float32)
        uv = _numbers(lines, b"vt ", 2).astype(np.float32)
        corners = _corners(lines)
    except ValueError:
        raise broken from None
    if len(corners) == 0 or corners.min() < 0:
        raise broken
    if corners[..., 0].max() >= len(verts) or corners[..., 1].max() >= len(uv):
        raise broken
    if not (np.isfinite(verts).all() and np.isfinite(uv).all()):
        raise broken
    upright = np.stack([verts[:, 0], -verts[:, 2], verts[:, 1]], 1)
    faces = corners[..., 0].astype(np.int32)
    return np.ascontiguousarray(upright), np.ascontiguousarray(faces), uv[corners[..., 1].ravel()]


def _check_png(path: Path) -> None:
    """By the file's first and last bytes: to decode it here would hold Blender up."""
    try:
        with path.open("rb") as file:
            head = file.read(24)
            file.seek(-8, 2)
            end = file.read(4)
    except OSError:
        head = end = b""
    sizes = head[16:20], head[20:24]
    if head[:8] != PNG or b"\0\0\0\0" in sizes or end != b"IEND":
        raise AssetError(f"{path} is no picture, or half of one.", REMAKE)


def _numbers(lines: list[bytes], key: bytes, width: int) -> np.ndarray:
    words = b" ".join(line[len(key) :] for line in lines if line.startswith(key)).split()
    return np.array(words, dtype=np.float64).reshape(-1, width)


def _corners(lines: list[bytes]) -> np.ndarray:
    """Indices (F, 3, 2) of vertex and uv, from 0."""
    found = [line[2:] for line in lines if line.startswith(b"f ")]
    if not found:
        return np.empty((0, 3, 2), np.int64)
    width = found[0].split()[0].count(b"/") + 1  # v/vt, or v/vt/vn
    if width < 2:
        raise ValueError("no uv")
    words = np.array(b" ".join(found).replace(b"/", b" ").split(), dtype=np.int64)
    return words.reshape(len(found), 3, width)[..., :2] - 1


def _check_counts(folder: Path, info: dict[str, Any], verts: int, faces: int) -> None:
    """Against asset.json, where it says: a mesh.obj that was cut short parses well."""
    told = info.get("mesh", {})
    for name, got in (("verts", verts), ("faces", faces)):
        if told.get(name, got) != got:
            raise AssetError(
                f"mesh.obj of {folder} has {got} {name}; asset.json says {told[name]}.", REMAKE
            )
