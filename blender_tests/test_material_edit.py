"""Another material and back; tint and scales over the baked maps."""

import numpy as np
import pytest

bpy = pytest.importorskip("bpy")

from blender_tests.pictures import linear, render, set_light  # noqa: E402
from fantasia3d_addon.asset.import_asset import import_asset  # noqa: E402
from fantasia3d_addon.blender import compat  # noqa: E402
from fantasia3d_addon.errors import AddonError  # noqa: E402
from fantasia3d_addon.material import edit as material_edit  # noqa: E402
from fantasia3d_addon.material import library as material_library  # noqa: E402
from fantasia3d_addon.mesh import maps  # noqa: E402

pytestmark = [pytest.mark.blender, pytest.mark.usefixtures("empty")]


def wiring(material) -> set[tuple[str, str, str, str]]:
    """Every link of a material, and the pictures in it."""
    tree = material.node_tree
    links = {
        (link.from_node.name, link.from_socket.identifier, link.to_node.name,
         link.to_socket.identifier)
        for link in tree.links
    }  # fmt: skip
    images = {(n.name, n.image.name, "", "") for n in tree.nodes if n.type == "TEX_IMAGE"}
    return links | images


def middle(obj, folder) -> np.ndarray:
    """The linear colour of the front's middle."""
    return linear(render(obj, folder, size=32)[13:19, 13:19].reshape(-1, 3).mean(0))


@pytest.mark.parametrize("name", material_library.NAMES)
def test_a_material_is_swapped_and_the_same_maps_come_back(asset, name):
    obj = import_asset(bpy.context, asset)
    own, before = obj.active_material, wiring(obj.active_material)
    made = material_edit.replace_material(obj, name)
    assert obj.active_material == made != own
    assert material_edit.principled(made) is not None
    material_edit.restore_material(obj)
    assert obj.active_material == own
    assert wiring(own) == before
    assert list(bpy.data.materials) == [own]
    assert all(image.packed_file for image in bpy.data.images)


def test_gold_looks_like_gold_and_the_chair_is_red_again(asset, tmp_path):
    obj = import_asset(bpy.context, asset)
    set_light(tmp_path, (0, -1, 0.2), strength=0.3)
    red = middle(obj, tmp_path)
    material_edit.replace_material(obj, "gold")
    gold = middle(obj, tmp_path)
    material_edit.restore_material(obj)
    again = middle(obj, tmp_path)
    assert red[0] > 5 * red[1]
    assert gold[0] > gold[1] > 1.5 * gold[2]  # as (1, .77, .31)
    np.testing.assert_allclose(again, red, rtol=1e-3)


def test_another_swap_still_knows_the_first_material(asset, tmp_path):
    obj = import_asset(bpy.context, asset)
    material_edit.replace_material(obj, "wood")
    mine = bpy.data.materials.new("mine")
    material_edit.replace_material(obj, mine)
    assert obj.active_material == mine
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "x.blend"))
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "x.blend"))
    obj = bpy.data.objects["a red wooden chair"]
    material_edit.restore_material(obj)
    assert obj.active_material.name == "a red wooden chair"


def test_the_baked_detail_is_kept_only_where_asked(asset):
    obj = import_asset(bpy.context, asset)

    def kinds(material):
        return {node.bl_idname for node in material.node_tree.nodes}

    kept = material_edit.replace_material(obj, "gold", keep_normals=True)
    assert "ShaderNodeNormalMap" in kinds(kept)
    plain = material_edit.replace_material(obj, "gold", keep_normals=False)
    assert "ShaderNodeNormalMap" not in kinds(plain)


def test_an_object_of_many_slots_gets_each_back(asset):
    obj = import_asset(bpy.context, asset)
    other = bpy.data.materials.new("other")
    obj.data.materials.append(other)
    obj.data.materials.append(None)
    before = [slot.material for slot in obj.material_slots]
    material_edit.replace_material(obj, "clay")
    assert len({slot.material for slot in obj.material_slots}) == 1
    material_edit.restore_material(obj)
    assert [slot.material for slot in obj.material_slots] == before


def test_an_object_that_shares_the_mesh_keeps_its_material(asset):
    obj = import_asset(bpy.context, asset)
    copy, old = obj.copy(), obj.active_material
    bpy.context.scene.collection.objects.link(copy)
    gold = material_edit.replace_material(obj, "gold")
    assert (obj.active_material, copy.active_material) == (gold, old)
    wood = material_edit.replace_material(copy, "wood")
    assert (obj.active_material, copy.active_material) == (gold, wood)
    for each in (obj, copy):
        material_edit.restore_material(each)
        assert each.active_material == old
        assert each.material_slots[0].link == "DATA"
    assert material_edit.KEPT not in obj
    assert material_edit.LINKS not in obj


def test_the_tint_multiplies_the_colour_and_the_reset_is_exact(asset, tmp_path):
    obj = import_asset(bpy.context, asset)
    set_light(tmp_path, (0, -1, 0.2), strength=0.3)
    before, plain = wiring(obj.active_material), middle(obj, tmp_path)
    material_edit.adjust_material(obj.active_material, tint=(0.5, 1, 1))
    tinted = middle(obj, tmp_path)
    assert tinted[0] / plain[0] == pytest.approx(0.5, abs=0.08)  # the gloss keeps its white
    material_edit.adjust_material(obj.active_material)  # ones: nothing
    np.testing.assert_allclose(middle(obj, tmp_path), plain, rtol=1e-3)
    material_edit.reset_material(obj.active_material)
    assert wiring(obj.active_material) == before


def test_the_scales_are_in_the_maps_that_leave(asset):
    obj = import_asset(bpy.context, asset)
    plain = maps.maps_of(obj)
    material_edit.adjust_material(obj.active_material, (1, 1, 1), 0.5, 1.0)
    halved = maps.maps_of(obj)
    np.testing.assert_allclose(halved.roughness, plain.roughness / 2, atol=1e-6)
    np.testing.assert_allclose(halved.base_color, plain.base_color, atol=1e-6)
    material_edit.adjust_material(obj.active_material, (0.25, 1, 1), 9.0, 1.0)
    tinted = maps.maps_of(obj)
    assert tinted.roughness.max() == 1.0  # no more than there is
    np.testing.assert_allclose(
        maps.to_linear(tinted.base_color[..., 0]),
        maps.to_linear(plain.base_color[..., 0]) / 4,
        atol=1e-4,
    )


def without_nodes():
    material = bpy.data.materials.new("x")
    compat.empty_nodes(material)
    return material


@pytest.mark.parametrize(
    ("act", "message"),
    [
        (lambda obj: material_edit.replace_material(obj, "unobtainium"), "Use one of wood, gold"),
        (material_edit.restore_material, "shows its own material"),
        (
            lambda obj: material_edit.adjust_material(without_nodes()),
            "has no Principled BSDF",
        ),
    ],
)
def test_what_cannot_be_is_refused(asset, act, message):
    obj = import_asset(bpy.context, asset)
    with pytest.raises(AddonError, match=message):
        act(obj)


def test_the_operators_are_the_functions(addon, asset):
    obj = import_asset(bpy.context, asset)
    bpy.context.view_layer.objects.active = obj
    own, before = obj.active_material, wiring(obj.active_material)
    assert bpy.ops.fantasia3d.replace_material(material="wood") == {"FINISHED"}
    operator = wiring(obj.active_material)
    assert wiring(material_edit.replace_material(obj, "wood")) == operator
    assert bpy.ops.fantasia3d.restore_material() == {"FINISHED"}
    assert obj.active_material == own
    assert not bpy.ops.fantasia3d.restore_material.poll()
    assert bpy.ops.fantasia3d.adjust_material(tint=(1, 0.5, 0.25), roughness_scale=0.5) == {
        "FINISHED"
    }
    values = [material_edit.factor(n).default_value for n in material_edit.edit_nodes(own)]
    assert [round(v, 6) for v in (*values[0][:3], values[1], values[2])] == [1, 0.5, 0.25, 0.5, 1]
    assert bpy.ops.fantasia3d.reset_material() == {"FINISHED"}
    assert wiring(own) == before


def test_a_removed_adjustment_comes_back_alone(asset):
    obj = import_asset(bpy.context, asset)
    before, nodes = wiring(obj.active_material), obj.active_material.node_tree.nodes
    material_edit.adjust_material(obj.active_material, (1, 0.5, 0.5))
    nodes.remove(nodes["Fantasia3D metallic"])
    material_edit.adjust_material(obj.active_material, (1, 0.5, 0.5))
    assert sorted(n.name for n in nodes if "Fantasia3D" in n.name) == sorted(material_edit.EDITS)
    material_edit.reset_material(obj.active_material)
    assert not [n for n in nodes if "Fantasia3D" in n.name]
    assert before >= wiring(obj.active_material)


def test_a_slot_that_is_new_since_the_swap_keeps_its_material(asset):
    obj, mine = import_asset(bpy.context, asset), bpy.data.materials.new("mine")
    own = obj.active_material
    material_edit.replace_material(obj, "gold")
    obj.data.materials.append(mine)
    material_edit.restore_material(obj)
    assert [slot.material for slot in obj.material_slots] == [own, mine]
