"""The guidance that a job names."""

import torch

from core.guidance.guidance import Guidance


def make_guidance(
    spec: str, device: "torch.device | str", *, chunk: int = 4, ignore_unknown: bool = False
) -> Guidance:
    """The guidance that the user names.

    Args:
        spec: "builtin", or a Stable Diffusion checkpoint in diffusers' format: its folder, or its
            hub id where it is in the local cache.
        chunk: pictures that go through a large network at a time.
        ignore_unknown: whether words that "builtin" does not know are left out, not refused.

    Raises:
        UserError: neither a known name nor a checkpoint.
        MissingError: a hub id that is not on this machine.
    """
    # Imported here: each brings libraries that the other does not need.
    if spec == "builtin":
        from core.guidance.builtin.guidance import load_builtin

        return load_builtin(device, ignore_unknown=ignore_unknown)
    from core.guidance.stable_diffusion.guidance import StableDiffusion

    return StableDiffusion.load(spec, device, chunk=chunk)
