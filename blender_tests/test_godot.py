"""The Godot export in Godot itself, without a window: ``-m slow``, and godot3-server on PATH.

FANTASIA3D_GODOT is its command otherwise (Debian: apt install godot3-server; tried with 3.2.3).
"""

import json
import os
import shlex
import shutil
import subprocess
import time
from pathlib import Path

import numpy as np
import pytest

bpy = pytest.importorskip("bpy")

from blender_tests.asset_fixture import bump_normals, write_asset  # noqa: E402
from fantasia3d_addon.asset.import_asset import import_asset  # noqa: E402
from fantasia3d_addon.blender.mesh_arrays import verts_of  # noqa: E402
from fantasia3d_addon.mesh import engines  # noqa: E402

pytestmark = [pytest.mark.slow, pytest.mark.blender, pytest.mark.usefixtures("empty")]
SCRIPT = Path(__file__).with_name("godot_scene.gd")
PROJECT = 'config_version=4\n[application]\nconfig/name="asset"\n'
GREEN, BLUE = 1, 2  # SpatialMaterial.TextureChannel


@pytest.fixture
def godot():
    """The command, as words."""
    given = os.environ.get("FANTASIA3D_GODOT") or shutil.which("godot3-server")
    if not given:
        pytest.skip("there is no godot3-server on PATH and no FANTASIA3D_GODOT")
    return shlex.split(given)


def imported(godot: list[str], project: Path) -> None:
    """Let the editor import what is in ``project``; it may hang then, so it is killed."""
    editor = subprocess.Popen(
        [*godot, "--path", str(project), "--editor", "--quit"],
        stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
    )  # fmt: skip
    try:
        deadline = time.monotonic() + 300
        while not list(project.glob(".import/*.md5")):  # the last file of an import
            assert time.monotonic() < deadline, "Godot imported nothing in five minutes."
            time.sleep(0.2)
    finally:
        editor.kill()
        editor.wait()


def scene(godot: list[str], glb: Path, project: Path) -> list[dict]:
    """The nodes that Godot makes of ``glb``."""
    project.mkdir()
    (project / "project.godot").write_text(PROJECT)
    shutil.copy(glb, project / "asset.glb")
    shutil.copy(SCRIPT, project / "scene.gd")
    imported(godot, project)
    command = [*godot, "--path", str(project), "--script", "scene.gd"]
    done = subprocess.run(command, capture_output=True, text=True, timeout=300)
    lines = [line for line in done.stdout.splitlines() if line.startswith("SCENE ")]
    assert lines, done.stdout + done.stderr
    return json.loads(lines[0].removeprefix("SCENE "))


def test_godot_gets_metres_the_front_along_z_one_material_and_convex_colliders(godot, tmp_path):
    obj = import_asset(bpy.context, write_asset(tmp_path / "asset", normal=bump_normals(64)))
    points = verts_of(obj.data)
    low, high = points.min(0), points.max(0)
    rows = scene(godot, engines.export_for(obj, tmp_path / "out", "godot"), tmp_path / "project")
    (mesh,) = [row for row in rows if row["kind"] == "MeshInstance"]
    np.testing.assert_allclose(mesh["low"], [low[0], low[2], -high[1]], atol=1e-4)
    np.testing.assert_allclose(mesh["high"], [high[0], high[2], -low[1]], atol=1e-4)
    assert mesh["name"] == "a_red_wooden_chair"
    assert mesh["textures"] == [True] * 3
    assert mesh["channels"] == [GREEN, BLUE]
    hulls = [row for row in rows if row["kind"] == "CollisionShape"]
    assert hulls and {row["shape"] for row in hulls} == {"ConvexPolygonShape"}
    assert len([row for row in rows if row["kind"] == "StaticBody"]) == len(hulls)
    corners = np.concatenate([row["points"] for row in hulls])
    size = np.array(mesh["high"]) - mesh["low"]
    np.testing.assert_allclose(corners.min(0), mesh["low"], atol=0.05 * size.max())
    np.testing.assert_allclose(corners.max(0), mesh["high"], atol=0.05 * size.max())
