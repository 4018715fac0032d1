"""Many of a shape all over a thing: "a mug with hearts"."""

import pytest
import torch

from core.geometry.parts.assembly import KnownParts
from core.geometry.parts.forms import Forms
from core.guidance.builtin.markings.emblems.drawn_emblem import has_same_hue
from core.guidance.builtin.markings.emblems.scattered import APART, FEWEST, HALF, scattered_on
from core.guidance.builtin.markings.emblems.windows import surface_places
from core.guidance.builtin.words.vocabulary import parse
from core.tests.drawn_things import shipped_prior

SIDE = 0.6


@pytest.fixture(scope="module")
def cube():
    """A cube as the one part of a thing."""
    return KnownParts(
        lambda points: (points.abs() - SIDE).amax(1, keepdim=True),
        Forms((1.0,), ((0.0, 0.0, 0.0),)),
    )


@pytest.mark.parametrize(
    ("prompt", "drawn"),
    [
        ("a mug with hearts", ["hearts"]),
        ("a mug with yellow stars on it", ["yellow stars"]),
        ("a teapot with little blue flowers on it", ["blue flowers"]),
        ("a vase with blue flowers on it", ["blue flowers"]),
        ("a floral armchair", ["flowers"]),
        ("a teapot with a floral pattern", ["flowers"]),
        ("a shirt with a heart pattern", ["hearts"]),
        ("an umbrella covered in hearts", ["hearts"]),
        ("a race car with flames on the side", ["flames"]),
        ("a blue mug with white stars and a red heart", ["white stars", "red heart"]),
        ("a vase with blue flowers", []),  # they are in it
        ("a mug with a heart", ["heart"]),
        ("a candle with a flame", []),  # its own
        ("a wizard hat with yellow stars", []),
        ("a green dress with polka dots", []),  # a pattern
        ("a basket of stars", []),
        ("two hearts", []),
        ("a dress with stars on its sleeves", ["stars"]),
        ("a mug with heart decals", ["hearts"]),
        ("a mug with flowers in it", []),
        ("a table with skulls on it", []),
        ("a cake with hearts on top", []),
        ("a girl with a flower and a hat", []),
        ("a house in flames", []),
        ("a horse with flames for a mane", []),
        ("a dragon with flames coming out of its mouth", []),
    ],
)
def test_what_is_drawn_all_over(prompt, drawn):
    assert [str(one) for one in parse(prompt).emblems] == drawn


def test_what_is_drawn_all_over_is_no_other_thing():
    assert parse("a dog with heart patterned bandana").noun == "dog"
    assert parse("a sofa with floral cushions").noun == "sofa"
    assert parse("a mug with blue flowers on it").companions == ()
    assert parse("a vase with blue flowers").companions[0].words.noun == "flower"


def test_the_shapes_are_upright_apart_and_on_every_side(cube):
    found = scattered_on(cube, [0])
    assert found is not None and len(found.middles) >= 3 * FEWEST
    assert float(torch.pdist(found.middles).min()) >= APART * found.half
    sides = (found.middles.abs() > SIDE - 1e-3) * found.middles.sign()
    assert len({tuple(side) for side in sides.int().tolist()}) == 6
    standing = found.outward[:, 2].abs() < 0.5
    assert (found.up[standing, 2] > 0.9).all()
    frames = torch.stack([found.right, found.up, found.outward], 1)
    assert torch.allclose(torch.linalg.det(frames), torch.ones(len(frames)), atol=1e-4)


def test_a_shape_is_where_it_is_and_nowhere_behind_it(cube):
    found = scattered_on(cube, [0])
    assert found is not None
    assert (found.margin(found.middles, "circle") > 0).all()
    behind = found.middles - 2 * found.half * found.outward
    assert (found.margin(behind, "circle") < 0).all()
    beside = found.middles + 1.4 * found.half * found.right
    assert (found.margin(beside, "circle") < 0).all()


def test_they_are_on_both_sides_of_a_thin_wall():
    wall = KnownParts(
        lambda points: (points.abs() - torch.tensor([0.6, 0.02, 0.6])).amax(1, keepdim=True),
        Forms((1.0,), ((0.0, 0.0, 0.0),)),
    )
    found = scattered_on(wall, [0])
    assert found is not None and len(found.middles) >= FEWEST
    assert {float(side) for side in found.outward[:, 1].sign()} >= {-1.0, 1.0}
    assert found.half == pytest.approx(HALF * 1.2, rel=0.05)  # no smaller for what is behind


def test_a_part_that_is_not_asked_for_has_none(cube):
    assert scattered_on(cube, [3]) is None


def test_a_mugs_hearts_are_outside_and_do_not_show_through_its_wall():
    prompted = shipped_prior().prompted("a white mug with red hearts", "").of_object(0)
    found = prompted.painted.emblems[0].scattered
    assert found is not None
    away = (found.middles * found.outward)[:, :2].sum(1)  # from the mug's axis
    outer, inner = away > 0.1, away < -0.1
    assert int(outer.sum()) >= FEWEST
    # On the outer wall behind a heart of the inner one there is none of it.
    behind = found.middles[inner] - 0.07 * found.outward[inner]
    alone = torch.cdist(behind, found.middles[~inner]).amin(1) > 1.5 * found.half
    assert (found.margin(behind[alone], "heart") < 0).all()


def test_blue_flowers_on_what_is_blue_by_nature_are_seen():
    """Of all parts that they lie on."""
    for prompt, stays in (
        ("a teapot with blue flowers", False),
        ("a blue teapot with blue flowers", True),
    ):
        painted = shipped_prior().prompted(prompt, "").of_object(0).painted
        on = [painted.paints[part] for part in painted.emblems[0].over]
        assert on
        assert any(has_same_hue(one.color, painted.emblems[0].paint.color) for one in on) is stays


def test_hearts_on_a_mug_are_an_area_of_their_own():
    prompted = shipped_prior().prompted("a white mug with red hearts", "").of_object(0)
    fields = prompted.area_fields()
    places, _, _ = surface_places(prompted.parts())
    points = torch.from_numpy(places[::50]).float()
    area = fields.near(points)[1].argmax(1)
    share = float((area == len(fields.each) - 1).float().mean())
    assert 0.02 < share < 0.25
    (low, high) = fields.each[-1].ranges.color
    assert low[0] > max(high[1:]), "red"
