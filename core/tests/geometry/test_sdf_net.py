"""Ψ: bounded offsets, and the two-pass extraction against the full gradient."""

import dataclasses

import pytest
import torch

from core.geometry.sdf_net import FOURIER, HASH, SdfNet, band_about, extract, sdf_on_grid, surface
from core.geometry.tet_grid import tet_grid

GRID = tet_grid(8)
SMALL_HASH = dataclasses.replace(HASH, levels=4, log2_size=10, finest=64)


def ball_net(config, seed=0):
    """A net whose SDF is roughly a ball's: a few steps towards it."""
    generator = torch.Generator().manual_seed(seed)
    net = SdfNet(GRID.cell, config, generator=generator)
    optimiser = torch.optim.Adam(net.parameters(), 1e-2)
    for _ in range(60):
        sdf, offset = net(GRID.tet_verts)
        loss = (sdf - (GRID.tet_verts.norm(dim=1) - 0.6)).square().mean() + offset.square().mean()
        optimiser.zero_grad()
        loss.backward()
        optimiser.step()
    return net


@pytest.mark.parametrize("config", [SMALL_HASH, FOURIER])
def test_two_pass_gradient_is_the_full_gradient(config):
    net = ball_net(config)
    weight = torch.randn(len(extract(net, GRID).verts), 3)
    gradients = []
    for drawn in (extract(net, GRID, chunk=100), surface(*sdf_on_grid(net, GRID), GRID)):
        assert len(drawn.faces) > 100
        loss = (drawn.verts * weight).sum() + drawn.verts.square().sum()
        gradients.append((drawn, torch.autograd.grad(loss, list(net.parameters()))))
    (two_pass, g_two), (full, g_full) = gradients
    assert torch.equal(two_pass.faces, full.faces)
    torch.testing.assert_close(two_pass.verts, full.verts)
    for ours, theirs in zip(g_two, g_full, strict=True):
        torch.testing.assert_close(ours, theirs, rtol=1e-3, atol=1e-5 * float(theirs.abs().max()))
    assert all(float(g.abs().max()) > 0 for g in g_full)


def test_extract_without_gradient_is_the_same_surface():
    net = ball_net(FOURIER)
    with torch.no_grad():
        quiet = extract(net, GRID)
    assert not quiet.verts.requires_grad
    torch.testing.assert_close(quiet.verts, extract(net, GRID).verts)


def test_an_empty_surface_is_empty():
    net = SdfNet(GRID.cell, FOURIER)
    with torch.no_grad():
        net.mlp[-1].bias[0] = 100.0
    drawn = extract(net, GRID)
    assert drawn.verts.shape == (0, 3)
    assert drawn.faces.shape == (0, 3)


def test_offset_stays_within_half_a_cell():
    net = SdfNet(0.1, FOURIER)
    with torch.no_grad():
        for parameter in net.parameters():
            parameter.mul_(10)
    offset = net(torch.rand(500, 3) * 2 - 1)[1]
    assert 0.045 < float(offset.detach().abs().max()) < 0.05 + 1e-7


def test_the_defaults_are_the_paper_s():
    net = SdfNet(GRID.cell)
    shapes = [tuple(p.shape) for name, p in net.named_parameters() if name.startswith("mlp")]
    assert shapes == [(32, 32), (32, 32), (4, 32)]  # three layers, 32 hidden, no bias
    assert net.encoding.resolutions[0] == 16
    assert net.encoding.resolutions[-1] == 4096
    assert len(net.encoding.resolutions) == 16
    assert max(net.encoding.sizes) == 2**19


def test_the_same_generator_gives_the_same_net():
    first, second = (
        SdfNet(GRID.cell, SMALL_HASH, generator=torch.Generator().manual_seed(4)) for _ in range(2)
    )
    for a, b in zip(first.parameters(), second.parameters(), strict=True):
        assert torch.equal(a, b)


def test_fourier_features_of_a_point():
    p = torch.tensor([[0.3, -0.2, 1.0]])
    features = SdfNet(GRID.cell, dataclasses.replace(FOURIER, octaves=2)).encoding(p)[0]
    phases = [1.5 * 0.3, 1.5 * -0.2, 1.5, 3 * 0.3, 3 * -0.2, 3.0]
    expected = torch.cat([p[0], torch.tensor(phases).sin(), torch.tensor(phases).cos()])
    torch.testing.assert_close(features, expected)


def test_within_the_band_the_surface_is_that_of_the_whole_lattice():
    net = ball_net(FOURIER)
    band = band_about(net, GRID, 1)
    assert 0 < len(band.near) < 0.8 * len(GRID.tet_verts)
    with torch.no_grad():
        net.mlp[-1].bias[0] += 0.5 * GRID.cell  # the ball shrinks, and stays within the band
    whole, near = extract(net, GRID), extract(net, GRID, band)
    assert torch.equal(near.faces, whole.faces)
    torch.testing.assert_close(near.verts, whole.verts)
    assert not torch.equal(near.sdf, whole.sdf)  # far away the old values stay


def test_the_band_reaches_as_far_as_requested():
    """About a single inner node: it and its neighbours, one cell away, and two cells more."""

    class Point(SdfNet):
        def forward(self, points):
            return points.norm(dim=1) - 0.5 * GRID.cell, torch.zeros_like(points)

    steps = (GRID.tet_verts / GRID.cell).abs().amax(1).round()
    near = steps[band_about(Point(GRID.cell, FOURIER), GRID, 2).near]
    assert int(near.max()) == 3
    assert int((near <= 2).sum()) == int((steps <= 2).sum()) == 5**3
