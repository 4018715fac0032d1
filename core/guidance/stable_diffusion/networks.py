"""A checkpoint's networks in memory."""

import json
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from typing import Any, NamedTuple

import torch
from huggingface_hub.errors import StrictDataclassError
from safetensors import SafetensorError, safe_open
from torch import Tensor

from core.errors import UserError
from core.guidance.stable_diffusion import libraries
from core.guidance.stable_diffusion.checkpoint import read_json, weight_variant
from core.guidance.stable_diffusion.clip_files import CONFIGURATIONS, END, merges, vocabulary
from core.guidance.stable_diffusion.keys import UNET, VAE, Place, clip_place, unet_key, vae_key
from core.guidance.stable_diffusion.memory import memory_short
from core.guidance.stable_diffusion.multi_view import MultiViewUNet
from core.guidance.stable_diffusion.multi_view_names import unet_config
from core.guidance.stable_diffusion.single_file import SECOND_BASE
from core.guidance.stable_diffusion.source import Checkpoint
from core.guidance.stable_diffusion.texts import Encoder, Texts

TRIAL_SIZE = 32  # of a latent: seconds on a CPU
_CLIP_LENGTH = 77  # tokens


class Networks(NamedTuple):
    """What score distillation uses of a checkpoint, frozen."""

    unet: Any  # UNet2DConditionModel or MultiViewUNet: diffusers types its attributes too widely
    vae: Any  # AutoencoderKL without its decoder: pictures are never decoded
    scheduler: "libraries.DDPMScheduler"
    encoders: tuple[Encoder, ...]  # SDXL has two


def load_networks(checkpoint: Checkpoint, dtype: torch.dtype) -> Networks:
    """The checkpoint's parts on the CPU, the networks in ``dtype``, the text encoders in 32 bit.

    Raises:
        UserError: a part is missing, incomplete or broken.
    """
    load = _from_file if checkpoint.file else _from_folder
    is_multi_view = checkpoint.family == "mvdream"
    unet = (
        _multi_view(checkpoint, dtype)
        if is_multi_view
        else load(libraries.UNet2DConditionModel, checkpoint, "unet", dtype)
    )
    vae = load(libraries.AutoencoderKL, checkpoint, "vae", vae_dtype(checkpoint, dtype))
    vae.decoder = None
    encoders = [_encoder(load, checkpoint, "text_encoder", libraries.CLIPTextModel)]
    if checkpoint.family == "sdxl":
        second = _encoder(load, checkpoint, "text_encoder_2", libraries.CLIPTextModelWithProjection)
        encoders.append(second)
    if checkpoint.file and checkpoint.prediction is None:
        kind = measured_prediction(unet, Texts(tuple(encoders)), noise_schedule(checkpoint))
        checkpoint = replace(checkpoint, prediction=kind)
        if kind == "epsilon":  # 2.x base: the same network, trained at another size
            base = read_json(checkpoint.folder.with_name(SECOND_BASE) / "unet" / "config.json")
            unet.register_to_config(sample_size=base["sample_size"])
    return Networks(unet, vae, noise_schedule(checkpoint), tuple(encoders))


@torch.no_grad()
def measured_prediction(unet: Any, texts: Texts, schedule: "libraries.DDPMScheduler") -> str:
    """What ``unet`` predicts, by a trial at the last step, where z_t is nearly all noise.

    A network that predicts the noise gives z_t back there. One that predicts
    v = sqrt(alpha_bar) eps - sqrt(1 - alpha_bar) z gives its idea of a picture, which has nothing
    of that noise.
    """
    last = len(schedule.alphas_cumprod) - 1
    z_t = torch.randn(1, 4, TRIAL_SIZE, TRIAL_SIZE, generator=torch.Generator().manual_seed(0))
    text = texts.encode([texts.tokens("", "")[0]]).to(unet.dtype)
    out = unet(z_t.to(unet.dtype), torch.tensor([last]), encoder_hidden_states=text).sample
    like = torch.cosine_similarity(out.float().flatten(), z_t.flatten(), 0)
    return "epsilon" if like > 0.5 else "v_prediction"


def noise_schedule(checkpoint: Checkpoint) -> "libraries.DDPMScheduler":
    """Whatever the checkpoint samples with: only its schedule and prediction type are read."""
    kind, changes = libraries.DDPMScheduler, dict[str, Any]()
    if checkpoint.prediction:
        changes["prediction_type"] = checkpoint.prediction
    if checkpoint.zero_snr:
        changes["rescale_betas_zero_snr"] = True
    with readable(checkpoint.folder / "scheduler"):
        return kind.from_pretrained(
            checkpoint.folder / "scheduler", local_files_only=True, **changes
        )


def empty_networks(checkpoint: Checkpoint) -> tuple[Any, Any]:
    """The U-Net and the encoder on the meta device: shapes without numbers."""
    unet_kind, vae_kind = libraries.UNet2DConditionModel, libraries.AutoencoderKL
    with readable(checkpoint.folder), torch.device("meta"):
        config = read_json(checkpoint.folder / "unet" / "config.json")
        if checkpoint.family == "mvdream":
            config = unet_config(config)
        unet = unet_kind.from_config(config)
        vae = vae_kind.from_config(read_json(checkpoint.folder / "vae/config.json"))
    vae.decoder = None
    return unet, vae


def _multi_view(checkpoint: Checkpoint, dtype: torch.dtype) -> MultiViewUNet:
    """MVDream's U-Net, whose folder has CompVis' names as its one file has."""
    inner, _ = empty_networks(checkpoint)
    with torch.device("meta"):
        model = MultiViewUNet(inner)
    top = UNET if checkpoint.file else ""

    def place_of(name: str) -> Place:
        plain = name.removeprefix("unet.")
        return Place(top + (name if plain == name else unet_key(plain, inner.config)))

    path = checkpoint.file or _multi_view_file(checkpoint.folder, half=dtype == torch.float16)
    with readable(path), safe_open(path, "pt") as file:
        weights = _read(file, path, model, place_of, dtype)
    model.load_state_dict(weights, assign=True)
    return model.eval()


def _multi_view_file(folder: Path, *, half: bool) -> Path:
    variant = weight_variant(folder, "unet", half=half)
    dotted = f".{variant}" if variant else ""
    return folder / "unet" / f"diffusion_pytorch_model{dotted}.safetensors"


def vae_dtype(checkpoint: Checkpoint, dtype: torch.dtype) -> torch.dtype:
    """SDXL's encoder overflows in 16 bit, unless its configuration states that it does not."""
    if checkpoint.family != "sdxl":
        return dtype
    overflows = read_json(checkpoint.folder / "vae" / "config.json").get("force_upcast", True)
    return torch.float32 if overflows else dtype


def _encoder(load: Callable[..., Any], checkpoint: Checkpoint, part: str, kind: Any) -> Encoder:
    model = load(kind, checkpoint, part, torch.float32).requires_grad_(False).eval()
    name = part.replace("text_encoder", "tokenizer")
    if checkpoint.file:
        # OpenAI's CLIP was trained with its end token as filling, OpenCLIP with token 0.
        pad = "!" if _open_clip(checkpoint, part) else END
        tokenizer = _shipped_tokenizer(pad)
    else:
        with readable(checkpoint.folder / name):
            folder = checkpoint.folder / name
            tokenizer = libraries.CLIPTokenizer.from_pretrained(folder, local_files_only=True)
    return Encoder(model, tokenizer)


def _shipped_tokenizer(pad: str) -> "libraries.CLIPTokenizer":
    pairs = merges(CONFIGURATIONS / "tokenizer" / "merges.txt")
    return libraries.CLIPTokenizer(
        vocab=vocabulary(pairs), merges=pairs, pad_token=pad, model_max_length=_CLIP_LENGTH
    )


# ---- from diffusers' folders


def _from_folder(kind: Any, checkpoint: Checkpoint, part: str, dtype: torch.dtype) -> Any:
    folder = checkpoint.folder
    variant = weight_variant(folder, part, half=dtype == torch.float16)
    with readable(folder / part):
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
        raise _incomplete(folder / part, sorted(report["missing_keys"]))
    return model


# ---- from one file


def _from_file(kind: Any, checkpoint: Checkpoint, part: str, dtype: torch.dtype) -> Any:
    path = checkpoint.folder / part / "config.json"
    with readable(path), torch.device("meta"):
        # The file's weights take the place of these, which were never in memory.
        if part.startswith("text"):
            model = kind(libraries.CLIPTextConfig.from_dict(read_json(path)))
        else:
            model = kind.from_config(read_json(path))
    if part == "vae":
        model.decoder = model.post_quant_conv = None
    assert checkpoint.file is not None
    with readable(checkpoint.file), safe_open(checkpoint.file, "pt") as file:
        place_of = _places(checkpoint, part, model, set(file.keys()))
        weights = _read(file, checkpoint.file, model, place_of, dtype)
    model.load_state_dict(weights, assign=True)
    for name, buffer in list(model.named_buffers()):
        if buffer.is_meta:  # CLIP's position_ids, which no file holds
            assert name.endswith("position_ids"), name
            owner = model.get_submodule(name.rpartition(".")[0])
            owner.position_ids = torch.arange(buffer.shape[-1]).expand(1, -1)
    return model.eval()


def _read(
    file: Any,
    path: Path,
    model: torch.nn.Module,
    place_of: Callable[[str], Place],
    dtype: torch.dtype,
) -> dict[str, Tensor]:
    """Each of the model's weights, from the file.

    Raises:
        UserError: one is missing, or of another shape than the model's.
    """
    names, weights, missing = set(file.keys()), {}, []
    for name, expected in model.state_dict().items():
        place = place_of(name)
        if place.key not in names:
            missing.append(place.key)
            continue
        found = _tensor(file, place)
        # A linear layer of the encoder's attention is a convolution of 1 x 1 in some files.
        if found.ndim == expected.ndim + 2 and found.numel() == expected.numel():
            found = found.flatten(1)
        if found.shape != expected.shape:
            raise UserError(
                f'"{path}" is a different model than its parts state: {place.key} is '
                f"{tuple(found.shape)}, expected {tuple(expected.shape)}.",
                "Give a checkpoint of Stable Diffusion 1.x, 2.x or XL.",
            )
        weights[name] = found.to(dtype)
    if missing:
        raise _incomplete(path, sorted(missing))
    return weights


def _places(
    checkpoint: Checkpoint, part: str, model: Any, names: set[str]
) -> Callable[[str], Place]:
    if part == "unet":
        return lambda name: Place(UNET + unet_key(name, model.config))
    if part == "vae":
        return lambda name: Place(VAE + vae_key(name))
    open_clip = _open_clip(checkpoint, part)
    number = int(part == "text_encoder_2")
    top = f"conditioner.embedders.{number}." if checkpoint.family == "sdxl" else "cond_stage_model."
    prefix = top + ("model." if open_clip else "transformer.text_model.")
    if not open_clip and not any(name.startswith(prefix) for name in names):
        prefix = top + "transformer."  # as newer tools write it
    return lambda name: clip_place(name, prefix, open_clip=open_clip)


def _open_clip(checkpoint: Checkpoint, part: str) -> bool:
    """Whether the text encoder is OpenCLIP's: that of 2.x and the second one of XL."""
    model = read_json(checkpoint.folder / "text_encoder" / "config.json")
    of_two = model.get("hidden_act") == "gelu" and checkpoint.family != "sdxl"
    return part == "text_encoder_2" or of_two


def _tensor(file: Any, place: Place) -> Tensor:
    if place.third is None:
        tensor = file.get_tensor(place.key)
        return tensor.T.contiguous() if place.transposed else tensor
    rows = file.get_slice(place.key)
    third = rows.get_shape()[0] // 3
    return rows[place.third * third : (place.third + 1) * third]


def _incomplete(path: Path, missing: list[str]) -> UserError:
    return UserError(
        f'"{path}" is incomplete: {len(missing)} of its weights are missing, the first '
        f"{missing[0]}.",
        "Download the checkpoint again.",
    )


@contextmanager
def readable(path: Path) -> Iterator[None]:
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
        StrictDataclassError,
        json.JSONDecodeError,
    ) as error:
        if isinstance(error, torch.OutOfMemoryError):
            raise memory_short(f'reading "{path}"') from error
        reason = str(error).strip().splitlines()
        raise UserError(
            f'"{path}" cannot be loaded ({reason[0] if reason else type(error).__name__}).',
            "Download or convert the checkpoint again.",
        ) from error
