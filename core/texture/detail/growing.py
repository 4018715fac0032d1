"""Plants, baked and cooked food, and the ground."""

import numpy as np

from core.texture.detail.noise import Values, smoothstep
from core.texture.detail.place import Layer, Place

LEAF = 0.036  # from one leaf of a bush to the next, in units


def leaf(place: Place) -> Layer:
    """A blade with its veins, yellower here and there."""
    p, noise = place.grained, place.noise
    bent = p + 0.02 * noise.waves(p, 6.0, 1, 2)[:, None]
    _, edge, _ = noise.cells(bent, (14.0, 30.0, 30.0), 2)
    vein = smoothstep(0.10, 0.0, edge)
    return Layer.of(
        0.6 * noise.waves(place.point, 5.0, 3, 4) - 0.4 * vein,
        (0.55, 0.66, 0.50),
        roughness=0.1 * vein,
        height=-0.0012 * vein + 0.0006 * noise.waves(p, 60.0, 4),
    )


def foliage(place: Place) -> Layer:
    """A bush's or a tree's: leaves of their own tones over each other, dark between them."""
    p, noise = place.point, place.noise
    bend = np.stack([noise.waves(p, 22.0, salt, 2) for salt in (1, 2, 3)], 1)
    _, edge, one = noise.cells(p + 0.012 * bend, 1 / noise.shown(LEAF), 4)
    gap, fine = smoothstep(0.35, 0.0, edge), noise.waves(p, 70.0, 5, 2)
    return Layer.of(
        0.6 * gap + 0.8 * (one - 0.5) + 0.3 * fine + 0.4 * noise.waves(p, 3.5, 6, 3),
        (0.45, 0.58, 0.42),
        roughness=0.1 * gap,
        height=0.006 * smoothstep(0.0, 0.6, edge) + 0.003 * one + 0.001 * fine,
    )


def petal(place: Place) -> Layer:
    """Fine lines along it, paler here and there."""
    p, noise = place.grained, place.noise
    line = noise.waves(p, (5.0, 60.0, 60.0), 1, 2)
    return Layer.of(
        0.25 * line + 0.4 * noise.waves(place.point, 5.0, 2, 3),
        (0.72, 0.62, 0.68),
        roughness=0.05 * line,
        height=0.0007 * line,
    )


def bark(place: Place) -> Layer:
    """Plates with furrows between them, along the trunk."""
    p, noise = place.grained, place.noise
    bent = p + 0.04 * noise.waves(p, (3.0, 8.0, 8.0), 1, 2)[:, None]
    _, edge, plate = noise.cells(bent, (9.0, 34.0, 34.0), 2)
    furrow = smoothstep(0.4, 0.0, edge)
    fine = noise.waves(p, (20.0, 60.0, 60.0), 3, 2)
    return Layer.of(
        0.6 * furrow + 0.45 * fine + 0.4 * (plate - 0.5),
        (0.42, 0.40, 0.38),
        roughness=0.04 * fine,
        height=-0.006 * furrow + 0.0012 * fine,
    )


def peel(place: Place) -> Layer:
    """A fruit's or a vegetable's: waxed, with fine pores, riper on one side."""
    p, noise = place.point, place.noise
    ripe, pore = noise.waves(p, 2.5, 1, 3), smoothstep(0.3, 0.6, noise.waves(p, 55.0, 2))
    return Layer.of(
        0.55 * ripe - 0.2 * pore,
        (0.66, 0.60, 0.52),
        roughness=0.06 * ripe + 0.08 * pore,
        height=-0.0006 * pore + 0.0008 * noise.waves(p, 12.0, 3, 2),
    )


def flesh(place: Place) -> Layer:
    """Juicy fibres of a fruit that is cut, of meat or of fish."""
    p, noise = place.point, place.noise
    fibre = noise.waves(p + 0.03 * noise.waves(p, 6.0, 1, 2)[:, None], (12.0, 45.0, 45.0), 2, 2)
    return Layer.of(
        0.45 * fibre + 0.35 * noise.waves(p, 5.0, 3, 3),
        (0.66, 0.55, 0.50),
        roughness=0.1 * fibre,
        height=0.0012 * fibre,
    )


def crust(place: Place) -> Layer:
    """Baked: browner where the oven was hotter, blistered, floury in places."""
    p, noise = place.point, place.noise
    brown, grain = noise.waves(p, 4.0, 1, 4), noise.waves(p, 50.0, 2, 3)
    blister = smoothstep(0.15, 0.5, noise.waves(p, 16.0, 3, 2))
    return Layer.of(
        0.75 * brown + 0.25 * grain + 0.35 * blister,
        (0.62, 0.48, 0.34),
        roughness=0.08 * grain - 0.1 * blister,
        height=0.0016 * grain + 0.0028 * blister,
    )


def crumb(place: Place) -> Layer:
    """The inside of bread and cake, coarse meat: holes of many sizes."""
    p, noise = place.point, place.noise
    near, _, one = noise.cells(p + 0.01 * noise.waves(p, 25.0, 1, 2)[:, None], 32.0, 2)
    hole = smoothstep(0.45, 0.15, near) * (one > 0.45)
    fine = noise.waves(p, 75.0, 3, 2)
    return Layer.of(
        0.7 * hole + 0.3 * fine + 0.2 * noise.waves(p, 5.0, 4, 2),
        (0.62, 0.54, 0.44),
        roughness=0.03 * fine + 0.05 * hole,
        height=-0.0055 * hole + 0.0012 * fine,
    )


def cream(place: Place) -> Layer:
    """Icing, ice cream, sauce: spread with a knife, smooth and moist."""
    p, noise = place.point, place.noise
    spread = noise.waves(p, (9.0, 9.0, 20.0), 1, 3)
    return Layer.of(
        0.2 * spread + 0.2 * noise.waves(p, 4.0, 2, 2),
        (0.76, 0.70, 0.66),
        roughness=0.12 * spread,
        height=0.0026 * spread,
    )


def paper(place: Place) -> Layer:
    """Fibres, a slight yellow, and creases."""
    p, noise = place.point, place.noise
    fibre, age = noise.waves(p, 80.0, 1, 2), noise.waves(p, 4.0, 2, 4)
    return Layer.of(
        0.12 * fibre + 0.35 * age,
        (0.80, 0.74, 0.62),
        roughness=0.04 * fibre + 0.06 * age,
        height=0.0003 * fibre + 0.0016 * age,
    )


def soil(place: Place) -> Layer:
    """Clods and grains, for moss and grass."""
    p, noise = place.point, place.noise
    near, _, one = noise.cells(p + 0.02 * noise.waves(p, 20.0, 1, 2)[:, None], 30.0, 2)
    grain = noise.waves(p, 70.0, 3, 3)
    return Layer.of(
        0.6 * smoothstep(0.2, 0.8, near) + 0.5 * (one - 0.5) + 0.4 * grain,
        (0.50, 0.50, 0.46),
        roughness=0.04 * grain - 0.05 * near,
        height=-0.008 * near + 0.002 * grain,
    )


def flame(place: Place) -> Layer:
    """Tongues that rise, yellow at the root and red at the tip."""
    return _burning(place, 2.2 * (np.asarray(place.rise, np.float32) - 0.45))


def embers(place: Place) -> Layer:
    """As a flame, of one brightness all over."""
    return _burning(place, 0.0)


def _burning(place: Place, cooling: Values | float) -> Layer:
    p, noise = place.point, place.noise
    tongue = noise.waves(p + 0.05 * noise.waves(p, 4.0, 1, 2)[:, None], (14.0, 14.0, 3.0), 2, 2)
    return Layer.of(
        0.6 * tongue + cooling, (0.80, 0.50, 0.30), roughness=0.05 * tongue, height=0.004 * tongue
    )


def liquid(place: Place) -> Layer:
    """A still surface with slow waves."""
    wave = place.noise.waves(place.point, 6.0, 1, 3)
    return Layer.of(0.2 * wave, (0.75, 0.78, 0.80), roughness=0.02 * wave, height=0.0022 * wave)


def wicker(place: Place) -> Layer:
    """Withies over and under stakes, and rope and straw that is plaited."""
    p, noise = place.point, place.noise
    pitch = 1 / noise.shown(0.05)
    # A whole number of withies around, or there would be a seam.
    angle = np.arctan2(p[:, 1], p[:, 0]) * (round(0.7 * np.pi * pitch) / (2 * np.pi))
    level = p[:, 2] * pitch
    phase = np.where(np.floor(level) % 2 > 0, np.pi, 0.0)
    over = 0.5 + 0.5 * np.sin(2 * np.pi * angle + phase)
    round_ = 1 - (2 * (level - np.floor(level)) - 1) ** 2
    fibre = noise.waves(p, (60.0, 60.0, 90.0), 1, 1)
    bump = (round_ * (0.4 + 0.6 * over)).astype(np.float32)
    return Layer.of(
        0.8 * (0.5 - bump) + 0.3 * fibre,
        (0.50, 0.44, 0.36),
        roughness=0.05 * fibre - 0.06 * bump,
        height=0.010 * bump,
    )
