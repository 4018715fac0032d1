"""Sizes that a prompt states, and the size of what is made then."""

import pytest
import torch

from core.guidance.builtin.physical import longest_side
from core.guidance.builtin.words.grammar.measures import Size, set_apart
from core.guidance.builtin.words.vocabulary import parse, understood
from core.io.job import Job
from core.io.run_folder import RunFolder
from core.stages.preview import size_of


@pytest.mark.parametrize(
    ("prompt", "size"),
    [
        ("a giraffe 5 m tall", Size(5, "height")),
        ("a traffic cone 75 cm", Size(0.75)),
        ("a shipping container 20ft, blue", Size(6.096)),
        ("a rug 1.5 m across", Size(1.5, "diameter")),
        ("a lion 3 metres long", Size(3)),
        ("a 2-metre-tall robot", Size(2, "height")),
        ("a 6'2\" knight", Size(1.8796)),
        ("a knight, 6 ft 2 in tall", Size(1.8796, "height")),
        ("a 6’ tall knight", Size(1.8288, "height")),
        ("a six foot tall bear", Size(1.8288, "height")),
        ("a table, 120 x 60 x 75 cm", Size(1.2)),
        ("a table 2m x 1m", Size(2)),
        ("a lamp with a height of 40 cm", Size(0.4, "height")),
        ("a vase, height: 30cm", Size(0.3, "height")),
        ("a 12 inch pizza", Size(0.3048)),
        ('a 15" laptop', Size(0.381)),
        ("a 15\u2033 laptop", Size(0.381)),
        ("a 15'' laptop", Size(0.381)),
        ("half a metre tall gnome", Size(0.5, "height")),
        ("a bookshelf 1,80 m high", Size(1.8, "height")),
        ("a sofa about 2.2 m wide", Size(2.2, "width")),
        ("a 1/2 m vase", Size(0.5)),
        ("a 5 1/2 foot bear", Size(1.6764)),
        ("a 1,200 mm wide desk", Size(1.2, "width")),
        ("a table 2 m x 90 cm", Size(2)),
        ("a rug 200 cm by 1 m", Size(2)),
        ("a vase with a 30 cm height", Size(0.3, "height")),
        ("a 6 ft. tall knight", Size(1.8288, "height")),
        ("a robot .5 m tall", Size(0.5, "height")),
        ("a 1m80 tall knight", Size(1.8, "height")),
        ("a thirty foot tall tree", Size(9.144, "height")),
        ("a six foot bear", Size(1.8288)),
        ("a tree 100 feet", Size(30.48)),
        ("a chair height=2m", Size(2, "height")),
    ],
)
def test_a_stated_size_is_read_and_says_nothing_of_the_shape(prompt, size):
    words = parse(prompt)
    assert words.size == pytest.approx(size)
    assert (words.left_out, words.notes) == ((), ())
    assert words.shape == ("round" if "round" in prompt else "")


@pytest.mark.parametrize(
    "prompt",
    [
        *("a 9mm pistol", "a 35mm camera", "a 5 kg dumbbell", "a door 5 cm thick"),
        *("a sword with a 20 cm grip", "a mug 0.1 mm tall", "a 10 year old dog"),
        *("a castle on a 10 m high hill", "a house with a door 2 m tall"),
    ],
)
def test_what_is_no_size_of_the_thing_is_left_out_and_said(prompt):
    words = parse(prompt)
    assert words.size is None
    assert words.weather == ()  # a dog of ten years is not worn
    (measure,) = [word for word in words.left_out if word[0].isdigit()]
    assert measure in words.notes[-1]


@pytest.mark.parametrize(
    "prompt",
    [
        "a sofa with 4 feet",
        "a 2 in 1 laptop",
        "a 12 in 1 tool",
        "a 1920s car",
        "a m4 rifle",
        "a 4k photo",
    ],
)
def test_numbers_without_a_unit_measure_nothing(prompt):
    text, sizes, others = set_apart(prompt)
    assert (text, sizes, others) == (prompt, [], [])


def test_an_age_in_words_makes_nothing_worn():
    words = parse("a two-year-old horse")
    assert (words.left_out, words.weather, words.size) == (("two-year-old",), (), None)


@pytest.mark.parametrize("prompt", ['a sign saying "5"', 'a sign of "apollo 13"', "a crate '5'"])
def test_what_is_quoted_is_no_size(prompt):
    assert parse(prompt).size is None


def test_legs_behind_feet_are_no_inches():
    words = parse("a 3 foot 3 legged stool")
    assert (words.size, words.part) == (Size(0.9144), "three legs")


@pytest.mark.parametrize("end", [" m tall", "/7 m", "' 2\"", " x 2 m"])
def test_a_number_beyond_all_measure_is_left_out(end):
    words = parse(f"a robot {'9' * 900}{end}")
    assert words.size is None
    assert words.left_out[0].startswith("999")


@pytest.mark.parametrize("text", ["1" + " x 1" * 400, "1" + (" " * 60 + "x 1") * 25])
def test_a_long_row_of_numbers_is_read_at_once(text):
    """It took twice as long for each number more: a blank could belong to a unit or not."""
    assert set_apart(f"a grid of {text}")[1:] == ([], [])


def test_the_first_of_two_sizes_counts():
    words = parse("a door, 2 m tall 90 cm wide, dark green")
    assert words.size == Size(2, "height")
    assert words.notes == ("0.9 m: left out, as one size is taken.",)
    assert words.color == "dark green"


def test_the_report_has_the_side_that_is_stated():
    found = understood("a 5 m tall giraffe")
    assert (found["size_m"], found["side"]) == (5, "height")
    assert understood("a red chair")["side"] == "length"


@pytest.mark.parametrize(
    ("prompt", "longest"),
    [
        ("a car 2 m tall", 8),
        ("a car 2 m wide", 4),
        ("a car, 2 m deep", 2),
        ("a car 2 m across", 2),
        ("a car 2 m long", 2),
        ("a car", 4.2),
        ("Two unknown gizmos, 2 M tall", 8),  # of a prompt for other models too
    ],
)
def test_the_stated_side_of_what_is_made_is_so_long(prompt, longest, tmp_path):
    box = torch.tensor([[0.0, 0, 0], [2, 4, 1]])
    assert longest_side(prompt, (2, 4, 1)) == pytest.approx(longest)
    run = RunFolder.create(tmp_path / "words", Job(prompt=prompt))
    assert size_of(run, box) == pytest.approx(longest)
    own = RunFolder.create(tmp_path / "own", Job(prompt=prompt, size_m=0.25))
    assert size_of(own, box) == 0.25
    run.size_m = 1.5  # with what it is on
    assert size_of(run, box) == 1.5


@pytest.mark.parametrize(("prompt", "metres"), [("vase 120mm", 0.12), ("a 40 mm cube", 0.04)])
def test_millimetres_are_a_size_of_what_has_no_calibre(prompt, metres):
    assert parse(prompt).size == Size(metres)
