"""Metals: brushed, polished, cast, hammered, leafed; and thin films of many colours."""

import numpy as np

from core.texture.detail.noise import Values, smoothstep
from core.texture.detail.place import Layer, Place

GREY = (0.72, 0.72, 0.72)
FILM = (0.7, 0.5, 1.1)  # turns of the hue for each axis that the surface faces


def strokes(place: Place, salt: int) -> Values:
    """Fine lines along the part, as a belt or a brush leaves them."""
    noise, p = place.noise, place.grained
    return noise.waves(p, (1.5, 65.0, 65.0), salt, 3) + 0.5 * noise.waves(p, (0.7, 25.0, 25.0), 9)


def smudges(place: Place, salt: int) -> Values:
    """Where hands and weather have been."""
    return place.noise.waves(place.point, 4.0, salt, 4)


def metal(place: Place) -> Layer:
    """Lightly brushed, and handled."""
    line, hand = strokes(place, 1), smudges(place, 2)
    return Layer.of(
        0.35 * line + 0.4 * hand,
        GREY,
        roughness=0.09 * line + 0.12 * hand,
        height=0.0002 * line + 0.0008 * hand,
    )


def brushed(place: Place) -> Layer:
    """Strongly brushed: the lines are all that it shows."""
    line, hand = strokes(place, 1), smudges(place, 2)
    return Layer.of(
        0.9 * line + 0.2 * hand,
        GREY,
        roughness=0.16 * line + 0.05 * hand,
        height=0.00035 * line,
    )


def polished(place: Place) -> Layer:
    """A mirror with smudges."""
    hand = smudges(place, 2)
    line = place.noise.waves(place.grained, (3.0, 80.0, 80.0), 1)
    return Layer.of(
        0.15 * hand, GREY, roughness=0.07 * np.abs(hand), height=0.00004 * line + 0.0008 * hand
    )


def cast(place: Place) -> Layer:
    """The skin that sand leaves on iron."""
    noise, p = place.noise, place.point
    sand, slow = noise.waves(p, 55.0, 1, 3), smudges(place, 2)
    return Layer.of(
        0.5 * sand + 0.6 * slow,
        GREY,
        roughness=0.08 * sand + 0.1 * slow,
        height=0.0012 * sand + 0.002 * noise.waves(p, 9.0, 3, 2),
    )


def golden(place: Place) -> Layer:
    """Softly beaten, with fine scratches; darker where it is worn less."""
    beaten = dents(place, 16.0, 1)
    line, hand = strokes(place, 3), smudges(place, 2)
    return Layer.of(
        0.5 * hand + 0.25 * line - 0.3 * beaten,
        (0.78, 0.68, 0.52),
        roughness=0.05 * line + 0.1 * hand,
        height=0.0022 * beaten + 0.00008 * line,
    )


def hammered(place: Place) -> Layer:
    """Beaten: a dent at every blow, and a brown bloom of age in between."""
    beaten, hand = dents(place, 15.0, 1), smudges(place, 2)
    aged = smoothstep(0.0, 0.5, hand)
    return Layer.of(
        0.75 * aged - 0.45 * beaten + 0.15 * strokes(place, 3),
        (0.55, 0.45, 0.42),
        roughness=0.2 * aged - 0.05 * beaten,
        height=0.006 * beaten,
    )


def leaf(place: Place) -> Layer:
    """Gold leaf: thin sheets laid over each other, with cracks that show the red ground."""
    noise, p = place.noise, place.point
    bent = p + 0.02 * noise.waves(p, 12.0, 1, 3)[:, None]
    _, edge, sheet = noise.cells(bent, 7.0, 2)
    crack = smoothstep(0.10, 0.02, edge) * smoothstep(-0.1, 0.25, noise.waves(p, 8.0, 3, 2))
    crease = noise.waves(p, 30.0, 4, 3)
    return Layer.of(
        1.1 * (sheet - 0.5) + 0.35 * crease,
        (0.70, 0.58, 0.42),
        over=np.full((len(p), 3), (0.20, 0.035, 0.02), np.float32),
        cover=0.75 * crack,
        metallic=-0.7 * crack,
        roughness=0.25 * (sheet - 0.5) + 0.08 * crease + 0.3 * crack,
        height=0.0006 * crease - 0.0012 * crack + 0.001 * sheet,
    )


def iridescent(place: Place) -> Layer:
    """A thin film: all hues, by the side that is looked at and by how thick the film is. A texture
    does not know the eye, so the surface's own direction is taken."""
    return _film(place, 0.85)


def pearl(place: Place) -> Layer:
    """Nacre, pearly paint: the same, pale."""
    return _film(place, 0.22)


def _film(place: Place, vivid: float) -> Layer:
    noise, p = place.noise, place.point
    turn = place.normal @ np.array(FILM, np.float32) + 0.7 * noise.waves(p, 2.5, 1, 3)
    hue = np.cos(2 * np.pi * (turn[:, None] + np.arange(3, dtype=np.float32) / 3))
    hand = smudges(place, 2)
    plain = Layer.of(0.1 * hand, GREY, roughness=0.04 * np.abs(hand), height=0.0006 * hand)
    return plain._replace(ratio=plain.ratio * np.exp(vivid * hue))


def dents(place: Place, frequency: float, salt: int) -> Values:
    """Round dents next to each other, 0 at their bottom; each ends where the next begins."""
    nearest, _, _ = place.noise.cells(place.point, frequency, salt, jitter=0.8)
    return np.minimum(nearest, 0.9) ** 2 * place.noise.seen(frequency)
