"""What a prompt says of parts alone, and what it says of no part of the thing."""

import pytest

from core.guidance.builtin.palette import Painted, painted
from core.guidance.builtin.patterns import MARGINS
from core.guidance.builtin.physical import usual_of
from core.guidance.builtin.words.phrases.slots import Words
from core.guidance.builtin.words.tables.colors import DARK, LIGHT, color_value
from core.guidance.builtin.words.vocabulary import parse


def test_a_colour_before_a_part_is_of_that_part_alone():
    assert parse("a chair with red legs") == Words("chair", second="red", target="legs")
    words = parse("a red chair with blue legs")
    assert (words.color, words.second, words.target) == ("red", "blue", "legs")
    words = parse("a red chair with blue legs and a green seat")
    assert words.of_parts("color") == {"legs": "blue", "seat": "green"}
    assert (words.color, words.target) == ("red", "legs")
    words = parse("a chair with blue legs, green legs")
    assert (words.of_parts("color"), words.left_out) == ({"legs": "blue"}, ("green legs",))
    words = parse("a cactus in a terracotta pot with a pink flower")
    assert (words.part_materials(), words.color) == ({"pot": "terracotta"}, "")


def test_what_is_of_the_bodys_colour_by_nature_has_its_new_one():
    of = parse("a teapot with a navy lid and cream body").part_shades()
    assert of == {"lid": "navy", "body": "cream", "spout": "cream", "handle": "cream"}
    assert parse("a mug with a white body and a blue handle").part_shades() == {
        "body": "white",
        "handle": "blue",
    }
    assert parse("a robot with a red body").part_shades() == {"body": "red"}
    # Its handle is black by nature.
    assert parse("a kettle with a white body").part_shades() == {"body": "white", "spout": "white"}


@pytest.mark.parametrize(
    ("prompt", "patterns", "colors"),
    [
        ("a lamp with a striped shade", {"shade": "striped"}, {}),
        (
            "a pirate ship with a red and white striped sail",
            {"sails": "striped with white"},
            {"sails": "red"},
        ),
        ("a mushroom with a spotted red cap", {"cap": "spotted"}, {"cap": "red"}),
        ("a chair, red legs, checkered seat", {"seat": "checkered"}, {"legs": "red"}),
        ("a mug without a striped handle", {}, {}),
    ],
)
def test_a_pattern_before_a_part_is_drawn_on_that_part_alone(prompt, patterns, colors):
    words = parse(prompt)
    assert (words.part_patterns(), words.part_shades(), words.pattern) == (patterns, colors, "")
    drawn = {part.name: part.pattern for part in painted(words.noun, words)}
    stated = {part: pattern.partition(" with ")[0] for part, pattern in patterns.items()}
    assert {part: drawn[part] for part in stated} == stated
    assert not set(stated.values()) & {drawn[part] for part in drawn.keys() - stated.keys()}


def test_the_second_colour_of_a_parts_pattern_is_as_stated_or_goes_with_the_first():

    def parts(prompt: str) -> dict[str, Painted]:
        words = parse(prompt)
        return {part.name: part for part in painted(words.noun, words)}

    sails = parts("a pirate ship with a navy and yellow striped sail")["sails"]
    assert (sails.color, sails.second) == (color_value("navy"), color_value("yellow"))
    assert parts("a pirate ship with a navy striped sail")["sails"].second == LIGHT
    assert parts("a pirate ship with a white striped sail")["sails"].second == DARK
    hull = parts("a red pirate ship with a striped sail")["hull"]
    assert (hull.color, hull.pattern in MARGINS) == (color_value("red"), False)


def test_a_pattern_has_the_second_colour_and_a_part_keeps_its_own():
    words = parse("a striped red mug with a blue handle")
    assert (words.pattern, words.second, words.target) == ("striped", "", "")
    assert words.of_parts("color") == {"handle": "blue"}
    words = parse("a red and white striped mug with a blue handle")
    assert (words.color, words.second) == ("red", "white")
    assert words.of_parts("color") == {"handle": "blue"}


@pytest.mark.parametrize(
    ("prompt", "material", "parts", "form"),
    [
        ("a steel sword with a leather grip", "metal", {"grip": "leather"}, "leather"),
        ("a wooden chair with a red leather seat", "wooden", {"seat": "leather"}, "leather"),
        ("a wooden chair with a leather red seat", "wooden", {"seat": "leather"}, "leather"),
        ("an armchair with blue velvet cushions", "", {"cushion": "fabric"}, "velvet"),
        ("a table with metal legs", "", {"legs": "metal"}, "metal"),
        ("a robot with steel arms", "", {"limbs": "metal"}, "steel"),
        ("a sword with a wooden handle", "", {"grip": "wooden"}, "wooden"),
        ("a bonsai tree in a ceramic pot", "", {"tray": "ceramic"}, "ceramic"),
        ("a leather chair", "leather", {}, ""),
        ("a chair of leather", "leather", {}, ""),
        ("a red car, chrome wheels", "", {"wheels": "metal"}, "chrome"),
        ("a sword with a stone pillow", "", {}, ""),
    ],
)
def test_a_material_before_a_part_is_of_that_part_alone(prompt, material, parts, form):
    words = parse(prompt)
    assert (words.material, words.of_parts("material")) == (material, parts)
    assert [accent.material_form for accent in words.accents if accent.material] == [form] * len(
        parts
    )
    if form == "steel" and not material:
        assert "steel: made as metal." in words.notes
    words = parse("a chair with leather legs, metal legs")
    assert words.part_materials() == {"legs": "leather"}
    assert words.left_out == ("metal legs",)
    assert words.notes[0].startswith("metal legs: left out, as a part has one colour, material")
    words = parse("a chair with glossy striped legs, matte spotted legs")
    assert (words.of_parts("sheen"), words.part_patterns()) == (
        {"legs": "glossy"},
        {"legs": "striped"},
    )
    assert words.left_out == ("matte legs", "spotted legs")
    assert (words.color, words.color_form) == ("", "")


def test_what_somebody_wears_is_a_thing_and_what_is_for_somebody_is_left_out():
    assert parse("pirate boots") == Words("boot", count=2, left_out=("pirate",))
    assert parse("a pirate with boots").noun == "pirate"
    assert parse("a bottle cap").noun == "bottle"
    words = parse("a red chair for children with blue eyes")
    assert (words.noun, words.color, words.second) == ("chair", "red", "")
    assert parse("a red telephone booth from london").noun == "phone booth"
    assert parse("a table from oak").material == "wooden"


@pytest.mark.parametrize("prompt", ["a toy train", "a train figurine"])
def test_a_toy_is_small(prompt):
    assert parse(prompt).noun == "train" and parse(prompt).is_toy
    assert usual_of(prompt)[0] == 0.25 < 5 < usual_of("a train")[0]
    assert usual_of("a toy coin") == usual_of("a coin")


@pytest.mark.parametrize(
    "prompt",
    [
        "a table with a toy on it",
        "a tree with an ornament",
        "a cat with a toy",
        "a plush sofa",
        "a train",
    ],
)
def test_what_is_with_a_toy_is_none(prompt):
    assert not parse(prompt).is_toy


@pytest.mark.parametrize(
    ("prompt", "part", "weather"),
    [
        ("a house without a red chimney", "no chimney", ()),
        ("a car without scratches", "", ()),
        ("a mug with no dirty handle", "no handle", ()),
        ("a snow covered dirty car", "", ("dirty", "snowy")),  # snow lies on the dirt
        ("a stained glass window", "", ()),
        ("a crown worn by a king", "", ()),
        ("a bowl used for soup", "", ()),
        ("an old fashioned car", "", ()),
    ],
)
def test_what_is_not_there_says_nothing_else(prompt, part, weather):
    words = parse(prompt)
    assert (words.part, words.weather, words.accents, words.second) == (part, weather, (), "")


def test_a_word_of_age_between_a_colour_and_its_part_takes_nothing_away():
    assert parse("a chair with red worn legs").of_parts("color") == {"legs": "red"}
    assert parse("a slate grey car") == Words("car", color="grey", color_form="slate grey")
    assert parse("a \ufb01sh").noun == "fish"  # a ligature
    assert parse("a hammer with a rubber grip").of_parts("material") == {"grip": "rubber"}


def test_a_negation_ends_with_its_phrase_and_a_robots_legs_are_its_limbs():
    assert parse("a mug without red with a handle").part == "handle"
    assert parse("a robot with blue legs").of_parts("color") == {"limbs": "blue"}


@pytest.mark.parametrize(
    ("prompt", "colors"),
    [
        ("a mailbox, blue body with a red flag", {"flag": "red", "box": "blue", "door": "blue"}),
        ("a skateboard with a purple deck", {"board": "purple"}),
        ("a broom with a red stick", {"handle": "red"}),
        ("a rifle with orange accents and a white body",
         {"body": "white", "barrel": "orange", "magazine": "orange", "scope": "orange"}),
        ("a wizard in a purple cloak", {"robe": "purple"}),
        ("a ball with a blue deck", {}),
    ],
)  # fmt: skip
def test_a_part_goes_by_what_people_call_it(prompt, colors):
    assert parse(prompt).of_parts("color") == colors


def test_the_size_of_a_part_is_not_the_things():
    assert parse("a rabbit with long legs").shape == ""
    words = parse("a bird with a long red beak")
    assert (words.shape, words.of_parts("color")) == ("", {"bill": "red"})
    assert words.part_sizes == (("bill", "long"),)
