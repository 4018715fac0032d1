"""What run.py does inside Blender: the core's job, then the asset, the file and the picture."""

import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest

bpy = pytest.importorskip("bpy")

from blender_tests.asset_fixture import write_asset  # noqa: E402
from blender_tests.pictures import read  # noqa: E402
from blender_tests.processes import blender_command  # noqa: E402
from fantasia3d_addon.cli import headless  # noqa: E402
from fantasia3d_addon.scene import render  # noqa: E402

pytestmark = [pytest.mark.blender, pytest.mark.usefixtures("empty")]
FAKE_CORE = Path(__file__).parent / "fake_core"
PYTHON = Path(sys.executable)


def run_core(prompt, folder, blend=None, render=None) -> int:
    """A job of the fake core, whose asset Blender takes."""
    command = [PYTHON, "-P", "-m", "core", "generate", prompt, "--out", folder]
    environ = {"PYTHONPATH": str(FAKE_CORE)}
    return headless.run_job(command, folder / "asset", blend, render, environ)


@pytest.fixture
def quick(monkeypatch):
    """Pictures of 32 pixels and two samples."""
    set_up = render.set_up_cycles

    def small(target):
        set_up(target, 32, 2)
        target.cycles.use_denoising = False
        target.world.cycles.sampling_method = "MANUAL"
        target.world.cycles.sample_map_resolution = 64

    monkeypatch.setattr(render, "set_up_cycles", small)


def test_a_job_ends_in_a_file_and_a_picture(asset, tmp_path, quick, monkeypatch, capfd):
    monkeypatch.setenv("FAKE_ASSET", str(asset))
    out, blend, png = tmp_path / "run", tmp_path / "new" / "chair.blend", tmp_path / "chair.png"
    assert run_core("a chair", out, blend, png) == 0
    output = capfd.readouterr().out
    assert "the fake core" in output
    assert str(blend) in output
    assert "Fra:" not in output  # Blender's own chatter
    assert read(png).shape == (32, 32, 3)
    bpy.ops.wm.open_mainfile(filepath=str(blend))
    (mesh,) = (obj for obj in bpy.data.objects if obj.type == "MESH")
    assert mesh.name == "a red wooden chair"
    assert bpy.context.scene.camera is not None
    assert bpy.context.scene.world.name.startswith("Fantasia3D")
    assert all(image.packed_file for image in bpy.data.images)
    assert sorted(p.name for p in blend.parent.iterdir()) == ["chair.blend"]


def test_without_files_to_make_blender_does_nothing(asset, tmp_path, monkeypatch):
    monkeypatch.setenv("FAKE_ASSET", str(asset))
    assert run_core("a chair", tmp_path / "run") == 0
    assert not bpy.data.objects


def test_the_cores_sentence_and_status_are_passed_on(tmp_path, capfd):
    blend = tmp_path / "x.blend"
    assert run_core("fail", tmp_path / "run", blend) == 2
    assert "error: There is no noun 'blorb'. Say chair." in capfd.readouterr().err
    assert not blend.exists()


def test_a_core_that_dies_has_the_status_of_its_signal(tmp_path):
    assert run_core("die", tmp_path / "run") == 134


def test_ctrl_c_is_the_cores_to_answer(tmp_path):
    """In a terminal both processes get it: the core stops cleanly, and Blender passes that on."""
    code = (
        "import os; from pathlib import Path; from blender_tests.test_headless import run_core\n"
        f"os._exit(run_core('long', Path({str(tmp_path / 'run')!r}), Path('x.blend')))"
    )
    process = subprocess.Popen(blender_command(code), start_new_session=True)
    events, deadline = tmp_path / "run" / "events.jsonl", time.monotonic() + 60
    while not events.exists() or b"progress" not in events.read_bytes():
        assert time.monotonic() < deadline
        time.sleep(0.05)
    os.killpg(process.pid, signal.SIGINT)
    assert process.wait(60) == 130
    assert b"cancelled" in events.read_bytes()


@pytest.mark.parametrize("handler", [signal.SIG_DFL, signal.default_int_handler, None])
def test_the_handler_of_ctrl_c_is_as_before(monkeypatch, handler):
    """None is Blender's own, in C, which Python can neither name nor put back."""
    calls = []
    monkeypatch.setattr(signal, "getsignal", lambda number: handler)
    monkeypatch.setattr(signal, "signal", lambda number, new: calls.append(new))
    with headless._ignore_ctrl_c():
        assert calls == ([] if handler is None else [signal.SIG_IGN])
    assert calls[1:] == ([] if handler is None else [handler])


def test_no_asset_is_a_sentence_and_status_2(tmp_path, capfd):
    assert headless.finish(tmp_path, blend=tmp_path / "x.blend") == 2
    assert "error: " in (output := capfd.readouterr().err)
    assert "has no asset.json" in output
    assert not (tmp_path / "x.blend").exists()


@pytest.mark.parametrize("option", ["blend", "render"])
def test_a_place_that_cannot_be_written_is_a_sentence_and_status_2(
    asset, tmp_path, quick, capfd, option
):
    (tmp_path / "file").touch()
    place = tmp_path / "file" / f"x.{'blend' if option == 'blend' else 'png'}"
    assert headless.finish(asset, **{option: place}) == 2
    assert f"error: {place} can't be written" in capfd.readouterr().err


def test_the_light_is_the_assets_own_unless_another_is_named(tmp_path, quick, capfd):
    for output, given, name in (
        ("blender:city", None, "city.exr"),
        ("blender:city", "studio", "studio.exr"),
        (None, None, "studio.exr"),
        ("/gone.hdr", None, "studio.exr"),
    ):
        folder = write_asset(tmp_path / str(len(list(tmp_path.iterdir()))), light=output)
        assert headless.finish(folder, blend=tmp_path / "x.blend", light=given) == 0
        assert [i.name for i in bpy.data.images if i.name.endswith(".exr")] == [name]
        assert ("warning: There is no light" in capfd.readouterr().err) == (output == "/gone.hdr")


def test_an_open_file_keeps_its_own_scene(asset, tmp_path):
    bpy.data.objects.new("mine", None)
    world = bpy.data.worlds.new("my world")
    bpy.context.scene.world = world
    bpy.data.objects["mine"].use_fake_user = True
    bpy.ops.wm.save_as_mainfile(filepath=str(tmp_path / "mine.blend"))
    assert headless.finish(asset, blend=tmp_path / "both.blend") == 0
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "both.blend"))
    assert {"mine", "a red wooden chair"} <= set(bpy.data.objects.keys())
    assert bpy.context.scene.world.name == "my world"


def test_quiet_lets_errors_through(capfd):
    with headless._quiet():
        os.write(1, b"chatter\n")
        os.write(2, b"an error\n")
    print("after", flush=True)
    output = capfd.readouterr()
    assert (output.out, output.err) == ("after\n", "an error\n")
