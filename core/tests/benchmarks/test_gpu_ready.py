"""What a GPU would have to wait for, and what its memory would have to hold, seen without one."""

from collections import Counter
from dataclasses import replace

import numpy as np
import pytest
import torch
from torch.nn.utils import clip_grad_norm_

from core import benchmarks, kernels
from core.appearance import shaded
from core.appearance.environment import Environment
from core.appearance.material import MaterialNet
from core.appearance.shaded import SurfacePoints, material_at
from core.benchmarks import bench_rehearsal
from core.benchmarks.bench_rehearsal import PHASES, Rehearsal, configurations, random_guidance
from core.camera import Cameras
from core.command_line import main
from core.device import sent
from core.errors import MemoryShortError, UserError
from core.geometry.tet_grid import tet_grid
from core.guidance.gaussian import GaussianGuidance
from core.guidance.guidance import Views
from core.guidance.stable_diffusion.memory import _Live
from core.io.job import read_events
from core.io.progress import Progress, Step
from core.render.antialias import edge_table
from core.render.normals import render_normals
from core.stages.appearance import LitObject, appearance_phases, learn_appearance
from core.stages.geometry import Distillation
from core.stages.guard import healthy_gradients
from core.stages.training import gradient_of
from core.tests.meshes import sphere
from core.tests.pretended_gpu import GPU, pretended, waits
from core.tests.runs.test_stages import (
    GREY,
    SHORT,
    SHORT_COLOR,
    color_setup,
    run_in,
    setup_of,
    unwrapped_sphere,
)

RENDER_WAITS = 7  # of one render of all views, with its gradient: sizes that depend on the picture
PART_WAITS = RENDER_WAITS + 1  # and one check whether the guidance's output is finite


@pytest.fixture
def plain(monkeypatch):
    """Plain torch, as on a GPU."""
    monkeypatch.setattr(kernels, "supports", lambda *_: False)


def test_the_pretended_gpu_sees_what_waits_and_what_mixes():
    with pretended():
        x = torch.arange(4.0, device=GPU)
        assert float(x.sum()) == 6
        assert x[x > 1].tolist() == [2, 3]  # the size, then the numbers
        torch.repeat_interleave(x.long())
        x + x.new_tensor([1.0, 2.0, 3.0, 4.0])
        sent(torch.ones(4), GPU)  # does not
        assert sum(waits.values()) == 5
        torch.ones(4).to(GPU)
        assert sum(waits.values()) == 6
        with pytest.raises(AssertionError, match="two devices"):
            x + torch.ones(4)
        y = x.clone().requires_grad_()
        (y * y).sum().backward()
        assert y.grad.tolist() == [0, 2, 4, 6]


def test_the_guard_waits_once_for_all_parameters():
    net = torch.nn.Sequential(*(torch.nn.Linear(3, 3) for _ in range(10)))
    with pretended():
        net.to(GPU)
        net(torch.ones(2, 3, device=GPU)).sum().backward()
        waits.clear()
        assert healthy_gradients(net)
        assert sum(waits.values()) == 1
    net.cpu()
    assert healthy_gradients(torch.nn.Linear(1, 1))  # none yet
    for bad in (torch.nan, torch.inf, -torch.inf):
        net[3].weight.grad[1, 2] = bad
        assert not healthy_gradients(net)
    net[3].weight.grad[:] = 3e38  # whose square is not finite
    assert healthy_gradients(net)


def test_a_render_waits_for_seven_sizes(plain):
    verts, faces = sphere(5)
    cameras = Cameras.orbit([0.0, 90.0, 180.0], [20.0])
    with pretended():
        there = verts.to(GPU).requires_grad_()
        edges = edge_table(faces.to(GPU))
        for _ in range(2):  # the first one sends its tables
            waits.clear()
            drawn = render_normals(there, faces.to(GPU), cameras.to(GPU), 64, edges=edges)
            torch.cat(drawn, -1).square().sum().backward()
            there.grad, grad = None, there.grad
        assert sum(waits.values()) - 1 == RENDER_WAITS  # one of them sent the faces
    here = verts.clone().requires_grad_()
    same = render_normals(here, faces, cameras, 64)
    torch.cat(same, -1).square().sum().backward()
    torch.testing.assert_close(grad.at, here.grad, rtol=1e-4, atol=1e-4)


def guidance_there():
    """One that knows grey pictures only."""
    grey = lambda cameras: torch.zeros(1, len(cameras), 4, 16, 16, device=GPU)  # noqa: E731
    guidance = GaussianGuidance(grey, 16)
    guidance.alpha_bar = guidance.alpha_bar.to(GPU)
    return guidance.prompted()


def geometry_step(tmp_path, name, **changes):
    config = replace(SHORT, views=3, **changes)
    setup = setup_of(config, guidance_there(), run_in(tmp_path))
    setup.training.module.to(GPU)
    return setup, Distillation(setup, tet_grid(12, device=GPU), name, before=0)


def color_step(tmp_path, mesh, light):
    config = replace(SHORT_COLOR, views=3, views_at_once=3, smooth=0.0)
    setup = replace(color_setup(config, run_in(tmp_path)), guidance=guidance_there())
    setup.training.module.to(GPU)
    subject = LitObject(mesh.to(GPU), light.to(GPU), None)
    return setup, appearance_phases(setup, subject)[0]


def waits_of(setup, phase):
    """Of a step as it is taken again and again; the first one sends its tables."""
    for _ in range(2):
        waits.clear()
        gradient_of(setup, phase, Step(0, 1, 1, last=False))
        counted = Counter(waits)
        clip_grad_norm_(setup.training.module.parameters(), 1.0)
        setup.training.set_learning_rate(1e-3)
        setup.training.optimizer.step()
        assert waits == counted  # the optimiser waits for nothing
    return sum(waits.values())


def test_a_step_waits_for_what_has_no_other_way(plain, tmp_path):
    """Nothing is sent, and nothing is asked for each parameter or each view."""
    with pretended():
        rays = geometry_step(tmp_path / "rays", "coarse", views_at_once=3, eikonal=0.05)
        assert waits_of(*rays) == 5 + PART_WAITS
        # Without rays and the eikonal term only the nodes at the surface have a gradient.
        fine = geometry_step(tmp_path / "fine", "fine", views_at_once=3, eikonal=0.0)
        assert waits_of(*fine) == 7 + PART_WAITS
        parts = geometry_step(tmp_path / "parts", "fine", views_at_once=1, eikonal=0.0)
        assert waits_of(*parts) == 7 + 3 * PART_WAITS


def test_a_step_of_the_appearance_waits_for_two_numbers_more_than_its_parts(plain, tmp_path):
    mesh, light = unwrapped_sphere(), Environment.of(GREY, "split_sum")
    with pretended():
        assert waits_of(*color_step(tmp_path, mesh, light)) == 2 + PART_WAITS


def test_many_points_of_a_material_are_not_kept(monkeypatch):
    monkeypatch.setattr(shaded, "CHUNK", 1 << 10)
    net = MaterialNet(SHORT_COLOR, torch.Generator().manual_seed(0))
    points = torch.rand(1 << 12, 3) - 0.5
    at = SurfacePoints(points, points[:, :2], *(points for _ in range(5)))
    peaks, grads = [], []
    for material in (lambda: net(points), lambda: material_at(net, at)):
        net.zero_grad()
        with _Live() as live:
            kd = material().kd
            kept = live.now
            kd.square().sum().backward()
        peaks.append(kept)
        grads.append(torch.cat([p.grad.flatten() for p in net.parameters()]))
    assert peaks[1] < peaks[0] / 2.5  # of this small grid; the material itself stays
    torch.testing.assert_close(grads[1], grads[0], rtol=1e-4, atol=1e-6)


def test_what_does_not_fit_is_halved_and_goes_on(tmp_path):
    """The same numbers as when it had started with that, and one warning."""
    mesh, light = unwrapped_sphere(), Environment.of(GREY, "split_sum")
    early = replace(SHORT_COLOR.early, steps=2)
    short = replace(SHORT_COLOR, early=early, views=3, views_at_once=3)
    made = []
    for broken in (True, False):
        config = short if broken else replace(short, views_at_once=1)
        run = run_in(tmp_path / str(broken))
        setup = color_setup(config, run)
        encode, tries = setup.guidance.encode_color, []

        def small(srgb, o, encode=encode, tries=tries, broken=broken):
            tries.append(len(srgb))
            if broken and len(srgb) > 1:
                raise torch.OutOfMemoryError("CUDA out of memory. Tried to allocate 2.00 GiB")
            return encode(srgb, o)

        setup.guidance.encode_color = small
        learn_appearance(setup, mesh, light, Progress(run))
        made.append(setup.training.module(mesh.verts).kd)
        warnings = [e["text"] for e in read_events(run.path) if e["type"] == "warning"]
        assert len(warnings) == broken
        assert not broken or "went on with 1 at a time" in warnings[0]
        assert tries[0] == (3 if broken else 1)
        assert set(tries[1:]) == {1}
    assert torch.equal(*made)


def test_one_view_that_does_not_fit_ends_the_run(tmp_path):
    run = run_in(tmp_path)
    setup = color_setup(replace(SHORT_COLOR, views_at_once=2), run)

    def never(srgb, o):
        raise MemoryShortError("There is not enough memory for the encoder.")

    setup.guidance.encode_color = never
    mesh, light = unwrapped_sphere(), Environment.of(GREY, "split_sum")
    with pytest.raises(MemoryShortError):
        learn_appearance(setup, mesh, light, Progress(run))


@pytest.mark.parametrize(("architecture", "views"), [("sd15", 2), ("sdxl", 2), ("mvdream", 4)])
def test_the_rehearsal_times_each_part_and_foretells_the_schedule(
    architecture, views, capsys, monkeypatch
):
    for name, less in (("STEPS", 1), ("FIT_STEPS", 10), ("FACES", 2000)):
        monkeypatch.setattr(bench_rehearsal, name, less)
    lines = bench_rehearsal.bench_rehearsal(
        Rehearsal(architecture, "tiny", views, views, device="cpu")
    )
    names = [line["name"] for line in lines]
    for phase in PHASES:
        parts = [n.split(": ")[1].split(",")[0] for n in names if n.startswith(f"{phase}: ")]
        wanted = ["a step", "U-Net", "VAE", "renderer", "field and the rest"]
        wanted = [name for name in wanted if name != "VAE" or phase != "coarse"]
        assert parts[:-1] == wanted
    assert names[-1] == "the paper's whole schedule"
    values = {line["name"]: line["value"] for line in lines}
    assert values[f"coarse: U-Net, {views} views"] > 0
    total = sum(line["value"] for line in lines if "steps of 24" in line["name"])
    assert values["the paper's whole schedule"] == pytest.approx(total)
    assert "fine: VAE" in capsys.readouterr().out


def test_stable_diffusion_2_is_rehearsed_with_its_own_networks():
    rehearsal = Rehearsal("sd21", batch=1, chunk=1)
    unet, _ = configurations(rehearsal)
    assert (unet["cross_attention_dim"], unet["sample_size"]) == (1024, 64)  # of 512² pictures
    small = random_guidance(replace(rehearsal, scale="tiny"), torch.device("cpu"))
    views = Views(Cameras.orbit([0.0], [20.0]))
    found = small.predict(torch.zeros(1, 4, 8, 8), torch.tensor([500]), views)
    assert found.cond.shape == (1, 4, 8, 8)


def test_an_unknown_architecture_is_one_sentence(capsys):
    assert main(["bench", "guidance", "--architecture", "sd99", "--device", "cpu"]) == 2
    assert "Use one of sd15, sd21, sdxl, mvdream." in capsys.readouterr().err
    with pytest.raises(UserError, match="--batch is 0"):
        Rehearsal("sd15", batch=0)
    with pytest.raises(UserError, match="--chunk is 2") as caught:
        Rehearsal("mvdream", batch=8, chunk=2)
    assert "a multiple of 4" in caught.value.fix
    assert main(["bench", "render", "--architecture", "sd15"]) == 2
    assert "belongs to bench guidance" in capsys.readouterr().err


@pytest.mark.parametrize(("long", "times"), [(0.0, 1), (60.0, 4)])
def test_a_long_step_is_timed_once_and_a_short_one_after_a_first(monkeypatch, long, times):
    monkeypatch.setattr(benchmarks, "LONG", long)
    done = []
    assert benchmarks.wall_ms(lambda: done.append(1), torch.device("cpu"), 3) > 0
    assert len(done) == times


def test_a_first_run_does_not_count_and_of_the_others_the_least(monkeypatch):
    clock = iter(np.cumsum([0, 1, 9, 3, 9, 2, 9, 4]).tolist())
    monkeypatch.setattr(benchmarks.time, "perf_counter", lambda: next(clock))
    assert benchmarks.wall_ms(lambda: None, torch.device("cpu"), 3) == pytest.approx(2000)
