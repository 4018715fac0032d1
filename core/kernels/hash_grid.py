"""Compiled version of :mod:`core.hash_grid`'s sampling, one point after another, level by level."""

import numpy as np

from core.kernels.compiled import compiled

ONE, ZERO = np.float32(1), np.float32(0)
Y_PRIME, Z_PRIME = 2654435761 - 2**32, 805459861  # as core.hash_grid.PRIMES


@compiled
def _cell(x, resolution):
    """The cell's first node along an axis, and the place within the cell."""
    scaled = x * np.float32(resolution)
    # x = 1, the cube's far side, is in the last cell.
    node = min(np.int64(scaled), resolution - 1)
    return node, scaled - np.float32(node)


@compiled
def _row(x, y, z, side, size):
    """Table row of a node: dense where all nodes fit, else hashed."""
    if side * side * side <= size:
        return (x * side + y) * side + z
    # A hashed level has a power of two of rows, so that & is the remainder.
    return (x ^ (y * Y_PRIME) ^ (z * Z_PRIME)) & (size - 1)


@compiled
def sample(table, unit, resolutions, sizes):
    """Features (N, levels * C) of points ``unit`` (N, 3) in [0, 1]."""
    features = table.shape[1]
    out = np.zeros((len(unit), len(resolutions) * features), np.float32)
    start = 0
    for level in range(len(resolutions)):
        resolution, size = resolutions[level], sizes[level]
        for i in range(len(unit)):
            x, u = _cell(unit[i, 0], resolution)
            y, v = _cell(unit[i, 1], resolution)
            z, w = _cell(unit[i, 2], resolution)
            for corner in range(8):
                a, b, c = corner >> 2, (corner >> 1) & 1, corner & 1
                row = start + _row(x + a, y + b, z + c, resolution + 1, size)
                weight = (u if a else ONE - u) * (v if b else ONE - v) * (w if c else ONE - w)
                for k in range(features):
                    out[i, level * features + k] += weight * table[row, k]
        start += size
    return out


@compiled
def sample_backward(g, table, unit, resolutions, sizes, to_points):
    """Gradients to the table, and if ``to_points`` to ``unit``."""
    features = table.shape[1]
    grad, grad_unit = np.zeros_like(table), np.zeros_like(unit)
    start = 0
    for level in range(len(resolutions)):
        resolution, size = resolutions[level], sizes[level]
        for i in range(len(unit)):
            x, u = _cell(unit[i, 0], resolution)
            y, v = _cell(unit[i, 1], resolution)
            z, w = _cell(unit[i, 2], resolution)
            gx, gy, gz = ZERO, ZERO, ZERO
            for corner in range(8):
                a, b, c = corner >> 2, (corner >> 1) & 1, corner & 1
                row = start + _row(x + a, y + b, z + c, resolution + 1, size)
                wx = u if a else ONE - u
                wy = v if b else ONE - v
                wz = w if c else ONE - w
                along = ZERO
                for k in range(features):
                    gradient = g[i, level * features + k]
                    grad[row, k] += wx * wy * wz * gradient
                    along += gradient * table[row, k]
                # Along its own axis a corner's weight has the slope 1 or -1; the other two factors
                # stay.
                gx += along * wy * wz if a else -along * wy * wz
                gy += along * wx * wz if b else -along * wx * wz
                gz += along * wx * wy if c else -along * wx * wy
            # A cell is 1 / resolution wide: from the place within it to ``unit``.
            if to_points:
                grad_unit[i, 0] += gx * np.float32(resolution)
                grad_unit[i, 1] += gy * np.float32(resolution)
                grad_unit[i, 2] += gz * np.float32(resolution)
        start += size
    return grad, grad_unit
