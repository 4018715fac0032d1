"""The panel in a real window; needs Xvfb and ImageMagick, and Blender's command line.

FANTASIA3D_BLENDER is that command; else ``blender`` on PATH.
"""

import json
import os
import shlex
import shutil
import subprocess
from pathlib import Path

import pytest

from blender_tests.asset_fixture import write_asset

pytestmark = pytest.mark.window
SCRIPT = Path(__file__).with_name("window_script.py")


@pytest.fixture(scope="module")
def report(tmp_path_factory):
    blender = os.environ.get("FANTASIA3D_BLENDER") or shutil.which("blender")
    if not blender:
        pytest.skip("there is no Blender on PATH or in FANTASIA3D_BLENDER")
    if not shutil.which("xvfb-run"):
        pytest.skip("there is no xvfb-run")
    out = tmp_path_factory.mktemp("window")
    asset = write_asset(out / "asset", size=128)
    command = ["xvfb-run", "-a", "-s", "-screen 0 1280x800x24", *shlex.split(blender)]
    command += ["--factory-startup", "--enable-event-simulate"]
    command += ["--window-geometry", "0", "0", "1280", "800"]
    command += ["--python", str(SCRIPT), "--", str(out), str(asset)]
    done = subprocess.run(
        command, cwd=SCRIPT.parents[1], timeout=900, capture_output=True, text=True
    )
    path = out / "report.json"
    assert path.exists(), done.stdout[-2000:] + done.stderr[-2000:]
    told = json.loads(path.read_text())
    assert "traceback" not in told, told["traceback"]
    return told | {"folder": out}


def test_a_prompt_is_typed_and_generate_is_clicked(report):
    """By events of the keyboard and the mouse."""
    assert report["prompt"] == "show"
    assert report["clicked"]


def test_the_bar_moves_and_cancel_is_answered_within_a_second(report):
    assert len(set(report["lines"])) > 2
    assert report["waits_for"] == "Waits for the present step of “Shape”"
    assert report["last"] == "cancelled"
    assert report["cancel_seconds"] < 1.0


def test_the_shape_grows_in_the_viewport_and_leaves_nothing(report):
    shapes = [tuple(shape) for shape in report["shapes"] if shape]
    assert len(set(shapes)) > 2
    assert report["left"] == []


def test_an_error_is_a_sentence_with_its_fix(report):
    assert report["error"] == ["There is no noun 'blorb'.", "Say chair."]


def test_the_asset_stands_in_the_scene_and_is_one_undo_step(report):
    assert report["objects"] == report["after_redo"] == ["a red wooden chair"]
    assert report["after_undo"] == []


def test_blender_is_never_held_up_while_a_job_runs(report):
    """By the thread's own clock: another process's turn is not ours."""
    ticks = [cpu for running, _wall, cpu in report["ticks"] if running]
    assert len(ticks) > 5
    assert max(ticks) < 0.05


def test_the_panel_is_drawn(report):
    """The screenshots differ: the bar, the error, the asset."""
    names = ("empty", "before", "running", "cancelled", "error", "done")
    pictures = [report["folder"] / f"{name}.png" for name in names]
    assert len({path.read_bytes() for path in pictures}) == len(names)
