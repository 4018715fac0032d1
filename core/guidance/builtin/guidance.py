"""The built-in prior as a guidance: two small diffusion models that travel with the project.

The geometry network paints object-frame normals, the appearance network paints colours onto given
normals. Both work on pictures of 64² without an autoencoder: the latent is the picture.
"""

import warnings
from dataclasses import dataclass
from pathlib import Path

import torch
from jaxtyping import Float, Int
from safetensors import SafetensorError
from torch import Tensor

from core.camera import Cameras
from core.errors import MissingError
from core.guidance.builtin.diffusion import alpha_bar_schedule
from core.guidance.builtin.hint import hint
from core.guidance.builtin.network import BLOCK, UNet, camera_map
from core.guidance.builtin.palette import finishes_of
from core.guidance.builtin.vocabulary import SLOTS, Known, Words, parse
from core.guidance.builtin.weights import load_weights, load_words
from core.guidance.guidance import (
    Embedding,
    Guidance,
    MaterialRanges,
    NormalFrame,
    PromptWarning,
    Views,
    coarse_latent,
)
from core.guidance.sds import eps_from_v, guide

WEIGHTS = Path(__file__).parent  # the two networks, next to the code that asks them
SIZE = 64
GEOMETRY_SLOTS = ("noun", "shape", "part")
APPEARANCE_SLOTS = ("noun", "color", "material", "pattern", "second")


@dataclass(frozen=True)
class BuiltinEmbedding(Embedding):
    """The two prompts, read."""

    words: Words
    negative: Words


class BuiltinGuidance(Guidance):
    """ε̂ of the built-in networks.

    The unconditional branch says the negative prompt's words, or none, and keeps the camera, so
    that guidance pulls towards the word and not towards having a camera.
    """

    normal_frame: NormalFrame = "object"
    latent_size = SIZE

    def __init__(
        self, geometry: UNet, appearance: UNet, known: Known = SLOTS, ignore_unknown: bool = False
    ) -> None:
        self.geometry, self.appearance = geometry, appearance
        self.known, self.ignore_unknown = known, ignore_unknown
        self.device = next(geometry.parameters()).device
        self.alpha_bar = alpha_bar_schedule().to(self.device)
        self.half = has_fast_bfloat16(self.device)

    def embed(self, prompt: str, negative_prompt: str) -> BuiltinEmbedding:
        """Raises ``UserError`` for words that are not in the vocabulary, unless they are ignored.

        Warns, as ``PromptWarning``, of what was read as another word or left out.
        """
        options = {"known": self.known, "ignore_unknown": self.ignore_unknown}
        words = parse(prompt, **options)
        negative = parse(negative_prompt, noun_needed=False, **options)
        for note in (*words.notes, *negative.notes):
            warnings.warn(note, PromptWarning, stacklevel=2)
        return BuiltinEmbedding(words, negative)

    def ranges(self, embedding: Embedding) -> MaterialRanges:
        """The roughness and metallic that the words' parts are painted with, and a little around.

        At 64² a rough metal and a dark plastic look alike; the words tell them apart.
        """
        if not isinstance(embedding, BuiltinEmbedding):
            raise TypeError("the embedding comes from another guidance")
        finishes = finishes_of(embedding.words.noun, embedding.words.material)
        rough, metal = ([getattr(f, n) for f in finishes] for n in ("roughness", "metallic"))
        return MaterialRanges(
            (max(min(rough) - 0.15, 0.05), min(max(rough) + 0.1, 0.95)),
            (max(min(metal) - 0.02, 0.0), min(max(metal) + 0.02, 1.0)),
        )

    def encode_normals(
        self, n: Float[Tensor, "b h w 3"], o: Float[Tensor, "b h w 1"]
    ) -> Float[Tensor, "b 4 s s"]:
        """[n * o, 2o - 1], area-downsampled."""
        return coarse_latent(n, o, SIZE)

    def encode_color(
        self, srgb: Float[Tensor, "b h w 3"], o: Float[Tensor, "b h w 1"]
    ) -> Float[Tensor, "b 4 s s"]:
        """[(2 srgb - 1) * o, 2o - 1], area-downsampled; ``srgb`` comes weighted by coverage."""
        return coarse_latent(2 * srgb - o, o, SIZE)

    @torch.no_grad()
    def eps_hat(
        self,
        z_t: Float[Tensor, "b 4 s s"],
        t: Int[Tensor, " b"],
        embedding: Embedding,
        views: Views,
        guidance_scale: float,
    ) -> Float[Tensor, "b 4 s s"]:
        """Both branches in one batch; with ``views.surface`` the appearance network answers."""
        if not isinstance(embedding, BuiltinEmbedding):
            raise TypeError("the embedding comes from another guidance")
        paints = views.surface is not None
        net = self.appearance if paints else self.geometry
        slots = APPEARANCE_SLOTS if paints else GEOMETRY_SLOTS
        count = len(z_t)
        said = torch.tensor([embedding.words.indices(slots), embedding.negative.indices(slots)])
        words = said.to(self.device).repeat_interleave(count, 0)
        told = None
        if views.surface is not None:
            surface = torch.nn.functional.adaptive_avg_pool2d(views.surface, SIZE)
            told = hint(surface.repeat(2, 1, 1, 1), words)
        camera = self._camera_map(views.cameras).repeat(2, 1, 1, 1)
        pair = z_t.repeat(2, 1, 1, 1)
        with torch.autocast(self.device.type, torch.bfloat16, enabled=self.half):
            v = net(pair, t.repeat(2), words, camera, told).float()
        eps_cond, eps_uncond = eps_from_v(v, pair, self.alpha_bar[t].repeat(2)).chunk(2)
        return guide(eps_cond, eps_uncond, guidance_scale)

    def _camera_map(self, cameras: Cameras) -> Float[Tensor, "b 6 m m"]:
        return camera_map(cameras.to(self.device), SIZE // BLOCK)


def has_fast_bfloat16(device: torch.device) -> bool:
    """Whether half precision is worth it: on a GPU, or on a CPU with its own units for it."""
    if device.type != "cpu":
        return True
    flags = torch.cpu.get_capabilities()
    return bool(flags.get("amx_bf16") or flags.get("avx512_bf16"))


def load_builtin(device: "torch.device | str", *, ignore_unknown: bool = False) -> BuiltinGuidance:
    """The shipped networks on ``device``; ``ignore_unknown`` leaves out words that are unknown.

    Raises ``MissingError`` when the weights are not there or broken.
    """
    nets, known = [], {}
    for name in ("geometry", "appearance"):
        path = WEIGHTS / f"{name}.safetensors"
        try:
            nets.append(load_weights(path).to(device))
            known |= load_words(path)
        except (FileNotFoundError, SafetensorError) as error:
            raise MissingError(
                f"The built-in prior's weights {path.name} are missing or broken ({error}).",
                "Fetch them again with the project, or train them: python -m core.prior train.",
            ) from error
    return BuiltinGuidance(*nets, known, ignore_unknown)
