"""The sizes of what is made as a larger or a smaller thing: a kennel is a house of a metre."""

import pytest

from core.guidance.builtin.nouns import NOUNS
from core.guidance.builtin.physical import usual_of
from core.guidance.builtin.words.grammar.lexicon import LEXICON, NARROWER, SLOTS
from core.guidance.builtin.words.tables.kind_sizes import KIND_SIZES, YOUNG_SCALE
from core.guidance.builtin.words.tables.sizes import TOY_SIZE
from core.guidance.builtin.words.tables.words import ALONE
from core.guidance.builtin.words.vocabulary import understood
from core.io.job import SIZES

KINDS = [(thing, form) for thing, kinds in KIND_SIZES.items() for form in kinds]


def read(prompt: str) -> dict:
    return understood(prompt, known=SLOTS)


def test_every_kind_with_a_size_is_a_narrower_word_of_its_thing():
    for thing, form in KINDS:
        assert LEXICON[form] == ("noun", thing) or ALONE[form] == thing, form
        assert form in NARROWER or form in ALONE, form


def test_every_such_size_is_not_that_of_the_thing():
    for thing, kinds in KIND_SIZES.items():
        usual, sizes = NOUNS[thing].usual.size_m, list(kinds.values())
        assert all(SIZES[0] <= size <= SIZES[1] for size in sizes), thing
        assert all(max(size / usual, usual / size) >= 1.25 for size in sizes), thing
        assert sizes == sorted(sizes), thing


def test_every_kind_is_read_with_its_size_and_named_once():
    for thing, form in KINDS:
        found = read(f"a {form}")
        assert (found["thing"], found["size_m"]) == (thing, KIND_SIZES[thing][form]), form
    assert len(KINDS) == len({form for _, form in KINDS})


@pytest.mark.parametrize(
    ("prompt", "thing", "size"),
    [
        ("a red wooden kennel", "house", 1.1),
        ("two ravens", "bird", 0.63),
        ("a small goldfish", "fish", 0.7 * 0.15),
        ("a huge orca", "orca", 2 * 6),
        ("a kraken 3 m tall", "octopus", 3),
        ("a 30 cm long sleigh", "sleigh", 0.3),
        ("a toy aircraft carrier", "cargo ship", TOY_SIZE),
        ("a toy angelfish", "fish", 0.15),
        ("an orca plushie", "orca", TOY_SIZE),
        ("a stone statue of a dwarf", "dwarf", 1.3),
        ("a cobblestone", "boulder", 0.12),
        ("a pigeon bird", "bird", 0.33),
        ("a labrador puppy", "dog", 0.35),
        ("a great dane puppy", "dog", 0.35),
        ("a house and a shed", "house", 8),
        ("a birdhouse with a chick", "birdhouse", 0.4),
        ("a pug with a chihuahua", "pug", 0.45),
        ("a labrador", "dog", 0.8),
    ],
)
def test_a_kind_has_its_own_size_and_what_is_said_of_it_counts(prompt, thing, size):
    found = read(prompt)
    assert (found["thing"], found["size_m"]) == (thing, pytest.approx(size))
    assert usual_of(prompt)[0] == pytest.approx(size) or "m " in prompt


def test_a_toy_is_only_noted_where_the_kind_is_larger():
    assert not any("no longer than" in note for note in read("a clownfish plush toy")["notes"])
    assert any("no longer than" in note for note in read("a tuna plush toy")["notes"])


def test_a_kind_weighs_as_much_less_as_it_is_smaller():
    (house, density), (kennel, same) = usual_of("a house"), usual_of("a kennel")
    assert kennel < house / 5
    assert density == same


@pytest.mark.parametrize(
    ("prompt", "times"),
    [
        ("a baby turtle", YOUNG_SCALE),
        ("two wolf cubs", YOUNG_SCALE),
        ("a baby goblin", YOUNG_SCALE),
        ("a big baby turtle", 1.5 * YOUNG_SCALE),
        ("a baby crib", 1),
        ("a baby tooth", 1),
    ],
)
def test_who_is_young_is_smaller_than_who_is_grown(prompt, times):
    found = read(prompt)
    usual = NOUNS[found["thing"]].usual.size_m
    assert found["size_m"] == pytest.approx(times * usual)
    assert ("baby" in found["left_out"]) == (times == 1)


def test_who_is_young_by_name_or_of_a_stated_size_is_not_made_smaller_again():
    assert read("a baby lamb")["size_m"] == read("a lamb")["size_m"]
    assert read("a baby turtle, 3 cm long")["size_m"] == 0.03
    assert read("a baby turtle plushie")["size_m"] == TOY_SIZE


@pytest.mark.parametrize(
    ("sort", "kind"),
    [("a retro television", "a retro tv"), ("a slice of pizza", "a pizza slice")],
)
def test_a_sort_is_as_large_as_the_kind_that_is_called_so(sort, kind):
    assert read(sort)["size_m"] == read(kind)["size_m"] < NOUNS[read(sort)["thing"]].usual.size_m
