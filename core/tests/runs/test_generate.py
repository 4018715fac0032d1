"""The main job, short but real: words in, an asset folder out, by the command line."""

import os
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import torch
from PIL import Image

from core.command_line import main
from core.config import preset
from core.generate import back, generate, is_own_shape, prepare, styled_inputs, unstyled
from core.geometry.marching_tets import marching_tets
from core.geometry.mesh import Mesh, normalise
from core.geometry.tangents import shading_normals
from core.geometry.tet_grid import tet_grid
from core.guidance.builtin.physical import usual_of
from core.io.asset import inspect, read_asset
from core.io.job import LAST, Job, read_events
from core.io.maps import Maps
from core.io.obj import obj_text
from core.io.progress import Progress
from core.io.run_folder import RunFolder
from core.job_config import retouching, shortened
from core.stages.texturing import load_unwrapped
from core.tests import tiny_runs
from core.tests.forked import ONE_THREAD, Session
from core.tests.offline import ONLINE, alone_here, attempts, cut_off, recorder
from core.texture.region import Region

ROOT = Path(__file__).parents[3]
SHORT = {
    "geometry.coarse.steps": 4,
    "geometry.grow.rounds": 1,
    "geometry.grow.steps": 2,
    "geometry.grow.views": 2,
    "geometry.grow.denoise_steps": 2,
    "geometry.fine.steps": 2,
    "geometry.refine.rounds": 2,
    "geometry.refine.steps": 2,
    "geometry.refine.views": 2,
    "geometry.refine.denoise_steps": 2,
    "geometry.sharpen.rounds": 1,
    "geometry.sharpen.views": 2,
    "geometry.sharpen.passes": 1,
    "geometry.sharpen.steps": 2,
    "geometry.sharpen.size": 32,
    "geometry.resolution": "12,14",
    "geometry.fit_steps": 6,
    "geometry.views": 2,
    "geometry.views_at_once": 2,
    "appearance.early.steps": 8,
    "appearance.late.steps": 2,
    "appearance.refine.rounds": 1,
    "appearance.refine.steps": 4,
    "appearance.refine.views": 2,
    "appearance.refine.denoise_steps": 2,
    "appearance.refine.size": 32,
    "appearance.learning_rate": 0.05,
    "appearance.early.size": 32,
    "appearance.late.size": 32,
    "appearance.views": 2,
}
OPTIONS = [f"--set={key}={value}" for key, value in SHORT.items()]
OPTIONS += ["--texture-size=64", "--max-faces=150"]


def core(*argv: object) -> "subprocess.Popen[str]":
    """A process of its own."""
    environ = os.environ | {"PYTHONPATH": str(ROOT)} | ONE_THREAD
    command = [sys.executable, "-m", "core", *map(str, argv)]
    return subprocess.Popen(
        command, env=environ, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True
    )


def finished(process: "subprocess.Popen[str]") -> tuple[int, str]:
    output = process.communicate(timeout=600)[0]
    return process.returncode, output


@pytest.fixture
def fork(tmp_path: Path) -> Callable[..., Session]:
    """A session that need not be a process from its very beginning."""
    return lambda *argv, before="": Session.start(argv, tmp_path / "output.txt", before)


def wait_for(run: Path, stage: str, step: int, seconds: float = 300) -> None:
    """Until the run has come to that step."""
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        events = read_events(run) if run.exists() else []
        if any(e.get("stage") == stage and e.get("step", 0) >= step for e in events):
            return
        assert not any(e["type"] in LAST for e in events), events[-1]
        time.sleep(0.05)
    raise AssertionError(f"{run} never came to {stage} {step}")


@pytest.fixture(scope="module")
def whole(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """One unbroken run, in a folder with a difficult name, without a network."""
    run = tmp_path_factory.mktemp("ein Lauf ü") / "rot"
    record = recorder(run.parent / "recorder")
    line = ("generate", "a red torus", "--out", run, *OPTIONS)
    session = Session.start(line, run.parent / "output.txt", before=alone_here(record))
    status, output = session.finished()
    assert status == 0, output
    assert output.splitlines()[-1] == str(run / "asset")
    return run


def test_the_asset_is_whole_and_closed(whole):
    report = inspect(whole)
    assert report["prompt"] == "a red torus"
    mesh = report["mesh"]
    assert mesh["closed"]
    assert mesh["manifold"]
    assert mesh["oriented"]
    assert mesh["volume"] > 0
    assert mesh["faces"] <= 150
    assert mesh["bounds"][0][2] == pytest.approx(0, abs=1e-6)
    assert report["size_m"] == pytest.approx(usual_of("a red torus")[0], abs=1e-5)
    mass = mesh["volume"] * usual_of("a red torus")[1]
    assert report["mass_kg"] == pytest.approx(mass, rel=1e-3)
    names = {p.name for p in (whole / "asset").iterdir()}
    for name in ("asset.json", "mesh.obj", "base_color.png", "orm.png", "normal.png", "asset.glb"):
        assert name in names
    assert not (whole / "asset.tmp").exists()
    assert set(report["timings"]) >= {"fit", "geometry", "unwrap", "appearance", "bake"}


def test_a_run_reaches_for_no_network(whole):
    """Nor had it one, where that is permitted (test_offline.py)."""
    assert attempts(whole.parent / "recorder") == []


@pytest.mark.skipif(not cut_off(), reason="no network namespace may be made here")
def test_an_attempt_of_such_a_run_would_fail_and_be_recorded(fork, tmp_path):
    record = recorder(tmp_path / "recorder")
    status, output = fork("words", "a chair", before=alone_here(record) + ONLINE).finished()
    assert status == 0, output
    assert output.split()[:2] == ["OSError", "gaierror"]
    tried = {line.split()[0] for line in attempts(record)}
    assert tried == {"socket.connect", "socket.getaddrinfo"}


def test_red_becomes_redder_even_in_a_few_steps(whole):
    kd = read_asset(whole).maps.base_color.flatten(0, 1).mean(0)
    assert float(kd[0]) > float(kd[1]) + 0.05
    assert float(kd[0]) > float(kd[2]) + 0.05


def test_the_events_tell_the_story(whole):
    events = read_events(whole)
    assert events[0]["type"] == "started"
    assert events[0]["pid"] > 0
    assert [e["type"] for e in events if e["type"] in LAST] == ["done"]
    assert events[-1] == events[-1] | {"type": "done", "path": "asset"}
    stages = list(dict.fromkeys(e["stage"] for e in events if e["type"] == "progress"))
    assert stages == ["fit", "geometry", "unwrap", "appearance", "bake"]
    for event in events:
        if event["type"] == "preview":
            assert (whole / event["path"]).is_file()


def test_a_cancel_is_heard_while_the_core_loads_and_over_once_it_was_carried_out(fork, tmp_path):
    run = RunFolder.create(tmp_path / "run", Job(prompt="a red torus", settings=SHORT))
    cancel = run.path / "cancel"
    cancel.touch()
    os.utime(cancel, (0, 0))  # one of an earlier session
    session = fork("resume", run.path)
    wait_for(run.path, "fit", 1)
    future = time.time() + 3600
    cancel.touch()
    os.utime(cancel, (future, future))  # as seen after the clock was set back
    assert session.finished()[0] == 130
    assert not cancel.exists()
    process = core("resume", run.path)
    time.sleep(0.05)  # not even Python is loaded, on a busy machine; files' clocks are coarse
    cancel.touch()
    assert finished(process)[0] == 130
    assert [e["type"] for e in read_events(run.path)][-2:] == ["started", "cancelled"]


KILLED = "import os, core.generate\ncore.generate.unwrap_shape = lambda *a, **k: os._exit(9)"


def test_a_killed_and_a_cancelled_run_resume_to_the_same_asset(whole, fork, tmp_path):
    """Killed in the geometry, killed after it, cancelled in the appearance, and still the same.

    After the second kill no step of the geometry is left, so that nothing may depend on one having
    been taken: such a run once extracted with the coarse lattice's cell, another mesh.obj.
    """
    run = tmp_path / "run"
    session = fork("generate", "a red torus", "--out", run, *OPTIONS)
    wait_for(run, "geometry", 3)
    session.kill()
    assert not (run / "asset").exists()

    assert fork("resume", run, before=KILLED).finished()[0] == 9
    assert {path.stem for path in (run / "checkpoint").iterdir()} == {"geometry"}

    session = fork("resume", run)
    wait_for(run, "appearance", 1)
    session.interrupt()
    status, output = session.finished()
    assert status == 130, output
    assert "Traceback" not in output
    assert read_events(run)[-1]["type"] == "cancelled"

    status, output = fork("resume", run).finished()
    assert status == 0, output
    for name in ("mesh.obj", "base_color.png", "orm.png", "normal.png"):
        assert (run / "asset" / name).read_bytes() == (whole / "asset" / name).read_bytes(), name


# The last of 9 steps carries the whole lattice outside.
VANISHED = """
from core.stages.guard import Guard
remember = Guard.remember
def last(guard, step):
    remember(guard, step)
    bias = guard._training.module.mlp[-1].bias.data
    if step == 8:
        guard._training.optimizer.step = lambda: bias[0].add_(100)
Guard.remember = last
"""


def test_a_surface_that_vanishes_at_the_last_step_exits_with_5(fork, tmp_path):
    run = tmp_path / "run"
    status, output = fork(*tiny_runs.generate(run), before=VANISHED).finished()
    assert status == 5, output
    assert "Traceback" not in output
    assert "vanished" in output
    assert read_events(run)[-1]["type"] == "error"
    assert fork("resume", run).finished()[0] == 5


def test_pictures_of_the_asset(whole, tmp_path):
    shaded, mask = tmp_path / "shaded.png", tmp_path / "mask.png"
    for name, path in (("shaded", shaded), ("mask", mask)):
        assert main(["render", str(whole), f"--out={path}", "--map", name, "--size", "48"]) == 0
    picture, inside = (np.asarray(Image.open(p).convert("RGB"), float) for p in (shaded, mask))
    assert picture.shape == (48, 48, 3)
    body = picture[inside[..., 0] == inside[..., 0].max()]
    assert len(body) > 50
    assert body[:, 0].mean() > body[:, 2].mean()


def test_retouching_keeps_more_the_stronger_it_is():
    config = preset("draft")
    assert retouching(config, 0.0) == config
    a, kept = config.appearance, retouching(config, 1.0).appearance
    assert kept.early.steps == 0
    assert kept.late.t_high == tuple(t / 2 for t in a.late.t_high)
    assert kept.learning_rate == pytest.approx(0.02 * a.learning_rate)
    assert kept.refine.rounds == 0
    half = retouching(config, 0.5).appearance.refine
    assert (half.rounds, half.steps) == (a.refine.rounds, a.refine.steps // 2)


def test_texture_starts_from_the_base_colour_over_the_meshs_own_uv(fork, tmp_path):
    """Two triangles that share texels are kept as they are; the colour is still there."""
    mesh = tmp_path / "wall.obj"
    text = "v -1 0 0\nv 1 0 0\nv 1 2 0\nv -1 2 0\nvt 0 0\nvt 1 0\nvt 1 1\n"
    mesh.write_text(text + "f 1/1 2/2 3/3\nf 3/1 4/2 1/3\n")
    Image.new("RGB", (8, 8), (40, 160, 60)).save(tmp_path / "green.png")
    run, words = tmp_path / "run", ["--uv=keep", f"--base-color={tmp_path / 'green.png'}"]
    status, output = fork(
        "texture", mesh, "a red cube", "--out", run, *words, "--strength=1", *OPTIONS
    ).finished()
    assert status == 0, output
    assert "overlap, so they share texels" in output
    asset = read_asset(run / "asset")
    assert sorted(asset.mesh.uv.tolist()) == [[0, 0], [1, 0], [1, 1]]
    green = torch.tensor([40, 160, 60]).div(255).pow(2.2)
    mean = asset.maps.base_color.flatten(0, 1).mean(0)
    torch.testing.assert_close(mean, green, atol=0.08, rtol=0)


def test_texture_keeps_the_users_mesh_and_its_place(fork, tmp_path):
    grid = tet_grid(6)
    verts, faces = marching_tets(grid.tet_verts, grid.tet_verts.norm(dim=1) - 0.7, grid)
    verts = verts * torch.tensor([1.0, 2.0, 0.5]) + torch.tensor([5.0, -3.0, 1.0])
    mesh = tmp_path / "Köpfchen.obj"
    flat = torch.zeros(1, 2)
    own = Mesh(verts, faces, flat, torch.zeros_like(faces))
    text = obj_text(own, shading_normals(own), "mesh")
    kept = [line for line in text.splitlines() if line.startswith("v ")]
    kept += [f"f {a} {b} {c}" for a, b, c in (faces + 1).tolist()]
    mesh.write_text("\n".join(kept) + "\n")
    run = tmp_path / "run"
    words = [*OPTIONS, "--max-faces=450"]  # it has 432
    status, output = fork("texture", mesh, "a blue ball", "--out", run, *words).finished()
    assert status == 0, output
    asset = read_asset(run)
    torch.testing.assert_close(asset.mesh.verts, verts, atol=1e-4, rtol=0)
    assert torch.equal(asset.mesh.faces, faces)
    kd = asset.maps.base_color.flatten(0, 1).mean(0)
    assert float(kd[2]) > float(kd[0])


@pytest.fixture
def small_disk(tmp_path: Path) -> Iterator[Path]:
    """A file system of a few megabytes."""
    disk = tmp_path / "disk"
    disk.mkdir()
    mount = ["mount", "-t", "tmpfs", "-o", "size=300k", "tmpfs", str(disk)]
    if sys.platform != "linux" or subprocess.run(mount, capture_output=True).returncode:
        pytest.skip("only root may mount a small file system")
    yield disk
    subprocess.run(["umount", str(disk)], check=True)


def test_a_full_disk_ends_with_a_sentence_and_nothing_half_written(fork, small_disk):
    run = small_disk / "run"
    status, output = fork(*tiny_runs.generate(run)).finished()
    assert status == 2, output
    assert "Traceback" not in output
    assert "No space" in output or "full" in output
    assert not (run / "asset").exists()
    assert not list(run.rglob("*.tmp"))


def test_a_simplified_mesh_goes_back_to_where_it_stood():
    grid = tet_grid(8)
    verts, faces = marching_tets(grid.tet_verts, grid.tet_verts.norm(dim=1) - 0.7, grid)
    mesh = Mesh(verts * 3 + torch.tensor([5.0, 0, -2]), faces)
    moved, _, _ = normalise(mesh.verts)
    assert back(moved, mesh) is mesh.verts
    torch.testing.assert_close(back(moved[10:], mesh), mesh.verts[10:], atol=1e-5, rtol=0)


def test_a_guide_shortens_the_phase_that_decides_the_shape():
    draft, standard = preset("draft"), preset("standard")
    keeps = shortened(draft, 1.0).geometry
    assert keeps.coarse.steps == keeps.grow.rounds == keeps.refine.steps == 0
    assert shortened(draft, 0.0) == draft
    assert shortened(draft, 0.5).geometry.coarse.steps == draft.geometry.coarse.steps // 2
    fine = standard.geometry.fine.steps
    assert 0 < shortened(standard, 0.9).geometry.fine.steps < fine / 5
    assert keeps.refine.t[0] == draft.geometry.refine.t[0] / 2
    assert draft.geometry.join and not keeps.join  # two shoes stay two


def test_an_asset_is_made_again_from_what_it_records_to_the_last_bit(whole, fork, tmp_path):
    """Moved out of its run folder: asset.json alone must do."""
    import json
    import shutil

    alone = shutil.copytree(whole / "asset", tmp_path / "alone")
    status, output = fork("verify", alone).finished()
    assert status == 0, output
    report = json.loads(output[output.index("{") :])
    assert report["same"]
    assert set(report["files"].values()) == {"same"}
    assert report["versions"] == {}


@pytest.mark.usefixtures("coarse")
def test_the_material_is_learnt_within_each_areas_ranges(tmp_path, monkeypatch):
    class SeenError(Exception):
        """Where the appearance's training would begin."""

    def created(_config, _generator, local=None):
        raise SeenError(local)

    monkeypatch.setattr("core.generate.MaterialNet", created)
    run = RunFolder.create(tmp_path / "run", Job(prompt="a dumbbell", max_faces=100))
    with pytest.raises(SeenError) as caught:
        generate(run, prepare(run.job), Progress(run))
    metallic = caught.value.args[0].bounds[:, 2:4]
    assert metallic.unique().tolist() == [1.0]  # of iron and steel, and no range around it


@pytest.mark.parametrize(
    ("command", "shape", "strength", "fine", "own"),
    [
        ("generate", False, 0.5, None, True),
        ("generate", True, 0.5, None, True),  # a guide
        ("generate", True, 1.0, None, False),  # kept as it is
        ("texture", True, 0.5, None, False),
        ("texture", True, 0.5, "region", True),  # of an asset that was made here
        ("texture", True, 0.5, "region of another's", False),
    ],
)
def test_a_users_mesh_keeps_its_sharp_edges(command, shape, strength, fine, own):
    mesh = Mesh(torch.zeros(3, 3), torch.tensor([[0, 1, 2]]))
    kept = Region(Maps(*[torch.zeros(2, 2, 3)] * 3), torch.ones(1, dtype=torch.bool))
    region = fine and kept._replace(fine=mesh if fine == "region" else None)
    inputs = replace(prepare(Job(prompt="a chair")), shape=mesh if shape else None, region=region)
    path = "own.obj" if command == "texture" else ""
    job = Job(prompt="a chair", command=command, mesh=path, guide_strength=strength)
    assert is_own_shape(job, inputs) is own


@pytest.mark.usefixtures("coarse")
@pytest.mark.parametrize("style", ["low poly", "voxel"])
def test_a_style_is_made_from_words_to_the_asset(tmp_path, style):
    settings = {"geometry.voxels": "12", "appearance.early.steps": "2"}
    settings |= {"appearance.late.steps": "0", "appearance.refine.steps": "2"}
    job = Job(prompt=f"a {style} striped dumbbell", texture_size=128, settings=settings)
    run = RunFolder.create(tmp_path / "run", job)
    asset = read_asset(generate(run, prepare(run.job), Progress(run)))
    report = asset.info["mesh"]
    assert asset.mesh.flat and report["closed"] and report["manifold"]
    kept = load_unwrapped(run)
    assert kept is not None and kept.mesh.flat  # a resumed run has it too
    assert (asset.maps.normal - torch.tensor([0.0, 0, 1])).abs().max() < 1e-3  # no relief
    assert {event["path"] for event in read_events(run.path) if event["type"] == "preview"} >= {
        "preview/normals.png",
        "preview/shape.npz",
    }
    shown = np.load(run.path / "preview" / "shape.npz")
    assert len(shown["faces"]) == len(asset.mesh.faces)  # the preview's shape is in the style too
    if style == "voxel":
        steps = asset.mesh.verts / asset.mesh.verts[:, 2].unique().diff().min()
        assert (steps.diff(dim=0) - steps.diff(dim=0).round()).abs().max() < 1e-2
        uv, face_uvs = asset.mesh.atlas
        corners = uv[face_uvs].view(-1, 6, 2)
        at = corners.mean(1, keepdim=True).lerp(corners, 0.7) * 128
        colors = asset.maps.base_color[127 - at[..., 1].long(), at[..., 0].long()]
        assert (colors - colors[:, :1]).abs().max() < 1e-2  # each square has one
        assert colors[:, 0].std(0).max() > 0.05  # the stripes
    else:
        assert len(asset.mesh.faces) < 800


def test_a_style_is_of_shapes_that_are_made_here_alone():
    job = Job(prompt="a voxel chair", settings={})
    inputs = prepare(job)
    assert styled_inputs(inputs, job).config.geometry.style == "voxels"
    assert not unstyled(job, inputs)
    both = prepare(Job(prompt="a voxel knight riding a horse"))
    assert styled_inputs(both, job).config.geometry.style == "voxels"
    mesh = replace(job, command="texture", mesh="own.obj")
    assert styled_inputs(inputs, mesh).config.geometry.style == "none"
    assert "voxels: left out" in unstyled(mesh, inputs)[0]
    kept = replace(job, guide_mesh="own.obj", guide_strength=1.0)
    assert styled_inputs(inputs, kept).config.geometry.style == "none" and unstyled(kept, inputs)
    part = replace(mesh, region="faces.txt", kept_asset="asset", uv="keep")
    assert not unstyled(part, inputs)  # of an asset in its style, which it keeps
    flat = Mesh(torch.zeros(3, 3), torch.tensor([[0, 1, 2]]), flat=True)
    assert styled_inputs(replace(inputs, shape=flat), part).config.appearance.detail == 0
    smooth = replace(flat, flat=False)
    assert styled_inputs(replace(inputs, shape=smooth), part).config.appearance.detail > 0
