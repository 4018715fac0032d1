"""Stone: as it breaks, polished, poured, and laid in courses."""

import numpy as np

from core.texture.detail.noise import Noise, Values, smoothstep
from core.texture.detail.place import Layer, Place

GREY = (0.55, 0.54, 0.52)
COURSE, LENGTH, JOINT = 0.045, 0.115, 0.007  # of bricks, in units


def speckles(noise: Noise, p: np.ndarray, frequency: float, salt: int) -> Values:
    """Grains of minerals: each dark, light or between, about in [-1, 1]."""
    _, _, grain = noise.cells(p, frequency, salt)
    speck = smoothstep(0.72, 0.95, grain) - smoothstep(0.25, 0.05, grain)
    return speck * noise.seen(0.7 * frequency)


def stone(place: Place) -> Layer:
    """Rough: cloudy, speckled and pitted."""
    noise, p = place.noise, place.point
    cloud, rough = noise.waves(p, 4.0, 1, 4), noise.waves(p, 15.0, 2, 5)
    speck = speckles(noise, p, 75.0, 3)
    pit = smoothstep(0.3, 0.6, noise.waves(p, 28.0, 4, 2))
    return Layer.of(
        0.5 * cloud + 0.4 * rough + 0.45 * speck + 0.45 * pit,
        GREY,
        roughness=0.05 * rough + 0.04 * speck,
        height=0.007 * rough - 0.003 * pit,
    )


def granite(place: Place) -> Layer:
    """Polished: large light and dark grains, and little relief."""
    noise, p = place.noise, place.point
    bent = p + 0.006 * noise.waves(p, 50.0, 1)[:, None]
    large, small = speckles(noise, bent, 42.0, 2), speckles(noise, bent, 85.0, 3)
    return Layer.of(
        1.0 * large + 0.6 * small + 0.25 * noise.waves(p, 5.0, 4, 3),
        GREY,
        roughness=0.08 * large,
        height=0.0002 * large,
    )


def marble(place: Place) -> Layer:
    """Veins where bent noise passes through 0 (K. Perlin, "An Image Synthesizer", SIGGRAPH 1985);
    most are faint, a few are dark."""
    noise, p = place.noise, place.point
    bend = np.stack([noise.waves(p, 3.0, salt, 4) for salt in (1, 2, 3)], 1)
    q = p + 0.16 * bend
    wide = np.abs(noise.waves(q, (3.4, 4.0, 2.7), 4, 2))
    thin = np.abs(noise.waves(q, (7.5, 8.0, 6.0), 5, 3))
    vein = smoothstep(0.13, 0.0, wide) * (0.65 + 0.55 * bend[:, 0])
    hair = smoothstep(0.06, 0.0, thin) * smoothstep(-0.3, 0.3, bend[:, 1])
    cloud = noise.waves(q, 3.0, 6, 3)
    return Layer.of(
        1.2 * vein + 0.7 * hair + 0.25 * cloud,
        (0.40, 0.41, 0.44),
        roughness=0.06 * vein,
        height=0.0012 * bend[:, 2] - 0.0002 * vein,
    )


def concrete(place: Place) -> Layer:
    """Poured: cloudy, sandy, with holes where air was."""
    noise, p = place.noise, place.point
    nearest, _, size = noise.cells(p, 16.0, 1)
    # Few cells have a hole, and each is of another size.
    hole = smoothstep(0.16, 0.09, nearest / np.maximum(size, 0.05)) * (size > 0.55)
    sand, cloud = noise.waves(p, 60.0, 2, 2), noise.waves(p, 3.0, 3, 5)
    return Layer.of(
        0.5 * cloud + 0.3 * sand + 0.7 * hole,
        GREY,
        roughness=0.04 * sand,
        height=0.0006 * sand - 0.005 * hole + 0.002 * noise.waves(p, 7.0, 4, 2),
    )


def masonry(place: Place) -> Layer:
    """Rubble: split stones in mortar, each of another shade."""
    noise, p = place.noise, place.point
    bent = p + 0.010 * noise.waves(p, 14.0, 1, 2)[:, None]
    _, edge, number = noise.cells(bent, (8.5, 8.5, 13.0), 2, jitter=0.85)
    joint = smoothstep(0.13, 0.05, edge)
    rough = noise.waves(p, 22.0, 3, 4)
    return Layer.of(
        (1.3 * (number - 0.5) + 0.4 * rough + 0.3 * speckles(noise, p, 75.0, 4)) * (1 - joint)
        + 0.75 * joint,
        GREY,
        roughness=0.05 * rough + 0.05 * joint,
        height=0.013 * smoothstep(0.04, 0.3, edge) + 0.004 * rough,
    )


def brick(place: Place) -> Layer:
    """Courses of brick in lime mortar, on walls by their own direction, from above by two axes."""
    noise, p = place.noise, place.point
    side = np.argmax(np.abs(place.normal), 1)
    # Across the wall, and up: on level faces y is up.
    across = np.where(side == 0, p[:, 1], p[:, 0])
    up = np.where(side == 2, p[:, 1], p[:, 2])
    wave = 0.002 * noise.waves(p, 30.0, 1, 2)
    row = up / COURSE + wave / COURSE
    course = np.floor(row)
    # Every other course is shifted by half a brick (running bond).
    column = (across + wave) / LENGTH + 0.5 * (course % 2)
    inside = _border(row - course, COURSE), _border(column - np.floor(column), LENGTH)
    joint = smoothstep(JOINT, 0.4 * JOINT, np.minimum(*inside)) * noise.seen(1 / (2 * JOINT))
    which = np.stack([np.floor(column), course, side], 1) + np.float32(0.5)
    shade = noise.cells(which, 1.0, 2, jitter=0.0)[2] - 0.5
    rough = noise.waves(p, 28.0, 3, 4)
    return Layer.of(
        (1.1 * shade + 0.4 * rough) * (1 - joint),
        (0.60, 0.52, 0.50),
        over=np.full((len(p), 3), (0.42, 0.39, 0.34), np.float32),
        cover=0.8 * joint,
        apart=joint,
        roughness=0.05 * rough,
        height=0.005 * smoothstep(0.3 * JOINT, 1.2 * JOINT, np.minimum(*inside)) + 0.0025 * rough,
    )


def _border(part: Values, size: float) -> Values:
    """The distance to the nearer end of a row of ``size``, from the part in [0, 1) of it."""
    return np.minimum(part, 1 - part) * size
