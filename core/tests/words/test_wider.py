"""Words for more than a thing behind its name, names that are written apart, and common slips."""

import pytest

from core.errors import UserError
from core.guidance.builtin.nouns import NOUNS
from core.guidance.builtin.words.grammar.lexicon import LEXICON, SLOTS
from core.guidance.builtin.words.grammar.tokens import Tokens
from core.guidance.builtin.words.grammar.wider import WIDER, is_wider
from core.guidance.builtin.words.tables.nearest import MISSPELLED
from core.guidance.builtin.words.vocabulary import parse, understood


@pytest.mark.parametrize(
    ("prompt", "thing"),
    [
        ("a corgi puppy", "corgi"),
        ("a corgi dog in a hat", "corgi"),
        ("a fox animal", "fox"),
        ("a wolf pup", "wolf"),
        ("an owl bird", "owl"),
        ("a red taxi car", "taxi"),
        ("a biplane plane", "biplane"),
        ("a throne chair", "throne"),
        ("a wooden sword weapon", "sword"),
        ("a carrot vegetable", "carrot"),
        ("a castle building", "castle"),
        ("a dragon monster", "dragon"),
        ("a robot man", "robot"),
        ("a beehive box", "beehive"),
        ("a laptop computer", "laptop"),
    ],
)
def test_a_wider_word_behind_the_thing_changes_nothing(prompt, thing):
    words = parse(prompt)
    assert words.noun == thing
    assert words.left_out == ()
    assert [one.words.noun for one in words.companions] == ["hat"] * ("hat" in prompt)


@pytest.mark.parametrize(
    ("prompt", "thing"),
    [
        ("a laptop computer bag", "handbag"),
        ("a fox mask", "mask"),
        ("a teapot lamp", "lamp"),
        ("a dragon lamp", "lamp"),
        ("a dragon monster truck", "monster truck"),  # a longer name begins with the wider word
        ("a knight, the man", "knight"),
    ],
)
def test_another_thing_behind_a_thing_is_the_one_that_is_meant(prompt, thing):
    assert parse(prompt).noun == thing


def test_the_wider_words_are_of_known_things():
    assert set().union(*WIDER.values()) <= set(NOUNS)
    assert is_wider("puppies", "corgi")
    assert not is_wider("puppy", "cat")


@pytest.mark.parametrize(
    ("prompt", "thing", "material"),
    [
        ("a snow man", "snowman", ""),
        ("a hour glass", "hourglass", ""),
        ("a gold fish", "fish", "golden"),  # one of gold
        ("a steel hammer head", "hammer", "metal"),  # no hammerhead
        ("a box wood texture", "cube", "wooden"),
        ("a dog that has sock", "dog", ""),
        ("a red fire hydrant", "fire hydrant", ""),  # a name of two words
        ("a teddybear", "teddy bear", ""),
        ("an officechair", "office chair", ""),
    ],
)
def test_a_name_may_be_written_apart_or_together(prompt, thing, material):
    words = parse(prompt)
    assert (words.noun, words.material) == (thing, material)


def test_one_person_is_a_person():
    assert parse("one person").noun == "person"
    assert parse("one man in a hat").noun == "person"


def test_halves_of_two_clauses_are_no_name():
    assert Tokens.of("a snow, man", SLOTS).words == ["a", "snow", "man"]
    assert Tokens.of("a snow man", SLOTS).words == ["a", "snowman"]


def test_common_misspellings_are_read_and_said():
    words = parse("a yello bycicle")
    assert (words.noun, words.color) == ("bicycle", "yellow")
    assert words.notes == ("'yello' is read as 'yellow'.", "'bycicle' is read as 'bicycle'.")
    assert set(MISSPELLED) <= set(LEXICON)
    assert not [form for text in MISSPELLED.values() for form in text.split() if form in LEXICON]


def test_behind_a_thing_a_slip_is_first_another_word_than_a_thing():
    """Of "finsh" both a fish and a finish may be meant."""
    guitar = parse("a guitar with a glossy finsh")
    assert (guitar.noun, guitar.left_out) == ("guitar", ())
    assert parse("a red finsh").noun == "fish"


@pytest.mark.parametrize(
    ("prompt", "thing"),
    [
        ("an aerial view of a castle", "castle"),
        ("a bird's eye view of a house", "house"),
        ("a top down shot of a pizza", "pizza"),
        ("a two story house", "house"),
        ("a three-seater sofa", "sofa"),
    ],
)
def test_how_it_is_seen_and_how_many_of_what_is_no_part_are_left_out(prompt, thing):
    found = understood(prompt)
    assert found["thing"] == thing
    assert not any("one thing" in note for note in found["notes"])


def test_a_finish_is_no_thing_by_itself():
    assert parse("a red guitar finish").noun == "guitar"
    with pytest.raises(UserError):
        parse("a guitar case")


def test_the_drawers_of_a_nightstand_are_no_count():
    assert parse("a nightstand with one drawer").left_out == ()
