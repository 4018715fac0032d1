"""The smallest SDF along a ray, against spheres whose rays are known in closed form."""

import torch

from core import kernels
from core.camera import Cameras
from core.geometry.ray_sdf import _span, pixel_rays, ray_min_sdf
from core.geometry.tet_grid import tet_grid

GRID = tet_grid(24)
CAMERAS = Cameras.orbit([0.0, 70.0, 200.0], [10.0, -30.0, 80.0])


def ball(centre, radius, grid=GRID):
    return (grid.tet_verts - torch.tensor(centre)).norm(dim=1) - radius


def seeded(seed=0):
    return torch.Generator().manual_seed(seed)


def shift(views, size, seed=0):
    return torch.rand(views, size, size, generator=seeded(seed))


def test_sphere_at_the_origin():
    eye, direction = pixel_rays(CAMERAS, 16)
    closest = eye[:, None] - (eye[:, None] * direction).sum(-1, keepdim=True) * direction
    passing = closest.norm(dim=-1)
    expected = (passing - 0.5).view(3, 16, 16)
    drawn = ray_min_sdf(ball([0.0, 0, 0], 0.5), GRID, CAMERAS, 200, shift(3, 16))
    inside_cube = (closest.abs().amax(-1) < 1.0).view(3, 16, 16)
    outside_ball = expected > 0
    error = (drawn - expected)[inside_cube & outside_ball].abs()
    assert error.numel() > 300
    assert error.max() < 0.005  # the lattice's interpolation of a curved function
    centre = drawn[:, 7:9, 7:9]
    assert (centre + 0.5).abs().max() < 0.12  # the kink at the centre is cut by one cell


def test_a_ball_shows_where_the_camera_s_matrix_puts_it():
    centre = [0.4, -0.3, 0.5]
    drawn = ray_min_sdf(ball(centre, 0.1), GRID, CAMERAS, 64, shift(3, 64))
    clip = CAMERAS.mvp @ torch.tensor([*centre, 1.0])
    column = (clip[:, 0] / clip[:, 3] * 0.5 + 0.5) * 64
    row = (0.5 - clip[:, 1] / clip[:, 3] * 0.5) * 64
    for view in range(3):
        lowest = int(drawn[view].argmin())
        assert abs(lowest // 64 + 0.5 - float(row[view])) < 2
        assert abs(lowest % 64 + 0.5 - float(column[view])) < 2


def test_gradient_is_that_of_the_chosen_sample():
    grid = tet_grid(4)
    sdf = torch.randn(5**3, generator=seeded(1), dtype=torch.float64).requires_grad_()
    cameras = Cameras(
        *(x.double() for x in (CAMERAS.azimuth, CAMERAS.elevation, CAMERAS.distance, CAMERAS.fovy))
    )

    def smallest(values):
        return ray_min_sdf(values, grid, cameras, 8, shift(len(cameras), 6, 2))

    assert torch.autograd.gradcheck(smallest, (sdf,))


def test_trilinear_values_of_a_linear_function_are_exact():
    p = GRID.tet_verts
    sdf = p @ torch.tensor([0.3, -0.7, 0.2]) + 0.1
    drawn = ray_min_sdf(sdf, GRID, CAMERAS, 50, shift(3, 8))
    eye, direction = pixel_rays(CAMERAS, 8)
    depth = torch.linspace(0, 6, 20001)
    for view, pixel in ((0, 27), (1, 36), (2, 28)):
        points = eye[view] + depth[:, None] * direction[view, pixel]
        within = points[points.abs().amax(1) < 1.05]
        values = within @ torch.tensor([0.3, -0.7, 0.2]) + 0.1
        step = (values.max() - values.min()) / 50
        got = drawn[view].view(-1)[pixel]
        assert values.min() - 1e-3 < got < values.min() + step


def test_rays_next_to_the_cube_are_far_from_the_surface():
    cameras = Cameras.orbit([0.0], [0.0], fovy_deg=100.0)
    drawn = ray_min_sdf(ball([0.0, 0, 0], 0.5), GRID, cameras, 20, shift(len(cameras), 16))
    assert drawn.isfinite().all()
    assert (drawn[:, 0] > 0.4).all()


def test_the_generator_decides_the_samples():
    sdf = torch.randn(25**3, generator=seeded(5))
    first, again, other = (ray_min_sdf(sdf, GRID, CAMERAS, 6, shift(3, 8, s)) for s in (1, 1, 2))
    assert torch.equal(first, again)
    assert not torch.equal(first, other)


def test_the_compiled_search_finds_what_torch_finds(monkeypatch):
    """Where two samples are equal to the last digits either may be found."""
    bumps = ball([0.2, -0.1, 0.0], 0.4) + 0.05 * torch.randn(
        len(GRID.tet_verts), generator=seeded()
    )
    cameras = Cameras.orbit([0.0, 70.0, 200.0], [10.0, -30.0, 90.0], distance=3.0, fovy_deg=60.0)
    eye, direction = pixel_rays(cameras, 32)  # some rays miss the cube

    def found():
        return ray_min_sdf(bumps, GRID, cameras, 40, shift(3, 32))

    compiled = found()
    with monkeypatch.context() as patch:
        patch.setattr(kernels, "supports", lambda *_: False)
        plain = found()
    torch.testing.assert_close(compiled, plain, atol=1e-5, rtol=0)
    near, far = _span(eye, direction, GRID.extent)
    assert (near == far).any() and (near < far).any()
