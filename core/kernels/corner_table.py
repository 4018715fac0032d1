"""Triangles that know their neighbours, for the loops of :mod:`core.kernels.remesh`.

Corner ``c`` is of face ``c // 3``; the edge across from it runs from its next corner to its
previous one. ``corners[c]`` is its vertex (-1: the face is gone), ``across[c]`` the corner beyond
the edge, -1 at a border of the mesh. ``kept[c]`` is true for an edge that stays one. ``at[v]`` is a
corner at v, -1 for a vertex that is gone.
"""

import numpy as np

from core.kernels.compiled import compiled

RING = 256  # faces round one vertex: with more, its edges are left alone


@compiled
def following(c):
    """The next corner of the face."""
    return c - 2 if c % 3 == 2 else c + 1


@compiled
def preceding(c):
    """The previous corner of the face."""
    return c + 2 if c % 3 == 0 else c - 1


@compiled
def link(across, a, b):
    """Make two corners' edges one; either may be -1."""
    if a >= 0:
        across[a] = b
    if b >= 0:
        across[b] = a


@compiled
def ring(across, at, v, out):
    """The corners at ``v`` in order, in ``out``; how many, -1: too many; whether they close."""
    c, n = at[v], 0
    start = c
    while True:  # to the left, until it closes or a border ends it
        out[n] = c
        n += 1
        if n == RING:
            return -1, False
        other = across[following(c)]
        if other < 0:
            break
        c = following(other)
        if c == start:
            return n, True
    c = start
    while True:  # the rest, to the right of the start
        other = across[preceding(c)]
        if other < 0:
            return n, False
        c = preceding(other)
        out[n] = c
        n += 1
        if n == RING:
            return -1, False


@compiled
def normal_of(ax, ay, az, b, c):
    """A triangle's unit normal, twice its area, and its quality (equilateral: 1)."""
    ux, uy, uz = b[0] - ax, b[1] - ay, b[2] - az
    vx, vy, vz = c[0] - ax, c[1] - ay, c[2] - az
    wx, wy, wz = vx - ux, vy - uy, vz - uz
    nx, ny, nz = uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx
    double = np.sqrt(nx * nx + ny * ny + nz * nz)
    squares = ux * ux + uy * uy + uz * uz + vx * vx + vy * vy + vz * vz
    squares += wx * wx + wy * wy + wz * wz
    by = 1 / max(double, 1e-300)
    return nx * by, ny * by, nz * by, double, 2 * np.sqrt(3.0) * double / max(squares, 1e-300)


@compiled
def triangle(verts, a, b, c):
    """The same of three vertices."""
    return normal_of(verts[a, 0], verts[a, 1], verts[a, 2], verts[b], verts[c])


@compiled
def distance(verts, a, b):
    """Between two vertices."""
    d = 0.0
    for k in range(3):
        d += (verts[a, k] - verts[b, k]) ** 2
    return np.sqrt(d)
