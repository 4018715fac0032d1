"""A solid of known parts as a mesh: components of their own, exact forms, one union."""

import math

import numpy as np
import pytest
import torch

from core.geometry.faces import bending
from core.geometry.lattice import Lattice
from core.geometry.mesh import health
from core.geometry.parts import assembly, matching
from core.geometry.parts import components as assembly_components
from core.geometry.parts.assembly import KnownParts, assembled
from core.geometry.parts.components import (
    Component,
    Place,
    drawn_at,
    places_of,
    points_of,
    repeats,
    turned_fraction,
)
from core.geometry.parts.fitting import Faces
from core.geometry.parts.forms import Forms
from core.geometry.parts.matching import around, fitted_together, mirrored, similar_groups, slack_of
from core.geometry.parts.primitives import Primitive, packed, unpacked
from core.geometry.union import is_solid, union
from core.render.normals import face_normals
from core.tests.meshes import torus

BOARD, LEGS, BALL = range(3)
BALLS = ((0.0, 0.4), (-0.7, 0.073))  # where along x, and the radius
FORMS = Forms((1.0, 0.8, 0.0), ((0.3, 0.2, 1.0),) * 3)


def box(points, center, half):
    q = (points - torch.tensor(center)).abs() - torch.tensor(half)
    return q.clamp_min(0).norm(dim=1) + q.amax(1).clamp_max(0)


def table(points, wave=0.0):
    """A board on two legs, a ball on it, far things beyond; each distance waves by ``wave``."""
    board = box(points, (0.0, 0.0, 0.2), (0.7, 0.5, 0.06))
    legs = [box(points, (x, 0.0, -0.25), (0.08, 0.3, 0.42)) for x in (-0.5, 0.5)]
    ball = (points - torch.tensor([0.2, 0.1, 0.3])).norm(dim=1) - 0.09
    distances = torch.stack([board, torch.minimum(*legs), ball, torch.ones(len(points))], 1)
    return distances + wave * (17 * points).sin().sum(1, keepdim=True)


def made(distances=table, forms=FORMS):
    return put_together(KnownParts(distances, forms))


def put_together(parts, exact=True):
    return assembled(parts, exact, 0.05, lambda done: None)


def wavy():
    """The table as a network draws it."""
    return KnownParts(lambda points: table(points, wave=0.002), FORMS)


@pytest.fixture(scope="module")
def wavy_parts():
    """What was found of it stays."""
    return wavy()


@pytest.fixture(scope="module")
def wavy_mesh(wavy_parts):
    return put_together(wavy_parts)


def drawn(distances):
    """The first component."""
    return drawn_at(distances, next(places_of(distances, 1)))


def test_every_connected_component_of_a_part_is_one():
    components = list(places_of(table, 4))
    assert [component.part for component in components] == [BOARD, LEGS, LEGS, BALL]
    for component, low in zip(components, (-0.7, -0.58, 0.42, 0.11), strict=True):
        assert -0.07 < component.low[0] - low < 0
    # Each knows where the other of its part is.
    left, right = components[1], components[2]
    places = torch.tensor([[-0.5, 0.0, -0.2], [0.5, 0.0, -0.2], [0.0, 0.0, -0.2]])
    assert left.others(places).tolist() == [False, True, False]
    assert right.others(places).tolist() == [True, False, False]


def test_what_waves_comes_out_with_its_planes_and_its_ball(wavy_parts, wavy_mesh):
    verts, faces = wavy_mesh
    found = health(verts, faces)
    assert found["closed"] and found["manifold"] and found["components"] == 1
    assert found["genus"] == 0
    normal = torch.nn.functional.normalize(face_normals(verts, faces), dim=1)
    area = torch.linalg.cross(*(verts[faces[:, k]] - verts[faces[:, 0]] for k in (1, 2))).norm(
        dim=1
    )
    middle = verts[faces].mean(1)
    ball = (middle - torch.tensor([0.2, 0.1, 0.3])).norm(dim=1) < 0.12
    along = normal.abs().amax(1) > 0.999
    assert (area * along)[~ball].sum() / area[~ball].sum() > 0.97
    # As exact as the waves of a component's middle let it be.
    low, high = verts.amin(0), verts.amax(0)
    torch.testing.assert_close(low, torch.tensor([-0.7, -0.5, -0.67]), atol=0.012, rtol=0)
    torch.testing.assert_close(high[:2], torch.tensor([0.7, 0.5]), atol=0.012, rtol=0)
    as_drawn = health(*put_together(wavy_parts, exact=False))
    assert as_drawn["area"] > 0 and as_drawn["closed"]


def test_what_is_a_box_up_to_its_errors_is_one_and_a_cushion_is_none():
    def rounded(radius):
        half = (0.4 - radius, 0.3 - radius, 0.1 - radius)
        return lambda points: (box(points, (0.0, 0.1, 0.0), half) - radius)[:, None]

    verts, _ = made(rounded(0.02), Forms((1.0,), ((0.0,),) * 3))
    low, high = verts.amin(0), verts.amax(0)
    torch.testing.assert_close(low, torch.tensor([-0.4, -0.2, -0.1]), atol=0.003, rtol=0)
    on = torch.minimum((verts - low).abs(), (verts - high).abs()).amin(1)
    assert on.max() < 1e-3  # corners too
    corner = torch.stack([low, high]).T
    assert torch.cdist(torch.cartesian_prod(*corner), verts).amin(1).max() < 1e-3
    soft, _ = made(rounded(0.09), Forms((0.7,), ((0.0,),) * 3))
    assert torch.cdist(torch.cartesian_prod(*corner), soft).amin(1).min() > 0.03


def test_of_a_part_without_a_flat_face_nothing_is_a_box_or_a_disc():
    """A stripe around a tiger's tail, hardly larger than what a network is off, was a block, and a
    panda's eyes were cut flat."""

    def stripe(points):
        return (box(points, (0.1, 0.0, 0.0), (0.05, 0.06, 0.11)) - 0.025)[:, None]

    def eye(points):  # of 0.04 by 0.055, with an edge
        across = points[:, :2].norm(dim=1) - 0.035
        edge = torch.stack([across, points[:, 2].abs() - 0.02], 1)
        return (edge.clamp_min(0).norm(dim=1) + edge.amax(1).clamp_max(0) - 0.02)[:, None]

    def form_of(part, flat):
        (component,) = KnownParts(part, Forms((flat,), ((0.5,),) * 3)).components
        return component.primitive.form if component.primitive else ""

    assert form_of(stripe, 1.0) == "box"
    assert form_of(stripe, 0.0) not in ("box", "")
    assert form_of(eye, 1.0) in ("frustum", "box")
    assert form_of(eye, 0.0) in ("ellipsoid", "capsule", "ring")
    # A row of zeros has no information: the part is small, or was never seen.
    assert Forms((0.0, 0.0, 0.2), ((0.0, 0.5, 0.0),) * 3).may_be_flat(0)
    assert not Forms((0.0, 0.0, 0.2), ((0.0, 0.5, 0.0),) * 3).may_be_flat(1)


@pytest.mark.parametrize(("flat", "form"), [(0.5, "capsule"), (0.57, "capsule"), (0.66, "box")])
def test_of_a_part_that_is_mostly_flat_a_component_is_a_block(flat, form):
    """A nightstand's drawer, drawn rounded, was a roll."""

    def drawer(points):
        return (box(points, (0.0, 0.0, 0.0), (0.34, 0.02, 0.035)) - 0.08)[:, None]

    (component,) = KnownParts(drawer, Forms((flat,), ((0.0,),) * 3)).components
    assert component.primitive.form == form


def test_what_is_round_is_told_by_the_component_itself():
    def disc(points):
        across = points[:, :2].norm(dim=1) - 0.5
        return torch.maximum(across, points[:, 2].abs() - 0.08)[:, None]

    def square(points):
        return box(points, (0.0, 0.0, 0.0), (0.5, 0.5, 0.08))[:, None]

    assert turned_fraction(disc, drawn(disc), 2) > 0.99
    assert turned_fraction(disc, drawn(disc), 0) < 0.5
    assert turned_fraction(square, drawn(square), 2) < 0.95
    # Its profile is a circle, though it has lumps and the table of forms has a square.

    def lumpy(points):
        return disc(points) + 0.008 * (9 * torch.atan2(points[:, 1:2], points[:, :1])).sin()

    verts, _ = made(lumpy, Forms((1.0,), ((0.3,), (0.3,), (0.3,))))
    wall = verts[verts[:, 2].abs() < 0.04]
    wall = wall[:, :2].norm(dim=1)
    assert (wall[wall > 0.4] - 0.5).abs().max() < 0.004


def test_what_does_not_touch_is_joined():
    def apart(points):
        ends = [box(points, (x, 0.0, 0.0), (0.2, 0.2, z)) for x, z in ((-0.4, 0.2), (0.4, 0.206))]
        return torch.stack(ends, 1)

    verts, faces = made(apart, Forms((1.0, 1.0), ((0.0, 0.0),) * 3))
    found = health(verts, faces)
    assert found["components"] == 1 and found["closed"] and found["genus"] == 0
    # And their upper faces are one plane, in between.
    left, right = (verts[x, 2].amax() for x in (verts[:, 0] < -0.3, verts[:, 0] > 0.3))
    assert left == pytest.approx(float(right), abs=1e-6) and 0.201 < left < 0.205


def component_of(one, part=0, error=0.03):
    """The component whose surface a primitive's is."""
    verts, faces = one.mesh(0.05)
    low, high = verts.amin(0).double().numpy(), verts.amax(0).double().numpy()
    place = Place(part, low, high, lambda points: torch.zeros(len(points), dtype=torch.bool))
    return Component(place, verts, faces, Lattice(np.ones((2, 2, 2)), low, 0.05), error)


def upright(*lengths, at=(0.0, 0.0, 0.0), turn=(0.0, 0.0, 0.0)):
    """A sharp box."""
    return Primitive("box", np.array(at), np.array(turn), np.array([*lengths, 0.0]))


CUBE = upright(0.4, 0.3, 0.2)
CUBES = KnownParts(lambda points: CUBE.distance(points)[:, None], Forms((1.0,), ((0.0,),) * 3))


@pytest.mark.parametrize("fault", ["ragged", "open"])
def test_planes_that_straighten_little_or_open_a_component_are_not_taken(monkeypatch, fault):
    component = component_of(CUBE)
    noise = 0.01 * torch.randn(component.verts.shape, generator=torch.Generator().manual_seed(0))
    good = component.verts.clone(), component.faces
    bad = {
        "ragged": (component.verts + 0.95 * noise, component.faces),
        "open": (component.verts.clone(), component.faces[1:]),
    }[fault]
    component = component._replace(verts=component.verts + noise)
    for answer, taken in ((bad, False), (good, True)):
        monkeypatch.setattr(assembly, "crisp", lambda *_, a=answer, smooth: a)
        verts, _ = assembly.exact_surface(CUBES, component)
        assert (verts is answer[0]) == taken
        rough, left = (
            bending(v.double().numpy(), component.faces.numpy()) for v in (component.verts, verts)
        )
        assert taken or left < 0.8 * rough  # then it loses its ripples instead


def layers(steps):
    """The cube as one layer, each side of its outline in so many steps."""
    corners = np.array([(-0.4, -0.3), (0.4, -0.3), (0.4, 0.3), (-0.4, 0.3)])
    fraction = np.linspace(0, 1, steps, endpoint=False)[:, None]
    sides = [a + fraction * (b - a) for a, b in zip(corners, np.roll(corners, -1, 0), strict=True)]
    outline = packed([(-0.2, 0.2, [np.concatenate(sides)])])
    return Primitive("layers", np.zeros(3), np.zeros(3), outline)


def test_of_layers_that_fit_as_well_those_of_fewer_numbers_are_taken(monkeypatch):
    fine, plain = layers(20), layers(1)
    found = iter([fine, plain, fine])
    monkeypatch.setattr(assembly, "layered", lambda *_: next(found))
    one = CUBES._layered(component_of(CUBE))
    assert one is plain and next(found, None) is None  # along all three axes


def test_layers_are_sought_along_a_component_s_own_axes_and_around_it(monkeypatch):
    frames, tilted = [], upright(0.4, 0.3, 0.1, turn=(0.0, 0.5, 0.3))
    around_it = layers(1)
    monkeypatch.setattr(assembly, "layered", lambda _, frame: frames.append(frame))
    monkeypatch.setattr(assembly, "wall", lambda _: around_it)
    assert CUBES._layered(component_of(CUBE)) is around_it
    assert len(frames) == 3
    CUBES._layered(component_of(tilted))
    assert len(frames) == 9
    along = [abs(frame[:, 2] @ tilted.frame[:, 2]) for frame in frames[6:]]
    assert max(along) > 0.99


@pytest.mark.parametrize(("refused", "form"), [("box", "capsule"), ("", "box")])
def test_a_block_that_was_not_drawn_so_is_found_again(monkeypatch, refused, form):
    def fitted(points, error, faces):
        return upright(0.1, 0.1, 0.1)._replace(form="box" if faces.block else "capsule")

    monkeypatch.setattr(matching, "primitive_of", fitted)
    monkeypatch.setattr(matching, "is_drawn", lambda _, one, component: one.form != refused)
    component = component_of(upright(0.1, 0.1, 0.1))
    one = matching.one_drawn(
        table, component, assembly_components.points_of(component), Faces(block=True)
    )
    assert one is not None and one.form == form


def test_components_of_one_part_and_size_are_similar():
    sizes = ((0, 0.3), (0, 0.1), (1, 0.1), (0, 0.105))
    components = [component_of(upright(half, half, half), part) for part, half in sizes]
    assert sorted(map(sorted, similar_groups(components))) == [[0], [1, 3], [2]]


def test_three_components_may_be_worse_than_two():
    assert slack_of(2) == 1 < slack_of(3)


@pytest.mark.parametrize("placed", [mirrored, around])
def test_components_that_are_mirrored_or_turned_are_fitted_together(placed):
    """Legs that spread."""
    leg = upright(0.06, 0.09, 0.3, turn=(0.1, 0.4, 0.0))
    ends = [(0.5, 0.4), (-0.5, 0.4)] if placed is mirrored else [(0.5, 0.0), (-0.3, 0.4)]
    middles = [np.array([*end, 0.1]) for end in ends]
    components = [component_of(leg.placed(placed(middle), middle)) for middle in middles]
    points = [points_of(component) for component in components]
    found = fitted_together(components, points)
    for one, some in zip(found, points, strict=True):
        assert one is not None and one.fits(some, components[0].error)
        np.testing.assert_array_equal(one.lengths, found[0].lengths)


def test_a_part_of_many_corners_is_not_taken_for_round():
    """A stop sign was a disc: its corners are hardly more than the errors off one."""
    turns = [k * math.pi / 8 for k in range(1, 16, 2)]
    sides = torch.tensor(
        [[math.cos(turn + math.pi / 8), math.sin(turn + math.pi / 8)] for turn in turns]
    )

    def octagon(points):
        across = (points[:, ::2] @ sides.T).amax(1) - 0.6
        return torch.maximum(across, points[:, 1].abs() - 0.08)[:, None]

    forms = Forms((0.9,), ((0.0,), (0.87,), (0.0,)))
    assert KnownParts(octagon, forms).components[0].primitive.form in ("frustum", "turned")
    (one,) = KnownParts(octagon, forms._replace(cornered=(0,))).components
    assert one.primitive.form == "layers"
    (_, _, (loop,)) = unpacked(one.primitive.lengths)[0]
    assert len(loop) == 8


def test_there_is_none_where_nothing_is_inside():
    assert made(lambda points: torch.ones(len(points), 3)) is None


def test_a_stop_asked_for_stops_it():
    def stop(done):
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        assembled(KnownParts(table, FORMS), True, 0.05, stop)


def test_the_same_solid_gives_the_same_mesh(wavy_mesh):
    torch.rand(1), np.random.rand()  # whatever others drew before
    again = put_together(wavy())
    assert all(torch.equal(a, b) for a, b in zip(wavy_mesh, again, strict=True))


def test_a_union_keeps_its_faces_small_and_its_volume_right():
    verts, faces = _cube()
    for _ in range(3):  # 12 faces become 768
        verts, faces = _halved(verts, faces)
    size = float((verts.amax(0) - verts.amin(0)).max())
    moved = verts + torch.tensor([size / 2, size / 3, size / 5])
    both, corners = union([(verts, faces), (moved, faces)], 0.0)
    found, one = health(both, corners), health(verts, faces)
    assert found["closed"] and found["manifold"] and found["components"] == 1
    assert found["volume"] == pytest.approx(one["volume"] * (2 - 1 / 2 * 2 / 3 * 4 / 5), rel=1e-4)
    assert len(corners) > 768  # those of one plane are not merged


def test_no_strut_leads_from_the_wall_of_a_void():
    verts, faces = _cube()
    pot = union([(0.9 * verts + 0.05, faces)], 0.0)
    hollow = torch.cat([verts, pot[0]]), torch.cat([faces, pot[1].flip(1) + len(verts)])
    knob = 0.2 * verts + torch.tensor([0.4, 0.4, 1.1]), faces
    for meshes in ([hollow], [hollow, knob]):
        made = union(meshes, 0.02)
        found = health(*made)
        assert found["components"] == 2  # the outside and the void's wall
        assert made[0].amin(0).tolist() == [0, 0, 0]
    assert found["volume"] > 1 - 0.9**3 + 0.2**3


def test_an_open_mesh_is_no_solid():
    verts, faces = torus()
    assert is_solid(verts, faces)
    assert not is_solid(verts, faces[1:])


def _cube():
    verts = torch.tensor([[x, y, z] for x in (0.0, 1) for y in (0.0, 1) for z in (0.0, 1)])
    sides = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    faces = [f for a, b, c, d in sides for f in ((a, b, c), (a, c, d))]
    return verts, torch.tensor(faces)


def _halved(verts, faces):
    """Each face becomes four."""
    edges = torch.sort(faces[:, [0, 1, 1, 2, 2, 0]].view(-1, 2), 1).values
    unique, index = torch.unique(edges, dim=0, return_inverse=True)
    a, b, c = (index.view(-1, 3) + len(verts)).T
    u, v, w = faces.T
    parts = [(u, a, c), (v, b, a), (w, c, b), (a, b, c)]
    return torch.cat([verts, verts[unique].mean(1)]), torch.cat([torch.stack(p, 1) for p in parts])


def around(turns):
    """The matrix that turns rows about the vertical by so much of a whole turn."""
    turn = 2 * math.pi * turns
    c, s = math.cos(turn), math.sin(turn)
    return torch.tensor([[c, s, 0.0], [-s, c, 0.0], [0.0, 0.0, 1.0]])


def star(points, wave=0.0):
    """Three round arms about the middle, too stout for pipes, each drawn a little otherwise."""
    arms = [
        box(points @ around(k / 3), (0.35, 0.0, 0.0), (0.25, 0.0, 0.0)) - 0.15 for k in range(3)
    ]
    return (torch.stack(arms).amin(0) + wave * (11 * points).sin().sum(1))[:, None]


def test_what_repeats_itself_around_an_axis_does_so_exactly():
    forms = Forms((0.0,), ((0.0,),) * 3)
    bent = KnownParts(lambda points: star(points, wave=0.006), forms)
    component = bent.components[0]
    assert len(bent.components) == 1 and component.primitive is None
    mean = repeats(bent.distances, component)
    assert mean is not None
    points = torch.rand(500, 3) - 0.5
    turned = (points - component.middle) @ around(1 / 3) + component.middle
    torch.testing.assert_close(mean(turned), mean(points), atol=1e-5, rtol=0)
    assert (bent.distances(turned) - bent.distances(points)).abs().max() > 0.005
    verts, _ = bent.surface_of(0)
    assert mean(verts).abs().mean() < 0.5 * bent.distances(verts).abs().mean()
    # One arm is longer than the others, and another thicker: nothing repeats.
    uneven = KnownParts(lambda p: star(p).minimum(long(p)), forms)
    assert repeats(uneven.distances, uneven.components[0]) is None


def long(points):
    arm = box(points, (0.5, 0.0, 0.0), (0.4, 0.0, 0.0)) - 0.12
    return arm.minimum(box(points @ around(1 / 3), (0.35, 0.0, 0.1), (0.3, 0.1, 0.15)))[:, None]


def test_a_flat_outline_is_one_all_along():
    def arch(points):
        hole = 0.35 - (points[:, [0, 2]] - torch.tensor([0.0, -0.5])).norm(dim=1)
        wave = 0.004 * (13 * points).sin().sum(1)
        return (box(points, (0.0, 0.0, 0.0), (0.7, 0.2, 0.5)).maximum(hole) + wave)[:, None]

    known = KnownParts(arch, Forms((0.7,), ((0.0,),) * 3))
    (component,) = known.components
    assert component.primitive is not None and component.primitive.form == "layers"
    verts, faces = known.surface_of(0)
    normals = face_normals(verts, faces)
    # Each face is an end, or along the axis.
    along = normals[:, 1].abs()
    assert ((along < 1e-2) | (along > 1 - 1e-2)).all()
    assert (arch(verts)[:, 0].abs() < 0.03).all()
    # A part that is round in the mean has none.
    (component,) = KnownParts(arch, Forms((0.1,), ((0.0,),) * 3)).components
    assert component.primitive is None


def test_four_legs_are_one_leg_four_times():
    def legs(points):
        at = [(x, y) for x in (-0.5, 0.5) for y in (-0.4, 0.4)]
        wave = 0.006 * (9 * points).sin().sum(1)
        each = [box(points, (x, y, 0.0), (0.1, 0.1, 0.4)) for x, y in at]
        return (torch.stack(each).amin(0) + wave)[:, None]

    found = [
        component.primitive
        for component in KnownParts(legs, Forms((1.0,), ((0.0,),) * 3)).components
    ]
    assert [one.form for one in found] == ["box"] * 4
    # But for the last digit, as the legs' faces are made flush.
    assert np.ptp([one.lengths for one in found], axis=0).max() < 1e-12
    assert sorted(round(float(one.center[0]), 1) for one in found) == [-0.5, -0.5, 0.5, 0.5]


def test_near_is_the_distance_from_the_exact_surfaces(wavy_parts, wavy_mesh):
    verts, _ = wavy_mesh
    near = wavy_parts.near(verts)
    assert near.shape == (len(verts), 3)
    assert near.amin(1).abs().max() < 4e-3  # the union's vertices are on one of them
    inside = wavy_parts.near(torch.tensor([[0.0, 0.0, 0.2], [0.2, 0.1, 0.33]]))
    assert inside[0, BOARD] < -0.04 and inside[1, BALL] < -0.03


@pytest.mark.parametrize(("high", "stays"), [(0.05, True), (0.3, False)])
def test_a_primitive_is_not_what_has_a_spike(high, stays):
    """A fountain's jet is few points of its water, and no layer has it."""

    def distances(points):
        board = box(points, (0.0, 0.0, 0.0), (0.8, 0.8, 0.15))
        spike = box(points, (0.3, 0.2, 0.15), (0.05, 0.05, high))
        return torch.stack([torch.minimum(board, spike), torch.ones(len(points))], 1)

    (place,) = places_of(distances, 1)
    component = drawn_at(distances, place)
    assert component is not None
    board = Primitive("box", np.zeros(3), np.zeros(3), np.array([0.8, 0.8, 0.15, 0.0]))
    assert matching.is_drawn(distances, board, component) == stays


@pytest.mark.parametrize(("least", "components"), [((), 2), ((0.02,), 2), ((1.0,), 1), ((0.0,), 2)])
def test_what_is_far_smaller_than_any_component_of_its_part_is_a_stray(least, components):
    """A ball, and one of a thirtieth of its surface."""

    def balls(points):
        return torch.stack(
            [(points - torch.tensor([x, 0.0, 0.0])).norm(dim=1) - r for x, r in BALLS], 1
        ).amin(1, keepdim=True)

    found = KnownParts(balls, Forms((0.0,), ((1.0,),) * 3, least=least)).components
    assert len(found) == components
    assert max(float(component.verts[:, 0].max()) for component in found) == pytest.approx(
        0.4, abs=0.02
    )
