"""Where an object came from, as custom properties, which stay in the file and go into exports."""

from __future__ import annotations

import contextlib
import math
from collections.abc import Mapping
from typing import Any

import bpy

from ..errors import AddonError

PREFIX = "fantasia3d_"
DENSITY = f"{PREFIX}density"  # kg/m³, averaged over the volume; the user may change it
TEXTS = ("prompt", "negative_prompt", "preset", "guidance", "light")
VERSIONS = ("python", "torch", "numpy", "numba")
NAMES = (*TEXTS, "seed", "software", "versions", "model_hashes", "mesh_hash")


def set_origin(owner: bpy.types.ID, info: Mapping[str, Any]) -> None:
    """Keep the origin in asset.json's ``info`` as custom properties of ``owner``."""
    for name in TEXTS:
        if isinstance(info.get(name), str) and info[name]:
            owner[PREFIX + name] = info[name]
    seed, density = info.get("seed"), info.get("density")
    if isinstance(seed, int):
        owner[f"{PREFIX}seed"] = str(seed)  # Blender's integers have 32 bits
    if isinstance(density, int | float) and 0 < density < math.inf:
        owner[DENSITY] = float(density)
    for name, group, key in (
        ("software", "made_by", "software"),
        ("mesh_hash", "hashes", "mesh.obj"),
    ):
        values = info.get(group)
        if isinstance(values, dict) and isinstance(values.get(key), str):
            owner[PREFIX + name] = values[key]
    for name, line in made_lines(info.get("made_by")).items():
        if line:
            owner[PREFIX + name] = line


def made_lines(made_by: Any) -> dict[str, str]:
    """The versions and the hashes of the model's files, a line each."""
    made = made_by if isinstance(made_by, dict) else {}
    weights = made.get("weights")
    hashes = weights.items() if isinstance(weights, dict) else ()
    return {
        "versions": ", ".join(f"{key} {made[key]}" for key in VERSIONS if key in made),
        "model_hashes": ", ".join(f"{name} sha256:{value}" for name, value in hashes),
    }


def origin_of(owner: bpy.types.ID) -> dict[str, str]:
    """The properties of :func:`set_origin`, by the names in asset.json."""
    found = {name: owner.get(PREFIX + name) for name in NAMES}
    return {name: value for name, value in found.items() if isinstance(value, str)}


def density_of(obj: bpy.types.Object, usual: float) -> float:
    """Kg/m³: the custom property that an import sets and the user may change, or ``usual``.

    Raises:
        AddonError: the user made it something else than a number above 0.
    """
    density = 0.0
    with contextlib.suppress(TypeError, ValueError):
        density = float(obj.get(DENSITY, usual))
    if not 0 < density < math.inf:
        raise AddonError(
            f"The density of {obj.name} is not a number above 0.",
            f"Change its custom property {DENSITY}, in kg/m³, or remove it.",
        )
    return density


def copy_origin(source: bpy.types.ID, to: bpy.types.ID) -> None:
    """Give ``to`` the custom properties of ``source`` on its origin."""
    for key in (DENSITY, *(PREFIX + name for name in NAMES)):
        if key in source:
            to[key] = source[key]
