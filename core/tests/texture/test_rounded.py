"""Convex edges catch the light: the normals next to them turn."""

import numpy as np
import pytest
import torch
import trimesh
from torch import Tensor

from core.geometry.mesh import Mesh
from core.ops import normalize
from core.texture.fine_surface import FineSurface
from core.texture.rounded import LONG, RoundedEdges, convex_edges

RADIUS = 0.05
UP, SIDE, FRONT = torch.eye(3)[2], torch.eye(3)[0], -torch.eye(3)[1]


def solid(mesh: trimesh.Trimesh) -> tuple[np.ndarray, np.ndarray]:
    return np.asarray(mesh.vertices, float), np.asarray(mesh.faces)


@pytest.fixture(scope="module")
def cube() -> RoundedEdges:
    return RoundedEdges(*solid(trimesh.creation.box((1.0, 1.0, 1.0))), RADIUS)


def on_top(edges: RoundedEdges, x: list[float], y: float = 0.0) -> Tensor:
    """The normals of places of the upper face."""
    points = torch.tensor([[at, y, 0.5] for at in x])
    return edges.normals(points, UP.expand(len(x), 3))


def test_normals_turn_evenly_towards_the_edge_and_both_sides_meet(cube):
    from_edge = [0.0, 0.2, 0.5, 0.8, 1.0, 2.0]  # radii
    above = on_top(cube, [0.5 - RADIUS * r for r in from_edge])
    near = cube.normals(torch.tensor([[0.5, 0.0, 0.5]]), SIDE[None])
    torch.testing.assert_close(above[0], near[0], atol=1e-5, rtol=0)
    torch.testing.assert_close(above[0], normalize((UP + SIDE)[None])[0], atol=1e-5, rtol=0)
    tilt = above[:, 0]
    assert (tilt[:-2] > tilt[1:-1]).all(), "less and less"
    torch.testing.assert_close(above[4:], UP.expand(2, 3), atol=1e-5, rtol=0)
    torch.testing.assert_close(above.norm(dim=1), torch.ones(len(above)))


def test_three_sides_meet_in_a_corner(cube):
    corner = torch.tensor([[0.5, -0.5, 0.5]])
    for own in (UP, SIDE, FRONT):
        found = cube.normals(corner, own[None])
        torch.testing.assert_close(found, normalize((UP + SIDE + FRONT)[None]), atol=0.06, rtol=0)


def test_where_a_shape_goes_in_it_stays_sharp():
    wall, floor = trimesh.creation.box((0.2, 1, 1)), trimesh.creation.box((1, 1, 0.2))
    shape = wall.apply_translation((-0.4, 0, 0.4)).union(floor)
    verts, faces = solid(shape)
    middles = convex_edges(verts, faces).ends.mean(1)
    inside = np.abs(middles - (-0.3, 0, 0.1))[:, [0, 2]].max(1) < 1e-6
    assert len(middles) and not inside.any()
    edges = RoundedEdges(verts, faces, RADIUS)
    near = torch.tensor([[-0.3 + 0.2 * RADIUS, 0.0, 0.1]])
    assert torch.equal(edges.normals(near, UP[None]), UP[None])


def test_a_crumb_and_what_is_smooth_have_no_edges():
    ball = trimesh.creation.icosphere(4)
    assert len(convex_edges(*solid(ball)).ends) == 0
    plain = RoundedEdges(*solid(ball), RADIUS)
    points = torch.from_numpy(ball.vertices[:5]).float()
    assert torch.equal(plain.normals(points, points), points)
    crumb = trimesh.creation.box([LONG * RADIUS / 13] * 3)  # its twelve edges are one line
    assert len(convex_edges(*solid(crumb), LONG * RADIUS).ends) == 0
    assert len(convex_edges(*solid(crumb)).ends) == 12


def test_the_fine_surface_has_them_where_asked_and_is_else_as_it_was():
    box = trimesh.creation.box((1.0, 1.0, 1.0))
    mesh = Mesh(torch.tensor(box.vertices).float(), torch.tensor(box.faces))
    at = torch.tensor([[0.499, 0.0, 0.5], [0.0, 0.0, 0.5]])
    sharp, soft = (FineSurface(mesh, r).normals(at, UP.expand(2, 3)) for r in (0.0, RADIUS))
    torch.testing.assert_close(sharp, UP.expand(2, 3), atol=1e-6, rtol=0)
    assert soft[0, 0] > 0.6
    torch.testing.assert_close(soft[1], UP, atol=1e-6, rtol=0)


def test_what_is_on_neither_side_of_an_edge_near_it_stays(cube):
    """A board's slanting underside, that another one's edge is below."""
    near = torch.tensor([[0.5 - 0.3 * RADIUS, 0.0, 0.5 + 0.2 * RADIUS]])
    under = normalize(-(UP + SIDE)[None])
    assert torch.equal(cube.normals(near, under), under)
