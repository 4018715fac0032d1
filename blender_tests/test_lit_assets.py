"""What glows and what lets light through: on import, in Cycles, in edits, and in other formats."""

import json

import numpy as np
import pytest

bpy = pytest.importorskip("bpy")

from blender_tests.asset_fixture import plane, write_asset  # noqa: E402
from blender_tests.pictures import read, render, set_light  # noqa: E402
from blender_tests.test_exports import bring_back  # noqa: E402
from fantasia3d_addon.asset.asset_folder import read_asset  # noqa: E402
from fantasia3d_addon.asset.import_asset import import_asset  # noqa: E402
from fantasia3d_addon.blender import compat  # noqa: E402
from fantasia3d_addon.errors import AssetError  # noqa: E402
from fantasia3d_addon.material.edit import image_of, principled  # noqa: E402
from fantasia3d_addon.mesh import engines, export, maps, region, remesh  # noqa: E402

pytestmark = [
    pytest.mark.blender,
    pytest.mark.usefixtures("empty"),
    # Blender 5.2's own FBX exporter under NumPy 2.5
    pytest.mark.filterwarnings("ignore:Setting the shape:DeprecationWarning"),
]
SIZE = 64
SIDE = np.arange(SIZE) < SIZE // 3  # the columns of the atlas' first islands


def glow() -> np.ndarray:
    """Orange on the block's right and front sides, which share the atlas' first columns."""
    return np.where(SIDE[None, :, None], np.uint8([255, 120, 20]), np.uint8(0)).repeat(SIZE, 0)


def clear() -> np.ndarray:
    """Where it does not glow, three quarters."""
    return np.where(SIDE[None, :, None], np.uint8(0), np.uint8([191] * 3)).repeat(SIZE, 0)


@pytest.fixture
def lit(tmp_path):
    """The folder of a block that glows on some of its sides and is clear on the others."""
    return write_asset(tmp_path / "lit", emission=glow(), transmission=clear())


def sockets(obj) -> dict[str, object]:
    """The picture that feeds each of the two, and what they are taken with."""
    inputs = principled(obj.active_material).inputs
    found = {name: image_of(inputs[name]) for name in ("Emission Color", "Transmission Weight")}
    numbers = {name: round(inputs[name].default_value, 4) for name in ("Emission Strength", "IOR")}
    return {name: pair and pair[0] for name, pair in found.items()} | numbers


def pixels(image) -> np.ndarray:
    """As in the file, row 0 at the top."""
    flat = np.empty(len(image.pixels), np.float32)
    image.pixels.foreach_get(flat)
    return flat.reshape(image.size[1], image.size[0], -1)[::-1, :, :3]


def test_the_maps_feed_their_sockets_with_the_assets_own_numbers(lit):
    found = sockets(import_asset(bpy.context, lit))
    assert (found["Emission Strength"], found["IOR"]) == (4, 1.3)
    emission, transmission = found["Emission Color"], found["Transmission Weight"]
    assert not emission.colorspace_settings.is_data and transmission.colorspace_settings.is_data
    np.testing.assert_allclose(pixels(emission) * 255, glow(), atol=0.01)
    np.testing.assert_allclose(pixels(transmission) * 255, clear(), atol=0.01)
    assert emission.packed_file and transmission.packed_file


def test_an_asset_without_them_has_no_such_nodes(asset):
    obj = import_asset(bpy.context, asset)
    plain = bpy.data.materials.new("plain")
    tree = compat.empty_nodes(plain)
    usual = tree.nodes.new("ShaderNodeBsdfPrincipled").inputs
    found = sockets(obj)
    assert found["Emission Color"] is found["Transmission Weight"] is None
    for name in ("Emission Strength", "IOR"):
        assert found[name] == pytest.approx(usual[name].default_value, abs=1e-4)


@pytest.mark.parametrize("value", ["much", None, True, -1, 1e9, [4]])
def test_a_strength_that_is_no_number_is_a_sentence(lit, value):
    info = json.loads((lit / "asset.json").read_text())
    info["files"]["emission.png"]["strength"] = value
    (lit / "asset.json").write_text(json.dumps(info))
    with pytest.raises(AssetError, match=r"strength or ior"):
        read_asset(lit)


def test_a_map_that_asset_json_names_and_that_is_not_there_is_a_sentence(lit):
    (lit / "transmission.png").unlink()
    with pytest.raises(AssetError, match=r"transmission.png is missing"):
        read_asset(lit)


def test_in_the_dark_it_is_seen_by_its_own_light(lit, asset, tmp_path):
    set_light(tmp_path, (0, -1, 0), strength=0)
    obj = import_asset(bpy.context, lit)
    picture = render(obj, tmp_path, azimuth_deg=45, elevation_deg=10, samples=16)
    assert picture[..., 0].max() > 0.99 and picture[..., 2].mean() < 0.5 * picture[..., 0].mean()
    bpy.data.objects.remove(obj)
    dark = render(import_asset(bpy.context, asset), tmp_path, 45, 10, samples=16)
    assert dark.max() < 0.01


@pytest.mark.parametrize("through", [0, 255])
def test_what_is_clear_shows_what_is_behind_it(tmp_path, through):
    """A black pane before a green sign: the sign is seen through it, or not at all."""
    white = np.full((SIZE, SIZE, 3), 255, np.uint8)
    pane = write_asset(
        tmp_path / "pane", plane(), base_color=white, transmission=white // 255 * np.uint8(through)
    )
    sign = write_asset(
        tmp_path / "sign", plane(), base_color=0 * white, emission=white * np.uint8([0, 1, 0])
    )
    set_light(tmp_path, (0, -1, 0), strength=0)
    front, back = import_asset(bpy.context, pane), import_asset(bpy.context, sign)
    back.location.y = 0.5
    bpy.context.view_layer.update()
    middle = render(front, tmp_path, 0, 0, samples=16)[SIZE // 2, SIZE // 2]
    assert (middle[1] > 0.9) == (through > 0) and middle[0] < 0.2


def test_a_regions_new_maps_bring_take_and_replace_what_glows(lit, asset, tmp_path):
    other = write_asset(tmp_path / "other", emission=255 - glow())
    obj = import_asset(bpy.context, lit)
    region.show_maps(obj, read_asset(other), "other")
    found = sockets(obj)
    np.testing.assert_allclose(pixels(found["Emission Color"]) * 255, 255 - glow(), atol=0.01)
    assert found["Transmission Weight"] is None
    region.show_maps(obj, read_asset(asset), "plain")
    found = sockets(obj)
    assert found["Emission Color"] is None and found["Emission Strength"] == 0
    region.show_maps(obj, read_asset(lit), "again")
    found = sockets(obj)
    assert found["Emission Color"] and found["Transmission Weight"]
    assert (found["Emission Strength"], found["IOR"]) == (4, 1.3)


def test_what_a_region_keeps_has_all_the_maps_byte_for_byte(lit, asset, tmp_path):
    names = {}
    for folder in (lit, asset):
        kept = region.write_kept(import_asset(bpy.context, folder), tmp_path / f"of {folder.name}")
        names[folder] = kept.keys()
        for role in ("emission", "transmission"):
            path = folder / f"{role}.png"
            assert (path.name in kept) == path.is_file()
            assert not path.is_file() or kept[path.name].read_bytes() == path.read_bytes()
        report = json.loads(kept["asset.json"].read_text())["files"]
        assert report.keys() == kept.keys() - {"asset.json"}


def test_quads_glow_where_the_triangles_did(lit):
    obj = import_asset(bpy.context, lit)
    made = remesh.quad_remesh(obj, faces=500, size=SIZE)
    found = sockets(made)
    assert (found["Emission Strength"], found["IOR"]) == (4, 1.3)
    emission, transmission = (
        pixels(found[name]) for name in ("Emission Color", "Transmission Weight")
    )
    glows = emission[..., 0] > 0.5
    assert 0.05 < glows.mean() < 0.6
    assert np.abs(emission[glows].mean(0) * 255 - (255, 120, 20)).max() < 12
    assert transmission[~glows].mean() > 0.6 > 0.1 > np.median(transmission[glows])


def test_materials_of_several_strengths_become_one(lit, asset):
    """What glows half as strongly has half of the light in the joined map."""
    obj, weak = import_asset(bpy.context, lit), bpy.data.materials.new("weak")
    bsdf = compat.empty_nodes(weak).nodes.new("ShaderNodeBsdfPrincipled")
    output = weak.node_tree.nodes.new("ShaderNodeOutputMaterial")
    weak.node_tree.links.new(bsdf.outputs["BSDF"], output.inputs["Surface"])
    bsdf.inputs["Emission Color"].default_value = (1, 1, 1, 1)
    bsdf.inputs["Emission Strength"].default_value = 2
    obj.data.materials.append(weak)
    half = len(obj.data.polygons) // 2
    obj.data.polygons.foreach_set("material_index", [i >= half for i in range(2 * half)])
    found = maps.maps_of(obj)
    assert found.light == (4, pytest.approx(1.3))
    top = maps.to_linear(found.emission[4 : SIZE // 2 - 4, 4:-4])  # islands of the second half
    np.testing.assert_allclose(np.median(top, (0, 1)), 0.5, atol=0.02)


@pytest.mark.parametrize("ending", ["glb", "usdc", "fbx", "obj"])
def test_what_glows_leaves_in_each_format_and_what_is_clear_in_gltf(lit, tmp_path, ending):
    if ending.startswith("usd") and not compat.has_usd():
        pytest.skip("this build writes no USD")
    path = export.export_object(import_asset(bpy.context, lit), tmp_path / "out" / f"x.{ending}")
    bpy.ops.wm.read_factory_settings(use_empty=True)
    found = sockets(bring_back(path))
    np.testing.assert_allclose(pixels(found["Emission Color"]) * 255, glow(), atol=1)
    if ending in ("glb", "fbx"):
        assert found["Emission Strength"] == 4
    if ending == "glb":
        np.testing.assert_allclose(pixels(found["Transmission Weight"]) * 255, clear(), atol=1)
        assert found["IOR"] == 1.3


@pytest.mark.parametrize(("engine", "names"), [
    ("unity", ("{}_Emission", "{}_Transmission")), ("unreal", ("T_{}_E", "T_{}_T")), ("godot", ())
])  # fmt: skip
def test_an_engine_gets_them_under_its_names(lit, tmp_path, engine, names):
    obj = import_asset(bpy.context, lit)
    path = engines.export_for(obj, tmp_path / "out", engine)
    for name, wanted in zip(names, (glow(), clear()), strict=False):
        picture = read(path.with_name(name.format(path.stem) + ".png"))
        np.testing.assert_allclose(picture * 255, wanted, atol=1)
    if engine == "godot":
        assert b"KHR_materials_emissive_strength" in path.read_bytes()
        assert b"KHR_materials_transmission" in path.read_bytes()
