import math

import pytest
import torch
from torch import Tensor

from core.appearance.brdf import fresnel_dielectric, ggx_d, schlick_weight, smith_g2
from core.appearance.lamps import MOST, WIDEST, Lamps, split_lamps
from core.appearance.latlong import directions, solid_angles
from core.ops import dot, normalize

GENERATOR = torch.Generator().manual_seed(0)
NORMAL = normalize(torch.randn(50, 3, generator=GENERATOR))
VIEW = normalize(NORMAL + 0.5 * normalize(torch.randn(50, 3, generator=GENERATOR)))
AXIS = normalize(torch.tensor([0.3, -0.8, 0.5]))


def spot(axis: Tensor, radius: float, radiance: float, height: int = 256) -> Tensor:
    """An even disc of light over a dim sky."""
    d = directions(height, 2 * height)
    inside = (d @ axis).clamp(-1, 1).acos() < radius
    return torch.where(inside[..., None], torch.tensor([1.0, 0.8, 0.5]) * radiance, 0.3)


def power(image: Tensor) -> Tensor:
    return (image * solid_angles(*image.shape[:2])[:, None]).sum((0, 1))


@pytest.mark.parametrize("axis", [AXIS, torch.tensor([-1.0, 0, 0]), torch.tensor([0.0, 0, 1])])
def test_a_sun_is_one_lamp_where_it_stands(axis: Tensor) -> None:
    """Also across the seam and on the pole."""
    image = spot(axis, 0.03, 5000.0)
    rest, lamps = split_lamps(image)
    assert len(lamps.width) == 1
    assert float(dot(lamps.direction[0], axis)) > math.cos(0.004)
    # Of an even disc: half its radius, less at the pole, where it ends between two rows; and
    # reading between texels.
    width = math.hypot(0.015, math.pi / 256 / 6**0.5)
    assert float(lamps.width) == pytest.approx(width, rel=0.3 if axis[2] == 1 else 0.1)
    assert float(rest.max()) < 0.02 * 5000


def test_no_light_is_lost_or_made() -> None:
    image = spot(AXIS, 0.03, 2000.0) + spot(normalize(torch.tensor([1.0, 1, 0])), 0.1, 300.0)
    rest, lamps = split_lamps(image)
    assert torch.allclose(power(rest) + lamps.power.sum(0), power(image), rtol=1e-4)
    assert float(rest.min()) >= float(image.min())


def test_a_wide_light_is_several_lamps() -> None:
    _, lamps = split_lamps(spot(AXIS, 0.06, 2000.0))
    assert 2 <= len(lamps.width) <= MOST
    assert float(lamps.width.max()) < WIDEST * 1.5
    assert float((lamps.direction @ AXIS).min()) > math.cos(0.06)


def test_even_light_has_no_lamp() -> None:
    image = torch.rand(32, 64, 3, generator=GENERATOR)
    rest, lamps = split_lamps(image)
    assert len(lamps.width) == 0
    assert torch.equal(rest, image)
    reflected = lamps.reflected(NORMAL, VIEW, dot(NORMAL, VIEW), torch.full((50, 1), 0.3))
    assert float(reflected.abs().sum() + lamps.irradiance(NORMAL).abs().sum()) == 0


@pytest.mark.parametrize("roughness", [0.1, 0.3, 0.7])
def test_a_lamp_reflects_as_the_sum_over_its_texels(roughness: float) -> None:
    """Eq. 8 summed over the map; ±15 % of the brightest where the disc is as wide as the lobe."""
    image = spot(AXIS, 0.02, 5000.0, 512)
    rest, lamps = split_lamps(image)
    normal = normalize(AXIS + VIEW[:1] + 0.3 * NORMAL)
    view = VIEW[:1].expand(50, 3)
    sun = (image - rest).view(-1, 3) * solid_angles(512, 1024).expand(-1, 1024).reshape(-1, 1)
    lit = sun.sum(1) > 0
    light = directions(512, 1024).view(-1, 3)[lit]
    h = normalize(light[None] + view[:, None])
    cos_l, cos_v = normal @ light.t(), dot(normal, view).clamp(min=1e-3)
    cos_h = (h * normal[:, None]).sum(-1).clamp(0, 1)
    cos_d = (h * view[:, None]).sum(-1).clamp(0, 1)
    alpha = torch.tensor(roughness**2)
    weight = ggx_d(cos_h, alpha) * smith_g2(cos_v, cos_l.clamp(min=1e-5), alpha) / (4 * cos_v)
    weight = weight * (cos_l > 0)
    schlick = schlick_weight(cos_d)
    kinds = torch.stack([1 - schlick, schlick, fresnel_dielectric(cos_d)]) * weight
    exact = kinds @ sun[lit]
    found = lamps.reflected(normal, view, cos_v, torch.full((50, 1), roughness))
    error = (found - exact).abs().amax((1, 2)) / exact.amax((1, 2))
    assert float(error.max()) < (0.15 if roughness == 0.1 else 0.02)
    diffuse = cos_l.clamp(min=0) @ sun[lit] / math.pi
    assert torch.allclose(lamps.irradiance(normal), diffuse, rtol=1e-3, atol=1e-3)


def test_rotation_turns_the_lamps() -> None:
    lamps = Lamps(AXIS[None], torch.ones(1, 3), torch.tensor([0.01]))
    turned = lamps.rotated(math.pi / 2)
    assert torch.allclose(turned.direction[0], torch.stack([-AXIS[1], AXIS[0], AXIS[2]]), atol=1e-6)


def test_gradients_are_exact() -> None:
    _, lamps = split_lamps(spot(AXIS, 0.02, 500.0))
    normal = normalize(AXIS + VIEW[:6]).double().requires_grad_()
    roughness = torch.linspace(0.2, 0.9, 6).double()[:, None].requires_grad_()
    view = VIEW[:6].double()

    def reflected(normal: Tensor, roughness: Tensor) -> Tensor:
        cos_v = dot(normal, view).clamp(min=1e-3)
        return lamps.reflected(normal, view, cos_v, roughness) + lamps.irradiance(normal)

    assert torch.autograd.gradcheck(reflected, (normal, roughness), eps=1e-7, atol=1e-3, rtol=1e-3)
