"""The loops of the bilateral filter of normals (:mod:`core.geometry.bilateral`)."""

import numpy as np

from core.kernels.compiled import compiled


@compiled
def filtered_once(normals, areas, near, other, start, sigma):
    """The faces' unit normals (f, 3) after one round (Zheng et al. 2011, Eq. 4).

    Args:
        near: of each pair of faces, the second one's area times the weight of their distance.
        other: of each pair, the second face; the pairs of face i are ``start[i]`` to
            ``start[i + 1]``.
        sigma: the difference at which unit normals count as similar.
    """
    out = np.empty_like(normals)
    steep = 1 / (sigma * sigma)
    for f in range(len(normals)):
        a, b, c = normals[f]
        # The face itself: at distance 0 from itself both weights are 1.
        x, y, z = areas[f] * a, areas[f] * b, areas[f] * c
        for pair in range(start[f], start[f + 1]):
            p, q, r = normals[other[pair]]
            # |n - m|² = 2 - 2 n · m
            weight = near[pair] * np.exp((a * p + b * q + c * r - 1) * steep)
            x += weight * p
            y += weight * q
            z += weight * r
        length = max(np.sqrt(x * x + y * y + z * z), 1e-20)
        out[f] = x / length, y / length, z / length
    return out


@compiled
def towards(verts, faces, normals, count):
    """The vertices (v, 3), one step nearer to the planes of the faces around them (Sun et al. 2007,
    Eq. 9); ``count``: of faces at each vertex, 1 where there are none."""
    step = np.zeros_like(verts)
    for f in range(len(faces)):
        i, j, k = faces[f]
        x, y, z = normals[f]
        plane = 0.0
        for v in (i, j, k):
            plane += (x * verts[v, 0] + y * verts[v, 1] + z * verts[v, 2]) / 3
        for v in (i, j, k):
            off = plane - (x * verts[v, 0] + y * verts[v, 1] + z * verts[v, 2])
            step[v, 0] += off * x
            step[v, 1] += off * y
            step[v, 2] += off * z
    for v in range(len(verts)):
        for axis in range(3):
            step[v, axis] = verts[v, axis] + step[v, axis] / count[v]
    return step
