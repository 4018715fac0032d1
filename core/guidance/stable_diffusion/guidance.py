"""Stable Diffusion 1.x and 2.x as guidance: the only file that imports diffusers and transformers.

The latent is the mean of the encoder's posterior, times the checkpoint's scaling factor. The mean,
not a sample: the posterior's spread is far below the noise that SDS adds, and a step then depends
on its seed through that noise alone.
"""

import json
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, Final

import torch
from diffusers import AutoencoderKL, DDPMScheduler, UNet2DConditionModel
from jaxtyping import Float, Int
from safetensors import SafetensorError
from torch import Tensor
from torch.nn.functional import interpolate
from transformers import CLIPTextModel, CLIPTokenizer

from core.config import GUIDANCE, GuidanceConfig
from core.errors import UserError
from core.guidance.guidance import Guidance, Predictions, PromptedGuidance, Views
from core.guidance.sds import eps_from_v
from core.guidance.stable_diffusion.checkpoint import find_checkpoint, read_json, weight_variant
from core.guidance.stable_diffusion.memory import available_bytes, memory_short, peak_bytes
from core.guidance.stable_diffusion.prompts import (
    AROUND,
    DEFAULT_NEGATIVE_PROMPT,
    VIEWS,
    clean_prompt,
    fit_tokens,
    opposing_weights,
    require_prompt,
    view_weights,
    view_words,
    warn_cut,
)

# Grey is a normal of length 0, so an empty picture states no direction; white is what a
# text-to-image model's object shots have behind them.
NORMAL_BACKGROUND: Final = 0.5
COLOR_BACKGROUND: Final = 1.0

_RESERVE: Final = 1.25  # fragments, the kernels' work space, the renderer


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
        unet: UNet2DConditionModel,
        vae: AutoencoderKL,
        scheduler: DDPMScheduler,
        encode_text: Callable[[list[list[int]]], Float[Tensor, "n l d"]],
        tokenizer: CLIPTokenizer | None,
        *,
        chunk: int = 4,
        config: GuidanceConfig = GUIDANCE,
    ) -> None:
        """Wire the parts together; ``load`` is the usual way.

        Args:
            chunk: pictures that go through the U-Net or the encoder at a time. The result does
                not depend on it.
        """
        # Frozen: the encoder's gradient is needed at its input alone.
        self.unet, self.vae = unet.requires_grad_(False).eval(), vae.requires_grad_(False).eval()
        self.prediction_type = _prediction_type(scheduler)
        self.alpha_bar = scheduler.alphas_cumprod.float()
        self.latent_size = int(unet.config.sample_size)
        self._encode_text, self._tokenizer = encode_text, tokenizer
        self.chunk, self.config = chunk, config

    @classmethod
    def load(
        cls,
        spec: str,
        device: "torch.device | str",
        *,
        chunk: int = 4,
        config: GuidanceConfig = GUIDANCE,
    ) -> "StableDiffusion":
        """The checkpoint that ``spec`` names: in 16 bit on CUDA, in 32 bit elsewhere.

        The text encoder stays in the machine's memory: it runs once. Without enough memory for
        ``chunk`` pictures at a time, the largest number that fits is taken.

        Raises:
            UserError: no such checkpoint, or one that cannot be used; the text says why.
            MissingError: a hub id that is not on this machine.
            MemoryShortError: not even one picture at a time fits.
        """
        folder, device = find_checkpoint(spec), torch.device(device)
        dtype = torch.float16 if device.type == "cuda" else torch.float32
        # FIT: estimated from the configuration, before any weights are read
        texts = 2 + AROUND if config.perp_neg else 2
        chunk = _chunk_that_fits(folder, device, dtype, chunk, texts)
        # PARTS: networks in the precision they run in; the text encoder runs once, on the CPU
        unet = _load(UNet2DConditionModel, folder, "unet", dtype)
        vae = _load(AutoencoderKL, folder, "vae", dtype)
        text_encoder = _load(CLIPTextModel, folder, "text_encoder", torch.float32).eval()
        with _readable(folder / "tokenizer"):
            tokenizer = CLIPTokenizer.from_pretrained(folder / "tokenizer", local_files_only=True)
        with _readable(folder / "scheduler"):
            # Whatever the checkpoint samples with: only its noise schedule and prediction type are
            # read.
            scheduler = DDPMScheduler.from_pretrained(folder / "scheduler", local_files_only=True)

        def encode_text(tokens: list[list[int]]) -> Tensor:
            with torch.no_grad():
                return text_encoder(torch.tensor(tokens)).last_hidden_state.to(device, dtype)

        vae.decoder = None  # pictures are never decoded
        with _out_of_memory("the checkpoint"):
            unet, vae = unet.to(device), vae.to(device)
        return cls(unet, vae, scheduler, encode_text, tokenizer, chunk=chunk, config=config)

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
        # One text for each side of the object: the weights of each camera mix them later.
        tokens, cuts = zip(*(self._tokens(prompt, view_words(view)) for view in VIEWS), strict=True)
        negative_tokens, negative_cut = self._tokens(negative, "")
        if any(cuts):
            warn_cut(max(cuts, key=len))
        if negative_cut:
            warn_cut(negative_cut, "negative prompt")
        # Once for all steps: the prompt does not change during a training.
        states = self._encode_text([*tokens, negative_tokens])
        empty = self._encode_text([self._tokens("", "")[0]])[0]
        return PromptedStableDiffusion(self, states[:-1], states[-1], empty)

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
        self, z_t: Float[Tensor, "b 4 s s"], t: Int[Tensor, " b"], text: Float[Tensor, "b l d"]
    ) -> Float[Tensor, "b 4 s s"]:
        """ε̂ of the U-Net for a text of each picture."""
        out = self.unet(z_t.to(self.unet.dtype), t, encoder_hidden_states=text).sample.to(z_t)
        if self.prediction_type == "epsilon":
            return out
        return eps_from_v(out, z_t, self.alpha_bar.to(z_t)[t])

    def _encode(self, picture: Float[Tensor, "b h w 3"]) -> Float[Tensor, "b 4 s s"]:
        """``picture`` in [0, 1], of any size."""
        picture = picture.permute(0, 3, 1, 2) * 2 - 1
        side = self.latent_size * _downscale(self.vae.config)
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
                if self.chunk == 1:
                    raise
            self.chunk //= 2
            if given[0].device.type == "cuda":
                torch.cuda.empty_cache()

    def _mean(self, picture: Tensor) -> Tensor:
        posterior = self.vae.encode(picture.to(self.vae.dtype)).latent_dist
        # SD 1 and 2 have none.
        shift = getattr(self.vae.config, "shift_factor", None) or 0.0
        return ((posterior.mean - shift) * self.vae.config.scaling_factor).to(picture.dtype)

    def _tokens(self, text: str, suffix: str) -> tuple[list[int], str]:
        """The tokens of ``text`` and ``suffix``, and the end of ``text`` that did not fit."""
        tokenizer = self._tokenizer
        ids = [
            tokenizer(part, add_special_tokens=False, verbose=False).input_ids
            for part in (text, suffix)
        ]
        tokens, cut = fit_tokens(
            *ids,
            tokenizer.model_max_length,
            bos=tokenizer.bos_token_id,
            eos=tokenizer.eos_token_id,
            pad=tokenizer.pad_token_id,
        )
        return tokens, tokenizer.decode(cut).strip()


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
        weights = view_weights(views.cameras, soft=self._soft_views).to(z_t.device)
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
        opposing_weight = self._perp_neg * opposing_weights(weights)[:, :AROUND].T
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
        texts = [torch.einsum("bv,vld->bld", weights.to(self.views), self.views)]
        texts += [text.expand_as(texts[0]) for text in others]
        # All texts of a picture in one batch: the U-Net's weights are read once.
        n = len(texts)
        return self.diffusion.eps(z_t.repeat(n, 1, 1, 1), t.repeat(n), torch.cat(texts)).chunk(n)


def estimate_memory(folder: Path, *, chunk: int, dtype: torch.dtype, texts: int = 2) -> int:
    """Bytes that guidance by this checkpoint takes, from its configuration alone.

    The U-Net's and the encoder's weights, and the larger of a guided noise prediction and an
    encoding with its gradient, ``chunk`` pictures each; a quarter is added for what only the
    kernels know.

    Args:
        texts: predictions of a picture that run together; Perp-Neg has more than two.
    """
    with _readable(folder), torch.device("meta"):
        unet = UNet2DConditionModel.from_config(read_json(folder / "unet" / "config.json"))
        vae = AutoencoderKL.from_config(read_json(folder / "vae" / "config.json"))
    vae.decoder = None
    for part in (unet, vae):
        torch.nn.Module.to(part.requires_grad_(False), dtype)  # diffusers' own warns of this
    size, width = int(unet.config.sample_size), int(unet.config.cross_attention_dim)
    side = size * _downscale(vae.config)

    # The two largest loads of a step; they do not run at the same time, so the larger one counts.
    def predict() -> None:
        batch = texts * chunk
        z = torch.empty(batch, 4, size, size, dtype=dtype)
        text = torch.empty(batch, 77, width, dtype=dtype)
        with torch.no_grad():
            unet(z, torch.empty(batch), encoder_hidden_states=text)

    def encode() -> None:
        picture = torch.empty(chunk, 3, side, side, dtype=dtype, requires_grad=True)
        vae.encode(picture).latent_dist.mean.sum().backward()

    weights = sum(p.nbytes for part in (unet, vae) for p in part.parameters())
    return int(_RESERVE * (weights + max(peak_bytes(predict), peak_bytes(encode))))


def _chunk_that_fits(
    folder: Path, device: torch.device, dtype: torch.dtype, chunk: int, texts: int
) -> int:
    available, needed = available_bytes(device), 0
    while chunk >= 1:
        needed = estimate_memory(folder, chunk=chunk, dtype=dtype, texts=texts)
        if needed <= available:
            return chunk
        chunk //= 2
    raise memory_short(f'the checkpoint "{folder}"', needed, available)


def _load(kind: Any, folder: Path, part: str, dtype: torch.dtype) -> Any:
    variant = weight_variant(folder, part, half=dtype == torch.float16)
    with _readable(folder / part):
        model, report = kind.from_pretrained(
            folder / part,
            dtype=dtype,
            variant=variant,
            use_safetensors=True,
            local_files_only=True,
            output_loading_info=True,
        )
    # diffusers and transformers fill missing weights at random and only log it.
    if report["missing_keys"]:
        raise UserError(
            f'"{folder / part}" is incomplete: {len(report["missing_keys"])} of its weights are '
            f"missing, the first {min(report['missing_keys'])}.",
            "Download the checkpoint again.",
        )
    return model


def _prediction_type(scheduler: DDPMScheduler) -> str:
    kind = scheduler.config.prediction_type
    if kind not in ("epsilon", "v_prediction"):
        raise UserError(
            f"The checkpoint predicts {kind}; expected epsilon or v_prediction.",
            "Use another checkpoint, or correct prediction_type in scheduler_config.json.",
        )
    return kind


def _downscale(config: Any) -> int:
    return 2 ** (len(config.block_out_channels) - 1)


@contextmanager
def _readable(path: Path) -> Iterator[None]:
    """Turn what a broken file raises into a sentence."""
    try:
        yield
    except (
        OSError,
        ValueError,
        KeyError,
        TypeError,
        RuntimeError,
        SafetensorError,
        json.JSONDecodeError,
    ) as error:
        if isinstance(error, torch.OutOfMemoryError):
            raise memory_short(f'reading "{path}"') from error
        reason = str(error).strip().splitlines()
        raise UserError(
            f'"{path}" cannot be loaded ({reason[0] if reason else type(error).__name__}).',
            "Download or convert the checkpoint again.",
        ) from error


@contextmanager
def _out_of_memory(what: str) -> Iterator[None]:
    try:
        yield
    except torch.cuda.OutOfMemoryError as error:
        raise memory_short(what) from error
