"""What is heaped and modelled, or flows: snow, sand, lava."""

import numpy as np

from core.texture.detail.noise import smoothstep
from core.texture.detail.place import Layer, Place

PLATE, SPLIT = 6.0, 15.0  # plates of crust a unit, and the smaller ones that they split into
GRAIN = 0.009  # of sand, in units: coarse, or none would be seen
CRUST = (0.020, 0.017, 0.016)  # linear


def snow(place: Place) -> Layer:
    """Packed by hand: lumps, blue in the hollows, and crystals that glint."""
    noise, p = place.noise, place.point
    lump, grain = noise.waves(p, 7.0, 1, 3), noise.waves(p, 70.0, 2, 2)
    glint = smoothstep(0.92, 0.95, noise.cells(p, 90.0, 3)[2]) * noise.seen(63.0)
    return Layer.of(
        -0.5 * lump + 0.2 * grain - 0.3 * glint,
        (0.72, 0.80, 0.90),
        roughness=0.04 * grain - 0.6 * glint,
        height=0.009 * lump + 0.0014 * grain,
    )


def sand(place: Place) -> Layer:
    """Damp and patted: grains of several shades, darker where it is wet, crumbling."""
    noise, p = place.noise, place.point
    fine = 1 / noise.shown(GRAIN)
    grain, wet = noise.waves(p, fine, 1), noise.waves(p, 2.0, 2, 3)
    patted = noise.waves(p, 9.0, 3, 3)
    return Layer.of(
        0.6 * (noise.cells(p, fine, 4)[2] - 0.5) + 0.25 * grain + 0.4 * wet - 0.12 * patted,
        (0.62, 0.56, 0.48),
        roughness=0.04 * grain,
        height=0.0011 * grain + 0.006 * patted,
    )


def lava(place: Place) -> Layer:
    """A dark crust in plates. Only the cracks between them are of the colour, and so glow; they
    are the hottest in the middle."""
    noise, p = place.noise, place.point
    bent = p + 0.05 * noise.waves(p, 5.0, 1, 3)[:, None]
    wide, fine = (noise.cells(bent, f, salt)[1] for f, salt in ((PLATE, 2), (SPLIT, 3)))
    heat, rough = noise.waves(p, 3.0, 4, 2), noise.waves(p, 18.0, 5, 4)
    gap = smoothstep(0.13, 0.01, wide - 0.05 * heat)
    split = smoothstep(0.10, 0.01, fine) * smoothstep(-0.05, 0.4, heat)
    crack = np.maximum(gap, 0.8 * split)
    crust = np.array(CRUST, np.float32) * np.exp(0.8 * rough)[:, None]
    return Layer.of(
        -smoothstep(0.5, 1.0, crack),
        (0.85, 0.40, 0.45),
        over=crust,
        cover=1 - crack,
        apart=1 - crack,
        roughness=0.08 * rough - 0.3 * crack,
        height=0.012 * smoothstep(0.0, 0.35, wide) + 0.004 * rough - 0.003 * split,
    )
