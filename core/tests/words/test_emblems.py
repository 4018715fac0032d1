"""What a prompt wants written or drawn on the thing is taken out of the prompt."""

import pytest

from core.errors import UserError
from core.guidance.builtin.palette import painted
from core.guidance.builtin.words.phrases.emblems import (
    MOST_LETTERS,
    STRIPES,
    Emblem,
    emblem_in,
    emblems_in,
)
from core.guidance.builtin.words.vocabulary import parse, understood

# Of a prompt: the text, the shape, the colour, the part, the side; and what is left of the prompt.
TAKEN = {
    "a white mug with a red heart": ("", "heart", "red", "", "", "a white mug"),
    "a wooden sign that says WELCOME": ("WELCOME", "", "", "", "", "a wooden sign"),
    "a sign that says hello world in red letters": ("hello world", "", "red", "", "", "a sign"),
    "a sign that says OPEN in big red letters": ("OPEN", "", "red", "", "", "a sign"),
    'an arcade cabinet with the words "STAR BLASTER" across the marquee in chunky yellow letters': (
        ("STAR BLASTER", "", "yellow", "marquee", "", "an arcade cabinet")
    ),
    "a mug that says HELLO in red block letters": ("HELLO", "", "red", "", "", "a mug"),
    "a sign that says OPEN in bold letters": ("OPEN", "", "", "", "", "a sign"),
    "a sign which reads keep out": ("keep out", "", "", "", "", "a sign"),
    "a blue sports car with white racing stripes": (
        ("", STRIPES, "white", "", "", "a blue sports car")
    ),
    "a red race car with the number 7": ("7", "", "", "", "", "a red race car"),
    "a red car, number 5": ("5", "", "", "", "", "a red car"),
    "a race car with #42 on the hood": ("42", "", "", "hood", "", "a race car"),
    "a tombstone that says RIP": ("RIP", "", "", "", "", "a tombstone"),
    "a birthday cake with happy birthday written on it": (
        ("happy birthday", "", "", "", "", "a birthday cake")
    ),
    "a shield with a red cross": ("", "cross", "red", "", "", "a shield"),
    "a crate labeled TNT": ("TNT", "", "", "", "", "a crate"),
    'a jar labelled "HONEY"': ("HONEY", "", "", "", "", "a jar"),
    "a barrel marked with a skull": ("", "skull", "", "", "", "a barrel"),
    'an "OPEN" sign': ("OPEN", "", "", "", "", "an sign"),
    "a wooden crate, marked 'EXPLOSIVE' in red paint": (
        ("EXPLOSIVE", "", "red", "", "", "a wooden crate")
    ),
    "an old book with a golden moon on the cover": (
        "",
        "moon",
        "golden",
        "cover",
        "",
        "an old book",
    ),
    "a school bus with number 12 on the side": ("12", "", "", "", "side", "a school bus"),
    "a blue cap with a lightning bolt on the front": (
        ("", "lightning bolt", "", "", "front", "a blue cap")
    ),
    "a jersey with number 23 on the back": ("23", "", "", "", "back", "a jersey"),
    "a white t-shirt with the word LOVE in pink letters": (
        ("LOVE", "", "pink", "", "", "a white t-shirt")
    ),
    'a white mug with a blue "M" on it': ("M", "", "blue", "", "", "a white mug"),
    "a mug that says World's Best Dad": ("World's Best Dad", "", "", "", "", "a mug"),
    "a ring engraved with “LOVE”": ("LOVE", "", "", "", "", "a ring"),
    "a mug with «LOVE» on it": ("LOVE", "", "", "", "", "a mug"),
    "a ‘NO’ sign": ("NO", "", "", "", "", "a sign"),
    'a sign that says "(.*)+$"': ("(.*)+$", "", "", "", "", "a sign"),
    "a green bottle with a question mark on it": ("?", "", "", "", "", "a green bottle"),
    "a teddy bear with a red heart on its belly": ("", "heart", "red", "belly", "", "a teddy bear"),
    "a yellow taxi with the word TAXI on the door": ("TAXI", "", "", "door", "", "a yellow taxi"),
    "a guitar with a star sticker": ("", "star", "", "", "", "a guitar"),
    "a mug with a flower print": ("", "flower", "", "", "", "a mug"),
    "a barrel with a black radiation symbol": ("", "radiation sign", "black", "", "", "a barrel"),
    "a mug with a red heart and a golden handle": (
        ("", "heart", "red", "", "", "a mug with a golden handle")
    ),
}


LEFT = (
    "a robot reading a book",
    "a dog with a flower",
    "a bear with a crown",
    "a bow with an arrow",
    "a ship with an anchor",
    "a lamp with a star-shaped base",
    "a chair with a heart-shaped back",
    "a house with a red door",
    "a house with 12 windows",
    "a house with a number on the door",
    "a jar with a label on the front",
    "a bottle with a white label and a cork",
    "a keyboard with white letters on black keys",
    "a mug with text in red",
    "a cat with a bell on its collar",
    "a black mug with white polka dots",
    "a ring with a heart shaped diamond",
    "a golden star",
    "a heart",
    "a flower pot",
    "a stop sign",
    "a dog's bowl",
    "the dogs' bowl and the cats' toy",
    '"a red chair"',
    "“a red chair”",
    '"OPEN"',
    '""',
    'a mug with ""',
    'a mug that says ""',
    'a mug with "',
    "a mug that says",
    r"a mug (with [a] *chair*) + \d+ $^",
    r"a mug that says (a|b)* \1 [",
    "",
    " ",
)


@pytest.mark.parametrize("prompt", TAKEN)
def test_what_is_to_be_drawn_is_taken_out_of_the_prompt(prompt):
    emblem, rest = emblem_in(prompt)
    assert emblem is not None
    assert (emblem.text, emblem.shape, emblem.color, emblem.on, emblem.side, rest) == TAKEN[prompt]


@pytest.mark.parametrize("prompt", LEFT)
def test_what_is_no_drawing_stays_in_the_prompt(prompt):
    assert emblem_in(prompt) == (None, prompt)


def test_a_text_that_is_too_long_is_not_taken():
    assert emblem_in(f'a sign that says "{"x" * MOST_LETTERS}"')[0].text == "x" * MOST_LETTERS
    long = f'a sign that says "{"x" * (MOST_LETTERS + 1)}"'
    assert emblem_in(long) == (None, long)


@pytest.mark.parametrize(
    "text", ["a", "a ", '"', "' ", '" ', "AB ", "with a red ", "says ", "'a", "heart on the ", "🙂"]
)
def test_however_long_a_prompt_is_it_is_read(text):
    prompt = (text * 5000)[:5000]
    emblem, rest = emblem_in(prompt)
    assert emblem or rest == prompt


@pytest.mark.parametrize(
    ("prompt", "noun", "part"),
    [
        ("a christmas tree with a star", "christmas tree", "star"),
        ("an ambulance with a red cross", "ambulance", "cross"),
        ("a medal with a star", "medal", "star"),
    ],
)
def test_what_the_thing_has_by_nature_is_its_part(prompt, noun, part):
    words = parse(prompt)
    assert words.noun == noun and words.emblems == () and not words.left_out
    assert part in [paint.name for paint in painted(noun, words)]


def test_a_stated_colour_of_a_things_own_part_is_not_lost():
    words = parse("a christmas tree with a blue star")
    assert words.emblems == () and words.part_shades() == {"star": "blue"}


def test_what_is_said_beside_the_drawing_is_read():
    words = parse("a blue mug with a red heart and a golden handle")
    assert words.color == "blue" and words.emblems == (Emblem("", "heart", "red", "red"),)
    assert words.of_parts("material") == {"handle": "golden"} and not words.left_out
    words = parse("a striped mug that says NO ENTRY in crimson")
    assert words.pattern == "striped" and str(words.emblems[0]) == 'crimson "NO ENTRY"'
    assert words.emblems[0].color_form == "crimson" and not words.color


def test_a_comma_behind_a_drawing_keeps_what_follows_apart():
    """A pirate ship was a cannon, and a crate with an open lid refused."""
    ship = parse("a pirate ship with a skull on the sail, cannons poking out")
    assert (ship.noun, [str(one) for one in ship.emblems]) == ("pirate ship", ["skull"])
    assert parse("a crate with FRAGILE stamped on the side, lid a bit open").noun == "crate"


def test_what_was_understood_has_the_drawing():
    assert understood("a tombstone that says RIP")["emblems"] == ['"RIP"']
    assert understood("a shield with a red cross")["emblems"] == ["red cross"]
    assert understood("a shield")["emblems"] == []


def test_a_prompt_with_nothing_but_a_drawing_is_of_no_thing():
    with pytest.raises(UserError):
        parse('"(.*)"')


@pytest.mark.parametrize(
    ("prompt", "emblems", "rest"),
    [
        ("a mug with a red heart and a blue star", ["red heart", "blue star"], "a mug"),
        ("a mug that says HELLO and a red heart", ['"HELLO"', "red heart"], "a mug"),
        ("a mug, star logo, and a heart", ["star", "heart"], "a mug"),
        ("a sign that says OPEN and a lamp", ['"OPEN"'], "a sign and a lamp"),
        ("a mug with a star on it and a moon on it", ["star", "moon"], "a mug"),
        ("a race car with number 7 and a driver", ['"7"'], "a race car with a driver"),
        ("a dog with a paw print collar", ["paw print"], "a dog with a collar"),
        ("a crate labeled TNT and made of oak", ['"TNT"'], "a crate and made of oak"),
        ("a mug with a heart, made of clay", ["heart"], "a mug, made of clay"),
        ("a boat with an anchor on the sail, white", ["anchor"], "a boat, white"),
        ("a staff with a star on top", [], "a staff with a star on top"),
        ("a 'medieval' sword", [], "a 'medieval' sword"),
        ('a "low poly" fox', [], 'a "low poly" fox'),
        ('a mug "World\'s Best Dad"', ['"World\'s Best Dad"'], "a mug"),
    ],
)
def test_what_stands_beside_what_is_drawn_stays(prompt, emblems, rest):
    found, left = emblems_in(prompt)
    assert ([str(one) for one in found], left) == (emblems, rest)


def test_a_negative_prompt_has_none():
    words = parse("a red mug with a star", noun_needed=False)
    assert words.emblems == ()


@pytest.mark.parametrize(
    ("prompt", "shade"),
    [
        ("blue jeans", "denim blue"),
        ("a blue denim jacket", "denim blue"),
        ("a dark blue pair of jeans", "navy"),
        ("a blue jacket", "blue"),
    ],
)
def test_the_blue_of_denim(prompt, shade):
    assert understood(prompt)["colours"] == [shade]
