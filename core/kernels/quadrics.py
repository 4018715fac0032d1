"""Quadrics: squared distances from planes, added up (Garland and Heckbert 1997, §3.4)."""

import numpy as np

from core.kernels.compiled import compiled

HOLD = 0.05  # of a quadric's weight, to the place that is wanted: as strong as a bend of 26 degrees


@compiled
def add_planes(owner, points, normals, areas, count):
    """The sum of each owner's planes' quadrics: (count, 11), A's six, b, c, the area.

    A quadric is the squared distance x·A x - 2 b·x + c from its planes, weighed by area.
    """
    out = np.zeros((count, 11))
    for i in range(len(owner)):
        q, w = out[owner[i]], areas[i]
        x, y, z = normals[i, 0], normals[i, 1], normals[i, 2]
        d = x * points[i, 0] + y * points[i, 1] + z * points[i, 2]
        q[0] += w * x * x
        q[1] += w * x * y
        q[2] += w * x * z
        q[3] += w * y * y
        q[4] += w * y * z
        q[5] += w * z * z
        q[6] += w * d * x
        q[7] += w * d * y
        q[8] += w * d * z
        q[9] += w * d * d
        q[10] += w
    return out


@compiled
def best_place(q, r, place):
    """``place`` moved to where ``q + r`` is least, as far as that is one place."""
    w = q[10] + r[10]
    if w <= 0:
        return
    a, b, c = (q[0] + r[0]) / w, (q[1] + r[1]) / w, (q[2] + r[2]) / w
    d, e, f = (q[3] + r[3]) / w, (q[4] + r[4]) / w, (q[5] + r[5]) / w
    x = (q[6] + r[6]) / w + HOLD * place[0]
    y = (q[7] + r[7]) / w + HOLD * place[1]
    z = (q[8] + r[8]) / w + HOLD * place[2]
    a, d, f = a + HOLD, d + HOLD, f + HOLD
    # Cramer's rule; HOLD keeps the determinant from 0.
    p, s, t = d * f - e * e, c * e - b * f, b * e - c * d
    u, v, m = a * f - c * c, b * c - a * e, a * d - b * b
    by = 1 / (a * p + b * s + c * t)
    place[0] = by * (p * x + s * y + t * z)
    place[1] = by * (s * x + u * y + v * z)
    place[2] = by * (t * x + v * y + m * z)


@compiled
def misfit(quadrics, verts, a, b):
    """How far the middle of an edge from ``a`` to ``b`` is from the surface around both."""
    q, r = quadrics[a], quadrics[b]
    w = q[10] + r[10]
    if w <= 0:
        return 0.0
    x, y = (verts[a, 0] + verts[b, 0]) / 2, (verts[a, 1] + verts[b, 1]) / 2
    z = (verts[a, 2] + verts[b, 2]) / 2
    s = (q[0] + r[0]) * x * x + (q[3] + r[3]) * y * y + (q[5] + r[5]) * z * z
    s += 2 * ((q[1] + r[1]) * x * y + (q[2] + r[2]) * x * z + (q[4] + r[4]) * y * z)
    s -= 2 * ((q[6] + r[6]) * x + (q[7] + r[7]) * y + (q[8] + r[8]) * z)
    return np.sqrt(max(s + q[9] + r[9], 0.0) / w)
