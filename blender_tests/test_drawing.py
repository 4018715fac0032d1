"""Panels are drawn many times a second: they look things up, and what reads files is elsewhere."""

import builtins
import io
import itertools
import os
import subprocess
import threading
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

bpy = pytest.importorskip("bpy")

from bpy.utils import previews  # noqa: E402

import fantasia3d_addon  # noqa: E402
from blender_tests.asset_fixture import write_png  # noqa: E402
from fantasia3d_addon import environment  # noqa: E402
from fantasia3d_addon.environment import lock_file  # noqa: E402
from fantasia3d_addon.jobs import candidates, history, memory, panels, paths  # noqa: E402
from fantasia3d_addon.jobs.process import Run  # noqa: E402
from fantasia3d_addon.jobs.progress import FollowedRun  # noqa: E402
from fantasia3d_addon.jobs.session import session  # noqa: E402
from fantasia3d_addon.jobs.target import Target  # noqa: E402
from fantasia3d_addon.ui import (  # noqa: E402
    edit_region,
    generate_panel,
    icons,
    job_panel,
    registration,
    setup_panel,
)

pytestmark = [pytest.mark.blender, pytest.mark.usefixtures("addon")]
PANELS = (
    generate_panel.FANTASIA3D_PT_generate,
    job_panel.FANTASIA3D_PT_jobs,
    setup_panel.FANTASIA3D_PT_set_up,
    edit_region.FANTASIA3D_PT_edit_region,
)


class Layout:
    """A layout that takes everything, opens each collapsible part, and draws each row of a list."""

    def __getattr__(self, name: str):
        return lambda *_args, **_more: (Layout(), Layout()) if name == "panel" else Layout()

    def template_list(self, _kind: str, _id: str, jobs: object, *_more: object, **_options: object):
        for item in jobs.entries:
            job_panel.FANTASIA3D_UL_runs.draw_item(None, None, Layout(), None, item, 0, None, "")


def draw() -> None:
    """Everything that the sidebar and the preferences draw, and what decides which buttons work."""
    for panel in PANELS:
        panel.draw(SimpleNamespace(layout=Layout()), bpy.context)
    setup_panel.draw_set_up(Layout(), bpy.context, repair=True)
    for cls in registration.CLASSES:
        if issubclass(cls, bpy.types.Operator) and hasattr(cls, "poll"):
            cls.poll(bpy.context)


def picture(path: Path, time: int = 1) -> Path:
    path.parent.mkdir(parents=True, exist_ok=True)
    write_png(path, np.zeros((8, 8, 3), np.uint8))
    os.utime(path, (time, time))
    return path


def write_runs(runs: Path, count: int) -> list[history.Entry]:
    """Candidates, each with its picture."""
    for number in range(count):
        run = runs / f"run{number}"
        picture(run / "asset" / "preview.png")
        (run / "job.json").write_text('{"prompt": "a chair", "preset": "draft"}')
        candidates.write(run / candidates.NAME, candidates.Candidate(group="g", until="shape"))
    return history.scan(runs)


@pytest.fixture
def reads(monkeypatch) -> list[str]:
    """The files, folders and programs that this thread opens, while the test runs."""
    found, here = [], threading.get_ident()

    def count(module: object, name: str) -> None:
        given = getattr(module, name)

        def counted(*args: object, **more: object):
            if threading.get_ident() == here:
                found.append(f"{name} {args[1:] if name == 'load' else args[:1]}")
            return given(*args, **more)

        monkeypatch.setattr(module, name, counted)

    for module, name in ((builtins, "open"), (io, "open"), (os, "scandir"), (os, "listdir")):
        count(module, name)
    count(subprocess, "Popen")
    count(previews.ImagePreviewCollection, "load")
    return found


def test_to_draw_the_panels_opens_no_file(tmp_path, monkeypatch, reads):
    monkeypatch.delenv("FANTASIA3D_PYTHON", raising=False)
    monkeypatch.delenv("FANTASIA3D_ENV", raising=False)
    monkeypatch.setattr(paths.Paths, "runs", tmp_path)
    settings = bpy.context.scene.fantasia3d
    settings.prompt, settings.light = "a red chair", "blender:forest"
    draw()  # the lights and the hash of the lock file are known from now on
    session.history = write_runs(tmp_path, 3)
    panels.update_list(session.history)
    folder = session.history[0].folder
    session.waiting.append((folder, None))
    session.running.append(FollowedRun(Run.attach(folder), Target(), None, None))
    session.running[0].picture = session.history[0].pictures[0]
    reads.clear()
    draw()
    assert reads == []
    icons.look()
    assert len(reads) == 3  # that is, what Blender reads in its own thread when it is drawn
    reads.clear()
    draw()
    assert reads == []
    assert set(icons._names) >= {entry.pictures for entry in session.history}


NUMBERS = itertools.count(1)


class Collection(dict):
    """A collection that keeps which pictures were read at once."""

    def __init__(self, read: list[str]) -> None:
        super().__init__()
        self.read = read

    def load(self, name: str, path: str, _kind: str) -> None:
        read = self.read

        class Picture:
            icon_id = next(NUMBERS)  # in the background, Blender gives 0 to all

            @property
            def image_size(self) -> tuple[int, int]:
                read.append(Path(path).name)
                return 8, 8

        self[name] = Picture()


@pytest.fixture
def read(monkeypatch) -> list[str]:
    """The names of the pictures that are read at once, with a fake of Blender's reader."""
    read: list[str] = []
    monkeypatch.setattr(icons, "_collections", [Collection(read)])
    yield read
    icons._names.clear()  # of a collection that is gone
    icons._drawn.clear()


def test_a_picture_appears_after_the_look_that_follows_its_drawing(tmp_path, read, monkeypatch):
    redrawn: list[bool] = []
    monkeypatch.setattr(icons, "redraw", lambda: redrawn.append(True))
    files = (tmp_path / "best.png", picture(tmp_path / "other.png"))
    assert icons.icon(files) == 0
    assert bpy.app.timers.is_registered(icons.look)
    assert (icons.look(), redrawn) == (None, [True])
    first = icons.icon(files)
    assert first != 0
    assert (icons.look(), redrawn) == (None, [True]), "nothing is new: it is not drawn again"
    picture(files[0])
    icons.icon(files)
    icons.look()
    assert icons.icon(files) not in (0, first)
    assert len(icons._collections[0]) == 1
    for path in files:
        path.unlink()
    icons.icon(files)
    icons.look()
    assert icons.icon(files) == len(icons._collections[0]) == 0
    assert icons.icon(()) == 0


def test_one_picture_that_replaces_another_is_read_in_a_look(tmp_path, read):
    files = [(tmp_path / f"{number}.png",) for number in range(3)]
    for time, left in ((1, [None]), (2, [icons.SECONDS, icons.SECONDS, None, None])):
        for each in files:
            picture(each[0], time)
            icons.icon(each)
        seconds = []
        for _ in left:
            seconds.append(icons.look())
            assert len(read) <= len(seconds)
        assert seconds == left
    assert read == ["0.png", "1.png", "2.png"]  # none at first


def test_the_pictures_that_are_kept_are_few_unless_more_are_drawn(tmp_path, read, monkeypatch):
    monkeypatch.setattr(icons, "MAX_PICTURES", 3)
    files = [(picture(tmp_path / f"{number}.png"),) for number in range(8)]
    for each in files:
        icons.icon(each)
        icons.look()
    assert list(icons._names) == files[-3:]
    assert len(icons._collections[0]) == 3
    for each in files[:5]:
        icons.icon(each)
    icons.look()
    assert all(icons.icon(each) for each in files[:5])


def test_no_picture_and_no_timer_outlives_the_addon(tmp_path):
    files = (picture(tmp_path / "a.png"),)
    icons.icon(files)
    icons.look()
    icons.icon(files)
    fantasia3d_addon.unregister()
    try:
        assert not bpy.app.timers.is_registered(icons.look)
        assert not (icons._names or icons._drawn or icons._collections)
        assert icons.icon(files) == 0
    finally:
        fantasia3d_addon.register()


def test_the_lock_file_is_read_again_when_it_was_written_again(tmp_path, monkeypatch):
    monkeypatch.delenv("FANTASIA3D_ENV", raising=False)
    given, times = lock_file.read_lock, []
    monkeypatch.setattr(lock_file, "read_lock", lambda root: times.append(root) or given(root))
    lock = tmp_path / lock_file.NAME
    lock.write_text("# [core]\ntorch==1\n")
    first = environment.env_folder(tmp_path)
    assert environment.env_folder(tmp_path) == first
    assert len(times) == 1
    lock.write_text("# [core]\ntorch==22\n")
    assert environment.env_folder(tmp_path) != first
    lock.unlink()
    with pytest.raises(environment.SetupError, match="no requirements.lock"):
        environment.env_folder(tmp_path)


def test_the_free_memory_is_measured_in_a_thread(monkeypatch):
    threads: list[threading.Thread] = []
    monkeypatch.setattr(
        memory, "available", lambda: threads.append(threading.current_thread()) or 5e9
    )
    free = memory.FreeMemory()
    assert free() is None
    free._task.join(10)
    assert free() == free() == 5e9
    assert len(threads) == 1
    assert threads[0] is not threading.main_thread()


def test_the_list_is_filtered_by_the_prompt(tmp_path):
    write_runs(tmp_path, 2)
    other = tmp_path / "other"
    other.mkdir()
    (other / "job.json").write_text('{"prompt": "a red Cow"}')
    session.history = history.scan(tmp_path)
    panels.update_list(session.history)
    jobs = bpy.context.window_manager.fantasia3d
    given = SimpleNamespace(filter_name="COW", bitflag_filter_item=4)
    shown, _ = job_panel.FANTASIA3D_UL_runs.filter_items(given, bpy.context, jobs, "entries")
    names = [item.name for item, flag in zip(jobs.entries, shown, strict=True) if flag == 4]
    assert names == [str(other)]
