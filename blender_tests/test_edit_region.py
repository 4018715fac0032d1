"""A region edited in Blender: what the job gets, and that all but the region's texels stays."""

from pathlib import Path

import pytest

bpy = pytest.importorskip("bpy")
import numpy as np  # noqa: E402

from blender_tests.asset_fixture import block, island_colors, write_asset  # noqa: E402
from fantasia3d_addon.asset.asset_folder import read_obj  # noqa: E402
from fantasia3d_addon.asset.import_asset import import_asset  # noqa: E402
from fantasia3d_addon.errors import AddonError  # noqa: E402
from fantasia3d_addon.jobs import edit_region, history, submit  # noqa: E402
from fantasia3d_addon.jobs.paths import Paths  # noqa: E402
from fantasia3d_addon.jobs.session import session  # noqa: E402
from fantasia3d_addon.jobs.target import BOTH, SHAPE  # noqa: E402
from fantasia3d_addon.mesh import new_shape, region  # noqa: E402

pytestmark = [pytest.mark.blender, pytest.mark.usefixtures("empty")]
MAPS = ("base_color.png", "orm.png", "normal.png")


@pytest.fixture
def chair(ready, tmp_path) -> bpy.types.Object:
    """An imported asset, active; the fake core hands out one with other colours."""
    other = write_asset(tmp_path / "other", base_color=255 - island_colors(64))
    ready.negative_prompt = str(other)
    obj = import_asset(bpy.context, write_asset(tmp_path / "chair"), (1, 2, 3))
    bpy.context.view_layer.objects.active = obj
    bpy.context.view_layer.update()
    return obj


def select(obj: bpy.types.Object, faces: range) -> None:
    """Exactly these, in Edit Mode."""
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_mode(type="FACE")
    bpy.ops.mesh.select_all(action="DESELECT")
    bpy.ops.object.mode_set(mode="OBJECT")
    obj.data.polygons.foreach_set("select", [i in faces for i in range(len(obj.data.polygons))])
    bpy.ops.object.mode_set(mode="EDIT")


def newest_run() -> Path:
    return max(Paths(bpy.context).runs.iterdir(), key=lambda path: path.stat().st_mtime)


def pixels(obj: bpy.types.Object) -> dict[str, np.ndarray]:
    """What the object's maps hold, row 0 at the top."""
    found = {}
    for role, image in region.look_of(obj).images.items():
        flat = np.empty(len(image.pixels), np.float32)
        image.pixels.foreach_get(flat)
        found[role] = flat.reshape(*image.size, -1)[::-1]
    return found


def state(obj: bpy.types.Object) -> tuple:
    """All of an object but its maps."""
    mesh = obj.data
    verts, uv = np.empty(3 * len(mesh.vertices), "f"), np.empty(2 * len(mesh.loops), "f")
    mesh.vertices.foreach_get("co", verts)
    mesh.uv_layers["UVMap"].uv.foreach_get("vector", uv)
    modifiers = [(m.name, m.type) for m in obj.modifiers]
    matrix = [tuple(row) for row in obj.matrix_world]
    return obj.name, mesh.name, verts.tobytes(), uv.tobytes(), matrix, modifiers


def test_the_job_keeps_the_maps_byte_for_byte_and_names_the_selected_faces(chair, wait, tmp_path):
    select(chair, range(40, 60))
    assert bpy.ops.fantasia3d.edit_region(words="red velvet") == {"FINISHED"}
    run = newest_run()
    entry = history.read_entry(run)
    assert {key: entry.job[key] for key in ("command", "prompt", "uv", "texture_size")} == {
        "command": "texture", "prompt": "red velvet", "uv": "keep", "texture_size": 64,
    }  # fmt: skip
    kept = Path(entry.job["kept_asset"])
    assert kept == (run / "kept" / "asset").resolve()
    for name in MAPS:
        assert (kept / name).read_bytes() == (tmp_path / "chair" / name).read_bytes()
    assert Path(entry.job["region"]).read_text().split() == [str(i) for i in range(40, 60)]
    ours, theirs = read_obj(kept / "mesh.obj"), read_obj(tmp_path / "chair" / "mesh.obj")
    assert all(map(np.array_equal, ours, theirs))
    bpy.ops.object.mode_set(mode="OBJECT")
    wait()


def test_what_is_flat_is_kept_flat(chair, wait):
    chair.data.shade_flat()
    select(chair, range(40, 60))
    assert bpy.ops.fantasia3d.edit_region(words="red velvet") == {"FINISHED"}
    path = Path(history.read_entry(newest_run()).job["kept_asset"]) / "mesh.obj"
    _, faces, _, flat = read_obj(path)
    lines = path.read_text().splitlines()
    assert flat and sum(line.startswith("vn ") for line in lines) == len(faces)
    of_corners = [line.split()[1:] for line in lines if line.startswith("f ")]
    assert [{c.split("/")[2] for c in one} for one in of_corners] == [
        {str(k + 1)} for k in range(len(faces))
    ]
    bpy.ops.object.mode_set(mode="OBJECT")
    wait()


def test_on_arrival_the_maps_alone_change_and_restore_brings_them_back(chair, wait):
    other = bpy.data.materials.new("paint")
    chair.data.materials.append(other)
    chair.modifiers.new("Bevel", "BEVEL")
    chair.rotation_euler.z = 0.5
    bpy.context.view_layer.update()
    before, maps, old = state(chair), pixels(chair), chair.material_slots[0].material
    copy = chair.copy()
    copy.data = chair.data.copy()  # an object of its own, which shares the material
    bpy.context.scene.collection.objects.link(copy)
    select(chair, range(10))
    edit_region.edit_region(bpy.context, "red velvet")
    bpy.ops.object.mode_set(mode="OBJECT")
    wait()
    assert session.error is None
    assert session.asset == chair.name
    assert state(chair) == before
    assert chair.material_slots[1].material == other
    new = pixels(chair)
    assert (new["base_color"] != maps["base_color"]).any()
    assert all(image.packed_file for image in region.look_of(chair).images.values())
    assert copy.material_slots[0].material == old
    assert np.array_equal(pixels(copy)["base_color"], maps["base_color"])
    assert bpy.ops.fantasia3d.restore_material() == {"FINISHED"}
    assert chair.material_slots[0].material == old


def test_an_object_that_shares_the_mesh_keeps_its_maps(chair, wait):
    copy, old = chair.copy(), chair.active_material
    bpy.context.scene.collection.objects.link(copy)
    select(chair, range(10))
    edit_region.edit_region(bpy.context, "red velvet")
    bpy.ops.object.mode_set(mode="OBJECT")
    wait()
    assert chair.active_material != old == copy.active_material
    assert chair.data == copy.data  # whose shape can still be edited once for both
    assert bpy.ops.fantasia3d.restore_material() == {"FINISHED"}
    assert chair.active_material == copy.active_material == old
    assert chair.material_slots[0].link == "DATA"


@pytest.fixture
def dented(chair, tmp_path, ready) -> bpy.types.Object:
    """The fake core hands out the asset with one vertex pushed in, and with other colours."""
    verts, *rest = block()
    verts = verts.copy()
    verts[middle(verts)] *= 0.9
    made = write_asset(tmp_path / "dented", (verts, *rest), base_color=255 - island_colors(64))
    ready.negative_prompt = str(made)
    return chair


def middle(verts: np.ndarray) -> int:
    """A vertex inside of one side."""
    return int(
        np.abs(verts - np.median(verts[verts[:, 0] == verts[:, 0].max()], 0)).sum(1).argmin()
    )


def positions(obj: bpy.types.Object) -> np.ndarray:
    flat = np.empty(3 * len(obj.data.vertices), np.float32)
    obj.data.vertices.foreach_get("co", flat)
    return flat.reshape(-1, 3)


def edit_shape(obj: bpy.types.Object, wait, change: str = SHAPE) -> None:
    select(obj, range(10))
    assert bpy.ops.fantasia3d.edit_region(words="a chair", change=change) == {"FINISHED"}
    bpy.ops.object.mode_set(mode="OBJECT")
    wait()


def test_on_arrival_the_vertices_alone_move_and_restore_brings_them_back(dented, wait):
    copy = dented.copy()  # which shares the mesh
    bpy.context.scene.collection.objects.link(copy)
    dented.modifiers.new("Bevel", "BEVEL")
    before, maps, old = positions(dented), pixels(dented), dented.active_material
    uv = state(dented)[3]
    edit_shape(dented, wait)
    assert session.error is None
    job = history.read_entry(newest_run()).job
    assert (job["reshape"], job["retexture"]) == (True, False)
    moved = (positions(dented) != before).any(1)
    assert moved.sum() == 1
    assert np.array_equal(positions(copy), before)
    assert (state(dented)[3], dented.active_material, len(dented.modifiers)) == (uv, old, 1)
    assert all(np.array_equal(new, maps[role]) for role, new in pixels(dented).items())
    edit_shape(dented, wait)  # a second edit must not overwrite the original
    assert bpy.ops.fantasia3d.restore_shape() == {"FINISHED"}
    assert np.array_equal(positions(dented), before)
    assert not bpy.ops.fantasia3d.restore_shape.poll()


def test_shape_and_material_arrive_together_and_each_has_its_way_back(dented, wait):
    before, maps = positions(dented), pixels(dented)
    edit_shape(dented, wait, BOTH)
    assert session.error is None
    job = history.read_entry(newest_run()).job
    assert (job["reshape"], job["retexture"]) == (True, True)
    assert (positions(dented) != before).any()
    assert (pixels(dented)["base_color"] != maps["base_color"]).any()
    assert bpy.ops.fantasia3d.restore_material() == {"FINISHED"}
    assert (positions(dented) != before).any()
    assert bpy.ops.fantasia3d.restore_shape() == {"FINISHED"}
    assert np.array_equal(positions(dented), before)


def test_a_shape_does_not_arrive_on_a_mesh_that_was_changed_meanwhile(dented, wait):
    select(dented, range(10))
    edit_region.edit_region(bpy.context, "a chair", change=SHAPE)
    bpy.ops.object.mode_set(mode="OBJECT")
    dented.data.vertices[0].co.x += 1
    changed = positions(dented)
    wait()
    assert "was changed after" in session.error[0]
    assert np.array_equal(positions(dented), changed)


def test_the_reasons_against_a_shape(dented):
    dented.vertex_groups.new(name="seat")
    assert edit_region.reason_against(bpy.context, "", SHAPE) == ""
    assert new_shape.reason_against_restore(dented) == "It has its own shape."
    dented.shape_key_add(name="Basis")
    assert "shape keys" in edit_region.reason_against(bpy.context, "", SHAPE)
    assert edit_region.reason_against(bpy.context) == ""  # its material can be edited


def test_adjustments_and_other_nodes_stay_over_the_new_maps(chair, wait):
    bpy.ops.fantasia3d.adjust_material(tint=(1, 0.5, 0.5))
    names = {node.name for node in chair.active_material.node_tree.nodes}
    select(chair, range(10))
    edit_region.edit_region(bpy.context, "red velvet")
    bpy.ops.object.mode_set(mode="OBJECT")
    wait()
    assert {node.name for node in chair.active_material.node_tree.nodes} == names


def test_a_vertex_group_is_a_region_in_object_mode(chair):
    group = chair.vertex_groups.new(name="seat")
    group.add(list(chair.data.polygons[7].vertices), 1.0, "REPLACE")
    assert region.faces_of(chair, "seat").tolist() == [7]
    assert region.faces_of(chair).tolist() == [7]  # the active one
    group.add(list(chair.data.polygons[7].vertices)[:1], 0.1, "REPLACE")
    with pytest.raises(AddonError, match="No faces"):
        region.faces_of(chair)


def test_faces_of_polygons_are_those_of_their_triangles(chair):
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_all(action="SELECT")
    bpy.ops.mesh.tris_convert_to_quads()
    bpy.ops.object.mode_set(mode="OBJECT")
    mesh = chair.data
    assert any(len(p.vertices) == 4 for p in mesh.polygons)
    mesh.calc_loop_triangles()
    last = len(mesh.polygons) - 1
    select(chair, range(last, last + 1))
    chair.update_from_editmode()
    wanted = [t.index for t in mesh.loop_triangles if t.polygon_index == last]
    assert region.faces_of(chair).tolist() == wanted


def test_a_job_is_repeated_with_its_own_copy_of_what_is_kept(chair, wait):
    select(chair, range(10))
    edit_region.edit_region(bpy.context, "red velvet")
    bpy.ops.object.mode_set(mode="OBJECT")
    wait()
    first = history.read_entry(newest_run())
    again = history.read_entry(submit.repeat(bpy.context, first))
    wait()
    for key in ("kept_asset", "region", "mesh"):
        assert Path(again.job[key]).is_relative_to(again.folder.resolve())
        assert Path(again.job[key]).exists()
    kept = [Path(entry.job["kept_asset"]) for entry in (first, again)]
    assert (kept[0] / "orm.png").read_bytes() == (kept[1] / "orm.png").read_bytes()


def test_what_was_painted_is_kept_too(chair, tmp_path):
    image = region.look_of(chair).images["base_color"]
    image.pixels[:4] = (0.0, 1.0, 0.0, 1.0)
    image.update()
    kept = region.write_kept(chair, tmp_path / "kept")
    loaded = bpy.data.images.load(str(kept["base_color.png"]))
    assert tuple(loaded.pixels[:4]) == (0.0, 1.0, 0.0, 1.0)


def test_the_reasons(ready, chair):
    def reason(group: str = "") -> str:
        return edit_region.reason_against(bpy.context, group)

    assert reason() == "Select faces in Edit Mode, or add a vertex group."
    chair.vertex_groups.new(name="seat")
    assert reason() == reason("seat") == ""
    assert "no vertex group" in reason("back")
    select(chair, range(0))
    assert reason() == "Select the faces to edit."
    assert not bpy.ops.fantasia3d.edit_region.poll()
    bpy.ops.object.mode_set(mode="OBJECT")
    with pytest.raises(AddonError, match="no words"):
        edit_region.edit_region(bpy.context, " ", "seat")
    chair.data.uv_layers.remove(chair.data.uv_layers[0])
    assert reason() == "The UV map of its maps was removed."
    chair.data.materials.clear()
    assert reason() == "It does not show the baked maps of an asset."
    bpy.context.view_layer.objects.active = None
    assert reason() == "Select a mesh."


def use_real_core(monkeypatch) -> None:
    """A short training by the core itself."""
    pytest.importorskip("torch")
    from core.tests.tiny_runs import OPTIONS
    from fantasia3d_addon import environment

    monkeypatch.setattr(environment, "project_root", lambda: Path(__file__).parents[1])
    settings = bpy.context.scene.fantasia3d
    settings.negative_prompt = ""
    settings.overrides = " ".join(o[6:] for o in OPTIONS if o.startswith("--set="))


def test_with_the_real_core_all_but_the_regions_vertices_stays(chair, wait, monkeypatch):
    use_real_core(monkeypatch)
    short = (f"geometry.reshape.{key}" for key in ("rounds=1", "steps=2", "views=2"))
    settings = bpy.context.scene.fantasia3d
    settings.overrides = " ".join([settings.overrides, *short])
    chair.data.vertices.foreach_get("co", old := np.empty(3 * len(chair.data.vertices), "f"))
    before, maps = state(chair), pixels(chair)
    select(chair, range(256, 384))  # the block's back
    edit_region.edit_region(bpy.context, "a cube", change=SHAPE)
    bpy.ops.object.mode_set(mode="OBJECT")
    wait(seconds=600)
    assert session.error is None
    moved = (positions(chair) != old.reshape(-1, 3)).any(1)
    inside = np.zeros(len(moved), bool)
    faces = [tuple(polygon.vertices) for polygon in chair.data.polygons]
    inside[np.unique(faces[256:384])] = True
    inside[np.unique(faces[:256] + faces[384:])] = False
    assert moved.any() and not (moved & ~inside).any()
    assert all(np.array_equal(new, maps[role]) for role, new in pixels(chair).items())
    assert bpy.ops.fantasia3d.restore_shape() == {"FINISHED"}
    assert state(chair) == before


def test_with_the_real_core_all_but_the_regions_texels_stays(chair, wait, monkeypatch):
    use_real_core(monkeypatch)
    import torch

    from core.io.asset import read_asset
    from core.texture.texels import texel_points

    settings = bpy.context.scene.fantasia3d
    settings.overrides += " texture.feather=0.05"
    before, maps = state(chair), pixels(chair)
    select(chair, range(256, 384))  # the block's back
    edit_region.edit_region(bpy.context, "blue metal")
    bpy.ops.object.mode_set(mode="OBJECT")
    wait(seconds=600)
    assert session.error is None
    assert state(chair) == before
    kept = read_asset(newest_run() / "kept" / "asset")
    texels = texel_points(*kept.mesh.atlas, 64)
    inside = (texels.face >= 256) & (texels.face < 384)
    outside = torch.zeros(64 * 64, dtype=torch.bool)
    outside[texels.index[~inside]] = True
    outside = outside.view(64, 64).numpy()
    within = torch.zeros(64 * 64, dtype=torch.bool)
    within[texels.index[inside]] = True
    within = within.view(64, 64).numpy() & ~outside
    for role, new in pixels(chair).items():
        assert np.array_equal(new[outside], maps[role][outside])
    assert (pixels(chair)["base_color"] != maps["base_color"])[within].any(-1).mean() > 0.5
