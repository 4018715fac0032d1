"""Words for bouquets and for flowers in a vase."""

import pytest

from core.guidance.builtin.words.vocabulary import parse


def flowers_of(words):
    """Each kind with its colour and number, the first one too if it is a flower."""
    each = [words, *(one.words for one in words.companions if one.relation == "bears")]
    return [(one.color, one.noun, one.count) for one in each if one.noun != "vase"]


@pytest.mark.parametrize(
    ("prompt", "kinds"),
    [
        ("a bouquet of roses", [("", "rose", 5)]),
        ("a rose bouquet", [("", "rose", 5)]),
        ("a bridal bouquet of white tulips", [("white", "tulip", 5)]),
        ("a bouquet of red and white roses", [("red", "rose", 3), ("white", "rose", 2)]),
        ("a bouquet of roses and daisies", [("", "rose", 3), ("", "flower", 3)]),
        ("a bouquet of flowers", [("", "rose", 2), ("", "flower", 2), ("", "tulip", 2)]),
        ("a bunch of yellow flowers", [("yellow", "flower", 5)]),
    ],
)
def test_a_bouquet_is_a_bunch_of_its_flowers(prompt, kinds):
    words = parse(prompt)
    assert (flowers_of(words), words.order) == (kinds, "heap")
    assert not words.notes and not words.left_out


@pytest.mark.parametrize(
    ("prompt", "kinds"),
    [
        ("a bouquet of sunflowers in a vase", [("", "sunflower", 5)]),
        ("a flower arrangement in a blue vase", [("", n, 2) for n in ("rose", "flower", "tulip")]),
        ("a vase with red and white roses", [("red", "rose", 3), ("white", "rose", 2)]),
        ("a vase with roses and tulips", [("", "rose", 3), ("", "tulip", 3)]),
        ("a vase of wildflowers", [("", n, 2) for n in ("rose", "flower", "tulip")]),
        ("a vase with three yellow tulips", [("yellow", "tulip", 3)]),
        ("a vase with a tulip", [("", "tulip", 1)]),
    ],
)
def test_a_vase_bears_flowers(prompt, kinds):
    words = parse(prompt)
    assert (words.noun, flowers_of(words), words.left_out) == ("vase", kinds, ())


@pytest.mark.parametrize(("prompt", "count"), [("tulips in a vase", 5), ("a tulip in a vase", 1)])
def test_flowers_in_a_vase_are_as_many_as_stated(prompt, count):
    words = parse(prompt)
    assert (words.noun, words.count, words.companions[0].words.noun) == ("tulip", count, "vase")


def test_what_a_bouquet_is_wrapped_in_is_left_out():
    words = parse("a bouquet of red tulips wrapped in paper")
    assert (words.color, words.material, words.count) == ("red", "", 5)
    assert words.notes == ("wrapped in paper: left out, as only the flowers are made.",)
    assert parse("a bunch of bananas").count == 5 and not parse("a bunch of bananas").companions
