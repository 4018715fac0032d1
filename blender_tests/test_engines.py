"""Exports for game engines: names, axes, scale and channels as each importer expects."""

import json
import struct

import numpy as np
import pytest

bpy = pytest.importorskip("bpy")

from blender_tests.asset_fixture import bump_normals, write_asset  # noqa: E402
from blender_tests.pictures import read  # noqa: E402
from fantasia3d_addon.asset.import_asset import import_asset  # noqa: E402
from fantasia3d_addon.blender.mesh_arrays import verts_of  # noqa: E402
from fantasia3d_addon.errors import OutputError  # noqa: E402
from fantasia3d_addon.mesh import engines, maps  # noqa: E402

pytestmark = [
    pytest.mark.blender,
    pytest.mark.usefixtures("empty"),
    # Blender 5.2's own FBX exporter under NumPy 2.5
    pytest.mark.filterwarnings("ignore:Setting the shape:DeprecationWarning"),
]
NAME = "a_red_wooden_chair"


@pytest.fixture
def obj(tmp_path):
    """The block, half metallic, moved away, turned and enlarged."""
    folder = write_asset(tmp_path / "asset", normal=bump_normals(64), metallic=0.25, roughness=0.5)
    made = import_asset(bpy.context, folder)
    made.location, made.scale = (3, -2, 1), (2, 2, 2)
    bpy.context.view_layer.update()
    return made


def fbx(path):
    """Nodes by name (their type and local scale), the scale of the unit, vertices by node."""
    from io_scene_fbx import parse_fbx

    root, _ = parse_fbx.parse(str(path), use_namedtuple=True)
    top = {elem.id: elem for elem in root.elems}
    settings = next(e for e in top[b"GlobalSettings"].elems if e.id == b"Properties70")
    values = {p.props[0]: p.props[4:] for p in settings.elems}
    named = lambda e: e.props[1].split(b"\0")[0].decode()  # noqa: E731
    objects = top[b"Objects"].elems
    kinds = {named(e): e.props[2].decode() for e in objects if e.id == b"Model"}
    # The type of a node without a mesh is in its attribute.
    kinds["groups"] = [e.props[2].decode() for e in objects if e.id == b"NodeAttribute"]
    local = {
        named(e): {
            p.props[0].decode(): p.props[4:]
            for block in e.elems
            if block.id == b"Properties70"
            for p in block.elems
        }
        for e in objects
        if e.id == b"Model"
    }
    verts = {
        named(e): np.array(next(v.props[0] for v in e.elems if v.id == b"Vertices")).reshape(-1, 3)
        for e in objects
        if e.id == b"Geometry"
    }
    return kinds, local, values[b"UnitScaleFactor"][0], verts


def size_of(obj):
    points = verts_of(obj.data) * 2
    return points.min(0), points.max(0)


def test_unity_gets_metres_lods_and_a_mask_map(obj, tmp_path):
    low, high = size_of(obj)
    before = {kind: len(getattr(bpy.data, kind)) for kind in ("objects", "meshes", "materials",
                                                              "images", "collections")}  # fmt: skip
    path = engines.export_for(obj, tmp_path / "out", "unity")
    assert {k: len(getattr(bpy.data, k)) for k in before} == before
    assert obj.name == "a red wooden chair"
    kinds, local, unit, verts = fbx(path)
    assert {f"{NAME}_LOD{i}" for i in range(4)} <= kinds.keys()
    assert f"{NAME}_Collider_00" in kinds
    for properties in local.values():
        assert properties.get("Lcl Scaling", [1, 1, 1]) == pytest.approx([1, 1, 1])
        assert properties.get("Lcl Rotation", [0, 0, 0]) == pytest.approx([0, 0, 0], abs=1e-4)
    # +Y up, the front (-Y here) along +Z; 100: a unit is 100 cm
    found = verts[f"{NAME}_LOD0"]
    assert unit == 100
    np.testing.assert_allclose(found.min(0), [low[0], low[2], -high[1]], atol=1e-5)
    np.testing.assert_allclose(found.max(0), [high[0], high[2], -low[1]], atol=1e-5)
    counts = [len(verts[f"{NAME}_LOD{i}"]) for i in range(4)]
    assert counts == sorted(counts, reverse=True) and counts[3] < counts[0] / 4
    image = bpy.data.images.load(str(path.with_name(f"{NAME}_MaskMap.png")))
    image.alpha_mode = "CHANNEL_PACKED"  # or Blender multiplies the colour by it
    image.colorspace_settings.is_data = True
    pixels = np.array(image.pixels[:]).reshape(64, 64, 4)
    np.testing.assert_allclose(pixels[32, 32], [0.25, 1, 0, 0.5], atol=0.01)


def test_unreal_gets_centimetres_a_lod_group_and_its_colliders(obj, tmp_path):
    low, high = size_of(obj)
    normal = maps.maps_of(obj).normal
    path = engines.export_for(obj, tmp_path / "out", "unreal")
    kinds, local, unit, verts = fbx(path)
    assert kinds["groups"] == ["LodGroup"]
    assert {f"{NAME}_LOD{i}" for i in range(4)} <= kinds.keys()
    assert f"UCX_{NAME}_LOD0_00" in kinds
    for name, properties in local.items():
        assert properties.get("Lcl Scaling", [1, 1, 1]) == pytest.approx([1, 1, 1]), name
    # The front (-Y here) along +X; +Y up in the file, which Unreal turns to +Z; centimetres
    found = verts[f"{NAME}_LOD0"] / 100
    assert unit == 1
    np.testing.assert_allclose(found.min(0), [-high[1], low[2], -high[0]], atol=1e-5)
    np.testing.assert_allclose(found.max(0), [-low[1], high[2], -low[0]], atol=1e-5)
    orm = read(path.with_name(f"T_{NAME}_ORM.png"))
    np.testing.assert_allclose(orm[8, 8], [1, 0.5, 0.25], atol=0.01)
    flipped = read(path.with_name(f"T_{NAME}_N.png"))
    np.testing.assert_allclose(flipped[..., 1], 1 - normal[..., 1], atol=1e-4)


def test_godot_gets_one_file_with_its_colliders(obj, tmp_path):
    path = engines.export_for(obj, tmp_path / "out", "godot")
    assert [p.name for p in path.parent.iterdir()] == [f"{NAME}.glb"]
    data = path.read_bytes()
    header = json.loads(data[20 : 20 + struct.unpack("<I", data[12:16])[0]])
    names = [node["name"] for node in header["nodes"]]
    assert NAME in names and f"{NAME}_00-convcolonly" in names
    assert not any("LOD" in name for name in names)
    shading = header["materials"][0]["pbrMetallicRoughness"]
    assert "metallicRoughnessTexture" in shading
    for node in header["nodes"]:
        assert not {"scale", "rotation", "translation"} & node.keys()


def test_the_colliders_fill_the_asset(obj, tmp_path):
    low, high = size_of(obj)
    _, _, _, verts = fbx(engines.export_for(obj, tmp_path, "unity"))
    hulls = np.concatenate([v for name, v in verts.items() if "Collider" in name])
    np.testing.assert_allclose(hulls.max(0) - hulls.min(0), (high - low)[[0, 2, 1]], rtol=0.05)


def test_an_unknown_engine_is_a_sentence(obj, tmp_path):
    with pytest.raises(OutputError, match=r"no engine 'quake'.*godot, unity, unreal"):
        engines.export_for(obj, tmp_path, "quake")
