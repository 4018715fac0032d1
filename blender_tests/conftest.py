"""Fixtures of the tests under Blender: an empty file, an asset folder, the add-on registered."""

from collections.abc import Iterator
from pathlib import Path

import pytest

from blender_tests.asset_fixture import write_asset


@pytest.fixture
def empty() -> Iterator[None]:
    """A file with nothing in it, before and after."""
    bpy = pytest.importorskip("bpy")
    bpy.ops.wm.read_factory_settings(use_empty=True)
    yield
    bpy.ops.wm.read_factory_settings(use_empty=True)


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
