"""The paper's figures: finished rows stay, failures are reported, the page shows the results."""

import contextlib
import dataclasses
import io
import json
import sys
from pathlib import Path
from unittest import mock

import pytest
import torch
import trimesh
from PIL import Image

from core.benchmarks import fit_scores
from core.command_line import job_of, main, parse
from core.config import preset
from core.errors import UserError
from core.geometry.mesh import health
from core.guidance.builtin.offered import offered_words
from core.guidance.builtin.palette import COLOR_VALUES
from core.guidance.builtin.words.vocabulary import understood
from core.reproduce import make as making
from core.reproduce.figures import ASSETS, FIGURES
from core.reproduce.guides import GUIDES, guide_file, triangle_volume
from core.reproduce.make import QUICK, Order, command_words, words_of
from core.reproduce.numbers import LABELS, guide_distance
from core.reproduce.page import write_page
from core.settings import with_settings

ROOT = Path(__file__).parents[3]


def order(out, **more):
    return Order(out, lambda words: job_of(parse(words)), **more)


# The figures


@pytest.mark.parametrize("name", ASSETS)
def test_every_asset_is_a_job_of_words_that_the_prior_knows(name, tmp_path):
    asset = ASSETS[name]
    job = job_of(parse(words_of(name, order(tmp_path))))
    understood(job.prompt)
    assert bool(job.guide_mesh) == bool(asset.guide)
    assert asset.noun in offered_words()["noun"]
    assert not asset.color or (asset.color in COLOR_VALUES and asset.color in job.prompt)


def test_a_checkpoint_gets_the_papers_own_prompt(tmp_path):
    words = words_of("bust", order(tmp_path, guidance="/models/sd"))
    assert "Theodoros" in words[-1]
    assert "--preset=standard" in words and "--guidance=/models/sd" in words
    assert words_of("guided-bus", order(tmp_path, guidance="/models/sd"))[-1] == "a red bus"


def test_every_row_names_what_there_is():
    for figure in FIGURES:
        for row in figure.rows:
            assert {row.asset, *row.others} <= ASSETS.keys()
            assert set(row.numbers) <= LABELS.keys()
            assert ("guide_distance" in row.numbers) <= bool(ASSETS[row.asset].guide)
    assert len({figure.name for figure in FIGURES}) == len(FIGURES)


def test_every_command_is_one_that_run_py_parses(tmp_path):
    sys.path.insert(0, str(ROOT))
    from run import parse as parse_all

    places = dict.fromkeys(ASSETS, tmp_path) | {"asset": tmp_path, "file": tmp_path / "a.png"}
    commands = {c for f in FIGURES for row in f.rows for _, c in row.shots if c != making.GUIDE}
    for command in commands:
        assert parse_all([*command_words(command, places), "--size", "64"]).command


def test_a_place_with_a_blank_stays_one_word():
    places = {"asset": Path("a b"), "file": Path("c")}
    assert command_words("render {asset} --out {file}", places) == ["render", "a b", "--out", "c"]


def test_the_shortest_settings_exist():
    with_settings(preset("draft"), dict(text.split("=") for text in QUICK))


# The guides


@pytest.mark.parametrize("name", GUIDES)
def test_a_guide_is_closed_and_faces_outwards(name):
    mesh = GUIDES[name]()
    assert health(mesh.verts, mesh.faces)["closed"]
    assert triangle_volume(mesh.verts, mesh.faces) > 0


def test_a_guide_is_at_no_distance_from_itself_and_a_larger_box_by_what_it_lacks(monkeypatch):
    monkeypatch.setattr(fit_scores, "MESH_POINTS", 30_000)  # half
    mesh = GUIDES["seat"]()
    assert guide_distance(dataclasses.replace(mesh, verts=3 * mesh.verts + 5), mesh) < 0.35
    ball, cube = GUIDES["person"](), GUIDES["bus"]()
    assert guide_distance(ball, cube) > 5


def test_the_distance_of_a_cube_and_half_of_it_has_a_closed_form():
    box = trimesh.creation.box()
    cube = dataclasses.replace(
        GUIDES["seat"](), verts=torch.tensor(box.vertices).float(), faces=torch.tensor(box.faces)
    )
    slab = dataclasses.replace(cube, verts=cube.verts * torch.tensor([1, 1, 0.5]))
    # Both have one middle. The cube's points are 1/8 away in the mean, the slab's 7/96.
    expected = 50 * (1 / 8 + 7 / 96)
    assert guide_distance(cube, slab) == pytest.approx(expected, abs=0.4)  # points are apart
    assert guide_distance(slab, cube) == pytest.approx(expected, abs=0.4)


def test_an_unknown_guide_is_refused(tmp_path):
    with pytest.raises(UserError, match="no guide mesh 'cow'"):
        guide_file(tmp_path, "cow")


# The command


def test_list_states_what_is_made_and_writes_nothing(tmp_path, capsys):
    assert main(["reproduce", "--list", "--out", str(tmp_path / "out")]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert [line.split()[0] for line in lines] == [figure.name for figure in FIGURES]
    assert all(" 0 of " in line for line in lines)
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize(
    ("words", "text"),
    [
        (["--figure=cow"], "no figure 'cow'"),
        (["--figure=sds", "--guidance=stabilityai/x"], "no figure 'sds'"),
        (["--page=a.html"], "ends in .md"),
        (["--row=cow"], "no row 'cow'"),
    ],
)
def test_what_cannot_be_made_is_refused_first(words, text, tmp_path, capsys):
    assert main(["reproduce", "--out", str(tmp_path / "out"), *words]) == 2
    assert text in capsys.readouterr().err
    assert not (tmp_path / "out").exists()


ROW = "genus 1 wanted"
PLACE = "figures/genus/genus-1-wanted-*"


@pytest.fixture(scope="module")
def made(tmp_path_factory):
    """One row made for real by the shortest settings; the output."""
    out, output = tmp_path_factory.mktemp("reproduce"), io.StringIO()
    # Pictures in this process, which has the method loaded; one of its own is tested below.
    with contextlib.redirect_stdout(output), mock.patch.object(making, "carry_out", main):
        assert again(out) == 0
    return out, output.getvalue()


def again(out):
    return main(["reproduce", "--quick", "--figure=genus", "--row", ROW, "--out", str(out)])


def times(out, pattern):
    return {path: path.stat().st_mtime_ns for path in out.glob(pattern)}


def test_a_row_is_made_and_the_page_shows_it(made):
    out, output = made
    page = (out / "reproduction.md").read_text()
    assert output.splitlines()[-1].endswith("reproduction.md")
    section = page.partition("## Genus")[2].partition("\n## ")[0]
    (row,) = [line for line in section.splitlines() if line.startswith("| **")]
    assert row.startswith(f"| **{ROW}**") and "(reproduction/genus-genus-1-wanted.jpg)" in row
    assert "components: " in row and "genus: " in row
    assert "Not made yet: genus 0 wanted, genus 2 wanted, genus 5 wanted." in section
    assert "`python3 run.py reproduce --figure physics` makes them" in page
    with Image.open(out / "reproduction" / "genus-genus-1-wanted.jpg") as picture:
        assert picture.size == (2 * 48 + 4, 48)
        assert len(picture.getcolors(1 << 16)) > 50


def test_a_command_is_carried_out_by_a_process_of_its_own_whose_error_is_reported():
    making.carry_out(["words", "a red chair"])
    with pytest.raises(UserError, match="does not know 'flurb'"):
        making.carry_out(["words", "a flurb"])


def test_what_is_there_is_not_made_again(made):
    out, _ = made
    before = times(out, "runs/*/asset/*") | times(out, "figures/*/*/*")
    assert len(before) > 3
    assert again(out) == 0
    assert times(out, "runs/*/asset/*") | times(out, "figures/*/*/*") == before


def test_a_row_is_continued_at_its_missing_picture(made, monkeypatch):
    out, _ = made
    monkeypatch.setattr(making, "carry_out", main)
    (place,) = out.glob(PLACE)
    kept = times(place, "0.png")
    (place / "1.png").unlink()
    (place / "row.json").unlink()
    assert again(out) == 0
    assert (place / "row.json").exists() and (place / "1.png").exists()
    assert times(place, "0.png") == kept


def test_a_row_that_failed_is_on_the_page_and_is_tried_again(made, tmp_path):
    out, _ = made
    (place,) = out.glob(f"{PLACE}/row.json")
    before = json.loads(place.read_text())
    place.write_text(json.dumps({"failure": "It vanished.", "pictures": [], "numbers": {}}))
    page = write_page(tmp_path / "page.md", order(out, quick=True)).read_text()
    assert f"**{ROW}** failed: It vanished." in page
    assert again(out) == 0
    assert json.loads(place.read_text()) == before


@pytest.mark.slow
def test_a_guided_row_states_how_far_it_is_from_its_guide(tmp_path):
    words = ["reproduce", "--quick", "--figure=genus", "--row=genus 5 wanted"]
    assert main([*words, "--out", str(tmp_path)]) == 0
    (place,) = tmp_path.glob("figures/genus/*/row.json")
    distance = json.loads(place.read_text())["numbers"]["guide_distance"]
    assert 0 < distance < 10
    assert "distance to the guide, %: " in (tmp_path / "reproduction.md").read_text()


@pytest.mark.slow
def test_pictures_in_cycles_are_made_by_run_py(tmp_path):
    pytest.importorskip("bpy")
    words = ["reproduce", "--quick", "--figure=material", "--row=bust", "--out", str(tmp_path)]
    assert main(words) == 0
    page = (tmp_path / "reproduction.md").read_text()
    assert "as generated · wood · gold · marble" in page
    with Image.open(tmp_path / "reproduction" / "material-bust.jpg") as strip:
        tiles = [strip.crop((52 * i, 0, 52 * i + 48, 48)).tobytes() for i in range(4)]
    assert len(set(tiles)) == 4
