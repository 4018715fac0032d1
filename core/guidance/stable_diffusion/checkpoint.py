"""Find a Stable Diffusion checkpoint; any other file or folder is refused unloaded.

A checkpoint is a folder in diffusers' format, with model_index.json and one folder per part, or one
.safetensors file. It is named by its path or by its hub id. The hub is reached only where the user
allows it with HF_HUB_OFFLINE=0.
"""

import json
import os
import re
from pathlib import Path
from typing import Any, Final

from core.errors import MissingError, UserError
from core.guidance.stable_diffusion.header import PICKLES
from core.guidance.stable_diffusion.multi_view_names import CAMERA, CLASS
from core.guidance.stable_diffusion.single_file import find_single_file
from core.guidance.stable_diffusion.source import Checkpoint
from core.io.input_file import expanded

# What Stable Diffusion 1.x and 2.x are made of; SD 3 and Flux differ in one of them.
PARTS: Final = {
    "unet": "UNet2DConditionModel",
    "vae": "AutoencoderKL",
    "text_encoder": "CLIPTextModel",
    "tokenizer": "CLIPTokenizer",
    "scheduler": "",  # any: only its noise schedule is read
}
WEIGHTS: Final = {
    "unet": "diffusion_pytorch_model",
    "vae": "diffusion_pytorch_model",
    "text_encoder": "model",
    "text_encoder_2": "model",
}
SECOND: Final = {"text_encoder_2": "CLIPTextModelWithProjection", "tokenizer_2": "CLIPTokenizer"}
# What other families' U-Nets take in addition to time and text, by its entry in the configuration.
OTHER_CONDITIONS: Final = {
    "class_embed_type": "unCLIP, whose U-Net also takes a picture's embedding",
    "time_cond_proj_dim": "a latent consistency model (LCM), whose U-Net takes a guidance scale",
}
# Schedulers of models distilled to a few steps.
DISTILLED: Final = {"LCMScheduler": "latent consistency model (LCM)", "TCDScheduler": "TCD model"}
_EXPECTED: Final = "a Stable Diffusion 1.x, 2.x or XL text-to-image checkpoint in diffusers' format"
_HUB_ID: Final = re.compile(r"[\w.-]+/[\w.-]+")


def find_checkpoint(spec: str) -> Checkpoint:
    """The checkpoint that ``spec`` names by path or by hub id.

    Raises:
        UserError: neither, or the file or folder holds something else.
        MissingError: no such file or folder, or a hub id that is not on this machine.
    """
    path = expanded(spec)
    if path.is_dir():
        return _require_text_to_image(path)
    if path.is_file():
        return find_single_file(path)
    # Written as a path: what is missing is a file or folder, not a repository of the hub.
    is_file = path.suffix.lower() in (".safetensors", *PICKLES)
    if is_file or spec.startswith((".", "~", os.sep)) or path.is_absolute():
        what = "file" if is_file else "folder"
        raise MissingError(
            f'There is no {what} "{spec}".',
            f"Give the folder of {_EXPECTED}, or a .safetensors file of one.",
        )
    if not _HUB_ID.fullmatch(spec):
        raise _no_guidance(spec)
    return _require_text_to_image(_from_hub(spec))


def read_json(path: Path) -> dict[str, Any]:
    """A configuration file of the checkpoint.

    Raises:
        UserError: missing or broken.
    """
    fix = "Download or convert the checkpoint again."
    try:
        # Infinity is no JSON, but diffusers' own schedulers write it.
        data = json.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError, RecursionError) as error:
        raise UserError(f'"{path}" cannot be read ({type(error).__name__}).', fix) from error
    if not isinstance(data, dict):
        raise UserError(f'"{path}" cannot be read (it holds no object).', fix)
    return data


def weight_variant(folder: Path, part: str, *, half: bool) -> str | None:
    """Which of a part's weights to load: None for the plain ones, "fp16" for those in 16 bit.

    Args:
        half: prefer those in 16 bit, because the part will run in it.

    Raises:
        UserError: no weights, or pickled ones alone, which can run any code when they are read.
    """
    files = {path.name for path in (folder / part).glob("*") if path.is_file()}
    stem = re.escape(WEIGHTS[part])
    numbered = r"(-\d+-of-\d+)?\.safetensors"
    plain = any(re.fullmatch(stem + numbered, name) for name in files)
    fp16 = any(re.fullmatch(stem + r"\.fp16" + numbered, name) for name in files)
    # 16 bit from the disk where the part runs in it, or where there is nothing else.
    if plain or fp16:
        return "fp16" if fp16 and (half or not plain) else None
    if any(name.endswith((".bin", ".ckpt", ".pt", ".pth")) for name in files):
        raise UserError(
            f'"{folder / part}" holds only pickled weights, which are never opened here.',
            "Use a copy with .safetensors files, or convert it where you trust it: "
            "StableDiffusionPipeline.from_pretrained(FOLDER, use_safetensors=False)"
            ".save_pretrained(NEW_FOLDER).",
        )
    raise UserError(
        f'"{folder / part}" holds no weights ({WEIGHTS[part]}.safetensors).',
        "Download the checkpoint again.",
    )


def _require_text_to_image(folder: Path) -> Checkpoint:
    index = folder / "model_index.json"
    if not index.is_file():
        raise UserError(
            f'"{folder}" is no checkpoint: it has no model_index.json.',
            f"Give the folder of {_EXPECTED}, or a .safetensors file of one.",
        )
    parts = read_json(index)
    if _class_of(parts, "unet") == CLASS:
        return _require_multi_view(folder, parts)
    is_xl = bool(_class_of(parts, "text_encoder_2"))
    _require_parts(folder, parts, PARTS | SECOND if is_xl else PARTS)
    _require_unet(folder, is_xl)
    _require_no_distilled(folder)
    zero_empty = is_xl and bool(parts.get("force_zeros_for_empty_prompt", True))
    return Checkpoint(folder, family="sdxl" if is_xl else "sd", zero_empty=zero_empty)


def _class_of(parts: dict[str, Any], part: str) -> str | None:
    """The class of a part: an entry is [library, class], both null where there is none."""
    entry = parts.get(part)
    found = entry[1] if isinstance(entry, list) and len(entry) == 2 else None
    return found if isinstance(found, str) else None


def _require_multi_view(folder: Path, parts: dict[str, Any]) -> Checkpoint:
    """MVDream's folder, whose U-Net has a configuration of its own."""
    _require_parts(folder, parts, PARTS | {"unet": CLASS})
    unet = read_json(folder / "unet" / "config.json")
    if unet.get("ip_dim"):
        raise _other_family(folder, "ImageDream, which starts from a picture")
    wanted = ("image_size", "in_channels", "out_channels", "model_channels", "channel_mult",
              "num_res_blocks", "attention_resolutions", "context_dim")  # fmt: skip
    missing = [key for key in wanted if key not in unet]
    if missing or unet.get("camera_dim") != CAMERA:
        raise _other_family(
            folder, f"a multi-view model of another kind ({', '.join(missing) or 'its cameras'})"
        )
    return Checkpoint(folder, family="mvdream")


def _require_parts(folder: Path, parts: dict[str, Any], wanted: dict[str, str]) -> None:
    for part, expected in wanted.items():
        found = _class_of(parts, part)
        # CLIPTokenizerFast is the same tokenizer in another language.
        if not found or (expected and found.removesuffix("Fast") != expected):
            raise UserError(
                f'"{folder}" is a {parts.get("_class_name", "pipeline")} whose {part} is '
                f"{found or 'missing'}; expected {expected or 'one'}.",
                f"Give {_EXPECTED}.",
            )


def _require_unet(folder: Path, is_xl: bool) -> None:
    """Refuse a U-Net that takes more than a noisy latent, the time and CLIP's states.

    SDXL's takes a pooled text and sizes, too, and nothing else.
    """
    unet = read_json(folder / "unet" / "config.json")
    channels = unet.get("in_channels", 4)
    if channels != 4:
        raise UserError(
            f'"{folder}" is for inpainting, depth or editing: its U-Net takes {channels} channels, '
            "not 4.",
            f"Give {_EXPECTED}.",
        )
    if not isinstance(unet.get("sample_size"), int):
        raise UserError(
            f'"{folder}" does not state how large its latents are: sample_size in '
            f"unet/config.json is {unet.get('sample_size')!r}.",
            "Write it there: 64 for pictures of 512 pixels a side, 96 for 768, 128 for 1024.",
        )
    added = unet.get("addition_embed_type")
    if added != ("text_time" if is_xl else None):
        which = "SDXL's refiner" if added == "text_time" else f"a model of {added or 'two texts'}"
        raise _other_family(folder, f"{which}, whose U-Net does not fit its text encoders")
    for key, family in OTHER_CONDITIONS.items():
        if unet.get(key) is not None:
            raise _other_family(folder, family)


def _require_no_distilled(folder: Path) -> None:
    """Refuse models that were distilled to a few steps: they jump to a picture and predict no
    score at most noise levels, so that score distillation has nothing to follow.

    SD-Turbo is recognised by its scheduler: Euler, predicting noise, with "trailing" timesteps.
    The plain Euler checkpoints have "leading" or "linspace", those that predict v may trail.
    """
    path = folder / "scheduler" / "scheduler_config.json"
    if not path.is_file():  # the scheduler's own loader names what is missing
        return
    scheduler = read_json(path)
    kind = str(scheduler.get("_class_name", ""))
    if kind in DISTILLED:
        raise _distilled(folder, DISTILLED[kind], f"its scheduler is {kind}")
    trailing = scheduler.get("timestep_spacing") == "trailing"
    predicts_noise = scheduler.get("prediction_type", "epsilon") == "epsilon"
    if kind.startswith("Euler") and trailing and predicts_noise:
        raise _distilled(folder, "turbo model", f'its {kind} has timestep_spacing "trailing"')


def _no_guidance(spec: str) -> UserError:
    return UserError(
        f'"{spec}" is no guidance.',
        'Give "builtin", a checkpoint\'s folder or .safetensors file, or its hub id such as '
        '"owner/name".',
    )


def _other_family(folder: Path, family: str) -> UserError:
    return UserError(f'"{folder}" is {family}.', f"Give {_EXPECTED}.")


def _distilled(folder: Path, kind: str, sign: str) -> UserError:
    return UserError(
        f'"{folder}" is a {kind}, distilled to a few steps ({sign}): it predicts no score to '
        "follow, at any guidance scale.",
        f"Give {_EXPECTED} that is not distilled. If it is not, save it with another scheduler, "
        "such as DDIMScheduler.",
    )


def _from_hub(hub_id: str) -> Path:
    # Imported here: a folder needs no hub.
    from huggingface_hub import snapshot_download
    from huggingface_hub.errors import (
        HfHubHTTPError,
        HFValidationError,
        LocalEntryNotFoundError,
    )

    online = os.environ.get("HF_HUB_OFFLINE", "").lower() in ("0", "false", "no", "off")
    # Only the parts that are used, without pickles and other frameworks' copies of the same
    # weights.
    folders = [f"{part}/*" for part in PARTS | SECOND]
    try:
        return Path(
            snapshot_download(
                hub_id,
                local_files_only=not online,
                allow_patterns=["model_index.json", *folders],
                ignore_patterns=["*.bin", "*.ckpt", "*.msgpack", "*.onnx*", "*non_ema*"],
            )
        )
    except HFValidationError as error:  # such as a folder that is not here, with an accent
        raise _no_guidance(hub_id) from error
    except (LocalEntryNotFoundError, HfHubHTTPError, OSError) as error:
        reason = "could not be downloaded" if online else "is not on this machine"
        raise MissingError(
            f'The checkpoint "{hub_id}" {reason}, and there is no folder of that name.',
            f"Download it with `hf download {hub_id}`, allow the download with HF_HUB_OFFLINE=0, "
            "give a checkpoint's folder, or use --guidance builtin.",
        ) from error
