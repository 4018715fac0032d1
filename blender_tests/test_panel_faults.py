"""Between the panel and a job: errors are reported, and the next action still works."""

import ast
import errno
import os
import re
import signal
import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace

import pytest

bpy = pytest.importorskip("bpy")

from blender_tests.asset_fixture import write_asset  # noqa: E402
from fantasia3d_addon.asset.import_asset import import_asset  # noqa: E402
from fantasia3d_addon.cli import headless  # noqa: E402
from fantasia3d_addon.environment import SetupError  # noqa: E402
from fantasia3d_addon.errors import AddonError, OutputError  # noqa: E402
from fantasia3d_addon.jobs import (  # noqa: E402
    history,
    job_settings,
    memory,
    panels,
    print_export,
    process,
    submit,
)
from fantasia3d_addon.jobs.lock import RunLock  # noqa: E402
from fantasia3d_addon.jobs.new_run import write_run  # noqa: E402
from fantasia3d_addon.jobs.process import Core  # noqa: E402
from fantasia3d_addon.jobs.progress import Progress  # noqa: E402
from fantasia3d_addon.jobs.session import session  # noqa: E402
from fantasia3d_addon.jobs.target import Target  # noqa: E402
from fantasia3d_addon.material import edit as material_edit  # noqa: E402
from fantasia3d_addon.scene import light, relight  # noqa: E402
from fantasia3d_addon.ui import (  # noqa: E402
    job_panel,
    mesh_operators,
    modal_operator,
    registration,
    tools_panel,
    translations,
)
from fantasia3d_addon.ui import text as panel_text  # noqa: E402
from fantasia3d_addon.ui.operator_helpers import run_and_report  # noqa: E402
from fantasia3d_addon.ui.text import in_language  # noqa: E402

pytestmark = [pytest.mark.blender, pytest.mark.usefixtures("empty")]
UI = Path(registration.__file__).parent
GERMAN = translations.read_po(translations.LOCALE / "de.po")


class Layout:
    """A layout that takes everything, and keeps the texts."""

    def __init__(self, texts: list[str]) -> None:
        self.texts = texts

    def __getattr__(self, name: str):
        def draw(*_args: object, text: str = "", **_more: object) -> "Layout":
            self.texts.append(text)
            return Layout(self.texts)

        return draw


def drawn(panel: type) -> list[str]:
    texts: list[str] = []
    panel.draw(SimpleNamespace(layout=Layout(texts)), bpy.context)
    return texts


# The queue and the history


def test_a_job_behind_one_that_cannot_start_is_started(ready, wait, tmp_path, monkeypatch):
    """The head of the queue fails at the request of the next one, which nothing called then."""
    started: list[object] = []
    monkeypatch.setattr(session, "start_timer", lambda: started.append(1))
    first = write_run(tmp_path / "runs", {"prompt": "x", "seed": 0}, Target(), {})
    (first / "events.jsonl").write_text("")
    session.waiting.append((first, RunLock.acquire(first)))
    (first / "log.txt").mkdir()  # so that it cannot start
    with pytest.raises(AddonError, match="can't be written"):
        submit.generate(bpy.context)
    assert len(session.waiting) == 1
    assert started
    wait()
    assert [obj.name for obj in bpy.data.objects] == ["a red wooden chair"]


def finished(ready, wait, runs: Path) -> history.Entry:
    submit.generate(bpy.context)
    wait()
    (entry,) = history.scan(runs)
    return entry


def test_an_asset_is_offered_once_however_often_the_jobs_are_refreshed(ready, wait, tmp_path):
    entry = finished(ready, wait, tmp_path / "runs")
    (entry.folder / "taken").unlink()
    for _ in range(3):
        bpy.ops.fantasia3d.refresh()
        wait()
    assert [missed.folder for missed in session.missed] == [entry.folder]
    bpy.ops.fantasia3d.job_remove(folder=str(entry.folder))
    assert session.missed == []  # and not any more when it is deleted


def test_a_run_that_waits_in_another_blender_is_not_deleted(tmp_path):
    run = write_run(tmp_path, {"prompt": "x", "seed": 0}, Target(), {})
    (entry,) = history.scan(tmp_path)
    assert entry.state == history.WAITING
    lock = RunLock.acquire(run)
    with pytest.raises(AddonError, match="A Blender waits for “x”"):
        history.remove(entry)
    lock.release()
    history.remove(entry)
    assert not run.exists()


def test_the_selected_run_stays_selected_when_another_comes(addon):
    jobs = bpy.context.window_manager.fantasia3d

    def show(*names: str) -> None:
        panels.update_list([history.Entry(folder=Path(name)) for name in names])

    show("/b", "/a")
    jobs.index = 1
    show("/c", "/b", "/a")
    assert jobs.entries[jobs.index].name == str(Path("/a"))
    show("/c", "/b")
    assert jobs.index == 2  # nothing is selected, and no other run in its place


def test_another_seed_is_another_material_too():
    job = {"prompt": "x", "command": "texture", "seed": 3, "color_seed": 8}
    entry = history.Entry(folder=Path("/x"), job=job)
    assert history.copy_of_job(entry)[0]["color_seed"] == 8
    assert "color_seed" not in history.copy_of_job(entry, seed=4)[0]


def test_candidates_need_no_seed_in_their_job():
    """Anybody may have written job.json."""
    group = history.Candidate(group="g", until="shape")
    entries = [history.Entry(folder=Path(name), candidate=group) for name in "ab"]
    assert history.open_candidates(entries) == entries


@pytest.mark.skipif(sys.platform == "win32", reason="groups of processes")
def test_a_process_that_leads_no_group_is_killed_alone():
    """A run of a script, which this Blender follows: Stop Now did nothing."""
    with subprocess.Popen(["sleep", "60"]) as child:
        assert os.getpgid(child.pid) != child.pid
        process.kill_process(child.pid)
        assert child.wait(10) == -signal.SIGKILL


def test_no_job_without_a_prompt(ready, tmp_path):
    ready.prompt = "  "
    for request in (submit.generate, submit.explore):
        with pytest.raises(AddonError, match="Enter a prompt"):
            request(bpy.context)
    assert not (tmp_path / "runs").exists()


# What the panel shows


@pytest.mark.parametrize(
    ("seconds", "text"), [(59.7, "1:00"), (119.6, "2:00"), (0.2, "0:00"), (3725.0, "62:05")]
)
def test_the_time_left_has_no_60_seconds(seconds, text):
    progress = Progress(("geometry",))
    progress.started, progress.stage, progress.seconds_left = True, "geometry", seconds
    assert progress.detail == f"Stage 1 of 1, {text} left in it"


def test_a_system_that_does_not_tell_its_free_memory(monkeypatch):
    """Such as Windows' first Linux: the panel was not drawn."""
    monkeypatch.setattr(memory.sys, "platform", "linux")
    monkeypatch.setattr(memory.Path, "read_text", lambda *_: "MemTotal: 8000 kB\n")
    assert memory.available() is None


def test_a_deleted_node_does_not_stop_a_panel(addon, asset, monkeypatch):
    monkeypatch.setattr(tools_panel, "wrapped_label", lambda *_args, **_more: None)
    obj = import_asset(bpy.context.scene, asset, (0, 0, 0))
    bpy.context.view_layer.objects.active = obj
    relight.relight(bpy.context.scene, light.STUDIO)
    nodes = bpy.context.scene.world.node_tree.nodes
    nodes.remove(light.light_node(bpy.context.scene.world, "Mapping"))
    assert "Strength" not in drawn(tools_panel.FANTASIA3D_PT_light)
    material_edit.adjust_material(obj.active_material, (1, 0, 0), 1.0, 1.0)
    nodes = obj.active_material.node_tree.nodes
    nodes.remove(material_edit.edit_nodes(obj.active_material)[0])
    texts = drawn(tools_panel.FANTASIA3D_PT_material)
    assert "Tint" not in texts and {"Roughness", "Metallic"} <= set(texts)


def test_a_name_that_is_too_long_is_no_model(addon):
    settings = bpy.context.scene.fantasia3d
    settings.prompt, settings.guidance = "a chair", "folder"
    for name in ("x" * 300, "x" * 300 + ".safetensors"):
        settings.model_folder = name
        assert "is not a Stable Diffusion model" in submit.reason_against_generate(bpy.context)
    with pytest.raises(AddonError, match="There is no LoRA"):
        job_settings._safetensors("x" * 300 + ".safetensors", "LoRA")


def test_a_refused_job_leaves_every_field(addon):
    settings = bpy.context.scene.fantasia3d
    settings.prompt, settings.seed, settings.light = "a chair", 9, "blender:forest"
    before = job_settings.job_of(settings)
    other = {"prompt": "a cow", "seed": 1, "preset": "paper", "loras": {"a": 1.0, "b": 1.0}}
    with pytest.raises(AddonError, match="several LoRA files"):
        job_settings.apply_job(settings, other)
    assert job_settings.job_of(settings) == before


def test_overrides_of_several_numbers_come_back_as_one_word(addon):
    settings = bpy.context.scene.fantasia3d
    given = {"geometry.radii": "0.6, 0.6, 0.6", "geometry.resolution": [12, 12]}
    job_settings.apply_job(settings, {"prompt": "a chair", "settings": given})
    back = {"geometry.radii": "0.6,0.6,0.6", "geometry.resolution": "12,12"}
    assert job_settings.overrides_of(settings) == back


def test_a_prompt_is_shown_as_it_was_written(addon, tmp_path, monkeypatch):
    """Blender has German words for Cube, Light and others, which were shown instead."""
    monkeypatch.setattr(panel_text, "in_language", str.upper)
    monkeypatch.setattr(panel_text, "wrapped", lambda words, _width: [words])
    write_run(tmp_path, {"prompt": "Cube", "seed": 0}, Target(), {})
    (entry,) = session.history = history.scan(tmp_path)
    shown: list[tuple[str, bool]] = []

    class Kept(Layout):
        def label(self, text: str = "", translate: bool = True, **_more: object) -> None:
            shown.append((text, translate))

        def row(self, **_more: object) -> "Kept":
            return self

        box = column = row

    layout = Kept([])
    item = SimpleNamespace(name=str(entry.folder))
    job_panel.FANTASIA3D_UL_runs.draw_item(None, None, layout, None, item, 0, None, "")
    job_panel._draw_entry(layout, bpy.context, entry)
    assert [each for each in shown if each[0].lower() == "cube"] == [("Cube", False)] * 2


@pytest.mark.parametrize(("name", "value"), [("size", 0.0005), ("max_faces", 99)])
def test_what_the_core_would_refuse_after_its_start_is_refused_here(addon, name, value):
    settings = bpy.context.scene.fantasia3d
    settings.prompt = "a chair"
    job = job_settings.job_of(settings)
    setattr(settings, name, value)
    with pytest.raises(AddonError, match="too (small|low)"):
        job_settings.job_of(settings)
    pytest.importorskip("torch")
    from core.errors import UserError
    from core.io.job import Job

    key = {"size": "size_m"}.get(name, name)
    with pytest.raises(UserError):
        Job(**job | {key: value})
    Job(**job | {key: {"size_m": job_settings.SMALLEST, "max_faces": job_settings.FEWEST}[key]})


# Tools


def test_a_tool_that_breaks_does_not_keep_the_others_from_starting(monkeypatch):
    """Whatever a step raised but an AddonError left it running for ever."""

    class Tool(modal_operator.ModalTask):
        title, _timer = "Thumbnail", None

        def steps(self, _context):
            raise OSError(errno.ENOSPC, "No space left on device")
            yield

    manager = SimpleNamespace(progress_end=lambda: None, event_timer_remove=lambda _: None)
    workspace = SimpleNamespace(status_text_set=lambda _: None)
    context = SimpleNamespace(window_manager=manager, workspace=workspace)
    tool = Tool()
    tool._steps = tool.steps(context)
    modal_operator.running[:] = [modal_operator.Running("Thumbnail")]
    with pytest.raises(OSError, match="No space"):
        tool.modal(context, SimpleNamespace(type="TIMER"))
    assert modal_operator.reason_to_wait() == ""


def test_an_export_that_hangs_or_cannot_start_is_a_sentence(addon, tmp_path, monkeypatch):
    obj = import_asset(bpy.context.scene, write_asset(tmp_path / "asset"), (0, 0, 0))
    core = Core(tmp_path, tmp_path)  # a folder is not a program
    with pytest.raises(OutputError, match="can't be started"):
        print_export.export_print(obj, tmp_path / "x.stl", core)
    hanging = tmp_path / "hanging"
    hanging.write_text("#!/bin/sh\nexec sleep 30\n")
    hanging.chmod(0o755)
    monkeypatch.setattr(print_export, "TIMEOUT", 0.2)
    core = Core(hanging, tmp_path)
    with pytest.raises(OutputError, match=r"x\.stl was not ready after"):
        print_export.export_print(obj, tmp_path / "x.stl", core)


def test_a_missing_installation_is_an_operators_sentence():
    output: list[str] = []
    operator = SimpleNamespace(report=lambda _kinds, text: output.append(text))

    def act() -> None:
        raise SetupError("There is no core.", "Install it.")

    assert run_and_report(operator, act) == {"CANCELLED"}
    assert output == ["There is no core. Install it."]


def test_an_export_into_a_folder_has_the_objects_name(addon, asset, tmp_path):
    """The file browser hands out the folder where no name was entered."""
    obj = import_asset(bpy.context.scene, asset, (0, 0, 0))
    bpy.context.view_layer.objects.active = obj
    (tmp_path / "out").mkdir()
    bpy.ops.fantasia3d.export(filepath=str(tmp_path / "out") + os.sep, format="obj")
    assert (tmp_path / "out" / f"{bpy.path.clean_name(obj.name)}.obj").is_file()
    assert not (tmp_path / "out.obj").exists()


def test_the_file_browser_warns_of_a_file_that_would_be_replaced(addon):
    for operator in ("export", "turntable"):
        assert "check_existing" in getattr(bpy.ops.fantasia3d, operator).get_rna_type().properties


# Translations


def test_every_reason_of_a_poll_is_translated():
    """Blender shows the text of poll_message_set as it is, but calls a function for it."""
    calls = [
        node
        for path in UI.glob("*.py")
        for node in ast.walk(ast.parse(path.read_text("utf-8")))
        if isinstance(node, ast.Call) and ast.unparse(node.func) == "cls.poll_message_set"
    ]
    assert [ast.unparse(call.args[0]) for call in calls] == ["in_language"]  # in one place
    helpers = {"allowed", "needs", "can_run", "super().poll"}
    polls = {
        f"{path.stem}.{cls.name}": {
            ast.unparse(found.value.func) if isinstance(found.value, ast.Call) else "none"
            for found in ast.walk(poll)
            if isinstance(found, ast.Return)
        }
        for path in UI.glob("*.py")
        for cls in ast.walk(ast.parse(path.read_text("utf-8")))
        # A panel is hidden, and gives no reason.
        if isinstance(cls, ast.ClassDef) and not re.search("_PT_|Panel", cls.name)
        for poll in cls.body
        if isinstance(poll, ast.FunctionDef) and poll.name == "poll"
    }
    assert len(polls) > 30
    assert {name: found for name, found in polls.items() if not found or found - helpers} == {}


def test_what_a_bug_stops_is_reported_in_german():
    def german(text: str) -> str:
        return in_language(text, lambda message: GERMAN.get(message, message))

    assert german("The jobs can't be followed. KeyError: x.").startswith("Die Aufträge ")
    assert german("“a cow” can't be followed. KeyError: x.").startswith("“a cow” kann nicht ")
    assert german("The asset “a cow” can't be imported. KeyError: x.").startswith("Das Asset ")
    for text in ("Repaired", mesh_operators.NOTHING, mesh_operators.NO_SCALE):
        assert text in GERMAN


# The command line


@pytest.mark.parametrize("encoding", ["latin-1", "utf-8"])
def test_the_cores_output_is_read_as_it_was_written(monkeypatch, capsys, encoding):
    """Windows' pipes have another encoding: a path's ü was shown as �."""
    monkeypatch.setenv("PYTHONIOENCODING", encoding)
    assert headless._run_core([sys.executable, "-c", "print('/Jürgen')"], {}) == 0
    assert capsys.readouterr().out == "/Jürgen\n"


def test_the_cores_reason_is_read_as_it_was_written(monkeypatch, tmp_path):
    monkeypatch.setenv("PYTHONIOENCODING", "latin-1")
    (tmp_path / "core").mkdir()
    (tmp_path / "core" / "__main__.py").write_text("raise SystemExit('error: no /Jürgen')", "utf-8")
    core = Core(Path(sys.executable), tmp_path)
    with pytest.raises(OutputError, match="no /Jürgen"):
        print_export._export(core, tmp_path, tmp_path / "x.stl", "stl")


def test_a_terminal_without_a_letter_does_not_stop_a_job(monkeypatch):
    with open(os.devnull, "w", encoding="ascii") as terminal:  # noqa: PTH123
        monkeypatch.setattr(sys, "stdout", terminal)
        assert headless._run_core([sys.executable, "-c", "print('ü')"], {}) == 0
