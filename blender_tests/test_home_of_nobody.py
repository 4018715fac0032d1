"""A path in the home folder of nobody is a sentence, wherever it is entered."""

import ast
import os
import sys
from pathlib import Path

import pytest

bpy = pytest.importorskip("bpy")

from fantasia3d_addon import environment  # noqa: E402
from fantasia3d_addon.asset.import_asset import import_asset  # noqa: E402
from fantasia3d_addon.blender.output import temporary_output  # noqa: E402
from fantasia3d_addon.environment.given import given_python, named_python  # noqa: E402
from fantasia3d_addon.environment.report import write_report  # noqa: E402
from fantasia3d_addon.errors import AddonError, OutputError  # noqa: E402
from fantasia3d_addon.jobs import environment_setup, job_settings, print_export  # noqa: E402
from fantasia3d_addon.jobs import submit as jobs_submit  # noqa: E402
from fantasia3d_addon.jobs.paths import Paths  # noqa: E402
from fantasia3d_addon.jobs.process import Core  # noqa: E402
from fantasia3d_addon.jobs.session import session  # noqa: E402
from fantasia3d_addon.mesh import engines, export  # noqa: E402
from fantasia3d_addon.scene import light, relight  # noqa: E402

pytestmark = [pytest.mark.blender, pytest.mark.usefixtures("empty")]
NOWHERE = "~no-one/x"
SENTENCE = "There is no home folder '~no-one', as in '~no-one/x"
ADDON = Path(environment.__file__).parents[1]
# The functions for all; the command line, which looks before Blender starts.
MAY_EXPAND = {"environment/files.py", "cli/parser.py"}


@pytest.fixture
def obj(asset):
    return import_asset(bpy.context.scene, asset, (0, 0, 0))


def test_an_output_is_refused(obj, tmp_path):
    core = Core(Path(sys.executable), tmp_path)
    with pytest.raises(OutputError, match=SENTENCE), temporary_output(Path(NOWHERE)):
        pass
    with pytest.raises(OutputError, match=SENTENCE), relight.whole_turntable(Path(NOWHERE)):
        pass
    for write in (
        lambda: export.export_object(obj, Path(NOWHERE + ".glb")),
        lambda: engines.export_for(obj, Path(NOWHERE), "godot"),
        lambda: print_export.export_print(obj, Path(NOWHERE + ".stl"), core),
        lambda: relight.turntable(obj, Path(NOWHERE)),
    ):
        with pytest.raises(OutputError, match=SENTENCE):
            write()


def test_the_panels_files_are_refused(addon):
    settings = bpy.context.scene.fantasia3d
    settings.prompt, settings.guidance, settings.model_folder = "a chair", "folder", NOWHERE
    for refuse in (
        lambda: light.light_file(NOWHERE),
        lambda: job_settings.job_of(settings),
        lambda: job_settings._safetensors(NOWHERE, "LoRA"),
    ):
        with pytest.raises(AddonError, match=SENTENCE):
            refuse()
    assert SENTENCE in jobs_submit.reason_against_generate(bpy.context)  # as the panel shows it


@pytest.mark.parametrize("name", ["FANTASIA3D_ENV", "FANTASIA3D_PYTHON"])
def test_a_variable_is_refused_and_the_panels_say_why(addon, monkeypatch, name):
    monkeypatch.delenv("FANTASIA3D_PYTHON", raising=False)
    monkeypatch.setenv(name, NOWHERE)
    with pytest.raises(environment.SetupError, match=SENTENCE):
        _ = Paths(bpy.context).python
    assert not environment_setup.is_installed()
    assert SENTENCE in jobs_submit.reason_against_jobs(bpy.context)
    if name == "FANTASIA3D_ENV":
        assert SENTENCE in environment_setup.reason_against()
        assert SENTENCE in environment_setup.reason_against_removal()


def test_the_preferences_folder_of_runs_is_told_and_nothing_stops(addon, monkeypatch):
    class Preferences:
        runs_folder = NOWHERE

    monkeypatch.setattr(
        Paths, "__init__", lambda self, _: setattr(self, "_preferences", Preferences)
    )
    for call in (session.refresh, lambda: session.adopt(bpy.context)):
        session.error = None
        call()
        assert session.error and SENTENCE in session.error[0]


def test_the_environments_own_paths_are_refused(monkeypatch):
    with pytest.raises(environment.SetupError, match=SENTENCE):
        given_python(NOWHERE, ())
    with pytest.raises(environment.SetupError, match=SENTENCE):
        write_report(Path(NOWHERE), environment.project_root(), [])


def test_a_given_python_is_the_same_to_all_who_ask(addon, monkeypatch):
    """doctor, its report and the panel took the ~ for a folder of that name."""
    monkeypatch.setenv("HOME", str(Path(sys.executable).parent))
    monkeypatch.setenv("FANTASIA3D_PYTHON", f"~{os.sep}{Path(sys.executable).name}")
    assert named_python() == sys.executable
    assert Paths(bpy.context).own_python == Path(sys.executable)


def test_one_function_expands_a_home_folder():
    found = {
        path.relative_to(ADDON).as_posix()
        for path in ADDON.rglob("*.py")
        for node in ast.walk(ast.parse(path.read_text("utf-8")))
        if isinstance(node, ast.Attribute) and node.attr == "expanduser"
    }
    assert found == MAY_EXPAND
