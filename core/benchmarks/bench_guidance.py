"""The built-in prior's part of a step."""

import torch

from core.benchmarks import least_ms, row
from core.camera import Cameras
from core.guidance.guidance import Views
from core.guidance.load import make_guidance
from core.guidance.sds import predict_eps


def rows() -> list[dict]:
    """One noise prediction with guidance, six views."""
    guidance = make_guidance("builtin", "cpu").prompted("a red wooden chair", "")
    size = guidance.latent_size
    z = torch.randn(6, 4, size, size, generator=torch.Generator().manual_seed(0))
    t = torch.full((6,), 500)
    cameras = Cameras.orbit([0.0, 60.0, 120.0, 180.0, 240.0, 300.0], [20.0])
    lines = []
    surface = torch.cat([z, z[:, :3]], 1)  # its values do not change the time
    for name, views in (("geometry", Views(cameras)), ("appearance", Views(cameras, surface))):
        ms = least_ms(lambda v=views: predict_eps(guidance, z, t, v, 7.5))
        lines.append(row(f"built-in prior, {name}, 6 views", ms, "ms"))
    return lines
