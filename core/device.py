"""The device that torch works on."""

import torch

from core.errors import MissingError, UserError


def device_of(name: str) -> torch.device:
    """The torch device ``name``; "auto" is the first GPU, or else the CPU."""
    found = {"cuda": torch.cuda.is_available(), "mps": torch.backends.mps.is_available()}
    if name == "auto":
        return torch.device(next((kind for kind, here in found.items() if here), "cpu"))
    kind = name.split(":")[0]
    if kind not in ("cpu", *found):
        raise UserError(f"There is no device {name!r}.", "Use auto, cpu, cuda or mps.")
    if not found.get(kind, True):
        raise MissingError(f"This torch finds no {kind} device.", "Use --device auto or cpu.")
    return torch.device(name)
