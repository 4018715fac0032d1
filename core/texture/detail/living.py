"""Coverings of animals and people: fur, feathers, scales, skin."""

import numpy as np

from core.texture.detail.noise import Points, Values, smoothstep
from core.texture.detail.place import Layer, Place

FEATHER, SCALE = 0.05, 0.028  # from one to the next, in units


def fur(place: Place) -> Layer:
    """Hairs that lie along the body, in tufts."""
    p, noise = hair_axes(place, 0.05), place.noise
    tuft = noise.waves(p, (7.0, 26.0, 26.0), 4, 2)
    hair = noise.waves(p, (14.0, 90.0, 90.0), 5, 2)
    return Layer.of(
        0.55 * hair + 0.45 * tuft + 0.3 * noise.waves(place.point, 4.0, 6, 3),
        (0.58, 0.54, 0.50),
        roughness=0.04 * hair + 0.05 * tuft,
        height=0.0022 * hair + 0.0040 * tuft,
    )


def hair(place: Place) -> Layer:
    """Long strands that fall."""
    p, noise = place.point, place.noise
    p = p + 0.03 * noise.waves(p, 5.0, 1, 2)[:, None]
    strand = noise.waves(p, (70.0, 70.0, 3.0), 2, 2)
    lock = noise.waves(p, (16.0, 16.0, 1.5), 3, 2)
    return Layer.of(
        0.6 * strand + 0.5 * lock,
        (0.55, 0.52, 0.50),
        roughness=0.1 * strand,
        height=0.0016 * strand + 0.0040 * lock,
    )


def feathers(place: Place) -> Layer:
    """Feathers in rows that hang over each other, each with its quill and its vane's fine lines."""
    p, noise = place.point, place.noise
    down, across = _feather(place)
    tip, root = smoothstep(0.22, 0.0, down), smoothstep(0.7, 1.3, down)
    quill = smoothstep(0.10, 0.02, np.abs(across)) * (1 - tip)
    vane = noise.waves(p, 80.0, 5, 1)
    return Layer.of(
        0.75 * root - 0.35 * tip - 0.2 * quill + 0.2 * vane + 0.35 * noise.waves(p, 6.0, 6, 3),
        (0.60, 0.58, 0.56),
        roughness=0.06 * root - 0.05 * quill,
        height=-0.0055 * down + 0.0010 * quill + 0.0004 * vane,
    )


def _feather(place: Place) -> tuple[Values, Values]:
    """How far above its feather's tip each point is, in rows, and how far from its quill; from
    three sides, each where the surface faces it."""
    noise = place.noise
    bend = np.stack([noise.waves(place.point, 9.0, salt, 2) for salt in (1, 2, 3)], 1)
    p = (place.point + 0.006 * bend) / np.float32(noise.shown(FEATHER))
    sides = [_row(p[:, u], p[:, v]) for u, v in ((1, 2), (0, 2), (0, 1))]
    down, across = (np.stack(values, 1) for values in zip(*sides, strict=True))
    first = place.faced.argmax(1)[:, None]
    return tuple(np.take_along_axis(x, first, 1)[:, 0] for x in (down, across))


def _row(u: Values, v: Values) -> tuple[Values, Values]:
    """The same of rows one high, of feathers one wide with round tips; every other row is half a
    feather to the side."""
    row = np.floor(v)
    own, below = (_aside(u, row - back) for back in (0, 1))
    over, under = v - row - 2.2 * own**2, v - row + 1 - 2.2 * below**2
    return np.where(over > 0, over, under), np.where(over > 0, own, below)


def _aside(u: Values, row: Values) -> Values:
    shifted = u + 0.5 * (row % 2)
    return shifted - np.floor(shifted) - 0.5


def scales(place: Place) -> Layer:
    """Scales, each a small dome, dark between them."""
    p, noise = place.point, place.noise
    _, edge, one = noise.cells(p, 1 / noise.shown(SCALE), 1, jitter=0.55)
    gap = smoothstep(0.25, 0.0, edge)
    return Layer.of(
        0.8 * gap + 0.5 * (one - 0.5) + 0.35 * noise.waves(p, 4.0, 2, 3),
        (0.52, 0.52, 0.50),
        roughness=0.25 * gap + 0.1 * (one - 0.5),
        height=0.0032 * smoothstep(0.0, 0.6, edge),
    )


def hide(place: Place) -> Layer:
    """A thick skin: folds and a net of fine creases."""
    p, noise = place.point, place.noise
    _, edge, _ = noise.cells(p + 0.012 * noise.waves(p, 15.0, 1, 2)[:, None], 42.0, 2)
    crease = smoothstep(0.12, 0.0, edge) * noise.seen(60.0)
    fold = smoothstep(0.09, 0.0, np.abs(noise.waves(p, (3.0, 3.0, 9.0), 3, 2)))
    return Layer.of(
        0.35 * crease + 0.3 * fold + 0.45 * noise.waves(p, 5.0, 4, 4),
        (0.60, 0.57, 0.55),
        roughness=0.08 * crease,
        height=-0.0010 * crease - 0.0030 * fold,
    )


def skin(place: Place) -> Layer:
    """A person's: pores, and a little more red here and there."""
    p, noise = place.point, place.noise
    pore, flush = noise.waves(p, 80.0, 1, 2), noise.waves(p, 4.0, 2, 3)
    return Layer.of(
        0.35 * flush + 0.1 * pore,
        (0.78, 0.60, 0.56),
        roughness=0.08 * flush + 0.05 * pore,
        height=0.0004 * pore + 0.0014 * noise.waves(p, 12.0, 3, 2),
    )


def wet_skin(place: Place) -> Layer:
    """Smooth and wet: a frog, a whale; paler and darker clouds."""
    p, noise = place.point, place.noise
    cloud, spot = noise.waves(p, 4.0, 1, 4), smoothstep(0.2, 0.5, noise.waves(p, 14.0, 2, 2))
    return Layer.of(
        0.5 * cloud + 0.25 * spot,
        (0.62, 0.62, 0.62),
        roughness=0.1 * cloud,
        height=0.0012 * noise.waves(p, 22.0, 3, 2),
    )


def chitin(place: Place) -> Layer:
    """An insect's or a crab's shell: polished, pitted, darker in places."""
    p, noise = place.point, place.noise
    pit = smoothstep(0.25, 0.5, noise.waves(p, 45.0, 1, 2))
    cloud = noise.waves(p, 5.0, 2, 3)
    return Layer.of(
        0.45 * cloud + 0.12 * pit,
        (0.58, 0.56, 0.56),
        roughness=0.1 * np.abs(cloud) + 0.1 * pit,
        height=-0.0012 * pit + 0.0010 * noise.waves(p, 9.0, 3, 2),
    )


def bone(place: Place) -> Layer:
    """Bone, teeth and horns: long streaks, yellow with age, hair cracks."""
    p, noise = place.grained, place.noise
    streak, age = noise.waves(p, (3.0, 30.0, 30.0), 1, 3), noise.waves(place.point, 5.0, 2, 3)
    crack = smoothstep(0.05, 0.0, np.abs(noise.waves(p, (4.0, 16.0, 16.0), 3, 2)))
    crack *= smoothstep(0.0, 0.4, noise.waves(place.point, 4.0, 4))
    return Layer.of(
        0.3 * streak + 0.45 * age + 0.35 * crack,
        (0.72, 0.63, 0.50),
        roughness=0.12 * age + 0.06 * streak,
        height=0.0006 * streak - 0.0008 * crack,
    )


def eye(place: Place) -> Layer:
    """As wet as an eye: nothing on it but the light."""
    wave = place.noise.waves(place.point, 7.0, 1, 2)
    return Layer.of(0.04 * wave, (0.8, 0.8, 0.8), roughness=0.02 * wave, height=0.0012 * wave)


def hair_axes(place: Place, bend: float) -> Points:
    """The part's own axes, its length first, bent by slow noise: the direction of hairs."""
    noise, p = place.noise, place.grained
    return p + bend * np.stack([noise.waves(p, 4.0, salt, 2) for salt in (1, 2, 3)], 1)
