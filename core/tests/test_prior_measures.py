"""Sizes that a prompt states, and the size of what is made then."""

import pytest
import torch

from core.guidance.builtin.measures import Size, set_apart
from core.guidance.builtin.physical import longest_side
from core.guidance.builtin.vocabulary import parse, understood
from core.io.job import Job
from core.stages.preview import size_of


@pytest.mark.parametrize(
    ("prompt", "size"),
    [
        ("a giraffe 5 m tall", Size(5, "height")),
        ("a traffic cone 75 cm", Size(0.75)),
        ("a shipping container 20ft, blue", Size(6.096)),
        ("a round rug 1.5 m across", Size(1.5, "diameter")),
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
    ],
)
def test_what_is_no_size_of_the_thing_is_left_out_and_said(prompt):
    words = parse(prompt)
    assert words.size is None
    assert words.weather == ()  # a dog of ten years is not worn
    (measure,) = [word for word in words.left_out if word[0].isdigit()]
    assert measure in words.notes[-1]


@pytest.mark.parametrize(
    "prompt", ["a sofa with 4 feet", "a 2 in 1 laptop", "a 1920s car", "a m4 rifle", "a 4k photo"]
)
def test_numbers_without_a_unit_measure_nothing(prompt):
    text, sizes, others = set_apart(prompt)
    assert (text, sizes, others) == (prompt, [], [])


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
def test_the_stated_side_of_what_is_made_is_so_long(prompt, longest):
    box = torch.tensor([[0.0, 0, 0], [2, 4, 1]])
    assert longest_side(prompt, (2, 4, 1)) == pytest.approx(longest)
    assert size_of(Job(prompt=prompt), box) == pytest.approx(longest)
    assert size_of(Job(prompt=prompt, size_m=0.25), box) == 0.25
