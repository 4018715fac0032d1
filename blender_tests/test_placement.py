"""Dropping, the origin, the Cornell box."""

import itertools
import math

import numpy as np
import pytest

bpy = pytest.importorskip("bpy")

from mathutils import Matrix  # noqa: E402

from blender_tests.pictures import add_ball, linear, read  # noqa: E402
from fantasia3d_addon.asset.import_asset import import_asset  # noqa: E402
from fantasia3d_addon.blender.mesh_arrays import verts_of, world_verts  # noqa: E402
from fantasia3d_addon.errors import AddonError  # noqa: E402
from fantasia3d_addon.mesh import new_shape  # noqa: E402
from fantasia3d_addon.scene import cornell_box, placement, render  # noqa: E402
from fantasia3d_addon.ui.operator_helpers import reason_against_tool  # noqa: E402

pytestmark = [pytest.mark.blender, pytest.mark.usefixtures("empty")]


def add_box(size, at):
    """A box of ``size`` (x, y, z) whose middle is ``at``."""
    mesh = bpy.data.meshes.new("box")
    corners = [
        (x * size[0] / 2, y * size[1] / 2, z * size[2] / 2)
        for z in (-1, 1) for y in (-1, 1) for x in (-1, 1)
    ]  # fmt: skip
    faces = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    mesh.from_pydata(corners, [], faces)
    obj = bpy.data.objects.new("box", mesh)
    obj.location = at
    bpy.context.scene.collection.objects.link(obj)
    bpy.context.view_layer.update()
    return obj


def test_it_falls_onto_what_is_below_it(asset):
    table = add_box((2, 2, 0.4), (0, 0, 1.0))
    add_box((1, 1, 1), (10, 0, 0))  # elsewhere
    obj = import_asset(bpy.context, asset, (0.3, 0, 5))
    assert placement.drop(obj) == pytest.approx(5 - 1.2, abs=1e-4)
    assert world_verts(obj)[:, 2].min() == pytest.approx(1.2, abs=1e-4)
    assert placement.drop(obj) == pytest.approx(0, abs=1e-4)  # it is there already
    assert tuple(table.location) == (0, 0, 1)


def test_what_its_modifiers_hide_does_not_hold_it(asset):
    for height in (1.0, 5.0):
        box = add_box((2, 2, 0.4), (0, 0, height))
        box.vertex_groups.new(name="none")
        box.modifiers.new("mask", "MASK").vertex_group = "none"
    obj = import_asset(bpy.context, asset, (0, 0, 3))
    assert placement.drop(obj) == pytest.approx(3, abs=1e-4)
    with pytest.raises(AddonError, match="leave no vertices"):
        placement.drop(box)


def test_a_ball_on_a_ball_touches_in_one_point():
    """Radius 0.5 each, 0.3 to the side: the centres end 1 apart."""
    add_ball((0, 0, 0))
    upper = add_ball((0.3, 0, 4))
    bpy.context.view_layer.update()
    placement.drop(upper)
    assert upper.location.z == pytest.approx(math.sqrt(1 - 0.09), abs=0.01)


def test_a_spike_below_stops_it_though_no_vertex_of_its_own_is_above():
    spike = add_box((0.02, 0.02, 2), (0.05, 0.03, 0))
    plate = add_box((2, 2, 0.1), (0, 0, 5))
    placement.drop(plate)
    assert world_verts(plate)[:, 2].min() == pytest.approx(world_verts(spike)[:, 2].max(), abs=1e-4)


@pytest.mark.parametrize("height", [3.0, -2.0])
def test_over_nothing_it_falls_to_the_ground(asset, height):
    obj = import_asset(bpy.context, asset, (0, 0, height))
    assert placement.drop(obj) == pytest.approx(height, abs=1e-5)
    with pytest.raises(AddonError, match="Nothing is below"):
        placement.drop(obj, ground=False)


def test_the_origin_goes_to_the_base_and_nothing_moves(asset):
    obj = import_asset(bpy.context, asset)
    obj.location, obj.rotation_euler, obj.scale = (1, 2, 3), (0.3, 0.4, 0.5), (1, 2, 1)
    child = bpy.data.objects.new("child", None)
    bpy.context.scene.collection.objects.link(child)
    child.parent = obj
    bpy.context.view_layer.update()
    before, place = world_verts(obj), child.matrix_world.copy()
    placement.origin_to_base(obj)
    np.testing.assert_allclose(world_verts(obj), before, atol=1e-5)
    np.testing.assert_allclose(np.array(child.matrix_world), np.array(place), atol=1e-5)
    origin, low, high = np.array(obj.matrix_world.translation), before.min(0), before.max(0)
    np.testing.assert_allclose(origin, [*(low + high)[:2] / 2, low[2]], atol=1e-5)


def test_what_is_scaled_to_nothing_has_its_origin_moved_too(asset):
    obj = import_asset(bpy.context, asset)
    obj.location, obj.scale = (1, 2, 3), (1, 1, 0)
    bpy.context.view_layer.update()
    before = world_verts(obj)
    placement.origin_to_base(obj)
    np.testing.assert_allclose(world_verts(obj), before, atol=1e-5)


def test_a_shared_mesh_is_left_alone(asset):
    obj = import_asset(bpy.context, asset)
    bpy.data.objects.new("copy", obj.data)
    with pytest.raises(AddonError, match="shares its mesh"):
        placement.origin_to_base(obj)


def state(target) -> dict[str, object]:
    kinds = ("objects", "meshes", "materials", "worlds", "lights", "cameras", "collections")
    found: dict[str, object] = {kind: sorted(getattr(bpy.data, kind).keys()) for kind in kinds}
    places = {o.name: tuple(o.matrix_world.translation) for o in bpy.data.objects}
    return found | {"world": target.world, "camera": target.camera, "places": places}


def test_the_box_holds_the_assets_apart_and_goes_without_a_trace(asset):
    target = bpy.context.scene
    target.world = bpy.data.worlds.new("mine")
    objs = [import_asset(target, asset, (x, 1, 2)) for x in (0, 0.1, 5)]
    bpy.context.view_layer.update()
    before = state(target)
    cornell_box.build(target, objs)
    boxes = [(world_verts(o).min(0), world_verts(o).max(0)) for o in objs]
    room = max(world_verts(o)[:, 2].max() for o in target.objects if "ceiling" in o.name)
    for low, high in boxes:
        assert low[2] == pytest.approx(0, abs=1e-5)
        assert high[2] < room
        assert np.abs([low[:2], high[:2]]).max() < room / 2
    for (_, left), (right, _) in itertools.pairwise(boxes):
        assert left[0] < right[0]
    assert target.camera.name.startswith("Cornell")
    with pytest.raises(AddonError, match="has a Cornell box"):
        cornell_box.build(target, objs)
    cornell_box.remove(target)
    assert state(target) == before


def test_the_floor_is_as_bright_as_the_light_makes_it(tmp_path):
    """Direct light alone. A small light of radiance L and area A, h above a matt floor of
    reflectance rho, makes the point below it rho L A / (pi h²) bright: here within the few percent
    by which the light is not small.
    """
    target = bpy.context.scene
    speck = add_box((0.001, 0.001, 0.001), (0, 0, 0.0005))
    cornell_box.build(target, [speck], height=1.0)
    speck.hide_render = True
    render.set_up_cycles(target, 64, 64)
    target.cycles.max_bounces, target.cycles.use_denoising = 0, False
    target.camera.location, target.camera.rotation_euler = (0, 0, 0.9), (0, 0, 0)
    target.camera.data.angle = 0.2
    target.render.filepath = str(tmp_path / "x.png")
    target.view_settings.exposure = 1.0
    bpy.ops.render.render(write_still=True)
    seen = linear(read(tmp_path / "x.png")[28:36, 28:36].reshape(-1, 3).mean(0)) / 2
    area = cornell_box.LIGHT[0] * cornell_box.LIGHT[1]
    expected = np.array(cornell_box.COLORS["white"]) * cornell_box.EMISSION * area / math.pi
    np.testing.assert_allclose(seen, expected / 0.998**2, rtol=0.05)


def test_the_walls_are_red_and_green_and_the_pane_glows(asset, tmp_path):
    target = bpy.context.scene
    cornell_box.build(target, [import_asset(target, asset)])
    render.set_up_cycles(target, 48, 16)
    target.cycles.use_denoising = False
    target.render.filepath = str(tmp_path / "x.png")
    bpy.ops.render.render(write_still=True)
    picture = read(tmp_path / "x.png")
    left, right = (linear(picture[20:28, side].mean((0, 1))) for side in (np.s_[1:4], np.s_[-4:-1]))
    assert left[0] > 4 * left[1]
    assert right[1] > 1.8 * right[0]  # the light itself is 1.4 times as red as green
    assert picture[:12, 20:28].max() > 0.95


def test_what_is_linked_from_another_file_is_refused_with_what_to_do(addon, asset, tmp_path):
    obj = import_asset(bpy.context, asset, (0, 0, 3))
    name, path = obj.name, str(tmp_path / "library.blend")
    bpy.ops.wm.save_as_mainfile(filepath=path, copy=True)
    bpy.data.objects.remove(obj)
    with bpy.data.libraries.load(path, link=True) as (_, into):
        into.objects = [name]
    obj = into.objects[0]
    bpy.context.scene.collection.objects.link(obj)
    bpy.context.view_layer.objects.active = obj
    own = bpy.data.objects.new("own", obj.data)  # its mesh is linked alone
    bpy.context.scene.collection.objects.link(own)
    tools = bpy.ops.fantasia3d
    changing = (tools.drop, tools.origin_to_base, tools.replace_material, tools.adjust_material,
                tools.mark_asset, tools.repair_mesh, tools.simulate)  # fmt: skip
    for active in (obj, own):
        bpy.context.view_layer.objects.active = active
        assert "Make Local" in reason_against_tool(bpy.context)
        for tool in changing:
            with pytest.raises(RuntimeError, match="Make it local first"):
                tool()
        assert tools.check_mesh() == {"FINISHED"}
        assert tools.export(filepath=str(tmp_path / f"{active.name}.glb")) == {"FINISHED"}
    own.data = own.data.copy()  # now its material alone is linked
    with pytest.raises(RuntimeError, match="Its material is linked"):
        tools.adjust_material()
    assert tools.drop() == {"FINISHED"}


def test_the_operators_are_the_functions(addon, asset):
    target = bpy.context.scene
    obj = import_asset(target, asset, (0, 0, 3))
    obj.select_set(True)
    bpy.context.view_layer.objects.active = obj
    assert bpy.ops.fantasia3d.drop() == {"FINISHED"}
    assert obj.location.z == pytest.approx(0, abs=1e-5)
    before = state(target)
    assert bpy.ops.fantasia3d.cornell_box() == {"FINISHED"}
    assert cornell_box.box_of(target) is not None
    assert not bpy.ops.fantasia3d.cornell_box.poll()
    assert bpy.ops.fantasia3d.remove_cornell_box() == {"FINISHED"}
    assert state(target) == before
    obj.data.transform(obj.matrix_world.Translation((0, 0, 1)))
    assert bpy.ops.fantasia3d.origin_to_base() == {"FINISHED"}
    assert obj.location.z == pytest.approx(1, abs=1e-5)


def test_the_origin_moves_in_a_mesh_of_a_fake_user_and_the_kept_shape_with_it(asset):
    obj = import_asset(bpy.context, asset, (1, 2, 3))
    obj.data.use_fake_user = True
    obj.data.transform(Matrix.Translation((0, 0, 0.5)))
    obj.data.attributes.new(new_shape.OLD, "FLOAT_VECTOR", "POINT")
    obj.data.attributes[new_shape.OLD].data.foreach_set("vector", verts_of(obj.data).ravel())
    bpy.context.view_layer.update()
    before = world_verts(obj)
    placement.origin_to_base(obj)
    new_shape.restore_shape(obj)
    bpy.context.view_layer.update()
    np.testing.assert_allclose(world_verts(obj), before, atol=1e-5)


def test_a_child_stands_in_the_box_too_and_goes_back(asset):
    child, parent = (import_asset(bpy.context, asset, (x, 1, 2)) for x in (0, 5))
    child.parent = parent
    bpy.context.view_layer.update()
    before = [world_verts(o) for o in (child, parent)]
    cornell_box.build(bpy.context.scene, [child, parent])
    assert world_verts(child)[:, 0].max() < world_verts(parent)[:, 0].min()
    assert world_verts(child)[:, 2].min() == pytest.approx(0, abs=1e-5)
    cornell_box.remove(bpy.context.scene)
    bpy.context.view_layer.update()
    np.testing.assert_allclose([world_verts(o) for o in (child, parent)], before, atol=1e-5)


def test_the_box_of_another_scene_keeps_its_colours(asset):
    first, second = bpy.context.scene, bpy.data.scenes.new("second")
    for target in (first, second):
        cornell_box.build(target, [import_asset(target, asset)])
    cornell_box.remove(first)
    walls = [o for o in cornell_box.box_of(second).objects if o.type == "MESH"]
    assert all(o.data.materials[0] for o in walls)
    cornell_box.remove(second)
    assert not [m for m in bpy.data.materials if m.name.startswith(cornell_box.NAME)]
