"""Primitives made as thin as the real thing, which a network draws stouter than it is.

Nothing that is thinner than the cells of its planes can be drawn, so that a bow's string is a rod
and a bicycle's frame a pipe. A rod gets thinner and keeps its length; a plate keeps its outline.
"""

import numpy as np
from jaxtyping import Float

from core.geometry.parts.limbs import packed_limbs, unpacked_limbs
from core.geometry.parts.pipes import packed_pipes, unpacked_pipes
from core.geometry.parts.primitives import (
    FRAMES,
    Layer,
    Lengths,
    Primitive,
    along_axes,
    packed,
    packed_along,
    unpacked,
)
from core.geometry.union import area_of, inset

STRIP = 1.25  # times as wide as thick, at most: an outline that gets narrower too
ALSO = 2.0  # times the least width: what is wider is no thickness


def thinned(one: Primitive, by: float) -> Primitive:
    """The primitive with what is thin of it ``by`` times as thick, about its middle."""
    if by == 1.0:
        return one
    center, lengths = THINNED[one.form](one.lengths, by)
    return one._replace(center=one.center + one.frame @ center, lengths=lengths)


# How far the middle moves, and the lengths.
Thinned = tuple[Float[np.ndarray, " 3"], Float[np.ndarray, " _n"]]
MIDDLE = np.zeros(3)


def _capsule(lengths: Lengths, by: float) -> Thinned:
    half, below, above = lengths
    more = (1 - by) / 2
    return (
        np.array([0, 0, more * (above - below)]),
        np.array([half + more * (below + above), by * below, by * above]),
    )


def _box(lengths: Lengths, by: float) -> Thinned:
    half = lengths[:3] * factors(lengths[:3], by)
    return MIDDLE, np.append(half, lengths[3:].clip(max=half.min()))


def _frustum(lengths: Lengths, by: float) -> Thinned:
    half, below, above, rim = lengths
    up, across = factors(np.array([half, max(below, above)]), by)
    made = np.array([up * half, across * below, across * above])
    narrow = made[made > 0].min()
    return MIDDLE, np.append(made, min(rim, narrow))


def _ring(lengths: Lengths, by: float) -> Thinned:
    return MIDDLE, lengths * (1, by)


def _turned(lengths: Lengths, by: float) -> Thinned:
    profile = lengths.reshape(-1, 2)
    low, high = profile.min(0), profile.max(0)
    middle, around = (low + high) / 2, 2 * np.pi * high[0]
    if 2 * low[0] < high[0]:  # no hoop: it goes on through the axis
        low, middle, around = -high * (1, 0) + low * (0, 1), middle * (0, 1), 0.0
    widths = [*(high - low), *([around] if around else [])]
    return MIDDLE, (middle + (profile - middle) * factors(np.array(widths), by)[:2]).ravel()


def _layers(lengths: Lengths, by: float) -> Thinned:
    return MIDDLE, packed(_thin_layers(unpacked(lengths), by))


def _crossed(lengths: Lengths, by: float) -> Thinned:
    along = {frame.tobytes(): unpacked(own) for frame, own in along_axes(lengths)}
    each = [along.get(frame.tobytes(), []) for frame in FRAMES]
    thin = [[layer for one in found for layer in _thin_layers([one], by)] for found in each]
    return MIDDLE, packed_along(thin)


def _wall(lengths: Lengths, by: float) -> Thinned:
    layers = unpacked(lengths[1:])
    middle = (layers[0][0] + layers[-1][1]) / 2
    return MIDDLE, np.append(lengths[0], packed(_flattened(layers, middle, by)))


def _blade(lengths: Lengths, by: float) -> Thinned:
    across = factors(np.append(lengths[:2], lengths[2:4].sum()), by)[:2]
    return MIDDLE, np.append(lengths[:2] * across, lengths[2:])


def _pipes(lengths: Lengths, by: float) -> Thinned:
    each = unpacked_pipes(lengths)
    thin = [pipe._replace(nodes=pipe.nodes * (1, 1, 1, by)) for pipe in each]
    return MIDDLE, packed_pipes(thin)


def _limbs(lengths: Lengths, by: float) -> Thinned:
    each, softness = unpacked_limbs(lengths)
    return MIDDLE, packed_limbs([nodes * (1, 1, 1, by, 1) for nodes in each], by * softness)


THINNED = {
    "box": _box,
    "ellipsoid": _box,
    "frustum": _frustum,
    "capsule": _capsule,
    "ring": _ring,
    "turned": _turned,
    "layers": _layers,
    "crossed": _crossed,
    "wall": _wall,
    "blade": _blade,
    "pipes": _pipes,
    "limbs": _limbs,
}


def factors(widths: Float[np.ndarray, " k"], by: float) -> Float[np.ndarray, " k"]:
    """``by`` for each width that is about the least; 1 for what is wider, and for all where none
    is: a table's one leg with its foot is no rod."""
    thin = widths < ALSO * widths.min()
    return np.where(thin & ~thin.all(), by, 1.0)


def _thin_layers(layers: list[Layer], by: float) -> list[Layer]:
    """Thinner along the axis, and across it where an outline is a strip."""
    low, high = layers[0][0], layers[-1][1]
    areas, ways = np.array([area_of(loops) for *_, loops in layers]).T
    strip = 2 * areas.sum() / ways.sum()  # in the mean
    up = by if high - low < ALSO * strip else 1.0
    found = _flattened(layers, (low + high) / 2, up)
    if strip < STRIP * (high - low):
        narrow = (1 - by) * float((areas / ways).min())  # half of the narrowest layer's
        found = [(low, high, inset(loops, narrow)) for low, high, loops in found]
    return [layer for layer in found if layer[2]]


def _flattened(layers: list[Layer], middle: float, by: float) -> list[Layer]:
    return [
        (middle + by * (low - middle), middle + by * (high - middle), loops)
        for low, high, loops in layers
    ]
