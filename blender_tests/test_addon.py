"""The add-on in Blender: it comes and goes without a trace, and its buttons are its functions."""

import random
import sys
import time
from pathlib import Path

import pytest

bpy = pytest.importorskip("bpy")

import fantasia3d_addon  # noqa: E402
from blender_tests.asset_fixture import write_asset  # noqa: E402
from fantasia3d_addon import environment, preferences  # noqa: E402
from fantasia3d_addon.errors import AddonError  # noqa: E402
from fantasia3d_addon.import_asset import import_asset  # noqa: E402
from fantasia3d_addon.properties import job_of  # noqa: E402
from fantasia3d_addon.registration import CLASSES  # noqa: E402
from fantasia3d_addon.session import session  # noqa: E402

pytestmark = [pytest.mark.blender, pytest.mark.usefixtures("empty")]
FAKE_CORE = Path(__file__).parent / "fake_core"


def traces() -> set[str]:
    """What Blender knows by our name."""
    kinds = (
        bpy.types.Panel,
        bpy.types.Operator,
        bpy.types.PropertyGroup,
        bpy.types.AddonPreferences,
    )
    found = {cls.__name__ for kind in kinds for cls in kind.__subclasses__() if cls.is_registered}
    found = {name for name in found if name.startswith("FANTASIA3D")}
    found |= {f"ops.{name}" for name in dir(bpy.ops.fantasia3d)}
    found |= {"Scene.fantasia3d"} if hasattr(bpy.types.Scene, "fantasia3d") else set()
    return found | ({"a timer"} if bpy.app.timers.is_registered(session._timer) else set())


def test_register_and_unregister_twice_leave_nothing():
    assert traces() == set()
    for _ in range(2):
        fantasia3d_addon.register()
        assert {cls.__name__ for cls in CLASSES} < traces()
        session.watch()
        fantasia3d_addon.unregister()
        assert traces() == set()


def test_the_package_loads_without_blender():
    """run.py shares its environment module under plain Python."""
    import subprocess

    names = "fantasia3d_addon.environment, fantasia3d_addon.jobs"
    code = f"import sys, {names}; print('bpy' in sys.modules)"
    done = subprocess.run(
        [sys.executable, "-c", code], cwd=FAKE_CORE.parents[1], capture_output=True, text=True
    )
    assert done.stdout.strip() == "False", done.stderr


@pytest.fixture
def ready(addon, tmp_path, monkeypatch):
    """The add-on with the fake core, an asset to make, and a folder for runs."""
    monkeypatch.setenv("FANTASIA3D_PYTHON", sys.executable)
    monkeypatch.setattr(environment, "project_root", lambda: FAKE_CORE)
    monkeypatch.setattr(preferences.Machine, "runs", tmp_path / "runs")
    settings = bpy.context.scene.fantasia3d
    settings.prompt = "a red wooden chair"
    settings.negative_prompt = str(write_asset(tmp_path / "made"))  # the fake core hands it out
    return settings


def wait(until=lambda: False) -> None:
    """Call the session's tick as a timer would, until the run has ended."""
    deadline = time.monotonic() + 60
    while session.tick() is not None and not until():
        assert time.monotonic() < deadline
        time.sleep(0.01)


def test_generate_puts_the_asset_at_the_cursor(ready):
    bpy.context.scene.cursor.location = (1, 2, 3)
    assert bpy.ops.fantasia3d.generate() == {"FINISHED"}
    bpy.context.scene.cursor.location = (0, 0, 0)  # where it was is what counts
    wait()
    (obj,) = bpy.data.objects
    assert (obj.name, tuple(obj.location)) == ("a red wooden chair", (1, 2, 3))
    assert session.asset == obj.name
    assert session.error is None
    assert session.run.folder.name.endswith("-a-red-wooden-chair")


def test_progress_is_told_while_it_runs(ready):
    ready.prompt = "long"
    bpy.ops.fantasia3d.generate()
    wait(until=lambda: session.progress.share > 0)
    assert session.progress.line.startswith("Geometry 0%, 0:01 left")
    with pytest.raises(RuntimeError, match=r"A run is going on|poll"):
        bpy.ops.fantasia3d.generate()
    assert bpy.ops.fantasia3d.cancel() == {"FINISHED"}
    assert session.progress.line == "Geometry: stops after this step"
    wait()
    assert session.run.last.type == "cancelled"
    assert (session.error, len(bpy.data.objects)) == (None, 0)


def test_an_error_stays_in_the_panel_with_its_fix(ready):
    ready.prompt = "fail"
    bpy.ops.fantasia3d.generate()
    wait()
    assert session.error == ("There is no noun 'blorb'.", "Say chair.")
    assert bpy.ops.fantasia3d.open_log.poll()
    ready.prompt = "x"
    bpy.ops.fantasia3d.generate()
    assert session.error is None  # a new run, a new page
    wait()


def test_half_an_asset_is_an_error_in_the_panel(ready):
    (Path(ready.negative_prompt) / "orm.png").unlink()
    bpy.ops.fantasia3d.generate()
    wait()
    assert session.error is not None
    assert session.error[0].endswith("orm.png is missing.")
    assert not bpy.data.objects


def test_a_new_file_does_not_lose_the_run(ready):
    bpy.ops.fantasia3d.generate()
    bpy.ops.wm.read_factory_settings(use_empty=True)
    assert bpy.app.timers.is_registered(session._timer)
    wait()
    assert [obj.name for obj in bpy.data.objects] == ["a red wooden chair"]


def test_the_guide_is_written_into_the_run(ready):
    mesh = bpy.data.meshes.new("guide")
    mesh.from_pydata([(0, 0, 0), (1, 0, 0), (0, 1, 0)], [], [(0, 1, 2)])
    ready.guide = bpy.data.objects.new("guide", mesh)
    bpy.context.scene.collection.objects.link(ready.guide)
    bpy.ops.fantasia3d.generate()
    assert (session.run.folder / "guide.obj").read_text().count("\nf ") == 1
    wait()


def test_the_import_operator_is_the_function(addon, asset):
    bpy.context.scene.cursor.location = (0, 0, 1)
    function = import_asset(bpy.context, asset, (0, 0, 1))
    assert bpy.ops.fantasia3d.import_asset(directory=str(asset)) == {"FINISHED"}
    operator = bpy.context.object
    assert operator != function
    assert operator.select_get()
    assert not function.select_get()
    assert operator.location == function.location
    assert len(operator.data.polygons) == len(function.data.polygons)
    with pytest.raises(RuntimeError, match=r"it has no asset\.json"):
        bpy.ops.fantasia3d.import_asset(directory=str(asset.parent / "nowhere"))


def test_a_new_seed_is_another(addon, monkeypatch):
    monkeypatch.setattr(random, "randrange", lambda limit: limit - 1)
    bpy.ops.fantasia3d.new_seed()
    assert bpy.context.scene.fantasia3d.seed == 2**31 - 1


def operators() -> dict[str, object]:
    return {
        cls.bl_idname: getattr(bpy.ops.fantasia3d, cls.bl_idname.partition(".")[2])
        for cls in CLASSES
        if issubclass(cls, bpy.types.Operator)
    }


@pytest.mark.parametrize("scene", ["empty", "a light", "edit mode"])
def test_every_poll_answers_in_every_scene(addon, scene):
    if scene != "empty":
        data = bpy.data.lights.new("x", "POINT") if scene == "a light" else bpy.data.meshes.new("x")
        obj = bpy.data.objects.new("x", data)
        bpy.context.scene.collection.objects.link(obj)
        bpy.context.view_layer.objects.active = obj
    if scene == "edit mode":
        bpy.ops.object.mode_set(mode="EDIT")
    answers = {name: operator.poll() for name, operator in operators().items()}
    assert answers["fantasia3d.import_asset"] == (scene != "edit mode")
    assert not answers["fantasia3d.generate"]  # the prompt is empty
    assert not answers["fantasia3d.cancel"]
    assert not answers["fantasia3d.open_log"]
    assert answers["fantasia3d.new_seed"]
    if scene == "edit mode":
        bpy.ops.object.mode_set(mode="OBJECT")


def test_generate_says_why_it_cannot_be_pressed(addon, monkeypatch, tmp_path):
    from fantasia3d_addon.operators import reason_against

    assert "prompt is empty" in reason_against(bpy.context)
    bpy.context.scene.fantasia3d.prompt = "a chair"
    monkeypatch.setenv("FANTASIA3D_PYTHON", str(tmp_path / "none"))
    assert "Set Up first" in reason_against(bpy.context)
    monkeypatch.setenv("FANTASIA3D_PYTHON", sys.executable)
    assert reason_against(bpy.context) == ""
    assert bpy.ops.fantasia3d.generate.poll()


def test_set_up_and_check_call_the_environment(addon, monkeypatch, tmp_path):
    monkeypatch.setenv("FANTASIA3D_ENV", str(tmp_path / "env"))
    asked = []

    def ensure(root, groups, say):
        say("half", 0.5)
        asked.append(groups)
        raise environment.SetupError("No disk.", "Buy one.")

    monkeypatch.setattr(environment, "ensure", ensure)
    session.set_up(bpy.context).join(10)
    assert asked == [()]
    assert session.work.error == ("No disk.", "Buy one.")
    line = environment.Line("torch", "MISSING", "It is not there. Press Set Up.")
    monkeypatch.setattr(environment, "examine", lambda root: [line])
    session.check(bpy.context).join(10)
    assert session.work.error == ("Missing: torch.", "It is not there. Press Set Up.")
    monkeypatch.setattr(environment, "examine", lambda root: [])
    session.check(bpy.context).join(10)
    assert (session.work.error, session.work.text) == (None, "Everything is here.")


def test_every_job_is_one_that_the_core_takes(addon, tmp_path):
    pytest.importorskip("jaxtyping")
    from core.protocol import Job

    settings = bpy.context.scene.fantasia3d
    settings.prompt = "a chair"
    assert Job(**job_of(settings)) == Job(prompt="a chair")  # the defaults of both are the same
    settings.guidance, settings.model = "model", "some/model"
    settings.texture_size, settings.max_faces, settings.seed = "2048", 5000, 7
    settings.light = "blender:city"
    settings.preset, settings.guide_strength = "paper", 0.25
    job = Job(**job_of(settings, tmp_path / "guide.obj"))
    assert (job.guidance, job.texture_size, job.max_faces) == ("some/model", 2048, 5000)
    assert job.light.endswith("city.exr")
    assert job.guide_mesh == str(tmp_path / "guide.obj")


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"guidance": "model"}, "No model is named"),
        ({"light": "FILE", "light_file": "/no/such.hdr"}, "There is no light"),
    ],
)
def test_a_job_that_cannot_be_is_refused(addon, change, message):
    settings = bpy.context.scene.fantasia3d
    for name, value in change.items():
        setattr(settings, name, value)
    with pytest.raises(AddonError, match=message):
        job_of(settings)


def test_the_network_is_used_only_where_blender_and_the_user_allow_it(addon):
    machine = preferences.Machine(bpy.context)
    assert machine.core_environ["HF_HUB_OFFLINE"] == "1"
