"""Meshes of the user's: OBJ, PLY, STL, GLB and glTF files, turned as Blender's import would."""

import warnings
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from typing import Any, Literal

import numpy as np
import torch
from PIL.Image import Image as Picture
from torch import Tensor

from core.errors import UserError
from core.geometry.mesh import Mesh, compact
from core.io.input_file import check_file, check_size
from core.ops import srgb_to_linear

# Formats whose files are +Y up; Blender's importers turn them, and leave the others alone.
Y_UP = {".obj", ".glb", ".gltf"}
Z_UP = {".ply", ".stl"}
MAX_BYTES = 1 << 30  # 20 million faces of an STL; a reader takes many times as much memory
MAX_COORDINATE = 1e15  # its square, and the sum of many, is a float32 still
Needed = Literal["", "uv", "texture"]  # of a mesh file, besides its shape
EXPORT_AGAIN = "Open it in Blender and export it as OBJ, PLY, STL or GLB without compression."


def load_mesh(path: "str | Path", needed: Needed = "") -> Mesh:
    """The mesh of an OBJ, PLY, STL, GLB or glTF file, turned as Blender's import would.

    All parts of a scene are joined, and vertices in one place welded; faces that this closes to a
    line are left out. The uv is kept if all parts have one and share at most one texture; parts
    with textures of their own overlap in uv space. The texture is kept if all parts are of it.

    Raises UserError, its fix in words; also where the parts' materials leave no uv, or no texture,
    and that is ``needed``.
    """
    path = Path(path)
    if path.suffix.lower() not in Y_UP | Z_UP:
        raise UserError(
            f"{path.name} is not an OBJ, PLY, STL, GLB or glTF file by its ending.", EXPORT_AGAIN
        )
    check_file(path, fix="Check the path of the mesh.")
    check_size(path, MAX_BYTES, "Decimate it in Blender, and export it again.")
    parts = _read_parts(path)
    if not parts:
        raise UserError(
            f"{path.name} holds no faces.", "Give a mesh with faces, not points or curves."
        )
    verts, faces = _join([(p.verts, p.faces) for p in parts])
    if not (np.abs(verts) < MAX_COORDINATE).all():  # false for NaN too
        raise UserError(
            f"{path.name} has vertices that are not finite numbers, or too large.", EXPORT_AGAIN
        )
    if path.suffix.lower() in Y_UP:
        verts = np.stack([verts[:, 0], -verts[:, 2], verts[:, 1]], 1)
    # In float32 as they will be used: what falls together then is welded.
    verts, number = _weld(verts.astype(np.float32))
    welded = number[faces]
    kept = (welded != np.roll(welded, 1, axis=1)).all(1)
    if not kept.any():
        raise UserError(f"{path.name} holds no face with an area.", "Give a mesh with an extent.")
    if needed:
        _check_materials(path, parts, needed)
    uv, face_uvs, texture = _texture(parts, kept)
    verts, faces = compact(torch.from_numpy(verts), torch.from_numpy(welded[kept]))
    return Mesh(verts, faces, uv, face_uvs, texture)


@dataclass(frozen=True, eq=False)
class _Part:
    """One geometry of a file, in its place in the scene; textures as trimesh gives them."""

    verts: np.ndarray
    faces: np.ndarray
    uv: np.ndarray | None
    material: object


def _read_parts(path: Path) -> list[_Part]:
    # Imported here: with what it brings it takes 0.4 CPU seconds of each command's start.
    import trimesh

    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # numpy's, from the depths of a parser
            scene = trimesh.load_scene(path, process=False)
            placed = [scene.graph[node] for node in scene.graph.nodes_geometry]
    except Exception as error:  # whatever a broken file makes a parser raise
        reason = str(error).rstrip(".! ") or type(error).__name__
        raise UserError(f"{path.name} cannot be read: {reason}.", EXPORT_AGAIN) from error
    parts = []
    for matrix, name in placed:
        part = scene.geometry[name]
        if not isinstance(part, trimesh.Trimesh) or not len(part.faces):
            continue
        _check_indices(path, part)
        with np.errstate(all="ignore"):  # not finite, or too large: refused below
            verts = np.asarray(part.vertices) @ matrix[:3, :3].T + matrix[:3, 3]
        mirrored = np.linalg.det(matrix[:3, :3]) < 0
        faces = np.asarray(part.faces)[:, ::-1] if mirrored else np.asarray(part.faces)
        uv, material = getattr(part.visual, "uv", None), getattr(part.visual, "material", None)
        parts.append(_Part(verts, faces, _usable_uv(uv, len(verts)), material))
    return parts


def _usable_uv(uv: object, count: int) -> np.ndarray | None:
    """(count, 2) where the file has that; an OBJ may give a third coordinate, which is no use."""
    found = np.asarray(uv) if uv is not None else np.empty(0)
    if found.ndim != 2 or found.shape[1] < 2 or len(found) != count:
        return None
    # NaN is not less than it, and what is more would be infinite in float32.
    return found[:, :2] if (np.abs(found[:, :2]) < MAX_COORDINATE).all() else None


def _check_indices(path: Path, part: Any) -> None:
    faces, verts = np.asarray(part.faces), np.asarray(part.vertices)
    if verts.ndim != 2 or verts.shape[1] != 3 or faces.ndim != 2 or faces.shape[1] != 3:
        raise UserError(f"{path.name} has vertices that are not three numbers.", EXPORT_AGAIN)
    if faces.min() < 0 or faces.max() >= len(verts):
        raise UserError(f"{path.name} has a face without one of its vertices.", EXPORT_AGAIN)


def _join(meshes: list[tuple[np.ndarray, np.ndarray]]) -> tuple[np.ndarray, np.ndarray]:
    """Meshes as one: points (of any dimension) in a row, indices shifted."""
    start = np.cumsum([0] + [len(points) for points, _ in meshes[:-1]])
    indices = [index + s for (_, index), s in zip(meshes, start, strict=True)]
    return np.concatenate([points for points, _ in meshes]), np.concatenate(indices)


def _weld(points: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """The distinct points, in the order of their first mention, and each point's number."""
    _, first, number = np.unique(points, axis=0, return_index=True, return_inverse=True)
    order = np.argsort(first)
    rank = np.empty_like(order)
    rank[order] = np.arange(len(order))
    return points[first[order]], rank[number.reshape(-1)]


def _texture(
    parts: list[_Part], kept: np.ndarray
) -> tuple[Tensor | None, Tensor | None, Tensor | None]:
    """uv, face_uvs and the base colour of the parts, if they go together."""
    if any(part.uv is None for part in parts) or not _same_picture(parts):
        return None, None, None
    uv, face_uvs = _join([(part.uv, part.faces) for part in parts])
    uv, number = _weld(uv.astype(np.float32))
    texture, image = None, _image(parts[0].material)
    if image is not None and _same_colors(parts):
        srgb = torch.from_numpy(_pixels(image).astype(np.float32) / 255)
        texture = srgb_to_linear(srgb) * _factor(parts[0].material)
    return torch.from_numpy(uv), torch.from_numpy(number[face_uvs][kept]), texture


def _check_materials(path: Path, parts: list[_Part], needed: Needed) -> None:
    """UserError where the parts have what is ``needed``, but not in common."""
    bare = sum(part.uv is None for part in parts)
    if bare == len(parts):
        return  # the caller that needs a uv reports that there is none
    if bare:
        raise UserError(
            f"{bare} of the {len(parts)} parts of {path.name} have no UV map.",
            "Unwrap them too, or use --uv auto without a base colour.",
        )
    if not _same_picture(parts):
        raise UserError(
            f"{path.name} has several materials with textures of their own: no UV map covers all.",
            "Bake them into one texture with one UV map, or use --uv auto without a base colour.",
        )
    if needed == "texture" and _pictures(parts) and not _same_colors(parts):
        raise UserError(
            f"{path.name} has several materials, not all of which have its texture's colours.",
            "Bake them into one texture, name a picture, or start plain.",
        )


def _same_picture(parts: list[_Part]) -> bool:
    """Whether all textures of the parts are one picture; an OBJ's materials each read their own."""
    return all(
        a.size == b.size and np.array_equal(_pixels(a), _pixels(b))
        for a, b in pairwise(_pictures(parts))
    )


def _pictures(parts: list[_Part]) -> list[Picture]:
    """Those of the parts, each once."""
    images = (_image(part.material) for part in parts)
    return list({id(image): image for image in images if image is not None}.values())


def _same_colors(parts: list[_Part]) -> bool:
    """Whether the parts differ neither in having a texture nor in its factor."""
    looks = {(_image(p.material) is None, *_factor(p.material).tolist()) for p in parts}
    return len(looks) == 1


def _image(material: object) -> Picture | None:
    """The base colour's picture: of a glTF material, or of an OBJ's."""
    named = (getattr(material, name, None) for name in ("baseColorTexture", "image"))
    # A broken file may have anything else there. Where it names none, trimesh makes a grey one up;
    # only a file's has a format.
    images = (image for image in named if isinstance(image, Picture) and image.format)
    return next(images, None)


def _pixels(image: Picture) -> np.ndarray:
    """(H,W,3) uint8; PIL reads the pixels only here."""
    try:
        return np.asarray(image.convert("RGB"))
    except Exception as error:  # whatever a broken picture makes PIL raise
        raise UserError(f"The mesh's texture cannot be read: {error}.", EXPORT_AGAIN) from error


def _factor(material: object) -> Tensor:
    """glTF's linear factor of the texture; 1 for other formats."""
    factor = getattr(material, "baseColorFactor", None)
    factor = np.asarray(factor if factor is not None else ())
    if factor.shape not in ((3,), (4,)) or factor.dtype.kind not in "iuf":
        return torch.ones(3)
    scale = 255 if np.issubdtype(factor.dtype, np.integer) else 1  # trimesh keeps it in 8 bits
    return torch.from_numpy((factor[:3] / scale).astype(np.float32))
