"""The menu of models: what the core found, and what a choice does."""

import json
import struct

import pytest

bpy = pytest.importorskip("bpy")

from fantasia3d_addon.jobs import models  # noqa: E402
from fantasia3d_addon.jobs.paths import Paths  # noqa: E402
from fantasia3d_addon.jobs.session import session  # noqa: E402

pytestmark = [pytest.mark.blender]


def write(path, name, shape=(1, 1)):
    """A safetensors file of one tensor of zeros."""
    size = 4 * shape[0] * shape[1]
    entry = {name: {"dtype": "F32", "shape": shape, "data_offsets": [0, size]}}
    header = json.dumps(entry).encode()
    path.write_bytes(struct.pack("<Q", len(header)) + header + bytes(size))


@pytest.fixture
def found(addon, tmp_path):
    """The core's answer for a folder with a LoRA, an embedding and a pickle."""
    write(tmp_path / "style.safetensors", "lora_unet_x.lora_down.weight")
    write(tmp_path / "word.safetensors", "emb_params", (1, 768))
    (tmp_path / "old.ckpt").write_bytes(b"x")
    core = Paths(bpy.context).core
    return models.ask(core._replace(environ={"HF_HUB_CACHE": str(tmp_path)}))


def test_the_core_lists_what_can_be_used_and_why_the_rest_cannot(found):
    kinds = {model["kind"]: model["reason"] for model in found}
    assert kinds.keys() == {"LoRA", "textual inversion", "pickled"}
    assert "never opened" in kinds["pickled"]
    usable = models.usable(found)
    assert [model["kind"] for model in usable] == ["LoRA", "textual inversion"]
    assert models.label(usable[0]) == "style.safetensors (LoRA, 0.0 GB)"


def test_another_tools_models_are_offered_too(addon, tmp_path, monkeypatch):
    hub, tool = tmp_path / "hub", tmp_path / "ComfyUI" / "models" / "loras"
    hub.mkdir()
    tool.mkdir(parents=True)
    write(hub / "word.safetensors", "emb_params", (1, 768))
    write(tool / "style.safetensors", "lora_unet_x.lora_down.weight")
    core = Paths(bpy.context).core._replace(environ={"HF_HUB_CACHE": str(hub)})
    found = models.ask_all(core, tmp_path / "ComfyUI")
    assert {model["kind"] for model in found} == {"LoRA", "textual inversion"}
    assert models.ask_all(core, None) == [model for model in found if model["kind"] != "LoRA"]
    assert models.ask_all(core, tmp_path / "gone") == models.ask_all(core, None)
    # The session asks with the folder of the preferences.
    asked = []
    monkeypatch.setattr(models, "ask_all", lambda _core, folder: asked.append(folder) or [])
    monkeypatch.setattr(Paths, "tool", tmp_path / "ComfyUI")
    session.find_models()
    session.models._task.join(10)
    session.tick()
    assert asked == [tmp_path / "ComfyUI"]


def test_a_choice_fills_the_field_that_it_is_for(addon, tmp_path):
    settings = bpy.context.scene.fantasia3d
    for kind, path in (("LoRA", "/l"), ("textual inversion", "/e"), ("Stable Diffusion 1", "/m")):
        bpy.ops.fantasia3d.choose_model(path=path, kind=kind)
    assert (settings.lora, settings.embedding) == ("/l", "/e")
    assert (settings.guidance, settings.model_folder) == ("folder", "/m")


def test_the_session_asks_once_and_takes_the_answer(addon, monkeypatch):
    answer = [{"path": "/m", "kind": "LoRA", "bytes": 1, "reason": ""}]
    asked = []
    monkeypatch.setattr(models, "ask", lambda core, folder=None: asked.append(core) or answer)
    assert session.found_models() is None
    session.models._task.join(10)
    assert session.found_models() is None
    session.tick()
    assert session.found_models() == answer
    assert len(asked) == 1


def test_a_model_of_the_hub_has_its_own_name():
    path = "/hub/models--some--model/snapshots/abc"
    shown = {"path": path, "kind": "StableDiffusionPipeline", "bytes": 2e9}
    assert models.label(shown) == "some/model (StableDiffusionPipeline, 2.0 GB)"
