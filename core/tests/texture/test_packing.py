"""Charts keep their distance and their common scale; as a slow reference has it."""

import time
from typing import Any

import numpy as np
import pytest
from scipy.ndimage import binary_dilation, distance_transform_edt

from core.kernels.cells import mark
from core.texture import packing
from core.texture.packing import PASSES, REST, in_least_box, pack
from core.texture.placing import cells_of, placed

RANDOM = np.random.default_rng(0)


def blobs(count: int, seed: int = 0) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Fans of triangles about a middle, one a chart, of many sizes."""
    random, uv, faces = np.random.default_rng(seed), [], []
    for i in range(count):
        angle = np.arange(12) * (np.pi / 6)
        radius = random.uniform(0.5, 1, 12) * random.uniform(0.3, 1)
        rim = np.stack([radius * np.cos(angle), 0.5 * radius * np.sin(angle)], 1)
        uv.append(np.concatenate([[[0, 0]], rim]))
        ring = 1 + np.arange(12)
        faces.append(13 * i + np.stack([0 * ring, ring, np.roll(ring, -1)], 1))
    return np.concatenate(uv), np.concatenate(faces), np.repeat(np.arange(count), 12)


def drawn(uv: np.ndarray, faces: np.ndarray, size: int) -> np.ndarray:
    mask = np.zeros((size, size), np.bool_)
    mark(uv[faces] * size, mask)
    return mask


def test_charts_keep_their_gap_and_are_inside() -> None:
    uv, faces, chart = blobs(25)
    gap = 4 / 1024
    out = pack(uv, faces, chart, gap)
    assert out.min() >= gap
    assert out.max() <= 1 - gap
    size = 2048
    masks = [drawn(out, faces[chart == c], size) for c in range(25)]
    every = np.sum(masks, axis=0, dtype=np.uint8)
    least = 2 * gap * size - 2
    for mask in masks:
        # Around the chart alone: what is farther from it than the gap is far enough.
        box = tuple(
            slice(max(0, at.min() - int(least) - 3), at.max() + int(least) + 4)
            for at in np.nonzero(mask)
        )
        others = every[box] > mask[box]
        distance = distance_transform_edt(~others)[mask[box]].min() if others.any() else np.inf
        assert distance - 1 >= least


def test_one_scale_for_all_and_no_mirror() -> None:
    uv, faces, chart = blobs(25)
    out = pack(uv, faces, chart, 1 / 256)
    area = lambda t: np.linalg.det(t[:, 1:] - t[:, :1])  # noqa: E731
    ratio = area(out[faces]) / area(uv[faces])
    assert ratio.min() > 0
    assert np.allclose(ratio, ratio[0], rtol=0.02)


def test_a_corner_of_a_face_without_area_stays_with_its_chart(monkeypatch) -> None:
    """xatlas left it at the origin: a generated asset had eight faces right across its atlas."""
    monkeypatch.setattr(packing, "FEW", 0)  # xatlas's own places, as an atlas of many charts has
    uv, faces, chart = blobs(9)
    ears = []
    for a, b in ((1, 2), (14, 15)):  # beyond the rim, on the line through the rim's edge
        ears.append(uv[b] + 0.5 * (uv[b] - uv[a]))
    uv = np.concatenate([uv, ears])
    faces = np.concatenate([faces, [[1, 2, len(uv) - 2], [14, 15, len(uv) - 1]]])
    chart = np.concatenate([chart, [0, 1]])
    out = pack(uv, faces, chart, 1 / 256)
    scale = np.sqrt(np.linalg.det(out[faces[0]][1:] - out[faces[0]][:1])) / np.sqrt(
        np.linalg.det(uv[faces[0]][1:] - uv[faces[0]][:1])
    )
    for ear, near in ((-2, 1), (-1, 14)):
        wanted = scale * np.linalg.norm(uv[ear] - uv[near])
        assert np.linalg.norm(out[ear] - out[near]) == pytest.approx(wanted, abs=0.01)


def test_they_fill_most_of_the_square() -> None:
    uv, faces, chart = blobs(60)
    out = pack(uv, faces, chart, 1 / 1024)
    assert np.linalg.det(out[faces][:, 1:] - out[faces][:, :1]).sum() / 2 > 0.6


def test_a_chart_without_room_is_none_and_one_with_room_is_where_it_is_free() -> None:
    """Masks of the placed charts, drawn again, share no cell: each in the best of its turns."""
    uv, faces, chart = blobs(12)
    found = packing.charts_of(uv, faces, chart)
    random = np.random.default_rng(0)
    assert placed(cells_of(found, 1000.0, 1), 100, random) is None
    at = placed(cells_of(found, 60.0, 1), 250, random)
    assert min(x.min() for x in at) >= 0
    assert max(x.max() for x in at) <= 250
    count = np.zeros((252, 252), int)
    for one, places in zip(found, at, strict=True):
        mask = np.zeros((252, 252), np.bool_)
        mark(places[one.corners] + 1, mask)
        count += binary_dilation(mask, np.ones((3, 3)))
    assert count.max() == 1
    turn = np.linalg.det(at[0][found[0].corners][:, 1:] - at[0][found[0].corners][:, :1])
    assert (turn > 0).all()  # no mirror


def test_our_own_packing_is_closer_than_xatlas_alone(monkeypatch) -> None:
    area = lambda out, faces: np.linalg.det(out[faces][:, 1:] - out[faces][:, :1]).sum() / 2  # noqa: E731
    uv, faces, chart = blobs(30)
    both = area(pack(uv, faces, chart, 4 / 1024), faces)
    monkeypatch.setattr(packing, "FEW", 0)
    assert both > area(pack(uv, faces, chart, 4 / 1024), faces) + 0.02


def test_same_twice() -> None:
    assert np.array_equal(pack(*blobs(9), 1 / 256), pack(*blobs(9), 1 / 256))


def test_too_many_find_no_room(monkeypatch) -> None:
    monkeypatch.setattr(packing, "PASSES", 1)
    assert pack(*blobs(9), 0.2) is None


def test_no_scale_is_tried_at_which_a_chart_is_longer_than_the_square(monkeypatch) -> None:
    """By its area alone a needle would be millions of cells long, which xatlas leaves out."""
    scales = []

    def watched(atlas, uv, face_uvs, scale, *rest):
        scales.append(scale)
        return laid_out(atlas, uv, face_uvs, scale, *rest)

    laid_out, own = packing.laid_out, packing.cells_of
    monkeypatch.setattr(packing, "laid_out", watched)
    monkeypatch.setattr(packing, "cells_of", lambda *x: scales.append(x[1]) or own(*x))
    needle = np.array([[0.0, 0], [1, 0], [0.5, 1e-7]])
    pack(needle, np.array([[0, 1, 2]]), np.zeros(1, np.int64), 1 / 256)
    assert scales and max(scales) <= packing.CELLS


def test_progress_grows_and_may_stop_it() -> None:
    seen: list[float] = []
    pack(*blobs(9), 1 / 256, seen.append)
    assert seen == sorted(seen)
    assert 0 <= seen[0] <= seen[-1] < 1

    def stop(_: float) -> None:
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        pack(*blobs(9), 1 / 256, stop)


def test_no_atlas_ends_before_its_threads_sleep(monkeypatch) -> None:
    """xatlas waits for ever at the end of one that has just worked, once in thousands of times."""
    rests = []

    class Watched(packing.xatlas.Atlas):
        def generate(self, *options: Any) -> None:
            super().generate(*options)
            self.since = time.monotonic()

        def __del__(self) -> None:
            rests.append(time.monotonic() - self.since)

    def stop(part: float) -> None:
        if part > 0.3:
            raise KeyboardInterrupt

    monkeypatch.setattr(packing.xatlas, "Atlas", Watched)
    monkeypatch.setattr(packing, "FEW", 0)  # xatlas alone, in all its passes
    pack(*blobs(9), 1 / 256)
    assert len(rests) == PASSES
    with pytest.raises(KeyboardInterrupt):
        pack(*blobs(9), 1 / 256, stop)
    assert PASSES < len(rests) < 2 * PASSES
    assert min(rests) >= REST


def test_marked_cells_are_those_with_a_point_of_the_triangle() -> None:
    """Against 300 x 300 points of each triangle; twice is counted where centres are in two."""
    for _ in range(20):
        t = RANDOM.uniform(0, 12, (1, 3, 2))
        mask = np.zeros((12, 12), np.bool_)
        assert mark(t, mask) == 0
        fraction = np.sort(RANDOM.uniform(0, 1, (90_000, 2)), 1)
        weight = np.stack([fraction[:, 0], fraction[:, 1] - fraction[:, 0], 1 - fraction[:, 1]], 1)
        x, y = np.floor(weight @ t[0]).astype(int).T
        points = np.zeros_like(mask)
        points[y, x] = True
        assert not (points & ~mask).any()
        assert (mask & ~points).sum() <= 2  # touched in less than a point's reach
    square = np.array([[[0, 0], [4, 0], [4, 4]], [[0, 0], [4, 4], [0, 4]]], float)
    assert mark(square, np.zeros((5, 5), np.bool_)) == 0  # a shared edge counts once
    again = np.concatenate([square, [[[1, 1], [3, 1], [3, 3]]], [[[1, 1], [3, 3], [1, 3]]]])
    assert mark(again, np.zeros((5, 5), np.bool_)) == 4


def test_the_least_box_of_a_turned_rectangle_is_its_own() -> None:
    x, y = np.meshgrid(np.linspace(0, 3, 9), np.linspace(0, 1, 9))
    flat = np.stack([x.ravel(), y.ravel()], 1)
    c, s = np.cos(0.6), np.sin(0.6)
    box = np.ptp(in_least_box(flat @ np.array([[c, s], [-s, c]])), axis=0)
    assert np.sort(box) == pytest.approx([1, 3], rel=0.08)
