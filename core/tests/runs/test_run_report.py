"""A run's report: all of the run in one file, which opens nothing else."""

import base64
import os
import re
import shutil
import subprocess
from functools import cache
from pathlib import Path

import numpy as np
import pytest
import torch
from PIL import Image

from core.command_line import main
from core.errors import UserError
from core.geometry.mesh import Mesh
from core.io.asset import place, write_asset
from core.io.job import Job
from core.io.maps import Maps
from core.io.run_folder import RunFolder
from core.report.facts import facts_of
from core.report.lights import COLUMNS, ROWS, lamp, lights_of, packed, rgbe
from core.report.page import MARK, picture_url, write_report
from core.report.svg import curve
from core.stages import preview
from core.tests.meshes import sphere
from core.texture.unwrap import unwrap

PROMPT = 'a "red" <b>mug</b> @title@'


@cache
def parts() -> tuple[Mesh, Maps]:
    """A grey, rough ball of a metre."""
    verts, faces = sphere(3)
    mesh = Mesh(place(verts), faces, *unwrap(verts, faces, 64))
    grey = torch.full((8, 8, 3), 0.5)
    orm = torch.tensor([1.0, 0.9, 0.0]).expand(8, 8, 3)
    return mesh, Maps(grey, orm, torch.tensor([0.0, 0.0, 1.0]).expand(8, 8, 3))


def made(path: Path, *, asset: bool = True) -> RunFolder:
    """A finished run's folder without the work of a run."""
    run = RunFolder.create(path / "run", Job(prompt=PROMPT, settings={"geometry.views": 3}))
    run.report("started", pid=1)
    for step, loss in enumerate((8.0, 2.0, 0.5), 1):
        run.report("progress", stage="geometry", step=step, steps=3, loss=loss, coverage=0.1 * step)
    run.report("warning", text="The surface <had> vanished.", fix="Nothing to do.")
    run.report("cancelled", text="Cancelled.")
    run.report("started", pid=2)
    run.report("progress", stage="geometry", step=3, steps=3, loss=0.25, coverage=0.3)
    for shade in (0, 128):
        picture = np.full((16, 16, 3), shade, np.uint8)
        preview.keep_frame(run, "geometry" if shade else "appearance", picture)
    if not asset:
        return run
    mesh, maps = parts()
    write_asset(run.asset, mesh, maps, {"timings": {"geometry": 12.5}})
    run.report("done", path="asset", text="complete.")
    return run


def script(page: str, name: str) -> str:
    return re.search(rf'id="{name}">(.*?)</script>', page, re.DOTALL).group(1)


def test_the_page_holds_the_run_and_its_asset(tmp_path):
    run = made(tmp_path)
    page = write_report(run.path).read_text(encoding="utf-8")
    assert "<b>mug</b>" not in page
    assert "<h1>a &quot;red&quot; &lt;b&gt;mug&lt;/b&gt; @title@</h1>" in page
    assert "generate, draft preset: done, in 2 sessions; 12 s" in page
    assert base64.b64decode(script(page, "glb")) == (run.asset / "asset.glb").read_bytes()
    assert "The surface &lt;had&gt; vanished. Nothing to do." in page
    for row in ("closed</td><td>yes", "geometry.views</td><td>3", "genus</td><td>0"):
        assert row in page
    assert page.count("<polyline") == 2  # loss and coverage
    assert page.count("<img") == 2 + 3  # frames and maps


def test_the_page_opens_nothing_else(tmp_path):
    """No address in what a browser loads by itself, and a policy that forbids every other."""
    page = write_report(made(tmp_path).path).read_text(encoding="utf-8")
    policy = re.search(r'Content-Security-Policy" content="([^"]*)"', page).group(1)
    assert policy.startswith("default-src 'none';")
    assert "http" not in policy
    assert "sourceMappingURL" not in page
    markup = re.sub(r"<script.*?</script>", "", page, flags=re.DOTALL)
    loaded = re.findall(r'(?:src|href)="(.{0,30})', markup)
    assert loaded
    assert all(address.startswith("data:image/jpeg;base64") for address in loaded)


def test_a_run_without_an_asset_has_a_report_too(tmp_path):
    page = write_report(made(tmp_path, asset=False).path).read_text(encoding="utf-8")
    assert "running or broken off" in page
    assert "model-viewer" not in page.partition("</style>")[2]


def test_a_step_taken_twice_counts_as_it_was_the_last_time(tmp_path):
    (shown,) = facts_of(made(tmp_path).path).curves
    assert shown.loss == {1: 8.0, 2: 2.0, 3: 0.25}
    assert shown.coverage[2] == pytest.approx(0.2)


def test_a_curve_falls_as_its_values_do():
    text = curve({1: 100.0, 2: 10.0, 3: 1.0}, "loss", logarithmic=True)
    points = [p.split(",") for p in re.search(r'points="([^"]*)"', text).group(1).split()]
    x, y = (np.array(c, float) for c in zip(*points, strict=True))
    np.testing.assert_allclose(np.diff(x), np.diff(x)[0], atol=0.2)
    np.testing.assert_allclose(np.diff(y), np.diff(y)[0], atol=0.2)  # logarithmic: even steps
    assert y[0] < y[-1]  # downwards on the screen
    long = curve({n: 9.0 if n == 801 else float(n % 2) for n in range(1000)}, "loss")
    assert ">9<" in long and ">step 999<" in long  # of the points that are left out, not these
    assert "logarithmic" not in curve({1: 0.0, 2: 1.0}, "loss", logarithmic=True)
    assert "NaN" not in curve({5: 2.0}, "loss").replace("nan", "NaN")


@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("notes.html", "is not a report"),
        ("report.txt", "not an HTML"),
        ("folder.html", "is a folder"),
    ],
)
def test_a_foreign_file_is_not_replaced(tmp_path, name, words):
    run, out = made(tmp_path), tmp_path / name
    out.mkdir() if name.startswith("folder") else out.write_text("mine")
    with pytest.raises(UserError, match=words):
        write_report(run.path, out)
    assert out.is_dir() or out.read_text() == "mine"


def test_a_report_is_replaced_by_a_newer_one_and_is_whole(tmp_path):
    run = made(tmp_path)
    first = write_report(run.path)
    assert first.read_bytes().startswith(MARK)
    first.write_bytes(MARK + b" older")
    assert write_report(run.path) == first
    assert first.read_bytes().endswith(b"</html>\n")
    assert not list(run.path.glob("*.tmp"))


@pytest.mark.parametrize(
    ("broken", "words"),
    [
        ("events.jsonl", "is not JSON"),
        ("asset/asset.glb", "is not a GLB file"),
        ("asset/asset.json", "is not JSON"),
        ("asset/orm.png", "is not a picture"),
        ("job.json", "is not JSON"),
    ],
)
def test_a_broken_run_is_named(tmp_path, broken, words, capsys):
    run = made(tmp_path)
    (run.path / broken).write_bytes(b"broken\n")
    assert main(["report", str(run.path)]) == 2
    output = capsys.readouterr().err
    assert words in output
    assert output.count("\n") == 1
    assert not (run.path / "report.html").exists()


@pytest.mark.parametrize("name", ["asset/orm.png", "asset/asset.glb", "asset/asset.json", "film"])
def test_a_link_out_of_the_run_is_not_followed(tmp_path, name):
    """A run of somebody else's must not bring another file of the user's into the page."""
    run = made(tmp_path)
    path = sorted((run.path / "preview" / "film").iterdir())[0] if name == "film" else None
    path = path or run.path / name
    path.rename(tmp_path / path.name)
    path.symlink_to(tmp_path / path.name)
    with pytest.raises(UserError, match="link to another folder"):
        write_report(run.path)


def test_no_run_is_a_sentence(tmp_path, capsys):
    assert main(["report", str(tmp_path / "nowhere")]) == 2
    assert "is not a run folder" in capsys.readouterr().err


def test_texels_keep_the_light_s_radiance():
    light = torch.tensor([[0.0, 0.0, 0.0], [1.0, 0.5, 0.25], [1000.0, 3.0, 0.0], [0.01, 0.02, 0.0]])
    texel = rgbe(light).double()
    back = texel[:, :3] / 256 * 2 ** (texel[:, 3:] - 128)
    assert float((back - light).abs().max() / 1000) < 1 / 128
    torch.testing.assert_close(back[1], light[1].double(), rtol=1 / 100, atol=1e-6)


def test_the_lamp_on_the_left_is_on_the_left_in_gltf_s_axes():
    """At -60° of azimuth and 30° up: (-.75, .5, .43), where +Z is towards the viewer."""
    texels = np.frombuffer(packed(lamp()), np.uint8).reshape(ROWS, COLUMNS, 4).astype(float)
    power = texels[..., :3].sum(-1) * 2 ** (texels[..., 3] - 128)
    row, column = np.unravel_index(power.argmax(), power.shape)
    v, u = (row + 0.5) / ROWS * np.pi, ((column + 0.5) / COLUMNS - 0.5) * 2 * np.pi
    found = [np.sin(v) * np.cos(u), np.cos(v), np.sin(v) * np.sin(u)]
    assert np.dot(found, [-0.75, 0.5, 0.433]) > np.cos(np.radians(26))  # the lamp's own radius


def test_a_light_that_is_not_here_is_left_out():
    assert next(iter(lights_of("studio"))) == "the run's"
    assert "the run's" not in lights_of("/of/another/machine.hdr")


def test_a_film_thins_out_as_it_grows(tmp_path, monkeypatch):
    run, now = RunFolder.create(tmp_path / "run", Job(prompt="a mug")), [1000.0]
    monkeypatch.setattr(preview.time, "time", lambda: now[0])
    film = run.path / "preview" / "film"
    for _ in range(1000):
        preview.keep_frame(run, "geometry", np.zeros((16, 16, 3), np.uint8))
        now[0] += 2.0
        (film / "geometry-1 copy.png").touch()  # somebody's
    (film / "geometry-1 copy.png").unlink()
    frames = sorted(film.iterdir())
    assert 40 < len(frames) < 100
    times = [int(path.stem.split("-")[1]) for path in frames]
    gaps = np.diff(times)
    assert gaps[0] == 2000
    assert gaps[-1] > 100_000
    with Image.open(frames[0]) as first:
        assert first.size == (8, 8)


def test_a_picture_in_the_page_is_small(tmp_path):
    Image.new("RGB", (2048, 1024), (255, 0, 0)).save(tmp_path / "large.png")
    url = picture_url(tmp_path / "large.png")
    assert len(url) < 20_000


CHROMIUM = next(
    filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None
)


def screenshot(page: Path, light: str, out: Path) -> tuple[np.ndarray, str]:
    """The page as a browser shows it, and the browser's output."""
    options = "--headless --no-sandbox --use-gl=angle --use-angle=swiftshader"
    options += " --enable-unsafe-swiftshader --hide-scrollbars --window-size=1000,620"
    options += " --virtual-time-budget=30000 --enable-logging=stderr --v=0"
    address = f"{page.as_uri()}#{light.replace(' ', '%20')}"
    command = [CHROMIUM, *options.split(), f"--user-data-dir={out.parent / 'profile'}"]
    environ = os.environ | {"HOME": str(out.parent)}
    done = subprocess.run(
        [*command, f"--screenshot={out}", address],
        env=environ, capture_output=True, text=True, timeout=500,
    )  # fmt: skip
    with Image.open(out) as picture:
        return np.asarray(picture.convert("RGB")).astype(float), done.stderr


@pytest.mark.slow
@pytest.mark.skipif(CHROMIUM is None, reason="needs Chromium on PATH (Debian's package chromium)")
def test_a_browser_shows_the_asset_lit_from_the_lamp_s_side_and_loads_nothing(tmp_path):
    run = made(tmp_path)
    page = write_report(run.path)
    picture, output = screenshot(page, "one lamp", tmp_path / "lamp.png")
    # The page's policy would name here what it had to forbid.
    wrong = ("violates", "Uncaught", "Failed to load", "ERR_")
    assert not [line for line in output.splitlines() if any(word in line for word in wrong)]
    # The ball is grey; the page behind it is bluish.
    view = picture[110:580, 100:900]
    grey = (np.ptp(view, axis=-1) < 6) & (view[..., 0] < 200)
    rows, columns = grey.nonzero()
    assert len(rows) > 5000
    middle = columns.mean()
    left, right = (
        view[rows[side], columns[side], 0].mean() for side in (columns < middle, columns > middle)
    )
    assert left > right + 10
