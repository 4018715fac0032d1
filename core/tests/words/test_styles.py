"""A style in a prompt."""

import pytest

from core.errors import UserError
from core.guidance.builtin.words.phrases.styles import style_of
from core.guidance.builtin.words.vocabulary import parse, understood


@pytest.mark.parametrize(
    ("prompt", "noun", "style"),
    [
        ("a low poly fox", "fox", "low_poly"),
        ("a low-poly 3d model of a red car", "car", "low_poly"),
        ("lowpoly style tree", "tree", "low_poly"),
        ("a fox, low poly", "fox", "low_poly"),
        ("a corgi in the style of low poly art", "corgi", "low_poly"),
        ("a polygonal deer", "deer", "low_poly"),
        ("a voxel castle", "castle", "voxels"),
        ("voxel art of a castle", "castle", "voxels"),
        ("a castle in voxel style", "castle", "voxels"),
        ("a house made of voxels", "house", "voxels"),
        ("a voxelized dragon", "dragon", "voxels"),
        ("a Minecraft style sword", "sword", "voxels"),
        ("a pixel art mushroom", "mushroom", "voxels"),
        ("an 8-bit cat", "cat", "voxels"),
        ("an origami fox", "fox", "low_poly"),
        ("a papercraft owl", "owl", "low_poly"),
        ("a lego castle", "castle", "voxels"),
        ("a red car made of lego bricks", "car", "voxels"),
        ("a castle built from legos", "castle", "voxels"),
        ("a lego brick", "lego brick", ""),
        ("a lego man", "person", ""),
        ("lego", "lego brick", ""),
        ("a fox", "fox", ""),
        ("a high poly fox", "fox", ""),
    ],
)
def test_a_style_is_read_and_nothing_of_it_is_left_out(prompt, noun, style):
    words = parse(prompt)
    assert (words.noun, words.style) == (noun, style)
    assert not words.left_out or not style


def test_the_rest_of_the_prompt_stays():
    words = parse("a low poly red wooden chair")
    assert (words.color, words.material, words.style) == ("red", "wooden", "low_poly")
    words = parse("a knight in low poly style riding a horse")
    assert [one.words.noun for one in words.companions] == ["horse"]
    assert parse("an origami crane").material == parse("a paper crane").material
    words = parse("a red car made of lego bricks")
    assert (words.color, words.material, words.is_toy) == ("red", "plastic", True)


def test_of_two_styles_the_first():
    words = parse("a low poly fox, voxel art")
    assert (words.noun, words.style, words.left_out) == ("fox", "low_poly", ())


def test_what_is_quoted_is_written():
    words = parse('a mug that says "low poly"')
    assert words.style == "" and [one.text for one in words.emblems] == ["low poly"]
    words = parse('a mug that says "made of lego"')
    assert (words.noun, words.style, words.material) == ("mug", "", "")
    assert [one.text for one in words.emblems] == ["made of lego"]
    assert parse('a mug that says "origami"').style == ""
    words = parse('a castle made of lego with a sign that says "lego"')
    assert (words.noun, words.style) == ("castle", "voxels")


def test_a_style_alone_is_no_thing():
    assert style_of("low poly style") == ("low poly style", "")
    with pytest.raises(UserError, match="low poly"):
        parse("low poly")


def test_a_negative_prompt_has_no_style():
    assert parse("low poly", noun_needed=False).style == ""


def test_the_report_has_the_style():
    assert understood("a low poly fox")["style"] == "low_poly"
    assert understood("a fox")["style"] is None
