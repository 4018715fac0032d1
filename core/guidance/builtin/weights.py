"""Files of weights: safetensors, with the network's sizes and words in the metadata.

The shipped form is in half precision, and its bulk in bytes: a tensor ``NAME`` of int8 is to be
multiplied, group by group, by the steps ``NAME.step``. One of uint8 has numbers of six bits, four
in three bytes.
"""

import json
from collections.abc import Callable
from dataclasses import asdict
from pathlib import Path
from typing import Any, TypeVar

import torch
from jaxtyping import Float, Int8, UInt8
from safetensors.torch import load_file, save_file
from torch import Tensor, nn
from torch.overrides import TorchFunctionMode

from core.guidance.builtin.network import UNet, UNetConfig
from core.guidance.builtin.offered import read_metadata
from core.guidance.builtin.solid_net import SolidNetConfig
from core.guidance.builtin.words.grammar.lexicon import Vocabulary
from core.io.atomic import atomic_file

Net = TypeVar("Net", bound=nn.Module)
# How torch's layers start their weights.
DRAWN = nn.init.uniform_, nn.init.normal_, nn.init.kaiming_uniform_
STEP = ".step"
BULK = 1 << 14  # numbers of a layer, from which on it is kept in bytes


def write_tensors(path: Path, tensors: dict[str, Tensor], metadata: dict[str, str]) -> None:
    """A safetensors file that is either the old one or the whole new one."""
    with atomic_file(path) as temporary:
        # The network is channels-last, and safetensors takes contiguous tensors only.
        whole = {name: t.detach().contiguous() for name, t in tensors.items()}
        save_file(whole, temporary, metadata)


def save_weights(
    path: Path, config: UNetConfig | SolidNetConfig, tensors: dict[str, Tensor]
) -> None:
    """Write weights in half precision, as a training's averaged weights are kept."""
    half = {name: tensor.half() for name, tensor in tensors.items()}
    write_tensors(path, half, {"config": json.dumps(asdict(config))})


def ship_weights(path: Path, net: UNet, words: Vocabulary) -> None:
    """The shipped form of a U-Net: a layer's rows in bytes; ``words`` by slot are offered.

    Tensors as in the replaced file, up to the rounding of a checkpoint, keep its bytes: the weights
    that a held training did not change stay the same to the bit.
    """
    old = load_file(path) if path.exists() else {}
    tensors = {}
    for name, tensor in net.named_parameters():
        layer = tensor.ndim > 1 and tensor.numel() >= BULK and not name.startswith("words.")
        new = in_bytes(name, tensor, len(tensor)) if layer else {name: tensor.half()}
        kept = {part: old[part] for part in new if part in old}
        tensors |= kept if kept.keys() == new.keys() and _same(name, kept, tensor) else new
    offered = {slot: list(known) for slot, known in words.items()}
    metadata = {"config": json.dumps(asdict(net.config)), "words": json.dumps(offered)}
    write_tensors(path, tensors, metadata)


def _same(name: str, old: dict[str, Tensor], new: Tensor) -> bool:
    before = whole(old)[name]
    return before.shape == new.shape and torch.equal(before.half(), new.half())


def in_bytes(name: str, tensor: Tensor, groups: int, bits: int = 8) -> dict[str, Tensor]:
    """A tensor as whole numbers of 8 or 6 bits, and the step of each of its ``groups`` of
    consecutive numbers."""
    rows = tensor.detach().reshape(groups, -1)
    step = (rows.abs().amax(1, keepdim=True) / (2 ** (bits - 1) - 1)).clamp_min(1e-6)
    steps = (rows / step).round().to(torch.int8).view(tensor.shape)
    return {name: packed(steps) if bits == 6 else steps, f"{name}{STEP}": step[:, 0].half()}


def packed(numbers: Int8[Tensor, "n a"]) -> UInt8[Tensor, "n b"]:
    """Numbers in ±31, a multiple of four in a row, as six bits each."""
    a, b, c, d = (numbers + 32).to(torch.uint8).view(len(numbers), -1, 4).unbind(-1)
    return torch.stack([a | b << 6, b >> 2 | c << 4, c >> 4 | d << 2], -1).view(len(numbers), -1)


def unpacked(data: UInt8[Tensor, "n b"]) -> Int8[Tensor, "n a"]:
    """The inverse of :func:`packed`."""
    a, b, c = data.view(len(data), -1, 3).unbind(-1)
    numbers = torch.stack([a & 63, a >> 6 | b << 2 & 63, b >> 4 | c << 4 & 63, c >> 2], -1)
    return numbers.to(torch.int8).view(len(data), -1) - 32


def whole(tensors: dict[str, Tensor]) -> dict[str, Float[Tensor, "..."]]:
    """The tensors of a file in single precision; booleans stay so.

    They are copies: a file that is mapped into memory could not be replaced on Windows.
    """
    found = {}
    for name, tensor in tensors.items():
        if tensor.dtype == torch.bool:
            found[name] = tensor.clone()
        elif not name.endswith(STEP):
            numbers = unpacked(tensor) if tensor.dtype == torch.uint8 else tensor
            found[name] = numbers.to(torch.float, copy=True)
    for name in found:
        if name + STEP in tensors:
            step = tensors[name + STEP].float()[:, None]
            found[name].view(len(step), -1).mul_(step)
    return found


def load_tensors(path: Path) -> dict[str, Tensor]:
    """The tensors of a file of weights, in single precision."""
    return whole(load_file(path))


def load_weights(path: Path) -> UNet:
    """A network from ``save_weights`` or ``ship_weights``, in single precision, ready for use."""
    facts = read_metadata(path)["config"]
    for name in ("words", "widths", "attention"):  # JSON has no tuples
        facts[name] = tuple(facts[name])
    # The file's precision is for its size: the arithmetic's is the caller's autocast.
    return filled(lambda: UNet(UNetConfig(**facts)), load_tensors(path))


def filled(make: Callable[[], Net], tensors: dict[str, Tensor]) -> Net:
    """The network that ``make`` builds, with these weights, ready for use."""
    with torch.device("meta"), _Undrawn():  # no memory is written that is not kept
        net = make()
    net.load_state_dict(tensors, assign=True)
    # As the network was made. Not in torch's stubs.
    net.to(memory_format=torch.channels_last)  # pyright: ignore[reportCallIssue]
    return net.eval().requires_grad_(False)


class _Undrawn(TorchFunctionMode):
    """A context in which a new network's weights stay unset; without memory, drawing them loads a
    compiler."""

    def __torch_function__(
        self, func: Callable, types: Any, args: tuple = (), kwargs: dict[str, Any] | None = None
    ) -> Any:
        kwargs = kwargs or {}
        return kwargs["tensor"] if func in DRAWN else func(*args, **kwargs)


def load_words(path: Path) -> dict[str, list[str]]:
    """The words by slot that the file's network offers."""
    return read_metadata(path)["words"]
