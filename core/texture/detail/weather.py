"""Effects of time on any material: wear, fire, dirt, dust, moss, snow."""

from collections.abc import Callable

import numpy as np

from core.texture.detail.noise import Values, smoothstep
from core.texture.detail.place import Layer, Place

RUBBED = (0.66, 0.68, 0.70)  # a worn edge's factor is 1 over this


def worn(place: Place) -> Layer:
    """Rubbed at the edges, scuffed and scratched here and there, with small dents."""
    noise, p = place.noise, place.point
    uneven = noise.waves(p, 14.0, 91, 3)
    edge = smoothstep(0.10, 0.32, place.edge + 0.14 * uneven - 0.04)
    scuff = smoothstep(0.18, 0.55, noise.waves(p, 5.0, 92, 4))
    line = np.abs(noise.waves(p, (5.0, 45.0, 30.0), 93, 1))
    scratch = smoothstep(0.05, 0.0, line) * smoothstep(0.0, 0.35, noise.waves(p, 4.0, 94, 2))
    dent = smoothstep(0.35, 0.65, noise.waves(p, 7.0, 95, 1))
    return Layer.of(
        -(0.9 * edge + 0.45 * scuff + 0.4 * scratch) + 0.25 * smoothstep(0.1, 0.6, -uneven),
        RUBBED,
        roughness=0.14 * scuff + 0.1 * edge + 0.12 * scratch,
        height=-0.0008 * scratch - 0.0030 * dent - 0.0016 * edge,
    )


def charred(place: Place) -> Layer:
    """Burnt: black, cracked into small blocks, grey with ash here and there; what the fire spared
    is browned."""
    noise, p = place.noise, place.point
    burnt = smoothstep(-0.45, 0.05, noise.waves(p, 3.0, 105, 4) + 0.5 * place.edge)
    _, edge, _ = noise.cells(p + 0.01 * noise.waves(p, 15.0, 106, 2)[:, None], (24, 24, 14), 107)
    crack = smoothstep(0.16, 0.02, edge)
    ash = smoothstep(0.2, 0.55, noise.waves(p, 9.0, 108, 4)) * (1 - crack)
    black = np.array([0.013, 0.011, 0.010], np.float32) + 0.10 * ash[:, None]
    return covering(
        0.55 + 0.43 * burnt, black, roughness=0.4, height=burnt * (0.002 * ash - 0.005 * crack)
    )


def dirty(place: Place) -> Layer:
    """Grime in corners and on the lower part of what is tall, and streaks that ran down."""
    noise, p = place.noise, place.point
    cloud, streak = noise.waves(p, 6.0, 96, 5), noise.waves(p, (30.0, 30.0, 2.0), 97, 2)
    low = smoothstep(0.05, -0.40, p[:, 2])  # the object's middle is at 0
    grime = smoothstep(0.02, 0.55, 0.5 * cloud + 1.6 * np.maximum(-place.edge, 0) + 0.35 * low)
    cover = np.clip(0.75 * grime + 0.2 * smoothstep(0.2, 0.6, streak), 0, 0.85)
    return covering(cover, (0.055, 0.038, 0.022), roughness=0.3, height=0.0008 * grime)


def dusty(place: Place) -> Layer:
    """A grey film on all that looks up."""
    noise, p = place.noise, place.point
    upward = smoothstep(0.1, 0.9, place.normal[:, 2] + 0.35 * noise.waves(p, 9.0, 98, 4))
    cover = np.clip(0.62 * upward + 0.12 + 0.08 * noise.waves(p, 60.0, 99, 2), 0, 0.8)
    return covering(cover, (0.40, 0.36, 0.30), roughness=0.4, height=0.0004 * upward)


def mossy(place: Place) -> Layer:
    """Cushions of moss on what looks up and in what is hollow."""
    noise, p = place.noise, place.point
    damp = 0.55 * place.normal[:, 2] + 1.2 * np.maximum(-place.edge, 0)
    grows = smoothstep(0.05, 0.32, damp + 0.8 * noise.waves(p, 4.5, 101, 4) - 0.12)
    tuft = noise.waves(p, 55.0, 102, 3)
    green = np.array([0.085, 0.150, 0.030], np.float32) * np.exp(0.5 * tuft)[:, None]
    return covering(0.95 * grows, green, roughness=0.5, height=grows * (0.006 + 0.004 * tuft))


def snowy(place: Place) -> Layer:
    """Snow on what looks up."""
    noise, p = place.noise, place.point
    upward = smoothstep(0.35, 0.6, place.normal[:, 2] + 0.3 * noise.waves(p, 6.0, 103, 3))
    grain = noise.waves(p, 70.0, 104, 2)
    return covering(
        upward, (0.86, 0.89, 0.93), roughness=0.3, height=upward * (0.010 + 0.001 * grain)
    )


def covering(
    cover: Values,
    color: "tuple[float, float, float] | np.ndarray",
    roughness: float,
    height: Values,
) -> Layer:
    """Another substance that takes ``cover`` of the surface: rough, and no metal."""
    plain = Layer.of(np.zeros_like(cover), (1.0, 1.0, 1.0))
    over = np.broadcast_to(np.array(color, np.float32), (len(cover), 3))
    return plain._replace(
        over=over,
        cover=cover,
        roughness=roughness * cover,
        metallic=-cover,
        height=np.asarray(height, np.float32),
        apart=cover,
    )


def laid(top: Layer, base: Layer) -> Layer:
    """``top`` over ``base``."""
    left = 1 - top.cover
    cover = 1 - (1 - base.cover) * left
    over = top.over * top.cover[:, None] + base.over * (base.cover * left)[:, None]
    return Layer(
        ratio=base.ratio * top.ratio,
        over=over / np.maximum(cover, 1e-6)[:, None],
        cover=cover,
        roughness=base.roughness * left + top.roughness,
        metallic=base.metallic * left + top.metallic,
        height=base.height * (1 - 0.7 * top.cover) + top.height,
        apart=1 - (1 - base.apart) * (1 - top.apart),
    )


WEATHERS: dict[str, Callable[[Place], Layer]] = {
    "worn": worn,
    "charred": charred,
    "dirty": dirty,
    "dusty": dusty,
    "mossy": mossy,
    "snowy": snowy,
}
