"""A baked texture set as a material: what the renderer sees of an asset."""

import torch
from jaxtyping import Float
from torch import Tensor

from core.appearance.material import Material
from core.appearance.seen_through import TransmissionSource
from core.appearance.shaded import EmissionSource, MaterialSource
from core.io.maps import EMISSION_STRENGTH, Maps
from core.ops import normalize


def emission_source(maps: Maps) -> EmissionSource | None:
    """The maps' emission, by uv; None: none."""
    if maps.emission is None:
        return None
    stack = EMISSION_STRENGTH * maps.emission.permute(2, 0, 1)[None]
    return lambda uv: _sampled(stack, uv)


def transmission_source(maps: Maps) -> TransmissionSource | None:
    """The maps' transmission, by uv; None: nothing is clear."""
    if maps.transmission is None:
        return None
    stack = maps.transmission.permute(2, 0, 1)[None]
    return lambda uv: _sampled(stack, uv)


def maps_source(maps: Maps) -> MaterialSource:
    """The maps, sampled bilinearly by uv."""
    stack = torch.cat([maps.base_color, maps.orm, maps.normal], -1).permute(2, 0, 1)[None]

    def source(_points: Float[Tensor, "p 3"], uv: Float[Tensor, "p 2"]) -> Material:
        kd, _, roughness, metallic, kn = _sampled(stack, uv).split([3, 1, 1, 1, 3], -1)
        return Material(kd, roughness, metallic, normalize(kn))

    return source


def _sampled(stack: Float[Tensor, "1 c s s"], uv: Float[Tensor, "p 2"]) -> Float[Tensor, "p c"]:
    # uv (0, 0) is bottom left, grid_sample's (-1, -1) top left.
    grid = torch.stack([2 * uv[:, 0] - 1, 1 - 2 * uv[:, 1]], -1)[None, None]
    return torch.nn.functional.grid_sample(
        stack.to(uv), grid, mode="bilinear", padding_mode="border", align_corners=False
    )[0, :, 0].T
