"""What fills an open vessel, in words and in form."""

import pytest
import torch

from core.geometry.parts.assembly import assembled
from core.guidance.builtin.composition.composed import UNFIT, Composed
from core.guidance.builtin.words.vocabulary import parse
from core.tests.drawn_things import body, composed, shipped_prior


@pytest.mark.parametrize(
    ("prompt", "thing", "color"),
    [
        ("a mug of beer", "cylinder", "amber"),
        ("a bucket filled with murky water", "cylinder", "azure"),
        ("a bowl of tomato soup", "cylinder", "red"),
        ("a bucket with blue paint in it", "cylinder", "blue"),
        ("a mug of hot black coffee", "cylinder", "coffee brown"),
        ("a wheelbarrow full of dirt", "ball", "umber"),
        ("a bowl of rice", "ball", "ivory"),
    ],
)
def test_what_is_in_a_vessel_is_a_liquid_or_a_heap(prompt, thing, color):
    words = parse(prompt)
    (one,) = words.companions
    assert (one.relation, one.words.noun, words.left_out) == ("fills", thing, ())
    assert (one.words.color_form or one.words.color) == color


@pytest.mark.parametrize(
    "prompt",
    ["a mug with a heart", "a crate of sand", "a teacup of tea", "a bowl with a blue rim"],
)
def test_what_is_closed_or_has_its_own_is_not_filled(prompt):
    words = parse(prompt, ignore_unknown=True)
    assert not any(one.relation == "fills" for one in words.companions)


def test_the_filling_has_its_own_colour_and_the_vessel_its_own():
    words = parse("a red mug full of blue paint with a green handle")
    (paint,) = words.companions
    assert (words.color, words.second, words.target) == ("red", "green", "handle")
    assert paint.words.color == "blue"


def test_a_spoon_comes_with_the_soup():
    words = parse("a bowl of soup with a spoon")
    assert [one.relation for one in words.companions] == ["fills", "bears"]


def test_beer_is_level_inside_the_mug_and_one_with_it():
    made = composed("a mug of beer").made
    assert made
    mug, beer = (
        (thing.parts(), place) for thing, (place,) in zip(made.things, made.places, strict=True)
    )
    walls = torch.cat([mug[1].out(one.verts.float()) for one in mug[0].components])
    (disc,) = beer[0].components
    level = beer[1].out(disc.verts)
    low, high = level.amin(0), level.amax(0)
    assert float(high[2] - low[2]) < 0.1 * float(high[0] - low[0])
    body_verts = walls[walls[:, 0] < high[0] + 0.1]
    assert float(low[2]) > float(body_verts[:, 2].min()) + 0.3
    assert float(high[2]) < float(body_verts[:, 2].max()) - 0.03
    whole = assembled(composed("a mug of beer").parts(), True, 0.05, lambda _: None)
    assert whole is not None
    faces = whole[1]
    edges = torch.cat([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]]).sort(1).values
    assert (edges.unique(dim=0, return_counts=True)[1] == 2).all()


def test_rice_is_heaped_above_the_rim_by_less_than_its_width():
    made = composed("a bowl of rice").made
    assert made
    bowl, rice = (
        place.out(torch.cat([one.verts.float() for one in thing.parts().components]))
        for thing, (place,) in zip(made.things, made.places, strict=True)
    )
    assert (
        bowl[:, 2].max()
        < rice[:, 2].max()
        < bowl[:, 2].max() + 0.5 * (rice[:, 0].max() - rice[:, 0].min())
    )
    assert rice[:, 0].max() < bowl[:, 0].max()


@pytest.mark.slow
def test_two_mugs_have_each_their_own():
    made = composed("two mugs of coffee").made
    assert made
    mugs, coffee = made.places
    assert len(mugs) == len(coffee) == 2
    away = [(a.shift - b.shift)[:2].norm() for a, b in zip(mugs, coffee, strict=True)]
    assert max(away) < 0.5 * float((mugs[0].shift - mugs[1].shift).norm())


def test_a_closed_vessel_stays_empty_and_that_is_noted(monkeypatch):
    from core.guidance.builtin.composition import filling

    monkeypatch.setattr(filling, "OPEN", 9.0)
    drawn = shipped_prior().prompted("a mug of milk", "").of_object(0)
    assert isinstance(drawn, Composed) and drawn.made
    assert len(drawn.made.things) == 1
    assert f"filling: {UNFIT}" in drawn.left_out()


def test_the_outline_is_within_the_wall():
    from core.guidance.builtin.composition.filling import LEVEL, _outline

    mug = body("a mug")
    found = _outline(mug, LEVEL)
    assert found
    loop, level = found
    rim = mug.without("handle")
    near = rim[(rim[:, 2] - level).abs() < 0.05]
    reach = float((near[:, :2] - rim.mean(0)[:2]).norm(dim=1).max())
    away = torch.from_numpy(loop).float() - rim.mean(0)[:2]
    assert float(away.norm(dim=1).max()) < reach
    assert float(away.norm(dim=1).min()) > 0.6 * reach
