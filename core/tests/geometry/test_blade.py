"""A blade, a lozenge across that comes to a point, is found again where a network rounded it."""

import numpy as np
import pytest
import torch
from scipy.spatial import ConvexHull

from core.geometry.init_shape import sample_surface
from core.geometry.mesh import health
from core.geometry.parts.assembly import KnownParts
from core.geometry.parts.blade import blade
from core.geometry.parts.components import drawn_at, places_of, points_of
from core.geometry.parts.forms import Forms
from core.geometry.parts.primitives import Primitive
from core.geometry.union import is_solid
from core.prior.solids import box, lozenge_blade

# Where it begins and ends, its half widths there, how long its point is, how many times as wide it
# is at its shoulder.
SWORD, LEAF = (-0.8, 0.8, 0.25, 0.16, 0.45, 0.85), (-0.4, 0.6, 0.12, 0.1, 0.7, 2.5)
NETWORK = 0.025  # by so much what it draws is blurred, training units
CASES = [(SWORD, 2, 1), (SWORD, 2, -1), (SWORD, 0, -1), (SWORD, 1, 1), (LEAF, 2, 1), (LEAF, 2, -1)]
TURNED = np.array([0.3, 0.5, -0.2])


def primitive(shape, center=(0.0, 0.0, 0.0), turn=(0.0, 0.0, 0.0)):
    low, high, wide, thick, tip, slim = shape
    lengths = np.array([wide, thick, high - tip - low, tip, slim])
    return Primitive("blade", np.array(center), np.array(turn), lengths)


def planes(shape):
    """Of its sides: normals outwards, and how far inside each the origin is."""
    low, high, wide, thick, tip, slim = shape
    across = np.array([(wide, 0), (0, thick), (-wide, 0), (0, -thick)])
    rings = [np.c_[k * across, np.full(4, z)] for k, z in ((1, low), (slim, high - tip))]
    found = ConvexHull(np.concatenate([*rings, [(0, 0, high)]])).equations
    return found[:, :3], found[:, 3]


def places(count=4000, reach=1.2):
    return np.random.default_rng(0).uniform(-reach, reach, (count, 3))


def turned(solid, axis, up):
    """The solid along an axis, its upper end towards this axis' end or its beginning."""

    def distance(p):
        x, y, z = p.roll(2 - axis, 1).unbind(1)
        return solid(torch.stack([x, y * up, z * up], 1))

    return distance


def drawn(solid):
    """As a network draws it: the mean over places nearby."""
    some = NETWORK * torch.randn(4, 1, 3, generator=torch.Generator().manual_seed(0))
    both = torch.tensor([1.0, -1.0])
    apart = (some * torch.cartesian_prod(both, both, both)).view(-1, 3)
    return lambda p: torch.stack([solid(p + by) for by in apart]).mean(0)[:, None]


def component_of(distances):
    (place,) = places_of(distances, 1)
    return drawn_at(distances, place)


def forms_of(solid, flat):
    return [
        component.primitive and component.primitive.form
        for component in KnownParts(drawn(solid), Forms((flat,), ((0.0,),) * 3)).components
    ]


@pytest.mark.parametrize("shape", [SWORD, LEAF], ids=["sword", "leaf"])
def test_a_blade_has_the_mesh_of_its_distance(shape):
    one = primitive(shape, (0.1, -0.2, 0.3), TURNED)
    verts, faces = one.mesh(0.05)
    found = health(verts, faces)
    assert is_solid(verts, faces) and found["components"] == 1 and found["genus"] == 0
    wide, thick, shoulder, tip, slim = one.lengths
    # A pyramid without its tip, and a pyramid, of a lozenge.
    area = 2 * wide * thick
    volume = area * (shoulder * (1 + slim + slim**2) + tip * slim**2) / 3
    assert found["volume"] == pytest.approx(volume, rel=1e-4)
    edges = verts[faces] - verts[faces].roll(1, 1)
    assert edges.norm(dim=2).max() < 4 * 0.05  # its sides are long
    on = sample_surface(verts, faces, 500, torch.Generator().manual_seed(0))
    assert one.distance(torch.cat([verts, on])).abs().max() < 1e-5
    middle = torch.from_numpy(one.center + one.frame[:, 2] * shoulder).float()
    inside = middle + 0.9 * (on - middle)
    outside = middle + 1.1 * (on - middle)
    assert one.distance(inside).max() < -1e-3 and one.distance(outside).min() > 1e-3


@pytest.mark.parametrize("shape", [SWORD, LEAF], ids=["sword", "leaf"])
def test_a_blade_s_distance_is_from_the_farthest_of_its_sides_planes(shape):
    normals, off = planes(shape)
    points = places()
    farthest = (points @ normals.T + off).max(1)
    np.testing.assert_allclose(
        primitive(shape, (0.0, 0.0, shape[0])).at(points), farthest, atol=1e-9
    )
    solid = lozenge_blade(*shape)
    given = solid(torch.from_numpy(points)).numpy()
    np.testing.assert_allclose(given, farthest, atol=1e-9)
    assert (given < 0).any() and (given > 0).any()


@pytest.mark.parametrize("shape", [SWORD, LEAF], ids=["sword", "leaf"])
def test_a_lozenge_blade_is_the_same_on_both_sides_and_never_beyond_the_distance(shape):
    solid = lozenge_blade(*shape)
    points = torch.from_numpy(places(400))
    for mirror in ((-1, 1, 1), (1, -1, 1)):
        torch.testing.assert_close(solid(points), solid(points * torch.tensor(mirror)))
    verts, faces = primitive(shape, (0.0, 0.0, shape[0])).mesh(0.02)
    nearest = torch.cdist(points, verts.double()).amin(1)
    given = solid(points)
    assert (given.abs() < nearest + 1e-6).all()
    # And the distance itself, right above and below the middles of its mesh's faces.
    corners = verts[faces].double()
    normals = torch.linalg.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    for by in (-1e-3, 1e-3):
        given = solid(corners.mean(1) + by * torch.nn.functional.normalize(normals, dim=1))
        torch.testing.assert_close(given, torch.full_like(given, by), atol=2e-5, rtol=0)


@pytest.mark.parametrize(("shape", "axis", "up"), CASES)
def test_a_blade_is_found_again_with_the_point_that_a_network_rounds_off(shape, axis, up):
    component = component_of(drawn(turned(lozenge_blade(*shape), axis, up)))
    one = blade(component)
    assert one is not None and one.fits(points_of(component), component.error)
    low, high, *_ = shape
    begin, end = (one.center + by * one.frame[:, 2] for by in (0.0, one.lengths[2:4].sum()))
    assert np.delete(np.abs([begin, end]), axis, 1).max() < 0.01  # on the axis
    assert begin[axis] * up == pytest.approx(low, abs=0.01)
    # Of the tenth of a unit that is lost most comes back.
    assert high - float((component.verts[:, axis] * up).max()) > 0.09
    assert end[axis] * up == pytest.approx(high, abs=0.05)
    wanted = primitive(shape).lengths
    np.testing.assert_allclose(one.lengths[[0, 1, 2, 4]], wanted[[0, 1, 2, 4]], rtol=0.07)
    np.testing.assert_allclose(
        one.lengths[3], wanted[3], rtol=0.12
    )  # its tip's, known from the fewest points


@pytest.mark.parametrize(("flat", "is_blade"), [(0.5, False), (0.66, True), (1.0, True)])
def test_a_component_is_a_blade_only_where_the_part_is_mostly_flat(flat, is_blade):
    assert (forms_of(lozenge_blade(*SWORD), flat) == ["blade"]) == is_blade


def test_a_board_is_a_box_and_fits_no_blade():
    board = box((0.0, 0.0, 0.0), (0.2, 0.1, 0.6))
    assert forms_of(board, 1.0) == ["box"]
    component = component_of(drawn(board))
    one = blade(component)
    assert one is not None and not one.fits(points_of(component), component.error)


@pytest.mark.parametrize(("long", "is_long"), [(0.9, False), (1.3, True)])
def test_what_is_hardly_longer_than_wide_is_no_blade(long, is_long):
    shape = (-0.4, -0.4 + long, 0.4, 0.3, 0.4, 0.9)
    assert (blade(component_of(drawn(lozenge_blade(*shape)))) is not None) == is_long


def test_a_small_blade_is_none_of_the_round_forms_that_are_near_it():
    small = lozenge_blade(-0.28, 0.29, 0.054, 0.042, 0.4, 2.5)
    assert forms_of(small, 1.0) == ["blade"]
