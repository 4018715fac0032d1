"""The object, its material, its entry in the Asset Browser and its GLB state their origin."""

import json
import struct

import pytest

bpy = pytest.importorskip("bpy")

from blender_tests.asset_fixture import write_asset  # noqa: E402
from fantasia3d_addon.asset.import_asset import import_asset  # noqa: E402
from fantasia3d_addon.asset.origin import origin_of  # noqa: E402
from fantasia3d_addon.mesh import asset_browser, export  # noqa: E402

pytestmark = [pytest.mark.blender]
INFO = {
    "seed": 2**40,
    "density": 650.0,
    "made_by": {
        "software": "Fantasia3D for Blender 0.1.0",
        "python": "3.11.7",
        "torch": "2.13.0+cpu",
        "weights": {"geometry.safetensors": "cd" * 32, "parts.safetensors": "ef" * 32},
    },
    "hashes": {"mesh.obj": "ab" * 32},
}
ORIGIN = {
    "prompt": "a red wooden chair",
    "preset": "draft",
    "guidance": "builtin",
    "seed": str(2**40),
    "software": "Fantasia3D for Blender 0.1.0",
    "versions": "python 3.11.7, torch 2.13.0+cpu",
    "model_hashes": f"geometry.safetensors sha256:{'cd' * 32}, "
    f"parts.safetensors sha256:{'ef' * 32}",
    "mesh_hash": "ab" * 32,
}


@pytest.fixture
def chair(empty, tmp_path):
    return import_asset(bpy.context, write_asset(tmp_path / "asset", size=16, **INFO))


def test_object_and_material_keep_it_also_in_the_saved_file(chair, tmp_path):
    assert origin_of(chair) == origin_of(chair.active_material) == ORIGIN
    name, path = chair.name, str(tmp_path / "a.blend")
    bpy.ops.wm.save_as_mainfile(filepath=path)
    bpy.ops.wm.open_mainfile(filepath=path)
    assert origin_of(bpy.data.objects[name]) == ORIGIN


def test_the_asset_browser_has_it(chair):
    asset_browser.mark_asset(chair, thumbnail=False)
    data = chair.asset_data
    assert (data.description, data.author) == (ORIGIN["prompt"], ORIGIN["software"])
    assert origin_of(data) == ORIGIN


def test_an_exported_glb_has_it_and_the_prompts_name(chair, tmp_path):
    data = export.export_object(chair, tmp_path / "a.glb").read_bytes()
    (length,) = struct.unpack("<I", data[12:16])
    (node,) = json.loads(data[20 : 20 + length])["nodes"]
    assert node["name"] == ORIGIN["prompt"]
    assert node["extras"] == {f"fantasia3d_{key}": value for key, value in ORIGIN.items()} | {
        "fantasia3d_density": 650.0
    }


def test_an_asset_of_an_earlier_release_has_what_it_states(empty, asset):
    assert set(origin_of(import_asset(bpy.context, asset))) == {"prompt", "preset", "guidance"} | {
        "seed"
    }


def test_nonsense_in_asset_json_is_passed_over(empty, tmp_path):
    wrong = {"seed": "x", "density": "heavy", "made_by": 3, "hashes": ["a"], "preset": None}
    obj = import_asset(bpy.context, write_asset(tmp_path / "asset", **wrong))
    assert set(origin_of(obj)) == {"prompt", "guidance"}
