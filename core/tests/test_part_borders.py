"""Points near a border between two parts go into their own part, along the surface."""

import pytest
import torch

from core.geometry.tet_grid import EXTENT
from core.guidance.builtin.guidance import load_builtin
from core.guidance.builtin.part_borders import INSET, PartBorders


def _ball(radius=0.6):
    """A ball; the second part is what lies at x > 0."""

    def field(points):
        x = points[:, 0]
        return points.norm(dim=1) - radius, torch.stack([-8 * x, 8 * x], 1)

    return PartBorders(field), field


def _on_the_ball(count=2000, radius=0.6):
    points = torch.randn(count, 3, generator=torch.Generator().manual_seed(0))
    return radius * points / points.norm(dim=1, keepdim=True)


def test_a_point_near_the_border_goes_to_the_inset_and_others_stay():
    borders, _ = _ball()
    points = _on_the_ball()
    moved = borders.inside(points)
    near = points[:, 0].abs() < INSET / 2
    assert near.sum() > 20
    # On the ball the way to the border is an arc; at x = 0 its tangent is the x axis.
    assert moved[near, 0].abs().min() > 0.8 * INSET
    assert moved[near, 0].abs().max() < 1.2 * INSET
    assert torch.equal(moved[near, 0] > 0, points[near, 0] > 0)  # in the part that it was in
    far = points[:, 0].abs() > 1.5 * INSET
    assert (moved - points)[far].norm(dim=1).max() < 0.002


def test_a_moved_point_stays_on_the_surface():
    borders, field = _ball()
    points = _on_the_ball()
    before, after = (field(p)[0] for p in (points, borders.inside(points)))
    assert (after - before).abs().max() < 0.004


def test_a_part_smaller_than_the_inset_is_not_left():
    def field(points):  # a disc of radius 0.04 on a plane
        r = points[:, :2].norm(dim=1)
        return points[:, 2], torch.stack([20 * (r - 0.04), 20 * (0.04 - r)], 1)

    borders = PartBorders(field)
    angle = torch.arange(32) * (2 * torch.pi / 32)
    points = 0.035 * torch.stack([angle.cos(), angle.sin(), torch.zeros(32)], 1)
    moved = borders.inside(points)
    assert moved[:, :2].norm(dim=1).max() < 0.035
    assert moved[:, 2].abs().max() < 1e-3


def test_the_axes_are_those_of_the_field():
    def field(points):
        x, y, z = points.unbind(1)
        return z - 0.2, torch.stack([x + 2 * y, -x - 2 * y + 0.3], 1)

    points = (torch.rand(100, 3, generator=torch.Generator().manual_seed(1)) - 0.5) * EXTENT
    values = PartBorders(field)._at(points)
    distance, logits = field(points)
    torch.testing.assert_close(values, torch.cat([distance[:, None], logits], 1), atol=1e-4, rtol=0)


@pytest.mark.parametrize(("prompt", "has"), [("a robot", True), ("a ball", False)])
def test_a_drawn_object_of_several_parts_has_borders(prompt, has):
    prompted = load_builtin("cpu").prompted(prompt, "")
    assert prompted.colored_at() is None  # not drawn yet
    inside = prompted.of_object(0).colored_at()
    assert (inside is not None) == has
    if inside:
        points = torch.zeros(1, 3)
        assert inside(points).shape == points.shape
