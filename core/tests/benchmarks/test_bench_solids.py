"""What ``bench solids`` measures."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from core.benchmarks import bench_solids as bench
from core.benchmarks.bench_solids import bench_solids, solid_scores, summary, variety
from core.benchmarks.likeness import Surface, objects
from core.errors import UserError
from core.geometry.parts.assembly import assembled
from core.guidance.builtin.guidance import PromptedBuiltin
from core.prior.retrieval import reference_clouds
from core.tests.drawn_things import shipped_prior


def _moved(surface: Surface, by: float) -> Surface:
    return replace(surface, points=surface.points + np.array([by, 0, 0]))


def test_variety_is_one_for_the_nouns_own_objects_and_none_for_copies():
    own = objects("mug")
    assert variety(list(own), own) == pytest.approx(1)
    assert variety([own[0]] * 3, own) == 0
    assert variety(list(own), (own[0], own[0])) == 1  # as of balls, which are all the same
    close, far = (variety([own[0], _moved(own[0], by)], own) for by in (0.02, 0.2))
    assert 0 < close < far


@pytest.mark.usefixtures("once")  # one mug
def test_a_drawn_mug_is_like_a_mug(monkeypatch):
    drawn = []

    def kept(*given):
        drawn.append(assembled(*given))
        return drawn[-1]

    monkeypatch.setattr(bench, "assembled", kept)
    monkeypatch.setattr(bench, "VARIED", 2)
    # The second time the same objects, whose meshes they keep.
    monkeypatch.setattr(PromptedBuiltin, "of_object", cache(PromptedBuiltin.of_object))
    guidance, references = shipped_prior(), reference_clouds(["bed", "mug", "tower"])
    scores = solid_scores(guidance, "mug", 1, references)
    assert (scores["first"], scores["first_five"], scores["nearer"]) == (1, 1, [])
    assert 0.8 < scores["crease"] < 1.3
    assert scores["missing"] <= scores["usual_missing"] + 0.03
    assert scores["pieces"] >= 0.85
    assert scores["cpu_s"] > 0
    # Once more with wrongly distinguished references; the shape and its likeness are kept.
    wrong = {"bed": references["mug"], "tower": references["tower"], "mug": references["bed"]}
    (made,) = drawn
    monkeypatch.setattr(bench, "assembled", lambda *_: made)
    monkeypatch.setattr(Surface, "of_mesh", lambda *_: None)
    monkeypatch.setattr(bench, "likeness", lambda *_: {})
    monkeypatch.setattr(bench, "variety", lambda drawn, own: (len(drawn), len(own)))
    report = solid_scores(guidance, "mug", 1, wrong)
    assert (report["first"], report["first_five"]) == (0, 1)
    assert "bed" in report["nearer"]
    assert report["variety"] == (2, 2)  # though one is put together


def test_the_summary_counts_nouns():
    good = {"crease": 0.9, "missing": 0.01, "usual_missing": 0.0, "pieces": 1.0, "variety": 0.9}
    good |= {"cpu_s": 1.0, "first": 1.0, "first_five": 1.0}
    bad = (
        good
        | {"first": 0.0, "first_five": 0.0}
        | {"crease": 1.5, "missing": 0.2, "pieces": 0.5, "variety": 0.1}
    )
    found = {line["name"]: line["value"] for line in summary({"a": good, "b": good, "c": bad})}
    for name in ("shape, top 1", "shape, top 5", "edges", "nothing missing", "pieces", "various"):
        assert found[name] == pytest.approx(2 / 3)


def test_an_unknown_noun_is_refused():
    with pytest.raises(UserError, match="no noun 'xyzzy'"):
        bench_solids(["xyzzy"], 1)
