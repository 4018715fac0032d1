"""Markings that stand out, or are sunk, in the normal map."""

from functools import partial

import pytest
import torch

from core.guidance.builtin import guidance as builtin
from core.guidance.builtin.areas import AreaFields, SolidAreas
from core.guidance.builtin.composition.composed import composed_heights
from core.guidance.builtin.composition.placing.placement import X_TO_Y, Placement
from core.guidance.builtin.markings.heights import (
    BY_NAME,
    BY_THING,
    FLAT,
    GROOVE,
    OF_PANE,
    RAISED,
    SUNK,
    Height,
    height_of,
)
from core.guidance.builtin.markings.marking import Marking
from core.guidance.builtin.markings.markings import Marked
from core.guidance.builtin.markings.table import MARKINGS
from core.tests.drawn_things import shipped_prior
from core.tests.texture_shapes import area as any_area

TWO = (any_area(), any_area())
BOX = torch.tensor([[-1.0, -1.0, -1.0], [1.0, 1.0, 1.0]])


def wall(monkeypatch, **rows):
    """A thing of one wall with markings on it."""
    name = "wall of a test"
    monkeypatch.setitem(MARKINGS, name, rows)
    return Marked(name, ["wall", *rows], [BOX, *[None] * len(rows)])


def square(half, points, _):
    return half - points[:, [0, 2]].abs().amax(1)


def along(places):
    """Points of the wall's front."""
    x = torch.as_tensor(places)
    return torch.stack([x, torch.full_like(x, -1.0), torch.zeros_like(x)], 1)


def test_every_name_with_a_height_is_a_markings():
    names = {part for parts in MARKINGS.values() for part in parts}
    listed = [name.replace("_", " ") for of in BY_NAME.values() for name in of.split()]
    assert set(listed) <= names and len(listed) == len(set(listed))
    for noun, parts in BY_THING.items():
        assert set(parts) <= set(MARKINGS[noun]), noun
    assert height_of("umbrella", "panels") == FLAT != height_of("wardrobe", "panels")
    assert height_of("zebra", "stripes") == FLAT


def test_what_is_raised_goes_up_within_its_border_and_ends_level():
    margins = RAISED.slope * torch.tensor([-9.0, 0.0, 0.5, 1.0, 9.0])
    assert torch.allclose(RAISED.at(margins), RAISED.high * torch.tensor([0, 0, 0.5, 1, 1]))


def test_a_pane_in_a_frame_is_sunk_below_both(monkeypatch):
    marked = wall(
        monkeypatch,
        windows=Marking("frames", partial(square, 0.3)),
        frames=Marking("wall", partial(square, 0.5)),
    )
    points = along([0.0, 0.4, 0.8])
    part = torch.tensor([1, 2, 0])
    levels = [OF_PANE.high + SUNK.high, OF_PANE.high, 0.0]
    assert torch.allclose(marked.height(points, part), torch.tensor(levels))
    # Of a wall's part it is the same: what is another part's has none of it.
    assert torch.allclose(marked.height(points, torch.zeros(3).long()), torch.tensor(levels))


def test_what_lies_on_top_takes_the_room_of_what_is_below_it(monkeypatch):
    """A groove that ends at a window's border does not go on under the glass."""
    marked = wall(
        monkeypatch,
        windows=Marking("wall", partial(square, 0.3)),
        seams=Marking("wall", lambda points, _: 0.012 - points[:, 2].abs()),
    )
    height = marked.height(along([0.0, 0.8]), torch.tensor([1, 2]))
    assert torch.allclose(height, torch.tensor([SUNK.high, GROOVE.high]))


def test_a_marking_on_one_part_is_not_felt_on_another(monkeypatch):
    name = "handle of a test"
    monkeypatch.setitem(MARKINGS, name, {"windows": Marking("wall", partial(square, 0.3))})
    marked = Marked(name, ["wall", "handle", "windows"], [BOX, BOX, None])
    height = marked.height(along([0.0, 0.0, 0.0]), torch.tensor([0, 1, 2]))
    assert torch.allclose(height, torch.tensor([SUNK.high, 0.0, SUNK.high]))


def _half(points):
    """Inside at y < 0; the second area is where x > 0."""
    return points[:, 1], torch.stack([-points[:, 0], points[:, 0]], 1)


def ramp(points, _area):
    return Height(0.1, 0.2).at(points[:, 0])


def test_the_slope_is_the_heights_along_the_surface_near_a_border():
    uneven = tuple(one._replace(level=False) for one in TWO)
    areas = SolidAreas(_half, uneven, heights=ramp, cells=40)
    x = torch.tensor([-0.05, 0.05, 0.9])
    points = torch.stack([x, 0 * x, 0 * x], 1)
    normals = torch.tensor([0.0, 1.0, 0.0]).expand(3, 3)
    slope = areas.slope(points, normals, areas.of(points), 1e-3)
    part = 0.05 / 0.2
    expected = 0.1 / 0.2 * 6 * part * (1 - part)
    assert slope[1, 0] == pytest.approx(expected, rel=1e-3)
    assert slope[[0, 2]].abs().max() == 0 and slope[:, 1:].abs().max() < 1e-6
    # Across the surface there is none, whichever way it faces.
    aside = torch.tensor([1.0, 0.0, 0.0]).expand(3, 3)
    assert areas.slope(points, aside, areas.of(points), 1e-3).abs().max() < 1e-6
    # None where nothing has a height, or the area is said to be level.
    for level in (SolidAreas(_half, uneven, cells=40), SolidAreas(_half, TWO, None, ramp, 40)):
        assert not level.slope(points, normals, areas.of(points), 1e-3).any()


def ball(points):
    return points.norm(dim=1) - 0.5, torch.zeros(len(points), 2)


def test_of_things_in_their_places_each_has_its_own_height_at_its_scale():
    shift = torch.tensor([0.5, 0.0, 0.0])
    places = [Placement(0.5, -shift, torch.eye(3)), Placement(0.5, shift, X_TO_Y)]
    one = AreaFields(ball, ball, TWO, lambda p, area: p[:, 0] + 10 * area)
    heights = composed_heights([one, one], [[Placement.of()], places])
    points = torch.tensor([[0.1, 0.0, 0.0], [-0.4, 0.0, 0.0], [0.5, 0.1, 0.0]])
    found = heights(points, torch.tensor([1, 2, 3]))
    # The third is of the second copy, which is turned: along its x lies y.
    assert torch.allclose(found, torch.tensor([10.1, 0.5 * 0.2, 0.5 * 10.2]))


@pytest.fixture(scope="module")
def house():
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(builtin, "SolidAreas", partial(SolidAreas, cells=40))
        one = shipped_prior().prompted("a house", "").of_object(0)
        return one, one.areas()


def test_a_houses_panes_lie_below_their_frames_and_its_doors_panels_stand_out(house):
    one, areas = house
    names = [part.name for part in one.painted.paints]
    parts = one.parts()
    verts = torch.cat([parts.surface_of(k)[0] for k in range(len(parts.components))])
    area = areas.of(verts)
    heights = areas.heights(verts, area)
    walls, panes, frames, door, panels = (
        heights[area == names.index(name)]
        for name in ("walls", "windows", "frames", "door", "panels")
    )
    uneven = {name for name, of in zip(names, areas.each, strict=True) if not of.level}
    assert uneven == {"windows", "frames", "panels", "seams"}
    assert panes.median() < walls.median() == 0 < frames.quantile(0.8)
    assert panels.max() > 0 == door.abs().max()


def test_a_basketballs_seams_go_in():
    painted = shipped_prior().prompted("a basketball", "").of_object(0).painted
    points = 0.9 * torch.tensor([[0.0, -1.0, 0.0], [0.2, -0.9, 0.4]])
    area = torch.zeros(2).long()
    assert torch.allclose(
        painted.area_fields(()).heights(points, area), torch.tensor([GROOVE.high, 0])
    )
    striped = shipped_prior().prompted("a basketball with white stripes", "").of_object(0).painted
    assert not striped.area_fields(()).heights(points, area).any()
