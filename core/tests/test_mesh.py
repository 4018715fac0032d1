"""Meshes: the health report against hand-made shapes, normalising, floaters, and files."""

import math

import pytest
import torch

from core.errors import UserError
from core.geometry.mesh import NORMAL_RADIUS, compact, drop_floaters, health, normalise


def tetrahedron(size=1.0, shift=0.0):
    verts = torch.tensor([[0.0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]) * size + shift
    return verts, torch.tensor([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]])


def torus(around=12, across=8):
    """A torus of quads cut in two, built by index arithmetic: genus 1 by construction."""
    i, j = torch.meshgrid(torch.arange(around), torch.arange(across), indexing="ij")
    a, b = i * (2 * math.pi / around), j * (2 * math.pi / across)
    ring = 1 + 0.4 * b.cos()
    verts = torch.stack([ring * a.cos(), ring * a.sin(), 0.4 * b.sin()], -1).view(-1, 3)

    def node(di, dj):
        return ((i + di) % around * across + (j + dj) % across).view(-1)

    lower = torch.stack([node(0, 0), node(1, 0), node(1, 1)], 1)
    upper = torch.stack([node(0, 0), node(1, 1), node(0, 1)], 1)
    return verts, torch.cat([lower, upper])


def join(*meshes):
    start, verts, faces = 0, [], []
    for v, f in meshes:
        verts.append(v)
        faces.append(f + start)
        start += len(v)
    return torch.cat(verts), torch.cat(faces)


def test_health_of_a_tetrahedron():
    report = health(*tetrahedron())
    assert report["closed"]
    assert report["manifold"]
    assert report["oriented"]
    assert report["volume"] == pytest.approx(1 / 6)
    assert report["area"] == pytest.approx(1.5 + 3**0.5 / 2)
    assert (report["verts"], report["faces"]) == (4, 4)
    assert (report["euler"], report["genus"], report["components"]) == (2, 0, 1)
    assert report["bounds"] == [[0, 0, 0], [1, 1, 1]]


def test_health_counts_handles_over_all_components():
    report = health(*join(torus(), torus(9, 5), tetrahedron(shift=5.0)))
    assert (report["genus"], report["components"], report["euler"]) == (2, 3, 2)
    assert report["closed"]
    assert report["manifold"]
    assert report["oriented"]


def test_health_sees_inward_faces_as_negative_volume():
    verts, faces = torus()
    outward, inward = health(verts, faces), health(verts, faces.flip(1))
    assert outward["volume"] == pytest.approx(-inward["volume"])
    assert outward["volume"] > 0


def test_health_sees_a_hole():
    verts, faces = tetrahedron()
    report = health(verts, faces[1:])
    assert not report["closed"]
    assert report["open_edges"] == 3
    assert report["genus"] is None
    assert report["volume"] is None
    assert report["manifold"]
    assert report["oriented"]


def test_health_sees_one_flipped_face():
    verts, faces = tetrahedron()
    faces[0] = faces[0].flip(0)
    report = health(verts, faces)
    assert report["closed"]
    assert report["manifold"]
    assert not report["oriented"]


def test_health_sees_an_edge_of_three_faces():
    verts, faces = tetrahedron()
    verts = torch.cat([verts, torch.tensor([[2.0, 2, 2]])])
    report = health(verts, torch.cat([faces, torch.tensor([[0, 1, 4]])]))
    assert report["nonmanifold_edges"] == 1
    assert not report["manifold"]


def test_health_sees_two_pieces_that_share_one_vertex():
    verts, faces = join(tetrahedron(), tetrahedron(-1.0))
    faces[faces == 4] = 0
    report = health(verts, faces)
    assert report["closed"]
    assert report["nonmanifold_edges"] == 0
    assert report["nonmanifold_verts"] == 1
    assert not report["manifold"]
    assert report["loose_verts"] == 1


def test_health_sees_degenerate_faces():
    verts, faces = tetrahedron()
    verts = torch.cat([verts, torch.tensor([[0.5, 0, 0]])])
    faces = torch.cat([faces, torch.tensor([[0, 0, 1], [0, 4, 1]])])
    assert health(verts, faces)["degenerate_faces"] == 2


def test_health_of_nothing():
    report = health(torch.zeros(0, 3), torch.zeros(0, 3, dtype=torch.int64))
    assert report["faces"] == 0
    assert not report["closed"]
    assert report["components"] == 0
    assert report["bounds"] is None


def test_health_is_plain_python():
    for value in health(*torus()).values():
        assert type(value) in (int, float, bool, list)


def test_normalise_centres_the_box_and_fits_the_sphere():
    verts = torus()[0] * 37 + torch.tensor([100.0, -3, 8])
    unit, center, scale = normalise(verts)
    torch.testing.assert_close(unit.amax(0) + unit.amin(0), torch.zeros(3), atol=1e-5, rtol=0)
    assert float(unit.norm(dim=1).max()) == pytest.approx(NORMAL_RADIUS, rel=1e-5)
    torch.testing.assert_close(unit / scale + center, verts)


def test_normalise_refuses_a_point():
    with pytest.raises(UserError, match="one point"):
        normalise(torch.ones(5, 3))


def test_drop_floaters_keeps_the_large_outward_pieces():
    void = tetrahedron(0.9, 0.03)
    parts = torus(), tetrahedron(0.05, 3.0), tetrahedron(1.5, 5.0), (void[0], void[1].flip(1))
    verts, faces = drop_floaters(*join(*parts), keep_ratio=0.05)
    expected = join(parts[0], parts[2])
    torch.testing.assert_close(verts, expected[0])
    assert torch.equal(faces, expected[1])


def test_drop_floaters_keeps_a_mesh_that_is_inside_out():
    verts, faces = torus()
    assert torch.equal(drop_floaters(*join((verts, faces.flip(1)), tetrahedron(0.01)))[0], verts)


def test_compact_keeps_the_order():
    verts, faces = compact(torch.arange(15.0).view(5, 3), torch.tensor([[4, 1, 3]]))
    assert verts[:, 0].tolist() == [3, 9, 12]
    assert faces.tolist() == [[2, 0, 1]]
