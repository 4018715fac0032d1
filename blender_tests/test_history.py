"""The history: what became of each run, and how it is done again. Needs no Blender."""

import json
import os
import time
from pathlib import Path

import pytest

from fantasia3d_addon.errors import JobError
from fantasia3d_addon.jobs import history, job_file
from fantasia3d_addon.jobs.lock import RunLock
from fantasia3d_addon.jobs.target import Target

JOB = {"version": 1, "prompt": "a chair", "seed": 3, "preset": "draft"}


def write_run(folder: Path, *events: dict, log: bool = True, **job: object) -> Path:
    folder.mkdir(parents=True)
    (folder / "job.json").write_text(json.dumps(JOB | job), encoding="utf-8")
    if log:
        (folder / "log.txt").touch()
    if events:
        lines = "".join(json.dumps(event) + "\n" for event in events)
        (folder / "events.jsonl").write_text(lines, encoding="utf-8")
    return folder


STARTED = {"type": "started", "pid": 2**22 + 1, "time": 100.0}  # no process has that number
STEP = {"type": "progress", "stage": "geometry", "step": 1, "steps": 9, "time": 101.0}


@pytest.mark.parametrize(
    ("events", "log", "state"),
    [
        ((), False, history.WAITING),
        ((), True, history.RUNNING),  # its process may just be loading
        ((STARTED, STEP), True, history.STOPPED),
        ((STARTED, STEP, {"type": "done", "time": 160.0}), True, history.DONE),
        ((STARTED, {"type": "error", "text": "No.", "time": 160.0}), True, history.FAILED),
        ((STARTED, {"type": "cancelled", "time": 160.0}), True, history.CANCELLED),
        ((STARTED, {"type": "cancelled"}, STARTED, STEP), True, history.STOPPED),  # resumed, died
    ],
)
def test_what_became_of_a_run(tmp_path, events, log, state):
    entry = history.read_entry(write_run(tmp_path / "run", *events, log=log))
    assert entry is not None
    assert entry.state == state
    if state == history.DONE:
        assert (entry.seconds, entry.stage) == (60.0, "geometry")
    if state == history.FAILED:
        assert entry.text == "No."


def test_a_process_without_events_is_dead_after_a_while(tmp_path):
    run = write_run(tmp_path / "run")
    os.utime(run / "log.txt", (1, 1))
    entry = history.read_entry(run)
    assert entry is not None
    assert entry.state == history.STOPPED


def test_a_long_story_is_read_from_its_end(tmp_path):
    steps = [STEP | {"step": n} for n in range(5000)]
    done = write_run(tmp_path / "done", STARTED, *steps, {"type": "done", "time": 160.0})
    died = write_run(tmp_path / "died", STARTED, *steps)
    states = [entry.state for entry in map(history.read_entry, (done, died)) if entry]
    assert states == [history.DONE, history.STOPPED]


def test_the_newest_is_first_and_what_is_no_run_is_passed_over(tmp_path):
    for age, name in ((30, "old"), (10, "new"), (20, "middle")):
        run = write_run(tmp_path / name, STARTED, {"type": "done"}, prompt=name)
        stamp = time.time() - age
        os.utime(run / "job.json", (stamp, stamp))
    (tmp_path / "empty").mkdir()
    (tmp_path / "broken").mkdir()
    (tmp_path / "broken" / "job.json").write_text("{")
    (tmp_path / "file").touch()
    entries = history.scan(tmp_path)
    assert [entry.prompt for entry in entries] == ["new", "middle", "old"]
    assert history.scan(tmp_path / "nowhere") == []
    known = {entry.folder: entry for entry in entries}
    assert all(entry is known[entry.folder] for entry in history.scan(tmp_path, known))
    with (tmp_path / "old" / "events.jsonl").open("a") as file:
        file.write(json.dumps(STARTED) + "\n")
    os.utime(tmp_path / "old" / "events.jsonl", (1, 1))
    assert history.scan(tmp_path, known)[2].state == history.STOPPED


def test_a_job_is_repeated_and_with_another_seed(tmp_path):
    run = write_run(tmp_path / "run", guide_mesh=str(tmp_path / "run" / "guide.obj"))
    (run / "guide.obj").write_text("v 0 0 0")
    entry = history.read_entry(run)
    assert entry is not None
    job, files = history.copy_of_job(entry)
    assert files == {"guide.obj": run / "guide.obj"}
    there = job_file.with_own_paths(job, tmp_path / "there")
    assert there == JOB | {"guide_mesh": str(tmp_path / "there" / "guide.obj")}
    assert history.copy_of_job(entry, 9)[0]["seed"] == 9
    assert all(history.other_seed(3) != 3 for _ in range(20))
    assert 0 <= history.other_seed(2**31 - 1) < 2**31
    (run / "guide.obj").unlink()
    with pytest.raises(JobError, match="no longer exists"):
        history.copy_of_job(entry)


def test_only_what_failed_midway_is_resumed(tmp_path):
    run = write_run(tmp_path / "run", STARTED, {"type": "error", "text": "No such noun."})
    entry = history.read_entry(run)
    assert entry is not None
    assert not entry.resumable
    (run / "checkpoint").mkdir()
    assert entry.resumable


def test_a_removed_run_is_deleted(tmp_path):
    run = write_run(tmp_path / "run", STARTED, {"type": "done"})
    entry = history.read_entry(run)
    assert entry is not None
    history.remove(entry)
    assert not run.exists()
    history.remove(entry)  # somebody else was faster


def test_a_lock_has_one_holder(tmp_path):
    first = RunLock.acquire(tmp_path)
    assert first is not None
    assert RunLock.acquire(tmp_path) is None
    first.release()
    second = RunLock.acquire(tmp_path)
    assert second is not None
    second.release()
    with pytest.raises(JobError, match="can't be written"):
        RunLock.acquire(tmp_path / "nowhere")


def test_a_target_is_kept_and_what_is_unknown_is_passed_over(tmp_path):
    target = Target(file="ä.blend", scene="S", location=(1, 2, 3), object="Cube", assign="object")
    target.write(tmp_path)
    assert Target.read(tmp_path) == target
    data = json.loads((tmp_path / "target.json").read_text())
    (tmp_path / "target.json").write_text(json.dumps(data | {"future": 1}))
    assert Target.read(tmp_path) == target
    (tmp_path / "target.json").write_text("[1]")
    assert Target.read(tmp_path) == Target.read(tmp_path / "nowhere") == Target()
