"""The built-in prior's parser: what it reads, what it corrects, what it refuses by name."""

import re
from pathlib import Path

import pytest

from core.errors import UserError
from core.guidance.builtin.nouns import CONSTRUCTED, GROUPS, NOUNS, row_of
from core.guidance.builtin.stretch import STRETCH
from core.guidance.builtin.words.grammar.lexicon import LEXICON, SLOTS, corrected, forms_of
from core.guidance.builtin.words.phrases.slots import Companion, Words
from core.guidance.builtin.words.tables.nearest import NEAREST, REAL
from core.guidance.builtin.words.tables.part_tables import OPTIONS, PART_WORDS
from core.guidance.builtin.words.tables.words import (
    COLORS,
    COUNTS,
    FILLER,
    IGNORED_ADJECTIVES,
    MATERIALS,
    PATTERNS,
    PHRASE_ENDS,
    SHAPES,
)
from core.guidance.builtin.words.vocabulary import parse, understood
from core.prior.data import ADJECTIVES, PART_STATES
from core.prior.data import NOUNS as DRAWN

NAMES = {word: noun.names for word, noun in NOUNS.items()}


@pytest.mark.parametrize(
    ("prompt", "words"),
    [
        ("a chair", Words("chair")),
        ("Chairs.", Words("chair", count=3)),
        ("a RED wooden chair", Words("chair", color="red", material="wooden")),
        ("a chair made of wood, red", Words("chair", color="red", material="wooden")),
        ("a donut", Words("donut")),
        ("blue doughnuts!", Words("donut", color="blue", count=3)),
        ("a tall gray mug", Words("mug", "tall", color="grey")),
        ("cup in the color of gold", Words("mug", material="golden")),
        ("a DSLR photo of a highly detailed house", Words("house")),
        ("boxes", Words("cube", count=3)),
        ("a high-quality 3D model of a snowman", Words("snowman")),
        ("the vase's", Words("vase")),
        ("red red ball", Words("ball", color="red")),
        ("an ice cream cone", Words("ice cream")),
        ("a cone", Words("cone")),
        ("teddy bears", Words("teddy bear", count=3)),
        ("a rusty metal anvil", Words("anvil", material="rusty")),
        ("a glass-like bottle", Words("bottle", material="glass")),
        ("a dark green sofa", Words("sofa", color="dark green")),
        ("navy blue sofa, dark blue", Words("sofa", color="navy")),
        ("a round table", Words("table", "round")),
        ("a ripe orange", Words("orange fruit")),
        ("a blue orange", Words("orange fruit", color="blue")),
        ("oranges", Words("orange fruit")),
        ("an orange cat", Words("cat", color="orange")),
        ("a cat, orange", Words("cat", color="orange")),
        ("an orange tomato", Words("tomato", color="orange")),
        ("wolves", Words("wolf", count=3)),
        ("fairies", Words("fairy", count=3)),
        ("knives", Words("knife", count=3)),
        ("women", Words("person")),
    ],
)
def test_a_prompt_is_read_into_slots(prompt, words):
    assert parse(prompt) == words
    assert parse(prompt).notes == ()


@pytest.mark.parametrize(
    ("prompt", "words"),
    [
        (
            "two-tone armchair, red",
            Words("armchair", color="red", pattern="two-tone"),
        ),
        (
            "red and white striped ball",
            Words("ball", color="red", pattern="striped", second="white"),
        ),
        ("a polka dot teapot", Words("teapot", pattern="spotted")),
        ("a chequered bowl", Words("bowl", pattern="checkered")),
        ("a red and blue ball", Words("ball", color="red", pattern="two-tone", second="blue")),
        (
            "a red mug with a blue handle",
            Words("mug", part="handle", color="red", second="blue", target="handle"),
        ),
        ("a house with a blue roof", Words("house", second="blue", target="roof")),
        (
            "a blue robot with yellow eyes",
            Words("robot", color="blue", second="yellow", target="eyes"),
        ),
        ("a lamp with a red shade", Words("lamp", second="red", target="shade")),
    ],
)
def test_two_colours_are_a_pattern_or_belong_to_parts(prompt, words):
    assert parse(prompt) == words


@pytest.mark.parametrize(
    ("prompt", "words"),
    [
        ("a bronze statue of a lion", Words("lion", material="copper", is_statue=True)),
        ("a lion statue", Words("lion", material="stone", is_statue=True)),
        (
            "the stone sculpture of a man on a horse",
            Words(
                "person",
                material="stone",
                is_statue=True,
                companions=(Companion("on", Words("horse", material="stone", is_statue=True)),),
            ),
        ),
        ("a statue", Words("bust")),
        ("a statue holding a sword", Words("bust")),
        ("a bust of a king", Words("bust")),
        ("a bust of a cat", Words("cat", material="stone", is_statue=True)),
        ("a bronze lion bust", Words("lion", material="copper", is_statue=True)),
    ],
)
def test_what_is_depicted_is_made_and_not_the_statue(prompt, words):
    read = parse(prompt)
    assert read == words
    form = next((form for form in ("statue", "sculpture") if form in prompt), "")
    assert not form or f"{form}: made as a {words.noun}." in read.notes


def test_iron_is_a_thing_only_where_no_other_is_named():
    assert parse("a blue iron") == Words("clothes iron", color="blue")
    assert parse("an iron sword") == Words("sword", material="metal")
    assert parse("a sword of iron").material == "metal"
    assert parse("iron", noun_needed=False) == Words(material="metal")
    with pytest.raises(UserError, match="does not name a thing"):
        parse("an iron xyzzy", ignore_unknown=True)


def test_what_is_made_by_hand_is_no_hand():
    assert parse("a hand-painted wooden mug") == Words("mug", material="wooden")
    assert parse("a hand made of stone") == Words("hand", material="stone", is_statue=True)


def test_the_order_of_words_does_not_matter():
    assert parse("wooden tall blue lamp") == parse("lamp, blue, tall, wooden")


@pytest.mark.parametrize("table", [NAMES, SHAPES, COLORS, MATERIALS, PATTERNS, PART_WORDS])
def test_every_synonym_means_its_word(table):
    for word, synonyms in table.items():
        for form in [word, *forms_of(synonyms)]:
            slot, meant = LEXICON[form.replace("-", " ").replace("'s", "")]
            # A part may be a thing of its own, as a hat and a cap are: after a noun it is the part.
            as_part = table is PART_WORDS and slot == "noun"
            assert meant == word or as_part, f"{form} means two words"


def test_the_tables_hide_nothing_from_each_other():
    assert FILLER.isdisjoint(LEXICON)
    assert IGNORED_ADJECTIVES.isdisjoint(LEXICON)
    assert IGNORED_ADJECTIVES.isdisjoint(FILLER)
    assert PHRASE_ENDS <= FILLER
    assert COUNTS.isdisjoint(LEXICON) and COUNTS.isdisjoint(FILLER)
    assert REAL.isdisjoint(LEXICON)
    for word, forms in NEAREST.items():
        assert word in LEXICON
        assert not set(forms.split(", ")) & set(LEXICON)


def test_the_readme_lists_all_things():
    text = (Path(__file__).parents[3] / "README.md").read_text(encoding="utf-8")
    assert f"it knows {len(NOUNS)} things" in text
    for group, nouns in GROUPS.items():
        assert f"| {group.lower()} ({len(nouns)}) | {', '.join(nouns)} |" in text


def test_the_words_are_those_that_were_drawn_in_their_order():
    borrowed = [noun for noun, row in NOUNS.items() if row.solid]
    others = [noun for noun in CONSTRUCTED if noun not in DRAWN and noun not in borrowed]
    assert [*DRAWN, *borrowed, *others] == list(NOUNS)
    assert {row_of(noun) for noun in NOUNS} == {"", *DRAWN}
    rows = [noun for group in GROUPS.values() for noun in group]
    assert sorted(rows) == sorted(NOUNS), "each once, and in the networks' order"
    assert ["", *SHAPES] == ADJECTIVES == ["", *STRETCH]
    assert ["", *SLOTS["part"]] == PART_STATES
    assert all(state in SLOTS["part"] for options in OPTIONS.values() for state in options)


@pytest.mark.parametrize(
    ("typed", "meant"),
    [
        *(("chiar", "chair"), ("tabel", "table"), ("mushrom", "mushroom"), ("snowmann", "snowman")),
        *(("armchiars", "armchair"), ("whithout", "without"), ("stripped", "striped")),
    ],
)
def test_a_slip_is_corrected(typed, meant):
    assert corrected(typed) == meant


def test_orange_is_a_colour_where_it_names_no_fruit():
    assert parse("an orange with pips").noun == "orange fruit"
    assert parse("orange", noun_needed=False) == Words(color="orange")
    for prompt in ("orange and blue", "black and orange", "painted in orange", "an orange widget"):
        with pytest.raises(UserError):
            parse(prompt)


def test_what_was_corrected_is_in_the_notes():
    words = parse("a read chiar without armrsts".replace("read", "red"))
    assert (words.noun, words.color, words.part) == ("chair", "red", "no armrests")
    assert words.notes == ("'chiar' is read as 'chair'.", "'armrsts' is read as 'armrests'.")
    assert parse("a dark yellow car") == Words("car", color="yellow", color_form="dark yellow")


def test_an_everyday_word_is_no_slip_of_a_known_one():
    words = parse("a boat of the class of past years, ballet")
    assert not [note for note in words.notes if "is read as" in note]


def test_a_corrected_word_begins_a_phrase_like_any_other():
    assert parse("a wizzard hat").noun == "wizard hat"
    assert parse("a tedy bear").noun == "teddy bear"
    assert parse("a teady bear").noun == "teddy bear"
    assert parse("a snowman witout a hat").part == "no hat"


@pytest.mark.parametrize("word", ["month", "three", "chess", "shark", "roll", "park", "broth"])
def test_a_word_of_another_thing_is_no_slip(word):
    assert corrected(word) == ""


def test_an_adjective_that_changes_nothing_is_left_out_and_reported():
    words = parse("a cozy leather armchair")
    assert (words.noun, words.material) == ("armchair", "leather")
    assert words.notes == ("The built-in model does not know 'cozy': left out.",)
    with pytest.raises(UserError, match="'okapi'") as caught:
        parse("a cozy okapi")
    assert "cozy" not in caught.value.text


def test_a_style_is_no_shape_and_reported():
    words = parse("a high-poly tree, 8k, octane render, white background")
    assert words == Words("tree")  # neither high nor white
    assert words.left_out == ("high poly",)  # the rest is of a picture


@pytest.mark.parametrize("prompt", ["two pairs of scissors", "many grapes", "a two headed apple"])
def test_of_what_is_not_counted_one_is_made_and_that_is_said(prompt):
    words = parse(prompt)
    assert (words.count, words.order) == (1, "row")
    assert words.notes[0].partition(": ")[2] == "one thing is made at a time."


@pytest.mark.parametrize(
    ("prompt", "words"),
    [
        ("a robot playing cards, in red", Words("robot", color="red")),
        ("a dragon guarding gold", Words("dragon")),
        ("a chest full of gold", Words("open chest")),
        ("a chest full of toys", Words("chest")),
        ("a chest covered in gold", Words("chest", material="golden")),
        ("a red teapot full of blue paint with a green handle",
         Words("teapot", color="red", second="green", target="handle")),
        ("a cottage by a blue lake", Words("cottage")),
        ("a cat near a green tree", Words("cat")),
        ("a rolling pin", Words("rolling pin")),
        ("a burning torch", Words("torch")),
    ],
)  # fmt: skip
def test_what_a_thing_does_and_what_is_near_it_is_not_of_it(prompt, words):
    found = parse(prompt)
    assert found == words
    assert found.notes or not found.left_out


@pytest.mark.parametrize(
    ("prompt", "part", "color"),
    [
        ("a robot with green flickering eyes", "eyes", "green"),
        ("a house with a red crooked roof", "roof", "red"),
        ("a cauldron with green bubbling potion", "brew", "green"),
    ],
)
def test_a_word_for_how_a_part_is_leaves_it_its_colour(prompt, part, color):
    found = understood(prompt)
    assert (found["part_colours"], found["colours"]) == ({part: color}, [])
    assert found["companions"] == []


def test_an_unknown_word_is_refused_with_the_nearest_known_one():
    with pytest.raises(UserError, match=r"'minaret' \(did you mean tower"):
        parse("a cement minaret")
    with pytest.raises(UserError) as caught:
        parse("a cement minaret")
    assert "'cement' (did you mean stone" in caught.value.text
    assert "--guidance FOLDER" in caught.value.fix
    assert caught.value.status == 2


def test_the_words_about_a_thing_are_listed_when_one_is_unknown():
    with pytest.raises(UserError) as caught:
        parse("a xyzzy")
    known = [*COLORS, *MATERIALS, *SHAPES, *PATTERNS]
    assert all(word in caught.value.fix for word in known)
    assert f"It knows {len(NOUNS)} things, such as table, chair, " in caught.value.fix
    assert "all: run.py words." in caught.value.fix
    assert "did you mean" not in caught.value.text


def test_unknown_words_can_be_left_out_and_that_is_reported():
    words = parse("a baroque red chair, xyzzy", ignore_unknown=True)
    assert words == Words("chair", color="red")
    assert "'baroque', 'xyzzy'" in words.notes[0]
    with pytest.raises(UserError, match="does not name a thing"):
        parse("xyzzy", ignore_unknown=True)


def test_a_word_that_the_weights_do_not_know_is_refused():
    known = SLOTS | {"noun": ["chair"]}
    assert parse("a chair", known=known).noun == "chair"
    with pytest.raises(UserError, match="'table'"):
        parse("a table", known=known)
    known = SLOTS | {"part": ["handle", "no handle"]}
    assert parse("a mug with a handle", known=known).part == "handle"
    with pytest.raises(UserError, match="cannot make a chair with armrests"):
        parse("a chair with armrests", known=known)


@pytest.mark.parametrize("prompt", ["", "   ", "red", "a photo of", "!?"])
def test_a_prompt_without_a_thing_is_refused(prompt):
    with pytest.raises(UserError, match="does not name a thing"):
        parse(prompt)


def test_two_things_that_nothing_joins_are_refused_and_of_more_words_the_first_count():
    with pytest.raises(UserError, match="one thing .* 'chair' and 'table'"):
        parse("a chair or a table")
    words = parse("a red, blue and green ball")
    assert (words.color, words.second, words.left_out) == ("red", "blue", ("green",))
    assert "green: left out, as two colours are taken." in words.notes
    assert (words.color_form, words.second_form) == ("", "")
    words = parse("a wooden and metal vase")
    assert (words.material, words.left_out) == ("wooden", ("metal",))
    assert "metal: left out, as one material is taken." in words.notes


@pytest.mark.parametrize(
    ("prompt", "words"),
    [
        ("a stop sign bent at the pole", Words("stop sign")),
        ("a rolled up rug, lilac", Words("rug", color="purple")),
        ("a coral cluster", Words("coral")),
        ("a bathtub 1950s", Words("bathtub")),
        ("a tower 3 levels high", Words("tower")),
        ("office building 5 floors", Words("skyscraper")),
        ("a mermaid sitting on a rock combing her hair", Words("mermaid")),
        ("a tree with snow on the branches", Words("tree", weather=("snowy",))),
        ("pls make me a robot w sunglasses", Words("robot")),
        ("a red n black chair", Words("chair", color="red")),
        ("a lightsaber but purple", Words("lightsaber", color="purple")),
        ("a knight's shield with a lion on it", Words("shield")),
        ("a knight sword", Words("sword")),
        ("a knight shield", Words("shield")),
        ("a knight\u2019s shield", Words("shield")),
        ("a candle, soft pink lighting", Words("candle")),
        ("a graceful red vase, playful and colourful", Words("vase", color="red")),
        ("a wall mounted mirror", Words("mirror")),
        ("a playful icon of a chair", Words("chair")),
        ("a guitar spanish", Words("guitar")),
    ],
)
def test_what_is_said_around_a_thing_does_not_refuse_it_or_change_it(prompt, words):
    read = parse(prompt)
    assert (read.noun, read.color, read.material) == (words.noun, words.color, words.material)
    assert read.weather == words.weather


@pytest.mark.parametrize("thing", ["sawfish", "tumbleweed"])
def test_an_unknown_thing_that_ends_as_a_description_does_is_named(thing):
    with pytest.raises(UserError, match=f"does not know '{thing}'"):
        parse(f"a {thing}")


def test_a_negative_prompt_needs_no_noun_but_only_known_words():
    assert parse("", noun_needed=False) == Words()
    assert parse("red", noun_needed=False) == Words(color="red")
    with pytest.raises(UserError, match="'ugly'"):
        parse("ugly", noun_needed=False)


def test_indices_start_at_one_and_zero_is_not_stated():
    words = parse("a wooden ball")
    assert words.indices() == [1, 0, 0, 0, 1, 0, 0, 0]
    assert words.indices(("material", "noun")) == [1, 1]


def test_words_as_text_can_be_read_again():
    words = parse("a tall striped red wooden chair")
    assert parse(str(words)) == words


def test_non_latin_words_are_named_too():
    with pytest.raises(UserError, match=re.escape("'стул'")):
        parse("красный стул")


@pytest.mark.parametrize(
    ("prompt", "words"),
    [
        ("a car, exposed copper pipes, cyan thrusters", Words("car")),
        ("a wall torch, wrought iron, xyzzy", Words("torch", material="metal")),
        ("a katana, black scabbard", Words("katana")),
        ("a raccoon dressed as a xyzzy", Words("raccoon")),
        (
            "a chair in red wood, green silk curtains",
            Words("chair", color="red", material="wooden"),
        ),
        ("a table made out of xyzzy wood", Words("table", material="wooden")),
        ("a peacock between the blue and emerald pieces", Words("peacock")),
        ("goblin shaman, game character", Words("goblin")),
        ("an old train station clock", Words("clock", weather=("worn",))),
        ("a cat shaped like an elephant", Words("cat")),
        ("a headset with pink cat ears and glowing xyzzy", Words("headphones")),
        ("a tall thin vase", Words("vase", shape="tall")),
        ("a dragon character", Words("dragon")),
        ("a dwarf elephant piled high", Words("elephant")),
    ],
)
def test_once_the_thing_is_known_what_is_strange_is_left_out_with_its_looks(prompt, words):
    found = parse(prompt)
    assert found == words
    assert found.notes


@pytest.mark.parametrize("prompt", ["a guitar case", "a car exhaust", "giraffe neck"])
def test_what_the_thing_before_it_has_not_is_the_thing_that_is_meant(prompt):
    with pytest.raises(UserError, match="does not know"):
        parse(prompt)


def test_of_a_part_alone_the_whole_is_made_and_that_is_said():
    assert parse("a sword handle").notes == ("sword handle: made as a sword, whole.",)
    assert parse("a sword with a handle").notes == ()
