"""An object of the scene as the file that the core starts from."""

import numpy as np
import pytest

bpy = pytest.importorskip("bpy")

from blender_tests.asset_fixture import block  # noqa: E402
from fantasia3d_addon.asset.export_shape import export_shape  # noqa: E402
from fantasia3d_addon.errors import AddonError, OutputError  # noqa: E402

pytestmark = [pytest.mark.blender, pytest.mark.usefixtures("empty")]


def add_block(quads: bool = False) -> bpy.types.Object:
    verts, faces, uv, face_uvs = block(2)
    mesh = bpy.data.meshes.new("block")
    mesh.from_pydata(verts.tolist(), [], faces.tolist())
    layer = mesh.uv_layers.new()
    layer.uv.foreach_set("vector", uv[face_uvs.ravel()].astype(np.float32).ravel())
    obj = bpy.data.objects.new("block", mesh)
    bpy.context.scene.collection.objects.link(obj)
    return obj


def export(obj, path):
    bpy.context.view_layer.update()
    export_shape(obj, path)


def read_back(path):
    """What Blender's own importer makes of the file: co in the world, corners, uv or None."""
    bpy.ops.wm.obj_import(filepath=str(path))
    obj = bpy.context.selected_objects[0]
    matrix = np.array(obj.matrix_world)
    co = np.array([v.co for v in obj.data.vertices]) @ matrix[:3, :3].T + matrix[:3, 3]
    corners = np.array([p.vertices[:] for p in obj.data.polygons])
    layer = obj.data.uv_layers.active
    return co, corners, np.array([d.vector for d in layer.uv]) if layer else None


def volume(co, faces):
    a, b, c = (co[faces[:, i]] for i in range(3))
    return np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6


def test_the_exported_shape_imports_in_place_with_its_uv(tmp_path):
    obj = add_block()
    obj.location, obj.rotation_euler, obj.scale = (1, 2, 3), (0.3, 0.2, 0.1), (1, 2, 0.5)
    export(obj, tmp_path / "shape.obj")
    co, corners, uv = read_back(tmp_path / "shape.obj")
    verts, faces, file_uv, face_uvs = block(2)
    matrix = np.array(obj.matrix_world)
    np.testing.assert_allclose(co, verts @ matrix[:3, :3].T + matrix[:3, 3], atol=1e-5)
    np.testing.assert_array_equal(corners, faces)
    np.testing.assert_allclose(uv, file_uv[face_uvs.ravel()], atol=1e-6)


def test_a_mirrored_object_keeps_its_faces_outward(tmp_path):
    obj = add_block()
    obj.scale = (-1, 1, 1)
    export(obj, tmp_path / "shape.obj")
    co, corners, _ = read_back(tmp_path / "shape.obj")
    assert volume(co, corners) == pytest.approx(volume(*block(2)[:2]), rel=1e-4)


def test_modifiers_are_applied_and_the_mesh_is_left_as_it_was(tmp_path):
    obj = add_block()
    before = len(obj.data.vertices)
    obj.modifiers.new("finer", "SUBSURF").levels = 2
    export(obj, tmp_path / "shape.obj")
    _, corners, _ = read_back(tmp_path / "shape.obj")
    assert corners.shape == (len(block(2)[1]) * 3 * 4 * 2, 3)  # three quads a triangle, then four
    assert len(obj.data.vertices) == before


@pytest.mark.parametrize("has_child", [False, True])
@pytest.mark.parametrize("hidden", ["object", "key", "collection", "excluded"])
def test_what_the_viewports_leave_out_is_exported_as_it_looks(tmp_path, hidden, has_child):
    """A view layer evaluates neither its modifiers nor where its parent has it."""
    obj, parent = add_block(), bpy.data.objects.new("parent", None)
    collection = bpy.data.collections.new("guides")
    bpy.context.scene.collection.children.link(collection)
    bpy.context.scene.collection.objects.unlink(obj)
    for each in (obj, parent):
        collection.objects.link(each)
    if hidden == "excluded":
        bpy.context.view_layer.layer_collection.children["guides"].exclude = True
    else:
        (collection if hidden == "collection" else obj).hide_viewport = True
    obj.parent, parent.location = parent, (5, 0, 0)
    obj.modifiers.new("finer", "SUBSURF").levels = 2
    if hidden == "key":
        obj.keyframe_insert("hide_viewport")
        obj.hide_viewport = False  # at this frame the key has another value
    if has_child:  # that is shown, and needs it
        child = bpy.data.objects.new("child", None)
        bpy.context.scene.collection.objects.link(child)
        child.parent = obj
    bpy.context.view_layer.update()
    before = len(bpy.data.objects), obj.hide_viewport, list(obj.users_collection)
    export(obj, tmp_path / "shape.obj")
    assert (len(bpy.data.objects), obj.hide_viewport, list(obj.users_collection)) == before
    co, corners, _ = read_back(tmp_path / "shape.obj")
    assert len(corners) == len(block(2)[1]) * 3 * 4 * 2
    assert co.mean(0)[0] == pytest.approx(5, abs=0.1)


def test_a_mesh_without_uv(tmp_path):
    obj = add_block()
    obj.data.uv_layers.remove(obj.data.uv_layers[0])
    export(obj, tmp_path / "shape.obj")
    assert read_back(tmp_path / "shape.obj")[2] is None


@pytest.mark.parametrize("data", ["none", "light", "mesh"])
def test_what_has_no_surface_is_refused(tmp_path, data):
    kinds = {
        "none": lambda: None,
        "light": lambda: bpy.data.lights.new("x", "POINT"),
        "mesh": lambda: bpy.data.meshes.new("x"),
    }
    obj = bpy.data.objects.new("x", kinds[data]())
    bpy.context.scene.collection.objects.link(obj)
    with pytest.raises(AddonError, match=r"“x” has no faces\. Choose"):
        export(obj, tmp_path / "shape.obj")


def test_a_place_that_cannot_be_written(tmp_path):
    with pytest.raises(OutputError, match="can't be written"):
        export(add_block(), tmp_path / "no" / "shape.obj")
