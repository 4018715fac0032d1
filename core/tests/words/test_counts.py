"""How many of a thing a prompt wants, and how they lie: a number, a pair, a pile, what fills it."""

import pytest

from core.guidance.builtin.words.phrases.slots import Words
from core.guidance.builtin.words.vocabulary import parse, understood


def counted(words: Words) -> tuple[str, int, str]:
    """The thing with its looks, how many of it there are, and how they lie."""
    return str(words), words.count, words.order


@pytest.mark.parametrize(
    ("prompt", "thing", "count", "order"),
    [
        ("two apples", "apple", 2, "row"),
        ("2 cats", "cat", 2, "row"),
        ("three wooden barrels", "wooden barrel", 3, "row"),
        ("three old, wooden barrels", "wooden barrel", 3, "row"),
        ("two red and white mushrooms", "two-tone red mushroom", 2, "row"),
        ("a pair of dice", "dice", 2, "row"),
        ("two dice", "dice", 2, "row"),
        ("three fish", "fish", 3, "row"),
        ("three snowmen", "snowman", 3, "row"),
        ("five candles", "candle", 5, "row"),
        ("three candles", "candle", 3, "row"),
        ("a couple of pumpkins", "pumpkin", 2, "row"),
        ("a trio of mushrooms", "mushroom", 3, "row"),
        ("half a dozen eggs", "egg", 6, "row"),
        ("twin swords", "sword", 2, "row"),
        ("a 3d render of two red apples", "red apple", 2, "row"),
        ("two cups of coffee", "teacup", 2, "row"),
        ("two slices of pizza", "pizza", 2, "row"),
        ("two desk lamps", "desk lamp", 2, "row"),
        ("two lion statues", "stone lion", 2, "row"),
        ("three books", "book", 3, "row"),
        ("three drums", "drum", 3, "row"),
        ("three apples in a row", "apple", 3, "row"),
        ("several apples", "apple", 3, "row"),
        ("some apples", "apple", 3, "row"),
        ("a few red apples", "red apple", 3, "row"),
        ("a set of golf clubs", "golf club", 3, "row"),
        ("a dozen eggs", "egg", 5, "heap"),
        ("twelve eggs", "egg", 5, "heap"),
        ("lots of apples", "apple", 5, "heap"),
        ("many apples", "apple", 5, "heap"),
        ("a bunch of bananas", "banana", 5, "heap"),
        ("a group of penguins", "penguin", 5, "row"),  # what is alive is in no heap
        ("a school of fish", "fish", 5, "row"),
        ("many cars", "car", 5, "row"),  # nor what is as large
        ("a pair of boots", "boot", 2, "row"),
        ("a pair of red sneakers", "red sneaker", 2, "row"),
        ("two pairs of boots", "boot", 4, "row"),
        ("some sneakers", "sneaker", 2, "row"),
        ("cowboy boots", "boot", 2, "row"),
        ("boxing gloves", "boxing glove", 2, "row"),
        ("sandals", "sandal", 2, "row"),
        ("high heels", "high heel", 2, "row"),
        ("socks", "sock", 2, "row"),
        ("roller skates", "roller skate", 2, "row"),
        ("three cherries", "cherry", 2, "row"),  # of which one is two
        ("red balloons", "red balloon", 3, "row"),
        ("mushrooms", "mushroom", 3, "row"),
        ("old gold coins", "golden coin", 3, "row"),
        ("cats on a sofa", "cat", 3, "row"),
        ("a deck of cards", "playing card", 5, "stack"),
        ("a pile of gold coins", "golden coin", 7, "heap"),
        ("a huge pile of treasure", "golden coin", 7, "heap"),
        ("a heap of skulls", "skull", 7, "heap"),
        ("a mound of pumpkins", "pumpkin", 7, "heap"),
        ("a mountain of skulls", "skull", 7, "heap"),
        ("a pile of leaves", "leaf", 7, "heap"),
        ("a red pile of apples", "red apple", 7, "heap"),
        ("a heap of three skulls", "skull", 3, "heap"),
        ("a stack of plates", "plate", 5, "stack"),
        ("a stack of stones", "boulder", 5, "stack"),
        ("a pile of bricks", "brick block", 7, "heap"),
        ("a coin stack", "coin", 5, "stack"),
        ("a rusty coin pile", "rusty coin", 7, "heap"),
        ("a rock pile", "boulder", 7, "heap"),
        ("a dice pile", "dice", 7, "heap"),
        ("a rock cairn", "boulder", 5, "stack"),
        ("an unstable cairn in the middle of a stream", "boulder", 5, "stack"),
        ("a pile of sushi", "sushi", 7, "heap"),
        ("a stack of gold coins", "golden coin", 5, "stack"),
        ("a stack of boxes", "cardboard box", 5, "stack"),
        ("a stack of three crates", "crate", 3, "stack"),
        ("three stacked crates", "crate", 3, "stack"),
        ("stacked crates", "crate", 3, "stack"),
        ("four crates stacked on top of each other", "crate", 4, "stack"),
    ],
)
def test_several_are_made(prompt, thing, count, order):
    words = parse(prompt)
    assert counted(words) == (thing, count, order)
    assert not any("one thing is made" in note for note in words.notes)
    assert words.usual()[0] == parse(f"a {words.noun}").usual()[0]


@pytest.mark.parametrize(
    ("prompt", "thing"),
    [
        ("my apples", "apple"),
        ("stairs", "staircase"),
        ("bunk beds", "bunk bed"),
        ("statues of lions", "stone lion"),
        ("one apple", "apple"),
        ("a sneaker", "sneaker"),
        ("a cowboy boot", "boot"),
        ("dice", "dice"),
        ("a pair of scissors", "scissors"),
        ("two pairs of trousers", "trousers"),
        ("jeans", "trousers"),
        ("a pair of glasses", "sunglasses"),
        ("a pair of headphones", "headphones"),
        ("a pair of binoculars", "binoculars"),
        ("a bunch of grapes", "grapes"),
        ("two cherries", "cherry"),
        ("pancakes", "pancakes"),
        ("a stack of pancakes", "pancakes"),
        ("a stack of books", "stack of books"),
        ("a book pile", "stack of books"),
        ("a hay stack", "hay bale"),
        ("a pile of old books", "stack of books"),
        ("many books", "stack of books"),
        ("a pair of maracas", "maracas"),
        ("a cluster of crystals", "crystal"),
        ("a candelabra with three candles", "candelabra"),
        ("a four poster bed", "four-poster bed"),
        ("a three-legged stool", "stool"),
        ("a table with four legs", "table"),
        ("a car with two doors", "car"),
        ("a two-tone car", "two-tone car"),
        ("a two headed dragon", "dragon"),
        ("a two story house", "house"),
        ("a 3 seater sofa", "sofa"),
        ("a six sided die", "dice"),
        ("a 24 karat gold ring", "ring"),
        ("a 1967 mustang", "sports car"),
        ("two metres tall robot", "robot"),
        ("a 2 m robot", "robot"),
        ("a red roof, two windows, a house", "house"),
        ("a school", "school"),
        ("a mountain", "mountain"),
        ("a nest with three eggs in it", "nest"),
        ("a bowl of ramen", "ramen"),
        ("a plate of pancakes", "pancakes"),
        ("a bucket of popcorn", "popcorn"),
        ("a box of chocolates", "cardboard box"),
        ("a mug with strawberries", "mug"),
        ("a chest full of gold coins", "open chest"),
    ],
)
def test_one_stays_one(prompt, thing):
    words = parse(prompt)
    assert counted(words) == (thing, 1, "row")
    assert words.companions == ()


@pytest.mark.parametrize(
    ("prompt", "relation", "other", "count", "order"),
    [
        ("a plate on two books", "on", "book", 2, "row"),
        ("a cat on two red pillows", "on", "red pillow", 2, "row"),
        ("a bear on roller skates", "on", "roller skate", 2, "row"),
        ("a dragon sleeping on a pile of gold coins", "on", "golden coin", 7, "heap"),
        ("a corgi in a pile of leaves", "on", "leaf", 7, "heap"),
        ("a bird on a stack of three crates", "on", "crate", 3, "stack"),
        ("a turtle with two houses on its back", "bears", "house", 2, "row"),
        ("a robot holding two swords", "holds", "sword", 1, "row"),
        ("a robot holding a stack of plates", "holds", "plate", 1, "row"),
        ("a basket of apples", "bears", "apple", 6, "heap"),
        ("a basket full of eggs", "bears", "egg", 6, "heap"),
        ("a basket with apples in it", "bears", "apple", 6, "heap"),
        ("a basket with three red apples in it", "bears", "red apple", 3, "heap"),
        ("a basket of books", "bears", "book", 6, "heap"),
        ("a basket of kittens", "bears", "cat", 3, "heap"),
        ("a bowl of cherries", "bears", "cherry", 6, "heap"),
        ("a bowl of grapes", "bears", "grapes", 1, "row"),
        ("a crate filled with green bottles", "bears", "green bottle", 6, "heap"),
        ("a crate of red and green apples", "bears", "two-tone red apple", 6, "heap"),
        ("a wheelbarrow full of pumpkins", "bears", "pumpkin", 6, "heap"),
        ("a bucket of fish", "bears", "fish", 6, "heap"),
        ("a box of donuts", "bears", "donut", 6, "heap"),
        ("a mug of pencils", "bears", "pencil", 6, "heap"),
        ("a vase of red tulips", "bears", "red tulip", 5, "heap"),
        ("a vase with a red tulip", "bears", "red tulip", 1, "row"),
        ("a basket of daisies", "bears", "flower", 5, "heap"),
        ("a plate of croissants", "on", "plate", 1, "row"),
        ("a wooden tray of three cupcakes", "on", "wooden plate", 1, "row"),
    ],
)
def test_there_are_several_of_what_goes_with_it(prompt, relation, other, count, order):
    (one,) = parse(prompt).companions
    assert (one.relation, *counted(one.words)) == (relation, other, count, order)


def test_of_what_is_held_there_is_one_and_that_is_said():
    words = parse("a robot holding two swords")
    assert words.notes == ("two: one thing is made at a time.",)


def test_what_lies_on_a_plate_is_a_heap():
    assert counted(parse("a plate of croissants")) == ("croissant", 5, "heap")
    assert counted(parse("a wooden tray of three cupcakes")) == ("cupcake", 3, "heap")
    assert counted(parse("a basket of red apples and green pears"))[0] == "basket"


def test_what_is_too_large_fills_nothing():
    words = parse("a mug of pumpkins")
    assert words.companions == ()
    assert words.left_out == ("pumpkin",)


def test_more_than_are_made_are_reported():
    assert parse("twelve eggs").notes == ("twelve: 5 are made.",)


def test_the_report_has_how_many_there_are_and_how_they_lie():
    found = understood("a dragon on a pile of gold coins")
    assert (found["count"], found["order"]) == (1, "row")
    assert [(one["count"], one["order"]) for one in found["companions"]] == [(7, "heap")]
    found = understood("three apples")
    assert (found["count"], found["order"]) == (3, "row")
