"""The loops of :mod:`core.geometry.planar`."""

import numpy as np

from core.kernels.compiled import compiled

LEAST_COSINE, FARTHEST = 0.3, 1.6  # to a plane that a face may take, and cells off it


@compiled
def connected(seed, plane, least, far, normal, middle, part, label, adjacent, mark, stamp, queue):
    """How many faces are connected to ``seed`` along a plane; they come first in ``queue`` (F,).

    ``plane`` (4,) is a normal and an offset. A region grows over a face where it is of the seed's
    ``part``, has no ``label`` yet, its ``normal`` makes an angle with the plane's of at least the
    cosine ``least``, and its ``middle`` is within ``far`` of the plane. ``mark`` (F,) is ``stamp``
    where one was.
    """
    queue[0], mark[seed], first, last = seed, stamp, 0, 1
    while first < last:
        face = queue[first]
        first += 1
        for side in range(3):
            other = adjacent[face, side]
            if other < 0 or mark[other] == stamp or label[other] >= 0 or part[other] != part[seed]:
                continue
            cosine, off = 0.0, -plane[3]
            for k in range(3):
                cosine += normal[other, k] * plane[k]
                off += middle[other, k] * plane[k]
            if cosine > least and abs(off) < far:
                mark[other], queue[last] = stamp, other
                last += 1
    return last


@compiled
def relabel(label, planes, costs, normal, middle, area, part, part_of, adjacent, length, rounds):
    """Each face takes the best of its own label, its neighbours' and none (-1), over and over.

    Besag, "On the Statistical Analysis of Dirty Pictures", 1986: iterated conditional modes. Of
    ``planes`` (P,4) with ``part_of`` (P,); the costs are those of the distance squared, of the
    angle, of having no plane, of another part than the plane's, and of a border, by its ``length``
    (F,3). Lengths are in cells.
    """
    by_distance, by_angle, none, foreign, border = costs
    for _ in range(rounds):
        changed = 0
        for face in range(len(label)):
            best, found = np.inf, label[face]
            for side in range(-2, 3):
                if side == -2:
                    mine = label[face]
                elif side == -1:
                    mine = -1
                elif adjacent[face, side] >= 0:
                    mine = label[adjacent[face, side]]
                else:
                    continue
                cost = none
                if mine >= 0:
                    cosine, off = 0.0, -planes[mine, 3]
                    for k in range(3):
                        cosine += normal[face, k] * planes[mine, k]
                        off += middle[face, k] * planes[mine, k]
                    if cosine < LEAST_COSINE or abs(off) > FARTHEST:
                        continue
                    cost = by_distance * off * off + by_angle * (1 - cosine)
                    if part_of[mine] != part[face]:
                        cost += foreign
                cost *= area[face]
                for other_side in range(3):
                    other = adjacent[face, other_side]
                    if other >= 0 and label[other] != mine:
                        cost += border * length[face, other_side]
                if cost < best - 1e-9:
                    best, found = cost, mine
            if found != label[face]:
                label[face] = found
                changed += 1
        if changed == 0:
            break
