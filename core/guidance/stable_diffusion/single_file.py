"""A checkpoint that is one .safetensors file, as artists download them: which model it is of."""

import re
from pathlib import Path
from typing import Final

from core.errors import UserError
from core.guidance.stable_diffusion.clip_files import CONFIGURATIONS
from core.guidance.stable_diffusion.header import UNKNOWN, Header, kind_of, read_header
from core.guidance.stable_diffusion.source import Checkpoint, Family

SECOND_V: Final = "sd21_v"
SECOND_BASE: Final = "sd21_base"  # the same networks, for 512² and not 768², predicting the noise
# The configuration of each kind that can be used.
FOLDERS: Final = {
    "Stable Diffusion 1": "sd15",
    "Stable Diffusion 2": SECOND_V,  # the larger one, until it is known which
    "Stable Diffusion XL": "sdxl",
    "MVDream": "mvdream",
}
FAMILIES: Final[dict[str, Family]] = {"sdxl": "sdxl", "mvdream": "mvdream"}
_EXPECTED: Final = "a checkpoint of Stable Diffusion 1.x, 2.x or XL, or MVDream's of 2.1"
_WHY: Final = {
    "LoRA": "Name it with --lora, and a checkpoint with --guidance.",
    "textual inversion": "Name it with --embedding, and a checkpoint with --guidance.",
    "U-Net without text encoder": f"Give the full file of {_EXPECTED}.",
    "checkpoint without VAE": "Use a version of it with its VAE baked in.",
}


def find_single_file(path: Path) -> Checkpoint:
    """The checkpoint in ``path``.

    Raises:
        UserError: pickled, cut short, or of a kind that cannot be used; the message names it.
    """
    header = read_header(path)
    kind = kind_of(header)
    if kind not in FOLDERS:
        raise UserError(*refusal(path, kind))
    turbo = re.search(r"turbo|lightning|lcm|hyper[-_]?sd", path.stem, re.IGNORECASE)
    if turbo or header.any("time_embed.cond_proj", "time_embedding.cond_proj"):
        raise UserError(
            f'"{path}" is distilled to a few steps (its name contains '
            f'"{turbo[0] if turbo else "LCM"}"): it predicts no score to follow, at any guidance '
            "scale.",
            f"Give {_EXPECTED} that is not distilled; rename the file if it is not.",
        )
    prediction = stated_prediction(header, path)
    folder = FOLDERS[kind]
    if folder == SECOND_V and prediction == "epsilon":
        folder = SECOND_BASE
    return Checkpoint(
        CONFIGURATIONS / folder,
        file=path,
        family=FAMILIES.get(folder, "sd"),
        prediction=prediction or (None if kind == "Stable Diffusion 2" else "epsilon"),
        zero_snr="ztsnr" in header.shapes,
        zero_empty=folder == "sdxl",
    )


def refusal(path: Path, kind: str) -> tuple[str, str]:
    """Why a file of ``kind`` is no checkpoint to use, and what to do."""
    what = "holds no model that is known here" if kind == UNKNOWN else f"is a file of {kind}"
    what = what.replace("a file of U-Net", "a U-Net").replace(
        "a file of checkpoint", "a checkpoint"
    )
    return f'"{path}" {what}.', _WHY.get(kind, f"Give {_EXPECTED}.")


def stated_prediction(header: Header, path: Path) -> str | None:
    """What the model predicts, where the file or the .yaml next to it states it.

    Some makers write it into the metadata (modelspec), some add an empty tensor "v_pred", some put
    a configuration of the same name next to the file, with ``parameterization: "v"``.
    """
    if "v_pred" in header.shapes:
        return "v_prediction"
    stated = header.metadata.get("modelspec.prediction_type", "").lower()
    if stated in ("v", "v_prediction", "v-prediction"):
        return "v_prediction"
    if stated == "epsilon":
        return "epsilon"
    yaml = path.with_suffix(".yaml")
    if not yaml.is_file():
        return None
    text = yaml.read_bytes()[:100_000].decode("utf-8", "replace")
    return "v_prediction" if re.search(r"""parameterization\s*:\s*["']?v\b""", text) else "epsilon"
