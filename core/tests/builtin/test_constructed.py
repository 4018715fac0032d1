"""Things that are put together from simple solids."""

import pytest
import torch

from core.geometry.mesh import component_labels, health
from core.geometry.union import union
from core.guidance.builtin.constructed.draw import Draw
from core.guidance.builtin.constructed.shapes import (
    FRONT,
    SIDE,
    ball,
    both_sides,
    box,
    circle,
    framed,
    limb,
    moved,
    of_training_size,
    pipe,
    plate,
    ring,
    rod,
    smooth_union,
    spun,
    turned,
)
from core.guidance.builtin.constructed.solid import EDGE, ConstructedSolid
from core.guidance.builtin.constructed.things import THINGS
from core.guidance.builtin.markings.markings import is_marking
from core.guidance.builtin.nouns import CONSTRUCTED, NOUNS, row_of, solid_of
from core.guidance.builtin.nouns.appendages import APPENDAGES
from core.guidance.builtin.nouns.order import ORDER
from core.guidance.builtin.palette import looks
from core.guidance.builtin.words.vocabulary import parse
from core.tests.drawn_things import shipped_prior

MOST_FACES = 200_000


def test_every_constructed_thing_has_its_solids():
    assert CONSTRUCTED.keys() == THINGS.keys() | APPENDAGES.keys()
    assert not THINGS.keys() & APPENDAGES.keys()
    unknown = {noun for noun in NOUNS if not row_of(noun)}
    assert (
        unknown == {noun for noun in CONSTRUCTED if solid_of(noun) not in ORDER}
        and row_of("violin") == "violin"
    )


@pytest.mark.parametrize("noun", THINGS)
def test_it_is_one_closed_component_and_read_without_notes(noun):
    words = parse(f"a {noun}")
    assert (words.noun, words.notes, words.left_out) == (noun, (), ())
    parts = of_training_size(THINGS[noun](Draw(0)))
    solids = [name for name in looks(noun) if not is_marking(noun, name)]
    assert list(parts) == solids, "the parts of its looks, in their order"
    verts, faces = union([one.mesh(EDGE) for own in parts.values() for one in own], 0.0)
    assert component_labels(faces, len(verts))[0] == 1, "all of it holds together"
    assert health(verts, faces)["closed"] and len(faces) < MOST_FACES
    assert float(verts.norm(dim=1).max()) == pytest.approx(0.9, abs=0.03)


PLACES = torch.rand(300, 3, generator=torch.Generator().manual_seed(0)) * 2 - 1
SOLIDS = {
    "box": box((0.3, 0.5, 0.2), (0.3, 0.1, 0.2), 0.02, (10, 20, 30)),
    "ball": ball((0.3, 0.1, 0.2), (0.4, 0, 0), (0, 0, 30)),
    "rod": rod((0.1, 0, 0), (0.5, 0.4, 0.3), 0.1, 0.05),
    "ring": ring(0.3, 0.05, (0.3, 0, 0), "y"),
    "pipe": pipe([(0.1, 0, 0), (0.4, 0.2, 0.3), (0.6, 0, 0.5)], (0.1, 0.05, 0.08)),
    "plate": plate([(0, 0), (0.5, 0), (0.2, 0.6)], 0.1, (0.2, 0, 0), FRONT),
    "holed": plate(circle(0.4), 0.1, (0.2, 0.1, 0), SIDE, [circle(0.2)]),
    "turned": turned([(0, 0), (0.3, 0), (0.2, 0.4), (0, 0.4)], (0.3, 0, 0)),
    "limbs": smooth_union(
        [
            limb([(0.1, 0, 0), (0.4, 0.2, 0.3)], (0.1, 0.08), (1.0, 1.4)),
            limb([(0.3, 0, 0), (0.3, 0.5, 0)], 0.1),
        ],
        0.05,
    ),
}


@pytest.mark.parametrize("name", SOLIDS)
def test_a_mirrored_a_moved_and_a_framed_solid_are_where_they_should_be(name):
    one, places = SOLIDS[name], PLACES.double()
    _, other = both_sides([one])
    across = torch.tensor([-1.0, 1.0, 1.0]).double()
    assert torch.allclose(other.distance(places * across), one.distance(places), atol=1e-6)
    (there,) = moved([one], (0.1, 0.2, 0.3))
    by = torch.tensor([0.1, 0.2, 0.3]).double()
    assert torch.allclose(there.distance(places + by), one.distance(places), atol=1e-6)
    larger = framed(one, 2.0, by.numpy())
    if one.form != "ellipsoid":  # known to first order
        assert torch.allclose(larger.distance(2 * places + by), 2 * one.distance(places), atol=1e-6)
    third = spun([one], 3)[1]
    c, s = -0.5, 0.75**0.5
    turn = torch.tensor([[c, -s, 0], [s, c, 0], [0, 0, 1]]).double()
    assert torch.allclose(third.distance(places @ turn.T), one.distance(places), atol=1e-5)


def test_it_is_drawn_by_its_seed_and_without_what_is_absent():
    first, same, other = (
        shipped_prior().prompted("a swimming pool", "").of_object(seed) for seed in (0, 0, 1)
    )
    assert isinstance(first.solid, ConstructedSolid)
    assert torch.equal(first.solid.mesh[0], same.solid.mesh[0])
    assert first.solid.mesh[0].shape != other.solid.mesh[0].shape or not torch.allclose(
        first.solid.mesh[0], other.solid.mesh[0]
    )
    without = shipped_prior().prompted("a swimming pool without a ladder", "").of_object(0)
    assert "ladder" in first.solid.solids and "ladder" not in without.solid.solids
    assert len(without.parts().components) == len(first.parts().components) - 2


def test_where_it_is_not_put_together_a_note_says_that_no_network_knows_it():
    """On the user's mesh, or distilled from an ellipsoid."""
    assert any(
        "swimming pool" in note
        for note in shipped_prior().prompted("a swimming pool", "").left_out()
    )
    assert not shipped_prior().prompted("a mug", "").left_out()
    drawn = shipped_prior().prompted("a swimming pool", "").of_object(0)
    assert not drawn.left_out()
    assert drawn.words.indices(("noun",)) == [0]


@pytest.mark.parametrize(("adjective", "axis"), [("tall", 2), ("wide", 0), ("thick", 1)])
def test_it_is_stretched_for_a_shape_adjective(adjective, axis):
    plain, other = (
        shipped_prior().prompted(f"a {shape} harp", "").of_object(0).solid
        for shape in ("", adjective)
    )
    before, after = ((v.amax(0) - v.amin(0)) for v in (plain.mesh[0], other.mesh[0]))
    assert int((after / before).argmax()) == axis and (after / before)[axis] > 1.05
    assert float(other.mesh[0].norm(dim=1).max()) == pytest.approx(0.9, abs=0.03)
    away = other.sdf(other.mesh[0])  # within another solid, less than 0
    assert float(away.max()) < 0.02 and float(away.median().abs()) < 0.002
    parts = torch.cat([one.verts for one in other.known.components])
    assert torch.allclose(parts, other.mesh[0])


@pytest.mark.parametrize(
    ("prompt", "by"), [("a round pig", 1.4), ("a round cow", 1.4), ("a thin horse", 0.62)]
)
def test_an_animal_is_wide_or_narrow_and_as_long_as_it_is(prompt, by):
    plain, other = (
        shipped_prior().prompted(words, "").of_object(0).solid.mesh[0]
        for words in (f"a {prompt.split()[-1]}", prompt)
    )
    wide, long, _ = (other.amax(0) - other.amin(0)) / (plain.amax(0) - plain.amin(0))
    assert float(wide / long) == pytest.approx(by, rel=1e-3)


def test_a_round_one_keeps_its_own_form_with_a_note():
    words = parse("a round swimming pool")
    assert not words.shape and any("keeps its own form" in note for note in words.notes)


@pytest.mark.parametrize(
    ("prompt", "part"),
    [("a dog with large ears", "ears"), ("a bicycle with large wheels", "wheels")],
)
def test_its_parts_have_the_stated_size_where_they_are_attached(prompt, part):
    drawn = shipped_prior().prompted(prompt, "").of_object(0)
    plain = shipped_prior().prompted(prompt.split(" with ")[0], "").of_object(0)
    assert not drawn.left_out() and not plain.left_out()
    index = list(looks(drawn.words.noun)).index(part)
    long = []
    for one in (drawn, plain):
        boxes, others = one.parts().boxes(), one.parts().components
        long.append(float((boxes[index][1] - boxes[index][0]).norm()))
        verts = torch.cat([other.verts for other in others])
        assert float(verts.norm(dim=1).max()) == pytest.approx(0.9, abs=0.03)
    assert long[0] > 1.1 * long[1]
    parts = drawn.parts()
    meshes = [parts.surface_of(k) for k in range(len(parts.components))]
    verts, faces = union(meshes, 0.0)
    labels = component_labels(faces, len(verts))[1]
    assert (labels == labels[0]).mean() > 0.99, "what grows stays attached"


def test_its_parts_keep_their_thickness_with_a_note():
    drawn = shipped_prior().prompted("a bicycle with thick wheels", "").of_object(0)
    assert any("thick wheels" in note for note in drawn.left_out())
    whole = shipped_prior().prompted("a bicycle", "").of_object(0)
    assert torch.equal(drawn.solid.mesh[0], whole.solid.mesh[0])


def test_solids_of_a_part_that_meet_are_one_place_for_its_markings():
    """A tower that is put together from two boxes is one wall, and another tower is another."""
    plain = shipped_prior().prompted("a castle", "").of_object(0).solid
    low, high = (box((0.2, 0.2, 0.2), (0.5, y, 0)) for y in (0.0, 0.2))
    towers = {"wall": [low, high, *moved([low], (-1, 0, 0))]}
    solid = ConstructedSolid(
        plain.net, plain.triplane, solids=towers, names=("wall", "roof"), frame=plain.frame
    )
    walls, roofs = solid.known.component_boxes()
    assert len(walls) == 2 and roofs == []
    assert sorted(float((box[1] - box[0]).max()) for box in walls) == pytest.approx([0.2, 0.4])


@pytest.mark.parametrize(("pose", "drawn"), [("sitting", False), ("running", True)])
def test_an_animal_whose_legs_are_folded_is_the_networks(pose, drawn):
    (first,) = shipped_prior().prompted(f"a {pose} dog", "").of_object(0).made.things
    assert isinstance(first.solid, ConstructedSolid) is drawn
