import pytest
import torch
from torch import Tensor

from core.appearance import shade as module
from core.appearance.brdf import directional_albedo
from core.appearance.environment import Environment
from core.appearance.latlong import directions
from core.appearance.shade import lifted, perturb, shade
from core.ops import dot, normalize

GENERATOR = torch.Generator().manual_seed(0)
N = 200
NORMAL = normalize(torch.randn(N, 3, generator=GENERATOR))
VIEW = normalize(NORMAL + 0.8 * normalize(torch.randn(N, 3, generator=GENERATOR)))
ONES = torch.ones(N, 1)


@pytest.fixture(scope="module")
def furnace() -> Environment:
    return Environment.of(torch.ones(16, 32, 3))


@pytest.fixture(scope="module")
def sky() -> Environment:
    x, y, z = directions(64, 128).unbind(-1)
    return Environment.of(torch.stack([1 + z, 1 + 0.5 * x, 1 + 0.5 * y], -1))


@pytest.mark.parametrize("roughness", [0.08, 0.3, 0.6, 1.0])
def test_white_furnace(furnace: Environment, roughness: float) -> None:
    """Under a uniform light of 1 a white surface sends out 1, less what one bounce cannot.

    A metal gives back its albedo, as GGX loses what bounces between microfacets (40 to 70 % are
    left at roughness 1, by the angle). A white dielectric loses only the coat's part of that.
    """
    white, rough = torch.ones(N, 3), roughness * ONES
    metal = shade(NORMAL, VIEW, white, rough, ONES, furnace)
    albedo = directional_albedo(rough, dot(NORMAL, VIEW).clamp(min=1e-3)).total
    assert float((metal - albedo).abs().max()) < 0.01
    assert float(metal.max()) <= 1 + 1e-3
    dielectric = shade(NORMAL, VIEW, white, rough, 0 * ONES, furnace)
    assert float(dielectric.max()) <= 1 + 1e-3
    assert float(dielectric.min()) > 0.9
    if roughness <= 0.3:
        assert float(metal.min()) > 0.9


def test_black_metal_reflects_only_at_grazing_angles(furnace: Environment) -> None:
    black = shade(NORMAL, NORMAL, torch.zeros(N, 3), 0.3 * ONES, ONES, furnace)
    assert float(black.max()) < 1e-3


def test_matte_surface_shows_its_colour_times_the_light(sky: Environment) -> None:
    """kd times the irradiance, less 4 to 9 % for the coat seen head on."""
    kd = torch.tensor([0.8, 0.4, 0.0]).expand(N, 3)
    dark = shade(NORMAL, NORMAL, 0 * kd, ONES, 0 * ONES, sky)
    matte = shade(NORMAL, NORMAL, kd, ONES, 0 * ONES, sky) - dark
    fraction = matte[:, :2] / (kd * sky.irradiance(NORMAL))[:, :2]
    assert float(fraction.min()) > 0.91
    assert float(fraction.max()) < 0.97
    assert float(matte[:, 2].abs().max()) < 1e-6


def test_metallic_is_a_mixture(sky: Environment) -> None:
    kd = torch.rand(N, 3, generator=GENERATOR)
    rough = 0.4 * ONES
    ends = [shade(NORMAL, VIEW, kd, rough, m * ONES, sky) for m in (0.0, 1.0)]
    middle = shade(NORMAL, VIEW, kd, rough, 0.25 * ONES, sky)
    assert torch.allclose(middle, torch.lerp(*ends, 0.25), atol=1e-5)


def test_gradients_are_exact(sky: Environment) -> None:
    # At roughnesses between the tables' nodes, where they have a kink.
    count = 4
    inputs = (
        NORMAL[:count],
        VIEW[:count],
        torch.rand(count, 3, generator=GENERATOR),
        torch.tensor([[0.234], [0.433], [0.567], [0.871]]),
        torch.rand(count, 1, generator=GENERATOR),
    )
    inputs = tuple(x.double().requires_grad_() for x in inputs)
    assert torch.autograd.gradcheck(
        lambda *x: shade(*x, sky), inputs, eps=1e-7, atol=1e-4, rtol=1e-3
    )


def test_grazing_and_turned_away_views_are_finite(sky: Environment) -> None:
    """Also straight up and straight down, where the map of directions is singular."""
    up = torch.tensor([0.0, 0, 1])
    normal = torch.stack([up, up, up, -up, up, up])
    view = torch.tensor(
        [[1.0, 0, 0], [1, 0, 1e-6], [0.6, 0, -0.8], [0, 0, -1], [0, 0, 1], [0, 0, -1]]
    )
    for roughness in (0.0, 0.08, 1.0):
        leaves = [
            x.clone().requires_grad_()
            for x in (
                normal,
                view,
                torch.full((6, 3), 0.5),
                torch.full((6, 1), roughness),
                torch.full((6, 1), 0.5),
            )
        ]
        color = shade(*leaves, sky)
        assert torch.isfinite(color).all()
        assert float(color.detach().min()) >= 0
        color.sum().backward()
        assert all(torch.isfinite(leaf.grad).all() for leaf in leaves)


def test_chunks_change_nothing(sky: Environment, monkeypatch: pytest.MonkeyPatch) -> None:
    inputs = (NORMAL, VIEW, torch.rand(N, 3, generator=GENERATOR), 0.4 * ONES, 0.5 * ONES)
    whole = shade(*inputs, sky)
    monkeypatch.setattr(module, "CHUNK", 7)
    assert torch.allclose(shade(*inputs, sky), whole, atol=1e-6)


def test_no_points_are_no_colours(sky: Environment) -> None:
    none = torch.zeros(0, 3)
    assert shade(none, none, none, none[:, :1], none[:, :1], sky).shape == (0, 3)


def tangents(normal: Tensor, sign: float) -> Tensor:
    side = torch.linalg.cross(normal, torch.tensor([0.2, 0.5, 0.8]).expand_as(normal))
    return torch.cat([normalize(side), torch.full((len(normal), 1), sign)], 1)


def test_flat_normal_map_changes_nothing() -> None:
    kn = torch.tensor([0.0, 0, 1]).expand(N, 3)
    assert torch.allclose(perturb(NORMAL, tangents(NORMAL, 1.0), kn), NORMAL, atol=1e-6)


@pytest.mark.parametrize("sign", [1.0, -1.0])
def test_normal_map_axes_are_tangent_bitangent_normal(sign: float) -> None:
    tangent = tangents(NORMAL, sign)
    kn = normalize(torch.tensor([0.3, 0.4, 0.8])).expand(N, 3)
    found = perturb(NORMAL, tangent, kn)
    bitangent = sign * torch.linalg.cross(NORMAL, tangent[:, :3])
    for axis, part in ((tangent[:, :3], 0), (bitangent, 1), (NORMAL, 2)):
        assert torch.allclose(dot(found, axis), kn[:, part : part + 1], atol=1e-5)


FRONT = normalize(VIEW + 0.9 * normalize(torch.randn(N, 3, generator=GENERATOR)))


def test_a_lifted_normal_mirrors_to_the_outside() -> None:
    steep = normalize(FRONT + 1.5 * normalize(torch.randn(N, 3, generator=GENERATOR)))
    below = dot(2 * dot(steep, VIEW) * steep - VIEW, FRONT) < 0
    assert 10 < int(below.sum()) < N - 10
    found = lifted(steep, VIEW, FRONT)
    height = dot(2 * dot(found, VIEW) * found - VIEW, FRONT)
    least = torch.minimum(0.9 * dot(VIEW, FRONT), torch.full((N, 1), 0.01))
    assert torch.allclose(height[below], least[below], atol=1e-4)
    assert torch.allclose(found.norm(dim=1), torch.ones(N), atol=1e-5)
    # In the plane of both normals, and between them.
    assert float(dot(found, torch.linalg.cross(steep, FRONT)).abs().max()) < 1e-5
    assert bool((dot(found, FRONT) >= dot(steep, FRONT) - 1e-6).all())
    fine = (height > least + 1e-4).squeeze(1)
    assert torch.equal(found[fine], steep[fine])


def test_the_lift_has_a_finite_gradient() -> None:
    steep = normalize(FRONT + 1.5 * NORMAL).requires_grad_()
    lifted(torch.cat([steep, FRONT]), VIEW.repeat(2, 1), FRONT.repeat(2, 1)).sum().backward()
    assert torch.isfinite(steep.grad).all()
