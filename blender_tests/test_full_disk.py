"""Blender's output on a full disk or in a read-only folder: the older file stays; it is reported.

The disk is a small file system in memory, which only root may mount.
"""

import os
import subprocess
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

bpy = pytest.importorskip("bpy")

from blender_tests.asset_fixture import write_asset  # noqa: E402
from blender_tests.pictures import set_light  # noqa: E402
from fantasia3d_addon.asset.import_asset import import_asset  # noqa: E402
from fantasia3d_addon.blender import compat, output  # noqa: E402
from fantasia3d_addon.errors import OutputError  # noqa: E402
from fantasia3d_addon.mesh import asset_browser, export  # noqa: E402
from fantasia3d_addon.scene import relight  # noqa: E402
from fantasia3d_addon.scene import render as scene_render  # noqa: E402

pytestmark = [
    pytest.mark.blender,
    pytest.mark.usefixtures("empty"),
    # Blender 5.2's own FBX exporter under NumPy 2.5
    pytest.mark.filterwarnings("ignore:Setting the shape:DeprecationWarning"),
]
OLD = b"the older file"
FREE = 4096  # bytes that are left: no output is so small


def remount(disk: Path, option: str) -> None:
    subprocess.run(["mount", "-o", f"remount,{option}", str(disk)], check=True)


@pytest.fixture
def disk(tmp_path: Path) -> Iterator[Path]:
    """A file system of 16 MB."""
    disk = tmp_path / "disk"
    disk.mkdir()
    mount = ["mount", "-t", "tmpfs", "-o", "size=16m", "tmpfs", str(disk)]
    if sys.platform != "linux" or subprocess.run(mount, capture_output=True).returncode:
        pytest.skip("only root may mount a small file system")
    yield disk
    subprocess.run(["umount", "-l", str(disk)], check=True)


@pytest.fixture
def obj(tmp_path: Path) -> "bpy.types.Object":
    """The block, in a scene with a camera and a light."""
    made = import_asset(bpy.context, write_asset(tmp_path / "asset"))
    bpy.context.view_layer.update()
    scene = bpy.context.scene
    scene_render.add_camera(scene, made)
    set_light(tmp_path, (0.4, -1, 0.4))
    scene_render.set_up_cycles(scene, 64, 1)
    return made


def library(obj: "bpy.types.Object", path: Path) -> None:
    asset_browser.mark_asset(obj, thumbnail=False)
    obj.name = path.stem
    asset_browser.save_to_library(obj, path.parent)


def turntable(obj: "bpy.types.Object", path: Path) -> None:
    relight.turntable(obj, path, frames=2, size=64, samples=1)


OUTPUTS: dict[str, Callable[["bpy.types.Object", Path], object]] = {
    "saved.blend": lambda _, path: scene_render.save_blend(path),
    "library.blend": library,
    **{
        f"picture{x}": lambda obj, path: scene_render.render_still(path, obj)
        for x in (".png", ".exr")
    },
    **{f"export{x}": export.export_object for x in (".glb", ".usdc", ".fbx", ".obj")},
    "turntable.mp4": turntable,
    "frames": turntable,
}


def fill(disk: Path, leave: int) -> None:
    """Files of the user's fill ``disk`` up to ``leave`` bytes."""
    space = os.statvfs(disk)
    (disk / "the user's").write_bytes(bytes(space.f_bavail * space.f_frsize - leave))


def set_out(disk: Path, name: str) -> Path:
    """The output's path, with an older output there."""
    path = disk / name
    if "." in name:
        path.write_bytes(OLD)
    else:
        path.mkdir()
        (path / "frame_0001.png").write_bytes(OLD)
    return path


def contents(folder: Path) -> dict[str, bytes]:
    paths = (path for path in folder.rglob("*") if path.is_file() and path.name != "the user's")
    return {path.relative_to(folder).as_posix(): path.read_bytes() for path in paths}


@pytest.mark.parametrize("name", OUTPUTS)
def test_on_a_full_disk_the_older_file_stays(obj, disk, name):
    if (name == "turntable.mp4" and not compat.has_video()) or (
        name.endswith(".usdc") and not compat.has_usd()
    ):
        pytest.skip("this build does not write it")
    path = set_out(disk, name)
    before, scenes = contents(disk), len(bpy.data.scenes)
    fill(disk, FREE)
    with pytest.raises(OutputError) as refused:
        OUTPUTS[name](obj, path)
    assert str(path) in refused.value.text and "\n" not in str(refused.value)
    assert contents(disk) == before
    assert len(bpy.data.scenes) == scenes
    assert output.PREFIX not in bpy.context.scene.render.filepath
    (disk / "the user's").unlink()
    OUTPUTS[name](obj, path)  # nothing is left in the way
    assert OLD not in contents(disk).values()


@pytest.mark.parametrize("name", OUTPUTS)
def test_in_a_read_only_folder_the_older_file_stays(obj, disk, name):
    if (name == "turntable.mp4" and not compat.has_video()) or (
        name.endswith(".usdc") and not compat.has_usd()
    ):
        pytest.skip("this build does not write it")
    path = set_out(disk, name)
    before, scenes = contents(disk), len(bpy.data.scenes)
    remount(disk, "ro")
    with pytest.raises(OutputError) as refused:
        OUTPUTS[name](obj, path)
    assert str(path) in refused.value.text and "\n" not in str(refused.value)
    assert contents(disk) == before and len(bpy.data.scenes) == scenes
