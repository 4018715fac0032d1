"""The families' solids: distances that sphere tracing may trust, sizes, and topology."""

import math

import pytest
import torch

from core.geometry.marching_tets import marching_tets
from core.geometry.mesh import health
from core.geometry.tet_grid import tet_grid
from core.prior.families import FAMILIES, Draw, build, surface_points
from core.prior.solids import box, cut, ellipsoid, lathe, polygon, prism, ring, tube


def _draw(seed: int = 0) -> Draw:
    return Draw(torch.Generator().manual_seed(seed))


def _points(count: int, reach: float = 1.5, seed: int = 0) -> torch.Tensor:
    return (torch.rand(count, 3, generator=torch.Generator().manual_seed(seed)) * 2 - 1) * reach


@pytest.mark.parametrize("noun", FAMILIES)
def test_a_family_is_normalised_and_its_distance_is_a_lower_bound(noun):
    shape = build(noun, "", _draw(), jitter=0)
    surface = surface_points(shape.sdf, 2.4)
    low, high = surface.amin(0), surface.amax(0)
    assert ((low + high) / 2).abs().max() < 0.02
    assert surface.norm(dim=1).max().item() == pytest.approx(0.9, abs=0.02)
    points = _points(400)
    distance = shape.sdf(points)
    to_surface = torch.cdist(points, surface).amin(1)
    spacing = 0.06  # of the surface's points, at their widest
    assert (distance.abs() <= to_surface + 0.02).all()
    if noun not in ("mushroom",):  # its ellipsoid is a first-order estimate
        outside = distance > 0.2
        assert (to_surface[outside] - distance[outside]).median() < spacing


@pytest.mark.parametrize("noun", FAMILIES)
def test_a_distance_never_changes_faster_than_the_way(noun):
    shape = build(noun, "tall", _draw(1))
    a, b = _points(3000, seed=1), _points(3000, seed=2) * 0.02
    steepness = (shape.sdf(a + b) - shape.sdf(a)).abs() / b.norm(dim=1)
    assert steepness.max() < (1.4 if noun == "mushroom" else 1.02)


@pytest.mark.parametrize(("noun", "genus"), [("torus", 1), ("mug", 1), ("chair", 0), ("ball", 0)])
def test_a_family_has_the_topology_of_its_word(noun, genus):
    shape = build(noun, "", _draw(2))
    grid = tet_grid(40)
    report = health(*marching_tets(grid.tet_verts, shape.sdf(grid.tet_verts), grid))
    assert report["genus"] == genus
    assert report["components"] == 1


def test_a_chair_has_four_legs_a_front_and_a_back():
    shape = build("chair", "", _draw(3), jitter=0)
    surface = surface_points(shape.sdf, 2.4)
    low, high = surface[:, 2].min(), surface[:, 2].max()
    feet = surface[surface[:, 2] < low + 0.1, :2]
    quarters = {(bool(x > 0), bool(y > 0)) for x, y in feet}
    assert len(quarters) == 4
    assert feet.abs().amin() > 0.15  # nothing in between them
    assert (surface[surface[:, 2] > high - 0.2, 1] > 0).all()  # the front faces -Y


def test_adjectives_stretch():
    def extent(adjective: str) -> torch.Tensor:
        points = surface_points(build("vase", adjective, _draw(4), jitter=0).sdf, 2.4)
        return points.amax(0) - points.amin(0)

    plain, tall, flat, wide = (extent(word) for word in ("", "tall", "flat", "wide"))
    assert tall[2] / tall[0] > 1.3 * plain[2] / plain[0]
    assert flat[2] / flat[0] < 0.7 * plain[2] / plain[0]
    assert wide[0] / wide[1] > 1.3 * plain[0] / plain[1]


def test_a_polygons_distance_is_that_to_its_nearest_boundary_point():
    corners = [(0.0, 0.0), (1.0, 0.2), (0.6, 0.5), (0.9, 1.1), (-0.2, 0.7)]
    walk = [
        (ax + (bx - ax) * k / 200, ay + (by - ay) * k / 200)
        for (ax, ay), (bx, by) in zip(corners, corners[1:] + corners[:1], strict=True)
        for k in range(200)
    ]
    points = _points(300)[:, :2]
    slow = torch.cdist(points, torch.tensor(walk)).amin(1)
    fast = polygon(points[:, 0], points[:, 1], corners)
    torch.testing.assert_close(fast.abs(), slow, atol=4e-3, rtol=0)
    turns = torch.zeros(300)  # winding number by summed angles
    for (ax, ay), (bx, by) in zip(corners, corners[1:] + corners[:1], strict=True):
        a, b = points - torch.tensor([ax, ay]), points - torch.tensor([bx, by])
        turns += torch.atan2(a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0], (a * b).sum(1))
    assert ((fast < 0) == (turns.abs() > math.pi)).all()


def test_solids_made_in_two_ways_are_the_same():
    points = _points(500)
    turned = lathe([(0.5, -0.4), (0.5, 0.6)])(points)
    straight = tube((0, 0, -0.4), (0, 0, 0.6), 0.5)(points)
    torch.testing.assert_close(turned, straight, atol=1e-5, rtol=0)
    square = [(-0.5, -0.3), (0.5, -0.3), (0.5, 0.3), (-0.5, 0.3)]
    torch.testing.assert_close(
        prism(square, 2, 0.4)(points), box((0, 0, 0), (0.5, 0.3, 0.4))(points), atol=1e-5, rtol=0
    )
    round_one = ellipsoid((0, 0, 0), (0.7, 0.7, 0.7))(points)
    torch.testing.assert_close(round_one, points.norm(dim=1) - 0.7, atol=1e-5, rtol=0)


def test_a_ring_has_a_hole_and_a_cut_removes():
    p = torch.tensor([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0]])
    torch.testing.assert_close(ring((0, 0, 0), 1.0, 0.3)(p), torch.tensor([0.7, -0.3]))
    solid = cut(box((0, 0, 0), (1, 1, 1)), box((0, 0, 0), (0.5, 0.5, 2)))
    torch.testing.assert_close(
        solid(torch.tensor([[0.0, 0.0, 0.0], [0.75, 0.0, 0.0]])), torch.tensor([0.5, -0.25])
    )
