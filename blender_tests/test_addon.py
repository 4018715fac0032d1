"""The add-on in Blender: it registers without a trace, and its buttons are its functions."""

import random
import sys
from pathlib import Path

import pytest

bpy = pytest.importorskip("bpy")

import fantasia3d_addon  # noqa: E402
from fantasia3d_addon.asset.import_asset import import_asset  # noqa: E402
from fantasia3d_addon.errors import AddonError  # noqa: E402
from fantasia3d_addon.jobs import (  # noqa: E402
    handlers,
    paths,
    submit,
)
from fantasia3d_addon.jobs.job_settings import apply_job, job_of  # noqa: E402
from fantasia3d_addon.jobs.session import session  # noqa: E402
from fantasia3d_addon.ui.registration import CLASSES  # noqa: E402

pytestmark = [pytest.mark.blender, pytest.mark.usefixtures("empty")]
ROOT = Path(__file__).parents[1]


def traces() -> set[str]:
    """What Blender knows by our name."""
    kinds = (
        bpy.types.Panel,
        bpy.types.Menu,
        bpy.types.FileHandler,
        bpy.types.UIList,
        bpy.types.Operator,
        bpy.types.PropertyGroup,
        bpy.types.AddonPreferences,
    )
    found = {cls.__name__ for kind in kinds for cls in kind.__subclasses__() if cls.is_registered}
    found = {name for name in found if name.startswith("FANTASIA3D")}
    found |= {f"ops.{name}" for name in dir(bpy.ops.fantasia3d)}
    for owner in (bpy.types.Scene, bpy.types.WindowManager):
        found |= {f"{owner.__name__}.fantasia3d"} if hasattr(owner, "fantasia3d") else set()
    for registered, function in handlers.HANDLERS:
        found |= {function.__name__} if function in registered else set()
    return found | ({"a timer"} if bpy.app.timers.is_registered(session._timer) else set())


def test_register_and_unregister_twice_leave_nothing():
    assert traces() == set()
    for _ in range(2):
        fantasia3d_addon.register()
        assert {cls.__name__ for cls in CLASSES} < traces()
        session.start_timer()
        fantasia3d_addon.unregister()
        assert traces() == set()


def test_the_package_loads_without_blender():
    """run.py shares its environment module under plain Python."""
    import subprocess

    jobs = ("process", "history", "target", "lock", "progress", "memory")
    modules = ("environment", "background.thread", *(f"jobs.{name}" for name in jobs))
    names = ", ".join(f"fantasia3d_addon.{module}" for module in modules)
    code = f"import sys, {names}; print('bpy' in sys.modules)"
    done = subprocess.run([sys.executable, "-c", code], cwd=ROOT, capture_output=True, text=True)
    assert done.stdout.strip() == "False", done.stderr


def test_the_import_operator_is_the_function(addon, asset):
    bpy.context.scene.cursor.location = (0, 0, 1)
    function = import_asset(bpy.context, asset, (0, 0, 1))
    bpy.context.scene.fantasia3d.placement = "cursor"
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
    assert answers["fantasia3d.guide_from_selection"] == (scene == "edit mode")
    for name in ("generate", "texture", "cancel", "stop_now", "open_log", "queue_drop"):
        assert not answers[f"fantasia3d.{name}"]  # the prompt is empty, nothing runs or waits
    for name in ("new_seed", "dismiss", "refresh", "check"):
        assert answers[f"fantasia3d.{name}"]
    if scene == "edit mode":
        bpy.ops.object.mode_set(mode="OBJECT")


def test_generate_has_a_reason_when_it_is_disabled(addon, monkeypatch, tmp_path):
    settings = bpy.context.scene.fantasia3d
    assert "Enter a prompt" in submit.reason_against_generate(bpy.context)
    settings.prompt = "a chair"
    monkeypatch.setenv("FANTASIA3D_PYTHON", str(tmp_path / "none"))
    assert "press Install" in submit.reason_against_generate(bpy.context)
    monkeypatch.setenv("FANTASIA3D_PYTHON", sys.executable)
    assert submit.reason_against_generate(bpy.context) == ""
    assert bpy.ops.fantasia3d.generate.poll()
    assert submit.reason_against_texture(bpy.context) == "Select a mesh."
    settings.light = "FILE"
    assert "Choose an HDR or EXR file" in submit.reason_against_generate(bpy.context)


def test_the_core_accepts_every_job(addon, tmp_path):
    pytest.importorskip("jaxtyping")
    from core.io.job import Job

    settings = bpy.context.scene.fantasia3d
    settings.prompt = "a chair"
    assert Job(**job_of(settings)) == Job(prompt="a chair")  # the defaults of both are the same
    settings.guidance, settings.hub_id = "hub", "some/model"
    settings.texture_size, settings.max_faces, settings.seed = "2048", 5000, 7
    settings.light, settings.device = "blender:city", "cpu"
    settings.preset, settings.guide_strength = "paper", 0.25
    settings.overrides = "geometry.views=3  texture.samples=9"
    job = Job(**job_of(settings))
    assert (job.guidance, job.texture_size, job.max_faces) == ("some/model", 2048, 5000)
    assert job.light.endswith("city.exr")
    assert job.settings == {"geometry.views": "3", "texture.samples": "9"}
    settings.color_strength = 0.75
    job = Job(**job_of(settings, "texture") | {"mesh": "m.obj", "base_color": "c.png"})
    assert (job.command, job.uv, job.guide_strength) == ("texture", "keep", 0.75)


def test_the_settings_come_back_from_their_job(addon, tmp_path):
    settings = bpy.context.scene.fantasia3d
    (tmp_path / "model_index.json").touch()
    settings.prompt, settings.seed, settings.preset = "a chair", 9, "paper"
    settings.guidance, settings.model_folder = "folder", str(tmp_path)
    settings.texture_size, settings.light = "1024", "blender:forest"
    settings.overrides, settings.guide_strength = "geometry.views=3", 0.25
    job = job_of(settings)
    for name in settings.bl_rna.properties.keys():  # noqa: SIM118
        if name not in ("rna_type", "name"):
            settings.property_unset(name)
    assert job_of(settings) != job
    apply_job(settings, job)
    assert job_of(settings) == job


def test_a_file_a_lora_and_an_embedding_come_back_from_their_job(addon, tmp_path):
    settings = bpy.context.scene.fantasia3d
    for name in ("model", "style", "word"):
        (tmp_path / f"{name}.safetensors").touch()
    settings.prompt, settings.guidance = "a chair", "folder"
    settings.model_folder = str(tmp_path / "model.safetensors")
    settings.lora, settings.lora_strength = str(tmp_path / "style.safetensors"), 0.7
    settings.embedding = str(tmp_path / "word.safetensors")
    job = job_of(settings)
    assert job["guidance"] == str(tmp_path / "model.safetensors")
    assert job["loras"] == {str(tmp_path / "style.safetensors"): 0.7}
    assert job["embeddings"] == [str(tmp_path / "word.safetensors")]
    apply_job(settings, {"prompt": "a chair"})
    assert not {"loras", "embeddings"} & job_of(settings).keys()
    apply_job(settings, job)
    assert job_of(settings) == job
    with pytest.raises(AddonError, match="several LoRA files"):
        apply_job(settings, job | {"loras": {"a": 1.0, "b": 1.0}})
    assert job_of(settings) == job
    (tmp_path / "style.safetensors").unlink()
    with pytest.raises(AddonError, match="There is no LoRA “style.safetensors”"):
        job_of(settings)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"guidance": "folder"}, "is not a Stable Diffusion model"),
        ({"guidance": "folder", "model_folder": "/tmp"}, "is not a Stable Diffusion model"),
        ({"guidance": "hub"}, "No model is chosen"),
        ({"light": "FILE"}, "No light is chosen"),
        ({"light": "FILE", "light_file": "/no/such.hdr"}, "There is no light"),
        ({"overrides": "geometry.views"}, "has no value"),
    ],
)
def test_a_job_that_cannot_be_is_refused(addon, change, message):
    settings = bpy.context.scene.fantasia3d
    for name, value in change.items():
        setattr(settings, name, value)
    with pytest.raises(AddonError, match=message):
        job_of(settings)


def test_the_guide_is_the_selected_mesh(addon):
    obj = bpy.data.objects.new("x", bpy.data.meshes.new("x"))
    bpy.context.scene.collection.objects.link(obj)
    bpy.context.view_layer.objects.active = obj
    assert bpy.ops.fantasia3d.guide_from_selection() == {"FINISHED"}
    assert bpy.context.scene.fantasia3d.guide == obj


def test_a_light_keeps_its_number_whichever_others_there_are(addon, monkeypatch):
    """A file saved in one Blender shows the same light in another."""
    from fantasia3d_addon.scene import light
    from fantasia3d_addon.ui import properties

    def numbers() -> dict[str, int]:
        properties.clear_light_items()
        return {item[0]: item[4] for item in properties.light_items(None, None)}

    before, here = numbers(), light.blender_lights()
    monkeypatch.setattr(light, "blender_lights", lambda: {"aurora": Path("x"), **here})
    after = numbers()
    assert after.items() > before.items()
    assert len(set(after.values())) == len(after)


def test_the_network_is_used_only_where_blender_and_the_user_allow_it(addon):
    machine = paths.Paths(bpy.context)
    assert machine.core_environ["HF_HUB_OFFLINE"] == "1"
