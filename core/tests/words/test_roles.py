"""Roles: "a penguin chef", "a farmer"; and what "with" and "by" say of who has something."""

import pytest

from core.errors import UserError
from core.guidance.builtin.words.tables.costumes import ROLES
from core.guidance.builtin.words.vocabulary import parse


def read(prompt: str) -> tuple[str, list[str]]:
    """The thing, and each other as "wears red hat"."""
    words = parse(prompt)
    return words.noun, [f"{one.relation} {one.words}" for one in words.companions]


@pytest.mark.parametrize(
    ("prompt", "thing", "others"),
    [
        ("a penguin chef", "penguin", ["wears chef hat", "wears white shirt"]),
        ("a chef penguin", "penguin", ["wears chef hat", "wears white shirt"]),
        ("a pirate cat", "cat", ["wears pirate hat"]),
        ("a cute frog prince", "frog", ["wears golden crown", "wears blue cape"]),
        ("a robot samurai", "samurai", []),
        ("a ninja turtle", "turtle", ["wears black scarf", "holds katana"]),
        ("a dog police officer", "dog", ["wears navy baseball cap", "wears navy shirt"]),
        ("a warrior princess", "princess", ["wears helmet", "holds sword"]),
        ("a skeleton pirate with a cutlass", "skeleton", ["holds sword", "wears pirate hat"]),
        ("a pirate cat on a boat", "cat", ["on boat", "wears pirate hat"]),
        (
            "a goblin king holding an axe",
            "goblin",
            ["holds axe", "wears golden crown", "wears red cape"],
        ),
        ("a hedgehog punk rocker", "hedgehog", ["wears sunglasses", "holds electric guitar"]),
        ("a rocker", "rocking chair", []),
        ("a bear surfer", "bear", ["holds surfboard"]),
        ("a banana skateboarder", "banana", ["on skateboard"]),
        ("a golfer", "person", ["holds golf club"]),
        ("a king penguin", "penguin", []),
        ("a vampire bat", "bat", []),
        ("a pirate ship", "pirate ship", []),
        ("a wizard tower", "tower", []),
        ("a pirate", "pirate", []),
        ("a chess king", "chess king", []),
        ("a soldier ant", "ant", []),
        ("a guard dog", "dog", []),
        ("a christmas cake", "cake", []),
        ("a sushi chef", "chef", []),
        ("a bear hunter", "person", ["wears brown jacket", "holds rifle"]),
        ("a woman warrior", "knight", []),
        ("an evil wizard frog", "frog", ["wears blue wizard hat", "wears blue cape"]),
        ("a cat that has a pirate hat", "cat", []),
        ("a dog dressed as a queen bee", "dog", []),
        ("a bed as a pirate ship", "bed", []),
        ("a farmer and a cow", "person", ["wears cowboy hat", "holds rake", "beside cow"]),
        (
            "a penguin chef next to an oven",
            "penguin",
            ["wears chef hat", "wears white shirt", "beside stove"],
        ),
        ("a crocodile dentist", "crocodile", ["wears white fabric jacket"]),
        ("a zombie cheerleader", "zombie", ["wears red dress"]),
        ("a skelton pirate", "skeleton", ["wears pirate hat"]),
        ("my pug as a king with a cape", "pug", ["wears cape", "wears golden crown"]),
        ("a dwarf smith with a hammer", "dwarf", ["holds hammer"]),
        ("a golden crown for a pirate cat", "crown", []),
    ],
)
def test_who_has_a_role_has_its_costume(prompt, thing, others):
    assert read(prompt) == (thing, others)


@pytest.mark.parametrize(
    ("prompt", "others"),
    [
        ("a farmer", ["wears cowboy hat", "holds rake"]),
        (
            "an old fisherman in a boat",
            ["in boat", "wears yellow fabric jacket", "holds fishing rod"],
        ),
        ("a lumberjack holding a sword", ["holds sword", "wears red beanie"]),
        ("a farmer in a red hat", ["wears red hat", "holds rake"]),
        ("a man", []),
    ],
)
def test_a_person_of_a_trade_has_what_tells_it(prompt, others):
    assert read(prompt) == ("person", others)


def test_what_a_costume_has_is_not_told_of():
    words = parse("a raccoon detective")
    assert [one.words.noun for one in words.companions] == ["jacket", "hat"]
    assert not words.notes and not words.left_out


def test_what_is_stated_of_a_costume_is_there_once():
    words = parse("a pug dressed as a king with a crown and a blue cape")
    assert [str(one.words) for one in words.companions] == ["crown", "blue cape"]
    assert not words.left_out


@pytest.mark.parametrize("role", sorted(ROLES))
def test_every_costume_is_of_things_that_are_known(role):
    for one in ROLES[role]:
        worn = parse(f"a bear {one}")
        assert worn.noun == "bear" and len(worn.companions) == 1
        assert not worn.left_out


@pytest.mark.parametrize(
    ("prompt", "thing", "others"),
    [
        ("a skeleton with a sword", "skeleton", ["holds sword"]),
        ("a monkey with a banana", "monkey", ["holds banana"]),
        ("a man with a rabbit", "person", ["holds rabbit"]),
        ("a girl with long tails and a sword", "girl", ["holds sword"]),
        ("a mech with spider legs", "mech", []),
        ("a gnome with a fishing rod", "gnome", ["holds fishing rod"]),
        ("a boy with a skateboard", "boy", ["beside skateboard"]),
        ("a girl with a teddy bear", "girl", ["holds teddy bear"]),
        ("a deer with a lantern on its antlers", "deer", []),
        ("a dragon with a sword through its chest", "dragon", []),
        ("a snail with a clock in its shell", "snail", []),
        ("a cow with a bell around its neck", "cow", []),
        ("a cat with star pattern", "cat", []),
        ("a teddy bear with a blue bow", "teddy bear", []),
        ("an alien waving from a ufo", "alien", []),
        ("a cat with a fish", "cat", ["holds fish"]),
        ("a man with a dog", "person", ["beside dog"]),
        ("a horse with a saddle", "horse", ["bears saddle"]),
        ("a knight with a shield", "knight", []),
        ("a robot with a screen", "robot", []),
        ("a pumpkin with a candle", "pumpkin", []),
        ("a house with a door", "house", []),
        ("a mug with a cat", "mug", []),
        ("a cute cat, blue hat, sitting", "cat", ["wears blue hat"]),
        ("an elf, leather armor, green cloak", "elf", ["wears leather chestplate",
                                                       "wears green cape"]),
        ("a sloth hanging from a lamp wearing headphones", "sloth", ["wears headphones"]),
        ("a stack of books with a skull and a candle on top", "stack of books",
         ["bears skull", "bears candle"]),
        ("a turtle with a house and a tree on its back", "turtle", ["bears tree", "bears house"]),
    ],
)  # fmt: skip
def test_what_with_says_of_who_has_it(prompt, thing, others):
    assert read(prompt) == (thing, others)


@pytest.mark.parametrize(
    ("prompt", "thing", "others"),
    [
        ("a tractor driven by a pig", "pig", ["in tractor"]),
        ("a horse ridden by a skeleton", "skeleton", ["on horse"]),
        ("a red hat worn by a penguin", "penguin", ["wears red hat"]),
        ("a violin being played by a frog, cartoon", "frog", ["holds violin"]),
        ("a treasure chest guarded by a dragon", "chest", ["beside dragon"]),
        ("a chair made by hand", "chair", []),
        ("a wooden ship worn by the sea", "cargo ship", []),
        ("a castle with a dragon ridden by a knight", "castle", []),
        ("dinosaur drive a car", "dinosaur", ["on car"]),
        ("a lamp stands on a wooden table", "lamp", ["on wooden table"]),
        ("a sandwich sits next to a thermos", "sandwich", ["beside bottle"]),
        ("an axe rests quietly in a stump", "axe", ["in stump"]),
        ("two night stands on a rug", "nightstand", ["on rug"]),
        ("my dog is a brown poodle with a red sweater", "poodle", ["wears red shirt"]),
    ],
)
def test_what_is_done_by_somebody_is_what_he_does(prompt, thing, others):
    assert read(prompt) == (thing, others)


@pytest.mark.parametrize(
    ("prompt", "noun", "left_out"),
    [
        ("a T-rex doing yoga", "dinosaur", "yoga"),
        ("a crocodile podiatrist", "crocodile", "podiatrist"),
        ("a phone stand shaped like an octopus", "octopus", "stand"),
    ],
)
def test_what_is_strange_about_a_known_thing_is_left_out(prompt, noun, left_out):
    words = parse(prompt)
    assert words.noun == noun and left_out in words.left_out
    assert any(left_out in note for note in words.notes)


def test_two_without_an_article_are_made_side_by_side():
    assert read("a sword and shield") == ("sword", ["beside shield"])
    assert read("bacon and eggs") == ("bacon", ["beside egg"])
    assert read("a desk and chair from a school") == ("desk", ["beside chair"])
    with pytest.raises(UserError, match="one thing"):
        parse("a ham and cheese sandwich")


@pytest.mark.parametrize(
    ("prompt", "first", "other"),
    [
        ("a wooden desk and chair", "wooden desk", "wooden chair"),
        ("a white teapot and cup", "white teapot", "white mug"),
        ("a wooden desk and red chair", "wooden desk", "red chair"),
        ("a wooden desk and a chair", "wooden desk", "chair"),
        ("a red apple and banana", "red apple", "banana"),  # which has a colour of its own
        ("a crow and cat", "black bird", "cat"),  # nobody says black
    ],
)
def test_what_is_said_before_two_is_said_of_both(prompt, first, other):
    words = parse(prompt)
    assert (str(words), [str(one.words) for one in words.companions]) == (first, [other])


@pytest.mark.parametrize(
    ("prompt", "thing", "others"),
    [
        ("a plush toy of a corgi nurse", "plush corgi", ["wears white fabric jacket"]),
        ("a plushie of a panda doctor", "plush panda", ["wears white fabric jacket"]),
        ("a sculpture of a corgi pirate", "stone corgi", ["wears stone pirate hat"]),
        ("a golden statue of a pirate king", "golden king", ["wears golden pirate hat"]),
        (
            "a statue of a cat wizard",
            "stone cat",
            ["wears stone wizard hat", "wears stone cape"],
        ),
        ("a statue of a farmer", "stone person", ["wears stone cowboy hat", "holds stone rake"]),
        ("a statue of a king penguin", "stone penguin", []),
        ("a statue of a robot dog", "metal dog", []),
    ],
)
def test_whoever_is_depicted_has_a_role_too(prompt, thing, others):
    words = parse(prompt)
    # A soft toy is of fabric.
    assert str(words) == thing.replace("plush", "fabric")
    assert [f"{one.relation} {one.words}" for one in words.companions] == others
    assert any(note.endswith(f": made as a {words.noun}.") for note in words.notes)


def test_a_suit_is_no_robe_besides():
    assert read("a judge in a suit") == ("person", ["wears black fabric jacket"])


def test_what_is_written_is_no_costume():
    (text,) = parse('a robot with the text "dressed as a king"').emblems
    assert text.text == "dressed as a king"
    (text,) = parse('a mug that says "dressed as a king"').emblems
    assert text.text == "dressed as a king"


def test_what_a_costume_and_the_prompt_both_have_is_there_once():
    assert read("a fisherman in a red jacket") == (
        "person",
        ["wears red jacket", "holds fishing rod"],
    )
    assert read("a blacksmith with a hammer") == ("person", ["holds hammer"])


def test_things_that_are_together_are_taken():
    assert (parse("two swords crossed together").noun, parse("two boots together").count) == (
        "sword",
        2,
    )
