"""The families' solids: distances that sphere tracing may trust, sizes, and topology."""

import math
from collections.abc import Callable, Iterable
from unittest import mock

import pytest
import torch
from scipy.spatial import KDTree

from core.geometry.marching_tets import marching_tets
from core.geometry.mesh import health
from core.geometry.tet_grid import tet_grid
from core.guidance.builtin.nouns import NOUNS
from core.guidance.builtin.stretch import STRETCH
from core.guidance.builtin.words.tables.part_tables import OPTIONS
from core.prior import families
from core.prior.draw import Draw
from core.prior.families import FAMILIES, Shape, build, surface_points
from core.prior.solids import (
    Solid,
    around,
    ball,
    blend,
    both,
    box,
    capsule,
    cut,
    egg,
    ellipsoid,
    join,
    lathe,
    limb,
    moved,
    polygon,
    prism,
    ring,
    taper,
    tilted,
    tube,
    turned,
)


def _draw(seed: int = 0, stated: str = "", adjective: str = "") -> Draw:
    return Draw(torch.Generator().manual_seed(seed), stated, adjective)


def _points(count: int, reach: float = 1.5, seed: int = 0) -> torch.Tensor:
    return (torch.rand(count, 3, generator=torch.Generator().manual_seed(seed)) * 2 - 1) * reach


def _each_family(check: Callable[[str], None], nouns: Iterable[str] = FAMILIES) -> None:
    """Check all nouns in one test, which costs less than a test for each; name all that fail."""
    wrong = []
    for noun in nouns:
        try:
            check(noun)
        except AssertionError as error:
            wrong.append(f"{noun}: {error}")
    assert not wrong, "\n".join(wrong)


@pytest.mark.parametrize("first", [0, *(pytest.param(k, marks=pytest.mark.slow) for k in (1, 2))])
def test_a_family_is_normalised_and_its_distance_is_a_lower_bound(first):
    _each_family(_is_normalised_and_a_lower_bound, [*FAMILIES][first::3])


def _is_normalised_and_a_lower_bound(noun: str) -> None:
    asked = []

    def seen(sdf: Solid) -> torch.Tensor:
        asked.append(surface_points(sdf))
        return asked[-1]

    with mock.patch.object(families, "surface_points", seen):
        shape = build(noun, "", _draw(), jitter=0)
    found = asked[0]  # in the family's own frame
    surface = (found - torch.tensor(shape.center)) * torch.tensor(shape.scale)
    low, high = surface.amin(0), surface.amax(0)
    assert ((low + high) / 2).abs().max() < 0.02
    assert surface.norm(dim=1).max().item() == pytest.approx(0.9, abs=0.02)
    points = _points(400)
    ends = _beyond(surface)
    sizes = [len(surface), len(ends), len(points)]
    on, out, distance = shape.sdf(torch.cat([surface, ends, points])).split(sizes)
    assert on.abs().max() < 0.02
    assert out.min() > 0.002, "it goes on where the lattice ends that its surface was found on"
    to_surface = torch.from_numpy(KDTree(surface.numpy()).query(points.numpy())[0])
    assert (distance.abs() <= to_surface + 0.02).all()
    # Not far below it either, where tracing would take many steps.
    outside = distance > 0.2
    assert (distance[outside] / to_surface[outside]).median() > 0.5


def _beyond(surface: torch.Tensor) -> torch.Tensor:
    """Places just beyond the surface's ends, each opposite a surface point near an end."""
    found = []
    for axis in range(3):
        for side in (-1.0, 1.0):
            end = (side * surface[:, axis]).amax()
            near = surface[side * surface[:, axis] > end - 0.1]
            near[:, axis] = side * (end + 0.05)
            found.append(near)
    return torch.cat(found)


def test_a_distance_never_changes_faster_than_the_way():
    _each_family(_is_nowhere_too_steep)


def _is_nowhere_too_steep(noun: str) -> None:
    """In the family's own frame, because the other frame takes longer; stretched like "tall"."""
    parts = FAMILIES[noun](_draw(1, adjective="tall"))
    shape = Shape(parts, (0.0, 0.0, 0.7), STRETCH["tall"][0])
    a, b = _points(6000, 2.4, seed=1), _points(6000, seed=2) * 0.02
    steepness = (shape.sdf(a + b) - shape.sdf(a)).abs() / b.norm(dim=1)
    assert steepness.max() < (1.4 if noun == "mushroom" else 1.02)


@pytest.mark.parametrize(
    ("noun", "stated", "genus"),
    [
        *(("torus", "", 1), ("mug", "handle", 1), ("mug", "no handle", 0), ("ball", "", 0)),
        # Between its legs a bar on each side, between seat and rail a board.
        *(("chair", "no armrests", 4), ("chair", "armrests", 6), ("bucket", "handle", 1)),
        *(("teapot", "", 1), ("crown", "", 1), ("trophy", "", 2), ("arch", "", 0)),
    ],
)
def test_a_family_has_the_topology_of_its_word(noun, stated, genus):
    shape = build(noun, "", _draw(2, stated))
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

    plain, tall, flat, wide, thin = (extent(w) for w in ("", "tall", "flat", "wide", "thin"))
    assert tall[2] / tall[0] > 1.3 * plain[2] / plain[0]
    assert flat[2] / flat[0] < 0.7 * plain[2] / plain[0]
    assert wide[0] / wide[1] > 1.3 * plain[0] / plain[1]
    assert thin[1] / thin[0] < 0.75 * plain[1] / plain[0]


def test_round_and_thick_things_are_fuller_and_round_ones_nearer_to_a_ball():
    def extent(noun: str, adjective: str) -> torch.Tensor:
        points = surface_points(build(noun, adjective, _draw(4), jitter=0).sdf, 2.4)
        return points.amax(0) - points.amin(0)

    plain, full = extent("bookshelf", ""), extent("bookshelf", "round")
    assert full[1] / full[2] > 1.3 * plain[1] / plain[2]
    volume = {}
    for adjective in ("", "thick", "round"):
        points = _points(20000, 1.0, seed=5)
        inside = build("chair", adjective, _draw(3), jitter=0).sdf(points) < 0
        volume[adjective] = inside.float().mean()
    assert min(volume["thick"], volume["round"]) > 1.3 * volume[""]


def test_the_parts_are_those_that_have_a_look_in_their_order():
    _each_family(_has_the_parts_that_have_a_look)


def _has_the_parts_that_have_a_look(noun: str) -> None:
    """A part that an object may lack comes last, so that the others keep their index."""
    for stated in ("", *OPTIONS.get(noun, ())):
        for seed in range(4):
            names = list(FAMILIES[noun](_draw(seed, stated)))
            assert names == list(NOUNS[noun].looks)[: len(names)]


@pytest.mark.parametrize("noun", [n for n, o in OPTIONS.items() if f"no {o[0]}" in o])
def test_a_part_is_there_if_and_only_if_it_is_stated(noun):
    part = OPTIONS[noun][0]
    volumes = []
    for stated in (part, f"no {part}"):
        solids = FAMILIES[noun](_draw(6, stated)).values()
        points = _points(60000, 2.4, seed=7)
        points[:, 2] += 0.8
        volumes.append((join(*solids)(points) < 0).float().mean())
    assert volumes[0] > volumes[1]


def test_there_are_as_many_legs_as_stated():
    for noun, stated, count in (("stool", "three legs", 3), ("stool", "four legs", 4)):
        shape = build(noun, "", _draw(1, stated), jitter=0)
        surface = surface_points(shape.sdf, 2.4)
        feet = surface[surface[:, 2] < surface[:, 2].min() + 0.08, :2]
        near = torch.cdist(feet, feet) < 0.25
        groups = (near.float() @ near.float() > 0).float()
        assert torch.linalg.matrix_rank(groups) == count


def test_new_solids_agree_with_slow_ones():
    points = _points(500)
    torch.testing.assert_close(
        taper((0, 0, 0), (0.3, 0.2, 0.5), 0.2, 0.2)(points),
        capsule((0, 0, 0), (0.3, 0.2, 0.5), 0.2)(points),
        atol=1e-5,
        rtol=0,
    )
    fraction = torch.linspace(0, 1, 4001)[:, None]  # a row of shrinking balls
    start, end = torch.tensor([0.0, 0.1, -0.4]), torch.tensor([0.2, 0.0, 0.5])
    row = start + fraction * (end - start)
    slow = (torch.cdist(points, row) - (0.3 - 0.2 * fraction.T)).amin(1)
    fast = taper((0, 0.1, -0.4), (0.2, 0, 0.5), 0.3, 0.1)(points)
    torch.testing.assert_close(fast, slow, atol=1e-4, rtol=0)
    pair = ball((0.5, 0, 0), 0.2), ball((-0.5, 0, 0), 0.2)
    torch.testing.assert_close(both(pair[0])(points), join(*pair)(points))
    torch.testing.assert_close(around(2, pair[0])(points), join(*pair)(points), atol=1e-5, rtol=0)
    torch.testing.assert_close(moved(pair[1], (1, 0, 0))(points), pair[0](points))
    up = ball((0, 0.5, 0), 0.2)
    torch.testing.assert_close(turned(pair[0], 2, 90)(points), up(points), atol=1e-5, rtol=0)
    filled = blend(0.1, *pair)(points)
    assert (filled <= join(*pair)(points) + 1e-6).all()
    assert (filled >= join(*pair)(points) - 0.025 - 1e-6).all()
    outside = egg((0, 0, 0), (0.3, 0.5, 0.4))(points)
    assert (outside <= points.norm(dim=1) - 0.3 + 1e-5).all()


def test_every_shape_word_has_its_stretch():
    for adjective in STRETCH:
        shape = build("bottle", adjective, _draw(1), jitter=0)
        assert surface_points(shape.sdf, 2.4).norm(dim=1).max().item() == pytest.approx(
            0.9, abs=0.03
        )


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


def test_a_limb_tapers_evenly_through_its_points():
    a, b, c = (0.0, 0.0, 0.0), (0.4, 0.1, 0.0), (0.4, 0.5, 0.3)
    halves = join(taper(a, b, 0.3, 0.2), taper(b, c, 0.2, 0.1))
    points = _points(500)
    torch.testing.assert_close(limb([a, b, c], 0.3, 0.1)(points), halves(points))


def test_what_is_tilted_has_its_front_lower():
    """A ball in front of the middle, which is to -Y."""
    low = tilted(ball((0, -1, 0), 0.1), 30, (0, 0, 2))
    front = torch.tensor([[0.0, -math.cos(math.pi / 6), 2 - 0.5]])
    torch.testing.assert_close(low(front), torch.tensor([-0.1]), atol=1e-6, rtol=0)


def test_an_arrangement_is_one_of_few_and_the_same_in_every_object():
    seen = {Draw(torch.Generator().manual_seed(seed)).arranged(3)(0, 1) for seed in range(40)}
    assert len(seen) == 3


def test_what_a_family_chooses_is_noted_but_not_its_proportions():
    draw = _draw(3, "handle")
    drawn = [draw(0, 1), draw.chance(0.5), draw.which(4), draw.has("handle", 0.0), draw.legs(3, 4)]
    assert draw.choices == drawn[1:]
    shaped = draw.formed("round")
    draw.arranged(5)
    assert (shaped.adjective, shaped.part_state, shaped.choices) == (
        "round",
        "handle",
        draw.choices,
    )
    assert len(draw.choices) == 5


def test_a_form_is_stated_or_drawn_and_is_one_choice_either_way():
    stated = Draw(torch.Generator().manual_seed(0), adjective="round")
    assert [stated.shaped("round", 0.0) for _ in range(3)] == [True] * 3
    drawn = Draw(torch.Generator().manual_seed(0))
    found = [drawn.shaped("round", 0.3) for _ in range(200)]
    assert 0.2 < sum(found) / len(found) < 0.4
    assert drawn.choices == [int(one) for one in found]
    assert stated.choices == [1] * 3


def test_a_ring_has_a_hole_and_a_cut_removes():
    p = torch.tensor([[0.0, 0.0, 0.0], [1.0, 0.0, 0.0]])
    torch.testing.assert_close(ring((0, 0, 0), 1.0, 0.3)(p), torch.tensor([0.7, -0.3]))
    solid = cut(box((0, 0, 0), (1, 1, 1)), box((0, 0, 0), (0.5, 0.5, 2)))
    torch.testing.assert_close(
        solid(torch.tensor([[0.0, 0.0, 0.0], [0.75, 0.0, 0.0]])), torch.tensor([0.5, -0.25])
    )
