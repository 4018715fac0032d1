"""Few flat faces, as many as the shape needs."""

import pytest
import torch

from core.errors import UserError
from core.geometry.mesh import Mesh, health
from core.tests.meshes import sphere, torus
from core.texture.low_poly import MEASURED, MOST, deviation, low_poly

BALL = Mesh(*sphere(5))  # 8,192 faces


def off(mesh: Mesh, fine: Mesh) -> float:
    """Of its longest side."""
    double = (fine.verts.double().numpy(), mesh.verts.double().numpy(), mesh.faces.numpy())
    return deviation(*double) / float((fine.verts.amax(0) - fine.verts.amin(0)).max())


def test_a_ball_has_facets_within_the_error():
    coarse, fine = (low_poly(BALL, error, 20_000) for error in (0.01, 0.0025))
    for mesh, error in ((coarse, 0.01), (fine, 0.0025)):
        report = health(mesh.verts, mesh.faces)
        assert report["closed"] and report["manifold"] and report["genus"] == 0
        assert error / 3 < off(mesh, BALL) <= error
        assert mesh.flat
    assert 60 <= len(coarse.faces) < len(fine.faces) <= MOST


def test_holes_stay():
    mesh = low_poly(Mesh(*torus()), 0.01, 20_000)
    assert health(mesh.verts, mesh.faces)["genus"] == 1


def test_the_size_changes_nothing():
    large = Mesh(BALL.verts * 1000, BALL.faces)
    assert len(low_poly(large, 0.01, 20_000).faces) == len(low_poly(BALL, 0.01, 20_000).faces)


def test_the_budget_comes_first():
    assert len(low_poly(BALL, 1e-4, 300).faces) <= 300
    assert len(low_poly(BALL, 1e-4, 50).faces) <= 50  # fewer than it would go to by itself


def test_deviation_of_most_of_the_points():
    plane = torch.tensor([[-9.0, -9, 0], [9, -9, 0], [0, 9, 0]]).double().numpy()
    face = torch.tensor([[0, 1, 2]]).numpy()
    points = torch.zeros(MEASURED, 3).double()
    points[: MEASURED // 50, 2] = 5.0  # a fiftieth is far away
    points[MEASURED // 50 :, 2] = 0.25
    assert deviation(points.numpy(), plane, face) == pytest.approx(0.25)


def test_what_cannot_be_simplified_is_refused_as_elsewhere():
    verts, faces = sphere(4)
    fin = torch.tensor([[int(faces[0, 0]), int(faces[0, 1]), len(verts)]])
    verts = torch.cat([verts, torch.tensor([[2.0, 2, 2]])])
    with pytest.raises(UserError, match="three faces share an edge"):
        low_poly(Mesh(verts, torch.cat([faces, fin])), 0.01, 500)


def test_it_can_be_stopped():
    def stop() -> None:
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        low_poly(BALL, 0.01, 20_000, stop)
