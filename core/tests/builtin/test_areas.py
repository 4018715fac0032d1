"""The areas of one colour: points near a border go into their own area, along the surface."""

import pytest
import torch

from core.geometry.parts import components
from core.geometry.tet_grid import EXTENT
from core.guidance.builtin.areas import FLUSH, INSET, SolidAreas, patterned
from core.guidance.builtin.palette import FINISHES, looks
from core.guidance.builtin.patterns import (
    BAND,
    COIN,
    COIN_RIM,
    COIN_ROW,
    KEY,
    KEY_GAP,
    KEY_SHIFT,
    MARGINS,
    PLATE,
    PLATE_LINE,
    RAINBOW,
    Laid,
)
from core.tests.drawn_things import shipped_prior
from core.tests.texture_shapes import area as any_area

TWO = (any_area(), any_area())


def _ball(radius=0.6):
    """A ball; the second part is what lies at x > 0."""

    def field(points):
        x = points[:, 0]
        return points.norm(dim=1) - radius, torch.stack([-x, x], 1)

    return SolidAreas(field, TWO), field


def at(areas, points):
    """The area of each point, and where it takes its material from."""
    area = areas.of(points)
    return area, areas.inside(points, area)


def _on_the_ball(count=2000, radius=0.6):
    points = torch.randn(count, 3, generator=torch.Generator().manual_seed(0))
    return radius * points / points.norm(dim=1, keepdim=True)


def test_a_point_near_the_border_goes_to_the_inset_and_others_stay():
    borders, _ = _ball()
    points = _on_the_ball()
    area, moved = at(borders, points)
    near = points[:, 0].abs() < INSET / 2
    assert near.sum() > 20
    # On the ball the way to the border is an arc; at x = 0 its tangent is the x axis.
    assert moved[near, 0].abs().min() > 0.8 * INSET
    assert moved[near, 0].abs().max() < 1.2 * INSET
    assert torch.equal(moved[near, 0] > 0, points[near, 0] > 0)  # in the area that it was in
    assert torch.equal(area == 1, points[:, 0] > 0)
    far = points[:, 0].abs() > 1.5 * INSET
    assert (moved - points)[far].norm(dim=1).max() < 0.002


def test_a_place_is_told_to_be_clear_where_no_border_is_near():
    borders, _ = _ball()
    points = _on_the_ball()
    area, clear = borders.certain(points, 0.0)
    assert torch.equal(area == 1, points[:, 0] > 0)
    assert torch.equal(clear, 2 * points[:, 0].abs() >= FLUSH)
    _, clear = borders.certain(points, 0.1)  # of a coarse texture
    assert torch.equal(clear, points[:, 0].abs() >= 0.1)
    one = SolidAreas(lambda p: (p[:, 0], p[:, :1]), TWO[:1], cells=4)
    area, clear = one.certain(points, 0.0)
    assert clear.all() and not area.any()


def test_a_moved_point_stays_on_the_surface():
    borders, field = _ball()
    points = _on_the_ball()
    before, after = (field(p)[0] for p in (points, at(borders, points)[1]))
    assert (after - before).abs().max() < 0.004


def test_a_slanted_border_is_left_along_the_surface():
    def field(points):
        x, _, z = points.unbind(1)
        return z, torch.stack([-x - z, x + z], 1)

    borders = SolidAreas(field, TWO, cells=20)
    points = torch.tensor([[0.01, 0.1, 0.0], [-0.02, 0.3, 0.0]])
    moved = at(borders, points)[1]
    expected = torch.tensor([[INSET, 0.1, 0.0], [-INSET, 0.3, 0.0]])
    torch.testing.assert_close(moved, expected, atol=1e-4, rtol=0)


def test_a_part_smaller_than_the_inset_is_not_left():
    def field(points):  # a disc of radius 0.04 on a plane
        r = points[:, :2].norm(dim=1)
        return points[:, 2], torch.stack([r - 0.04, 0.04 - r], 1)

    borders = SolidAreas(field, TWO)
    angle = torch.arange(32) * (2 * torch.pi / 32)
    points = 0.035 * torch.stack([angle.cos(), angle.sin(), torch.zeros(32)], 1)
    moved = at(borders, points)[1]
    assert moved[:, :2].norm(dim=1).max() < 0.035
    assert moved[:, 2].abs().max() < 1e-3


def test_the_axes_are_those_of_the_field():
    def field(points):
        x, y, z = points.unbind(1)
        return z - 0.2, torch.stack([x + 2 * y, -x - 2 * y + 0.3], 1)

    points = (torch.rand(100, 3, generator=torch.Generator().manual_seed(1)) - 0.5) * EXTENT
    values = SolidAreas(field, TWO)._at(points)
    distance, logits = field(points)
    torch.testing.assert_close(values, torch.cat([distance[:, None], logits], 1), atol=1e-4, rtol=0)


def test_a_pattern_parts_its_part_in_two():
    def field(points):  # two parts, left and right of x = 0
        x = points[:, 0]
        return points[:, 2], torch.stack([-x, x], 1)

    areas = patterned(field, [Laid("two-tone").margins(), None])
    points = torch.tensor([[-0.5, 0, 0.3], [-0.5, 0, -0.3], [0.5, 0, 0.3], [0.5, 0, -0.3]])
    distance, depths = areas(points)
    assert depths.argmax(1).tolist() == [0, 1, 2, 2]
    assert torch.equal(distance, points[:, 2])
    # The margin between the two is the way to the border.
    assert (depths[0, 0] - depths[0, 1]).item() == pytest.approx(0.3)


def test_a_rainbow_parts_its_part_in_six_as_deep_as_they_are_wide():
    def field(points):
        return points[:, 2], torch.ones(len(points), 1)

    points = torch.tensor([[0, 0, -BAND * (k + 0.5)] for k in range(8)])
    depths = patterned(field, [Laid(RAINBOW).margins()])(points)[1]
    assert depths.argmax(1).tolist() == [0, 1, 2, 3, 4, 5, 0, 1]
    # The margin over the next one is the way to the border.
    first, second = depths.topk(2, 1).values.T
    assert (first - second).tolist() == pytest.approx([BAND / 2] * 8)


@pytest.mark.parametrize("name", MARGINS)
def test_a_pattern_is_as_far_from_its_border_as_it_says(name):
    points = torch.rand(4000, 3, generator=torch.Generator().manual_seed(2)) * 2 - 1
    margin = MARGINS[name](points)
    assert 0.08 < (margin > 0).float().mean() < 0.6
    near = margin.abs() < 0.03
    way = torch.randn(int(near.sum()), 3, generator=torch.Generator().manual_seed(3))
    moved = points[near] + way * (margin[near].abs() / way.norm(dim=1) * 0.6)[:, None]
    # What goes less far than the margin stays on its side.
    assert ((MARGINS[name](moved) > 0) == (margin[near] > 0)).float().mean() > 0.99


@pytest.mark.parametrize("name", ["scales", "waffle"])
def test_lines_that_meet_at_the_axis_are_as_near_as_they_say(name):
    """At a cone's tip a turn is a short way."""
    points = torch.rand(4000, 3, generator=torch.Generator().manual_seed(4)) * 0.1 - 0.05
    margin = MARGINS[name](points)
    way = 0.6 * margin.abs()[:, None] * points.roll(1, 1) / points.norm(dim=1, keepdim=True)
    stays = (MARGINS[name](points + way) > 0) == (margin > 0)
    assert stays.float().mean() > 0.97


def test_a_turtles_plates_are_hexagons():
    """Lines half way to each of the six next plates, which are all as far."""
    turns = torch.deg2rad(torch.arange(0.0, 360, 60) + 90)
    around = torch.stack([turns.cos(), turns.sin(), 0 * turns], 1)
    middles, borders = (MARGINS["plates"](around * far) for far in (PLATE, PLATE / 2))
    assert torch.allclose(middles, torch.full((6,), PLATE_LINE - PLATE / 2), atol=1e-5)
    assert torch.allclose(borders, torch.full((6,), PLATE_LINE), atol=1e-5)


def test_a_basketball_has_two_circles_and_a_curve_at_either_side():
    """Points as (x, z) of its front, which is a disc of radius .9."""
    lines = [(0.0, 0.5), (0.25, 0.0), (0.73, 0.5), (0.49, 0.05)]
    fields = [(0.25, 0.3), (0.8, 0.2), (0.3, 0.7)]
    for x, z in lines + fields:
        sides = torch.tensor(
            [(i * x, y, k * z) for i in (1, -1) for y in (0.2, -0.2) for k in (1, -1)]
        )
        assert ((MARGINS["seams"](sides) > 0) == ((x, z) in lines)).all(), (x, z)


@pytest.mark.usefixtures("coarse")  # the weights
@pytest.mark.parametrize(
    ("prompt", "plain"),
    [
        ("a blue chair", (True,) * 4),
        ("a red ball with white stripes", (True, True)),
        ("a lighthouse", (True,) * 6),  # its rings are known, though no words ask for them
        ("a turtle", (True,) * 4),  # the plates of its shell too
        ("a tower", (False, True, True)),  # its bricks are learnt
    ],
)
def test_the_areas_of_what_is_drawn(prompt, plain, monkeypatch):
    monkeypatch.setattr(components, "SEARCH", 40)  # an eighth of the time
    prompted = shipped_prior().prompted(prompt, "")
    assert prompted.areas() is None  # not drawn yet
    areas = prompted.of_object(0).areas()
    assert tuple(one.plain for one in areas.each[: len(plain)]) == plain
    points = torch.rand(50, 3) - 0.5
    area, inside = at(areas, points)
    assert torch.equal(areas.of(points), area)
    assert area.max() < len(areas.each) and inside.shape == (50, 3)


@pytest.mark.usefixtures("coarse")
def test_a_striped_rug_has_stripes_across_it(monkeypatch):
    """Level ones, as a mast's, would leave what lies in one colour."""
    monkeypatch.setattr(components, "SEARCH", 40)
    prompted = shipped_prior().prompted("a red and white striped rug", "").of_object(0)
    areas, size = prompted.areas(), prompted.parts().extents()[0]
    along, across = (0, 1) if size[0] > size[1] else (1, 0)
    line = torch.zeros(400, 3)
    line[:, along] = torch.linspace(-0.45, 0.45, 400) * size[along]
    line[:, 2], line[:, across] = 0.49 * size[2], -0.2 * size[across]
    seen = areas.of(line)
    field = [k for k, one in enumerate(areas.each) if one.surface == areas.each[1].surface][:2]
    in_field = seen[(seen == field[0]) | (seen == field[1])]  # not the lozenge in its middle
    assert (in_field[1:] != in_field[:-1]).sum() >= 4
    line[:, across] *= -1
    assert (areas.of(line) == seen).float().mean() > 0.9, "straight across"


def test_a_border_is_where_the_exact_surfaces_say_and_a_flush_pane_is_seen():
    """The drawn border waves; the exact one is a plane, but for what lies just under the other."""

    def drawn(points):
        wave = 0.02 * (20 * points[:, 1]).sin()
        return points[:, 2], torch.stack([-points[:, 0] + wave, points[:, 0] - wave], 1)

    def exact(points, under=0.0):
        return points[:, 2], torch.stack([-points[:, 0], points[:, 0] - under], 1)

    x = torch.linspace(-0.05, 0.05, 41)
    points = torch.cartesian_prod(x, torch.linspace(-0.5, 0.5, 41), torch.zeros(1))
    area, _ = at(SolidAreas(drawn, TWO, exact), points)
    assert torch.equal(area, (points[:, 0] > 0).long()), (
        "surfaces that cross are parted by themselves"
    )
    area, _ = at(SolidAreas(drawn, TWO), points)
    assert points[area != (points[:, 0] > 0).long(), 0].abs().max() > 0.015
    # A pane that the wall's surface is just over is seen where it was drawn; one far under is not,
    # nor the wall on the pane.

    def pane(points):
        return points[:, 2], torch.stack([-points[:, 0] + 0.5, points[:, 0] - 0.5], 1)

    x = torch.linspace(0.46, 0.54, 33)
    points = torch.cartesian_prod(x, torch.linspace(-0.5, 0.5, 9), torch.zeros(1))
    inside = points[:, 0] > 0.501
    for under, seen in ((0.01, True), (0.2, False)):
        near = SolidAreas(pane, TWO, lambda p, u=under: (p[:, 2], wall_over(p, u)))
        assert bool((at(near, points)[0][inside] == 1).all()) == seen
    near = SolidAreas(pane, TWO, lambda p: (p[:, 2], wall_over(p, -0.01)))
    by_border = (points[:, 0] - 0.5).abs() < 0.03  # where the lattice does not tell
    assert (at(near, points)[0][by_border] == 1).all()


def wall_over(points, under):
    return torch.stack([-points[:, 2], -points[:, 2] - under], 1)


def test_the_nearest_areas_are_those_of_the_lattices_nodes():
    def field(points):  # parted by a plane that no axis is square to
        x, y, z = points.unbind(1)
        side = x + 2 * y + 4 * z
        return points[:, 0], torch.stack([-side, side], 1)

    areas = SolidAreas(field, TWO, cells=10)
    side = torch.linspace(-EXTENT, EXTENT, 11)
    nodes = torch.cartesian_prod(side, side, side)
    expected = field(nodes)[1].argmax(1).view(11, 11, 11)
    sure = field(nodes)[1].amax(1).view(11, 11, 11) > 1e-4
    assert torch.equal(areas.nearest()[sure], expected[sure])


@pytest.mark.usefixtures("coarse")  # the weights
def test_each_part_has_the_finish_that_the_words_and_nature_give_it(monkeypatch):
    monkeypatch.setattr(components, "SEARCH", 40)
    guidance = shipped_prior()

    def areas_of(prompt):
        parts = guidance.prompted(prompt, "")
        each = parts.of_object(0).areas().each
        return dict(zip(looks(parts.words.noun), each, strict=True))

    sword = areas_of("a sword")
    assert sword["blade"].ranges.metallic == (1.0, 1.0)
    assert sword["grip"].ranges.metallic == (0.0, 0.0)
    low, high = sword["blade"].ranges.roughness
    assert low < FINISHES["metal"].roughness < high < 0.35
    assert (sword["blade"].surface.kind, sword["grip"].surface.kind) == ("metal", "leather")
    car = areas_of("a golden car")
    assert car["body"].ranges.metallic == (1.0, 1.0)
    assert car["windows"].ranges.metallic == (0.0, 0.0)
    assert car["windows"].ranges.roughness[1] < 0.15 < 0.7 < car["wheels"].ranges.roughness[0]


def test_a_keyboards_keys_lie_in_rows_that_are_shifted():
    """A gap at every border of a key and none in its middle, in each of three rows."""
    for row in range(3):
        start = -KEY_SHIFT * row * KEY
        y = (row + 0.5) * KEY
        middles = torch.tensor([[start + (k + 0.5) * KEY, y, 0.2] for k in range(4)])
        borders = torch.tensor([[start + k * KEY, y, 0.2] for k in range(4)])
        below = middles - torch.tensor([0.0, KEY / 2, 0.0])
        assert torch.allclose(MARGINS["keys"](middles), torch.full((4,), KEY_GAP - KEY / 2))
        assert (MARGINS["keys"](borders) > 0).all() and (MARGINS["keys"](below) > 0).all()


def test_coins_lie_in_rows_each_over_the_one_behind():
    """Dark at the rim of the coin on top, and nowhere within it; none is seen through."""
    row = COIN * COIN_ROW
    middles = torch.tensor([[2 * row * k, 0.0, 0.03] for k in range(-2, 3)])
    assert (MARGINS["coins"](middles) < -COIN_RIM).all()
    turn = torch.linspace(0, torch.pi, 9)[1:-1]  # the back half of a rim, which lies on others
    half = torch.stack([turn.cos(), 0 * turn, turn.sin()], 1)
    assert (MARGINS["coins"](half * (COIN - 0.3 * COIN_RIM)) > 0).all()
    assert (MARGINS["coins"](half * (COIN - 1.7 * COIN_RIM)) < 0).all()
