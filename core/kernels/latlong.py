"""Twin of :meth:`core.appearance.latlong.Levels.read`, one direction after another."""

import math

import numpy as np

from core.kernels.compiled import compiled

ZERO, HALF, ONE = np.float32(0), np.float32(0.5), np.float32(1)
TINY = np.float32(1e-12)
TURN, UP = np.float32(1 / (2 * math.pi)), np.float32(1 / math.pi)


@compiled
def _to_uv(x, y, z, azimuth):
    """Place on the map, and the squared distance from the axis of the poles, 0 on it."""
    squared = x * x + y * y
    if squared < TINY:
        x, y, squared = ONE, ZERO, ZERO
    u = HALF - np.float32(math.atan2(y, x)) * TURN + azimuth
    v = np.float32(math.atan2(np.float32(math.sqrt(max(squared, TINY))), z)) * UP
    return u - np.float32(math.floor(u)), v, squared


@compiled
def _level(level, count):
    """The lower level, and the share of the one above."""
    held = min(max(level, ZERO), np.float32(count - 1))
    base = min(int(held), max(count - 2, 0))
    return base, held - np.float32(base)


@compiled
def _pixel(u, v, place):
    """The upper left of the four texels about a place, and the shares of the others."""
    x = u * place[0] + HALF
    y = v * place[1] + HALF + place[2]
    column, row = int(x), int(y)
    return column, row, x - np.float32(column), y - np.float32(row)


@compiled
def read(picture, places, azimuth, direction, level):
    """Values (N, C) of ``picture`` (C, H, W); ``azimuth`` in turns, ``places`` (L, 3)."""
    channels, count = len(picture), len(places)
    out = np.zeros((len(direction), channels), np.float32)
    for i in range(len(direction)):
        u, v, _ = _to_uv(direction[i, 0], direction[i, 1], direction[i, 2], azimuth)
        base, above = _level(level[i], count)
        for step in range(2):
            share = above if step else ONE - above
            if share == ZERO:
                continue
            column, row, fx, fy = _pixel(u, v, places[base + step])
            for c in range(channels):
                top = picture[c, row, column] * (ONE - fx) + picture[c, row, column + 1] * fx
                low = (
                    picture[c, row + 1, column] * (ONE - fx) + picture[c, row + 1, column + 1] * fx
                )
                out[i, c] += share * (top * (ONE - fy) + low * fy)
    return out


@compiled
def read_backward(g, picture, places, azimuth, direction, level):
    """Gradients to the directions and the levels."""
    channels, count = len(picture), len(places)
    to_direction, to_level = np.zeros_like(direction), np.zeros_like(level)
    for i in range(len(direction)):
        x, y, z = direction[i, 0], direction[i, 1], direction[i, 2]
        u, v, squared = _to_uv(x, y, z, azimuth)
        base, above = _level(level[i], count)
        gu, gv, gl = ZERO, ZERO, ZERO
        for step in range(min(2, count - base)):
            share = above if step else ONE - above
            column, row, fx, fy = _pixel(u, v, places[base + step])
            along, down, value = ZERO, ZERO, ZERO
            for c in range(channels):
                p, q = picture[c, row, column], picture[c, row, column + 1]
                r, s = picture[c, row + 1, column], picture[c, row + 1, column + 1]
                along += g[i, c] * ((q - p) * (ONE - fy) + (s - r) * fy)
                top, low = p + (q - p) * fx, r + (s - r) * fx
                down += g[i, c] * (low - top)
                value += g[i, c] * (top + (low - top) * fy)
            gu += share * along * places[base + step, 0]
            gv += share * down * places[base + step, 1]
            gl += value if step else -value
        if level[i] >= ZERO and level[i] <= np.float32(count - 1) and count > 1:
            to_level[i] = gl
        if squared > ZERO:
            radius = np.float32(math.sqrt(squared))
            slope = gv * UP / (squared + z * z)
            to_direction[i, 0] = gu * TURN * y / squared + slope * z * x / radius
            to_direction[i, 1] = -gu * TURN * x / squared + slope * z * y / radius
            to_direction[i, 2] = -slope * radius
    return to_direction, to_level
