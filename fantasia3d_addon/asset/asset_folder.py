"""Reads an asset folder: asset.json and the welded mesh. No bpy.

The mesh is read here and not by Blender's OBJ importer, which is as exact (and takes 0.15 s for
200,000 faces where this takes 0.5 s) but is an operator: it needs a window, leaves Edit Mode,
changes the selection, and links into the collection that is active when the job ends.
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from ..blender.input_file import parse_json, require_file
from ..environment.files import is_file
from ..errors import AssetError

VERSION = 1
MAX_BYTES = 8 << 20  # asset.json is a few kilobytes
MAX_PIXELS = 1 << 27  # of a map; the core's largest has half of that
FLAT = b"s off"  # the line of an OBJ that is shaded flat
PNG = b"\x89PNG\r\n\x1a\n"
ROLES = ("base_color", "orm", "normal")
OPTIONAL = ("emission", "transmission")  # roles of what glows, and of what lets light through
STRENGTH, IOR = 5.0, 1.45  # of these maps, where an asset gives none
DISTRIBUTIONS = ("GGX", "MULTI_GGX")
REMAKE = "Resume its run, or generate it again."  # the fix for anything incomplete


@dataclass(frozen=True)
class Picture:
    """One of the maps, as asset.json describes it."""

    path: Path
    color_space: str  # "sRGB" or "Non-Color"


class Light(NamedTuple):
    """The emission strength and the IOR of a material's optional maps."""

    strength: float = STRENGTH  # times the emission: the radiance
    ior: float = IOR  # of what the transmission lets through


USUAL = Light()


@dataclass(frozen=True)
class AssetFolder:
    """An asset folder, checked; the mesh in Blender's axes (front -Y, up +Z), in metres."""

    path: Path
    info: dict[str, Any]  # asset.json
    verts: np.ndarray  # (V, 3) float32
    faces: np.ndarray  # (F, 3) int32, counter-clockwise seen from outside
    corner_uv: np.ndarray  # (3 F, 2) float32, (0, 0) bottom left
    pictures: dict[str, Picture]  # by role
    flat: bool = False  # shaded flat, as a low poly mesh is

    @property
    def prompt(self) -> str:
        """The text that the asset was generated from."""
        return str(self.info.get("prompt") or "")

    @property
    def distribution(self) -> str:
        """The microfacet distribution that the maps were learned with."""
        return str(self.info.get("distribution", "GGX"))

    @property
    def light(self) -> Light:
        """The emission strength and the IOR of its optional maps."""
        entries = [entry for entry in self.info["files"].values() if isinstance(entry, dict)]
        by_role = {str(entry.get("role")): entry for entry in entries}
        strength = by_role.get("emission", {}).get("strength", STRENGTH)
        return Light(strength, by_role.get("transmission", {}).get("ior", IOR))


def read_asset(folder: Path) -> AssetFolder:
    """The asset in ``folder``, which may also be the run folder around it.

    Raises:
        AssetError: the folder is not an asset, or a part of it is missing or broken.
    """
    folder = asset_in(folder)
    info = read_info(folder)
    files = _files_by_role(folder, info)
    convention = files["normal"][1].get("convention", "OpenGL")
    if convention != "OpenGL":
        raise AssetError(
            f"{files['normal'][0]} is a {convention} normal map.", "Use one in OpenGL's convention."
        )
    if info.get("distribution", "GGX") not in DISTRIBUTIONS:
        raise AssetError(
            f"asset.json of {folder} has the distribution {info['distribution']!r}.",
            f"This add-on reads {' and '.join(DISTRIBUTIONS)}.",
        )
    verts, faces, corner_uv, flat = read_obj(files["mesh"][0])
    _check_counts(folder, info, len(verts), len(faces))
    maps = {role: files[role] for role in (*ROLES, *OPTIONAL) if role in files}
    pictures = {}
    for role, (path, entry) in maps.items():
        _check_png(path)
        pictures[role] = Picture(path, str(entry.get("color_space", "Non-Color")))
    asset = AssetFolder(folder, info, verts, faces, corner_uv, pictures, flat)
    for number in asset.light:
        # bool is an int, and JSON's NaN is false here.
        if isinstance(number, bool) or not isinstance(number, (int, float)) or not 0 < number < 1e4:
            raise AssetError(
                f"asset.json of {folder} has the strength or ior {number!r} of a map.",
                "Use a number from 0 to 10000.",
            )
    return asset


def _files_by_role(folder: Path, info: dict[str, Any]) -> dict[str, tuple[Path, dict[str, Any]]]:
    """Path and description of the mesh and of each map."""
    files = {}
    for name, entry in info["files"].items():
        if not (isinstance(entry, dict) and isinstance(entry.get("role"), str)):
            continue
        # An asset may come from anywhere: it must not pack other files into the .blend.
        if not _is_plain_name(name):
            raise AssetError(
                f"asset.json of {folder} names {name!r}, which is not a file name.", REMAKE
            )
        files[entry["role"]] = (folder / name, entry)
    for role in ("mesh", *ROLES, *(role for role in OPTIONAL if role in files)):
        if role not in files:
            raise AssetError(f"asset.json of {folder} names no {role.replace('_', ' ')}.", REMAKE)
        if not is_file(files[role][0]):
            raise AssetError(f"{files[role][0]} is missing.", REMAKE)
        if files[role][0].resolve().parent != folder.resolve():
            raise AssetError(f"{files[role][0]} is a link to another folder.", REMAKE)
    return files


def _is_plain_name(name: str) -> bool:
    """Whether ``name`` is a file name and no path, on any system."""
    return name not in ("", ".", "..") and not set(name) & set("/\\:\0")


def asset_in(folder: Path) -> Path:
    """``folder``, or the asset in it where it is a run folder."""
    inside = folder / "asset"
    here, below = (is_file(path / "asset.json") for path in (folder, inside))
    is_run = below and not here
    return inside if is_run else folder


def read_info(folder: Path) -> dict[str, Any]:
    """asset.json of the asset in ``folder``.

    Raises:
        AssetError: it is missing, broken, or of another version.
    """
    folder = asset_in(folder)
    path = folder / "asset.json"
    try:
        require_file(path)
        if path.stat().st_size > MAX_BYTES:
            raise AssetError(f"{path} is larger than {MAX_BYTES >> 20} MB.", REMAKE)
        info = parse_json(path.read_text(encoding="utf-8"))
    except (FileNotFoundError, NotADirectoryError):
        if is_file(folder / "job.json"):
            raise AssetError(
                f"The run {folder} has not finished: it has no asset yet.",
                "Resume it, under Jobs or by run.py resume.",
            ) from None
        raise AssetError(
            f"{folder} is not an asset: it has no asset.json.",
            "Choose the folder named asset in a run folder.",
        ) from None
    except (OSError, ValueError) as error:
        raise AssetError(f"{path} can't be read ({error}).", REMAKE) from None
    if not isinstance(info, dict) or not isinstance(info.get("files"), dict):
        raise AssetError(f"{path} names no files.", REMAKE)
    for name in ("prompt", "light"):
        if not isinstance(info.get(name, "") or "", str):
            raise AssetError(f"{path} has a {name} that is not text.", REMAKE)
    if info.get("version") != VERSION:
        raise AssetError(
            f"{path} has version {info.get('version')!r}; this add-on reads {VERSION}.",
            "Install the add-on and the core of the same release.",
        )
    return info


def read_obj(path: Path) -> tuple[np.ndarray, np.ndarray, np.ndarray, bool]:
    """Verts (V,3), faces (F,3), uv by corner (3F,2) of a triangle mesh in the OBJ axes of Blender,
    and whether it is shaded flat.

    Those are forward -Z and up Y; what comes back has front -Y and up +Z. Vertices stay as welded
    as they are in the file.

    Raises:
        AssetError: the file is not a triangle mesh with a uv for each corner.
    """
    try:
        require_file(path)
        lines = path.read_bytes().splitlines()
    except OSError as error:
        raise AssetError(f"{path} can't be read ({error.strerror}).", REMAKE) from None
    broken = AssetError(f"{path} is not a triangle mesh with a uv for each corner.", REMAKE)
    try:
        with np.errstate(over="ignore"):  # beyond single precision: not finite, and refused below
            verts = _numbers(lines, b"v ", 3).astype(np.float32)
            uv = _numbers(lines, b"vt ", 2).astype(np.float32)
        corners = _corners(lines)
    except (ValueError, OverflowError):  # OverflowError: a number beyond 64 bits
        raise broken from None
    if len(corners) == 0 or corners.min() < 0:
        raise broken
    # numpy would take a negative index from the end, and Blender crashes on one beyond it.
    if corners[..., 0].max() >= len(verts) or corners[..., 1].max() >= len(uv):
        raise broken
    if not (np.isfinite(verts).all() and np.isfinite(uv).all()):
        raise broken
    # From Y up, -Z forward to Z up, -Y forward.
    upright = np.stack([verts[:, 0], -verts[:, 2], verts[:, 1]], 1)
    faces = corners[..., 0].astype(np.int32)
    corner_uv = uv[corners[..., 1].ravel()]
    return np.ascontiguousarray(upright), np.ascontiguousarray(faces), corner_uv, FLAT in lines


def _check_png(path: Path) -> None:
    """By the file's first and last bytes: decoding it here would block Blender."""
    try:
        with path.open("rb") as file:
            head = file.read(24)
            file.seek(-8, 2)
            end = file.read(4)
    except OSError:
        head = end = b""
    # The header's width and height.
    width, height = int.from_bytes(head[16:20], "big"), int.from_bytes(head[20:24], "big")
    if head[:8] != PNG or not width * height or end != b"IEND":
        raise AssetError(f"{path} is not a picture, or an incomplete one.", REMAKE)
    if width * height > MAX_PIXELS:
        raise AssetError(f"{path} declares {width} x {height} pixels, which is too many.", REMAKE)


def _numbers(lines: list[bytes], key: bytes, width: int) -> np.ndarray:
    # One conversion for all lines: a loop over 100,000 of them takes seconds in Python.
    words = b" ".join(line[len(key) :] for line in lines if line.startswith(key)).split()
    return np.array(words, dtype=np.float64).reshape(-1, width)


def _corners(lines: list[bytes]) -> np.ndarray:
    """Indices (F, 3, 2) of vertex and uv, from 0."""
    found = [line[2:] for line in lines if line.startswith(b"f ")]
    if not found:
        return np.empty((0, 3, 2), np.int64)
    width = b"".join(found[0].split()[:1]).count(b"/") + 1  # v/vt, or v/vt/vn
    if width < 2:
        raise ValueError("no uv")
    words = np.array(b" ".join(found).replace(b"/", b" ").split(), dtype=np.int64)
    return words.reshape(len(found), 3, width)[..., :2] - 1


def _check_counts(folder: Path, info: dict[str, Any], verts: int, faces: int) -> None:
    """Against those in asset.json: a mesh.obj that was cut short is still a valid OBJ."""
    counts = info.get("mesh", {})
    if not isinstance(counts, dict):
        raise AssetError(f"asset.json of {folder} has no counts of the mesh.", REMAKE)
    for name, got in (("verts", verts), ("faces", faces)):
        if counts.get(name, got) != got:
            raise AssetError(
                f"mesh.obj of {folder} has {got} {name}; asset.json has {counts[name]}.", REMAKE
            )
