"""DDIM against what is known of it: with the exact score it ends at the mean, or on a picture."""

import pytest
import torch

from core.camera import Cameras
from core.guidance.denoise import denoise
from core.guidance.gaussian import GaussianGuidance, PromptedGaussian
from core.guidance.guidance import Views
from core.guidance.sds import add_noise

VIEWS = Views(Cameras.orbit([0.0, 120.0], [10.0, 20.0]))


def known(std: float, *means: float) -> PromptedGaussian:
    """Pictures of one grey each, with a Gaussian of ``std`` about it."""
    mu = torch.tensor(means)[:, None, None, None, None].expand(len(means), 2, 4, 8, 8)
    return GaussianGuidance(lambda cameras: mu[:, : len(cameras)], 8, std=std).prompted()


def noisy(guidance: PromptedGaussian, z: torch.Tensor, t: int) -> torch.Tensor:
    eps = torch.randn(z.shape, generator=torch.Generator().manual_seed(0))
    return add_noise(z, eps, guidance.alpha_bar[t].expand(len(z)))


@pytest.mark.parametrize("steps", [1, 4])
def test_where_all_pictures_are_one_it_is_found(steps):
    guidance = known(1e-4, 0.3)
    z_t = noisy(guidance, torch.zeros(2, 4, 8, 8), 900)
    clean = denoise(guidance, z_t, 900, VIEWS, 1.0, steps)
    torch.testing.assert_close(clean, torch.full_like(clean, 0.3), atol=1e-3, rtol=0)


def test_one_step_gives_the_mean_of_what_the_noise_may_hide():
    """E[z | z_t] of N(mu, std²): mu + sqrt(ab) std² (z_t - sqrt(ab) mu) / (ab std² + sigma²)."""
    guidance, t = known(0.5, 0.3), 600
    z_t, ab = noisy(guidance, torch.zeros(2, 4, 8, 8), 600), guidance.alpha_bar[600]
    gain = ab.sqrt() * 0.25 / (ab * 0.25 + 1 - ab)
    expected = 0.3 + gain * (z_t - ab.sqrt() * 0.3)
    clean = denoise(guidance, z_t, t, VIEWS, 1.0, 1)
    torch.testing.assert_close(clean, expected, atol=1e-5, rtol=0)


def test_many_steps_carry_a_gaussian_onto_a_gaussian():
    """The probability flow keeps each value's rank: (z - mu) / std of the end is z_t's own."""
    guidance, t = known(0.5, 0.3), 900
    z_t, ab = noisy(guidance, torch.zeros(2, 4, 8, 8), 900), guidance.alpha_bar[900]
    rank = (z_t - ab.sqrt() * 0.3) / (ab * 0.25 + 1 - ab).sqrt()
    clean = denoise(guidance, z_t, t, VIEWS, 1.0, 200)
    torch.testing.assert_close((clean - 0.3) / 0.5, rank, atol=0.03, rtol=0.03)


def test_of_two_pictures_it_takes_the_nearer_one():
    guidance = known(0.05, -0.5, 0.5)
    for near in (-0.5, 0.5):
        z_t = noisy(guidance, torch.full((2, 4, 8, 8), near), 500)
        clean = denoise(guidance, z_t, 500, VIEWS, 1.0, 6)
        torch.testing.assert_close(clean, torch.full_like(clean, near), atol=0.15, rtol=0)
