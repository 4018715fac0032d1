"""Wavefront OBJ in the axes that Blender's importer takes by default: forward -Z, up Y.

World (x, y, z), front -Y and up +Z, is written as (x, z, -y). Numbers carry nine digits, enough to
give every float32 back.
"""

from pathlib import Path

import numpy as np
import torch
from jaxtyping import Float, Int
from torch import Tensor

from core.errors import UserError
from core.geometry.mesh import Mesh
from core.geometry.tangents import Normals
from core.io.atomic import atomic_file
from core.io.input_file import check_file, check_size

MAX_BYTES = 2 << 30  # of an asset's mesh: 20 million faces
FLAT = b"s off"  # the line of a mesh that is shaded flat


def to_y_up(world: Float[Tensor, "*b 3"]) -> Float[Tensor, "*b 3"]:
    """World axes to +Y up, front +Z."""
    x, y, z = world.unbind(-1)
    return torch.stack([x, z, -y], -1)


def from_y_up(file: Float[Tensor, "*b 3"]) -> Float[Tensor, "*b 3"]:
    """Inverse of :func:`to_y_up`."""
    x, y, z = file.unbind(-1)
    return torch.stack([x, -z, y], -1)


def obj_text(mesh: Mesh, normals: Normals, material: str) -> str:
    """Welded vertices, a uv index for each corner, a smooth normal for each vertex; of a flat mesh
    one for each face.

    ``material`` names both the .mtl file (without its ending) and the material in it.
    """
    uv, face_uvs = mesh.atlas
    corners = torch.stack([mesh.faces, face_uvs, normals.index], -1) + 1
    numbers = tuple(corners.reshape(-1).tolist())
    return "".join(
        [
            f"mtllib {material}.mtl\no {material}\n",
            _lines("v", to_y_up(mesh.verts)),
            _lines("vt", uv),
            _lines("vn", to_y_up(normals.each)),
            f"usemtl {material}\n{FLAT.decode() if mesh.flat else 's 1'}\n",
            "f %d/%d/%d %d/%d/%d %d/%d/%d\n" * len(mesh.faces) % numbers,
        ]
    )


def mtl_text(
    material: str,
    base_color: str,
    normal: str,
    roughness: str = "",
    metallic: str = "",
    *,
    emission: str = "",
) -> str:
    """A material with its maps. OBJ has no place for a packed roughness and metallic map: those
    are files of their own, or constants where they are empty.

    Blender calls a normal map map_Bump, other programs norm. What lets light through is left out:
    MTL has only the opacity's map (map_d), which takes the reflections away too, and Tf and Ni,
    which are of the whole material.
    """
    surface = "Pr 0.5\nPm 0\n"
    if roughness and metallic:
        surface = f"Pr 1\nPm 1\nmap_Pr {roughness}\nmap_Pm {metallic}\n"
    return (
        f"newmtl {material}\nKd 1 1 1\nillum 2\n{surface}"
        f"map_Kd {base_color}\nmap_Bump -bm 1 {normal}\nnorm {normal}\n"
        + (f"Ke 1 1 1\nmap_Ke {emission}\n" if emission else "")
    )


def write_plain_obj(path: Path, verts: Float[Tensor, "v 3"], faces: Int[Tensor, "f 3"]) -> None:
    """The shape alone, whole or not at all."""
    with atomic_file(path) as temporary:
        temporary.write_text(plain_obj_text(verts, faces), encoding="ascii")


def plain_obj_text(verts: Float[Tensor, "v 3"], faces: Int[Tensor, "f 3"]) -> str:
    """The shape alone: no uv, no normals, no material."""
    corners = tuple((faces.cpu() + 1).reshape(-1).tolist())
    return _lines("v", to_y_up(verts.detach().cpu())) + "f %d %d %d\n" * len(faces) % corners


def read_obj(path: Path) -> Mesh:
    """The mesh as :func:`obj_text` wrote it.

    Raises UserError for a file that is not there or is not a triangle mesh with uv.
    """
    check_file(path, "mesh")
    check_size(path, MAX_BYTES, "Make the asset again.")
    try:
        lines = path.read_bytes().splitlines()
        verts, uv = _read(lines, b"v ", 3), _read(lines, b"vt ", 2)
        faces = [line[2:] for line in lines if line.startswith(b"f ")]
        words = b" ".join(faces).replace(b"/", b" ").split()
        corners = torch.from_numpy(np.array(words, np.int64)).view(len(faces), 3, 3) - 1
        flat = FLAT in lines
        limits = torch.tensor([len(verts), len(uv), len(faces) if flat else len(verts)])
        if not len(faces) or bool((corners < 0).any()) or bool((corners >= limits).any()):
            raise ValueError("indices without a vertex")
    except OSError as error:
        raise UserError(f"{path} cannot be read: {error.strerror}.", "Check the path.") from error
    except (ValueError, RuntimeError, OverflowError) as error:  # Overflow: an index over 64 bits
        raise UserError(
            f"{path} is not the triangle mesh that was written there ({error}).",
            "Make the asset again, or use the OBJ as a mesh: texture MESH.",
        ) from error
    return Mesh(from_y_up(verts), corners[..., 0].clone(), uv, corners[..., 1].clone(), flat=flat)


def _read(lines: list[bytes], key: bytes, width: int) -> Float[Tensor, "n {width}"]:
    rows = [line[len(key) :] for line in lines if line.startswith(key)]
    with np.errstate(over="ignore"):  # beyond single precision: not finite, and refused below
        values = np.array(b" ".join(rows).split(), np.float64).astype(np.float32)
    if not np.isfinite(values).all():
        raise ValueError("numbers that are not finite")
    return torch.from_numpy(values).view(len(rows), width)


def _lines(key: str, rows: Float[Tensor, "n c"]) -> str:
    line = key + " %.9g" * rows.shape[1] + "\n"
    return line * len(rows) % tuple(rows.detach().cpu().float().reshape(-1).tolist())
