"""Real size and weight, from the job to the rigid body and the exports."""

import json

import numpy as np
import pytest

bpy = pytest.importorskip("bpy")

from blender_tests.asset_fixture import block, write_asset  # noqa: E402
from blender_tests.test_free_place import followed  # noqa: E402
from blender_tests.test_live_preview import write_shape  # noqa: E402
from fantasia3d_addon.asset.import_asset import import_asset  # noqa: E402
from fantasia3d_addon.asset.origin import DENSITY  # noqa: E402
from fantasia3d_addon.jobs import history, live_preview  # noqa: E402
from fantasia3d_addon.jobs.job_settings import apply_job, job_of  # noqa: E402
from fantasia3d_addon.mesh.export import export_object  # noqa: E402
from fantasia3d_addon.physics import mass, simulation  # noqa: E402
from fantasia3d_addon.ui.job_panel import facts  # noqa: E402
from fantasia3d_addon.ui.text import length  # noqa: E402

pytestmark = [pytest.mark.blender]


def small(size: float = 0.1):
    """The block, ``size`` metres high."""
    verts, *rest = block()
    return size * verts, *rest


def test_a_size_goes_into_the_job_and_comes_back(addon):
    settings = bpy.context.scene.fantasia3d
    settings.prompt, settings.size = "a mug", 0.1
    job = job_of(settings)
    assert job["size_m"] == 0.1  # not 0.10000000149011612
    settings.size = 0
    apply_job(settings, job)
    assert settings.size == pytest.approx(0.1)
    assert "size_m" not in job_of(settings, "texture")


def test_the_preview_has_the_size_that_the_asset_will_have(addon, tmp_path):
    path = tmp_path / "shape.npz"
    write_shape(path)
    with np.load(path) as parts:
        np.savez(path, size_m=4.2, **parts)
    obj = live_preview.show(bpy.context.scene, path, followed(tmp_path))
    bpy.context.view_layer.update()
    assert max(obj.dimensions) == pytest.approx(4.2, abs=1e-5)


def test_a_rigid_body_weighs_volume_times_density(empty, tmp_path):
    gold = import_asset(bpy.context, write_asset(tmp_path / "gold", density=19300.0))
    wood = import_asset(bpy.context, write_asset(tmp_path / "wood", density=650.0), (3, 0, 0))
    plain = import_asset(bpy.context, write_asset(tmp_path / "plain"), (6, 0, 0))
    verts, faces, _, _ = block()
    a, b, c = (verts[faces[:, i]] for i in range(3))
    volume = float(np.einsum("ij,ij->i", a, np.cross(b, c)).sum() / 6)
    assert DENSITY not in plain
    for obj, density in ((gold, 19300), (wood, 650), (plain, mass.WOOD)):
        simulation.simulate(obj, "RIGID", simulation.Options(frames=2))
        body = simulation.owner_of(obj)
        assert body.rigid_body.mass == pytest.approx(volume * density, rel=1e-3)


def test_the_volume_is_that_in_the_world_and_that_of_an_open_mesh_its_hulls(empty, asset):
    obj = import_asset(bpy.context, asset)
    bpy.context.view_layer.update()
    one = mass.volume_of(obj)
    obj.scale = (2, 1, -1)
    bpy.context.view_layer.update()
    assert mass.volume_of(obj) == pytest.approx(2 * one, rel=1e-5)
    bpy.ops.mesh.primitive_plane_add()
    assert mass.volume_of(bpy.context.object) == 0
    assert mass.mass_of(bpy.context.object, 0.5) == 0.5 * mass.WOOD


@pytest.mark.parametrize("kind", ["RIGID", "SOFT", "CLOTH"])
def test_a_mug_of_ten_centimetres_is_simulated_as_well(empty, tmp_path, kind):
    obj = import_asset(bpy.context, write_asset(tmp_path / "mug", mesh=small(), density=900.0))
    simulation.simulate(obj, kind, simulation.Options(frames=8, height=0.05))
    bpy.context.scene.frame_set(8)
    low = simulation.world_verts(obj)[:, 2].min()
    assert -0.01 < low < 0.05  # it may have bounced


@pytest.mark.parametrize("ending", [".glb", ".fbx", ".obj"])
def test_an_export_has_the_worlds_size(empty, tmp_path, ending):
    obj = import_asset(bpy.context, write_asset(tmp_path / "mug", mesh=small(), size=16))
    path = export_object(obj, tmp_path / f"mug{ending}")
    bpy.ops.wm.read_factory_settings(use_empty=True)
    name = {".glb": "import_scene.gltf", ".fbx": "import_scene.fbx", ".obj": "wm.obj_import"}
    group, operator = name[ending].split(".")
    getattr(getattr(bpy.ops, group), operator)(filepath=str(path))
    bpy.context.view_layer.update()
    (back,) = [obj for obj in bpy.data.objects if obj.type == "MESH"]
    assert max(back.dimensions) == pytest.approx(0.1, rel=1e-4)


def test_the_history_has_the_size_of_what_is_done(addon, tmp_path):
    run = tmp_path / "run"
    write_asset(run / "asset", size_m=0.1)
    (run / "job.json").write_text(json.dumps({"prompt": "a mug"}))
    (run / "events.jsonl").write_text('{"type": "done", "time": 1}\n')
    entry = history.read_entry(run)
    assert entry.size_m == 0.1
    assert "Size: 10 cm" in facts(entry)
    (run / "asset" / "asset.json").write_text("{")
    assert history.read_entry(run).size_m == 0


@pytest.mark.parametrize(("metres", "text"), [(4.2, "4.2 m"), (0.1, "10 cm"), (0.081, "8.1 cm")])
def test_lengths_are_short(metres, text):
    assert length(metres) == text
