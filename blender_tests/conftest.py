"""Fixtures of the tests under Blender: an empty file, an asset folder, the add-on registered."""

import importlib.util
import os
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from blender_tests.asset_fixture import write_asset

FAKE_CORE = Path(__file__).parent / "fake_core"
# With a Blender whose Python has no torch, nothing can be compared with the core.
collect_ignore_glob = [] if importlib.util.find_spec("torch") else ["*_matches_cycles.py"]


@pytest.hookimpl(trylast=True)
def pytest_unconfigure(config: pytest.Config) -> None:
    """Exit at once: bpy 4.5 sometimes hangs in an ordinary exit, after the report."""
    if "bpy" in sys.modules and hasattr(config, "ended_with"):
        sys.stdout.flush()
        sys.stderr.flush()
        os._exit(config.ended_with)


def pytest_sessionfinish(session: pytest.Session, exitstatus: int) -> None:
    session.config.ended_with = int(exitstatus)


_emptied: set[object] = set()  # the module whose last test left a file with nothing in it


def pytest_runtest_setup(item: pytest.Item) -> None:
    """Who does not ask for an empty file may leave one that is not."""
    if "empty" not in item.fixturenames:
        _emptied.clear()


@pytest.fixture
def empty(request: pytest.FixtureRequest) -> Iterator[None]:
    """A file with nothing in it, before and after; made once between two such tests of a module."""
    bpy = pytest.importorskip("bpy")
    if request.module not in _emptied:  # its own fixtures may have used Blender since another's
        bpy.ops.wm.read_factory_settings(use_empty=True)
    _emptied.clear()
    yield
    bpy.ops.wm.read_factory_settings(use_empty=True)
    _emptied.add(request.module)


@pytest.fixture
def asset(tmp_path: Path) -> Path:
    """The asset folder of a small, asymmetric block."""
    return write_asset(tmp_path / "asset")


@pytest.fixture
def addon(empty: None) -> Iterator[None]:
    """The add-on, registered. It must not stay so: bpy hangs at exit with classes of ours."""
    import fantasia3d_addon

    fantasia3d_addon.register()
    yield
    fantasia3d_addon.unregister()


@pytest.fixture
def ready(addon, tmp_path, monkeypatch):
    """The settings of the add-on with the fake core, an asset to make, and a folder for runs."""
    import bpy

    from fantasia3d_addon import environment
    from fantasia3d_addon.jobs import paths

    monkeypatch.setenv("FANTASIA3D_PYTHON", sys.executable)
    monkeypatch.setattr(environment, "project_root", lambda: FAKE_CORE)
    monkeypatch.setattr(paths.Paths, "runs", tmp_path / "runs")
    settings = bpy.context.scene.fantasia3d
    settings.prompt = "a red wooden chair"
    settings.negative_prompt = str(write_asset(tmp_path / "made"))  # the fake core hands it out
    return settings


@pytest.fixture
def wait() -> Callable[..., None]:
    """Calls the session's tick as a timer would, until all has ended or ``until`` is true."""
    from fantasia3d_addon.jobs.session import BUG, session

    def until_the_end(until: Callable[[], bool] = lambda: False, seconds: float = 60.0) -> None:
        deadline = time.monotonic() + seconds
        while session.tick() is not None and not until():
            assert time.monotonic() < deadline
            assert session.error is None or session.error[1] != BUG, session.error
            time.sleep(0.01)

    return until_the_end
