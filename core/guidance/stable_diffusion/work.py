"""How much arithmetic a checkpoint's networks take, from shapes alone."""

from typing import Any

import torch
from torch.utils.flop_counter import FlopCounterMode

from core.guidance.guidance import Work
from core.guidance.stable_diffusion.conditions import conditions, downscale, takes_pooled
from core.guidance.stable_diffusion.networks import empty_networks
from core.guidance.stable_diffusion.source import Checkpoint


def work_of(checkpoint: Checkpoint, texts: int = 2) -> Work:
    """Of one view: a guided prediction, and an encoding with its gradient.

    Args:
        texts: predictions that one guided prediction takes.
    """
    unet, vae = empty_networks(checkpoint)
    vae.requires_grad_(False)
    size, side = unet.config.sample_size, unet.config.sample_size * downscale(vae.config)
    rows = 77 + takes_pooled(unet.config)

    def predict() -> None:
        text = torch.empty(1, rows, unet.config.cross_attention_dim)
        z, t = torch.empty(1, 4, size, size), torch.empty(1)
        with torch.no_grad():
            unet(z, t, **conditions(unet.config, text, side))

    def encode() -> None:
        picture = torch.empty(1, 3, side, side, requires_grad=True)
        with torch.no_grad():
            vae.encode(picture)  # as _Encode does: once without a graph, once with one
        vae.encode(picture).latent_dist.mean.sum().backward()

    return Work(texts * _flops(predict), _flops(encode))


def _flops(call: Any) -> float:
    with FlopCounterMode(display=False) as counter, torch.device("meta"):
        call()
    return float(counter.get_total_flops())
