"""What can be unrolled is unrolled exactly; what cannot stretches little; nothing folds."""

import numpy as np

from core.geometry.mesh import taubin
from core.tests.meshes import sphere
from core.texture.flatten import (
    as_rigid,
    at_rest,
    cotangents,
    face_down,
    flatten,
    seen_along_axis,
    turned,
    unfolded,
)


def sheet(n: int = 12) -> tuple[np.ndarray, np.ndarray]:
    """A square of n x n quads, from 0 to 1."""
    x, y = np.meshgrid(np.arange(n + 1), np.arange(n + 1), indexing="ij")
    at = lambda i, j: (i * (n + 1) + j).reshape(-1)  # noqa: E731
    i, j = np.meshgrid(np.arange(n), np.arange(n), indexing="ij")
    p, q, r, s = at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)
    faces = np.concatenate([np.stack([p, q, r], 1), np.stack([p, r, s], 1)])
    return np.stack([x, y, 0 * x], -1).reshape(-1, 3) / n, faces


def cap(degrees: float) -> tuple[np.ndarray, np.ndarray]:
    """The part of a ball around its top."""
    verts, faces = (x.double().numpy() if x.is_floating_point() else x.numpy() for x in sphere(5))
    faces = faces[(verts[faces][..., 2] > 0.8 * np.cos(np.deg2rad(degrees))).all(1)]
    used, faces = np.unique(faces, return_inverse=True)
    return verts[used], faces.reshape(-1, 3)


def sides(p: np.ndarray) -> np.ndarray:
    return np.linalg.norm(np.roll(p, -1, 1) - p, axis=2)


def test_a_bent_sheet_unrolls_without_stretch() -> None:
    flat, faces = sheet()
    angle = 2.0 * (flat[:, 0] - 0.5)  # 114 degrees of a cylinder
    bent = np.stack([np.sin(angle) / 2, flat[:, 1], np.cos(angle) / 2], 1)
    uv, face_uvs = flatten(bent, faces, np.zeros(len(faces), np.int64))
    assert np.abs(sides(uv[face_uvs]) / sides(bent[faces]) - 1).max() < 5e-3
    assert not face_down(uv, face_uvs).any()


def test_a_cap_stretches_as_little_as_it_must() -> None:
    verts, faces = cap(60)
    uv, face_uvs = flatten(verts, faces, np.zeros(len(faces), np.int64))
    ratio = sides(uv[face_uvs]) / sides(verts[faces])
    assert 0.8 < ratio.min() < 0.97  # no map of a ball is without it
    assert 1.03 < ratio.max() < 1.25
    assert not face_down(uv, face_uvs).any()


def test_charts_are_flattened_each_by_itself() -> None:
    verts, faces = cap(50)
    chart = (verts[faces].mean(1)[:, 0] > 0).astype(np.int64)
    uv, face_uvs = flatten(verts, faces, chart)
    assert not set(face_uvs[chart == 0].reshape(-1)) & set(face_uvs[chart == 1].reshape(-1))
    both = chart == 0
    alone, alone_uvs = flatten(verts, faces[both], np.zeros(both.sum(), np.int64))
    a, b = sides(uv[face_uvs[both]]), sides(alone[alone_uvs])
    assert np.allclose(a, b, rtol=0.01)


def test_triangles_at_rest_keep_their_sides_and_run_counter_clockwise() -> None:
    p = np.random.default_rng(0).standard_normal((50, 3, 3))
    rest = at_rest(p)
    assert np.allclose(sides(rest), sides(p))
    assert not face_down(rest.reshape(-1, 2), np.arange(150).reshape(-1, 3)).any()


def test_cotangents_are_those_of_the_angles() -> None:
    right = np.array([[[0.0, 0], [2, 0], [0, 2]]])
    assert np.allclose(cotangents(right), [[0.05, 1, 1]])  # of 90 degrees it is 0, held above


def test_the_turn_is_that_of_a_singular_value_decomposition() -> None:
    random = np.random.default_rng(0)
    rest = at_rest(random.standard_normal((20, 3, 3)))
    weight, uv = cotangents(rest), random.standard_normal((60, 2))
    face_uvs = np.arange(60).reshape(-1, 3)
    side = np.roll(rest, -1, 1) - np.roll(rest, 1, 1)
    now = uv[np.roll(face_uvs, -1, 1)] - uv[np.roll(face_uvs, 1, 1)]
    found = turned(uv, face_uvs, side, weight)
    for i in range(20):
        u, _, vt = np.linalg.svd(np.einsum("k,ka,kb->ab", weight[i], now[i], side[i]))
        turn = u @ np.diag([1, np.linalg.det(u @ vt)]) @ vt
        assert np.allclose(found[i], side[i] @ turn.T)


def test_no_small_move_makes_it_more_rigid() -> None:
    verts, faces = cap(50)
    rest = at_rest(verts[faces])
    side, weight = np.roll(rest, -1, 1) - np.roll(rest, 1, 1), cotangents(rest)

    def energy(uv: np.ndarray) -> float:
        now = uv[np.roll(faces, -1, 1)] - uv[np.roll(faces, 1, 1)]
        left = now - turned(uv, faces, side, weight)
        return float((weight * np.square(left).sum(-1)).sum())

    start = verts[:, :2]
    uv = as_rigid(start, faces, rest)
    assert energy(uv) < 0.3 * energy(start)
    random = np.random.default_rng(0)
    for size in (1e-2, 1e-3):
        assert energy(uv + size * random.standard_normal(uv.shape)) > energy(uv)
        wave = size * np.sin(3 * start[:, ::-1])
        assert min(energy(uv + wave), energy(uv - wave)) > 0.999 * energy(uv)


def test_what_is_face_down_is_unfolded() -> None:
    verts, faces = sheet()
    uv = verts[:, :2].copy()
    uv[85] += (0.2, 0.15)  # across its neighbours
    assert face_down(uv, faces).any()
    assert not face_down(unfolded(uv, faces), faces).any()
    good = verts[:, :2]
    assert unfolded(good, faces) is good


def test_a_chart_is_seen_from_where_it_looks() -> None:
    verts, faces = sheet()
    turn = np.linalg.qr(np.random.default_rng(0).standard_normal((3, 3)))[0]
    turn *= np.sign(np.linalg.det(turn))
    _, first = np.unique(faces, return_index=True)
    uv = seen_along_axis(verts @ turn.T, faces, np.zeros(len(faces), np.int64), first)
    assert np.allclose(sides(uv[faces]), sides(verts[faces]))
    assert not face_down(uv, faces).any()


def test_ripples_go_and_the_size_stays() -> None:
    verts = sphere(5, noise=0.004)[0].double().numpy()
    faces = sphere(5)[1].numpy()
    calm = taubin(verts, faces, 10)
    before, after = np.linalg.norm(verts, axis=1), np.linalg.norm(calm, axis=1)
    assert after.std() < 0.5 * before.std()
    assert abs(after.mean() - 0.8) < 0.005
