"""The hint: what the appearance network is given of the surface and of the words."""

import pytest
import torch

from core.guidance.builtin.hint import CHANNELS, SURFACE, hint, stencil
from core.guidance.builtin.lexicon import SLOTS
from core.guidance.builtin.palette import swatches
from core.guidance.builtin.patterns import PATTERNS, Place
from core.guidance.builtin.vocabulary import parse

NAMES = list(SLOTS["pattern"])


def surface_of(points: torch.Tensor, coverage: float = 1.0) -> torch.Tensor:
    """A picture of 20 x 25 of these points (500, 3)."""
    surface = torch.zeros(1, SURFACE, 20, 25)
    surface[:, 3] = 2 * coverage - 1
    surface[:, 4:] = coverage * points.T.view(3, 20, 25)
    return surface


def words_of(prompt: str) -> torch.Tensor:
    slots = ("noun", "color", "material", "pattern", "second")
    return torch.tensor([parse(prompt).indices(slots)])


def some_points() -> torch.Tensor:
    return 2 * torch.rand(500, 3, generator=torch.Generator().manual_seed(0)) - 1


def laid(prompt: str) -> torch.Tensor:
    return stencil(surface_of(some_points()), words_of(prompt))[0, 0].flatten()


@pytest.mark.parametrize("name", NAMES)
def test_the_stencil_is_where_the_pattern_puts_the_second_colour(name: str):
    points = some_points()
    painted = PATTERNS[name](torch.zeros(500, 3), torch.ones(500, 3), Place(points, points))
    seen = laid(f"a red and white {name} ball")
    assert torch.equal(seen, painted[:, 0] > 0)
    assert 0.1 < seen.float().mean() < 0.9


def test_no_stencil_where_no_pattern_is_stated_or_it_is_for_accents_alone():
    assert not laid("a red ball").any()
    assert not laid("a striped ball").any()  # in which colours?
    assert laid("a red striped ball").any()  # and white, as it is painted
    assert not laid("a two-tone red and white chair").any()  # its seat is the accent
    assert laid("a striped red and white chair").any()


def test_the_first_swatch_is_laid_as_the_pattern_has_it_and_the_second_is_even():
    points, words = some_points(), words_of("a red and white striped ball")
    surface = surface_of(points)[:, :, :20, :20]
    given = hint(surface, words)
    assert given.shape == (1, CHANNELS, 20, 20)
    assert torch.equal(given[:, :SURFACE], surface)
    red, white = swatches(words)[0].split(4)
    mask = stencil(surface, words)[0]
    expected = torch.where(mask, white[:, None, None], red[:, None, None])
    assert torch.equal(given[0, SURFACE : SURFACE + 4], expected)
    assert torch.equal(given[0, SURFACE + 4 :], white[:, None, None].expand(4, 20, 20))


def test_each_picture_of_a_batch_has_its_own_pattern_or_none():
    surface = surface_of(some_points())
    prompts = ("a red ball", "a spotted red ball", "a striped red ball", "a spotted red ball")
    words = torch.cat([words_of(prompt) for prompt in prompts])
    seen = stencil(surface.expand(4, -1, -1, -1), words)
    for k in range(4):
        assert torch.equal(seen[k : k + 1], stencil(surface, words[k : k + 1]))
    assert not torch.equal(seen[1], seen[2])


def test_a_pixel_that_is_covered_in_part_has_the_same_pattern_and_an_empty_one_none():
    points, words = some_points(), words_of("a striped red ball")
    whole, part, empty = (stencil(surface_of(points, o), words) for o in (1.0, 0.4, 0.0))
    assert (part == whole).float().mean() > 0.99  # but for rounding
    assert not empty.any()
