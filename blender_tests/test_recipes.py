"""The recipes' code runs as printed, except for its sizes; and no operator is missing there."""

import re

import pytest

from blender_tests.processes import ROOT

bpy = pytest.importorskip("bpy")

from fantasia3d_addon.blender import compat  # noqa: E402
from fantasia3d_addon.mesh import asset_browser  # noqa: E402
from fantasia3d_addon.ui import registration  # noqa: E402

pytestmark = pytest.mark.blender
PAGE = (ROOT / "docs" / "recipes.md").read_text("utf-8")
TOOLS, JOBS = re.findall(r"```python\n(.*?)```", PAGE, re.DOTALL)
SMALL = (  # the same calls with fewer pixels, frames and faces, and a smaller light
    ('"sunset"', '"studio"'),
    ("bl_ext.user_default.fantasia3d", "fantasia3d_addon"),
    ("frames=96", "frames=2, size=16, samples=1"),
    ("frames=60", "frames=4"),
    ("faces=4000", "faces=300, size=32"),
)


def run(code: str) -> dict:
    for given, small in SMALL:
        code = code.replace(given, small)
    names: dict = {}
    exec(compile(code, "recipes.md", "exec"), names)
    return names


def test_the_tools_recipe_runs(empty, asset, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(asset_browser, "SIZE", 32)
    monkeypatch.setattr(asset_browser, "SAMPLES", 1)
    monkeypatch.setattr(compat, "has_denoiser", lambda: False)
    (tmp_path / "out").mkdir()
    asset.rename(tmp_path / "out" / "chair")
    assert all(given in TOOLS for given, _small in SMALL)
    names = run(TOOLS)
    assert names["chair"].asset_data
    assert len(names["lods"]) == 3
    assert {len(p.vertices) for p in names["quads"].data.polygons} == {4}
    made = {path.name: path.stat().st_size for path in tmp_path.glob("chair.*")}
    assert set(made) == {"chair.mp4", "chair.glb"} and min(made.values()) > 500


def test_the_jobs_recipe_runs(ready, capsys):
    run(JOBS)
    output = capsys.readouterr().out.splitlines()
    assert output[1] == "Ready to generate."
    assert output[2] == "a red wooden chair"
    assert output[3].startswith("done {")
    assert output[4] == "cancelled"


def test_every_operator_is_named():
    names = {
        cls.bl_idname.partition(".")[2]
        for cls in registration.CLASSES
        if issubclass(cls, bpy.types.Operator)
    }
    text = re.sub(r"```.*?```", "", PAGE, flags=re.DOTALL)
    documented = set(re.findall(r"\b[a-z_]+\b", " ".join(re.findall(r"`([^`]+)`", text))))
    assert names <= documented, names - documented
