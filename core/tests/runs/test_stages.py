"""The trainings: their formulas, that views may be rendered in any portions, that they resume."""

import copy
import functools
import math
import shutil
from dataclasses import replace

import pytest
import torch

from core.adam import Adam
from core.appearance.environment import Environment
from core.appearance.material import MaterialNet
from core.appearance.shaded import UvMesh
from core.config import DRAFT, RefineConfig
from core.errors import Cancelled, NoSurfaceError
from core.geometry.init_shape import ellipsoid, fit
from core.geometry.marching_tets import marching_tets
from core.geometry.mesh import Mesh, health, polished, signed_volume
from core.geometry.sdf_net import FOURIER, SdfNet, band_about
from core.geometry.tet_grid import tet_grid
from core.guidance.gaussian import GaussianGuidance, mesh_reference
from core.io.job import Job, read_events
from core.io.progress import Progress
from core.io.run_folder import RunFolder
from core.ops import linear_to_srgb
from core.render.antialias import edge_table
from core.stages.appearance import LitObject, appearance_phases, learn_appearance
from core.stages.geometry import Distillation, Fitting, learn_geometry, random_rotations
from core.stages.regularisers import bending, eikonal, strays
from core.stages.shape_scene import ShapeScene
from core.stages.start_shape import sdf_net
from core.stages.state import Training
from core.stages.training import Setup, decayed
from core.tests.tiny_runs import loosely_packed
from core.texture.unwrap import unwrap

SHORT = replace(
    DRAFT.geometry,
    resolution=(12, 16),
    coarse=replace(DRAFT.geometry.coarse, steps=4, size=32),
    grow=RefineConfig(rounds=2, steps=3, views=5, batch=3, size=32, ray_mask=1.0),
    fine=replace(DRAFT.geometry.fine, steps=3, size=32),
    refine=RefineConfig(rounds=2, steps=3, views=5, batch=3, size=32),
    sharpen=replace(DRAFT.geometry.sharpen, rounds=0),  # Gauss' guidance has none
    views=4,
    views_at_once=4,
    cameras=replace(DRAFT.geometry.cameras),
)
GREY = torch.full((8, 16, 3), 0.8)


@functools.cache
def grey_light():
    return Environment.of(GREY)


def sphere(resolution=16, radius=0.6):
    grid = tet_grid(resolution)
    return marching_tets(grid.tet_verts, grid.tet_verts.norm(dim=1) - radius, grid)


def guidance(frame="object", size=16):
    return GaussianGuidance(mesh_reference([sphere(radius=0.8)], size, normal_frame=frame), size,
                            normal_frame=frame).prompted()  # fmt: skip


def start_net(config=SHORT, radius=0.5):
    return copy.deepcopy(fitted(config.net, config.resolution, radius))


@functools.cache
def fitted(net, resolution, radius):
    """Ψ of a ball, fitted once: the fit takes longer than most of the tests."""
    generator = torch.Generator().manual_seed(0)
    psi = sdf_net(replace(SHORT, net=net, resolution=resolution), generator)
    fit(psi, ellipsoid((radius,) * 3), 60, generator)
    return psi


def run_in(path):
    return RunFolder.create(path, Job(prompt="a ball"))


def learn(net, g, config, run, seed=1):
    """The whole geometry training; its mesh."""
    training = Training("geometry", net, torch.Generator().manual_seed(seed), run)
    return learn_geometry(Setup(training, g, config), Progress(run))


def gradient(phase, setup, index):
    """Of one step, as one vector."""
    scene, losses = phase.begin(index)
    scene.backward(losses)
    return torch.cat([p.grad.flatten() for p in setup.training.module.parameters()])


def setup_of(config, g, run, seed=5):
    training = Training("geometry", start_net(config), torch.Generator().manual_seed(seed), run)
    return Setup(training, g, config)


def test_the_rate_ends_at_its_fraction():
    assert decayed(2.0, 0.25, 0.0) == 2.0
    assert decayed(2.0, 0.25, 0.5) == 1.0
    assert decayed(2.0, 0.25, 1.0) == 0.5


def test_random_rotations_are_rotations_without_a_preferred_direction():
    r = random_rotations(20000, torch.Generator().manual_seed(0))
    torch.testing.assert_close(r @ r.mT, torch.eye(3).expand_as(r), atol=1e-5, rtol=0)
    torch.testing.assert_close(torch.linalg.det(r), torch.ones(len(r)))
    # Each entry of a uniform rotation has mean 0 and variance 1/3.
    assert float(r.mean(0).abs().max()) < 4.5 * math.sqrt(1 / 3 / len(r))
    assert float((r.square().mean(0) - 1 / 3).abs().max()) < 4.5 * math.sqrt(4 / 45 / len(r))


def test_a_true_distance_pays_nothing_and_its_double_pays_one():
    grid = tet_grid(10)
    plane = grid.tet_verts @ torch.tensor([0.6, 0.0, 0.8])
    assert float(eikonal(plane, grid)) == pytest.approx(0, abs=1e-6)
    assert float(eikonal(2 * plane, grid)) == pytest.approx(1, abs=1e-4)


def test_bending_of_a_regular_tetrahedron_is_four_thirds():
    """Its outward normals meet at arccos(-1/3)."""
    verts = torch.tensor([[1.0, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]])
    faces = torch.tensor([[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]])
    assert float(bending(verts, faces, edge_table(faces))) == pytest.approx(4 / 3, rel=1e-5)


def test_polish_takes_off_the_bumps_and_keeps_the_volume():
    verts, faces = sphere(32)
    bump = 0.01 * torch.randn(len(verts), 1, generator=torch.Generator().manual_seed(0))
    rough = verts * (1 + bump)
    smooth = polished(rough, faces, 10)
    assert polished(rough, faces, 0) is rough
    before, after = ((x.norm(dim=1) - 0.6).std() for x in (rough, smooth))
    assert float(after) < 0.45 * float(before)
    assert signed_volume(smooth, faces) == pytest.approx(signed_volume(rough, faces), rel=0.01)


def torus(resolution=24, ring=0.5, tube=0.22):
    grid = tet_grid(resolution)
    x, y, z = grid.tet_verts.unbind(1)
    return marching_tets(grid.tet_verts, ((x.hypot(y) - ring).hypot(z) - tube), grid)


@pytest.mark.parametrize("ray_mask", [1.0, 0.0])
def test_growing_opens_a_hole_along_the_rays_and_only_so(tmp_path, ray_mask):
    """A ball under a guidance that knows a torus: no outline of the ball is where its hole is, and
    normals alone dent it slowly."""
    none = replace(SHORT.coarse, steps=0)
    grow = RefineConfig(rounds=2, steps=25, views=12, batch=6, size=32, t=(0.9, 0.6))
    # At twice the rate the ball vanishes at first, and whether its dents tear is the CPU's chance.
    grow = replace(grow, ray_mask=ray_mask, learning_rate=5e-3)
    config = replace(SHORT, coarse=none, grow=grow, fine=none, refine=RefineConfig())
    g = GaussianGuidance(mesh_reference([torus()], 32, normal_frame="object"), 32).prompted()
    config = replace(config, resolution=(24, 24))
    verts, faces = learn(start_net(config), g, config, run_in(tmp_path))
    assert health(verts, faces)["genus"] == (1 if ray_mask else 0)


@pytest.mark.parametrize("frame", ["object", "camera"])
@pytest.mark.parametrize("name", ["coarse", "fine"])
@pytest.mark.parametrize("rays", [0.0, 1.0])
def test_the_gradient_does_not_depend_on_how_many_views_are_rendered_at_once(
    tmp_path, frame, name, rays
):
    """With all that is random by view: the turns of the normals, the samples of the rays."""
    grads = []
    for at_once in (4, 3, 1):
        config = replace(SHORT, views_at_once=at_once, ray_mask_share=rays, rotate_normals=True)
        setup = setup_of(config, guidance(frame), run_in(tmp_path / str(at_once)))
        phase = Distillation(setup, tet_grid(config.resolution[0]), name, before=0)
        grads.append(gradient(phase, setup, 1))
    assert float(grads[0].norm()) > 0
    torch.testing.assert_close(grads[1], grads[0], rtol=1e-3, atol=1e-6)
    torch.testing.assert_close(grads[2], grads[0], rtol=1e-3, atol=1e-6)


@pytest.mark.parametrize("name", ["refine", "grow"])
def test_the_fitting_gradient_does_not_depend_on_how_many_views_are_rendered_at_once(
    tmp_path, name
):
    grads = []
    for at_once in (5, 2, 1):
        config = replace(SHORT, views_at_once=at_once)
        setup = setup_of(config, guidance(), run_in(tmp_path / str(at_once)))
        grads.append(gradient(Fitting(setup, tet_grid(12), name), setup, 0))
    assert float(grads[0].norm()) > 0
    torch.testing.assert_close(grads[1], grads[0], rtol=1e-3, atol=1e-6)
    torch.testing.assert_close(grads[2], grads[0], rtol=1e-3, atol=1e-6)


def test_refining_fits_the_pictures_that_the_guidance_means(tmp_path):
    """A sphere of 0.6 under a guidance that knows one of 0.8, by refining alone."""
    none = replace(SHORT.coarse, steps=0)
    refine = RefineConfig(rounds=2, steps=25, views=6, batch=3, size=32, t=(0.7, 0.5))
    config = replace(
        SHORT,
        coarse=none,
        grow=RefineConfig(),
        fine=none,
        refine=replace(refine, learning_rate=1e-2),
    )
    verts, _ = learn(start_net(config, 0.6), guidance(), config, run_in(tmp_path))
    radius = verts.norm(dim=1)
    assert float(radius.mean()) == pytest.approx(0.8, abs=0.04)
    assert float(radius.std()) < 0.04


class Ball(SdfNet):
    """A ball's distance, ``side`` times as long outside of 0.8."""

    side = 1.0

    def forward(self, points):
        away = points.norm(dim=1)
        return (away - 0.5) * torch.where(away > 0.8, self.side, 1.0), torch.zeros_like(points)


def test_what_is_outside_of_the_band_stays_on_its_side():
    grid = tet_grid(16)
    net = Ball(grid.cell, FOURIER)
    band = band_about(net, grid, 1)
    generator = torch.Generator().manual_seed(0)
    assert float(strays(net, grid, band, generator)) == 0
    net.side = 0.6  # farther or nearer is free
    assert float(strays(net, grid, band, generator)) == 0
    net.side = -1.0
    assert float(strays(net, grid, band, generator)) > 1


def test_walls_that_came_up_far_away_go_again():
    grid, net = tet_grid(16), start_net()
    band = band_about(net, grid, 1)
    far = torch.ones(len(band.sdf), dtype=torch.bool)
    far[band.near] = False
    with torch.no_grad():
        net.mlp[-1].bias[0] -= 1.0
        assert (net(grid.tet_verts)[0].sign() != band.sdf.sign())[far].float().mean() > 0.5
    optimizer = Adam(net.parameters(), 1e-2)
    generator = torch.Generator().manual_seed(0)
    for _ in range(30):
        optimizer.zero_grad()
        strays(net, grid, band, generator).backward()
        optimizer.step()
    with torch.no_grad():
        assert (net(grid.tet_verts)[0].sign() != band.sdf.sign())[far].float().mean() < 0.01


def test_the_mask_along_empty_rays_reaches_the_lattice(tmp_path):
    grads = []
    for rays in (1.0, 0.0):  # with and without
        config = replace(SHORT, eikonal=0.0, ray_mask_share=rays)
        setup = setup_of(config, guidance(), run_in(tmp_path / str(rays)))
        scene, losses = Distillation(setup, tet_grid(12), "coarse", before=0).begin(1)
        scene.backward(losses)
        grads.append(None if scene.sdf is None else scene.sdf.grad)
    assert grads[0] is not None
    assert float(grads[0].abs().sum()) > 0
    assert grads[1] is None


def test_what_is_gathered_at_the_surface_and_the_lattice_is_carried_into_psi():
    """As if the losses had been computed on Ψ's own graph."""
    grid, grads = tet_grid(12), []
    for apart in (True, False):
        net = start_net()
        scene = ShapeScene(net, grid, guidance(), lattice=True)
        verts, sdf = (scene.verts, scene.sdf) if apart else (scene._verts, scene._sdf)
        assert sdf is not None
        loss = (verts**3).sum() + (sdf**2).sum()
        if apart:
            scene.backward(iter([loss]))
        else:
            loss.backward()
        grads.append(torch.cat([p.grad.flatten() for p in net.parameters()]))
    torch.testing.assert_close(*grads, rtol=1e-4, atol=1e-5)


@pytest.fixture(scope="module")
def unbroken(tmp_path_factory):
    """A whole geometry training: its run folder and its mesh."""
    run = run_in(tmp_path_factory.mktemp("unbroken") / "run")
    return run.path, learn(start_net(), guidance(), SHORT, run)


@pytest.mark.parametrize("stop", [3, 8, 14])  # distilling; within a round of growing; of refining
def test_geometry_resumes_to_the_same_mesh(unbroken, tmp_path, stop, monkeypatch):
    whole = unbroken[1]
    run = run_in(tmp_path / "b")
    steps = Progress.steps

    def broken(self, stage, first, counts):
        for step in steps(self, stage, first, counts):
            if step.at == stop:
                self.interrupt()
            yield step

    with monkeypatch.context() as patch:
        patch.setattr(Progress, "steps", broken)
        with pytest.raises(Cancelled):
            learn(start_net(), guidance(), SHORT, run)
    again = learn(start_net(), guidance(), SHORT, RunFolder.open(run.path))
    assert torch.equal(again[1], whole[1])
    torch.testing.assert_close(again[0], whole[0], rtol=0, atol=0)


def test_a_geometry_without_a_step_left_gives_the_same_mesh(unbroken, tmp_path):
    """Ψ's offsets reach as far as the fine lattice's cell, whether or not a step was taken."""
    path, whole = unbroken
    shutil.copytree(path, tmp_path / "run")
    again = learn(start_net(), guidance(), SHORT, RunFolder.open(tmp_path / "run"))
    assert torch.equal(again[1], whole[1])
    torch.testing.assert_close(again[0], whole[0], rtol=0, atol=0)


def test_a_surface_that_is_gone_at_the_end_is_a_sentence(tmp_path):
    none, rounds = replace(SHORT.coarse, steps=0), RefineConfig()
    config = replace(SHORT, coarse=none, grow=rounds, fine=none, refine=rounds)
    net = start_net()
    with torch.no_grad():
        net.mlp[-1].bias[0] += 10
    with pytest.raises(NoSurfaceError, match="vanished.*--guide") as caught:
        learn(net, guidance(), config, run_in(tmp_path))
    assert caught.value.status == 5


def test_a_vanished_surface_goes_back_and_then_ends_with_a_sentence(tmp_path):
    """Ψ starts all outside: nothing can bring it back, and the run exits with code 5."""
    net = start_net()
    with torch.no_grad():
        net.mlp[-1].bias[0] += 10
    run = run_in(tmp_path)
    long = replace(SHORT, coarse=replace(SHORT.coarse, steps=40))
    with pytest.raises(NoSurfaceError, match="vanished.*--guide"):
        learn(net, guidance(), long, run)
    assert sum(e["type"] == "warning" for e in read_events(run.path)) == 5


SHORT_COLOR = replace(
    DRAFT.appearance,
    early=replace(DRAFT.appearance.early, steps=16, size=32),
    late=replace(DRAFT.appearance.late, steps=4, size=32),
    refine=RefineConfig(rounds=1, steps=4, views=3, batch=2, size=32, learning_rate=1e-2),
    views=2,
    views_at_once=1,
    log2_hash_size=12,
    finest=32,
    smooth=0.1,
    bump=0.5,
)


def color_setup(config, run):
    """Γ under a guidance that knows red pictures only."""
    red = torch.tensor([0.8, -0.8, -0.8, 1.0])[:, None, None].expand(4, 16, 16)
    reference = lambda cameras: red.expand(1, len(cameras), 4, 16, 16)  # noqa: E731
    teacher = GaussianGuidance(reference, 16).prompted()
    net = MaterialNet(config, torch.Generator().manual_seed(0))
    training = Training("appearance", net, torch.Generator().manual_seed(1), run)
    return Setup(training, teacher, config)


@functools.cache
def unwrapped_sphere():
    verts, faces = sphere(8)
    with loosely_packed():
        return UvMesh.of(Mesh(verts, faces, *unwrap(verts, faces, 64)))


def test_appearance_learns_the_color_and_ends_with_a_checkpoint(tmp_path):
    config, mesh = SHORT_COLOR, unwrapped_sphere()

    def learn_color(run):
        setup = color_setup(config, run)
        learn_appearance(setup, mesh, grey_light(), Progress(run))
        return setup.training.module(mesh.verts).kd

    first = MaterialNet(config, torch.Generator().manual_seed(0))(mesh.verts).kd.mean(0)
    run = run_in(tmp_path)
    last = learn_color(run)
    middle = linear_to_srgb(torch.tensor(config.kd_range)).mean()
    torch.testing.assert_close(linear_to_srgb(first), middle.expand(3), atol=1e-3, rtol=0)
    assert last.mean(0)[0] - last.mean(0)[1] > 0.05
    assert torch.equal(learn_color(RunFolder.open(run.path)), last)  # no step is left to take
    assert (run.path / "preview" / "color.png").exists()


@pytest.mark.parametrize("at", [0, 2], ids=["early", "refine"])
def test_the_material_s_gradient_does_not_depend_on_how_many_views_are_rendered_at_once(
    tmp_path, at
):
    """With the way to the neighbouring points, which is drawn for each point seen."""
    grads, mesh = [], unwrapped_sphere()
    for at_once in (3, 2, 1):
        config = replace(SHORT_COLOR, views=3, views_at_once=at_once, smooth=1.0)
        setup = color_setup(config, run_in(tmp_path / str(at_once)))
        subject = LitObject(mesh, grey_light(), None)
        grads.append(gradient(appearance_phases(setup, subject)[at], setup, 0))
    assert float(grads[0].norm()) > 0
    torch.testing.assert_close(grads[1], grads[0], rtol=1e-3, atol=1e-6)
    torch.testing.assert_close(grads[2], grads[0], rtol=1e-3, atol=1e-6)


def test_colours_are_refined_at_a_rate_that_falls_once_more(tmp_path):
    """Or the turns of the light leave noise in kd."""
    a = DRAFT.appearance
    setup, subject = (
        color_setup(a, run_in(tmp_path)),
        LitObject(unwrapped_sphere(), grey_light(), None),
    )
    early, late, refine = appearance_phases(setup, subject)
    found = [early.learning_rate(0), late.learning_rate(late.steps - 1)]
    found += [refine.learning_rate(0), refine.learning_rate(refine.steps - 1)]
    full = [a.learning_rate, a.refine.learning_rate]
    expected = [rate * left for rate in full for left in (1.0, a.learning_rate_end)]
    assert found == pytest.approx(expected)
    assert a.learning_rate_end < 1
