"""Files of weights: safetensors, with the network's sizes and words in the metadata."""

import json
from collections.abc import Callable
from dataclasses import asdict
from pathlib import Path
from typing import Any, TypeVar

from safetensors.torch import load_file, save_file
from torch import Tensor, nn
from torch.overrides import TorchFunctionMode

from core.guidance.builtin.lexicon import Vocabulary
from core.guidance.builtin.network import UNet, UNetConfig
from core.guidance.builtin.offered import read_metadata
from core.guidance.builtin.solid_net import SolidNetConfig
from core.io.atomic import atomic_file

Net = TypeVar("Net", bound=nn.Module)
# How torch's layers start their weights.
DRAWN = nn.init.uniform_, nn.init.normal_, nn.init.kaiming_uniform_


def write_tensors(path: Path, tensors: dict[str, Tensor], metadata: dict[str, str]) -> None:
    """A safetensors file that is either the old one or the whole new one."""
    with atomic_file(path) as temporary:
        # The network is channels-last, and safetensors takes contiguous tensors only.
        whole = {name: t.detach().contiguous() for name, t in tensors.items()}
        save_file(whole, temporary, metadata)


def save_weights(
    path: Path,
    config: UNetConfig | SolidNetConfig,
    tensors: dict[str, Tensor],
    words: Vocabulary | None = None,
) -> None:
    """The shipped form, in half precision; ``words`` are those by slot that are good enough."""
    half = {name: tensor.half() for name, tensor in tensors.items()}
    offered = {slot: list(known) for slot, known in (words or {}).items()}
    metadata = {"config": json.dumps(asdict(config)), "words": json.dumps(offered)}
    write_tensors(path, half, metadata)


def load_weights(path: Path) -> UNet:
    """A network from ``save_weights``, in single precision, ready for use."""
    facts = read_metadata(path)["config"]
    for name in ("words", "widths", "attention"):  # JSON has no tuples
        facts[name] = tuple(facts[name])
    # Half precision is for the file's size: the arithmetic's precision is the caller's autocast.
    tensors = {name: tensor.float() for name, tensor in load_file(path).items()}
    return filled(lambda: UNet(UNetConfig(**facts)), tensors)


def filled(make: Callable[[], Net], tensors: dict[str, Tensor]) -> Net:
    """The network that ``make`` builds, with these weights, ready for use."""
    with _Undrawn():
        net = make()
    net.load_state_dict(tensors)
    return net.eval().requires_grad_(False)


class _Undrawn(TorchFunctionMode):
    """Within, a new network's weights stay unset: drawing them takes longer than reading them."""

    def __torch_function__(
        self, func: Callable, types: Any, args: tuple = (), kwargs: dict[str, Any] | None = None
    ) -> Any:
        kwargs = kwargs or {}
        return kwargs["tensor"] if func in DRAWN else func(*args, **kwargs)


def load_words(path: Path) -> dict[str, list[str]]:
    """The words by slot that the file's network may be asked for."""
    return read_metadata(path)["words"]
