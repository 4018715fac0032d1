"""The command line: one sentence and the right status for what is wrong."""

import json

import pytest

from core.command_line import job_of, main, parse
from core.device import device_of
from core.errors import UserError


def wrong(capsys, *argv):
    status = main(list(argv))
    output = capsys.readouterr()
    assert "Traceback" not in output.err and output.err.count("\n") == 1, output.err
    assert output.out == ""
    return status, output.err


@pytest.mark.parametrize(
    ("argv", "words"),
    [
        (["generate", ""], "prompt is empty"),
        (["generate", " \t "], "prompt is empty"),
        (["generate", "chair " * 1000], "has 6000 characters"),
        (["generate", "a chair", "--sede", "3"], "Did you mean --seed?"),
        (["generate", "a chair", "--see", "3"], "no option '--see'"),
        (["generate", "a chair", "--seed", "x"], "invalid int value: 'x'"),
        (["generate", "a chair", "--preset", "fast"], "draft, sds, standard, paper"),
        (["generate", "a chair", "--set", "geometry.fine.stepz=3"], "geometry.fine.steps"),
        (["generate", "a chair", "--set", "geometry.fine.steps"], "has no value"),
        (["generate", "a chair", "--set", "geometry.coarse.steps=-3"], "0 to 1000000"),
        (["generate", "a chair", "--set", "geometry.radii=nan,1,1"], "0.05 to 1"),
        (["generate", "a chair", "--set", "texture.size=0"], "64 to 8192"),
        (["generate", "a chair", "--texture-size", "0"], "64 to 8192"),
        (["generate", "a chair", "--max-faces", "0"], "100 or more"),
        (["generate", "a chair", "--device", "abacus"], "auto, cpu, cuda or mps"),
        (["generate", "a chair", "--light", "nowhere.exr"], "nowhere.exr"),
        (["generate", "a chair", "--guide", "nowhere.obj"], "nowhere.obj"),
        (["generate", "a chair", "--guide-strength", "7"], "0 to 1"),
        (["texture", "nowhere.obj", "a chair"], "nowhere.obj"),
        (["texture", "nowhere.obj"], "prompt"),
        (["resume", "nowhere"], "is not a run folder"),
        (["render", "nowhere", "--out", "x.png"], "is not an asset"),
        (["render", "nowhere", "--out", "x.gif"], ".png or .exr"),
        (["render", "nowhere", "--out", "x.png", "--map", "shadow"], "no map 'shadow'"),
        (["render", "nowhere", "--out", "x.png", "--size", "0"], "1 to 8192"),
        (["render", "nowhere", "--out", "x.png", "--size", "1000000"], "1 to 8192"),
        (["render", "nowhere", "--out", "x.png", "--azimuth-deg", "nan"], "azimuth is nan"),
        (["render", "nowhere", "--out", "x.png", "--azimuth-deg", "inf"], "-36000 to 36000"),
        (["render", "nowhere", "--out", "x.png", "--elevation-deg", "nan"], "-90 to 90"),
        (["render", "nowhere", "--out", "x.png", "--elevation-deg", "100"], "-90 to 90"),
        (["render", "nowhere", "--out", "x.png", "--fovy-deg", "nan"], "1 to 170"),
        (["render", "nowhere", "--out", "x.png", "--distance", "nan"], "more than 0"),
        (["inspect", "nowhere"], "nowhere"),
        (["inspect", "x" * 300], "name too long"),
        (["generate", "a chair", "--out", "x" * 300], "name too long"),
        (["generate", "a chair \udcff"], "a byte that is not text"),
        (["export", "nowhere", "--format", "glb", "--out", "x.glb"], "is not an asset"),
        (["genrate", "a chair"], "genrate"),
        ([], "COMMAND"),
    ],
)
def test_what_is_wrong_is_one_sentence_with_status_2(argv, words, capsys, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    status, output = wrong(capsys, *argv)
    assert status in (2, 3) and words in output, output
    assert list(tmp_path.iterdir()) == []


def test_a_missing_device_is_status_3(capsys, monkeypatch, tmp_path):
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr("torch.cuda.is_available", lambda: False)
    assert wrong(capsys, "generate", "a chair", "--device", "cuda")[0] == 3


@pytest.mark.parametrize(("cuda", "chosen"), [(True, "cuda"), (False, "cpu")])
def test_auto_leaves_an_apple_gpu_alone(monkeypatch, cuda, chosen):
    monkeypatch.setattr("torch.cuda.is_available", lambda: cuda)
    monkeypatch.setattr("torch.backends.mps.is_available", lambda: True)
    assert device_of("auto").type == chosen
    assert device_of("mps").type == "mps"


def test_options_reach_the_job(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "model").mkdir()
    argv = ["generate", "a chair", "--seed", "7", "--negative", "blurry", "--guide", "ü b.obj"]
    argv += ["--set", "geometry.views=3", "--set", "texture.size = 64", "--guidance", "model"]
    job = job_of(parse(argv))
    assert (job.seed, job.negative_prompt, job.preset) == (7, "blurry", "draft")
    assert job.guide_mesh == str(tmp_path / "ü b.obj")  # a run may be resumed from elsewhere
    assert job.guidance == str(tmp_path / "model")
    assert job.settings == {"geometry.views": "3", "texture.size": "64"}


def test_the_home_that_a_shell_leaves_in_an_option_is_found(tmp_path, monkeypatch):
    """``--out=~/run`` once made a folder of the name ~ in the current one."""
    monkeypatch.setenv("HOME", str(tmp_path))
    (tmp_path / "sky.hdr").write_bytes(b"")
    args = parse(["generate", "a cube", "--out=~/run", "--light=~/sky.hdr"])
    assert args.out == tmp_path / "run"
    assert job_of(args).light == str(tmp_path / "sky.hdr")
    assert str(parse(["render", "~/a", "--out=~no-one/a.png"]).out) == "~no-one/a.png"


def test_a_folder_with_the_name_of_a_light_is_none(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    for name in ("studio", "mesh", "model"):
        (tmp_path / name).mkdir()
    options = ["--light", "studio", "--base-color", "mesh", "--guidance", "model"]
    job = job_of(parse(["texture", "m.obj", "a cube", *options]))
    assert (job.light, job.base_color) == ("studio", "mesh")
    assert job.guidance == str(tmp_path / "model")


def test_a_hub_id_stays_an_id(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    assert job_of(parse(["generate", "a", "--guidance", "some/model"])).guidance == "some/model"


def test_an_unknown_option_without_a_near_one_points_to_the_help():
    with pytest.raises(UserError, match="--help"):
        parse(["inspect", "x", "--qqqqqq"])


def test_a_run_whose_job_is_wrong_states_so_in_its_events(tmp_path, capsys):
    """What the add-on wrote is checked like what a user typed."""
    job = {"version": 1, "prompt": "a chair", "preset": "fast"}
    (tmp_path / "job.json").write_text(json.dumps(job))
    assert main(["resume", str(tmp_path)]) == 2
    events = [json.loads(x) for x in (tmp_path / "events.jsonl").read_text().splitlines()]
    assert [e["type"] for e in events] == ["started", "error"]
    assert "preset" in events[1]["text"]
    assert "draft" in events[1]["fix"]
    capsys.readouterr()
