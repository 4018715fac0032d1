"""Γ: its ranges, its tangent-space normal, the paper's specular term."""

from dataclasses import replace

import pytest
import torch

from core.appearance.material import Material, MaterialNet, specular_color, to_ranges
from core.config import AppearanceConfig, preset
from core.guidance.load import make_guidance
from core.job_config import within
from core.ops import linear_to_srgb, srgb_to_linear

CONFIG = AppearanceConfig(log2_hash_size=10, finest=32)


def test_the_ends_of_the_sigmoids_are_the_ends_of_the_ranges():
    raw = torch.full((1, 8), 40.0)
    for sign, end in ((-1, 0), (1, 1)):
        srgb = to_ranges(sign * raw, replace(CONFIG, kd_curve="srgb"))
        m = to_ranges(sign * raw, CONFIG)
        torch.testing.assert_close(srgb.kd, torch.full((1, 3), CONFIG.kd_range[end]))
        torch.testing.assert_close(m.kd, torch.full((1, 3), CONFIG.kd_range[end]))
        torch.testing.assert_close(m.roughness, torch.full((1, 1), CONFIG.roughness_range[end]))
        torch.testing.assert_close(m.metallic, torch.full((1, 1), CONFIG.metallic_range[end]))


def test_the_normal_is_unit_and_never_points_into_the_surface():
    raw = 5 * torch.randn(500, 8, generator=torch.Generator().manual_seed(0))
    kn = to_ranges(raw, CONFIG).kn
    torch.testing.assert_close(kn.norm(dim=1), torch.ones(500))
    assert float(kn[:, 2].min()) > 0
    flat = to_ranges(raw, replace(CONFIG, bump=0.0)).kn
    torch.testing.assert_close(flat, torch.tensor([[0.0, 0, 1]]).expand(500, 3))


def test_a_seed_gives_the_same_material_and_another_seed_another():
    points = torch.rand(20, 3, generator=torch.Generator().manual_seed(1))
    a, b, c = (
        MaterialNet(CONFIG, torch.Generator().manual_seed(seed)).raw(points) for seed in (1, 1, 2)
    )
    assert torch.equal(a, b)
    assert not torch.equal(a, c)


def test_kd_runs_over_linear_light_as_the_papers_does_or_over_srgb_as_the_drafts():
    middle = torch.zeros(1, 8)
    paper, draft = preset("paper").appearance, preset("draft").appearance
    torch.testing.assert_close(to_ranges(middle, paper).kd, torch.full((1, 3), 0.5))
    of_srgb = srgb_to_linear(linear_to_srgb(torch.tensor(draft.kd_range)).mean())
    torch.testing.assert_close(to_ranges(middle, draft).kd, of_srgb.expand(1, 3))


def test_it_starts_grey_half_rough_and_as_metallic_as_asked():
    config = replace(CONFIG, metallic_start=0.1, kd_curve="srgb")
    m = MaterialNet(config, torch.Generator().manual_seed(0))(torch.zeros(1, 3))
    middle = linear_to_srgb(torch.tensor(CONFIG.kd_range)).mean()  # of what the eye sees
    torch.testing.assert_close(linear_to_srgb(m.kd), middle.expand(1, 3), atol=0.01, rtol=0)
    torch.testing.assert_close(m.roughness, torch.tensor([[0.49]]), atol=0.01, rtol=0)
    torch.testing.assert_close(m.metallic, torch.tensor([[0.1]]), atol=0.01, rtol=0)


@pytest.mark.parametrize(("m", "ks"), [(0.0, 0.04), (1.0, 0.6), (0.5, 0.32)])
def test_the_specular_term_is_the_papers(m, ks):
    material = Material(torch.full((1, 3), 0.6), torch.ones(1, 1), torch.full((1, 1), m),
                        torch.tensor([[0.0, 0, 1]]))  # fmt: skip
    torch.testing.assert_close(specular_color(material), torch.full((1, 3), ks))


def test_the_words_bound_the_material():
    """The built-in prior knows what its words are made of; others leave all open."""
    guidance = make_guidance("builtin", "cpu")
    for prompt, metallic in (
        ("a red wooden chair", (0.0, 0.02)),
        ("a golden mug", (0.98, 1.0)),
        ("a lamp", (0.0, 1.0)),  # its pole is golden by nature
    ):
        bounds = guidance.prompted(prompt, "").ranges()
        assert bounds.metallic == pytest.approx(metallic)
        config = within(CONFIG, bounds)
        assert config.metallic_range == bounds.metallic
        assert 0 < config.roughness_range[0] < config.roughness_range[1] < 1
    rough = guidance.prompted("a rubber ball", "").ranges().roughness
    assert rough[0] > guidance.prompted("a metal ball", "").ranges().roughness[1]
    assert within(CONFIG, None) == CONFIG
