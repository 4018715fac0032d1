"""The models in folders: which can be used, and why the others cannot. Opens no weights.

It reads headers and configurations alone, needs no torch, and looks two folders deep: that is where
the hub's cache, ComfyUI and A1111 keep their files.
"""

import os
from collections.abc import Iterator
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Final

from core.errors import UserError
from core.guidance.stable_diffusion.checkpoint import find_checkpoint, read_json
from core.guidance.stable_diffusion.header import PICKLES, kind_of, read_header
from core.io.input_file import expanded

ADDITIONS: Final = ("LoRA", "textual inversion")
_DEEP: Final = 4  # folders below the one that is named
_MOST: Final = 2000  # models of one folder
# Where other tools keep them, below the folder in which they are installed.
USUAL: Final = (
    "models/checkpoints", "models/Stable-diffusion", "models/diffusers", "models/loras",
    "models/Lora", "models/embeddings", "embeddings",
)  # fmt: skip


@dataclass(frozen=True)
class Model:
    """One model that was found."""

    path: str
    kind: str
    bytes: int
    reason: str = ""  # why it cannot be used; "": it can

    def as_json(self) -> dict[str, object]:
        """What ``run.py models --json`` and the panel read."""
        return asdict(self)


def models_folder() -> Path:
    """Where the hub keeps what was downloaded, by its own variables."""
    caches = os.environ.get("XDG_CACHE_HOME") or "~/.cache"
    home = os.environ.get("HF_HOME") or Path(caches, "huggingface")
    return expanded(os.environ.get("HF_HUB_CACHE") or Path(home, "hub"))


def models_in(folders: list[Path]) -> list[Model]:
    """The models in ``folders``, or in the hub's cache where none is named.

    Raises:
        UserError: a folder that is not there.
    """
    named = [expanded(folder) for folder in folders]
    for folder in named:
        if not folder.is_dir():
            raise UserError(f'There is no folder "{folder}".', "Give a folder of models.")
    named = named or [models_folder()]
    found: dict[Path, Model] = {}
    for folder in named:
        usual = [folder / part for part in USUAL if (folder / part).is_dir()]
        for place in usual or [folder]:
            for path in sorted(_candidates(place, _DEEP)):
                if len(found) < _MOST:
                    found.setdefault(path.resolve() if path.is_dir() else path, described(path))
    return list(found.values())


def described(path: Path) -> Model:
    """What ``path`` is, and why it cannot be used."""
    try:
        kind, size = _kind(path), _size(path)
        if kind not in ADDITIONS:
            find_checkpoint(str(path))
    except UserError as error:
        return Model(str(path), _kind_if_known(path), _size(path), f"{error.text} {error.fix}")
    return Model(str(path), kind, size)


def _candidates(folder: Path, deep: int) -> Iterator[Path]:
    """Files of models, and folders that are one; what is not readable is left out."""
    try:
        entries = sorted(folder.iterdir())
    except OSError:
        return
    if (folder / "model_index.json").is_file():
        yield folder
        return
    for entry in entries:
        if entry.suffix.lower() in (".safetensors", *PICKLES) and entry.is_file():
            yield entry
        elif entry.is_dir() and deep and not entry.name.startswith("."):
            yield from _candidates(entry, deep - 1)


def _kind(path: Path) -> str:
    if path.is_file():
        return kind_of(read_header(path))
    return str(read_json(path / "model_index.json").get("_class_name", "diffusers folder"))


def _kind_if_known(path: Path) -> str:
    try:
        return _kind(path)
    except UserError:
        return "pickled" if path.suffix.lower() in PICKLES else "broken"


def _size(path: Path) -> int:
    files = [path] if path.is_file() else list(path.glob("*/*.safetensors"))
    return sum(file.stat().st_size for file in files if file.exists())


def table(models: list[Model]) -> str:
    """The list as text: a line each, what can be used first."""
    if not models:
        return "No models found."
    lines = []
    for model in sorted(models, key=lambda m: (bool(m.reason), m.path)):
        reason = f"\n    cannot be used: {model.reason}" if model.reason else ""
        lines.append(f"{model.bytes / 1e9:7.2f} GB  {model.kind:24}  {model.path}{reason}")
    return "\n".join(lines)
