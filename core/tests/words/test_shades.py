"""Shades of colours, how a surface shines, and materials that get their own detail."""

import pytest

from core.guidance.builtin.palette import painted
from core.guidance.builtin.surfaces import ALL_GLOWS, PART_GLOWS, SHINES, surface_of
from core.guidance.builtin.variants import VARIANTS
from core.guidance.builtin.words.grammar.lexicon import LEXICON
from core.guidance.builtin.words.phrases.slots import Words
from core.guidance.builtin.words.tables.colors import (
    COLOR_VALUES,
    SHADES,
    TOWARDS,
    color_value,
    shade,
)
from core.guidance.builtin.words.vocabulary import parse, understood
from core.texture.detail.kinds import KINDS


def parts_of(prompt):
    words = parse(prompt)
    return {part.name: part for part in painted(words.noun, words)}


def test_a_shade_is_painted_in_its_own_colour():
    assert parts_of("a teal ball")["body"].color == color_value("cyan", "teal")
    assert color_value("cyan", "teal") != COLOR_VALUES["cyan"]
    body = parts_of("a charcoal armchair with mustard cushions")
    assert body["back"].color == color_value("grey", "charcoal")
    assert body["cushion"].color == color_value("yellow", "mustard")


def test_shades_of_one_word_are_two_colours():
    parts = parts_of("a dark brown chair with light brown legs")
    assert sum(parts["back"].color) < sum(COLOR_VALUES["brown"]) < sum(parts["legs"].color)
    words = parse("a striped light green and dark green ball")
    assert (words.color_form, words.second, words.second_form) == ("light green", "dark green", "")


def test_a_tone_moves_any_colour_towards_black_or_white():
    for form in ("dark purple", "pale purple", "dark lavender"):
        end = sum(TOWARDS[form.split()[0]][0])
        plain = sum(color_value("purple", form.split()[1]))
        assert abs(sum(color_value("purple", form)) - end) < abs(plain - end)
    lavender = color_value("purple", "lavender")
    assert color_value("purple", "dark lavender") == pytest.approx([0.5 * c for c in lavender])
    pale = [0.45 * c + 0.55 for c in lavender]
    assert color_value("purple", "pale lavender") == pytest.approx(pale)
    assert color_value("navy", "dark blue") == COLOR_VALUES["navy"]  # a word of its own
    assert color_value("dark green", "dark green") == COLOR_VALUES["dark green"]
    assert parse("a dark wooden chair").color == ""
    assert parse("a sofa, light grey fabric").color_form == "light grey"


def test_every_shade_has_a_value_and_is_reported_as_it_was_written():
    for word, shades in SHADES.items():
        for form in shades:
            assert LEXICON[form] == ("color", word)
            assert all(0 <= c <= 1 for c in color_value(word, form))
            assert shade(word, form) == form
    found = understood("a teal mug with a dark teal handle")
    assert (found["colours"], found["part_colours"]) == (["teal"], {"handle": "dark teal"})
    assert understood("a gray mug")["colours"] == ["grey"]


@pytest.mark.parametrize(
    ("prompt", "part", "rough"),
    [
        ("a matte black kettle", "body", SHINES["matte"]),
        ("a polished wooden table", "top", SHINES["glossy"]),
        ("a fan with a glossy base", "stand", SHINES["glossy"]),
        ("a satin red car", "body", SHINES["satin"]),
    ],
)
def test_a_word_of_sheen_sets_how_rough_a_part_is(prompt, part, rough):
    painted_part = parts_of(prompt)[part]
    surface = surface_of(parse(prompt), painted_part)
    assert painted_part.finish.roughness + surface.roughness == pytest.approx(rough)


def test_sheen_is_not_of_what_has_its_own_or_lives():
    words = parse("a glossy red car")
    parts = parts_of("a glossy red car")
    assert surface_of(words, parts["wheels"]).roughness == 0
    parts = parts_of("a glossy cat")
    assert surface_of(parse("a glossy cat"), parts["body"]).roughness == 0
    words = parse("a matte car with a glossy body")
    parts = {part.name: part for part in painted(words.noun, words)}
    assert parts["body"].sheen == ("glossy",)


def test_a_glossy_metal_is_no_mirror():
    words = parse("a glossy golden ball")
    part = next(painted("ball", words))
    assert part.finish.roughness + surface_of(words, part).roughness == pytest.approx(0.12)


def test_every_narrower_material_has_a_kind_of_detail_and_no_note():
    for form, variant in VARIANTS.items():
        assert variant.kind in KINDS, form
        assert LEXICON[form][0] == "material", form
    words = parse("a jade dragon")
    assert (words.material, words.material_form, words.notes) == ("stone", "jade", ())
    assert understood("a jade dragon")["materials"] == ["jade"]


@pytest.mark.parametrize(
    ("prompt", "words"),
    [
        ("a pine", Words("tree")),
        ("a pine table", Words("table", material="wooden")),
        ("a printer with white paper", Words("printer", second="white", target="paper")),
        ("a swan made of paper", Words("swan", material="fabric")),
        ("a chocolate rabbit", Words("rabbit", material="plastic", is_statue=True)),
    ],
)
def test_what_is_a_thing_alone_or_a_part_may_be_a_material(prompt, words):
    assert parse(prompt) == words


def test_a_metal_is_a_colour_of_what_is_soft():
    hair = parts_of("a king with a silver beard")["beard"]
    assert (hair.material, hair.finish.metallic) == ("", 0)
    assert min(hair.color) > 0.6
    assert parts_of("a king with a steel beard")["beard"].finish.metallic == 1
    assert parts_of("a robot with golden eyes")["eyes"].finish.metallic == 1


def test_a_stone_is_the_gem_of_what_has_one():
    words = parse("a golden ring with an oval emerald")
    assert (words.color, words.material, words.of_parts("color")) == (
        "", "golden", {"gem": "green"},
    )  # fmt: skip
    assert parse("a crown with rubies").of_parts("color") == {"gems": "red"}
    assert parse("an emerald vase").color_form == "emerald"
    assert parse("an emerald ring").of_parts("color") == {"gem": "green"}


def test_what_is_said_to_glow_does_and_a_part_more_than_a_whole():
    def glow(prompt, part):
        return surface_of(parse(prompt), parts_of(prompt)[part]).glow

    assert glow("a skull with glowing green eyes", "eyes") == PART_GLOWS
    assert glow("a skull with glowing green eyes", "bone") == 0
    assert glow("a glowing mushroom", "cap") == ALL_GLOWS
    assert glow("a candle with a glowing flame", "flame") == 1  # as it does by nature


@pytest.mark.parametrize("form", ["frosted glass", "tinted glass", "clear glass", "icy"])
def test_light_goes_through_every_glass(form):
    prompt = f"a {form} vase"
    surface = surface_of(parse(prompt), parts_of(prompt)["body"])
    assert surface.kind == "glass"
    assert surface.clear >= 0.6
