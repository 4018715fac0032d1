"""Where a checkpoint's configuration and its weights are."""

from dataclasses import dataclass, field
from pathlib import Path
from typing import Literal

Family = Literal["sd", "sdxl", "mvdream"]


@dataclass(frozen=True)
class Checkpoint:
    """A checkpoint that was found and can be read."""

    folder: Path  # model_index.json, and a folder of configuration for each part
    file: Path | None = None  # all weights in one file; None: in the parts' folders
    family: Family = "sd"
    # "epsilon" or "v_prediction", where it is not what the scheduler's configuration states.
    prediction: str | None = None
    zero_snr: bool = False  # the noise schedule ends in pure noise
    zero_empty: bool = False  # the empty text is zeros, as in SDXL's training

    @property
    def name(self) -> Path:
        """What the user named."""
        return self.file or self.folder


@dataclass(frozen=True)
class Additions:
    """Files that the user puts on top of a checkpoint."""

    loras: dict[str, float] = field(default_factory=dict)  # file: strength
    embeddings: tuple[str, ...] = ()  # textual inversions

    def __bool__(self) -> bool:
        return bool(self.loras or self.embeddings)
