"""The comparison of the distillations: equal calls, resumable, one run folder a training."""

import json

import pytest
import torch

from core.benchmarks.bench_distillation import (
    INVERSION_STEPS,
    METHODS,
    bench_distillation,
    config_of,
    summary,
)
from core.errors import UserError
from core.guidance.builtin.guidance import PromptedBuiltin
from core.tests.tiny_runs import TINY


def test_every_method_gets_the_same_number_of_network_calls():
    for method in ("sds", "csd", "sdi"):
        config = config_of(method, 60, [])
        calls = 1 + INVERSION_STEPS if method == "sdi" else 1
        for phase in (config.geometry.coarse, config.appearance.early):
            assert phase.steps * calls == 60
            assert phase.distillation == method
        assert config.geometry.grow.rounds == config.appearance.refine.rounds == 0
        assert config.geometry.fine.steps == config.appearance.late.steps == 0


@pytest.mark.usefixtures("coarse")  # the three appearances are of one solid under one light
def test_a_short_bench_is_scored_written_and_not_made_again(tmp_path, monkeypatch, capsys):
    """With a guidance that predicts nothing: the file's work, not the network's."""
    asked = []

    def nothing(self, z_t, t, views, *, cond_only=False, apart=False):
        from core.guidance.guidance import Predictions

        asked.append(len(z_t))
        return Predictions(torch.zeros_like(z_t), torch.zeros_like(z_t))

    monkeypatch.setattr(PromptedBuiltin, "predict", nothing)
    monkeypatch.setattr("core.benchmarks.bench_distillation.SOLID", 16)  # fewer faces to unwrap
    small = ["geometry.resolution=12,12", "geometry.fit_steps=20", "geometry.views=2"]
    small += ["appearance.views=2", "appearance.log2_hash_size=8"]
    small += [f"{key}={value}" for key, value in TINY.items() if "sharpen" in key]
    out = tmp_path / "table.json"
    bench_distillation(["ball"], small, 4, tmp_path / "runs", out)
    assert len(asked) == len(METHODS) * 4
    output, table = capsys.readouterr().out, json.loads(out.read_text())
    assert [(run["stage"], run["method"]) for run in table["runs"]] == list(METHODS)
    assert all(not run["failure"] for run in table["runs"])
    assert "appearance sdi, of 1 nouns: dE, mean" in output
    for stage, method in METHODS:
        assert (tmp_path / "runs" / "ball" / f"{stage}-{method}" / "job.json").exists()
    asked.clear()
    bench_distillation(["ball"], small, 4, tmp_path / "runs", out)
    assert not asked
    assert json.loads(out.read_text())["runs"] == table["runs"]
    for others in ((small, 8), (small[1:], 4)):  # these scores are none of theirs
        with pytest.raises(UserError, match="holds scores of other settings"):
            bench_distillation(["ball"], *others, tmp_path / "runs", out)


def test_a_failed_training_counts_as_wrong_and_an_unknown_noun_is_refused():
    facts = {"noun": "ball", "stage": "geometry", "method": "csd", "failure": "", "rank": 1}
    made = facts | {"chamfer": 0.1, "cpu_s": 1.0}
    rows = summary([made, facts | {"failure": "The surface vanished."}])
    assert rows[0]["name"] == "geometry csd, of 2 nouns: nearest to their own"
    assert rows[0]["value"] == 1
    with pytest.raises(UserError, match="no noun 'barometer'"):
        bench_distillation(["barometer"], [])
