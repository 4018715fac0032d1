"""Guidance with a known answer: the exact score of a Gaussian mixture over reference pictures.

Around each of K reference latents μ_k of the very camera is a Gaussian of standard deviation
``std``. Diffused, it is N(sqrt(alpha_bar) μ_k, (alpha_bar std² + sigma²) I), so the noise that
the optimal denoiser predicts is known in closed form (Karras et al. 2022, appendix B.3):

    ε̂ = -sigma ∇ log p(z_t) = sigma (z_t - sqrt(alpha_bar) Σ_k r_k μ_k) / (alpha_bar std² + sigma²)
    r = softmax_k(-|z_t - sqrt(alpha_bar) μ_k|² / 2 (alpha_bar std² + sigma²))

It rebuilds given shapes. With it a fault of the geometry's code is distinguished
from a weakness of a learnt prior: for tests, never a feature.
"""

from collections.abc import Callable, Sequence

import torch
from jaxtyping import Float, Int
from torch import Tensor

from core.camera import Cameras
from core.guidance.guidance import (
    Guidance,
    NormalFrame,
    Predictions,
    PromptedGuidance,
    Views,
    coarse_latent,
)
from core.render.normals import render_normals

# K reference latents for each of the cameras.
Reference = Callable[[Cameras], Float[Tensor, "k b 4 s s"]]


class GaussianGuidance(Guidance):
    """ε̂ of a mixture over ``reference``; it takes no prompt and knows no guidance scale."""

    def __init__(
        self,
        reference: Reference,
        latent_size: int,
        *,
        std: float = 0.2,
        normal_frame: NormalFrame = "camera",
    ) -> None:
        """Make the exact guidance.

        Args:
            reference: the mixture's means, in the latents' range, at the requested cameras.
            latent_size: side of the reference latents.
            std: how far a picture may be from a reference, in the latents' units; also how
                softly the nearest reference is chosen.
            normal_frame: the axes of the references' normals.
        """
        self.reference, self.latent_size, self.std = reference, latent_size, std
        self.normal_frame = normal_frame
        self.alpha_bar = scaled_linear()

    def prompted(self, prompt: str = "", negative_prompt: str = "") -> "PromptedGaussian":
        """The exact score; the prompts change nothing."""
        del prompt, negative_prompt
        return PromptedGaussian(self)

    def encode_normals(
        self, n: Float[Tensor, "b h w 3"], o: Float[Tensor, "b h w 1"]
    ) -> Float[Tensor, "b 4 s s"]:
        """The coarse latent: there is no other."""
        return coarse_latent(n, o, self.latent_size)

    def encode_color(
        self, srgb: Float[Tensor, "b h w 3"], o: Float[Tensor, "b h w 1"]
    ) -> Float[Tensor, "b 4 s s"]:
        """[2 c - 1, 2 o - 1] with the first three weighted by coverage, downsampled."""
        return coarse_latent(2 * srgb - o, o, self.latent_size)


class PromptedGaussian(PromptedGuidance):
    """The mixture's score. There is no other to compare it with, so guidance scales do nothing."""

    def __init__(self, guidance: GaussianGuidance) -> None:
        super().__init__(guidance)
        self.reference, self.std = guidance.reference, guidance.std

    @torch.no_grad()
    def predict(
        self,
        z_t: Float[Tensor, "b 4 s s"],
        t: Int[Tensor, " b"],
        views: Views,
        *,
        cond_only: bool = False,
        apart: bool = False,
    ) -> Predictions:
        """The exact noise prediction at ``views.cameras``."""
        del cond_only, apart
        mu = self.reference(views.cameras).to(z_t)
        return Predictions(mixture_eps(z_t, self.alpha_bar.to(z_t)[t], mu, self.std))


def mixture_eps(
    z_t: Float[Tensor, "b 4 s s"],
    alpha_bar: Float[Tensor, " b"],
    mu: Float[Tensor, "k b 4 s s"],
    std: float,
) -> Float[Tensor, "b 4 s s"]:
    """ε̂ of the equally weighted mixture of N(μ_k, std² I); the formula at the file's head."""
    alpha_bar = alpha_bar[:, None, None, None]
    variance = alpha_bar * std**2 + 1 - alpha_bar
    apart = z_t - alpha_bar.sqrt() * mu
    # The densities' common factor is left out: the softmax divides it away.
    log_r = -(apart.square() / (2 * variance)).sum((2, 3, 4))
    r = log_r.softmax(0)[:, :, None, None, None]
    return (1 - alpha_bar).sqrt() * (r * apart).sum(0) / variance


def mesh_reference(
    meshes: Sequence[tuple[Float[Tensor, "_v 3"], Int[Tensor, "_f 3"]]],
    latent_size: int,
    *,
    render_size: int = 64,
    normal_frame: NormalFrame = "camera",
) -> Reference:
    """The coarse latents of closed meshes, drawn by the project's own renderer at each call."""

    def reference(cameras: Cameras) -> Float[Tensor, "k b 4 s s"]:
        with torch.no_grad():
            pictures = [
                render_normals(verts, faces, cameras.to(verts.device), render_size, normal_frame)
                for verts, faces in meshes
            ]
        return torch.stack([coarse_latent(n, o, latent_size) for n, o in pictures])

    return reference


def scaled_linear(
    steps: int = 1000, start: float = 0.00085, end: float = 0.012
) -> Float[Tensor, " {steps}"]:
    """alpha_bar of Stable Diffusion's schedule: beta is linear in its square root."""
    # In float64: a product of a thousand factors just below 1.
    root = torch.linspace(start**0.5, end**0.5, steps, dtype=torch.float64)
    return (1 - root.square()).cumprod(0).float()
