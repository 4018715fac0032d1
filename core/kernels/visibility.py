"""Compiled version of :mod:`core.render.visibility`, one triangle after another."""

import numpy as np

from core.kernels.compiled import compiled

HALF, ZERO, ONE = np.float32(0.5), np.float32(0), np.float32(1)
# The bounds of core.render.visibility: of a level edge's height, a span's width, and an area whose
# sign is rounding.
LEVEL, NARROW, SLIVER = np.float32(1e-30), np.float32(1e-12), np.float32(4e-7)
# By the comparisons of rows: the corners from the top row down, and whether their order is even.
ORDERS = np.array(
    ((2, 1, 0), (2, 1, 0), (1, 2, 0), (1, 0, 2), (2, 0, 1), (0, 2, 1), (0, 1, 2), (0, 1, 2))
)
EVEN = np.array([(b - a) % 3 == 1 for a, b, _ in ORDERS])


@compiled
def see(clip, faces, cull, face_id):
    """Write the nearest face of each pixel into ``face_id`` (H, W), -1 where none.

    ``clip`` (V, 4) float32, ``faces`` (F, 3) int64.
    """
    height, width = face_id.shape
    screen = np.empty((len(clip), 3), np.float32)
    before = np.empty(len(clip), np.bool_)
    for v in range(len(clip)):
        # Each vertex once for all its faces; behind the near plane the place on the screen is not
        # used.
        before[v] = clip[v, 2] + clip[v, 3] > ZERO
        _to_screen(clip[v], height, width, screen[v])
    depth = np.full((height, width), np.float32(np.inf))
    face_id[:] = -1
    corners, cut = np.empty((3, 3), np.float32), np.empty((3, 4), np.float32)
    for f in range(len(faces)):
        a, b, c = faces[f]
        seen = np.int64(before[a]) + np.int64(before[b]) + np.int64(before[c])
        if seen == 3:
            # Where the mesh is finer than the pixels, most faces end here.
            if _meets_no_centre(screen[a, 0], screen[b, 0], screen[c, 0]):
                continue
            if _meets_no_centre(screen[a, 1], screen[b, 1], screen[c, 1]):
                continue
            if cull:
                p = (screen[b, 0] - screen[a, 0]) * (screen[c, 1] - screen[a, 1])
                q = (screen[c, 0] - screen[a, 0]) * (screen[b, 1] - screen[a, 1])
                # Written with "not": a NaN is dropped too, as in the torch version.
                if not p - q <= SLIVER * (abs(p) + abs(q)):
                    continue
            corners[0], corners[1], corners[2] = screen[a], screen[b], screen[c]
            _draw(corners, f, cull, depth, face_id)
        elif seen > 0:
            # Turn the triangle so that the corner on its own side of the plane comes first.
            while before[a] != (seen == 1):
                a, b, c = b, c, a
            if before[b] == before[a] or before[c] == before[a]:
                continue
            if seen == 1:
                # One corner before the plane: a smaller triangle.
                cut[0] = clip[a]
                _on_near_plane(clip[a], clip[b], cut[1])
                _on_near_plane(clip[a], clip[c], cut[2])
                _draw_cut(cut, corners, f, cull, depth, face_id)
            else:
                # Two before it: a quadrilateral, drawn as two triangles.
                _on_near_plane(clip[b], clip[a], cut[0])
                cut[1], cut[2] = clip[b], clip[c]
                _draw_cut(cut, corners, f, cull, depth, face_id)
                cut[1] = clip[c]
                _on_near_plane(clip[c], clip[a], cut[2])
                _draw_cut(cut, corners, f, cull, depth, face_id)


@compiled
def _to_screen(clip, height, width, out):
    inverse = ONE / clip[3]
    out[0] = (clip[0] * inverse * HALF + HALF) * np.float32(width)
    out[1] = (HALF - clip[1] * inverse * HALF) * np.float32(height)
    out[2] = clip[2] * inverse * HALF + HALF


@compiled
def _meets_no_centre(a, b, c):
    return not np.ceil(max(a, b, c) - HALF) > np.ceil(min(a, b, c) - HALF)


@compiled
def _on_near_plane(before, behind, out):
    d0, d1 = before[2] + before[3], behind[2] + behind[3]
    t = d0 / (d0 - d1)
    for k in range(4):
        out[k] = before[k] + t * (behind[k] - before[k])


@compiled
def _draw_cut(cut, corners, face, cull, depth, face_id):
    for k in range(3):
        _to_screen(cut[k], face_id.shape[0], face_id.shape[1], corners[k])
    _draw(corners, face, cull, depth, face_id)


@compiled
def _draw(corners, face, cull, depth, face_id):
    """Draws one triangle row by row."""
    height, width = np.float32(face_id.shape[0]), np.float32(face_id.shape[1])
    # NaN and infinite corners are in no picture; one sum finds any of them.
    total = ZERO
    for k in range(3):
        total += corners[k, 0] + corners[k, 1] + corners[k, 2]
    if not np.isfinite(total):
        return
    y0, y1, y2 = corners[0, 1], corners[1, 1], corners[2, 1]
    code = 4 * (y0 <= y1) + 2 * (y1 <= y2) + (y0 <= y2)
    top, middle, bottom = ORDERS[code, 0], ORDERS[code, 1], ORDERS[code, 2]
    first = min(max(np.ceil(corners[top, 1] - HALF), ZERO), height)
    last = min(np.ceil(corners[bottom, 1] - HALF), height)
    for row in range(int(first), int(last)):
        y = np.float32(row) + HALF
        # The long edge on one side, the short one that the row meets on the other.
        x0, z0 = _cross(corners, top, bottom, y)
        if y >= corners[middle, 1]:
            x1, z1 = _cross(corners, middle, bottom, y)
        else:
            x1, z1 = _cross(corners, top, middle, y)
        # Counter-clockwise: with the corners in an even order the long edge is on the right.
        if EVEN[code] if cull else x0 > x1:
            x0, z0, x1, z1 = x1, z1, x0, z0
        # Half open: from the first centre at x0 or right of it to the last one left of x1.
        begin = min(max(np.ceil(x0 - HALF), ZERO), width)
        end = min(np.ceil(x1 - HALF), width)
        slope = (z1 - z0) / max(x1 - x0, NARROW)
        z_begin = z0 + (begin + HALF - x0) * slope
        low, high = min(z0, z1), max(z0, z1)
        start = int(begin)
        for column in range(start, int(end)):
            z = z_begin + np.float32(column - start) * slope
            # Within the span's ends: a sliver's slope may be large and rounded.
            z = max(min(max(z, low), high), ZERO)
            # Of equal depths the first face: they come in order.
            if z < depth[row, column]:
                depth[row, column] = z
                face_id[row, column] = face


@compiled
def _cross(corners, upper, lower, y):
    """Column and depth where an edge crosses the row ``y``."""
    x0, y0, z0 = corners[upper, 0], corners[upper, 1], corners[upper, 2]
    x1, y1, z1 = corners[lower, 0], corners[lower, 1], corners[lower, 2]
    height = max(y1 - y0, LEVEL)
    t = y - y0
    x = x0 + t * ((x1 - x0) / height)
    return min(max(x, min(x0, x1)), max(x0, x1)), z0 + t * ((z1 - z0) / height)
