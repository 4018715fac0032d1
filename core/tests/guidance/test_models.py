"""The list of models: what can be used, and a sentence for what cannot."""

import json
import shutil
from pathlib import Path

import pytest
import torch
from safetensors.torch import save_file

from core.command_line import main
from core.errors import MissingError, UserError
from core.guidance.stable_diffusion.checkpoint import find_checkpoint
from core.guidance.stable_diffusion.models import models_folder, models_in, table
from core.tests.one_file import write_one_file


@pytest.fixture
def comfy(checkpoints, tmp_path):
    """A folder of another tool with one of each."""
    root = tmp_path / "ComfyUI"
    place = root / "models" / "checkpoints"
    (root / "models" / "loras").mkdir(parents=True)
    place.mkdir()
    write_one_file(checkpoints["1.x"], place / "dream.safetensors")
    shutil.copytree(checkpoints["2.x"], root / "models" / "diffusers" / "two")
    (place / "old.ckpt").write_bytes(b"\x80\x04cos\nsystem\n(S'touch opened'\ntR.")
    (place / "half.safetensors").write_bytes((place / "dream.safetensors").read_bytes()[:90000])
    save_file({"a.lora_down.weight": torch.zeros(1, 1)}, root / "models/loras/style.safetensors")
    save_file({"x.y": torch.zeros(1)}, place / "thing.safetensors")
    (root / "notes.safetensors").write_bytes(b"not looked at: the usual folders are there")
    return root


def test_each_file_has_its_kind_its_size_and_why_it_cannot_be_used(comfy):
    found = {m.path.removeprefix(str(comfy / "models")): m for m in models_in([comfy])}
    kinds = {path: (model.kind, bool(model.reason)) for path, model in found.items()}
    assert kinds == {
        "/checkpoints/dream.safetensors": ("Stable Diffusion 1", False),
        "/checkpoints/half.safetensors": ("broken", True),
        "/checkpoints/old.ckpt": ("pickled", True),
        "/checkpoints/thing.safetensors": ("unknown", True),
        "/diffusers/two": ("StableDiffusionPipeline", False),
        "/loras/style.safetensors": ("LoRA", False),
    }
    assert "cut short" in found["/checkpoints/half.safetensors"].reason
    assert "never opened" in found["/checkpoints/old.ckpt"].reason
    assert found["/checkpoints/dream.safetensors"].bytes > 100_000
    weights = comfy.glob("models/diffusers/two/*/*.safetensors")
    assert found["/diffusers/two"].bytes == sum(file.stat().st_size for file in weights)


def test_the_command_prints_a_table_or_json(comfy, capsys):
    assert main(["models", str(comfy), "--json"]) == 0
    found = json.loads(capsys.readouterr().out)
    assert len(found) == 6
    assert {"path", "kind", "bytes", "reason"} == found[0].keys()
    assert main(["models", str(comfy)]) == 0
    text = capsys.readouterr().out
    usable = text.splitlines()[:3]  # before those that cannot be used, each with its reason
    assert [line.split("/")[-1] for line in usable] == [
        "dream.safetensors",
        "two",
        "style.safetensors",
    ]
    assert text.count("cannot be used") == 3


def test_no_folder_is_the_hubs_cache_and_a_missing_one_is_a_sentence(
    comfy, checkpoints, tmp_path, monkeypatch
):
    hub = tmp_path / "hub"
    snapshot = hub / "models--a--b" / "snapshots" / "123"
    snapshot.parent.mkdir(parents=True)
    shutil.copytree(checkpoints["1.x"], snapshot)
    monkeypatch.setenv("HF_HUB_CACHE", str(hub))
    (model,) = models_in([])
    assert model.path == str(snapshot) and not model.reason
    with pytest.raises(UserError, match="There is no folder"):
        models_in([tmp_path / "none"])
    monkeypatch.setenv("HF_HUB_CACHE", str(tmp_path / "empty"))
    assert table(models_in([])) == "No models found."


def test_the_hubs_cache_is_where_the_hub_has_it(monkeypatch):
    for name in ("HF_HUB_CACHE", "HF_HOME"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setenv("XDG_CACHE_HOME", "/caches")
    assert models_folder() == Path("/caches/huggingface/hub")
    monkeypatch.setenv("HF_HOME", "/home/of/hf")
    assert models_folder() == Path("/home/of/hf/hub")


def test_the_home_of_nobody_is_no_folder():
    with pytest.raises(UserError, match="There is no folder"):
        models_in([Path("~nobody-here/models")])
    with pytest.raises(MissingError, match="There is no folder"):
        find_checkpoint("~nobody-here/model")
