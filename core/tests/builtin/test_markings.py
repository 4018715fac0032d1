"""Markings: parts that lie on another one, as sharp as the texture."""

import math
from functools import partial

import numpy as np
import pytest
import torch
from scipy import ndimage
from scipy.sparse import coo_matrix
from scipy.sparse.csgraph import connected_components
from scipy.spatial import cKDTree

from core.benchmarks.bench_prior import known_nouns
from core.errors import UserError
from core.geometry.parts import components
from core.guidance.builtin import guidance as builtin
from core.guidance.builtin.areas import SolidAreas
from core.guidance.builtin.guidance import GEOMETRY_SLOTS
from core.guidance.builtin.markings.forms import balls, cubes, faces, stripes, tiles, wings
from core.guidance.builtin.markings.forms.lettering import number_on
from core.guidance.builtin.markings.margins import within
from core.guidance.builtin.markings.markings import Marked, has_markings, is_marking
from core.guidance.builtin.markings.rows.tools_toys_and_instruments import STICKERS
from core.guidance.builtin.markings.stencils import land, lettering, text_size
from core.guidance.builtin.markings.table import MARKINGS
from core.guidance.builtin.nouns import NOUNS, row_of, solid_of
from core.guidance.builtin.offered import drawn_nouns, offered_words
from core.guidance.builtin.palette import looks, painted
from core.guidance.builtin.words.phrases.slots import Words
from core.guidance.builtin.words.vocabulary import parse
from core.ops import srgb_to_linear
from core.prior.draw import Draw
from core.prior.families import family
from core.tests.drawn_things import shipped_prior

UNIT = torch.ones(3)
BORROWED = [noun for noun in NOUNS if solid_of(noun) != noun]
EACH = [(noun, part) for noun, parts in MARKINGS.items() for part in parts]


def on_a_ball(count, radius=1.0):
    """Spread evenly (Vogel's spiral)."""
    k = torch.arange(count) + 0.5
    z, angle = 1 - 2 * k / count, k * (math.pi * (3 - math.sqrt(5)))
    flat = (1 - z * z).sqrt()
    return radius * torch.stack([flat * angle.cos(), flat * angle.sin(), z], 1)


def on_a_face(axis, side, count, half=1.0):
    """A lattice on one of a cube's faces, row by row."""
    line = (torch.arange(count) + 0.5) * (2 * half / count) - half
    at = torch.cartesian_prod(line, line)
    across = [k for k in range(3) if k != axis]
    points = torch.full((count * count, 3), side * half)
    points[:, across] = at
    return points


@pytest.mark.parametrize("noun", MARKINGS)
def test_markings_are_parts_that_lie_on_a_part_with_a_solid(noun):
    parts = looks(noun)
    for part, marking in MARKINGS[noun].items():
        assert part in parts and marking.on in parts
        below = [part]
        while is_marking(noun, below[-1]):
            assert len(below) == len(set(below)), "lies on itself"
            below.append(MARKINGS[noun][below[-1]].on)
        assert below[-1] in parts
    assert has_markings(noun) and not has_markings("gem")


# They are where a head is, and not on any ball.
SPOTS = [(n, p) for n, p in EACH if getattr(MARKINGS[n][p].marks, "func", None) is faces.round_eyes]


@pytest.mark.parametrize(("noun", "part"), [each for each in EACH if each not in SPOTS])
def test_a_marking_is_on_some_of_what_bears_it_and_as_far_as_it_says(noun, part):
    cube = torch.cat([on_a_face(axis, side, 97, 0.7) for axis in range(3) for side in (-1, 1)])
    line = torch.arange(-16, 16.1, 0.4)
    around = torch.cartesian_prod(line, line, line)
    marks, by = MARKINGS[noun][part].marks, MARKINGS[noun][part].by
    bearers = ((on_a_ball(20000, 0.9), 0.9 * UNIT), (cube, 0.7 * UNIT))
    if by in ("eyes", "belly"):  # what is beside them
        bearers = ((0.1 * around, 0.1 * UNIT),)
    for points, half in bearers:
        margin = marks(points, half)
        assert margin.isfinite().all() and margin.min() < 0 < margin.max()
        near, step = points[margin.abs() < 0.02], 1e-3
        taps = step * torch.eye(3)
        slope = [(marks(near + tap, half) - marks(near - tap, half)) / (2 * step) for tap in taps]
        assert 0.5 < torch.stack(slope, 1).norm(dim=1).median() < 1.5


@pytest.mark.parametrize(
    ("noun", "part"),
    [*SPOTS[:1], *(pytest.param(*each, marks=pytest.mark.slow) for each in SPOTS[1:])],
)
def test_spots_are_on_both_sides_of_a_front(noun, part):
    drawn = shipped_prior().prompted(f"a {noun}", "").of_object(1)
    fields, names = drawn.area_fields(), list(looks(noun))
    assert drawn.solid and fields
    points = drawn.solid.mesh[0]
    head = points[drawn.solid.part(points) == names.index(MARKINGS[noun][part].on)]
    middle = head.mean(0)
    seen = points[fields.near(points)[1].argmax(1) == names.index(part)]
    assert (seen[:, 0] > middle[0] + 0.05).sum() > 10 and (seen[:, 0] < middle[0] - 0.05).sum() > 10
    assert (seen[:, 1] < middle[1] + 0.1).all() and (seen[:, 1] < middle[1]).float().mean() > 0.5


LIT = [noun for noun, parts in MARKINGS.items() if {"glints", "eyes"} <= set(parts)]


@pytest.mark.parametrize("noun", LIT)
def test_a_face_has_two_eyes_with_a_light_in_each(noun):
    points = on_a_ball(40000)
    eyes, lights = (MARKINGS[noun][part].marks(points, UNIT) > 0 for part in ("eyes", "glints"))
    assert eyes[lights].float().mean() > 0.9 and lights.sum() < 0.5 * eyes.sum()
    for side in (-1, 1):
        assert (points[eyes, 0] * side > 0).any() and (points[lights, 0] * side > 0).any()
    assert (points[eyes, 0].abs() > 0.1).all() and (points[eyes, 1] < 0).all()


SHINY = [noun for noun, parts in MARKINGS.items() if "glints" in parts and noun not in LIT]


@pytest.mark.parametrize("noun", SHINY)
def test_an_eyeball_has_its_light_in_front_and_mostly_the_eyes_own_colour(noun):
    points = on_a_ball(40000, 0.1)
    light = MARKINGS[noun]["glints"].marks(points, 0.1 * UNIT) > 0
    assert light.any() and light.float().mean() < 0.2
    assert (points[light, 1] < 0.03).all()  # to the front, or a little to the side


def test_an_eighth_part_is_a_marking_as_the_network_draws_seven():
    eight = {noun: list(row.looks)[7:] for noun, row in NOUNS.items() if len(row.looks) > 7}
    drawn = {noun: parts for noun, parts in eight.items() if row_of(noun)}
    left = {noun for noun, parts in drawn.items() if not is_marking(noun, parts[0])}
    assert left == {"person"}


def test_a_dies_opposite_faces_add_to_seven():
    counts = {}
    for axis in range(3):
        for side in (-1, 1):
            inside = cubes.pips(on_a_face(axis, side, 120), UNIT).view(120, 120) > 0
            counts[axis, side] = ndimage.label(inside.numpy())[1]
            assert not inside[:8].any() and not inside[:, :8].any(), "over the edge"
    assert sorted(counts.values()) == [1, 2, 3, 4, 5, 6]
    assert all(counts[axis, -1] + counts[axis, 1] == 7 for axis in range(3))


def test_a_football_has_twelve_pentagons_that_are_apart():
    points = on_a_ball(40000)
    dark = points[balls.pentagons(points, UNIT) > 0].numpy()
    near = cKDTree(dark).query_pairs(0.04, output_type="ndarray")
    graph = coo_matrix((np.ones(len(near)), near.T), shape=(len(dark), len(dark)))
    count, own = connected_components(graph, directed=False)
    assert count == 12
    sizes = np.bincount(own)
    assert sizes.max() < 1.05 * sizes.min()
    middles = np.stack([dark[own == k].mean(0) for k in range(12)])
    middles /= np.linalg.norm(middles, axis=1, keepdims=True)
    # An icosahedron's corners.
    nearest = np.sort(middles @ middles.T, axis=1)[:, -6:-1]
    assert np.allclose(nearest, 1 / math.sqrt(5), atol=0.01)
    assert seen("soccer ball", torch.from_numpy(middles)) == ["patches"] * 12, "no seam on one"


def test_each_place_of_a_puzzle_cube_has_one_colour_and_the_gaps_none():
    marks = [MARKINGS["puzzle cube"][name].marks for name in STICKERS]
    line, middle = torch.tensor([-2 / 3, 0, 2 / 3]), set()
    for axis in range(3):
        for side in (-1.0, 1.0):
            points = torch.full((18, 3), side)
            across = [k for k in range(3) if k != axis]
            points[:9, across] = torch.cartesian_prod(line, line)
            gaps = torch.cartesian_prod(torch.tensor([-1 / 3, 1 / 3, 0.99]), line)
            points[9:, across] = gaps
            inside = torch.stack([mark(points, UNIT) > 0 for mark in marks], 1)
            assert (inside[:9].sum(1) == 1).all() and not inside[9:].any()
            middle.add(int(inside[4].float().argmax()))
    assert middle == set(range(6)), "each face's middle has its own"


def test_a_letters_stem_is_inside_and_what_is_beside_it_is_not():
    at = torch.tensor([[0, 0.0], [0, 0.45], [0, -0.45], [0.4, 0], [-0.4, 0], [0, 0.7], [9, 9]])
    assert (lettering(at, "I") > 0).tolist() == [True] * 3 + [False] * 4
    # As it is read: the foot of an L is to the right, below.
    wide, high = text_size("L")
    foot, none = [0.35 * wide, -0.45], [0.35 * wide, 0.45]
    assert (lettering(torch.tensor([foot, none]), "L") > 0).tolist() == [True, False]
    assert high == pytest.approx(1, abs=0.1)
    assert text_size("A\nA")[1] > 1.9 and text_size("AAAA")[0] > 3 * text_size("A")[0]


def test_a_number_on_a_ball_is_upright_where_it_is_said_to_be():
    number = partial(number_on, half=UNIT, text="7", way=(0.0, -1.0, 0.0), high=0.8)
    bar = torch.tensor([[-0.15, -1, 0.37], [0.15, -1, 0.37]])
    assert (number(bar) > 0).all()
    assert not (number(bar * torch.tensor([1.0, 1, -1])) > 0).all(), "not upside down"
    assert (number(bar * torch.tensor([1.0, -1, 1])) < 0).all(), "not at the back"


def place(north, east):
    """On a globe that shows 15° east, by degrees."""
    north, east = math.radians(north), math.radians(east - 15)
    flat = math.cos(north)
    return [flat * math.sin(east), -flat * math.cos(east), math.sin(north)]


@pytest.mark.parametrize(
    ("north", "east", "dry"),
    [
        (48.9, 2.4, True),  # Paris
        (23, 10, True),  # the Sahara
        (38, -98, True),  # Kansas
        (-32, 147, True),  # inland of Sydney
        (60, 100, True),  # Siberia
        (-8, -55, True),  # Brazil
        (-85, 0, True),  # the South Pole
        (0, -150, False),  # the Pacific
        (30, -40, False),  # the Atlantic
        (-30, 80, False),  # the Indian Ocean
        (85, 0, False),  # the North Pole
    ],
)
def test_the_worlds_land_is_where_it_is(north, east, dry):
    assert (land(torch.tensor([place(north, east)])) > 0).item() == dry


def seen(noun, points, gone=(), on=""):
    """The names of the parts at places on a ball or on a disc that bears the markings; ``on``: the
    part that it is, where it is not the first."""
    names = ["" if name in gone else name for name in looks(noun)]
    boxes = [torch.stack([-UNIT, UNIT]) if name else None for name in names]
    distances = torch.full((len(points), len(names)), 9.0)
    distances[:, list(looks(noun)).index(on) if on else 0] = 0.0
    return [names[k] for k in Marked(noun, names, boxes)(distances, points).argmin(1)]


def turned(*angles):
    """From the front to the right."""
    return torch.tensor([[math.sin(a), -math.cos(a), 0] for a in angles])


def test_what_lies_on_a_marking_lies_on_what_bears_that():
    at = turned(0.0, 0.4, 1.0, math.pi)
    assert seen("eyeball", at) == ["pupil", "iris", "white", "white"]
    assert seen("eyeball", at, ("pupil",)) == ["iris", "iris", "white", "white"]
    rings = torch.tensor([[x, -0.1, 0.0] for x in (0.1, 0.3, 0.5, 0.7, 0.9)])
    assert seen("target", rings) == ["golds", "reds", "blues", "blacks", "board"]
    cloth = torch.tensor([[x, -0.1, z] for x, z in ((0, 0), (0.3, 0), (0.9, 0.0), (0.5, 0.25))])
    assert seen("brazilian flag", cloth) == ["disc", "disc", "cloth", "lozenge"]


def test_a_flags_colours_are_where_they_belong():
    """The pole is at the left, seen from the front."""
    left, middle, right = ([x, 0.0, 0.3] for x in (-0.7, 0.0, 0.7))
    tricolour = torch.tensor([left, middle, right])
    assert seen("french flag", tricolour) == ["blues", "cloth", "reds"]
    assert seen("italian flag", tricolour) == ["greens", "cloth", "reds"]
    levels = torch.tensor([[0, 0, 0.7], [0, 0, 0.0], [0, 0, -0.7]])
    assert seen("german flag", levels) == ["blacks", "cloth", "golds"]
    american = seen("american flag", torch.tensor([[-0.7, 0.0, 0.95], [0.5, 0, 12 / 13]]))
    assert american == ["canton", "cloth"]
    rows = torch.tensor([[0.5, 0, 2 * (k + 0.5) / 13 - 1] for k in range(13)])
    assert seen("american flag", rows) == ["cloth", "stripes"] * 6 + ["cloth"]


def test_what_is_printed_is_where_it_belongs():
    front = torch.tensor([[x, -0.9, z] for x, z in ((0, 0.0), (0, 0.4), (0.9, 0.9))])
    assert seen("first aid kit", front) == ["cross", "body", "body"]
    rug = torch.tensor([[x, y, 0.0] for x, y in ((0, 0), (0.5, 0), (0.6, 0.2), (0.97, 0))])
    assert seen("rug", rug) == ["middle", "lozenge", "field", "border"]
    record = torch.tensor([[x, y, 0.0] for y in (-0.1, 0.1) for x in (0.0, 0.2, 0.415, 0.95)])
    assert seen("vinyl record", record) == ["hole", "label", "grooves", "disc"] * 2
    picture = torch.tensor([[0.5, -0.1, 0.55], [0, -0.1, 0.9], [0, -0.1, -0.9]])
    assert seen("easel", picture, on="picture") == ["sun", "picture", "hills"]
    north = torch.tensor([[0.08 * x, -0.1, 0.72 + 0.08 * z] for x in (-1, 1) for z in (-1, 1)])
    assert seen("compass", north, on="dial") == ["marks"] * 4, "the four feet of an N"


def test_an_ambulance_has_a_cross_on_both_sides_and_none_on_its_back():
    places = torch.tensor([[1.0, 0.38, 0.14], [-1.0, 0.38, 0.14], [0.3, 1.0, -0.1]])
    assert seen("ambulance", places) == ["cross", "cross", "body"]
    about = torch.tensor([[x, y, -0.56] for x, y in ((1, 0), (-1, 0), (0.3, 1), (0.3, -1))])
    assert seen("ambulance", about) == ["cross"] * 4, "the stripe"


def test_a_polygons_margin_is_the_distance_to_its_border():
    square = torch.tensor([[-1.0, -1], [1, -1], [1, 1], [-1, 1]])
    at = torch.tensor([[0, 0], [0.7, 0.2], [2, 0], [1.3, 1.4]])
    assert torch.allclose(within(at, square), torch.tensor([1, 0.3, -1, -0.5]))


def test_a_butterflys_wings_mirror_one_another_and_have_dark_edges():
    at = torch.cartesian_prod(torch.linspace(-1, 1, 41), torch.linspace(-1, 1, 41))
    points = torch.cat([at, torch.zeros(len(at), 1)], 1)
    names = seen("butterfly", points, on="edges")
    assert names == seen("butterfly", points * torch.tensor([-1.0, 1, 1]), on="edges")
    assert {"wings", "edges", "dots"} == set(names)
    # From the wing's root, in its width, to its own box, in halves: its outer half.
    outlines = [torch.tensor(line) for line in (wings.FORE[3:9], wings.HIND[2:7])]
    boxed = [torch.stack([2 * line[:, 0] - 1, line[:, 1], 0 * line[:, 0]], 1) for line in outlines]
    assert set(seen("butterfly", torch.cat(boxed), on="edges")) <= {"edges", "dots"}


@pytest.mark.parametrize(
    ("prompt", "gone"),
    [
        ("a zebra without stripes", "stripes"),
        ("a dalmatian without spots", "spots"),
        ("a soccer ball without seams", "seams"),
        ("a stop sign without letters", "letters"),
    ],
)
def test_a_marking_that_is_taken_away_is_nowhere(prompt, gone):
    words = parse(prompt)
    assert words.absent == (gone,)
    points = on_a_ball(3000)
    assert gone in seen(words.noun, points)
    assert gone not in seen(words.noun, points, words.absent)


@pytest.mark.parametrize("noun", BORROWED)
def test_a_borrowed_things_parts_are_its_bases(noun):
    base, parts, bases = solid_of(noun), list(looks(noun)), list(looks(solid_of(noun)))
    assert solid_of(base) == base and base in NOUNS
    for k, part in enumerate(parts):
        if not is_marking(noun, part):
            assert k < len(bases) and not is_marking(base, bases[k])
            assert part not in bases or bases.index(part) == k
    assert Words(noun).indices(GEOMETRY_SLOTS) == Words(base).indices(GEOMETRY_SLOTS)
    assert set(family(noun)(Draw(torch.Generator().manual_seed(0)))) <= set(parts)


@pytest.mark.parametrize(
    ("prompt", "part", "color"),
    [
        ("a soccer ball with red patches", "patches", "red"),
        ("a blue dice with yellow pips", "pips", "yellow"),
        ("a zebra with green stripes", "stripes", "green"),
        ("an earth with purple land", "land", "purple"),
        ("a rug with a green border", "border", "green"),
        ("a blue butterfly with yellow dots", "dots", "yellow"),
        ("a fire truck with a yellow stripe", "stripe", "yellow"),
    ],
)
def test_a_marking_has_the_colour_that_is_said_of_it(prompt, part, color):
    words = parse(prompt)
    paint = next(paint for paint in painted(words.noun, words) if paint.name == part)
    assert not words.left_out and words.part_shades()[part] == color
    assert paint.colored and paint.color != paint.look.color


@pytest.fixture(scope="module")
def football():
    """One with red patches."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(components, "SEARCH", 40)
        patch.setattr(builtin, "SolidAreas", partial(SolidAreas, cells=40))
        prompted = shipped_prior().prompted("a soccer ball with red patches", "").of_object(0)
        return prompted, prompted.areas(), prompted.parts().boxes()[0]


def test_an_areas_border_is_as_sharp_as_the_marking(football):
    _, areas, (low, high) = football
    half, middle = (high - low) / 2, (high + low) / 2
    points = middle + half * on_a_ball(20000)
    margin = balls.pentagons(points - middle, half)
    dark = areas.of(points) == list(looks("soccer ball")).index("patches")
    near = margin.abs() < 0.02
    assert (near & (margin > 0)).sum() > 100 and (near & (margin < 0)).sum() > 100
    sure = margin.abs() > 0.004  # the seams that meet a pentagon end at its border
    assert torch.equal(dark[sure], margin[sure] > 0)


def test_a_marking_has_no_solid(football):
    """The network has learnt one, as a relief: it is not drawn."""
    prompted, _, _ = football
    assert {component.place.part for component in prompted.parts().components} == {0}


def test_an_areas_colour_is_the_markings(football):
    prompted, areas, _ = football
    names = [paint.name for paint in painted("soccer ball", prompted.words)]
    ranges = areas.each[names.index("patches")].ranges
    low, high = map(torch.tensor, ranges.color)
    assert (low[0] > high[1]) and (low[0] > high[2]), "red"
    ball = areas.each[names.index("ball")].ranges
    assert min(ball.color[0]) > srgb_to_linear(torch.tensor(0.7)), "white"


def test_a_marking_whose_bearer_is_gone_is_gone():
    names = list(NOUNS["american flag"].looks)
    boxes = [torch.tensor([[-1.0] * 3, [1.0] * 3])] * len(names)
    whole = Marked("american flag", names, boxes)
    assert [names[part] for part, *_ in whole.laid].count("stars") == 1
    without = ["" if name == "cloth" else name for name in names]
    assert Marked("american flag", without, boxes).laid == []


def test_what_is_anothers_solid_is_not_benched():
    assert "tennis ball" in offered_words()["noun"] and "ball" in drawn_nouns()
    assert {solid_of(noun) for noun in drawn_nouns()} == set(drawn_nouns())
    with pytest.raises(UserError, match="tennis ball"):
        known_nouns(["tennis ball"])


def test_cells_lie_on_the_upper_side_of_a_leaning_panel():
    half = torch.tensor([0.9, 0.4, 0.3])
    line = torch.tensor([[0.15, 0.1, 0.1 * 0.3 / 0.4]])  # in the panel's plane, within a cell
    out = torch.tensor([[0.0, -0.3, 0.4]]) * 0.1
    assert tiles.solar_cells(line + out, half) > 0 > tiles.solar_cells(line - out, half)


def test_a_popcorn_box_has_no_stripes_around_its_badge():
    half = torch.full((3,), 0.5)
    front = torch.tensor([[x, -0.5, 0.0] for x in torch.linspace(-0.1, 0.1, 41).tolist()])
    assert (stripes.popcorn_stripes(front, half, 0.48) <= 0).all()
    assert (stripes.popcorn_stripes(front, half, 0.0) > 0).any()
    back = front * torch.tensor([1.0, -1.0, 1.0])
    assert (stripes.popcorn_stripes(back, half, 0.48) > 0).any()


def test_a_mark_at_the_top_is_about_the_upper_balls_middle():
    half = torch.tensor([0.3, 0.3, 0.5])
    marks = partial(balls.cap, wide=0.2)  # about the front
    at, below = torch.tensor([[0.0, -0.3, 0.2]]), torch.tensor([[0.0, -0.3, 0.0]])
    assert balls.at_top(at, half, marks) > 0 > balls.at_top(below, half, marks)


def test_a_paired_marking_is_on_both_sides_and_one_by_another_part_has_its_place():
    def laid(noun, part, on, boxes, points):
        names = list(looks(noun))
        each = [boxes.get(name) for name in names]
        distances = torch.ones(len(points), len(names))
        distances[:, names.index(on)] = 0  # all of the places are on it
        return Marked(noun, names, each)(distances, points)[:, names.index(part)] <= 0

    arm = torch.tensor([[0.6, -0.4, -0.3], [0.9, 0.4, 0.3]])
    x, z = torch.linspace(0.6, 0.9, 60), torch.linspace(-0.3, 0.3, 120)
    front = torch.cartesian_prod(x, torch.tensor([-0.4]), z)
    there = front * torch.tensor([-1.0, 1.0, 1.0])
    sides = [laid("sofa", "piping", "arms", {"arms": arm}, at) for at in (front, there)]
    assert sides[0].any() and torch.equal(*sides)

    body = torch.tensor([[-0.5, -0.3, -1.0], [0.5, 0.3, 1.0]])
    cone = torch.tensor([[-0.3, -0.35, -0.7], [0.3, -0.25, -0.1]])
    disc = torch.cartesian_prod(torch.linspace(-0.5, 0.5, 60), torch.tensor([-0.3]), z.mul(3))
    one, other = (
        laid("speaker", "caps", "cones", {"body": box, "cones": cone}, disc) for box in (body, cone)
    )
    assert one.any() and not torch.equal(one, other), "by the body's box, not by a cone's"
