"""The simple solid that a component is, up to its errors: fitted to points of its surface.

By least squares in a trust region (Branch, Coleman and Li 1999), robustly (soft L1).
"""

from collections.abc import Callable, Iterator
from typing import NamedTuple

import numpy as np
from jaxtyping import Float
from scipy.optimize import least_squares
from scipy.spatial.transform import Rotation

from core.geometry.parts.primitives import BLUR, FORMS, Points, Primitive

REACH = 1.5  # errors, at most, between the ends of a solid and of the points on it
SOFT = 0.3  # errors, beyond which a point counts less
LOGS = (-6.0, 2.0)  # of lengths: what is lost goes no farther
LIMIT = 4.0  # points' worth, of where the points end
TURNED = 3  # of the fits along the axes are turned
STEPS = 14  # evaluations of the gradient, at most
# What a solid with more freedom, or less, has to have of the other's mean error, at most.
TURNED_GAIN, ROUNDED_GAIN, EVEN_LOSS = 0.7, 0.75, 1.15
EVEN = 0.15  # of a length, by which two that are meant to be one differ at most
ASKEW = 0.98  # cosine between an axis of the points and the nearest coordinate axis
STOUT, LONG = 1.6, 1.15  # how unlike two widths may be; how much longer than wide a capsule is
# A tip is rounded off, not cut: errors, at most, of the radius where it ends, of its rounding's,
# and of its height.
TIP = 1.7, 2.5, 3.5
ENDS = 0.3  # of a surface, the ends of what is still a rod
BLOCK = 0.5  # of a surface, what is flat of a block or a disc, at the least
TUBE = 0.75  # of a ring's radius, at most, its tube's


class Faces(NamedTuple):
    """What is known of a component beforehand. Its points do not show it where it is hardly larger
    than the errors."""

    flat: bool = True  # whether it may have flat faces, more than the ends of a rod
    block: bool = False  # whether it is mostly flat, if it can be
    sharp: bool = False  # whether the edges of such a block are
    cornered: bool = False  # whether it has so many corners that it seems round


ANY = Faces()


def primitive_of(points: Points, error: float, faces: Faces = ANY) -> Primitive | None:
    """The primitive whose surface the points are on, up to errors of about ``error``; or None."""
    if faces.cornered:
        return None
    found = _primitive_of(points, error, True, not faces.sharp, BLOCK) if faces.block else None
    return found or _primitive_of(points, error, faces.flat)


def _primitive_of(
    points: Points, error: float, flat: bool, rims: bool = True, flattest: float = 0.0
) -> Primitive | None:
    """The same; ``flattest``: how much of it is flat at the least."""

    def off(one: Primitive) -> float:
        return one.off(points, error)

    def covered(one: Primitive) -> bool:
        fraction = _flat_fraction(one)
        return (flat or fraction < ENDS) and fraction >= flattest and _covered(one, points, error)

    best, limit = None, np.inf
    gain = TURNED_GAIN  # for solids along the coordinate axes
    for frame in frames_of(points):
        starts = (one for one in _starts(points, frame) if flat or one.form != "box")
        starts = (one for one in starts if not flattest or one.form in ("box", "frustum"))
        fixed = [_fitted(one, points, error) for one in starts]
        likely = sorted(fixed, key=off)[:TURNED]
        freely = [_fitted(one, points, error, turns=True) for one in likely]
        for found, needed in ((fixed, 1.0), (freely, gain)):
            one = min(filter(covered, found), key=off, default=None)
            if one is not None and off(one) < needed * limit:
                best, limit = one, off(one)
        limit, gain = limit * gain, 1.0  # the points' own are no better than any near them
    if best is None:
        return None
    if FORMS[best.form].rims and rims:
        soft = _fitted(_with_rims(best), points, error, rims=True)
        best = soft if off(soft) < ROUNDED_GAIN * off(best) else best
    best = _evened(best, off)
    both = (pointed(best, error), best)
    return next((one for one in both if one and one.fits(points, error)), None)


def pointed(one: Primitive, error: float) -> Primitive | None:
    """A frustum with the tip that a network rounds off, where little of it is missing, and no
    rims; or None."""
    if one.form != "frustum":
        return None
    half, below, above, _ = one.lengths
    wide, end = max(below, above), min(below, above)
    missing = 2 * half * end / max(wide - end, 1e-9)
    sine = (wide - end) / np.hypot(wide - end, 2 * half)
    # A ball in the tip, as large as to end where the frustum does.
    rounding = missing * sine / max(1 - sine, 1e-9)
    if (np.array([end, rounding, missing]) > np.array(TIP) * error).any():
        return None
    radii, up = ((wide, 0.0), 1) if below > above else ((0.0, wide), -1)
    center = one.center + up * missing / 2 * one.frame[:, 2]
    return one._replace(center=center, lengths=np.array([half + missing / 2, *radii, 0.0]))


def frames_of(points: Points) -> Iterator[Float[np.ndarray, "3 3"]]:
    """The coordinate axes, and the points' own where these are others."""
    yield np.eye(3)
    own = np.linalg.svd(points - points.mean(0), full_matrices=False)[2].T
    if np.abs(own).max(0).min() < ASKEW:
        yield own * np.sign(np.linalg.det(own))


def _starts(points: Points, frame: Float[np.ndarray, "3 3"]) -> Iterator[Primitive]:
    """The solid that fills the box around the points along the frame's axes, its columns."""
    local = points @ frame
    low, high = local.min(0), local.max(0)
    center, half = frame @ (low + high) / 2, ((high - low) / 2).clip(1e-3)
    upright = Rotation.from_matrix(frame).as_rotvec()
    yield Primitive("ellipsoid", center, upright, half)
    yield Primitive("box", center, upright, np.append(half, 0.0))
    for axis in range(3):
        i, j = (k for k in range(3) if k != axis)
        if max(half[i], half[j]) > STOUT * min(half[i], half[j]):
            continue
        turn = Rotation.from_matrix(frame @ np.roll(np.eye(3), axis + 1, 0)).as_rotvec()
        radius, height = (half[i] + half[j]) / 2, half[axis]
        yield Primitive("frustum", center, turn, np.array([height, radius, radius, 0.0]))
        if height > LONG * radius:
            yield Primitive("capsule", center, turn, np.array([height - radius, radius, radius]))
        if height < TUBE * radius:
            yield Primitive("ring", center, turn, np.array([radius - height, height]))


def _flat_fraction(one: Primitive) -> float:
    """The fraction of the surface that is flat."""
    if one.form != "frustum":
        return float(one.form == "box")
    half, below, above, _ = one.lengths
    ends = below**2 + above**2
    return float(ends / (ends + (below + above) * np.hypot(2 * half, below - above)))


def _covered(one: Primitive, points: Points, error: float) -> bool:
    """Whether the points are all over the surface: it ends where they do."""
    if one.form == "ring" and one.lengths[1] > TUBE * one.lengths[0]:
        return False
    verts = one.mesh(np.inf)[0].numpy()
    ends = np.stack([verts.min(0) - points.min(0), verts.max(0) - points.max(0)])
    return bool(np.abs(ends).max() < REACH * error)


def _fitted(
    start: Primitive, points: Points, error: float, *, turns: bool = False, rims: bool = False
) -> Primitive:
    """Where the points are least off; turned freely, or as it is; with its rims' radius, or not."""
    count = len(start.lengths) - (FORMS[start.form].rims and not rims)
    fixed = start.lengths[count:]

    def of(x: np.ndarray) -> Primitive:
        turn = x[3:6] if turns else start.turn
        lengths = np.concatenate([np.exp(x[-count:].clip(*LOGS)), fixed])
        if rims:  # no more than a ball has
            lengths[-1] = min(lengths[-1], lengths[:-1].min())
        return Primitive(start.form, x[:3], turn, lengths)

    upright = start.frame
    x = [start.center, *([start.turn] if turns else []), np.log(start.lengths[:count])]
    first = np.concatenate(x)

    def residuals(x: np.ndarray) -> np.ndarray:
        one = of(x)
        local = (points - one.center) @ (one.frame if turns else upright)
        # No point shows where a long side ends: it ends where the points do.
        low, high = _ends(one)
        ends = np.array([local[:, 2].min() + low, local[:, 2].max() - high])
        return np.concatenate([FORMS[one.form].distance(local, one.lengths), LIMIT * ends]) / error

    solved = least_squares(
        residuals,
        first,
        loss="soft_l1",
        f_scale=SOFT,
        max_nfev=STEPS,
    )
    return of(solved.x)


def _ends(one: Primitive) -> tuple[float, float]:
    """How far it goes below and above its middle along its own z."""
    if one.form == "capsule":
        half, below, above = one.lengths
        return half + below, half + above
    return (one.lengths[{"frustum": 0, "ring": 1}.get(one.form, 2)],) * 2


def _with_rims(one: Primitive) -> Primitive:
    rim = min(BLUR, one.lengths[:3].min() / 2)
    return one._replace(lengths=np.append(one.lengths[:3], rim))


def _evened(one: Primitive, off: Callable[[Primitive], float]) -> Primitive:
    """With lengths that are nearly the same made the same, where that fits about as well."""
    limit = EVEN_LOSS * off(one)
    for same in FORMS[one.form].same:
        lengths = one.lengths.copy()
        mean = lengths[list(same)].mean()
        if np.abs(lengths[list(same)] / mean - 1).max() > EVEN / 2:
            continue
        lengths[list(same)] = mean
        if off(one._replace(lengths=lengths)) <= limit:
            return one._replace(lengths=lengths)
    return one
