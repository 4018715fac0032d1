"""Rust: on bare iron, and breaking through paint."""

import numpy as np
from jaxtyping import Float

from core.texture.detail.noise import Values, smoothstep
from core.texture.detail.place import Layer, Place

# Linear, worn and stained. A lighter grey would draw the mean away from rust.
STEEL = (0.15, 0.138, 0.13)
DARK, BRIGHT = (0.075, 0.022, 0.010), (0.34, 0.10, 0.022)  # linear: old rust and fresh


def spread(place: Place) -> Values:
    """How far rust has gone, about in [-1, 1]: patches with ragged borders."""
    noise, p = place.noise, place.point
    # Water runs down: patches are a little longer than wide.
    return noise.waves(p, (4.5, 4.5, 3.2), 1, 6) + 0.25 * noise.waves(p, (22.0, 22.0, 7.0), 2, 3)


def flakes(place: Place) -> tuple[Values, Float[np.ndarray, "n 3"]]:
    """The height of rust's crust in about [-1, 1], and its colour."""
    noise, p = place.noise, place.point
    crust = noise.waves(p, 26.0, 3, 4)
    age = noise.waves(p, 9.0, 4, 4) + 0.5 * crust
    fresh = smoothstep(-0.35, 0.45, age)[:, None]
    return crust, np.array(DARK, np.float32) * (1 - fresh) + np.array(BRIGHT, np.float32) * fresh


def rusty(place: Place) -> Layer:
    """Iron, most of it rust: dull, rough and not metallic; bare metal in between."""
    crust, color = flakes(place)
    rust = smoothstep(-0.33, -0.15, spread(place))
    # The learnt colour stays as a tint; what is under it is rust or steel.
    over = color * rust[:, None] + np.array(STEEL, np.float32) * (1 - rust)[:, None]
    line = place.noise.waves(place.grained, (2.0, 70.0, 70.0), 5, 2)
    return Layer.of(
        0.3 * crust,
        (0.6, 0.5, 0.4),
        over=over,
        cover=np.where(rust > 0.5, np.float32(0.75), np.float32(0.95)),
        roughness=0.15 * rust + 0.06 * crust * rust + (0.08 * line - 0.33) * (1 - rust),
        metallic=-0.58 * rust + 0.4 * (1 - rust),
        height=rust * (0.0025 + 0.0022 * crust) + 0.0001 * line * (1 - rust),
        apart=1 - rust,
    )


def rusted_paint(place: Place) -> Layer:
    """Paint that keeps its colour where it holds, with rust where it has come off."""
    crust, color = flakes(place)
    far = spread(place)
    rust = smoothstep(0.16, 0.24, far)
    # Before it comes off, paint is stained and blisters.
    stain = smoothstep(-0.25, 0.2, far) * (1 - rust)
    worn = place.noise.waves(place.point, 14.0, 6, 4)
    return Layer.of(
        0.75 * stain + 0.25 * worn * (1 - rust),
        (0.62, 0.45, 0.36),
        over=color,
        cover=rust,
        roughness=0.2 * rust - 0.25 * (1 - rust) + 0.12 * stain + 0.08 * worn,
        metallic=np.full(len(rust), -0.58, np.float32) + 0.1 * rust,
        height=0.0018 * stain * (1 - rust) - 0.002 * rust + 0.0022 * crust * rust,
        apart=rust,
    )
