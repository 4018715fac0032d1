"""Charts laid side by side in the unit square, at one scale and as large as they go.

xatlas first, then :mod:`core.texture.placing`, which mostly finds room for a larger scale.

xatlas takes the scale and makes the atlas as large as it must be, so the scale is sought at which
that is the square. It turns a chart by transposing it, which mirrors it: charts are turned here, by
chance, until one order of turns lets a larger scale fit.
"""

import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager

import numpy as np
import xatlas
from jaxtyping import Float, Int

from core.texture.placing import Chart, cells_of, placed, turned

CELLS = 512  # along the square: the steps in which xatlas looks for places
EXPECTED_FILL = 0.7  # fraction of the square that charts fill at the first scale
PASSES = 24  # at other scales and in other turns
GROWTH = 0.01  # of the scale, from one that fits to the next tried
CLOSER_PASSES = 48  # at larger scales, by our own packing
ORDERS = 6  # by chance, at one scale
CLOSER_GROWTH = (0.02, 0.004)  # of the scale: at first, and the least that is tried
FEW = 200  # charts: our own packing of more takes longer than it is worth
MANY = 500  # charts: of more, xatlas tries some places for each and not all
STRAY = 3.0  # cells: more than what xatlas rounds in placing a chart
REST = 0.25  # s from an atlas's last work to its end


class Atlases:
    """xatlas's atlases, each ended only when its threads have long been asleep.

    An atlas that ends wakes its threads without their mutex (0.0.11, ``~TaskScheduler``): one that
    is just falling asleep misses that, and the end waits for it for ever.
    """

    def __init__(self) -> None:
        self.resting: list[tuple[float, xatlas.Atlas]] = []

    def __enter__(self) -> "Atlases":
        return self

    def __exit__(self, *_: object) -> None:
        time.sleep(REST)
        self.resting.clear()

    @contextmanager
    def new(self) -> Iterator[xatlas.Atlas]:
        """One to work with."""
        rested = time.monotonic() - REST
        self.resting = [(since, atlas) for since, atlas in self.resting if since > rested]
        atlas = xatlas.Atlas()
        try:
            yield atlas
        finally:
            self.resting.append((time.monotonic(), atlas))


def pack(
    uv: Float[np.ndarray, "u 2"],
    face_uvs: Int[np.ndarray, "f 3"],
    chart: Int[np.ndarray, " f"],
    gap: float,
    progress: Callable[[float], None] = lambda _: None,
) -> Float[np.ndarray, "u 2"] | None:
    """``uv``, each chart moved and turned, all scaled equally except for xatlas's rounding to
    cells; ``gap`` is round every chart.

    ``gap`` is in parts of the square's side. None where so many charts and gaps find no room.
    """
    found = charts_of(uv, face_uvs, chart)
    few = len(found) <= FEW
    # 1e-6: a gap of a whole number of cells is not rounded up to the next.
    padding = max(1, int(np.ceil(gap * CELLS - 1e-6)))
    # The padding along the square's own sides, which the result is moved by.
    room = CELLS - 2 * padding
    area = float(triangle_areas(uv[face_uvs]).sum())
    scale = room * np.sqrt(EXPECTED_FILL / max(area, 1e-30))
    scale = min(scale, room / longest(found))
    # A fixed seed: the same mesh gives the same atlas.
    random, best, step = np.random.default_rng(0), None, GROWTH
    with Atlases() as atlases:
        for round_ in range(PASSES):
            progress(0.6 * round_ / PASSES)
            # Even rounds leave the charts upright, odd ones turn them.
            turns = random.integers(0, 4, len(found)) * (round_ % 2)
            apart = in_a_row(found, turns, len(uv))
            with atlases.new() as atlas:
                at, side = laid_out(atlas, apart, face_uvs, scale, padding, len(found) <= MANY)
            if side <= room:
                best, step = (with_strays(at, apart * scale, found), scale), GROWTH
            elif not round_ % 2:  # upright again, it had to be another scale
                step += GROWTH / 2
            if best and few:  # our own packing continues from there
                break
            if best:
                scale = best[1] * (1 + step)
            else:
                # Nothing has fitted yet: smaller by what is too much, by GROWTH at least.
                scale *= min(room / side, 1 - GROWTH)
    if best and few:
        best = closer(found, best, padding, lambda x: progress(0.6 + 0.4 * x))
    return (best[0] + padding) / CELLS if best else None


def closer(
    found: list[Chart],
    best: tuple[Float[np.ndarray, "u 2"], float],
    padding: int,
    progress: Callable[[float], None],
) -> tuple[Float[np.ndarray, "u 2"], float]:
    """``best``, the places in cells and their scale, or our own at a larger scale."""
    random, (step, least), misses = np.random.default_rng(0), CLOSER_GROWTH, 0
    scale, cells = 0.0, None
    largest = (CELLS - 2 * padding) / longest(found)
    for round_ in range(CLOSER_PASSES):
        progress(round_ / CLOSER_PASSES)
        wanted = min(best[1] * (1 + step), largest)
        if wanted <= best[1]:
            break
        if cells is None or wanted != scale:
            scale, cells = wanted, cells_of(found, wanted, padding)
        at = placed(cells, CELLS - 2 * padding, random)
        if at is not None:
            out = np.zeros_like(best[0])
            for one, places in zip(found, at, strict=True):
                out[one.uvs] = places
            best, misses = (out, scale), 0
            continue
        misses += 1
        if misses % ORDERS == 0:
            step /= 2
        if step < least:
            break
    return best


def longest(found: list[Chart]) -> float:
    """The longest side of a chart's box: no scale makes it longer than the square."""
    return max(float(one.at.max()) for one in found) + 1e-30


def in_a_row(
    found: list[Chart], turns: Int[np.ndarray, " c"], count: int
) -> Float[np.ndarray, "{count} 2"]:
    """All charts next to one another, each in so many quarter ``turns``."""
    out, x = np.zeros((count, 2)), 0.0
    for one, turn in zip(found, turns, strict=True):
        at = turned(one.at, int(turn))
        out[one.uvs] = at + np.array([x, 0.0])
        x += 1.05 * float(at[:, 0].max())
    return out


def laid_out(
    atlas: xatlas.Atlas,
    uv: Float[np.ndarray, "u 2"],
    face_uvs: Int[np.ndarray, "f 3"],
    scale: float,
    padding: int,
    thorough: bool,
) -> tuple[Float[np.ndarray, "u 2"], int]:
    """xatlas's places in a new ``atlas`` at ``scale`` cells a unit, ``padding`` cells round each
    chart; the side of the square that they take."""
    options = xatlas.PackOptions()
    atlas.add_uv_mesh(uv.astype(np.float32), face_uvs.astype(np.uint32))
    options.texels_per_unit, options.padding, options.bruteForce = scale, padding, thorough
    options.rotate_charts = options.rotate_charts_to_axis = options.create_image = False
    options.bilinear = False
    atlas.generate(xatlas.ChartOptions(), options)
    if not atlas.width:  # nothing has an area
        return np.zeros_like(uv), 1
    # xatlas has vertices of its own; ``source`` gives ours for each.
    source, _, at = atlas.get_mesh(0)
    out = np.zeros_like(uv)
    out[source] = at * np.array([atlas.width, atlas.height])
    return out, max(atlas.width, atlas.height)


def with_strays(
    at: Float[np.ndarray, "u 2"], given: Float[np.ndarray, "u 2"], found: list[Chart]
) -> Float[np.ndarray, "u 2"]:
    """``at``, with the corners that xatlas left behind moved to where their charts have gone.

    It places no face without an area in single precision, and so no corner that is of such a face
    alone: these stay in the atlas's corner, and the face would cross all charts on the way there.
    ``given``: what xatlas was given, in cells. A chart keeps its form but for the rounding.
    """
    out = at.copy()
    for one in found:
        moved = at[one.uvs] - given[one.uvs]
        way = np.median(moved, axis=0)
        stray = np.abs(moved - way).max(1) > STRAY
        # Within the atlas: a chart without any area was not placed at all.
        out[one.uvs[stray]] = np.clip(given[one.uvs[stray]] + way, 0, at.max(0))
    return out


def charts_of(
    uv: Float[np.ndarray, "u 2"], face_uvs: Int[np.ndarray, "f 3"], chart: Int[np.ndarray, " f"]
) -> list[Chart]:
    """Each chart by itself, turned so that its box is least."""
    order = np.argsort(chart, kind="stable")
    found = []
    for faces in np.split(order, np.flatnonzero(np.diff(chart[order])) + 1):
        uvs, corners = np.unique(face_uvs[faces], return_inverse=True)
        at = in_least_box(uv[uvs])
        found.append(Chart(uvs, at, corners.reshape(-1, 3)))
    return found


def in_least_box(at: Float[np.ndarray, "n 2"], steps: int = 45) -> Float[np.ndarray, "n 2"]:
    """Turned so that the box along the axes is least and upright, and moved to the origin."""
    # A quarter turn is enough: beyond it the same boxes come again.
    angles = np.arange(steps) * (np.pi / 2 / steps)
    turns = np.stack([np.cos(angles), -np.sin(angles), np.sin(angles), np.cos(angles)], 1)
    boxes = np.stack([np.ptp(at @ t.reshape(2, 2).T, axis=0).prod() for t in turns])
    at = at @ turns[boxes.argmin()].reshape(2, 2).T
    width, height = np.ptp(at, axis=0)
    if width > height:
        at = np.stack([-at[:, 1], at[:, 0]], 1)
    return at - at.min(0)


def triangle_areas(corners: Float[np.ndarray, "f 3 2"]) -> Float[np.ndarray, " f"]:
    """Without sign."""
    p, q = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    return np.abs(p[:, 0] * q[:, 1] - p[:, 1] * q[:, 0]) / 2
