"""Compiled version of the search in :mod:`core.geometry.ray_sdf`, one ray after another."""

import numpy as np

from core.kernels.compiled import compiled

ZERO, HALF, ONE = np.float32(0), np.float32(0.5), np.float32(1)


@compiled
def lowest(volume, eye, direction, near, far, shift, extent, samples):
    """Number of each ray's smallest trilinear value of the lattice (B, P).

    ``volume`` (X, Y, Z), ``eye`` (B, 3), ``direction`` (B, P, 3), ``near``, ``far``, ``shift``
    (B, P), all float32. Beyond the cube of half side ``extent`` its nearest values count.
    """
    views, rays = near.shape
    found = np.empty((views, rays), np.int64)
    last = np.empty(3, np.float32)
    for axis in range(3):
        last[axis] = np.float32(volume.shape[axis] - 1)
    start, move = np.empty(3, np.float32), np.empty(3, np.float32)
    count = np.float32(samples)
    for b in range(views):
        for p in range(rays):
            # In nodes, the place is linear in the sample's number.
            length = far[b, p] - near[b, p]
            first = near[b, p] + length * (shift[b, p] / count)
            for axis in range(3):
                scale = HALF * last[axis] / extent
                start[axis] = (eye[b, axis] + direction[b, p, axis] * first + extent) * scale
                move[axis] = direction[b, p, axis] * (length / count) * scale
            best, number = np.float32(np.inf), 0
            for k in range(samples):
                value = _trilinear(volume, start, move, np.float32(k), last)
                if value < best:
                    best, number = value, k
            found[b, p] = number
    return found


@compiled
def _trilinear(volume, start, move, k, last):
    x = min(max(start[0] + move[0] * k, ZERO), last[0])
    y = min(max(start[1] + move[1] * k, ZERO), last[1])
    z = min(max(start[2] + move[2] * k, ZERO), last[2])
    # The last node belongs to the cell before it.
    i = min(np.int64(x), volume.shape[0] - 2)
    j = min(np.int64(y), volume.shape[1] - 2)
    h = min(np.int64(z), volume.shape[2] - 2)
    u, v, w = x - np.float32(i), y - np.float32(j), z - np.float32(h)
    total = ZERO
    for dx in range(2):
        for dy in range(2):
            row = volume[i + dx, j + dy]
            along = row[h] * (ONE - w) + row[h + 1] * w
            total += along * (u if dx else ONE - u) * (v if dy else ONE - v)
    return total
