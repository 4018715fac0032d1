"""Several things as one guidance: what is painted and predicted where, and how large they are."""

import math
from dataclasses import replace

import pytest
import torch

from core.camera import Cameras
from core.config import DRAFT
from core.generate import Inputs, of_seed
from core.geometry.mesh import NORMAL_RADIUS, Mesh, component_labels, health
from core.geometry.parts.assembly import assembled
from core.guidance.builtin.composition.composed import Composed, ComposedParts, composed_field
from core.guidance.builtin.composition.placing.placement import Body, Placement
from core.guidance.builtin.composition.poses.posing import seen_from
from core.guidance.builtin.guidance import PromptedBuiltin
from core.guidance.builtin.palette import looks
from core.guidance.builtin.words.vocabulary import parse
from core.guidance.guidance import Views
from core.io.job import Job
from core.job_config import config_of
from core.tests.drawn_things import body, composed, shipped_prior


def test_a_composition_is_one_closed_component_of_the_usual_radius():
    parts = composed("a cat on a red cushion").parts()
    assert parts is not None
    made = assembled(parts, True, DRAFT.geometry.floaters, lambda _: None)
    assert made is not None
    verts, faces = made
    report = health(verts, faces)
    assert report["closed"] and component_labels(faces, len(verts))[0] == 1
    middle = (verts.amin(0) + verts.amax(0)) / 2
    assert float((verts - middle).norm(dim=1).max()) == pytest.approx(NORMAL_RADIUS, abs=0.05)


def test_each_place_is_painted_as_the_thing_that_is_there():
    guidance = composed("a cat on a red cushion")
    areas, parts = guidance.areas(), guidance.parts()
    assert areas is not None and parts is not None
    cat, cushion = guidance.made.things
    assert len(areas.each) >= len(looks("cat")) + len(looks(cushion.words.noun))
    body_of = Body.of(cushion.words, cushion.solid).placed(guidance.made.places[1][0])
    low = body_of.verts[body_of.verts[:, 2] < body_of.verts[:, 2].median()]
    colors = [areas.each[k].surface.color for k in areas.of(low).unique().tolist()]
    assert any(r > 0.5 and r > 2 * max(g, b) for r, g, b in colors), colors
    head = Body.of(cat.words, cat.solid).placed(guidance.made.places[0][0])
    top = head.verts[head.verts[:, 2] > head.verts[:, 2].quantile(0.9)]
    mine = cat.areas()  # with the light in its eyes
    assert mine and (areas.of(top) < len(mine.each)).all()


@pytest.mark.parametrize(
    "prompt", ["a cat on a table", pytest.param("a mouse on a rug", marks=pytest.mark.slow)]
)
def test_what_stands_on_a_thin_top_touches_it(prompt):
    parts = composed(prompt).parts()
    assert isinstance(parts, ComposedParts)
    (cat, (here,)), (top, (there,)) = parts.placed
    assert top.is_thinner
    verts = torch.cat([cat.surface_of(k)[0] for k in range(len(cat.components))])
    away = top.near(there.into(here.out(verts))).amin(1) * there.scale
    assert -0.04 < away.min() < 0


def test_far_from_a_thing_its_network_is_not_asked():
    asked = []

    def field(points):
        asked.append(points)
        return points[:, 0] * 0 - 1.0, points[:, :2] * 0 + 1.0

    at = composed_field([field], [[Placement(0.5, torch.zeros(3), torch.eye(3))]])
    distance, depths = at(torch.tensor([[0.0, 0.0, 0.0], [5.0, 0.0, 0.0]]))
    assert [len(points) for points in asked] == [1]
    assert distance[0] == -0.5 and distance[1] > 3 and (depths[1] < -3).all()
    far = at(torch.tensor([[5.0, 0.0, 0.0]]))  # nothing near at all
    assert far[0] > 3


@pytest.mark.parametrize("negative", [pytest.param("", marks=pytest.mark.slow), "red"])
def test_a_picture_is_predicted_by_the_thing_at_each_place(negative):
    prompted = shipped_prior().prompted("a cat on a red cushion", negative)
    drawn = prompted.of_object(0)
    cameras = Cameras.orbit([20.0], [10.0], 2.75, 40.0)
    surface = torch.zeros(1, 7, 64, 64)
    surface[:, 3] = -1.0
    sides = slice(8, 24), slice(40, 56)  # on the left points of the cat, then of the cushion
    for columns, thing, (place,) in zip(sides, drawn.made.things, drawn.made.places, strict=True):
        verts = Body.of(thing.words, thing.solid).placed(place).verts
        verts = verts[verts[:, 2] > verts[:, 2].quantile(0.3)]  # not where they touch
        some = verts[torch.linspace(0, len(verts) - 1, 16 * 16).long()]
        surface[0, 3, 24:40, columns] = 1.0
        surface[0, 4:, 24:40, columns] = some.T.reshape(3, 16, 16)
    z = torch.randn(1, 4, 64, 64, generator=torch.Generator().manual_seed(0))
    t, options = torch.tensor([300]), {"apart": bool(negative)}
    found = drawn.predict(z, t, Views(cameras, surface), **options)
    owner, copy = drawn._owner(surface)
    assert (owner[0, :20] == 0).all() and (copy == 0).all()
    for index, thing in enumerate(drawn.made.things):
        (place,) = drawn.made.places[index]
        own = thing.predict(z, t, Views(cameras, seen_from(surface, place)), **options)
        mine = owner == index
        assert (mine[0, 24:40, sides[index]]).float().mean() > 0.9
        for of, alone in zip(found, own, strict=True):
            assert (of is None) == (alone is None)
            if of is not None:
                pixels = mine[:, None].expand_as(of)
                torch.testing.assert_close(of[pixels], alone[pixels])
                assert not torch.allclose(of, alone)  # elsewhere it is the other's


@pytest.mark.slow
def test_an_object_is_as_large_as_it_is_with_what_goes_with_it():
    alone = body("a rabbit").usual
    assert 1.1 * alone < composed("a rabbit on a stack of books").size_m() < 3 * alone
    stated = composed("a 60 cm tall rabbit on a stack of books").size_m()
    assert 0.65 < stated < 1.8
    assert shipped_prior().prompted("a rabbit", "").of_object(0).size_m() is None


@pytest.mark.slow
def test_a_mesh_of_ones_own_and_what_is_distilled_are_of_the_first_thing_alone():
    prompted = shipped_prior().prompted("a wizard wearing a golden crown", "")
    alone = prompted.of_object(0, whole=False)
    for one in (prompted, alone):
        (note,) = one.left_out()
        assert note.startswith("crown: left out")
        assert one.size_m() is None
    wizard = shipped_prior().prompted("a wizard", "").of_object(0, whole=False)
    assert alone.parts().forms == wizard.parts().forms
    assert set(wizard.parts().forms.slender) == {1.0}  # nor is its staff made thinner
    assert alone.alone.words.absent == ()  # it has its hat
    whole = prompted.of_object(0)
    assert whole.left_out() == () and whole.made.things[0].words.absent == ("hat",)
    assert whole.alone.words.absent == ()
    mesh = Mesh(body("a wizard").verts, body("a wizard").faces)
    guided = alone.in_proportion(mesh, 0.5, 0.02)
    assert guided.left_out() and guided.start_shape() is not None


@pytest.mark.parametrize(
    ("preset", "guide", "whole"),
    [("draft", False, True), ("draft", True, False), ("sds", False, False)],
)
def test_things_are_made_together_without_a_guide_where_nothing_is_distilled(preset, guide, whole):
    job = Job(prompt="a cat on a cushion", preset=preset)
    config = config_of(job)
    config = replace(config, geometry=replace(config.geometry, start="learned"))
    prompted = shipped_prior().prompted(job.prompt, "")
    shape = Mesh(body("a cat").verts, body("a cat").faces) if guide else None
    inputs = Inputs(config, torch.device("cpu"), prompted, torch.zeros(1), shape)
    made = of_seed(inputs, job).guidance
    assert isinstance(made, Composed) and (made.made is not None) == whole
    assert bool(made.left_out()) != whole


def test_a_material_range_spans_all_things():
    wide = composed("a cat on a golden cushion").ranges()
    assert wide.metallic[0] <= 0.02 and wide.metallic[1] >= 0.9
    assert math.isfinite(wide.roughness[0])


@pytest.mark.slow
def test_copies_are_painted_each_as_the_thing_itself():
    words = replace(parse("a red apple"), count=3)
    guidance = shipped_prior()
    apple = guidance.prompted("a red apple", "")
    three = Composed(guidance, apple, [replace_words(apple, words)], []).of_object(0)
    (places,) = three.made.places
    assert len(places) == 3
    alone = apple.of_object(0).areas()
    together = three.areas()
    verts = Body.of(words, three.made.things[0].solid).verts
    for place in places:
        same = together.of(place.out(verts)) == alone.of(verts)
        assert float(same.float().mean()) > 0.95
    assert len(together.each) == len(alone.each)
    assert three.parts().copy(torch.stack([p.shift for p in places]))[1].tolist() == [0, 1, 2]


def replace_words(prompted, words):
    return PromptedBuiltin(prompted.builtin, words, prompted.negative)
