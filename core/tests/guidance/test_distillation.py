"""csd and sdi against their formulas, with exact scores; sds has test_sds.py."""

from dataclasses import replace

import pytest
import torch

from core.camera import Cameras
from core.config import preset
from core.errors import UserError
from core.guidance import sds
from core.guidance.gaussian import GaussianGuidance, mixture_eps
from core.guidance.guidance import Predictions, PromptedGuidance, Views
from core.guidance.sds import Method, classifier_score, inverted_noise, sds_grad
from core.io.job import Job
from core.io.run_folder import RunFolder
from core.settings import with_settings
from core.stages.distill import Draw
from core.stages.state import Training
from core.stages.training import Setup
from core.tests.drawn_things import shipped_prior
from core.tests.guidance.test_sds import Normal

T = torch.tensor([40, 500, 950])
WORDS = {"cond": 0.9, "uncond": 0.1, "negative": -0.6}  # means of three normal distributions
STD = 0.5


def random(*shape, seed=0):
    generator = torch.Generator().manual_seed(seed)
    return torch.randn(*shape, generator=generator, dtype=torch.float64)


class Spoken(Normal):
    """Exact scores of three texts: N(mu, s² I) with the means of ``WORDS``.

    ``negative``: whether there is a negative prompt, the third.
    """

    def __init__(self, negative=True):
        super().__init__(0.0, STD)
        self.calls, self.negative = 0, negative

    def prompted(self, *_):
        return PromptedSpoken(self)


class PromptedSpoken(PromptedGuidance):
    def predict(self, z_t, t, views, *, cond_only=False, apart=False):
        self._guidance.calls += 1
        cond, uncond, negative = (
            mixture_eps(z_t, self.alpha_bar[t], torch.full_like(z_t, mu)[None], STD)
            for mu in WORDS.values()
        )
        if not self._guidance.negative:
            return Predictions(cond, uncond)
        # Without ``apart`` the negative prompt takes the unconditional's place.
        if apart:
            return Predictions(cond, uncond, negative=negative)
        return Predictions(cond, negative)


def grad(guidance, z, eps, method, scale=1.0):
    views = Views(Cameras.orbit([0.0] * len(z), [0.0] * len(z)))
    return sds_grad(guidance.prompted(), z, views, T, eps, "sigma2", scale, method=method)


def factors(guidance):
    """alpha_bar, sigma and the diffused data's variance at T."""
    ab = guidance.alpha_bar[T][:, None, None, None]
    return ab, (1 - ab).sqrt(), ab * STD**2 + 1 - ab


def test_csd_is_the_difference_of_two_exact_scores_and_has_no_noise():
    """w σ sqrt(ab) (mu_∅ - mu_y) / (ab s² + σ²), whatever ε is."""
    guidance, z = Spoken(), random(3, 4, 2, 2)
    ab, sigma, variance = factors(guidance)
    expected = sigma**2 * sigma * ab.sqrt() * (WORDS["uncond"] - WORDS["cond"]) / variance
    for seed in (1, 2):
        found = grad(guidance, z, random(*z.shape, seed=seed), Method("csd"))
        torch.testing.assert_close(found, expected.expand_as(z))


def test_csd_s_negative_prompt_counts_as_much_as_its_weight():
    """ε(y) - (1 - ω) ε(∅) - ω ε(neg): the means with the same weights."""
    guidance, z, eps = Spoken(), random(3, 4, 2, 2), random(3, 4, 2, 2, seed=1)
    omega = torch.tensor([0.0, 0.25, 0.5], dtype=torch.float64)
    ab, sigma, variance = factors(guidance)
    w = omega[:, None, None, None]
    away = (1 - w) * WORDS["uncond"] + w * WORDS["negative"] - WORDS["cond"]
    expected = 7.0 * sigma**2 * sigma * ab.sqrt() * away / variance
    found = grad(guidance, z, eps, Method("csd", omega), scale=7.0)
    torch.testing.assert_close(found, expected.expand_as(z))


@pytest.mark.parametrize("omega", [0.0, 1e-6, 0.5, 1.0])
def test_csd_s_weight_is_of_the_negative_prompt_where_all_views_have_the_same(omega):
    """At 0, a phase's first step, the negative prompt does not count."""
    guidance, z, eps = Spoken(), random(3, 4, 2, 2), random(3, 4, 2, 2, seed=1)
    ab, sigma, variance = factors(guidance)
    away = (1 - omega) * WORDS["uncond"] + omega * WORDS["negative"] - WORDS["cond"]
    expected = sigma**2 * sigma * ab.sqrt() * away / variance
    weights = torch.full((3,), omega, dtype=torch.float64)
    found = grad(guidance, z, eps, Method("csd", weights))
    torch.testing.assert_close(found, expected.expand_as(z))


def test_csd_is_what_one_more_of_guidance_adds_to_sds():
    guidance, z, eps = Spoken(negative=False), random(3, 4, 2, 2), random(3, 4, 2, 2, seed=1)
    more, less = (grad(guidance, z, eps, sds.SDS, scale) for scale in (8.0, 7.0))
    torch.testing.assert_close(more - less, grad(guidance, z, eps, Method("csd")))


def test_csd_keeps_perp_neg():
    cond, uncond, other = random(3, 2, 4, 2, 2)
    weight = torch.tensor([[0.5, 0.0]], dtype=torch.float64)
    both = Predictions(cond, uncond, other[None], weight)
    expected = cond - uncond
    expected[0] -= 0.5 * sds.perp_neg(cond - uncond, other - uncond)[0]
    torch.testing.assert_close(classifier_score(both), expected)
    torch.testing.assert_close(classifier_score(both), sds.guided(both, 1.0) - uncond)


def test_csd_without_an_unconditional_prediction_is_nothing():
    assert not classifier_score(Predictions(random(1, 4, 2, 2))).any()


def test_the_inverted_noise_is_the_probability_flow_s():
    """For N(mu, s²) the flow keeps (z_t - sqrt(ab) mu) / sqrt(ab s² + σ²): known in closed form."""
    guidance, z = Normal(0.3, STD), random(3, 4, 2, 2)
    ab, sigma, variance = factors(guidance)
    z_t = ab.sqrt() * 0.3 + variance.sqrt() * (z - 0.3) / STD
    expected = (z_t - ab.sqrt() * z) / sigma
    views = Views(Cameras.orbit([0.0] * 3, [0.0] * 3))
    errors = []
    for steps in (40, 800):  # an Euler method: twenty times the steps, a twentieth of the error
        found = inverted_noise(guidance.prompted(), z, T, views, -1.0, steps)
        errors.append(float((found - expected).abs().max()))
    assert errors[1] < 0.02
    assert errors[1] < errors[0] / 8


def test_sdi_pulls_to_the_mean_as_the_flow_has_it_and_needs_no_noise():
    """w sqrt(ab) (d - sqrt(ab) s) / (d σ) (z - mu) with d² = ab s² + σ²."""
    guidance, z = Normal(0.3, STD), random(3, 4, 2, 2)
    ab, sigma, variance = factors(guidance)
    d = variance.sqrt()
    expected = sigma**2 * ab.sqrt() * (d - ab.sqrt() * STD) / (d * sigma) * (z - 0.3)
    method = Method("sdi", inversion_steps=800)
    found = [grad(guidance, z, random(*z.shape, seed=s), method) for s in (1, 2)]
    assert torch.equal(*found)
    torch.testing.assert_close(found[0], expected, rtol=0.03, atol=0.02)
    at_mean = grad(guidance, torch.full_like(z, 0.3), random(*z.shape), Method("sdi"))
    torch.testing.assert_close(at_mean, torch.zeros_like(z), rtol=0, atol=1e-2)


@pytest.mark.parametrize(("method", "calls"), [("sds", 1), ("csd", 1), ("sdi", 6)])
def test_a_step_asks_the_network_so_often(method, calls):
    guidance, z = Spoken(), random(3, 4, 2, 2)
    grad(guidance, z, random(*z.shape), Method(method, inversion_steps=5), scale=3.0)
    assert guidance.calls == calls


def test_the_inversion_has_minus_the_guidance_s_scale():
    guidance, z, eps = Spoken(), random(3, 4, 2, 2), random(3, 4, 2, 2, seed=1)
    views = Views(Cameras.orbit([0.0] * 3, [0.0] * 3))
    kappa = inverted_noise(guidance.prompted(), z, T, views, -3.0, 4)
    found = grad(guidance, z, eps, Method("sdi", inversion_steps=4), scale=3.0)
    torch.testing.assert_close(found, grad(guidance, z, kappa, sds.SDS, scale=3.0))
    assert float((found - grad(guidance, z, eps, sds.SDS, scale=3.0)).abs().max()) > 0.1


@pytest.mark.parametrize("negative", ["", "striped", "a mug"])
def test_the_built_in_prior_predicts_for_the_negative_prompt_apart(negative):
    guidance = shipped_prior()
    views = Views(Cameras.orbit([30.0], [20.0]))
    z_t = random(1, 4, 64, 64).float()
    t = torch.tensor([600])
    plain = guidance.prompted("a chair", "").predict(z_t, t, views)
    given = guidance.prompted("a chair", negative)
    replaced, apart = given.predict(z_t, t, views), given.predict(z_t, t, views, apart=True)
    torch.testing.assert_close(apart.uncond, plain.uncond, rtol=0, atol=1e-4)
    if negative != "a mug":  # a pattern is nothing that the geometry's network knows
        assert apart.negative is None
        return
    torch.testing.assert_close(apart.negative, replaced.uncond, rtol=0, atol=1e-4)
    assert float((apart.negative - apart.uncond).abs().max()) > 1e-3


def draw(tmp_path, progress, **settings):
    config = with_settings(
        preset("draft"), {f"geometry.coarse.{k}": v for k, v in settings.items()}
    ).geometry
    guidance = GaussianGuidance(lambda cameras: torch.zeros(1, len(cameras), 4, 8, 8), 8)
    module, generator = torch.nn.Linear(1, 1), torch.Generator().manual_seed(0)
    run = RunFolder.create(tmp_path / f"{progress}", Job(prompt="a ball"))
    setup = Setup(Training("geometry", module, generator, run), guidance.prompted(), config)
    return Draw.of(setup, config.coarse, progress)


def test_sdi_s_timestep_falls_and_is_not_drawn(tmp_path):
    options = {"distillation": "sdi", "t_high": "0.9,0.3"}
    assert draw(tmp_path, 0.0, **options).t.unique().tolist() == [900]
    assert draw(tmp_path, 1.0, **options).t.unique().tolist() == [300]
    assert len(draw(tmp_path, 0.5, t_high="0.9,0.3").t.unique()) > 1


def test_csd_s_negative_weight_is_annealed_and_travels_with_its_views(tmp_path):
    options = {"distillation": "csd", "csd_negative": "0.2,0.6"}
    assert draw(tmp_path, 0.0, **options).negative.tolist() == pytest.approx([0.2] * 6)
    late = draw(tmp_path, 0.5, **options)
    parts = [part.negative for part in late.split(4, torch.device("cpu"))]
    assert [len(part) for part in parts] == [4, 2]
    assert torch.cat(parts).tolist() == pytest.approx([0.4] * 6)
    assert draw(tmp_path, 1.0).negative is None


def test_a_method_is_a_setting_of_each_phase():
    settings = {
        "geometry.coarse.distillation": "csd",
        "appearance.late.distillation": "sdi",
        "appearance.late.inversion_steps": "4",
    }
    draft = preset("draft")
    config = with_settings(draft, settings)
    assert config.geometry.coarse.distillation == "csd"
    assert config.geometry.fine == draft.geometry.fine
    late = replace(draft.appearance.late, distillation="sdi", inversion_steps=4)
    assert config.appearance.late == late
    with pytest.raises(UserError, match="Use sds or csd or sdi"):
        with_settings(draft, {"geometry.coarse.distillation": "vsd"})
