"""Bent pipes: their curves, their surfaces, and components that are pipes."""

import numpy as np
import pytest
import torch

from core.geometry.mesh import component_labels, health, signed_volume
from core.geometry.parts import pipe_fitting
from core.geometry.parts.assembly import KnownParts, assembled
from core.geometry.parts.forms import Forms
from core.geometry.parts.pipe_fitting import piped, simplified
from core.geometry.parts.pipes import Pipe, packed_pipes, pipes, surface_of, unpacked_pipes
from core.geometry.parts.skeleton import Skeleton, skeleton_of
from core.geometry.parts.slender import thinned
from core.geometry.sweep import across
from core.guidance.builtin.nouns import NOUNS
from core.tests.drawn_things import shipped_prior

R = 0.06
ROUND = Forms((0.0,), ((0.0,),) * 3)


def line(*places, radius=R):
    return np.array([(*place, radius) for place in places], float)


def arc(count=9, radius=0.5, share=0.5):
    angle = np.linspace(0, 2 * np.pi * share, count)
    return np.stack([radius * np.cos(angle), 0 * angle, radius * np.sin(angle) - 0.2], 1)


HANDLE = [Pipe(line(*arc()))]
RING = [Pipe(line(*(arc(13, share=1.0) * (1.0, 1.0, 0.6))[:-1]), closed=True)]
FORK = [
    Pipe(line((0, 0, -0.6), (0, 0, 0))),
    Pipe(line((0, 0, 0), (0.4, 0.1, 0.5))),
    Pipe(line((0, 0, 0), (-0.4, 0, 0.5))),
]
CORNERS = (-0.5, 0, -0.4), (0.5, 0, -0.4), (0.3, 0.1, 0.5)
TRIANGLE = [Pipe(line(a, b)) for a, b in zip(CORNERS, CORNERS[1:] + CORNERS[:1], strict=True)]
EACH = {"handle": HANDLE, "ring": RING, "fork": FORK, "triangle": TRIANGLE}
LOOPS = {"handle": 0, "ring": 1, "fork": 0, "triangle": 1}


def drawn(found, wave=0.006):
    """The distances of pipes as a network has them, off by waves."""
    numbers = packed_pipes(found)

    def distances(points):
        off = torch.from_numpy(pipes(points.double().numpy(), numbers)).to(points)
        return (off + wave * (13 * points).sin().sum(1))[:, None]

    return distances


@pytest.mark.parametrize("name", EACH)
def test_a_component_of_pipes_is_found_with_its_joints_and_loops(name):
    parts = KnownParts(drawn(EACH[name]), ROUND)
    (component,) = parts.components
    skeleton = skeleton_of(component.lattice, 1.5)
    assert skeleton is not None and skeleton.loops == LOOPS[name]
    one = component.primitive
    assert one is not None and one.form == "pipes"
    true = packed_pipes(EACH[name])
    verts, faces = one.mesh(0.05)
    off = np.abs(pipes(verts.double().numpy(), true))
    assert off.mean() < 0.15 * component.error and off.max() < 0.5 * component.error
    radii = np.concatenate([pipe.nodes[:, 3] for pipe in unpacked_pipes(one.lengths)])
    assert np.abs(radii / R - 1).max() < 0.25
    facts = health(verts, faces)
    assert facts["closed"] and facts["components"] == 1, facts
    assert genus(verts, faces) == LOOPS[name]


def test_pipes_are_made_thinner_to_their_ends():
    thin = Forms((0.0,), ((0.0,),) * 3, slender=(0.4,))
    wide, narrow = (KnownParts(drawn(HANDLE, 0.0), forms) for forms in (ROUND, thin))
    (stout,), (slim,) = ([c.primitive for c in one.components] for one in (wide, narrow))
    assert stout and slim and np.array_equal(thinned(stout, 0.4).lengths, slim.lengths)
    made = assembled(narrow, True, 0.05, lambda _: None)
    assert made is not None
    size = (made[0].amax(0) - made[0].amin(0)).tolist()
    assert size == pytest.approx([1 + 0.8 * R, 0.8 * R, 0.5 + 0.8 * R], abs=0.02)
    assert narrow.near(torch.tensor([[0.5 + R, 0.0, -0.2]]))[0, 0] == pytest.approx(
        0.6 * R, abs=0.01
    )


def board(points, half=(0.6, 0.04, 0.15), wave=0.004):
    q = points.abs() - torch.tensor(half)
    bent = q.clamp_min(0).norm(dim=1) + q.amax(1).clamp_max(0)
    return (bent + wave * (13 * points).sin().sum(1))[:, None]


def test_what_is_stout_or_a_board_is_no_pipe():
    fat = [pipe._replace(nodes=pipe.nodes * (1, 1, 1, 3)) for pipe in FORK]
    for distances in (board, drawn(fat)):
        forms = [c.primitive and c.primitive.form for c in KnownParts(distances, ROUND).components]
        assert "pipes" not in forms


def genus(verts, faces):
    return 1 - (len(verts) - len(faces) // 2) // 2


@pytest.mark.parametrize(("radius", "is_pipe"), [(0.11, True), (0.14, False)])
def test_a_long_ring_is_a_pipe_up_to_the_radius_of_one(radius, is_pipe):
    ring = [Pipe(line(*arc(13, 0.6, 1.0)[:-1], radius=radius), closed=True)]
    (component,) = KnownParts(drawn(ring), ROUND).components
    assert (piped(component) is not None) == is_pipe


def test_a_pipe_of_another_area_than_the_surface_is_none(monkeypatch):
    """Of a strip, whose pipe winds over it with half as much surface again."""
    (component,) = KnownParts(lambda p: board(p, (0.7, 0.05, 0.12), 0.002), ROUND).components
    assert piped(component) is None
    monkeypatch.setattr(pipe_fitting, "AREA", 0.6)
    assert piped(component) is not None


def test_the_first_skeleton_that_has_all_loops_is_taken(monkeypatch):
    """An eye so small that wide bands do not see it."""
    eye = Pipe(line(*arc(9, 0.1, 1.0)[:-1]), closed=True)
    shaft = Pipe(line((0, 0, -0.3), (0, 0, -0.8)))
    (component,) = KnownParts(drawn([eye, shaft]), ROUND).components
    loops = [skeleton_of(component.lattice, width).loops for width in (4.0, 1.5)]
    assert (loops, genus(component.verts, component.faces)) == ([0, 1], 1)
    monkeypatch.setattr(pipe_fitting, "WIDTHS", (4.0, 1.5))
    assert genus(*piped(component).mesh(0.05)) == 1
    monkeypatch.setattr(pipe_fitting, "WIDTHS", (4.0,))
    assert piped(component) is None


def test_the_circles_of_a_closed_curve_turn_evenly():
    """Off a plane the first direction comes back turned; a little of that is on each circle."""
    angle = np.linspace(0, 2 * np.pi, 400, endpoint=False)
    wide = 1 + 0.3 * np.cos(3 * angle)  # a coil bent to a ring
    places = np.stack([wide * np.cos(angle), wide * np.sin(angle), 0.3 * np.sin(3 * angle)], 1)
    along = np.roll(places, -1, 0) - np.roll(places, 1, 0)
    along /= np.linalg.norm(along, axis=1, keepdims=True)
    side, other = across(places, closed=True)
    assert np.abs((side * along).sum(1)).max() < 1e-9
    assert np.abs(other - np.cross(along, side)).max() < 1e-9
    after = np.roll(side, -1, 0)
    turns = np.arctan2((after * other).sum(1), (after * side).sum(1))
    assert abs(turns.sum()) > 0.1  # in all
    assert np.abs(turns - turns.mean()).max() < 1e-3


@pytest.mark.slow
def test_a_small_wing_is_no_pipe_that_winds_over_it():
    dragon = shipped_prior().prompted("a dragon with huge wings", "").of_object(1).parts()
    assert dragon is not None
    wings = list(NOUNS["dragon"].looks).index("wings")
    found = [component for component in dragon.components if component.place.part == wings]
    assert found and not any(c.primitive and c.primitive.form == "pipes" for c in found)


def test_a_closed_curve_goes_through_its_nodes_and_a_circle_is_one():
    nodes = line(*arc(13, share=1.0)[:-1])
    curve = Pipe(nodes, closed=True).curve
    assert np.allclose(curve[0], curve[-1])
    assert np.abs(np.linalg.norm(curve[:, [0, 2]] - (0, -0.2), axis=1) - 0.5).max() < 0.003
    off = np.linalg.norm(curve[:, None] - nodes, axis=2).min(0)
    assert off.max() < 1e-9
    straight = Pipe(line((0, 0, 0), (0, 0, 1), (0, 0, 3))).curve
    assert np.allclose(straight[:, :2], 0) and (np.diff(straight[:, 2]) > 0).all()


@pytest.mark.parametrize("name", EACH)
def test_a_pipe_s_surface_is_closed_faces_outwards_and_is_at_distance_0(name):
    for pipe in EACH[name]:
        verts, faces = surface_of(pipe, 0.05, 32)
        facts = health(verts, faces)
        assert facts["closed"] and component_labels(faces, len(verts))[0] == 1
        assert signed_volume(verts, faces) > 0
        ways = torch.cat([faces[:, [k, (k + 1) % 3]] for k in range(3)])
        assert len(ways.unique(dim=0)) == len(ways)  # each edge once each way: no end is inside out
        off = pipes(verts.double().numpy(), packed_pipes([pipe]))
        assert np.abs(off).max() < 0.002


def test_pipes_are_packed_and_come_back():
    found = unpacked_pipes(packed_pipes([*RING, *FORK]))
    for pipe, other in zip(found, [*RING, *FORK], strict=True):
        assert pipe.closed == other.closed and np.array_equal(pipe.nodes, other.nodes)


def test_a_loop_with_a_branch_is_cut_at_its_corners():
    square = [(-1, -1), (0, -1), (1, -1), (1, 1), (-1, 1)]
    nodes = line(*((x, y, 0) for x, y in [*square, (2, 2)]))
    edges = {k: {(k + 1) % 5, (k - 1) % 5} for k in range(5)}
    graph = simplified(Skeleton(nodes, edges), 0.1)
    assert sorted(map(len, graph.pipes)) == [2, 2, 2, 2]  # the middle of a side is no node
    edges[3] |= {5}
    edges[5] = {3}
    graph = simplified(Skeleton(nodes, edges), 0.1)
    assert len(graph.pipes) == 5 and len(graph.nodes) == 5
