"""A guidance that knows the answer: exact pictures of one solid in place of a network's."""

import torch
from jaxtyping import Float, Int
from torch import Tensor

from core.camera import Cameras
from core.guidance.builtin.diffusion import alpha_bar_schedule
from core.guidance.guidance import Embedding, Guidance, NormalFrame, Views, coarse_latent
from core.prior.families import Shape
from core.prior.tracer import render

AT_ONCE = 4  # views traced together


class Oracle(Guidance):
    """ε̂ that leads every noisy latent to the solid's own picture, as the built-in prior draws it.

    What a training makes with it is the best that any network could get out of that training.
    """

    normal_frame: NormalFrame = "object"

    def __init__(self, shape: Shape, size: int = 64) -> None:
        """``size``: side of the pictures, pixels."""
        self.shape, self.latent_size = shape, size
        self.alpha_bar = alpha_bar_schedule()
        self._seen: tuple[Cameras, Tensor] | None = None

    def embed(self, prompt: str, negative_prompt: str) -> Embedding:
        """Words mean nothing here."""
        del prompt, negative_prompt
        return Embedding()

    def encode_normals(
        self, n: Float[Tensor, "b h w 3"], o: Float[Tensor, "b h w 1"]
    ) -> Float[Tensor, "b 4 s s"]:
        """[n * o, 2o - 1], area-downsampled, as for the built-in prior."""
        return coarse_latent(n, o, self.latent_size)

    def encode_color(
        self, srgb: Float[Tensor, "b h w 3"], o: Float[Tensor, "b h w 1"]
    ) -> Float[Tensor, "b 4 s s"]:
        """Raises NotImplementedError: the solid has no colour."""
        raise NotImplementedError("the oracle knows shapes alone")

    def eps_hat(
        self,
        z_t: Float[Tensor, "b 4 s s"],
        t: Int[Tensor, " b"],
        embedding: Embedding,
        views: Views,
        guidance_scale: float,
    ) -> Float[Tensor, "b 4 s s"]:
        """The noise that takes the true picture to ``z_t``."""
        del embedding, guidance_scale
        a = self.alpha_bar[t][:, None, None, None]
        return (z_t - a.sqrt() * self._truth(views.cameras)) / (1 - a).sqrt()

    def _truth(self, cameras: Cameras) -> Float[Tensor, "b 4 s s"]:
        """The solid's pictures; those of the last cameras are kept, for denoising asks often."""
        if self._seen is None or self._seen[0] is not cameras:
            parts = [cameras[slice(k, k + AT_ONCE)] for k in range(0, len(cameras), AT_ONCE)]
            seen = [render(self.shape, part, self.latent_size) for part in parts]
            pictures = [torch.cat([x.normal, 2 * x.coverage - 1], 1) for x in seen]
            self._seen = cameras, torch.cat(pictures)
        return self._seen[1]
