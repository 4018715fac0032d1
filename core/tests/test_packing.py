"""Charts keep their distance and their common scale; the loops do what slow twins do."""

import numpy as np
import pytest
from scipy.ndimage import binary_dilation, distance_transform_edt

from core.kernels.packing import lowest_place, mark, spans, take, widened
from core.texture.packing import Place, cells_under, in_least_box, pack, turned

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


def test_charts_keep_their_gap_and_lie_inside() -> None:
    uv, faces, chart = blobs(25)
    gap = 4 / 1024
    out = pack(uv, faces, chart, gap)
    assert out.min() >= gap
    assert out.max() <= 1 - gap
    size = 2048
    masks = [drawn(out, faces[chart == c], size) for c in range(25)]
    for c, mask in enumerate(masks):
        others = np.any(masks[:c] + masks[c + 1 :], axis=0)
        assert distance_transform_edt(~others)[mask].min() - 1 >= 2 * gap * size - 2


def test_one_scale_for_all_and_no_mirror() -> None:
    uv, faces, chart = blobs(25)
    out = pack(uv, faces, chart, 1 / 256)
    area = lambda t: np.linalg.det(t[:, 1:] - t[:, :1])  # noqa: E731
    ratio = area(out[faces]) / area(uv[faces])
    assert ratio.min() > 0
    assert np.allclose(ratio, ratio[0])


def test_they_fill_most_of_the_square() -> None:
    uv, faces, chart = blobs(60)
    out = pack(uv, faces, chart, 1 / 1024)
    assert np.linalg.det(out[faces][:, 1:] - out[faces][:, :1]).sum() / 2 > 0.6


def test_same_twice() -> None:
    assert np.array_equal(pack(*blobs(9), 1 / 256), pack(*blobs(9), 1 / 256))


def test_too_many_find_no_room() -> None:
    assert pack(*blobs(9), 0.2) is None


def test_progress_grows_and_may_stop_it() -> None:
    seen: list[float] = []
    pack(*blobs(9), 1 / 256, seen.append)
    assert seen == sorted(seen)
    assert 0 <= seen[0] <= seen[-1] < 1

    def stop(_: float) -> None:
        raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        pack(*blobs(9), 1 / 256, stop)


def test_marked_cells_are_those_with_a_point_of_the_triangle() -> None:
    """Against 300 x 300 points of each triangle; twice is counted where centres lie in two."""
    for _ in range(20):
        t = RANDOM.uniform(0, 12, (1, 3, 2))
        mask = np.zeros((12, 12), np.bool_)
        assert mark(t, mask) == 0
        share = np.sort(RANDOM.uniform(0, 1, (90_000, 2)), 1)
        weight = np.stack([share[:, 0], share[:, 1] - share[:, 0], 1 - share[:, 1]], 1)
        x, y = np.floor(weight @ t[0]).astype(int).T
        points = np.zeros_like(mask)
        points[y, x] = True
        assert not (points & ~mask).any()
        assert (mask & ~points).sum() <= 2  # touched in less than a point's reach
    square = np.array([[[0, 0], [4, 0], [4, 4]], [[0, 0], [4, 4], [0, 4]]], float)
    assert mark(square, np.zeros((5, 5), np.bool_)) == 0  # a shared edge counts once
    again = np.concatenate([square, [[[1, 1], [3, 1], [3, 3]]], [[[1, 1], [3, 3], [1, 3]]]])
    assert mark(again, np.zeros((5, 5), np.bool_)) == 4


def test_widened_is_a_dilation_by_a_square() -> None:
    for by in (1, 3):
        mask = RANDOM.uniform(size=(17, 23)) < 0.05
        right = binary_dilation(np.pad(mask, by), np.ones((2 * by + 1,) * 2))
        assert np.array_equal(widened(mask, by), right)


def test_spans_are_the_mask() -> None:
    mask = RANDOM.uniform(size=(9, 14)) < 0.5
    again = np.zeros_like(mask)
    rows = spans(mask)
    for row, first, after in rows:
        assert not again[row, first:after].any()
        again[row, first:after] = True
    assert np.array_equal(again, mask)
    assert (np.diff(rows[:, 2] - rows[:, 1]) <= 0).all()


def test_the_lowest_place_is_that_of_a_search_of_all() -> None:
    side = 24
    for _ in range(30):
        taken, run_end = np.zeros((side, side), np.bool_), np.full((side, side), side, np.int64)
        for _ in range(4):
            y, x = RANDOM.integers(-3, side, 2)
            take(taken, run_end, RANDOM.uniform(size=(6, 7)) < 0.6, y, x)
        mask = RANDOM.uniform(size=(5, 4)) < 0.4
        mask[0, 0] = True
        places = [
            (y, x)
            for y in range(side - 4)
            for x in range(side - 3)
            if not (taken[y : y + 5, x : x + 4] & mask).any()
        ]
        right = places[0] if places else (-1, -1)
        assert lowest_place(taken, run_end, spans(mask), *mask.shape) == right


@pytest.mark.parametrize("turns", [0, 1, 2, 3])
def test_a_chart_turns_with_its_cells(turns: int) -> None:
    corners = RANDOM.uniform(0, 9, (4, 3, 2))
    corners -= corners.min((0, 1))
    mask = cells_under(corners)
    at = turned(corners.reshape(-1, 2), Place(turns, 0, 0, mask.shape)).reshape(-1, 3, 2)
    again = np.zeros_like(np.rot90(mask, turns))
    mark(at, again)
    assert np.array_equal(again, np.rot90(mask, turns))


def test_the_least_box_of_a_turned_rectangle_is_its_own() -> None:
    x, y = np.meshgrid(np.linspace(0, 3, 9), np.linspace(0, 1, 9))
    flat = np.stack([x.ravel(), y.ravel()], 1)
    c, s = np.cos(0.6), np.sin(0.6)
    box = np.ptp(in_least_box(flat @ np.array([[c, s], [-s, c]])), axis=0)
    assert np.sort(box) == pytest.approx([1, 3], rel=0.08)
