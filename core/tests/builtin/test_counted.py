"""Another number of similar components of a part."""

import numpy as np
import pytest
import torch

from core.geometry.parts.balls import balls_of
from core.geometry.parts.components import drawn_in, places_of
from core.geometry.parts.counted import recounted, similar_of
from core.guidance.builtin.counted_solid import CountedSolid
from core.guidance.builtin.guidance import PromptedBuiltin
from core.guidance.builtin.words.phrases.slots import Words
from core.guidance.builtin.words.vocabulary import parse
from core.tests.drawn_things import shipped_prior


def box(points, center, half):
    q = (points - torch.tensor(center)).abs() - torch.tensor(half)
    return q.clamp_min(0).norm(dim=1) + q.amax(1).clamp_max(0)


def ball(points, center, radius):
    return (points - torch.tensor(center)).norm(dim=1) - radius


def around(radius, count):
    angle = 2 * np.pi * np.arange(count) / count
    return [(float(radius * np.cos(a)), float(radius * np.sin(a))) for a in angle]


def cake(points):
    """A cake, three candles and their flames."""
    candles = [box(points, (*at, 0.25), (0.05, 0.05, 0.2)) for at in around(0.35, 3)]
    flames = [ball(points, (*at, 0.5), 0.06) for at in around(0.35, 3)]
    each = (torch.stack(candles).amin(0), torch.stack(flames).amin(0))
    return torch.stack([box(points, (0, 0, -0.15), (0.6, 0.6, 0.25)), *each], 1)


def dresser(points):
    """A body, and four drawers with handles one above another."""
    heights = (-0.45, -0.15, 0.15, 0.45)
    drawers = [box(points, (0, -0.32, z), (0.4, 0.05, 0.12)) for z in heights]
    handles = [box(points, (0, -0.42, z), (0.1, 0.06, 0.03)) for z in heights]
    each = (torch.stack(drawers).amin(0), torch.stack(handles).amin(0))
    return torch.stack([box(points, (0, 0, 0), (0.5, 0.3, 0.65)), *each], 1)


def table(points):
    """A top, and four legs that a frame below it joins."""
    at = [(x, y) for x in (-0.6, 0.6) for y in (-0.35, 0.35)]
    legs = [box(points, (*xy, -0.3), (0.06, 0.06, 0.4)) for xy in at]
    frame = box(points, (0, 0, 0.03), (0.66, 0.41, 0.08))
    top = box(points, (0, 0, 0.16), (0.75, 0.5, 0.06))
    return torch.stack([top, torch.stack([*legs, frame]).amin(0)], 1)


def face(points):
    """A head with a pair of eyes."""
    eyes = torch.stack([ball(points, (x, -0.55, 0.1), 0.14) for x in (-0.22, 0.22)])
    return torch.stack([ball(points, (0, 0, 0), 0.6), eyes.amin(0)], 1)


def nest(points):
    """Three eggs that touch, on a board."""
    eggs = torch.stack([ball(points, (*at, 0.1), 0.2) for at in around(0.22, 3)])
    return torch.stack([box(points, (0, 0, -0.2), (0.7, 0.7, 0.15)), eggs.amin(0)], 1)


def drawn(distances, parts):
    return [one for place in places_of(distances, parts) for one in drawn_in(distances, place)]


def counted(distances, parts, count):
    """The boxes' middles of the copies of part 1, and all copies."""
    components = drawn(distances, parts)
    found = recounted(distances, components, 1, count)
    if found is None:
        return None, None, components
    whole = dict(enumerate(components)) | dict(found.apart)
    verts = {k: one.verts for k, one in whole.items()}
    verts |= {k: one.points() for k, one in found.balls.items()}
    placed = [copy.out(verts[copy.source]) for copy in found.copies if copy.part == 1]
    middles = torch.stack([(v.amin(0) + v.amax(0)) / 2 for v in placed]) if placed else None
    return middles, found, components


@pytest.mark.parametrize("count", [2, 4, 5, 8])
def test_candles_are_on_a_ring_each_with_its_flame(count):
    middles, found, _ = counted(cake, 3, count)
    assert len(middles) == count == sum(copy.part == 2 for copy in found.copies)
    assert torch.allclose(middles[:, :2].norm(dim=1), torch.tensor(0.35), atol=0.02)
    assert torch.allclose(middles[:, 2], torch.tensor(0.25), atol=0.03)  # as deep in the cake
    angles = torch.atan2(middles[:, 1], middles[:, 0]).sort().values
    assert torch.allclose(angles.diff(), torch.tensor(2 * np.pi / count).float(), atol=0.05)


def test_as_many_as_are_drawn_stay():
    _, found, _ = counted(cake, 3, 3)
    assert found == ((), (), {}, {})


def test_one_candle_is_in_the_middle():
    middles, _, _ = counted(cake, 3, 1)
    assert torch.allclose(middles, torch.tensor([[0.0, 0.0, 0.25]]), atol=0.03)


def test_too_many_do_not_fit():
    assert counted(cake, 3, 60)[0] is None


@pytest.mark.parametrize("count", [2, 3, 5])
def test_drawers_fill_the_height_and_keep_their_handles(count):
    middles, found, components = counted(dresser, 3, count)
    heights = middles[:, 2].sort().values
    assert len(heights) == count
    drawers = [copy for copy in found.copies if copy.part == 1]
    placed = torch.cat([copy.out(components[copy.source].verts) for copy in drawers])
    ends = placed[:, 2].amin().item(), placed[:, 2].amax().item()
    assert ends == pytest.approx((-0.57, 0.57), abs=0.03)
    assert heights.diff().max() - heights.diff().min() < 0.02
    handles = [copy for copy in found.copies if copy.part == 2]
    tall = [float(np.ptp(one.out(components[one.source].verts)[:, 2])) for one in handles]
    room = float(heights[1] - heights[0]) - 0.06
    assert len(handles) == count
    assert max(tall) == pytest.approx(0.06 * min(1, room / 0.24), abs=0.012)


def test_a_table_with_three_legs_has_no_frame_but_legs_up_to_its_top():
    middles, found, components = counted(table, 2, 3)
    at = middles[middles[:, 0].argsort()]
    assert torch.allclose(at[:, 0], torch.tensor([-0.6, 0.6, 0.6]), atol=0.06)
    assert torch.allclose(at[:, 1].abs(), torch.tensor([0.0, 0.35, 0.35]), atol=0.06)
    (whole,) = similar_of(components, 1)
    assert not len(found.apart[whole].verts)
    for copy in found.copies:
        placed = copy.out(found.apart[copy.source].verts)
        wide = np.ptp(placed.numpy(), axis=0)
        assert float(placed[:, 2].amax()) > 0.08 and max(wide[:2]) < 0.25 < wide[2]


def test_a_third_eye_is_between_the_others_on_the_face():
    middles, _, _ = counted(face, 2, 3)
    (odd,) = [middle for middle in middles if abs(float(middle[0])) < 0.05]
    off = float(odd.norm())
    assert off == pytest.approx(float(torch.tensor([0.22, 0.55, 0.1]).norm()), abs=0.05)
    assert float(counted(face, 2, 1)[0][0, 0]) == pytest.approx(0.0, abs=0.02)


@pytest.mark.parametrize("count", [2, 5])
def test_eggs_that_touch_are_taken_apart(count):
    components = drawn(nest, 2)
    (whole,) = similar_of(components, 1)
    assert len(balls_of(components[whole])) == 3
    middles, found, _ = counted(nest, 2, count)
    assert len(middles) == count and len(found.balls) == 3
    assert float(torch.pdist(middles).min()) > 0.2  # they are apart


def test_a_box_is_no_balls():
    components = drawn(lambda x: torch.stack([box(x, (0, 0, 0), (0.5, 0.2, 0.2))], 1), 1)
    assert balls_of(components[0]) == []


def test_words_state_how_many():
    assert parse("a cake with five candles").part_counts == (("candles", 5),)
    assert parse("a cake with 7 pink candles").part_counts == (("candles", 7),)
    assert parse("a nest with a single egg").part_counts == (("eggs", 1),)
    assert parse("a table with three legs").part == "four legs"
    assert parse("a table with three legs").part_counts == (("legs", 3),)
    assert parse("a table with one leg").part_counts == ()
    for prompt in ("a spider with six legs", "a bicycle with three wheels", "a dog with two heads"):
        words = parse(prompt)
        assert words.part_counts == () and "parts are not counted" in words.notes[-1]


@pytest.mark.slow
def test_a_drawn_cake_has_as_many_candles_as_stated():
    words = parse("a birthday cake with four candles")
    thing = PromptedBuiltin(shipped_prior(), words, Words()).of_object(0)
    assert isinstance(thing.solid, CountedSolid) and thing.left_out() == ()
    parts = [one.place.part for one in thing.painted.parts.drawn()]
    names = [paint.name for paint in thing.painted.paints]
    assert [parts.count(names.index(name)) for name in ("candles", "flames")] == [4, 4]


@pytest.mark.slow
def test_what_has_no_room_is_noted():
    words = parse("a candelabra with seven candles")
    thing = PromptedBuiltin(shipped_prior(), words, Words()).of_object(0)
    assert thing.left_out() == ("7 candles: left out, as that many do not fit there.",)
