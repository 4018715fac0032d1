"""The built-in prior's parser: what it reads, and what it refuses by name."""

import pytest

from core.errors import UserError
from core.prior.data import ADJECTIVES
from core.prior.data import NOUNS as DRAWN
from core.prior.vocabulary import COLORS, FILLER, LEXICON, MATERIALS, NOUNS, SHAPES, Words, parse


@pytest.mark.parametrize(
    ("prompt", "words"),
    [
        ("a chair", Words("chair")),
        ("Chairs.", Words("chair")),
        ("a RED wooden chair", Words("chair", "", "red", "wooden")),
        ("a chair made of wood, red", Words("chair", "", "red", "wooden")),
        ("a donut", Words("torus")),
        ("blue doughnuts!", Words("torus", "", "blue")),
        ("a tall gray coffee-free mug".replace("coffee-free ", ""), Words("mug", "tall", "grey")),
        ("cup in the color of gold", Words("mug", "", "", "golden")),
        ("a DSLR photo of a highly detailed house", Words("house")),
        ("boxes", Words("cube")),
        ("a high-quality 3D model of a snowman", Words("snowman")),
        ("the vase's", Words("vase")),
        ("red red ball", Words("ball", "", "red")),
    ],
)
def test_a_prompt_is_read_into_slots(prompt, words):
    assert parse(prompt) == words


def test_the_order_of_words_does_not_matter():
    assert parse("wooden tall blue lamp") == parse("lamp, blue, tall, wooden")


@pytest.mark.parametrize("slot_words", [NOUNS, SHAPES, COLORS, MATERIALS])
def test_every_synonym_means_its_word(slot_words):
    for word, synonyms in slot_words.items():
        for form in [word, *synonyms.split()]:
            assert LEXICON[form][1] == word, f"{form} means two words"


def test_filler_hides_no_known_word():
    assert not FILLER & set(LEXICON)


def test_the_nouns_and_shapes_are_those_that_were_drawn_in_their_order():
    assert list(NOUNS) == DRAWN
    assert ["", *SHAPES] == ADJECTIVES


def test_a_typo_is_named_and_not_mended():
    with pytest.raises(UserError) as caught:
        parse("a red chiar")
    assert "'chiar' (did you mean chair" in caught.value.text
    assert "--guidance FOLDER" in caught.value.fix
    assert caught.value.status == 2


def test_a_word_of_another_thing_is_refused_with_the_nearest_known_one():
    with pytest.raises(UserError, match=r"'sofa' \(did you mean armchair"):
        parse("a leather sofa")
    with pytest.raises(UserError, match="'leather'"):
        parse("a leather sofa")


def test_all_known_words_are_listed_when_one_is_unknown():
    with pytest.raises(UserError) as caught:
        parse("a xyzzy")
    assert all(word in caught.value.fix for word in [*NOUNS, *COLORS, *MATERIALS, *SHAPES])
    assert "did you mean" not in caught.value.text


@pytest.mark.parametrize("prompt", ["", "   ", "red", "a photo of", "!?"])
def test_a_prompt_without_a_thing_is_refused(prompt):
    with pytest.raises(UserError, match="does not name a thing"):
        parse(prompt)


def test_two_things_and_two_colours_are_refused():
    with pytest.raises(UserError, match="one noun .* 'chair' and 'table'"):
        parse("a chair and a table")
    with pytest.raises(UserError, match="one color .* 'red' and 'blue'"):
        parse("a red and blue ball")


def test_a_negative_prompt_needs_no_noun_but_only_known_words():
    assert parse("", noun_needed=False) == Words()
    assert parse("red", noun_needed=False) == Words(color="red")
    with pytest.raises(UserError, match="'ugly'"):
        parse("ugly", noun_needed=False)


def test_indices_start_at_one_and_zero_is_unsaid():
    words = parse("a wooden ball")
    assert words.indices() == [1, 0, 0, 1]
    assert words.indices(("material", "noun")) == [1, 1]


def test_non_latin_words_are_named_too():
    with pytest.raises(UserError, match="'стул'"):
        parse("красный стул")
