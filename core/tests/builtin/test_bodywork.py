"""Bodywork: a vehicle's body has round edges and wells around its wheels."""

import math

import numpy as np
import pytest
import torch

from core.geometry.parts.assembly import KnownParts, assembled
from core.geometry.parts.bodywork import GAP, Bodywork, bodied, is_upright, rounded_edges
from core.geometry.parts.forms import Forms
from core.geometry.union import is_solid, rounded_box, volume
from core.guidance.builtin.bodywork import ROUNDED, bodywork_of
from core.guidance.builtin.markings.forms import rings
from core.guidance.builtin.markings.markings import Marked
from core.guidance.builtin.palette import looks
from core.prior.solids import box, tube

RADIUS, WHEEL = 0.05, 0.16


def block(center, half):
    verts, faces = rounded_box(np.array(half), 0.0, 0.1, 16)
    return verts.float() + torch.tensor(center), faces


BODY = block((0.0, 0.0, 0.1), (0.4, 0.8, 0.2))


def wheel(x: float, y: float):
    return block((x, y, -0.06), (0.07, WHEEL, WHEEL))


@pytest.fixture(scope="module")
def cube():
    return block((0.0, 0.0, 0.0), (0.5, 0.5, 0.5))


def test_a_rounded_cube_keeps_its_faces_and_loses_its_corners(cube):
    made = rounded_edges(cube, 0.1)
    assert is_solid(*made)
    assert torch.allclose(made[0].amax(0), cube[0].amax(0), atol=1e-3)
    inner = 0.8  # Steiner's formula
    area, edges = 6 * inner**2 * 0.1, 12 * inner * math.pi * 0.01 / 4
    whole = inner**3 + area + edges + 4 / 3 * math.pi * 0.001
    assert volume(made) == pytest.approx(whole, rel=0.003)
    assert made[0].abs().sum(1).max() < 1.5 - 3 * 0.1 * (1 - 1 / math.sqrt(3)) + 0.01


def test_what_is_thinner_than_the_edges_are_round_stays():
    plate = block((0.0, 0.0, 0.0), (0.5, 0.5, 0.03))
    kept = bodied(plate, 0.05, [], 0.1)
    assert volume(kept) == pytest.approx(volume(plate))


def test_a_body_has_wells_around_its_wheels_and_holds_them_by_their_axles():
    wheels = [wheel(x, y) for x in (-0.36, 0.36) for y in (-0.5, 0.5)]
    made = bodied(BODY, 0.0, wheels, 0.1)
    assert is_solid(*made)
    verts = made[0]
    axle = torch.hypot(verts[:, 1].abs() - 0.5, verts[:, 2] + 0.06)
    over = (verts[:, 0].abs() > 0.31) & (axle > 0.1)
    # No vertex of the body is nearer to a wheel than the gap, but for the axle's.
    assert axle[over].min() > WHEEL + 0.9 * GAP
    assert ((verts[:, 0].abs() - 0.36).abs() < 1e-4).any()  # the axles' ends
    sides = made[0][made[1]] - made[0][made[1].roll(1, 1)]
    assert sides.norm(dim=2).max() < 0.12
    lost = volume(BODY) - volume(made)
    assert 0 < lost < 0.2 * volume(BODY)


def test_a_wheel_that_is_not_at_its_side_gets_no_well():
    spare = block((0.0, 0.8, 0.1), (WHEEL, 0.07, WHEEL))
    middle = wheel(0.0, -0.6)
    made = bodied(BODY, 0.0, [spare, middle], 0.1)
    assert volume(made) == pytest.approx(volume(BODY))
    sizes = ([0.1, 0.4, 0.4], [0.4, 0.1, 0.4], [0.4, 0.4, 0.4], [0.1, 0.4, 0.2])
    upright = [is_upright(torch.tensor(size)) for size in sizes]
    assert upright == [True, False, False, False]


def test_the_areas_distances_are_those_of_the_finished_body():
    solids = [box((0, 0, 0.1), (0.4, 0.8, 0.2))]
    solids.append(tube((0.29, 0.5, -0.06), (0.43, 0.5, -0.06), WHEEL))

    def distances(points):
        return torch.stack([solid(points) for solid in solids], 1)

    round_ = ((0.0, 0.9), (0.0, 0.0), (0.0, 0.0))
    plain = KnownParts(distances, Forms((1.0, 0.5), round_))
    work = KnownParts(distances, Forms((1.0, 0.5), round_, bodywork={0: Bodywork(RADIUS, 1)}))
    corner = torch.tensor([[0.4, 0.8, 0.3]]) - 0.004
    assert plain.near(corner)[0, 0] < 0 < work.near(corner)[0, 0]
    within = torch.tensor([[0.38, 0.5, -0.06 + WHEEL + GAP / 2]])  # the well
    assert plain.near(within)[0, 0] < 0 < work.near(within)[0, 0]
    made = assembled(work, True, 0.05, lambda _: None)
    assert made is not None and is_solid(*made)
    assert volume(made) < volume(assembled(plain, True, 0.05, lambda _: None))


def test_a_body_whose_sides_lean_is_not_made_of_steps():
    def steps(points):  # as a network that errs a little draws a cabin
        slabs = [(points - torch.tensor([0, 0, z])).abs() - torch.tensor([a, a, 0.25])
                 for z, a in ((-0.2, 0.6), (0.25, 0.4))]  # fmt: skip
        return torch.stack([slab.amax(1) for slab in slabs]).amin(0)[:, None]

    flat = ((0.0,),) * 3
    made = KnownParts(steps, Forms((1.0,), flat)).components
    assert [one.primitive.form for one in made] == ["layers"]
    leaning = Forms((1.0,), flat, bodywork={0: Bodywork(0.0, None, True)})
    assert [one.primitive for one in KnownParts(steps, leaning).components] == [None]


def test_each_row_is_of_a_part_that_the_thing_has():
    for noun, rows in ROUNDED.items():
        names = list(looks(noun))
        found = bodywork_of(noun, names)
        assert [names[part] for part in found] == [name for name in names if name in rows]
        assert all(0 < one.radius < 0.1 for one in found.values())
        assert all(names[one.wheels] == "wheels" for one in found.values() if one.wheels)
    names = list(looks("police car"))
    assert bodywork_of("police car", names) == bodywork_of("taxi", list(looks("taxi")))
    assert bodywork_of("chair", list(looks("chair"))) == {}


def test_every_wheel_has_a_hub_on_both_faces_whichever_way_it_stands():
    side = [torch.tensor([[x - 0.1, -y, 0.0], [x + 0.1, 0.6 - y, 0.6]])
            for x, y in ((-0.5, 0.3), (0.5, 1.5))]  # fmt: skip
    spare = torch.tensor([[-0.3, 0.9, 0.2], [0.3, 1.1, 0.8]])
    names, boxes = list(looks("van")), [None] * len(looks("van"))
    wheels, hubs = names.index("wheels"), names.index("hubs")
    boxes[wheels] = side[0]
    every = [[] if name != "wheels" else [*side, spare] for name in names]
    at = [[x + out, y, 0.3] for x, y in ((-0.5, 0.0), (0.5, -1.2)) for out in (-0.1, 0.1)]
    at += [[0.0, 1.1, 0.5], [-0.4, 0.28, 0.3]]  # the spare wheel's; a tread
    points = torch.tensor(at)
    distances = torch.ones(len(points), len(names))
    distances[:, wheels] = 0

    def on_hub(**boxes_of):
        found = Marked("van", names, boxes, **boxes_of)(distances, points)
        return (found[:, hubs] <= 0).tolist()

    assert on_hub(every=every) == [True] * 5 + [False]
    assert on_hub() == [True, True, False, False, False, False]  # the largest alone


def test_a_hub_has_holes_in_a_ring():
    half = torch.tensor([0.1, 0.3, 0.3])
    angles = torch.arange(5) * math.tau / 5

    def ring(far, turn):
        away = far * 0.3
        y, z = away * torch.cos(angles + turn), away * torch.sin(angles + turn)
        return torch.stack([torch.full((5,), 0.1), y, z], 1)

    assert (rings.hub(ring(0.36, 0.0), half) < 0).all()
    assert (rings.hub(ring(0.36, math.pi / 5), half) > 0).all()
    assert (rings.hub(ring(0.2, 0.0), half) > 0).all()
    assert (rings.hub(ring(0.7, math.pi / 5), half) < 0).all()
