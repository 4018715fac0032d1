"""The add-on's side of the run folder, against real processes. Needs no Blender."""

import json
import os
import shutil
import signal
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path

import pytest

from fantasia3d_addon.errors import JobError
from fantasia3d_addon.jobs import history, process
from fantasia3d_addon.jobs.events import Event
from fantasia3d_addon.jobs.process import Core, Run, is_core

FAKE_CORE = Path(__file__).parent / "fake_core"
CORE = Core(Path(sys.executable), FAKE_CORE)


def start(folder: Path, prompt: str = "x", **settings: object) -> Run:
    job = {"version": 1, "prompt": prompt, **settings}
    return Run.start(folder, job, CORE)


def follow(run: Run, until: Callable[[list[Event]], bool] = lambda events: False) -> list[Event]:
    """The events to the end, or until ``until`` is true."""
    events: list[Event] = []
    deadline = time.monotonic() + 60
    while not run.finished and not until(events):
        assert time.monotonic() < deadline, events
        events += run.poll()
        time.sleep(0.01)
    return events


def reap(run: Run) -> None:
    """Wait for the process of a run that another one follows."""
    assert run._process
    run._process.wait(60)


def test_a_run_goes_to_its_end(tmp_path):
    events = follow(start(tmp_path / "run"))
    assert [e.step for e in events if e.type == "progress"] == [1, 2, 3, 4, 5]
    assert (events[0].type, events[-1].type, events[-1].path) == ("started", "done", "asset")


def test_the_job_is_written_as_it_is_given(tmp_path):
    run = start(tmp_path / "run", "a réd chair 椅子", seed=7)
    job = json.loads((run.folder / "job.json").read_text(encoding="utf-8"))
    assert job == {"version": 1, "prompt": "a réd chair 椅子", "seed": 7}
    follow(run)


def test_a_folder_with_a_run_is_not_taken_for_another(tmp_path):
    follow(start(tmp_path / "run"))
    with pytest.raises(JobError, match="holds a run already"):
        start(tmp_path / "run")


def test_what_the_core_prints_is_in_the_log_without_blenders_python(tmp_path, monkeypatch):
    monkeypatch.setenv("PYTHONPATH", "/nowhere")
    monkeypatch.setenv("PYTHONHOME", "/nowhere")
    run = start(tmp_path / "run")
    assert follow(run)[-1].type == "done"
    log = run.log.read_text()
    assert "the fake core" in log
    assert "PYTHONHOME" not in log
    assert "PYTHONPATH" not in log


def test_cancel_is_answered(tmp_path):
    run = start(tmp_path / "run", "long")
    follow(run, until=lambda events: len(events) > 2)
    run.cancel()
    follow(run)
    assert run.last is not None
    assert run.last.type == "cancelled"


def test_resume_forgets_the_cancel_and_tells_only_what_is_new(tmp_path):
    run = start(tmp_path / "run", "long")
    follow(run, until=lambda events: len(events) > 2)
    run.cancel()
    follow(run)
    job = json.loads((run.folder / "job.json").read_text())
    (run.folder / "job.json").write_text(json.dumps(job | {"prompt": "short"}))
    again = Run.resume(run.folder, CORE)
    events = follow(again)
    assert [e.type for e in events] == ["started", *["progress"] * 5, "done"]


def test_an_error_carries_its_fix(tmp_path):
    run = start(tmp_path / "run", "fail")
    follow(run)
    assert run.last is not None
    assert (run.last.type, run.last.text) == ("error", "There is no noun 'blorb'.")
    assert run.last.fix == "Say chair."


def test_a_death_without_an_error_names_the_log(tmp_path):
    run = start(tmp_path / "run", "die")
    follow(run)
    assert run.last is not None
    assert run.last.type == "error"
    assert str(run.log) in run.last.fix
    assert f"signal {signal.SIGABRT.value}" in run.last.text


def test_a_death_on_a_full_disk_is_reported_as_such(tmp_path, monkeypatch):
    run = start(tmp_path / "run", "die")
    monkeypatch.setattr(process.shutil, "disk_usage", lambda _: shutil._ntuple_diskusage(9, 9, 0))
    follow(run)
    assert run.last is not None
    assert run.last.text == f"The disk of {run.folder} is full."
    assert run.last.fix == "Free some space, then resume the run."


def test_a_death_after_its_folder_was_deleted_is_reported_as_such(tmp_path):
    run = start(tmp_path / "run", "long")
    follow(run, until=lambda events: len(events) > 2)
    os.kill(run.pid, signal.SIGSTOP)  # or it writes a file into the folder that is being deleted
    shutil.rmtree(run.folder)
    run.kill()
    follow(run)
    assert run.last is not None
    assert run.last.text == f"The run's folder {run.folder} no longer exists."


def test_kill_9_is_noticed_by_who_started_it_and_by_who_found_it(tmp_path):
    run = start(tmp_path / "run", "long")
    follow(run, until=lambda events: len(events) > 2)
    found = Run.attach(run.folder)
    assert found.poll()[0].type == "started"
    assert not found.finished
    os.kill(run.pid, signal.SIGKILL)
    follow(run)
    follow(found)
    for end in (run.last, found.last):
        assert end is not None
        assert end.type == "error"
        assert "stopped unexpectedly" in end.text


def test_a_run_is_followed_again_after_the_end_of_its_blender(tmp_path):
    """The process lives on when the one that started it dies, and its events are all there."""
    code = (
        "import sys, os, time; from pathlib import Path\n"
        "from fantasia3d_addon.jobs.process import Core, Run\n"
        f"run = Run.start(Path({str(tmp_path / 'run')!r}), {{'version': 1, 'prompt': 'long'}}, "
        f"Core(Path(sys.executable), Path({str(FAKE_CORE)!r})))\n"
        "while not run.poll(): time.sleep(0.01)\n"
        "os.kill(os.getpid(), 9)"
    )
    root = Path(__file__).parents[1]
    assert subprocess.run([sys.executable, "-c", code], cwd=root).returncode == -signal.SIGKILL
    run = Run.attach(tmp_path / "run")
    events = follow(run, until=lambda events: len(events) > 4)
    assert events[0].type == "started"
    assert is_core(run.pid, run.folder)
    run.cancel()
    follow(run)
    assert run.last is not None
    assert run.last.type == "cancelled"


def test_a_finished_run_is_attached_as_finished(tmp_path):
    follow(start(tmp_path / "run"))
    run = Run.attach(tmp_path / "run")
    assert run.poll()[-1].type == "done"
    assert run.finished


def test_a_line_that_is_still_being_written_waits(tmp_path):
    run = start(tmp_path / "run", "half a line")
    events = follow(run)
    assert "gré" in [e.stage for e in events]
    assert not any(e.type == "warning" for e in events)


def test_a_broken_line_is_a_warning_and_the_rest_is_read(tmp_path):
    events = follow(start(tmp_path / "run", "nonsense"))
    assert [e.type for e in events][-3:] == ["warning", "warning", "done"]


def test_poll_does_not_wait(tmp_path):
    run = start(tmp_path / "run", "say nothing")
    begin = time.perf_counter()
    for _ in range(100):
        assert run.poll() == []
    assert time.perf_counter() - begin < 1.0
    os.kill(run.pid, signal.SIGKILL)
    reap(run)


def test_a_run_nobody_started_is_dead_after_a_while(tmp_path, monkeypatch):
    (tmp_path / "job.json").write_text("{}")
    assert [e.type for e in Run.attach(tmp_path).poll()] == ["error"]
    (tmp_path / "log.txt").touch()  # a process may just have been started
    assert Run.attach(tmp_path).poll() == []


def test_a_living_run_is_followed_though_its_log_is_old(tmp_path):
    """A long stage prints nothing for many minutes."""
    run = start(tmp_path / "run", "long")
    follow(run, until=lambda events: len(events) > 2)
    old = time.time() - 10 * process.START_SECONDS
    os.utime(run.log, (old, old))
    found = Run.attach(run.folder)
    assert "error" not in [event.type for event in found.poll()]
    assert (found.pid, found.finished) == (run.pid, False)
    run.kill()
    follow(run)
    follow(found)
    assert found.last is not None
    assert found.last.type == "error"


def test_no_python_there(tmp_path):
    with pytest.raises(JobError, match=r"There is no Python at .*Install"):
        Run.start(tmp_path / "run", {}, Core(Path("/no/python"), FAKE_CORE))


def test_a_python_that_is_no_program(tmp_path):
    (tmp_path / "python").write_text("no program")
    with pytest.raises(JobError, match="can't be started"):
        Run.start(tmp_path / "run", {}, Core(tmp_path / "python", FAKE_CORE))


def test_a_place_that_cannot_be_written(tmp_path):
    (tmp_path / "file").touch()
    with pytest.raises(JobError, match="can't be written"):
        start(tmp_path / "file" / "run")


def test_other_processes_are_not_mistaken_for_the_core(tmp_path):
    assert not is_core(os.getpid(), tmp_path / "a run of its own")
    assert not is_core(2**22 + 1, tmp_path)


def test_a_core_on_another_run_is_another_process(tmp_path):
    """The system has given the process number to another one."""
    run = start(tmp_path / "one", "long")
    follow(run, until=lambda events: len(events) > 2)
    assert is_core(run.pid, tmp_path / "one")
    assert not is_core(run.pid, tmp_path / "two")
    run.kill()
    follow(run)


def test_kill_ends_a_process_that_does_not_listen(tmp_path):
    run = start(tmp_path / "run", "deaf")
    follow(run, until=lambda events: len(events) > 2)
    run.cancel()
    time.sleep(0.2)
    run.poll()
    assert run.last is None
    run.kill()
    follow(run)
    assert run.last is not None
    assert "signal 9" in run.last.text


def test_without_proc_the_holder_of_the_runs_lock_is_the_core(tmp_path, monkeypatch):
    """As on macOS and Windows."""
    monkeypatch.setattr(process, "_command_line", lambda _pid: None)
    run = start(tmp_path / "run", "long")
    follow(run, until=lambda events: len(events) > 2)
    assert is_core(run.pid, run.folder)
    assert not is_core(os.getpid(), run.folder)  # the lock is another's
    found = Run.attach(run.folder)
    found.poll()
    found.kill()
    follow(run)
    assert run.last is not None
    assert "signal 9" in run.last.text
    assert not is_core(run.pid, run.folder)


def test_a_stranger_that_has_the_number_of_a_dead_core_is_left_alone(tmp_path, monkeypatch):
    """Where the system reports no command lines, too."""
    monkeypatch.setattr(process, "_command_line", lambda _pid: None)
    folder = tmp_path / "run"
    folder.mkdir()
    (folder / "job.json").write_text('{"version": 1, "prompt": "x", "seed": 1}')
    (folder / "lock").write_text(" 1\n")  # it stays when its holder dies
    with subprocess.Popen(["sleep", "60"], start_new_session=True) as stranger:
        started = json.dumps({"type": "started", "time": 0, "pid": stranger.pid})
        (folder / "events.jsonl").write_text(started + "\n")
        entry = history.read_entry(folder)
        assert entry is not None
        assert (entry.state, entry.resumable) == (history.STOPPED, True)
        run = Run.attach(folder)
        assert run.poll()[-1].type == "error"
        run.kill()
        time.sleep(0.1)
        assert stranger.poll() is None
        history.remove(entry)
        assert not folder.exists()
        stranger.kill()


def test_a_process_that_has_exited_is_not_killed(tmp_path, monkeypatch):
    """Its number may be another's already."""
    run = start(tmp_path / "run")
    follow(run)
    killed = []
    monkeypatch.setattr(process, "kill_process", killed.append)
    run.kill()
    assert killed == []
