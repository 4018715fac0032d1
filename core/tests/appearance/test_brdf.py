import math

import pytest
import torch
from torch import Tensor

from core.appearance.brdf import (
    Albedo,
    albedo_table,
    brdf,
    directional_albedo,
    fresnel_dielectric,
    ggx_d,
    hammersley,
    lookup_albedo,
    schlick_weight,
    smith_g2,
    smith_lambda,
    visible_normals,
)

ROUGHNESS = torch.tensor([0.2, 0.45, 0.8, 1.0], dtype=torch.float64)[:, None]


def hemisphere(n: int) -> tuple[Tensor, Tensor]:
    """Directions on an even grid of cos and azimuth, and the solid angle of each."""
    cos = (torch.arange(n, dtype=torch.float64) + 0.5) / n
    phi = (torch.arange(2 * n, dtype=torch.float64) + 0.5) * (math.pi / n)
    cos, phi = torch.meshgrid(cos, phi, indexing="ij")
    sin = (1 - cos.square()).sqrt()
    d = torch.stack([sin * phi.cos(), sin * phi.sin(), cos], -1).view(-1, 3)
    return d, torch.full((len(d),), math.pi / n / n, dtype=torch.float64)


def view(cos: float) -> Tensor:
    return torch.tensor([math.sqrt(1 - cos * cos), 0, cos], dtype=torch.float64)


@pytest.mark.parametrize("alpha", [0.05, 0.3, 1.0])
def test_projected_microfacets_cover_the_plane(alpha: float) -> None:
    """∫ D (n·h) dh = 1 (Walter 2007, Eq. 4)."""
    cos = (torch.arange(100000, dtype=torch.float64) + 0.5) / 100000
    d = ggx_d(cos, torch.full_like(cos, alpha))
    assert float(2 * math.pi * (d * cos).mean()) == pytest.approx(1, rel=1e-3)


@pytest.mark.parametrize("cos", [0.1, 0.5, 0.95])
def test_visible_microfacets_cover_the_view(cos: float) -> None:
    """∫ G1 D (v·h)+ dh = n·v (Heitz 2014, Eq. 16)."""
    h, weight = hemisphere(400)
    v, alpha = view(cos), torch.full_like(weight, 0.4)
    g1 = 1 / (1 + smith_lambda(torch.tensor(cos, dtype=torch.float64), alpha))
    total = (g1 * ggx_d(h[:, 2], alpha) * (h @ v).clamp(min=0) * weight).sum()
    assert float(total) == pytest.approx(cos, rel=2e-3)


def test_reflectance_is_the_same_both_ways() -> None:
    generator = torch.Generator().manual_seed(0)
    v, light, h, alpha = torch.rand(4, 100, generator=generator) * 0.9 + 0.05
    assert torch.allclose(brdf(v, light, h, alpha), brdf(light, v, h, alpha))


@pytest.mark.parametrize("cos", [0.2, 0.7])
def test_albedo_equals_the_integral_of_the_reflectance(cos: float) -> None:
    light, weight = hemisphere(400)
    v = view(cos)
    h = torch.nn.functional.normalize(light + v, dim=1)
    for roughness in ROUGHNESS:
        f = brdf(v[2], light[:, 2], h[:, 2], roughness.square()) * light[:, 2] * weight
        cos_d = (h @ v).clamp(max=1)
        expected = [
            (f * fresnel).sum()
            for fresnel in (torch.ones_like(f), schlick_weight(cos_d), fresnel_dielectric(cos_d))
        ]
        found = directional_albedo(roughness, torch.tensor([cos], dtype=torch.float64), 4096)
        for ours, theirs in zip(found, expected, strict=True):
            assert float(ours) == pytest.approx(float(theirs), rel=0.01, abs=2e-4)


def test_fresnel_at_its_ends() -> None:
    """Normal incidence gives the paper's 0.04, grazing gives 1."""
    cos = torch.tensor([1.0, 0.0], dtype=torch.float64)
    assert torch.allclose(fresnel_dielectric(cos), torch.tensor([0.04, 1.0], dtype=torch.float64))
    assert schlick_weight(cos).tolist() == [0, 1]


def test_snell_and_fresnel_by_the_book() -> None:
    """At 60 degrees, index 1.5, from the two polarisations' textbook formulas."""
    t = math.asin(math.sin(math.pi / 3) / 1.5)
    s = (0.5 - 1.5 * math.cos(t)) / (0.5 + 1.5 * math.cos(t))
    p = (math.cos(t) - 1.5 * 0.5) / (math.cos(t) + 1.5 * 0.5)
    found = float(fresnel_dielectric(torch.tensor(0.5, dtype=torch.float64)))
    assert found == pytest.approx((s * s + p * p) / 2)


def test_no_energy_is_made() -> None:
    table = albedo_table()
    assert float(table.min()) >= 0
    assert float(table.max()) <= 1 + 1e-4
    assert (table[0, 1:] <= table[0, :1] + 1e-5).all()


def test_shadowing_is_between_0_and_1_and_none_on_a_mirror() -> None:
    cos = torch.linspace(0, 1, 50)
    for alpha in (0.0, 0.5, 1.0):
        g = smith_g2(cos, cos.flip(0), torch.full_like(cos, alpha))
        assert float(g.min()) >= 0
        assert float(g.max()) <= 1
    assert torch.allclose(smith_g2(cos[1:], cos[1:], torch.zeros(49)), torch.ones(49))


def test_shadowing_is_correlated_by_height() -> None:
    """At alpha 1, Λ = (1 / cos - 1) / 2, so G2 is the harmonic mean of the two cosines."""
    v, light = torch.rand(2, 50, generator=torch.Generator().manual_seed(0)) * 0.9 + 0.1
    assert torch.allclose(smith_g2(v, light, torch.ones(50)), 2 / (1 / v + 1 / light), atol=1e-5)


def test_visible_normals_are_unit_and_face_the_view() -> None:
    cos_v = torch.tensor([0.05, 0.5, 1.0])[:, None]
    h = visible_normals(cos_v, torch.full_like(cos_v, 0.5), hammersley(256))
    assert torch.allclose(h.norm(dim=-1), torch.ones(3, 256), atol=1e-5)
    assert float(h[..., 2].min()) > 0
    facing = torch.sqrt(1 - cos_v.square()) * h[..., 0] + cos_v * h[..., 2]
    assert float(facing.min()) > -1e-3


def test_hammersley_is_even() -> None:
    u = hammersley(256)
    counts = torch.histc(u[:, 1], bins=16, min=0, max=1)
    assert torch.equal(counts, torch.full((16,), 16.0))
    assert u.mean(0).tolist() == pytest.approx([0.5, 0.5])


def test_table_is_near_the_integral_between_its_nodes() -> None:
    generator = torch.Generator().manual_seed(1)
    roughness = torch.rand(200, 1, generator=generator) * 0.92 + 0.08
    cos = torch.rand(200, 1, generator=generator) * 0.95 + 0.05
    exact = torch.cat(directional_albedo(roughness, cos), 1)
    error = (torch.cat(lookup_albedo(roughness, cos), 1) - exact).abs()
    assert float(error.max()) < 0.01
    assert float(error.mean()) < 0.001


def test_table_has_the_gradient_of_its_values() -> None:
    roughness = torch.tensor([[0.31], [0.62]], dtype=torch.float64, requires_grad=True)
    cos = torch.tensor([[0.4], [0.8]], dtype=torch.float64, requires_grad=True)

    def total(r: Tensor, c: Tensor) -> Tensor:
        albedo: Albedo = lookup_albedo(r, c)
        return torch.cat(albedo, 1)

    assert torch.autograd.gradcheck(total, (roughness, cos))


def test_schlicks_weight_is_a_fifth_power() -> None:
    """0 head on, 1 at the horizon, 1/32 halfway; no more behind it."""
    found = schlick_weight(torch.tensor([1.0, 0.5, 0.0, -0.5]))
    assert torch.allclose(found, torch.tensor([0.0, 1 / 32, 1, 1]))
