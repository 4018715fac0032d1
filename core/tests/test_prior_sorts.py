"""Sorts of a thing: a round table is another table than a long one; a round cat is a plump one."""

import math

import pytest
import torch

from core.guidance.builtin.guidance import GEOMETRY_SLOTS, load_builtin
from core.guidance.builtin.nouns import NOUNS
from core.guidance.builtin.part_forms import is_round
from core.guidance.builtin.solid import Solid
from core.guidance.builtin.solid_net import KINDS
from core.guidance.builtin.sorts import SORTS, sort_of
from core.guidance.builtin.vocabulary import parse

EACH = [(noun, words) for noun, sorts in SORTS.items() for words in sorts]


@pytest.mark.parametrize(("noun", "words"), EACH)
def test_a_sort_is_of_a_known_thing_and_of_kinds_that_the_network_has_seen(noun, words):
    guidance = load_builtin("cpu")
    assert noun in NOUNS and guidance.solid is not None
    first = KINDS * (guidance.prompted(f"a {noun}", "").words.indices(GEOMETRY_SLOTS)[0] - 1) + 1
    counts = guidance.solid.counts.sum((0, 1))[first : first + KINDS]
    kinds = SORTS[noun][words]
    assert len(set(kinds)) == len(kinds) < KINDS
    assert all(counts[kind] for kind in kinds)
    assert sort_of(noun, f"a {words.split(', ')[0]} one").kinds == kinds


@pytest.mark.parametrize(
    ("prompt", "noun", "said"),
    [
        ("a floor lamp with a white shade and a tripod base", "floor lamp", "tripod"),
        ("retro tv with antenna", "television", "antenna"),
        ("a smart TV", "television", "smart"),
        ("black top hat with a red ribbon", "hat", "top hat"),
        ("a three-tier wedding cake", "cake", "wedding"),
        ("a slice of pizza", "pizza", "slice of"),
        ("a french-door fridge", "refrigerator", "french door"),
    ],
)
def test_what_names_a_sort_is_not_left_out(prompt, noun, said):
    words = parse(prompt)
    assert words.noun == noun and words.kinds == SORTS[noun][_words_of(noun, said)]
    left = {word for form in words.left_out for word in form.split()}
    assert not left & set(said.split())
    assert not any(note.startswith(f"{said}: left out") for note in words.notes)


def _words_of(noun, said):
    return next(words for words in SORTS[noun] if said in words.split(", "))


@pytest.mark.parametrize(
    "prompt",
    [
        "a coffee table that isn't round",
        "a coffee table with round legs",
        "a stool next to a round table",
        "a street lamp, two meters tall",
        "a tv on an old table",
        "a pizza with a piece missing",
        "a window with no wooden shutters",
        "a paintbrush on a wall",
    ],
)
def test_what_is_said_of_another_thing_or_denied_names_no_sort(prompt):
    assert not parse(prompt).kinds


@pytest.mark.parametrize("form", ["round", "rounded", "circular", "circlar"])
def test_every_word_for_round_is_the_round_sort(form):
    words = parse(f"a {form} coffee table")
    assert words.kinds == parse("a round coffee table").kinds and not words.shape


def test_what_is_denied_names_no_sort():
    assert sort_of("television", "a retro tv").kinds
    assert not sort_of("floor lamp", "a floor lamp without a tripod").kinds
    assert not sort_of("window", "a window, no shutters").kinds
    assert not sort_of("floor lamp", "a floor lamp").kinds


@pytest.mark.parametrize("prompt", ["a round cat", "a chubby mug", "a plump pumpkin"])
def test_what_is_plump_swells(prompt):
    assert parse(prompt).shape == "round"


@pytest.mark.parametrize("noun", ["plate", "clock", "ball", "barrel"])
def test_what_is_round_anyway_stays_as_it_is(noun):
    words = parse(f"a round {noun}")
    assert is_round(noun) and not words.shape and not words.left_out


@pytest.mark.parametrize("noun", ["house", "sofa", "car"])
def test_what_is_never_round_is_said_to_be_so(noun):
    words = parse(f"a round {noun}")
    assert not is_round(noun) and not words.shape and not words.kinds
    assert words.left_out == ("round",)
    assert f"round: left out, as a {noun} keeps its own form here." in words.notes


ROUND_SORTS = [(noun, "round") for noun in ("coffee table", "stool")]
OTHERS = [("coffee table", "square"), ("shield", "kite")]


@pytest.mark.parametrize(("noun", "word"), ROUND_SORTS + OTHERS)
def test_a_round_sort_is_round_and_another_is_not_and_nothing_is_stretched(noun, word):
    prompted = load_builtin("cpu").prompted(f"a {word} {noun}", "")
    for seed in range(3):
        solid = prompted.of_object(seed).solid
        assert (_roundness(solid) > 0.9) == (word == "round")
        assert len(set(solid.frame.scale)) == 1 and not solid.swell


def _roundness(solid: Solid) -> float:
    """The fraction of the largest part's surface that stays on it when it is turned about the
    vertical, or about y."""
    verts, _ = solid.mesh
    part = solid.part(verts)
    largest = int(part.bincount().argmax())
    own = verts[part == largest]
    middle, shares = (own.amin(0) + own.amax(0)) / 2, []
    for i, j in ((0, 1), (0, 2)):
        off = []
        for degrees in (37.0, 101.0, 164.0):  # by no symmetry of a square
            c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
            at = own - middle
            at[:, i], at[:, j] = c * at[:, i] - s * at[:, j], s * at[:, i] + c * at[:, j]
            off.append(solid.distances(at + middle)[:, largest].abs() < 0.02)
        shares.append(torch.stack(off).float().mean().item())
    return max(shares)


def test_the_flat_television_is_flat_and_the_old_one_deep():
    guidance = load_builtin("cpu")
    deep, flat = (
        _extent(guidance.prompted(prompt, "").of_object(1).solid)
        for prompt in ("a vintage tv", "a flat screen tv")
    )
    assert deep[1] / deep[0] > 0.5 > 0.45 > flat[1] / flat[0]


def test_a_top_hat_is_taller_than_a_bowler():
    guidance = load_builtin("cpu")
    top, bowler = (
        _extent(guidance.prompted(prompt, "").of_object(1).solid)
        for prompt in ("a top hat", "a bowler hat")
    )
    assert top[2] / top[0] > bowler[2] / bowler[0]


def _extent(solid: Solid) -> list[float]:
    verts, _ = solid.mesh
    return (verts.amax(0) - verts.amin(0)).tolist()
