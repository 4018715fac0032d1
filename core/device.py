"""The device that torch works on."""

import torch
from torch import Tensor

from core.errors import MissingError, UserError, shown


def device_of(name: str, place: int | None = None) -> torch.device:
    """The torch device ``name``; "auto" is a CUDA GPU, or else the CPU.

    ``place``: of a process among those on this machine that make one asset together; each takes
    the GPU of that number, and on a CPU all share it.
    """
    device = _device_of(name)
    if place is None or device.type != "cuda":
        return device
    if device.index is not None:
        raise UserError(
            f"Several processes cannot share the device {shown(name)}.",
            "Use --device cuda: each of them then takes a GPU of its own.",
        )
    return _device_of(f"cuda:{place}")


def sent(x: Tensor, device: "torch.device | str") -> Tensor:
    """``x`` on ``device``; what a GPU still has to do is not waited for."""
    # To CUDA alone: there the CPU's memory is read at once, and the copy takes its turn. From a GPU
    # the numbers would be used before they have come.
    return x.to(device, non_blocking=torch.device(device).type not in ("cpu", "mps"))


def _device_of(name: str) -> torch.device:
    found = {"cuda": torch.cuda.is_available(), "mps": torch.backends.mps.is_available()}
    if name == "auto":
        # Not mps: Apple GPUs have no float64, which visibility, tangents and meshes compute in, so
        # that the first render would fail. It must be asked for by name until someone has run it.
        return torch.device("cuda" if found["cuda"] else "cpu")
    kind = name.split(":")[0]
    try:
        device = torch.device(name)
    except RuntimeError:
        device = None
    if kind not in ("cpu", *found) or device is None:
        raise UserError(f"There is no device {shown(name)}.", "Use auto, cpu, cuda or mps.")
    if not found.get(kind, True):
        raise MissingError(f"This torch finds no {kind} device.", "Use --device auto or cpu.")
    if kind == "cuda" and (device.index or 0) >= torch.cuda.device_count():
        raise MissingError(f"This torch finds no device {name}.", "Use --device cuda or auto.")
    return device


def has_fast_bfloat16(device: torch.device) -> bool:
    """Whether half precision is worth it: on a GPU, or on a CPU with its own units for it."""
    if device.type != "cpu":
        return True
    flags = torch.cpu.get_capabilities()
    return bool(flags.get("amx_bf16") or flags.get("avx512_bf16"))
