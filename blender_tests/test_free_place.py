"""Where a preview and an asset appear: next to existing objects, and in the view."""

import json

import numpy as np
import pytest

bpy = pytest.importorskip("bpy")

from mathutils import Vector  # noqa: E402

from blender_tests.asset_fixture import write_asset  # noqa: E402
from blender_tests.test_live_preview import write_shape  # noqa: E402
from fantasia3d_addon.blender.mesh_arrays import world_verts  # noqa: E402
from fantasia3d_addon.jobs import live_preview  # noqa: E402
from fantasia3d_addon.jobs.process import Run  # noqa: E402
from fantasia3d_addon.jobs.progress import FollowedRun  # noqa: E402
from fantasia3d_addon.jobs.session import session  # noqa: E402
from fantasia3d_addon.jobs.target import Target  # noqa: E402
from fantasia3d_addon.scene import view  # noqa: E402
from fantasia3d_addon.scene.free_place import free_place  # noqa: E402

pytestmark = [pytest.mark.blender]
UNIT = np.array([[-0.5, -0.5, 0.0], [0.5, 0.5, 1.0]])


@pytest.fixture
def default_scene(addon):
    """Blender's own: a cube of 2 m about the origin, a camera and a light."""
    bpy.ops.wm.read_factory_settings(use_empty=False)


def block(low, high, name="block", flip=False) -> bpy.types.Object:
    mesh = bpy.data.meshes.new(name)
    verts = [(x, y, z) for x in (low[0], high[0]) for y in (low[1], high[1])
             for z in (low[2], high[2])]  # fmt: skip
    faces = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    mesh.from_pydata(verts, [], [face[::-1] if flip else face for face in faces])
    obj = bpy.data.objects.new(name, mesh)
    bpy.context.scene.collection.objects.link(obj)
    return obj


def place(near=(0, 0, 0), bounds=UNIT) -> np.ndarray:
    return np.array(free_place(bpy.context.scene, bounds, near))


def boxes_overlap(a, b) -> bool:
    (al, ah), (bl, bh) = ((p.min(0), p.max(0)) for p in (world_verts(a), world_verts(b)))
    return bool((al < bh).all() and (bl < ah).all())


def test_a_free_cursor_is_the_place_to_the_last_bit(empty):
    assert tuple(place((0.1, 2.3, 4.5))) == (0.1, 2.3, 4.5)


def test_it_is_the_nearest_free_place(empty):
    """Against a search over a fine grid."""
    block((-1, -1, 0), (1, 1, 2))
    block((1.5, -3, 0), (4, 3, 1))
    near = np.array([0.6, 0.2, 0.0])
    found = place(near)
    grid = np.mgrid[-4:6:0.02, -5:5:0.02].reshape(2, -1).T
    taken = np.zeros(len(grid), bool)
    for low, high in (((-1, -1), (1, 1)), ((1.5, -3), (4, 3))):
        inside = (grid > np.array(low) - 0.55) & (grid < np.array(high) + 0.55)
        taken |= inside.all(1)
    nearest = np.linalg.norm(grid[~taken] - near[:2], axis=1).min()
    assert np.linalg.norm(found[:2] - near[:2]) == pytest.approx(nearest, abs=0.03)


def test_a_ground_of_no_height_is_not_in_the_way(empty):
    block((-9, -9, -1), (9, 9, 0)).scale.z = 0
    assert tuple(place()) == (0, 0, 0)


def test_what_is_above_or_below_is_not_in_the_way(empty):
    block((-1, -1, -0.5), (1, 1, 0.0), "a floor")
    block((-1, -1, 1.01), (1, 1, 2), "a shelf")
    assert tuple(place()) == (0, 0, 0)


def test_a_room_is_not_in_the_way_but_its_walls_and_its_table_are(empty):
    block((-4, -4, 0), (4, 4, 3), "a room", flip=True)
    assert tuple(place()) == (0, 0, 0)
    block((-0.5, -0.5, 0), (0.5, 0.5, 0.8), "a table")
    assert 0.9 < np.abs(place()).max() < 1.5
    assert np.abs(place((3.9, 0, 0)))[0] < 3.9 or np.abs(place((3.9, 0, 0)))[0] > 4.4


def test_a_large_solid_is_in_the_way(empty):
    block((-9, -9, 0), (9, 9, 9), "a rock")
    assert np.abs(place()).max() > 9


def test_the_surroundings_of_a_scene_that_is_not_shown_count(addon, asset):
    shown, other = bpy.context.scene, bpy.data.scenes.new("other")
    block((-4, -4, 0), (4, 4, 3), "a room", flip=True)
    other.collection.objects.link(bpy.data.objects["a room"])
    shown.collection.objects.unlink(bpy.data.objects["a room"])
    assert bpy.context.scene == shown
    x = np.abs(free_place(other, UNIT, (3.9, 0, 0)))[0]
    assert x < 3.9 or x > 4.4
    eye = Vector((0, 0, 1))
    assert free_place(other, UNIT, (1, 0, 0), eye=eye) == (1, 0, 0)
    from fantasia3d_addon.jobs.import_result import import_result

    name = import_result(asset, Target(), other, push_undo=False)
    assert name in other.objects


def test_a_mug_is_not_put_below_a_chair(empty, asset):
    block((-0.25, -0.25, 0), (0.25, 0.25, 0.9), "a chair")
    assert np.abs(place(bounds=0.1 * UNIT)).max() >= 0.3


def test_hidden_objects_are_not_in_the_way(empty):
    block((-1, -1, 0), (1, 1, 2)).hide_set(True)
    assert tuple(place()) == (0, 0, 0)


def test_two_assets_and_the_default_cube_never_intersect(default_scene, asset):
    bpy.ops.fantasia3d.import_asset(directory=str(asset))
    bpy.ops.fantasia3d.import_asset(directory=str(asset))
    meshes = [obj for obj in bpy.context.scene.objects if obj.type == "MESH"]
    assert len(meshes) == 3
    bpy.context.view_layer.update()
    for i, obj in enumerate(meshes):
        assert not any(boxes_overlap(obj, other) for other in meshes[:i])
        assert np.linalg.norm(obj.location) < 3.5


def test_the_user_may_place_it_exactly_at_the_cursor_or_in_the_view(default_scene, asset):
    settings = bpy.context.scene.fantasia3d
    settings.placement = "cursor"
    bpy.ops.fantasia3d.import_asset(directory=str(asset))
    assert tuple(bpy.context.object.location) == (0, 0, 0)
    settings.placement = "view"
    region_3d = next(view.areas(bpy.context.scene))[1].spaces.active.region_3d
    region_3d.view_location = (5, 6, 0)
    bpy.ops.fantasia3d.import_asset(directory=str(asset))
    assert tuple(bpy.context.object.location) == pytest.approx((5, 6, 0), abs=1e-4)


def test_the_place_is_on_the_side_that_the_view_shows(default_scene, asset):
    bpy.ops.fantasia3d.import_asset(directory=str(asset))
    bpy.context.view_layer.update()
    obj, eye = bpy.context.object, view.eye(bpy.context.scene)
    ray = obj.matrix_world @ Vector((0, 0, 0.5)) - eye
    graph = bpy.context.evaluated_depsgraph_get()
    assert bpy.context.scene.ray_cast(graph, eye, ray)[4] == obj
    assert np.linalg.norm(obj.location) < 2.5


def test_an_asset_that_is_imported_by_hand_is_shown_and_offered_its_colours(default_scene, asset):
    (region_3d,) = views()
    region_3d.view_distance = 100
    bpy.ops.fantasia3d.import_asset(directory=str(asset))
    assert region_3d.view_distance < 5
    assert session.asset == bpy.context.object.name


def followed(tmp_path, **target) -> FollowedRun:
    folder = tmp_path / "run"
    folder.mkdir(exist_ok=True)
    (folder / "job.json").write_text(json.dumps({"prompt": "a chair"}))
    return FollowedRun(Run.attach(folder), Target(**target), None, 0)


def test_the_preview_is_next_to_the_default_cube_and_stays_there(default_scene, tmp_path):
    path, run = tmp_path / "shape.npz", followed(tmp_path)
    write_shape(path)
    obj = live_preview.show(bpy.context.scene, path, run)
    bpy.context.view_layer.update()
    assert not boxes_overlap(obj, bpy.data.objects["Cube"])
    before = tuple(obj.location)
    write_shape(path, 0.3)
    assert tuple(live_preview.show(bpy.context.scene, path, run).location) == before


def test_the_asset_takes_the_place_of_its_preview(default_scene, asset, tmp_path):
    from fantasia3d_addon.jobs.import_result import import_result

    run = followed(tmp_path)
    write_shape(tmp_path / "shape.npz")
    live_preview.show(bpy.context.scene, tmp_path / "shape.npz", run)
    live_preview.remove()
    name = import_result(asset, run.target, bpy.context.scene, near=run.place)
    assert tuple(bpy.data.objects[name].location) == pytest.approx(run.place)


def views() -> list[bpy.types.RegionView3D]:
    return [area.spaces.active.region_3d for _, area in view.areas(bpy.context.scene)]


def test_half_the_view_is_that_of_blenders_own_matrix(default_scene):
    """The start-up file holds the matrix of its view, as Blender drew it."""
    ((_, area),) = view.areas(bpy.context.scene)
    rows = np.array(area.spaces.active.region_3d.perspective_matrix)[:2, :3]
    np.testing.assert_allclose(view._half_view(area), 1 / np.linalg.norm(rows, axis=1), rtol=1e-3)


def projected(region_3d, point) -> Vector:
    """In half widths and heights of the view; headless, Blender does not update its matrix."""
    ((_, area),) = view.areas(bpy.context.scene)
    back = region_3d.view_rotation @ Vector((0, 0, 1))
    eye = region_3d.view_location + region_3d.view_distance * back
    x, y, z = region_3d.view_rotation.inverted() @ (Vector(point) - eye)
    depth = -z if region_3d.view_perspective == "PERSP" else region_3d.view_distance
    width, height = view._half_view(area)
    return Vector((x / width / depth, y / height / depth))


@pytest.mark.parametrize("kind", ["PERSP", "ORTHO"])
@pytest.mark.parametrize("at", [(0.3, 0.1, 0.0), (30, 4, 0), (0, -60, 5)])
def test_the_view_shows_what_it_did_not_show(default_scene, kind, at):
    obj = block((-0.05, -0.05, 0), (0.05, 0.05, 0.1), "a mug")
    obj.location = at
    bpy.context.view_layer.update()
    (region_3d,) = views()
    region_3d.view_perspective = kind
    assert view.frame_if_unseen(bpy.context.scene, obj)
    low, high = (projected(region_3d, obj.matrix_world @ Vector(obj.bound_box[i])) for i in (0, 6))
    assert max(map(abs, (*low, *high))) < 1
    assert 0.1 < (high - low).length < 2
    assert not view.frame_if_unseen(bpy.context.scene, obj)


def test_a_view_that_shows_it_and_one_through_a_camera_stay(default_scene):
    (region_3d,) = views()
    before = tuple(region_3d.view_location), region_3d.view_distance
    assert not view.frame_if_unseen(bpy.context.scene, bpy.data.objects["Cube"])
    far = block((50, 0, 0), (51, 1, 1))
    bpy.context.view_layer.update()
    region_3d.view_perspective = "CAMERA"
    assert not view.frame_if_unseen(bpy.context.scene, far)
    assert (tuple(region_3d.view_location), region_3d.view_distance) == before


def test_a_preview_is_looked_at_alone_and_never_leaves_an_empty_view(default_scene, tmp_path):
    write_shape(tmp_path / "shape.npz")
    obj = live_preview.show(bpy.context.scene, tmp_path / "shape.npz", followed(tmp_path))
    cube = bpy.data.objects["Cube"]
    window, area = next(view.areas(bpy.context.scene))
    region = next(region for region in area.regions if region.type == "WINDOW")
    with bpy.context.temp_override(window=window, area=area, region=region):
        assert bpy.ops.fantasia3d.local_view() == {"FINISHED"}
        space = area.spaces.active
        assert space.local_view  # what is in it only a window knows (window_script.py)
        assert (obj.hide_select, cube.select_get(), obj.select_get()) == (True, True, False)
        bpy.ops.fantasia3d.local_view()
        assert not space.local_view
        bpy.ops.fantasia3d.local_view()
        live_preview.remove()
        assert not space.local_view


def test_an_asset_in_a_room_of_assets_still_finds_a_place(default_scene, tmp_path):
    folder = write_asset(tmp_path / "one")
    for _ in range(12):
        bpy.ops.fantasia3d.import_asset(directory=str(folder))
    meshes = [obj for obj in bpy.context.scene.objects if obj.type == "MESH"]
    bpy.context.view_layer.update()
    for i, obj in enumerate(meshes):
        assert not any(boxes_overlap(obj, other) for other in meshes[:i])
