"""The maps that leave are over the UV map that the material's pictures are over."""

import numpy as np
import pytest

bpy = pytest.importorskip("bpy")

from blender_tests.asset_fixture import SIDES, write_asset  # noqa: E402
from blender_tests.test_exports import bring_back  # noqa: E402
from fantasia3d_addon.asset.import_asset import import_asset  # noqa: E402
from fantasia3d_addon.asset.origin import DENSITY  # noqa: E402
from fantasia3d_addon.asset.texture_object import show_on_all_slots  # noqa: E402
from fantasia3d_addon.blender import compat  # noqa: E402
from fantasia3d_addon.blender.mesh_arrays import corner_uv, values  # noqa: E402
from fantasia3d_addon.errors import AddonError  # noqa: E402
from fantasia3d_addon.jobs import print_export  # noqa: E402
from fantasia3d_addon.material import edit as material_edit  # noqa: E402
from fantasia3d_addon.mesh import engines, export, maps  # noqa: E402

pytestmark = [
    pytest.mark.blender,
    pytest.mark.usefixtures("empty"),
    # Blender 5.2's own FBX exporter under NumPy 2.5
    pytest.mark.filterwarnings("ignore:Setting the shape:DeprecationWarning"),
]


@pytest.fixture
def obj(tmp_path):
    """An asset whose mesh has another UV map, the active one, which no picture is over."""
    made = import_asset(bpy.context, write_asset(tmp_path / "asset"))
    layers = made.data.uv_layers
    layers.new(name="mine", do_init=False)
    layers["mine"].uv.foreach_set("vector", np.full(2 * len(made.data.loops), 0.05, np.float32))
    layers.active = layers["mine"]
    layers["mine"].active_render = True
    bpy.context.view_layer.update()
    return made


def shown_uv(obj) -> np.ndarray:
    """The UVs that the picture of the base colour is over."""
    node = material_edit.picture_of(
        material_edit.principled(obj.active_material).inputs["Base Color"]
    )[0]
    links = node.inputs["Vector"].links
    name = links[0].from_node.uv_map if links else ""
    layers = obj.data.uv_layers
    return values((layers[name] if name else layers[0]).uv, "vector", 2)


def show_over_the_second(obj) -> np.ndarray:
    """Swap the two UV maps and what the pictures are over; the UVs that they are over."""
    layers = obj.data.uv_layers
    own, mine = (values(layers[name].uv, "vector", 2) for name in ("UVMap", "mine"))
    layers["UVMap"].uv.foreach_set("vector", mine.ravel())
    layers["mine"].uv.foreach_set("vector", own.ravel())
    for node in obj.active_material.node_tree.nodes:
        if hasattr(node, "uv_map"):
            node.uv_map = "mine"
    return own


@pytest.mark.parametrize("ending", ["glb", "fbx", "obj"])
def test_an_export_shows_the_pictures_over_their_own_uv_map(obj, tmp_path, ending):
    own = values(obj.data.uv_layers["UVMap"].uv, "vector", 2)
    path = export.export_object(obj, tmp_path / f"x.{ending}")
    assert obj.data.uv_layers.active.name == "mine"
    bpy.ops.wm.read_factory_settings(use_empty=True)
    found = shown_uv(bring_back(path))
    np.testing.assert_allclose(found.min(0), own.min(0), atol=1e-4)
    np.testing.assert_allclose(found.max(0), own.max(0), atol=1e-4)


def test_an_engine_gets_them_as_the_first_uv_map(obj, tmp_path):
    own = show_over_the_second(obj)
    path = engines.export_for(obj, tmp_path / "out", "godot")
    bpy.ops.wm.read_factory_settings(use_empty=True)
    bpy.ops.import_scene.gltf(filepath=str(path))
    back = next(o for o in bpy.data.objects if o.type == "MESH" and "conv" not in o.name)
    first = values(back.data.uv_layers[0].uv, "vector", 2)
    np.testing.assert_allclose(first.max(0), own.max(0), atol=1e-4)


@pytest.mark.parametrize("ending", ["glb", "fbx"])
def test_an_export_keeps_the_uv_maps_before_that_of_the_pictures(obj, tmp_path, ending):
    """Such as a light map's: it comes after, since programs show the pictures over the first."""
    own = show_over_the_second(obj)
    path = export.export_object(obj, tmp_path / f"x.{ending}")
    bpy.ops.wm.read_factory_settings(use_empty=True)
    first, second = (values(layer.uv, "vector", 2) for layer in bring_back(path).data.uv_layers)
    np.testing.assert_allclose(first.max(0), own.max(0), atol=1e-4)
    np.testing.assert_allclose(second, 0.05, atol=1e-4)


def test_a_simulators_body_gets_them_too(obj, tmp_path):
    own = values(obj.data.uv_layers["UVMap"].uv, "vector", 2)
    print_export._write_asset(obj, tmp_path)
    lines = (tmp_path / "mesh.obj").read_text().splitlines()
    found = np.array([line.split()[1:] for line in lines if line.startswith("vt ")], float)
    np.testing.assert_allclose(found.max(0), own.max(0), atol=1e-4)
    obj[DENSITY] = "heavy"
    with pytest.raises(AddonError, match="is not a number above 0"):
        print_export._write_asset(obj, tmp_path)


def test_a_uv_map_that_the_modifiers_lose_is_a_sentence_and_leaves_nothing(obj):
    material_edit.replace_material(obj, "wood")
    nodes = bpy.data.node_groups.new("lose", "GeometryNodeTree")
    nodes.interface.new_socket("Mesh", in_out="OUTPUT", socket_type="NodeSocketGeometry")
    cube, out = (nodes.nodes.new(name) for name in ("GeometryNodeMeshCube", "NodeGroupOutput"))
    nodes.links.new(cube.outputs["Mesh"], out.inputs[0])
    obj.modifiers.new("lose", "NODES").node_group = nodes
    bpy.context.view_layer.update()
    before = len(bpy.data.meshes)
    with pytest.raises(AddonError, match="leave no UV map"):
        maps.maps_of(obj, 16)
    assert len(bpy.data.meshes) == before


def test_slots_of_one_material_are_one_material(obj):
    """As a job leaves an object whose every slot it shows its material in."""
    before = maps.maps_of(obj).base_color
    obj.data.materials.append(None)
    show_on_all_slots(obj, obj.data.materials[0])
    assert np.array_equal(maps.maps_of(obj).base_color, before)


def test_a_picture_over_something_else_is_baked(obj):
    """Each side shows its neighbour's part of the picture."""
    tree = obj.active_material.node_tree
    picture = material_edit.picture_of(
        material_edit.principled(obj.active_material).inputs["Base Color"]
    )[0]
    mapping = tree.nodes.new("ShaderNodeMapping")
    mapping.inputs["Location"].default_value = (1 / 3, 0, 0)
    tree.links.new(picture.inputs["Vector"].links[0].from_socket, mapping.inputs["Vector"])
    tree.links.new(mapping.outputs["Vector"], picture.inputs["Vector"])
    color = maps.maps_of(obj, 32).base_color[20:28, 2:8]
    np.testing.assert_allclose(color, np.full((8, 6, 3), SIDES["left"][2]) / 255, atol=0.02)


def test_a_picture_in_a_box_projection_and_an_alpha_are_baked(tmp_path):
    """Not texel for texel over the UV map, and no colour."""
    obj = import_asset(bpy.context, write_asset(tmp_path / "asset", roughness=0.5))
    before, tree = maps.maps_of(obj, 32), obj.active_material.node_tree
    bsdf = material_edit.principled(obj.active_material)
    picture = material_edit.picture_of(bsdf.inputs["Base Color"])[0]
    picture.projection = "BOX"
    tree.links.new(picture.outputs["Alpha"], bsdf.inputs["Metallic"])
    found = maps.maps_of(obj, 32)
    assert np.abs(found.base_color - before.base_color).mean() > 0.05
    picture.projection = "FLAT"
    assert maps.maps_of(obj, 32).metallic[8:24].mean() == pytest.approx(1, abs=0.01)


def test_what_a_modifier_bends_is_baked_where_it_is(tmp_path):
    obj = import_asset(bpy.context, write_asset(tmp_path / "asset"))
    material_edit.replace_material(obj, "wood")
    bend = obj.modifiers.new("bend", "SIMPLE_DEFORM")
    bend.deform_method, bend.angle = "BEND", 1.0
    bpy.context.view_layer.update()
    assert (maps.maps_of(obj, 32).base_color.sum(-1) > 0).all()  # the rays found it


def test_a_lost_picture_is_a_sentence(obj, tmp_path):
    picture = material_edit.picture_of(
        material_edit.principled(obj.active_material).inputs["Base Color"]
    )[0]
    picture.image = bpy.data.images.new("gone", 8, 8)
    picture.image.source, picture.image.filepath = "FILE", str(tmp_path / "nowhere.png")
    with pytest.raises(AddonError, match="“gone” can't be read"):
        export.export_object(obj, tmp_path / "x.glb")


def test_a_removed_adjustment_is_none(tmp_path):
    obj = import_asset(bpy.context, write_asset(tmp_path / "asset", roughness=0.5))
    material_edit.adjust_material(obj.active_material, (1, 0.5, 0.5), 0.5)
    nodes = obj.active_material.node_tree.nodes
    nodes.remove(nodes["Fantasia3D tint"])
    found = maps.maps_of(obj)
    np.testing.assert_allclose(found.roughness, 0.25, atol=0.01)


def test_a_strength_from_nodes_is_a_part_of_the_strongest(tmp_path):
    obj = import_asset(bpy.context, write_asset(tmp_path / "asset"))
    strong, fed = bpy.data.materials.new("strong"), bpy.data.materials.new("fed")
    for material, strength in ((strong, 5.0), (fed, 0.0)):
        if not compat.ALWAYS_HAS_NODES:
            material.use_nodes = True
        bsdf = material_edit.principled(material)
        bsdf.inputs["Emission Color"].default_value = (1, 1, 1, 1)
        bsdf.inputs["Emission Strength"].default_value = strength
    value = fed.node_tree.nodes.new("ShaderNodeValue")
    value.outputs[0].default_value = 2.5
    fed.node_tree.links.new(
        value.outputs[0], material_edit.principled(fed).inputs["Emission Strength"]
    )
    obj.data.materials.clear()
    for material in (strong, fed):
        obj.data.materials.append(material)
    half = len(obj.data.polygons) // 2
    obj.data.polygons.foreach_set("material_index", [i >= half for i in range(2 * half)])
    found = maps.maps_of(obj, 64)
    assert found.light.strength == 5
    uv = corner_uv(obj.data).reshape(-1, 3, 2).mean(1)[half:]
    rows, columns = ((1 - uv[:, 1]) * 64).astype(int), (uv[:, 0] * 64).astype(int)
    glow = maps.to_linear(found.emission[rows, columns])
    np.testing.assert_allclose(np.median(glow), 0.5, atol=0.02)
