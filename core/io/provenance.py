"""What a picture's or a GLB's own metadata say of its making, and hashes of files."""

import hashlib
from pathlib import Path
from typing import Any

from core import __version__

SOFTWARE = f"Fantasia3D for Blender {__version__}"


def summary(info: dict[str, Any]) -> dict[str, str]:
    """The few lines that a picture's or a GLB's own metadata hold, from asset.json's ``info``."""
    names = ("prompt", "negative_prompt", "seed", "preset")
    given = {key: str(info[key]) for key in names if info.get(key) not in (None, "")}
    model = info.get("guidance")
    return given | ({"model": Path(model).name} if model else {}) | {"software": SOFTWARE}


def file_hash(path: Path) -> str:
    """SHA-256 of a file."""
    with path.open("rb") as file:
        return hashlib.file_digest(file, "sha256").hexdigest()
