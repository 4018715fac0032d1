"""MVDream's numbers and its configuration, without torch."""

from collections.abc import Mapping
from typing import Any, Final

TOGETHER: Final = 4  # views, 90 degrees apart and of one elevation
CAMERA: Final = 16  # numbers of a camera: its matrix
CLASS: Final = "MultiViewUNetModel"  # in a folder's model_index.json


def unet_config(config: Mapping[str, Any]) -> dict[str, Any]:
    """diffusers' configuration of the U-Net that MVDream's own states."""
    widths = [config["model_channels"] * factor for factor in config["channel_mult"]]
    levels = range(len(widths))
    attends = [2**level in config["attention_resolutions"] for level in levels]
    down = ["CrossAttnDownBlock2D" if a else "DownBlock2D" for a in attends]
    up = ["CrossAttnUpBlock2D" if a else "UpBlock2D" for a in reversed(attends)]
    heads, of_a_head = config.get("num_heads", -1), config.get("num_head_channels", -1)
    return {
        "sample_size": config["image_size"],
        "in_channels": config["in_channels"],
        "out_channels": config["out_channels"],
        "block_out_channels": widths,
        "layers_per_block": config["num_res_blocks"],
        "down_block_types": down,
        "up_block_types": up,
        "cross_attention_dim": config["context_dim"],
        # By diffusers' old slip this is the number of heads, not their width.
        "attention_head_dim": [w // of_a_head if of_a_head > 0 else heads for w in widths],
        "transformer_layers_per_block": config.get("transformer_depth", 1),
        "use_linear_projection": True,
    }
