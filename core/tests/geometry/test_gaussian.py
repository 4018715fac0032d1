"""The exact score, and what it proves of the geometry: SDS with it carries a sphere to a torus and
to a table through DMTet and the real renderer."""

import pytest
import torch

from core.adam import Adam
from core.camera import CameraConfig, Cameras, sample_cameras
from core.geometry.init_shape import ellipsoid, fit
from core.geometry.marching_tets import marching_tets
from core.geometry.mesh import health
from core.geometry.ray_sdf import ray_min_sdf
from core.geometry.sdf_net import FOURIER, SdfNet, extract, sdf_on_grid, surface
from core.geometry.tet_grid import tet_grid
from core.guidance import sds
from core.guidance.gaussian import GaussianGuidance, mesh_reference, mixture_eps, scaled_linear
from core.guidance.guidance import Views, coarse_latent
from core.render.normals import render_normals

SIZE = 32  # of the renders; half of it is the latent's


def generator(seed=0):
    return torch.Generator().manual_seed(seed)


def torus(p):
    ring = p[:, :2].norm(dim=1) - 0.65
    return (ring.square() + p[:, 2].square()).sqrt() - 0.22


def box(p, center, half):
    q = (p - p.new_tensor(center)).abs() - p.new_tensor(half)
    return q.clamp(min=0).norm(dim=1) + q.amax(1).clamp(max=0)


LEGS = [(x, y, -0.2) for x in (-0.45, 0.45) for y in (-0.45, 0.45)]


def table(p):
    parts = [box(p, (0.0, 0.0, 0.35), (0.6, 0.6, 0.1))]
    parts += [box(p, leg, (0.1, 0.1, 0.5)) for leg in LEGS]
    return torch.stack(parts).amin(0)


def mesh_of(sdf, resolution):
    grid = tet_grid(resolution)
    return marching_tets(grid.tet_verts, sdf(grid.tet_verts), grid)


def distill_shape(sdf, *, lattice, steps, ray_mask_share, seed):
    """A sphere after ``steps`` of SDS towards the shape ``sdf``, from four views a step."""
    random = generator(seed)
    reference = mesh_of(sdf, 24)
    means = mesh_reference([reference], SIZE // 2, render_size=SIZE)
    guidance = GaussianGuidance(means, SIZE // 2).prompted()
    grid = tet_grid(lattice)
    net = SdfNet(grid.cell, FOURIER, generator=random)
    fit(net, ellipsoid((0.6, 0.6, 0.6)), 60, random)
    optimizer = Adam(net.parameters(), 4e-3, (0.9, 0.99))
    for step in range(steps):
        share = step / steps
        follow_rays = share < ray_mask_share
        mesh = surface(*sdf_on_grid(net, grid), grid) if follow_rays else extract(net, grid)
        cameras = sample_cameras(4, CameraConfig(), random)
        n, o = render_normals(mesh.verts, mesh.faces, cameras, SIZE, guidance.normal_frame)
        z = coarse_latent(n, o, guidance.latent_size)
        t = sds.sample_t(len(z), 0.02, sds.anneal(0.98, 0.5, share), 1000, random)
        eps = torch.randn(z.shape, generator=random)
        grad = sds.sds_grad(guidance, z, Views(cameras), t, eps, "sigma2", 1.0, cap=0.1)
        loss = sds.sds_loss(z, grad)
        if follow_rays:
            shift = torch.rand(len(z), SIZE // 2, SIZE // 2, generator=random)
            near = ray_min_sdf(mesh.sdf, grid, cameras, 40, shift)
            loss = loss + (grad[:, 3] * (2 * torch.sigmoid(-(10 + 50 * share) * near) - 1)).sum()
        optimizer.zero_grad()
        (loss / z.numel()).backward()
        torch.nn.utils.clip_grad_norm_(net.parameters(), 1.0)
        optimizer.step()
    with torch.no_grad():
        mesh = extract(net, grid)
    return net, (mesh.verts, mesh.faces), reference


def overlap(a, b):
    """Intersection over union of two meshes' masks, over six views."""
    cameras = Cameras.orbit([0.0, 60, 120, 180, 240, 0], [20.0, 20, 20, 20, 20, 80])
    with torch.no_grad():
        masks = [render_normals(*mesh, cameras, 64)[1] > 0.5 for mesh in (a, b)]
    return ((masks[0] & masks[1]).sum() / (masks[0] | masks[1]).sum()).item()


# ---- the score


def test_noise_is_the_score_of_the_diffused_mixture():
    """-sigma times autograd's gradient of log Σ_k N(z_t; sqrt(ab) mu_k, (ab s² + sigma²) I)."""
    mu = torch.randn(3, 2, 4, 2, 2, generator=generator(), dtype=torch.float64)
    z_t = torch.randn(2, 4, 2, 2, generator=generator(1), dtype=torch.float64).requires_grad_()
    alpha_bar, std = torch.tensor([0.9, 0.1], dtype=torch.float64), 0.7
    ab = alpha_bar[:, None, None, None]
    variance = ab * std**2 + 1 - ab
    log_p = (-((z_t - ab.sqrt() * mu) ** 2) / (2 * variance)).sum((2, 3, 4)).logsumexp(0)
    (score,) = torch.autograd.grad(log_p.sum(), z_t)
    expected = -(1 - ab).sqrt() * score
    torch.testing.assert_close(mixture_eps(z_t.detach(), alpha_bar, mu, std), expected)


def test_noise_is_the_mean_of_the_noise_that_led_to_z_t():
    """E[eps | z_t] by importance sampling from the data: what "optimal denoiser" means."""
    n, std, ab = 400_000, 0.5, torch.tensor([0.6], dtype=torch.float64)
    means = torch.tensor([-1.0, 0.8], dtype=torch.float64)
    z_t = torch.full((1, 4, 1, 1), 0.2, dtype=torch.float64)
    # One dimension: the four channels of a reference agree, so give three of them no say.
    z = means[torch.randint(2, (n,), generator=generator())]
    z = z + std * torch.randn(n, generator=generator(1), dtype=torch.float64)
    eps = (0.2 - ab.sqrt() * z) / (1 - ab).sqrt()
    w = (-eps.square() / 2).exp()
    mean = (w * eps).sum() / w.sum()
    stderr = (w.square() * (eps - mean).square()).sum().sqrt() / w.sum()
    mu = torch.zeros(2, 1, 4, 1, 1, dtype=torch.float64)
    mu[:, 0, 0, 0, 0] = means
    ours = mixture_eps(z_t, ab, mu, std)[0, 0, 0, 0]
    assert abs(ours - mean) < 4 * stderr
    assert stderr < 0.01


def test_the_nearest_reference_pulls():
    mu = torch.tensor([-1.0, 1.0])[:, None, None, None, None].expand(2, 1, 4, 4, 4)
    alpha_bar = torch.tensor([0.9])
    for side in (-1.0, 1.0):
        z = torch.full((1, 4, 4, 4), 0.6 * side)
        eps = mixture_eps(alpha_bar.sqrt() * z, alpha_bar, mu, 0.2)
        # Adding noise of the predicted sign leads away from the reference, removing it there.
        assert (eps * side < 0).all()


def test_a_picture_of_the_reference_itself_has_no_gradient():
    """Same mesh, same camera, one reference without spread: eps_hat is eps."""
    reference = mesh_of(torus, 16)
    means = mesh_reference([reference], 16, render_size=32)
    guidance = GaussianGuidance(means, 16, std=0.0).prompted()
    cameras = Cameras.orbit([10.0, 130.0, 250.0], [0.0, 40.0, -15.0])
    z = coarse_latent(*render_normals(*reference, cameras, 32, "camera"), 16)
    t, eps = torch.tensor([100, 500, 900]), torch.randn(3, 4, 16, 16, generator=generator())

    def grad_at(cameras):
        return sds.sds_grad(guidance, z, Views(cameras), t, eps, "sigma2", 1.0).abs()

    assert grad_at(cameras).max() < 1e-4
    # A torus about z looks the same from every azimuth, so it takes another elevation.
    assert grad_at(Cameras.orbit([10.0, 130.0, 250.0], [80.0, 0.0, 60.0])).max() > 0.1


def test_the_schedule_is_stable_diffusions():
    alpha_bar = scaled_linear()
    assert len(alpha_bar) == 1000
    assert (alpha_bar[1:] < alpha_bar[:-1]).all()
    assert alpha_bar[0].item() == pytest.approx(1 - 0.00085)
    assert alpha_bar[-1].item() == pytest.approx(0.00466, abs=1e-5)  # sigma_max 14.61


# ---- the shapes


def test_sds_opens_the_hole_of_a_torus():
    _, mesh, reference = distill_shape(torus, lattice=16, steps=80, ray_mask_share=0.0, seed=0)
    report = health(*mesh)
    assert report["closed"]
    assert report["components"] == 1
    assert report["genus"] == 1
    assert overlap(mesh, reference) > 0.9  # 0.92 to 0.97 over four seeds


def test_sds_grows_the_four_legs_of_a_table():
    net, mesh, reference = distill_shape(table, lattice=20, steps=100, ray_mask_share=0.5, seed=0)
    report = health(*mesh)
    assert report["closed"]
    assert report["components"] == 1
    assert report["genus"] == 0
    assert overlap(mesh, reference) > 0.88
    feet = torch.tensor(LEGS) * torch.tensor([1, 1, 2.5])  # z = -0.5
    between = torch.tensor([[0.0, 0.0], [0.45, 0.0], [-0.45, 0.0], [0.0, 0.45], [0.0, -0.45]])
    between = torch.cat([between, torch.full((5, 1), -0.5)], 1)
    with torch.no_grad():
        assert (net(feet)[0] < 0).all()
        assert (net(between)[0] > 0).all()
