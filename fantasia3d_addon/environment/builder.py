"""Blender's own builder of extensions, which is next to the bpy module."""

from __future__ import annotations

from pathlib import Path

from . import machine
from .machine import SetupError

CODE = "import importlib.util as u; print(u.find_spec('bpy').submodule_search_locations[0])"


def find_builder(python: Path) -> list[str | Path]:
    """The command of the builder that belongs to the bpy module of ``python``.

    Raises:
        SetupError: there is none.
    """
    answer = machine.output([str(python), "-c", machine.NOT_FROM_HERE + CODE])
    place = Path(answer.splitlines()[-1]) if answer else None
    found = sorted(place.glob("*/scripts/addons_core/bl_pkg/cli/blender_ext.py")) if place else []
    if not found:
        raise SetupError("This bpy has no extension builder.", "Run: run.py setup blender --renew")
    return [python, found[0]]
