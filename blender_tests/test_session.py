"""Jobs in Blender, with a fake core: queue, end, crash, several Blenders at once."""

import shutil
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

bpy = pytest.importorskip("bpy")

from blender_tests.conftest import FAKE_CORE  # noqa: E402
from blender_tests.processes import blender_command  # noqa: E402
from fantasia3d_addon.errors import AddonError  # noqa: E402
from fantasia3d_addon.jobs import history, submit  # noqa: E402
from fantasia3d_addon.jobs.lock import RunLock  # noqa: E402
from fantasia3d_addon.jobs.process import is_core  # noqa: E402
from fantasia3d_addon.jobs.session import session  # noqa: E402

pytestmark = [pytest.mark.blender, pytest.mark.usefixtures("empty")]
AWAY = """
import os, sys, time
from pathlib import Path
import bpy, fantasia3d_addon
from fantasia3d_addon import environment
from fantasia3d_addon.jobs import paths, submit
from fantasia3d_addon.jobs.session import session
os.environ["FANTASIA3D_PYTHON"] = {python!r}
environment.project_root = lambda: Path({core!r})
paths.Paths.runs = Path({runs!r})
fantasia3d_addon.register()
settings = bpy.context.scene.fantasia3d
settings.negative_prompt = {asset!r}
for settings.prompt in {prompts!r}:
    submit.generate(bpy.context)
until = time.time() + 30
while time.time() < until and not (session.running and session.running[0].progress.step > 2):
    session.tick()
    time.sleep(0.01)
print("started", flush=True)
{then}
os.kill(os.getpid(), 9)
"""


@contextmanager
def another_blender(ready, runs: Path, *prompts: str, then: str = "") -> Iterator[None]:
    """A Blender that requests ``prompts``, sees the first start, runs ``then`` and is killed."""
    code = AWAY.format(
        python=sys.executable,
        core=str(FAKE_CORE),
        runs=str(runs),
        asset=ready.negative_prompt,
        prompts=list(prompts),
        then=then,
    )
    command = blender_command(code)
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout
        assert any(line.strip() == "started" for line in process.stdout)
        yield
        process.kill()


def only_run(runs: Path) -> history.Entry:
    (entry,) = history.scan(runs)
    return entry


def test_generate_puts_the_asset_at_the_cursor(ready, wait):
    bpy.context.scene.cursor.location = (1, 2, 3)
    assert bpy.ops.fantasia3d.generate() == {"FINISHED"}
    bpy.context.scene.cursor.location = (0, 0, 0)  # where it was is what counts
    wait()
    (obj,) = bpy.data.objects
    assert (obj.name, tuple(obj.location)) == ("a red wooden chair", (1, 2, 3))
    assert (session.asset, session.error) == (obj.name, None)
    assert session.last.name.endswith("-a-red-wooden-chair")
    assert all(image.packed_file for image in bpy.data.images if image.source == "FILE")


def test_the_operator_is_the_function(ready, wait):
    jobs = []
    for press in (lambda: submit.generate(bpy.context), bpy.ops.fantasia3d.generate):
        press()
        wait()
        jobs.append(session.last.job)
    assert jobs[0] == jobs[1]
    assert len(bpy.data.objects) == 2


def test_progress_is_shown_while_it_runs_and_cancel_shows_what_it_waits_for(ready, wait):
    ready.prompt = "long"
    bpy.ops.fantasia3d.generate()
    progress = session.running[0].progress
    assert progress.detail == "Loading the method, a few seconds"
    wait(until=lambda: progress.fraction > 0)
    assert progress.line.startswith("Shape  0%")
    assert progress.detail.startswith("Stage 2 of 5, 1:4")  # minutes and seconds
    begin = time.monotonic()
    assert bpy.ops.fantasia3d.cancel() == {"FINISHED"}
    assert (progress.line, progress.detail) == (
        "Cancelling",
        "Waiting for the present step of “Shape”",
    )
    wait()
    assert time.monotonic() - begin < 1.0
    assert session.last.end.type == "cancelled"
    assert (session.error, len(bpy.data.objects)) == (None, 0)


def test_a_core_that_does_not_listen_can_be_stopped_and_resumed(ready, wait, monkeypatch):
    ready.prompt = "deaf"
    bpy.ops.fantasia3d.generate()
    wait(until=lambda: session.running[0].progress.fraction > 0)
    assert not bpy.ops.fantasia3d.stop_now.poll()
    bpy.ops.fantasia3d.cancel()
    assert not session.running[0].progress.overdue
    monkeypatch.setattr("fantasia3d_addon.jobs.progress.PATIENCE", 0.0)
    assert session.running[0].progress.overdue
    bpy.ops.fantasia3d.stop_now()
    wait()
    assert session.error[0].startswith("The generator stopped unexpectedly")
    entry = only_run(session.last.run.folder.parent)
    assert (entry.state, entry.resumable) == (history.STOPPED, True)


def test_an_error_stays_in_the_panel_with_its_fix(ready, wait):
    ready.prompt = "fail"
    bpy.ops.fantasia3d.generate()
    wait()
    assert session.error == ("There is no noun 'blorb'.", "Say chair.")
    assert bpy.ops.fantasia3d.open_log.poll()
    ready.prompt = "x"
    bpy.ops.fantasia3d.generate()
    assert session.error is None  # a new run, a new page
    wait()
    bpy.ops.fantasia3d.dismiss()
    assert (session.last, session.asset) == (None, "")


def test_half_an_asset_is_an_error_in_the_panel(ready, wait):
    (Path(ready.negative_prompt) / "orm.png").unlink()
    bpy.ops.fantasia3d.generate()
    wait()
    assert session.error[0].endswith("orm.png is missing.")
    assert not bpy.data.objects


def test_an_asset_that_was_deleted_is_a_sentence_and_no_traceback(ready, wait):
    run = submit.generate(bpy.context)
    wait()
    shutil.rmtree(run / "asset")
    with pytest.raises(RuntimeError) as refused:
        bpy.ops.fantasia3d.job_import(folder=str(run))
    sentence = "Its asset no longer exists. Press Repeat to generate it again."
    assert str(refused.value).strip() == f"Error: {sentence}"
    shutil.rmtree(run)
    session.history = history.scan(run.parent, {e.folder: e for e in session.history})
    for press in (bpy.ops.fantasia3d.job_import, bpy.ops.fantasia3d.job_repeat):
        with pytest.raises(RuntimeError) as refused:
            press(folder=str(run))
        assert "Traceback" not in str(refused.value)


def test_an_asset_of_the_history_is_imported_again(ready, wait):
    run = submit.generate(bpy.context)
    wait()
    assert bpy.ops.fantasia3d.job_import(folder=str(run)) == {"FINISHED"}
    names = sorted(o.name for o in bpy.data.objects)
    assert names == ["a red wooden chair", "a red wooden chair.001"]
    assert bpy.context.active_object.name == names[1]


def test_what_is_deleted_while_the_history_is_read_does_not_come_back(ready, wait, monkeypatch):
    submit.generate(bpy.context)
    wait()
    (entry,) = session.history
    scan, begun, gone = history.scan, threading.Event(), threading.Event()

    def slowly(runs, known=None):
        found = scan(runs, known)
        begun.set()
        assert gone.wait(10)
        return found

    monkeypatch.setattr(history, "scan", slowly)
    session.refresh()
    assert begun.wait(10)
    history.remove(entry)
    session.refresh()
    gone.set()
    wait()
    assert session.history == []


def test_the_timer_goes_on_until_a_history_that_was_read_is_shown(ready, wait, monkeypatch):
    wait()
    session.refresh()
    deadline = time.monotonic() + 30
    while session._scan.running and time.monotonic() < deadline:
        time.sleep(0.01)
    handle = session._handle
    monkeypatch.setattr(session, "_handle", lambda: None)  # it ended after it was looked at
    assert session.tick() is not None
    monkeypatch.setattr(session, "_handle", handle)
    assert session.tick() is None


def test_jobs_run_in_the_order_in_which_they_were_queued(ready, wait):
    runs = []
    for ready.prompt in ("long", "second", "third", "fourth"):
        runs.append(submit.generate(bpy.context))
    assert [followed.prompt for followed in session.running] == ["long"]
    assert [folder for folder, _ in session.waiting] == runs[1:]
    assert history.read_entry(runs[1]).state == history.WAITING
    bpy.ops.fantasia3d.queue_drop(folder=str(runs[2]))
    assert not runs[2].exists()
    session.cancel()
    wait()
    states = {entry.prompt: entry.state for entry in history.scan(runs[0].parent)}
    assert states == {"long": "cancelled", "second": "done", "fourth": "done"}
    assert len(bpy.data.objects) == 2


def test_the_process_has_exited_when_its_job_is_done(ready, wait):
    """It holds the GPU's memory."""
    bpy.ops.fantasia3d.generate()
    run = session.running[0].run
    wait()
    assert run.pid
    assert not is_core(run.pid, run.folder)


def test_an_asset_waits_while_the_user_is_in_edit_mode(ready, wait):
    obj = bpy.data.objects.new("x", bpy.data.meshes.new("x"))
    bpy.context.scene.collection.objects.link(obj)
    bpy.context.view_layer.objects.active = obj
    bpy.ops.fantasia3d.generate()
    bpy.ops.object.mode_set(mode="EDIT")
    wait(until=lambda: bool(session.importing))
    for _ in range(3):
        assert session.tick() is not None
    assert len(bpy.data.objects) == 1
    bpy.ops.object.mode_set(mode="OBJECT")
    wait()
    assert len(bpy.data.objects) == 2


def test_a_new_file_does_not_lose_the_run(ready, wait):
    bpy.ops.fantasia3d.generate()
    bpy.ops.wm.read_factory_settings(use_empty=True)
    assert bpy.app.timers.is_registered(session._timer)
    wait()
    assert [obj.name for obj in bpy.data.objects] == ["a red wooden chair"]


def test_an_asset_does_not_fall_into_another_file(ready, wait, tmp_path):
    mine = str(tmp_path / "mine.blend")
    bpy.ops.wm.save_as_mainfile(filepath=mine)
    ready.prompt = "brief"
    bpy.ops.fantasia3d.generate()
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "other.blend"))  # the same work
    bpy.ops.wm.read_factory_settings(use_empty=True)
    wait()
    assert not bpy.data.objects
    assert [entry.prompt for entry in session.missed] == ["brief"]
    assert bpy.ops.fantasia3d.job_import(folder=str(session.missed[0].folder)) == {"FINISHED"}
    assert len(bpy.data.objects) == 1
    assert not session.missed


def test_a_queued_asset_does_not_fall_into_another_file(ready, wait, tmp_path):
    mine, other = str(tmp_path / "mine.blend"), str(tmp_path / "other.blend")
    bpy.ops.wm.save_as_mainfile(filepath=other)
    bpy.ops.wm.save_as_mainfile(filepath=mine)
    runs = [submit.generate(bpy.context) for _ in range(2)]
    assert len(session.waiting) == 1
    bpy.ops.wm.open_mainfile(filepath=other)
    wait()
    assert not bpy.data.objects
    assert [entry.folder for entry in session.missed] == runs
    assert all(history.awaits_import(history.read_entry(folder)) for folder in runs)


def test_an_adopted_run_does_not_fall_into_another_file(ready, wait, tmp_path):
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "mine.blend"))
    ready.prompt = "brief"
    run = submit.generate(bpy.context)
    process = session.running[0].run._process
    session.close()  # Blender ends, and a new one opens its startup file
    bpy.ops.wm.read_factory_settings(use_empty=True)
    session.adopt(bpy.context)
    assert [followed.run.folder for followed in session.running] == [run]
    wait()
    process.wait(60)
    assert not bpy.data.objects
    assert [entry.folder for entry in session.missed] == [run]


def test_a_resumed_run_comes_where_it_is_resumed(ready, wait, tmp_path):
    ready.prompt = "brief"
    run = submit.generate(bpy.context)
    wait(until=lambda: session.running[0].progress.fraction > 0)
    session.cancel()
    wait()
    session.close()
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "mine.blend"))  # it had no name before
    submit.resume(bpy.context, history.read_entry(run))
    wait()
    assert (len(bpy.data.objects), session.missed) == (1, [])


def test_an_asset_comes_into_the_scene_where_the_active_collection_is_linked(ready, wait, tmp_path):
    library = tmp_path / "library.blend"
    bpy.data.libraries.write(str(library), {bpy.data.collections.new("Lib")}, fake_user=True)
    bpy.data.collections.remove(bpy.data.collections["Lib"])
    with bpy.data.libraries.load(str(library), link=True) as (_, wanted):
        wanted.collections = ["Lib"]
    bpy.context.scene.collection.children.link(bpy.data.collections["Lib"])
    layer = bpy.context.view_layer
    layer.active_layer_collection = layer.layer_collection.children["Lib"]
    run = submit.generate(bpy.context)
    wait()
    assert session.error is None
    assert len(bpy.context.scene.collection.objects) == 1
    assert bpy.ops.fantasia3d.job_import(folder=str(run)) == {"FINISHED"}
    assert len(bpy.context.scene.collection.objects) == 2


def test_what_an_import_raises_is_a_sentence_and_the_asset_is_offered(ready, monkeypatch, capsys):
    def broken(*_args: object, **_more: object) -> None:
        raise RuntimeError("Could not link it.")

    monkeypatch.setattr("fantasia3d_addon.jobs.import_result.import_asset", broken)
    run = submit.generate(bpy.context)
    while session.tick() is not None:
        time.sleep(0.01)
    text, fix = session.error
    assert text == (
        "The asset “a red wooden chair” can't be imported. RuntimeError: Could not link it."
    )
    assert fix.endswith(".")
    lock = RunLock.acquire(run)  # nobody follows it any more
    assert lock
    lock.release()
    assert "Traceback" in capsys.readouterr().err
    assert [entry.folder for entry in session.missed] == [run]
    monkeypatch.undo()
    bpy.ops.fantasia3d.job_import(folder=str(run))
    assert (len(bpy.data.objects), session.missed) == (1, [])


def test_a_tick_that_fails_is_reported_once_and_the_next_goes_on(ready, monkeypatch, capsys):
    def broken(**_more: object) -> None:
        raise RuntimeError("No such layer.")

    run = submit.generate(bpy.context)
    monkeypatch.setattr("fantasia3d_addon.jobs.session.live_preview.remove", broken)
    while session.tick() is not None:
        time.sleep(0.01)
    text = "“a red wooden chair” can't be followed. RuntimeError: No such layer."
    assert session.error[0] == text
    assert capsys.readouterr().err.count("Traceback") == 1
    assert (run / "taken").exists()
    assert len(bpy.data.objects) == 1


def test_a_run_that_continues_after_a_crash_is_followed(ready, wait, tmp_path):
    with another_blender(ready, tmp_path / "runs", "brief", "second"):
        pass
    session.adopt(bpy.context)
    assert [followed.prompt for followed in session.running] == ["brief"]
    assert [history.read_entry(folder).prompt for folder, _ in session.waiting] == ["second"]
    assert session.paused
    wait()
    assert [obj.name for obj in bpy.data.objects] == ["a red wooden chair"]
    assert bpy.ops.fantasia3d.queue_go_on() == {"FINISHED"}
    wait()
    assert len(bpy.data.objects) == 2


def test_a_run_of_a_living_blender_is_left_to_it(ready, wait, tmp_path):
    with another_blender(ready, tmp_path / "runs", "long", then="time.sleep(60)"):
        session.adopt(bpy.context)
        assert not session.running
        entry = only_run(tmp_path / "runs")
        assert entry.state == history.RUNNING
        with pytest.raises(AddonError, match="still running"):
            history.remove(entry)
    session.adopt(bpy.context)
    assert [followed.prompt for followed in session.running] == ["long"]
    session.cancel()
    wait()
    assert only_run(tmp_path / "runs").state == history.CANCELLED


def test_what_was_done_while_blender_was_closed_is_offered(ready, wait, tmp_path):
    with another_blender(ready, tmp_path / "runs", "brief"):
        pass
    entry = only_run(tmp_path / "runs")
    while entry.state != history.DONE:
        time.sleep(0.1)
        entry = only_run(tmp_path / "runs")
    session.adopt(bpy.context)
    assert [missed.prompt for missed in session.missed] == ["brief"]
    bpy.ops.fantasia3d.job_import(folder=str(entry.folder))
    assert [obj.name for obj in bpy.data.objects] == ["a red wooden chair"]
    session.adopt(bpy.context)
    assert not session.missed


def test_the_core_is_missing(ready, monkeypatch, tmp_path):
    monkeypatch.setattr("fantasia3d_addon.jobs.paths.Paths.python", tmp_path / "none")
    with pytest.raises(AddonError, match="There is no Python"):
        submit.generate(bpy.context)
    assert (session.running, session.waiting) == ([], [])


def test_no_tick_takes_long_from_the_start_to_the_asset(ready, wait, monkeypatch):
    """By the thread's own clock: another process's turn is not ours."""
    seconds = []

    def timed(tick=session.tick):
        begin = time.thread_time()
        try:
            return tick()
        finally:
            seconds.append(time.thread_time() - begin)

    monkeypatch.setattr(session, "tick", timed)
    bpy.ops.fantasia3d.generate()
    wait()
    assert len(bpy.data.objects) == 1
    assert max(seconds) < 0.05
