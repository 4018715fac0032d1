"""What a prompt becomes: clean text, a text per side of the object, each camera's weights of them.

View words after DreamFusion (§3.2, "view-dependent conditioning") and the released Fantasia3D code:
front and back within 45 degrees of the axis, side between them, overhead above 60 degrees of
elevation; below -60 degrees, bottom.
"""

import unicodedata
import warnings
from typing import Final

import torch
from jaxtyping import Float
from torch import Tensor

from core.camera import Cameras
from core.errors import UserError
from core.guidance.guidance import PromptWarning

VIEWS: Final = ("front", "side", "back", "overhead", "bottom")
AROUND: Final = 3  # the first of them, around the vertical
MAX_CHARACTERS: Final = 1000  # about three times what CLIP's 77 tokens hold
# What SDS at a high guidance scale tends to; used where the user gives no negative prompt.
DEFAULT_NEGATIVE_PROMPT: Final = "oversaturated, flat color, blurry, low quality, deformed"

_POLE_DEG = 60.0  # where the view from above or below begins
_POLE_BLEND_DEG = 15.0  # half the width of the soft change to it


class PromptCutWarning(PromptWarning):
    """A text encoder could not hold the whole prompt; the message names the part that was cut."""


def clean_prompt(text: str, what: str = "prompt") -> str:
    """The text in one line, in Unicode's composed form.

    Args:
        what: how the message names the text, "prompt" or "negative prompt".

    Raises:
        UserError: longer than MAX_CHARACTERS, or with control characters.
    """
    # Composed, so that an accent typed as two characters is read as one.
    line = " ".join(unicodedata.normalize("NFC", text).split())
    if len(line) > MAX_CHARACTERS:
        raise UserError(
            f"The {what} has {len(line)} characters; at most {MAX_CHARACTERS} are read.",
            "Shorten it to a sentence or two.",
        )
    # Cc: control, Cs: half of a surrogate pair, Co and Cn: no character that others know.
    bad = [c for c in line if unicodedata.category(c) in ("Cc", "Cs", "Co", "Cn")]
    if bad:
        raise UserError(
            f"The {what} holds a character that is no text (U+{ord(bad[0]):04X}).",
            "Type it again, without control characters.",
        )
    return line


def require_prompt(text: str) -> str:
    """``clean_prompt``, and something must be left of it."""
    line = clean_prompt(text)
    if not any(unicodedata.category(c)[0] in "LNS" for c in line):  # letter, number or symbol
        raise UserError(
            "The prompt is empty." if not line else f'The prompt "{line}" holds no word.',
            'Write what to make, for instance "a wooden chair".',
        )
    return line


def view_words(view: str) -> str:
    """What is added to the prompt for one side of the object."""
    return f", {view} view"


def view_weights(cameras: Cameras, *, soft: bool = False) -> Float[Tensor, "b 5"]:
    """How much of each camera's picture belongs to each of ``VIEWS``; rows sum to 1.

    Args:
        soft: weights that change linearly with the angles. False: the nearest view alone, front up
            to 45 degrees of azimuth.
    """
    azimuth = _wrapped_deg(cameras.azimuth).abs()
    elevation = torch.rad2deg(cameras.elevation)
    # Linear from front (0 degrees) to side (90) and from side to back (180).
    back = ((azimuth - 90) / 90).clamp(0, 1)
    front = (1 - azimuth / 90).clamp(0, 1)
    overhead = _ramp(elevation)
    bottom = _ramp(-elevation)
    if not soft:
        # On the border itself a camera is still front, side by side with a rounding of the angle.
        front, back = (azimuth <= 45 + 1e-4).to(front), (azimuth >= 135 - 1e-4).to(back)
        overhead, bottom = (overhead > 0.5).to(front), (bottom > 0.5).to(front)
    around = torch.stack([front, 1 - front - back, back], -1)
    # What the poles take, the sides lose: a row sums to 1.
    pole = torch.stack([overhead, bottom], -1)
    return torch.cat([around * (1 - pole.sum(-1, keepdim=True)), pole], -1)


def opposing_weights(weights: Float[Tensor, "b 5"]) -> Float[Tensor, "b 5"]:
    """How strongly Perp-Neg steers away from each view: as far as a side is not in the picture.

    Only front, side and back: nobody meets a second object's overhead view on its flank.
    """
    around = torch.ones_like(weights) - weights
    around[:, AROUND:] = 0
    return around


def fit_tokens(
    prompt: list[int], suffix: list[int], length: int, *, bos: int, eos: int, pad: int
) -> tuple[list[int], list[int]]:
    """``length`` tokens [bos, prompt, suffix, eos, pad ...], and those of the prompt that were cut.

    The prompt gives way, never the suffix: a prompt that is cut still states from where it is seen.
    """
    # Two for the begin and end tokens.
    room = length - 2 - len(suffix)
    tokens = [bos, *prompt[:room], *suffix, eos]
    return tokens + [pad] * (length - len(tokens)), prompt[room:]


def warn_cut(cut: str, what: str = "prompt") -> None:
    """Warn which end of the prompt the text encoder will not see."""
    warnings.warn(
        f'The {what} is too long for the text encoder, which does not see its end: "{cut}". '
        "Shorten it, most important words first.",
        PromptCutWarning,
        stacklevel=2,
    )


def warn_unused(word: str) -> None:
    """Warn that an embedding has no effect."""
    warnings.warn(
        f'The embedding "{word}" is not used. Write its name in the prompt or the negative prompt.',
        PromptWarning,
        stacklevel=2,
    )


def _wrapped_deg(azimuth: Float[Tensor, " b"]) -> Float[Tensor, " b"]:
    """Degrees in [-180, 180]."""
    # By atan2, so that any number of turns comes out in one range.
    return torch.rad2deg(torch.atan2(azimuth.sin(), azimuth.cos()))


def _ramp(elevation_deg: Float[Tensor, " b"]) -> Float[Tensor, " b"]:
    """0 to 1 across the beginning of a pole's view, half there."""
    return ((elevation_deg - _POLE_DEG) / (2 * _POLE_BLEND_DEG) + 0.5).clamp(0, 1)
