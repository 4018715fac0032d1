"""Charts laid into the plane as rigidly as may be: every triangle keeps its shape and its size.

"A Local/Global Approach to Mesh Parameterization" (Liu et al. 2008, ARAP), all charts at once, from
each chart's view along its axis.
"""

import numpy as np
from jaxtyping import Bool, Float, Int
from scipy.sparse import coo_array, csc_array, eye_array
from scipy.sparse.linalg import splu

from core.geometry.faces import unit
from core.geometry.mesh import mean_around, taubin

ITERATIONS = 10
COTANGENTS = (0.05, 20.0)  # kept within: a sliver would pull with all its weight, or push
HOLD = 1e-6  # of the mean weight, to the place at the start: a chart alone may be anywhere
UNFOLDING = 40  # rounds
SMOOTHING = 10  # rounds, of the surface that gives the charts their first layout


def flatten(
    verts: Float[np.ndarray, "v 3"], faces: Int[np.ndarray, "f 3"], chart: Int[np.ndarray, " f"]
) -> tuple[Float[np.ndarray, "u 2"], Int[np.ndarray, "f 3"]]:
    """uv in the surface's own unit, and a uv index by corner; the charts overlap.

    A vertex has one uv for each chart that meets there.
    """
    key = chart[:, None] * (int(faces.max()) + 1) + faces
    _, first, face_uvs = np.unique(key, return_index=True, return_inverse=True)
    face_uvs = face_uvs.reshape(-1, 3)
    # Smoothed for the first layout only; the triangles at rest are the surface's own.
    uv = seen_along_axis(taubin(verts, faces, SMOOTHING), faces, chart, first)
    rest = at_rest(verts[faces])
    uv = unfolded(as_rigid(uv, face_uvs, rest), face_uvs)
    return uv, face_uvs


def seen_along_axis(
    verts: Float[np.ndarray, "v 3"],
    faces: Int[np.ndarray, "f 3"],
    chart: Int[np.ndarray, " f"],
    first: Int[np.ndarray, " u"],
) -> Float[np.ndarray, "u 2"]:
    """Each chart as it looks from where its normals point to; ``first``: a corner for each uv."""
    p = verts[faces]
    cross = np.cross(p[:, 1] - p[:, 0], p[:, 2] - p[:, 0])
    # The cross products are as long as twice the areas: a mean weighted by area.
    axis = unit(np.stack([np.bincount(chart, x) for x in cross.T], 1))
    # The coordinate axis farthest from the chart's: their cross product is not near 0.
    least = np.eye(3)[np.abs(axis).argmin(1)]
    right = unit(np.cross(least, axis))
    up = np.cross(axis, right)
    at, of = p.reshape(-1, 3)[first], chart[first // 3]
    return np.stack([(at * right[of]).sum(1), (at * up[of]).sum(1)], 1)


def at_rest(p: Float[np.ndarray, "f 3 3"]) -> Float[np.ndarray, "f 3 2"]:
    """Each triangle in a plane of its own, counter-clockwise."""
    along, across = p[:, 1] - p[:, 0], p[:, 2] - p[:, 0]
    length = np.linalg.norm(along, axis=1)
    x = (along * across).sum(1) / np.maximum(length, 1e-30)
    y = np.linalg.norm(np.cross(along, across), axis=1) / np.maximum(length, 1e-30)
    rest = np.zeros((len(p), 3, 2))
    rest[:, 1, 0], rest[:, 2, 0], rest[:, 2, 1] = length, x, y
    return rest


def as_rigid(
    uv: Float[np.ndarray, "u 2"], face_uvs: Int[np.ndarray, "f 3"], rest: Float[np.ndarray, "f 3 2"]
) -> Float[np.ndarray, "u 2"]:
    """The least of Liu's Eq. 2, the triangles as at ``rest`` but turned, from ``uv``."""
    # A corner's cotangent is the weight of the side across from it.
    side = np.roll(rest, -1, 1) - np.roll(rest, 1, 1)  # opposite of each corner, from next to last
    weight = cotangents(rest)
    a, b = np.roll(face_uvs, 1, 1).reshape(-1), np.roll(face_uvs, -1, 1).reshape(-1)
    laplacian = coo_array(
        (
            np.r_[weight, weight, -weight, -weight].reshape(4, -1).reshape(-1),
            (np.r_[a, b, a, b], np.r_[a, b, b, a]),
        ),
        shape=(len(uv),) * 2,
    )
    # Without it the matrix is singular: moving a whole chart costs nothing.
    hold = HOLD * weight.mean()
    # The matrix stays, so it is factorised once. It is symmetric and positive definite (positive
    # weights): an ordering for symmetric matrices, and no pivoting.
    solver = splu(
        csc_array(laplacian + hold * eye_array(len(uv))),
        permc_spec="MMD_AT_PLUS_A",
        options={"SymmetricMode": True},
        diag_pivot_thresh=0.0,
    )
    start = uv
    for _ in range(ITERATIONS):
        # Local: each triangle turned to fit its uv; global: uv that fit the turned triangles.
        pull = weight.reshape(-1, 1) * turned(uv, face_uvs, side, weight).reshape(-1, 2)
        total = [np.bincount(b, x, len(uv)) - np.bincount(a, x, len(uv)) for x in pull.T]
        uv = solver.solve(np.stack(total, 1) + hold * start)
    return uv


def cotangents(rest: Float[np.ndarray, "f 3 2"]) -> Float[np.ndarray, "f 3"]:
    """The cotangent of the angle in each corner, kept within COTANGENTS."""
    p, q = np.roll(rest, -1, 1) - rest, np.roll(rest, 1, 1) - rest
    cross = p[..., 0] * q[..., 1] - p[..., 1] * q[..., 0]
    return ((p * q).sum(-1) / np.maximum(cross, 1e-30)).clip(*COTANGENTS)


def turned(
    uv: Float[np.ndarray, "u 2"],
    face_uvs: Int[np.ndarray, "f 3"],
    side: Float[np.ndarray, "f 3 2"],
    weight: Float[np.ndarray, "f 3"],
) -> Float[np.ndarray, "f 3 2"]:
    """The sides at rest, each triangle turned to be as near to its uv as it can (Liu, §3.2)."""
    now = uv[np.roll(face_uvs, -1, 1)] - uv[np.roll(face_uvs, 1, 1)]
    x, y = side[..., 0], side[..., 1]
    cosine = (weight * (now * side).sum(-1)).sum(1)
    sine = (weight * (now[..., 1] * x - now[..., 0] * y)).sum(1)
    length = np.maximum(np.hypot(cosine, sine), 1e-30)
    c, s = (cosine / length)[:, None], (sine / length)[:, None]
    return np.stack([c * x - s * y, s * x + c * y], -1)


def unfolded(
    uv: Float[np.ndarray, "u 2"], face_uvs: Int[np.ndarray, "f 3"]
) -> Float[np.ndarray, "u 2"]:
    """``uv`` with face-down triangles smoothed by their neighbours until there are none."""
    mean = mean_around(face_uvs, len(uv))
    for _ in range(UNFOLDING):
        wrong = np.unique(face_uvs[face_down(uv, face_uvs)])
        if not len(wrong):
            break
        uv = uv.copy()
        # Half the way in each round, all from the places before it.
        uv[wrong] = (mean[wrong] @ uv + uv[wrong]) / 2
    return uv


def face_down(
    uv: Float[np.ndarray, "u 2"], face_uvs: Int[np.ndarray, "f 3"]
) -> Bool[np.ndarray, " f"]:
    """Triangles that do not run counter-clockwise."""
    a, b, c = (uv[face_uvs[:, i]] for i in range(3))
    p, q = b - a, c - a
    return p[:, 0] * q[:, 1] - p[:, 1] * q[:, 0] <= 0
