"""What a GPU would have to wait for, and what its memory would have to hold, seen without one."""

from collections import Counter
from dataclasses import replace

import pytest
import torch
from torch.utils._python_dispatch import TorchDispatchMode

from core import kernels
from core.appearance import shaded
from core.appearance.environment import Environment
from core.appearance.material import MaterialNet
from core.appearance.shaded import SurfacePoints, material_at
from core.benchmarks.bench_rehearsal import PHASES, Rehearsal, bench_rehearsal
from core.camera import Cameras
from core.command_line import main
from core.errors import MemoryShortError, UserError
from core.geometry.tet_grid import tet_grid
from core.guidance.gaussian import GaussianGuidance
from core.guidance.stable_diffusion.memory import _Live
from core.io.job import read_events
from core.io.progress import Progress, Step
from core.render.antialias import edge_table
from core.render.normals import render_normals
from core.stages.appearance import learn_appearance
from core.stages.geometry import Distillation
from core.stages.guard import healthy_gradients
from core.stages.training import gradient_of
from core.tests.meshes import sphere
from core.tests.test_stages import (
    GREY,
    SHORT,
    SHORT_COLOR,
    color_setup,
    run_in,
    setup_of,
    unwrapped_sphere,
)

# What asks for a number, or for a size that depends on numbers.
WAITS = ("_local_scalar_dense", "nonzero", "unique", "masked_select", "_unique2")

RENDER_WAITS = 14  # of one render of all views, with its gradient: sizes that depend on the picture


class Waits(TorchDispatchMode):
    """Counts what a GPU would be waited for."""

    def __init__(self):
        super().__init__()
        self.count = Counter()

    def __torch_dispatch__(self, func, types, args=(), kwargs=None):
        name = func.overloadpacket.__name__
        bools = name == "index" and any(x is not None and x.dtype == torch.bool for x in args[1])
        sizeless = name == "repeat_interleave" and not (kwargs or {}).get("output_size")
        if name in WAITS or bools or sizeless or name == "unique_consecutive":
            self.count[name] += 1
        return func(*args, **(kwargs or {}))

    @property
    def total(self):
        return sum(self.count.values())


@pytest.fixture
def plain(monkeypatch):
    """Plain torch, as on a GPU."""
    monkeypatch.setattr(kernels, "supports", lambda *_: False)


def test_the_count_sees_what_waits():
    with Waits() as waits:
        x = torch.arange(4.0)
        float(x.sum())
        x[x > 1]
        torch.repeat_interleave(torch.tensor([1, 2]))
    assert waits.total == 3


def test_the_guard_waits_once_for_all_parameters():
    net = torch.nn.Sequential(*(torch.nn.Linear(3, 3) for _ in range(10)))
    net(torch.ones(2, 3)).sum().backward()
    with Waits() as waits:
        assert healthy_gradients(net)
    assert waits.count == {"_local_scalar_dense": 1}
    assert healthy_gradients(torch.nn.Linear(1, 1))  # none yet
    for bad in (torch.nan, torch.inf, -torch.inf):
        net[3].weight.grad[1, 2] = bad
        assert not healthy_gradients(net)
    net[3].weight.grad[:] = 3e38  # whose square is not finite
    assert healthy_gradients(net)


def test_a_render_waits_a_bounded_number_of_times(plain):
    verts, faces = sphere(8)
    verts.requires_grad_()
    edges = edge_table(faces)
    cameras = Cameras.orbit([0.0, 90.0, 180.0], [20.0])
    with Waits() as waits:
        n, o = render_normals(verts, faces, cameras, 64, edges=edges)
        (n.sum() + o.sum()).backward()
    assert waits.total <= RENDER_WAITS


def test_a_step_waits_once_for_its_numbers(plain, tmp_path):
    """However many parts it has: but for their renders, and one look at what the network said."""
    totals = []
    for at_once in (3, 1):
        config = replace(SHORT, views=3, views_at_once=at_once, ray_mask_share=0.0)
        nothing = GaussianGuidance(lambda cameras: torch.zeros(1, len(cameras), 4, 16, 16), 16)
        setup = setup_of(config, nothing.prompted(), run_in(tmp_path / str(at_once)))
        phase = Distillation(setup, tet_grid(12), "coarse", before=0)
        with Waits() as waits:
            gradient_of(setup, phase, Step(0, 1, 1, last=False))
        totals.append(waits.total)
    assert totals[1] - totals[0] <= 2 * (RENDER_WAITS + 1)  # three parts, and one


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
    """The same numbers as when it had begun with that, and one warning."""
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
def test_the_rehearsal_times_each_part_and_foretells_the_schedule(architecture, views, capsys):
    lines = bench_rehearsal(Rehearsal(architecture, "tiny", views, views, device="cpu"))
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
