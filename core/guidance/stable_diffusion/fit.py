"""How many pictures at a time fit into the memory, from a checkpoint's configuration alone."""

from typing import Any

import torch

from core.guidance.stable_diffusion.conditions import conditions, downscale, takes_pooled
from core.guidance.stable_diffusion.memory import available_bytes, memory_short, peak_bytes
from core.guidance.stable_diffusion.networks import empty_networks, vae_dtype
from core.guidance.stable_diffusion.source import Checkpoint

RESERVE = 1.25  # fragments, the kernels' work space, the renderer
# Pictures at a time, the largest that fits: with Stable Diffusion 1.5 in 16 bit 24 in 80 GB, 8 in
# 24, 4 in 12, 2 in 8 and 1 in 6.
CHUNKS = (24, 12, 8, 4, 2, 1)
MOST_ON_CPU = 4  # more at a time are no faster there


def estimate_memory(
    checkpoint: Checkpoint, *, chunk: int, dtype: torch.dtype, texts: int = 2
) -> int:
    """Bytes that guidance by this checkpoint takes.

    The U-Net's and the encoder's weights, and :func:`busy_bytes`; a quarter is added for what only
    the kernels know.

    Args:
        texts: predictions of a picture that run together; Perp-Neg has more than two.
    """
    parts = _parts(checkpoint, dtype)
    weights = sum(p.nbytes for part in parts for p in part.parameters())
    return int(RESERVE * (weights + _busy(*parts, chunk, texts)))


def busy_bytes(checkpoint: Checkpoint, *, chunk: int, dtype: torch.dtype, texts: int = 2) -> int:
    """Bytes of the larger of a guided noise prediction and an encoding with its gradient, ``chunk``
    pictures each."""
    return _busy(*_parts(checkpoint, dtype), chunk, texts)


def _parts(checkpoint: Checkpoint, dtype: torch.dtype) -> tuple[Any, Any]:
    """The U-Net and the VAE, in the precision they run in."""
    unet, vae = empty_networks(checkpoint)
    kinds = {unet: dtype, vae: vae_dtype(checkpoint, dtype)}
    for part, kind in kinds.items():
        torch.nn.Module.to(part.requires_grad_(False), kind)  # diffusers' own warns of this
    return unet, vae


_known: dict[tuple, int] = {}


def _busy(unet: Any, vae: Any, chunk: int, texts: int) -> int:
    """Cached for each configuration, as it takes up to a second."""
    key = str(unet.config), str(vae.config), unet.dtype, vae.dtype, chunk, texts
    if key not in _known:
        _known[key] = _measured(unet, vae, chunk, texts)
    return _known[key]


def _measured(unet: Any, vae: Any, chunk: int, texts: int) -> int:
    size, width = int(unet.config.sample_size), int(unet.config.cross_attention_dim)
    side = size * downscale(vae.config)

    # The two largest loads of a step; they do not run at the same time, so the larger one counts.
    def predict() -> None:
        batch = texts * chunk
        z = torch.empty(batch, 4, size, size, dtype=unet.dtype)
        text = torch.empty(batch, 77 + takes_pooled(unet.config), width, dtype=unet.dtype)
        with torch.no_grad():
            unet(z, torch.empty(batch), **conditions(unet.config, text, side))

    def encode() -> None:
        picture = torch.empty(chunk, 3, side, side, dtype=vae.dtype, requires_grad=True)
        vae.encode(picture).latent_dist.mean.sum().backward()

    return max(peak_bytes(predict), peak_bytes(encode))


def chunk_that_fits(
    checkpoint: Checkpoint,
    device: torch.device,
    dtype: torch.dtype,
    most: int | None = None,
    *,
    texts: int,
    least: int = 1,
) -> int:
    """The most pictures at a time that fit, of ``CHUNKS``.

    Args:
        most: no more than these; None: as many as the device is the faster for.
        least: a multiple of it is returned: pictures that go together.

    Raises:
        MemoryShortError: not even ``least`` do.
    """
    if most is None:
        most = max(CHUNKS) if device.type == "cuda" else MOST_ON_CPU
    available, needed = available_bytes(device), 0
    for chunk in _chunks(most, least):
        needed = estimate_memory(checkpoint, chunk=chunk, dtype=dtype, texts=texts)
        if needed <= available:
            return chunk
    raise memory_short(f'the checkpoint "{checkpoint.name}"', needed, available)


def _chunks(most: int, least: int) -> list[int]:
    """``most`` and the smaller ones of CHUNKS, in multiples of ``least``; ``least`` at the end."""
    some = [n // least * least for n in (most, *(n for n in CHUNKS if n < most))]
    return [n for n in dict.fromkeys(some) if n > least] + [least]
