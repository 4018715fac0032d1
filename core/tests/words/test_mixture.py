"""Several materials of one thing, and a material next to a colour."""

import pytest

from core.errors import UserError
from core.guidance.builtin.nouns import NOUNS
from core.guidance.builtin.substances import natural_kind
from core.guidance.builtin.words.grammar.lexicon import Entry
from core.guidance.builtin.words.grammar.mixture import (
    SUITED,
    lesser_parts,
    parts_next_to_color,
    parts_of_color,
    parts_of_each,
)
from core.tests.words.test_word_order import read


def material(form: str, word: str = "") -> Entry:
    return Entry("material", word or form, form)


KETTLE = ("handle", "lid", "lines")
WOOD, METAL, GLASS = material("wooden"), material("metal"), material("glass")


@pytest.mark.parametrize(
    ("prompt", "main", "of_parts"),
    [
        ("a wood and metal stool", "wooden", {"legs": "metal", "band": "metal"}),
        ("a metal and wood stool", "metal", {"seat": "wooden"}),
        ("a stool of steel and oak", "metal", {"seat": "oak"}),
        ("chair in wood & leather", "wooden", {"seat": "leather", "back": "leather"}),
        ("a leather and chrome chair", "leather", {"legs": "chrome"}),
        ("a gold and velvet throne", "golden", {"cushion": "velvet"}),
        ("steel and glass coffee table", "metal", {"top": "glass", "shelf": "glass"}),
        ("coffee table made of glass and wood", "glass", {"legs": "wooden"}),
        ("white marble and gold side table", "white marble", {"legs": "golden"}),
        ("a hammer of wood and iron", "wooden", {"head": "iron", "claw": "iron"}),
        ("iron and wood chest", "iron", dict.fromkeys(("body", "lid"), "wooden")),
        ("a wooden chest with iron", "wooden", dict.fromkeys(("bands", "lock", "rivets"), "iron")),
        ("a wooden stone well", "wooden", {"wall": "stone"}),
        ("a brass and glass lantern", "brass", {"glass": "glass"}),
        ("a rattan and metal chair", "rattan", {"legs": "metal"}),
        ("wood/metal bar stool", "wooden", {"legs": "metal", "band": "metal"}),  # and no metal bar
        ("broom wood and straw", "wooden", {"bristles": "straw"}),
        (
            "teapot of glass and steel",
            "glass",
            {"handle": "metal", "lid": "metal", "bands": "metal"},
        ),  # and not the body
        ("a radio of wood and plastic", "wooden", {"knobs": "plastic"}),
        # of one class
        ("oak and walnut table", "oak", {"legs": "walnut"}),
        ("sword, silver and gold", "silver", {"guard": "golden", "pommel": "golden"}),
        ("a brick and stone house", "brick", {"chimney": "stone"}),
        ("porcelain teapot with gold", "ceramic", {"bands": "golden"}),
        ("a bronze shield and metal gold", "bronze", {"rim": "golden", "emblem": "golden"}),
        # three
        (
            "a steel sword with leather and gold",
            "metal",
            {"grip": "leather", "guard": "golden", "pommel": "golden"},
        ),
    ],
)
def test_each_material_goes_to_the_parts_that_it_suits(prompt, main, of_parts):
    told = read(prompt)
    assert told["materials"] == [main]
    assert told["part_materials"] == of_parts
    assert not [note for note in told["notes"] if "left out" in note]


@pytest.mark.parametrize(
    ("prompt", "main"),
    [
        ("a brass metal lamp", "brass"),
        ("a metal brass lamp", "brass"),
        ("a lamp, brass metal", "brass"),
        ("a see-through plastic bottle", "see through"),
        ("an armchair upholstered in green velvet", "velvet"),
        ("a handbag in quilted burgundy leather", "leather"),
        ("a cart of old metal and rusty", "rusty"),
        ("a rusty iron bucket", "rusty"),
        ("a wooden cart, the wood is grey", "wooden"),
    ],
)
def test_what_says_no_more_of_the_same_is_no_second(prompt, main):
    told = read(prompt)
    assert (told["materials"], told["part_materials"]) == ([main], {})
    assert not [note for note in told["notes"] if "left out" in note]


def test_a_colour_right_before_a_second_material_goes_with_it():
    told = read("park bench, weathered wood and black iron")
    assert (told["colours"], told["materials"]) == ([], ["wooden"])
    assert (told["part_colours"], told["part_materials"]) == (
        {"legs": "black", "bolts": "black"},
        {"legs": "iron", "bolts": "iron"},
    )
    told = read("a black leather and oak chair")
    assert (told["colours"], told["materials"]) == (["black"], ["leather"])
    assert (told["part_colours"], told["part_materials"]) == ({}, {"legs": "oak", "arms": "oak"})


def test_a_part_that_has_a_material_of_its_own_keeps_it():
    told = read("a wood and metal stool with ceramic legs")
    assert told["part_materials"] == {"legs": "ceramic", "band": "metal"}
    told = read("a wood and metal table with ceramic legs")
    assert told["part_materials"] == {"legs": "ceramic"}
    assert "metal: left out, as one material is taken." in told["notes"]


def test_a_second_material_without_a_part_is_left_out_with_its_colour():
    told = read("ceramic vase with white gold and black wood")
    assert (told["materials"], told["colours"], told["part_materials"]) == (["ceramic"], [], {})
    assert "black wood: left out, as one material is taken." in told["notes"]
    for prompt in (
        "a statue of a lion in bronze and marble",
        "statue of a chair, bronze and marble",
    ):
        told = read(prompt)
        assert (told["materials"], told["part_materials"]) == (["bronze"], {})
        assert "marble: left out, as one material is taken." in told["notes"]


@pytest.mark.parametrize(
    ("prompt", "colors", "of_parts"),
    [
        ("a black and gold chair", ["black"], {"legs": "golden"}),
        ("gold and black chair", ["black"], {"legs": "golden"}),
        ("sofa in white and gold", ["white"], {"feet": "golden"}),
        ("a red and gold sword", ["red"], dict.fromkeys(("guard", "pommel", "wraps"), "golden")),
        ("red and iron chest", ["red"], dict.fromkeys(("bands", "lock", "rivets"), "iron")),
        ("white and oak table", ["white"], {"top": "oak"}),
        ("white and marble table", ["white"], {"top": "marble"}),
        ("a guitar, black and gold", ["black"], {"pegs": "golden", "frets": "golden"}),
        (
            "a gold colored and red chest",
            ["red"],
            dict.fromkeys(("bands", "lock", "rivets"), "golden"),
        ),
        ("blue and silver fish", ["blue"], {"fins": "silver"}),
        (
            "white and gold dragon",
            ["white"],
            {"belly": "golden", "wings": "golden", "ribs": "golden"},
        ),
        ("black leather and gold sofa", ["black"], {"feet": "golden"}),
        (
            "black dragon with gold",
            ["black"],
            {"belly": "golden", "wings": "golden", "ribs": "golden"},
        ),
        ("a kettle, red, chrome", ["red"], dict.fromkeys(KETTLE, "chrome")),
        ("silver-blue car", ["silver blue"], {}),
        # What has no part for it is of two colours.
        ("black and gold vase", ["black", "golden yellow"], {}),
        ("black and gold striped vase", ["black", "golden yellow"], {}),
        ("a grey and fluffy pillow", ["grey"], {}),
    ],
)
def test_a_material_next_to_a_colour_is_that_of_other_parts(prompt, colors, of_parts):
    told = read(prompt)
    assert (told["colours"], told["part_materials"]) == (colors, of_parts)


def test_what_is_of_metal_by_nature_leaves_the_colour_to_the_rest():
    told = read("a silver and black sword")
    assert (told["materials"], told["colours"]) == (["silver"], [])
    assert told["part_colours"] == {"grip": "black"}
    told = read("chrome and red toaster")
    assert (told["materials"], told["part_colours"]) == (
        ["chrome"],
        {"lever": "red", "knob": "red"},
    )
    # What it is not of by nature is painted, but for some parts.
    metal = dict.fromkeys(("bands", "lock", "rivets"), "golden")
    assert read("gold and red chest")["part_materials"] == metal


@pytest.mark.parametrize(
    ("prompt", "parts"),
    [
        ("a gold and red crown", {"gems": "red"}),
        ("silver and turquoise necklace", {"stone": "turquoise"}),
        ("picture frame silver and black", {}),  # not its picture
    ],
)
def test_gems_take_the_colour_and_what_has_no_part_for_it_loses_it(prompt, parts):
    told = read(prompt)
    assert (told["part_colours"], told["colours"]) == (parts, [])
    lost = "black: left out, as nothing else in it has a colour."
    assert (lost in told["notes"]) == (not parts)


@pytest.mark.parametrize(
    "prompt", ["a car, red, wooden", "a car, red, metal", "a car, red, velvet"]
)
def test_behind_a_comma_what_is_no_other_metal_is_of_the_whole(prompt):
    told = read(prompt)
    assert len(told["materials"]) == len(told["colours"]) == 1


def test_behind_a_colour_materials_with_their_own_are_all_of_parts():
    told = read("vintage motorcycle, cream, brown leather, chrome")
    assert (told["colours"], told["materials"]) == (["cream"], [])
    assert told["part_colours"] == {"seat": "brown"}
    metal = {"engine": "chrome", "handlebar": "chrome", "fins": "chrome"}
    assert told["part_materials"] == {"seat": "leather"} | metal


@pytest.mark.parametrize("prompt", ["a red and rusty car", "a grey and metallic robot"])
def test_a_quality_next_to_a_colour_is_of_the_whole(prompt):
    told = read(prompt)
    assert len(told["materials"]) == len(told["colours"]) == 1
    assert told["part_materials"] == {}


@pytest.mark.parametrize(
    "prompt",
    ["crystal and gold chandelier", "a bone and gold crown", "chandelier in gold and crystal"],
)
def test_a_thing_that_says_what_another_is_of_is_left_out(prompt):
    told = read(prompt)
    assert told["materials"] == ["golden"]
    left = next(word for word in ("crystal", "bone") if word in prompt)
    assert f"{left}: left out, as one material is taken." in told["notes"]


def test_what_an_and_joins_without_an_article_is_no_other_thing():
    told = read("vase blue porcelain and gold cracks")
    assert (told["colours"], told["materials"]) == (["blue"], ["ceramic"])
    assert read("golem with moss and a crystal")["weather"] == ["mossy"]
    for prompt in ("a vase and a gold okapi", "a vase and okapi"):
        with pytest.raises(UserError, match="okapi"):
            read(prompt)


@pytest.mark.parametrize(
    ("prompt", "of_parts"),
    [
        ("wooden barrel with iron bands", {"hoops": "iron"}),
        ("a book with brass corners", dict.fromkeys(("bands", "badge", "border"), "brass")),
        ("a spoon with a blue silicone head", {"bowl": "silicone"}),
        ("a fork with gold tines", {"head": "golden"}),
        ("a shield with an iron boss", {"emblem": "iron"}),
        (
            "an electric guitar with chrome hardware",
            {"bridge": "chrome", "knobs": "chrome", "frets": "chrome"},
        ),
        ("copper pot with brass handles", {"handles": "brass"}),
        ("a wooden chair with metal accents", {"legs": "metal"}),
        ("leather sofa with chrome accents", {"feet": "chrome"}),
        ("a wooden shield with iron reinforcement", {"rim": "iron", "emblem": "iron"}),
    ],
)
def test_trim_is_no_seat_and_parts_go_by_other_names(prompt, of_parts):
    assert read(prompt)["part_materials"] == of_parts


def test_a_long_list_of_materials_is_read():
    assert read("a chair " + "wood and metal " * 60)["part_materials"] == {"legs": "metal"}


@pytest.mark.parametrize("noun", NOUNS)
def test_something_of_any_thing_is_left_to_the_first_and_the_colour(noun):
    looks = NOUNS[noun].looks
    pairs = [(WOOD, METAL), (METAL, WOOD), (GLASS, METAL), (METAL, GLASS)]
    for first, second in pairs:
        found = parts_of_each(noun, [first, second])
        assert set(found.values()) <= {second}
        assert set(found) <= set(looks)
    mains = {part for part, look in looks.items() if look[0] in "*&"}
    for one in (WOOD, METAL):
        assert mains - set(parts_next_to_color(noun, one))
        assert not set(lesser_parts(noun, one)) & {p for p in looks if looks[p][0] == "*"}
        assert not set(parts_of_color(noun, one)) & {p for p in looks if looks[p][0] == "*"}


def test_the_table_names_parts_that_things_have():
    names = {part for noun in NOUNS.values() for part in noun.looks}
    assert {part for _, part in SUITED} <= names


def test_a_natural_kind_is_stated_or_known_by_its_name():
    assert natural_kind("desk", "handles") == "golden"
    assert natural_kind("chair", "seat") == "wooden"  # by its pattern
    assert natural_kind("bench", "legs") == "cast iron"
    assert natural_kind("potion", "cork") == "wooden"


@pytest.mark.parametrize(
    ("prompt", "main", "of_parts"),
    [
        ("a steampunk helicopter", ["brass"], {"rotor": "copper", "bands": "copper"}),
        ("a steampunk robot", ["brass"], {"limbs": "copper"}),
        ("a robot in steampunk style", ["brass"], {"limbs": "copper"}),
        ("a robot, steampunk, highly detailed", ["brass"], {"limbs": "copper"}),
        ("a steampunk house", ["brass"], {"roof": "copper"}),
        ("a steampunk submarine", ["brass"], {"fins": "copper", "keel": "copper"}),
        ("a steampunk clock", ["brass"], {"feet": "copper"}),  # and not the face
        (
            "a steampunk top hat",
            ["leather"],
            {"buckle": "brass", "ribbon": "brass", "piping": "brass"},
        ),
    ],
)
def test_what_steam_drives_is_of_brass_and_copper(prompt, main, of_parts):
    found = read(prompt)
    assert (found["materials"], found["part_materials"]) == (main, of_parts)
    assert found["left_out"] == []


@pytest.mark.parametrize(
    ("prompt", "materials"),
    [
        ("a steampunk cat", []),
        ("a helicopter with a steampunk propeller", []),
        ("a steampunk man", []),
        ("a steampunk banana", []),
        ("a steampunk red car", []),
        ("a steampunk car with red wheels", []),
        ("a steampunk wooden ship", ["wooden"]),
    ],
)
def test_no_brass_is_for_what_lives_or_has_words_of_its_own(prompt, materials):
    found = read(prompt)
    assert found["materials"] == materials and found["left_out"] == ["steampunk"]
    assert "brass" not in found["part_materials"].values()
