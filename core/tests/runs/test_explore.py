"""Candidates: a pause changes nothing of the asset, and a new material nothing of the shape."""

import shutil
from pathlib import Path

import pytest
from PIL import Image

from core.command_line import main
from core.config import DRAFT, SDS
from core.io.job import read_events
from core.stages import appearance, geometry
from core.stages.training import first_steps
from core.tests.tiny_runs import OPTIONS, made

PROMPT = "a red torus"

pytestmark = pytest.mark.usefixtures("coarse")


def run(*argv: object) -> None:
    assert main([*map(str, argv)]) == 0


def last(folder: Path) -> str:
    return read_events(folder)[-1]["type"]


@pytest.fixture(scope="module")
def shapes(tmp_path_factory: pytest.TempPathFactory, coarse: None) -> Path:
    """Two candidates, of the seeds 3 and 4."""
    folder = tmp_path_factory.mktemp("explore") / "tori"
    run("explore", PROMPT, "--count=2", "--seed=3", "--out", folder, *OPTIONS)
    return folder


@pytest.fixture(scope="module")
def finished(shapes: Path) -> Path:
    """The second candidate, finished."""
    run("resume", shapes / "candidate-2")
    return shapes / "candidate-2"


def test_a_finished_candidate_is_the_asset_of_an_unbroken_run(finished, tmp_path):
    run("generate", PROMPT, "--seed=4", "--out", tmp_path / "whole", *OPTIONS)
    assert made(finished) == made(tmp_path / "whole")


def test_a_foreign_file_where_the_asset_goes_is_refused_before_the_work(shapes, tmp_path):
    folder = shutil.copytree(shapes / "candidate-1", tmp_path / "run")
    (folder / "asset").mkdir()
    (folder / "asset" / "mine.txt").write_text("precious")
    before = len(read_events(folder))
    assert main(["resume", str(folder)]) == 2
    assert [e["type"] for e in read_events(folder)[before:]] == ["started", "error"]
    assert (folder / "asset" / "mine.txt").read_text() == "precious"


def test_candidates_stop_at_a_first_look_and_are_shown_on_one_sheet(shapes):
    first = shapes / "candidate-1"
    assert last(first) == "paused"
    assert not (first / "asset").exists()
    assert not (first / "checkpoint" / "mesh.safetensors").exists()
    steps = [e["step"] for e in read_events(first) if e.get("stage") == "geometry" and "step" in e]
    assert max(steps) == 5  # three of distilling, two of the one round of growing
    assert (first / "preview" / "shape.npz").is_file()
    with Image.open(shapes / "candidates.png") as sheet:
        assert sheet.size == (512, 280)
        halves = [sheet.crop((x, 0, x + 256, 256)).tobytes() for x in (0, 256)]
    assert halves[0] != halves[1]


def test_exploring_again_makes_only_what_is_missing(shapes, finished):
    before = [read_events(shapes / f"candidate-{n}") for n in (1, 2)]
    run("explore", PROMPT, "--count=2", "--seed=3", "--out", shapes, *OPTIONS)
    assert [read_events(shapes / f"candidate-{n}") for n in (1, 2)] == before


def test_another_material_keeps_the_shape_to_the_last_byte(finished, tmp_path):
    folder = tmp_path / "colors"
    run("recolor", finished, "--count=1", "--out", folder)
    candidate = folder / "candidate-1"
    assert last(candidate) == "paused"
    assert (candidate / "preview" / "color.png").is_file()
    run("resume", candidate)
    mine, source = made(candidate), made(finished)
    assert mine["mesh.obj"] == source["mesh.obj"]
    assert mine["base_color.png"] != source["base_color.png"]


@pytest.mark.parametrize(
    ("argv", "text"),
    [
        (("explore", PROMPT, "--count=0", "--out", "{new}"), "--count is 0."),
        (("explore", "a red blorb", "--out", "{new}"), "blorb"),
        (("explore", PROMPT, "--seed=9", "--out", "{shapes}"), "of other settings"),
        (("recolor", "{shapes}/candidate-1", "--out", "{new}"), "is not finished"),
        (("recolor", "{shapes}", "--out", "{new}"), "is not a run folder"),
        (("resume", "{shapes}/candidate-1", "--until=night"), "--until is 'night'"),
    ],
)
def test_what_cannot_be_explored_is_reported_and_writes_nothing(
    shapes, tmp_path, capsys, argv, text
):
    places = {"new": tmp_path / "new", "shapes": shapes}
    assert main([word.format(**places) for word in argv]) == 2
    assert text in capsys.readouterr().err
    assert not (tmp_path / "new").exists()


@pytest.mark.parametrize("command", ["explore", "recolor"])
def test_a_picture_of_the_users_is_never_replaced(command, shapes, tmp_path, capsys):
    mine = tmp_path / "candidates.png"
    mine.write_text("precious")
    what = PROMPT if command == "explore" else str(shapes / "candidate-2")
    assert main([command, what, "--out", str(tmp_path)]) == 2
    assert "does not belong to candidates" in capsys.readouterr().err
    assert list(tmp_path.iterdir()) == [mine] and mine.read_text() == "precious"


def test_the_steps_before_a_stop():
    assert first_steps([30, 200, 0, 120], None) == [30, 200, 0, 120]
    assert first_steps([30, 200, 0, 120], 130) == [30, 100, 0, 0]
    assert first_steps([30, 200], 20) == [20, 0]
    assert first_steps([30, 200], 500) == [30, 200]


def test_a_first_look_takes_less_than_the_whole():
    for config in (DRAFT, SDS):
        g, a = config.geometry, config.appearance
        all_of_it = g.coarse.steps + g.grow.rounds * g.grow.steps + g.fine.steps
        assert 0 < geometry.early_steps(g) <= all_of_it + g.refine.rounds * g.refine.steps
        steps = a.early.steps + a.late.steps + a.refine.rounds * a.refine.steps
        assert 0 < appearance.early_steps(a) <= steps
    g = DRAFT.geometry
    assert geometry.early_steps(g) < g.coarse.steps + g.grow.rounds * g.grow.steps


def test_a_done_run_whose_shape_was_not_kept_is_not_to_be_resumed(shapes, tmp_path, capsys):
    """As a batch leaves it: `resume` would train it all again."""
    done = tmp_path / "done"
    done.mkdir()
    for name in ("job.json", "events.jsonl"):
        (done / name).write_bytes((shapes / "candidate-1" / name).read_bytes())
    (done / "asset").mkdir()
    assert main(["recolor", str(done), "--out", str(tmp_path / "new")]) == 2
    output = capsys.readouterr().err
    assert "was not kept" in output and "resume" not in output
    assert not (tmp_path / "new").exists()
