import pytest
import torch

from core.camera import Cameras
from core.errors import UserError
from core.guidance.stable_diffusion.prompts import (
    MAX_CHARACTERS,
    VIEWS,
    PromptCutWarning,
    clean_prompt,
    fit_tokens,
    opposing_weights,
    require_prompt,
    view_weights,
    view_words,
    warn_cut,
)


def view_at(azimuth_deg, elevation_deg=0.0):
    shares = view_weights(Cameras.orbit([azimuth_deg], [elevation_deg]))[0]
    assert sorted(shares.tolist()) == [0, 0, 0, 0, 1]
    return VIEWS[int(shares.argmax())]


@pytest.mark.parametrize(
    ("view", "azimuths_deg"),
    [
        ("front", [0.0, 45.0, -45.0, 315.0, 360.0, 740.0]),
        ("side", [46.0, 90.0, 134.0, -134.0, 270.0]),
        ("back", [135.0, 180.0, -136.0, 225.0]),
    ],
)
def test_the_view_turns_at_the_diagonals(view, azimuths_deg):
    assert {view_at(azimuth_deg) for azimuth_deg in azimuths_deg} == {view}


@pytest.mark.parametrize("azimuth_deg", [0.0, 90.0, 180.0])
def test_the_view_from_above_begins_at_60_degrees(azimuth_deg):
    around = view_at(azimuth_deg)
    assert view_at(azimuth_deg, 59.0) == view_at(azimuth_deg, -59.0) == around
    assert view_at(azimuth_deg, 61.0) == view_at(azimuth_deg, 90.0) == "overhead"
    assert view_at(azimuth_deg, -61.0) == "bottom"


def test_soft_shares_are_continuous_sum_to_one_and_agree_with_the_hard_ones():
    azimuth = torch.arange(-360, 360, 0.5)
    for elevation in (-80.0, 0.0, 58.0, 62.0, 89.0):
        cameras = Cameras.orbit(azimuth, torch.tensor(elevation))
        soft, hard = view_weights(cameras, soft=True), view_weights(cameras)
        torch.testing.assert_close(soft.sum(1), torch.ones(len(azimuth)))
        assert soft.min() >= 0
        # 0.5 degrees of 90 to go from one view to the next
        assert (soft[1:] - soft[:-1]).abs().max() < 0.5 / 90 + 1e-4
        if elevation == 0:
            assert soft.gather(1, hard.argmax(1, keepdim=True)).min() >= 0.5 - 1e-4
    rise = view_weights(Cameras.orbit([0.0] * 91, torch.arange(91.0)), soft=True)[:, 3]
    assert rise[45] == 0
    assert rise[60] == pytest.approx(0.5, abs=1e-5)
    assert rise[75] == pytest.approx(1)


def test_the_middle_between_two_views_is_half_of_each():
    shares = view_weights(Cameras.orbit([45.0, 112.5], [0.0, 0.0]), soft=True)
    expected = torch.tensor([[0.5, 0.5, 0, 0, 0], [0, 0.75, 0.25, 0, 0]])
    torch.testing.assert_close(shares, expected)


def test_perp_neg_opposes_the_sides_that_are_not_seen():
    shares = view_weights(Cameras.orbit([180.0, 0.0], [0.0, 90.0]))
    expected = torch.tensor([[1.0, 1, 0, 0, 0], [1, 1, 1, 0, 0]])
    torch.testing.assert_close(opposing_weights(shares), expected)


def test_view_words_follow_the_prompt():
    assert "a mug" + view_words("back") == "a mug, back view"


@pytest.mark.parametrize("text", ["", "   ", "\n\t", "\u200b \u00a0", "...", "—!"])
def test_a_prompt_without_a_word_is_refused(text):
    with pytest.raises(UserError, match="prompt") as error:
        require_prompt(text)
    assert "a wooden chair" in error.value.fix
    assert error.value.status == 2


@pytest.mark.parametrize("text", ["ein grüner Krug", "一把红色的椅子", "🦊", "7", "стул", "كرسي"])
def test_any_language_is_text(text):
    assert require_prompt(text) == text


def test_white_space_becomes_single_spaces_and_letters_are_composed():
    assert clean_prompt("  a red\n\twooden\r\nchair ") == "a red wooden chair"
    assert clean_prompt("cafe\u0301") == "caf\u00e9"
    assert clean_prompt("") == ""


@pytest.mark.parametrize("text", ["a\x00chair", "a \x1b[31mred chair", "\udcff", "\ue000", "\x7f"])
def test_control_characters_are_refused_by_number(text):
    with pytest.raises(UserError, match=r"U\+(0000|001B|DCFF|E000|007F)"):
        clean_prompt(text)


def test_a_very_long_prompt_is_refused_with_its_length():
    assert len(clean_prompt("x" * MAX_CHARACTERS)) == MAX_CHARACTERS
    with pytest.raises(UserError, match="negative prompt has 5000 characters"):
        clean_prompt("x" * 5000, "negative prompt")


@pytest.mark.parametrize("count", [0, 1, 3, 4, 5, 9])
def test_the_prompt_gives_way_to_the_view_words(count):
    prompt = list(range(10, 10 + count))
    tokens, cut = fit_tokens(prompt, [7, 8], 8, bos=1, eos=2, pad=0)
    kept = prompt[:4]
    assert tokens == [1, *kept, 7, 8, 2] + [0] * (4 - len(kept))
    assert kept + cut == prompt
    assert len(tokens) == 8


def test_the_warning_names_what_is_cut():
    with pytest.warns(PromptCutWarning, match='does not see its end: "on a hill"'):
        warn_cut("on a hill")
