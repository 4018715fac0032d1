"""Words for toppings and for what is in a cup."""

import pytest

from core.guidance.builtin.words.vocabulary import parse


@pytest.mark.parametrize(
    ("prompt", "thing", "top"),
    [
        ("a steaming mug of hot chocolate topped with whipped cream", "mug", "cloud"),
        ("a pie topped with whipped cream", "pie", "cloud"),
        ("a slice of apple pie with a dollop of whipped cream on top", "pie", "cloud"),
        ("a waffle with whipped cream", "waffle", "cloud"),
        ("hot chocolate with marshmallows", "teacup", "cylinder"),
        ("a mug of cocoa with mini marshmallows", "mug", "cylinder"),
        ("a cupcake topped with a strawberry", "cupcake", "strawberry"),
    ],
)
def test_a_topping_is_on_the_thing_and_no_color(prompt, thing, top):
    words = parse(prompt)
    assert (words.noun, words.color, words.part) == (thing, "", "")
    assert [(one.relation, one.words.noun) for one in words.companions] == [("bears", top)]


def test_marshmallows_are_white_and_several():
    (one,) = parse("hot chocolate with marshmallows").companions
    assert (one.words.color, one.words.count, one.words.order) == ("white", 6, "heap")
    (one,) = parse("hot chocolate with pink marshmallows").companions
    assert one.words.color == "pink"


@pytest.mark.parametrize(
    ("prompt", "color"),
    [
        ("a cup of coffee", "coffee brown"),
        ("a cup of black coffee", "coffee brown"),
        ("hot chocolate", "chocolate brown"),
        ("a cup of hot cocoa", "chocolate brown"),
        ("a cup of tea", None),
        ("a cup of coffee with green tea", "green"),
    ],
)
def test_a_cup_has_a_liquid_in_its_color(prompt, color):
    words = parse(prompt, ignore_unknown=True)
    assert (words.noun, words.part_shades().get("tea")) == ("teacup", color)


def test_a_strawberry_is_in_the_place_of_the_cherry():
    assert parse("a cupcake topped with a strawberry").absent == ("cherry",)
    assert parse("a cupcake with a cherry on top").absent == ()
    assert parse("a milkshake with whipped cream and a cherry on top").absent == ()


@pytest.mark.parametrize("prompt", ["a tube of red lipstick", "a stick of red lip balm"])
def test_a_tube_of_lipstick_is_a_lipstick(prompt):
    words = parse(prompt)
    assert (words.noun, words.color, words.left_out) == ("lipstick", "red", ())


def test_cream_is_a_color_where_it_is_none_to_eat():
    assert parse("a cream mug").color_form == "cream" == parse("a mug, cream").color_form
