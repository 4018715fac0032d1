"""Mesh files that are broken, or made to break: one sentence each, and never a wrong mesh."""

import json
import struct
from pathlib import Path

import numpy as np
import pytest
import trimesh
from PIL import Image
from trimesh.visual.material import PBRMaterial

from core.errors import UserError
from core.generate import prepare
from core.io.job import Job
from core.io.mesh_file import load_mesh

TRIANGLE = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0]], np.float32).tobytes()
OBJ = b"v 0 0 0\nv 1 0 0\nv 0 1 0\n"
PLY = (
    b"ply\nformat %s 1.0\nelement vertex %d\nproperty float x\nproperty float y\n"
    b"property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
)


def glb(indices: list[int], nodes: list[dict] | None = None, count: int = 3) -> bytes:
    """One triangle, unless ``indices``, ``nodes`` or the vertices' ``count`` are given."""
    tree = {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": nodes or [{"mesh": 0}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": count, "type": "VEC3"},
            {"bufferView": 1, "componentType": 5125, "count": 3, "type": "SCALAR"},
        ],
        "bufferViews": [
            {"buffer": 0, "byteLength": 36},
            {"buffer": 0, "byteOffset": 36, "byteLength": 12},
        ],
        "buffers": [{"byteLength": 48}],
    }
    text = json.dumps(tree).encode()
    text += b" " * (-len(text) % 4)
    data = TRIANGLE + np.array(indices, np.uint32).tobytes()
    chunks = struct.pack("<I4s", len(text), b"JSON") + text
    chunks += struct.pack("<I4s", len(data), b"BIN\0") + data
    return struct.pack("<4sII", b"glTF", 2, 12 + len(chunks)) + chunks


@pytest.mark.parametrize(
    ("name", "data"),
    [
        ("index.obj", OBJ + b"f 1 2 9\n"),
        ("beyond 64 bits.obj", OBJ + b"f 1 2 99999999999999999999999\n"),
        ("negative.obj", OBJ + b"f 1 2 -9\n"),
        ("large.obj", b"v 0 0 0\nv 1e39 0 0\nv 0 1 0\nf 1 2 3\n"),
        ("nan.obj", b"v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n"),
        ("index.ply", PLY % (b"ascii", 3) + b"0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n"),
        ("count.ply", PLY % (b"binary_little_endian", 3_000_000_000) + b"0"),
        ("count.stl", bytes(80) + struct.pack("<I", 4_000_000_000) + bytes(50)),
        ("empty.stl", b""),
        ("index.glb", glb([0, 1, 9])),
        ("count.glb", glb([0, 1, 2], count=10**12)),
        ("cut.glb", glb([0, 1, 2])[:60]),
    ],
)
def test_a_broken_mesh_is_one_sentence(tmp_path: Path, name: str, data: bytes) -> None:
    (tmp_path / name).write_bytes(data)
    with pytest.raises(UserError, match=name.replace(".", r"\.")) as error:
        load_mesh(tmp_path / name)
    assert error.value.fix


@pytest.mark.parametrize("number", [b"nan", b"inf", b"-1e39"])
def test_a_uv_that_is_no_number_of_32_bits_is_none(tmp_path: Path, number: bytes) -> None:
    path = tmp_path / "uv.obj"
    path.write_bytes(OBJ + b"vt 0 0\nvt 1 0\nvt " + number + b" 1\nf 1/1 2/2 3/3\n")
    assert load_mesh(path).uv is None


@pytest.mark.parametrize(
    "nodes",
    [
        [{"mesh": 0, "children": [0]}],
        [{"mesh": 0, "children": [1]}, {"children": [0]}],
    ],
)
def test_nodes_in_a_circle_end(tmp_path: Path, nodes: list[dict]) -> None:
    (tmp_path / "a.glb").write_bytes(glb([0, 1, 2], nodes))
    assert len(load_mesh(tmp_path / "a.glb").faces) == 1


RED, BLUE = (Image.new("RGB", (4, 4), color) for color in ("red", "blue"))
TEXTURED, PLAIN = {"baseColorTexture": RED}, {"baseColorFactor": [0, 0, 255, 255]}


def boxes(path: Path, *materials: dict) -> Path:
    """A row of boxes, with separate uv, each of its own material."""
    parts = []
    for k, material in enumerate(materials):
        box = trimesh.creation.box()
        box.apply_translation([3.0 * k, 0, 0])
        uv = np.random.default_rng(k).random((len(box.vertices), 2)) / len(materials)
        uv += k / len(materials)
        box.visual = trimesh.visual.TextureVisuals(uv=uv, material=PBRMaterial(**material))
        parts.append(box)
    trimesh.Scene(parts).export(path)
    return path


@pytest.mark.parametrize("needed", ["uv", "texture"])
def test_several_textures_are_called_so(tmp_path: Path, needed) -> None:
    path = boxes(tmp_path / "a.glb", TEXTURED, {"baseColorTexture": BLUE})
    assert load_mesh(path).uv is None
    with pytest.raises(UserError, match="several materials with textures of their own") as error:
        load_mesh(path, needed)
    assert "--uv auto" in error.value.fix


@pytest.mark.parametrize("asked", [{"uv": "keep"}, {"base_color": "mesh"}])
def test_a_job_that_asks_for_the_uv_is_told_of_the_textures(tmp_path: Path, asked: dict) -> None:
    path = boxes(tmp_path / "a.glb", TEXTURED, {"baseColorTexture": BLUE})
    job = Job(prompt="a red cube", command="texture", mesh=str(path), device="cpu", **asked)
    with pytest.raises(UserError, match="several materials with textures of their own"):
        prepare(job)


@pytest.mark.parametrize("other", [PLAIN, {}, TEXTURED | PLAIN])
def test_a_part_of_another_colour_does_not_get_the_texture(tmp_path: Path, other: dict) -> None:
    path = boxes(tmp_path / "a.glb", TEXTURED, other)
    mesh = load_mesh(path, "uv")
    assert mesh.uv is not None and mesh.base_color is None
    with pytest.raises(UserError, match="not all of which have its texture's colours") as error:
        load_mesh(path, "texture")
    assert error.value.fix


@pytest.mark.parametrize("needed", ["", "uv", "texture"])
def test_colours_alone_are_no_texture_and_share_a_uv(tmp_path: Path, needed) -> None:
    mesh = load_mesh(boxes(tmp_path / "a.glb", PLAIN, {}), needed)
    assert mesh.uv is not None and mesh.base_color is None


def test_materials_of_an_obj_with_one_picture_have_it_in_common(tmp_path: Path) -> None:
    RED.save(tmp_path / "red.png")
    mtl = "".join(f"newmtl {name}\nmap_Kd red.png\n" for name in ("a", "b"))
    (tmp_path / "a.mtl").write_text(mtl)
    faces = b"usemtl a\nf 1/1 2/2 3/3\nusemtl b\nf 1/1 3/3 4/1\n"
    path = tmp_path / "a.obj"
    path.write_bytes(b"mtllib a.mtl\n" + OBJ + b"v 0 0 1\nvt 0 0\nvt 1 0\nvt 0 1\n" + faces)
    mesh = load_mesh(path, "texture")
    assert mesh.uv is not None and mesh.base_color is not None
    assert mesh.base_color[0, 0].tolist() == [1, 0, 0]


@pytest.mark.parametrize("needed", ["uv", "texture"])
def test_a_uv_that_some_parts_lack_is_not_called_missing(tmp_path: Path, needed) -> None:
    (tmp_path / "a.mtl").write_text("newmtl a\nnewmtl b\n")
    path = tmp_path / "a.obj"
    faces = b"vt 0 0\nvt 1 0\nvt 0 1\nusemtl a\nf 1/1 2/2 3/3\nusemtl b\nf 1 3 4\n"
    path.write_bytes(b"mtllib a.mtl\n" + OBJ + b"v 0 0 1\n" + faces)
    assert load_mesh(path).uv is None
    with pytest.raises(UserError, match="1 of the 2 parts of a.obj have no UV map"):
        load_mesh(path, needed)
