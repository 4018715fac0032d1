"""Compiled versions of :mod:`core.render.rasterizer` and :mod:`core.render.antialias`, by pixel."""

import numpy as np

from core.kernels.compiled import compiled

TWO, ONE, HALF, ZERO = np.float32(2), np.float32(1), np.float32(0.5), np.float32(0)
THIRD = np.float32(1 / 3)
TINY = np.float32(np.finfo(np.float32).tiny * 1e4)


@compiled
def covered(face_id, faces):
    """Covered pixels of ``face_id`` (B, H·W): pixel, view, face (P,) and corners (P, 3)."""
    # Counted first, so that every array is made at its size.
    count = 0
    for b in range(face_id.shape[0]):
        for i in range(face_id.shape[1]):
            count += face_id[b, i] >= 0
    pixel, view = np.empty(count, np.int64), np.empty(count, np.int64)
    face, corners = np.empty(count, np.int64), np.empty((count, 3), np.int64)
    p = 0
    for b in range(face_id.shape[0]):
        for i in range(face_id.shape[1]):
            f = face_id[b, i]
            if f >= 0:
                pixel[p], view[p], face[p] = b * face_id.shape[1] + i, b, f
                corners[p, 0], corners[p, 1], corners[p, 2] = faces[f, 0], faces[f, 1], faces[f, 2]
                p += 1
    return pixel, view, face, corners


@compiled
def _weights(clip, b, corners, p, cx, cy):
    """The corners' (x, y) seen from the pixel's ray, and the weights."""
    i, j, k = corners[p, 0], corners[p, 1], corners[p, 2]
    x0, y0 = clip[b, i, 0] - clip[b, i, 3] * cx, clip[b, i, 1] - clip[b, i, 3] * cy
    x1, y1 = clip[b, j, 0] - clip[b, j, 3] * cx, clip[b, j, 1] - clip[b, j, 3] * cy
    x2, y2 = clip[b, k, 0] - clip[b, k, 3] * cx, clip[b, k, 1] - clip[b, k, 3] * cy
    w0, w1, w2 = x1 * y2 - x2 * y1, x2 * y0 - x0 * y2, x0 * y1 - x1 * y0
    return x0, y0, x1, y1, x2, y2, w0, w1, w2


@compiled
def _centre(pixel, height, width):
    column, row = pixel % width, (pixel // width) % height
    cx = np.float32(2 * column + 1) / np.float32(width) - ONE
    cy = ONE - np.float32(2 * row + 1) / np.float32(height)
    return cx, cy


@compiled
def barycentrics(clip, view, corners, pixel, height, width):
    """Perspective-correct barycentrics (P, 3), and which of them carry gradient (P,)."""
    bary = np.empty((len(pixel), 3), np.float32)
    sound = np.empty(len(pixel), np.bool_)
    for p in range(len(pixel)):
        cx, cy = _centre(pixel[p], height, width)
        _, _, _, _, _, _, w0, w1, w2 = _weights(clip, view[p], corners, p, cx, cy)
        total = w0 + w1 + w2
        # The bounds are those of core.render.rasterizer.Barycentrics.
        sound[p] = abs(total) > TINY
        if sound[p]:
            w0, w1, w2 = w0 / total, w1 / total, w2 / total
            sound[p] = max(abs(w0), abs(w1), abs(w2)) < TWO
        if not sound[p]:
            w0 = w1 = w2 = THIRD
        bary[p, 0], bary[p, 1], bary[p, 2] = w0, w1, w2
    return bary, sound


@compiled
def barycentrics_backward(g, clip, view, corners, pixel, height, width, bary, sound):
    """Gradient to ``clip`` (B, V, 4)."""
    out = np.zeros_like(clip)
    for p in range(len(pixel)):
        if not sound[p]:
            continue
        b = view[p]
        cx, cy = _centre(pixel[p], height, width)
        x0, y0, x1, y1, x2, y2, w0, w1, w2 = _weights(clip, b, corners, p, cx, cy)
        inverse = ONE / (w0 + w1 + w2)
        # Through the division by the sum, then through the cross products of the corners.
        mean = g[p, 0] * bary[p, 0] + g[p, 1] * bary[p, 1] + g[p, 2] * bary[p, 2]
        g0, g1 = (g[p, 0] - mean) * inverse, (g[p, 1] - mean) * inverse
        g2 = (g[p, 2] - mean) * inverse
        # Each corner's place enters the weights of the other two.
        _add(out[b, corners[p, 0]], g2 * y1 - g1 * y2, g1 * x2 - g2 * x1, cx, cy)
        _add(out[b, corners[p, 1]], g0 * y2 - g2 * y0, g2 * x0 - g0 * x2, cx, cy)
        _add(out[b, corners[p, 2]], g1 * y0 - g0 * y1, g0 * x1 - g1 * x0, cx, cy)
    return out


@compiled
def _add(row, gx, gy, cx, cy):
    row[0] += gx
    row[1] += gy
    # X = x - w * centre: w gets the centre's part, z nothing.
    row[3] -= gx * cx + gy * cy


@compiled
def depths(clip, view, corners, bary):
    """Depth in [0, 1] of the points (P,)."""
    out = np.empty(len(view), np.float32)
    for p in range(len(view)):
        z = w = ZERO
        for k in range(3):
            corner = clip[view[p], corners[p, k]]
            z += bary[p, k] * corner[2]
            w += bary[p, k] * corner[3]
        out[p] = z / w * HALF + HALF
    return out


@compiled
def normalize(x, eps):
    """Rows of ``x`` (N, C) at unit length, and what they were multiplied by (N,)."""
    out, scale = np.empty_like(x), np.empty(len(x), np.float32)
    for i in range(len(x)):
        square = ZERO
        for c in range(x.shape[1]):
            square += x[i, c] * x[i, c]
        scale[i] = ONE / np.sqrt(max(square, eps))
        for c in range(x.shape[1]):
            out[i, c] = x[i, c] * scale[i]
    return out, scale


@compiled
def normalize_backward(g, out, scale, eps):
    """Gradient (N, C); where the length was bounded, only the factor's."""
    result = np.empty_like(g)
    limit = ONE / np.sqrt(eps)
    for i in range(len(g)):
        along = ZERO
        if scale[i] < limit:
            for c in range(g.shape[1]):
                along += g[i, c] * out[i, c]
        for c in range(g.shape[1]):
            result[i, c] = (g[i, c] - along * out[i, c]) * scale[i]
    return result


@compiled
def weighted_sum(table, index, weight):
    """Sums (P, C) of the rows of ``table`` (N, C), by index and weight (P, K)."""
    out = np.zeros((len(index), table.shape[1]), np.float32)
    for p in range(len(index)):
        for k in range(index.shape[1]):
            for c in range(table.shape[1]):
                out[p, c] += weight[p, k] * table[index[p, k], c]
    return out


@compiled
def weighted_sum_backward(g, table, index, weight):
    """Gradients to the table (N, C) and to the weights (P, K)."""
    to_table, to_weight = np.zeros_like(table), np.zeros_like(weight)
    for p in range(len(index)):
        for k in range(index.shape[1]):
            row, w, total = index[p, k], weight[p, k], ZERO
            for c in range(table.shape[1]):
                to_table[row, c] += g[p, c] * w
                total += g[p, c] * table[row, c]
            to_weight[p, k] = total
    return to_table, to_weight


@compiled
def facing(screen, faces):
    """Whether a face is counter-clockwise on the screen, (B, F)."""
    out = np.empty((screen.shape[0], len(faces)), np.bool_)
    for b in range(screen.shape[0]):
        for f in range(len(faces)):
            i, j, k = faces[f, 0], faces[f, 1], faces[f, 2]
            x0, y0 = screen[b, i, 0], screen[b, i, 1]
            p = (screen[b, j, 0] - x0) * (screen[b, k, 1] - y0)
            q = (screen[b, k, 0] - x0) * (screen[b, j, 1] - y0)
            # Rows grow downwards: counter-clockwise has a negative area.
            out[b, f] = p < q
    return out


@compiled
def silhouette_edges(front, in_front, verts, faces, cull):
    """View and edge (S,) of the edges ``verts``, ``faces`` (E, 2) that bound the surface."""
    # Empty, but written so that numba can infer the type.
    views, edges = [np.int64(0) for _ in range(0)], [np.int64(0) for _ in range(0)]
    for b in range(front.shape[0]):
        for e in range(len(verts)):
            one, other = faces[e, 0], faces[e, 1]
            bounds = (front[b, one] or not cull) if other < 0 else front[b, one] != front[b, other]
            if bounds and in_front[b, verts[e, 0]] and in_front[b, verts[e, 1]]:
                views.append(b)
                edges.append(e)
    return np.array(views, np.int64), np.array(edges, np.int64)
