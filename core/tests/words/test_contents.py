"""What is on a plate or fills a chest is the thing."""

import pytest

from core.guidance.builtin.words.grammar.lexicon import SLOTS
from core.guidance.builtin.words.phrases.slots import Words
from core.guidance.builtin.words.vocabulary import parse


def read(prompt: str) -> Words:
    """The prompt's words, whatever the shipped weights offer."""
    return parse(prompt, known=SLOTS)


@pytest.mark.parametrize(
    ("prompt", "food"),
    [
        ("a plate of pancakes", "pancakes"),
        ("a tray of pink cupcakes", "cupcake"),
        ("a silver platter of grapes", "grapes"),
        ("a plate with a steak", "steak"),
        ("a plate of the finest sushi", "sushi"),
        ("sushi platter with chopsticks", "sushi"),
        ("a cheese board", "cheese"),
    ],
)
def test_what_is_served_is_the_thing(prompt, food):
    words = read(prompt)
    assert (words.noun, words.material) == (food, "")


@pytest.mark.parametrize(
    ("prompt", "noun"),
    [
        ("a wooden tray", "plate"),
        ("a plate with a gold rim", "plate"),
        ("a plate of armour", "plate"),
        ("a plate with a rim and cheese", "plate"),
        ("cutting board with bread", "cutting board"),
        ("a bowl with a plate", "bowl"),
    ],
)
def test_a_plate_without_food_is_a_plate(prompt, noun):
    assert read(prompt).noun == noun


def test_a_plates_colour_is_not_the_foods():
    words = read("a white plate of blueberry pancakes")
    assert (words.noun, words.color, words.part_shades()) == ("pancakes", "", {"plate": "white"})
    words = read("a blue plate of red strawberries")
    assert (words.noun, words.color) == ("strawberry", "red")


@pytest.mark.parametrize(
    "prompt",
    [
        "a treasure chest full of gold",
        "pirate treasure chest overflowing with coins",
        "a chest filled with gold, jewels and pearls",
        "a chest, full of treasure",
        "a chest with gold coins",
        "an open treasure chest with jewels",
        "a chest full of gold coins and a skull",
        "a chest, iron bands, gold glowing inside",
        "a chest with jewels glittering inside",
        "a treasure chest, slightly open",
        "a chest with an open lid",
        "an open old chest",
    ],
)
def test_a_chest_of_which_one_sees_the_gold_stands_open(prompt):
    words = read(prompt)
    assert (words.noun, words.material) == ("open chest", "")


@pytest.mark.parametrize(
    "prompt",
    [
        "a treasure chest",
        "a chest full of toys",
        "a chest with gold bands",
        "a chest, red velvet inside",
        "a chest beside an open window",
    ],
)
def test_another_chest_is_closed(prompt):
    assert read(prompt).noun == "chest"


def test_the_coins_are_of_their_metal_and_the_bands_of_theirs():
    words = read("an old wooden chest filled with silver coins")
    assert (words.material, words.part_materials()) == ("wooden", {"coins": "silver"})
    words = read("an open chest with iron bands")
    assert words.part_materials() == {"bands": "iron"}
    words = read("a chest, oak planks with iron bands, half open, gold inside")
    assert (words.noun, words.part_materials()["bands"]) == ("open chest", "iron")
    words = read("an open chest with gold bands")
    assert (words.material, words.part_materials()) == ("", {"bands": "golden"})


def test_what_else_is_open_is_no_chest():
    assert read("a bowl beside an open chest").noun == "bowl"
    assert read("a chest of drawers with an open drawer").noun == "dresser"
