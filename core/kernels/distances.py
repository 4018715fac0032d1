"""Signed distances of many points from simple solids about the origin, negative inside.

Inigo Quilez, "Distance functions" and "2D distance functions" (iquilezles.org).
"""

import numpy as np

from core.kernels.compiled import compiled

STEEPEST = 0.99  # sine of a capsule's side
ADDS = 12.0  # softnesses: what is farther adds nothing to a smooth union


@compiled
def ellipsoid(p, radii):
    """(n,) of points (n, 3), to first order."""
    out = np.empty(len(p))
    for i in range(len(p)):
        first, second = 0.0, 0.0
        for k in range(3):
            x = p[i, k] / radii[k]
            first += x * x
            second += (x / radii[k]) ** 2
        first = np.sqrt(first)
        out[i] = first * (first - 1) / max(np.sqrt(second), 1e-9)
    return out


@compiled
def box(p, lengths):
    """(n,) from a box: half its sizes, and the radius of its edges."""
    out = np.empty(len(p))
    rim = lengths[3]
    for i in range(len(p)):
        outside, most = 0.0, -np.inf
        for k in range(3):
            q = abs(p[i, k]) - (lengths[k] - rim)
            most = max(most, q)
            if q > 0:
                outside += q * q
        out[i] = np.sqrt(outside) + min(most, 0.0) - rim
    return out


@compiled
def frustum(p, lengths):
    """(n,) from a cone without its tip: half its height, the radii below and above, its rims'."""
    out = np.empty(len(p))
    rim = lengths[3]
    half, below, above = lengths[0] - rim, lengths[1] - rim, lengths[2] - rim
    long = max((above - below) ** 2 + 4 * half * half, 1e-12)
    for i in range(len(p)):
        across, up = np.hypot(p[i, 0], p[i, 1]), p[i, 2]
        # From the lower end, the upper one, and the side.
        low = max(across - max(below, 0.0), 0.0) ** 2 + (up + half) ** 2
        high = max(across - max(above, 0.0), 0.0) ** 2 + (up - half) ** 2
        along = ((across - below) * (above - below) + (up + half) * 2 * half) / long
        along = min(max(along, 0.0), 1.0)
        x = across - below - along * (above - below)
        y = up + half - along * 2 * half
        nearest = np.sqrt(min(low, high, x * x + y * y))
        side = (across - below) * 2 * half - (up + half) * (above - below)
        out[i] = (-nearest if abs(up) < half and side < 0 else nearest) - rim
    return out


@compiled
def capsule(p, lengths):
    """(n,) from the hull of two balls: half the distance of their middles, the radii."""
    out = np.empty(len(p))
    half, below, above = lengths[0], lengths[1], lengths[2]
    sine = min(max((below - above) / (2 * half), -STEEPEST), STEEPEST)
    cosine = np.sqrt(1 - sine * sine)
    for i in range(len(p)):
        across, up = np.hypot(p[i, 0], p[i, 1]), p[i, 2] + half
        along = up * cosine - across * sine
        if along < 0:
            out[i] = np.hypot(across, up) - below
        elif along > 2 * half * cosine:
            out[i] = np.hypot(across, up - 2 * half) - above
        else:
            out[i] = across * cosine + up * sine - below
    return out


@compiled
def outline(p, start, end):
    """(n,) of points (n, 2) from the sides of flat loops, (m, 2) each; inside by the even-odd
    rule."""
    out = np.empty(len(p))
    for i in range(len(p)):
        x, y = p[i, 0], p[i, 1]
        nearest, inside = np.inf, False
        for k in range(len(start)):
            ay, by = start[k, 1], end[k, 1]
            ex, ey = end[k, 0] - start[k, 0], by - ay
            wx, wy = x - start[k, 0], y - ay
            along = (wx * ex + wy * ey) / max(ex * ex + ey * ey, 1e-12)
            along = min(max(along, 0.0), 1.0)
            dx, dy = wx - along * ex, wy - along * ey
            nearest = min(nearest, dx * dx + dy * dy)
            if (y >= ay) != (y >= by) and (ex * wy - ey * wx > 0) == (ey > 0):
                inside = not inside
        nearest = np.sqrt(nearest)
        out[i] = -nearest if inside else nearest
    return out


@compiled
def pipes(p, curves):
    """From round curves: points (m, 4) with radii, apart where a radius is not finite; to first
    order where they taper.

    Returns the distance (n,), the point of the curves that the nearest segment begins at (n,), and
    how far along that it is (n,), 0 to 1.
    """
    out, row, along = np.empty(len(p)), np.zeros(len(p), np.int64), np.zeros(len(p))
    for i in range(len(p)):
        nearest = np.inf
        for k in range(len(curves) - 1):
            if not (np.isfinite(curves[k, 3]) and np.isfinite(curves[k + 1, 3])):
                continue
            dot, square = 0.0, 0.0
            for c in range(3):
                way = curves[k + 1, c] - curves[k, c]
                dot += way * (p[i, c] - curves[k, c])
                square += way * way
            t = min(max(dot / max(square, 1e-12), 0.0), 1.0)
            off = 0.0
            for c in range(3):
                off += (p[i, c] - (1 - t) * curves[k, c] - t * curves[k + 1, c]) ** 2
            off = np.sqrt(off) - (1 - t) * curves[k, 3] - t * curves[k + 1, 3]
            if off < nearest:
                nearest, row[i], along[i] = off, k, t
        out[i] = nearest
    return out, row, along


@compiled
def smooth_union(p, curves, softness):
    """(n,) from what flows together of round curves: points (m, 5) with radii and how many times as
    wide along x they are, apart where a radius is not finite; to first order.

    The smooth minimum is exponential: Quilez, "Smooth minimum". A curve that is far from what is
    nearest adds nothing.
    """
    starts = [0] + [k + 1 for k in range(len(curves)) if not np.isfinite(curves[k, 3])]
    ends = [start - 1 for start in starts[1:]] + [len(curves)]
    bounds = np.empty((len(starts), 4))
    for m in range(len(starts)):
        own = curves[starts[m] : ends[m]]
        for c in range(3):
            bounds[m, c] = (own[:, c].min() + own[:, c].max()) / 2
        bounds[m, 3] = 0.0
        for k in range(len(own)):
            away = np.sqrt(((own[k, :3] - bounds[m, :3]) ** 2).sum())
            bounds[m, 3] = max(bounds[m, 3], away + own[k, 3] * max(own[k, 4], 1.0))
    out, each = np.empty(len(p)), np.empty(len(starts))
    for i in range(len(p)):
        nearest = np.inf
        for m in range(len(starts)):
            away = 0.0
            for c in range(3):
                away += (p[i, c] - bounds[m, c]) ** 2
            each[m] = np.sqrt(away) - bounds[m, 3]
        for m in np.argsort(each):
            if each[m] > nearest + ADDS * softness:
                each[m] = np.inf
                continue
            each[m] = _round_curve(p[i], curves[starts[m] : ends[m]])
            nearest = min(nearest, each[m])
        total = 0.0
        for m in range(len(starts)):
            total += np.exp((nearest - each[m]) / softness)
        out[i] = nearest - softness * np.log(total)
    return out


@compiled
def _round_curve(p, curve):
    here = np.inf
    for k in range(len(curve) - 1):
        dot, square = 0.0, 0.0
        for c in range(3):
            way = curve[k + 1, c] - curve[k, c]
            dot += way * (p[c] - curve[k, c])
            square += way * way
        t = min(max(dot / max(square, 1e-12), 0.0), 1.0)
        wide = (1 - t) * curve[k, 4] + t * curve[k + 1, 4]
        off = ((p[0] - (1 - t) * curve[k, 0] - t * curve[k + 1, 0]) / wide) ** 2
        for c in range(1, 3):
            off += (p[c] - (1 - t) * curve[k, c] - t * curve[k + 1, c]) ** 2
        off = np.sqrt(off) - (1 - t) * curve[k, 3] - t * curve[k + 1, 3]
        here = min(here, off * min(wide, 1.0))
    return here
