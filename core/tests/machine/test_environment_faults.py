"""What goes wrong around the environment on a machine of its own kind: a sentence, and no hang."""

import errno
import json
import os
import sys
import threading

import pytest

from fantasia3d_addon.environment import (
    blender_program,
    doctor,
    install,
    machine,
    paths,
    removal,
    report,
)
from fantasia3d_addon.environment.machine import SetupError

posix = pytest.mark.skipif(sys.platform == "win32", reason="flock, pipes")


@posix
@pytest.mark.parametrize(("number", "answer"), [(errno.ENOLCK, True), (errno.EAGAIN, False)])
def test_a_file_system_without_locks_refuses_nothing(tmp_path, monkeypatch, number, answer):
    """Some network folders have none: the set-up waited for another one for ever."""

    def flock(*_: object) -> None:
        raise OSError(number, os.strerror(number))

    monkeypatch.setattr("fcntl.flock", flock)
    with (tmp_path / "lock").open("ab") as file:
        assert machine.try_lock(file) == answer
        assert not machine.try_lock(file, unlockable=False)


def test_files_that_go_while_they_are_counted_count_nothing(tmp_path):
    """pip writes, renames and removes in the folder meanwhile."""
    (tmp_path / "stays").write_bytes(bytes(100))
    ended = threading.Event()

    def churn() -> None:
        while not ended.is_set():
            folder = tmp_path / "folder"
            folder.mkdir()
            (folder / "file").touch()
            (folder / "file").unlink()
            folder.rmdir()

    thread = threading.Thread(target=churn)
    thread.start()
    try:
        assert {install._size_of(tmp_path) for _ in range(3000)} == {100}
    finally:
        ended.set()
        thread.join()


def test_an_environment_that_is_in_use_is_a_sentence(tmp_path, monkeypatch):
    """Windows removes no program that runs; it was reported as a bug."""
    folder = tmp_path / "env"
    folder.mkdir()
    (folder / paths.MARKER).write_text("{}")

    def rmtree(path: object, *_: object) -> None:
        raise PermissionError(errno.EACCES, "Access is denied", str(path))

    monkeypatch.setattr(removal.shutil, "rmtree", rmtree)
    with pytest.raises(SetupError, match=r"env cannot be removed \(Access is denied\)\. Close"):
        removal.remove(folder)


def test_a_disk_that_fills_up_between_two_steps_is_a_sentence(tmp_path, monkeypatch):
    def full(*_: object) -> None:
        raise OSError(errno.ENOSPC, "No space left on device", str(tmp_path / "env" / "file"))

    monkeypatch.delenv("FANTASIA3D_PYTHON", raising=False)
    monkeypatch.setattr(install._SetUp, "carry_out", full)
    place = paths.Place(tmp_path / "env")
    with pytest.raises(SetupError, match=r"file cannot be written \(No space left on device\)"):
        install.ensure(paths.project_root(), (), lambda *_: None, place=place)


@pytest.mark.parametrize("named", ["/opt/O'Brien/blender", '"', " "])
def test_a_command_whose_quotes_do_not_match_is_no_program(monkeypatch, named):
    monkeypatch.setenv("FANTASIA3D_BLENDER", named)
    with pytest.raises(SetupError, match="and no program"):
        blender_program.find_blender("3.12")


@pytest.mark.skipif(sys.platform in ("win32", "darwin"), reason="XDG is of other systems")
def test_a_relative_data_home_is_ignored(monkeypatch, tmp_path):
    """As its specification has it; the environment was another in each folder."""
    monkeypatch.setenv("HOME", str(tmp_path))
    monkeypatch.setenv("XDG_DATA_HOME", "data")
    assert paths.data_folder() == tmp_path / ".local" / "share" / "fantasia3d"


@posix
def test_a_report_does_not_wait_for_a_pipes_writer(tmp_path):
    os.mkfifo(tmp_path / "pipe")
    for name, content in (("pipe", ""), ("deep", "[" * 100_000), ("text", f'"{report.KEY}"')):
        if content:
            (tmp_path / name).write_text(content)
        with pytest.raises(SetupError, match="is not a report of this project"):
            report.write_report(tmp_path / name, paths.project_root(), [])
    with pytest.raises(SetupError, match="cannot be written"):
        report.write_report(tmp_path / ("x" * 300), paths.project_root(), [])


@pytest.fixture
def bare(tmp_path, monkeypatch):
    """A home without runs, and nothing to ask."""
    for name in ("HOME", "XDG_DATA_HOME", "XDG_CONFIG_HOME", "APPDATA", "LOCALAPPDATA"):
        monkeypatch.setenv(name, str(tmp_path))
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(report, "_packages", lambda *_: [])
    return tmp_path


def test_a_report_has_the_panels_runs_and_half_a_surrogate_pair(bare):
    """Those of an extension and of a plain module are in Blender's own folders."""
    folder = report._blender_folder() / "4.5"
    for place in ("extensions/.user/user_default/fantasia3d", "datafiles/fantasia3d"):
        run = folder / place / "runs" / "20261127-chair"
        run.mkdir(parents=True)
        job = {"command": "generate", "preset": "draft", "settings": {"a.b": "\udc80"}}
        (run / "job.json").write_text(json.dumps(job))
    written = report.write_report(bare / "report.json", paths.project_root(), [])
    runs = json.loads(written.read_text("utf-8"))["runs"]
    assert [run["job"]["preset"] for run in runs] == ["draft", "draft"]


def test_a_home_that_is_the_root_leaves_the_slashes_of_a_report(monkeypatch, tmp_path):
    monkeypatch.setenv("HOME", "/")
    monkeypatch.setenv("USERPROFILE", "/")
    redaction = report.Redaction(tmp_path / "root", tmp_path / "env")
    assert redaction.text("step 3/4") == "step 3/4"


def test_the_doctor_finds_the_hubs_models_where_the_hub_has_them(tmp_path, monkeypatch):
    for name in ("HF_HUB_CACHE", "HF_HOME", "XDG_CACHE_HOME"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setenv("HOME", str(tmp_path))
    model = "huggingface/hub/models--me--owl/snapshots/1/model_index.json"
    for variable, value, base in (
        ("XDG_CACHE_HOME", str(tmp_path / "caches"), tmp_path / "caches"),
        ("HF_HOME", "~/mine/huggingface", tmp_path / "mine"),
    ):
        (base / model).parent.mkdir(parents=True)
        (base / model).touch()
        with monkeypatch.context() as patch:
            patch.setenv(variable, value)
            assert doctor._hub_models() == "me/owl"
    assert not doctor._hub_models()
