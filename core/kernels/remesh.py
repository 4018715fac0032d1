"""The loops of :mod:`core.texture.remesh`, on a corner table.

``kind`` of a vertex: FREE, on a line of kept edges (LINE), or HELD. ``counts``: the vertices and
the faces in use, gaps among them. ``want`` (V): the wanted length of the edges at a vertex.
"""

import numpy as np

from core.kernels.compiled import compiled
from core.kernels.corner_table import (
    RING,
    distance,
    following,
    link,
    normal_of,
    preceding,
    ring,
    triangle,
)
from core.kernels.quadrics import best_place, misfit

FREE, LINE, HELD = 0, 1, 2
SPLIT, COLLAPSE = 4 / 3, 4 / 5  # of the wanted length (Botsch and Kobbelt 2004, §4)
TURN = 0.8  # cosine, which a face's normal may turn by in one move
TURN_JOINED = 0.3  # and where an edge becomes a point, which may be across a sharp edge
TURN_FITTED = 0.3  # and where an edge turns into a sharp one
FLAT = 0.8  # cosine between two faces whose common edge may turn for their shape's sake
FIT = 0.12  # of an edge's length: a distance from the surface that is none
SLIVER = 1e-3  # quality (1: equilateral) of a face that has no direction


@compiled
def moves_well(verts, corners, fan, n, place, but, least):
    """Whether the fan's vertex may go to ``place``: no face folds or becomes a sliver.

    ``but``: a vertex; faces that have it are passed over, since they will be gone. -1: none.
    """
    for i in range(n):
        v, a, b = corners[fan[i]], corners[following(fan[i])], corners[preceding(fan[i])]
        if but >= 0 and (a == but or b == but):
            continue
        x, y, z, _, fine = triangle(verts, v, a, b)
        nx, ny, nz, _, new_fine = normal_of(place[0], place[1], place[2], verts[a], verts[b])
        if new_fine < SLIVER and new_fine < fine:
            return False
        # A sliver has no direction worth keeping.
        if x * nx + y * ny + z * nz < least and fine > SLIVER:
            return False
    return True


@compiled
def split_long(table, verts, quadrics, kind, at, want, counts):
    """Halve edges longer than SPLIT times ``want``."""
    corners, across, kept = table
    for c in range(3 * counts[1]):
        if corners[c] < 0 or across[c] > c:
            continue  # each edge from one side
        n, p, o, m = following(c), preceding(c), across[c], counts[0]
        b, d = corners[n], corners[p]
        if distance(verts, b, d) <= SPLIT * (want[b] + want[d]) / 2:
            continue
        if m + 1 > len(verts) or 3 * (counts[1] + 2) > len(corners):
            return
        for k in range(3):
            verts[m, k] = (verts[b, k] + verts[d, k]) / 2
        quadrics[m] = (quadrics[b] + quadrics[d]) / 2
        want[m], kind[m] = (want[b] + want[d]) / 2, LINE if kept[c] else FREE
        counts[0] += 1
        # The face (a, b, d) becomes (a, b, m) and (a, m, d).
        c2 = halved(table, c, m, counts)
        at[m], at[d], at[b] = p, c2 + 2, n
        if o >= 0:  # and (e, d, b) beyond the edge (e, d, m) and (e, m, b)
            o2 = halved(table, o, m, counts)
            link(across, c, o2)
            link(across, c2, o)


@compiled
def halved(table, c, m, counts):
    """The face of corner ``c`` cut from there to ``m``; the new face's first corner, at c's vertex.

    The new face gets the previous corner's vertex.
    """
    corners, across, kept = table
    n, p, c2 = following(c), preceding(c), 3 * counts[1]
    counts[1] += 1
    corners[c2], corners[c2 + 1], corners[c2 + 2] = corners[c], m, corners[p]
    corners[p] = m
    across[c2] = -1
    across[c2 + 1] = -1
    link(across, c2 + 1, across[n])
    link(across, n, c2 + 2)
    kept[c2], kept[c2 + 1], kept[c2 + 2] = kept[c], kept[n], False
    kept[n] = False
    return c2


@compiled
def collapse_short(table, verts, quadrics, kind, at, want, counts):
    """Make edges shorter than COLLAPSE times ``want`` a point, where the topology stays."""
    corners, across, kept = table
    fan_u, fan_v = np.empty(RING, np.int64), np.empty(RING, np.int64)
    place, marks = np.empty(3), np.full(len(verts), -1)
    for c in range(3 * counts[1]):
        if corners[c] < 0 or across[c] > c:
            continue
        u, v = corners[following(c)], corners[preceding(c)]
        if distance(verts, u, v) >= COLLAPSE * (want[u] + want[v]) / 2:
            continue
        if kind[v] > kind[u]:
            u, v = v, u
        # A line stays a line, and what is held stays where it is.
        if kind[v] == HELD or (kind[v] == LINE and not kept[c]):
            continue
        even = 0.5 if kind[u] == kind[v] else 1.0
        for k in range(3):
            place[k] = even * verts[u, k] + (1 - even) * verts[v, k]
        if kind[u] == FREE:
            best_place(quadrics[u], quadrics[v], place)
        nu, _ = ring(across, at, u, fan_u)
        nv, _ = ring(across, at, v, fan_v)
        if nu < 0 or nv < 0 or not may_join(table, at, c, fan_u[:nu], fan_v[:nv], marks):
            continue
        if too_far(verts, corners, fan_v[:nv], place, want) or (
            even < 1 and too_far(verts, corners, fan_u[:nu], place, want)
        ):
            continue
        if moves_well(verts, corners, fan_u, nu, place, v, TURN_JOINED) and moves_well(
            verts, corners, fan_v, nv, place, u, TURN_JOINED
        ):
            verts[u] = place
            quadrics[u] += quadrics[v]
            join(table, at, c, u, fan_v[:nv])


@compiled
def too_far(verts, corners, fan, place, want):
    """Whether an edge from ``place`` to the fan's rim would be split again."""
    for c in fan:
        for w in (corners[following(c)], corners[preceding(c)]):
            d = 0.0
            for k in range(3):
                d += (verts[w, k] - place[k]) ** 2
            if np.sqrt(d) > SPLIT * want[w]:
                return True
    return False


@compiled
def may_join(table, at, c, fan_u, fan_v, marks):
    """Whether the two ends of corner ``c``'s edge may become one and leave a manifold."""
    corners, across, kept = table
    o = across[c]
    other, closing = np.empty(RING, np.int64), 0
    for tip in (c, o):
        if tip < 0:
            continue
        closing += 1
        n, p = following(tip), preceding(tip)
        if (across[n] < 0 and across[p] < 0) or (kept[n] and kept[p]):
            return False
        count, closed = ring(across, at, corners[tip], other)
        if count < 0 or (closed and count <= 3):
            return False
    # Link condition: their common neighbours are those of the edge's faces alone.
    for corner in fan_u:
        for w in (corners[following(corner)], corners[preceding(corner)]):
            marks[w] = c
    common = 0
    for corner in fan_v:
        for w in (corners[following(corner)], corners[preceding(corner)]):
            if marks[w] == c:
                common += 1
                marks[w] = -1
    # v itself is a neighbour of u, but not of v.
    return common == closing


@compiled
def join(table, at, c, u, fan_v):
    """The edge of corner ``c`` made the vertex ``u``; ``fan_v``: the corners at its other end."""
    corners, across, kept = table
    tips = (c, across[c])
    at[corners[fan_v[0]]] = -1
    for corner in fan_v:
        corners[corner] = u
    for tip in tips:
        if tip < 0:
            continue
        n, p = following(tip), preceding(tip)
        x, y, stays = across[n], across[p], kept[n] or kept[p]
        for side in (x, y):
            if side >= 0:
                kept[side] = stays
        link(across, x, y)
        for corner in (tip, n, p):
            corners[corner] = across[corner] = -1
        # The corners of the neighbour's that are at both ends of the common edge.
        side = x if x >= 0 else y
        for corner in (following(side), preceding(side)):
            at[corners[corner]] = corner


@compiled
def flip_edges(table, verts, quadrics, at, counts, by_shape):
    """Turn edges within flat places: for six faces round a vertex, or ``by_shape`` of the faces."""
    corners, across, kept = table
    fan = np.empty(RING, np.int64)
    sizes = np.zeros(4, np.int64)
    for c in range(3 * counts[1]):
        if corners[c] < 0 or across[c] > c or across[c] < 0 or kept[c]:
            continue
        n, p, o = following(c), preceding(c), across[c]
        a, b, d, e = corners[c], corners[n], corners[p], corners[o]
        x, y, z, _, fine = triangle(verts, a, b, d)
        x2, y2, z2, _, fine2 = triangle(verts, e, d, b)
        flat = x * x2 + y * y2 + z * z2
        worst = min(fine, fine2)
        nx, ny, nz, _, new = triangle(verts, a, b, e)
        nx2, ny2, nz2, _, new2 = triangle(verts, e, d, a)
        best = min(new, new2)
        now, then = misfit(quadrics, verts, b, d), misfit(quadrics, verts, a, e)
        close = FIT * distance(verts, b, d)
        fits = now > close and then < now / 2 and best > worst / 4
        if not fits and (then > max(now, close) or (flat < FLAT and worst > SLIVER)):
            continue
        # Neither new face looks away from the old ones; a sliver has no direction.
        if worst > SLIVER:
            sx, sy, sz = x + x2, y + y2, z + z2
        elif fine > fine2:
            sx, sy, sz = x, y, z
        else:
            sx, sy, sz = x2, y2, z2
        size = max(np.sqrt(sx * sx + sy * sy + sz * sz), 1e-300)
        least = TURN_FITTED if fits else TURN
        if min(nx * sx + ny * sy + nz * sz, nx2 * sx + ny2 * sy + nz2 * sz) < least * size:
            continue
        if not fits and by_shape and best <= worst + 1e-9:
            continue
        sound, gain = True, 0
        for i, v in enumerate((a, e, b, d)):
            sizes[i], closed = ring(across, at, v, fan)
            wanted = 6 if closed else 4
            change = 1 if i < 2 else -1
            gain += abs(sizes[i] - wanted) - abs(sizes[i] + change - wanted)
            sound = sound and sizes[i] > 0 and (i < 2 or sizes[i] > (3 if closed else 2))
            if i == 0:
                for k in range(max(sizes[0], 0)):
                    if corners[following(fan[k])] == e or corners[preceding(fan[k])] == e:
                        sound = False
        if sound and (fits or by_shape or (gain > 0 and best > worst / 2)):
            turn(table, at, c)


@compiled
def turn(table, at, c):
    """The edge across from corner ``c`` turned: it leads from there to the corner beyond."""
    corners, across, kept = table
    n, p, o = following(c), preceding(c), across[c]
    no, po = following(o), preceding(o)
    a, b, d, e = corners[c], corners[n], corners[p], corners[o]
    x, y = across[no], across[n]
    corners[p], corners[po] = e, a
    across[c] = across[o] = -1
    link(across, c, x)
    link(across, o, y)
    link(across, n, no)
    kept[c], kept[o] = kept[no], kept[n]
    kept[n] = kept[no] = False
    at[a], at[b], at[d], at[e] = c, n, no, o


@compiled
def wanted_places(table, verts, kind, at, counts):
    """Where each vertex would go for even faces, within its surface or its line: (V,3)."""
    corners, across, kept = table
    fan, out = np.empty(RING, np.int64), verts[: counts[0]].copy()
    for v in range(counts[0]):
        if at[v] < 0 or kind[v] == HELD:
            continue
        count, _ = ring(across, at, v, fan)
        if count < 0:
            continue
        total, sx, sy, sz = 0.0, 0.0, 0.0, 0.0
        for c in fan[:count]:
            a, b = corners[following(c)], corners[preceding(c)]
            if kind[v] == LINE:  # the middle of its neighbours along the line
                # A border's last corner is seen from one side alone.
                for w, on in ((a, kept[preceding(c)]), (b, across[following(c)] < 0)):
                    if on:
                        total += 1
                        sx, sy, sz = sx + verts[w, 0], sy + verts[w, 1], sz + verts[w, 2]
                continue
            _, _, _, size, _ = triangle(verts, v, a, b)  # the middles of its faces, by area
            total += size
            sx += size * (verts[v, 0] + verts[a, 0] + verts[b, 0]) / 3
            sy += size * (verts[v, 1] + verts[a, 1] + verts[b, 1]) / 3
            sz += size * (verts[v, 2] + verts[a, 2] + verts[b, 2]) / 3
        if total > 0 and (kind[v] == FREE or total == 2):
            out[v, 0], out[v, 1], out[v, 2] = sx / total, sy / total, sz / total
    return out


@compiled
def move(table, verts, quadrics, kind, at, places):
    """Vertices to their ``places``, as far as their quadrics let them, where no face folds."""
    corners, across, _ = table
    fan, place = np.empty(RING, np.int64), np.empty(3)
    for v in range(len(places)):
        if at[v] < 0:
            continue
        count, _ = ring(across, at, v, fan)
        if count < 0:
            continue
        for k in range(3):
            place[k] = places[v, k]
        if kind[v] == FREE:
            best_place(quadrics[v], quadrics[v], place)
        if moves_well(verts, corners, fan, count, place, -1, TURN):
            verts[v] = place


@compiled
def on_lines(points, starts, ends):
    """The nearest points (N,3) on the segments from ``starts`` to ``ends`` (S,3)."""
    out = points.copy()
    for i in range(len(points)):
        best = np.inf
        for s in range(len(starts)):
            along, length = 0.0, 0.0
            for k in range(3):
                d = ends[s, k] - starts[s, k]
                along += (points[i, k] - starts[s, k]) * d
                length += d * d
            t = min(max(along / max(length, 1e-300), 0.0), 1.0)
            away = 0.0
            for k in range(3):
                away += (points[i, k] - starts[s, k] - t * (ends[s, k] - starts[s, k])) ** 2
            if away < best:
                best = away
                for k in range(3):
                    out[i, k] = starts[s, k] + t * (ends[s, k] - starts[s, k])
    return out
