"""The asset folder appears whole or not at all, and reads back as it was."""

import errno
import json
import os
import shutil
import struct
import zipfile
from dataclasses import asdict, replace
from pathlib import Path

import numpy as np
import pytest
import torch

from core import verify
from core.errors import UserError
from core.geometry.mesh import Mesh, health
from core.geometry.uv_health import uv_health
from core.io import asset as module
from core.io import png as images
from core.io.asset import export, inspect, place, read_asset, write_asset, write_plain_obj
from core.io.atomic import temporary
from core.io.job import Job
from core.io.maps import Maps
from core.tests.texture_shapes import smooth_material, torus, torus_uv
from core.texture.bake import bake

INFO = {"prompt": "a red wooden chair", "seed": 3, "timings": {"geometry": 1.5}}


def arrays(mesh: Mesh) -> tuple[torch.Tensor, ...]:
    return mesh.verts, mesh.faces, *mesh.atlas


@pytest.fixture(scope="module")
def parts() -> tuple:
    verts, faces = torus()
    uv, face_uvs = torus_uv()
    maps = bake(Mesh(verts, faces, uv, face_uvs), smooth_material, 64)
    return Mesh(place(verts), faces, uv, face_uvs), maps


@pytest.fixture
def folder(parts, tmp_path: Path) -> Path:
    preview = torch.rand(8, 8, 3)
    return write_asset(tmp_path / "run" / "asset", *parts, INFO, preview)


def test_place() -> None:
    verts, _ = torus()
    placed = place(verts * 7 + torch.tensor([3.0, -2, 9]))
    low, high = placed.amin(0), placed.amax(0)
    assert (high - low).max() == pytest.approx(1)
    assert low[2] == pytest.approx(0, abs=1e-6)
    torch.testing.assert_close((low + high)[:2], torch.zeros(2), atol=1e-6, rtol=0)
    with pytest.raises(UserError, match="one point"):
        place(torch.ones(4, 3))


def test_reads_back(folder: Path, parts) -> None:
    """Geometry to the bit, maps to the rounding of their files."""
    back = read_asset(folder)
    for got, want in zip(arrays(back.mesh), arrays(parts[0]), strict=True):
        assert torch.equal(got, want)
    maps: Maps = parts[1]
    assert (images.srgb_bytes(back.maps.base_color) == images.srgb_bytes(maps.base_color)).all()
    assert (back.maps.orm - maps.orm).abs().max() <= 0.5 / 255 + 1e-6
    assert (back.maps.normal - maps.normal).abs().max() < 2 / 65535


def test_a_run_folder_will_do(folder: Path) -> None:
    assert read_asset(folder.parent).folder == folder


def test_asset_json_tells_all(folder: Path, parts) -> None:
    result = json.loads((folder / "asset.json").read_text())
    assert result["version"] == 1
    assert result["prompt"] == INFO["prompt"]
    assert result["timings"] == INFO["timings"]
    assert result["size_m"] == pytest.approx(1)
    assert result["mesh"]["closed"]
    assert result["mesh"]["genus"] == 1
    assert result["mesh"]["faces"] == len(parts[0].faces)
    there = {path.name for path in folder.iterdir()}
    assert set(result["files"]) == there - {"asset.json"}
    assert result["files"]["base_color.png"]["color_space"] == "sRGB"
    assert result["files"]["normal.png"]["convention"] == "OpenGL"
    assert result["files"]["orm.png"]["channels"] == "occlusion, roughness, metallic"


@pytest.fixture(scope="module")
def lit_maps(parts) -> Maps:
    """The ring's maps, its left half glowing and its right half clear."""
    half = (torch.arange(64) < 32).float().view(1, 64, 1)
    color = torch.tensor([1.0, 0.4, 0.1])
    return parts[1]._replace(
        emission=(half * color).expand(64, 64, 3), transmission=(0.8 * (1 - half)).expand(64, 64, 1)
    )


@pytest.fixture
def lit_folder(parts, lit_maps, tmp_path: Path) -> Path:
    return write_asset(tmp_path / "lit", parts[0], lit_maps, INFO)


def test_what_glows_and_what_is_clear_reads_back_with_its_strength(lit_folder: Path, lit_maps):
    back = read_asset(lit_folder).maps
    for role, to_bytes in (("emission", images.srgb_bytes), ("transmission", images.unit_bytes)):
        assert (to_bytes(getattr(back, role)) == to_bytes(getattr(lit_maps, role))).all()
    result = json.loads((lit_folder / "asset.json").read_text())
    emission, transmission = (result["files"][f"{role}.png"] for role in module.OPTIONAL)
    assert (emission["color_space"], emission["strength"]) == ("sRGB", module.EMISSION_STRENGTH)
    assert (transmission["color_space"], transmission["ior"]) == ("Non-Color", module.IOR)
    assert {"emission.png", "transmission.png"} <= result["hashes"].keys()
    assert images.read_png(lit_folder / "transmission.png").shape == (64, 64, 1)


def test_where_nothing_glows_there_is_no_file_and_the_others_are_the_same(parts, folder, tmp_path):
    """Also where the maps are there and all zero."""
    dark = parts[1]._replace(emission=torch.zeros(64, 64, 3), transmission=torch.zeros(64, 64, 1))
    plain = write_asset(tmp_path / "plain", parts[0], dark, INFO)
    names = {path.name for path in plain.iterdir()}
    assert names == {path.name for path in folder.iterdir()} - {"preview.png"}
    for name in module.DATA_FILES:
        assert (plain / name).read_bytes() == (folder / name).read_bytes()
    maps = read_asset(plain).maps
    assert maps.emission is maps.transmission is None


def test_an_asset_from_before_these_maps_is_read_and_a_lost_one_is_refused(lit_folder: Path):
    (lit_folder / "emission.png").unlink()
    with pytest.raises(UserError, match="emission.png"):
        read_asset(lit_folder)
    result = json.loads((lit_folder / "asset.json").read_text())
    del result["files"]
    (lit_folder / "asset.json").write_text(json.dumps(result))
    maps = read_asset(lit_folder).maps
    assert maps.emission is maps.transmission is None


def test_the_glb_states_what_glows_and_what_is_clear(lit_folder: Path, folder: Path) -> None:
    result, data = read_glb(lit_folder / "asset.glb")
    (material,) = result["materials"]
    more = material["extensions"]
    assert material["emissiveFactor"] == [1, 1, 1]
    strength = more["KHR_materials_emissive_strength"]["emissiveStrength"]
    assert strength == module.EMISSION_STRENGTH
    assert more["KHR_materials_transmission"]["transmissionFactor"] == 1
    assert more["KHR_materials_ior"]["ior"] == module.IOR
    assert set(result["extensionsUsed"]) == set(more)
    textures = {
        "emission": material["emissiveTexture"],
        "transmission": more["KHR_materials_transmission"]["transmissionTexture"],
    }
    for role, texture in textures.items():
        view = result["bufferViews"][result["images"][texture["index"]]["bufferView"]]
        start = view["byteOffset"]
        picture = (lit_folder / f"{role}.png").read_bytes()
        assert data[start : start + view["byteLength"]] == picture
    plain, _ = read_glb(folder / "asset.glb")
    assert "extensionsUsed" not in plain and "extensions" not in plain["materials"][0]


def test_an_obj_takes_what_glows_along(lit_folder: Path, tmp_path: Path) -> None:
    out = export(lit_folder, "obj", tmp_path / "ring.obj")
    assert "map_Ke ring_emission.png" in out.with_suffix(".mtl").read_text()
    copied = out.with_name("ring_emission.png")
    assert copied.read_bytes() == (lit_folder / "emission.png").read_bytes()
    assert "map_Ke emission.png" in (lit_folder / "mesh.mtl").read_text()


def test_verify_sees_a_map_that_one_of_the_two_lacks(
    parts, lit_maps, folder, tmp_path, monkeypatch
):
    info = INFO | {"job": asdict(Job(prompt="a ring"))}
    lit = write_asset(tmp_path / "lit", parts[0], lit_maps, info)
    monkeypatch.setattr(verify, "prepare", lambda job: None)
    found = verify.verify(lit, lambda run, inputs: folder)["files"]
    assert found["emission.png"] == found["transmission.png"] == "differs"
    assert found["mesh.obj"] == "same"


def test_obj_stands_upright_in_the_importers_axes(folder: Path, parts) -> None:
    """Blender turns file (x, y, z) into world (x, -z, y)."""
    lines = (folder / "mesh.obj").read_text().splitlines()
    x, y, z = (float(word) for word in next(line for line in lines if line[:2] == "v ").split()[1:])
    assert [x, -z, y] == pytest.approx(parts[0].verts[0].tolist())
    assert sum(line.startswith("vn ") for line in lines) == len(parts[0].verts)
    assert sum(line.startswith("v ") for line in lines) == len(parts[0].verts)
    assert lines[0] == "mtllib mesh.mtl"
    assert "map_Kd base_color.png" in (folder / "mesh.mtl").read_text()


def read_glb(path: Path) -> tuple[dict, bytes]:
    data = path.read_bytes()
    magic, version, length = struct.unpack_from("<4sII", data)
    assert (magic, version, length) == (b"glTF", 2, len(data))
    size, kind = struct.unpack_from("<I4s", data, 12)
    assert kind == b"JSON"
    result = json.loads(data[20 : 20 + size])
    rest, kind = struct.unpack_from("<I4s", data, 20 + size)
    assert kind == b"BIN\0"
    assert 28 + size + rest == len(data)
    return result, data[28 + size :]


def accessor(result: dict, data: bytes, index: int) -> np.ndarray:
    entry = result["accessors"][index]
    view = result["bufferViews"][entry["bufferView"]]
    assert view["byteOffset"] % 4 == 0
    width = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}[entry["type"]]
    dtype = {5126: "<f4", 5125: "<u4"}[entry["componentType"]]
    flat = np.frombuffer(data, dtype, entry["count"] * width, view["byteOffset"])
    return flat.reshape(-1, width)


def test_glb_holds_the_same_corners(folder: Path, parts) -> None:
    """Position, uv, normal and tangent of every corner, in glTF's axes."""
    verts, faces, uv, face_uvs = arrays(parts[0])
    result, data = read_glb(folder / "asset.glb")
    primitive = result["meshes"][0]["primitives"][0]
    index = accessor(result, data, primitive["indices"])[:, 0]
    got = {k: accessor(result, data, i)[index] for k, i in primitive["attributes"].items()}
    want = verts[faces].reshape(-1, 3).numpy()
    assert np.array_equal(got["POSITION"], want[:, [0, 2, 1]] * np.float32([1, 1, -1]))
    at = uv[face_uvs].reshape(-1, 2).numpy()
    assert np.array_equal(got["TEXCOORD_0"], np.stack([at[:, 0], 1 - at[:, 1]], -1))
    assert np.allclose(np.linalg.norm(got["NORMAL"], axis=1), 1, atol=1e-5)
    assert np.abs((got["NORMAL"] * got["TANGENT"][:, :3]).sum(1)).max() < 1e-5
    assert len(np.unique(got["POSITION"], axis=0)) == len(verts)
    count = result["accessors"][primitive["attributes"]["POSITION"]]["count"]
    assert len(verts) < count < 1.3 * len(verts)  # split at the seams only
    entry = result["accessors"][primitive["attributes"]["POSITION"]]
    assert entry["min"] == got["POSITION"].min(0).tolist()


def test_a_flat_mesh_stays_flat_in_every_file(parts, tmp_path: Path) -> None:
    mesh, maps = parts
    folder = write_asset(tmp_path / "asset", replace(mesh, flat=True), maps, INFO)
    back = read_asset(folder).mesh
    assert back.flat and torch.equal(back.faces, mesh.faces)
    assert not read_asset(write_asset(tmp_path / "smooth", mesh, maps, INFO)).mesh.flat
    lines = (folder / "mesh.obj").read_text().splitlines()
    assert "s off" in lines and sum(line.startswith("vn ") for line in lines) == len(mesh.faces)
    result, data = read_glb(folder / "asset.glb")
    primitive = result["meshes"][0]["primitives"][0]
    index = accessor(result, data, primitive["indices"])[:, 0]
    normals = accessor(result, data, primitive["attributes"]["NORMAL"])[index].reshape(-1, 3, 3)
    corners = mesh.verts[mesh.faces].double().numpy()[..., [0, 2, 1]] * (1, 1, -1)
    a, b, c = corners.transpose(1, 0, 2)
    across = np.cross(b - a, c - a)
    across /= np.linalg.norm(across, axis=1, keepdims=True)
    assert np.abs(normals - across[:, None]).max() < 1e-5
    copy = tmp_path / "copy.obj"
    export(folder, "obj", copy)
    assert "s off" in copy.read_text().splitlines()


def test_glb_shows_both_sides_of_an_open_mesh_only(parts, tmp_path: Path) -> None:
    mesh, maps = parts
    verts, faces, uv, face_uvs = arrays(mesh)
    at_seams, number = np.unique(
        np.stack([faces.reshape(-1), face_uvs.reshape(-1)], 1), axis=0, return_inverse=True
    )
    cut = Mesh(
        verts[at_seams[:, 0]], torch.from_numpy(number.reshape(-1, 3)), uv, face_uvs
    )  # a vertex for each uv
    assert not health(cut.verts, cut.faces)["closed"]
    cases = {
        "closed": mesh,
        "cut": cut,
        "open": Mesh(verts, faces[50:], uv, face_uvs[50:]),
        "inward": Mesh(verts, faces.flip(1), uv, face_uvs.flip(1)),
    }
    sides = {}
    for name, case in cases.items():
        result, _ = read_glb(write_asset(tmp_path / name, case, maps, INFO) / "asset.glb")
        sides[name] = result["materials"][0].get("doubleSided", False)
    assert sides == {"closed": False, "cut": False, "open": True, "inward": True}


def test_glb_textures_are_the_files(folder: Path) -> None:
    result, data = read_glb(folder / "asset.glb")
    for image in result["images"]:
        view = result["bufferViews"][image["bufferView"]]
        held = data[view["byteOffset"] : view["byteOffset"] + view["byteLength"]]
        assert held == (folder / f"{image['name']}.png").read_bytes()
    material = result["materials"][0]
    assert result["images"][material["normalTexture"]["index"]]["name"] == "normal"
    orm = material["pbrMetallicRoughness"]["metallicRoughnessTexture"]["index"]
    assert result["images"][orm]["name"] == "orm"
    assert material["occlusionTexture"]["index"] == orm


def failing(number: int):
    """A stand-in for images.write_png that fails on the last map."""
    real = images.write_png

    def write(path: Path, image) -> None:
        if path.name == "normal.png":
            raise OSError(number, os.strerror(number))
        real(path, image)

    return write


@pytest.mark.parametrize(
    ("number", "words"),
    [
        (errno.ENOSPC, "disk is full"),
        (errno.EACCES, "permission denied"),
        (errno.EROFS, "read-only file system"),
    ],
)
def test_a_full_disk_leaves_nothing(parts, tmp_path, monkeypatch, number, words) -> None:
    monkeypatch.setattr(module.images, "write_png", failing(number))
    with pytest.raises(UserError, match=words):
        write_asset(tmp_path / "asset", *parts, INFO)
    assert list(tmp_path.iterdir()) == []


def test_a_failure_keeps_the_older_asset(folder: Path, parts, monkeypatch) -> None:
    before = (folder / "asset.json").read_text()
    monkeypatch.setattr(module.images, "write_png", failing(errno.ENOSPC))
    with pytest.raises(UserError, match="disk is full"):
        write_asset(folder, *parts, INFO | {"seed": 4})
    assert [path.name for path in folder.parent.iterdir()] == ["asset"]
    assert (folder / "asset.json").read_text() == before


def test_a_failed_rename_keeps_the_older_asset(folder: Path, parts, monkeypatch) -> None:
    real = Path.rename

    def rename(self: Path, to: Path) -> Path:
        if self.name.endswith("-asset.tmp"):
            raise OSError(errno.ENOSPC, "no room")
        return real(self, to)

    monkeypatch.setattr(Path, "rename", rename)
    with pytest.raises(UserError, match="disk is full"):
        write_asset(folder, *parts, INFO | {"seed": 4})
    assert [path.name for path in folder.parent.iterdir()] == ["asset"]
    assert read_asset(folder).info["seed"] == 3


def test_a_newer_asset_takes_the_place(folder: Path, parts) -> None:
    write_asset(folder, *parts, INFO | {"seed": 4})
    assert read_asset(folder).info["seed"] == 4
    assert [path.name for path in folder.parent.iterdir()] == ["asset"]


def test_folders_of_the_user_next_to_it_stay(folder: Path, parts) -> None:
    """A copy of an asset has the names of our own files."""
    for name in ("asset.tmp", "asset.old", ".fantasia3d-mine-asset.old"):
        shutil.copytree(folder, folder.with_name(name))
    write_asset(folder, *parts, INFO | {"seed": 7})
    seeds = {x.name: read_asset(x).info["seed"] for x in folder.parent.iterdir()}
    assert seeds == {
        "asset": 7, "asset.tmp": 3, "asset.old": 3, ".fantasia3d-mine-asset.old": 3,
    }  # fmt: skip


@pytest.mark.parametrize("kind", ["", "tmp", "old"])
def test_files_of_the_user_are_never_removed(tmp_path: Path, parts, kind: str) -> None:
    asset = tmp_path / "asset"
    precious = (temporary(asset, kind) if kind else asset) / "precious.txt"
    precious.parent.mkdir()
    precious.write_text("mine")
    with pytest.raises(UserError, match=r"precious\.txt is not a file of an asset"):
        write_asset(tmp_path / "asset", *parts, INFO)
    assert precious.read_text() == "mine"


def test_an_older_asset_left_over_by_a_crash_does_not_block_the_next(folder: Path, parts) -> None:
    shutil.copytree(folder, temporary(folder, "old"))
    write_asset(folder, *parts, INFO | {"seed": 6})
    assert read_asset(folder).info["seed"] == 6
    assert [path.name for path in folder.parent.iterdir()] == ["asset"]


def test_leftovers_of_a_crash_do_not_matter(folder: Path, parts) -> None:
    """A process that ended between the two renames: the older asset is found again."""
    temporary(folder).mkdir()
    folder.rename(temporary(folder, "old"))
    write_asset(folder, *parts, INFO | {"seed": 5})
    assert read_asset(folder).info["seed"] == 5
    assert [path.name for path in folder.parent.iterdir()] == ["asset"]


def break_asset(folder: Path, what: str) -> None:
    if what == "json":
        (folder / "asset.json").write_text("{")
    elif what == "version":
        (folder / "asset.json").write_text('{"version": 9}')
    elif what == "gone":
        (folder / "orm.png").unlink()
    elif what == "cut":
        text = (folder / "mesh.obj").read_text()
        (folder / "mesh.obj").write_text(text[: text.rindex("f ")])
    elif what == "words":
        (folder / "mesh.obj").write_text("v 1 2 three\n")
    else:
        images.write_png(folder / "orm.png", np.zeros((4, 4, 3), np.uint8))


@pytest.mark.parametrize(
    ("what", "words"),
    [
        ("json", "is not JSON"),
        ("version", "version 9"),
        ("gone", "no picture"),
        ("cut", "asset.json states"),
        ("words", "not the triangle mesh"),
        ("size", "the size of base_color.png"),
    ],
)
def test_broken_assets_are_reported(folder: Path, what: str, words: str) -> None:
    break_asset(folder, what)
    with pytest.raises(UserError, match=words) as caught:
        read_asset(folder)
    assert caught.value.fix


@pytest.mark.parametrize(
    "text",
    [
        "[" * 100_000,
        "[]",
        '{"version": 1, "mesh": 3}',
        '{"version": [1]}',
        b"\xff\xfe{}",
        "1" * 9000,
    ],
)
def test_a_strange_asset_json_is_one_sentence(folder: Path, text: "str | bytes") -> None:
    data = text if isinstance(text, bytes) else text.encode()
    (folder / "asset.json").write_bytes(data)
    with pytest.raises(UserError, match=r"asset\.json") as error:
        read_asset(folder)
    assert error.value.fix


def test_no_asset_is_reported(tmp_path: Path) -> None:
    with pytest.raises(UserError, match="is not an asset"):
        read_asset(tmp_path)
    (tmp_path / "job.json").write_text("{}")
    with pytest.raises(UserError, match="has not finished") as error:
        read_asset(tmp_path)
    assert "run.py resume" in error.value.fix


def test_inspect(folder: Path, parts) -> None:
    result = inspect(folder)
    assert result["mesh"] == health(parts[0].verts, parts[0].faces) | uv_health(parts[0])
    assert result["texture_size"] == [64, 64]
    assert json.loads(json.dumps(result)) == result
    mesh = inspect(folder / "mesh.obj")
    assert mesh["mesh"]["genus"] == 1
    assert mesh["uv"]


def test_export(folder: Path, tmp_path: Path) -> None:
    export(folder, "glb", tmp_path / "chair.glb")
    assert (tmp_path / "chair.glb").read_bytes() == (folder / "asset.glb").read_bytes()
    export(folder, "obj", tmp_path / "chair.obj")
    assert (tmp_path / "chair.obj").read_text().startswith("mtllib chair.mtl")
    material = (tmp_path / "chair.mtl").read_text()
    for name in ("base_color", "normal"):
        assert f"chair_{name}.png" in material
        assert (tmp_path / f"chair_{name}.png").is_file()
    with pytest.raises(UserError, match="'usd'"):
        export(folder, "usd", tmp_path / "chair.usd")
    with pytest.raises(UserError, match="does not end in"):
        export(folder, "glb", tmp_path / "chair.obj")
    with pytest.raises(UserError, match="cannot be written"):
        export(folder, "glb", tmp_path / "none" / "chair.glb")


def test_plain_obj(tmp_path: Path) -> None:
    verts, faces = torus()
    write_plain_obj(tmp_path / "shape.obj", verts, faces)
    result = inspect(tmp_path / "shape.obj")
    assert result["mesh"]["genus"] == 1
    assert result["mesh"]["volume"] == pytest.approx(health(verts, faces)["volume"], rel=1e-4)


def test_a_closed_asset_of_known_density_has_its_mass(tmp_path: Path) -> None:
    import trimesh

    from core.io.asset import write_asset

    box = trimesh.creation.box((0.2, 0.2, 0.5))
    verts = torch.tensor(box.vertices, dtype=torch.float32)
    faces = torch.tensor(box.faces, dtype=torch.long)
    uv = torch.rand(3, 2, generator=torch.Generator().manual_seed(0))
    mesh = Mesh(verts, faces, uv, torch.arange(3).expand(len(faces), 3))
    flat = torch.zeros(4, 4, 3)
    maps = Maps(flat, flat, flat + torch.tensor([0.0, 0, 1]))
    write_asset(tmp_path / "box", mesh, maps, {"density": 650.0})
    report = json.loads((tmp_path / "box" / "asset.json").read_text("utf-8"))
    assert report["size_m"] == 0.5
    assert report["mass_kg"] == pytest.approx(0.02 * 650, rel=1e-3)


def test_pictures_and_glb_say_where_they_came_from(parts, tmp_path: Path) -> None:
    info = INFO | {"prompt": "ein roter Stuhl, größer", "guidance": "builtin", "preset": "draft"}
    weights = {"geometry.safetensors": "cd" * 32}
    info["made_by"] = {"python": "3.11.7", "torch": "2.13.0", "weights": weights}
    hashes = f"geometry.safetensors sha256:{'cd' * 32}"
    folder = write_asset(tmp_path / "made", *parts, info)
    for name in ("base_color.png", "orm.png", "normal.png"):
        data = (folder / name).read_bytes()
        assert b"iTXtPrompt" in data
        assert "ein roter Stuhl, größer".encode() in data
        assert b"iTXtSeed\0\0\0\0\x003" in data
        assert b"iTXtModel Hashes\0\0\0\0\0" + hashes.encode() in data
    glb = (folder / "asset.glb").read_bytes()
    (length,) = struct.unpack("<I", glb[12:16])
    node = json.loads(glb[20 : 20 + length])["nodes"][0]
    assert node["name"] == "ein roter Stuhl, größer"
    assert node["extras"]["seed"] == "3"
    assert node["extras"]["versions"] == "python 3.11.7, torch 2.13.0"
    assert node["extras"]["model_hashes"] == hashes
    report = json.loads((folder / "asset.json").read_text("utf-8"))
    import hashlib

    mesh = hashlib.sha256((folder / "mesh.obj").read_bytes()).hexdigest()
    assert report["hashes"]["mesh.obj"] == mesh


def test_text_in_a_png_leaves_its_pixels_and_other_readers_find_it(tmp_path: Path) -> None:
    import OpenImageIO

    pixels = np.random.default_rng(0).integers(0, 255, (5, 7, 3), dtype=np.uint8)
    images.write_png(tmp_path / "a.png", pixels)
    images.add_text(tmp_path / "a.png", {"Prompt": "a chair", "Seed": "7"})
    assert (images.read_png(tmp_path / "a.png") == pixels).all()
    spec = OpenImageIO.ImageInput.open(str(tmp_path / "a.png")).spec()
    assert spec.get_string_attribute("Prompt") == "a chair"


@pytest.mark.parametrize("format", ["stl", "3mf"])
def test_a_print_file_is_the_watertight_mesh_in_millimetres(folder, tmp_path, format) -> None:
    """STL is read by trimesh; 3MF by its own XML."""
    import xml.etree.ElementTree as ElementTree
    import zipfile

    import trimesh

    asset = read_asset(folder)
    out = export(folder, format, tmp_path / f"ring.{format}")
    if format == "stl":
        back = trimesh.load(out)
        verts, faces = np.asarray(back.vertices), np.asarray(back.faces)
        assert back.is_watertight
    else:
        with zipfile.ZipFile(out) as file:
            root = ElementTree.fromstring(file.read("3D/3dmodel.model"))
        assert root.get("unit") == "millimeter"
        rows = [[float(e.get(k)) for k in "xyz"] for e in root.iter() if e.tag.endswith("}vertex")]
        keys = ("v1", "v2", "v3")
        triangles = [e for e in root.iter() if e.tag.endswith("}triangle")]
        verts, faces = np.array(rows), np.array([[int(e.get(k)) for k in keys] for e in triangles])
        np.testing.assert_array_equal(faces, asset.mesh.faces.numpy())
    a, b, c = (verts[faces[:, i]] for i in range(3))
    volume = np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6
    expected = health(asset.mesh.verts, asset.mesh.faces)["volume"]
    assert volume == pytest.approx(1e9 * expected, rel=1e-4)
    again = export(folder, format, tmp_path / f"again.{format}")
    assert again.read_bytes() == out.read_bytes()


def test_an_open_mesh_is_not_printed(parts, tmp_path: Path) -> None:
    mesh, maps = parts
    uv, face_uvs = mesh.atlas
    opened = Mesh(mesh.verts, mesh.faces[1:], uv, face_uvs[1:])
    folder = write_asset(tmp_path / "open", opened, maps, INFO)
    with pytest.raises(UserError, match="not watertight: 3 open"):
        export(folder, "stl", tmp_path / "open.stl")


def test_a_mesh_with_a_turned_face_is_not_printed_and_that_is_reported(
    parts, tmp_path: Path
) -> None:
    mesh, _ = parts
    turned = torch.cat([mesh.faces[:1].flip(1), mesh.faces[1:]])
    write_plain_obj(tmp_path / "turned.obj", mesh.verts, turned)
    with pytest.raises(UserError, match="0 non-manifold edges, and not all faces look outwards"):
        export(tmp_path / "turned.obj", "stl", tmp_path / "turned.stl")


def test_a_3mf_is_packed(folder, tmp_path: Path) -> None:
    with zipfile.ZipFile(export(folder, "3mf", tmp_path / "a.3mf")) as file:
        (model,) = [entry for entry in file.infolist() if entry.filename.endswith(".model")]
    assert model.compress_size < model.file_size / 2


def test_an_obj_has_its_roughness_and_metallic_as_maps(folder, tmp_path: Path) -> None:
    export(folder, "obj", tmp_path / "ring.obj")
    text = (tmp_path / "ring.mtl").read_text()
    assert "map_Pr ring_roughness.png" in text
    assert "map_Pm ring_metallic.png" in text
    orm = images.read_png(folder / "orm.png")
    for channel, name in ((1, "roughness"), (2, "metallic")):
        picture = images.read_png(tmp_path / f"ring_{name}.png")
        assert (picture == orm[..., channel : channel + 1]).all()
