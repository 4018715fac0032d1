"""LoRA files on top of a checkpoint: W + strength · alpha / rank · B A (Hu et al. 2021).

Three layouts name the layers: kohya's (``lora_unet_down_blocks_0_...``; SDXL's often by CompVis'
names), diffusers' with peft (``unet.down_blocks.0...lora_A``), and diffusers' older one
(``...processor.to_q_lora.down``). What a file adds is added to the weights once, before the run.
"""

import json
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any, Final, NamedTuple

import torch
from safetensors.torch import load_file
from torch import Tensor, nn

from core.errors import UserError
from core.guidance.stable_diffusion.header import Header, kind_of, read_header
from core.guidance.stable_diffusion.keys import unet_key
from core.guidance.stable_diffusion.networks import readable

_DOWN: Final = (".lora_down.weight", ".lora_A.weight", "_lora.down.weight", ".lora.down.weight",
                ".lora_linear_layer.down.weight")  # fmt: skip
_UP: Final = (".lora_up.weight", ".lora_B.weight", "_lora.up.weight", ".lora.up.weight",
              ".lora_linear_layer.up.weight")  # fmt: skip
# In the name of each tensor of a LoRA, whatever its layout.
_OF_LORA: Final = re.compile(r"lora[._](down|up|A|B|linear_layer|embedding)\b")
# Other ways to change a layer, by a part of their tensors' names.
_OTHERS: Final = {
    "hada_": "LoHa", "lokr_": "LoKr", "dora_scale": "DoRA", "lora_mid": "LoCon in three parts",
    "lora_magnitude_vector": "DoRA", ".diff": "weight differences",
}  # fmt: skip


class Pair(NamedTuple):
    """What a LoRA adds to one layer."""

    down: Tensor  # A: (rank, in), or a convolution's (rank, in, k, k)
    up: Tensor  # B: (out, rank), or (out, rank, 1, 1)
    alpha: float

    def delta(self) -> Tensor:
        """alpha / rank · B A, (out, in · k · k)."""
        scale = self.alpha / len(self.down)
        return scale * (self.up.float().flatten(1) @ self.down.float().flatten(1))


def add_lora(path: Path, strength: float, unet: Any, encoders: tuple[Any, ...]) -> None:
    """Add the LoRA in ``path`` to the weights of the U-Net and of the text encoders.

    Raises:
        UserError: no LoRA, of another kind, or for another checkpoint.
    """
    pairs = read_pairs(path)
    layers = dict(_layers(unet, encoders))
    depth = min(len(encoder.encoder.layers) for encoder in map(_text_model, encoders))
    unknown = [n for n in pairs if n not in layers and not _is_left_out(n, depth, encoders)]
    if unknown:
        raise UserError(
            f'The LoRA "{path}" is for another kind of model: {len(unknown)} of its {len(pairs)} '
            f"layers are not in this checkpoint, the first {unknown[0]}.",
            "Use it with a checkpoint of the version it was trained for (1.x, 2.x or XL).",
        )
    changes = [(layers[name], pair, name) for name, pair in pairs.items() if name in layers]
    for layer, pair, name in changes:  # all of them first: no checkpoint is changed by half
        shape = (len(pair.up), pair.down.flatten(1).shape[1])
        if tuple(layer.weight.flatten(1).shape) != shape or pair.up.shape[1] != len(pair.down):
            raise UserError(
                f'The LoRA "{path}" is for another version: {name} is {shape[0]} by {shape[1]}, '
                f"the checkpoint's {' by '.join(map(str, layer.weight.flatten(1).shape))}.",
                "Use it with a checkpoint of the version it was trained for (1.x, 2.x or XL).",
            )
    with torch.no_grad():
        for layer, pair, _ in changes:
            weight = layer.weight
            added = strength * pair.delta().view(weight.shape)
            weight.copy_((weight.float() + added).to(weight.dtype))


def read_pairs(path: Path) -> dict[str, Pair]:
    """The file's pairs, by the layer's name as the file has it, without the layout's endings.

    Raises:
        UserError: no LoRA, or another way to change a layer.
    """
    header = read_header(path)
    for part, what in _OTHERS.items():
        if header.any(part):
            raise UserError(
                f'"{path}" holds {what}, not plain LoRA.',
                "Use a plain LoRA, or a checkpoint into which it was merged.",
            )
    if kind_of(header) != "LoRA":
        raise UserError(f'"{path}" is no LoRA: it is {kind_of(header)}.', "Give a LoRA's file.")
    with readable(path):
        tensors = load_file(path)
    _require_all_read(path, tensors)
    downs, ups = (_by_layer(tensors, endings) for endings in (_DOWN, _UP))
    if odd := sorted(downs.keys() ^ ups.keys()):
        raise UserError(f'"{path}" has one half of {odd[0]} alone.', "Download it again.")
    alphas = _by_layer(tensors, (".alpha",))
    stated = _stated_alphas(header)
    for name, down in downs.items():
        _require_pair(path, name, down, ups[name], alphas.get(name))
    return {
        name: Pair(
            down,
            ups[name],
            float(alphas[name]) if name in alphas else stated.get(name[:4], float(len(down))),
        )
        for name, down in downs.items()
    }


def _require_all_read(path: Path, tensors: dict[str, Tensor]) -> None:
    """Refuse a layout that is not known: what is not read would be left out in silence."""
    read = (*_DOWN, *_UP, ".alpha")
    unread = [name for name in tensors if _OF_LORA.search(name) and not name.endswith(read)]
    if unread:
        raise UserError(
            f'"{path}" has a layout that is not known here: {len(unread)} of its {len(tensors)} '
            f"tensors, the first {unread[0]}.",
            "Save it in kohya's or diffusers' layout, or use a checkpoint into which it was "
            "merged.",
        )


def _require_pair(path: Path, name: str, down: Tensor, up: Tensor, alpha: Tensor | None) -> None:
    matrices = min(down.ndim, up.ndim) >= 2 and 0 < len(down) == up.shape[1]
    if not matrices or (alpha is not None and alpha.numel() != 1):
        raise UserError(
            f'"{path}" is broken: the two halves of {name} are {tuple(down.shape)} and '
            f"{tuple(up.shape)}, which have no product.",
            "Download it again.",
        )


def _by_layer(tensors: dict[str, Tensor], endings: tuple[str, ...]) -> dict[str, Tensor]:
    found = {}
    for key, tensor in tensors.items():
        ending = next((e for e in endings if key.endswith(e)), None)
        if ending:
            # diffusers' older layout names the attention's processor, and no number for the output.
            name = key.removesuffix(ending).removeprefix("base_model.model.")
            name = name.replace(".processor.", ".")
            found[re.sub(r"\.to_out$", ".to_out.0", name)] = tensor
    return found


def _stated_alphas(header: Header) -> dict[str, float]:
    """peft's alpha by the first letters of a network's name, where diffusers wrote it."""
    try:
        stated = json.loads(header.metadata.get("lora_adapter_metadata", "{}"))
        found = {key: float(value) for key, value in stated.items() if key.endswith(".lora_alpha")}
    except (ValueError, TypeError, AttributeError):
        return {}
    return {key[:4]: value for key, value in found.items()}


def _layers(unet: Any, encoders: tuple[Any, ...]) -> Iterator[tuple[str, nn.Module]]:
    """Each layer that has weights, under every name that a file may give it."""
    for name, layer in _weighted(unet):
        yield f"unet.{name}", layer
        yield f"lora_unet_{name.replace('.', '_')}", layer
        native = unet_key(f"{name}.weight", unet.config).removesuffix(".weight")
        yield f"lora_unet_{native.replace('.', '_')}", layer
    for number, encoder in enumerate(encoders):
        kohya = f"te{number + 1}" if len(encoders) > 1 else "te"
        part = "text_encoder" if number == 0 else f"text_encoder_{number + 1}"
        for name, layer in _weighted(_text_model(encoder)):
            yield f"{part}.text_model.{name}", layer
            yield f"lora_{kohya}_text_model_{name.replace('.', '_')}", layer


def _weighted(network: nn.Module) -> Iterator[tuple[str, nn.Module]]:
    kinds = (nn.Linear, nn.Conv2d)
    return ((name, m) for name, m in network.named_modules() if isinstance(m, kinds))


def _text_model(encoder: Any) -> Any:
    return getattr(encoder, "text_model", encoder)


def _is_left_out(name: str, depth: int, encoders: tuple[Any, ...]) -> bool:
    """Whether it is the last layer of 2.x' text encoder, whose states are never used."""
    number = re.search(r"text_model[._]encoder[._]layers[._](\d+)", name)
    return bool(number) and len(encoders) == 1 and int(number[1]) == depth
