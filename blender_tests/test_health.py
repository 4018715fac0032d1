"""The mesh's health, and the repairs, on meshes whose faults are known."""

import time

import numpy as np
import pytest

bpy = pytest.importorskip("bpy")

from blender_tests.asset_fixture import block, write_asset  # noqa: E402
from fantasia3d_addon.asset.import_asset import import_asset  # noqa: E402
from fantasia3d_addon.blender.mesh_arrays import (  # noqa: E402
    corner_uv,
    values,
    verts_of,
    world_verts,
)
from fantasia3d_addon.errors import AddonError  # noqa: E402
from fantasia3d_addon.mesh import health, new_shape  # noqa: E402

pytestmark = [pytest.mark.blender, pytest.mark.usefixtures("empty")]


def made(tmp_path, mesh=None):
    obj = import_asset(bpy.context, write_asset(tmp_path / "a", mesh))
    bpy.context.view_layer.update()
    return obj


def test_a_generated_asset_is_healthy_and_its_numbers_are_right(tmp_path):
    obj = made(tmp_path)
    verts, faces, uv, face_uvs = block()
    report = health.examine(obj)
    assert report.faults == ()
    assert (report.verts, report.faces, report.components) == (len(verts), len(faces), 1)
    assert report.closed and report.manifold
    a, b, c = (uv[face_uvs[:, i]] for i in range(3))
    cross = (b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]
    uv_area = np.abs(cross).sum() / 2
    assert report.uv_fill == pytest.approx(uv_area, abs=0.015)
    assert report.uv_overlap == 0
    p, q, r = (verts[faces[:, i]] for i in range(3))
    area = np.linalg.norm(np.cross(q - p, r - p), axis=1).sum() / 2
    assert report.texel_density == pytest.approx(np.sqrt(uv_area * 64 * 64 / area), rel=1e-3)
    assert [size[1:] for size in report.textures] == [(64, 64)] * 3
    assert health.repair(obj) == ()


def test_overlapping_uvs_are_found(tmp_path):
    verts, faces, uv, face_uvs = block()
    obj = made(tmp_path, (verts, faces, uv % (1 / 3, 1 / 2), face_uvs))
    report = health.examine(obj)
    assert report.uv_fill == pytest.approx(0.141, abs=0.01)  # one island's place of six
    assert report.uv_overlap > 0.6


def split_mesh():
    verts, faces, uv, face_uvs = block()
    return verts[faces.ravel()], np.arange(faces.size).reshape(-1, 3), uv, face_uvs


def test_welding_closes_the_seams_and_keeps_the_uvs(tmp_path):
    obj = made(tmp_path, split_mesh())
    report = health.examine(obj)
    assert report.doubled == report.verts - len(block()[0])
    assert report.faults[0] == "WELD"
    before = corner_uv(obj.data)
    assert health.repair(obj, "WELD") == ("WELD",)
    after = health.examine(obj)
    assert (after.closed, after.doubled, after.verts) == (True, 0, len(block()[0]))
    np.testing.assert_array_equal(np.sort(corner_uv(obj.data), 0), np.sort(before, 0))


def holed():
    verts, faces, uv, face_uvs = block()
    return verts, faces[3:], uv, face_uvs[3:]


def test_holes_are_filled_and_the_new_corners_have_uvs_in_the_atlas(tmp_path):
    obj = made(tmp_path, holed())
    assert health.examine(obj).open_edges > 0
    assert health.repair(obj) == ("HOLES",)
    report = health.examine(obj)
    assert report.closed and report.manifold and not report.inverted
    uv = corner_uv(obj.data)
    assert ((uv > 0) & (uv < 1)).all()


def test_inverted_faces_are_turned(tmp_path):
    verts, faces, uv, face_uvs = block()
    obj = made(tmp_path, (verts, faces[:, ::-1], uv, face_uvs[:, ::-1]))
    assert health.examine(obj).inverted
    assert health.repair(obj) == ("NORMALS",)
    assert not health.examine(obj).inverted


def test_small_components_loose_vertices_and_a_scale_are_repaired_together(tmp_path):
    verts, faces, uv, face_uvs = block(12)
    speck = np.array([[2, 0, 0], [2.1, 0, 0], [2, 0.1, 0], [2, 0, 0.1]])
    sides = np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
    mesh = (
        np.concatenate([verts, speck, [[5, 5, 5]]]), np.concatenate([faces, sides + len(verts)]),
        uv, np.concatenate([face_uvs, face_uvs[:4]]),
    )  # fmt: skip
    obj = made(tmp_path, mesh)
    obj.scale = (2, 2, 2)
    report = health.examine(obj)
    assert (report.components, report.small_components, report.loose) == (2, 1, 1)
    assert health.repair(obj) == ("LOOSE", "SPECKS", "SCALE")
    report = health.examine(obj)
    assert (report.faults, report.components, report.faces) == ((), 1, len(faces))
    assert max(obj.dimensions) == pytest.approx(2, abs=1e-3)


def test_two_solids_that_touch_in_a_vertex_are_parted():
    verts = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (-1, 0, 0), (0, -1, 0), (0, 0, -1)]
    faces = [(0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3), (0, 4, 5), (0, 6, 4), (0, 5, 6), (4, 6, 5)]
    mesh = bpy.data.meshes.new("x")
    mesh.from_pydata(verts, [], faces)
    obj = bpy.data.objects.new("x", mesh)
    bpy.context.scene.collection.objects.link(obj)
    bpy.context.view_layer.update()
    assert health.examine(obj).nonmanifold == 1
    assert health.repair(obj) == ("NONMANIFOLD", "UV")
    report = health.examine(obj)
    assert (report.nonmanifold, report.verts, report.doubled) == (0, 8, 0)
    assert report.uv_fill > 0.1


def test_an_impossible_repair_is_an_error(tmp_path):
    obj = made(tmp_path)
    with pytest.raises(AddonError, match="There is no repair 'HEART'"):
        health.repair(obj, "HEART")
    obj.shape_key_add(name="Basis")
    with pytest.raises(AddonError, match="has shape keys"):
        health.repair(obj)


def test_the_scale_of_a_shared_mesh_is_left_and_that_is_reported(addon, tmp_path, capfd):
    obj = made(tmp_path, holed())
    obj.scale = (2, 2, 2)
    obj.data.use_fake_user = True  # which is no other object
    copy = bpy.data.objects.new("copy", obj.data)
    with pytest.raises(AddonError, match=r"share the mesh.*Make Single User"):
        health.repair(obj, "SCALE")
    assert health.repair(obj) == ("HOLES",)
    assert tuple(obj.scale) == (2, 2, 2)
    bpy.context.view_layer.objects.active = obj
    assert bpy.ops.fantasia3d.repair_mesh() == {"FINISHED"}
    assert "The scale is not applied" in capfd.readouterr().out
    bpy.data.objects.remove(copy)
    assert bpy.ops.fantasia3d.repair_mesh() == {"FINISHED"}
    assert "not applied" not in capfd.readouterr().out
    assert tuple(obj.scale) == (1, 1, 1)


def test_the_operators_are_the_functions_and_the_panel_knows_when_a_report_is_old(addon, tmp_path):
    obj = made(tmp_path, holed())
    bpy.context.view_layer.objects.active = obj
    assert health.cached_report(obj) is None
    assert bpy.ops.fantasia3d.check_mesh() == {"FINISHED"}
    assert health.cached_report(obj) == health.examine(obj)
    assert bpy.ops.fantasia3d.repair_mesh(what="HOLES") == {"FINISHED"}
    assert health.cached_report(obj).closed
    obj.data.vertices.add(1)
    assert health.cached_report(obj) is None


def test_a_mirrored_object_is_not_left_inside_out(tmp_path):
    obj = made(tmp_path)
    obj.scale = (-1, 2, 1)
    assert health.repair(obj) == ("SCALE",)
    assert health.examine(obj).faults == ()


def test_hidden_faces_get_uvs_too_and_stay_hidden(tmp_path):
    obj = made(tmp_path)
    obj.data.uv_layers.remove(obj.data.uv_layers[0])
    hidden = np.arange(len(obj.data.polygons)) % 2 == 0
    obj.data.polygons.foreach_set("hide", hidden)
    health.repair(obj, "UV")
    report = health.examine(obj)
    assert report.uv_fill > 0.3
    assert report.uv_overlap == 0
    assert np.array_equal(values(obj.data.polygons, "hide", 1, bool).ravel(), hidden)


def test_a_large_hole_does_not_take_minutes():
    """5 s when the filled faces were gathered again for each corner, 75 s for 3000 edges."""
    bpy.ops.mesh.primitive_cylinder_add(vertices=1200, end_fill_type="NOTHING", calc_uvs=True)
    start = time.process_time()
    health.repair(bpy.context.object, "HOLES")
    assert health.examine(bpy.context.object).closed
    assert time.process_time() - start < 2.5


def test_an_applied_scale_is_of_the_kept_shape_too(tmp_path):
    obj = made(tmp_path)
    obj.data.attributes.new(new_shape.OLD, "FLOAT_VECTOR", "POINT")
    obj.data.attributes[new_shape.OLD].data.foreach_set("vector", verts_of(obj.data).ravel())
    obj.scale = (2, 2, 2)
    bpy.context.view_layer.update()
    before = world_verts(obj)
    health.repair(obj, "SCALE")
    new_shape.restore_shape(obj)
    bpy.context.view_layer.update()
    np.testing.assert_allclose(world_verts(obj), before, atol=1e-5)
