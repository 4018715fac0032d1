"""Softening, the restorer's start, its batches and its loss; and that refining uses it."""

import math
import shutil
from dataclasses import replace
from functools import partial

import pytest
import torch

from core.camera import Cameras
from core.config import RefineConfig
from core.guidance.builtin.diffusion import alpha_bar_schedule
from core.guidance.builtin.guidance import BuiltinGuidance
from core.guidance.builtin.network import UNet, UNetConfig, camera_map
from core.guidance.builtin.restore import TIME, as_render, restored
from core.guidance.builtin.weights import load_weights, save_weights
from core.guidance.gaussian import GaussianGuidance, mesh_reference
from core.guidance.guidance import Guidance, Predictions, PromptedGuidance, Views
from core.prior.data import ADJECTIVES, NOUNS, PART_STATES, write_shard
from core.prior.draw import Draw
from core.prior.families import build
from core.prior.restorer import KNEE, Restoring, restoring_loss
from core.prior.restorer_score import mean_angle, score_restoring
from core.prior.soft_pairs import make_pairs, write_pairs
from core.prior.soften import (
    Softness,
    blur2,
    blur3,
    draw_softness,
    noise_field,
    soft_pictures,
    soft_shape,
)
from core.prior.tracer import render
from core.prior.train import TrainConfig, Training
from core.stages.refine import cleaned

WORDS = (len(NOUNS), len(ADJECTIVES) - 1, len(PART_STATES) - 1)
TINY = UNetConfig(words=WORDS, widths=(8, 8, 16, 16), code=16)
EXACT = Softness(blur=1e-4, shift=0.0, dents=(), warp=0.0)


def _generator(seed: int = 0) -> torch.Generator:
    return torch.Generator().manual_seed(seed)


def _views(noun: str = "house", count: int = 2) -> torch.Tensor:
    cameras = Cameras.orbit([20.0, 140.0, 250.0][:count], [25.0, -10.0, 5.0][:count])
    seen = render(build(noun, "", Draw(_generator())), cameras)
    return torch.cat([seen.normal, 2 * seen.coverage - 1], 1)


def _inputs(count: int = 2):
    words = torch.zeros(count, len(WORDS), dtype=torch.long)
    return words, camera_map(Cameras.orbit([0.0] * count, [0.0] * count), 32)


def _with_stem(net: UNet) -> UNet:
    wider = UNet(replace(net.config, stem=8))
    missing, unexpected = wider.load_state_dict(net.state_dict(), strict=False)
    assert not unexpected
    assert all(name.startswith("stem.") for name in missing)
    return wider


def test_a_new_stem_changes_nothing():
    torch.manual_seed(0)
    net = UNet(TINY)
    z, t = torch.randn(2, 4, 64, 64), torch.tensor([10, 700])
    words, camera = _inputs()
    torch.testing.assert_close(_with_stem(net)(z, t, words, camera), net(z, t, words, camera))


def test_a_stem_sees_single_pixels():
    """Two pictures that differ within a block differ in the output within that block."""
    torch.manual_seed(0)
    net = _with_stem(UNet(TINY))
    for p in net.stem.exit.parameters():
        torch.nn.init.normal_(p, std=0.1)
    z, t = torch.zeros(1, 4, 64, 64), torch.tensor([TIME])
    z[0, 0, 30, 30] = 1.0
    words, camera = _inputs(1)
    base = net(torch.zeros_like(z), t, words, camera)
    fine = (net(z, t, words, camera) - base)[0, :, 30:32, 30:32]
    assert fine.flatten(1).std(1).min() > 1e-4


def test_old_weights_start_a_network_with_a_stem(tmp_path):
    old, new = (
        Training(partial(UNet, TINY), TrainConfig()),
        Training(partial(UNet, replace(TINY, stem=8)), TrainConfig(seed=1)),
    )
    save_weights(tmp_path / "old.safetensors", TINY, old.averaged())
    new.start_from(tmp_path / "old.safetensors")
    z, t = torch.randn(1, 4, 64, 64, generator=_generator()), torch.tensor([300])
    words, camera = _inputs(1)
    away = new.net(z, t, words, camera) - old.net(z, t, words, camera)
    assert away.abs().max() < 5e-3  # half precision
    assert new.net.stem.enter.weight.abs().min() > 0  # it can learn


def test_weights_with_a_stem_load_again(tmp_path):
    config = replace(TINY, stem=8)
    net = UNet(config)
    save_weights(tmp_path / "net.safetensors", config, dict(net.named_parameters()))
    assert load_weights(tmp_path / "net.safetensors").config == config


def test_restoring_without_a_correction_is_the_identity_but_for_its_scale():
    net = UNet(TINY)
    for p in net.exit.parameters():
        torch.nn.init.zeros_(p)
    x = _views()
    out = restored(net, x, *_inputs())
    torch.testing.assert_close(out, x * alpha_bar_schedule()[TIME].sqrt())
    assert alpha_bar_schedule()[TIME].sqrt() == pytest.approx(0.988, abs=1e-3)


def test_as_render_gives_normals_as_long_as_the_coverage():
    x = torch.randn(2, 4, 8, 8, generator=_generator())
    out = as_render(x)
    coverage = (out[:, 3] + 1) / 2
    assert coverage.min() >= 0
    assert coverage.max() <= 1
    torch.testing.assert_close(out[:, :3].norm(dim=1), coverage)
    torch.testing.assert_close(as_render(out), out)


def test_blur_keeps_a_constant_and_widens_an_impulse_by_its_variance():
    assert torch.allclose(blur2(torch.full((2, 3, 16, 16), 0.7), torch.tensor([0.5, 3.0])),
                          torch.tensor(0.7))  # fmt: skip
    x = torch.zeros(1, 1, 33, 33)
    x[0, 0, 16, 16] = 1
    row = blur2(x, torch.tensor([2.0]))[0, 0].sum(0)
    at = torch.arange(33) - 16.0
    assert row.sum().item() == pytest.approx(1)
    assert (row * at**2).sum().item() == pytest.approx(4, rel=0.08)  # cut at 2.5 sigma
    solid = torch.zeros(1, 1, 17, 17, 17)
    solid[0, 0, 8, 8, 8] = 1
    for axis in ((0, 1), (0, 2), (1, 2)):
        line = blur3(solid, 1.5)[0, 0].sum(axis)
        assert (line * (torch.arange(17) - 8.0) ** 2).sum().item() == pytest.approx(2.25, rel=0.1)


def test_noise_varies_over_its_nodes_distance_and_has_unit_variance():
    """Random values blurred: their differences shrink with the distance over that of nodes."""
    fine, coarse = (noise_field(1, nodes, 40, _generator()) for nodes in (20, 6))
    assert fine.std().item() == coarse.std().item() == pytest.approx(1)
    assert fine.diff(dim=-1).std() > 2 * coarse.diff(dim=-1).std()


def test_pictures_without_softening_are_unchanged():
    x = _views()
    assert torch.equal(soft_pictures(x, torch.zeros(2), _generator()), x)


def test_softer_pictures_are_further_from_the_truth_and_still_renders():
    x = _views(count=3)
    soft = [soft_pictures(x, torch.full((3,), s), _generator()) for s in (0.1, 0.4, 1.0)]
    angles = [mean_angle(y, x) for y in soft]
    assert 0 < angles[0] < angles[1] < angles[2] < 40
    for y in soft:
        coverage = (y[:, 3] + 1) / 2
        assert coverage.min() > -1e-4
        assert coverage.max() < 1 + 1e-4
        assert (y[:, :3].norm(dim=1) <= coverage + 0.08).all()


def test_an_unsoftened_solid_keeps_its_distances_and_its_picture():
    shape = build("ball", "", Draw(_generator()), jitter=0.0)
    lattice = soft_shape(shape.sdf, EXACT, _generator())
    points = torch.rand(500, 3, generator=_generator()) * 2 - 1
    away = lattice.sdf(points) / 0.75 - shape.sdf(points)
    assert away.abs().max() < 0.02  # a node distance squared over the radius, and its centre's kink
    cameras = Cameras.orbit([0.0], [10.0])
    true, soft = (render(s, cameras) for s in (shape, lattice))
    as_picture = lambda seen: torch.cat([seen.normal, 2 * seen.coverage - 1], 1)  # noqa: E731
    assert mean_angle(as_picture(soft), as_picture(true)) < 2


def test_blur_makes_a_thin_plate_vanish_and_keeps_a_thick_one():
    def plate(half):
        return lambda points: points[..., 2].abs() - half

    soft = replace(EXACT, blur=0.06)
    origin = torch.zeros(1, 3)
    # E|x| of a normal deviate is 0.8 sigma: a plate is gone when its half is less.
    assert soft_shape(plate(0.03), soft, _generator()).sdf(origin) > 0
    assert soft_shape(plate(0.08), soft, _generator()).sdf(origin) < 0


def test_a_shift_moves_the_surface_inwards():
    shape = build("ball", "", Draw(_generator()), jitter=0.0)
    on_surface = torch.tensor([[0.9, 0.0, 0.0]])
    moved = soft_shape(shape.sdf, replace(EXACT, shift=0.03), _generator()).sdf(on_surface) / 0.75
    assert moved.item() == pytest.approx(0.03, abs=0.005)


def test_softness_reaches_from_mild_to_strong():
    drawn = [draw_softness(Draw(_generator(k))) for k in range(200)]
    blurs = sorted(s.blur for s in drawn)
    assert blurs[0] < 0.008
    assert 0.09 < blurs[-1] < 0.117


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """Pictures."""
    path = tmp_path_factory.mktemp("data")
    write_shard(path, 3, objects=6)
    return path


@pytest.fixture(scope="module")
def with_pairs(folder, tmp_path_factory):
    """And pictures of soft solids."""
    path = shutil.copytree(folder, tmp_path_factory.mktemp("pairs") / "data")
    write_pairs(path, 0, objects=2)
    return path


@pytest.fixture(scope="module")
def with_close_ups(with_pairs, tmp_path_factory):
    """And close-ups of them."""
    path = shutil.copytree(with_pairs, tmp_path_factory.mktemp("close") / "data")
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("core.prior.soft_pairs.VIEWS", 2)
        write_pairs(path, 3, objects=2, close=True)
    return path


def come(new, path):
    """What is in ``new`` comes into the folder of a source that is at work."""
    shutil.copytree(new, path, dirs_exist_ok=True)


def test_batches_are_pictures_to_be_softened(folder):
    x, words, camera, soft = Restoring(folder).batch(10, _generator())
    assert x.shape == (10, 4, 64, 64)
    assert soft.shape == (0, 4, 64, 64)
    assert words.shape == (10, 3)
    assert camera.shape == (10, 6, 32, 32)


def test_soft_solids_join_the_batches_when_they_come(folder, with_pairs, tmp_path):
    source = Restoring(shutil.copytree(folder, tmp_path / "data"))
    assert source.pairs is None
    come(with_pairs, tmp_path / "data")
    source.rescan()
    x, _, _, soft = source.batch(10, _generator())
    assert len(source.pairs) == 8
    assert (len(x), len(soft)) == (10, 4)
    assert 0 < mean_angle(soft, x[6:]) < 45


def test_close_ups_are_half_of_each_batch_once_there_are_any(with_pairs, with_close_ups, tmp_path):
    source = Restoring(shutil.copytree(with_pairs, tmp_path / "data"))
    assert source.close is None
    come(with_close_ups, tmp_path / "data")
    source.rescan()
    pictures, words, camera, soft = source.batch(8, _generator())
    assert len(pictures) == len(words) == len(camera) == 8
    assert soft.shape[1:] == (4, 64, 64)
    close = source.close
    assert close is not None and len(close) == 4
    known = close.samples.pictures()
    found = [any(torch.equal(picture, one) for one in known) for picture in pictures]
    assert sum(found) == 4
    given = [any(torch.equal(one, soft_one) for one in close.soft_pictures()) for soft_one in soft]
    assert sum(given) == 2  # the other two are to be softened as pictures
    # Maps of close-ups: their points are nearer to one another than a whole picture's.
    spread = camera[:, :3].flatten(2).std(2).norm(dim=1)
    assert (spread[torch.tensor(found)].max() < spread[~torch.tensor(found)].min()).item()


def test_a_close_up_is_traced_as_the_part_of_a_whole_picture_is():
    shape = build("chair", "", Draw(_generator()))
    whole = Cameras.orbit([30.0], [20.0])
    close = whole.close_up(torch.tensor([[0.25, -0.25]]), torch.tensor([2.0]))
    large, part = render(shape, whole, 128), render(shape, close, 64)
    assert torch.equal(large.coverage[..., 48:112, 48:112], part.coverage)
    torch.testing.assert_close(large.normal[..., 48:112, 48:112], part.normal, atol=1e-3, rtol=0)
    maps = camera_map(whole, 64)[..., 24:56, 24:56]
    torch.testing.assert_close(maps, camera_map(close, 32))


def test_the_same_seed_makes_the_same_pairs():
    one, other = make_pairs(5, 1, ["mug"]), make_pairs(5, 1, ["mug"])
    assert torch.equal(one.soft, other.soft)
    assert (one.samples.noun == NOUNS.index("mug")).all()


def test_the_loss_is_quadratic_below_its_knee_and_linear_above(monkeypatch):
    training = Training(
        partial(UNet, TINY), TrainConfig(batch=2, drop_both=0.0), objective=restoring_loss
    )
    x = _views()

    def loss(error):
        monkeypatch.setattr("core.prior.restorer.restored", lambda net, z, w, c: x + error)
        return restoring_loss(training, (x, *_inputs(), x[:0])).item()

    assert loss(0.0) == pytest.approx(0, abs=1e-7)
    assert loss(0.002) == pytest.approx(0.002**2 / (2 * KNEE), rel=0.01)
    assert loss(0.5) == pytest.approx(0.5 - KNEE, rel=0.01)


def test_training_lowers_the_loss(with_close_ups):
    config = TrainConfig(batch=2, learning_rate=3e-3, warm_up=1, minutes=60)
    training = Training(partial(UNet, replace(TINY, stem=8)), config, objective=restoring_loss)
    source = Restoring(with_close_ups)
    held = source.batch(16, _generator(9))
    before = restoring_loss(training, held).item()
    for _ in range(20):
        training.advance(source)
    assert restoring_loss(training, held).item() < 0.8 * before


def test_angles_are_those_between_the_normals():
    a = torch.zeros(1, 4, 2, 2)
    a[:, 2], a[:, 3] = 1, 1
    b = a.clone()
    b[:, 0], b[:, 2] = math.sin(0.3), math.cos(0.3)
    b[:, 3, 0] = -1  # not covered: not compared
    b[:, :3, 0] = -1
    assert mean_angle(a, b) == pytest.approx(math.degrees(0.3), rel=1e-3)


def test_scores_compare_the_same_fresh_objects():
    torch.manual_seed(0)
    net = UNet(TINY).eval()
    one, other = (score_restoring(net, "mug", 2, seed=7) for _ in range(2))
    assert one == other
    assert one.soft > 0
    assert "of it" in str(one)


def test_a_guidance_without_a_restorer_restores_nothing():
    net = UNet(TINY).eval()
    prompted = BuiltinGuidance(net, net).prompted("house", "")
    assert prompted.restore(_views(), Views(Cameras.orbit([20.0, 140.0], [25.0, -10.0]))) is None


def test_the_restorer_gets_the_words_and_the_cameras():
    net, seen, given = UNet(TINY).eval(), UNet(TINY).eval(), []
    seen.register_forward_pre_hook(lambda module, args: given.extend(args))
    prompted = BuiltinGuidance(net, net, restorer=seen).prompted("tall house", "")
    cameras = Cameras.orbit([20.0, 140.0], [25.0, -10.0])
    out = prompted.restore(_views(), Views(cameras))
    assert out.shape == (2, 4, 64, 64)
    _, t, words, camera = given
    torch.testing.assert_close(camera, camera_map(cameras, 32))
    tall = ADJECTIVES.index("tall")
    assert (t == TIME).all()
    assert words.tolist() == [[NOUNS.index("house") + 1, tall, 0]] * 2


class Recorded(PromptedGuidance):
    """Restores to a constant, and counts how often it is asked to denoise."""

    def __init__(self, guidance: Guidance, constant: float | None) -> None:
        super().__init__(guidance)
        self.constant, self.denoised = constant, 0

    def restore(self, pictures, views):
        return None if self.constant is None else torch.full_like(pictures, self.constant)

    def predict(self, z_t, t, views, *, cond_only=False, apart=False):
        self.denoised += 1
        return Predictions(z_t, z_t)


@pytest.mark.parametrize(
    ("restore", "constant", "denoises"), [(True, 0.5, 0), (True, None, 2), (False, 0.5, 2)]
)
def test_refining_restores_where_it_is_set_and_the_guidance_can(restore, constant, denoises):
    guidance = Recorded(GaussianGuidance(mesh_reference([], 16), 16), constant)
    rounds = RefineConfig(rounds=1, denoise_steps=2, restore=restore)
    z, views = torch.zeros(2, 4, 16, 16), Views(Cameras.orbit([0.0, 90.0], [0.0, 0.0]))
    out = cleaned(z, guidance, views, rounds, 0, generator=_generator())
    assert guidance.denoised == denoises
    assert bool((out == 0.5).all()) == (denoises == 0)
