"""A thing's parts in a prompt: what it has, what it lacks, what it calls them."""

import pytest

from core.errors import UserError
from core.guidance.builtin.words.phrases.slots import Words
from core.guidance.builtin.words.vocabulary import parse, understood


@pytest.mark.parametrize(
    ("prompt", "part"),
    [
        ("a chair without armrests", "no armrests"),
        ("armchair with armrests", ""),
        ("a chair with arms", "armrests"),
        ("a chair with four legs", ""),
        ("a table with four legs", "four legs"),
        ("a three-legged stool", "three legs"),
        ("stool with 4 legs", "four legs"),
        ("a table with white legs", "four legs"),  # not on one
        ("a table with a white leg", ""),
        ("a table with one leg and brass legs", "one leg"),
        ("a table on a pedestal", "one leg"),
        ("a mug with no handle", "no handle"),
        ("a bottle with a lid", "cap"),
        ("a snowman without a hat", "no hat"),
        ("a snowman with a top hat", "hat"),
        ("a car with wheels", ""),
    ],
)
def test_the_state_of_a_part_is_read_where_a_thing_may_lack_it(prompt, part):
    assert parse(prompt).part == part


def test_a_hat_of_its_own_is_a_thing():
    assert parse("a hat").noun == "hat"


def test_a_part_that_a_thing_never_has_is_left_out_and_one_that_it_always_has_is_not():
    for prompt, form in (
        ("a ball with a handle", "handle"),
        ("a mug with a red lid", "red lid"),
        ("a person with strong arms", "arm"),
        ("a chair with three legs", "three legs"),
    ):
        words = parse(prompt)
        assert any(note.startswith(f"{form}: left out") for note in words.notes)
        assert form in words.left_out and not (words.part or words.second)


@pytest.mark.parametrize(
    ("prompt", "absent"),
    [
        ("a dragon without wings", ("wings",)),
        ("a house with no roof", ("roof", "chimney")),
        ("a car without wheels and without windows", ("wheels", "hubs", "windows")),
        ("a donut without icing", ("icing", "sprinkles", "strands", "drops")),
        ("a robot without a head", ("head", "eyes", "aerial")),
        ("a bus without wheels or windows", ("wheels", "hubs", "windows")),
        ("a bus without wheels and windows and a red body", ("wheels", "hubs", "windows")),
        ("a dragon with no wings nor horns", ("wings", "horns")),
        ("a pizza without olives", ("olives",)),  # which is no colour here
        ("a sneaker without laces or stripes", ("laces", "stripes")),
        ("a tree without leaves", ("leaves",)),
        ("a chair without legs, red", ("legs",)),
        ("a teapot without a lid", ("lid",)),  # the first row of the lexicon calls it a cap
        ("a mug without a handle", ("handle",)),  # where it may be stated too
        ("a bus without a wheel", ("wheels", "hubs")),
        ("a chair without armrests", ("arms",)),
    ],
)
def test_a_thing_is_made_without_any_of_its_parts(prompt, absent):
    words = parse(prompt)
    assert words.absent == absent
    assert not words.left_out
    assert understood(prompt)["parts"][-len(absent) :] == [f"no {part}" for part in absent]


def test_one_or_another_is_no_choice_and_that_is_said():
    assert parse("a red or blue car").left_out == ("or",)
    assert not parse("a car without wheels or windows").left_out


def test_what_is_no_part_by_itself_is_not_left_away_and_all_of_a_thing_neither():
    for prompt, form in (
        ("a mug without a spout", "spout"),
        ("a robot without arms", "arm"),
        ("a knight without a helmet", "helmet"),  # else a thing
        ("a pizza without candles", "candle"),
    ):
        words = parse(prompt)
        assert (words.absent, words.left_out) == ((), (f"without {form}",))
        assert words.notes == (f"without {form}: left out, as that is not a separate part here.",)
    assert parse("a cake without candles").absent == ("candles", "flames")
    # What may be stated is learnt, whatever the part is called.
    words = parse("a candle without a handle")
    assert (words.part, words.absent, words.notes) == ("no handle", (), ())
    with pytest.raises(UserError, match="cannot make a mug without body"):
        parse("a mug without a body")
    with pytest.raises(UserError, match="cannot make a princess without dress"):
        parse("a princess without a dress")


@pytest.mark.parametrize(
    ("prompt", "colors"),
    [
        ("a sneaker with red laces", {"laces": "red"}),
        ("a tiger with blue stripes", {"stripes": "blue"}),  # no pattern of all of it
        ("a hot dog with green mustard", {"mustard": "green"}),
        ("a campfire with white stones", {"stones": "white"}),
        ("a camper with an orange stripe", {"stripe": "orange"}),
    ],
)
def test_what_the_thing_itself_calls_a_part_is_one_whatever_it_means_elsewhere(prompt, colors):
    words = parse(prompt)
    assert words.part_shades() == colors
    assert not (words.color or words.pattern or words.material or words.left_out)
    # But not as what it is made of, or a colour of all of it.
    assert parse("an island made of stones").material == "stone"
    assert parse("an eyeball, white").color == "white"


def test_a_part_may_go_by_the_name_that_the_thing_has_for_it():
    words = parse("a teapot with a navy lid")
    assert (words.second, words.pattern, words.part) == ("navy", "", "")
    assert words.target == "lid"
    assert parse("a white teapot with a lid").color == "white"
    assert parse("a bottle without a lid").part == "no cap"


def test_a_thing_is_a_part_after_a_thing_that_has_it():
    assert parse("a red cap").noun == "baseball cap"
    assert parse("a bottle without a cap").part == "no cap"
    words = parse("a black piano with white keys")
    assert (words.noun, words.second, words.target) == ("piano", "white", "keys")
    assert parse("a golden key").noun == "key"


def test_a_parts_name_before_a_thing_qualifies_it_and_in_a_phrase_of_its_own_is_the_part():
    words = parse("a roof tower")
    assert (words.noun, words.left_out) == ("tower", ("roof",))
    assert parse("the spout of a red teapot") == Words("teapot", color="red")
    assert parse("the wheel of a red car") == Words("wheel")  # a thing of its own
    assert parse("a three-legged stool").part == "three legs"


@pytest.mark.parametrize(
    ("prompt", "words", "part"),
    [
        ("a torus with pink icing", Words("torus"), "pink icing"),
        ("a barrel of water", Words("barrel"), "water"),
        ("a black robot with a red glow", Words("robot", color="black"), "red glow"),
    ],
)
def test_a_part_that_the_thing_has_not_is_left_out_and_said_so(prompt, words, part):
    found = parse(prompt)
    assert found == words
    assert found.notes == (f"{part}: left out, as a {words.noun} has none here.",)
    assert " ".join(found.left_out) == part


@pytest.mark.parametrize(
    ("prompt", "colors"),
    [
        ("a lantern with a green flame", {"glass": "green"}),
        ("a campfire with blue flames", {"flame": "blue"}),
        ("a torch with green fire", {"flame": "green"}),
        ("a spaceship with a blue glow", {"flames": "blue"}),
    ],
)
def test_what_burns_and_what_glows_is_found_by_either_name(prompt, colors):
    assert understood(prompt)["part_colours"] == colors


def test_a_slip_in_the_name_of_a_part_that_the_thing_has_is_read_as_that():
    words = parse("a donut with green sprinkls")
    assert words.of_parts("color") == {"sprinkles": "green"}
    assert "'sprinkls' is read as 'sprinkles'." in words.notes
    assert parse("a chair with green sprinkls").of_parts("color") == {}
