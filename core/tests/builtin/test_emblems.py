"""What a prompt wants written or drawn on the thing is put on it."""

from dataclasses import replace
from functools import partial

import numpy as np
import pytest
import torch

from core.config import DRAFT
from core.generate import Inputs, generate
from core.geometry.parts.assembly import KnownParts
from core.geometry.parts.forms import Forms
from core.guidance.builtin import guidance as builtin
from core.guidance.builtin.areas import SolidAreas
from core.guidance.builtin.guidance import PromptedBuiltin
from core.guidance.builtin.markings.emblems import drawn_emblem as placing
from core.guidance.builtin.markings.emblems import windows
from core.guidance.builtin.markings.emblems.drawn_emblem import COLORS, Drawn, differ, drawn_on
from core.guidance.builtin.markings.emblems.scattered import scattered_on
from core.guidance.builtin.markings.emblems.windows import WAYS, Window, largest_square, window_on
from core.guidance.builtin.markings.shapes import SHAPES, shape_margin
from core.guidance.builtin.palette import FINISHES, looks, painted
from core.guidance.builtin.words.phrases.emblems import (
    ALSO_THINGS,
    FLAT,
    emblems_in,
)
from core.guidance.builtin.words.phrases.moods import MOODS
from core.guidance.builtin.words.phrases.slots import Words
from core.guidance.builtin.words.vocabulary import parse
from core.io.job import Job, read_events
from core.io.progress import Progress
from core.io.run_folder import RunFolder
from core.prior.solids import cut, tube
from core.tests.drawn_things import shipped_prior


@pytest.mark.parametrize("name", SHAPES)
def test_a_shape_fills_its_square_and_no_more(name):
    line = torch.linspace(-1.3, 1.3, 131)
    at = torch.cartesian_prod(line, line)
    margin = shape_margin(at, name)
    inside = at[margin > 0]
    assert 0.75 < inside.abs().max() < 1.1
    assert len(inside) > 0.04 * len(at)
    assert (margin[at.abs().amax(1) > 1.1] < 0).all()


def test_every_shape_that_may_be_named_can_be_drawn():
    faces = {f"{mood} face" for mood in MOODS}
    assert set(FLAT) | set(ALSO_THINGS) | faces == set(SHAPES)
    assert set(COLORS) <= set(SHAPES)


def test_shapes_are_upright():
    """A heart's tip is below, an arrow's to the right."""
    down = torch.tensor([[0, -0.75], [0, 0.75]])
    assert (shape_margin(down, "heart") > 0).tolist() == [True, False]
    right = torch.tensor([[0.5, 0.3], [-0.5, 0.3]])
    assert (shape_margin(right, "arrow") > 0).tolist() == [True, False]


def mask(*rows):
    return np.array([[one == "#" for one in row] for row in rows])


@pytest.mark.parametrize(
    ("rows", "found"),
    [
        (("...", "..."), (0, (0, 0))),
        (("#",), (1, (0, 0))),
        (("....", "..#.", "...."), (1, (1, 2))),
        (("####",) * 4, (4, (0, 0))),
        (("#" * 12,) * 4, (4, (0, 4))),  # in the middle
        (("#" * 4,) * 12, (4, (4, 0))),
        (("##...", "##...", ".....", "..###", "..###", "..###"), (3, (3, 2))),
    ],
)
def test_the_largest_square_of_a_mask(rows, found):
    side, (top, left) = largest_square(mask(*rows))
    assert (side, (top, left)) == found
    assert mask(*rows)[top : top + side, left : left + side].all()


def test_a_square_may_have_a_small_hole_in_it_and_no_large_one():
    holed = np.ones((12, 12), bool)
    holed[5, 5] = False
    assert largest_square(holed)[0] >= 10
    holed[4:8, 4:8] = False
    assert largest_square(holed)[0] == 4


SIDE = 0.6


def cube(points):
    return (points.abs() - SIDE).amax(1, keepdim=True)


@pytest.fixture(scope="module")
def parts():
    """Of a cube."""
    return KnownParts(cube, Forms((1.0,), ((0.0, 0.0, 0.0),)))


@pytest.mark.parametrize("way", WAYS)
def test_the_window_of_a_cube_is_in_the_middle_of_a_face(parts, way):
    window = window_on(parts, [1.0], 1.0, way)
    assert window.part == 0 and window.way == WAYS[way]
    assert window.middle == pytest.approx((0, 0), abs=0.03)
    assert 0.85 * SIDE < window.half <= SIDE
    assert 0.9 * SIDE < window.behind < SIDE
    assert window_on(parts, [0.0], 1.0, way) is None


def test_where_nobody_asks_it_is_the_front(parts):
    assert window_on(parts, [1.0], 1.0).way == WAYS["front"]
    wide = window_on(parts, [1.0], 3.0)
    assert 0.25 * SIDE < wide.half <= SIDE / 3


def test_shapes_are_scattered_on_each_main_part_where_it_is_seen():
    """A cup on a saucer, with tea in it: none is below the cup or below the tea."""
    solids = [
        cut(tube((0, 0, -0.2), (0, 0, 0.4), 0.35), tube((0, 0, -0.1), (0, 0, 1), 0.27)),
        tube((0, 0, -0.3), (0, 0, -0.2), 0.9),
        tube((0, 0, -0.1), (0, 0, 0.25), 0.28),  # into the wall
    ]

    def distances(points):
        return torch.stack([solid(points) for solid in solids], 1)

    round_ = ((0.0,) * 3, (0.0,) * 3, (0.8,) * 3)
    found = scattered_on(KnownParts(distances, Forms((0.5, 0.6, 0.6), round_)), [0, 1])
    assert found.half < 0.1  # by the cup, not by the saucer
    x, y, z = found.middles.unbind(1)
    far = torch.hypot(x, y)
    assert ((z > -0.19) & (far > 0.3)).sum() >= 3  # on the cup, of all around it
    assert ((z < -0.19) & (far > 0.4)).sum() >= 3  # on the saucer
    assert not ((far < 0.26) & (z < 0.2) & (z > -0.25)).any()  # in the tea, below the cup


def test_a_text_on_the_side_is_read_from_both_sides():
    window = Window(0, WAYS["side"], (0.1, 0.2), 0.5, 0.3)
    right = torch.tensor([[0.6, 0.35, 0.2], [-0.6, -0.15, 0.2], [-0.6, 0.35, 0.45]])
    # Seen from +x, +y is to the right; from -x it is to the left.
    expected = torch.tensor([[0.5, 0], [0.5, 0], [-0.5, 0.5]])
    torch.testing.assert_close(window.at(right), expected)
    assert (window.before(right) > 0).all()
    assert window.before(torch.tensor([[0.1, 0.0, 0.0]])) < 0


@pytest.mark.parametrize(
    ("way", "right", "up"),
    [
        ("front", (1, 0, 0), (0, 0, 1)),
        ("back", (-1, 0, 0), (0, 0, 1)),
        ("top", (1, 0, 0), (0, 1, 0)),
    ],
)
def test_a_text_is_not_mirrored(way, right, up):
    window = Window(0, WAYS[way], (0, 0), 1.0, 0.3)
    at = window.at(torch.tensor([right, up]).float())
    torch.testing.assert_close(at, torch.eye(2))
    (axis, side), eye = window.way.to, torch.zeros(1, 3)
    eye[0, axis] = side
    assert window.before(eye) > 0 > window.before(-eye)
    cross = torch.linalg.cross(torch.tensor(right).float(), torch.tensor(up).float())
    assert torch.equal(cross[None], eye), "right, up and towards the eye are right-handed"


def drawn(parts, prompt):
    """On a cube, whatever the thing."""
    words = parse(prompt)
    paints = list(painted(words.noun, words))[:1]
    return Drawn(words.emblems[0], words.noun, parts, paints), paints


def test_what_is_drawn_is_on_its_face_alone(parts):
    on, _ = drawn(parts, "a white cube with a red circle on it")
    points = torch.tensor(
        [[0, -SIDE, 0], [0.55, -SIDE, 0.55], [0, SIDE, 0], [SIDE, 0, 0], [0, 0, SIDE]]
    )
    found = on(cube(points), points)
    assert found.shape == (5, 2)
    assert found.argmin(1).tolist() == [1, 0, 0, 0, 0]
    assert torch.allclose(found.amin(1), cube(points)[:, 0], atol=1e-6), "the surface stays"


def test_a_text_on_a_part_is_as_large_as_there_is_room(parts):
    on, _ = drawn(parts, "a cube that says II")
    line = torch.linspace(-0.55, 0.55, 200)
    front = torch.stack([line, 0 * line - SIDE, 0 * line + on.window.middle[1]], 1)
    letters = on(cube(front), front).argmin(1) == 1
    starts = (letters[1:] & ~letters[:-1]).sum()
    assert starts == 2 and letters.any()
    assert not letters[:10].any() and not letters[-10:].any()


def test_racing_stripes_are_two_along_the_body(parts):
    on, _ = drawn(parts, "a blue car with white racing stripes")
    x = torch.tensor([-0.24, 0.24, 0.0, -0.5, 0.5]) * SIDE
    for y in (-0.5, 0.5):
        points = torch.stack([x, torch.full_like(x, y), torch.full_like(x, SIDE)], 1)
        assert on(cube(points), points).argmin(1).tolist() == [1, 1, 0, 0, 0]


@pytest.mark.parametrize(
    ("prompt", "color"),
    [
        ("a cube with a golden star", "golden"),
        ("a cube that says OPEN in copper", "copper"),
    ],
)
def test_a_metal_is_one(parts, prompt, color):
    on, _ = drawn(parts, prompt)
    assert on.paint.finish == FINISHES[color] and on.paint.color == FINISHES[color].color


def test_a_stated_colour_that_the_part_has_by_nature_is_seen(parts):
    on, paints = drawn(parts, "an apple with a red heart")
    assert not differ(paints[0].color, on.paint.color)
    on.make_seen(paints)
    assert differ(paints[0].color, on.paint.color) and paints[0].colored
    # What the words say stays.
    for prompt in ("a red apple with a red heart", "a yellow apple with a red heart"):
        on, paints = drawn(parts, prompt)
        before = list(paints)
        on.make_seen(paints)
        assert paints == before


def test_a_colour_that_nobody_says_is_seen(parts):
    for prompt in (
        "a white cube with a snowflake on it",
        "a red cube with a heart",
        "a cube, number 7",
    ):
        on, paints = drawn(parts, prompt)
        assert differ(on.paint.color, paints[0].color), prompt
    on, _ = drawn(parts, "a white cube with a heart")
    assert on.paint.color == COLORS["heart"]


@pytest.fixture(scope="module")
def mug():
    """With a heart, and its areas."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(builtin, "SolidAreas", partial(SolidAreas, cells=40))
        prompted = shipped_prior().prompted("a white mug with a red heart", "").of_object(0)
        return prompted, prompted.areas()


def test_a_drawing_is_an_area_of_its_own(mug):
    prompted, areas = mug
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(builtin, "SolidAreas", partial(SolidAreas, cells=4))
        words = parse("a white mug")
        plain = PromptedBuiltin(prompted.builtin, words, prompted.negative, prompted.solid)
        assert len(areas.each) == len(plain.areas().each) + 1
    assert prompted.words == parse("a white mug with a red heart")


def test_a_heart_is_on_the_front_and_nowhere_at_the_back(mug):
    prompted, areas = mug
    paints = list(painted("mug", prompted.words))
    window = Drawn(prompted.words.emblems[0], "mug", prompted.parts(), paints).window
    assert window.way == WAYS["front"]
    x, z = window.middle
    line = torch.linspace(-1, 1, 401)
    across = torch.stack([0 * line + x, line, 0 * line + z], 1)
    solid = (prompted.solid.distances(across).amin(1) < 0).nonzero()[:, 0]
    front, back = areas.of(across[solid[[0, -1]]]).tolist()
    assert front == len(areas.each) - 1 != back
    (low, high), white = areas.each[front].ranges.color, areas.each[back].ranges.color
    assert low[0] > max(high[1:]), "red"
    assert min(white[0]) > 0.5


def test_several_are_taken_and_lie_apart(parts):
    emblems, rest = emblems_in(
        "a crate labelled POISON with a skull on it and white stripes down the middle"
    )
    assert [str(one) for one in emblems] == ["white racing stripes", '"POISON"', "skull"]
    assert rest == "a crate"
    paints = list(painted("cube", parse("a cube")))
    first, second, third = drawn_on("cube", emblems, parts, paints)
    assert first.window is None and second.window.way == WAYS["front"]
    assert third.window.way != second.window.way  # the front is full
    # Each is a column of its own, and the stripes are below the others.
    nothing, stripe = torch.full((1, 8), -0.1), torch.tensor([[0.144, -0.6, 0.55]])
    assert first(nothing, stripe).argmin() == 1 and first(nothing, stripe).shape == (1, 2)
    beam = torch.linspace(-0.5, 0.5, 400)
    front = torch.stack([beam, torch.full_like(beam, -0.6), torch.zeros(400)], 1)
    nothing = torch.full((400, 8), -0.1)
    found = third(second(first(nothing, front), front), front)
    assert found.shape == (400, 4) and set(found.argmin(1).tolist()) == {0, 1, 2}
    assert not (second(first(nothing, front), front).argmin(1)[found[:, 2] < -0.005] == 1).any()


def test_stripes_of_the_bodys_own_colour_are_there(parts):
    on, paints = drawn(parts, "a white sports car with white racing stripes")
    assert set(on.bears) == {0}
    # Of a thing without a main part too.
    others = [paint._replace(look=paint.look._replace(role="+")) for paint in paints]
    assert Drawn(on.emblem, "sports car", parts, others).bears == [0]
    assert on(torch.full((1, 8), -0.1), torch.zeros(1, 3)).shape == (1, len(paints) + 1)


def test_what_stands_out_of_the_cube_is_passed_over(parts, monkeypatch):
    """As what a guide has bent may."""
    places, normals, of = windows.surface_places(parts)
    out = torch.tensor([[0.0, -9.0, 9.0], [9.0, -9.0, 0.0], [0.0, -9.0, -9.0]]).numpy()
    more = tuple(
        map(np.concatenate, ((places, out), (normals, [[0.0, -1.0, 0.0]] * 3), (of, [0] * 3)))
    )
    before = window_on(parts, [1.0], 1.0, "front")
    monkeypatch.setattr(windows, "surface_places", lambda _: more)
    assert window_on(parts, [1.0], 1.0, "front") == before


def test_where_the_asked_part_has_no_room_it_is_elsewhere(parts):
    words = parse("a mug with a heart on the handle")
    paints = list(painted(words.noun, words))
    on = Drawn(words.emblems[0], words.noun, parts, paints)  # a cube, which is all body
    assert words.emblems[0].on == "handle" and on.window is not None and on.on == 0


def test_what_has_no_place_is_said(mug, monkeypatch):
    mug, _ = mug
    assert mug.left_out() == ()
    words = parse("a mug that says HELLO and a red heart")
    of_mesh = PromptedBuiltin(mug.builtin, words, Words())
    (note,) = {text for text in of_mesh.left_out() if "HELLO" in text}
    assert "not on your mesh" in note
    monkeypatch.setattr(placing, "window_on", lambda *_: None)
    full = PromptedBuiltin(mug.builtin, words, Words(), mug.solid)
    assert [text for text in full.left_out() if "no room" in text and "HELLO" in text]


def test_what_bears_what_is_drawn_stays():
    """Without its border a rug would be nothing but fringes."""
    builtin_prior = shipped_prior()
    whole = builtin_prior.prompted("a rug", "").of_object(0)
    without = builtin_prior.prompted("a rug without a border", "").of_object(0)
    at = torch.zeros(1, 3)
    assert torch.equal(without.solid.distances(at), whole.solid.distances(at))
    assert [text for text in without.left_out() if text.startswith("no border")]
    assert without.painted.marked.laid
    plain = builtin_prior.prompted("a rug without a lozenge", "").of_object(0)
    assert not plain.left_out()


def test_what_is_denied_takes_its_markings_with_it():
    house = shipped_prior().prompted("a house without a door", "").of_object(0)
    areas, names = house.areas(), list(looks("house"))
    assert areas is not None and len(areas.sizes) == len(names)
    seen = {name for name, size in zip(names, areas.sizes.tolist(), strict=True) if size}
    assert seen >= {"walls", "windows", "frames"} and not seen & {"door", "panels"}
    assert not house.left_out()


@pytest.mark.parametrize(
    ("prompt", "there"),
    [
        pytest.param("a kettlebell", True, marks=pytest.mark.slow),
        ("a kettlebell that says GO", False),
    ],
)
def test_a_badge_gives_way_to_what_is_asked_for(prompt, there):
    prompted = shipped_prior().prompted(prompt, "").of_object(0)
    badge = list(looks("kettlebell")).index("badge")
    assert (badge in [part for part, *_ in prompted.painted.marked.laid]) is there


@pytest.mark.slow
def test_a_stated_number_is_where_the_things_own_is():
    plain, stated = (
        shipped_prior().prompted(f"a race car{more}", "").of_object(0).painted
        for more in ("", " with number 44")
    )
    assert stated.number == "44" and not stated.emblems and not stated.left_out()
    assert torch.isfinite(stated.shown(torch.zeros(1, 3))).all()  # the visor has no number
    index = list(looks("race car")).index("number")
    own, other = ({one.part: one for one in of.marked.laid}[index] for of in (plain, stated))
    low, high = own.box
    flat = torch.cartesian_prod(torch.linspace(-0.3, 0.3, 80), torch.linspace(-0.9, 0.1, 120))
    points = torch.nn.functional.pad(flat, (0, 1)) + (low + high) / 2
    one, two = own.margin(points) > 0, other.margin(points) > 0
    assert one.any() and two.any() and not torch.equal(one, two)
    # It is the same disc, another number left out of it.
    assert (one | two).float().mean() < 1.5 * one.float().mean()


@pytest.mark.parametrize(
    "more",
    [
        pytest.param("the number 7 on its side", marks=pytest.mark.slow),
        pytest.param("a white number 7", marks=pytest.mark.slow),
        "the text 12345",
    ],
)
def test_a_number_that_is_not_the_things_own_is_written_anew(more):
    painted = shipped_prior().prompted(f"a race car with {more}", "").of_object(0).painted
    assert not painted.number and len(painted.emblems) == 1


def test_what_is_on_a_door_that_is_no_part_is_on_the_side():
    painted = shipped_prior().prompted("a taxi with the number 7 on its door", "").of_object(0)
    (seven,) = painted.painted.emblems
    assert seven.window.way == WAYS["side"]
    letters = list(looks("taxi")).index("letters")
    assert letters in [one.part for one in painted.painted.marked.laid]  # on its sign


def test_a_run_tells_what_of_the_prompt_is_left_out(tmp_path, monkeypatch):
    """Before it makes anything."""
    monkeypatch.setattr("core.generate.learned_shape", lambda *_, **__: pytest.fail("too late"))
    prompt = "a mug that says HELLO"
    config = replace(DRAFT, geometry=replace(DRAFT.geometry, start="ellipsoid"))
    prompted, light = shipped_prior().prompted(prompt, ""), torch.zeros(2, 4, 3)
    inputs = Inputs(config, torch.device("cpu"), prompted, light, None)
    run = RunFolder.create(tmp_path / "run", Job(prompt=prompt))
    with pytest.raises(pytest.fail.Exception, match="too late"):
        generate(run, inputs, Progress(run))
    (event,) = [e for e in read_events(run.path) if e["type"] == "warning"]
    assert event["text"].startswith('"HELLO": left out')
