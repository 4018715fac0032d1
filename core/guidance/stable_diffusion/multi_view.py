"""MVDream (Shi et al. 2023): four views of an object denoised together, each with its camera.

Its U-Net is Stable Diffusion's with two changes (§3.1, §3.2): self-attention runs over the pixels
of all four views, and a network of two layers turns each camera into something that is added to the
embedding of the time. A text-to-image checkpoint draws a face on every side; this one does not.
"""

from typing import Any

import torch
from jaxtyping import Float
from torch import Tensor, nn

from core.camera import Cameras
from core.guidance.stable_diffusion.multi_view_names import CAMERA, TOGETHER


def across_views(tokens: Float[Tensor, "b l c"]) -> Float[Tensor, "g m c"]:
    """The tokens of a group's views as one sequence."""
    return tokens.reshape(len(tokens) // TOGETHER, -1, tokens.shape[-1])


class AcrossViews:
    """An attention processor of diffusers' that lets every pixel see all views of its group."""

    def __init__(self, usual: Any) -> None:
        self.usual = usual

    def __call__(self, attn: Any, hidden_states: Tensor, *args: Any, **kwargs: Any) -> Tensor:
        joined = across_views(hidden_states)
        return self.usual(attn, joined, *args, **kwargs).reshape(hidden_states.shape)


class MultiViewUNet(nn.Module):
    """diffusers' U-Net of Stable Diffusion 2 with MVDream's two changes."""

    def __init__(self, unet: Any) -> None:
        super().__init__()
        self.unet = unet
        width = 4 * unet.config.block_out_channels[0]
        layers = nn.Linear(CAMERA, width), nn.SiLU(), nn.Linear(width, width)
        self.camera_embed = nn.Sequential(*layers)
        self._cameras: Tensor | None = None
        unet.set_attn_processor(
            {
                name: AcrossViews(usual) if ".attn1." in name else usual
                for name, usual in unet.attn_processors.items()
            }
        )
        # The embedding of the time is the one place that reaches every block.
        unet.time_embedding.register_forward_hook(self._with_cameras)

    @property
    def config(self) -> Any:
        """The inner U-Net's."""
        return self.unet.config

    @property
    def dtype(self) -> torch.dtype:
        """Of its weights."""
        return self.unet.dtype

    @property
    def device(self) -> torch.device:
        """Of its weights."""
        return self.unet.device

    def forward(
        self, z_t: Tensor, t: Tensor, *, cameras: Float[Tensor, "b 16"], **given: Any
    ) -> Any:
        """The inner U-Net's output; ``z_t`` holds whole groups of views, one after another."""
        self._cameras = cameras
        try:
            return self.unet(z_t, t, **given)
        finally:
            self._cameras = None

    def _with_cameras(self, _module: nn.Module, _given: Any, time: Tensor) -> Tensor:
        assert self._cameras is not None
        return time + self.camera_embed(self._cameras.to(time.dtype))


def inner_unet(unet: Any) -> Any:
    """diffusers' U-Net itself, whose layers a LoRA names."""
    return unet.unet if isinstance(unet, MultiViewUNet) else unet


def camera_numbers(cameras: Cameras) -> Float[Tensor, "b 16"]:
    """Each camera's matrix, camera to world, as MVDream was trained with it.

    At distance 1, whatever it is here; +Z is up. Its objects face +X where ours face -Y, so the
    scene is turned by 90 degrees.
    """
    n = len(cameras)
    matrix = torch.zeros(n, 4, 4, dtype=cameras.azimuth.dtype, device=cameras.azimuth.device)
    turned = Cameras(
        cameras.azimuth + torch.pi / 2, cameras.elevation, cameras.distance, cameras.fovy
    )
    matrix[:, :3, :3] = turned.rotation.transpose(1, 2)
    matrix[:, :3, 3] = turned.back
    matrix[:, 3, 3] = 1
    return matrix.flatten(1)
