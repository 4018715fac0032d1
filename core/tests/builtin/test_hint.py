"""The hint: what the appearance network is given of the surface, the parts and the words."""

import pytest
import torch

from core.guidance.builtin.hint import CHANNELS, HINT_SLOTS, SURFACE, hint, stencil
from core.guidance.builtin.nouns import NOUNS
from core.guidance.builtin.palette import COLOR_VALUES, FINISHES, looks, painted, swatches
from core.guidance.builtin.part_map import PARTS
from core.guidance.builtin.patterns import (
    BAND,
    PATTERNS,
    RAINBOW,
    RAINBOW_COLORS,
    STRIPE,
    Laid,
    Place,
    axis_of,
)
from core.guidance.builtin.words.grammar.lexicon import SLOTS
from core.guidance.builtin.words.tables.colors import toned
from core.guidance.builtin.words.vocabulary import parse

NAMES = list(SLOTS["pattern"])


def surface_of(points: torch.Tensor, coverage: float = 1.0) -> torch.Tensor:
    """A picture of 20 x 25 of these points (500, 3)."""
    surface = torch.zeros(1, SURFACE, 20, 25)
    surface[:, 3] = 2 * coverage - 1
    surface[:, 4:] = coverage * points.T.view(3, 20, 25)
    return surface


def words_of(prompt: str) -> torch.Tensor:
    return torch.tensor([parse(prompt).indices(HINT_SLOTS)])


def some_points() -> torch.Tensor:
    return 2 * torch.rand(500, 3, generator=torch.Generator().manual_seed(0)) - 1


def all_of(part: int) -> torch.Tensor:
    """A part map in which everything is of one part."""
    parts = torch.zeros(1, PARTS, 20, 25)
    parts[:, part] = 1
    return parts


def laid(prompt: str, part: str) -> torch.Tensor:
    """The colours (500, 4) of a surface that is all of one part, [2 srgb - 1, 1]."""
    words = words_of(prompt)
    noun = list(NOUNS)[int(words[0, 0]) - 1]
    given = hint(surface_of(some_points()), all_of(list(looks(noun)).index(part)), words)
    return given[0, SURFACE : SURFACE + 4].flatten(1).T


def swatch(color: str) -> torch.Tensor:
    return torch.tensor([*(2 * c - 1 for c in COLOR_VALUES[color]), 1.0])


@pytest.mark.parametrize("name", NAMES)
def test_the_stencil_is_where_the_pattern_puts_the_second_colour(name: str):
    points = some_points()
    painted = PATTERNS[name](torch.zeros(500, 3), torch.ones(500, 3), Place(points, points))
    seen = stencil(surface_of(points), [[Laid(name)]])[0, 0].flatten()
    assert torch.equal(seen == 1, painted[:, 0] > 0)
    assert 0.1 < seen.float().mean() < 0.9
    assert not stencil(surface_of(points), [[Laid()]]).any()


@pytest.mark.parametrize(
    ("prompt", "part", "color"),
    [
        ("a red chair", "back", "red"),
        ("a red chair with blue legs", "back", "red"),
        ("a red chair with blue legs", "legs", "blue"),
        ("a blue robot with yellow eyes", "eyes", "yellow"),
        ("a blue robot with yellow eyes", "head", "blue"),
        ("a two-tone red and white chair", "seat", "white"),  # its accent
        ("a two-tone red and white chair", "back", "red"),
    ],
)
def test_a_place_has_the_colour_that_the_words_give_to_its_part(prompt, part, color):
    assert torch.allclose(laid(prompt, part), swatch(color).expand(500, 4))


def test_a_part_of_which_nothing_is_stated_has_its_colour_by_nature():
    eyes = torch.tensor([*(2 * c - 1 for c in looks("robot")["eyes"].color), 1.0])
    assert torch.allclose(laid("a red robot", "eyes"), eyes.expand(500, 4))


def test_a_pattern_is_drawn_on_the_parts_that_it_is_about():
    points = some_points()
    mask = stencil(surface_of(points), [[Laid("striped")]])[0, 0].flatten()[:, None] == 1
    expected = torch.where(mask, swatch("white"), swatch("red"))
    assert torch.allclose(laid("a striped red and white chair", "back"), expected)
    legs = laid("a striped red and white lamp", "foot")
    assert torch.equal(legs, legs[:1].expand(500, 4)), "an accent keeps its nature"


def test_the_hint_is_the_surface_the_colours_and_the_second_swatch():
    surface, words = surface_of(some_points()), words_of("a red and white striped ball")
    given = hint(surface, all_of(0), words)
    assert given.shape == (1, CHANNELS, 20, 25)
    assert torch.equal(given[:, :SURFACE], surface)
    even = swatches(words)[0, 4:, None, None]
    assert torch.equal(given[0, SURFACE + 4 :], even.expand(4, 20, 25))
    none = hint(surface, all_of(0), torch.zeros(1, len(HINT_SLOTS), dtype=torch.long))
    assert (none[:, SURFACE:] == 0).all(), "without words nothing is known"


def test_between_two_parts_the_colour_is_between_theirs():
    parts = (all_of(0) + 3 * all_of(2)) / 4
    given = hint(surface_of(some_points()), parts, words_of("a red chair with blue legs"))
    mixed = given[0, SURFACE : SURFACE + 4].flatten(1).T
    seat, legs = laid("a red chair with blue legs", "seat"), swatch("blue")
    assert torch.allclose(mixed, 0.25 * seat + 0.75 * legs, atol=1e-6)


def test_each_picture_of_a_batch_has_its_own_pattern_or_none():
    surface = surface_of(some_points())
    patterns = [[Laid(name)] for name in ("", "spotted", "striped", "spotted")]
    seen = stencil(surface.expand(4, -1, -1, -1), patterns)
    for k, pattern in enumerate(patterns):
        assert torch.equal(seen[k : k + 1], stencil(surface, [pattern]))
    assert not torch.equal(seen[1], seen[2])


def test_two_parts_of_one_picture_have_each_their_pattern():
    surface = surface_of(some_points())
    laid = [Laid("striped"), Laid("striped", 0), Laid("spotted"), Laid()]
    seen = stencil(surface, [laid])[0]
    assert len(seen) == len(laid)
    for k, one in enumerate(laid):
        assert torch.equal(seen[k], stencil(surface, [[one]])[0, 0])
    x = surface[0, 4] > STRIPE / 2
    assert seen[1][x & (surface[0, 4] < STRIPE)].unique().numel() == 1, "upright along x"


@pytest.mark.parametrize(
    ("extent", "axis"),
    [
        ((1.6, 1.0, 0.3), 0),  # an awning, a rug
        ((0.5, 1.6, 0.4), 1),
        ((0.3, 0.3, 1.4), 2),  # a mast
        ((1.6, 1.0, 1.2), 2),  # a house's wall: level, as before
        ((0.5, 0.4, 0.4), 2),  # a cup: no side is much longer
        ((0.0, 0.0, 0.0), 2),  # a part that is not there
    ],
)
def test_stripes_follow_one_another_along_what_lies(extent, axis):
    assert axis_of(extent) == axis


def test_a_part_that_lies_has_its_stripes_across_it_in_the_hint_too():
    words, row = parse("a striped red and white bench"), words_of("a striped red and white bench")
    points = some_points()
    axes = tuple(0 for _ in looks("bench"))
    given = hint(surface_of(points), all_of(0), row, [words], axes)
    mask = stencil(surface_of(points), [[Laid("striped", 0)]])[0, 0].flatten()[:, None] == 1
    colors = given[0, SURFACE : SURFACE + 4].flatten(1).T
    assert torch.allclose(colors, torch.where(mask, swatch("white"), swatch("red")))


@pytest.mark.parametrize(
    ("prompt", "part", "many"),
    [
        ("a rainbow unicorn", "body", True),
        ("a rainbow unicorn", "eyes", False),
        ("a unicorn with a rainbow mane", "mane", True),
        ("a unicorn with a rainbow mane", "body", False),
        ("a sofa with rainbow stripes", "cushion", True),
        ("a red sofa with rainbow stripes", "cushion", True),
        ("a rainbow sofa with red dots", "cushion", False),  # what is stated besides
    ],
)
def test_a_rainbow_has_all_its_colours_one_after_another(prompt, part, many):
    words, points = parse(prompt), some_points()
    at = list(looks(words.noun)).index(part)
    given = hint(surface_of(points), all_of(at), words_of(prompt), [words])
    colors = given[0, SURFACE : SURFACE + 3].flatten(1).T / 2 + 0.5
    bands = torch.tensor(RAINBOW_COLORS)
    away = torch.cdist(colors, bands)
    assert bool((away.amin(0) < 1e-3).all()) is many
    if many:
        assert (away.amin(1) < 1e-3).all()
        band = (-points[:, 2] / BAND).floor().long() % len(bands)  # red is the highest
        assert torch.equal(away.argmin(1), band)


@pytest.mark.parametrize(
    ("prompt", "part", "tone"),
    [
        ("a pastel rainbow unicorn", "body", "pastel"),
        ("a multi-coloured unicorn", "body", ""),
        ("a sofa with white and rainbow striped cushions", "cushion", ""),
        ("a unicorn under a rainbow", "body", None),
        ("a house with a rainbow above it", "walls", None),
    ],
)
def test_a_rainbow_has_a_tone_and_one_that_stands_by_itself_is_another_thing(prompt, part, tone):
    words = parse(prompt)
    (found,) = (one for one in painted(words.noun, words) if one.name == part)
    assert (found.pattern == RAINBOW) is (tone is not None)
    if tone:
        assert found.colors()[0] == toned(RAINBOW_COLORS[0], tone)


def test_a_rainbow_lies_along_what_lies():
    points = some_points()
    along = stencil(surface_of(points), [[Laid(RAINBOW, 0)]])[0, 0].flatten()
    assert torch.equal(along, (-points[:, 0] / BAND).floor().long() % 6)


def test_a_pixel_that_is_covered_in_part_has_the_same_pattern_and_an_empty_one_none():
    points = some_points()
    laid = [[Laid("striped")]]
    whole, part, empty = (stencil(surface_of(points, o), laid) for o in (1.0, 0.4, 0.0))
    assert (part == whole).float().mean() > 0.99  # but for rounding
    assert not empty.any()


def test_parts_beyond_the_one_that_the_rows_can_say_are_in_the_hint():
    prompt = "a red chair with blue legs and a wooden seat"
    words, row = parse(prompt), words_of(prompt)
    seat = list(looks("chair")).index("seat")
    told = hint(surface_of(some_points()), all_of(seat), row, [words])
    wood = torch.tensor(FINISHES["wooden"].color)
    covered = told[0, 3] > -1
    for channel, value in zip(told[0, 7:10], 2 * wood - 1, strict=True):
        torch.testing.assert_close(channel[covered], value.expand(int(covered.sum())))
    alone = hint(surface_of(some_points()), all_of(seat), row)
    assert not torch.allclose(told[:, 7:10], alone[:, 7:10])
