"""Every string of the interface has its German one, and Blender uses it."""

import ast
import inspect
from collections.abc import Iterator
from pathlib import Path

import pytest

bpy = pytest.importorskip("bpy")

from fantasia3d_addon.jobs import events  # noqa: E402
from fantasia3d_addon.mesh import health  # noqa: E402
from fantasia3d_addon.ui import registration, tools_panel, translations, words_menu  # noqa: E402
from fantasia3d_addon.ui.text import SENTENCES, VALUES, in_language  # noqa: E402

pytestmark = [pytest.mark.blender]
ADDON = Path(__file__).parents[1] / "fantasia3d_addon"
GERMAN = translations.read_po(translations.LOCALE / "de.po")
NO_PANEL = ("cli", "environment")  # their errors end a command
SHOWN = ("text", "placeholder", "heading")  # keywords of a layout's functions


def of_classes() -> Iterator[str]:
    """Labels, tooltips, names and descriptions of what is registered."""
    for cls in registration.CLASSES:
        if cls in words_menu.GROUP_MENUS:
            continue
        yield getattr(cls, "bl_label", "")
        if issubclass(cls, bpy.types.Operator):
            yield inspect.cleandoc(cls.__doc__)
        ours = [base for base in cls.__mro__ if base.__module__.startswith("fantasia3d_addon")]
        names = {name for base in ours for name in vars(base).get("__annotations__", {})}
        for prop in cls.bl_rna.properties:
            if prop.identifier in names and not prop.is_hidden:
                yield from (prop.name, prop.description)
                for item in getattr(prop, "enum_items_static", ()):
                    yield from (item.name, item.description)


def constants(node: ast.AST) -> Iterator[str]:
    """String constants, those of a choice included; f-strings are not messages."""
    if isinstance(node, ast.Constant) and isinstance(node.value, str):
        yield node.value
    elif isinstance(node, ast.IfExp):
        yield from constants(node.body)
        yield from constants(node.orelse)


def sentences(text: str) -> list[str]:
    """Those of a message that end as one; the rest is a part of one."""
    return [each for each in SENTENCES.split(text) if each.endswith(".")]


def of_panels() -> Iterator[str]:
    """What the panels draw, and why something can't be done now."""
    for path in ADDON.rglob("*.py"):
        tree = ast.parse(path.read_text("utf-8"))
        for node in ast.walk(tree):
            if isinstance(node, ast.Call):
                name = ast.unparse(node.func).rpartition(".")[2]
                if path.parent.name == "ui":
                    for keyword in node.keywords:
                        yield from constants(keyword.value) if keyword.arg in SHOWN else ()
                if name in ("allowed", "can_run", "needs"):
                    yield from (text for arg in node.args for text in constants(arg))
                if name == "wrapped_label" and len(node.args) > 2:
                    yield from constants(node.args[2])
                if name == "collapsible":
                    yield from constants(node.args[2])
                if name in ("translated", "in_language"):
                    yield from constants(node.args[0])
                if name.endswith("Error") and path.parent.name not in NO_PANEL:
                    found = (text for arg in node.args for text in constants(arg))
                    yield from (each for text in found for each in sentences(text))
            if isinstance(node, ast.FunctionDef) and node.name.lstrip("_").startswith("reason"):
                for found in ast.walk(node):
                    yield from constants(found.value) if isinstance(found, ast.Return) else ()


def messages() -> set[str]:
    found = {*of_classes(), *of_panels(), *events.STAGES.values()}
    return {text for text in found if any(char.isalpha() for char in text)}


def test_every_string_has_a_german_one(addon):
    lacking = sorted(messages() - set(GERMAN))
    assert lacking == []


def test_a_message_of_sentences_and_values_is_translated():
    german = {"No model is chosen.": "Kein Modell.", "{} of {}, {} left": "{} von {}, noch {}",
              "{} is running.": "{} läuft.", "Shape": "Form"}  # fmt: skip

    def shown(text: str) -> str:
        return in_language(text, lambda message: german.get(message, message))

    assert shown("No model is chosen. Enter one.") == "Kein Modell. Enter one."
    assert shown("2 of 10, 1:05 left") == "2 von 10, noch 1:05"
    assert shown("“Shape” is running.") == "“Form” läuft."
    assert shown("a red chair, 1.5 m {tall}") == "a red chair, 1.5 m {tall}"


@pytest.mark.parametrize("count", [0, 1, 2])
def test_every_line_of_a_mesh_report_has_a_german_one(count):
    for uv_fill in (None, 0.64):
        report = health.Report(
            verts=count, faces=count, triangles=2, components=count, small_components=0, loose=0,
            doubled=count, degenerate=0, open_edges=count, nonmanifold=count, inverted=count > 0,
            scaled=False, uv_fill=uv_fill, uv_overlap=0.1 * count, texel_density=570.0 * count,
            textures=(),
        )  # fmt: skip
        for text, _ in tools_panel.lines(report):
            assert VALUES.sub("{}", text) in GERMAN, text


def test_the_test_sees_what_is_drawn(addon):
    """Or it would pass for an empty set."""
    found = messages()
    assert len(found) > 300
    assert found >= {"Installation required", "Select a mesh.", "Drop to Surface", "Draft"}


def test_the_words_groups_have_german_names():
    pytest.importorskip("torch")
    from core.guidance.builtin.words.groups import word_groups

    assert {group["name"] for group in word_groups()} <= set(GERMAN)


def test_translations_keep_what_must_stay():
    for english, german in GERMAN.items():
        assert german
        assert not german.endswith(".") or english.endswith(".")
        for word in ("model_index.json", "geometry.fine.steps=100", "z = 0", ".glb", "1 %"):
            assert (word in english) == (word in german)


def test_blender_shows_german(addon):
    view = bpy.context.preferences.view
    language = view.language
    codes = bpy.app.translations.locales
    code = next((code for code in ("de_DE", "de") if code in codes), None)
    if code is None:
        pytest.skip("this build has no other languages")
    try:
        view.language = code
        view.use_translate_interface = True
        shown = bpy.app.translations.pgettext_iface("Drop to Surface", "Operator")
        assert shown == "Auf Oberfläche ablegen"
    finally:
        view.language = language
