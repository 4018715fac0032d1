"""What a U-Net takes in addition to a noisy latent and the time."""

from typing import Any

import torch
from jaxtyping import Float
from torch import Tensor

from core.guidance.stable_diffusion.texts import pooled_of


def takes_pooled(config: Any) -> bool:
    """Whether it is SDXL's U-Net, which also takes a pooled text and sizes."""
    return getattr(config, "addition_embed_type", None) == "text_time"


def conditions(config: Any, text: Float[Tensor, "b l d"], side: int) -> dict[str, Any]:
    """The U-Net's other arguments.

    Args:
        config: the U-Net's.
        text: of ``Texts.encode``.
        side: of the picture, pixels. SDXL gets it as the size at which the picture was made, not
            cropped (Podell et al. 2023, §2.2).
    """
    if not takes_pooled(config):
        return {"encoder_hidden_states": text}
    # Six numbers: the original size, the crop's corner, the size now; each with its embedding.
    width = config.projection_class_embeddings_input_dim - 6 * config.addition_time_embed_dim
    sizes = torch.tensor([side, side, 0, 0, side, side], device=text.device, dtype=text.dtype)
    added = {"text_embeds": pooled_of(text, width), "time_ids": sizes.expand(len(text), 6)}
    return {"encoder_hidden_states": text[:, :-1], "added_cond_kwargs": added}


def downscale(config: Any) -> int:
    """Pixels of the picture along a latent's pixel, by the VAE's configuration."""
    return 2 ** (len(config.block_out_channels) - 1)
