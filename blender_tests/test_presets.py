"""Saved settings: Blender's own presets, in the user's own folder."""

from pathlib import Path

import pytest

bpy = pytest.importorskip("bpy")

from fantasia3d_addon.ui import presets  # noqa: E402

pytestmark = [pytest.mark.blender, pytest.mark.usefixtures("empty", "addon")]


@pytest.fixture
def scripts(tmp_path, monkeypatch):
    """A folder of the user's for presets."""
    real = bpy.utils.user_resource

    def folder(kind: str, *, path: str = "", create: bool = False) -> str:
        if kind != "SCRIPTS":
            return real(kind, path=path, create=create)
        place = tmp_path / "scripts" / path
        if create:
            place.mkdir(parents=True, exist_ok=True)
        return str(place)

    monkeypatch.setattr(bpy.utils, "user_resource", folder)
    # Blender names the menu after the preset that was saved last.
    menu = presets.FANTASIA3D_PT_presets
    monkeypatch.setattr(menu, "bl_label", menu.bl_label)
    return tmp_path / "scripts" / "presets" / presets.FOLDER


def test_a_preset_restores_the_settings_but_not_the_prompt(scripts):
    settings = bpy.context.scene.fantasia3d
    settings.prompt, settings.seed, settings.max_faces = "a chair", 7, 1234
    settings.light, settings.guidance, settings.hub_id = "blender:forest", "hub", "some/model"
    assert bpy.ops.fantasia3d.preset_add(name="My Look") == {"FINISHED"}
    (file,) = scripts.glob("*.py")
    assert file.stem == "My_Look"
    for name in settings.bl_rna.properties.keys():  # noqa: SIM118
        if name not in ("rna_type", "name"):
            settings.property_unset(name)
    settings.prompt, settings.seed = "a mug", 8
    exec(compile(Path(file).read_text(), str(file), "exec"), {"bpy": bpy})
    assert (settings.prompt, settings.seed) == ("a mug", 8)
    assert (settings.max_faces, settings.light, settings.hub_id) == (
        1234,
        "blender:forest",
        "some/model",
    )


def test_every_saved_field_is_one_of_the_settings():
    """And every setting but the prompt, the seed, the task and the object is saved."""
    fields = {p.identifier for p in bpy.context.scene.fantasia3d.bl_rna.properties}
    left = {"rna_type", "name", "task", "prompt", "seed", "guide"}
    assert set(presets.SAVED) == fields - left
