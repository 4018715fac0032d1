"""The guidance that a job names."""

import torch

from core.config import GUIDANCE, GuidanceConfig
from core.errors import UserError
from core.guidance.guidance import Guidance


def make_guidance(
    spec: str,
    device: "torch.device | str",
    *,
    chunk: int = 4,
    ignore_unknown: bool = False,
    config: GuidanceConfig = GUIDANCE,
) -> Guidance:
    """The guidance that the user names.

    Args:
        spec: "builtin", or a Stable Diffusion checkpoint in diffusers' format: its folder, or its
            hub id where it is in the local cache.
        chunk: pictures that go through a large network at a time.
        ignore_unknown: whether words that "builtin" does not know are left out, not refused.
        config: how a checkpoint is used.

    Raises:
        UserError: neither a known name nor a checkpoint, or settings that it does not take.
        MissingError: a hub id that is not on this machine.
    """
    # Imported here: each brings libraries that the other does not need.
    if spec == "builtin":
        from core.guidance.builtin.guidance import load_builtin

        _refuse_view_settings(config)
        return load_builtin(device, ignore_unknown=ignore_unknown)
    from core.guidance.stable_diffusion.guidance import StableDiffusion

    return StableDiffusion.load(spec, device, chunk=chunk, config=config)


def _refuse_view_settings(config: GuidanceConfig) -> None:
    """The built-in networks take the camera itself, so there are no view texts to weight."""
    for name in ("soft_views", "perp_neg"):
        if getattr(config, name):
            raise UserError(
                f"The built-in prior takes no guidance.{name}: it has no texts of views.",
                "Leave it out, or name a Stable Diffusion checkpoint with --guidance.",
            )
