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
    command = ["xvfb-run", "-a", "-s", "-screen 0 1280x720x24", *shlex.split(blender)]
    command += ["--factory-startup", "--python", str(SCRIPT), "--", str(out), str(asset)]
    done = subprocess.run(
        command, cwd=SCRIPT.parents[1], timeout=900, capture_output=True, text=True
    )
    path = out / "report.json"
    assert path.exists(), done.stdout[-2000:] + done.stderr[-2000:]
    told = json.loads(path.read_text())
    assert "traceback" not in told, told["traceback"]
    return told | {"folder": out}


def test_the_bar_moves_and_cancel_is_answered(report):
    assert report["generate"] == report["cancel"] == ["FINISHED"]
    assert len(set(report["lines"])) > 1
    assert report["last"] == "cancelled"


def test_an_error_is_a_sentence_with_its_fix(report):
    assert report["error"] == ["There is no noun 'blorb'.", "Say chair."]


def test_the_asset_stands_in_the_scene_and_is_one_undo_step(report):
    assert report["objects"] == ["a red wooden chair"]
    assert report["after_undo"] == []


def test_blender_is_never_held_up_while_a_job_runs(report):
    ticks = [seconds for running, seconds in report["ticks"] if running]
    assert len(ticks) > 5
    assert max(ticks) < 0.05


def test_the_panel_is_drawn(report):
    """The screenshots differ: the bar, the error, the asset."""
    pictures = [report["folder"] / f"{n}.png" for n in ("before", "running", "error", "done")]
    assert len({path.read_bytes() for path in pictures}) == 4
