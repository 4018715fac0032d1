import pytest
import torch

from core.camera import Cameras
from core.errors import UserError
from core.guidance import sds
from core.guidance.guidance import Guidance, Predictions, PromptedGuidance, Views, coarse_latent


def generator(seed=0):
    return torch.Generator().manual_seed(seed)


class Normal(Guidance):
    """The exact noise prediction for data N(mu, s^2 I): a guidance with a known answer."""

    normal_frame = "camera"
    latent_size = 1

    def __init__(self, mu, s, steps=1000):
        self.mu, self.s = mu, s
        self.alpha_bar = torch.linspace(0.999, 0.01, steps, dtype=torch.float64)

    def prompted(self, *_):
        return PromptedNormal(self)

    def encode_normals(self, n, o):
        raise NotImplementedError

    encode_color = encode_normals


class PromptedNormal(PromptedGuidance):
    def predict(self, z_t, t, views, *, cond_only=False, apart=False):
        normal = self._guidance
        ab = self.alpha_bar[t][:, None, None, None]
        sigma = (1 - ab).sqrt()
        return Predictions(sigma * (z_t - ab.sqrt() * normal.mu) / (ab * normal.s**2 + 1 - ab))


def views(n):
    return Views(Cameras.orbit([0.0] * n, [0.0] * n))


def latents(n, value, h=1):
    return torch.full((n, 4, h, h), value, dtype=torch.float64)


def grad_of(guidance, z, t, eps, **options):
    options = {"weighting": "sigma2", "guidance_scale": 1.0, **options}
    return sds.sds_grad(guidance.prompted(), z, views(len(z)), t=t, eps=eps, **options)


@pytest.mark.parametrize("magnitude", [1.0, 1e4])
def test_loss_gradient_is_grad_to_the_last_bit(magnitude):
    z = (magnitude * torch.randn(2, 4, 8, 8, generator=generator())).requires_grad_()
    grad = 1e-3 * torch.randn(2, 4, 8, 8, generator=generator(1))
    loss = sds.sds_loss(z, grad)
    loss.backward()
    assert torch.equal(z.grad, grad)
    torch.testing.assert_close(loss.detach(), 0.5 * (grad**2).sum())


def test_add_noise_preserves_the_variance_of_unit_data():
    z, eps = torch.randn(2, 50_000, 4, 1, 1, generator=generator(), dtype=torch.float64)
    z_t = sds.add_noise(z, eps, torch.full((50_000,), 0.3, dtype=torch.float64))
    stderr = (2 / z_t.numel()) ** 0.5  # of a normal's variance
    assert abs(z_t.var() - 1) < 4 * stderr


def test_v_prediction_names_the_noise_that_was_added():
    z, eps = torch.randn(2, 5, 4, 3, 3, generator=generator(), dtype=torch.float64)
    ab = torch.linspace(0.01, 0.99, 5, dtype=torch.float64)
    a, s = ab.sqrt()[:, None, None, None], (1 - ab).sqrt()[:, None, None, None]
    v = a * eps - s * z
    torch.testing.assert_close(sds.eps_from_v(v, sds.add_noise(z, eps, ab), ab), eps)


@pytest.mark.parametrize(
    ("kind", "expected"),
    [
        ("sigma2", [0.36, 0.5, 0.64]),
        ("sigma2_sqrt", [0.36 * 0.8, 0.5**1.5, 0.64 * 0.6]),
        ("inv_sigma2", [25 / 9, 2.0, 25 / 16]),
    ],
)
def test_weight_by_hand(kind, expected):
    alpha_bar = torch.tensor([0.64, 0.5, 0.36], dtype=torch.float64)
    torch.testing.assert_close(
        sds.weight(alpha_bar, kind), torch.tensor(expected, dtype=torch.float64)
    )


@pytest.mark.parametrize("kind", ["sigma2", "sigma2_sqrt", "inv_sigma2"])
@pytest.mark.parametrize("step", [20, 500, 980])
def test_mean_gradient_is_the_closed_form_of_a_normal(kind, step):
    """E_eps[w (eps_hat - eps)] = w sigma sqrt(ab) (z - mu) / (ab s^2 + sigma^2)."""
    n, value, guidance = 100_000, 1.1, Normal(mu=0.3, s=0.5)
    t = torch.full((n,), step)
    eps = torch.randn(n, 4, 1, 1, generator=generator(step), dtype=torch.float64)
    grad = grad_of(guidance, latents(n, value), t, eps, weighting=kind)
    ab = guidance.alpha_bar[step]
    w = {"sigma2": 1 - ab, "sigma2_sqrt": (1 - ab) * ab**0.5, "inv_sigma2": 1 / (1 - ab)}[kind]
    expected = w * ((1 - ab) * ab).sqrt() * (value - guidance.mu)
    expected = expected / (ab * guidance.s**2 + 1 - ab)
    stderr = grad.std() / grad.numel() ** 0.5
    assert abs(grad.mean() - expected) < 4 * stderr
    assert abs(expected) > 20 * stderr  # the statistics can tell it from zero


def test_one_known_picture_gives_a_gradient_without_noise():
    """s = 0: the denoiser knows z's target, so w (eps_hat - eps) = w sqrt(ab) / sigma (z - mu)."""
    guidance, t = Normal(mu=0.3, s=0.0), torch.tensor([100, 900])
    eps = torch.randn(2, 4, 3, 3, generator=generator(), dtype=torch.float64)
    grad = grad_of(guidance, latents(2, 1.1, 3), t, eps)
    ab = guidance.alpha_bar[t][:, None, None, None]
    expected = ((1 - ab) * ab).sqrt() * (1.1 - 0.3)
    torch.testing.assert_close(grad, expected.expand_as(grad))


def test_the_gradient_does_not_reach_through_the_guidance():
    z = latents(1, 1.0).requires_grad_()
    grad = grad_of(Normal(0.0, 1.0), z, torch.tensor([5]), torch.zeros_like(z))
    assert not grad.requires_grad


def test_guidance_scale_runs_from_unconditional_through_conditional_outwards():
    c, u = torch.randn(2, 1, 4, 2, 2, generator=generator(), dtype=torch.float64)
    torch.testing.assert_close(sds.guide(c, u, 0.0), u)
    torch.testing.assert_close(sds.guide(c, u, 1.0), c)
    torch.testing.assert_close(sds.guide(c, u, 7.5), c + 6.5 * (c - u))


def test_predictions_are_combined_as_far_as_they_are_there():
    """Alone; with an unconditional one; with Perp-Neg, whose part along the prompt does nothing."""
    c, u, v = torch.randn(3, 2, 4, 2, 2, generator=generator(), dtype=torch.float64)
    assert torch.equal(sds.guided(Predictions(c), 7.5), c)
    assert torch.equal(sds.guided(Predictions(c, u), 7.5), sds.guide(c, u, 7.5))
    weights = torch.tensor([[0.5, 0.0]], dtype=torch.float64)
    found = sds.guided(Predictions(c, u, v[None], weights), 7.5)
    expected = sds.guide(c, u, 7.5)
    expected[0] -= 7.5 * 0.5 * sds.perp_neg(c - u, v - u)[0]
    torch.testing.assert_close(found, expected)
    along = u + 0.3 * (c - u)
    found = sds.guided(Predictions(c, u, along[None], weights), 7.5)
    torch.testing.assert_close(found, sds.guide(c, u, 7.5))


def test_perp_neg_is_perpendicular_and_removes_nothing_else():
    d, n = torch.randn(2, 3, 4, 5, 5, generator=generator(), dtype=torch.float64)
    d[2] = 0
    perp = sds.perp_neg(d, n)
    torch.testing.assert_close((perp * d).sum((1, 2, 3)), torch.zeros(3, dtype=torch.float64))
    torch.testing.assert_close(perp[2], n[2])  # nothing to be perpendicular to
    rest = n - perp
    cosine = torch.nn.functional.cosine_similarity(rest[:2].flatten(1), d[:2].flatten(1))
    torch.testing.assert_close(cosine.abs(), torch.ones(2, dtype=torch.float64))


def test_capped_views_have_the_cap_and_the_others_are_untouched():
    grad = (
        torch.randn(3, 4, 8, 8, generator=generator())
        * torch.tensor([9, 0.01, 0])[:, None, None, None]
    )
    capped = sds.cap_rms(grad, 0.1)
    torch.testing.assert_close(capped[0].square().mean().sqrt(), torch.tensor(0.1))
    torch.testing.assert_close(
        torch.cosine_similarity(capped[0].flatten(), grad[0].flatten(), 0), torch.tensor(1.0)
    )
    assert torch.equal(capped[1:], grad[1:])


def test_a_split_batch_gives_the_whole_batch():
    guidance, t = Normal(0.3, 0.5), torch.tensor([20, 300, 700, 980])
    z, eps = torch.randn(2, 4, 4, 3, 3, generator=generator(), dtype=torch.float64)
    whole = grad_of(guidance, z, t, eps, cap=0.1)
    parts = [grad_of(guidance, z[i], t[i], eps[i], cap=0.1) for i in (slice(0, 1), slice(1, 4))]
    torch.testing.assert_close(whole, torch.cat(parts))


def test_timesteps_are_uniform_over_their_bounds_and_repeat_with_the_seed():
    t = sds.sample_t(20_000, 0.02, 0.5, 1000, generator())
    assert t.min() == 20
    assert t.max() == 500
    spread = (481**2 - 1) / 12  # of a discrete uniform on 481 numbers
    assert abs(t.double().mean() - 260) < 4 * (spread / len(t)) ** 0.5
    assert torch.equal(t, sds.sample_t(20_000, 0.02, 0.5, 1000, generator()))
    assert sds.sample_t(50, 1.0, 1.0, 1000, generator()).unique().tolist() == [999]


@pytest.mark.parametrize("bounds", [(0.6, 0.2), (-0.1, 0.5), (1.1, 1.2)])
def test_an_empty_range_of_timesteps_is_refused(bounds):
    with pytest.raises(UserError, match="empty range"):
        sds.sample_t(4, *bounds, 1000, generator())


def test_annealing_is_linear_and_stops_at_its_ends():
    assert [sds.anneal(0.98, 0.5, p) for p in (-1.0, 0.0, 0.5, 1.0, 2.0)] == pytest.approx(
        [0.98, 0.98, 0.74, 0.5, 0.5]
    )


@pytest.mark.parametrize("bad", [float("nan"), float("inf")])
def test_what_is_not_finite_is_named_with_its_side_and_timestep(bad):
    z = latents(3, 1.0)
    t, eps = torch.tensor([1, 2, 3]), torch.zeros_like(z)
    broken = Normal(mu=torch.tensor([0, bad, 0], dtype=torch.float64)[:, None, None, None], s=1.0)
    with pytest.raises(sds.NotFiniteError, match=r"guidance's.*1 of 3 views \(t = \[2\]\)"):
        grad_of(broken, z, t, eps)
    z[0, 0] = bad
    with pytest.raises(sds.NotFiniteError, match=r"picture.*1 of 3 views \(t = \[1\]\)"):
        grad_of(Normal(0.0, 1.0), z, t, eps)


def test_coarse_latent_is_the_area_mean_with_the_mask_in_a_normals_range():
    n = torch.randn(2, 8, 8, 3, generator=generator())
    o = torch.rand(2, 8, 8, 1, generator=generator())
    z = coarse_latent(n, o, 4)
    cell = (slice(None), slice(2, 4), slice(6, 8))  # row 1, column 3
    torch.testing.assert_close(z[:, :3, 1, 3], n[cell].mean((1, 2)))
    torch.testing.assert_close(z[:, 3, 1, 3], 2 * o[cell].mean((1, 2))[:, 0] - 1)


def test_coarse_latent_of_nothing_is_the_empty_mask():
    z = coarse_latent(torch.zeros(1, 64, 64, 3), torch.zeros(1, 64, 64, 1), 32)
    assert torch.equal(z[:, :3], torch.zeros(1, 3, 32, 32))
    assert torch.equal(z[:, 3], -torch.ones(1, 32, 32))


def test_shapes_are_checked():
    """Meta-test: the type checker is on, so a wrong shape fails here, not in a user's run."""
    with pytest.raises(Exception, match="alpha_bar"):
        sds.add_noise(torch.zeros(2, 4, 8, 8), torch.zeros(2, 4, 8, 8), torch.zeros(3))
