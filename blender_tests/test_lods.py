"""Levels of detail and quads of what an object looks like, and of what can't be made simpler."""

import numpy as np
import pytest

bpy = pytest.importorskip("bpy")

from blender_tests.test_placement import add_box  # noqa: E402
from fantasia3d_addon.asset.import_asset import import_asset  # noqa: E402
from fantasia3d_addon.asset.texture_object import show_on_all_slots  # noqa: E402
from fantasia3d_addon.errors import AddonError  # noqa: E402
from fantasia3d_addon.mesh import remesh  # noqa: E402

pytestmark = [pytest.mark.blender, pytest.mark.usefixtures("empty")]


@pytest.mark.parametrize("options", [{"levels": 1}, {"max_faces": 900}])
def test_a_level_has_what_the_modifiers_make(asset, options):
    obj = import_asset(bpy.context, asset)
    obj.modifiers.new("two", "ARRAY")
    bpy.context.view_layer.update()
    (lod,) = remesh.make_lods(obj, **options)
    np.testing.assert_allclose(lod.dimensions, obj.dimensions, rtol=0.02)
    assert len(lod.data.polygons) <= options.get("max_faces", len(obj.data.polygons))
    assert len(obj.modifiers) == 1


def test_a_level_shows_the_material_that_the_object_shows(asset):
    obj, shown = import_asset(bpy.context, asset), bpy.data.materials.new("shown")
    show_on_all_slots(obj, shown)
    (lod,) = remesh.make_lods(obj, levels=1)
    assert lod.active_material == shown


def test_what_has_too_many_parts_for_the_budget_is_a_sentence_and_leaves_nothing():
    parts = [add_box((0.1, 0.1, 0.1), (i, 0, 0)) for i in range(60)]
    with bpy.context.temp_override(active_object=parts[0], selected_editable_objects=parts):
        bpy.ops.object.join()
    before = [len(kind) for kind in (bpy.data.objects, bpy.data.meshes, bpy.data.collections)]
    with pytest.raises(AddonError, match=r"50 faces can.t be made of box: \d+ are left"):
        remesh.make_lods(parts[0], max_faces=50)
    after = [len(kind) for kind in (bpy.data.objects, bpy.data.meshes, bpy.data.collections)]
    assert after == before


def test_quads_have_what_the_modifiers_make(asset):
    obj = import_asset(bpy.context, asset)
    obj.modifiers.new("two", "ARRAY").relative_offset_displace = (1.5, 0, 0)
    bpy.context.view_layer.update()
    quads = remesh.quad_remesh(obj, 600, 16)
    np.testing.assert_allclose(quads.dimensions, obj.dimensions, rtol=0.05)
