"""The guidance that a job names."""

from collections.abc import Mapping, Sequence
from typing import Final

import torch

from core.config import GUIDANCE, GuidanceConfig
from core.errors import UserError
from core.guidance.guidance import Guidance

NO_LORAS: Final[Mapping[str, float]] = {}


def make_guidance(
    spec: str,
    device: "torch.device | str",
    *,
    chunk: int | None = None,
    ignore_unknown: bool = False,
    config: GuidanceConfig = GUIDANCE,
    loras: Mapping[str, float] = NO_LORAS,
    embeddings: Sequence[str] = (),
) -> Guidance:
    """The guidance that the user names.

    Args:
        spec: "builtin", or a Stable Diffusion checkpoint: its folder in diffusers' format, its
            .safetensors file, or its hub id where it is in the local cache.
        chunk: at most so many pictures go through a large network at a time; None: as many as fit.
        ignore_unknown: whether words that "builtin" does not know are left out, not refused.
        config: how a checkpoint is used.
        loras: LoRA files on top of a checkpoint, each with its strength.
        embeddings: files of textual inversions.

    Raises:
        UserError: neither a known name nor a checkpoint, or settings that it does not take.
        MissingError: a hub id that is not on this machine.
    """
    # Imported here: each brings libraries that the other does not need.
    if spec == "builtin":
        from core.guidance.builtin.guidance import load_builtin

        _refuse_view_settings(config)
        if loras or embeddings:
            raise UserError(
                "The built-in model takes no LoRA and no embedding.",
                "Leave them out, or name a Stable Diffusion checkpoint with --guidance.",
            )
        return load_builtin(device, ignore_unknown=ignore_unknown)
    from core.guidance.stable_diffusion.checkpoint import find_checkpoint

    find_checkpoint(spec)  # a wrong name is refused before diffusers is imported, which takes 10 s
    from core.guidance.stable_diffusion.guidance import StableDiffusion
    from core.guidance.stable_diffusion.source import Additions

    additions = Additions(dict(loras), tuple(embeddings))
    return StableDiffusion.load(spec, device, chunk=chunk, config=config, additions=additions)


def _refuse_view_settings(config: GuidanceConfig) -> None:
    """The built-in networks take the camera itself, so there are no view texts to weight."""
    for name in ("soft_views", "perp_neg"):
        if getattr(config, name):
            raise UserError(
                f"The built-in model takes no guidance.{name}: it has no texts of views.",
                "Leave it out, or name a Stable Diffusion checkpoint with --guidance.",
            )
    if config.prediction != "auto":
        raise UserError(
            "The built-in model takes no guidance.prediction: what it predicts is known.",
            "Leave it out, or name a Stable Diffusion checkpoint with --guidance.",
        )
