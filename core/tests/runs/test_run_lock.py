"""One core at a time works on a run."""

import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from core.command_line import main
from core.errors import UserError
from core.io.job import Job, read_events
from core.io.lock import run_lock
from core.io.run_folder import RunFolder
from fantasia3d_addon.jobs.lock import worker

ROOT = Path(__file__).parents[3]
HOLD = """
import sys, time
from pathlib import Path
from core.io.lock import run_lock
with run_lock(Path(sys.argv[1])):
    print("held", flush=True)
    time.sleep(60)
"""


@pytest.fixture
def owner(tmp_path):
    """A process that works on a run, and the run."""
    run = RunFolder.create(tmp_path / "ein Lauf", Job(prompt="a chair"))
    child = subprocess.Popen(
        [sys.executable, "-c", HOLD, str(run.path)], cwd=ROOT, stdout=subprocess.PIPE, text=True
    )
    assert child.stdout and child.stdout.readline() == "held\n"
    yield child, run
    child.kill()
    child.communicate()


def test_a_second_resume_ends_with_the_owners_pid_and_status_2(owner, capsys):
    child, run = owner
    assert main(["resume", str(run.path)]) == 2
    output = capsys.readouterr().err
    assert f"(pid {child.pid})" in output and output.count("\n") == 1, output
    assert read_events(run.path) == [], "the owner's events are its own"
    assert child.poll() is None


def test_the_add_on_sees_the_same_lock(owner):
    child, run = owner
    assert worker(run.path) == str(child.pid)


@pytest.mark.skipif(os.name != "posix", reason="signals")
def test_the_lock_of_a_killed_process_is_free(owner):
    child, run = owner
    child.send_signal(signal.SIGKILL)
    child.wait()
    assert worker(run.path) == ""
    with run_lock(run.path):
        assert worker(run.path) == str(os.getpid())
    assert worker(run.path) == ""


def test_a_moment_of_the_add_ons_asking_refuses_no_run(tmp_path, monkeypatch):
    tries = iter([False, False, True])
    monkeypatch.setattr("core.io.lock._try_lock", lambda _: next(tries))
    with run_lock(tmp_path):
        assert (tmp_path / "lock").read_text() == f" {os.getpid()}\n"


@pytest.mark.skipif(os.name != "posix", reason="links")
@pytest.mark.parametrize("name", ["lock", "events.jsonl", "log.txt"])
def test_a_file_of_the_users_behind_a_link_keeps_what_it_holds(tmp_path, name):
    """The folder of a run may come from anywhere."""
    run, mine = RunFolder.create(tmp_path / "run", Job(prompt="a chair")), tmp_path / "mine.txt"
    mine.write_text("my work\nwithout an end")
    (run.path / name).symlink_to(mine)
    with pytest.raises(UserError, match=f"{name} is a link to another folder"), run_lock(run.path):
        pass
    assert mine.read_text() == "my work\nwithout an end"
    mine.unlink()  # and none is made there
    with pytest.raises(UserError, match="is a link"), run_lock(run.path):
        pass
    assert not mine.exists()


def test_a_run_that_may_not_be_written_is_a_sentence_at_resume(tmp_path, monkeypatch, capsys):
    run = RunFolder.create(tmp_path / "run", Job(prompt="a chair"))

    def refuse(path: Path, *_args: object, **_options: object) -> None:
        raise PermissionError(13, "Permission denied", str(path))

    monkeypatch.setattr(Path, "open", refuse)
    with (
        pytest.raises(UserError, match=r"cannot be written \(Permission denied\)"),
        run_lock(run.path),
    ):
        pass
