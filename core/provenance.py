"""The origin of an asset: its job, versions and weights."""

import importlib.metadata
import platform
from collections.abc import Mapping
from dataclasses import asdict
from pathlib import Path
from typing import Any

from core.geometry.parts.assembly import KnownParts, thinned_by
from core.guidance.builtin.offered import NETWORKS, PARTS, RESTORER, SOLID, WEIGHTS
from core.guidance.builtin.physical import usual_of
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


def info_of(
    job: Job, timings: Mapping[str, float], drawn: KnownParts | None = None
) -> dict[str, Any]:
    """The facts in asset.json about the origin.

    Args:
        timings: seconds of each stage.
        drawn: the parts that the guidance knows of the shape.
    """
    names = ("prompt", "negative_prompt", "seed", "preset", "guidance", "command", "light")
    words = {key: value for key, value in asdict(job).items() if key in names}
    rounded = {stage: round(seconds, 2) for stage, seconds in timings.items()}
    _, density = usual_of(job.prompt)
    density *= thinned_by(drawn) if drawn else 1.0  # the usual mass is of what is drawn
    origin = {"job": recorded(job), "made_by": made_by(job)}
    return words | origin | {"density": density, "timings": rounded, "distribution": "GGX"}
