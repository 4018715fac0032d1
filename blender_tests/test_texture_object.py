"""A material for the user's own mesh: her UVs, modifiers and slots stay as they were."""

import math
from pathlib import Path

import numpy as np
import pytest

bpy = pytest.importorskip("bpy")

from fantasia3d_addon.asset import bake_base_color, texture_object  # noqa: E402
from fantasia3d_addon.blender import compat  # noqa: E402
from fantasia3d_addon.errors import AddonError  # noqa: E402
from fantasia3d_addon.jobs import submit  # noqa: E402
from fantasia3d_addon.jobs.session import session  # noqa: E402

pytestmark = [pytest.mark.blender, pytest.mark.usefixtures("empty")]


def add_cube(size: float = 2.0) -> bpy.types.Object:
    bpy.ops.mesh.primitive_cube_add(size=size)
    return bpy.context.object


def uv_of(mesh: bpy.types.Mesh, name: str) -> np.ndarray:
    uv = np.empty(2 * len(mesh.loops), np.float32)
    mesh.uv_layers[name].uv.foreach_get("vector", uv)
    return uv.reshape(-1, 2)


def exported(path: Path) -> tuple[np.ndarray, np.ndarray]:
    """Vertices in Blender's axes, and the uv."""
    lines = [line.split() for line in path.read_text().splitlines()]
    verts = np.array([[float(x) for x in line[1:]] for line in lines if line[0] == "v"])
    uv = np.array([[float(x) for x in line[1:]] for line in lines if line[0] == "vt"])
    return np.stack([verts[:, 0], -verts[:, 2], verts[:, 1]], 1), uv


def area(uv: np.ndarray) -> np.ndarray:
    """Of each quad of the uv (4F, 2)."""
    a, b, c, d = uv.reshape(-1, 4, 2).transpose(1, 0, 2)
    cross = lambda p, q: p[:, 0] * q[:, 1] - p[:, 1] * q[:, 0]  # noqa: E731
    return np.abs(cross(c - a, d - b)) / 2


def test_the_users_uv_is_kept_and_transform_and_modifiers_are_respected(tmp_path):
    obj = add_cube()
    obj.location, obj.rotation_euler, obj.scale = (5, 0, 0), (0, 0, math.pi / 2), (1, 2, 3)
    mirror = obj.modifiers.new("Array", "ARRAY")
    mirror.relative_offset_displace[0] = 1.5
    before = uv_of(obj.data, "UVMap")
    path = tmp_path / "mesh.obj"
    assert texture_object.prepare_object(bpy.context, obj, False, path) == "UVMap"
    verts, uv = exported(path)
    assert len(verts) == 16
    np.testing.assert_allclose(verts.min(0), (3, -1, -3), atol=1e-5)  # two cubes along its x
    np.testing.assert_allclose(verts.max(0), (7, 4, 3), atol=1e-5)
    assert len(uv) == 2 * len(before)
    np.testing.assert_array_equal(uv_of(obj.data, "UVMap"), before)
    assert [layer.name for layer in obj.data.uv_layers] == ["UVMap"]


def test_a_new_uv_map_is_added_without_overlaps(tmp_path):
    obj = add_cube()
    obj.data.polygons[2].select = False
    selected = [p.select for p in obj.data.polygons]
    before = uv_of(obj.data, "UVMap")
    name = texture_object.prepare_object(bpy.context, obj, True, tmp_path / "mesh.obj")
    assert [layer.name for layer in obj.data.uv_layers] == ["UVMap", name]
    assert obj.data.uv_layers.active.name == "UVMap"
    new = uv_of(obj.data, name)
    assert new.min() >= 0
    assert new.max() <= 1
    boxes = [(q.min(0), q.max(0)) for q in new.reshape(-1, 4, 2)]
    for i, (low, high) in enumerate(boxes):  # a cube's islands are boxes: some side parts them
        for other_low, other_high in boxes[:i]:
            assert (np.maximum(low, other_low) >= np.minimum(high, other_high) - 1e-5).any()
    np.testing.assert_allclose(area(new), area(new)[0], rtol=0.01)
    np.testing.assert_array_equal(uv_of(obj.data, "UVMap"), before)
    assert [p.select for p in obj.data.polygons] == selected
    assert bpy.context.view_layer.objects.active == obj
    assert [o.name for o in bpy.data.objects] == [obj.name]
    assert len(bpy.data.meshes) == 1
    again = texture_object.prepare_object(bpy.context, obj, True, tmp_path / "mesh.obj")
    assert (again, len(obj.data.uv_layers)) == (name, 2)


def test_a_mesh_without_a_uv_gets_one(tmp_path):
    obj = add_cube()
    obj.data.uv_layers.remove(obj.data.uv_layers[0])
    name = texture_object.prepare_object(bpy.context, obj, False, tmp_path / "mesh.obj")
    assert name == texture_object.NEW_UV_MAP
    assert len(exported(tmp_path / "mesh.obj")[1]) == 24


def test_an_object_that_cannot_be_textured_has_a_reason(tmp_path):
    assert texture_object.reason_against(None) == "Select a mesh."
    empty = bpy.data.objects.new("Nothing", bpy.data.meshes.new("Nothing"))
    assert texture_object.reason_against(empty) == "“Nothing” has no faces."
    obj = add_cube()
    assert texture_object.reason_against(obj) == ""
    bpy.ops.object.mode_set(mode="EDIT")
    assert "Edit Mode" in texture_object.reason_against(obj)
    bpy.ops.object.mode_set(mode="OBJECT")
    obj.data.uv_layers[0].uv[0].vector = (3, 0)
    with pytest.raises(AddonError, match="outside the unit square"):
        texture_object.prepare_object(bpy.context, obj, False, tmp_path / "mesh.obj")
    obj.modifiers.new("Remesh", "REMESH")
    with pytest.raises(AddonError, match="leave no UV map “UVMap”"):
        texture_object.prepare_object(bpy.context, obj, False, tmp_path / "mesh.obj")


def cube_with_slots() -> bpy.types.Object:
    obj = add_cube()
    for name in ("wood", "iron"):
        obj.data.materials.append(bpy.data.materials.new(name))
    obj.data.polygons[3].material_index = 1
    return obj


def test_the_material_is_in_a_new_slot_and_the_others_stay(asset):
    obj = cube_with_slots()
    material = texture_object.assign_material(obj, asset, "UVMap", "slot")
    assert [slot.material.name for slot in obj.material_slots] == ["wood", "iron", material.name]
    assert [p.material_index for p in obj.data.polygons] == [0, 0, 0, 1, 0, 0]
    uv_nodes = [n for n in material.node_tree.nodes if n.bl_idname == "ShaderNodeUVMap"]
    assert [n.uv_map for n in uv_nodes] == ["UVMap"]


def test_the_whole_object_shows_it_and_its_mesh_keeps_its_own(asset):
    obj = cube_with_slots()
    copy = bpy.data.objects.new("copy", obj.data)
    material = texture_object.assign_material(obj, asset, "UVMap", "object")
    assert [slot.material for slot in obj.material_slots] == [material, material]
    assert [slot.material.name for slot in copy.material_slots] == ["wood", "iron"]
    obj.material_slots[0].link = "DATA"  # the way back
    assert obj.material_slots[0].material.name == "wood"


def test_a_mesh_without_slots_gets_the_first(asset):
    obj = add_cube()
    material = texture_object.assign_material(obj, asset, "UVMap", "slot")
    assert [slot.material for slot in obj.material_slots] == [material]


def test_a_removed_uv_map_is_an_error_and_nothing_is_left(asset):
    obj = add_cube()
    with pytest.raises(AddonError, match="no longer has the UV map “Fantasia3D”"):
        texture_object.assign_material(obj, asset, "Fantasia3D", "slot")
    (asset / "orm.png").unlink()
    with pytest.raises(AddonError, match="is missing"):
        texture_object.assign_material(obj, asset, "UVMap", "slot")
    assert (len(bpy.data.materials), len(bpy.data.images)) == (0, 0)


def colored(name: str, color: tuple[float, ...]) -> bpy.types.Material:
    material = bpy.data.materials.new(name)
    if not compat.ALWAYS_HAS_NODES:
        material.use_nodes = True
    material.node_tree.nodes["Principled BSDF"].inputs["Base Color"].default_value = color
    return material


def pixels(path: Path) -> np.ndarray:
    """(S, S, 3) of a PNG as in the file; row 0 is the bottom."""
    image = bpy.data.images.load(str(path))
    image.colorspace_settings.is_data = True
    values = np.array(image.pixels[:]).reshape(*image.size, -1)[..., :3]
    bpy.data.images.remove(image)
    return values


def srgb(linear: float) -> float:
    return 1.055 * linear ** (1 / 2.4) - 0.055


def test_the_present_colour_is_exact_and_the_object_is_left_alone(tmp_path):
    obj = add_cube()
    texture_object.add_uv_map(bpy.context, obj)
    for material in (colored("a", (0.8, 0.2, 0.05, 1)), colored("b", (0.1, 0.5, 0.9, 1))):
        obj.data.materials.append(material)
    obj.data.polygons[3].material_index = 1
    obj.modifiers.new("Subdivision", "SUBSURF").subdivision_type = "SIMPLE"
    counts = [len(getattr(bpy.data, k)) for k in ("objects", "meshes", "materials", "scenes")]
    bake_base_color.bake(bpy.context, obj, texture_object.NEW_UV_MAP, tmp_path / "c.png", 64)
    picture = pixels(tmp_path / "c.png")
    uv = uv_of(obj.data, texture_object.NEW_UV_MAP).reshape(-1, 4, 2).mean(1)
    for face, center in enumerate(uv):
        column, row = (center * 64).astype(int)
        expected = (0.1, 0.5, 0.9) if face == 3 else (0.8, 0.2, 0.05)
        np.testing.assert_allclose(picture[row, column], [srgb(x) for x in expected], atol=0.006)
    after = [len(getattr(bpy.data, k)) for k in ("objects", "meshes", "materials", "scenes")]
    assert after == counts
    assert [len(m.node_tree.nodes) for m in obj.data.materials] == [2, 2]


def test_a_mix_of_shaders_has_the_mix_of_their_colours(tmp_path):
    obj = add_cube()
    material = colored("mixed", (1, 0, 0, 1))
    tree = material.node_tree
    mix, diffuse = tree.nodes.new("ShaderNodeMixShader"), tree.nodes.new("ShaderNodeBsdfDiffuse")
    diffuse.inputs["Color"].default_value = (0, 1, 0, 1)
    mix.inputs[0].default_value = 0.25
    tree.links.new(tree.nodes["Principled BSDF"].outputs[0], mix.inputs[1])
    tree.links.new(diffuse.outputs[0], mix.inputs[2])
    tree.links.new(mix.outputs[0], tree.nodes["Material Output"].inputs["Surface"])
    obj.data.materials.append(material)
    bake_base_color.bake(bpy.context, obj, "UVMap", tmp_path / "c.png", 32)
    middle = pixels(tmp_path / "c.png")[16, 16]
    np.testing.assert_allclose(middle, (srgb(0.75), srgb(0.25), 0), atol=0.006)


def test_a_shader_with_an_unknown_colour_is_named(tmp_path):
    obj = add_cube()
    material = colored("odd", (1, 0, 0, 1))
    tree = material.node_tree
    holdout = tree.nodes.new("ShaderNodeHoldout")
    tree.links.new(holdout.outputs[0], tree.nodes["Material Output"].inputs["Surface"])
    obj.data.materials.append(material)
    with pytest.raises(AddonError, match="“odd” is unknown: it comes from “Holdout”"):
        bake_base_color.bake(bpy.context, obj, "UVMap", tmp_path / "c.png", 32)
    assert (len(bpy.data.materials), len(bpy.data.scenes)) == (1, 1)


def test_texture_goes_from_the_button_to_the_material(ready, wait):
    obj = cube_with_slots()
    obj.location = (1, 2, 3)
    ready.task, ready.use_present_color, ready.assign = "texture", True, "object"
    assert bpy.ops.fantasia3d.texture() == {"FINISHED"}
    run = session.running[0].run.folder
    job = session.running[0].job
    assert (job["command"], job["uv"]) == ("texture", "keep")
    assert job["mesh"] == str((run / "mesh.obj").resolve())
    assert Path(job["base_color"]).stat().st_size > 100
    bpy.ops.mesh.primitive_cube_add()  # the selection is another's by then
    wait()
    assert session.error is None
    assert session.asset == obj.name
    assert {slot.material.name for slot in obj.material_slots} == {"a red wooden chair"}
    assert len(bpy.data.objects) == 2


def test_a_removed_object_is_an_error(ready, wait):
    obj = add_cube()
    submit.texture(bpy.context)
    bpy.data.objects.remove(obj)
    wait()
    assert session.error[0] == "The object “Cube” no longer exists."


def test_a_textured_mesh_is_repeated_from_the_files_of_its_run(ready, wait):
    from fantasia3d_addon.jobs import history

    obj = add_cube()
    submit.texture(bpy.context)
    wait()
    entry = history.read_entry(session.last.run.folder)
    submit.repeat(bpy.context, entry, vary_seed=True)
    again = session.running[0]
    assert again.job["seed"] != entry.job["seed"]
    assert Path(again.job["mesh"]).parent == again.run.folder
    assert again.target.object == obj.name
    wait()
    assert len(obj.material_slots) == 2


def textured(wait, file: Path) -> tuple[bpy.types.Object, Path]:
    """A cube in ``file`` and the run of its material, which it has."""
    obj = add_cube()
    bpy.ops.wm.save_as_mainfile(filepath=str(file))
    run = submit.texture(bpy.context)
    wait()
    assert len(obj.material_slots) == 1
    return obj, run


def test_a_material_of_the_history_comes_onto_its_object(ready, wait, tmp_path):
    obj, run = textured(wait, tmp_path / "mine.blend")
    assert bpy.ops.fantasia3d.job_import(folder=str(run)) == {"FINISHED"}
    assert (len(obj.material_slots), len(bpy.data.objects)) == (2, 1)
    bpy.ops.wm.save_mainfile()
    session.close()  # and in a later Blender
    bpy.ops.wm.open_mainfile(filepath=bpy.data.filepath)
    assert bpy.ops.fantasia3d.job_import(folder=str(run)) == {"FINISHED"}
    assert (len(bpy.data.objects["Cube"].material_slots), len(bpy.data.objects)) == (3, 1)


@pytest.mark.parametrize("saved", [True, False])
def test_an_object_of_another_file_is_not_taken_for_the_jobs(ready, wait, tmp_path, saved):
    """Every new file has a “Cube” with a “UVMap”."""
    if saved:
        _, run = textured(wait, tmp_path / "mine.blend")
    else:
        add_cube()
        run = submit.texture(bpy.context)
        wait()
    bpy.ops.wm.read_factory_settings(use_empty=True)
    other = add_cube()
    assert bpy.ops.fantasia3d.job_import(folder=str(run)) == {"FINISHED"}
    assert len(other.material_slots) == 0
    assert len(bpy.data.objects) == 2
    assert bpy.context.active_object.name == "a red wooden chair"


def test_a_mesh_that_is_another_by_now_is_not_taken_for_the_jobs(ready, wait, tmp_path):
    obj, run = textured(wait, tmp_path / "mine.blend")
    obj.modifiers.new("Subdivision", "SUBSURF")
    bpy.context.view_layer.update()
    bpy.ops.fantasia3d.job_import(folder=str(run))
    assert (len(obj.material_slots), len(bpy.data.objects)) == (1, 2)


def test_a_job_for_an_object_ends_in_another_file(ready, wait, tmp_path):
    """Requested in one that was never saved, followed by a later Blender."""
    add_cube()
    ready.prompt = "brief"
    run = submit.texture(bpy.context)
    process = session.running[0].run._process
    session.close()
    bpy.ops.wm.read_factory_settings(use_empty=True)
    other = add_cube()
    session.adopt(bpy.context)
    assert [followed.run.folder for followed in session.running] == [run]
    wait()
    process.wait(60)
    assert (len(other.material_slots), len(bpy.data.objects)) == (0, 1)
    assert [entry.folder for entry in session.missed] == [run]


@pytest.mark.skipif(compat.ALWAYS_HAS_NODES, reason="no material is without nodes")
def test_nodes_that_are_switched_off_have_no_colour(tmp_path):
    obj, material = add_cube(), colored("plain", (0, 0, 1, 1))
    material.use_nodes, material.diffuse_color = False, (1, 0, 0, 1)
    obj.data.materials.append(material)
    bake_base_color.bake(bpy.context, obj, "UVMap", tmp_path / "c.png", 32)
    np.testing.assert_allclose(pixels(tmp_path / "c.png")[16, 16], (1, 0, 0), atol=0.006)
