"""Files of weights: safetensors, written aside and renamed, the network's sizes in the metadata."""

import json
from dataclasses import asdict
from pathlib import Path
from typing import Any

from safetensors import safe_open
from safetensors.torch import load_file, save_file
from torch import Tensor

from core.guidance.builtin.network import UNet, UNetConfig
from core.guidance.builtin.vocabulary import Known


def write_tensors(path: Path, tensors: dict[str, Tensor], metadata: dict[str, str]) -> None:
    """A safetensors file that is either the old one or the whole new one."""
    aside = path.with_suffix(".part")
    save_file({name: t.detach().contiguous() for name, t in tensors.items()}, aside, metadata)
    aside.replace(path)


def save_weights(
    path: Path, config: UNetConfig, tensors: dict[str, Tensor], words: Known | None = None
) -> None:
    """The shipped form, in half precision; ``words`` are those by slot that are good enough."""
    half = {name: tensor.half() for name, tensor in tensors.items()}
    said = {slot: list(known) for slot, known in (words or {}).items()}
    write_tensors(path, half, {"config": json.dumps(asdict(config)), "words": json.dumps(said)})


def load_weights(path: Path) -> UNet:
    """A network from ``save_weights``, in single precision, ready to be asked."""
    facts = _metadata(path, "config")
    for name in ("words", "widths", "attention"):  # JSON has no tuples
        facts[name] = tuple(facts[name])
    net = UNet(UNetConfig(**facts))
    net.load_state_dict({name: tensor.float() for name, tensor in load_file(path).items()})
    return net.eval().requires_grad_(False)


def load_words(path: Path) -> dict[str, list[str]]:
    """The words by slot that the file's network may be asked for."""
    return _metadata(path, "words")


def _metadata(path: Path, key: str) -> dict[str, Any]:
    with safe_open(path, "pt") as file:
        return json.loads(file.metadata()[key])
