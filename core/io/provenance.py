"""Metadata of pictures and GLB files on their origin, and hashes of files."""

import hashlib
from pathlib import Path
from typing import Any

from core import __version__

VERSIONS = ("python", "torch", "numpy", "numba")
SOFTWARE = f"Fantasia3D for Blender {__version__}"


def summary(info: dict[str, Any]) -> dict[str, str]:
    """The few lines that a picture's or a GLB's own metadata hold, from asset.json's ``info``."""
    names = ("prompt", "negative_prompt", "seed", "preset")
    given = {key: str(info[key]) for key in names if info.get(key) not in (None, "")}
    model, made_by = info.get("guidance"), info.get("made_by", {})
    weights = made_by.get("weights", {})
    made = {
        "model": Path(model).name if model else "",
        "model_hashes": ", ".join(f"{name} sha256:{value}" for name, value in weights.items()),
        "versions": ", ".join(f"{key} {made_by[key]}" for key in VERSIONS if key in made_by),
    }
    return given | {key: text for key, text in made.items() if text} | {"software": SOFTWARE}


def file_hash(path: Path) -> str:
    """SHA-256 of a file."""
    with path.open("rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()
