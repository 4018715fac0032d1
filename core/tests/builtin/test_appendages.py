"""Wings, horns and ears: exact solids by themselves and on a body."""

import pytest
import torch

from core.geometry.mesh import component_labels, health
from core.geometry.union import union
from core.guidance.builtin.composition.appendages.mount import Mount
from core.guidance.builtin.composition.appendages.shapes import SHAPES, joined_alone
from core.guidance.builtin.constructed.solid import EDGE, ConstructedSolid
from core.guidance.builtin.nouns.appendages import APPENDAGES
from core.guidance.builtin.palette import looks
from core.tests.drawn_things import body, box, composed, shipped_prior


def solids(noun: str, mount: Mount) -> list[tuple[torch.Tensor, torch.Tensor]]:
    return [one.mesh(EDGE) for own in SHAPES[noun](mount).values() for one in own]


def points(noun: str, mount: Mount) -> torch.Tensor:
    return torch.cat([verts for verts, _ in solids(noun, mount)]).float()


@pytest.mark.parametrize("noun", APPENDAGES)
def test_by_itself_it_is_one_closed_component_with_its_parts(noun):
    assert APPENDAGES.keys() == SHAPES.keys()
    mount = Mount.alone()
    parts = joined_alone(SHAPES[noun](mount), mount)
    assert list(parts) == list(looks(noun))
    verts, faces = union([one.mesh(EDGE) for own in parts.values() for one in own], 0.0)
    assert component_labels(faces, len(verts))[0] == 1
    assert health(verts, faces)["closed"]


@pytest.mark.parametrize("noun", ["wings", "bat wings", "horns", "antlers", "cat ears"])
def test_what_is_paired_is_the_same_on_both_sides(noun):
    each = [one for own in SHAPES[noun](Mount.alone()).values() for one in own]
    places = torch.rand(500, 3, generator=torch.Generator().manual_seed(0)) * 3 - 1.5
    there, mirrored = (
        torch.stack([one.distance(at) for one in each]).amin(0)
        for at in (places, places * torch.tensor([-1.0, 1.0, 1.0]))
    )
    assert torch.allclose(there, mirrored, atol=1e-5) and there.amin() < 0.1


def test_on_a_cat_wings_begin_in_its_back_and_ears_on_its_head():
    cat = body("a cat")
    mount = Mount.of(cat)
    low, high = cat.box
    assert not mount.stands and not mount.sideways
    wings, ears = points("wings", mount), points("bunny ears", mount)
    assert wings[:, 2].amax() > high[2] and wings[:, 0].amax() > high[0]
    begin = wings[wings[:, 2] < mount.shoulder[2] + 0.02]
    assert (
        len(begin)
        and (cat.verts - begin.mean(0) * torch.tensor([0.0, 1, 1])).norm(dim=1).min() < 0.2
    )
    assert ears[:, 1].mean() < 0.5 * (low[1] + high[1])  # at its front
    tail = points("fox tail", mount)
    assert tail[:, 1].amax() > high[1]


def test_a_things_wings_are_at_its_sides_and_grow_with_it():
    crate = box([-0.5, -0.4, -0.3], [0.5, 0.4, 0.3])
    mount = Mount.of(crate)
    found = points("wings", mount)
    assert mount.sideways and found[:, 0].amax() > 0.5 and found[:, 0].amin() < -0.5
    assert float(found[:, 0].abs().amin()) > 0.3  # none inside it
    larger = points("wings", mount.times(1.5))
    assert larger[:, 2].amax() - mount.shoulder[2] == pytest.approx(
        1.5 * float(found[:, 2].amax() - mount.shoulder[2]), rel=1e-4
    )


def test_a_winged_pig_is_one_closed_component_with_wings():
    pig = composed("a pig with wings")
    _, wings = pig.made.things
    assert isinstance(wings.solid, ConstructedSolid)
    parts = pig.parts()
    count = len(parts.components)
    verts, faces = union([parts.surface_of(k) for k in range(count)], 0.0)
    assert component_labels(faces, len(verts))[0] == 1


def test_it_is_made_by_itself_of_the_training_s_size():
    drawn = shipped_prior().prompted("bat wings", "").of_object(0)
    assert isinstance(drawn.solid, ConstructedSolid)
    verts, _ = drawn.solid.mesh
    assert float(verts.norm(dim=1).max()) == pytest.approx(0.9, abs=0.02)
