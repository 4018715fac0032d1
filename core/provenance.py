"""The origin of an asset: its job, versions and weights."""

import importlib.metadata
import platform
from dataclasses import asdict
from pathlib import Path
from typing import Any

from core.guidance.builtin.offered import NETWORKS, PARTS, RESTORER, SOLID, WEIGHTS
from core.io.job import Job
from core.io.provenance import SOFTWARE, file_hash

FILES = (
    "mesh",
    "guide_mesh",
    "base_color",
    "kept_asset",
    "region",
    "light",
    "guidance",
)  # of a job: may be paths
LIBRARIES = ("torch", "numpy", "numba")  # whose versions decide the last bits


def recorded(job: Job) -> dict[str, Any]:
    """The whole job as asset.json keeps it: of files the name alone, not where they were."""
    data = asdict(job)
    for key in FILES:
        if Path(data[key]).is_absolute():
            data[key] = Path(data[key]).name
    data["loras"] = {Path(path).name: strength for path, strength in job.loras.items()}
    data["embeddings"] = [Path(path).name for path in job.embeddings]
    return data


def made_by(job: Job) -> dict[str, Any]:
    """Versions, platform and hashes of what makes the asset of ``job``."""
    versions = {name: importlib.metadata.version(name) for name in LIBRARIES}
    weights = {}
    if job.guidance == "builtin":
        names = (*NETWORKS, PARTS, SOLID, RESTORER)
        paths = [WEIGHTS / f"{name}.safetensors" for name in names]
        weights = {path.name: file_hash(path) for path in paths if path.exists()}
    here = {"software": SOFTWARE, "python": platform.python_version()} | versions
    return here | {"machine": platform.machine(), "weights": weights}
