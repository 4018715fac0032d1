"""Cameras: their places, their pictures, their random numbers."""

import math

import pytest
import torch

from core.camera import ZOOM, CameraConfig, Cameras, aimed, sample_cameras


def test_azimuth_is_counted_from_the_front_counter_clockwise():
    eye = Cameras.orbit([0, 90, 180, 0], [0, 0, 0, 90], distance=2).eye
    expected = [[0, -2, 0], [2, 0, 0], [0, 2, 0], [0, 0, 2]]
    torch.testing.assert_close(eye, torch.tensor(expected, dtype=torch.float32), atol=1e-6, rtol=0)


def test_rotation_is_a_rotation_everywhere_even_at_the_poles():
    cameras = Cameras.orbit([0, 10, 200, 0, 30], [0, 80, -45, 90, -90])
    r = cameras.rotation
    torch.testing.assert_close(r @ r.mT, torch.eye(3).expand(5, 3, 3), atol=1e-6, rtol=0)
    torch.testing.assert_close(torch.linalg.det(r), torch.ones(5))


def test_the_matrix_agrees_with_the_rotation_and_the_eye():
    cameras = Cameras.orbit([25], [35], distance=3.5)
    x = torch.tensor([0.2, -0.4, 0.3])
    by_parts = cameras.rotation[0] @ (x - cameras.eye[0])
    torch.testing.assert_close((cameras.w2c[0] @ torch.cat([x, torch.ones(1)]))[:3], by_parts)


def test_what_is_up_is_up_and_what_is_right_is_right():
    cameras = Cameras.orbit([0], [0])
    clip = torch.tensor([[0.1, 0, 0, 1], [0, 0, 0.1, 1.0]]) @ cameras.mvp[0].T
    ndc = clip[:, :2] / clip[:, 3:]
    assert ndc[0, 0] > 0
    assert ndc[0, 1].abs() < 1e-6
    assert ndc[1, 1] > 0
    assert ndc[1, 0].abs() < 1e-6


def test_the_frustum_is_as_wide_as_the_field_of_view():
    cameras = Cameras.orbit([0], [0], distance=3, fovy_deg=40)
    edge = 3 * math.tan(math.radians(20))
    clip = cameras.mvp[0] @ torch.tensor([0, 0, edge, 1.0])
    assert float(clip[1] / clip[3]) == pytest.approx(1, abs=1e-6)
    near, far = (cameras.mvp[0] @ torch.tensor([0, y, 0, 1.0]) for y in (-2.9, 7.0))
    assert float(near[2] / near[3]) == pytest.approx(-1, abs=1e-5)
    assert float(far[2] / far[3]) == pytest.approx(1, abs=1e-5)


@pytest.mark.parametrize("n", [1, 3, 8])
def test_azimuths_are_stratified_at_any_batch_size(n):
    generator = torch.Generator().manual_seed(0)
    gaps = []
    for _ in range(200):
        azimuth = sample_cameras(n, CameraConfig(azimuth_jitter=0.0), generator).azimuth
        turns = (azimuth / (2 * math.pi)).remainder(1).sort().values
        gaps.append(torch.cat([turns, turns[:1] + 1]).diff())
    assert float(torch.cat(gaps).sub(1 / n).abs().max()) < 1e-5


def test_elevations_are_uniform_on_the_sphere():
    """The sine of the elevation is uniform: mean 0, variance 1/3, within 4 standard errors."""
    generator = torch.Generator().manual_seed(1)
    config = CameraConfig(elevation_deg=(-90, 90))
    sine = sample_cameras(20000, config, generator).elevation.sin()
    assert abs(float(sine.mean())) < 4 * (1 / 3 / 20000) ** 0.5
    assert float(sine.square().mean()) == pytest.approx(1 / 3, abs=4 * (4 / 45 / 20000) ** 0.5)


def test_a_seed_gives_the_same_cameras():
    a, b = (sample_cameras(5, CameraConfig(), torch.Generator().manual_seed(3)) for _ in range(2))
    assert torch.equal(a.eye, b.eye)


def test_a_close_up_is_a_part_of_the_picture_and_one_of_it_a_part_of_that():
    whole = Cameras.orbit([25, 140], [35, -20])
    center, zoom = torch.tensor([[0.25, -0.3], [-0.1, 0.2]]), torch.tensor([2.0, 3.0])
    close = whole.close_up(center, zoom)
    x = torch.cat([torch.randn(2, 6, 3) * 0.3, torch.ones(2, 6, 1)], -1)

    def seen(cameras):
        clip = x @ cameras.mvp.mT
        return clip[..., :2] / clip[..., 3:]

    expected = (seen(whole) - center[:, None]) * zoom[:, None, None]
    torch.testing.assert_close(seen(close), expected, atol=1e-5, rtol=0)
    again = close.close_up(center, zoom)
    expected = (expected - center[:, None]) * zoom[:, None, None]
    torch.testing.assert_close(seen(again), expected, atol=1e-4, rtol=0)
    assert torch.equal(close[1:].shift, close.shift[1:])
    assert close.tensors().keys() - whole.tensors().keys() == {"shift"}


def test_close_ups_aim_at_what_is_there():
    whole = Cameras.orbit([0.0] * 50, [10.0] * 50)
    coverage = torch.zeros(50, 8, 8)
    coverage[:, 1, 6] = 1  # the second row from the top, the last column but one
    close = aimed(whole, coverage, torch.Generator().manual_seed(0))
    zoom = (whole.fovy / 2).tan() / (close.fovy / 2).tan()
    assert zoom.min() >= ZOOM[0] - 1e-4 and zoom.max() <= ZOOM[1] + 1e-4
    assert zoom.max() / zoom.min() > 1.8
    torch.testing.assert_close(-close.shift / zoom[:, None], torch.tensor([[0.625, 0.625]] * 50))
