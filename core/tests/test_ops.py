"""The shared formulas."""

import torch

from core.ops import dot, linear_to_srgb, normalize, srgb_to_linear


def test_srgb_of_known_values():
    linear = torch.tensor([0.0, 0.0031308, 0.21404114, 1.0], dtype=torch.float64)
    srgb = torch.tensor([0.0, 0.04045, 0.5, 1.0], dtype=torch.float64)
    torch.testing.assert_close(linear_to_srgb(linear), srgb, atol=2e-6, rtol=0)


def test_srgb_goes_there_and_back():
    x = torch.linspace(0, 2, 1001, dtype=torch.float64)
    torch.testing.assert_close(srgb_to_linear(linear_to_srgb(x)), x, atol=1e-7, rtol=0)


def test_srgb_has_a_finite_gradient_at_black():
    x = torch.zeros(3, requires_grad=True)
    linear_to_srgb(x).sum().backward()
    torch.testing.assert_close(x.grad, torch.full((3,), 12.92))


def test_normalize_gives_unit_length_and_keeps_zero():
    x = torch.tensor([[3.0, 0, 4.0], [0, 0, 0]], requires_grad=True)
    y = normalize(x)
    torch.testing.assert_close(dot(y, y)[:, 0], torch.tensor([1.0, 0.0]))
    y.sum().backward()
    assert x.grad.isfinite().all()
