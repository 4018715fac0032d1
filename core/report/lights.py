"""Lights for the report's viewer, small enough to be in the page: RGBE texels, rows from above.

Axes are glTF's (+Y up, the asset looks along +Z), columns as three.js reads a lat-long map.
"""

import base64
import math
from contextlib import suppress

import torch
from jaxtyping import Float, UInt8
from torch import Tensor

from core.appearance.latlong import Levels, directions
from core.appearance.lights import load_light, smoothstep, softbox
from core.errors import UserError

ROWS, COLUMNS = 32, 64  # of a light: sharp enough to see where it comes from


def lights_of(own: str) -> dict[str, str]:
    """Lights by name, the run's ``own`` first where it can be read here; base64 of the texels."""
    found = {}
    with suppress(UserError):  # a file of another machine: the report does not need it
        found["the run's"] = load_light(own)
    found |= {"studio": load_light("studio"), "sky": sky(), "one lamp": lamp()}
    return {name: base64.b64encode(packed(image)).decode() for name, image in found.items()}


def sky() -> Float[Tensor, "h w 3"]:
    """Blue above, brown below, a warm sun on the right."""
    d = directions(64, 128)
    up = smoothstep(-0.1, 0.3, d[..., 2])[..., None]
    light = torch.lerp(d.new_tensor([0.16, 0.13, 0.10]), d.new_tensor([0.35, 0.55, 0.95]), up)
    return light + softbox(d, 50.0, 35.0, 12.0)[..., None] * d.new_tensor([24.0, 20.0, 15.0])


def lamp() -> Float[Tensor, "h w 3"]:
    """One lamp on the left in the dark."""
    d = directions(64, 128)
    return 0.05 + softbox(d, -60.0, 30.0, 25.0)[..., None].expand(-1, -1, 3) * 8.0


def packed(image: Float[Tensor, "h w 3"]) -> bytes:
    """The light's texels as the viewer wants them: turned to glTF's axes, RGBE."""
    v = (torch.arange(ROWS) + 0.5) / ROWS * math.pi  # from +Y down
    u = ((torch.arange(COLUMNS) + 0.5) / COLUMNS - 0.5) * 2 * math.pi
    v, u = (x.reshape(-1) for x in torch.meshgrid(v, u, indexing="ij"))
    x, y, z = v.sin() * u.cos(), v.cos(), v.sin() * u.sin()
    # glTF's (x, y, z) is the core's (x, -z, y).
    light = Levels.of([image]).read(torch.stack([x, -z, y], 1))
    return rgbe(light).numpy().tobytes()


def rgbe(light: Float[Tensor, "n 3"]) -> UInt8[Tensor, "n 4"]:
    """Radiance's shared exponent: (r, g, b) = bytes / 256 · 2^(e - 128). (Ward 1991.)"""
    most = light.amax(1).clamp(min=1e-9)
    exponent = torch.floor(torch.log2(most)) + 1
    mantissa = light * 256 * torch.exp2(-exponent)[:, None]
    texels = torch.cat([mantissa, exponent[:, None] + 128], 1)
    return texels.clamp(0, 255).to(torch.uint8)
