"""Slender things: known wider than they are, looked at so, and drawn in their own proportions."""

from collections.abc import Callable
from functools import cache

import numpy as np
import pytest
import torch

from core.geometry.mesh import NORMAL_RADIUS, face_areas
from core.geometry.parts.assembly import KnownParts, assembled, thinned_by
from core.geometry.parts.forms import Forms
from core.geometry.parts.primitives import FORMS, Primitive, packed, packed_along, unpacked
from core.geometry.parts.sheets import thinned_sheet
from core.geometry.parts.slender import THINNED, thinned
from core.geometry.tet_grid import EXTENT
from core.geometry.union import is_solid
from core.guidance.builtin.bent import BentSolid, in_box
from core.guidance.builtin.guidance import PromptedBuiltin
from core.guidance.builtin.nouns import NOUNS
from core.guidance.builtin.slender import SLENDER, slender_parts
from core.guidance.builtin.stretch import AS_IT_IS, DRAWN_WIDER
from core.prior.draw import Draw
from core.prior.families import Shape, build, normalised
from core.prior.solid_data import distances_of
from core.prior.solids import ball, box
from core.tests.drawn_things import shipped_prior

WIDER = (3.0, 3.0, 1.0)
HALF = torch.tensor([0.1, 0.012, 0.8])  # a blade, thinner than a cell of the lattice


def blade(points):
    """Its distances as a network that knows it wider has them: too short by that."""
    q = (points.abs() - HALF) * torch.tensor(WIDER)
    return ((q.clamp_min(0).norm(dim=1) + q.amax(1).clamp_max(0)) / max(WIDER))[:, None]


@pytest.fixture(scope="module")
def parts() -> KnownParts:
    return KnownParts(blade, Forms((1.0,), ((0.0,),) * 3), WIDER)


def test_a_blade_is_found_and_as_thin_as_it_is(parts):
    made = assembled(parts, True, 0.05, lambda _: None)
    assert made is not None
    high = made[0].amax(0)
    assert torch.allclose(high, HALF, rtol=0.02), high  # 0.05 as it is
    (extent,) = parts.extents()
    assert np.allclose(extent, 2 * HALF.numpy(), rtol=0.1)
    (drawn,) = (parts.surface_of(k, exact=False)[0] for k in range(len(parts.components)))
    assert torch.allclose(drawn.amax(0), HALF, rtol=0.1)


def test_its_distance_is_told_across_it_and_what_is_far_is_far(parts):
    x, y = 0.05, 0.03
    points = torch.tensor([[x, HALF[1] + y, 0.2], [0.0, 0.0, 0.0], [0.9, 0.9, 0.0]])
    found = parts.near(points)[:, 0]
    assert found[0].item() == pytest.approx(y, abs=0.003)
    assert found[1] < 0 and found[2] > 0.09


def stretched_shape() -> Shape:
    plate = {"plate": box((0, 0, 0), (0.3, 0.05, 1.0)), "knob": ball((0, 0, 1.0), 0.2)}
    return normalised(plate, WIDER)


def test_a_stretched_shape_s_distances_are_true_to_first_order():
    shape = stretched_shape()
    away = torch.linspace(-0.03, 0.05, 9)
    wall = 0.05 * shape.scale[1]
    points = torch.stack([0 * away, wall + away, 0 * away], 1)
    assert torch.allclose(distances_of(shape, points)[:, 0], away, atol=1e-3)
    # Its own are too short by the stretch: a network's error would be three times as large a one.
    assert torch.allclose(shape.distances(points)[:, 0], away / 3, atol=1e-3)


def test_of_an_even_shape_they_are_the_shapes_own():
    shape, points = build("mug", "", Draw(torch.Generator().manual_seed(0))), torch.rand(50, 3)
    assert torch.equal(distances_of(shape, points), shape.distances(points))


@pytest.mark.parametrize("noun", DRAWN_WIDER)
def test_what_is_slender_is_a_known_thing_and_is_told_wider_by_the_data(noun):
    assert noun in NOUNS and max(DRAWN_WIDER[noun]) > 1 == min(DRAWN_WIDER[noun])
    own, wide = (
        build(noun, "", Draw(torch.Generator().manual_seed(0)), 0.0, by)
        for by in (AS_IT_IS, DRAWN_WIDER[noun])
    )
    ratio = np.array(wide.scale) / own.scale
    assert np.allclose(ratio / ratio.min(), DRAWN_WIDER[noun])


@pytest.fixture(scope="module")
def sword() -> Callable[[int], PromptedBuiltin]:
    return cache(shipped_prior().prompted("a sword", "").of_object)


def test_a_sword_is_slender(sword):
    one = sword(0)
    verts, _ = one.solid.mesh
    assert one.solid.frame.scale[2] == pytest.approx(2.4 * one.solid.frame.scale[0])
    radius = (verts - (verts.amin(0) + verts.amax(0)) / 2).norm(dim=1).max().item()
    assert radius == pytest.approx(NORMAL_RADIUS, abs=0.03)
    made = assembled(one.parts(), True, 0.05, lambda _: None)
    width, depth, height = (made[0].amax(0) - made[0].amin(0)).tolist()
    assert height > 2.5 * width > 5 * depth


def test_by_a_guide_that_is_wide_it_is_not_cut_off(sword):
    """A guide along x: looked at 2.4 times as wide, its ends would be out of the cube."""
    one, half = sword(0), torch.tensor([0.85, 0.1, 0.3])
    frame = in_box(one.solid, torch.stack([-half, half]), 0.01).frame
    bent = BentSolid(one.solid.net, one.solid.triplane, frame)
    parts = PromptedBuiltin(one.builtin, one.words, one.negative, bent).parts()
    made = assembled(parts, False, 0.05, lambda _: None)
    assert made[0][:, 0].amax() > 0.8 > EXTENT / 2.4


UPON = (0.3, -0.2, 0.1), (0.2, 0.5, -0.3)  # somewhere, turned somehow
STRIP = np.array([(0.5, 0.5), (-0.5, 0.5), (-0.5, -0.5), (0.5, -0.5)])
FRAME = [STRIP, 0.85 * STRIP[::-1]]  # a square frame's outline
# Form, lengths, and its size along its own axes at half the thickness.
THIN = [
    ("capsule", (0.5, 0.1, 0.06), (0.1, 0.1, 1.16)),
    ("box", (0.05, 0.06, 0.7, 0.0), (0.05, 0.06, 1.4)),
    ("box", (0.6, 0.05, 0.7, 0.02), (1.2, 0.05, 1.4)),
    ("ellipsoid", (0.5, 0.3, 0.05), (1.0, 0.6, 0.05)),
    ("frustum", (0.6, 0.1, 0.08, 0.02), (0.1, 0.1, 1.2)),
    ("frustum", (0.05, 0.5, 0.5, 0.0), (1.0, 1.0, 0.05)),
    ("ring", (0.5, 0.1), (1.1, 1.1, 0.1)),
    ("turned", (0, -0.5, 0.1, -0.5, 0.1, 0.5, 0, 0.5), (0.1, 0.1, 1.0)),
    ("turned", (0.4, -0.05, 0.5, -0.05, 0.5, 0.05, 0.4, 0.05), (0.95, 0.95, 0.05)),
    ("layers", packed([(-0.1, 0.1, [STRIP])]), (1.0, 1.0, 0.1)),
    ("layers", packed([(-0.5, 0.5, [STRIP * (0.1, 1.0)])]), (0.054, 0.954, 1.0)),
    ("layers", packed([(-0.1, 0.1, FRAME)]), (0.9625, 0.9625, 0.2)),
    ("crossed", packed_along([[(-0.1, 0.1, [STRIP])], [], [(-0.1, 0.1, [STRIP])]]), (1, 1, 1)),
    ("wall", (0.5, *packed([(0.45, 0.55, [STRIP * (4, 1)])])), (1.05, 1.05, 1.0)),
    ("blade", (0.2, 0.05, 0.6, 0.3, 1.0), (0.4, 0.05, 0.9)),
    ("blade", (0.08, 0.05, 0.6, 0.3, 1.0), (0.08, 0.05, 0.9)),
]


def wing(points):
    """A sheet that is bent, with an uneven outline: no primitive."""
    x, y, z = points.unbind(1)
    outline = (x.square() + (y * (1.3 + 0.4 * (5 * x).sin())).square()).sqrt() - 0.5
    across = (z - 0.35 * x.square() - 0.2 * x * y).abs() - 0.05
    away = torch.stack([outline, across], 1)
    return (away.clamp_min(0).norm(dim=1) + away.amax(1).clamp_max(0))[:, None]


@pytest.mark.parametrize("by", [1.0, 0.4])
def test_a_sheet_that_is_no_primitive_gets_thinner_and_keeps_its_outline(by):
    parts = KnownParts(wing, Forms((0.0,), ((0.0,),) * 3, slender=(by,)))
    (component,) = parts.components
    assert component.primitive is None
    verts, faces = parts.surface_of(0)
    assert is_solid(verts, faces)
    area = float(face_areas(verts, faces).sum())
    assert 2 * volume(verts, faces) / area == pytest.approx(0.1 * by, rel=0.2)
    drawn, _ = parts.surface_of(0, exact=False)
    for ends in (drawn.amax(0) - verts.amax(0), drawn.amin(0) - verts.amin(0)):
        assert ends[:2].abs().max() < 0.02
    assert thinned_by(parts) == pytest.approx(1 / by, rel=0.15 * (by < 1))


def test_what_is_stout_is_no_sheet():
    blob = KnownParts(
        lambda p: (p.norm(dim=1) - 0.4 + 0.03 * (9 * p).sin().sum(1))[:, None],
        Forms((0.0,), ((0.0,),) * 3, slender=(0.4,)),
    )
    (component,) = blob.components
    made = thinned_sheet(component.verts, component.faces, component.lattice, 0.4)
    assert made[0] is component.verts


def test_points_of_the_drawn_surface_settle_on_the_thin_one():
    q = torch.tensor([0.6, 0.5, 0.08])

    def board(points):
        off = points.abs() - q
        return (off.clamp_min(0).norm(dim=1) + off.amax(1).clamp_max(0))[:, None]

    points = torch.cat([torch.rand(200, 2) - 0.5, torch.full((200, 1), 0.08)], 1)
    part = torch.zeros(200, dtype=torch.long)
    for by in (1.0, 0.5):
        parts = KnownParts(board, Forms((1.0,), ((0.0,),) * 3, slender=(by,)))
        found = parts.settled(points, part)
        assert torch.allclose(found[:, :2], points[:, :2], atol=0.005)
        assert (found[:, 2] - 0.08 * by).abs().max() < 0.006


def test_a_thinner_thing_weighs_what_is_usual():
    ladder = shipped_prior().prompted("a ladder", "").of_object(1)
    parts = ladder.parts()
    assert parts is not None and thinned_by(parts) > 1.3
    mug = shipped_prior().prompted("a chest", "").of_object(1).parts()
    assert mug is not None and thinned_by(mug) == 1.0


def test_a_narrow_layer_stays_among_wide_ones():
    foot = [(-0.5, -0.4, [STRIP]), (-0.4, 0.5, [0.15 * STRIP])]
    one = Primitive("layers", np.zeros(3), np.zeros(3), packed(foot))
    (_, _, (base,)), (low, high, (pole,)) = unpacked(thinned(one, 0.4).lengths)
    assert (low, high) == (-0.4, 0.5)
    assert 0.05 < np.abs(pole).max() < 0.07 and np.abs(base).max() > 0.4


FOOT = (0, -0.5, 0.5, -0.5, 0.5, -0.4, 0.1, -0.3, 0.1, 0.5, 0, 0.5)


@pytest.mark.parametrize(
    ("form", "lengths"),
    [("turned", FOOT), ("box", (0.3, 0.4, 0.5, 0.0)), ("frustum", (0.3, 0.3, 0.2, 0.0))],
)
def test_what_has_no_thin_direction_stays(form, lengths):
    one = Primitive(form, *map(np.array, UPON), np.array(lengths, float))
    assert np.array_equal(thinned(one, 0.4).lengths, one.lengths)


def volume(verts, faces) -> float:
    return float(torch.linalg.det(verts[faces].double()).sum() / 6)


def test_each_form_can_be_thinner():
    assert set(THINNED) == set(FORMS) == {form for form, *_ in THIN} | {"pipes", "limbs"}


@pytest.mark.parametrize(("form", "lengths", "size"), THIN)
def test_a_primitive_is_made_thinner_and_as_long_as_it_is(form, lengths, size):
    one = Primitive(form, *map(np.array, UPON), np.array(lengths, float))
    made = thinned(one, 0.5)
    assert thinned(one, 1.0) is one
    verts, faces = made.mesh(np.inf)
    assert is_solid(verts, faces)
    local = made.local(verts.double().numpy())
    assert np.allclose(np.ptp(local, axis=0), size, atol=0.004), np.ptp(local, axis=0)
    was = one.local(one.mesh(np.inf)[0].double().numpy())
    assert volume(verts, faces) < 0.63 * volume(*one.mesh(np.inf))
    ends = [(x.min(0) + x.max(0)) / 2 for x in (local, was)]
    there = made.center + made.frame @ ends[0], one.center + one.frame @ ends[1]
    assert np.allclose(*there, atol=0.004)  # its middle stays


@pytest.mark.parametrize("noun", SLENDER)
def test_thin_parts_are_known_parts_and_are_thinner(noun):
    assert noun in NOUNS and set(SLENDER[noun]) <= set(NOUNS[noun].looks)
    assert all(0.1 <= by < 0.95 for by in SLENDER[noun].values())
    names = list(NOUNS[noun].looks)
    assert slender_parts(noun, names) == [SLENDER[noun].get(name, 1.0) for name in names]


def test_another_s_solid_is_as_thin_as_that_one_unless_it_has_a_row():
    own = {noun for noun, row in NOUNS.items() if row.solid and noun in SLENDER}
    others = [noun for noun, row in NOUNS.items() if row.solid in SLENDER and noun not in own]
    assert own and others
    for noun in others:
        solid, names = NOUNS[noun].solid, list(NOUNS[noun].looks)
        first = slender_parts(solid, list(NOUNS[solid].looks))
        found = slender_parts(noun, names)
        assert len(found) == len(names) and found[: len(first)] == first[: len(names)]
