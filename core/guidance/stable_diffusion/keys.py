"""Names of a network's weights: from diffusers' layout to that of the one-file checkpoints.

A one-file checkpoint (CompVis' layout, as kohya's tools and most sites write it) holds the U-Net
under ``model.diffusion_model``, the VAE under ``first_stage_model`` and the text encoders under
``cond_stage_model`` or ``conditioner``. OpenAI's CLIP keeps transformers' names there; OpenCLIP has
its own, with the three projections of an attention in one matrix.
"""

from collections.abc import Mapping
from typing import Any, Final, NamedTuple

UNET: Final = "model.diffusion_model."
VAE: Final = "first_stage_model."

_UNET_ENDS: Final = {
    "conv_in": "input_blocks.0.0",
    "time_embedding.linear_1": "time_embed.0",
    "time_embedding.linear_2": "time_embed.2",
    "add_embedding.linear_1": "label_emb.0.0",
    "add_embedding.linear_2": "label_emb.0.2",
    "conv_norm_out": "out.0",
    "conv_out": "out.2",
}
_UNET_RESNET: Final = {
    "norm1": "in_layers.0",
    "conv1": "in_layers.2",
    "norm2": "out_layers.0",
    "conv2": "out_layers.3",
    "time_emb_proj": "emb_layers.1",
    "conv_shortcut": "skip_connection",
}
_VAE_ATTENTION: Final = {"group_norm": "norm", "to_q": "q", "to_k": "k", "to_v": "v"}
_OPEN_CLIP: Final = {
    "embeddings.token_embedding.weight": "token_embedding.weight",
    "embeddings.position_embedding.weight": "positional_embedding",
    "final_layer_norm.weight": "ln_final.weight",
    "final_layer_norm.bias": "ln_final.bias",
}
_OPEN_CLIP_LAYER: Final = {
    "layer_norm1": "ln_1",
    "layer_norm2": "ln_2",
    "mlp.fc1": "mlp.c_fc",
    "mlp.fc2": "mlp.c_proj",
    "self_attn.out_proj": "attn.out_proj",
}
_PROJECTIONS: Final = ("q_proj", "k_proj", "v_proj")  # their order in OpenCLIP's one matrix


class Place(NamedTuple):
    """Where a weight is in a one-file checkpoint."""

    key: str
    third: int | None = None  # of OpenCLIP's q, k and v in one matrix: which third of its rows
    transposed: bool = False


def unet_key(name: str, config: Mapping[str, Any]) -> str:
    """The name, without ``UNET``, of the U-Net's weight ``name``.

    Args:
        config: the U-Net's configuration: ``layers_per_block`` and ``up_block_types``.
    """
    layers = config.get("layers_per_block", 2) + 1  # of a block, its last one included
    match name.split("."):
        case ["mid_block", "resnets", j, part, *rest]:
            return _joined("middle_block", 2 * int(j), _UNET_RESNET[part], *rest)
        case ["mid_block", "attentions", j, *rest]:
            return _joined("middle_block", 2 * int(j) + 1, *rest)
        case ["down_blocks", i, "resnets", j, part, *rest]:
            block = 1 + int(i) * layers + int(j)
            return _joined("input_blocks", block, 0, _UNET_RESNET[part], *rest)
        case ["down_blocks", i, "attentions", j, *rest]:
            return _joined("input_blocks", 1 + int(i) * layers + int(j), 1, *rest)
        case ["down_blocks", i, "downsamplers", _, "conv", *rest]:
            return _joined("input_blocks", (int(i) + 1) * layers, 0, "op", *rest)
        case ["up_blocks", i, "resnets", j, part, *rest]:
            block = int(i) * layers + int(j)
            return _joined("output_blocks", block, 0, _UNET_RESNET[part], *rest)
        case ["up_blocks", i, "attentions", j, *rest]:
            return _joined("output_blocks", int(i) * layers + int(j), 1, *rest)
        case ["up_blocks", i, "upsamplers", _, "conv", *rest]:
            # It follows the resnet, and the attention where the block has one.
            place = 1 + ("Attn" in config["up_block_types"][int(i)])
            return _joined("output_blocks", (int(i) + 1) * layers - 1, place, "conv", *rest)
    start, _, end = name.rpartition(".")
    return f"{_UNET_ENDS[start]}.{end}"


def vae_key(name: str) -> str:
    """The name, without ``VAE``, of the encoder's weight ``name``; the decoder is never read."""
    match name.split("."):
        case ["encoder", "down_blocks", i, "resnets", j, part, *rest]:
            part = "nin_shortcut" if part == "conv_shortcut" else part
            return _joined("encoder.down", i, "block", j, part, *rest)
        case ["encoder", "down_blocks", i, "downsamplers", _, *rest]:
            return _joined("encoder.down", i, "downsample", *rest)
        case ["encoder", "mid_block", "resnets", j, *rest]:
            return _joined(f"encoder.mid.block_{int(j) + 1}", *rest)
        case ["encoder", "mid_block", "attentions", _, "to_out", _, end]:
            return f"encoder.mid.attn_1.proj_out.{end}"
        case ["encoder", "mid_block", "attentions", _, part, end]:
            return f"encoder.mid.attn_1.{_VAE_ATTENTION[part]}.{end}"
    return name.replace("conv_norm_out", "norm_out")


def clip_place(name: str, prefix: str, *, open_clip: bool) -> Place:
    """Where the text encoder's weight ``name`` is, under ``prefix``."""
    plain = name.removeprefix("text_model.")
    if not open_clip:
        return Place(prefix + plain)
    if plain == "text_projection.weight":  # OpenCLIP multiplies from the other side
        return Place(prefix + "text_projection", transposed=True)
    if plain in _OPEN_CLIP:
        return Place(prefix + _OPEN_CLIP[plain])
    _, _, layer, part = plain.split(".", 3)
    start, _, end = part.rpartition(".")
    block = f"{prefix}transformer.resblocks.{layer}."
    if start in _OPEN_CLIP_LAYER:
        return Place(f"{block}{_OPEN_CLIP_LAYER[start]}.{end}")
    third = _PROJECTIONS.index(start.removeprefix("self_attn."))
    return Place(f"{block}attn.in_proj_{end}", third)


def _joined(*parts: object) -> str:
    return ".".join(map(str, parts))
