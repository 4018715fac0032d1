"""How much memory a network's run takes, found without running it."""

import weakref
from collections.abc import Callable
from typing import Any

import psutil
import torch
from torch import Tensor
from torch.overrides import TorchFunctionMode
from torch.utils._python_dispatch import TorchDispatchMode
from torch.utils._pytree import tree_leaves

from core.errors import MemoryShortError


class _Live(TorchDispatchMode):
    """Counts the bytes of all tensors that are alive."""

    def __init__(self) -> None:
        super().__init__()
        self.now = self.peak = 0
        self._known: set[int] = set()

    def __torch_dispatch__(self, func: Any, types: Any, args: Any = (), kwargs: Any = None) -> Any:
        out = func(*args, **(kwargs or {}))
        # A view of what was there before, such as a transposed weight, takes nothing.
        given = {storage._cdata for storage in _storages((args, kwargs))}
        for storage in _storages(out):
            if storage._cdata not in given:
                self._count(storage)
        return out

    def _count(self, storage: torch.UntypedStorage) -> None:
        # Views share their storage, which counts once.
        key, size = storage._cdata, storage.nbytes()
        if key in self._known:
            return
        self._known.add(key)
        self.now += size
        self.peak = max(self.peak, self.now)
        # The meta device allocates nothing: the end of the storage object stands for the release.
        weakref.finalize(storage, self._forget, key, size)

    def _forget(self, key: int, size: int) -> None:
        self._known.discard(key)
        self.now -= size


def _storages(tree: Any) -> list[torch.UntypedStorage]:
    return [x.untyped_storage() for x in tree_leaves(tree) if isinstance(x, Tensor)]


class _FusedAttention(TorchFunctionMode):
    """The fused kernels never hold the attention matrix; the meta device's stand-in would."""

    def __torch_function__(self, func: Any, types: Any, args: Any = (), kwargs: Any = None) -> Any:
        if func is torch.nn.functional.scaled_dot_product_attention:
            return _attention_output(*args, **(kwargs or {}))
        return func(*args, **(kwargs or {}))


def _attention_output(query: Tensor, key: Tensor, value: Tensor, **_: Any) -> Tensor:
    # Keeps all three in the graph, as the kernel's backward does.
    return query * value.square().mean(-2, True) * key.square().mean((-2, -1), True)


def peak_bytes(call: Callable[[], object]) -> int:
    """The most bytes of tensors that ``call`` has alive at once, beyond those it began with.

    ``call`` runs on the meta device: shapes alone, neither memory nor arithmetic.
    """
    with _Live() as live, _FusedAttention(), torch.device("meta"):
        call()
    return live.peak


def available_bytes(device: "torch.device | str") -> int:
    """Free memory of a CUDA device, or of the machine for any other."""
    device = torch.device(device)
    if device.type == "cuda":
        return torch.cuda.mem_get_info(device)[0]
    return psutil.virtual_memory().available


def memory_short(what: str, needed: int | None = None, available: int | None = None) -> Exception:
    """The error, with its numbers in GB where they are known."""
    numbers = ""
    if needed is not None and available is not None:
        numbers = f": it needs about {needed / 1e9:.1f} GB of {available / 1e9:.1f} GB"
    return MemoryShortError(
        f"There is not enough memory for {what}{numbers}.",
        "Close other programs that use the GPU, render fewer views at once, use a smaller "
        "checkpoint, --device cpu, or --guidance builtin.",
    )
