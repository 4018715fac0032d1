"""The add-on's names of events, fields and stages are those of the core; options are one thing."""

import ast
from dataclasses import fields
from pathlib import Path

import pytest

from fantasia3d_addon import options
from fantasia3d_addon.jobs.events import END_EVENTS, EVENTS, STAGES, Event, stages_of

ROOT = Path(__file__).parents[1]


def test_the_events_are_the_cores():
    pytest.importorskip("torch")
    from core.io import job

    assert job.EVENTS == EVENTS
    assert set(END_EVENTS) <= set(EVENTS)


def words_of_the_core() -> set[str]:
    """All string constants and names of keyword arguments of the core, but for its tests."""
    files = [path for path in (ROOT / "core").rglob("*.py") if "tests" not in path.parts]
    nodes = [node for path in files for node in ast.walk(ast.parse(path.read_text("utf-8")))]
    words = {node.value for node in nodes if isinstance(node, ast.Constant)}
    words |= {node.arg for node in nodes if isinstance(node, ast.keyword)}
    return {word for word in words if isinstance(word, str)}


def test_the_core_has_every_stage_and_every_field_of_an_event():
    names = {*STAGES, *(field.name for field in fields(Event))}
    assert names - words_of_the_core() == set()


@pytest.mark.parametrize(
    ("job", "stages"),
    [
        ({}, "fit geometry unwrap appearance bake"),
        ({"command": "texture"}, "unwrap appearance bake"),
        ({"command": "texture", "uv": "keep"}, "appearance bake"),
        (
            {"command": "texture", "uv": "keep", "base_color": "c.png"},
            "start appearance bake",
        ),
    ],
)
def test_a_job_has_its_stages_in_order(job, stages):
    assert stages_of(job) == tuple(stages.split())


DECLARED = [value for value in vars(options).values() if isinstance(value, options.Option)]


@pytest.mark.parametrize("option", DECLARED, ids=lambda option: f"{option.name} {option.label}")
def test_an_options_default_is_in_its_range_and_it_has_a_tooltip(option):
    assert option.tip and option.label
    if option.items:
        assert option.default in option.names
    elif not isinstance(option.default, str):
        assert option.allows(option.default)
        assert not option.allows(float("nan"))
        assert not option.allows(float("inf"))


def test_an_option_is_the_same_in_operator_panel_and_function(request):
    bpy = pytest.importorskip("bpy")
    request.getfixturevalue("addon")
    from fantasia3d_addon.physics.simulation import Options

    operator = bpy.ops.fantasia3d.simulate.get_rna_type().properties
    panel = bpy.context.scene.fantasia3d_tools.bl_rna.properties
    for option in options.SIMULATION:
        assert getattr(Options(), option.name) == option.default
        for properties in (operator, panel):
            prop = properties[option.name]
            assert (prop.default, prop.name, prop.description) == (
                option.default,
                option.label,
                option.tip,
            )
            if option.high is not None:
                assert (prop.hard_min, prop.hard_max) == (option.low, option.high)


def test_every_property_has_a_tooltip(request):
    bpy = pytest.importorskip("bpy")
    request.getfixturevalue("addon")
    from fantasia3d_addon.ui.registration import CLASSES

    silent = [
        f"{cls.__name__}.{prop.identifier}"
        for cls in CLASSES
        if issubclass(cls, (bpy.types.PropertyGroup, bpy.types.AddonPreferences))
        or (issubclass(cls, bpy.types.Operator) and cls.__name__ != "FANTASIA3D_OT_preset_add")
        for prop in rna_of(bpy, cls).properties
        if prop.identifier not in ("rna_type", "name", "bl_idname", "entries")
        and not prop.is_hidden
        and not prop.description
    ]
    assert silent == []


def rna_of(bpy, cls):
    if not issubclass(cls, bpy.types.Operator):
        return cls.bl_rna
    return getattr(bpy.ops.fantasia3d, cls.bl_idname.partition(".")[2]).get_rna_type()
