"""Every operator is found by search, has a tooltip, and states why it is disabled."""

import re
from pathlib import Path

import pytest

bpy = pytest.importorskip("bpy")

from blender_tests.asset_fixture import write_asset, write_png  # noqa: E402
from fantasia3d_addon.scene import light  # noqa: E402
from fantasia3d_addon.ui import menus, registration  # noqa: E402

pytestmark = [pytest.mark.blender]
CLASSES = registration.CLASSES
GENERATE = Path(registration.__file__).with_name("generate_panel.py")
OPERATORS = {
    cls.bl_idname.partition(".")[2]: cls for cls in CLASSES if issubclass(cls, bpy.types.Operator)
}
# Buttons of one word, one file or one preset: they need what only their place knows.
IN_PLACE = {"add_word", "replace_word", "import_file", "preset_add", "choose_model"}


class Layout:
    """A layout that follows submenus and keeps the operators that F3 would find."""

    def __init__(self, found: dict[str, str]) -> None:
        self.found = found

    def operator(self, name: str, text: str = "", **_more: object) -> "Layout":
        self.found[name.partition(".")[2]] = text
        return self

    def menu(self, name: str, **_more: object) -> None:
        draw_menu(name, self.found)

    def separator(self) -> None:
        pass


def draw_menu(name: str, found: dict[str, str]) -> None:
    menu = type("Menu", (), {"layout": Layout(found)})()
    getattr(bpy.types, name).draw(menu, bpy.context)


def test_every_operator_is_in_a_menu_under_a_name_with_the_add_ons(addon, asset):
    found: dict[str, str] = {}
    for _, draw in menus.ENTRIES:
        draw(type("Menu", (), {"layout": Layout(found)})(), bpy.context)
    assert set(found) | IN_PLACE == set(OPERATORS)
    assert all(text.startswith("Fantasia3D: ") for text in found.values())
    assert len(set(found.values())) == len(found)  # no two under one name


def test_blenders_menus_have_the_entries_and_lose_them_again(empty):
    import fantasia3d_addon

    def counts() -> list[int]:
        return [len(getattr(bpy.types, menu)._dyn_ui_initialize()) for menu, _ in menus.ENTRIES]

    before = counts()
    fantasia3d_addon.register()
    assert counts() == [count + 1 for count in before]
    fantasia3d_addon.unregister()
    assert counts() == before


def test_no_two_parts_of_the_panel_have_one_name():
    """Panels, and the parts of Generate from Text."""
    panels = [cls.bl_label for cls in CLASSES if issubclass(cls, bpy.types.Panel)]
    parts = re.findall(r'collapsible\(layout, "\w+", "([\w ]+)"\)', GENERATE.read_text("utf-8"))
    assert {"Light", "Output"} <= set(parts)
    assert len({*panels, *parts}) == len(panels) + len(parts)


def test_the_pie_menus_operators_exist():
    assert {name for name, _ in (*menus.PIE, *menus.CONTEXT)} <= set(OPERATORS)
    assert len(menus.PIE) == 8


@pytest.mark.parametrize("name", OPERATORS)
def test_an_operator_has_a_tooltip(name):
    assert 10 < len(OPERATORS[name].__doc__) < 120
    assert not OPERATORS[name].__doc__.endswith(".")  # Blender adds it


def annotated(cls: type) -> set[str]:
    """The properties that the add-on declares for a class, those of its mixins too."""
    ours = [base for base in cls.__mro__ if base.__module__.startswith("fantasia3d_addon")]
    return {name for base in ours for name in vars(base).get("__annotations__", {})}


def test_every_property_has_a_name_and_a_tooltip(addon):
    kinds = (bpy.types.Operator, bpy.types.PropertyGroup, bpy.types.AddonPreferences)
    lacking = [
        f"{cls.__name__}.{prop.identifier}"
        for cls in CLASSES
        if issubclass(cls, kinds)
        for prop in cls.bl_rna.properties
        if prop.identifier in annotated(cls) and not prop.is_hidden
        if not (prop.name and prop.description) or prop.description.endswith(".")
    ]
    assert lacking == []


@pytest.mark.parametrize("name", [n for n, cls in OPERATORS.items() if hasattr(cls, "poll")])
def test_a_disabled_operator_states_why(addon, name):
    """In an empty scene, where nothing runs; some are enabled even there."""
    operator = getattr(bpy.ops.fantasia3d, name)
    if operator.poll():
        return
    with pytest.raises(RuntimeError) as caught:
        operator()
    assert "context is incorrect" not in str(caught.value)


def test_a_dropped_asset_json_or_glb_is_the_asset(addon, tmp_path):
    folder = write_asset(tmp_path / "asset")
    (folder / "asset.glb").touch()
    for name in ("asset.json", "asset.glb"):
        assert bpy.ops.fantasia3d.import_file(filepath=str(folder / name)) == {"FINISHED"}
    first, second = (obj for obj in bpy.data.objects if obj.type == "MESH")
    assert len(first.data.vertices) == len(second.data.vertices)
    assert second.location != first.location


def test_a_dropped_glb_of_another_program_is_imported_and_a_broken_one_reported(addon, tmp_path):
    bpy.ops.mesh.primitive_cube_add()
    path = tmp_path / "other.glb"
    bpy.ops.export_scene.gltf(filepath=str(path))
    before = len(bpy.data.objects)
    bpy.ops.fantasia3d.import_file(filepath=str(path))
    assert len(bpy.data.objects) > before
    (tmp_path / "broken.glb").write_bytes(b"no")
    with pytest.raises(RuntimeError, match="can't be imported"):
        bpy.ops.fantasia3d.import_file(filepath=str(tmp_path / "broken.glb"))


def test_a_dropped_light_lights_the_scene(addon, tmp_path):
    assert bpy.ops.fantasia3d.relight(filepath=str(light.STUDIO_FILE)) == {"FINISHED"}
    assert light.environment_image(bpy.context.scene.world)
    write_png(tmp_path / "no.png", __import__("numpy").zeros((2, 2, 3), "uint8"))
    with pytest.raises(RuntimeError):
        bpy.ops.fantasia3d.relight(filepath=str(tmp_path / "missing.hdr"))


def test_the_handlers_take_what_they_are_for(addon):
    from fantasia3d_addon.ui import drop_files

    endings = {
        handler.bl_import_operator: set(handler.bl_file_extensions.split(";"))
        for handler in (drop_files.FANTASIA3D_FH_asset, drop_files.FANTASIA3D_FH_light)
    }
    assert endings == {
        "fantasia3d.import_file": {".json", ".glb"},
        "fantasia3d.relight": {".hdr", ".exr"},
    }
    assert not drop_files.FANTASIA3D_FH_asset.poll_drop(bpy.context)  # no 3D view here


def test_online_access_is_allowed_by_one_button(addon, monkeypatch):
    from fantasia3d_addon.jobs import environment_setup

    system = bpy.context.preferences.system
    system.use_online_access = False
    if not bpy.app.online_access_override:
        assert "online access" in environment_setup.reason_against()
        assert bpy.ops.fantasia3d.allow_online_access() == {"FINISHED"}
        assert bpy.app.online_access
        assert environment_setup.reason_against() == ""
        assert not bpy.ops.fantasia3d.allow_online_access.poll()
        system.use_online_access = False
