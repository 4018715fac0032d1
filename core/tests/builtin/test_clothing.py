"""Clothes as they are worn."""

from functools import cache

import pytest
import torch

from core.geometry.mesh import component_labels
from core.geometry.union import is_solid, union
from core.guidance.builtin.composition.clothes.clothing import Garment, garment
from core.guidance.builtin.composition.clothes.cuts import CUTS, cut
from core.guidance.builtin.composition.clothes.measurements import BARE, Measurements
from core.guidance.builtin.composition.placing.placement import Body
from core.guidance.builtin.palette import looks
from core.guidance.builtin.words.companions.known_as import CLOTHING, WORN
from core.guidance.builtin.words.phrases.slots import Words
from core.tests.drawn_things import body, composed, shipped_prior


@cache
def measured(prompt: str) -> Measurements:
    parts = shipped_prior().prompted(prompt, "").of_object(0).parts()
    assert parts
    return Measurements.of(body(prompt), parts)


@cache
def worn_by(prompt: str, noun: str, material: str = "") -> Garment | None:
    solid = shipped_prior().prompted("a shirt", "").of_object(0).solid
    assert solid
    return garment(Words(noun=noun, material=material), solid, measured(prompt))


def part_of(made: Garment, name: str, points: torch.Tensor) -> torch.Tensor:
    return made.distances(points)[:, made.names.index(name)]


@pytest.mark.slow
def test_all_that_is_cut_may_be_worn_and_has_parts_of_its_noun():
    assert CUTS.keys() == CLOTHING < WORN
    for noun in CUTS:
        for wearer in ("a robot", "a cat"):
            points = body(wearer).verts
            parts = cut(noun, measured(wearer), points)
            assert parts.keys() <= looks(noun).keys(), noun
            assert any((part < 0).any() for part in parts.values()), (noun, wearer)


@pytest.mark.parametrize(
    ("prompt", "stands", "has_legs"),
    [
        pytest.param("a penguin", True, True, marks=pytest.mark.slow),
        ("a robot", True, True),
        ("a cat", False, True),
        pytest.param("a snake", True, False, marks=pytest.mark.slow),
        pytest.param("a shark", False, False, marks=pytest.mark.slow),
        pytest.param("a teddy bear", True, False, marks=pytest.mark.slow),
        pytest.param("a monkey", True, False, marks=pytest.mark.slow),
        pytest.param("an elephant", False, True, marks=pytest.mark.slow),
    ],
)
def test_how_somebody_is_built(prompt: str, stands: bool, has_legs: bool):
    wearer = measured(prompt)
    assert (wearer.stands, wearer.has_legs) == (stands, has_legs)
    assert wearer.low < wearer.crotch < wearer.neck[2] + 0.3
    assert wearer.front < wearer.back


@pytest.mark.parametrize("prompt", ["a cat", "a robot", "a penguin"])
def test_a_shirt_is_around_the_trunk_and_not_around_the_head_and_the_feet(prompt: str):
    made, wearer, points = worn_by(prompt, "shirt"), measured(prompt), body(prompt).verts
    assert made
    outside = made.sdf(points)
    deep = wearer.below_neck(points)
    high = (points[:, 2] - wearer.low) / (body(prompt).box[1, 2] - wearer.low)
    assert (outside[deep < -0.1] > 0).all()
    assert (outside[high < 0.05] > 0).all()
    trunk = (deep > 0.06) & (points[:, 2] > wearer.crotch + 0.06) & (points[:, 0].abs() < 0.15)
    trunk &= points[:, 1] < (wearer.hind - 0.1 if not wearer.stands else wearer.back + 0.03)
    covered = body(prompt).without(*BARE)
    trunk &= torch.cdist(points, covered).amin(1) < 1e-6
    assert trunk.sum() > 50
    assert (outside[trunk] < 0).float().mean() > 0.97


def test_one_garment_lies_over_another():
    points, wearer = body("a robot").verts, measured("a robot")
    out = wearer.skin(points)
    shirt, trousers, jacket = (
        cut(noun, wearer, points)["body"] for noun in ("shirt", "trousers", "jacket")
    )
    # Where nothing but the wearer's surface bounds them.
    bound = {
        name: (one - out + 0.035 + layer).abs() < 1e-4
        for name, one, layer in zip(
            "stj", (shirt, trousers, jacket), (0.008, 0, 0.016), strict=True
        )
    }
    both, under = bound["s"] & bound["t"], bound["j"] & bound["s"]
    assert both.sum() > 20 and (shirt[both] < trousers[both]).all()
    assert under.sum() > 20 and (jacket[under] < shirt[under]).all()


def test_what_has_no_eyes_is_dressed_about_its_own_middle():
    assert abs(float(measured("a cactus").neck[0] - body("a cactus").box.mean(0)[0])) < 1e-6


@pytest.mark.slow
def test_a_tail_goes_through():
    points, wearer = body("a monkey").verts, measured("a monkey")
    made = worn_by("a monkey", "shirt")
    tail = points[points[:, 1] > wearer.back + 0.15]
    assert made and len(tail) > 20
    assert (made.sdf(tail) > 0).all()


@pytest.mark.slow
def test_a_raised_arm_has_a_sleeve_beside_the_head_and_the_head_none():
    drawn = shipped_prior().prompted("a man", "").of_object(1)
    assert drawn.solid
    own = Body.of(drawn.words, drawn.solid)
    wearer = Measurements.of(own, drawn.parts())
    shirt = cut("shirt", wearer, own.verts)["body"]
    above = own.verts[:, 2] > float(wearer.neck[2]) + 0.03
    aside = (own.verts[:, 0] - wearer.neck[0]).abs() / wearer.head.wide
    assert (shirt[above & (aside < 0.5)] > 0).all()
    arm = above & (aside > 0.65) & (own.verts[:, 2] < wearer.raised - 0.03)
    assert arm.sum() > 20 and (shirt[arm] < 0).float().mean() > 0.9


def test_cloth_lies_a_little_outside_of_its_wearer():
    made, wearer = worn_by("a cat", "shirt"), measured("a cat")
    assert made
    out = wearer.skin(made.mesh[0])
    assert 0.02 < float(out.amax()) < 0.08


def test_a_jacket_is_open_below_the_neck_where_a_shirt_is_seen_and_zipped_if_of_leather():
    made, wearer = worn_by("a penguin", "jacket"), measured("a penguin")
    suit = worn_by("a penguin", "jacket", "fabric")
    assert made and suit
    points = made.mesh[0]
    own = made.part(points)
    shirt = points[own == made.names.index("shirt")]
    zipped = points[own == made.names.index("zip")]
    assert len(shirt) and len(zipped)
    assert float(shirt[:, 2].mean()) > float(zipped[:, 2].mean())
    assert (shirt[:, 1] < wearer.back).all() and (
        zipped[:, 1] < (wearer.front + wearer.back) / 2
    ).all()
    assert "zip" not in suit.names


def test_a_dress_is_wider_at_its_foot():
    made = worn_by("a penguin", "dress")
    assert made
    points, low = made.mesh[0], made.mesh[0][:, 2].amin()
    foot, waist = points[points[:, 2] < low + 0.1], points[(points[:, 2] - low - 0.6).abs() < 0.05]
    assert foot[:, 1].amax() - foot[:, 1].amin() > 1.2 * (waist[:, 1].amax() - waist[:, 1].amin())


def test_a_cape_hangs_behind():
    made, wearer = worn_by("a robot", "cape"), measured("a robot")
    assert made
    cloth = part_of(made, "cloth", made.mesh[0]) < 0.01
    points = made.mesh[0][cloth]
    hem = points[points[:, 2] < wearer.crotch]
    middle = hem[(hem[:, 0] - wearer.neck[0]).abs() < 0.1]
    # It is around the back, nowhere before the middle, and folded.
    assert (hem[:, 1] > wearer.neck[1] - 0.05).all() and (middle[:, 1] > wearer.back - 0.1).all()
    assert hem[:, 0].amax() - hem[:, 0].amin() > 1.5 * wearer.wide
    assert float(points[:, 2].amin()) < wearer.crotch - 0.1
    clasp = made.mesh[0][part_of(made, "clasp", made.mesh[0]) < 0.01]
    assert (clasp[:, 1] < wearer.neck[1] + 0.01).all()


@pytest.mark.slow
def test_shoes_are_on_each_foot_and_do_not_fit_a_fish():
    made = worn_by("a robot", "boot")
    assert made
    verts, faces = made.mesh
    assert component_labels(faces, len(verts))[0] == 2
    assert float(verts[:, 2].amax()) < measured("a robot").crotch
    assert worn_by("a shark", "boot") is None


@pytest.mark.slow
def test_of_clothes_that_do_not_fit_the_others_are_worn_and_it_is_reported():
    found = composed("a shark wearing boots and a crown")
    assert [thing.words.noun for thing in found.made.things] == ["shark", "crown"]
    assert "boot: left out, as the thing has no place for it." in found.left_out()


@pytest.mark.parametrize(
    "prompt",
    [
        "a cat wearing a red shirt",
        pytest.param("a penguin wearing a leather jacket and a scarf", marks=pytest.mark.slow),
    ],
)
def test_who_is_dressed_is_one_closed_mesh_without_a_strut(prompt: str):
    parts = composed(prompt).parts()
    assert parts
    verts, faces = union([parts.surface_of(k) for k in range(len(parts.components))], strut=0.0)
    assert is_solid(verts, faces) and component_labels(faces, len(verts))[0] == 1


def test_a_scarf_is_around_the_neck_and_not_on_the_shoulders():
    made, wearer = worn_by("a robot", "scarf"), measured("a robot")
    assert made
    wool = made.mesh[0][part_of(made, "wool", made.mesh[0]) < 0.01]
    around = wool[wearer.below_throat(wool).abs() < 0.06]
    assert around[:, 0].amin() < -0.1 < 0.1 < around[:, 0].amax()
    assert around[:, 1].amin() < wearer.throat[1] < around[:, 1].amax()
    assert float(around[:, 0].abs().amax()) < 0.8 * wearer.head.wide
