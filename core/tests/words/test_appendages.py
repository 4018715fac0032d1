"""Wings, horns and ears of what has none: read as things on its body."""

import pytest

from core.guidance.builtin.composition.placing.wearing import freed
from core.guidance.builtin.nouns import NOUNS
from core.guidance.builtin.nouns.appendages import APPENDAGES
from core.guidance.builtin.words.vocabulary import parse


def worn(prompt: str) -> tuple[str, list[tuple[str, str]]]:
    words = parse(prompt)
    return words.noun, [(one.relation, one.words.noun) for one in words.companions]


@pytest.mark.parametrize(
    ("prompt", "noun", "on_it"),
    [
        ("a pig with wings", "pig", ["wings"]),
        ("a winged lion with a golden crown", "lion", ["wings", "crown"]),
        ("a horned rabbit", "rabbit", ["horns"]),
        ("a car with wings", "car", ["wings"]),
        ("a girl with cat ears and a halo", "girl", ["cat ears", "halo"]),
        ("a dog with bunny ears", "dog", ["bunny ears"]),
        ("an angel with bat wings", "angel", ["bat wings"]),
        ("a robot with devil horns and a devil tail", "robot", ["devil horns", "devil tail"]),
        # What has them by itself keeps its own.
        ("a dragon with red wings", "dragon", []),
        ("a winged demon", "demon", []),
        ("a winged horse", "pegasus", []),
        ("a horned helmet", "viking helmet", []),
        ("a bird with blue wings", "bird", []),
        ("chicken wings", "chicken", []),
    ],
)
def test_who_has_what(prompt, noun, on_it):
    assert worn(prompt) == (noun, [("wears", one) for one in on_it])


@pytest.mark.parametrize("noun", APPENDAGES)
def test_each_is_read_by_itself_as_one_and_without_notes(noun):
    words = parse(f"a pair of {noun}" if noun.endswith("s") else f"a {noun}")
    assert (words.noun, words.count, words.notes, words.left_out) == (noun, 1, (), ())
    assert NOUNS[noun].constructed


def test_a_stated_look_is_theirs_and_the_own_ones_go():
    lion = parse("a lion with golden wings")
    assert not lion.material and lion.companions[0].words.material == "golden"
    angel = parse("an angel with black bat wings")
    pairs = [(one.relation, one.words) for one in angel.companions]
    assert pairs[0][1].color == "black" and "wings" in freed(angel, pairs).absent
