"""Charts hang together, look one way, and are as many as the shape asks for."""

import numpy as np
import pytest
import torch
import trimesh

from core.geometry.faces import areas_and_normals, neighbours
from core.tests.meshes import sphere, torus
from core.texture import charts as module
from core.texture.charts import (
    borders,
    charts,
    components,
    halved,
    merged,
    smooth,
    straightened,
)


def arrays(mesh: tuple[torch.Tensor, torch.Tensor]) -> tuple[np.ndarray, np.ndarray]:
    return mesh[0].double().numpy(), mesh[1].numpy()


def test_neighbours_are_those_of_a_double_loop() -> None:
    faces = arrays(sphere(1))[1][3:]  # open
    faces = np.concatenate([faces, [[0, 2, 40], [2, 0, 41]]])  # a third and a fourth on an edge
    faces[5] = faces[5][::-1]  # looks inwards
    edge = lambda f, i: (int(f[i]), int(f[(i + 1) % 3]))  # noqa: E731
    for a, face in enumerate(faces):
        for i in range(3):
            p, q = edge(face, i)
            sharing = [(b, edge(other, j)) for b, other in enumerate(faces) for j in range(3)
                       if set(edge(other, j)) == {p, q} and (b, j) != (a, i)]  # fmt: skip
            right = len(sharing) == 1 and sharing[0][1] == (q, p)
            assert neighbours(faces)[a, i] == (sharing[0][0] if right else -1)


def test_a_chart_hangs_together_and_looks_one_way() -> None:
    verts, faces = arrays(torus(64, 32))
    chart, adjacent = charts(verts, faces), neighbours(faces)
    assert len(np.unique(components(chart, adjacent))) == chart.max() + 1
    assert set(chart) == set(range(chart.max() + 1))
    area, normal = areas_and_normals(verts, faces)
    for one in range(chart.max() + 1):
        mine = chart == one
        axis = area[mine] @ normal[mine]
        cosine = normal[mine] @ axis / np.linalg.norm(axis)
        assert cosine.min() > np.cos(np.deg2rad(80))
        assert np.mean(cosine > module.WIDEST) > 0.97  # grown by smoothed normals


def test_borders_are_on_the_edges() -> None:
    """Of a box that is a little rough: its charts end at its edges, not a face or two beyond."""
    solid = trimesh.creation.box((1.0, 0.7, 0.3))
    for _ in range(4):
        solid = solid.subdivide()
    rough = np.random.default_rng(0).normal(0, 0.002, solid.vertices.shape)
    verts, faces = solid.vertices + rough, np.asarray(solid.faces)
    face, side = np.nonzero(neighbours(faces) >= 0)
    other = neighbours(faces)[face, side]
    chart, normal = charts(verts, faces), areas_and_normals(verts, faces)[1]
    border = chart[face] != chart[other]
    bent = (normal[face] * normal[other]).sum(1) < 0.5
    assert np.mean(bent[border]) > 0.8  # the largest face is two charts


@pytest.mark.parametrize("noise", [0.0, 0.004])
def test_their_number_is_the_shapes_not_the_faces(noise: float) -> None:
    """A ball, of 2,048 faces or 32,768, rippled or not."""
    found = [charts(*arrays(sphere(n, noise=noise / 2 ** (n - 4)))).max() + 1 for n in (4, 6)]
    assert min(found) >= 4
    assert max(found) <= 20


def test_a_box_has_at_most_two_charts_a_side() -> None:
    corner = np.array([[x, y, z] for x in (0.0, 1) for y in (0.0, 1) for z in (0.0, 1)])
    quads = [[0, 1, 3, 2], [4, 6, 7, 5], [0, 4, 5, 1], [2, 3, 7, 6], [0, 2, 6, 4], [1, 5, 7, 3]]
    faces = np.array([[q[0], q[i], q[i + 1]] for q in quads for i in (1, 2)])
    chart = charts(corner, faces)
    assert chart.max() + 1 <= 12
    area, normal = areas_and_normals(corner, faces)
    assert np.allclose(area, 0.5)
    for one in range(chart.max() + 1):
        assert np.linalg.norm(normal[chart == one].mean(0)) > module.ONE_WAY


def test_smoothing_leaves_a_plane_and_takes_ripples() -> None:
    verts, faces = arrays(sphere(5, noise=0.004))
    area, normal = areas_and_normals(verts, faces)
    centre = verts[faces].mean(1)
    out = centre / np.linalg.norm(centre, axis=1, keepdims=True)
    adjacent = neighbours(faces)
    before, after = (normal * out).sum(1), (smooth(normal, area, adjacent) * out).sum(1)
    assert before.min() < 0.9
    assert after.min() > 0.98
    flat = np.tile([0.0, 0.6, 0.8], (len(faces), 1))
    assert np.allclose(smooth(flat, area, adjacent), flat)


def strip(n: int) -> tuple[np.ndarray, np.ndarray]:
    """n squares in a row, each of two faces."""
    verts = np.array([[x, y, 0.0] for x in range(n + 1) for y in (0, 1)])
    i = 2 * np.arange(n)
    return verts, np.concatenate(
        [np.stack([i, i + 2, i + 1], 1), np.stack([i + 1, i + 2, i + 3], 1)]
    )


def test_a_tooth_goes_over_to_its_neighbours() -> None:
    faces = strip(8)[1]
    chart = np.zeros(len(faces), np.int64)
    chart[3] = 1  # between two faces of 0
    flat = np.tile([0.0, 0, 1], (len(faces), 1))
    assert not straightened(chart, neighbours(faces), flat).any()
    steep = flat.copy()
    steep[3] = (1, 0, 0)
    assert straightened(chart, neighbours(faces), steep)[3] == 1


def test_joining_stops_where_the_surface_turns(monkeypatch: pytest.MonkeyPatch) -> None:
    """Ten segments of a strip that bends by 20 degrees from each to the next: a part spans 140."""
    monkeypatch.setattr(module, "LARGEST_JOINED", 1.0)
    faces = strip(10)[1]
    adjacent, part = neighbours(faces), np.tile(np.arange(10), 2)
    angle = np.deg2rad(20) * part
    normal = np.stack([np.sin(angle), 0 * angle, np.cos(angle)], 1)
    one = merged(part.copy(), adjacent, normal, np.ones(20))
    assert one.max() + 1 == 2
    assert max(np.ptp(part[one == c]) for c in (0, 1)) <= 7
    flat = merged(part.copy(), adjacent, normal * 0 + normal[0], np.ones(20))
    assert flat.max() == 0


def test_borders_count_shared_edges() -> None:
    found = borders(np.tile(np.arange(3), 2), neighbours(strip(3)[1]))
    assert found == {0: {1: 1}, 1: {0: 1, 2: 1}, 2: {1: 1}}


def test_halving_cuts_the_long_side() -> None:
    verts, faces = strip(8)
    cut = halved(np.zeros(16, np.int64), np.array([True]), neighbours(faces), verts[faces].mean(1))
    x = verts[faces].mean(1)[:, 0]
    assert cut.max() == 1
    assert np.array_equal(cut == cut[0], x < 4)
    kept = halved(
        np.zeros(16, np.int64), np.array([False]), neighbours(faces), verts[faces].mean(1)
    )
    assert kept.max() == 0
