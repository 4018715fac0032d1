import json
import time
from collections.abc import Callable
from typing import Any

import pytest
import torch

from core import benchmarks
from core.benchmarks import (
    ball,
    bench,
    bench_gpu,
    bench_guidance,
    least_ms,
    machine,
    row,
    table_line,
)
from core.benchmarks.bench_fit import bench_fit
from core.errors import UserError
from core.guidance.stable_diffusion import libraries


@pytest.mark.parametrize("faces", [1_000, 20_000])
def test_ball_is_closed_and_about_as_fine_as_asked(faces: int) -> None:
    verts, triangles = ball(faces)
    assert len(triangles) == pytest.approx(faces, rel=0.1)
    assert len(verts) - len(triangles) * 3 // 2 + len(triangles) == 2
    a, b, c = verts[triangles].unbind(1)
    assert float((torch.linalg.cross(a, b) * c).sum()) > 0  # faces outward


def test_time_is_the_processes_own() -> None:
    assert least_ms(lambda: time.sleep(0.05), 1) < 25


def test_line_shows_which_way_the_target_is() -> None:
    assert table_line({"part": "a"} | row("b", 1.0, "ms", 2.0)).endswith("ms  (at most 2)")
    assert table_line({"part": "a"} | row("b", 1.0, "", 0.5, at_least=True)).endswith(
        "(at least 0.5)"
    )
    assert table_line({"part": "a"} | row("b", 1.0, "ms")).endswith("ms")


def test_table_is_written_whole_with_the_machine(tmp_path, monkeypatch, capsys) -> None:
    monkeypatch.setattr(bench_gpu, "rows", lambda: [row("x", 3.0, "ms", 4.0)])
    bench(["gpu"], tmp_path / "table.json")
    table = json.loads((tmp_path / "table.json").read_text())
    assert table["machine"] == machine()
    assert table["rows"] == [{"part": "gpu"} | row("x", 3.0, "ms", 4.0)]
    monkeypatch.setattr(bench_gpu, "rows", list)
    bench(["gpu"])
    assert "no CUDA device" in capsys.readouterr().out


def test_unknown_part_is_named() -> None:
    with pytest.raises(UserError, match="rendr") as error:
        bench(["rendr"])
    assert all(part in error.value.fix for part in benchmarks.PARTS)


def test_a_step_next_to_a_network_runs_on_any_device(monkeypatch: pytest.MonkeyPatch) -> None:
    # By what is done, since the clock of a busy machine is no measure: a view that is rendered
    # counts 1, a latent that the network predicts 100.
    done = 0.0

    def counted(what: Callable[..., Any], count: Callable[..., float]) -> Callable[..., Any]:
        def call(*args: Any, **options: Any) -> Any:
            nonlocal done
            done += count(*args)
            return what(*args, **options)

        return call

    torch.manual_seed(0)
    unet = libraries.UNet2DConditionModel(
        sample_size=8,
        block_out_channels=(8, 8),
        layers_per_block=1,
        down_block_types=("DownBlock2D", "CrossAttnDownBlock2D"),
        up_block_types=("CrossAttnUpBlock2D", "UpBlock2D"),
        cross_attention_dim=8,
        attention_head_dim=2,
        norm_num_groups=4,
    )
    rendered = counted(bench_gpu.render_normals, lambda _verts, _faces, cameras, *_: len(cameras))
    predicted = counted(unet.forward, lambda latents, *_: 100 * len(latents))
    monkeypatch.setattr(bench_gpu, "render_normals", rendered)
    monkeypatch.setattr(unet, "forward", predicted)
    monkeypatch.setattr("time.perf_counter", lambda: done)
    render, step = bench_gpu.iteration_ms(unet, torch.device("cpu"), 200, views=2, size=32)
    assert render == 1e3 * 2
    assert step == 1e3 * (2 + 100 * 2 * 2)  # both branches of both views


def test_the_guidance_is_timed_for_both_networks() -> None:
    """The shipped networks take what is made for them here."""
    rows = bench_guidance.rows()
    assert ["geometry" in rows[0]["name"], "appearance" in rows[1]["name"]] == [True, True]
    assert all(found["value"] > 0 for found in rows)


def test_a_fit_of_other_settings_is_not_taken_for_this_one(tmp_path):
    (tmp_path / "settings.json").write_text('{"geometry.polish": "1"}')
    with pytest.raises(UserError, match="holds scores of other settings"):
        bench_fit(["chair"], {}, tmp_path)
