"""Young animals with a parent in words: which thing they are, how many, how large."""

import pytest

from core.guidance.builtin.words.vocabulary import parse


def young(prompt: str) -> list[tuple[str, str, int]]:
    """The relation, the thing and the number of each companion."""
    return [(one.relation, one.words.noun, one.words.count) for one in parse(prompt).companions]


@pytest.mark.parametrize(
    ("prompt", "parent", "count"),
    [
        ("a mother duck with three ducklings", "duck", 3),
        ("a hen with chicks", "chicken", 3),
        ("a hen and her two chicks", "chicken", 2),
        ("a cat with two kittens", "cat", 2),
        ("a bear with her cub", "bear", 1),
        ("a mother bear and her cubs", "bear", 3),
        ("an elephant and its baby", "elephant", 1),
        ("a mother elephant with a calf", "elephant", 1),
        ("a penguin with a baby penguin", "penguin", 1),
        ("a mare and foal", "horse", 1),
        ("a duck followed by four ducklings", "duck", 4),
        ("a golden retriever with a litter of puppies", "dog", 4),
        ("a mother and baby giraffe", "giraffe", 1),
        ("a wolf with its pups following it", "wolf", 3),
    ],
)
def test_young_ones_are_small_animals_of_their_parents_kind(prompt: str, parent: str, count: int):
    words, found = parse(prompt), young(prompt)
    assert words.noun == parent and {noun for _, noun, _ in found} == {parent}
    assert {how for how, *_ in found} == {"beside"}
    assert sum(many for *_, many in found) == count
    sizes = [one.words.usual()[0] for one in words.companions]
    assert max(sizes) < 0.6 * words.usual()[0]


@pytest.mark.parametrize(
    ("prompt", "relation"),
    [
        ("a koala with a baby on its back", "bears"),
        ("a swan with three cygnets on its back", "bears"),
        ("a kangaroo with a joey in its pouch", "holds"),
        ("a cat carrying a kitten in its mouth", "holds"),
        ("a swan with a cygnet swimming beside it", "beside"),
    ],
)
def test_the_place_of_young_ones_may_be_stated(prompt: str, relation: str):
    words = parse(prompt)
    assert [one.relation for one in words.companions] == [relation]
    assert words.companions[0].words.noun == words.noun


def test_young_ones_have_their_parents_colours_or_their_own():
    (cub,) = parse("a polar bear with her cub").companions
    assert cub.words.color == "white" and cub.words.of_parts("color")["muzzle"] == "white"
    for one in parse("a black cat with two kittens").companions:
        assert one.words.color == "black"
    for one in parse("a brown duck with ducklings").companions:
        assert one.words.color == "yellow"
    (kitten,) = parse("a black cat with a white kitten").companions
    assert kitten.words.color == "white"


@pytest.mark.parametrize(
    ("prompt", "noun", "companion"),
    [
        ("a bear with a baby panda", "bear", "panda"),
        ("a dog with a kitten", "dog", "cat"),
        ("a woman with her baby", "person", "baby"),
        ("a dog with a child", "dog", "boy"),
    ],
)
def test_the_young_of_another_are_another(prompt: str, noun: str, companion: str):
    words = parse(prompt)
    assert (words.noun, words.companions[0].words.noun) == (noun, companion)


@pytest.mark.parametrize("prompt", ["a baby elephant", "a seal pup", "a mother hen", "a mug"])
def test_one_animal_is_one(prompt: str):
    assert parse(prompt).companions == ()
