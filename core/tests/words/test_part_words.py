"""What words on a part of a thing mean, as a prompt of the whole."""

import pytest

from core.guidance.builtin.words.part_words import of_whole

WHOLE = "a red wooden chair"


@pytest.mark.parametrize(
    ("words", "prompt"),
    [
        ("a blue metal chair", "a blue metal chair"),  # a thing of its own
        ("red velvet", "a red velvet chair"),
        ("a red velvet seat", "a red velvet chair"),
        ("blue", "a blue wooden chair"),  # paint on the same material
        ("gold leaf", "a gold leaf chair"),  # another material has its own colour
        ("striped green", "a striped green wooden chair"),
        ("a seat", "a seat"),  # nothing known: refused as it is
        ("blorb", "blorb"),
    ],
)
def test_words_of_a_part_are_the_look_of_the_whole(words: str, prompt: str):
    assert of_whole(words, WHOLE) == prompt


def test_of_an_unknown_whole_the_words_stay():
    assert of_whole("red velvet", "a steampunk astrolabe") == "red velvet"
    assert of_whole("red velvet", "") == "red velvet"
