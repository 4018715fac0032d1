"""Sorts of a thing: a round table is another table than a long one; a round cat is a plump one."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import cache

import pytest
import torch

from core.guidance.builtin.guidance import GEOMETRY_SLOTS, BuiltinGuidance
from core.guidance.builtin.nouns import NOUNS
from core.guidance.builtin.palette import looks
from core.guidance.builtin.part_forms import is_round
from core.guidance.builtin.solid_net import KINDS
from core.guidance.builtin.words.tables.sorts import SORTS, sort_of
from core.guidance.builtin.words.vocabulary import parse
from core.tests.drawn_things import shipped_prior

SEEN = 2  # objects of a kind, at the least
EACH = [(noun, words) for noun, sorts in SORTS.items() for words in sorts]


@pytest.fixture(scope="module")
def guidance() -> BuiltinGuidance:
    return shipped_prior()


@pytest.mark.parametrize(("noun", "words"), EACH)
def test_a_sort_is_of_a_known_thing_and_of_kinds_that_the_network_has_seen(guidance, noun, words):
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
        ("an old fashioned street lamp", "street lamp", "old fashioned"),
        ("black top hat with a red ribbon", "hat", "top hat"),
        ("a three-tier wedding cake", "cake", "wedding"),
        ("a slice of pizza", "pizza", "slice of"),
        ("a spiked wooden club", "club", "spiked"),
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
        "an ottoman next to a round table",
        "a street lamp, two meters tall",
        "a tv on an old table",
        "a pizza with a piece missing",
        "a window with no wooden shutters",
        "a paintbrush on a wall",
        "a club without spikes",
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


@pytest.mark.parametrize("noun", ["plate", "clock", "ball", "barrel", "stool"])
def test_what_is_round_anyway_stays_as_it_is(noun):
    words = parse(f"a round {noun}")
    assert is_round(noun) and not words.shape and not words.left_out


@pytest.mark.parametrize("noun", ["house", "sofa", "car"])
def test_what_is_never_round_is_said_to_be_so(noun):
    words = parse(f"a round {noun}")
    assert not is_round(noun) and not words.shape and not words.kinds
    assert words.left_out == ("round",)
    assert f"round: left out, as a {noun} keeps its own form here." in words.notes


@dataclass(frozen=True)
class Drawn:
    """Where a kind's middle is solid: points of a lattice, and how far these are apart."""

    points: torch.Tensor
    step: float
    handles: torch.Tensor

    def sides(self) -> list[float]:
        return (self.points.amax(0) - self.points.amin(0) + self.step).tolist()

    def tall(self) -> float:
        return self.sides()[2] / self.sides()[0]

    def deep(self) -> float:
        return self.sides()[1] / self.sides()[0]

    def full(self) -> float:
        """Of the box around it."""
        x, y, z = self.sides()
        return len(self.points) * self.step**3 / (x * y * z)

    def between(self, low: float, high: float) -> "Drawn":
        """Of its height."""
        z = self.points[:, 2]
        at = (z - z.amin()) / (z.amax() - z.amin())
        return replace(self, points=self.points[(at >= low) & (at <= high)])

    def tip_flat(self) -> float:
        return -self.between(0.93, 1).deep()

    def spread(self) -> float:
        """How far from its axis it stands, where its legs are."""
        return float(self.between(0.05, 0.2).points[:, :2].norm(dim=1).median())

    def handles_apart(self) -> float:
        """How far from the middle they are, on average."""
        return float(self.handles[:, 0].abs().mean())


# Of a thing's sorts, by one of the words that name it: what its kinds have more of, or less, than
# all others that the training had.
MEASURED: list[tuple[str, str, Callable[[Drawn], float], bool]] = [
    ("hat", "top hat", Drawn.full, True),
    ("hat", "bowler", Drawn.full, False),
    ("television", "modern", Drawn.deep, False),
    ("television", "retro", Drawn.deep, True),
    ("shield", "round", Drawn.full, False),
    ("shield", "kite", Drawn.full, True),
    ("mirror", "oval", Drawn.full, False),
    ("mirror", "square", Drawn.full, True),
    ("refrigerator", "french door", Drawn.handles_apart, False),
    ("refrigerator", "retro", Drawn.handles_apart, True),
    ("cake", "wedding", Drawn.tall, True),
    ("pizza", "slice of", Drawn.full, False),
    ("pizza", "whole", Drawn.full, True),
    ("window", "shutter", Drawn.tall, False),
    ("floor lamp", "tripod", Drawn.spread, True),
    ("coffee table", "round", Drawn.deep, True),
    ("coffee table", "oblong", Drawn.deep, False),
    ("ottoman", "round", Drawn.full, False),
    ("ottoman", "square", Drawn.full, True),
    ("sunglasses", "round", Drawn.full, False),
    ("sunglasses", "square", Drawn.full, True),
    ("clock", "bell", Drawn.tall, True),
    ("clock", "wall", Drawn.tall, False),
    ("street lamp", "double", Drawn.tall, False),
    ("street lamp", "victorian", Drawn.full, True),
    ("street lamp", "modern", Drawn.deep, True),
    ("pillow", "tassel", Drawn.full, False),
    ("screwdriver", "slotted", Drawn.tip_flat, True),
    ("screwdriver", "phillips", Drawn.tip_flat, False),
    ("club", "spiked", Drawn.full, False),
    ("club", "smooth", Drawn.full, True),
    ("paintbrush", "flat", Drawn.full, True),
    ("paintbrush", "artist", Drawn.full, False),
]


@pytest.fixture(scope="module")
def drawn(guidance) -> Callable[[str], dict[int, Drawn]]:
    """Each kind of a noun that the training had, by its number."""
    net, side = guidance.solid, torch.linspace(-0.95, 0.95, 40)
    nodes = torch.stack(torch.meshgrid(side, side, side, indexing="ij"), -1).view(-1, 3)

    @cache
    def of(noun: str) -> dict[int, Drawn]:
        rows = torch.tensor([parse(f"a {noun}").indices(GEOMETRY_SLOTS)])
        first, found = KINDS * (int(rows[0, 0]) - 1) + 1, {}
        handles = [k for k, part in enumerate(looks(noun)) if part == "handles"]
        for kind in range(KINDS):
            if net.counts[..., first + kind].sum() < SEEN:
                continue
            row = torch.cat([rows, torch.tensor([[first + kind]])], 1)
            with torch.no_grad():
                plane = net.triplane(row, torch.zeros(1, net.config.latent))
                parts = torch.cat([net.at(plane, some[None])[0] for some in nodes.split(1 << 15)])
            own = nodes[(parts[:, handles] < 0).any(1)]
            found[kind] = Drawn(nodes[parts.amin(1) < 0], float(side[1] - side[0]), own)
        return found

    return of


def test_every_sort_is_measured():
    measured = {(noun, _words_of(noun, word)) for noun, word, *_ in MEASURED}
    assert measured == set(EACH)


@pytest.mark.parametrize(("noun", "word", "measure", "more"), MEASURED)
def test_a_sort_has_what_its_word_says_and_the_others_have_not(drawn, noun, word, measure, more):
    kinds = SORTS[noun][_words_of(noun, word)]
    values = {kind: measure(one) * (1 if more else -1) for kind, one in drawn(noun).items()}
    own = [values[kind] for kind in kinds]
    others = [value for kind, value in values.items() if kind not in kinds]
    assert min(own) > max(others), values


def test_a_stated_sort_is_drawn_and_nothing_is_stretched(guidance):
    solid = guidance.prompted("a round coffee table", "").of_object(1).solid
    x, y, _ = (solid.mesh[0].amax(0) - solid.mesh[0].amin(0)).tolist()
    assert x == pytest.approx(y, rel=0.03)
    assert len(set(solid.frame.scale)) == 1 and not solid.swell
