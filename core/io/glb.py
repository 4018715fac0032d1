"""One binary glTF 2.0 file with its textures inside.

World (x, y, z) is written as (x, z, -y): +Y up, the front looks along +Z, as glTF has it.
"""

import json
import struct
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np
import torch
from jaxtyping import Float, Int
from torch import Tensor

from core.geometry.faces import outward
from core.geometry.mesh import Mesh
from core.geometry.tangents import Normals
from core.io.obj import to_y_up

FLOAT, UINT = 5126, 5125  # component types
VERTICES, INDICES = 34962, 34963  # buffer targets
LINEAR, MIPMAPS, CLAMP = 9729, 9987, 33071  # sampler
ROLES = ("base_color", "orm", "normal", "emission", "transmission")  # the textures, in their order


@dataclass
class _Buffer:
    """The growing binary part, and the JSON that describes its layout."""

    data: bytearray = field(default_factory=bytearray)
    views: list[dict[str, Any]] = field(default_factory=list)
    accessors: list[dict[str, Any]] = field(default_factory=list)

    def view(self, data: bytes, **more: int) -> int:
        """Append ``data`` at a multiple of four bytes; the index of its view."""
        self.data += bytes(-len(self.data) % 4)
        place = {"buffer": 0, "byteOffset": len(self.data), "byteLength": len(data)}
        self.views.append(place | more)
        self.data += data
        return len(self.views) - 1

    def array(self, array: np.ndarray, kind: str, target: int, bounds: bool = False) -> int:
        """Append rows of numbers; the index of their accessor."""
        entry: dict[str, Any] = {
            "bufferView": self.view(array.astype(array.dtype.newbyteorder("<")).tobytes(),
                                    target=target),
            "componentType": FLOAT if array.dtype == np.float32 else UINT,
            "count": len(array),
            "type": kind,
        }  # fmt: skip
        if bounds:
            entry |= {"min": array.min(0).tolist(), "max": array.max(0).tolist()}
        self.accessors.append(entry)
        return len(self.accessors) - 1


def glb_bytes(
    mesh: Mesh,
    normals: Normals,
    tangents: Float[Tensor, "f 3 4"],
    pictures: dict[str, bytes],
    origin: Mapping[str, str] | None = None,
    *,
    emission_strength: float = 1.0,
    ior: float = 1.5,
) -> bytes:
    """The file. ``pictures`` are the PNG files "base_color", "orm" and "normal", and where the
    object has them "emission", times ``emission_strength``, and "transmission", of ``ior``.

    ``origin`` is kept in the object's extras; its "prompt" names the object.

    Vertices are split where their uv, normals or tangents differ. Both sides of the faces are drawn
    where a back can be seen: of an open mesh, and of one that is inside out.
    """
    uv, face_uvs = mesh.atlas
    corner, index = split_corners(mesh.faces, face_uvs, normals.index, tangents)
    f, fu = mesh.faces.cpu().reshape(-1)[corner], face_uvs.cpu().reshape(-1)[corner]
    u, v = uv.detach().cpu().float()[fu].unbind(1)
    tangent = tangents.cpu().reshape(-1, 4)[corner].float()
    columns = {
        "POSITION": to_y_up(mesh.verts.detach().cpu().float()[f]),
        "NORMAL": to_y_up(normals.corners.cpu().float().reshape(-1, 3)[corner]),
        "TEXCOORD_0": torch.stack([u, 1 - v], -1),  # glTF's v grows downwards
        "TANGENT": torch.cat([to_y_up(tangent[:, :3]), tangent[:, 3:]], -1),
    }
    pictures = {role: pictures[role] for role in ROLES if role in pictures}
    buffer = _Buffer()
    attributes = {
        key: buffer.array(column.numpy(), f"VEC{column.shape[1]}", VERTICES, key == "POSITION")
        for key, column in columns.items()
    }
    indices = buffer.array(index.numpy().astype(np.uint32), "SCALAR", INDICES)
    described = _described(buffer, attributes, indices, pictures, dict(origin or {}))
    material = described["materials"][0]
    if _shows_a_back(mesh):
        material["doubleSided"] = True
    extensions = _light(material, list(pictures), emission_strength, ior)
    if extensions:
        described |= {"extensionsUsed": extensions}
    return _packed(described, bytes(buffer.data))


def _shows_a_back(mesh: Mesh) -> bool:
    """Whether some face can be seen from behind; a mesh that is only cut at its seams is closed."""
    verts, faces = mesh.verts.detach().cpu().double().numpy(), mesh.faces.cpu().numpy()
    if outward(verts, faces):
        return False
    welded, number = np.unique(verts, axis=0, return_inverse=True)
    faces = number.reshape(-1)[faces]
    faces = faces[(faces != np.roll(faces, 1, 1)).all(1)]  # a corner twice: no face any more
    return not outward(welded, faces)


def _light(
    material: dict[str, Any], roles: list[str], emission_strength: float, ior: float
) -> list[str]:
    """Add to ``material`` what glows and what is clear; the names of the extensions that it takes.

    Without KHR_materials_volume a wall is thin: viewers show what is behind it straight.
    """
    extensions: dict[str, dict[str, Any]] = {}
    if "emission" in roles:
        texture = {"index": roles.index("emission")}
        material |= {"emissiveTexture": texture, "emissiveFactor": [1, 1, 1]}
        extensions["KHR_materials_emissive_strength"] = {"emissiveStrength": emission_strength}
    if "transmission" in roles:
        texture = {"index": roles.index("transmission")}
        weight = {"transmissionFactor": 1, "transmissionTexture": texture}
        extensions["KHR_materials_transmission"] = weight
        extensions["KHR_materials_ior"] = {"ior": ior}
    if extensions:
        material["extensions"] = extensions
    return list(extensions)


def split_corners(
    faces: Int[Tensor, "f 3"],
    face_uvs: Int[Tensor, "f 3"],
    face_normals: Int[Tensor, "f 3"],
    tangents: Float[Tensor, "f 3 4"],
) -> tuple[Int[Tensor, " n"], Int[Tensor, " m"]]:
    """A corner (of 3F) for each split vertex, and the split vertex of each of the 3F corners.

    Split vertices are in the order of their welded ones.
    """
    rows = torch.stack([faces, face_uvs, face_normals], -1).cpu().numpy().reshape(-1, 3)
    bits = tangents.cpu().float().numpy().reshape(-1, 4).view(np.int32)
    keys = [*bits.T, *rows.T[::-1]]
    order = np.lexsort(keys)
    changed = np.any([key[order][1:] != key[order][:-1] for key in keys], axis=0)
    label = np.concatenate([[0], changed.cumsum()])
    index = np.empty(len(order), np.int64)
    index[order] = label
    first = order[np.concatenate([[True], changed])]
    return torch.from_numpy(first), torch.from_numpy(index)


def _described(
    buffer: _Buffer,
    attributes: dict[str, int],
    indices: int,
    pictures: dict[str, bytes],
    origin: dict[str, str],
) -> dict[str, Any]:
    name = origin.get("prompt", "asset")
    images = [
        {"name": role, "mimeType": "image/png", "bufferView": buffer.view(picture)}
        for role, picture in pictures.items()
    ]
    material = {
        "name": name,
        "pbrMetallicRoughness": {
            "baseColorTexture": {"index": 0},
            "metallicRoughnessTexture": {"index": 1},
        },
        "occlusionTexture": {"index": 1},
        "normalTexture": {"index": 2},
    }
    return {
        "asset": {"version": "2.0", "generator": "Fantasia3D for Blender"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0, "name": name} | ({"extras": origin} if origin else {})],
        "meshes": [
            {
                "name": name,
                "primitives": [{"attributes": attributes, "indices": indices, "material": 0}],
            }
        ],
        "materials": [material],
        "textures": [{"sampler": 0, "source": i} for i in range(len(images))],
        "samplers": [{"magFilter": LINEAR, "minFilter": MIPMAPS, "wrapS": CLAMP, "wrapT": CLAMP}],
        "images": images,
        "accessors": buffer.accessors,
        "bufferViews": buffer.views,
        "buffers": [{"byteLength": len(buffer.data)}],
    }


def _packed(described: dict[str, Any], data: bytes) -> bytes:
    """Header and the two chunks, each padded to four bytes."""
    text = json.dumps(described, separators=(",", ":")).encode()
    text += b" " * (-len(text) % 4)
    data += b"\0" * (-len(data) % 4)
    total = 12 + 8 + len(text) + 8 + len(data)
    return b"".join(
        [
            struct.pack("<4sII", b"glTF", 2, total),
            struct.pack("<I4s", len(text), b"JSON"),
            text,
            struct.pack("<I4s", len(data), b"BIN\0"),
            data,
        ]
    )
