"""Words for what is under another thing, for riding a broom, and for some sets and contents."""

import pytest

from core.guidance.builtin.words.vocabulary import parse, understood


def others(prompt: str) -> list[str]:
    """Each companion as its relation, its number, its pose and its thing."""
    return [
        " ".join(filter(None, (one.relation, str(one.words.count), one.words.pose, one.words.noun)))
        for one in parse(prompt, ignore_unknown=True).companions
    ]


@pytest.mark.parametrize(
    ("prompt", "thing", "found"),
    [
        ("a cat under a table", "table", ["below 1 cat"]),
        ("a cat sleeping under a wooden table", "table", ["below 1 sleeping cat"]),
        ("a man sitting beneath a tree", "tree", ["below 1 sitting person"]),
        ("a mouse hiding under a mushroom", "mushroom", ["below 1 mouse"]),
        ("an umbrella over a picnic table", "umbrella", ["below 1 picnic table"]),
        ("a christmas tree with presents underneath", "christmas tree", ["below 3 gift"]),
        ("a christmas tree with two gifts under it", "christmas tree", ["below 2 gift"]),
        ("a desk with a chair under it", "desk", ["below 1 chair"]),
        # It is no roof, or who is under it does something.
        ("a baby under a blanket", "baby", []),
        ("a girl reading a book under an apple tree", "girl", ["holds 1 book"]),
    ],
)
def test_what_is_under_a_thing_comes_with_it(prompt, thing, found):
    assert (parse(prompt, ignore_unknown=True).noun, others(prompt)) == (thing, found)


@pytest.mark.parametrize(
    ("prompt", "thing", "absent"),
    [
        ("a witch riding a broom", "witch", ("broom",)),
        ("a witch flying on her broomstick", "witch", ("broom",)),
        ("a wizard riding a broomstick", "wizard", ()),
        ("a black cat sitting on a flying broom", "cat", ()),
    ],
)
def test_somebody_rides_a_broom_and_has_no_other(prompt, thing, absent):
    words = parse(prompt)
    assert (words.noun, words.absent, words.left_out) == (thing, absent, ())
    assert others(prompt) == ["on 1 broom"]


def test_a_witch_who_does_not_ride_keeps_her_broom():
    words = parse("a witch with a broom")
    assert (words.absent, words.companions) == ((), ())


@pytest.mark.parametrize(
    ("prompt", "thing", "found"),
    [
        ("a garden gnome fishing", "gnome", ["holds 1 fishing rod"]),
        ("a fishing boat", "boat", []),
        ("a carved pumpkin with a candle inside", "jack-o-lantern", []),
        ("a beehive hanging from a branch", "tree", ["hanging 1 beehive"]),
        ("a flower growing from a skull", "flower", ["on 1 skull"]),
        ("a wheel of cheese with a mouse", "cheese", ["beside 1 mouse"]),
        ("an apple with a leaf", "apple", []),
        ("a strawberry sundae with whipped cream", "sundae", []),
    ],
)
def test_what_goes_with_a_thing_by_itself(prompt, thing, found):
    assert (parse(prompt, ignore_unknown=True).noun, others(prompt)) == (thing, found)


def test_the_look_of_a_set_is_that_of_each_thing_in_it():
    words = parse("a ceramic tea set with blue flowers")
    (cups,) = words.companions
    for one in (words, cups.words):
        assert [str(emblem) for emblem in one.emblems] == ["blue flowers"]
        assert one.material == "ceramic"
    assert (words.noun, cups.words.noun, cups.words.count) == ("teapot", "teacup", 2)
    silver = parse("a silver tea service")
    assert {silver.named_material(), silver.companions[0].words.named_material()} == {"silver"}


def test_emblems_are_on_each_of_several():
    assert [str(one) for one in parse("two teacups with blue flowers").emblems] == ["blue flowers"]


def test_a_kind_has_its_own_colours_by_part():
    house = understood("a gingerbread house")
    assert house["part_colours"]["roof"] == "white" and house["pattern"] == "spotted"
    bagel = understood("a bagel")["part_colours"]
    assert bagel["icing"] == bagel["dough"]


def test_the_sand_of_an_hourglass_is_a_part():
    assert parse("an hourglass with blue sand").part_shades() == {"glass": "blue"}
