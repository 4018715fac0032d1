"""Thin faces taken out of a corner table, whatever edges they are between.

Where two solids nearly meet in a plane, their union has a step that is a thousandth of it high: a
strip of thin faces between two sharp lines, which the loops of :mod:`core.kernels.remesh` would
keep apart. A needle's short side becomes a point, a cap's long side turns (Botsch and Kobbelt, "A
Robust Procedure to Eliminate Degenerate Faces from Triangle Meshes", 2001).
"""

import numpy as np

from core.kernels.compiled import compiled
from core.kernels.corner_table import (
    RING,
    distance,
    following,
    normal_of,
    preceding,
    ring,
    triangle,
)
from core.kernels.remesh import join, may_join, turn

TURN = 0.5  # cosine, which the normal of a face that is not thin may turn by
NEEDLE = 3.0  # thicknesses: a shorter side becomes a point


@compiled
def take_out_thin(table, verts, at, count, thin):
    """Take out those of ``count`` faces whose least height is below ``thin``; how many changed."""
    corners, _, _ = table
    fans, marks = np.empty((2, RING), np.int64), np.full(len(verts), -1)
    changed = 0
    for f in range(count):
        if corners[3 * f] < 0:
            continue
        long, short = sides(verts, corners, f)
        if height(verts, corners, long) >= thin:
            continue
        length = distance(verts, corners[following(short)], corners[preceding(short)])
        short_enough = length < NEEDLE * thin
        done = short_enough and shortened(table, verts, at, short, fans, marks, thin)
        if done or cap_turned(table, verts, at, long, fans[0]):
            changed += 1
    return changed


@compiled
def sides(verts, corners, f):
    """The corners across from the longest and the shortest side of face ``f``."""
    long = short = 3 * f
    most = least = -1.0
    for c in range(3 * f, 3 * f + 3):
        d = distance(verts, corners[following(c)], corners[preceding(c)])
        if d > most:
            most, long = d, c
        if least < 0 or d < least:
            least, short = d, c
    return long, short


@compiled
def height(verts, corners, c):
    """From the edge across from corner ``c`` to it."""
    a, b, d = corners[c], corners[following(c)], corners[preceding(c)]
    _, _, _, double, _ = triangle(verts, a, b, d)
    return double / max(distance(verts, b, d), 1e-300)


@compiled
def shortened(table, verts, at, c, fans, marks, thin):
    """Make the edge across from corner ``c`` a point, if no face that is not thin turns by it."""
    corners, across, _ = table
    u, v = corners[following(c)], corners[preceding(c)]
    nu, closed_u = ring(across, at, u, fans[0])
    nv, closed_v = ring(across, at, v, fans[1])
    if nu < 0 or nv < 0 or not (closed_u and closed_v):  # an open border stays where it is
        return False
    if not may_join(table, at, c, fans[0, :nu], fans[1, :nv], marks):
        return False
    # One of the ends rather than between: it is on the surface, or on its edge.
    for end, other in ((u, v), (v, u)):
        fan, count = (fans[1], nv) if end == u else (fans[0], nu)
        if stays(verts, corners, fan[:count], verts[end], end, thin):
            for k in range(3):
                verts[other, k] = verts[end, k]
            join(table, at, c, u, fans[1, :nv])
            return True
    return False


@compiled
def stays(verts, corners, fan, place, but, thin):
    """Whether the fan's vertex may go to ``place``: no face with a direction of its own turns.

    ``but``: a vertex; faces that have it will be gone.
    """
    for c in fan:
        v, a, b = corners[c], corners[following(c)], corners[preceding(c)]
        if a == but or b == but:
            continue
        long, _ = sides(verts, corners, c // 3)
        if height(verts, corners, long) < thin:
            continue
        x, y, z, _, _ = triangle(verts, v, a, b)
        nx, ny, nz, _, _ = normal_of(place[0], place[1], place[2], verts[a], verts[b])
        if x * nx + y * ny + z * nz < TURN:
            return False
    return True


@compiled
def cap_turned(table, verts, at, c, fan):
    """Turn the edge across from corner ``c``, which is so near to it that the surface stays."""
    corners, across, _ = table
    o = across[c]
    if o < 0:
        return False
    a, b, d, e = corners[c], corners[following(c)], corners[preceding(c)], corners[o]
    x, y, z, _, _ = triangle(verts, e, d, b)
    for first, second in ((b, e), (e, d)):
        nx, ny, nz, _, _ = triangle(verts, a, first, second)
        if x * nx + y * ny + z * nz < TURN:
            return False
    # Each end keeps three faces at least, and the new edge is not there already.
    for end in (b, d):
        count, closed = ring(across, at, end, fan)
        if count < 0 or count <= (3 if closed else 2):
            return False
    count, _ = ring(across, at, a, fan)
    if count < 0:
        return False
    for corner in fan[:count]:
        if corners[following(corner)] == e or corners[preceding(corner)] == e:
            return False
    turn(table, at, c)
    return True
