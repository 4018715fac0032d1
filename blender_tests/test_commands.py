"""The command line's Blender side: relight, physics, cornell, exports."""

import re
import shutil
import subprocess
import sys

import pytest

bpy = pytest.importorskip("bpy")

import run  # noqa: E402
from blender_tests.pictures import lobe, read, write_hdr  # noqa: E402
from blender_tests.processes import ROOT  # noqa: E402
from fantasia3d_addon.blender import compat  # noqa: E402
from fantasia3d_addon.cli import commands, headless  # noqa: E402
from fantasia3d_addon.errors import AddonError  # noqa: E402
from fantasia3d_addon.scene import render  # noqa: E402

pytestmark = [
    pytest.mark.blender,
    pytest.mark.usefixtures("empty"),
    # Blender 5.2's own FBX exporter under NumPy 2.5
    pytest.mark.filterwarnings("ignore:Setting the shape:DeprecationWarning"),
]


@pytest.fixture
def quick(monkeypatch):
    """Pictures of 32 pixels and two samples, whatever is asked for."""
    set_up = render.set_up_cycles

    def small(target, size=0, samples=None):
        set_up(target, 32, 2)
        target.cycles.use_denoising = False
        if target.world:
            target.world.cycles.sampling_method = "MANUAL"
            target.world.cycles.sample_map_resolution = 32

    monkeypatch.setattr(render, "set_up_cycles", small)


def test_relight_makes_a_picture_a_turntable_and_a_file(asset, tmp_path, quick, capfd):
    light = write_hdr(tmp_path / "x.hdr", lobe((1, -0.5, 0.5)))
    argv = ["relight", str(asset), "--light", str(light), "--material", "gold"]
    argv += ["--render", str(tmp_path / "a.png"), "--blend", str(tmp_path / "a.blend")]
    argv += ["--turntable", str(tmp_path / "turn"), "--frames", "2"]
    assert headless.command(run.parse(argv)) == 0
    assert read(tmp_path / "a.png").shape == (32, 32, 3)
    assert len(list((tmp_path / "turn").iterdir())) == 2
    output = capfd.readouterr().out.splitlines()
    assert output[-3:] == [str(tmp_path / n) for n in ("a.blend", "a.png", "turn")]
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "a.blend"))
    (obj,) = (o for o in bpy.data.objects if o.type == "MESH")
    assert obj.active_material.name.startswith("Gold")


def test_physics_saves_the_baked_cloth(asset, tmp_path, quick):
    argv = ["physics", str(asset), "--physics", "cloth", "--frames", "8"]
    argv += ["--blend", str(tmp_path / "a.blend"), "--render", str(tmp_path / "a.png"), "--at", "5"]
    assert headless.command(run.parse(argv)) == 0
    assert (tmp_path / "a.png").is_file()
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "a.blend"))
    from fantasia3d_addon.physics import bake, simulation

    owner = simulation.owner_of(bpy.data.objects["a red wooden chair"])
    assert bake.cache_of(owner).is_baked
    assert bpy.context.scene.frame_current == 5


def test_cornell_accepts_several_assets(asset, tmp_path, quick):
    argv = ["cornell", str(asset), str(asset), "--blend", str(tmp_path / "a.blend")]
    assert headless.command(run.parse(argv)) == 0
    bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "a.blend"))
    assert sum(o.name.startswith("a red") for o in bpy.data.objects) == 2
    assert "Cornell box" in bpy.data.collections


def test_cornell_makes_assets_the_same_size_where_that_is_asked_for(asset, tmp_path, quick):
    small = tmp_path / "small"
    shutil.copytree(asset, small)
    mesh = (small / "mesh.obj").read_text(encoding="utf-8")
    numbers = re.compile(r"(?<=^v )(.*)$", re.MULTILINE)
    # Its longest side is its depth, which the box's camera does not see.
    by = (1 / 50, 1 / 50, 1 / 5)
    scaled = numbers.sub(
        lambda v: " ".join(str(float(x) * k) for x, k in zip(v[1].split(), by, strict=True)), mesh
    )
    (small / "mesh.obj").write_text(scaled, encoding="utf-8")
    sides = []
    for more in ([], ["--same-size"]):
        bpy.ops.wm.read_homefile(use_empty=True, use_factory_startup=True)
        argv = ["cornell", str(asset), str(small), "--blend", str(tmp_path / "a.blend"), *more]
        assert headless.command(run.parse(argv)) == 0
        bpy.ops.wm.open_mainfile(filepath=str(tmp_path / "a.blend"))
        shown = [o.dimensions for o in bpy.data.objects if o.name.startswith("a red")]
        large, little = (max(x, z) for x, _, z in shown)
        sides.append(large / little)
    assert sides == pytest.approx([50, 1], rel=1e-3)


@pytest.mark.parametrize("ending", ["fbx", "usdc"])
def test_export_writes_what_the_core_does_not(asset, tmp_path, ending):
    if ending == "usdc" and not compat.has_usd():
        pytest.skip("this build writes no USD")
    path = tmp_path / f"a.{ending}"
    argv = ["export", str(asset), "--format", ending.removesuffix("c"), "--out", str(path)]
    assert headless.command(run.parse(argv)) == 0
    assert path.stat().st_size > 1000


@pytest.mark.parametrize(
    ("argv", "message"),
    [
        (["relight", "X"], "There is nothing to write. Add --render, --turntable or --blend."),
        (["relight", "X", "--render", "a.png"], "it has no asset.json"),
        (["export", "X", "--format", "usd", "--out", "x.fbx"], "file's name ends in it"),
    ],
)
def test_what_cannot_be_is_one_sentence_and_exit_code_2(tmp_path, argv, message, capfd):
    argv = [str(tmp_path) if word == "X" else word for word in argv]
    assert headless.command(run.parse(argv)) == 2
    output = capfd.readouterr().err
    assert output.startswith("error: ")
    assert message in output
    assert "Traceback" not in output
    with pytest.raises(AddonError):
        commands.run(run.parse(argv))


RELIGHT = ["relight", "X", "--render", "a.png"]
PHYSICS = ["physics", "X", "--physics", "soft", "--render", "a.png"]


@pytest.mark.parametrize(
    ("command", "option", "value", "takes"),
    [
        (RELIGHT, "--strength", "nan", "0 to 1e+06"),
        (RELIGHT, "--strength", "inf", "0 to 1e+06"),
        (RELIGHT, "--strength", "-1", "0 to 1e+06"),
        (RELIGHT, "--strength", "bright", "0 to 1e+06"),
        (RELIGHT, "--rotation-deg", "nan", "any number"),
        (RELIGHT, "--rotation-deg", "-inf", "any number"),
        (RELIGHT, "--size", "0", "16 to 8192"),
        (RELIGHT, "--size", "-1", "16 to 8192"),
        (RELIGHT, "--size", "1000000", "16 to 8192"),
        (RELIGHT, "--size", "nan", "16 to 8192"),
        (RELIGHT, "--samples", "-1", "0 to 65536"),
        (RELIGHT, "--samples", "99999999", "0 to 65536"),
        (RELIGHT, "--frames", "1", "2 to 5000"),
        (PHYSICS, "--height", "inf", "0 to 1000"),
        (PHYSICS, "--height", "-5", "0 to 1000"),
        (PHYSICS, "--height", "1e30", "0 to 1000"),
        (PHYSICS, "--softness", "nan", "0 to 1"),
        (PHYSICS, "--softness", "5", "0 to 1"),
        (PHYSICS, "--frames", "0", "2 to 5000"),
        (["cornell", "X", "--render", "a.png"], "--size", "0", "16 to 8192"),
    ],
)
def test_a_number_out_of_its_range_is_refused_with_the_range(command, option, value, takes, capfd):
    assert run.main([*command, f"{option}={value}"]) == 2
    printed = capfd.readouterr().err
    assert printed.startswith("error: ") and printed.count("\n") == 1
    assert (
        option in printed and f"'{value}'" in printed and f"use {takes}" in printed.replace(".", "")
    )


def test_a_light_with_nan_is_refused_and_leaves_the_old_picture(asset, tmp_path, capfd):
    exr = pytest.importorskip("core.io.exr", reason="the core is not in this Python")
    import torch

    pixels = torch.ones(8, 16, 3)
    pixels[2, 3] = float("nan")
    exr.write_exr(tmp_path / "nan.exr", pixels)
    (tmp_path / "a.png").write_bytes(b"old")
    line = ["relight", str(asset), "--light", str(tmp_path / "nan.exr")]
    assert headless.command(run.parse([*line, "--render", str(tmp_path / "a.png")])) == 2
    assert "not finite numbers" in capfd.readouterr().err
    assert (tmp_path / "a.png").read_bytes() == b"old"


@pytest.mark.parametrize("name", ["a.fbx", "a.obj"])
def test_a_folder_is_no_place_for_an_export(asset, tmp_path, name, capfd):
    (tmp_path / name).mkdir()
    line = ["export", str(asset), "--format", name[2:], "--out", str(tmp_path / name)]
    assert headless.command(run.parse(line)) == 2
    assert f"{name} is a folder" in capfd.readouterr().err
    assert {path.name for path in tmp_path.iterdir()} == {asset.name, name}


@pytest.mark.slow
def test_the_command_line_itself_lights_an_asset(asset, tmp_path):
    if bpy.app.binary_path:
        pytest.skip("under Blender the launcher is tested by test_package.py")
    out = tmp_path / "a.png"
    command = [sys.executable, str(ROOT / "run.py"), "--inside", "relight", str(asset)]
    command += ["--render", str(out), "--size", "32", "--samples", "2"]
    done = subprocess.run(command, capture_output=True, text=True, timeout=300)
    last = done.stdout.splitlines()[-1:]  # bpy 5.2 prints its colour configuration before
    assert (done.returncode, last) == (0, [str(out)]), done.stderr


def test_lod_keeps_to_its_budget_and_remesh_makes_quads(asset, tmp_path):
    line = ["lod", str(asset), "--max-faces", "200", "--out", str(tmp_path / "low.obj")]
    assert headless.command(run.parse(line)) == 0
    faces = [li for li in (tmp_path / "low.obj").read_text().splitlines() if li[:2] == "f "]
    assert 180 <= len(faces) <= 200
    line = ["lod", str(asset), "--levels", "2", "--out", str(tmp_path / "chair.obj")]
    assert headless.command(run.parse(line)) == 0
    sizes = [(tmp_path / f"chair_LOD{i}.obj").read_text().count("\nf ") for i in (1, 2)]
    assert sizes[1] == pytest.approx(sizes[0] / 2, rel=0.05)
    line = ["remesh", str(asset), "--max-faces", "300", "--texture-size", "32"]
    assert headless.command(run.parse([*line, "--out", str(tmp_path / "quads.obj")])) == 0
    text = (tmp_path / "quads.obj").read_text()
    rows = [li.split() for li in text.splitlines() if li[:2] == "f "]
    assert all(len(row) == 5 for row in rows) and 150 < len(rows) < 600


def test_an_export_into_a_folder_is_named_by_the_prompt(asset, tmp_path, capfd):
    line = ["export", str(asset), "--format", "fbx", "--out", str(tmp_path / "out")]
    assert headless.command(run.parse(line)) == 0
    assert [path.name for path in (tmp_path / "out").iterdir()] == ["a_red_wooden_chair.fbx"]
    line = ["export", str(asset), "--format", "unity", "--out", str(tmp_path / "unity")]
    assert headless.command(run.parse(line)) == 0
    assert (tmp_path / "unity" / "a_red_wooden_chair.fbx").is_file()
    assert (tmp_path / "unity" / "a_red_wooden_chair_MaskMap.png").is_file()
    line = ["export", str(asset), "--format", "unreal", "--out", str(tmp_path / "x.fbx")]
    assert headless.command(run.parse(line)) == 2
    assert "Name a folder with --out" in capfd.readouterr().err
