"""Wood and straw: what has fibres along its length."""

import numpy as np

from core.texture.detail.noise import smoothstep
from core.texture.detail.place import Layer, Place

HEART = np.array([0.43, 0.61], np.float32)  # of the tree, across the grain: outside most parts
RINGS = 48.0  # a unit


def wooden(place: Place) -> Layer:
    """Growth rings about the tree's heart, fibres and pores along the grain.

    Rings as cylinders bent by noise: D. R. Peachey, "Solid Texturing of Complex Surfaces", SIGGRAPH
    1985. Within a year the wood gets slowly darker and then starts light again.
    """
    p, noise = place.grained, place.noise
    # Slow along the grain: it bends the long lines of a flat-sawn board.
    bend = noise.waves(p, (1.2, 3.5, 3.5), 1, 3)
    radius = np.hypot(p[:, 1] - HEART[0], p[:, 2] - HEART[1]) + 0.035 * bend
    turn = RINGS * radius + 0.13 * noise.waves(p, (5.0, 14.0, 14.0), 2)
    year = turn - np.floor(turn)
    late = smoothstep(0.25, 0.9, year) * smoothstep(1.0, 0.93, year) * noise.seen(2 * RINGS)
    fibre = noise.waves(p, (6.0, 70.0, 70.0), 3, 2)
    # Pores are open vessels, cut lengthwise: thin and short.
    pore = smoothstep(0.25, 0.5, noise.waves(p, (11.0, 95.0, 95.0), 4))
    broad = noise.waves(p, (1.0, 6.0, 6.0), 5, 2)
    # Each part is of another board.
    board = np.array([0.0, 0.22, -0.18], np.float32)[place.along]
    return Layer.of(
        0.6 * late + 0.35 * fibre + 0.55 * pore + 0.4 * broad + board,
        (0.60, 0.49, 0.40),
        roughness=0.13 * pore - 0.1 * late + 0.06 * fibre,
        height=0.0003 * late - 0.0007 * pore + 0.00035 * fibre,
    )


def thatch(place: Place) -> Layer:
    """Straw that hangs down in layers, the ends of each over the next."""
    p, noise = place.point, place.noise
    straw = noise.waves(p, (60.0, 60.0, 5.0), 1, 2)
    row = 11 * p[:, 2] + 0.35 * noise.waves(p, 14.0, 2)
    layer = row - np.floor(row)
    return Layer.of(
        0.8 * straw + 0.7 * smoothstep(0.3, 0.0, layer) + 0.2 * noise.waves(p, 5.0, 3, 2),
        (0.55, 0.48, 0.38),
        roughness=0.05 * straw,
        height=0.003 * straw + 0.012 * layer * smoothstep(1.0, 0.9, layer),
    )
