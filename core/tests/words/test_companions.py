"""What a prompt wants together with the thing: on it, in it, worn, held, or borne by it."""

import pytest

from core.guidance.builtin.words.phrases.slots import Companion, Words
from core.guidance.builtin.words.vocabulary import parse, understood


def with_it(prompt: str) -> tuple[str, list[tuple[str, str]]]:
    """The thing, and what goes with it, as "red hat"."""
    words = parse(prompt)
    return str(words), [(one.relation, str(one.words)) for one in words.companions]


@pytest.mark.parametrize(
    ("prompt", "thing", "relation", "other"),
    [
        ("a rabbit sitting on top of a stack of pancakes", "rabbit", "on", "pancakes"),
        ("a cat sleeping on a red cushion", "cat", "on", "red pillow"),
        ("a cat curled up asleep on a rug", "cat", "on", "rug"),
        ("a peacock on a surfboard", "peacock", "on", "surfboard"),
        ("an anvil on a tree stump, stylized", "anvil", "on", "stump"),
        ("an astronaut riding a horse", "astronaut", "on", "horse"),
        ("a squirrel riding on a red motorcycle", "squirrel", "on", "red motorcycle"),
        ("A KNIGHT RIDING A HORSE", "knight", "on", "horse"),
        ("a dog driving a blue car", "dog", "on", "blue car"),
        ("a frog perched on a mushroom", "frog", "on", "mushroom"),
        ("a bird atop a wooden barrel", "bird", "on", "wooden barrel"),
        ("a crown resting upon a purple pillow", "crown", "on", "purple pillow"),
        ("a mermaid sitting on a rock", "mermaid", "on", "boulder"),
        ("cat on chair", "cat", "on", "chair"),
        ("a teddy bear in a wooden chair", "teddy bear", "on", "wooden chair"),
        ("a white rabbit on a wooden chair", "white rabbit", "on", "wooden chair"),
        ("a croissant on a plate", "croissant", "on", "plate"),
        ("a dragon on top of a castle", "dragon", "on", "castle"),
        ("a cat on a red and white chair", "cat", "on", "two-tone red chair"),
        ("tulips in a vase", "tulip", "in", "vase"),
        ("a cat in a box", "cat", "in", "cardboard box"),
        ("a sword stuck in a stone", "sword", "in", "boulder"),
        ("an axe in a tree stump", "axe", "in", "stump"),
        ("a dog in a red race car", "dog", "in", "red race car"),
        ("a cat hiding inside a cardboard box", "cat", "in", "cardboard box"),
        ("a teddy bear in a shopping cart", "teddy bear", "in", "shopping cart"),
        ("a bird in a nest", "bird", "in", "nest"),
        ("a rubber duck in a white bathtub", "rubber duck", "in", "white bathtub"),
        ("a penguin in a boat", "penguin", "in", "boat"),
        ("a monkey in a golf cart", "monkey", "in", "golf cart"),
        ("a red dog wearing a blue hat", "red dog", "wears", "blue hat"),
        ("a corgi in a cowboy hat", "corgi", "wears", "cowboy hat"),
        ("a cat in sunglasses", "cat", "wears", "sunglasses"),
        ("a cat with a top hat on its head", "cat", "wears", "hat"),
        ("a cat with a crown on its head", "cat", "wears", "crown"),
        ("a frog with a golden crown", "frog", "wears", "golden crown"),
        ("cactus wearing a sombrero", "cactus", "wears", "cowboy hat"),
        ("an owl wearing glasses", "owl", "wears", "sunglasses"),
        ("a snowman wearing a cowboy hat", "snowman", "wears", "cowboy hat"),
        ("a wizard wearing a golden crown", "wizard", "wears", "golden crown"),
        ("a man carrying a backpack", "person", "wears", "backpack"),
        ("a pig with a blue backpack", "pig", "wears", "blue backpack"),
        ("a cat wearing a santa hat", "cat", "wears", "santa hat"),
        ("a dog with a green bow tie around its neck", "dog", "wears", "green bow tie"),
        ("a bear with a red scarf in blue", "blue bear", "wears", "red scarf"),
        ("crab holding a sharp kitchen knife", "crab", "holds", "knife"),
        ("a fox with a lantern in its paw", "fox", "holds", "lantern"),
        ("a dog carrying a bone in its mouth", "dog", "holds", "bone"),
        ("a robot playing an electric guitar", "robot", "holds", "electric guitar"),
        ("a rabbit eating a carrot", "rabbit", "holds", "carrot"),
        ("a bear reading a book", "bear", "holds", "book"),
        ("a turtle with a house on its back", "turtle", "bears", "house"),
        ("a snail carrying a castle on its back", "snail", "bears", "castle"),
        ("a cake with a strawberry on top", "cake", "bears", "strawberry"),
        ("a table with a lamp on it", "table", "bears", "lamp"),
        ("a stump with an axe on it", "stump", "bears", "axe"),
        ("a car with a surfboard on the roof", "car", "bears", "surfboard"),
        ("a barrel with a cat inside", "barrel", "bears", "cat"),
        ("a bowl with a goldfish in it", "bowl", "bears", "orange fish"),  # one
        ("an anvil with a hammer", "anvil", "bears", "hammer"),
        ("a panda rowing a boat", "panda", "in", "boat"),
        ("a boy paddling a red canoe", "boy", "in", "red canoe"),
        ("a penguin piloting a plane", "penguin", "on", "airplane"),
        ("a pirate with a parrot on his shoulder", "pirate", "bears", "parrot"),
        ("a cat using a laptop", "cat", "beside", "laptop"),
        ("a man using a phone", "person", "holds", "phone"),
        ("a man playing the piano", "person", "beside", "piano"),
        ("a knight fighting a dragon", "knight", "beside", "dragon"),
        ("a cat chasing a white mouse", "cat", "beside", "white mouse"),
        ("a dog barking at a mailbox", "dog", "beside", "mailbox"),
        ("a boy kicking a soccer ball", "boy", "beside", "soccer ball"),
        ("a tiger jumping over a log", "tiger", "on", "log"),
        ("a horse jumping over a fence", "horse", "beside", "fence"),
    ],
)
def test_another_thing_is_made_with_the_first(prompt, thing, relation, other):
    assert with_it(prompt) == (thing, [(relation, other)])
    assert not any("one thing is made" in note for note in parse(prompt).notes)


@pytest.mark.parametrize(
    ("prompt", "others"),
    [
        (
            "a corgi wearing a beret and holding a baguette standing up on two hind legs",
            ["wears beanie", "holds bread"],
        ),
        ("a penguin wearing a scarf and a beanie", ["wears scarf", "wears beanie"]),
        (
            "a dog wearing a hat, sunglasses and a scarf",
            ["wears hat", "wears sunglasses", "wears scarf"],
        ),
        ("a knight riding a horse holding a spear", ["on horse", "holds spear"]),
        ("a bear on a bicycle while holding a balloon", ["on bicycle", "holds balloon"]),
        ("a cat in a box on a table", ["in cardboard box"]),
        ("a cat on a chair and a dog", ["on chair", "beside dog"]),
        ("a dog wearing red boots and a hat", ["wears red boot", "wears hat"]),
        ("a penguin in a tuxedo and a top hat", ["wears black fabric jacket", "wears hat"]),
        (
            "a bear wearing a hat, a scarf and boots",
            ["wears hat", "wears scarf", "wears boot"],
        ),
        (
            "a pig wearing a hat, sunglasses, a scarf, boots and a backpack",
            ["wears hat", "wears sunglasses", "wears scarf", "wears boot"],
        ),
    ],
)
def test_four_go_with_it_at_most_and_the_rest_is_left_out(prompt, others):
    words = parse(prompt)
    assert [f"{one.relation} {one.words}" for one in words.companions] == others
    assert not words.color


@pytest.mark.parametrize(
    "prompt",
    [
        "a snowman with a hat",
        "a knight holding a sword and a shield",
        "a knight wearing a helmet",
        "a wizard with a staff",
        "a teddy bear with a red bow tie",
        "a bed with a pillow",
        "a cake on a plate",
        "a cactus in a terracotta pot",
        "a chess king",
        "a chair on a white background",
        "a skeleton on a museum stand",
        "a vase on display",
        "a clock on the wall",
        "a watch on a chain",
        "a dog on wheels",
        "a mug with a heart on it",
        "a mug with a cat on it",
        "a shield with a lion on it",
        "a table with a flower on it",
        "a castle on a hill",
        "a fox in a forest",
        "an astronaut on the moon",
        "a rover on mars",
        "a cat in space",
        "a crab on the beach",
        "a gargoyle on a church",
        "a cup on its side",
        "a cat on a frobnicator",
        "salt and pepper",
        "a plate of pancakes",
        "a plate with a fried egg",
        "a candle in a lantern",
        "a robot resembling a dog",
        "a dog chasing its tail",
        "a man wearing red shoes",
        "a shirt with a white collar",
        "a statue holding a sword",
        "a robot with one big eye and a tiny antenna on its head",
        "a dog reading news on a cellphone",
        "a dress on a mannequin",
        "a necklace on a bust",
        'a sign that says "CAT ON A CHAIR"',
        "a horse wearing a saddle",
        "a chair in red",
        "a clown riding a zorb juggling balls",
    ],
)
def test_one_thing_is_made_as_ever(prompt):
    assert parse(prompt).companions == ()


def test_what_is_said_of_one_is_not_the_others():
    cat = parse("a cat on a rug with big ears")
    assert cat.companions == (Companion("on", Words("rug")),)
    chair = parse("a black cat on a blue velvet armchair with golden legs, glossy")
    assert (str(chair), chair.sheen) == ("black cat", ("glossy",))
    assert chair.companions[0].words.part_materials() == {"legs": "golden"}
    hat = parse("a cat wearing a hat with a red ribbon").companions[0].words
    assert hat.part_shades() == {"ribbon": "red"}


@pytest.mark.parametrize(
    ("prompt", "first", "others"),
    [
        ("a woman in a red dress", "person", ["red dress"]),
        ("a cat with a red collar", "cat", ["red dog collar"]),
        ("a robot with a red cape", "robot", ["red cape"]),
        ("a superhero with a red cape", "superhero", []),
        ("a pig in a pink tutu", "pig", ["pink dress"]),
        ("a raccoon wearing a hoodie and sunglasses", "raccoon", ["fabric jacket", "sunglasses"]),
        ("a fish wearing a watch", "fish", []),
    ],
)
def test_clothes_are_worn(prompt, first, others):
    words = parse(prompt)
    worn = [str(one.words).removeprefix("grey ") for one in words.companions]
    assert (words.noun, worn) == (first, others)
    assert {one.relation for one in words.companions} <= {"wears"}


@pytest.mark.parametrize(
    ("prompt", "first", "others"),
    [
        ("a cat dressed as a pirate", "cat", ["pirate hat"]),
        ("a dog in a superman costume", "dog", ["red cape"]),
        (
            "a frog dressed up as a king on a lily pad",
            "frog",
            ["lily pad", "golden crown", "red cape"],
        ),
        ("a mouse dressed like a wizard", "mouse", ["blue wizard hat", "blue cape"]),
        ("a penguin in a police uniform", "penguin", ["navy baseball cap", "navy shirt"]),
        ("a pirate", "pirate", []),
        ("a santa costume", "santa claus", []),
        ("a horse in armor", "horse", ["chestplate"]),
        ("a chair wearing a shirt", "chair", []),
    ],
)
def test_a_costume_is_what_is_worn(prompt, first, others):
    words = parse(prompt)
    assert (words.noun, [str(one.words) for one in words.companions]) == (first, others)


def test_a_statues_suit_is_of_its_material_and_a_stated_one_of_its_own():
    (jacket,) = parse("a bronze statue of a man in a suit").companions
    assert (jacket.words.color, jacket.words.material_form) == ("", "bronze")
    assert not jacket.words.accents
    (crown,) = parse("a marble statue of a cat wearing a golden crown").companions
    assert crown.words.material == "golden"


def test_what_is_cut_to_its_wearer_has_no_size_of_its_own():
    (raincoat,) = parse("a hamster in a tiny yellow raincoat").companions
    assert raincoat.words.scale == 1.0
    assert not any("usual size" in note for note in raincoat.words.notes)


def test_the_trousers_of_a_suit_are_of_its_colour_where_none_is_stated():
    assert parse("a man in a grey suit").of_parts("color") == {"trousers": "grey"}
    assert parse("a man in a grey suit with red trousers").of_parts("color") == {"trousers": "red"}
    assert parse("a bear in a grey suit").of_parts("color") == {}


def test_a_text_is_on_what_it_is_said_of():
    robot = parse("a robot holding a sign that says HELLO")
    assert not robot.emblems
    assert [str(one) for one in robot.companions[0].words.emblems] == ['"HELLO"']
    mug = parse("a red mug with a heart on it on a wooden table")
    assert [str(one) for one in mug.emblems] == ["heart"]
    assert mug.companions == (Companion("on", Words("table", material="wooden")),)


def test_what_a_statue_rides_is_of_its_material():
    knight = parse("a bronze statue of a knight riding a horse")
    assert knight.companions[0].words == Words("horse", material="copper", is_statue=True)


def test_the_notes_and_what_is_left_out_of_both_are_the_first_things():
    words = parse("a zoomed out photo of a spooky dog wearing a large sparkly beret")
    assert words.left_out == ("spooky", "sparkly")
    assert "beret: made as a beanie." in words.notes
    assert "large: the beanie is made 1.5 times its usual size." in words.notes
    assert words.usual() == parse("a dog").usual()


def test_a_negative_prompt_has_none():
    assert parse("a cat on a chair", noun_needed=False).companions == ()


def test_the_report_has_each_with_its_looks():
    found = understood("a white rabbit on a red wooden chair with long golden legs")
    assert (found["thing"], found["colours"], found["materials"]) == ("rabbit", ["white"], [])
    assert found["companions"] == [
        {
            "relation": "on",
            "thing": "chair",
            "pose": None,
            "mood": None,
            "cut": None,
            "count": 1,
            "order": "row",
            "colours": ["red"],
            "part_sizes": {"legs": "long"},
            "part_counts": {},
            "part_colours": {},
            "materials": ["wooden"],
            "part_materials": {"legs": "golden"},
            "pattern": None,
            "emblems": [],
        }
    ]


@pytest.mark.parametrize(
    ("prompt", "first", "other", "color"),
    [
        ("a chair and a table", "chair", "table", ""),
        ("a wooden table and a red chair", "table", "chair", "red"),
        ("a cat next to a blue dog", "cat", "dog", "blue"),
        ("penguins beside a block of ice", "penguin", "cube", ""),
        ("a bottle of wine and a wine glass", "bottle", "wine glass", ""),
    ],
)
def test_of_two_things_the_second_is_beside_the_first(prompt, first, other, color):
    words = parse(prompt)
    (companion,) = words.companions
    assert (words.noun, companion.relation, companion.words.noun) == (first, "beside", other)
    assert companion.words.color == color
