"""The paper's ablations, each by a setting: what it changes, and that nothing else does."""

import math
from dataclasses import replace

import pytest
import torch

from core.appearance.environment import Environment
from core.appearance.latlong import directions
from core.appearance.material import MaterialNet
from core.appearance.shade import shade
from core.camera import Cameras
from core.config import DRAFT, RefineConfig, preset
from core.geometry.tet_grid import tet_grid
from core.guidance.guidance import MaterialRanges
from core.io.job import Job, read_events
from core.io.progress import Progress
from core.io.run_folder import RunFolder
from core.job_config import config_of, within
from core.ops import normalize
from core.render.antialias import edge_table
from core.settings import with_settings
from core.stages.appearance import LitObject
from core.stages.geometry import Distillation, geometry_phases, learn_geometry
from core.stages.lit_shape import CLAY, LitShape, clay, lit_shape, take_material
from core.stages.state import Training
from core.stages.training import Setup
from core.tests.runs.test_stages import (
    GREY,
    SHORT,
    color_setup,
    guidance,
    setup_of,
    sphere,
    start_net,
    unwrapped_sphere,
)

LOOK = replace(DRAFT.appearance, log2_hash_size=8, finest=32, shading="split_sum")


def seeded(seed=0):
    return torch.Generator().manual_seed(seed)


def run_in(path):
    return RunFolder.create(path, Job(prompt="a ball"))


def sky():
    x, y, z = directions(16, 32).unbind(-1)
    return torch.stack([1 + z, 1 + 0.5 * x, 1 + 0.5 * y], -1)


# ---- diffuse only


def test_diffuse_only_is_the_colour_times_the_irradiance_and_nothing_else():
    """L = kd ∫ L_i cos / π, from every side and at every roughness."""
    normal = normalize(torch.randn(50, 3, generator=seeded()))
    view = normalize(normal + 0.5 * torch.randn(50, 3, generator=seeded(1)))
    one, kd = torch.ones(50, 1), torch.rand(50, 3, generator=seeded(2))
    light = Environment.of(sky(), "diffuse").rotated(1.0)
    expected = kd * light.irradiance(normal)
    for rough, metal in ((0.1, 0.0), (0.9, 1.0)):
        found = shade(normal, view, kd, rough * one, metal * one, light)
        torch.testing.assert_close(found, expected)
    full = shade(normal, view, kd, 0.1 * one, 0 * one, Environment.of(sky(), "split_sum"))
    assert float((full - expected).abs().max()) > 0.02


def test_a_diffuse_asset_is_matte_whatever_the_words_say():
    words = MaterialRanges((0.1, 0.2), (0.9, 1.0))
    matte = within(replace(LOOK, shading="diffuse"), words)
    assert (matte.roughness_range, matte.metallic_range) == ((1.0, 1.0), (0.0, 0.0))
    assert within(LOOK, words).roughness_range == words.roughness


# ---- shaded pictures in place of normals


def test_clay_is_grey_where_the_light_is_white():
    """Under a light of 1 from everywhere a diffuse surface shows its kd, in sRGB."""
    verts, faces = sphere(12)
    lit = LitShape(Environment.of(torch.ones(8, 16, 3), "diffuse"), clay, rotate=True)
    seen = lit.render(verts, faces, Cameras.orbit([30.0], [20.0]), 32, edge_table(faces))
    inside = seen.o[..., 0] > 0.999
    shown = 1.055 * CLAY ** (1 / 2.4) - 0.055
    assert int(inside.sum()) > 100
    torch.testing.assert_close(
        seen.srgb[inside], torch.full((int(inside.sum()), 3), shown), atol=5e-3, rtol=0
    )
    assert not seen.srgb[seen.o[..., 0] == 0].any()


def test_a_shaded_picture_s_gradient_in_the_shape_is_its_slope():
    """Of the brightness under a sky, along a stretch of the ball, against central differences."""
    verts, faces = sphere(10)
    lit = LitShape(Environment.of(sky(), "diffuse"), clay, rotate=False)
    cameras, edges = Cameras.orbit([10.0], [35.0]), edge_table(faces)

    def brightness(stretch):
        moved = verts * torch.cat([torch.ones(2), 1 + stretch[None]])
        return lit.render(moved, faces, cameras, 64, edges).srgb.mean()

    stretch = torch.zeros((), requires_grad=True)
    (slope,) = torch.autograd.grad(brightness(stretch), stretch)
    with torch.no_grad():
        h = torch.tensor(0.02)
        expected = (brightness(h) - brightness(-h)) / (2 * h)
    assert abs(float(expected)) > 1e-3
    assert float(slope) == pytest.approx(float(expected), rel=0.15)


@pytest.mark.parametrize("pictures", ["shaded", "entangled"])
def test_the_coarse_phase_of_shaded_pictures_encodes_colours(tmp_path, pictures):
    """It has neither turned normals nor rays, and the guidance gets the surface to paint on."""
    config = replace(SHORT, pictures=pictures, ray_mask_share=1.0)
    setup = setup_of(config, guidance("camera"), run_in(tmp_path))
    net = setup.training.module
    lit = lit_shape(net, config, LOOK, GREY, seeded())
    grid = tet_grid(12)
    phase = Distillation(setup, grid, "coarse", 0, lit)
    assert phase.sharpness(0) == 0.0
    drawn = phase.draw(0)
    assert drawn.rotations is None
    assert drawn.ray_shift is None
    scene, _ = phase.begin(0)
    z, views = scene.latents(Cameras.orbit([0.0], [0.0]), 32)
    assert views.surface is not None
    assert not views.surface.requires_grad
    plain, _ = Distillation(setup, grid, "coarse", 0).begin(0)
    assert plain.latents(Cameras.orbit([0.0], [0.0]), 32)[1].surface is None
    assert z.requires_grad


def entangled_setup(path, seed=5):
    config = replace(SHORT, pictures="entangled", grow=RefineConfig(), refine=RefineConfig())
    net = start_net(config)
    lit = lit_shape(net, config, LOOK, GREY, seeded(1))
    training = Training("geometry", net, seeded(seed), run_in(path))
    return Setup(training, guidance(), config), lit


def test_entangled_learning_moves_shape_and_material_by_one_loss(tmp_path):
    setup, lit = entangled_setup(tmp_path)
    net = setup.training.module
    scene, losses = geometry_phases(setup, tet_grid(12), tet_grid(16), lit)[0].begin(0)
    scene.backward(losses)
    for part in (net.mlp[-1].weight, net.material.layers[-1].weight):
        assert float(part.grad.norm()) > 0


def test_the_material_that_was_learned_with_the_shape_is_the_asset_s(tmp_path):
    setup, lit = entangled_setup(tmp_path)
    learn_geometry(setup, Progress(setup.training.run), lit)
    own = MaterialNet(LOOK, seeded(7))
    points = torch.rand(20, 3, generator=seeded(3)) - 0.5
    with torch.no_grad():
        before = own(points).kd
        take_material(own, setup.training.run)
        torch.testing.assert_close(own(points).kd, setup.training.module.material(points).kd)
        assert float((own(points).kd - before).abs().max()) > 1e-3
    last = [e for e in read_events(setup.training.run.path) if e["type"] == "progress"][-1]
    assert 0.01 < last["coverage"] < 1  # of the surface, for those who watch the run


def test_entangled_has_no_appearance_phases_but_a_texture_has():
    settings = {"geometry.pictures": "entangled"}
    look = config_of(Job(prompt="a mug", settings=settings)).appearance
    assert look.early.steps == look.late.steps == look.refine.rounds == 0
    texture = Job(prompt="a mug", command="texture", mesh="x.obj", settings=settings)
    usual = config_of(Job(prompt="a mug")).appearance
    assert config_of(texture).appearance == usual
    shaded = config_of(Job(prompt="a mug", settings={"geometry.pictures": "shaded"}))
    assert shaded.appearance == usual
    assert usual.early.steps > 0 < usual.refine.rounds


# ---- no rotations, no coarse phase, fixed light


@pytest.mark.parametrize(("rotate", "frame"), [(True, "camera"), (False, "camera")])
def test_rotations_can_be_left_out(tmp_path, rotate, frame):
    config = replace(SHORT, rotate_normals=rotate)
    setup = setup_of(config, guidance(frame), run_in(tmp_path))
    drawn = Distillation(setup, tet_grid(12), "coarse", before=0).draw(0)
    assert (drawn.rotations is not None) == rotate


def test_the_coarse_phase_can_be_left_out(tmp_path):
    """The fine one then begins at the full rate, from the ellipsoid."""
    config = with_settings(preset("sds"), {"geometry.coarse.steps": "0"}).geometry
    setup = setup_of(replace(config, resolution=(12, 16)), guidance(), run_in(tmp_path))
    phases = geometry_phases(setup, tet_grid(12), tet_grid(16))
    assert [phase.steps for phase in phases] == [0, 0, 100, 0]
    assert phases[2].learning_rate(0) == config.learning_rate


@pytest.mark.parametrize("rotate", [True, False])
def test_the_light_turns_between_steps_or_is_fixed(tmp_path, rotate):
    config = replace(LOOK, rotate_light=rotate)
    setup = color_setup(config, run_in(tmp_path))
    subject = LitObject(unwrapped_sphere(), Environment.of(sky(), "split_sum"), None)
    up = torch.tensor([[1.0, 0.0, 0.0]])
    seen = {round(float(subject.scene(setup).lit.irradiance(up)[0, 1]), 6) for _ in range(4)}
    assert len(seen) == (4 if rotate else 1)


@pytest.mark.parametrize("rotate", [True, False])
def test_the_shape_s_light_turns_too(rotate):
    lit = LitShape(Environment.of(sky(), "diffuse"), clay, rotate)
    turned = lit.turned(seeded())
    turn = 2 * math.pi * float(torch.rand(1, generator=seeded()))
    x = torch.tensor([[1.0, 0.0, 0.0]])
    expected = lit.light.rotated(turn if rotate else 0.0).irradiance(x)
    torch.testing.assert_close(turned.light.irradiance(x), expected)
