"""The renderer and a network of Stable Diffusion's size, on a CUDA device where there is one."""

import torch
from torch import Tensor

from core.benchmarks import ball, row, wall_ms
from core.camera import Cameras
from core.guidance.guidance import coarse_latent
from core.guidance.stable_diffusion import libraries
from core.render.antialias import edge_table
from core.render.normals import render_normals

# Stable Diffusion 1.5's network: what it costs does not depend on its weights.
SD15 = {
    "sample_size": 64,
    "block_out_channels": (320, 640, 1280, 1280),
    "cross_attention_dim": 768,
    "attention_head_dim": 8,
}
TOKENS = 77


def iteration_ms(
    unet: "libraries.UNet2DConditionModel",
    device: torch.device,
    faces: int,
    views: int,
    size: int,
) -> tuple[float, float]:
    """Times of a coarse step: the renderer forward and backward, and with the noise prediction.

    The prediction is the one of classifier-free guidance, so of 2 * ``views`` latents.
    """
    verts, triangles = (x.to(device) for x in ball(faces))
    verts.requires_grad_()
    edges = edge_table(triangles)
    azimuth = torch.arange(views) * (360 / views)
    cameras = Cameras.orbit(azimuth, torch.full((views,), 20.0)).to(device)
    latent_size, width = unet.config["sample_size"], unet.config["cross_attention_dim"]
    words = torch.zeros(2 * views, TOKENS, width, device=device, dtype=unet.dtype)

    def latent() -> Tensor:
        n, o = render_normals(verts, triangles, cameras, size, edges=edges)
        return coarse_latent(n, o, latent_size)

    def render() -> None:
        z = latent()
        torch.autograd.grad(z, verts, torch.ones_like(z))

    def step() -> None:
        z = latent()
        with torch.no_grad():
            noise = unet(torch.cat([z, z]).to(unet.dtype), 500, words).sample.to(z)
        torch.autograd.grad(z, verts, noise[:views] - noise[views:])

    return wall_ms(render, device), wall_ms(step, device)


def rows() -> list[dict]:
    """Nothing where there is no CUDA device."""
    if not torch.cuda.is_available():
        return []
    device = torch.device("cuda")
    unet = libraries.UNet2DConditionModel(**SD15).to(device, torch.float16).eval()
    lines = []
    for faces in (20_000, 80_000):
        render, step = iteration_ms(unet, device, faces, views=24, size=512)
        name = f"{faces:,} faces, 24 views of 512²"
        lines.append(row(f"renderer with gradient, {name} (wall)", render, "ms"))
        lines.append(row(f"a step with a network of SD 1.5's size, {name} (wall)", step, "ms"))
        lines.append(row(f"the renderer's part, {name}", render / step, "", 0.1))
    return lines
