"""Simulations next to others: of the same asset, of other assets, of the user's own objects."""

import numpy as np
import pytest

bpy = pytest.importorskip("bpy")

from mathutils import Matrix  # noqa: E402

from blender_tests.test_placement import add_box  # noqa: E402
from fantasia3d_addon.asset.import_asset import import_asset  # noqa: E402
from fantasia3d_addon.asset.origin import DENSITY  # noqa: E402
from fantasia3d_addon.blender.mesh_arrays import acting, world_verts  # noqa: E402
from fantasia3d_addon.errors import AddonError  # noqa: E402
from fantasia3d_addon.mesh import asset_browser  # noqa: E402
from fantasia3d_addon.physics import bake, simulation  # noqa: E402
from fantasia3d_addon.physics.helpers import BODY, COLLIDER  # noqa: E402

pytestmark = [pytest.mark.blender, pytest.mark.usefixtures("empty")]
FRAMES = 14


@pytest.fixture
def obj(asset):
    made = import_asset(bpy.context, asset)
    bpy.context.view_layer.update()
    return made


def fall(obj, height: float, frames: int = FRAMES) -> None:
    settings = simulation.Options(frames=frames, height=height, convex=True)
    simulation.simulate(obj, "RIGID", settings)


def lowest(obj) -> float:
    return float(world_verts(obj)[:, 2].min())


def path(obj) -> np.ndarray:
    """The middle (frames, 3) of ``obj``."""
    places = []
    for frame in range(1, FRAMES + 1):
        bpy.context.scene.frame_set(frame)
        places.append(world_verts(obj).mean(0))
    return np.array(places)


def names() -> set[str]:
    return {o.name for o in bpy.data.objects}


def fallen(seconds: float) -> float:
    return 9.81 / 2 * seconds**2


def test_a_second_fall_of_it_is_not_the_first_again(obj):
    fall(obj, 0.3)
    fall(obj, 3.0)
    z = path(obj)[:, 2]
    assert z[0] - z[-1] == pytest.approx(fallen((FRAMES - 1) / 24), rel=0.1)


def test_another_asset_falls_too_and_keeps_its_fall_when_the_first_is_removed(obj, asset):
    """All rigid bodies of a scene have one cache, which knows each by its number."""
    fall(obj, 0.3)
    first = path(obj)
    other = import_asset(bpy.context, asset, (4, 0, 0))
    fall(other, 3.0)
    np.testing.assert_allclose(path(obj), first, atol=0.01)
    second = path(other)
    assert second[0, 2] - second[-1, 2] > 1
    simulation.clear(obj)
    np.testing.assert_allclose(path(other), second, atol=0.01)
    assert bake.cache_of(simulation.owner_of(other)).is_baked


def test_another_asset_keeps_its_fall_when_a_second_is_cancelled(obj, asset):
    fall(obj, 0.3)
    first = path(obj)
    other = import_asset(bpy.context, asset, (4, 0, 0))
    settings = simulation.Options(frames=FRAMES, convex=True)
    steps = simulation.steps(other, "RIGID", settings)
    for _ in range(5):
        next(steps)
    steps.close()
    assert bake.cache_of(simulation.owner_of(obj)).is_baked
    np.testing.assert_allclose(path(obj), first, atol=0.01)


def test_a_second_fall_bakes_what_falls_next_to_it_once(obj, asset):
    other, left = (import_asset(bpy.context, asset, (x, 0, 0)) for x in (4, 8))
    for each, height in ((obj, 0.3), (other, 3.0), (left, 0.3)):
        fall(each, height)
    delete(left)
    before, frames = path(other), []
    bpy.app.handlers.frame_change_pre.append(lambda scene, _: frames.append(scene.frame_current))
    fall(obj, 1.0)
    assert frames.count(FRAMES) == 1
    np.testing.assert_allclose(path(other), before, atol=0.01)
    frames.clear()
    fall(obj, 1.0, 3)  # alone, the bake is as long as was asked for
    assert frames.count(FRAMES) == 1
    simulation.clear(other)
    fall(obj, 1.0, 3)
    assert bake.cache_of(simulation.owner_of(obj)).frame_end == 3
    bpy.app.handlers.frame_change_pre.clear()


def test_what_falls_next_to_it_keeps_its_fall_when_the_second_is_refused(obj, asset):
    other = import_asset(bpy.context, asset, (4, 0, 0))
    fall(obj, 0.3)
    fall(other, 3.0)
    before, obj[DENSITY] = path(other), "heavy"
    with pytest.raises(AddonError, match="is not a number above 0"):
        fall(obj, 0.3)
    np.testing.assert_allclose(path(other), before, atol=0.01)


def test_what_stands_next_to_it_is_no_ground(obj):
    add_box((0.5, 0.5, 0.5), (1.2, 0, 0.25))
    fall(obj, 0.05)
    bpy.context.scene.frame_set(FRAMES)
    assert lowest(obj) == pytest.approx(0, abs=0.02)
    assert simulation.GROUND in names()


def test_the_ground_is_under_the_mesh_not_under_its_origin(obj):
    obj.data.transform(Matrix.Translation((20, 0, 0)))
    fall(obj, 0.05)
    bpy.context.scene.frame_set(FRAMES)
    assert lowest(obj) == pytest.approx(0, abs=0.02)


@pytest.mark.parametrize("kind", ["RIGID", "CLOTH"])
def test_a_child_of_the_users_falls_from_its_place_and_is_a_child_again(obj, kind):
    parent = bpy.data.objects.new("parent", None)
    bpy.context.scene.collection.objects.link(parent)
    parent.location, parent.rotation_euler, parent.scale = (5, 1, 0), (0.4, 0, 1), (2, 2, 2)
    obj.parent = parent
    bpy.context.view_layer.update()
    before, above = world_verts(obj), world_verts(obj)
    above[:, 2] += 0.7
    settings = simulation.Options(frames=3, height=0.7, convex=True)
    simulation.simulate(obj, kind, settings)
    np.testing.assert_allclose(world_verts(obj), above, atol=0.02)
    simulation.clear(obj)
    assert obj.parent == parent
    np.testing.assert_allclose(world_verts(obj), before, atol=1e-4)


def test_the_users_own_bodies_and_colliders_keep_their_settings(obj):
    floor, other = add_box((9, 9, 1), (0, 0, -0.5)), add_box((0.5, 0.5, 0.5), (1.2, 0, 0.25))
    for each, kind in ((floor, "PASSIVE"), (other, "ACTIVE")):
        with acting(each):
            bpy.ops.rigidbody.object_add(type=kind)
        each.rigid_body.collision_shape = "BOX"
    floor.modifiers.new("own", "COLLISION")
    floor.collision.thickness_outer = 0.2
    for kind in ("RIGID", "CLOTH"):
        simulation.simulate(obj, kind, simulation.Options(frames=3, convex=True))
        simulation.clear(obj)
    assert [each.rigid_body.collision_shape for each in (floor, other)] == ["BOX", "BOX"]
    assert floor.collision.thickness_outer == pytest.approx(0.2)


@pytest.mark.parametrize("kind", ["RIGID", "CLOTH"])
def test_a_floor_of_another_file_holds_it(asset, tmp_path, kind):
    floor = add_box((9, 9, 1), (0, 0, -0.2))
    # It is what another asset falls on there.
    simulation.simulate(import_asset(bpy.context, asset), kind, simulation.Options(frames=2))
    bpy.data.libraries.write(str(tmp_path / "set.blend"), {floor})
    bpy.ops.wm.read_factory_settings(use_empty=True)
    with bpy.data.libraries.load(str(tmp_path / "set.blend"), link=True) as (_, wanted):
        wanted.objects = ["box"]
    bpy.context.scene.collection.objects.link(wanted.objects[0])
    obj = import_asset(bpy.context, asset, (0, 0, 0.3))
    bpy.context.view_layer.update()
    before = names()
    settings = simulation.Options(frames=FRAMES, height=0.05, convex=True)
    simulation.simulate(obj, kind, settings)
    bpy.context.scene.frame_set(FRAMES)
    assert lowest(obj) > 0.25
    simulation.clear(obj)
    assert names() == before


def test_it_is_removed_though_its_collections_are_excluded(obj):
    floor = add_box((9, 9, 1), (0, 0, -0.5))
    scenery = bpy.data.collections.new("scenery")
    bpy.context.scene.collection.children.link(scenery)
    bpy.context.scene.collection.objects.unlink(floor)
    scenery.objects.link(floor)
    before = names()
    fall(obj, 0.3, 3)
    for name in (simulation.COLLECTION, "scenery"):
        bpy.context.view_layer.layer_collection.children[name].exclude = True
    simulation.clear(obj)
    assert names() == before
    assert floor.rigid_body is None


def delete(obj) -> None:
    bpy.ops.object.select_all(action="DESELECT")
    obj.select_set(True)
    bpy.ops.object.delete()


def test_what_a_deleted_asset_left_is_in_nobodys_way(obj, asset):
    floor = add_box((9, 9, 1), (0, 0, -0.5))
    fall(obj, 0.0)
    delete(obj)
    other = import_asset(bpy.context, asset)
    bpy.context.view_layer.update()
    fall(other, 0.1)
    assert len(names()) == 3  # the floor, the asset, its body
    bpy.context.scene.frame_set(FRAMES)
    assert lowest(other) < 0.05
    simulation.clear(other)
    assert names() == {floor.name, other.name}
    assert floor.rigid_body is None


def test_a_hidden_cage_does_not_outlive_its_asset(obj, asset):
    simulation.simulate(obj, "CLOTH", simulation.Options(frames=2))
    delete(obj)
    other = import_asset(bpy.context, asset)
    bpy.context.view_layer.update()
    fall(other, 0.1, 2)
    simulation.clear(other)
    assert names() == {other.name}


def test_a_sheet_outlives_the_asset_that_it_was_draped_over(obj, asset):
    simulation.simulate(obj, "DRAPE", simulation.Options(frames=3))
    sheet = simulation.owner_of(obj)
    delete(obj)
    other = import_asset(bpy.context, asset)
    bpy.context.view_layer.update()
    fall(other, 0.1, 2)
    simulation.clear(other)
    assert names() == {sheet.name, other.name}
    assert simulation.MARK not in sheet


def test_a_cloth_that_is_removed_leaves_the_users_own_bake(obj, monkeypatch):
    ball = add_box((0.5, 0.5, 0.5), (3, 3, 2))
    with acting(ball):
        bpy.ops.rigidbody.object_add(type="ACTIVE")
    bake._keep(bake.cache_of(ball))
    simulation.simulate(obj, "CLOTH", simulation.Options(frames=3))
    monkeypatch.setattr(bake, "_unbake", lambda _: pytest.fail("it was baked again"))
    simulation.clear(obj)
    assert bake.cache_of(ball).is_baked


def of_an_earlier_version(obj) -> None:
    """Make the marks of its simulation those of a file that was saved with names, not tokens."""
    now = obj[simulation.MARK].to_dict()
    obj[simulation.MARK] = {k: v for k, v in now.items() if k not in ("token", "name")}
    for made in bpy.data.objects:
        if made.get(simulation.MARK) == now["token"]:
            made[simulation.MARK] = obj.name
        if BODY in made:
            del made[BODY]
            made[COLLIDER] = True


def test_an_earlier_versions_floor_is_no_body_when_it_is_removed(obj):
    floor = add_box((9, 9, 1), (0, 0, -0.5))
    fall(obj, 0.1, 3)
    of_an_earlier_version(obj)
    simulation.clear(obj)
    assert floor.rigid_body is None
    assert names() == {floor.name, obj.name}


def test_an_earlier_versions_asset_may_have_another_name_by_now(obj, asset):
    fall(obj, 0.1, 3)
    of_an_earlier_version(obj)
    obj.name, body = "throne", obj.parent
    fall(import_asset(bpy.context, asset, (4, 0, 0)), 0.1, 3)
    assert obj.parent == body


@pytest.mark.parametrize("density", ["heavy", 0, -1.0])
def test_a_density_that_is_none_is_a_sentence(obj, density):
    obj[DENSITY] = density
    with pytest.raises(AddonError, match="is not a number above 0"):
        fall(obj, 0.0)
    assert names() == {obj.name}


def test_a_thumbnail_shows_a_fallen_asset(obj, monkeypatch):
    """In the thumbnail's own scene nothing has fallen."""
    monkeypatch.setattr(asset_browser, "SIZE", 32)
    monkeypatch.setattr(asset_browser, "SAMPLES", 1)
    fall(obj, 3.0)
    bpy.context.scene.frame_set(FRAMES)
    before = names()
    assert asset_browser.render_thumbnail(obj)[14:18, 14:18, 3].min() > 0.99
    assert names() == before
