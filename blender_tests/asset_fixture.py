"""A small asset folder made by hand, as docs/architecture.md describes one. No torch, no core.

The shape is a closed block with rounded corners, its six sides six islands of the atlas, with a
nose at the front (-Y) and a top that is narrower than its base, so that no turn maps it to itself.
"""

import json
import struct
import zlib
from pathlib import Path

import numpy as np

SIDES = {  # outward axis and sign; the sides' colours as 8-bit sRGB
    "right": (0, 1, (30, 160, 60)),
    "left": (0, -1, (40, 70, 200)),
    "back": (1, 1, (220, 190, 40)),
    "front": (1, -1, (200, 30, 30)),
    "top": (2, 1, (235, 235, 235)),
    "bottom": (2, -1, (25, 25, 25)),
}
FLAT = (32768, 32768, 65535)
PROMPT = "a red wooden chair"


def block(n: int = 8) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Welded verts (V,3), faces (F,3), uv (U,2), face_uvs (F,3); 12 n² faces, 1 m high, z >= 0."""
    points, corners, uv = [], [], []
    lattice = [(a, b) for a in range(n) for b in range(n)]
    for island, (axis, sign, _) in enumerate(SIDES.values()):
        base = island * (n + 1) ** 2
        a, b = np.meshgrid(np.linspace(-1, 1, n + 1), np.linspace(-1, 1, n + 1), indexing="ij")
        point = np.zeros((n + 1, n + 1, 3))
        point[..., axis], point[..., axis - 2], point[..., axis - 1] = sign, a, b
        points.append(point.reshape(-1, 3))
        cell = np.array([island % 3, island // 3])
        inside = np.stack([a if sign > 0 else -a, b], -1).reshape(-1, 2) * 0.46 + 0.5
        uv.append((inside + cell) / (3, 2))
        for i, j in lattice:
            p, q = base + i * (n + 1) + j, base + (i + 1) * (n + 1) + j
            quad = [p, q, q + 1, p + 1][:: int(sign)]
            corners += [[quad[0], quad[1], quad[2]], [quad[0], quad[2], quad[3]]]
    flat, face_uvs = np.concatenate(points), np.array(corners)
    verts, weld = np.unique(flat.round(9), axis=0, return_inverse=True)
    return shaped(verts), weld.reshape(-1)[face_uvs], np.concatenate(uv), face_uvs


def shaped(verts: np.ndarray) -> np.ndarray:
    """The cube [-1,1]³ as the block: rounded, with its nose and its narrow top."""
    x, y, z = (verts / np.linalg.norm(verts, axis=1, keepdims=True) ** 0.6).T
    nose = np.exp(-8 * (x**2 + z**2)) * (y < 0)
    x = x * (0.75 - 0.25 * z)
    out = np.stack([x * 0.6, y * 0.5 - 0.35 * nose, z], 1)
    low, high = out.min(0), out.max(0)
    middle = np.array([*(low + high)[:2] / 2, low[2]])
    return (out - middle) / (high - low).max()


def plane() -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """A square of 1 m that faces -Y, its u to +X and its v to +Z."""
    verts = np.array([[-0.5, 0, 0], [0.5, 0, 0], [0.5, 0, 1], [-0.5, 0, 1]])
    faces = np.array([[0, 1, 2], [0, 2, 3]])
    return verts, faces, verts[:, [0, 2]] + (0.5, 0), faces


def island_colors(size: int) -> np.ndarray:
    """The base colour map (S,S,3) uint8: each side's cell of the atlas in its colour."""
    picture = np.zeros((size, size, 3), np.uint8)
    columns, rows = np.arange(size) * 3 // size, (size - 1 - np.arange(size)) * 2 // size
    for island, (_, _, color) in enumerate(SIDES.values()):
        picture[np.ix_(rows == island // 3, columns == island % 3)] = color
    return picture


def bump_normals(size: int) -> np.ndarray:
    """The normal map (S,S,3) uint16, OpenGL, of a dome on the surface."""
    u = (np.arange(size) + 0.5) / size * 2 - 1
    x, y = np.meshgrid(u, -u)  # row 0 is the top
    inside = x**2 + y**2 < 0.64
    n = np.stack([x, y, np.sqrt(np.maximum(1 - x**2 - y**2, 0))], -1)
    n = np.where(inside[..., None], n, (0, 0, 1))
    return np.round((n / 2 + 0.5) * 65535).astype(np.uint16)


def write_png(path: Path, picture: np.ndarray) -> None:
    """``picture`` (H,W,3), uint8 or uint16, as PNG."""
    height, width, _ = picture.shape
    big = picture.astype(picture.dtype.newbyteorder(">"))
    rows = b"".join(b"\0" + row.tobytes() for row in big)
    header = struct.pack(">IIBBBBB", width, height, 8 * picture.dtype.itemsize, 2, 0, 0, 0)
    chunks = [(b"IHDR", header), (b"IDAT", zlib.compress(rows)), (b"IEND", b"")]
    body = b"".join(
        struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
        for kind, data in chunks
    )
    path.write_bytes(b"\x89PNG\r\n\x1a\n" + body)


def write_obj(path: Path, verts, faces, uv, face_uvs) -> None:
    """In the axes that are the default of Blender's own importer: forward -Z, up Y."""
    lines = [f"v {x:.7f} {z:.7f} {-y:.7f}" for x, y, z in verts]
    lines += [f"vt {u:.7f} {v:.7f}" for u, v in uv]
    lines += [
        "f " + " ".join(f"{v + 1}/{t + 1}" for v, t in zip(face, face_uv, strict=True))
        for face, face_uv in zip(faces, face_uvs, strict=True)
    ]
    path.write_text("\n".join(lines) + "\n")


def write_asset(
    folder: Path,
    mesh=None,
    prompt: str = PROMPT,
    size: int = 64,
    base_color: np.ndarray | None = None,
    normal: np.ndarray | None = None,
    roughness: float = 0.6,
    metallic: float = 0.0,
    emission: np.ndarray | None = None,
    transmission: np.ndarray | None = None,
    **info,
) -> Path:
    """The whole folder; ``mesh`` is what :func:`block` returns.

    ``emission`` and ``transmission``: their pictures (H,W,3), at a strength of 4 and an IOR of 1.3.
    """
    folder.mkdir(parents=True)
    verts, faces, uv, face_uvs = mesh or block()
    write_obj(folder / "mesh.obj", verts, faces, uv, face_uvs)
    orm = np.broadcast_to(np.round(np.array([1, roughness, metallic]) * 255), (size, size, 3))
    flat = np.broadcast_to(np.array(FLAT, np.uint16), (size, size, 3))
    write_png(folder / "base_color.png", island_colors(size) if base_color is None else base_color)
    write_png(folder / "orm.png", orm.astype(np.uint8))
    write_png(folder / "normal.png", flat if normal is None else normal)
    data = {
        "version": 1,
        "prompt": prompt,
        "negative_prompt": "",
        "seed": 0,
        "preset": "draft",
        "guidance": "builtin",
        "command": "generate",
        "size_m": 1.0,
        "mesh": {"verts": len(verts), "faces": len(faces), "closed": True},
        "files": {
            "mesh.obj": {"role": "mesh"},
            "base_color.png": {"role": "base_color", "color_space": "sRGB", "channels": "RGB"},
            "orm.png": {
                "role": "orm",
                "color_space": "Non-Color",
                "channels": "occlusion, roughness, metallic",
            },
            "normal.png": {
                "role": "normal",
                "color_space": "Non-Color",
                "convention": "OpenGL",
                "tangent_space": "MikkTSpace",
                "bits": 16,
            },
        },
        "timings": {},
        "distribution": "GGX",
    }
    more = {
        "emission": (emission, {"color_space": "sRGB", "strength": 4.0}),
        "transmission": (transmission, {"color_space": "Non-Color", "ior": 1.3}),
    }
    for role, (picture, entry) in more.items():
        if picture is not None:
            write_png(folder / f"{role}.png", picture)
            data["files"][f"{role}.png"] = {"role": role} | entry
    (folder / "asset.json").write_text(json.dumps(data | info, ensure_ascii=False), "utf-8")
    return folder
