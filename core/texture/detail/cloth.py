"""Cloth, sequins on it, and leather."""

import numpy as np

from core.texture.detail.noise import Noise, Values, smoothstep
from core.texture.detail.place import Layer, Place

THREAD = 0.013  # from one thread to the next, in units
TWILL = 0.010
PEBBLE = 0.0147  # of leather
SEQUIN = 0.024


def fabric(place: Place) -> Layer:
    """A plain weave: threads over and under each other, none as thick as the next.

    The wider its threads have to be to be seen, the less their colours differ: a white coat is
    white, not checkered.
    """
    weave = _box(place, plain_weave, THREAD)
    fine = THREAD / place.noise.shown(THREAD)
    slub = _threads(place)
    worn = place.noise.waves(place.point, 5.0, 3, 3)
    return Layer.of(
        0.65 * fine * (0.6 - weave) + 0.35 * slub + 0.25 * worn,
        (0.55, 0.55, 0.55),
        roughness=0.05 * (0.6 - weave),
        height=0.0028 * weave,
    )


def denim(place: Place) -> Layer:
    """Twill: diagonal ribs of dyed threads over white ones, faded."""
    rib = _box(place, twill, TWILL)
    slub, fade = _threads(place), place.noise.waves(place.point, 3.5, 3, 3)
    return Layer.of(
        0.8 * (0.5 - rib) + 0.5 * slub + 0.5 * fade,
        (0.50, 0.55, 0.62),
        roughness=0.04 * (0.5 - rib),
        height=0.0016 * rib,
    )


def felt(place: Place) -> Layer:
    """Felt and wool: matted hairs without order."""
    noise, p = place.noise, place.point
    bend = np.stack([noise.waves(p, 18.0, salt, 2) for salt in (1, 2, 3)], 1)
    hair = noise.waves(p + 0.03 * bend, 55.0, 4, 3)
    return Layer.of(
        0.6 * hair + 0.3 * noise.waves(p, 7.0, 5, 3),
        (0.62, 0.62, 0.62),
        roughness=0.04 * hair,
        height=0.0020 * hair,
    )


def velvet(place: Place) -> Layer:
    """A pile brushed in different directions, with a shine where it is flat."""
    noise, p = place.noise, place.point
    pile_way = noise.waves(p + 0.05 * noise.waves(p, 4.0, 1)[:, None], 6.0, 2, 3)
    pile = noise.waves(p, 90.0, 3, 1)
    return Layer.of(
        0.45 * pile_way + 0.3 * pile,
        (0.55, 0.55, 0.55),
        roughness=0.2 * pile_way,
        height=0.0006 * pile + 0.0008 * pile_way,
    )


def sequins(place: Place) -> Layer:
    """Small discs of metal, each hung at another angle, on dark cloth."""
    noise = place.noise
    near, edge, one = noise.cells(place.point, 1 / noise.shown(SEQUIN), 1, jitter=0.6)
    disc = smoothstep(0.04, 0.16, edge)
    return Layer.of(
        1.2 * (1 - disc) + 1.6 * (one - 0.5),
        (0.45, 0.45, 0.45),
        roughness=(0.25 * one - 0.75) * disc,
        metallic=0.95 * disc,
        height=disc * (0.0030 - 0.0055 * near * (one - 0.2)),
    )


def leather(place: Place) -> Layer:
    """Pebbles with furrows between them, creases, and wear that makes it lighter."""
    noise, p = place.noise, place.point
    bend = np.stack([noise.waves(p, 12.0, salt, 2) for salt in (1, 2, 3)], 1)
    _, edge, pebble = noise.cells(p + 0.008 * bend, 1 / noise.shown(PEBBLE), 4)
    bump = smoothstep(0.0, 0.45, edge)
    # Creases: where slow noise passes through 0, here and there.
    crease = smoothstep(0.10, 0.0, np.abs(noise.waves(p + 0.03 * bend, 4.0, 5, 3)))
    crease *= smoothstep(0.0, 0.4, noise.waves(p, 3.0, 6))
    worn = noise.waves(p, 3.0, 7, 4)
    return Layer.of(
        0.5 * (0.6 - bump) + 0.35 * crease + 0.6 * worn + 0.15 * (pebble - 0.5),
        (0.55, 0.48, 0.43),
        roughness=0.15 * (0.7 - bump) + 0.12 * worn + 0.08 * crease,
        height=0.0011 * bump - 0.0022 * crease,
    )


def plain_weave(u: Values, v: Values) -> Values:
    """The height in [0, 1] of a weave with a thread on each unit of u and of v."""
    x, y = u - np.floor(u) - 0.5, v - np.floor(v) - 0.5
    # A thread is high where it goes over, at every other crossing.
    warp = (1 - 4 * x * x) * (0.6 + 0.4 * _sign(u) * np.sin(np.pi * v))
    weft = (1 - 4 * y * y) * (0.6 - 0.4 * _sign(v) * np.sin(np.pi * u))
    return np.maximum(warp, weft)


def twill(u: Values, v: Values) -> Values:
    """The height in [0, 1] of diagonal ribs."""
    rib = 0.5 + 0.5 * np.sin(np.pi * (u + v))
    return rib * (0.8 + 0.2 * np.sin(2 * np.pi * (u - v)))


def _sign(x: Values) -> Values:
    return 1 - 2 * (np.floor(x) % 2)


def _box(place: Place, weave, size: float) -> Values:
    """``weave`` from three sides, each where the surface faces it; blended at the borders."""
    # A cloth is never quite straight.
    p = place.point + 0.004 * place.noise.waves(place.point, 6.0, 1, 2)[:, None]
    size = place.noise.shown(size)
    p = p / np.float32(size)
    sides = [weave(p[:, (axis + 1) % 3], p[:, (axis + 2) % 3]) for axis in range(3)]
    return (place.faced * np.stack(sides, 1)).sum(1)


def _threads(place: Place) -> Values:
    """Threads that are lighter or darker than others, along two axes of the side faced."""
    noise: Noise = place.noise
    long = [noise.waves(place.point, f, 10 + i) for i, f in enumerate(((3.0, 60.0, 60.0),
            (60.0, 3.0, 60.0), (60.0, 60.0, 3.0)))]  # fmt: skip
    return sum(long) / 2
