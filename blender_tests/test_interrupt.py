"""Ctrl-C during a render, a process that ends at once, and what killed ones leave behind."""

import errno
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import psutil
import pytest

pytest.importorskip("bpy")

import run
from blender_tests.pictures import read
from blender_tests.processes import blender_command
from fantasia3d_addon.blender import blend_output, output
from fantasia3d_addon.cli import headless, interrupt, session_folder

pytestmark = [pytest.mark.blender, pytest.mark.usefixtures("empty")]
ROOT = Path(__file__).parents[1]
SECONDS = 15.0  # on a busy machine; 1 on an idle one


def default_sigint() -> None:
    """A terminal's: a shell gives its background jobs an ignored one, which children inherit."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)


@pytest.mark.skipif(os.name != "posix", reason="signals")
@pytest.mark.parametrize("target", ["--render=a.png", "--turntable=a.mp4"])
def test_ctrl_c_ends_a_render_and_leaves_the_old_picture(asset, tmp_path, target):
    folder = tmp_path / "pictures"
    folder.mkdir()
    old = folder / target.partition("=")[2]
    old.write_bytes(b"the old picture")
    line = [sys.executable, str(ROOT / "run.py"), "relight", str(asset), target]
    child = subprocess.Popen(
        [*line, "--size", "700", "--samples", "4096"],
        cwd=folder,
        env={**os.environ, "FANTASIA3D_PYTHON": sys.executable},
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        preexec_fn=default_sigint,
    )
    deadline = time.monotonic() + 100
    while not any(folder.glob(f"{output.PREFIX}*")):
        assert child.poll() is None and time.monotonic() < deadline
        time.sleep(0.05)
    # The render is under way. By the processor's time: a busy machine loads Blender for long.
    process = psutil.Process(child.pid)
    started = sum(process.cpu_times()[:2])
    while sum(process.cpu_times()[:2]) < started + 1:
        assert child.poll() is None and time.monotonic() < deadline, child.communicate()
        time.sleep(0.05)
    start = time.monotonic()
    child.send_signal(signal.SIGINT)
    out, err = child.communicate(timeout=60)
    assert child.returncode == 130, err
    assert time.monotonic() - start < SECONDS
    assert err.strip().splitlines()[-1] == "Cancelled."
    assert "Traceback" not in err and out == ""
    assert [path.name for path in folder.iterdir()] == [old.name]
    assert old.read_bytes() == b"the old picture"


def test_a_render_that_nobody_stops_leaves_ctrl_c_as_it_was(asset, tmp_path, monkeypatch):
    before = signal.getsignal(signal.SIGINT)
    line = ["relight", str(asset), "--render", str(tmp_path / "a.png")]
    assert headless.command(run.parse([*line, "--size", "16", "--samples", "1"])) == 0
    assert read(tmp_path / "a.png").shape == (16, 16, 3)
    assert signal.getsignal(signal.SIGINT) == before
    assert signal.set_wakeup_fd(-1) == -1
    assert not output._in_use


def test_an_ignored_ctrl_c_stays_ignored():
    before = signal.signal(signal.SIGINT, signal.SIG_IGN)
    try:
        with interrupt.ends_at_ctrl_c():
            os.kill(os.getpid(), signal.SIGINT)
            assert signal.getsignal(signal.SIGINT) == signal.SIG_IGN
    finally:
        signal.signal(signal.SIGINT, before)


ENDS = {
    "run.leave": "import run; run.leave(0)",
    "ctrl-c": "from fantasia3d_addon.cli import interrupt; interrupt._end()",
}


@pytest.mark.skipif(os.name != "posix", reason="TMPDIR")
@pytest.mark.parametrize("end", ENDS)
@pytest.mark.parametrize("is_long", [False, True])
def test_blenders_own_folder_is_removed_at_the_end_and_never_everybodys(tmp_path, end, is_long):
    """Blender, whose paths have at most 1023 bytes, falls back to the folder that it is named."""
    base = tmp_path
    while is_long and len(str(base)) < 900:
        base /= 100 * "x"
    if is_long:
        base /= (1017 - len(str(base))) * "x"
    base.mkdir(parents=True, exist_ok=True)
    (base / "mine.txt").write_text("another program's")
    message = "import bpy, sys; sys.stdout.write(bpy.app.tempdir); sys.stdout.flush()"
    done = subprocess.run(
        blender_command(f"{message}\n{ENDS[end]}"),
        env={**os.environ, "TMPDIR": str(base)},
        capture_output=True,
        text=True,
    )
    folder = Path(next(x for x in done.stdout.splitlines() if x.startswith(str(base))))
    assert (folder == base) == is_long, done.stderr
    assert [path.name for path in base.iterdir()] == ["mine.txt"]
    assert done.returncode == (0 if end == "run.leave" else 130)


def test_a_folder_that_was_named_to_blender_is_no_session_folder(tmp_path, monkeypatch):
    folder = tmp_path / "blender_render"
    folder.mkdir()
    assert session_folder.is_session_folder(folder)
    assert not session_folder.is_session_folder(folder, [f"{folder}/"])
    assert not session_folder.is_session_folder(tmp_path)
    assert not session_folder.is_session_folder(Path())
    monkeypatch.setenv("TMPDIR", str(folder))
    assert not session_folder.is_session_folder(folder)


def left_over(parent: Path, name: str, lock: str = output.LOCK) -> Path:
    folder = parent / f"{output.PREFIX}{name}"
    folder.mkdir()
    (folder / "picture.png").write_bytes(b"half")
    (folder / lock).touch()
    long_ago = time.time() - 3600
    os.utime(folder, (long_ago, long_ago))
    return folder


def test_a_later_output_removes_what_a_killed_one_left_and_nothing_else(tmp_path):
    stale = left_over(tmp_path, "stale")
    kept = {left_over(tmp_path, "another-program", "note.txt")}
    kept.add(left_over(tmp_path, "just-made"))
    os.utime(tmp_path / f"{output.PREFIX}just-made")
    busy = left_over(tmp_path, "busy")
    with (busy / output.LOCK).open("ab") as lock:
        assert output.try_lock(lock)
        with output.temporary_output(tmp_path / "a.txt") as temporary:
            temporary.write_text("whole")
    assert not stale.exists()
    assert set(tmp_path.iterdir()) == {*kept, busy, tmp_path / "a.txt"}


def test_nothing_is_taken_for_stale_where_the_file_system_has_no_locks(tmp_path, monkeypatch):
    """Another process may be at work in it."""

    def flock(*_: object) -> None:
        raise OSError(errno.ENOLCK, os.strerror(errno.ENOLCK))

    fcntl = pytest.importorskip("fcntl")
    busy = left_over(tmp_path, "busy")
    monkeypatch.setattr(fcntl, "flock", flock)
    with output.temporary_output(tmp_path / "a.txt") as temporary:
        temporary.write_text("whole")
    assert set(tmp_path.iterdir()) == {busy, tmp_path / "a.txt"}


def test_what_a_killed_save_left_is_removed_and_nothing_else(tmp_path):
    stale = left_over(tmp_path, "abcdefgh")
    dead = [tmp_path / f"{output.PREFIX}{name}" for name in ("abcdefgh.blend", "qwertzui.blend@")]
    busy = tmp_path / f"{output.PREFIX}12345678"
    busy.mkdir()
    kept = {busy, busy.with_name(f"{busy.name}.blend"), tmp_path / f"{output.PREFIX}mine.blend"}
    for path in (*dead, *kept - {busy}):
        path.write_bytes(b"half")
    with blend_output.temporary_blend(tmp_path / "a.blend") as temporary:
        assert temporary.parent == tmp_path
        temporary.write_text("whole")
    assert not stale.exists()
    assert set(tmp_path.iterdir()) == {*kept, tmp_path / "a.blend"}


def test_a_save_that_is_cut_off_leaves_nothing(tmp_path):
    with blend_output.temporary_blend(tmp_path / "a.blend") as temporary:
        temporary.with_name(f"{temporary.name}@").write_text("half")
        temporary.write_text("half")
        output.remove_temporaries()  # as Ctrl-C does
        assert not list(tmp_path.iterdir())
        (tmp_path / temporary.stem).mkdir()  # which a process that lives would have
        temporary.write_text("whole")


def test_frames_of_a_killed_turntable_do_not_come_into_the_next(asset, tmp_path):
    half, mine = left_over(tmp_path, "stale"), tmp_path / f"{output.PREFIX}turn"
    mine.mkdir()  # without a lock: the user's
    line = ["relight", str(asset), "--turntable", str(tmp_path / "turn"), "--frames", "2"]
    assert headless.command(run.parse([*line, "--size", "16", "--samples", "1"])) == 0
    assert [p.name for p in sorted((tmp_path / "turn").iterdir())] == [
        "frame_0001.png",
        "frame_0002.png",
    ]
    assert not half.exists() and mine.exists()
