"""Stable Diffusion 1.x, 2.x and XL as guidance.

The latent is the mean of the encoder's posterior, times the checkpoint's scaling factor. The mean,
not a sample: the posterior's spread is far below the noise that SDS adds, and a step then depends
on its seed through that noise alone.
"""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from typing import Any, Final

import torch
from jaxtyping import Float, Int
from torch import Tensor
from torch.nn.functional import interpolate

from core.camera import Cameras
from core.config import GUIDANCE, GuidanceConfig
from core.errors import UserError
from core.guidance.guidance import Guidance, Predictions, PromptedGuidance, Views, Work
from core.guidance.sds import eps_from_v
from core.guidance.stable_diffusion.checkpoint import find_checkpoint
from core.guidance.stable_diffusion.conditions import conditions, downscale
from core.guidance.stable_diffusion.embedding import read_embedding
from core.guidance.stable_diffusion.fit import busy_bytes, chunk_that_fits
from core.guidance.stable_diffusion.lora import add_lora
from core.guidance.stable_diffusion.memory import memory_short
from core.guidance.stable_diffusion.multi_view import MultiViewUNet, camera_numbers, inner_unet
from core.guidance.stable_diffusion.multi_view_names import TOGETHER
from core.guidance.stable_diffusion.networks import Networks, load_networks
from core.guidance.stable_diffusion.prompts import (
    AROUND,
    DEFAULT_NEGATIVE_PROMPT,
    VIEWS,
    clean_prompt,
    opposing_weights,
    require_prompt,
    view_weights,
    view_words,
    warn_cut,
    warn_unused,
)
from core.guidance.stable_diffusion.source import Additions, Checkpoint
from core.guidance.stable_diffusion.texts import Texts
from core.guidance.stable_diffusion.work import work_of

# Grey is a normal of length 0, so an empty picture states no direction; white is what a
# text-to-image model's object shots have behind them.
NORMAL_BACKGROUND: Final = 0.5
COLOR_BACKGROUND: Final = 1.0
NOTHING: Final = Additions()


class _Encode(torch.autograd.Function):
    """A picture through the encoder without keeping its activations: backward runs it again.

    Backward sends a gradient of unit size, because one of SDS's size (1e-6 and less) would be
    rounded to zero in 16 bit.
    """

    @staticmethod
    def forward(ctx: Any, picture: Tensor, encode: Callable[[Tensor], Tensor]) -> Tensor:
        ctx.encode = encode
        ctx.save_for_backward(picture)
        return encode(picture)

    @staticmethod
    def backward(ctx: Any, *grads: Tensor) -> tuple[Tensor, None]:
        (picture,) = ctx.saved_tensors
        # ``tiny`` keeps a gradient of nothing at 0 / tiny = 0.
        size = grads[0].abs().amax().clamp(min=torch.finfo(grads[0].dtype).tiny)
        with torch.enable_grad(), _out_of_memory("the gradient of the encoder"):
            grad = _encoder_gradient(ctx.encode, picture.detach(), grads[0] / size)
        return grad * size, None


def _encoder_gradient(encode: Callable[[Tensor], Tensor], picture: Tensor, grad: Tensor) -> Tensor:
    """The gradient at the pictures; half of them at a time where memory does not hold all."""
    try:
        picture.requires_grad_()
        return torch.autograd.grad(encode(picture), picture, grad)[0]
    except torch.OutOfMemoryError:
        if len(picture) == 1:
            raise
    picture, half = picture.detach(), len(picture) // 2
    parts = zip(picture.split(half), grad.split(half), strict=True)
    return torch.cat([_encoder_gradient(encode, *part) for part in parts])


class StableDiffusion(Guidance):
    """ε̂_φ of a Stable Diffusion checkpoint (Rombach et al. 2022), the paper's guidance."""

    normal_frame = "camera"

    def __init__(
        self,
        networks: Networks,
        *,
        zero_empty: bool = False,
        chunk: int = 4,
        config: GuidanceConfig = GUIDANCE,
    ) -> None:
        """Wire the parts together; ``load`` is the usual way.

        Args:
            zero_empty: see ``Texts``.
            chunk: pictures that go through the U-Net or the encoder at a time. The result does
                not depend on it.
        """
        # Frozen: the encoder's gradient is needed at its input alone.
        self.unet = networks.unet.requires_grad_(False).eval()
        self.vae = networks.vae.requires_grad_(False).eval()
        self.prediction_type = _prediction_type(networks.scheduler)
        self.alpha_bar = networks.scheduler.alphas_cumprod.float().to(self.unet.device)
        self.takes_cameras = isinstance(self.unet, MultiViewUNet)
        self.views_together = TOGETHER if self.takes_cameras else 1
        self._unet_config = self.unet.config
        self.latent_size = int(self._unet_config.sample_size)
        self.texts = Texts(networks.encoders, zero_empty=zero_empty)
        self.chunk, self.config = chunk, config
        self._checkpoint: Checkpoint | None = None  # where it was loaded from

    @classmethod
    def load(
        cls,
        spec: str,
        device: "torch.device | str",
        *,
        chunk: int | None = None,
        config: GuidanceConfig = GUIDANCE,
        additions: Additions = NOTHING,
    ) -> "StableDiffusion":
        """The checkpoint that ``spec`` names: in 16 bit on CUDA, in 32 bit elsewhere.

        The text encoder stays in the machine's memory: it runs once. At most ``chunk``
        pictures go through at a time; without it, as many as fit.

        Raises:
            UserError: no such checkpoint, or one that cannot be used; the message gives the reason.
            MissingError: a hub id that is not on this machine.
            MemoryShortError: not even one picture at a time fits.
        """
        checkpoint, device = find_checkpoint(spec), torch.device(device)
        if config.prediction != "auto":
            checkpoint = replace(checkpoint, prediction=config.prediction)
        dtype = torch.float16 if device.type == "cuda" else torch.float32
        # FIT: estimated from the configuration, before any weights are read
        if checkpoint.family == "mvdream" and (config.perp_neg or config.soft_views):
            raise UserError(
                "MVDream takes the cameras themselves: it has no texts of views to weight.",
                "Leave guidance.perp_neg and guidance.soft_views out.",
            )
        least = TOGETHER if checkpoint.family == "mvdream" else 1
        chunk = chunk_that_fits(checkpoint, device, dtype, chunk, texts=_texts(config), least=least)
        # PARTS: networks in the precision they run in; the text encoders run once, on the CPU
        networks = load_networks(checkpoint, dtype)
        models = tuple(encoder.model for encoder in networks.encoders)
        for path, strength in additions.loras.items():
            add_lora(Path(path), strength, inner_unet(networks.unet), models)
        with _out_of_memory("the checkpoint"):
            networks.unet.to(device)
            networks.vae.to(device)
        guidance = cls(networks, zero_empty=checkpoint.zero_empty, chunk=chunk, config=config)
        guidance._checkpoint = checkpoint
        if device.type == "cuda":  # only there it decides how many views are rendered together
            given = {"chunk": chunk, "dtype": dtype, "texts": _texts(config)}
            guidance.busy_bytes = busy_bytes(checkpoint, **given)
        for path in additions.embeddings:
            guidance.texts.add_words(*read_embedding(Path(path), guidance.texts.widths))
        return guidance

    def prompted(self, prompt: str, negative_prompt: str) -> "PromptedStableDiffusion":
        """CLIP's states of the prompt seen from each side, and of the negative prompt.

        An empty negative prompt is DEFAULT_NEGATIVE_PROMPT, unless that is switched off: then it
        is CLIP's empty text, the true unconditional. What exceeds the encoder's 77 tokens is cut,
        with a ``PromptCutWarning``.
        """
        prompt = require_prompt(prompt)
        negative = clean_prompt(negative_prompt, "negative prompt")
        if not negative and self.config.default_negative:
            negative = DEFAULT_NEGATIVE_PROMPT
        for word in self.texts.unused(prompt, negative):
            warn_unused(word)
        # One text for each side of the object: the weights of each camera mix them later.
        tokens, cuts = zip(
            *(self.texts.tokens(prompt, self._view_words(view)) for view in VIEWS), strict=True
        )
        negative_tokens, negative_cut = self.texts.tokens(negative, "")
        if any(cuts):
            warn_cut(max(cuts, key=len))
        if negative_cut:
            warn_cut(negative_cut, "negative prompt")
        # Once for all steps: the prompt does not change during a training.
        empty_tokens, _ = self.texts.tokens("", "")
        states = self.texts.encode([*tokens, negative_tokens, empty_tokens])
        *views, negative, empty = states.to(self.unet.device, self.unet.dtype)
        return PromptedStableDiffusion(self, torch.stack(views), negative, empty)

    def of_views(self, cameras: Cameras, *, soft: bool) -> Float[Tensor, "b v"]:
        """What depends on the camera alone: the weights of ``VIEWS``, then MVDream's 16 numbers."""
        weights = view_weights(cameras, soft=soft)
        return torch.cat([weights, camera_numbers(cameras)], -1) if self.takes_cameras else weights

    def _view_words(self, view: str) -> str:
        return "" if self.takes_cameras else view_words(view)

    def work(self) -> Work | None:
        """From the checkpoint's configuration."""
        return work_of(self._checkpoint, _texts(self.config)) if self._checkpoint else None

    def encode_normals(
        self, n: Float[Tensor, "b h w 3"], o: Float[Tensor, "b h w 1"]
    ) -> Float[Tensor, "b 4 s s"]:
        """z of the picture (n + 1) / 2, laid over grey (§4.2, the late phase)."""
        return self._encode((n + o) / 2 + (1 - o) * NORMAL_BACKGROUND)

    def encode_color(
        self, srgb: Float[Tensor, "b h w 3"], o: Float[Tensor, "b h w 1"]
    ) -> Float[Tensor, "b 4 s s"]:
        """z of the shaded picture, laid over white (§4.3)."""
        return self._encode(srgb + (1 - o) * COLOR_BACKGROUND)

    def eps(
        self,
        z_t: Float[Tensor, "b 4 s s"],
        t: Int[Tensor, " b"],
        text: Float[Tensor, "b l d"],
        cameras: Float[Tensor, "b camera"] | None = None,
    ) -> Float[Tensor, "b 4 s s"]:
        """ε̂ of the U-Net for a text of each picture, and its camera (16 numbers) where it takes
        cameras."""
        given = conditions(self._unet_config, text, self._side)
        if self.takes_cameras:
            given["cameras"] = cameras
        out = self.unet(z_t.to(self.unet.dtype), t, **given).sample.to(z_t)
        if self.prediction_type == "epsilon":
            return out
        return eps_from_v(out, z_t, self.alpha_bar.to(z_t)[t])

    @property
    def _side(self) -> int:
        """Of the pictures that the model was trained with, pixels."""
        return self.latent_size * downscale(self.vae.config)

    def _encode(self, picture: Float[Tensor, "b h w 3"]) -> Float[Tensor, "b 4 s s"]:
        """``picture`` in [0, 1], of any size."""
        picture = picture.permute(0, 3, 1, 2) * 2 - 1
        side = self._side
        if picture.shape[-2:] != (side, side):
            # Antialiased, so that a larger render is averaged and every pixel gets a gradient.
            picture = interpolate(picture, (side, side), mode="bilinear", antialias=True)
        with _out_of_memory("the encoder"):
            return torch.cat(self.by_chunk(lambda x: _Encode.apply(x, self._mean), picture))

    def by_chunk(self, run: Callable[..., Any], *given: Tensor) -> list[Any]:
        """What ``run`` makes of ``chunk`` pictures at a time; of half as many from where memory
        does not hold them."""
        while True:
            try:
                return [run(*x) for x in zip(*(y.split(self.chunk) for y in given), strict=True)]
            except torch.OutOfMemoryError:
                # MVDream's views of a group stay together.
                if self.chunk <= self.views_together:
                    raise
            k = self.views_together
            self.chunk = max(self.chunk // 2 // k * k, k)
            if given[0].device.type == "cuda":
                torch.cuda.empty_cache()

    def _mean(self, picture: Tensor) -> Tensor:
        posterior = self.vae.encode(picture.to(self.vae.dtype)).latent_dist
        # SD 1 and 2 have none.
        shift = getattr(self.vae.config, "shift_factor", None) or 0.0
        return ((posterior.mean - shift) * self.vae.config.scaling_factor).to(picture.dtype)


class PromptedStableDiffusion(PromptedGuidance):
    """ε̂_φ for one prompt; the negative prompt takes the place of the unconditional one."""

    def __init__(
        self,
        guidance: StableDiffusion,
        views: Float[Tensor, "5 l d"],
        negative: Float[Tensor, "l d"],
        empty: Float[Tensor, "l d"],
    ) -> None:
        """
        Args:
            views: CLIP's last hidden states of the prompt, for each of ``VIEWS``.
            negative, empty: those of the negative prompt, and of no words.
        """
        super().__init__(guidance)
        self.diffusion, self.views, self.negative, self.empty = guidance, views, negative, empty
        self._soft_views = guidance.config.soft_views
        self._perp_neg = guidance.config.perp_neg

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
        """The U-Net's predictions, ``chunk`` pictures at a time."""
        weights = self.diffusion.of_views(views.cameras, soft=self._soft_views).to(z_t.device)
        given, others = (z_t, t.to(z_t.device), weights), self._others(cond_only, apart)
        with _out_of_memory("the U-Net"):
            parts = self.diffusion.by_chunk(lambda *x: self._predict(*x, others), *given)
        cond, *rest = (torch.cat(part) for part in zip(*parts, strict=True))
        if not rest:
            return Predictions(cond)
        negative = rest.pop(1) if apart else None
        if not self._perp_neg:
            return Predictions(cond, rest[0], negative=negative)
        # Only the sides around the vertical have predictions.
        opposing_weight = self._perp_neg * opposing_weights(weights[:, : len(VIEWS)])[:, :AROUND].T
        return Predictions(cond, rest[0], torch.stack(rest[1:]), opposing_weight, negative)

    def _others(self, cond_only: bool, apart: bool) -> list[Tensor]:
        """The texts next to the prompt's: what it is compared with, then Perp-Neg's sides."""
        # One text is half of the work. Perp-Neg acts at guidance scale 1 too, and needs the others.
        if cond_only and not self._perp_neg:
            return []
        compared = [self.empty, self.negative] if apart else [self.negative]
        return compared + (list(self.views[:AROUND]) if self._perp_neg else [])

    def _predict(
        self, z_t: Tensor, t: Tensor, weights: Tensor, others: list[Tensor]
    ) -> tuple[Tensor, ...]:
        """For the prompt, then for each of the ``others``."""
        weights, cameras = weights.to(self.views).split(
            [len(VIEWS), weights.shape[1] - len(VIEWS)], 1
        )
        texts = [torch.einsum("bv,vld->bld", weights, self.views)]
        texts += [text.expand_as(texts[0]) for text in others]
        # All texts of a picture in one batch: the U-Net's weights are read once.
        n = len(texts)
        z_t, t, cameras = z_t.repeat(n, 1, 1, 1), t.repeat(n), cameras.repeat(n, 1)
        return self.diffusion.eps(z_t, t, torch.cat(texts), cameras).chunk(n)


def _texts(config: GuidanceConfig) -> int:
    """Predictions of a picture that run together."""
    return 2 + AROUND if config.perp_neg else 2


def _prediction_type(scheduler: Any) -> str:
    kind = scheduler.config.prediction_type
    if kind not in ("epsilon", "v_prediction"):
        raise UserError(
            f"The checkpoint predicts {kind}; expected epsilon or v_prediction.",
            "Use another checkpoint, or correct prediction_type in scheduler_config.json.",
        )
    return kind


@contextmanager
def _out_of_memory(what: str) -> Iterator[None]:
    try:
        yield
    except torch.cuda.OutOfMemoryError as error:
        raise memory_short(what) from error
