"""Smooth things: glazed, moulded, blown, painted, kneaded."""

import numpy as np

from core.texture.detail.noise import smoothstep
from core.texture.detail.place import Layer, Place

GREY = (0.70, 0.70, 0.70)
PRINT, RIDGES = 7.0, 10.0  # fingerprints a unit, and ridges from the middle of one to its rim
BANDS = 4.0  # of candy, a unit along each axis


def ceramic(place: Place) -> Layer:
    """A clean glaze: thicker here and there, slightly wavy; the cracks show in its gloss alone."""
    noise, p = place.noise, place.point
    wave, pool = noise.waves(p, 6.0, 1, 2), noise.waves(p, 3.0, 2, 3)
    _, edge, _ = noise.cells(p + 0.02 * noise.waves(p, 8.0, 3)[:, None], 11.0, 4)
    crack = smoothstep(0.035, 0.008, edge) * smoothstep(0.1, 0.5, noise.waves(p, 2.5, 5, 2))
    return Layer.of(
        0.25 * pool + 0.06 * crack,
        (0.62, 0.58, 0.53),
        roughness=0.05 * np.abs(pool) + 0.08 * crack,
        height=0.0032 * wave - 0.0002 * crack,
    )


def clay(place: Place) -> Layer:
    """Fired without a glaze: rings of the potter's fingers, sand, and fire marks."""
    noise, p = place.noise, place.point
    ring = np.sin(2 * np.pi * (22 * p[:, 2] + 0.6 * noise.waves(p, 3.0, 1, 2)))
    sand, fire = noise.waves(p, 60.0, 2, 3), noise.waves(p, 3.0, 3, 4)
    return Layer.of(
        0.5 * fire + 0.25 * sand + 0.12 * ring,
        (0.62, 0.55, 0.50),
        roughness=0.05 * sand,
        height=0.0009 * ring + 0.0006 * sand,
    )


def plastic(place: Place) -> Layer:
    """A fine grain from the mould."""
    noise, p = place.noise, place.point
    grain, slow = noise.waves(p, 85.0, 1, 2), noise.waves(p, 4.0, 2, 3)
    return Layer.of(
        0.12 * slow + 0.10 * grain,
        GREY,
        roughness=0.05 * grain + 0.06 * slow,
        height=0.0004 * grain + 0.0006 * slow,
    )


def plasticine(place: Place) -> Layer:
    """Modelled with the fingers: soft dents, and the prints that they left here and there."""
    noise, p = place.noise, place.point
    near, _, which = noise.cells(p + 0.03 * noise.waves(p, 9.0, 1)[:, None], PRINT, 2)
    pressed = smoothstep(0.62, 0.35, near) * smoothstep(0.5, 0.6, which)
    ridge = np.sin(2 * np.pi * RIDGES * near) * pressed * noise.seen(PRINT * RIDGES)
    dent, kneaded = noise.waves(p, 6.0, 3, 2), noise.waves(p, 3.0, 4, 3)
    return Layer.of(
        0.25 * kneaded - 0.05 * ridge + 0.08 * pressed,
        GREY,
        roughness=0.08 * kneaded - 0.06 * pressed,
        height=0.013 * dent - 0.005 * pressed + 0.0004 * ridge,
    )


def candy(place: Place) -> Layer:
    """Boiled sugar that was pulled: bands of white through the colour, under a glaze."""
    noise, p = place.noise, place.point
    pulled = p.sum(1) * np.float32(BANDS) + 0.35 * noise.waves(p, 2.5, 1, 2)
    white = smoothstep(0.1, 0.3, np.sin(2 * np.pi * pulled))
    return Layer.of(
        0.15 * noise.waves(p, 4.0, 2, 2),
        GREY,
        over=np.full((len(p), 3), (0.86, 0.83, 0.80), np.float32),
        cover=white,
        apart=white,
        roughness=0.03 * noise.waves(p, 9.0, 3, 2),
        height=0.003 * noise.waves(p, 5.0, 4, 2) + 0.0012 * white,
    )


def rubber(place: Place) -> Layer:
    """Dull: grained, dusty, scuffed."""
    noise, p = place.noise, place.point
    grain, dust = noise.waves(p, 70.0, 1, 3), noise.waves(p, 5.0, 2, 5)
    scuff = smoothstep(0.25, 0.6, noise.waves(p, (9.0, 40.0, 22.0), 3, 2))
    return Layer.of(
        0.3 * grain - 0.45 * smoothstep(0.0, 0.6, dust) - 0.4 * scuff,
        GREY,
        roughness=0.05 * dust - 0.08 * scuff,
        height=0.0009 * grain,
    )


def glass(place: Place) -> Layer:
    """Nearly even: blown a little thicker here and there, with fingerprints' dullness."""
    noise, p = place.noise, place.point
    wave, print_ = noise.waves(p, 5.0, 1, 2), noise.waves(p, 9.0, 2, 3)
    return Layer.of(
        0.06 * wave, GREY, roughness=0.05 * smoothstep(0.2, 0.7, print_), height=0.0014 * wave
    )


def paint(place: Place) -> Layer:
    """A sprayed coat: orange peel, and dust on it."""
    noise, p = place.noise, place.point
    peel, dust = noise.waves(p, 45.0, 1, 2), noise.waves(p, 4.0, 2, 4)
    return Layer.of(0.12 * dust, GREY, roughness=0.05 * dust + 0.02 * peel, height=0.00025 * peel)


def plain(place: Place) -> Layer:
    """A thing of no stated substance: as if modelled by hand, even in colour."""
    noise, p = place.noise, place.point
    hand, grain = noise.waves(p, 7.0, 1, 3), noise.waves(p, 60.0, 2, 2)
    return Layer.of(
        0.12 * hand,
        GREY,
        roughness=0.05 * hand + 0.04 * grain,
        height=0.0014 * hand + 0.0003 * grain,
    )
