"""What is said of a part in front of the thing, and of materials with a tone."""

import pytest

from core.errors import UserError
from core.guidance.builtin.palette import FINISHES, painted
from core.guidance.builtin.surfaces import surfaces_of
from core.guidance.builtin.variants import VARIANTS, has_own_look, split_tone
from core.guidance.builtin.words.tables.colors import COLOR_VALUES
from core.guidance.builtin.words.vocabulary import parse, understood


@pytest.mark.parametrize(
    ("prompt", "thing", "materials", "colors"),
    [
        ("a marble topped table", "table", {"top": "marble"}, {}),
        ("a marble-topped table", "table", {"top": "marble"}, {}),
        ("a glass top coffee table", "coffee table", {"top": "glass"}, {}),
        ("a wooden handled knife", "knife", {"handle": "wooden"}, {}),
        ("a wood handle knife", "knife", {"handle": "wooden"}, {}),
        ("a gold rimmed plate", "plate", {"rim": "golden"}, {}),
        ("a wooden framed mirror in a room", "mirror", {"frame": "wooden"}, {}),
        ("a red roofed house", "house", {}, {"roof": "red"}),
        ("a dark teal-roofed cottage", "cottage", {}, {"roof": "dark teal"}),
        ("a figure of a blue eyed cat", "cat", {}, {"eyes": "blue"}),
        ("a cat, blue eyed", "cat", {}, {"eyes": "blue"}),
        ("a red cap mushroom", "mushroom", {}, {"cap": "red"}),
        ("a sword with a leather wrapped handle", "sword", {"grip": "leather"}, {}),
        ("a stainless steel topped brass legged table", "table",
         {"top": "stainless steel", "legs": "brass"}, {}),
    ],
)  # fmt: skip
def test_what_is_said_of_a_part_in_front_of_the_thing_is_the_parts(
    prompt, thing, materials, colors
):
    found = understood(prompt)
    assert (found["thing"], found["materials"], found["colours"]) == (thing, [], [])
    assert (found["part_materials"], found["part_colours"]) == (materials, colors)


@pytest.mark.parametrize(
    ("prompt", "thing", "material", "color"),
    [
        ("a gold key", "key", "golden", ""),
        ("a black top hat", "hat", "", "black"),  # no part of a hat
        ("a red flower pot", "flower pot", "", "red"),  # a thing by itself
        ("a leather bound book", "book", "leather", ""),  # no part
        ("a gold plated ring", "ring", "golden", ""),
        ("a leather wrapped chair", "chair", "leather", ""),
        ("a white painted bunk bed", "bunk bed", "", "white"),
        ("a red, topped table", "table", "", "red"),  # of another clause
        ("a red knight's helmet", "helmet", "", "red"),
        ("a green plastic potted plant", "potted plant", "plastic", "green"),
        ("a pink fried egg", "fried egg", "", "pink"),
        ("an orange stone crown", "crown", "stone", "orange"),  # which has stones
    ],
)
def test_what_is_said_of_the_thing_stays_the_things(prompt, thing, material, color):
    words = parse(prompt)
    assert (words.noun, words.material, words.color, words.accents) == (thing, material, color, ())


def test_a_part_in_front_that_the_thing_has_not_is_said():
    found = understood("a copper bottomed pan")
    assert (found["materials"], found["left_out"]) == ([], ["copper bottom"])
    assert found["notes"] == ["copper bottom: left out, as a pan has none here."]


def test_the_shape_of_a_part_is_not_the_things():
    found = understood("a long-legged bird")
    assert found["part_sizes"] == {"legs": "long"}
    assert found["shape"] is None
    assert found["left_out"] == found["notes"] == []


@pytest.mark.parametrize(
    ("prompt", "material"),
    [
        ("a dark oak desk", "dark oak"),
        ("a table in light oak", "light oak"),
        ("a dark leather sofa", "dark leather"),
        ("a dark wood table", "dark wood"),  # a word by itself
        ("a soft leather sofa", "leather"),  # no tone of a material
        ("a dark red leather sofa", "leather"),  # the colour's
    ],
)
def test_a_tone_before_a_material_is_the_materials(prompt, material):
    found = understood(prompt)
    assert found["materials"] == [material]
    assert not any("dark" in word or "light" in word for word in found["left_out"])


def test_a_material_with_a_tone_is_of_that_kind_and_lighter_or_darker():
    def factor(prompt):
        words = parse(prompt)
        part = next(one for one in painted(words.noun, words) if one.material)
        found = next(one for one in surfaces_of(words) if one.kind == "wooden")
        return part, found.factor

    _, plain = factor("an oak desk")
    _, dark = factor("a dark oak desk")
    _, light = factor("a light oak desk")
    assert all(a < b < c for a, b, c in zip(dark, plain, light, strict=True))
    part, dark = factor("a dark oak red desk")
    assert part.colored and dark == (1.0, 1.0, 1.0), "a stated colour is painted as it is"
    leather = surfaces_of(parse("a dark leather sofa"))
    assert any(one.kind == "leather" and max(one.factor) < 0.5 for one in leather)
    assert FINISHES["leather"].color, "which the tone goes from"


def test_the_tone_of_a_variant_that_has_one_in_its_name_is_not_taken_off():
    assert split_tone("dark wood") == ("", "dark wood")
    assert split_tone("dark oak") == ("dark", "oak")
    assert has_own_look("dark steel") and has_own_look("oak") and not has_own_look("wooden")
    assert "dark wood" in VARIANTS


def test_of_two_materials_of_a_part_the_one_that_says_more_counts():
    assert understood("a sofa with gold metal legs")["part_materials"] == {"feet": "golden"}
    assert understood("a sofa with metal gold legs")["part_materials"] == {"feet": "golden"}


def test_what_it_stands_on_with_its_looks_is_left_aside():
    found = understood("a deer near a mossy rock")
    assert (found["thing"], found["materials"], found["weather"]) == ("deer", [], [])
    assert "mossy rock: left out, as one thing is made at a time." in found["notes"]


def test_a_slip_in_a_name_of_several_words_is_read():
    found = understood("a double deker bus")
    assert found["thing"] == "double decker bus"
    assert found["notes"] == ["'double deker bus' is read as 'double decker bus'."]
    assert understood("a coffe machine")["thing"] == "coffee machine"
    with pytest.raises(UserError):
        parse("a double xyz")


def test_a_finish_is_of_the_whole_and_an_outside_too():
    assert understood("a bottle with a teal finish")["part_colours"] == {"body": "teal"}
    assert understood("a bathtub, black outside")["part_colours"]["body"] == "black"


@pytest.mark.parametrize(
    ("prompt", "color", "second", "pattern"),
    [
        ("a crate with orange stripes", "", "orange", "striped"),
        ("a mug with blue polka dots and a red lid", "", "blue", "spotted"),
        ("a crate with orange stripes and glowing panels", "", "orange", "striped"),
        ("a white car with red stripes", "white", "red", "striped"),
        ("a blue mug with dots", "blue", "", "spotted"),
        ("a mug with dots, blue", "blue", "", "spotted"),
        ("a sofa with red and white stripes", "red", "white", "striped"),
        ("an orange striped crate", "orange", "", "striped"),
        ("a crate, orange stripes", "", "orange", "striped"),
        ("a dress with white polka dots in blue", "blue", "white", "spotted"),
    ],
)
def test_one_color_of_stripes_or_dots_lies_on_the_thing_s_own(prompt, color, second, pattern):
    words = parse(prompt)
    assert (words.color, words.second, words.pattern) == (color, second, pattern)
    assert not words.target
    first = next(painted(words.noun, words))
    if not color:
        assert first.color == first.look.color
        assert first.second == COLOR_VALUES[second]
