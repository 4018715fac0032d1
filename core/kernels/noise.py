"""Solid noise: gradient noise and cellular noise at points of space, one point after another.

Gradient noise: K. Perlin, "Improving Noise", SIGGRAPH 2002. Cellular noise: S. Worley, "A Cellular
Texture Basis Function", SIGGRAPH 1996. Both take their random numbers from a hash of the lattice
point instead of a table, so that they have no period and each seed is another field.
"""

import math

import numpy as np

from core.kernels.compiled import compiled

MASK = 2**32 - 1
ONE, HALF = np.float32(1), np.float32(0.5)
PER_WORD = np.float32(1 / 2**32)


@compiled
def _hash(x, y, z, seed):
    """32 random bits of a lattice point."""
    h = (x * 374761393 + y * 668265263 + z * 2246822519 + seed * 3266489917) & MASK
    # Two rounds of multiply and shift (as in xxHash): neighbours share no bit pattern.
    h = ((h ^ (h >> 15)) * 2246822519) & MASK
    h = ((h ^ (h >> 13)) * 3266489917) & MASK
    return h ^ (h >> 16)


@compiled
def _slope(h, x, y, z):
    """The dot product with one of the 12 directions to a cube's edges (Perlin 2002)."""
    h &= 15
    u = x if h < 8 else y
    v = y if h < 4 else (x if h in (12, 14) else z)
    return (u if h & 1 == 0 else -u) + (v if h & 2 == 0 else -v)


@compiled
def _fade(t):
    """6 t^5 - 15 t^4 + 10 t^3: no jump of the second derivative at the lattice."""
    return t * t * t * (t * (t * np.float32(6) - np.float32(15)) + np.float32(10))


@compiled
def _gradient(px, py, pz, seed):
    x, y, z = math.floor(px), math.floor(py), math.floor(pz)
    i, j, k = np.int64(x), np.int64(y), np.int64(z)
    fx, fy, fz = np.float32(px - x), np.float32(py - y), np.float32(pz - z)
    u, v, w = _fade(fx), _fade(fy), _fade(fz)
    total = np.float32(0)
    for corner in range(8):
        a, b, c = corner >> 2, (corner >> 1) & 1, corner & 1
        h = _hash(i + a, j + b, k + c, seed)
        weight = (u if a else ONE - u) * (v if b else ONE - v) * (w if c else ONE - w)
        dx, dy, dz = fx - np.float32(a), fy - np.float32(b), fz - np.float32(c)
        total += weight * _slope(h, dx, dy, dz)
    return total


@compiled
def gradient(points, scale, weights, seed):
    """Σ_o weights[o] noise(2^o scale p) of points (N, 3); each octave in about [-1, 1].

    ``scale`` (3,) is the frequency along each axis.
    """
    out = np.zeros(len(points), np.float32)
    for i in range(len(points)):
        x, y, z = points[i, 0] * scale[0], points[i, 1] * scale[1], points[i, 2] * scale[2]
        total, grow = np.float32(0), ONE
        for octave in range(len(weights)):
            if weights[octave] != 0:
                total += weights[octave] * _gradient(x * grow, y * grow, z * grow, seed + octave)
            grow *= np.float32(2)
        out[i] = total
    return out


@compiled
def cells(points, scale, jitter, seed):
    """(N, 3) of points (N, 3): distance to the nearest feature point, to the second nearest, and
    the nearest one's own random number in [0, 1).

    Distances are in cells. ``jitter`` in [0, 1]: how far a feature point leaves its cell's middle.
    """
    out = np.empty((len(points), 3), np.float32)
    for i in range(len(points)):
        x, y, z = points[i, 0] * scale[0], points[i, 1] * scale[1], points[i, 2] * scale[2]
        ci, cj, ck = np.int64(math.floor(x)), np.int64(math.floor(y)), np.int64(math.floor(z))
        first, second, number = np.float32(1e9), np.float32(1e9), 0
        for n in range(27):
            a, b, c = ci + n // 9 - 1, cj + n // 3 % 3 - 1, ck + n % 3 - 1
            h = _hash(a, b, c, seed)
            # Three coordinates from one hash: 10 bits each are fine enough for a point.
            ox = np.float32((h & 1023) / 1023.0) - HALF
            oy = np.float32(((h >> 10) & 1023) / 1023.0) - HALF
            oz = np.float32(((h >> 20) & 1023) / 1023.0) - HALF
            dx = np.float32(a) + HALF + jitter * ox - x
            dy = np.float32(b) + HALF + jitter * oy - y
            dz = np.float32(c) + HALF + jitter * oz - z
            d = dx * dx + dy * dy + dz * dz
            if d < first:
                first, second, number = d, first, h
            elif d < second:
                second = d
        out[i, 0], out[i, 1] = math.sqrt(first), math.sqrt(second)
        # Mixed again: the low bits are the point's place.
        out[i, 2] = np.float32(_hash(number, 1, 2, seed)) * PER_WORD
    return out
