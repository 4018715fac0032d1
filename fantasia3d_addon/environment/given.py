"""An interpreter of the user's, used as it is instead of an environment (FANTASIA3D_PYTHON)."""

from __future__ import annotations

import os
import re
import shutil
from collections.abc import Sequence
from pathlib import Path

from . import machine
from .files import expanded, of_variable
from .machine import SetupError

MODULES = {
    "core": ("torch", "numpy", "safetensors"),
    "blender": ("bpy",),
    "test": ("pytest",),
    "ray": ("ray",),
}
# Run by an interpreter that is used as it is: its version, and which of the arguments it lacks.
LOOK = """import importlib.util as u
lacking = ", ".join(name for name in sys.argv[1:] if not u.find_spec(name))
print("%d.%d" % sys.version_info[:2], lacking, sep="|")"""


def named_python() -> str:
    """The path in FANTASIA3D_PYTHON, with its ~ expanded where there is such a home; or ""."""
    return of_variable(os.environ.get("FANTASIA3D_PYTHON", ""))


def given_python(given: str, groups: Sequence[str]) -> Path:
    """The interpreter that FANTASIA3D_PYTHON names, if it has the packages of ``groups``.

    Raises:
        SetupError: it is not a program, not a Python, too old, or lacks packages.
    """
    found = shutil.which(str(expanded(given, SetupError)))
    fix = "Set it to a Python that has this project's packages, or unset it."
    if not found:
        raise SetupError(f"FANTASIA3D_PYTHON is {given}, which is not a program.", fix)
    wanted = [name for group in groups for name in MODULES.get(group, ())]
    code = machine.NOT_FROM_HERE + LOOK
    version, _, absent = machine.output([found, "-c", code, *wanted]).partition("|")
    numbers = re.fullmatch(r"(\d+)\.(\d+)", version)
    # A newer one is the user's choice, who has the packages for it.
    oldest = min(tuple(map(int, version.split("."))) for version in machine.PYTHONS)
    if not numbers or (int(numbers[1]), int(numbers[2])) < oldest:
        what = f"Python {version}" if numbers else "not a Python"
        need = f"it must be Python {min(machine.PYTHONS)} or newer"
        raise SetupError(f"FANTASIA3D_PYTHON is {given}, which is {what}; {need}.", fix)
    if absent:
        raise SetupError(f"FANTASIA3D_PYTHON is {given}, which has no {absent}.", fix)
    return Path(found)
