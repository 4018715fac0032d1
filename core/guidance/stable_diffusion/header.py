"""What a .safetensors file holds, from its header alone: no weights are read, nothing is run."""

import json
import struct
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Final

from core.errors import UserError
from core.guidance.stable_diffusion.keys import UNET, VAE

PICKLES: Final = (".ckpt", ".pt", ".pth", ".bin", ".pkl")
_LONGEST: Final = 100_000_000  # bytes of a header, the format's own limit
# What a header that is none raises: no JSON, none of its entries, a number without an end, nesting.
_BROKEN: Final = (
    ValueError, KeyError, TypeError, AttributeError, IndexError, struct.error, OverflowError,
    RecursionError,
)  # fmt: skip


@dataclass(frozen=True)
class Header:
    """Names and shapes of a file's tensors, and what its maker wrote into it."""

    shapes: dict[str, tuple[int, ...]]
    metadata: dict[str, str]

    def any(self, *parts: str) -> bool:
        """Whether a name holds one of ``parts``."""
        return any(part in name for name in self.shapes for part in parts)

    def starts(self, *prefixes: str) -> bool:
        """Whether a name starts with one of ``prefixes``."""
        return any(name.startswith(prefixes) for name in self.shapes)


def read_header(path: Path) -> Header:
    """The header of ``path``.

    Raises:
        UserError: pickled, no safetensors file, or cut short.
    """
    if path.suffix.lower() in PICKLES:
        raise UserError(
            f'"{path}" is a pickled file ({path.suffix}), which can run any code when it is read; '
            "it is never opened here.",
            "Use a .safetensors copy of it.",
        )
    if path.suffix.lower() != ".safetensors":
        raise UserError(
            f'"{path}" is a file of another kind ({path.suffix or "no ending"}).',
            "Give a .safetensors file or a checkpoint's folder.",
        )
    try:
        data, begin = _parsed(path)
        metadata = {str(k): str(v) for k, v in data.pop("__metadata__", {}).items()}
        shapes = {name: tuple(map(int, entry["shape"])) for name, entry in data.items()}
        end = max((int(entry["data_offsets"][1]) for entry in data.values()), default=0)
        size = path.stat().st_size
    except OSError as error:
        raise UserError(f'"{path}" cannot be read ({error.strerror}).', "Check it.") from error
    except _BROKEN as error:
        raise UserError(
            f'"{path}" is no whole safetensors file: its header cannot be read.',
            "Download it again.",
        ) from error
    if begin + end > size:
        raise UserError(
            f'"{path}" is cut short: it has {size:,} of {begin + end:,} bytes.',
            "Download it again.",
        )
    return Header(shapes, metadata)


def _parsed(path: Path) -> tuple[dict[str, Any], int]:
    """The header's JSON object, and where the tensors begin."""
    with path.open("rb") as file:
        (length,) = struct.unpack("<Q", file.read(8))
        if length > _LONGEST:
            raise ValueError
        text = file.read(length)
    if len(text) < length:
        raise ValueError
    data = json.loads(text)
    if not isinstance(data, dict):
        raise TypeError
    return data, 8 + length


def _is_embedding(header: Header) -> bool:
    shapes = list(header.shapes.values())
    widths = all(len(shape) in (1, 2) and shape[-1] >= 16 for shape in shapes)
    named = {"emb_params", "clip_l", "clip_g"} & header.shapes.keys()
    return (len(shapes) == 1 and widths) or bool(named)


def _channels(header: Header) -> tuple[int, ...]:
    """Of what the U-Net takes; of a broken file none."""
    return header.shapes.get(f"{UNET}input_blocks.0.0.weight", (0, 4))[1:2]


# The first that is true names the file. What is not a checkpoint comes before what may be one.
_TEXTS: Final = ("cond_stage_model.", "conditioner.")  # where the text encoders are
_KINDS: Final[tuple[tuple[str, Callable[[Header], bool]], ...]] = (
    ("LoRA", lambda h: h.any("lora_down", "lora_A", "lora.down", "lora_linear", "hada_", "lokr_")),
    ("textual inversion", _is_embedding),
    ("ControlNet", lambda h: h.any("control_model.", "input_hint_block", "controlnet_")),
    ("Flux", lambda h: h.any("double_blocks.")),
    ("Stable Diffusion 3", lambda h: h.any("joint_blocks.")),
    ("SDXL refiner", lambda h: h.starts("conditioner.embedders.0.model.")),
    ("inpainting or editing model", lambda h: _channels(h) != (4,)),
    (
        "U-Net without text encoder",
        lambda h: h.starts(UNET) and not h.starts(*_TEXTS),
    ),
    ("checkpoint without VAE", lambda h: h.starts(UNET) and not h.starts(VAE)),
    # ImageDream's U-Net has layers for a picture as well.
    ("ImageDream", lambda h: h.starts(f"{UNET}camera_embed.") and h.any("image_embed.", "_ip.")),
    (
        "MVDream of Stable Diffusion 1",
        lambda h: h.starts(f"{UNET}camera_embed.") and h.starts("cond_stage_model.transformer."),
    ),
    ("MVDream", lambda h: h.starts(f"{UNET}camera_embed.") and h.starts("cond_stage_model.model.")),
    ("Stable Diffusion XL", lambda h: h.starts(UNET) and h.starts("conditioner.embedders.1.")),
    ("Stable Diffusion 2", lambda h: h.starts(UNET) and h.starts("cond_stage_model.model.")),
    ("Stable Diffusion 1", lambda h: h.starts(UNET) and h.starts("cond_stage_model.transformer.")),
    ("VAE", lambda h: h.starts("encoder.", VAE)),
)
UNKNOWN: Final = "unknown"


def kind_of(header: Header) -> str:
    """What the file is, in a few words; ``UNKNOWN`` where no kind fits."""
    return next((kind for kind, fits in _KINDS if fits(header)), UNKNOWN)
