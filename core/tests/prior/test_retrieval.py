"""Retrieval of shapes and the scores of ``bench prior``."""

import pytest
import torch

from core.benchmarks.bench_prior import (
    ADDED,
    GENUS,
    line,
    main_delta_e,
    one_wall,
    summary,
    words_for,
)
from core.geometry.marching_tets import marching_tets
from core.geometry.tet_grid import tet_grid
from core.guidance.builtin.palette import COLOR_VALUES
from core.guidance.builtin.words.grammar.lexicon import SLOTS
from core.guidance.builtin.words.vocabulary import parse
from core.io.maps import Maps
from core.ops import lab, srgb_to_linear
from core.prior.data import NOUNS
from core.prior.draw import Draw
from core.prior.families import build
from core.prior.retrieval import (
    chamfer,
    kept_clouds,
    mesh_cloud,
    ranking,
    reference_clouds,
    turns,
)
from core.texture.detail.detail import THIN


def _generator(seed: int = 0) -> torch.Generator:
    return torch.Generator().manual_seed(seed)


def test_chamfer_is_zero_to_itself_symmetric_and_the_shift_of_a_far_point():
    a, b = torch.randn(2, 20, 3, generator=_generator())
    assert chamfer(a, a) < 1e-3  # cdist of equal points rounds
    torch.testing.assert_close(chamfer(a, b), chamfer(b, a))
    one, other = torch.zeros(1, 3), torch.tensor([[3.0, 4.0, 0.0]])
    assert chamfer(one, other).item() == pytest.approx(5.0)


def test_turning_about_the_vertical_loses_nothing():
    a = torch.randn(50, 3, generator=_generator(1))
    quarter = torch.stack([-a[:, 1], a[:, 0], a[:, 2]], 1)
    found = chamfer(turns(a, 4), quarter)
    assert found.argmin() == 1
    assert found[1] < 1e-3
    assert found[[0, 2, 3]].min() > 0.05


@pytest.mark.parametrize("noun", ["mug", "chair", "rocket"])
def test_a_mesh_of_a_fresh_object_is_nearest_to_its_own_noun(noun):
    references = reference_clouds(["mug", "chair", "table", "rocket", "bottle", "ball"], 3)
    shape = build(noun, "", Draw(_generator(3)))
    grid = tet_grid(32)
    verts, faces = marching_tets(grid.tet_verts, shape.sdf(grid.tet_verts), grid)
    turned = verts[:, [1, 0, 2]] * torch.tensor([-1.0, 1.0, 1.0]) * 0.4 + 2  # any pose and size
    ranks = ranking(mesh_cloud(turned, faces, _generator()), references)
    assert ranks[0][0] == noun
    assert ranks[0][1] < 0.75 * ranks[1][1]


def test_few_points_select_the_nouns_that_all_points_are_compared_with(monkeypatch):
    clouds = (
        torch.randn(40, 1, 384, 3, generator=_generator())
        * torch.linspace(1, 3, 40)[:, None, None, None]
    )
    references = {str(n): list(one) for n, one in enumerate(clouds)}
    cloud = torch.randn(384, 3, generator=_generator(1))
    found = ranking(cloud, references)
    monkeypatch.setattr("core.prior.retrieval.NEAR", 40)
    whole = ranking(cloud, references)
    assert found[:15] == whole[:15]  # each of the 24, by the same distance
    assert len(dict(found)) == 40


def test_reference_clouds_are_kept_until_what_makes_them_changes(tmp_path, monkeypatch):
    path = tmp_path / "new" / "references.safetensors"
    made = kept_clouds(["ball", "mug"], path)
    fresh = reference_clouds(["ball", "mug"])
    assert all(map(torch.equal, made["mug"], fresh["mug"]))
    asked = []
    monkeypatch.setattr(
        "core.prior.retrieval.reference_clouds", lambda nouns: asked.append(nouns) or fresh
    )
    again = kept_clouds(["ball", "mug"], path)
    assert not asked
    assert list(again) == ["ball", "mug"]
    assert all(map(torch.equal, again["mug"], made["mug"]))
    kept_clouds(["mug", "ball"], path)  # other nouns
    monkeypatch.setattr("core.prior.retrieval._state", lambda _: "another family")
    kept_clouds(["ball", "mug"], path)
    assert asked == [["mug", "ball"], ["ball", "mug"]]


def test_lab_has_its_known_values():
    """White, mid grey and sRGB red after Lindbloom's calculator (D65)."""
    srgb = torch.tensor([[1.0, 1.0, 1.0], [0.5, 0.5, 0.5], [1.0, 0.0, 0.0]])
    expected = torch.tensor([[100.0, 0, 0], [53.39, 0, 0], [53.24, 80.09, 67.20]])
    torch.testing.assert_close(lab(srgb_to_linear(srgb)), expected, atol=0.15, rtol=0)


def test_the_colour_is_judged_on_the_main_parts_fraction():
    red = srgb_to_linear(torch.tensor(COLOR_VALUES["red"]))
    green = srgb_to_linear(torch.tensor(COLOR_VALUES["green"]))
    half = torch.cat([red.expand(60, 3), green.expand(40, 3)])
    assert main_delta_e(half, "mushroom", "red") < 0.01  # one part of two is its cap
    assert main_delta_e(half, "ball", "red") < 0.01
    assert main_delta_e(half.flip(0)[:70], "ball", "red") > 50


def test_words_of_the_runs_can_be_read_and_go_round():
    known = {slot: list(words) for slot, words in SLOTS.items()}
    stated = [words_for(noun, seed, known) for noun in NOUNS for seed in (0, 1)]
    assert {color for color, _ in stated} == set(known["color"])
    assert {material for _, material in stated} == set(known["material"])
    for noun, (color, material) in zip(NOUNS, stated[::2], strict=True):
        words = parse(f"{color} {material} {noun}{ADDED.get(noun, '')}")
        assert words.part == ADDED.get(noun, "").removeprefix(" with a ")
        assert (words.noun, words.color, words.material) == (noun, color, material)


def test_a_failed_run_counts_as_wrong_in_every_rate():
    good = {"noun": "mug", "seed": 0, "color": "red", "material": "metal", "seconds": 1.0}
    good |= {"failure": "", "rank": 1, "nearest": ["mug"], "delta_e": 3.0, "closed": True}
    good |= {"components": 1, "genus": GENUS["mug"], "material_right": True}
    good |= {"roughness": 0.3, "metallic": 1.0, "crease": 0.9, "flat": 1.0, "missing": 0.01}
    good |= {"usual_missing": 0.0, "pieces": 1.0}
    bad = good | {"failure": "The surface vanished.", "seed": 1}
    rates = {r["name"]: r["value"] for r in summary([good, bad])}
    assert rates.pop("holes, of 1 runs") == 1
    assert rates.pop("crease, median") == 0.9
    assert set(rates.values()) == {0.5}
    assert "FAILED: The surface" in line(bad)
    assert "rank  1 " in line(good)


def test_the_colour_of_what_is_clear_is_that_of_one_wall():
    green = torch.tensor([0.05, 0.4, 0.1]).expand(2, 2, 3)
    clear = torch.tensor([[0.0, 0.95], [0.95, 0.0]])[..., None]
    maps = Maps(green ** (1 - THIN * clear), green, green, None, clear)
    assert maps.base_color[0, 1, 0] > 0.2
    torch.testing.assert_close(one_wall(maps), green)
    assert one_wall(maps._replace(transmission=None)) is maps.base_color
