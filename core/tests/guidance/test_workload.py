"""How long a run takes on a CPU: counted calls, counted operations, a measured speed."""

from dataclasses import replace

import pytest

from core.config import PRESETS, Config
from core.generate import prepare
from core.guidance.guidance import Work
from core.guidance.stable_diffusion.clip_files import CONFIGURATIONS
from core.guidance.stable_diffusion.source import Checkpoint
from core.guidance.stable_diffusion.work import work_of
from core.io.job import Job
from core.stages import workload
from core.stages.workload import calls_of, cpu_notice, operations_per_second, spoken
from core.tests.runs.test_stages import SHORT, guidance, learn, run_in, start_net


def test_the_papers_schedule_by_hand():
    """1,500 + 1,500 and 2,000 steps of 24 views; the coarse phase encodes nothing."""
    assert calls_of(PRESETS["paper"], "generate") == (5000 * 24, 3500 * 24)
    assert calls_of(PRESETS["paper"], "texture") == (2000 * 24, 2000 * 24)
    late = replace(Config().appearance.late, distillation="sdi", inversion_steps=7)
    config = replace(Config(), appearance=replace(Config().appearance, late=late))
    assert calls_of(config, "texture").predictions == 24 * (1000 + 8 * 1000)


def test_the_calls_of_a_training_are_those_that_are_counted(tmp_path):
    """Its rounds of fitting too, where every step encodes pictures again."""
    counted = guidance()
    predict, encode = counted.predict, counted.encode_normals
    predictions, encodings = [], []

    def predicted(z_t, *given, **more):
        predictions.append(len(z_t))
        return predict(z_t, *given, **more)

    def encoded(n, o):
        if n.requires_grad:
            encodings.append(len(n))
        return encode(n, o)

    counted.predict, counted.encode_normals = predicted, encoded
    learn(start_net(), counted, SHORT, run_in(tmp_path / "run"))
    whole = calls_of(replace(Config(), geometry=SHORT), "generate")
    material = calls_of(Config(), "texture")
    assert sum(predictions) == whole.predictions - material.predictions
    assert sum(encodings) == whole.encodings - material.encodings


def test_a_checkpoints_operations_are_those_known_of_stable_diffusion_1():
    """Its U-Net takes 0.8 TFLOP for 64² (2 for a multiply-add), its encoder 1.1 for 512²."""
    work = work_of(Checkpoint(CONFIGURATIONS / "sd15"))
    assert work.prediction == pytest.approx(2 * 0.8e12, rel=0.1)
    # Forward twice, and a backward to the picture alone, which is a forward's work.
    assert work.encoding == pytest.approx(3 * 1.1e12, rel=0.15)


def test_the_notice_has_calls_times_operations_by_speed(monkeypatch):
    """At 40 GFLOP/s: 48,000 views of 1.6 TFLOP and 3.2 TFLOP are 67 days."""
    monkeypatch.setattr(workload, "operations_per_second", lambda: 4e10)
    text = cpu_notice(Work(1.6e12, 3.2e12), PRESETS["paper"], "texture")
    assert "about 67 days" in text and "48,000 views" in text and "2 minutes each" in text
    assert cpu_notice(None, PRESETS["paper"], "generate") == ""
    assert cpu_notice(Work(1e6, 1e6), PRESETS["paper"], "generate") == ""


def test_a_small_checkpoint_is_not_announced_and_a_large_one_is(checkpoints, monkeypatch):
    job = Job(prompt="a chair", guidance=str(checkpoints["1.x"]), preset="paper")
    assert not prepare(job).warnings
    monkeypatch.setattr(workload, "WORTH_TELLING", 1e-9)
    (text,) = prepare(job).warnings
    assert text.startswith("On this CPU the run will take about")


def test_the_speed_is_that_of_a_machine_and_times_are_words():
    assert 1e8 < operations_per_second() < 1e14
    assert [spoken(s) for s in (40, 300, 10_000, 86400 * 12)] == [
        "40 s", "5 minutes", "3 hours", "12 days",
    ]  # fmt: skip
