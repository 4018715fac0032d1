"""Things with another thing's solid, and parts that are there only where something is said of
them."""

import pytest
import torch

from core.guidance.builtin.markings.markings import Marked, is_marking
from core.guidance.builtin.markings.table import MARKINGS
from core.guidance.builtin.nouns import NOUNS, solid_of
from core.guidance.builtin.nouns.crates_and_drums import CRATES_AND_DRUMS
from core.guidance.builtin.nouns.printed_things import PRINTED_THINGS
from core.guidance.builtin.palette import looks, painted
from core.guidance.builtin.words.tables.colors import COLOR_VALUES
from core.guidance.builtin.words.vocabulary import parse
from core.tests.drawn_things import shipped_prior

OTHERS = (
    "hockey puck",
    "compact disc",
    "school locker",
    "sci-fi door",
    "yoga mat",
    "jupiter",
    "mars",
)
BORROWED = (*CRATES_AND_DRUMS, *PRINTED_THINGS, *OTHERS)
HALF = torch.tensor([0.6, 0.1, 0.9])
ASKED = [noun for noun in NOUNS for part, look in looks(noun).items() if look.asked and part]


def shown(noun, place, half):
    """The part at a place of a thing with one solid, whose markings are all there."""
    names = list(looks(noun))
    box = torch.stack([-half, half])
    marked = Marked(noun, names, [box] + [None] * (len(names) - 1))
    distances = torch.full((1, len(names)), 9.0)
    distances[0, 0] = -0.1
    return names[int(marked(distances, torch.tensor([place]) * half).argmin())]


@pytest.mark.parametrize("noun", BORROWED)
def test_it_is_made_of_another_things_solid_and_read_without_notes(noun):
    words = parse(f"a {noun}")
    assert words.noun == noun and not words.notes and not words.left_out
    assert NOUNS[noun].solid == solid_of(noun) != noun and MARKINGS[noun]
    for name in NOUNS[noun].names.split(";")[0].split(","):
        assert parse(f"a {name.strip()}").noun == noun and not parse(f"a {name.strip()}").notes


@pytest.mark.parametrize(
    ("noun", "place", "part"),
    [
        ("playing card", (0.0, -1.0, 0.0), "pips"),
        ("playing card", (0.0, -1.0, 0.5), "paper"),
        ("playing card", (0.8, 1.0, -0.4), "back"),
        ("treasure map", (0.57, -1.0, -0.17), "cross"),
        ("treasure map", (0.99, -1.0, 0.0), "edges"),
        ("license plate", (0.6, -1.0, 0.68), "bolts"),
        ("credit card", (-0.7, -1.0, 0.06), "chip"),
        ("credit card", (0.0, 1.0, 0.5), "band"),
        ("domino", (0.0, -1.0, 0.0), "line"),
        ("domino", (-0.45, -1.0, 0.78), "pips"),
        ("mahjong tile", (0.0, 1.0, 0.0), "back"),
        ("wanted poster", (0.0, -1.0, 0.22), "hat"),
        ("passport", (1.0, 0.0, 0.0), "pages"),
        ("passport", (0.0, 1.0, 0.0), "cover"),
        ("cereal box", (0.0, 1.0, -0.6), "bowl"),
    ],
)
def test_what_is_printed_lies_where_it_should(noun, place, part):
    assert shown(noun, place, HALF) == part


@pytest.mark.parametrize(
    ("noun", "place", "part"),
    [
        ("oil drum", (0.0, -1.0, 0.36), "bands"),
        ("oil drum", (0.0, 0.0, 1.0), "body"),
        ("oil drum", (0.97, 0.0, 1.0), "rims"),
        ("toxic barrel", (0.0, 0.0, 1.0), "goo"),
        ("toxic barrel", (0.0, -1.0, -0.06), "sign"),
        ("manhole cover", (0.86, 0.0, 1.0), "rings"),
        ("manhole cover", (0.0, 0.0, -1.0), "body"),
        ("landmine", (0.0, 0.0, 1.0), "light"),
        ("jupiter", (0.55, -0.78, -0.29), "storm"),
        ("mars", (0.3, 0.0, 0.95), "ice"),
    ],
)
def test_marks_about_an_upright_axis_lie_where_they_should(noun, place, part):
    assert shown(noun, place, torch.tensor([0.7, 0.7, 0.7])) == part


@pytest.mark.parametrize("side", [-1.0, 1.0])
def test_a_lockers_number_is_not_mirrored_and_may_be_another(side):
    marks = MARKINGS["school locker"]["number"].marks
    at = torch.cartesian_prod(torch.linspace(-0.12, 0.12, 49), torch.linspace(-0.1, 0.1, 41))
    points = torch.stack([at[:, 0] + 0.5 * side, -torch.ones(len(at)), at[:, 1] + 0.3], 1)
    inside = marks(points, torch.ones(3)) > 0
    assert 0 < inside.sum() < len(inside) and at[inside, 0].abs().max() < 0.12
    first = marks(points, torch.ones(3), text="17") > 0
    assert not torch.equal(first, inside)
    left, right = (marks(points - torch.tensor([0.5 * side, 0, 0]) + torch.tensor([x, 0.0, 0.0]),
                         torch.ones(3)) > 0 for x in (-0.5, 0.5))  # fmt: skip
    assert torch.equal(left, right)


@pytest.mark.parametrize(
    ("prompt", "part", "color"),
    [
        ("a cat with white paws", "paws", "white"),
        ("a cat with white boots", "paws", "white"),
        ("a fox with black feet", "paws", "black"),
        ("a dog with brown socks", "paws", "brown"),
        ("a black horse with white socks", "socks", "white"),
        ("a cow with white legs", "socks", "white"),
    ],
)
def test_feet_have_the_colour_that_is_said_of_them(prompt, part, color):
    words = parse(prompt)
    paint = {one.name: one for one in painted(words.noun, words)}[part]
    assert paint.apart and paint.look.asked and not words.companions
    assert paint.color == COLOR_VALUES[color]


@pytest.mark.parametrize("prompt", ["a cat wearing red boots", "a fox in socks", "a cat in boots"])
def test_what_an_animal_wears_is_not_its_feet(prompt):
    words = parse(prompt)
    assert not words.accents
    assert not any(one.apart for one in painted(words.noun, words) if one.look.asked)


@pytest.mark.parametrize("prompt", ["a cat without paws", "a horse with no socks"])
def test_feet_cannot_be_taken_away_and_that_is_reported(prompt):
    words = parse(prompt)
    assert not words.absent and len(words.left_out) == 1
    assert "not a separate part" in words.notes[0]


@pytest.mark.parametrize("noun", dict.fromkeys(ASKED))
def test_feet_are_marked_at_the_lower_end_and_only_if_something_is_said_of_them(noun):
    part = next(name for name, look in looks(noun).items() if look.asked)
    assert is_marking(noun, part) and next(iter(MARKINGS[noun])) == part
    marks = MARKINGS[noun][part].marks
    points = torch.tensor([[0.0, 0.0, -0.95], [0.0, 0.0, -0.5], [0.0, 0.0, 0.9]])
    assert (marks(points, torch.ones(3)) > 0).tolist() == [True, False, False]
    plain, said = parse(f"a white {noun}"), parse(f"a {noun} with red {part}")
    assert [one.apart for one in painted(noun, plain) if one.look.asked] == [False]
    assert [one.apart for one in painted(noun, said) if one.look.asked] == [True]


@pytest.mark.parametrize(
    ("prompt", "there"),
    [("a cat", False), ("a cat with paws", False), ("a cat with red paws", True)],
)
def test_feet_are_an_area_only_if_something_is_said_of_them(prompt, there):
    drawn = shipped_prior().prompted(prompt, "").of_object(1)
    fields = drawn.area_fields()
    points = drawn.solid.mesh[0]
    part = list(looks("cat")).index("paws")
    on = fields.near(points)[1].argmax(1) == part
    assert on.any() == there
    if there:
        assert points[on, 2].max() < points[:, 2].min() + 0.25 * (
            points[:, 2].max() - points[:, 2].min()
        )


@pytest.mark.parametrize(
    ("prompt", "part"),
    [
        ("a motorcycle with red lights", "lamp"),
        ("a scooter with red lights", "lamp"),
        ("a car with red lights", "lamps"),
        ("a tractor with red headlights", "lamps"),
        ("a ufo with red lights", "lights"),
    ],
)
def test_a_vehicles_lights_are_its_lamps(prompt, part):
    words = parse(prompt)
    paint = {one.name: one for one in painted(words.noun, words)}[part]
    assert paint.color == COLOR_VALUES["red"] and paint.apart and not words.notes
    neon = parse("a motorcycle with neon lights")
    assert [(one.part, one.sheen) for one in neon.accents] == [("lamp", "glowing")]
