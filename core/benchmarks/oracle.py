"""A guidance that knows the answer: exact pictures of one solid in place of a network's."""

import torch
from jaxtyping import Float
from torch import Tensor

from core.camera import Cameras
from core.guidance.builtin.diffusion import alpha_bar_schedule
from core.guidance.gaussian import GaussianGuidance, PromptedGaussian, Reference
from core.guidance.guidance import Views
from core.prior.families import Shape
from core.prior.tracer import render

AT_ONCE = 4  # views traced together


class Oracle(GaussianGuidance):
    """The solid's own pictures, as the built-in prior draws them, of ``size`` pixels a side.

    What a training makes with it is the best that any network could get out of that training.
    """

    def __init__(self, shape: Shape, size: int = 64) -> None:
        super().__init__(traced(shape, size), size, std=0.0, normal_frame="object")
        self.alpha_bar = alpha_bar_schedule()

    def prompted(self, prompt: str = "", negative_prompt: str = "") -> "PromptedOracle":
        """One solid; the prompts change nothing."""
        del prompt, negative_prompt
        return PromptedOracle(self)


class PromptedOracle(PromptedGaussian):
    """An ε̂ that leads every noisy latent to the solid's picture, and that picture itself."""

    def restore(self, pictures: Float[Tensor, "b 4 s s"], views: Views) -> Float[Tensor, "b 4 s s"]:
        """The solid's pictures, whatever the shape's own look like."""
        return self.reference(views.cameras)[0].to(pictures)


def traced(shape: Shape, size: int) -> Reference:
    """The solid's latents. Those of the last cameras are kept, for denoising asks often."""
    kept: list[tuple[Cameras, Tensor]] = []

    def reference(cameras: Cameras) -> Float[Tensor, "1 b 4 s s"]:
        if not kept or kept[0][0] is not cameras:
            parts = [cameras[slice(k, k + AT_ONCE)] for k in range(0, len(cameras), AT_ONCE)]
            seen = [render(shape, part, size) for part in parts]
            kept[:] = [
                (cameras, torch.cat([torch.cat([x.normal, 2 * x.coverage - 1], 1) for x in seen]))
            ]
        return kept[0][1][None]

    return reference
