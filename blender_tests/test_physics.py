"""Rigid and soft bodies, cloth and a draped sheet: they move, stay whole, and go again."""

import numpy as np
import pytest

bpy = pytest.importorskip("bpy")

from blender_tests.asset_fixture import block, write_asset  # noqa: E402
from fantasia3d_addon.asset.import_asset import import_asset  # noqa: E402
from fantasia3d_addon.blender.mesh_arrays import values, world_verts  # noqa: E402
from fantasia3d_addon.errors import AddonError  # noqa: E402
from fantasia3d_addon.mesh import proxy  # noqa: E402
from fantasia3d_addon.physics import bake, simulation  # noqa: E402

pytestmark = [pytest.mark.blender, pytest.mark.usefixtures("empty")]
FRAMES = 14


@pytest.fixture
def obj(asset):
    made = import_asset(bpy.context, asset)
    bpy.context.view_layer.update()
    return made


def motion(obj) -> np.ndarray:
    """The vertices (frames, V, 3) of ``obj`` at the first, the middle and the last frame."""
    frames = []
    for frame in (1, FRAMES // 2, FRAMES):
        bpy.context.scene.frame_set(frame)
        frames.append(world_verts(obj))
    return np.stack(frames)


def edge_lengths(obj, points) -> np.ndarray:
    ends = values(obj.data.edges, "vertices", 2, np.int32)
    return np.linalg.norm(points[ends[:, 0]] - points[ends[:, 1]], axis=1)


def everything() -> dict[str, list[str]]:
    kinds = ("objects", "meshes", "materials")
    return {kind: sorted(getattr(bpy.data, kind).keys()) for kind in kinds}


@pytest.mark.parametrize("kind", ["RIGID", "SOFT", "CLOTH"])
def test_it_falls_stays_whole_and_goes_without_a_trace(obj, kind):
    before, start = everything(), world_verts(obj)
    simulation.simulate(obj, kind, simulation.Options(frames=FRAMES, height=0.3))
    owner = simulation.owner_of(obj)
    assert bake.cache_of(owner).is_baked
    path = motion(obj)
    assert np.isfinite(path).all()
    np.testing.assert_allclose(path[0], start + np.array([0, 0, 0.3]), atol=0.01)
    assert path[1].mean(0)[2] < path[0].mean(0)[2] - 0.02
    assert path[2][:, 2].min() > -0.06  # the ground holds it
    assert len(path[2]) == len(start)  # no vertex was doubled, so that no seam can open
    stretch = edge_lengths(obj, path[2]) / edge_lengths(obj, path[0])
    assert stretch.max() < (1.001 if kind == "RIGID" else 8)
    if kind != "RIGID":
        assert np.abs(stretch - 1).max() > 0.01  # it is no rigid body
    simulation.clear(obj)
    assert everything() == before
    np.testing.assert_allclose(world_verts(obj), start, atol=1e-5)


def test_free_fall_is_half_g_t_squared(obj):
    simulation.simulate(obj, "RIGID", simulation.Options(frames=10, height=2.0, convex=True))
    scene = bpy.context.scene
    height = []
    for frame in (1, 10):
        scene.frame_set(frame)
        height.append(world_verts(obj).mean(0)[2])
    seconds = 9 / scene.render.fps
    assert height[0] - height[1] == pytest.approx(9.81 / 2 * seconds**2, rel=0.08)


def test_a_sheet_falls_over_it_and_it_stays(obj):
    start = world_verts(obj)
    simulation.simulate(obj, "DRAPE", simulation.Options(frames=FRAMES))
    path = motion(obj)
    np.testing.assert_allclose(path, np.stack([start] * 3), atol=1e-6)
    sheet = simulation.owner_of(obj)
    bpy.context.scene.frame_set(FRAMES)
    points = world_verts(sheet)
    assert np.isfinite(points).all()
    top = start[:, 2].max()
    middle = np.linalg.norm(points[:, :2] - start[:, :2].mean(0), axis=1) < 0.1
    assert points[middle, 2].min() > top - 0.05  # it rests on the top
    assert points[:, 2].min() < top - 0.1  # its border hangs down
    simulation.clear(obj)
    assert [o.name for o in bpy.data.objects] == [obj.name]


def test_a_sheet_falls_from_the_height_that_is_asked_for(obj):
    simulation.simulate(obj, "DRAPE", simulation.Options(frames=2, height=2.0))
    bpy.context.scene.frame_set(1)
    low, top = (world_verts(each)[:, 2] for each in (simulation.owner_of(obj), obj))
    assert low.min() - top.max() == pytest.approx(2.0, abs=1e-3)


def test_a_sheet_does_not_fall_through_a_small_asset(asset):
    scene, obj = bpy.context.scene, import_asset(bpy.context, asset)
    obj.scale *= 0.2 / max(obj.dimensions)
    bpy.context.view_layer.update()
    middle = np.mean(world_verts(obj)[:, 2])
    scene.render.fps, scene.render.fps_base = 48, 2.0  # also where that is no whole number
    settings = simulation.Options(frames=15)
    assert not simulation.note_of(obj, "DRAPE", settings)
    simulation.simulate(obj, "DRAPE", settings)
    scene.frame_set(15)
    assert world_verts(simulation.owner_of(obj))[:, 2].max() > middle
    assert world_verts(simulation.owner_of(obj))[:, 2].min() < middle  # it has fallen


def test_a_sheet_starts_no_higher_than_it_can_be_stopped(obj):
    obj.scale *= 0.02 / max(obj.dimensions)
    bpy.context.view_layer.update()
    settings = simulation.Options(frames=2)
    note = simulation.note_of(obj, "DRAPE", settings)
    assert note.startswith("The sheet starts 0.120 m above it")
    assert not simulation.note_of(obj, "SOFT", settings)
    simulation.simulate(obj, "DRAPE", settings)
    bpy.context.scene.frame_set(1)
    low, top = (world_verts(each)[:, 2] for each in (simulation.owner_of(obj), obj))
    assert low.min() - top.max() == pytest.approx(0.12, abs=1e-3)


def test_it_falls_on_the_users_own_floor_and_the_floor_is_free_afterwards(obj):
    bpy.ops.mesh.primitive_plane_add(size=6, location=(0, 0, -0.2))
    floor = bpy.context.object
    simulation.simulate(obj, "SOFT", simulation.Options(frames=FRAMES, height=0.0))
    assert simulation.GROUND not in bpy.data.objects
    assert any(m.type == "COLLISION" for m in floor.modifiers)
    simulation.clear(obj)
    assert not floor.modifiers


def copied(obj) -> bpy.types.Object:
    copy = obj.copy()
    bpy.context.scene.collection.objects.link(copy)
    return copy


@pytest.mark.parametrize("kind", ["RIGID", "SOFT", "DRAPE"])
def test_a_renamed_object_is_freed_and_takes_no_other_with_it(obj, kind):
    start, first = world_verts(obj), obj.name
    simulation.simulate(obj, kind, simulation.Options(frames=3, height=0.3))
    obj.name = "renamed"
    second = copied(obj)
    simulation.clear(second)
    second.name, second.location = first, (5, 0, 0)
    simulation.simulate(second, kind, simulation.Options(frames=3, height=0.3))
    simulation.clear(second)
    assert simulation.owner_of(obj) is not None
    simulation.clear(obj)
    assert sorted(o.name for o in bpy.data.objects) == sorted([first, "renamed"])
    assert (obj.parent, len(obj.modifiers)) == (None, 0)
    np.testing.assert_allclose(world_verts(obj), start, atol=1e-5)


@pytest.mark.parametrize("kind", ["RIGID", "CLOTH", "DRAPE"])
def test_a_copy_is_freed_where_it_is_and_the_original_stays_simulated(obj, kind):
    simulation.simulate(obj, kind, simulation.Options(frames=3, height=0.3))
    before = everything()
    copy = copied(obj)
    copy.location.x += 1
    bpy.context.view_layer.update()
    place = np.array(copy.matrix_world)
    simulation.clear(copy)
    assert not simulation.is_simulated(copy)
    assert (copy.parent, len(copy.modifiers)) == (None, 0)
    np.testing.assert_allclose(np.array(copy.matrix_world), place, atol=1e-5)
    bpy.data.objects.remove(copy)
    assert everything() == before
    assert simulation.owner_of(obj) is not None


def test_a_simulated_object_that_is_deleted_is_gone(obj):
    simulation.simulate(obj, "RIGID", simulation.Options(frames=3, height=0.3))
    name = obj.name
    bpy.ops.object.select_all(action="DESELECT")
    obj.select_set(True)
    bpy.ops.object.delete()
    assert name not in bpy.data.objects


def test_a_copy_outlives_the_original_simulation(obj):
    bpy.ops.mesh.primitive_plane_add(size=6, location=(0, 0, -0.2))
    floor = bpy.context.object
    simulation.simulate(obj, "SOFT", simulation.Options(frames=3))
    copy = copied(obj)
    simulation.clear(obj)
    assert not floor.modifiers
    simulation.clear(copy)
    assert {o.name for o in bpy.data.objects} == {obj.name, copy.name, floor.name}


def test_a_simulation_of_an_earlier_version_is_removed(obj):
    """Its helpers hold the name of the asset."""
    before, start = everything(), world_verts(obj)
    simulation.simulate(obj, "RIGID", simulation.Options(frames=3, height=0.3))
    before_token = obj[simulation.MARK].to_dict()
    obj[simulation.MARK] = {k: v for k, v in before_token.items() if k not in ("token", "name")}
    for made in bpy.data.objects:
        if made != obj:
            made[simulation.MARK] = obj.name
    simulation.clear(obj)
    assert everything() == before
    np.testing.assert_allclose(world_verts(obj), start, atol=1e-5)


def masked(obj) -> None:
    """Let a modifier leave nothing of ``obj``."""
    obj.vertex_groups.new(name="none")
    obj.modifiers.new("mask", "MASK").vertex_group = "none"


def test_what_its_modifiers_hide_is_nothing_to_fall_on(obj):
    bpy.ops.mesh.primitive_plane_add(size=6, location=(0, 0, -0.2))
    masked(bpy.context.object)
    simulation.simulate(obj, "RIGID", simulation.Options(frames=3))
    assert simulation.GROUND in bpy.data.objects
    simulation.clear(obj)
    masked(obj)
    with pytest.raises(AddonError, match="leave no vertices"):
        simulation.simulate(obj, "RIGID", simulation.Options(frames=3))


def test_a_bake_travels_with_the_file(obj, tmp_path):
    simulation.simulate(obj, "SOFT", simulation.Options(frames=FRAMES))
    before = motion(obj)
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "x.blend"))
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "x.blend"))
    obj = bpy.data.objects["a red wooden chair"]
    np.testing.assert_allclose(motion(obj), before, atol=1e-5)
    assert simulation.is_simulated(obj)


def test_a_mesh_with_open_seams_is_refused_with_what_to_press(tmp_path):
    verts, faces, uv, face_uvs = block()
    doubled = verts[faces.ravel()]  # as an exporter without welding writes it
    mesh = doubled, np.arange(len(doubled)).reshape(-1, 3), uv, face_uvs
    obj = import_asset(bpy.context, write_asset(tmp_path / "a", mesh))
    for kind in ("SOFT", "CLOTH"):
        with pytest.raises(AddonError, match=r"is not welded.*Press Weld"):
            simulation.simulate(obj, kind)
    assert [o.name for o in bpy.data.objects] == [obj.name]
    assert not obj.modifiers


def test_an_open_mesh_is_no_soft_body(tmp_path):
    verts, faces, uv, face_uvs = block()
    mesh = verts, faces[:-4], uv, face_uvs[:-4]
    obj = import_asset(bpy.context, write_asset(tmp_path / "a", mesh))
    with pytest.raises(AddonError, match=r"is not closed.*Press Fill Holes"):
        simulation.simulate(obj, "SOFT")


def test_an_unstable_simulation_is_an_error_and_is_removed(obj, monkeypatch):
    monkeypatch.setattr(bake, "STRETCH", 0.5)  # even rest is too much
    before, start = everything(), world_verts(obj)
    with pytest.raises(AddonError, match=r"is not stable: an edge becomes"):
        simulation.simulate(obj, "CLOTH", simulation.Options(frames=3))
    assert everything() == before
    np.testing.assert_allclose(world_verts(obj), start, atol=1e-6)


def test_cancelling_removes_the_simulation(obj):
    before = everything()
    steps = simulation.steps(obj, "SOFT", simulation.Options(frames=50))
    for _ in range(3):
        next(steps)
    steps.close()
    assert everything() == before


def test_a_convex_body_is_one_part_and_its_centre_of_mass_is_exact():
    bpy.ops.mesh.primitive_cube_add(size=2, location=(0, 0, 0))
    mesh = proxy.cage(bpy.context.object, 400)
    parts = proxy.convex_parts(mesh)
    assert len(parts) == 1
    _, center, volume = proxy.hull_mesh("hull", parts[0] + (1, 2, 3))
    np.testing.assert_allclose(center, (1, 2, 3), atol=1e-6)
    assert volume == pytest.approx(8, rel=1e-5)


def test_a_torus_is_parted_so_that_its_hole_stays_open():
    """The hull of a torus fills its hole; the parts come within 12 % of the solid."""
    bpy.ops.mesh.primitive_torus_add(
        major_radius=1, minor_radius=0.3, major_segments=24, minor_segments=8
    )
    mesh = proxy.cage(bpy.context.object, 400)
    parts = proxy.convex_parts(mesh, most=16)
    assert len(parts) >= 6
    hulls = [proxy.hull_mesh("hull", part) for part in parts]
    whole = proxy.hull_mesh("hull", np.concatenate(parts))[2]
    solid = 2 * np.pi**2 * 1 * 0.3**2
    assert sum(volume for _, _, volume in hulls) < 1.15 * solid < 0.8 * whole
    for part in parts:
        assert (np.linalg.norm(part.mean(0)[:2])) > 0.5  # none crosses the hole


def test_the_operators_are_the_functions(addon, obj):
    bpy.context.view_layer.objects.active = obj
    simulation.simulate(obj, "RIGID", simulation.Options(frames=FRAMES, height=0.2))
    function = motion(obj)
    assert bpy.ops.fantasia3d.simulate(kind="RIGID", frames=FRAMES, height=0.2) == {"FINISHED"}
    np.testing.assert_allclose(motion(obj), function, atol=1e-5)
    assert bpy.ops.fantasia3d.clear_simulation() == {"FINISHED"}
    assert not simulation.is_simulated(obj)
    assert not bpy.ops.fantasia3d.clear_simulation.poll()
