"""The shipped networks as a guidance: they know their words and their cameras."""

from collections.abc import Iterator
from unittest import mock

import pytest
import torch

from core.appearance.environment import Environment
from core.camera import Cameras
from core.command_line import job_of, parse
from core.config import DRAFT
from core.errors import MissingError, UserError
from core.generate import prepare
from core.guidance.builtin import guidance as builtin
from core.guidance.builtin import hint as hint_module
from core.guidance.builtin.guidance import (
    GEOMETRY_SLOTS,
    BuiltinGuidance,
    load_builtin,
)
from core.guidance.builtin.hint import CHANNELS, HINT_SLOTS
from core.guidance.builtin.network import UNet
from core.guidance.builtin.nouns.order import ORDER
from core.guidance.builtin.offered import WEIGHTS
from core.guidance.builtin.words.grammar.lexicon import SLOTS
from core.guidance.guidance import Views
from core.guidance.load import make_guidance
from core.guidance.sds import add_noise, predict_eps
from core.io.job import Job
from core.prior import evaluate
from core.prior.data import CAMERAS
from core.prior.draw import Draw
from core.prior.evaluate import score_paint, score_pattern
from core.prior.families import build
from core.prior.tracer import render
from core.prior.velocity import x_from_v
from core.tests.drawn_things import shipped_prior
from core.tests.tiny_runs import remembered


@pytest.fixture(scope="module")
def guidance() -> BuiltinGuidance:
    """The shipped one."""
    return shipped_prior()


@pytest.fixture(scope="module")
def made_once() -> Iterator[None]:
    """The studio's light and the objects of a seed, which take longer than a score."""
    light = classmethod(remembered(Environment.of.__func__))
    objects = mock.patch.object(evaluate, "make", remembered(evaluate.make))
    with mock.patch.object(Environment, "of", light), objects:
        yield


def _surface(noun: str, cameras: Cameras, stated: str = "", adjective: str = "") -> torch.Tensor:
    draw = Draw(torch.Generator().manual_seed(0), stated)
    seen = render(build(noun, adjective, draw), cameras, 64)
    return torch.cat([seen.normal, 2 * seen.coverage - 1, seen.point * seen.coverage], 1)


def _picture(noun: str, cameras: Cameras, stated: str = "", adjective: str = "") -> torch.Tensor:
    return _surface(noun, cameras, stated, adjective)[:, :4]


def _noise(seed: int, count: int = 1) -> torch.Tensor:
    return torch.randn(count, 4, 64, 64, generator=torch.Generator().manual_seed(seed))


def _error(guidance, x, prompt, cameras, t=700, scale=1.0):
    eps = torch.randn(x.shape, generator=torch.Generator().manual_seed(1))
    times = torch.full((len(x),), t)
    z_t = add_noise(x, eps, guidance.alpha_bar[times])
    eps_hat = predict_eps(guidance.prompted(prompt, ""), z_t, times, Views(cameras), scale)
    return (eps_hat - eps).square().mean().item()


def test_the_weights_fit_their_slots_and_the_budget(guidance):
    pairs = ((guidance.geometry, GEOMETRY_SLOTS), (guidance.appearance, HINT_SLOTS[:-1]))
    for net, slots in pairs:
        rows = {"noun": len(ORDER)}
        assert net.config.words == tuple(rows.get(slot, len(SLOTS[slot])) for slot in slots)
        assert all(p.isfinite().all() for p in net.parameters())
    assert guidance.geometry.config.hint == 0
    assert guidance.appearance.config.hint == CHANNELS
    total = sum(path.stat().st_size for path in WEIGHTS.glob("*.safetensors"))
    assert total < 80e6
    assert isinstance(make_guidance("builtin", "cpu"), BuiltinGuidance)


@pytest.mark.parametrize(("noun", "other"), [("chair", "torus"), ("torus", "mug"), ("mug", "cube")])
def test_a_picture_is_denoised_best_under_its_own_word(guidance, noun, other):
    cameras = Cameras.orbit([20.0, 140.0, 250.0], [15.0, 30.0, 5.0])
    x = _picture(noun, cameras)
    right = _error(guidance, x, f"a {noun}", cameras)
    assert right < 0.8 * _error(guidance, x, f"a {other}", cameras)


@pytest.mark.parametrize(
    ("noun", "stated", "right", "wrong"),
    [
        ("mug", "no handle", "a mug without a handle", "a mug with a handle"),
        ("bench", "no backrest", "a bench without a backrest", "a bench with a backrest"),
        ("stool", "one leg", "a stool with one leg", "a stool with four legs"),
    ],
)
def test_a_picture_is_denoised_best_with_its_parts_stated(guidance, noun, stated, right, wrong):
    cameras = Cameras.orbit([20.0, 70.0, 140.0], [15.0, 30.0, 5.0])
    x = _picture(noun, cameras, stated)
    assert _error(guidance, x, right, cameras) < 0.9 * _error(guidance, x, wrong, cameras)


@pytest.mark.parametrize("adjective", ["tall", "flat", "thin"])
def test_a_picture_is_denoised_best_under_its_adjective(guidance, adjective):
    cameras = Cameras.orbit([20.0, 70.0, 140.0], [15.0, 30.0, 5.0])
    x = _picture("house", cameras, adjective=adjective)
    right = _error(guidance, x, f"a {adjective} house", cameras)
    others = {"tall", "flat", "thin"} - {adjective}
    assert all(right < _error(guidance, x, f"a {word} house", cameras) for word in others)


@pytest.mark.parametrize(("noun", "elevation"), [("chair", 15.0), ("mug", 15.0), ("mug", -45.0)])
def test_a_picture_is_denoised_best_at_its_own_camera(guidance, noun, elevation):
    x = _picture(noun, Cameras.orbit([0.0, 90.0], [elevation] * 2))
    right = _error(guidance, x, noun, Cameras.orbit([0.0, 90.0], [elevation] * 2))
    wrong = _error(guidance, x, noun, Cameras.orbit([180.0, 270.0], [elevation] * 2))
    assert right < 0.8 * wrong


@pytest.mark.parametrize("noun", ["mug", "bucket"])
def test_a_bottom_is_known_about_as_well_as_the_rest(guidance, noun):
    """Weights that had seen nothing from below -20° erred twice as much there."""
    errors = []
    for elevation in (-50.0, 30.0):
        cameras = Cameras.orbit([0.0, 90.0, 200.0], [elevation] * 3)
        errors.append(_error(guidance, _picture(noun, cameras), noun, cameras))
    assert errors[0] < 1.5 * errors[1]


@pytest.mark.parametrize("stage", ["geometry", "appearance"])
def test_the_draft_looks_from_where_the_prior_has_seen_things_from_below_too(stage):
    asked = getattr(DRAFT, stage).cameras
    for name in ("elevation_deg", "fovy_deg", "distance"):
        (low, high), (least, most) = getattr(asked, name), getattr(CAMERAS, name)
        assert least <= low <= high <= most
    assert asked.elevation_deg[0] < -40  # a mug has a bottom


def test_the_appearance_network_paints_the_word_onto_the_given_shape(guidance):
    cameras = Cameras.orbit([30.0, 200.0], [20.0, 20.0])
    surface = _surface("mug", cameras)
    inside = surface[:, 3] > 0.9
    t = torch.full((2,), 900)
    alpha_bar = guidance.alpha_bar[t]
    z_t = _noise(2, 2)
    for color, channel in (("red", 0), ("green", 1), ("blue", 2)):
        prompted = guidance.prompted(f"a {color} mug", "")
        eps_hat = predict_eps(prompted, z_t, t, Views(cameras, surface), 1.0)
        a = alpha_bar[:, None, None, None]
        painted = (z_t - (1 - a).sqrt() * eps_hat) / a.sqrt()
        assert (painted[:, 3] > 0)[inside].float().mean() > 0.8  # the coverage is the hint's
        assert painted.permute(0, 2, 3, 1)[inside].mean(0)[:3].argmax() == channel


def test_the_guidance_scale_extrapolates_from_the_negative_prompt(guidance):
    cameras = Cameras.orbit([20.0], [10.0])
    z_t, t = _noise(3), torch.tensor([800])
    chair = guidance.prompted("chair", "mug")
    at = {s: predict_eps(chair, z_t, t, Views(cameras), s) for s in (0.0, 1.0, 3.0)}
    torch.testing.assert_close(at[3.0], at[0.0] + 3 * (at[1.0] - at[0.0]), atol=1e-4, rtol=1e-3)
    mug = predict_eps(guidance.prompted("mug", ""), z_t, t, Views(cameras), 1.0)
    torch.testing.assert_close(at[0.0], mug, atol=1e-4, rtol=1e-3)


def test_eps_hat_is_the_networks_v(guidance, monkeypatch):
    """v read as a picture and the noise give z_t back."""
    cameras = Cameras.orbit([20.0], [10.0])
    z_t, t = _noise(4), torch.tensor([500])
    answers = []
    monkeypatch.setattr(
        guidance.geometry,
        "forward",
        lambda *inputs: (
            answers.append(type(guidance.geometry).forward(guidance.geometry, *inputs))
            or answers[-1]
        ),
    )
    eps_hat = predict_eps(guidance.prompted("cone", ""), z_t, t, Views(cameras), 1.0)
    alpha_bar = guidance.alpha_bar[t]
    x = x_from_v(answers[0][:1].float(), z_t, alpha_bar)
    torch.testing.assert_close(add_noise(x, eps_hat, alpha_bar), z_t, atol=1e-4, rtol=1e-4)


def test_a_render_is_encoded_as_the_training_pictures_are(guidance):
    o = torch.zeros(1, 128, 128, 1)
    o[:, 32:96, 32:96] = 1
    n = o * torch.tensor([0.0, -1.0, 0.0])
    z = guidance.encode_normals(n, o)
    assert z.shape == (1, 4, 64, 64)
    torch.testing.assert_close(z[0, :, 32, 32], torch.tensor([0.0, -1.0, 0.0, 1.0]))
    torch.testing.assert_close(z[0, :, 2, 2], torch.tensor([0.0, 0.0, 0.0, -1.0]))
    srgb = o * torch.tensor([1.0, 0.5, 0.0])
    z = guidance.encode_color(srgb, o)
    torch.testing.assert_close(z[0, :, 32, 32], torch.tensor([1.0, 0.0, -1.0, 1.0]))
    torch.testing.assert_close(z[0, :, 2, 2], torch.tensor([0.0, 0.0, 0.0, -1.0]))


def test_encoding_carries_the_gradient(guidance):
    srgb = torch.rand(1, 96, 96, 3, requires_grad=True)
    guidance.encode_color(srgb, torch.ones(1, 96, 96, 1)).sum().backward()
    assert srgb.grad.abs().min() > 0


def test_unknown_words_are_refused_in_both_prompts(guidance):
    with pytest.raises(UserError, match="'wombat'"):
        guidance.prompted("a wombat", "")
    with pytest.raises(UserError, match="'blurry'"):
        guidance.prompted("a chair", "blurry")


def test_what_was_not_taken_to_the_letter_is_a_warning():
    job = job_of(parse(["generate", "a wombat chiar", "--ignore-unknown-words"]))
    assert Job.from_json(job.to_json()).ignore_unknown_words
    with pytest.raises(UserError, match="ignore_unknown_words is 1"):
        Job(prompt="a chair", ignore_unknown_words=1)
    inputs = prepare(job)
    assert inputs.guidance.words.noun == "chair"
    assert inputs.warnings == (
        "'chiar' is read as 'chair'.",
        "The built-in model does not know 'wombat': left out.",
    )


def test_missing_weights_say_what_to_do(tmp_path, monkeypatch):
    monkeypatch.setattr(builtin, "WEIGHTS", tmp_path)
    with pytest.raises(MissingError, match=r"geometry\.safetensors .* python -m core\.prior train"):
        load_builtin("cpu")
    (tmp_path / "geometry.safetensors").write_bytes(b"nothing")
    with pytest.raises(MissingError, match="broken"):
        load_builtin("cpu")


@pytest.mark.usefixtures("made_once")
@pytest.mark.parametrize("noun", ["chair", "hamburger", "car"])
def test_the_stated_colour_is_seen_in_much_noise(guidance, noun):
    score = score_paint(guidance.appearance, noun, 4, torch.Generator().manual_seed(3))
    assert len(score.delta_e) == 4
    assert max(score.delta_e) < 25
    if noun == "chair":
        blind = UNet(guidance.appearance.config).eval()  # untrained: it knows nothing of colours
        unseen = score_paint(blind, noun, 4, torch.Generator().manual_seed(3))
        assert sum(unseen.delta_e) > 2 * sum(score.delta_e)


@pytest.mark.usefixtures("made_once")
@pytest.mark.parametrize("pattern", ["striped", "spotted", "checkered"])
def test_a_stated_pattern_is_seen_in_much_noise(guidance, pattern, monkeypatch):
    score = score_pattern(guidance.appearance, pattern, 12, torch.Generator().manual_seed(3))
    assert score > 0.35
    monkeypatch.setattr(hint_module, "stencil", lambda s, _: torch.zeros_like(s[:, :1]) > 0)
    even = score_pattern(guidance.appearance, pattern, 12, torch.Generator().manual_seed(3))
    assert even < 0.5 * score
