"""Paint: every part has a colour, words change the parts they are about, and light is kept."""

import colorsys

import pytest
import torch

from core.ops import linear_to_srgb
from core.prior.colored import Painter
from core.prior.data import NOUNS, make
from core.prior.families import FAMILIES, Draw
from core.prior.palette import (
    COLOR_VALUES,
    FINISHES,
    MAIN,
    NATURE,
    PATTERNS,
    coat,
    paint,
    part_names,
)
from core.prior.vocabulary import COLORS, MATERIALS


def _draw(seed: int = 0) -> Draw:
    return Draw(torch.Generator().manual_seed(seed))


def test_all_words_and_all_parts_have_paint():
    assert list(COLOR_VALUES) == list(COLORS)
    assert list(FINISHES) == ["", *MATERIALS]
    for noun in FAMILIES:
        assert set(NATURE[noun]) == set(part_names(noun))
        assert set(MAIN.get(noun, ())) <= set(part_names(noun))


def test_a_colour_word_paints_the_main_parts_only():
    names = part_names("snowman")
    blue = coat("snowman", "blue", "", _draw())
    body, nose = (blue.color[names.index(part)] for part in ("body", "nose"))
    assert body.argmax() == 2
    assert body[2] > 3 * body[0]
    assert nose.argmax() == 0
    assert nose[0] > 2 * nose[2]


def test_a_metal_is_a_metal_and_a_wood_has_grain():
    golden = coat("ball", "", "golden", _draw())
    assert golden.metallic.item() == 1
    assert golden.color[0, 0] > golden.color[0, 2] * 2
    wooden = coat("ball", "red", "wooden", _draw())
    assert PATTERNS[wooden.pattern[0]] == "grain"
    assert wooden.metallic.item() == 0
    assert wooden.color[0, 0] > 3 * wooden.color[0, 1]


@pytest.mark.parametrize("color", COLORS)
def test_jitter_stays_within_the_word(color):
    """No draw is nearer to another colour word than to its own."""
    values = torch.tensor([COLOR_VALUES[name] for name in COLORS])
    for seed in range(20):
        drawn = coat("ball", color, "", _draw(seed)).color[0]
        assert list(COLORS)[int((values - drawn).norm(dim=1).argmin())] == color


def test_patterns_repaint_only_their_own_parts():
    mushroom = coat("mushroom", "", "", _draw())
    names = part_names("mushroom")
    up = torch.tensor([[0.0, 0.0, 1.0]]).expand(2, 3)
    part = torch.tensor([names.index("cap"), names.index("stem")])
    kd, roughness, metallic = paint(mushroom, part, torch.zeros(2, 3), up)
    assert kd[0].min() > 0.7  # a white spot on top of the cap
    torch.testing.assert_close(linear_to_srgb(kd[1]), mushroom.color[part[1]], atol=1e-5, rtol=0)
    assert roughness.shape == metallic.shape == (2, 1)


def test_a_painted_picture_has_the_colour_of_its_word_and_nothing_around():
    samples = make(11, 6)
    painter = Painter()
    index = torch.arange(len(samples))
    color = torch.full((len(samples),), 1 + list(COLORS).index("green"))
    x = painter.pictures(samples, index, color, torch.zeros_like(color), _draw())
    assert x.shape == (len(samples), 4, 64, 64)
    coverage = samples.coverage.float() / 255
    torch.testing.assert_close(x[:, 3:], 2 * coverage - 1)
    assert (x[:, :3].abs() * (coverage == 0)).max() == 0
    for row in range(0, len(samples), 4):
        noun = NOUNS[int(samples.noun[row])]
        main = torch.tensor([part in MAIN.get(noun, part_names(noun)) for part in part_names(noun)])
        seen = (coverage[row, 0] == 1) & main[samples.part[row].long().clamp_min(0)]
        if seen.sum() > 20:
            hue, _, _ = colorsys.rgb_to_hsv(*(x[row, :3, seen].mean(1) * 0.5 + 0.5).tolist())
            assert 0.25 < hue < 0.45, noun
